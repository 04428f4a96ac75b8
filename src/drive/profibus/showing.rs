//! Showing a run while it goes on, from the agreement to the moment at which the slave is let go: every cycle tells status word and frequency,
//! so nothing is asked for it.

use super::exchange::Exchange;
use super::mode::{Mode, Seen};
use super::shown::{EVERY, Shown, seconds};
use super::words::{FULL, Wanted};
use crate::drive::panel::Lingering;
use crate::failure::Failure;
use crate::outcome::{Decimal, ErrorDoc, Event, Record, RunKeys, RunNews, SCHEMA_VERSION, StreamStart, WatchedDrive};
use crate::profile::Family;
use crate::text::Text;
use crate::tick::Tick;
use std::rc::Rc;

impl Exchange<'_, '_> {
    /// From now on it is shown: says what is going to be. `stop` is how it ends, by the words of `--on-exit`.
    pub fn show(
        &mut self,
        family: &Rc<Family>,
        command: &'static str,
        (wanted, stop, keys): (Wanted, &'static str, Option<RunKeys>),
    ) {
        let t = Decimal { raw: 0, decimals: 6 };
        let news = RunNews {
            t,
            address: self.address(),
            phase: "waiting",
            setpoint: Some(Decimal { raw: wanted.value(), decimals: 2 }),
            unit: Some(wanted.unit().to_owned()),
            ends: None,
            stop,
            keys,
        };
        // A percent of A004 is one of 4000h, and Basic mode tells 0.01 Hz.
        let maximum = match (wanted, self.mode()) {
            (_, Mode::Basic(_)) => Some(FULL),
            (Wanted::Percent(_), Mode::Profidrive(_)) => Some(10_000),
            (Wanted::Hertz(_), Mode::Profidrive(_)) => None,
        };
        let is_basic = self.mode().is_basic();
        let shown = Shown::new(family.clone(), is_basic, maximum, (self.line.now(), news.clone()));
        let (port, line) = self.line.name();
        let drive = WatchedDrive {
            address: self.address(),
            node: 0,
            called: None,
            drive: family.drive.clone(),
            title: Some(family.title.clone()),
            columns: shown.columns(),
        };
        self.records([Record::Start(StreamStart {
            t,
            schema: SCHEMA_VERSION,
            tool: "antrieb",
            command,
            port,
            begun: self.line.since_1970().map(seconds),
            line,
            protocol: "dp",
            interval: Some(seconds(EVERY)),
            waits: None,
            drives: vec![drive],
        })]);
        self.records([Record::Run(news)]);
        self.shown = Some(shown);
    }

    /// From now on it is on its way to being held.
    pub fn starts(&mut self) {
        self.comes_to("starting", None);
    }

    /// The run comes to its next part, and when that ends by itself. Nobody gives a setpoint any more while it stops.
    pub(super) fn comes_to(&mut self, phase: &'static str, end: Option<Tick>) {
        let now = self.line.now();
        let news = self.shown.as_mut().and_then(|shown| shown.comes_to(now, phase, end));
        self.records(news.map(Record::Run));
    }

    /// The setpoint is led to this.
    pub(super) fn is_set(&mut self, raw: i64) {
        self.shown.iter_mut().for_each(|shown| shown.is_set(raw));
    }

    /// It is stopped by another way from now on.
    pub(super) fn stops_by(&mut self, stop: &'static str) {
        let now = self.line.now();
        let news = self.shown.as_mut().and_then(|shown| shown.stops_by(now, stop));
        self.records(news.map(Record::Run));
    }

    /// What 4000h is was measured, in hundredths of the unit.
    pub(super) fn is_scaled(&mut self, maximum: i64) {
        self.shown.iter_mut().for_each(|shown| shown.maximum = Some(maximum));
    }

    /// Goes on showing the motor under the stop word until nobody looks any more, or the view has stayed long enough; a slave that is lost
    /// ends it. `told` is what somebody is told of the end.
    pub(super) async fn lingers(&mut self, mut lingering: Lingering, told: Text) {
        self.comes_to("ended", None);
        self.tell(Event::Note(told));
        while lingering.goes_on(self.line.now()) && self.cycle().await.is_ok() {}
    }

    /// Tells what came in a cycle.
    pub(super) fn shows(&mut self, seen: Seen) {
        self.tells(Ok(seen));
    }

    /// No answer came: whoever watches sees a gap in place of what was before it.
    pub(super) fn misses(&mut self, failure: &Failure) {
        self.tells(Err(ErrorDoc::from(failure)));
    }

    fn tells(&mut self, heard: Result<Seen, ErrorDoc>) {
        let (now, setpoint) = (self.line.now(), self.mode().signed(self.words));
        let told = self.shown.as_mut().map(|shown| shown.sample(now, setpoint, heard));
        self.records(told.into_iter().flatten());
    }

    fn records(&mut self, records: impl IntoIterator<Item = Record>) {
        records.into_iter().for_each(|record| self.line.tell(Event::Record(Box::new(record))));
    }
}
