//! A drive that refuses its control word, and nothing else, while its shaft turns.

use super::rig::{READY, RUNNING, drive, when};
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
            assert!(run.err.contains("error: THE SHAFT MAY STILL TURN") && !told.contains("as asked for"), "{told}");
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

/// Who has told which product he is refuses his word for a reason of his own: nobody named a family, and no other one's words go out.
#[test]
fn a_servo_that_refuses_its_word_is_not_asked_whether_it_is_one() {
    let bench = "[[drive]]\nmodel = \"lxm05\"\n[[drive.event]]\nat = \"0s\"\nrefuses = 6914\n";
    for verb in ["statemachine disable", "statemachine quick-stop", "sollwert 0rpm"] {
        let run = antrieb(&format!("-v -a 1 {verb}")).on(bench).run();
        assert!(!run.err.contains("--drive right") && !run.err.contains("other families"), "{verb}: {}", run.err);
        assert!(!run.sent().iter().any(|hex| hex.starts_with("01 06 01 9A")), "{verb}: {}", run.err);
        let named = antrieb(&format!("-v -a 1 --drive lxm05 {verb}")).on(bench).run();
        let refuses = verb.starts_with("statemachine");
        assert_eq!(named.err.contains("is --drive right?"), refuses, "{verb}: {}", named.err);
    }
}

#[test]
fn a_stop_for_which_no_port_opens_says_that_the_shaft_may_turn() {
    for verb in ["statemachine quick-stop", "statemachine disable", "statemachine disable-voltage", "sollwert 0"] {
        for addresses in ["1", "1,2"] {
            let run = antrieb(&format!("-p {{dir}}/nothing -a {addresses} {verb}")).json().exits(3);
            let message = run.error()["message"].as_str().unwrap();
            assert!(message.starts_with("THE SHAFT MAY STILL TURN: no stop was sent"), "{message}");
            assert!(run.error()["hint"].as_str().unwrap().starts_with("what stops it now"), "{}", run.error());
        }
    }
    let other = antrieb("-p {dir}/nothing -a 1 --yes sollwert 5Hz --enable --hold").json().exits(3);
    assert!(!other.error()["message"].as_str().unwrap().contains("SHAFT"), "{}", other.error());
}

/// It was never without power, so nobody has enabled it again; and what it is by its terminals is told of nobody who was not asked.
#[test]
fn a_drive_that_ignores_its_stop_was_not_enabled_again_and_is_not_told_by_the_terminal_of_another() {
    let of = |address: u8, how: &str| {
        let event = format!("[[drive.event]]\nat = \"0s\"\n{how} = 410");
        format!("[[drive]]\nmodel = \"acu\"\naddress = {address}\nbaud = 19200\nset = {{ {RUNNING} }}\n{event}\n")
    };
    for (how, verb) in
        [("refuses", "quick-stop"), ("ignores", "disable"), ("refuses", "disable-voltage"), ("ignores", "quick-stop")]
    {
        for who in ["-a 1", "-a 1,2", "-a 1 --drive acu"] {
            let line = format!("-b 19200 {who} statemachine {verb}");
            let run = antrieb(&line).on(&[of(1, how), of(2, how)].concat()).run();
            let told = format!("{line} {how}: {}", run.err);
            assert!(run.err.contains("THE SHAFT MAY STILL TURN"), "{told}");
            assert!(![&run.out, &run.err].iter().any(|text| text.contains("enabled again")), "{told} {}", run.out);
            assert!(!run.err.contains("S1IND"), "the terminal of an ACT: {told}");
            assert!(run.err.contains("STOA"), "{told}");
        }
    }
}

/// A servo has no P.228, and says so: what it answers is not waited for.
#[test]
fn a_zero_does_not_wait_for_a_setpoint_that_the_drive_does_not_have() {
    let run = antrieb("-v --drive acu -a 1 sollwert 0").on("[[drive]]\nmodel = \"lxm05\"\n").run();
    let said = when(&run.err, "01 65 01 E4");
    assert!(said < 100.0, "{said}: {}", run.err);
    assert_eq!(run.err.matches("read P.228").count(), 3, "who refuses it three times has none: {}", run.err);
}
