//! The search for the offset of a resolver (EM-RES-03 manual 6.4.1), without a line: what was seen of the shaft, and what is tried next.
//!
//! Offsets are those of P.382, in 0.1°. Frequencies are in one unit, whichever. Bounds that the manual does not print are ours.

/// Offsets that repeat: 360° through the ratio of the pole pairs, in 0.1°.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turn(f64);

impl Turn {
    /// By the pole pairs of the motor and of the resolver, which divide them.
    pub(super) fn of(motor_pairs: i64, resolver_pairs: i64) -> Self {
        Turn(3_600.0 * resolver_pairs.max(1) as f64 / motor_pairs.max(1) as f64)
    }

    /// A part of it.
    pub(super) fn part(self, of: f64) -> i64 {
        (self.0 / of).round() as i64
    }

    /// The same offset, from 0 on.
    pub(super) fn wrap(self, offset: i64) -> i64 {
        (offset as f64).rem_euclid(self.0).round() as i64
    }
}

/// What a try has come to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Seen {
    /// It does not turn, or only into another place.
    Stands,
    /// It is faster than it may be, or turns against its setpoint.
    RunsAway,
    /// It turns as it is told, and this is the offset, and P.235 there.
    Found(i64, i64),
    /// It turned, but P.235 did not come to 0.
    Unsettled,
}

/// What comes next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Next {
    /// Another try, at the offset of the search.
    Try,
    /// Two phases of the motor are to be exchanged, then another try.
    ExchangePhases,
    /// It is found.
    Found(i64, i64),
    /// There is nothing more to try.
    GiveUp,
}

/// Try by try.
#[derive(Clone, Copy, Debug)]
pub(super) struct Search {
    pub(super) offset: i64,
    turn: Turn,
    stood: u8,
    raced: u8,
}

impl Search {
    /// Longest way: stands, phases, stands, 90°, stands, phases, races, 180°, turns.
    pub(super) const TRIES: u8 = 6;

    pub(super) fn new(offset: i64, turn: Turn) -> Self {
        Search { offset: turn.wrap(offset), turn, stood: 0, raced: 0 }
    }

    /// What comes behind a try.
    pub(super) fn after(&mut self, seen: Seen) -> Next {
        match seen {
            Seen::Found(offset, voltage) => Next::Found(offset, voltage),
            Seen::Unsettled => Next::GiveUp,
            Seen::RunsAway => {
                self.raced += 1;
                self.offset = self.turn.wrap(self.offset + self.turn.part(2.0));
                if self.raced > 1 { Next::GiveUp } else { Next::Try }
            }
            Seen::Stands => {
                self.stood += 1;
                match self.stood {
                    1 | 3 => Next::ExchangePhases,
                    2 => {
                        self.offset = self.turn.wrap(self.offset + self.turn.part(4.0));
                        Next::Try
                    }
                    _ => Next::GiveUp,
                }
            }
        }
    }
}

/// P.235 on its way to 0: up where it is positive, down where it is negative, in steps that become smaller each time it changes.
#[derive(Clone, Copy, Debug)]
struct Descent {
    turn: Turn,
    at: i64,
    step: i64,
    sign: i64,
    /// The smallest voltage so far, and where.
    best: (i64, i64),
    left: u8,
}

/// Where a descent leads.
enum Way {
    On,
    Done,
    Lost,
}

impl Descent {
    fn see(&mut self, voltage: i64) -> Way {
        if voltage.abs() < self.best.0.abs() {
            self.best = (voltage, self.at);
        }
        let turned = self.sign * voltage.signum() < 0;
        if voltage == 0 || (turned && self.step == 1) {
            return Way::Done;
        }
        if self.left == 0 {
            return Way::Lost;
        }
        if turned {
            self.step = (self.step / 2).max(1);
        }
        (self.left, self.sign) = (self.left - 1, voltage.signum());
        self.at = self.turn.wrap(self.at + self.sign * self.step);
        Way::On
    }
}

/// What a look shows: the frequency that is put out, that of the resolver, P.235.
#[derive(Clone, Copy, Debug)]
pub(super) struct Look {
    pub(super) stator: i64,
    pub(super) resolver: i64,
    pub(super) voltage: i64,
}

/// One try, look by look.
#[derive(Clone, Copy, Debug)]
pub(super) struct Trial {
    /// What it is told, and how fast it may become.
    setpoint: i64,
    limit: i64,
    /// How long it may take to come up, in microseconds.
    patience: u64,
    descent: Descent,
    turns: bool,
    /// Looks since the offset changed; those that were told the same thing twice.
    settling: u8,
    odd: u8,
    even: u8,
}

/// Steps of the offset in one try.
pub(super) const STEPS: u8 = 40;
/// A look right behind a change tells of before.
const SETTLES: u8 = 2;
/// What is seen once may be the way into another place.
const TWICE: u8 = 2;

impl Trial {
    /// The first try of a place: with large steps.
    pub(super) fn coarse(offset: i64, turn: Turn, (setpoint, limit): (i64, i64), patience: u64) -> Self {
        Self::new(offset, turn, (setpoint, limit), (patience, turn.part(16.0)))
    }

    /// A place that is known: with small ones, of 2.5° at one pair of poles.
    pub(super) fn fine(offset: i64, turn: Turn, (setpoint, limit): (i64, i64), patience: u64) -> Self {
        Self::new(offset, turn, (setpoint, limit), (patience, turn.part(144.0)))
    }

    fn new(offset: i64, turn: Turn, (setpoint, limit): (i64, i64), (patience, step): (u64, i64)) -> Self {
        let best = (i64::MAX, offset);
        let descent = Descent { turn, at: offset, step: step.max(1), sign: 0, best, left: STEPS };
        Trial { setpoint, limit, patience, descent, turns: false, settling: 0, odd: 0, even: 0 }
    }

    /// Where the offset must be now.
    pub(super) fn offset(&self) -> i64 {
        self.descent.at
    }

    /// Takes a look, so long after the setpoint was given; tells what the try has come to, once it has.
    pub(super) fn see(&mut self, gone_us: u64, look: Look) -> Option<Seen> {
        let Trial { setpoint, limit, .. } = *self;
        let against = |frequency: i64| frequency * setpoint < 0 && frequency.abs() * 4 > setpoint.abs();
        if look.stator.abs() > limit || look.resolver.abs() > limit {
            return Some(Seen::RunsAway);
        }
        self.odd = if against(look.stator) || against(look.resolver) { self.odd + 1 } else { 0 };
        if self.odd >= TWICE {
            return Some(Seen::RunsAway);
        }
        // How the frequency of the resolver counts its own pairs of poles is in no source.
        let follows = look.resolver * setpoint.signum() * 16 >= setpoint.abs();
        let is_near = (look.stator - setpoint).abs() * 10 <= setpoint.abs() && follows;
        if !self.turns {
            self.even = if is_near { self.even + 1 } else { 0 };
            self.turns = self.even >= TWICE;
            return (!self.turns && gone_us >= self.patience).then_some(Seen::Stands);
        }
        if !is_near {
            self.even = self.even.saturating_sub(1);
            return (self.even == 0).then_some(Seen::Unsettled);
        }
        self.even = TWICE;
        self.settling += 1;
        if self.settling < SETTLES {
            return None;
        }
        self.settling = 0;
        let (voltage, offset) = match self.descent.see(look.voltage) {
            Way::On => return None,
            Way::Lost => return Some(Seen::Unsettled),
            Way::Done => self.descent.best,
        };
        Some(Seen::Found(offset, voltage))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The motor of the manual: torque by the cosine of the error, P.235 by its sine.
    fn tried(truth: i64, ratio: f64, swapped: bool, trial: &mut Trial) -> Seen {
        for nth in 0..400u64 {
            let error = ((trial.offset() - truth) as f64 / 10.0 * ratio).to_radians();
            let speed = match error.cos() {
                _ if swapped => 0,
                torque if torque > 0.2 => 450,
                torque if torque < -0.2 => -(nth as i64) * 100,
                _ => 0,
            };
            let voltage = (-error.sin() * speed as f64).round() as i64;
            let look = Look { stator: speed, resolver: speed, voltage };
            if let Some(seen) = trial.see(nth * 250_000, look) {
                return seen;
            }
        }
        unreachable!("a try has an end")
    }

    #[test]
    fn it_is_found_from_any_offset_with_any_pole_pairs_and_the_phases_either_way() {
        for (motor, resolver) in [(1, 1), (2, 1), (3, 1), (3, 3), (4, 2), (6, 3), (7, 1)] {
            let turn = Turn::of(motor, resolver);
            for (truth, wrong) in (0..3_600).step_by(37).flat_map(|truth| [(truth, false), (truth, true)]) {
                let (mut search, mut swapped, mut tries) = (Search::new(0, turn), wrong, 0);
                let found = loop {
                    tries += 1;
                    let mut trial = Trial::coarse(search.offset, turn, (450, 500), 10_000_000);
                    let seen = tried(truth, motor as f64 / resolver as f64, swapped, &mut trial);
                    match search.after(seen) {
                        Next::Try => {}
                        Next::ExchangePhases => swapped = !swapped,
                        Next::Found(offset, _) => break offset,
                        Next::GiveUp => unreachable!("{motor}:{resolver} {truth} {wrong}"),
                    }
                };
                assert!(tries <= Search::TRIES, "{tries}");
                let off = turn.wrap(found - truth + turn.part(2.0)) - turn.part(2.0);
                assert!(off.abs() <= 2, "{motor}:{resolver} at {truth}: {found}");
                assert!((0..=turn.part(1.0)).contains(&found), "{found}");
            }
        }
    }

    #[test]
    fn what_leads_nowhere_ends() {
        let mut search = Search::new(0, Turn::of(3, 1));
        let all = [Seen::Stands; 4].map(|seen| search.after(seen));
        assert_eq!(all, [Next::ExchangePhases, Next::Try, Next::ExchangePhases, Next::GiveUp]);
        let mut search = Search::new(0, Turn::of(3, 1));
        assert_eq!([Seen::RunsAway; 2].map(|seen| search.after(seen)), [Next::Try, Next::GiveUp]);
        assert_eq!(Search::new(0, Turn::of(3, 1)).after(Seen::Unsettled), Next::GiveUp);
    }

    #[test]
    fn too_fast_is_seen_at_once_and_the_wrong_way_at_the_second_look() {
        let trial = || Trial::coarse(0, Turn::of(3, 1), (450, 500), 10_000_000);
        let look = |speed| Look { stator: speed, resolver: speed, voltage: 9 };
        assert_eq!(trial().see(0, look(501)), Some(Seen::RunsAway));
        assert_eq!(trial().see(0, look(-501)), Some(Seen::RunsAway));
        assert_eq!(trial().see(0, Look { stator: 0, ..look(501) }), Some(Seen::RunsAway));
        let mut twice = trial();
        assert_eq!([0, 1].map(|us| twice.see(us, look(-200))), [None, Some(Seen::RunsAway)]);
        let mut twitch = trial();
        assert_eq!([-200, 0, -200, 0].map(|speed| twitch.see(0, look(speed))), [None; 4]);
        assert_eq!(trial().see(10_000_000, look(0)), Some(Seen::Stands));
    }
}
