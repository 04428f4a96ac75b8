//! Where undo files go: what cannot be left there is told before anybody is asked, and only if something is to be written.

use super::plant::states;
use crate::run::antrieb;
use antrieb::transport::witness;

const ACT: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n";
const TWO: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive]]\nmodel = \"act\"\naddress = 2\n";

fn file(values: &str) -> String {
    format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}\n")
}

/// Beside it no file system takes another file: its name would be too long. That is a folder without a right to write, also for
/// who has every right.
fn long() -> String {
    "x".repeat(248)
}

fn worn() -> u64 {
    witness::left().unwrap().0.totals().eeprom_writes
}

#[test]
fn an_undo_file_that_cannot_be_left_is_in_nobodys_way_where_nothing_is_to_be_written() {
    let name = format!("{}.toml", long());
    let run = |value: u32| {
        antrieb(&format!("-a 1 dataset load {{dir}}/{name}")).on(ACT).file(&name, &file(&format!("372 = {value}")))
    };
    // The drive has it already.
    run(1390).exits(0);
    for refused in [run(1440), run(1440).answered("y"), run(1440).and("--lang de --yes")] {
        let refused = refused.exits(7);
        assert!(!refused.err.contains("[y/N]") && refused.err.contains("--undo-file"), "{}", refused.err);
        assert_eq!(worn(), 0);
    }
    let told = run(1440).and("--yes").json().exits(7);
    assert_eq!(
        (told.error()["code"].as_str(), told.data("/ended").as_str()),
        (Some("data.undo_file"), Some("untouched"))
    );
    assert_eq!(told.data("/values/0/result"), "skipped");
    let message = told.error()["message"].as_str().unwrap();
    assert_eq!(message.matches("nothing was written").count(), 1, "{message}");
    run(1440).and("--yes --undo-file {dir}/u.toml").exits(0);
}

#[test]
fn a_drive_of_a_plant_whose_undo_file_cannot_be_left_is_left_out_where_something_is_to_be_written() {
    let name = long();
    let project = |second: &str| {
        format!(
            "port = \"sim:{{dir}}/bench.toml\"\n[drives.{name}]\naddress = 1\nfiles = [\"a.toml\"]\n\
             [drives.fan]\naddress = 2\nfiles = [\"{second}\"]\n"
        )
    };
    let run = |line: &str, value: u32| {
        let run = antrieb(line);
        let project = project("b.toml").replace("{dir}", &run.directory().display().to_string());
        let run = run.file("antrieb.toml", &project).file("bench.toml", TWO);
        run.file("a.toml", &file(&format!("372 = {value}"))).file("b.toml", &file("372 = 1450"))
    };
    // It is as it shall be: only the other one is written to.
    run("apply --yes", 1390).exits(0);
    let told = run("apply --yes", 1440).json().exits(9);
    assert_eq!(states(&told), format!("fan done, {name} skipped"), "{:#}", told.value);
    assert_eq!(told.data("/drives/1/error/code"), "data.undo_file");
    let hint = told.error()["hint"].as_str().unwrap();
    assert!(hint.contains("project file") && !hint.contains("--undo-file"), "{hint}");
    let none = run("apply --yes --atomic", 1440).json().exits(7);
    assert_eq!((states(&none), worn()), (format!("fan skipped, {name} skipped"), 0));
    run("apply --yes --lang de", 1440).exits(9);
}
