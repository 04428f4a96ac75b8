//! Where failures stand among what was found.

use super::{Data, Dataset, ErrorDoc, Outcome};

impl Outcome {
    /// What is wrong with single drives and values: a hint among it may name a command.
    pub fn each_error(&mut self, work: &mut dyn FnMut(&mut ErrorDoc)) {
        self.data.iter_mut().flat_map(errors).for_each(work);
    }
}

fn errors(data: &mut Data) -> Vec<&mut ErrorDoc> {
    match data {
        Data::Identify(found) => found.drives.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Diag(found) => found.drives.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Statemachine(found) => found.drives.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Stops(found) => found.drives.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::LineCheck(found) => found.drives.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Read(found) => found.values.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Write(found) => found.values.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Load(found) => found.values.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Saves(found) => found.saved.iter_mut().filter_map(|one| one.error.as_mut()).collect(),
        Data::Comparisons(found) => {
            let each = found.comparisons.iter_mut();
            each.flat_map(|one| {
                one.error.iter_mut().chain(one.differences.iter_mut().filter_map(|row| row.error.as_mut()))
            })
            .collect()
        }
        Data::Sollwert(found) => {
            let each = found.drives.iter_mut();
            each.flat_map(|one| {
                one.error.iter_mut().chain(one.setpoints.iter_mut().filter_map(|row| row.error.as_mut()))
            })
            .collect()
        }
        Data::Plant(found) => {
            let each = found.drives.iter_mut();
            each.flat_map(|one| {
                one.error.iter_mut().chain(one.load.values.iter_mut().filter_map(|row| row.error.as_mut()))
            })
            .collect()
        }
        Data::PlantCheck(found) => {
            let each = found.drives.iter_mut().map(|one| &mut one.comparison);
            each.flat_map(|one| {
                one.error.iter_mut().chain(one.differences.iter_mut().filter_map(|row| row.error.as_mut()))
            })
            .collect()
        }
        Data::BusShow(found) => {
            let each = found.drives.iter_mut();
            each.flat_map(|one| one.error.iter_mut().chain(one.values.iter_mut().filter_map(|row| row.error.as_mut())))
                .collect()
        }
        Data::Dataset(found) => of_sets(found).collect(),
        Data::Datasets(found) => found.drives.iter_mut().flat_map(of_sets).collect(),
        _ => Vec::new(),
    }
}

fn of_sets(found: &mut Dataset) -> impl Iterator<Item = &mut ErrorDoc> {
    let Dataset { error, rows, written, .. } = found;
    let values = rows.iter_mut().flat_map(|row| &mut row.values).filter_map(|value| value.error.as_mut());
    error.iter_mut().chain(values).chain(written.iter_mut().filter_map(|row| row.error.as_mut()))
}
