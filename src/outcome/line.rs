//! What `diag line` found: the adapter, the pauses, the reply times, and what to do.

use super::{ErrorDoc, LinkTest};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `diag line`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LineCheck {
    /// Port.
    pub port: String,
    /// Line setting.
    pub line: String,
    /// Protocol.
    pub protocol: &'static str,
    /// What is between us and the wire.
    pub adapter: Adapter,
    /// Whether the adapter gives back what we send; null if nothing came that tells.
    pub echo: Option<bool>,
    /// Pauses that we kept between a reply and the next question.
    pub pauses: Pauses,
    /// One entry a drive.
    pub drives: Vec<CheckedDrive>,
    /// What is worth doing; empty if nothing is wrong.
    pub advice: Vec<Advice>,
}

/// An adapter as its driver describes it.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Adapter {
    /// Name of the port, links resolved.
    pub name: String,
    /// Driver.
    pub driver: Option<String>,
    /// Maker, product and USB identity.
    pub about: Option<String>,
    /// How long it holds bytes back before it passes them on, where the driver tells.
    pub latency_timer_ms: Option<u32>,
    /// What came of asking for low latency: `granted`, `refused` or `unsupported`.
    pub low_latency: &'static str,
    /// Who switches the direction of an RS-485 line: `auto`, `kernel`, `rts` or `adapter`.
    pub rs485: &'static str,
    /// Errors that the driver counted during the check, where it counts.
    pub errors: Option<AdapterErrors>,
}

/// Characters received with an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct AdapterErrors {
    /// Stop bit missing.
    pub frame: u32,
    /// Lost because nobody fetched them in time.
    pub overrun: u32,
    /// Parity wrong.
    pub parity: u32,
    /// Line held down for longer than a character.
    pub brk: u32,
}

/// Pauses between a reply and the next question.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Pauses {
    /// What the protocol and the drive want at least.
    pub required_us: u64,
    /// How many were measured.
    pub measured: u64,
    /// The shortest.
    pub shortest_us: Option<u64>,
    /// The longest.
    pub longest_us: Option<u64>,
}

/// One drive of the check.
#[derive(Debug, Serialize, JsonSchema)]
pub struct CheckedDrive {
    /// Address.
    pub address: u8,
    /// What the test brought.
    pub test: Option<LinkTest>,
    /// Why there is no test.
    pub error: Option<ErrorDoc>,
}

/// Something to do about the line.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Advice {
    /// Stable name.
    pub code: &'static str,
    /// For people.
    pub text: Text,
}
