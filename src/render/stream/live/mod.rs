//! The whole terminal: what drives do, now and over the last minutes.
//!
//! [`Screen`] knows records and draws them, on any terminal that ratatui can draw on, as much of it as fits.
//! [`Terminal`] takes the real one and gives it back, whatever happens; [`Keys`] listens to it. Over a shaft that turns
//! ([`Late`]) nothing waits for a terminal: what it did not take yet is not drawn over.

mod chart;
mod diagnosis;
mod keys;
mod past;
mod picture;
mod run;
mod screen;
#[cfg(test)]
mod tests;

pub use keys::{Key, Keys};
pub use picture::Picture;

use super::{Form, Manner};
use crate::outcome::Record;
use crate::render::Outlet;
use crate::render::console::forget_what_was_typed;
use keys::Ear;
use ratatui::crossterm::terminal::{self, EnterAlternateScreen, LeaveAlternateScreen};
use ratatui::crossterm::{cursor, execute};
use ratatui::prelude::CrosstermBackend;
use screen::Screen;
use std::io::{self, Write};
use std::time::Duration;

/// The live view on a real terminal.
pub(super) struct Live<'a> {
    terminal: Terminal<'a>,
    screen: Screen,
    holds_stderr: bool,
    /// Something is not drawn yet, because the terminal had not taken what was drawn before.
    owes: bool,
}

impl<'a> Live<'a> {
    /// Takes the terminal over, and listens to it.
    pub(super) fn take(out: Box<dyn Write + 'a>, queue: Option<Outlet>, manner: Manner, ear: Ear) -> io::Result<Self> {
        // Whether there are colours was decided with the settings; crossterm must not look at NO_COLOR for itself.
        ratatui::crossterm::style::force_color_output(manner.color);
        let (terminal, screen) = (Terminal::take(out, queue)?, Screen::new(manner.lang, manner.color));
        let mut live = Live { terminal, screen, holds_stderr: manner.holds_stderr, owes: false };
        ear.listen();
        live.draw()?;
        Ok(live)
    }

    fn draw(&mut self) -> io::Result<()> {
        self.owes = self.terminal.queue.as_ref().is_some_and(|queue| !queue.is_idle());
        if self.owes {
            return Ok(());
        }
        self.terminal.inner.draw(|frame| self.screen.draw(frame)).map(|_| ())
    }
}

impl Form for Live<'_> {
    fn catch_up(&mut self) -> io::Result<()> {
        if self.owes { self.draw() } else { Ok(()) }
    }

    fn record(&mut self, record: &Record) -> io::Result<()> {
        self.screen.record(record);
        self.draw()
    }

    fn note(&mut self, text: &str) -> io::Result<bool> {
        if !text.is_empty() {
            self.screen.note(text);
            self.draw()?;
        }
        Ok(self.holds_stderr)
    }

    fn press(&mut self, key: Key) -> io::Result<()> {
        match key {
            Key::Next => self.screen.turn(1),
            Key::Previous => self.screen.turn(-1),
            Key::Diagnosis => self.screen.diagnoses = !self.screen.diagnoses && self.screen.run.is_some(),
            _ => {}
        }
        self.draw()
    }
}

/// The live view of a run: the terminal is taken over once somebody agreed to it.
pub(super) struct Late {
    queue: Outlet,
    manner: Manner,
    ear: Option<Ear>,
    live: Option<Live<'static>>,
}

impl Late {
    pub(super) fn new(queue: Outlet, manner: Manner, ear: Ear) -> Self {
        Late { queue, manner, ear: Some(ear), live: None }
    }
}

impl Form for Late {
    fn catch_up(&mut self) -> io::Result<()> {
        self.live.as_mut().map_or(Ok(()), Form::catch_up)
    }

    fn record(&mut self, record: &Record) -> io::Result<()> {
        if let (Record::Start(_), Some(ear)) = (record, self.ear.take()) {
            let out = Box::new(self.queue.at_once());
            self.live = Some(Live::take(out, Some(self.queue.clone()), self.manner, ear)?);
        }
        self.live.as_mut().map_or(Ok(()), |live| live.record(record))
    }

    fn note(&mut self, text: &str) -> io::Result<bool> {
        self.live.as_mut().map_or(Ok(false), |live| live.note(text))
    }

    fn press(&mut self, key: Key) -> io::Result<()> {
        self.live.as_mut().map_or(Ok(()), |live| live.press(key))
    }
}

/// A terminal that was taken over; dropping it gives it back.
pub(super) struct Terminal<'a> {
    inner: ratatui::Terminal<CrosstermBackend<Box<dyn Write + 'a>>>,
    /// What is drawn waits here for the terminal to take it.
    queue: Option<Outlet>,
}

/// What is pasted says so (xterm "bracketed paste"), so that it is not taken for keys.
const PASTES: &[u8] = b"\x1b[?2004h";
const NO_PASTES: &[u8] = b"\x1b[?2004l";
/// So long a terminal may take nothing before it is left as it is.
const PATIENCE: Duration = Duration::from_secs(2);

impl<'a> Terminal<'a> {
    /// Whether there is a terminal that can be taken over.
    pub(super) fn is_there() -> bool {
        let is_there = terminal::enable_raw_mode().is_ok() && terminal::size().is_ok();
        let _as_it_was = terminal::disable_raw_mode();
        is_there
    }

    /// Takes the terminal over. What was typed before it meant something else.
    fn take(out: Box<dyn Write + 'a>, queue: Option<Outlet>) -> io::Result<Self> {
        let mut terminal = Terminal { inner: ratatui::Terminal::new(CrosstermBackend::new(out))?, queue };
        terminal::enable_raw_mode()?;
        forget_what_was_typed();
        execute!(terminal.inner.backend_mut(), EnterAlternateScreen, cursor::Hide)?;
        terminal.inner.backend_mut().write_all(PASTES)?;
        Ok(terminal)
    }
}

impl Drop for Terminal<'_> {
    fn drop(&mut self) {
        let _closed = self.inner.backend_mut().write_all(NO_PASTES);
        let _closed = execute!(self.inner.backend_mut(), LeaveAlternateScreen, cursor::Show);
        self.queue.iter().for_each(|queue| queue.drain(Some(PATIENCE)));
        // What ratatui shows again by itself has nowhere to fail: of a closed terminal it would tell on stderr, and panic there.
        *self.inner.backend_mut() = CrosstermBackend::new(Box::new(io::sink()));
        // Who still leans on a key does not type it into the shell.
        forget_what_was_typed();
        let _closed = terminal::disable_raw_mode();
    }
}
