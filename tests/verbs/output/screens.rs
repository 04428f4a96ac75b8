//! What every verb shows on a terminal of 80 columns, in both languages: `docs/screens`, one file a verb.
//! `UPDATE=1 cargo test --test verbs screens` writes them anew.

use crate::run::{Run, antrieb, verbs};
use antrieb::render::wrap;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use unicode_width::UnicodeWidthStr;

/// A pump that has tripped and warns, a fan that is ready, and a servo.
const PLANT: &str = "\
[[drive]]
model = \"act\"
address = 1
set = { \"372@2\" = 1450, \"480@3\" = 12.5 }
[[drive.event]]
at = \"0s\"
fault = \"F0401\"
warning = 0x0041
[[drive]]
model = \"acu\"
address = 2
modules = [\"EM-RES-03\"]
set = { \"412\" = 1 }
[[drive]]
model = \"lxm05\"
address = 3
";

const HEARD: &str = "# antrieb trace 1, 19200 8E1, rtu
1000 < 01 03 21 74 00 01 CE 2C 01 03 02 05 6E 3A F8
60000 < 01 83 02 C0 F1
";

/// A list as a spreadsheet in German exports it: a byte order mark, semicolons, decimal commas, CR LF.
const EXCEL: &str = "\u{feff}Register;Bezeichnung;Einheit;Faktor;Typ\r\n0;\"Spannung; L1\";V;0,1;int32\r\n51;Frequenz;Hz;0,1;uint16\r\n49;cos phi;;0,001;int16\r\n";

/// What is typed, verb by verb; the port is that of the plant.
const TYPED: &[(&str, &[&str])] = &[
    ("scan", &["scan -a 1-9", "scan -a 1-3 --baud auto"]),
    ("identify", &["identify -a 2", "identify -a 3"]),
    (
        "read",
        &[
            "read -a 2 @actual",
            "read -a 1 372@all 480-482",
            "read -a 3 -p sim --protocol dp 968 701 F002 --yes",
            "read -a 5 -p sim --protocol sdo 411 480 900",
        ],
    ),
    ("write", &["write -a 2 480=12,5Hz --yes", "write -a 2 480=12,5Hz --dry-run"]),
    (
        "dataset",
        &[
            "dataset show -a 1 372 480 481",
            "dataset active -a 1",
            "dataset save {dir}/saved.toml -a 1",
            "dataset check {dir}/slow.toml -a 1",
            "dataset diff -a 1 1 2",
            "dataset load {dir}/slow.toml -a 1 --dry-run",
            "dataset load {dir}/slow.toml -a 1 --yes",
        ],
    ),
    (
        "diag",
        &[
            "diag -a 1-3",
            "diag -a 1",
            "diag -a 3",
            "diag -a 3 -p sim --protocol dp --yes",
            "diag line -a 1-3 --count 20",
        ],
    ),
    (
        "statemachine",
        &[
            "statemachine -a 2",
            "statemachine enable -a 2 --yes",
            "statemachine disable -a 2",
            "statemachine -a 3 -p sim --protocol dp --yes",
        ],
    ),
    (
        "sollwert",
        &[
            "sollwert -a 2",
            "sollwert 25Hz -a 2 --source line --enable --hold --duration 1s --yes",
            "sollwert 0 -a 2",
            "sollwert 20Hz -a 3 -p sim --protocol dp --jog 2s --take-control --yes",
        ],
    ),
    ("line", &["line show -a 1"]),
    (
        "monitor",
        &[
            "monitor -a 2 --line --count 3 --interval 300ms",
            "monitor -a 2 --line --count 2 --interval 300ms --record {dir}/kept.csv",
        ],
    ),
    (
        "params",
        &[
            "params frequency --drive act",
            "params 412",
            "params nenn --drive act",
            "params import --own meter {dir}/excel.csv --low-half-first --output {dir}/meter.toml",
            "params export 375 --drive act --output {dir}/one.csv",
        ],
    ),
    (
        "decode",
        &[
            "decode 01 03 21 74 00 01 CE 2C",
            "decode telegram 01 03 01 E0 00 01 84 00 01 03 02 04 E2 3A CD",
            "decode can 605#4074010200000000 585#427401026E050000",
            "decode status 0x0237 --drive acu",
            "decode fault F0401",
            "decode register 10",
        ],
    ),
    (
        "profibus",
        &[
            "profibus live -p sim",
            "profibus live -p sim -a 3",
            "profibus module L200 set deceleration min 0x0001 max 0x7530",
            "profibus module C7 FF FF --drive l200",
        ],
    ),
    ("sniff", &["sniff -p tape:{dir}/heard"]),
    ("protocol", &["protocol show -a 1"]),
    ("plot", &["plot {dir}/record.csv --measure"]),
    ("report", &["report {dir}/plant.html {dir}/plant.md -a 1-4 --record {dir}/record.csv"]),
    (
        "procedure",
        &["procedure list", "procedure first-contact -a 1 --dry-run", "procedure first-contact watchdog=2s -a 1 --yes"],
    ),
    (
        "systembus",
        &[
            "systembus plan {dir}/bus.toml",
            "systembus load",
            "systembus show -a 5 -p sim --protocol sdo",
            "systembus monitor -p sim --protocol sdo --duration 2s",
            "systembus load 500 1 2 8",
        ],
    ),
    ("init", &["init {dir}/new.toml -a 1-9"]),
    ("plan", &["plan --config {dir}/plant.toml"]),
    ("apply", &["apply --config {dir}/plant.toml --yes"]),
    ("check", &["check --config {dir}/plant.toml"]),
    ("simulate", &["simulate -h", "simulate {dir}/lost.toml"]),
    ("schema", &["schema -h", "schema nothing"]),
    ("completions", &["completions -h", "completions ksh"]),
    ("man", &["man -h", "man nothing"]),
];

/// Verbs that need no port.
const ALONE: &[&str] = &["simulate", "schema", "completions", "man"];

/// Files that are there besides.
const FILES: &[(&str, &str)] = &[
    ("heard", HEARD),
    ("record.csv", include_str!("../../../docs/examples/record.csv")),
    ("bus.toml", include_str!("../../../docs/examples/system-bus-setpoint.toml")),
    (
        "plant.toml",
        "[drives.fan-2]\naddress = 2\nfiles = [\"fan.toml\"]\n[drives.pump-1]\naddress = 1\nfiles = [\"pump.toml\"]\n",
    ),
    ("fan.toml", "antrieb = 1\ndrive.family = \"acu\"\n[values]\n\"480@1\" = \"20 Hz\"\n\"412\" = 1\n"),
    ("slow.toml", "antrieb = 1\ndrive.family = \"act\"\n[values]\n\"372@2\" = 1400\n\"480@1\" = \"12.5 Hz\"\n"),
    ("excel.csv", EXCEL),
    ("pump.toml", "antrieb = 1\ndrive.family = \"act\"\n[values]\n\"372@2\" = 1450\n"),
];

/// One screen after the other, as they were typed.
fn screens(lines: &[&str], lang: &str) -> String {
    let mut text = String::new();
    for line in lines {
        let is_alone = ALONE.iter().any(|verb| line.starts_with(verb));
        let run = antrieb(&format!("{line} --lang {lang}")).columns(80);
        let run = FILES.iter().fold(run, |run, (name, text)| run.file(name, text));
        let run = if is_alone || line.contains(" -p ") { run } else { run.on(PLANT) };
        let output = run.run();
        let place = output.directory().display().to_string();
        // A line that is refreshed shows its last state.
        let out: Vec<_> = output.out.lines().map(|row| row.rsplit('\r').next().unwrap_or("").trim_end()).collect();
        // As a terminal has it: broken where the program breaks it there.
        let err: String = output.err.replace(&place, ".").lines().map(|row| wrap(row, Some(80)) + "\n").collect();
        let shown = format!("{}\n{err}", out.join("\n").replace(&place, "."));
        // What was heard is shown whole, however long a telegram is.
        for row in out.iter().filter(|_| !line.starts_with("sniff")) {
            assert!(row.width() <= 80, "{line}: {} columns\n{row}", row.width());
        }
        let _ = write!(text, "$ antrieb {}\n{shown}(exit {})\n\n", line.replace("{dir}", "."), output.exit);
    }
    text
}

#[test]
#[expect(clippy::disallowed_methods, reason = "UPDATE=1 is how a test is told to write")]
fn the_screens_in_the_documentation_are_those_of_the_program() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/screens");
    let mut stale = Vec::new();
    for (verb, lines) in TYPED {
        for lang in ["en", "de"] {
            let (file, text) = (folder.join(format!("{verb}.{lang}.txt")), screens(lines, lang));
            if std::env::var_os("UPDATE").is_some() {
                std::fs::create_dir_all(&folder).unwrap();
                std::fs::write(&file, &text).unwrap();
            } else if std::fs::read_to_string(&file).unwrap_or_default() != text {
                stale.push(file.display().to_string());
            }
        }
    }
    assert!(stale.is_empty(), "UPDATE=1 writes them anew, then read the difference: {stale:#?}");
}

#[test]
fn the_screen_of_the_readme_is_one_of_them() {
    let (_, behind) = include_str!("../../../README.md").split_once("```text\n").unwrap();
    let (screen, _) = behind.split_once("```").unwrap();
    assert!(include_str!("../../../docs/screens/run.en.txt").contains(screen), "{screen}");
}

#[test]
fn every_verb_has_its_screens() {
    let missing: Vec<_> = verbs().filter(|verb| TYPED.iter().all(|row| row.0 != *verb)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// A digit that is cut off is another value.
#[test]
fn no_number_is_torn_on_a_narrow_terminal() {
    let odd = "antrieb = 1\n[drive]\nfamily=\"act\"\n[values]\n\"407\"=5\n\"480\"=99999\n\"486\"=5\n\"375\"=55\n";
    let own = ["write -a 1 480=5 372=1390", "write -a 1,2 480=7 372=1400 --yes", "dataset load {dir}/odd.toml -a 1"];
    let lines = TYPED.iter().flat_map(|(_, lines)| *lines).chain(&own);
    let lines =
        lines.filter(|line| !["monitor", "sniff", "sollwert", "report"].iter().any(|verb| line.starts_with(verb)));
    let digits = |word: &&str| word.chars().any(|letter| letter.is_ascii_digit());
    for line in lines {
        let out = |columns: Option<u16>| {
            let run =
                FILES.iter().fold(antrieb(&format!("{line} --lang de")), |run, (name, text)| run.file(name, text));
            let run = run.file("odd.toml", odd);
            let run = columns.into_iter().fold(run, Run::columns);
            let output = if line.contains(" -p ") { run } else { run.on(PLANT) }.run();
            output.out.replace(&output.directory().display().to_string(), ".")
        };
        let wide = out(None);
        let known: BTreeSet<&str> = wide.split_whitespace().collect();
        let narrow = out(Some(80));
        let torn: Vec<_> = narrow.split_whitespace().filter(digits).filter(|word| !is_known(word, &known)).collect();
        assert!(torn.is_empty(), "{line}: {torn:?}\n{narrow}");
    }
}

/// Whether a word stands in the wide table too, or what is folded and labelled in the narrow one.
fn is_known(word: &str, known: &BTreeSet<&str>) -> bool {
    let bare = word.trim_matches(|letter: char| "():;,`".contains(letter));
    let is_folded = |word: &str| word.len() == 3 && word.as_bytes().get(1) == Some(&b'-');
    let is_broken = |one: &str| one.contains('-') && one.contains(char::is_alphabetic) && one.contains(bare);
    known.iter().any(|one| one.trim_matches(|letter: char| "():;,`".contains(letter)) == bare || is_broken(one))
        || is_folded(bare)
        || bare.contains('@')
}

#[test]
fn what_is_typed_again_is_broken_nowhere() {
    for (line, whole) in [
        ("params frequency --drive act", "frequency-motorpoti-up"),
        ("params fixed --drive act", "fixed-frequency-changeover-1"),
        ("procedure list", "first-contact"),
        ("procedure list", "resolver-offset"),
    ] {
        for lang in ["en", "de"] {
            let wide = antrieb(&format!("{line} --lang {lang}")).on(PLANT).run().out;
            let narrow = antrieb(&format!("{line} --lang {lang}")).on(PLANT).columns(80).run().out;
            assert!(!wide.contains(whole) || narrow.contains(whole), "{line} --lang {lang}: {whole}\n{narrow}");
            assert!(narrow.lines().all(|row| row.width() <= 80), "{narrow}");
            let words: BTreeSet<&str> = wide.split_whitespace().collect();
            let torn: Vec<_> = narrow.split_whitespace().filter(|word| !words.contains(word)).collect();
            assert!(torn.is_empty(), "{line} --lang {lang}: {torn:?}\n{narrow}");
        }
    }
}

#[test]
fn the_fault_comes_first_however_many_warnings_there_are() {
    let worst = "[[drive]]\nmodel = \"acu\"\naddress = 2\nset = { \"412\" = 44 }\n[[drive.event]]\nat = \"0s\"\nfault = \"F0500\"\n\
                 warning = 0x07FF\n[[drive]]\nmodel = \"lxm05\"\naddress = 3\n";
    for lang in ["en", "de"] {
        let shown = |line: &str| antrieb(&format!("{line} --lang {lang}")).on(worst).columns(80).run().out;
        let page = shown("diag -a 2");
        assert!(page.lines().count() <= 23, "{page}");
        let at = |word: &str| page.find(word).unwrap_or_else(|| panic!("{word}: {page}"));
        let [fault, state, warnings] =
            if lang == "en" { ["fault", "state", "warnings"] } else { ["Störung", "Zustand", "Warnungen"] };
        assert!(at(fault) < at(&format!("\n{state}")) && at(&format!("\n{state}")) < at(warnings), "{page}");
        assert!(shown("diag -a 2 -v").lines().count() > page.lines().count());
        for line in ["diag -a 2,3", "scan -a 2-3"] {
            let page = shown(line);
            assert!(page.contains(" +10"), "{line}\n{page}");
            let rows = page.lines().filter(|row| row.trim_start().starts_with(['2', '3']) && !row.contains("P.412"));
            assert!(rows.count() >= 2 && page.lines().count() < 12, "{line}\n{page}");
        }
    }
}

#[test]
fn what_ails_a_drive_fits_on_one_screen() {
    for line in ["diag -a 1", "diag -a 1-3", "statemachine -a 2", "scan -a 1-9", "identify -a 2"] {
        for lang in ["en", "de"] {
            let output = antrieb(&format!("{line} --lang {lang}")).on(PLANT).columns(80).run();
            let rows = output.out.lines().count();
            assert!(rows <= 23, "{line} --lang {lang}: {rows} lines\n{}", output.out);
        }
    }
}
