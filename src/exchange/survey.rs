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

mod attendance;
mod patience;
mod rounds;

use super::dialect::{Dialect, Question, Said};
use super::ear::{self, Ear, Ours, Piece};
use super::foreign;
use super::{Conversation, MOST_RECORDS, Record, Step, Verdict};
use crate::protocol::Protocol;
use crate::protocol::line::LineSetting;
use crate::tick::{Span, Tick};
pub use attendance::Attendance;
pub use patience::Patience;
use patience::{ADAPTER, PAUSE};
use rounds::Round;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// A line that is never silent for so long belongs to somebody else.
const BABBLE: Span = Span::from_secs(1);
/// Bytes that are kept of what is no telegram yet: more than any reply has.
const MOST_BYTES: usize = 128;
/// So many questions of somebody else are no accident of the line: there is another master.
const OTHER_MASTER: u32 = 3;
/// Replies that are kept of one station; more tell nothing new.
const MOST_REPLIES: usize = 64;

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
    ear: Ear,
    /// Our last telegrams, which may come back.
    ours: Ours,
    /// Who was asked last, and until when it is waited for.
    window: Option<(u8, Tick)>,
    /// The line is free for the next telegram from then on.
    ready_at: Tick,
    /// Since when the line is waited for.
    held: Option<Tick>,
    /// It ends then, whoever is still to be asked.
    ends_at: Option<Tick>,
    /// Since when somebody else of us has the line.
    away: Option<Tick>,
    /// It ended before everybody was asked.
    cut: bool,
    /// An exchange must be ended on the line, where the protocol wants that.
    farewell: bool,
    /// Who is being asked, until that is told.
    asking: Option<u8>,
    /// Signs of life that are to be told.
    signs: VecDeque<Sign>,
    noisy: bool,
    occupied: bool,
    /// Questions that were heard and are not ours.
    foreign: u32,
    /// Times that garbage came.
    garbage: u32,
    records: Vec<Record>,
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
            ear: Ear::default(),
            ours: Ours::default(),
            window: None,
            ready_at: now + dialect.silence(line),
            held: None,
            ends_at: patience.limit.map(|limit| now + limit),
            away: None,
            cut: false,
            farewell: false,
            asking: None,
            signs: VecDeque::new(),
            noisy: false,
            occupied: false,
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

    /// How often garbage came. At all: somebody is there.
    pub fn garbage(&self) -> u32 {
        self.garbage
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

    /// Whether its time was over before everybody was asked, and asked again who was garbled.
    pub fn is_cut(&self) -> bool {
        self.cut
    }

    /// Whether another master asks on this line.
    pub fn is_shared(&self) -> bool {
        self.foreign >= OTHER_MASTER
    }

    /// Questions of somebody else that were heard.
    pub fn foreign(&self) -> u32 {
        self.foreign
    }

    /// So many were heard before it.
    pub fn remembers(&mut self, foreign: u32) {
        self.foreign = foreign;
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
        if !self.ear.bytes().is_empty() {
            let over = self.ear.last() + self.straggle();
            if now < over && now.since(self.ear.began()) < BABBLE {
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
            self.away = Some(now);
            return Step::Done(News::Heard(sign));
        }
        if self.ends_at.is_some_and(|at| now >= at) {
            self.cut = !self.queue.is_empty() || self.suspicious().next().is_some();
            return self.end();
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
            Some(until) => Step::Wait(self.ends_at.map_or(until, |at| until.min(at))),
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
        self.ours.sends(now, bytes.clone());
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
        silent.map(|station| station.end + self.patience.tail).max()
    }

    /// Takes bytes that came in at `at`.
    pub fn feed(&mut self, at: Tick, bytes: &[u8]) {
        self.ready_at = self.ready_at.max(at + self.dialect.gap(self.line, PAUSE));
        // Some drivers leave the parity bit of 7-bit characters in place.
        let mask = if self.line.data_bits == 7 { 0x7F } else { 0xFF };
        let bytes: Vec<u8> = bytes.iter().map(|byte| byte & mask).collect();
        self.ear.hears(at, &bytes);
        // Before it is cut: a flood must not cost the time that tells it from silence.
        self.ear.keep(MOST_BYTES);
        loop {
            let (questions, stations) = (&self.questions, &self.stations);
            let asked = |station| questions.get(&station).filter(|_| stations.contains_key(&station));
            let Some((piece, bytes)) = self.ear.cut(self.dialect, &mut self.ours, asked) else { break };
            self.take(at, piece, bytes);
        }
    }

    /// Takes what went over the line while somebody else of us had it: what came and was not for him, and what he sent, which
    /// may come back late.
    pub fn overhear(&mut self, record: &Record) {
        match record.verdict {
            Verdict::Request | Verdict::Fence => self.ours.sends(record.at, record.bytes.clone()),
            Verdict::Stray { .. } | Verdict::Garbage => {
                self.feed(record.at, &record.bytes);
                if !self.ear.bytes().is_empty() {
                    self.reject(record.at);
                }
            }
            Verdict::Farewell | Verdict::Reply | Verdict::Echo | Verdict::Copy => {}
        }
    }

    /// Somebody else has had the line until now.
    pub fn resume(&mut self, now: Tick) {
        let away = self.away.take().map_or(Span::ZERO, |since| now.since(since));
        self.ends_at = self.ends_at.map(|at| at + away);
        self.ready_at = self.ready_at.max(now + self.dialect.gap(self.line, PAUSE));
    }

    /// It ends then at the latest, however long somebody else had the line.
    pub fn end_by(&mut self, at: Tick) {
        self.ends_at = Some(self.ends_at.map_or(at, |ends| ends.min(at)));
    }

    /// A station has answered.
    fn credit(&mut self, at: Tick, station: u8, said: Said) {
        if self.window.is_some_and(|(asked, _)| asked == station) {
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
        let bytes = self.ear.take();
        self.take(at, ear::kind(self.dialect, &bytes), bytes);
    }

    /// A piece of what came: a reply belongs to the station that it names, and garbage has its suspects.
    fn take(&mut self, at: Tick, piece: Piece, bytes: Vec<u8>) {
        if matches!(piece, Piece::Stray(..) | Piece::Garbage) {
            self.foreign += foreign::questions(self.dialect, &bytes, |piece| self.ours.hold(piece));
        }
        let is_awaited = |station| self.window.is_some_and(|(asked, _)| asked == station);
        let verdict = match piece {
            Piece::Echo => Verdict::Echo,
            Piece::Reply(station, _) if is_awaited(station) => Verdict::Reply,
            Piece::Reply(station, _) | Piece::Stray(station, _) => Verdict::Stray { station },
            Piece::Garbage => Verdict::Garbage,
        };
        self.record(Record { at, verdict, bytes });
        match piece {
            Piece::Echo => {}
            Piece::Reply(station, said) => self.credit(at, station, said),
            Piece::Stray(station, _) => self.meet(at, station),
            Piece::Garbage => self.suspect(),
        }
    }

    /// A station has sent a telegram that is no reply to what it was asked.
    fn meet(&mut self, at: Tick, station: u8) {
        let Some(known) = self.stations.get_mut(&station) else {
            self.strangers.insert(station);
            return self.suspect();
        };
        if !std::mem::replace(&mut known.heard, true) {
            self.signs.push_back(Sign { station, said: None, after: at.since(known.end) });
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
            return self.dialect.straggle(self.ear.bytes());
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
