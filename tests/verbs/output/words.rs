//! What the program says: what is in force, who is there, who is to blame, and what a file may decide.

use crate::run::antrieb;
use serde_json::{Value, json};

/// An LXM05, and what else the bench file says.
fn lxm05(rest: &str) -> String {
    format!("[[drive]]\nmodel = \"lxm05\"\n{rest}\n")
}

fn lost(once: u32) -> String {
    format!("[[disturb]]\nonce = {once}\nkind = \"lost\"\n")
}

#[test]
fn the_control_mode_in_force_is_shown_and_the_stored_one_where_it_differs() {
    // Data set 2 is active, and carries another P.412 than the others.
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 44, \"412@2\" = 1, \"414\" = 2 }\n";
    let state = antrieb("-a 1 statemachine").on(bench).json().exits(0);
    let mode = state.data("/drives/0/control_mode");
    assert_eq!((&mode["raw"], &mode["data_set"], &mode["store"]), (&json!(1), &json!(2), &json!("ram")));
    assert_eq!(state.data("/drives/0/control_mode_stored"), &json!(null), "the same value is stored there");
    let slugs = state.data("/drives/0/control/bits").as_array().unwrap();
    assert!(slugs.iter().any(|bit| bit["slug"] == "enable-operation"), "the bits are named by what is in force");
}

#[test]
fn a_control_mode_that_is_not_stored_is_told_in_both_languages() {
    let bench = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 44, \"412@1ram\" = 1 }\n";
    let state = antrieb("-a 1 statemachine").on(bench).json().exits(0);
    assert_eq!(state.data("/drives/0/control_mode/raw"), 1);
    assert_eq!(state.data("/drives/0/control_mode_stored/raw"), 44);
    let table = antrieb("-a 1 --lang de statemachine").on(bench).exits(0);
    assert!(table.out.contains("gespeichert, nicht wirksam  P.412 = 44"), "{}", table.out);
    let identity = antrieb("-a 1 identify").on(bench).json().exits(0);
    let modes = identity.data("/drives/0/values").as_array().unwrap().iter().filter(|value| value["param"] == 412);
    let modes: Vec<_> = modes.map(|value| (value["raw"].clone(), value["store"].clone())).collect();
    assert_eq!(modes, [(json!(1), json!("ram")), (json!(44), json!("eeprom"))]);
}

#[test]
fn one_lost_reply_makes_no_stranger_of_an_lxm05() {
    for (nth, pieces) in [(1, false), (1, true), (2, true), (3, true)] {
        let bench = lxm05(&format!("servo = {{ in_pieces = {pieces} }}")) + &lost(nth);
        let document = antrieb("-a 1 identify").on(&bench).json().exits(0);
        assert_eq!(document.data("/drives/0/drive"), "lxm05", "reply {nth}, in pieces: {pieces}");
        let scan = antrieb("-a 1 scan").on(&bench).json().exits(0);
        assert_eq!(scan.data("/drives/0/drive"), "lxm05", "reply {nth}, in pieces: {pieces}");
    }
}

#[test]
fn an_lxm05_is_asked_what_it_is_before_anything_that_it_refuses() {
    let run = antrieb("-a 1 -v diag").on(&lxm05("")).exits(0);
    let sent = run.sent();
    assert!(sent[0].starts_with("01 2B 0E 01 00"), "{sent:?}");
    assert!(!sent.iter().any(|hex| hex.starts_with("01 03 01 9B")), "P.411 is none of its own: {sent:?}");
    assert!(!run.err.contains("overwritten"), "{}", run.err);
    // Its answer is lost: it is asked for P.411, which is said.
    let run = antrieb("-a 1 diag").on(&(lxm05("") + &lost(1))).exits(0);
    assert!(run.err.contains("overwritten"), "{}", run.err);
}

#[test]
fn a_named_lxm05_shows_its_product_code() {
    let bench = lxm05("servo = { product = \"LXM05AD10M2\" }");
    for options in ["", "--drive lxm05"] {
        let document = antrieb(&format!("-a 1 {options} identify")).on(&bench).json().exits(0);
        assert_eq!(document.data("/drives/0/product"), "LXM05AD10M2", "{options}");
    }
    let table = antrieb("-a 1 --drive lxm05 identify").on(&bench).exits(0);
    assert!(table.out.contains("LXM05AD10M2"), "{}", table.out);
    assert_eq!(antrieb("-p sim -a 1 identify").json().exits(0).data("/drives/0/product"), &json!(null));
}

#[test]
fn an_lxm05_whose_product_code_begins_otherwise_is_known_by_its_own_address() {
    for order in [0, 1] {
        let bench = format!(
            "[[drive]]\nmodel = \"lxm05\"\naddress = 7\nset = {{ MBdword_order = {order} }}\n\
                             servo = {{ product = \"05A-D10\" }}\n"
        );
        let document = antrieb("-a 7 identify").on(&bench).json().exits(0);
        assert_eq!(document.data("/drives/0/drive"), "lxm05", "word order {order}");
        let evidence = document.data("/drives/0/evidence").as_array().unwrap();
        assert_eq!(evidence.last().unwrap()["asked"], "MBadr (5640)");
    }
}

#[test]
fn fences_use_what_an_lxm05_has() {
    for nth in 1..12 {
        let bench = lxm05("") + &lost(nth);
        let run = antrieb("-a 1 -v diag").on(&bench).exits(0);
        let reserved = |hex: &String| hex.starts_with("01 08 00 0E") || hex.starts_with("01 08 00 0F");
        assert!(!run.sent().iter().any(reserved), "reply {nth} lost: {:?}", run.sent());
    }
}

#[test]
fn a_silent_drive_hides_no_trip_under_check() {
    let bench = "[[drive]]\nmodel = \"act\"\n[[drive]]\nmodel = \"acu\"\naddress = 2\n\
                 [[drive.event]]\nat = \"0s\"\nfault = \"F0500\"\n";
    let document = antrieb("-a 1,2,7 diag --check").on(bench).json().exits(9);
    assert_eq!(document.error()["context"]["faulted"], "2");
    assert_eq!(document.error()["context"]["unknown"], "7");
    let message = document.error()["message"].as_str().unwrap();
    assert!(message.starts_with("a fault is present at address 2; not known of address 7"), "{message}");
    let german = antrieb("--lang de -a 2,7 diag --check").on(bench).exits(9);
    assert!(german.err.contains("eine Störung liegt an bei Adresse 2; nicht bekannt von Adresse 7"), "{}", german.err);
    antrieb("-a 1,2 diag --check").on(bench).json().exits(1);
    antrieb("-a 1,7 diag --check").on(bench).json().exits(9);
}

#[test]
fn a_silent_drive_is_something_to_complain_of() {
    let codes = |document: &Value| {
        let advice = document["data"]["advice"].as_array().unwrap();
        advice.iter().map(|row| row["code"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    let fine = antrieb("-p sim -a 1 diag line --count 5").json().exits(0);
    assert_eq!(codes(&fine.value), [""; 0]);
    let partly = antrieb("-p sim -a 1,7 diag line --count 5").json().exits(9);
    assert_eq!(codes(&partly.value), ["no_reply"]);
    for options in ["", "--drive act"] {
        let line = format!("-p sim -a 7 {options} diag line --count 5");
        assert_eq!(codes(&antrieb(&line).json().exits(4).value), ["no_reply"], "{options}");
        for lang in ["en", "de"] {
            let table = antrieb(&format!("{line} --lang {lang}")).exits(4);
            assert!(!table.out.contains("nothing to complain") && !table.out.contains("nichts zu beanstanden"));
        }
    }
    antrieb("-p sim --dry-run -a 1 diag line").json().exits(0);
}

#[test]
fn the_name_that_nobody_knows_is_blamed() {
    for line in ["read _p_act xyz", "read xyz _p_act", "--yes write RAMPacc=5 xyz=1"] {
        let document = antrieb(&format!("-a 1 {line}")).on(&lxm05("")).json().exits(7);
        let message = document.error()["message"].as_str().unwrap();
        assert!(message.contains("'xyz'"), "{line}: {message}");
    }
    let mixed = antrieb("-p sim -a 1 read _p_act rated-speed").json().exits(7);
    let message = mixed.error()["message"].as_str().unwrap();
    assert_eq!(message, "no drive has all of these: _p_act (lxm05), rated-speed (act, acu)");
}

#[test]
fn codes_and_addresses_are_understood_as_they_are_written() {
    for (line, key) in [
        ("decode fault EB303", "EB303"),
        ("decode fault eb303", "EB303"),
        ("--drive lxm05 decode fault E2300", "E2300"),
        ("--drive lxm05 decode fault 0x2300", "E2300"),
        ("decode fault F2105", "F2105"),
    ] {
        assert_eq!(antrieb(line).json().exits(0).data("/fault/key"), key, "{line}");
    }
    for (line, says) in [
        ("--drive act decode fault E2300", "F0500"),
        ("--drive lxm05 decode fault F0500", "E0500"),
        ("decode fault E+FF", "0x0500"),
    ] {
        let document = antrieb(line).json().exits(2);
        let message = document.error()["message"].as_str().unwrap();
        assert!(message.contains(says), "{line}: {message}");
    }
    for number in ["0x1E14", "1E14h", "16#1E14", "7700", "_p_act"] {
        let document = antrieb(&format!("-a 1 --drive lxm05 read {number}")).on(&lxm05("")).json().exits(0);
        assert_eq!(document.data("/values/0/param"), 7700, "{number}");
    }
}

#[test]
fn what_is_printed_nowhere_is_marked() {
    let row = |drive: &str, param: &str| {
        antrieb(&format!("--drive {drive} params {param}")).json().exits(0).data("/params/0").clone()
    };
    for param in ["1544", "1556", "9736", "10248", "6938"] {
        let unconfirmed = row("lxm05", param)["unconfirmed"].clone();
        assert!(unconfirmed.as_array().unwrap().contains(&json!("volatile")), "{param}: {unconfirmed}");
    }
    for param in ["5638", "5640", "5642", "5644", "5646"] {
        assert_eq!(row("lxm05", param)["unconfirmed"], json!([]), "printed in 4.1: {param}");
    }
    assert_eq!(row("act", "418")["default"], 3.5);
    let read = antrieb("-a 1 --drive lxm05 read RAMPacc MBadr MBnode_guard").on(&lxm05("")).json().exits(0);
    let stores = [0, 1, 2].map(|index| read.data(&format!("/values/{index}/store")).clone());
    assert_eq!(stores, [json!("unknown"), json!("eeprom"), json!("ram")]);
}

#[test]
fn nothing_is_written_unless_all_of_it_can_be() {
    let wrote = |sent: &[String]| sent.iter().any(|hex| hex[3..].starts_with("06") || hex[3..].starts_with("65"));
    for (line, exit, says) in [
        ("write 480@1=6 1500=5", 6, "unknown parameter"),
        ("write 480@1=6 1599@7=5", 6, "nothing was written"),
        ("write 480@1=6 270=1 --force 1500=5", 7, "width"),
    ] {
        let run = antrieb(&format!("-p sim -a 1 -v --yes {line}")).exits(exit);
        assert!(!wrote(&run.sent()), "{line}: {:?}", run.sent());
        assert!(run.err.to_lowercase().contains(says), "{line}: {}", run.err);
    }
    let run = antrieb("-a 1 --drive lxm05 -v --yes write RAMPacc=600 1548=5").on(&lxm05("")).exits(6);
    assert!(!run.sent().iter().any(|hex| hex.starts_with("01 10") || hex.starts_with("01 17")), "{:?}", run.sent());
    let broadcast = antrieb("-p sim -a 0 -v --yes write 480=6 1500=5").exits(7);
    assert_eq!(broadcast.sent(), [""; 0]);
}

#[test]
fn what_cannot_be_is_shown_raw_with_a_warning() {
    let twins = "[[drive]]\nmodel = \"foreign\"\nregisters = { \"1376\" = 0, \"10\" = 77, \"413\" = 17 }\n";
    let document = antrieb("-a 1 --drive act read 1376 10 413").on(twins).json().exits(0);
    let value = |index: usize| document.data(&format!("/values/{index}")).clone();
    assert_eq!((&value(0)["raw"], &value(0)["value"]), (&json!(0), &json!(null)));
    assert_eq!((&value(0)["expected"], &value(1)["expected"]), (&json!("1 … 247"), &json!("1, 2, 3, 4, 5, 6")));
    assert!(value(2).get("expected").is_none(), "a watchdog of 17 s may be");
    assert_eq!(document.warnings(), ["value.implausible", "value.implausible"]);
    let table = antrieb("-a 1 --drive act --lang de read 1376").on(twins).exits(0);
    assert!(table.out.contains("(Rohwert, unplausibel: erwartet 1 … 247)"), "{}", table.out);
    assert!(table.err.contains("zwei Antriebe mit einer Adresse"), "{}", table.err);
}

#[test]
fn a_file_never_makes_a_broadcast() {
    for (file, got) in [
        ("address = \"0\"\n", "got 0"),
        ("address = \"1,0\"\n", "got 0"),
        ("address = \"255\"\n", "got 255"),
        ("[drives.all]\naddress = 0\n", "got 0"),
        ("[drives.pump]\naddress = 255\n[drives.fan]\naddress = 1\n", "got 255"),
        ("[drives.pump]\naddress = 248\n", "got 248"),
    ] {
        for verb in ["--yes write 480=6", "read 372", "-a 1 read 372"] {
            let run = antrieb(&format!("-p sim -v {verb}")).file("antrieb.toml", file).exits(7);
            assert_eq!(run.sent(), [""; 0], "{file}{verb}");
            assert!(run.err.contains(got) && run.err.contains("antrieb.toml:"), "{file}{verb}: {}", run.err);
        }
    }
    let user = antrieb("-p sim --yes write 480=6").user_file("config.toml", "address = \"0\"\n").exits(7);
    assert!(user.err.contains("got 0"), "{}", user.err);
}

#[test]
fn what_a_project_file_decides_behind_ones_back_is_said() {
    let port = "port = \"tcp://127.0.0.1:1\"\n";
    for (lang, says) in
        [("en", "antrieb.toml sets the port: tcp://127.0.0.1:1"), ("de", "antrieb.toml bestimmt den Anschluss")]
    {
        let run = antrieb(&format!("--lang {lang} -a 1 read 372")).file("antrieb.toml", port).exits(3);
        assert!(run.err.contains(says), "{}", run.err);
    }
    let named = "[drives.pump]\naddress = 1\nport = \"mbtcp://127.0.0.1:1\"\n";
    let run = antrieb("-a pump read 372").file("antrieb.toml", named).exits(3);
    assert!(run.err.contains("antrieb.toml sets the port: mbtcp://127.0.0.1"), "{}", run.err);
    for quiet in ["-p sim -a 1 read 372", "decode status 0x0237"] {
        let run = antrieb(quiet).file("antrieb.toml", port).exits(0);
        assert!(!run.err.contains("sets the port"), "{quiet}: {}", run.err);
    }
    let rows = "schema = 1\nfamily = \"active\"\nparams = [{ id = 372, en = \"x\", de = \"x\", replace = true, access = \"r\", source = \"s\" }]\n";
    let run =
        antrieb("-p sim -a 1 read 372").file("antrieb.toml", "catalogue = [\"own.toml\"]\n").file("own.toml", rows);
    let run = run.exits(0);
    assert!(run.err.contains("antrieb.toml: the catalogue own.toml replaces rows of the built-in one"), "{}", run.err);
}

/// Under every reading of what the manual leaves open, on a good line and with a reply lost.
#[test]
fn an_lxm05_is_followed_or_found_waiting_for_its_power_on() {
    for (mbadr, mbbaud) in
        [("at-once", "at-once"), ("at-once", "power-on"), ("power-on", "at-once"), ("power-on", "power-on")]
    {
        for nth in [0, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14] {
            let readings = format!("readings = {{ mbadr = \"{mbadr}\", mbbaud = \"{mbbaud}\" }}");
            let bench = lxm05(&readings) + &if nth > 0 { lost(nth) } else { String::new() };
            let run = antrieb("-a 1 --yes line set --address 5 --baud 38400").on(&bench).json().exits(0);
            let address = if mbadr == "at-once" { 5 } else { 1 };
            let baud = if mbbaud == "at-once" { 38_400 } else { 19_200 };
            let now = run.data("/now");
            let case = format!("{mbadr} {mbbaud} {nth}: {now}");
            assert_eq!((&now["address"], &now["baud"]), (&json!(address), &json!(baud)), "{case}");
            let moved = (address, baud) == (5, 38_400);
            assert_eq!(run.data("/result"), if moved { "moved" } else { "stored" }, "{case}");
            let later = run.data("/after_restart");
            assert!(moved && later.is_null() || later["text"] == "rtu 38400 8E1, address 5", "{case}: {later}");
            let back = run.data("/way_back").as_str().unwrap();
            assert!(
                back.contains(&format!("-b {baud}")) && back.ends_with("line set --baud 19200 --address 1"),
                "{back}"
            );
        }
    }
}

#[test]
fn line_set_knows_the_settings_of_the_family() {
    for (line, exit, says) in [
        ("--drive lxm05 --yes line set --baud 57600", 7, "expected 9600, 19200, 38400, got 57600"),
        ("--yes line set --baud 115200", 7, "expected 9600, 19200, 38400, got 115200"),
        ("--yes line set --baud 300", 7, "expected 2400, 4800, 9600, 19200, 38400, 57600, 115200, got 300"),
        ("--yes protocol set vabus", 7, "speaks rtu and nothing else"),
    ] {
        let run = antrieb(&format!("-a 1 {line}")).on(&lxm05("")).json().exits(exit);
        let message = run.error()["message"].as_str().unwrap();
        assert!(message.contains(says), "{line}: {message}");
    }
    let asked = antrieb("-a 1 line set --address 5 --parity odd").on(&lxm05("")).answered("n").exits(8);
    for part in ["MBadr (5640)", "its manual does not say", "MBformat (5642)", "switched on the next time"] {
        assert!(asked.err.contains(part), "{part}: {}", asked.err);
    }
    let show = antrieb("-a 1 line show").on(&lxm05("")).json().exits(0);
    let params: Vec<_> = show.data("/values").as_array().unwrap().iter().map(|value| value["param"].clone()).collect();
    assert_eq!(params, [5638, 5640, 5642, 5646]);
    let planned = antrieb("-a 1 --drive lxm05 --dry-run line set --baud 9600 --address 3").json().exits(0);
    let writes: Vec<_> = planned.data("/telegrams").as_array().unwrap().iter().map(|row| row["hex"].clone()).collect();
    assert_eq!(writes.len(), 2, "no restart: {writes:?}");
    let warned = antrieb("-a 1 --lang de --yes write MBadr=9").on(&lxm05("")).exits(0);
    assert!(warned.err.contains("was die Anleitung nicht sagt"), "{}", warned.err);
}

/// Function codes that write, behind the address.
fn writes(telegrams: impl IntoIterator<Item = String>) -> Vec<String> {
    let writes = |hex: &String| ["06", "65", "10", "17"].contains(&&hex[3..5]);
    telegrams.into_iter().filter(writes).collect()
}

#[test]
fn a_dry_run_shows_every_telegram_that_the_run_writes() {
    let act = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 44, \"434\" = 2 }\n".to_owned();
    let motion = "--watchdog 2s --take-control --hold --duration 300ms";
    let servo = "--watchdog 2s --hold --duration 300ms";
    for (drive, bench, verb) in [
        ("act", act.clone(), format!("statemachine enable {motion}")),
        ("act", act, format!("sollwert 25Hz --enable {motion}")),
        ("lxm05", lxm05(""), format!("sollwert 1000rpm --mode velocity --set RAMPacc=2000 --enable {servo}")),
        ("lxm05", lxm05(""), format!("sollwert 48usr --enable {servo}")),
        ("lxm05", lxm05(""), format!("sollwert 5A --enable {servo} --on-exit quick-stop")),
    ] {
        let line = format!("-a 1 --drive {drive} --yes {verb}");
        let planned = antrieb(&line).on(&bench).and("--dry-run").json().exits(0);
        assert!(!planned.err.contains(" ms > "), "nothing is sent");
        let rows = planned.data("/telegrams").as_array().unwrap().clone();
        let planned_writes = writes(rows.iter().map(|row| row["hex"].as_str().unwrap().to_owned()));
        let sent = writes(antrieb(&format!("-v {line}")).on(&bench).exits(0).sent());
        for telegram in &sent {
            // What is given back is only known from the drive.
            let current_source = "01 10 1B 20 00 02 04 00 00 00 00";
            let target = "01 10 1B 1C 00 02 04 00 00 00 00";
            let given_back = ["01 06 51 9D", "01 06 61 9C", "01 10 16 0C", "01 10 06 14", current_source, target];
            let is_back = given_back.iter().any(|start| telegram.starts_with(start));
            assert!(planned_writes.contains(telegram) || is_back, "{verb}: {telegram} is not in {planned_writes:#?}");
        }
        assert!(planned.data("/notes").as_array().unwrap().len() >= 3, "{:#}", planned.value);
    }
}

/// Without --hold nothing stops the run, and nothing goes back; so it is with --on-exit keep.
#[test]
fn a_dry_run_stops_and_gives_back_nothing_that_the_run_leaves() {
    let act = "[[drive]]\nmodel = \"act\"\naddress = 1\nset = { \"412\" = 44 }\n";
    for verb in [
        "statemachine enable --take-control",
        "statemachine shutdown --take-control",
        "statemachine goto switched-on --take-control",
        "sollwert 25Hz --enable --take-control",
        "sollwert 25Hz --enable --take-control --hold --duration 300ms --on-exit keep",
        "sollwert 0 --source line",
    ] {
        let line = format!("-a 1 --drive act --yes {verb}");
        let planned = antrieb(&line).on(act).and("--dry-run").json().exits(0);
        let rows = planned.data("/telegrams").as_array().unwrap().clone();
        let planned_writes = writes(rows.iter().map(|row| row["hex"].as_str().unwrap().to_owned()));
        let sent = writes(antrieb(&format!("-v {line}")).on(act).run().sent());
        assert_eq!((planned_writes.first(), planned_writes.last()), (sent.first(), sent.last()), "{verb}: {sent:#?}");
        let notes = planned.data("/notes").to_string();
        assert!(notes.contains("what is changed stays so: ") && !notes.contains("written back"), "{verb}: {notes}");
    }
}

#[test]
fn a_dry_run_names_what_depends_on_answers() {
    let german = antrieb("-a 1 --dry-run --lang de statemachine enable --take-control").exits(0).out;
    for part in ["P.412", "P.249 sagt welcher", "Code 43", "'Einschaltsperre'", "bleibt so: P.412"] {
        assert!(german.contains(part), "{part}: {german}");
    }
    antrieb("-a 1 --dry-run statemachine goto switched-on").json().exits(0);
    antrieb("-a 1 --dry-run statemachine contacts S1IND --take-control").json().exits(0);
    let scan = antrieb("-p sim --dry-run scan").json().exits(0);
    assert_eq!(scan.data("/telegrams").as_array().unwrap().len(), 2, "the first and the last address");
    assert!(scan.data("/notes/0").as_str().unwrap().starts_with("247 address(es) on 1 port(s)"));
    let auto = antrieb("-p sim --baud auto --protocol auto --dry-run scan").exits(0).out;
    assert!(auto.contains("baud, protocol = auto"), "{auto}");
}

#[test]
fn a_number_that_is_too_large_is_out_of_range_and_no_misspelling() {
    for port in ["-p sim", ""] {
        let run =
            antrieb(&format!("{port} -a 1 --drive act sollwert 99999999999999999999Hz --dry-run")).json().exits(7);
        assert_eq!(run.error()["code"], "data.range");
        assert!(run.error()["message"].as_str().unwrap().contains("99999999999999999999"), "{}", run.error());
    }
    let run = antrieb("-p sim -a 1 write 480=99999999999999999999").json().exits(7);
    assert!(!run.error()["message"].as_str().unwrap().contains("neither a number"), "{}", run.error());
}

#[test]
fn a_broadcast_says_that_nobody_confirms_it() {
    let run = antrieb("-p sim --drive act -a 0 write 480@1ram=10 --yes").exits(0);
    assert!(run.err.contains("warning: sent to everybody: no drive confirms it"), "{}", run.err);
    let one = antrieb("-p sim -a 1 write 480@1ram=10 --yes").exits(0);
    assert!(!one.err.contains("everybody"), "{}", one.err);
}

#[test]
fn a_verb_under_another_one_is_hinted_at() {
    let run = antrieb("enable").exits(2);
    assert!(run.err.contains("hint: it is `antrieb statemachine enable`"), "{}", run.err);
    assert!(antrieb("enable --json").exits(2).out.contains("antrieb statemachine enable"));
    assert!(!antrieb("enabel").exits(2).err.contains("hint: it is"));
}

#[test]
fn who_was_asked_once_was_not_asked_times() {
    let silent = antrieb("-p sim -a 77 --retries 0 read 372").exits(4);
    assert!(silent.err.contains("asked once") && !silent.err.contains("1 times"), "{}", silent.err);
}

#[test]
fn a_dry_run_of_what_stops_begins_with_the_telegram_that_stops() {
    for (line, first) in [
        ("--drive acu statemachine quick-stop", "01 06 01 9A 00 02"),
        ("--drive acu statemachine disable-voltage", "01 06 01 9A 00 00"),
        ("--drive lxm05 statemachine quick-stop", "01 10 1B 02 00 02 04 00 00 00 02"),
    ] {
        let planned = antrieb(&format!("-a 1 {line} --dry-run")).json().exits(0);
        assert!(planned.data("/telegrams/0/hex").as_str().unwrap().starts_with(first), "{line}: {:#}", planned.value);
    }
    for (line, nth, stops) in [
        // P.410 tells whether it would close contacts; P.228 and P.282 what is left behind a zero.
        ("--drive acu statemachine disable", 1, "01 06 01 9A 00 07"),
        ("--drive acu sollwert 0", 2, "01 65 01 E4 00 00 00 00"),
    ] {
        let planned = antrieb(&format!("-a 1 {line} --dry-run")).json().exits(0);
        let hex = planned.data(&format!("/telegrams/{nth}/hex")).as_str().unwrap().to_owned();
        assert!(hex.starts_with(stops), "{line}: {:#}", planned.value);
        let german = antrieb(&format!("-a 1 --lang de {line} --dry-run")).exits(0).out;
        assert!(german.contains("geht zuerst hinaus"), "{german}");
    }
}
