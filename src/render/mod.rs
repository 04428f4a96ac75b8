//! The only room that writes: data to stdout, everything else to stderr.

mod ask;
mod console;
mod document;
mod rows;
mod stream;
mod table;
mod words;

pub use ask::{Input, Terminal};
pub use console::{Console, Streams};
pub use document::{Envelope, print, print_failure, schema};
pub use rows::Row;
pub use stream::{Key, Keys, Manner, Stream, View};

use std::str::FromStr;

/// Form of the output.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Format {
    /// For people.
    #[default]
    Table,
    /// One document.
    Json,
    /// One object a line.
    Ndjson,
    /// Comma-separated values with a head line.
    Csv,
}

impl FromStr for Format {
    type Err = String;
    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "table" => Ok(Format::Table),
            "json" => Ok(Format::Json),
            "ndjson" => Ok(Format::Ndjson),
            "csv" => Ok(Format::Csv),
            _ => Err(format!("expected table, json, ndjson or csv, got '{text}'")),
        }
    }
}

/// A text that may come from a device or a file, with its control characters made visible.
pub fn clean(text: &str) -> String {
    let mut clean = String::with_capacity(text.len());
    for letter in text.chars() {
        if letter.is_control() || is_bidi_control(letter) {
            clean.extend(letter.escape_unicode());
        } else {
            clean.push(letter);
        }
    }
    clean
}

/// Columns of the terminal on stdout, if it is one.
pub fn terminal_width() -> Option<u16> {
    #[cfg(unix)]
    return rustix::termios::tcgetwinsize(rustix::stdio::stdout())
        .ok()
        .map(|size| size.ws_col)
        .filter(|&columns| columns > 0);
    #[cfg(not(unix))]
    None
}

/// Whether the reader of stdout has gone away.
pub fn output_is_closed() -> bool {
    #[cfg(unix)]
    {
        use rustix::event::{PollFd, PollFlags, Timespec, poll};
        let out = rustix::stdio::stdout();
        let mut watched = [PollFd::new(&out, PollFlags::empty())];
        let now = Timespec { tv_sec: 0, tv_nsec: 0 };
        poll(&mut watched, Some(&now)).is_ok()
            && watched.iter().any(|fd| fd.revents().intersects(PollFlags::ERR | PollFlags::NVAL))
    }
    #[cfg(not(unix))]
    false
}

/// Characters that turn the direction of a line around and so can make it read as something else.
fn is_bidi_control(letter: char) -> bool {
    matches!(letter, '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_made_visible() {
        assert_eq!(clean("a\u{1b}[31m\u{202e}ü"), "a\\u{1b}[31m\\u{202e}ü");
    }
}
