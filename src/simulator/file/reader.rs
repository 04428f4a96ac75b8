//! Words, times and numbers of a bench file, and how a wrong one is told.

use crate::profile::value::parse_decimal;
use crate::profile::{Broken, Registry};
use crate::protocol::line::Parity;
use crate::protocol::modbus::LAST_STATION;
use crate::text::{Text, both};
use crate::tick::Span;
use std::fmt;
use std::ops::Range;
use toml::{Spanned, Value};

/// Parities that a file can name.
pub(crate) const PARITIES: [Parity; 3] = [Parity::Even, Parity::Odd, Parity::None];

/// What stands on the bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Model {
    Act,
    Acu,
    Lxm05,
    Foreign,
}

impl Model {
    pub(crate) const NAMES: [(&'static str, Model); 4] =
        [("act", Model::Act), ("acu", Model::Acu), ("lxm05", Model::Lxm05), ("foreign", Model::Foreign)];

    pub(crate) fn name(self) -> &'static str {
        Self::NAMES.iter().find(|row| row.1 == self).map_or("", |row| row.0)
    }
}

/// A bench file, and what its rows mean.
#[derive(Debug)]
pub(crate) struct BenchFile<'a> {
    pub(crate) path: &'a str,
    pub(crate) text: &'a str,
    pub(crate) registry: &'a Registry,
}

impl BenchFile<'_> {
    pub(crate) fn error(&self, span: Range<usize>, message: Text) -> Broken {
        Broken::at(self.path, self.text, span.start, message)
    }

    /// `key = got` does not do; `expected` would.
    pub(crate) fn unfit(&self, key: &str, span: Range<usize>, got: &dyn fmt::Display, expected: &Text) -> Broken {
        self.error(span, both!("{key} = {got}; expected {expected}", "{key} = {got}; erwartet: {expected}", expected))
    }

    /// One of the words of a table.
    pub(crate) fn word<T: Copy>(&self, key: &str, got: &Spanned<String>, words: &[(&str, T)]) -> Result<T, Broken> {
        let found = words.iter().find(|(word, _)| word == got.get_ref());
        found.map(|(_, value)| *value).ok_or_else(|| {
            let known: Vec<_> = words.iter().map(|row| row.0).collect();
            self.unfit(key, got.span(), &quoted(got), &one_of(&known.join(", ")))
        })
    }

    pub(crate) fn time(&self, key: &str, got: &Spanned<String>) -> Result<Span, Broken> {
        got.get_ref().parse().map_err(|_| {
            let expected =
                both!("a time with unit, such as \"10ms\", \"2s\"", "eine Zeit mit Einheit wie \"10ms\" oder \"2s\"");
            self.unfit(key, got.span(), &quoted(got), &expected)
        })
    }

    pub(crate) fn time_or(&self, key: &str, got: Option<&Spanned<String>>, default: Span) -> Result<Span, Broken> {
        got.map_or(Ok(default), |got| self.time(key, got))
    }

    pub(crate) fn station(&self, got: &Spanned<i64>) -> Result<u8, Broken> {
        let station = u8::try_from(*got.get_ref()).ok().filter(|station| (1..=LAST_STATION).contains(station));
        station.ok_or_else(|| self.unfit("address", got.span(), got.get_ref(), &from_to(1, LAST_STATION)))
    }

    pub(crate) fn count(&self, got: &Spanned<u64>) -> Result<u64, Broken> {
        match *got.get_ref() {
            0 => {
                let message = both!("0 hits nothing; expected 1 or more", "0 trifft nichts; erwartet: 1 oder mehr");
                Err(self.error(got.span(), message))
            }
            count => Ok(count),
        }
    }
}

/// As it stands in the file.
pub(crate) fn quoted(got: &Spanned<String>) -> String {
    format!("\"{}\"", got.get_ref())
}

/// One of these words.
pub(crate) fn one_of(known: &str) -> Text {
    both!("one of: {known}", "{known}")
}

/// A number between these.
pub(crate) fn from_to(low: impl fmt::Display, high: impl fmt::Display) -> Text {
    both!("{low} to {high}", "{low} bis {high}")
}

/// What a drive throws its dice with.
pub(crate) fn own_seed(seed: u64, address: u8) -> u64 {
    seed.wrapping_mul(256).wrapping_add(address.into())
}

/// Reads a number, written as one or as text.
pub(crate) fn decimal(value: &Value, decimals: u8) -> Result<i64, Text> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Integer(number) => number.to_string(),
        Value::Float(number) => number.to_string(),
        _ => return Err(both!("expected a number", "erwartet wird eine Zahl")),
    };
    parse_decimal(&text, decimals).map_err(|error| error.text())
}
