//! What is shown of a run while it goes on: whatever the motor sees by itself, and what is asked for besides in the pauses of a
//! run that is held. Nothing of that holds anything up: it is asked for only where its answer and a missing one both fit into the
//! pause, never into a busy line, and not for a while where no answer came.

use super::look::status_word;
use super::{Motor, StopChoice};
use crate::drive::describe;
use crate::drive::interrupt::Interrupt;
use crate::drive::panel::{Lingering, Panel, Stays};
use crate::drive::transfer::Reading;
use crate::drive::watch::Memory;
use crate::drive::{AccessError, Item, Session, Target};
use crate::exchange::INSIST;
use crate::failure::{Class, Failure};
use crate::outcome::{
    Column, Decimal, ErrorDoc, Event, Record, RunKeys, RunNews, SCHEMA_VERSION, Sample, SampleValue, State,
    StreamStart, WatchedDrive,
};
use crate::profile::{Param, Type};
use crate::text::Text;
use crate::tick::{Span, Tick};

/// Pause between two looks of a run that is held or shown; also what the records say of it.
const EVERY: Span = Span::from_millis(250);
/// No two samples come sooner, however often something is seen.
const SOONEST: Span = Span::from_millis(200);
/// What a question for the view is taken to cost before one was asked.
const COST: Span = Span::from_millis(60);
/// And at most: an answer that took longer was lost, and the next one is not.
const DEAREST: Span = Span::from_millis(600);
/// What was seen longer ago is not shown any more.
const STALE: Span = Span::from_secs(3);
/// The pause of a run is no longer for what is shown than this, and has this to spare.
const LONGEST: Span = Span::from_secs(1);
const SLACK: Span = Span::from_millis(20);
/// Where one was not answered none is asked for so long.
const SULK: Span = Span::from_secs(5);

/// What is shown of a run.
#[derive(Debug)]
pub struct Watched {
    rows: Vec<Row>,
    begun: Tick,
    samples: u64,
    told: Option<Tick>,
    /// What the drive said of its state, and when.
    status: Option<(u32, Tick)>,
    /// What was seen of it before a fault.
    memory: Memory,
    /// A fault whose code was not known yet was not told: it is with the next look, whether that tells it or not.
    held_back: bool,
    /// The last question brought no answer: what was seen before it is not shown as if it were of now.
    silent: bool,
    news: RunNews,
    /// What was said of it last.
    said: Option<RunNews>,
    cost: Span,
    not_before: Tick,
    next: usize,
    /// The keypad of whoever watches.
    panel: Panel,
    /// It was held, so that ending it by a key is its normal end.
    held: bool,
    /// The setpoint is led along a schedule.
    led: bool,
}

/// A value that is shown.
#[derive(Debug)]
struct Row {
    param: Param,
    column: Column,
    value: Option<SampleValue>,
    /// The drive does not have it.
    refused: bool,
}

impl Row {
    fn told(&self, since: Span, target: &Target, raw: i64) -> SampleValue {
        let kind = self.param.kind.unwrap_or(Type::Long);
        let reading = Reading { set: 0, raw, text: None, kind, corrected: false };
        let mut value = describe::value(target.address, &target.family, &self.param, reading, &|_| None);
        if let Some(word) = &mut value.word {
            word.bits.iter_mut().for_each(|bit| bit.help = None);
        }
        SampleValue { t: seconds(since), value }
    }
}

impl Watched {
    /// Begins: says what is going to be shown. `keys`: what the arrows of the keypad do.
    pub fn begin(
        session: &mut Session<'_>,
        target: &Target,
        items: &[Item],
        (command, stop): (&'static str, StopChoice),
        keys: Option<RunKeys>,
        panel: Panel,
    ) -> Self {
        let family = &target.family;
        let of = |item: &Item| item.columns(family).into_iter().next().map(|column| (item.param().clone(), column));
        let rows = items.iter().filter_map(of);
        let rows: Vec<_> = rows.map(|(param, column)| Row { param, column, value: None, refused: false }).collect();
        let columns = rows.iter().map(|row| row.column.clone()).collect();
        let t = Decimal { raw: 0, decimals: 6 };
        let start = StreamStart {
            t,
            schema: SCHEMA_VERSION,
            tool: "antrieb",
            command,
            port: session.port().to_owned(),
            begun: session.since_1970().map(seconds),
            line: session.line().to_string(),
            protocol: session.protocol().name(),
            interval: Some(seconds(EVERY)),
            waits: None,
            drives: vec![Self::drive(target, session.node(), columns)],
        };
        session.tell(Event::Record(Box::new(Record::Start(start))));
        let news = RunNews {
            t,
            address: target.address,
            phase: "waiting",
            setpoint: None,
            unit: None,
            ends: None,
            stop: stop.slug(),
            keys,
        };
        let begun = session.now();
        let mut shown = Watched {
            rows,
            begun,
            samples: 0,
            told: None,
            status: None,
            memory: Memory::default(),
            held_back: false,
            silent: false,
            news,
            said: None,
            cost: COST,
            not_before: begun,
            next: 0,
            panel,
            held: false,
            led: false,
        };
        shown.changes(session);
        shown
    }

    fn drive(target: &Target, node: u8, columns: Vec<Column>) -> WatchedDrive {
        let Target { address, family, .. } = target;
        let (address, drive) = (*address, family.drive.clone());
        let title = Some(family.title.clone());
        WatchedDrive { address, node, called: None, drive, title, columns }
    }

    /// From now on it is on its way to being held.
    pub fn starts(&mut self, session: &mut Session<'_>) {
        self.news.phase = "starting";
        self.changes(session);
    }

    /// Whether the run was held.
    pub fn was_held(&self) -> bool {
        self.held
    }

    fn changes(&mut self, session: &mut Session<'_>) {
        self.news.t = seconds(session.now().since(self.begun));
        let is_old = self.said.as_ref().is_some_and(|said| RunNews { t: self.news.t, ..said.clone() } == self.news);
        if !is_old {
            self.said = Some(self.news.clone());
            session.tell(Event::Record(Box::new(Record::Run(self.news.clone()))));
        }
    }

    fn takes(&mut self, now: Tick, target: &Target, param: &Param, raw: i64) {
        self.silent = false;
        let Some(row) = self.rows.iter_mut().find(|row| row.param.id == param.id) else { return };
        row.value = Some(row.told(now.since(self.begun), target, raw));
    }

    /// Whether this is the first look at a fault of which the drive will tell the code in a moment.
    fn waits_for_code(&mut self, state: &State, values: &[SampleValue]) -> bool {
        let is_code = |row: &Row| row.column.role == Some("fault") && !row.refused;
        let Some(code) = self.rows.iter().find(|row| is_code(row)).map(|row| row.param.id) else { return false };
        let is_told = values.iter().any(|row| row.value.param == code && row.value.raw.is_some_and(|raw| raw != 0));
        let waits = state.slug.starts_with("fault") && !is_told && !self.held_back;
        self.held_back = waits || (self.held_back && state.slug.starts_with("fault"));
        waits
    }

    /// The next value that is asked for, if there is time for it until then.
    fn next(&mut self, now: Tick, until: Tick) -> Option<(usize, Param)> {
        if now < self.not_before || now + self.cost + INSIST > until {
            return None;
        }
        let count = self.rows.len();
        let asked = |row: &Row| !row.refused && row.column.role != Some("status-word");
        let index = (self.next..self.next + count)
            .map(|index| index % count)
            .find(|&index| self.rows.get(index).is_some_and(asked))?;
        self.next = index + 1;
        Some((index, self.rows.get(index)?.param.clone()))
    }
}

impl Motor<'_, '_> {
    /// A value was seen.
    pub(super) fn sees(&mut self, param: &Param, raw: i64) {
        let now = self.session.now();
        if let Some(shown) = &mut self.watched {
            shown.takes(now, self.target, param, raw);
        }
    }

    /// A status word was seen.
    pub(super) fn sees_status(&mut self, status: u32) {
        let Some(shown) = &mut self.watched else { return };
        (shown.status, shown.silent) = (Some((status, self.session.now())), false);
        if let Some(param) = self.target.family.clone().role("status-word") {
            self.sees(param, status.into());
        }
        self.shows();
    }

    /// The run comes to its next part: `held`, `stopping`, `ended`; and when that ends by itself.
    pub(super) fn comes_to(&mut self, phase: &'static str, end: Option<Tick>) {
        let given = self.setpoint.as_ref().map(|setpoint| setpoint.param);
        let Some(shown) = &mut self.watched else { return };
        shown.held |= phase == "held";
        if matches!(phase, "stopping" | "ended") {
            shown.panel.rests();
        }
        if phase == "stopping" {
            // The setpoint of the run holds no more.
            let is_role = |row: &Row| row.column.role.is_some_and(|role| role.starts_with("setpoint"));
            let leads = |row: &&mut Row| Some(row.param.id) == given || is_role(row);
            shown.rows.iter_mut().filter(leads).for_each(|row| row.value = None);
        }
        shown.news.phase = if phase == "held" && shown.led { "led" } else { phase };
        shown.news.ends = end.map(|end| seconds(end.since(shown.begun)));
        self.shows();
    }

    /// Says something to whoever watches.
    pub fn tell(&mut self, text: Text) {
        self.session.tell(Event::Note(text));
    }

    /// From now on, until it is said again, the setpoint is led: what ends is the way and not the run.
    pub fn is_led(&mut self, led: bool) {
        self.watched.iter_mut().for_each(|shown| shown.led = led);
    }

    /// It is stopped by another way from now on.
    pub(super) fn stops_by(&mut self, slug: &'static str) {
        self.watched.iter_mut().for_each(|shown| shown.news.stop = slug);
        self.shows();
    }

    /// Tells what is known, unless that was done a moment ago, or the drive has fallen silent.
    pub(super) fn shows(&mut self) {
        let now = self.session.now();
        let Some(shown) = &mut self.watched else { return };
        let runs = !matches!(shown.news.phase, "stopping" | "ended");
        let setpoint = self.setpoint.as_ref().filter(|_| runs);
        let given = setpoint.map(|setpoint| setpoint.value);
        let is_new = std::mem::replace(&mut shown.news.setpoint, given) != given;
        shown.news.unit = setpoint.map(|setpoint| setpoint.unit.clone()).filter(|unit| !unit.is_empty());
        shown.changes(self.session);
        // Of a drive that answers slowly every value is asked for more seldom.
        let stale = STALE.longer(shown.cost.times(8 * shown.rows.len() as u64));
        let oldest = seconds(now.since(shown.begun + stale)).raw;
        // What was just given is what stands, also where there was no time to ask for it.
        if let Some(setpoint) = setpoint
            && let Some(row) = shown.rows.iter_mut().find(|row| row.param.id == setpoint.param)
            && (is_new || row.value.as_ref().is_none_or(|value| value.t.raw < oldest))
        {
            row.value = Some(row.told(now.since(shown.begun), self.target, setpoint.value.raw));
        }
        let Some((status, at)) = shown.status.filter(|_| !shown.silent) else { return };
        let is_fresh = |value: &SampleValue| value.t.raw >= oldest;
        let values: Vec<_> = shown.rows.iter().filter_map(|row| row.value.clone().filter(is_fresh)).collect();
        let state: State = describe::state(&self.target.family, status);
        if shown.waits_for_code(&state, &values) {
            return;
        }
        self.samples((now.since(at) < STALE).then_some(state), values, None);
    }

    /// No valid answer came, or the port is lost: whoever watches sees a gap, and its length, in place of what was before it, the first at once.
    pub(super) fn misses(&mut self, failure: &Failure) {
        if failure.is_unheard() || failure.class == Class::Port {
            if let Some(shown) = &mut self.watched
                && !std::mem::replace(&mut shown.silent, true)
                && failure.class == Class::Port
            {
                shown.told = None;
            }
            self.samples(None, Vec::new(), Some(ErrorDoc::from(failure)));
        }
    }

    fn samples(&mut self, state: Option<State>, values: Vec<SampleValue>, error: Option<ErrorDoc>) {
        let now = self.session.now();
        let is_due = |shown: &Watched| shown.told.is_none_or(|told| now.since(told) >= SOONEST);
        let Some(shown) = self.watched.as_mut().filter(|shown| is_due(shown) || shown.memory.is_new(state.as_ref()))
        else {
            return;
        };
        let sample = Sample {
            t: seconds(now.since(shown.begun)),
            n: shown.samples,
            port: None,
            address: self.target.address,
            node: self.session.node(),
            called: None,
            drive: self.target.family.drive.clone(),
            state,
            values,
            error,
            line: None,
        };
        (shown.told, shown.samples) = (Some(now), shown.samples + 1);
        if let Some(trip) = shown.memory.take(&sample, &self.target.family, None) {
            self.session.tell(Event::Record(Box::new(Record::Trip(Box::new(trip)))));
        }
        self.session.tell(Event::Record(Box::new(Record::Sample(sample))));
    }

    /// The pause before the next round of a run that is held, of which what is shown takes a part. It ends when it is to end,
    /// whatever the drive answers; `end` is that of the run.
    pub(super) async fn spend(&mut self, pause: Span, end: Option<Tick>) -> Result<(), Failure> {
        let until = self.session.now() + pause.longer(self.room_for_a_value(end));
        self.fill(until, end).await?;
        let now = self.session.now();
        if now < until { self.rest(until.since(now)).await } else { Ok(()) }
    }

    /// How long a pause has room for one value that is shown, however slowly the drive answers; no longer than its watchdog and the end
    /// leave.
    fn room_for_a_value(&self, end: Option<Tick>) -> Span {
        let Some(shown) = &self.watched else { return Span::ZERO };
        let most = self.guard.map_or(LONGEST, |guard| Span::from_micros(guard.as_micros() / 4));
        let most = end.map_or(most, |end| most.min(end.since(self.session.now())));
        let cost = Span::from_micros(shown.cost.as_micros() / 4 * 5);
        (cost + INSIST + SLACK).min(most)
    }

    /// So long took an answer: the next one for the view will hardly take less.
    pub(super) fn expects_answers_within(&mut self, took: Span) {
        if let Some(shown) = &mut self.watched {
            shown.cost = took.min(DEAREST).longer(Span::from_micros(shown.cost.as_micros() / 8 * 7));
        }
    }

    /// Asks for what is shown, as far as that fits into a pause.
    async fn fill(&mut self, until: Tick, end: Option<Tick>) -> Result<(), Failure> {
        if self.watched.is_some() {
            let insisted = self.session.is_insisting();
            self.session.insist(false);
            let asked = self.ask_for_view(until).await;
            self.session.insist(insisted);
            self.session.end_at(end);
            asked?;
            self.shows();
        }
        Ok(())
    }

    /// Looks at the state for the view alone.
    async fn look_for_view(&mut self) -> Result<(), Failure> {
        self.session.end_at(None);
        let retries = self.session.set_retries(0);
        let status = status_word(self.session, self.target).await;
        self.session.set_retries(retries);
        match status {
            Ok(status) => self.sees_status(status),
            Err(failure) => {
                self.misses(&failure);
                if matches!(failure.class, Class::Port | Class::Interrupted) {
                    return Err(failure);
                }
            }
        }
        Ok(())
    }

    /// Shows the drive until a key of the keypad is held, or somebody ended it before. Only reads.
    pub async fn await_key(&mut self, panel: &Panel) -> Result<(), Failure> {
        loop {
            self.look_for_view().await?;
            let until = self.session.now() + EVERY;
            self.fill(until, None).await?;
            let held = self.session.during_until(panel.held(), Some(until)).await;
            if held.map_err(|error| self.failure(&error))?.is_some() {
                return Ok(());
            }
        }
    }

    async fn ask_for_view(&mut self, until: Tick) -> Result<(), Failure> {
        let rows = self.watched.as_ref().map_or(0, |shown| shown.rows.len());
        for _ in 0..rows {
            let now = self.session.now();
            let Some((index, param)) = self.watched.as_mut().and_then(|shown| shown.next(now, until)) else {
                return Ok(());
            };
            self.session.end_at(Some(Tick::from_micros(until.as_micros() - INSIST.as_micros())));
            let retries = self.session.set_retries(0);
            let read = self.target.read_set(self.session, &param, 0).await;
            self.session.set_retries(retries);
            let took = self.session.now().since(now);
            self.expects_answers_within(took);
            match read {
                Ok(reading) => self.sees(&param, reading.raw),
                Err(AccessError::Refused(_)) => {
                    self.watched
                        .iter_mut()
                        .filter_map(|shown| shown.rows.get_mut(index))
                        .for_each(|row| row.refused = true);
                }
                Err(error) => {
                    let failure = self.failure(&error);
                    if matches!(failure.class, Class::Port | Class::Interrupted) {
                        return Err(failure);
                    }
                    let again = self.session.now() + SULK;
                    self.watched.iter_mut().for_each(|shown| shown.not_before = again);
                    return Ok(());
                }
            }
        }
        Ok(())
    }

    /// Goes on showing the drive behind its end, of which this is told, until nobody looks any more, or it has stayed long
    /// enough. Only reads.
    pub async fn linger(&mut self, interrupt: &Interrupt, told: Text, stays: Stays) {
        self.comes_to("ended", None);
        self.tell(told);
        let mut lingering = Lingering::new(interrupt.panel().clone(), stays, self.session.now());
        while lingering.goes_on(self.session.now()) {
            // Who interrupts here has left; a lost port ends the next question as well.
            let _over = self.look_for_view().await;
            if self.spend(EVERY, None).await.is_err() {
                return;
            }
        }
    }
}

fn seconds(span: Span) -> Decimal {
    Decimal { raw: i64::try_from(span.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
}
