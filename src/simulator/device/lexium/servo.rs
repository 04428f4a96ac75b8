//! A Lexium LXM05 behind the line: parameters, errors, time (LXM05 manual V1.04, chapters 4 to 6).
//!
//! Choices where the manual is silent:
//! - settings of the line (4.1) act from power-on; the manual says so of MBbaud and MBformat, and nothing of the others;
//! - power-on takes 3 s; the electronics have their own supply, so nothing here looks at the mains;
//! - the node guard counts from the write of MBnode_guard on, then from the last telegram to this station with a right
//!   check value; it acts only in "operation enabled", as an error of class 1;
//! - the fault memory shows the newest entry; FLT_Time counts seconds since the bench was built; the memory outlives the
//!   power;
//! - error numbers below 1000h are this bench's own: the list of the maker (E1xxx to ECxxx) is in no source.

use super::machine::{Automaton, Power};
use super::memory::Memory;
use super::motion::Modes;
use super::params::{self, Kind, Values};
use super::readings::{Reading, Readings};
use super::setup::{Identity, Setup};
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::pdu::WordOrder;
use crate::simulator::device::contract::{Fault, NodeSetting, Servo};
use crate::tick::{Span, Tick};

/// One step of the drive.
const STEP: Span = Span::from_millis(1);
/// MBformat: number, parity, stop bits (manual 4.1).
const FORMATS: [(i32, Parity, u8); 4] =
    [(1, Parity::None, 1), (2, Parity::Even, 1), (3, Parity::Odd, 1), (4, Parity::None, 2)];
/// The master has not called in time. A number of the bench.
const GUARD_ERROR: Fault = Fault { number: 0x0101, class: 1, qualifier: 0 };
/// The shaft has run onto a limit switch. A number of the bench.
const LIMIT_ERROR: Fault = Fault { number: 0x0102, class: 1, qualifier: 0 };

/// An LXM05 without its line.
#[derive(Clone, Debug)]
pub(crate) struct Lexium {
    pub(crate) values: Values,
    pub(crate) identity: Identity,
    pub(crate) readings: Readings,
    pub(crate) memory: Memory,
    pub(crate) machine: Automaton,
    pub(crate) motion: Modes,
    /// End of the last step.
    pub(crate) at: Tick,
    /// As it was at power-on.
    pub(crate) order: WordOrder,
    /// Number of the last synchronous error.
    pub(crate) synchronous: u16,
    pub(crate) listen_only: bool,
    /// Last telegram that the node guard counts from.
    pub(crate) heard: Option<Tick>,
}

impl Lexium {
    /// A drive that is switched on.
    pub(crate) fn new(setup: &Setup, place: NodeSetting) -> Self {
        let line = place.line;
        let format = FORMATS.iter().find(|row| (row.1, row.2) == (line.parity, line.stop_bits)).map_or(2, |row| row.0);
        let mut values = Values::new();
        values.put(params::BAUD, i32::try_from(line.baud).unwrap_or(i32::MAX));
        values.put(params::FORMAT, format);
        values.put(params::ADDRESS, place.address.into());
        for &(address, value) in &setup.values {
            if let (Ok(address), Ok(value)) = (address.try_into(), value.try_into()) {
                values.put(address, value);
            }
        }
        let mut lexium = Lexium {
            values,
            identity: setup.identity.clone(),
            readings: setup.readings,
            memory: Memory::default(),
            machine: Automaton::new(Some(Tick::ZERO), setup.readings),
            motion: Modes::new(setup.world, setup.readings),
            at: Tick::ZERO,
            order: WordOrder::HighFirst,
            synchronous: 0,
            listen_only: false,
            heard: None,
        };
        lexium.values.settle();
        lexium.take_settings();
        lexium.motion.take_ratio(&lexium.values);
        lexium.machine.tick(Tick::ZERO, true);
        lexium
    }

    /// Speed and character format that MBbaud and MBformat hold.
    pub(crate) fn line(&self) -> LineSetting {
        let (_, parity, stop_bits) =
            *FORMATS.iter().find(|row| i64::from(row.0) == self.values.get(params::FORMAT)).unwrap_or(&FORMATS[1]);
        let baud = u32::try_from(self.values.get(params::BAUD)).unwrap_or(19_200);
        LineSetting { baud, data_bits: 8, parity, stop_bits }
    }

    /// MBadr.
    pub(crate) fn address(&self) -> u8 {
        u8::try_from(self.values.get(params::ADDRESS)).unwrap_or(1)
    }

    /// Power-on (or off and on again): off the bus until `up`.
    pub(crate) fn power_up(&mut self, now: Tick, up: Tick) {
        self.catch_up(now);
        self.values.power_up(self.readings.has(Reading::SaveByCommand));
        self.machine = Automaton::new(Some(up), self.readings);
        self.motion.power_up();
        self.take_settings();
        (self.synchronous, self.listen_only, self.heard) = (0, false, None);
    }

    /// What holds at once of MBadr, MBbaud and MBdword_order, when the reply to their write is out.
    pub(crate) fn follow(&mut self, address: u8, line: LineSetting) -> (u8, LineSetting) {
        let now = |reading| self.readings.has(reading);
        let address = if now(Reading::AddressAtOnce) { self.address() } else { address };
        let baud = if now(Reading::BaudAtOnce) { self.line().baud } else { line.baud };
        if now(Reading::WordOrderAtOnce) {
            self.take_settings();
        }
        (address, LineSetting { baud, ..line })
    }

    fn take_settings(&mut self) {
        self.order = if self.values.get(params::WORD_ORDER) == 1 { WordOrder::LowFirst } else { WordOrder::HighFirst };
    }

    /// A telegram to this station.
    pub(crate) fn heard(&mut self, now: Tick, is_write: bool) {
        let feeds = is_write || !self.readings.has(Reading::GuardFedByWrites);
        if feeds && self.values.get(params::NODE_GUARD) > 0 {
            self.heard = Some(now);
        }
    }

    /// An asynchronous error.
    pub(crate) fn fail(&mut self, now: Tick, fault: Fault) {
        self.catch_up(now);
        self.record(now, fault);
    }

    fn record(&mut self, now: Tick, fault: Fault) {
        self.machine.fail(fault);
        let seconds = i32::try_from(now.since(Tick::ZERO).as_millis() / 1_000).unwrap_or(i32::MAX);
        let entry = [fault.number.into(), fault.class.into(), seconds, fault.qualifier.into()];
        self.memory.keep(entry);
        self.show_entry(Some(entry));
    }

    /// Puts an entry of the fault memory where it is read; none is all zeros.
    pub(crate) fn show_entry(&mut self, entry: Option<[i32; 4]>) {
        let fields = [params::FAULT_NUMBER, params::FAULT_CLASS, params::FAULT_TIME, params::FAULT_QUALIFIER];
        for (field, value) in fields.into_iter().zip(entry.unwrap_or_default()) {
            self.values.put(field, value);
        }
    }

    /// Whether the output stage feeds the motor.
    pub(crate) fn powered(&self) -> bool {
        self.machine.power() != Power::Off
    }

    pub(crate) fn in_fault(&self) -> bool {
        self.machine.in_fault()
    }

    /// What the shaft does at `now`, if nobody does anything until then.
    pub(crate) fn servo(&self, now: Tick) -> Servo {
        let mut later = self.clone();
        later.catch_up(now);
        Servo {
            state: later.machine.status() & 0x6F,
            mode: later.motion.mode_number(),
            position_usr: later.motion.position(),
            speed_milli_rpm: later.motion.speed(),
            referenced: later.motion.referenced(),
        }
    }

    /// Frequency of the shaft at `now`, 0.01 turns per second; never 0 while it turns.
    pub(crate) fn frequency(&self, now: Tick) -> i64 {
        let speed = self.servo(now).speed_milli_rpm;
        speed.signum() * (speed.abs() / 600).max(speed.abs().min(1))
    }

    /// Cells of the EEPROM written.
    pub(crate) fn eeprom_writes(&self) -> u64 {
        self.values.writes()
    }

    /// Value of a persistent parameter.
    pub(crate) fn kept(&self, address: u32) -> Option<i64> {
        let row = params::at(u16::try_from(address).ok()?).filter(|row| row.kind == Kind::Kept)?;
        Some(self.values.get(row.address))
    }

    /// When the state can change by itself: never before the next step.
    pub(crate) fn next(&self) -> Option<Tick> {
        let ends = [self.machine.next(), self.motion.next(), self.guard_ends()];
        ends.into_iter().flatten().min().map(|end| end.max(self.at + STEP))
    }

    /// When the speed can change by itself.
    pub(crate) fn next_turning(&self) -> Option<Tick> {
        (self.powered() || !self.motion.stands()).then(|| self.at + STEP)
    }

    fn guard_ends(&self) -> Option<Tick> {
        let guard = u64::try_from(self.values.get(params::NODE_GUARD)).ok().filter(|&guard| guard > 0)?;
        let heard = self.heard.filter(|_| self.machine.power() == Power::Drives)?;
        Some(heard + Span::from_millis(guard))
    }

    /// Lets the time pass, in steps of a millisecond.
    pub(crate) fn catch_up(&mut self, now: Tick) {
        while self.at + STEP <= now {
            let before = (self.motion.clone(), self.machine.state());
            self.at += STEP;
            self.step();
            if before == (self.motion.clone(), self.machine.state()) {
                // Nothing goes on: the next step that can differ is the one of a deadline.
                let until = self.next().unwrap_or(now).min(now);
                let idle = until.since(self.at).as_micros() / STEP.as_micros();
                self.at += STEP.times(idle.saturating_sub(1));
            }
        }
    }

    fn step(&mut self) {
        let now = self.at;
        if self.guard_ends().is_some_and(|ends| ends <= now) {
            match self.readings.has(Reading::GuardQuickStop) {
                true => self.machine.quick_stop(),
                false => self.record(now, GUARD_ERROR),
            }
        }
        if self.powered() && self.motion.off_limits() && !self.in_fault() {
            self.record(now, LIMIT_ERROR);
        }
        self.machine.tick(now, self.motion.stands());
        self.motion.tick(now, &mut self.values, self.machine.word(), self.machine.power());
    }
}
