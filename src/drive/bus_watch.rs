//! Listens on a CAN bus without ever sending: what comes, how often, what is missing, who is in fault.

use super::access::AccessError;
use super::can::trouble;
use super::decode::Reader;
use super::session::Session;
use crate::failure::Failure;
use crate::outcome::{BusMonitor, Decimal, Event, HeardEmergency, HeardOnBus, HeardPlace, Record, TelegramDoc};
use crate::protocol::can::emergency::Emergency;
use crate::protocol::can::{Frame, Identifier, Service, duration};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::collections::BTreeMap;

/// A PDO that a plan has sent.
#[derive(Clone, Debug)]
pub struct Awaited {
    /// Its identifier.
    pub identifier: u16,
    /// Who sends it.
    pub name: Text,
    /// How often, if somebody says.
    pub every_ms: Option<u32>,
    /// When it is missing.
    pub patience: Option<Span>,
}

/// How long to listen, and what to make of it.
pub struct BusWatch<'w> {
    /// End after this time.
    pub duration: Option<Span>,
    /// End when nothing came for so long.
    pub quiet: Option<Span>,
    /// Every frame is a record; else only what is new: the first under an identifier, network, boot-ups, emergencies.
    pub tells_all: bool,
    /// PDOs of a plan.
    pub awaited: Vec<Awaited>,
    /// What bytes carry under an identifier, by the plan.
    pub carried: &'w dyn Fn(u16, &[u8]) -> Vec<HeardPlace>,
}

impl std::fmt::Debug for BusWatch<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("BusWatch")
            .field("duration", &self.duration)
            .field("awaited", &self.awaited)
            .finish_non_exhaustive()
    }
}

/// Tells what comes until the time is over, or somebody interrupts, which is the normal end. A failure if nothing came, or the port was lost.
pub async fn watch_bus(
    session: &mut Session<'_>,
    reader: &Reader<'_>,
    watch: &BusWatch<'_>,
) -> (BusMonitor, Option<Failure>) {
    let begun = session.now();
    let mut census = Census::new(watch, session.line().baud, begun);
    let (because, error) = listen(session, reader, watch, &mut census).await;
    let mut failure = error.map(|error| error.failure(0, None));
    if census.frames == 0 && failure.is_none() {
        let flags = session.bus_errors().await.ok().flatten();
        failure = Some(trouble::unheard(session.port(), session.line().baud, flags));
    }
    census.lost = session.frames_lost();
    if failure.is_none() && session.was_overrun().await {
        session.tell(Event::Note(overrun()));
    }
    (census.told(session.port(), session.now(), because), failure)
}

/// The adapter lost frames itself, and does not tell how many.
fn overrun() -> Text {
    both!(
        "the adapter tells that it lost frames (overrun): not all that was on the bus is here",
        "der Adapter meldet, dass er Frames verloren hat (Überlauf): hier steht nicht alles, was auf dem Bus war"
    )
}

async fn listen(
    session: &mut Session<'_>,
    reader: &Reader<'_>,
    watch: &BusWatch<'_>,
    census: &mut Census<'_>,
) -> (&'static str, Option<AccessError>) {
    let mut last = census.begun;
    loop {
        let ends = [
            (watch.duration.map(|span| census.begun + span), "duration"),
            (watch.quiet.map(|span| last + span), "quiet"),
        ];
        let ends = ends.into_iter().filter_map(|(at, because)| Some((at?, because))).min_by_key(|end| end.0);
        if let Some((_, because)) = ends.filter(|end| session.now() >= end.0) {
            return (because, None);
        }
        let ends = ends.map_or(session.now() + Span::from_secs(1), |end| end.0);
        let until = census.next_missed().map_or(ends, |missed| missed.min(ends));
        let frames = match session.frames(until).await {
            Ok(frames) => frames,
            Err(AccessError::Interrupted) => return ("interrupted", None),
            Err(error) => return ("lost", Some(error)),
        };
        let now = session.now();
        for frame in frames {
            last = now;
            let (doc, is_new) = census.hears(now, &frame, reader);
            if is_new || watch.tells_all {
                session.tell(Event::Record(Box::new(Record::Telegram(doc))));
            }
        }
        for note in census.look(now) {
            session.tell(Event::Note(note));
        }
    }
}

/// What was heard under an identifier.
#[derive(Clone, Debug, Default)]
struct Heard {
    name: Text,
    frames: u64,
    first: Tick,
    last: Tick,
    longest: Span,
    planned_ms: Option<u32>,
    patience: Option<Span>,
    missing: bool,
    bytes: Vec<u8>,
    hex: Option<String>,
}

/// Frames that are all the same, one behind the other.
#[derive(Clone, Copy, Debug)]
struct Run {
    frame: Frame,
    since: Tick,
    last: Tick,
    frames: u64,
}

/// Behind so many of them without a pause nobody acknowledges them (ISO 11898-1: a frame is sent until somebody does).
const UNACKNOWLEDGED: u64 = 200;
/// What comes again within this time is no news.
const AGAIN: Span = Span::from_millis(100);

struct Census<'w> {
    watch: &'w BusWatch<'w>,
    bit_rate: u32,
    begun: Tick,
    frames: u64,
    lost: u64,
    busy: Span,
    heard: BTreeMap<Identifier, Heard>,
    emergencies: Vec<HeardEmergency>,
    /// What is to be said of PDOs that came again.
    back: Vec<Text>,
    run: Option<Run>,
}

impl<'w> Census<'w> {
    fn new(watch: &'w BusWatch<'w>, bit_rate: u32, begun: Tick) -> Self {
        let row = |one: &Awaited| {
            let heard = Heard {
                name: one.name.clone(),
                last: begun,
                planned_ms: one.every_ms,
                patience: one.patience,
                ..Heard::default()
            };
            (Identifier::Standard(one.identifier), heard)
        };
        let heard = watch.awaited.iter().map(row).collect();
        let (frames, lost, busy) = (0, 0, Span::ZERO);
        let (emergencies, back, run) = (Vec::new(), Vec::new(), None);
        Census { watch, bit_rate, begun, frames, lost, busy, heard, emergencies, back, run }
    }

    /// Whether the frame before was the same, a moment ago.
    fn comes_again(&mut self, now: Tick, frame: &Frame) -> bool {
        let Some(run) = self.run.as_mut().filter(|run| run.frame == *frame && now < run.last + AGAIN) else {
            self.run = Some(Run { frame: *frame, since: now, last: now, frames: 1 });
            return false;
        };
        (run.last, run.frames) = (now, run.frames + 1);
        let busy = duration(self.bit_rate, frame.bytes().len() as u64).times(2 * UNACKNOWLEDGED);
        if run.frames == UNACKNOWLEDGED && now < run.since + busy {
            self.back.push(alone(frame));
        }
        true
    }

    /// Counts a frame; what it says, and whether that is news.
    fn hears(&mut self, now: Tick, frame: &Frame, reader: &Reader<'_>) -> (TelegramDoc, bool) {
        let mut doc = reader.frame(frame);
        doc.at_us = Some(now.as_micros());
        self.frames += 1;
        self.busy = self.busy + duration(self.bit_rate, frame.bytes().len() as u64);
        let comes_again = self.comes_again(now, frame);
        let planned = self.heard.get(&frame.identifier).is_some_and(|heard| heard.planned_ms.is_some());
        let heard = self.heard.entry(frame.identifier).or_default();
        let is_first = heard.frames == 0;
        if is_first {
            heard.first = now;
            if heard.name == Text::default() {
                heard.name = name(frame.identifier);
            }
        } else {
            heard.longest = heard.longest.longer(now.since(heard.last));
        }
        heard.frames += 1;
        if heard.missing {
            let (number, name) = (frame.identifier.number(), &heard.name);
            self.back.push(both!("{number} {name} comes", "{number} {name} kommt", name));
        }
        (heard.last, heard.bytes, heard.missing) = (now, frame.bytes().to_vec(), false);
        heard.hex = Some(crate::protocol::Hex(frame.bytes()).to_string());
        if let Identifier::Standard(identifier) = frame.identifier {
            let places = (self.watch.carried)(identifier, frame.bytes());
            if planned || !places.is_empty() {
                doc.meaning = carrying(&heard.name, &places);
            }
        }
        let service = match frame.identifier {
            Identifier::Standard(number) => Service::of(number),
            Identifier::Extended(_) => Service::Free,
        };
        if let Service::Emergency(node) = service
            && !comes_again
        {
            self.emergency(now, node, frame.bytes(), &doc);
        }
        let is_news = matches!(service, Service::Nmt | Service::Emergency(_) | Service::BootUp(_));
        (doc, is_first || is_news && !comes_again)
    }

    fn emergency(&mut self, now: Tick, node: u8, bytes: &[u8], doc: &TelegramDoc) {
        let Some(told) = Emergency::decode(bytes) else { return };
        let t = self.t(now);
        if told == Emergency::CLEARED {
            let open = self.emergencies.iter_mut().filter(|one| one.node == node && one.cleared.is_none());
            return open.for_each(|one| one.cleared = Some(t));
        }
        self.emergencies.push(HeardEmergency {
            node,
            fault: told.fault,
            meaning: doc.meaning.clone(),
            t,
            cleared: None,
        });
    }

    fn t(&self, now: Tick) -> Decimal {
        Decimal { raw: i64::try_from(now.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
    }

    /// When the next PDO will be missing.
    fn next_missed(&self) -> Option<Tick> {
        let waiting = self.heard.values().filter(|heard| !heard.missing);
        waiting.filter_map(|heard| Some(heard.last + heard.patience?)).min()
    }

    /// What is missing now and was not before.
    fn look(&mut self, now: Tick) -> Vec<Text> {
        let mut notes = std::mem::take(&mut self.back);
        for (identifier, heard) in &mut self.heard {
            if !heard.missing && heard.patience.is_some_and(|patience| now >= heard.last + patience) {
                heard.missing = true;
                let (number, name) = (identifier.number(), &heard.name);
                notes.push(both!("{number} {name} is missing", "{number} {name} fehlt", name));
            }
        }
        notes
    }

    fn told(self, port: &str, now: Tick, because: &'static str) -> BusMonitor {
        let listened = now.since(self.begun);
        let tenths = |span: Span| Decimal { raw: (span.as_micros() / 100) as i64, decimals: 1 };
        let t = self.t(self.begun + listened);
        let load = self.busy.as_micros() * 1_000 / listened.as_micros().max(1);
        let row = |(identifier, heard): (&Identifier, &Heard)| {
            let between = heard.frames.checked_sub(1).filter(|gaps| *gaps > 0);
            let mean = |gaps: u64| tenths(Span::from_micros(heard.last.since(heard.first).as_micros() / gaps));
            let places = match identifier {
                Identifier::Standard(number) => (self.watch.carried)(*number, &heard.bytes),
                Identifier::Extended(_) => Vec::new(),
            };
            HeardOnBus {
                identifier: identifier.number(),
                name: heard.name.clone(),
                frames: heard.frames,
                every_ms: between.map(mean),
                longest_ms: between.map(|_| tenths(heard.longest)),
                planned_ms: heard.planned_ms,
                missing: heard.missing,
                hex: heard.hex.clone(),
                places,
            }
        };
        BusMonitor {
            port: port.to_owned(),
            bit_rate: self.bit_rate,
            because,
            t,
            frames: self.frames,
            lost: self.lost,
            load_percent: Decimal { raw: load as i64, decimals: 1 },
            heard: self.heard.iter().map(row).collect(),
            emergencies: self.emergencies,
        }
    }
}

/// What an identifier is for.
fn name(identifier: Identifier) -> Text {
    let Identifier::Standard(number) = identifier else {
        return both!("29-bit identifier", "29-Bit-Identifier");
    };
    let node = |what: &str, node: u8| both!("{what}, node {node}", "{what}, Knoten {node}");
    match Service::of(number) {
        Service::Nmt => Text::name("NMT"),
        Service::Sync => Text::name("SYNC"),
        Service::Time => both!("time of day", "Uhrzeit"),
        Service::Emergency(of) => node("Emergency", of),
        Service::TxPdo(pdo, of) => node(&format!("TxPDO{}", pdo.number()), of),
        Service::RxPdo(pdo, of) => node(&format!("RxPDO{}", pdo.number()), of),
        Service::FourthPdo { sent, node: of } => node(if sent { "TxPDO4" } else { "RxPDO4" }, of),
        Service::SdoReply(channel, of) => {
            both!("SDO{c} reply, node {of}", "SDO{c}-Antwort, Knoten {of}", c = channel.number())
        }
        Service::SdoRequest(channel, of) => {
            both!("SDO{c} request, node {of}", "SDO{c}-Frage, Knoten {of}", c = channel.number())
        }
        Service::BootUp(of) => node("Boot-Up", of),
        Service::Free => both!("no service", "kein Dienst"),
    }
}

/// A PDO in words.
fn carrying(name: &Text, places: &[HeardPlace]) -> Text {
    let one = |place: &HeardPlace| {
        let source = place.source.map_or_else(String::new, |source| format!(" ({source})"));
        format!("{}{source} = {}", place.place, place.raw)
    };
    let places = places.iter().map(one).collect::<Vec<_>>().join(", ");
    let between = if places.is_empty() { "" } else { ": " };
    both!("{name}{between}{places}", "{name}{between}{places}", name)
}

/// That a frame is said again and again.
fn alone(frame: &Frame) -> Text {
    let number = frame.identifier.number();
    both!(
        "{number} is said again and again, because nobody acknowledges it: its sender is alone, and who only listens acknowledges nothing; a \
         second node on the bus ends it, and so does a question, such as `antrieb scan`",
        "{number} wird immer wieder gesagt, weil niemand bestätigt: wer da sendet, ist allein, und wer nur zuhört, bestätigt nichts; ein \
         zweiter Knoten am Bus beendet das, und eine Frage auch, etwa `antrieb scan`"
    )
}
