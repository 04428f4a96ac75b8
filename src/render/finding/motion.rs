//! `statemachine enable`, `sollwert 25Hz`: what the shaft did.

use super::page::{Page, shown};
use super::{Finding, Rows};
use crate::outcome::{Motion, Setpoint, State, Stopped, Stops};
use crate::render::clean;

impl Finding for Motion {
    fn table(&self, page: Page) -> String {
        page.motion(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("motion", &[self])
    }
}

impl Finding for Stops {
    fn table(&self, page: Page) -> String {
        page.each(&self.drives, Page::stopped)
    }

    fn rows(&self) -> Rows {
        Rows::of("motion", &self.drives)
    }
}

impl Page {
    fn stopped(self, drive: &Stopped) -> String {
        let called = drive.called.as_ref().map_or_else(String::new, |called| format!("{}: ", clean(called)));
        let text = match &drive.motion {
            Some(motion) => self.motion(motion),
            None => self.heading(drive.address, "unknown"),
        };
        let error = drive.error.as_ref().map_or_else(String::new, |error| self.prose(error.message.get(self.lang)));
        called + &text + &error
    }

    fn motion(self, motion: &Motion) -> String {
        let mut text = self.heading(motion.address, &motion.drive);
        let state = |state: &Option<State>| {
            state.as_ref().map_or_else(|| self.word("not known").to_owned(), |state| self.say(&state.name))
        };
        let mut rows = vec![("state", format!("{} -> {}", state(&motion.from), state(&motion.to)))];
        if let Some(setpoint) = &motion.setpoint {
            rows.push(("setpoint", self.setpoint(setpoint)));
        }
        for change in &motion.changed {
            let back = if change.restored { "given back" } else { "NOT given back" };
            let what = format!("{} {} -> {}, {}", change.name, change.old, change.new, self.word(back));
            rows.push(("changed", what));
        }
        if let Some(stop) = &motion.stop {
            let proof = match stop.acknowledged {
                true => "acknowledged",
                false if stop.choice == "keep" => "no stop",
                // It is obeyed, but by a drive that shows no standstill.
                false if motion.running == Some(false) && stop.standing.is_none() => "standstill NOT proven",
                false => "NOT acknowledged",
            };
            let note = stop.note.as_ref().map_or_else(String::new, |note| format!("; {}", self.say(note)));
            let by = stop.escalated.map_or_else(String::new, |by| format!(" -> {by}"));
            rows.push((
                "stop",
                format!("{}{by} ({}), {}{note}", stop.choice, self.word(stop.because), self.word(proof)),
            ));
        }
        if let Some(running) = motion.running {
            let word = self.word(if running { "yes" } else { "no" });
            let shaft = motion.shaft().map_or_else(String::new, |told| format!("; {}", self.word(told)));
            rows.push(("running", format!("{word}{shaft}")));
        }
        rows.extend(motion.notes.iter().map(|note| ("note", self.say(note))));
        text += &self.pairs(rows);
        let steps = motion.steps.iter().map(|step| {
            vec![
                step.transition.clone(),
                step.command.clone().unwrap_or_else(|| "-".to_owned()),
                step.control.clone().unwrap_or_else(|| "-".to_owned()),
                self.say(&step.state.name),
                format!("{} ms", step.took_ms),
            ]
        });
        let steps = self.table(&[">step", "command", "control word", "state", ">took"], steps.collect());
        if steps.is_empty() { text } else { text + "\n" + &steps }
    }

    /// What was given, what the drive makes of it, and what came of it.
    fn setpoint(self, setpoint: &Setpoint) -> String {
        let reached = match setpoint.reached {
            Some(true) => format!(", {}", self.word("reached")),
            Some(false) => format!(", {}", self.word("not reached")),
            None => String::new(),
        };
        let actual = setpoint.actual.map_or_else(String::new, |actual| {
            format!(", {} {} {}", self.word("actual value"), shown(actual, false), setpoint.unit)
        });
        let below = setpoint.denominator.map_or_else(String::new, |below| format!("/{below}"));
        let runs = setpoint.effective.filter(|effective| effective.raw != setpoint.value.raw);
        let runs = runs.map_or_else(String::new, |effective| {
            format!(" ({} {} {})", self.word("makes"), shown(effective, false), setpoint.unit)
        });
        format!("{}{below} {}{runs}{reached}{actual}", shown(setpoint.value, false), setpoint.unit)
    }
}
