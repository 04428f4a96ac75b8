//! What was heard on the line lately, and how soon stations answer: by this a copy of an older reply, or the reply of somebody
//! else, is told from the answer, although both may have the right form.
//!
//! * A repeater, a radio link or a second drive at one address may send a reply once more, up to 500 ms later
//!   (docs/measured.md). So bytes that were heard within that time prove nothing of a station of which copies have come. Of any
//!   other they are asked for again, until it has said two words of two things each: the first copy of all may come in
//!   place of an answer. From then on the usual time of an answer is waited for, in case the true one comes,
//!   until that has come a few times to nothing.
//! * Where none has come, an answer that comes sooner than this station has ever answered is waited
//!   upon for as long as the true one may take. On a quiet line this costs nothing.

use super::alike::Alike;
use super::dialect::Question;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// A copy comes within this time (docs/measured.md: 500 ms), and a little for the telegram itself.
pub(super) const COPY_WITHIN: Span = Span::from_millis(600);
/// Clocks and adapters are not more exact than this, on the bench too.
const TOLERANCE_US: i64 = 100;
/// An answer that comes so much later than ever is not the usual one (USB adapters hold bytes back for up to 16 ms,
/// docs/measured.md).
const DAWDLE_US: i64 = 20_000;
/// An answer that came sooner than ever is waited upon for no longer than this, and so long beyond the slowest one.
const LONGEST_HOLD: Span = Span::from_millis(150);
const MARGIN: Span = Span::from_millis(5);
/// So long a copy is listened for that was never heard, because it met our questions: they go out 2 ms behind an answer.
const UNHEARD_COPY: Span = Span::from_millis(60);
/// A copy that comes later is not waited for: what must not wait waits no longer for a busy line either.
const LONGEST_COPY: Span = Span::from_millis(100);
/// So often the same words must have been the answer to two things until they are not asked for again; so often where something warned of
/// copies.
const ALIKE: u8 = 1;
const ALIKE_WARNED: u8 = 2;
/// So often in a row a station must have been late until it is waited for.
const OFTEN_LATE: u8 = 2;
/// How much longer at most, and how much beyond what it took.
const LATEST_WAIT: Span = Span::from_secs(1);
const LATE_MARGIN: Span = Span::from_millis(100);
/// Telegrams that are remembered: more than fit into the time.
const MOST: usize = 512;

#[derive(Debug)]
struct Telegram {
    at: Tick,
    bytes: Vec<u8>,
    answered: Option<Question>,
    /// A copy of it has come.
    copied: bool,
}

/// How soon a station answers one kind of question, in microseconds from the end of the question to the start of the reply;
/// below zero where the line is none of wires.
#[derive(Clone, Copy, Debug)]
struct Pace {
    fastest: i64,
    slowest: i64,
}

/// What is remembered of a line.
#[derive(Debug, Default)]
pub(super) struct Heard {
    telegrams: VecDeque<Telegram>,
    paces: BTreeMap<(u8, u8), Pace>,
    /// Stations of which a reply came twice, or one that nobody had asked for.
    surplus: BTreeSet<u8>,
    /// Garbage came, or what nobody had asked for: more than replies that are late or lost.
    rough: bool,
    alike: Alike,
    /// How long after an answer of a station its copy was over; before any was heard, how long it is listened for.
    delays: BTreeMap<u8, Span>,
    /// How often in a row a reply of a station came behind its time, and how much later at most.
    late: BTreeMap<u8, (u8, Span)>,
    /// The longest that a reply of a station ever came behind its time, or was waited for in vain.
    latest: BTreeMap<u8, Span>,
    /// The copy of the last answer is over then.
    copy_due: Option<(u8, Tick)>,
}

/// An answer, as far as time and bytes tell of it.
#[derive(Clone, Debug)]
pub(super) struct Sample<'a> {
    pub(super) station: u8,
    pub(super) function: u8,
    pub(super) question: &'a Question,
    pub(super) bytes: &'a [u8],
    pub(super) at: Tick,
    /// From the end of the question to the start of the reply, microseconds.
    pub(super) after: i64,
    /// It can be asked again for nothing but a doubt.
    pub(super) again: bool,
    /// It could be another answer to the question before it.
    pub(super) confused: bool,
    /// It must not wait, or others wait for it.
    pub(super) hastens: bool,
    /// A value names what it answers; only refusals and acknowledgements are alike.
    pub(super) named: bool,
}

/// Whether it is the answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Weight {
    /// It is.
    Answer,
    /// It is, unless another comes so much longer after the end of the question.
    Wait(Span),
    /// It answers the question, but the true reply may still come.
    Stale(Span),
    /// It may be a copy of the answer to another question, of a station of which copies come; the usual answer comes so soon.
    Copy(Span),
    /// Another one came, in other words: neither is believed.
    Rival,
    /// The same words came a moment ago as another answer, or this comes late or behind noise: said again, it is the answer.
    Again,
}

impl Heard {
    /// Remembers a telegram; `answered` is the question that it was taken for the answer to.
    pub(super) fn note(&mut self, at: Tick, bytes: &[u8], answered: Option<&Question>) {
        while self.telegrams.front().is_some_and(|old| at.since(old.at) > COPY_WITHIN || self.telegrams.len() >= MOST) {
            self.telegrams.pop_front();
        }
        self.telegrams.push_back(Telegram { at, bytes: bytes.to_vec(), answered: answered.cloned(), copied: false });
    }

    /// Telegrams with these bytes that may be copied now.
    fn like(&self, at: Tick, bytes: &[u8]) -> impl Iterator<Item = &Telegram> {
        self.telegrams.iter().filter(move |old| old.bytes == bytes && at.since(old.at) <= COPY_WITHIN)
    }

    /// Whether the same bytes were heard a moment ago.
    pub(super) fn is_copy(&self, at: Tick, bytes: &[u8]) -> bool {
        self.like(at, bytes).next().is_some()
    }

    /// Whether they were the answer to another question, or to none.
    pub(super) fn is_anothers(&self, at: Tick, bytes: &[u8], question: &Question) -> bool {
        self.like(at, bytes).any(|old| old.answered.as_ref() != Some(question))
    }

    /// Whether an answer to this question was heard a moment ago.
    pub(super) fn has_answer_to(&self, question: &Question) -> bool {
        self.telegrams.iter().any(|old| old.answered.as_ref() == Some(question))
    }

    /// From when on nothing that was heard by now is copied any more.
    pub(super) fn quiet_at(&self, now: Tick) -> Tick {
        self.telegrams.back().map_or(now, |last| last.at + COPY_WITHIN).max(now)
    }

    /// Whether more than was asked for has come from a station.
    pub(super) fn has_surplus(&self, station: u8) -> bool {
        self.surplus.contains(&station)
    }

    /// Whether something warned of copies, of this station or of any.
    pub(super) fn may_bring_copies(&self, station: u8) -> bool {
        self.rough || self.has_surplus(station)
    }

    /// More than was asked for comes from a station; another one may be next.
    pub(super) fn sees_surplus(&mut self, station: u8) {
        self.surplus.insert(station);
        self.rough = true;
    }

    /// A copy has come; the first answer that it may be one of had none yet.
    pub(super) fn sees_copy(&mut self, station: u8, at: Tick, bytes: &[u8]) {
        self.sees_surplus(station);
        self.copy_due.take_if(|due| due.0 == station);
        let mut answers = self.telegrams.iter_mut().filter(|old| old.answered.is_some() && old.bytes == bytes);
        if let Some(first) = answers.find(|old| !old.copied && at.since(old.at) <= COPY_WITHIN) {
            first.copied = true;
            self.delays.insert(station, at.since(first.at));
        }
    }

    /// Something follows the answers of a station that meets our next question.
    pub(super) fn meets_copies(&mut self, station: u8) {
        self.delays.entry(station).or_insert(UNHEARD_COPY);
    }

    /// A station has answered: its copy is let pass, unless that is far too late.
    pub(super) fn awaits_copy(&mut self, station: u8, at: Tick) {
        let delay = self.delays.get(&station).filter(|&&delay| delay <= LONGEST_COPY);
        self.copy_due = delay.map(|&delay| (station, at + delay + MARGIN));
    }

    /// The line is left to the copy of the last answer until then.
    pub(super) fn copy_due(&self) -> Option<Tick> {
        self.copy_due.map(|due| due.1)
    }

    /// Garbage came, or what nobody had asked for: the first copy may come in place of an answer.
    pub(super) fn sees_trouble(&mut self) {
        self.rough = true;
    }

    /// The last answer, in the words of another one, was said again.
    pub(super) fn vouches(&mut self, station: u8) {
        let last = self.telegrams.iter().rfind(|old| old.answered.is_some());
        if let Some(bytes) = last.map(|last| last.bytes.clone()) {
            self.alike.vouches(station, &bytes);
        }
    }

    /// Behind words of another answer nothing came in its usual time.
    pub(super) fn comes_alone(&mut self, station: u8) {
        self.alike.comes_alone(station);
    }

    /// Whether words of a moment ago may be a copy, although none of this station has come yet: the first of all may come in place of an
    /// answer that is late or lost. What must not wait, and where values have names, doubts that only where something went wrong before,
    /// or they come sooner than any answer, or (what must not wait) this station's answers may take long.
    fn may_copy(&self, sample: &Sample<'_>, warned: bool) -> bool {
        let wanted = match (self.rough || warned, sample.hastens || sample.named) {
            (true, _) => ALIKE_WARNED,
            (false, false) => ALIKE,
            (false, true) => return false,
        };
        !self.alike.vouched(sample.station, sample.bytes, wanted)
    }

    /// A reply of a station came so long behind the time that was left for it.
    pub(super) fn sees_late(&mut self, station: u8, by: Span) {
        let late = self.late.entry(station).or_default();
        *late = (late.0.saturating_add(1), late.1.longer(by.min(LATEST_WAIT)));
        self.misses(station, by);
    }

    /// No reply of a station came within the time that was left for it.
    pub(super) fn misses(&mut self, station: u8, within: Span) {
        let latest = self.latest.entry(station).or_default();
        *latest = latest.longer(within);
    }

    /// A station has answered in time.
    pub(super) fn sees_prompt(&mut self, station: u8) {
        self.late.remove(&station);
    }

    /// So much longer a station is waited for that answers late, again and again: asked anew meanwhile it owes a reply each time, and none of
    /// its answers can be believed.
    pub(super) fn patience(&self, station: u8) -> Span {
        let late = self.late.get(&station).filter(|late| late.0 >= OFTEN_LATE);
        late.map_or(Span::ZERO, |late| late.1 + Span::from_micros(late.1.as_micros() / 4) + LATE_MARGIN)
    }

    /// The longest that a station took, from the end of a question to the start of its reply, or was behind its time.
    pub(super) fn slowest(&self, station: u8) -> Span {
        let paces = self.paces.range((station, 0)..=(station, u8::MAX)).map(|(_, pace)| pace.slowest);
        let slowest = paces.filter_map(|micros| u64::try_from(micros).ok()).max().map_or(Span::ZERO, Span::from_micros);
        self.latest.get(&station).map_or(slowest, |late| slowest.longer(*late))
    }

    /// Weighs an answer. `doubtful`: garbage came before it.
    pub(super) fn weigh(&self, sample: &Sample<'_>, doubtful: bool) -> Weight {
        let pace = self.paces.get(&(sample.station, sample.function));
        let soon = pace.is_some_and(|pace| sample.after + TOLERANCE_US < pace.fastest);
        let hold = |micros| Span::from_micros(u64::try_from(micros).unwrap_or(0)).min(LONGEST_HOLD) + MARGIN;
        let slowest = hold(pace.map_or(0, |pace| pace.slowest));
        // Whose answers differ in time by so much may take so much longer still.
        let slower = hold(pace.map_or(0, |pace| 2 * pace.slowest - pace.fastest));
        let is_trusted = self.alike.is_trusted(sample.station);
        let irregular = pace.is_some_and(|pace| pace.slowest > pace.fastest + DAWDLE_US);
        let is_new = !self.is_copy(sample.at, sample.bytes);
        let other = self.is_anothers(sample.at, sample.bytes, sample.question);
        // It was the answer to this a moment ago as well: a copy would say nothing else.
        let own = self.like(sample.at, sample.bytes).any(|old| old.answered.as_ref() == Some(sample.question));
        let late = pace.is_some_and(|pace| sample.after > pace.slowest + DAWDLE_US);
        let surplus = self.has_surplus(sample.station);
        match (is_new, surplus || doubtful || late) {
            (false, true) if other && surplus => Weight::Copy(slowest),
            (false, true) if other => Weight::Again,
            (false, true) => Weight::Stale(slowest),
            (false, false) if other && sample.again && self.may_copy(sample, soon || irregular && sample.hastens) => {
                Weight::Again
            }
            (true, _) if late && sample.again && sample.confused => Weight::Again,
            (false, false) if other && !(own || is_trusted || sample.hastens || sample.named) => Weight::Wait(slower),
            _ if soon => Weight::Wait(slowest),
            _ => Weight::Answer,
        }
    }

    /// An answer was believed without doubt: so soon does the station answer.
    pub(super) fn learn(&mut self, station: u8, function: u8, after: i64) {
        let pace = self.paces.entry((station, function)).or_insert(Pace { fastest: after, slowest: after });
        pace.fastest = pace.fastest.min(after);
        pace.slowest = pace.slowest.max(after);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::modbus::pdu::Request;

    const BYTES: [u8; 3] = [1, 2, 3];

    fn at(ms: u64) -> Tick {
        Tick::ZERO + Span::from_millis(ms)
    }

    fn question(start: u16) -> Question {
        Request::ReadRegisters { start, count: 1 }.into()
    }

    fn sample<'a>(question: &'a Question, bytes: &'a [u8], ms: u64, after: i64) -> Sample<'a> {
        Sample {
            station: 1,
            function: 3,
            question,
            bytes,
            at: at(ms),
            after,
            again: true,
            confused: false,
            hastens: false,
            named: false,
        }
    }

    /// A station that has answered after 10 ms and after 30 ms.
    fn known() -> Heard {
        let mut heard = Heard::default();
        for after in [10_000, 30_000, 20_000] {
            heard.learn(1, 3, after);
        }
        heard
    }

    #[test]
    fn an_answer_that_comes_sooner_than_ever_waits_for_the_slowest_true_one() {
        let (heard, asked) = (known(), question(1));
        let weigh = |after| heard.weigh(&sample(&asked, &BYTES, 0, after), false);
        let wait = Weight::Wait(Span::from_millis(35));
        assert_eq!(
            [9_800, 9_899, 9_900, 10_000, 30_000].map(weigh),
            [wait, wait, Weight::Answer, Weight::Answer, Weight::Answer]
        );
        // Another station, or another kind of question, has its own pace.
        let other = Sample { station: 2, ..sample(&asked, &BYTES, 0, 1) };
        assert_eq!(heard.weigh(&other, false), Weight::Answer);
        let mut slow = Heard::default();
        slow.learn(1, 3, 2_000_000);
        let held = Weight::Wait(Span::from_millis(155));
        assert_eq!(slow.weigh(&sample(&asked, &BYTES, 0, 1_000), false), held, "no true one is waited for without end");
    }

    #[test]
    fn bytes_that_were_heard_a_moment_ago_prove_nothing_where_the_line_says_things_twice() {
        let (mut heard, asked, other) = (known(), question(1), question(2));
        heard.note(at(1_000), &BYTES, Some(&asked));
        let weigh =
            |heard: &Heard, asked, ms, after, doubtful| heard.weigh(&sample(asked, &BYTES, ms, after), doubtful);
        // The same value once more is the usual thing.
        assert_eq!(weigh(&heard, &asked, 1_100, 15_000, false), Weight::Answer);
        assert_eq!(weigh(&heard, &asked, 1_100, 50_000, false), Weight::Answer, "20 ms late is nothing yet");
        let stale = Weight::Stale(Span::from_millis(35));
        assert_eq!(weigh(&heard, &asked, 1_100, 50_001, false), stale, "so late it may be a copy");
        assert_eq!(weigh(&heard, &asked, 1_100, 15_000, true), stale, "behind garbage too");
        assert_eq!(weigh(&heard, &other, 1_100, 15_000, true), Weight::Again, "it was the answer to something else");
        assert_eq!(weigh(&heard, &other, 1_100, 50_001, false), Weight::Again);
        heard.sees_surplus(1);
        assert!(heard.has_surplus(1) && !heard.has_surplus(2));
        assert_eq!(
            weigh(&heard, &other, 1_100, 15_000, false),
            Weight::Copy(Span::from_millis(35)),
            "of which copies come here"
        );
        assert_eq!(weigh(&heard, &asked, 1_600, 15_000, false), stale);
        assert_eq!(weigh(&heard, &asked, 1_601, 15_000, false), Weight::Answer, "nothing is copied so late");
        assert_eq!(heard.weigh(&sample(&other, &[9], 1_100, 15_000), true), Weight::Answer, "new bytes are no copy");
    }

    #[test]
    fn words_of_another_answer_are_asked_for_again_until_the_station_is_known_to_say_them() {
        let (mut heard, asked, other) = (known(), question(1), question(2));
        heard.note(at(1_000), &BYTES, Some(&asked));
        let weigh = |heard: &Heard, asked, after| heard.weigh(&sample(asked, &BYTES, 1_100, after), false);
        assert_eq!([15_000, 5_000].map(|after| weigh(&heard, &other, after)), [Weight::Again; 2]);
        let hasty = |heard: &Heard, after| {
            heard.weigh(&Sample { hastens: true, ..sample(&other, &BYTES, 1_100, after) }, false)
        };
        assert_eq!([15_000, 5_000].map(|after| hasty(&heard, after)), [Weight::Answer, Weight::Again]);
        let named = |after| heard.weigh(&Sample { named: true, ..sample(&other, &BYTES, 1_100, after) }, false);
        assert_eq!([15_000, 5_000].map(named), [Weight::Answer, Weight::Again], "as a refusal");
        assert_eq!(weigh(&heard, &asked, 15_000), Weight::Answer, "the same of the same");
        assert!(matches!(weigh(&heard, &asked, 5_000), Weight::Wait(_)));
        let once = Sample { again: false, ..sample(&other, &BYTES, 1_100, 15_000) };
        assert!(matches!(heard.weigh(&once, false), Weight::Wait(_)));
        heard.vouches(2);
        assert_eq!(weigh(&heard, &other, 15_000), Weight::Again);
        heard.vouches(1);
        let wait = Weight::Wait(Span::from_millis(55));
        assert_eq!(weigh(&heard, &other, 15_000), wait, "the true one may come later than ever");
        assert_eq!(weigh(&heard, &other, 5_000), Weight::Again, "sooner than ever it takes two");
        heard.sees_trouble();
        assert_eq!([weigh(&heard, &other, 15_000), hasty(&heard, 15_000)], [Weight::Again; 2]);
        heard.vouches(1);
        assert_eq!([weigh(&heard, &other, 15_000), hasty(&heard, 15_000)], [wait, Weight::Answer]);
        (0..6).for_each(|_| heard.comes_alone(1));
        assert_eq!(weigh(&heard, &other, 15_000), Weight::Answer, "none ever came behind one");
    }

    #[test]
    fn a_station_that_was_late_once_is_asked_again_in_haste_too() {
        let (mut heard, asked, other) = (known(), question(1), question(2));
        heard.note(at(1_000), &BYTES, Some(&asked));
        let hasty =
            |heard: &Heard| heard.weigh(&Sample { hastens: true, ..sample(&other, &BYTES, 1_100, 15_000) }, false);
        assert_eq!(hasty(&heard), Weight::Answer);
        heard.learn(1, 3, 30_001);
        assert_eq!(hasty(&heard), Weight::Again);
    }

    #[test]
    fn a_late_answer_that_may_be_another_to_the_question_before_is_asked_for_again() {
        let (heard, asked) = (known(), question(1));
        let weigh = |after, again, confused| {
            heard.weigh(&Sample { again, confused, ..sample(&asked, &BYTES, 0, after) }, false)
        };
        assert_eq!(weigh(50_001, true, true), Weight::Again);
        let others = [weigh(50_000, true, true), weigh(50_001, false, true), weigh(50_001, true, false)];
        assert_eq!(others, [Weight::Answer; 3]);
    }

    #[test]
    fn copies_of_one_station_tell_nothing_of_another_but_that_it_is_to_be_asked_again() {
        let (mut heard, asked, other) = (known(), question(1), question(2));
        heard.note(at(1_000), &BYTES, Some(&asked));
        heard.sees_copy(2, at(1_010), &[9]);
        let weigh = |heard: &Heard| heard.weigh(&sample(&other, &BYTES, 1_100, 15_000), false);
        assert_eq!(weigh(&heard), Weight::Again, "a repeater copies everybody");
        (0..ALIKE_WARNED).for_each(|_| heard.vouches(1));
        assert_eq!(weigh(&heard), Weight::Wait(Span::from_millis(55)));
        heard.sees_copy(1, at(1_020), &BYTES);
        assert!(matches!(weigh(&heard), Weight::Copy(_)));
    }

    #[test]
    fn the_line_is_left_to_a_copy_as_long_as_they_take_and_no_longer_than_a_stop_may_wait() {
        let (mut heard, asked) = (Heard::default(), question(1));
        let due = |heard: &mut Heard, ms| {
            heard.note(at(ms), &BYTES, Some(&asked));
            heard.awaits_copy(1, at(ms));
            heard.copy_due()
        };
        assert_eq!(due(&mut heard, 0), None);
        heard.meets_copies(1);
        assert_eq!(due(&mut heard, 10), Some(at(75)), "none was ever heard");
        // Each is one of the first answer that had none yet.
        heard.sees_copy(1, at(30), &BYTES);
        assert_eq!(heard.copy_due(), None);
        assert_eq!(due(&mut heard, 40), Some(at(75)));
        heard.sees_copy(1, at(60), &BYTES);
        assert_eq!(due(&mut heard, 100), Some(at(155)));
        heard.sees_copy(2, at(110), &BYTES);
        assert_eq!(heard.copy_due(), Some(at(155)), "somebody else's");
        let mut late = Heard::default();
        late.note(at(0), &BYTES, Some(&asked));
        late.sees_copy(1, at(101), &BYTES);
        assert_eq!(due(&mut late, 200), None);
    }

    #[test]
    fn who_answers_late_again_and_again_is_waited_for_until_he_is_in_time() {
        let mut heard = Heard::default();
        let late = |heard: &mut Heard, ms| {
            heard.sees_late(1, Span::from_millis(ms));
            [heard.patience(1).as_millis(), heard.patience(2).as_millis()]
        };
        assert_eq!([late(&mut heard, 200), late(&mut heard, 120), late(&mut heard, 240)], [[0, 0], [350, 0], [400, 0]]);
        assert_eq!(late(&mut heard, 6_000), [1_350, 0], "nobody is waited for without end");
        heard.sees_prompt(1);
        assert_eq!(late(&mut heard, 200), [0, 0]);
    }

    #[test]
    fn copies_are_looked_for_as_long_as_they_may_come() {
        let mut heard = Heard::default();
        assert_eq!(heard.quiet_at(at(70)), at(70));
        heard.note(at(100), &BYTES, None);
        assert_eq!([heard.quiet_at(at(100)), heard.quiet_at(at(900))], [at(700), at(900)]);
        assert!(heard.is_copy(at(700), &BYTES) && !heard.is_copy(at(701), &BYTES));
        assert!(!heard.is_copy(at(200), &[1, 2]));
        heard.note(at(700), &[4], None);
        assert_eq!(heard.telegrams.len(), 2, "what may still be copied is kept");
        heard.note(at(701), &[5], None);
        assert_eq!(heard.telegrams.len(), 2, "and what may not is forgotten");
        for _ in 0..2 * MOST {
            heard.note(at(702), &[6], None);
        }
        assert_eq!(heard.telegrams.len(), MOST);
    }
}
