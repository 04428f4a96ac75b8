//! Protocol data units: function code and data, requests and replies, for master and slave.
//!
//! Codes 3, 6 and 8 follow MODBUS Application Protocol V1.1b3 (6.3, 6.6, 6.8) as narrowed by the CM-485 manual 6.4;
//! codes 100 and 101 are the maker's own (CM-485 manual 6.4.3, 6.4.4). Any other code travels as raw data.

use super::MAX_PDU;
use std::fmt;

/// Function code 3: read holding registers (CM-485 manual 6.4.1: one 16-bit parameter).
pub const READ_REGISTERS: u8 = 3;
/// Function code 6: write a single register (CM-485 manual 6.4.2: one 16-bit parameter).
pub const WRITE_REGISTER: u8 = 6;
/// Function code 8: diagnostics (CM-485 manual 6.4.5).
pub const DIAGNOSTICS: u8 = 8;
/// Function code 100: read one 32-bit parameter, vendor code (CM-485 manual 6.4.3).
pub const READ_LONG: u8 = 100;
/// Function code 101: write one 32-bit parameter, vendor code (CM-485 manual 6.4.4).
pub const WRITE_LONG: u8 = 101;
/// Bit of the function code that marks an exception reply (CM-485 manual 6.5).
pub const EXCEPTION_BIT: u8 = 0x80;

/// Sub-function of code 8 that sets every counter to zero (CM-485 manual 6.4.5).
pub const CLEAR_COUNTERS: u16 = 0x0A;
/// Sub-functions of code 8 that return a counter (CM-485 manual 6.4.5).
pub const COUNTERS: std::ops::RangeInclusive<u16> = 0x0B..=0x12;

/// The address word of the ACTIVE family: data set in the upper 4 bits, parameter number in the lower 12
/// (CM-485 manual 6.4.1).
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ParamAddress(u16);

impl ParamAddress {
    /// Highest parameter number that the drives know (CM-485 manual 6.4.1).
    pub const LAST_NUMBER: u16 = 1599;
    /// Highest number that the 12 bits can carry.
    pub const MAX_NUMBER: u16 = 0x0FFF;
    /// Highest data set: 0-4 EEPROM, 5-9 RAM (CM-485 manual 7).
    pub const LAST_SET: u8 = 9;

    /// An address from data set (0-15) and parameter number (0-4095); `None` if they do not fit into their bits.
    pub fn new(set: u8, number: u16) -> Option<Self> {
        (set <= 0x0F && number <= Self::MAX_NUMBER).then(|| ParamAddress(u16::from(set) << 12 | number))
    }

    /// The address that a word on the wire stands for.
    pub const fn from_word(word: u16) -> Self {
        ParamAddress(word)
    }

    /// The word on the wire.
    pub const fn word(self) -> u16 {
        self.0
    }

    /// Data set, 0-15.
    pub const fn set(self) -> u8 {
        (self.0 >> 12) as u8
    }

    /// Parameter number, 0-4095.
    pub const fn number(self) -> u16 {
        self.0 & Self::MAX_NUMBER
    }
}

impl fmt::Debug for ParamAddress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "P.{}@{}", self.number(), self.set())
    }
}

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

/// What a slave answers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Reply {
    /// Code 3.
    Registers(Vec<u16>),
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

/// Exception codes (MODBUS Application Protocol V1.1b3, 7; CM-485 manual 6.6 uses 1-4).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Exception {
    /// 1: function code or sub-function unknown.
    IllegalFunction,
    /// 2: address (parameter) unknown, or a wrong number of registers.
    IllegalDataAddress,
    /// 3: wrong length, or a fixed field with another value.
    IllegalDataValue,
    /// 4: reading or writing the parameter failed.
    DeviceFailure,
    /// 5: accepted, takes long.
    Acknowledge,
    /// 6: busy with a long command.
    DeviceBusy,
    /// 8: memory parity error.
    MemoryParity,
    /// 10: gateway has no path.
    GatewayPath,
    /// 11: gateway target did not answer.
    GatewayTarget,
    /// A code that the norm does not define.
    Other(u8),
}

impl Exception {
    const TABLE: [(Exception, u8, &'static str); 9] = [
        (Exception::IllegalFunction, 1, "illegal function"),
        (Exception::IllegalDataAddress, 2, "illegal data address"),
        (Exception::IllegalDataValue, 3, "illegal data value"),
        (Exception::DeviceFailure, 4, "slave device failure"),
        (Exception::Acknowledge, 5, "acknowledge"),
        (Exception::DeviceBusy, 6, "slave device busy"),
        (Exception::MemoryParity, 8, "memory parity error"),
        (Exception::GatewayPath, 10, "gateway path unavailable"),
        (Exception::GatewayTarget, 11, "gateway target failed to respond"),
    ];

    /// The exception that a code on the wire stands for.
    pub fn from_code(code: u8) -> Self {
        Self::TABLE.iter().find(|row| row.1 == code).map_or(Exception::Other(code), |row| row.0)
    }

    /// The code on the wire.
    pub fn code(self) -> u8 {
        match self {
            Exception::Other(code) => code,
            known => Self::TABLE.iter().find(|row| row.0 == known).map_or(0, |row| row.1),
        }
    }

    /// The name that the norm gives.
    pub fn name(self) -> &'static str {
        Self::TABLE.iter().find(|row| row.0 == self).map_or("undefined exception", |row| row.2)
    }
}

impl fmt::Display for Exception {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.code(), self.name())
    }
}

/// Why a PDU is not what its function code promises.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PduError {
    /// Nothing there at all.
    #[error("empty PDU")]
    Empty,
    /// The data have another length than the function code asks for.
    #[error("function code {function}: {len} data bytes, expected {expected}")]
    Length {
        /// Function code as it came.
        function: u8,
        /// Data bytes after the function code.
        len: usize,
        /// Data bytes that the code asks for.
        expected: usize,
    },
    /// Longer than any PDU may be.
    #[error("PDU of {len} bytes, at most {MAX_PDU} are allowed")]
    TooLong {
        /// Length of the PDU.
        len: usize,
    },
}

/// How the normal reply to a request ends, so that nobody has to wait for silence to know that it is complete.
///
/// Lengths count the PDU: function code and data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReplyEnd {
    /// The reply has this many bytes.
    Fixed(usize),
    /// The byte at this offset counts the bytes that follow it.
    CountAt(usize),
    /// Only silence (RTU) or the terminator (ASCII) tells.
    Silence,
    /// There is no reply: the request is a broadcast.
    Never,
}

impl ReplyEnd {
    /// Length of the whole reply PDU whose first bytes are `start`; `None` while it cannot be told yet or ever.
    pub fn length(self, start: &[u8]) -> Option<usize> {
        if start.first()? & EXCEPTION_BIT != 0 {
            return Some(2);
        }
        match self {
            ReplyEnd::Fixed(length) => Some(length),
            ReplyEnd::CountAt(offset) => start.get(offset).map(|&count| offset + 1 + usize::from(count)),
            ReplyEnd::Silence | ReplyEnd::Never => None,
        }
    }
}

impl Request {
    /// Function code of the request.
    pub fn function(&self) -> u8 {
        match self {
            Request::ReadRegisters { .. } => READ_REGISTERS,
            Request::WriteRegister { .. } => WRITE_REGISTER,
            Request::Diagnostics { .. } => DIAGNOSTICS,
            Request::ReadLong { .. } => READ_LONG,
            Request::WriteLong { .. } => WRITE_LONG,
            Request::Other { function, .. } => *function,
        }
    }

    /// Whether the request changes something in the slave, so that it may be broadcast.
    pub fn is_write(&self) -> bool {
        matches!(self, Request::WriteRegister { .. } | Request::WriteLong { .. })
            || matches!(self, Request::Diagnostics { sub: CLEAR_COUNTERS, .. })
    }

    /// The PDU on the wire.
    pub fn encode(&self) -> Vec<u8> {
        let mut pdu = vec![self.function()];
        match self {
            Request::ReadRegisters { start: a, count: b }
            | Request::WriteRegister { address: a, value: b }
            | Request::Diagnostics { sub: a, data: b } => {
                pdu.extend(a.to_be_bytes());
                pdu.extend(b.to_be_bytes());
            }
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
            WRITE_REGISTER => {
                let [address, value] = words(function, data)?;
                Request::WriteRegister { address, value }
            }
            DIAGNOSTICS => {
                let [sub, data] = words(function, data)?;
                Request::Diagnostics { sub, data }
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
            Request::ReadRegisters { .. } => ReplyEnd::CountAt(1),
            Request::WriteRegister { .. } | Request::Diagnostics { .. } | Request::ReadLong { .. } => {
                ReplyEnd::Fixed(5)
            }
            Request::WriteLong { .. } => ReplyEnd::Fixed(7),
            Request::Other { .. } => ReplyEnd::Silence,
        }
    }

    /// Whether `reply` can be the answer to this request: same function code, and echoed fields as they were sent.
    pub fn is_answered_by(&self, reply: &Reply) -> bool {
        match (self, reply) {
            (request, Reply::Exception { function, .. }) => request.function() == *function,
            (Request::ReadRegisters { count, .. }, Reply::Registers(values)) => values.len() == usize::from(*count),
            (Request::WriteRegister { address, value }, Reply::RegisterWritten { address: written, value: echoed }) => {
                address == written && value == echoed
            }
            (Request::Diagnostics { sub, .. }, Reply::Diagnostics { sub: echoed, .. }) => sub == echoed,
            (Request::ReadLong { .. }, Reply::Long(_)) => true,
            (Request::WriteLong { address, value }, Reply::LongWritten { address: written, value: echoed }) => {
                address == written && value == echoed
            }
            (Request::Other { function, .. }, Reply::Other { function: answered, .. }) => function == answered,
            _ => false,
        }
    }
}

impl Reply {
    /// Function code of the request that this answers.
    pub fn function(&self) -> u8 {
        match self {
            Reply::Registers(_) => READ_REGISTERS,
            Reply::RegisterWritten { .. } => WRITE_REGISTER,
            Reply::Diagnostics { .. } => DIAGNOSTICS,
            Reply::Long(_) => READ_LONG,
            Reply::LongWritten { .. } => WRITE_LONG,
            Reply::Exception { function, .. } | Reply::Other { function, .. } => *function,
        }
    }

    /// The PDU on the wire, as a slave sends it.
    pub fn encode(&self) -> Vec<u8> {
        let mut pdu = vec![self.function()];
        match self {
            Reply::Registers(values) => {
                pdu.push(u8::try_from(values.len() * 2).unwrap_or(u8::MAX));
                pdu.extend(values.iter().flat_map(|value| value.to_be_bytes()));
            }
            Reply::RegisterWritten { address: a, value: b } | Reply::Diagnostics { sub: a, data: b } => {
                pdu.extend(a.to_be_bytes());
                pdu.extend(b.to_be_bytes());
            }
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
            let &[code] = data else {
                return Err(PduError::Length { function, len: data.len(), expected: 1 });
            };
            return Ok(Reply::Exception { function: function & !EXCEPTION_BIT, code: Exception::from_code(code) });
        }
        Ok(match function {
            READ_REGISTERS => {
                let (&count, bytes) = data.split_first().ok_or(PduError::Length { function, len: 0, expected: 3 })?;
                if bytes.len() != usize::from(count) || count % 2 != 0 {
                    let expected = 1 + usize::from(count).next_multiple_of(2);
                    return Err(PduError::Length { function, len: data.len(), expected });
                }
                Reply::Registers(bytes.chunks_exact(2).map(be16).collect())
            }
            WRITE_REGISTER => {
                let [address, value] = words(function, data)?;
                Reply::RegisterWritten { address, value }
            }
            DIAGNOSTICS => {
                let [sub, data] = words(function, data)?;
                Reply::Diagnostics { sub, data }
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

fn split(pdu: &[u8]) -> Result<(u8, &[u8]), PduError> {
    if pdu.len() > MAX_PDU {
        return Err(PduError::TooLong { len: pdu.len() });
    }
    pdu.split_first().map(|(&function, data)| (function, data)).ok_or(PduError::Empty)
}

/// Exactly `N` big-endian words (CM-485 manual 6.4: the most significant byte comes first).
fn words<const N: usize>(function: u8, data: &[u8]) -> Result<[u16; N], PduError> {
    if data.len() != 2 * N {
        return Err(PduError::Length { function, len: data.len(), expected: 2 * N });
    }
    let mut words = [0; N];
    for (word, bytes) in words.iter_mut().zip(data.chunks_exact(2)) {
        *word = be16(bytes);
    }
    Ok(words)
}

fn be16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |word, &byte| word << 8 | u16::from(byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn address_word_of_the_manual() {
        let address = ParamAddress::new(2, 372).unwrap();
        assert_eq!(address.word(), 0x2174); // CM-485 manual 6.4.1
        assert_eq!((address.set(), address.number()), (2, 372));
        assert_eq!(ParamAddress::new(9, ParamAddress::LAST_NUMBER).unwrap().word(), 0x963F);
        assert_eq!(ParamAddress::new(0, 0x1000), None);
    }

    #[test]
    fn reply_length_is_known_from_the_request() {
        let read = Request::ReadRegisters { start: 0x2174, count: 1 };
        assert_eq!(read.reply_end().length(&[3]), None);
        assert_eq!(read.reply_end().length(&[3, 2]), Some(4));
        assert_eq!(read.reply_end().length(&[0x83]), Some(2));
        assert_eq!(Request::ReadLong { address: 1 }.reply_end().length(&[100]), Some(5));
    }

    #[test]
    fn an_echo_with_another_value_is_no_answer() {
        let write = Request::WriteRegister { address: 0x4178, value: 15 };
        assert!(write.is_answered_by(&Reply::RegisterWritten { address: 0x4178, value: 15 }));
        assert!(!write.is_answered_by(&Reply::RegisterWritten { address: 0x4178, value: 16 }));
        assert!(!write.is_answered_by(&Reply::Registers(vec![15])));
        assert!(write.is_answered_by(&Reply::Exception { function: 6, code: Exception::DeviceFailure }));
    }
}
