//! Replies that stations still owe: after a time-out or garbage the missing reply may still come. A debt is paid by the
//! reply or settled by the answer to a fence, not by time alone.

use super::dialect::{Question, Said};
use super::heard::COPY_WITHIN;
use super::limits::LATEST_OF_ALL;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// So long other programs are kept from the line for the sake of a reply that is missing, without a sign of it.
const HOLD: Span = Span::from_secs(2);
/// So long for one that was answered, and doubted: what a drive does in this time nobody sees.
const HOLD_DOUBTED: Span = Span::from_millis(100);

/// The longest that a drive takes to answer but under high load (CM-485 manual 6.8).
pub(super) const LATEST_REPLY: Span = Span::from_millis(500);

/// Replies that are remembered of every station although a fence was answered before they came.
const MOST_OVERTAKEN: usize = 16;

/// A reply that was missing when a later one came: it is lost, or a link that mixes up telegrams brings it afterwards.
#[derive(Clone, Debug)]
pub(super) struct Overtaken {
    pub(super) missing: Question,
    /// When it was missed.
    pub(super) since: Tick,
    /// It came as garbage: only a copy of it, which was spared, may still come.
    spoilt: bool,
}

impl Overtaken {
    /// Until when it may come.
    pub(super) fn until(&self) -> Tick {
        self.since + if self.spoilt { COPY_WITHIN } else { LATEST_OF_ALL }
    }
}

/// A question whose reply may still come, and when it was asked last.
#[derive(Clone, Debug)]
struct Missing {
    question: Question,
    since: Tick,
}

/// What one station owes.
#[derive(Clone, Debug, Default)]
struct Debt {
    /// In the order in which they were asked; of a fence counts the first time.
    missing: Vec<Missing>,
    /// The same, every asking for itself.
    lately: Vec<Overtaken>,
    since: Tick,
    /// Other programs are kept from the line until then.
    held: Tick,
    /// Nothing else can overtake the missing replies after this; a drive under load may still be late.
    due: Tick,
    /// How many replies may still come.
    owed: u32,
}

/// What every station owes, and who has answered anything yet.
#[derive(Debug, Default)]
pub(super) struct Debts {
    by_station: BTreeMap<u8, Debt>,
    heard: BTreeSet<u8>,
    overtaken: BTreeMap<u8, Vec<Overtaken>>,
    /// A reply came after a later one: the line mixes them up.
    mixes: bool,
}

impl Debts {
    /// A station owes the reply to a question, which is due at a time.
    pub(super) fn owes(&mut self, station: u8, missing: Question, due: Tick, now: Tick) {
        self.note(station, &missing, due, now, HOLD).remember(&missing, now, false);
    }

    /// What was taken for the reply may have been an older one, and none came behind it: most likely nothing more will, but what comes all
    /// the same is no answer to something else.
    pub(super) fn doubts(&mut self, station: u8, missing: Question, due: Tick, now: Tick) {
        self.note(station, &missing, due, now, HOLD_DOUBTED).remember(&missing, now, false);
    }

    /// A station owes somebody else the reply to a question. He goes on asking, so nobody keeps the line for it.
    pub(super) fn owes_another(&mut self, station: u8, missing: Question, due: Tick, now: Tick) {
        self.note(station, &missing, due, now, Span::ZERO).remember(&missing, now, false);
    }

    /// A question was answered by garbage, which most likely was the reply.
    pub(super) fn may_owe(&mut self, station: u8, missing: &Question, now: Tick) {
        self.note(station, missing, now, now, HOLD).remember(missing, now, true);
    }

    fn note(&mut self, station: u8, missing: &Question, due: Tick, now: Tick, hold: Span) -> &mut Debt {
        let debt = self.by_station.entry(station).or_default();
        debt.since = now;
        debt.held = debt.held.max(now + hold);
        debt.due = debt.due.max(due);
        debt.owed = debt.owed.saturating_add(1);
        debt.missing.retain(|old| old.question != *missing && now < old.since + LATEST_OF_ALL);
        debt.missing.push(Missing { question: missing.clone(), since: now });
        debt
    }

    /// A station owes the reply to a fence too. That is none to be waited for.
    pub(super) fn owes_fence(&mut self, station: u8, fence: Question, now: Tick) {
        // Of a suspect, which owed nothing else, it counts as well: its answer may come behind that of the next one.
        let Some(debt) = self.by_station.get_mut(&station) else { return self.owes(station, fence, now, now) };
        debt.owed = debt.owed.saturating_add(1);
        debt.remember(&fence, now, false);
        debt.missing.retain(|old| now < old.since + LATEST_OF_ALL);
        match debt.missing.iter_mut().find(|old| old.question == fence) {
            Some(old) => old.since = now,
            None => debt.missing.push(Missing { question: fence, since: now }),
        }
    }

    /// A station sent something valid.
    pub(super) fn hears(&mut self, station: u8) {
        self.heard.insert(station);
    }

    /// A reply that nobody waited for and that came at `at`: if it answers what its station was asked before, that is one less
    /// that it owes. Tells whether it does.
    pub(super) fn pays(&mut self, station: u8, said: &Said, at: Tick) -> bool {
        let Some(debt) = self.by_station.get_mut(&station) else { return false };
        let pays = debt.missing.iter().any(|missing| missing.since <= at && missing.question.is_answered_by(said));
        if pays {
            debt.owed = debt.owed.saturating_sub(1);
            take_first(&mut debt.lately, said, at);
        }
        if debt.owed == 0 {
            self.by_station.remove(&station);
        }
        pays
    }

    /// When the reply to this was missed, asked last.
    pub(super) fn missed(&self, station: u8, question: &Question) -> Option<Tick> {
        let missing = &self.by_station.get(&station)?.missing;
        missing.iter().find(|missing| missing.question == *question).map(|missing| missing.since)
    }

    /// Whether this is a reply that is missing, and none that came spoilt.
    pub(super) fn is_late(&self, station: u8, said: Option<&Said>) -> bool {
        let late = |old: &Overtaken| !old.spoilt && said.is_some_and(|said| old.missing.is_answered_by(said));
        self.by_station.get(&station).is_some_and(|debt| debt.lately.iter().any(late))
    }

    /// Everything that a station owed before `asked` has come, or cannot come any more, as stations answer in order. What has
    /// not come is remembered for as long as a line that mixes up telegrams may take.
    pub(super) fn settle(&mut self, station: u8, asked: Tick, now: Tick) {
        let Some(debt) = self.by_station.remove(&station) else { return };
        let (later, earlier): (Vec<_>, Vec<_>) = debt.lately.into_iter().partition(|old| old.since > asked);
        let overtaken = self.overtaken.entry(station).or_default();
        overtaken.extend(earlier);
        overtaken.retain(|old| now < old.until());
        let surplus = overtaken.len().saturating_sub(MOST_OVERTAKEN);
        overtaken.drain(..surplus);
        for Overtaken { missing, since, .. } in later {
            self.owes(station, missing, debt.due, since);
        }
    }

    /// Replies of a station that may still come although later ones have.
    pub(super) fn overtaken(&self, station: u8, now: Tick) -> impl Iterator<Item = &Overtaken> {
        self.overtaken.get(&station).into_iter().flatten().filter(move |old| now < old.until())
    }

    /// Whether a reply to this may still come from a station: it is owed, or was overtaken.
    pub(super) fn may_come(&self, station: u8, question: &Question, now: Tick) -> bool {
        let is_owed = |debt: &Debt| debt.missing.iter().any(|missing| missing.question == *question);
        self.by_station.get(&station).is_some_and(is_owed)
            || self.overtaken(station, now).any(|old| old.missing == *question)
    }

    /// A reply came that nobody waited for: it is one that was overtaken, if it answers what was asked then.
    pub(super) fn arrives(&mut self, station: u8, said: &Said, at: Tick) -> bool {
        let Some(overtaken) = self.overtaken.get_mut(&station) else { return false };
        overtaken.retain(|old| at < old.until());
        let arrived = take_first(overtaken, said, at);
        self.mixes |= arrived.as_ref().is_some_and(|old| !old.spoilt);
        arrived.is_some()
    }

    /// A reply that came and was only doubted, at `since`, is not to come any more, where replies come in order. Another one
    /// to the same question, which was lost before, still is.
    pub(super) fn forgives(&mut self, station: u8, question: &Question, since: Tick) {
        if let Some(overtaken) = self.overtaken.get_mut(&station).filter(|_| !self.mixes) {
            overtaken.retain(|old| old.since != since || old.missing != *question);
        }
    }

    /// Whether a reply came after a later one.
    pub(super) fn mixes(&self) -> bool {
        self.mixes
    }

    /// Questions whose replies may still come from a station.
    pub(super) fn missing(&self, station: u8) -> Vec<Question> {
        let missing = self.by_station.get(&station).into_iter().flat_map(|debt| &debt.missing);
        missing.map(|missing| missing.question.clone()).collect()
    }

    /// Whether the reply to this question, asked before `since`, may still come.
    pub(super) fn is_missing(&self, station: u8, question: &Question, since: Tick, now: Tick) -> bool {
        let older = |old: &Overtaken| old.missing == *question && old.since <= since && now < old.since + LATEST_OF_ALL;
        self.by_station.get(&station).is_some_and(|debt| debt.lately.iter().any(older))
    }

    /// When the replies are due that a station owes, and until when the latest of them may come.
    pub(super) fn due(&self, station: u8) -> Option<(Tick, Tick)> {
        self.by_station.get(&station).map(|debt| (debt.due, debt.since + LATEST_OF_ALL))
    }

    /// The stations that have answered before and owe a reply, and until when it may still come.
    pub(super) fn owing(&self) -> impl Iterator<Item = (u8, Tick)> {
        let owing = self.by_station.iter().filter(|(station, _)| self.heard.contains(station));
        owing.map(|(&station, debt)| (station, debt.held))
    }
}

impl Debt {
    fn remember(&mut self, missing: &Question, since: Tick, spoilt: bool) {
        if self.lately.len() >= MOST_OVERTAKEN {
            self.lately.remove(0);
        }
        self.lately.push(Overtaken { missing: missing.clone(), since, spoilt });
    }
}

/// Takes away the first that is answered by this, which came at `at`: no reply is to what was asked later.
fn take_first(overtaken: &mut Vec<Overtaken>, said: &Said, at: Tick) -> Option<Overtaken> {
    let place = overtaken.iter().position(|old| old.since <= at && old.missing.is_answered_by(said))?;
    Some(overtaken.remove(place))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::modbus::pdu::Request;

    fn question(start: u16) -> Question {
        Question::Modbus(Request::ReadRegisters { start, count: 1 })
    }

    fn at(ms: u64) -> Tick {
        Tick::ZERO + Span::from_millis(ms)
    }

    #[test]
    fn what_is_missing_stays_so_until_it_cannot_come_any_more() {
        let mut debts = Debts::default();
        let [first, second] = [question(1), question(2)];
        debts.owes(1, first.clone(), at(500), at(0));
        debts.owes(1, second.clone(), at(900), at(400));
        assert_eq!(debts.missing(1), [first.clone(), second.clone()]);
        debts.owes(1, first.clone(), at(700), at(600));
        assert_eq!(
            debts.missing(1),
            [second.clone(), first.clone()],
            "what is asked again is missing once, from then on"
        );
        assert_eq!(
            debts.due(1),
            Some((at(900), at(7_600))),
            "the latest that is due, and 7 s behind the last question"
        );
        debts.owes(1, question(3), at(7_500), at(7_399));
        assert_eq!(debts.missing(1).len(), 3);
        debts.owes(1, question(3), at(7_500), at(7_400));
        assert_eq!(debts.missing(1), [first, question(3)], "7 s after it was asked it cannot come");
        assert!(debts.missing(2).is_empty());
    }

    #[test]
    fn what_was_doubted_is_forgiven_and_what_was_lost_before_is_not() {
        let mut debts = Debts::default();
        let said = Said::Modbus(crate::protocol::modbus::pdu::Reply::Registers(vec![7]));
        debts.owes(1, question(1), at(500), at(400));
        debts.owes(1, question(1), at(500), at(420));
        debts.settle(1, at(430), at(440));
        debts.forgives(1, &question(1), at(420));
        assert!(debts.arrives(1, &said, at(2_500)), "asked at 400 and lost");
        assert!(!debts.arrives(1, &said, at(2_600)), "asked at 420 and doubted");
        assert!(debts.mixes());
    }

    #[test]
    fn a_reply_that_is_owed_may_come_and_one_that_was_overtaken_for_a_while() {
        let mut debts = Debts::default();
        let may_come = |debts: &Debts, start, ms| debts.may_come(1, &question(start), at(ms));
        debts.owes(1, question(1), at(500), at(0));
        assert!(may_come(&debts, 1, 100) && !may_come(&debts, 2, 100) && !debts.may_come(2, &question(1), at(100)));
        debts.settle(1, at(110), at(120));
        assert!(debts.missing(1).is_empty());
        assert_eq!([6_999, 7_000].map(|ms| may_come(&debts, 1, ms)), [true, false], "7 s after it was missed");
    }

    #[test]
    fn only_a_station_that_was_heard_is_waited_for_at_the_end() {
        let mut debts = Debts::default();
        debts.owes(1, question(1), at(500), at(0));
        debts.owes(2, question(1), at(600), at(100));
        assert_eq!(debts.owing().count(), 0);
        debts.hears(2);
        assert_eq!(debts.owing().collect::<Vec<_>>(), [(2, at(2_100))]);
    }

    fn words(words: &[u16]) -> Said {
        Said::Modbus(crate::protocol::modbus::pdu::Reply::Registers(words.to_vec()))
    }

    #[test]
    fn a_reply_pays_what_it_answers_and_what_was_asked_before_it() {
        let mut debts = Debts::default();
        debts.owes(1, question(1), at(600), at(100));
        assert!(!debts.pays(1, &words(&[1, 2]), at(200)), "two words answer no question for one");
        assert!(!debts.pays(1, &words(&[1]), at(99)), "nobody answers before he is asked");
        assert!(!debts.pays(2, &words(&[1]), at(200)), "somebody else");
        assert!(debts.due(1).is_some());
        assert!(debts.pays(1, &words(&[1]), at(100)));
        assert!(debts.due(1).is_none() && !debts.pays(1, &words(&[1]), at(200)), "that was all");
        // Asked twice it is owed twice.
        debts.owes(1, question(1), at(800), at(300));
        debts.owes(1, question(1), at(900), at(400));
        assert!(debts.pays(1, &words(&[1]), at(500)) && debts.due(1).is_some());
        assert!(debts.pays(1, &words(&[1]), at(500)) && debts.due(1).is_none());
    }

    #[test]
    fn what_came_spoilt_is_late_no_more_and_only_its_copy_is_waited_for() {
        let late = |debts: &Debts, said: &[u16]| debts.is_late(1, Some(&words(said)));
        let mut lost = Debts::default();
        lost.owes(1, question(1), at(500), at(0));
        assert!(
            late(&lost, &[7])
                && !late(&lost, &[7, 8])
                && !lost.is_late(1, None)
                && !lost.is_late(2, Some(&words(&[7])))
        );
        let mut spoilt = Debts::default();
        spoilt.may_owe(1, &question(1), at(0));
        assert!(!late(&spoilt, &[7]) && spoilt.due(1) == Some((at(0), at(7_000))));
        for (debts, until) in [(&mut lost, LATEST_OF_ALL), (&mut spoilt, COPY_WITHIN)] {
            debts.settle(1, at(10), at(20));
            let last = Tick::ZERO + until;
            assert_eq!(debts.overtaken(1, at(30)).map(Overtaken::until).collect::<Vec<_>>(), [last]);
            assert_eq!(debts.overtaken(1, last).count(), 0, "then it cannot come any more");
        }
        // That a copy comes tells nothing of a line that mixes up telegrams.
        assert!(spoilt.arrives(1, &words(&[7]), at(40)) && !spoilt.mixes());
        assert!(lost.arrives(1, &words(&[7]), at(40)) && lost.mixes());
    }

    #[test]
    fn of_many_replies_that_were_overtaken_the_latest_are_remembered() {
        let mut debts = Debts::default();
        for start in 0..40 {
            debts.owes(1, question(start), at(500), at(u64::from(start)));
            debts.settle(1, at(u64::from(start)), at(u64::from(start) + 1));
        }
        let known: Vec<u64> = debts.overtaken(1, at(50)).map(|old| old.since.as_micros() / 1_000).collect();
        assert_eq!(known, (24..40).collect::<Vec<_>>());
        let mut at_once = Debts::default();
        for start in 0..40 {
            at_once.owes(1, question(start), at(500), at(u64::from(start)));
        }
        at_once.settle(1, at(40), at(41));
        assert_eq!(at_once.overtaken(1, at(50)).map(|old| old.since.as_micros() / 1_000).collect::<Vec<_>>(), known);
        // And no longer than they may come.
        at_once.owes(1, question(50), at(8_000), at(7_030));
        at_once.settle(1, at(7_030), at(7_031));
        assert_eq!(at_once.overtaken(1, at(7_031)).count(), 9, "of 32 to 39, and this one");
    }

    #[test]
    fn what_was_asked_behind_a_fence_is_owed_on() {
        let mut debts = Debts::default();
        debts.owes(1, question(1), at(600), at(100));
        debts.owes(1, question(2), at(700), at(200));
        debts.owes(1, question(3), at(800), at(300));
        debts.settle(1, at(200), at(310));
        assert_eq!((debts.missing(1), debts.due(1)), (vec![question(3)], Some((at(800), at(7_300)))));
        assert_eq!(
            debts.overtaken(1, at(310)).map(|old| old.missing.clone()).collect::<Vec<_>>(),
            [question(1), question(2)]
        );
    }

    #[test]
    fn a_reply_from_before_a_time_may_come_for_seven_seconds() {
        let mut debts = Debts::default();
        debts.owes(1, question(1), at(600), at(100));
        let is_missing = |station, start, since, now| debts.is_missing(station, &question(start), at(since), at(now));
        assert_eq!([99, 100, 101].map(|since| is_missing(1, 1, since, 200)), [false, true, true]);
        assert_eq!([7_099, 7_100].map(|now| is_missing(1, 1, 150, now)), [true, false]);
        assert!(!is_missing(1, 2, 150, 200) && !is_missing(2, 1, 150, 200));
    }

    #[test]
    fn a_fence_that_is_asked_again_is_owed_once_more_and_missing_since_then() {
        let mut debts = Debts::default();
        debts.owes_fence(1, question(9), at(0));
        assert_eq!((debts.missing(1), debts.due(1)), (vec![question(9)], Some((at(0), at(7_000)))));
        debts.owes(1, question(1), at(600), at(100));
        debts.owes_fence(1, question(9), at(6_000));
        assert_eq!(debts.missing(1), [question(9), question(1)], "it keeps its place");
        debts.owes_fence(1, question(8), at(7_099));
        assert_eq!(debts.missing(1), [question(9), question(1), question(8)]);
        debts.owes_fence(1, question(8), at(7_100));
        assert_eq!(debts.missing(1), [question(9), question(8)], "7 s behind the question nothing answers it");
        assert_eq!((0..5).filter(|_| debts.pays(1, &words(&[7]), at(8_000))).count(), 5);
        assert!(debts.due(1).is_none(), "five were owed");
    }

    #[test]
    fn only_what_was_doubted_then_is_forgiven() {
        let left = |start, since| {
            let mut debts = Debts::default();
            debts.owes(1, question(1), at(500), at(0));
            debts.owes(1, question(2), at(500), at(10));
            debts.settle(1, at(20), at(30));
            debts.forgives(1, &question(start), at(since));
            debts.overtaken(1, at(40)).count()
        };
        assert_eq!([left(1, 0), left(1, 10), left(2, 0), left(2, 10), left(3, 0)], [1, 2, 2, 1, 2]);
    }

    #[test]
    fn a_reply_pays_what_was_asked_alike_and_nothing_else() {
        let double = Question::Modbus(Request::ReadRegisters { start: 1, count: 2 });
        let mut debts = Debts::default();
        debts.owes(1, question(1), at(500), at(0));
        debts.owes(1, double.clone(), at(500), at(10));
        assert!(debts.pays(1, &words(&[1, 2]), at(20)));
        assert!(debts.is_late(1, Some(&words(&[7]))) && !debts.is_late(1, Some(&words(&[1, 2]))));
        // Nobody answers before he is asked; at that moment he may.
        let mut debts = Debts::default();
        debts.owes(1, question(1), at(500), at(10));
        debts.owes(1, double.clone(), at(500), at(10));
        assert!(debts.pays(1, &words(&[1]), at(10)) && !debts.is_late(1, Some(&words(&[7]))));
        // 16 of those that are missing are remembered, the latest.
        let mut debts = Debts::default();
        debts.owes(1, double, at(500), at(0));
        (0..15).for_each(|start| debts.owes(1, question(start), at(500), at(10)));
        assert!(debts.is_late(1, Some(&words(&[1, 2]))));
        debts.owes(1, question(15), at(500), at(10));
        assert!(!debts.is_late(1, Some(&words(&[1, 2]))) && debts.is_late(1, Some(&words(&[7]))));
    }

    #[test]
    fn what_was_overtaken_arrives_within_seven_seconds() {
        for (ms, arrives) in [(6_999, true), (7_000, false)] {
            let mut debts = Debts::default();
            debts.owes(1, question(1), at(500), at(0));
            debts.settle(1, at(10), at(20));
            assert_eq!(debts.arrives(1, &words(&[7]), at(ms)), arrives, "{ms}");
        }
    }
}
