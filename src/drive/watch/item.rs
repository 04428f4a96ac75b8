//! A parameter that is watched, and what came of reading it.

use crate::drive::{Reader, describe};
use crate::failure::Failure;
use crate::outcome::{Column, Value};
use crate::profile::{DataSets, Family, Param, Selection, Store};

/// A parameter that is watched in one drive.
#[derive(Clone, Debug)]
pub struct Item {
    param: Param,
    sets: DataSets,
    /// Not every drive needs to have it.
    pub(in crate::drive) lenient: bool,
    /// Values that were read.
    pub(super) good: u64,
    /// What went wrong last.
    pub(super) failure: Option<Failure>,
    /// It went wrong in this round.
    pub(super) failed: bool,
    /// The drive does not have it; it is not asked for again.
    pub(super) refused: Option<Failure>,
    /// A word of which this raw value is 100 %, which no catalogue tells.
    full: Option<i64>,
}

impl Item {
    /// Nothing of it was read yet.
    pub fn new(selection: Selection) -> Self {
        let Selection { param, sets, of_group, .. } = selection;
        Item { param, sets, lenient: of_group, good: 0, failure: None, failed: false, refused: None, full: None }
    }

    /// The parameter.
    pub fn param(&self) -> &Param {
        &self.param
    }

    /// The data sets that are watched.
    pub fn sets(&self) -> DataSets {
        self.sets
    }

    /// The same word as a part of this raw value, in percent.
    pub(in crate::drive) fn part_of(self, full: i64) -> Self {
        Item { full: Some(full), ..self }
    }

    /// The same of another parameter.
    pub(in crate::drive) fn moved_to(self, param: Param) -> Self {
        Item { param, ..self }
    }

    /// Raw value of 100 %, of a word that is a part.
    pub(in crate::drive) fn full(&self) -> Option<i64> {
        self.full
    }

    /// Whether it is one value, without data sets, that the drive has.
    pub(super) fn is_plain(&self) -> bool {
        self.sets == DataSets::Unnamed && self.refused.is_none()
    }

    pub(super) async fn read(&mut self, reader: &mut Reader<'_, '_>) -> Result<Vec<Value>, Failure> {
        reader.lenient = self.lenient;
        let rows = reader.rows(&self.param, self.sets).await?;
        let (failure, forgiven) = (reader.failures.drain(..).next(), reader.forgiven.drain(..).next());
        self.came(&rows, failure, forgiven);
        // The four sets differ, so there is no value of all of them: from now on each is asked for.
        if rows.len() > self.sets.wire().len() {
            self.sets = match self.sets {
                DataSets::One(_, store) | DataSets::All(store) => DataSets::All(store),
                DataSets::Unnamed => DataSets::All(Store::Eeprom),
            };
        }
        Ok(rows)
    }

    /// What came of reading it; what is forgiven is a parameter that a drive has not.
    pub(in crate::drive) fn came(&mut self, rows: &[Value], failure: Option<Failure>, forgiven: Option<Failure>) {
        self.good += rows.iter().filter(|row| row.error.is_none()).count() as u64;
        self.failed = failure.is_some();
        self.refused = forgiven.filter(|_| self.good == 0);
        self.failure = failure.or_else(|| self.refused.clone()).or_else(|| self.failure.take());
    }

    /// The rows of this parameter when it cannot be read.
    pub(super) fn unread(&self, station: u8, family: &Family, failure: &Failure) -> Vec<Value> {
        let sets = self.sets.wire().into_iter();
        sets.map(|set| describe::unread(station, family, &self.param, set, failure)).collect()
    }

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
                is_word: family.is_word(param),
            }
        };
        self.sets.wire().into_iter().map(column).collect()
    }
}

/// What every family has, in the order of the default view.
const ROLES: [&str; 13] = [
    "status-word",
    "setpoint-ramp",
    "actual-frequency",
    "stator-frequency",
    "encoder-frequency",
    "actual-speed",
    "position",
    "current",
    "dc-link-voltage",
    "fault",
    "warnings",
    "setpoint-bus",
    "setpoint-velocity",
];
