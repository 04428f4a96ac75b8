//! Service data objects: parameters over CAN, as a drive speaks them and as CiA 301 (7.2.4.3) says.
//!
//! A drive (EM-RES-03 manual 5.10.1) takes only what fits in one frame. Index = parameter, sub-index = data set. Its reply to a
//! read is always 42h with four bytes: no width is told. Its aborts carry a code of its error register in byte 4 and zeros
//! behind it. Whatever it says, CiA 301 has a form for it, so one codec reads both.

/// Whose value it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Multiplexer {
    /// Parameter, or object of CANopen.
    pub index: u16,
    /// Data set, or sub-index.
    pub sub: u8,
}

/// How a transfer of a value begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Initiate {
    /// The value itself, in up to four bytes.
    Expedited {
        /// Least significant first; what counts of them nobody says if `size` is `None`.
        bytes: [u8; 4],
        /// How many of them count, if it is told.
        size: Option<u8>,
    },
    /// The value follows in segments.
    Segmented {
        /// Its bytes, if it is told.
        size: Option<u32>,
    },
}

impl Initiate {
    /// Two bytes: uint, int. Told as such, because strict servers want it; a drive ignores it (manual 5.10.1).
    pub fn word(word: u16) -> Self {
        let [low, high] = word.to_le_bytes();
        Initiate::Expedited { bytes: [low, high, 0, 0], size: Some(2) }
    }

    /// Four bytes.
    pub fn long(long: u32) -> Self {
        Initiate::Expedited { bytes: long.to_le_bytes(), size: Some(4) }
    }

    /// Four bytes whose width nobody tells, as every reply of a drive.
    pub fn untold(long: u32) -> Self {
        Initiate::Expedited { bytes: long.to_le_bytes(), size: None }
    }

    fn decode(command: u8, data: [u8; 4]) -> Self {
        let (is_told, unused) = (command & SIZE_TOLD != 0, (command >> 2) & 3);
        if command & EXPEDITED != 0 {
            return Initiate::Expedited { bytes: data, size: is_told.then_some(4 - unused) };
        }
        Initiate::Segmented { size: is_told.then_some(u32::from_le_bytes(data)) }
    }

    /// The bits of the command byte, and the data.
    fn encode(self) -> (u8, [u8; 4]) {
        match self {
            Initiate::Expedited { bytes, size: Some(size) } => {
                (EXPEDITED | SIZE_TOLD | (4u8.saturating_sub(size) & 3) << 2, bytes)
            }
            Initiate::Expedited { bytes, size: None } => (EXPEDITED, bytes),
            Initiate::Segmented { size: Some(size) } => (SIZE_TOLD, size.to_le_bytes()),
            Initiate::Segmented { size: None } => (0, [0; 4]),
        }
    }
}

const EXPEDITED: u8 = 2;
const SIZE_TOLD: u8 = 1;

/// A piece of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Segment {
    /// Changes from segment to segment.
    pub toggle: bool,
    /// Nothing follows.
    pub is_last: bool,
    bytes: [u8; 7],
    len: u8,
}

impl Segment {
    /// A segment of up to seven bytes.
    pub fn new(toggle: bool, is_last: bool, bytes: &[u8]) -> Option<Self> {
        let mut segment = Segment { toggle, is_last, bytes: [0; 7], len: u8::try_from(bytes.len()).ok()? };
        segment.bytes.get_mut(..bytes.len())?.copy_from_slice(bytes);
        Some(segment)
    }

    /// What it carries.
    pub fn bytes(&self) -> &[u8] {
        self.bytes.get(..self.len.into()).unwrap_or_default()
    }

    fn decode(command: u8, data: [u8; 7]) -> Option<Self> {
        let len = 7usize.checked_sub(usize::from((command >> 1) & 7))?;
        Segment::new(command & TOGGLE != 0, command & 1 != 0, data.get(..len)?)
    }

    fn encode(&self) -> (u8, [u8; 7]) {
        (toggled(self.toggle) | (7 - self.len.min(7)) << 1 | u8::from(self.is_last), self.bytes)
    }
}

const TOGGLE: u8 = 0x10;

fn toggled(toggle: bool) -> u8 {
    if toggle { TOGGLE } else { 0 }
}

/// Why a transfer was ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct AbortCode(pub u32);

impl AbortCode {
    /// The code of the error register, if it is a drive's (manual 5.10.1: byte 4, zeros behind it).
    pub fn of_a_drive(self) -> Option<u8> {
        u8::try_from(self.0).ok().filter(|code| *code != 0)
    }
}

/// What a server is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Request {
    /// Write a value.
    Download(Multiplexer, Initiate),
    /// The next piece of what is written.
    DownloadSegment(Segment),
    /// Read a value.
    Upload(Multiplexer),
    /// The next piece of what is read, please.
    UploadSegment {
        /// Changes from segment to segment.
        toggle: bool,
    },
    /// The client gives up.
    Abort(Multiplexer, AbortCode),
    /// A block transfer, or nothing at all; the first byte. No drive takes it.
    Other(u8),
}

/// What a server answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reply {
    /// The value was written, or its segments may come.
    Downloaded(Multiplexer),
    /// The piece was taken.
    SegmentDownloaded {
        /// Of the piece.
        toggle: bool,
    },
    /// The value, or how long it is.
    Upload(Multiplexer, Initiate),
    /// The next piece.
    UploadSegment(Segment),
    /// Refused.
    Abort(Multiplexer, AbortCode),
    /// A block transfer, or nothing at all; the first byte.
    Other(u8),
}

/// Command specifiers in the top three bits: of the client, and of the server (CiA 301 7.2.4.3).
const CLIENT: Specifiers =
    Specifiers { initiate_download: 1, download_segment: 0, initiate_upload: 2, upload_segment: 3 };
const SERVER: Specifiers =
    Specifiers { initiate_download: 3, download_segment: 1, initiate_upload: 2, upload_segment: 0 };
const ABORT: u8 = 4;

struct Specifiers {
    initiate_download: u8,
    download_segment: u8,
    initiate_upload: u8,
    upload_segment: u8,
}

/// The parts of eight bytes: command, multiplexer, data.
fn parts(bytes: [u8; 8]) -> (u8, Multiplexer, [u8; 4], [u8; 7]) {
    let [command, low, high, sub, a, b, c, d] = bytes;
    let of = Multiplexer { index: u16::from_le_bytes([low, high]), sub };
    (command, of, [a, b, c, d], [low, high, sub, a, b, c, d])
}

fn initiated(specifier: u8, bits: u8, of: Multiplexer, [a, b, c, d]: [u8; 4]) -> [u8; 8] {
    let [low, high] = of.index.to_le_bytes();
    [specifier << 5 | bits, low, high, of.sub, a, b, c, d]
}

fn segmented(specifier: u8, bits: u8, [a, b, c, d, e, f, g]: [u8; 7]) -> [u8; 8] {
    [specifier << 5 | bits, a, b, c, d, e, f, g]
}

impl Request {
    /// Reads the eight bytes of a frame to a server.
    pub fn decode(bytes: [u8; 8]) -> Self {
        let (command, of, data, segment) = parts(bytes);
        let specifier = command >> 5;
        let other = Request::Other(command);
        match specifier {
            _ if specifier == CLIENT.initiate_download => Request::Download(of, Initiate::decode(command, data)),
            _ if specifier == CLIENT.download_segment => {
                Segment::decode(command, segment).map_or(other, Request::DownloadSegment)
            }
            _ if specifier == CLIENT.initiate_upload => Request::Upload(of),
            _ if specifier == CLIENT.upload_segment => Request::UploadSegment { toggle: command & TOGGLE != 0 },
            ABORT => Request::Abort(of, AbortCode(u32::from_le_bytes(data))),
            _ => other,
        }
    }

    /// The eight bytes of the frame.
    pub fn encode(&self) -> [u8; 8] {
        match self {
            Request::Download(of, initiate) => {
                let (bits, data) = initiate.encode();
                initiated(CLIENT.initiate_download, bits, *of, data)
            }
            Request::DownloadSegment(segment) => {
                let (bits, data) = segment.encode();
                segmented(CLIENT.download_segment, bits, data)
            }
            Request::Upload(of) => initiated(CLIENT.initiate_upload, 0, *of, [0; 4]),
            Request::UploadSegment { toggle } => segmented(CLIENT.upload_segment, toggled(*toggle), [0; 7]),
            Request::Abort(of, code) => initiated(ABORT, 0, *of, code.0.to_le_bytes()),
            Request::Other(command) => segmented(0, *command, [0; 7]),
        }
    }
}

impl Reply {
    /// Reads the eight bytes of a frame from a server.
    pub fn decode(bytes: [u8; 8]) -> Self {
        let (command, of, data, segment) = parts(bytes);
        let specifier = command >> 5;
        let other = Reply::Other(command);
        match specifier {
            _ if specifier == SERVER.initiate_download => Reply::Downloaded(of),
            _ if specifier == SERVER.download_segment => Reply::SegmentDownloaded { toggle: command & TOGGLE != 0 },
            _ if specifier == SERVER.initiate_upload => Reply::Upload(of, Initiate::decode(command, data)),
            _ if specifier == SERVER.upload_segment => {
                Segment::decode(command, segment).map_or(other, Reply::UploadSegment)
            }
            ABORT => Reply::Abort(of, AbortCode(u32::from_le_bytes(data))),
            _ => other,
        }
    }

    /// The eight bytes of the frame.
    pub fn encode(&self) -> [u8; 8] {
        match self {
            Reply::Downloaded(of) => initiated(SERVER.initiate_download, 0, *of, [0; 4]),
            Reply::SegmentDownloaded { toggle } => segmented(SERVER.download_segment, toggled(*toggle), [0; 7]),
            Reply::Upload(of, initiate) => {
                let (bits, data) = initiate.encode();
                initiated(SERVER.initiate_upload, bits, *of, data)
            }
            Reply::UploadSegment(segment) => {
                let (bits, data) = segment.encode();
                segmented(SERVER.upload_segment, bits, data)
            }
            Reply::Abort(of, code) => initiated(ABORT, 0, *of, code.0.to_le_bytes()),
            Reply::Other(command) => segmented(0, *command, [0; 7]),
        }
    }
}
