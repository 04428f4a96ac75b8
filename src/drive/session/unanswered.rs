//! What nobody answers, and must be said while it goes on being sent.

use super::Session;
use crate::outcome::Event;
use crate::text::Text;
use crate::tick::{Span, Tick};

/// Without a valid answer for so long it is said.
const LONG: Span = Span::from_secs(2);

/// What is said where no answer comes.
#[derive(Debug)]
pub(super) struct Warns {
    told: bool,
    text: Text,
    /// The last valid answer, or the beginning.
    since: Tick,
}

impl Session<'_> {
    /// From now on this is told, once, where no valid answer comes for 2 s; what began to count before goes on.
    pub(in crate::drive) fn warns(&mut self, text: Text) {
        let since = self.now();
        self.warns.get_or_insert(Warns { told: false, text, since });
    }

    /// What is sent from now on may stay unanswered.
    pub(in crate::drive) fn warns_no_more(&mut self) {
        self.warns = None;
    }

    /// A question was answered, or not.
    pub(super) fn heeds(&mut self, is_answered: bool) {
        let now = self.now();
        let Some(warns) = &mut self.warns else { return };
        if is_answered {
            warns.since = now;
        } else if now.since(warns.since) >= LONG && !std::mem::replace(&mut warns.told, true) {
            let note = Event::Note(warns.text.clone());
            self.tell(note);
        }
    }
}
