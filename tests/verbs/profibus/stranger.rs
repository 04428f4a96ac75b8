//! What a stranger's slave has found (tests/strangers/profibus, verdicts/issue-16.md): ends that are told as they are, locked parameters,
//! outages of a watch, recordings.

use super::rig::{Hand, RESTS, does, event, module};
use super::{is_let_go, later, line};
use crate::run::{Output, antrieb};
use antrieb::tick::Span;
use serde_json::{Value, json};

const RUN: &str = "sollwert 20Hz --enable --hold --duration 3s --take-control --watchdog 2s";

/// A recording of our own: a question, an answer in two pieces, a cycle; and whatever is said of it.
fn recording(first: &str) -> String {
    format!(
        "{first}0 > 10 08 02 49 53 16\n8000 < 10 02 08\n9000 < 00 0A 16\n20000 > 68 05 05 68 88 82 6D 3C 3E F1 16\n\
         30000 < 68 0B 0B 68 82 88 08 3E 3C 02 05 00 FF 0A 35 D1 16\n50000 > 68 0C 0C 68 88 82 5D 3D 3E 88 C8 01 0B 0A 35 00 7D 16\n\
         60000 < E5\n80000 > 68 07 07 68 08 02 5D 04 7E 00 00 E9 16\n110000 < 68 07 07 68 02 08 08 00 31 00 00 43 16\n"
    )
}

#[track_caller]
fn telegrams(typed: &str, text: &str) -> Vec<Value> {
    let run = antrieb(&format!("{typed} decode trace {{dir}}/t --cfg ppo3")).file("t", text).json().exits(0);
    run.data("/telegrams").as_array().unwrap().clone()
}

#[test]
fn a_recording_of_profibus_is_read_as_one() {
    let ours = recording("# antrieb trace 1, 19200 8E1, dp\n");
    for (typed, text) in [("", &ours), ("--protocol dp", &ours), ("--protocol rtu", &ours), ("", &recording(""))] {
        let told = telegrams(typed, text);
        assert_eq!(told.len(), 8, "{typed}: {told:#?}");
        assert!(told.iter().all(|telegram| telegram["check_ok"] == true && telegram["protocol"] == "dp"), "{typed}");
        assert!(told[6]["meaning"].as_str().unwrap().contains("047Eh"), "{typed}: {}", told[6]["meaning"]);
        assert_eq!((&told[1]["at_us"], &told[5]["address"]), (&json!(9_000), &json!(8)), "{typed}");
    }
    // One of another line stays what it says that it is.
    let rtu = "# antrieb trace 1, 19200 8E1, rtu\n0 > 01 03 21 74 00 01 CE 2C\n";
    for typed in ["", "--protocol dp"] {
        let run = antrieb(&format!("{typed} decode trace {{dir}}/t")).file("t", rtu).json().exits(0);
        assert_eq!(run.data("/telegrams/0/protocol"), "rtu", "{typed}");
    }
}

fn said(run: &Output) -> String {
    format!("{}{}", run.out, run.err)
}

#[test]
fn a_locked_inverter_is_stopped_and_unlocked() {
    for readings in ["", "locked = \"error-11\""] {
        let locked = line("", readings).replace("\"703\" = 2", "\"703\" = 2, \"927\" = 0");
        let of = |typed: &str| antrieb(&format!("-a 3 --protocol dp --yes {typed}")).on(&locked).json();
        let run = of("write 927=1").exits(0);
        assert_eq!(run.data("/values/0/result"), "verified", "{readings}");
        assert_eq!(of("read 927").exits(0).data("/values/0/raw"), 0, "{readings}");
        let run = of("statemachine disable").exits(0);
        assert_eq!(run.data("/stop/acknowledged"), true, "{readings}");
        for typed in ["read F002", "write F002=5s", "write 927=1 F002=5s"] {
            let run = of(typed).exits(6);
            assert_eq!(run.error()["code"], "refused.locked", "{typed} {readings}");
            assert!(run.error().to_string().contains("write 927=1"), "{typed}: {}", run.error());
            assert!(is_let_go(&later()), "{typed}");
        }
    }
}

#[test]
fn an_outage_is_gaps_from_its_beginning_on() {
    for (until, drive) in [("4s", ""), ("6s", ""), ("7800ms", ""), ("6s", "--drive l200 --mode basic")] {
        let events = [event("2s", "cut = true"), event(until, "cut = false")].concat();
        let (basic, mode) = drive.split_once(" --").map_or((drive, ""), |_| ("--drive l200", "--mode basic"));
        let typed = format!(
            "-a 3 --protocol dp --yes {basic} monitor {mode} --interval 100ms --duration 12s --unpaced --format ndjson"
        );
        let run = antrieb(&typed).on(&module("", "", &events)).run();
        let records: Vec<Value> = run.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        let samples = records.iter().filter(|record| record["type"] == "sample");
        let (gaps, good): (Vec<_>, Vec<_>) = samples.partition(|sample| !sample["error"].is_null());
        let t = |sample: &Value| sample["t"].as_f64().unwrap();
        let (first, last) = (t(gaps[0]), t(gaps.last().unwrap()));
        let last_good = good.iter().map(|sample| t(sample)).filter(|at| *at < first).fold(0.0, f64::max);
        let back = good.iter().map(|sample| t(sample)).find(|at| *at > last).unwrap();
        assert!(first - last_good < 0.7, "{until} {drive}: {last_good} {first}");
        assert!(back - last < 1.0 && gaps.len() > 2, "{until} {drive}: {last} {back}");
        let summary = &records.last().unwrap()["summary"];
        assert_eq!(summary["gaps"], gaps.len(), "{until} {drive}");
        assert!(!run.err.contains("so long for what is asked"), "{}", run.err);
        let bus = later();
        // Who does not answer is asked the same again.
        let is_usual = bus.remarks().iter().all(|remark| remark.contains("the same question"));
        assert!(is_let_go(&bus) && is_usual, "{until} {drive}: {:?}", bus.remarks());
    }
}

/// Nobody says that a motor runs which was never started and never turned.
#[test]
fn a_line_that_goes_dead_at_a_question_leaves_nothing_running() {
    let hand = || Hand { thinks: Span::from_secs(30), ..Hand::default() };
    let came = does(RUN, &module(RESTS, "", &event("10s", "cut = true")), hand());
    assert_eq!(came.code().1, 4, "{:?}", came.failure());
    assert_eq!((came.motion().running, came.motion().idle), (None, true));
    assert!(!came.failure().unwrap().alarm);
    // One that was started may run.
    let came = does(RUN, &module(RESTS, "", &event("5s", "cut = true")), Hand::default());
    assert_eq!(came.motion().running, None, "{:?}", came.failure());
    assert!(came.failure().unwrap().alarm);
}

/// What a slave told before it fell silent is not told as what it does now; as with an ACTIVE that is lost.
#[test]
fn what_a_slave_that_is_lost_does_is_not_known() {
    for run in [RUN.to_owned(), RUN.replace("--take-control", "--mode basic")] {
        let came = does(&run, &module(RESTS, "", &event("6s", "cut = true")), Hand::default());
        let (motion, stop) = (came.motion(), came.stop());
        assert!(motion.from.is_some() && motion.setpoint.is_some() && !motion.idle, "{run}: {:?}", came.failure());
        assert!(motion.to.is_none() && stop.state.is_none(), "{run}: {:?}", motion.to);
        assert_eq!((motion.running, motion.standing), (None, None), "{run}");
        assert_eq!((stop.acknowledged, stop.standing), (false, None), "{run}");
        assert!(motion.setpoint.as_ref().is_some_and(|told| told.actual.is_none()), "{run}");
        assert!(came.failure().unwrap().told().en.starts_with("THE SHAFT MAY STILL TURN"), "{run}");
    }
}

#[test]
fn a_shaft_that_may_turn_is_said_first_whatever_went_wrong() {
    for run in [RUN.to_owned(), RUN.replace("--take-control", "--take-control --until reached")] {
        for at in ["4s", "5s"] {
            let came = does(&run, &module(RESTS, "", &event(at, "trip = true")), Hand::default());
            let failure = came.failure().unwrap();
            assert_eq!((came.code(), came.motion().standing), (("forbidden.tripped", 8), None), "{run} {at}");
            assert!(failure.told().en.starts_with("THE SHAFT MAY STILL TURN"), "{}", failure.told().en);
        }
    }
}

/// P.703 = 4 gives whoever is let go to the terminals.
#[test]
fn what_would_give_the_motor_to_a_closed_contact_is_not_given_back() {
    let set = RESTS.replace("\"703\" = 0", "\"703\" = 4");
    let came = does(RUN, &module(&set, "", &event("4s", "contact = true")), Hand::default());
    assert_eq!(came.code(), ("partial.not_given_back", 9), "{:?}", came.failure());
    came.holds("a contact closes in the run");
    let motion = came.motion();
    assert!(motion.changed.iter().all(|change| !change.restored), "{:?}", motion.changed);
    assert!(motion.notes.iter().any(|note| note.en.contains("P.703 stays 2")), "{:?}", motion.notes);
    assert!(came.failure().unwrap().told().en.starts_with("THE SHAFT MAY STILL TURN"));
    // With the contact open both go back.
    let came = does(RUN, &module(&set, "", ""), Hand::default());
    assert!(came.code() == ("", 0) && came.is_given_back(), "{:?}", came.failure());
    let warned = |lost: u32| {
        let text = line("", "").replace("\"703\" = 2", &format!("\"703\" = {lost}"));
        said(&antrieb("-a 3 --protocol dp --yes read F002").on(&text).exits(0)).contains("closed start contact may")
    };
    assert_eq!([0, 1, 2, 3, 4].map(warned), [false, false, false, false, true]);
}

/// In the second set 4000h may be A204, or A004 as the manual has it (4.1.2.3): what is measured decides.
#[test]
fn the_second_set_is_named_and_measured() {
    for (set, is_known) in
        [("\"607\" = 1, \"15\" = 500, \"16\" = 1000", true), ("\"607\" = 1, \"15\" = 5, \"16\" = 5", false)]
    {
        let came = does(RUN, &module(&format!("{RESTS}, {set}"), "a004 = \"0.1hz\"", ""), Hand::default());
        let details: Vec<String> = came.asked[1].details.iter().map(|text| text.en.to_string()).collect();
        assert!(details.iter().any(|text| text.contains("A204, A004")), "{details:?}");
        if is_known {
            assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
            let fastest = came.moments().iter().map(|moment| moment.shaft).max().unwrap();
            assert!((1_990..=2_000).contains(&fastest), "{fastest}");
        } else {
            assert!(came.failure().unwrap().told().en.contains("A204"), "{:?}", came.failure());
        }
        came.holds(set);
    }
}

/// Whoever names one series and finds another (P.624) reads nothing of it by the names of the first; a stop goes out all the same.
#[test]
fn another_series_than_the_one_that_was_named_is_refused() {
    let x200 = module("", "", "").replace("l200", "x200");
    let of = |drive: &str, typed: &str| antrieb(&format!("-a 3 --protocol dp {drive} --yes {typed}")).on(&x200).json();
    for typed in [
        "read F002",
        "identify",
        "write F002=5s",
        "diag",
        "statemachine",
        "sollwert 10Hz --jog 1s",
        "monitor --count 1",
    ] {
        let run = of("--drive l200", typed).exits(7);
        assert_eq!(run.error()["code"], "data.other_family", "{typed}");
        assert!(run.error()["message"].as_str().unwrap().contains("'x200' (P.624)"), "{typed}: {}", run.error());
        assert!(is_let_go(&later()), "{typed}");
    }
    for drive in ["--drive x200", ""] {
        assert_eq!(of(drive, "read F002").exits(0).data("/values/0/drive"), "x200", "{drive}");
    }
    assert_eq!(of("--drive l200", "statemachine disable").exits(0).data("/stop/acknowledged"), true);
}
