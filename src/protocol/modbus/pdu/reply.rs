//! Replies: what a slave answers.

use super::codes::{
    DIAGNOSTICS, ENCAPSULATED, EXCEPTION_BIT, EXCHANGE_REGISTERS, IDENTIFICATION, READ_INPUTS, READ_LONG,
    READ_REGISTERS, WRITE_LONG, WRITE_REGISTER, WRITE_REGISTERS,
};
use super::exception::Exception;
use super::fields::{PduError, put_bytes, split, take_bytes, words};
use super::identification::Identification;

/// What a slave answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// Code 3.
    Registers(Vec<u16>),
    /// Code 4.
    Inputs(Vec<u16>),
    /// Code 6: the echo of the request.
    RegisterWritten {
        /// Register, or address word.
        address: u16,
        /// The 16 bits that were written.
        value: u16,
    },
    /// Code 8.
    Diagnostics {
        /// Sub-function, echoed.
        sub: u16,
        /// Counter value, or the echoed data field.
        data: u16,
    },
    /// Code 16.
    RegistersWritten {
        /// First register, echoed.
        start: u16,
        /// Number of registers, echoed.
        count: u16,
    },
    /// Code 23: what was read after the write.
    RegistersExchanged(Vec<u16>),
    /// Code 43, type 14.
    Identification(Identification),
    /// Code 100.
    Long(u32),
    /// Code 101: the echo of the request.
    LongWritten {
        /// Address word.
        address: u16,
        /// The 32 bits that were written.
        value: u32,
    },
    /// Exception reply.
    Exception {
        /// Function code of the request, without the exception bit.
        function: u8,
        /// Why it was refused.
        code: Exception,
    },
    /// Any other function code, raw.
    Other {
        /// Function code.
        function: u8,
        /// Everything after the function code.
        data: Vec<u8>,
    },
}

impl Reply {
    /// Function code of the request that this answers.
    pub fn function(&self) -> u8 {
        match self {
            Reply::Registers(_) => READ_REGISTERS,
            Reply::Inputs(_) => READ_INPUTS,
            Reply::RegisterWritten { .. } => WRITE_REGISTER,
            Reply::Diagnostics { .. } => DIAGNOSTICS,
            Reply::RegistersWritten { .. } => WRITE_REGISTERS,
            Reply::RegistersExchanged(_) => EXCHANGE_REGISTERS,
            Reply::Identification(_) => ENCAPSULATED,
            Reply::Long(_) => READ_LONG,
            Reply::LongWritten { .. } => WRITE_LONG,
            Reply::Exception { function, .. } | Reply::Other { function, .. } => *function,
        }
    }

    /// The PDU on the wire, as a slave sends it.
    pub fn encode(&self) -> Vec<u8> {
        let mut pdu = vec![self.function()];
        match self {
            Reply::Registers(values) | Reply::Inputs(values) | Reply::RegistersExchanged(values) => {
                put_bytes(&mut pdu, values)
            }
            Reply::RegisterWritten { address: a, value: b }
            | Reply::RegistersWritten { start: a, count: b }
            | Reply::Diagnostics { sub: a, data: b } => {
                pdu.extend(a.to_be_bytes());
                pdu.extend(b.to_be_bytes());
            }
            Reply::Identification(told) => pdu.extend(told.encode()),
            Reply::Long(value) => pdu.extend(value.to_be_bytes()),
            Reply::LongWritten { address, value } => {
                pdu.extend(address.to_be_bytes());
                pdu.extend(value.to_be_bytes());
            }
            Reply::Exception { function, code } => return vec![function | EXCEPTION_BIT, code.code()],
            Reply::Other { data, .. } => pdu.extend(data),
        }
        pdu
    }

    /// Reads a reply PDU, as a master does.
    pub fn decode(pdu: &[u8]) -> Result<Self, PduError> {
        let (function, data) = split(pdu)?;
        if function & EXCEPTION_BIT != 0 {
            let function = function & !EXCEPTION_BIT;
            let code = match *data {
                [code] => code,
                [IDENTIFICATION, code] if function == ENCAPSULATED => code,
                _ => return Err(PduError::Length { function: function | EXCEPTION_BIT, len: data.len(), expected: 1 }),
            };
            return Ok(Reply::Exception { function, code: Exception::from_code(code) });
        }
        Ok(match function {
            READ_REGISTERS => Reply::Registers(take_bytes(function, data)?),
            READ_INPUTS => Reply::Inputs(take_bytes(function, data)?),
            WRITE_REGISTER => {
                let [address, value] = words(function, data)?;
                Reply::RegisterWritten { address, value }
            }
            DIAGNOSTICS => {
                let [sub, data] = words(function, data)?;
                Reply::Diagnostics { sub, data }
            }
            WRITE_REGISTERS => {
                let [start, count] = words(function, data)?;
                Reply::RegistersWritten { start, count }
            }
            EXCHANGE_REGISTERS => Reply::RegistersExchanged(take_bytes(function, data)?),
            ENCAPSULATED if data.first() == Some(&IDENTIFICATION) => {
                Reply::Identification(Identification::decode(data)?)
            }
            READ_LONG => {
                let [high, low] = words(function, data)?;
                Reply::Long(u32::from(high) << 16 | u32::from(low))
            }
            WRITE_LONG => {
                let [address, high, low] = words(function, data)?;
                Reply::LongWritten { address, value: u32::from(high) << 16 | u32::from(low) }
            }
            _ => Reply::Other { function, data: data.to_vec() },
        })
    }
}

/// The refusal of a code 43 that carries the type behind the function code, as the LXM05 sends it (LXM05 manual 6.2).
/// The norm leaves the type out (V1.1b3, 6.21); [`Reply::decode`] takes both.
pub fn refused_identification(code: Exception) -> Vec<u8> {
    vec![ENCAPSULATED | EXCEPTION_BIT, IDENTIFICATION, code.code()]
}
