//! `scan`: who answered.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{FoundDrive, Scan};

impl Finding for Scan {
    fn table(&self, page: Page) -> String {
        page.scan(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("drive", &self.drives)
    }
}

impl Page {
    fn scan(self, scan: &Scan) -> String {
        let several = |of: fn(&FoundDrive) -> &String| {
            scan.drives.iter().any(|drive| Some(of(drive)) != scan.drives.first().map(of))
        };
        let shows_port = several(|drive| &drive.port);
        let shows_line = [&scan.line, &scan.protocol].contains(&&"auto".to_owned())
            || several(|drive| &drive.line)
            || several(|drive| &drive.protocol);
        let row = |drive: &FoundDrive| {
            let mut row = if shows_port { vec![drive.port.clone()] } else { Vec::new() };
            if shows_line {
                row.extend([drive.line.clone(), drive.protocol.clone()]);
            }
            row.extend([
                drive.address.to_string(),
                self.family(&drive.drive).to_owned(),
                drive.title.get(self.lang).to_owned(),
                self.say_or_not(drive.state.as_ref().map(|state| &state.name)),
                drive.fault.as_ref().map_or_else(|| "-".to_owned(), |fault| self.say(fault)),
                drive
                    .warnings
                    .as_ref()
                    .map_or_else(|| "-".to_owned(), |warnings| self.first_of(warnings.get(self.lang))),
            ]);
            let told = drive.evidence.last().filter(|_| self.full);
            row.extend(told.map(|row| format!("{}: {}", self.say(&row.asked), self.say(&row.answered))));
            row
        };
        let mut rows: Vec<_> = scan.drives.iter().map(row).collect();
        let mut head = if shows_port { vec!["port"] } else { Vec::new() };
        if shows_line {
            head.extend(["=line", "protocol"]);
        }
        head.extend([">addr", "drive", "name", "=state", "fault", "warnings"]);
        if self.full {
            head.push("evidence");
        }
        // What it is called its family says too: where a drive takes more than a line with it, it goes.
        let whole: Vec<_> = head.iter().map(|name| format!("={}", name.trim_start_matches(['>', '=']))).collect();
        let whole: Vec<&str> = whole.iter().map(String::as_str).collect();
        if let Some(name) =
            head.iter().position(|name| *name == "name").filter(|_| !self.full && !self.has_room(&whole, &rows))
        {
            head.remove(name);
            rows.iter_mut().for_each(|row| drop(row.remove(name)));
        }
        // Of a fault its code is enough to look it up; a torn word is not.
        if let Some(fault) =
            head.iter().position(|name| *name == "fault").filter(|_| !self.full && !self.has_room(&head, &rows))
        {
            for cell in rows.iter_mut().filter_map(|row| row.get_mut(fault)) {
                *cell = cell.split(' ').next().unwrap_or_default().to_owned();
            }
        }
        self.yielding(&head, rows, &["protocol"])
    }
}
