//! What is known of a drive that is watched, and what was over the last minutes.

use crate::outcome::{Column, Decimal, Sample, WatchedDrive};
use crate::render::stream::cells::{find, is_number};
use std::collections::VecDeque;

/// What is known of a drive, and what was.
pub(super) struct Drive {
    pub(super) about: WatchedDrive,
    /// Indices of the columns that are drawn: setpoint and actual value, or the first numbers of one unit.
    pub(super) drawn: Vec<usize>,
    pub(super) last: Option<Sample>,
    pub(super) past: VecDeque<Past>,
}

/// A sample as far as it is drawn.
pub(super) struct Past {
    pub(super) t: f64,
    pub(super) values: Vec<Option<f64>>,
    /// No answer came; a value that was not asked for yet is no gap.
    pub(super) is_gap: bool,
}

/// Most samples of a drive that are kept.
const KEPT: usize = 2_000;

impl Drive {
    pub(super) fn new(about: WatchedDrive) -> Self {
        let role = |roles: &[&str]| {
            let found = |column: &Column| column.scaled && column.role.is_some_and(|role| roles.contains(&role));
            about.columns.iter().position(found)
        };
        let setpoint = role(&["setpoint-ramp", "setpoint-bus"]);
        let actual = role(&["actual-frequency", "stator-frequency", "encoder-frequency", "actual-speed"]);
        let actual = actual.or_else(|| role(&["position"]));
        let mut drawn: Vec<usize> = setpoint.into_iter().chain(actual).collect();
        if drawn.is_empty() {
            let numbers = about.columns.iter().enumerate().filter(|(_, column)| is_number(column));
            let first = numbers.clone().next().and_then(|(_, column)| column.unit.clone());
            drawn = numbers.filter(|(_, column)| column.unit == first).map(|(index, _)| index).take(2).collect();
        }
        Drive { about, drawn, last: None, past: VecDeque::new() }
    }

    pub(super) fn take(&mut self, sample: &Sample) {
        let value = |index: &usize| find(self.about.columns.get(*index)?, sample)?.value.map(float);
        let values = self.drawn.iter().map(value).collect();
        if self.past.len() == KEPT {
            self.past.pop_front();
        }
        self.past.push_back(Past { t: float(sample.t), values, is_gap: sample.error.is_some() });
        self.last = Some(sample.clone());
    }
}

pub(super) fn float(decimal: Decimal) -> f64 {
    decimal.raw as f64 / 10f64.powi(decimal.decimals.into())
}
