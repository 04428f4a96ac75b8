//! `sniff`: what others say on a line, in every form and protocol; never a byte of our own.

use crate::run::antrieb;
use serde_json::{Value, json};

/// A question and its reply glued, a write and its echo-like reply, an exception, noise. All received: a tape of a listener.
const RTU: &str = "# antrieb trace 1, 19200 8E1, rtu
1000 < 01 03 21 74 00 01 CE 2C 01 03 02 05 6E 3A F8
30000 < 03 06 41 78 00 0F 5C 09
36000 < 03 06 41 78 00 0F 5C 09
50000 < 01 03 21 74
51000 < 00 01 CE 2C
60000 < 01 83 02 C0 F1
90000 < 55 AA
";

const TOLD: &str = "       1.000  >  01 03 21 74 00 01 CE 2C  address 1: read P.372@2 Rated Speed, 16 bit
       1.000  <  01 03 02 05 6E 3A F8     address 1: value 1390 (0x056E)
      30.000  >  03 06 41 78 00 0F 5C 09  address 3: write P.376@4 Rated Mech. Power = 1.5 kW
      36.000  <  03 06 41 78 00 0F 5C 09  address 3: P.376@4 Rated Mech. Power = 1.5 kW written
      50.000  >  01 03 21 74 00 01 CE 2C  address 1: read P.372@2 Rated Speed, 16 bit
      60.000  <  01 83 02 C0 F1           address 1: refuses function code 3, exception 2 (illegal data address)
      90.000  !  55 AA                    no valid telegram: 2 bytes are too few for a frame
";

#[test]
fn every_telegram_is_a_line_with_time_direction_bytes_and_words() {
    let line = "-p tape:{dir}/t sniff --protocol rtu";
    let output = antrieb(line).file("t", RTU).exits(0);
    assert!(output.out.starts_with(TOLD), "{}", output.out);
    assert!(output.err.contains("7 telegrams in"), "{}", output.err);
    let german = antrieb(&format!("--lang de {line}")).file("t", RTU).exits(0);
    assert!(german.out.contains("Adresse 1: Wert 1390") && german.err.contains("7 Telegramme in"), "{}", german.out);
}

#[test]
fn a_document_tells_all_at_the_end_and_a_stream_each_as_it_comes() {
    let line = "-p tape:{dir}/t sniff --protocol rtu";
    let document = antrieb(line).file("t", RTU).json().exits(0);
    let data = &document.value["data"];
    assert_eq!((&data["heard"], &data["garbled"], &data["because"]), (&json!(7), &json!(1), &json!("quiet")));
    let telegrams = data["telegrams"].as_array().unwrap();
    let stream = antrieb(&format!("{line} --format ndjson")).file("t", RTU).exits(0);
    let records: Vec<Value> = stream.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let (end, told) = records.split_last().unwrap();
    assert_eq!(told.len(), telegrams.len());
    for (record, telegram) in told.iter().zip(telegrams) {
        assert_eq!(
            (&record["type"], &record["hex"], &record["at_us"]),
            (&json!("telegram"), &telegram["hex"], &telegram["at_us"])
        );
    }
    assert_eq!((&end["type"], &end["command"], &end["summary"]["heard"]), (&json!("end"), &json!("sniff"), &json!(7)));
}

#[test]
fn the_count_and_the_time_end_it() {
    let run = |more: &str| antrieb(&format!("-p tape:{{dir}}/t sniff {more}")).file("t", RTU).json().exits(0);
    for (more, heard, because) in [("--count 3", 3, "count"), ("--for 40ms", 4, "duration")] {
        let document = run(&format!("--protocol rtu {more}"));
        let data = &document.value["data"];
        assert_eq!((&data["heard"], &data["because"]), (&json!(heard), &json!(because)), "{more}");
    }
}

#[test]
fn ascii_and_vabus_are_heard_too() {
    let ascii =
        "# antrieb trace 1, 19200 7E1, ascii\n1000 < 3A 30 31 30 33 32 31 37 34\n9000 < 30 30 30 31 36 36 0D 0A\n";
    let output = antrieb("-p tape:{dir}/t sniff --protocol ascii").file("t", ascii).exits(0);
    assert!(output.out.contains("1.000  >") && output.out.contains("address 1: read P.372@2"), "{}", output.out);
    let vabus = "# antrieb trace 1, 19200 7E1, vabus\n1000 < 04 41 30 32 33 37 32 05 41 02 30 32 33 37 32 30 34 30 35 36 45 03 45\n";
    let output = antrieb("-p tape:{dir}/t sniff --protocol vabus").file("t", vabus).exits(0);
    assert!(
        output.out.contains(">  04 41") && output.out.contains("<  41 02") && output.out.contains("1390"),
        "{}",
        output.out
    );
}

#[test]
fn a_silent_line_is_4_a_foreign_one_5_and_a_gateway_is_none() {
    for line in ["-p sim sniff", "-p sim sniff --for 2s"] {
        let output = antrieb(line).json().exits(4);
        assert_eq!(output.error()["code"], "silence.nothing_heard");
        assert!(output.error()["hint"].as_str().unwrap().contains("never sends"));
    }
    let foreign = antrieb("-p tape:{dir}/t sniff --protocol vabus").file("t", RTU).json().exits(5);
    assert_eq!(foreign.error()["code"], "garbled.nothing_valid");
    assert_eq!(antrieb("-p mbtcp://localhost sniff").json().exits(2).error()["code"], "usage.no_line");
    assert_eq!(antrieb("-p sim sniff --dry-run").json().exits(0).data("/telegrams"), &json!([]));
}

#[test]
fn what_was_heard_can_be_recorded_and_heard_again() {
    let first = antrieb("-p tape:{dir}/t sniff --protocol rtu --trace {dir}/again").file("t", RTU).exits(0);
    let again = std::fs::read_to_string(first.directory().join("again")).unwrap();
    assert!(again.lines().skip(1).all(|line| line.contains('<')), "{again}");
    assert_eq!(antrieb("-p tape:{dir}/t sniff --protocol rtu").file("t", &again).exits(0).out, first.out);
}

/// Asked twice, answered; refused; everybody; asked and never answered; noise behind it.
const BUSY: &str = "# antrieb trace 1, 19200 8E1, rtu
1000000 < 01 03 21 74 00 01 CE 2C
1500000 < 01 03 21 74 00 01 CE 2C
1520000 < 01 03 02 05 6E 3A F8
1600000 < 01 03 21 74 00 01 CE 2C
1610000 < 01 83 02 C0 F1
1700000 < 03 06 41 78 00 0F 5C 09
1750000 < 55 AA
4000000 < 01 03 21 74 00 01 CE 2C
4012000 < 01 03 02 05 6E 3A F8
";

#[test]
fn what_became_of_every_question_is_counted_station_by_station() {
    let line = "-p tape:{dir}/t sniff --protocol rtu";
    let told = antrieb(line).file("t", BUSY).json().exits(0);
    let [one, three] = &told.data("/stations").as_array().unwrap()[..] else { panic!("{:#}", told.value) };
    let counts = |station: &Value| {
        ["address", "requests", "replies", "unanswered", "exceptions", "check_errors"]
            .map(|name| station[name].as_u64().unwrap())
    };
    assert_eq!((counts(one), counts(three)), ([1, 4, 3, 1, 1, 0], [3, 1, 0, 1, 0, 1]));
    assert_eq!(one["repeats"], json!([{ "times": 1, "questions": 1 }]));
    // The first byte of a reply came so long before it was handed over as its bytes take: 5 of 7 at 11 bits and 19200 baud.
    let times = ["fastest_us", "median_us", "slowest_us"].map(|name| one[name].as_u64().unwrap());
    assert!(
        (7_000..8_100).contains(&times[0]) && times[1] <= times[2] && (15_900..16_100).contains(&times[2]),
        "{times:?}"
    );
    assert!(told.data("/load_percent").as_f64().unwrap() > 0.1 && told.data("/garbled") == 1, "{:#}", told.value);
    for (lang, words) in
        [("en", ["bus load", "1x: 1", "no reflections"]), ("de", ["Buslast", "1x: 1", "keine Reflexionen"])]
    {
        let page = antrieb(&format!("--lang {lang} {line}")).file("t", BUSY).exits(0).out;
        words.iter().for_each(|word| assert!(page.contains(word), "{word}: {page}"));
    }
    let live = antrieb(&format!("{line} --statistics 1s --format ndjson")).file("t", BUSY).exits(0).out;
    let heard: Vec<Value> = live.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let counts: Vec<_> =
        heard.iter().filter(|record| record["type"] == "statistics").map(|record| &record["heard"]).collect();
    assert!(counts.len() > 3 && counts.contains(&&json!(1)) && counts.contains(&&json!(9)), "{counts:?}");
}

#[test]
fn only_what_is_wanted_is_told_and_everything_is_counted() {
    let told = |more: &str| {
        let run = antrieb(&format!("-p tape:{{dir}}/t sniff --protocol rtu {more}")).file("t", BUSY).json().exits(0);
        let at = |telegram: &Value| telegram["at_us"].as_u64().unwrap() / 1_000;
        (run.data("/telegrams").as_array().unwrap().iter().map(at).collect::<Vec<_>>(), run.data("/heard").clone())
    };
    assert_eq!(told("--filter 'address=3'"), (vec![1_700], json!(9)));
    assert_eq!(told("--filter refused --filter disturbed"), (vec![1_610, 1_750], json!(9)));
    assert_eq!(told("--trigger refused --pre 100ms --post 100ms"), (vec![1_520, 1_600, 1_610, 1_700], json!(9)));
    let (once, heard) = told("--trigger refused --pre 100ms --post 100ms --once --filter '!reply'");
    assert_eq!((once, heard.as_u64().unwrap() < 9), (vec![1_600, 1_700], true));
    assert!(antrieb("-p sim sniff --filter 'adress=3'").exits(2).err.contains("address=1,5-9"));
}

#[test]
fn a_capture_holds_what_was_told_and_stdout_can_be_one() {
    let line = "-p tape:{dir}/t sniff --protocol rtu --pcap {dir}/heard.pcap";
    let run = antrieb(line).file("t", RTU).exits(0);
    assert!(run.out.starts_with(TOLD), "{}", run.out);
    let capture = std::fs::read(run.directory().join("heard.pcap")).unwrap();
    assert_eq!(capture[..4], [0xD4, 0xC3, 0xB2, 0xA1]);
    // A head of 24 bytes, and 28 before the bytes of each of seven telegrams.
    assert_eq!(capture.len(), 24 + 7 * 28 + 8 + 7 + 8 + 8 + 8 + 5 + 2);
    let kept = antrieb(line).file("t", RTU).file("heard.pcap", "precious").exits(7);
    assert_eq!(kept.text_of("heard.pcap"), "precious");
    let empty = antrieb("-p sim sniff --duration 1s --pcap {dir}/none.pcap").exits(4);
    assert_eq!(std::fs::read(empty.directory().join("none.pcap")).unwrap().len(), 24);
    assert!(antrieb("-p sim --json sniff --pcap {dir}/x").exits(2).out.contains("usage.format"));
}
