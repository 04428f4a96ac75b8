//! `sniff` on a CAN bus: every frame in words, in every form, and nothing of our own.

use crate::run::antrieb;
use antrieb::transport::witness;
use serde_json::{Value, json};

/// A master drive that beats its time, a node with a PDO, and somebody who asks over SDO1: an answer, a refusal, nobody there.
const BUS: &str = "[[foreign]]\nframe = \"605#409B010000000000\"\nevery = \"500ms\"\n\
    [[foreign]]\nframe = \"605#40D2040000000000\"\nevery = \"730ms\"\n\
    [[foreign]]\nframe = \"609#409B010000000000\"\nevery = \"900ms\"\n\
    [[foreign]]\nframe = \"00000123#01\"\nevery = \"800ms\"\n\
    [[drive]]\nmodel = \"acu\"\naddress = 0\nset = { \"919\" = 100, \"904\" = 2000 }\n\
    [[drive]]\nmodel = \"acu\"\naddress = 5\nset = { \"930\" = 1, \"931\" = 50, \"950\" = 740 }\n";

fn left_alone() {
    let bus = witness::left_can().unwrap();
    assert!(bus.counts()[0] == 0 && bus.orders().is_empty() && !bus.is_open(), "{:?}", bus.remarks());
}

#[test]
fn every_frame_of_a_bus_is_told_and_nothing_is_sent() {
    let run = antrieb("--protocol sdo sniff --duration 5s").on(BUS).exits(0);
    left_alone();
    for told in [
        "080#",
        "SDO1 node 5: read P.411@0 Status word",
        "SDO1 node 5: P.411@0 Status word = ",
        "SDO1 node 5: refused: P.1234@0: error 11, Unknown parameter",
        "TxPDO1 of node 5: words",
        "29-bit identifier: not of the system bus",
        "bus load",
        "acknowledges nothing",
    ] {
        assert!(run.out.contains(told), "{told}\n{}", run.out);
    }
    antrieb("--lang de --protocol sdo sniff --duration 5s").on(BUS).exits(0);
    let run = antrieb("--protocol sdo sniff --duration 5s").on(BUS).json().exits(0);
    let data = &run.value["data"];
    assert_eq!(json!([data["protocol"], data["line"], data["because"]]), json!(["sdo", "CAN 500 kbit/s", "duration"]));
    let counted: Vec<_> = data["stations"].as_array().unwrap().iter().map(|row| row["address"].clone()).collect();
    assert_eq!(counted, [json!(5), json!(9)], "who is asked over SDO");
    let [five, nine] = &data["stations"].as_array().unwrap()[..] else { panic!("{data}") };
    assert!(five["requests"].as_u64() >= Some(15) && five["unanswered"] == 0, "{five}");
    assert!(five["exceptions"].as_u64() >= Some(5) && five["fastest_us"].as_u64() > Some(0), "{five}");
    assert!(nine["unanswered"].as_u64() >= Some(4) && nine["replies"] == 0, "{nine}");
}

#[test]
fn what_is_wanted_of_a_bus_is_told_in_every_form() {
    let wanted = "--protocol sdo sniff --duration 5s --format ndjson --filter 'address=5 refused'";
    let stream = antrieb(wanted).on(BUS).exits(0);
    let records: Vec<Value> = stream.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let (end, told) = records.split_last().unwrap();
    assert!(told.iter().all(|row| row["service"] == "sdo_reply" && row["raw"] == 11), "{told:?}");
    assert!(told.len() >= 5 && end["summary"]["heard"].as_u64() > Some(50), "{end}");
    let run = antrieb("--protocol sdo sniff --count 4 --pcap {dir}/bus.pcap --trace {dir}/t").on(BUS).exits(0);
    assert_eq!(std::fs::read(run.directory().join("bus.pcap")).unwrap()[20..24], [227, 0, 0, 0]);
    let told = |out: &str| out.lines().take(4).map(|line| line[12..].to_owned()).collect::<Vec<_>>();
    let first = told(&run.out);
    // The recording is read, and plays back.
    let recorded = run.text_of("t");
    let decoded = antrieb("decode trace {dir}/t").file("t", &recorded).json().exits(0);
    let rows = decoded.data("/telegrams").as_array().unwrap();
    assert!(rows.iter().any(|row| row["meaning"] == "to the adapter: open the channel to listen only"), "{rows:?}");
    assert!(rows.iter().all(|row| row["service"] == "adapter" || row["sent"] == false), "{rows:?}");
    let again = antrieb("-p tape:{dir}/t --protocol sdo -b 500000 sniff --count 4").file("t", &recorded).exits(0);
    assert_eq!(told(&again.out), first);
}

/// What an adapter says that is no word of it is told and counted, and so is that it lost frames itself.
#[test]
fn what_an_adapter_spoils_or_loses_is_told() {
    let run = antrieb("--protocol sdo sniff --duration 2s --trace {dir}/t").on(BUS).exits(0);
    assert!(!run.out.contains("overrun"), "{}", run.out);
    let whole = run.text_of("t");
    // Of a question (t6058…) the length is torn, and the status flags tell of an overrun.
    let (before, behind) = whole.rsplit_once("74 36 30 35 38 ").unwrap();
    let torn = format!("{before}74 36 30 35 58 {behind}").replace("46 30 30 0D", "46 30 39 0D");
    assert!(torn.contains("46 30 39 0D"), "{whole}");
    let sniff = "-p tape:{dir}/t --protocol sdo -b 500000 sniff --duration 2s";
    let run = antrieb(sniff).file("t", &torn).exits(0);
    assert!(run.out.contains("t605X4") && run.out.contains("it lost frames (overrun)"), "{}", run.out);
    let run = antrieb(sniff).file("t", &torn).json().exits(0);
    assert_eq!(*run.data("/garbled"), json!(1), "{:#}", run.value["data"]);
}

#[test]
fn what_means_nothing_on_a_bus_is_refused_and_a_silent_one_is_told() {
    for (more, why) in [
        ("--search", "serial line"),
        ("--filter function=3", "function code"),
        ("--trigger function=3", "function code"),
        ("--cfg ppo1", "PROFIBUS"),
    ] {
        let run = antrieb(&format!("--protocol sdo sniff {more}")).on(BUS).json().exits(2);
        assert!(run.error()["message"].as_str().unwrap().contains(why), "{more}: {}", run.error());
    }
    let silent = antrieb("--protocol sdo sniff").on("[[drive]]\nmodel = \"acu\"\naddress = 5\n").json().exits(4);
    assert_eq!(silent.error()["code"], "silence.nothing_heard");
    left_alone();
    let other = format!("[bus]\nrate = 250000\n{BUS}");
    let run = antrieb("--protocol sdo sniff --duration 3s").on(&other).json().exits(5);
    assert_eq!(run.error()["code"], "garbled.bit_rate");
}
