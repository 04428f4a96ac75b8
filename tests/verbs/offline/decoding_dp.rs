//! Telegrams of PROFIBUS-DP (fieldbus facts, "Golden telegrams"; SJ2-PB manual 3 and 4).

use crate::run::antrieb;

/// Bytes, address, what is said.
const GOLDEN: &[(&str, u8, &str)] = &[
    ("10 08 02 49 53 16", 8, "master 2 to station 8: FDL status (is anybody there?)"),
    ("10 02 08 00 0A 16", 8, "station 8 to master 2: slave: OK"),
    ("68 05 05 68 88 82 6D 3C 3E F1 16", 8, "master 2 to station 8: Slave_Diag"),
    (
        "68 0B 0B 68 82 88 08 3E 3C 02 05 00 FF 0A 35 D1 16",
        8,
        "station 8 to master 2: Slave_Diag: Station_Not_Ready, Prm_Req; no master has parameterised it; ident 0A35h",
    ),
    (
        "68 13 13 68 88 82 5D 3D 3E B8 1E 01 00 0A 35 01 00 00 00 82 00 00 00 7B 16",
        8,
        "master 2 to station 8: Set_Prm: Lock_Req, Sync_Req, Freeze_Req, WD_On; watchdog 300 ms; ident 0A35h; \
         7 bytes of the GSD",
    ),
    ("68 06 06 68 88 82 7D 3E 3E 21 24 16", 8, "master 2 to station 8: Chk_Cfg: 1 identifier; 0 bytes in, 2 bytes out"),
    (
        "68 0B 0B 68 82 88 08 3E 3C 00 0C 00 02 0A 35 D9 16",
        8,
        "station 8 to master 2: Slave_Diag: WD_On; master 2; ident 0A35h",
    ),
    (
        "68 0B 0B 68 82 8A 08 3E 3C 06 05 00 FF 0F 84 2B 16",
        10,
        "station 10 to master 2: Slave_Diag: Station_Not_Ready, Cfg_Fault, Prm_Req; no master has parameterised it; \
         ident 0F84h",
    ),
];

#[test]
fn golden_telegrams_are_known_without_being_told() {
    for (bytes, address, meaning) in GOLDEN {
        let document = antrieb(&format!("decode telegram {bytes}")).json().exits(0);
        let telegram = document.data("/telegrams/0");
        assert_eq!(
            (telegram["protocol"].as_str(), telegram["address"].as_u64()),
            (Some("dp"), Some(u64::from(*address)))
        );
        assert_eq!(telegram["meaning"], *meaning);
        let hex: Vec<&str> =
            telegram["fields"].as_array().unwrap().iter().map(|field| field["hex"].as_str().unwrap()).collect();
        assert_eq!(hex.join(" "), *bytes, "the fields are the telegram");
    }
}

#[test]
fn telegrams_one_behind_the_other_are_told_one_by_one() {
    let all: Vec<&str> = GOLDEN.iter().map(|row| row.0).chain(["E5", "DC 02 01"]).collect();
    let document = antrieb(&format!("decode telegram {}", all.join(" "))).json().exits(0);
    let told = document.data("/telegrams").as_array().unwrap();
    assert_eq!(told.iter().map(|doc| doc["hex"].as_str().unwrap()).collect::<Vec<_>>(), all);
    let last: Vec<_> = told.iter().rev().take(2).map(|doc| doc["meaning"].as_str().unwrap()).collect();
    assert_eq!(last, ["the token goes from master 1 to 2", "SC: understood, nothing to say"]);
}

/// The exchange of 4.1, framed: PPO2, A038 put into PZD3.
#[test]
fn data_exchange_is_told_by_its_configuration() {
    let sent = "68 17 17 68 08 02 5D 73 93 01 00 00 00 00 22 04 06 20 00 01 F4 00 00 00 00 00 00 AF 16";
    let meaning = |options: &str| {
        let document = antrieb(&format!("decode telegram {sent} {options}")).json().exits(0);
        document.data("/telegrams/0/meaning").as_str().unwrap().to_owned()
    };
    assert!(meaning("--cfg ppo2").contains("write an element, 16 bit: P.915.1"), "{}", meaning("--cfg ppo2"));
    assert_eq!(meaning("--cfg f3f5"), meaning("--cfg ppo2"));
    assert!(meaning("--cfg ppo1").ends_with("20 bytes, and ppo1 has 12"));
    assert!(meaning("").ends_with("20 bytes; --cfg tells what they are"));
}

#[test]
fn a_verb_that_does_not_speak_it_says_so() {
    // A part of a verb that speaks it sends nothing else on its line either.
    for line in ["line show", "diag line", "diag line --dry-run"] {
        let told = antrieb(&format!("--protocol dp --port sim -a 3 {line}")).json().exits(2);
        assert_eq!(told.error()["code"], "usage.profibus", "{line}");
        assert!(!told.err.contains(" ms > "), "{line}: {}", told.err);
    }
}
