//! Telegrams of the data link layer: SD1 to SD4 and SC, with their check byte (IEC 61158-4-3; fieldbus facts, "Telegrams").

use super::control::Control;

/// A telegram without data: `10 DA SA FC FCS 16`.
const SD1: u8 = 0x10;
/// One of any length: `68 LE LE 68 DA SA FC … FCS 16`.
const SD2: u8 = 0x68;
/// One of eight bytes: `A2 DA SA FC … FCS 16`.
const SD3: u8 = 0xA2;
/// A token: `DC DA SA`.
const SD4: u8 = 0xDC;
/// The short acknowledgement, alone.
const SC: u8 = 0xE5;
/// Ends SD1, SD2 and SD3.
const ED: u8 = 0x16;
/// Bit 7 of an address: a service access point stands in front of the data.
const EXTENDED: u8 = 0x80;
/// Addresses and control byte.
const HEAD: usize = 3;
/// Bytes behind the head of SD3, access points among them.
const FIXED: usize = 8;
/// Bytes behind the head of SD2, access points among them: LE is 4 to 249.
pub const MOST: usize = 249 - HEAD;

/// A telegram.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Telegram {
    /// SC: understood, and there is nothing to say.
    Ack,
    /// SD4: the right to speak passes from one master to another.
    Token {
        /// Who gets it.
        to: u8,
        /// Who had it.
        from: u8,
    },
    /// SD1, SD2, SD3.
    Frame(Frame),
}

/// A telegram with a control byte.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Station that is spoken to, 0 to 127.
    pub to: u8,
    /// Station that speaks, 0 to 127.
    pub from: u8,
    /// Who asks or answers, and how.
    pub control: Control,
    /// Access point at the station that is spoken to.
    pub dsap: Option<u8>,
    /// Access point at the station that speaks.
    pub ssap: Option<u8>,
    /// What is carried, at most 246 bytes with the access points.
    pub data: Vec<u8>,
    /// Whether it is framed as SD3, which eight bytes may be and need not.
    pub is_fixed: bool,
}

/// Why bytes are no telegram.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum FrameError {
    /// The first byte begins no telegram.
    #[error("{0:02X}h begins no telegram of PROFIBUS (10h, 68h, A2h, DCh, E5h)")]
    Start(u8),
    /// Fewer bytes than the telegram has.
    #[error("{got} bytes, and the telegram has {expected}")]
    TooShort {
        /// Bytes that it has.
        expected: usize,
        /// Bytes that came.
        got: usize,
    },
    /// More bytes than the telegram has.
    #[error("{extra} bytes too many behind the telegram")]
    TooLong {
        /// How many.
        extra: usize,
    },
    /// The two lengths of SD2 differ, do not fit, or the second 68h is missing.
    #[error("length {first:02X}h {second:02X}h: it is said twice, 04h to F9h, between 68h and 68h")]
    Length {
        /// As it stands first.
        first: u8,
        /// As it is repeated.
        second: u8,
    },
    /// The check byte does not fit.
    #[error("check byte {got:02X}h, expected {expected:02X}h")]
    Check {
        /// What the bytes ask for.
        expected: u8,
        /// What came.
        got: u8,
    },
    /// The last byte is not 16h.
    #[error("{0:02X}h where the telegram ends with 16h")]
    End(u8),
    /// The control byte has bit 7 set.
    #[error("control byte {0:02X}h: bit 7 is always 0")]
    Control(u8),
    /// An address promises an access point, and there is no byte left for it.
    #[error("an address promises an access point that is missing")]
    AccessPoint,
}

/// The check byte: the sum of all bytes from the first address on.
pub fn fcs(bytes: &[u8]) -> u8 {
    bytes.iter().fold(0, |sum, byte| sum.wrapping_add(*byte))
}

/// Length of the telegram that begins with these bytes; `None` as long as they do not tell.
pub fn length(bytes: &[u8]) -> Result<Option<usize>, FrameError> {
    Ok(match bytes {
        [] => None,
        [SC, ..] => Some(1),
        [SD4, ..] => Some(HEAD),
        [SD1, ..] => Some(HEAD + 3),
        [SD3, ..] => Some(HEAD + FIXED + 3),
        &[SD2, first, second, again, ..] => {
            let fits = first == second && again == SD2 && (HEAD + 1..=HEAD + MOST).contains(&first.into());
            if !fits {
                return Err(FrameError::Length { first, second });
            }
            Some(usize::from(first) + 6)
        }
        [SD2, ..] => None,
        [other, ..] => return Err(FrameError::Start(*other)),
    })
}

/// Cuts bytes that came together into telegrams; what is none comes out as it is, up to the next byte that begins one.
pub fn cut(mut bytes: &[u8]) -> Vec<&[u8]> {
    let mut pieces = Vec::new();
    while !bytes.is_empty() {
        let lost = || (1..bytes.len()).find(|&at| bytes.get(at..).and_then(whole).is_some()).unwrap_or(bytes.len());
        let (piece, rest) = bytes.split_at(whole(bytes).unwrap_or_else(lost));
        pieces.push(piece);
        bytes = rest;
    }
    pieces
}

/// Length of the whole telegram that these bytes begin with.
fn whole(bytes: &[u8]) -> Option<usize> {
    let end = length(bytes).ok().flatten()?;
    Telegram::decode(bytes.get(..end)?).is_ok().then_some(end)
}

impl Telegram {
    /// Reads exactly one telegram.
    pub fn decode(bytes: &[u8]) -> Result<Self, FrameError> {
        let got = bytes.len();
        let expected = length(bytes)?.ok_or(FrameError::TooShort { expected: HEAD + 6, got })?;
        if got < expected {
            return Err(FrameError::TooShort { expected, got });
        }
        if got > expected {
            return Err(FrameError::TooLong { extra: got - expected });
        }
        match *bytes {
            [SC] => Ok(Telegram::Ack),
            [SD4, to, from] => Ok(Telegram::Token { to, from }),
            [SD2, _, _, _, ref inner @ .., check, end] => Frame::inner(inner, check, end, false),
            [start, ref inner @ .., check, end] => Frame::inner(inner, check, end, start == SD3),
            _ => Err(FrameError::TooShort { expected, got }),
        }
    }

    /// The bytes that say this.
    pub fn encode(&self) -> Vec<u8> {
        match self {
            Telegram::Ack => vec![SC],
            Telegram::Token { to, from } => vec![SD4, *to, *from],
            Telegram::Frame(frame) => frame.encode(),
        }
    }
}

impl Frame {
    fn inner(inner: &[u8], check: u8, end: u8, is_fixed: bool) -> Result<Telegram, FrameError> {
        if end != ED {
            return Err(FrameError::End(end));
        }
        let expected = fcs(inner);
        if check != expected {
            return Err(FrameError::Check { expected, got: check });
        }
        let [to, from, control, rest @ ..] = inner else {
            return Err(FrameError::TooShort { expected: HEAD, got: inner.len() });
        };
        let (dsap, rest) = access_point(*to, rest)?;
        let (ssap, rest) = access_point(*from, rest)?;
        let control = Control::decode(*control).ok_or(FrameError::Control(*control))?;
        let [to, from] = [to, from].map(|address| address & !EXTENDED);
        Ok(Telegram::Frame(Frame { to, from, control, dsap, ssap, data: rest.to_vec(), is_fixed }))
    }

    /// The bytes that say this; what does not fit into a telegram (see [`MOST`]) is cut off.
    fn encode(&self) -> Vec<u8> {
        let extended = |address: u8, sap: Option<u8>| address & !EXTENDED | if sap.is_some() { EXTENDED } else { 0 };
        let mut inner = vec![extended(self.to, self.dsap), extended(self.from, self.ssap), self.control.encode()];
        inner.extend(self.dsap.iter().chain(&self.ssap).chain(&self.data).take(MOST));
        let ends = [fcs(&inner), ED];
        let behind = inner.len() - HEAD;
        let start = match u8::try_from(inner.len()) {
            _ if behind == 0 => vec![SD1],
            _ if behind == FIXED && self.is_fixed => vec![SD3],
            Ok(length) => vec![SD2, length, length, SD2],
            Err(_) => Vec::new(), // 249 at most
        };
        [start, inner, ends.to_vec()].concat()
    }
}

/// The access point that an address promises, and what is behind it.
fn access_point(address: u8, rest: &[u8]) -> Result<(Option<u8>, &[u8]), FrameError> {
    match rest {
        _ if address & EXTENDED == 0 => Ok((None, rest)),
        [sap, rest @ ..] => Ok((Some(*sap), rest)),
        [] => Err(FrameError::AccessPoint),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Telegrams of real devices (fieldbus facts, "Golden telegrams").
    const GOLDEN: [&[u8]; 7] = [
        &[0x10, 0x08, 0x02, 0x49, 0x53, 0x16],
        &[0x10, 0x02, 0x08, 0x00, 0x0A, 0x16],
        &[0x68, 0x05, 0x05, 0x68, 0x88, 0x82, 0x6D, 0x3C, 0x3E, 0xF1, 0x16],
        &[0x68, 0x0B, 0x0B, 0x68, 0x82, 0x88, 0x08, 0x3E, 0x3C, 2, 5, 0, 0xFF, 0x0A, 0x35, 0xD1, 0x16],
        &[
            0x68, 0x13, 0x13, 0x68, 0x88, 0x82, 0x5D, 0x3D, 0x3E, 0xB8, 0x1E, 1, 0, 0x0A, 0x35, 1, 0, 0, 0, 0x82, 0, 0,
            0, 0x7B, 0x16,
        ],
        &[0x68, 0x06, 0x06, 0x68, 0x88, 0x82, 0x7D, 0x3E, 0x3E, 0x21, 0x24, 0x16],
        &[0x68, 0x0B, 0x0B, 0x68, 0x82, 0x8A, 0x08, 0x3E, 0x3C, 6, 5, 0, 0xFF, 0x0F, 0x84, 0x2B, 0x16],
    ];

    #[test]
    fn telegrams_of_real_devices_are_read_and_made_again() {
        for bytes in GOLDEN {
            assert_eq!(Telegram::decode(bytes).unwrap().encode(), bytes);
        }
        assert_eq!(cut(&GOLDEN.concat()), GOLDEN);
        let Telegram::Frame(diag) = Telegram::decode(GOLDEN[2]).unwrap() else { panic!() };
        assert_eq!((diag.to, diag.from, diag.dsap, diag.ssap, diag.data.len()), (8, 2, Some(60), Some(62), 0));
    }

    #[test]
    fn what_is_wrong_with_a_telegram_is_named() {
        let decode = |bytes: &[u8]| Telegram::decode(bytes).unwrap_err();
        assert_eq!(decode(&[0x10, 8, 2, 0x49, 0x54, 0x16]), FrameError::Check { expected: 0x53, got: 0x54 });
        assert_eq!(decode(&[0x10, 8, 2, 0x49, 0x53, 0x17]), FrameError::End(0x17));
        assert_eq!(decode(&[0x10, 8, 2]), FrameError::TooShort { expected: 6, got: 3 });
        assert_eq!(decode(&[0xE5, 0xE5]), FrameError::TooLong { extra: 1 });
        assert_eq!(decode(&[0x68, 5, 6, 0x68]), FrameError::Length { first: 5, second: 6 });
        assert_eq!(decode(&[0x68, 3, 3, 0x68, 0, 0, 0, 0, 0x16]), FrameError::Length { first: 3, second: 3 });
        assert_eq!(decode(&[0x10, 0x88, 2, 0x49, 0xD3, 0x16]), FrameError::AccessPoint);
        assert_eq!(decode(&[0x10, 8, 2, 0xC9, 0xD3, 0x16]), FrameError::Control(0xC9));
        assert_eq!(decode(&[0x55]), FrameError::Start(0x55));
    }

    #[test]
    fn noise_between_telegrams_is_a_piece_of_its_own() {
        let bytes = [&[0, 0x68][..], GOLDEN[0], &[0xFF], &[0xE5], &[0x10]].concat();
        assert_eq!(cut(&bytes), [&[0, 0x68][..], GOLDEN[0], &[0xFF], &[0xE5], &[0x10]]);
    }

    fn frames() -> impl Strategy<Value = Frame> {
        let sap = || proptest::option::of(any::<u8>());
        let data = proptest::collection::vec(any::<u8>(), 0..=MOST - 2);
        (0_u8..128, 0_u8..128, 0_u8..128, sap(), sap(), data, any::<bool>()).prop_map(
            |(to, from, control, dsap, ssap, data, is_fixed)| {
                let control = Control::decode(control).unwrap();
                let behind = data.len() + usize::from(dsap.is_some()) + usize::from(ssap.is_some());
                Frame { to, from, control, dsap, ssap, data, is_fixed: is_fixed && behind == FIXED }
            },
        )
    }

    /// Eight bytes may be framed either way, and it is told which.
    #[test]
    fn what_is_framed_as_sd3_is_known_as_that() {
        for is_fixed in [true, false] {
            let control = Control::decode(8).unwrap();
            let frame = Frame { to: 3, from: 0, control, dsap: None, ssap: None, data: vec![7; FIXED], is_fixed };
            let bytes = Telegram::Frame(frame.clone()).encode();
            assert_eq!((bytes[0] == SD3, Telegram::decode(&bytes)), (is_fixed, Ok(Telegram::Frame(frame))));
        }
    }

    proptest! {
        #[test]
        fn every_frame_comes_back_as_it_was(frame in frames()) {
            let telegram = Telegram::Frame(frame);
            prop_assert_eq!(Telegram::decode(&telegram.encode()), Ok(telegram));
        }

        #[test]
        fn no_bytes_bring_the_codec_down(
            start in proptest::sample::select(vec![SD1, SD2, SD3, SD4, SC, 0]),
            rest in proptest::collection::vec(any::<u8>(), 0..300),
        ) {
            let bytes = [&[start], &rest[..]].concat();
            let _ = Telegram::decode(&bytes);
            prop_assert_eq!(cut(&bytes).concat(), bytes);
        }

        #[test]
        fn one_flipped_bit_is_seen(frame in frames(), at in any::<proptest::sample::Index>(), bit in 0_u32..8) {
            let telegram = Telegram::Frame(frame);
            let mut bytes = telegram.encode();
            let at = at.index(bytes.len());
            bytes[at] ^= 1 << bit;
            prop_assert_ne!(Telegram::decode(&bytes), Ok(telegram));
        }
    }
}
