//! What was found of drives on several lines: one table of values, otherwise a part for each line.

use super::page::Page;
use super::{Finding, Rows, of};
use crate::outcome::{Data, OnLine, OverLines, Value};

impl Finding for OverLines {
    fn table(&self, page: Page) -> String {
        page.over_lines(self)
    }

    fn rows(&self) -> Rows {
        let named = |line: &OnLine| of(&line.data).rows().of_drives(&line.port, |fields| line.called(fields).cloned());
        let found = self.lines.iter().map(named).fold(Rows::default(), Rows::and);
        if self.unreached.is_empty() { found } else { found.and(Rows::of("unreached", &self.unreached)) }
    }
}

impl Page {
    fn over_lines(self, found: &OverLines) -> String {
        let values: Option<Vec<_>> = found.lines.iter().map(read).collect();
        let mut text = match values {
            Some(values) => {
                let drives = found.lines.iter().map(|line| vec![line.port.clone(), self.drives(line)]).collect();
                self.table(&["port", "drives"], drives) + "\n" + &self.values_of(&values.concat())
            }
            None => {
                let part = |line: &OnLine| {
                    self.prose(&format!("{}: {}", line.port, self.drives(line))) + &of(&line.data).table(self)
                };
                found.lines.iter().map(part).collect::<Vec<_>>().join("\n")
            }
        };
        let unreached = found.unreached.iter();
        let rows = unreached.map(|one| {
            vec![one.called.clone(), one.port.clone(), one.address.to_string(), self.say(&one.error.message)]
        });
        let rows: Vec<_> = rows.collect();
        text += if rows.is_empty() { "" } else { "\n" };
        text + &self.table(&["drive", "port", ">addr", "error"], rows)
    }

    /// The drives of a line: `pump (1), fan (2)`.
    fn drives(self, line: &OnLine) -> String {
        let told = line.addresses();
        let drives = line.names.iter().filter(|(address, _)| told.contains(address));
        drives.map(|(address, name)| format!("{name} ({address})")).collect::<Vec<_>>().join(", ")
    }
}

/// The values that were read on a line, each with the name of its drive; `None` if something else was found.
fn read(line: &OnLine) -> Option<Vec<(Option<&str>, &Value)>> {
    let Data::Read(read) = &line.data else { return None };
    let called = |value: &Value| line.names.get(&value.address).map(String::as_str);
    Some(read.values.iter().map(|value| (called(value), value)).collect())
}
