//! `dataset load` and `dataset undo`: what goes from a file into a drive, what does not, and what is said of it.

use crate::run::{Output, Run, antrieb};
use antrieb::transport::witness;

/// An ACT whose settings were changed.
const CHANGED: &str =
    "[[drive]]\nmodel = \"act\"\nset = { \"30\" = 210, \"372@2\" = 1450, \"480@3\" = -12.5, \"392@4\" = 0 }\n";
const FRESH: &str = "[[drive]]\nmodel = \"act\"\n";

fn file(values: &str) -> String {
    format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}\n")
}

fn load(values: &str, more: &str) -> Run {
    antrieb(&format!("-a 1 --yes dataset load {{dir}}/f.toml {more}")).on(FRESH).file("f.toml", &file(values))
}

/// Another command on the bench that this one has left, in its directory.
fn then(ended: Output, line: &str) -> Run {
    let (bench, at) = witness::left().unwrap();
    witness::stands(bench, at);
    ended.then(&format!("-p sim:{{dir}}/bench.toml {line}"))
}

/// Settings saved, a drive with its factory settings, loaded: the same; and taken back, the factory settings again.
fn round_trip(changed: &str, fresh: &str, options: &str) {
    let saved = antrieb(&format!("{options} -a 1 dataset save {{dir}}/f.toml")).on(changed).exits(0);
    let text = saved.text_of("f.toml");
    let loading = format!("{options} -a 1 --yes dataset load {{dir}}/f.toml");
    let loaded = antrieb(&loading).on(fresh).file("f.toml", &text).exits(0);
    assert!(loaded.out.contains("done, every value proven"), "{}", loaded.out);
    let same = then(loaded, &format!("{options} -a 1 dataset check {{dir}}/f.toml"));
    let same = same.exits(0);
    let undone = then(same, &format!("{options} -a 1 --yes dataset undo {{dir}}/f.undo.toml")).exits(0);
    then(undone, &format!("{options} -a 1 dataset check {{dir}}/f.toml")).exits(1);
}

#[test]
fn what_was_saved_and_loaded_is_the_same_over_every_protocol_and_family() {
    let acu = "[[drive]]\nmodel = \"acu\"\nmodules = [\"EM-RES-03\"]\n";
    let set = "set = { \"30\" = 210, \"372@2\" = 1450, \"931\" = 77, \"412@1\" = 1 }\n";
    let servo = "[[drive]]\nmodel = \"lxm05\"\n";
    for (keys, options) in [
        ("", ""),
        ("protocol = \"ascii\"\n", "--protocol ascii"),
        ("protocol = \"vabus\"\n", "--protocol vabus --drive acu"),
    ] {
        round_trip(&format!("{acu}{keys}{set}"), &format!("{acu}{keys}"), options);
        let act = options.replace("acu", "act");
        round_trip(&format!("{FRESH}{keys}{}", set.replace("\"931\" = 77, ", "")), &format!("{FRESH}{keys}"), &act);
    }
    round_trip(&format!("{servo}set = {{ RAMPacc = 3000, GEARdenom = 7 }}\n"), servo, "");
}

#[test]
fn what_the_drive_has_already_is_not_written_and_later_files_lie_over_earlier_ones() {
    let run = antrieb("-a 1 --yes -v dataset load {dir}/a.toml {dir}/b.toml").on(CHANGED);
    let run = run.file("a.toml", &file("372 = 1400\n\"480@3\" = -12.5")).file("b.toml", &file("372 = 1450"));
    let ended = run.exits(0);
    let writes =
        ended.questions().iter().filter(|sent| sent.starts_with("01 06 ") || sent.starts_with("01 65 ")).count();
    assert_eq!(writes, 3, "{}", ended.err);
}

#[test]
fn groups_parameters_and_data_sets_pick_what_is_written() {
    let values = "372 = 1440\n424 = 20\n\"480@1\" = 7\n418 = 4\n10 = 3";
    for (more, expected) in [
        ("--only motor", vec![(372, 1), (372, 2), (372, 3), (372, 4)]),
        ("--only @Motor,RAMPS --sets 2", vec![(372, 2), (424, 2)]),
        ("--only motor --sets 2-4", vec![(372, 2), (372, 3), (372, 4)]),
        ("--except motor,ramps,480-483", vec![(418, 0)]),
        ("--only rated-speed,418 --sets 0,3", vec![(372, 3), (418, 0)]),
    ] {
        let document = load(values, more).json().exits(0).value;
        let rows = document["data"]["values"].as_array().unwrap();
        let mut found: Vec<_> = rows.iter().map(|row| (row["param"].as_u64(), row["data_set"].as_u64())).collect();
        found.sort_unstable();
        let mut expected: Vec<_> = expected.into_iter().map(|(id, set)| (Some(id), Some(set))).collect();
        expected.sort_unstable();
        assert_eq!(found, expected, "{more}");
    }
    let unknown = load(values, "--only pumps").exits(2).err;
    assert!(unknown.contains("'pumps' names no group") && unknown.contains("ramps"), "{unknown}");
    // The first letters of P.434 in German, and the ramps of who types it.
    let ramps = load(values, "--except rampen").exits(2).err;
    assert!(ramps.contains("'rampen' names no group") && ramps.contains("ramps"), "{ramps}");
}

#[test]
fn bus_settings_are_left_out_until_somebody_asks_and_what_cuts_the_line_is_refused() {
    let out = load("10 = 3\n372 = 1440", "").exits(0).out;
    assert!(out.contains("left out until named  10"), "{out}");
    let asked = load("10 = 3\n372 = 1440", "--only bus").exits(0);
    assert!(asked.err.contains("P.10 take effect after a restart") || asked.err.contains("P.10"), "{}", asked.err);
    assert!(asked.out.contains("Baud rate"), "{}", asked.out);
    let cut = load("1376 = 3\n372 = 1440", "--only bus,motor").exits(8);
    assert!(cut.err.contains("can cut the line at once") && cut.err.contains("nothing was written"), "{}", cut.err);
    assert!(!cut.out.contains("verified"), "{}", cut.out);
    load("1376 = 1", "--only bus").exits(0);
}

#[test]
fn a_drive_that_runs_gets_no_file() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"410\" = 15, \"484\" = 10 }\n";
    let run = antrieb("-a 1 --yes dataset load {dir}/f.toml").on(bench).file("f.toml", &file("372 = 1440"));
    let ended = run.exits(8);
    assert!(ended.err.contains("runs (Operation enabled)"), "{}", ended.err);
}

#[test]
fn a_file_of_another_family_a_newer_format_or_broken_content_is_refused_with_its_place() {
    let refused = |text: &str| {
        let run = antrieb("-a 1 --yes -v dataset load {dir}/f.toml").on(FRESH).file("f.toml", text).exits(7);
        assert!(!run.sent().iter().any(|sent| sent.starts_with("01 06")), "{}", run.err);
        run.err
    };
    let other = file("372 = 1440").replace("act", "acu");
    let told = refused(&other);
    assert!(told.contains("f.toml:3:10: the file is for drives of the family acu, drive 1 is"), "{told}");
    let newer = refused(&file("372 = 1440").replace("antrieb = 1", "antrieb = 9"));
    assert!(newer.contains("f.toml:1:11: format 9 is newer"), "{newer}");
    for (values, place) in [
        ("372 = \"1440 kW\"", "f.toml:5:7:"),
        ("rated-sped = 1", "f.toml:5:1:"),
        ("\"372@7\" = 1", "f.toml:5:1:"),
        ("372 = ", "f.toml:5:"),
        ("372 = 1440\n\"372@0\" = 1", "f.toml:6:1:"),
    ] {
        let told = refused(&file(values));
        assert!(told.contains(place), "{values}: {told}");
    }
    let half = refused(&file("372 = 1440").replace("[values]", "[saved]\ncomplete = false\n[values]"));
    assert!(half.contains("not complete"), "{half}");
}

#[test]
fn nobody_who_says_no_or_is_not_there_gets_anything_written_and_no_undo_file_is_left() {
    let quiet = antrieb("-a 1 dataset load {dir}/f.toml").on(FRESH).file("f.toml", &file("372 = 1440"));
    let ended = quiet.exits(8);
    assert!(ended.err.contains("P.372@1-4 Rated Speed: 1390 -> 1440 1/min"), "{}", ended.err);
    assert!(!ended.directory().join("f.undo.toml").exists());
    let no = antrieb("-a 1 dataset load {dir}/f.toml").on(FRESH).file("f.toml", &file("372 = 1440")).answered("n");
    assert!(!no.exits(8).directory().join("f.undo.toml").exists());
}

#[test]
fn without_an_undo_file_nothing_is_written() {
    let run = load("372 = 1440", "--undo-file {dir}/taken.toml -v").file("taken.toml", "mine");
    let ended = run.exits(7);
    assert!(ended.err.contains("the undo file cannot be written: the file exists already"), "{}", ended.err);
    assert_eq!(ended.text_of("taken.toml"), "mine");
    assert!(!ended.sent().iter().any(|sent| sent.starts_with("01 06")), "{}", ended.err);
    let second = load("372 = 1440", "").file("f.undo.toml", "mine").exits(0);
    assert!(second.out.contains("f.undo-2.toml"), "{}", second.out);
}

/// P.392 = 1 is taken in some configurations only, and the drive takes it away when the configuration changes: on the way there
/// and on the way back the configuration goes first.
#[test]
fn a_configuration_goes_before_what_it_changes_there_and_back() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"30\" = 110, \"392@1\" = 1 }\n";
    let run = |values: &str, code: u8| {
        antrieb("-a 1 --yes dataset load {dir}/f.toml").on(bench).file("f.toml", &file(values)).exits(code)
    };
    let changed = run("30 = 210\n372 = 1440", 0);
    assert!(changed.err.contains("the drive changed P.392@1 by itself: 1 -> 2"), "{}", changed.err);
    let undone = then(changed, "-a 1 --yes dataset undo {dir}/f.undo.toml").exits(0);
    assert!(then(undone, "-a 1 read 392@1 30").exits(0).out.contains("DC brake"));
    let failed = run("30 = 210\n372 = 1440\n376 = 0", 9);
    assert!(failed.out.contains("as before, proven"), "{}", failed.out);
    let values = then(failed, "-a 1 read 392@1 30 372").exits(0).out;
    assert!(values.contains("DC brake") && values.contains("110") && values.contains("1390"), "{values}");
}

#[test]
fn an_undo_file_belongs_to_one_drive_and_leaves_what_somebody_changed_since() {
    let undo =
        "antrieb = 1\n[drive]\nfamily = \"act\"\naddress = 3\n[values]\n372 = 1400\n[undo]\nvalues = { 372 = 1390 }\n";
    let run = |text: &str, more: &str| {
        antrieb(&format!("-a 1 --yes dataset undo {{dir}}/u.toml {more}")).on(FRESH).file("u.toml", text)
    };
    let other = run(undo, "").exits(7).err;
    assert!(other.contains("address 3, not 1"), "{other}");
    run(undo, "--force").exits(0);
    let since = undo.replace("address = 3\n", "").replace("372 = 1390", "372 = 1380");
    let told = run(&since, "").exits(9);
    assert!(
        told.err.contains(
            "reads as 1390 1/min, which is neither the value before the load (1400 1/min) nor the one that it was to \
             write (1380 1/min)"
        ),
        "{}",
        told.err
    );
    run(&since, "--force").exits(0);
    // Another line may have a drive of equal family and address: that is for the user to know, before he is asked and behind it.
    let elsewhere = undo.replace("address = 3\n", "address = 1\n[saved]\nport = \"/dev/ttyUSB7\"\n");
    let line = "-a 1 dataset undo {dir}/u.toml";
    let asked = antrieb(line).on(FRESH).file("u.toml", &elsewhere).answered("n").exits(8).err;
    assert!(asked.contains("was left at /dev/ttyUSB7, this is sim:"), "{asked}");
    let told = antrieb(&format!("--yes {line}")).on(FRESH).file("u.toml", &elsewhere).json().exits(0);
    assert!(told.warnings().contains(&"undo.other_port"), "{:#}", told.value);
    let none = run(&file("372 = 1400"), "").exits(7).err;
    assert!(none.contains("has no table [undo]"), "{none}");
    // That it is none goes before whose it is.
    let none = run(&file("372 = 1400").replace("[values]", "address = 3\n[values]"), "").exits(7).err;
    assert!(none.contains("has no table [undo]"), "{none}");
    // Where nobody can be asked, what would have been asked about is told.
    let quiet = antrieb("-a 1 dataset undo {dir}/u.toml").on(FRESH).file("u.toml", &undo.replace("address = 3\n", ""));
    let told = quiet.json().exits(8);
    assert_eq!((told.data("/ended"), told.data("/values/0/raw")), (&"untouched".into(), &1400.into()));
}

#[test]
fn what_starts_the_shaft_by_its_new_values_is_said() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1 }\n";
    let run = antrieb("-a 1 --yes dataset load {dir}/f.toml").on(bench).file("f.toml", &file("412 = 0"));
    let ended = run.exits(0);
    assert!(ended.err.contains("MOTION: this can start the shaft"), "{}", ended.err);
    assert!(ended.err.contains("drive 1 RUNS with its new values"), "{}", ended.err);
}

#[test]
fn a_save_goes_on_with_the_drive_that_it_was_begun_with() {
    let part = "antrieb = 1\n[drive]\nfamily = \"act\"\naddress = 2\n[saved]\ncomplete = false\n[not-held]\nnot-asked = \"480\"\n[values]\n372 = 1400\n";
    let run = antrieb("-a 1 --drive ACT dataset save {dir}/x.toml --resume").on(FRESH).file("x.toml.part", part).json();
    assert_eq!(run.error()["code"], "data.other_drive", "{}", run.error());
    // Family and address are alike on every line; a port that has another name by now is told by --force.
    let part = part.replace("address = 2\n[saved]\n", "address = 1\n[saved]\nport = \"/dev/ttyUSB7\"\n");
    let on = |more: &str| {
        let line = format!("-a 1 --drive act dataset save {{dir}}/x.toml --resume {more}");
        antrieb(&line).on(FRESH).file("x.toml.part", &part).json()
    };
    let other = on("").exits(7);
    assert_eq!(other.error()["code"], "data.other_drive", "{}", other.error());
    assert!(other.error()["hint"].as_str().unwrap().contains("--resume --force"), "{}", other.error());
    on("--force").exits(0);
}

/// The file of the other pump is the commonest slip: it is said, and refuses nothing.
#[test]
fn a_file_that_names_another_address_is_told_before_and_behind_the_question() {
    let of_two = file("372 = 1450").replace("family = \"act\"", "family = \"act\"\naddress = 2");
    let run = |line: &str| antrieb(line).on(FRESH).file("f.toml", &of_two).file("base.toml", &file("480 = 5"));
    let told = "f.toml names address 2 in its head, this drive has 1";
    for line in ["-a 1 --yes dataset load {dir}/base.toml {dir}/f.toml", "-a 1 --dry-run dataset load {dir}/f.toml"] {
        let ended = run(line).exits(0);
        assert!(ended.page().contains(told), "{}", ended.page());
        let document = run(line).json().exits(0);
        assert!(document.warnings().contains(&"load.other_address"), "{:#}", document.value);
    }
    let asked = run("-a 1 dataset load {dir}/f.toml").answered("n").run();
    assert!(asked.err.contains(told), "{}", asked.err);
    run("-a 1 --lang de --yes dataset load {dir}/f.toml").exits(0);
    // Of two drives of a plant that share it, the other one is told of.
    let project = "[drives.a]\naddress = 2\nfiles = [\"f.toml\"]\n[drives.b]\naddress = 1\nfiles = [\"f.toml\"]\n";
    let two = format!("{FRESH}address = 1\n{FRESH}address = 2\n");
    let planned = antrieb("plan").on(&two).file("f.toml", &of_two).file("antrieb.toml", project).json().exits(1);
    assert_eq!(planned.warnings(), ["load.other_address"], "{:#}", planned.value);
}

/// What can be known before the first byte is told before a drive is asked for anything.
#[test]
fn an_undo_file_that_cannot_be_left_is_told_before_a_drive_is_asked() {
    let values = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"480@2\" = \"20 Hz\"\n";
    for (place, why) in [("none/where.toml", "No such file"), ("", "directory")] {
        let line = format!("-v -a 1 dataset load {{dir}}/new.toml --yes --undo-file {{dir}}/{place}");
        let run = antrieb(&line).on("[[drive]]\nmodel = \"act\"\naddress = 1\n").file("new.toml", values);
        let refused = run.exits(7);
        assert!(refused.sent().is_empty() && refused.err.contains(why), "{place}: {}", refused.err);
    }
    let run = antrieb("-v -a 1-3 init {dir}/none/plant.toml").on("[[drive]]\nmodel = \"act\"\naddress = 1\n").exits(7);
    assert!(run.sent().is_empty(), "{}", run.err);
}
