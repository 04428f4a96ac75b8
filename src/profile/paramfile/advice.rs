//! What to do about a line of a file that is no TOML: slips that are made by hand, in words that help.

use crate::text::{Text, both};

/// What helps where the reader of TOML stumbled, at this byte; `None` where the format says all there is.
pub(super) fn advice(text: &str, at: usize, error: &str) -> Option<Text> {
    if let Some(of_format) = of_format(error) {
        return of_format;
    }
    if text.replace("\r\n", "").contains('\r') {
        return Some(both!(
            "its lines end with a carriage return alone: save it with line feeds (LF or CR LF)",
            "die Zeilen enden nur mit einem Wagenrücklauf: mit Zeilenvorschub speichern (LF oder CR LF)"
        ));
    }
    let start = text.get(..at)?.rfind('\n').map_or(0, |end| end + 1);
    let (before, line) = (text.get(..start)?, text.get(start..)?.lines().next()?);
    let (key, value) = line.split('#').next()?.split_once('=')?;
    let (key, value) = (key.trim(), value.trim());
    if error.starts_with("duplicate key") {
        let same = |line: &&str| line.split_once('=').is_some_and(|(other, _)| other.trim() == key);
        let first = before.lines().count() - before.lines().rev().position(|line| same(&line))?;
        return Some(both!(
            "line {first} has a value for it: keep one of the two",
            "in Zeile {first} steht ein Wert dafür: einen von beiden behalten"
        ));
    }
    if value.is_empty() {
        return Some(no_value());
    }
    const TYPOGRAPHIC: [char; 7] = ['“', '”', '„', '«', '»', '‘', '’'];
    let plain = value.trim_matches(TYPOGRAPHIC);
    if plain != value {
        return Some(both!(
            "quotes of a word processor are none here: {key} = \"{plain}\"",
            "Anführungszeichen einer Textverarbeitung gelten nicht: {key} = \"{plain}\""
        ));
    }
    let is_bare = |letter: char| letter.is_ascii_alphanumeric() || "-_.\"'".contains(letter);
    if !key.is_empty() && !key.chars().all(is_bare) {
        let value =
            if value.parse::<f64>().is_ok() || is_quoted(value) { value.to_owned() } else { format!("\"{value}\"") };
        return Some(both!(
            "a name with a blank, an @ or an umlaut stands in quotes: \"{key}\" = {value}",
            "ein Name mit Leerzeichen, @ oder Umlaut steht in Anführungszeichen: \"{key}\" = {value}"
        ));
    }
    (!is_quoted(value) && !key.is_empty()).then(|| {
        both!(
            "a value with a comma or a unit stands in quotes: {key} = \"{value}\"",
            "ein Wert mit Komma oder Einheit steht in Anführungszeichen: {key} = \"{value}\""
        )
    })
}

fn is_quoted(value: &str) -> bool {
    value.starts_with(['"', '\'', '[', '{'])
}

/// What helps where the TOML is right and does not fit the format; `None` where it is the TOML.
fn of_format(error: &str) -> Option<Option<Text>> {
    const OTHERS: [&str; 4] = ["unknown variant ", "invalid type: ", "invalid value: ", "data did not match "];
    if error.starts_with("missing field ") {
        return Some(Some(both!(
            "the least that a file holds: `antrieb = 1`, below `[drive]` its `family = \"acu\"`, and below `[values]` a line a value",
            "das Mindeste einer Datei: `antrieb = 1`, unter `[drive]` die `family = \"acu\"` und unter `[values]` eine Zeile je Wert"
        )));
    }
    if error.starts_with("unknown field ") {
        return Some(Some(both!(
            "values of parameters stand below `[values]`; what else a file may say: docs/parameter-files.md",
            "Werte von Parametern stehen unter `[values]`; was eine Datei sonst sagen kann: docs/parameter-files.md"
        )));
    }
    OTHERS.iter().any(|start| error.starts_with(start)).then_some(None)
}

/// What helps where a line has no value.
pub(super) fn no_value() -> Text {
    both!(
        "write the value behind `=`, or take the line out: a parameter without a line is left as it is",
        "den Wert hinter `=` schreiben oder die Zeile löschen: ein Parameter ohne Zeile bleibt, wie er ist"
    )
}
