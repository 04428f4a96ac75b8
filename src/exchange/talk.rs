//! Who speaks on a line on which nobody of us has said anything yet: another master, somebody whom nobody understands, or noise.
//!
//! The line is listened to in windows, one for each setting that it may have. A telegram tells another master at once, in whatever
//! protocol. At a wrong setting telegrams are garbage, but still two bursts a poll, again and again, at some setting as long as
//! telegrams are; electrical noise is a few bytes now and then.

use super::dialect::Dialect;
use super::foreign;
use super::{Conversation, MOST_RECORDS, Record, Step, Verdict};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::Framing;
use crate::tick::{Span, Tick};

/// Who speaks unasked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Talker {
    /// Another master: telegrams came.
    Master,
    /// Somebody; nobody can tell whether it is another master.
    Somebody,
}

/// What was heard unasked so far.
#[derive(Clone, Debug, Default)]
pub struct Talk {
    /// How often somebody spoke.
    pub bursts: u32,
    /// Bytes that came.
    pub bytes: u32,
    /// How long it was listened to.
    pub listened: Span,
    /// Bursts that are long enough for a telegram.
    telegrams: u32,
    /// Bursts that are longer than noise is.
    long: u32,
    questions: u32,
    replies: u32,
}

/// Who polls once a second speaks within this, wherever in his poll it begins: a second, his telegrams, what a busy host adds.
pub const WINDOW: Span = Span::from_millis(1_250);
/// Once somebody spoke, the rest of his poll is waited for so long.
const POLL: Span = Span::from_millis(350);
/// A line that has no pause for so long is never silent.
const BABBLE: Span = Span::from_secs(1);
/// A pause is longer than this and two characters: so long an adapter holds bytes back (docs/measured.md: the latency timer of FTDI has
/// 16 ms), and a host has its say.
const ADAPTER: Span = Span::from_millis(20);
/// Between a question and its answer lies more than this, or three characters.
const GAP: Span = Span::from_millis(5);
/// The shortest telegram of the protocols here is longer than three bytes; an adapter may swallow one.
const TELEGRAM: usize = 4;
/// From so many bytes on it is more than a disturbance leaves: a question with its answer.
const LONG: usize = 12;
/// So many of these are no accident.
const MOST_LONG: u32 = 3;
/// A reply that is late may be one to somebody who has just left the line; a second one is not.
const REPLIES: u32 = 2;
/// Bursts in 10 s: noise that comes once a second stays below this, a poll and its answer once a second do not.
const OFTEN: u64 = 15;
/// From so many bursts in 10 s on nothing needs to be waited for.
const CERTAINLY: u64 = 30;
/// For that it must have been listened to so long.
const SAMPLE: Span = Span::from_millis(2_000);
/// Bytes of one window in which telegrams are looked for.
const MOST_BYTES: usize = 2_048;

impl Talk {
    /// Whether nobody spoke.
    pub fn is_silent(&self) -> bool {
        self.bursts == 0
    }

    /// Who speaks, as far as that is certain already.
    pub fn certain(&self) -> Option<Talker> {
        self.master().or_else(|| (self.listened >= SAMPLE && self.speaks(CERTAINLY)).then_some(Talker::Somebody))
    }

    /// Who speaks, when it was listened to at every setting; `None`: nobody, or noise.
    pub fn verdict(&self) -> Option<Talker> {
        let speaks = self.long >= MOST_LONG || self.speaks(OFTEN);
        self.master().or_else(|| speaks.then_some(Talker::Somebody))
    }

    fn master(&self) -> Option<Talker> {
        (self.questions > 0 || self.replies >= REPLIES).then_some(Talker::Master)
    }

    /// Whether somebody speaks so often in 10 s, and is no drip of single bytes.
    fn speaks(&self, often: u64) -> bool {
        let like_telegrams = self.telegrams * 4 >= self.bursts;
        like_telegrams && u64::from(self.bursts) * 10_000_000 > often * self.listened.as_micros()
    }

    fn note(&mut self, burst: usize) {
        self.bursts += 1;
        self.bytes += burst as u32;
        self.telegrams += u32::from(burst >= TELEGRAM);
        self.long += u32::from(burst >= LONG);
    }
}

/// Listens for a while at one setting. It ends when its time is over, when somebody was heard long enough, or when the line is never
/// silent.
#[derive(Debug)]
pub struct Window {
    line: LineSetting,
    began: Tick,
    until: Tick,
    /// Bytes of the burst that is coming in, and when its last one came.
    burst: Vec<u8>,
    last: Tick,
    /// Since when there was no silence, and since when somebody was heard.
    busy: Option<Tick>,
    heard: Option<Tick>,
    is_occupied: bool,
    talk: Talk,
    came: Vec<u8>,
    records: Vec<Record>,
}

impl Window {
    /// A window at a setting, which ends then at the latest.
    pub fn new(line: LineSetting, now: Tick, until: Tick) -> Self {
        Window {
            line,
            began: now,
            until,
            burst: Vec::new(),
            last: now,
            busy: None,
            heard: None,
            is_occupied: false,
            talk: Talk::default(),
            came: Vec::new(),
            records: Vec::new(),
        }
    }

    /// Whether the line was never silent.
    pub fn is_occupied(&self) -> bool {
        self.is_occupied
    }

    /// What came since the last call.
    pub fn take_records(&mut self) -> Vec<Record> {
        std::mem::take(&mut self.records)
    }

    /// Adds what was heard to what was heard before.
    pub fn adds_to(mut self, talk: &mut Talk, now: Tick) {
        self.close();
        let (questions, replies) = telegrams(&self.came);
        talk.bursts += self.talk.bursts;
        talk.bytes += self.talk.bytes;
        talk.telegrams += self.talk.telegrams;
        talk.long += self.talk.long;
        talk.listened = talk.listened + now.since(self.began);
        talk.questions += questions;
        talk.replies += replies;
    }

    /// Whoever says nothing for longer is silent.
    fn pause(&self) -> Span {
        ADAPTER + self.line.chars(2)
    }

    /// A burst is over.
    fn close(&mut self) {
        let burst = std::mem::take(&mut self.burst);
        if burst.is_empty() {
            return;
        }
        self.talk.note(burst.len());
        if self.records.len() < MOST_RECORDS {
            self.records.push(Record { at: self.last, verdict: Verdict::Garbage, bytes: burst });
        }
    }
}

impl Conversation for Window {
    type End = ();

    fn step(&mut self, now: Tick) -> Step<()> {
        let silent_at = self.last + self.pause();
        let busy = self.busy.filter(|_| now < silent_at);
        self.is_occupied |= busy.is_some_and(|since| now.since(since) >= BABBLE);
        let ends = self.heard.map_or(self.until, |at| self.until.min(at + POLL));
        if self.is_occupied || now >= self.until || busy.is_none() && now >= ends {
            self.close();
            return Step::Done(());
        }
        Step::Wait(if busy.is_some() { self.until.min(silent_at) } else { ends })
    }

    fn feed(&mut self, at: Tick, bytes: &[u8]) {
        if at.since(self.last) > GAP.longer(self.line.chars(3)) {
            self.close();
        }
        if at.since(self.last) > self.pause() || self.busy.is_none() {
            self.busy = Some(at);
        }
        self.heard.get_or_insert(at);
        self.last = at;
        self.burst.extend_from_slice(bytes);
        let room = MOST_BYTES.saturating_sub(self.came.len());
        self.came.extend(bytes.iter().take(room));
    }
}

/// Questions and replies among what came, in any protocol. What has 7 bits is understood at 8 as well: the parity bit comes as the
/// highest one.
fn telegrams(came: &[u8]) -> (u32, u32) {
    let low: Vec<u8> = came.iter().map(|byte| byte & 0x7F).collect();
    let of = |protocol: Protocol, bytes: &[u8]| foreign::questions(Dialect::new(protocol), bytes, |_| false);
    let questions = of(Framing::Rtu.into(), came) + of(Framing::Ascii.into(), &low) + of(Protocol::Vabus, &low);
    let replies = |framing: Framing, mut bytes: &[u8]| {
        let mut count = 0;
        while let Some(reply) = Dialect::new(framing.into()).reply_within(bytes) {
            bytes = bytes.get(reply.end..).unwrap_or_default();
            count += 1;
        }
        count
    };
    (questions, replies(Framing::Rtu, came) + replies(Framing::Ascii, &low))
}

#[cfg(test)]
mod tests;
