//! What is kept in a file beside a stream: all of it, or what lies around the moments that were waited for.

use super::csv::Csv;
use super::ndjson::Ndjson;
use super::pcap::Pcap;
use super::{Form, Manner, View};
use crate::outcome::{Decimal, Record};
use std::collections::VecDeque;
use std::io::{self, Write};

/// Opens the file once there is something to keep.
pub type Place = Box<dyn FnOnce() -> io::Result<Box<dyn Write>>>;

/// Keeps a stream in a file.
pub(super) struct Recorder {
    view: View,
    manner: Manner,
    place: Option<Place>,
    form: Option<Box<dyn Form>>,
    /// Something is waited for: only what lies so many seconds before it and behind it is kept.
    window: Option<(f64, f64)>,
    /// What came last and may have to be kept.
    past: VecDeque<Record>,
    /// Until then everything is kept, in seconds.
    until: Option<f64>,
}

impl Recorder {
    pub(super) fn new(view: View, manner: Manner, place: Place) -> Self {
        Recorder { view, manner, place: Some(place), form: None, window: None, past: VecDeque::new(), until: None }
    }

    pub(super) fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Start(start) => {
                self.window = start.waits.as_ref().map(|waits| (seconds(waits.pre), seconds(waits.post)));
                self.open()?;
                self.keep(record)
            }
            Record::Telegram(_) => {
                self.open()?;
                self.keep(record)
            }
            Record::Trigger(news) => {
                let (t, (before, behind)) = (seconds(news.t), self.window.unwrap_or_default());
                while let Some(earlier) = self.past.pop_front() {
                    if time(&earlier).is_none_or(|at| at >= t - before) {
                        self.keep(&earlier)?;
                    }
                }
                self.until = Some(t + behind);
                self.keep(record)
            }
            Record::End(end) => {
                // A capture of a line on which nobody spoke is an empty one.
                if self.view == View::Pcap && end.summary.is_some() {
                    self.open()?;
                }
                self.keep(record)
            }
            _ if self.window.is_none() || time(record).zip(self.until).is_some_and(|(t, until)| t <= until) => {
                self.keep(record)
            }
            _ => {
                self.remember(record);
                Ok(())
            }
        }
    }

    /// There is something to keep.
    fn open(&mut self) -> io::Result<()> {
        let Some(place) = self.place.take() else { return Ok(()) };
        let out = place()?;
        self.form = Some(match self.view {
            View::Csv => Box::new(Csv::new(out, self.manner.lang)),
            View::Pcap => Box::new(Pcap::new(out)?),
            _ => Box::new(Ndjson::new(out, self.manner.lang)),
        });
        Ok(())
    }

    fn remember(&mut self, record: &Record) {
        self.past.push_back(record.clone());
        let (Some(now), Some((before, _))) = (time(record), self.window) else { return };
        let is_old = |record: &Record| time(record).is_some_and(|t| t < now - before);
        while self.past.front().is_some_and(is_old) {
            self.past.pop_front();
        }
    }

    fn keep(&mut self, record: &Record) -> io::Result<()> {
        self.form.as_mut().map_or(Ok(()), |form| form.record(record))
    }
}

/// When it was, in seconds.
fn time(record: &Record) -> Option<f64> {
    match record {
        Record::Sample(sample) => Some(seconds(sample.t)),
        Record::Trip(trip) => Some(seconds(trip.t)),
        Record::Lost(change) | Record::Reopened(change) => Some(seconds(change.t)),
        _ => None,
    }
}

fn seconds(t: Decimal) -> f64 {
    t.raw as f64 / 10f64.powi(t.decimals.into())
}
