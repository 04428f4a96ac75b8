//! What a load says of a drive whose two memories do not go together, that somebody else writes, or that starts meanwhile.

use super::ends::{Case, End};
use crate::run::{Output, Run, antrieb};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::Value;

fn file(values: &str) -> String {
    format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}\n")
}

fn bench(keys: &str) -> String {
    format!("[[drive]]\nmodel = \"act\"\n{keys}\n")
}

pub(super) fn load(keys: &str, values: &str) -> Run {
    antrieb("-a 1 --yes -v dataset load {dir}/f.toml").on(&bench(keys)).file("f.toml", &file(values))
}

/// The bench that a run has left.
pub(super) struct Left(pub(super) Bench, pub(super) Tick);

pub(super) fn left() -> Left {
    let (bench, at) = witness::left().unwrap();
    Left(bench, at)
}

impl Left {
    /// EEPROM and RAM of a cell of the only drive.
    pub(super) fn cell(&self, number: u32, set: u8) -> (Option<i64>, Option<i64>) {
        let drive = self.0.drives().next().unwrap();
        (drive.eeprom(number, set), drive.ram(number, set))
    }

    /// Writes to the EEPROM.
    pub(super) fn worn(&self) -> u64 {
        self.0.totals().eeprom_writes
    }

    /// Another command on it, in the directory of the last one.
    pub(super) fn then(self, ended: Output, line: &str) -> Run {
        witness::stands(self.0, self.1);
        ended.then(&format!("-p sim:{{dir}}/bench.toml {line}"))
    }
}

fn result(document: &Value, number: u32, set: u8) -> &str {
    let rows = document["data"]["values"].as_array().unwrap();
    let row = rows.iter().find(|row| row["param"] == number && row["data_set"] == set).unwrap();
    row["result"].as_str().unwrap()
}

#[test]
fn what_the_ram_took_and_the_eeprom_did_not_is_put_back() {
    for manner in ["refuses", "keeps"] {
        // As the first value, and behind another.
        for (values, written) in [("\"480@2\" = -12.5", false), ("\"372@1\" = 1440\n\"480@2\" = -12.5", true)] {
            let keys = format!("set = {{ \"480\" = 5 }}\neeprom = {{ \"480@2\" = \"{manner}\" }}");
            let ended = load(&keys, values).json().exits(9);
            assert_eq!(ended.data("/ended"), "back", "{manner}: {:#}", ended.value);
            assert_eq!(result(&ended.value, 480, 2), "restored", "{manner}");
            let left = left();
            assert_eq!(left.cell(480, 2), (Some(500), Some(500)), "{manner}");
            assert_eq!(left.cell(372, 1), (Some(1390), Some(1390)), "{manner} {written}");
        }
    }
}

#[test]
fn what_the_ram_may_have_taken_is_named_where_the_drive_does_not_show_it() {
    for manner in ["refuses", "keeps"] {
        let keys = format!(
            "set = {{ \"480\" = 5 }}\neeprom = {{ \"480@2\" = \"{manner}\" }}\nreadings = {{ ram_reads = \"refused\" }}"
        );
        let ended = load(&keys, "\"480@2\" = -12.5").json().exits(9);
        assert_eq!(ended.data("/ended"), "torn", "{manner}: {:#}", ended.value);
        assert_eq!(result(&ended.value, 480, 2), "unrestored", "{manner}");
        assert!(ended.value.to_string().contains("does not show its RAM"), "{manner}: {:#}", ended.value);
    }
    // `write` proves nothing of the RAM, and says so.
    let keys = "eeprom = { \"480@2\" = \"refuses\" }";
    let ended = antrieb("-a 1 --yes write 480@2=7").on(&bench(keys)).exits(6);
    assert!(ended.err.contains(" -a 1 read 480@2ram` tells"), "{}", ended.err);
}

#[test]
fn what_is_only_stored_is_no_success_and_wears_the_eeprom_once() {
    let keys = "set = { \"480\" = 5 }\neeprom = { \"480@2\" = \"not-in-force\" }";
    let ended = load(keys, "\"480@2\" = -12.5\n\"372@1\" = 1440").json().exits(9);
    assert_eq!(ended.data("/ended"), "stored", "{:#}", ended.value);
    assert_eq!((result(&ended.value, 480, 2), result(&ended.value, 372, 1)), ("stored", "verified"));
    assert_eq!(ended.error()["code"], "partial.not_in_force");
    let seen = left();
    assert_eq!((seen.cell(480, 2), seen.worn()), ((Some(-1250), Some(500)), 2));
    // The same once more brings it into force, and leaves the EEPROM alone.
    let first = load(keys, "\"480@2\" = -12.5\n\"372@1\" = 1440").exits(9);
    let again = left().then(first, "-a 1 --yes dataset load {dir}/f.toml").exits(0);
    let seen = left();
    assert_eq!((seen.cell(480, 2), seen.worn()), ((Some(-1250), Some(-1250)), 2), "{}", again.err);
}

#[test]
fn what_somebody_changed_since_stays_also_where_no_source_tells_the_data_sets() {
    let keys = "four = [419]\nset = { \"419\" = 60, \"419@3\" = 43.21 }";
    let undo = format!("{}[undo]\nvalues = {{ 419 = 60 }}\n", file("419 = 50"));
    let run = |more: &str| {
        antrieb(&format!("-a 1 --yes dataset undo {{dir}}/u.toml {more}")).on(&bench(keys)).file("u.toml", &undo)
    };
    let ended = run("").exits(9);
    assert!(ended.err.contains("43.21 Hz, which is neither"), "{}", ended.err);
    let seen = left();
    assert_eq!((seen.cell(419, 3).0, seen.cell(419, 1).0), (Some(4321), Some(5000)));
    run("--force").exits(0);
    assert_eq!(left().cell(419, 3).0, Some(5000));
}

#[test]
fn what_was_in_force_goes_back_behind_what_is_stored_whichever_data_sets_either_stands_for() {
    let keys = format!(
        "four = [419]\nset = {{ \"419@3ram\" = 43.21 }}\n[[drive.event]]\nafter_telegrams = 1\nrefuses = {}",
        2 << 12 | 480
    );
    let ended = load(&keys, "419 = 60\n\"480@2\" = 7").json().exits(9);
    assert_eq!(ended.data("/ended"), "back", "{:#}", ended.value);
    let seen = left();
    assert_eq!((seen.cell(419, 3), seen.cell(419, 1)), ((Some(5000), Some(4321)), (Some(5000), Some(5000))));
}

#[test]
fn only_the_cell_that_is_not_in_force_is_written_and_only_in_the_ram() {
    let ended = load("four = [419]\nset = { \"419\" = 60, \"419@3ram\" = 43.21 }", "419 = 60").json().exits(0);
    let seen = left();
    assert_eq!((seen.cell(419, 3), seen.worn()), ((Some(6000), Some(6000)), 0), "{:#}", ended.value);
    assert_eq!(ended.data("/eeprom_writes"), 0);
}

/// A drive that something happens to at every telegram of a load; how it ended, and what stands in 480@2.
fn at_every_telegram(keys: &str, event: &str, values: &str, mut judge: impl FnMut(usize, u8, &Value, &Left)) {
    for step in 1..80 {
        let keys = format!("{keys}\n[[drive.event]]\nafter_telegrams = {step}\n{event}");
        let ended = load(&keys, values).json();
        judge(step, ended.exit, &ended.value, &left());
    }
}

#[test]
fn what_somebody_sets_while_the_question_stands_is_not_written_over() {
    let mut seen = 0;
    at_every_telegram(
        "set = { \"480\" = 5 }",
        "set = { \"480@2\" = 7.77 }",
        "\"480@2\" = -12.5\n372 = 1440",
        |step, exit, document, left| {
            let now = left.cell(480, 2).0;
            let error = &document["error"]["code"];
            if error == "forbidden.changed_meanwhile" {
                seen += 1;
                assert_eq!((exit, now), (8, Some(777)), "{step}: {document:#}");
                assert_eq!((document["data"]["ended"].as_str(), left.worn()), (Some("untouched"), 0), "{step}");
                assert_eq!(result(document, 480, 2), "skipped", "{step}");
                assert!(document["data"]["undo_file"].is_null(), "{step}");
            }
            assert!(exit != 0 || now == Some(-1250) || now == Some(777), "{step}: {now:?}");
        },
    );
    assert!(seen >= 2, "{seen}");
}

#[test]
fn nothing_is_written_to_a_drive_that_starts_on_the_way() {
    let mut ends = std::collections::BTreeSet::new();
    at_every_telegram(
        "start_right = false\nset = { \"412\" = 0, \"480\" = 5 }",
        "start_right = true",
        "\"480@2\" = -12.5\n372 = 1440\n424 = 20",
        |step, exit, document, left| {
            let now = left.cell(480, 2).0;
            let ended = document["data"]["ended"].as_str().map(str::to_owned);
            ends.insert((exit, ended.clone()));
            let rows = document["data"]["values"].as_array().cloned().unwrap_or_default();
            let has = |result: &str| rows.iter().any(|row| row["result"] == result);
            match (exit, ended.as_deref()) {
                (0, Some("done")) => assert!(
                    now == Some(-1250) && document["warnings"].to_string().contains("RUNS")
                        || document["warnings"].as_array().unwrap().is_empty(),
                    "{step}: {document:#}"
                ),
                (8, _) => assert_eq!((left.worn(), now), (0, Some(500)), "{step}"),
                // What was written stays in a drive that runs, and each value of it is named.
                (9, Some("torn")) => {
                    assert!(has("unrestored") && !has("restored"), "{step}: {document:#}");
                    let message = document["error"]["message"].as_str().unwrap();
                    assert!(message.contains("runs"), "{step}: {document:#}");
                    // The rows that say which values are as many.
                    let count = rows.iter().filter(|row| row["result"] == "unrestored").count();
                    let values = if count == 1 { "1 value may".to_owned() } else { format!("{count} values may") };
                    assert!(message.contains(&values), "{step}: {document:#}");
                }
                other => panic!("{step}: {other:?} {document:#}"),
            }
        },
    );
    assert!([0, 8, 9].iter().all(|exit| ends.iter().any(|end| end.0 == *exit)), "{ends:?}");
}

#[test]
fn a_write_that_is_confirmed_is_not_sent_again_whatever_else_comes() {
    // One reply is lost, late or garbled; whatever comes of it, no cell is written more than the plan says.
    for kind in [
        "kind = \"lost\"",
        "kind = \"garbled\"",
        "kind = \"late\"\nby = \"550ms\"",
        "kind = \"doubled\"\nby = \"30ms\"",
    ] {
        for step in 1..40 {
            let keys = format!("reply_delay = \"8ms\"\n[[disturb]]\nonce = {step}\n{kind}");
            let ended = load(&keys, "\"480@2\" = -12.5\n372 = 1440\n\"424@1\" = 20").json();
            let most = ended.value["data"]["eeprom_writes"].as_u64().unwrap_or(0);
            let left = left();
            assert!(left.worn() <= most, "{kind} at {step}: {} of {most}: {:#}", left.worn(), ended.value);
            assert!(ended.exit != 0 || left.cell(480, 2).0 == Some(-1250), "{kind} at {step}");
        }
    }
}

#[test]
fn that_the_drive_may_tell_what_is_in_force_is_said_where_it_matters() {
    let keys = "set = { \"480\" = 5, \"480@2ram\" = -12.5 }\nreadings = { ram_reads = \"in-force\" }";
    let ended = load(keys, "\"480@2\" = -12.5").json().exits(0);
    let told = |warnings: &Value| warnings.to_string().contains("load.open_memory");
    assert!(told(&ended.value["warnings"]), "{:#}", ended.value);
    // A drive that tells the two apart has shown it.
    let apart = load("set = { \"480@2ram\" = 7 }", "\"480@2\" = 5").json().exits(0);
    assert!(!told(&apart.value["warnings"]), "{:#}", apart.value);
}

#[test]
fn a_file_for_another_family_is_not_written_because_of_drive() {
    let text = file("372 = 1440").replace("act", "acu");
    let run = |more: &str| {
        antrieb(&format!("-a 1 --drive acu --yes -v {more} dataset load {{dir}}/f.toml"))
            .on(&bench(""))
            .file("f.toml", &text)
    };
    let refused = run("").json().exits(7);
    assert_eq!(refused.error()["code"], "data.other_family");
    assert!(!refused.err.contains("write P."), "{}", refused.err);
    run("--force").exits(0);
}

#[test]
fn a_drive_that_restarts_on_the_way_back_is_waited_for() {
    // A refusal, and at each telegram behind it 6 s of silence.
    for step in 14..44 {
        let keys = format!(
            "[[drive.event]]\nafter_telegrams = 1\nrefuses = {}\n\
             [[drive.event]]\nafter_telegrams = {step}\nsilent = \"6s\"",
            2 << 12 | 480
        );
        let ended = load(&keys, "\"480@2\" = 7\n372 = 1440\n\"424@1\" = 20").json();
        let end = ended.value["data"]["ended"].as_str();
        assert!(end != Some("torn"), "{step}: {:#}", ended.value);
        assert_eq!(left().cell(372, 1).0, Some(1390), "{step}");
    }
}

#[test]
fn what_cannot_be_read_is_not_different() {
    let check = |values: &str, more: &str| {
        antrieb(&format!("-a 1 dataset check {{dir}}/x.toml {more}"))
            .on(&bench(""))
            .file("x.toml", &file(values))
            .json()
    };
    let unread = check("372 = 1390\n\"382@1\" = 7", "").exits(9);
    assert_eq!(unread.error()["code"], "partial.unread", "{}", unread.error());
    assert!(unread.data("/comparisons/0/equal").is_null(), "{:#}", unread.value);
    let both = check("372 = 1391\n\"382@1\" = 7", "").exits(9);
    assert!(both.error()["message"].as_str().unwrap().contains("1 differs"), "{}", both.error());
    assert_eq!(check("", "").exits(7).error()["code"], "data.no_values");
    // Of a file only what is meant.
    check("372 = 1391\n480 = 5", "").exits(1);
    check("372 = 1391\n480 = 5", "--except motor").exits(0);
    check("372 = 1391\n480 = 5", "--only 480 --sets 2-3").exits(0);
    check("372 = 1391", "--only 480").exits(7);
}

#[test]
fn who_is_gone_is_silent_and_no_stranger() {
    for step in 1..4 {
        let keys = format!("[[drive.event]]\nafter_telegrams = {step}\nsilent = \"10h\"");
        load(&keys, "372 = 1440").exits(4);
    }
}

#[test]
fn what_somebody_changed_meanwhile_stays_when_a_load_goes_back() {
    // It is changed at the third write, and the fourth is refused.
    for (ram, more, refuses) in [("", "", 2 << 12 | 482), ("ram", "--ram", 7 << 12 | 482)] {
        let keys = format!(
            "set = {{ \"480\" = 5 }}\n[[drive.event]]\nafter_telegrams = 1\nrefuses = {refuses}\n\
             [[drive.event]]\nafter_writes = 3\nset = {{ \"480@2{ram}\" = 12.34 }}"
        );
        let values = "\"372@1\" = 1440\n\"480@2\" = -12.5\n\"481@2\" = 7\n\"482@2\" = 8";
        let run = antrieb(&format!("-a 1 --yes -v dataset load {{dir}}/f.toml {more}")).on(&bench(&keys));
        let ended = run.file("f.toml", &file(values)).json().exits(9);
        assert_eq!(ended.data("/ended"), "torn", "{:#}", ended.value);
        let of = |number, set| result(&ended.value, number, set);
        assert_eq!((of(480, 2), of(372, 1), of(481, 2)), ("unrestored", "restored", "restored"), "{:#}", ended.value);
        let text = ended.value.to_string();
        assert!(text.contains("reads as 12.34 Hz") && text.contains("it stays"), "{:#}", ended.value);
        assert!(ended.error()["hint"].to_string().contains("--force"), "{}", ended.error());
        // Once, though it stands in both memories.
        assert!(ended.error()["message"].to_string().contains("1 value may not be"), "{}", ended.error());
        let left = left();
        assert_eq!((left.cell(480, 2).1, left.cell(372, 1).1), (Some(1234), Some(1390)), "{more}");
    }
}

#[test]
fn a_value_that_somebody_sets_is_written_over_only_right_before_its_own_write() {
    let mut seen = Vec::new();
    at_every_telegram(
        "set = { \"480\" = 5 }",
        "set = { \"480@2\" = 12.34 }",
        "\"372@1\" = 1440\n\"480@2\" = -12.5\n\"481@2\" = 7",
        |step, exit, document, left| {
            let now = left.cell(480, 2).0;
            // Between a write and its reading back nobody can tell what the drive made of it from what somebody sets.
            let by_drive = document.to_string().contains("refused.reads_back_differently") && exit == 9;
            assert!(by_drive || now == Some(1234) || now == Some(-1250), "{step}: {exit} {now:?} {document:#}");
            seen.push(now == Some(1234));
        },
    );
    // Before the plan it is what stood there, and behind the end nothing came; between them there is one gap.
    let stays = |at: &bool| *at;
    let (first, last) = (seen.iter().position(stays).unwrap(), seen.iter().rposition(stays).unwrap());
    let gaps = seen[first..=last].split(stays).filter(|gap| !gap.is_empty()).map(<[bool]>::len);
    let gaps: Vec<usize> = gaps.collect();
    assert!(gaps.len() <= 1 && gaps.iter().all(|gap| *gap < 6), "{gaps:?}");
    assert!(last - first > 15, "{seen:?}");
}

#[test]
fn what_somebody_changed_under_the_first_write_is_not_written_over_by_its_own() {
    let keys = "set = { \"480\" = 5 }\n[[drive.event]]\nafter_writes = 1\nset = { \"480@2\" = 12.34 }";
    let ended = load(keys, "\"372@1\" = 1440\n\"480@2\" = -12.5").json().exits(9);
    assert_eq!(ended.data("/ended"), "back", "{:#}", ended.value);
    assert_eq!((result(&ended.value, 480, 2), result(&ended.value, 372, 1)), ("skipped", "restored"));
    let seen = left();
    assert_eq!((seen.cell(480, 2).0, seen.cell(372, 1).0), (Some(1234), Some(1390)));
    // An undo goes the other way round.
    let keys =
        "set = { \"480@2\" = 7, \"372@1\" = 1440 }\n[[drive.event]]\nafter_writes = 1\nset = { \"372@1\" = 1500 }";
    let undo =
        format!("{}[undo]\nvalues = {{ \"480@2\" = 7, \"372@1\" = 1440 }}\n", file("\"480@2\" = 5\n\"372@1\" = 1390"));
    let undone = antrieb("-a 1 --yes dataset undo {dir}/u.toml").on(&bench(keys)).file("u.toml", &undo).exits(9);
    assert!(undone.err.contains("reads as 1500"), "{}", undone.err);
    let seen = left();
    assert_eq!((seen.cell(480, 2).0, seen.cell(372, 1).0), (Some(500), Some(1500)));
}

#[test]
fn an_undo_behind_a_ram_that_is_not_shown_brings_it_back_unread_and_says_so() {
    for manner in ["refuses", "keeps"] {
        let keys = format!(
            "set = {{ \"480\" = 5 }}\neeprom = {{ \"480@2\" = \"{manner}\" }}\nreadings = {{ ram_reads = \"refused\" }}"
        );
        for values in ["\"480@2\" = -12.5", "\"372@1\" = 1440\n\"480@2\" = -12.5"] {
            let ended = load(&keys, values).exits(9);
            assert!(ended.err.contains("switch the drive off and on"), "{}", ended.err);
            let before = left();
            let worn = before.worn();
            assert_eq!(before.cell(480, 2), (Some(500), Some(-1250)));
            let undone = before.then(ended, "-a 1 --yes dataset undo {dir}/f.undo.toml").exits(0);
            assert!(undone.out.contains("done, proven as far as it can be read"), "{}", undone.out);
            assert!(undone.err.contains("does not show its RAM"), "{}", undone.err);
            let after = left();
            assert_eq!((after.cell(480, 2), after.worn()), ((Some(500), Some(500)), worn));
            // It stays so, however often.
            let again = after.then(undone, "-a 1 --yes dataset undo {dir}/f.undo.toml").json().exits(0);
            let of_ram = |row: &&Value| row["param"] == 480 && row["store"] == "ram";
            let row = again.data("/values").as_array().unwrap().iter().find(of_ram).unwrap();
            assert_eq!((&row["result"], &row["old"]), (&"written".into(), &Value::Null), "{:#}", again.value);
            assert!(again.warnings().contains(&"load.in_force"), "{:#}", again.value);
            assert_eq!(left().worn(), worn);
        }
    }
    // It is asked about; and what the drive does not take is named.
    let undo = format!("{}[undo]\nvalues = {{ \"480@2\" = 7 }}\n", file("\"480@2\" = 5"));
    let run = |line: &str, event: &str| {
        let keys = format!("set = {{ \"480\" = 5 }}\nreadings = {{ ram_reads = \"refused\" }}\n{event}");
        antrieb(&format!("-a 1 {line} dataset undo {{dir}}/u.toml")).on(&bench(&keys)).file("u.toml", &undo)
    };
    let asked = run("", "").answered("n").exits(8);
    assert!(asked.err.contains("P.480@2 Fixed Frequency 1: ? -> 5.00 Hz, ram"), "{}", asked.err);
    run("--lang de", "").answered("j").exits(0);
    let refuses = format!("[[drive.event]]\nafter_telegrams = 1\nrefuses = {}", 7 << 12 | 480);
    let refused = run("--yes", &refuses).json().exits(9);
    assert_eq!(refused.data("/ended"), "torn", "{:#}", refused.value);
    // Whatever somebody says who leaves nothing to compare.
    run("--yes --force", "").exits(0);
    // Where everything is written anew, the RAM has it too; that it was not seen is said.
    let keys = "set = { \"480\" = 5 }\nreadings = { ram_reads = \"refused\" }";
    let ended = load(keys, "\"480@2\" = -12.5").exits(0);
    let undone = left().then(ended, "-a 1 --yes dataset undo {dir}/f.undo.toml").json().exits(0);
    assert!(undone.value["warnings"].to_string().contains("does not show its RAM"), "{:#}", undone.value);
}

/// A drive that tells its RAM as stored (docs/open-points.md, `ram_reads`).
const TELLS_RAM: &str = "set = { \"480\" = 5 }\nreadings = { ram_reads = \"in-force\" }";

#[test]
fn a_value_that_the_drive_acknowledged_goes_back_by_a_write_where_its_memories_are_not_told_apart() {
    let keys = format!("{TELLS_RAM}\neeprom = {{ \"480@2\" = \"not-in-force\" }}");
    let ended = load(&keys, "\"480@2\" = 7.5").json().exits(9);
    assert_eq!(ended.data("/ended"), "back", "{:#}", ended.value);
    let seen = left();
    assert_eq!((seen.cell(480, 2).0, seen.worn()), (Some(500), 2));
}

#[test]
fn what_did_not_go_back_into_the_eeprom_is_not_hidden_behind_the_ram() {
    let mut torn = 0;
    for step in 1..60 {
        let keys = format!(
            "{TELLS_RAM}\neeprom = {{ \"482@2\" = \"refuses\" }}\n[[drive.event]]\nafter_telegrams = {step}\nrefuses = {}",
            2 << 12 | 480
        );
        let run = load(&keys, "\"480@2\" = -12.5\n\"482@2\" = 7").run();
        let seen = left();
        if run.exit != 9 || seen.cell(480, 2).0 != Some(-1250) {
            continue;
        }
        torn += 1;
        assert_eq!(seen.cell(480, 2).1, Some(-1250), "telegram {step}: {}", run.err);
        seen.then(run, "-a 1 --yes dataset undo {dir}/f.undo.toml").exits(9);
        assert_eq!(left().cell(480, 2).0, Some(-1250), "telegram {step}");
    }
    assert!(torn > 0);
}

/// From the write on that `480@2` refuses, the EEPROM of `480@1` takes nothing back; after five minutes both are well again.
const WORN: &str = "eeprom = { \"480@2\" = \"refuses\" }\n\
    [[drive.event]]\nafter_writes = 2\neeprom = { \"480@1\" = \"refuses\" }\n\
    [[drive.event]]\nat = \"300s\"\neeprom = { \"480@1\" = \"takes\", \"480@2\" = \"takes\" }";

#[test]
fn what_the_eeprom_did_not_take_back_is_written_by_undo_whatever_the_drive_tells_of_it() {
    let in_force = ["rtu", "vabus", "ascii"].map(|protocol| ("in-force", protocol, 2));
    for (reads, protocol, writes) in in_force.into_iter().chain([("refused", "rtu", 1)]) {
        let keys = format!(
            "set = {{ \"480\" = 5 }}\nreadings = {{ ram_reads = \"{reads}\" }}\nprotocol = \"{protocol}\"\n{WORN}"
        );
        let of_it = &format!("--protocol {protocol}");
        let run = load(&keys, "\"480@1\" = 8\n\"480@2\" = 8").and(of_it).exits(9);
        let file = run.text_of("f.undo.toml");
        assert!(file.contains("\n[undo.unproven]\n\"480@1\" = \"5.00 Hz\""), "{file}");
        let seen = left();
        assert_eq!(seen.cell(480, 1), (Some(800), Some(500)), "{reads} {protocol}");
        // Still worn: it is said, and may be tried again.
        let undo = "-a 1 --yes dataset undo {dir}/f.undo.toml";
        let worn = seen.then(run, undo).and(of_it).exits(9);
        let seen = left();
        assert_eq!(seen.cell(480, 1).0, Some(800), "{reads} {protocol}");
        let Left(mut bench, at) = seen;
        let later = at + Span::from_secs(300);
        bench.advance(later);
        let before = bench.totals().eeprom_writes;
        let undone = Left(bench, later).then(worn, undo).and(of_it).exits(0);
        let seen = left();
        assert_eq!((seen.cell(480, 1), seen.worn() - before), ((Some(500), Some(500)), writes), "{reads} {protocol}");
        assert!(reads == "refused" || undone.err.contains("may tell its RAM as stored"), "{}", undone.err);
    }
}

/// The EEPROM is worn while the load is taken back by `undo`: the file keeps what it did not take, for the next one.
#[test]
fn what_the_eeprom_did_not_take_back_in_an_undo_is_written_by_the_next() {
    for protocol in ["rtu", "vabus", "ascii"] {
        let keys = format!(
            "set = {{ \"480\" = 5 }}\nreadings = {{ ram_reads = \"in-force\" }}\nprotocol = \"{protocol}\"\n\
             [[drive.event]]\nat = \"100s\"\neeprom = {{ \"480@1\" = \"refuses\" }}\n\
             [[drive.event]]\nat = \"300s\"\neeprom = {{ \"480@1\" = \"takes\" }}"
        );
        let of_it = &format!("--protocol {protocol}");
        let undo = "-a 1 --yes dataset undo {dir}/f.undo.toml";
        let later = |Left(mut bench, at): Left, seconds: u64| {
            let later = at + Span::from_secs(seconds);
            bench.advance(later);
            Left(bench, later)
        };
        let run = load(&keys, "\"480@1\" = 8\n\"480@2\" = 8").and(of_it).exits(0);
        let whole = run.text_of("f.undo.toml");
        let worn = later(left(), 150).then(run, undo).and(of_it).exits(9);
        let seen = left();
        assert_eq!(seen.cell(480, 1).0, Some(800), "{protocol}");
        let file = worn.text_of("f.undo.toml");
        assert!(
            file.contains("\n[undo.unproven]\n\"480@1\" = \"5.00 Hz\"") && !file.contains("n]\n\"480@2\""),
            "{file}"
        );
        assert!(worn.err.contains("dataset undo"), "{}", worn.err);
        let undone = later(seen, 300).then(worn, undo).and(of_it).exits(0);
        let seen = left();
        assert_eq!([seen.cell(480, 1).0, seen.cell(480, 2).0], [Some(500); 2], "{protocol}");
        // Once all is proven, it says again what it said at first.
        assert_eq!(undone.text_of("f.undo.toml"), whole);
    }
}

/// Killed at whatever telegram of the way back, with an EEPROM that did not take it: `undo` brings it back, or says that it did not.
#[test]
fn what_the_eeprom_did_not_take_back_is_known_behind_a_kill() {
    let registry = Registry::open(&[]).unwrap();
    let keys = format!("set = {{ \"480\" = 5 }}\nreadings = {{ ram_reads = \"in-force\" }}\n{WORN}");
    let case = Case { model: "act", keys: keys.leak(), options: "", ram: false };
    let (mut killed, mut hidden) = (0, 0);
    for step in 1.. {
        let directory = tempfile::tempdir().unwrap();
        let dir = directory.path();
        std::fs::write(dir.join("bench.toml"), case.bench(End::Killed, step, (480, 1))).unwrap();
        std::fs::write(dir.join("f.toml"), file("\"480@1\" = 8\n\"480@2\" = 8")).unwrap();
        let mut seen = case.run(&registry, dir, "load {dir}/f.toml", End::Killed, step);
        if !seen.killed {
            break;
        }
        killed += 1;
        let cell = |bench: &Bench| {
            let drive = bench.drives().next().unwrap();
            (drive.eeprom(480, 1), drive.ram(480, 1))
        };
        hidden += usize::from(cell(&seen.bench) == (Some(800), Some(500)));
        if !dir.join("f.undo.toml").exists() {
            assert_eq!(cell(&seen.bench).0, Some(500), "{step}");
            continue;
        }
        let later = seen.at + Span::from_secs(300);
        seen.bench.advance(later);
        witness::stands(seen.bench, later);
        let undone = case.run(&registry, dir, "undo {dir}/f.undo.toml", End::Whole, 0);
        let back = cell(&undone.bench) == (Some(500), Some(500));
        assert!(back && undone.failure.is_none(), "{step}: {:?} {:?}", cell(&undone.bench), undone.failure);
    }
    assert!(killed > 20 && hidden > 0, "{killed} {hidden}");
}

#[test]
fn a_place_that_is_refused_behind_the_question_is_not_called_changed() {
    let mut refused = 0;
    for step in 1..30 {
        let keys = format!("set = {{ \"480\" = 5 }}\n[[disturb]]\nonce = {step}\nkind = \"exception\"\nbyte = 3");
        let document = load(&keys, "\"480@2\" = -12.5").json();
        assert!(!document.err.contains("and is ? now"), "reply {step}: {}", document.err);
        refused += usize::from(document.exit == 6);
    }
    assert!(refused > 0);
}

#[test]
fn a_load_says_that_a_drive_does_not_show_its_ram() {
    let keys = "set = { \"480\" = 5, \"480@2ram\" = 44.44 }\nreadings = { ram_reads = \"refused\" }";
    let ended = load(keys, "\"480@2\" = 5").exits(0);
    assert!(ended.err.contains("does not show its RAM: only what is stored is proven"), "{}", ended.err);
    let checked = left().then(ended, "-a 1 dataset check {dir}/f.toml").exits(0);
    assert!(checked.err.contains("does not show its RAM: what it works with"), "{}", checked.err);
}

#[test]
fn of_what_is_no_setting_nothing_is_loaded_and_no_option_is_blamed() {
    let ended = load("", "484 = 10").exits(1);
    assert!(ended.err.contains("are no settings") && !ended.err.contains("--only"), "{}", ended.err);
    assert!(ended.err.contains("write` sends one by one: 484"), "{}", ended.err);
    // What can only be read nobody sends, and a setting that is left out is one all the same.
    let read = load("", "411 = 1").exits(1);
    assert!(read.err.contains("they can only be read: 411") && !read.err.contains("write`"), "{}", read.err);
    let picked = antrieb("-a 1 --yes dataset load {dir}/f.toml --only actual").on(&bench(""));
    let picked = picked.file("f.toml", &file("411 = 1\n480 = 8")).exits(1);
    assert!(picked.err.contains("of the 2 values of the files none was asked for"), "{}", picked.err);
}
