//! What leads the setpoint of a run that is held, on whatever line: its way first, then the arrows of the keypad.

use super::keys::Keys;
use crate::drive::Panel;
use crate::profile::setpoint::Schedule;
use crate::text::{Text, both};
use crate::tick::Span;

/// The way of a setpoint, and what the arrows do at its end; raw.
#[derive(Clone, Debug)]
pub(in crate::command) struct Way {
    pub(in crate::command) schedule: Schedule,
    pub(in crate::command) keys: Option<Keys>,
}

/// Who leads it.
pub(in crate::command) struct Leads<'l> {
    schedule: &'l Schedule,
    keys: Option<Keys>,
    panel: &'l Panel,
    /// What a key is told that leaves the bounds.
    refused: Option<Text>,
    /// What was given last.
    given: i64,
    /// Who pressed an arrow on the way was told that it does nothing yet.
    told: bool,
}

impl<'l> Leads<'l> {
    /// At the beginning of the way.
    pub(in crate::command) fn new(
        schedule: &'l Schedule,
        (keys, refused): (Option<Keys>, Option<Text>),
        panel: &'l Panel,
    ) -> Self {
        Leads { schedule, keys, panel, refused, given: schedule.at(0), told: false }
    }

    /// How long it is led.
    pub(in crate::command) fn takes(&self) -> Span {
        Span::from_micros(self.schedule.end_us())
    }

    /// Where it is on its way after a time, and what somebody is told who presses an arrow there.
    pub(in crate::command) fn on_its_way(&mut self, gone: Span) -> (i64, Option<Text>) {
        self.given = self.schedule.at(gone.as_micros());
        let presses = !self.panel.take_steps().is_empty() && !std::mem::replace(&mut self.told, true);
        let told = presses.then(|| {
            both!("the arrows work when the way is at its end", "die Pfeile wirken, wenn der Verlauf zu Ende ist")
        });
        (self.given, told)
    }

    /// Its last value. What was pressed on the way means nothing.
    pub(in crate::command) fn arrives(&mut self) -> i64 {
        self.panel.take_steps();
        self.given = self.schedule.at(u64::MAX);
        self.given
    }

    /// Where the arrows have brought it, and what is told of one that would have left the bounds.
    pub(in crate::command) fn by_arrows(&mut self) -> (i64, Option<Text>) {
        let steps = self.panel.take_steps();
        let (next, is_refused) = self.keys.map_or((self.given, false), |keys| keys.after(self.given, &steps));
        self.given = next;
        (next, self.refused.clone().filter(|_| is_refused))
    }

    /// The drive did not take what was given: this stands.
    pub(in crate::command) fn stays_at(&mut self, raw: i64) {
        self.given = raw;
    }
}
