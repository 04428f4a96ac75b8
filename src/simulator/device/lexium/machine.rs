//! The state machine on DCOMcontrol and DCOMstatus: CiA 402 (sources H), without any short cut to "operation enabled".
//!
//! Choices where the manual is silent:
//! - the control word is a level: what stands in it is obeyed as soon as the state allows; only bit 7 acts on its edge;
//! - the output stage needs 20 ms from "switched on" to "operation enabled", so a master that does not look is too early;
//! - transitions 5 and 8 take the power away and the shaft coasts, as 9 does;
//! - after a quick stop the drive goes to "switch on disabled" as soon as the shaft stands (12);
//! - classes of errors (sources D): 0 is a warning, bit 7; 1 and 2 brake by the quick stop ramp in "fault reaction active"
//!   and end in "fault", because every asynchronous error shows in bit 3 (manual 6.3.2); 3 and 4 take the power away at
//!   once; 4 is reset only by power-off;
//! - a fault can be reset at once; a further error takes no place of the first, but is kept in the memory.

use super::readings::{Reading, Readings};
use crate::simulator::device::cia402::{Command, State};
use crate::simulator::device::contract::Fault;
use crate::tick::{Span, Tick};

/// From "switched on" to "operation enabled".
const STAGE: Span = Span::from_millis(20);

/// What the output stage does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Power {
    Off,
    /// The shaft does what the mode of operation says.
    Drives,
    /// The shaft comes to rest on the quick stop ramp.
    Stops,
    /// The shaft comes to rest on the ramp, and the power goes then.
    Ramps,
}

/// State, and what leads out of it.
#[derive(Clone, Debug)]
pub(crate) struct Automaton {
    state: State,
    word: u16,
    /// End of power-on or of switching the output stage on.
    until: Option<Tick>,
    /// The fault that stands.
    fault: Option<Fault>,
    warning: bool,
    /// Control 7 brakes: the shaft is on its way to rest.
    ramping: bool,
    /// Only disable voltage leads out of the quick stop.
    held: bool,
    readings: Readings,
}

impl Automaton {
    /// A drive that comes up at `up`; never, without power.
    pub(crate) fn new(up: Option<Tick>, readings: Readings) -> Self {
        let (state, word, fault, warning) = (State::NotReady, 0, None, false);
        Automaton { state, word, until: up, fault, warning, ramping: false, held: false, readings }
    }

    pub(crate) fn state(&self) -> State {
        self.state
    }

    /// The control word as it stands.
    pub(crate) fn word(&self) -> u16 {
        self.word
    }

    pub(crate) fn power(&self) -> Power {
        match self.state {
            State::Enabled if self.ramping => Power::Ramps,
            State::Enabled => Power::Drives,
            State::QuickStop | State::FaultReaction => Power::Stops,
            _ => Power::Off,
        }
    }

    pub(crate) fn in_fault(&self) -> bool {
        matches!(self.state, State::FaultReaction | State::Fault)
    }

    /// When the state will change by itself.
    pub(crate) fn next(&self) -> Option<Tick> {
        self.until
    }

    /// Bits 0-7 and 9 of DCOMstatus; bit 4 (voltage) and bit 9 (remote) as CiA 402 has them, with the mains always on.
    pub(crate) fn status(&self) -> u16 {
        let bit = |on: bool, number: u8| u16::from(on) << number;
        let up = self.state != State::NotReady;
        self.state.bits() | bit(up, 4) | bit(self.warning, 7) | bit(up, 9)
    }

    /// A new control word.
    pub(crate) fn command(&mut self, now: Tick, word: u16) {
        let rising = word & !self.word;
        self.word = word;
        let resettable = self.fault.is_none_or(|fault| fault.class < 4);
        if self.state == State::Fault && rising & 0x80 != 0 && resettable {
            self.state = State::SwitchOnInhibit; // 15
            self.fault = None;
        }
        self.warning &= rising & 0x80 == 0;
        self.obey(now);
    }

    /// Lets a millisecond pass that ends `now`; `stands` tells whether the shaft does.
    pub(crate) fn tick(&mut self, now: Tick, stands: bool) {
        match self.state {
            State::NotReady if self.until.is_some_and(|until| until <= now) => self.go(State::SwitchOnInhibit), // 1
            State::SwitchedOn if self.until.is_some_and(|until| until <= now) => self.go(State::Enabled),       // 4
            State::QuickStop if stands && !self.held => self.go(State::SwitchOnInhibit),                        // 12
            State::Enabled if self.ramping && stands => self.go(State::SwitchedOn),                             // 5
            State::FaultReaction if stands => self.go(State::Fault),                                            // 14
            _ => return,
        }
        self.obey(now);
    }

    /// An asynchronous error (13).
    pub(crate) fn fail(&mut self, fault: Fault) {
        if fault.class == 0 {
            self.warning = true;
        } else if !self.in_fault() && self.state != State::NotReady {
            let brakes = fault.class < 3 && self.power() != Power::Off;
            self.fault = Some(fault);
            self.go(if brakes { State::FaultReaction } else { State::Fault });
        }
    }

    /// The reaction to a master that is not heard any more, where it is a quick stop and no fault (11).
    pub(crate) fn quick_stop(&mut self) {
        self.go(State::QuickStop);
        self.held = true;
    }

    fn obey(&mut self, now: Tick) {
        if self.state == State::Enabled && Command::of(self.word) == Command::EnableOperation {
            self.ramping = false;
        }
        if self.state == State::SwitchedOn && Command::of(self.word) != Command::EnableOperation {
            self.until = None; // called back
        }
        // 0x0F leads from "ready" over "switched on" on.
        for _ in 0..3 {
            let Some(next) = self.follows(Command::of(self.word)) else { return };
            if next == State::Enabled {
                self.until = self.until.or(Some(now + STAGE)); // 4
                return;
            }
            if (self.state, next) == (State::Enabled, State::SwitchedOn) && self.readings.has(Reading::Control7Brakes) {
                self.ramping = true;
                return;
            }
            self.go(next);
            self.held = next == State::QuickStop && self.readings.has(Reading::QuickStopStays);
        }
    }

    fn follows(&self, command: Command) -> Option<State> {
        use Command::{DisableVoltage, EnableOperation, QuickStop, ShutDown, SwitchOn};
        Some(match (self.state, command) {
            (State::SwitchOnInhibit, ShutDown) => State::Ready,              // 2
            (State::Ready, SwitchOn | EnableOperation) => State::SwitchedOn, // 3
            (State::SwitchedOn, EnableOperation) => State::Enabled,          // 4
            (State::Enabled, SwitchOn) => State::SwitchedOn,                 // 5
            (State::SwitchedOn | State::Enabled, ShutDown) => State::Ready,  // 6, 8
            (State::Ready | State::SwitchedOn, QuickStop) => State::SwitchOnInhibit, // 7, 10
            (State::Ready | State::SwitchedOn | State::Enabled | State::QuickStop, DisableVoltage) => {
                State::SwitchOnInhibit // 7, 10, 9, 12
            }
            (State::Enabled, QuickStop) => State::QuickStop, // 11
            _ => return None,
        })
    }

    fn go(&mut self, next: State) {
        self.state = next;
        self.until = None;
        self.ramping = false;
        self.held = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NOW: Tick = Tick::from_micros(1_000_000);
    const LATER: Tick = Tick::from_micros(1_020_000);

    /// A drive in operation.
    fn enabled() -> Automaton {
        let mut machine = Automaton::new(Some(Tick::ZERO), Readings::default());
        machine.tick(NOW, true);
        machine.command(NOW, 0x06);
        machine.command(NOW, 0x0F);
        machine.tick(LATER, true);
        assert_eq!(machine.state(), State::Enabled);
        machine
    }

    #[test]
    fn every_transition_of_the_control_word() {
        let walk = |words: &[u16]| {
            let mut machine = enabled();
            words.iter().for_each(|&word| machine.command(LATER, word));
            machine.status() & 0x6F
        };
        for (words, state) in [
            (&[0x07][..], 0x23),
            (&[0x06], 0x21),
            (&[0x00], 0x40),
            (&[0x02], 0x07),
            (&[0x02, 0x00], 0x40),
            (&[0x02, 0x0F], 0x07),
            (&[0x06, 0x00], 0x40),
            (&[0x06, 0x02], 0x40),
            (&[0x07, 0x06], 0x21),
            (&[0x07, 0x02], 0x40),
            (&[0x07, 0x00], 0x40),
            (&[0x00, 0x0F], 0x40),
            (&[0x00, 0x07], 0x40),
            (&[0x00, 0x06, 0x07], 0x23),
        ] {
            assert_eq!(walk(words), state, "{words:02X?}");
        }
    }

    #[test]
    fn the_output_stage_takes_its_time_and_can_be_called_back() {
        let mut machine = Automaton::new(Some(NOW), Readings::default());
        machine.command(NOW, 0x06);
        assert_eq!(machine.status(), 0);
        machine.tick(NOW, true);
        assert_eq!(machine.status(), 0x0231, "the command that stood is obeyed");
        machine.command(NOW, 0x0F);
        machine.tick(Tick::from_micros(1_019_999), true);
        assert_eq!(machine.status() & 0x6F, 0x23);
        machine.command(NOW, 0x07);
        machine.tick(LATER, true);
        assert_eq!(machine.status() & 0x6F, 0x23, "called back");
    }

    #[test]
    fn classes_decide_what_an_error_does_and_what_resets_it() {
        let fault = |class| Fault { number: 7, class, qualifier: 0 };
        for (class, at_once, at_rest, reset) in
            [(0, 0x27, 0x27, 0x27), (1, 0x0F, 0x08, 0x40), (2, 0x0F, 0x08, 0x40), (3, 0x08, 0x08, 0x40), (4, 8, 8, 8)]
        {
            let mut machine = enabled();
            machine.fail(fault(class));
            assert_eq!(machine.status() & 0x6F, at_once, "{class}");
            machine.tick(LATER, true);
            assert_eq!(machine.status() & 0x6F, at_rest, "{class}");
            machine.command(LATER, 0x0F);
            machine.command(LATER, 0x8F);
            assert_eq!(machine.status() & 0x6F, reset, "{class}");
            assert_eq!(machine.status() >> 7 & 1, 0, "{class}");
        }
    }

    #[test]
    fn only_the_edge_of_bit_7_resets_and_a_drive_without_power_has_no_fault() {
        let mut machine = enabled();
        machine.command(LATER, 0x8F);
        machine.fail(Fault { number: 1, class: 3, qualifier: 0 });
        machine.command(LATER, 0x8F);
        assert!(machine.in_fault());
        machine.command(LATER, 0x00);
        machine.command(LATER, 0x80);
        assert!(!machine.in_fault());
        let mut off = Automaton::new(None, Readings::default());
        off.fail(Fault { number: 1, class: 3, qualifier: 0 });
        assert_eq!((off.state(), off.next()), (State::NotReady, None));
    }
}
