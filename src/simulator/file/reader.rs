//! Words, times and numbers of a bench file, and how a wrong one is told.

use crate::profile::Registry;
use crate::profile::value::parse_decimal;
use crate::protocol::line::Parity;
use crate::protocol::modbus::LAST_STATION;
use crate::text::{Text, both};
use crate::tick::Span;
use std::ops::Range;
use toml::{Spanned, Value};

/// Why a bench file is refused, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{path}:{line}:{column}: {message}")]
pub struct BenchError {
    /// The file.
    pub path: String,
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1.
    pub column: usize,
    /// What is wrong, and what was expected.
    pub message: String,
}

impl BenchError {
    /// In words for people; what is wrong with a file of this format is told in English.
    pub fn text(&self) -> Text {
        let BenchError { path, line, column, message } = self;
        both!("{path}:{line}:{column}: {message}", "{path}:{line}:{column}: {message}", message = Text::quoted(message))
    }
}

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
    pub(crate) fn error(&self, span: Range<usize>, message: String) -> BenchError {
        let (line, column) = crate::profile::place(self.text, span.start);
        BenchError { path: self.path.to_owned(), line, column, message }
    }

    /// One of the words of a table.
    pub(crate) fn word<T: Copy>(&self, key: &str, got: &Spanned<String>, words: &[(&str, T)]) -> Result<T, BenchError> {
        let found = words.iter().find(|(word, _)| word == got.get_ref());
        found.map(|(_, value)| *value).ok_or_else(|| {
            let known: Vec<_> = words.iter().map(|row| row.0).collect();
            let message = format!("{key} = \"{}\"; expected one of: {}", got.get_ref(), known.join(", "));
            self.error(got.span(), message)
        })
    }

    pub(crate) fn time(&self, key: &str, got: &Spanned<String>) -> Result<Span, BenchError> {
        got.get_ref().parse().map_err(|_| {
            let message = format!("{key} = \"{}\"; expected a time with unit, such as \"10ms\", \"2s\"", got.get_ref());
            self.error(got.span(), message)
        })
    }

    pub(crate) fn time_or(&self, key: &str, got: Option<&Spanned<String>>, default: Span) -> Result<Span, BenchError> {
        got.map_or(Ok(default), |got| self.time(key, got))
    }

    pub(crate) fn station(&self, got: &Spanned<i64>) -> Result<u8, BenchError> {
        let station = u8::try_from(*got.get_ref()).ok().filter(|station| (1..=LAST_STATION).contains(station));
        let message = || format!("address = {}; expected 1 to {LAST_STATION}", got.get_ref());
        station.ok_or_else(|| self.error(got.span(), message()))
    }

    pub(crate) fn count(&self, got: &Spanned<u64>) -> Result<u64, BenchError> {
        match *got.get_ref() {
            0 => Err(self.error(got.span(), "0 hits nothing; expected 1 or more".to_owned())),
            count => Ok(count),
        }
    }
}

/// What a drive throws its dice with.
pub(crate) fn own_seed(seed: u64, address: u8) -> u64 {
    seed.wrapping_mul(256).wrapping_add(address.into())
}

/// Reads a number, written as one or as text.
pub(crate) fn decimal(value: &Value, decimals: u8) -> Result<i64, String> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Integer(number) => number.to_string(),
        Value::Float(number) => number.to_string(),
        other => return Err(format!("{} given; expected a number", other.type_str())),
    };
    parse_decimal(&text, decimals).map_err(|error| error.to_string())
}
