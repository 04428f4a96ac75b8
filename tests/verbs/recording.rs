//! `monitor --record`: what is kept of a watch, and what triggers it; on the bench in virtual time.

use crate::run::{Output, antrieb};
use serde_json::{Value, json};

/// Starts at 2 s by its ramp of 5 Hz/s to 25 Hz, and trips at 9 s.
pub(crate) const TRIPS: &str = "[[drive]]\nmodel = \"act\"\nenable = false\nset = { \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 25, \"418\" = 0 }\n\
    [[drive.event]]\nat = \"2s\"\nenable = true\n[[drive.event]]\nat = \"9s\"\nfault = \"F0500\"\n";

#[track_caller]
fn records(text: &str) -> Vec<Value> {
    text.lines().map(|line| serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"))).collect()
}

fn of_type<'r>(records: &'r [Value], kind: &str) -> Vec<&'r Value> {
    records.iter().filter(|record| record["type"] == kind).collect()
}

fn seconds(record: &Value) -> f64 {
    record["t"].as_f64().unwrap()
}

fn value(sample: &Value, slug: &str) -> f64 {
    let values = sample["values"].as_array().unwrap();
    values.iter().find(|value| value["slug"] == slug).unwrap()["value"].as_f64().unwrap()
}

#[track_caller]
fn tripped(options: &str) -> Output {
    tripped_on(TRIPS, options)
}

#[track_caller]
fn tripped_on(bench: &str, options: &str) -> Output {
    let line = "-a 1 monitor --interval 0 --duration 20s --unpaced --json --record {dir}/trip.ndjson";
    antrieb(&format!("{line} {options}")).on(bench).exits(0)
}

#[test]
fn a_triggered_record_of_a_trip_holds_the_two_seconds_before_it() {
    let run = tripped("--trigger 'state -> fault' --once");
    let records = records(&run.text_of("trip.ndjson"));
    let validator = jsonschema::validator_for(&serde_json::from_str(&antrieb("schema monitor").exits(0).out).unwrap());
    let validator = validator.unwrap();
    assert!(records.iter().all(|record| validator.is_valid(record)), "{records:#?}");
    assert_eq!((&records[0]["type"], &records.last().unwrap()["type"]), (&json!("start"), &json!("end")));
    assert_eq!(records[0]["waits"], json!({"triggers": ["state -> fault"], "pre": 2.0, "post": 5.0, "once": true}));
    let at = seconds(of_type(&records, "trigger")[0]);
    assert!((9.0..9.3).contains(&at), "{at}");
    let samples = of_type(&records, "sample");
    let (first, last) = (seconds(samples[0]), seconds(samples.last().unwrap()));
    // From the last round that began two seconds before it, to five seconds behind.
    let step = seconds(samples[1]) - first;
    assert!((at - 2.0 - step..=at - 2.0).contains(&first), "{first} before {at}");
    assert!((at + 5.0 - step..=at + 5.0).contains(&last), "{last} behind {at}");
    // No round is left out, and every value has its own time.
    let numbers: Vec<_> = samples.iter().map(|sample| sample["n"].as_u64().unwrap()).collect();
    assert!(numbers.windows(2).all(|pair| pair[1] == pair[0] + 1), "{numbers:?}");
    for sample in &samples {
        let times: Vec<_> = sample["values"].as_array().unwrap().iter().map(seconds).collect();
        assert!(times.windows(2).all(|pair| pair[0] < pair[1]) && times[0] > seconds(sample), "{times:?}");
        // The round in which it trips has seen the drive running, and stopped.
        let (t, turns) = (seconds(sample), value(sample, "stator-frequency") > 24.0);
        assert!((t >= at || turns || t > at - 2.0 * step) && !(t > at && turns), "{sample:#}");
    }
    assert_eq!(records.last().unwrap()["summary"]["because"], "trigger");
    // What was printed went on as ever: from the start.
    assert_eq!(self::records(&run.out)[1]["t"], 0.0);
    assert!(run.err.contains("trigger at 9."), "{}", run.err);
}

/// Once a second: the trigger comes with the first sample of the fault, and two whole seconds lie before it.
#[test]
fn the_time_before_a_trigger_is_covered_however_seldom_it_is_looked() {
    for (interval, least) in [("1s", 2), ("3s", 1), ("700ms", 3)] {
        let line =
            format!("-a 1 monitor --interval {interval} --duration 20s --unpaced --json --record {{dir}}/trip.ndjson");
        let run = antrieb(&format!("{line} --trigger 'state -> fault' --once --pre 2s")).on(TRIPS).exits(0);
        let records = records(&run.text_of("trip.ndjson"));
        let trip = seconds(of_type(&records, "trip")[0]);
        let at = seconds(of_type(&records, "trigger")[0]);
        assert_eq!(trip, at, "{interval}: the trigger comes with the trip");
        let before = of_type(&records, "sample").into_iter().filter(|sample| seconds(sample) < at).collect::<Vec<_>>();
        assert!(before.len() >= least && seconds(before[0]) <= at - 2.0, "{interval}: {before:#?}");
        assert!(before[1..].iter().all(|sample| seconds(sample) > at - 2.0), "{interval}: no more than is needed");
    }
    let none =
        antrieb("-a 1 monitor 210 --interval 100ms --duration 24s --unpaced --json --record {dir}/x.ndjson --pre 0s")
            .and("--trigger 'state -> fault'")
            .on(TRIPS)
            .exits(0);
    let records = records(&none.text_of("x.ndjson"));
    assert_eq!(seconds(of_type(&records, "sample")[0]), seconds(of_type(&records, "trigger")[0]));
}

/// Nobody watches what ails it: it is asked for that once, at the trip.
#[test]
fn the_fault_is_read_at_the_trip_where_nobody_watches_it() {
    let line = "-a 1 monitor 283 210 411 --interval 100ms --duration 12s --unpaced --json -v";
    let run = antrieb(line).on(TRIPS).exits(0);
    let records = records(&run.out);
    assert_eq!(of_type(&records, "trip")[0]["fault"]["key"], "F0500", "{}", run.out);
    assert_eq!(run.sent().iter().filter(|sent| sent.starts_with("01 03 01 04")).count(), 1, "P.260 is asked once");
    let servo = "[[drive]]\nmodel = \"lxm05\"\naddress = 3\n[[drive.event]]\nat = \"4s\"\nfault = \"E2300\"\n";
    let run = antrieb("-a 3 monitor --interval 100ms --duration 6s --unpaced --json -v").on(servo).exits(0);
    let records = self::records(&run.out);
    assert_eq!(of_type(&records, "trip")[0]["fault"]["key"], "E2300", "{}", run.out);
    let columns = records[0]["drives"][0]["columns"].as_array().unwrap();
    let slugs: Vec<_> = columns.iter().filter_map(|column| column["slug"].as_str()).collect();
    assert_eq!(slugs, ["status-word", "active-mode", "profile-velocity", "actual-position"]);
}

/// The manual's worked example (LXM05 manual 5.3): what lies next to each other is one question.
#[test]
fn neighbours_of_a_servo_drive_are_watched_in_one_telegram() {
    let servo = "[[drive]]\nmodel = \"lxm05\"\naddress = 3\n";
    let line = "-a 3 --drive lxm05 monitor 15366 15362 15364 6916 --count 10 --interval 0 --unpaced --json -v";
    let run = antrieb(line).on(servo).exits(0);
    let count = |start: &str| run.sent().iter().filter(|sent| sent.starts_with(start)).count();
    assert_eq!((count("03 03 3C 02 00 06"), count("03 03 3C 02 00 02"), count("03 03 3C 04")), (10, 0, 0));
    let samples = records(&run.out);
    for sample in of_type(&samples, "sample") {
        assert!(sample["values"].as_array().unwrap().iter().all(|value| value["raw"].is_i64()), "{sample:#}");
    }
    // Who refuses them together is asked for each, and not again for all.
    let own = "schema = 1\nfamily = \"lexium05\"\nparams = [{ id = 15370, slug = \"more\", en = \"more\", de = \"mehr\", type = \"long\", \
               decimals = 0, access = \"r\" }]\n";
    let line = line.replace("15366 15362 15364 6916", "15368 15370") + " --catalogue {dir}/own.toml";
    let run = antrieb(&line).on(servo).file("own.toml", own).exits(9);
    let count = |start: &str| run.sent().iter().filter(|sent| sent.starts_with(start)).count();
    assert_eq!((count("03 03 3C 08 00 04"), count("03 03 3C 08 00 02")), (1, 10), "{:?}", run.sent());
}

/// Two families that call different parameters the same: no heading stands for two columns.
#[test]
fn no_two_columns_have_one_heading() {
    let both = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive]]\nmodel = \"lxm05\"\naddress = 3\n";
    for addresses in ["1,3", "1,3,9"] {
        let line =
            format!("-a {addresses} monitor --count 3 --interval 100ms --unpaced --format csv --record {{dir}}/r.csv");
        let run = antrieb(&line).on(both).run();
        let text = run.text_of("r.csv");
        let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
        let mut once = head.clone();
        once.sort_unstable();
        once.dedup();
        assert_eq!(once.len(), head.len(), "{head:?}");
        assert!(head.contains(&"status-word.411") && head.contains(&"status-word.6916_bits"), "{head:?}");
        run.then("plot {dir}/r.csv -a 1").exits(0);
    }
}

/// A short name means what a family is known to have, and never whatever else begins with it.
#[test]
fn a_short_name_that_a_family_lacks_is_refused() {
    for (drive, name, there) in [("act", "voltage", "current"), ("lxm05", "current", "setpoint, actual")] {
        let line = format!("-p sim -a 1 --drive {drive} monitor --count 2 --unpaced --trigger '{name} > 5'");
        let run = antrieb(&line).exits(7);
        assert!(run.err.contains(&format!("is '{name}' (there is: ")) && run.err.contains(there), "{}", run.err);
    }
    let state = antrieb("-p sim -a 1 monitor --count 2 --unpaced --trigger 'state = fault'").exits(2);
    assert!(state.err.contains("'state -> fault'") && !state.err.contains("P.392"), "{}", state.err);
}

/// A name is that of the drive that answers, and no other family refuses it before anybody has asked.
#[test]
fn the_fault_of_a_servo_drive_triggers_by_its_name_without_its_family_being_named() {
    let bench = "[[drive]]\nmodel = \"lxm05\"\naddress = 3\n[[drive.event]]\nat = \"4s\"\nfault = \"E2300\"\n";
    for drive in ["", "--drive lxm05"] {
        let line = format!("-a 3 {drive} monitor --count 8 --unpaced --json --trigger 'fault = E2300'");
        let run = antrieb(&line).on(bench).exits(0);
        assert_eq!(of_type(&records(&run.out), "trigger").len(), 1, "{}", run.out);
    }
    // That of an ACTIVE is none of this drive, which says so itself.
    let other = antrieb("-a 3 monitor --count 2 --unpaced --trigger 'fault = F0500'").on(bench).run();
    assert!(other.err.contains("FLT_err_num"), "{}", other.err);
    let nobody = antrieb("-a 3 monitor --count 2 --unpaced --trigger 'fault = X1'").on(bench).exits(2);
    assert!(nobody.err.contains("'X1'"), "{}", nobody.err);
}

#[test]
fn a_fault_comes_with_what_was_seen_last_before_it() {
    let mut told = 0;
    for ms in (9_000..9_120).step_by(30) {
        let run = tripped_on(&TRIPS.replace("9s", &format!("{ms}ms")), "");
        let records = records(&run.text_of("trip.ndjson"));
        assert_eq!(run.text_of("trip.ndjson"), run.out, "without a trigger everything is kept");
        let [trip] = of_type(&records, "trip")[..] else { panic!("{}", run.out) };
        assert_eq!(trip["fault"]["key"], "F0500");
        assert_eq!(trip["before"]["state"]["slug"], "operation-enabled");
        let last = of_type(&records, "sample").into_iter().rfind(|sample| seconds(sample) < seconds(trip)).unwrap();
        assert_eq!(trip["before"]["values"], last["values"]);
        let seen = "F0500 Output current overload; seen last before it: Operation enabled, ";
        assert!(run.err.contains(seen), "{}", run.err);
        // In the midst of a sample it finds the state as it was before, and no current any more.
        told += usize::from(
            value(&trip["before"], "stator-frequency") > 24.0 && value(&trip["before"], "rms-current") > 0.0,
        );
    }
    assert!(told > 0);
}

/// No manual that we have names the number of the DC-link voltage; who knows it brings it along, and sees it before a trip.
#[test]
fn a_catalogue_of_ones_own_brings_the_voltage_of_the_dc_link_before_a_trip() {
    let own = "schema = 1\nfamily = \"active\"\nparams = [{ id = 222, slug = \"dc-link\", en = \"DC link\", de = \"Zwischenkreis\", \
               type = \"uint\", decimals = 1, unit = \"V\", access = \"r\" }]\n[roles]\ndc-link-voltage = 222\n";
    let bench = TRIPS.replace("\"418\" = 0 }", "\"418\" = 0, \"222\" = 565 }");
    let line = "-a 1 --catalogue {dir}/own.toml monitor --interval 100ms --duration 12s --unpaced --json";
    let run = antrieb(line).and("--trigger 'voltage > 500V'").on(&bench).file("own.toml", own).exits(0);
    let records = records(&run.out);
    let [trip] = of_type(&records, "trip")[..] else { panic!("{}", run.out) };
    assert_eq!(value(&trip["before"], "dc-link"), 565.0);
    assert!(!of_type(&records, "trigger").is_empty() && run.err.contains("565.0 V"), "{}", run.err);
}

#[test]
fn a_value_triggers_where_it_passes_its_level_and_repeatedly() {
    let bench = "[[drive]]\nmodel = \"act\"\nenable = false\nset = { \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 25, \"418\" = 0 }\n\
        [[drive.event]]\nat = \"2s\"\nenable = true\nfor = \"4s\"\n[[drive.event]]\nat = \"16s\"\nenable = true\nfor = \"4s\"\n";
    let line = "-a 1 monitor 210 --interval 100ms --duration 24s --unpaced --format csv --record {dir}/runs.csv \
        --pre 500ms --post 1s";
    let run = antrieb(&format!("{line} --trigger 'frequency rising 10Hz'")).on(bench).exits(0);
    let text = run.text_of("runs.csv");
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    assert_eq!(reader.headers().unwrap().iter().next_back(), Some("trigger"));
    let rows: Vec<_> = reader.records().map(Result::unwrap).collect();
    let triggered: Vec<_> = rows.iter().filter(|row| row.iter().next_back() == Some("frequency rising 10Hz")).collect();
    assert_eq!(triggered.len(), 2, "{text}");
    for row in &triggered {
        let frequency: f64 = row[5].parse().unwrap();
        assert!((10.0..11.0).contains(&frequency), "{row:?}");
    }
    assert_eq!(rows.len(), 2 * (5 + 1 + 10), "half a second before, and one behind: {text}");
    // A level that is passed already when the watch begins counts as well; an edge has to be seen.
    let at_once = |trigger: &str| {
        let line = format!("-p sim -a 1 monitor 210 --count 3 --unpaced --json --trigger '{trigger}'");
        of_type(&records(&antrieb(&line).exits(0).out), "trigger").len()
    };
    assert_eq!((at_once("frequency < 10Hz"), at_once("frequency falling 10Hz"), at_once("state -> fault")), (1, 0, 0));
}

/// An empty file says nothing of why it is empty.
#[test]
fn a_trigger_that_never_came_true_is_told_with_its_empty_record() {
    let line = "-p sim -a 1 monitor 210 --count 3 --unpaced --json --record {dir}/none.csv --trigger 'current > 90A'";
    let run = antrieb(line).exits(0);
    assert_eq!(run.text_of("none.csv").lines().count(), 1);
    assert!(
        run.err.contains("no trigger came true, so ") && run.err.contains("none.csv holds no sample"),
        "{}",
        run.err
    );
    assert_eq!(records(&run.out).pop().unwrap()["warnings"][0]["code"], "monitor.no_trigger");
    let met = antrieb(line).and("--trigger 'frequency < 10Hz'").exits(0);
    assert!(!met.err.contains("no trigger came true"), "{}", met.err);
}

#[test]
fn what_a_trigger_looks_at_is_watched_and_nothing_twice() {
    let slugs = |line: &str| -> Vec<String> {
        let out = antrieb(&format!("-p sim -a 1 monitor {line} --count 1 --unpaced --json")).exits(0).out;
        let columns = records(&out)[0]["drives"][0]["columns"].as_array().unwrap().clone();
        columns.iter().map(|column| column["slug"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(slugs("210 --trigger 'current > 12A'"), ["stator-frequency", "rms-current"]);
    assert_eq!(slugs("211 --trigger 'current > 12A'"), ["rms-current"]);
    assert_eq!(slugs("210 --trigger 'state -> fault'"), ["stator-frequency", "status-word"]);
}

#[test]
fn a_trigger_has_a_name_in_the_project_file() {
    let project = "[triggers.trip]\nwhen = \"state -> fault\"\npre = \"1s\"\npost = \"2s\"\nonce = true\nwatch = [\"210\", \"211\"]\n";
    let line = "-a 1 monitor --interval 0 --unpaced --json --record {dir}/trip.csv --trigger trip";
    let run = antrieb(line).on(TRIPS).file("antrieb.toml", project).exits(0);
    let start = &records(&run.out)[0];
    assert_eq!(start["waits"], json!({"triggers": ["state -> fault"], "pre": 1.0, "post": 2.0, "once": true}));
    assert!(run.text_of("trip.csv").starts_with(
        "t,n,address,drive,state,stator-frequency,rms-current,status-word,status-word_bits,error,trigger\n"
    ));
    // What is typed goes before it.
    let typed = antrieb(line).and("411 --pre 3s").on(TRIPS).file("antrieb.toml", project).exits(0);
    assert_eq!(records(&typed.out)[0]["waits"]["pre"], 3.0);
    let unknown = antrieb("-p sim monitor --trigger tripp").file("antrieb.toml", project).exits(2);
    assert!(unknown.err.contains("there is no trigger 'tripp' (`[triggers]` has: trip)"), "{}", unknown.err);
    let none = antrieb("-a 1 monitor --trigger tripp --duration 1s").on(TRIPS).exits(2);
    assert!(none.err.contains("'tripp', and no `[triggers]` in antrieb.toml"), "{}", none.err);
    let wrong = project.replace("\"1s\"", "\"soon\"");
    let wrong = antrieb("-p sim monitor --trigger trip").file("antrieb.toml", &wrong).exits(7);
    assert!(wrong.err.contains("triggers.trip: "), "{}", wrong.err);
}

#[test]
fn what_one_of_several_triggers_wants_ends_no_watch() {
    let project =
        "[triggers.trip]\nwhen = \"state -> fault\"\nonce = true\n[triggers.runs]\nwhen = \"frequency > 1Hz\"\n";
    let line =
        "-a 1 monitor --interval 0 --unpaced --json --record {dir}/t.ndjson --duration 20s --trigger runs --trigger";
    for (more, once) in [("trip", false), ("trip --once", true)] {
        let run = antrieb(&format!("{line} {more}")).on(TRIPS).file("antrieb.toml", project).exits(0);
        let records = records(&run.out);
        assert_eq!(records[0]["waits"]["once"], once, "{more}");
        let trips = records.iter().any(|record| record["type"] == "trigger" && record["trigger"] == "state -> fault");
        assert_eq!(trips, !once, "{more}: {}", run.out);
    }
}

#[test]
fn nobody_elses_file_is_replaced() {
    let line = "-p sim -a 1 monitor 210 --count 2 --unpaced --json --record {dir}/old.ndjson";
    let refused = antrieb(line).file("old.ndjson", "precious\n").exits(7);
    assert_eq!(refused.text_of("old.ndjson"), "precious\n");
    assert!(refused.err.contains("--force replaces it") && refused.out.lines().count() == 1, "{}", refused.err);
    let replaced = antrieb(line).and("--force").file("old.ndjson", "precious\n").exits(0);
    assert_eq!(replaced.text_of("old.ndjson"), replaced.out);
    antrieb("-p sim -a 1 monitor 210 --count 2 --unpaced --record {dir}").exits(7);
    antrieb("-p sim -a 1 monitor 210 --count 2 --unpaced --record {dir}/none/where.csv").exits(7);
    let dry = antrieb("-p sim -a 1 monitor 210 --dry-run --record {dir}/dry.csv").exits(0);
    assert!(!dry.directory().join("dry.csv").exists());
}

#[test]
fn what_is_no_trigger_is_refused_before_the_port_is_opened() {
    for (trigger, exit) in
        [("current >", 2), ("current > 12Hz", 2), ("state -> asleep", 2), ("frobnicate > 3", 7), ("480-483 > 3", 2)]
    {
        antrieb(&format!("-p /dev/antrieb-has-no-such-port monitor --trigger '{trigger}'")).exits(exit);
    }
    antrieb("-p sim monitor --pre 2s").exits(2);
}
