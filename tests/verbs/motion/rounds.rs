//! Several drives are told to stop in rounds: who is silent keeps it from nobody.

use super::rig::{RUNNING, ran};
use crate::run::{Run, antrieb};
use antrieb::tick::Span;

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

/// A drive that runs, at an address, with more besides.
fn running(address: u8, more: &str) -> String {
    format!("[[drive]]\nmodel = \"acu\"\naddress = {address}\nbaud = 19200\nset = {{ {RUNNING} }}\n{more}\n")
}

/// A verb on drives that have run up for 10 s.
fn at_speed(line: &str, bench: &str) -> Run {
    ran(Span::from_secs(10), line, bench)
}

/// One that nobody switched on, one that says no, and good ones: the end is the same in whatever order they are named, and says every
/// address once.
#[test]
fn the_end_of_a_group_stop_goes_by_what_came_and_not_by_the_order() {
    let refuses = "[[drive.event]]\nat = \"0s\"\nrefuses = 410";
    let dead = "[[drive.event]]\nat = \"0s\"\nsilent = \"10min\"";
    let bench = [running(1, ""), running(2, ""), running(7, refuses), running(9, dead)].concat();
    for (orders, exit) in
        [(&["9,1,2", "1,9,2", "1,2,9", "2,7,1", "7,1,2", "9,7,1"][..], 9), (&["9,7", "7,9"], 4), (&["1,2", "2,1"], 0)]
    {
        for addresses in orders {
            let run = at_speed(&format!("-a {addresses} statemachine quick-stop"), &bench).exits(exit);
            for address in addresses.split(',') {
                let named = format!("address {address}: ");
                let error = run.err.lines().find(|line| line.starts_with("error: ")).unwrap_or_default();
                let is_good = ["1", "2"].contains(&address);
                assert_eq!(error.matches(&named).count(), usize::from(!is_good), "{addresses}: {error}");
            }
        }
    }
}

/// Ramps of their own, and lines that are slow or full: who is looked at in turns shows his standstill all the same.
#[test]
fn a_group_that_ramps_down_is_seen_to_stand() {
    let ramps =
        |down: u32| format!("ramps = {{ up_right = 50, down_right = {down}, up_left = 50, down_left = {down} }}");
    for downs in [[12, 10, 5], [5, 10, 12], [10, 10, 10]] {
        let quick = |down: u32| format!("\"424\" = {down}, \"425\" = {down}, ");
        let drive =
            |(address, down)| running(address, &ramps(down)).replace("\"410\" =", &format!("{}\"410\" =", quick(down)));
        let bench: String = (1..=3).zip(downs).map(drive).collect();
        for (verb, named) in
            [("quick-stop", ""), ("disable", ""), ("quick-stop", "--drive acu "), ("disable", "--drive acu ")]
        {
            let run = at_speed(&format!("{named}-a 1-3 statemachine {verb}"), &bench).json().exits(0);
            for at in 0..3 {
                assert_eq!(
                    run.data(&format!("/drives/{at}/motion/standing")),
                    true,
                    "{downs:?} {named}{verb} {at}: {}",
                    run.err
                );
            }
        }
    }
}
