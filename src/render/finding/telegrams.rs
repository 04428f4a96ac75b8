//! Telegrams: of `sniff`, and of `--dry-run`.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Plan, Sniff, TelegramDoc};
use crate::profile::value::format_decimal;

impl Finding for Plan {
    fn table(&self, page: Page) -> String {
        page.plan(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("telegram", &self.telegrams)
    }
}

impl Finding for Sniff {
    fn table(&self, page: Page) -> String {
        page.telegrams(&self.telegrams)
    }

    fn rows(&self) -> Rows {
        Rows::of("telegram", &self.telegrams)
    }
}

impl Page {
    fn plan(self, plan: &Plan) -> String {
        let notes: String = plan.notes.iter().map(|note| self.prose(&format!("- {}", note.get(self.lang)))).collect();
        let gap = if notes.is_empty() { "" } else { "\n" };
        self.telegrams(&plan.telegrams) + gap + &notes
    }

    pub(super) fn telegrams(self, docs: &[TelegramDoc]) -> String {
        let rows = docs.iter().map(|doc| {
            let at = doc.at_us.map_or_else(String::new, |us| format_decimal(us as i64, 3));
            vec![at, direction(doc).to_owned(), doc.hex.clone(), self.say(&doc.meaning)]
        });
        self.table(&[">ms", "", "telegram", "meaning"], rows.collect())
    }
}

/// Sign of who speaks: `>` the master, `<` a drive, `?` either, `!` nobody who can be understood.
pub(in crate::render) fn direction(doc: &TelegramDoc) -> &'static str {
    match doc.direction {
        _ if !doc.check_ok => "!",
        Some("request") => ">",
        Some(_) => "<",
        None => "?",
    }
}
