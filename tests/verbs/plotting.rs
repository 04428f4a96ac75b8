//! `plot`: what was recorded on the bench as a picture and as numbers.

use crate::recording::TRIPS;
use crate::run::antrieb;
use serde_json::{Value, json};

const RECORD: &str = include_str!("../../docs/examples/record.csv");
/// Enabled twice for 4 s, on its way up by 5 Hz/s.
const TWICE: &str = "[[drive]]\nmodel = \"act\"\nenable = false\nset = { \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 25, \"418\" = 0 }\n\
    [[drive.event]]\nat = \"2s\"\nenable = true\nfor = \"4s\"\n[[drive.event]]\nat = \"16s\"\nenable = true\nfor = \"4s\"\n";

/// The bench's motor follows straight ramps of 5 Hz/s: no overshoot, and within 2 % of 25 Hz after 4.9 s.
#[test]
fn what_is_measured_of_the_benchs_motor_is_what_its_formula_tells() {
    for (file, interval) in [("run.ndjson", "0"), ("run.csv", "200ms")] {
        let line =
            format!("-a 1 monitor 283 210 --interval {interval} --duration 8.9s --unpaced --record {{dir}}/{file}");
        let run = antrieb(&line).on(TRIPS).exits(0);
        let plot = run.then(&format!("plot {{dir}}/{file} --measure")).json().exits(0);
        let [told] = &plot.data("/responses").as_array().unwrap()[..] else { panic!("{:#}", plot.value) };
        let near = |field: &str, formula: f64, by: f64| {
            let measured = told[field].as_f64().unwrap_or_else(|| panic!("{field}: {told:#}"));
            assert!((measured - formula).abs() <= by, "{file}, {field}: {measured}, not {formula} within {by}");
        };
        let step = 0.21;
        near("t", 2.0, step);
        near("settling_s", 4.9, step);
        near("overshoot_percent", 0.0, 0.0);
        near("slope", 5.0, 0.1);
        near("dead_time_s", 0.0, step);
        near("end", 25.0, 0.01);
        assert_eq!(plot.data("/curves/0/part"), "setpoint");
        assert_eq!(plot.data("/curves/1/part"), "actual");
        assert_eq!(plot.data("/curves/1/max"), 25.0);
    }
}

#[test]
fn between_markers_a_curve_comes_to_what_its_lines_come_to() {
    let plot = |options: &str| {
        let line = format!("plot {{dir}}/record.csv stator-frequency --measure {options}");
        antrieb(&line).file("record.csv", RECORD).json().exits(0)
    };
    // A straight line from 0 to 25 Hz in 5 s.
    let ramp = plot("--from 2s --to 7s");
    let [min, max, mean, rms] =
        ["min", "max", "mean", "rms"].map(|field| ramp.data(&format!("/curves/0/{field}")).as_f64());
    assert_eq!((min, max, mean), (Some(0.0), Some(25.0), Some(12.5)));
    assert!((rms.unwrap() - 25.0 / 3f64.sqrt()).abs() < 1e-6, "{rms:?}");
    assert_eq!(plot("--from 8s --to 10s").data("/curves/0/rms"), 25.0);
    antrieb("plot {dir}/record.csv --from 40s").file("record.csv", RECORD).exits(2);
    let unmeasured = antrieb("plot {dir}/record.csv").file("record.csv", RECORD).json().exits(0);
    assert_eq!((unmeasured.data("/curves/0/min"), unmeasured.data("/responses")), (&Value::Null, &Value::Null));
}

#[test]
fn a_picture_shows_curves_states_faults_gaps_and_triggers_in_both_languages() {
    for (lang, words) in [
        ("en", ["time [s]", "gap", "Operation enabled", "Stator frequency (left)", "[Hz]", "[A]", "fault"]),
        ("de", ["Zeit [s]", "Lücke", "Betrieb freigegeben", "Ständerfrequenz (links)", "[Hz]", "[A]", "Störung"]),
    ] {
        let run = antrieb(&format!("--lang {lang} plot {{dir}}/record.csv --svg {{dir}}/ramp.svg"))
            .file("record.csv", RECORD);
        let svg = run.exits(0).text_of("ramp.svg");
        for word in words {
            assert!(svg.contains(&format!(">{word}<")), "{word} in {svg}");
        }
        assert!(svg.contains(">411 &gt; 8<"), "{svg}");
        let is_well_formed = svg.starts_with("<svg xmlns=") && svg.ends_with("</svg>\n");
        assert!(is_well_formed && svg.matches("<path").count() > 10, "{svg}");
        // Black, white and grey only, and nothing from elsewhere.
        let colours = svg.match_indices("=\"#").filter_map(|(at, _)| svg[at + 3..].split('"').next());
        assert!(colours.into_iter().all(|colour| colour.bytes().all(|byte| byte == colour.as_bytes()[0])), "{svg}");
        assert_eq!(svg.matches("http").count(), 1, "{svg}");
        // The setpoint is dashed, the actual value whole, the current dotted; the gap parts each curve in two.
        assert_eq!(svg.matches("stroke-dasharray=\"9 5\"").count(), 1 + 2, "{svg}");
        assert_eq!(svg.matches("stroke-dasharray=\"1.5 4\"").count(), 1 + 2, "{svg}");
    }
}

#[test]
fn the_record_of_a_trip_says_what_it_was() {
    let record = "-a 1 monitor --interval 0 --duration 20s --unpaced --record {dir}/trip.ndjson --trigger 'state -> fault' --once";
    let run = antrieb(record).on(TRIPS).exits(0).then("plot {dir}/trip.ndjson --lang de").json().exits(0);
    let marks = run.data("/marks");
    assert_eq!(marks[0]["kind"], "fault");
    assert!(marks[0]["text"].as_str().unwrap().starts_with("F0500 "), "{marks}");
    assert_eq!((&marks[1]["kind"], &marks[1]["text"]), (&json!("trigger"), &json!("state -> fault")));
    let columns: Vec<_> = run.data("/curves").as_array().unwrap().iter().map(|curve| curve["axis"].clone()).collect();
    assert_eq!(columns, ["left", "left", "right"]);
}

/// Of a record with two pieces nobody knows what lay between them: no line, no mean and no response goes over it.
#[test]
fn between_the_pieces_of_a_record_nothing_is_drawn_or_measured() {
    let mut measured = Vec::new();
    for file in ["pieces.ndjson", "pieces.csv"] {
        let line = "-a 1 monitor --interval 100ms --duration 24s --unpaced --pre 1s --post 1s --trigger 'frequency rising 10Hz'";
        let run = antrieb(&format!("{line} --record {{dir}}/{file}")).on(TWICE).exits(0);
        let drawn = run.then(&format!("plot {{dir}}/{file} --svg {{dir}}/x.svg")).exits(0);
        let svg = drawn.text_of("x.svg");
        // The setpoint is dashed: once in the legend, and once for each piece.
        assert_eq!(
            (svg.matches(">gap<").count(), svg.matches("stroke-dasharray=\"9 5\"").count()),
            (1, 1 + 2),
            "{file}"
        );
        let plot = drawn.then(&format!("plot {{dir}}/{file} --measure")).json().exits(0);
        let gaps = plot.data("/gaps").as_array().unwrap();
        let [gap] = &gaps[..] else { panic!("{file}: {gaps:#?}") };
        let (from, to) = (gap["from"].as_f64().unwrap(), gap["to"].as_f64().unwrap());
        assert!((4.9..5.3).contains(&from) && (16.9..17.3).contains(&to), "{file}: {gap}");
        // Seen on its way up twice, never down from one piece to the next.
        let told = plot.data("/responses").as_array().unwrap();
        let falls = |told: &&Value| told["end"].as_f64() < told["start"].as_f64();
        assert!(!told.iter().any(|told| falls(&told)), "{file}: {told:#?}");
        measured.push(ways(told));
    }
    // A table has one time for a row, a record one for each value: the last row of a piece counts in both.
    assert_eq!(measured[0], measured[1]);
}

/// From where to where each response goes, in setpoint and actual value.
fn ways(told: &[serde_json::Value]) -> Vec<[String; 4]> {
    told.iter().map(|told| ["from", "to", "start", "end"].map(|key| told[key].to_string())).collect()
}

/// A shaft that lost its power by a trip, or because somebody took its enable, followed no setpoint.
#[test]
fn a_trip_and_a_coast_are_no_responses() {
    for (bench, kinds) in [(TRIPS, 1), (TWICE, 0)] {
        let mut measured = Vec::new();
        for file in ["run.ndjson", "run.csv"] {
            let line = "-a 1 monitor --interval 100ms --duration 14s --unpaced --record {dir}";
            let run = antrieb(&format!("{line}/{file}")).on(bench).exits(0);
            let plot = run.then(&format!("plot {{dir}}/{file} --measure")).json().exits(0);
            let told = plot.data("/responses").as_array().unwrap();
            assert!(told.len() == 1 && told[0]["end"].as_f64() > Some(10.0), "{file}: {told:#?}");
            let marks = plot.data("/marks").as_array().unwrap();
            assert_eq!(marks.iter().filter(|mark| mark["kind"] == "fault").count(), kinds, "{file}: {marks:#?}");
            measured.push(ways(told));
        }
        assert_eq!(measured[0], measured[1]);
    }
}

/// The state of a round may be read before the enable that its setpoint shows already, or its actual value.
#[test]
fn a_step_that_comes_with_the_enable_is_measured_whenever_its_state_was_read() {
    for at in ["2.08s", "2.1s", "2.12s", "2.14s"] {
        let bench = format!(
            "[[drive]]\nmodel = \"act\"\nenable = false\nramps = {{ up_right = 5000, down_right = 5000, up_left = 5, down_left = 5 }}\n\
             set = {{ \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 25, \"418\" = 0 }}\n\
             [[drive.event]]\nat = \"{at}\"\nenable = true\n"
        );
        for file in ["x.ndjson", "x.csv"] {
            let line = format!("-a 1 monitor --interval 100ms --duration 5s --unpaced --record {{dir}}/{file}");
            let plot = antrieb(&line).on(&bench).exits(0).then(&format!("plot {{dir}}/{file} --measure"));
            let plot = plot.json().exits(0);
            let [told] = &plot.data("/responses").as_array().unwrap()[..] else {
                panic!("{at} {file}: {:#}", plot.value)
            };
            // One time holds for a whole row of CSV, in which the actual value may have been read behind the enable already.
            if (at, file) == ("2.14s", "x.csv") {
                continue;
            }
            assert_eq!(
                (&told["start"], &told["end"], &told["to"]),
                (&json!(0.0), &json!(25.0), &json!(25.0)),
                "{at} {file}"
            );
            assert!(told["settling_s"].is_f64() && told["overshoot_percent"].is_f64(), "{at} {file}: {told:#}");
            assert_eq!(plot.data("/notes"), &json!([]), "{at} {file}");
        }
    }
    // A setpoint that stood long before: that it is not measured is said.
    let row = |t: usize| {
        let (state, actual) = if t < 20 { ("switched-on", 0) } else { ("operation-enabled", 5 * (t - 20)) };
        format!("{:.1},{t},1,act,{state},25.00,{actual}.00,\n", t as f64 / 10.0)
    };
    let head = "t,n,address,drive,state,ramp-reference-frequency,stator-frequency,error\n".to_owned();
    let record = head + &(0..30).map(row).collect::<String>();
    for (lang, words) in
        [("en", "with a setpoint of 25 Hz that stood already"), ("de", "ein Sollwert von 25 Hz stand schon an")]
    {
        let line = format!("--lang {lang} plot {{dir}}/x.csv --measure");
        let told = antrieb(&line).file("x.csv", &record).exits(0);
        assert!(told.out.contains(words), "{}", told.out);
        assert!(!antrieb(&line.replace(" --measure", "")).file("x.csv", &record).exits(0).out.contains(words));
    }
}

/// A table has no record of a trip; what its fault was stands in its rows, perhaps in a later one.
#[test]
fn a_fault_in_a_table_is_marked_with_its_code() {
    let record = |cells: [&str; 4]| {
        let states = ["operation-enabled", "fault", "fault", "fault"];
        let rows = (0..4).map(|n| format!("{n}.0,{n},1,act,{},1.00,{},\n", states[n], cells[n])).collect::<String>();
        "t,n,address,drive,state,stator-frequency,current-fault,error\n".to_owned() + &rows
    };
    for (cells, text) in
        [(["0", "0x0500", "0x0500", ""], "F0500 "), (["0", "0", "1280", "1280"], "F0500 "), (["", "", "", ""], "fault")]
    {
        let plot = antrieb("plot {dir}/x.csv").file("x.csv", &record(cells)).json().exits(0);
        assert!(plot.data("/marks/0/text").as_str().unwrap().starts_with(text), "{:#}", plot.value);
    }
}

/// What is drawn is SVG, and no name makes anything else of it.
#[test]
fn a_name_that_promises_another_form_of_picture_is_refused() {
    for name in ["x.png", "x.PDF"] {
        let told =
            antrieb(&format!("plot {{dir}}/record.csv --svg {{dir}}/{name}")).file("record.csv", RECORD).exits(2);
        assert!(told.err.contains("ends with .svg") && !told.directory().join(name).exists(), "{}", told.err);
    }
    antrieb("plot {dir}/record.csv --svg {dir}/x").file("record.csv", RECORD).exits(0);
}

/// Where its status word was not asked, nobody can tell a coast from a setpoint of 0, and that is said; each way ends where its own
/// setpoint was seen last.
#[test]
fn without_a_state_it_is_said_that_what_follows_may_be_a_stop() {
    for interval in ["0", "100ms"] {
        let line =
            format!("-a 1 monitor 283 210 --interval {interval} --duration 12s --unpaced --record {{dir}}/x.ndjson");
        let plot = antrieb(&line).on(TWICE).exits(0).then("plot {dir}/x.ndjson --measure").json().exits(0);
        let up = plot.data("/responses/0");
        assert!(up["end"].as_f64() > Some(19.0) && up["slope"].is_f64(), "{interval}: {up:#}");
        let told = plot.data("/notes").to_string();
        assert!(told.contains("holds no state of the drive"), "{interval}: {told}");
    }
    let line = "-a 1 monitor 411 283 210 --interval 100ms --duration 12s --unpaced --record {dir}/x.ndjson";
    let plot = antrieb(line).on(TWICE).exits(0).then("plot {dir}/x.ndjson --measure").json().exits(0);
    assert_eq!(plot.data("/notes"), &json!([]));
}

/// The port is exclusive, so a run is recorded by itself. Its stop ends what is measured; the motor of the bench runs up with 5 Hz/s.
#[test]
fn a_run_that_recorded_itself_is_measured_until_its_stop() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 2\nset = { \"412\" = 1, \"434\" = 2 }\n";
    let line = "-a 2 sollwert 15Hz --enable --hold --duration 6s --yes --format ndjson";
    let run = antrieb(line).on(bench).exits(0);
    let plot = antrieb("plot {dir}/run.ndjson --measure").file("run.ndjson", &run.out).json().exits(0);
    let stop = &plot.data("/marks/0");
    assert_eq!((&stop["kind"], &stop["text"]), (&json!("stop"), &json!("stop: ramp")));
    let [told] = &plot.data("/responses").as_array().unwrap()[..] else { panic!("{:#}", plot.value) };
    assert_eq!((&told["to"], &told["end"]), (&json!(15.0), &json!(15.0)), "{told:#}");
    let slope = told["slope"].as_f64().unwrap();
    assert!((slope - 5.0).abs() < 0.1 && told["settling_s"].is_f64() && told["dead_time_s"].is_f64(), "{told:#}");
    let drawn = antrieb("--lang de plot {dir}/run.ndjson").file("run.ndjson", &run.out).exits(0).out;
    assert!(drawn.contains("■ Halt"), "{drawn}");
    // A fault that ends a held run is marked, though no record of its own tells it.
    let state = |slug: &str, t: f64| {
        format!(
            "{{\"type\":\"sample\",\"t\":{t},\"address\":2,\"drive\":\"acu\",\"state\":{{\"slug\":\"{slug}\"}},\"values\":[{{\"t\":{t},\"param\":210,\
             \"slug\":\"stator-frequency\",\"data_set\":0,\"unit\":\"Hz\",\"value\":{t}}}]}}\n"
        )
    };
    let record = [("operation-enabled", 1.0), ("fault", 2.0), ("fault", 3.0)].map(|(slug, t)| state(slug, t)).concat();
    let tripped = antrieb("plot {dir}/trip.ndjson").file("trip.ndjson", &record).json().exits(0);
    assert_eq!(tripped.data("/marks").as_array().unwrap().len(), 1, "{:#}", tripped.value);
    assert_eq!((tripped.data("/marks/0/kind"), tripped.data("/marks/0/t")), (&json!("fault"), &json!(2.0)));
}

/// A ramp that the run leads itself, stopped as it arrives, or held for a while: one way, with the slope that was asked for.
#[test]
fn a_led_ramp_is_measured_as_one_way_however_soon_the_stop_comes() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 2\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n";
    for (ramp, slope, duration, rests) in [
        ("0Hz:20Hz:4s", 5.0, "200ms", false),
        ("0Hz:20Hz:4s", 5.0, "1s", true),
        ("0Hz:20Hz:10s", 2.0, "200ms", false),
        ("0Hz:20Hz:10s", 2.0, "3s", true),
    ] {
        let line = format!("-a 2 sollwert --ramp {ramp} --enable --hold --duration {duration} --yes --format ndjson");
        let run = antrieb(&line).on(bench).exits(0);
        let plot = antrieb("plot {dir}/run.ndjson --measure").file("run.ndjson", &run.out).json().exits(0);
        let [told] = &plot.data("/responses").as_array().unwrap()[..] else { panic!("{line}: {:#}", plot.value) };
        let measured = told["slope"].as_f64().unwrap_or_else(|| panic!("{line}: {told:#}"));
        assert!((measured - slope).abs() < 0.1 && told["dead_time_s"].is_f64(), "{line}: {told:#}");
        assert_eq!(told["settling_s"].is_f64(), rests, "{line}: {told:#}");
    }
}

/// A fault in a held run: a record of its own before the sample that shows it, with what was seen last, and a mark.
#[test]
fn a_trip_in_a_held_run_is_a_record_and_a_mark() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 2\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n\
        [[drive.event]]\nat = \"3100ms\"\nfault = \"F0500\"\n";
    let line = "-a 2 sollwert 15Hz --enable --hold --duration 6s --yes --format ndjson";
    let run = antrieb(line).on(bench).exits(8);
    let records: Vec<Value> = run.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let trips: Vec<usize> = (0..records.len()).filter(|&index| records[index]["type"] == "trip").collect();
    let [at] = trips[..] else { panic!("{}", run.out) };
    let trip = &records[at];
    assert_eq!(
        (&trip["fault"]["key"], &trip["before"]["state"]["slug"]),
        (&json!("F0500"), &json!("operation-enabled"))
    );
    let seen = trip["before"]["values"].as_array().unwrap();
    assert!(
        seen.iter().any(|row| row["slug"] == "ramp-reference-frequency" && row["value"].as_f64() > Some(5.0)),
        "{trip:#}"
    );
    let state = |record: &Value| record["state"]["slug"].as_str().map(|state| state == "fault");
    assert!(records[..at].iter().all(|record| state(record) != Some(true)), "{}", run.out);
    assert_eq!(records[at + 1..].iter().find_map(state), Some(true), "{}", run.out);
    let plot = antrieb("plot {dir}/run.ndjson").file("run.ndjson", &run.out).json().exits(0);
    let marks = plot.data("/marks").as_array().unwrap();
    let faults: Vec<_> = marks.iter().filter(|mark| mark["kind"] == "fault").collect();
    assert!(faults.len() == 1 && faults[0]["text"].as_str().unwrap().starts_with("F0500 "), "{marks:#?}");
}

#[test]
fn what_is_no_record_or_no_column_is_refused() {
    let plot = |text: &str, options: &str| antrieb(&format!("plot {{dir}}/x {options}")).file("x", text).run();
    for (text, options, exit, told) in [
        ("nonsense\n", "", 7, "line 1: expected a record of `monitor`"),
        ("{\"type\":\"start\"}\n", "", 7, "line 1: expected a record"),
        ("t,n,address,drive,state,error\n", "", 7, "there is no sample in it"),
        (RECORD, "speed", 7, "there is no column 'speed' with numbers"),
        (RECORD, "-a 3", 7, "has no drive with address 3 (it has: 1)"),
    ] {
        let run = plot(text, options);
        assert!(run.exit == exit && run.err.contains(told), "{told}: exit {} {}", run.exit, run.err);
    }
    antrieb("plot {dir}/none").exits(7);
    let line = "plot {dir}/record.csv --svg {dir}/old.svg";
    let refused = antrieb(line).file("record.csv", RECORD).file("old.svg", "precious").exits(7);
    assert_eq!(refused.text_of("old.svg"), "precious");
    antrieb(line).and("--force").file("record.csv", RECORD).file("old.svg", "precious").exits(0);
}

/// The characteristic of an analog input: the examples of the EM-RES-03 manual (6.1.3.1).
#[test]
fn the_characteristic_of_an_analog_input_is_drawn_in_each_mode() {
    let file = "antrieb = 1\ndrive.family = \"acu\"\n[values]\n562 = \"1\"\n564 = \"-70.00 %\"\n565 = \"-50.00 %\"\n566 = \"80.00 %\"\n567 = \"85.00 %\"\n";
    let plot = |modes: &str| {
        antrieb(&format!("plot {{dir}}/x.toml {modes} --svg {{dir}}/x.svg")).file("x.toml", file).json().exits(0)
    };
    let own = plot("");
    assert_eq!((own.data("/across"), own.data("/curves/0/part")), (&json!("V"), &json!("other")));
    assert_eq!((own.data("/from"), own.data("/to")), (&json!(-10.0), &json!(10.0)));
    assert_eq!([own.data("/curves/0/min"), own.data("/curves/0/max")], [&json!(-50.0), &json!(85.0)]);
    let zero = own.data("/marks/0/text").as_str().unwrap();
    assert!(zero.contains("-1.44 V") && zero.contains("0.20 V"), "{zero}");
    // What is not printed is another curve, and the factory's band is told.
    assert_eq!(own.data("/curves").as_array().unwrap().len(), 2);
    let codes: Vec<_> = own.value["warnings"].as_array().unwrap().iter().map(|row| row["code"].clone()).collect();
    assert_eq!(codes, ["plot.factory", "plot.open"]);
    let drawn = antrieb("plot {dir}/x.toml --svg {dir}/x.svg").file("x.toml", file).exits(0);
    assert!(drawn.text_of("x.svg").contains("input [V]"));
    let all = plot("1 11 21 101");
    let highest: Vec<_> = all.data("/curves").as_array().unwrap().iter().map(|row| row["min"].clone()).collect();
    assert_eq!(highest, [json!(-50.0), json!(0.0), json!(0.0), json!(0.0)]);
    let table = antrieb("--lang de plot {dir}/x.toml 21").file("x.toml", file).exits(0).out;
    assert!(table.contains("21 Unipolar 2-10 V") && table.contains("10 V"), "{table}");
    for (typed, text, exit) in [
        ("plot {dir}/x.toml 2", file.to_owned(), 2),
        ("plot {dir}/x.toml --measure", file.to_owned(), 2),
        ("plot {dir}/x.toml", file.replace("80.00", "-70.00"), 7),
        ("plot {dir}/x.toml", file.replace("acu", "sj200"), 7),
    ] {
        antrieb(typed).file("x.toml", &text).exits(exit);
    }
}
