//! Another master who begins while a slave is ours: the end goes out beside him, and every report says so.

use super::rig::{Came, Hand, RESTS, Said, does, event, module};
use crate::run::antrieb;
use antrieb::outcome::Warning;

const RUN: &str = "sollwert 20Hz --enable --hold --duration 3s --take-control --watchdog 2s";
const BASIC: &str = "sollwert 20Hz --enable --hold --duration 3s --mode basic --set F002=2s --set F003=2s";

/// A line with another master from a moment on.
fn with_another(bench: &str, at: &str) -> String {
    format!("{bench}[[master]]\naddress = 2\nat = \"{at}\"\nby = \"60s\"\n")
}

#[track_caller]
fn warned(came: &Came) -> &Warning {
    let warnings = &came.outcome.as_ref().unwrap().warnings;
    warnings.iter().find(|warning| warning.code == "profibus.other_master").unwrap_or_else(|| panic!("{warnings:?}"))
}

/// He begins in the ramp down: nothing is wrong with the run, and the rest of its end went out beside him.
#[test]
fn who_begins_while_the_stop_goes_out_is_named() {
    for (line, stop, lent) in [(RUN, 0x047E, true), (BASIC, 0x0050, false)] {
        let whole = does(line, &module(RESTS, "", ""), Hand::default());
        let moments = whole.moments();
        let fastest = moments.iter().rposition(|moment| moment.shaft > 1_900).unwrap();
        let down = moments[fastest..].iter().find(|moment| matches!(moment.said, Said::Words(word, _) if word == stop));
        let at = format!("{}us", down.unwrap().at.as_micros() + 100_000);
        let came = does(line, &with_another(&module(RESTS, "", ""), &at), Hand::default());
        assert_eq!(came.code(), ("", 0), "{line}: {:?}", came.failure());
        came.holds(line);
        let said = &warned(&came).message.en;
        let all = [format!("{stop:04X}h"), "zero outputs".into(), "Clear".into(), "Unlock".into()];
        assert!(all.iter().all(|part| said.contains(part.as_str())) && said.contains("address 2"), "{said}");
        assert_eq!(said.contains("P.703 = 0") && said.contains("P.928 = 0"), lent, "{said}");
    }
    // What only stops, too.
    let set = RESTS.replace("\"928\" = 0", "\"928\" = 1");
    let driven = module(&set, "", &event("0s", "contact = true"));
    for verb in ["statemachine disable", "sollwert 0Hz"] {
        let came = does(verb, &with_another(&driven, "1800ms"), Hand::default());
        assert_eq!(came.code(), ("", 0), "{verb}: {:?}", came.failure());
        came.holds(verb);
        assert!(warned(&came).message.en.contains("Unlock"), "{verb}: {:?}", warned(&came));
    }
    let alone = does("statemachine disable", &driven, Hand::default());
    assert!(alone.outcome.unwrap().warnings.is_empty());
}

/// A run is ended by him, and by nothing more than its end: which parts of it went out is said.
#[test]
fn a_run_that_another_master_ends_says_what_went_out() {
    let came = does(RUN, &with_another(&module(RESTS, "", ""), "4s"), Hand::default());
    assert_eq!(came.code(), ("forbidden.other_master", 8), "{:?}", came.failure());
    came.holds("another master at speed");
    let message = &came.failure().unwrap().message.en;
    assert!(message.contains("behind that only what ends the exchange was sent"), "{message}");
    let said = &warned(&came).message.en;
    let in_turn = ["047Eh", "P.928 = 0", "P.703 = 0", "zero outputs", "Clear", "Unlock"];
    let places: Vec<_> = in_turn.iter().map(|part| said.find(part)).collect();
    assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{said}");
}

#[test]
fn who_only_reads_says_that_too() {
    for verb in ["read F002 F003 703", "statemachine", "diag", "identify", "write F002=5s"] {
        let bench = with_another(&module(RESTS, "", ""), "1600ms");
        let run = antrieb(&format!("-a 3 --protocol dp --yes {verb}")).on(&bench).json();
        assert_ne!(run.exit, 0, "{verb}: {}", run.value);
        assert!(run.warnings().contains(&"profibus.other_master"), "{verb}: {}", run.value);
        assert!(!run.value.to_string().contains("nothing more was sent\""), "{verb}: {}", run.value);
    }
}
