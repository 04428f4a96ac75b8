//! What is told of a drive over which control is taken while somebody else runs it, before and afterwards.

use super::rig::{DISABLE, drive, held};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::tick::Span;
use serde_json::json;

const LINE: &str = "-v -b 115200 -a 1 --drive acu --yes sollwert 15Hz --enable --hold --duration 300ms --take-control";

/// Runs at 20 Hz by its contacts, or by virtual ones.
fn running(mode: u8, word: u8) -> String {
    let set = format!("\"412\" = {mode}, \"410\" = {word}, \"434\" = 2, \"484\" = 20, \"418\" = 0");
    drive(&set, "readings = { other_modes = \"contacts\" }\nramps = { up_right = 500, down_right = 20 }")
}

/// How fast its shaft turns, before it is taken.
#[test]
fn how_fast_a_shaft_turns_is_told_before_control_of_it_is_taken() {
    for (mode, word) in [(0, 0), (2, 3)] {
        let run = antrieb(LINE).on(&running(mode, word)).run();
        let before = run.err.split("> 01 06").next().unwrap();
        assert!(before.contains("its shaft turns now: P.210"), "{mode}: {}", run.err);
    }
}

/// What stood in its control word is a quick stop for the one who commands, which it is in with its power.
#[test]
fn a_drive_that_control_puts_into_a_quick_stop_is_not_said_to_have_lost_its_power() {
    let run = antrieb(LINE).on(&running(2, 3)).json();
    let notes = run.data("/notes").to_string();
    assert!(notes.contains("which stops it: Quick stop active"), "{:#}", run.value);
    assert!(!notes.contains("took its power"), "{:#}", run.value);
}

/// Control stays with us, because it ran before under the one who had it.
#[test]
fn control_that_is_kept_says_that_the_drive_ran_before() {
    let run = antrieb(LINE).on(&running(0, 0)).json().exits(9);
    let notes = run.data("/notes").to_string();
    assert!(notes.contains("the drive ran under P.412 = 0 before"), "{:#}", run.value);
    assert!(!notes.contains("would start the drive"), "{:#}", run.value);
}

/// The answer to the taking of control is lost, with all others for seconds; the drive has obeyed it, and runs by our word: it is ramped down.
#[test]
fn a_drive_that_was_taken_without_an_answer_is_stopped_by_its_control_word() {
    const TAKE: &str = "01 06 61 9C 00 01";
    let taken = |rest: &str| {
        let bench = format!("{}\n{rest}", running(0, 0));
        held(&bench, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.take_control(1, Some(15)).await?;
            motor.walk("operation-enabled").await
        })
    };
    let take = taken("").sent.iter().position(|hex| hex.starts_with(TAKE)).unwrap() + 1;
    for ms in [3_600, 4_000, 4_400] {
        let came = taken(&format!("[[drive.event]]\nafter_telegrams = {take}\nsilent = \"{ms}ms\""));
        let told = format!("{ms}: {:?} {:?}", came.ended, came.sent);
        assert!(came.ended.result.is_err(), "{told}");
        assert!(came.ended.stop.as_ref().is_some_and(|stop| stop.acknowledged), "{told}");
        assert_eq!((came.turning, came.energised), (0, 0), "{told}");
        // The command of a ramp, and no contacts.
        assert!(came.sent[take..].iter().any(|hex| hex.starts_with(DISABLE)), "{told}");
    }
}

/// The same of a run that nobody holds: it has failed, so that it is stopped as well.
#[test]
fn a_drive_that_was_taken_without_an_answer_is_stopped_where_nobody_holds_it_too() {
    let line = "-v -b 115200 -a 1 --drive acu --yes statemachine enable --take-control";
    let calm = antrieb(line).on(&running(0, 0)).run().sent();
    let take = calm.iter().position(|hex| hex.starts_with("01 06 61 9C 00 01")).unwrap() + 1;
    let silent = format!("{}\n[[drive.event]]\nafter_telegrams = {take}\nsilent = \"4s\"", running(0, 0));
    let run = antrieb(line).on(&silent).json();
    assert_eq!(run.data("/stop/acknowledged"), &json!(true), "{:#} {}", run.value, run.err);
    assert_eq!(run.data("/running"), &json!(false), "{:#}", run.value);
}

/// Neither its enable nor its start contact is closed: nothing starts when control goes back.
#[test]
fn control_goes_back_to_contacts_that_are_open() {
    let line =
        "-b 115200 -a 1 --drive acu --yes statemachine goto ready-to-switch-on --take-control --hold --duration 300ms";
    let open = "enable = false\nstart_right = false\nreadings = { other_modes = \"contacts\" }";
    let run = antrieb(line).on(&drive("\"412\" = 0, \"434\" = 2, \"418\" = 0", open)).json();
    assert_eq!(run.data("/changed/0/restored"), &json!(true), "{:#}", run.value);
}

/// On the way up a fault ends the walk at once; out of a fault it is where the walk begins.
#[test]
fn a_fault_on_the_way_up_is_told_as_that() {
    let ready = "\"412\" = 1, \"434\" = 2, \"418\" = 0";
    let line = "-v -b 115200 -a 1 --drive acu --yes statemachine enable";
    let calm = antrieb(line).on(&drive(ready, "")).exits(0).sent();
    let enabled = calm.iter().position(|hex| hex.starts_with("01 06 01 9A 00 0F")).unwrap() + 1;
    let trips = format!("[[drive.event]]\nafter_telegrams = {enabled}\nfault = \"F0500\"");
    let run = antrieb(line).on(&drive(ready, &trips)).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.fault", "{:#}", run.value);
}
