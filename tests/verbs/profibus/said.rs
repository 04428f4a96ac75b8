//! What is said of a run over PROFIBUS, a stop, a reset and a state: documents, records, plans and pages, in both languages.

use super::rig::{RESTS, event, module};
use crate::run::{antrieb, check_document};
use serde_json::Value;

const RUN: &str = "-a 3 --protocol dp --yes sollwert 20Hz --jog 3s --take-control --watchdog 2s";

#[test]
fn a_run_tells_its_words_its_setpoint_and_its_end() {
    let run = antrieb(RUN).on(&module(RESTS, "", "")).json().exits(0);
    assert_eq!((run.data("/action"), run.data("/mode")), (&"sollwert".into(), &"frequency".into()));
    let setpoint = ["value", "unit", "reached"].map(|key| run.data(&format!("/setpoint/{key}")).clone());
    assert_eq!(setpoint, [Value::from(20.0), "Hz".into(), true.into()]);
    let actual = run.data("/setpoint/actual").as_f64().unwrap();
    assert!((19.9..=20.0).contains(&actual), "{actual}");
    let steps = run.data("/steps").as_array().unwrap();
    let steps: Vec<_> = steps.iter().map(|step| (&step["command"], &step["control"], &step["state"]["slug"])).collect();
    let row = |command: &str, control: &str, state: &str| [command, control, state].map(Value::from);
    let expected = [row("OFF1", "0x0406", "ready-to-switch-on"), row("ON1", "0x047F", "operation-enabled")];
    assert_eq!(
        steps,
        [(&expected[0][0], &expected[0][1], &expected[0][2]), (&expected[1][0], &expected[1][1], &expected[1][2])]
    );
    assert_eq!(run.data("/stop/acknowledged"), true);
    assert_eq!((run.data("/standing"), run.data("/running")), (&true.into(), &false.into()));
    let changed: Vec<_> =
        run.data("/changed").as_array().unwrap().iter().map(|row| (&row["name"], &row["restored"])).collect();
    assert_eq!(changed, [(&"P.703".into(), &true.into()), (&"P.928".into(), &true.into())]);
}

#[test]
fn records_of_a_run_begin_hold_and_end() {
    let run = antrieb(RUN).and("--format ndjson").on(&module(RESTS, "", "")).exits(0);
    let records: Vec<Value> = run.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let types: Vec<&str> = records.iter().map(|record| record["type"].as_str().unwrap()).collect();
    assert_eq!((types[0], *types.last().unwrap()), ("start", "end"), "{types:?}");
    let is_phase = |record: &Value, phase: &str| record["type"] == "run" && record["phase"] == phase;
    let held = records.iter().skip_while(|record| !is_phase(record, "held"));
    let samples: Vec<f64> = held
        .take_while(|record| !is_phase(record, "stopping"))
        .filter(|record| record["type"] == "sample")
        .map(|record| record["values"][2]["value"].as_f64().unwrap())
        .collect();
    assert!(records.iter().any(|record| is_phase(record, "stopping")), "{types:?}");
    assert!((10..=14).contains(&samples.len()), "{samples:?}");
    assert!(samples.is_sorted() && (19.9..=20.0).contains(samples.last().unwrap()), "{samples:?}");
}

#[test]
fn a_plan_tells_the_words_and_opens_nothing() {
    for (verb, words) in [
        ("sollwert -20Hz --jog 3s", &["0406", "0C7F", "047E"][..]),
        ("sollwert 30% --jog 3s", &["0406", "047F", "047E"]),
        ("statemachine disable", &["047E"]),
        ("statemachine disable-voltage", &["047A"]),
        ("statemachine reset", &["0406", "0486", "0406", "047E"]),
        ("statemachine show", &["047E"]),
    ] {
        let run = antrieb(&format!("-a 3 --protocol dp --dry-run {verb}")).on(&module(RESTS, "", "")).json().exits(0);
        let telegrams = run.data("/telegrams").as_array().unwrap();
        let told: Vec<&str> = telegrams.iter().map(|telegram| telegram["meaning"].as_str().unwrap()).collect();
        assert_eq!(told.len(), words.len(), "{verb}: {told:?}");
        told.iter().zip(words).for_each(|(told, word)| assert!(told.contains(word), "{verb}: {told}"));
        assert!(antrieb::transport::witness::left_profibus().is_none(), "no line was opened");
    }
}

#[test]
fn the_state_is_told_without_anything_being_written() {
    let run = antrieb("-a 3 --protocol dp --yes statemachine").on(&module(RESTS, "", "")).json().exits(0);
    assert_eq!(run.data("/drives/0/control_mode/raw"), 0);
    assert_eq!(run.data("/drives/0/missing").as_array().unwrap().len(), 1);
    assert_eq!(
        (run.data("/drives/0/state/slug"), run.data("/drives/0/fault_code")),
        (&"ready-to-switch-on".into(), &0.into())
    );
    let tripped = module(RESTS, "", &event("100ms", "trip = true"));
    let run = antrieb("-a 3 --protocol dp --yes statemachine show").on(&tripped).json().exits(0);
    assert_eq!((run.data("/drives/0/state/slug"), run.data("/drives/0/fault_code")), (&"fault".into(), &Value::Null));
    antrieb("-a 3 --protocol dp statemachine show").on(&module(RESTS, "", "")).exits(8);
}

#[test]
fn a_stop_needs_no_yes_and_no_terminal() {
    let driven = module(&RESTS.replace("\"928\" = 0", "\"928\" = 1"), "", &event("0s", "contact = true"));
    for verb in ["statemachine disable", "statemachine quick-stop", "statemachine disable-voltage", "sollwert 0Hz"] {
        let run = antrieb(&format!("-a 3 --protocol dp {verb} --json")).on(&driven).run();
        assert_eq!(run.exit, 0, "{verb}: {}", run.err);
        let document: Value = serde_json::from_str(&run.out).unwrap();
        check_document(&document, 0);
        assert_eq!(run.err.contains("OFF1"), verb.contains("quick-stop"), "{}", run.err);
    }
}

#[test]
fn pages_are_german_where_that_is_wanted() {
    let tripped = module(RESTS, "", &event("100ms", "trip = true"));
    for (line, bench, code) in [
        ("sollwert 20Hz --jog 2s --take-control --watchdog 2s", module(RESTS, "", ""), 0),
        ("sollwert 20Hz --jog 2s --take-control --on-exit coast", module(RESTS, "", ""), 0),
        ("sollwert 20Hz --jog 2s --take-control", tripped.clone(), 8),
        ("sollwert 20Hz --jog 9s --take-control", module(RESTS, "", &event("6s", "trip = true")), 8),
        ("sollwert 20Hz --jog 9s --take-control", module(RESTS, "", &event("6s", "cut = true")), 4),
        ("sollwert 20Hz --jog 9s --take-control", module(RESTS, "a004 = \"0.1hz\"", ""), 0),
        ("statemachine show", module(RESTS, "", ""), 0),
        ("statemachine reset", tripped, 0),
        ("statemachine quick-stop", module(RESTS, "", ""), 0),
        ("statemachine disable --dry-run", module(RESTS, "", ""), 0),
        ("sollwert 20Hz --jog 2s --dry-run", module(RESTS, "", ""), 0),
    ] {
        antrieb(&format!("-a 3 --protocol dp --yes {line} --lang de")).on(&bench).exits(code);
        antrieb(&format!("-a 3 --protocol dp --yes {line}")).on(&bench).exits(code);
    }
    let asked = antrieb("-a 3 --protocol dp sollwert 20Hz --jog 2s --take-control --watchdog 2s --lang de");
    let asked = asked.on(&module(RESTS, "", "")).answered("j\nj").exits(0);
    assert!(asked.err.contains("P.928 0 -> 1") && asked.err.contains("P.703 0 -> 2"), "{}", asked.err);
}
