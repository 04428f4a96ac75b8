//! Why a link cannot be opened or does not go on.

use super::Rs485Mode;
#[cfg(target_os = "linux")]
use super::can_trouble::CanTrouble;
use crate::protocol::Hex;
use crate::text::Text;
use std::path::PathBuf;

/// Why a link cannot be opened or does not go on.
#[derive(Debug, thiserror::Error)]
pub enum LinkError {
    /// There is no such port.
    #[error("there is no port '{0}'")]
    NotFound(String),
    /// Somebody else has it.
    #[error("port '{0}' is in use by another program")]
    Busy(String),
    /// The user may not open it.
    #[error("no permission to open port '{0}'")]
    Permission(String),
    /// The driver does not do what was asked.
    #[error("port '{port}': {message}")]
    Setting {
        /// The port.
        port: String,
        /// What the driver said, or what it set in place of what was asked.
        message: String,
    },
    /// The direction of an RS-485 line cannot be switched as asked.
    #[error("port '{port}' does not offer --rs485 {}: {}", mode.name(), message.en)]
    Direction {
        /// The port.
        port: String,
        /// Who should have switched.
        mode: Rs485Mode,
        /// What the driver said.
        message: Text,
    },
    /// The serial line behind a raw TCP port or a gateway cannot be set through it.
    #[error("the serial line behind '{0}' cannot be set from here")]
    Fixed(String),
    /// The device server does not set its serial line for us: it refuses RFC 2217, or does not answer it.
    #[error("'{0}' does not speak RFC 2217")]
    NoRfc2217(String),
    /// Nobody answers at that address of the network.
    #[error("cannot connect to '{port}': {}", message.en)]
    Unreachable {
        /// The port.
        port: String,
        /// What the system said.
        message: Text,
    },
    /// The port is there, and whoever should answer behind it does not any more.
    #[error("{}", why.en)]
    Gone {
        /// The port.
        port: String,
        /// Why nobody answers.
        why: Text,
    },
    /// The adapter, or the other end of a connection, takes no bytes any more.
    #[error("port '{0}' takes no bytes: what is behind it does not fetch them")]
    Stuck(String),
    /// The adapter that had this name was unplugged, and another one has the name now.
    #[error("port '{port}' is another adapter now: {found}")]
    Stranger {
        /// The port.
        port: String,
        /// What has the name.
        found: String,
    },
    /// Something is wrong with a CAN interface of the kernel.
    #[cfg(target_os = "linux")]
    #[error("{}", why.told(port).en)]
    Can {
        /// The port.
        port: String,
        /// What.
        why: CanTrouble,
    },
    /// The CAN adapter refuses to send.
    #[error("the CAN adapter at '{0}' refuses to send a frame")]
    Unsent(String),
    /// Nobody on the bus acknowledges what the CAN adapter sends.
    #[error(
        "the CAN adapter at '{port}' reports errors (status flags {flags:02X}h): nobody on the bus acknowledges its frames"
    )]
    Unacknowledged {
        /// The port.
        port: String,
        /// Its status flags (Lawicel CANUSB manual, F).
        flags: u8,
    },
    /// The adapter was unplugged, or the other end hung up.
    #[error("port '{0}' was lost: the adapter was unplugged or the other end hung up")]
    Lost(String),
    /// The file is no recording that can be played back.
    #[error("recording {}: {}", file.display(), message.en)]
    Recording {
        /// The file.
        file: PathBuf,
        /// What is wrong with it, with the line.
        message: Text,
    },
    /// Something else was sent than the recording has.
    #[error("recording {}, line {line}: recorded was {}, sent was {}", file.display(), Hex(expected), Hex(sent))]
    OffTape {
        /// The file.
        file: PathBuf,
        /// Line of the file, from 1.
        line: usize,
        /// What was sent when it was recorded.
        expected: Vec<u8>,
        /// What was sent now.
        sent: Vec<u8>,
    },
}

impl LinkError {
    /// The port that it happened to; a recording has a file.
    pub fn port(&self) -> Option<&str> {
        match self {
            LinkError::NotFound(port)
            | LinkError::Busy(port)
            | LinkError::Permission(port)
            | LinkError::Fixed(port)
            | LinkError::NoRfc2217(port)
            | LinkError::Stuck(port)
            | LinkError::Lost(port)
            | LinkError::Unsent(port)
            | LinkError::Unacknowledged { port, .. }
            | LinkError::Gone { port, .. }
            | LinkError::Setting { port, .. }
            | LinkError::Direction { port, .. }
            | LinkError::Unreachable { port, .. }
            | LinkError::Stranger { port, .. } => Some(port),
            #[cfg(target_os = "linux")]
            LinkError::Can { port, .. } => Some(port),
            LinkError::Recording { .. } | LinkError::OffTape { .. } => None,
        }
    }
}
