//! A drive that refuses its control word, and nothing else, while its shaft turns.

use super::rig::{READY, RUNNING, drive};
use crate::run::antrieb;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::json;

/// P.410, and DCOMcontrol of the servo.
const AT_19_HZ: &str = "[[drive.event]]\nwhen = \"above 19Hz\"\nrefuses = 410";

/// Its setpoint is obeyed still: it goes to 0 once nothing else is left, in time, and the end names the refusal.
#[test]
fn a_drive_that_refuses_its_control_word_gets_its_setpoint_0() {
    let servo = "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 3000, RAMPdecel = 3000 }\n\
                 [[drive.event]]\nwhen = \"above 4Hz\"\nrefuses = 6914";
    let ramps = "ramps = { up_right = 50, down_right = 20, up_left = 50, down_left = 20 }";
    let acu = drive(READY, &format!("{ramps}\n{AT_19_HZ}"));
    for (bench, who, value) in [
        (acu.as_str(), "-b 115200", "20Hz"),
        (&acu.replace("acu", "act"), "-b 115200", "20Hz"),
        (servo, "--drive lxm05", "300rpm"),
    ] {
        for way in ["ramp", "quick-stop", "coast"] {
            let line = format!("{who} -a 1 --yes sollwert {value} --enable --hold --duration 2s --on-exit {way}");
            let run = antrieb(&line).on(bench).json();
            let (bench, at) = witness::left().unwrap();
            let told = format!("{line}: {at:?} {:#}\n{}", run.value, run.err);
            assert_eq!((bench.totals().turning, bench.totals().energised), (0, 1), "{told}");
            assert!(at < Tick::ZERO + Span::from_secs(20), "{told}");
            assert_eq!(run.error()["code"], "forbidden.not_stopped", "{told}");
            assert!(run.err.contains("error: THE SHAFT MAY STILL TURN"), "{told}");
            assert_eq!((run.data("/stop/acknowledged"), run.data("/running")), (&json!(false), &json!(true)), "{told}");
            assert_eq!((run.data("/stop/standing"), run.data("/standing")), (&json!(true), &json!(true)), "{told}");
            let notes = run.data("/notes").to_string();
            assert!(way == "coast" || notes.contains("is not obeyed: coast in its place"), "{told}");
            assert!(
                ["exception 4", "the setpoint went to 0 in its place"].iter().all(|note| notes.contains(note)),
                "{told}"
            );
        }
    }
}

/// Nothing was given, so that there is nothing to take back: what the setpoint is stays somebody else's.
#[test]
fn a_drive_that_was_only_enabled_keeps_the_setpoint_of_others() {
    let bench = drive(RUNNING, "[[drive.event]]\nat = \"1500ms\"\nrefuses = 410");
    let run = antrieb("-v -b 115200 -a 1 --yes statemachine enable --hold --duration 2s").on(&bench).run();
    let (mut bench, at) = witness::left().unwrap();
    bench.advance(at + Span::from_secs(5));
    assert_eq!((run.exit, bench.totals().turning), (8, 1), "{}", run.err);
    assert!(!run.err.contains("> 01 65 01 E4"), "{}", run.err);
    assert!(run.err.contains("error: THE SHAFT MAY STILL TURN"), "{}", run.err);
}
