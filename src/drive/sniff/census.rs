//! What is heard on a line, station by station: who is asked, who answers, how fast, how often again, and how full the line is.
//! On a CAN bus several are asked at once, each on a lane of its own, and the time of a frame is that of its bits.
//!
//! A serial adapter hands bytes over in pieces, so times are those of its driver. What came in one piece has no pause that anybody
//! could know, and is not counted as one.

use crate::outcome::{Decimal, Repeats, SniffCount, SniffedStation, TelegramDoc};
use crate::tick::{Span, Tick};
use std::collections::BTreeMap;

/// What was counted so far.
#[derive(Debug)]
pub(super) struct Census {
    terms: Terms,
    began: Tick,
    heard: u64,
    garbled: u64,
    bytes: u64,
    stations: BTreeMap<u8, Tally>,
    /// Questions by their lane.
    open: BTreeMap<Lane, Open>,
    /// When the last byte of the last telegram came.
    last: Option<Tick>,
}

/// Where at most one question is open: the whole of a line, or an SDO of a node.
pub(super) type Lane = u16;

/// What holds on a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Terms {
    /// A thousand characters on it; where length is counted in microseconds, those.
    pub(super) thousand: Span,
    /// The pause that must lie between two telegrams, where silences part them.
    pub(super) pause: Option<Span>,
    /// How long a reply may take.
    pub(super) patience: Span,
    /// The address of everybody; nobody answers.
    pub(super) everybody: u8,
}

impl Terms {
    fn chars(&self, count: u64) -> Span {
        Span::from_micros(self.thousand.as_micros() * count / 1_000)
    }
}

/// How a telegram came.
#[derive(Clone, Copy, Debug)]
pub(super) struct Came {
    /// When its first byte came.
    pub(super) first: Tick,
    /// How many of its bytes came then.
    pub(super) piece: u64,
    /// When its last byte came.
    pub(super) last: Tick,
    /// All of its bytes.
    pub(super) bytes: u64,
    /// Whether it is a request or a reply is not told by its bytes.
    pub(super) alike: bool,
    /// Where it is asked and answered.
    pub(super) lane: Lane,
}

/// A question that is not answered yet.
#[derive(Debug)]
struct Open {
    address: u8,
    hex: String,
    /// When its last byte came.
    at: Tick,
    /// How often it was asked again.
    again: u64,
    /// So many telegrams came since that can be its reply or itself once more.
    doubts: u64,
}

/// What was counted of a station.
#[derive(Debug, Default)]
struct Tally {
    requests: u64,
    replies: u64,
    unanswered: u64,
    either: u64,
    exceptions: u64,
    check_errors: u64,
    short_pauses: u64,
    /// How many questions were asked again so often.
    again: BTreeMap<u64, u64>,
    /// How many replies took so many tenths of a millisecond: as many rows as there are times, however long it is listened to.
    times: BTreeMap<u64, u64>,
    fastest: Option<Span>,
    slowest: Option<Span>,
    /// The longest time of a reply that its bytes tell for one.
    surely: Option<Span>,
}

/// What counts as the reply where a request looks the same: twice as long as a reply took that cannot be mistaken, and what the buffer
/// of an adapter may add; of a station of which none is known, what drives usually take.
const BUFFERED: Span = Span::from_millis(20);
const USUAL: Span = Span::from_millis(100);

/// A time in the rows of [`Tally::times`].
const TENTH_MS: u64 = 100;

impl Census {
    pub(super) fn new(terms: Terms, began: Tick) -> Self {
        let (stations, open, last) = (BTreeMap::new(), BTreeMap::new(), None);
        Census { terms, began, heard: 0, garbled: 0, bytes: 0, stations, open, last }
    }

    /// Counts what nobody asks and nobody answers.
    pub(super) fn passes(&mut self, doc: &TelegramDoc, bytes: u64) {
        self.heard += 1;
        self.garbled += u64::from(!doc.check_ok);
        self.bytes += bytes;
    }

    /// Counts a telegram, or what is none.
    pub(super) fn note(&mut self, doc: &TelegramDoc, came: Came) {
        self.passes(doc, came.bytes);
        // Where nothing of it came with what was before, its first byte began so long before it was handed over.
        let start = Tick::from_micros(came.first.as_micros().saturating_sub(self.terms.chars(came.piece).as_micros()));
        let pause = self.last.replace(came.last).filter(|last| came.first > *last).map(|last| start.since(last));
        let Some(address) = doc.address.filter(|_| doc.check_ok) else {
            // What names nobody and is whole, a token, disturbed nothing.
            if let Some(open) = self.open.get(&came.lane).filter(|_| !doc.check_ok) {
                self.stations.entry(open.address).or_default().check_errors += 1;
            }
            return;
        };
        // Adapters and hosts are not exact to a character: what counts is what lies clearly below.
        let is_short = |pause: Span| self.terms.pause.is_some_and(|needed| pause.times(2) < needed);
        let short = u64::from(pause.is_some_and(is_short));
        self.stations.entry(address).or_default().short_pauses += short;
        let answers = self.open.get(&came.lane).is_some_and(|open| open.address == address);
        match doc.direction {
            Some("request") => self.asked(address, doc, came),
            None if !answers => self.asked(address, doc, came),
            None => self.doubts(address, came),
            _ => self.answered(address, doc, start, came),
        }
    }

    /// How long after a request a telegram that looks the same is taken for its reply.
    pub(super) fn in_time(&self, address: u8) -> Span {
        let known = self.stations.get(&address).and_then(|tally| tally.surely);
        known.map_or(USUAL, |known| known.times(2) + BUFFERED).min(self.terms.patience)
    }

    /// The reply to what is open, late, or the same request once more.
    fn doubts(&mut self, address: u8, came: Came) {
        self.stations.entry(address).or_default().either += 1;
        if let Some(open) = self.open.get_mut(&came.lane) {
            (open.at, open.doubts) = (came.last, open.doubts + 1);
        }
    }

    fn asked(&mut self, address: u8, doc: &TelegramDoc, came: Came) {
        self.stations.entry(address).or_default().requests += 1;
        let again = match self.open.remove(&came.lane) {
            Some(open) => {
                self.missed(&open);
                let is_same = open.address == address && open.hex == doc.hex && open.doubts == 0;
                if is_same { open.again + 1 } else { self.close(&open) }
            }
            None => 0,
        };
        if address != self.terms.everybody {
            let open = Open { address, hex: doc.hex.clone(), at: came.last, again, doubts: 0 };
            self.open.insert(came.lane, open);
        }
    }

    fn answered(&mut self, address: u8, doc: &TelegramDoc, start: Tick, came: Came) {
        let is_its = self.open.get(&came.lane).is_some_and(|open| open.address == address);
        let mut open = is_its.then(|| self.open.remove(&came.lane)).flatten();
        if let Some(open) = open.as_mut().filter(|open| open.doubts > 0) {
            // So the last one in doubt was the request; and the one before, if nothing else lies between, was not answered.
            let tally = self.stations.entry(address).or_default();
            (tally.requests, tally.either) = (tally.requests + 1, tally.either.saturating_sub(1));
            if open.doubts == 1 {
                tally.unanswered += 1;
                open.again += 1;
            }
        }
        if let Some(open) = &open {
            self.close(open);
        }
        let tally = self.stations.entry(address).or_default();
        tally.replies += 1;
        tally.exceptions += u64::from(doc.refuses);
        // What was handed over with its question tells no time.
        if let Some(open) = open.filter(|open| came.first > open.at) {
            let time = start.since(open.at);
            tally.took(time);
            if !came.alike {
                tally.surely = Some(tally.surely.map_or(time, |known| known.max(time)));
            }
        }
    }

    /// Nobody answered, unless something came that can be the reply.
    fn missed(&mut self, open: &Open) {
        if open.doubts > 0 {
            return;
        }
        self.stations.entry(open.address).or_default().unanswered += 1;
    }

    /// A question is asked no more; how often the next one was asked again.
    fn close(&mut self, open: &Open) -> u64 {
        if open.again > 0 {
            *self.stations.entry(open.address).or_default().again.entry(open.again).or_default() += 1;
        }
        0
    }

    /// What it comes to.
    pub(super) fn count(&self, now: Tick) -> SniffCount {
        let (listened, busy) = (now.since(self.began).as_micros(), self.terms.chars(self.bytes).as_micros());
        let tenths = (busy.saturating_mul(1_000)).checked_div(listened).unwrap_or(0).min(1_000);
        let waiting = |address: u8| self.open.values().filter(move |open| open.address == address);
        let is_late = |open: &&Open| open.doubts == 0 && now.since(open.at) > self.terms.patience;
        let station = |(&address, tally): (&u8, &Tally)| {
            let again = waiting(address).map(|open| open.again).filter(|again| *again > 0);
            tally.told(address, waiting(address).filter(is_late).count() as u64, again.collect())
        };
        SniffCount {
            t: Decimal { raw: i64::try_from(listened).unwrap_or(i64::MAX), decimals: 6 },
            heard: self.heard,
            garbled: self.garbled,
            load_percent: Decimal { raw: tenths as i64, decimals: 1 },
            stations: self.stations.iter().map(station).collect(),
        }
    }
}

impl Tally {
    fn took(&mut self, time: Span) {
        *self.times.entry(time.as_micros() / TENTH_MS).or_default() += 1;
        self.fastest = Some(self.fastest.map_or(time, |known| known.min(time)));
        self.slowest = Some(self.slowest.map_or(time, |known| known.max(time)));
    }

    /// Half of the replies were faster.
    fn median(&self) -> Option<u64> {
        let half = self.times.values().sum::<u64>().div_ceil(2);
        let mut count = 0;
        let mut until = self.times.iter().filter(|(_, times)| {
            count += **times;
            count >= half
        });
        until.next().map(|(tenths, _)| tenths * TENTH_MS)
    }

    fn told(&self, address: u8, late: u64, again: Vec<u64>) -> SniffedStation {
        let mut repeats = self.again.clone();
        again.into_iter().for_each(|times| *repeats.entry(times).or_default() += 1);
        SniffedStation {
            address,
            requests: self.requests,
            replies: self.replies,
            unanswered: self.unanswered + late,
            either: self.either,
            exceptions: self.exceptions,
            repeats: repeats.into_iter().map(|(times, questions)| Repeats { times, questions }).collect(),
            fastest_us: self.fastest.map(Span::as_micros),
            median_us: self.median().map(|median| median.max(self.fastest.map_or(0, Span::as_micros))),
            slowest_us: self.slowest.map(Span::as_micros),
            check_errors: self.check_errors,
            short_pauses: self.short_pauses,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn telegram(address: u8, direction: &'static str, hex: &str) -> TelegramDoc {
        let doc = TelegramDoc::blank("rtu", hex.to_owned(), true);
        TelegramDoc { address: Some(address), direction: Some(direction), ..doc }
    }

    /// 1 ms a character, so that one can count along.
    fn census() -> Census {
        let (thousand, pause) = (Span::from_secs(1), Some(Span::from_micros(3_500)));
        Census::new(Terms { thousand, pause, patience: Span::from_millis(500), everybody: 0 }, Tick::from_micros(0))
    }

    /// Handed over in one piece at this time.
    fn at(ms: u64, bytes: u64) -> Came {
        let at = Tick::from_micros(ms * 1_000);
        Came { first: at, piece: bytes, last: at, bytes, alike: false, lane: 0 }
    }

    #[test]
    fn questions_are_counted_by_what_became_of_them() {
        let mut census = census();
        let asks = telegram(3, "request", "03 03");
        // Asked three times, answered 20 ms later: the reply has 5 bytes and was whole at 1250.
        for ms in [10, 600, 1_200] {
            census.note(&asks, at(ms, 8));
        }
        census.note(&telegram(3, "reply", "03 83"), at(1_225, 5));
        // And another one, which nobody answers.
        census.note(&asks, at(2_000, 8));
        let [told] = &census.count(Tick::from_micros(2_100_000)).stations[..] else { panic!() };
        assert_eq!((told.requests, told.replies, told.unanswered), (4, 1, 2), "the last may still be answered");
        assert_eq!(told.repeats, [Repeats { times: 2, questions: 1 }]);
        assert_eq!((told.fastest_us, told.median_us, told.slowest_us), (Some(20_000), Some(20_000), Some(20_000)));
        let late = census.count(Tick::from_micros(4_000_000));
        assert_eq!(late.stations[0].unanswered, 3);
        // 37 characters in 4 s.
        assert_eq!((late.load_percent, late.heard), (Decimal { raw: 9, decimals: 1 }, 5));
    }

    #[test]
    fn what_comes_in_one_piece_has_no_time_and_no_pause() {
        let mut census = census();
        census.note(&telegram(1, "request", "01"), at(50, 8));
        census.note(&telegram(1, "reply", "01"), at(50, 7));
        // Behind it 1 ms of silence, where 3.5 ms are needed.
        census.note(&telegram(2, "request", "02"), at(59, 8));
        let garbled = TelegramDoc::blank("rtu", "55".to_owned(), false);
        census.note(&garbled, at(80, 1));
        let count = census.count(Tick::from_micros(100_000));
        let [one, two] = &count.stations[..] else { panic!("{count:?}") };
        assert_eq!((one.replies, one.fastest_us, one.short_pauses), (1, None, 0));
        assert_eq!((two.short_pauses, two.check_errors, two.unanswered, count.garbled), (1, 1, 0, 1));
    }

    #[test]
    fn nobody_answers_what_is_for_everybody() {
        let mut census = census();
        census.note(&telegram(0, "request", "00"), at(10, 8));
        let count = census.count(Tick::from_micros(9_000_000));
        assert_eq!((count.stations[0].requests, count.stations[0].unanswered), (1, 0));
    }
}
