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
