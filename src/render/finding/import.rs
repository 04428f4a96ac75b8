//! `params import`: the catalogue with what was taken for what above it, or that alone. `params export`: the list.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Export, Import};
use crate::text::Text;

impl Finding for Import {
    fn table(&self, page: Page) -> String {
        // Without a file the page is the catalogue, and what is told stands in it as comments.
        let mark = if self.catalogue.is_some() { "# " } else { "" };
        let narrow = Page { width: page.width.map(|width| width.saturating_sub(mark.len() as u16)), ..page };
        let told: String = self.told.iter().map(|line| narrow.prose(line.get(page.lang))).collect();
        let told: String = told.lines().map(|line| format!("{mark}{line}\n")).collect();
        told + self.catalogue.as_deref().unwrap_or_default()
    }

    fn rows(&self) -> Rows {
        Rows::of("param", &self.rows).and(Rows::of("left_out", &self.left_out))
    }
}

impl Finding for Export {
    fn table(&self, page: Page) -> String {
        let (count, to) = (self.params.len(), self.output.as_deref().unwrap_or_default());
        let count = Text::count(count as u64, ["parameter", "parameters"], ["Parameter", "Parameter"]);
        let said = page.lang.pick("written to", "geschrieben nach");
        self.list.clone().unwrap_or_else(|| page.prose(&format!("{} {said} {to}", count.get(page.lang))))
    }

    fn rows(&self) -> Rows {
        let cells = |param: &std::collections::BTreeMap<&'static str, String>| {
            self.columns.iter().map(|column| param.get(column).cloned().unwrap_or_default()).collect()
        };
        Rows::named("param", &self.columns, self.params.iter().map(cells))
    }
}
