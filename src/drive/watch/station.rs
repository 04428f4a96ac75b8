//! A drive that is watched, and what of it.

use super::item::Item;
use super::trigger::Armed;
use super::trip::Memory;
use super::{Place, Watch};
use crate::drive::{Reader, Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::{Record, Sample, SampleValue, TriggerNews, Value, Warning};
use crate::tick::Tick;

/// A drive that is watched.
pub(super) struct Station {
    pub(super) place: Place,
    pub(super) target: Option<Target>,
    /// What is read of it; until it is recognised, what any drive of its kind would have.
    pub(super) items: Vec<Item>,
    /// It did not answer in the last round: since when.
    pub(super) silent: Option<Tick>,
    /// It is no drive that we know.
    pub(super) out: Option<Failure>,
    /// Values that were read.
    pub(super) good: u64,
    /// Why there is none.
    pub(super) failure: Option<Failure>,
    asked_widths: Vec<u32>,
    /// What is waited for in it.
    armed: Vec<Armed>,
    memory: Memory,
}

/// What came of asking one drive.
pub(super) struct Haul {
    pub(super) values: Vec<SampleValue>,
    pub(super) warnings: Vec<Warning>,
    /// The first thing that went wrong.
    pub(super) failure: Option<Failure>,
}

impl Station {
    pub(super) fn new(place: Place, items: Vec<Item>) -> Self {
        Station {
            place,
            target: None,
            items,
            silent: None,
            out: None,
            good: 0,
            failure: None,
            asked_widths: Vec::new(),
            armed: Vec::new(),
            memory: Memory::default(),
        }
    }

    /// What a sample shows that is told before it: that the drive went into a fault, and each trigger that came true.
    pub(super) fn news(&mut self, sample: &Sample) -> Vec<Record> {
        let Some(family) = self.target.as_ref().map(|target| target.family.clone()) else { return Vec::new() };
        let trip = self.memory.take(sample, &family).map(|trip| Record::Trip(Box::new(trip)));
        let (t, address) = (sample.t, sample.address);
        let triggers = self.armed.iter_mut().filter_map(|armed| {
            let is_true = armed.comes_true(sample);
            is_true.then(|| Record::Trigger(TriggerNews { t, n: 0, address, trigger: armed.text.clone() }))
        });
        trip.into_iter().chain(triggers).collect()
    }

    /// Recognises the drive if that was not done yet, then reads what is watched. A silent drive is not asked further.
    pub(super) async fn read(&mut self, session: &mut Session<'_>, watch: &Watch<'_>) -> Result<Haul, Failure> {
        if self.target.is_none() {
            let shows_register = self.items.iter().any(|item| item.param().slug == "error-register");
            let target = watch.terms.target(session, self.place.address, shows_register).await?;
            let chosen = (watch.select)(&target.family)?;
            self.items = chosen.items;
            self.armed = chosen.waited_for.into_iter().map(|one| Armed::new(one, &target.family)).collect();
            self.target = Some(target);
        }
        let mut haul = Haul { values: Vec::new(), warnings: Vec::new(), failure: None };
        let Some(target) = &mut self.target else { return Ok(haul) };
        let family = target.family.clone();
        let mut reader = Reader::new(session, target);
        reader.asked_widths = std::mem::take(&mut self.asked_widths);
        let mut silence: Option<Failure> = None;
        for item in &mut self.items {
            let rows = match silence.as_ref().or(item.refused.as_ref()) {
                Some(failure) => item.unread(self.place.address, &family, failure),
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

/// A stream repeats its values for ever; what bits mean and what to do about them is told by `params`.
fn terse(mut value: Value) -> Value {
    if let Some(word) = &mut value.word {
        word.bits.iter_mut().for_each(|bit| bit.help = None);
    }
    value
}
