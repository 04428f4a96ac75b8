//! `monitor` over PROFIBUS: what comes with every exchange at the speed of the bus, parameters over PKW beside it, in both modes.

use super::rig::{event, module};
use super::{is_let_go, later};
use crate::run::{Output, antrieb};
use serde_json::{Value, json};

/// The terminals run it at 10 Hz, and P.928 leaves it to them.
const RUNS: &str = "\"928\" = 0, \"703\" = 2, \"88\" = 1, \"89\" = 1, \"7\" = -100, \"9\" = -100";

#[track_caller]
fn watched(typed: &str, bench: &str) -> (Output, Vec<Value>) {
    let typed = format!("-a 3 --protocol dp --yes {typed} --unpaced --format ndjson");
    let run = antrieb(&typed).on(bench).run();
    let records = run.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    (run, records)
}

fn samples(records: &[Value]) -> Vec<&Value> {
    records.iter().filter(|record| record["type"] == "sample").collect()
}

/// A value of a sample by its number.
fn of(sample: &Value, param: u32) -> &Value {
    let values = sample["values"].as_array().unwrap();
    values.iter().find(|value| value["param"] == param).unwrap_or_else(|| panic!("no {param} in {sample:#}"))
}

#[test]
fn words_come_with_every_exchange() {
    let bench = format!("[line]\nbaud = 500000\n{}", module(RUNS, "", &event("1800ms", "contact = true")));
    let (run, records) = watched("--baud 500000 monitor --interval 0 --count 1500", &bench);
    let start = &records[0];
    assert_eq!([&start["protocol"], &start["line"]], [&json!("dp"), &json!("500000 8E1")], "{}", run.err);
    let samples = samples(&records);
    assert_eq!(samples.len(), 1_500);
    let t: Vec<f64> = samples.iter().map(|sample| sample["t"].as_f64().unwrap()).collect();
    let longest = t.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    assert!(longest < 0.005, "{longest}");
    let (first, last) = (samples[0], samples[1_499]);
    assert_eq!(of(last, 968)["word"]["raw"], of(last, 968)["raw"]);
    assert_eq!((of(last, 700)["value"].clone(), of(last, 700)["unit"].clone()), (json!(0.0), json!("%")));
    let [raw, percent] = ["raw", "value"].map(|key| of(last, 701)[key].as_f64().unwrap());
    assert!((raw / 163.84 - percent).abs() < 0.01, "{raw} {percent}");
    assert!(of(first, 701)["raw"] != of(last, 701)["raw"]);
    assert!(last["state"]["slug"].is_string());
}

#[test]
fn the_block_of_basic_mode_is_told_in_hertz() {
    let (run, records) =
        watched("--drive l200 monitor --mode basic --interval 0 --count 5 700 701 968 F002", &module("", "", ""));
    let drive = &records[0]["drives"][0];
    let columns: Vec<_> = drive["columns"].as_array().unwrap().iter().map(|column| column["param"].clone()).collect();
    assert_eq!(columns, [611, 614, 7], "{}", run.err);
    for sample in samples(&records) {
        assert_eq!([&of(sample, 614)["value"], &of(sample, 611)["value"]], [&json!(0.0), &json!(0.0)]);
        assert_eq!(sample["state"]["slug"], "stop");
        assert_eq!(of(sample, 7)["error"]["code"], "refused.no_pkw");
    }
    assert_eq!(run.exit, 9, "the ramp never came");
    let run = antrieb("-a 3 --protocol dp --yes --drive l200 monitor --mode basic --count 2 --unpaced")
        .on(&module("", "", ""));
    let run = run.exits(0);
    assert!(run.out.contains("state") && run.out.contains("Stop"), "{}", run.out);
}

#[test]
fn parameters_are_asked_for_beside_the_words() {
    let (run, records) = watched("monitor 968 614 F002 --interval 500ms --count 3", &module("\"7\" = -500", "", ""));
    let samples = samples(&records);
    assert_eq!((run.exit, samples.len()), (0, 3), "{}", run.err);
    for (sample, t) in samples.iter().zip([0.0, 0.5, 1.0]) {
        assert!((sample["t"].as_f64().unwrap() - t).abs() < 0.04, "{}", sample["t"]);
        assert_eq!([&of(sample, 7)["value"], &of(sample, 614)["value"]], [&json!(5.0), &json!(0.0)]);
    }
    let bus = later();
    assert!(is_let_go(&bus) && bus.remarks().is_empty(), "{:?}", bus.remarks());
}

#[test]
fn triggers_look_at_words_in_percent() {
    let bench = module(RUNS, "", &event("3s", "contact = true"));
    let (run, records) =
        watched("monitor --interval 0 --duration 6s --trigger 'actual > 10%' --once --post 100ms", &bench);
    let first = records.iter().position(|record| record["type"] == "trigger").unwrap_or_else(|| panic!("{}", run.err));
    let beyond = &records[first + 1];
    let value = of(beyond, 701)["value"].as_f64().unwrap();
    assert!(value > 10.0 && value < 13.0, "{value}");
    assert_eq!(records.last().unwrap()["summary"]["because"], "trigger");
}

#[test]
fn a_trip_is_told_with_what_was_seen_before_it() {
    let bench = module("", "", &event("2s", "trip = true"));
    let (_, records) = watched("monitor --interval 100ms --duration 3s", &bench);
    let trip = records.iter().find(|record| record["type"] == "trip").unwrap();
    assert_eq!(trip["before"]["state"]["slug"], "ready-to-switch-on");
    let last = *samples(&records).last().unwrap();
    assert_eq!(last["state"]["slug"], "fault");
    assert_eq!(trip["fault"], json!(null), "no bit of ZSW names a cause");
    let (run, records) = watched("--drive l200 monitor --mode basic --interval 100ms --duration 3s", &bench);
    let trip = records.iter().find(|record| record["type"] == "trip").unwrap();
    assert_eq!((&trip["fault"]["key"], &trip["fault"]["code"]), (&json!("25h"), &json!(0x25)), "{trip:#}");
    assert!(run.err.contains("25h external fault"), "{}", run.err);
}

#[test]
fn a_wire_that_is_cut_is_a_gap_and_the_watch_goes_on() {
    let events = [event("2s", "cut = true"), event("9s", "cut = false")].concat();
    let (run, records) = watched("monitor --interval 200ms --duration 12s", &module("", "", &events));
    let (gaps, good): (Vec<_>, Vec<_>) = samples(&records).into_iter().partition(|sample| !sample["error"].is_null());
    assert!(!gaps.is_empty() && good.last().unwrap()["t"].as_f64() > Some(11.0), "{}", run.err);
    assert!(run.err.contains("answers again after"), "{}", run.err);
    assert!(is_let_go(&later()));
}

#[test]
fn what_is_watched_is_recorded_in_every_form() {
    let bench = module("\"703\" = 2", "", "");
    let line = "-a 3 --protocol dp --yes monitor --interval 100ms --count 4 --unpaced --record {dir}/run";
    for (form, rows) in [("csv", 5), ("ndjson", 6)] {
        let run = antrieb(&format!("{line}.{form}")).on(&bench).exits(0);
        let text = std::fs::read_to_string(run.directory().join(format!("run.{form}"))).unwrap();
        assert_eq!(text.lines().count(), rows, "{text}");
    }
    let run = antrieb("-a 3 --protocol dp --yes monitor --interval 100ms --count 2 --unpaced --format csv")
        .on(&bench)
        .exits(0);
    assert!(run.out.starts_with("t,n,address,drive,state,"), "{}", run.out);
}

#[test]
fn nobody_is_watched_without_a_yes_and_plans_send_nothing() {
    let bench = module("", "", "");
    antrieb("-a 3 --protocol dp monitor --unpaced").on(&bench).exits(8);
    let run = antrieb("-a 3 --protocol dp --dry-run monitor").on(&bench).exits(0);
    assert!(run.out.contains("047E"), "{}", run.out);
    antrieb("-a 3 --protocol dp --yes monitor --reconnect").on(&bench).exits(2);
    antrieb("-a 3 monitor --mode basic").on(&bench).exits(2);
}

#[test]
fn whoever_turns_by_its_terminals_is_left_so_where_the_bus_has_no_right() {
    let bench = module(RUNS, "", &event("0s", "contact = true"));
    let (run, _) = watched("monitor --interval 0 --count 100", &bench);
    assert_eq!(run.exit, 0, "{}", run.err);
    assert!(run.err.contains("warning: THE SHAFT MAY STILL TURN"), "{}", run.err);
}
