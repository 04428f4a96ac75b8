//! `procedure`: the steps, what became of each, and what was found.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Procedure, ProcedureStep, Procedures};

impl Finding for Procedures {
    fn table(&self, page: Page) -> String {
        let rows = self.procedures.iter().map(|one| {
            let values =
                [one.values.as_str(), one.optional.as_str()].map(|keys| if keys.is_empty() { "-" } else { keys });
            let [values, optional] = values.map(str::to_owned);
            vec![
                one.procedure.clone(),
                page.say(&one.title),
                one.drives.clone(),
                one.steps.to_string(),
                values,
                optional,
            ]
        });
        let head = ["=procedure", "what for", "drives", ">steps", "must be given", "may be given"];
        page.yielding(&head, rows.collect(), &[">steps", "drives", "may be given"])
    }

    fn rows(&self) -> Rows {
        Rows::of("procedure", &self.procedures)
    }
}

impl Finding for Procedure {
    fn table(&self, page: Page) -> String {
        let mut text = page.heading(self.address, &self.drive);
        text += &page.prose(&format!("{}: {}", self.procedure, page.say(&self.title)));
        let rows = self.steps.iter().enumerate().flat_map(|(index, step)| {
            let first = vec![(index + 1).to_string(), page.word(fate(self, step)).to_owned(), page.say(&step.title)];
            let more = page.told(step).into_iter().map(|told| vec![String::new(), String::new(), format!("- {told}")]);
            std::iter::once(first).chain(more)
        });
        text += "\n";
        text += &page.table(&[">step", "result", "what"], rows.collect());
        for note in &self.notes {
            text += "\n";
            text += &page.prose(&page.say(note));
        }
        if let Some(record) = &self.record {
            text += "\n";
            text += &page.prose(&format!("{}: {record}", page.word("record")));
        }
        text
    }

    fn rows(&self) -> Rows {
        Rows::of("step", &self.steps).without_lists()
    }
}

/// What became of a step, in a word.
fn fate(procedure: &Procedure, step: &ProcedureStep) -> &'static str {
    match (procedure.dry_run, step.turns) {
        (true, true) => "turns the shaft",
        (true, false) => "",
        _ => step.result.slug(),
    }
}

impl Page {
    /// What was found in a step, why it is not done, or what would be sent.
    fn told(self, step: &ProcedureStep) -> Vec<String> {
        let sent = step.telegrams.iter().map(|telegram| format!("{} {}", telegram.hex, self.say(&telegram.meaning)));
        let error = step.error.as_ref().map(|error| &error.message);
        let found = step.found.iter().chain(error).map(|text| self.say(text));
        sent.chain(found).collect()
    }
}
