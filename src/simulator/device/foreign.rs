//! A Modbus slave that is no drive of ours: it knows what the norm defines and no vendor code
//! (MODBUS Application Protocol V1.1b3, 6.3, 6.4, 6.6, 6.8, 6.12).

use crate::profile::input_register;
use crate::protocol::modbus::pdu::{Exception, PduError, Reply, Request};
use crate::simulator::device::contract::{AskedByModbus, Device, Response};
use crate::simulator::device::counters::Counters;
use crate::tick::Tick;
use std::collections::BTreeMap;

/// Registers by address, and those that are only read (code 4), which are other ones.
#[derive(Clone, Debug, Default)]
pub(crate) struct Foreign {
    registers: BTreeMap<u16, u16>,
    /// It has no time for anybody.
    busy: bool,
    inputs: BTreeMap<u16, u16>,
}

/// Most registers of one request (V1.1b3, 6.3).
const MOST_REGISTERS: u16 = 125;

impl Foreign {
    /// Input registers have the numbers that a catalogue gives them.
    pub(crate) fn new(cells: &BTreeMap<u32, u16>, busy: bool) -> Self {
        let of = |which: fn(u32) -> Option<u16>| {
            cells.iter().filter_map(move |(&number, &value)| Some((which(number)?, value)))
        };
        let registers = of(|number| u16::try_from(number).ok()).collect();
        Foreign { registers, inputs: of(input_register).collect(), busy }
    }

    pub(crate) fn register(&self, address: u32) -> Option<i64> {
        self.registers.get(&u16::try_from(address).ok()?).map(|&value| value.into())
    }

    /// Executes a request and makes the reply.
    pub(crate) fn answer(&mut self, pdu: &[u8]) -> Reply {
        let function = pdu.first().copied().unwrap_or(0);
        if self.busy {
            return Reply::Exception { function, code: Exception::DeviceBusy };
        }
        self.execute(pdu).unwrap_or_else(|code| Reply::Exception { function, code })
    }

    fn execute(&mut self, pdu: &[u8]) -> Result<Reply, Exception> {
        let request = Request::decode(pdu).map_err(|error| match error {
            // The lengths of 100 and 101 are our maker's; nobody else knows these codes.
            PduError::Length { function: 100 | 101, .. } | PduError::Empty => Exception::IllegalFunction,
            PduError::Length { .. } | PduError::ByteCount { .. } | PduError::TooLong { .. } => {
                Exception::IllegalDataValue
            }
        })?;
        match request {
            Request::ReadRegisters { start, count } => read(&self.registers, start, count).map(Reply::Registers),
            Request::ReadInputs { start, count } => read(&self.inputs, start, count).map(Reply::Inputs),
            Request::WriteRegister { address, value } => {
                *self.registers.get_mut(&address).ok_or(Exception::IllegalDataAddress)? = value;
                Ok(Reply::RegisterWritten { address, value })
            }
            Request::WriteRegisters { start, values } => {
                let count = values.len() as u16;
                let last = start.checked_add(count.saturating_sub(1)).ok_or(Exception::IllegalDataAddress)?;
                if !(start..=last).all(|address| self.registers.contains_key(&address)) {
                    return Err(Exception::IllegalDataAddress);
                }
                self.registers.extend((start..=last).zip(values));
                Ok(Reply::RegistersWritten { start, count })
            }
            Request::Diagnostics { sub: 0, data } => Ok(Reply::Diagnostics { sub: 0, data }),
            _ => Err(Exception::IllegalFunction),
        }
    }
}

fn read(cells: &BTreeMap<u16, u16>, start: u16, count: u16) -> Result<Vec<u16>, Exception> {
    if count == 0 || count > MOST_REGISTERS {
        return Err(Exception::IllegalDataValue);
    }
    let read = |offset: u16| cells.get(&start.checked_add(offset)?).copied();
    (0..count).map(read).collect::<Option<_>>().ok_or(Exception::IllegalDataAddress)
}

impl Device for Foreign {
    fn model(&self) -> &'static str {
        "foreign"
    }

    fn modbus(&mut self) -> Option<&mut dyn AskedByModbus> {
        Some(self)
    }

    /// A register.
    fn ram(&self, address: u32, _set: u8) -> Option<i64> {
        self.register(address)
    }
}

impl AskedByModbus for Foreign {
    fn answer(&mut self, _counters: &mut Counters, _now: Tick, pdu: &[u8]) -> Option<Response<Reply>> {
        Some(Response::plain(Foreign::answer(self, pdu)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_speaks_the_norm_and_nothing_else() {
        let mut foreign = Foreign::new(&[(0, 17), (1, 42), (300_002, 5), (300_003, 6)].into(), false);
        assert_eq!(foreign.answer(&[4, 0, 1, 0, 2]).encode(), [4, 4, 0, 5, 0, 6]);
        assert_eq!(foreign.answer(&[4, 0, 0, 0, 1]).encode(), [0x84, 2]);
        assert_eq!(foreign.answer(&[3, 0, 0, 0, 2]).encode(), [3, 4, 0, 17, 0, 42]);
        assert_eq!(foreign.answer(&[3, 0, 1, 0, 2]).encode(), [0x83, 2]);
        assert_eq!(foreign.answer(&[3, 0, 0, 0, 0]).encode(), [0x83, 3]);
        assert_eq!(foreign.answer(&[6, 0, 1, 0, 9]).encode(), [6, 0, 1, 0, 9]);
        assert_eq!(foreign.answer(&[8, 0, 0, 0xA5, 0x37]).encode(), [8, 0, 0, 0xA5, 0x37]);
        assert_eq!(foreign.answer(&[8, 0, 0x0B, 0, 0]).encode(), [0x88, 1]);
        assert_eq!(foreign.answer(&[100, 1, 0xE1]).encode(), [0xE4, 1]);
        assert_eq!(foreign.register(1), Some(9));
        assert_eq!(foreign.answer(&[16, 0, 0, 0, 2, 4, 0, 1, 0, 2]).encode(), [16, 0, 0, 0, 2]);
        assert_eq!(foreign.answer(&[16, 0, 1, 0, 2, 4, 0, 7, 0, 8]).encode(), [0x90, 2], "one of them is not there");
        assert_eq!((foreign.register(0), foreign.register(1)), (Some(1), Some(2)), "and so none is written");
    }
}
