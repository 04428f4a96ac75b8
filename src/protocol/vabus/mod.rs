//! VABus, the maker's own serial protocol (VECTRON bus, VCB bus, P.395 = 0), for the master and for the drive.
//!
//! Every telegram is text of 7-bit characters with the control codes of ISO 1745 (sources A1 to A4; S1 = Agile VABus manual
//! VEC 686; EM-RES-03 manual 5.10.2.2). Whether four digits are a number or a string of four characters
//! cannot be seen in a telegram: whoever asked knows.
//!
//! * [`Request`] and [`Reply`]: what a master asks, what a drive answers, to bytes and back;
//! * [`arrival`]: what the bytes that have come so far are to a master who waits for a reply;
//! * [`Receiver`]: cuts what is heard on the line, both sides, into telegrams.
//!
//! Received bytes are compared as they come; a driver that leaves the parity bit of 7-bit characters in has to be cured
//! where the line is read.

mod fields;
mod receive;
mod telegram;

pub use fields::{Address, Data, DataSet, Header, ParamNumber, SystemNode};
pub use receive::{Arrival, Heard, Receiver, arrival};
pub use telegram::{Reply, Request, Telegram};

/// Start of text: the header of a telegram that carries data follows (sources A1).
pub const STX: u8 = 0x02;
/// End of text: the check character follows (sources A1).
pub const ETX: u8 = 0x03;
/// End of transmission: opens every telegram of a master, and ends an exchange (sources A1, A2).
pub const EOT: u8 = 0x04;
/// Enquiry: ends a telegram that asks for a value (sources A1).
pub const ENQ: u8 = 0x05;
/// The drive did what it was told (sources A1).
pub const ACK: u8 = 0x06;
/// The drive refused; P.11 tells why (sources A1, A2).
pub const NAK: u8 = 0x15;

/// Longest telegram: EOT, address, STX, header of 5, length of 2, data of 99, ETX, BCC.
pub const MAX_TELEGRAM: usize = 3 + 5 + 2 + Data::MOST + 2;

/// The check character: XOR of every byte after STX up to and including ETX (sources A2). It may have any value.
///
/// `text` is what stands between STX and ETX, both excluded.
pub fn bcc(text: &[u8]) -> u8 {
    text.iter().fold(ETX, |check, byte| check ^ byte)
}

/// Why bytes are no telegram of VABus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum TelegramError {
    /// The telegram is not complete.
    #[error("{len} bytes are too few for a telegram")]
    TooShort {
        /// How many bytes came.
        len: usize,
    },
    /// Bytes follow the end of the telegram.
    #[error("{extra} bytes too many after the telegram")]
    TooLong {
        /// How many bytes too many.
        extra: usize,
    },
    /// No control code where one must stand, or the wrong one.
    #[error("{got:02X}h where {expected} must stand")]
    Control {
        /// Which control codes may stand there.
        expected: &'static str,
        /// What stands there.
        got: u8,
    },
    /// The character is no drive's address: 41h to 5Eh, or 60h for all.
    #[error("{0:02X}h is no address (41h to 5Eh, 60h for all drives)")]
    Address(u8),
    /// The character is no system-bus node: 30h, or 41h to 7Fh.
    #[error("{0:02X}h is no system-bus node (30h, or 41h to 7Fh)")]
    Node(u8),
    /// The character is no data set: `0` to `9` to the drive, `0` to `4` from it.
    #[error("{0:02X}h is no data set")]
    Set(u8),
    /// The three characters are no parameter number: `000` to `999`, `A00` to `F99`.
    #[error("{0:02X?} is no parameter number (000 to 999, A00 to F99)")]
    Number([u8; 3]),
    /// The two characters are no length: `01` to `99`.
    #[error("{0:02X?} is no length (01 to 99)")]
    Length([u8; 2]),
    /// A control code within the data.
    #[error("control code {0:02X}h within the data")]
    Text(u8),
    /// The check character does not fit.
    #[error("check character {got:02X}h, expected {expected:02X}h")]
    Check {
        /// What the bytes ask for.
        expected: u8,
        /// What came.
        got: u8,
    },
}
