//! Where a row of a catalogue was taken from, in both languages: sources are written in English, as short as `CM-485 manual 5.2.1; facts S17 p72`.

use crate::text::{Text, both};

/// What is said in more than one word.
const PHRASES: [(&str, &str); 4] = [
    ("one public list; only the range up to", "eine öffentliche Liste; bestätigt ist nur der Bereich bis"),
    (" is confirmed", ""),
    ("one public list, not confirmed by a second", "eine öffentliche Liste, von keiner zweiten bestätigt"),
    ("public lists of SJ200 trip codes", "öffentliche Listen der Störungen des SJ200"),
];

/// Words of a source, each with its German.
const WORDS: [(&str, &str); 3] = [("manual", "Anleitung"), ("facts", "Fakten"), ("example", "Beispiel")];

/// A source as it is cited.
pub fn cited(source: &str) -> Text {
    let told = PHRASES.iter().fold(source.to_owned(), |told, (en, de)| told.replace(en, de));
    let german: Vec<String> = told.split(' ').map(word).collect();
    Text { en: source.to_owned().into(), de: german.join(" ").into() }
}

/// The file that a row stands in, as it is shown beside its source.
pub fn origin(origin: &str) -> Text {
    let file = origin.strip_prefix("built-in ");
    file.map_or_else(|| Text::name(origin), |file| both!("built-in {file}", "eingebaut: {file}"))
}

fn word(word: &str) -> String {
    let bare = word.trim_end_matches([',', ';', '.', ')']);
    let rest = word.strip_prefix(bare).unwrap_or_default();
    let page = bare.strip_prefix('p').filter(|page| !page.is_empty() && page.bytes().all(|byte| byte.is_ascii_digit()));
    let known = WORDS.iter().find(|(en, _)| *en == bare).map(|(_, de)| (*de).to_owned());
    match page.map(|page| format!("S. {page}")).or(known) {
        Some(german) => german + rest,
        None => word.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;
    use crate::text::Lang;

    #[test]
    fn a_source_is_cited_in_both_languages() {
        for (source, german) in [
            ("CM-485 manual 1.5, 3.1", "CM-485 Anleitung 1.5, 3.1"),
            ("facts S12 p194; EM-RES-03 manual 6.4", "Fakten S12 S. 194; EM-RES-03 Anleitung 6.4"),
            (
                "one public list; only the range up to E60 is confirmed",
                "eine öffentliche Liste; bestätigt ist nur der Bereich bis E60",
            ),
            ("a colleague's list", "a colleague's list"),
        ] {
            let told = cited(source);
            assert_eq!((told.get(Lang::En), told.get(Lang::De)), (source, german));
        }
    }

    #[test]
    fn no_english_is_left_in_a_source_of_ours() {
        let registry = Registry::open(&[]).unwrap();
        for drive in registry.drives() {
            let family = registry.family(&drive.id).unwrap();
            for param in family.params.values() {
                let told = cited(&param.source);
                let english = ["manual", "facts", "example", "list ", "confirmed", "public", " of "];
                let left = english.iter().find(|word| told.get(Lang::De).contains(*word));
                assert_eq!(left, None, "{}: {}", param.id, param.source);
            }
        }
    }
}
