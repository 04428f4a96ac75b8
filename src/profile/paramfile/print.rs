//! Writing a parameter file.

use super::file::{Head, Provenance, SavedDrive};
use super::settings::{Setting, Settings};
use crate::profile::family::Family;
use crate::profile::select::Store;
use crate::profile::value::{self, value_text};
use crate::text::{Lang, Text};
use serde::Serialize;
use std::fmt::Write;

const TITLE: &Text = &Text::new(
    "Parameters of a drive, for antrieb (docs/parameter-files.md).",
    "Parameter eines Antriebs, für antrieb (docs/parameter-files.md).",
);
const NOT_HELD: &Text =
    &Text::new("What this file does not hold, and why.", "Was diese Datei nicht enthält, und warum.");
const TYPES: &Text = &Text::new("Found out by asking.", "Durch Fragen herausgefunden.");
const TO_COME: &Text = &Text::new(
    "What was to come; `antrieb dataset undo` brings back the values above.",
    "Was kommen sollte; `antrieb dataset undo` holt die Werte oben zurück.",
);

const IN_RAM: &Text = &Text::new(
    "What stood in the RAM alone; `antrieb dataset undo` names it and does not bring it back.",
    "Was nur im RAM stand; `antrieb dataset undo` nennt es und holt es nicht zurück.",
);

const UNPROVEN: &Text = &Text::new(
    "What perhaps did not come back; `antrieb dataset undo` writes it, whatever the drive tells of it.",
    "Was vielleicht nicht zurückkam; `antrieb dataset undo` schreibt es, was der Antrieb davon auch sagt.",
);

/// What takes a transaction back.
#[derive(Clone, Debug)]
pub struct UndoSettings {
    /// What stood there.
    pub old: Settings,
    /// What was to come.
    pub new: Settings,
    /// Where it went.
    pub store: Store,
    /// What stood in the RAM alone.
    pub ram: Settings,
    /// What perhaps did not come back.
    pub unproven: Settings,
}

/// The text of a file with these settings: the same settings make the same text.
pub fn print(head: &Head, settings: &Settings, family: &Family) -> String {
    print_as(1, head, settings, family)
}

/// The same, as of a version of the format: the lowest that knows all of it, so that older programs read what they can.
fn print_as(version: u32, head: &Head, settings: &Settings, family: &Family) -> String {
    let says = |comment: &Text| format!("# {}\n", comment.get(head.lang));
    let mut text = says(TITLE);
    let _ = writeln!(text, "antrieb = {version}\n\n[drive]");
    let SavedDrive { evidence, .. } = &head.drive;
    text.push_str(&table(&SavedDrive { evidence: Vec::new(), ..head.drive.clone() }));
    if !evidence.is_empty() {
        let rows = evidence.iter().map(|row| format!("  {},\n", quoted(row)));
        let _ = writeln!(text, "evidence = [\n{}]", rows.collect::<String>());
    }
    if head.saved != (Provenance { complete: true, ..Provenance::default() }) {
        let _ = write!(text, "\n[saved]\n{}", table(&head.saved));
    }
    if !head.not_held.is_empty() {
        let _ = write!(text, "\n{}[not-held]\n", says(NOT_HELD));
        for (reason, list) in &head.not_held {
            let _ = writeln!(text, "{} = {}", reason.name(), quoted(list));
        }
    }
    if !head.types.is_empty() {
        let _ = write!(text, "\n{}[types]\n", says(TYPES));
        for (number, kind) in &head.types {
            let _ = writeln!(text, "{number} = {}", quoted(kind.name()));
        }
    }
    text.push_str("\n[values]\n");
    for setting in settings.iter() {
        text.push_str(&line(setting, family, head.lang));
    }
    text
}

/// The text of a file that takes a transaction back.
pub fn print_undo(head: &Head, settings: &UndoSettings, family: &Family) -> String {
    let UndoSettings { old, new, store, ram, unproven } = settings;
    let mut text = print_as(version(settings), head, old, family);
    let _ = write!(text, "\n# {}\n[undo]\n", TO_COME.get(head.lang));
    let memory = if *store == Store::Ram { "ram" } else { "eeprom" };
    let _ = write!(text, "memory = \"{memory}\"\n\n[undo.values]\n");
    text.extend(new.iter().map(|setting| line(setting, family, head.lang)));
    for (name, what, settings) in [("ram", IN_RAM, ram), ("unproven", UNPROVEN, unproven)] {
        text.push_str(&section(name, what, settings, family, head.lang));
    }
    text
}

/// A table of settings behind what takes a transaction back; none where there are none.
fn section(name: &str, what: &Text, settings: &Settings, family: &Family, lang: Lang) -> String {
    if settings.is_empty() {
        return String::new();
    }
    let rows: String = settings.iter().map(|setting| line(setting, family, lang)).collect();
    format!("\n# {}\n[undo.{name}]\n{rows}", what.get(lang))
}

/// The lowest version of the format that knows all that an undo file states, so that older programs read what they can.
fn version(UndoSettings { ram, unproven, .. }: &UndoSettings) -> u32 {
    if ram.is_empty() && unproven.is_empty() { 1 } else { 2 }
}

/// The text of an undo file with these as not proven, and everything else as a hand may have left it. Whether it was read so is for the
/// caller: a file can be written in many ways.
pub fn with_unproven(text: &str, settings: &UndoSettings, family: &Family, lang: Lang) -> String {
    let (unproven, of_version) = (&settings.unproven, version(settings).to_string());
    let is_head = |row: &str| UNPROVEN.both().iter().any(|what| row == format!("# {what}"));
    let (mut lines, mut is_old) = (Vec::new(), false);
    for row in text.lines() {
        let told = row.trim();
        if told.starts_with('[') {
            is_old = told == "[undo.unproven]";
            lines.pop_if(|last: &mut String| is_old && is_head(last));
        }
        if is_old {
            continue;
        }
        let stated = told.strip_prefix("antrieb").and_then(|rest| rest.trim_start().strip_prefix('='));
        let is_other = stated.is_some_and(|stated| ["1", "2"].contains(&stated.trim()) && stated.trim() != of_version);
        lines.push(if is_other { format!("antrieb = {of_version}") } else { row.to_owned() });
    }
    let text = lines.join("\n");
    format!("{}\n{}", text.trim_end(), section("unproven", UNPROVEN, unproven, family, lang))
}

/// The line of a setting: `"372@2" = "1450 1/min"  # rated-speed`; in German its name stands behind the slug.
pub fn line(setting: &Setting, family: &Family, lang: Lang) -> String {
    let Setting { param, set, raw, .. } = setting;
    let key = if *set == 0 { param.key() } else { format!("{}@{set}", param.key()) };
    let more = match family.text_of(param, *raw) {
        Some(text) => format!(": {}", text.get(lang)),
        None if param.hex && *raw >= 0 => format!(": 0x{raw:04X}"),
        None => String::new(),
    };
    let scale = match &param.unit {
        Some(unit) if !param.has_scale() => {
            lang.pick(format!(", in {unit} with unknown decimals"), format!(", in {unit}, Nachkommastellen unbekannt"))
        }
        _ => String::new(),
    };
    let name = match lang {
        Lang::En => param.slug.clone(),
        Lang::De => format!("{}, {}", param.slug, param.name.de),
    };
    // A comment ends with its line, whatever a catalogue says.
    let comment: String =
        format!("{name}{more}{scale}").chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    // What would be read as another value is told as it is.
    let text = value_text(param, *raw);
    let is_same = value::parse(&text, param, &family.choices(param)).is_ok_and(|read| read == *raw);
    let text = if is_same { text } else { format!("raw {raw}") };
    format!("{} = {}  # {comment}\n", quoted(&key), quoted(&text))
}

/// The rows of a table, `key = value`.
fn table(rows: &impl Serialize) -> String {
    toml::to_string(rows).unwrap_or_default()
}

/// A string of TOML.
fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}
