//! What a run does to the letter: how long it bears what, which word goes where, and what its notes say and do not say.

use super::rig::{Came, DISABLE, QUICK_STOP, READY, RUNNING, drive, held, held_of, run_at_20_hz, servo};
use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Meant, Motor, StopChoice, look, may_change_mode, shout_zero};
use antrieb::gate::Relief;
use antrieb::profile::{Family, Mode, Registry};
use antrieb::tick::{Span, Tick};
use serde_json::json;

/// The setpoint 20 Hz.
const REFRESH: &str = "01 65 01 E4 00 00 07 D0";

fn dead_after(telegrams: usize, ms: u64) -> Came {
    let dies = format!("[[drive.event]]\nafter_telegrams = {telegrams}\nsilent = \"{ms}ms\"");
    held(&drive(READY, &dies), &[], StopChoice::QuickStop, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.change("watchdog", 4).await?;
        run_at_20_hz(motor, Some(Span::from_secs(8))).await
    })
}

/// Telegrams up to a round of a hold.
fn up_to_the_hold() -> usize {
    let sent = dead_after(100_000, 0).sent;
    sent.iter().enumerate().filter(|(_, hex)| hex.starts_with(REFRESH)).nth(3).unwrap().0
}

#[test]
fn a_hold_outlives_a_line_that_is_dead_for_less_than_its_watchdog_bears() {
    let hold = up_to_the_hold();
    let outlived = |ms| (hold..hold + 4).filter(|&after| dead_after(after, ms).ended.result.is_ok()).count();
    // Half of 4 s for a look and the refresh behind it each, and nearly all of it since the last good look.
    assert_eq!((outlived(1_200), outlived(9_000)), (4, 0));
    assert!(outlived(2_800) > 0);
}

#[test]
fn a_stop_goes_out_before_the_watchdog_misses_us_and_not_at_the_first_lost_answer() {
    let hold = up_to_the_hold();
    for after in hold..hold + 4 {
        let came = dead_after(after, 600_000);
        let stop = came.sent.iter().position(|hex| hex.starts_with(QUICK_STOP)).unwrap();
        let borne = came.at[stop].since(came.heard).as_millis();
        assert!((2_000..4_000).contains(&borne), "{after}: {borne}");
    }
    // Held with nothing to say: looks alone are borne as long, and no longer.
    let held_still = |after: usize| {
        let dies = format!("[[drive.event]]\nafter_telegrams = {after}\nsilent = \"600s\"");
        held(&drive(READY, &dies), &[], StopChoice::QuickStop, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.change("watchdog", 4).await?;
            motor.walk("operation-enabled").await?;
            motor.hold(Some(Span::from_secs(30)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
        })
    };
    for after in 30..33 {
        let came = held_still(after);
        let stop = came.sent.iter().position(|hex| hex.starts_with(QUICK_STOP)).unwrap();
        let borne = came.at[stop].since(came.heard).as_millis();
        assert!((2_000..4_000).contains(&borne), "{after}: {borne}");
    }
    // On the way to its setpoint, where looks are all that goes out.
    let dies = "ramps = { up_right = 5, down_right = 5 }\n[[drive.event]]\nwhen = \"above 9Hz\"\nsilent = \"600s\"";
    for (watchdog, borne_ms) in [(Some(4), 2_000..4_000), (Some(8), 4_000..6_500), (None, 3_000..5_500)] {
        let came =
            held(&drive(READY, dies), &[], StopChoice::QuickStop, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
                if let Some(watchdog) = watchdog {
                    motor.change("watchdog", watchdog).await?;
                }
                run_at_20_hz(motor, None).await
            });
        let stop = came.sent.iter().position(|hex| hex.starts_with(QUICK_STOP)).unwrap();
        let borne = came.at[stop].since(came.heard).as_millis();
        assert!(borne_ms.contains(&borne), "{watchdog:?}: {borne}");
    }
}

#[test]
fn a_standstill_is_owed_to_a_quick_stop_and_not_to_a_coast_also_at_the_last_look() {
    // Gone by its watchdog while it did not answer, without an encoder.
    let gone = |choice, ms: u64| {
        let dies = format!("[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"{ms}ms\"");
        let bench = drive(&format!("{READY}, \"413\" = 2, \"217\" = 0, \"218\" = 0"), &dies);
        held(&bench, &[], choice, Span::ZERO, async |motor| run_at_20_hz(motor, None).await)
    };
    for (choice, acknowledged) in [(StopChoice::QuickStop, false), (StopChoice::Coast, true)] {
        let mut seen = 0;
        for ms in (9_400..14_000).step_by(400) {
            let came = gone(choice, ms);
            if came.stop().state.is_some() {
                seen += 1;
                let told = (came.stop().acknowledged, came.stop().standing);
                assert_eq!(told, (acknowledged, None), "{choice:?} {ms}: {:?}", came.ended);
            }
        }
        assert!(seen > 0, "{choice:?}");
    }
}

const COASTS: &str = "without power: a shaft that was turning coasts; nothing tells when it stands";

#[test]
fn the_note_of_a_stop_says_why_nothing_was_seen_only_where_that_was_promised() {
    let blind = |rest: &str| drive(&format!("{READY}, \"392\" = 0, \"217\" = 0, \"218\" = 0"), rest);
    let fault = "[[drive.event]]\nwhen = \"above 19Hz\"\nfault = \"F0500\"";
    for (choice, rest, why) in
        [(StopChoice::Ramp, "", true), (StopChoice::Coast, "", false), (StopChoice::Ramp, fault, false)]
    {
        let came = held(&blind(rest), &[], choice, Span::ZERO, async |motor| {
            run_at_20_hz(motor, Some(Span::from_secs(1))).await
        });
        let note = came.stop().note.clone().unwrap().en;
        assert!(note.starts_with(COASTS), "{choice:?}: {note}");
        assert_eq!(note.contains("P.392 = 0"), why, "{choice:?} {rest}: {note}");
        assert_eq!(note == COASTS, !why, "{choice:?} {rest}: {note}");
    }
}

#[test]
fn the_note_of_a_stop_that_nobody_heard_names_the_watchdog_of_the_run() {
    let dies = "[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"600s\"";
    for (stored, set, says, turns) in [
        (0, None, "is off", true),
        (7, None, "is 7 s", false),
        (7, Some(4), "is 4 s", false),
        (3, Some(0), "is off", true),
    ] {
        let bench = drive(&format!("{READY}, \"413\" = {stored}"), dies);
        let came = held(&bench, &[], StopChoice::QuickStop, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            // Another change before it, and behind it.
            let family = Registry::open(&[]).unwrap().family("acu").unwrap();
            motor.change_param(family.param(434).unwrap(), 3).await?;
            if let Some(set) = set {
                motor.change("watchdog", set).await?;
            }
            run_at_20_hz(motor, None).await
        });
        let note = came.stop().note.clone().unwrap().en;
        assert!(note.contains(says), "{stored} {set:?}: {note}");
        assert_eq!(note.contains("MAY STILL TURN"), turns, "{stored} {set:?}: {note}");
    }
}

/// PVn_target and PPp_targetusr by code 16, and the look at _DCOMopmd_act.
const VELOCITY_0: &str = "01 10 1B 1A 00 02 04 00 00 00 00";
const TARGET_0: &str = "01 10 1B 1C 00 02 04 00 00 00 00";
const SHOWN_MODE: &str = "01 03 1B 08";

#[test]
fn a_ramp_gives_the_setpoint_0_before_it_asks_for_the_mode_and_only_where_0_stops() {
    let run = |slug: &'static str, raw: i64| {
        let bench = servo("RAMPacc = 3000, RAMPdecel = 3000, PPp_targetusr = 12", "");
        held_of("lxm05", &bench, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            let registry = Registry::open(&[]).unwrap();
            let family = registry.family("lxm05").unwrap();
            let mode = family.mode(slug).unwrap().clone();
            motor.prepare(&mode);
            motor.walk("operation-enabled").await?;
            motor.enter().await?;
            motor.make_it_count().await?;
            motor.give(&family.param_or_unknown(mode.setpoint), raw, "").await?;
            if let Some(start) = mode.starts.first() {
                motor.travel(start).await?;
            }
            motor.hold(Some(Span::from_millis(300)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
        })
    };
    let velocity = run("velocity", 300);
    let first = velocity.sent.iter().position(|hex| hex.starts_with(VELOCITY_0)).unwrap();
    let asked = velocity.sent.iter().rposition(|hex| hex.starts_with(SHOWN_MODE)).unwrap();
    assert!(first < asked, "{:?}", velocity.sent);
    let position = run("position", 3_000);
    assert!(position.stop().acknowledged, "{:?}", position.ended);
    assert!(!position.sent.iter().any(|hex| hex.starts_with(TARGET_0)), "{:?}", position.sent);
}

#[test]
fn two_drives_at_one_address_are_not_enabled() {
    // Nothing but P.372 is different, so that only the look at it tells.
    let drive = |delay, speed| {
        let set = format!("\"412\" = 1, \"372@1\" = {speed}");
        format!("[[drive]]\nmodel = \"act\"\nreply_delay = \"{delay}ms\"\nset = {{ {set} }}\n")
    };
    with_motor(
        "act",
        &(drive(4, 1391) + &drive(14, 1491)),
        async |session, target, permit| {
            let speed = target.family.param(372).unwrap().clone();
            let mut differs = false;
            for _ in 0..4 {
                differs |= target.read_set(session, &speed, 1).await.is_err();
            }
            assert!(differs);
            let mut motor = Motor::new(session, target, permit, None);
            let ended = motor
                .run(false, StopChoice::Ramp, async |motor: &mut Motor<'_, '_>| motor.walk("operation-enabled").await)
                .await;
            let failure = ended.result.unwrap_err();
            assert_eq!(failure.code, "garbled.two_answers", "{failure:?}");
        },
        |bench| assert_eq!(bench.totals().energised, 0),
    );
}

#[test]
fn a_quick_stop_walks_the_transitions_of_the_machine() {
    // It has hardly begun to turn, so that it has left the quick stop by itself before anybody looks.
    let active = drive(RUNNING, "").replace("115200", "19200");
    with_motor(
        "acu",
        &active,
        async |session, target, permit| {
            let mut motor = Motor::new(session, target, permit, None);
            motor.command("quick-stop").await.unwrap();
            let steps: Vec<_> = motor.steps.iter().map(|step| step.transition.as_str()).collect();
            assert_eq!(steps, ["11", "12"]);
        },
        |bench| assert_eq!(bench.totals().turning, 0),
    );
    with_motor(
        "lxm05",
        "[[drive]]\nmodel = \"lxm05\"\n",
        async |session, target, permit| {
            let mut motor = Motor::new(session, target, permit, None);
            motor.walk("operation-enabled").await.unwrap();
            let up = motor.steps.len();
            motor.command("quick-stop").await.unwrap();
            let steps: Vec<_> = motor.steps.iter().skip(up).map(|step| step.transition.as_str()).collect();
            assert_eq!(steps, ["11", "12"]);
        },
        |bench| assert_eq!(bench.totals().energised, 0),
    );
}

/// Modes in which a bare zero stops.
pub(super) fn zeros(family: &Family) -> Vec<Mode> {
    family.modes.iter().filter(|mode| mode.zero_stops() && mode.starts.is_empty()).cloned().collect()
}

#[test]
fn a_zero_goes_to_the_mode_that_the_drive_shows_and_to_no_other() {
    // PVn_target 6938 of the velocity profile, SPEEDn_target 8456 of speed control.
    for (slug, own, other) in [("speed", 8_456, 6_938), ("velocity", 6_938, 8_456)] {
        let kept = "references_after_run = \"kept\", references_after_mode = \"kept\"";
        with_motor(
            "lxm05",
            &servo("RAMPacc = 3000, RAMPdecel = 3000", &format!("readings = {{ {kept} }}")),
            async |session, target, permit| {
                let family = target.family.clone();
                let mut motor = Motor::new(session, target, permit, None);
                motor.set(family.param(other).unwrap(), 700).await.unwrap();
                motor.prepare(family.mode(slug).unwrap());
                motor.enter().await.unwrap();
                motor.make_it_count().await.unwrap();
                motor.set(family.param(own).unwrap(), 300).await.unwrap();
                let registry = Registry::open(&[]).unwrap();
                let meant = Meant { address: 1, family: Some(family), order: None };
                assert!(shout_zero(session, &registry, &meant, &zeros).await.unwrap());
                let drive = session.bench().unwrap().drive(1).unwrap();
                assert_eq!((drive.ram(own, 0), drive.ram(other, 0)), (Some(0), Some(700)), "{slug}");
            },
            |_| {},
        );
    }
}

#[test]
fn the_mode_of_a_shaft_that_stands_may_be_changed() {
    with_motor(
        "lxm05",
        &servo("RAMPacc = 3000", ""),
        async |session, target, permit| {
            let family = target.family.clone();
            let mut motor = Motor::new(session, target, permit, None);
            motor.prepare(family.mode("velocity").unwrap());
            motor.walk("operation-enabled").await.unwrap();
            motor.enter().await.unwrap();
            motor.make_it_count().await.unwrap();
            let state = look(session, target).await.unwrap().state;
            may_change_mode(session, target, &state, family.mode("speed").unwrap()).await.unwrap();
        },
        |_| {},
    );
}

#[test]
fn a_word_that_asks_for_no_power_does_not_make_a_drive_one_that_had_some() {
    let idle = drive(&format!("{READY}, \"217\" = 0, \"218\" = 0"), "");
    let came = held(&idle, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.walk("switched-on").await?;
        motor.command("shutdown").await?;
        motor.command("disable-voltage").await?;
        assert!(motor.is_idle());
        motor.walk("operation-enabled").await?;
        assert!(!motor.is_idle());
        Ok(())
    });
    assert!(came.ended.result.is_ok(), "{:?}", came.ended);
    assert!(came.sent.iter().any(|hex| hex.starts_with(DISABLE)));
}

#[test]
fn a_drive_that_was_relieved_of_its_power_gets_no_other_stop() {
    let came = held(&drive(READY, ""), &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        run_at_20_hz(motor, Some(Span::from_millis(100))).await?;
        motor.relieving = Some(Tick::ZERO + Span::from_secs(60));
        motor.relieve(Relief::DisableVoltage).await
    });
    assert!(came.ended.result.is_ok() && came.ended.stop.is_none(), "{:?}", came.ended);
    assert_eq!(came.energised, 0);
}

#[test]
fn what_a_run_keeps_is_what_its_report_says() {
    let line = "-b 115200 -a 1 --yes sollwert 20Hz --enable --hold --duration 50ms --until reached --watchdog 2s";
    let run = antrieb(&format!("{line} --on-exit quick-stop")).on(&drive(READY, "")).json().exits(0);
    assert_eq!((run.data("/setpoint/writes"), run.data("/changed/0/old")), (&json!(2), &json!(0)));
    let steps: Vec<_> = run.data("/steps").as_array().unwrap().iter().map(|step| step["transition"].clone()).collect();
    assert!(!steps.is_empty() && steps.iter().all(|number| number != ""), "{steps:?}");
}

#[test]
fn a_verb_that_stops_waits_for_a_ramp_that_lasts_and_says_that_it_stands() {
    // From 10 Hz in 25 s: longer than a stop that proves nothing is pursued.
    let bench = drive(
        &format!("{RUNNING}, \"392\" = 2, \"424\" = \"0.4\", \"425\" = \"0.4\""),
        "ramps = { up_right = 999, down_right = 0.4, up_left = 999, down_left = 0.4 }",
    );
    for verb in ["disable", "quick-stop"] {
        // The first telegrams go to a drive that has had time to run up.
        let run = antrieb(&format!("-v -b 115200 -a 1 statemachine {verb}")).on(&bench).json();
        let last =
            run.err.lines().filter_map(|line| line.split_once(" ms > ")?.0.trim().parse::<f64>().ok()).next_back();
        assert_eq!((run.exit, run.data("/standing")), (0, &json!(true)), "{verb}: {:#}", run.value);
        assert!(last.is_some_and(|ms| ms > 15_000.0), "{verb}: {last:?}");
    }
}

#[test]
fn a_short_watchdog_is_fed_in_every_wait() {
    let bench = servo("RAMPacc = 600, RAMPdecel = 600", "readings = { node_guard_fed_by = \"all\" }");
    let came = held_of("lxm05", &bench, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        let registry = Registry::open(&[]).unwrap();
        let family = registry.family("lxm05").unwrap();
        let mode = family.mode("velocity").unwrap().clone();
        let param = family.param_or_unknown(mode.setpoint);
        motor.change("watchdog", 48).await?;
        motor.prepare(&mode);
        motor.walk("operation-enabled").await?;
        motor.enter().await?;
        motor.make_it_count().await?;
        motor.give(&param, 300, "1/min").await?;
        motor.until_reached().await?;
        motor.hold(Some(Span::from_secs(1)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    });
    assert!(came.ended.result.is_ok() && came.stop().acknowledged, "{:?}", came.ended);
}

#[test]
fn a_drive_that_comes_back_after_it_was_given_up_gets_its_stop_and_its_settings() {
    let dies = "ramps = { up_right = 50, down_right = 20 }\n[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"20s\"";
    with_motor(
        "acu",
        &drive(READY, dies).replace("115200", "19200"),
        async |session, target, permit| {
            let family = target.family.clone();
            let mut motor = Motor::new(session, target, permit, None);
            let ended = motor
                .run(true, StopChoice::QuickStop, async |motor: &mut Motor<'_, '_>| {
                    motor.change_param(family.param(434).unwrap(), 3).await?;
                    run_at_20_hz(motor, None).await
                })
                .await;
            let given_up = ended.stop.unwrap();
            assert!(!given_up.acknowledged && motor.unheard, "{given_up:?}");
            assert!(motor.changes.iter().all(|change| !change.restored));
            // It answers again while the stop goes out once more.
            let stop = motor.stop_after_all(&given_up).await;
            assert_eq!((stop.acknowledged, stop.choice, stop.because), (true, "quick-stop", "error"), "{stop:?}");
            assert!(motor.changes.iter().all(|change| change.restored), "{:?}", motor.changes);
        },
        |bench| assert_eq!((bench.totals().turning, bench.totals().energised), (0, 0)),
    );
}

#[test]
fn a_quick_stop_in_place_of_a_ramp_is_no_success_also_where_everything_is_answered_later() {
    // What the control word is was asked for twice, and not told.
    let lost = "[[disturb]]\nonce = 1\nkind = \"lost\"\n[[disturb]]\nonce = 2\nkind = \"lost\"";
    let bench = drive(&format!("{RUNNING}, \"392\" = 2"), lost);
    let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&bench).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.other_stop", "{:#}", run.value);
    assert!(run.err.contains(&format!("> {QUICK_STOP}")), "{}", run.err);
}

#[test]
fn a_holding_time_is_waited_for() {
    let bench = drive(&format!("{READY}, \"638\" = 9"), "ramps = { up_right = 50, down_right = 50 }");
    for choice in [StopChoice::Ramp, StopChoice::QuickStop] {
        let came = held(&bench, &[], choice, Span::ZERO, async |motor| {
            run_at_20_hz(motor, Some(Span::from_millis(200))).await
        });
        assert!(came.stop().acknowledged && came.stop().escalated.is_none(), "{:?}", came.ended);
        assert!(came.took > Tick::ZERO + Span::from_secs(9), "{:?}", came.took);
    }
}
