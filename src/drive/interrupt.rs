//! The wish to stop, from Ctrl-C and other signals.

use super::panel::{Button, Panel};
use crate::tick::Tick;
use std::sync::Arc;
use std::sync::atomic::{AtomicU32, Ordering};
use tokio::sync::Notify;

/// A wish to stop that every wait on the line listens to. All clones hear of the same wishes; each may have taken note
/// of some of them already.
#[derive(Clone, Debug, Default)]
pub struct Interrupt {
    inner: Arc<(AtomicU32, Notify)>,
    /// Wishes that were taken note of and no longer count here.
    noted: u32,
    panel: Panel,
}

impl Interrupt {
    /// What the same somebody sees of a held run, and its keypad.
    pub fn panel(&self) -> &Panel {
        &self.panel
    }

    /// A button of the keypad was pressed. What stops a run is a wish like another.
    pub fn button(&self, button: Button, at: Tick) {
        if self.panel.press(button, at) {
            self.wish();
        }
    }

    /// Looks whether a key is still held that must be.
    pub fn look(&self, at: Tick) {
        if self.panel.look(at) {
            self.wish();
        }
    }

    /// Wishes that everything ends, where nobody has wished that before: for what comes of itself and perhaps more than
    /// once, such as a hang-up and the closed pipe behind it.
    pub fn raise(&self) {
        self.panel.leave();
        let _was_raised = self.inner.0.compare_exchange(0, OF_ITSELF, Ordering::Relaxed, Ordering::Relaxed);
        self.inner.1.notify_waiters();
    }

    /// Wishes it once more, as somebody does who presses Ctrl-C again.
    pub fn press(&self) {
        self.panel.leave();
        self.wish();
    }

    fn wish(&self) {
        self.inner.0.fetch_add(PRESS, Ordering::Relaxed);
        self.inner.1.notify_waiters();
    }

    /// Whether somebody asked to stop.
    pub fn is_raised(&self) -> bool {
        self.inner.0.load(Ordering::Relaxed) > self.noted
    }

    /// Resolves when somebody asks to stop.
    pub async fn raised(&self) {
        loop {
            let notified = self.inner.1.notified();
            if self.is_raised() {
                return;
            }
            notified.await;
        }
    }

    /// Hears only who presses: what must be done goes on where nobody reads what is told of it.
    pub fn hear_only_keys(&mut self) {
        self.noted = self.noted.max(OF_ITSELF);
    }

    /// Takes note of every wish so far, and of one that comes of itself, such as a pipe that closes while the end is on
    /// its way: only who presses from now on counts.
    pub fn note(&mut self) {
        self.noted = self.inner.0.load(Ordering::Relaxed).max(OF_ITSELF);
    }

    /// How often somebody has pressed, as far as note was taken of it.
    pub fn presses(&self) -> u32 {
        self.noted / PRESS
    }
}

/// What a wish that comes of itself counts, once.
const OF_ITSELF: u32 = 1;
/// What a pressed key counts: more than what comes of itself.
const PRESS: u32 = 2;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_who_presses_again_is_heard_again() {
        let signals = Interrupt::default();
        let mut here = signals.clone();
        signals.raise();
        assert!(here.is_raised());
        here.note();
        signals.raise();
        assert!(!here.is_raised(), "a hang-up and a closed pipe are one wish");
        signals.press();
        assert!(here.is_raised());
        assert!(signals.is_raised(), "what one has noted the others still hear");
    }

    #[test]
    fn presses_are_counted_however_many_are_noted_at_once() {
        for of_itself in [false, true] {
            let signals = Interrupt::default();
            let mut here = signals.clone();
            if of_itself {
                signals.raise();
            }
            here.note();
            assert_eq!(here.presses(), 0, "a hang-up is no press");
            signals.press();
            signals.press();
            assert_eq!(here.presses(), 0, "not noted yet");
            here.note();
            assert_eq!(here.presses(), 2);
            assert_eq!(here.clone().presses(), 2);
        }
    }

    #[test]
    fn where_only_keys_are_heard_a_closed_pipe_ends_nothing() {
        let signals = Interrupt::default();
        let mut here = signals.clone();
        here.hear_only_keys();
        signals.raise();
        assert!(!here.is_raised());
        signals.press();
        assert!(here.is_raised());
    }

    #[test]
    fn a_pipe_that_closes_while_the_end_is_on_its_way_is_no_wish_for_more() {
        let signals = Interrupt::default();
        let mut here = signals.clone();
        here.note();
        signals.raise();
        assert!(!here.is_raised());
        signals.press();
        assert!(here.is_raised());
    }
}
