//! The first round of a stop of several drives: what one shows while others have their turn, and how long those that are silent take.

use super::rig::{RUNNING, ran, sent};
use crate::run::Document;
use antrieb::tick::Span;

const DEAD: &str = "[[drive.event]]\nat = \"0s\"\nsilent = \"10min\"";

/// A drive that runs at 10 Hz.
fn drive(address: u8, set: &str, rest: &str) -> String {
    format!("[[drive]]\nmodel = \"acu\"\naddress = {address}\nbaud = 19200\nset = {{ {RUNNING}{set} }}\n{rest}\n")
}

/// A verb on drives that have run for 3 s.
fn running(line: &str, bench: &str) -> Document {
    ran(Span::from_secs(3), &format!("-v -b 19200 {line}"), bench).json()
}

/// What was sent, and when, in ms since the first.
fn since_the_first(run: &Document) -> Vec<(f64, String)> {
    let all = sent(&run.err);
    let first = all[0].0;
    all.into_iter().map(|(at, hex)| (at - first, hex)).collect()
}

/// It stands, and loses its power a moment later: that is proven where it was seen under power while others kept everybody waiting, and
/// where it was not seen so it is not.
#[test]
fn a_standstill_that_shows_only_while_others_are_told_is_proven_if_it_was_seen() {
    let dead: String = (2..6).map(|address| drive(address, "", DEAD)).collect();
    for (named, verb) in
        [("", "quick-stop"), ("", "disable"), ("--drive acu", "quick-stop"), ("--drive acu", "disable")]
    {
        for (hold, seen) in [("0.2", None), ("0.4", None), ("0.7", Some(true))] {
            let quick =
                format!(", \"424\" = 40, \"425\" = 40, \"637\" = 10, \"638\" = \"{hold}\", \"217\" = 0, \"218\" = 0");
            let ramps = "ramps = { up_right = 50, down_right = 40, up_left = 50, down_left = 40 }";
            let run = running(&format!("{named} -a 1-5 statemachine {verb}"), &(drive(1, &quick, ramps) + &dead));
            let told = format!("{named} {verb} {hold}: {:#} {}", run.value, run.err);
            assert_eq!(run.data("/drives/0/motion/standing").as_bool(), seen, "{told}");
            assert_eq!(run.data("/drives/0/error").is_null(), seen.is_some(), "{told}");
        }
    }
}

/// Nobody named it, and it refuses every word: it is asked who it is before anything is told of it, such as what stops it now.
#[test]
fn a_drive_that_refuses_its_word_is_told_as_what_it_is() {
    let foreign = "[[drive]]\nmodel = \"foreign\"\naddress = 1\nbaud = 19200\n";
    let refuses = drive(1, "", "[[drive.event]]\nat = \"0s\"\nrefuses = 410");
    for (bench, code, stops) in [
        (foreign, "data.unknown_drive", "its enable input"),
        (&refuses, "refused.slave_device_failure", "STOA and STOB"),
    ] {
        for verb in ["quick-stop", "disable", "disable-voltage"] {
            let run = running(&format!("-a 1,2 statemachine {verb}"), &(bench.to_owned() + &drive(2, "", "")));
            let error = run.data("/drives/0/error");
            assert_eq!(error["code"], code, "{verb}: {error}");
            let notes: Vec<&str> = run.err.lines().filter(|line| line.contains("what stops it now: ")).collect();
            assert!(notes.iter().all(|note| note.contains(stops)) && !notes.is_empty(), "{verb}: {notes:#?}");
        }
    }
}

/// Two that may be of any family and never answer: what goes on to one keeps the other waiting for some seconds only.
#[test]
fn drives_that_never_answer_are_told_for_eight_seconds() {
    let dead: String = (1..3).map(|address| drive(address, "", DEAD)).collect();
    let all = since_the_first(&running("-a 1,2 statemachine quick-stop", &dead));
    for address in 1..3 {
        let is_word = |hex: &str| ["06", "10"].iter().any(|code| hex.starts_with(&format!("0{address} {code}")));
        let words: Vec<f64> = all.iter().filter(|(_, hex)| is_word(hex)).map(|(at, _)| *at).collect();
        let lasts = words.last().unwrap() - words[0];
        // And one turn of each behind that.
        assert!(words.len() > 6 && (8_000.0 - 1_020.0..8_000.0 + 1_020.0).contains(&lasts), "{address}: {words:?}");
    }
}

/// Its second round is waited for as long as an answer may take, whatever its family is.
#[test]
fn one_that_may_be_of_any_family_is_waited_for_in_its_second_round() {
    let all = since_the_first(&running("-a 1 statemachine quick-stop", &drive(1, "", DEAD)));
    let words = all.iter().filter(|(_, hex)| hex.starts_with("01 06") || hex.starts_with("01 10"));
    let at: Vec<f64> = words.map(|(at, _)| *at).collect();
    let waits: Vec<bool> = at.windows(2).map(|pair| pair[1] - pair[0] >= 500.0).collect();
    // Three words, of which the first waits for who it is.
    let second = |nth: usize| (3..6).contains(&nth);
    assert_eq!(waits, (0..14).map(second).collect::<Vec<_>>(), "{at:?}");
}

/// Nobody waits for the others of its kind, so that it is asked first which of them it is: what stops it now is told from then on.
#[test]
fn what_stops_a_drive_that_ignores_its_word_is_told_of_that_one() {
    let ignores = drive(1, "", "[[drive.event]]\nat = \"0s\"\nignores = 410");
    for (verb, notes) in [("quick-stop", 1), ("disable", 2), ("disable-voltage", 1)] {
        let run = running(&format!("-a 1 statemachine {verb}"), &ignores);
        let told: Vec<&str> = run.err.lines().filter(|line| line.contains("what stops it now: ")).collect();
        assert!(told.iter().all(|told| told.contains("STOA and STOB")) && told.len() == notes + 1, "{verb}: {told:#?}");
    }
}
