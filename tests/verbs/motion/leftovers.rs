//! What a drive does by its own settings and by what stands in it from before: told first, and never a surprise.

use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice, look, may_change_mode};
use antrieb::drive::{Session, Target};
use antrieb::gate::{Motion, Permit};
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::json;

const SUM: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 10 }\n";

fn servo(readings: &str) -> String {
    format!("[[drive]]\nmodel = \"lxm05\"\nset = {{ RAMPacc = 3000, RAMPdecel = 3000 }}\nreadings = {{ {readings} }}\n")
}

/// Turns the shaft in the velocity profile at 600 1/min and leaves it so.
async fn turn(session: &mut Session<'_>, target: &mut Target, permit: &Permit<Motion>) {
    let (mode, param) = (target.family.mode("velocity").unwrap().clone(), target.family.param(6_938).unwrap().clone());
    let mut motor = Motor::new(session, target, permit, None);
    let ended = motor
        .run(false, StopChoice::Ramp, async |motor: &mut Motor<'_, '_>| {
            motor.prepare(&mode);
            motor.walk("operation-enabled").await?;
            motor.enter().await?;
            motor.make_it_count().await?;
            motor.give(&param, 600, "1/min").await?;
            motor.until_reached().await
        })
        .await;
    ended.result.unwrap();
}

#[test]
fn a_setpoint_that_stands_in_a_servo_does_not_start_it() {
    let kept = "references_after_run = \"kept\", references_after_mode = \"kept\"";
    for (mode, setpoint, reference) in [("velocity", 6_938, None), ("speed", 8_456, Some((6_946, 2)))] {
        with_motor(
            "lxm05",
            &servo(kept),
            async |session, target, permit| {
                let family = target.family.clone();
                let mut motor = Motor::new(session, target, permit, None);
                motor.prepare(family.mode(mode).unwrap());
                motor.enter().await.unwrap();
                motor.make_it_count().await.unwrap();
                motor.set(family.param(setpoint).unwrap(), 900).await.unwrap();
                let mut motor = Motor::new(session, target, permit, None);
                motor.walk("operation-enabled").await.unwrap();
                let told = motor.notes.iter().map(|note| &*note.en).collect::<Vec<_>>().join("\n");
                let label = family.param(setpoint).unwrap().label();
                assert!(told.contains(&format!("{label} still stands at 900 1/min")), "{told}");
                session.rest(Span::from_secs(2)).await.unwrap();
                let drive = session.bench().unwrap().drive(1).unwrap();
                assert_eq!(drive.ram(setpoint, 0), Some(0));
                assert!(reference.is_none_or(|(param, _)| drive.ram(param, 0) == Some(0)));
            },
            |bench| assert_eq!((bench.totals().turning, bench.totals().energised), (0, 1), "{mode}"),
        );
    }
}

#[test]
fn a_gear_run_leaves_no_reference_behind() {
    let bench = servo("references_after_run = \"kept\", references_after_mode = \"kept\"");
    antrieb("-a 1 --yes sollwert 2/3 --enable --hold --duration 50ms").on(&bench).json().exits(0);
    let (bench, _) = witness::left().unwrap();
    assert_eq!(bench.drive(1).unwrap().ram(6_948, 0), Some(0));
}

/// 6.3.1: a drive may refuse another mode while it turns; the axis then still turns in the old one.
#[test]
fn the_ramp_acts_on_the_mode_that_the_drive_shows() {
    for wanted in ["current", "speed", "gear", "jog"] {
        with_motor(
            "lxm05",
            &servo("mode_change = \"refused\", control_7 = \"refused\""),
            async |session, target, permit| {
                turn(session, target, permit).await;
                let mode = target.family.mode(wanted).unwrap().clone();
                let mut motor = Motor::new(session, target, permit, None);
                let ended = motor
                    .run(true, StopChoice::Ramp, async |motor: &mut Motor<'_, '_>| {
                        motor.walk("operation-enabled").await?;
                        motor.prepare(&mode);
                        motor.enter().await
                    })
                    .await;
                assert!(ended.result.is_err(), "{wanted}");
                let stop = ended.stop.unwrap();
                assert!(stop.acknowledged && stop.escalated.is_none(), "{wanted}: {stop:?}");
            },
            |bench| assert_eq!((bench.totals().turning, bench.totals().energised), (0, 0), "{wanted}"),
        );
    }
}

#[test]
fn behind_node_guarding_the_way_out_is_walked_and_everything_given_back() {
    for reading in ["quick-stop", "fault"] {
        with_motor(
            "lxm05",
            // The line is dead for a second while the shaft turns.
            &format!(
                "{}[[drive.event]]\nwhen = \"above 9Hz\"\nsilent = \"1s\"\n",
                servo(&format!("node_guard = \"{reading}\""))
            ),
            async |session, target, permit| {
                let (acceleration, param) =
                    (target.family.param(1_556).unwrap().clone(), target.family.param(6_938).unwrap().clone());
                let mode = target.family.mode("velocity").unwrap().clone();
                let mut motor = Motor::new(session, target, permit, None);
                let ended = motor
                    .run(true, StopChoice::Ramp, async |motor: &mut Motor<'_, '_>| {
                        motor.change("watchdog", 300).await?;
                        motor.change_param(&acceleration, 2_000).await?;
                        motor.prepare(&mode);
                        motor.walk("operation-enabled").await?;
                        motor.enter().await?;
                        motor.make_it_count().await?;
                        motor.give(&param, 600, "1/min").await?;
                        motor.until_reached().await?;
                        motor.hold(Some(Span::from_secs(60)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
                    })
                    .await;
                let code = ended.result.unwrap_err().code;
                assert!(["forbidden.left_run", "forbidden.fault"].contains(&code.as_str()), "{reading}: {code}");
                let stop = ended.stop.unwrap();
                assert!(stop.acknowledged && stop.escalated.is_none(), "{reading}: {stop:?}");
                assert!(motor.changes.iter().all(|change| change.restored), "{reading}: {:?}", motor.changes);
                assert!(session.now() < Tick::ZERO + Span::from_secs(6), "{reading}: quickly, {:?}", session.now());
            },
            |bench| {
                let drive = bench.drive(1).unwrap();
                assert_eq!((drive.ram(5_644, 0), drive.ram(1_556, 0)), (Some(0), Some(3_000)), "{reading}");
                assert_eq!((bench.totals().turning, bench.totals().energised), (0, 0), "{reading}");
            },
        );
    }
}

#[test]
fn every_stop_leads_out_of_a_quick_stop_that_stays() {
    for slug in ["disable", "quick-stop", "disable-voltage"] {
        with_motor(
            "lxm05",
            &servo("quick_stop = \"stays\""),
            async |session, target, permit| {
                turn(session, target, permit).await;
                let control = target.family.param(6_914).unwrap().clone();
                let mut motor = Motor::new(session, target, permit, None);
                motor.set(&control, 2).await.unwrap();
                motor.command(slug).await.unwrap();
            },
            |bench| {
                let servo = bench.drive(1).unwrap().servo(Tick::ZERO).unwrap();
                assert_eq!((servo.state, bench.totals().energised), (0x40, 0), "{slug}");
                // Disable voltage goes out at once, into a quick stop too: the shaft coasts.
                assert!(bench.totals().turning == 0 || slug == "disable-voltage", "{slug}");
            },
        );
    }
}

#[test]
fn what_the_drive_adds_is_told_and_counted() {
    let asked = antrieb("-a 1 sollwert 25Hz --enable").on(SUM).answered("n").exits(8);
    for part in [
        "25.00 Hz (the drive runs at 35.00 Hz)",
        "35.00 Hz: 10.00 Hz internal setpoint are added (P.228, P.475 =",
        "--source line leaves it out",
    ] {
        assert!(asked.err.contains(part), "{part}: {}", asked.err);
    }
    let run = antrieb("-a 1 --yes sollwert 25Hz --enable --until reached --hold --duration 50ms").on(SUM);
    let run = run.json().exits(0);
    assert_eq!((run.data("/setpoint/value"), run.data("/setpoint/effective")), (&json!(25.0), &json!(35.0)));
    assert!(run.data("/setpoint/actual").as_f64().unwrap() > 34.8, "{}", run.value);
    let alone = antrieb("-a 1 --yes sollwert 25Hz --source line --enable --until reached --hold --duration 50ms");
    let alone = alone.on(SUM).json().exits(0);
    assert_eq!(alone.data("/setpoint/effective"), &json!(25.0));
    assert!(alone.data("/setpoint/actual").as_f64().unwrap() < 25.1, "{}", alone.value);
    let beyond = antrieb("-a 1 --yes sollwert 45Hz").on(SUM).json().exits(7);
    assert!(beyond.error()["message"].as_str().unwrap().contains("55.00 Hz"), "{}", beyond.error());
    let german = antrieb("-a 1 --lang de sollwert 25Hz --enable").on(SUM).answered("n").exits(8);
    assert!(german.err.contains("interner Sollwert kommen dazu"), "{}", german.err);
}

#[test]
fn enabling_tells_what_the_drive_runs_at_by_itself() {
    let asked = antrieb("-a 1 statemachine enable").on(SUM).answered("n").exits(8);
    assert!(asked.err.contains("it runs at 10.00 Hz by itself (P.228, P.434 = 3)"), "{}", asked.err);
    let least = SUM.replace("\"434\" = 3", "\"434\" = 2, \"418\" = 5");
    let asked = antrieb("-a 1 statemachine goto operation-enabled").on(&least).answered("n").exits(8);
    assert!(asked.err.contains("it runs at 5.00 Hz by itself (P.418, P.434 = 2)"), "{}", asked.err);
}

#[test]
fn contacts_tell_what_they_start() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 2, \"434\" = 3, \"228\" = 10, \"484\" = 25 }\n";
    let asked = antrieb("-a 1 statemachine contacts S1IND S2IND").on(bench).answered("n").exits(8);
    for part in ["P.484 stands at 25.00 Hz: it runs at that", "it runs at 10.00 Hz by itself"] {
        assert!(asked.err.contains(part), "{part}: {}", asked.err);
    }
    let opened = antrieb("-a 1 statemachine contacts").on(bench).answered("n").run();
    assert!(!opened.err.contains("runs at"), "{}", opened.err);
}

#[test]
fn numbers_that_no_telegram_holds_are_refused_before_anything_is_sent() {
    for (drive, words, exit) in [
        ("acu", "92233720368547758.07rpm", 7),
        ("acu", "92233720368547458.07rpm", 7),
        ("acu", "92233720368547758.07Hz", 7),
        ("lxm05", "9223372036854775807rpm", 7),
        ("lxm05", "2147483648rpm --force", 7),
        ("lxm05", "2/0", 2),
        ("lxm05", "2/4294967296", 7),
        ("lxm05", "0x-8000000000000000 --mode velocity", 2),
        ("lxm05", "0x+ --mode velocity", 2),
    ] {
        let bench = format!("[[drive]]\nmodel = \"{drive}\"\n");
        let bench = if drive == "acu" { SUM } else { &bench };
        let line = format!("-v -a 1 --drive {drive} --yes sollwert {words} --enable");
        let run = antrieb(&line).on(bench).json().exits(exit);
        let sent = run.err.lines().filter(|line| line.contains(" > "));
        // 06 and 65 write to an ACTIVE, 10 and 17 to an LXM05.
        let writes =
            sent.filter(|line| ["> 01 06", "> 01 65", "> 01 10", "> 01 17"].iter().any(|code| line.contains(code)));
        assert_eq!(writes.count(), 0, "{line}: {}", run.err);
    }
    for value in ["0x-8000000000000000", "0x+", "0x-1", "99999999999999999999"] {
        antrieb(&format!("-a 1 --drive acu --yes write 372={value}")).on(SUM).json().exits(7);
    }
}

/// 6.3.1: another mode is inadmissible while the shaft turns; and whoever turns it is not to be stopped by surprise.
#[test]
fn the_mode_of_a_shaft_that_somebody_else_turns_is_not_changed() {
    with_motor(
        "lxm05",
        &servo(""),
        async |session, target, permit| {
            turn(session, target, permit).await;
            let family = target.family.clone();
            let state = look(session, target).await.unwrap().state;
            for mode in ["position", "homing", "current", "speed", "gear", "jog"] {
                let mode = family.mode(mode).unwrap();
                let refused = may_change_mode(session, target, &state, mode).await.unwrap_err();
                assert_eq!((refused.code.as_str(), refused.class.exit()), ("forbidden.turning", 8), "{}", mode.slug);
            }
            let same = family.mode("velocity").unwrap();
            may_change_mode(session, target, &state, same).await.unwrap();
        },
        |bench| assert_eq!(bench.totals().turning, 1, "it is left alone"),
    );
}

/// LXM05 manual 5.5.4 prints codes; a technician types the speed.
#[test]
fn a_number_that_is_no_code_is_refused_before_the_drive_is_enabled() {
    let bench = servo("");
    for number in ["100", "3", "-1"] {
        let run = antrieb(&format!("-v -a 1 --yes sollwert {number} --mode jog --enable --hold --duration 50ms"));
        let run = run.on(&bench).json().exits(7);
        assert!(run.error()["hint"].as_str().unwrap().contains("JOGn_slow"), "{number}");
        assert!(!run.err.contains("> 01 10"), "{number}: {}", run.err);
        antrieb(&format!("-a 1 --drive lxm05 --dry-run sollwert {number} --mode jog")).json().exits(7);
    }
    antrieb("-a 1 --yes sollwert 5 --mode jog --enable --hold --duration 50ms").on(&bench).json().exits(0);
    antrieb("-a 1 --drive lxm05 --dry-run sollwert 2 --mode jog --force").json().exits(0);
}

#[test]
fn a_watchdog_beyond_what_the_drive_takes_is_refused_and_not_cut() {
    let run = "-a 1 --yes sollwert 300rpm --enable --hold --duration 50ms --watchdog";
    let refused = antrieb(&format!("{run} 20s")).on(&servo("")).json().exits(7);
    assert!(refused.error()["message"].as_str().unwrap().contains("at most 10.000 s"), "{:#}", refused.value);
    antrieb("-a 1 --drive lxm05 --dry-run sollwert 300rpm --watchdog 20s").json().exits(7);
    let most = antrieb(&format!("{run} 10s")).on(&servo("")).json().exits(0);
    assert_eq!(most.data("/changed/0/new"), &json!(10_000));
}

/// With P.434 = 2 an ACTIVE lifts what is less than P.418, and its bit 10 comes there.
#[test]
fn a_setpoint_that_the_drive_bends_to_its_limits_is_not_reached() {
    let bench = |set: &str| format!("[[drive]]\nmodel = \"acu\"\nset = {{ \"412\" = 1, {set} }}\n");
    for (setpoint, set, effective) in [
        ("1Hz", "\"434\" = 2, \"418\" = \"3.5\"", 3.5),
        ("-1Hz", "\"434\" = 2, \"418\" = \"3.5\"", -3.5),
        ("20Hz --force", "\"434\" = 2, \"418\" = 0, \"419\" = 10", 10.0),
    ] {
        let run = antrieb(&format!("-a 1 --yes sollwert {setpoint} --enable --until reached --hold --duration 50ms"));
        let run = run.on(&bench(set)).json().exits(1);
        assert_eq!(run.error()["code"], "no.not_reached", "{setpoint}");
        assert_eq!(
            (run.data("/setpoint/reached"), run.data("/setpoint/effective")),
            (&json!(false), &json!(effective))
        );
    }
    let asked =
        antrieb("-a 1 sollwert 1Hz --enable").on(&bench("\"434\" = 2, \"418\" = \"3.5\"")).answered("n").exits(8);
    assert!(asked.err.contains("the drive runs at 3.50 Hz"), "{}", asked.err);
    let reached = antrieb("-a 1 --yes sollwert 5Hz --enable --until reached --hold --duration 50ms");
    let reached = reached.on(&bench("\"434\" = 2, \"418\" = \"3.5\"")).json().exits(0);
    assert_eq!(reached.data("/setpoint/reached"), &json!(true));
}
