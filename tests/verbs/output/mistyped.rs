//! What was mistyped is answered with what can be typed: findings 18 and 20 of tests/strangers/hands.

use crate::run::antrieb;

/// What is said of a line, in both languages. Names of commands are English words too; `german` knows them.
fn said(line: &str, code: u8) -> [String; 2] {
    ["en", "de"].map(|lang| {
        let told = antrieb(&format!("{line} --lang {lang}")).run();
        assert_eq!(told.exit, code, "{line}: {}", told.err);
        told.err
    })
}

fn told(line: &str, code: u8, words: &[&str]) {
    for said in said(line, code) {
        assert!(words.iter().all(|word| said.contains(word)), "{line}: {said}");
    }
}

#[test]
fn what_is_pasted_bare_behind_decode_is_led_to_what_it_seems_to_be() {
    told("decode 01 03 00", 2, &["`antrieb decode telegram 01 03 00"]);
    told("decode F0700", 2, &["`antrieb decode fault F0700"]);
    told("decode 0x37", 2, &["`antrieb decode status 0x37"]);
    antrieb("decode fault F0700").exits(0);
    antrieb("decode status 0x37").exits(0);
}

#[test]
fn a_word_before_the_verb_is_no_word_behind_it() {
    told("-p sim antrieb dataset diff drive:1 s.toml", 2, &["`antrieb -p sim dataset diff drive:1 s.toml"]);
    for said in said("-p sim frobnicate dataset diff drive:1 s.toml", 2) {
        assert!(said.contains("'frobnicate'") && !said.contains(": ;"), "{said}");
    }
}

/// Who leaves out `dataset`, or calls one of its verbs otherwise, gets back the whole line that he meant.
#[test]
fn a_verb_within_dataset_is_led_to_with_all_that_was_typed() {
    for (typed, meant) in [
        ("save s.toml", "dataset save s.toml"),
        ("diff 1 2", "dataset diff 1 2"),
        ("undo s.undo.toml", "dataset undo s.undo.toml"),
        ("dataset compare 1 2", "dataset diff 1 2"),
        ("dataset restore s.toml", "dataset load s.toml"),
        ("dataset sichern s.toml", "dataset save s.toml"),
    ] {
        told(&format!("-p sim -a 1 {typed}"), 2, &[&format!("`antrieb -p sim -a 1 {meant}")]);
    }
}

#[test]
fn several_ports_are_told_of_the_verbs_that_take_them() {
    told("-p sim -p sim read 480", 2, &["`scan`, `init`, `plan`, `apply`"]);
    told("-p A,B scan", 3, &["-p A -p B"]);
}

#[test]
fn no_setpoint_is_recommended_that_the_drive_refuses() {
    for said in said("-p sim -a 3 --drive lxm05 sollwert 10Hz", 2) {
        assert!(!said.contains("25Hz") && said.contains("--mode (velocity"), "{said}");
    }
    told("-p sim -a 3 sollwert 600", 2, &["25Hz", "lxm05: velocity", "act: frequency"]);
    told("-p sim -a 1 --drive act sollwert 600", 2, &["25Hz", "--mode (frequency"]);
}

#[test]
fn a_folder_that_is_not_there_is_not_called_a_file() {
    let [en, de] = said("-p sim -a 1 dataset save {dir}/sub/s.toml", 7);
    assert!(en.contains("there is no directory") && de.contains("es gibt kein Verzeichnis"), "{en}{de}");
    let is_file = antrieb("-p sim -a 1 dataset save {dir}/f/s.toml").file("f", "").exits(7).err;
    assert!(is_file.contains("is no directory"), "{is_file}");
}

#[test]
fn nobody_is_told_that_he_typed_all() {
    for said in said("-p sim plan", 2) {
        assert!(!said.contains("'all'") && said.contains("antrieb -p sim init"), "{said}");
    }
    told("-p sim -a all read 411", 2, &["'all'"]);
}
