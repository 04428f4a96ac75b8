//! Who is on the line? Every station is asked the same question, and the line is listened to all the while.
//!
//! * The next station is asked after a short window, but nobody's time is cut short by that: a reply names its station, so
//!   it is credited whenever it comes, and at the end every station has had its full time.
//! * Nothing is sent into a telegram that is coming in.
//! * Garbage is the trace of somebody: of two replies at once, or of a reply that met our question. Whoever was asked
//!   within the full time before it and is still silent is asked again when his time is over: in another rhythm, so that
//!   what has met once does not meet again, and with windows that grow, in the end by the book.
//! * Who is heard is told at once ([`News::Heard`]), so that it can be asked what it is. Meanwhile somebody else has the
//!   line ([`Survey::resume`]); what he overhears is handed in ([`Survey::overhear`]).

use super::dialect::{Dialect, Question, Said};
use super::{Conversation, Record, Step, Verdict};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet, VecDeque};

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
}

/// A drive answers not before 10 ms (CM-485 manual 6.8).
const REPLY_DELAY: Span = Span::from_millis(10);
/// What a drive may take longer than that without being late.
const SLACK: Span = Span::from_millis(2);
/// USB adapters hold bytes back for up to 16 ms (facts/engineering.md: latency timer of FTDI).
const ADAPTER: Span = Span::from_millis(16);
/// A look at a setting may take so much longer than a typical drive does, because nobody listens there any more when it
/// is over.
const GLANCE: Span = Span::from_millis(20);
/// Pause of the manual after a reply (CM-485 manual 6.8).
const PAUSE: Span = Span::from_millis(2);
/// So often garbage must come when a station is asked alone before it is given up.
const TRIES: u32 = 3;
/// A line that is never silent for so long belongs to somebody else.
const BABBLE: Span = Span::from_secs(1);
/// Bytes that are kept of what is no telegram yet: more than any reply has.
const MOST_BYTES: usize = 128;
/// Longest reply to a question that asks for one value, in any protocol.
const LONGEST_REPLY: usize = 32;
/// From so many questions on it can be told that the line itself makes the garbage.
const NOISE_SAMPLE: u32 = 8;

impl Patience {
    /// The window is just long enough for a typical drive: its reply is over by then, so the next question does not
    /// meet it whatever the adapter holds back; on slow lines its first byte has been seen, and the rest is waited for.
    pub fn brief(protocol: Protocol, line: LineSetting, question: &Question, full: Span) -> Self {
        let mut dialect = Dialect::new(protocol);
        // The reply is a little shorter than the question.
        let length = dialect.encode(1, question).len().saturating_sub(1);
        let whole = dialect.duration(line, length) + dialect.gap(line, PAUSE);
        let window = REPLY_DELAY + SLACK + whole.min(first_byte(dialect, line));
        Patience { window: window.min(full), full, thorough: true, twice: 0 }
    }

    /// A short look before the setting of the line is changed: the first byte of a typical drive has been seen.
    pub fn glance(protocol: Protocol, line: LineSetting, full: Span) -> Self {
        let window = REPLY_DELAY + SLACK + first_byte(Dialect::new(protocol), line) + GLANCE;
        Patience { window: window.min(full), full, thorough: false, twice: 0 }
    }

    /// Every station gets its full time before the next is asked.
    pub fn by_the_book(full: Span) -> Self {
        Patience { window: full, full, thorough: true, twice: 0 }
    }
}

/// How long the first byte of a reply may take from the start of it to the program.
fn first_byte(dialect: Dialect, line: LineSetting) -> Span {
    dialect.duration(line, 1) + ADAPTER
}

/// What a survey tells on its way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum News {
    /// This station is being asked.
    Asked(u8),
    /// A station is there. Told once a station, when the line is free for whoever wants to ask it more.
    Heard(Sign),
    /// Everybody was asked and has had the time to answer.
    Over,
}

/// A sign of life.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sign {
    /// Who.
    pub station: u8,
    /// Its reply; `None` if it sent a valid telegram that does not answer the question.
    pub said: Option<Said>,
    /// From the end of the question to the end of the reply.
    pub after: Span,
}

/// What a station did.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Attendance {
    /// How often it was asked.
    pub asked: u32,
    /// What it replied; more replies than questions are not the work of one station.
    pub replies: Vec<Said>,
    /// How often garbage came that nobody else can have sent.
    pub garbled: u32,
    /// End of the last question to it.
    end: Tick,
    /// It sent something valid.
    heard: bool,
}

/// A survey of one line with one setting.
#[derive(Debug)]
pub struct Survey {
    dialect: Dialect,
    line: LineSetting,
    questions: BTreeMap<u8, Question>,
    patience: Patience,
    /// Stations in the order in which they are asked first.
    order: Vec<u8>,
    queue: VecDeque<u8>,
    round: Round,
    stations: BTreeMap<u8, Attendance>,
    /// Stations that sent telegrams without having been asked.
    strangers: BTreeSet<u8>,
    /// Silent stations that may have sent garbage, with the shortest time from question to garbage.
    suspects: BTreeMap<u8, Span>,
    /// What has come and is no telegram yet.
    came: Vec<u8>,
    began: Tick,
    last: Tick,
    /// The last telegram, as long as its echo may come.
    sent: Vec<u8>,
    /// Who was asked last, and until when it is waited for.
    window: Option<(u8, Tick)>,
    /// The line is free for the next telegram from then on.
    ready_at: Tick,
    /// An exchange must be ended on the line, where the protocol wants that.
    farewell: bool,
    /// Who is being asked, until that is told.
    asking: Option<u8>,
    /// Signs of life that are to be told.
    signs: VecDeque<Sign>,
    noisy: bool,
    occupied: bool,
    /// Times that garbage came.
    garbage: u32,
    records: Vec<Record>,
}

/// One time around.
#[derive(Clone, Copy, Debug)]
struct Round {
    number: u32,
    window: Span,
    asked: u32,
    garbage: u32,
}

/// A reply in what has come.
struct Found {
    start: usize,
    end: usize,
    station: u8,
    said: Said,
}

impl Attendance {
    /// Replies that are more than there were questions.
    pub fn surplus(&self) -> usize {
        self.replies.len().saturating_sub(self.asked as usize)
    }

    /// Whether a reply may still come.
    pub fn owes(&self) -> bool {
        self.replies.len() < self.asked as usize
    }

    /// Whether the replies are not all the same.
    pub fn differ(&self) -> bool {
        self.replies.iter().any(|reply| Some(reply) != self.replies.first())
    }
}

impl Survey {
    /// A survey that puts to every station its question, in their order.
    pub fn new(
        protocol: Protocol,
        line: LineSetting,
        questions: impl IntoIterator<Item = (u8, Question)>,
        patience: Patience,
        now: Tick,
    ) -> Self {
        let dialect = Dialect::new(protocol);
        let questions: Vec<(u8, Question)> = questions.into_iter().collect();
        Survey {
            dialect,
            line,
            order: questions.iter().map(|question| question.0).collect(),
            queue: questions.iter().map(|question| question.0).collect(),
            questions: questions.into_iter().collect(),
            patience,
            round: Round { number: 0, window: patience.window, asked: 0, garbage: 0 },
            stations: BTreeMap::new(),
            strangers: BTreeSet::new(),
            suspects: BTreeMap::new(),
            came: Vec::new(),
            began: now,
            last: now,
            sent: Vec::new(),
            window: None,
            ready_at: now + dialect.silence(line),
            farewell: false,
            asking: None,
            signs: VecDeque::new(),
            noisy: false,
            occupied: false,
            garbage: 0,
            records: Vec::new(),
        }
    }

    /// What every station did that was asked.
    pub fn attendance(&self) -> &BTreeMap<u8, Attendance> {
        &self.stations
    }

    /// Stations that were asked and have answered, or cannot answer any more by now, and are not to be asked again.
    pub fn settled(&self, now: Tick) -> impl Iterator<Item = u8> {
        let over = move |known: &Attendance| known.heard || now >= known.end + self.patience.full;
        let open = |station: &u8| self.suspects.contains_key(station) || self.queue.contains(station);
        self.stations.iter().filter(move |(station, known)| over(known) && !open(station)).map(|(&station, _)| station)
    }

    /// Whether garbage came at all: somebody is there.
    pub fn is_garbled(&self) -> bool {
        self.garbage > 0
    }

    /// Stations that sent telegrams without having been asked: somebody else asks them.
    pub fn strangers(&self) -> &BTreeSet<u8> {
        &self.strangers
    }

    /// Whether garbage came so often that it is the line's and not a station's.
    pub fn is_noisy(&self) -> bool {
        self.noisy
    }

    /// Whether somebody else spoke all the time, so that nobody could be asked any more.
    pub fn is_occupied(&self) -> bool {
        self.occupied
    }

    /// Silent stations that garbage came from: again and again, or right after the only question to them.
    pub fn garbled(&self) -> impl Iterator<Item = u8> {
        let soon = |station: &u8| self.suspects.get(station).is_some_and(|&delay| delay <= self.patience.window);
        let once = move |station: &u8| !self.patience.thorough && soon(station);
        let silent = self.stations.iter().filter(|(_, known)| !known.heard);
        silent.filter(move |(station, known)| known.garbled >= TRIES || once(station)).map(|(&station, _)| station)
    }

    /// The telegrams since the last call.
    pub fn take_records(&mut self) -> Vec<Record> {
        std::mem::take(&mut self.records)
    }

    /// What to do now. Call again after every step, also after `Done`, until it is [`News::Over`].
    pub fn step(&mut self, now: Tick) -> Step<News> {
        if let Some(station) = self.asking.take() {
            return Step::Done(News::Asked(station));
        }
        if !self.came.is_empty() {
            let over = self.last + self.straggle();
            if now < over && now.since(self.began) < BABBLE {
                return Step::Wait(over);
            }
            self.occupied = now < over;
            self.reject(now);
        }
        if self.occupied {
            return self.end();
        }
        if now < self.ready_at {
            return Step::Wait(self.ready_at);
        }
        if std::mem::take(&mut self.farewell) {
            return self.send(now, self.dialect.farewell().to_vec(), Verdict::Farewell);
        }
        if let Some(sign) = self.signs.pop_front() {
            return Step::Done(News::Heard(sign));
        }
        match self.window {
            Some((_, until)) if now < until => return Step::Wait(until),
            _ => self.window = None,
        }
        self.proceed(now)
    }

    /// The next question; when all are asked, the next round; then the end.
    fn proceed(&mut self, now: Tick) -> Step<News> {
        if let Some(station) = self.queue.pop_front() {
            return self.ask(station, now);
        }
        // The first time around is long: when it is over, whoever was suspected in it may have had his time already.
        let recent = self.suspicious().filter_map(|station| self.stations.get(&station.0)).map(|known| known.end).max();
        let is_long = recent.is_some_and(|end| now >= end + self.patience.full) && self.round.number == 0;
        match self.last_reply_by().filter(|&until| now < until && !is_long) {
            Some(until) => Step::Wait(until),
            None if self.next_round() => self.proceed(now),
            None => self.end(),
        }
    }

    fn ask(&mut self, station: u8, now: Tick) -> Step<News> {
        let Some(question) = self.questions.get(&station) else { return Step::Wait(now) };
        let bytes = self.dialect.encode(station, question);
        let end = now + self.dialect.duration(self.line, bytes.len());
        let attendance = self.stations.entry(station).or_default();
        attendance.asked += 1;
        attendance.end = end;
        self.round.asked += 1;
        self.window = Some((station, end + self.round.window));
        self.asking = Some(station);
        self.sent.clone_from(&bytes);
        self.send(now, bytes, Verdict::Request)
    }

    fn send(&mut self, now: Tick, bytes: Vec<u8>, verdict: Verdict) -> Step<News> {
        let end = now + self.dialect.duration(self.line, bytes.len());
        self.ready_at = end + self.dialect.silence(self.line);
        self.records.push(Record { at: now, verdict, bytes: bytes.clone() });
        Step::Send(bytes)
    }

    fn end(&mut self) -> Step<News> {
        Step::Done(self.signs.pop_front().map_or(News::Over, News::Heard))
    }

    /// Until when somebody may still answer; `None` if nobody is waited for.
    fn last_reply_by(&self) -> Option<Tick> {
        let silent = self.stations.values().filter(|station| !station.heard);
        silent.map(|station| station.end + self.patience.full).max().filter(|_| self.patience.thorough)
    }

    /// Who is to be asked again, and how long before the garbage he was asked.
    fn suspicious(&self) -> impl Iterator<Item = (u8, Span)> {
        let first = if self.round.number == 0 { self.patience.twice } else { 0 };
        let again = self.order.iter().take(first).filter(|station| !self.suspects.contains_key(station));
        let suspects = self.suspects.iter().map(|(&station, &delay)| (station, delay));
        let all = suspects.chain(again.map(|&station| (station, self.patience.full)));
        all.filter(|(station, _)| self.stations.get(station).is_some_and(|known| !known.heard && known.garbled < TRIES))
    }

    /// Puts the suspects into the queue; `false` if there are none.
    fn next_round(&mut self) -> bool {
        let mut suspects: Vec<(u8, Span)> = self.suspicious().collect();
        self.suspects.clear();
        // The most suspicious first: who was asked right before the garbage came.
        suspects.sort_by_key(|suspect| suspect.1);
        let usual = self.round.asked >= NOISE_SAMPLE && self.round.garbage > self.round.asked / 2;
        self.noisy |= usual;
        if suspects.is_empty() || usual || !self.patience.thorough {
            return false;
        }
        let window = match self.round.number {
            _ if suspects.len() == 1 => self.patience.full,
            // In another rhythm, so that a reply does not meet the same moment again.
            0 => Span::from_micros(self.patience.window.as_micros() * 5 / 4).min(self.patience.full),
            _ => self.round.window.times(2).min(self.patience.full),
        };
        self.queue = suspects.into_iter().map(|suspect| suspect.0).collect();
        self.round = Round { number: self.round.number + 1, window, asked: 0, garbage: 0 };
        true
    }

    /// Takes bytes that came in at `at`.
    pub fn feed(&mut self, at: Tick, bytes: &[u8]) {
        if self.came.is_empty() {
            self.began = at;
        }
        self.last = at;
        self.ready_at = self.ready_at.max(at + self.dialect.gap(self.line, PAUSE));
        // Some drivers leave the parity bit of 7-bit characters in place.
        let mask = if self.line.data_bits == 7 { 0x7F } else { 0xFF };
        self.came.extend(bytes.iter().map(|byte| byte & mask));
        self.sort_out(at);
        let surplus = self.came.len().saturating_sub(MOST_BYTES);
        self.came.drain(..surplus);
    }

    /// Somebody else has had the line until now.
    pub fn resume(&mut self, now: Tick) {
        self.ready_at = self.ready_at.max(now + self.dialect.gap(self.line, PAUSE));
    }

    /// Takes what came while somebody else had the line, and was not for him.
    pub fn overhear(&mut self, at: Tick, bytes: &[u8]) {
        self.feed(at, bytes);
        if !self.came.is_empty() {
            self.reject(at);
        }
    }

    /// Takes the echo of our own telegram and every reply out of what has come.
    fn sort_out(&mut self, at: Tick) {
        let echo = self.came.windows(self.sent.len().max(1)).position(|window| window == self.sent);
        if let Some(start) = echo {
            self.came.drain(start..start + self.sent.len());
            let bytes = std::mem::take(&mut self.sent);
            self.records.push(Record { at, verdict: Verdict::Echo, bytes });
        }
        while let Some(found) = self.find() {
            let bytes: Vec<u8> = self.came.drain(..found.end).collect();
            let (before, reply) = bytes.split_at(found.start);
            // A little noise when the line turns around is nobody's telegram.
            if before.len() >= self.dialect.shortest_reply() {
                self.note(at, before);
            }
            self.credit(at, found.station, found.said, reply);
        }
    }

    /// The first reply in what has come, of anybody who was asked.
    fn find(&self) -> Option<Found> {
        let (came, least) = (&self.came, self.dialect.shortest_reply());
        (0..came.len()).find_map(|start| {
            (start + least..=came.len().min(start + LONGEST_REPLY)).find_map(|end| {
                let (station, said) = self.dialect.sender(came.get(start..end)?)?;
                let question = self.questions.get(&station).filter(|_| self.stations.contains_key(&station))?;
                let said = said.filter(|said| question.is_answered_by(said))?;
                Some(Found { start, end, station, said })
            })
        })
    }

    /// A reply belongs to the station that it names.
    fn credit(&mut self, at: Tick, station: u8, said: Said, bytes: &[u8]) {
        let asked = self.window.is_some_and(|(asked, _)| asked == station);
        let verdict = if asked { Verdict::Reply } else { Verdict::Stray { station } };
        self.records.push(Record { at, verdict, bytes: bytes.to_vec() });
        if asked {
            self.window = None;
            self.farewell = !self.dialect.farewell().is_empty();
        }
        let Some(attendance) = self.stations.get_mut(&station).filter(|_| !said.is_unreached()) else { return };
        attendance.replies.push(said.clone());
        let after = at.since(attendance.end);
        if !std::mem::replace(&mut attendance.heard, true) {
            self.signs.push_back(Sign { station, said: Some(said), after });
        }
    }

    /// What has come is no reply and nothing follows.
    fn reject(&mut self, at: Tick) {
        let bytes = std::mem::take(&mut self.came);
        self.note(at, &bytes);
    }

    /// Says what bytes are that are no reply: a telegram all the same, or garbage, which has its suspects.
    fn note(&mut self, at: Tick, bytes: &[u8]) {
        let Some((station, _)) = self.dialect.sender(bytes) else {
            self.records.push(Record { at, verdict: Verdict::Garbage, bytes: bytes.to_vec() });
            return self.suspect();
        };
        self.records.push(Record { at, verdict: Verdict::Stray { station }, bytes: bytes.to_vec() });
        let Some(known) = self.stations.get_mut(&station) else {
            self.strangers.insert(station);
            return self.suspect();
        };
        if !std::mem::replace(&mut known.heard, true) {
            self.signs.push_back(Sign { station, said: None, after: at.since(known.end) });
        }
    }

    /// Whoever may have sent what began last and nobody understands, or what nobody was asked for.
    fn suspect(&mut self) {
        self.round.garbage += 1;
        self.garbage += 1;
        let (began, full) = (self.began, self.patience.full);
        let silent = self.stations.iter().filter(|(_, station)| !station.heard);
        let within = silent.map(|(&station, known)| (station, began.since(known.end)));
        let suspects: Vec<(u8, Span)> = within.filter(|&(_, delay)| delay < full).collect();
        if let [(only, _)] = suspects.as_slice()
            && let Some(known) = self.stations.get_mut(only)
        {
            known.garbled += 1;
        }
        for (station, delay) in suspects {
            let shortest = self.suspects.entry(station).or_insert(delay);
            *shortest = delay.min(*shortest);
        }
    }

    /// Silence after which a telegram that has begun is over; whoever is asked by the book may dawdle as it allows.
    fn straggle(&self) -> Span {
        if self.round.window == self.patience.full {
            return self.dialect.straggle(&self.came);
        }
        ADAPTER + self.dialect.duration(self.line, 2)
    }
}

impl Conversation for Survey {
    type End = News;

    fn step(&mut self, now: Tick) -> Step<News> {
        Survey::step(self, now)
    }

    fn feed(&mut self, at: Tick, bytes: &[u8]) {
        Survey::feed(self, at, bytes);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::line::Parity;
    use crate::protocol::modbus::pdu::{Reply, Request};
    use crate::protocol::modbus::{Framing, rtu};

    const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);
    const RTU: Protocol = Protocol::Modbus(Framing::Rtu);
    const FULL: Span = Span::from_millis(500);

    /// Two wires on which who speaks at once with somebody is not understood. The master does not hear what comes while
    /// it sends, as behind an adapter that switches its receiver off.
    struct Bus {
        survey: Survey,
        now: Tick,
        /// Station, delay of its reply, value that it replies with.
        drives: Vec<(u8, u64, u16)>,
        /// Bytes on the wire: from, to, what the master hears when they are over.
        slots: Vec<(Tick, Tick, u8)>,
        /// The adapter holds bytes back until then.
        latency: Span,
        sent: Vec<(Tick, Vec<u8>)>,
        told: Vec<News>,
    }

    fn question() -> Question {
        Question::Modbus(Request::ReadRegisters { start: 411, count: 1 })
    }

    fn survey(stations: impl IntoIterator<Item = u8>, patience: Patience) -> Survey {
        let questions = stations.into_iter().map(|station| (station, question()));
        Survey::new(RTU, LINE, questions, patience, Tick::ZERO)
    }

    fn brief() -> Patience {
        Patience::brief(RTU, LINE, &question(), FULL)
    }

    impl Bus {
        fn new(drives: &[(u8, u64, u16)], stations: impl IntoIterator<Item = u8>, patience: Patience) -> Self {
            let survey = survey(stations, patience);
            let drives = drives.to_vec();
            Bus {
                survey,
                now: Tick::ZERO,
                drives,
                slots: Vec::new(),
                latency: Span::ZERO,
                sent: Vec::new(),
                told: Vec::new(),
            }
        }

        /// Puts bytes on the wire; whatever is there at the same time is spoilt.
        fn put(&mut self, at: Tick, bytes: &[u8]) {
            for (count, &byte) in (0..).zip(bytes) {
                let (from, to) = (at + LINE.chars(count), at + LINE.chars(count + 1));
                match self.slots.iter_mut().find(|slot| slot.0 < to && from < slot.1) {
                    Some(slot) => slot.2 &= byte.rotate_left(1),
                    None => self.slots.push((from, to, byte)),
                }
            }
            self.slots.sort();
        }

        fn send(&mut self, bytes: Vec<u8>) {
            let end = self.now + LINE.chars(bytes.len() as u64);
            let (now, before) = (self.now, self.slots.len());
            self.slots.retain(|slot| slot.1 <= now || slot.0 >= end);
            let clean = before == self.slots.len();
            let asked = *bytes.first().unwrap();
            for (station, delay, value) in self.drives.clone() {
                if clean && station == asked {
                    let reply = rtu::encode(station, &Reply::Registers(vec![value]).encode());
                    self.put(end + Span::from_millis(delay), &reply);
                }
            }
            self.sent.push((now, bytes));
        }

        fn run(mut self) -> Self {
            loop {
                match self.survey.step(self.now) {
                    Step::Done(News::Over) => return self,
                    Step::Done(news) => self.told.push(news),
                    Step::Send(bytes) => self.send(bytes),
                    Step::Wait(until) => self.wait(until),
                }
                assert!(self.now < Tick::ZERO + Span::from_secs(1_000), "it ends");
            }
        }

        fn wait(&mut self, until: Tick) {
            let Some(&(_, end, _)) = self.slots.first().filter(|slot| slot.1 + self.latency <= until) else {
                self.now = self.now.max(until);
                return;
            };
            // The adapter hands on what has come when its time is over.
            self.now = self.now.max(end + self.latency);
            let due = self.slots.iter().take_while(|slot| slot.1 <= self.now).count();
            let bytes: Vec<u8> = self.slots.drain(..due).map(|slot| slot.2).collect();
            self.survey.feed(self.now, &bytes);
        }

        fn found(&self) -> Vec<u8> {
            let heard = self.told.iter().filter_map(|news| match news {
                News::Heard(sign) => Some(sign.station),
                _ => None,
            });
            let mut heard: Vec<u8> = heard.collect();
            heard.sort_unstable();
            heard
        }
    }

    const THREE: [(u8, u64, u16); 3] = [(1, 10, 7), (17, 11, 8), (42, 12, 9)];

    #[test]
    fn the_whole_line_takes_six_seconds_and_asks_everybody_once() {
        let bus = Bus::new(&THREE, 1..=247, brief()).run();
        assert_eq!(bus.found(), [1, 17, 42]);
        assert_eq!(bus.sent.len(), 247);
        let took = bus.now.since(Tick::ZERO);
        assert!(took < Span::from_millis(6_500), "{took}");
        // The last one has had its full time.
        assert!(bus.now.since(bus.sent.last().unwrap().0) >= FULL);
    }

    #[test]
    fn an_adapter_that_holds_bytes_back_costs_nothing_but_time() {
        let mut bus = Bus::new(&THREE, 1..=60, brief());
        bus.latency = ADAPTER;
        let bus = bus.run();
        assert_eq!(bus.found(), [1, 17, 42]);
        assert_eq!(bus.sent.len(), 60, "nobody is asked twice");
    }

    #[test]
    fn a_late_reply_is_credited_to_the_address_that_it_names() {
        let bus = Bus::new(&[(1, 10, 7), (17, 304, 8)], 1..=60, brief()).run();
        let said = Some(Said::Modbus(Reply::Registers(vec![8])));
        let late = bus.told.iter().find_map(|news| match news {
            News::Heard(sign) if sign.station == 17 => Some(sign.clone()),
            _ => None,
        });
        assert_eq!(late, Some(Sign { station: 17, said, after: Span::from_millis(304) + LINE.chars(7) }));
        assert_eq!(bus.survey.attendance()[&17].replies.len(), 1);
    }

    #[test]
    fn late_replies_that_meet_a_question_are_asked_for_again() {
        // What comes while the master sends is lost: only a reply that is over before its questions are is never seen.
        let count = |patience: Patience| {
            let found = |delay: &u64| Bus::new(&[(17, *delay, 8)], 1..=60, patience).run().found() == [17];
            (10..=490).filter(found).count()
        };
        assert!(count(brief()) >= 481 * 92 / 100, "{}", count(brief()));
        assert_eq!(count(Patience::by_the_book(FULL)), 481);
    }

    #[test]
    fn a_question_that_was_spoilt_by_a_late_reply_is_repeated() {
        // 17 answers into the questions to those who are asked 300 ms later: every one of them is found all the same.
        for victim in 28..=33 {
            for delay in 296..320 {
                let bus = Bus::new(&[(17, delay, 8), (victim, 10, 9)], 1..=60, brief()).run();
                assert!(bus.found().contains(&victim) || !bus.found().contains(&17), "{victim} {delay}");
            }
        }
    }

    #[test]
    fn two_with_one_address_are_told_from_silence() {
        let same = Bus::new(&[(1, 10, 7), (17, 10, 8), (17, 10, 9)], 1..=247, brief()).run();
        assert_eq!(same.found(), [1]);
        assert_eq!(same.survey.attendance()[&17].garbled, TRIES);
        let others = same.survey.attendance().iter().filter(|(station, _)| **station != 17);
        assert_eq!(others.map(|(_, known)| known.garbled).max(), Some(0));
        let took = same.now.since(Tick::ZERO);
        assert!(took < Span::from_secs(10), "{took}");
        let apart = Bus::new(&[(17, 10, 8), (17, 30, 9)], 15..=20, brief()).run();
        let known = &apart.survey.attendance()[&17];
        assert_eq!((apart.found(), known.asked, known.replies.len()), (vec![17], 1, 2));
    }

    #[test]
    fn nothing_is_sent_into_a_telegram_that_comes_in() {
        // The first byte of the reply comes in the last moment of the window.
        let patience = Patience { window: Span::from_millis(20), ..brief() };
        let bus = Bus::new(&[(1, 19, 7)], 1..=3, patience).run();
        let (first, second) = (bus.sent[0].0, bus.sent[1].0);
        let reply = LINE.chars(8) + Span::from_millis(19) + LINE.chars(7);
        assert_eq!(second.since(first), reply + LINE.t35());
        assert_eq!((bus.found(), bus.sent.len()), (vec![1], 3));
    }

    #[test]
    fn echo_and_noise_are_nobody() {
        let mut survey = survey(1..=2, brief());
        let mut now = Tick::ZERO;
        let mut asked = 0;
        loop {
            match survey.step(now) {
                Step::Done(News::Over) => break,
                Step::Done(News::Asked(_)) => asked += 1,
                Step::Done(News::Heard(sign)) => assert_eq!(sign.station, 2),
                Step::Send(mut bytes) => {
                    now += LINE.chars(bytes.len() as u64);
                    let to = bytes[0];
                    bytes.insert(0, 0x00);
                    survey.feed(now, &bytes);
                    if to == 2 {
                        now += Span::from_millis(10);
                        survey.feed(now, &[0xFF]);
                        survey.feed(now, &rtu::encode(2, &Reply::Registers(vec![1]).encode()));
                    }
                }
                Step::Wait(until) => now = until,
            }
        }
        assert_eq!(survey.attendance()[&2].replies.len(), 1);
        assert!(survey.attendance()[&1].garbled > 0 && asked > 2, "a byte of noise may be the rest of a reply");
    }

    #[test]
    fn a_line_that_is_never_silent_is_left_alone() {
        let mut survey = survey(1..=247, brief());
        let mut now = Tick::ZERO;
        let mut sent = 0;
        loop {
            match survey.step(now) {
                Step::Done(News::Over) => break,
                Step::Done(_) => {}
                Step::Send(_) => sent += 1,
                Step::Wait(_) => {
                    now += Span::from_millis(3);
                    survey.feed(now, &[0x55]);
                }
            }
        }
        assert!(survey.is_occupied());
        assert!(sent <= 1 && now < Tick::ZERO + Span::from_secs(2));
    }

    #[test]
    fn telegrams_of_somebody_else_are_told_apart() {
        let mut survey = survey([1], brief());
        let mut now = Tick::ZERO;
        loop {
            match survey.step(now) {
                Step::Done(News::Over) => break,
                Step::Done(_) => {}
                Step::Send(_) => {
                    now += Span::from_millis(20);
                    survey.feed(now, &rtu::encode(9, &[3, 0, 0, 0, 1]));
                }
                Step::Wait(until) => now = until,
            }
        }
        assert_eq!(survey.strangers().iter().collect::<Vec<_>>(), [&9]);
        assert!(!survey.attendance()[&1].heard);
    }

    #[test]
    fn what_others_overhear_is_credited_too() {
        let mut survey = survey([1, 2], brief());
        let mut now = Tick::ZERO;
        while !matches!(survey.step(now), Step::Send(_)) {
            now += Span::from_millis(1);
        }
        now += Span::from_millis(30);
        survey.overhear(now, &rtu::encode(1, &Reply::Registers(vec![1]).encode()));
        assert_eq!(survey.step(now), Step::Done(News::Asked(1)));
        let Step::Wait(free) = survey.step(now) else { panic!("the pause after a reply") };
        assert!(matches!(survey.step(free), Step::Done(News::Heard(Sign { station: 1, .. }))));
    }
}
