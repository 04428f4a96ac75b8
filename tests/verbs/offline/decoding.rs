//! `decode` and `params`: what bytes, words and codes say, without a drive.

use super::decoding_lexium::ascii;
use crate::run::antrieb;
use serde_json::json;

/// Every telegram printed in chapter 8 of the CM-485 manual: line, bytes, function code, what is said.
/// (The misprint at line 1622 is corrected: sources G1.)
const PRINTED: &[(u32, &str, u8, &str)] = &[
    (1321, "01 03 21 74 00 01 CE 2C", 3, "address 1: read P.372@2 Rated Speed, 16 bit"),
    (1326, "01 03 02 05 6E 3A F8", 3, "address 1: value 1390 (0x056E)"),
    (1337, "01 03 01 74 00 02 85 ED", 3, "address 1: read 2 registers, P.372@0 Rated Speed"),
    (1342, "01 83 02 C0 F1", 3, "address 1: refuses function code 3, exception 2 (illegal data address)"),
    (1357, "03 06 41 78 00 0F 5C 09", 6, "address 3: write P.376@4 Rated Mech. Power = 1.5 kW (request, or its echo)"),
    (1362, "03 06 41 78 00 0F 5C 09", 6, "address 3: write P.376@4 Rated Mech. Power = 1.5 kW (request, or its echo)"),
    (1373, "03 06 21 78 00 00 02 0D", 6, "address 3: write P.376@2 Rated Mech. Power = 0.0 kW (request, or its echo)"),
    (1378, "03 86 04 E2 63", 6, "address 3: refuses function code 6, exception 4 (slave device failure)"),
    (1391, "01 64 01 E1 81 DF", 100, "address 1: read P.481@0 Fixed Frequency 2, 32 bit"),
    (1396, "01 64 00 00 03 E8 70 BC", 100, "address 1: value 1000 (0x000003E8)"),
    (1409, "01 64 26 40 5B 97", 100, "address 1: read P.1600@2, 32 bit"),
    (1414, "01 E4 04 6A C3", 100, "address 1: refuses function code 100, exception 4 (slave device failure)"),
    (
        1431,
        "01 65 21 77 00 00 03 E8 46 C5",
        101,
        "address 1: write P.375@2 Rated Frequency = 10.00 Hz (request, or its echo)",
    ),
    (
        1436,
        "01 65 21 77 00 00 03 E8 46 C5",
        101,
        "address 1: write P.375@2 Rated Frequency = 10.00 Hz (request, or its echo)",
    ),
    (
        1449,
        "01 65 21 77 00 00 03 84 46 E8",
        101,
        "address 1: write P.375@2 Rated Frequency = 9.00 Hz (request, or its echo)",
    ),
    (1454, "01 E5 04 6B 53", 101, "address 1: refuses function code 101, exception 4 (slave device failure)"),
    (1467, "01 08 00 0A 00 00 C0 09", 8, "address 1: diagnostics, clear all counters (request, or its echo)"),
    (1472, "01 08 00 0A 00 00 C0 09", 8, "address 1: diagnostics, clear all counters (request, or its echo)"),
    (1483, "01 08 00 0E 00 00 81 C8", 8, "address 1: diagnostics, Messages to this drive (request, or its echo)"),
    (1488, "01 08 00 0E 00 01 40 08", 8, "address 1: diagnostics, Messages to this drive (request, or its echo)"),
    (1499, "01 08 00 13 00 00 11 CE", 8, "address 1: diagnostics, sub-function 0x13 (request, or its echo)"),
    (1504, "01 88 01 87 C0", 8, "address 1: refuses function code 8, exception 1 (illegal function)"),
    (1520, "3A 30 31 30 33 32 31 37 34 30 30 30 31 36 36 0D 0A", 3, "address 1: read P.372@2 Rated Speed, 16 bit"),
    (1526, "3A 30 31 30 33 30 32 30 35 36 45 38 37 0D 0A", 3, "address 1: value 1390 (0x056E)"),
    (1537, "3A 30 31 30 33 30 31 37 34 30 30 30 32 38 35 0D 0A", 3, "address 1: read 2 registers, P.372@0 Rated Speed"),
    (
        1543,
        "3A 30 31 38 33 30 32 37 41 0D 0A",
        3,
        "address 1: refuses function code 3, exception 2 (illegal data address)",
    ),
    (1559, ":03064178000F2F", 6, "address 3: write P.376@4 Rated Mech. Power = 1.5 kW (request, or its echo)"),
    (1565, ":03064178000F2F", 6, "address 3: write P.376@4 Rated Mech. Power = 1.5 kW (request, or its echo)"),
    (1577, ":0306217800005E", 6, "address 3: write P.376@2 Rated Mech. Power = 0.0 kW (request, or its echo)"),
    (1583, ":03860473", 6, "address 3: refuses function code 6, exception 4 (slave device failure)"),
    (1597, ":016401E1B9", 100, "address 1: read P.481@0 Fixed Frequency 2, 32 bit"),
    (1603, ":0164000003E8B0", 100, "address 1: value 1000 (0x000003E8)"),
    (1616, ":0164264035", 100, "address 1: read P.1600@2, 32 bit"),
    (1622, ":01E40417", 100, "address 1: refuses function code 100, exception 4 (slave device failure)"),
    (1639, ":01652177000003E817", 101, "address 1: write P.375@2 Rated Frequency = 10.00 Hz (request, or its echo)"),
    (1645, ":01652177000003E817", 101, "address 1: write P.375@2 Rated Frequency = 10.00 Hz (request, or its echo)"),
    (1659, ":01652177000003847B", 101, "address 1: write P.375@2 Rated Frequency = 9.00 Hz (request, or its echo)"),
    (1665, ":01E50416", 101, "address 1: refuses function code 101, exception 4 (slave device failure)"),
    (1679, ":0108000A0000ED", 8, "address 1: diagnostics, clear all counters (request, or its echo)"),
    (1685, ":0108000A0000ED", 8, "address 1: diagnostics, clear all counters (request, or its echo)"),
    (1697, ":0108000E0000E9", 8, "address 1: diagnostics, Messages to this drive (request, or its echo)"),
    (1703, ":0108000E0001E8", 8, "address 1: diagnostics, Messages to this drive (request, or its echo)"),
    (1715, ":010800130000E4", 8, "address 1: diagnostics, sub-function 0x13 (request, or its echo)"),
    (1721, ":01880176", 8, "address 1: refuses function code 8, exception 1 (illegal function)"),
];

#[test]
fn all_44_printed_telegrams_are_explained() {
    assert_eq!(PRINTED.len(), 44);
    let mut wrong = Vec::new();
    for (line, bytes, function, meaning) in PRINTED {
        let document = antrieb(&format!("decode telegram {bytes}")).json().exits(0);
        let telegram = document.data("/telegrams/0");
        assert_eq!(telegram["check_ok"], true, "line {line}");
        assert_eq!(telegram["function"], *function, "line {line}");
        let ascii = bytes.starts_with([':']) || bytes.starts_with("3A");
        assert_eq!(telegram["protocol"], if ascii { "ascii" } else { "rtu" }, "line {line}");
        if telegram["meaning"] != *meaning {
            wrong.push(format!("line {line}: {} in place of {meaning}", telegram["meaning"]));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn codes_of_other_families_are_plain_registers_without_one() {
    for (pdu, meaning) in [
        ("10 1B 02 00 02 04 00 00 00 06", "write register 6914 = 0 (0x0000), register 6915 = 6 (0x0006)"),
        ("10 1B 02 00 02", "2 registers from 6914 written"),
        (
            "17 1B 04 00 02 1B 02 00 02 04 00 00 00 06",
            "write register 6914 = 0 (0x0000), register 6915 = 6 (0x0006), then read 2 registers from 6916",
        ),
        ("17 04 00 00 00 21", "value 0 (0x0000), 33 (0x0021)"),
        ("2B 0E 01 02 00 00 01 03 07 56 30 32 2E 30 30 31", "identification: object 3 \"V02.001\""),
    ] {
        let document = antrieb(&format!("decode telegram '{}'", ascii(pdu))).json().exits(0);
        assert_eq!(document.data("/telegrams/0/meaning"), &json!(format!("address 1: {meaning}")), "{pdu}");
    }
}

#[test]
fn a_telegram_whose_lengths_contradict_each_other_says_so() {
    let telegram = ascii("10 1B 02 00 02 02 00 06");
    for (lang, meaning) in [
        ("en", "address 1: function code 16: 7 data bytes, expected 9"),
        ("de", "Adresse 1: Funktionscode 16: 7 Datenbytes, erwartet 9"),
    ] {
        let document = antrieb(&format!("--lang {lang} decode telegram '{telegram}'")).json().exits(0);
        assert_eq!(document.data("/telegrams/0/meaning"), meaning);
    }
}

/// Once the drive is known, what goes over the line is told in its words.
#[test]
fn the_telegrams_of_a_session_name_parameters() {
    let bench = "[[drive]]\nmodel = \"lxm05\"\naddress = 1\nset = { MBdword_order = 1 }\n";
    let run = antrieb("-v -a 1 --yes write PPp_targetusr=-3").on(bench).exits(0);
    for told in [
        "read identification: basic objects, from vendor name",
        "read MBadr (5640) Modbus address",
        "write PPp_targetusr (6940) Target position (point-to-point) = -3 usr, then read PPp_targetusr (6940)",
        "value -3 (0xFFFFFFFD)",
    ] {
        assert!(run.err.contains(told), "{told}: {}", run.err);
    }
    let refused = antrieb("-v -a 1 --drive lxm05 read 9998").on(bench).exits(6).err;
    assert!(refused.contains("diagnostics, last synchronous error: 0x0002"), "{refused}");
}

#[test]
fn a_telegram_is_taken_apart_field_by_field() {
    let document = antrieb("decode telegram 01 03 21 74 00 01 CE 2C").json().exits(0);
    let fields = document.data("/telegrams/0/fields").as_array().unwrap();
    let hex: Vec<_> = fields.iter().map(|field| field["hex"].as_str().unwrap()).collect();
    assert_eq!(hex, ["01", "03", "21 74", "00 01", "CE 2C"]);
    assert_eq!(fields[2]["value"], "P.372@2 Rated Speed");
}

#[test]
fn bytes_are_taken_however_they_are_typed() {
    let expected = antrieb("decode telegram 01 03 21 74 00 01 CE 2C").exits(0).out;
    for typed in ["01032174 0001CE2C", "0x01,0x03,0x21,0x74,0x00,0x01,0xCE,0x2C", "01-03-21-74-00-01-ce-2c"] {
        assert_eq!(antrieb(&format!("decode telegram {typed}")).exits(0).out, expected, "{typed}");
    }
    antrieb("decode telegram ':0103 2174 0001 66\\r\\n'").exits(0);
}

#[test]
fn what_is_no_telegram_is_said_to_be_none() {
    let document = antrieb("decode telegram 01 03 21 74 00 01 CE 2D").json().exits(5);
    assert_eq!(document.data("/telegrams/0/check_ok"), false);
    for bytes in ["zz", "0", "''", "01 0x"] {
        antrieb(&format!("decode telegram {bytes}")).json().exits(2);
    }
    for bytes in ["01", "00 00", ":", ":01032174000167", "FF FF FF FF"] {
        antrieb(&format!("decode telegram {bytes}")).json().exits(5);
    }
}

#[test]
fn the_status_word_depends_on_the_drive() {
    let bit4 = |drive: &str| {
        let document = antrieb(&format!("--drive {drive} decode status 0x0237")).json().exits(0);
        assert_eq!(document.data("/word/state/slug"), "operation-enabled");
        let bits = document.data("/word/bits").as_array().unwrap().clone();
        bits.into_iter().find(|bit| bit["bit"] == 4).unwrap()["slug"].clone()
    };
    assert_eq!((bit4("act"), bit4("acu")), (json!("voltage-disabled"), json!("voltage-enabled")));
}

#[test]
fn every_state_of_the_status_word_has_a_name() {
    // CM-485 manual 9.1.2 and 10.2: bits 6, 5, 3, 2, 1, 0.
    for (word, state) in [
        ("0x0000", "not-ready"),
        ("0x0040", "switch-on-disabled"),
        ("0x0021", "ready-to-switch-on"),
        ("0x0023", "switched-on"),
        ("0x0027", "operation-enabled"),
        ("0x0007", "quick-stop-active"),
        ("0x000F", "fault-reaction-active"),
        ("0x0008", "fault"),
    ] {
        let document = antrieb(&format!("decode status {word}")).json().exits(0);
        assert_eq!(document.data("/word/state/slug"), state, "{word}");
    }
}

/// The reply alone does not say what was asked; beside its request it is told like what `read` tells.
#[test]
fn a_reply_beside_its_request_says_what_it_answers() {
    for (pair, says) in [
        ("01 03 01 E0 00 01 84 00 01 03 02 04 E2 3A CD", "address 1: P.480@0 Fixed Frequency 1 = 12.50 Hz"),
        (
            "01 03 01 9B 00 01 F4 19 01 03 02 02 37 F8 F2",
            "address 1: P.411@0 Status word = 0x0237 (Operation enabled: Ready to switch on",
        ),
        ("01 03 01 9C 00 01 45 D8 01 03 02 00 01 79 84", "address 1: P.412@0 Local/Remote = 1 (State machine)"),
        ("01 64 00 D2 C0 5A 01 64 00 00 03 E8 70 BC", "address 1: P.210@0 Stator frequency = 10.00 Hz"),
        ("01 03 01 E0 00 01 84 00 01 83 04 40 F3", "(asked for: address 1: read P.480@0 Fixed Frequency 1, 16 bit)"),
    ] {
        let told = antrieb(&format!("--drive act decode telegram {pair}")).json().exits(0);
        let meaning = told.data("/telegrams/1/meaning").as_str().unwrap();
        assert!(meaning.contains(says), "{meaning}");
    }
    let shown = antrieb("decode telegram 01 03 01 E0 00 01 84 00 01 03 02 04 E2 3A CD").exits(0).out;
    assert_eq!(shown.matches("12.50 Hz").count(), 2, "the field too: {shown}");
    // Another drive's reply answers nobody.
    let other = antrieb("decode telegram 01 03 01 E0 00 01 84 00 02 03 02 04 E2 7E CD").run();
    assert!(!other.out.contains("12.50 Hz"), "{}", other.out);
    let servo = antrieb("--drive lxm05 decode telegram 01 03 01 E0 00 01 84 00 01 03 02 04 E2 3A CD").json().exits(0);
    assert_eq!(servo.data("/telegrams/1/meaning"), "address 1: register 480 = 1250 (0x04E2)");
}

#[test]
fn the_control_word_depends_on_the_control_mode() {
    let slugs = |mode: u8| {
        let document = antrieb(&format!("--drive act decode control 0x0003 --mode {mode}")).json().exits(0);
        let bits = document.data("/word/bits").as_array().unwrap().clone();
        let set: Vec<_> = bits.into_iter().filter(|bit| bit["set"] == true).map(|bit| bit["slug"].clone()).collect();
        (set, document.data("/word/unknown").clone())
    };
    assert_eq!(slugs(1), (vec![json!("switch-on"), json!("enable-voltage")], json!([])));
    assert_eq!(slugs(2), (vec![json!("s1ind"), json!("s2ind")], json!([])));
    assert_eq!(slugs(0), (vec![json!(null), json!(null)], json!([0, 1])));
}

#[test]
fn warnings_faults_and_errors_are_explained_in_both_languages() {
    let document = antrieb("decode warnings 0x8083").json().exits(0);
    assert_eq!(document.data("/word/bits").as_array().unwrap().len(), 16);
    for code in ["F0500", "f0500", "0x0500", "1280", "0500h"] {
        let document = antrieb(&format!("decode fault {code}")).json().exits(0);
        assert_eq!(document.data("/fault/key"), "F0500", "{code}");
        assert!(document.data("/fault/remedy").is_string());
    }
    assert_eq!(antrieb("decode fault F213F").json().exits(0).data("/fault/node"), 63);
    assert_eq!(antrieb("decode fault 0").json().exits(0).data("/fault"), &json!(null));
    assert_eq!(antrieb("decode fault F0999").json().exits(0).data("/fault/cause"), &json!(null));
    assert_eq!(antrieb("decode error 11").json().exits(0).data("/register/slug"), "unknown-parameter");
    assert_eq!(antrieb("decode error 99").json().exits(0).data("/register/slug"), "unknown");
    let german = antrieb("--lang de decode fault F0500").exits(0).out;
    assert!(german.contains("Störung") && german.contains("Abhilfe"), "{german}");
    for bad in ["fault FXYZ", "status 0x10000", "error -1", "warnings ''"] {
        antrieb(&format!("decode {bad}")).json().exits(2);
    }
}

#[test]
fn the_catalogue_is_browsed_by_number_and_words() {
    let one = antrieb("params 412").json().exits(0);
    assert_eq!(one.data("/params").as_array().unwrap().len(), 1);
    assert!(one.data("/params/0/values").as_array().unwrap().len() >= 3);
    let several = antrieb("params fixed frequency").json().exits(0);
    let numbers: Vec<_> =
        several.data("/params").as_array().unwrap().iter().map(|row| row["param"].as_u64().unwrap()).collect();
    assert!([480, 481, 482, 483, 485, 486, 487, 488].iter().all(|number| numbers.contains(number)), "{numbers:?}");
    assert_eq!(
        antrieb("params festfrequenz 1").json().exits(0).data("/params/0/slug"),
        antrieb("params fixed-frequency-1").json().exits(0).data("/params/0/slug")
    );
    antrieb("params nonsense").json().exits(1);
    let all = |drive: &str| {
        antrieb(&format!("--drive {drive} params")).json().exits(0).data("/params").as_array().unwrap().len()
    };
    assert!(all("acu") >= 199 && all("act") > 150);
    let doubtful = antrieb("params 17").json().exits(0);
    assert!(!doubtful.data("/params/0/unconfirmed").as_array().unwrap().is_empty());
}

#[test]
fn a_recording_follows_a_drive_to_another_protocol() {
    let trace = "# antrieb trace 1, 19200 7E1, vabus\n0 > 04 41 30 32 33 37 32 05\n\
                 30000 > 04\n50000 > 01 03 21 74 00 01 CE 2C\n70000 < 01 03 02 05 6E 3A F8\n\
                 190000 < 01 03 02 05 6F 3A F8\n199000 > 3A 30 31 30 33 32 31 37 34 30 30 30 31 36 36 0D 0A\n";
    let document = antrieb("decode trace {dir}/line.txt").file("line.txt", trace).json().exits(0);
    let telegrams = document.data("/telegrams").as_array().unwrap();
    let protocols: Vec<_> = telegrams.iter().map(|telegram| telegram["protocol"].as_str().unwrap()).collect();
    assert_eq!(protocols, ["vabus", "vabus", "rtu", "rtu", "rtu", "ascii"]);
}

/// A value whose point no source places is no value with a unit.
#[test]
fn what_has_no_known_decimals_is_told_as_the_integer() {
    let told = antrieb("--drive acu decode telegram 02 65 01 A1 00 00 01 F4 48 CB").run();
    assert!(told.out.contains("= raw 500") && !told.out.contains("500 Hz"), "{}", told.out);
}
