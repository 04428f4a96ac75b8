//! `dataset load`, `dataset undo`: what became of each value.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Load, LoadEnd, NotLoadedWhy, WriteResult, Written};
use std::collections::BTreeSet;

impl Finding for Load {
    fn table(&self, page: Page) -> String {
        page.load(self) + &page.closing([self])
    }

    fn rows(&self) -> Rows {
        Rows::of("written", &self.values)
    }
}

impl Page {
    pub(super) fn load(self, load: &Load) -> String {
        let shown: Vec<Written> = load.values.iter().filter(|row| self.is_told(row)).cloned().collect();
        let mut text = self.load_head(load);
        if !shown.is_empty() {
            text += "\n";
            text += &self.written(&shown);
        }
        text
    }

    /// The last lines on a terminal, where the head may have scrolled away: what came of it, and what takes it back.
    pub(super) fn closing<'l>(self, loads: impl IntoIterator<Item = &'l Load>) -> String {
        let loads = loads.into_iter().filter(|_| self.width.is_some());
        let told: String =
            loads.filter_map(|load| load.closing.as_ref()).map(|told| self.prose(told.get(self.lang))).collect();
        if told.is_empty() { told } else { format!("\n{told}") }
    }

    /// What files hold and no load takes unless it is named: a drive that is called equal may have it otherwise.
    pub(super) fn unnamed<'l>(self, loads: impl IntoIterator<Item = &'l Load>) -> String {
        let left = loads.into_iter().flat_map(|load| &load.left_out);
        let left: BTreeSet<u32> =
            left.filter(|row| row.why == NotLoadedWhy::NotAskedFor).map(|row| row.param).collect();
        let left: Vec<String> = left.iter().map(u32::to_string).collect();
        if left.is_empty() { String::new() } else { self.pairs(vec![(UNNAMED, left.join(", "))]) }
    }

    fn is_told(self, row: &Written) -> bool {
        self.full || row.result != WriteResult::Unchanged || row.old_raw != Some(row.raw)
    }

    /// What is told of a load but its values.
    pub(super) fn load_head(self, load: &Load) -> String {
        let unchanged = load.values.iter().filter(|row| !self.is_told(row)).count();
        let mut pairs = vec![("files", load.files.join(", "))];
        pairs.extend(load.ended.map(|ended| ("result", self.word(self::ended(ended, &load.values)).to_owned())));
        pairs.extend((unchanged > 0).then(|| ("unchanged", unchanged.to_string())));
        for (why, word) in LEFT_OUT {
            let left: Vec<String> = load.left_out.iter().filter(|row| row.why == *why).map(place).collect();
            pairs.extend((!left.is_empty()).then(|| (*word, left.join(", "))));
        }
        pairs.extend(load.undo_file.iter().map(|file| ("undo file", file.clone())));
        // Behind several drives each may have another one.
        let page = Page { node: load.node.max(self.node), ..self };
        page.heading(load.address, &load.drive) + &self.pairs(pairs)
    }
}

fn place(left: &crate::outcome::NotLoaded) -> String {
    if left.data_set == 0 { left.param.to_string() } else { format!("{}@{}", left.param, left.data_set) }
}

fn ended(ended: LoadEnd, rows: &[Written]) -> &'static str {
    match ended {
        LoadEnd::Done if rows.iter().any(|row| row.result == WriteResult::Written) => {
            "done, proven as far as it can be read"
        }
        LoadEnd::Done => "done, every value proven",
        LoadEnd::Stored => "stored, not all in force",
        LoadEnd::Untouched => "nothing was changed",
        // What somebody else has changed stays.
        LoadEnd::Back if rows.iter().any(|row| row.result == WriteResult::Skipped && row.error.is_some()) => {
            "what was written is as before, proven"
        }
        LoadEnd::Back => "as before, proven",
        LoadEnd::Torn => "NOT as before",
    }
}

const UNNAMED: &str = "left out until named";

const LEFT_OUT: &[(NotLoadedWhy, &str)] = &[
    (NotLoadedWhy::NotAskedFor, UNNAMED),
    (NotLoadedWhy::ReadOnly, "left out, only told"),
    (NotLoadedWhy::Command, "left out, commands"),
    (NotLoadedWhy::Restarts, "left out, restarts"),
    (NotLoadedWhy::Text, "left out, texts"),
];
