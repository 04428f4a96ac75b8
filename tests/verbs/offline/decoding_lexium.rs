//! Telegrams of the Lexium manual, and what its parameters are in them.

use crate::run::antrieb;
use serde_json::json;

/// Telegrams of the LXM05 manual, chapters 5.2, 5.3, 5.5.1 and 6.2, with the lengths of facts G4: PDU, direction, what is said of
/// it in English and in German. The manual prints fields, not bytes; values that it leaves open are ours.
const LEXIUM: &[(&str, Option<&str>, &str, &str)] = &[
    (
        "03 1E 14 00 02", // 5.2.1
        Some("request"),
        "read _p_act (7700) Actual position of the motor",
        "lesen _p_act (7700) Istposition des Motors",
    ),
    ("03 04 FF FF FF FE", Some("reply"), "value -2 (0xFFFFFFFE)", "Wert -2 (0xFFFFFFFE)"),
    (
        "10 1B 1C 00 02 04 00 00 00 30", // 5.2.3
        Some("request"),
        "write PPp_targetusr (6940) Target position (point-to-point) = 48 usr",
        "schreiben PPp_targetusr (6940) Zielposition (Punkt-zu-Punkt) = 48 usr",
    ),
    (
        "10 1B 1C 00 02",
        Some("reply"),
        "PPp_targetusr (6940) Target position (point-to-point) written",
        "PPp_targetusr (6940) Zielposition (Punkt-zu-Punkt) geschrieben",
    ),
    (
        "17 1B 04 00 02 1B 02 00 02 04 00 00 00 06", // 5.2.4
        Some("request"),
        "write DCOMcontrol (6914) Control word = 0x0006, then read DCOMstatus (6916) Status word",
        "schreiben DCOMcontrol (6914) Steuerwort = 0x0006, dann lesen DCOMstatus (6916) Statuswort",
    ),
    ("17 04 00 00 00 21", Some("reply"), "value 33 (0x00000021)", "Wert 33 (0x00000021)"),
    (
        "2B 0E 01 00", // 5.2.5
        Some("request"),
        "read identification: basic objects, from vendor name",
        "Identifikation lesen: Grundangaben, ab Hersteller",
    ),
    (
        "2B 0E 01 02 00 00 03 00 03 61 62 63 01 00 03 07 56 30 32 2E 30 30 31",
        Some("reply"),
        "identification: vendor name \"abc\", product code \"\", revision \"V02.001\"",
        "Identifikation: Hersteller \"abc\", Produktcode \"\", Ausgabestand \"V02.001\"",
    ),
    (
        "2B 0E 01 82 FF 02 01 00 03 61 62 63",
        Some("reply"),
        "identification: vendor name \"abc\", more from revision",
        "Identifikation: Hersteller \"abc\", weiter ab Ausgabestand",
    ),
    (
        "03 3C 02 00 08", // 5.3, example 1
        Some("request"),
        "read FLT_err_num (15362), FLT_class (15364), FLT_Time (15366), FLT_Qual (15368)",
        "lesen FLT_err_num (15362), FLT_class (15364), FLT_Time (15366), FLT_Qual (15368)",
    ),
    (
        "03 10 00 00 23 00 00 00 00 02 00 00 00 4D 00 00 00 05",
        Some("reply"),
        "value 8960 (0x00002300), 2 (0x00000002), 77 (0x0000004D), 5 (0x00000005)",
        "Wert 8960 (0x00002300), 2 (0x00000002), 77 (0x0000004D), 5 (0x00000005)",
    ),
    (
        "10 06 08 00 04 08 00 00 00 01 FF FF FF FF", // 5.3, example 2
        Some("request"),
        "write SPVswLimPusr (1544) = 1 usr, SPVswLimNusr (1546) = -1 usr",
        "schreiben SPVswLimPusr (1544) = 1 usr, SPVswLimNusr (1546) = -1 usr",
    ),
    (
        "10 06 08 00 04",
        Some("reply"),
        "SPVswLimPusr (1544), SPVswLimNusr (1546) written",
        "SPVswLimPusr (1544), SPVswLimNusr (1546) geschrieben",
    ),
    (
        "10 1B 06 00 02 04 FF FF FF FD", // 5.5.1
        Some("request"),
        "write DCOMopmode (6918) Operating mode = -3 (Current control)",
        "schreiben DCOMopmode (6918) Betriebsart = -3 (Stromregelung)",
    ),
    (
        "10 20 08 00 02 04 00 00 03 E8",
        Some("request"),
        "write CUR_I_target (8200) Set current = 10.00 A",
        "schreiben CUR_I_target (8200) Sollstrom = 10.00 A",
    ),
    // Table 5.2.
    ("08 00 00 A5 37", None, "diagnostics, echo: 0xA537", "Diagnose, Echo: 0xA537"),
    ("08 00 01 FF 00", None, "diagnostics, start the port anew", "Diagnose, Anschluss neu starten"),
    ("08 00 02 00 00", None, "diagnostics, last synchronous error", "Diagnose, letzter synchroner Fehler"),
    ("08 00 03 00 00", None, "diagnostics, sub-function 0x03", "Diagnose, Unterfunktion 0x03"),
    ("08 00 04 00 00", None, "diagnostics, listen only", "Diagnose, nur noch zuhören"),
    ("08 00 0A 00 00", None, "diagnostics, clear all counters", "Diagnose, alle Zähler löschen"),
    ("08 00 0C 00 00", None, "diagnostics, Checksum errors", "Diagnose, Prüfsummenfehler"),
    // 6.2; the norm leaves the type of code 43 out.
    (
        "90 04",
        Some("reply"),
        "refuses function code 16, exception 4 (slave device failure)",
        "lehnt ab: Funktionscode 16, Ausnahme 4 (Fehler im Slave)",
    ),
    (
        "AB 0E 03",
        Some("reply"),
        "refuses function code 43, exception 3 (illegal data value)",
        "lehnt ab: Funktionscode 43, Ausnahme 3 (Datenwert unzulässig)",
    ),
    (
        "AB 03",
        Some("reply"),
        "refuses function code 43, exception 3 (illegal data value)",
        "lehnt ab: Funktionscode 43, Ausnahme 3 (Datenwert unzulässig)",
    ),
    // What is no whole parameter, and what no catalogue knows.
    ("03 1E 14 00 01", Some("request"), "read register 7700", "lesen Register 7700"),
    ("03 1E 14 00 03", Some("request"), "read 3 registers from 7700", "lesen 3 Register ab 7700"),
    (
        "10 1E 16 00 02 04 00 00 03 E8",
        Some("request"),
        "write P.7702 = 1000 (0x000003E8)",
        "schreiben P.7702 = 1000 (0x000003E8)",
    ),
    (
        "03 06 08 00 0A",
        Some("request"),
        "read 5 parameters from SPVswLimPusr (1544)",
        "lesen 5 Parameter ab SPVswLimPusr (1544)",
    ),
    ("06 1B 03 00 06", None, "write register 6915 = 6 (0x0006)", "schreiben Register 6915 = 6 (0x0006)"),
    // A number of the ACTIVE family is none of this family's, whatever it is called there.
    ("64 05 04", Some("request"), "read P.1284@0, 32 bit", "lesen P.1284@0, 32 Bit"),
];

/// A PDU of station 1 as an ASCII telegram, which a person can check.
pub(super) fn ascii(pdu: &str) -> String {
    let body = format!("01 {pdu}");
    let sum = body.split(' ').map(|byte| u8::from_str_radix(byte, 16).unwrap()).fold(0u8, u8::wrapping_add);
    format!(":{body} {:02X}", sum.wrapping_neg())
}

#[test]
fn telegrams_of_the_lexium_manual_are_told_as_its_parameters() {
    for (pdu, direction, english, german) in LEXIUM {
        for (lang, meaning, address, either) in
            [("en", english, "address", "request, or its echo"), ("de", german, "Adresse", "Anfrage oder ihr Echo")]
        {
            let document =
                antrieb(&format!("--drive lxm05 --lang {lang} decode telegram '{}'", ascii(pdu))).json().exits(0);
            let telegram = document.data("/telegrams/0");
            let echo = if direction.is_none() { format!(" ({either})") } else { String::new() };
            assert_eq!(telegram["direction"], json!(direction), "{pdu}");
            assert_eq!(telegram["meaning"], format!("{address} 1: {meaning}{echo}"), "{pdu}");
            let fields = telegram["fields"].as_array().unwrap();
            let hex: Vec<&str> = fields.iter().map(|field| field["hex"].as_str().unwrap()).collect();
            assert_eq!(format!(":{}", hex.join(" ")), ascii(pdu), "the fields are the telegram");
        }
    }
}

#[test]
fn values_of_two_registers_are_one_field_each() {
    let telegram = ascii("10 06 08 00 04 08 00 00 00 01 FF FF FF FF");
    let document = antrieb(&format!("--drive lxm05 decode telegram '{telegram}'")).json().exits(0);
    let fields = document.data("/telegrams/0/fields").as_array().unwrap();
    let told: Vec<_> =
        fields.iter().map(|field| ["hex", "name", "value"].map(|key| field[key].as_str().unwrap())).collect();
    assert_eq!(
        told[2..7],
        [
            ["06 08", "first register", "SPVswLimPusr (1544) Software limit switch, positive"],
            ["00 04", "register count", "4"],
            ["08", "byte count", "8"],
            ["00 00 00 01", "SPVswLimPusr (1544)", "1 usr"],
            ["FF FF FF FF", "SPVswLimNusr (1546)", "-1 usr"],
        ]
    );
}

#[test]
fn the_word_order_is_the_one_that_is_given() {
    let low = "--drive lxm05 --word-order low";
    let telegram = ascii("10 20 08 00 02 04 03 E8 00 00");
    let document = antrieb(&format!("{low} decode telegram '{telegram}'")).json().exits(0);
    assert_eq!(document.data("/telegrams/0/meaning"), "address 1: write CUR_I_target (8200) Set current = 10.00 A");
    let planned = antrieb(&format!("-p sim -a 1 {low} --dry-run write CUR_I_target=10A")).exits(0).out;
    assert!(planned.contains("01 17 20 08 00 02 20 08 00 02 04 03 E8 00 00"), "{planned}");
}
