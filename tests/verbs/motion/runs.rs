//! Motion in process: transitions, interlocks with their reasons, setpoints, bounded runs, what is given back.

use crate::agreeable::permit;
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice, look};
use antrieb::drive::{Interrupt, Opening, Session, Target};
use antrieb::gate::{Motion, Permit};
use antrieb::outcome::Event;
use antrieb::profile::Registry;
use antrieb::transport::Port;
use serde_json::json;

/// A drive that obeys the control word, with everything that it needs to run.
const READY: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 2 }\n";

fn bench(model: &str, rest: &str) -> String {
    format!("[[drive]]\nmodel = \"{model}\"\n{rest}\n")
}

#[test]
fn without_a_terminal_nothing_moves_and_nothing_is_written() {
    for verb in ["statemachine enable", "sollwert 25Hz", "sollwert 5Hz --jog 1s"] {
        let run = antrieb(&format!("-v -a 1 {verb}")).on(READY).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.no_terminal", "{verb}");
        assert!(run.err.contains("MOTION: the shaft may turn"), "what the question would have been: {}", run.err);
        let writes = ["> 01 06", "> 01 10", "> 01 65"];
        assert!(!writes.iter().any(|write| run.err.contains(write)), "not one write: {}", run.err);
    }
}

#[test]
fn what_forbids_a_run_anyway_comes_before_the_question_of_a_terminal() {
    let ignored = bench("act", "set = { \"412\" = 1, \"434\" = 1 }");
    let run = antrieb("-a 1 sollwert 25Hz").on(&ignored).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.ramp_setpoint");
    for yes in ["", "--yes"] {
        let reset = antrieb(&format!("-a 1 {yes} statemachine reset")).on(READY).json().exits(8);
        assert_eq!(reset.error()["code"], "forbidden.no_fault");
        assert!(!reset.err.contains("MOTION"), "{}", reset.err);
    }
}

#[test]
fn the_question_of_a_run_says_that_it_goes_on_and_that_nothing_would_stop_it() {
    let keeps = "the drive KEEPS RUNNING when this program ends";
    let off = "the drive's watchdog (P.413) is off: if the line breaks, nothing stops it; --watchdog 2s sets it";
    for (verb, words) in [
        ("statemachine enable", &[keeps, off][..]),
        ("sollwert 25Hz --enable", &[keeps, off]),
        ("sollwert 25Hz --enable --hold", &[off, "it is stopped when this program ends (ramp)"]),
        (
            "sollwert 25Hz --enable --watchdog 2s",
            &["the drive runs on when this program ends, until its watchdog stops it"],
        ),
    ] {
        let run = antrieb(&format!("-a 1 {verb}")).on(READY).answered("n").exits(8);
        for text in [keeps, off] {
            assert_eq!(run.err.contains(text), words.contains(&text), "{verb}: {text}\n{}", run.err);
        }
        assert!(words.iter().all(|text| run.err.contains(text)), "{verb}: {}", run.err);
    }
    let german = antrieb("--lang de -a 1 statemachine enable").on(READY).answered("n").exits(8);
    assert!(german.err.contains("der Antrieb LÄUFT WEITER, wenn dieses Programm endet"), "{}", german.err);
}

#[test]
fn the_end_of_a_run_is_told_on_stderr_where_nobody_reads_stdout_any_more() {
    for (line, format, told) in [
        ("sollwert 25Hz --enable --hold --duration 1s", "json", "note: ramp: the stop was acknowledged"),
        ("sollwert 25Hz --enable --hold --duration 1s", "table", "note: ramp: the stop was acknowledged"),
        ("statemachine enable", "json", "note: the drive keeps running"),
    ] {
        let cut = antrieb(&format!("-a 1 --yes {line} --format {format}")).on(READY).into_pipe_of(5).exits(0);
        assert!(cut.err.contains(told), "{line} {format}: {}", cut.err);
    }
}

#[test]
fn a_held_run_says_that_it_runs_and_what_an_interrupt_does() {
    let held = antrieb("-a 1 --yes sollwert 25Hz --enable --hold --duration 1s").on(READY).exits(0);
    assert_eq!(held.err.matches("note: running; Ctrl-C stops: ramp").count(), 1, "{}", held.err);
    let enabled = antrieb("--lang de -a 1 --yes statemachine enable --hold --duration 1s --on-exit quick-stop");
    let enabled = enabled.on(READY).exits(0);
    assert!(enabled.err.contains(": läuft; Strg-C hält an: quick-stop"), "{}", enabled.err);
    let quiet = antrieb("-q -a 1 --yes sollwert 25Hz --enable --hold --duration 1s").on(READY).exits(0);
    assert!(!quiet.err.contains("Ctrl-C"), "{}", quiet.err);
    let once = antrieb("-a 1 --yes sollwert 25Hz --enable").on(READY).exits(0);
    assert!(!once.err.contains("Ctrl-C"), "{}", once.err);
}

#[test]
fn the_way_to_operation_and_back_is_walked_and_proven() {
    for (model, short) in [("act", "4"), ("acu", "4'")] {
        let ready = bench(model, "set = { \"412\" = 1 }");
        let enabled = antrieb("-a 1 --yes statemachine enable").on(&ready).json().exits(0);
        assert_eq!(enabled.data("/steps/0/transition"), short);
        assert_eq!(enabled.data("/to/slug"), "operation-enabled");
        assert_eq!(enabled.data("/running"), &json!(true));
        let run = antrieb("-a 1 --yes statemachine goto switched-on").on(&ready).json().exits(0);
        let numbers: Vec<_> =
            run.data("/steps").as_array().unwrap().iter().map(|step| step["transition"].clone()).collect();
        assert_eq!(numbers, ["2", "3"]);
        let held = antrieb("-a 1 --yes statemachine enable --hold --duration 100ms --on-exit quick-stop");
        let held = held.on(&ready).json().exits(0);
        assert_eq!((held.data("/running"), held.data("/stop/acknowledged")), (&json!(false), &json!(true)));
        assert_eq!(held.data("/to/slug"), "switch-on-disabled");
    }
}

#[test]
fn what_is_missing_is_said_instead_of_timing_out() {
    for (rest, code, says) in [
        ("set = { \"412\" = 0 }", "forbidden.control_mode", "P.412 is 0"),
        ("set = { \"412\" = 1 }\nenable = false", "forbidden.interlock", "external enable"),
        ("set = { \"412\" = 1 }\nstart_right = false", "forbidden.interlock", "start contact"),
        ("set = { \"412\" = 1 }\nmains = false", "forbidden.interlock", "mains voltage"),
    ] {
        let run = antrieb("-a 1 --drive acu --yes statemachine enable").on(&bench("acu", rest)).json().exits(8);
        let error = run.error().clone();
        assert_eq!(error["code"], code, "{rest}");
        let told = format!("{} {}", error["message"], error["hint"]);
        assert!(told.contains(says), "{rest}: {told}");
        let shown = antrieb("-a 1 --drive acu statemachine").on(&bench("acu", rest)).json();
        assert!(!shown.data("/drives/0/missing").as_array().unwrap().is_empty(), "{rest}");
    }
}

#[test]
fn a_fault_is_reset_once_behind_its_lock() {
    let tripped = bench("act", "set = { \"412\" = 1 }\n[[drive.event]]\nat = \"1ms\"\nfault = \"F0500\"");
    let refused = antrieb("-a 1 --yes statemachine enable").on(&tripped).json().exits(8);
    assert_eq!(refused.error()["code"], "forbidden.fault", "enabling resets no fault by the way");
    for line in
        ["statemachine enable", "statemachine goto operation-enabled", "sollwert 5Hz --enable --hold --duration 1s"]
    {
        let refused = antrieb(&format!("-a 1 {line} -v")).on(&tripped).answered("y").exits(8);
        assert!(refused.err.contains("in a fault") && refused.err.contains("F0500"), "{}", refused.err);
        assert!(refused.err.contains("-a 1 statemachine reset` acknowledges it"), "{}", refused.err);
        assert!(!refused.err.contains("MOTION") && !refused.sent().iter().any(|sent| sent.starts_with("01 06")));
    }
    let reset = antrieb("-a 1 --yes statemachine reset").on(&tripped).json().exits(0);
    assert_eq!(reset.data("/from/slug"), "fault");
    assert_eq!(reset.data("/to/slug"), "switch-on-disabled");
    assert!(reset.data("/steps/0/took_ms").as_u64().unwrap() >= 15_000);
    let healthy = antrieb("-a 1 --yes statemachine reset").on(READY).json().exits(8);
    assert_eq!(healthy.error()["code"], "forbidden.no_fault");
}

#[test]
fn a_reset_is_one_rising_edge_that_does_not_stand() {
    let tripped = bench("act", "set = { \"412\" = 1 }\n[[drive.event]]\nat = \"1ms\"\nfault = \"F0500\"");
    let reset = antrieb("-v -a 1 --yes statemachine reset").on(&tripped).json().exits(0);
    let words: Vec<_> = reset.err.lines().filter_map(|line| line.split_once("> 01 06 01 9A ")?.1.get(..5)).collect();
    assert_eq!(words, ["00 00", "00 80", "00 00"], "{}", reset.err);
}

#[test]
fn setpoints_are_checked_before_they_are_given() {
    let internal = bench("acu", "set = { \"412\" = 1, \"434\" = 1 }");
    let ignored = antrieb("-a 1 --yes sollwert 25Hz").on(&internal).json().exits(8);
    assert_eq!(ignored.error()["code"], "forbidden.ramp_setpoint");
    let taken = antrieb("-a 1 --yes sollwert 25Hz --source line --enable --until reached --hold --duration 50ms");
    let taken = taken.on(&internal).json().exits(0);
    assert_eq!(taken.data("/setpoint/reached"), &json!(true));
    assert_eq!(taken.data("/changed/0/restored"), &json!(true));
    let beyond = antrieb("-a 1 --yes sollwert 60Hz").on(READY).json().exits(7);
    assert!(beyond.error()["message"].as_str().unwrap().contains("P.419"), "{}", beyond.error());
    antrieb("-a 1 --yes sollwert 25").on(READY).json().exits(2);
    let speed = antrieb("-a 1 --yes sollwert 1500rpm").on(READY).json().exits(0);
    assert_eq!(speed.data("/setpoint/value"), &json!(50.0));
    let percent = antrieb("-a 1 --yes sollwert -30%").on(READY).json().exits(0);
    assert_eq!((percent.data("/setpoint/param"), percent.data("/setpoint/value")), (&json!(524), &json!(-30.0)));
}

#[test]
fn ramps_and_profiles_lead_the_setpoint() {
    let ramp =
        antrieb("-a 1 --yes sollwert --ramp 5Hz:10Hz:1s --enable --hold --duration 10ms").on(READY).json().exits(0);
    assert_eq!(ramp.data("/setpoint/value"), &json!(10.0));
    assert!(ramp.data("/setpoint/writes").as_u64().unwrap() >= 4);
    let profile = antrieb("-a 1 --yes sollwert --profile {dir}/p.csv --enable --hold --duration 10ms");
    let profile = profile.file("p.csv", "# time, setpoint\n0s, 5Hz\n500ms, 8Hz\n").on(READY).json().exits(0);
    assert_eq!(profile.data("/setpoint/value"), &json!(8.0));
    let broken = antrieb("-a 1 --yes sollwert --profile {dir}/p.csv").file("p.csv", "0s, 5Hz\n0s, 8Hz\n").on(READY);
    let broken = broken.json().exits(7);
    assert!(broken.error()["message"].as_str().unwrap().contains("p.csv:2: times must rise"));
}

#[test]
fn control_goes_back_only_where_that_does_not_start_the_drive() {
    let run = "-a 1 --yes sollwert 5Hz --take-control --enable --hold --duration 500ms";
    let virtual_contacts = bench("act", "set = { \"412\" = 2, \"434\" = 2 }");
    let given = antrieb(run).on(&virtual_contacts).json().exits(0);
    assert_eq!((given.data("/changed/0/restored"), given.data("/running")), (&json!(true), &json!(false)));
    let closed = bench("act", "start_right = true\nset = { \"412\" = 0, \"434\" = 2 }");
    // What was left out is never 0.
    let kept = antrieb(run).on(&closed).json().exits(9);
    assert_eq!(kept.error()["code"], "partial.not_given_back");
    assert_eq!((kept.data("/changed/0/restored"), kept.data("/running")), (&json!(false), &json!(false)));
}

#[test]
fn contacts_are_named_and_opened_at_the_end() {
    let contacts = bench("act", "set = { \"412\" = 2 }");
    let run =
        antrieb("-a 1 --yes statemachine contacts S1IND S2IND --hold --duration 300ms").on(&contacts).json().exits(0);
    assert_eq!((run.data("/running"), run.data("/stop/acknowledged")), (&json!(false), &json!(true)));
    antrieb("-a 1 --yes statemachine contacts S9IND").on(&contacts).json().exits(2);
    let other = antrieb("-a 1 --yes statemachine contacts S1IND").on(READY).json().exits(8);
    assert_eq!(other.error()["code"], "forbidden.control_mode");
}

#[test]
fn the_question_names_drive_state_and_what_will_happen() {
    let asked = antrieb("-a 1 statemachine enable").on(READY).answered("n").exits(8);
    for part in ["Enable operation", "drive 1 (acu)", "Switch-on disabled", "MOTION"] {
        assert!(asked.err.contains(part), "{part}: {}", asked.err);
    }
}

/// Runs `work` on the drive at address 1 of a bench, in virtual time, and hands out the bench afterwards.
pub(crate) fn with_motor(
    drive: &str,
    drives: &str,
    work: impl AsyncFnOnce(&mut Session<'_>, &mut Target, &Permit<Motion>),
    after: impl FnOnce(&mut antrieb::simulator::Bench),
) {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, drives).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let port = Port::Sim(Some(file));
    let mut observe = |_: Event| {};
    let opening = Opening::at(&port);
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let opened = Session::open(opening, &registry, Interrupt::default(), &mut observe);
    let mut session = runtime.block_on(opened).unwrap();
    let mut target = Target::new(1, registry.family(drive).unwrap());
    runtime.block_on(work(&mut session, &mut target, &permit()));
    after(session.bench().unwrap());
}

#[test]
fn motion_wears_no_eeprom_and_the_judge_has_no_remark() {
    with_motor(
        "acu",
        READY,
        async |session, target, permit| {
            let setpoint = target.family.role("setpoint-frequency").unwrap().clone();
            for _ in 0..5 {
                let mut motor = Motor::new(session, target, permit, None);
                let ended = motor
                    .run(true, StopChoice::QuickStop, async |motor: &mut Motor<'_, '_>| {
                        motor.change("watchdog", 2).await?;
                        motor.walk("operation-enabled").await?;
                        motor.give(&setpoint, 2_000, "Hz").await?;
                        motor.until_reached().await
                    })
                    .await;
                ended.result.unwrap();
                assert!(ended.stop.unwrap().acknowledged);
                let watchdog = look(session, target).await.unwrap().watchdog_s.unwrap();
                assert_eq!(watchdog.raw, 0);
            }
        },
        |bench| {
            assert_eq!(bench.drive(1).unwrap().eeprom_writes(), 0);
            assert_eq!(bench.totals().turning, 0);
            assert_eq!(bench.remarks(), []);
        },
    );
}

#[test]
fn a_panic_in_the_work_stops_the_shaft_too() {
    with_motor(
        "acu",
        READY,
        async |session, target, permit| {
            let setpoint = target.family.role("setpoint-frequency").unwrap().clone();
            let mut motor = Motor::new(session, target, permit, None);
            let ended = motor
                .run(false, StopChoice::QuickStop, async |motor: &mut Motor<'_, '_>| {
                    motor.walk("operation-enabled").await?;
                    motor.give(&setpoint, 2_000, "Hz").await?;
                    motor.until_reached().await?;
                    if motor.steps.len() < 100 {
                        panic!("a bug of ours");
                    }
                    Ok(())
                })
                .await;
            assert_eq!(ended.result.unwrap_err().code, "bug.panic");
            assert!(ended.stop.unwrap().acknowledged);
        },
        |bench| assert_eq!(bench.totals().turning, 0),
    );
}

#[test]
fn a_dead_line_is_reported_and_the_watchdog_named() {
    let dies = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 2, \"413\" = 1 }\n[[drive.event]]\nwhen = \"above 5Hz\"\nsilent = \"600s\"\n";
    with_motor(
        "acu",
        dies,
        async |session, target, permit| {
            let setpoint = target.family.role("setpoint-frequency").unwrap().clone();
            look(session, target).await.unwrap();
            let mut motor = Motor::new(session, target, permit, None);
            let ended = motor
                .run(true, StopChoice::QuickStop, async |motor: &mut Motor<'_, '_>| {
                    motor.walk("operation-enabled").await?;
                    motor.give(&setpoint, 2_000, "Hz").await?;
                    motor.until_reached().await
                })
                .await;
            let stop = ended.stop.unwrap();
            assert!(!stop.acknowledged);
            assert!(stop.note.unwrap().en.contains("is 1 s: it trips"), "the watchdog is named");
        },
        |bench| assert_eq!(bench.totals().energised, 0, "the drive's own watchdog stopped it"),
    );
}
