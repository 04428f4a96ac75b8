//! The terminal while a line is drawn on it again and again: what is typed is not echoed into it, where it would begin another line and
//! leave the old one standing (`^C` behind a bar). What is typed into a run is gone at its end as well: a shell that found it there would do
//! it, and an arrow and Enter are the command of the run once more, unasked.

#[cfg(unix)]
use rustix::termios::{LocalModes, OptionalActions, Termios, tcgetattr, tcgetpgrp, tcsetattr};

/// A terminal that echoes nothing, as long as this lives.
#[derive(Debug)]
pub(super) struct Hush {
    #[cfg(unix)]
    was: Termios,
    #[cfg(unix)]
    end: OptionalActions,
}

impl Hush {
    /// Of the terminal at stdin; of none where stdin is none, or is that of somebody else's job. What is typed is left to who comes
    /// next if `keeps`.
    #[cfg(unix)]
    pub(super) fn begin(keeps: bool) -> Option<Self> {
        let stdin = rustix::stdio::stdin();
        if tcgetpgrp(stdin).is_ok_and(|group| group != rustix::process::getpgrp()) {
            return None;
        }
        let was = tcgetattr(stdin).ok()?;
        let mut hushed = was.clone();
        hushed.local_modes.remove(LocalModes::ECHO);
        tcsetattr(stdin, OptionalActions::Now, &hushed).ok()?;
        Some(Hush { was, end: if keeps { OptionalActions::Now } else { OptionalActions::Flush } })
    }

    /// Where terminals are otherwise, nothing is known of them.
    #[cfg(not(unix))]
    pub(super) fn begin(_keeps: bool) -> Option<Self> {
        None
    }
}

#[cfg(unix)]
impl Drop for Hush {
    fn drop(&mut self) {
        let _gone = tcsetattr(rustix::stdio::stdin(), self.end, &self.was);
    }
}
