//! `decode` of CAN: frames as people type them, logs of candump, and what went to and from an SLCAN adapter.

use crate::run::antrieb;
use serde_json::json;

/// Frames of the EM-RES-03 manual (chapter 5) and of CiA 301, with what is said of them in English and German.
const FRAMES: &[(&str, &str, &str)] = &[
    // 5.8.1
    (
        "000#0100",
        "NMT: to all nodes: Start Remote Node (PDOs begin, which can release a drive)",
        "NMT: an alle Knoten: Start Remote Node (PDOs beginnen, das kann einen Antrieb freigeben)",
    ),
    ("000#8105", "NMT: to node 5: Reset Node", "NMT: an Knoten 5: Reset Node"),
    ("080#", "SYNC", "SYNC"),
    ("705#00", "node 5: boot-up", "Knoten 5: Boot-Up"),
    // 5.9.3
    (
        "085#0010800000000122",
        "node 5: fault F2201 System bus timeout RxPDO1",
        "Knoten 5: Störung F2201 Systembus: Timeout RxPDO1",
    ),
    (
        "085#0000000000000000",
        "node 5: emergency cleared, the fault was acknowledged",
        "Knoten 5: Emergency aufgehoben, die Störung ist quittiert",
    ),
    // 5.10.1
    (
        "605#4074010200000000",
        "SDO1 node 5: read P.372@2 Rated Speed",
        "SDO1 Knoten 5: lesen P.372@2 Bemessungsdrehzahl",
    ),
    (
        "585#427401026E050000",
        "SDO1 node 5: P.372@2 Rated Speed = 1390 1/min",
        "SDO1 Knoten 5: P.372@2 Bemessungsdrehzahl = 1390 1/min",
    ),
    (
        "605#22A2030002000000",
        "SDO1 node 5: write P.930@0 TxPDO1 function = 2 (SYNC-controlled)",
        "SDO1 Knoten 5: schreiben P.930@0 TxPDO1 Function = 2 (SYNC-gesteuert)",
    ),
    (
        "585#60A2030000000000",
        "SDO1 node 5: written: P.930@0 TxPDO1 function",
        "SDO1 Knoten 5: geschrieben: P.930@0 TxPDO1 Function",
    ),
    (
        "585#8074010200000000",
        "SDO1 node 5: refused: P.372@2 Rated Speed: abort code 00000000h, no reason told",
        "SDO1 Knoten 5: abgelehnt: P.372@2 Bemessungsdrehzahl: Abbruchcode 00000000h, kein Grund genannt",
    ),
    (
        "5C5#42840300FFFF0000",
        "SDO2 node 5 (CANopen: 69): P.900@0 Node ID (system bus) = -1 (Off)",
        "SDO2 Knoten 5 (CANopen: 69): P.900@0 Node-ID (Systembus) = -1 (Aus)",
    ),
    (
        "5C5#42840300FFFFFFFF",
        "SDO2 node 5 (CANopen: 69): P.900@0 Node ID (system bus) = -1 (Off)",
        "SDO2 Knoten 5 (CANopen: 69): P.900@0 Node-ID (Systembus) = -1 (Aus)",
    ),
    // CiA 301
    (
        "585#8000100000000206",
        "SDO1 node 5: refused: object 1000h:0: abort code 06020000h, no such object",
        "SDO1 Knoten 5: abgelehnt: Objekt 1000h:0: Abbruchcode 06020000h, kein solches Objekt",
    ),
    (
        "585#410810000C000000",
        "SDO1 node 5: object 1008h:0 = 12 bytes follow in pieces",
        "SDO1 Knoten 5: Objekt 1008h:0 = 12 Byte folgen in Teilstücken",
    ),
    ("585#1D21000000000000", "SDO1 node 5: last piece 21", "SDO1 Knoten 5: letztes Teilstück 21"),
    // PDOs are raw: no scale is printed.
    (
        "182#0F00000040420F00",
        "TxPDO1 of node 2: words 000Fh 0000h 4240h 000Fh",
        "TxPDO1 von Knoten 2: Worte 000Fh 0000h 4240h 000Fh",
    ),
    ("1FFFFFFF#00", "29-bit identifier: not of the system bus", "29-Bit-Identifier: nicht vom Systembus"),
];

#[test]
fn every_frame_is_told_in_both_languages() {
    for (frame, en, de) in FRAMES {
        for (lang, said) in [("en", en), ("de", de)] {
            let run = antrieb(&format!("decode can {frame} --lang {lang}")).json().exits(0);
            assert_eq!(run.value["data"]["telegrams"][0]["meaning"], **said, "{frame}");
        }
    }
}

#[test]
fn a_refusal_of_a_drive_is_told_by_its_error_register() {
    let run = antrieb("decode can 585#800F270B0B000000 585#807401020B000000").json().exits(0);
    let told = &run.value["data"]["telegrams"];
    assert_eq!(told[1]["raw"], 11);
    assert!(told[1]["meaning"].as_str().unwrap().starts_with("SDO1 node 5: refused: P.372@2 Rated Speed: error 11, "));
    assert!(told[0]["meaning"].as_str().unwrap().contains("object 270Fh:11"));
}

#[test]
fn slcan_and_blanks_say_the_same_as_a_log() {
    let telegrams = |line: &str| antrieb(line).json().exits(0).value["data"]["telegrams"].clone();
    let log = telegrams("decode can 585#427401026E050000");
    assert_eq!(telegrams("decode can 585#42 74 01 02 6E 05 00 00"), log);
    assert_eq!(telegrams("decode can t5858427401026E050000"), log);
    let one = &log[0];
    assert_eq!(
        json!([one["protocol"], one["address"], one["identifier"], one["service"], one["channel"]]),
        json!(["can", 5, 0x585, "sdo_reply", 1])
    );
    assert_eq!(json!([one["param"], one["data_set"], one["raw"]]), json!([372, 2, 1390]));
}

#[test]
fn what_is_no_frame_is_refused_and_what_is_damaged_is_told() {
    antrieb("decode can 605#4").exits(2);
    antrieb("decode can 123##1AABB").exits(2);
    antrieb("decode can hello").exits(2);
    let run = antrieb("decode can 605#4074").json().exits(5);
    assert_eq!(run.value["error"]["message"], "no valid frame: expected eight bytes");
}

#[test]
fn a_log_of_candump_is_read_and_written() {
    let log = "(1436509052.000000) can0 705#00\n(1436509052.003500) can0 000#0100\n\
               (1436509053.500000) can0 20000040#0000000000000000\n";
    let run = antrieb("decode trace {dir}/bus.log").file("bus.log", log).json().exits(0);
    let told = run.value["data"]["telegrams"].as_array().unwrap();
    assert_eq!(told.iter().map(|one| one["at_us"].as_u64().unwrap()).collect::<Vec<_>>(), [0, 3_500, 1_500_000]);
    assert_eq!(json!([told[0]["interface"], told[2]["service"]]), json!(["can0", "trouble"]));
    assert_eq!(told[2]["meaning"], "the CAN interface reports: BUS-OFF");
    let run = antrieb("decode trace {dir}/bus.log --candump {dir}/again.log").file("bus.log", log).exits(0);
    assert_eq!(run.text_of("again.log"), log);
    let again = run.then("decode trace {dir}/bus.log --candump {dir}/again.log").exits(7);
    assert!(again.err.contains("--force"), "{}", again.err);
}

#[test]
fn what_an_adapter_said_is_told_word_by_word() {
    let said = "V\rV1013\rS6\r\rO\r\u{7}t0000EA5F\rt7051000001\rt70\r";
    let run = antrieb("decode trace {dir}/heard").file("heard", said).json().exits(0);
    let told = run.value["data"]["telegrams"].as_array().unwrap();
    let meanings: Vec<&str> = told.iter().map(|one| one["meaning"].as_str().unwrap()).collect();
    assert_eq!(
        meanings[..5],
        [
            "to the adapter: ask for the version",
            "adapter: version 1013",
            "to the adapter: bit rate 500 kbit/s",
            "to the adapter: open the channel",
            "adapter: refused (BEL)",
        ]
    );
    assert_eq!(json!([told[6]["at_us"], told[7]["check_ok"]]), json!([2_000, false]), "a new minute; a torn frame");
    let run = antrieb("decode trace {dir}/heard --candump {dir}/bus.log").file("heard", said).exits(0);
    assert_eq!(run.text_of("bus.log"), "(0000000059.999000) can0 000#\n(0000000060.001000) can0 705#00\n");
}

/// What a verb recorded over CAN is told with its times, who said it, and in words; it becomes a log of candump.
#[test]
fn a_recording_of_our_own_over_can_is_told_frame_by_frame() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 5\n";
    let run = antrieb("--protocol sdo -a 5 --drive acu read 411 1234 --trace {dir}/t").on(bench).exits(9);
    let recorded = run.text_of("t");
    assert!(recorded.starts_with("# antrieb trace 1, CAN 500 kbit/s, sdo\n"), "{recorded}");
    let bare = recorded.split_once('\n').unwrap().1;
    let told =
        |line: &str| antrieb(line).file("t", &recorded).file("bare", bare).json().exits(0).data("/telegrams").clone();
    let whole = told("decode trace {dir}/t");
    for line in
        ["decode trace {dir}/bare", "--protocol sdo decode trace {dir}/bare", "--protocol sdo decode trace {dir}/t"]
    {
        assert_eq!(told(line), whole, "{line}");
    }
    let rows: Vec<_> = whole.as_array().unwrap().iter().filter(|row| row["service"] != "adapter").collect();
    let pick =
        |row: &serde_json::Value| json!([row["service"], row["address"], row["param"], row["sent"], row["direction"]]);
    assert_eq!(pick(rows[0]), json!(["sdo_request", 5, 411, true, "request"]));
    assert_eq!(pick(rows[1]), json!(["sdo_reply", 5, 411, false, "reply"]));
    assert!(rows[0]["at_us"].as_u64().unwrap() > 1_250_000, "since the port was opened: {}", rows[0]);
    let last = rows.last().unwrap()["meaning"].as_str().unwrap();
    assert!(last.starts_with("SDO2 node 5 (CANopen: 69): refused: P.1234@0: error 11"), "{last}");
    assert!(whole.as_array().unwrap().iter().all(|row| row["check_ok"] == true), "{whole}");
    let run = antrieb("decode trace {dir}/t --candump {dir}/log").file("t", &recorded).exits(0);
    let log = run.text_of("log");
    assert_eq!(log.lines().count(), rows.len());
    assert!(log.lines().next().unwrap().ends_with("can0 645#409B010000000000"), "{log}");
    assert!(run.out.contains("to the adapter: bit rate 500 kbit/s"), "{}", run.out);
}

/// Words fall apart as the adapter hands them over; what is none is marked, and the rest is told.
#[test]
fn a_recording_over_can_is_read_however_its_pieces_fall() {
    let text = "# antrieb trace 1, CAN 500 kbit/s, sdo\n\
                10 > 0D\n\
                1000 < 74 30 30 30 32 30 31\n1200 < 30 30 0D 74 30 38 30 30 0D\n\
                2000 < 74 30 38 35 38 30 30 31 30 38 30 30 30 30 30 30 30 30 31 32 32 0D\n\
                3000 < 74 37 30 35 31 37 46 0D 07\n\
                4000 < FF 00 41 0D\n\
                # 4500 CAN 250 kbit/s\n\
                5000 < 74 35 38 35\n";
    let run = antrieb("decode trace {dir}/t").file("t", text).json().exits(0);
    let rows = run.data("/telegrams").as_array().unwrap();
    let told: Vec<_> =
        rows.iter().map(|row| (row["at_us"].as_u64().unwrap(), row["meaning"].as_str().unwrap())).collect();
    assert_eq!(
        told[..6],
        [
            (10, "to the adapter: end what was begun"),
            (1_000, "NMT: to all nodes: Start Remote Node (PDOs begin, which can release a drive)"),
            (1_200, "SYNC"),
            (2_000, "node 5: fault F2201 System bus timeout RxPDO1"),
            (3_000, "node 5: heartbeat, Pre-Operational; the drives send none"),
            (3_000, "adapter: refused (BEL)"),
        ]
    );
    assert_eq!((told.len(), &rows[6]["check_ok"], &rows[7]["check_ok"]), (8, &json!(false), &json!(false)));
    let broken = antrieb("decode trace {dir}/t").file("t", &format!("{text}6000 < 7")).json().exits(7);
    assert!(broken.error()["message"].as_str().unwrap().contains("line 10: expected"), "{}", broken.error());
    let packed = antrieb("decode trace {dir}/t").file("t", text);
    std::fs::write(packed.directory().join("t"), [0x1F, 0x8B, 8, 0, 0]).unwrap();
    assert!(packed.json().exits(7).error()["message"].as_str().unwrap().contains("packed with gzip"));
}
