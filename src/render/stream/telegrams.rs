//! One line a telegram as it comes, for people.

use super::cells::seconds;
use super::{Form, Manner};
use crate::outcome::{Record, SniffCount, StationChange, StationNews, StreamEnd, StreamSummary, TelegramDoc};
use crate::profile::value::format_decimal;
use crate::render::clean;
use crate::render::finding::{Page, direction};
use crate::render::wrap::wrap;
use crate::text::both;
use std::io::{self, Write};

/// Milliseconds of a day, with three places.
const TIME: usize = 12;
/// Eight bytes, the usual question of Modbus RTU.
const BYTES: usize = 23;
/// A frame of CAN with eight bytes.
const FRAME: usize = 27;

pub(super) struct Telegrams<'a> {
    out: &'a mut dyn Write,
    manner: Manner,
}

impl<'a> Telegrams<'a> {
    pub(super) fn new(out: &'a mut dyn Write, manner: Manner) -> Self {
        Telegrams { out, manner }
    }

    /// What was counted, between empty lines.
    fn count(&mut self, count: &SniffCount) -> io::Result<()> {
        if count.stations.is_empty() {
            return Ok(());
        }
        let Manner { lang, width, .. } = self.manner;
        writeln!(self.out, "\n{}", Page { lang, width, full: false, node: 0 }.sniffed(count))?;
        self.out.flush()
    }

    /// A station of a PROFIBUS line, and what became of it.
    fn station(&mut self, news: &StationNews) -> io::Result<()> {
        let lang = self.manner.lang;
        let (at, station) = (seconds(news.t), &news.station);
        let change = match news.change {
            StationChange::Came => both!("came", "kam"),
            StationChange::Changed => both!("changed", "anders"),
            StationChange::Went => both!("went", "ging"),
        };
        let ident = station.ident.as_deref().map(|ident| format!("ident {ident}"));
        let master = station.master.map(|master| format!("master {master}"));
        let data = station.layout.or(station.configuration.as_deref()).map(str::to_owned);
        let state = station.does().map(|does| does.get(lang).to_owned());
        let error = station.error.as_ref().map(|error| error.message.get(lang).to_owned());
        let told: Vec<String> = [ident, state, master, data, error].into_iter().flatten().collect();
        let (is, told) = (clean(station.is.get(lang)), clean(&told.join("  ")));
        writeln!(self.out, "{at:>TIME$}  {:>3}  {:<8}  {is}  {told}", station.address, change.get(lang))?;
        self.out.flush()
    }

    fn line(&mut self, doc: &TelegramDoc) -> io::Result<()> {
        let at = doc.at_us.map_or_else(String::new, |us| format_decimal(us as i64, 3));
        let (sign, meaning) = (direction(doc), clean(doc.meaning.get(self.manner.lang)));
        let width = if self.manner.is_can { FRAME } else { BYTES };
        writeln!(self.out, "{at:>TIME$}  {sign}  {:<width$}  {meaning}", doc.hex)?;
        self.out.flush()
    }
}

impl Form for Telegrams<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Telegram(telegram) => self.line(telegram),
            Record::Statistics(count) => self.count(count),
            Record::Station(news) => self.station(news),
            Record::End(StreamEnd { summary: Some(StreamSummary::Sniff(sniff)), .. }) => {
                self.count(&sniff.count)?;
                // What went on without one that was asked has its limits too.
                match sniff.count.stations.is_empty() && sniff.count.heard == 0 {
                    true => Ok(()),
                    false => writeln!(self.out, "{}", wrap(sniff.unseen.get(self.manner.lang), self.manner.width)),
                }
            }
            Record::End(StreamEnd { summary: Some(StreamSummary::Bus(heard)), .. }) => {
                let Manner { lang, width, .. } = self.manner;
                writeln!(self.out, "\n{}", Page { lang, width, full: false, node: 0 }.bus_heard(heard))?;
                self.out.flush()
            }
            _ => Ok(()),
        }
    }
}
