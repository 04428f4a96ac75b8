//! `diag` over PROFIBUS: Slave_Diag, the trip, what a lost master means, and the LEDs, in both modes; nothing is written.

use super::rig::{RESTS, event, module};
use super::{is_let_go, later};
use crate::run::{Document, antrieb};
use serde_json::Value;

const DIAG: &str = "-a 3 --protocol dp --drive l200 --yes diag";

fn led(run: &Document, at: usize) -> String {
    run.data(&format!("/drives/0/slave/leds/{at}/value")).as_str().unwrap().to_owned()
}

#[test]
fn a_slave_at_rest_is_told_with_what_a_lost_master_means() {
    for readings in ["", "pkw_waits = \"empty\"", "error_word = \"high\"", "unconfigured = \"basic\""] {
        let mode = if readings.contains("unconfigured") { "--mode profidrive" } else { "" };
        let run = antrieb(&format!("{DIAG} {mode}")).on(&module(RESTS, readings, "")).json().exits(0);
        assert_eq!((run.data("/drives/0/healthy"), run.data("/drives/0/fault_code")), (&true.into(), &0.into()));
        assert_eq!(run.data("/drives/0/status/state/slug"), "ready-to-switch-on");
        assert_eq!(run.data("/drives/0/missing").as_array().unwrap().len(), 1, "P.928 is 0");
        let values = run.data("/drives/0/slave/values").as_array().unwrap();
        let of = |id: u32| values.iter().find(|value| value["param"] == id).map(|value| value["raw"].clone());
        assert_eq!(
            (of(703), of(928), of(89), of(300)),
            (Some(0.into()), Some(0.into()), Some(1.into()), Some(0.into()))
        );
        assert!((led(&run, 1).starts_with("off"), led(&run, 2).starts_with("green")) == (true, true));
        assert!(led(&run, 3).starts_with("off") && led(&run, 4).starts_with("green"));
        assert!(!run.data("/drives/0/slave/diagnosis").as_array().unwrap().is_empty());
        assert_eq!(run.warnings(), ["profibus.let_go"]);
        assert!(is_let_go(&later()), "{readings}");
    }
}

#[test]
fn a_trip_is_a_fault_and_check_says_so() {
    let tripped = module(RESTS, "", &event("100ms", "trip = true"));
    for (mode, key) in [("", "ZSW"), ("--mode basic", "25h")] {
        let run = antrieb(&format!("{DIAG} {mode}")).on(&tripped).json().exits(0);
        assert_eq!(run.data("/drives/0/fault/key"), key);
        assert_eq!((run.data("/drives/0/healthy"), run.data("/drives/0/fault_code")), (&false.into(), &Value::Null));
        assert!(led(&run, 1).starts_with("red") && led(&run, 2).starts_with("blinks"));
        let flags = run.data("/drives/0/slave/diagnosis").to_string();
        assert!(flags.contains("Ext_Diag"), "{flags}");
        let run = antrieb(&format!("{DIAG} --check {mode}")).on(&tripped).json().exits(1);
        assert_eq!(run.error()["code"], "no.fault_present");
        antrieb(&format!("{DIAG} --check {mode}")).on(&module(RESTS, "", "")).exits(0);
    }
}

#[test]
fn basic_mode_tells_no_parameter_and_what_cannot_be_taken_is_said() {
    let run = antrieb(&format!("{DIAG} --mode basic")).on(&module(RESTS, "", "")).json().exits(0);
    assert!(run.data("/drives/0/slave/values").as_array().unwrap().is_empty());
    assert!(led(&run, 4).contains("if the inverter answers"));
    // Another series: what it says before it is taken stands there all the same.
    let run =
        antrieb(&format!("{} --mode basic", DIAG.replace("l200", "sj200"))).on(&module(RESTS, "", "")).json().exits(6);
    assert_eq!(run.error()["code"], "refused.cfg_fault");
    assert!(!run.data("/drives/0/slave/diagnosis").as_array().unwrap().is_empty());
    assert_eq!(run.data("/drives/0/error/code"), "refused.cfg_fault");
    antrieb("-a 3 --protocol dp diag").on(&module(RESTS, "", "")).exits(8);
    antrieb(&format!("{DIAG} --clear")).on(&module(RESTS, "", "")).exits(2);
    antrieb("-a 1 --port sim diag --mode basic").exits(2);
}

#[test]
fn its_page_is_there_in_both_languages() {
    for lang in ["en", "de"] {
        for (mode, trip) in [("", ""), ("--mode basic", ""), ("", "trip = true"), ("--dry-run", "")] {
            let events = if trip.is_empty() { String::new() } else { event("100ms", trip) };
            antrieb(&format!("{DIAG} {mode} --lang {lang}")).on(&module(RESTS, "", &events)).exits(0);
        }
    }
}
