//! Recordings of a CAN bus: logs of candump, and what went to and from an SLCAN adapter.

use super::super::Reader;
use super::names;
use crate::outcome::TelegramDoc;
use crate::protocol::can::FrameError;
use crate::protocol::can::candump::{Entry, What, is_line};
use crate::protocol::can::slcan::{Word, cut, is_text};
use crate::text::{Text, both};

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

/// What a recording has, with microseconds since it began.
enum Line {
    Entry(Entry),
    Word(Word, Option<u64>),
    /// What an adapter said that is no word of it.
    Damaged(String, FrameError),
}

/// Reads a recording; `None` if it is none of CAN.
fn lines(text: &str) -> Option<Result<Vec<Line>, Text>> {
    let text = text.trim_start_matches('\u{feff}');
    let mut told =
        text.lines().map(str::trim).enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let (_, first) = told.clone().next()?;
    if is_text(text) {
        return Some(Ok(words(text)));
    }
    if !is_line(first) {
        return None;
    }
    let read = |(nth, line): (usize, &str)| {
        let number = nth + 1;
        let why = |error| {
            let why = names::wrong(&error);
            both!("line {number}: {why}", "Zeile {number}: {why}", why)
        };
        Entry::read(line).map(Line::Entry).map_err(why)
    };
    Some(told.try_fold(Vec::new(), |mut lines, line| {
        lines.push(read(line)?);
        Ok(lines)
    }))
}

/// Whether a text is a recording of CAN.
pub fn is_can(text: &str) -> bool {
    lines(text).is_some()
}

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
        Ok(word) => {
            let at_us = timed(&word);
            Line::Word(word, at_us)
        }
        Err(error) => Line::Damaged(word.to_owned(), error),
    };
    cut(text).map(str::trim).map(read).collect()
}

impl Reader<'_> {
    /// Takes a recording of a CAN bus apart; `None` if it is none.
    pub(in crate::drive::decode) fn can_recording(&self, text: &str) -> Option<Result<Vec<TelegramDoc>, Text>> {
        let lines = match lines(text)? {
            Ok(lines) => lines,
            Err(why) => return Some(Err(why)),
        };
        let begun = lines.iter().find_map(at);
        let doc = |line: &Line| {
            let mut doc = match line {
                Line::Entry(entry) => self.what(&entry.what),
                Line::Word(word, _) => self.slcan(word),
                Line::Damaged(word, error) => super::damaged(word, error),
            };
            doc.at_us = at(line).zip(begun).and_then(|(at, begun)| at.checked_sub(begun));
            if let (Line::Entry(entry), Some(can)) = (line, doc.can.as_mut()) {
                can.interface.clone_from(&entry.interface);
            }
            doc
        };
        Some(Ok(lines.iter().map(doc).collect()))
    }
}

fn at(line: &Line) -> Option<u64> {
    match line {
        Line::Entry(entry) => entry.at_us,
        Line::Word(_, at_us) => *at_us,
        Line::Damaged(..) => None,
    }
}

/// A recording of a CAN bus as candump logs it; `None` if it is none.
pub fn log(text: &str) -> Option<Result<Written, Text>> {
    let lines = match lines(text)? {
        Ok(lines) => lines,
        Err(why) => return Some(Err(why)),
    };
    let entry = |line: &Line| match line {
        Line::Entry(entry) => Some(entry.clone()),
        Line::Word(Word::Frame { frame, .. }, at_us) => {
            Some(Entry { at_us: *at_us, interface: None, what: What::Frame(*frame) })
        }
        Line::Word(..) | Line::Damaged(..) => None,
    };
    let entries: Vec<Entry> = lines.iter().filter_map(entry).collect();
    let log = entries.iter().map(|entry| format!("{entry}\n")).collect();
    Some(Ok(Written { log, frames: entries.len() as u64, left_out: (lines.len() - entries.len()) as u64 }))
}
