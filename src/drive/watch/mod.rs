//! Watching parameters of one or several drives until somebody ends it. Never writes.
//!
//! A round asks every drive for every parameter. What a drive does not answer is a gap in its sample, and the round
//! goes on with the next drive. What is sampled goes out as records at once; only the first round is held back until
//! it is known what there is to watch.

mod item;
mod moment;
mod pace;
mod rounds;
mod source;
mod station;
mod trigger;
mod trip;

pub use item::Item;
pub use rounds::{Calls, Rounds, When};
pub(in crate::drive) use source::Source;
pub(in crate::drive) use station::{Haul, Station, terse};
pub use trigger::{Compare, Condition, Signal, Test};
pub(super) use trip::Memory;

use super::{Session, Terms, is_over, summary};
use crate::exchange::Tally;
use crate::failure::{Class, Failure};
use crate::outcome::{
    Column, Data, Decimal, ErrorDoc, Event, LineNews, Monitor, Outcome, PortChange, Record, SCHEMA_VERSION, Sample,
    SampleValue, StreamStart, Value, Warning, WatchedDrive,
};
use crate::profile::Family;
use crate::text::both;
use crate::tick::{Span, Tick};
use pace::Pace;

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

/// A drive that is watched.
#[derive(Clone, Debug)]
pub struct Place {
    /// Its address.
    pub address: u8,
    /// Its name in the project file.
    pub called: Option<String>,
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
    places: &[Place],
    chosen: &Chosen,
    select: &Select<'_>,
) -> Outcome {
    let items = &chosen.items;
    let stations = places.iter().map(|place| Station::new(place.clone(), items.clone())).collect();
    watch_stations(session, terms, rounds, stations, (&chosen.waited_for, select)).await
}

/// The same of drives that are known, wherever their samples come from.
pub(in crate::drive) async fn watch_stations(
    session: &mut impl Source,
    terms: &Terms<'_>,
    rounds: Rounds,
    mut stations: Vec<Station>,
    (waited_for, select): (&[Condition], &Select<'_>),
) -> Outcome {
    let mut watch = Watch {
        terms,
        select,
        begin: session.now(),
        port: session.port(),
        held: Some(Vec::new()),
        triggers: waited_for.iter().map(|condition| condition.text.clone()).collect(),
        end: rounds.duration.map(|duration| (session.now() + duration, "duration")),
        rounds,
        tally: untold(),
        pace: Pace::default(),
        warnings: Vec::new(),
        lost: None,
        unheard: None,
    };
    watch.tally.because = watch.run(session, &mut stations).await;
    watch.start(session, &stations);
    watch.tally.t = watch.seconds(session.now());
    let interval = watch.rounds.when.interval();
    watch.pace.tell(&mut watch.tally, interval);
    watch.warnings.extend(watch.pace.warning(interval, watch.tally.gaps));
    watch.outcome(stations)
}

/// A watch at work.
pub(in crate::drive) struct Watch<'a> {
    pub(in crate::drive) terms: &'a Terms<'a>,
    select: &'a Select<'a>,
    rounds: Rounds,
    begin: Tick,
    /// The port, as it was called then.
    port: String,
    /// Records of the first round, until the stream is started.
    held: Option<Vec<Record>>,
    /// The triggers, as they were typed.
    triggers: Vec<String>,
    /// When it ends, and why then.
    end: Option<(Tick, &'static str)>,
    tally: Monitor,
    pace: Pace,
    warnings: Vec<Warning>,
    /// The port is lost.
    lost: Option<Failure>,
    /// Nobody who calls for a round can be heard any more.
    unheard: Option<Failure>,
}

impl Watch<'_> {
    /// Goes round until it is over; returns why it is.
    async fn run(&mut self, session: &mut impl Source, stations: &mut [Station]) -> &'static str {
        loop {
            if let Some(because) = self.pause(session, self.pace.last()).await {
                return because;
            }
            self.pace.begins(session.now(), self.begin, self.rounds.when.interval());
            let result = match self.lost.clone() {
                Some(failure) => {
                    self.blank(session, stations, &failure);
                    Ok(())
                }
                None => self.round(session, stations).await,
            };
            if let Err(failure) = result
                && let Some(because) = self.trouble(session, failure)
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
        }
    }

    /// One sample of every drive. Ends early only if the session is over.
    async fn round(&mut self, session: &mut impl Source, stations: &mut [Station]) -> Result<(), Failure> {
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
    fn blank(&mut self, session: &mut impl Source, stations: &[Station], failure: &Failure) {
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
            let rows = station.items.iter().flat_map(|item| item.unread(station.place.address, &family, failure));
            rows.map(|value| SampleValue { t, value: Value { drive: drive.clone(), ..value } }).collect()
        });
        Sample {
            t,
            n: self.tally.rounds,
            address: station.place.address,
            node: self.terms.speech.node,
            called: station.place.called.clone(),
            port: Some(self.port.clone()),
            values: values.unwrap_or_default(),
            drive,
            state: None,
            error: Some(ErrorDoc::from(failure)),
            line: None,
        }
    }

    /// Asks one drive; what it does not answer is a gap.
    async fn sample(&mut self, session: &mut impl Source, station: &mut Station) -> Result<Sample, Failure> {
        let now = session.now();
        if let Some(failure) = &station.out {
            return Ok(self.gap(now, station, failure));
        }
        let haul = match session.read(station, self).await {
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
            address: station.place.address,
            node: self.terms.speech.node,
            called: station.place.called.clone(),
            port: Some(self.port.clone()),
            drive: station.target.as_ref().map_or_else(String::new, |target| target.family.drive.clone()),
            state: haul.state.or_else(|| haul.values.iter().find_map(|value| value.value.word.as_ref()?.state.clone())),
            values: haul.values,
            error: failure.as_ref().map(ErrorDoc::from),
            line: None,
        })
    }

    /// Says once that a drive went silent, and once that it is back.
    fn mark(&self, session: &mut impl Source, station: &mut Station, failure: Option<&Failure>, now: Tick) {
        let note = match (failure, station.silent) {
            (Some(failure), None) => {
                station.silent = Some(now);
                both!("{why} (going on)", "{why} (es geht weiter)", why = failure.told())
            }
            (None, Some(since)) => {
                station.silent = None;
                let (address, gap) = (station.place.address, now.since(since));
                both!("address {address} answers again after {gap}", "Adresse {address} antwortet wieder nach {gap}")
            }
            _ => return,
        };
        session.tell(Event::Note(note));
    }

    fn port_change(&self, session: &impl Source, failure: Option<&Failure>) -> PortChange {
        let (t, port) = (self.seconds(session.now()), session.port());
        PortChange { t, port, error: failure.map(ErrorDoc::from) }
    }

    fn emit_sample(&mut self, session: &mut impl Source, sample: Sample) {
        self.tally.samples += 1;
        self.tally.gaps += u64::from(sample.error.is_some());
        let line = Some(news(session.tally()));
        self.emit(session, Record::Sample(Sample { line, ..sample }));
    }

    fn emit(&mut self, session: &mut impl Source, record: Record) {
        match &mut self.held {
            Some(held) => held.push(record),
            None => session.tell(Event::Record(Box::new(record))),
        }
    }

    /// Says what is watched and lets go of what was held back, unless that is done.
    fn start(&mut self, session: &mut impl Source, stations: &[Station]) {
        let Some(held) = self.held.take() else { return };
        let (line, protocol) = session.speaks(self.terms);
        let start = StreamStart {
            t: decimal(Span::ZERO),
            schema: SCHEMA_VERSION,
            tool: "antrieb",
            command: "monitor",
            port: self.port.clone(),
            begun: session.since_1970().map(|now| decimal(now - session.now().since(self.begin))),
            line,
            protocol,
            interval: self.rounds.when.interval().map(decimal),
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
            let Place { address, called } = station.place.clone();
            let (node, drive) = (self.terms.speech.node, "unknown".to_owned());
            return WatchedDrive { address, node, called, drive, title: None, columns };
        };
        WatchedDrive {
            address: station.place.address,
            node: self.terms.speech.node,
            called: station.place.called.clone(),
            drive: target.family.drive.clone(),
            title: Some(target.family.title.clone()),
            columns: station.items.iter().flat_map(|item| item.columns(&target.family)).collect(),
        }
    }

    /// Seconds since the start.
    pub(in crate::drive) fn seconds(&self, tick: Tick) -> Decimal {
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
        let failure = lost.or(self.unheard).or_else(|| summary(failures, good));
        Outcome { data: Some(Data::Monitor(self.tally)), warnings: self.warnings, failure }
    }
}

/// What is told of a watch that has not begun.
fn untold() -> Monitor {
    let (t, interval, interval_kept) = (decimal(Span::ZERO), None, None);
    Monitor { because: "interrupted", t, rounds: 0, samples: 0, gaps: 0, triggers: 0, interval, interval_kept, late: 0 }
}

/// What the line has come to.
fn news(tally: Tally) -> LineNews {
    let Tally { sent, replies, waited, repeats, silences, garbled, .. } = tally;
    LineNews { telegrams: sent, replies, waited: decimal(waited), repeats, silences, garbled }
}

fn decimal(span: Span) -> Decimal {
    Decimal { raw: i64::try_from(span.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
}
