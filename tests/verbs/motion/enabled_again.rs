//! Somebody else enables a drive in the last moments of what took its power: it is stopped once more, and told as it is then.

use super::events::left;
use super::rig::{RUNNING, drive, sent};
use crate::run::antrieb;

const OFF: &str = "01 06 01 9A 00 00";
const AGAIN: &str = "it was enabled again behind its stop, by somebody else: the stop went out again";

/// Enabled at any of the last telegrams; behind the last of them nobody looks any more. How often that was told.
fn enabled_at_the_end(delay: &str) -> usize {
    let quiet = format!("{RUNNING}, \"217\" = 0, \"218\" = 0");
    let bench = |event: &str| drive(&quiet, event).replace("\"1ms\"", delay);
    let line = "-v -b 115200 -a 1 --drive acu statemachine disable-voltage";
    let calm = antrieb(line).on(&bench("")).exits(0).sent();
    let proof = calm.iter().rposition(|hex| hex.starts_with(OFF)).unwrap() + 2;
    let mut told = 0;
    for after in proof..calm.len() {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"410\" = 15 }}");
        let run = antrieb(line).on(&bench(&event)).json();
        let seen = format!("{delay} {after} of {}: {:#} {}", calm.len(), run.value, run.err);
        let words = sent(&run.err).iter().skip(after).filter(|(_, hex)| hex.starts_with(OFF)).count();
        let is_told = run.data("/notes").to_string().contains(AGAIN);
        assert_eq!(is_told, words > 0, "what is told went out: {seen}");
        assert_eq!((left().1, run.data("/running").as_bool()), (0, Some(false)), "{seen}");
        told += usize::from(is_told);
    }
    told
}

#[test]
fn a_drive_that_is_enabled_again_while_its_shaft_is_looked_at_is_stopped_once_more() {
    let told = enabled_at_the_end("\"40ms\"");
    assert!(told > 3, "{told}");
}

/// Where all answers come at once the word before is a moment ago, in which no stop is said again: that moment is waited for.
#[test]
fn a_drive_that_answers_at_once_and_is_enabled_again_is_stopped_once_more() {
    let told = enabled_at_the_end("\"1ms\"");
    assert!(told > 3, "{told}");
}
