//! `monitor`: watches parameters of one or several drives until somebody ends it. Never writes.
//!
//! A round asks every drive for every parameter. What a drive does not answer is a gap in its sample, and the round
//! goes on with the next drive. What is sampled goes out as records at once; only the first round is held back until
//! it is known what there is to watch.

use super::verb::{Flow, Verb, Working};
use super::{
    Context, Reader, addresses_to_read, check_number, connect, is_over, offline, offline_family, plan, read_question,
};
use crate::args::{Settings, parse_span};
use crate::drive::{AccessError, Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::outcome::{
    Column, Data, Decimal, ErrorDoc, Event, Monitor, Outcome, PortChange, Record, SCHEMA_VERSION, Sample, SampleValue,
    StreamStart, Value, Warning, WatchedDrive,
};
use crate::profile::{DataSets, Family, Lang, Param, Registry, Selection, Selector, Store};
use crate::tick::{Span, Tick};
use clap::Args as ClapArgs;

/// Watches drives: state, setpoint, actual value, current, fault and warnings, or parameters of your choice.
///
/// On a terminal a live view with a chart; into a pipe or a file one line a sample. `--format ndjson` (or --json: a
/// stream has no end to wait for) and `--format csv` are for programs. Nothing is ever written to a drive.
///
/// A drive that does not answer is a gap in the data, and the watch goes on. Ctrl-C is the usual way to end it, and
/// ends it with exit code 0, like --count and --duration. If nothing ever answered it is 4; a lost port is 3, unless
/// --reconnect waits for it.
///
/// Parameters are named as for `read`.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// What to watch: 210, 480@2, rated-speed, @actual [default: state, setpoint, actual frequency, current, fault,
    /// warnings]
    #[arg(value_name = "PARAMETER")]
    pub params: Vec<String>,

    /// Time from round to round; 0 is as fast as the line allows
    #[arg(long, value_name = "TIME", default_value = "1s", value_parser = interval)]
    pub interval: Span,

    /// End after this time
    #[arg(long, value_name = "TIME", value_parser = parse_span)]
    pub duration: Option<Span>,

    /// End after this many rounds
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    pub count: Option<u64>,

    /// Wait for a port that is lost, such as an adapter that was unplugged, and go on when it is back
    ///
    /// A USB adapter is known by its serial number: it is found under another name, and another adapter under its old name
    /// is left alone. One without a serial number is known by its socket, or by its name.
    #[arg(long)]
    pub reconnect: bool,

    /// One line that is refreshed, in place of the live view
    #[arg(long)]
    pub line: bool,

    /// On the built-in bench: do not follow the wall clock; minutes of the bench take milliseconds
    #[arg(long)]
    pub unpaced: bool,
}

impl Verb for Args {
    const NAME: &'static str = "monitor";
    type Prints = Record;

    fn streams(&self) -> Option<Flow> {
        Some(Flow::Samples { line: self.line })
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Watches until the count or the time is over, the port is lost, or somebody ends it.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let selectors: Vec<Selector> = args
        .params
        .iter()
        .map(|text| text.parse().map_err(|error| super::read::select_failure(&error)))
        .collect::<Result<_, _>>()?;
    let Context { settings, registry, interrupt, observe, .. } = context;
    let addresses = addresses_to_read(settings, *observe)?;
    // Names are checked before the port is opened: some drive must know all of them.
    let (family, items) = offline(settings, registry, |family| items(&selectors, family, settings.lang))?;
    if settings.dry_run {
        let sets = items.iter().flat_map(|item| item.sets.wire().into_iter().map(move |set| (&item.param, set)));
        let questions: Vec<_> = sets.map(|(param, set)| read_question(param, set)).collect();
        return plan(context, &family, &questions);
    }
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    if !args.unpaced {
        session.pace();
    }
    let mut stations: Vec<_> = addresses.iter().map(|&address| Station::new(address, items.clone())).collect();
    let mut watch = Watch {
        settings,
        registry,
        selectors,
        interval: args.interval,
        begin: session.now(),
        held: Some(Vec::new()),
        tally: Monitor { because: "interrupted", t: decimal(Span::ZERO), rounds: 0, samples: 0, gaps: 0 },
        warnings: Vec::new(),
        lost: None,
    };
    watch.tally.because = watch.run(args, &mut session, &mut stations).await;
    watch.start(&mut session, &stations);
    watch.tally.t = watch.seconds(session.now());
    Ok(watch.outcome(stations))
}

/// What every family has, in the order of the default view.
const ROLES: [&str; 11] = [
    "status-word",
    "setpoint-ramp",
    "actual-frequency",
    "stator-frequency",
    "encoder-frequency",
    "actual-speed",
    "current",
    "dc-link-voltage",
    "fault",
    "warnings",
    "setpoint-bus",
];

/// Roles of the default view; of several actual values one will do, and only if its decimals are known.
const DEFAULT: [&[&str]; 7] = [
    &["status-word"],
    &["setpoint-ramp", "setpoint-bus"],
    &["actual-frequency", "stator-frequency", "encoder-frequency", "actual-speed"],
    &["current"],
    &["dc-link-voltage"],
    &["fault"],
    &["warnings"],
];

/// How often a lost port is tried.
const TRY_AGAIN: Span = Span::from_millis(500);

/// A parameter that is watched in one drive.
#[derive(Clone, Debug)]
struct Item {
    param: Param,
    sets: DataSets,
    /// Not every drive needs to have it.
    lenient: bool,
    /// Values that were read.
    good: u64,
    /// What went wrong last.
    failure: Option<Failure>,
    /// It went wrong in this round.
    failed: bool,
    /// The drive does not have it; it is not asked for again.
    refused: Option<Failure>,
}

impl Item {
    fn new(selection: Selection) -> Self {
        let Selection { param, sets, of_group } = selection;
        Item { param, sets, lenient: of_group, good: 0, failure: None, failed: false, refused: None }
    }

    async fn read(&mut self, reader: &mut Reader<'_, '_, '_>) -> Result<Vec<Value>, Failure> {
        reader.lenient = self.lenient;
        let rows = reader.rows(&self.param, self.sets).await?;
        self.good += rows.iter().filter(|row| row.error.is_none()).count() as u64;
        let (failure, forgiven) = (reader.failures.drain(..).next(), reader.forgiven.drain(..).next());
        self.failed = failure.is_some();
        self.refused = forgiven.filter(|_| self.good == 0);
        self.failure = failure.or_else(|| self.refused.clone()).or_else(|| self.failure.take());
        // The four sets differ, so there is no value of all of them: from now on each is asked for.
        if rows.len() > self.sets.wire().len() {
            self.sets = match self.sets {
                DataSets::One(_, store) | DataSets::All(store) => DataSets::All(store),
                DataSets::Unnamed => DataSets::All(Store::Eeprom),
            };
        }
        Ok(rows)
    }

    /// The rows of this parameter when it cannot be read.
    fn unread(&self, station: u8, family: &Family, settings: &Settings, failure: &Failure) -> Vec<Value> {
        let sets = self.sets.wire().into_iter();
        sets.map(|set| describe::unread(station, family, &self.param, set, settings.lang, failure)).collect()
    }
}

/// A drive that is watched.
struct Station {
    address: u8,
    target: Option<Target>,
    /// What is read of it; until it is recognised, what any drive of its kind would have.
    items: Vec<Item>,
    /// It did not answer in the last round: since when.
    silent: Option<Tick>,
    /// It is no drive that we know.
    out: Option<Failure>,
    /// Values that were read.
    good: u64,
    /// Why there is none.
    failure: Option<Failure>,
    asked_widths: Vec<u32>,
}

/// What came of asking one drive.
struct Haul {
    values: Vec<SampleValue>,
    warnings: Vec<Warning>,
    /// The first thing that went wrong.
    failure: Option<Failure>,
}

/// A watch at work.
struct Watch<'a> {
    settings: &'a Settings,
    registry: &'a Registry,
    selectors: Vec<Selector>,
    interval: Span,
    begin: Tick,
    /// Records of the first round, until the stream is started.
    held: Option<Vec<Record>>,
    tally: Monitor,
    warnings: Vec<Warning>,
    /// The port is lost.
    lost: Option<Failure>,
}

impl Watch<'_> {
    /// Goes round until it is over; returns why it is.
    async fn run(&mut self, args: &Args, session: &mut Session<'_>, stations: &mut [Station]) -> &'static str {
        let end = args.duration.map(|duration| self.begin + duration);
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
                && let Some(because) = self.trouble(session, failure, args.reconnect)
            {
                return because;
            }
            self.start(session, stations);
            self.tally.rounds += 1;
            if args.count.is_some_and(|count| self.tally.rounds >= count) {
                return "count";
            }
            if stations.iter().all(|station| station.out.is_some()) {
                return "no_drive";
            }
            let next = self.next_slot(slot, session.now());
            let until = end.map_or(next, |end| end.min(next));
            while session.now() < until {
                let result = match self.lost {
                    Some(_) => self.seek_port(session, until).await,
                    None => session.rest(until.since(session.now())).await.map_err(|error| self.told(&error)),
                };
                if let Err(failure) = result
                    && let Some(because) = self.trouble(session, failure, args.reconnect)
                {
                    return because;
                }
            }
            if end.is_some_and(|end| session.now() >= end) {
                return "duration";
            }
        }
    }

    /// The next point of the grid of rounds that is still ahead.
    fn next_slot(&self, slot: Tick, now: Tick) -> Tick {
        if self.interval == Span::ZERO {
            // Without a port there is nothing that would hold up the next round.
            return if self.lost.is_some() { now + TRY_AGAIN } else { now };
        }
        let step = self.interval.as_micros();
        let (done, gone) = (slot.since(self.begin).as_micros() / step, now.since(self.begin).as_micros() / step);
        self.begin + self.interval.times(gone.max(done) + 1)
    }

    /// One sample of every drive. Ends early only if the session is over.
    async fn round(&mut self, session: &mut Session<'_>, stations: &mut [Station]) -> Result<(), Failure> {
        for index in 0..stations.len() {
            let Some((_, rest)) = stations.split_at_mut_checked(index) else { break };
            let Some(station) = rest.first_mut() else { break };
            match self.sample(session, station).await {
                Ok(sample) => self.emit_sample(session, sample),
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
        let values = family.or_else(|| offline_family(self.settings, self.registry).ok()).map(|family| {
            let rows =
                station.items.iter().flat_map(|item| item.unread(station.address, &family, self.settings, failure));
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
        })
    }

    /// Says once that a drive went silent, and once that it is back.
    fn mark(&self, session: &mut Session<'_>, station: &mut Station, failure: Option<&Failure>, now: Tick) {
        let note = match (failure, station.silent) {
            (Some(failure), None) => {
                station.silent = Some(now);
                format!("{} ({})", failure.message, self.words("going on"))
            }
            (None, Some(since)) => {
                station.silent = None;
                let (address, gap) = (station.address, now.since(since));
                format!("{} {address} {} {gap}", self.words("address"), self.words("answers again after"))
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
                session.tell(Event::Note(format!("{}; {}", failure.message, self.words("waiting for it"))));
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
            session.tell(Event::Note(format!("{}: {}", change.port, self.words("the port is back"))));
            self.emit(session, Record::Reopened(change));
            return Ok(());
        }
        // Another adapter under the old name is told once, and left alone.
        if let Err(failure) = reopened
            && failure.code == "port.stranger"
            && self.lost.as_ref().is_some_and(|known| known.message != failure.message)
        {
            let waits = self.words("waiting for the one that was lost");
            session.tell(Event::Note(format!("{}; {waits}", failure.message)));
            self.lost = Some(failure);
        }
        let pause = TRY_AGAIN.min(until.since(session.now()));
        session.rest(pause).await.map_err(|error| self.told(&error))
    }

    fn told(&self, error: &AccessError) -> Failure {
        error.failure(0, None, self.settings.lang)
    }

    fn words(&self, english: &'static str) -> &'static str {
        let german = match english {
            "waiting for it" => "es wird darauf gewartet",
            "waiting for the one that was lost" => "es wird auf den verlorenen gewartet",
            "the port is back" => "der Anschluss ist wieder da",
            "going on" => "es geht weiter",
            "answers again after" => "antwortet wieder nach",
            "address" => "Adresse",
            _ => english,
        };
        self.settings.lang.pick(english, german)
    }

    fn port_change(&self, session: &Session<'_>, failure: Option<&Failure>) -> PortChange {
        let (t, port) = (self.seconds(session.now()), session.port().to_owned());
        PortChange { t, port, error: failure.map(ErrorDoc::from) }
    }

    fn emit_sample(&mut self, session: &mut Session<'_>, sample: Sample) {
        self.tally.samples += 1;
        self.tally.gaps += u64::from(sample.error.is_some());
        self.emit(session, Record::Sample(sample));
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
            line: self.settings.line.to_string(),
            protocol: self.settings.protocol.name(),
            interval: decimal(self.interval),
            drives: stations.iter().map(|station| self.watched(station)).collect(),
        };
        for record in std::iter::once(Record::Start(start)).chain(held) {
            session.tell(Event::Record(Box::new(record)));
        }
    }

    fn watched(&self, station: &Station) -> WatchedDrive {
        let lang = self.settings.lang;
        let Some(target) = &station.target else {
            // It may turn out to be any drive that we know.
            let mut columns: Vec<Column> = Vec::new();
            for drive in self.registry.drives() {
                let Some(family) = self.registry.family(&drive.id) else { continue };
                for item in items(&self.selectors, &family, self.settings.lang).unwrap_or_default() {
                    let new = item.columns(&family, lang).into_iter();
                    columns.extend(new.filter(|new| !columns.iter().any(|known| known.is_of(new))).collect::<Vec<_>>());
                }
            }
            return WatchedDrive { address: station.address, drive: "unknown".to_owned(), title: None, columns };
        };
        WatchedDrive {
            address: station.address,
            drive: target.family.drive.clone(),
            title: Some(target.family.title.get(lang).to_owned()),
            columns: station.items.iter().flat_map(|item| item.columns(&target.family, lang)).collect(),
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
        let failure = lost.or_else(|| super::summary(failures, good, self.settings.lang));
        Outcome { data: Some(Data::Monitor(self.tally)), warnings: self.warnings, failure }
    }
}

impl Station {
    fn new(address: u8, items: Vec<Item>) -> Self {
        Station {
            address,
            target: None,
            items,
            silent: None,
            out: None,
            good: 0,
            failure: None,
            asked_widths: Vec::new(),
        }
    }

    /// Recognises the drive if that was not done yet, then reads what is watched. A silent drive is not asked further.
    async fn read(&mut self, session: &mut Session<'_>, watch: &Watch<'_>) -> Result<Haul, Failure> {
        let (settings, registry) = (watch.settings, watch.registry);
        if self.target.is_none() {
            let shows_register = self.items.iter().any(|item| item.param.slug == "error-register");
            let target = super::target(session, settings, registry, self.address, shows_register).await?;
            self.items = items(&watch.selectors, &target.family, watch.settings.lang)?;
            self.target = Some(target);
        }
        let mut haul = Haul { values: Vec::new(), warnings: Vec::new(), failure: None };
        let Some(target) = &mut self.target else { return Ok(haul) };
        let family = target.family.clone();
        let mut reader = Reader::new(session, target, settings);
        reader.asked_widths = std::mem::take(&mut self.asked_widths);
        let mut silence: Option<Failure> = None;
        for item in &mut self.items {
            let rows = match silence.as_ref().or(item.refused.as_ref()) {
                Some(failure) => item.unread(self.address, &family, settings, failure),
                None => {
                    let rows = item.read(&mut reader).await?;
                    silence = item.failure.clone().filter(|failure| failure.class == Class::Silence && item.failed);
                    rows
                }
            };
            if item.failed || item.refused.is_some() {
                haul.failure = haul.failure.or_else(|| item.failure.clone());
            }
            let t = watch.seconds(reader.session.now());
            haul.values.extend(rows.into_iter().map(|value| SampleValue { t, value: terse(value) }));
        }
        haul.warnings = std::mem::take(&mut reader.warnings);
        self.asked_widths = reader.asked_widths;
        Ok(haul)
    }
}

impl Item {
    fn columns(&self, family: &Family, lang: Lang) -> Vec<Column> {
        let param = &self.param;
        let column = |set: u8| {
            let (data_set, store) = describe::place(set);
            Column {
                param: param.id,
                data_set,
                store: describe::kept(store, param),
                slug: param.slug.clone(),
                name: param.name(lang).to_owned(),
                unit: param.unit.clone(),
                role: ROLES.into_iter().find(|role| family.role(role).is_some_and(|known| known.id == param.id)),
                scaled: param.has_scale(),
            }
        };
        self.sets.wire().into_iter().map(column).collect()
    }
}

/// What the selectors mean in this family; without any, the roles of the default view.
fn items(selectors: &[Selector], family: &Family, lang: Lang) -> Result<Vec<Item>, Failure> {
    if selectors.is_empty() {
        let one_of = |roles: &&[&str]| {
            let mut known = roles.iter().filter_map(|role| family.role(role));
            known.clone().find(|param| param.has_scale()).or_else(|| known.next()).cloned()
        };
        let select = |param| Item::new(Selection { param, sets: DataSets::Unnamed, of_group: true });
        return Ok(DEFAULT.iter().filter_map(one_of).filter(|param| !moves_on(family, param)).map(select).collect());
    }
    let mut items = Vec::new();
    for selector in selectors {
        let selections = selector.resolve(family).map_err(|error| super::read::select_failure(&error))?;
        for selection in selections {
            // Whoever names it alone wants it so.
            if selection.of_group && moves_on(family, &selection.param) {
                continue;
            }
            check_number(family, &selection.param, lang)?;
            items.push(Item::new(selection));
        }
    }
    Ok(items)
}

/// Whether reading a parameter again and again may change what it shows: an entry of the fault memory, of which the next
/// may be read the next time. The state tells of a fault as well, and `diag` shows the memory once.
fn moves_on(family: &Family, param: &Param) -> bool {
    family.fault_codes.memory && family.role("fault").is_some_and(|fault| fault.id == param.id)
}

/// A stream repeats its values for ever; what bits mean and what to do about them is told by `params`.
fn terse(mut value: Value) -> Value {
    if let Some(word) = &mut value.word {
        word.bits.iter_mut().for_each(|bit| bit.help = None);
    }
    value
}

fn decimal(span: Span) -> Decimal {
    Decimal { raw: i64::try_from(span.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
}

/// Like any other time, but 0 needs no unit.
fn interval(text: &str) -> Result<Span, String> {
    if text.trim() == "0" { Ok(Span::ZERO) } else { parse_span(text) }
}
