//! Guided work in a report: what was given, and what became of each step.

use super::paper::Block;
use crate::outcome::{KeptStep, ProcedureRecord, StepFate};
use crate::render::finding::page::Page;
use crate::text::both;

impl Page {
    pub(super) fn procedure_part(self, record: &ProcedureRecord) -> Vec<Block> {
        let name = both!("Procedure: {title}", "Prozedur: {title}", title = record.title);
        let mut facts = vec![self.fact("drive", format!("{} ({})", record.address, record.known_drive()))];
        let done = record.steps.iter().filter(|step| step.result == StepFate::Done).count();
        facts.push(self.fact("steps", format!("{done}/{}", record.of)));
        let given: Vec<String> = record.given.iter().map(|row| format!("{} = {}", row.key, row.value)).collect();
        facts.extend((!given.is_empty()).then(|| self.fact("given", given.join(", "))));
        let stays: Vec<String> = record.stays().iter().map(|text| self.say(text)).collect();
        facts.extend((!stays.is_empty()).then(|| self.fact("stays otherwise", stays.join("; "))));
        let rows = record.steps.iter().enumerate().map(|(index, step)| self.kept(index + 1, step));
        let table = self.grid(&[">step", "what", "result", "time (UTC)", "found"], rows);
        vec![Block::Heading(1, self.say(&name)), Block::Facts(facts), table]
    }

    fn kept(self, nth: usize, step: &KeptStep) -> Vec<String> {
        let found = step.found.iter().chain(&step.error).map(|text| self.say(text)).collect::<Vec<_>>().join("; ");
        let time = step.time.clone().unwrap_or_else(|| "-".to_owned());
        vec![nth.to_string(), self.say(&step.title), self.word(step.result.slug()).to_owned(), time, found]
    }
}
