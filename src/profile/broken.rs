//! What is wrong with a TOML file that somebody wrote, and where: in both languages, also where the reader of TOML says it.
//!
//! The reader (crates `toml` and `serde`) speaks English. Its words are known, so they are translated by a table; words that
//! are not in it are quoted.

#[cfg(test)]
mod tests;
mod words;

use super::names::place;
use crate::text::{Text, both};
use serde::de;
use serde_json::error::Category;
use words::{EXPECTED, WRONG};

/// Why a file is refused, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{path}:{line}:{column}: {}", message.en)]
pub struct Broken {
    /// The file as the user names it, or `built-in active.toml`.
    pub path: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// What is wrong, and what would be right.
    pub message: Text,
}

impl Broken {
    /// At this byte of its text.
    pub fn at(path: &str, text: &str, byte: usize, message: Text) -> Self {
        let (line, column) = place(text, byte);
        Broken { path: path.to_owned(), line, column, message }
    }

    /// In words for people.
    pub fn text(&self) -> Text {
        let Broken { path, line, column, message } = self;
        both!("{path}:{line}:{column}: {message}", "{path}:{line}:{column}: {message}", message)
    }
}

/// Where the reader of TOML stumbled, in bytes, and what it says of it.
pub fn stumbled(error: &toml::de::Error) -> (usize, Text) {
    (error.span().map_or(0, |span| span.start), said(error.message()))
}

/// Why a file is not the JSON that it should be, and where.
pub fn stumbled_json(error: &serde_json::Error) -> Text {
    let (line, column, message) = (error.line(), error.column(), error.to_string());
    let why = match error.classify() {
        Category::Data => said(message.rsplit_once(" at line ").map_or(message.as_str(), |(why, _)| why)),
        Category::Eof => both!("it ends before it is complete", "sie endet, bevor sie vollständig ist"),
        Category::Syntax | Category::Io => both!("that is no JSON", "das ist kein JSON"),
    };
    both!("line {line}, column {column}: {why}", "Zeile {line}, Spalte {column}: {why}", why)
}

/// An error of our own for the reader, which hands on a single text: both languages go in it, for [`stumbled`] to part them.
pub fn in_both<E: de::Error>(text: &Text) -> E {
    E::custom(format_args!("{}{BETWEEN}{}", text.en, text.de))
}

/// Between the two languages: NUL, which no TOML has.
const BETWEEN: char = '\0';
/// Longest message, in characters: it may quote the file.
const LONGEST: usize = 800;

/// A message that may quote the file, without its control characters and not longer than a few lines.
pub(super) fn shorten(message: &str) -> String {
    message.chars().map(|c| if c.is_control() { ' ' } else { c }).take(LONGEST).collect()
}

fn said(message: &str) -> Text {
    if let Some((en, de)) = message.split_once(BETWEEN) {
        return Text { en: shorten(en).into(), de: shorten(de).into() };
    }
    let message = shorten(message);
    by_serde(&message).or_else(|| by_toml(&message)).unwrap_or_else(|| Text::quoted(&message))
}

/// What does not fit the keys and types of the format.
fn by_serde(message: &str) -> Option<Text> {
    if let Some(name) = message.strip_prefix("missing field ") {
        return Some(both!("missing field {name}", "es fehlt {name}"));
    }
    if let Some(name) = message.strip_prefix("duplicate field ") {
        return Some(both!("{name} stands twice", "{name} steht zweimal da"));
    }
    if message.starts_with("data did not match any variant of untagged enum ") {
        return Some(both!("a value of another kind is expected", "erwartet wird ein Wert anderer Art"));
    }
    if message == "wanted string or table" {
        return Some(both!("expected a text in quotes", "erwartet: ein Text in Anführungszeichen"));
    }
    let (what, expected) = message.split_once(", expected ")?;
    for (start, en, de) in [
        ("unknown field ", "unknown field", "unbekannter Schlüssel"),
        ("unknown variant ", "unknown word", "unbekanntes Wort"),
    ] {
        if let Some(name) = what.strip_prefix(start) {
            let names = names(expected);
            return Some(both!("{en} {name}, expected {names}", "{de} {name}; erwartet: {names}", names));
        }
    }
    let wanted = wanted(expected);
    if let Some(count) = what.strip_prefix("invalid length ") {
        let en_de = both!("expected {wanted}, got {count} of them", "erwartet: {wanted}; dort stehen {count}", wanted);
        return Some(en_de);
    }
    let got = got(what.strip_prefix("invalid type: ").or_else(|| what.strip_prefix("invalid value: "))?);
    Some(both!("expected {wanted}, got {got}", "erwartet: {wanted}; dort steht {got}", wanted, got))
}

/// Names that would be right: `a` or `b`, one of `a`, `b`, `c`.
fn names(expected: &str) -> Text {
    let names = expected.strip_prefix("one of ").unwrap_or(expected);
    Text { en: expected.to_owned().into(), de: names.replace("` or `", "`, `").into() }
}

/// What would have been right.
fn wanted(expected: &str) -> Text {
    let whole = |low: i128, high: i128| both!("a whole number {low} to {high}", "eine ganze Zahl von {low} bis {high}");
    match expected {
        "u8" => whole(0, u8::MAX.into()),
        "u16" => whole(0, u16::MAX.into()),
        "u32" => whole(0, u32::MAX.into()),
        "i64" | "u64" | "usize" => both!("a whole number", "eine ganze Zahl"),
        "f64" => both!("a number", "eine Zahl"),
        "a boolean" => both!("`true` or `false`", "`true` oder `false`"),
        "a string" | "string only" | "path string" | "variant identifier" => {
            both!("a text in quotes", "ein Text in Anführungszeichen")
        }
        "a sequence" => both!("a list in [ ]", "eine Liste in [ ]"),
        "a map" => both!("a table", "eine Tabelle"),
        "a number, or a number in quotes" => {
            both!("a number, or a number in quotes", "eine Zahl oder eine Zahl in Anführungszeichen")
        }
        "any valid TOML value" => both!("a number that TOML can hold", "eine Zahl, die TOML fasst"),
        _ if expected.starts_with("struct ") => both!("a table", "eine Tabelle"),
        _ => Text::quoted(expected),
    }
}

/// What stands there.
fn got(unexpected: &str) -> Text {
    let (kind, value) = unexpected.split_once(' ').unwrap_or((unexpected, ""));
    let value = value.trim_end_matches(" as i128").trim_matches('`').trim_start_matches("point `");
    match kind {
        "string" => both!("the text {value}", "der Text {value}"),
        "integer" | "floating" => both!("the number {value}", "die Zahl {value}"),
        "boolean" => both!("`{value}`", "`{value}`"),
        "sequence" => both!("a list", "eine Liste"),
        "map" => both!("a table", "eine Tabelle"),
        "unit" => both!("no value", "kein Wert"),
        "datetime" => both!("a date or time", "ein Datum oder eine Uhrzeit"),
        _ => Text::quoted(unexpected),
    }
}

/// What is no TOML: what is wrong, and what was expected there.
fn by_toml(message: &str) -> Option<Text> {
    // Dates are read to their last digit, and stand in none of our files.
    if ["invalid date", "invalid time", "invalid offset"].iter().any(|start| message.starts_with(start)) {
        return Some(Text { en: message.to_owned().into(), de: "ungültiges Datum oder ungültige Uhrzeit".into() });
    }
    if message.starts_with("cannot extend value of type ") {
        let de = "ein Wert, der schon da steht, lässt sich nicht mit einem Punkt erweitern";
        return Some(Text { en: message.to_owned().into(), de: de.into() });
    }
    let (what, expected) = message.split_once(", expected ").unwrap_or((message, ""));
    let what = row(WRONG, what)?;
    if expected.is_empty() {
        return Some(what);
    }
    // A comma may itself be what was expected.
    let marked = expected.replace("`,`", "`\u{1}`");
    let expected = marked.split(", ").map(|one| {
        let one = one.replace('\u{1}', ",");
        row(EXPECTED, &one).unwrap_or_else(|| Text::name(one))
    });
    let expected = Text::join(&expected.collect::<Vec<_>>(), ", ");
    Some(both!("{what}, expected {expected}", "{what}; erwartet: {expected}", what, expected))
}

fn row(rows: &[(&'static str, &'static str)], en: &str) -> Option<Text> {
    rows.iter().find(|row| row.0 == en).map(|row| Text::new(row.0, row.1))
}
