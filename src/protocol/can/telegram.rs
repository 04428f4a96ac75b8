//! A frame of SDO as bytes: its identifier, and all eight of its data. What a conversation says and hears in place of characters.

use super::frame::{Body, Frame, Identifier, Payload};
use super::identifier::{LAST_DRIVE, SdoChannel, Service};
use crate::tick::Span;

/// A frame of eight bytes under an identifier of 11 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Telegram {
    /// Its identifier.
    pub identifier: u16,
    /// Its data.
    pub data: [u8; Payload::MOST],
}

impl Telegram {
    /// Bytes of it: two of the identifier, most significant first, and the data.
    pub const LEN: usize = 10;

    /// A question to a station over a channel; `None` for one that no drive has.
    pub fn request(channel: SdoChannel, station: u8, data: [u8; Payload::MOST]) -> Option<Self> {
        let node = match station {
            MASTER_STATION => 0,
            1..=LAST_DRIVE => station,
            _ => return None,
        };
        Some(Telegram { identifier: Service::SdoRequest(channel, node).identifier()?, data })
    }

    /// `None` for a frame of anything but 11 bits and eight bytes.
    pub fn of(frame: &Frame) -> Option<Self> {
        match (frame.identifier, &frame.body) {
            (Identifier::Standard(identifier), Body::Data(payload)) => {
                Some(Telegram { identifier, data: payload.eight()? })
            }
            _ => None,
        }
    }

    /// `None` for bytes that are none.
    pub fn decode(bytes: &[u8]) -> Option<Self> {
        let (head, data) = bytes.split_first_chunk()?;
        let identifier = u16::from_be_bytes(*head);
        let data = data.try_into().ok()?;
        (identifier <= Identifier::MAX_STANDARD).then_some(Telegram { identifier, data })
    }

    /// The bytes for a frame of 11 bits with fewer than eight, so that they stand among whole ones and are taken for none: it is marked where
    /// no identifier reaches, with its length, and the rest is zero.
    pub fn cut_short(frame: &Frame) -> Option<[u8; Self::LEN]> {
        let (Identifier::Standard(identifier), Body::Data(payload)) = (frame.identifier, &frame.body) else {
            return None;
        };
        let len = u16::try_from(payload.bytes().len()).ok().filter(|len| *len < Payload::MOST as u16)?;
        let mut data = [0; Payload::MOST];
        data.iter_mut().zip(payload.bytes()).for_each(|(place, byte)| *place = *byte);
        Some(Telegram { identifier: SHORT | len << LENGTH_AT | identifier, data }.encode())
    }

    /// Its bytes.
    pub fn encode(&self) -> [u8; Self::LEN] {
        let [high, low] = self.identifier.to_be_bytes();
        let [a, b, c, d, e, f, g, h] = self.data;
        [high, low, a, b, c, d, e, f, g, h]
    }

    /// The frame that carries it.
    pub fn frame(&self) -> Frame {
        Frame { identifier: Identifier::Standard(self.identifier), body: Body::Data(self.data.into()) }
    }

    /// What its identifier is for.
    pub fn service(&self) -> Service {
        Service::of(self.identifier)
    }
}

/// The station that a drive with node 0 has in a conversation, where 0 is everybody: no drive has this node (EM-RES-03 manual 5.5).
pub const MASTER_STATION: u8 = LAST_DRIVE + 1;

/// The station of a drive with this node.
pub fn station(node: u8) -> u8 {
    if node == 0 { MASTER_STATION } else { node }
}

/// Of a frame that was too short, above its identifier.
const SHORT: u16 = 1 << 15;
const LENGTH_AT: u32 = 12;

/// The frame that bytes stand for: two of the identifier, most significant first, and up to eight of data; or one that was too short
/// ([`Telegram::cut_short`]).
pub fn telegram_frame(bytes: &[u8]) -> Option<Frame> {
    let (head, data) = bytes.split_first_chunk()?;
    let head = u16::from_be_bytes(*head);
    if head & SHORT == 0 {
        return Frame::data(head, data);
    }
    let len = usize::from((head & !SHORT) >> LENGTH_AT);
    Frame::data(head & Identifier::MAX_STANDARD, data.get(..len)?)
}

/// Bits of a frame of 11 bits around its data, with the three between frames (ISO 11898-1), and those of each byte.
const AROUND: u64 = 47;
const BITS_PER_BYTE: u64 = 8;
/// Bits of a frame that may be stuffed, without its data: after every four of them at most one is (ISO 11898-1).
const STUFFED: u64 = 34;

/// The longest that a frame of so many bytes takes on a bus.
pub fn duration(bit_rate: u32, bytes: u64) -> Span {
    let data = bytes * BITS_PER_BYTE;
    let bits = AROUND + data + (STUFFED + data - 1) / 4;
    Span::from_micros((bits * 1_000_000).div_ceil(u64::from(bit_rate.max(1))))
}
