//! `scan`: who is on the line, and what the line does to the search.

use crate::run::antrieb;
use antrieb::args::{Addresses, Globals, Settings};
use antrieb::command::{Context, scan};
use antrieb::drive::Interrupt;
use antrieb::failure::Class;
use antrieb::gate::{Ask, Question, Reply};
use antrieb::outcome::{Data, Event};
use antrieb::profile::Registry;
use serde_json::json;

const FOREIGN: &str = "[[drive]]\nmodel = \"acu\"\naddress = 2\n\
                       [[drive]]\nmodel = \"foreign\"\naddress = 9\nregisters = { \"0\" = 17, \"411\" = 5 }\n\
                       [[drive]]\nmodel = \"foreign\"\naddress = 200\n";

/// One drive at 1, and every reply of it disturbed in the same way.
fn disturbed(kind: &str) -> String {
    format!("[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = 1\nkind = \"{kind}\"\n")
}

#[test]
fn the_scan_asks_247_addresses_and_is_the_same_every_time() {
    let first = antrieb("-p sim -v scan --json").exits(0);
    let second = antrieb("-p sim -v scan --json").exits(0);
    assert_eq!(first.out, second.out);
    assert_eq!(first.err, second.err, "every telegram, at the same time");
    let stations: std::collections::BTreeSet<String> = first.sent().iter().map(|hex| hex[..2].to_owned()).collect();
    assert_eq!(stations.len(), 247);
    let table = antrieb("-p sim scan").exits(0);
    assert_eq!(table.out, antrieb("-p sim scan").exits(0).out);
    assert_eq!(table.rows().len(), 2);
}

#[test]
fn a_scan_lists_drives_with_the_evidence() {
    let document = antrieb("-p sim scan").json().exits(0);
    assert_eq!(document.data("/asked"), 247);
    assert_eq!(document.data("/complete"), true);
    assert_eq!(document.data("/line"), "19200 8E1");
    let found: Vec<_> =
        document.data("/drives").as_array().unwrap().iter().map(|d| (&d["address"], &d["drive"])).collect();
    assert_eq!(found, [(&json!(1), &json!("act")), (&json!(2), &json!("acu"))]);
    assert!(document.data("/drives/0/evidence").as_array().unwrap().len() >= 2);
    assert_eq!(document.data("/drives/1/state/slug"), "switched-on");
}

#[test]
fn a_modbus_device_that_is_no_known_drive_is_listed_with_what_it_answered() {
    for (options, bench) in
        [("", FOREIGN.to_owned()), ("--protocol ascii", FOREIGN.replace("address", "protocol = \"ascii\"\naddress"))]
    {
        let document = antrieb(&format!("{options} scan")).on(&bench).json().exits(0);
        let unknown = document.data("/drives/1");
        assert_eq!((&unknown["address"], &unknown["drive"]), (&json!(9), &json!("unknown")));
        let answers: Vec<_> =
            unknown["evidence"].as_array().unwrap().iter().map(|row| row["answered"].as_str().unwrap()).collect();
        assert_eq!(answers, ["0x0005", "exception 1 (illegal function)", "exception 1 (illegal function)"]);
        assert_eq!(document.data("/drives/2/address"), 200, "it refuses every question, but it is there");
        assert_eq!(document.data("/drives/2/drive"), "unknown");
    }
    let table = antrieb("--lang de scan").on(FOREIGN).exits(0);
    assert!(table.out.contains("Modbus-Gerät, kein bekannter Antrieb"), "{}", table.out);
}

#[test]
fn other_verbs_say_that_it_is_no_drive_that_they_know() {
    for verb in ["read 372", "diag", "statemachine", "sollwert", "dataset active", "--yes write 372=1"] {
        let document = antrieb(&format!("-a 9 {verb}")).on(FOREIGN).json().exits(7);
        assert_eq!(document.error()["code"], "data.unknown_drive", "{verb}");
        assert!(document.error()["hint"].as_str().unwrap().contains("--drive"), "{verb}");
    }
    let document = antrieb("-a 9 identify").on(FOREIGN).json().exits(0);
    assert_eq!(document.data("/drives/0/drive"), "unknown");
    assert_eq!(document.data("/drives/0/evidence").as_array().unwrap().len(), 3);
}

#[test]
fn who_has_no_time_to_say_what_it_is_may_be_a_drive() {
    let busy = "[[drive]]\nmodel = \"foreign\"\nbusy = true\n";
    let document = antrieb("-a 1 read 372").on(busy).json().exits(6);
    assert_eq!(document.error()["code"], "refused.busy");
    assert!(document.error()["hint"].as_str().unwrap().contains("exception 6"), "{}", document.error());
}

#[test]
fn only_the_addresses_that_were_named_are_asked() {
    let run = antrieb("-p sim -v -a 2,5-7 scan").exits(0);
    let stations: std::collections::BTreeSet<&str> =
        run.err.lines().filter_map(|line| Some(&line.split_once(" ms > ")?.1[..2])).collect();
    assert_eq!(stations.into_iter().collect::<Vec<_>>(), ["02", "05", "06", "07"]);
}

#[test]
fn nobody_on_the_line_is_a_no_with_what_to_check() {
    let document = antrieb("-p sim -a 100-120 scan").json().exits(1);
    assert_eq!(document.data("/drives"), &json!([]));
    assert!(document.error()["hint"].as_str().unwrap().contains("VABus"));
    for settings in ["--baud 9600", "--parity odd", "--protocol ascii", "--parity none"] {
        antrieb(&format!("-p sim {settings} -a 1-2 scan")).json().exits(1);
    }
    let vabus = "[[drive]]\nmodel = \"act\"\nprotocol = \"vabus\"\n";
    antrieb("scan").on(vabus).json().exits(1);
}

#[test]
fn an_interrupted_scan_leaves_an_honest_part() {
    struct NobodyAsked;
    impl Ask for NobodyAsked {
        fn ask<'a>(&'a mut self, _: &'a Question) -> Reply<'a> {
            unreachable!("a scan asks nobody")
        }
        fn is_there(&self) -> bool {
            false
        }
    }
    let environment = antrieb::args::Environment::default();
    let flags = Globals { port: vec!["sim".parse().unwrap()], ..Globals::default() };
    let mut settings = Settings::resolve(&flags, &environment).unwrap();
    settings.addresses = Addresses::Unnamed;
    let registry = Registry::open(&[]).unwrap();
    let interrupt = Interrupt::default();
    let pressed = interrupt.clone();
    let mut observe = |event| {
        if matches!(&event, Event::Found(drive) if drive.address == 1) {
            pressed.raise();
        }
    };
    let mut context = Context {
        settings: &settings,
        registry: &registry,
        ask: &mut NobodyAsked,
        observe: &mut observe,
        interrupt,
        sheet: antrieb::render::sheet,
        calls: None,
    };
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    let outcome = runtime.block_on(scan::run(&scan::Args::default(), &mut context)).unwrap();
    let failure = outcome.failure.unwrap();
    assert_eq!((failure.class, failure.class.exit()), (Class::Interrupted, 130));
    assert!(failure.to_string().contains("1 of 247 addresses had their full time to answer"), "{failure}");
    let Some(Data::Scan(found)) = outcome.data else { panic!("no data") };
    assert_eq!((found.complete, found.asked, found.drives.len()), (false, 1, 1));
}

#[test]
fn a_slow_drive_is_not_taken_for_silent() {
    // Over 500 ms at CPU load above 90 % (CM-485 manual 6.8).
    let slow = "[[drive]]\nmodel = \"act\"\nload = \"high\"\n";
    assert_eq!(antrieb("-a 1 read 372").on(slow).json().exits(0).data("/values/0/value"), 1390);
    let document = antrieb("-a 1 read 1600").on(slow).json().exits(6);
    assert_eq!(document.error()["context"]["p11"], "11", "the cause survives repeated questions");
    let run = antrieb("-a 1 --timeout 1s -v --drive act read 372").on(slow).exits(0);
    assert_eq!(run.questions().len(), 1, "{}", run.err);
    antrieb("-a 1 --timeout 1s scan").on(slow).json().exits(0);
}

#[test]
fn a_bad_line_costs_repeats_and_no_truth() {
    for kind in ["late", "lost", "garbled", "truncated", "noise", "doubled", "foreign", "echo"] {
        let bench = format!("[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = 3\nkind = \"{kind}\"\n");
        let document = antrieb("-a 1 read 372@2 481 376 260 412 418").on(&bench).json().exits(0);
        let raws: Vec<_> =
            document.data("/values").as_array().unwrap().iter().map(|value| value["raw"].clone()).collect();
        assert_eq!(raws, [1390, 1000, 8, 0, 44, 350], "{kind}");
    }
}

#[test]
fn garbage_alone_is_called_garbage() {
    for kind in ["garbled", "truncated"] {
        let document = antrieb("-a 1 read 372").on(&disturbed(kind)).json().exits(5);
        assert_eq!(document.error()["code"], "garbled.no_valid_reply", "{kind}");
        assert!(document.error()["context"]["bytes"].is_string());
    }
    let document = antrieb("-a 1-3 scan").on(&disturbed("garbled")).json().exits(1);
    assert_eq!(document.warnings(), ["scan.garbage"]);
}

#[test]
fn a_line_that_echoes_is_understood() {
    let echo = "[line]\necho = true\n[[drive]]\nmodel = \"act\"\n";
    assert_eq!(antrieb("-a 1 read 372").on(echo).json().exits(0).data("/values/0/value"), 1390);
    let document = antrieb("-a 1 --yes write 480@1=6").on(echo).json().exits(0);
    assert_eq!(document.data("/values/0/result"), "verified");
}
