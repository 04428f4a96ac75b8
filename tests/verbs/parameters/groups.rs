//! `dataset` of several drives at once: a row for each, and what is wrong with one costs the others nothing.

use crate::run::{Document, Run, antrieb};

/// Two ACTs; nobody else on the line.
const TWO: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\nset = { \"372@2\" = 1450, \"30\" = 210, \"392@4\" = 0 }\n\
                   [[drive]]\nmodel = \"act\"\naddress = 2\n";
const PLANT: &str = "[drives.fan]\naddress = 1\n[drives.pump]\naddress = 2\n";

fn both(line: &str) -> Run {
    antrieb(&format!("-a all {line}")).on(TWO).file("antrieb.toml", PLANT)
}

fn file(values: &str) -> String {
    format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}\n")
}

fn each(document: &Document, of: &str) -> Vec<String> {
    let drives = document.data("/drives").as_array().unwrap().iter();
    drives
        .map(|drive| format!("{} {}", drive["address"], drive.pointer(of).unwrap_or(&serde_json::Value::Null)))
        .collect()
}

#[test]
fn data_sets_of_several_drives_are_shown_each_for_itself() {
    let shown = both("dataset show 372").json().exits(0);
    assert_eq!(each(&shown, "/rows/0/equal"), ["1 false", "2 true"]);
    assert_eq!(each(&both("dataset active").json().exits(0), "/active"), ["1 1", "2 1"]);
    let differ = both("dataset diff 1 2 372").json().exits(1);
    assert_eq!(each(&differ, "/rows/0/param"), ["1 372", "2 null"]);
    let told = differ.error()["message"].as_str().unwrap();
    assert!(told.contains("1 of 2 drives") && told.contains("drive 1"), "{told}");
    let page = both("dataset show 372").exits(0).out;
    assert!(page.contains("drive 1 (act)") && page.contains("drive 2 (act)"), "{page}");
    let csv = both("--format csv dataset show 372").exits(0).out;
    assert_eq!(csv.lines().filter(|line| line.contains("372")).count(), 8, "{csv}");
}

#[test]
fn who_is_silent_has_a_row_and_costs_the_others_nothing() {
    let shown = antrieb("-a 1,7,2 dataset show 372").on(TWO).json().exits(9);
    assert_eq!(each(&shown, "/error/class"), ["1 null", "7 \"silence\"", "2 null"]);
    let csv = antrieb("-a 1,7,2 --format csv dataset show 372").on(TWO).exits(9).out;
    assert!(csv.contains("\n7,") && csv.contains("no reply"), "{csv}");
    antrieb("-a 7,8 dataset active").on(TWO).json().exits(4);
    // A write is looked at whole before anybody is asked.
    let select = antrieb("-a 1,7 -v --yes dataset select 2").on(TWO).exits(4);
    assert!(!select.sent().iter().any(|sent| sent.starts_with("01 06")), "{}", select.err);
}

#[test]
fn a_data_set_is_selected_and_copied_in_several_drives_behind_one_question() {
    let selected = both("--yes dataset select 3").json().exits(0);
    assert_eq!(each(&selected, "/active"), ["1 3", "2 3"]);
    assert_eq!(each(&selected, "/written/0/result"), ["1 \"verified\"", "2 \"verified\""]);
    let asked = both("dataset select 3").answered("n").exits(8).err;
    assert_eq!(asked.matches("[y/N]").count(), 1, "{asked}");
    assert!(asked.contains("drive 1") && asked.contains("drive 2"), "{asked}");
    let nobody = both("dataset select 3").json().exits(8);
    assert_eq!(each(&nobody, "/written/0/result"), ["1 \"skipped\"", "2 \"skipped\""]);
    let copied = both("--yes dataset copy 2 3 372").json().exits(0);
    assert_eq!(each(&copied, "/written/0/result"), ["1 \"verified\"", "2 \"unchanged\""]);
    let planned = both("--dry-run dataset select 3").json().exits(0);
    assert_eq!(planned.data("/values").as_array().unwrap().len(), 2);
}

#[test]
fn files_and_factory_settings_are_held_against_several_drives() {
    let drives = both("dataset diff factory drive 30 392").json().exits(1);
    let sides: Vec<_> = (0..2).map(|nth| drives.data(&format!("/comparisons/{nth}/b/address")).clone()).collect();
    assert_eq!(sides, [1, 2]);
    assert_eq!(drives.data("/comparisons/1/equal"), true);
    let more = antrieb("-a 1,1,2 dataset diff factory drive").on(&TWO.replacen(
        "address = 2",
        "address = 2\nset = { \"30\" = 220 }",
        1,
    ));
    assert!(more.exits(1).err.contains("values differ"));
    let held =
        antrieb("-a 1,7,2 dataset diff {dir}/f.toml 2").on(TWO).file("f.toml", &file("372 = 1450")).json().exits(9);
    assert_eq!(held.data("/comparisons/0/equal"), true);
    assert_eq!(held.data("/comparisons/1/error/class"), "silence");
    assert_eq!(held.data("/comparisons/2/equal"), false);
}

#[test]
fn one_file_goes_into_several_drives_each_a_transaction() {
    let load = |line: &str| both(line).file("f.toml", &file("372 = 1440"));
    let asked = load("dataset load {dir}/f.toml").answered("n").exits(8).err;
    assert_eq!(asked.matches("[y/N]").count(), 1, "{asked}");
    let done = load("--yes dataset load {dir}/f.toml").json().exits(0);
    assert_eq!(each(&done, "/state"), ["1 \"done\"", "2 \"done\""]);
    assert_eq!(each(&done, "/called"), ["1 \"fan\"", "2 \"pump\""]);
    let run = load("--yes dataset load {dir}/f.toml").columns(200).exits(0);
    for drive in ["1", "2"] {
        let undo = run.directory().join(format!("f-{drive}.undo.toml"));
        assert!(undo.exists(), "{}", undo.display());
    }
    assert!(run.page().contains("-a fan dataset undo"), "{}", run.out);
    let planned = load("--dry-run dataset load {dir}/f.toml").json().exits(0);
    assert_eq!(each(&planned, "/dry_run"), ["1 true", "2 true"]);
    let own = both("--yes dataset load '{dir}/f-{address}.toml'")
        .file("f-1.toml", &file("372 = 1441"))
        .file("f-2.toml", &file("372 = 1442"));
    assert_eq!(each(&own.json().exits(0), "/values/0/raw"), ["1 1441", "2 1442"]);
}

#[test]
fn a_drive_that_cannot_be_loaded_is_named_and_the_others_are() {
    let load = |line: &str| antrieb(line).on(TWO).file("f.toml", &file("372 = 1440"));
    let done = load("-a 1,7,2 --yes dataset load {dir}/f.toml").json().exits(9);
    assert_eq!(each(&done, "/state"), ["1 \"done\"", "7 \"skipped\"", "2 \"done\""]);
    load("-a 7,8 --yes dataset load {dir}/f.toml").json().exits(4);
    // One name is no two files.
    let one = load("-a 1,2 --yes dataset load {dir}/f.toml --undo-file {dir}/u.toml").exits(2);
    assert!(one.err.contains("{address}"), "{}", one.err);
    load("-a 1,2 --yes dataset load {dir}/f.toml --undo-file '{dir}/u-{address}.toml'").exits(0);
}

#[test]
fn what_one_drive_alone_can_do_says_what_to_type_for_one() {
    let undo = file("372 = 1440");
    for (line, typed) in [
        ("dataset undo {dir}/f.toml", "dataset undo"),
        ("statemachine enable", "statemachine enable"),
        ("statemachine goto switched-on", "statemachine goto switched-on"),
        ("sollwert 5Hz", "sollwert 5Hz"),
    ] {
        let refused = antrieb(&format!("-a 1,2 --yes {line}")).on(TWO).file("f.toml", &undo).exits(2).err;
        assert!(refused.contains("hint:") && refused.contains("-a 1 ") && refused.contains(typed), "{refused}");
        let german = antrieb(&format!("-a 1,2 --lang de --yes {line}")).on(TWO).file("f.toml", &undo).exits(2).err;
        assert!(german.contains("Hinweis:") && german.contains("-a 1 ") && german.contains(typed), "{german}");
    }
}
