//! Several drives are told to stop in rounds: who is silent keeps it from nobody.

use super::rig::RUNNING;
use crate::run::antrieb;

/// When the first telegram went out that tells a drive to stop, in ms.
fn told_at(run: &crate::run::Output, address: u8, word: &str) -> f64 {
    let lines = run.err.lines().filter_map(|line| line.split_once(" ms > "));
    let mut told = lines.filter(|(_, rest)| {
        rest.contains(&format!("  address {address}: write ")) && word.split('|').any(|word| rest.contains(word))
    });
    told.next().map_or(f64::INFINITY, |(at, _)| at.trim().parse().unwrap())
}

/// How a drive on the line is, and what its stop is called.
struct Who {
    is: &'static str,
    model: &'static str,
    word: &'static str,
}

/// Nobody waits longer for his stop than one reply may take of each before him, whoever these are: a cabinet that is switched off, a drive
/// under load, one that refuses, and one of another family.
#[test]
fn whoever_is_silent_keeps_the_stop_from_nobody_behind_him() {
    const DEAD: Who = Who { is: "[[drive.event]]\nat = \"0s\"\nsilent = \"10min\"", model: "acu", word: "P.410" };
    const SLOW: Who = Who { is: "reply_delay = \"300ms\"", model: "acu", word: "P.410" };
    const REFUSES: Who = Who { is: "[[drive.event]]\nat = \"0s\"\nrefuses = 410", model: "act", word: "P.410" };
    const GOOD: Who = Who { is: "", model: "act", word: "P.410" };
    const SERVO: Who = Who { is: "", model: "lxm05", word: "DCOMcontrol|register 6914" };
    let of = |who: &Who, address: usize, line: &str| {
        let set = if who.model == "lxm05" { String::new() } else { format!("set = {{ {RUNNING} }}\n") };
        format!("[[drive]]\nmodel = \"{}\"\naddress = {address}\nbaud = 19200\n{line}\n{set}{}\n", who.model, who.is)
    };
    let orders = [
        [DEAD, GOOD, SLOW, SERVO, DEAD, REFUSES, GOOD],
        [SLOW, SLOW, DEAD, DEAD, SERVO, GOOD, REFUSES],
        [REFUSES, DEAD, DEAD, DEAD, DEAD, GOOD, SERVO],
    ];
    for (line, options, servos) in [
        ("", "", true),
        ("", "--drive acu", false),
        ("protocol = \"ascii\"", "--protocol ascii", false),
        ("protocol = \"vabus\"", "--protocol vabus", false),
        ("protocol = \"vabus\"", "--protocol vabus --drive act", false),
    ] {
        for (order, verb) in
            orders.iter().flat_map(|order| ["quick-stop", "disable", "disable-voltage"].map(|verb| (order, verb)))
        {
            let order: Vec<&Who> = order.iter().filter(|who| servos || who.model != "lxm05").collect();
            let bench: String = order.iter().enumerate().map(|(at, who)| of(who, at + 1, line)).collect();
            let run =
                antrieb(&format!("-v -b 19200 {options} -a 1-{} statemachine {verb}", order.len())).on(&bench).run();
            for (before, who) in order.iter().enumerate() {
                let at = told_at(&run, before as u8 + 1, who.word);
                // Each before him has a reply's time, and its telegrams; what a ramp is must be asked for before it is said.
                let turn = if *verb == *"disable" { 850.0 } else { 600.0 };
                let may = (before as f64 + 1.0) * turn;
                assert!(
                    at <= may || who.is == DEAD.is,
                    "{options} {verb}: {before} at {at} ms: {}",
                    run.err.lines().take(60).collect::<Vec<_>>().join("\n")
                );
            }
        }
    }
}
