//! `monitor` in process: every form of its stream, gaps, ends, and that it never writes; on the bench in virtual time.
use crate::run::{Output, antrieb};
use jsonschema::Validator;
use serde_json::{Value, json};
use std::sync::LazyLock;

/// A drive that goes off the bus from 2 s to 5 s.
const FALLS_SILENT: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive.event]]\nat = \"2s\"\nsilent = \"3s\"\n[[drive]]\nmodel = \"acu\"\naddress = 2\n";

static SCHEMA: LazyLock<Validator> = LazyLock::new(|| {
    let schema: Value = serde_json::from_str(&antrieb("schema monitor").exits(0).out).unwrap();
    assert!(jsonschema::meta::is_valid(&schema));
    jsonschema::validator_for(&schema).unwrap()
});

/// The records of a run; each must fit the schema, the first be the start, the last the end.
#[track_caller]
fn records(output: &Output) -> Vec<Value> {
    let records: Vec<Value> = output.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    for record in &records {
        let broken: Vec<_> =
            SCHEMA.iter_errors(record).map(|error| format!("{}: {error}", error.instance_path)).collect();
        assert!(broken.is_empty(), "{}\n{record:#}", broken.join("\n"));
        assert!(record["t"].is_number() || record["type"] == "telegram", "{record}");
    }
    let ends: Vec<_> = records.iter().filter(|record| record["type"] == "end").collect();
    assert_eq!(ends.len(), 1, "{}", output.out);
    let end = records.last().unwrap();
    assert_eq!(end["type"], "end");
    assert_eq!(end["ok"], json!(output.exit == 0));
    assert_eq!(end["error"].is_null(), output.exit == 0);
    if output.exit != 0 {
        assert_eq!(end["error"]["exit"], output.exit);
    }
    records
}

fn of_type<'r>(records: &'r [Value], kind: &str) -> Vec<&'r Value> {
    records.iter().filter(|record| record["type"] == kind).collect()
}

fn value<'s>(sample: &'s Value, slug: &str) -> &'s Value {
    let values = sample["values"].as_array().unwrap();
    values.iter().find(|value| value["slug"] == slug).unwrap_or_else(|| panic!("no {slug} in {sample:#}"))
}

#[test]
fn a_stream_is_a_start_samples_and_an_end() {
    let output = antrieb("-p sim -a 1,2 monitor --count 3 --interval 600ms --unpaced --format ndjson").exits(0);
    let records = records(&output);
    assert_eq!(records[0]["type"], "start");
    assert_eq!(records[0]["interval"], 0.6);
    let drives: Vec<_> = records[0]["drives"].as_array().unwrap().iter().map(|drive| drive["drive"].clone()).collect();
    assert_eq!(drives, ["act", "acu"]);
    let samples = of_type(&records, "sample");
    let of_first: Vec<_> = samples.iter().filter(|sample| sample["address"] == 1).collect();
    // On the grid of the interval, whatever the rounds cost.
    let times: Vec<_> = of_first.iter().map(|sample| sample["t"].as_f64().unwrap()).collect();
    assert_eq!(times, [0.0, 0.6, 1.2]);
    let numbers: Vec<_> = of_first.iter().map(|sample| sample["n"].as_u64().unwrap()).collect();
    assert_eq!(numbers, [0, 1, 2]);
    for sample in &samples {
        assert_eq!(sample["state"]["slug"], "switched-on");
        assert_eq!(sample["error"], Value::Null);
        let slugs: Vec<_> = sample["values"].as_array().unwrap().iter().map(|value| value["slug"].clone()).collect();
        let columns = &records[0]["drives"][0]["columns"];
        let expected: Vec<_> = columns.as_array().unwrap().iter().map(|column| column["slug"].clone()).collect();
        assert_eq!(slugs, expected);
        let frequency = value(sample, "stator-frequency");
        assert_eq!(
            (&frequency["raw"], &frequency["value"], &frequency["unit"]),
            (&json!(0), &json!(0.0), &json!("Hz"))
        );
        assert!(frequency["t"].as_f64() > sample["t"].as_f64());
        assert_eq!(value(sample, "status-word")["word"]["bits"][0]["slug"], "ready-to-switch-on");
    }
    let end = records.last().unwrap();
    assert_eq!(end["summary"]["because"], "count");
    assert_eq!(
        (&end["summary"]["rounds"], &end["summary"]["samples"], &end["summary"]["gaps"]),
        (&json!(3), &json!(6), &json!(0))
    );
}

/// Who asked for 200 ms and gets 400 shall not believe to have them.
#[test]
fn an_interval_that_the_line_cannot_keep_is_told() {
    let end = |line: &str| {
        let run = antrieb(&format!("-p sim -a 1,2 monitor --unpaced {line}")).exits(0);
        (records(&run).pop().unwrap(), run.err)
    };
    let (slow, told) = end("--count 5 --interval 200ms --json");
    let summary = &slow["summary"];
    assert_eq!((&summary["interval"], &summary["late"]), (&json!(0.2), &json!(4)), "{slow:#}");
    assert_eq!(summary["interval_kept"], 0.45);
    assert_eq!(slow["warnings"][0]["code"], "monitor.interval");
    assert!(told.contains("the interval of 200 ms was not kept: a round came every 450 ms on average"), "{told}");
    let (kept, told) = end("--count 5 --interval 600ms --json");
    assert_eq!((&kept["summary"]["interval_kept"], &kept["summary"]["late"]), (&json!(0.6), &json!(0)));
    assert!(!told.contains("not kept"), "{told}");
    let (free, _) = end("--count 5 --interval 0 --json");
    assert!(free["summary"]["interval_kept"].as_f64().unwrap() > 0.2 && free["warnings"] == json!([]), "{free:#}");
    assert_eq!(end("--count 1 --json").0["summary"]["interval_kept"], Value::Null);
}

#[test]
fn json_means_ndjson_and_runs_are_alike() {
    let line = "-p sim -a 1,2 monitor --count 4 --unpaced";
    let ndjson = antrieb(&format!("{line} --format ndjson")).exits(0).out;
    assert_eq!(antrieb(&format!("{line} --json")).exits(0).out, ndjson);
}

#[test]
fn a_paced_bench_takes_its_time_and_tells_the_same() {
    let line = "-p sim -a 1 monitor --count 3 --interval 250ms --json";
    #[expect(clippy::disallowed_methods, reason = "whether real time goes by is the question")]
    let begin = std::time::Instant::now();
    let paced = antrieb(line).paced().exits(0).out;
    #[expect(clippy::disallowed_methods, reason = "whether real time goes by is the question")]
    let took = begin.elapsed();
    assert!(took.as_millis() >= 590, "{took:?}"); // 2 intervals and the last round
    assert_eq!(antrieb(&format!("{line} --unpaced")).exits(0).out, paced);
}

#[test]
fn a_silent_drive_is_a_gap_and_the_watch_goes_on() {
    let output = antrieb("-a 1,2 monitor --count 9 --unpaced --json").on(FALLS_SILENT).exits(0);
    let records = records(&output);
    let (first, second): (Vec<_>, Vec<_>) =
        of_type(&records, "sample").into_iter().partition(|sample| sample["address"] == 1);
    let gaps: Vec<_> = first.iter().map(|sample| !sample["error"].is_null()).collect();
    assert!(!gaps[0] && !gaps[1] && !gaps.last().unwrap(), "{gaps:?}");
    assert!(gaps.iter().filter(|gap| **gap).count() >= 2, "{gaps:?}");
    assert!(second.iter().all(|sample| sample["error"].is_null()));
    let gap = first.iter().find(|sample| !sample["error"].is_null()).unwrap();
    assert_eq!(gap["error"]["class"], "silence");
    // It is known which drive it is, and what is missing.
    assert_eq!(gap["drive"], "act");
    for value in gap["values"].as_array().unwrap() {
        assert_eq!((&value["raw"], &value["value"]), (&Value::Null, &Value::Null));
        assert_eq!(value["error"]["class"], "silence");
    }
    let end = records.last().unwrap();
    assert_eq!(end["summary"]["gaps"], gaps.iter().filter(|gap| **gap).count());
    // Said once each.
    assert_eq!(output.err.matches("going on").count(), 1, "{}", output.err);
    assert_eq!(output.err.matches("answers again").count(), 1, "{}", output.err);
}

#[test]
fn gaps_in_csv_are_empty_cells() {
    let output = antrieb("-a 1,2 monitor --count 9 --unpaced --format csv").on(FALLS_SILENT).exits(0);
    let mut reader = csv::Reader::from_reader(output.out.as_bytes());
    let head: Vec<_> = reader.headers().unwrap().iter().map(str::to_owned).collect();
    assert_eq!(head[..5], ["t", "n", "address", "drive", "state"]);
    assert_eq!(head.last().unwrap(), "error");
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!(rows.len(), 18);
    let column = |name: &str| head.iter().position(|head| head == name).unwrap();
    let (frequency, error) = (column("stator-frequency"), column("error"));
    for row in &rows {
        assert_eq!(row[frequency].is_empty(), !row[error].is_empty(), "{row:?}");
        assert!(row[error].is_empty() || &row[error] == "silence.no_reply");
        assert!(row[frequency].is_empty() || &row[frequency] == "0.00");
    }
    assert!(rows.iter().any(|row| !row[error].is_empty()));
}

#[test]
fn a_word_in_csv_is_hex_and_its_bits_are_names() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 2\n[[drive.event]]\nat = \"0s\"\nwarning = 0x0085\n";
    for (lang, names) in [("en", "Long-term Ixt"), ("de", "Langzeit Ixt")] {
        let output =
            antrieb(&format!("-a 2 monitor --count 1 --unpaced --format csv --lang {lang}")).on(bench).exits(0);
        let mut reader = csv::Reader::from_reader(output.out.as_bytes());
        let head = reader.headers().unwrap().clone();
        let row = reader.records().next().unwrap().unwrap();
        let cell = |name: &str| row.get(head.iter().position(|head| head == name).unwrap()).unwrap();
        assert_eq!(cell("warnings"), "0x0085");
        assert!(cell("warnings_bits").contains(&format!("; {names}; ")), "{}", cell("warnings_bits"));
        assert!(cell("status-word").starts_with("0x") && !cell("status-word_bits").is_empty(), "{row:?}");
    }
}

#[test]
fn values_without_known_decimals_are_raw_in_csv() {
    let output = antrieb("-p sim -a 1 monitor 241 372@2 --count 1 --unpaced --format csv").exits(0);
    assert_eq!(output.out.lines().next().unwrap(), "t,n,address,drive,state,actual-frequency.raw,rated-speed@2,error");
}

#[test]
fn lines_are_aligned_and_plain() {
    for lang in ["en", "de"] {
        let line = format!("--lang {lang} -a 1,2 monitor --count 6 --unpaced");
        let output = antrieb(&line).on(FALLS_SILENT).exits(0);
        assert!(!output.out.contains(['\u{1b}', '\r']), "{}", output.out);
        let lines: Vec<Vec<char>> = output.out.lines().map(|line| line.chars().collect()).collect();
        assert_eq!(lines.len(), 13);
        let head: String = lines[0].iter().collect();
        let unit = head.chars().collect::<Vec<_>>().windows(4).position(|four| four == ['[', 'H', 'z', ']']).unwrap();
        for line in &lines[1..] {
            // Numbers end below the end of their head.
            let cell: String = line[unit - 1..unit + 4].iter().collect();
            assert!(cell.ends_with("0.00") || cell.ends_with("--"), "{cell:?} in {line:?}");
        }
        let gap = if lang == "de" { "Lücke" } else { "gap" };
        assert!(output.out.contains(gap), "{}", output.out);
    }
}

#[test]
fn one_line_is_refreshed_and_fits_the_terminal() {
    let output = antrieb("-a 1,2 monitor --line --count 4 --unpaced").on(FALLS_SILENT).columns(60).exits(0);
    assert_eq!(output.out.matches('\n').count(), 1, "{:?}", output.out);
    assert!(output.out.ends_with('\n') && !output.out.contains('\u{1b}'));
    for text in output.out.trim_end_matches('\n').split('\r') {
        assert!(text.chars().count() <= 59, "{text:?}");
    }
    // Into a pipe there is nothing to refresh.
    let piped = antrieb("-a 1,2 monitor --line --count 4 --unpaced").on(FALLS_SILENT).exits(0);
    assert!(!piped.out.contains('\r') && piped.out.lines().count() == 9);
}

#[test]
fn nothing_that_ever_answered_is_silence() {
    let output = antrieb("-p sim -a 9 monitor --count 2 --unpaced --json").exits(4);
    let records = records(&output);
    assert_eq!(records[0]["drives"][0]["drive"], "unknown");
    assert!(!records[0]["drives"][0]["columns"].as_array().unwrap().is_empty());
    assert_eq!(of_type(&records, "sample").len(), 2);
    assert_eq!(records.last().unwrap()["error"]["code"], "silence.no_reply");
    // One of two: partly done.
    antrieb("-p sim -a 1,9 monitor --count 2 --unpaced --json").exits(9);
    // Who it is, then its status word. The first try repeats its question, later ones do not.
    let asked = antrieb("-p sim -a 9 -v monitor --count 3 --unpaced").exits(4).sent();
    assert_eq!(asked.len(), (1 + 3) + (1 + 1) + (1 + 1), "{asked:?}");
}

#[test]
fn a_drive_that_comes_later_fits_into_the_columns() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 1\n[[drive.event]]\nat = \"0ms\"\nsilent = \"3s\"\n";
    let output = antrieb("-a 1 monitor --count 5 --unpaced --format csv").on(bench).exits(0);
    let mut reader = csv::Reader::from_reader(output.out.as_bytes());
    let rows: Vec<csv::StringRecord> = reader.records().map(Result::unwrap).collect();
    assert_eq!((&rows[0][3], &rows.last().unwrap()[3]), ("unknown", "acu"));
    let last = rows.last().unwrap();
    // What only a Lexium has, which it could have been, stays empty: its status word, of which the number tells that it is another one.
    let empty: Vec<_> =
        reader.headers().unwrap().iter().zip(last).filter(|row| row.1.is_empty()).map(|row| row.0).collect();
    let servo = ["status-word.6916", "status-word.6916_bits", "active-mode", "profile-velocity", "actual-position"];
    assert_eq!((empty[0], &empty[1..6], empty[6], empty.len()), ("warnings_bits", &servo[..], "error", 7), "{last:?}");
}

#[test]
fn the_time_and_the_count_end_it() {
    let end = |options: &str| {
        let output = antrieb(&format!("-p sim -a 1 monitor --unpaced --json {options}")).exits(0);
        records(&output).pop().unwrap()
    };
    let timed = end("--duration 5s");
    assert_eq!((&timed["t"], &timed["summary"]["because"]), (&json!(5.0), &json!("duration")));
    assert_eq!(timed["summary"]["rounds"], 5);
    assert_eq!(end("--duration 5s --count 3")["summary"]["because"], "count");
    assert_eq!(end("--duration 2s --count 300")["summary"]["because"], "duration");
    // As fast as the line allows.
    let fast = end("--interval 0 --duration 2s");
    assert!(fast["summary"]["rounds"].as_u64().unwrap() > 10, "{fast}");
}

#[test]
fn a_closed_pipe_is_a_success_and_ends_it() {
    for form in ["--format ndjson", "--format csv", "", "--json"] {
        for room in [0, 10, 400, 3_000] {
            let output = antrieb(&format!("-p sim -a 1 monitor --unpaced {form}")).into_pipe_of(room).run();
            assert_eq!(output.exit, 0, "{form} {room}: {}", output.err);
            assert_eq!(output.out.len(), room);
        }
    }
}

#[test]
fn it_never_writes() {
    let sent = antrieb("-v -a 1,2 monitor --count 8 --unpaced").on(FALLS_SILENT).exits(0).sent();
    assert!(sent.len() > 50);
    for telegram in sent {
        // Reading 16 bits, reading 32 bits, the description of the device, diagnostic counters as a fence.
        let function = telegram.split(' ').nth(1).unwrap();
        assert!(["03", "64", "2B", "08"].contains(&function), "{telegram}");
        assert!(function != "08" || !telegram[6..].starts_with("00 0A"), "{telegram} clears the counters");
    }
}

#[test]
fn sets_that_differ_are_four_columns() {
    let bench = "[[drive]]\nmodel = \"act\"\naddress = 1\nset = { \"480@2\" = 7 }\n";
    let output = antrieb("-a 1 monitor 480 --count 3 --unpaced --json").on(bench).exits(0);
    let records = records(&output);
    assert_eq!(records[0]["drives"][0]["columns"].as_array().unwrap().len(), 4);
    for sample in of_type(&records, "sample") {
        let values = sample["values"].as_array().unwrap();
        let sets: Vec<_> = values.iter().map(|value| value["data_set"].as_u64().unwrap()).collect();
        assert_eq!(sets, [1, 2, 3, 4]);
        assert_eq!(values[1]["value"], 7.0);
    }
    // Found out once; from then on every set is asked at once.
    let asked = antrieb("-v --drive act -a 1 monitor 480 --count 3 --unpaced").on(bench).exits(0).sent();
    // The first answer in the words of another is asked for again, behind a question that tells them apart.
    assert_eq!(asked.len(), 1 + (1 + 1 + 4) + 2 + 4 + 4, "greeted, asked: {asked:?}");
}

#[test]
fn what_a_drive_does_not_have_is_said() {
    // Named: partly done.
    let output = antrieb("-p sim -a 1 monitor 210 1600 --count 2 --unpaced --json").exits(9);
    let refused =
        of_type(&records(&output), "sample").iter().filter(|s| s["values"][1]["error"]["class"] == "refused").count();
    assert_eq!(refused, 2);
    // Of a group: left out, and not asked again.
    antrieb("-p sim -a 1 monitor @actual --count 2 --unpaced --json").exits(0);
}

#[test]
fn a_device_that_is_no_drive_ends_it() {
    let bench = "[[drive]]\nmodel = \"foreign\"\naddress = 9\n";
    let output = antrieb("-a 9 monitor --unpaced --json").on(bench).exits(7);
    assert_eq!(records(&output).last().unwrap()["summary"]["because"], "no_drive");
}

#[test]
fn what_cannot_begin_is_one_line() {
    for (line, exit) in [
        ("-p sim monitor --interval x", 2),
        ("-p sim monitor --count 0", 2),
        ("-p sim monitor frobnicate", 7),
        ("-p sim -a 0 monitor", 2),
        ("-p /dev/antrieb-has-no-such-port -a 1 monitor --reconnect", 3),
        ("-p sim --catalogue none.toml monitor", 7),
    ] {
        let output = antrieb(&format!("{line} --json")).exits(exit);
        assert_eq!(records(&output).len(), 1, "{line}");
        let output = antrieb(line).exits(exit);
        assert!(output.out.is_empty() && output.err.contains("error: "), "{line}: {}", output.out);
    }
}

#[test]
fn a_dry_run_shows_the_questions() {
    let records = records(&antrieb("-p /dev/antrieb-has-no-such-port -a 1 monitor 210 --dry-run --json").exits(0));
    assert_eq!(records.len(), 2);
    assert_eq!(records[0]["type"], "telegram");
    let table = antrieb("-p /dev/antrieb-has-no-such-port -a 1 monitor 210 --dry-run").exits(0).out;
    assert!(table.contains("read P.210"), "{table}");
}

/// The lines of the line protocol: measurement and tags, fields.
#[test]
fn telegraf_and_influx_get_one_line_a_drive_and_round() {
    let output = antrieb("-p sim -a 1,2 monitor 210 480@2 411 --count 2 --unpaced --format influx").exits(0);
    let lines: Vec<_> = output.out.lines().collect();
    let begins = "antrieb,address=1,family=act,port=sim reachable=true,stator_frequency=0.00,fixed_frequency_1_2=";
    assert!(lines.len() == 4 && lines[0].starts_with(begins), "{}", output.out);
    assert!(lines[1].starts_with("antrieb,address=2,family=acu,port=sim "), "{}", lines[1]);
    assert!(
        lines[1].contains(",status_word=") && lines[1].contains(",state=\"switched-on\",line_telegrams="),
        "{}",
        lines[1]
    );
    let silent = antrieb("-a 1 monitor 210 --duration 4s --unpaced --format influx").on(FALLS_SILENT).exits(0);
    assert!(silent.out.contains(" reachable=false,error=\"silence.no_reply\",line_telegrams="), "{}", silent.out);
}

/// One exposition a round: every family of metrics once, its samples behind its type, and an end.
#[test]
fn prometheus_gets_every_round_as_a_text_that_is_whole() {
    let output = antrieb("-p sim -a 1,2 monitor 210 411 --count 2 --unpaced --format openmetrics").exits(0);
    let rounds: Vec<_> = output.out.split_inclusive("# EOF\n").collect();
    assert_eq!(rounds.len(), 2, "{}", output.out);
    for round in rounds {
        let mut types: Vec<&str> = Vec::new();
        for line in round.lines() {
            match line.strip_prefix("# TYPE ") {
                Some(told) => types.push(told.split(' ').next().unwrap()),
                None => assert!(line.starts_with('#') || line.starts_with(types.last().unwrap()), "{line}"),
            }
        }
        let once: std::collections::BTreeSet<_> = types.iter().collect();
        assert_eq!(types.len(), once.len(), "{types:?}");
        for row in [
            "antrieb_reachable{address=\"2\",family=\"acu\",port=\"sim\"} 1\n",
            "antrieb_state{address=\"1\",family=\"act\",port=\"sim\",state=\"switched-on\"} 1\n",
            "name=\"stator-frequency\",data_set=\"0\",store=\"ram\",unit=\"Hz\"} 0.00\n",
            "antrieb_line_silences_total{port=\"sim\"} 0\n",
        ] {
            assert!(round.contains(row), "{row} in {round}");
        }
    }
}

#[test]
fn a_text_file_holds_the_last_round_and_takes_no_other_files_place() {
    let watch = "-p sim -a 1 monitor 210 --count 2 --unpaced --format csv --textfile {dir}/drives.prom";
    let run = antrieb(watch).exits(0);
    let text = run.text_of("drives.prom");
    assert!(text.starts_with("# TYPE antrieb_") && text.ends_with("# EOF\n"), "{text}");
    // Type and help name a counter as its sample does, which OpenMetrics does not.
    assert!(text.contains("# TYPE antrieb_line_silences_total counter\n# HELP antrieb_line_silences_total "), "{text}");
    assert_eq!(run.out.lines().count(), 3, "the stream goes on as ever: {}", run.out);
    let mine = antrieb(watch).file("drives.prom", "something else\n").exits(7);
    assert!(mine.err.contains("drives.prom: the file exists already"), "{}", mine.err);
    assert_eq!(mine.text_of("drives.prom"), "something else\n");
    let refused = antrieb("-p sim -a 1 read 210 --format influx").exits(2);
    assert!(refused.err.contains("monitor"), "{}", refused.err);
}

/// The short words mean what they mean to a trigger, and not the only name that begins so.
#[test]
fn a_short_word_is_watched_as_what_it_says() {
    for (word, id) in
        [("fault", 260), ("state", 411), ("setpoint", 283), ("frequency", 210), ("current", 211), ("warnings", 270)]
    {
        let run = antrieb(&format!("-p sim -a 1 --format ndjson monitor --count 1 {word}")).exits(0);
        let sample = run.out.lines().find(|line| line.contains("\"type\":\"sample\"")).unwrap();
        let sample: Value = serde_json::from_str(sample).unwrap();
        assert_eq!(sample["values"][0]["param"], id, "{word}: {sample:#}");
    }
    let none = antrieb("-p sim -a 1 monitor --count 1 voltage").exits(7);
    assert!(none.err.contains("no source tells which parameter"), "{}", none.err);
}
