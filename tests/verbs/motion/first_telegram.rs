//! A stop that is the first telegram of all: its answer has the bytes of an echo, and a drive may be slow.

use crate::run::{Output, antrieb};

/// A drive that runs from the first moment on, with what else is said of it and of its line.
fn bench(model: &str, (drive, hold): (&str, &str), line: &str) -> String {
    let set = format!("\"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 20, \"418\" = 0, \"638\" = \"{hold}\"");
    format!("[[drive]]\nmodel = \"{model}\"\nbaud = 19200\n{drive}\nset = {{ {set} }}\n{line}")
}

/// How often P.410 was written.
fn words(run: &Output) -> usize {
    run.err.lines().filter(|line| line.contains(" ms > ") && line.contains(": write P.410@0 = ")).count()
}

#[test]
fn a_stop_of_a_drive_that_is_named_is_believed_before_the_standstill_is_over() {
    let mut sins = Vec::new();
    for (protocol, model, echo) in ["rtu", "ascii"].into_iter().flat_map(|protocol| {
        ["acu", "act"]
            .into_iter()
            .flat_map(move |model| ["", "[line]\necho = true\n"].map(|echo| (protocol, model, echo)))
    }) {
        for (delay, hold) in [(1, "0.3"), (10, "0.3"), (20, "0.5"), (60, "0.7")] {
            let drive = format!("protocol = \"{protocol}\"\nreply_delay = \"{delay}ms\"");
            let line = format!("-v --protocol {protocol} -b 19200 --drive {model} -a 1 statemachine quick-stop");
            let run = antrieb(&line).on(&bench(model, (&drive, hold), echo)).run();
            if (run.exit, words(&run)) != (0, 1) {
                sins.push(format!("{line} {delay} ms, {hold} s {echo}: exit {}\n{}", run.exit, run.err));
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

/// A dead drive behind an adapter that echoes has acknowledged nothing; its word goes out as often as ever.
#[test]
fn an_echo_alone_acknowledges_no_stop() {
    let dead = "[[drive.event]]\nat = \"0ms\"\nsilent = \"600s\"\n[line]\necho = true\n";
    for protocol in ["rtu", "ascii"] {
        let drive = format!("protocol = \"{protocol}\"");
        let line = format!("-v --protocol {protocol} -b 19200 --drive acu -a 1 statemachine quick-stop");
        let run = antrieb(&line).on(&bench("acu", (&drive, "1"), dead)).run();
        assert!(run.exit == 4 && words(&run) >= 5, "{protocol}: exit {}\n{}", run.exit, run.err);
        assert!(run.err.contains("THE SHAFT MAY STILL TURN"), "{}", run.err);
    }
}

/// Who answers each question once, within the 500 ms of the manual, is understood: what was said too often is what nobody
/// could tell apart.
#[test]
fn a_slow_drive_is_seen_to_stand_behind_its_stop() {
    let mut sins = Vec::new();
    for (delay, hold) in [(200, "1"), (300, "3"), (400, "3")] {
        for drive in ["", "--drive acu"] {
            for verb in ["statemachine quick-stop", "sollwert 0"].into_iter().take(if delay < 400 { 2 } else { 1 }) {
                let slow = format!("reply_delay = \"{delay}ms\"");
                let line = format!("-v -b 19200 {drive} -a 1 {verb}");
                let run = antrieb(&line).on(&bench("acu", (&slow, hold), "")).run();
                if run.exit != 0 {
                    sins.push(format!("{line} {delay} ms, {hold} s: exit {}\n{}", run.exit, run.err));
                }
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}
