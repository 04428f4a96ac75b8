//! RTU frames: station, PDU, CRC-16 with the low byte first; telegrams are parted by silence
//! (MODBUS over Serial Line V1.02, 2.5.1; CM-485 manual 6.7.1).

use super::{Adu, FrameError};
use crate::protocol::check::crc16;
use crate::protocol::line::LineSetting;
use crate::tick::Tick;

/// Longest frame (CM-485 manual 6.7.1.2).
pub const MAX_FRAME: usize = 256;
/// Shortest frame: station, function code, CRC.
pub const MIN_FRAME: usize = 4;
/// Bytes that the frame adds to the PDU: station before it, CRC after it.
pub const OVERHEAD: usize = 3;

/// The frame for `station` around `pdu`.
pub fn encode(station: u8, pdu: &[u8]) -> Vec<u8> {
    let mut frame = Vec::with_capacity(pdu.len() + OVERHEAD);
    frame.push(station);
    frame.extend(pdu);
    frame.extend(crc16(&frame).to_le_bytes());
    frame
}

/// Takes exactly one whole frame apart.
pub fn decode(frame: &[u8]) -> Result<Adu, FrameError> {
    if frame.len() < MIN_FRAME {
        return Err(FrameError::TooShort { len: frame.len() });
    }
    if frame.len() > MAX_FRAME {
        return Err(FrameError::TooLong { len: frame.len() });
    }
    let (body, &[low, high]) = frame.split_last_chunk::<2>().ok_or(FrameError::TooShort { len: frame.len() })?;
    let (expected, got) = (crc16(body), u16::from_le_bytes([low, high]));
    if expected != got {
        return Err(FrameError::Check { expected, got });
    }
    let (&station, pdu) = body.split_first().ok_or(FrameError::TooShort { len: frame.len() })?;
    Ok(Adu { station, pdu: pdu.to_vec() })
}

/// Cuts a line into frames by its silences, as a slave or a listener does.
///
/// Feed every byte with the time at which its last bit was on the wire, then ask [`Receiver::idle`] as time passes.
#[derive(Clone, Debug)]
pub struct Receiver {
    line: LineSetting,
    frame: Vec<u8>,
    last: Tick,
    broken: bool,
}

/// What stood between two silences.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Burst {
    /// The bytes, at most one more than a frame may have.
    pub bytes: Vec<u8>,
    /// A pause of more than 1.5 characters was inside, so slaves discard it.
    pub broken: bool,
}

impl Receiver {
    /// A receiver on a line with this setting.
    pub fn new(line: LineSetting) -> Self {
        Receiver { line, frame: Vec::new(), last: Tick::ZERO, broken: false }
    }

    /// Takes a byte whose last bit was on the wire at `at`. Returns the burst before it, if a silence parted the two.
    pub fn feed(&mut self, at: Tick, byte: u8) -> Option<Burst> {
        let started = Tick::from_micros(at.as_micros().saturating_sub(self.line.chars(1).as_micros()));
        let before = self.idle(started);
        if before.is_none() && !self.frame.is_empty() && started.since(self.last) > self.line.t15() {
            self.broken = true;
        }
        if self.frame.len() <= MAX_FRAME {
            self.frame.push(byte);
        }
        self.last = at;
        before
    }

    /// When the present burst will be over if nothing more comes.
    pub fn ends(&self) -> Option<Tick> {
        (!self.frame.is_empty()).then(|| self.last + self.line.t35())
    }

    /// The burst that was over before or at `now`.
    pub fn idle(&mut self, now: Tick) -> Option<Burst> {
        (self.ends()? <= now)
            .then(|| Burst { bytes: std::mem::take(&mut self.frame), broken: std::mem::take(&mut self.broken) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;
    use crate::tick::Span;

    #[test]
    fn silences_part_frames_and_gaps_break_them() {
        let line = LineSetting::rtu(19_200, Parity::Even);
        let mut receiver = Receiver::new(line);
        let mut at = Tick::from_micros(10_000);
        for byte in [1, 2, 3] {
            at += line.chars(1);
            assert_eq!(receiver.feed(at, byte), None);
        }
        at += line.chars(1) + line.t15() + Span::from_micros(10);
        assert_eq!(receiver.feed(at, 4), None);
        assert_eq!(receiver.idle(at + Span::from_micros(2_005)), None);
        let burst = receiver.idle(at + line.t35()).unwrap();
        assert_eq!(burst, Burst { bytes: vec![1, 2, 3, 4], broken: true });
        assert_eq!(receiver.ends(), None);
    }

    /// 1.5 characters break nothing yet; one byte more than a frame may have tells that it is none.
    #[test]
    fn a_frame_is_broken_by_more_than_a_pause_and_told_as_too_long() {
        let line = LineSetting::rtu(19_200, Parity::Even);
        let pause = |span: Span| {
            let mut receiver = Receiver::new(line);
            let at = Tick::from_micros(10_000);
            receiver.feed(at, 1);
            receiver.feed(at + span + line.chars(1), 2);
            receiver.idle(at + Span::from_secs(1)).unwrap().broken
        };
        assert_eq!([line.t15(), line.t15() + Span::from_micros(1)].map(pause), [false, true]);
        let mut receiver = Receiver::new(line);
        let mut at = Tick::from_micros(10_000);
        for _ in 0..MAX_FRAME + 9 {
            at += line.chars(1);
            receiver.feed(at, 0);
        }
        assert_eq!(receiver.idle(at + line.t35()).unwrap().bytes.len(), MAX_FRAME + 1);
    }
}
