//! What was seen of a drive last before a fault.

use crate::drive::describe;
use crate::outcome::{Before, Fault, Sample, State, Trip, Value, addressed};
use crate::profile::Family;
use crate::profile::value::format_decimal;
use crate::text::{Text, both};

/// What was seen of a drive so far.
#[derive(Debug, Default)]
pub(in crate::drive) struct Memory {
    before: Before,
    /// Whether a fault was present at the last look.
    faulty: Option<bool>,
}

impl Memory {
    /// Takes a sample; what is to be told if the drive went into a fault with it. A fault that was there at the first look came
    /// before anybody looked. `told` is what ails it, where no value tells that.
    pub(in crate::drive) fn take(&mut self, sample: &Sample, family: &Family, told: Option<&Fault>) -> Option<Trip> {
        let word = sample.values.iter().find_map(|row| row.value.word.as_ref().filter(|word| word.state.is_some()));
        let fault = family.role("fault").and_then(|param| {
            let row = sample.values.iter().find(|row| row.value.param == param.id)?;
            u32::try_from(row.value.raw?).ok()
        });
        let code = fault.and_then(|code| family.present_fault(word.map(|word| word.raw), code));
        let in_fault = sample.state.as_ref().map(|state| state.slug.starts_with("fault"));
        let now = in_fault.or_else(|| fault.map(|_| code.is_some()))?;
        let before = self.faulty.replace(now);
        if !now {
            self.keep(sample);
        }
        (now && before == Some(false)).then(|| Trip {
            t: sample.t,
            address: sample.address,
            node: sample.node,
            fault: code.and_then(|code| describe::fault(family, code)).or_else(|| told.cloned()),
            before: self.before.clone(),
        })
    }

    /// Whether this state is that of a fault which was not there before.
    pub(in crate::drive) fn is_new(&self, state: Option<&State>) -> bool {
        self.faulty == Some(false) && state.is_some_and(|state| state.slug.starts_with("fault"))
    }

    /// Of each value the last one that could be read.
    fn keep(&mut self, sample: &Sample) {
        self.before.state = sample.state.clone().or(self.before.state.take());
        for row in sample.values.iter().filter(|row| row.value.raw.is_some()) {
            match self.before.values.iter_mut().find(|old| place(&old.value) == place(&row.value)) {
                Some(old) => *old = row.clone(),
                None => self.before.values.push(row.clone()),
            }
        }
    }
}

/// Which value it is.
fn place(value: &Value) -> (u32, u8, &'static str) {
    (value.param, value.data_set, value.store)
}

/// A drive that went into a fault, for people.
pub(super) fn told(trip: &Trip) -> Text {
    let Trip { t, address, node, fault, before } = trip;
    let address = addressed(*address, *node);
    let t = format_decimal(t.raw / 1_000, 3);
    let fault = fault.as_ref().map_or_else(|| both!("fault", "Störung"), |fault| fault.told());
    let values = before.values.iter().filter_map(|row| {
        let Value { name, value, unit, .. } = &row.value;
        let (value, unit) = (value.as_ref()?, unit.as_ref()?);
        let value = format_decimal(value.raw, value.decimals);
        Some(both!("{name} {value} {unit}", "{name} {value} {unit}", name))
    });
    let state = before.state.iter().map(|state| state.name.clone());
    let seen: Vec<Text> = state.chain(values).collect();
    if seen.is_empty() {
        return both!("address {address} at {t} s: {fault}", "Adresse {address} bei {t} s: {fault}", fault);
    }
    both!(
        "address {address} at {t} s: {fault}; seen last before it: {seen}",
        "Adresse {address} bei {t} s: {fault}; zuletzt davor gesehen: {seen}",
        fault,
        seen = Text::join(&seen, ", ")
    )
}
