//! One aligned line a sample, for people, without escape codes.

use super::Form;
use super::cells::{Board, GAP, is_number, seconds, short};
use crate::outcome::{Column, Record, Sample, StreamStart, addressed};
use crate::profile::Lang;
use crate::render::clean;
use crate::render::words::word;
use std::io::{self, Write};
use unicode_width::UnicodeWidthStr;

pub(super) struct Lines<'a> {
    out: &'a mut dyn Write,
    lang: Lang,
    board: Board,
    /// The state has a column of its own, so its word needs none.
    state: bool,
    widths: Vec<usize>,
}

/// Names of states are shorter in both languages.
const STATE: usize = 24;
/// `F0500`, `0x0082`, `-120.00`.
const VALUE: usize = 7;

impl<'a> Lines<'a> {
    pub(super) fn new(out: &'a mut dyn Write, lang: Lang) -> Self {
        Lines { out, lang, board: Board::default(), state: false, widths: Vec::new() }
    }

    fn head(&mut self, start: &StreamStart) -> io::Result<()> {
        self.board = Board::of(start);
        let is_state = |column: &Column| column.role == Some("status-word");
        // Every exchange over PROFIBUS tells it, in Basic mode by no word that has a number.
        self.state = start.protocol == "dp" || self.board.columns.iter().any(is_state);
        let labels: Vec<_> = self.board.columns.iter().map(|column| (self.label(column), is_state(column))).collect();
        let labels: Vec<_> = labels.into_iter().filter(|(_, is_state)| !is_state).map(|(label, _)| label).collect();
        self.board.columns.retain(|column| !is_state(column));
        self.widths = labels.iter().map(|label| label.width().max(VALUE)).collect();
        let (time, address, state) = ("t [s]", word(self.lang, "addr"), word(self.lang, "state"));
        self.line(time, address, state, labels, "")
    }

    fn sample(&mut self, sample: &Sample) -> io::Result<()> {
        let state = match (&sample.state, &sample.error) {
            (Some(state), _) => state.name.get(self.lang).to_owned(),
            (None, Some(_)) => word(self.lang, "gap").to_owned(),
            (None, None) => GAP.to_owned(),
        };
        let cells = self.board.values(sample).map(|(column, value)| short(column, value, self.lang)).collect();
        let error = sample.error.as_ref().map_or("", |error| error.message.get(self.lang));
        self.line(&seconds(sample.t), &addressed(sample.address, sample.node), &state, cells, error)
    }

    fn line(&mut self, time: &str, address: &str, state: &str, cells: Vec<String>, error: &str) -> io::Result<()> {
        let mut line = format!("{}  {}", right(time, 9), right(address, 4));
        if self.state {
            line += "  ";
            line += &left(state, STATE);
        }
        for ((column, cell), width) in self.board.columns.iter().zip(cells).zip(&self.widths) {
            line += "  ";
            line += &if is_number(column) { right(&cell, *width) } else { left(&cell, *width) };
        }
        if !error.is_empty() {
            line += "  ";
            line += &clean(error);
        }
        writeln!(self.out, "{}", line.trim_end())?;
        self.out.flush()
    }

    fn label(&self, column: &Column) -> String {
        let name = clean(&self.board.label(column, self.lang));
        column.unit.as_ref().map_or(name.clone(), |unit| format!("{name} [{}]", clean(unit)))
    }
}

impl Form for Lines<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Start(start) => self.head(start),
            Record::Sample(sample) => self.sample(sample),
            _ => Ok(()),
        }
    }
}

fn right(text: &str, width: usize) -> String {
    let text = clean(text);
    format!("{}{text}", " ".repeat(width.saturating_sub(text.width())))
}

fn left(text: &str, width: usize) -> String {
    let text = clean(text);
    format!("{text}{}", " ".repeat(width.saturating_sub(text.width())))
}
