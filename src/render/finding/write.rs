//! `write`: what became of each value.

use super::page::{Page, set_name, shown};
use super::{Finding, Rows};
use crate::outcome::{Decimal, Write, WriteResult, Written, numbered};
use std::collections::BTreeSet;

impl Finding for Write {
    fn table(&self, page: Page) -> String {
        page.written(&self.values)
    }

    fn rows(&self) -> Rows {
        Rows::of("written", &self.values)
    }
}

impl Page {
    /// One row a value. On a terminal there is no room beside it for what is to be said of it.
    pub(super) fn written(self, values: &[Written]) -> String {
        if self.width.is_some() {
            return self.changes(values);
        }
        let rows = values.iter().map(|row| {
            let mut remark = row.error.as_ref().map(|error| error.message.get(self.lang).to_owned());
            remark = remark.or_else(|| row.text.as_ref().map(|text| self.say(text)));
            let note = row.note.as_ref().map(|note| self.say(note));
            let mut remark = remark.into_iter().chain(note).collect::<Vec<_>>();
            if is_planned(row) {
                remark.extend(row.telegram.clone());
                remark.extend(row.meaning.as_ref().map(|meaning| self.say(meaning)));
            }
            vec![
                self.address(row.address),
                numbered(row.param, row.index),
                set_name(row.data_set, row.store),
                self.word(row.store).to_owned(),
                self.say(&row.name),
                old(row),
                new(row),
                self.unit_of(row),
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

    /// The same on 80 columns: data sets that went the same way in one row, and what is odd about a value, or would be sent, below.
    pub(super) fn changes(self, values: &[Written]) -> String {
        let several = values.iter().any(|row| Some(row.address) != values.first().map(|first| first.address));
        let alike = values.chunk_by(|one, next| self.width.is_some() && are_alike(one, next));
        let alike: Vec<(&Written, &Written)> = alike.filter_map(|sets| Some((sets.first()?, sets.last()?))).collect();
        let rows = alike.iter().map(|(first, last)| self.change(first, last, several));
        let head = [">addr", ">param", "set", "name", ">old", ">new", "unit", "result"];
        let mut text = self.table(head.get(usize::from(!several)..).unwrap_or_default(), rows.collect());
        let sent = values.iter().any(|row| self.to_send(row).is_some());
        text += if sent { "\n" } else { "" };
        // A line of a file may be told of four data sets.
        let mut told = BTreeSet::new();
        let remarks = alike.iter().flat_map(|(first, last)| self.remarks(first, last));
        text + &remarks.filter(|remark| told.insert(remark.clone())).collect::<String>()
    }

    fn change(self, row: &Written, last: &Written, several: bool) -> Vec<String> {
        let address = several.then(|| self.address(row.address));
        let text = row.text.as_ref().map(|text| format!(" ({})", self.say(text)));
        let cells = [
            numbered(row.param, row.index),
            sets(row, last),
            self.say(&row.name),
            old(row),
            new(row) + &text.unwrap_or_default(),
            self.unit_of(row),
            self.word(result(row.result)).to_owned(),
        ];
        address.into_iter().chain(cells).collect()
    }

    /// The unit, or that the numbers are raw, because no source tells where their point stands.
    fn unit_of(self, row: &Written) -> String {
        let is_raw = row.value.is_none() && row.unit.is_some();
        if is_raw { self.word("raw").to_owned() } else { row.unit.clone().unwrap_or_default() }
    }

    /// Why a value did not go, what is odd about it, and the telegram of one that is only planned.
    fn remarks(self, row: &Written, last: &Written) -> Vec<String> {
        let place = format!("{}@{}", numbered(row.param, row.index), sets(row, last));
        let error = row.error.as_ref().map(|error| error.message.get(self.lang).to_owned());
        let note = row.note.as_ref().map(|note| self.say(note));
        let told = error.into_iter().chain(note).map(|told| match told.contains(&format!("P.{}", row.param)) {
            true => told,
            false => format!("{place}: {told}"),
        });
        let meaning = row.meaning.as_ref().map(|meaning| self.say(meaning)).unwrap_or_default();
        let sent = self.to_send(row).map(|telegram| format!("{telegram}  {meaning}"));
        told.chain(sent).map(|remark| self.prose(&remark)).collect()
    }

    /// What would be sent, where there is no room for it beside the value.
    fn to_send(self, row: &Written) -> Option<&str> {
        row.telegram.as_deref().filter(|_| is_planned(row) && self.width.is_some())
    }
}

/// The data sets of a row: `1`, `1-4`, `2ram`, or `ram` where there is but one.
fn sets(first: &Written, last: &Written) -> String {
    match (first.data_set, first.store) {
        (0, "ram") => "ram".to_owned(),
        (set, _) if set != last.data_set => format!("{set}-{}", set_name(last.data_set, last.store)),
        (set, store) => set_name(set, store),
    }
}

fn is_planned(row: &Written) -> bool {
    row.result == WriteResult::Planned
}

/// Whether a data set went the same way as the one before it, and the same is to be said of both.
fn are_alike(one: &Written, next: &Written) -> bool {
    let way = |row: &Written| (row.address, row.param, row.store, row.old_raw, row.raw, row.result);
    let said = |row: &Written| (row.error.as_ref().map(|error| error.message.clone()), row.note.clone());
    way(one) == way(next) && one.data_set + 1 == next.data_set && said(one) == said(next) && !is_planned(one)
}

fn old(row: &Written) -> String {
    row.old_raw.map_or_else(|| "?".to_owned(), |raw| digits(row.old, raw))
}

fn new(row: &Written) -> String {
    digits(row.value, row.raw)
}

fn digits(value: Option<Decimal>, raw: i64) -> String {
    value.map_or_else(|| raw.to_string(), |value| shown(value, false))
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
