//! What goes out goes out as often as it is needed and no more, and to whom it is meant.

use super::rig::{DISABLE, READY, RUNNING, drive, held, run_at_20_hz, servo};
use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Meant, StopChoice, look, role_raw, shout_zero};
use antrieb::profile::{Family, Mode, Registry};
use antrieb::tick::Span;

/// Over VABus, where an acknowledgement is no echo.
#[test]
fn a_stop_that_is_acknowledged_in_time_is_said_once() {
    for delay_ms in [1, 200] {
        let bench =
            drive(RUNNING, "").replace("reply_delay = \"1ms\"", "protocol = \"vabus\"\nreply_delay = \"DELAY\"");
        let bench = bench.replace("DELAY", &format!("{delay_ms}ms"));
        let run = antrieb("-v --protocol vabus -b 115200 --drive acu -a 1 statemachine quick-stop").on(&bench).run();
        let sent = run.sent();
        let said = sent.iter().take_while(|hex| **hex == sent[0]).count();
        assert_eq!(said, 1, "{delay_ms}: {}", run.err);
    }
}

/// The look at the state would fall into the time that the 0 of the stator lasts, on a slow line.
#[test]
fn while_the_frequency_falls_it_is_what_is_looked_at() {
    let bench = drive(READY, "ramps = { up_right = 50, down_right = 5 }");
    let second = Some(Span::from_secs(1));
    let came = held(&bench, &[], StopChoice::Ramp, Span::ZERO, async |motor| run_at_20_hz(motor, second).await);
    let stop = came.sent.iter().position(|hex| hex.starts_with(DISABLE)).unwrap();
    let looks = |what: &str| came.sent[stop..].iter().filter(|hex| hex.starts_with(what)).count();
    // P.411 and P.210.
    let (state, frequency) = (looks("01 03 01 9B"), looks("01 64 00 D2"));
    assert!(
        (100..350).contains(&frequency) && state * 5 < frequency,
        "{state} looks at the state, {frequency} at the frequency: {:?}",
        &came.sent[stop..]
    );
}

#[test]
fn who_has_control_is_looked_at_every_second_of_a_run() {
    let three = Some(Span::from_secs(3));
    let came =
        held(&drive(READY, ""), &[], StopChoice::Coast, Span::ZERO, async |motor| run_at_20_hz(motor, three).await);
    let refreshed = |hex: &&String| hex.starts_with("01 65 01 E4 00 00 07 D0");
    // P.412 in RAM of data set 1, from the first refresh on.
    let from = came.sent.iter().position(|hex| refreshed(&hex)).unwrap();
    let looks = came.sent[from..].iter().filter(|hex| hex.starts_with("01 03 61 9C")).count();
    assert!((3..=7).contains(&looks), "{looks}");
}

#[test]
fn a_drive_without_a_fault_has_none_and_one_that_tripped_has() {
    for (model, trips, fault) in [("acu", "F0500", 0x0500), ("lxm05", "E2300", 0x2300)] {
        for tripped in [false, true] {
            let event = format!("[[drive.event]]\nat = \"1ms\"\nfault = \"{trips}\"\n");
            let bench = format!("[[drive]]\nmodel = \"{model}\"\n{}", if tripped { &event } else { "" });
            with_motor(
                model,
                &bench,
                async |session, target, _permit| {
                    session.rest(Span::from_millis(50)).await.unwrap();
                    let seen = look(session, target).await.unwrap();
                    assert_eq!(seen.fault, Some(if tripped { fault } else { 0 }), "{model}: {seen:?}");
                },
                |_| {},
            );
        }
    }
}

#[test]
fn a_zero_goes_to_every_mode_where_the_drive_shows_none() {
    let zeros = |family: &Family| -> Vec<Mode> {
        family.modes.iter().filter(|mode| mode.zero_stops() && mode.starts.is_empty()).cloned().collect()
    };
    with_motor(
        "lxm05",
        &servo("PVn_target = 700, SPEEDn_target = 300", ""),
        async |session, target, _permit| {
            let registry = Registry::open(&[]).unwrap();
            let active = role_raw(session, target, "mode-active").await.unwrap();
            let meant = Meant { address: 1, family: Some(target.family.clone()), order: None };
            assert!(shout_zero(session, &registry, &meant, &zeros).await.unwrap(), "{active:?}");
            let drive = session.bench().unwrap().drive(1).unwrap();
            assert_eq!((drive.ram(6_938, 0), drive.ram(8_456, 0)), (Some(0), Some(0)), "{active:?}");
        },
        |_| {},
    );
}
