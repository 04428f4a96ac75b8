//! What is known of a run that is shown: what its columns are, and what a cycle tells of them.

use super::looked::fault;
use super::mode::Seen;
use super::state;
use super::words::FULL;
use crate::drive::describe;
use crate::drive::transfer::Reading;
use crate::drive::watch::Memory;
use crate::outcome::{Column, Decimal, ErrorDoc, Record, RunNews, Sample, SampleValue};
use crate::profile::{Family, Param, Type};
use crate::tick::{Span, Tick};
use std::rc::Rc;

/// No two samples come sooner.
pub(super) const EVERY: Span = Span::from_millis(250);
/// Status word (5.1), setpoint and actual value (5.2) as words; and both as frequencies (5.3), which is what the Basic block tells.
const ZSW: u32 = 968;
const HSW: u32 = 700;
const HIW: u32 = 701;
const SETPOINT: u32 = 611;
const FREQUENCY: u32 = 614;

/// What is shown of a run.
#[derive(Debug)]
pub(super) struct Shown {
    pub(super) family: Rc<Family>,
    /// Status word, setpoint and actual value; no number names the status word of the Basic block.
    params: Vec<Param>,
    /// What 4000h is, in hundredths of the unit; `None` until it was measured.
    pub(super) maximum: Option<i64>,
    begun: Tick,
    told: Option<Tick>,
    samples: u64,
    /// What was seen of it before a fault.
    memory: Memory,
    news: RunNews,
    /// What was said of it last.
    said: RunNews,
}

impl Shown {
    /// Before anything was told.
    pub(super) fn new(
        family: Rc<Family>,
        is_basic: bool,
        maximum: Option<i64>,
        (begun, news): (Tick, RunNews),
    ) -> Self {
        let ids: &[u32] = if is_basic { &[SETPOINT, FREQUENCY] } else { &[ZSW, HSW, HIW] };
        let params = ids.iter().map(|&id| family.param_or_unknown(id)).collect();
        Shown {
            family,
            params,
            maximum,
            begun,
            told: None,
            samples: 0,
            memory: Memory::default(),
            said: news.clone(),
            news,
        }
    }

    /// Its columns.
    pub(super) fn columns(&self) -> Vec<Column> {
        let (data_set, store) = describe::place(0);
        let column = |param: &Param| Column {
            param: param.id,
            data_set,
            store: describe::kept(store, param),
            slug: param.slug.clone(),
            name: param.name.clone(),
            unit: self.news.unit.clone().filter(|_| param.id != ZSW),
            role: Some(match param.id {
                ZSW => "status-word",
                HSW | SETPOINT => "setpoint-bus",
                _ => "actual-frequency",
            }),
            scaled: true,
            is_word: param.id == ZSW,
        };
        self.params.iter().map(column).collect()
    }

    /// Where the run has come to, if that is news. `end` is that of its new part.
    pub(super) fn comes_to(&mut self, now: Tick, phase: &'static str, end: Option<Tick>) -> Option<RunNews> {
        let (begun, is_over) = (self.begun, matches!(phase, "stopping" | "ended"));
        self.changes(now, |news| {
            news.phase = phase;
            news.ends = end.map(|end| seconds(end.since(begun)));
            news.setpoint = news.setpoint.filter(|_| !is_over);
        })
    }

    /// The setpoint is led to this. It is told with the next sample: a way changes it in every cycle.
    pub(super) fn is_set(&mut self, raw: i64) {
        self.news.setpoint = Some(Decimal { raw, decimals: 2 });
    }

    /// By which way it is stopped, if that is news.
    pub(super) fn stops_by(&mut self, now: Tick, stop: &'static str) -> Option<RunNews> {
        self.changes(now, |news| news.stop = stop)
    }

    fn changes(&mut self, now: Tick, change: impl FnOnce(&mut RunNews)) -> Option<RunNews> {
        change(&mut self.news);
        self.untold(now)
    }

    /// What was not told of it yet.
    fn untold(&mut self, now: Tick) -> Option<RunNews> {
        let t = seconds(now.since(self.begun));
        let is_new = self.news != self.said;
        self.said.clone_from(&self.news);
        is_new.then(|| RunNews { t, ..self.news.clone() })
    }

    /// What a cycle told, or that nobody was heard, unless something was told a moment ago; a trip at once, with what was seen last before
    /// it. `setpoint` is what is sent.
    pub(super) fn sample(&mut self, now: Tick, setpoint: i64, heard: Result<Seen, ErrorDoc>) -> Vec<Record> {
        let (seen, error) = heard.map_or_else(|error| (None, Some(error)), |seen| (Some(seen), None));
        let state = seen.and_then(state::of);
        let is_early = self.told.is_some_and(|told| now.since(told) < EVERY);
        if is_early && !self.memory.is_new(state.as_ref()) {
            return Vec::new();
        }
        let t = seconds(now.since(self.begun));
        let sample = Sample {
            t,
            n: self.samples,
            port: None,
            address: self.news.address,
            node: 0,
            called: None,
            drive: self.family.drive.clone(),
            state,
            values: seen.map_or_else(Vec::new, |seen| self.values(t, setpoint, seen)),
            error,
            line: None,
        };
        (self.told, self.samples) = (Some(now), self.samples + 1);
        // A bit of ZSW names no cause.
        let cause = seen.filter(|seen| seen.state.is_some()).and_then(fault);
        let trip = self.memory.take(&sample, &self.family, cause.as_ref());
        let trip = trip.map(|trip| Record::Trip(Box::new(trip)));
        self.untold(now).map(Record::Run).into_iter().chain(trip).chain([Record::Sample(sample)]).collect()
    }

    fn values(&self, t: Decimal, setpoint: i64, seen: Seen) -> Vec<SampleValue> {
        // Nothing is nothing at every scale.
        let Some(maximum) = self.maximum.or((setpoint == 0 && seen.hiw == 0).then_some(0)) else { return Vec::new() };
        let value = |param: &Param| {
            let (raw, kind) = match param.id {
                ZSW => (i64::from(seen.zsw), Type::Uint),
                HSW | SETPOINT => (setpoint, Type::Int),
                _ => (i64::from(seen.hiw), Type::Int),
            };
            let reading = Reading { set: 0, raw, text: None, kind, corrected: false };
            let mut value = describe::value(self.news.address, &self.family, param, reading, &|_| None);
            match &mut value.word {
                Some(word) => {
                    word.state = state::of(seen);
                    word.bits.iter_mut().for_each(|bit| bit.help = None);
                }
                None => {
                    value.value = Some(Decimal { raw: raw * maximum / FULL, decimals: 2 });
                    value.unit.clone_from(&self.news.unit);
                }
            }
            SampleValue { t, value }
        };
        self.params.iter().map(value).collect()
    }
}

pub(super) fn seconds(span: Span) -> Decimal {
    Decimal { raw: i64::try_from(span.as_micros()).unwrap_or(i64::MAX), decimals: 6 }
}
