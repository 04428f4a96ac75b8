//! What the drive had already when a load was planned: nobody writes it, and at the end it must stand there all the same.

use crate::run::{Output, Run, antrieb};
use antrieb::transport::witness;
use serde_json::Value;

fn file(values: &str) -> String {
    format!("antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n{values}\n")
}

/// A load into an ACU of which 480@1 becomes another value behind the first write.
fn load(protocol: &str, values: &str, more: &str) -> Run {
    let bench = format!(
        "[[drive]]\nmodel = \"acu\"\nprotocol = \"{protocol}\"\nset = {{ \"480\" = 5 }}\n{more}\n\
         [[drive.event]]\nafter_writes = 1\nset = {{ \"480@1\" = 7.77 }}\n"
    );
    let line = format!("--protocol {protocol} -a 1 --yes dataset load {{dir}}/f.toml");
    antrieb(&line).on(&bench).file("f.toml", &file(values))
}

/// What stands in EEPROM and RAM.
type Cell = (Option<i64>, Option<i64>);

/// EEPROM and RAM of a cell of the only drive, and the cells of its EEPROM that were written.
fn left<const N: usize>(places: [(u32, u8); N]) -> ([Cell; N], u64) {
    let (bench, _) = witness::left().unwrap();
    let drive = bench.drives().next().unwrap();
    let cells = places.map(|(number, set)| (drive.eeprom(number, set), drive.ram(number, set)));
    (cells, bench.totals().eeprom_writes)
}

fn both(raw: i64) -> Cell {
    (Some(raw), Some(raw))
}

fn row(document: &Value, number: u32, set: u8) -> &Value {
    let rows = document["data"]["values"].as_array().unwrap();
    rows.iter().find(|row| row["param"] == number && row["data_set"] == set).unwrap()
}

fn most(document: &Value) -> u64 {
    ["eeprom_writes", "eeprom_writes_back"].iter().filter_map(|key| document["data"][key].as_u64()).sum()
}

/// Another command on the bench that was left.
fn then(ended: Output, line: &str) -> Run {
    let (bench, at) = witness::left().unwrap();
    witness::stands(bench, at);
    ended.then(&format!("-p sim:{{dir}}/bench.toml {line}"))
}

#[test]
fn what_was_equal_at_the_plan_is_read_again_at_the_end() {
    for protocol in ["rtu", "ascii", "vabus"] {
        for values in ["372 = 1440\n480 = 5", "372 = 1440\n\"480@1\" = 5"] {
            let ended = load(protocol, values, "").json().exits(9);
            assert_eq!(ended.data("/ended"), "back", "{protocol}: {:#}", ended.value);
            let row = row(&ended.value, 480, 1);
            assert_eq!(row["result"], "skipped", "{row:#}");
            let told = "P.480@1 was 5.00 Hz when it was asked about, and is 7.77 Hz now";
            assert!(row["error"]["message"].as_str().unwrap().contains(told), "{row:#}");
            assert!(ended.error()["message"].as_str().unwrap().contains(told), "{:#}", ended.value);
            // It is his who has changed it.
            assert_eq!(left([(480, 1), (372, 1)]).0, [both(777), both(1390)], "{protocol}");
        }
    }
    // Also where it is changed in the RAM alone.
    let bench = "[[drive]]\nmodel = \"acu\"\nset = { \"480\" = 5 }\n\
                 [[drive.event]]\nafter_writes = 1\nset = { \"480@1ram\" = 7.77 }\n";
    let run = antrieb("-a 1 --yes dataset load {dir}/f.toml").on(bench);
    let ended = run.file("f.toml", &file("372 = 1440\n480 = 5")).json().exits(9);
    assert!(ended.error()["message"].as_str().unwrap().contains("(RAM) was 5.00 Hz"), "{:#}", ended.value);
}

/// No source tells all that P.30 changes (`[files]`): nobody else is presumed behind it, and the way back is of all that the file holds.
#[test]
fn what_a_configuration_took_with_it_goes_back_with_it() {
    for protocol in ["rtu", "ascii", "vabus"] {
        let ended = load(protocol, "30 = 210\n480 = 5\n376 = 15", "").json().exits(9);
        assert_eq!(ended.data("/ended"), "back", "{protocol}: {:#}", ended.value);
        assert_eq!(row(&ended.value, 480, 1)["result"], "restored", "{:#}", ended.value);
        let (cells, worn) = left([(480, 1), (30, 0)]);
        assert_eq!(cells, [both(500), both(110)], "{protocol}");
        assert!(worn <= most(&ended.value), "{worn}: {:#}", ended.value);
    }
    // Ended before the proof: what was never reached goes back all the same.
    let refuses = format!("[[drive.event]]\nafter_telegrams = 1\nrefuses = {}", 1 << 12 | 372);
    for values in ["30 = 210\n372 = 1440\n480 = 5", "30 = 210\n372 = 1440\n480 = 8"] {
        let ended = load("rtu", values, &refuses).json().exits(9);
        assert_eq!(ended.data("/ended"), "back", "{:#}", ended.value);
        let (cells, worn) = left([(480, 1), (30, 0), (372, 1)]);
        assert_eq!(cells, [both(500), both(110), both(1390)]);
        assert!(worn <= most(&ended.value), "{worn}: {:#}", ended.value);
    }
    // What cannot go back is named.
    let refuses = format!("[[drive.event]]\nafter_writes = 1\nrefuses = {}", 1 << 12 | 480);
    let ended = load("rtu", "30 = 210\n480 = 5", &refuses).json().exits(9);
    assert_eq!(ended.data("/ended"), "torn", "{:#}", ended.value);
    assert_eq!(row(&ended.value, 480, 1)["result"], "unrestored", "{:#}", ended.value);
}

/// Behind a crash the undo file knows of it, and `undo` names it.
#[test]
fn an_undo_behind_a_configuration_names_what_stands_otherwise() {
    let loaded = load("rtu", "30 = 210\n480 = 5", "").exits(9);
    let text = loaded.text_of("f.undo.toml");
    let (values, undo) = text.split_once("[undo]").unwrap();
    assert!(values.contains("\"480@1\" = \"5.00 Hz\"") && !undo.contains("480"), "{text}");
    let bench = "[[drive]]\nmodel = \"acu\"\nset = { \"30\" = 210, \"480\" = 5, \"480@1\" = 7.77 }\n";
    let undo = |more: &str| antrieb(&format!("-a 1 --yes dataset undo {{dir}}/u.toml {more}")).on(bench);
    let ended = undo("").file("u.toml", &text).json().exits(9);
    assert_eq!(row(&ended.value, 480, 1)["result"], "refused", "{:#}", ended.value);
    assert_eq!(left([(480, 1), (30, 0)]).0, [both(777), both(110)]);
    undo("--force").file("u.toml", &text).exits(0);
    assert_eq!(left([(480, 1), (30, 0)]).0, [both(500), both(110)]);
}

#[test]
fn all_is_also_what_no_catalogue_knows() {
    // To a program that knows only the ACT, what the resolver module brings is unknown.
    let bench = "[[drive]]\nmodel = \"acu\"\nmodules = [\"EM-RES-03\"]\nset = { \"382\" = 7 }\n";
    let text = file("372 = 1390\n382 = \"raw 20\"").replace("acu", "act");
    for only in ["all", "all,bus", "@ALL", "382"] {
        let run = |verb: &str, more: &str| {
            let line = format!("-a 1 --drive act --yes dataset {verb} {{dir}}/f.toml --only {only} {more}");
            antrieb(&line).on(bench).file("f.toml", &text)
        };
        run("check", "").exits(1);
        run("load", "--force").exits(0);
        let (found, _) = left([(382, 1)]);
        assert_eq!(found, [both(20)], "{only}");
    }
    let none = antrieb("-a 1 --drive act --yes --force dataset load {dir}/f.toml --except all").on(bench);
    none.file("f.toml", &text).exits(1);
}

/// A file of a drive with another firmware: the width to write with is the one at which this drive answers.
#[test]
fn a_width_that_a_file_names_is_not_believed_against_the_drive() {
    for protocol in ["rtu", "ascii", "vabus"] {
        let usual = format!("[[drive]]\nmodel = \"acu\"\nprotocol = \"{protocol}\"\n");
        let odd = format!("{usual}other_width = [480, 372]\nset = {{ \"480\" = 8, \"372\" = 1440 }}\n");
        let line = format!("--protocol {protocol} -a 1 --yes dataset");
        let saved = antrieb(&format!("{line} save {{dir}}/a.toml")).on(&odd).exits(0);
        let text = saved.text_of("a.toml");
        assert!(text.contains("480 = \"word\"") && text.contains("372 = \"long\""), "{text}");
        let run = antrieb(&format!("{line} load {{dir}}/f.toml")).on(&usual).file("f.toml", &text);
        let loaded = run.exits(0);
        assert!(loaded.out.contains("done, every value proven"), "{}", loaded.out);
        assert!(!loaded.err.contains("does not show its RAM"), "{}", loaded.err);
        let undo = loaded.text_of("f.undo.toml");
        assert!(!undo.contains("[types]"), "{undo}");
        let same = then(loaded, &format!("{line} check {{dir}}/f.toml")).exits(0);
        let undone = then(same, &format!("{line} undo {{dir}}/f.undo.toml")).exits(0);
        assert!(!undone.err.contains("does not show"), "{}", undone.err);
        assert_eq!(left([(372, 3)]).0, [both(1390)], "{protocol}");
    }
}

/// P.417 is in Hz, and no source tells where its point stands: what is written is shown as it is read.
#[test]
fn a_raw_value_of_unknown_decimals_is_shown_as_one() {
    let bench = "[[drive]]\nmodel = \"acu\"\n";
    let load = |more: &str| antrieb(&format!("-a 1 {more} dataset load {{dir}}/f.toml")).on(bench);
    let load = |more: &str| load(more).file("f.toml", &file("417 = \"raw 500\""));
    let asked = load("").answered("n").exits(8);
    assert!(asked.err.contains("-> 500 (raw, decimals unknown: Hz)"), "{}", asked.err);
    let german = load("--lang de").answered("n").exits(8);
    assert!(german.err.contains("-> 500 (roh, Nachkommastellen unbekannt: Hz)"), "{}", german.err);
    let done = load("--yes").json().exits(0);
    let row = row(&done.value, 417, 0);
    assert_eq!((&row["raw"], &row["value"], &row["old"]), (&500.into(), &Value::Null, &Value::Null), "{row:#}");
    assert!(row["old_raw"].is_number(), "{row:#}");
    let table = load("--yes").exits(0).out;
    let line = table.lines().find(|line| line.contains("417")).unwrap();
    assert!(line.contains("500") && line.contains("raw") && !line.contains("Hz"), "{line}");
    let written = antrieb("-a 1 --yes write 417=0x1F4").on(bench).json().exits(0);
    assert_eq!(written.data("/values/0/value"), &Value::Null);
}
