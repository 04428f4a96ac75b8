//! The columns of a table that has no room for all of it.

use comfy_table::{ColumnConstraint, Width};
use unicode_width::UnicodeWidthStr;

/// Blanks between two columns.
pub(super) const GAP: u16 = 2;
/// A column of words is no narrower than this.
const NARROWEST: u16 = 8;

/// No column becomes so narrow that a word is torn apart, as long as all of them have room for their longest. Where they have not,
/// names are broken behind their hyphens; where that does not do either, the column with the longest words gives way, and never
/// one of numbers (`>` in the head), because a digit less is another value. Returns what holds for each column.
///
/// A column whose head begins with `=` is never broken: what stands there is typed again.
pub(super) fn hold_words_together(
    names: &[&str],
    rows: &mut [Vec<String>],
    head: &[&str],
    width: u16,
) -> Vec<ColumnConstraint> {
    let least = of_words(names, rows, head);
    if sum(&least) <= width {
        return least.into_iter().map(|least| ColumnConstraint::LowerBoundary(Width::Fixed(least))).collect();
    }
    let mut least = widths(names, rows, |index, cell| match is_whole(head, index) {
        true => cell.width(),
        false => longest(pieces(cell).map(|(piece, _)| piece)),
    });
    let is_of_words = |index: usize| head.get(index).is_none_or(|name| !name.starts_with(['>', '=']));
    let over = sum(&least).saturating_sub(width);
    let words = least.iter_mut().enumerate().filter(|(index, _)| is_of_words(*index));
    if let Some((_, longest)) = words.max_by_key(|(_, least)| **least) {
        *longest = longest.saturating_sub(over).max(NARROWEST.min(*longest));
    }
    if sum(&least) > width {
        return Vec::new();
    }
    let whole = widths(names, rows, |_, cell| cell.width());
    let columns = shared_out(least, &whole, width);
    for row in rows {
        for (cell, columns) in row.iter_mut().zip(&columns) {
            *cell = broken(cell, usize::from(columns.saturating_sub(GAP)));
        }
    }
    columns.into_iter().map(|columns| ColumnConstraint::Absolute(Width::Fixed(columns))).collect()
}

/// Whether a line has room for every word of a table.
pub(super) fn has_room(names: &[&str], rows: &[Vec<String>], head: &[&str], width: u16) -> bool {
    sum(&of_words(names, rows, head)) <= width
}

/// What each column needs for its longest word.
fn of_words(names: &[&str], rows: &[Vec<String>], head: &[&str]) -> Vec<u16> {
    widths(names, rows, |index, cell| match is_whole(head, index) {
        true => cell.width(),
        false => longest(cell.split_whitespace()),
    })
}

fn is_whole(head: &[&str], index: usize) -> bool {
    head.get(index).is_some_and(|name| name.starts_with('='))
}

/// What each column needs for its cells, with the gap behind it.
fn widths(names: &[&str], rows: &[Vec<String>], needs: impl Fn(usize, &str) -> usize) -> Vec<u16> {
    let of = |(index, name): (usize, &&str)| {
        let cells = rows.iter().filter_map(|row| Some(needs(index, row.get(index)?)));
        cells.chain([longest(name.split_whitespace())]).max().unwrap_or(0) as u16 + GAP
    };
    names.iter().enumerate().map(of).collect()
}

fn sum(widths: &[u16]) -> u16 {
    widths.iter().sum()
}

fn longest<'w>(words: impl Iterator<Item = &'w str>) -> usize {
    words.map(UnicodeWidthStr::width).max().unwrap_or(0)
}

/// Gives what is left of a line to the columns that could use it, a blank in turn.
fn shared_out(mut columns: Vec<u16>, whole: &[u16], width: u16) -> Vec<u16> {
    let mut left = width.saturating_sub(sum(&columns));
    loop {
        let before = left;
        for (column, _) in columns.iter_mut().zip(whole).filter(|(column, whole)| **column < **whole) {
            let given = left.min(1);
            (*column, left) = (*column + given, left - given);
        }
        if left == 0 || left == before {
            break;
        }
    }
    columns
}

/// The words of a text, parted behind their hyphens too, each with whether a word ends there. The sign of a number is no hyphen.
fn pieces(text: &str) -> impl Iterator<Item = (&str, bool)> {
    text.split_whitespace().flat_map(|word| {
        let is_hyphen = |at: usize| word.get(..at).is_some_and(|before| before.ends_with(char::is_alphabetic));
        let ends = word.match_indices('-').map(|(at, _)| at).filter(|at| is_hyphen(*at)).map(|at| at + 1);
        let mut start = 0;
        let ends: Vec<usize> = ends.filter(|end| *end < word.len()).chain([word.len()]).collect();
        ends.into_iter().map(move |end| {
            let piece = word.get(start..end).unwrap_or_default();
            start = end;
            (piece, end == word.len())
        })
    })
}

/// A text in lines of at most so many columns; what is longer stays for who prints it to break.
fn broken(text: &str, columns: usize) -> String {
    let (mut lines, mut is_apart) = (vec![String::new()], false);
    for (piece, is_end) in pieces(text) {
        let Some(line) = lines.last_mut() else { break };
        let blank = if is_apart { " " } else { "" };
        if !line.is_empty() && line.width() + blank.len() + piece.width() > columns {
            lines.push(piece.to_owned());
        } else {
            line.push_str(blank);
            line.push_str(piece);
        }
        is_apart = is_end;
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_broken_behind_a_hyphen_and_a_number_nowhere() {
        assert_eq!(broken("fixed-frequency-1 x", 10), "fixed-\nfrequency-\n1 x");
        assert_eq!(broken("-999.00 … 999.00", 8), "-999.00\n… 999.00");
        assert_eq!(broken("-999.00 … 999.00", 7), "-999.00\n…\n999.00");
        assert_eq!(broken("1-4", 2), "1-4");
    }
}
