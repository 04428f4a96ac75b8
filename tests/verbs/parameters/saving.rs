//! `dataset save`: what a file holds, how many telegrams it takes, and what is left of a save that was interrupted.

use crate::run::{Output, antrieb};
use antrieb::profile::paramfile::{NotHeld, ParamFile};
use antrieb::profile::{Param, Registry, Sets};

/// An ACU in which much was set, also by data sets.
const CUBE: &str = "[[drive]]\nmodel = \"acu\"\naddress = 1\nmodules = [\"EM-RES-03\"]\n\
                    set = { \"372@2\" = 1450, \"480\" = -12.5, \"480@3\" = 7.25, \"395\" = 2, \"700\" = 0 }\n";

fn cube(set: &str) -> String {
    format!("[[drive]]\nmodel = \"acu\"\naddress = 1\nmodules = [\"EM-RES-03\"]\nset = {{ {set} }}\n")
}

/// Lines of the values, without their remarks.
fn values(text: &str) -> Vec<&str> {
    let values = text.split("[values]\n").nth(1).unwrap().lines();
    values.map(|line| line.split("  #").next().unwrap()).collect()
}

fn file(text: &str) -> ParamFile {
    ParamFile::parse("x.toml", text).unwrap()
}

/// A reply that is late, a drive that is busy for a moment, a refusal without a cause: none says anything of the parameter. It is in the file, or the
/// save is not complete.
#[test]
fn no_value_is_missing_from_a_file_that_is_complete() {
    let bench = |disturb: &str| format!("{}{disturb}", cube("\"372@3\" = 1000, \"480@3\" = 9"));
    let saved = |disturb: &str| antrieb("--json -a 1 dataset save {dir}/pump.toml").on(&bench(disturb)).run();
    let whole = saved("");
    assert_eq!(whole.exit, 0);
    let count = |output: &Output| {
        let told: serde_json::Value = serde_json::from_str(&output.out).unwrap();
        let saved = &told["data"]["saved"][0];
        (saved["complete"] == true, saved["values"].as_array().unwrap().len())
    };
    let (_, all) = count(&whole);
    let late =
        [3, 5, 9, 23, 26, 40].map(|once| format!("[[disturb]]\nonce = {once}\nkind = \"late\"\nby = \"1200ms\"\n"));
    let refused = |code, once| format!("[[disturb]]\nonce = {once}\nkind = \"exception\"\nbyte = {code}\n");
    let once = (1..=8).map(|code| refused(code, 45));
    // Twice without a cause: P.11 is read between, and tells none.
    let twice = [(4, 47), (5, 46)].map(|(code, again)| refused(code, 45) + &refused(code, again));
    for disturb in late.into_iter().chain(once).chain(twice) {
        let run = saved(&disturb);
        let (is_complete, values) = count(&run);
        // Also where the sets were asked one by one because a cause was lost: what is equal in all is one line.
        let is_whole = values == all;
        assert_eq!((is_complete, run.exit), (is_whole, if is_whole { 0 } else { 9 }), "{disturb}: {}", run.err);
        if !is_complete {
            let file = run.text_of("pump.toml.part");
            let resumed = antrieb("--json -a 1 dataset save {dir}/pump.toml --resume --force").on(&bench(""));
            let (is_complete, values) = count(&resumed.file("pump.toml.part", &file).exits(0));
            assert!(is_complete && values == all, "{disturb}: {values} of {all}");
        }
    }
}

#[test]
fn a_file_holds_every_setting_and_says_what_it_does_not_hold() {
    let run = antrieb("-a 1 dataset save {dir}/pump.toml").on(&cube("\"372@2\" = 1450, \"480\" = -12.5")).exits(0);
    let text = run.text_of("pump.toml");
    let lines = values(&text);
    for line in [
        "\"30\" = \"110\"",
        "\"372@1\" = \"1390 1/min\"",
        "\"372@2\" = \"1450 1/min\"",
        "\"372@4\" = \"1390 1/min\"",
        "\"480\" = \"-12.50 Hz\"",
        "\"417\" = \"raw 0\"",
        "\"1376\" = \"1\"",
    ] {
        assert!(lines.contains(&line), "{line} in\n{text}");
    }
    let family = Registry::open(&[]).unwrap().family("acu").unwrap();
    let file = file(&text);
    let settings = file.settings(&family).unwrap();
    let held: Vec<u32> = settings.params().map(|param| param.id).collect();
    let left: Vec<u32> =
        file.head.not_held.values().flat_map(|list| antrieb::profile::paramfile::numbers(list).unwrap()).collect();
    for number in family.params.keys() {
        assert!(held.contains(number) != left.contains(number), "{number} is held, or it is said why not");
    }
    assert_eq!(file.head.not_held[&NotHeld::RamOnly], "34, 410");
    assert_eq!(file.head.saved.signature, Some(settings.signature("acu").to_string()));
    assert!(file.head.saved.complete);
    assert!(!run.directory().join("pump.toml.part").exists());
}

/// A drive takes one question for each parameter, five more for each that differs between data sets, and what recognising it
/// takes. What it does not have is refused, and the cause is read: two questions, for a drive of which no source says that it
/// has it not.
#[test]
fn a_save_takes_at_most_n_and_6_d_and_10_telegrams() {
    let everywhere: &[&str] = &["rtu", "ascii", "vabus"];
    let servo = "[[drive]]\nmodel = \"lxm05\"\naddress = 1\nset = { }\n".to_owned();
    let act = servo.replace("lxm05", "act");
    for (drive, bench, protocols, ds, least) in [
        ("acu", cube(""), everywhere, &[0, 1, 3, 12][..], 150),
        ("act", act, everywhere, &[0, 2], 80),
        ("lxm05", servo, &["rtu"], &[0], 15),
    ] {
        let family = Registry::open(&[]).unwrap().family(drive).unwrap();
        let settable = |param: &&Param| {
            let has_room = param.max.is_none_or(|max| max >= 3) && ![412, 381, 434].contains(&param.id);
            param.sets == Some(Sets::Four) && has_room && (param.module.is_none() || drive == "acu")
        };
        for (protocol, &d) in protocols.iter().flat_map(|protocol| ds.iter().map(move |d| (*protocol, d))) {
            let some = family.params.values().filter(settable).take(d);
            let set: Vec<_> = some.map(|param| format!("\"{}@3\" = 3", param.id)).collect();
            let set = format!("set = {{ {} }}", set.join(", "));
            let bench = bench.replace("set = {  }", &set).replace("set = { }", &set);
            let bench = bench.replace("address = 1", &format!("address = 1\nprotocol = \"{protocol}\""));
            let line = format!("--protocol {protocol} -v -a 1 dataset save {{dir}}/x.toml");
            let run = antrieb(&line).on(&bench).exits(0);
            let file = file(&run.text_of("x.toml"));
            let settings = file.settings(&family).unwrap();
            let n = settings.params().count();
            let differing = settings.params().filter(|param| settings.exactly(param.id, 1).is_some()).count();
            let refused = file
                .head
                .not_held
                .get(&NotHeld::Refused)
                .map_or(0, |list| antrieb::profile::paramfile::numbers(list).unwrap().len());
            // The closing EOT of VABus is no question, and asks for nothing.
            let asked = run.sent().iter().filter(|telegram| *telegram != "04").count();
            let case = format!("{drive} {protocol}: {asked} telegrams, n = {n}, d = {d}, refused {refused}");
            assert!(n > least && differing == d && (refused == 0 || drive == "act"), "{case}, differ {differing}");
            assert!(asked <= n + 6 * d + 2 * refused + 10, "{case}");
        }
    }
}

#[test]
fn only_what_was_changed_is_saved_if_that_is_asked_for() {
    let bench = cube("\"480@3\" = 7.25, \"419\" = 60, \"372@2\" = 1450, \"395\" = 2");
    let run = antrieb("-a 1 -v dataset save --changed {dir}/pump.toml").on(&bench).exits(0);
    let text = run.text_of("pump.toml");
    assert_eq!(values(&text), ["\"395\" = \"2\"", "\"419\" = \"60.00 Hz\"", "\"480@3\" = \"7.25 Hz\""], "{text}");
    let head = file(&text).head;
    // No source tells the factory setting of the rated speed: it is not even asked.
    let numbers = |reason| antrieb::profile::paramfile::numbers(&head.not_held[&reason]).unwrap();
    assert!(numbers(NotHeld::NoKnownFactorySetting).contains(&372));
    assert!(numbers(NotHeld::FactorySetting).contains(&413));
    assert!(!run.sent().iter().any(|telegram| telegram.starts_with("01 03 01 74")), "P.372");
}

/// What was saved of it goes into a drive with factory settings, and it is the same.
#[test]
fn a_file_of_changes_is_replayed() {
    let changed = cube("\"480@3\" = 7.25, \"419\" = 60");
    let saved = antrieb("-a 1 dataset save --changed {dir}/pump.toml").on(&changed).exits(0);
    let text = saved.text_of("pump.toml");
    let loaded = antrieb("-a 1 --yes dataset load {dir}/pump.toml").on(&cube("")).file("pump.toml", &text).exits(0);
    let rows = loaded.out.lines().filter(|line| line.contains("verified"));
    // What the drive speaks (P.395) is a setting of a bus.
    assert_eq!((rows.count(), values(&text).len()), (2, 3), "{}", loaded.out);
    let again = antrieb("-a 1 --yes dataset load {dir}/pump.toml").on(&changed).file("pump.toml", &text).exits(0);
    assert!(!again.out.contains("verified"), "{}", again.out);
}

#[test]
fn a_discovery_finds_what_no_catalogue_knows() {
    // To a program that knows only the ACT, what the resolver module brings is unknown.
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 1\nmodules = [\"EM-RES-03\"]\nset = { \"382\" = -3.1 }\n";
    let run = antrieb("-a 1 --drive act dataset save --discover {dir}/all.toml").on(bench).exits(0);
    let text = run.text_of("all.toml");
    let file = file(&text);
    assert!(values(&text).contains(&"\"382\" = \"65505\""), "{text}");
    assert!(text.contains("# parameter-382"), "{text}");
    let refused = antrieb::profile::paramfile::numbers(&file.head.not_held[&NotHeld::Refused]).unwrap();
    assert!(refused.contains(&0) && refused.contains(&1599) && refused.len() > 1300);
    let refused = antrieb("-a 1 dataset save --discover {dir}/all.toml").on("[[drive]]\nmodel = \"lxm05\"\n").json();
    assert_eq!(refused.exits(7).error()["code"], "data.no_numbers");
}

#[test]
fn an_interrupted_save_says_what_is_missing_and_goes_on_from_there() {
    let bench = CUBE.replace(", \"700\" = 0", "");
    let whole = antrieb("-a 1 dataset save {dir}/pump.toml").on(&bench).exits(0).text_of("pump.toml");
    let silent = format!("{bench}[[drive.event]]\nat = \"1s\"\nsilent = \"10h\"\n");
    let cut = antrieb("-a 1 dataset save {dir}/pump.toml").on(&silent).exits(9);
    assert!(cut.err.contains("parameters are missing") && cut.err.contains("--resume` goes on"), "{}", cut.err);
    assert!(!cut.directory().join("pump.toml").exists(), "a file is never half a file");
    let part = cut.text_of("pump.toml.part");
    let head = file(&part).head;
    assert!(!head.saved.complete && head.not_held.contains_key(&NotHeld::NotAsked), "{part}");

    // Unasked it is neither gone on with nor thrown away.
    let again = cut.then("-a 1 dataset save {dir}/pump.toml").on(&bench).exits(7);
    assert!(again.err.contains("an earlier save was interrupted"), "{}", again.err);
    let resumed = again.then("-v -a 1 dataset save {dir}/pump.toml --resume").on(&bench).exits(0);
    let told = |text: &str| values(text).iter().map(|line| (*line).to_owned()).collect::<Vec<_>>();
    assert_eq!(told(&resumed.text_of("pump.toml")), told(&whole));
    assert!(!resumed.directory().join("pump.toml.part").exists());
    let asked = resumed.sent().len();
    assert!(asked < values(&whole).len(), "only what was missing is asked: {asked}");
    let nothing = antrieb("-a 1 dataset save {dir}/pump.toml --resume").on(&bench).json().exits(7);
    assert_eq!(nothing.error()["code"], "data.resume");
}

#[test]
fn nothing_is_replaced_unasked() {
    let bench = CUBE.replace(", \"700\" = 0", "");
    let run = antrieb("-a 1 dataset save {dir}/pump.toml").on(&bench).file("pump.toml", "precious").exits(7);
    assert!(run.err.contains("--force replaces it"), "{}", run.err);
    assert_eq!(run.text_of("pump.toml"), "precious");
    assert!(
        run.then("-a 1 --force dataset save {dir}/pump.toml").on(&bench).exits(0).text_of("pump.toml").len() > 1000
    );
}

#[test]
fn what_cannot_be_written_is_told_before_the_drive_is_asked_for_it() {
    let run = antrieb("-v -a 1 dataset save {dir}/none/pump.toml").on(&cube("")).exits(7);
    assert!(run.err.contains("is no directory") && run.sent().is_empty(), "{}", run.err);
    // A directory stands where the part is to be.
    let run =
        antrieb("-v -a 1 dataset save --force {dir}/pump.toml").on(&cube("")).file("pump.toml.part/x", "").exits(7);
    assert!(run.err.contains("pump.toml.part") && run.sent().len() < 10, "{}", run.err);
    // Nothing is left of a drive that says nothing.
    let silent = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive.event]]\nat = \"22ms\"\nsilent = \"10h\"\n";
    let run = antrieb("-a 1 --drive act dataset save {dir}/pump.toml").on(silent).exits(4);
    assert_eq!(std::fs::read_dir(run.directory()).unwrap().count(), 1, "the bench alone");
}

#[test]
fn several_drives_get_a_file_each() {
    let line =
        |rest: &str| -> Output { antrieb(&format!("-p sim -a 1,2 dataset save {rest}")).file("all/x", "").run() };
    let named = line("{dir}/drive-{address}.toml");
    assert_eq!(named.exit, 0, "{}", named.err);
    assert!(named.text_of("drive-1.toml").contains("family = \"act\""));
    assert!(named.text_of("drive-2.toml").contains("family = \"acu\""));
    let directory = line("{dir}/all");
    assert!(directory.text_of("all/drive-1.toml").contains("address = 1"));
    assert!(directory.text_of("all/drive-2.toml").contains("address = 2"));
    assert_eq!(line("{dir}/one.toml").exit, 2);
    let partly = antrieb("-p sim -a 1,7 dataset save {dir}/{address}.toml").json().exits(9);
    assert_eq!(partly.data("/saved/0/complete"), true);
    assert_eq!(partly.data("/saved/1/error/class"), "silence");
}

/// What the manuals leave open changes nothing in a file, but that a drive that shows the value in force is saved so.
#[test]
fn a_file_is_the_same_whatever_the_manuals_leave_open() {
    let act = |readings: &str, protocol: &str| {
        format!(
            "[[drive]]\nmodel = \"act\"\naddress = 1\nprotocol = \"{protocol}\"\nreadings = {{ {readings} }}\n\
             set = {{ \"372@2\" = 1450, \"480\" = -12.5, \"480@3ram\" = 7 }}\n"
        )
    };
    for protocol in ["rtu", "vabus"] {
        let saved = |readings: &str| {
            let line = format!("--protocol {protocol} -a 1 dataset save {{dir}}/x.toml");
            let text = antrieb(&line).on(&act(readings, protocol)).exits(0).text_of("x.toml");
            text[text.find("[not-held]").unwrap()..].to_owned()
        };
        let usual = saved("");
        for readings in [
            "unknown_parameter = \"2\"",
            "set_character = \"as-asked\"",
            "after_nak = \"silence\"",
            "wrong_bcc = \"silence\"",
            "line_reply = \"lost\"",
        ] {
            assert_eq!(saved(readings), usual, "{protocol} {readings}");
        }
        let in_force = saved("ram_reads = \"in-force\"");
        assert!(in_force.contains("\"480@3\" = \"7.00 Hz\"") && !usual.contains("480@3"), "{in_force}");
    }
    let servo = |readings: &str| {
        let bench = format!(
            "[[drive]]\nmodel = \"lxm05\"\naddress = 1\nreadings = {{ {readings} }}\nset = {{ RAMPacc = 500 }}\n"
        );
        let text = antrieb("-a 1 dataset save {dir}/x.toml").on(&bench).exits(0).text_of("x.toml");
        text[text.find("[not-held]").unwrap()..].to_owned()
    };
    let usual = servo("");
    assert!(usual.contains("\"1556\" = \"500 1/min*s\""), "{usual}");
    for readings in
        ["exceptions = \"1\"", "exceptions = \"4\"", "flt_err_num = \"moves-on\"", "code_23 = \"reads-first\""]
    {
        assert_eq!(servo(readings), usual, "{readings}");
    }
}

#[test]
fn a_node_of_the_system_bus_is_saved_through_its_master() {
    let bench = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\naddress = 3\n\
                 nodes = [{ id = 17, model = \"acu\", set = { \"372@2\" = 2800 } }]\n";
    let line = "--protocol vabus -a 3.17 dataset";
    let saved = antrieb(&format!("{line} save {{dir}}/node.toml")).on(bench).exits(0);
    let text = saved.text_of("node.toml");
    assert!(text.contains("node = 17") && text.contains("\"372@2\" = \"2800 1/min\""), "{text}");
    saved.then(&format!("{line} check {{dir}}/node.toml")).on(bench).exits(0);
}

#[test]
fn what_was_saved_is_told_as_json_and_csv_too() {
    let on = cube("\"372@2\" = 1450");
    let document = antrieb("-a 1 dataset save {dir}/x.toml").on(&on).json().exits(0);
    let values = document.data("/saved/0/values").as_array().unwrap();
    let value = values.iter().find(|value| value["param"] == 372 && value["data_set"] == 2).unwrap();
    assert_eq!((&value["raw"], &value["unit"], &value["store"]), (&1450.into(), &"1/min".into(), &"eeprom".into()));
    let csv = antrieb("-a 1 --format csv dataset save {dir}/x.toml").on(&on).exits(0).out;
    assert_eq!(csv.lines().count(), values.len() + 1);
    let head: Vec<&str> = csv.lines().next().unwrap().split(',').collect();
    let column = |name: &str| head.iter().position(|own| *own == name).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().skip(1).map(|line| line.split(',').collect()).collect();
    let told = |number: &str, set: &str| {
        let row = rows.iter().find(|row| row[column("param")] == number && row[column("data_set")] == set).unwrap();
        ["raw", "value", "unit", "store"].map(|name| row[column(name)])
    };
    assert_eq!(told("372", "2"), ["1450", "1450", "1/min", "eeprom"]);
    assert_eq!(told("480", "0")[..3], ["500", "5.0", "Hz"]);
    let planned = antrieb("-a 1 dataset save --dry-run {dir}/x.toml").on(&on).json().exits(0);
    assert_eq!(planned.data("/telegrams").as_array().unwrap().len(), 166);
}

#[test]
fn several_drives_go_on_where_each_of_them_was() {
    let drive = |address: u8| format!("[[drive]]\nmodel = \"act\"\naddress = {address}\n");
    let bench = drive(1) + &drive(2) + &drive(3);
    let cut = format!("{}{}[[drive.event]]\nafter_telegrams = 60\nsilent = \"10h\"\n{}", drive(1), drive(2), drive(3));
    let line = "-a 1-3 dataset save {dir}/{address}.toml";
    let ended = antrieb(line).on(&cut).exits(9);
    assert!(ended.directory().join("1.toml").exists() && ended.directory().join("2.toml.part").exists());
    // The third was not begun at all.
    std::fs::remove_file(ended.directory().join("3.toml")).unwrap();
    let again = ended.then(&format!("-v {line} --resume")).on(&bench).json().exits(0);
    for nth in 0..3 {
        assert_eq!(again.data(&format!("/saved/{nth}/complete")), true, "{:#}", again.value);
        assert!(again.data(&format!("/saved/{nth}/values")).as_array().unwrap().len() > 50);
    }
}

#[test]
fn what_was_begun_in_one_scope_is_not_gone_on_with_in_another() {
    let part = "antrieb = 1\n[drive]\nfamily = \"act\"\naddress = 1\n[saved]\nscope = \"settings\"\ncomplete = false\n[values]\n";
    let run = |more: &str| {
        let line = format!("-a 1 -v dataset save {{dir}}/x.toml --resume {more}");
        antrieb(&line).on("[[drive]]\nmodel = \"act\"\n").file("x.toml.part", part)
    };
    for more in ["--changed", "--discover"] {
        let ended = run(more).exits(2);
        assert!(ended.err.contains("was begun as `settings`") && ended.sent().is_empty(), "{}", ended.err);
    }
    run("").exits(0);
}

#[test]
fn a_value_that_moves_is_none_also_if_it_was_read_before_the_interruption() {
    let part = "antrieb = 1\n[drive]\nfamily = \"act\"\naddress = 1\n[saved]\nscope = \"discovered\"\ncomplete = false\n\
                [not-held]\nnot-asked = \"480\"\n[values]\n382 = 1\n";
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 1\nmodules = [\"EM-RES-03\"]\nset = { \"382\" = -3.1 }\n";
    let run =
        antrieb("-a 1 --drive act dataset save {dir}/x.toml --resume").on(bench).file("x.toml.part", part).exits(0);
    let text = run.text_of("x.toml");
    assert!(!text.contains("\"382\" ="), "{text}");
    let moving = antrieb::profile::paramfile::numbers(&file(&text).head.not_held[&NotHeld::ActualValue]).unwrap();
    assert!(moving.contains(&382), "{text}");
}

#[cfg(unix)]
#[test]
fn where_no_file_can_stand_nothing_is_begun() {
    let linked = antrieb("-a 1 -v --force dataset save {dir}/link.toml").on(&cube(""));
    std::os::unix::fs::symlink(linked.directory().join("other.toml"), linked.directory().join("link.toml")).unwrap();
    let ended = linked.exits(7);
    assert!(ended.err.contains("this is a symbolic link") && ended.sent().is_empty(), "{}", ended.err);
    assert!(!ended.directory().join("link.toml.part").exists());
}

#[test]
fn a_long_whose_width_no_source_tells_is_saved_loaded_and_undone_where_its_data_sets_differ() {
    let bench = "[[drive]]\nmodel = \"act\"\nfour = [518]\nset = { \"518\" = 1, \"518@4\" = 2 }\n";
    let saved = antrieb("-a 1 --drive act dataset save {dir}/a.toml").on(bench).exits(0).text_of("a.toml");
    let held: Vec<&str> = values(&saved).into_iter().filter(|line| line.starts_with("\"518")).collect();
    assert_eq!(held.len(), 4, "{held:?}");
    let text = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n518 = 3\n";
    let loaded = antrieb("-a 1 --yes dataset load {dir}/f.toml").on(bench).file("f.toml", text).exits(0);
    assert!(loaded.err.contains("1.00, 1.00, 1.00, 2.00") || loaded.err.contains("2.00 -> 3.00"), "{}", loaded.err);
}

#[test]
fn a_save_that_is_gone_on_with_without_its_catalogue_is_not_complete() {
    let catalogue = "schema = 1\nfamily = \"active\"\nparams = [{ id = 508, slug = \"spare\", en = \"Spare\", de = \"Reserve\", access = \"rw\", source = \"s\" }]\n";
    let silent = "[[drive]]\nmodel = \"act\"\n[[drive.event]]\nat = \"1s\"\nsilent = \"10h\"\n";
    let begun = antrieb("--catalogue {dir}/own.toml -a 1 dataset save {dir}/a.toml").on(silent);
    let begun = begun.file("own.toml", catalogue).exits(9);
    let on = begun.then("-a 1 dataset save {dir}/a.toml --resume").on("[[drive]]\nmodel = \"act\"\n").exits(9);
    assert!(on.err.contains("the catalogues and options with which the save was begun"), "{}", on.err);
}

/// Another firmware has another width than the catalogue: the drive has the parameter, and says so.
#[test]
fn a_width_that_a_catalogue_is_wrong_about_costs_no_value() {
    for unknown in ["4", "2"] {
        let odd = "other_width = [372, 480]\nset = { \"372@2\" = 1450, \"480\" = 7.25 }";
        let bench = format!("[[drive]]\nmodel = \"acu\"\n{odd}\nreadings = {{ unknown_parameter = \"{unknown}\" }}\n");
        let saved = antrieb("-a 1 dataset save {dir}/a.toml").on(&bench).exits(0).text_of("a.toml");
        for line in ["\"372@2\" = \"1450 1/min\"", "\"480\" = \"7.25 Hz\""] {
            assert!(values(&saved).iter().any(|value| value.starts_with(line)), "{saved}");
        }
        // What was written of such a parameter is taken back too.
        let other = saved.replace("1450 1/min", "1400 1/min").replace("7.25 Hz", "8 Hz");
        let loaded = antrieb("-a 1 --yes dataset load {dir}/b.toml").on(&bench).file("b.toml", &other).exits(0);
        let undone = loaded
            .then("-a 1 --yes dataset undo {dir}/b.undo.toml")
            .on(&bench.replace("7.25", "8").replace("1450", "1400"));
        assert!(undone.exits(0).out.contains("7.25"));
    }
}

/// Nor is it a parameter that the drive does not have where it is busy at the width that is right.
#[test]
fn a_drive_that_is_busy_at_the_other_width_has_the_parameter() {
    let bench = "[[drive]]\nmodel = \"acu\"\nother_width = [480]\n";
    let sent = antrieb("-v -a 1 dataset save {dir}/a.toml").on(bench).exits(0).sent();
    let asked = sent.iter().position(|hex| hex.starts_with("01 03 01 E0")).unwrap() + 1;
    let busy = |once: usize| format!("[[disturb]]\nonce = {once}\nkind = \"exception\"\n");
    let busy = (asked..asked + 12).map(busy).collect::<String>();
    let saved = antrieb("-a 1 dataset save {dir}/a.toml").on(&format!("{bench}{busy}")).exits(9);
    assert!(saved.err.contains("missing"), "{}", saved.err);
    assert!(saved.text_of("a.toml.part").contains("unanswered = \"480"), "{}", saved.text_of("a.toml.part"));
}

/// `check`, `load` and `undo` ask at the same widths, also of a file that names none. Over VABus a reply carries its length, and tells so.
#[test]
fn who_checks_and_who_loads_ask_at_the_same_widths() {
    for protocol in ["rtu", "ascii", "vabus"] {
        let bench = |values: &str| {
            let odd = "other_width = [372, 480]";
            format!("[[drive]]\nmodel = \"acu\"\nprotocol = \"{protocol}\"\n{odd}\nset = {{ {values} }}\n")
        };
        let before = bench("\"372@2\" = 1450, \"480\" = 7.25");
        let line = format!("--protocol {protocol} -a 1 --yes dataset");
        let text = "antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n\"372@2\" = 1400\n\"480\" = -8\n";
        antrieb(&format!("{line} check {{dir}}/f.toml")).on(&before).file("f.toml", text).exits(1);
        let loaded = antrieb(&format!("{line} load {{dir}}/f.toml")).on(&before).file("f.toml", text).exits(0);
        let undo = loaded.text_of("f.undo.toml");
        assert!(undo.contains("480 = \"word\"") && undo.contains("372 = \"long\""), "{undo}");
        let after = bench("\"372@2\" = 1400, \"480\" = -8");
        let undone = loaded.then(&format!("{line} undo {{dir}}/f.undo.toml")).on(&after).exits(0);
        assert!(undone.out.contains("7.25") && undone.out.contains("1450"), "{}", undone.out);
    }
}

#[test]
fn over_vabus_a_width_that_a_catalogue_is_wrong_about_costs_no_value() {
    let bench = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\nother_width = [372, 480]\n\
                 set = { \"372@2\" = 1450, \"480\" = -7.25 }\n";
    let saved = antrieb("--protocol vabus -a 1 dataset save {dir}/a.toml").on(bench).exits(0);
    let text = saved.text_of("a.toml");
    assert!(text.contains("\"372@2\" = \"1450 1/min\"") && text.contains("\"480\" = \"-7.25 Hz\""), "{text}");
    assert!(text.contains("480 = \"word\""), "{text}");
    saved.then("--protocol vabus -a 1 dataset check {dir}/a.toml").on(bench).exits(0);
    // A single value is believed in the form of its row alone.
    antrieb("--protocol vabus -a 1 read 480").on(bench).exits(5);
    // What is told in the other form and not again is no value.
    let sure = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\n";
    let sent = antrieb("-v --protocol vabus -a 1 dataset check {dir}/a.toml").on(sure).file("a.toml", &text).run();
    assert!(sent.exit != 0, "{}", sent.out);
}

/// Half of a file that was copied to a stick.
#[test]
fn a_file_that_is_not_what_was_saved_is_told_before_it_is_loaded() {
    let bench = "[[drive]]\nmodel = \"act\"\naddress = 1\n";
    let saved = antrieb("-a 1 dataset save {dir}/pump.toml").on(bench).exits(0);
    let whole = saved.then("-a 1 dataset load {dir}/pump.toml --yes").on(bench).exits(0);
    assert!(!whole.err.contains("signature"), "{}", whole.err);
    let text = whole.text_of("pump.toml");
    let half = text.lines().take(text.lines().count() / 2).map(|line| format!("{line}\n")).collect::<String>();
    std::fs::write(whole.directory().join("half.toml"), half).unwrap();
    let half = whole.then("-a 1 dataset load {dir}/half.toml --yes").on(bench).json().exits(0);
    assert!(half.warnings().contains(&"file.edited"), "{:?}", half.warnings());
}

#[test]
fn a_dash_is_no_file() {
    let refused = antrieb("-p sim -a 1 dataset save -").exits(2);
    assert!(refused.err.contains("expected the name of a file") && refused.err.contains("--json"), "{}", refused.err);
}
