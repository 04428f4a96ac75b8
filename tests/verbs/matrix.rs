//! Every verb of the list x {fine, silence, refused, partial, interrupted} x {table en, table de, JSON, NDJSON, CSV}.
//!
//! Both tables and the JSON document are snapshots; NDJSON and CSV are held against the JSON document, and that against the
//! schema of the verb. What is interrupted is cut short after some telegrams, in [`interrupted`].
//! [`every_verb_has_its_rows`] walks the list: a verb without a row fails it.

mod bench;
mod rows;

use crate::agreeable::Agreeable;
use crate::german;
use crate::run::{Run, antrieb, check_document};
use antrieb::args::{Environment, Globals, Settings};
use antrieb::command::{Context, Entry, VERBS};
use antrieb::drive::Interrupt;
use antrieb::failure::Class;
use antrieb::outcome::{Event, Outcome};
use antrieb::profile::{Lang, Registry};
use antrieb::render::{self, Console, Format};
use clap::{Args, FromArgMatches};
use serde_json::{Map, Value};

use bench::{BENCH, FILES, HELD, MODULES, TAPE};
use rows::{cell, rows, shortened};

/// Runs a line in every form; it must end with this code in each.
#[track_caller]
fn case(name: &str, code: u8, line: &str) {
    if name.starts_with("monitor") || name.starts_with("sniff") {
        return stream(name, code, line);
    }
    let run = |options: &str| -> Run {
        let run = antrieb(&format!("{line} {options}")).on(bench_of(line));
        FILES.iter().chain(&[("held.toml", HELD)]).fold(run, |run, (name, text)| run.file(name, text))
    };
    tables(name, code, run);

    let document = run("").json().exits(code).value;
    insta::with_settings!({ filters => vec![(r#"[^\s"]*\.tmp\w+"#, "DIR")] }, {
        insta::assert_snapshot!(format!("{name}_json"), format!("{:#}\n", shortened(document.clone())));
    });

    let rows: Vec<Map<String, Value>> = rows(&document).into_iter().map(anywhere).collect();
    let ndjson = run("--format ndjson").exits(code).out;
    let mut lines: Vec<Value> = ndjson.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let end = lines.pop().unwrap();
    assert_eq!(end["type"], "end", "{end}");
    let mut whole = document.clone();
    whole.as_object_mut().unwrap().remove("data");
    let mut told = end.clone();
    told.as_object_mut().unwrap().remove("type");
    assert_eq!(nowhere(told), nowhere(whole), "the last line is the document without its data");
    check_document(&with_data(end, document["data"].clone()), code);
    let lines: Vec<Map<String, Value>> = lines.into_iter().map(untagged).map(anywhere).collect();
    assert_eq!(lines, rows, "NDJSON has the rows of the document");

    let csv = run("--format csv").exits(code).out;
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let head: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let records: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), rows.len(), "CSV has the rows of the document");
    let mut every: Vec<String> = Vec::new();
    for key in rows.iter().flat_map(Map::keys) {
        every.extend((!every.contains(key)).then(|| key.clone()));
    }
    // What holds several values has a column for each of them.
    let has = |name: &String| head.iter().any(|column| column == name || column.starts_with(&format!("{name}_")));
    let lost: Vec<&String> = every.iter().filter(|name| !has(name)).collect();
    assert!(lost.is_empty(), "CSV has a column for every field of any row: {lost:?} in {head:?}");
    assert_eq!(head.iter().collect::<std::collections::BTreeSet<_>>().len(), head.len(), "{head:?}");
    for (record, row) in records.iter().zip(&rows) {
        let is_place = |key: &str| ["port", "way_back", "undo_file"].contains(&key);
        let cell_of = |(key, text): (&String, &str)| {
            if is_place(key) && !text.is_empty() { "(port)".to_owned() } else { text.to_owned() }
        };
        assert!(!record.iter().any(|text| text.starts_with(['{', '['])), "a cell is a plain value: {record:?}");
        // What is made of several values in the document is a text here.
        let is_simple = |key: &&String| {
            every.contains(key) && !row.get(*key).is_some_and(|value| value.is_object() || value.is_array())
        };
        let simple = head.iter().zip(record).filter(|(key, _)| is_simple(key));
        let cells: Vec<(&String, String)> = simple.map(|pair| (pair.0, cell_of(pair))).collect();
        // A row of another kind, such as a drive that failed among values, has those cells that it has.
        let expected: Vec<(&String, String)> =
            head.iter().filter(is_simple).map(|key| (key, row.get(key).map_or_else(String::new, cell))).collect();
        assert_eq!(cells, expected);
    }
}

/// Both tables. A server of the moment has another port each time.
#[track_caller]
fn tables(name: &str, code: u8, run: impl Fn(&str) -> Run) {
    let tables = ["--lang en", "--lang de"].map(|lang| run(lang).exits(code).page());
    german::same(&tables[0], &tables[1]);
    insta::with_settings!({ filters => vec![(r"127\.0\.0\.1:\d+", "(port)")] }, {
        insta::assert_snapshot!(format!("{name}_table"), tables.join("\n"));
    });
}

/// The same for what streams: its records come one by one, and the last one is the end.
#[track_caller]
fn stream(name: &str, code: u8, line: &str) {
    let run = |options: &str| -> Run {
        match name {
            "sniff_fine" => antrieb(&format!("-p tape:{{dir}}/heard {line} {options}")).file("heard", TAPE),
            _ => antrieb(&format!("{line} {options}")).on(BENCH),
        }
    };
    tables(name, code, run);
    let lines = |out: &str| -> Vec<Value> { out.lines().map(|line| serde_json::from_str(line).unwrap()).collect() };
    let records = lines(&run("--format ndjson").exits(code).out);
    let end = records.last().unwrap();
    assert_eq!((&end["type"], &end["ok"]), (&"end".into(), &Value::Bool(code == 0)));
    if name.starts_with("monitor") {
        let validator = jsonschema::validator_for(&(entry("monitor").schema)()).unwrap();
        let json = lines(&run("--json").exits(code).out);
        assert!(json.iter().chain(&records).all(|record| validator.is_valid(record)), "{json:#?}");
    } else {
        let document = run("").json().exits(code).value;
        assert_eq!(rows(&document).len(), records.len() - 1);
    }
    let csv = run("--format csv").exits(code).out;
    assert!(csv::Reader::from_reader(csv.as_bytes()).records().all(|record| record.is_ok()), "{csv}");
}

fn bench_of(line: &str) -> &'static str {
    if line.contains("profibus live") || line.contains("profibus read") { MODULES } else { BENCH }
}

fn entry(name: &str) -> &'static Entry {
    VERBS.iter().find(|verb| verb.name == name).unwrap()
}

/// What comes of a verb that is interrupted after so many telegrams, in every form; with the code that it ends with.
#[track_caller]
fn interrupted(after: usize, code: u8, line: &str) {
    let directory = tempfile::tempdir().unwrap();
    for (name, text) in FILES.iter().chain(&[("bench.toml", bench_of(line)), ("heard", TAPE), ("held.toml", HELD)]) {
        std::fs::write(directory.path().join(name), text).unwrap();
    }
    let (kind, file) = if line.contains("sniff") { ("tape", "heard") } else { ("sim", "bench.toml") };
    let port = format!("{kind}:{}/{file}", directory.path().display());
    let line = line.replace("{dir}", &directory.path().display().to_string());
    let words = ["antrieb", "-p", &port].into_iter().chain(line.split_whitespace());
    let verbs = VERBS.iter().map(|verb| (verb.command)());
    let tree = Globals::augment_args(clap::Command::new("antrieb")).subcommands(verbs);
    let matches = tree.try_get_matches_from(words).unwrap();
    let (name, own) = matches.subcommand().unwrap();
    let (entry, verb) = (entry(name), (entry(name).typed)(own).unwrap());
    let globals = Globals::from_arg_matches(&matches).unwrap();
    let settings = Settings::resolve(&globals, &Environment::default()).unwrap();
    let settings = Settings { verbose: true, ..settings };
    let (registry, interrupt) = (Registry::open(&[]).unwrap(), Interrupt::default());
    let (pressed, mut heard) = (interrupt.clone(), 0);
    let mut observe = |event: Event| {
        heard += usize::from(matches!(event, Event::Telegram { .. } | Event::Record(_)));
        if heard >= after {
            pressed.raise();
        }
    };
    let mut context = Context {
        settings: &settings,
        registry: &registry,
        ask: &mut Agreeable,
        observe: &mut observe,
        interrupt,
        sheet: render::sheet,
        calls: None,
    };
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let outcome = runtime.block_on(verb.run(&mut context)).unwrap_or_else(Outcome::from);
    let class = outcome.failure.as_ref().map(|failure| failure.class);
    assert_eq!(class.map_or(0, Class::exit), code, "{line}: {:?}", outcome.failure);
    let printed = |format: Format, lang: Lang| {
        let (mut out, console) = (Vec::new(), Console::new(Box::new(std::io::sink()), lang, true, false));
        render::print(&outcome, entry.name, format, render::Manner::of(lang), &mut out, &console).unwrap();
        String::from_utf8(out).unwrap()
    };
    let tables = [Lang::En, Lang::De].map(|lang| printed(Format::Table, lang));
    assert_eq!(tables[0].is_empty(), tables[1].is_empty());
    let failed = outcome.failure.as_ref().map(|failure| [&failure.message.en, &failure.message.de]);
    failed.into_iter().for_each(|[english, german]| german::same(english, german));
    german::same(&tables[0], &tables[1]);
    if entry.name != "monitor" {
        check_document(&serde_json::from_str(&printed(Format::Json, Lang::En)).unwrap(), code);
    }
    let ndjson = printed(Format::Ndjson, Lang::En);
    let end: Value = serde_json::from_str(ndjson.lines().last().unwrap()).unwrap();
    assert_eq!(end["type"], "end");
    let csv = printed(Format::Csv, Lang::En);
    assert!(csv::Reader::from_reader(csv.as_bytes()).records().all(|record| record.is_ok()), "{csv}");
}

/// A row without the place of the bench, which is another one in every run.
fn anywhere(mut row: Map<String, Value>) -> Map<String, Value> {
    for place in ["port", "way_back", "undo_file"] {
        if let Some(place) = row.get_mut(place).filter(|place| !place.is_null()) {
            *place = "(port)".into();
        }
    }
    row.into_iter().map(|(name, field)| (name, nowhere(field))).collect()
}

/// A document without the name of its temporary directory, which hints give back as a port.
fn nowhere(value: Value) -> Value {
    match value {
        Value::String(text) => {
            let mut parts = text.split(".tmp");
            let first = parts.next().unwrap_or_default().to_owned();
            parts.fold(first, |text, part| text + ".tmp" + part.get(6..).unwrap_or(part)).into()
        }
        Value::Array(items) => items.into_iter().map(nowhere).collect(),
        Value::Object(fields) => fields.into_iter().map(|(name, field)| (name, nowhere(field))).collect(),
        other => other,
    }
}

fn with_data(mut end: Value, data: Value) -> Value {
    end.as_object_mut().unwrap().remove("type");
    end["data"] = data;
    end
}

/// A row of NDJSON as it stands in the document.
fn untagged(line: Value) -> Map<String, Value> {
    let Value::Object(mut fields) = line else { panic!("{line}") };
    assert!(fields.remove("type").is_some_and(|tag| tag.is_string()));
    fields
}

macro_rules! cases {
    ($($name:ident: $code:literal, $line:literal;)*) => {
        /// The names of all cases: a verb and a situation.
        const CASES: &[&str] = &[$(stringify!($name)),*];

        $(
            #[test]
            fn $name() {
                case(stringify!($name), $code, $line);
            }
        )*
    };
}

/// Where the interrupt comes after so many telegrams.
macro_rules! cuts {
    ($($name:ident: $after:literal, $code:literal, $line:literal;)*) => {
        const CUTS: &[&str] = &[$(stringify!($name)),*];

        $(
            #[test]
            fn $name() {
                interrupted($after, $code, $line);
            }
        )*
    };
}

/// What cannot happen to a verb, and why.
const NEVER: &[(&str, &[&str], &str)] = &[
    ("scan", &["refused"], "a refusal is an answer: somebody is there"),
    ("scan", &["partial"], "only an interrupt leaves addresses out"),
    ("init", &["refused", "partial"], "it finds what `scan` finds"),
    ("sniff", &["refused", "partial"], "it asks nobody, and hears what there is"),
    ("params", &["silence", "refused", "partial", "interrupted"], "it asks nobody, and is done at once"),
    ("decode", &["silence", "refused", "partial", "interrupted"], "it asks nobody, and is done at once"),
    ("plot", &["silence", "refused", "partial", "interrupted"], "it asks nobody, and is done at once"),
    ("procedure", &["partial"], "it ends at the first step that is not done"),
    ("simulate", &["silence", "refused", "partial"], "it is asked, and asks nobody"),
];

#[test]
fn every_verb_has_its_rows() {
    for verb in VERBS {
        for situation in ["fine", "silence", "refused", "partial", "interrupted"] {
            let name = format!("{}_{situation}", verb.name);
            let has_row = CASES.iter().chain(CUTS).any(|case| *case == name);
            let never = NEVER.iter().any(|row| row.0 == verb.name && row.1.contains(&situation));
            assert_ne!(has_row, never, "{name}: expected a row among the cases, or one that says why it never happens");
        }
    }
    for (verb, ..) in NEVER {
        assert!(VERBS.iter().any(|known| known.name == *verb), "{verb} is no verb");
    }
}

cases! {
    scan_fine: 0, "scan";
    scan_silence: 1, "-a 3-8 scan";

    identify_fine: 0, "-a 2 identify";
    identify_unknown: 0, "-a 9 identify";
    identify_refused: 6, "-a 9 --drive acu identify";
    identify_silence: 4, "-a 7 identify";
    identify_partial: 9, "-a 1,7 identify";

    read_fine: 0, "-a 1 read 372@2 481 411 260 270";
    read_two_drives: 0, "-a 1,2 read 372 411";
    read_differing: 0, "-a 1 read 372 480@ram";
    read_silence: 4, "-a 7 read 372@2 481";
    read_refused: 6, "-a 1 read 1600@2 --type long";
    read_partial: 9, "-a 1 read 372@2 1600";
    read_partial_drives: 9, "-a 2,7 read 372";
    read_unknown_drive: 7, "-a 9 read 372";

    write_fine: 0, "-a 1 --yes write 376@4=1.5kW 480@2ram=-12,5";
    write_unchanged: 0, "-a 1 write 481=10Hz";
    write_planned: 0, "-a 1 --dry-run write 376@4=1.5kW 10=5";
    write_unconfirmed: 8, "-a 1 write 376@4=1.5kW";
    write_broadcast: 0, "-a 0 --yes write 480=7.5";
    write_silence: 4, "-a 7 --yes write 376@4=1.5kW";
    write_refused: 6, "-a 1 --yes write 376@2=0";
    write_partial: 9, "-a 1 --yes write 480@1=6 376@2=0 481@1=7";
    write_bad: 7, "-a 1 --yes write 480@1=1000";

    dataset_fine: 0, "-a 1 dataset show 372 376 480";
    dataset_active: 0, "-a 1 dataset active";
    dataset_diff: 1, "-a 1 dataset diff 1 2";
    dataset_copy: 0, "-a 1 --yes dataset copy 2 3 372 376";
    dataset_select: 0, "-a 1 --yes dataset select 3";
    dataset_save: 0, "-a 1 dataset save --changed {dir}/saved.toml";
    dataset_save_partial: 9, "-a 1,7 dataset save --changed {dir}/saved-{address}.toml";
    dataset_check: 1, "-a 1 dataset check {dir}/held.toml";
    dataset_check_partial: 9, "-a 1,7 dataset check {dir}/held.toml";
    dataset_diff_files: 1, "dataset diff {dir}/held.toml factory";
    dataset_diff_unified: 1, "-a 1 dataset diff --unified {dir}/held.toml drive";
    dataset_diff_ram: 0, "-a 1 dataset diff 2 2ram 372";
    dataset_silence: 4, "-a 7 dataset show 372";
    dataset_load: 0, "-a 1 --yes dataset load {dir}/base.toml {dir}/pump.toml";
    dataset_load_dry: 0, "-a 1 --dry-run dataset load {dir}/pump.toml --only setpoints";
    dataset_load_same: 0, "-a 1 --yes dataset load {dir}/same.toml --ram";
    dataset_load_silence: 4, "-a 7 --drive act --yes dataset load {dir}/base.toml";
    dataset_load_refused: 7, "-a 1 --yes dataset load {dir}/wild.toml";
    dataset_load_undone: 9, "-a 1 --yes dataset load {dir}/refused.toml";
    dataset_undo: 0, "-a 1 --yes dataset undo {dir}/undo.toml";
    dataset_undo_changed: 9, "-a 1 --yes dataset undo {dir}/stale.toml";
    dataset_refused: 6, "-a 1 dataset show 1600";
    dataset_partial: 9, "-a 1 dataset show 372 1600";

    init_fine: 0, "-a 1-9 init {dir}/new.toml";
    init_silence: 1, "-a 3-8 init {dir}/new.toml";

    plan_fine: 0, "--config {dir}/same-plant.toml plan";
    plan_differs: 1, "--config {dir}/plant.toml -a @line plan";
    plan_dry: 0, "--config {dir}/plant.toml -a fan-2 plan --dry-run";
    plan_silence: 4, "--config {dir}/plant.toml -a ghost-7 plan";
    plan_refused: 7, "--config {dir}/wild-plant.toml plan";
    plan_partial: 9, "--config {dir}/plant.toml plan";

    apply_fine: 0, "--config {dir}/plant.toml -a @line --yes apply";
    apply_silence: 4, "--config {dir}/plant.toml -a ghost-7 --yes apply";
    apply_refused: 9, "--config {dir}/torn-plant.toml -a pump-1 --yes apply";
    apply_partial: 9, "--config {dir}/torn-plant.toml --yes apply";
    apply_atomic: 9, "--config {dir}/torn-plant.toml --yes apply --atomic";
    apply_none: 4, "--config {dir}/plant.toml -a pump-1,ghost-7 --yes apply --atomic";

    check_fine: 0, "--config {dir}/same-plant.toml check";
    check_drift: 1, "--config {dir}/plant.toml -a @line check";
    check_dry: 0, "--config {dir}/plant.toml -a fan-2 check --dry-run";
    check_silence: 4, "--config {dir}/plant.toml -a ghost-7 check";
    check_refused: 7, "--config {dir}/plant.toml -a stranger-9 check";
    check_partial: 9, "--config {dir}/plant.toml check";

    diag_fine: 0, "-a 1 diag";
    diag_fault: 0, "-a 2 diag";
    diag_check: 1, "-a 2 diag --check";
    diag_silence: 4, "-a 7 diag";
    diag_refused: 6, "-a 9 --drive acu diag";
    diag_partial: 9, "-a 1,7 diag";

    statemachine_fine: 0, "-a 2 statemachine";
    statemachine_silence: 4, "-a 7 statemachine";
    statemachine_refused: 6, "-a 9 --drive acu statemachine";
    statemachine_partial: 9, "-a 1,7 statemachine";

    sollwert_fine: 0, "-a 2 sollwert";
    sollwert_silence: 4, "-a 7 sollwert";
    sollwert_refused: 6, "-a 9 --drive acu sollwert";

    sollwert_partial: 9, "-a 1,7 sollwert";

    params_fine: 0, "params 413";
    params_one: 0, "params 412";
    params_several: 0, "params rated";
    params_none: 1, "params nonsense";

    systembus_fine: 0, "systembus plan {dir}/bus.toml";
    systembus_relations: 0, "systembus plan {dir}/relations.toml";
    systembus_broken: 1, "systembus plan {dir}/broken.toml";
    systembus_load: 0, "systembus load";
    systembus_sum: 1, "systembus load 50 6 6 6";
    systembus_show: 0, "-a 2 systembus show";
    systembus_silence: 4, "-a 7 systembus show";
    systembus_refused: 6, "-a 1 systembus show";
    systembus_partial: 9, "-a 2,7 systembus show";
    systembus_check: 1, "systembus check {dir}/bus.toml drive-1=2";
    systembus_apply: 0, "--yes systembus apply {dir}/bus.toml drive-1=2";

    decode_fine: 0, "decode fault F0500";
    decode_telegram: 0, "decode telegram 01 65 21 77 00 00 03 E8 46 C5";
    decode_can: 0, "decode can 605#4074010200000000 585#427401026E050000 085#0010800000000122";
    decode_garbage: 5, "decode telegram 01 02 03";
    decode_status: 0, "decode status 0x0237";
    decode_control: 0, "--drive act decode control 0x000F --mode 1";
    decode_warnings: 0, "decode warnings 0x8083";
    decode_fault: 0, "decode fault F2105";
    profibus_live: 0, "profibus live";
    profibus_live_one: 0, "-a 3 profibus live";
    profibus_planned: 0, "-a 3 --dry-run profibus live";
    profibus_read: 0, "-a 3 --yes profibus read F002 614 703 219";
    profibus_unconfirmed: 8, "-a 3 profibus read F002";
    profibus_refused: 6, "-a 3 --yes profibus read 599";
    profibus_partial: 9, "-a 3 --yes profibus read 614 599";
    profibus_mute: 4, "-a 9 --yes profibus read 614";
    profibus_silence: 1, "-a 9,10 profibus live";
    profibus_fine: 0, "profibus module L200 set deceleration min 0x0001 max 0x7530";
    decode_stw: 0, "decode control 0x047F --drive l200";
    params_hitachi: 0, "--drive x200 params F002";
    decode_error: 0, "decode error 11";
    decode_dp: 0, "decode telegram 68 05 05 68 88 82 6D 3C 3E F1 16 68 0B 0B 68 82 88 08 3E 3C 02 05 00 FF 0A 35 D1 16";
    decode_dp_garbage: 5, "--protocol dp decode telegram 10 08 02 49 54 16";
    decode_pkw: 0, "decode pkw 7393 0100 0000 0022";
    decode_diagnosis: 0, "decode diagnosis 08 0C 00 02 0A 35 04 01 02 03";
    decode_basic_status: 0, "decode basic-status 0x0DD0";
    decode_basic_control: 0, "decode basic-control 0x4051";

procedure_fine: 0, "-a 1 --yes procedure first-contact watchdog=2s --record {dir}/p.json";
    procedure_planned: 0, "-a 1 --dry-run procedure first-contact watchdog=2s";
    procedure_silence: 4, "-a 7 --yes procedure first-contact --record {dir}/p.json";
    procedure_refused: 6, "-a 9 --drive acu --yes procedure first-contact --record {dir}/p.json";

        report_fine: 0, "-a 1 report --changed --count 20";
    report_silence: 4, "-a 7 report";
    report_refused: 6, "-a 9 --drive acu report --count 2";
    report_partial: 9, "-a 2,7 report --changed --count 20";

    diag_line: 0, "-a 2 diag line --count 20";
    diag_line_partial: 9, "-a 2,7 diag line --count 20";

    protocol_fine: 0, "-a 1 protocol show";
    protocol_unchanged: 0, "-a 1 --yes protocol set rtu";
    protocol_moved: 0, "-a 1 --yes protocol set ascii";
    protocol_silence: 4, "-a 7 protocol show";
    protocol_refused: 6, "-a 9 --drive acu protocol show";
    protocol_partial: 9, "-a 1,7 protocol show";

    line_fine: 0, "-a 1 line show";
    line_moved: 0, "-a 1 --yes line set --baud 9600";
    line_silence: 4, "-a 7 line show";
    line_refused: 6, "-a 9 --drive acu line show";
    line_partial: 9, "-a 1,7 line show";

    simulate_fine: 0, "simulate --for 1ms --tcp 127.0.0.1:0";

    plot_fine: 0, "plot {dir}/record.csv --measure";

    monitor_fine: 0, "-a 1,2 monitor --count 2";
    monitor_silence: 4, "-a 7 monitor 411 --count 1";
    monitor_refused: 6, "-a 1 monitor 1600 --count 1";
    monitor_partial: 9, "-a 1,7 monitor 411 --count 1";

    sniff_fine: 0, "sniff --count 4";
    sniff_silence: 4, "sniff --for 1s";
}

cuts! {
    procedure_interrupted: 9, 130, "-a 1 --yes procedure first-contact --record {dir}/p.json";
    scan_interrupted: 40, 130, "scan";
    identify_interrupted: 6, 130, "-a 1,2 identify";
    read_interrupted: 8, 130, "-a 1,2 read 372 480@all 411";
    write_interrupted: 7, 130, "-a 1,2 --yes write 376@4=1.5kW 480@2ram=-12,5";
    dataset_interrupted: 12, 130, "-a 1 dataset show 372 376 480";
    dataset_save_interrupted: 30, 130, "-a 1 dataset save {dir}/saved.toml";
    dataset_check_interrupted: 8, 130, "-a 1 dataset check {dir}/held.toml";
    init_interrupted: 40, 130, "init {dir}/new.toml";
    plan_interrupted: 8, 130, "--config {dir}/plant.toml plan";
    apply_interrupted: 40, 130, "--config {dir}/plant.toml -a @line --yes apply";
    systembus_interrupted: 12, 130, "-a 2 systembus show";
    check_interrupted: 8, 130, "--config {dir}/plant.toml check";
    diag_interrupted: 8, 130, "-a 1,2 diag";
    report_interrupted: 60, 130, "-a 1,2 report";
    statemachine_interrupted: 8, 130, "-a 1,2 statemachine";
    sollwert_interrupted: 8, 130, "-a 1,2 sollwert";
    protocol_interrupted: 8, 130, "-a 1,2 protocol show";
    line_interrupted: 8, 130, "-a 1,2 line show";
    monitor_interrupted: 6, 0, "-a 1,2 monitor --count 50";
    sniff_interrupted: 2, 0, "sniff";
    profibus_interrupted: 3, 130, "profibus live";
    simulate_interrupted: 0, 0, "simulate --tcp 127.0.0.1:0";
}
