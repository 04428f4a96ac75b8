//! `monitor --gather stdin` with somebody behind stdin who takes his time.

use crate::program::{AtTerminal, Piped, alone};

const GATHER: &str = "-p sim -a 1 monitor 210 --gather stdin --json";

#[track_caller]
fn ends(mut program: Piped, because: &str, rounds: u64) {
    assert_eq!(program.ends(), Some(0), "{}", program.said());
    let summary = &program.records.last().unwrap()["summary"];
    assert_eq!((summary["because"].as_str(), summary["rounds"].as_u64()), (Some(because), Some(rounds)), "{summary}");
}

#[test]
fn a_round_comes_with_its_line_and_the_end_of_stdin_ends_it() {
    let _alone = alone();
    let mut program = Piped::called(GATHER);
    for n in 0..3 {
        program.call();
        program.until("the next sample", |record| record["n"] == n);
    }
    program.leave();
    ends(program, "input", 3);
}

#[test]
fn who_waits_for_a_line_hears_a_signal_at_once() {
    let _alone = alone();
    for signal in ["-INT", "-TERM"] {
        let mut program = Piped::called(GATHER);
        program.call();
        program.until("the first sample", |record| record["n"] == 0);
        program.signal(signal);
        ends(program, "interrupted", 1);
    }
}

#[test]
fn the_time_is_over_without_a_line_too() {
    let _alone = alone();
    ends(Piped::called(&format!("{GATHER} --duration 200ms")), "duration", 0);
}

#[test]
fn enter_takes_a_sample_by_hand() {
    let _alone = alone();
    let mut run = AtTerminal::whole("-p sim -a 1 monitor 210 --gather stdin");
    run.shows("Enter takes a sample, Ctrl-D ends");
    run.types("\n");
    run.shows("0.000     1         0.00");
    run.types("\u{4}");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    run.shows("1 sample in 1 round");
}
