//! `dataset`: the data sets side by side.

use super::page::{Page, is_unscaled, number, set_name, shown};
use super::{Finding, Rows};
use crate::outcome::{Dataset, Datasets, Value};

impl Finding for Dataset {
    fn table(&self, page: Page) -> String {
        page.dataset(self)
    }

    fn rows(&self) -> Rows {
        let values: Vec<_> = self.rows.iter().flat_map(|row| &row.values).collect();
        Rows::of("value", &values).and(Rows::of("written", &self.written)).or(Rows::of("dataset", &[self]))
    }
}

impl Finding for Datasets {
    fn table(&self, page: Page) -> String {
        let told = self.drives.iter().map(|one| {
            let error = one.error.iter().map(|error| ("error", page.say(&error.message))).collect();
            let is_known = one.active.is_some() || !one.rows.is_empty() || !one.written.is_empty();
            (if is_known { page.dataset(one) } else { page.heading(one.address, &one.drive) }) + &page.pairs(error)
        });
        told.collect::<Vec<_>>().join("\n")
    }

    fn rows(&self) -> Rows {
        self.drives.iter().map(Finding::rows).fold(Rows::default(), Rows::and)
    }
}

impl Page {
    fn dataset(self, dataset: &Dataset) -> String {
        let mut text = self.heading(dataset.address, &dataset.drive);
        let active = dataset.active.map_or_else(|| "?".to_owned(), |set| set.to_string());
        let told = |value: &Value| {
            let number = value.value.map_or_else(|| "?".to_owned(), |number| shown(number, false));
            format!("{number} {}", self.say_or_not(value.text.as_ref()))
        };
        let selection = dataset.selection.as_ref().map_or_else(String::new, told);
        let mut pairs = vec![("active set", active), ("selection", selection)];
        pairs.extend(dataset.selection_stored.iter().map(|value| ("stored only", told(value))));
        text += &self.pairs(pairs);
        let sets = dataset.rows.iter().map(|row| row.values.len()).max().unwrap_or(0);
        if sets > 0 {
            let first = dataset.rows.iter().find(|row| row.values.len() == sets);
            let sets = first
                .iter()
                .flat_map(|row| &row.values)
                .map(|value| format!(">@{}", set_name(value.data_set, value.store)));
            let sets: Vec<String> = sets.collect();
            let mut head = vec![">param", "name"];
            head.extend(sets.iter().map(String::as_str));
            head.extend(["unit", "equal"]);
            let rows = dataset.rows.iter().map(|row| {
                let mut cells = vec![row.param.to_string(), self.say(&row.name)];
                // Beside values in a unit a raw one says so itself.
                let is_raw = !row.values.iter().any(|value| value.value.is_some());
                cells.extend(row.values.iter().map(|value| match &value.error {
                    None if is_unscaled(value) && !is_raw => format!("{} {}", self.word("raw"), number(value)),
                    None => number(value),
                    Some(error) => error.code.clone(),
                }));
                let is_raw = is_raw && row.values.iter().any(is_unscaled);
                cells.push(if is_raw { self.word("raw").to_owned() } else { row.unit.clone().unwrap_or_default() });
                cells.push(self.word(if row.equal { "yes" } else { "no" }).to_owned());
                cells
            });
            text += "\n";
            text += &self.table(&head, rows.collect());
        }
        if !dataset.written.is_empty() {
            text += "\n";
            text += &self.written(&dataset.written);
        }
        text
    }
}
