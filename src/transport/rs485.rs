//! Who switches an RS-485 line between talking and listening.

use crate::text::{Wrong, both};
use crate::tick::Span;
use std::str::FromStr;

/// Who switches the direction of the line, and how long before and after a telegram it stands at talking.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rs485 {
    /// Who switches.
    pub mode: Rs485Mode,
    /// From talking to the first start bit. The kernel counts whole milliseconds and gets it rounded up.
    pub before: Span,
    /// From the last stop bit to listening, rounded like `before`.
    pub after: Span,
}

/// Who switches the direction of an RS-485 line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rs485Mode {
    /// The kernel where it does so already, else the adapter.
    #[default]
    Auto,
    /// The driver of the port (Linux: TIOCSRS485).
    Kernel,
    /// We do, with the modem line RTS: high while we talk.
    Rts,
    /// The adapter by itself, as most USB adapters do.
    Adapter,
}

impl Rs485Mode {
    /// Every mode with the word that names it on the command line and in files.
    pub const NAMES: [(Rs485Mode, &'static str); 4] = [
        (Rs485Mode::Auto, "auto"),
        (Rs485Mode::Kernel, "kernel"),
        (Rs485Mode::Rts, "rts"),
        (Rs485Mode::Adapter, "adapter"),
    ];

    /// The word that names this mode: `auto`, `kernel`, `rts`, `adapter`.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|(mode, _)| *mode == self).map_or("auto", |(_, name)| name)
    }
}

/// Reads `auto`, `kernel`, `rts` or `adapter`.
impl FromStr for Rs485Mode {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let found = Self::NAMES.iter().find(|(_, name)| name.eq_ignore_ascii_case(text.trim()));
        found.map(|(mode, _)| *mode).ok_or_else(|| {
            Wrong(both!(
                "expected auto, kernel, rts or adapter, got '{text}'",
                "erwartet: auto, kernel, rts oder adapter; angegeben: '{text}'"
            ))
        })
    }
}

impl Rs485 {
    /// Whether somebody asked for delays.
    pub(super) fn has_delays(self) -> bool {
        self.before > Span::ZERO || self.after > Span::ZERO
    }
}
