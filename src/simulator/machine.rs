//! The state machine of a drive (CM-485 manual 9.1.2 for ACT, 10.2 for ACU; transitions by number: facts H).
//!
//! Choices where the manual is silent or contradicts itself:
//! - status bit 4 of the ACU shows the mains in every state (text of 10.1; its table prints 0 for "switched on");
//! - the commands of the control word are obeyed also without the external enable, but for transition 4, which needs
//!   it; losing enable or start contact while enabled lets the shaft coast and leads to "switched on";
//! - with P.412 above 2 the keypad starts the drive, and nobody presses its keys here: "switched on" it remains;
//! - the fault reaction takes no time; losing the mains while enabled is fault F0702;
//! - after a software reset or power-on a fault is gone.

use super::shaft::{Ramps, Shaft};
use crate::tick::{Span, Tick};

/// A fault cannot be acknowledged earlier (CM-485 manual 9.1.2).
const FAULT_LOCK: Span = Span::from_secs(15);
/// Mains failure (CM-485 manual 12.2).
const MAINS_FAILURE: u16 = 0x0702;

/// States of the drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum State {
    SwitchOnInhibit,
    Ready,
    SwitchedOn,
    Enabled,
    QuickStop,
    Fault,
}

impl State {
    /// Bits 0-6 of the status word (CM-485 manual 9.1.2).
    fn bits(self) -> u16 {
        match self {
            State::SwitchOnInhibit => 0x40,
            State::Ready => 0x21,
            State::SwitchedOn => 0x23,
            State::Enabled => 0x27,
            State::QuickStop => 0x07,
            State::Fault => 0x08,
        }
    }
}

/// Who commands the drive: P.412 (CM-485 manual 9).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Control {
    /// 0: digital inputs; 2: control word in their place.
    Contacts,
    /// 1: control word.
    StateMachine,
    /// Above 2: keypad.
    Keypad,
}

/// What the machine looks at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inputs {
    pub(super) acu: bool,
    pub(super) control: Control,
    pub(super) word: u16,
    pub(super) enable: bool,
    pub(super) right: bool,
    pub(super) left: bool,
    pub(super) mains: bool,
    /// Configuration x40: start contacts have no function (CM-485 manual 10.2).
    pub(super) positioning: bool,
    /// Reference frequency, 0.01 Hz, inside P.419.
    pub(super) goal: i64,
    pub(super) ramps: Ramps,
    pub(super) quick_ramps: Ramps,
    /// P.392: 0 coast, 1 DC brake, 2 ramp.
    pub(super) transition5: i64,
    /// P.637 as a frequency, 0.01 Hz.
    pub(super) threshold: i64,
    /// P.638.
    pub(super) holding: Span,
    /// P.632.
    pub(super) braking: Span,
}

impl Inputs {
    /// The external enable and a start contact are there.
    pub(super) fn released(&self) -> bool {
        self.enable && (self.right || self.left || self.positioning)
    }

    fn may_start(&self) -> bool {
        self.released() && (self.mains || !self.acu)
    }
}

/// A stop that is under way, and when it will be over.
#[derive(Clone, Copy, Debug)]
struct Stop {
    kind: StopKind,
    ends: Tick,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum StopKind {
    Ramp,
    Brake,
    Quick,
}

/// Commands of the control word (CM-485 manual 9.1.2, 10.2).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Command {
    DisableVoltage,
    QuickStop,
    ShutDown,
    SwitchOn,
    EnableOperation,
}

impl Command {
    fn of(word: u16) -> Self {
        match (word & 2 != 0, word & 4 != 0, word & 1 != 0, word & 8 != 0) {
            (false, ..) => Command::DisableVoltage,
            (_, false, ..) => Command::QuickStop,
            (_, _, false, _) => Command::ShutDown,
            (_, _, _, false) => Command::SwitchOn,
            (_, _, _, true) => Command::EnableOperation,
        }
    }
}

/// State machine and shaft.
#[derive(Clone, Debug)]
pub(super) struct Machine {
    pub(super) state: State,
    pub(super) fault: u16,
    fault_at: Tick,
    last_word: u16,
    stop: Option<Stop>,
    pub(super) shaft: Shaft,
}

impl Machine {
    /// After power-on: switch-on inhibit (CM-485 manual 9.1.2).
    pub(super) fn new(at: Tick) -> Self {
        Machine {
            state: State::SwitchOnInhibit,
            fault: 0,
            fault_at: at,
            last_word: 0,
            stop: None,
            shaft: Shaft::new(at),
        }
    }

    /// Whether the output stage works.
    pub(super) fn runs(&self) -> bool {
        matches!(self.state, State::Enabled | State::QuickStop)
    }

    /// When the state will change by itself.
    pub(super) fn next(&self) -> Option<Tick> {
        self.stop.map(|stop| stop.ends)
    }

    /// Lets the time pass with inputs that do not change.
    pub(super) fn settle(&mut self, now: Tick, inputs: &Inputs) {
        // A stop that ends can, by the commands that stand, lead to at most a few further steps.
        for _ in 0..8 {
            let Some(stop) = self.stop.filter(|stop| stop.ends <= now) else { break };
            self.shaft.advance(stop.ends);
            self.stop = None;
            self.state = if stop.kind == StopKind::Quick { State::SwitchOnInhibit } else { State::SwitchedOn };
            self.shaft.coast(stop.ends);
            self.react(stop.ends, inputs);
        }
        self.shaft.advance(now);
    }

    /// Obeys what the inputs say now.
    pub(super) fn react(&mut self, now: Tick, inputs: &Inputs) {
        let rising = inputs.word & !self.last_word;
        if inputs.control == Control::StateMachine {
            // Transition 15: rising edge of bit 7, after the lock.
            if self.state == State::Fault && rising & 0x80 != 0 && now.since(self.fault_at) >= FAULT_LOCK {
                self.state = State::SwitchOnInhibit;
                self.fault = 0;
            }
        }
        self.last_word = inputs.word;
        if self.state == State::Fault {
            return;
        }
        if self.runs() && inputs.acu && !inputs.mains {
            return self.trip(now, MAINS_FAILURE);
        }
        match inputs.control {
            Control::StateMachine => {
                // 0x0F leads from "ready" over "switched on" to "enabled": a few steps at once.
                for _ in 0..4 {
                    if !self.obey(now, Command::of(inputs.word), inputs) {
                        break;
                    }
                }
            }
            Control::Contacts => self.obey_contacts(now, inputs, inputs.released()),
            Control::Keypad => self.obey_contacts(now, inputs, false),
        }
        if self.state == State::Enabled && self.stop.is_none() {
            self.shaft.follow(now, inputs.goal, inputs.ramps);
        }
    }

    /// A fault: transitions 13 and 14. A standing fault keeps its code.
    pub(super) fn trip(&mut self, now: Tick, code: u16) {
        if self.state != State::Fault {
            self.leave(now, State::Fault);
            self.fault = code;
            self.fault_at = now;
        }
    }

    /// Bits 0-6 of the status word, and bits 4, 9, 10, 11 as the drive shows them.
    pub(super) fn status(&self, inputs: &Inputs, reached: bool, limited: bool) -> u16 {
        let bit = |on: bool, number: u8| u16::from(on) << number;
        let remote = match inputs.control {
            Control::StateMachine => inputs.released(),
            Control::Contacts | Control::Keypad => false,
        };
        self.state.bits()
            | bit(inputs.acu && inputs.mains, 4)
            | bit(remote, 9)
            | bit(self.state == State::Enabled && self.stop.is_none() && reached, 10)
            | bit(self.state == State::Enabled && limited, 11)
    }

    /// One transition of the control word; tells whether there was one.
    fn obey(&mut self, now: Tick, command: Command, inputs: &Inputs) -> bool {
        use Command::{DisableVoltage, EnableOperation, QuickStop, ShutDown, SwitchOn};
        let braking = self.stop.is_some_and(|stop| stop.kind == StopKind::Brake);
        if self.runs() && !inputs.released() {
            self.leave(now, State::SwitchedOn);
            return true;
        }
        if braking {
            return false; // CM-485 manual 9.1.2.2: no new control word before the brake is done
        }
        let mains = inputs.mains || !inputs.acu;
        let next = match (self.state, command) {
            (State::SwitchOnInhibit, ShutDown) => State::Ready, // 2
            (State::SwitchOnInhibit, EnableOperation) if inputs.may_start() && !inputs.positioning => State::Enabled, // 4'
            (State::Ready, SwitchOn | EnableOperation) if mains => State::SwitchedOn, // 3
            (State::SwitchedOn, EnableOperation) if inputs.may_start() => State::Enabled, // 4
            (State::SwitchedOn | State::Enabled, ShutDown) => State::Ready,           // 6, 8
            (State::Ready | State::SwitchedOn | State::Enabled | State::QuickStop, DisableVoltage) => {
                State::SwitchOnInhibit // 7, 9, 10, 12
            }
            // Only the table of the ACU names 7 and 10 beside the quick stop.
            (State::Ready | State::SwitchedOn, QuickStop) if inputs.acu => State::SwitchOnInhibit,
            (State::Enabled, QuickStop) => {
                self.shaft.follow(now, 0, inputs.quick_ramps);
                self.begin_stop(StopKind::Quick, inputs);
                self.state = State::QuickStop; // 11
                return true;
            }
            (State::Enabled, SwitchOn) if self.stop.is_none() => return self.transition_5(now, inputs),
            (State::Enabled, EnableOperation) => {
                self.stop = None; // the ramp of transition 5 can be called back
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
                self.shaft.coast(now);
                self.stop = Some(Stop { kind: StopKind::Brake, ends: now + inputs.braking });
            }
            _ => {
                self.shaft.follow(now, 0, inputs.ramps);
                self.begin_stop(StopKind::Ramp, inputs);
            }
        }
        true
    }

    /// Under contacts only "switched on", "enabled" and "fault" are shown (CM-485 manual 9.1.1).
    fn obey_contacts(&mut self, now: Tick, inputs: &Inputs, run: bool) {
        let run = run && inputs.may_start();
        match self.state {
            State::Enabled if run => self.stop = None,
            State::Enabled if inputs.enable && inputs.control == Control::Contacts => {
                if self.stop.is_none() {
                    self.shaft.follow(now, 0, inputs.ramps);
                    self.begin_stop(StopKind::Ramp, inputs);
                }
            }
            _ if run => {
                self.state = State::Enabled;
                self.stop = None;
            }
            State::SwitchedOn => {}
            _ => self.leave(now, State::SwitchedOn),
        }
    }

    fn begin_stop(&mut self, kind: StopKind, inputs: &Inputs) {
        self.stop = Some(Stop { kind, ends: self.shaft.falls_to(inputs.threshold) + inputs.holding });
    }

    /// Goes to a state, with the output stage off in all but "enabled".
    fn leave(&mut self, now: Tick, next: State) {
        self.stop = None;
        self.state = next;
        if next != State::Enabled {
            self.shaft.coast(now);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAMP: Ramps = Ramps::all(500);

    fn inputs(acu: bool, word: u16) -> Inputs {
        Inputs {
            acu,
            control: Control::StateMachine,
            word,
            enable: true,
            right: true,
            left: false,
            mains: true,
            positioning: false,
            goal: 1_000,
            ramps: RAMP,
            quick_ramps: Ramps::all(1_000),
            transition5: 2,
            threshold: 50,
            holding: Span::from_secs(1),
            braking: Span::from_secs(3),
        }
    }

    /// Goes through control words, one a second, and returns bits 0-6 after each.
    fn walk(acu: bool, words: &[u16]) -> Vec<u16> {
        let mut machine = Machine::new(Tick::ZERO);
        let mut states = Vec::new();
        for (second, &word) in (0..).zip(words) {
            let now = Tick::ZERO + Span::from_secs(second);
            machine.react(now, &inputs(acu, word));
            states.push(machine.state.bits());
        }
        states
    }

    #[test]
    fn the_long_way_and_the_short_cut() {
        assert_eq!(walk(false, &[0, 6, 7, 0xF, 0]), [0x40, 0x21, 0x23, 0x27, 0x40]);
        assert_eq!(walk(true, &[0xF, 6, 0xF, 6]), [0x27, 0x21, 0x27, 0x21]);
        assert_eq!(walk(false, &[7]), [0x40]);
        assert_eq!(walk(true, &[6, 2]), [0x21, 0x40]);
        assert_eq!(walk(false, &[6, 2]), [0x21, 0x21]);
    }

    #[test]
    fn quick_stop_ends_in_switch_on_inhibit_after_the_holding_time() {
        let mut machine = Machine::new(Tick::ZERO);
        machine.react(Tick::ZERO, &inputs(true, 0xF));
        let at = Tick::ZERO + Span::from_secs(2);
        machine.settle(at, &inputs(true, 0xF));
        machine.react(at, &inputs(true, 2));
        assert_eq!(machine.state, State::QuickStop);
        // 10.00 Hz down to 0.50 Hz with 10.00 Hz/s, then 1 s.
        assert_eq!(machine.next(), Some(at + Span::from_millis(1_950)));
        machine.settle(at + Span::from_millis(1_950), &inputs(true, 2));
        assert_eq!((machine.state, machine.shaft.powered()), (State::SwitchOnInhibit, false));
    }

    #[test]
    fn the_ramp_of_transition_5_can_be_called_back() {
        let mut machine = Machine::new(Tick::ZERO);
        machine.react(Tick::ZERO, &inputs(true, 0xF));
        let second = |count| Tick::ZERO + Span::from_secs(count);
        machine.settle(second(2), &inputs(true, 0xF));
        machine.react(second(2), &inputs(true, 7));
        assert_eq!(machine.state, State::Enabled);
        machine.settle(second(3), &inputs(true, 7));
        assert_eq!(machine.shaft.speed(), 500);
        machine.react(second(3), &inputs(true, 0xF));
        machine.settle(second(4), &inputs(true, 0xF));
        assert_eq!((machine.state, machine.shaft.speed()), (State::Enabled, 1_000));
    }

    #[test]
    fn without_enable_or_mains_nothing_starts() {
        let mut machine = Machine::new(Tick::ZERO);
        machine.react(Tick::ZERO, &Inputs { enable: false, ..inputs(false, 0xF) });
        assert_eq!(machine.state, State::SwitchOnInhibit);
        machine.react(Tick::ZERO, &Inputs { mains: false, ..inputs(true, 6) });
        machine.react(Tick::ZERO, &Inputs { mains: false, ..inputs(true, 7) });
        assert_eq!(machine.state, State::Ready);
    }

    #[test]
    fn losing_the_enable_coasts_to_switched_on() {
        let mut machine = Machine::new(Tick::ZERO);
        machine.react(Tick::ZERO, &inputs(true, 0xF));
        machine.react(Tick::from_micros(9), &Inputs { enable: false, ..inputs(true, 0xF) });
        assert_eq!((machine.state, machine.shaft.powered()), (State::SwitchedOn, false));
    }

    #[test]
    fn a_fault_is_locked_for_15_seconds_and_needs_an_edge() {
        let mut machine = Machine::new(Tick::ZERO);
        machine.trip(Tick::ZERO, 0x0500);
        let at = |millis| Tick::ZERO + Span::from_millis(millis);
        machine.react(at(14_999), &inputs(true, 0x80));
        machine.react(at(16_000), &inputs(true, 0x80));
        assert_eq!((machine.state, machine.fault), (State::Fault, 0x0500));
        machine.react(at(16_001), &inputs(true, 0));
        machine.react(at(16_002), &inputs(true, 0x80));
        assert_eq!((machine.state, machine.fault), (State::SwitchOnInhibit, 0));
    }

    #[test]
    fn contacts_show_three_states_only() {
        let mut machine = Machine::new(Tick::ZERO);
        let contacts = Inputs { control: Control::Contacts, ..inputs(false, 0) };
        machine.react(Tick::ZERO, &contacts);
        assert_eq!(machine.state, State::Enabled);
        machine.react(Tick::ZERO + Span::from_secs(1), &Inputs { right: false, ..contacts });
        machine.settle(Tick::ZERO + Span::from_secs(60), &Inputs { right: false, ..contacts });
        assert_eq!(machine.state, State::SwitchedOn);
        machine.react(Tick::ZERO, &Inputs { control: Control::Keypad, ..contacts });
        assert_eq!(machine.state, State::SwitchedOn);
    }
}
