//! A drive that is watched, and what of it.

use super::Watch;
use crate::drive::{Reader, Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::outcome::{Column, SampleValue, Value, Warning};
use crate::profile::{DataSets, Family, Param, Selection, Store};
use crate::tick::Tick;

/// A parameter that is watched in one drive.
#[derive(Clone, Debug)]
pub struct Item {
    param: Param,
    sets: DataSets,
    /// Not every drive needs to have it.
    pub(super) lenient: bool,
    /// Values that were read.
    pub(super) good: u64,
    /// What went wrong last.
    pub(super) failure: Option<Failure>,
    /// It went wrong in this round.
    failed: bool,
    /// The drive does not have it; it is not asked for again.
    refused: Option<Failure>,
}

impl Item {
    /// Nothing of it was read yet.
    pub fn new(selection: Selection) -> Self {
        let Selection { param, sets, of_group } = selection;
        Item { param, sets, lenient: of_group, good: 0, failure: None, failed: false, refused: None }
    }

    /// The parameter.
    pub fn param(&self) -> &Param {
        &self.param
    }

    /// The data sets that are watched.
    pub fn sets(&self) -> DataSets {
        self.sets
    }

    async fn read(&mut self, reader: &mut Reader<'_, '_>) -> Result<Vec<Value>, Failure> {
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
    pub(super) fn unread(&self, station: u8, family: &Family, failure: &Failure) -> Vec<Value> {
        let sets = self.sets.wire().into_iter();
        sets.map(|set| describe::unread(station, family, &self.param, set, failure)).collect()
    }
}

/// A drive that is watched.
pub(super) struct Station {
    pub(super) address: u8,
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
}

/// What came of asking one drive.
pub(super) struct Haul {
    pub(super) values: Vec<SampleValue>,
    pub(super) warnings: Vec<Warning>,
    /// The first thing that went wrong.
    pub(super) failure: Option<Failure>,
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

impl Station {
    pub(super) fn new(address: u8, items: Vec<Item>) -> Self {
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
    pub(super) async fn read(&mut self, session: &mut Session<'_>, watch: &Watch<'_>) -> Result<Haul, Failure> {
        if self.target.is_none() {
            let shows_register = self.items.iter().any(|item| item.param.slug == "error-register");
            let target = watch.terms.target(session, self.address, shows_register).await?;
            self.items = (watch.select)(&target.family)?;
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
                Some(failure) => item.unread(self.address, &family, failure),
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
    pub(in crate::drive) fn columns(&self, family: &Family) -> Vec<Column> {
        let param = &self.param;
        let column = |set: u8| {
            let (data_set, store) = describe::place(set);
            Column {
                param: param.id,
                data_set,
                store: describe::kept(store, param),
                slug: param.slug.clone(),
                name: param.name.clone(),
                unit: param.unit.clone(),
                role: ROLES.into_iter().find(|role| family.role(role).is_some_and(|known| known.id == param.id)),
                scaled: param.has_scale(),
            }
        };
        self.sets.wire().into_iter().map(column).collect()
    }
}

/// A stream repeats its values for ever; what bits mean and what to do about them is told by `params`.
fn terse(mut value: Value) -> Value {
    if let Some(word) = &mut value.word {
        word.bits.iter_mut().for_each(|bit| bit.help = None);
    }
    value
}
