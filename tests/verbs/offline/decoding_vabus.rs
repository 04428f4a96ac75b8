//! Telegrams of VABus, whole, damaged and recorded.

use crate::run::antrieb;
use serde_json::json;

/// The telegrams that prove VABus (sources A4), and a node of the system bus: bytes, address, what is said.
const VABUS: &[(&str, u8, &str)] = &[
    ("04 41 30 32 33 37 32 05", 1, "address 1: read P.372@2 Rated Speed"),
    ("41 02 30 32 33 37 32 30 34 30 35 36 45 03 45", 1, "address 1: P.372@2 Rated Speed = 1390 1/min"),
    ("04 43 02 30 34 33 37 36 30 34 30 30 30 46 03 47", 3, "address 3: write P.376@4 Rated Mech. Power = 1.5 kW"),
    ("43 06", 3, "address 3: done (ACK)"),
    ("43 15", 3, "address 3: refused (NAK); P.11 tells why"),
    ("04 41 30 30 34 38 31 05", 1, "address 1: read P.481@0 Fixed Frequency 2"),
    ("41 02 30 30 34 38 31 30 38 30 30 30 30 30 33 45 38 03 48", 1, "address 1: P.481@0 Fixed Frequency 2 = 10.00 Hz"),
    (
        "04 41 02 30 30 34 38 30 30 38 46 46 46 46 44 31 32 30 03 40",
        1,
        "address 1: write P.480@0 Fixed Frequency 1 = -120.00 Hz",
    ),
    (
        "04 41 02 30 30 30 31 37 31 35 30 30 32 31 30 30 30 32 31 31 30 30 32 31 33 03 00",
        1,
        "address 1: write P.17@0 Block access: parameter list = \"002100021100213\"",
    ),
    (
        "41 02 30 30 30 31 39 31 36 30 30 30 30 32 41 35 44 30 30 36 36 30 30 32 38 03 34",
        1,
        "address 1: P.19@0 Block access: read values = \"00002A5D00660028\"",
    ),
    ("04 43 51 37 44 37 35 05", 3, "address 3: read system-bus node 17, P.1375@7 Modbus parity"),
    ("04 60 02 30 30 34 31 30 30 34 30 30 30 30 03 32", 32, "to everybody: write P.410@0 Control word = 0"),
];

#[test]
fn telegrams_of_vabus_are_known_without_being_told() {
    for (bytes, address, meaning) in VABUS {
        let document = antrieb(&format!("decode telegram {bytes}")).json().exits(0);
        let telegram = document.data("/telegrams/0");
        assert_eq!(telegram["protocol"], "vabus", "{bytes}");
        assert_eq!((&telegram["address"], &telegram["meaning"]), (&json!(address), &json!(meaning)), "{bytes}");
        let hex: Vec<&str> =
            telegram["fields"].as_array().unwrap().iter().map(|field| field["hex"].as_str().unwrap()).collect();
        assert_eq!(hex.join(" "), *bytes, "the fields are the telegram");
    }
}

#[test]
fn a_damaged_telegram_of_vabus_says_what_is_wrong() {
    let bytes = "41 02 30 32 33 37 32 30 34 30 35 36 45 03 44";
    let document = antrieb(&format!("--protocol vabus --lang de decode telegram {bytes}")).json().exits(5);
    let message = document.error()["message"].as_str().unwrap();
    assert_eq!(message, "kein gültiges Telegramm: Prüfzeichen 44h, erwartet 45h");
}

#[test]
fn a_recording_of_vabus_is_cut_into_telegrams() {
    let trace = "# antrieb trace 1, 19200 7E1, vabus\n0 > 04 41 30 32 33 37 32 05\n\
                 14000 < FF 41 02 30 32 33 37 32 30\n20000 < 34 30 35 36 45 03 45\n30000 > 04\n";
    let document = antrieb("decode trace {dir}/line.txt").file("line.txt", trace).json().exits(0);
    let telegrams = document.data("/telegrams").as_array().unwrap();
    let meanings: Vec<_> = telegrams.iter().map(|telegram| telegram["meaning"].as_str().unwrap()).collect();
    assert_eq!(
        meanings,
        [
            "address 1: read P.372@2 Rated Speed",
            "no valid telegram: FFh is no address (41h to 5Eh, 60h for all drives)",
            "address 1: P.372@2 Rated Speed = 1390 1/min",
            "end of the exchange",
        ]
    );
}
