//! What is known of a shaft that may coast: a standstill is proven, or nobody calls it one.

use super::rig::{DISABLE, ENCODER, READY, REFRESH, RUNNING, alone, drive, held, servo};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::json;

/// A drive without an encoder that is brought to 20 Hz and stopped there.
fn blind(set: &str, rest: &str) -> String {
    quick(&format!("{READY}, \"217\" = 0, \"218\" = 0, {set}"), rest)
}

/// With steep ramps: a run that is held takes its time.
fn quick(set: &str, rest: &str) -> String {
    let ramps = "ramps = { up_right = 50, down_right = 20, up_left = 50, down_left = 20 }";
    drive(&format!("{set}, \"424\" = 20"), &format!("{ramps}\n{rest}"))
}

const TO_20_HZ: &str = "-b 115200 -a 1 --yes sollwert 20Hz --enable --hold --duration 50ms --until reached";

#[test]
fn a_ramp_that_ends_under_power_proves_the_standstill() {
    for (protocol, slow) in [("rtu", ""), ("ascii", ""), ("vabus", ""), ("rtu", "slow = \"400ms\"")] {
        for way in ["ramp", "quick-stop"] {
            let bench = blind("\"392\" = 2", &format!("protocol = \"{protocol}\"\n{slow}"));
            let run = antrieb(&format!("--protocol {protocol} {TO_20_HZ} --on-exit {way}")).on(&bench).json();
            let told = format!("{protocol} {slow} {way}: {:#}", run.value);
            assert_eq!(
                (run.exit, run.data("/standing"), run.data("/stop/standing")),
                (0, &json!(true), &json!(true)),
                "{told}"
            );
            assert_eq!((run.data("/running"), run.data("/stop/acknowledged")), (&json!(false), &json!(true)), "{told}");
        }
    }
}

#[test]
fn a_ramp_that_lets_the_shaft_coast_is_no_success_and_says_why() {
    for (set, why) in [
        ("\"392\" = 0", "P.392 = 0"),
        ("\"392\" = 1, \"632\" = \"0.2\"", "P.392 = 1"),
        ("\"637\" = 40, \"638\" = 0", "P.637"),
    ] {
        let run = antrieb(TO_20_HZ).on(&blind(set, "")).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.standstill_unproven", "{set}");
        assert!(run.error()["hint"].as_str().unwrap().contains(why), "{}", run.error());
        assert_eq!((run.data("/running"), run.data("/standing")), (&json!(false), &json!(null)), "{set}");
        assert_eq!(
            (run.data("/stop/acknowledged"), run.data("/stop/escalated")),
            (&json!(false), &json!(null)),
            "{set}"
        );
        let table = antrieb(&format!("--lang de {TO_20_HZ}")).on(&blind(set, "")).run();
        assert!(table.out.contains("nein; ob die Welle steht, zeigt nichts"), "{}", table.out);
        assert!(table.err.contains("DIE WELLE KANN NOCH DREHEN"), "{}", table.err);
    }
}

#[test]
fn a_coast_is_given_as_asked_for_and_nobody_calls_it_a_standstill() {
    let run = antrieb(&format!("{TO_20_HZ} --on-exit coast")).on(&blind("\"392\" = 2", "")).json().exits(0);
    assert_eq!((run.data("/stop/acknowledged"), run.data("/stop/standing")), (&json!(true), &json!(null)));
    assert_eq!((run.data("/running"), run.data("/standing")), (&json!(false), &json!(null)));
    assert!(run.data("/stop/note").as_str().unwrap().contains("nothing tells when it stands"));
    let table = antrieb(&format!("{TO_20_HZ} --on-exit coast")).on(&blind("\"392\" = 2", "")).run();
    assert!(table.out.contains("no; whether the shaft stands is not told"), "{}", table.out);
}

#[test]
fn what_shows_a_coasting_shaft_is_waited_for() {
    let encoder = |set: &str| quick(&format!("{READY}, \"637\" = 40, \"638\" = 0, {set}"), "");
    let shown = blind("\"637\" = 40, \"638\" = 0", "readings = { coast_shows = \"shaft\" }");
    for bench in [encoder("\"392\" = 2"), encoder("\"392\" = 0"), shown] {
        for way in ["ramp", "coast"] {
            let run = antrieb(&format!("{TO_20_HZ} --on-exit {way}")).on(&bench).json().exits(0);
            assert_eq!((run.data("/stop/standing"), run.data("/standing")), (&json!(true), &json!(true)), "{way}");
            assert_eq!(witness::left().unwrap().0.totals().turning, 0, "{way}");
        }
    }
}

#[test]
fn a_coast_that_lasts_is_watched_for_a_while_and_no_longer_than_somebody_wants() {
    // 400 Hz; this bench loses 10 Hz a second, and an encoder shows it.
    let ramps = "ramps = { up_right = 999, down_right = 999, up_left = 999, down_left = 999 }";
    let bench = drive(&format!("{READY}, \"419\" = 400, \"549\" = 5, \"30\" = 210"), ramps);
    for (presses, most) in [(&[][..], 45), (&[REFRESH, ENCODER], 10)] {
        let work = async |motor: &mut Motor<'_, '_>| {
            let family = Registry::open(&[]).unwrap().family("acu").unwrap();
            let setpoint = family.role("setpoint-frequency").unwrap();
            motor.walk("operation-enabled").await?;
            motor.give(setpoint, 40_000, "Hz").await?;
            motor.until_reached().await?;
            let last = if presses.is_empty() { Some(Span::from_millis(100)) } else { None };
            motor.hold(last, async |motor: &mut Motor<'_, '_>, _| motor.refresh(setpoint, 40_000).await).await
        };
        let came = held(&bench, presses, StopChoice::Coast, Span::ZERO, work);
        let told = format!("{:?} {:?}", came.took, came.ended);
        assert_eq!((came.stop().acknowledged, came.stop().standing), (true, Some(false)), "{told}");
        assert!(came.took < Tick::ZERO + Span::from_secs(most) && came.turning == 1, "{told}");
    }
}

#[test]
fn the_end_of_a_run_that_lost_its_power_says_that_the_shaft_may_coast() {
    for (rest, code) in [
        ("enable = false", "forbidden.left_run"),
        ("start_right = false", "forbidden.left_run"),
        ("fault = \"F0500\"", "forbidden.fault"),
        ("mains = false", "forbidden.fault"),
    ] {
        let event = format!("[[drive.event]]\nwhen = \"above 19Hz\"\n{rest}");
        let run = antrieb(&TO_20_HZ.replace("50ms", "5s")).on(&blind("\"392\" = 2", &event)).json().exits(8);
        assert_eq!(run.error()["code"], code, "{rest}");
        let message = run.error()["message"].as_str().unwrap();
        assert!(message.starts_with("THE SHAFT MAY STILL TURN"), "{rest}: {message}");
        assert!(message.contains("whether the shaft stands is not told"), "{rest}: {message}");
        assert_eq!((run.data("/running"), run.data("/standing")), (&json!(false), &json!(null)), "{rest}");
    }
}

#[test]
fn a_drive_that_left_the_run_is_stopped_before_it_is_asked_why() {
    let event = "[[drive.event]]\nwhen = \"above 19Hz\"\nenable = false";
    let line = format!("-v {}", TO_20_HZ.replace("50ms", "5s"));
    let run = antrieb(&line).on(&blind("\"392\" = 2", event)).json().exits(8);
    let sent: Vec<_> = run.err.lines().filter_map(|line| line.split_once("> ")?.1.get(..17)).collect();
    let last = |hex: &str| sent.iter().rposition(|line| line.starts_with(hex)).unwrap();
    let stopped = sent.iter().position(|line| line.starts_with(DISABLE)).unwrap();
    let looked = sent.iter().take(stopped).rposition(|line| line.starts_with("01 03 01 9B")).unwrap();
    assert_eq!(looked + 1, stopped, "the stop follows the look that showed it: {}", run.err);
    assert!(last("01 03 00 FA") > stopped && run.error()["hint"].as_str().unwrap().contains("STOA"), "{}", run.err);
}

#[test]
fn a_verb_that_stops_says_what_is_known_of_the_shaft() {
    let running = |set: &str| quick(&format!("{RUNNING}, \"217\" = 0, \"218\" = 0, {set}"), "");
    for (verb, set, exit, standing) in [
        ("quick-stop", "\"392\" = 2", 0, json!(true)),
        ("disable", "\"392\" = 2", 0, json!(true)),
        ("disable-voltage", "\"392\" = 2", 0, json!(null)),
        ("disable", "\"392\" = 0", 0, json!(null)),
    ] {
        let run = alone(&format!("statemachine {verb}"), &running(set)).exits(exit);
        assert_eq!((run.data("/running"), run.data("/standing")), (&json!(false), &standing), "{verb} {set}");
        let notes = run.data("/notes").to_string();
        assert_eq!(notes.contains("nothing tells when it stands"), standing.is_null(), "{verb} {set}: {notes}");
    }
    // Nobody gave it power.
    let idle = antrieb("-b 115200 -a 1 --yes sollwert 5Hz").on(&blind("\"392\" = 2", "")).run();
    assert!(idle.out.lines().any(|line| line.trim_end().ends_with(" no")), "{}", idle.out);
}

#[test]
fn a_servo_without_power_that_turns_is_never_under_a_plain_no() {
    let turning = servo("RAMPacc = 6000, RAMPn_max = 3000", "");
    let at_speed = "-a 1 --drive lxm05 --yes sollwert 900rpm --enable --hold --duration 1s";
    let run = antrieb(&format!("{at_speed} --on-exit coast")).on(&turning).json().exits(0);
    // It was watched until it stood.
    assert_eq!((run.data("/stop/standing"), run.data("/standing")), (&json!(true), &json!(true)));
    let changed = antrieb(&format!("{at_speed} --on-exit coast --set RAMPdecel=500")).on(&turning).json().exits(0);
    assert_eq!((changed.data("/changed/0/restored"), changed.data("/stop/standing")), (&json!(true), &json!(true)));
}
