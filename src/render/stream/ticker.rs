//! One line on a terminal that every sample refreshes.

use super::cells::{Board, GAP, first_of, is_number, seconds, short};
use super::{Form, Manner};
use crate::outcome::{Decimal, Record, Sample, addressed};
use crate::profile::Lang;
use crate::render::{clean, terminal_width};
use std::collections::BTreeMap;
use std::io::{self, Write};
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

pub(super) struct Ticker<'a> {
    out: &'a mut dyn Write,
    lang: Lang,
    width: usize,
    /// The width is that of our own terminal, so it may change.
    follows: bool,
    board: Board,
    /// What is told of each: its state, then what matters most first.
    drives: BTreeMap<u8, Vec<String>>,
    t: Decimal,
    /// Columns of what stands there now.
    shown: usize,
}

impl<'a> Ticker<'a> {
    pub(super) fn new(out: &'a mut dyn Write, manner: Manner) -> Self {
        let follows = manner.width.is_some() && terminal_width() == manner.width;
        let width = manner.width.unwrap_or(80).into();
        let (board, t) = (Board::default(), Decimal { raw: 0, decimals: 6 });
        Ticker { out, lang: manner.lang, width, follows, board, drives: BTreeMap::new(), t, shown: 0 }
    }

    fn sample(&self, sample: &Sample) -> Vec<String> {
        let (mut ills, mut rest) = (Vec::new(), Vec::new());
        let state = match (&sample.state, &sample.error) {
            (Some(state), _) => state.name.get(self.lang).to_owned(),
            (None, Some(error)) => format!("{GAP} {}", error.message.get(self.lang)),
            (None, None) => String::new(),
        };
        for (column, value) in self.board.values(sample) {
            let ill = matches!(column.role, Some("fault" | "warnings"));
            let quiet = ill && value.is_some_and(|value| value.raw == Some(0));
            if quiet || column.role == Some("status-word") || sample.error.is_some() {
                continue;
            }
            let unit =
                column.unit.as_ref().filter(|_| is_number(column)).map_or(String::new(), |unit| format!(" {unit}"));
            let told = match value.filter(|_| ill) {
                Some(value) if column.role == Some("warnings") => first_of(column, value, self.lang),
                _ => short(column, value, self.lang),
            };
            let part = format!("{} {told}{unit}", self.board.label(column, self.lang));
            if ill { ills.push(part) } else { rest.push(part) }
        }
        let state = format!("{}: {state}", addressed(sample.address, sample.node));
        [state].into_iter().chain(ills).chain(rest).map(|part| clean(&part)).collect()
    }

    fn show(&mut self) -> io::Result<()> {
        if let Some(width) = terminal_width().filter(|_| self.follows) {
            self.width = width.into();
        }
        // The last column stays free: some terminals begin a new line behind it.
        let drives: Vec<&[String]> = self.drives.values().map(Vec::as_slice).collect();
        let text = fitting(&format!("{} s  ", seconds(self.t)), &drives, self.width.saturating_sub(1));
        self.write(&text)
    }

    /// Puts a text where the last one stands. Blanks wipe what it does not cover, on every terminal there is.
    fn write(&mut self, text: &str) -> io::Result<()> {
        let columns = text.width();
        let blanks = " ".repeat(self.shown.min(self.width.saturating_sub(1)).saturating_sub(columns));
        write!(self.out, "\r{text}{blanks}")?;
        self.shown = columns;
        self.out.flush()
    }
}

impl Form for Ticker<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Start(start) => self.board = Board::of(start),
            Record::Sample(sample) => {
                self.t = sample.t;
                self.drives.insert(sample.address, self.sample(sample));
                self.show()?;
            }
            Record::End(_) if self.shown > 0 => {
                writeln!(self.out)?;
                self.out.flush()?;
            }
            _ => {}
        }
        Ok(())
    }

    fn note(&mut self, _text: &str) -> io::Result<bool> {
        if self.shown > 0 {
            self.write("")?;
            write!(self.out, "\r")?;
            self.out.flush()?;
        }
        Ok(false)
    }
}

/// What stands where parts of a drive did not fit.
const MORE: &str = " \u{2026}";

/// As many parts of every drive as fit, what matters most of each before what matters less of any; whose parts are not all there is
/// marked. Only what would not even fit alone is cut.
fn fitting(head: &str, drives: &[&[String]], width: usize) -> String {
    let line = |counts: &[usize]| {
        let told = drives.iter().zip(counts).map(|(drive, &count)| {
            let more = if count < drive.len() { MORE } else { "" };
            format!("{}{more}", drive.get(..count).unwrap_or(drive).join("  "))
        });
        format!("{head}{}", told.collect::<Vec<_>>().join(" | "))
    };
    let mut counts = vec![1; drives.len()];
    for rank in 1..drives.iter().map(|drive| drive.len()).max().unwrap_or(0) {
        for (index, drive) in drives.iter().enumerate() {
            let mut more = counts.clone();
            match more.get_mut(index) {
                Some(count) if *count == rank && rank < drive.len() => *count += 1,
                _ => continue,
            }
            if line(&more).width() <= width {
                counts = more;
            }
        }
    }
    cut(&line(&counts), width)
}

/// As much of a text as fits; that it goes on is marked.
fn cut(text: &str, width: usize) -> String {
    if text.width() <= width {
        return text.to_owned();
    }
    let mark = MORE.trim_start();
    let mut room = width.saturating_sub(mark.width());
    let fits = |letter: &char| {
        let columns = letter.width().unwrap_or(0);
        let fits = columns <= room;
        room = room.saturating_sub(columns);
        fits
    };
    let begin: String = text.chars().take_while(fits).collect();
    if width < mark.width() { begin } else { format!("{begin}{mark}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_fit_is_left_out_whole_and_marked_and_what_matters_least_first() {
        let parts = |text: &str| text.split('|').map(str::to_owned).collect::<Vec<_>>();
        let (one, two) = (parts("1: Störung|Störung F0500|Strom 1,2 A"), parts("2: Bereit|Strom 0,0 A"));
        let drives = [&one[..], &two[..]];
        for (width, expected) in [
            (80, "3 s  1: Störung  Störung F0500  Strom 1,2 A | 2: Bereit  Strom 0,0 A"),
            (60, "3 s  1: Störung  Störung F0500 … | 2: Bereit  Strom 0,0 A"),
            (50, "3 s  1: Störung  Störung F0500 … | 2: Bereit …"),
            (32, "3 s  1: Störung … | 2: Bereit …"),
            (20, "3 s  1: Störung … |…"),
        ] {
            assert_eq!(fitting("3 s  ", &drives, width), expected, "{width}");
        }
    }
}
