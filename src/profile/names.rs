//! How names are compared, and where a place in a text is.

/// Line and column of a byte of a text, both from 1, the column in characters: what an editor shows.
pub fn place(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or("");
    (before.matches('\n').count() + 1, before.rsplit('\n').next().unwrap_or("").chars().count() + 1)
}

/// Folds a name for comparison: lower case, blanks for punctuation, umlauts spelt out (`ä` as `ae`).
pub fn fold(name: &str) -> String {
    fold_with(name, |umlaut| match umlaut {
        'ä' => "ae",
        'ö' => "oe",
        'ü' => "ue",
        _ => "ss",
    })
}

/// Whether `query` (as typed) is the start of `name`, whatever the case, blanks, and however umlauts are spelt.
pub(super) fn starts(name: &str, query: &str) -> bool {
    compare(name, query, |name, query| name.starts_with(query))
}

/// Whether `query` (as typed) is `name`, whatever the case, blanks, and however umlauts are spelt.
pub(super) fn same(name: &str, query: &str) -> bool {
    compare(name, query, |name, query| name == query)
}

fn compare(name: &str, query: &str, fits: impl Fn(&str, &str) -> bool) -> bool {
    let query = fold(query);
    let dense = |text: &str| text.replace(' ', "");
    [fold(name), fold_plain(name)].iter().any(|name| fits(name, &query) || fits(&dense(name), &dense(&query)))
}

/// Like [`fold`], with umlauts reduced to their base letter (`ä` as `a`).
fn fold_plain(name: &str) -> String {
    fold_with(name, |umlaut| match umlaut {
        'ä' => "a",
        'ö' => "o",
        'ü' => "u",
        _ => "s",
    })
}

fn fold_with(name: &str, spell: impl Fn(char) -> &'static str) -> String {
    let mut folded = String::with_capacity(name.len());
    for letter in name.chars().flat_map(char::to_lowercase) {
        match letter {
            'ä' | 'ö' | 'ü' | 'ß' => folded.push_str(spell(letter)),
            letter if letter.is_alphanumeric() => folded.push(letter),
            _ if folded.ends_with(' ') || folded.is_empty() => {}
            _ => folded.push(' '),
        }
    }
    folded.truncate(folded.trim_end().len());
    folded
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn umlauts_and_case_do_not_matter() {
        for query in ["Übergang 5", "uebergang 5", "UBERGANG", "über", "ubergang-5"] {
            assert!(starts("Übergang 5", query), "{query}");
        }
        assert!(!starts("Übergang 5", "gang"));
        assert!(same("max. Regelabweichung", "MAX REGELABWEICHUNG"));
    }
}
