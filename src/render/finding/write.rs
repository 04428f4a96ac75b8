//! `write`: what became of each value.

use super::page::{Page, set_name, shown};
use super::{Finding, Row, list};
use crate::outcome::{Write, WriteResult, Written};

impl Finding for Write {
    fn table(&self, page: Page) -> String {
        page.written(&self.values)
    }

    fn rows(&self) -> Vec<Row> {
        list("written", &self.values)
    }
}

impl Page {
    pub(super) fn written(self, values: &[Written]) -> String {
        let rows = values.iter().map(|row| {
            let old = row.old.map_or_else(|| "?".to_owned(), |old| shown(old, false));
            let mut remark = row.error.as_ref().map(|error| error.message.get(self.lang).to_owned());
            remark = remark.or_else(|| row.text.as_ref().map(|text| self.say(text)));
            let note = row.note.as_ref().map(|note| self.say(note));
            let mut remark = remark.into_iter().chain(note).collect::<Vec<_>>();
            if row.result == WriteResult::Planned {
                remark.extend(row.telegram.clone());
                remark.extend(row.meaning.as_ref().map(|meaning| self.say(meaning)));
            }
            vec![
                row.address.to_string(),
                row.param.to_string(),
                set_name(row.data_set, row.store),
                row.store.to_owned(),
                self.say(&row.name),
                old,
                shown(row.value, false),
                row.unit.clone().unwrap_or_default(),
                self.word(result(row.result)).to_owned(),
                remark.join("; "),
            ]
        });
        let mut rows: Vec<Vec<String>> = rows.collect();
        let mut head = vec![">addr", ">param", "set", "store", "name", ">old", ">new", "unit", "result"];
        // A column that says nothing is none.
        match rows.iter().all(|row| row.last().is_some_and(String::is_empty)) {
            true => rows.iter_mut().for_each(|row| drop(row.pop())),
            false => head.push("meaning"),
        }
        self.table(&head, rows)
    }
}

pub(super) fn result(result: WriteResult) -> &'static str {
    match result {
        WriteResult::Verified => "verified",
        WriteResult::Written => "written",
        WriteResult::Stored => "stored only",
        WriteResult::Unchanged => "unchanged",
        WriteResult::Planned => "planned",
        WriteResult::Refused => "refused",
        WriteResult::Unknown => "unknown",
        WriteResult::Differs => "differs",
        WriteResult::Broadcast => "broadcast",
        WriteResult::Skipped => "skipped",
        WriteResult::Restored => "restored",
        WriteResult::Unrestored => "unrestored",
    }
}
