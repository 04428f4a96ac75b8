//! `protocol set`, `line set`: where a drive is now.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Relocation, RelocationResult, RelocationStep, StepResult};

impl Finding for Relocation {
    fn table(&self, page: Page) -> String {
        page.relocation(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("relocation", &[self])
    }
}

impl Page {
    fn relocation(self, relocation: &Relocation) -> String {
        let heading = self.heading(relocation.address, &relocation.drive);
        let row = |step: &RelocationStep| {
            let old = step.old_raw.map_or_else(|| "-".to_owned(), |old| old.to_string());
            let result = match step.result {
                StepResult::Planned => "planned",
                StepResult::Proven => "proven",
                StepResult::Undone => "undone",
                StepResult::Failed => "failed",
                StepResult::Unknown => "unknown",
            };
            let text = self.say_or_not(step.text.as_ref());
            let new = step.raw.to_string();
            vec![step.param.to_string(), self.say(&step.name), old, new, text, self.word(result).to_owned()]
        };
        let steps =
            self.table(&[">param", "name", ">old", ">new", "", "result"], relocation.steps.iter().map(row).collect());
        let result = match relocation.result {
            RelocationResult::Moved => "moved",
            RelocationResult::Unchanged => "unchanged",
            RelocationResult::Stored => "stored, holds after power-on",
            RelocationResult::Restored => "left as it was",
            RelocationResult::Halfway => "halfway",
            RelocationResult::Lost => "lost",
        };
        let perhaps: Vec<&str> = relocation.perhaps.iter().map(|place| place.text.get(self.lang)).collect();
        let mut rows = vec![
            ("from", self.say(&relocation.from.text)),
            ("to", self.say(&relocation.to.text)),
            ("result", self.word(result).to_owned()),
        ];
        rows.extend(relocation.now.iter().map(|now| ("answers at", self.say(&now.text))));
        rows.extend((!perhaps.is_empty()).then(|| ("perhaps at", perhaps.join("; "))));
        rows.extend(relocation.after_restart.iter().map(|place| ("after a restart", self.say(&place.text))));
        rows.extend(relocation.way_back.iter().map(|command| ("way back", command.clone())));
        [heading, steps, self.pairs(rows)].concat()
    }
}
