//! The worked cases of issue 2, in RTU and in ASCII: what is read, what is written, what the drive refuses and why.

use crate::run::{Document, Run, antrieb};

const ASCII: &str = "[[drive]]\nmodel = \"act\"\naddress = 1\nprotocol = \"ascii\"\n\
                     [[drive]]\nmodel = \"acu\"\naddress = 2\nprotocol = \"ascii\"\n";

/// A line on the standard drives in RTU, and on the same drives in ASCII.
fn both(line: &str) -> [Run; 2] {
    [antrieb(&format!("-p sim {line}")), antrieb(&format!("--protocol ascii {line}")).on(ASCII)]
}

#[track_caller]
fn refused(run: Run, cause: &str, code: &str) -> Document {
    let document = run.json().exits(6);
    assert_eq!(document.error()["class"], "refused");
    assert_eq!(document.error()["code"], code);
    assert_eq!(document.error()["context"]["p11"], cause);
    assert_eq!(document.error()["context"]["exception"], "4");
    assert_eq!(document.error()["context"]["address"], "1");
    assert!(document.error()["hint"].is_string());
    document
}

#[test]
fn five_parameters_are_read() {
    for run in both("-a 1 read 372@2 481 411 260 270") {
        let document = run.json().exits(0);
        let values = document.data("/values").as_array().unwrap();
        let read: Vec<_> = values
            .iter()
            .map(|value| (value["param"].as_u64().unwrap(), value["data_set"].as_u64().unwrap(), &value["value"]))
            .map(|(param, set, value)| format!("{param}@{set}={value}"))
            .collect();
        assert_eq!(read, ["372@2=1390", "481@0=10.0", "411@0=35", "260@0=0", "270@0=0"]);
        assert_eq!(document.data("/values/0/unit"), "1/min");
        assert_eq!(document.data("/values/1/raw"), 1000);
        assert_eq!(document.data("/values/1/decimals"), 2);
        assert_eq!(document.data("/values/2/word/state/slug"), "switched-on");
        assert_eq!(document.data("/values/3/text"), "no fault");
        assert_eq!(document.data("/values/4/word/hex"), "0x0000");
    }
}

#[test]
fn the_printed_telegrams_go_over_the_line() {
    let [rtu, ascii] = both("-v -a 1 read 372@2 481");
    let (rtu, ascii) = (rtu.exits(0), ascii.exits(0));
    // CM-485 manual 8.1.1 and 8.1.3, 8.2.1 and 8.2.3.
    assert!(rtu.sent().contains(&"01 03 21 74 00 01 CE 2C".to_owned()), "{}", rtu.err);
    assert!(rtu.telegrams('<').contains(&"01 03 02 05 6E 3A F8".to_owned()), "{}", rtu.err);
    assert!(rtu.sent().contains(&"01 64 01 E1 81 DF".to_owned()), "{}", rtu.err);
    assert!(rtu.telegrams('<').contains(&"01 64 00 00 03 E8 70 BC".to_owned()), "{}", rtu.err);
    let hex = |text: &str| text.bytes().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ");
    assert!(ascii.sent().contains(&hex(":01032174000166\r\n")), "{}", ascii.err);
    assert!(ascii.telegrams('<').contains(&hex(":010302056E87\r\n")), "{}", ascii.err);
}

#[test]
fn a_power_is_written_with_its_unit() {
    for run in both("-a 1 --yes write 376@4=1.5kW") {
        let document = run.json().exits(0);
        assert_eq!(document.data("/values/0/old"), 0.8);
        assert_eq!(document.data("/values/0/value"), 1.5);
        assert_eq!(document.data("/values/0/raw"), 15);
        assert_eq!(document.data("/values/0/data_set"), 4);
        assert_eq!(document.data("/values/0/store"), "eeprom");
        assert_eq!(document.data("/values/0/result"), "verified");
    }
    // The telegram of the manual's example (8.1.2, station 3).
    let station = "[[drive]]\nmodel = \"act\"\naddress = 3\n";
    let run = antrieb("-a 3 --drive act --yes -v write 376@4=1.5kW").on(station).exits(0);
    assert!(run.sent().contains(&"03 06 41 78 00 0F 5C 09".to_owned()), "{}", run.err);
}

#[test]
fn a_power_of_nothing_is_refused_by_the_drive() {
    for run in both("-a 1 --yes write 376@2=0") {
        let document = refused(run, "1", "refused.value_not_permitted");
        assert_eq!(document.data("/values/0/result"), "refused");
        assert_eq!(document.data("/values/0/error/context/p11"), "1");
    }
}

#[test]
fn a_rated_frequency_of_9_hertz_is_refused_by_the_drive() {
    for run in both("-a 1 --yes write 375@2=9Hz") {
        refused(run, "1", "refused.value_not_permitted");
    }
    antrieb("-p sim -a 1 --yes write 375@2=10Hz").exits(0);
}

#[test]
fn a_parameter_beyond_the_last_is_refused_by_the_drive() {
    for run in both("-a 1 read 1600@2 --type long") {
        let document = refused(run, "11", "refused.unknown_parameter");
        assert_eq!(document.data("/values/0/raw"), &serde_json::Value::Null);
        assert_eq!(document.data("/values/0/error/exit"), 6);
    }
    let run = antrieb("-p sim -a 1 -v read 1600@2 --type long").exits(6);
    assert!(run.sent().contains(&"01 64 26 40 5B 97".to_owned()), "CM-485 manual 8.1.3: {}", run.err);
}

#[test]
fn the_status_word_is_refused_by_us_and_with_force_by_the_drive() {
    for run in both("-a 1 --yes write 411=1") {
        let document = run.json().exits(7);
        assert_eq!(document.error()["code"], "data.read_only");
        assert!(document.error()["hint"].as_str().unwrap().contains("--force"));
    }
    for run in both("-a 1 --yes write 411=1 --force") {
        refused(run, "4", "refused.not_writable");
    }
}

#[test]
fn the_refusal_is_told_in_the_language_of_the_user() {
    let run = antrieb("-p sim -a 1 --lang de read 1600@2 --type long").exits(6);
    assert!(run.err.contains("P.11 = 11: Unbekannter Parameter"), "{}", run.err);
}
