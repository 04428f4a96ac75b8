//! What its own settings make of a setpoint: what is told of that, what may differ a little, and what a zero does beside it.

use super::rig::{READY, RUNNING, drive};
use crate::run::antrieb;
use serde_json::json;

/// Only the sum with a setpoint of the other sign turns the shaft the other way.
#[test]
fn a_zero_that_nothing_of_the_other_sign_stands_beside_is_written_without_a_question() {
    for (source, internal, line, asks) in
        [(2, -10, 20, false), (3, 0, 20, false), (3, 10, 0, false), (3, 10, 20, false), (3, -10, 20, true)]
    {
        let set = RUNNING.replace("\"434\" = 2, \"484\" = 10", &format!("\"434\" = {source}, \"484\" = {line}"));
        let bench = drive(&format!("{set}, \"228\" = {internal}"), "");
        let run = antrieb("-b 115200 -a 1 --drive acu write 484=0Hz").on(&bench).run();
        assert_eq!(run.exit, if asks { 8 } else { 0 }, "{source} {internal} {line}: {}", run.err);
    }
}

/// A limit that is the same in all data sets counts in the one that is selected; a least frequency lifts 0 as well, clockwise.
#[test]
fn what_a_drive_runs_at_behind_a_write_is_bent_by_what_counts_in_every_data_set() {
    let set = |more: &str| format!("\"412\" = 1, \"414\" = 1, \"434\" = 2, \"228\" = 0, \"410\" = 0, {more}");
    for (more, verb, runs_at) in [
        ("\"484\" = 10, \"418\" = 0, \"419\" = 5", "dataset select 3 --ram", "5.00 Hz"),
        ("\"484\" = 0, \"418\" = 7, \"419\" = 50", "write 419@ram=40Hz", "7.00 Hz"),
        ("\"484\" = 10, \"418\" = 7, \"419\" = 50", "write 484=-1Hz", "-7.00 Hz"),
    ] {
        let run = antrieb(&format!("-b 115200 -a 1 {verb}")).on(&drive(&set(more), "")).answered("n").exits(8);
        assert!(run.err.contains(&format!("it runs at {runs_at} when it is enabled")), "{verb}: {}", run.err);
    }
}

/// It refuses to tell what it works with. That is said, and what is told at no time has not changed.
#[test]
fn settings_that_a_drive_does_not_tell_are_named_and_end_no_run() {
    let run = |readings: &str| {
        antrieb("-b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 3s").on(&drive(READY, readings)).exits(0)
    };
    let untold = "the drive does not tell P.434, P.419: what it makes of the setpoint may be another one";
    assert!(run("readings = { ram_reads = \"refused\" }").err.contains(untold));
    assert!(!run("").err.contains("does not tell"));
}

/// A source of its own may be an analog one: half a hertz, or a 20th, is no other setpoint.
#[test]
fn an_internal_setpoint_that_wavers_ends_no_run_and_one_that_changes_does() {
    let line = "-v -b 115200 -a 1 --yes sollwert 5Hz --enable --hold --duration 4s";
    for (internal, then, ends) in
        [(10.0, 10.5, false), (10.0, 9.5, false), (10.0, 10.51, true), (40.0, 42.0, false), (40.0, 42.01, true)]
    {
        let set = READY.replace("\"434\" = 2", &format!("\"434\" = 3, \"419\" = 90, \"228\" = {internal}"));
        let event = format!("[[drive.event]]\nat = \"1500ms\"\nset = {{ \"228\" = {then} }}");
        let run = antrieb(line).on(&drive(&set, &event)).json();
        let code = run.value.pointer("/error/code").cloned().unwrap_or_default();
        let expected = if ends { json!("forbidden.otherwise") } else { json!(null) };
        assert_eq!(code, expected, "{internal} {then}: {:#} {}", run.value, run.err);
    }
}

/// Its limit is lowered on the way up, so that the ramp ends below its goal: that is seen within seconds, not at the end.
#[test]
fn a_ramp_that_stays_below_its_goal_ends_the_run() {
    let ramps = "ramps = { up_right = 5, down_right = 50 }\n[[drive.event]]\nat = \"1500ms\"\nset = { \"419\" = 8 }";
    let run = antrieb("-v -b 115200 -a 1 --yes sollwert 20Hz --enable --hold --duration 20s").on(&drive(READY, ramps));
    let run = run.json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.otherwise", "{:#}", run.value);
    let stop = run.err.lines().find(|line| line.contains("> 01 06 01 9A 00 07")).unwrap();
    let at: f64 = stop.split_whitespace().next().unwrap().parse().unwrap();
    // It is there after 1.6 s, and looked at every second.
    assert!(at < 5_000.0, "{stop}");
}

/// What a run will set is part of the question; what stands there already is not.
#[test]
fn a_setting_that_changes_nothing_is_no_part_of_the_question() {
    let bench = super::rig::servo("RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000", "");
    for (raw, changes) in [(700, true), (3_000, false)] {
        let line = format!("-a 1 --drive lxm05 sollwert 300rpm --set RAMPdecel={raw} --enable --hold --duration 1s");
        let run = antrieb(&line).on(&bench).answered("n").exits(8);
        let is_told = run.err.lines().any(|line| line.contains("RAMPdecel") && line.contains("3000"));
        assert_eq!(is_told, changes, "{raw}: {}", run.err);
    }
}
