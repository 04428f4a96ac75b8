//! Modbus over TCP: a header with a transaction number in place of station, check value and silence.
//!
//! MODBUS Messaging on TCP/IP Implementation Guide V1.0b, 3.1: transaction number, protocol number 0, length of what
//! follows (all 16 bits, high byte first), unit (the station behind a gateway), then the PDU.

use super::{Adu, FrameError, MAX_PDU};

/// Bytes around the PDU: six of the header and the unit.
pub const OVERHEAD: usize = 7;

/// Puts a PDU for or from `station` into a frame.
pub fn encode(transaction: u16, station: u8, pdu: &[u8]) -> Vec<u8> {
    let length = u16::try_from(pdu.len() + 1).unwrap_or(u16::MAX);
    let mut frame = Vec::with_capacity(pdu.len() + OVERHEAD);
    frame.extend(transaction.to_be_bytes());
    frame.extend([0, 0]);
    frame.extend(length.to_be_bytes());
    frame.push(station);
    frame.extend(pdu);
    frame
}

/// Length of the whole frame that begins with `start`; `None` while it cannot be told.
pub fn length(start: &[u8]) -> Option<usize> {
    let length = u16::from_be_bytes([*start.get(4)?, *start.get(5)?]);
    Some(usize::from(length) + OVERHEAD - 1)
}

/// Takes exactly one whole frame apart: its transaction number, and what it carries.
pub fn decode(frame: &[u8]) -> Result<(u16, Adu), FrameError> {
    let &[t1, t0, p1, p0, _, _, station, ref pdu @ ..] = frame else {
        return Err(FrameError::TooShort { len: frame.len() });
    };
    let protocol = u16::from_be_bytes([p1, p0]);
    if protocol != 0 {
        return Err(FrameError::Check { expected: 0, got: protocol });
    }
    if pdu.is_empty() || length(frame).is_some_and(|length| length > frame.len()) {
        return Err(FrameError::TooShort { len: frame.len() });
    }
    if pdu.len() > MAX_PDU || length(frame).is_some_and(|length| length < frame.len()) {
        return Err(FrameError::TooLong { len: frame.len() });
    }
    Ok((u16::from_be_bytes([t1, t0]), Adu { station, pdu: pdu.to_vec() }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_go_both_ways() {
        let frame = encode(0x1501, 1, &[3, 0x21, 0x74, 0, 1]);
        assert_eq!(frame, [0x15, 0x01, 0, 0, 0, 6, 1, 3, 0x21, 0x74, 0, 1]);
        assert_eq!(length(&frame), Some(frame.len()));
        let adu = Adu { station: 1, pdu: vec![3, 0x21, 0x74, 0, 1] };
        assert_eq!(decode(&frame), Ok((0x1501, adu)));
    }

    #[test]
    fn other_lengths_and_protocols_are_no_frames() {
        let frame = encode(1, 1, &[3, 2, 5, 0x6E]);
        for length in 0..frame.len() {
            assert!(decode(&frame[..length]).is_err(), "{length}");
        }
        assert!(decode(&[frame.as_slice(), &[0]].concat()).is_err());
        let mut other = frame.clone();
        other[3] = 1;
        assert!(decode(&other).is_err());
    }
}
