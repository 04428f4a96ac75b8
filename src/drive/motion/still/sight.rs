//! What looks tell of the shaft of a drive that shows the frequency of its stator: that is 0 without power, whatever the shaft does.

/// What looks tell of a shaft whose drive shows the frequency of its stator, which is 0 without power.
#[derive(Debug, Default)]
pub(in super::super) struct Sight {
    /// Whether the drive had power at the last look at its state.
    pub(in super::super) on: Option<bool>,
    /// The frequency was 0 since then; whether under power, only the next look at the state tells.
    pub(in super::super) zero: bool,
    /// It was 0 before anybody looked at the state.
    early: bool,
    /// The last look showed movement.
    turns: bool,
    /// What the last look under power showed of a shaft that turned.
    last: Option<i64>,
    /// What also tells without power was seen turning: an encoder, or the frequency itself.
    pub(in super::super) free: bool,
    /// It was seen to stand under power.
    pub(in super::super) held: bool,
    /// It was seen to come to rest without power.
    rested: bool,
    /// The stop goes as a setting says, which may be by direct current: that takes the frequency away, not the speed.
    pub(in super::super) by_setting: bool,
    /// The drive has said what a 0 under power is worth then; whoever interrupts that question has no answer to it.
    pub(in super::super) settled: bool,
}

impl Sight {
    /// A look at the state.
    pub(in super::super) fn state(&mut self, on: Option<bool>) {
        self.held |= self.zero && on == Some(true);
        (self.on, self.zero, self.early) = (on, false, false);
    }

    /// The state is a quick stop, or still operation behind an acknowledged "disable": no drive enters these but out of operation, so it had
    /// power all the time since it was told to stop.
    pub(in super::super) fn brakes(&mut self) {
        self.held |= self.early;
    }

    /// A look at the frequency, or without power at the encoder.
    pub(in super::super) fn frequency(&mut self, raw: i64) {
        self.turns = raw != 0;
        if self.turns && self.on == Some(true) {
            self.last = Some(raw);
        }
        match self.on {
            _ if self.turns => {
                self.free |= self.on == Some(false);
                (self.zero, self.early, self.held, self.rested) = (false, false, false, false);
            }
            Some(true) => self.zero = true,
            on => {
                self.early = on.is_none();
                self.rested |= self.free;
            }
        }
    }

    /// What was seen before tells no more: something else is under way.
    pub(in super::super) fn forget(&mut self) {
        *self = Sight { on: self.on, free: self.free, ..Sight::default() };
    }

    /// A stop that goes as a setting says.
    pub(in super::super) fn goes_by_setting(&mut self) {
        self.by_setting = true;
    }

    /// Whether a 0 waits for the look at the state that tells what it is worth.
    pub(in super::super) fn must_look(&self) -> bool {
        (self.zero || self.early) && !self.held
    }

    /// What was seen last of a shaft that was about to stand as its power went; `None` if it was faster than `most`, or was seen
    /// to stand, or to turn without power.
    pub(in super::super) fn crept(&self, most: i64) -> Option<i64> {
        let last = self.last.filter(|last| last.abs() <= most)?;
        (self.on == Some(false) && self.standing().is_none()).then_some(last)
    }

    /// Whether the frequency is on its way to 0, under power.
    pub(in super::super) fn falls(&self) -> bool {
        self.turns && self.on == Some(true)
    }

    pub(in super::super) fn standing(&self) -> Option<bool> {
        if self.turns {
            Some(false)
        } else {
            ((self.held && (self.settled || !self.by_setting)) || self.rested).then_some(true)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A look: at the state, or at the frequency.
    enum Look {
        State(Option<bool>),
        Shows(i64),
        Brakes,
    }
    use Look::{Brakes, Shows, State};
    const ON: Look = State(Some(true));
    const OFF: Look = State(Some(false));
    const UNKNOWN: Look = State(None);

    fn seen(looks: &[Look]) -> Sight {
        let mut sight = Sight::default();
        for look in looks {
            match look {
                State(on) => sight.state(*on),
                Shows(raw) => sight.frequency(*raw),
                Brakes => {
                    sight.brakes();
                    sight.state(Some(true));
                }
            }
        }
        sight
    }

    #[test]
    fn a_frequency_of_0_proves_a_standstill_under_power_only_or_where_it_turned_without() {
        for (looks, stands) in [
            (&[][..], None),
            (&[ON, Shows(5)], Some(false)),
            (&[OFF, Shows(0)], None),
            (&[UNKNOWN, Shows(0)], None),
            // Only the look behind the 0 tells whether it was under power.
            (&[ON, Shows(0)], None),
            (&[ON, Shows(0), ON], Some(true)),
            (&[ON, Shows(0), OFF], None),
            (&[ON, Shows(0), UNKNOWN], None),
            (&[ON, Shows(0), OFF, ON], None),
            (&[ON, Shows(0), ON, Shows(5)], Some(false)),
            (&[ON, Shows(5), OFF, Shows(0)], None),
            (&[OFF, Shows(5)], Some(false)),
            (&[OFF, Shows(5), Shows(0)], Some(true)),
            (&[UNKNOWN, Shows(5), OFF, Shows(0)], None),
            (&[OFF, Shows(5), Shows(0), Shows(-5)], Some(false)),
            // Before any look at the state only a quick stop tells that it had power then.
            (&[Shows(0)], None),
            (&[Shows(0), Brakes], Some(true)),
            (&[Shows(0), ON], None),
            (&[Shows(0), OFF], None),
            (&[Shows(0), OFF, Brakes], None),
            (&[Shows(0), Shows(5), Brakes], Some(false)),
            (&[OFF, Shows(0), Brakes], None),
        ] {
            assert_eq!(seen(looks).standing(), stands);
        }
    }

    #[test]
    fn it_is_known_when_another_look_is_needed() {
        assert!(seen(&[ON, Shows(0)]).must_look());
        assert!(!seen(&[ON, Shows(0), ON]).must_look() && !seen(&[ON, Shows(0), ON, Shows(0)]).must_look());
        assert!(seen(&[Shows(0)]).must_look() && !seen(&[Shows(0), Brakes]).must_look());
        assert!(!seen(&[ON, Shows(5)]).must_look() && !seen(&[OFF, Shows(0)]).must_look());
        assert!(seen(&[ON, Shows(5)]).falls());
        assert!(!seen(&[ON, Shows(0)]).falls() && !seen(&[OFF, Shows(5)]).falls());
    }

    #[test]
    fn a_shaft_that_crept_as_its_power_went_is_told_from_one_that_turned() {
        for (looks, crept) in [
            (&[ON, Shows(2_000), ON, Shows(2), OFF, Shows(0)][..], Some(2)),
            (&[ON, Shows(-2), OFF, Shows(0)], Some(-2)),
            (&[ON, Shows(2), ON, Shows(51), OFF, Shows(0)], None),
            (&[ON, Shows(2)], None),
            (&[ON, Shows(2), ON, Shows(0), ON], None),
            (&[OFF, Shows(2), Shows(0)], None),
            (&[OFF, Shows(0)], None),
            // As slow as that, and no faster.
            (&[ON, Shows(50), OFF, Shows(0)], Some(50)),
            // It turned, and then showed 0: what was last seen of it turning was fast.
            (&[ON, Shows(2_000), ON, Shows(0), OFF, Shows(0)], None),
            // Whether it had power then nobody knows.
            (&[UNKNOWN, Shows(2), OFF, Shows(0)], None),
            // It still has power, and it still turns without.
            (&[ON, Shows(2), ON, Shows(0)], None),
            (&[ON, Shows(2), OFF, Shows(2)], None),
        ] {
            assert_eq!(seen(looks).crept(50), crept);
        }
    }

    #[test]
    fn a_new_movement_forgets_what_the_old_one_showed() {
        let mut held = seen(&[ON, Shows(0), ON]);
        held.forget();
        assert_eq!(held.standing(), None);
        let mut free = seen(&[OFF, Shows(5)]);
        free.forget();
        free.frequency(0);
        assert_eq!(free.standing(), Some(true), "that it shows movement without power is not forgotten");
    }
}
