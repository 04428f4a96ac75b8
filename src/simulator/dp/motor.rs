//! The motor behind an inverter: a frequency that goes by ramps, and a shaft that goes on turning without power.

use crate::tick::{Span, Tick};

/// A turning field and the shaft in it, 0.01 Hz, positive clockwise.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motor {
    /// Where it was, and when.
    at: Tick,
    from: i64,
    to: i64,
    /// Time from 0 to [`Motor::full`].
    ramp: Span,
    /// Maximum frequency.
    pub(crate) full: i64,
    is_fed: bool,
    /// A load keeps the shaft from becoming slower as long as it has power.
    dragged: bool,
}

/// How long a shaft without power goes on turning from full speed.
const COASTING: Span = Span::from_secs(8);
/// How long the DC brake takes from full speed.
const BRAKING: Span = Span::from_millis(500);

impl Motor {
    pub(crate) fn new(full: i64) -> Self {
        Motor { at: Tick::ZERO, from: 0, to: 0, ramp: Span::from_secs(1), full, is_fed: false, dragged: false }
    }

    /// Speed of the shaft.
    pub(crate) fn shaft(&self, now: Tick) -> i64 {
        let elapsed = i128::from(now.since(self.at).as_micros());
        let ramp = i128::from(self.ramp.as_micros().max(1));
        let step = i64::try_from(i128::from(self.full) * elapsed / ramp).unwrap_or(i64::MAX);
        match self.from <= self.to {
            true => self.from.saturating_add(step).min(self.to),
            false => self.from.saturating_sub(step).max(self.to),
        }
    }

    /// Output frequency: 0 without power, whatever the shaft does.
    pub(crate) fn frequency(&self, now: Tick) -> i64 {
        if self.is_fed { self.shaft(now) } else { 0 }
    }

    /// Whether the inverter feeds it.
    pub(crate) fn is_fed(&self) -> bool {
        self.is_fed
    }

    /// Goes to a frequency by a ramp.
    pub(crate) fn go(&mut self, now: Tick, to: i64, ramp: Span) {
        let (to, shaft) = (to.clamp(-self.full, self.full), self.shaft(now));
        let to = if self.dragged && to.abs() < shaft.abs() { shaft } else { to };
        if self.is_fed && (self.to, self.ramp) == (to, ramp) {
            return;
        }
        *self = Motor { at: now, from: shaft, to, ramp, is_fed: true, ..*self };
    }

    /// A load drags it from now on, or no more.
    pub(crate) fn drag(&mut self, now: Tick, is_dragged: bool) {
        self.dragged = is_dragged;
        if is_dragged {
            self.hold(now);
        }
    }

    /// Stops by a ramp; at rest the power goes.
    pub(crate) fn stop(&mut self, now: Tick, ramp: Span) {
        if self.is_fed && self.shaft(now) == 0 && self.to == 0 {
            self.is_fed = false;
        }
        if self.is_fed {
            self.go(now, 0, ramp);
        }
    }

    /// Loses its power once it has come to rest.
    pub(crate) fn rests(&mut self, now: Tick) {
        self.is_fed &= self.to != 0 || self.shaft(now) != 0;
    }

    /// Keeps the frequency that it has.
    pub(crate) fn hold(&mut self, now: Tick) {
        if self.is_fed {
            self.go(now, self.shaft(now), self.ramp);
        }
    }

    /// Stops by the DC brake.
    pub(crate) fn brake(&mut self, now: Tick) {
        self.stop(now, BRAKING);
    }

    /// Loses its power.
    pub(crate) fn coast(&mut self, now: Tick) {
        if self.is_fed {
            *self = Motor { at: now, from: self.shaft(now), to: 0, ramp: COASTING, is_fed: false, ..*self };
        }
    }
}
