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

/// Whether `query` (as typed) stands in `name` as a word of its own, or several.
pub(super) fn has_word(name: &str, query: &str) -> bool {
    let words = |text: &str| format!(" {text} ");
    let query = words(&fold(query));
    [fold(name), fold_plain(name)].iter().any(|name| words(name).contains(&query))
}

/// How many slips of the keyboard make `query` (as typed) of `name`, if they are few: one in four letters, three at most.
pub(super) fn near(name: &str, query: &str) -> Option<usize> {
    let (name, query) = (fold(name), fold(query));
    let most = (query.chars().count() / 4).min(3);
    Some(slips(&name, &query)).filter(|slips| (1..=most).contains(slips))
}

/// Whether `query` (as typed) is `name`, or a few slips of the keyboard away from it.
pub fn is_nearly(name: &str, query: &str) -> bool {
    same(name, query) || near(name, query).is_some()
}

/// The names that are the fewest slips away from `query` (as typed), if these are few: in a short list one slip is, also in three letters.
pub fn nearest<'n>(names: &[&'n str], query: &str) -> Vec<&'n str> {
    let typed = fold(query);
    let count = typed.chars().count();
    let most = if count < 3 { 0 } else { (count / 4).clamp(1, 3) };
    let slips = names.iter().map(|name| (slips(&fold(name), &typed), *name));
    let near: Vec<_> = slips.filter(|(slips, _)| *slips <= most).collect();
    let least = near.iter().map(|(slips, _)| *slips).min();
    near.into_iter().filter(|(slips, _)| Some(*slips) == least).map(|(_, name)| name).collect()
}

/// How many letters were left out, put in, taken for another, or swapped with the next (Damerau's distance).
fn slips(one: &str, other: &str) -> usize {
    let other: Vec<char> = other.chars().collect();
    let (mut before, mut last): (Vec<usize>, Vec<usize>) = (Vec::new(), (0..=other.len()).collect());
    let mut previous = None;
    for (row, letter) in one.chars().enumerate() {
        let mut line = vec![row + 1];
        for (column, &typed) in other.iter().enumerate() {
            let at = |list: &[usize], index: usize| list.get(index).copied().unwrap_or(usize::MAX - 1);
            let changed = at(&last, column) + usize::from(letter != typed);
            let swapped = column > 0 && previous == Some(typed) && other.get(column - 1) == Some(&letter);
            let swap = if swapped { at(&before, column - 1) + 1 } else { usize::MAX };
            line.push(changed.min(swap).min(at(&last, column + 1) + 1).min(at(&line, column) + 1));
        }
        (before, last, previous) = (last, line, Some(letter));
    }
    last.last().copied().unwrap_or(0)
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
    fn slips_of_the_keyboard_are_counted() {
        for (name, query, slips) in [
            ("rated-speed", "rated-sped", Some(1)),
            ("rated-speed", "rtaed-speed", Some(1)),
            ("rated-speed", "rated-speeed", Some(1)),
            ("rated-speed", "rated-spoon", None),
            ("rated-speed", "rated-speed", None),
            ("Bemessungsdrehzahl", "Bemesungsdrehzal", Some(2)),
            ("abc", "abd", None),
        ] {
            assert_eq!(near(name, query), slips, "{query}");
        }
    }

    #[test]
    fn the_nearest_of_a_short_list_is_found_in_three_letters_too() {
        let names = ["fan", "pump", "servo", "p1"];
        for (query, near) in [
            ("fann", &["fan"][..]),
            ("pmp", &["pump"]),
            ("Pupm", &["pump"]),
            ("p2", &[]),
            ("belt", &[]),
            ("srevo", &["servo"]),
        ] {
            assert_eq!(nearest(&names, query), near, "{query}");
        }
    }

    #[test]
    fn umlauts_and_case_do_not_matter() {
        for query in ["Übergang 5", "uebergang 5", "UBERGANG", "über", "ubergang-5"] {
            assert!(starts("Übergang 5", query), "{query}");
        }
        assert!(!starts("Übergang 5", "gang"));
        assert!(same("max. Regelabweichung", "MAX REGELABWEICHUNG"));
    }
}
