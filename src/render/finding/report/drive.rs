//! A drive on paper: who it is, what it does, how it is set.

use super::paper::{Block, Cell, Table};
use crate::outcome::{Diagnosis, Identity, ReportedDrive, Value};
use crate::render::finding::page::{Page, number, unit};
use crate::text::both;

impl Page {
    pub(super) fn drive_part(self, drive: &ReportedDrive, changed_only: bool) -> Vec<Block> {
        let called = drive.called.as_ref().map_or_else(String::new, |called| format!(" · {called}"));
        let family = self.family(&drive.drive);
        let title = format!("{} {}{called} ({family})", self.word("drive"), self.address(drive.address));
        let mut blocks = vec![Block::Heading(1, title)];
        if let Some(error) = &drive.error {
            blocks.push(Block::Alarm(self.say(&error.message)));
            blocks.extend(error.hint.as_ref().map(|hint| Block::Text(self.say(hint))));
        }
        if let Some(found) = &drive.diagnosis {
            blocks.extend(self.state_part(found));
        }
        if let Some(identity) = &drive.identity {
            blocks.extend(self.identity_part(identity));
        }
        if !drive.values.is_empty() || drive.compared > 0 {
            blocks.extend(self.deviations(drive));
            blocks.extend(self.settings_part(drive, changed_only));
        }
        blocks
    }

    fn state_part(self, found: &Diagnosis) -> Vec<Block> {
        let mut blocks = vec![Block::Heading(2, self.word("state").to_owned())];
        if let Some(fault) = &found.fault {
            blocks.push(Block::Alarm(format!("{}: {}", self.word("fault"), self.say(&fault.told()))));
        }
        let mut rows = Vec::new();
        if let Some(status) = &found.status {
            let state = self.say_or_not(status.state.as_ref().map(|state| &state.name));
            rows.push(("state", format!("{state} ({})", status.hex)));
        }
        rows.extend(self.fault_of(found));
        rows.extend(found.warnings.iter().flat_map(|word| self.warnings(word)));
        rows.extend(self.missing(&found.missing));
        rows.extend(self.memory(&found.memory));
        rows.extend(
            found
                .error_register
                .iter()
                .filter(|register| register.code != 0)
                .map(|register| ("error register", format!("{} {}", register.code, self.say(&register.name)))),
        );
        rows.extend(found.watchdog.iter().map(|value| ("watchdog", self.short(value))));
        let label = |name: &str| if name.is_empty() { String::new() } else { self.word(name).to_owned() };
        blocks.push(Block::Facts(rows.into_iter().map(|(name, text)| (label(name), text)).collect()));
        let counted =
            found.counters.iter().filter_map(|counter| Some((counter, counter.count.filter(|count| *count > 0)?)));
        let rows: Vec<_> = counted.map(|(counter, count)| vec![count.to_string(), self.say(&counter.name)]).collect();
        if !rows.is_empty() {
            blocks.push(self.grid(&[">count", "diagnostic counter"], rows.into_iter()));
        }
        blocks
    }

    fn identity_part(self, identity: &Identity) -> Vec<Block> {
        let mut facts = vec![self.fact("title", self.say(&identity.title))];
        facts.extend(identity.product.clone().map(|product| self.fact("product", product)));
        facts.extend(identity.values.iter().map(|value| (self.say(&value.name), self.short(value))));
        facts.extend(identity.modules.iter().map(|module| {
            let present = self.word(if module.present { "present" } else { "not fitted" });
            (format!("{} {}", self.word("module"), module.name), format!("{present}: {}", self.say(&module.evidence)))
        }));
        let evidence = identity.evidence.iter();
        let evidence = evidence.map(|row| [&row.asked, &row.answered, &row.tells].map(|text| self.say(text)).to_vec());
        vec![
            Block::Heading(2, self.word("identity").to_owned()),
            Block::Facts(facts),
            self.grid(&["asked", "value", "tells"], evidence),
        ]
    }

    /// What differs from the factory settings.
    fn deviations(self, drive: &ReportedDrive) -> Vec<Block> {
        let (count, compared) = (drive.differences.len(), drive.compared);
        let told = both!(
            "{count} of {compared} values with a known factory setting differ from it.",
            "{count} von {compared} Werten mit bekannter Werkseinstellung weichen von ihr ab."
        );
        let heading = both!("Deviations from the factory settings", "Abweichungen von der Werkseinstellung");
        let mut blocks = vec![Block::Heading(2, self.say(&heading)), Block::Text(self.say(&told))];
        let rows = drive.differences.iter().map(|row| {
            vec![
                row.param.to_string(),
                if row.data_set == 0 { String::new() } else { row.data_set.to_string() },
                self.say(&row.name),
                self.held((row.a_raw, row.a_value, row.a_text.as_ref()), row.b_value),
                row.error.as_ref().map_or_else(
                    || self.held((row.b_raw, row.b_value, row.b_text.as_ref()), row.a_value),
                    |error| self.say(&error.message),
                ),
                self.unit(row),
            ]
        });
        if count > 0 {
            blocks.push(self.grid(&[">param", "set", "name", ">factory", ">drive", "unit"], rows));
        }
        blocks
    }

    /// The settings, the four data sets side by side.
    fn settings_part(self, drive: &ReportedDrive, changed_only: bool) -> Vec<Block> {
        let heading = both!("Settings, as stored", "Einstellungen, wie gespeichert");
        let mut blocks = vec![Block::Heading(2, self.say(&heading))];
        let has_sets = drive.values.iter().any(|value| value.data_set > 0);
        let bold =
            both!("What differs from the factory setting is bold.", "Was von der Werkseinstellung abweicht, ist fett.");
        let all = match has_sets {
            true => both!(
                "One value alone stands for all four data sets. {bold}",
                "Ein Wert allein gilt für alle vier Datensätze. {bold}",
                bold
            ),
            false => bold,
        };
        let few = both!(
            "Listed is what differs from the factory setting, or from data set to data set.",
            "Aufgeführt ist, was von der Werkseinstellung oder von Datensatz zu Datensatz abweicht."
        );
        blocks.push(Block::Text(self.say(if changed_only { &few } else { &all })));
        if !drive.in_force.is_empty() {
            blocks.push(Block::List(drive.in_force.iter().map(|note| self.say(note)).collect()));
        }
        let columns: &[&str] = if has_sets { &["1", "2", "3", "4"] } else { &["value"] };
        let rows = drive.values.chunk_by(|one, other| one.param == other.param);
        let rows = rows.map(|sets| self.sets_row(drive, sets, columns.len()));
        let column = |name: &&str| {
            let is_set = name.parse::<u8>().is_ok();
            (if is_set { (*name).to_owned() } else { self.word(name).to_owned() }, true)
        };
        let mut head = vec![(self.word("param").to_owned(), true), (self.word("name").to_owned(), false)];
        head.extend(columns.iter().map(column));
        head.push((self.word("unit").to_owned(), false));
        blocks.push(Block::Table(Table { head, rows: rows.collect() }));
        let left =
            drive.not_held.iter().map(|row| vec![row.count.to_string(), self.say(&row.text), row.params.clone()]);
        if !drive.not_held.is_empty() {
            blocks.push(Block::Heading(2, self.word("not in the list").to_owned()));
            blocks.push(self.grid(&[">count", "why", "param"], left));
        }
        let signature =
            drive.signature.clone().unwrap_or_else(|| self.word("none: not everything was read").to_owned());
        blocks.push(Block::Facts(vec![self.fact("signature of the settings", signature)]));
        blocks
    }

    /// A parameter with its data sets.
    fn sets_row(self, drive: &ReportedDrive, sets: &[Value], columns: usize) -> Vec<Cell> {
        let Some(first) = sets.first() else { return Vec::new() };
        let is_marked = |value: &Value| {
            let is_it = |set: u8| [0, value.data_set].contains(&set) || value.data_set == 0;
            drive.differences.iter().any(|row| row.param == value.param && is_it(row.data_set))
        };
        let cell = |value: &Value, span| {
            let meaning = self.meaning(value);
            let text = if meaning.is_empty() { number(value) } else { format!("{} {meaning}", number(value)) };
            Cell { text, span, is_marked: is_marked(value) }
        };
        let mut row = vec![Cell::from(first.param.to_string()), Cell::from(self.say(&first.name))];
        match sets {
            [one] if one.data_set == 0 => row.push(cell(one, columns)),
            _ => row.extend((1..=columns).map(|set| {
                let held = sets.iter().find(|value| usize::from(value.data_set) == set);
                held.map_or_else(|| Cell::from(String::new()), |value| cell(value, 1))
            })),
        }
        row.push(Cell::from(unit(first).to_owned()));
        row
    }
}
