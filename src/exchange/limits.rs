//! Time limits of a conversation, and the end that no byte can put off.

use super::dialect::Dialect;
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::rtu;
use crate::tick::{Span, Tick};

use super::twins::SECOND_WITHIN;

/// Time limits of a conversation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// From the end of the request until its reply is given up.
    pub reply_timeout: Span,
    /// How often a question is repeated.
    pub retries: u8,
    /// Pause after a reply, so that the drive can switch off its transmitter.
    pub pause: Span,
    /// Pause after a broadcast, so that everybody can obey.
    pub turnaround: Span,
    /// The longest that a telegram waits for a silent line, or for what a station still owes; then it goes out even into a
    /// busy line. `None`: it waits for its turn, and a line that is never silent fails the question.
    pub insist: Option<Span>,
    /// An answer is asked for once more where it may be another's. Not what is cleared by reading, such as the register
    /// that tells why a drive said no, and not what wears by being written.
    pub witness: bool,
    /// No answer is believed that may be one to the same question from before this time. What proves a stop is asked so.
    pub since: Option<Tick>,
    /// So long behind the answer a second one is listened for, which only two drives at one address give.
    pub listen: Span,
    /// Others wait for the line: until no copy of anything can come is their time, so what may be one ends the question.
    pub gives_way: bool,
    /// A shaft depends on it: words of a moment ago are doubted only where something warned of copies.
    pub hastens: bool,
}

impl Default for Limits {
    fn default() -> Self {
        Limits {
            reply_timeout: Span::from_millis(500), // CM-485 manual 6.8
            retries: 2,
            pause: Span::from_millis(2),        // CM-485 manual 6.8
            turnaround: Span::from_millis(100), // MODBUS over Serial Line V1.02, 2.4.1: typically 100-200 ms
            insist: None,
            witness: true,
            since: None,
            listen: Span::ZERO,
            gives_way: false,
            hastens: false,
        }
    }
}

/// What must not wait for a busy line waits so long: a tenth of the shortest watchdog that a drive can be given (P.413: 1 s,
/// CM-485 manual 11.2), and as long as a broadcast gives everybody to obey (MODBUS over Serial Line V1.02, 2.4.1).
pub const INSIST: Span = Span::from_millis(100);
/// A line that is not silent for so long, beside one longest telegram, belongs to somebody else.
pub(super) const BUSY: Span = Span::from_secs(1);
/// Later than this no reply comes: 6 s were seen behind gateways, and a second for whoever is slower.
pub(super) const LATEST_OF_ALL: Span = Span::from_secs(7);
/// A gateway that got no answer from a station that has answered before is asked so often again: one telegram was lost on the
/// line behind it.
pub(super) const UNREACHED_REPEATS: u8 = 1;
/// How often a question is asked anew because its answer may be an older one.
pub(super) const ROUNDS: u8 = 2;
/// How often it is asked so that answers agree, where one that was overtaken may come.
pub(super) const WITNESSES: usize = 3;
/// The same where nothing keeps replies in order and many are on their way; all of it ends within [`Limits::longest`] as well.
pub(super) const MOST_WITNESSES: usize = 6;

impl Limits {
    /// The longest that one question takes, whatever comes over the line. It is asked, and in the worst case asked again
    /// twice behind a fence and three times for a witness, every time as often as it is repeated; once the line must become
    /// silent, once a reply that is still owed is waited for, once one that was overtaken, and once more the answer to a
    /// fence; and a second answer is listened for.
    pub fn longest(&self, protocol: Protocol, line: LineSetting) -> Span {
        let again = 1 + 2 * u64::from(ROUNDS) + WITNESSES as u64;
        let seconds = SECOND_WITHIN.times(2 * (1 + u64::from(ROUNDS)));
        let tries = self.tries(protocol, line).times(again);
        tries + seconds + self.patience(protocol, line) + LATEST_OF_ALL.times(3) + self.turnaround + self.listen
    }

    /// The longest that all tries of a question take of which nobody doubts whose answer comes.
    pub fn tries(&self, protocol: Protocol, line: LineSetting) -> Span {
        let dialect = Dialect::new(protocol);
        let telegram = dialect.duration(line, rtu::MAX_FRAME);
        (telegram + self.reply_timeout + dialect.longest_straggle()).times(u64::from(self.retries) + 1)
    }

    /// How long all telegrams of a question together wait for a silent line.
    pub(super) fn patience(&self, protocol: Protocol, line: LineSetting) -> Span {
        BUSY + Dialect::new(protocol).duration(line, rtu::MAX_FRAME)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;
    use crate::protocol::modbus::Framing;

    #[test]
    fn the_longest_question_is_the_sum_of_everything_that_can_be_waited_for() {
        let limits = Limits {
            reply_timeout: Span::from_millis(300),
            retries: 1,
            turnaround: Span::from_millis(70),
            listen: Span::from_millis(9),
            ..Limits::default()
        };
        let line = LineSetting::rtu(19_200, Parity::Even);
        let longest = |protocol: Protocol| limits.longest(protocol, line).as_micros() / 1_000;
        // Behind a gateway no byte takes time: 2 x 8 tries of 300 + 50 ms, six second answers of 600 ms, 1 s for a busy line,
        // three times the latest reply of 7 s, the turnaround, and a second answer.
        assert_eq!(longest(Framing::Tcp.into()), 16 * 350 + 6 * 600 + 1_000 + 21_000 + 79);
        // 256 characters of 11 bits at 19200 Bd take 146.7 ms, in every try and once on a busy line.
        assert_eq!(longest(Framing::Rtu.into()), 16 * 350 + 6 * 600 + 1_000 + 21_000 + 79 + 17 * 146_667 / 1_000);
        // ASCII may dawdle a second between two characters.
        assert_eq!(longest(Framing::Ascii.into()) - longest(Framing::Rtu.into()), 16 * 950);
    }
}
