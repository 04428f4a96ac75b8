//! Watching parameters of one or several drives until somebody ends it. Never writes.
//!
//! A round asks every drive for every parameter. What a drive does not answer is a gap in its sample, and the round
//! goes on with the next drive. What is sampled goes out as records at once; only the first round is held back until
//! it is known what there is to watch.

mod item;
mod moment;
mod station;
mod trigger;
mod trip;

pub use item::Item;
pub use trigger::{Compare, Condition, Signal, Test};

use super::{AccessError, Session, Terms, is_over, summary};
use crate::exchange::Tally;
use crate::failure::{Class, Failure};
use crate::outcome::{
    Column, Data, Decimal, ErrorDoc, Event, LineNews, Monitor, Outcome, PortChange, Record, SCHEMA_VERSION, Sample,
    SampleValue, StreamStart, Value, Warning, WatchedDrive,
};
use crate::profile::Family;
use crate::text::both;
use crate::tick::{Span, Tick};
use station::Station;

/// How often, and until when.
#[derive(Clone, Copy, Debug)]
pub struct Rounds {
    /// From round to round; zero is as fast as the line allows.
    pub interval: Span,
    /// It ends after this time.
    pub duration: Option<Span>,
    /// It ends after so many rounds.
    pub count: Option<u64>,
    /// A lost port is waited for.
    pub reconnect: bool,
    /// What lies around a trigger.
    pub window: Window,
}

/// What lies around a trigger.
#[derive(Clone, Copy, Debug)]
pub struct Window {
    /// So long before it.
    pub pre: Span,
    /// So long behind it.
    pub post: Span,
    /// The first one ends the watch, so long after it.
    pub once: bool,
}

/// What is watched in a drive, and what is waited for in it.
#[derive(Clone, Debug, Default)]
pub struct Chosen {
    /// What is read, in this order.
    pub items: Vec<Item>,
    /// The triggers.
    pub waited_for: Vec<Condition>,
}

/// What is watched in a drive of a family.
pub type Select<'a> = dyn Fn(&Family) -> Result<Chosen, Failure> + 'a;

/// Watches until the count or the time is over, the port is lost, or somebody ends it. `chosen` is watched in a drive until
/// it is recognised, what `select` says of its family from then on.
pub async fn watch(
    session: &mut Session<'_>,
    terms: &Terms<'_>,
    rounds: Rounds,
    addresses: &[u8],
    chosen: &Chosen,
    select: &Select<'_>,
) -> Outcome {
    let items = &chosen.items;
    let mut stations: Vec<_> = addresses.iter().map(|&address| Station::new(address, items.clone())).collect();
    let mut watch = Watch {
        terms,
        select,
        rounds,
        begin: session.now(),
        held: Some(Vec::new()),
        triggers: chosen.waited_for.iter().map(|condition| condition.text.clone()).collect(),
        end: rounds.duration.map(|duration| (session.now() + duration, "duration")),
        tally: Monitor { because: "interrupted", t: decimal(Span::ZERO), rounds: 0, samples: 0, gaps: 0, triggers: 0 },
        warnings: Vec::new(),
        lost: None,
    };
    watch.tally.because = watch.run(session, &mut stations).await;
    watch.start(session, &stations);
    watch.tally.t = watch.seconds(session.now());
    watch.outcome(stations)
}

/// How often a lost port is tried.
const TRY_AGAIN: Span = Span::from_millis(500);

/// A watch at work.
struct Watch<'a> {
    terms: &'a Terms<'a>,
    select: &'a Select<'a>,
    rounds: Rounds,
    begin: Tick,
    /// Records of the first round, until the stream is started.
    held: Option<Vec<Record>>,
    /// The triggers, as they were typed.
    triggers: Vec<String>,
    /// When it ends, and why then.
    end: Option<(Tick, &'static str)>,
    tally: Monitor,
    warnings: Vec<Warning>,
    /// The port is lost.
    lost: Option<Failure>,
}

impl Watch<'_> {
    /// Goes round until it is over; returns why it is.
    async fn run(&mut self, session: &mut Session<'_>, stations: &mut [Station]) -> &'static str {
        loop {
            let slot = session.now();
            let result = match self.lost.clone() {
                Some(failure) => {
                    self.blank(session, stations, &failure);
                    Ok(())
                }
                None => self.round(session, stations).await,
            };
            if let Err(failure) = result
                && let Some(because) = self.trouble(session, failure, self.rounds.reconnect)
            {
                return because;
            }
            self.start(session, stations);
            self.tally.rounds += 1;
            if self.rounds.count.is_some_and(|count| self.tally.rounds >= count) {
                return "count";
            }
            if stations.iter().all(|station| station.out.is_some()) {
                return "no_drive";
            }
            let next = self.next_slot(slot, session.now());
            let until = self.end.map_or(next, |(end, _)| end.min(next));
            while session.now() < until {
                let result = match self.lost {
                    Some(_) => self.seek_port(session, until).await,
                    None => session.rest(until.since(session.now())).await.map_err(|error| self.told(&error)),
                };
                if let Err(failure) = result
                    && let Some(because) = self.trouble(session, failure, self.rounds.reconnect)
                {
                    return because;
                }
            }
            if let Some((_, because)) = self.end.filter(|(end, _)| session.now() >= *end) {
                return because;
            }
        }
    }

    /// The next point of the grid of rounds that is still ahead.
    fn next_slot(&self, slot: Tick, now: Tick) -> Tick {
        if self.rounds.interval == Span::ZERO {
            // Without a port there is nothing that would hold up the next round.
            return if self.lost.is_some() { now + TRY_AGAIN } else { now };
        }
        let step = self.rounds.interval.as_micros();
        let (done, gone) = (slot.since(self.begin).as_micros() / step, now.since(self.begin).as_micros() / step);
        self.begin + self.rounds.interval.times(gone.max(done) + 1)
    }

    /// One sample of every drive. Ends early only if the session is over.
    async fn round(&mut self, session: &mut Session<'_>, stations: &mut [Station]) -> Result<(), Failure> {
        for index in 0..stations.len() {
            let Some((_, rest)) = stations.split_at_mut_checked(index) else { break };
            let Some(station) = rest.first_mut() else { break };
            match self.sample(session, station).await {
                Ok(sample) => {
                    self.mark_moments(session, station, &sample);
                    self.emit_sample(session, sample);
                }
                Err(failure) => {
                    if failure.class == Class::Port {
                        self.blank(session, rest, &failure);
                    }
                    return Err(failure);
                }
            }
        }
        Ok(())
    }

    /// A gap for each of these drives.
    fn blank(&mut self, session: &mut Session<'_>, stations: &[Station], failure: &Failure) {
        for station in stations {
            let sample = self.gap(session.now(), station, failure);
            self.emit_sample(session, sample);
        }
    }

    /// The sample of a drive that cannot be read now.
    fn gap(&self, now: Tick, station: &Station, failure: &Failure) -> Sample {
        let t = self.seconds(now);
        let family = station.target.as_ref().map(|target| target.family.clone());
        let drive = family.as_ref().map_or_else(|| "unknown".to_owned(), |family| family.drive.clone());
        let values = family.or_else(|| self.terms.usual()).map(|family| {
            let rows = station.items.iter().flat_map(|item| item.unread(station.address, &family, failure));
            rows.map(|value| SampleValue { t, value: Value { drive: drive.clone(), ..value } }).collect()
        });
        Sample {
            t,
            n: self.tally.rounds,
            address: station.address,
            values: values.unwrap_or_default(),
            drive,
            state: None,
            error: Some(ErrorDoc::from(failure)),
            line: None,
        }
    }

    /// Asks one drive; what it does not answer is a gap.
    async fn sample(&mut self, session: &mut Session<'_>, station: &mut Station) -> Result<Sample, Failure> {
        let now = session.now();
        if let Some(failure) = &station.out {
            return Ok(self.gap(now, station, failure));
        }
        // A drive that was silent is asked once, so that it does not hold up the others.
        let retries = session.set_retries(0);
        if station.silent.is_none() {
            session.set_retries(retries);
        }
        let haul = station.read(session, self).await;
        session.set_retries(retries);
        let haul = match haul {
            Ok(haul) => haul,
            Err(failure) if is_over(&failure) => return Err(failure),
            Err(failure) => {
                if !matches!(failure.class, Class::Silence | Class::Garbled) {
                    station.out = Some(failure.clone());
                }
                station.failure.get_or_insert(failure.clone());
                self.mark(session, station, Some(&failure), now);
                return Ok(self.gap(now, station, &failure));
            }
        };
        for warning in haul.warnings {
            if !self.warnings.contains(&warning) {
                self.warnings.push(warning);
            }
        }
        let good = haul.values.iter().filter(|value| value.value.error.is_none()).count() as u64;
        station.good += good;
        let failure = haul.failure.filter(|_| good == 0);
        if let Some(failure) = &failure {
            station.failure.get_or_insert(failure.clone());
        }
        self.mark(session, station, failure.as_ref(), now);
        Ok(Sample {
            t: self.seconds(now),
            n: self.tally.rounds,
            address: station.address,
            drive: station.target.as_ref().map_or_else(String::new, |target| target.family.drive.clone()),
            state: haul.values.iter().find_map(|value| value.value.word.as_ref()?.state.clone()),
            values: haul.values,
            error: failure.as_ref().map(ErrorDoc::from),
            line: None,
        })
    }

    /// Says once that a drive went silent, and once that it is back.
    fn mark(&self, session: &mut Session<'_>, station: &mut Station, failure: Option<&Failure>, now: Tick) {
        let note = match (failure, station.silent) {
            (Some(failure), None) => {
                station.silent = Some(now);
                both!("{why} (going on)", "{why} (es geht weiter)", why = failure.message)
            }
            (None, Some(since)) => {
                station.silent = None;
                let (address, gap) = (station.address, now.since(since));
                both!("address {address} answers again after {gap}", "Adresse {address} antwortet wieder nach {gap}")
            }
            _ => return,
        };
        session.tell(Event::Note(note));
    }

    /// What to do when the session is over: end with this reason, or go on without a port.
    fn trouble(&mut self, session: &mut Session<'_>, failure: Failure, reconnect: bool) -> Option<&'static str> {
        if failure.class != Class::Port {
            return Some("interrupted");
        }
        if self.lost.is_none() {
            let change = self.port_change(session, Some(&failure));
            self.emit(session, Record::Lost(change));
            if reconnect {
                let text = both!("{why}; waiting for it", "{why}; es wird darauf gewartet", why = failure.message);
                session.tell(Event::Note(text));
            }
        }
        self.lost = Some(failure);
        (!reconnect).then_some("lost")
    }

    /// Tries to open a lost port, and waits a little if that does not work.
    async fn seek_port(&mut self, session: &mut Session<'_>, until: Tick) -> Result<(), Failure> {
        let reopened = session.reopen().await.map_err(|error| self.told(&error));
        if reopened.is_ok() {
            self.lost = None;
            let change = self.port_change(session, None);
            let text = both!("{port}: the port is back", "{port}: der Anschluss ist wieder da", port = change.port);
            session.tell(Event::Note(text));
            self.emit(session, Record::Reopened(change));
            return Ok(());
        }
        // Another adapter under the old name is told once, and left alone.
        if let Err(failure) = reopened
            && failure.code == "port.stranger"
            && self.lost.as_ref().is_some_and(|known| known.message != failure.message)
        {
            session.tell(Event::Note(both!(
                "{why}; waiting for the one that was lost",
                "{why}; es wird auf den verlorenen gewartet",
                why = failure.message
            )));
            self.lost = Some(failure);
        }
        let pause = TRY_AGAIN.min(until.since(session.now()));
        session.rest(pause).await.map_err(|error| self.told(&error))
    }

    fn told(&self, error: &AccessError) -> Failure {
        error.failure(0, None)
    }

    fn port_change(&self, session: &Session<'_>, failure: Option<&Failure>) -> PortChange {
        let (t, port) = (self.seconds(session.now()), session.port().to_owned());
        PortChange { t, port, error: failure.map(ErrorDoc::from) }
    }

    fn emit_sample(&mut self, session: &mut Session<'_>, sample: Sample) {
        self.tally.samples += 1;
        self.tally.gaps += u64::from(sample.error.is_some());
        let line = Some(news(session.tally()));
        self.emit(session, Record::Sample(Sample { line, ..sample }));
    }

    fn emit(&mut self, session: &mut Session<'_>, record: Record) {
        match &mut self.held {
            Some(held) => held.push(record),
            None => session.tell(Event::Record(Box::new(record))),
        }
    }

    /// Says what is watched and lets go of what was held back, unless that is done.
    fn start(&mut self, session: &mut Session<'_>, stations: &[Station]) {
        let Some(held) = self.held.take() else { return };
        let start = StreamStart {
            t: decimal(Span::ZERO),
            schema: SCHEMA_VERSION,
            tool: "antrieb",
            command: "monitor",
            port: session.port().to_owned(),
            begun: session.since_1970().map(|now| decimal(now - session.now().since(self.begin))),
            line: self.terms.line.to_string(),
            protocol: self.terms.speech.protocol.name(),
            interval: decimal(self.rounds.interval),
            waits: self.waits(),
            drives: stations.iter().map(|station| self.watched(station)).collect(),
        };
        for record in std::iter::once(Record::Start(start)).chain(held) {
            session.tell(Event::Record(Box::new(record)));
        }
    }

    fn watched(&self, station: &Station) -> WatchedDrive {
        let Some(target) = &station.target else {
            // It may turn out to be any drive that we know.
            let mut columns: Vec<Column> = Vec::new();
            for drive in self.terms.registry.drives() {
                let family = self.terms.registry.family(&drive.id).filter(|family| family.link.is_asked_on_a_line());
                let Some(family) = family else { continue };
                for item in (self.select)(&family).unwrap_or_default().items {
                    let new = item.columns(&family).into_iter();
                    columns.extend(new.filter(|new| !columns.iter().any(|known| known.is_of(new))).collect::<Vec<_>>());
                }
            }
            return WatchedDrive { address: station.address, drive: "unknown".to_owned(), title: None, columns };
        };
        WatchedDrive {
            address: station.address,
            drive: target.family.drive.clone(),
            title: Some(target.family.title.clone()),
            columns: station.items.iter().flat_map(|item| item.columns(&target.family)).collect(),
        }
    }

    /// Seconds since the start.
    fn seconds(&self, tick: Tick) -> Decimal {
        decimal(tick.since(self.begin))
    }

    fn outcome(self, stations: Vec<Station>) -> Outcome {
        let (mut failures, mut good) = (Vec::new(), 0);
        for station in stations {
            if station.good == 0 {
                failures.extend(station.failure);
                continue;
            }
            good += 1;
            let never = station.items.into_iter().filter(|item| item.good == 0 && !item.lenient);
            failures.extend(never.filter_map(|item| item.failure));
        }
        let lost = self.lost.filter(|_| self.tally.because == "lost");
        let failure = lost.or_else(|| summary(failures, good));
        Outcome { data: Some(Data::Monitor(self.tally)), warnings: self.warnings, failure }
    }
}

/// What the line has come to.
fn news(tally: Tally) -> LineNews {
    let Tally { sent, replies, waited, repeats, silences, garbled, .. } = tally;
    LineNews { telegrams: sent, replies, waited: decimal(waited), repeats, silences, garbled }
}

fn decimal(span: Span) -> Decimal {
    Decimal { raw: i64::try_from(span.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
}
