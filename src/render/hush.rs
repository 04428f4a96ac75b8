//! The terminal while a run is shown by its line: what is typed is not echoed into it, and gone at its end. A shell that found it there
//! would do it: an arrow and Enter are the command of the run once more, unasked.

#[cfg(unix)]
use rustix::termios::{LocalModes, OptionalActions, Termios, tcgetattr, tcgetpgrp, tcsetattr};

/// A terminal that echoes nothing, as long as this lives.
#[derive(Debug)]
pub(super) struct Hush {
    #[cfg(unix)]
    was: Termios,
}

impl Hush {
    /// Of the terminal at stdin; of none where stdin is none, or is that of somebody else's job.
    #[cfg(unix)]
    pub(super) fn begin() -> Option<Self> {
        let stdin = rustix::stdio::stdin();
        if tcgetpgrp(stdin).is_ok_and(|group| group != rustix::process::getpgrp()) {
            return None;
        }
        let was = tcgetattr(stdin).ok()?;
        let mut hushed = was.clone();
        hushed.local_modes.remove(LocalModes::ECHO);
        tcsetattr(stdin, OptionalActions::Now, &hushed).ok()?;
        Some(Hush { was })
    }

    /// Where terminals are otherwise, nothing is known of them.
    #[cfg(not(unix))]
    pub(super) fn begin() -> Option<Self> {
        None
    }
}

#[cfg(unix)]
impl Drop for Hush {
    fn drop(&mut self) {
        let _gone = tcsetattr(rustix::stdio::stdin(), OptionalActions::Flush, &self.was);
    }
}
