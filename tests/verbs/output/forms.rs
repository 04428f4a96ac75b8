//! Forms of output: what goes where, what a pipe, a terminal and a script get.

use crate::run::{SCHEMAS, antrieb, verbs};
use unicode_width::UnicodeWidthStr;

/// A line of every verb that brings plenty.
const PLENTY: [&str; 15] = [
    "-p sim scan",
    "-p sim -a 1,2 identify",
    "-p sim -a 1,2 read @modbus",
    "-p sim -a 1 read 1600 372",
    "-p sim -a 1 --yes write 480@1=6 376@2=0 481@1=7",
    "-p sim -a 2 dataset show",
    "-p sim -a 2 --yes dataset copy 1 2",
    "-p sim -a 1,2 diag --link-test 5",
    "-p sim -a 1,2 statemachine",
    "-p sim -a 1,2 sollwert",
    "params",
    "params 412",
    "decode telegram 01 65 21 77 00 00 03 E8 46 C5",
    "decode status 0xFFFF",
    "decode fault F2105",
];

#[test]
fn a_closed_pipe_is_a_success() {
    for line in ["-p sim -a 1,2 diag", "-p sim -a 1 read @modbus 1600", "params"] {
        for format in ["table", "json", "ndjson", "csv"] {
            let run = antrieb(&format!("{line} --format {format}")).run();
            // The reader is gone at once, in the middle of the first line, and later than any buffer.
            for bytes in [0, 40, 9_000] {
                if run.out.len() <= bytes {
                    continue;
                }
                let cut = antrieb(&format!("{line} --format {format}")).into_pipe_of(bytes).exits(run.exit);
                assert!(!cut.err.contains("cannot write"), "{line} {format} {bytes}: {}", cut.err);
                assert!(run.out.starts_with(&cut.out), "{line} {format} {bytes}");
            }
        }
    }
    for line in ["--help", "schema", "schema read", "completions bash", "man", "man read", "--version"] {
        antrieb(line).into_pipe_of(5).exits(0);
    }
}

/// The pipe concerns what is printed, not what came of it.
#[test]
fn a_closed_pipe_makes_no_error_a_success() {
    for line in [
        "-p sim -a 1 read nowhere",
        "-p sim -a 1 --config nowhere.toml read 480",
        "-p sim:nowhere.toml -a 1 read 480",
        "-p sim -a 9 read 480",
        "-p sim -a 1 read 1600",
        "-p sim -a 1 dataset check nowhere.toml",
        "-p sim -a 1 monitor nowhere",
        "-p sim -a 9 monitor --count 2 --unpaced",
        "-p sim -a 1 write nowhere=1",
        "-p sim -a 1 diag --nowhere",
        "decode telegram xy",
        "params nowhere",
        "schema nowhere",
    ] {
        for form in ["", "--json", "--format ndjson"] {
            let whole = antrieb(line).and(form).run();
            assert_ne!(whole.exit, 0, "{line} {form}");
            for bytes in [0, 5] {
                let cut = antrieb(line).and(form).into_pipe_of(bytes).exits(whole.exit);
                assert!(whole.out.len() <= bytes || cut.err.contains("error: "), "{line} {form} {bytes}: {}", cut.err);
            }
        }
    }
}

#[test]
fn stdout_carries_data_only() {
    for line in PLENTY {
        let json = antrieb(&format!("{line} --json")).run();
        serde_json::from_str::<serde_json::Value>(&json.out).unwrap_or_else(|error| panic!("{line}: {error}"));
        let table = antrieb(line).run();
        for text in ["warning:", "error:", "hint:", "note:", "found "] {
            assert!(!table.out.contains(text), "{line}: {text}");
        }
    }
}

#[test]
fn eighty_columns_are_enough() {
    for lang in ["en", "de"] {
        for line in PLENTY {
            let run = antrieb(&format!("--lang {lang} {line}")).columns(80).run();
            let long: Vec<_> = run.out.lines().filter(|shown| shown.width() > 80).collect();
            assert_eq!(long, [""; 0], "{line}");
        }
    }
}

/// What goes out without a word of caution is the prose around a table: notes of a dry run, what went wrong with a drive.
#[test]
fn prose_under_a_table_is_wrapped_between_words() {
    for lang in ["en", "de"] {
        for line in [
            "-p sim -a 1 --drive act sollwert 12Hz --enable --dry-run",
            "-p sim -a 1 --drive act sollwert 0 --dry-run",
            "-p sim init {dir}/antrieb.toml --dry-run",
            "-p sim -a 1-3 statemachine quick-stop",
            "-p sim -a 1,7 statemachine",
            "-p sim -a 1,7 sollwert",
            "-p sim -a 1,7 diag",
            "-p sim -a 1,7 diag line --count 3",
            "-p sim -a 1,7 identify",
        ] {
            let run = antrieb(&format!("--lang {lang} {line}")).columns(80).run();
            let piped = antrieb(&format!("--lang {lang} {line}")).run();
            let long: Vec<_> = run.out.lines().filter(|shown| shown.width() > 80).collect();
            assert_eq!(long, [""; 0], "{line}");
            assert!(
                piped.out.lines().any(|shown| shown.starts_with("- "))
                    == run.out.lines().any(|shown| shown.starts_with("- "))
            );
        }
    }
}

#[test]
fn eighty_columns_tear_no_number_apart() {
    let run = antrieb("-p sim -a 1 read 372@2 481 411 375").columns(80).exits(0);
    for number in ["1390", "10.00", "0x0023", "50.00"] {
        assert!(run.out.split_whitespace().any(|word| word == number), "{number}: {}", run.out);
    }
    let run = antrieb("-p sim -a 1 --yes write 480@1=6 372@2=1450").columns(80).exits(0);
    for word in ["480", "5.00", "6.00", "372", "1390", "1450", "verified"] {
        assert!(run.out.split_whitespace().any(|shown| shown == word), "{word}: {}", run.out);
    }
    let planned = antrieb("-p sim -a 1 --drive act write 480=6 --dry-run").columns(80).exits(0);
    assert!(planned.out.lines().any(|line| line.starts_with("01 65 01 E0 00 00 02 58 ")), "{}", planned.out);
    let run = antrieb("-p sim -a 1 dataset show 372 480").columns(80).exits(0);
    assert_eq!(run.out.split_whitespace().filter(|word| *word == "1390").count(), 4, "{}", run.out);
}

#[test]
fn a_pipe_gets_one_row_a_line() {
    let read = antrieb("-p sim -a 1 read 372@all 1600 411").exits(9);
    assert_eq!(read.rows().len(), 6, "{}", read.out);
    let params = antrieb("params").exits(0);
    let count = antrieb("params").json().data("/params").as_array().unwrap().len();
    assert_eq!(params.rows().len(), count);
    let written = antrieb("-p sim -a 1 --yes write 480@1=6 376@2=0 481@1=7").exits(9);
    assert_eq!(written.rows().len(), 3, "{}", written.out);
    for line in PLENTY {
        let run = antrieb(line).run();
        assert!(!run.out.contains('\t') && !run.out.contains('\u{1b}'), "{line}");
        assert!(!run.out.lines().any(|shown| shown.ends_with(' ')), "{line}");
        assert!(!run.out.contains(['│', '|', '┆']), "no borders that break copying: {line}\n{}", run.out);
    }
}

#[test]
fn a_terminal_changes_the_width_and_nothing_else() {
    let squeeze = |text: &str| text.split_whitespace().collect::<String>();
    let wide = antrieb("-p sim -a 1 read 372@2 481 411").columns(300).exits(0);
    let piped = antrieb("-p sim -a 1 read 372@2 481 411").exits(0);
    assert_eq!(squeeze(&wide.out), squeeze(&piped.out));
}

#[test]
fn the_quiet_are_told_failures_only() {
    assert_eq!(antrieb("-p sim -q scan").exits(0).err, "");
    assert_eq!(antrieb("-p sim -q -a 1 --yes write 480@1=6").exits(0).err, "");
    let run = antrieb("-p sim -q -a 9 read 372").exits(4);
    assert!(run.err.starts_with("error: "), "{}", run.err);
}

#[test]
fn telegrams_are_shown_decoded_with_their_times() {
    let run = antrieb("-p sim -a 1 --drive act -v read 372@2").exits(0);
    let lines: Vec<_> = run.err.lines().collect();
    assert!(lines[0].starts_with("note: settings: port sim"), "{}", lines[0]);
    let lines = &lines[1..];
    assert_eq!(lines.len(), 4);
    assert!(lines[0].trim_start().starts_with("2.006 ms > 01 08 00 0B 00 00 91 C9  "), "{}", lines[0]);
    let lines = &lines[2..];
    assert!(lines[0].contains(" ms > 01 03 21 74 00 01 CE 2C  "), "{}", lines[0]);
    assert!(lines[0].contains("P.372@2"), "{}", lines[0]);
    assert!(lines[1].contains(" ms < 01 03 02 05 6E 3A F8  ") && lines[1].contains("1390"), "{}", lines[1]);
    let german = antrieb("-p sim -a 1 --drive act -v --lang de read 372@2").exits(0);
    assert!(german.err.contains("lesen P.372@2"), "{}", german.err);
}

#[test]
fn schemas_are_printed_for_every_verb_and_refuse_what_is_no_document() {
    for verb in verbs() {
        let validator = &SCHEMAS[verb];
        assert!(!validator.is_valid(&serde_json::json!({})), "{verb}");
        let whole = serde_json::json!({ "schema": 1, "tool": "antrieb", "command": verb, "ok": true,
            "data": { "surprise": 1 }, "warnings": [], "error": null });
        assert!(!validator.is_valid(&whole), "{verb}");
    }
    antrieb("schema nope").exits(2);
}

#[test]
fn a_document_of_one_verb_is_none_of_another() {
    let read: serde_json::Value = antrieb("-p sim -a 1 read 372").json().value;
    assert!(SCHEMAS[""].is_valid(&read) && SCHEMAS["read"].is_valid(&read));
    for verb in ["scan", "write", "diag", "params"] {
        assert!(!SCHEMAS[verb].is_valid(&read), "{verb}");
    }
}

#[test]
fn json_says_the_same_in_every_language() {
    // Numbers, slugs and codes are for scripts; only names and texts are for people.
    let [en, de] =
        ["en", "de"].map(|lang| antrieb(&format!("-p sim -a 1 --lang {lang} read 372 411 1600")).json().value);
    for pointer in
        ["/data/values/0/slug", "/data/values/1/word/bits/0/slug", "/data/values/2/error/code", "/error/code"]
    {
        assert!(en.pointer(pointer).is_some_and(|text| text.is_string()), "{pointer}: {en:#}");
        assert_eq!(en.pointer(pointer), de.pointer(pointer), "{pointer}");
    }
    assert_ne!(en.pointer("/data/values/0/name"), de.pointer("/data/values/0/name"));
}

#[test]
fn completions_and_man_pages_are_printed() {
    for shell in ["bash", "zsh", "fish", "powershell"] {
        assert!(antrieb(&format!("completions {shell}")).exits(0).out.contains("sollwert"), "{shell}");
    }
    assert!(antrieb("man").exits(0).out.starts_with(".ie"));
    assert!(antrieb("man read").exits(0).out.contains("data set"));
    antrieb("man nope").exits(2);
}

#[test]
fn csv_has_the_same_head_line_whatever_is_found() {
    let plant = "[drives.a]\naddress = 1\nfiles = [\"p.toml\"]\n[drives.b]\naddress = 2\nfiles = [\"p.toml\"]\n";
    let head = |line: &str, values: &str, bench: &str| {
        let file = format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}\n");
        let run = antrieb(&format!("--config {{dir}}/antrieb.toml --format csv {line}"));
        let run = run.file("antrieb.toml", plant).file("p.toml", &file).on(bench).run();
        let head = run.out.lines().next().unwrap_or_default().to_owned();
        assert!(head.contains("address"), "{line}: {}{}", run.out, run.err);
        head
    };
    let two = "[[drive]]\nmodel = \"act\"\n[[drive]]\nmodel = \"act\"\naddress = 2\n";
    let one = "[[drive]]\nmodel = \"act\"\n";
    let (same, other) = ("\"480\" = 5.0", "\"480\" = 6.0");
    for line in
        ["plan", "apply", "apply --yes", "check", "-a 1 dataset check {dir}/p.toml", "-a 1 dataset load {dir}/p.toml"]
    {
        let fine = head(line, same, two);
        assert_eq!(head(line, other, two), fine, "{line}");
        if !line.contains("dataset") {
            assert_eq!(head(line, other, one), fine, "{line}");
        }
    }
    assert_eq!(head("scan -a 5", same, two), head("scan -a 1", same, two));
}

/// A cell is a value: what holds several has a column for each of them, and a list its members with semicolons between.
#[test]
fn records_stand_in_columns_of_their_own_in_csv() {
    let cells = |line: &str, bench: &str| {
        let run = antrieb(&format!("--lang de --format csv {line}")).on(bench).exits(0);
        let mut reader = csv::Reader::from_reader(run.out.as_bytes());
        let heads: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
        let row = reader.records().next().unwrap().unwrap();
        let cells: std::collections::BTreeMap<_, _> = heads.into_iter().zip(row.iter().map(str::to_owned)).collect();
        let record = ["asked 20", "choice ramp", "tells ", "took_ms "].into_iter().find(|part| run.out.contains(part));
        assert_eq!(record, None, "{line}: {}", run.out);
        cells
    };
    let ready = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n";
    let line = cells("-a 1 diag line --count 20", ready);
    assert_eq!([&line["test_asked"], &line["test_replies"], &line["test_silent"]], ["20", "20", "0"]);
    let bars: u64 = line["test_histogram_count"].split("; ").map(|bar| bar.parse::<u64>().unwrap()).sum();
    assert_eq!(bars, 20, "{line:?}");
    let run = cells("-a 1 --yes sollwert 10Hz --enable --hold --duration 1s --watchdog 2s", ready);
    assert_eq!([&run["stop_choice"], &run["stop_acknowledged"], &run["stop_standing"]], ["ramp", "true", "true"]);
    assert!(run["changed"].contains("P.413@0ram 0 -> 2"), "{}", run["changed"]);
    let steps =
        ["steps_transition", "steps_control", "steps_state", "steps_took_ms"].map(|name| run[name].split("; ").count());
    assert!(steps.iter().all(|count| *count == steps[0] && *count > 0), "{run:?}");
    let who = cells("-a 1 identify", ready);
    let evidence = ["asked", "answered", "tells"].map(|part| &who[&format!("evidence_{part}")]);
    assert!(evidence.iter().all(|cell| !cell.is_empty()), "{evidence:?}");
}
