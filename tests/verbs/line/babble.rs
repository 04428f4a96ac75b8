//! Whole verbs on a line that is never silent: every one ends by itself, within a time that no byte can move.

use crate::run::antrieb;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

/// What somebody says, again and again.
const BABBLE: [(&str, &str); 9] = [
    ("drip", "kind = \"babble\"\npattern = \"55\"\nby = \"20ms\""),
    ("master, 12 ms", "kind = \"babble\"\npattern = \"master\"\nby = \"12ms\""),
    ("master, 25 ms", "kind = \"babble\"\npattern = \"master\"\nby = \"25ms\""),
    ("flood", "kind = \"babble\"\npattern = \"random\"\nby = \"1ms\""),
    ("digits", "kind = \"babble\"\npattern = \"digits\"\nby = \"0ms\""),
    ("twins", "every = 1\nkind = \"twin\"\nby = \"3ms\""),
    ("doubled", "every = 1\nkind = \"doubled\"\nby = \"30ms\""),
    ("echo", "every = 1\nkind = \"echo\""),
    ("late", "every = 1\nkind = \"late\"\nby = \"6s\""),
];

/// Verbs, and how long each may take at most.
const VERBS: [(&str, u64); 9] = [
    ("-a 1 read 372", 60),
    ("-a 1 write 372@1=1400 --yes", 60),
    ("-a 1 identify", 60),
    ("-a 1 diag", 60),
    ("-a 1 statemachine", 60),
    // It has gone out in the first second; the rest proves nothing.
    ("-a 1 statemachine quick-stop", 15),
    ("-a 1 sollwert 5Hz --yes", 60),
    ("-a 1 sollwert 5Hz --yes --hold --duration 2s", 60),
    ("scan --address 1-3", 60),
];

#[test]
fn every_verb_ends_whatever_babbles() {
    let mut longest = Span::ZERO;
    for protocol in ["rtu", "vabus"] {
        // Over VABus what it adds: its digits, its repeats, its end of exchange.
        let own = ["digits", "twins", "late"];
        for (name, babble) in BABBLE.into_iter().filter(|row| protocol == "rtu" || own.contains(&row.0)) {
            let bench = format!("[[drive]]\nmodel = \"act\"\nprotocol = \"{protocol}\"\n[[disturb]]\n{babble}\n");
            for (verb, most) in VERBS {
                witness::call();
                let run = antrieb(&format!("--protocol {protocol} {verb}")).on(&bench).run();
                let took = witness::left().map_or(Span::ZERO, |(_, now)| now.since(Tick::ZERO));
                println!("{protocol} {name}: {verb}: exit {}, {took}", run.exit);
                assert!(run.exit != 101 && run.exit != 2, "{protocol} {name} {verb}: {}", run.err);
                assert!(took <= Span::from_secs(most), "{protocol} {name} {verb}: {took}");
                longest = longest.max(took);
            }
        }
    }
    println!("longest: {longest}");
}

#[test]
fn a_scan_of_a_line_that_is_never_silent_does_not_say_that_nobody_is_there() {
    for verb in ["scan -a 2-4", "scan -a 2-4 --baud auto"] {
        let bench = format!("[[drive]]\nmodel = \"act\"\naddress = 9\n[[disturb]]\n{}\n", BABBLE[0].1);
        let document = antrieb(verb).on(&bench).json();
        let error = &document.value["error"];
        assert_eq!((document.exit, error["code"].as_str()), (5, Some("garbled.never_silent")), "{verb}");
        let is_blamed = document.value["warnings"].to_string().contains("scan.garbage");
        assert!(!is_blamed || verb.contains("auto"), "nobody knows whose garbage it is");
    }
}
