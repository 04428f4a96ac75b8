//! Writing a parameter file.

use super::file::{Head, Provenance, SavedDrive, VERSION};
use super::settings::{Setting, Settings};
use crate::profile::family::Family;
use crate::profile::param::Param;
use crate::profile::select::Store;
use crate::profile::value;
use serde::Serialize;
use std::fmt::Write;

/// The text of a file with these settings: the same settings make the same text.
pub fn print(head: &Head, settings: &Settings, family: &Family) -> String {
    let mut text = String::from("# Parameters of a drive, for antrieb (docs/parameter-files.md).\n");
    let _ = writeln!(text, "antrieb = {VERSION}\n\n[drive]");
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
        text.push_str("\n# What this file does not hold, and why.\n[not-held]\n");
        for (reason, list) in &head.not_held {
            let _ = writeln!(text, "{} = {}", reason.name(), quoted(list));
        }
    }
    if !head.types.is_empty() {
        text.push_str("\n# Found out by asking.\n[types]\n");
        for (number, kind) in &head.types {
            let _ = writeln!(text, "{number} = {}", quoted(kind.name()));
        }
    }
    text.push_str("\n[values]\n");
    for setting in settings.iter() {
        text.push_str(&line(setting, family));
    }
    text
}

/// The text of a file that takes a transaction back: what stood there, what was to come, and where.
pub fn print_undo(head: &Head, old: &Settings, (new, store): (&Settings, Store), family: &Family) -> String {
    let mut text = print(head, old, family);
    text.push_str("\n# What was to come; `antrieb dataset undo` brings back the values above.\n[undo]\n");
    let memory = if store == Store::Ram { "ram" } else { "eeprom" };
    let _ = write!(text, "memory = \"{memory}\"\n\n[undo.values]\n");
    text.extend(new.iter().map(|setting| line(setting, family)));
    text
}

/// A value as a file holds it and as it is typed: `1450 1/min`, or `raw 1234` where nobody knows its decimals.
pub fn value_text(param: &Param, raw: i64) -> String {
    match &param.unit {
        Some(_) if !param.has_scale() => format!("raw {raw}"),
        Some(unit) => format!("{} {unit}", value::written(param, raw)),
        None => value::written(param, raw),
    }
}

/// The line of a setting: `"372@2" = "1450 1/min"  # rated-speed`.
pub fn line(setting: &Setting, family: &Family) -> String {
    let Setting { param, set, raw, .. } = setting;
    let key = if *set == 0 { param.id.to_string() } else { format!("{}@{set}", param.id) };
    let more = match family.text_of(param, *raw) {
        Some(text) => format!(": {}", text.en),
        None if param.hex && *raw >= 0 => format!(": 0x{raw:04X}"),
        None => String::new(),
    };
    let scale = match &param.unit {
        Some(unit) if !param.has_scale() => format!(", in {unit} with unknown decimals"),
        _ => String::new(),
    };
    // A comment ends with its line, whatever a catalogue says.
    let comment: String =
        format!("{}{more}{scale}", param.slug).chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
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
