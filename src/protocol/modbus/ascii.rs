//! ASCII frames: `:`, hexadecimal digits, LRC, CR LF (MODBUS over Serial Line V1.02, 2.5.2; CM-485 manual 6.7.2).
//!
//! Digits go out in upper case and come in in either case.

use super::{Adu, FrameError, MAX_PDU};
use crate::protocol::check::lrc;
use crate::tick::{Span, Tick};

/// Start of frame.
pub const START: u8 = b':';
/// End of frame.
pub const END: &[u8; 2] = b"\r\n";
/// Longest frame: start, two digits for station, PDU and LRC each, end.
pub const MAX_FRAME: usize = 1 + 2 * (1 + MAX_PDU + 1) + 2;
/// Longest pause between two characters of one frame (CM-485 manual 6.7.2.2).
pub const MAX_PAUSE: Span = Span::from_secs(1);

/// The frame for `station` around `pdu`.
pub fn encode(station: u8, pdu: &[u8]) -> Vec<u8> {
    let mut body = vec![station];
    body.extend(pdu);
    body.push(lrc(&body));
    let digits = body.iter().flat_map(|byte| [digit(byte >> 4), digit(byte & 0x0F)]);
    std::iter::once(START).chain(digits).chain(END.iter().copied()).collect()
}

/// Takes exactly one whole frame, from `:` to LF, apart.
pub fn decode(frame: &[u8]) -> Result<Adu, FrameError> {
    if frame.len() > MAX_FRAME {
        return Err(FrameError::TooLong { len: frame.len() });
    }
    let digits = frame.strip_prefix(&[START]).and_then(|rest| rest.strip_suffix(END)).ok_or(FrameError::Delimiter)?;
    let body = digits.chunks(2).map(byte).collect::<Result<Vec<u8>, _>>()?;
    let too_short = FrameError::TooShort { len: frame.len() };
    let (&got, body) = body.split_last().ok_or(too_short.clone())?;
    let (&station, pdu) = body.split_first().ok_or(too_short.clone())?;
    if pdu.is_empty() {
        return Err(too_short);
    }
    let expected = lrc(body);
    if expected != got {
        return Err(FrameError::Check { expected: expected.into(), got: got.into() });
    }
    Ok(Adu { station, pdu: pdu.to_vec() })
}

fn digit(nibble: u8) -> u8 {
    char::from_digit(nibble.into(), 16).map_or(b'0', |digit| digit.to_ascii_uppercase() as u8)
}

fn byte(pair: &[u8]) -> Result<u8, FrameError> {
    let nibble = |&byte: &u8| char::from(byte).to_digit(16).ok_or(FrameError::Digit { byte });
    match pair {
        [high, low] => Ok((nibble(high)? << 4 | nibble(low)?) as u8),
        [single, ..] => Err(FrameError::Digit { byte: *single }),
        [] => Err(FrameError::Delimiter),
    }
}

/// Cuts a stream of characters into frames; the same frames come out however the stream is split into chunks.
///
/// What stands before a `:` is dropped and counted; a new `:` starts over; a pause of more than a second between two
/// characters drops what was begun. Characters are taken modulo 0x80, because some drivers leave the parity bit in.
#[derive(Clone, Debug, Default)]
pub struct Receiver {
    frame: Vec<u8>,
    last: Tick,
    dropped: u64,
}

impl Receiver {
    /// Takes a character that was complete at `at`; returns the frame that it completes, from `:` to LF.
    pub fn feed(&mut self, at: Tick, byte: u8) -> Option<Vec<u8>> {
        let byte = byte & 0x7F;
        if at.since(self.last) > MAX_PAUSE {
            self.drop_frame();
        }
        self.last = at;
        if byte == START {
            self.drop_frame();
        } else if self.frame.is_empty() || self.frame.len() >= MAX_FRAME {
            self.drop_frame();
            self.dropped += 1;
            return None;
        }
        self.frame.push(byte);
        self.frame.ends_with(END).then(|| std::mem::take(&mut self.frame))
    }

    /// Characters of the frame that has begun.
    pub fn pending(&self) -> &[u8] {
        &self.frame
    }

    /// Characters that belonged to no complete frame so far.
    pub fn dropped(&self) -> u64 {
        self.dropped
    }

    fn drop_frame(&mut self) {
        self.dropped += self.frame.len() as u64;
        self.frame.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn either_case_comes_in_and_upper_case_goes_out() {
        let frame = encode(1, &[0x83, 0x02]);
        assert_eq!(frame, b":0183027A\r\n");
        let adu = Adu { station: 1, pdu: vec![0x83, 0x02] };
        assert_eq!(decode(b":0183027a\r\n"), Ok(adu));
    }

    #[test]
    fn what_is_no_frame_is_named() {
        assert_eq!(decode(b"0183027A\r\n"), Err(FrameError::Delimiter));
        assert_eq!(decode(b":0183027X\r\n"), Err(FrameError::Digit { byte: b'X' }));
        assert_eq!(decode(b":018302 7A\r\n"), Err(FrameError::Digit { byte: b' ' }));
        assert_eq!(decode(b":01830279\r\n"), Err(FrameError::Check { expected: 0x7A, got: 0x79 }));
        assert_eq!(decode(b":01FF\r\n"), Err(FrameError::TooShort { len: 7 }));
    }

    /// A second is the longest pause (V1.02 2.5.2.1), and 513 characters are the longest frame.
    #[test]
    fn a_frame_ends_by_a_pause_and_by_its_length() {
        let pause = |span: Span| {
            let mut receiver = Receiver::default();
            let at = Tick::from_micros(5);
            receiver.feed(at, b':');
            receiver.feed(at + span, b'0');
            receiver.pending().len()
        };
        assert_eq!([MAX_PAUSE, MAX_PAUSE + Span::from_micros(1)].map(pause), [2, 0]);
        let mut receiver = Receiver::default();
        let mut feed = |byte| {
            receiver.feed(Tick::ZERO, byte);
            (receiver.pending().len(), receiver.dropped())
        };
        assert_eq!([feed(b'x'), feed(b':'), feed(b'0')], [(0, 1), (1, 1), (2, 1)]);
        let longest = (2..MAX_FRAME).map(|_| feed(b'0')).last();
        assert_eq!((longest, feed(b'0')), (Some((MAX_FRAME, 1)), (0, 2 + MAX_FRAME as u64)));
    }

    #[test]
    fn noise_before_the_colon_is_dropped() {
        let mut receiver = Receiver::default();
        let stream = b"\x00x:01\x80:0183027A\r\n";
        let frames: Vec<_> =
            stream.iter().enumerate().filter_map(|(i, &b)| receiver.feed(Tick::from_micros(i as u64), b)).collect();
        assert_eq!(frames, [b":0183027A\r\n".to_vec()]);
        assert_eq!(receiver.dropped(), 6);
    }
}
