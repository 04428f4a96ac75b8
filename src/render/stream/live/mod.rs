//! The whole terminal: what drives do, now and over the last minutes.
//!
//! [`Screen`] knows records and draws them, on any terminal that ratatui can draw on, as much of it as fits.
//! [`Terminal`] takes the real one and gives it back, whatever happens; [`Keys`] listens to it.

mod chart;
mod keys;
mod past;
mod screen;
#[cfg(test)]
mod tests;

pub use keys::{Key, Keys};

use super::{Form, Manner};
use crate::outcome::Record;
use ratatui::crossterm::terminal::{self, EnterAlternateScreen, LeaveAlternateScreen};
use ratatui::crossterm::{cursor, execute};
use ratatui::prelude::CrosstermBackend;
use screen::Screen;
use std::io::{self, Write};

/// The live view on a real terminal.
pub(super) struct Live<'a> {
    terminal: Terminal<'a>,
    screen: Screen,
    holds_stderr: bool,
}

impl<'a> Live<'a> {
    pub(super) fn new(terminal: Terminal<'a>, manner: Manner) -> io::Result<Self> {
        // Whether there are colours was decided with the settings; crossterm must not look at NO_COLOR for itself.
        ratatui::crossterm::style::force_color_output(manner.color);
        let screen = Screen::new(manner.lang, manner.color);
        let mut live = Live { terminal, screen, holds_stderr: manner.holds_stderr };
        live.draw()?;
        Ok(live)
    }

    fn draw(&mut self) -> io::Result<()> {
        self.terminal.inner.draw(|frame| self.screen.draw(frame)).map(|_| ())
    }
}

impl Form for Live<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        self.screen.record(record);
        self.draw()
    }

    fn note(&mut self, text: &str) -> io::Result<bool> {
        if !text.is_empty() {
            text.clone_into(&mut self.screen.note);
            self.draw()?;
        }
        Ok(self.holds_stderr)
    }

    fn press(&mut self, key: Key) -> io::Result<()> {
        match key {
            Key::Next => self.screen.turn(1),
            Key::Previous => self.screen.turn(-1),
            Key::Redraw | Key::Quit => {}
        }
        self.draw()
    }
}

/// A terminal that was taken over; dropping it gives it back.
pub(super) struct Terminal<'a> {
    inner: ratatui::Terminal<CrosstermBackend<&'a mut dyn Write>>,
}

impl<'a> Terminal<'a> {
    /// Whether there is a terminal that can be taken over.
    pub(super) fn is_there() -> bool {
        let is_there = terminal::enable_raw_mode().is_ok() && terminal::size().is_ok();
        let _as_it_was = terminal::disable_raw_mode();
        is_there
    }

    /// Takes the terminal over.
    pub(super) fn take(out: &'a mut dyn Write) -> io::Result<Self> {
        let mut terminal = Terminal { inner: ratatui::Terminal::new(CrosstermBackend::new(out))? };
        terminal::enable_raw_mode()?;
        execute!(terminal.inner.backend_mut(), EnterAlternateScreen, cursor::Hide)?;
        Ok(terminal)
    }
}

impl Drop for Terminal<'_> {
    fn drop(&mut self) {
        let _closed = execute!(self.inner.backend_mut(), LeaveAlternateScreen, cursor::Show);
        let _closed = terminal::disable_raw_mode();
    }
}
