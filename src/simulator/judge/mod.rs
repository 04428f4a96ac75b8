//! The judge: what the master did that no master may do, by the manual and not by what our own master does.
//!
//! It sees only when the master spoke and what, when drives answered, and it never keeps anybody from answering.

mod gaps;
mod sin;
mod telegram;
mod vabus;

pub use gaps::Gaps;
pub use sin::{Remark, Sin};
pub(crate) use telegram::{MasterTelegram, Spelt, wrong_format};

use crate::protocol::line::LineSetting;
use crate::protocol::vabus::{Address, EOT, Request};
use crate::simulator::line::speech::Spoken;
use crate::tick::{Span, Tick};
use gaps::GapLog;
use vabus::Rules;

/// After this time without a reply the master may ask again (CM-485 manual 6.8).
pub(crate) const REPLY_TIMEOUT: Span = Span::from_millis(500);
/// Remarks kept; a bench that runs for weeks must not fill the memory.
const MOST_REMARKS: usize = 1_000;

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
pub(crate) struct Judge {
    remarks: Vec<Remark>,
    count: u64,
    open: Option<MasterTelegram>,
    /// End of the last whole telegram, and the silence that must follow it.
    last: Option<(Tick, Span)>,
    asked: Option<Asked>,
    /// A drive sends until then.
    answering: Option<Tick>,
    /// Last bit of the last reply, and the rest that must follow it.
    reply: Option<(Tick, Span)>,
    vabus: Rules,
    pub(crate) gaps: GapLog,
    /// What the 500 ms rules allow for, where telegrams may be read late.
    pub(crate) slack: Span,
}

impl Judge {
    pub(crate) fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// Remarks made, also those that were too many to be kept.
    pub(crate) fn count(&self) -> u64 {
        self.count
    }

    pub(crate) fn remark(&mut self, at: Tick, kind: Sin, text: String) {
        self.count = self.count.saturating_add(1);
        if self.remarks.len() < MOST_REMARKS {
            self.remarks.push(Remark { at, kind, text });
        }
    }

    /// The telegram that is over because the master starts to send `bytes` at `at`; with another setting, or behind an EOT
    /// that they do not continue, they are another telegram.
    pub(crate) fn before(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) -> Option<MasterTelegram> {
        let open = self.open.as_ref()?;
        let continues = bytes.first().is_some_and(|&byte| byte == EOT || Address::from_character(byte).is_ok());
        let parted = open.line != line || (open.is_end() && !continues);
        let over = open.complete() || parted || at.since(open.end) >= open.limits().1;
        over.then(|| self.close()).flatten()
    }

    /// The telegram that is over because nothing came until `now`.
    pub(crate) fn settle(&mut self, now: Tick) -> Option<MasterTelegram> {
        let open = self.open.as_ref()?;
        let complete = open.spoken() != Spoken::RTU && open.complete() && now >= open.end;
        (complete || (now >= open.end && now.since(open.end) >= open.limits().1)).then(|| self.close()).flatten()
    }

    fn close(&mut self) -> Option<MasterTelegram> {
        let telegram = self.open.take()?;
        let rest = if telegram.spoken() == Spoken::RTU { telegram.line.t35() } else { Span::ZERO };
        self.last = Some((telegram.end, rest));
        Some(telegram)
    }

    /// The master starts to send.
    pub(crate) fn sends(&mut self, at: Tick, line: LineSetting, bytes: &[u8]) {
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
            open.extend(end, bytes);
            self.open = Some(open);
            return;
        }
        self.weigh_start(at);
        self.asked = None;
        self.open = Some(MasterTelegram::begin(at, line, bytes));
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
    pub(crate) fn asked(&mut self, end: Tick, station: u8, taken: bool) {
        self.asked = Some(Asked { end, station, taken });
    }

    /// The drive at `station` sends from now on, until `until`.
    pub(crate) fn answers(&mut self, station: u8, until: Tick) {
        self.asked = self.asked.filter(|asked| asked.station != station);
        self.answering = self.answering.max(Some(until));
    }

    /// A request of VABus is complete: whether the master may send it, and how often.
    pub(crate) fn weigh_request(&mut self, at: Tick, request: &Request) {
        for (kind, text) in self.vabus.weigh(request) {
            self.remark(at, kind, text);
        }
    }

    /// The master ends an exchange of VABus.
    pub(crate) fn ends_exchange(&mut self) {
        self.vabus.ends_exchange();
    }

    /// A drive puts this reply of VABus on the wire, as the master will hear it.
    pub(crate) fn overhears(&mut self, frame: &[u8]) {
        self.vabus.overhears(frame);
    }

    /// A byte of a drive was complete at `end`; `rest` must follow the last of them.
    pub(crate) fn heard(&mut self, end: Tick, rest: Span) {
        self.reply = Some((end, rest));
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
