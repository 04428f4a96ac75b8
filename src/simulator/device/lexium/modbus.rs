//! Function codes of the LXM05 (manual 5.2), its refusals (6.2) and its synchronous errors (6.3.1).
//!
//! Choices where the manual is silent:
//! - exception 2 for addresses: none that the manual names, the second register of one, a gap between neighbours;
//!   3 for counts and lengths that are none, and for values out of range; 4 for what cannot be done with the parameter,
//!   or not now;
//! - the values of a telegram are checked before the first of them is written;
//! - code 23 writes first (V1.1b3, 6.17), and reads nothing if the write is refused;
//! - code 8: sub-function 1 takes 0000h and FF00h and clears the counters, 4 silences the drive until 1 comes, which is
//!   then not answered (V1.1b3, 6.8.1); all others but 0 want the data 0; what is reserved is exception 1;
//! - code 43 knows category 1 only, and begins anew with object 0 if it does not know the object (V1.1b3, 6.21).

use super::motion;
use super::params::{self, Kind, Row};
use super::readings::{Reading, Readings};
use super::servo::Lexium;
use crate::protocol::modbus::pdu::identification::{BASIC, Object, PRODUCT_CODE, VENDOR_NAME};
use crate::protocol::modbus::pdu::{
    CLEAR_COUNTERS, DIAGNOSTIC_REGISTER, ECHO, ENCAPSULATED, Exception, Identification, LISTEN_ONLY, MOST_EXCHANGED,
    MOST_READ, MOST_WRITTEN, PduError, RESTART_COMMUNICATION, Reply, Request, refused_identification,
};
use crate::simulator::device::cia402::{Command, State};
use crate::simulator::device::counters::Counters;
use crate::tick::Tick;

/// Why something is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Refusal {
    Function,
    Address,
    Length,
    Value,
    ReadOnly,
    NotNow,
}

impl Refusal {
    /// Exception code, and the synchronous error that sub-function 2 tells: numbers of the bench.
    fn row(self, readings: Readings) -> (Exception, u16) {
        let (code, number) = match self {
            Refusal::Function => (Exception::IllegalFunction, 1),
            Refusal::Address => (Exception::IllegalDataAddress, 2),
            Refusal::Length => (Exception::IllegalDataValue, 3),
            Refusal::Value => (Exception::IllegalDataValue, 4),
            Refusal::ReadOnly => (Exception::DeviceFailure, 5),
            Refusal::NotNow => (Exception::DeviceFailure, 6),
        };
        let one = ONE_FOR_ALL.iter().find(|row| readings.has(row.0));
        (one.map_or(code, |row| row.1), number)
    }
}

/// Which exception fits which case is open (manual 6.2): one for all.
const ONE_FOR_ALL: [(Reading, Exception); 4] = [
    (Reading::Exception1, Exception::IllegalFunction),
    (Reading::Exception2, Exception::IllegalDataAddress),
    (Reading::Exception3, Exception::IllegalDataValue),
    (Reading::Exception4, Exception::DeviceFailure),
];
/// Sub-functions of code 8 that return a counter (manual, table 5.2).
const COUNTERS: [u16; 6] = [11, 12, 13, 16, 17, 18];
/// Data of sub-function 1 that also clear the event log of the norm (V1.1b3, 6.8.1).
const CLEAR_LOG: u16 = 0xFF00;
/// Conformity level (manual 5.2.5).
const CONFORMITY: u8 = 2;

/// The PDU of a reply: a refusal of code 43 carries the type (manual 6.2).
pub(crate) fn encode(reply: &Reply) -> Vec<u8> {
    match reply {
        Reply::Exception { function: ENCAPSULATED, code } => refused_identification(*code),
        reply => reply.encode(),
    }
}

impl Lexium {
    /// Executes a request and makes the reply; `None` if the drive only listens. A refusal is counted.
    pub(crate) fn answer(&mut self, counters: &mut Counters, now: Tick, pdu: &[u8]) -> Option<Reply> {
        self.catch_up(now);
        let request = Request::decode(pdu);
        if self.listen_only {
            let restart = matches!(request, Ok(Request::Diagnostics { sub: RESTART_COMMUNICATION, .. }));
            self.listen_only = !restart;
            return None;
        }
        let done = request.map_err(|error| match error {
            PduError::Length { .. } | PduError::ByteCount { .. } | PduError::TooLong { .. } => Refusal::Length,
            PduError::Empty => Refusal::Function,
        });
        let reply = done.and_then(|request| self.execute(counters, now, request)).unwrap_or_else(|refusal| {
            let (code, number) = refusal.row(self.readings);
            self.synchronous = number;
            counters.count(Counters::EXCEPTIONS);
            Reply::Exception { function: pdu.first().copied().unwrap_or(0), code }
        });
        (!self.listen_only).then_some(reply)
    }

    fn execute(&mut self, counters: &mut Counters, now: Tick, request: Request) -> Result<Reply, Refusal> {
        match request {
            Request::ReadRegisters { start, count } => {
                let told = self.read_from(start, count)?;
                let faults = start..start.saturating_add(count);
                if self.readings.has(Reading::FaultMemoryMovesOn) && faults.contains(&params::FAULT_NUMBER) {
                    let next = self.memory.move_on();
                    self.show_entry(next);
                }
                Ok(Reply::Registers(told))
            }
            Request::WriteRegisters { start, values } => {
                self.write_from(now, start, &values, MOST_WRITTEN)?;
                Ok(Reply::RegistersWritten { start, count: values.len() as u16 })
            }
            Request::ExchangeRegisters { start, count, write_start, values } => {
                self.rows(start, count, MOST_READ)?;
                let first = self.readings.has(Reading::ExchangeReadsFirst);
                let before = if first { Some(self.read_from(start, count)?) } else { None };
                self.write_from(now, write_start, &values, MOST_EXCHANGED)?;
                let told = before.map_or_else(|| self.read_from(start, count), Ok);
                told.map(Reply::RegistersExchanged)
            }
            Request::Diagnostics { sub, data } => self.diagnose(counters, sub, data),
            Request::ReadIdentification { category: BASIC, object } => Ok(Reply::Identification(self.identify(object))),
            Request::ReadIdentification { .. } => Err(Refusal::Value),
            _ => Err(Refusal::Function),
        }
    }

    /// The neighbours that `count` registers from `start` on make.
    fn rows(&self, start: u16, count: u16, most: u16) -> Result<Vec<&'static Row>, Refusal> {
        if count == 0 || count > most || !count.is_multiple_of(2) {
            return Err(Refusal::Length);
        }
        let row = |offset: u16| start.checked_add(offset).and_then(params::at).ok_or(Refusal::Address);
        (0..count).step_by(2).map(row).collect()
    }

    fn read_from(&self, start: u16, count: u16) -> Result<Vec<u16>, Refusal> {
        let rows = self.rows(start, count, MOST_READ)?;
        Ok(rows.iter().flat_map(|row| self.order.split(self.read(row.address) as u32)).collect())
    }

    fn write_from(&mut self, now: Tick, start: u16, values: &[u16], most: u16) -> Result<(), Refusal> {
        let count = u16::try_from(values.len()).unwrap_or(u16::MAX);
        let rows = self.rows(start, count, most)?;
        let values = values.chunks_exact(2).map(|pair| self.order.join([pair[0], pair[1]]) as i32);
        let writes: Vec<(&Row, i32)> = rows.into_iter().zip(values).collect();
        let one_by_one = self.readings.has(Reading::WritesOneByOne);
        for (row, value) in writes.iter().filter(|_| !one_by_one) {
            self.check(row, *value)?;
        }
        for (row, value) in writes {
            if one_by_one {
                self.check(row, value)?;
            }
            self.write(now, row, value);
        }
        Ok(())
    }

    /// Present value of a parameter.
    pub(crate) fn read(&self, address: u16) -> i32 {
        let narrow = |value: i64| i32::try_from(value).unwrap_or(if value < 0 { i32::MIN } else { i32::MAX });
        match address {
            params::STATUS => {
                let (word, power) = (self.machine.word(), self.machine.power());
                (self.machine.status() | self.motion.status(&self.values, word, power)).into()
            }
            params::MODE_ACTIVE => narrow(self.motion.mode_number()),
            params::POSITION => narrow(self.motion.position().saturating_add(self.motion.waver(self.at))),
            _ => narrow(self.values.get(address)),
        }
    }

    fn check(&self, row: &Row, value: i32) -> Result<(), Refusal> {
        let jogs = self.motion.mode() == Some(motion::Mode::Jog) && self.machine.state() == State::Enabled;
        let turns = self.machine.state() == State::Enabled && !self.motion.stands();
        match row {
            Row { address: params::MODE, .. } if turns && self.is_busy(value) => Err(Refusal::NotNow),
            Row { address: params::CONTROL, .. } if turns && self.refuses_word(value) => Err(Refusal::NotNow),
            Row { kind: Kind::ReadOnly, .. } => Err(Refusal::ReadOnly),
            row if !row.takes(value) => Err(Refusal::Value),
            Row { address: params::JOG, .. } if value != 0 && !jogs => Err(Refusal::NotNow),
            _ => Ok(()),
        }
    }

    /// Whether a running movement forbids this mode (manual 6.3.1).
    fn is_busy(&self, mode: i32) -> bool {
        self.readings.has(Reading::ModeChangeRefused) && i64::from(mode) != self.motion.mode_number()
    }

    fn refuses_word(&self, word: i32) -> bool {
        self.readings.has(Reading::Control7Refused) && Command::of(word as u16) == Command::SwitchOn
    }

    /// Somebody else sets a parameter: as a telegram would, but what the drive itself shows of its faults is put there.
    pub(crate) fn set_by_hand(&mut self, now: Tick, address: u32, value: i64) {
        let row = u16::try_from(address).ok().and_then(params::at);
        let Some((row, value)) = row.zip(i32::try_from(value).ok()) else { return };
        if row.kind == Kind::ReadOnly {
            self.values.put(row.address, value);
        } else if self.check(row, value).is_ok() {
            self.write(now, row, value);
        }
    }

    fn write(&mut self, now: Tick, row: &Row, value: i32) {
        self.values.write(row, value);
        match row.address {
            params::CONTROL => {
                let (word, before) = (value as u16, self.machine.word());
                self.machine.command(now, word);
                if self.machine.state() == State::Enabled {
                    self.motion.command(&self.values, word, before);
                }
            }
            params::MODE => {
                if let Some(mode) = motion::Mode::of(value.into()) {
                    self.motion.want(now, mode);
                }
            }
            params::GEAR_NUMERATOR => self.motion.take_ratio(&self.values),
            params::NODE_GUARD => self.heard = (value > 0).then_some(now),
            _ => {}
        }
    }

    fn diagnose(&mut self, counters: &mut Counters, sub: u16, data: u16) -> Result<Reply, Refusal> {
        let told = match (sub, data) {
            (ECHO, data) => data,
            (RESTART_COMMUNICATION, 0 | CLEAR_LOG) => {
                *counters = Counters::default();
                data
            }
            (DIAGNOSTIC_REGISTER, 0) => self.synchronous,
            (LISTEN_ONLY, 0) => {
                self.listen_only = true;
                data
            }
            (CLEAR_COUNTERS, 0) => {
                *counters = Counters::default();
                self.synchronous = 0;
                data
            }
            (sub, 0) if COUNTERS.contains(&sub) => counters.get(sub),
            (RESTART_COMMUNICATION | DIAGNOSTIC_REGISTER | LISTEN_ONLY | CLEAR_COUNTERS, _) => {
                return Err(Refusal::Value);
            }
            (sub, _) if COUNTERS.contains(&sub) => return Err(Refusal::Value),
            _ => return Err(Refusal::Function),
        };
        Ok(Reply::Diagnostics { sub, data: told })
    }

    fn identify(&self, object: u8) -> Identification {
        let identity = &self.identity;
        let texts = [
            (VENDOR_NAME, &identity.vendor),
            (PRODUCT_CODE, &identity.product),
            (identity.revision_object, &identity.revision),
        ];
        let first = texts.iter().position(|text| text.0 == object).unwrap_or(0);
        let most = if identity.in_pieces { 1 } else { texts.len() };
        let told = texts.iter().skip(first).take(most);
        let next = texts.get(first + most).map(|text| text.0);
        let objects = told.map(|(id, text)| Object { id: *id, value: text.as_bytes().to_vec() }).collect();
        Identification { category: BASIC, conformity: CONFORMITY, next, objects }
    }
}
