//! What all forms for people, and CSV, have in common: columns over all drives, and values as text.

use crate::outcome::{Bit, Column, Decimal, Sample, StreamStart, Value, Word};
use crate::profile::Lang;
use crate::profile::value::format_decimal;
use crate::render::words::word;

/// The columns of all drives that are watched, each once.
#[derive(Clone, Debug, Default)]
pub(super) struct Board {
    pub(super) columns: Vec<Column>,
}

impl Board {
    pub(super) fn of(start: &StreamStart) -> Self {
        let mut columns: Vec<Column> = Vec::new();
        for column in start.drives.iter().flat_map(|drive| &drive.columns) {
            if !columns.iter().any(|known| known.is_of(column)) {
                columns.push(column.clone());
            }
        }
        Board { columns }
    }

    /// Every column with the value that a sample has for it.
    pub(super) fn values<'s>(&'s self, sample: &'s Sample) -> impl Iterator<Item = (&'s Column, Option<&'s Value>)> {
        self.columns.iter().map(|column| (column, find(column, sample)))
    }

    /// What stands over a column: short for what every drive has, the name for the rest.
    pub(super) fn label(&self, column: &Column, lang: Lang) -> String {
        let short = |column: &Column| match column.role {
            Some("setpoint-ramp" | "setpoint-bus" | "setpoint-velocity") => Some("setpoint"),
            Some("actual-frequency" | "stator-frequency" | "encoder-frequency" | "actual-speed") => Some("actual"),
            Some("current") => Some("current"),
            Some("dc-link-voltage") => Some("DC link"),
            Some("fault") => Some("fault"),
            Some("warnings") => Some("warnings"),
            _ => None,
        };
        let own =
            short(column).filter(|own| self.columns.iter().filter(|other| short(other) == Some(*own)).count() == 1);
        let name = own.map_or_else(|| column.name.get(lang).to_owned(), |own| word(lang, own).to_owned());
        if column.data_set > 0 { format!("{name}@{}", column.data_set) } else { name }
    }
}

/// The value that a sample has for a column, if it could be read.
pub(in crate::render) fn find<'s>(column: &Column, sample: &'s Sample) -> Option<&'s Value> {
    let value = sample.values.iter().map(|value| &value.value).find(|value| column.holds(value));
    value.filter(|value| value.raw.is_some())
}

/// A value as a number: exact, or raw where nobody knows the decimals.
pub(in crate::render) fn number(value: &Value) -> String {
    match (value.value, value.raw) {
        (Some(Decimal { raw, decimals }), _) => format_decimal(raw, decimals),
        // Its bits are no number at all.
        (None, Some(_)) if value.kind == Some("float") => "-".to_owned(),
        (None, Some(raw)) => raw.to_string(),
        (None, None) => String::new(),
    }
}

/// A value for people, short: `24.93`, `F0500`, `0x0082`, `none`.
pub(in crate::render) fn short(column: &Column, value: Option<&Value>, lang: Lang) -> String {
    let Some(value) = value else { return GAP.to_owned() };
    match (column.role, value.raw, &value.word, &value.text) {
        (Some("fault" | "warnings"), Some(0), ..) => word(lang, "none").to_owned(),
        (Some("fault"), _, _, Some(text)) => text.get(lang).split(' ').next().unwrap_or_default().to_owned(),
        (_, _, Some(word), _) => word.hex.clone(),
        (_, _, _, Some(text)) => text.get(lang).to_owned(),
        (_, Some(raw), ..) if !column.scaled => format!("{} {raw}", word(lang, "raw")),
        _ => number(value),
    }
}

/// The first name of the bits that are set, and how many others there are: `Ixt +2`; of anything else what [`long`] says.
pub(in crate::render) fn first_of(column: &Column, value: &Value, lang: Lang) -> String {
    let told = long(column, value, lang);
    match value.word.as_ref().map(|word| bits(word, lang)).unwrap_or_default().split_first() {
        Some((first, others)) if !others.is_empty() => format!("{first} +{}", others.len()),
        _ => told,
    }
}

/// The names of the bits that are set; the number of one that nobody named.
pub(in crate::render) fn bits(of: &Word, lang: Lang) -> Vec<String> {
    let unnamed = |bit: &Bit| format!("{} {}", word(lang, "bit"), bit.bit);
    let name = |bit: &Bit| bit.name.as_ref().map_or_else(|| unnamed(bit), |name| name.get(lang).to_owned());
    of.bits.iter().filter(|bit| bit.set).map(name).collect()
}

/// The names of the bits that are set, or the text of a value, for people.
pub(in crate::render) fn long(column: &Column, value: &Value, lang: Lang) -> String {
    match (column.role, &value.word) {
        (Some("status-word"), Some(status)) => {
            status.state.as_ref().map_or_else(String::new, |state| state.name.get(lang).to_owned())
        }
        (Some("fault"), None) if value.raw == Some(0) => word(lang, "none").to_owned(),
        (_, Some(word)) if word.raw == 0 => self::word(lang, "none").to_owned(),
        (_, Some(word)) => bits(word, lang).join(", "),
        (_, None) => value.text.as_ref().map_or_else(String::new, |text| text.get(lang).to_owned()),
    }
}

/// Whether a column is a number that can be drawn.
pub(super) fn is_number(column: &Column) -> bool {
    column.scaled && !matches!(column.role, Some("status-word" | "fault" | "warnings"))
}

/// Seconds with three decimals.
pub(super) fn seconds(t: Decimal) -> String {
    format_decimal(t.raw / 1_000, 3)
}

/// Stands for a value that is missing.
pub(in crate::render) const GAP: &str = "--";
