//! The live view as lines of text: what a terminal of a size would show of records that were told so far.

use super::screen::Screen;
use crate::outcome::Record;
use crate::profile::Lang;
use ratatui::backend::TestBackend;

/// A live view that nobody sees.
pub struct Picture(Screen);

impl std::fmt::Debug for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_tuple("Picture").finish_non_exhaustive()
    }
}

impl Picture {
    /// Before anything was told.
    pub fn new(lang: Lang) -> Self {
        Picture(Screen::new(lang, false))
    }

    /// Takes a record.
    pub fn record(&mut self, record: &Record) {
        self.0.record(record);
    }

    /// Somebody has something to say.
    pub fn note(&mut self, text: &str) {
        self.0.note(text);
    }

    /// Shows the diagnosis in place of the chart, as `d` does, or not.
    pub fn diagnoses(&mut self, diagnoses: bool) {
        self.0.diagnoses = diagnoses;
    }

    /// Its lines on a terminal of so many columns and rows, without what is blank at their ends.
    pub fn lines(&self, width: u16, height: u16) -> Vec<String> {
        lines(&self.0, width, height)
    }
}

pub(super) fn lines(screen: &Screen, width: u16, height: u16) -> Vec<String> {
    let Ok(mut terminal) = ratatui::Terminal::new(TestBackend::new(width, height));
    let Ok(_) = terminal.draw(|frame| screen.draw(frame));
    let cells: Vec<&str> = terminal.backend().buffer().content().iter().map(|cell| cell.symbol()).collect();
    cells.chunks(usize::from(width.max(1))).map(|row| row.concat().trim_end().to_owned()).collect()
}
