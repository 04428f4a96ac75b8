//! What stands in brackets for what is to be typed, in the language of the text around it.

use crate::text::{Lang, Text};

/// Words of placeholders that are others in German; several as one go before each of them.
const GERMAN: &[(&str, &str)] = &[
    ("FROM:TO:TIME", "VON:BIS:ZEIT"),
    ("ADDR", "ADRESSE"),
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
    ("KEY", "SCHLÜSSEL"),
    ("LANG", "SPRACHE"),
    ("LIST", "LISTE"),
    ("MODE", "BETRIEBSART"),
    ("MODULE", "BAUGRUPPE"),
    ("NAMES", "NAMEN"),
    ("ORDER", "REIHENFOLGE"),
    ("PARITY", "PARITÄT"),
    ("PATH", "PFAD"),
    ("PERCENT", "PROZENT"),
    ("PROTOCOL", "PROTOKOLL"),
    ("SEARCH", "SUCHWORT"),
    ("SET", "SATZ"),
    ("SETPOINT", "SOLLWERT"),
    ("SETS", "SÄTZE"),
    ("SOURCE", "QUELLE"),
    ("STATE", "ZUSTAND"),
    ("STEP", "SCHRITT"),
    ("TIME", "ZEIT"),
    ("TO", "NACH"),
    ("TYPE", "TYP"),
    ("VALUE", "WERT"),
    ("WHAT", "WAS"),
    ("WHEN", "WANN"),
    ("WHO", "WER"),
    ("WORD", "WORT"),
    ("WORDS", "WÖRTER"),
];

/// A text with its placeholders in its own language.
pub(super) fn placed(text: &Text) -> Text {
    Text::by(|lang| match lang {
        Lang::En => text.get(lang).to_owned(),
        Lang::De => german(text.get(lang)),
    })
}

fn german(text: &str) -> String {
    // What need not be typed stands in square ones.
    [('<', '>'), ('[', ']')].into_iter().fold(text.to_owned(), |told, brackets| within(&told, brackets))
}

fn within(text: &str, (open, close): (char, char)) -> String {
    let mut parts = text.split(open);
    let mut told = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        told.push(open);
        match part.split_once(close) {
            Some((words, rest)) => {
                told.extend([&of(words).map_or_else(|| each_word(words), str::to_owned), &*close.to_string(), rest])
            }
            None => told.push_str(part),
        }
    }
    told
}

fn of(word: &str) -> Option<&'static str> {
    GERMAN.iter().find(|row| row.0 == word).map(|row| row.1)
}

fn each_word(words: &str) -> String {
    let is_end = |letter: char| !letter.is_ascii_uppercase();
    let german = |part: &str| {
        let word = part.trim_end_matches(is_end);
        of(word).unwrap_or(word).to_owned() + part.get(word.len()..).unwrap_or_default()
    };
    words.split_inclusive(is_end).map(german).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn placeholders_are_told_in_the_language_of_the_text() {
        let english = "a < b: <PARAMETER=VALUE>... <FROM:TO:TIME> <FROM> <TO> [SETPOINT] [KEY=VALUE] VALUE [y/N] [";
        let german = "a < b: <PARAMETER=WERT>... <VON:BIS:ZEIT> <VON> <NACH> [SOLLWERT] [SCHLÜSSEL=WERT] VALUE [y/N] [";
        let told = placed(&Text::name(english));
        assert_eq!((told.get(Lang::En), told.get(Lang::De)), (english, german));
    }
}
