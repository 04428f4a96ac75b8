//! How things are named, and what is said of a name that does not do.

use crate::run::antrieb;

const PLANT: &str = "port = \"sim\"\n[drives.pump]\naddress = 1\ndrive = \"act\"\n[drives.fan]\naddress = 2\ndrive = \"acu\"\n\
                     [drives.far]\naddress = 3\nport = \"/dev/ttyUSB9\"\n";

#[test]
fn a_slip_of_the_keyboard_is_answered_with_what_was_meant() {
    for (typed, meant) in [("rated-sped", "372 (rated-speed)"), ("rtaed-speed", "372 (rated-speed)")] {
        let english = antrieb(&format!("-p sim -a 1 read {typed}")).exits(7).err;
        assert!(english.contains(&format!("hint: did you mean {meant}")), "{english}");
        let german = antrieb(&format!("--lang de -p sim -a 1 read {typed}")).exits(7).err;
        assert!(german.contains("Hinweis: gemeint ist vielleicht 372 (Bemessungsdrehzahl)"), "{german}");
    }
    let far = antrieb("-p sim -a 1 read frobnication").exits(7).err;
    assert!(!far.contains("did you mean"), "{far}");
}

#[test]
fn names_of_drives_stand_in_lists() {
    let both = antrieb("-a pump,fan read 372").file("antrieb.toml", PLANT).json().exits(0);
    let drives: Vec<_> = [0, 1].map(|row| both.data(&format!("/values/{row}/drive")).as_str().unwrap()).into();
    assert_eq!(drives, ["act", "acu"], "each is what it is");
    let mixed = antrieb("-a fan,1,fan read 372").file("antrieb.toml", PLANT).json().exits(0);
    let addresses: Vec<_> =
        mixed.data("/values").as_array().unwrap().iter().map(|row| row["address"].clone()).collect();
    assert_eq!(addresses, [2, 1]);
    let apart = antrieb("-a pump,far write 372=1400").file("antrieb.toml", PLANT).exits(2).err;
    assert!(apart.contains("far is not on the line of the others"), "{apart}");
    for (typed, meant) in [("pump,fen", "fan"), ("fann", "fan"), ("pmp", "pump")] {
        let told = antrieb(&format!("-a {typed} read 372")).file("antrieb.toml", PLANT).exits(2).err;
        assert!(
            told.contains("one of: fan, far, pump") && told.contains(&format!("did you mean '{meant}'?")),
            "{told}"
        );
    }
}

#[test]
fn a_value_may_stand_behind_its_parameter() {
    let document = antrieb("-p sim -a 1 write 376 1,5kW 480=6Hz 481@2 7.5 --dry-run").json().exits(0);
    let rows: Vec<_> = document.data("/values").as_array().unwrap().iter().map(|row| row["param"].clone()).collect();
    assert_eq!(rows, [376, 480, 481]);
    for odd in ["376", "376=1 480", "376 1.5 kW"] {
        antrieb(&format!("-p sim -a 1 write {odd} --dry-run")).exits(2);
    }
}

/// The verb that follows the drive is named where one writes what would leave it behind.
#[test]
fn a_setting_of_the_line_is_told_its_verb() {
    for (typed, verb) in
        [("1376=5", "line set --address"), ("10=19200", "line set --baud"), ("395=ascii", "protocol set")]
    {
        let told = antrieb(&format!("-p sim -a 1 write {typed} --dry-run")).exits(0).err;
        assert!(told.contains("is a setting of the line") && told.contains(verb), "{told}");
    }
    let told = antrieb("-p sim -a 1 write 410=0 --dry-run").exits(0).err;
    assert!(told.contains("statemachine disable-voltage"), "{told}");
    let quiet = antrieb("-p sim -a 1 write 480=6 410=15 --dry-run").exits(0).err;
    assert!(!quiet.contains("setting of the line") && !quiet.contains("disable-voltage"), "{quiet}");
}

#[test]
fn an_unknown_unit_is_said_to_be_unknown() {
    let told = antrieb("-p sim -a 1 write 1600=5kW").exits(7).err;
    assert!(told.contains("the unit of this parameter is unknown") && told.contains("--catalogue"), "{told}");
}

#[test]
fn a_request_and_its_reply_are_told_as_a_pair() {
    for (reply, exit) in [("01 03 02 05 6E 3A F8", 0), ("01 83 02 C0 F1", 0), ("01 03 02 05 6F 3A F8", 5)] {
        let document = antrieb(&format!("decode telegram 01 03 21 74 00 01 CE 2C {reply}")).json().exits(exit);
        if exit == 0 {
            let directions = [0, 1].map(|at| document.data(&format!("/telegrams/{at}/direction")).clone());
            assert_eq!(directions, ["request", "reply"]);
        }
    }
    let page = antrieb("decode telegram 01 03 21 74 00 01 CE 2C 01 03 02 05 6E 3A F8").exits(0).out;
    assert!(page.contains("read P.372@2") && page.contains("P.372@2 Rated Speed = 1390"), "{page}");
}

#[cfg(unix)]
#[test]
fn what_is_no_serial_port_is_said_to_be_none() {
    let told = antrieb("-p /dev/null -a 1 read 372").exits(3).err;
    assert!(told.contains("error: /dev/null is no serial port\nhint: "), "{told}");
    let told = antrieb("--lang de -p /dev/null -a 1 read 372").exits(3).err;
    assert!(told.contains("Fehler: /dev/null ist kein serieller Anschluss"), "{told}");
}

/// A value below zero needs no `=`: no option begins with a digit.
#[test]
fn a_value_below_zero_may_be_a_word_of_its_own() {
    for (line, raw) in [
        ("480@1 -12,5", -1250),
        ("480@1 -12.5Hz", -1250),
        ("480@1 -12", -1200),
        ("480@1 -,5", -50),
        ("480@1 --decimals 2 -12,5Hz", -1250),
        ("480@1 −12,5", -1250),
        ("--dry-run 480@1 -12,5 -v", -1250),
        ("-- 480@1 -12,5", -1250),
    ] {
        let document = antrieb(&format!("-p sim -a 1 --drive act --dry-run --json write {line}")).run();
        let document: serde_json::Value = serde_json::from_str(&document.out).unwrap();
        assert_eq!(document["data"]["values"][0]["raw"], raw, "{line}: {document}");
    }
    let several = antrieb("-p sim -a 1 --drive act --dry-run write 480@1 -1 481@1=-2 482@1 -3,5Hz").json().exits(0);
    let raws: Vec<_> = several.data("/values").as_array().unwrap().iter().map(|row| row["raw"].clone()).collect();
    assert_eq!(raws, [-100, -200, -350]);
    for line in ["-12,5Hz", "-12.5Hz --mode frequency", "--mode frequency -12,5"] {
        let planned = antrieb(&format!("-p sim -a 1 --drive act --dry-run sollwert {line}")).exits(0);
        assert!(planned.out.contains("= -12.50 Hz"), "{line}\n{}", planned.out);
    }
    let led = "--ramp -5Hz:5Hz:2s --hold --enable --step 1Hz --min -6,5Hz --max 6Hz --view";
    antrieb(&format!("-p sim -a 1 --drive act --dry-run sollwert {led}")).exits(0);
    for unknown in ["write 480=1 --yess", "write 480 -x", "sollwert --hodl 5Hz", "read -5"] {
        let said = antrieb(&format!("-p sim -a 1 {unknown}")).exits(2).err;
        assert!(said.contains(" is not expected behind `"), "{unknown}: {said}");
    }
}

/// What a German technician says for what the manual writes; the table is in the catalogue (`synonyms`).
#[test]
fn parameters_are_found_by_what_people_say() {
    for (said, param) in
        [("Nennfrequenz", "375"), ("nenndrehzahl", "372"), ("Nenndreh", "372"), ("Nominal Speed", "372")]
    {
        let read = antrieb(&format!("-p sim -a 1 read '{said}'")).json().exits(0);
        assert_eq!(read.data("/values/0/param").to_string(), param, "{said}");
    }
    let found = antrieb("--drive act params nenn").json().exits(0);
    let found: Vec<_> = found.data("/params").as_array().unwrap().iter().map(|row| row["param"].as_u64()).collect();
    assert_eq!(found, [Some(372), Some(375), Some(376)]);
    let power = antrieb("-p sim -a 1 read Nennleistung").exits(7).err;
    assert!(power.contains("did you mean 376 (rated-mechanical-power)"), "{power}");
}

#[test]
fn a_suggestion_is_in_the_language_of_the_output_and_is_taken_as_it_stands() {
    for (lang, typed, meant) in
        [("en", "rated-freqency", "rated-frequency"), ("de", "Bemessungsfreqenz", "Bemessungsfrequenz")]
    {
        let told = antrieb(&format!("--lang {lang} -p sim -a 1 read {typed}")).exits(7).err;
        assert!(told.contains(&format!("375 ({meant})")), "{told}");
        assert_eq!(antrieb(&format!("-p sim -a 1 read {meant}")).json().exits(0).data("/values/0/param"), 375);
    }
}

/// What the system says of a host is said in German as well.
#[test]
fn a_host_that_is_not_there_is_told_in_both_languages() {
    let told = |lang: &str| antrieb(&format!("--lang {lang} -p tcp://127.0.0.1:1 -a 1 read 411")).exits(3).err;
    assert!(told("en").contains("cannot connect to 'tcp://127.0.0.1:1': Connection refused"), "{}", told("en"));
    let german = told("de");
    assert!(german.contains("keine Verbindung zu 'tcp://127.0.0.1:1': Verbindung abgewiesen"), "{german}");
    assert!(!german.contains('"'), "{german}");
}

/// A language changes names and texts, never a number: what is printed is taken as it stands, and a comma as well.
#[test]
fn numbers_have_a_decimal_point_in_every_language() {
    for lang in ["en", "de"] {
        let hint = antrieb(&format!("--lang {lang} -p sim -a 1 write 376@4")).exits(2).err;
        let example = hint.split_whitespace().last().unwrap();
        assert_eq!(example, "376@4=1.5kW", "{hint}");
        for typed in [example, "376@4=1,5kW"] {
            let planned = antrieb(&format!("--lang {lang} -p sim -a 1 --drive act write {typed} --dry-run")).exits(0);
            assert!(planned.out.contains("1.5 kW") && !planned.out.contains("1,5"), "{}", planned.out);
        }
        let read = antrieb(&format!("--lang {lang} -p sim -a 1 read 375")).exits(0);
        assert!(read.out.contains(" 50.00 "), "{}", read.out);
    }
}
