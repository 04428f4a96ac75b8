//! Every verb x {fine, silence, refused, partial} x {table en, table de, JSON, NDJSON, CSV}.
//!
//! Both tables and the JSON document are snapshots; NDJSON and CSV are held against the JSON document.

use crate::run::{Run, antrieb, check_document};
use serde_json::{Map, Value};

/// An ACU with a fault and a warning, an ACT whose data sets differ, and a device that is no drive.
const BENCH: &str = "\
[[drive]]
model = \"act\"
address = 1
set = { \"372@2\" = 1450, \"480@3\" = -12.5 }
[[drive]]
model = \"acu\"
address = 2
modules = [\"EM-RES-03\"]
set = { \"412\" = 1, \"210\" = 12.49, \"228\" = 12.5 }
[[drive.event]]
at = \"0s\"
fault = \"F0500\"
warning = 0x0020
[[drive]]
model = \"foreign\"
address = 9
registers = { \"0\" = 17 }
";

/// Runs a line in every form; it must end with this code in each.
#[track_caller]
fn case(name: &str, code: u8, line: &str) {
    let run = |options: &str| -> Run { antrieb(&format!("{line} {options}")).on(BENCH) };
    let tables = [run("--lang en"), run("--lang de")].map(|run| run.exits(code).page());
    insta::assert_snapshot!(format!("{name}_table"), tables.join("\n"));

    let document = run("").json().exits(code).value;
    insta::assert_snapshot!(format!("{name}_json"), format!("{:#}\n", shortened(document.clone())));

    let rows: Vec<Map<String, Value>> = rows(&document).into_iter().map(anywhere).collect();
    let ndjson = run("--format ndjson").exits(code).out;
    let mut lines: Vec<Value> = ndjson.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let end = lines.pop().unwrap();
    assert_eq!(end["type"], "end", "{end}");
    let mut whole = document.clone();
    whole.as_object_mut().unwrap().remove("data");
    let mut told = end.clone();
    told.as_object_mut().unwrap().remove("type");
    assert_eq!(told, whole, "the last line is the document without its data");
    check_document(&with_data(end, document["data"].clone()), code);
    let lines: Vec<Map<String, Value>> = lines.into_iter().map(untagged).map(anywhere).collect();
    assert_eq!(lines, rows, "NDJSON has the rows of the document");

    let csv = run("--format csv").exits(code).out;
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let head: Vec<String> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    let records: Vec<_> = reader.records().map(Result::unwrap).collect();
    assert_eq!(records.len(), rows.len(), "CSV has the rows of the document");
    for (record, row) in records.iter().zip(&rows) {
        let cell_of = |(key, text): (&String, &str)| if key == "port" { "(port)".to_owned() } else { text.to_owned() };
        let cells: Vec<(&String, String)> = head.iter().zip(record).map(|pair| (pair.0, cell_of(pair))).collect();
        let expected: Vec<(&String, String)> = row.iter().map(|(key, value)| (key, cell(value))).collect();
        assert_eq!(cells, expected);
    }
}

/// A row without the place of the bench, which is another one in every run.
fn anywhere(mut row: Map<String, Value>) -> Map<String, Value> {
    if let Some(port) = row.get_mut("port") {
        *port = "(port)".into();
    }
    row
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
    fields.into_iter().map(|(key, value)| (if key == "data_type" { "type".to_owned() } else { key }, value)).collect()
}

/// What a value is in CSV.
fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// The list that a document is in the main.
fn rows(document: &Value) -> Vec<Map<String, Value>> {
    let data = &document["data"];
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let rows: Vec<Value> = match document["command"].as_str().unwrap() {
        _ if data.is_null() => Vec::new(),
        "scan" | "identify" | "diag" | "statemachine" => list(&data["drives"]),
        "read" | "write" => list(&data["values"]),
        "params" => list(&data["params"]),
        "decode" if !list(&data["telegrams"]).is_empty() => list(&data["telegrams"]),
        "decode" => vec![data.clone()],
        "dataset" if list(&data["rows"]).is_empty() && list(&data["written"]).is_empty() => vec![data.clone()],
        "dataset" => {
            let values = list(&data["rows"]).into_iter().flat_map(|row| list(&row["values"]));
            values.chain(list(&data["written"])).collect()
        }
        "sollwert" => {
            let of = |drive: Value| {
                ["setpoints", "actual", "sources"]
                    .into_iter()
                    .flat_map(move |part| list(&drive[part]))
                    .collect::<Vec<_>>()
            };
            let failed = list(&data["drives"]).into_iter().filter(|drive| !drive["error"].is_null());
            list(&data["drives"]).into_iter().flat_map(of).chain(failed).collect()
        }
        other => panic!("{other}"),
    };
    rows.into_iter().map(|row| row.as_object().unwrap().clone()).collect()
}

/// A document without its long lists of bits and counters, for snapshots that people read.
fn shortened(mut value: Value) -> Value {
    match &mut value {
        Value::Object(fields) => {
            for (key, field) in fields.iter_mut() {
                match (key.as_str(), &field) {
                    ("bits" | "counters", Value::Array(list)) => *field = format!("({} rows)", list.len()).into(),
                    ("port", Value::String(_)) => *field = "(port)".into(),
                    _ => *field = shortened(field.take()),
                }
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|item| *item = shortened(item.take())),
        _ => {}
    }
    value
}

macro_rules! cases {
    ($($name:ident: $code:literal, $line:literal;)*) => {$(
        #[test]
        fn $name() {
            case(stringify!($name), $code, $line);
        }
    )*};
}

cases! {
    scan_fine: 0, "scan";
    scan_silence: 1, "-a 3-8 scan";

    identify_fine: 0, "-a 2 identify";
    identify_unknown: 0, "-a 9 identify";
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

    dataset_show: 0, "-a 1 dataset show 372 376 480";
    dataset_active: 0, "-a 1 dataset active";
    dataset_diff: 1, "-a 1 dataset diff 1 2";
    dataset_copy: 0, "-a 1 --yes dataset copy 2 3 372 376";
    dataset_select: 0, "-a 1 --yes dataset select 3";
    dataset_silence: 4, "-a 7 dataset show 372";
    dataset_refused: 6, "-a 1 dataset show 1600";
    dataset_partial: 9, "-a 1 dataset show 372 1600";

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

    params_one: 0, "params 412";
    params_several: 0, "params rated";
    params_none: 1, "params nonsense";

    decode_telegram: 0, "decode telegram 01 65 21 77 00 00 03 E8 46 C5";
    decode_garbage: 5, "decode telegram 01 02 03";
    decode_status: 0, "decode status 0x0237";
    decode_control: 0, "--drive act decode control 0x000F --mode 1";
    decode_warnings: 0, "decode warnings 0x8083";
    decode_fault: 0, "decode fault F2105";
    decode_error: 0, "decode error 11";
}
