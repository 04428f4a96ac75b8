//! What is otherwise where a drive is reached through another one (`-a 3.17`): it is told by the address that was typed.

use crate::failure::Failure;
use crate::outcome::{Comparison, Data, Outcome};
use crate::text::Text;

/// What stands before the address of a drive.
const WORDS: [&str; 4] = ["drive ", "address ", "Antrieb ", "Adresse "];

/// The node is told wherever the drive is: in refusals, in warnings and in what was found.
pub fn told(outcome: Result<Outcome, Failure>, node: u8) -> Outcome {
    let mut outcome = outcome.unwrap_or_else(Outcome::from);
    outcome.each_error(&mut |error| {
        error.message = behind(&error.message, node);
        error.context.entry("node".to_owned()).or_insert_with(|| node.to_string());
    });
    match &mut outcome.data {
        Some(Data::Identify(found)) => found.drives.iter_mut().for_each(|one| one.node = node),
        Some(Data::Diag(found)) => found.drives.iter_mut().for_each(|one| one.node = node),
        Some(Data::Comparisons(found)) => found.comparisons.iter_mut().for_each(|one| compared(one, node)),
        Some(Data::Report(found)) => {
            for one in &mut found.drives {
                one.node = node;
                one.identity.iter_mut().for_each(|identity| identity.node = node);
                one.diagnosis.iter_mut().for_each(|diagnosis| diagnosis.node = node);
            }
        }
        _ => {}
    }
    for warning in &mut outcome.warnings {
        warning.message = behind(&warning.message, node);
    }
    let failure = outcome.failure.map(|failure| {
        let failure = failure.within(|said| behind(&said, node));
        if failure.context.iter().any(|fact| fact.0 == "node") { failure } else { failure.with("node", node) }
    });
    Outcome { failure, ..outcome }
}

/// The same of a side of a comparison that is a drive.
pub(super) fn compared(one: &mut Comparison, node: u8) {
    for side in [&mut one.a, &mut one.b].into_iter().filter(|side| side.address.is_some() && node > 0) {
        let name = behind(&side.name, node);
        let named = |text: &Text| text.replacing(&side.name, &name);
        one.unified = one.unified.as_ref().map(named);
        (side.name, side.node) = (name, node);
    }
}

/// A text in which the drive is named with its node.
fn behind(text: &Text, node: u8) -> Text {
    Text { en: named(&text.en, node).into(), de: named(&text.de, node).into() }
}

fn named(text: &str, node: u8) -> String {
    let mut told = String::new();
    let mut rest = text;
    let begins = |rest: &str| WORDS.into_iter().filter_map(|word| Some(rest.find(word)? + word.len())).min();
    while let Some((before, after)) = begins(rest).and_then(|at| rest.split_at_checked(at)) {
        let digits = after.len() - after.trim_start_matches(|letter: char| letter.is_ascii_digit()).len();
        let (address, after) = after.split_at_checked(digits).unwrap_or(("", after));
        let has_node =
            after.strip_prefix('.').is_some_and(|more| more.starts_with(|letter: char| letter.is_ascii_digit()));
        told += before;
        told += address;
        if !address.is_empty() && !has_node {
            told += &format!(".{node}");
        }
        rest = after;
    }
    told + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_node_is_told_once_and_only_behind_an_address() {
        for (text, told) in [
            ("drive 3 refused: NAK", "drive 3.17 refused: NAK"),
            ("address 3: no reply; drive 3.", "address 3.17: no reply; drive 3.17."),
            ("drive 3.17 (acu)", "drive 3.17 (acu)"),
            ("the drive is gone, drive", "the drive is gone, drive"),
            ("Antrieb 3: Adresse 12", "Antrieb 3.17: Adresse 12.17"),
        ] {
            assert_eq!(named(text, 17), told);
        }
    }
}
