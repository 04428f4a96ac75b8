//! Stops of a drive that is not reached: the port is lost, or nobody answers. It is said, with what stops the shaft, and in time.

use crate::run::antrieb;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

const VERBS: [&str; 4] =
    ["statemachine quick-stop", "statemachine disable", "statemachine disable-voltage", "sollwert 0"];

const ACU: &str =
    "[[drive]]\nmodel = \"acu\"\nset = { \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 20, \"418\" = 0 }\n";
const SERVO: &str = "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 3000, RAMPdecel = 3000 }\n";

#[test]
fn wherever_the_port_is_lost_the_shaft_that_may_turn_is_said_first() {
    for (bench, named) in [(ACU, "--drive acu"), (ACU, ""), (SERVO, "--drive lxm05"), (SERVO, "")] {
        for verb in VERBS {
            let mut lost = 0;
            for telegrams in 0..24 {
                witness::pull_after(Some(telegrams));
                let run = antrieb(&format!("{named} -a 1 {verb}")).on(bench).run();
                witness::pull_after(None);
                if run.exit != 3 {
                    continue;
                }
                lost += 1;
                let what = format!("{named} {verb}, telegram {telegrams}: {}", run.err);
                // Once it is seen to stand, or without power, the page tells what is known of the shaft.
                let stands = run.err.contains("the stop was acknowledged") || run.out.contains("without power");
                assert!(stands || run.err.contains("error: THE SHAFT MAY STILL TURN"), "{what}");
                assert!(stands || run.err.contains("what stops it now"), "{what}");
            }
            assert!(lost > 2, "{named} {verb}: {lost}");
        }
    }
}

#[test]
fn a_long_time_out_makes_no_stop_longer() {
    let silent = format!("{ACU}[[drive.event]]\nat = \"0s\"\nsilent = \"600s\"\n");
    for (named, verb) in [("", VERBS[0]), ("--drive acu", VERBS[0]), ("", VERBS[1]), ("", VERBS[3])] {
        let run = antrieb(&format!("-v --timeout 60s {named} -a 1 {verb}")).on(&silent).run();
        let (_, now) = witness::left().unwrap();
        let took = now.since(Tick::ZERO);
        assert!(took < Span::from_secs(20), "{named} {verb}: {took}\n{}", run.err);
        assert_eq!(run.exit, 4, "{named} {verb}: {}", run.err);
    }
}

/// When it was said that nobody answers the stop, in ms since its first word behind the last answer.
fn said(err: &str, word: &str) -> Vec<f64> {
    let (mut at, mut first, mut said) = (0.0, None, Vec::new());
    for line in err.lines() {
        if line.contains(" ms < ") {
            first = None;
        }
        if let Some((ms, hex)) = line.split_once(" ms > ") {
            at = ms.trim().parse::<f64>().unwrap();
            first = first.or(hex.starts_with(word).then_some(at));
        }
        if line.starts_with("note: THE SHAFT MAY STILL TURN") {
            said.push(at - first.unwrap());
        }
    }
    said
}

/// P.410 and P.484.
const WORDS: [&str; 4] = ["01 06 01 9A", "01 06 01 9A", "01 06 01 9A", "01 65 01 E4"];

#[test]
fn that_nobody_answers_a_stop_is_said_once_while_it_is_sent() {
    let silent = format!("{ACU}[[drive.event]]\nat = \"0s\"\nsilent = \"600s\"\n");
    for timeout in ["", "--timeout 5s"] {
        for named in ["--drive acu", ""] {
            for (verb, word) in VERBS.into_iter().zip(WORDS) {
                let run = antrieb(&format!("-v {timeout} {named} -a 1 {verb}")).on(&silent).run();
                let said = said(&run.err, word);
                assert!(matches!(said[..], [at] if at < 3_200.0), "{timeout} {named} {verb}: {said:?}\n{}", run.err);
                assert!(run.err.contains("error: THE SHAFT MAY STILL TURN"), "{}", run.err);
            }
        }
    }
    let dies = format!("{ACU}[[drive.event]]\nafter_telegrams = 60\nsilent = \"600s\"\n").replace("= 15", "= 0");
    let run = antrieb("-v -a 1 --drive acu sollwert 10Hz --enable --hold --duration 30s --yes").on(&dies).run();
    assert!(matches!(said(&run.err, "01 06 01 9A 00 07")[..], [at] if at < 3_200.0), "{}", run.err);
}

#[test]
fn of_a_stop_that_is_answered_in_the_end_nothing_of_the_kind_is_said() {
    let late = |ms: u32| ACU.replace("set =", &format!("reply_delay = \"{ms}ms\"\nset ="));
    let lossy = format!("{ACU}[[disturb]]\nevery = 3\nkind = \"lost\"\n");
    for bench in [late(10), late(450), lossy] {
        for verb in VERBS {
            let run = antrieb(&format!("-v -a 1 {verb}")).on(&bench).run();
            assert!(!run.err.contains("note: THE SHAFT"), "{verb}: {}", run.err);
        }
    }
}
