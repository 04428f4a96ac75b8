//! A drive that is watched, and what of it.

use super::item::Item;
use super::trigger::Armed;
use super::trip::Memory;
use super::{Chosen, Place};
use crate::drive::Target;
use crate::failure::Failure;
use crate::outcome::{Fault, Record, Sample, SampleValue, State, TriggerNews, Value, Warning};
use crate::tick::Tick;

/// A drive that is watched.
pub(in crate::drive) struct Station {
    pub(in crate::drive) place: Place,
    pub(in crate::drive) target: Option<Target>,
    /// What is read of it; until it is recognised, what any drive of its kind would have.
    pub(in crate::drive) items: Vec<Item>,
    /// It did not answer in the last round: since when.
    pub(super) silent: Option<Tick>,
    /// It is no drive that we know.
    pub(super) out: Option<Failure>,
    /// Values that were read.
    pub(super) good: u64,
    /// Why there is none.
    pub(super) failure: Option<Failure>,
    pub(super) asked_widths: Vec<u32>,
    /// What is waited for in it.
    armed: Vec<Armed>,
    pub(super) memory: Memory,
    /// What ails it now, where no value tells that.
    pub(in crate::drive) fault: Option<Fault>,
}

/// What came of asking one drive.
#[derive(Default)]
pub(in crate::drive) struct Haul {
    pub(in crate::drive) values: Vec<SampleValue>,
    /// What it does, where no value tells that.
    pub(in crate::drive) state: Option<State>,
    pub(in crate::drive) warnings: Vec<Warning>,
    /// The first thing that went wrong.
    pub(in crate::drive) failure: Option<Failure>,
}

impl Station {
    pub(in crate::drive) fn new(place: Place, items: Vec<Item>) -> Self {
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
            fault: None,
        }
    }

    /// It turns out to be this drive, of which this is watched.
    pub(in crate::drive) fn is(&mut self, target: Target, chosen: Chosen) {
        self.items = chosen.items;
        self.armed = chosen.waited_for.into_iter().map(|one| Armed::new(one, &target.family)).collect();
        self.target = Some(target);
    }

    /// What a sample shows that is told before it: that the drive went into a fault, and each trigger that came true.
    pub(super) fn news(&mut self, sample: &Sample) -> Vec<Record> {
        let Some(family) = self.target.as_ref().map(|target| target.family.clone()) else { return Vec::new() };
        let trip = self.memory.take(sample, &family, self.fault.as_ref()).map(|trip| Record::Trip(Box::new(trip)));
        let (t, address, node) = (sample.t, sample.address, sample.node);
        let triggers = self.armed.iter_mut().filter_map(|armed| {
            let is_true = armed.comes_true(sample);
            is_true.then(|| Record::Trigger(TriggerNews { t, n: 0, address, node, trigger: armed.text.clone() }))
        });
        trip.into_iter().chain(triggers).collect()
    }
}

/// A stream repeats its values for ever; what bits mean and what to do about them is told by `params`.
pub(in crate::drive) fn terse(mut value: Value) -> Value {
    if let Some(word) = &mut value.word {
        word.bits.iter_mut().for_each(|bit| bit.help = None);
    }
    value
}
