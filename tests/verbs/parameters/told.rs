//! What `load`, `check`, `diff`, `plan` and `apply` tell of files that are not as they were meant, and who hears it.

use super::plant::{ONE, TWO, plant};
use crate::run::{Run, antrieb};
use antrieb::transport::witness;

const FRESH: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n";

fn file(values: &str) -> String {
    format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}\n")
}

fn on_file(line: &str, text: &str) -> Run {
    antrieb(line).on(FRESH).file("f.toml", text)
}

/// Of these verbs 1 says that something differs.
#[test]
fn where_nothing_is_meant_that_is_no_difference() {
    let code = |line: &str| on_file(line, &file("")).json().exits(7).error()["code"].as_str().unwrap().to_owned();
    assert_eq!(code("-a 1 dataset check {dir}/f.toml"), "data.no_values");
    assert_eq!(code("-a 1 dataset diff 1 2 @bus"), "data.no_switchable");
    let planned = plant("-a a1 plan --only bus", [TWO, TWO, ONE]).json().exits(7);
    assert_eq!(planned.error()["code"], "data.no_values");
}

#[test]
fn an_undo_file_that_is_there_is_in_nobodys_way_where_nothing_is_to_be_written() {
    let load = "-a 1 dataset load {dir}/f.toml --undo-file {dir}/u.toml --yes";
    let same = on_file(load, &file("372 = 1390")).file("u.toml", "mine").exits(0);
    assert_eq!(same.text_of("u.toml"), "mine");
    let taken = on_file(load, &file("372 = 1440")).file("u.toml", "mine").exits(7);
    assert!(taken.err.contains("exists already") && taken.err.contains("nothing was written"), "{}", taken.err);
    assert_eq!(taken.text_of("u.toml"), "mine");
    let asked = on_file("-a 1 dataset load {dir}/f.toml --undo-file {dir}/u.toml", &file("372 = 1440"));
    let asked = asked.file("u.toml", "mine").answered("y").exits(7);
    assert!(!asked.err.contains("[y/N]"), "{}", asked.err);
    // Of several drives each has its own.
    let two = format!("{FRESH}[[drive]]\nmodel = \"act\"\naddress = 2\n");
    let line = "-a 1,2 dataset load {dir}/f.toml --undo-file {dir}/u-{address}.toml --yes";
    antrieb(line).on(&two).file("f.toml", &file("372 = 1390")).file("u-2.toml", "mine").exits(0);
}

#[test]
fn two_data_sets_are_shown_as_lines() {
    let bench = format!("{FRESH}set = {{ \"480@2\" = 6, \"480@2ram\" = 7 }}\n");
    let told = |line: &str, code: u8| {
        let shown = antrieb(&format!("-a 1 dataset diff {line} --unified")).on(&bench).exits(code).out;
        shown.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    for (pair, sides, values) in [
        ("1 2", ["data set 1", "data set 2"], ["5.00 Hz", "6.00 Hz"]),
        ("2 2ram 480-483", ["data set 2", "data set 2ram"], ["6.00 Hz", "7.00 Hz"]),
    ] {
        let lines = [("-", values[0]), ("+", values[1])]
            .map(|(mark, value)| format!("{mark}\"480\" = \"{value}\"  # Fixed Frequency 1"));
        let [a, b] = sides.map(|side| format!("drive 1, {side}"));
        let expected =
            [format!("--- {a}"), format!("+++ {b}"), "@@ @setpoints @@".into(), lines[0].clone(), lines[1].clone()];
        assert_eq!(told(pair, 1), expected, "{pair}");
    }
    told("3 4", 0);
    told("1 2 --dry-run", 0);
}

#[test]
fn what_is_refused_of_a_file_is_named_with_its_line_and_column() {
    let load =
        |text: &str, more: &str| on_file(&format!("-a 1 dataset load {{dir}}/f.toml --yes {more}"), text).exits(7).err;
    let other = file("480 = 8").replace("act", "acu");
    assert!(load(&file("480 = 8").replace("act", "acx"), "").contains("f.toml:3:10: no catalogue knows"));
    for line in ["\"412\" = 999", "412 = \"raw 999\""] {
        let range = load(&file(&format!("480 = 8\n{line}")), "");
        assert!(range.contains("f.toml:6:1: P.412"), "{range}");
        let rehearsed = load(&file(&format!("480 = 8\n{line}")), "--dry-run");
        assert!(rehearsed.contains("f.toml:6:1: P.412"), "{rehearsed}");
    }
    let two = on_file("-a 1 dataset load {dir}/f.toml {dir}/g.toml", &file("480 = 8")).file("g.toml", &other).exits(7);
    assert!(two.err.contains("g.toml:3:10: the file is for drives of the family acu"), "{}", two.err);
    let sets = load(&file("\"372@1-3\" = 1400"), "");
    assert!(sets.contains("f.toml:5:1:") && sets.contains("expected 0-4, and a line for each"), "{sets}");
    assert!(!sets.contains("5-9"), "{sets}");
}

/// Also what the drive alone knows; and four data sets in one line are one thing.
#[test]
fn what_is_in_the_way_is_counted_and_named_by_the_lines_of_the_files() {
    let load = |more: &str, code: u8| {
        let run = antrieb(&format!("-a 1 dataset load {{dir}}/f.toml {{dir}}/g.toml --yes {more}")).on(FRESH);
        run.file("f.toml", &file("480 = 8")).file("g.toml", &file("481 = 9\n777 = 8")).exits(code).err
    };
    for (lang, hint) in [("en", "--except 777 leaves it out"), ("de", "--except 777 lässt ihn weg")] {
        let unknown = load(&format!("--lang {lang}"), 6);
        assert!(unknown.contains("g.toml:6:1: P.777") && unknown.contains(hint), "{unknown}");
    }
    load("--except 777", 0);
    let cuts = on_file("-a 1 dataset load {dir}/f.toml --only 1376 --yes", &file("480 = 8\n1376 = 7")).exits(8).err;
    assert!(cuts.contains("f.toml:6:1: P.1376"), "{cuts}");
    for (values, more) in [("480 = 8\n412 = 99", None), ("\"412@1\" = 99\n\"412@2\" = 99", Some("; 1 more in the way"))]
    {
        let range = on_file("-a 1 dataset load {dir}/f.toml --yes", &file(values)).exits(7).err;
        assert_eq!(range.contains("in the way"), more.is_some_and(|more| range.contains(more)), "{range}");
    }
}

/// Also where the four stand differently, so that each has a row.
#[test]
fn why_a_line_of_a_file_cannot_go_is_told_once() {
    let bench = format!("{FRESH}set = {{ \"412@2\" = 1, \"412@3\" = 2 }}\n");
    let project = "[drives.a]\nport = \"sim:{dir}/a.bench\"\naddress = 1\nfiles = [\"f.toml\"]\n";
    for verb in ["plan", "apply --yes"] {
        let run = antrieb(verb).columns(80).file("a.bench", &bench).file("f.toml", &file("412 = 999"));
        let project = project.replace("{dir}", &run.directory().display().to_string());
        let out = run.file("antrieb.toml", &project).run().out;
        let told = out.split("error").next().unwrap().matches("f.toml:5:1").count();
        assert_eq!(told, 1, "{verb}: {out}");
    }
}

/// Slips of the hand, each with what helps.
#[test]
fn what_is_wrong_with_a_line_comes_with_what_would_be_right() {
    for (values, place, hint) in [
        ("\"480\" = 12,5", "f.toml:5:", "stands in quotes: \"480\" = \"12,5\""),
        ("480 = 12.50 Hz", "f.toml:5:", "stands in quotes: 480 = \"12.50 Hz\""),
        ("480@2 = 8", "f.toml:5:", "stands in quotes: \"480@2\" = 8\n"),
        ("Rated Speed = 1450 rpm", "f.toml:5:", "stands in quotes: \"Rated Speed\" = \"1450 rpm\""),
        ("480 = “8”", "f.toml:5:", "quotes of a word processor are none here: 480 = \"8\""),
        ("480 = 8\r372 = 1400", "f.toml:5:", "save it with line feeds"),
        ("372 = 1400\n480 = 5\n480 = 6", "f.toml:7:1:", "line 6 has a value for it"),
        ("480 =", "f.toml:5:", "write the value behind `=`, or take the line out"),
        ("480 = \"\"", "f.toml:5:", "write the value behind `=`, or take the line out"),
    ] {
        for lang in ["en", "de"] {
            let line = format!("--lang {lang} -a 1 dataset load {{dir}}/f.toml --yes");
            let told = on_file(&line, &file(values)).exits(7).err;
            assert!(told.contains(place) && (lang == "de" || told.contains(hint)), "{values}: {told}");
            assert!(!told.contains("dataset save"), "{told}");
        }
    }
    on_file("-a 1 dataset load {dir}/f.toml --yes", &file("480 = \"12,5\"")).exits(0);
    // What is right TOML and none of a file is no matter of quotes.
    let whole = file("480 = 5");
    for (text, told) in [
        (whole.replace("antrieb = 1\n", "antrieb = 1\nfoo = 1\n"), "stand below `[values]`"),
        (whole.replace("[drive]\nfamily = \"act\"\n", ""), "below `[drive]` its `family"),
        (whole.replace("family = \"act\"\n", ""), "below `[drive]` its `family"),
        (whole.replace("\"act\"", "1"), "writes a file as it has to be"),
    ] {
        for lang in ["en", "de"] {
            let ended = on_file(&format!("--lang {lang} -a 1 dataset load {{dir}}/f.toml --yes"), &text).exits(7);
            assert!(
                !ended.err.contains("quotes:") && (lang == "de" || ended.err.contains(told)),
                "{text}: {}",
                ended.err
            );
        }
    }
}

#[test]
fn a_file_in_other_letters_is_refused_with_its_place() {
    for (line, name) in [
        ("-p sim -a 1 dataset check {dir}/f.toml", "f.toml"),
        ("-p sim:{dir}/f.toml -a 1 read 480", "f.toml"),
        ("-p sim --catalogue {dir}/f.toml -a 1 read 480", "f.toml"),
        ("-p sim -a 1 read 480", "antrieb.toml"),
    ] {
        for lang in ["en", "de"] {
            let run = antrieb(&format!("--lang {lang} {line}"));
            std::fs::write(run.directory().join(name), b"# Grundwerte\n# f\xC3\xBCr M\xFCller\n").unwrap();
            let told = run.exits(7).err;
            assert!(told.contains(&format!("{name}:2:8: ")) && told.contains("UTF-8"), "{told}");
        }
    }
}

/// From wherever the program is started. Names of devices are names.
#[test]
fn ports_of_a_project_file_begin_where_it_stands() {
    let on = |line: &str, port: &str| {
        let project = format!("[ports.left]\npath = \"{port}\"\n[drives.a]\nport = \"left\"\naddress = 1\n");
        let site = antrieb(&format!("--config {{dir}}/site/antrieb.toml {line}")).file("site/antrieb.toml", &project);
        site.file("site/left.bench", FRESH).file("site/p0", "")
    };
    on("-a a read 480", "sim:left.bench").exits(0);
    for (port, begins_there) in [("p0", true), ("./nowhere", true), ("ttyUSB77", false), ("/dev/ttyUSB77", false)] {
        let told = on("-a a read 480", port).exits(3).err;
        assert_eq!(told.contains("/site/"), begins_there, "{port}: {told}");
    }
}

#[test]
fn a_file_whose_name_promises_another_form_is_said_to_be_toml() {
    for name in ["f.csv", "f.json"] {
        let line = format!("-p sim -a 1 dataset save {{dir}}/{name} --changed");
        let saved = antrieb(&line).exits(0);
        assert!(saved.err.contains("is a parameter file (TOML) all the same"), "{}", saved.err);
        antrieb(&format!("--lang de {line}")).exits(0);
        assert_eq!(antrieb(&line).json().exits(0).warnings(), ["file.is_toml"]);
    }
    assert!(!antrieb("-p sim -a 1 dataset save {dir}/f.toml --changed").exits(0).err.contains("TOML"));
}

#[test]
fn a_row_without_a_telegram_says_why() {
    for lang in ["en", "de"] {
        let line = format!("--lang {lang} -a 1 dataset load {{dir}}/f.toml --dry-run");
        let shown = on_file(&line, &file("603 = 100")).exits(0).out;
        assert!(shown.contains(if lang == "en" { "no source tells its type" } else { "nennt seinen Typ" }), "{shown}");
    }
}

/// Two relative names, of which one has no folder; what they lead to need not be a port.
#[test]
fn two_relative_names_of_one_port_are_one_port() {
    let project = "[drives.a]\nport = \"Cargo.toml\"\naddress = 1\n[drives.b]\nport = \"./Cargo.toml\"\naddress = 1\n";
    let refused = antrieb("plan").file("antrieb.toml", project).exits(7).err;
    assert!(refused.contains("drives a and b have the same address 1"), "{refused}");
}

/// The adapter is pulled at every telegram of the beginning.
#[test]
fn a_save_says_that_something_is_kept_only_where_it_is() {
    let mut lost = 0;
    for after in 0..9 {
        witness::pull_after(Some(after));
        let ended = antrieb("-a 1 dataset save {dir}/s.toml").on("[[drive]]\nmodel = \"acu\"\n").run();
        witness::pull_after(None);
        assert_ne!(ended.exit, 0, "{after}");
        let is_kept = ended.directory().join("s.toml.part").exists();
        assert_eq!(ended.err.contains("what was read stands in"), is_kept, "{after}: {}", ended.err);
        assert_eq!(ended.err.contains("--resume"), is_kept, "{after}: {}", ended.err);
        lost += usize::from(!is_kept);
    }
    assert!((1..9).contains(&lost), "{lost}");
}

#[test]
fn a_word_that_one_family_of_a_plant_knows_is_no_mistake_of_the_others() {
    let on = |line: &str| plant(line, [TWO, TWO, ONE]);
    let states = |line: &str| super::plant::states(&on(line).json().exits(1));
    assert_eq!(states("plan --only voltage,372"), "a1 planned, a2 same, b1 planned, b2 same, c3 same");
    assert_eq!(states("plan --except setpoints"), states("plan --except setpoints,voltage"));
    on("check --only 372").exits(1);
    on("check --except voltage").exits(1);
    for verb in ["plan", "check", "apply --yes"] {
        let refused = on(&format!("{verb} --only pumps")).exits(2).err;
        assert!(refused.contains("'pumps' names no group"), "{refused}");
    }
}

#[test]
fn of_drives_that_nobody_could_look_at_nobody_says_how_they_are() {
    let config = "[drives.a]\nport = \"/dev/none-a\"\naddress = 1\nfiles = [\"f.toml\"]\n\
                  [drives.b]\nport = \"/dev/none-b\"\naddress = 1\nfiles = [\"f.toml\"]\n";
    for (lang, told) in
        [("en", "2 of 2 drives could not be looked at"), ("de", "2 von 2 Antrieben ließen sich nicht ansehen")]
    {
        let run = antrieb(&format!("--lang {lang} apply --yes")).file("antrieb.toml", config);
        let ended = run.file("f.toml", &file("372 = 1440")).exits(3).err;
        assert!(ended.contains(told), "{ended}");
    }
}

/// A slave of PROFIBUS beside a drive on a line is reached, by what speaks that; files are not.
#[test]
fn why_no_file_goes_into_a_slave_of_profibus_is_told_as_it_is() {
    let config = "[drives.inverter]\nport = \"sim\"\nprotocol = \"dp\"\naddress = 3\nfiles = [\"i.toml\"]\n\
                  [drives.pump]\nport = \"{dir}/b.toml\"\naddress = 1\nfiles = [\"p.toml\"]\n";
    let files = [("i.toml", "F002 = 5", "sj200"), ("p.toml", "480 = 5", "act")];
    for (verb, lang) in [("plan", "en"), ("apply --yes", "en"), ("check", "en"), ("plan", "de")] {
        let mut run = antrieb(&format!("--lang {lang} -a all {verb}"));
        for (name, values, family) in files {
            run = run.file(name, &file(values).replace("act", family));
        }
        let bench = run.directory().join("b.toml").display().to_string();
        let run = run.file("b.toml", "[[drive]]\nmodel = \"act\"\naddress = 1\n");
        let ended = run.file("antrieb.toml", &config.replace("{dir}/b.toml", &format!("sim:{bench}"))).exits(9);
        let told =
            if lang == "en" { "of a plant do not go over PROFIBUS-DP" } else { "gehen noch nicht über PROFIBUS-DP" };
        assert!(ended.err.contains(told) && !ended.err.contains("alone"), "{verb}: {}", ended.err);
    }
}

/// A backup of a drive with option modules, for one without.
#[test]
fn what_all_is_in_the_way_can_be_left_out_as_it_is_told() {
    let modules = "[[drive]]\nmodel = \"acu\"\nmodules = [\"EM-RES-03\"]\n";
    let bare = "[[drive]]\nmodel = \"acu\"\n";
    let saved = antrieb("-a 1 dataset save {dir}/s.toml").on(modules).exits(0);
    let refused = saved.then("-a 1 dataset load {dir}/s.toml --yes").on(bare).exits(6);
    let all = refused.err.split("--except ").nth(1).unwrap().split(' ').next().unwrap().to_owned();
    assert!(all.contains(','), "{}", refused.err);
    refused.then(&format!("-a 1 dataset load {{dir}}/s.toml --yes --except {all}")).on(bare).exits(0);
}
