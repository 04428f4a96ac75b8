//! Tables for people: aligned, without borders, one row a line when piped.

use super::clean;
use super::words::word;
use crate::outcome::{
    Adapter, AdapterErrors, Bucket, Data, Dataset, Decimal, Decode, Diagnosis, Fault, FoundDrive, Identity, LineCheck,
    LinkTest, Motion, ParamDoc, Plan, Relocation, RelocationResult, RelocationStep, Scan, SetpointReport, State,
    StateReport, StepResult, TelegramDoc, Value, Word, WriteResult, Written,
};
use crate::profile::Lang;
use crate::profile::value::format_decimal;
use comfy_table::{CellAlignment, ContentArrangement, Table};

/// The result as text; `width` is the width of the terminal, if it is one.
pub(super) fn render(data: &Data, lang: Lang, width: Option<u16>) -> String {
    let page = Page { lang, width };
    match data {
        Data::Scan(scan) => page.scan(scan),
        Data::Identify(identify) => page.each(&identify.drives, Page::identity),
        Data::Read(read) => page.values(&read.values),
        Data::Write(write) => page.written(&write.values),
        Data::Dataset(dataset) => page.dataset(dataset),
        Data::Diag(diag) => page.each(&diag.drives, Page::diagnosis),
        Data::LineCheck(check) => page.line_check(check),
        Data::Statemachine(report) => page.each(&report.drives, Page::state),
        Data::Sollwert(report) => page.each(&report.drives, Page::setpoints),
        Data::Params(params) => match params.params.as_slice() {
            [only] => page.param(only),
            several => page.params(several),
        },
        Data::Decode(decode) => page.decode(decode),
        Data::Plan(plan) => page.plan(plan),
        Data::Sniff(sniff) => page.telegrams(&sniff.telegrams),
        // Its stream has shown everything.
        Data::Monitor(_) => String::new(),
        Data::Motion(motion) => page.motion(motion),
        Data::Relocation(relocation) => page.relocation(relocation),
        Data::Simulate(served) => {
            let mut text = format!(
                "{}: {} clients, {} telegrams received, {} answered ({} exceptions), {} EEPROM writes, {} shafts turning, \
                 {} motors powered, {} remarks\n",
                served.port,
                served.clients,
                served.received,
                served.answered,
                served.exceptions,
                served.eeprom_writes,
                served.turning,
                served.energised,
                served.remarks.len()
            );
            served.remarks.iter().for_each(|remark| text += &format!("remark: {}\n", clean(remark)));
            text
        }
    }
}

#[derive(Clone, Copy)]
struct Page {
    lang: Lang,
    width: Option<u16>,
}

impl Page {
    fn word(self, english: &'static str) -> &'static str {
        word(self.lang, english)
    }

    fn each<T>(self, items: &[T], one: impl Fn(Page, &T) -> String) -> String {
        items.iter().map(|item| one(self, item)).collect::<Vec<_>>().join("\n")
    }

    /// A table; columns whose name starts with `>` are aligned to the right.
    fn table(self, head: &[&'static str], rows: Vec<Vec<String>>) -> String {
        if rows.is_empty() {
            return String::new();
        }
        let mut table = Table::new();
        table.load_style(comfy_table::presets::NOTHING).set_content_arrangement(ContentArrangement::Disabled);
        if let Some(width) = self.width {
            table.set_content_arrangement(ContentArrangement::Dynamic).set_width(width);
        }
        let names: Vec<_> = head.iter().map(|name| self.word(name.trim_start_matches('>'))).collect();
        if names.iter().any(|name| !name.is_empty()) {
            table.set_header(names);
        }
        for row in rows {
            table.add_row(row.iter().map(|cell| clean(cell)));
        }
        for (index, column) in table.column_iter_mut().enumerate() {
            column.set_padding((0, 2));
            if head.get(index).is_some_and(|name| name.starts_with('>')) {
                column.set_cell_alignment(CellAlignment::Right);
            }
        }
        let lines: Vec<String> = table.lines().map(|line| line.trim_end().to_owned()).collect();
        let indent =
            lines.iter().filter(|line| !line.is_empty()).map(|line| line.len() - line.trim_start().len()).min();
        let indent = indent.unwrap_or(0);
        lines.iter().map(|line| format!("{}\n", line.get(indent..).unwrap_or(""))).collect()
    }

    /// Names at the left, what belongs to them at the right.
    fn pairs(self, rows: Vec<(&'static str, String)>) -> String {
        self.table(&["", ""], rows.into_iter().map(|(name, text)| vec![self.word(name).to_owned(), text]).collect())
    }

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
            let text = step.text.clone().unwrap_or_default();
            let new = step.raw.to_string();
            vec![step.param.to_string(), step.name.clone(), old, new, text, self.word(result).to_owned()]
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
        let perhaps: Vec<&str> = relocation.perhaps.iter().map(|place| place.text.as_str()).collect();
        let mut rows = vec![
            ("from", relocation.from.text.clone()),
            ("to", relocation.to.text.clone()),
            ("result", self.word(result).to_owned()),
        ];
        rows.extend(relocation.now.iter().map(|now| ("answers at", now.text.clone())));
        rows.extend((!perhaps.is_empty()).then(|| ("perhaps at", perhaps.join("; "))));
        rows.extend(relocation.after_restart.iter().map(|place| ("after a restart", place.text.clone())));
        rows.extend(relocation.way_back.iter().map(|command| ("way back", command.clone())));
        [heading, steps, self.pairs(rows)].concat()
    }

    fn heading(self, address: u8, drive: &str) -> String {
        format!("{} {address} ({})\n", self.word("drive"), clean(drive))
    }

    fn scan(self, scan: &Scan) -> String {
        let several = |of: fn(&FoundDrive) -> &String| {
            scan.drives.iter().any(|drive| Some(of(drive)) != scan.drives.first().map(of))
        };
        let shows_port = several(|drive| &drive.port);
        let shows_line = [&scan.line, &scan.protocol].contains(&&"auto".to_owned())
            || several(|drive| &drive.line)
            || several(|drive| &drive.protocol);
        let row = |drive: &FoundDrive| {
            let told = drive.evidence.last().map_or_else(String::new, |row| format!("{}: {}", row.asked, row.answered));
            let mut row = if shows_port { vec![drive.port.clone()] } else { Vec::new() };
            if shows_line {
                row.extend([drive.line.clone(), drive.protocol.clone()]);
            }
            row.extend([
                drive.address.to_string(),
                drive.drive.clone(),
                drive.title.clone(),
                drive.state.as_ref().map_or_else(String::new, |state| state.name.clone()),
                drive.fault.clone().unwrap_or_else(|| "-".to_owned()),
                told,
            ]);
            row
        };
        let rows = scan.drives.iter().map(row).collect();
        let mut head = if shows_port { vec!["port"] } else { Vec::new() };
        if shows_line {
            head.extend(["line", "protocol"]);
        }
        head.extend([">addr", "drive", "name", "state", "fault", "evidence"]);
        self.table(&head, rows)
    }

    fn identity(self, identity: &Identity) -> String {
        let mut text = self.heading(identity.address, &identity.drive);
        if let Some(error) = &identity.error {
            return text + &format!("{}\n", clean(&error.message));
        }
        let product = identity.product.as_ref().map_or_else(String::new, |product| format!(", {product}"));
        text += &format!("{}\n\n", clean(&(identity.title.clone() + &product)));
        text += &self.values(&identity.values);
        let rows = identity.modules.iter().map(|module| {
            let present = if module.present { "present" } else { "not fitted" };
            vec![module.name.clone(), self.word(present).to_owned(), module.evidence.clone()]
        });
        text += "\n";
        text += &self.table(&["module", "", "evidence"], rows.collect());
        let rows = identity.evidence.iter();
        let rows = rows.map(|row| vec![row.asked.clone(), row.answered.clone(), row.tells.clone()]).collect();
        text + "\n" + &self.table(&["asked", "value", "tells"], rows)
    }

    /// One row a value; the address only if there are several drives.
    fn values(self, values: &[Value]) -> String {
        let several = values.iter().any(|value| Some(value.address) != values.first().map(|first| first.address));
        let rows = values.iter().map(|value| {
            let mut row = if several { vec![value.address.to_string()] } else { Vec::new() };
            row.extend([
                value.param.to_string(),
                set_name(value.data_set, value.store),
                value.name.clone(),
                number(value),
                unit(value).to_owned(),
                self.meaning(value),
            ]);
            row
        });
        let head: &[&str] = if several {
            &[">addr", ">param", "set", "name", ">value", "unit", "meaning"]
        } else {
            &[">param", "set", "name", ">value", "unit", "meaning"]
        };
        self.table(head, rows.collect())
    }

    /// What a value stands for: the error, the text, the state and set bits.
    /// A value in a few words: number, unit, meaning.
    fn short(self, value: &Value) -> String {
        let unit = unit(value);
        let meaning = match (self.meaning(value), &value.error) {
            (meaning, _) if meaning.is_empty() => meaning,
            (meaning, Some(_)) => return meaning,
            (meaning, None) => format!("({meaning})"),
        };
        let words = [number(value), unit.to_owned(), meaning];
        words.into_iter().filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
    }

    fn meaning(self, value: &Value) -> String {
        if let Some(error) = &value.error {
            return error.message.clone();
        }
        let mut parts = Vec::new();
        parts.extend(value.text.clone());
        if let Some(word) = &value.word {
            parts.extend(word.state.as_ref().map(|state| state.name.clone()));
            let set = word.bits.iter().filter(|bit| bit.set);
            let set: Vec<_> = set
                .map(|bit| bit.name.clone().unwrap_or_else(|| format!("{} {}", self.word("bit"), bit.bit)))
                .collect();
            parts.push(if set.is_empty() { "-".to_owned() } else { set.join(", ") });
        }
        if let Some(expected) = &value.expected {
            parts.push(format!("({}: {} {expected})", self.word("raw, implausible"), self.word("expected")));
        } else if value.value.is_none() && value.raw.is_some() {
            let unit = value.unit.as_ref().map_or_else(String::new, |unit| format!(": {unit}"));
            parts.push(format!("({}{unit})", self.word("raw, decimals unknown")));
        }
        if value.unconfirmed.iter().any(|field| field == "row") {
            parts.push(format!("({})", self.word("unconfirmed")));
        }
        parts.join(": ")
    }

    fn written(self, values: &[Written]) -> String {
        let rows = values.iter().map(|row| {
            let old = row.old.map_or_else(|| "?".to_owned(), |old| shown(old, false));
            let mut remark = row.error.as_ref().map(|error| error.message.clone());
            remark = remark.or_else(|| row.text.clone());
            let mut remark = remark.into_iter().chain(row.note.clone()).collect::<Vec<_>>();
            if row.result == WriteResult::Planned {
                remark.extend(row.telegram.clone());
                remark.extend(row.meaning.clone());
            }
            vec![
                row.address.to_string(),
                row.param.to_string(),
                set_name(row.data_set, row.store),
                row.store.to_owned(),
                row.name.clone(),
                old,
                shown(row.value, false),
                row.unit.clone().unwrap_or_default(),
                self.word(result(row.result)).to_owned(),
                remark.join("; "),
            ]
        });
        let head = [">addr", ">param", "set", "store", "name", ">old", ">new", "unit", "result", "meaning"];
        self.table(&head, rows.collect())
    }

    fn dataset(self, dataset: &Dataset) -> String {
        let mut text = self.heading(dataset.address, &dataset.drive);
        let active = dataset.active.map_or_else(|| "?".to_owned(), |set| set.to_string());
        let selection = dataset.selection.as_ref().map_or_else(String::new, |value| {
            let number = value.value.map_or_else(|| "?".to_owned(), |number| shown(number, false));
            format!("{number} {}", value.text.clone().unwrap_or_default())
        });
        text += &self.pairs(vec![("active set", active), ("selection", selection)]);
        let sets = dataset.rows.iter().map(|row| row.values.len()).max().unwrap_or(0);
        if sets > 0 {
            let first = dataset.rows.iter().find(|row| row.values.len() == sets);
            let names: Vec<String> =
                first.iter().flat_map(|row| &row.values).map(|value| format!("@{}", value.data_set)).collect();
            let mut head: Vec<&'static str> = vec![">param", "name"];
            head.extend(names.iter().map(|name| match name.as_str() {
                "@1" => ">@1",
                "@2" => ">@2",
                "@3" => ">@3",
                "@4" => ">@4",
                _ => ">value",
            }));
            head.extend(["unit", "equal"]);
            let rows = dataset.rows.iter().map(|row| {
                let mut cells = vec![row.param.to_string(), row.name.clone()];
                cells.extend(row.values.iter().map(|value| match &value.error {
                    None => number(value),
                    Some(error) => error.code.clone(),
                }));
                let is_raw = row.values.iter().any(is_unscaled);
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

    fn diagnosis(self, report: &Diagnosis) -> String {
        let mut text = self.heading(report.address, &report.drive);
        if let Some(error) = &report.error {
            return text + &format!("{}\n", clean(&error.message));
        }
        let mut rows = Vec::new();
        if let Some(status) = &report.status {
            let state = status.state.as_ref().map_or_else(String::new, |state| state.name.clone());
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
                let name = bit.name.clone().unwrap_or_else(|| format!("{} {}", self.word("bit"), bit.bit));
                let help = bit.help.as_ref().map_or_else(String::new, |help| format!(": {help}"));
                rows.push((if index == 0 { "warnings" } else { "" }, format!("{name}{help}")));
            }
        }
        if let Some(register) = &report.error_register {
            let hint = register.hint.as_ref().filter(|_| register.code != 0);
            let hint = hint.map_or_else(String::new, |hint| format!(": {hint}"));
            rows.push(("error register", format!("{} {}{hint}", register.code, register.name)));
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
            vec![count, counter.name.clone(), counter.help.clone()]
        });
        text + "\n" + &self.table(&[">count", "name", "meaning"], rows.collect())
    }

    fn line_check(self, check: &LineCheck) -> String {
        let Adapter { name, driver, about, latency_timer_ms, low_latency, rs485, errors } = &check.adapter;
        let known = [Some(name), driver.as_ref(), about.as_ref()].into_iter().flatten();
        let unknown = || self.word("unknown").to_owned();
        let micros =
            |us: Option<u64>| us.map_or_else(|| "-".to_owned(), |us| format!("{} ms", format_decimal(us as i64, 3)));
        let pauses = &check.pauses;
        let mut rows = vec![
            ("adapter", clean(&known.cloned().collect::<Vec<_>>().join(", "))),
            ("latency timer", latency_timer_ms.map_or_else(unknown, |ms| format!("{ms} ms"))),
            ("low latency", self.word(low_latency).to_owned()),
            ("RS-485 direction", (*rs485).to_owned()),
            ("echo", check.echo.map_or_else(unknown, |echo| self.word(if echo { "yes" } else { "no" }).to_owned())),
            (
                "pauses",
                format!(
                    "{} … {}, {} {}",
                    micros(pauses.shortest_us),
                    micros(pauses.longest_us),
                    self.word("required"),
                    micros(Some(pauses.required_us))
                ),
            ),
        ];
        if let Some(errors) = errors {
            let AdapterErrors { frame, overrun, parity, brk } = errors;
            rows.push(("adapter errors", format!("frame {frame}, parity {parity}, overrun {overrun}, break {brk}")));
        }
        let mut text = format!("{} {} {}\n", check.port, check.line, check.protocol) + &self.pairs(rows);
        for drive in &check.drives {
            text += &format!("\n{} {}\n", self.word("drive"), drive.address);
            if let Some(test) = &drive.test {
                text += &self.pairs(self.link(test));
                text += &self.histogram(&test.histogram);
            }
            if let Some(error) = &drive.error {
                text += &format!("{}\n", clean(&error.message));
            }
        }
        let advice = check.advice.iter().map(|advice| format!("- {}\n", advice.text));
        let nothing = format!("{}\n", self.word("nothing to complain of"));
        let fine = check.drives.iter().all(|drive| drive.error.is_none());
        let advice = if check.advice.is_empty() && fine { nothing } else { advice.collect() };
        text + "\n" + &advice
    }

    /// A bar of up to 40 marks for each bucket.
    fn histogram(self, buckets: &[Bucket]) -> String {
        let most = buckets.iter().map(|bucket| bucket.count).max().unwrap_or(1).max(1);
        let row = |bucket: &Bucket| {
            let from = bucket.from_us / 1_000;
            let range =
                bucket.to_us.map_or_else(|| format!(">= {from} ms"), |to| format!("{from} - {} ms", to / 1_000));
            let marks = (bucket.count * 40).div_ceil(most) as usize;
            vec![range, bucket.count.to_string(), "#".repeat(marks)]
        };
        self.table(&[">reply times", ">count", ""], buckets.iter().map(row).collect())
    }

    /// The entry of the fault memory; number 0 is none.
    fn memory(self, memory: &[Value]) -> Vec<(&'static str, String)> {
        if memory.first().is_some_and(|number| number.raw == Some(0)) {
            return vec![("fault memory", self.word("none").to_owned())];
        }
        let label = |index| if index == 0 { "fault memory" } else { "" };
        let rows = memory.iter().enumerate();
        rows.map(|(index, value)| (label(index), format!("{}: {}", value.name, self.short(value)))).collect()
    }

    fn fault(self, fault: &Fault) -> Vec<(&'static str, String)> {
        let mut rows = vec![("fault", format!("{} {}", fault.key, fault.name))];
        rows.extend(fault.group.iter().map(|group| ("group", group.clone())));
        rows.extend(fault.node.iter().map(|node| ("node", node.to_string())));
        rows.extend(fault.cause.iter().map(|cause| ("cause", cause.clone())));
        rows.extend(fault.remedy.iter().map(|remedy| ("remedy", remedy.clone())));
        rows
    }

    fn link(self, link: &LinkTest) -> Vec<(&'static str, String)> {
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

    fn state(self, report: &StateReport) -> String {
        let mut text = self.heading(report.address, &report.drive);
        if let Some(error) = &report.error {
            return text + &format!("{}\n", clean(&error.message));
        }
        let mut rows = Vec::new();
        rows.extend(report.state.iter().map(|state| ("state", state.name.clone())));
        let mode = |mode: &Value| format!("P.{} = {} {}", mode.param, number(mode), self.meaning(mode));
        rows.extend(report.control_mode.iter().map(|value| ("control mode", mode(value))));
        rows.extend(report.control_mode_stored.iter().map(|value| ("stored, not in force", mode(value))));
        match (&report.fault, report.fault_code) {
            (Some(fault), _) => rows.extend(self.fault(fault)),
            (None, Some(_)) => rows.push(("fault", self.word("none").to_owned())),
            (None, None) => rows.push(("fault", self.word("could not be read").to_owned())),
        }
        for (index, missing) in report.missing.iter().enumerate() {
            rows.push((if index == 0 { "missing" } else { "" }, missing.clone()));
        }
        text += &self.pairs(rows);
        let map = report.states.iter().flat_map(|state| {
            let leads = state.leads.iter().enumerate().map(|(index, lead)| {
                let name = if index == 0 { state.name.clone() } else { String::new() };
                let mark = if state.present && index == 0 { ">>" } else { "" };
                vec![mark.to_owned(), name, lead.clone()]
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

    fn bits(self, bits: &Word) -> String {
        let rows = bits.bits.iter().map(|bit| {
            let unknown = || self.word("unknown").to_owned();
            vec![bit.bit.to_string(), u8::from(bit.set).to_string(), bit.name.clone().unwrap_or_else(unknown)]
        });
        self.table(&[">bit", ">value", "name"], rows.collect())
    }

    fn setpoints(self, report: &SetpointReport) -> String {
        let mut text = self.heading(report.address, &report.drive);
        if let Some(error) = &report.error {
            return text + &format!("{}\n", clean(&error.message));
        }
        for (name, values) in
            [("setpoints", &report.setpoints), ("actual values", &report.actual), ("sources", &report.sources)]
        {
            text += &format!("\n{}\n", self.word(name));
            text += &self.values(values);
        }
        text
    }

    fn params(self, params: &[ParamDoc]) -> String {
        let rows = params.iter().map(|param| {
            vec![
                param.param.to_string(),
                param.slug.clone(),
                param.name.clone(),
                param.unit.clone().unwrap_or_default(),
                range(param),
                param.access.to_owned(),
                param.data_sets.map_or_else(|| "?".to_owned(), |sets| sets.to_string()),
            ]
        });
        self.table(&[">param", "slug", "name", "unit", "range", "access", "data sets"], rows.collect())
    }

    fn param(self, param: &ParamDoc) -> String {
        let mut rows = vec![
            ("param", param.param.to_string()),
            ("slug", param.slug.clone()),
            ("name", param.name.clone()),
            ("type", param.kind.unwrap_or("?").to_owned()),
            ("access", param.access.to_owned()),
            ("data sets", param.data_sets.map_or_else(|| "?".to_owned(), |sets| sets.to_string())),
        ];
        rows.extend(param.decimals.map(|decimals| ("decimals", decimals.to_string())));
        rows.extend(param.unit.iter().map(|unit| ("unit", unit.clone())));
        if param.min.is_some() || param.max.is_some() {
            rows.push(("range", range(param)));
        }
        rows.extend(param.default.map(|default| ("default", shown(default, false))));
        rows.extend(param.hazard.map(|hazard| ("hazard", hazard.to_owned())));
        rows.extend(param.module.iter().map(|module| ("module", module.clone())));
        if param.volatile {
            rows.push(("volatile", self.word("yes").to_owned()));
        }
        if param.after_reset {
            rows.push(("note", self.word("after a reset").to_owned()));
        }
        for (index, choice) in param.values.iter().enumerate() {
            rows.push((if index == 0 { "values" } else { "" }, format!("{} = {}", choice.raw, choice.text)));
        }
        for (index, bit) in param.bits.iter().enumerate() {
            rows.push((
                if index == 0 { "bits" } else { "" },
                format!("{} {}", bit.bit, bit.name.clone().unwrap_or_default()),
            ));
        }
        rows.extend(param.note.iter().map(|note| ("note", note.clone())));
        if !param.unconfirmed.is_empty() {
            rows.push(("unconfirmed", param.unconfirmed.join(", ")));
        }
        rows.push(("source", format!("{} ({})", param.source, param.origin)));
        self.pairs(rows)
    }

    fn decode(self, decode: &Decode) -> String {
        let mut text = String::new();
        match decode.telegrams.as_slice() {
            [] => {}
            [only] => text += &self.telegram(only),
            several => text += &self.telegrams(several),
        }
        if let Some(bits) = &decode.word {
            text += &clean(&bits.hex);
            text += &bits.state.as_ref().map_or_else(String::new, |state| format!(" {}", state.name));
            text += "\n";
            text += &self.bits(bits);
            let help = bits.bits.iter().filter(|bit| bit.set && bit.help.is_some());
            let rows: Vec<_> = help
                .map(|bit| vec![bit.name.clone().unwrap_or_default(), bit.help.clone().unwrap_or_default()])
                .collect();
            if !rows.is_empty() {
                text += "\n";
                text += &self.table(&["", ""], rows);
            }
        }
        match (&decode.fault, decode.kind) {
            (Some(fault), _) => text += &self.pairs(self.fault(fault)),
            (None, "fault") => text += &self.pairs(vec![("fault", self.word("none").to_owned())]),
            _ => {}
        }
        if let Some(register) = &decode.register {
            let mut rows = vec![("error register", format!("{} {}", register.code, register.name))];
            rows.extend(register.hint.iter().map(|hint| ("hint", hint.clone())));
            text += &self.pairs(rows);
        }
        text
    }

    fn motion(self, motion: &Motion) -> String {
        let mut text = self.heading(motion.address, &motion.drive);
        let state = |state: &Option<State>| {
            state.as_ref().map_or_else(|| self.word("not known").to_owned(), |state| state.name.clone())
        };
        let mut rows = vec![("state", format!("{} -> {}", state(&motion.from), state(&motion.to)))];
        if let Some(setpoint) = &motion.setpoint {
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
            rows.push((
                "setpoint",
                format!("{}{below} {}{runs}{reached}{actual}", shown(setpoint.value, false), setpoint.unit),
            ));
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
            let note = stop.note.as_ref().map_or_else(String::new, |note| format!("; {note}"));
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
        rows.extend(motion.notes.iter().map(|note| ("note", note.clone())));
        text += &self.pairs(rows);
        let steps = motion.steps.iter().map(|step| {
            vec![
                step.transition.clone(),
                step.command.clone().unwrap_or_else(|| "-".to_owned()),
                step.control.clone().unwrap_or_else(|| "-".to_owned()),
                step.state.name.clone(),
                format!("{} ms", step.took_ms),
            ]
        });
        let steps = self.table(&[">step", "command", "control word", "state", ">took"], steps.collect());
        if steps.is_empty() { text } else { text + "\n" + &steps }
    }

    fn plan(self, plan: &Plan) -> String {
        let notes: String = plan.notes.iter().map(|note| format!("- {}\n", clean(note))).collect();
        let gap = if notes.is_empty() { "" } else { "\n" };
        self.telegrams(&plan.telegrams) + gap + &notes
    }

    fn telegrams(self, docs: &[TelegramDoc]) -> String {
        let rows = docs.iter().map(|doc| {
            let at = doc.at_us.map_or_else(String::new, |us| format_decimal(us as i64, 3));
            vec![at, direction(doc).to_owned(), doc.hex.clone(), doc.meaning.clone()]
        });
        self.table(&[">ms", "", "telegram", "meaning"], rows.collect())
    }

    fn telegram(self, doc: &TelegramDoc) -> String {
        let mut text = self.table(&[""], vec![vec![doc.hex.clone()], vec![doc.meaning.clone()]]);
        let rows = doc.fields.iter().map(|field| vec![field.hex.clone(), field.name.clone(), field.value.clone()]);
        let rows: Vec<_> = rows.collect();
        if !rows.is_empty() {
            text += "\n";
            text += &self.table(&["", "field", "value"], rows);
        }
        text
    }
}

/// Sign of who speaks: `>` the master, `<` a drive, `?` either, `!` nobody who can be understood.
pub(super) fn direction(doc: &TelegramDoc) -> &'static str {
    match doc.direction {
        _ if !doc.check_ok => "!",
        Some("request") => ">",
        Some(_) => "<",
        None => "?",
    }
}

fn shown(number: Decimal, hex: bool) -> String {
    if hex && (0..=0xFFFF).contains(&number.raw) {
        return format!("0x{:04X}", number.raw);
    }
    format_decimal(number.raw, number.decimals)
}

fn number(value: &Value) -> String {
    match (value.value, value.raw) {
        (Some(number), _) => shown(number, value.hex),
        (None, Some(raw)) => raw.to_string(),
        (None, None) => "-".to_owned(),
    }
}

/// A raw number whose decimals nobody knows.
fn is_unscaled(value: &Value) -> bool {
    value.value.is_none() && value.raw.is_some()
}

/// The unit of the number that is shown; a raw one is in none.
fn unit(value: &Value) -> &str {
    value.unit.as_deref().filter(|_| !is_unscaled(value)).unwrap_or("")
}

/// `2`, or `2ram`; volatile parameters have no EEPROM set.
fn set_name(set: u8, store: &str) -> String {
    if store == "ram" && set > 0 { format!("{set}ram") } else { set.to_string() }
}

fn range(param: &ParamDoc) -> String {
    match (param.min, param.max) {
        (None, None) => String::new(),
        (min, max) => {
            let limit = |limit: Option<Decimal>| limit.map_or_else(|| "?".to_owned(), |limit| shown(limit, false));
            format!("{} … {}", limit(min), limit(max))
        }
    }
}

fn result(result: WriteResult) -> &'static str {
    match result {
        WriteResult::Verified => "verified",
        WriteResult::Written => "written",
        WriteResult::Unchanged => "unchanged",
        WriteResult::Planned => "planned",
        WriteResult::Refused => "refused",
        WriteResult::Unknown => "unknown",
        WriteResult::Differs => "differs",
        WriteResult::Broadcast => "broadcast",
        WriteResult::Skipped => "skipped",
    }
}
