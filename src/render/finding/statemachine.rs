//! `statemachine`: the state, and what leads out of it.

use super::page::{Page, number};
use super::{Finding, Rows};
use crate::outcome::{StateReport, Statemachine, Value};

impl Finding for Statemachine {
    fn table(&self, page: Page) -> String {
        page.each(&self.drives, Page::state)
    }

    fn rows(&self) -> Rows {
        Rows::of("drive", &self.drives)
    }
}

impl Page {
    fn state(self, report: &StateReport) -> String {
        let mut text = self.heading(report.address, &report.drive);
        if let Some(error) = &report.error {
            return text + &self.prose(error.message.get(self.lang));
        }
        let mut rows = Vec::new();
        rows.extend(report.state.iter().map(|state| ("state", self.say(&state.name))));
        let mode = |mode: &Value| format!("P.{} = {} {}", mode.param, number(mode), self.meaning(mode));
        rows.extend(report.control_mode.iter().map(|value| ("control mode", mode(value))));
        rows.extend(report.control_mode_stored.iter().map(|value| ("stored, not in force", mode(value))));
        rows.extend(self.fault_or_none(report.fault.as_ref(), report.fault_code));
        rows.extend(self.missing(&report.missing));
        if self.full {
            return text + &self.pairs(rows) + &self.map(report);
        }
        let here = report.states.iter().filter(|state| state.present).flat_map(|state| &state.leads);
        rows.extend(here.enumerate().map(|(index, lead)| (if index == 0 { "from here" } else { "" }, self.say(lead))));
        for (name, word) in [("status word", &report.status), ("control word", &report.control)] {
            rows.extend(word.iter().map(|word| (name, format!("{}: {}", word.hex, self.set_bits(word)))));
        }
        text += &self.pairs(rows);
        text
    }

    /// Every state and where it leads, and the words bit by bit.
    fn map(self, report: &StateReport) -> String {
        let mut text = String::new();
        let map = report.states.iter().flat_map(|state| {
            let leads = state.leads.iter().enumerate().map(|(index, lead)| {
                let name = if index == 0 { self.say(&state.name) } else { String::new() };
                let mark = if state.present && index == 0 { ">>" } else { "" };
                vec![mark.to_owned(), name, self.say(lead)]
            });
            leads.collect::<Vec<_>>()
        });
        text += "\n";
        text += &self.table(&["", "", ""], map.collect());
        for (name, bits) in [("status word", &report.status), ("control word", &report.control)] {
            if let Some(bits) = bits {
                text += &format!("\n{} {}\n", self.word(name), bits.hex);
                text += &self.bits(bits);
            }
        }
        text
    }
}
