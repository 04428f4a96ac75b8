//! `write`: what became of each value.

use super::page::{Page, set_name, shown};
use super::{Finding, Rows};
use crate::outcome::{Write, WriteResult, Written};

impl Finding for Write {
    fn table(&self, page: Page) -> String {
        page.written(&self.values)
    }

    fn rows(&self) -> Rows {
        Rows::of("written", &self.values)
    }
}

impl Page {
    pub(super) fn written(self, values: &[Written]) -> String {
        // On a terminal a telegram has no room beside its value.
        let is_planned = |row: &Written| row.result == WriteResult::Planned;
        let apart = self.width.is_some();
        let rows = values.iter().map(|row| {
            let old = row.old.map_or_else(|| "?".to_owned(), |old| shown(old, false));
            let mut remark = row.error.as_ref().map(|error| error.message.get(self.lang).to_owned());
            remark = remark.or_else(|| row.text.as_ref().map(|text| self.say(text)));
            let note = row.note.as_ref().map(|note| self.say(note));
            let mut remark = remark.into_iter().chain(note).collect::<Vec<_>>();
            if is_planned(row) && !apart {
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
        let told = values.iter().filter(|row| apart && is_planned(row)).filter_map(|row| {
            let meaning = row.meaning.as_ref().map(|meaning| self.say(meaning)).unwrap_or_default();
            Some(self.prose(&format!("{}  {meaning}", row.telegram.as_ref()?)))
        });
        let told: String = told.collect();
        let gap = if told.is_empty() { "" } else { "\n" };
        self.table(&head, rows) + gap + &told
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
