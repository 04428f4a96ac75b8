//! `profibus read`: the slave is taken, held by the stop word, and let go, however the work ends; the line itself is asked.

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
