//! Whole verbs on a line that is never silent: every one ends by itself, within a time that no byte can move.

use crate::run::antrieb;
use antrieb::command::VERBS;
use antrieb::drive::{Price, Upper};
use antrieb::exchange::Limits;
use antrieb::protocol::Protocol;
use antrieb::protocol::line::Parity;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

/// What a line is like: what somebody says on it again and again, and what becomes of replies.
const BAD: [(&str, &str); 13] = [
    ("drip", "kind = \"babble\"\npattern = \"55\"\nby = \"20ms\""),
    ("master, 12 ms", "kind = \"babble\"\npattern = \"master\"\nby = \"12ms\""),
    ("master, 25 ms", "kind = \"babble\"\npattern = \"master\"\nby = \"25ms\""),
    ("flood", "kind = \"babble\"\npattern = \"random\"\nby = \"1ms\""),
    ("digits", "kind = \"babble\"\npattern = \"digits\"\nby = \"0ms\""),
    ("twins", "every = 1\nkind = \"twin\"\nby = \"3ms\""),
    ("doubled", "every = 1\nkind = \"doubled\"\nby = \"30ms\""),
    ("echo", "every = 1\nkind = \"echo\""),
    ("late", "every = 1\nkind = \"late\"\nby = \"6s\""),
    ("now and then late", "every = 3\nkind = \"late\"\nby = \"900ms\""),
    ("silent", "every = 1\nkind = \"lost\""),
    ("silent now and then", "every = 2\nkind = \"lost\""),
    ("garbled", "every = 1\nkind = \"garbled\""),
];

/// Verbs, of how many things in all they ask beside what they ask every drive, and an earlier end where one is promised.
const TYPED: [(&str, u64, Option<u64>); 24] = [
    ("-a 1 read 372", 1, None),
    ("-a 1 read 372@all 480-483", 5, None),
    ("-a 1 write 372@1=1400 --yes", 1, None),
    ("-a 1 dataset show 371 372", 2, None),
    ("-a 1 identify", 0, None),
    ("-a 1 diag", 0, None),
    ("-a 1 diag line --count 9", 9, None),
    // As many settings as the catalogue has of an ACT.
    ("-a 1 report --changed --count 9", 125, None),
    ("-a 1 monitor 372 411 --count 2 --unpaced", 4, None),
    ("-a 1 line set --baud 9600 --yes", 0, None),
    ("-a 1 protocol show", 0, None),
    ("-a 1 systembus show", 77, None),
    ("systembus check {dir}/bus.toml drive-1=1 --drive act", 48, None),
    ("-a 1 statemachine", 0, None),
    // It has gone out in the first second; the rest proves nothing.
    ("-a 1 statemachine quick-stop", 0, Some(20)),
    ("-a 1 sollwert", 0, None),
    ("-a 1 sollwert 5Hz --yes", 0, None),
    ("-a 1 sollwert 5Hz --yes --enable --hold --duration 1s", 0, None),
    ("scan --address 1-3", 3, None),
    ("init --address 1-3 {dir}/new.toml", 3, None),
    ("plan --config {dir}/plant.toml", 2, None),
    ("apply --yes --config {dir}/plant.toml", 2, None),
    ("check --config {dir}/plant.toml", 2, None),
    ("-a 1 procedure first-contact --yes --record {dir}/first.json", 0, None),
];

/// What a plant is to have.
const PLANT: &str = "[drives.pump]\naddress = 1\nfiles = [\"base.toml\"]\n";
const BUS: &str = include_str!("../../../docs/examples/system-bus-setpoint.toml");
const BASE: &str = "antrieb = 1\ndrive.family = \"act\"\n[values]\n\"372@1\" = 1440\n\"480@2\" = 7\n";

/// Every verb that asks a drive is in the table.
#[test]
fn every_verb_that_asks_has_an_upper_time_that_is_tried() {
    let tried = |name: &str| TYPED.iter().any(|row| row.0.split(' ').any(|word| word == name));
    for verb in VERBS {
        assert_eq!(tried(verb.name), verb.upper != Upper::OFFLINE, "{}", verb.name);
        let help = antrieb(&format!("{} --help", verb.name)).exits(0).out;
        assert_eq!(help.contains("Upper time, whatever comes over the line: "), tried(verb.name), "{}", verb.name);
    }
}

#[test]
fn every_verb_ends_within_its_upper_time_whatever_the_line_is_like() {
    let (mut longest, mut sins) = (Span::ZERO, Vec::new());
    for protocol in ["rtu", "vabus"] {
        let spoken: Protocol = protocol.parse().unwrap();
        let price = Price::of(&Limits::default(), spoken, spoken.line(19_200, Parity::Even));
        // Over VABus what it adds: its digits, its repeats, its end of exchange.
        let own = ["digits", "twins", "late"];
        for (name, bad) in BAD.into_iter().filter(|row| protocol == "rtu" || own.contains(&row.0)) {
            let bench = format!(
                "[[drive]]\nmodel = \"act\"\nprotocol = \"{protocol}\"\nset = {{ \"412\" = 1 }}\n[[disturb]]\n{bad}\n"
            );
            for (verb, count, sooner) in TYPED {
                let upper = VERBS.iter().find(|row| verb.split(' ').any(|word| word == row.name)).unwrap().upper;
                let most = sooner.map_or(upper.span(price, count), Span::from_secs);
                let run = antrieb(&format!("--protocol {protocol} {verb}")).on(&bench);
                let run = run.file("plant.toml", PLANT).file("base.toml", BASE).file("bus.toml", BUS).run();
                let took = witness::left().map_or(Span::ZERO, |(_, now)| now.since(Tick::ZERO));
                println!("{protocol} {name}: {verb}: exit {}, {took} of {most}", run.exit);
                assert!(run.exit != 101 && run.exit != 2, "{protocol} {name} {verb}: {}", run.err);
                if took > most {
                    sins.push(format!("{protocol} {name}: {verb}: {took} of {most}"));
                }
                longest = longest.max(took);
            }
        }
    }
    println!("longest: {longest}");
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

#[test]
fn a_scan_of_a_line_that_is_never_silent_does_not_say_that_nobody_is_there() {
    for verb in ["scan -a 2-4", "scan -a 2-4 --baud auto"] {
        let bench = format!("[[drive]]\nmodel = \"act\"\naddress = 9\n[[disturb]]\n{}\n", BAD[0].1);
        let document = antrieb(verb).on(&bench).json();
        let error = &document.value["error"];
        assert_eq!((document.exit, error["code"].as_str()), (5, Some("garbled.never_silent")), "{verb}");
        let is_blamed = document.value["warnings"].to_string().contains("scan.garbage");
        assert!(!is_blamed || verb.contains("auto"), "nobody knows whose garbage it is");
    }
}
