//! What is said of a parameter file in a drive is so: what is in force, what was left out, what was undone, what is not whole.

use crate::run::{Output, Run, antrieb};
use antrieb::transport::witness;

const FRESH: &str = "[[drive]]\nmodel = \"act\"\n";
const RUNNING: &str = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"410\" = 15, \"484\" = 10 }\n";

fn file(values: &str) -> String {
    format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}\n")
}

fn load(bench: &str, values: &str, more: &str) -> Run {
    antrieb(&format!("-a 1 --yes -v dataset load {{dir}}/f.toml {more}")).on(bench).file("f.toml", &file(values))
}

fn undo(bench: &str, values: &str, coming: &str) -> Run {
    let text = format!("{}[undo]\nvalues = {{ {coming} }}\n", file(values));
    antrieb("-a 1 --yes -v dataset undo {dir}/u.toml").on(bench).file("u.toml", &text)
}

/// Another command on the bench that [`cells`] has looked at, in its directory.
fn then(ended: Output, line: &str) -> Run {
    ended.then(&format!("-p sim:{{dir}}/bench.toml {line}"))
}

fn writes(sent: &[String]) -> usize {
    sent.iter().filter(|sent| ["01 06 ", "01 10 ", "01 65 "].iter().any(|code| sent.starts_with(code))).count()
}

/// What stands in cells of the only drive on the bench that is left: number, data set, in RAM.
fn cells<const N: usize>(places: [(u32, u8, bool); N]) -> [Option<i64>; N] {
    let (bench, at) = witness::left().unwrap();
    let drive = bench.drives().next().unwrap();
    let raws = places.map(|(number, set, ram)| if ram { drive.ram(number, set) } else { drive.eeprom(number, set) });
    witness::stands(bench, at);
    raws
}

#[test]
fn what_is_stored_but_not_in_force_is_written_and_not_called_done() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"480\" = 5, \"480@1ram\" = 7 }\n";
    let document = load(bench, "480 = 5", "").json().exits(0);
    let rows = document.data("/values").as_array().unwrap();
    let results: Vec<_> = rows.iter().map(|row| row["result"].as_str().unwrap()).collect();
    // What is stored is not stored once more: the RAM alone gets it.
    assert_eq!(results, ["unchanged", "verified", "unchanged", "unchanged", "unchanged"]);
    assert!(rows[1]["note"].as_str().unwrap().contains("works with another value (RAM)"), "{}", rows[1]);
    assert_eq!((rows[1]["store"].as_str(), document.data("/eeprom_writes")), (Some("ram"), &0.into()));
    assert!(document.err.contains("7.00 -> 5.00 Hz"), "{}", document.err);
    assert_eq!(cells([(480, 1, true)]), [Some(500)]);
    // What is both stored and in force costs nothing.
    let same = load("[[drive]]\nmodel = \"act\"\nset = { \"480\" = 5 }\n", "480 = 5", "").exits(0);
    assert_eq!(writes(&same.sent()), 0, "{}", same.err);
}

#[test]
fn a_value_of_which_the_ram_cannot_be_read_is_not_called_unchanged() {
    // The drive has 5 stored and works with 7; it falls silent at every telegram, once at the question for the RAM.
    for step in 1..8 {
        let bench = format!(
            "[[drive]]\nmodel = \"act\"\nset = {{ \"480@1\" = 5, \"480@1ram\" = 7 }}\n\
             [[drive.event]]\nafter_telegrams = {step}\nsilent = \"10h\"\n"
        );
        let run = antrieb("-a 1 --drive act --yes write 480@1=5").on(&bench).run();
        assert!(!run.out.contains("unchanged"), "{step}: {}", run.out);
    }
}

#[test]
fn the_ram_behind_what_exists_once_goes_back_too() {
    let both = [(400, 0, false), (400, 0, true)];
    let start = antrieb("-a 1 --yes write 400@0ram=4").on(FRESH).exits(0);
    assert_eq!(cells(both), [Some(2), Some(4)]);
    // The drive refuses a power of 0.
    let ended = then(start, "-a 1 --yes dataset load {dir}/f.toml").file("f.toml", &file("400 = 6\n376 = 0")).exits(9);
    assert!(ended.err.contains("P.400@0: the drive works with 4 (RAM)"), "{}", ended.err);
    assert!(ended.out.contains("as before, proven"), "{}", ended.out);
    assert_eq!(cells(both), [Some(2), Some(4)]);
}

#[test]
fn an_undo_says_where_the_drive_works_with_something_else_than_it_brings_back() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"480\" = 5, \"480@1ram\" = 7 }\n";
    let document = undo(bench, "\"480@1\" = 5", "\"480@1\" = 6").json().exits(0);
    assert_eq!(document.warnings(), ["load.in_force"]);
    assert_eq!(cells([(480, 1, true)]), [Some(700)], "somebody's RAM is not touched");
}

#[test]
fn where_the_scope_leaves_nothing_that_is_no_success() {
    for (values, more, hint) in [
        ("372 = 1440", "--only ramps", "--only, --except and --sets"),
        ("372 = 1440", "--except motor", "--only, --except and --sets"),
        ("\"372@2\" = 1440", "--sets 1,3", "--only, --except and --sets"),
        ("10 = 3\n1376 = 7", "", "--only 10,1376"),
        ("10 = 3", "--dry-run", "--only 10"),
        ("", "", "files with values"),
    ] {
        let ended = load(FRESH, values, more).exits(1);
        assert!(!ended.out.contains("done") && ended.sent().is_empty(), "{values} {more}: {}", ended.out);
        assert!(ended.err.contains(hint), "{values} {more}: {}", ended.err);
    }
    let document = load(FRESH, "10 = 3", "").json().exits(1);
    assert_eq!((document.error()["code"].as_str(), document.data("/ended")), (Some("no.values"), &"untouched".into()));
}

#[test]
fn what_hangs_on_an_index_is_left_out_until_it_is_named_and_can_be_named() {
    let text = file("1201 = 3\n372 = 1440").replace("act", "acu");
    let run = |more: &str| {
        let line = format!("-a 1 --dry-run dataset load {{dir}}/f.toml {more}");
        antrieb(&line).on("[[drive]]\nmodel = \"acu\"\n").file("f.toml", &text).exits(0).out
    };
    assert!(run("").contains("left out until named  1201"), "{}", run(""));
    for named in ["1201", "positioning", "all,1201"] {
        assert!(run(&format!("--only {named}")).contains("Read index"), "{named}");
    }
}

#[test]
fn a_sign_that_a_value_does_not_carry_is_refused_before_the_first_byte() {
    let ended = load(FRESH, "372 = 1440\n480 = \"raw 99999999999\"", "").exits(7);
    assert_eq!(writes(&ended.sent()), 0, "{}", ended.err);
    let typed = format!("{}[types]\n417 = \"word\"\n", file("417 = \"raw -5\""));
    let placed = antrieb("-a 1 --yes -v dataset load {dir}/f.toml").on(FRESH).file("f.toml", &typed).exits(7);
    assert!(placed.err.contains("f.toml:5:7: -5 does not fit into a word"), "{}", placed.err);
}

#[test]
fn a_dry_run_tells_what_would_be_refused() {
    for (values, more, code) in [("480 = 2000", "", 7), ("1376 = 3", "--only bus", 8)] {
        let document = load(FRESH, values, &format!("{more} --dry-run")).json().exits(code);
        assert_eq!(document.data("/values/0/result"), "refused");
        let message = document.error()["message"].as_str().unwrap();
        assert!(message.ends_with("nothing would be written"));
        assert_eq!(message.contains("unless the drive has it already"), code == 8, "{message}");
    }
}

/// In the RAM a power loss takes back also what nobody wrote: whatever is said of a row then is so.
#[test]
fn a_power_loss_under_a_load_into_the_ram_leaves_no_row_that_says_what_is_not_so() {
    let mut ends = std::collections::BTreeSet::new();
    for step in 1..40 {
        let set = "set = { \"480\" = 5, \"480@1ram\" = 7 }";
        let bench = format!(
            "[[drive]]\nmodel = \"act\"\n{set}\n[[drive.event]]\nafter_telegrams = {step}\npower_cycle = true\n"
        );
        let line = "-a 1 --drive act --yes dataset load {dir}/f.toml --ram";
        let values = "\"372@1\" = 1440\n\"480@1\" = 7\n\"480@2\" = 8\n\"481@1\" = 9";
        let document = antrieb(line).on(&bench).file("f.toml", &file(values)).json();
        let (bench, _) = witness::left().unwrap();
        let drive = bench.drives().next().unwrap();
        for row in document.value["data"]["values"].as_array().unwrap_or(&Vec::new()) {
            let number = |field: &str| row[field].as_i64();
            let now = drive.ram(number("param").unwrap() as u32, number("data_set").unwrap() as u8);
            let expected = match row["result"].as_str().unwrap() {
                "verified" => number("raw"),
                "unchanged" | "restored" if document.exit == 9 => number("old_raw"),
                "unchanged" if document.exit == 0 => number("raw"),
                _ => continue,
            };
            assert_eq!(now, expected, "{step}: exit {}: {row}", document.exit);
        }
        ends.insert(document.exit);
    }
    assert!(ends.contains(&0) && ends.contains(&9), "{ends:?}");
}

#[test]
fn an_undo_brings_back_what_it_can_and_names_what_cannot_be_read() {
    let values = "372 = 1400\n\"382@1\" = 7\n\"480@2\" = 5";
    let ended = undo(FRESH, values, "372 = 1390, \"382@1\" = 8, \"480@2\" = 10").json().exits(9);
    let rows = ended.data("/values").as_array().unwrap();
    let of = |id: u32| rows.iter().find(|row| row["param"] == id).unwrap()["result"].clone();
    assert_eq!((of(372), of(382)), ("restored".into(), "unrestored".into()), "{:#}", ended.value);
    assert_eq!(cells([(372, 1, false)]), [Some(1400)]);
    assert!(ended.error()["message"].as_str().unwrap().contains("cannot be read"), "{}", ended.error());
}

#[test]
fn an_undo_leaves_a_drive_that_runs_alone() {
    let document = undo(RUNNING, "372 = 1400", "372 = 1390").json().exits(8);
    assert_eq!(
        (document.error()["code"].as_str(), document.data("/ended")),
        (Some("forbidden.running"), &"untouched".into())
    );
    // It starts to run on the way, also while somebody is asked.
    let mut ends = Vec::new();
    for step in 1..24 {
        let bench = format!(
            "[[drive]]\nmodel = \"act\"\nstart_right = false\nset = {{ \"412\" = 0, \"480\" = 10 }}\n\
             [[drive.event]]\nafter_telegrams = {step}\nstart_right = true\n"
        );
        let ended = undo(&bench, "\"372@1\" = 1400", "\"372@1\" = 1390").run();
        if ended.exit == 8 {
            assert!(!ended.err.contains("may not be as before"), "{}", ended.err);
            assert!(ended.out.contains("nothing was changed") && ended.out.contains("skipped"), "{}", ended.out);
            assert_eq!(writes(&ended.sent()), 0, "{}", ended.err);
        }
        ends.push((ended.exit, ended.err.contains("nothing was changed")));
    }
    // Before the question, behind it, and too late to be seen before the write.
    assert!([(8, false), (8, true), (0, false)].iter().all(|end| ends.contains(end)), "{ends:?}");
}

#[test]
fn an_undo_file_is_no_layer_of_a_load() {
    let undo = format!("{}[undo]\nvalues = {{ 372 = 1390 }}\n", file("372 = 1400"));
    let line = "-a 1 --yes -v dataset load {dir}/f.toml {dir}/u.toml";
    let ended = antrieb(line).on(FRESH).file("f.toml", &file("480 = 7")).file("u.toml", &undo).exits(7);
    assert!(ended.err.contains("u.toml: this file takes a load back"), "{}", ended.err);
    assert!(ended.err.contains("dataset undo") && ended.sent().is_empty(), "{}", ended.err);
}

#[test]
fn a_status_word_that_cannot_be_read_is_no_standstill() {
    // Silent each time that it is asked: sometimes that is the question for its state.
    for (first, second) in (1..5).flat_map(|first| (first + 1..13).map(move |second| (first, second))) {
        let silent = |step: i32| format!("[[drive.event]]\nafter_telegrams = {step}\nsilent = \"450ms\"\n");
        let bench = format!("{RUNNING}{}{}", silent(first), silent(second));
        let line = "-a 1 --drive act --retries 0 --yes -v dataset load {dir}/f.toml";
        let ended = antrieb(line).on(&bench).file("f.toml", &file("\"372@1\" = 1440")).run();
        assert!(ended.exit != 0 && writes(&ended.sent()) == 0, "{first} {second}: {}", ended.err);
    }
}

#[test]
fn what_was_written_is_heard_of_also_where_nobody_reads_the_document() {
    let ended = load(FRESH, "372 = 1440", "").into_pipe_of(5).exits(0);
    for told in ["done, every value proven", "f.undo.toml", "1440", "verified"] {
        assert!(ended.err.contains(told), "{told}: {}", ended.err);
    }
}

#[test]
fn a_check_of_a_file_that_is_not_whole_is_no_success() {
    let part = |value: &str| {
        file(value).replace("[values]", "[saved]\ncomplete = false\n[not-held]\nnot-asked = \"480\"\n[values]")
    };
    let check = |value: &str| antrieb("-a 1 dataset check {dir}/x.toml").on(FRESH).file("x.toml", &part(value)).json();
    let same = check("372 = 1390").exits(9);
    assert_eq!(same.error()["code"], "partial.file_incomplete");
    assert!(same.data("/comparisons/0/equal").is_null(), "{:#}", same.value);
    assert_eq!(check("372 = 1400").exits(1).error()["code"], "no.differences");
    let files = antrieb("dataset diff {dir}/a.toml {dir}/b.toml");
    files.file("a.toml", &part("372 = 1")).file("b.toml", &file("372 = 1")).exits(9);
}

#[test]
fn an_undo_file_of_another_product_is_refused_also_where_the_family_was_named() {
    let text = "antrieb = 1\n[drive]\nfamily = \"lxm05\"\nproduct = \"SOMETHING ELSE\"\n[values]\n1556 = 3000\n[undo]\n\
                values = { 1556 = 2000 }\n";
    for named in ["", "--drive lxm05"] {
        let line = format!("-a 1 {named} --yes dataset undo {{dir}}/u.toml");
        let ended = antrieb(&line).on("[[drive]]\nmodel = \"lxm05\"\n").file("u.toml", text).json().exits(7);
        assert_eq!(ended.error()["code"], "data.other_drive", "{named}: {}", ended.error());
    }
}

#[test]
fn an_undo_says_which_ram_it_replaces() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"480@2\" = -12.5, \"480@2ram\" = 7.77 }\n";
    let document = undo(bench, "\"480@2\" = 5", "\"480@2\" = -12.5").json().exits(0);
    assert!(document.warnings().contains(&"load.in_force"), "{:#}", document.value);
    assert!(document.value["warnings"].to_string().contains("7.77 Hz (RAM)"), "{:#}", document.value);
    assert!(document.err.contains("both are replaced"), "{}", document.err);
}

/// What stood in the RAM alone does not come back from a file that knows only what was stored: the file says so, and `undo` too.
#[test]
fn an_undo_names_what_stood_in_the_ram_alone() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"480\" = 5, \"480@2ram\" = 7 }\n";
    // Stored anew, and put into force by the load, beside something that is stored.
    for values in ["480 = 8", "480 = 5\n481 = 9"] {
        let loaded = load(bench, values, "").exits(0);
        let left = loaded.text_of("f.undo.toml");
        assert!(left.contains("\nantrieb = 2\n"), "{left}");
        assert!(left.contains("[undo.ram]\n\"480@2\" = \"7.00 Hz\"  # fixed-frequency-1\n"), "{left}");
        assert_eq!(cells([(480, 2, true)]), [Some(if values.contains("481") { 500 } else { 800 })]);
        let asked = then(loaded, "-a 1 dataset undo {dir}/f.undo.toml").answered("y").exits(0);
        let told = "P.480@2: before the load the drive worked with 7.00 Hz (RAM alone), which does not come back";
        for what in [told, "write` with @2ram sets it"] {
            assert_eq!(asked.err.matches(what).count(), 2, "asked and reported: {}", asked.err);
        }
        assert_eq!(cells([(480, 2, false), (480, 2, true)]), [Some(500), Some(500)]);
        let again = then(asked, "-a 1 dataset undo {dir}/f.undo.toml --yes --lang de").json().exits(0);
        assert!(again.warnings().contains(&"load.in_force"), "{:#}", again.value);
        assert!(again.value["warnings"].to_string().contains("nur im RAM"), "{:#}", again.value);
        let text = antrieb("-a 1 dataset undo {dir}/f.undo.toml --yes").on(bench).file("f.undo.toml", &left);
        assert!(!text.exits(0).err.contains("does not come back"), "it stands there yet");
    }
    // Who has nothing more to say writes the first version, which older programs read.
    let plain = load(FRESH, "480 = 8", "").exits(0).text_of("f.undo.toml");
    assert!(plain.contains("\nantrieb = 1\n") && !plain.contains("undo.ram"), "{plain}");
    let in_ram = load(bench, "480 = 8", "--ram").exits(0).text_of("f.undo.toml");
    assert!(in_ram.contains("\"480@2\" = \"7.00 Hz\"") && !in_ram.contains("undo.ram"), "{in_ram}");
}

/// P.1376 is the address of Modbus, P.394 that of VABus (CM-485 manual 11.2): the one that is not spoken can be proven and taken back.
#[test]
fn which_address_cuts_the_line_depends_on_what_is_spoken() {
    for (protocol, cuts, other) in [("rtu", 1376, 394), ("vabus", 394, 1376)] {
        let bench = format!("[[drive]]\nmodel = \"act\"\nprotocol = \"{protocol}\"\n");
        let load = |number: u32, more: &str| {
            let text = format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{number} = 7\n");
            let line = format!("--protocol {protocol} -a 1 dataset load {{dir}}/f.toml --only bus --yes {more}");
            antrieb(&line).on(&bench).file("f.toml", &text)
        };
        assert!(load(cuts, "").exits(8).err.contains("can cut the line at once"), "{protocol}");
        load(cuts, "--dry-run").exits(8);
        load(other, "--dry-run").exits(0);
        load(other, "").exits(0);
        let write = |number: u32| antrieb(&format!("--protocol {protocol} -a 1 write {number} 7 --yes")).on(&bench);
        let told = write(other).json().exits(0);
        assert_eq!((told.data("/values/0/result"), told.warnings().len()), (&"verified".into(), 0), "{protocol}");
        assert_eq!(write(cuts).json().warnings(), ["line.changed"], "{protocol}");
        let asked = |number: u32| {
            let line = format!("--protocol {protocol} -a 1 write {number} 7");
            antrieb(&line).on(&bench).answered("n").exits(8).err
        };
        let told = [cuts, other].map(asked);
        assert_eq!(told.each_ref().map(|told| told.contains("LINE: ")), [true, false], "{protocol}: {told:?}");
        assert_eq!(told.map(|told| told.contains("line set --address")), [true, false], "{protocol}");
    }
}

#[test]
fn an_undo_file_of_a_hand_cuts_no_line_and_says_from_where_it_leads_back() {
    let cut = undo(FRESH, "1376 = 9\n\"480@2\" = 6", "1376 = 1, \"480@2\" = 5").json().exits(9);
    assert!(cut.value.to_string().contains("can cut the line at once"), "{:#}", cut.value);
    assert_eq!(cells([(480, 2, false), (1376, 0, false)]), [Some(600), Some(1)]);
    let unnamed = |more: &str| {
        let text = format!("{}[undo]\nvalues = {{ \"480@2\" = 5 }}\n", file("\"481@1\" = 9.99\n\"480@2\" = 6"));
        antrieb(&format!("-a 1 --yes dataset undo {{dir}}/u.toml {more}")).on(FRESH).file("u.toml", &text)
    };
    let stays = unnamed("").exits(9);
    assert!(stays.err.contains("does not say in [undo]"), "{}", stays.err);
    assert_eq!(cells([(480, 2, false), (481, 1, false)]), [Some(600), Some(1000)]);
    unnamed("--force").exits(0);
}

/// Whatever a hand has written into it: commands, setpoints, restarts and what only the drive tells were never loaded.
#[test]
fn an_undo_file_of_a_hand_brings_back_nothing_that_no_load_writes() {
    for (row, word) in [("410 = 15", "P.410"), ("484 = 10", "P.484"), ("34 = 123", "P.34"), ("411 = 0", "P.411")] {
        let memories = ["eeprom", "ram"].map(|memory| format!("memory = \"{memory}\"\n"));
        for (memory, more) in memories.iter().flat_map(|memory| [(memory, ""), (memory, "--force")]) {
            let text = format!(
                "{}[undo]\n{memory}values = {{ {row}, \"480@2\" = 5 }}\n",
                file(&format!("{row}\n\"480@2\" = 6"))
            );
            let run = antrieb(&format!("-a 1 --yes -v dataset undo {{dir}}/u.toml {more}"));
            let told = run.on(FRESH).file("u.toml", &text).exits(7);
            assert!(told.err.contains(word) && told.err.contains("no load ever writes"), "{row}: {}", told.err);
            assert!(told.err.contains("u.toml:5"), "{}", told.err);
            assert_eq!(writes(&told.sent()), 0, "{row}");
        }
    }
    let servo = "antrieb = 1\n[drive]\nfamily = \"lxm05\"\n[values]\n6914 = 15\n[undo]\nvalues = { 6914 = 0 }\n";
    let run = antrieb("-a 1 --yes --lang de dataset undo {dir}/u.toml").on("[[drive]]\nmodel = \"lxm05\"\n");
    let told = run.file("u.toml", servo).exits(7);
    assert!(told.err.contains("6914") && told.err.contains("schreibt kein Laden"), "{}", told.err);
}

#[test]
fn a_check_names_what_the_drive_works_with_where_that_is_not_what_is_stored() {
    let check =
        |bench: &str| antrieb("-a 1 dataset check {dir}/x.toml").on(bench).file("x.toml", &file("480 = 5")).json();
    let differs = check("[[drive]]\nmodel = \"act\"\nset = { \"480\" = 5, \"480@2ram\" = 7.77 }\n").exits(0);
    assert_eq!(differs.warnings(), ["check.in_force"], "{:#}", differs.value);
    assert!(differs.value["warnings"].to_string().contains("P.480@2: stored is 5.00 Hz, the drive works with 7.77 Hz"));
    assert!(check("[[drive]]\nmodel = \"act\"\nset = { \"480\" = 5 }\n").exits(0).warnings().is_empty());
}
