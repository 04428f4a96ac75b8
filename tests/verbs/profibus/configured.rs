//! The configuration of a slave, as it is named (`--cfg`): how it is led then, and what comes with its further words.

use super::rig::module;
use super::{is_let_go, later, line};
use crate::run::antrieb;
use antrieb::transport::witness;

#[test]
fn a_slave_is_taken_as_it_is_named() {
    for (typed, state) in [
        ("--cfg ppo1 statemachine", "ready-to-switch-on"),
        ("--cfg F3F1 statemachine", "ready-to-switch-on"),
        ("--cfg ppo2 statemachine", "ready-to-switch-on"),
        ("--cfg ppo3 statemachine", "ready-to-switch-on"),
        ("--cfg ppo4 statemachine", "ready-to-switch-on"),
        ("--cfg ppo5 statemachine", "ready-to-switch-on"),
        ("--cfg basic --drive l200 statemachine", "stop"),
    ] {
        let typed = typed.split_once(" statemachine").unwrap().0;
        let run = antrieb(&format!("-a 3 --protocol dp --yes statemachine {typed}")).on(&line("", "")).json().exits(0);
        assert_eq!(run.data("/drives/0/state/slug"), state, "{typed}");
        let bus = later();
        assert!(is_let_go(&bus) && bus.remarks().is_empty(), "{typed}: {:?}", bus.remarks());
    }
    let run = antrieb("-a 3 --protocol dp --yes read F002 --cfg ppo1").on(&line("", "")).json().exits(0);
    assert_eq!(run.data("/values/0/raw"), -1_000);
}

#[test]
fn what_a_configuration_cannot_is_said_before_a_line_is_opened() {
    for typed in [
        "read F002 --cfg ppo3",
        "read F002 --cfg basic",
        "statemachine --cfg ppo6",
        "statemachine --cfg basic",
        "statemachine --mode basic --cfg ppo1 --drive l200",
    ] {
        antrieb(&format!("-a 3 --protocol dp --yes {typed}")).on(&line("", "")).exits(2);
    }
    antrieb("-a 3 --yes read F002 --cfg ppo1").on(&line("", "")).exits(2);
    assert!(witness::left_profibus().is_none(), "no line was opened");
    let run = "-a 3 --protocol dp --yes sollwert 10Hz --jog 1s --take-control --cfg ppo3";
    let run = antrieb(run).on(&line("", "")).json().exits(2);
    assert!(run.error()["message"].as_str().unwrap().contains("PKW"));
}

#[test]
fn nothing_is_written_by_a_word_that_is_mapped_to_a_parameter() {
    for element in [1, 4] {
        let text = module(&format!("\"928\" = 1, \"915.{element}\" = 7"), "", "");
        let run = antrieb("-a 3 --protocol dp --yes monitor 239 --cfg ppo2 --count 2 --unpaced --json").on(&text).run();
        assert_eq!(run.exit, 8, "{}", run.err);
        assert!(run.err.contains(&format!("P.915.{element}")), "{}", run.err);
        let bus = later();
        assert_eq!(bus.raw(3, 915, Some(element)), Some(7));
        assert_eq!(bus.raw(3, 7, None).map(|raw| raw as i16), Some(-1_000), "what is mapped stands as before");
        assert!(is_let_go(&bus));
        // A stop needs no further words.
        antrieb("-a 3 --protocol dp statemachine --cfg ppo2 disable").on(&text).exits(0);
        assert_eq!(later().raw(3, 7, None).map(|raw| raw as i16), Some(-1_000));
    }
    // Beyond the words that the configuration has, it does not matter.
    let text = module("\"928\" = 1, \"915.5\" = 7", "", "");
    antrieb("-a 3 --protocol dp --yes statemachine --cfg ppo2").on(&text).exits(0);
}

#[test]
fn what_is_watched_comes_with_every_cycle_and_the_mapping_is_given_back() {
    let text = module("\"928\" = 1, \"916.1\" = 34", "", "");
    let rounds = |cfg: &str| {
        let typed = "-a 3 --protocol dp --yes monitor F002 239 615 --interval 0 --count 20 --unpaced --format csv";
        let run = antrieb(&format!("{typed} {cfg}")).on(&text).exits(0);
        let bus = later();
        assert_eq!([bus.raw(3, 916, Some(1)), bus.raw(3, 916, Some(2))], [Some(34), Some(0)]);
        assert!(is_let_go(&bus) && bus.remarks().is_empty(), "{:?}", bus.remarks());
        let last = run.out.trim_end().lines().last().unwrap().to_owned();
        assert!(last.contains("10.00"), "{last}");
        last.split(',').next().unwrap().parse::<f64>().unwrap()
    };
    let (asked, mapped) = (rounds(""), rounds("--cfg ppo2"));
    assert!(mapped * 4.0 < asked, "{mapped} s in place of {asked} s");
}

#[test]
fn the_mapping_is_stored_by_a_0_and_the_value_behind_it() {
    let text = module("\"928\" = 1, \"704\" = 2", "", "");
    let run = antrieb("-a 3 --protocol dp --yes write 704=2 -v --json").on(&text).run();
    assert_eq!(run.exit, 0, "{}", run.err);
    assert!(run.out.contains("verified"), "what stands there already is done again: {}", run.out);
    assert_eq!(later().raw(3, 704, None), Some(2));
    let sent = |pwe: &str| run.err.lines().position(|line| line.contains(&format!("22 C0 00 00 00 00 00 {pwe}")));
    assert!(sent("00").unwrap() < sent("02").unwrap(), "{}", run.err);
}
