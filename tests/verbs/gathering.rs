//! `monitor --gather stdin`: a round for each line, in every form; and whose values they are.
use crate::run::antrieb;
use serde_json::{Value, json};

const GATHER: &str = "-p sim -a 1,2 monitor 210 --gather stdin --unpaced";

fn records(out: &str) -> Vec<Value> {
    out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn every_line_is_a_round_in_every_form() {
    let lines = [("", 2 * 3), ("csv", 2 * 3), ("influx", 2 * 3), ("openmetrics", 3)];
    for (format, expected) in lines {
        let format = if format.is_empty() { String::new() } else { format!("--format {format}") };
        let run = antrieb(&format!("{GATHER} {format}")).fed("\n\n\n").exits(0);
        let came = if format.contains("openmetrics") {
            run.out.matches("# EOF\n").count()
        } else {
            run.out.lines().count() - usize::from(!format.contains("influx"))
        };
        assert_eq!(came, expected, "{format}: {}", run.out);
    }
    // On a terminal as well: there is nothing to draw anew between two lines.
    let shown = antrieb(GATHER).fed("\n\n\n").columns(80).exits(0);
    assert_eq!(shown.rows().len(), 2 * 3, "{}", shown.out);
}

#[test]
fn rounds_come_with_lines_alone_whatever_these_say_and_end_with_them() {
    for (input, rounds) in [("", 0), ("\n", 1), ("now", 1), ("a\r\nb\r\n", 2), ("\n\nlast", 3)] {
        let records = records(&antrieb(&format!("{GATHER} --json")).fed(input).exits(0).out);
        let end = records.last().unwrap();
        assert_eq!((&records[0]["type"], &records[0]["interval"]), (&json!("start"), &Value::Null));
        assert_eq!(
            (&end["summary"]["because"], &end["summary"]["rounds"]),
            (&json!("input"), &json!(rounds)),
            "{input:?}"
        );
        let numbers: Vec<_> = records.iter().filter(|record| record["type"] == "sample").map(|row| &row["n"]).collect();
        let expected: Vec<_> = (0..rounds).flat_map(|n| [json!(n), json!(n)]).collect();
        assert_eq!(numbers, expected.iter().collect::<Vec<_>>(), "{input:?}");
    }
    // Without a line nobody is asked anything.
    assert!(antrieb(&format!("-v {GATHER}")).fed("").exits(0).sent().is_empty());
}

#[test]
fn other_ends_hold_as_well() {
    let end = |more: &str, lines: usize| {
        let run = antrieb(&format!("{GATHER} --json {more}")).fed(&"\n".repeat(lines)).exits(0);
        records(&run.out).pop().unwrap()["summary"].clone()
    };
    assert_eq!((&end("--count 2", 9)["because"], &end("--count 2", 9)["rounds"]), (&json!("count"), &json!(2)));
    let timed = end("--duration 1s", 500);
    assert_eq!(timed["because"], "duration");
    assert!(timed["rounds"].as_u64().unwrap() > 2, "{timed}");
    // Nobody who answers is told as ever.
    antrieb("-p sim -a 9 monitor --gather stdin --unpaced --json").fed("\n").exits(4);
}

#[test]
fn one_of_clock_and_lines_says_when() {
    let both = antrieb("-p sim monitor --gather stdin --interval 1s").fed("").exits(2);
    assert!(both.err.contains("--gather") && both.err.contains("--interval"), "{}", both.err);
    antrieb("-p sim monitor --gather file").fed("").exits(2);
    // As Telegraf's configuration spells it.
    antrieb("-p sim monitor --gather STDIN --unpaced").fed("\n").exits(0);
}

#[test]
fn who_sits_at_the_keyboard_is_told_what_to_press() {
    for (lang, told) in
        [("en", "Enter takes a sample, Ctrl-D ends"), ("de", "Enter nimmt einen Messpunkt, Strg-D beendet")]
    {
        let run = antrieb(&format!("--lang {lang} {GATHER}")).answered("").exits(0);
        assert!(run.err.contains(told) && run.rows().len() == 2, "{}\n{}", run.err, run.out);
        let piped = antrieb(&format!("--lang {lang} {GATHER}")).fed("\n").exits(0);
        assert!(!piped.err.contains("Enter"), "{}", piped.err);
    }
}

#[test]
fn a_drive_that_has_a_name_bears_it() {
    let plant =
        "port = \"sim\"\n[drives.\"main pump\"]\naddress = 2\n[drives.elsewhere]\naddress = 1\nport = \"/dev/ttyS9\"\n";
    let line = "-a 1,2 monitor 210 --count 1 --unpaced --format";
    let of = |format: &str| antrieb(&format!("{line} {format}")).file("antrieb.toml", plant).exits(0).out;
    let influx = of("influx");
    assert!(influx.contains("antrieb,address=1,family=act,port=sim reachable=true,stator_frequency=0.00,"), "{influx}");
    let named = "antrieb,address=2,drive=main\\ pump,family=acu,port=sim reachable=true,stator_frequency=0.00,";
    assert!(influx.contains(named), "{influx}");
    let text = of("openmetrics");
    assert!(text.contains("antrieb_reachable{address=\"1\",family=\"act\",port=\"sim\"} 1\n"), "{text}");
    let named = "antrieb_reachable{address=\"2\",drive=\"main pump\",family=\"acu\",port=\"sim\"} 1\n";
    assert!(text.contains(named), "{text}");
    let records = records(&of("ndjson"));
    let called: Vec<_> = records[0]["drives"].as_array().unwrap().iter().map(|drive| &drive["called"]).collect();
    assert_eq!(called, [&Value::Null, &json!("main pump")]);
    let whose = |row: &Value| ["port", "address", "called", "drive"].map(|name| row[name].clone());
    assert_eq!(whose(&records[1]), [json!("sim"), json!(1), Value::Null, json!("act")]);
    assert_eq!(whose(&records[2]), [json!("sim"), json!(2), json!("main pump"), json!("acu")]);
}
