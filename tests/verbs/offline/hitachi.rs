//! Hitachi L200, SJ200 and X200 behind an SJ2-PB: what is told of them without a line (manual 10-01-26).

use crate::run::antrieb;
use serde_json::Value;

/// Examples of 3.1.1 and 3.1.2: words, parameters, identifier.
const MODULES: &[(&str, &str, &str)] = &[
    ("L200 Get acceleration (non inverted, index based)", "81 00 07", "50"),
    ("L200 Get acceleration (inverted, address based)", "99 12 10", "50"),
    ("L200 Basic block (non inverted)", "C7 FF FF", "F3"),
    (
        "L200 Set deceleration (non inverted, index based, generic, min. 0x0001, max. 0x7530)",
        "E1 00 09 00 01 75 30",
        "60",
    ),
    ("X200 Get acceleration (non swapped, index based)", "00 07", "50"),
    ("X200 Get acceleration (swapped, address based)", "32 10", "50"),
    ("X200 Basic block (non swapped)", "8F FF", "F3"),
    ("X200 Set deceleration (non swapped, index based, generic, min. 0x0001, max. 0x7530)", "C0 09 00 01 75 30", "60"),
    ("SJ200 set 0x1210", "41 00 07", "60"),
];

#[test]
fn modules_of_the_manual_are_made_of_words_and_told_from_bytes() {
    for (words, bytes, cfg) in MODULES {
        let made = antrieb(&format!("profibus module '{words}'")).json().exits(0);
        let told = antrieb(&format!("profibus module {bytes}")).json().exits(0);
        for document in [&made, &told] {
            assert_eq!(
                (document.data("/parameters"), document.data("/cfg")),
                (&Value::from(*bytes), &Value::from(*cfg))
            );
        }
        for same in ["/meaning", "/param", "/drive", "/notes"] {
            assert_eq!(made.data(same), told.data(same), "{words}");
        }
        let fields = made.data("/fields").as_array().unwrap();
        let hex: Vec<_> = fields.iter().map(|field| field["hex"].as_str().unwrap()).collect();
        assert_eq!(hex.join(" "), *bytes, "the fields are the module");
    }
}

#[test]
fn the_identifier_of_one_byte_is_left_open() {
    let document = antrieb("profibus module L200 set A001").json().exits(0);
    assert_eq!((document.data("/parameters"), document.data("/cfg")), (&Value::from("C0 00 58"), &Value::Null));
    assert!(document.data("/notes/0").as_str().unwrap().contains("20 or 60"));
}

#[test]
fn each_series_has_its_own_rows() {
    let has = |drive: &str, number: u64| {
        let rows = antrieb(&format!("--drive {drive} params")).json().exits(0).data("/params").clone();
        rows.as_array().unwrap().iter().any(|row| row["param"] == number)
    };
    assert!(has("sj200", 37) && has("x200", 264) && has("l200", 240) && has("x200", 915));
    assert!(!has("l200", 37) && !has("l200", 264) && !has("x200", 240));
    let least =
        |drive: &str| antrieb(&format!("--drive {drive} params 64")).json().exits(0).data("/params/0/min").clone();
    assert_eq!((least("l200"), least("sj200")), (Value::from(20.0), Value::from(10.0)));
}

/// 4.1: 0406 and 047F, 0231 and 0737; the words of the example by name.
#[test]
fn words_of_the_profile_are_told_bit_by_bit() {
    let set = |line: &str| {
        let document = antrieb(line).json().exits(0);
        let bits = document.data("/word/bits").as_array().unwrap().clone();
        let set = bits.iter().filter(|bit| bit["set"] == true);
        set.map(|bit| bit["bit"].as_u64().unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(set("decode control 0x0406 --drive l200"), [1, 2, 10]);
    assert_eq!(set("decode control 0x047F --drive x200"), [0, 1, 2, 3, 4, 5, 6, 10]);
    assert_eq!(set("decode status 0x0231 --drive sj200"), [0, 4, 5, 9]);
    assert_eq!(set("decode status 0x0737 --drive l200"), [0, 1, 2, 4, 5, 8, 9, 10]);
}

/// Index 7: raw FFFFh is 0.01 s, 03E8h is 100.0 s; 0 is nothing.
#[test]
fn ramp_times_are_told_by_their_mixed_code() {
    for (pwe, value) in
        [("0000 FFFF", "0.01 s"), ("0000 D8F1", "99.99 s"), ("0000 03E8", "100.0 s"), ("0000 7530", "3000.0 s")]
    {
        let document = antrieb(&format!("decode pkw 2007 0000 {pwe}")).json().exits(0);
        let meaning = document.data("/parts/meaning").as_str().unwrap();
        assert!(meaning.ends_with(&format!("Acceleration time 1 = {value}")), "{meaning}");
    }
}

#[test]
fn a_code_of_the_display_is_decimal() {
    let fault = |line: &str| antrieb(line).json().exits(0).data("/fault").clone();
    let known = fault("decode fault E07");
    assert_eq!((&known["key"], &known["code"], &known["cause"]), (&"E07".into(), &7.into(), &Value::Null));
    assert_eq!(fault("--drive l200 decode fault E13")["name"], "undocumented fault");
    assert_eq!(fault("decode fault EB303")["key"], "EB303", "that of an LXM05");
}

/// Nothing goes out to what no Modbus reaches.
#[test]
fn an_inverter_behind_the_module_is_not_asked_over_modbus() {
    for line in ["read 7", "read 7 --dry-run", "write 7=5s --yes", "monitor 7", "diag", "identify"] {
        let error = antrieb(&format!("--drive l200 -p sim -a 1 {line}")).json().exits(2).error()["code"].clone();
        assert_eq!(error, "usage.profibus", "{line}");
    }
}
