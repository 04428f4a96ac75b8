//! What is said to a technician at a terminal of 80 columns, in his language.

use crate::german;
use crate::run::antrieb;
use unicode_width::UnicodeWidthStr;

const READY: &str = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n";

/// Questions, notes, warnings and hints break between words; in a pipe they are lines.
#[test]
fn on_a_terminal_prose_is_wrapped_between_words_and_in_a_pipe_it_is_not() {
    let lines = [
        "-p sim --lang de -a 1 sollwert 25Hz --enable --hold --duration 1s",
        "-p sim -a 1 sollwert 25Hz --enable --hold --duration 1s --dead-man --view",
        "-p sim -a 9 read 372",
        "-p sim --lang de -a 9 read 372",
        "-p sim --baud auto --parity auto --protocol auto -a 30-40 scan --within 3s",
        "-p sim --lang de --baud auto --parity auto --protocol auto -a 30-40 scan --within 3s",
        "-p sim write 376=1,5",
    ];
    for line in lines {
        let shown = antrieb(line).columns(80).answered("n\n").run().err;
        let long: Vec<&str> = shown.lines().filter(|line| line.width() > 80 && line.contains(' ')).collect();
        assert!(long.is_empty(), "{line}: {long:#?}");
        let piped = antrieb(line).run().err;
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let only_words = |text: &str| words(text).into_iter().filter(|word| !word.starts_with('[')).collect::<Vec<_>>();
        for wrapped in only_words(&shown).windows(2).take(3) {
            assert!(words(&piped).windows(2).any(|pair| pair == wrapped), "{line}: {wrapped:?} of {piped}");
        }
    }
    let hint = antrieb("-p sim -a 9 scan").columns(80).answered("").exits(1).err;
    assert!(hint.lines().any(|line| line.contains("--baud auto --parity auto --protocol auto")), "{hint}");
}

/// More than a hundred ways to go wrong, in both languages: no line of prose is wider than the terminal; a word that is, a path, stays
/// whole.
#[test]
fn whatever_goes_wrong_is_told_within_eighty_columns() {
    for run in ["en", "de"].into_iter().flat_map(german::wrong) {
        let ended = run.columns(80).answered("n\n").run();
        // A line that is refreshed is each of its states.
        let lines = ended.out.lines().chain(ended.err.lines()).flat_map(|line| line.split('\r'));
        let long: Vec<&str> = lines.filter(|line| line.width() > 80 && line.trim().contains(' ')).collect();
        assert!(long.is_empty(), "{}: {long:#?}", ended.line);
    }
}

#[test]
fn a_number_without_a_base_says_how_it_was_read() {
    for (line, other) in [
        ("decode status 0237", "`antrieb decode status 0x0237`"),
        ("decode fault 0700", "`antrieb decode fault F0700`"),
        ("--drive lxm05 decode fault 0700", "`antrieb decode fault E0700`"),
        ("--lang de decode warnings 1000", "`antrieb decode warnings 0x1000`"),
    ] {
        let told = antrieb(line).exits(0).err;
        assert!(told.contains(other) && told.contains(&line[line.len() - 4..]), "{line}: {told}");
    }
    for clear in ["decode status 0x0237", "decode fault F0700", "decode status 567", "decode error 11"] {
        assert_eq!(antrieb(clear).exits(0).err, "", "{clear}");
    }
}

#[test]
fn german_errors_are_german() {
    let told = antrieb("--lang de -p sim -a 999 read 372").exits(2).err;
    assert!(told.starts_with("Fehler: Adresse: erwartet: 0 bis 247"), "{told}");
    let list = "Nr.;Bezeichnung;Einheit;Typ;Nachkommastellen;Zugriff\nP.372;Drehzahl;1/min;uint;0;rw\n";
    let told = antrieb("--lang de params import {dir}/a.csv").file("a.csv", list).exits(7).err;
    assert!(told.contains("a.csv:2: Parameter 372 steht schon in der eingebauten active.toml\n"), "{told}");
    assert!(told.contains("--replace") && !told.contains("replace = true"), "{told}");
    let held = antrieb("--lang de -a 1 --yes sollwert 25Hz --enable --hold --duration 1s").on(READY).exits(0).err;
    assert!(held.contains("Strg-C") && !held.contains("Ctrl-C"), "{held}");
}

#[test]
fn what_was_typed_is_said_as_it_was_typed() {
    let told = antrieb("-p sim -a 1 sollwert 5Hz --hold --duration -3s").exits(2).err;
    assert!(told.contains("'-3s'") && !told.contains('\u{2212}'), "{told}");
}

#[test]
fn a_unit_behind_a_blank_is_named() {
    for (line, joined) in
        [("sollwert 25 Hz", "25Hz"), ("write 376 1,5 kW", "376=1,5kW"), ("write 376=1,5 kW", "376=1,5kW")]
    {
        for lang in ["en", "de"] {
            let told = antrieb(&format!("--lang {lang} -p sim -a 1 {line}")).exits(2).err;
            assert!(told.contains(&format!(": {joined}\n")), "{line}: {told}");
        }
    }
    let told = antrieb("-p sim -a 1 --yes write 376=750W").exits(7).err;
    assert!(
        told.contains("'750W' has more decimals than this parameter: its step is 0.1 kW, so it takes 0.7 kW or 0.8 kW"),
        "{told}"
    );
}

#[test]
fn a_verb_of_the_same_name_goes_before_one_within_another() {
    for verb in ["plan", "apply", "check"] {
        let told = antrieb(&format!("dataset {verb} x.toml")).run().err;
        assert!(verb == "check" || told.contains(&format!("it is `antrieb {verb}`")), "{told}");
    }
}

#[test]
fn help_is_a_verb_and_says_in_german_that_it_is_english() {
    let [word, option] = ["help scan", "scan --help"].map(|line| antrieb(line).exits(0).out);
    assert_eq!(word, option);
    assert_eq!(antrieb("help").exits(0).out, antrieb("--help").exits(0).out);
    let german = antrieb("--lang de scan -h").run().out;
    assert!(german.lines().nth(1).unwrap().contains("Hilfetexte sind englisch"), "{german}");
    assert_eq!(german.lines().count(), antrieb("scan -h").exits(0).out.lines().count());
}

#[test]
fn a_map_without_an_area_says_so_and_a_list_of_an_old_mac_is_read() {
    let map = "{\"mbmap\": 2, \"vendor\": \"x\", \"model\": \"y\", \"address_base\": 0, \"registers\": [{\"address\": 1, \"name\": \"speed\", \"type\": \"uint16\"}]}";
    let told = antrieb("--json params import {dir}/m.json --as mbmap").file("m.json", map).run();
    assert!(told.out.contains("`area` is missing"), "{}", told.out);
    let ranged =
        map.replace("\"uint16\"", "\"int16\", \"area\": \"holding\", \"scale\": 0.1, \"min\": -20, \"max\": 20");
    let told = antrieb("params import {dir}/m.json").file("m.json", &ranged).exits(0).out;
    assert!(
        told.contains("the ranges (min, max) of these registers are not taken") && told.contains("refused: 1;"),
        "{told}"
    );
    let list = "Nr.;Bezeichnung;Einheit;Typ;Nachkommastellen;Zugriff\rP.370;Nennstrom X;A;uint;1;rw\rP.420;Rampe;Hz/s;long;2;rw\r";
    let read = antrieb("params import {dir}/a.csv").file("a.csv", list).json().exits(0);
    assert_eq!(read.data("/rows").as_array().unwrap().len(), 2);
}

/// What was asked, what only had a look, what is left: with the settings by their names.
#[test]
fn a_search_that_was_cut_short_names_its_settings() {
    let told = antrieb("-p sim --baud auto -a 30-60 scan --within 2s").exits(1).err;
    assert!(told.contains("left open: ") && told.contains("19200 8E1 rtu"), "{told}");
    assert!(!told.contains("1 other settings"), "{told}");
    let known = antrieb("-p sim -a 1-200 scan --within 1500ms").exits(0).err;
    assert!(known.contains("warning: asked to the end: 1-") && known.contains("-200 at 19200 8E1 rtu"), "{known}");
    let saved = antrieb("-p sim --baud auto -a 30-60 scan --within 2s").json().exits(1);
    assert!(
        saved.error()["hint"].as_str().unwrap().contains("--baud auto scan --resume RESULT.json"),
        "{}",
        saved.error()
    );
    assert!(!told.contains("RESULT.json can be gone on with: "), "{told}");
}

/// Nobody has asked a drive what modes it has; a family that was named has those of its catalogue.
#[test]
fn a_mode_that_nobody_has_is_not_said_of_a_drive_that_nobody_asked() {
    let told = antrieb("-p sim -a 2 sollwert 300 --mode foo").exits(2).err;
    assert!(told.contains("no family has a mode 'foo'") && told.contains("lxm05: velocity"), "{told}");
    let told = antrieb("-p sim -a 2 --drive lxm05 sollwert 300 --mode foo").exits(2).err;
    assert!(told.contains("'foo' is no mode of the family lxm05 (expected: velocity"), "{told}");
}

#[test]
fn places_names_and_placeholders_are_told_as_they_are() {
    for (line, part) in [
        ("-p sim -a 1 --lang de line set --address 400 --yes", "Adresse: erwartet 1-247, erhalten 400"),
        ("--lang de simulate nix.toml", "Prüfstanddatei"),
        ("-p sim -a 1 --lang de write 423=5Hz", "Parameter 423: die Einheit"),
        ("-p sim -a 1 write 423=5Hz", "parameter 423: the unit"),
        ("-p sim -a 1 sollwert --enable --profile nix.csv", "nix.csv: "),
        ("-p sim --lang de write", "`antrieb write <PARAMETER=WERT>...`"),
        ("-p sim write", "`antrieb write <PARAMETER=VALUE>...`"),
    ] {
        let told = antrieb(line).run().err;
        assert!(told.contains(part), "{line}: {told}");
    }
}

/// Who was not understood at the setting that he typed is told to search others, and a bus of one rate is left alone.
#[test]
fn behind_silence_a_search_is_proposed_that_can_find_somebody() {
    for (line, search) in [
        ("-a 1 --parity odd read 411", "-p sim:{dir}/bench.toml --parity auto scan`"),
        ("-a 1 -b 9600 read 411", "-p sim:{dir}/bench.toml -b auto scan`"),
        ("-a 1 read 411 480", "`antrieb -p sim:{dir}/bench.toml scan`"),
    ] {
        let told = antrieb(line).on("[[drive]]\nmodel = \"act\"\naddress = 7\n").run();
        let search = search.replace("{dir}", &told.directory().display().to_string());
        assert!(told.err.contains(&search), "{line}: {}", told.err);
    }
}

#[test]
fn the_keypad_of_a_run_without_a_setpoint_says_why_it_has_no_arrows() {
    for (lang, why) in [("en", "gives none"), ("de", "gibt keinen")] {
        let line = format!("--lang {lang} -p sim -a 2 statemachine enable --hold --view --step 1Hz");
        let told = antrieb(&line).exits(2).err;
        assert!(told.contains(why) && told.contains("--enable --hold --view --step"), "{told}");
    }
}

/// A setting of the line and the name of a drive are whole, or not there.
#[test]
fn a_row_of_a_search_breaks_no_setting_and_no_name() {
    let slow =
        "[[drive]]\nmodel = \"acu\"\naddress = 3\nbaud = 2400\n[[drive]]\nmodel = \"act\"\naddress = 1\nbaud = 2400\n";
    for lang in ["en", "de"] {
        let told = antrieb(&format!("--lang {lang} -a 1-3 --baud auto scan")).on(slow).columns(80).exits(0).out;
        assert_eq!(told.matches("2400 8E1").count(), 2, "{told}");
        assert!(told.lines().all(|line| line.trim() != "Cube" && !line.ends_with("ACTIVE")), "{told}");
        assert_eq!(told.lines().filter(|line| !line.is_empty()).count(), 3, "{told}");
    }
}

/// German is German to the end: sources, fields, states of a slave, what a library says; and one is told apart from several.
#[test]
fn no_english_and_no_bracketed_plural_is_left_in_german() {
    let told = |line: &str| antrieb(&format!("--lang de {line}")).on(READY).exits(0);
    let page = told("params 411 --drive act").out;
    assert!(
        page.contains("Statuswort") && page.contains("CM-485 Anleitung 9") && page.contains("eingebaut: active.toml"),
        "{page}"
    );
    let page = told("params 1376").out;
    assert!(page.contains("unbestätigt") && page.contains("englischer Name, Typ"), "{page}");
    assert!(told("dataset diff -a 1 1 2 480").err.contains("sind in 1 Parameter gleich"), "{page}");
    assert!(told("dataset diff -a 1 1 2 480 481").err.contains("sind in 2 Parametern gleich"), "{page}");
    let steps = antrieb("--lang de procedure first-contact watchdog=2s -a 1 --yes").on(READY).run();
    assert!(steps.err.contains("(CM-485 Anleitung ") && !steps.err.contains("manual"), "{}", steps.err);
    let memory = antrieb("--lang de -a 1 diag").on("[[drive]]\nmodel = \"lxm05\"\n").exits(0).out;
    assert!(memory.contains("Fehlerspeicher") && memory.contains("leer"), "{memory}");
    let live = antrieb("--lang de -p sim profibus live").exits(0).out;
    assert!(live.contains("wartet auf Set_Prm") && !live.contains("wait-prm"), "{live}");
    for (map, told) in
        [("{\"mbmap\": 2, \"registers\": [\n", "hört mittendrin auf"), ("{\"mbmap\": }", "ab Spalte 11 kein JSON")]
    {
        let err = antrieb("--lang de params import {dir}/m.json").file("m.json", map).exits(7).err;
        assert!(err.contains(told) && !err.contains("EOF"), "{err}");
    }
}

/// A refusal names the verb that does it.
#[test]
fn what_a_line_does_not_speak_has_another_verb() {
    for (line, hint) in [
        ("-p sim --protocol sdo -a 3 statemachine enable --yes", "serial plug"),
        ("-p sim --protocol dp -a 3 statemachine switch-on --yes", "statemachine enable --hold`"),
        ("-p sim --protocol dp -a 3 statemachine enable --yes", "sollwert 20Hz --enable --hold`"),
    ] {
        let told = antrieb(line).exits(2).err;
        assert!(told.contains(hint), "{line}: {told}");
    }
}
