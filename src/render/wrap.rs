//! Prose in lines that fit a terminal.

use unicode_width::UnicodeWidthStr;

/// What follows a line that was too long is indented by so many blanks more than it.
const HANGING: usize = 2;

/// The text in lines of at most so many columns, broken between words; a longer word, and so a number or a path, stays whole. What
/// is to be copied stays on one line where it fits there: what stands in backticks, and options with what belongs to them.
pub fn wrap(text: &str, columns: Option<u16>) -> String {
    let Some(columns) = columns.map(usize::from).filter(|&columns| text.width() > columns) else {
        return text.to_owned();
    };
    let indent = text.len() - text.trim_start_matches(' ').len();
    let hanging = " ".repeat(indent + HANGING);
    let room = columns.saturating_sub(hanging.len());
    let mut lines = vec![" ".repeat(indent)];
    let is_begun = |line: &str| !line.trim_start_matches(' ').is_empty();
    for unit in units(text.trim_start_matches(' ')) {
        // What fits on no line is broken like anything else.
        let pieces: Vec<&str> = if unit.width() > room { unit.split(' ').collect() } else { vec![unit] };
        for piece in pieces {
            let Some(line) = lines.last_mut() else { break };
            let blank = usize::from(is_begun(line));
            if blank > 0 && line.width() + blank + piece.width() > columns {
                lines.push(hanging.clone() + piece);
            } else {
                line.push_str(&" ".repeat(blank));
                line.push_str(piece);
            }
        }
    }
    lines.join("\n")
}

/// What is not broken, parted by single blanks.
fn units(text: &str) -> Vec<&str> {
    let (mut units, mut start, mut is_quoted, mut is_option) = (Vec::new(), 0, false, false);
    let blanks = text.match_indices(' ').map(|(at, _)| at).chain([text.len()]);
    let mut word = 0;
    for end in blanks {
        let (this, next) = (text.get(word..end).unwrap_or_default(), text.get(end + 1..).unwrap_or_default());
        is_quoted ^= this.matches('`').count() % 2 == 1;
        let is_closed = this.ends_with([',', ';', ':', '.', ')', '`']);
        let was_option = std::mem::replace(&mut is_option, begins_option(this));
        // An option stays with its value, and with the word before it: `scan --resume FILE`.
        let holds = is_quoted || !is_closed && (is_option || begins_option(next) && (was_option || is_short(this)));
        word = end + 1;
        if !holds || end == text.len() {
            units.push(text.get(start..end).unwrap_or_default());
            start = end + 1;
        }
    }
    units
}

fn begins_option(text: &str) -> bool {
    text.trim_start_matches(['(', '`'])
        .strip_prefix('-')
        .is_some_and(|rest| rest.starts_with(|c: char| c == '-' || c.is_ascii_alphabetic()))
}

/// The name of a verb, or of the program.
fn is_short(word: &str) -> bool {
    !word.is_empty() && word.chars().all(|letter| letter.is_ascii_lowercase())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_numbers_stay_whole_and_no_line_is_too_long() {
        let text = "note: the drive stops 1-30 ms after --watchdog 2s, by P.413; see https://example.org/a/very/long/path/that/fits/nowhere";
        for columns in 20..140 {
            let wrapped = wrap(text, Some(columns));
            let words: Vec<&str> = wrapped.split_whitespace().collect();
            assert_eq!(words, text.split_whitespace().collect::<Vec<_>>(), "{columns}");
            let long = wrapped.lines().filter(|line| line.width() > usize::from(columns));
            assert!(long.clone().all(|line| line.contains("https")), "{columns}: {long:?}");
            assert!(columns < 40 || wrapped.lines().any(|line| line.contains("--watchdog 2s")), "{wrapped}");
        }
        assert_eq!(wrap(text, None), text, "in a pipe nothing is wrapped");
    }

    #[test]
    fn a_command_stays_on_one_line() {
        let hint = "hint: if the setting of the line is not known: --baud auto --parity auto --protocol auto; `antrieb sniff -p X` shows it, \
                    and a saved result goes on with scan --resume RESULT.json";
        for columns in 60..100 {
            let wrapped = wrap(hint, Some(columns));
            for whole in
                ["--baud auto --parity auto --protocol auto;", "`antrieb sniff -p X`", "scan --resume RESULT.json"]
            {
                assert!(wrapped.lines().any(|line| line.contains(whole)), "{columns}: {wrapped}");
            }
        }
    }

    #[test]
    fn what_follows_is_indented_and_blanks_within_stay() {
        assert_eq!(wrap("  one two three", Some(10)), "  one two\n    three");
        assert_eq!(wrap("a  b", Some(80)), "a  b");
        assert_eq!(wrap("aa  bb cc", Some(7)), "aa  bb\n  cc");
    }
}
