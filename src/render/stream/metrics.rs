//! What feeds other tools has in common: whose a value is, and what every drive tells besides its parameters.

use crate::outcome::{Decimal, Sample, StreamStart, Value};
use crate::profile::value::format_decimal;

/// Name and value of a label.
pub(super) type Label = (&'static str, String);

/// Whose values they are.
#[derive(Clone, Debug, Default)]
pub(super) struct Origin {
    port: String,
    /// When the stream began, in microseconds since 1970; the bench has no time of day.
    begun: Option<i64>,
    /// How many drives are watched.
    pub(super) drives: usize,
}

impl Origin {
    pub(super) fn of(start: &StreamStart) -> Self {
        let begun = start.begun.map(|begun| begun.raw);
        Origin { port: start.port.clone(), begun, drives: start.drives.len() }
    }

    /// Names of the labels, in their order, with what they are for a drive; without a name in the project file it has no `drive`.
    pub(super) fn labels(&self, sample: &Sample) -> Vec<Label> {
        let called = sample.called.clone().map(|name| ("drive", name));
        let address = ("address", sample.address.to_string());
        [address].into_iter().chain(called).chain([("family", sample.drive.clone()), self.line()]).collect()
    }

    /// What names the line itself.
    pub(super) fn line(&self) -> Label {
        ("port", self.port.clone())
    }

    /// The time of day of a moment of the stream, in nanoseconds since 1970.
    pub(super) fn nanoseconds(&self, t: Decimal) -> Option<i64> {
        self.begun?.checked_add(t.raw)?.checked_mul(1_000)
    }
}

/// The name of a value: which set and which memory it is of is part of it where it is not the usual one.
pub(super) fn key(value: &Value) -> String {
    let set = if value.data_set > 0 { format!("_{}", value.data_set) } else { String::new() };
    let raw = if value.value.is_none() { "_raw" } else { "" };
    format!("{}{set}{raw}", value.slug.replace('-', "_"))
}

/// A value as a number, and whether it is in its unit.
pub(super) fn number(value: &Value) -> Option<String> {
    match (value.value, value.raw) {
        (Some(Decimal { raw, decimals }), _) => Some(format_decimal(raw, decimals)),
        (None, raw) => raw.map(|raw| raw.to_string()),
    }
}

/// What went wrong with a sample, if something did.
pub(super) fn error(sample: &Sample) -> Option<&str> {
    let own = sample.values.iter().find_map(|value| value.value.error.as_ref());
    sample.error.as_ref().or(own).map(|error| error.code.as_str())
}
