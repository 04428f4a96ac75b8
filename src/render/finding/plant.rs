//! `plan`, `apply`, `check`, `init`: the drives of a plant.

use super::page::Page;
use super::paramfile::compared;
use super::{Finding, Rows};
use crate::outcome::{
    Init, NamedFind, Plant, PlantCheck, PlantComparison, PlantDrive, PlantState, WriteResult, Written, addressed,
};
use crate::render::clean;

impl Finding for Plant {
    fn table(&self, page: Page) -> String {
        page.plant(self)
    }

    fn rows(&self) -> Rows {
        let of = |drive: &PlantDrive| {
            let whole = Rows::of("drive", &[drive]).without_lists();
            of_drive(&drive.called, &drive.port, whole.and(Rows::of("written", &drive.load.values)))
        };
        self.drives.iter().map(of).fold(Rows::default(), Rows::and)
    }
}

impl Finding for PlantCheck {
    fn table(&self, page: Page) -> String {
        page.plant_check(self)
    }

    fn rows(&self) -> Rows {
        let of = |one: &PlantComparison| {
            let rows = compared("drive", one, &one.comparison).under("address", &one.address.into());
            of_drive(&one.called, &one.port, rows)
        };
        self.drives.iter().map(of).fold(Rows::default(), Rows::and)
    }
}

impl Finding for Init {
    fn table(&self, page: Page) -> String {
        let ports: Vec<&str> = self.drives.iter().map(|drive| drive.found.port.as_str()).collect();
        let rows = self.drives.iter().map(|NamedFind { called, found }| {
            let family = page.family(&found.drive).to_owned();
            vec![called.clone(), found.address.to_string(), family, found.line.clone(), found.protocol.clone()]
        });
        let file = self.project.clone().unwrap_or_else(|| page.word("none").to_owned());
        let mut text =
            page.overview(Some(&file), &ports, &["name", ">addr", "drive", "line", "protocol"], rows.collect());
        if !self.unknown.is_empty() {
            text += &format!("\n{}\n", page.word("not recognised"));
            let rows = self.unknown.iter();
            let rows = rows.map(|found| vec![found.address.to_string(), page.say(&found.title), found.port.clone()]);
            text += &page.table(&[">addr", "", "port"], rows.collect());
        }
        text
    }

    fn rows(&self) -> Rows {
        Rows::of("drive", &self.drives).and(Rows::of("unknown", &self.unknown)).without_lists()
    }
}

/// A drive in a plant and what is told of it: each row says of which.
fn of_drive(called: &str, port: &str, rows: Rows) -> Rows {
    rows.under("port", &port.into()).under("called", &called.into())
}

impl Page {
    /// First every drive in a line, then those in which something changes or went wrong.
    fn plant(self, plant: &Plant) -> String {
        // Before something is written it is told how much would be, behind that how much was.
        let is_over = plant.drives.iter().any(|drive| has_begun(drive.state));
        let due = |result: WriteResult| if is_over { was_written(result) } else { result != WriteResult::Unchanged };
        let rows = plant.drives.iter().map(|drive| {
            let load = &drive.load;
            let count =
                |result: &dyn Fn(WriteResult) -> bool| load.values.iter().filter(|row| result(row.result)).count();
            vec![
                drive.called.clone(),
                addressed(load.address, load.node),
                self.family(&load.drive).to_owned(),
                self.word(state(drive.state)).to_owned(),
                count(&due).to_string(),
                count(&|result| result == WriteResult::Unchanged).to_string(),
            ]
        });
        let written = if is_over { ">written" } else { ">to write" };
        let head = ["name", ">addr", "drive", "state", written, ">equal"];
        let ports: Vec<&str> = plant.drives.iter().map(|drive| drive.port.as_str()).collect();
        let mut text = self.overview(plant.project.as_deref(), &ports, &head, rows.collect());
        text += &self.unnamed(plant.drives.iter().map(|drive| &drive.load));
        let is_told = |drive: &&PlantDrive| self.full || drive.state != PlantState::Same;
        for drive in plant.drives.iter().filter(is_told) {
            text += &format!("\n{}: ", clean(&drive.called));
            text += &match self.full || plant.dry_run {
                true => self.load(&drive.load),
                false => self.load_head(&drive.load) + &self.changed(&drive.load.values),
            };
            if let Some(error) = &drive.error {
                text += &self.pairs(vec![("error", self.say(&error.message))]);
            }
        }
        text + &self.closing(plant.drives.iter().map(|drive| &drive.load))
    }

    /// What changes of a drive.
    fn changed(self, values: &[Written]) -> String {
        let changed = values.iter().filter(|row| row.result != WriteResult::Unchanged);
        // What would be sent is told by a dry run.
        let changed: Vec<Written> = changed.map(|row| Written { telegram: None, ..row.clone() }).collect();
        if changed.is_empty() { String::new() } else { format!("\n{}", self.changes(&changed)) }
    }

    /// Every drive in a line; the port only if there are several.
    fn overview(self, project: Option<&str>, ports: &[&str], head: &[&str], mut rows: Vec<Vec<String>>) -> String {
        let mut pairs: Vec<_> = project.map(|project| ("file", project.to_owned())).into_iter().collect();
        let mut head = head.to_vec();
        match ports.first().filter(|first| ports.iter().all(|port| port == *first)) {
            Some(port) => pairs.push(("port", (*port).to_owned())),
            None => {
                head.insert(1, "port");
                rows.iter_mut().zip(ports).for_each(|(row, port)| row.insert(1, (*port).to_owned()));
            }
        }
        self.pairs(pairs) + "\n" + &self.table(&head, rows)
    }

    fn plant_check(self, check: &PlantCheck) -> String {
        let rows = check.drives.iter().map(|one| {
            let stands = match one.comparison.equal {
                Some(true) => "equal",
                Some(false) => "different",
                None => "unknown",
            };
            vec![
                one.called.clone(),
                addressed(one.address, one.comparison.b.node),
                self.family(&one.comparison.b.drive).to_owned(),
                self.word(stands).to_owned(),
                one.comparison.compared.to_string(),
                one.comparison.differences.iter().filter(|row| row.error.is_none()).count().to_string(),
            ]
        });
        let head = ["name", ">addr", "drive", "state", ">compared", ">different"];
        let ports: Vec<&str> = check.drives.iter().map(|one| one.port.as_str()).collect();
        let mut text = self.overview(Some(&check.project), &ports, &head, rows.collect());
        for one in check.drives.iter().filter(|one| self.full || one.comparison.equal != Some(true)) {
            text += &format!("\n{}:\n", clean(&one.called));
            text += &self.comparison(&one.comparison);
        }
        text
    }
}

/// Whether something was written to a drive, whatever became of it.
fn has_begun(state: PlantState) -> bool {
    use PlantState::{Back, Done, Stored, Torn};
    matches!(state, Done | Stored | Back | Torn)
}

/// Whether a value went into the drive, and perhaps back.
fn was_written(result: WriteResult) -> bool {
    use WriteResult::{Differs, Restored, Stored, Unknown, Unrestored, Verified, Written};
    matches!(result, Verified | Written | Stored | Unknown | Differs | Restored | Unrestored)
}

fn state(state: PlantState) -> &'static str {
    match state {
        PlantState::Same => "equal",
        PlantState::Planned => "planned",
        PlantState::Done => "done",
        PlantState::Stored => "stored, not all in force",
        PlantState::Skipped => "skipped",
        PlantState::Untouched => "nothing was changed",
        PlantState::Back => "as before, proven",
        PlantState::Torn => "NOT as before",
    }
}
