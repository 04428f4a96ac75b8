//! Requests: what a master asks.

use super::codes::{
    CLEAR_COUNTERS, DIAGNOSTICS, ECHO, ENCAPSULATED, EXCHANGE_REGISTERS, IDENTIFICATION, LISTEN_ONLY, READ_INPUTS,
    READ_LONG, READ_REGISTERS, RESTART_COMMUNICATION, WRITE_LONG, WRITE_REGISTER, WRITE_REGISTERS,
};
use super::end::ReplyEnd;
use super::fields::{PduError, leading, put_values, split, take_values, words};
use super::identification;
use super::reply::Reply;

/// What a master asks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Request {
    /// Code 3.
    ReadRegisters {
        /// First register, or address word.
        start: u16,
        /// Number of registers; ACTIVE drives allow only 1.
        count: u16,
    },
    /// Code 4.
    ReadInputs {
        /// First input register.
        start: u16,
        /// Number of registers.
        count: u16,
    },
    /// Code 6.
    WriteRegister {
        /// Register, or address word.
        address: u16,
        /// The 16 bits to write.
        value: u16,
    },
    /// Code 8.
    Diagnostics {
        /// Sub-function.
        sub: u16,
        /// Data field, 0 for the sub-functions of the ACTIVE family.
        data: u16,
    },
    /// Code 16.
    WriteRegisters {
        /// First register.
        start: u16,
        /// At most [`MOST_WRITTEN`](super::MOST_WRITTEN) registers.
        values: Vec<u16>,
    },
    /// Code 23: writes first, then reads (V1.1b3, 6.17).
    ExchangeRegisters {
        /// First register to read.
        start: u16,
        /// Number of registers to read.
        count: u16,
        /// First register to write.
        write_start: u16,
        /// At most [`MOST_EXCHANGED`](super::MOST_EXCHANGED) registers to write.
        values: Vec<u16>,
    },
    /// Code 43, type 14.
    ReadIdentification {
        /// Category: [`identification::BASIC`], [`identification::SINGLE`] or another of the norm.
        category: u8,
        /// Object to begin with.
        object: u8,
    },
    /// Code 100.
    ReadLong {
        /// Address word.
        address: u16,
    },
    /// Code 101.
    WriteLong {
        /// Address word.
        address: u16,
        /// The 32 bits to write.
        value: u32,
    },
    /// Any other function code, raw.
    Other {
        /// Function code.
        function: u8,
        /// Everything after the function code.
        data: Vec<u8>,
    },
}

impl Request {
    /// Function code of the request.
    pub fn function(&self) -> u8 {
        match self {
            Request::ReadRegisters { .. } => READ_REGISTERS,
            Request::ReadInputs { .. } => READ_INPUTS,
            Request::WriteRegister { .. } => WRITE_REGISTER,
            Request::Diagnostics { .. } => DIAGNOSTICS,
            Request::WriteRegisters { .. } => WRITE_REGISTERS,
            Request::ExchangeRegisters { .. } => EXCHANGE_REGISTERS,
            Request::ReadIdentification { .. } => ENCAPSULATED,
            Request::ReadLong { .. } => READ_LONG,
            Request::WriteLong { .. } => WRITE_LONG,
            Request::Other { function, .. } => *function,
        }
    }

    /// Whether the request changes something in the slave, so that it may be broadcast.
    pub fn is_write(&self) -> bool {
        match self {
            Request::WriteRegister { .. }
            | Request::WriteRegisters { .. }
            | Request::ExchangeRegisters { .. }
            | Request::WriteLong { .. } => true,
            Request::Diagnostics { sub, .. } => [CLEAR_COUNTERS, RESTART_COMMUNICATION, LISTEN_ONLY].contains(sub),
            _ => false,
        }
    }

    /// The PDU on the wire.
    pub fn encode(&self) -> Vec<u8> {
        let mut pdu = vec![self.function()];
        match self {
            Request::ReadRegisters { start: a, count: b }
            | Request::ReadInputs { start: a, count: b }
            | Request::WriteRegister { address: a, value: b }
            | Request::Diagnostics { sub: a, data: b } => {
                pdu.extend(a.to_be_bytes());
                pdu.extend(b.to_be_bytes());
            }
            Request::WriteRegisters { start, values } => {
                pdu.extend(start.to_be_bytes());
                put_values(&mut pdu, values);
            }
            Request::ExchangeRegisters { start, count, write_start, values } => {
                pdu.extend([start, count, write_start].into_iter().flat_map(|word| word.to_be_bytes()));
                put_values(&mut pdu, values);
            }
            Request::ReadIdentification { category, object } => pdu.extend([IDENTIFICATION, *category, *object]),
            Request::ReadLong { address } => pdu.extend(address.to_be_bytes()),
            Request::WriteLong { address, value } => {
                pdu.extend(address.to_be_bytes());
                pdu.extend(value.to_be_bytes());
            }
            Request::Other { data, .. } => pdu.extend(data),
        }
        pdu
    }

    /// Reads a request PDU, as a slave does.
    pub fn decode(pdu: &[u8]) -> Result<Self, PduError> {
        let (function, data) = split(pdu)?;
        Ok(match function {
            READ_REGISTERS => {
                let [start, count] = words(function, data)?;
                Request::ReadRegisters { start, count }
            }
            READ_INPUTS => {
                let [start, count] = words(function, data)?;
                Request::ReadInputs { start, count }
            }
            WRITE_REGISTER => {
                let [address, value] = words(function, data)?;
                Request::WriteRegister { address, value }
            }
            DIAGNOSTICS => {
                let [sub, data] = words(function, data)?;
                Request::Diagnostics { sub, data }
            }
            WRITE_REGISTERS => {
                let ([start, count], rest) = leading(function, data)?;
                Request::WriteRegisters { start, values: take_values(function, data, count, rest)? }
            }
            EXCHANGE_REGISTERS => {
                let ([start, count, write_start, written], rest) = leading(function, data)?;
                let values = take_values(function, data, written, rest)?;
                Request::ExchangeRegisters { start, count, write_start, values }
            }
            ENCAPSULATED if data.first() == Some(&IDENTIFICATION) => {
                let &[_, category, object] = data else {
                    return Err(PduError::Length { function, len: data.len(), expected: 3 });
                };
                Request::ReadIdentification { category, object }
            }
            READ_LONG => {
                let [address] = words(function, data)?;
                Request::ReadLong { address }
            }
            WRITE_LONG => {
                let [address, high, low] = words(function, data)?;
                Request::WriteLong { address, value: u32::from(high) << 16 | u32::from(low) }
            }
            _ => Request::Other { function, data: data.to_vec() },
        })
    }

    /// How the normal reply ends.
    pub fn reply_end(&self) -> ReplyEnd {
        match self {
            Request::ReadRegisters { .. } | Request::ReadInputs { .. } | Request::ExchangeRegisters { .. } => {
                ReplyEnd::CountAt(1)
            }
            Request::Diagnostics { sub: LISTEN_ONLY, .. } => ReplyEnd::Never,
            Request::WriteRegister { .. }
            | Request::WriteRegisters { .. }
            | Request::Diagnostics { .. }
            | Request::ReadLong { .. } => ReplyEnd::Fixed(5),
            Request::ReadIdentification { .. } => ReplyEnd::Objects,
            Request::WriteLong { .. } => ReplyEnd::Fixed(7),
            Request::Other { .. } => ReplyEnd::Silence,
        }
    }

    /// Whether `reply` can be the answer to this request: same function code, and echoed fields as they were sent.
    pub fn is_answered_by(&self, reply: &Reply) -> bool {
        match (self, reply) {
            (request, Reply::Exception { function, .. }) => request.function() == *function,
            (Request::ReadRegisters { count, .. }, Reply::Registers(values)) => values.len() == usize::from(*count),
            (Request::ReadInputs { count, .. }, Reply::Inputs(values)) => values.len() == usize::from(*count),
            (Request::WriteRegister { address, value }, Reply::RegisterWritten { address: written, value: echoed }) => {
                address == written && value == echoed
            }
            (Request::Diagnostics { sub: ECHO, data }, Reply::Diagnostics { sub: ECHO, data: echoed }) => {
                data == echoed
            }
            (Request::Diagnostics { sub, .. }, Reply::Diagnostics { sub: echoed, .. }) => sub == echoed,
            (Request::WriteRegisters { start, values }, Reply::RegistersWritten { start: written, count }) => {
                start == written && values.len() == usize::from(*count)
            }
            (Request::ExchangeRegisters { count, .. }, Reply::RegistersExchanged(values)) => {
                values.len() == usize::from(*count)
            }
            (Request::ReadIdentification { category, object }, Reply::Identification(told)) => {
                *category == told.category && (*category != identification::SINGLE || told.object(*object).is_some())
            }
            (Request::ReadLong { .. }, Reply::Long(_)) => true,
            (Request::WriteLong { address, value }, Reply::LongWritten { address: written, value: echoed }) => {
                address == written && value == echoed
            }
            (Request::Other { function, .. }, Reply::Other { function: answered, .. }) => function == answered,
            _ => false,
        }
    }
}
