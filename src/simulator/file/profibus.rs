//! What a bench file says of a PROFIBUS line.

use super::reader::{BenchFile, from_to, one_of};
use crate::profile::{Broken, Registry, stumbled};
use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::device::readings::Reading as _;
use crate::simulator::dp::bench::{Disturbance, Event, IDENT, Profibus, Setup};
use crate::simulator::dp::inverter::Kind;
use crate::simulator::dp::readings::{Reading, Readings};
use crate::text::both;
use crate::tick::{Span, Tick};
use serde::Deserialize;
use std::collections::BTreeMap;
use toml::Spanned;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default)]
    line: LineTable,
    #[serde(default)]
    module: Vec<ModuleTable>,
    #[serde(default)]
    stuck: Vec<StuckTable>,
    #[serde(default)]
    master: Vec<MasterTable>,
}

/// Another master is active for a while.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct MasterTable {
    address: u8,
    at: Spanned<String>,
    by: Spanned<String>,
    every: Option<Spanned<String>>,
}

/// The port of the master takes no bytes for a while.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct StuckTable {
    at: Spanned<String>,
    by: Spanned<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct LineTable {
    baud: Option<Spanned<u32>>,
    #[serde(default)]
    seed: u64,
    #[serde(default)]
    echo: bool,
    #[serde(default)]
    flips: u64,
    #[serde(default)]
    losses: u64,
    latency: Option<Spanned<String>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ModuleTable {
    drive: Spanned<String>,
    address: Spanned<u8>,
    ident: Option<u16>,
    #[serde(default)]
    set: BTreeMap<Spanned<String>, i64>,
    #[serde(default)]
    readings: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    event: Vec<EventTable>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct EventTable {
    at: Spanned<String>,
    #[serde(default)]
    trip: bool,
    contact: Option<bool>,
    cut: Option<bool>,
    dragged: Option<bool>,
}

/// Speeds that a slave finds by itself (fieldbus facts: what adapters reach).
const RATES: [u32; 6] = [9_600, 19_200, 93_750, 187_500, 500_000, 1_500_000];
/// So often another master speaks where nothing else is said, and so often in all.
const TOKENS: Span = Span::from_millis(50);
const MOST_TOKENS: usize = 100_000;
/// Addresses that the rotary switches have (SJ2-PB manual 1.4).
const LAST: u8 = 99;

impl Profibus {
    /// The line of a file. `path` is only for the messages.
    pub fn from_toml(path: &str, text: &str, registry: &Registry) -> Result<Self, Broken> {
        let reader = BenchFile { path, text, registry };
        let file: File = toml::from_str(text).map_err(|error| {
            let (at, why) = stumbled(&error);
            reader.error(at..at, why)
        })?;
        if file.module.is_empty() {
            let message = both!("no [[module]]; expected at least one", "kein [[module]]; erwartet: mindestens eines");
            return Err(reader.error(0..0, message));
        }
        let table = &file.line;
        let baud = match &table.baud {
            Some(got) if !RATES.contains(got.get_ref()) => {
                let known = RATES.map(|rate| rate.to_string()).join(", ");
                return Err(reader.unfit("baud", got.span(), got.get_ref(), &one_of(&known)));
            }
            got => got.as_ref().map_or(19_200, |got| *got.get_ref()),
        };
        let latency = reader.time_or("latency", table.latency.as_ref(), Span::ZERO)?;
        let LineTable { flips, losses, echo, seed, .. } = *table;
        let disturbance = Disturbance { flips, losses, echo, latency };
        let setups = file.module.iter().map(|row| reader.module(row)).collect::<Result<_, _>>()?;
        let spells = file.stuck.iter().map(|row| {
            let at = Tick::ZERO + reader.time("at", &row.at)?;
            Ok((at, at + reader.time("by", &row.by)?))
        });
        let stuck = spells.collect::<Result<_, _>>()?;
        let tokens = file.master.iter().map(|row| reader.tokens(row)).collect::<Result<Vec<_>, _>>()?;
        let line = LineSetting::rtu(baud, Parity::Even);
        Ok(Profibus::new(line, setups, disturbance, seed, registry).stuck(stuck).beside(tokens.concat()))
    }
}

impl BenchFile<'_> {
    /// When another master speaks.
    fn tokens(&self, row: &MasterTable) -> Result<Vec<(Tick, u8)>, Broken> {
        let begins = Tick::ZERO + self.time("at", &row.at)?;
        let ends = begins + self.time("by", &row.by)?;
        let every = self.time_or("every", row.every.as_ref(), TOKENS)?.longer(Span::from_millis(1));
        let all = std::iter::successors(Some(begins), |at| Some(*at + every));
        Ok(all.take_while(|at| *at < ends).take(MOST_TOKENS).map(|at| (at, row.address)).collect())
    }

    fn module(&self, row: &ModuleTable) -> Result<Setup, Broken> {
        let kind = self.word("drive", &row.drive, &Kind::NAMES)?;
        let address = *row.address.get_ref();
        if !(1..=LAST).contains(&address) {
            return Err(self.unfit("address", row.address.span(), &address, &from_to(1, LAST)));
        }
        let mut readings = Readings::default();
        for (key, word) in &row.readings {
            let message = || {
                both!("readings: a module has no question \"{key}\"", "readings: ein Modul hat keine Frage \"{key}\"")
            };
            let question = Reading::question(key).ok_or_else(|| self.error(word.span(), message()))?;
            if let Some(reading) = self.word(key, word, question.words)? {
                readings.add(reading);
            }
        }
        let parsed = |index: &str| {
            let (number, element) = index.split_once('.').unwrap_or((index, "0"));
            Some((number.parse().ok()?, element.parse().ok()?))
        };
        let set = row.set.iter().map(|(index, raw)| match parsed(index.get_ref()) {
            Some((number, element)) => Ok((number, element, *raw)),
            None => {
                let index_is = index.get_ref();
                let message = both!("\"{index_is}\"; expected an index", "\"{index_is}\"; erwartet: ein Index");
                Err(self.error(index.span(), message))
            }
        });
        let set = set.collect::<Result<_, _>>()?;
        let mut events = Vec::new();
        for event in &row.event {
            let at = Tick::ZERO + self.time("at", &event.at)?;
            events.extend(event.trip.then_some((at, Event::Trip)));
            events.extend(event.contact.map(|is_closed| (at, Event::Contact(is_closed))));
            events.extend(event.cut.map(|is_cut| (at, Event::Cut(is_cut))));
            events.extend(event.dragged.map(|is_dragged| (at, Event::Dragged(is_dragged))));
        }
        Ok(Setup { kind, address, ident: row.ident.unwrap_or(IDENT), readings, set, events })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulator::device::readings::are_told;

    const EXAMPLE: &str = include_str!("../profibus.toml");

    fn line(text: &str) -> Result<Profibus, String> {
        let registry = Registry::open(&[]).unwrap();
        Profibus::from_toml("line.toml", text, &registry).map_err(|error| error.to_string())
    }

    #[test]
    fn the_example_is_a_line_and_tells_every_reading() {
        let modules: Vec<_> = line(EXAMPLE).unwrap().modules().collect();
        assert_eq!(modules, [("l200", 3)]);
        are_told::<Reading>(EXAMPLE);
    }

    #[test]
    fn refusals_say_where_and_what_was_expected() {
        let module = |rest: &str| line(&format!("[[module]]\ndrive = \"l200\"\n{rest}\n")).unwrap_err();
        assert_eq!(module("address = 100"), "line.toml:3:11: address = 100; expected 1 to 99");
        assert!(module("address = 3\nset = { \"F002\" = 1 }").contains("expected an index"));
        assert!(module("address = 3\nreadings = { unlock = \"perhaps\" }").contains("expected one of: loss, no-loss"));
        assert!(module("address = 3\nreadings = { colour = \"red\" }").contains("no question"));
        assert!(line("[line]\nbaud = 57600\n[[module]]\ndrive = \"l200\"\naddress = 3").unwrap_err().contains("19200"));
        assert!(line("").unwrap_err().contains("at least one"));
    }
}
