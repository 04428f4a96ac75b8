//! From a parameter to the question that reads or writes it, over the ACTIVE family's Modbus codes.

use crate::profile::Type;
use crate::protocol::modbus::pdu::{ParamAddress, Request};
use crate::protocol::modbus::{Framing, Hex};

/// A parameter number and a data set as they go on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RegisterAddress {
    /// Parameter number, 0-4095.
    pub number: u16,
    /// Data set on the wire, 0-9.
    pub set: u8,
}

impl RegisterAddress {
    /// The address, if the number fits into its 12 bits.
    pub fn new(number: u32, set: u8) -> Option<Self> {
        let number = u16::try_from(number).ok()?;
        ParamAddress::new(set, number).map(|_| RegisterAddress { number, set })
    }

    /// The address word on the wire.
    pub fn word(self) -> u16 {
        ParamAddress::new(self.set, self.number).map_or(0, ParamAddress::word)
    }
}

/// The question that reads a parameter of this width: code 3 for 16 bits, 100 for 32 (CM-485 manual 6.4).
pub(super) fn read(at: RegisterAddress, kind: Type) -> Request {
    match kind {
        Type::Long => Request::ReadLong { address: at.word() },
        _ => Request::ReadRegisters { start: at.word(), count: 1 },
    }
}

/// The question that writes a parameter of this width: code 6 for 16 bits, 101 for 32 (CM-485 manual 6.4).
pub(super) fn write(at: RegisterAddress, kind: Type, bits: u32) -> Request {
    match kind {
        Type::Long => Request::WriteLong { address: at.word(), value: bits },
        _ => Request::WriteRegister { address: at.word(), value: bits as u16 },
    }
}

/// A write as it would go over the line, in hex, for a dry run.
pub fn request_telegram(framing: Framing, station: u8, at: RegisterAddress, kind: Type, bits: u32) -> String {
    Hex(&framing.encode(station, &write(at, kind, bits).encode())).to_string()
}
