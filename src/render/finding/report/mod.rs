//! `report`: a few lines for a terminal, and the whole of it on paper, in HTML or Markdown.

mod drive;
mod html;
mod markdown;
mod paper;
mod procedure;
mod whole;

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Form, Report, ReportedDrive};
use crate::profile::Lang;
use crate::render::clean;

/// A report as the text of a file.
pub fn sheet(report: &Report, form: Form, lang: Lang) -> String {
    let paper = Page { lang, width: None, full: false, node: 0 }.paper(report);
    match form {
        Form::Html => html::print(&paper),
        Form::Markdown => markdown::print(&paper),
    }
}

impl Finding for Report {
    fn table(&self, page: Page) -> String {
        // A screen has no room for the warnings beside the rest; `diag` shows them.
        let shown = |nth: &usize| OVERVIEW.get(*nth) != Some(&"warnings");
        let head: Vec<&str> = (0..OVERVIEW.len()).filter(shown).filter_map(|nth| OVERVIEW.get(nth).copied()).collect();
        let row = |drive| {
            let cells = page.in_a_line(drive).into_iter().enumerate();
            cells.filter(|(nth, _)| shown(nth)).map(|(_, cell)| cell).collect()
        };
        let mut text = page.table(&head, self.drives.iter().map(row).collect());
        if let Some(check) = &self.line {
            text += "\n";
            text += &page.advice(check);
        }
        if !self.files.is_empty() {
            text += "\n";
            text +=
                &self.files.iter().map(|file| format!("{}: {}\n", page.word("file"), clean(file))).collect::<String>();
        }
        text
    }

    fn rows(&self) -> Rows {
        let values: Vec<_> = self.drives.iter().flat_map(|drive| &drive.values).collect();
        let failed: Vec<_> = self.drives.iter().filter(|drive| drive.values.is_empty()).collect();
        let failed = Rows::of("drive", &failed).without_lists().without(&["identity", "diagnosis"]);
        Rows::of("value", &values).and(failed)
    }
}

/// What the overview tells of each drive.
const OVERVIEW: [&str; 7] = [">addr", "drive", "state", "fault", "warnings", ">not factory", "signature"];

impl Page {
    /// A drive in a line.
    fn in_a_line(self, drive: &ReportedDrive) -> Vec<String> {
        let none = || "-".to_owned();
        let family = self.family(&drive.drive);
        let name = drive.called.as_ref().map_or_else(|| family.to_owned(), |called| format!("{called} ({family})"));
        let mut row = vec![self.address(drive.address), name];
        match (&drive.diagnosis, &drive.error) {
            (Some(found), _) => {
                let state = found.status.as_ref().and_then(|word| word.state.as_ref());
                row.push(state.map_or_else(none, |state| self.say(&state.name)));
                row.push(self.present(found));
                row.push(found.warnings.as_ref().map_or_else(none, |word| self.set_bits(word)));
                row.push(format!("{}/{}", drive.differences.len(), drive.compared));
                row.push(drive.signature.clone().unwrap_or_else(none));
            }
            (None, error) => {
                row.push(error.as_ref().map_or_else(none, |error| self.say(&error.message)));
                row.extend((0..4).map(|_| none()));
            }
        }
        row
    }
}
