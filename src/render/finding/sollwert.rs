//! `sollwert`: setpoints and actual values.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{SetpointReport, Sollwert};

impl Finding for Sollwert {
    fn table(&self, page: Page) -> String {
        page.each(&self.drives, Page::setpoints)
    }

    fn rows(&self) -> Rows {
        let parts = |drive: &SetpointReport| {
            [&drive.setpoints, &drive.actual, &drive.sources].map(|part| Rows::of("value", part))
        };
        let values = self.drives.iter().flat_map(parts).fold(Rows::default(), Rows::and);
        // A drive that failed has no values, but must not be missing.
        values.and(Rows::of("drive", &self.drives.iter().filter(|drive| drive.error.is_some()).collect::<Vec<_>>()))
    }
}

impl Page {
    fn setpoints(self, report: &SetpointReport) -> String {
        let mut text = self.heading(report.address, &report.drive);
        if let Some(error) = &report.error {
            return text + &self.prose(error.message.get(self.lang));
        }
        for (name, values) in
            [("setpoints", &report.setpoints), ("actual values", &report.actual), ("sources", &report.sources)]
        {
            text += &format!("\n{}\n", self.word(name));
            text += &self.values(values);
        }
        text
    }
}
