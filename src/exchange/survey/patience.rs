//! How long a survey waits for its stations, so that the next question meets no reply.

use crate::exchange::dialect::{Dialect, Question};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::tick::Span;

/// How long stations are waited for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patience {
    /// From the end of a question until the next one is sent, if nothing comes.
    pub window: Span,
    /// From the end of a question until its reply cannot come any more.
    pub full: Span,
    /// Whether late replies are waited for at the end, and whoever may have been garbled is asked again.
    pub thorough: bool,
    /// So many of the first stations are asked once more in any case if they are silent: a late reply that came while
    /// another station was asked leaves no trace.
    pub twice: usize,
    /// Whether the line is left to another master that speaks on it.
    pub yields: bool,
}

/// A drive answers not before 10 ms (CM-485 manual 6.8).
const REPLY_DELAY: Span = Span::from_millis(10);
/// What a drive may take longer than that without being late.
const SLACK: Span = Span::from_millis(2);
/// USB adapters hold bytes back for up to 16 ms (docs/measured.md: latency timer of FTDI).
pub(super) const ADAPTER: Span = Span::from_millis(16);
/// A look at a setting may take so much longer than a typical drive does, because nobody listens there any more when it
/// is over.
const GLANCE: Span = Span::from_millis(20);
/// Pause of the manual after a reply (CM-485 manual 6.8).
pub(super) const PAUSE: Span = Span::from_millis(2);

impl Patience {
    /// The window is just long enough for a typical drive: its reply is over by then, so the next question does not
    /// meet it whatever the adapter holds back; on slow lines its first byte has been seen, and the rest is waited for.
    pub fn brief(protocol: Protocol, line: LineSetting, question: &Question, full: Span) -> Self {
        let mut dialect = Dialect::new(protocol);
        // The reply is a little shorter than the question.
        let length = dialect.encode(1, question).len().saturating_sub(1);
        let whole = dialect.duration(line, length) + dialect.gap(line, PAUSE);
        let window = REPLY_DELAY + SLACK + whole.min(first_byte(dialect, line));
        Patience { window: window.min(full), full, thorough: true, twice: 0, yields: true }
    }

    /// A short look before the setting of the line is changed: the first byte of a typical drive has been seen.
    pub fn glance(protocol: Protocol, line: LineSetting, full: Span) -> Self {
        let window = REPLY_DELAY + SLACK + first_byte(Dialect::new(protocol), line) + GLANCE;
        Patience { window: window.min(full), full, thorough: false, twice: 0, yields: true }
    }

    /// Every station gets its full time before the next is asked.
    pub fn by_the_book(full: Span) -> Self {
        Patience { window: full, full, thorough: true, twice: 0, yields: true }
    }
}

/// How long the first byte of a reply may take from the start of it to the program.
fn first_byte(dialect: Dialect, line: LineSetting) -> Span {
    dialect.duration(line, 1) + ADAPTER
}
