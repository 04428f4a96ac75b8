//! What is wrong with a TOML file that somebody wrote, and where: in both languages, also where the reader of TOML says it.
//!
//! The reader (crates `toml` and `serde`) speaks English. Its words are known, so they are translated by a table; words that
//! are not in it are quoted.

use super::names::place;
use crate::text::{Text, both};
use serde::de;

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
        _ if expected.starts_with("struct ") => both!("a table", "eine Tabelle"),
        _ => Text::quoted(expected),
    }
}

/// What stands there.
fn got(unexpected: &str) -> Text {
    let (kind, value) = unexpected.split_once(' ').unwrap_or((unexpected, ""));
    let value = value.trim_matches('`').trim_start_matches("point `");
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

/// What can be wrong (toml 1.2, toml_parser 1.1).
const WRONG: &[(&str, &str)] = &[
    ("`_` may only go between digits", "`_` steht nur zwischen Ziffern"),
    ("cannot recurse further; max recursion depth met", "zu tief verschachtelt"),
    ("carriage return must be followed by newline", "hinter einem Wagenrücklauf steht kein Zeilenende"),
    ("could not allocate for string", "der Speicher reicht für diesen Text nicht"),
    ("duplicate key", "dieser Schlüssel steht zweimal da"),
    ("extra `=`", "ein `=` zu viel"),
    ("extra assignment between key-value pairs", "ein `=` zu viel zwischen zwei Werten"),
    ("extra comma in array", "ein Komma zu viel in der Liste"),
    ("extra comma in inline table", "ein Komma zu viel in der Tabelle"),
    ("floating-point number overflowed", "die Zahl ist zu groß"),
    ("integer number overflowed", "die Zahl ist zu groß"),
    ("integers with a radix cannot be signed", "eine Zahl mit 0x, 0o oder 0b hat kein Vorzeichen"),
    ("invalid basic string", "ungültiger Text in Anführungszeichen"),
    ("invalid binary number", "ungültige Binärzahl"),
    ("invalid boolean", "das ist weder true noch false"),
    ("invalid comment character", "ungültiges Zeichen im Kommentar"),
    ("invalid exponent", "ungültiger Exponent"),
    ("invalid float", "ungültige Kommazahl"),
    ("invalid fraction", "ungültige Nachkommastellen"),
    ("invalid hexadecimal number", "ungültige Hexadezimalzahl"),
    ("invalid inline table element", "ungültiger Eintrag in der Tabelle"),
    ("invalid integer number", "ungültige ganze Zahl"),
    ("invalid key", "ungültiger Schlüssel"),
    ("invalid key-value pair", "ungültige Zeile"),
    ("invalid literal string", "ungültiger Text in einfachen Anführungszeichen"),
    ("invalid mantissa", "ungültige Zahl"),
    ("invalid multi-line basic string", "ungültiger mehrzeiliger Text"),
    ("invalid multi-line literal string", "ungültiger mehrzeiliger Text in einfachen Anführungszeichen"),
    ("invalid octal number", "ungültige Oktalzahl"),
    ("invalid string", "ungültiger Text"),
    ("invalid table", "ungültige Tabelle"),
    ("invalid unquoted key", "ungültiger Schlüssel ohne Anführungszeichen"),
    ("invalid value", "ungültiger Wert"),
    ("key with no value", "ein Schlüssel ohne Wert"),
    ("keys cannot be multi-line basic strings", "ein Schlüssel ist kein mehrzeiliger Text"),
    ("keys cannot be multi-line literal strings", "ein Schlüssel ist kein mehrzeiliger Text"),
    ("missing array opening", "der Anfang der Liste fehlt"),
    ("missing assignment between key-value pairs", "zwischen Schlüssel und Wert fehlt das `=`"),
    ("missing comma between array elements", "zwischen zwei Einträgen der Liste fehlt ein Komma"),
    ("missing comma between key-value pairs", "zwischen zwei Einträgen der Tabelle fehlt ein Komma"),
    ("missing comment start", "der Anfang des Kommentars fehlt"),
    ("missing escaped value", "hinter `\\` fehlt etwas"),
    ("missing inline table opening", "der Anfang der Tabelle fehlt"),
    ("missing key for inline table element", "ein Wert der Tabelle ohne Schlüssel"),
    ("missing opening quote", "das erste Anführungszeichen fehlt"),
    ("missing table open", "der Anfang der Tabelle fehlt"),
    ("missing value", "der Wert fehlt"),
    ("missing value for key", "ein Schlüssel ohne Wert"),
    ("radix must be lowercase", "0x, 0o und 0b werden klein geschrieben"),
    ("recursion limit", "zu tief verschachtelt"),
    ("redundant integer number prefix", "0x, 0o oder 0b steht zweimal da"),
    ("redundant numeric sign", "zwei Vorzeichen"),
    ("string values must be quoted", "ein Text braucht Anführungszeichen"),
    ("too few unicode value digits", "zu wenige Ziffern in einem Unicode-Zeichen"),
    ("u64 value was too large", "die Zahl ist zu groß"),
    ("unclosed array", "die Liste hat kein Ende"),
    ("unclosed array table", "der Kopf der Tabelle hat kein Ende"),
    ("unclosed inline table", "die Tabelle hat kein Ende"),
    ("unclosed table", "der Kopf der Tabelle hat kein Ende"),
    ("unexpected `=` in array", "ein `=` in der Liste"),
    ("unexpected content", "unerwarteter Inhalt"),
    ("unexpected content between comment and newline", "unerwarteter Inhalt zwischen Kommentar und Zeilenende"),
    ("unexpected key or value", "hier gehört weder ein Schlüssel noch ein Wert hin"),
    ("unexpected leading zero", "eine Null zu viel vor der Zahl"),
    ("unexpected sign", "hier gehört kein Vorzeichen hin"),
    ("unquoted keys cannot be empty", "ein Schlüssel ohne Anführungszeichen ist nicht leer"),
];

/// What can be expected; what stands between backticks is the same in both languages.
const EXPECTED: &[(&str, &str)] = &[
    ("basic string", "Text in Anführungszeichen"),
    ("characters", "Zeichen"),
    ("digits", "Ziffern"),
    ("end-of-input", "Ende der Datei"),
    ("key", "ein Schlüssel"),
    ("letters", "Buchstaben"),
    ("literal string", "Text in einfachen Anführungszeichen"),
    ("multi-line basic string", "mehrzeiliger Text"),
    ("multi-line literal string", "mehrzeiliger Text in einfachen Anführungszeichen"),
    ("newline", "Zeilenende"),
    ("non-double-quote visible characters", "sichtbare Zeichen"),
    ("non-single-quote characters", "Zeichen"),
    ("non-single-quote visible characters", "sichtbare Zeichen"),
    ("nothing", "nichts"),
    ("numbers", "Ziffern"),
    ("printable characters", "druckbare Zeichen"),
    ("string", "ein Text"),
    ("unquoted string", "Text ohne Anführungszeichen"),
    ("unicode hexadecimal value", "Hexadezimalziffern eines Unicode-Zeichens"),
    ("value", "ein Wert"),
    ("whitespace", "Leerraum"),
];

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;
    use std::collections::BTreeMap;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[expect(dead_code, reason = "only what goes wrong with it is looked at")]
    struct Shape {
        #[serde(default)]
        small: u8,
        #[serde(default)]
        whole: i64,
        #[serde(default)]
        broken: f64,
        #[serde(default)]
        text: String,
        #[serde(default)]
        is: bool,
        #[serde(default)]
        list: Vec<i64>,
        #[serde(default)]
        pair: Option<(u8, u8)>,
        #[serde(default)]
        rows: BTreeMap<String, i64>,
        inner: Option<Inner>,
        word: Option<Word>,
        either: Option<Either>,
    }

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    #[expect(dead_code, reason = "only what goes wrong with it is looked at")]
    struct Inner {
        needed: u16,
    }

    #[derive(Debug, Deserialize)]
    #[serde(rename_all = "lowercase")]
    enum Word {
        One,
        Two,
    }

    #[derive(Debug, Deserialize)]
    #[serde(untagged)]
    #[expect(dead_code, reason = "only what goes wrong with it is looked at")]
    enum Either {
        Number(i64),
        Several(Vec<i64>),
    }

    fn of(text: &str) -> Text {
        stumbled(&toml::from_str::<Shape>(text).unwrap_err()).1
    }

    #[test]
    fn types_are_told_in_words() {
        for (text, en, de) in [
            (
                "whole = \"1\"",
                "expected a whole number, got the text \"1\"",
                "erwartet: eine ganze Zahl; dort steht der Text \"1\"",
            ),
            (
                "small = 300",
                "expected a whole number 0 to 255, got the number 300",
                "erwartet: eine ganze Zahl von 0 bis 255; dort steht die Zahl 300",
            ),
            ("small = 1.5", "expected a whole number 0 to 255, got the number 1.5", "dort steht die Zahl 1.5"),
            (
                "is = 1",
                "expected `true` or `false`, got the number 1",
                "erwartet: `true` oder `false`; dort steht die Zahl 1",
            ),
            ("text = true", "expected a text in quotes, got `true`", "Text in Anführungszeichen; dort steht `true`"),
            ("word = 1", "expected a text in quotes", "erwartet: ein Text in Anführungszeichen"),
            ("list = 1", "expected a list in [ ], got the number 1", "erwartet: eine Liste in [ ]; dort steht"),
            ("rows = [1]", "expected a table, got a list", "erwartet: eine Tabelle; dort steht eine Liste"),
            ("inner = { needed = [] }", "got a list", "dort steht eine Liste"),
            ("inner = { }", "missing field `needed`", "es fehlt `needed`"),
            ("inner = { other = 1 }", "unknown field `other`, expected `needed`", "unbekannter Schlüssel `other`"),
            (
                "word = \"six\"",
                "unknown word `six`, expected `one` or `two`",
                "unbekanntes Wort `six`; erwartet: `one`, `two`",
            ),
            ("either = \"x\"", "a value of another kind", "ein Wert anderer Art"),
        ] {
            let said = of(text);
            assert_eq!((said.en.contains(en), said.de.contains(de)), (true, true), "{text}: {said:?}");
        }
    }

    /// What is no TOML is told in German wherever the reader stumbles.
    #[test]
    fn what_the_reader_says_is_known() {
        let spoilt = [
            "x",
            "x =",
            "= 1",
            "x = = 1",
            "x == 1",
            "x = 1 2",
            "x = 01",
            "x = 0X1",
            "x = 0x",
            "x = 0xG",
            "x = 0b2",
            "x = 0o8",
            "x = +0x1",
            "x = 0x0x1",
            "x = ++1",
            "x = 1__0",
            "x = _1",
            "x = 1_",
            "x = 1.",
            "x = .5",
            "x = 1e",
            "x = 1.5e+",
            "x = abc",
            "x = tru",
            "x = True",
            "x = 2026-13-01",
            "x = 2026-01-01T",
            "x = 99999999999999999999",
            "x = 1e999999",
            "x = [1",
            "x = [1 2]",
            "x = [,]",
            "x = [1,,2]",
            "x = [=]",
            "x = [1 = 2]",
            "x = {a = 1",
            "x = {a}",
            "x = {a =}",
            "x = {a = 1 b = 2}",
            "x = {,}",
            "x = {a = 1,, b = 2}",
            "x = {= 1}",
            "x = {a = = 1}",
            "x = {a 1}",
            "x = ]",
            "x = }",
            "x = \"a",
            "x = 'a",
            "x = \"\"\"a",
            "x = '''a",
            "x = \"\\q\"",
            "x = \"\\u12\"",
            "x = \"\\uD800\"",
            "x = \"\u{1}\"",
            "x = '\u{1}'",
            "# \u{1}",
            "x = 1\ry = 2",
            "[x",
            "[[x",
            "[[x]",
            "[x]]",
            "[]",
            "[[]]",
            "[x.]",
            "[.x]",
            "[x] y",
            "[x]\n[x]",
            "x = 1\nx = 2",
            "x = 1\nx.y = 2",
            "x = [1]\nx.y = 2",
            "x = {}\nx.y = 1",
            "x = 1\n[x]",
            "x = 1\n[[x]]",
            "x.y",
            "x. = 1",
            "\"\"\"x\"\"\" = 1",
            "'''x''' = 1",
            "ä = 1",
            "a b = 1",
            "x = a b",
            "x = nonsense # y",
            "\"x",
            "x = \"a\" b",
            "{x = 1}",
            ",",
            "x = ,",
            "x = 1,",
            "x = -",
            "x = +",
            "x = \\",
        ];
        let errors = spoilt.iter().filter_map(|text| toml::from_str::<toml::Value>(text).err());
        let said = errors.map(|error| stumbled(&error).1);
        let unknown: Vec<Text> =
            said.filter(|said| said.de == Text::quoted(&said.en).de || said.de == said.en).collect();
        assert_eq!(unknown, [], "not in the table");
        let deep = format!("x = {}", "[".repeat(300));
        assert!(of(&deep).de.contains("verschachtelt"), "{:?}", of(&deep));
    }

    #[test]
    fn both_languages_go_through_a_reader_of_one() {
        #[derive(Debug)]
        struct Refused;
        impl<'de> Deserialize<'de> for Refused {
            fn deserialize<D: serde::Deserializer<'de>>(_: D) -> Result<Self, D::Error> {
                Err(in_both(&both!("no", "nein")))
            }
        }
        let error = toml::from_str::<BTreeMap<String, Refused>>("x = 1").unwrap_err();
        assert_eq!(stumbled(&error), (4, both!("no", "nein")));
        assert_eq!(said("words of tomorrow").both(), ["words of tomorrow", "\"words of tomorrow\""]);
    }
}
