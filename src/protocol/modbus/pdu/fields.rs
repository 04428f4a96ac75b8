//! Words, registers and their counts on the wire, and why they are none.

use crate::protocol::modbus::MAX_PDU;

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

pub(super) fn split(pdu: &[u8]) -> Result<(u8, &[u8]), PduError> {
    if pdu.len() > MAX_PDU {
        return Err(PduError::TooLong { len: pdu.len() });
    }
    pdu.split_first().map(|(&function, data)| (function, data)).ok_or(PduError::Empty)
}

/// Number of registers, number of their bytes, registers.
pub(super) fn put_values(pdu: &mut Vec<u8>, values: &[u16]) {
    pdu.extend(u16::try_from(values.len()).unwrap_or(u16::MAX).to_be_bytes());
    put_bytes(pdu, values);
}

/// Number of bytes, registers.
pub(super) fn put_bytes(pdu: &mut Vec<u8>, values: &[u16]) {
    pdu.push(u8::try_from(values.len() * 2).unwrap_or(u8::MAX));
    pdu.extend(values.iter().flat_map(|value| value.to_be_bytes()));
}

/// Number of bytes, and `count` registers, of a request whose whole data are `data`.
pub(super) fn take_values(function: u8, data: &[u8], count: u16, rest: &[u8]) -> Result<Vec<u16>, PduError> {
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
pub(super) fn take_bytes(function: u8, data: &[u8]) -> Result<Vec<u16>, PduError> {
    let (&count, bytes) = data.split_first().ok_or(PduError::Length { function, len: 0, expected: 3 })?;
    if bytes.len() != usize::from(count) || count % 2 != 0 {
        let expected = 1 + usize::from(count).next_multiple_of(2);
        return Err(PduError::Length { function, len: data.len(), expected });
    }
    Ok(bytes.chunks_exact(2).map(be16).collect())
}

/// `N` big-endian words, and what follows them.
pub(super) fn leading<const N: usize>(function: u8, data: &[u8]) -> Result<([u16; N], &[u8]), PduError> {
    let (head, rest) =
        data.split_at_checked(2 * N).ok_or(PduError::Length { function, len: data.len(), expected: 2 * N + 1 })?;
    Ok((words(function, head)?, rest))
}

/// Exactly `N` big-endian words (CM-485 manual 6.4: the most significant byte comes first).
pub(super) fn words<const N: usize>(function: u8, data: &[u8]) -> Result<[u16; N], PduError> {
    if data.len() != 2 * N {
        return Err(PduError::Length { function, len: data.len(), expected: 2 * N });
    }
    let mut words = [0; N];
    for (word, bytes) in words.iter_mut().zip(data.chunks_exact(2)) {
        *word = be16(bytes);
    }
    Ok(words)
}

pub(super) fn be16(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0, |word, &byte| word << 8 | u16::from(byte))
}
