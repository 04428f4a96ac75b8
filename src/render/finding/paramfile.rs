//! `dataset save`, `check` and `diff`: what a file holds, and where sides differ.

use super::page::{Page, shown};
use super::{Finding, Rows};
use crate::outcome::{Comparison, Comparisons, Decimal, Difference, SavedFile, Saves, Side};
use crate::render::clean;
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;

impl Finding for Saves {
    fn table(&self, page: Page) -> String {
        page.each(&self.saved, Page::saved)
    }

    fn rows(&self) -> Rows {
        let values: Vec<_> = self.saved.iter().flat_map(|saved| &saved.values).collect();
        let failed: Vec<_> = self.saved.iter().filter(|saved| saved.values.is_empty()).collect();
        Rows::of("value", &values).and(Rows::of("saved", &failed).without_lists())
    }
}

impl Finding for Comparisons {
    fn table(&self, page: Page) -> String {
        page.each(&self.comparisons, Page::comparison)
    }

    fn rows(&self) -> Rows {
        let of = |one: &Comparison| {
            let address = one.b.address.or(one.a.address).map_or(Value::Null, Value::from);
            compared("comparison", one, one).under("address", &address)
        };
        self.comparisons.iter().map(of).fold(Rows::default(), Rows::and)
    }
}

/// A comparison, and a row for each place where its sides differ.
pub(super) fn compared<T: Serialize + JsonSchema>(kind: &'static str, whole: &T, one: &Comparison) -> Rows {
    let whole = Rows::of(kind, std::slice::from_ref(&whole)).without_lists().without(&["a", "b"]);
    whole.and(Rows::of("difference", &one.differences))
}

impl Page {
    fn saved(self, saved: &SavedFile) -> String {
        let mut text = self.heading(saved.address, &saved.drive);
        let none = || self.word("none").to_owned();
        let mut rows = vec![
            ("file", saved.file.clone().unwrap_or_else(none)),
            ("complete", self.word(if saved.complete { "yes" } else { "no" }).to_owned()),
            ("values", saved.values.len().to_string()),
        ];
        rows.extend(saved.signature.clone().map(|signature| ("signature", signature)));
        rows.extend(saved.error.as_ref().map(|error| ("error", self.say(&error.message))));
        text += &self.pairs(rows);
        if !saved.not_held.is_empty() {
            text += &format!("\n{}\n", self.word("not in the file"));
            let rows =
                saved.not_held.iter().map(|row| vec![row.count.to_string(), self.say(&row.text), row.params.clone()]);
            text += &self.table(&[">", "", ""], rows.collect());
        }
        text
    }

    pub(super) fn comparison(self, comparison: &Comparison) -> String {
        if let Some(unified) = &comparison.unified {
            return self.say(unified).lines().map(|line| format!("{}\n", clean(line))).collect();
        }
        let Comparison { a, b, compared, differences, error, .. } = comparison;
        let mut rows = vec![vec!["a".to_owned(), self.side(a)], vec!["b".to_owned(), self.side(b)]];
        // Where nothing could be held against anything, no number says how much of it was alike.
        if error.is_none() || *compared > 0 {
            let count = differences.iter().filter(|row| row.error.is_none()).count();
            rows.push(vec![self.word("compared").to_owned(), compared.to_string()]);
            rows.push(vec![self.word("different").to_owned(), count.to_string()]);
        }
        if let Some(error) = error {
            rows.push(vec![self.word("error").to_owned(), self.say(&error.message)]);
        }
        let mut text = self.table(&["", ""], rows);
        let mut last = None;
        let fails = differences.iter().any(|row| row.error.is_some());
        let why = |row: &Difference| row.error.as_ref().map_or_else(String::new, |error| self.say(&error.message));
        let rows = differences.iter().map(|row| {
            let group = row.group.as_ref().filter(|_| last.replace(&row.group) != Some(&row.group));
            let cells = vec![
                group.map_or_else(String::new, |group| format!("@{group}")),
                row.param.to_string(),
                if row.data_set == 0 { String::new() } else { row.data_set.to_string() },
                self.say(&row.name),
                self.held((row.a_raw, row.a_value, row.a_text.as_ref()), row.b_value),
                self.held((row.b_raw, row.b_value, row.b_text.as_ref()), row.a_value),
                self.unit(row),
            ];
            cells.into_iter().chain(fails.then(|| why(row))).collect()
        });
        let rows: Vec<_> = rows.collect();
        if !rows.is_empty() {
            text += "\n";
            let head =
                ["group", ">param", "set", "name", ">a", ">b", "unit"].into_iter().chain(fails.then_some("error"));
            text += &self.table(&head.collect::<Vec<_>>(), rows);
        }
        text
    }

    pub(super) fn unit(self, row: &Difference) -> String {
        match row.error.is_none() && row.a_value.is_none() && row.b_value.is_none() {
            true => self.word("raw").to_owned(),
            false => row.unit.clone().unwrap_or_default(),
        }
    }

    fn side(self, side: &Side) -> String {
        let mut parts = vec![self.family(&side.drive).to_owned()];
        parts.extend(side.signature.as_ref().map(|signature| format!("{} {signature}", self.word("signature"))));
        if side.edited == Some(true) {
            parts.push(self.word("changed since it was saved").to_owned());
        }
        format!("{} ({})", self.say(&side.name), parts.join(", "))
    }

    /// What one side holds: raw value, value, what it stands for. Beside a value in its unit a raw one says so itself.
    pub(super) fn held(
        self,
        (raw, value, text): (Option<i64>, Option<Decimal>, Option<&Text>),
        other: Option<Decimal>,
    ) -> String {
        let number = match (value, raw) {
            (Some(value), _) => shown(value, false),
            (None, Some(raw)) if other.is_some() => format!("{} {raw}", self.word("raw")),
            (None, Some(raw)) => raw.to_string(),
            (None, None) => "-".to_owned(),
        };
        text.map_or(number.clone(), |text| format!("{number} {}", self.say(text)))
    }
}
