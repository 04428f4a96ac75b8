//! A recording of a line as text: one chunk of bytes a line, with direction and time.
//!
//! ```text
//! # antrieb trace 1, 19200 8E1, rtu
//! 2006 > 01 03 21 74 00 01 CE 2C
//! 20590 < 01 03 02 05 6E 3A F8
//! ```
//!
//! The first line says what was recorded: line setting and protocol. The number is microseconds since the port was
//! opened; `>` is what we sent, `<` what came. Lines that begin with `#` are remarks.

use crate::protocol::Hex;
use crate::protocol::line::LineSetting;
use crate::text::{Text, both};
use crate::tick::Tick;
use std::fmt;
use std::io::{self, Write};

/// Writes a recording.
pub struct Trace {
    sink: Box<dyn Write>,
    /// It ended early.
    is_cut: bool,
    /// Why, until somebody was told.
    why: Option<io::Error>,
}

impl fmt::Debug for Trace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Trace").field("is_cut", &self.is_cut).finish_non_exhaustive()
    }
}

impl Trace {
    /// A recording that goes to `sink`; `about` says what line it is of.
    pub fn new(mut sink: Box<dyn Write>, about: &str) -> io::Result<Self> {
        writeln!(sink, "{HEADER}{about}")?;
        Ok(Trace { sink, is_cut: false, why: None })
    }

    /// Remarks that the line was set anew.
    pub(super) fn line_set(&mut self, at: Tick, line: LineSetting) {
        self.write(&format!("# {} {line}", at.as_micros()));
    }

    pub(super) fn sent(&mut self, at: Tick, bytes: &[u8]) {
        self.line(at, '>', bytes);
    }

    pub(super) fn received(&mut self, at: Tick, bytes: &[u8]) {
        self.line(at, '<', bytes);
    }

    fn line(&mut self, at: Tick, direction: char, bytes: &[u8]) {
        self.write(&format!("{} {direction} {}", at.as_micros(), Hex(bytes)));
    }

    /// A disk that is full must not stop a drive from being stopped: the first error ends the recording only.
    fn write(&mut self, line: &str) {
        if !self.is_cut {
            self.why = writeln!(self.sink, "{line}").and_then(|()| self.sink.flush()).err();
            self.is_cut = self.why.is_some();
        }
    }

    /// Why the recording ended early; once.
    pub(super) fn take_error(&mut self) -> Option<io::Error> {
        self.why.take()
    }
}

/// The line setting that the first line of a recording tells, as it is printed: `19200 8E1`.
pub(super) fn recorded_line(text: &str) -> Option<&str> {
    let about = text.lines().next()?.strip_prefix(HEADER)?;
    Some(about.split(',').next().unwrap_or(about).trim())
}

/// How a recording begins.
const HEADER: &str = "# antrieb trace 1, ";

/// A line of a recording.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TraceLine {
    /// Line of the file, from 1.
    pub number: usize,
    /// Microseconds since the port was opened.
    pub at_us: u64,
    /// We sent it; otherwise it came.
    pub sent: bool,
    /// The bytes.
    pub bytes: Vec<u8>,
}

/// Reads a recording; the error names the line.
pub fn read_trace(text: &str) -> Result<Vec<TraceLine>, Text> {
    /// 2^53: so many microseconds a JSON number holds to the last one, 285 years.
    const MOST_US: u64 = 1 << 53;
    /// So much of a line that is none is shown: it may be as long as the file.
    const SHOWN: usize = 80;
    let mut lines = Vec::new();
    for (number, line) in text.lines().enumerate() {
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let number = number + 1;
        let bad = || {
            both!(
                "line {number}: expected MICROSECONDS > or < HEX BYTES, got '{begins}'",
                "Zeile {number}: erwartet MIKROSEKUNDEN > oder < HEX-BYTES; dort steht '{begins}'",
                begins = line.chars().take(SHOWN).collect::<String>()
            )
        };
        let mut words = line.split_whitespace();
        let at_us = words.next().and_then(|word| word.parse().ok()).filter(|at| *at <= MOST_US).ok_or_else(bad)?;
        let sent = match words.next() {
            Some(">") => true,
            Some("<") => false,
            _ => return Err(bad()),
        };
        let byte = |word: &str| (word.len() == 2).then(|| u8::from_str_radix(word, 16).ok()).flatten();
        let bytes = words.map(byte).collect::<Option<Vec<u8>>>().ok_or_else(bad)?;
        lines.push(TraceLine { number, at_us, sent, bytes });
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn recordings_read_back() {
        let text = "# antrieb trace 1, 19200 8E1\n2006 > 01 03\n\n20590 < 01 83 02\n";
        let lines = read_trace(text).unwrap();
        assert_eq!(lines[1], TraceLine { number: 4, at_us: 20_590, sent: false, bytes: vec![1, 0x83, 2] });
        assert!(read_trace("x > 01").unwrap_err().en.starts_with("line 1:"));
        assert!(read_trace("9007199254740992 > 01").is_ok());
        assert!(read_trace("9007199254740993 > 01").unwrap_err().en.starts_with("line 1:"));
        assert!(read_trace("5 > 1").unwrap_err().de.contains("5 > 1"));
    }

    /// A disk with room for so many bytes.
    struct Disk(usize);

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0 = self.0.checked_sub(bytes.len()).ok_or(io::ErrorKind::StorageFull)?;
            Ok(bytes.len())
        }
        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_full_disk_ends_the_recording_and_is_told_once() {
        let mut trace = Trace::new(Box::new(Disk(60)), "19200 8E1, rtu").unwrap();
        trace.sent(Tick::ZERO, &[1, 3]);
        assert!(trace.take_error().is_none());
        (0..9).for_each(|_| trace.sent(Tick::ZERO, &[1, 3]));
        assert_eq!(trace.take_error().unwrap().kind(), io::ErrorKind::StorageFull);
        trace.sent(Tick::ZERO, &[1, 3]);
        assert!(trace.take_error().is_none());
    }
}
