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
