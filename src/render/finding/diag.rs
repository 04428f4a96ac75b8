//! `diag`: what ails a drive.

use super::page::Page;
use super::{Finding, Row, list};
use crate::outcome::{Diag, Diagnosis, LinkTest, Value};
use crate::profile::value::format_decimal;
use crate::render::clean;

impl Finding for Diag {
    fn table(&self, page: Page) -> String {
        page.each(&self.drives, Page::diagnosis)
    }

    fn rows(&self) -> Vec<Row> {
        list("drive", &self.drives)
    }
}

impl Page {
    fn diagnosis(self, report: &Diagnosis) -> String {
        let mut text = self.heading(report.address, &report.drive);
        if let Some(error) = &report.error {
            return text + &format!("{}\n", clean(error.message.get(self.lang)));
        }
        let mut rows = Vec::new();
        if let Some(status) = &report.status {
            let state = self.say_or_not(status.state.as_ref().map(|state| &state.name));
            rows.push(("state", format!("{state} ({})", status.hex)));
        }
        match (&report.fault, report.fault_code) {
            (Some(fault), _) => rows.extend(self.fault(fault)),
            (None, Some(_)) => rows.push(("fault", self.word("none").to_owned())),
            (None, None) => rows.push(("fault", self.word("could not be read").to_owned())),
        }
        if let Some(warnings) = &report.warnings {
            let set: Vec<_> = warnings.bits.iter().filter(|bit| bit.set).collect();
            if set.is_empty() {
                rows.push(("warnings", self.word("none").to_owned()));
            }
            for (index, bit) in set.iter().enumerate() {
                let name = self.bit(bit);
                let help = bit.help.as_ref().map_or_else(String::new, |help| format!(": {}", self.say(help)));
                rows.push((if index == 0 { "warnings" } else { "" }, format!("{name}{help}")));
            }
        }
        if let Some(register) = &report.error_register {
            let hint = register.hint.as_ref().filter(|_| register.code != 0);
            let hint = hint.map_or_else(String::new, |hint| format!(": {}", self.say(hint)));
            rows.push(("error register", format!("{} {}{hint}", register.code, self.say(&register.name))));
        }
        rows.extend(self.memory(&report.memory));
        let known = report.watchdog.iter().filter(|value| value.error.is_none());
        rows.extend(known.map(|value| ("watchdog", self.short(value))));
        if report.counters_cleared {
            rows.push(("counters cleared", self.word("yes").to_owned()));
        }
        if let Some(link) = &report.link {
            rows.extend(self.link(link));
        }
        text += &self.pairs(rows);
        let rows = report.counters.iter().map(|counter| {
            let count = counter.count.map_or_else(|| "-".to_owned(), |count| count.to_string());
            vec![count, self.say(&counter.name), self.say(&counter.help)]
        });
        text + "\n" + &self.table(&[">count", "name", "meaning"], rows.collect())
    }

    /// The entry of the fault memory; number 0 is none.
    fn memory(self, memory: &[Value]) -> Vec<(&'static str, String)> {
        if memory.first().is_some_and(|number| number.raw == Some(0)) {
            return vec![("fault memory", self.word("none").to_owned())];
        }
        let label = |index| if index == 0 { "fault memory" } else { "" };
        let rows = memory.iter().enumerate();
        rows.map(|(index, value)| (label(index), format!("{}: {}", self.say(&value.name), self.short(value)))).collect()
    }

    pub(super) fn link(self, link: &LinkTest) -> Vec<(&'static str, String)> {
        let millis =
            |us: Option<u64>| us.map_or_else(|| "-".to_owned(), |us| format!("{} ms", format_decimal(us as i64, 3)));
        vec![
            (
                "link test",
                format!(
                    "{} {}, {} {}, {} {}, {} {}, {} {}",
                    link.asked,
                    self.word("asked"),
                    link.replies,
                    self.word("replies"),
                    link.silent,
                    self.word("silent"),
                    link.garbled,
                    self.word("garbled"),
                    link.strays,
                    self.word("strays")
                ),
            ),
            ("error rate", format!("{} %", link.error_rate_percent)),
            (
                "reply times",
                format!(
                    "{} … {}, {} {}, 95 % {}",
                    millis(link.fastest_us),
                    millis(link.slowest_us),
                    self.word("median"),
                    millis(link.median_us),
                    millis(link.p95_us)
                ),
            ),
        ]
    }
}
