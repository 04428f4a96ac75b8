//! What a run remembers, and what it must not: proofs from before, an enable that it walked to, what it changed.

use super::rig::{READY, drive, held, servo};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::tick::Span;
use antrieb::transport::witness;
use serde_json::json;

const ONE: Span = Span::from_secs(1);

#[test]
fn an_enable_that_is_lost_right_behind_the_walk_ends_the_run() {
    let walk = async |motor: &mut Motor<'_, '_>| motor.walk("operation-enabled").await;
    let walked = held(&drive(READY, ""), &[], StopChoice::Keep, Span::ZERO, walk).sent.len();
    let lost = format!("[[drive.event]]\nafter_telegrams = {walked}\nenable = false");
    let came = held(&drive(READY, &lost), &[], StopChoice::QuickStop, Span::ZERO, async |motor| {
        motor.walk("operation-enabled").await?;
        motor.hold(Some(ONE), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    });
    assert_eq!(came.ended.result.as_ref().err().map(|failure| failure.code.as_str()), Some("forbidden.left_run"));
    assert_eq!(came.energised, 0);
}

/// Its stator shows 0 Hz as soon as the power is gone, while the shaft coasts; nobody looked at it as it turned.
#[test]
fn a_standstill_from_before_proves_nothing_of_a_stop() {
    let setpoint = Registry::open(&[]).unwrap().family("acu").unwrap().role("setpoint-frequency").unwrap().clone();
    let bench = drive(&format!("{READY}, \"217\" = 0, \"218\" = 0"), "");
    let came = held(&bench, &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.walk("operation-enabled").await?;
        motor.give(&setpoint, 2_000, "Hz").await?;
        motor.until_reached().await?;
        // Down by a ramp, which is seen to end at 0 under power, and up again.
        motor.walk("switched-on").await?;
        motor.walk("operation-enabled").await?;
        motor.give(&setpoint, 2_000, "Hz").await?;
        motor.hold(Some(ONE), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    });
    assert_eq!((came.stop().standing, came.turning), (None, 1), "{:?}", came.ended);
}

#[test]
fn what_was_set_to_0_before_the_enable_is_no_change_to_give_back() {
    let standing = servo("PVn_target = 900, RAMPacc = 3000, RAMPdecel = 3000", "");
    // Only an ACT lets its line setpoint be read, so that it could be remembered.
    let inverter = drive(&format!("{READY}, \"484\" = 10"), "").replace("acu", "act");
    for (bench, who, setpoint) in [(standing, "--drive lxm05", 6_938), (inverter, "-b 115200 --drive act", 484)] {
        let line = format!("{who} -a 1 --yes statemachine enable --hold --duration 200ms --on-exit coast");
        let run = antrieb(&line).on(&bench).json().exits(0);
        let (bench, _) = witness::left().unwrap();
        let left = bench.drive(1).unwrap().ram(setpoint, 0);
        assert_eq!((run.data("/changed"), left), (&json!([]), Some(0)), "{:#}", run.value);
    }
}

#[test]
fn what_is_lost_while_it_is_given_back_is_given_back_again() {
    let line = "-v -b 115200 -a 1 --yes sollwert 10Hz --enable --watchdog 4s --hold --duration 50ms --on-exit coast";
    let clean = antrieb(line).on(&drive(READY, "")).exits(0).sent();
    // P.413 = 0 in RAM, behind the stop.
    let back = clean.iter().rposition(|hex| hex.starts_with("01 06") && hex.contains(" 9D 00 00")).unwrap();
    for (silent_ms, restored) in [(1_600, true), (60_000, false)] {
        let lost = format!("[[drive.event]]\nafter_telegrams = {back}\nsilent = \"{silent_ms}ms\"");
        let run = antrieb(line).on(&drive(READY, &lost)).json();
        assert_eq!(run.data("/changed/0/restored"), &json!(restored), "{:#}\n{}", run.value, run.err);
        assert_eq!(run.exit == 0, restored, "{:#}", run.value);
    }
}
