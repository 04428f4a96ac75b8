//! The keys of a terminal that was taken over.

use ratatui::crossterm::event::{self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use tokio::sync::mpsc;

/// What a key is good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// q, Escape, Ctrl-C: end.
    Quit,
    /// Tab, right: the next drive.
    Next,
    /// Left: the drive before.
    Previous,
    /// The terminal has another size.
    Redraw,
}

impl Key {
    pub(super) fn of(event: &Event) -> Option<Key> {
        match event {
            Event::Resize(..) => Some(Key::Redraw),
            Event::Key(KeyEvent { kind: KeyEventKind::Release, .. }) => None,
            Event::Key(KeyEvent { code, modifiers, .. }) => match code {
                KeyCode::Char('c' | 'd') if modifiers.contains(KeyModifiers::CONTROL) => Some(Key::Quit),
                KeyCode::Char('q' | 'Q') | KeyCode::Esc => Some(Key::Quit),
                KeyCode::Tab | KeyCode::Right => Some(Key::Next),
                KeyCode::BackTab | KeyCode::Left => Some(Key::Previous),
                KeyCode::Char('l') if modifiers.contains(KeyModifiers::CONTROL) => Some(Key::Redraw),
                _ => None,
            },
            _ => None,
        }
    }
}

/// The keys of a terminal that was taken over, read by a thread of their own.
#[derive(Debug)]
pub struct Keys {
    coming: mpsc::UnboundedReceiver<Key>,
    over: Arc<AtomicBool>,
}

/// So long the thread may outlive its listener.
const LOOK: Duration = Duration::from_millis(100);

impl Keys {
    pub(in crate::render::stream) fn read() -> Self {
        let (send, coming) = mpsc::unbounded_channel();
        let over = Arc::new(AtomicBool::new(false));
        let ends = over.clone();
        std::thread::spawn(move || {
            while !ends.load(Ordering::Relaxed) {
                let key = match event::poll(LOOK) {
                    Ok(false) => continue,
                    Ok(true) => event::read(),
                    Err(error) => Err(error),
                };
                // A terminal that cannot be read has gone; SIGHUP or the next write tells.
                let Ok(key) = key else { return };
                if Key::of(&key).is_some_and(|key| send.send(key).is_err()) {
                    return;
                }
            }
        });
        Keys { coming, over }
    }

    /// The next key; never comes if the terminal is gone.
    pub async fn next(&mut self) -> Key {
        match self.coming.recv().await {
            Some(key) => key,
            None => std::future::pending().await,
        }
    }
}

impl Drop for Keys {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
    }
}
