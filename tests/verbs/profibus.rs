//! Parameters over PROFIBUS, read and written: the slave is taken, held by the stop word, and let go, however the work ends; the line
//! itself is asked.

mod basic;
mod beside;
mod configured;
mod datasets;
mod described;
mod ends;
mod heard;
mod keys;
mod led;
mod looked;
mod rig;
mod said;
mod scanned;
mod stranger;
mod watched;

use crate::run::antrieb;
use antrieb::simulator::Profibus;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

/// A motor that a lost controller has left running at 10 Hz by its terminals: the contact is closed, and P.928 is as named.
fn line(more: &str, readings: &str) -> String {
    format!(
        "[line]\n{more}\n[[module]]\ndrive = \"l200\"\naddress = 3\nset = {{ \"928\" = 1, \"703\" = 2 }}\n\
         readings = {{ {readings} }}\n"
    )
}

/// The line as it was left, a while later.
fn later() -> Profibus {
    let mut bus = witness::left_profibus().unwrap();
    bus.advance(Tick::ZERO + Span::from_secs(600));
    bus
}

fn is_let_go(bus: &Profibus) -> bool {
    bus.counts()[3] == 0 && bus.turning() == [0, 0]
}

#[test]
fn values_come_whatever_the_channel_does_meanwhile() {
    for readings in [
        "",
        "pkw_waits = \"empty\"",
        "pkw_again = \"every-cycle\"",
        "negative_pwe = \"extended\"",
        "watchdog = \"telegrams\"",
        "unconfigured = \"basic\"",
    ] {
        let run = antrieb("-a 3 --yes profibus read F002 703 624 219").on(&line("", readings)).json().exits(0);
        let raw: Vec<_> = run.data("/values").as_array().unwrap().iter().map(|value| value["raw"].clone()).collect();
        assert_eq!(raw, [-1_000, 2, 0x20, 0], "{readings}");
        assert_eq!(run.data("/values/0/value"), 10.0);
        assert_eq!(run.data("/values/0/drive"), "l200");
        assert_eq!(run.warnings(), ["profibus.let_go"]);
        let bus = later();
        assert!(is_let_go(&bus) && bus.remarks().is_empty(), "{readings}: {:?}", bus.remarks());
    }
}

#[test]
fn refusals_are_told_in_words_in_whichever_half_the_number_stands() {
    for (readings, set, code) in [
        ("", "", "refused.pkw"),
        ("error_word = \"high\"", "", "refused.pkw"),
        ("", ", \"927\" = 0", "refused.no_right"),
        ("locked = \"error-11\"", ", \"927\" = 0", "refused.pkw"),
    ] {
        let text = line("", readings).replace("\"703\" = 2", &format!("\"703\" = 2{set}"));
        let run = antrieb("-a 3 --yes --drive l200 profibus read 599").on(&text).json().exits(6);
        assert_eq!(run.error()["code"], code, "{readings} {set}");
        assert!(is_let_go(&later()));
    }
}

#[test]
fn a_bad_line_costs_repeats_and_no_value() {
    for more in
        ["flips = 3", "losses = 4", "echo = true", "latency = \"16ms\"", "baud = 500000", "baud = 93750\nlosses = 3"]
    {
        let baud = more.split(['=', '\n']).nth(1).filter(|_| more.starts_with("baud")).unwrap_or(" 19200");
        let run =
            antrieb(&format!("-a 3 --baud{baud} --yes profibus read F002 703")).on(&line(more, "")).json().exits(0);
        assert_eq!((run.data("/values/0/raw"), run.data("/values/1/raw")), (&(-1_000).into(), &2.into()), "{more}");
        assert!(is_let_go(&later()), "{more}");
    }
}

#[test]
fn a_port_that_is_lost_leaves_it_to_the_watchdog() {
    for telegrams in 0..60 {
        witness::pull_after(Some(telegrams));
        let run = antrieb("-a 3 --yes profibus read F002 703").on(&line("", "")).run();
        witness::pull_after(None);
        assert!([0, 3].contains(&run.exit), "{telegrams}: {}", run.err);
        assert!(is_let_go(&later()), "{telegrams}");
    }
}

#[test]
fn nothing_is_taken_without_a_yes() {
    antrieb("-a 3 profibus read F002").on(&line("", "")).exits(8);
    assert!(witness::left_profibus().is_none(), "no line was opened");
    antrieb("profibus read F002").on(&line("", "")).exits(2);
}

/// Every reading that concerns a request, and lines that lose some of it.
const HARD: [(&str, &str); 9] = [
    ("", ""),
    ("", "pkw_waits = \"empty\""),
    ("", "pkw_again = \"every-cycle\""),
    ("", "negative_pwe = \"extended\""),
    ("", "watchdog = \"telegrams\""),
    ("flips = 3", ""),
    ("losses = 4", "pkw_again = \"every-cycle\""),
    ("echo = true", ""),
    ("latency = \"16ms\"", ""),
];

#[test]
fn what_is_written_is_read_back() {
    for (more, readings) in HARD {
        let typed = "-a 3 --protocol dp --yes write F002=5s 703=1 915.2=34";
        let run = antrieb(typed).on(&line(more, readings)).json().exits(0);
        let row = |at: usize, key: &str| run.data(&format!("/values/{at}/{key}")).clone();
        assert_eq!([row(0, "old_raw"), row(0, "raw")], [-1_000, -500], "{more} {readings}");
        assert_eq!([row(0, "old"), row(0, "value")], [10.0, 5.0]);
        assert_eq!([row(1, "old_raw"), row(1, "raw")], [2, 1]);
        assert_eq!([row(2, "param"), row(2, "index"), row(2, "raw")], [915, 2, 34]);
        (0..3).for_each(|at| assert_eq!(row(at, "result"), "verified", "{more} {readings}"));
        assert_eq!(run.warnings(), ["profibus.let_go"]);
        assert!(is_let_go(&later()), "{more} {readings}");
    }
}

#[test]
fn what_stands_there_already_is_not_sent() {
    let run = antrieb("-a 3 --protocol dp --yes write F002=10s 703=2").on(&line("", "")).json().exits(0);
    let results = ["/values/0/result", "/values/1/result"].map(|at| run.data(at).clone());
    assert_eq!(results, ["unchanged", "unchanged"]);
    assert!(is_let_go(&later()));
}

#[test]
fn elements_are_read_by_their_number() {
    let run = antrieb("-a 3 --protocol dp --yes read 964.4 915.1 614").on(&line("", "")).json().exits(0);
    let row = |at: usize| {
        let value = |key: &str| run.data(&format!("/values/{at}")).get(key).cloned().unwrap_or_default();
        [value("param"), value("index"), value("raw")]
    };
    assert_eq!(row(0), [964, 4, 2_007]);
    assert_eq!(row(1), [915, 1, 0]);
    assert_eq!(run.data("/values/2/raw"), 0);
    assert!(run.data("/values/2").get("index").is_none());
    for (typed, code) in [("964.9", 6), ("F002.1", 7), ("7.1", 6)] {
        antrieb(&format!("-a 3 --protocol dp --yes read {typed}")).on(&line("", "")).exits(code);
        if code == 6 {
            assert!(is_let_go(&later()), "{typed}");
        }
    }
}

#[test]
fn an_array_without_an_element_is_all_of_its_elements() {
    let run = antrieb("-a 3 --protocol dp --yes read 964 915").on(&line("", "")).json().exits(0);
    let values = run.data("/values").as_array().unwrap();
    let read: Vec<_> = values.iter().map(|value| [value["param"].clone(), value["index"].clone()]).collect();
    let expected = (1..=5).map(|at| [964, at]).chain((1..=8).map(|at| [915, at]));
    assert_eq!(read, expected.map(|row| row.map(serde_json::Value::from)).collect::<Vec<_>>());
    assert!(values.iter().all(|value| value["raw"].is_i64()), "{values:?}");
    assert!(is_let_go(&later()));
    let run = antrieb("-a 3 --protocol dp --yes write 915=34").on(&line("", "")).json().exits(2);
    assert_eq!(run.error()["code"], "usage.element");
    assert!(witness::left_profibus().is_none(), "no line was opened");
}

#[test]
fn a_refused_value_leaves_out_the_rest_and_is_said() {
    for (readings, set) in [("", ""), ("error_word = \"high\"", ""), ("", ", \"927\" = 0")] {
        let text = line("", readings).replace("\"703\" = 2", &format!("\"703\" = 2{set}"));
        let typed = "-a 3 --protocol dp --drive l200 --yes write 704=9 F002=5s --force";
        let run = antrieb(typed).on(&text).json().exits(6);
        let results = ["/values/0/result", "/values/1/result"].map(|at| run.data(at).clone());
        assert_eq!(results, ["refused", "skipped"], "{readings}");
        assert!(is_let_go(&later()));
    }
    let offline = |typed: &str| antrieb(&format!("-a 3 --protocol dp --yes write {typed}")).on(&line("", "")).json();
    assert_eq!(offline("614=1").exits(7).error()["code"], "data.read_only");
    assert_eq!(offline("F002=5s --type int").exits(2).error()["code"], "usage.profibus");
    assert!(witness::left_profibus().is_none(), "no line was opened");
    antrieb("-a 1 --port sim read 480 --slot-time 20ms").exits(2);
}

#[test]
fn a_port_that_is_lost_at_any_telegram_of_a_write_leaves_it_to_the_watchdog() {
    for telegrams in (0..80).step_by(3) {
        witness::pull_after(Some(telegrams));
        let run = antrieb("-a 3 --protocol dp --yes write F002=5s 703=2 --json").on(&line("", "")).run();
        witness::pull_after(None);
        assert!([0, 3, 9].contains(&run.exit), "{telegrams}: {}", run.err);
        assert!(is_let_go(&later()), "{telegrams}");
    }
}

/// 10 Hz by the terminals, which P.928 = 1 takes from them: the stop is waited for whatever is asked meanwhile.
#[test]
fn a_motor_that_turns_stands_before_zero_outputs_go() {
    let event = "\n[[module.event]]\nat = \"0s\"\ncontact = true\n";
    for readings in ["", "without_control = \"ramp\"", "unlock = \"no-loss\"", "clear = \"loss\""] {
        let text = line("", readings) + event;
        antrieb("-a 3 --protocol dp --yes write F002=5s").on(&text).exits(0);
        let bus = later();
        assert!(is_let_go(&bus) && bus.remarks().is_empty(), "{readings}: {:?}", bus.remarks());
    }
}

#[test]
fn a_write_asks_twice_and_a_dry_run_shows_the_telegram() {
    antrieb("-a 3 --protocol dp write F002=5s").on(&line("", "")).exits(8);
    antrieb("-a 3 --protocol dp write F002=5s").on(&line("", "")).answered("n\n").exits(8);
    assert!(witness::left_profibus().is_none(), "no line was opened");
    let run = antrieb("-a 3 --protocol dp --dry-run write 915.1=34").on(&line("", "")).json().exits(0);
    assert_eq!(run.data("/values/0/result"), "planned");
    assert!(run.data("/values/0/meaning").as_str().unwrap().contains("P.915.1"));
}
