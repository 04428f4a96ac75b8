//! Lists of parameter numbers as people write them: `210-213, 217`.

use crate::profile::link::INPUTS;
use std::collections::BTreeSet;

/// Writes numbers as ranges: `210-213, 217`.
pub fn ranges(numbers: impl IntoIterator<Item = u32>) -> String {
    let mut runs: Vec<(u32, u32)> = Vec::new();
    for number in numbers.into_iter().collect::<BTreeSet<_>>() {
        match runs.last_mut() {
            Some((_, last)) if last.checked_add(1) == Some(number) => *last = number,
            _ => runs.push((number, number)),
        }
    }
    let shown =
        runs.iter().map(|(first, last)| if first == last { first.to_string() } else { format!("{first}-{last}") });
    shown.collect::<Vec<_>>().join(", ")
}

/// Highest number of any family.
const LAST: u32 = u16::MAX as u32;

/// Reads what [`ranges`] writes; `None` if it is something else.
pub fn numbers(ranges: &str) -> Option<BTreeSet<u32>> {
    let (mut all, mut count) = (BTreeSet::new(), 0);
    for range in ranges.split(',').map(str::trim).filter(|range| !range.is_empty()) {
        let (first, last) = range.split_once('-').unwrap_or((range, range));
        let (first, last): (u32, u32) = (first.trim().parse().ok()?, last.trim().parse().ok()?);
        let is_number = |number: &u32| *number <= LAST || INPUTS.contains(number);
        if first > last || ![first, last].iter().all(is_number) || last - first > LAST {
            return None;
        }
        count += last - first + 1;
        if count > LAST + 1 {
            // More than there are: the same ones over and over.
            return None;
        }
        all.extend(first..=last);
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_read_as_they_are_written() {
        for (list, text) in [
            (vec![], ""),
            (vec![7], "7"),
            (vec![213, 210, 211, 212, 217], "210-213, 217"),
            (vec![1, 2, 4, 300_001], "1-2, 4, 300001"),
        ] {
            assert_eq!(ranges(list.clone()), text);
            assert_eq!(numbers(text), Some(list.into_iter().collect()));
        }
        for text in ["a", "9-3", "1-99999999", "1--2", "65536", "1-300001"] {
            assert_eq!(numbers(text), None, "{text}");
        }
        assert_eq!(numbers("0-65535").map(|all| all.len()), Some(65_536));
        assert_eq!(numbers("1, 1, 1-2").map(|all| all.len()), Some(2));
        // As long as a file may be, and done at once.
        assert_eq!(numbers(&"0-65535,".repeat(2_000_000)), None);
    }
}
