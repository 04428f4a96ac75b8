//! `scan`, `identify`, `diag`, `statemachine`, `sollwert`: who is on the line, how it is, and what the line does to it.

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

/// An ACU with a fault and three warnings.
const ILL: &str = "[[drive]]\nmodel = \"acu\"\naddress = 2\n\
                   [[drive.event]]\nat = \"0s\"\nfault = \"F2105\"\nwarning = 0x0083\n";

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
    let mut context =
        Context { settings: &settings, registry: &registry, ask: &mut NobodyAsked, observe: &mut observe, interrupt };
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    let outcome = runtime.block_on(scan::run(&scan::Args::default(), &mut context)).unwrap();
    let failure = outcome.failure.unwrap();
    assert_eq!((failure.class, failure.class.exit()), (Class::Interrupted, 130));
    assert!(failure.message.contains("1 of 247 addresses were asked"), "{failure}");
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
    assert_eq!(run.sent().len(), 1, "{}", run.err);
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

#[test]
fn identify_tells_family_settings_and_modules() {
    let document = antrieb("-p sim -a 1,2 identify").json().exits(0);
    assert_eq!(document.data("/drives/0/drive"), "act");
    assert_eq!(document.data("/drives/1/drive"), "acu");
    let params: Vec<_> =
        document.data("/drives/1/values").as_array().unwrap().iter().map(|value| value["param"].clone()).collect();
    assert_eq!(params, [1376, 395, 10, 1375, 413, 412, 30, 249, 414]);
    assert_eq!(document.data("/drives/1/values/1/text"), "Modbus RTU");
    assert_eq!(document.data("/drives/0/modules/0/present"), false);
    assert_eq!(document.data("/drives/1/modules/0/present"), true);
    let named = antrieb("-p sim -a 2 --drive acu identify").json().exits(0);
    assert_eq!(named.data("/drives/0/evidence/0/asked"), "--drive");
}

#[test]
fn an_acu_without_mains_is_still_an_acu() {
    let dark = "[[drive]]\nmodel = \"acu\"\naddress = 2\nmains = false\n";
    let document = antrieb("-a 2 identify").on(dark).json().exits(0);
    assert_eq!(document.data("/drives/0/drive"), "acu");
    assert_eq!(document.data("/drives/0/evidence").as_array().unwrap().last().unwrap()["answered"], "P.11 = 3");
}

#[test]
fn a_fault_is_told_with_cause_and_remedy_and_every_warning_by_name() {
    let document = antrieb("-a 2 diag").on(ILL).json().exits(0);
    let drive = document.data("/drives/0");
    assert_eq!(drive["healthy"], false);
    assert_eq!(drive["status"]["state"]["slug"], "fault");
    assert_eq!((&drive["fault"]["key"], &drive["fault"]["node"]), (&json!("F2105"), &json!(5)));
    assert!(drive["fault"]["cause"].is_string() && drive["fault"]["remedy"].is_string());
    let bits = drive["warnings"]["bits"].as_array().unwrap();
    let set: Vec<_> = bits.iter().filter(|bit| bit["set"] == true).map(|bit| bit["slug"].as_str().unwrap()).collect();
    assert_eq!((bits.len(), set), (16, vec!["ixt", "ixt-short", "motor-temperature"]));
    assert_eq!(drive["counters"].as_array().unwrap().len(), 8);
    let german = antrieb("-a 2 --lang de diag").on(ILL).exits(0);
    for word in ["Störung", "Ursache", "Abhilfe", "Warnungen", "Fehlerregister"] {
        assert!(german.out.contains(word), "{word}: {}", german.out);
    }
    let scan = antrieb("scan").on(ILL).json().exits(0);
    assert!(scan.data("/drives/0/fault").as_str().unwrap().starts_with("F2105 "));
    assert_eq!(antrieb("-a 2 statemachine").on(ILL).json().exits(0).data("/drives/0/fault/code"), 0x2105);
}

#[test]
fn check_is_for_scripts() {
    assert_eq!(antrieb("-a 2 diag --check").on(ILL).json().exits(1).error()["code"], "no.fault_present");
    antrieb("-p sim -a 1,2 diag --check").json().exits(0);
    antrieb("-p sim -a 1,7 diag --check").json().exits(9);
}

#[test]
fn an_undocumented_fault_and_an_undefined_bit_are_shown() {
    let odd = "[[drive]]\nmodel = \"act\"\nset = { \"411\" = \"0x1023\" }\n\
               [[drive.event]]\nat = \"0s\"\nfault = \"F0999\"\n";
    let document = antrieb("-a 1 diag").on(odd).json().exits(0);
    assert_eq!(document.data("/drives/0/fault/key"), "F0999");
    assert_eq!(document.data("/drives/0/fault/cause"), &json!(null));
    assert_eq!(document.data("/drives/0/status/unknown"), &json!([12]));
}

#[test]
fn counters_are_cleared_only_after_asking() {
    let run = antrieb("-p sim -a 1 -v diag --clear").exits(8);
    assert_eq!(run.sent(), [""; 0]);
    let run = antrieb("-p sim -a 1 -v diag --clear").answered("n").exits(8);
    assert_eq!(run.sent(), [""; 0]);
    let document = antrieb("-p sim -a 1 diag --clear").answered("y").json().exits(0);
    assert_eq!(document.data("/drives/0/counters_cleared"), true);
    assert!(document.data("/drives/0/counters/0/count").as_u64().unwrap() > 0, "shown before they are lost");
}

#[test]
fn the_link_test_counts_and_measures() {
    let fine = antrieb("-p sim -a 1 diag --link-test 50").json().exits(0);
    let link = fine.data("/drives/0/link");
    assert_eq!((&link["asked"], &link["replies"], &link["error_rate_percent"]), (&json!(50), &json!(50), &json!(0.0)));
    assert!(link["fastest_us"].as_u64().unwrap() >= 10_000, "not before 10 ms (CM-485 manual 6.8)");
    let lossy = "[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = 4\nkind = \"lost\"\n";
    let lossy = antrieb("-a 1 diag --link-test 100").on(lossy).json().exits(0);
    let link = lossy.data("/drives/0/link");
    assert_eq!(link["replies"].as_u64().unwrap() + link["silent"].as_u64().unwrap(), 100);
    assert!(link["silent"].as_u64().unwrap() > 10, "{link}");
    assert!(link["error_rate_percent"].as_f64().unwrap() > 10.0, "{link}");
    for bad in ["0", "-1", "x"] {
        antrieb(&format!("-p sim -a 1 diag --link-test {bad}")).json().exits(2);
    }
}

#[test]
fn the_state_names_the_control_word_by_the_control_mode() {
    let bench = |mode: &str| format!("[[drive]]\nmodel = \"act\"\nset = {{ \"412\" = {mode} }}\n");
    let slugs = |mode: &str| {
        let document = antrieb("-a 1 statemachine").on(&bench(mode)).json().exits(0);
        assert_eq!(document.data("/drives/0/control_mode/param"), 412);
        let bits = document.data("/drives/0/control/bits").as_array().unwrap().clone();
        bits.iter().map(|bit| bit["slug"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    assert!(slugs("1").contains(&"enable-operation".to_owned()));
    assert!(slugs("2").contains(&"s1ind".to_owned()));
    assert_eq!(slugs("0"), [""; 0], "by contacts the word has no function");
    antrieb("-p sim -a 1 statemachine show").exits(0);
    assert_eq!(antrieb("-p sim -a 1 state").exits(0).out, antrieb("-p sim -a 1 statemachine").exits(0).out);
    assert_eq!(antrieb("-p sim -a 1 state").json().value["command"], "statemachine");
}

#[test]
fn setpoints_and_actual_values_stand_side_by_side() {
    let bench = "[[drive]]\nmodel = \"acu\"\nset = { \"228\" = \"12.5\", \"210\" = \"12.49\", \"434\" = 1 }\n";
    let document = antrieb("-a 1 sollwert").on(bench).json().exits(0);
    assert_eq!(document.data("/drives/0/setpoints/0/value"), 12.5);
    assert_eq!(document.data("/drives/0/actual/1/value"), 12.49);
    assert_eq!(document.data("/drives/0/sources/0/param"), 434);
    assert_eq!(antrieb("-a 1 setpoint").on(bench).json().value["command"], "sollwert");
}

#[test]
fn a_recording_can_be_replayed_offline() {
    let run = antrieb("-p sim -a 1 --trace {dir}/line.txt read 372@2 1600").exits(9);
    let trace = std::fs::read_to_string(run.directory().join("line.txt")).unwrap();
    assert!(trace.starts_with("# antrieb trace 1, 19200 8E1, rtu\n"), "{trace}");
    let decoded = antrieb("decode trace {dir}/line.txt").file("line.txt", &trace).json().exits(0);
    let telegrams = decoded.data("/telegrams").as_array().unwrap();
    assert_eq!(telegrams.len(), 14, "four questions tell the family: {trace}");
    assert!(telegrams.iter().all(|telegram| telegram["check_ok"] == true));
    assert!(telegrams.iter().any(|telegram| telegram["meaning"] == "address 1: read P.372@2 Rated Speed, 16 bit"));
    let last = telegrams.last().unwrap();
    assert_eq!((&last["direction"], &last["hex"]), (&json!("reply"), &json!("01 03 02 00 0B F9 83")));
    let bad = antrieb("decode trace {dir}/bad.txt").file("bad.txt", "# antrieb trace 1\nhello\n").json().exits(7);
    assert!(bad.error()["message"].as_str().unwrap().contains('2'), "names the line: {}", bad.error());
    antrieb("decode trace {dir}/none.txt").json().exits(7);
}

#[test]
fn a_bench_file_that_makes_no_sense_is_refused_with_its_place() {
    let document = antrieb("scan").on("[[drive]]\nmodel = \"act\"\naddress = 248\n").json().exits(7);
    assert!(document.error()["message"].as_str().unwrap().contains("bench.toml:3:11: address = 248"));
    antrieb("-p sim:{dir}/none.toml scan").json().exits(7);
}
