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
    /// Something is waited for: only what lies so many microseconds before it and behind it is kept.
    window: Option<(i64, i64)>,
    /// What came last and may have to be kept.
    past: VecDeque<Record>,
    /// Until then everything is kept, in microseconds.
    until: Option<i64>,
}

impl Recorder {
    pub(super) fn new(view: View, manner: Manner, place: Place) -> Self {
        Recorder { view, manner, place: Some(place), form: None, window: None, past: VecDeque::new(), until: None }
    }

    pub(super) fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Start(start) => {
                self.window = start.waits.as_ref().map(|waits| (micros(waits.pre), micros(waits.post)));
                self.open()?;
                self.keep(record)
            }
            Record::Telegram(_) => {
                self.open()?;
                self.keep(record)
            }
            Record::Trigger(news) => {
                let (t, (_, behind)) = (micros(news.t), self.window.unwrap_or_default());
                self.forget(t);
                while let Some(earlier) = self.past.pop_front() {
                    self.keep(&earlier)?;
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
            View::Pcap => Box::new(Pcap::new(out, self.manner.is_can)?),
            _ => Box::new(Ndjson::new(out, self.manner.lang)),
        });
        Ok(())
    }

    fn remember(&mut self, record: &Record) {
        self.past.push_back(record.clone());
        if let Some(now) = time(record) {
            self.forget(now);
        }
    }

    /// Lets go of what a trigger now would not need: the last whole round that began before its time is needed, because with it that time
    /// is covered.
    fn forget(&mut self, now: i64) {
        let before = self.window.unwrap_or_default().0;
        if before == 0 {
            self.past.retain(|record| time(record).is_none_or(|t| t >= now));
            return;
        }
        let (mut first, mut behind, mut round) = (0, 0, None);
        for (index, record) in self.past.iter().enumerate() {
            if time(record).is_some_and(|t| t > now - before) {
                break;
            }
            if let Record::Sample(sample) = record {
                if round.replace(sample.n) != Some(sample.n) {
                    first = behind;
                }
                behind = index + 1;
            }
        }
        self.past.drain(..first);
    }

    fn keep(&mut self, record: &Record) -> io::Result<()> {
        self.form.as_mut().map_or(Ok(()), |form| form.record(record))
    }
}

/// When it was, in microseconds.
fn time(record: &Record) -> Option<i64> {
    match record {
        Record::Sample(sample) => Some(micros(sample.t)),
        Record::Trip(trip) => Some(micros(trip.t)),
        Record::Lost(change) | Record::Reopened(change) => Some(micros(change.t)),
        _ => None,
    }
}

fn micros(t: Decimal) -> i64 {
    t.raw * 10i64.pow(6u32.saturating_sub(t.decimals.into()))
}
