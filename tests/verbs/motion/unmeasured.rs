//! A shaft that nobody measured may coast: exit 0 only where what was promised was seen.

use super::rig::{READY, drive};
use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice, look};
use serde_json::json;

/// An ACTIVE without power, and without an encoder.
fn idle(model: &str, set: &str) -> String {
    drive(&format!("{READY}, \"217\" = 0, \"218\" = 0, {set}"), "").replace("acu", model)
}

#[test]
fn a_stop_of_a_drive_without_power_at_the_first_look_promises_no_more_than_was_seen() {
    for model in ["act", "acu"] {
        for (verb, set, exit) in [
            ("quick-stop", "\"392\" = 2", 8),
            ("disable", "\"392\" = 2", 8),
            // It is set to coast, so that is what was asked for.
            ("disable", "\"392\" = 0", 0),
            ("disable-voltage", "\"392\" = 2", 0),
        ] {
            let run = antrieb(&format!("-b 115200 -a 1 statemachine {verb}")).on(&idle(model, set)).json();
            let told = format!("{model} {verb} {set}: {:#}", run.value);
            assert_eq!(
                (run.exit, run.data("/running"), run.data("/standing")),
                (exit, &json!(false), &json!(null)),
                "{told}"
            );
            if exit > 0 {
                assert_eq!(run.error()["code"], "forbidden.standstill_unproven", "{told}");
                assert!(run.error()["hint"].as_str().unwrap().contains("no power at any look"), "{told}");
            }
        }
        // What needs no power is what a zero promises.
        antrieb("-b 115200 -a 1 sollwert 0").on(&idle(model, "\"392\" = 2")).json().exits(0);
    }
    for verb in ["quick-stop", "disable", "disable-voltage"] {
        let run = antrieb(&format!("-a 1 statemachine {verb}")).on("[[drive]]\nmodel = \"lxm05\"\n").json().exits(0);
        assert_eq!(run.data("/standing"), &json!(true), "a servo tells its position without power too");
    }
}

#[test]
fn a_servo_whose_answers_end_before_its_standstill_was_seen_is_no_success() {
    let mut unseen = 0;
    for verb in ["quick-stop", "disable"] {
        for dead in 1..30 {
            let event = format!("[[drive.event]]\nafter_telegrams = {dead}\nsilent = \"600s\"");
            let bench = format!("[[drive]]\nmodel = \"lxm05\"\n{event}\n");
            let run = antrieb(&format!("-a 1 --drive lxm05 statemachine {verb}")).on(&bench).json();
            let told = format!("{verb}, dead after {dead}: {:#}", run.value);
            let stands = run.value.pointer("/data/standing") == Some(&json!(true));
            assert!(run.exit != 0 || stands, "{told}");
            unseen += u32::from(run.exit == 8 && run.error()["code"] == "forbidden.standstill_unproven");
        }
    }
    assert!(unseen > 0);
}

#[test]
fn a_run_that_gave_no_power_proves_no_standstill_either() {
    for model in ["act", "acu"] {
        for (on_exit, exit) in [("ramp", 8), ("quick-stop", 8), ("coast", 0)] {
            let line = format!("--yes statemachine goto switched-on --hold --duration 300ms --on-exit {on_exit}");
            let run = antrieb(&format!("-b 115200 -a 1 {line}")).on(&idle(model, "\"392\" = 2")).json();
            let told = format!("{model} {on_exit}: {:#}", run.value);
            assert_eq!((run.exit, run.data("/stop/acknowledged")), (exit, &json!(true)), "{told}");
            assert_eq!((run.data("/running"), run.data("/stop/standing")), (&json!(false), &json!(null)), "{told}");
            if exit > 0 {
                assert_eq!(run.error()["code"], "forbidden.standstill_unproven", "{told}");
                // Nobody gave it power here.
                assert!(!run.error()["message"].as_str().unwrap().contains("MAY STILL TURN"), "{told}");
                assert!(run.error()["hint"].as_str().unwrap().contains("--on-exit coast"), "{told}");
            }
        }
    }
    let refused = idle("acu", "\"392\" = 2").replace("model", "enable = false\nmodel");
    let run = antrieb("-b 115200 -a 1 --yes statemachine enable --hold").on(&refused).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.interlock");
    assert!(!run.error()["message"].as_str().unwrap().contains("MAY STILL TURN"), "{}", run.error());
}

#[test]
fn an_encoder_shows_a_shaft_that_coasts_from_before() {
    for (set, standing) in [("\"392\" = 0", Some(true)), ("\"392\" = 0, \"217\" = 0, \"218\" = 0", None)] {
        with_motor(
            "acu",
            &drive(&format!("{READY}, {set}"), "ramps = { up_right = 50, down_right = 50 }").replace("115200", "19200"),
            async |session, target, permit| {
                let setpoint = target.family.role("setpoint-frequency").unwrap().clone();
                let mut motor = Motor::new(session, target, permit, None);
                motor.walk("operation-enabled").await.unwrap();
                motor.give(&setpoint, 2_000, "Hz").await.unwrap();
                motor.until_reached().await.unwrap();
                motor.command("disable-voltage").await.unwrap();
                let before = look(session, target).await.unwrap();
                assert_eq!(before.state, "switch-on-disabled");
                assert_eq!(session.bench().unwrap().totals().turning, 1, "it coasts");
                let mut motor = Motor::new(session, target, permit, None);
                motor.controls(&before);
                let ended = motor.run(true, StopChoice::Ramp, async |_: &mut Motor<'_, '_>| Ok(())).await;
                let stop = ended.stop.unwrap();
                assert_eq!((stop.acknowledged, stop.standing), (true, standing), "{stop:?}");
                assert_eq!(session.bench().unwrap().totals().turning == 0, standing.is_some(), "it was waited for");
            },
            |_| {},
        );
    }
}

/// Contacts start and stop it; a least frequency lifts a setpoint of 0.
fn by_contacts(model: &str, least: &str) -> String {
    let set = format!("\"410\" = 0, \"412\" = 0, \"434\" = 2, \"484\" = 10, \"418\" = \"{least}\", \"413\" = 2");
    drive(&set, "").replace("acu", model)
}

#[test]
fn a_shaft_that_its_contacts_keep_turning_is_told_before_and_is_no_silence_afterwards() {
    const LINE: &str = "-b 115200 -a 1 sollwert 20Hz --hold --duration 500ms --wait 300ms";
    for model in ["act", "acu"] {
        for (lang, theirs, lifted) in [("en", "its contacts", "3.50 Hz"), ("de", "seine Kontakte", "3.50 Hz")] {
            let bench = by_contacts(model, "3.5");
            let asked = antrieb(&format!("--lang {lang} {LINE}")).on(&bench).answered("n").exits(8);
            assert!(asked.err.contains(theirs) && asked.err.contains(lifted), "{}", asked.err);
            let run = antrieb(&format!("--lang {lang} --yes {LINE}")).on(&bench).json().exits(8);
            assert_eq!(run.error()["code"], "forbidden.not_stopped", "{:#}", run.value);
            let told = (run.data("/stop/state/slug"), run.data("/running"), run.data("/standing"));
            assert_eq!(told, (&json!("operation-enabled"), &json!(true), &json!(false)));
            assert!(run.error()["hint"].as_str().unwrap().contains(theirs), "{}", run.error());
        }
        let stands = antrieb(&format!("--yes {LINE}")).on(&by_contacts(model, "0")).json();
        assert_eq!(stands.data("/standing"), &json!(true), "{:#}", stands.value);
    }
    let own =
        antrieb("-b 115200 -a 1 sollwert 20Hz --hold --duration 500ms").on(&drive(READY, "")).answered("n").exits(8);
    assert!(own.err.contains("it is stopped when this program ends"), "{}", own.err);
}

#[test]
fn a_drive_that_loses_its_power_on_the_way_to_zero_is_not_said_to_stand() {
    let set = "\"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 10, \"418\" = 0, \"217\" = 0, \"218\" = 0";
    let mut unseen = 0;
    for telegrams in 1..12 {
        let bench = drive(set, &format!("[[drive.event]]\nafter_telegrams = {telegrams}\nenable = false"));
        let run = antrieb("-b 115200 -a 1 --drive acu sollwert 0").on(&bench).json();
        let seen_powered = run.data("/from/slug") == &json!("operation-enabled");
        let told = format!("{telegrams}: {:#}", run.value);
        assert!(run.exit != 0 || !seen_powered || run.data("/setpoint/reached") == &json!(true), "{told}");
        unseen += u32::from(run.exit == 8);
    }
    assert!(unseen > 0);
}
