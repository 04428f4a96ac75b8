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

pub(super) mod foreign;

use super::dialect::{Dialect, Question, Said};
use super::{Conversation, MOST_RECORDS, Record, Step, Verdict};
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
    /// Whether the line is left to another master that speaks on it.
    pub yields: bool,
}

/// A drive answers not before 10 ms (CM-485 manual 6.8).
const REPLY_DELAY: Span = Span::from_millis(10);
/// What a drive may take longer than that without being late.
const SLACK: Span = Span::from_millis(2);
/// USB adapters hold bytes back for up to 16 ms (docs/measured.md: latency timer of FTDI).
const ADAPTER: Span = Span::from_millis(16);
/// An adapter or a server of ports gives back what we send within this time (as long as a repeater takes, docs/measured.md).
const ECHO_WITHIN: Span = Span::from_millis(600);
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
/// So many questions of somebody else are no accident of the line: there is another master.
const OTHER_MASTER: u32 = 3;
/// From so many questions on it can be told that the line itself makes the garbage.
const NOISE_SAMPLE: u32 = 8;
/// Times around: windows double from one to the next, so by then every station has been asked by the book, and often enough.
const MOST_ROUNDS: u32 = 16;
/// Replies that are kept of one station; more tell nothing new.
const MOST_REPLIES: usize = 64;

impl Patience {
    /// The window is just long enough for a typical drive: its reply is over by then, so the next question does not
    /// meet it whatever the adapter holds back; on slow lines its first byte has been seen, and the rest is waited for.
    pub fn brief(protocol: Protocol, line: LineSetting, question: &Question, full: Span) -> Self {
        let mut dialect = Dialect::new(protocol);
        // The reply is a little shorter than the question.
        let length = dialect.encode(1, question).len().saturating_sub(1);
        let whole = dialect.duration(line, length) + dialect.gap(line, PAUSE);
        let window = REPLY_DELAY + SLACK + whole.min(first_byte(dialect, line));
        Patience { window: window.min(full), full, thorough: true, twice: 0, yields: true }
    }

    /// A short look before the setting of the line is changed: the first byte of a typical drive has been seen.
    pub fn glance(protocol: Protocol, line: LineSetting, full: Span) -> Self {
        let window = REPLY_DELAY + SLACK + first_byte(Dialect::new(protocol), line) + GLANCE;
        Patience { window: window.min(full), full, thorough: false, twice: 0, yields: true }
    }

    /// Every station gets its full time before the next is asked.
    pub fn by_the_book(full: Span) -> Self {
        Patience { window: full, full, thorough: true, twice: 0, yields: true }
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
    /// The last telegrams and when they went out, as long as their echoes may come.
    sent: VecDeque<(Tick, Vec<u8>)>,
    /// Who was asked last, and until when it is waited for.
    window: Option<(u8, Tick)>,
    /// The line is free for the next telegram from then on.
    ready_at: Tick,
    /// Since when the line is waited for.
    held: Option<Tick>,
    /// An exchange must be ended on the line, where the protocol wants that.
    farewell: bool,
    /// Who is being asked, until that is told.
    asking: Option<u8>,
    /// Signs of life that are to be told.
    signs: VecDeque<Sign>,
    noisy: bool,
    occupied: bool,
    /// Our last telegrams, which a line may double.
    ours: VecDeque<(Tick, Vec<u8>)>,
    /// Questions that were heard and are not ours.
    foreign: u32,
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
            sent: VecDeque::new(),
            window: None,
            ready_at: now + dialect.silence(line),
            held: None,
            farewell: false,
            asking: None,
            signs: VecDeque::new(),
            noisy: false,
            occupied: false,
            ours: VecDeque::new(),
            foreign: 0,
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

    /// Whether another master asks on this line.
    pub fn is_shared(&self) -> bool {
        self.foreign >= OTHER_MASTER
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
        if self.patience.yields && self.is_shared() {
            return Step::Done(News::Over);
        }
        if self.occupied {
            return self.end();
        }
        if now < self.ready_at {
            let held = *self.held.get_or_insert(now);
            // Whole telegrams without a pause between them are babble too.
            self.occupied = now.since(held) >= BABBLE;
            return if self.occupied { self.end() } else { Step::Wait(self.ready_at.min(held + BABBLE)) };
        }
        self.held = None;
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
        for telegrams in [&mut self.sent, &mut self.ours] {
            telegrams.retain(|(then, _)| now.since(*then) <= ECHO_WITHIN);
            telegrams.push_back((now, bytes.clone()));
        }
        self.send(now, bytes, Verdict::Request)
    }

    fn send(&mut self, now: Tick, bytes: Vec<u8>, verdict: Verdict) -> Step<News> {
        let end = now + self.dialect.duration(self.line, bytes.len());
        self.ready_at = end + self.dialect.silence(self.line);
        self.record(Record { at: now, verdict, bytes: bytes.clone() });
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
        let enough = self.round.number >= MOST_ROUNDS;
        if suspects.is_empty() || usual || enough || !self.patience.thorough {
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
        // Before it is sorted: a flood must not cost the time that tells it from silence.
        let surplus = self.came.len().saturating_sub(MOST_BYTES);
        self.came.drain(..surplus);
        self.sort_out(at);
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
        while let Some((place, start)) = self.echo() {
            let Some((_, bytes)) = self.sent.remove(place) else { break };
            self.came.drain(start..start + bytes.len());
            self.record(Record { at, verdict: Verdict::Echo, bytes });
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

    /// Which of our telegrams has come back, and where it stands in what has come.
    fn echo(&self) -> Option<(usize, usize)> {
        self.sent.iter().enumerate().find_map(|(place, (_, sent))| {
            let start = self.came.windows(sent.len().max(1)).position(|window| window == sent)?;
            Some((place, start))
        })
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
        self.record(Record { at, verdict, bytes: bytes.to_vec() });
        if asked {
            self.window = None;
            self.farewell = !self.dialect.farewell().is_empty();
        }
        let Some(attendance) = self.stations.get_mut(&station).filter(|_| !said.is_unreached()) else { return };
        if attendance.replies.len() < MOST_REPLIES {
            attendance.replies.push(said.clone());
        }
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
        self.foreign += foreign::questions(self.dialect, bytes, &self.ours);
        let Some((station, _)) = self.dialect.sender(bytes) else {
            self.record(Record { at, verdict: Verdict::Garbage, bytes: bytes.to_vec() });
            return self.suspect();
        };
        self.record(Record { at, verdict: Verdict::Stray { station }, bytes: bytes.to_vec() });
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

    fn record(&mut self, record: Record) {
        if self.records.len() < MOST_RECORDS {
            self.records.push(record);
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
mod tests;
