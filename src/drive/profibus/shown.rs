//! What is shown of a run while it goes on: every cycle tells status word and frequency, so nothing is asked for it.

use super::exchange::Exchange;
use super::mode::Seen;
use super::state;
use super::words::Wanted;
use crate::drive::describe;
use crate::drive::transfer::Reading;
use crate::outcome::{
    Column, Decimal, Event, Record, RunNews, SCHEMA_VERSION, Sample, SampleValue, StreamStart, WatchedDrive,
};
use crate::profile::{Family, Param, Type};
use crate::tick::{Span, Tick};
use std::rc::Rc;

/// No two samples come sooner.
const EVERY: Span = Span::from_millis(250);
/// The actual value word (5.2), and the output frequency (5.3), which is what the Basic block tells.
const HIW: u32 = 701;
const FREQUENCY: u32 = 614;

/// What is shown of a run.
#[derive(Debug)]
pub struct Shown {
    family: Rc<Family>,
    hiw: Param,
    begun: Tick,
    told: Option<Tick>,
    samples: u64,
    news: RunNews,
}

impl Shown {
    /// Begins: says what is going to be shown. `stop` is how it ends, by the words of `--on-exit`.
    pub fn begin(
        exchange: &mut Exchange<'_, '_>,
        family: &Rc<Family>,
        command: &'static str,
        (wanted, stop): (Wanted, &'static str),
    ) -> Self {
        let hiw = family.param_or_unknown(if exchange.mode().is_basic() { FREQUENCY } else { HIW });
        let (begun, address) = (exchange.line.now(), exchange.address());
        let t = Decimal { raw: 0, decimals: 6 };
        let (raw, unit) = match wanted {
            Wanted::Hertz(raw) => (raw, "Hz"),
            Wanted::Percent(raw) => (raw, "%"),
        };
        let column = Column {
            param: hiw.id,
            data_set: 0,
            store: "unknown",
            slug: hiw.slug.clone(),
            name: hiw.name.clone(),
            unit: Some(unit.to_owned()),
            role: Some("actual-frequency"),
            scaled: true,
            is_word: false,
        };
        let (port, line) = exchange.line.name();
        let drives = vec![WatchedDrive {
            address,
            called: None,
            drive: family.drive.clone(),
            title: Some(family.title.clone()),
            columns: vec![column],
        }];
        exchange.line.tell(Event::Record(Box::new(Record::Start(StreamStart {
            t,
            schema: SCHEMA_VERSION,
            tool: "antrieb",
            command,
            port,
            begun: exchange.line.since_1970().map(seconds),
            line,
            protocol: "dp",
            interval: Some(seconds(EVERY)),
            waits: None,
            drives,
        }))));
        let news = RunNews {
            t,
            address,
            phase: "waiting",
            setpoint: Some(Decimal { raw, decimals: 2 }),
            unit: Some(unit.to_owned()),
            ends: None,
            stop,
            keys: None,
        };
        let mut shown = Shown { family: family.clone(), hiw, begun, told: None, samples: 0, news };
        shown.comes_to(exchange, "waiting", None);
        shown
    }

    /// From now on it is on its way to being held.
    pub fn starts(&mut self, exchange: &mut Exchange<'_, '_>) {
        self.comes_to(exchange, "starting", None);
    }

    /// The run comes to its next part, and when that ends by itself.
    pub(super) fn comes_to(&mut self, exchange: &mut Exchange<'_, '_>, phase: &'static str, end: Option<Tick>) {
        self.news.phase = phase;
        self.news.t = seconds(exchange.line.now().since(self.begun));
        self.news.ends = end.map(|end| seconds(end.since(self.begun)));
        exchange.line.tell(Event::Record(Box::new(Record::Run(self.news.clone()))));
    }

    /// Tells what came in a cycle; `maximum` is what 4000h is, in hundredths of the unit.
    pub(super) fn sees(&mut self, exchange: &mut Exchange<'_, '_>, seen: Seen, maximum: i64) {
        let now = exchange.line.now();
        if self.told.is_some_and(|told| now.since(told) < EVERY) {
            return;
        }
        let t = seconds(now.since(self.begun));
        let raw = i64::from(seen.hiw);
        let reading = Reading { set: 0, raw, text: None, kind: Type::Int, corrected: false };
        let mut value = describe::value(exchange.address(), &self.family, &self.hiw, reading, &|_| None);
        value.value = Some(Decimal { raw: raw * maximum / 0x4000, decimals: 2 });
        value.unit = self.news.unit.clone();
        let sample = Sample {
            t,
            n: self.samples,
            port: None,
            address: exchange.address(),
            called: None,
            drive: self.family.drive.clone(),
            state: Some(state::of(seen)),
            values: vec![SampleValue { t, value }],
            error: None,
            line: None,
        };
        (self.told, self.samples) = (Some(now), self.samples + 1);
        exchange.line.tell(Event::Record(Box::new(Record::Sample(sample))));
    }
}

fn seconds(span: Span) -> Decimal {
    Decimal { raw: i64::try_from(span.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
}
