//! What stands in angle brackets for what is to be typed, in the language of the text around it.

use crate::text::{Lang, Text};

/// Words of placeholders that are others in German.
const GERMAN: [(&str, &str); 24] = [
    ("ADDRESS", "ADRESSE"),
    ("CHAR", "ZEICHEN"),
    ("COLUMN", "SPALTE"),
    ("COMMAND", "BEFEHL"),
    ("DIRECTORY", "ORDNER"),
    ("DRIVE", "ANTRIEB"),
    ("FAMILY", "FAMILIE"),
    ("FIELD", "FELD"),
    ("FILE", "DATEI"),
    ("FROM", "VON"),
    ("HEAD", "ÜBERSCHRIFT"),
    ("LANG", "SPRACHE"),
    ("LIST", "LISTE"),
    ("MODE", "BETRIEBSART"),
    ("PARITY", "PARITÄT"),
    ("PERCENT", "PROZENT"),
    ("PROTOCOL", "PROTOKOLL"),
    ("SETPOINT", "SOLLWERT"),
    ("SOURCE", "QUELLE"),
    ("STATE", "ZUSTAND"),
    ("TIME", "ZEIT"),
    ("TO", "BIS"),
    ("VALUE", "WERT"),
    ("WORD", "WORT"),
];

/// A text with its placeholders in its own language.
pub(super) fn placed(text: &Text) -> Text {
    Text::by(|lang| match lang {
        Lang::En => text.get(lang).to_owned(),
        Lang::De => german(text.get(lang)),
    })
}

fn german(text: &str) -> String {
    let mut parts = text.split('<');
    let before = parts.next().unwrap_or_default().to_owned();
    parts.fold(before, |told, part| match part.split_once('>') {
        Some((words, rest)) => told + "<" + &each_word(words) + ">" + rest,
        None => told + "<" + part,
    })
}

fn each_word(words: &str) -> String {
    let of =
        |word: &str| GERMAN.iter().find(|row| row.0 == word).map_or_else(|| word.to_owned(), |row| row.1.to_owned());
    let is_end = |letter: char| !letter.is_ascii_uppercase();
    words
        .split_inclusive(is_end)
        .map(|part| {
            let word = part.trim_end_matches(is_end);
            of(word) + part.get(word.len()..).unwrap_or_default()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn placeholders_are_told_in_the_language_of_the_text() {
        let told = placed(&Text::name("a < b: <PARAMETER=VALUE>... <FROM:TO:TIME> VALUE"));
        assert_eq!(
            told.get(Lang::De),
            "a < b: <PARAMETER=VALUE>... <FROM:TO:TIME> VALUE"
                .replace("=VALUE", "=WERT")
                .replace("FROM:TO:TIME", "VON:BIS:ZEIT")
        );
        assert_eq!(told.get(Lang::En), "a < b: <PARAMETER=VALUE>... <FROM:TO:TIME> VALUE");
    }
}
