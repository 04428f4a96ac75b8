//! What the live view of a run shows besides that of `monitor`: where it has come to, and what the keys do.

use super::screen::Screen;
use crate::outcome::{RunKeys, RunNews};
use crate::profile::value::format_decimal;
use crate::render::clean;
use crate::render::run_line::left;
use crate::render::wrap::wrap;
use ratatui::text::Line;

impl Screen {
    /// Where the run has come to, and the last thing that was said, as far as they fit.
    pub(super) fn course(&self, run: &RunNews) -> String {
        let lang = self.lang;
        let phase = match run.phase {
            "waiting" => lang.pick("waiting for a key to be held", "wartet, bis eine Taste gehalten wird"),
            "starting" => lang.pick("starting", "läuft an"),
            "led" => lang.pick("led", "geführt"),
            "stopping" => lang.pick("STOPPING", "HÄLT AN"),
            "ended" => lang.pick("the run is over", "der Lauf ist zu Ende"),
            _ => lang.pick("held", "gehalten"),
        };
        let mut parts = vec![phase.to_owned()];
        parts.extend(run.setpoint.map(|setpoint| {
            let value = format_decimal(setpoint.raw, setpoint.decimals);
            format!("{} {value} {}", self.word("setpoint"), run.unit.as_deref().unwrap_or("")).trim_end().to_owned()
        }));
        parts.extend(left(run, self.t).map(|left| lang.pick("{} s left", "noch {} s").replace("{}", &left)));
        if run.phase != "ended" {
            parts.push(format!("{}: {}", self.word("stop"), run.stop));
        }
        clean(&format!(" {}", parts.join("  ")))
    }

    /// That the shaft may turn, the keys, where the run has come to, and what was said last, which has as many lines as it needs: its end
    /// may be what matters.
    pub(super) fn said(&self, run: &RunNews, width: u16) -> Vec<String> {
        let told = |text: &str| wrap(&format!(" {}", clean(text)), Some(width));
        let alarm = Some(&self.alarm).filter(|alarm| !alarm.is_empty()).map(|alarm| told(alarm)).unwrap_or_default();
        let note = told(&self.note);
        let course = [self.keys(run, width), self.course(run)];
        alarm.lines().map(str::to_owned).chain(course).chain(note.lines().map(str::to_owned)).collect()
    }

    /// What the keys do; what does not fit is left out, what stops comes first.
    pub(super) fn keys(&self, run: &RunNews, width: u16) -> String {
        let lang = self.lang;
        let mut keys = match run.phase {
            "ended" => vec![lang.pick("q ends", "q beendet").to_owned()],
            "stopping" if run.stop == "coast" => Vec::new(),
            "stopping" => vec![lang.pick("Ctrl-C: a stronger stop", "Strg-C: stärkerer Halt").to_owned()],
            _ => vec![
                lang.pick("space stop", "Leertaste Halt").to_owned(),
                lang.pick("q stop and end", "q Halt und Ende").to_owned(),
            ],
        };
        if let Some(RunKeys { step, min, max, unit }) =
            run.keys.as_ref().filter(|_| !matches!(run.phase, "ended" | "stopping"))
        {
            let [step, min, max] = [step, min, max].map(|value| format_decimal(value.raw, value.decimals));
            keys.push(format!("\u{2191}\u{2193} {step} {unit} ({min} … {max})"));
        }
        keys.push(lang.pick("d diagnosis", "d Diagnose").to_owned());
        let line = |keys: &[String]| clean(&format!(" {}", keys.join("  ")));
        while keys.len() > 1 && Line::raw(line(&keys)).width() > width.into() {
            keys.pop();
        }
        line(&keys)
    }
}
