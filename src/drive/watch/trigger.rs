//! What a watch waits for: a value that passes a level, a bit that changes, a state that is reached.

use super::item::Item;
use crate::outcome::{Column, Sample, TriggerNews, Value, addressed};
use crate::profile::value::format_decimal;
use crate::profile::{Family, Type};
use crate::text::{Text, both};

/// What is waited for in a drive of one family.
#[derive(Clone, Debug)]
pub struct Condition {
    /// As it was typed.
    pub text: String,
    /// What is looked at.
    pub signal: Signal,
    /// What it must do.
    pub test: Test,
}

/// What a condition looks at.
#[derive(Clone, Debug)]
pub enum Signal {
    /// The state of the drive.
    State,
    /// A value, or one of its bits.
    Value(Box<Item>, Option<u8>),
}

/// What the signal must do.
#[derive(Clone, Debug, PartialEq)]
pub enum Test {
    /// Become this state, out of another one; a fault is any state of one.
    Becomes(String),
    /// Compare so with this level, and not have done so before; also at the first look.
    Is(Compare, i64),
    /// Come from below this level to it or above it.
    Rises(i64),
    /// Come from above this level to it or below it.
    Falls(i64),
}

/// A comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compare {
    /// `>`
    Above,
    /// `>=`
    AtLeast,
    /// `<`
    Below,
    /// `<=`
    AtMost,
    /// `=`
    Equal,
    /// `!=`
    Other,
}

/// A condition that is looked at, of one drive.
#[derive(Clone, Debug)]
pub(super) struct Armed {
    pub(super) text: String,
    test: Test,
    /// The column of the value, its bit, and whether it is a float; none where the state is looked at.
    column: Option<(Column, Option<u8>, bool)>,
    state: Option<String>,
    value: Option<f64>,
    was_so: bool,
}

impl Armed {
    pub(super) fn new(condition: Condition, family: &Family) -> Self {
        let mut test = condition.test;
        let column = match condition.signal {
            Signal::State => None,
            Signal::Value(item, bit) => {
                let is_float = item.param().kind == Some(Type::Float);
                if let Some(full) = item.full() {
                    test = test.part_of(full);
                }
                item.columns(family).into_iter().next().map(|column| (column, bit, is_float))
            }
        };
        Armed { text: condition.text, test, column, state: None, value: None, was_so: false }
    }

    /// Whether it comes true with this sample. What a gap hides is seen behind it.
    pub(super) fn comes_true(&mut self, sample: &Sample) -> bool {
        let Some((column, bit, is_float)) = &self.column else { return self.becomes(sample) };
        let values = || sample.values.iter().map(|row| &row.value).filter(|value| value.raw.is_some());
        let its = values().find(|value| column.holds(value));
        // The sets differ, so each has a column of its own by now: the first one stands for all.
        let Some(value) = its.or_else(|| values().find(|value| value.param == column.param)) else { return false };
        let Some(now) = number(value, *bit, *is_float) else { return false };
        let level = |raw: i64| if *is_float { float(raw) } else { raw as f64 };
        let before = self.value.replace(now);
        match &self.test {
            Test::Becomes(_) => false,
            Test::Rises(raw) => before.is_some_and(|before| before < level(*raw)) && now >= level(*raw),
            Test::Falls(raw) => before.is_some_and(|before| before > level(*raw)) && now <= level(*raw),
            Test::Is(compare, raw) => {
                let is_so = compare.holds(now, level(*raw));
                is_so && !std::mem::replace(&mut self.was_so, is_so)
            }
        }
    }

    fn becomes(&mut self, sample: &Sample) -> bool {
        let Some(now) = sample.state.as_ref().map(|state| state.slug.clone()) else { return false };
        let before = self.state.replace(now.clone());
        // A drive is in a fault from the reaction to it on.
        let is_it = |wanted: &str, state: &str| state == wanted || (wanted == "fault" && state.starts_with("fault"));
        matches!(&self.test, Test::Becomes(wanted) if is_it(wanted, &now) && before.is_some_and(|before| !is_it(wanted, &before)))
    }
}

impl Test {
    /// A level in hundredths of a percent, of a word of which this is 100 %.
    fn part_of(self, full: i64) -> Self {
        let raw = |level: i64| level * full / 10_000;
        match self {
            Test::Is(compare, level) => Test::Is(compare, raw(level)),
            Test::Rises(level) => Test::Rises(raw(level)),
            Test::Falls(level) => Test::Falls(raw(level)),
            becomes @ Test::Becomes(_) => becomes,
        }
    }
}

impl Compare {
    fn holds(self, value: f64, level: f64) -> bool {
        match self {
            Compare::Above => value > level,
            Compare::AtLeast => value >= level,
            Compare::Below => value < level,
            Compare::AtMost => value <= level,
            Compare::Equal => value == level,
            Compare::Other => value != level,
        }
    }
}

/// A value, or its bit, as a number. Raw values are far below 2^53, so nothing is rounded.
fn number(value: &Value, bit: Option<u8>, is_float: bool) -> Option<f64> {
    let raw = value.raw?;
    Some(match bit {
        Some(bit) => f64::from(u8::from(raw >> bit & 1 == 1)),
        None if is_float => float(raw),
        None => raw as f64,
    })
}

/// A float of which the raw value is the bits.
fn float(raw: i64) -> f64 {
    f64::from(f32::from_bits(raw as u32))
}

/// A trigger that came true, for people.
pub(super) fn told(news: &TriggerNews) -> Text {
    let TriggerNews { t, address, node, trigger, .. } = news;
    let address = addressed(*address, *node);
    let t = format_decimal(t.raw / 1_000, 3);
    both!("trigger at {t} s, address {address}: {trigger}", "Auslöser bei {t} s, Adresse {address}: {trigger}")
}
