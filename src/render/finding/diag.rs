//! `diag`: what ails a drive.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Diag, Diagnosis, LinkTest, Register, SlaveDiagnosis, Value, Word};
use crate::profile::value::format_decimal;

impl Finding for Diag {
    fn table(&self, page: Page) -> String {
        match self.drives.len() > 1 && !page.full {
            true => page.fleet(self),
            false => page.each(&self.drives, Page::diagnosis),
        }
    }

    fn rows(&self) -> Rows {
        Rows::of("drive", &self.drives)
    }
}

impl Page {
    /// Several drives, one row each.
    fn fleet(self, diag: &Diag) -> String {
        // A number that nobody can read ails no drive: it stands in its own page.
        let is_told = |register: &&Register| register.code != 0 && register.hint.is_some();
        let refused = diag.drives.iter().any(|report| report.error_register.as_ref().filter(is_told).is_some());
        let row = |report: &Diagnosis| {
            let state = report.status.as_ref().and_then(|word| word.state.as_ref());
            let found = match &report.error {
                Some(error) => [self.say(&error.message), String::new(), String::new()],
                None => [
                    self.say_or_not(state.map(|state| &state.name)),
                    self.present(report),
                    report.warnings.as_ref().map_or_else(String::new, |word| self.first_of(&self.set_bits(word))),
                ],
            };
            let refusal = report.error_register.as_ref().filter(is_told);
            let refusal = refusal.map_or_else(|| "-".to_owned(), |it| format!("{} {}", it.code, self.say(&it.name)));
            let head = [self.address(report.address), self.family(&report.drive).to_owned()];
            head.into_iter().chain(found).chain(refused.then_some(refusal)).collect()
        };
        let rows = diag.drives.iter().map(row).collect();
        let head = [">addr", "drive", "state", "fault", "warnings", "error register"];
        let table = self.table(head.get(..if refused { 6 } else { 5 }).unwrap_or(&head), rows);
        let missing = diag.drives.iter().filter(|report| !report.missing.is_empty());
        let missing = missing.map(|report| {
            let texts = report.missing.iter().map(|text| self.say(text)).collect::<Vec<_>>();
            vec![self.address(report.address), self.word("missing").to_owned(), texts.join("; ")]
        });
        match self.table(&[">", "", ""], missing.collect()) {
            none if none.is_empty() => table,
            missing => table + "\n" + &missing,
        }
    }

    /// The fault that is present, that there is none, or why nobody can say.
    pub(super) fn fault_of(self, report: &Diagnosis) -> Vec<(&'static str, String)> {
        if report.tells_faults {
            return self.fault_or_none(report.fault.as_ref(), report.fault_code);
        }
        vec![("fault", self.word("the catalogue names no parameter for it").to_owned())]
    }

    /// The fault that is present, in a few words.
    pub(super) fn present(self, report: &Diagnosis) -> String {
        match (&report.fault, report.fault_code) {
            (Some(fault), _) => self.say(&fault.told()),
            (None, Some(_)) => "-".to_owned(),
            (None, None) if !report.tells_faults => self.word("unknown").to_owned(),
            (None, None) => self.word("could not be read").to_owned(),
        }
    }

    fn diagnosis(self, report: &Diagnosis) -> String {
        let mut text = self.heading(report.address, &report.drive);
        if let Some(error) = &report.error {
            return text + &self.prose(error.message.get(self.lang));
        }
        let mut rows = self.fault_of(report);
        if let Some(status) = &report.status {
            let state = self.say_or_not(status.state.as_ref().map(|state| &state.name));
            rows.push(("state", format!("{state} ({})", status.hex)));
        }
        rows.extend(self.missing(&report.missing));
        rows.extend(report.warnings.iter().flat_map(|word| self.warnings(word)));
        rows.extend(report.inputs.iter().map(|word| ("inputs", self.each_bit(word))));
        if let Some(bus) = &report.bus {
            let known = bus.values.iter().filter(|value| value.error.is_none());
            rows.extend(known.map(|value| ("system bus", format!("{} {}", self.say(&value.name), self.short(value)))));
            rows.extend(bus.emergencies.iter().map(|told| ("emergency", self.say(told))));
        }
        if let Some(register) = report.error_register.as_ref().filter(|register| self.full || register.code != 0) {
            let hint = register.hint.as_ref().filter(|_| register.code != 0);
            let hint = hint.map_or_else(String::new, |hint| format!(": {}", self.say(hint)));
            let age = if register.code == 0 {
                ""
            } else {
                self.lang.pick("; it does not tell when", "; wann, sagt er nicht")
            };
            rows.push(("error register", format!("{} {}{hint}{age}", register.code, self.say(&register.name))));
        }
        rows.extend(self.memory(&report.memory));
        let known = report.watchdog.iter().filter(|value| value.error.is_none() && (self.full || value.raw != Some(0)));
        rows.extend(known.map(|value| ("watchdog", self.short(value))));
        if report.counters_cleared {
            rows.push(("counters cleared", self.word("yes").to_owned()));
        }
        if let Some(link) = &report.link {
            rows.extend(self.link(link));
        }
        text += &self.pairs(rows);
        let shown = report.counters.iter().filter(|counter| self.full || counter.count != Some(0));
        let rows = shown.map(|counter| {
            let count = counter.count.map_or_else(|| "-".to_owned(), |count| count.to_string());
            let help = self.full.then(|| self.say(&counter.help));
            [count, self.say(&counter.name)].into_iter().chain(help).collect()
        });
        let head: &[&str] = if self.full { &[">count", "name", "meaning"] } else { &[">count", "name"] };
        match self.table(head, rows.collect()) {
            none if none.is_empty() => {}
            counters => text += &("\n".to_owned() + &counters),
        }
        text + &report.slave.as_ref().map_or_else(String::new, |slave| self.slave(slave))
    }

    /// What a slave of PROFIBUS tells besides.
    fn slave(self, slave: &SlaveDiagnosis) -> String {
        let rows =
            slave.values.iter().map(|value| vec![value.param.to_string(), self.say(&value.name), self.short(value)]);
        let mut text = match self.table(&[">param", "name", "value"], rows.collect()) {
            none if none.is_empty() => none,
            values => "\n".to_owned() + &values,
        };
        if !slave.diagnosis.is_empty() {
            text += &format!("\nSlave_Diag{}", self.fields(&slave.diagnosis));
        }
        let rows = slave.leds.iter().map(|led| vec![self.say(&led.name), self.say(&led.value)]);
        match self.table(&["", ""], rows.collect()) {
            none if none.is_empty() => text,
            leds => text + "\n" + &leds,
        }
    }

    /// Every bit with its state: `S1IND 1, S2IND 0`.
    fn each_bit(self, word: &Word) -> String {
        let named = word.bits.iter().map(|bit| format!("{} {}", self.bit(bit), u8::from(bit.set)));
        let unknown = word.unknown.iter().map(|bit| format!("bit {bit} 1"));
        named.chain(unknown).collect::<Vec<_>>().join(", ")
    }

    /// The warnings that are set by their names; on a full page each with what it means.
    pub(super) fn warnings(self, word: &Word) -> Vec<(&'static str, String)> {
        if !self.full && word.bits.iter().any(|bit| bit.set) {
            return vec![("warnings", self.set_bits(word))];
        }
        let set = word.bits.iter().filter(|bit| bit.set).enumerate();
        let rows: Vec<_> = set
            .map(|(index, bit)| {
                let help = bit.help.as_ref().map_or_else(String::new, |help| format!(": {}", self.say(help)));
                (if index == 0 { "warnings" } else { "" }, format!("{}{help}", self.bit(bit)))
            })
            .collect();
        if rows.is_empty() { vec![("warnings", self.word("none").to_owned())] } else { rows }
    }

    /// The entry of the fault memory; number 0 is none.
    pub(super) fn memory(self, memory: &[Value]) -> Vec<(&'static str, String)> {
        if memory.first().is_some_and(|number| number.raw == Some(0)) {
            return vec![("fault memory", self.word("empty").to_owned())];
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
