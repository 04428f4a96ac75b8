//! The state machine of a drive (CM-485 manual 9.1.2 for ACT, 10.2 for ACU; transitions by number: sources H).
//!
//! Choices where the manual is silent or contradicts itself:
//! - status bit 4 of the ACU shows the mains in every state (text of 10.1; its table prints 0 for "switched on");
//! - transition 4 needs the external enable and a start contact; the other commands do without them, unless the bench
//!   file says `strict_remote`: 9.1.2 and 10.2 write once that only transition 4 needs them, and once that without the
//!   Remote bit the control word does nothing at all;
//! - losing enable or start contact while enabled lets the shaft coast and leads to "switched on"; in a quick stop it
//!   ends the quick stop (12);
//! - the control word is a level: what stands in it is obeyed as soon as the state allows, also at the end of a ramp, of
//!   DC braking, of a quick stop, of a reset, or when the enable comes back. Only bit 7 acts on its edge. So 0x8F
//!   acknowledges and starts in one go, as the table of commands has it (bits 3 to 0 are "any");
//! - in a quick stop nothing is obeyed but "disable voltage" (12);
//! - a braking time P.632 of 0 brakes for no time at all;
//! - the rules of transition 5 and quick stop hold in positioning configurations too, for which 10.2 leaves them open;
//! - under contacts a missing start contact stops by the ramp, a missing enable lets the shaft coast; start contacts for
//!   both directions mean clockwise; a fault can be acknowledged only under the state machine;
//! - with P.412 above 2 the keypad starts the drive, and nobody presses its keys here: "switched on" it remains; or, as
//!   another reading has it, the contacts do;
//! - a fault switches the output stage off at once, so the shaft coasts. If it worked, "fault reaction active" is shown
//!   for 0.1 s, in which the drive already tells the fault; else there is nothing to react with, and no time passes. A
//!   further fault does not take the place of the first;
//! - losing the mains while the output stage works is fault F0702; in the other states nothing happens but bit 4;
//! - after a software reset or power-on a fault is gone, and "not ready" lasts as long as the drive is off the bus.

use super::resolver::{FASTEST, Follows, RACES};
use crate::simulator::device::cia402::{Command, State};
use crate::simulator::device::motor::Motor;
use crate::simulator::device::shaft::{Ramps, Shaft};
use crate::tick::{Span, Tick};

#[cfg(test)]
mod tests;

/// A fault cannot be acknowledged earlier (CM-485 manual 9.1.2).
const FAULT_LOCK: Span = Span::from_secs(15);
/// How long "fault reaction active" is shown: a bench value.
const REACTION: Span = Span::from_millis(100);
/// Mains failure (CM-485 manual 12.2).
const MAINS_FAILURE: u16 = 0x0702;

/// Who commands the drive: P.412 (CM-485 manual 9).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Control {
    /// 0: digital inputs; 2: control word in their place.
    Contacts,
    /// 1: control word.
    StateMachine,
    /// Above 2: keypad.
    Keypad,
}

/// What the machine looks at.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Inputs {
    pub(crate) acu: bool,
    pub(crate) control: Control,
    pub(crate) word: u16,
    pub(crate) enable: bool,
    pub(crate) right: bool,
    pub(crate) left: bool,
    pub(crate) mains: bool,
    /// Configuration x40: start contacts have no function, and there is no short cut (CM-485 manual 10.2).
    pub(crate) positioning: bool,
    /// Without the Remote bit no command is obeyed.
    pub(crate) strict_remote: bool,
    /// Only a control word that is written is obeyed, not one that stands.
    pub(crate) edge: bool,
    /// A fault is acknowledged only with the Remote bit.
    pub(crate) reset_needs_remote: bool,
    /// Reference frequency, 0.01 Hz, inside P.419.
    pub(crate) goal: i64,
    pub(crate) ramps: Ramps,
    pub(crate) quick_ramps: Ramps,
    /// P.392: 0 coast, 1 DC brake, 2 ramp.
    pub(crate) transition5: i64,
    /// P.637 as a frequency, 0.01 Hz.
    pub(crate) threshold: i64,
    /// P.638.
    pub(crate) holding: Span,
    /// P.632.
    pub(crate) braking: Span,
    pub(crate) motor: Motor,
    /// How the rotor follows.
    pub(crate) follows: Follows,
}

impl Inputs {
    fn started(&self) -> bool {
        self.enable && (self.right || self.left)
    }

    /// The external enable and a start contact are there.
    pub(crate) fn released(&self) -> bool {
        self.started() || (self.enable && self.positioning)
    }

    fn voltage(&self) -> bool {
        self.mains || !self.acu
    }
}

/// Something under way that will end by itself.
#[derive(Clone, Copy, Debug)]
struct Phase {
    kind: Kind,
    ends: Tick,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    /// Coming up after power-on.
    Boot,
    /// Ramp of transition 5, or of a missing start contact.
    Ramp,
    /// DC braking of transition 5.
    Brake,
    /// Quick stop.
    Quick,
    /// Reaction to a fault.
    Reaction,
}

/// State machine and shaft.
#[derive(Clone, Debug)]
pub(crate) struct Automaton {
    pub(crate) state: State,
    pub(crate) fault: u16,
    fault_at: Tick,
    last_word: u16,
    /// The control word was written and not yet looked at.
    pub(crate) fresh: bool,
    phase: Option<Phase>,
    pub(crate) shaft: Shaft,
}

impl Automaton {
    /// A drive without power, with its shaft at rest.
    pub(crate) fn new(at: Tick) -> Self {
        let shaft = Shaft::new(at);
        Automaton { state: State::NotReady, fault: 0, fault_at: at, last_word: 0, fresh: false, phase: None, shaft }
    }

    /// Power-on or reset (0): "not ready" until the drive is up (1). Never up, if the power is gone for good. A shaft
    /// that turns coasts on.
    pub(crate) fn restart(&mut self, now: Tick, up: Option<Tick>) {
        self.leave(now, State::NotReady);
        self.phase = up.map(|ends| Phase { kind: Kind::Boot, ends });
        (self.fault, self.last_word) = (0, 0);
    }

    /// Whether the output stage works.
    pub(crate) fn runs(&self) -> bool {
        matches!(self.state, State::Enabled | State::QuickStop)
    }

    /// Whether a fault stands.
    pub(crate) fn in_fault(&self) -> bool {
        matches!(self.state, State::FaultReaction | State::Fault)
    }

    /// When the state will change by itself.
    pub(crate) fn next(&self) -> Option<Tick> {
        self.phase.map(|phase| phase.ends)
    }

    /// Lets the time pass with inputs that do not change.
    pub(crate) fn settle(&mut self, now: Tick, inputs: &Inputs) {
        // What ends can, by the commands that stand, lead to at most a few further steps.
        for _ in 0..8 {
            let Some(phase) = self.phase.filter(|phase| phase.ends <= now) else { break };
            self.shaft.advance(phase.ends);
            let next = match phase.kind {
                Kind::Boot => State::SwitchOnInhibit,          // 1
                Kind::Ramp | Kind::Brake => State::SwitchedOn, // 5
                Kind::Quick => State::SwitchOnInhibit,         // 12
                Kind::Reaction => State::Fault,                // 14
            };
            self.leave(phase.ends, next);
            self.react(phase.ends, inputs);
        }
        self.shaft.advance(now);
    }

    /// Obeys what the inputs say now.
    pub(crate) fn react(&mut self, now: Tick, inputs: &Inputs) {
        let rising = inputs.word & !self.last_word;
        self.last_word = inputs.word;
        self.shaft.advance(now);
        self.shaft.fit(inputs.motor);
        let fresh = std::mem::take(&mut self.fresh) || !inputs.edge;
        let commanded = inputs.control == Control::StateMachine && (inputs.released() || !inputs.strict_remote);
        let acknowledged = commanded && (inputs.released() || !inputs.reset_needs_remote);
        // Transition 15: rising edge of bit 7, after the lock.
        if self.state == State::Fault && acknowledged && rising & 0x80 != 0 && now.since(self.fault_at) >= FAULT_LOCK {
            self.state = State::SwitchOnInhibit;
            self.fault = 0;
        }
        if self.in_fault() || self.state == State::NotReady {
            return;
        }
        if self.runs() && !inputs.voltage() {
            return self.trip(now, MAINS_FAILURE);
        }
        match inputs.control {
            Control::StateMachine => self.obey(now, inputs, commanded && fresh),
            Control::Contacts => self.obey_contacts(now, inputs, inputs.started() && inputs.voltage()),
            Control::Keypad => self.obey_contacts(now, inputs, false),
        }
        if self.state == State::Enabled && self.phase.is_none() {
            let goal = if inputs.motor.overloaded() { 0 } else { inputs.goal };
            self.lead(now, goal, inputs.ramps, inputs);
        }
    }

    /// A fault: transition 13, and 14 at once if nothing is on. A standing fault keeps its code, and what is off has none.
    pub(crate) fn trip(&mut self, now: Tick, code: u16) {
        if self.in_fault() || (self.state == State::NotReady && self.phase.is_none()) {
            return;
        }
        match self.runs() {
            true => {
                self.leave(now, State::FaultReaction);
                self.phase = Some(Phase { kind: Kind::Reaction, ends: now + REACTION });
            }
            false => self.leave(now, State::Fault),
        }
        (self.fault, self.fault_at) = (code, now);
    }

    /// Bits 0-6 of the status word, and bits 4, 9, 10, 11 as the drive shows them.
    pub(crate) fn status(&self, inputs: &Inputs, reached: bool, limited: bool) -> u16 {
        let bit = |on: bool, number: u8| u16::from(on) << number;
        let remote = inputs.control == Control::StateMachine && inputs.released();
        self.state.bits()
            | bit(inputs.acu && inputs.mains, 4)
            | bit(remote, 9)
            | bit(self.state == State::Enabled && self.phase.is_none() && reached, 10)
            | bit(self.state == State::Enabled && limited, 11)
    }

    fn obey(&mut self, now: Tick, inputs: &Inputs, commanded: bool) {
        match self.state {
            State::Enabled if !inputs.released() => self.leave(now, State::SwitchedOn),
            State::QuickStop if !inputs.released() => self.leave(now, State::SwitchOnInhibit),
            _ => {}
        }
        // 0x0F leads from "ready" over "switched on" to "enabled": a few steps at once.
        for _ in 0..4 {
            if !commanded || !self.step(now, Command::of(inputs.word), inputs) {
                break;
            }
        }
    }

    /// One transition of the control word; tells whether there was one.
    fn step(&mut self, now: Tick, command: Command, inputs: &Inputs) -> bool {
        use Command::{DisableVoltage, EnableOperation, QuickStop, ShutDown, SwitchOn};
        if self.phase.is_some_and(|phase| phase.kind == Kind::Brake) {
            return false; // CM-485 manual 9.1.2.2: no new control word before the brake is done
        }
        let may_start = inputs.released() && inputs.voltage();
        let next = match (self.state, command) {
            (State::SwitchOnInhibit, ShutDown) => State::Ready, // 2
            (State::SwitchOnInhibit, EnableOperation) if may_start && !inputs.positioning => State::Enabled, // 4'
            (State::Ready, SwitchOn | EnableOperation) if inputs.voltage() => State::SwitchedOn, // 3
            (State::SwitchedOn, EnableOperation) if may_start => State::Enabled, // 4
            (State::SwitchedOn | State::Enabled, ShutDown) => State::Ready, // 6, 8
            (State::Ready | State::SwitchedOn | State::Enabled | State::QuickStop, DisableVoltage) => {
                State::SwitchOnInhibit // 7, 9, 10, 12
            }
            // Only the table of the ACU names 7 and 10 beside the quick stop.
            (State::Ready | State::SwitchedOn, QuickStop) if inputs.acu => State::SwitchOnInhibit,
            (State::Enabled, QuickStop) => {
                self.lead(now, 0, inputs.quick_ramps, inputs);
                self.slow_down(Kind::Quick, inputs);
                self.state = State::QuickStop; // 11
                return true;
            }
            (State::Enabled, SwitchOn) if self.phase.is_none() => return self.transition_5(now, inputs),
            (State::Enabled, EnableOperation) => {
                self.phase = None; // the ramp of transition 5 can be called back
                return false;
            }
            _ => return false,
        };
        self.leave(now, next);
        true
    }

    fn transition_5(&mut self, now: Tick, inputs: &Inputs) -> bool {
        match inputs.transition5 {
            0 => self.leave(now, State::SwitchedOn),
            1 => {
                self.shaft.brake(now);
                self.phase = Some(Phase { kind: Kind::Brake, ends: now + inputs.braking });
            }
            _ => {
                self.lead(now, 0, inputs.ramps, inputs);
                self.slow_down(Kind::Ramp, inputs);
            }
        }
        true
    }

    /// Under contacts only "switched on", "enabled" and the fault are shown (CM-485 manual 9.1.1).
    fn obey_contacts(&mut self, now: Tick, inputs: &Inputs, run: bool) {
        match self.state {
            State::Enabled if run => self.phase = None,
            State::Enabled if inputs.enable && inputs.control == Control::Contacts => {
                if self.phase.is_none() {
                    self.lead(now, 0, inputs.ramps, inputs);
                    self.slow_down(Kind::Ramp, inputs);
                }
            }
            _ if run => {
                self.state = State::Enabled;
                self.phase = None;
            }
            State::SwitchedOn => {}
            _ => self.leave(now, State::SwitchedOn),
        }
    }

    /// Gives the rotor a goal, which it follows as its resolver lets it.
    fn lead(&mut self, now: Tick, goal: i64, ramps: Ramps, inputs: &Inputs) {
        self.shaft.advance(now);
        let speed = self.shaft.speed();
        match inputs.follows {
            Follows::Setpoint => self.shaft.follow(now, goal, ramps),
            Follows::Nothing => self.shaft.follow(now, 0, ramps),
            // The speed controller corrects the wrong way round, so every difference grows.
            Follows::Itself => {
                let away = match (speed - goal).signum() {
                    0 => speed.signum(),
                    away => away,
                };
                self.shaft.follow(now, away * FASTEST, Ramps::all(RACES));
            }
        }
    }

    /// Below P.637 the holding time P.638 runs; only then the output stage is switched off (CM-485 manual 9.1.2.1,
    /// 9.1.2.2).
    fn slow_down(&mut self, kind: Kind, inputs: &Inputs) {
        self.phase = Some(Phase { kind, ends: self.shaft.falls_to(inputs.threshold) + inputs.holding });
    }

    /// What hangs at the shaft keeps it from becoming slower, or lets it go: a ramp that is under way ends later, or never.
    pub(crate) fn drag(&mut self, on: bool, inputs: &Inputs) {
        self.shaft.drag(on);
        if let Some(phase) = self.phase.filter(|phase| matches!(phase.kind, Kind::Ramp | Kind::Quick)) {
            self.slow_down(phase.kind, inputs);
        }
    }

    /// Goes to a state, with the output stage off in all but "enabled".
    fn leave(&mut self, now: Tick, next: State) {
        self.phase = None;
        self.state = next;
        if next != State::Enabled {
            self.shaft.coast(now);
        }
    }
}
