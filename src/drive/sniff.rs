//! Listens on a line without ever sending: what comes is cut into telegrams, and they are told in words.

mod bus;
mod census;
mod filter;
mod search;
#[cfg(test)]
mod tests;

pub use filter::Filter;

use super::access::AccessError;
use super::decode::Reader;
use super::decode::dp::{self, Cyclic, EVERYBODY, NAME};
use super::scan::Unknown;
use super::session::Session;
use crate::exchange::Cutter;
use crate::failure::Failure;
use crate::outcome::{Event, Record, Sniff, SniffSummary, TelegramDoc};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use crate::transport::Wake;
use census::{Came, Census, Terms};
use search::{Sought, search};
use std::collections::VecDeque;
use std::iter::repeat_n;

/// How long to listen, to what, and what to keep.
#[derive(Clone, Debug, Default)]
pub struct Listening {
    /// End after this time.
    pub duration: Option<Span>,
    /// End when nothing came for so long.
    pub quiet: Option<Span>,
    /// End after so many telegrams that were told, disturbed ones among them.
    pub count: Option<u64>,
    /// Whether the telegrams are part of the result, beside the records on the way.
    pub keep: bool,
    /// What of the setting is not known: it is looked for first.
    pub unknown: Unknown,
    /// Tell what was counted so often.
    pub statistics: Option<Span>,
    /// Only what one of these lets through is told; everything if there are none.
    pub filters: Vec<Filter>,
    /// Nothing is told but what lies around a telegram that one of these lets through.
    pub triggers: Vec<Filter>,
    /// So long before it.
    pub pre: Span,
    /// And so long behind it.
    pub post: Span,
    /// End behind the first one.
    pub once: bool,
    /// PROFIBUS-DP is spoken, and what cyclic data are, if that is known.
    pub profibus: Option<Option<Cyclic>>,
}

/// Tells every telegram as a record until the time or the count is over, or somebody interrupts, which is the normal end; a failure only
/// if the port is lost, or if a CAN bus was silent. Never sends.
pub async fn sniff(session: &mut Session<'_>, reader: &Reader<'_>, plan: Listening) -> (Sniff, Option<Failure>) {
    let begin = session.now();
    let mut reader = *reader;
    let until = plan.duration.map(|span| begin + span);
    let sought = match plan.unknown.any() {
        true => Some(search(session, &mut reader, plan.unknown, until).await),
        false => None,
    };
    let (mut ear, mut log) = (Ear::of(session, reader, plan.profibus), Log::new(plan));
    let (because, error) = match &sought {
        Some(Sought { found: false, because, .. }) => (*because, None),
        _ => listen(session, &mut ear, &mut log, begin).await,
    };
    let (search, cut) = sought.map_or((None, None), |sought| (Some(sought.told()), sought.cut));
    // What was begun is told as it is.
    log.tell(session, ear.silence());
    // Where nothing was heard, the same flags tell why; reading clears them.
    let has_heard = ear.census.count(session.now()).heard > 0;
    let is_overrun = session.line().is_can() && has_heard && error.is_none() && session.was_overrun().await;
    let summary = SniffSummary { search, ..summary(session, &ear, because, is_overrun) };
    let mut failure = error.or(cut).map(|error| error.failure(0, None));
    if failure.is_none() && summary.count.heard == 0 {
        failure = bus::unheard(session).await;
    }
    (Sniff { summary, telegrams: log.kept }, failure)
}

/// Until it is over; why.
async fn listen(
    session: &mut Session<'_>,
    ear: &mut Ear<'_>,
    log: &mut Log,
    begin: Tick,
) -> (&'static str, Option<AccessError>) {
    let mut last = session.now();
    let mut told = last;
    loop {
        let plan = &log.plan;
        let ends = [
            (plan.duration.map(|span| begin + span), Some("duration")),
            (plan.quiet.map(|span| last + span), Some("quiet")),
            (log.until.filter(|_| plan.once), Some("trigger")),
            (plan.statistics.map(|span| told + span), None),
            (ear.ends(last), None),
        ];
        let next = ends.into_iter().filter_map(|(at, because)| Some((at?, because))).min_by_key(|(at, _)| *at);
        let (until, because) = next.unwrap_or((session.now() + Span::from_secs(1), None));
        let heard = session.hear(until).await;
        let now = session.now();
        let telegrams = match heard {
            Ok(Wake::Bytes(bytes)) => {
                last = now;
                match session.heard_frames() {
                    Some(frames) => ear.frames(last, &frames, session.damaged_words()),
                    None => ear.feed(last, &bytes),
                }
            }
            Ok(Wake::Silence) if because.is_some() => return (because.unwrap_or_default(), None),
            Ok(Wake::Silence) if ear.ends(last).is_some_and(|at| now >= at) => ear.silence(),
            Ok(Wake::Silence) => Vec::new(),
            Err(AccessError::Interrupted) => return ("interrupted", None),
            Err(error) => return ("lost", Some(error)),
        };
        if log.tell(session, telegrams) {
            return ("count", None);
        }
        if log.plan.statistics.is_some_and(|span| now >= told + span) {
            told = now;
            session.tell(Event::Record(Box::new(Record::Statistics(ear.census.count(now)))));
        }
        // Bytes that come all the time do not prolong it.
        let is_over = |at: Option<Tick>| at.is_some_and(|at| now >= at);
        if is_over(log.plan.duration.map(|span| begin + span)) {
            return ("duration", None);
        }
        if log.plan.once && is_over(log.until) {
            return ("trigger", None);
        }
    }
}

fn summary(session: &Session<'_>, ear: &Ear<'_>, because: &'static str, is_overrun: bool) -> SniffSummary {
    SniffSummary {
        because,
        port: session.port().to_owned(),
        line: session.line().to_string(),
        protocol: ear.speaks,
        search: None,
        count: ear.census.count(session.now()),
        unseen: if session.line().is_can() { bus::unseen(session.frames_lost(), is_overrun) } else { unseen() },
    }
}

/// Everybody, but on PROFIBUS; nobody answers.
const BROADCAST: u8 = 0;

/// What a census must know of the line.
fn terms(session: &Session<'_>, is_profibus: bool) -> Terms {
    let line = session.line();
    if line.is_can() {
        return bus::terms(session.limits().reply_timeout);
    }
    // Only in RTU silences part the telegrams.
    let pause = (session.protocol().name() == "rtu" && !is_profibus).then(|| line.t35());
    let everybody = if is_profibus { EVERYBODY } else { BROADCAST };
    Terms { thousand: line.chars(1_000), pause, patience: session.limits().reply_timeout, everybody }
}

/// What a serial adapter does not tell.
fn unseen() -> Text {
    both!(
        "a serial adapter tells characters, no levels and no reflections: what a cable without termination or bias does to the \
         edges takes an oscilloscope; pauses and times are those of its driver",
        "ein serieller Adapter zeigt Zeichen, keine Pegel und keine Reflexionen: was eine Leitung ohne Abschluss oder Ruhepegel mit \
         den Flanken macht, zeigt ein Oszilloskop; Pausen und Zeiten sind die seines Treibers"
    )
}

/// What was told so far.
struct Log {
    plan: Listening,
    told: u64,
    kept: Vec<TelegramDoc>,
    /// What came last and may have to be told, while something is waited for.
    past: VecDeque<TelegramDoc>,
    /// Until then everything is told.
    until: Option<Tick>,
}

impl Log {
    fn new(plan: Listening) -> Self {
        Log { plan, told: 0, kept: Vec::new(), past: VecDeque::new(), until: None }
    }

    /// Tells telegrams up to the count; `true` if that is reached.
    fn tell(&mut self, session: &mut Session<'_>, telegrams: Vec<TelegramDoc>) -> bool {
        for telegram in telegrams {
            for telegram in self.wanted(telegram) {
                if self.is_full() {
                    break;
                }
                self.told += 1;
                if self.plan.keep {
                    self.kept.push(telegram.clone());
                }
                session.tell(Event::Record(Box::new(Record::Telegram(telegram))));
            }
        }
        self.is_full()
    }

    /// What is to be told now that this came.
    fn wanted(&mut self, telegram: TelegramDoc) -> Vec<TelegramDoc> {
        let Listening { filters, triggers, pre, post, once, .. } = &self.plan;
        let at = Tick::from_micros(telegram.at_us.unwrap_or(0));
        let lets = |filters: &[Filter]| filters.iter().any(|filter| filter.lets(&telegram));
        let is_old = |past: &TelegramDoc| past.at_us.is_some_and(|then| at.since(Tick::from_micros(then)) > *pre);
        while self.past.front().is_some_and(is_old) {
            self.past.pop_front();
        }
        let mut wanted = Vec::new();
        if lets(triggers) && !(*once && self.until.is_some()) {
            wanted.extend(self.past.drain(..));
            self.until = Some(at + *post);
        }
        if !filters.is_empty() && !lets(filters) {
            return wanted;
        }
        if triggers.is_empty() || self.until.is_some_and(|until| at <= until) {
            wanted.push(telegram);
            return wanted;
        }
        self.past.push_back(telegram);
        wanted
    }

    fn is_full(&self) -> bool {
        self.plan.count.is_some_and(|count| self.told >= count)
    }
}

/// What was asked, and when it was said.
struct Asked {
    at: Tick,
    address: Option<u8>,
    function: Option<u8>,
    hex: String,
}

impl Asked {
    /// Whether a telegram whose bytes tell no direction can answer it: to a write of one register the answer is the same (V1.1b3 6.5,
    /// 6.6).
    fn can_be_answered_by(&self, doc: &TelegramDoc) -> bool {
        let is_echo = matches!(doc.function, Some(5 | 6));
        (self.address, self.function) == (doc.address, doc.function) && (!is_echo || self.hex == doc.hex)
    }
}

/// Turns bytes and silence into telegrams in words.
struct Ear<'r> {
    reader: Reader<'r>,
    /// In its place, where PROFIBUS-DP is spoken.
    profibus: Option<dp::Reader<'r>>,
    /// The word of what is spoken.
    speaks: &'static str,
    cutter: Cutter,
    /// When each of the bytes came that belong to no telegram yet.
    arrivals: VecDeque<Tick>,
    /// How long a reply may take.
    patience: Span,
    /// What was asked last.
    asked: Option<Asked>,
    /// Something was heard before.
    is_in: bool,
    census: Census,
    /// What the clock of the line must be put forward by, to be that of the day.
    since_1970: Option<Span>,
    /// Bits per second, for what a frame takes of a CAN bus.
    bit_rate: u32,
}

impl<'r> Ear<'r> {
    /// On the line of a session.
    fn of(session: &Session<'_>, reader: Reader<'r>, profibus: Option<Option<Cyclic>>) -> Self {
        let profibus = profibus.map(|cyclic| dp::Reader { family: reader.family, cyclic });
        let cutter = profibus.map_or_else(|| Cutter::new(reader.protocol, session.line()), |_| Cutter::dp());
        let census = Census::new(terms(session, profibus.is_some()), session.now());
        let speaks = if profibus.is_some() { NAME } else { session.protocol().name() };
        let since_1970 = session
            .since_1970()
            .map(|span| Span::from_micros(span.as_micros().saturating_sub(session.now().as_micros())));
        let bit_rate = session.line().baud;
        Ear {
            profibus,
            speaks,
            since_1970,
            bit_rate,
            ..Ear::new(reader, cutter, session.limits().reply_timeout, census)
        }
    }

    fn new(reader: Reader<'r>, cutter: Cutter, patience: Span, census: Census) -> Self {
        let (arrivals, asked) = (VecDeque::new(), None);
        let (profibus, speaks) = (None, reader.protocol.name());
        let (is_in, since_1970, bit_rate) = (false, None, 0);
        Ear { reader, profibus, speaks, cutter, arrivals, patience, asked, is_in, census, since_1970, bit_rate }
    }

    /// When what is open will stay so, if the last byte came at `last`.
    fn ends(&self, last: Tick) -> Option<Tick> {
        (!self.arrivals.is_empty()).then(|| last + self.cutter.pause())
    }

    fn feed(&mut self, at: Tick, bytes: &[u8]) -> Vec<TelegramDoc> {
        self.arrivals.extend(repeat_n(at, bytes.len()));
        let pieces = self.cutter.feed(bytes);
        self.told(pieces)
    }

    fn silence(&mut self) -> Vec<TelegramDoc> {
        let pieces = self.cutter.silence();
        self.told(pieces)
    }

    fn told(&mut self, pieces: Vec<Vec<u8>>) -> Vec<TelegramDoc> {
        pieces.iter().map(|bytes| self.telegram(bytes)).collect()
    }

    fn telegram(&mut self, bytes: &[u8]) -> TelegramDoc {
        let came: Vec<Tick> = self.arrivals.drain(..bytes.len().min(self.arrivals.len())).collect();
        let at = came.first().copied().unwrap_or_default();
        let mut doc = match &self.profibus {
            Some(reader) => reader.telegram(bytes),
            None => self.reader.telegram(bytes, None),
        };
        // A short acknowledgement names nobody: it is of whoever was asked.
        if doc.check_ok && doc.address.is_none() && doc.direction == Some("reply") {
            doc.address = self.asked.as_ref().and_then(|asked| asked.address);
        }
        let alike = doc.direction.is_none();
        // Where request and reply look alike, the first is the request; but of the very first nobody knows.
        if doc.check_ok && alike && self.is_in && self.profibus.is_none() {
            let asked = self.asked.as_ref().filter(|asked| asked.can_be_answered_by(&doc));
            let is_same = asked.is_some_and(|asked| asked.hex == doc.hex);
            let in_time = self.census.in_time(doc.address.unwrap_or_default());
            match asked.map(|asked| at.since(asked.at)).filter(|since| *since <= self.patience) {
                // Behind the time that a reply takes a master may as well have asked the same again, and nothing tells which.
                Some(since) if is_same && since > in_time => {}
                reply => doc = self.reader.telegram(bytes, Some(reply.is_none())),
            }
        }
        doc.at_us = Some(at.as_micros());
        doc.since_1970_us = self.since_1970.map(|span| span.as_micros() + at.as_micros());
        let piece = came.iter().filter(|then| **then == at).count() as u64;
        let last = came.last().copied().unwrap_or(at);
        self.census.note(&doc, Came { first: at, piece, last, bytes: bytes.len() as u64, alike, lane: 0 });
        self.is_in = true;
        let (address, function) = (doc.address, doc.function);
        let asked = Asked { at: last, address, function, hex: doc.hex.clone() };
        self.asked = (doc.check_ok && doc.direction != Some("reply")).then_some(asked);
        doc
    }
}
