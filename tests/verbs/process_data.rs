//! Process data on the simulated bus: the examples of the EM-RES-03 manual planned, applied and running; the bus watched, and its
//! nodes started and stopped.

use crate::run::{Run, antrieb};
use antrieb::simulator::Can;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::{Value, json};

const RELATIONS: &str = include_str!("../../docs/examples/system-bus-relations.toml");
const AS_WORDS: &str = include_str!("../../docs/examples/system-bus-links-as-words.toml");
const AS_LONG: &str = include_str!("../../docs/examples/system-bus-links.toml");
const SETPOINT: &str = include_str!("../../docs/examples/system-bus-setpoint.toml");

/// The inputs of "function C" (5.11.5), which no source names.
const FUNCTION_C: &str = "schema = 1\nfamily = \"active\"\nparams = [\n\
    { id = 125, slug = \"c-one\", de = \"C eins\", en = \"C one\", type = \"uint\", access = \"rw\", enum = \"signal-source\" },\n\
    { id = 187, slug = \"c-two\", de = \"C zwei\", en = \"C two\", type = \"uint\", access = \"rw\", enum = \"signal-source\" },\n]\n";

/// ACUs at these nodes, each with more of its table.
fn nodes(rows: &[(u8, &str)]) -> String {
    rows.iter().map(|(node, more)| format!("[[drive]]\nmodel = \"acu\"\naddress = {node}\n{more}\n")).collect()
}

/// A plan that says how all of its drives count.
fn counted(plan: &str) -> String {
    plan.lines()
        .map(|line| {
            if line.starts_with("node = ") && !plan.contains("rx-functions") {
                format!("{line}\nrx-functions = \"0-1\"\n")
            } else {
                format!("{line}\n")
            }
        })
        .collect()
}

/// The bus behind a plan that was applied over it, with its nodes started; at what time.
fn started(line: Run) -> (Can, u64) {
    line.exits(0);
    let mut bus = witness::left_can().unwrap();
    assert!(bus.remarks().is_empty() && bus.orders().is_empty() && !bus.is_open(), "{:?}", bus.remarks());
    let now = bus.now();
    bus.master_sends(now, b"S6\rO\rt00020100\r");
    let ms = now.since(Tick::ZERO).as_millis();
    pass(&mut bus, ms + 100);
    (bus, ms)
}

fn pass(bus: &mut Can, until_ms: u64) {
    bus.advance(Tick::ZERO + Span::from_millis(until_ms));
}

fn applied(plan: &str, bench: &str) -> Run {
    let line = "--catalogue {dir}/c.toml --protocol sdo --yes systembus apply {dir}/bus.toml";
    antrieb(line).on(bench).file("bus.toml", &counted(plan)).file("c.toml", FUNCTION_C)
}

#[test]
fn the_relations_of_5_11_4_run_and_what_is_missing_trips_its_receivers() {
    let silent = "[[drive.event]]\nat = \"100s\"\nsilent = \"10s\"";
    let bench = nodes(&[(1, &format!("set = {{ \"410\" = 7, \"228\" = 50 }}\n{silent}")), (2, ""), (3, "")]);
    let (mut bus, now) = started(applied(RELATIONS, &bench));
    assert!(now < 90_000);
    let of = |bus: &mut Can, node, source| bus.source(node, source).unwrap();
    // The control word by 385 to both, the setpoint by 641, the status word of the third by 642 as RxPDO3.
    assert_eq!([of(&mut bus, 2, 704), of(&mut bus, 3, 704), of(&mut bus, 2, 718)], [7, 7, 5_000]);
    let status = bus.ram(3, 411, 0);
    assert_eq!(Some(of(&mut bus, 2, 724)), status);
    let faults = |bus: &Can| [1, 2, 3].map(|node| bus.ram(node, 260, 0).unwrap());
    assert_eq!(faults(&bus), [0; 3]);
    pass(&mut bus, 99_900);
    assert_eq!(faults(&bus), [0; 3]);
    pass(&mut bus, 100_200);
    assert_eq!(faults(&bus), [0, 0x2201, 0x2201], "RxPDO1 of both");
}

#[test]
fn both_forms_of_example_2_of_5_11_5_bring_their_values() {
    let bench = nodes(&[(1, "sources = { \"27\" = 70000, \"5\" = 1234 }"), (2, "")]);
    for (plan, source, arrives) in [(AS_LONG, 729, 70_000), (AS_WORDS, 727, 70_000 % 65_536)] {
        let (mut bus, _) = started(applied(plan, &bench));
        assert_eq!([source, 724].map(|source| bus.source(2, source)), [Some(arrives), Some(1_234)]);
        assert_eq!([125, 187].map(|param| bus.ram(2, param, 0)), [Some(source.into()), Some(724)]);
        let check = antrieb("--catalogue {dir}/c.toml --protocol sdo systembus check {dir}/bus.toml");
        let set = |node: u8, params: &[u32]| {
            let row = |param: &u32| format!("\"{param}\" = {}", bus.ram(node, *param, 0).unwrap());
            format!("set = {{ {} }}", params.iter().map(row).collect::<Vec<_>>().join(", "))
        };
        let same = nodes(&[(1, &set(1, &[934, 935, 929, 972, 975, 977])), (2, &set(2, &[928, 945, 125, 187]))]);
        check.on(&same).file("bus.toml", &counted(plan)).file("c.toml", FUNCTION_C).exits(0);
    }
}

/// The settings of a drive that a plan decides, as a bench has them.
fn settings(plan: &str, name: &str) -> String {
    let run = antrieb("systembus plan {dir}/bus.toml --settings").file("bus.toml", plan).json().exits(0);
    let drives = run.data("/drives").as_array().unwrap().clone();
    let drive = drives.iter().find(|drive| drive["name"] == name).unwrap();
    let rows = drive["settings"].as_array().unwrap().iter().filter(|row| row["raw"].is_number());
    let rows = rows.filter(|row| row["param"] != 923).map(|row| format!("\"{}\" = {}", row["param"], row["raw"]));
    rows.collect::<Vec<_>>().join(", ")
}

/// Example 1 of 5.11.5.3: a master drive, set over its serial plug, and one that follows it.
fn follows(more: &str) -> String {
    let master = format!("set = {{ {}, \"228\" = 10, \"412\" = 1 }}", settings(SETPOINT, "drive-1"));
    let event = "[[drive.event]]\nat = \"30s\"\nset = { \"410\" = 15 }\n";
    format!(
        "[readings]\nrx_functions = \"0-2\"\n{}",
        nodes(&[(0, &format!("{master}\n{event}{more}")), (1, "set = { \"412\" = 1, \"228\" = 0 }"), (9, "")])
    )
}

#[test]
fn example_1_of_5_11_5_3_turns_the_second_shaft_with_the_first() {
    let apply = "--protocol sdo --yes systembus apply {dir}/bus.toml drive-2";
    let silent = "[[drive.event]]\nat = \"60s\"\nsilent = \"10s\"";
    antrieb(apply).on(&follows(silent)).file("bus.toml", SETPOINT).exits(0);
    let mut bus = witness::left_can().unwrap();
    assert!(bus.remarks().is_empty() && bus.now() < Tick::ZERO + Span::from_secs(30));
    pass(&mut bus, 29_000);
    assert_eq!((bus.turning(), bus.source(1, 709)), ([0, 0], Some(1_000)), "the setpoint is there, the start is not");
    pass(&mut bus, 45_000);
    assert_eq!((bus.turning(), bus.ram(1, 283, 0), bus.ram(0, 283, 0)), ([2, 2], Some(1_000), Some(1_000)));
    // The master is gone: RxPDO1 is missed behind 40 ms.
    pass(&mut bus, 61_000);
    assert_eq!((bus.ram(1, 260, 0), bus.ram(0, 260, 0)), (Some(0x2201), Some(0)));
}

#[test]
fn a_bus_is_watched_in_the_words_of_its_plan_and_nothing_is_sent() {
    let silent = "[[drive.event]]\nat = \"20s\"\nsilent = \"10s\"";
    let slave = format!("set = {{ \"412\" = 1, \"228\" = 0, {} }}", settings(SETPOINT, "drive-2"));
    let bench = follows(silent).replace("set = { \"412\" = 1, \"228\" = 0 }", &slave);
    let typed = "--protocol sdo systembus monitor {dir}/bus.toml --duration 22s";
    let run = antrieb(typed).on(&bench).file("bus.toml", SETPOINT).json().exits(0);
    let bus = witness::left_can().unwrap();
    assert!(bus.remarks().is_empty() && bus.counts()[0] == 0, "{:?}", bus.remarks());
    let row = run.data("/heard").as_array().unwrap().iter().find(|row| row["identifier"] == 385).unwrap().clone();
    assert_eq!(
        (&row["name"], &row["every_ms"], &row["planned_ms"]),
        (&json!("drive-1 TxPDO1"), &json!(8.0), &json!(8))
    );
    let place = row["places"].as_array().unwrap().iter().find(|row| row["place"] == "long2").unwrap();
    assert_eq!(
        (&place["raw"], &place["source"], &place["takers"][0]["param"]),
        (&json!(1_000), &json!(62), &json!(137))
    );
    assert_eq!((&row["missing"], run.warnings()), (&json!(true), vec!["bus.missing"]));
    // What the drive made of it.
    let emergency = &run.data("/emergencies/0");
    assert_eq!(
        (&emergency["node"], &emergency["fault"], &emergency["cleared"]),
        (&json!(1), &json!(0x2201), &Value::Null)
    );
    let load = run.data("/load_percent").as_f64().unwrap();
    assert!((2.0..6.0).contains(&load), "{load}");

    let lines = antrieb(&format!("{typed} --format ndjson")).on(&bench).file("bus.toml", SETPOINT).exits(0).out;
    let records: Vec<Value> = lines.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let pdos = records.iter().filter(|row| row["type"] == "telegram" && row["identifier"] == 385).count();
    assert!(pdos > 1_500 && records.last().unwrap()["type"] == "end", "{pdos}");
    let page = antrieb(&format!("{typed} --lang de")).on(&bench).file("bus.toml", SETPOINT).exits(0).out;
    assert!(page.contains("drive-1 TxPDO1") && page.contains("F2201"), "{page}");
}

#[test]
fn a_watch_that_hears_nothing_says_why() {
    let run = antrieb("--protocol sdo systembus monitor --duration 2s").on(&nodes(&[(1, "")])).json().exits(4);
    assert_eq!(run.error()["code"], "silence.nothing_heard");
    let beat = format!("[[foreign]]\nframe = \"080#\"\nevery = \"10ms\"\n{}", nodes(&[(1, "")]));
    let run = antrieb("--protocol sdo -b 125000 systembus monitor --duration 2s").on(&beat).json().exits(5);
    assert_eq!(run.error()["code"], "garbled.bit_rate");
    assert!(witness::left_can().unwrap().remarks().is_empty());
    antrieb("-p sim systembus monitor").exits(2);
}

#[test]
fn an_acknowledged_emergency_is_cleared() {
    let event = "set = { \"412\" = 1 }\n[[drive.event]]\nat = \"2s\"\nfault = \"F0500\"\n[[drive.event]]\nat = \"18s\"\nset = { \"410\" = 128 }";
    let run =
        antrieb("--protocol sdo systembus monitor --duration 20s").on(&nodes(&[(5, event), (6, "")])).json().exits(0);
    assert_eq!(*run.data("/emergencies/0/fault"), json!(0x0500));
    assert!(run.data("/emergencies/0/cleared").as_f64().unwrap() >= 18.0);
}

/// Who only listens acknowledges nothing, so a drive that is alone says the same until somebody does: one piece of news, and why.
#[test]
fn what_nobody_acknowledges_is_told_once() {
    let bench = nodes(&[(5, "[[drive.event]]\nat = \"2s\"\nfault = \"F0500\"")]);
    let run = antrieb("--protocol sdo systembus monitor --duration 5s").on(&bench).json().exits(0);
    assert_eq!(run.data("/emergencies").as_array().unwrap().len(), 1);
    assert!(
        run.data("/heard/0/frames").as_u64().unwrap() > 10_000 && run.err.matches("again and again").count() == 1,
        "{}",
        run.err
    );
    let run = antrieb("--protocol sdo --lang de systembus monitor --duration 5s").on(&bench).exits(0);
    assert!(run.err.contains("bestätigt nichts") && run.out.lines().count() < 40, "{}", run.out);
    // It is found, and asked, all the same.
    antrieb("--protocol sdo -a 5 read 979 260").on(&bench).exits(0);
}

fn nmt(typed: &str, bench: &str) -> Run {
    antrieb(&format!("--protocol sdo systembus nmt {typed}")).on(bench)
}

#[test]
fn nodes_are_started_and_stopped_and_show_it() {
    let bench = nodes(&[(1, ""), (5, "")]);
    for (typed, proof, after) in [
        ("start --node 5 --yes", json!("state"), json!(2)),
        ("preop --node 5", json!("state"), json!(1)),
        ("stop --node 5", json!("silence"), Value::Null),
        ("reset --node 5 --yes", json!("boot_up"), json!(1)),
    ] {
        let run = nmt(typed, &bench).json().exits(0);
        assert_eq!((run.data("/nodes/0/proof"), run.data("/nodes/0/after")), (&proof, &after), "{typed}");
        let bus = witness::left_can().unwrap();
        assert_eq!((bus.orders().len(), bus.remarks().len(), bus.is_open()), (1, 0, false));
        let is_told = run.warnings().contains(&"bus.no_stop");
        assert_eq!(is_told, typed.starts_with("preop") || typed.starts_with("stop"));
    }
    // Nobody to look at: said, and not taken for done.
    assert_eq!(nmt("start --yes", &bench).json().exits(4).error()["code"], "silence.unproven");
    assert_eq!(witness::left_can().unwrap().ram(5, 978, 0), Some(2));
    assert_eq!(nmt("start --node 9 --yes", &bench).json().exits(4).error()["code"], "silence.unproven");
    let run = nmt("start --node 5 --dry-run", &bench).json().exits(0);
    assert_eq!(*run.data("/telegrams/0/hex"), json!("000#01 05"));
}

#[test]
fn what_can_turn_a_shaft_asks_and_a_network_of_somebody_else_is_left_alone() {
    let bench = nodes(&[(5, "")]);
    for typed in ["start", "reset"] {
        nmt(&format!("{typed} --node 5"), &bench).exits(8);
        assert!(witness::left_can().unwrap().orders().is_empty());
    }
    let run = nmt("start --node 5", &bench).answered("n").exits(8);
    assert!(run.err.contains("5 (acu)"), "{}", run.err);
    let master = format!("[[foreign]]\nframe = \"080#\"\nevery = \"10ms\"\n{bench}");
    let run = nmt("stop --node 5", &master).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.other_master");
    assert!(witness::left_can().unwrap().orders().is_empty());
    nmt("--force stop --node 5", &master).exits(0);
    assert_eq!(witness::left_can().unwrap().ram(5, 978, 0), Some(3));
}
