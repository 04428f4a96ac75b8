//! What is claimed of a drive at the end, and what is not.

use super::rig::{READY, RUNNING, drive, held, servo};
use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::tick::Span;
use serde_json::json;

const LINE: &str = "-v -b 115200 -a 1 --drive acu";
const RAMPS: &str = "ramps = { up_right = 999, down_right = 40, up_left = 999, down_left = 40 }\n";

fn dies(after: usize) -> String {
    format!("{RAMPS}[[drive.event]]\nafter_telegrams = {after}\nsilent = \"600s\"")
}

/// Whoever has power may be turned by somebody else while nobody looks.
#[test]
fn a_drive_with_power_whose_answers_end_is_not_said_to_stand() {
    let line = format!("{LINE} sollwert 0");
    let all = antrieb(&line).on(&drive(RUNNING, RAMPS)).exits(0).sent().len();
    for after in 1..all {
        let run = antrieb(&line).on(&drive(RUNNING, &dies(after))).json();
        let told = |pointer: &str| run.value.pointer(pointer) == Some(&json!(true));
        assert!(!told("/data/standing"), "dead after {after} of {all}: {:#}", run.value);
        // What it was before its silence says nothing of what it does now.
        assert!(run.exit != 0 && !told("/data/running"), "dead after {after} of {all}: {:#}", run.value);
    }
}

/// P.392 says what a frequency of 0 behind a ramp is worth; nothing says anything else of a quick stop.
#[test]
fn a_standstill_that_was_seen_is_told_though_answers_end_where_nothing_is_left_to_ask() {
    const SETTING: &str = "01 03 61 88";
    for (verb, needs) in [("disable", true), ("quick-stop", false)] {
        let line = format!("{LINE} statemachine {verb}");
        let clean = antrieb(&line).on(&drive(RUNNING, RAMPS)).exits(0).sent();
        let told = clean.iter().position(|hex| hex.starts_with(SETTING)).map_or(0, |asked| asked + 1);
        assert_eq!(told > 0, needs, "{clean:?}");
        let mut stands = 0;
        for after in clean.len() - 9..clean.len() {
            let run = antrieb(&line).on(&drive(RUNNING, &dies(after))).json();
            let seen = run.data("/running") == &json!(false) && after > told;
            let expected = if seen { json!(true) } else { json!(null) };
            assert_eq!(run.data("/standing"), &expected, "{verb}, dead after {after}: {:#}", run.value);
            stands += u32::from(seen);
        }
        assert!(stands > 2, "{verb}: {stands}");
    }
}

/// Another drive with its address answers otherwise: what was proven may be of either.
#[test]
fn nothing_is_told_of_one_of_two_drives() {
    for verb in ["disable", "disable-voltage"] {
        for by in [10, 20, 40] {
            let twin = format!("[[disturb]]\nevery = 1\nkind = \"twin\"\nby = \"{by}ms\"");
            let bench = drive(RUNNING, &format!("{RAMPS}{twin}")).replace("115200", "19200");
            let run = antrieb(&format!("-a 1 --drive acu statemachine {verb}")).on(&bench).json();
            let told = format!("{verb}, {by} ms behind: {:#}", run.value);
            assert_ne!(run.exit, 0, "{told}");
            assert_eq!((run.data("/running"), run.data("/standing")), (&json!(null), &json!(null)), "{told}");
            assert!(run.error()["message"].as_str().unwrap().starts_with("THE SHAFT MAY STILL TURN"), "{told}");
        }
    }
}

/// Two answers to one question were heard, long ago: that is told at the end.
#[test]
fn that_two_answers_differed_is_not_forgotten() {
    for (twin, differs) in [("", false), ("[[disturb]]\nonce = 2\nkind = \"twin\"\n", true)] {
        let bench = drive(READY, twin).replace("115200", "19200");
        with_motor(
            "acu",
            &bench,
            async |session, target, permit| {
                let mut motor = Motor::new(session, target, permit, None);
                let walked = motor.walk("switched-on").await;
                assert_eq!((walked.is_err(), motor.differs(), motor.twins().is_some()), (differs, differs, differs));
            },
            |_| {},
        );
    }
}

const KEYS: &str = "RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000";

/// It trips on its way, or its line is gone: neither is the end of its time.
#[test]
fn a_movement_that_does_not_end_by_itself_says_why() {
    let line = "-v -a 1 --yes sollwert 300000usr --set PPn_target=300 --enable --until reached --hold --duration 2s";
    for (event, code) in
        [("fault = \"E2300\"\nclass = 3", "forbidden.fault"), ("silent = \"600s\"", "silence.no_reply")]
    {
        for at in [1_000, 1_500, 2_000] {
            let bench = servo(KEYS, &format!("[[drive.event]]\nat = \"{at}ms\"\n{event}\n"));
            let run = antrieb(line).on(&bench).json();
            let told = format!("{event} {at}: {:#}", run.value);
            assert_eq!(run.error()["code"], code, "{told}");
            assert!(!run.data("/notes").to_string().contains("--duration was over"), "{told}");
        }
    }
}

/// Another master lets it turn by a speed: its state shows "reached" then, of another setpoint.
#[test]
fn a_movement_is_not_at_its_end_while_its_shaft_turns() {
    const ENABLE: &str = "01 10 1B 02 00 02 04 00 00 00 0F";
    const START: &str = "01 10 1B 02 00 02 04 00 00 00 1F";
    let line = "-v -a 1 --yes sollwert 300000usr --set PPn_target=300 --enable --hold --duration 3s";
    let other = "[[drive.event]]\nat = \"1s\"\nset = { DCOMopmode = 3, PVn_target = 300 }\n";
    let run = antrieb(line).on(&servo(KEYS, other)).json();
    // The start is taken back where the movement has ended.
    let (_, behind) = run.err.split_once(&format!("> {START}")).unwrap();
    assert!(!behind.contains(&format!("> {ENABLE}")), "{:#} {}", run.value, run.err);
    assert_ne!(run.exit, 0, "{:#}", run.value);
}

/// What keeps it from running is said once, and of a stop that another master took away it is said too.
#[test]
fn what_is_missing_is_said_once_and_of_a_stop_that_is_not_obeyed_too() {
    let missing = drive(READY, "enable = false");
    let run = antrieb(&format!("{LINE} --yes statemachine enable")).on(&missing).json().exits(8);
    assert_eq!(run.value.to_string().matches("Remote bit 9 is 0").count(), 1, "{:#}", run.value);
    let taken = "ramps = { up_right = 999, down_right = 3 }\n[[drive.event]]\nat = \"100ms\"\nset = { \"412\" = 0 }";
    let run = antrieb(&format!("{LINE} statemachine disable")).on(&drive(RUNNING, taken)).json().exits(8);
    assert_eq!(run.value.to_string().matches("P.412 is 0").count(), 1, "{:#}", run.value);
}

/// What stays below its setpoint is told as that, and not as a wide band of a drive that calls it reached.
#[test]
fn a_band_is_blamed_only_where_the_drive_calls_that_reached() {
    let setpoint = Registry::open(&[]).unwrap().family("acu").unwrap().role("setpoint-frequency").unwrap().clone();
    // A tenth of 20 Hz, and half a hertz more; 1 Hz where that is more.
    for (goal, shown, deviation, why) in [
        (2_000, "18.00", 30, None),
        (2_000, "17.99", 30, Some("own wide band")),
        (500, "4.00", 30, None),
        (500, "3.99", 30, Some("own wide band")),
        (2_000, "17.99", 1, Some("does not move any more")),
    ] {
        let bench = drive(&format!("{READY}, \"210\" = \"{shown}\", \"549\" = {deviation}"), "");
        let came = held(&bench, &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.walk("operation-enabled").await?;
            motor.expects = Some((goal, goal));
            motor.give(&setpoint, goal, "Hz").await?;
            motor.until_reached().await
        });
        let message = came.ended.result.as_ref().err().map(|failure| failure.message.en.to_string());
        let told = format!("{goal} {shown} {deviation}: {:?}", came.ended.result);
        assert_eq!(message.is_some(), why.is_some(), "{told}");
        assert!(why.is_none_or(|why| message.unwrap().contains(why)), "{told}");
    }
}
