//! `dataset check` and `dataset diff` of files, drives and factory settings.

use crate::run::{Document, Output, antrieb};
use serde_json::Value;
use std::collections::BTreeSet;

/// Who saves, how it is spoken to, what was set, and how many values that is.
const CASES: &[(&str, &str, &str, usize)] = &[
    ("act", "rtu", "\"372@2\" = 1450, \"480\" = -12.5, \"419\" = 60", 3),
    ("act", "ascii", "\"372@2\" = 1450, \"480\" = -12.5, \"419\" = 60", 3),
    ("act", "vabus", "\"372@2\" = 1450, \"480\" = -12.5, \"419\" = 60", 3),
    ("acu", "rtu", "\"376@4\" = 1.5, \"481@1\" = 7, \"481@2\" = 7, \"481@3\" = 7, \"481@4\" = 7", 2),
    ("acu", "ascii", "\"376@4\" = 1.5, \"30\" = 210", 2),
    ("acu", "vabus", "\"376@4\" = 1.5, \"30\" = 210", 2),
    ("lxm05", "rtu", "RAMPacc = 500, HMn = 61", 2),
];

fn bench(model: &str, protocol: &str, set: &str) -> String {
    format!("[[drive]]\nmodel = \"{model}\"\nprotocol = \"{protocol}\"\naddress = 1\nset = {{ {set} }}\n")
}

#[track_caller]
fn saved(model: &str, protocol: &str, set: &str) -> Output {
    antrieb(&format!("--protocol {protocol} -a 1 dataset save {{dir}}/pump.toml"))
        .on(&bench(model, protocol, set))
        .exits(0)
}

fn differences(document: &Document) -> Vec<String> {
    let rows = document.data("/comparisons/0/differences").as_array().unwrap();
    let told = |row: &Value| format!("{}@{} {} {}", row["param"], row["data_set"], row["a_raw"], row["b_raw"]);
    let mut told: Vec<_> = rows.iter().map(told).collect();
    told.sort_unstable();
    told
}

#[test]
fn a_drive_is_checked_against_its_file_and_a_factory_reset_shows() {
    for (model, protocol, set, count) in CASES {
        let check = format!("--protocol {protocol} -a 1 dataset check {{dir}}/pump.toml");
        let same = saved(model, protocol, set).then(&check).on(&bench(model, protocol, set)).json().exits(0);
        assert_eq!(same.data("/comparisons/0/equal"), true, "{model} {protocol}");
        let signatures = ["a", "b"].map(|side| same.data(&format!("/comparisons/0/{side}/signature")).clone());
        assert_eq!(signatures[0], signatures[1]);
        // Back at its factory settings.
        let reset = saved(model, protocol, set).then(&check).on(&bench(model, protocol, "")).json().exits(1);
        assert_eq!(differences(&reset).len(), *count, "{model} {protocol}: {:#}", reset.value);
        assert_eq!(reset.error()["code"], "no.differences");
    }
}

#[test]
fn a_check_asks_what_the_file_holds_and_nothing_else() {
    let hand = "antrieb = 1\ndrive.family = \"act\"\n[values]\n372 = 1390\n\"480@2\" = \"5 Hz\"\n";
    let line = "-a 1 -v dataset check {dir}/hand.toml";
    let run = antrieb(line).on(&bench("act", "rtu", "")).file("hand.toml", hand).exits(0);
    let sent = run.sent();
    let asked =
        sent.iter().skip_while(|sent| !sent.starts_with("01 03 01 74")).filter(|sent| !sent.starts_with("01 08"));
    // As stored, and as in force; the first that is the same is asked for twice.
    let asked: BTreeSet<_> = asked.collect();
    assert_eq!(asked.len(), 4, "{}", run.err);
    let differing = bench("act", "rtu", "\"372@3\" = 1500, \"480@2\" = 6, \"480@3\" = 7");
    let document = antrieb(line).on(&differing).file("hand.toml", hand).json().exits(1);
    assert_eq!(differences(&document), ["372@3 1390 1500", "480@2 500 600"]);
    assert_eq!(document.data("/comparisons/0/compared"), 5);
}

#[test]
fn a_file_that_was_changed_by_hand_is_told_from_one_that_was_not() {
    let set = "\"372\" = 1450";
    let run = saved("act", "rtu", set);
    let text = run.text_of("pump.toml");
    assert!(text.contains("\"372\" = \"1450 1/min\""));
    let touched = text.replace("1450 1/min", "1460 1/min");
    let check = "-a 1 dataset check {dir}/pump.toml";
    let document = run.then(check).on(&bench("act", "rtu", set)).file("pump.toml", &touched).json().exits(1);
    assert_eq!((document.data("/comparisons/0/a/edited"), document.warnings()), (&true.into(), vec!["file.edited"]));
    // Other remarks and another order are no change.
    let turned = text.replace("# rated-speed", "# turned over").replace("# Parameters of a drive", "# Mine");
    let document = antrieb(check).on(&bench("act", "rtu", set)).file("pump.toml", &turned).json().exits(0);
    assert_eq!((document.data("/comparisons/0/a/edited"), document.warnings().len()), (&false.into(), 0));
}

/// What a file lacks takes nothing from what differs in what it holds.
#[test]
fn a_file_that_is_not_whole_and_differs_is_not_said_to_be_the_same() {
    let part = |value: u32| {
        format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[saved]\ncomplete = false\n[values]\n\"480\" = {value}\n")
    };
    for line in ["-a 1 dataset check {dir}/f.toml", "-a 1 dataset diff {dir}/f.toml drive"] {
        let told = antrieb(line).on(&bench("act", "rtu", "")).file("f.toml", &part(8)).exits(1);
        assert!(!told.out.contains("nothing differs") && told.err.contains("is what an interrupted save has left"));
        let same = antrieb(line).on(&bench("act", "rtu", "")).file("f.toml", &part(5)).exits(9);
        assert!(same.out.contains("nothing differs as far as"), "{}", same.out);
    }
    // What has nothing to be compared is no difference.
    let empty = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n";
    let none = antrieb("-a 1 dataset diff {dir}/f.toml drive").on(&bench("act", "rtu", "")).file("f.toml", empty);
    assert_eq!(none.json().exits(7).error()["code"], "data.no_common");
}

#[test]
fn what_is_broken_of_another_family_or_newer_is_refused_before_anything_is_asked() {
    let on = bench("act", "rtu", "");
    let case = |text: &str| {
        let run = antrieb("-v -a 1 dataset check {dir}/f.toml").on(&on).file("f.toml", text).json().exits(7);
        (run.error()["code"].as_str().unwrap().to_owned(), run.error()["message"].as_str().unwrap().to_owned())
    };
    let (code, message) = case("antrieb = 1\ndrive.family = \"act\"\n[values]\n372 = \"fast\"\n");
    assert!(code == "data.parameter_file" && message.contains("f.toml:4:7: 'fast'"), "{message}");
    assert_eq!(case("antrieb = 7\n").0, "data.newer_format");
    assert_eq!(case("antrieb = 1\ndrive.family = \"acx\"\n[values]\n").0, "data.unknown_family");
    let (code, message) = case("antrieb = 1\ndrive.family = \"acu\"\n[values]\n372 = 1\n");
    assert!(code == "data.other_family" && message.contains("the drive is of the family act"), "{message}");
    let other = antrieb("-a 1 dataset check {dir}/f.toml").on(&on);
    let other = other.file("f.toml", "antrieb = 1\ndrive.family = \"acu\"\n[values]\n372 = 1\n");
    let shown = other.exits(7).out;
    assert!(shown.contains("drive 1 (act)") && !shown.contains("compared") && !shown.contains("different"), "{shown}");
    assert_eq!(
        antrieb("-p sim -a 1 dataset check {dir}/none.toml").json().exits(7).error()["code"],
        "data.parameter_file"
    );
}

#[test]
fn sides_are_sets_files_drives_and_factory_settings() {
    let old = "antrieb = 1\ndrive.family = \"act\"\n[values]\n372 = 1390\n480 = 5\n376 = 0.8\n";
    let new = "antrieb = 1\ndrive.family = \"act\"\n[values]\n372 = 1450\n\"480@2\" = 6\n480 = 5\n400 = 4\n";
    let diff = |line: &str| {
        let on = bench("act", "rtu", "\"372@2\" = 1450, \"400\" = 8, \"419\" = 60, \"480@2\" = 6, \"480@2ram\" = 9");
        antrieb(&format!("dataset diff {line}")).on(&on).file("old.toml", old).file("new.toml", new).json()
    };
    let of = |line: &str| differences(&diff(line).exits(1));
    assert_eq!(
        of("{dir}/old.toml {dir}/new.toml"),
        ["372@0 1390 1450", "376@0 8 null", "400@0 null 4", "480@2 500 600"]
    );
    assert_eq!(of("{dir}/old.toml {dir}/new.toml 480"), ["480@2 500 600"]);
    assert_eq!(of("factory {dir}/new.toml"), ["400@0 2 4", "480@2 500 600"]);
    assert_eq!(of("-a 1 factory drive"), ["395@0 0 2", "400@0 2 8", "419@0 5000 6000", "480@2 500 600"]);
    assert_eq!(of("drive:1 {dir}/new.toml"), ["372@1 1390 1450", "372@3 1390 1450", "372@4 1390 1450", "400@0 8 4"]);
    assert_eq!(of("-a 1 {dir}/old.toml 2"), ["372@2 1390 1450", "480@2 500 600"]);
    assert_eq!(of("-a 1 2ram {dir}/new.toml 480"), ["480@2 900 600"]);
    assert_eq!(of("-a 1 factory 2 480"), ["480@2 500 600"]);
    diff("-a 1 drive {dir}/new.toml 480").exits(0);
    diff("-a 1 1 3").exits(0);
    let sets = diff("-a 1 2 2ram 480 372").exits(1);
    assert_eq!(sets.data("/rows/0/values/1/store"), "ram");
    for (line, code) in [
        ("drive:0 factory", 2),
        ("factory factory", 2),
        ("-a 1 5 {dir}/new.toml", 2),
        ("-a 1 drive nowhere", 7),
        ("{dir}/old.toml {dir}/new.toml 411", 7),
    ] {
        diff(line).exits(code);
    }
}

#[test]
fn two_drives_are_compared() {
    let two = "[[drive]]\nmodel = \"act\"\naddress = 1\nset = { \"372@2\" = 1450 }\n[[drive]]\nmodel = \"act\"\naddress = 2\n";
    let document = antrieb("dataset diff drive:1 drive:2").on(two).json().exits(1);
    assert_eq!(differences(&document), ["1376@0 1 2", "372@2 1450 1390"]);
    let mixed = antrieb("-p sim dataset diff drive:1 drive:2").json().exits(7);
    assert_eq!(mixed.error()["code"], "data.other_family");
}

#[test]
fn differences_are_shown_as_lines_that_can_be_replayed() {
    let old = "antrieb = 1\ndrive.family = \"act\"\n[values]\n372 = 1390\n480 = 5\n";
    let line = "-a 1 dataset check --unified {dir}/old.toml";
    let run = antrieb(line).on(&bench("act", "rtu", "\"480@2\" = 6")).file("old.toml", old).exits(1);
    let told: Vec<_> = run.out.lines().skip(2).collect();
    assert_eq!(
        told,
        [
            "@@ @setpoints @@",
            "-\"480@2\" = \"5.00 Hz\"  # Fixed Frequency 1",
            "+\"480@2\" = \"6.00 Hz\"  # Fixed Frequency 1"
        ]
    );
}

#[test]
fn what_a_drive_does_not_answer_is_neither_the_same_nor_different() {
    let silent = format!("{}[[drive.event]]\nat = \"300ms\"\nsilent = \"10h\"\n", bench("act", "rtu", "\"30\" = 210"));
    let set = saved("act", "rtu", "\"30\" = 210").then("-a 1 dataset check {dir}/pump.toml").on(&silent).json();
    let document = set.exits(9);
    assert_eq!(document.error()["class"], "partial");
    assert!(document.data("/comparisons/0/differences").as_array().is_some());
}
