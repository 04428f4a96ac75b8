//! Recordings of a CAN bus: our own, logs of candump, and what went to and from an SLCAN adapter.

use super::super::{Reader, recorded_protocol};
use super::names;
use crate::outcome::TelegramDoc;
use crate::protocol::Protocol;
use crate::protocol::can::FrameError;
use crate::protocol::can::candump::{Entry, What, is_line};
use crate::protocol::can::slcan::{Word, cut, is_text};
use crate::text::{Text, both};
use crate::transport::{TraceLine, read_trace};

/// A log in the form of candump, and how many of its lines are not in it because they are no frames.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Written {
    /// The log.
    pub log: String,
    /// Lines of it.
    pub frames: u64,
    /// What was said to or by an adapter, and what was damaged.
    pub left_out: u64,
}

/// A line of a recording, with what it tells besides.
struct Line {
    /// Microseconds: of the clock of the day, or since the recording began.
    at_us: Option<u64>,
    /// This program sent it, or heard it; `None` where nobody tells.
    sent: Option<bool>,
    what: Said,
}

/// What a recording has.
enum Said {
    Entry(Entry),
    Word(Word),
    /// What an adapter said, or was told, that is no word of it.
    Damaged(String, FrameError),
}

/// A recording, and whether its times count from the moment at which the port was opened.
struct Recording {
    lines: Vec<Line>,
    is_own: bool,
}

/// Reads a recording; `None` if it is none of CAN. One of our own that does not say what it is of is known by its bytes, or taken for one
/// of CAN (`is_set`).
fn lines(text: &str, is_set: bool) -> Option<Result<Recording, Text>> {
    match recorded_protocol(text) {
        Some(Protocol::Sdo(_)) => return Some(read_trace(text).map(own)),
        Some(_) => return None,
        None => {}
    }
    let told = text.lines().map(str::trim).enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let (_, first) = told.clone().next()?;
    if is_text(text) {
        return Some(Ok(Recording { lines: words(text), is_own: false }));
    }
    if !is_line(first) {
        let traced = read_trace(text);
        let is_meant = is_set || traced.as_ref().is_ok_and(|lines| is_text(&said(lines)));
        return is_meant.then(|| traced.map(own));
    }
    let read = |(nth, line): (usize, &str)| {
        let number = nth + 1;
        let why = |error| {
            let why = names::wrong(&error);
            both!("line {number}: {why}", "Zeile {number}: {why}", why)
        };
        let entry = Entry::read(line).map_err(why)?;
        Ok(Line { at_us: entry.at_us, sent: None, what: Said::Entry(entry) })
    };
    let lines = told.map(read).collect::<Result<_, _>>();
    Some(lines.map(|lines| Recording { lines, is_own: false }))
}

/// Whether a text is a recording of CAN, or is taken for one.
pub fn is_can(text: &str, is_set: bool) -> bool {
    lines(text, is_set).is_some()
}

/// Everything that was said, either way.
fn said(lines: &[TraceLine]) -> String {
    String::from_utf8_lossy(&lines.iter().flat_map(|line| line.bytes.clone()).collect::<Vec<_>>()).into_owned()
}

/// What this program recorded (`--trace`): the words to an adapter and those from it, each however the pieces fall, with the time of its first
/// byte. What somebody left unfinished is damaged.
fn own(traced: Vec<TraceLine>) -> Recording {
    let mut lines = Vec::new();
    // To the adapter, and from it.
    let mut open: [(u64, Vec<u8>); 2] = Default::default();
    let word = |(at, bytes): (u64, Vec<u8>), sent: bool| {
        let word = String::from_utf8_lossy(&bytes).into_owned();
        let what = Word::read(&word).map_or_else(|error| Said::Damaged(word, error), Said::Word);
        Line { at_us: Some(at), sent: Some(sent), what }
    };
    for line in traced {
        let [heard, told] = &mut open;
        let piece = if line.sent { told } else { heard };
        for byte in line.bytes {
            if piece.1.is_empty() {
                piece.0 = line.at_us;
            }
            match byte {
                END => lines.push(word(std::mem::take(piece), line.sent)),
                BELL => {
                    let begun = std::mem::take(piece);
                    lines.extend((!begun.1.is_empty()).then(|| word(begun, line.sent)));
                    lines.push(word((line.at_us, vec![BELL]), line.sent));
                }
                b'\n' => {}
                byte => piece.1.push(byte),
            }
        }
    }
    let torn = |(begun, sent): ((u64, Vec<u8>), bool)| {
        let (at_us, word) = (Some(begun.0), String::from_utf8_lossy(&begun.1).into_owned());
        let what = Said::Damaged(word.clone(), FrameError::Form(word));
        (!begun.1.is_empty()).then_some(Line { at_us, sent: Some(sent), what })
    };
    lines.extend(open.into_iter().zip([false, true]).filter_map(torn));
    Recording { lines, is_own: true }
}

/// What ends a word, and what refuses.
const END: u8 = b'\r';
const BELL: u8 = 7;

/// The words of SLCAN, whose times begin anew every minute.
fn words(text: &str) -> Vec<Line> {
    const MINUTE_MS: u64 = 60_000;
    let (mut minutes, mut last) = (0, 0);
    let mut timed = |word: &Word| {
        let Word::Frame { at_ms: Some(ms), .. } = word else { return None };
        let ms = u64::from(*ms);
        minutes += u64::from(ms < last);
        last = ms;
        Some((minutes * MINUTE_MS + ms) * 1000)
    };
    let read = |word: &str| match Word::read(word) {
        Ok(word) => Line { at_us: timed(&word), sent: None, what: Said::Word(word) },
        Err(error) => Line { at_us: None, sent: None, what: Said::Damaged(word.to_owned(), error) },
    };
    cut(text).map(str::trim).map(read).collect()
}

impl Reader<'_> {
    /// Takes a recording of a CAN bus apart; `None` if it is none.
    pub(in crate::drive::decode) fn can_recording(&self, text: &str) -> Option<Result<Vec<TelegramDoc>, Text>> {
        let is_set = matches!(self.protocol, Protocol::Sdo(_));
        Some(lines(text, is_set)?.map(|recording| self.recorded(&recording)))
    }

    fn recorded(&self, recording: &Recording) -> Vec<TelegramDoc> {
        let first = recording.lines.iter().find_map(|line| line.at_us);
        let begun = if recording.is_own { Some(0) } else { first };
        let doc = |line: &Line| {
            let mut doc = match &line.what {
                Said::Entry(entry) => self.what(&entry.what),
                Said::Word(word) => self.slcan(word, line.sent),
                Said::Damaged(word, error) => super::damaged_word(word, error),
            };
            doc.at_us = line.at_us.zip(begun).and_then(|(at, begun)| at.checked_sub(begun));
            if let Some(can) = doc.can.as_mut() {
                can.sent = line.sent;
                if let Said::Entry(entry) = &line.what {
                    can.interface.clone_from(&entry.interface);
                }
            }
            doc
        };
        recording.lines.iter().map(doc).collect()
    }
}

/// A recording of a CAN bus as candump logs it; `None` if it is none.
pub fn log(text: &str, is_set: bool) -> Option<Result<Written, Text>> {
    Some(lines(text, is_set)?.map(|recording| {
        let entry = |line: &Line| match &line.what {
            Said::Entry(entry) => Some(entry.clone()),
            Said::Word(Word::Frame { frame, .. }) => {
                Some(Entry { at_us: line.at_us, interface: None, what: What::Frame(*frame) })
            }
            Said::Word(_) | Said::Damaged(..) => None,
        };
        let entries: Vec<Entry> = recording.lines.iter().filter_map(entry).collect();
        let log = entries.iter().map(|entry| format!("{entry}\n")).collect();
        Written { log, frames: entries.len() as u64, left_out: (recording.lines.len() - entries.len()) as u64 }
    }))
}
