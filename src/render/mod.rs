//! The only room that writes: data to stdout, everything else to stderr.

mod ask;
mod calls;
mod console;
mod document;
mod finding;
mod hush;
mod outlet;
mod run_line;
mod search;
mod spoken;
mod stream;
mod words;
mod wrap;

pub use ask::Terminal;
pub use calls::calls;
pub use console::{Console, Input, Streams, forget_what_was_typed};
pub use document::{print, print_end};
pub use finding::sheet;
pub use outlet::{AtOnce, Outlet, Patience, Stdout, write_from_the_background};
pub use stream::{Keep, Key, Keys, Manner, Picture, Place, Stream, View};
pub use wrap::wrap;

use crate::text::{Wrong, both};
use std::str::FromStr;
use unicode_width::UnicodeWidthChar;

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
    /// InfluxDB line protocol: streams of samples only.
    Influx,
    /// OpenMetrics text: streams of samples only.
    OpenMetrics,
}

impl Format {
    /// Every form, with its word.
    pub const ALL: [(&'static str, Format); 6] = [
        ("table", Format::Table),
        ("json", Format::Json),
        ("ndjson", Format::Ndjson),
        ("csv", Format::Csv),
        ("influx", Format::Influx),
        ("openmetrics", Format::OpenMetrics),
    ];

    /// Whether it is only for samples that come again and again.
    pub fn is_for_samples(self) -> bool {
        matches!(self, Format::Influx | Format::OpenMetrics)
    }
}

impl FromStr for Format {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let known = Format::ALL.iter().find(|(word, _)| *word == text);
        known.map(|(_, format)| *format).ok_or_else(|| {
            Wrong(both!(
                "expected table, json, ndjson, csv, influx or openmetrics, got '{text}'",
                "erwartet: table, json, ndjson, csv, influx oder openmetrics; angegeben: '{text}'"
            ))
        })
    }
}

/// A text that may come from a device or a file, with everything in it made visible that a terminal obeys or does not
/// show. What is clean already stays as it is.
pub fn clean(text: &str) -> String {
    let mut clean = String::with_capacity(text.len());
    let mut before = ' ';
    for letter in text.chars() {
        // One mark over a letter is part of it: `u` and U+0308 are a "ü" of other systems.
        let is_shown = letter.width().is_some_and(|columns| columns > 0) || is_mark(letter) && before.is_alphabetic();
        if is_shown && !is_invisible(letter) {
            clean.push(letter);
        } else {
            clean.extend(letter.escape_unicode());
        }
        before = letter;
    }
    clean
}

/// Combining marks of the scripts that our texts are in (Unicode block "Combining Diacritical Marks").
fn is_mark(letter: char) -> bool {
    matches!(letter, '\u{0300}'..='\u{036F}') && letter != '\u{034F}'
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

/// Columns and lines of the terminal on stdout.
fn terminal_size() -> Option<(u16, u16)> {
    #[cfg(unix)]
    return rustix::termios::tcgetwinsize(rustix::stdio::stdout()).ok().map(|size| (size.ws_col, size.ws_row));
    #[cfg(not(unix))]
    None
}

/// Columns of the terminal on stderr, if it is one.
fn progress_width() -> Option<u16> {
    #[cfg(unix)]
    return rustix::termios::tcgetwinsize(rustix::stdio::stderr())
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
        is_closed(rustix::stdio::stdout())
    }
    #[cfg(not(unix))]
    false
}

/// Whether the terminal that stderr was has gone away.
pub fn terminal_is_gone() -> bool {
    #[cfg(unix)]
    {
        is_closed(rustix::stdio::stderr())
    }
    #[cfg(not(unix))]
    false
}

#[cfg(unix)]
fn is_closed(stream: rustix::fd::BorrowedFd<'_>) -> bool {
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    let mut watched = [PollFd::new(&stream, PollFlags::empty())];
    let now = Timespec { tv_sec: 0, tv_nsec: 0 };
    poll(&mut watched, Some(&now)).is_ok()
        && watched.iter().any(|fd| fd.revents().intersects(PollFlags::ERR | PollFlags::NVAL | PollFlags::HUP))
}

/// Characters that show nothing, or turn the direction of a line around, and so can make it read as something else,
/// whatever width a table of widths gives them: the soft hyphen, fillers, joiners, marks of direction, separators of lines
/// and paragraphs, variation selectors, tags (Unicode 16, Default_Ignorable_Code_Point and Bidi_Control).
fn is_invisible(letter: char) -> bool {
    matches!(letter,
        '\u{00AD}' | '\u{034F}' | '\u{061C}' | '\u{115F}'..='\u{1160}' | '\u{17B4}'..='\u{17B5}' | '\u{180B}'..='\u{180F}'
        | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{2800}' | '\u{3164}'
        | '\u{FE00}'..='\u{FE0F}' | '\u{FEFF}' | '\u{FFA0}' | '\u{FFF0}'..='\u{FFFB}' | '\u{1BCA0}'..='\u{1BCA3}'
        | '\u{1D173}'..='\u{1D17A}' | '\u{E0000}'..='\u{E0FFF}')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_are_made_visible() {
        assert_eq!(clean("a\u{1b}[31m\u{202e}ü"), "a\\u{1b}[31m\\u{202e}ü");
        assert_eq!(clean("a\u{9b}31m\n\t"), "a\\u{9b}31m\\u{a}\\u{9}");
    }

    #[test]
    fn what_shows_nothing_is_made_visible_and_letters_stay() {
        for hidden in
            "\u{ad}\u{200b}\u{200d}\u{200e}\u{2028}\u{2060}\u{2066}\u{feff}\u{fe0f}\u{3164}\u{e0041}\u{0489}".chars()
        {
            let shown = clean(&format!("a{hidden}b"));
            assert_eq!(shown, format!("a{}b", hidden.escape_unicode()));
            assert_eq!(clean(&shown), shown);
        }
        for text in ["Umdrehungen 1/min \u{b7} µs Ω °C ² €", "u\u{308}ber", "漢字 Ελλ Жж"] {
            assert_eq!(clean(text), text);
        }
        assert_eq!(clean("u\u{308}\u{308}"), "u\u{308}\\u{308}");
    }
}
