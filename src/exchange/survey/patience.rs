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
    /// From the end of the last question on so long replies are waited for.
    pub tail: Span,
    /// Whether whoever may have been garbled is asked again.
    pub again: bool,
    /// So many of the first stations are asked once more in any case if they are silent: a late reply that came while
    /// another station was asked leaves no trace.
    pub twice: usize,
    /// Whether the line is left to another master that speaks on it.
    pub yields: bool,
    /// The longest that it takes, but for the time that somebody else of us has the line: whoever is still to be asked then is
    /// left out. `None`: as long as it needs.
    pub limit: Option<Span>,
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
        Patience { window: window.min(full), ..Patience::by_the_book(full) }
    }

    /// A quick look before the setting of the line is changed: of the last station, too, the first byte has been seen if it is
    /// a typical drive. Nobody is asked again.
    pub fn quick(protocol: Protocol, line: LineSetting, question: &Question, full: Span) -> Self {
        let tail = REPLY_DELAY + SLACK + first_byte(Dialect::new(protocol), line) + GLANCE;
        Patience { tail: tail.min(full), again: false, ..Patience::brief(protocol, line, question, full) }
    }

    /// One time around: nobody is asked again, and nobody is waited for at the end.
    pub fn once(self) -> Self {
        Patience { tail: Span::ZERO, again: false, ..self }
    }

    /// Every station gets its full time before the next is asked.
    pub fn by_the_book(full: Span) -> Self {
        Patience { window: full, full, tail: full, again: true, twice: 0, yields: true, limit: None }
    }

    /// How long so many stations take that are silent, on a line that is silent: questions on the wire, windows, the end of the
    /// last ones, and whoever is asked twice.
    pub fn lasts(&self, protocol: Protocol, line: LineSetting, question: &Question, stations: usize) -> Span {
        if stations == 0 {
            return Span::ZERO;
        }
        let mut dialect = Dialect::new(protocol);
        let (length, silence) = (dialect.encode(1, question).len(), dialect.silence(line));
        let one = |window: Span| dialect.duration(line, length) + window.longer(silence);
        let again = if self.again { self.twice.min(stations) } else { 0 };
        let first = one(self.window).times(stations as u64);
        // Unless whoever is asked twice has had his time by then, the last one is waited for first.
        let rest = one(self.window).times((stations - again) as u64) + self.window;
        let pause = if again == 0 || rest >= self.full { Span::ZERO } else { self.tail - self.window };
        let second = if again == 0 { self.window } else { self.second_window() };
        let tail = self.tail.longer(second) - second;
        silence + first + pause + one(second).times(again as u64) + tail
    }

    /// The window of the second time around: another rhythm, so that a reply does not meet the same moment again.
    pub(super) fn second_window(&self) -> Span {
        Span::from_micros(self.window.as_micros() * 5 / 4).min(self.full)
    }
}

/// How long the first byte of a reply may take from the start of it to the program.
fn first_byte(dialect: Dialect, line: LineSetting) -> Span {
    dialect.duration(line, 1) + ADAPTER
}
