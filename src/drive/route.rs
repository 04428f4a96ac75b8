//! From a parameter to the question that reads or writes it, over the ACTIVE family's Modbus codes.

use crate::profile::Type;
use crate::protocol::modbus::pdu::{CLEAR_COUNTERS, ParamAddress, Request};

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

/// A question that a verb would put, for a dry run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inquiry {
    /// Read a parameter.
    Read(RegisterAddress, Type),
    /// Write these bits to a parameter.
    Write(RegisterAddress, Type, u32),
    /// Read a diagnostic counter.
    Counter(u16),
    /// Set every diagnostic counter to zero.
    ClearCounters,
}

impl Inquiry {
    pub(super) fn request(self) -> Request {
        match self {
            Inquiry::Read(at, kind) => read(at, kind),
            Inquiry::Write(at, kind, bits) => write(at, kind, bits),
            Inquiry::Counter(sub) => Request::Diagnostics { sub, data: 0 },
            Inquiry::ClearCounters => Request::Diagnostics { sub: CLEAR_COUNTERS, data: 0 },
        }
    }
}
