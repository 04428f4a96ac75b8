//! Control that is taken from others while the drive runs: what becomes of the shaft is told before, done without a break where
//! the control word counts for nothing yet, and told afterwards; and what a run sets besides is named before.

use super::rig::{READY, drive, held};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::tick::Span;
use serde_json::json;

const TAKE: &str = "01 06 01 9A 00 0F";

/// Runs at 20 Hz by its contacts, or by virtual ones.
fn running(mode: u8, word: u8) -> String {
    let set = format!("\"412\" = {mode}, \"410\" = {word}, \"434\" = 2, \"484\" = 20, \"418\" = 0");
    drive(&set, "readings = { other_modes = \"contacts\" }\nramps = { up_right = 500, down_right = 20 }")
}

const HELD: &str = "-v -b 115200 -a 1 --yes sollwert 15Hz --enable --hold --duration 1s --take-control";

#[test]
fn control_over_a_drive_that_runs_is_taken_without_taking_its_power() {
    for mode in [0, 44] {
        for line in [HELD, "-v -b 115200 -a 1 --yes statemachine enable --hold --duration 1s --take-control"] {
            let run = antrieb(line).on(&running(mode, 0)).json().exits(9);
            assert_eq!(run.data("/steps"), &json!([]), "{mode} {line}: it was enabled anew: {:#}", run.value);
            assert!(run.err.contains("no manual says that it does"), "{}", run.err);
            let taken = format!("control was taken while it ran (P.412: {mode} -> 1), and it kept its power");
            assert!(run.data("/notes").to_string().contains(&taken), "{:#}", run.value);
            // Its setpoint does not dip on the way.
            let zeros = |run: &str| run.matches("01 65 01 E4 00 00 00 00").count();
            let before = run.err.split("> 01 65 01 E4 00 00 05 DC").next().unwrap();
            assert!(line != HELD || zeros(before) == 0, "{}", run.err);
        }
    }
}

#[test]
fn where_the_control_word_counts_already_it_is_told_that_taking_control_may_stop_the_shaft() {
    let run = antrieb(HELD).on(&running(2, 3)).json();
    assert!(run.err.contains("means something else then, which may take its power"), "{}", run.err);
    assert!(
        run.data("/notes").to_string().contains("control was taken while it ran (P.412: 2 -> 1), which"),
        "{:#}",
        run.value
    );
    // A drive at rest is told nothing of that.
    let idle = antrieb(HELD).on(&drive(&READY.replace("\"412\" = 1", "\"412\" = 44"), "")).json().exits(0);
    assert!(!idle.err.contains("somebody else runs it"), "{}", idle.err);
}

#[test]
fn a_drive_that_keeps_its_control_runs_on_and_is_not_called_stopped() {
    let bench = format!("{}[[drive.event]]\nat = \"0s\"\nrefuses = 24988\n", running(0, 0));
    let run = antrieb(HELD).on(&bench).json().exits(6);
    assert_eq!(run.data("/stop"), &json!(null), "{:#}", run.value);
    // No word stands there that would start it for the next one who takes control.
    let words: Vec<_> = run.err.lines().filter_map(|line| line.split_once("> 01 06 01 9A ")).collect();
    assert!(words.last().unwrap().1.starts_with("00 00"), "{words:?}");
}

/// A word that it refuses counts for nothing: it runs as before, and there is nothing to stop.
#[test]
fn a_drive_that_refuses_the_word_before_its_control_runs_on_and_is_not_called_stopped() {
    let bench = format!("{}[[drive.event]]\nat = \"0s\"\nrefuses = 410\n", running(0, 0));
    let run = antrieb(HELD).on(&bench).json().exits(6);
    assert_eq!(run.data("/stop"), &json!(null), "{:#}", run.value);
    assert_eq!(run.data("/running"), &json!(true), "{:#}", run.value);
    assert!(!run.err.contains("> 01 06 61 9C"), "{}", run.err);
}

/// Whoever interrupts between the word and the control gets a drive that runs as before, or one that is stopped.
#[test]
fn an_interrupt_on_the_way_leaves_no_word_behind_and_stops_what_was_taken() {
    for (presses, stops) in [(&[TAKE][..], false), (&["01 06 61 9C 00 01"][..], true), (&[TAKE, "+1"][..], false)] {
        let came =
            held(&running(0, 0), presses, StopChoice::Ramp, Span::from_secs(60), async |motor: &mut Motor<'_, '_>| {
                motor.take_control(1, Some(15)).await?;
                motor.walk("operation-enabled").await?;
                motor.hold(Some(Span::from_secs(1)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
            });
        let told = format!("{presses:?} {:?} {:?}", came.ended, came.sent);
        assert!(came.ended.result.is_err(), "{told}");
        let word = came.sent.iter().rev().find(|hex| hex.starts_with("01 06 01 9A")).unwrap();
        assert!(word.starts_with("01 06 01 9A 00 00"), "{told}");
        assert_eq!(came.ended.stop.as_ref().map(|stop| stop.acknowledged), stops.then_some(true), "{told}");
    }
}

#[test]
fn a_reset_gives_back_the_control_that_it_took_unless_that_could_start_the_shaft() {
    let line = "-b 115200 -a 1 --yes statemachine reset --take-control --watchdog 2s";
    let fault = "[[drive.event]]\nat = \"0s\"\nfault = \"F0702\"\n";
    let open = "[[drive.event]]\nat = \"0s\"\nstart_right = false\n";
    for mode in [0, 44] {
        let set = READY.replace("\"412\" = 1", &format!("\"412\" = {mode}"));
        let readings = "readings = { other_modes = \"contacts\" }";
        // The first look comes behind the reaction to the fault.
        let bench = |events: &str| drive(&set, &format!("{readings}\n{events}")).replace("\"1ms\"", "\"50ms\"");
        let back = antrieb(line).on(&bench(&format!("{open}{fault}"))).json().exits(0);
        let restored = |run: &crate::run::Document| {
            let changed = run.data("/changed").as_array().unwrap().clone();
            changed.iter().map(|row| (row["param"].clone(), row["restored"].clone())).collect::<Vec<_>>()
        };
        assert_eq!(restored(&back), [(json!(413), json!(true)), (json!(412), json!(true))], "{mode} {:#}", back.value);
        // A contact that stands closed did not start it only because of its fault.
        let kept = antrieb(line).on(&bench(fault)).json().exits(9);
        assert_eq!(restored(&kept), [(json!(413), json!(true)), (json!(412), json!(false))], "{mode} {:#}", kept.value);
        assert_eq!(kept.error()["code"], "partial.not_given_back");
        assert!(kept.data("/notes").to_string().contains("P.412 stays 1"), "{:#}", kept.value);
        assert_eq!(kept.data("/running"), &json!(false));
    }
}

#[test]
fn what_a_run_sets_besides_is_named_before_somebody_agrees() {
    let bench = drive("\"412\" = 44, \"434\" = 3, \"413\" = 0, \"418\" = 0", "");
    let line = "-b 115200 -a 1 sollwert 10Hz --enable --take-control --source line --watchdog 2s";
    let rows = |then: &str| {
        [
            format!("P.413@0ram: 0 s -> 2 s, {then}"),
            format!(
                "P.412@1ram: 44 -> 1, {then}{}",
                if then.ends_with("end") { " where that starts nothing" } else { "" }
            ),
            format!("P.434@1ram: 3 -> 2, {then}"),
        ]
    };
    for (more, then) in [
        ("--hold", "in RAM, given back at the end"),
        ("", "in RAM, and stays so"),
        ("--hold --on-exit keep", "in RAM, and stays so"),
    ] {
        let asked = antrieb(&format!("{line} {more}")).on(&bench).answered("n").exits(8);
        for row in rows(then) {
            assert!(asked.err.contains(&row), "{row}: {}", asked.err);
        }
    }
    // What is so already is not named, and what is named is what was done.
    let run = antrieb(&format!("{line} --hold --duration 1s --yes")).on(&bench).json().exits(0);
    let changed: Vec<_> = run.data("/changed").as_array().unwrap().iter().map(|row| row["name"].clone()).collect();
    assert_eq!(changed, [json!("P.413@0ram"), json!("P.412@1ram"), json!("P.434@1ram")], "{:#}", run.value);
    let same =
        antrieb("-b 115200 -a 1 sollwert 10Hz --enable --take-control").on(&drive(READY, "")).answered("n").exits(8);
    assert!(!same.err.contains("P.412@"), "{}", same.err);
    let servo = "[[drive]]\nmodel = \"lxm05\"\n";
    let asked = antrieb("-a 1 sollwert 100rpm --set RAMPacc=2000 --enable --hold --watchdog 2s")
        .on(servo)
        .answered("n")
        .exits(8);
    assert!(asked.err.contains("RAMPacc (1556): 600 1/min*s -> 2000 1/min*s, given back at the end"), "{}", asked.err);
    let contacts =
        antrieb("-b 115200 -a 1 statemachine contacts S1IND --take-control").on(&bench).answered("n").exits(8);
    assert!(contacts.err.contains("P.412@1ram: 44 -> 2, in RAM, and stays so"), "{}", contacts.err);
}

/// What a run has set in RAM is gone behind a power failure, and that is the sign of it.
#[test]
fn a_drive_that_restarts_in_a_run_is_told_as_one_that_did() {
    let line = "-b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 9s --source line";
    let set = "\"412\" = 1, \"434\" = 3, \"418\" = 0";
    let restarts = "[[drive.event]]\nat = \"2s\"\npower_cycle = true\n";
    let told = |run: &crate::run::Document| run.data("/notes").to_string().contains("P.434@1ram is 3 again");
    // Also where its stop is acknowledged, because it has no power any more.
    for exit in ["ramp", "quick-stop", "coast"] {
        let run = antrieb(&format!("{line} --on-exit {exit}")).on(&drive(set, restarts)).json();
        assert!(run.exit != 0 && told(&run), "{exit}: {:#} {}", run.value, run.err);
        assert_eq!(run.data("/stop/acknowledged"), exit == "coast", "{exit}: {:#}", run.value);
    }
    // A trip leaves the RAM as it is.
    let trip = antrieb(line).on(&drive(set, "[[drive.event]]\nat = \"2s\"\nfault = \"F0500\"\n")).json();
    assert!(trip.exit != 0 && !told(&trip), "{:#} {}", trip.value, trip.err);
}

/// What a percentage does is up to the controller behind it (CM-485 manual 9.2.2): it is asked about, and that it stops nothing is told.
#[test]
fn a_zero_that_stops_nothing_says_so() {
    for (line, bench) in
        [("-a 1 sollwert 0%", "[[drive]]\nmodel = \"act\"\n"), ("-a 1 sollwert 0A", "[[drive]]\nmodel = \"lxm05\"\n")]
    {
        let run = antrieb(line).on(bench).run();
        assert_eq!(run.exit, 8, "{}", run.err);
        assert!(run.err.contains("a setpoint of 0 does not bring the shaft to rest in this mode"), "{}", run.err);
        assert!(run.err.contains("statemachine quick-stop` does"), "{}", run.err);
    }
    let turns = antrieb("-a 1 sollwert 5%").on("[[drive]]\nmodel = \"act\"\n").run();
    assert!(!turns.err.contains("to rest in this mode"), "{}", turns.err);
}
