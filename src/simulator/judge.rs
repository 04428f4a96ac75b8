//! The judge: what the master did that no master may do, by the manual and not by what our own master does.
//!
//! It sees only when the master spoke and what, when drives answered, and it never keeps anybody from answering.

use crate::protocol::line::LineSetting;
use crate::protocol::modbus::{Adu, FrameError, Framing, ascii, rtu};
use crate::tick::{Span, Tick};
use std::fmt;

/// What the judge noted about the master.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// When it happened.
    pub at: Tick,
    /// Which rule was broken.
    pub kind: Sin,
    /// What happened, with figures.
    pub text: String,
}

/// Rules that a master can break.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sin {
    /// A request less than 2 ms, or t3.5 on RTU, after the last bit of a reply (CM-485 manual 6.8, 6.7.1.3).
    TooEarly,
    /// A request while a drive answers, or while a drive that took the last one has not yet answered and 500 ms are
    /// not over (CM-485 manual 6.8); two telegrams at once.
    WhileBusy,
    /// A request less than 500 ms after one that no drive has taken (CM-485 manual 6.8): no drive is disturbed, but
    /// the master could not know that.
    Impatient,
    /// A pause of more than 1.5 characters inside an RTU telegram, or of more than 1 s inside an ASCII one
    /// (CM-485 manual 6.7.1.3, 6.7.2.2).
    GapInside,
    /// Less than 3.5 characters between two RTU telegrams of the master (CM-485 manual 6.7.1.3).
    GapBefore,
    /// A broadcast that is no write (CM-485 manual 6.1).
    BroadcastRead,
    /// Bytes that are no telegram: check value, length, digits, address, character format.
    Malformed,
}

impl Sin {
    /// A stable word for it: `too-early`.
    pub fn name(self) -> &'static str {
        match self {
            Sin::TooEarly => "too-early",
            Sin::WhileBusy => "while-busy",
            Sin::Impatient => "impatient",
            Sin::GapInside => "gap-inside",
            Sin::GapBefore => "gap-before",
            Sin::BroadcastRead => "broadcast-read",
            Sin::Malformed => "malformed",
        }
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {} ({})", self.at.since(Tick::ZERO), self.text, self.kind.name())
    }
}

/// After this time without a reply the master may ask again (CM-485 manual 6.8).
pub(super) const REPLY_TIMEOUT: Span = Span::from_millis(500);
/// Time that a drive needs to switch its transmitter off (CM-485 manual 6.8).
pub(super) const TURNAROUND: Span = Span::from_millis(2);
/// Remarks kept; a bench that runs for weeks must not fill the memory.
const MOST_REMARKS: usize = 1_000;

/// Bytes kept of a telegram that does not end: more than the longest ASCII frame has.
const MOST_BYTES: usize = 1_024;

/// A telegram of the master, whole or not.
#[derive(Clone, Debug)]
pub(super) struct Telegram {
    /// Start of the first start bit.
    pub(super) start: Tick,
    /// End of the last stop bit.
    pub(super) end: Tick,
    pub(super) line: LineSetting,
    pub(super) framing: Framing,
    bytes: Vec<u8>,
    /// A pause was inside, so that drives discard it.
    pub(super) torn: bool,
}

impl Telegram {
    fn limits(&self) -> (Span, Span) {
        match self.framing {
            Framing::Rtu => (self.line.t15(), self.line.t35()),
            Framing::Ascii => (ascii::MAX_PAUSE, ascii::MAX_PAUSE),
        }
    }

    pub(super) fn decode(&self) -> Result<Adu, FrameError> {
        self.framing.decode(&self.bytes)
    }
}

/// A request that waits for its reply.
#[derive(Clone, Copy, Debug)]
struct Asked {
    end: Tick,
    station: u8,
    /// A drive has taken it.
    taken: bool,
}

/// The judge's notebook.
#[derive(Clone, Debug, Default)]
pub(super) struct Judge {
    remarks: Vec<Remark>,
    count: u64,
    open: Option<Telegram>,
    /// End of the last whole telegram, and the silence that must follow it.
    last: Option<(Tick, Span)>,
    asked: Option<Asked>,
    /// A drive sends until then.
    answering: Option<Tick>,
    /// Last bit of the last reply, and the rest that must follow it.
    reply: Option<(Tick, Span)>,
    /// What the 500 ms rules allow for, where telegrams may be read late.
    pub(super) slack: Span,
}

impl Judge {
    pub(super) fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Remarks made, also those that were too many to be kept.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    pub(super) fn remark(&mut self, at: Tick, kind: Sin, text: String) {
        self.count = self.count.saturating_add(1);
        if self.remarks.len() < MOST_REMARKS {
            self.remarks.push(Remark { at, kind, text });
        }
    }

    /// The telegram that is over because the master starts to send at `at`.
    pub(super) fn before(&mut self, at: Tick) -> Option<Telegram> {
        let open = self.open.as_ref()?;
        let over = open.decode().is_ok() || at.since(open.end) >= open.limits().1;
        over.then(|| self.close()).flatten()
    }

    /// The telegram that is over because nothing came until `now`.
    pub(super) fn settle(&mut self, now: Tick) -> Option<Telegram> {
        let open = self.open.as_ref()?;
        let complete = open.framing == Framing::Ascii && open.decode().is_ok() && now >= open.end;
        (complete || (now >= open.end && now.since(open.end) >= open.limits().1)).then(|| self.close()).flatten()
    }

    fn close(&mut self) -> Option<Telegram> {
        let telegram = self.open.take()?;
        let rest = if telegram.framing == Framing::Rtu { telegram.line.t35() } else { Span::ZERO };
        self.last = Some((telegram.end, rest));
        Some(telegram)
    }

    /// The master starts to send.
    pub(super) fn sends(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) {
        let end = at + line.chars(bytes.len() as u64);
        if let Some(mut open) = self.open.take() {
            let (pause, _) = open.limits();
            if at < open.end {
                self.remark(at, Sin::WhileBusy, "the master sends while it is still sending".to_owned());
            } else if at.since(open.end) > pause && !open.torn {
                let text = format!("{} of silence inside a telegram, at most {pause} allowed", at.since(open.end));
                self.remark(at, Sin::GapInside, text);
                open.torn = true;
            }
            let room = MOST_BYTES.saturating_sub(open.bytes.len());
            open.bytes.extend(bytes.iter().take(room));
            open.end = open.end.max(end);
            self.open = Some(open);
            return;
        }
        self.weigh_start(at);
        self.asked = None;
        let framing = if looks_ascii(bytes) { Framing::Ascii } else { Framing::Rtu };
        self.open = Some(Telegram {
            start: at,
            end,
            line,
            framing,
            bytes: bytes.iter().copied().take(MOST_BYTES).collect(),
            torn: false,
        });
    }

    /// Holds the start of a telegram against everything that was on the wire before.
    fn weigh_start(&mut self, at: Tick) {
        if let Some((end, rest)) = self.last.filter(|&(end, rest)| at < end + rest) {
            if at < end {
                return self.remark(at, Sin::WhileBusy, "the master sends while it is still sending".to_owned());
            }
            let silence = at.since(end);
            let text = format!("{silence} of silence between two telegrams, at least {rest} required");
            return self.remark(at, Sin::GapBefore, text);
        }
        if self.answering.is_some_and(|until| at < until) {
            return self.remark(at, Sin::WhileBusy, "the master sends while a drive answers".to_owned());
        }
        if let Some(asked) = self.asked.filter(|asked| at.since(asked.end) + self.slack < REPLY_TIMEOUT) {
            let (since, station) = (at.since(asked.end), asked.station);
            let (kind, who) = match asked.taken {
                true => (Sin::WhileBusy, "has not answered yet"),
                false => (Sin::Impatient, "does not answer"),
            };
            let text = format!("request {since} after one to station {station}, which {who}; wait {REPLY_TIMEOUT}");
            return self.remark(at, kind, text);
        }
        if let Some((end, rest)) = self.reply.filter(|&(end, rest)| at < end + rest) {
            let text = format!("request {} after the end of a reply, at least {rest} required", at.since(end));
            self.remark(at, Sin::TooEarly, text);
        }
    }

    /// A request to a station is complete; `taken` if a drive will answer.
    pub(super) fn asked(&mut self, end: Tick, station: u8, taken: bool) {
        self.asked = Some(Asked { end, station, taken });
    }

    /// The drive at `station` sends from now on, until `until`.
    pub(super) fn answers(&mut self, station: u8, until: Tick) {
        self.asked = self.asked.filter(|asked| asked.station != station);
        self.answering = self.answering.max(Some(until));
    }

    /// A byte of a drive was complete at `end`; `rest` must follow the last of them.
    pub(super) fn heard(&mut self, end: Tick, rest: Span) {
        self.reply = Some((end, rest.longer(TURNAROUND)));
    }
}

/// Whether the master speaks ASCII: from `:` on only characters that occur in such telegrams. An RTU telegram to
/// station 58 also starts with `:`, but holds other bytes.
fn looks_ascii(bytes: &[u8]) -> bool {
    let fits = |byte: &u8| byte.is_ascii_hexdigit() || matches!(byte, b':' | b'\r' | b'\n');
    bytes.first() == Some(&ascii::START) && bytes.iter().all(fits)
}

/// Why an RTU telegram cannot be one, beside its bytes.
pub(super) fn wrong_format(telegram: &Telegram) -> Option<String> {
    match telegram.framing {
        Framing::Rtu if telegram.line.data_bits != 8 => {
            Some(format!("an RTU telegram needs 8 data bits, not {}", telegram.line))
        }
        Framing::Rtu if telegram.bytes.len() > rtu::MAX_FRAME => Some("an RTU telegram of over 256 bytes".to_owned()),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;

    const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);
    const READ: [u8; 8] = [0x01, 0x03, 0x21, 0x74, 0x00, 0x01, 0xCE, 0x2C];

    fn sins(judge: &Judge) -> Vec<Sin> {
        judge.remarks.iter().map(|remark| remark.kind).collect()
    }

    #[test]
    fn a_gap_inside_and_a_missing_gap_before() {
        let mut judge = Judge::default();
        judge.sends(Tick::ZERO, LINE, &READ[..3]);
        let later = Tick::ZERO + LINE.chars(3) + LINE.t15() + Span::from_micros(1);
        assert!(judge.before(later).is_none());
        judge.sends(later, LINE, &READ[3..]);
        let end = later + LINE.chars(5);
        let early = end + (LINE.t35() - Span::from_micros(1));
        assert!(judge.before(early).is_some_and(|telegram| telegram.torn));
        judge.sends(early, LINE, &READ);
        assert_eq!(sins(&judge), [Sin::GapInside, Sin::GapBefore]);
    }

    #[test]
    fn chunks_of_one_telegram_are_no_sin() {
        let mut judge = Judge::default();
        let mut at = Tick::ZERO;
        for byte in READ {
            assert!(judge.before(at).is_none());
            judge.sends(at, LINE, &[byte]);
            at = at + LINE.chars(1) + LINE.t15();
        }
        let telegram = judge.settle(at + LINE.t35()).unwrap();
        assert!(telegram.decode().is_ok() && !telegram.torn);
        assert_eq!(sins(&judge), []);
    }

    #[test]
    fn rest_after_a_reply_and_patience_before_it() {
        let mut judge = Judge::default();
        judge.asked(Tick::ZERO, 1, true);
        judge.sends(Tick::ZERO + Span::from_millis(499), LINE, &READ);
        judge.open = None;
        judge.asked(Tick::ZERO, 77, false);
        judge.sends(Tick::ZERO + Span::from_millis(25), LINE, &READ);
        judge.open = None;
        let reply = Tick::ZERO + Span::from_secs(1);
        judge.answers(1, reply);
        judge.sends(reply + Span::from_millis(9), LINE, &READ);
        judge.open = None;
        judge.heard(reply, LINE.t35());
        judge.sends(reply + Span::from_millis(2), LINE, &READ);
        judge.open = None;
        judge.sends(reply + LINE.t35(), LINE, &READ);
        assert_eq!(sins(&judge), [Sin::WhileBusy, Sin::Impatient, Sin::TooEarly]);
    }
}
