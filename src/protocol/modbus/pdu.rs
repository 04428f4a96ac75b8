//! Protocol data units: function code and data, requests and replies, for master and slave.
//!
//! Codes 3, 6 and 8 follow MODBUS Application Protocol V1.1b3 (6.3, 6.6, 6.8) as narrowed by the CM-485 manual 6.4;
//! codes 100 and 101 are the maker's own (CM-485 manual 6.4.3, 6.4.4). Codes 16, 23 and 43/14 follow V1.1b3 (6.12, 6.17,
//! 6.21) and the LXM05 manual 5.2, with its lengths as corrected in facts G4. Any other code travels as raw data.

mod address;
mod end;
mod exception;
pub mod identification;
mod order;
#[cfg(test)]
mod tests;

pub use address::ParamAddress;
pub use end::ReplyEnd;
pub use exception::Exception;
pub use identification::Identification;
pub use order::WordOrder;

use super::MAX_PDU;

/// Function code 3: read holding registers (CM-485 manual 6.4.1: one 16-bit parameter).
pub const READ_REGISTERS: u8 = 3;
/// Function code 6: write a single register (CM-485 manual 6.4.2: one 16-bit parameter).
pub const WRITE_REGISTER: u8 = 6;
/// Function code 8: diagnostics (CM-485 manual 6.4.5).
pub const DIAGNOSTICS: u8 = 8;
/// Function code 16: write multiple registers (LXM05 manual 5.2.3).
pub const WRITE_REGISTERS: u8 = 16;
/// Function code 23: write multiple registers, then read others (LXM05 manual 5.2.4).
pub const EXCHANGE_REGISTERS: u8 = 23;
/// Function code 43: encapsulated interface; its type says what is inside (LXM05 manual 5.2.5).
pub const ENCAPSULATED: u8 = 43;
/// Type 14 of code 43: read device identification (LXM05 manual 5.2.5).
pub const IDENTIFICATION: u8 = 14;
/// Function code 100: read one 32-bit parameter, vendor code (CM-485 manual 6.4.3).
pub const READ_LONG: u8 = 100;
/// Function code 101: write one 32-bit parameter, vendor code (CM-485 manual 6.4.4).
pub const WRITE_LONG: u8 = 101;
/// Bit of the function code that marks an exception reply (CM-485 manual 6.5).
pub const EXCEPTION_BIT: u8 = 0x80;

/// Most registers that one telegram of code 3 or 23 reads (V1.1b3, 6.3, 6.17).
pub const MOST_READ: u16 = 125;
/// Most registers that one telegram of code 16 writes (V1.1b3, 6.12).
pub const MOST_WRITTEN: u16 = 123;
/// Most registers that one telegram of code 23 writes (V1.1b3, 6.17).
pub const MOST_EXCHANGED: u16 = 121;

/// Sub-function of code 8 that sends the data field back (LXM05 manual, table 5.2).
pub const ECHO: u16 = 0x00;
/// Sub-function of code 8 that starts the port anew, which ends "listen only" (LXM05 manual, table 5.2).
pub const RESTART_COMMUNICATION: u16 = 0x01;
/// Sub-function of code 8 that returns the diagnostic register: the number of the last synchronous error of an LXM05
/// (LXM05 manual, table 5.2).
pub const DIAGNOSTIC_REGISTER: u16 = 0x02;
/// Sub-function of code 8 that silences the slave; it does not answer (LXM05 manual, table 5.2; V1.1b3, 6.8.1).
pub const LISTEN_ONLY: u16 = 0x04;
/// Sub-function of code 8 that sets every counter to zero (CM-485 manual 6.4.5).
pub const CLEAR_COUNTERS: u16 = 0x0A;
/// Sub-functions of code 8 that return a counter (CM-485 manual 6.4.5).
pub const COUNTERS: std::ops::RangeInclusive<u16> = 0x0B..=0x12;

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
    /// Code 16.
    WriteRegisters {
        /// First register.
        start: u16,
        /// At most [`MOST_WRITTEN`] registers.
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
        /// At most [`MOST_EXCHANGED`] registers to write.
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
    /// The field that counts the bytes of a request contradicts its number of registers.
    #[error("function code {function}: {got} bytes announced for {count} registers")]
    ByteCount {
        /// Function code as it came.
        function: u8,
        /// Value of the field.
        got: u8,
        /// Number of registers in the same telegram.
        count: u16,
    },
    /// Longer than any PDU may be.
    #[error("PDU of {len} bytes, at most {MAX_PDU} are allowed")]
    TooLong {
        /// Length of the PDU.
        len: usize,
    },
}

impl Request {
    /// Function code of the request.
    pub fn function(&self) -> u8 {
        match self {
            Request::ReadRegisters { .. } => READ_REGISTERS,
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
            Request::ReadRegisters { .. } | Request::ExchangeRegisters { .. } => ReplyEnd::CountAt(1),
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

impl Reply {
    /// Function code of the request that this answers.
    pub fn function(&self) -> u8 {
        match self {
            Reply::Registers(_) => READ_REGISTERS,
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
            Reply::Registers(values) | Reply::RegistersExchanged(values) => put_bytes(&mut pdu, values),
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

fn split(pdu: &[u8]) -> Result<(u8, &[u8]), PduError> {
    if pdu.len() > MAX_PDU {
        return Err(PduError::TooLong { len: pdu.len() });
    }
    pdu.split_first().map(|(&function, data)| (function, data)).ok_or(PduError::Empty)
}

/// Number of registers, number of their bytes, registers.
fn put_values(pdu: &mut Vec<u8>, values: &[u16]) {
    pdu.extend(u16::try_from(values.len()).unwrap_or(u16::MAX).to_be_bytes());
    put_bytes(pdu, values);
}

/// Number of bytes, registers.
fn put_bytes(pdu: &mut Vec<u8>, values: &[u16]) {
    pdu.push(u8::try_from(values.len() * 2).unwrap_or(u8::MAX));
    pdu.extend(values.iter().flat_map(|value| value.to_be_bytes()));
}

/// Number of bytes, and `count` registers, of a request whose whole data are `data`.
fn take_values(function: u8, data: &[u8], count: u16, rest: &[u8]) -> Result<Vec<u16>, PduError> {
    let expected = data.len() - rest.len() + 1 + 2 * usize::from(count);
    match rest.split_first() {
        Some((&got, bytes)) if data.len() == expected && usize::from(got) == bytes.len() => {
            Ok(bytes.chunks_exact(2).map(be16).collect())
        }
        Some((&got, _)) if data.len() == expected => Err(PduError::ByteCount { function, got, count }),
        _ => Err(PduError::Length { function, len: data.len(), expected }),
    }
}

/// Number of bytes, and as many registers.
fn take_bytes(function: u8, data: &[u8]) -> Result<Vec<u16>, PduError> {
    let (&count, bytes) = data.split_first().ok_or(PduError::Length { function, len: 0, expected: 3 })?;
    if bytes.len() != usize::from(count) || count % 2 != 0 {
        let expected = 1 + usize::from(count).next_multiple_of(2);
        return Err(PduError::Length { function, len: data.len(), expected });
    }
    Ok(bytes.chunks_exact(2).map(be16).collect())
}

/// `N` big-endian words, and what follows them.
fn leading<const N: usize>(function: u8, data: &[u8]) -> Result<([u16; N], &[u8]), PduError> {
    let (head, rest) =
        data.split_at_checked(2 * N).ok_or(PduError::Length { function, len: data.len(), expected: 2 * N + 1 })?;
    Ok((words(function, head)?, rest))
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
