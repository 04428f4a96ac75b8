//! The judge: what the master did that no master may do, by the manual and not by what our own master does.
//!
//! It sees only when the master spoke and what, when drives answered, and it never keeps anybody from answering.

use super::gaps::GapLog;
use super::setup::Spoken;
use super::vabus::PAUSE;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::{Adu, FrameError, ascii, rtu};
use crate::protocol::vabus::{self, Address, EOT, ParamNumber, Reply, Request, SystemNode, TelegramError};
use crate::tick::{Span, Tick};
use std::collections::BTreeSet;
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
    /// VABus: a SELECT to a drive that sent NAK and whose P.11 has not been read since (facts A2).
    Locked,
    /// VABus: more than three transmissions of one telegram without a good reply or an EOT between them (facts A2).
    TooOften,
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
            Sin::Locked => "locked",
            Sin::TooOften => "too-often",
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
/// Transmissions of one telegram in one exchange of VABus (facts A2).
const MOST_TRANSMISSIONS: u32 = 3;
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
    bytes: Vec<u8>,
    /// A pause was inside, so that drives discard it.
    pub(super) torn: bool,
}

/// What a telegram of a master says.
pub(super) enum Spelt {
    Modbus(Result<Adu, FrameError>),
    /// `None` for an EOT alone, which ends an exchange.
    Vabus(Result<Option<Request>, TelegramError>),
}

impl Telegram {
    /// The protocol that the master means, as far as the bytes tell until now.
    pub(super) fn spoken(&self) -> Spoken {
        if looks_ascii(&self.bytes) {
            Spoken::ASCII
        } else if looks_vabus(self.line, &self.bytes) {
            Spoken::Vabus
        } else {
            Spoken::RTU
        }
    }

    fn limits(&self) -> (Span, Span) {
        match self.spoken() {
            Spoken::ASCII => (ascii::MAX_PAUSE, ascii::MAX_PAUSE),
            Spoken::Vabus => (PAUSE, PAUSE),
            Spoken::Modbus(_) | Spoken::PBus => (self.line.t15(), self.line.t35()),
        }
    }

    pub(super) fn spelt(&self) -> Spelt {
        match self.spoken() {
            Spoken::Modbus(framing) => Spelt::Modbus(framing.decode(&self.bytes)),
            Spoken::Vabus | Spoken::PBus if self.is_end() => Spelt::Vabus(Ok(None)),
            Spoken::Vabus | Spoken::PBus => Spelt::Vabus(Request::decode(self.vabus_bytes()).map(Some)),
        }
    }

    /// Whether it is an EOT alone, until now.
    fn is_end(&self) -> bool {
        self.bytes.iter().all(|&byte| byte == EOT)
    }

    /// A request without what ended the exchange before it.
    fn vabus_bytes(&self) -> &[u8] {
        let ends = self.bytes.iter().take_while(|&&byte| byte == EOT).count();
        self.bytes.get(ends.saturating_sub(1)..).unwrap_or_default()
    }

    /// Whether nothing can be missing at its end. Behind an EOT a telegram may follow.
    fn complete(&self) -> bool {
        matches!(self.spelt(), Spelt::Modbus(Ok(_)) | Spelt::Vabus(Ok(Some(_))))
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
    /// VABus: drives that sent NAK and whose P.11 has not been told since.
    locked: BTreeSet<Address>,
    /// VABus: the last request, and how often it was sent without a good reply.
    repeated: Option<(Request, u32)>,
    pub(super) gaps: GapLog,
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

    /// The telegram that is over because the master starts to send `bytes` at `at`; with another setting, or behind an EOT
    /// that they do not continue, they are another telegram.
    pub(super) fn before(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) -> Option<Telegram> {
        let open = self.open.as_ref()?;
        let continues = bytes.first().is_some_and(|&byte| byte == EOT || Address::from_character(byte).is_ok());
        let parted = open.line != line || (open.is_end() && !continues);
        let over = open.complete() || parted || at.since(open.end) >= open.limits().1;
        over.then(|| self.close()).flatten()
    }

    /// The telegram that is over because nothing came until `now`.
    pub(super) fn settle(&mut self, now: Tick) -> Option<Telegram> {
        let open = self.open.as_ref()?;
        let complete = open.spoken() != Spoken::RTU && open.complete() && now >= open.end;
        (complete || (now >= open.end && now.since(open.end) >= open.limits().1)).then(|| self.close()).flatten()
    }

    fn close(&mut self) -> Option<Telegram> {
        let telegram = self.open.take()?;
        let rest = if telegram.spoken() == Spoken::RTU { telegram.line.t35() } else { Span::ZERO };
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
        self.open = Some(Telegram {
            start: at,
            end,
            line,
            bytes: bytes.iter().copied().take(MOST_BYTES).collect(),
            torn: false,
        });
    }

    /// Holds the start of a telegram against everything that was on the wire before.
    fn weigh_start(&mut self, at: Tick) {
        let behind_reply = |end: Tick| at >= end && self.last.is_none_or(|(last, _)| last < end);
        if let Some((end, rest)) = self.reply.filter(|&(end, _)| behind_reply(end)) {
            self.gaps.note(at.since(end), rest);
        }
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

    /// A request of VABus is complete: whether the master may send it, and how often.
    pub(super) fn weigh_request(&mut self, at: Tick, request: &Request) {
        let count = match self.repeated.take() {
            Some((last, count)) if last == *request => count + 1,
            _ => 1,
        };
        self.repeated = Some((request.clone(), count));
        if count > MOST_TRANSMISSIONS {
            let text = format!("transmission {count} of one telegram, at most {MOST_TRANSMISSIONS} allowed");
            self.remark(at, Sin::TooOften, text);
        }
        if matches!(request, Request::Select { address, .. } if self.locked.contains(address)) {
            let address = request.address();
            let text = format!("SELECT to drive {address} after its NAK; P.11 has to be read first");
            self.remark(at, Sin::Locked, text);
        }
    }

    /// The master ends an exchange of VABus.
    pub(super) fn ends_exchange(&mut self) {
        self.repeated = None;
    }

    /// A drive puts this reply on the wire, as the master will hear it.
    pub(super) fn overhears(&mut self, frame: &[u8]) {
        let Ok(reply) = vabus::Reply::decode(frame) else { return };
        self.repeated = None;
        match reply {
            Reply::Nak { address } => {
                self.locked.insert(address);
            }
            Reply::Value { address, header, .. }
                if (header.node, header.number) == (SystemNode::SELF, ParamNumber::ERROR_REGISTER) =>
            {
                self.locked.remove(&address);
            }
            Reply::Value { .. } | Reply::Ack { .. } => {}
        }
    }

    /// A byte of a drive was complete at `end`; `rest` must follow the last of them.
    pub(super) fn heard(&mut self, end: Tick, rest: Span) {
        self.reply = Some((end, rest));
    }
}

/// Whether the master speaks ASCII: from `:` on only characters that occur in such telegrams. An RTU telegram to
/// station 58 also starts with `:`, but holds other bytes.
fn looks_ascii(bytes: &[u8]) -> bool {
    let fits = |byte: &u8| byte.is_ascii_hexdigit() || matches!(byte, b':' | b'\r' | b'\n');
    bytes.first() == Some(&ascii::START) && bytes.iter().all(fits)
}

/// Whether the master speaks VABus: EOT first, and nothing behind it that no such telegram holds. An RTU telegram to
/// station 4 begins with the same byte, but no drive of this maker knows function codes that are addresses of VABus.
fn looks_vabus(line: LineSetting, bytes: &[u8]) -> bool {
    let rest = match bytes {
        [EOT, rest @ ..] => rest,
        _ => return false,
    };
    let address = rest.iter().find(|&&byte| byte != EOT);
    line.data_bits == 7 || address.is_none_or(|&byte| Address::from_character(byte).is_ok())
}

/// Why a telegram cannot be one of RTU, beside its bytes.
pub(super) fn wrong_format(telegram: &Telegram) -> Option<String> {
    match telegram.spoken() {
        Spoken::RTU if telegram.line.data_bits != 8 => {
            Some(format!("an RTU telegram needs 8 data bits, not {}", telegram.line))
        }
        Spoken::RTU if telegram.bytes.len() > rtu::MAX_FRAME => Some("an RTU telegram of over 256 bytes".to_owned()),
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
        assert!(judge.before(later, LINE, &READ).is_none());
        judge.sends(later, LINE, &READ[3..]);
        let end = later + LINE.chars(5);
        let early = end + (LINE.t35() - Span::from_micros(1));
        assert!(judge.before(early, LINE, &READ).is_some_and(|telegram| telegram.torn));
        judge.sends(early, LINE, &READ);
        assert_eq!(sins(&judge), [Sin::GapInside, Sin::GapBefore]);
    }

    #[test]
    fn chunks_of_one_telegram_are_no_sin() {
        let mut judge = Judge::default();
        let mut at = Tick::ZERO;
        for byte in READ {
            assert!(judge.before(at, LINE, &[byte]).is_none());
            judge.sends(at, LINE, &[byte]);
            at = at + LINE.chars(1) + LINE.t15();
        }
        let telegram = judge.settle(at + LINE.t35()).unwrap();
        assert!(telegram.complete() && !telegram.torn);
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
