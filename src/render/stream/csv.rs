//! One row a sample, under a head line. A value that is missing is an empty cell, and `error` says why; of a word there is its
//! hex, and the names of the bits that are set in a column of their own.

use super::Form;
use super::cells::{Board, bits, number, seconds};
use crate::outcome::{Column, Record, Sample, addressed};
use crate::profile::Lang;
use crate::render::clean;
use std::io::{self, Write};

pub(super) struct Csv<'a> {
    out: Box<dyn Write + 'a>,
    lang: Lang,
    board: Board,
    /// Something is waited for: what came true stands in a column of its own.
    waits: bool,
    /// What came true with the next sample.
    triggered: Vec<String>,
}

impl<'a> Csv<'a> {
    pub(super) fn new(out: Box<dyn Write + 'a>, lang: Lang) -> Self {
        Csv { out, lang, board: Board::default(), waits: false, triggered: Vec::new() }
    }

    fn row(&mut self, cells: &[String]) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(cells).map_err(io::Error::other)?;
        let row = writer.into_inner().map_err(|error| io::Error::other(error.to_string()))?;
        self.out.write_all(&row)?;
        self.out.flush()
    }

    fn head(&self) -> Vec<String> {
        let columns = self.board.columns.iter().flat_map(|column| {
            let set = if column.data_set > 0 { format!("@{}", column.data_set) } else { String::new() };
            // Drives of two families may call different parameters the same.
            let is_another = |other: &Column| other.slug == column.slug && other.param != column.param;
            let slug = match self.board.columns.iter().any(is_another) {
                true => format!("{}.{}", column.slug, column.param),
                false => column.slug.clone(),
            };
            // Nobody knows the decimals: the raw integer must not be taken for the value.
            let name = format!("{slug}{set}{}", if column.scaled { "" } else { ".raw" });
            let named = column.is_word.then(|| format!("{slug}{set}{BITS}"));
            std::iter::once(name).chain(named)
        });
        let first = ["t", "n", "address", "drive", "state"].map(str::to_owned).into_iter();
        let trigger = self.waits.then(|| "trigger".to_owned());
        first.chain(columns).chain(["error".to_owned()]).chain(trigger).collect()
    }

    fn cells(&mut self, sample: &Sample) -> Vec<String> {
        let error = sample.error.as_ref().or_else(|| sample.values.iter().find_map(|value| value.value.error.as_ref()));
        let state = sample.state.as_ref().map_or_else(String::new, |state| state.slug.clone());
        let first = [
            seconds(sample.t),
            sample.n.to_string(),
            addressed(sample.address, sample.node),
            sample.drive.clone(),
            state,
        ];
        let values = self.board.values(sample).flat_map(|(column, value)| {
            let word = value.and_then(|value| value.word.as_ref());
            let shown = word.map_or_else(|| value.map_or_else(String::new, number), |word| word.hex.clone());
            let named = column.is_word.then(|| word.map_or_else(String::new, |word| bits(word, self.lang).join("; ")));
            std::iter::once(shown).chain(named)
        });
        let error = error.map_or_else(String::new, |error| error.code.clone());
        let triggered = std::mem::take(&mut self.triggered).join("; ");
        let trigger = self.waits.then_some(triggered);
        first.into_iter().chain(values).chain([error]).chain(trigger).map(|cell| clean(&cell)).collect()
    }
}

/// What stands behind the name of a word over the names of its bits, as in the CSV of a document.
const BITS: &str = "_bits";

impl Form for Csv<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Start(start) => {
                self.board = Board::of(start);
                self.waits = start.waits.is_some();
                self.row(&self.head())
            }
            Record::Trigger(news) => {
                self.triggered.push(news.trigger.clone());
                Ok(())
            }
            Record::Sample(sample) => {
                let cells = self.cells(sample);
                self.row(&cells)
            }
            _ => Ok(()),
        }
    }
}
