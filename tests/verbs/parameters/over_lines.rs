//! `-a all` and `-a @group` of verbs that read, over the ports of a plant.

use super::plant::{ONE, TWO, plant};
use crate::run::antrieb;
use antrieb::transport::witness;
use serde_json::Value;

const GONE: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive.event]]\nat = \"0s\"\nsilent = \"5min\"\n";

/// The drives of a list, by name and port: `a1 left`.
fn named(list: &Value) -> Vec<String> {
    let port = |row: &Value| row["port"].as_str().unwrap().rsplit('/').next().unwrap().replace(".bench", "");
    let rows = list.as_array().unwrap().iter();
    rows.map(|row| format!("{} {}", row["called"].as_str().unwrap(), port(row))).collect()
}

const ALL: [&str; 5] = ["a1 left", "a2 left", "b1 middle", "b2 middle", "c3 right"];

#[test]
fn what_reads_goes_over_every_port_and_names_each_drive_with_its_port() {
    for (verb, list, code) in [
        ("read 372@1", "/values", 0),
        ("identify", "/drives", 0),
        ("diag", "/drives", 0),
        ("diag --check", "/drives", 0),
        ("statemachine show", "/drives", 0),
        ("sollwert", "/drives", 0),
        ("dataset show 372", "/drives", 0),
        ("dataset active", "/drives", 0),
        ("dataset diff 1 2", "/drives", 0),
        ("dataset diff factory drive", "/comparisons", 1),
        ("dataset check {dir}/{name}.toml", "/comparisons", 1),
        ("dataset save {dir}/{name}-is.toml", "/saved", 0),
        ("read 372 --dry-run", "/telegrams", 0),
    ] {
        let run = |format: &str| {
            let run = plant(&format!("-a a1,b1 {format} {verb}"), [TWO, TWO, ONE]);
            let at = run.directory().to_owned();
            let copy = |name: &str| std::fs::copy(at.join("act.toml"), at.join(name)).unwrap();
            copy("a1.toml");
            copy("b1.toml");
            run
        };
        let told = run("").json().exits(code);
        assert_eq!(named(told.data(list)), ["a1 left", "b1 middle"], "{verb}");
        for lang in ["en", "de"] {
            let page = run(&format!("--lang {lang}")).columns(80).exits(code).out;
            assert!(["left.bench", "a1", "b1"].iter().all(|word| page.contains(word)), "{verb}: {page}");
        }
        let rows = run("--format csv").exits(code).out;
        assert!(rows.starts_with("called,port,"), "{verb}: {rows}");
    }
    let all = plant("-a all identify", [TWO, TWO, ONE]).json().exits(0);
    assert_eq!(named(all.data("/drives")), ALL);
    let lines = plant("-a all diag line --count 5", [TWO, TWO, ONE]).json().exits(0);
    assert_eq!(lines.data("/lines").as_array().unwrap().len(), 3);
    let found = plant("-a all scan", [TWO, TWO, ONE]).json().exits(0);
    assert_eq!(found.data("/drives").as_array().unwrap().len(), 5);
    plant("-a @ones line show", [TWO, TWO, ONE]).exits(0);
    plant("-a @ones protocol show", [TWO, TWO, ONE]).exits(0);
    let rows = plant("-a all --format ndjson sollwert", [TWO, TWO, ONE]).exits(0).out;
    assert!(rows.contains("\"called\":\"b2\",\"port\":"), "{rows}");
}

/// As on one port: 9 where part of it came, otherwise why nothing did.
#[test]
fn whoever_is_missing_on_a_port_is_named_and_the_others_are_read() {
    let some = plant("-a @ones read 372@1", [GONE, TWO, ONE]).json().exits(9);
    assert_eq!(named(some.data("/values")), ["a1 left", "b1 middle"]);
    assert_eq!(some.data("/values/0/error/class"), "silence");
    assert!(some.error()["message"].as_str().unwrap().contains("left.bench: "), "{}", some.error());
    plant("-a @ones read 372@1", [GONE, GONE, ONE]).json().exits(4);
    plant("-a @ones diag --check", [GONE, TWO, ONE]).json().exits(9);
    let tripped = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive.event]]\nat = \"0s\"\nfault = \"F0500\"\n";
    plant("-a @ones diag --check", [tripped, TWO, ONE]).json().exits(1);
    // A port that is not there.
    let project =
        "[drives.a]\nport = \"sim:{dir}/a.bench\"\naddress = 1\n[drives.b]\nport = \"/dev/nowhere\"\naddress = 1\n";
    for (verb, list) in [("identify", "/drives"), ("read 372@1", "/values")] {
        let run = antrieb(&format!("-a all {verb}")).file("a.bench", TWO);
        let project = project.replace("{dir}", &run.directory().display().to_string());
        let came = run.file("antrieb.toml", &project).json().exits(9);
        assert_eq!(came.data(list).as_array().unwrap().len(), 1);
        assert_eq!((came.data("/unreached/0/called"), came.data("/unreached/0/error/exit")), (&"b".into(), &3.into()));
    }
    // What was mistyped is told once.
    let wrong = plant("-a @ones read nosuch", [TWO, TWO, ONE]).exits(7).err;
    assert!(!wrong.contains(".bench: "), "{wrong}");
}

#[test]
fn files_go_into_the_drives_of_every_port_behind_one_question() {
    let load = "-a @ones dataset load {dir}/act.toml";
    let asked = plant(load, [TWO, TWO, ONE]).answered("y").exits(0);
    assert_eq!(asked.err.matches("[y/N]").count(), 1, "{}", asked.err);
    let stored: Vec<_> = witness::all_left().iter().map(|(bench, _)| bench.drive(1).unwrap().eeprom(372, 1)).collect();
    assert_eq!(stored, [Some(1440), Some(1440)]);
    assert!(asked.text_of("act-a1.undo.toml").contains("1390") && asked.text_of("act-b1.undo.toml").contains("1390"));
    let named = plant("-a a2,b2 dataset load {dir}/acu.toml --undo-file {dir}/u-{address}.toml --yes", [TWO, TWO, ONE]);
    assert!(named.exits(2).err.contains("{name}"));
}

#[test]
fn what_stays_on_one_line_says_what_to_do_instead() {
    for (verb, hint) in [
        ("write 372=1400", "dataset load"),
        ("dataset select 2", "-p"),
        ("dataset copy 1 2", "-p"),
        ("dataset undo {dir}/u.toml", "dataset undo FILE"),
        ("sollwert 5Hz", "one drive at a time"),
        ("statemachine enable", "one drive at a time"),
        ("diag --clear", "-p"),
        ("line set --baud 9600", "-p"),
        ("report {dir}/r.html", "-p"),
        ("monitor --count 1", "a watch is of one line"),
    ] {
        let run = plant(&format!("-v -a @ones {verb} --yes"), [TWO, TWO, ONE]).exits(2);
        assert!(run.err.contains(hint) && run.sent().is_empty(), "{verb}: {}", run.err);
    }
    plant("-a @ones --trace {dir}/t.trace identify", [TWO, TWO, ONE]).exits(2);
    // It keeps no stop back: nobody obeys it here, but everybody hears it.
    let stop = plant("-v -a @ones --trace {dir}/t.trace statemachine quick-stop", [TWO, TWO, ONE]).exits(8);
    let words = stop.err.lines().filter(|line| line.contains("> 01 06 01 9A"));
    assert!(words.count() > 1 && stop.err.contains("not recorded"), "{}", stop.err);
}
