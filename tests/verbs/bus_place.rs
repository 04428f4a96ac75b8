//! A drive is moved on the system bus over that bus: its bit rate and its channels. When that holds is in no source (EM-RES-03 manual 5.4,
//! 5.9.4), so each is tried with drives that take it at once, from power-on, and from a Reset Node.

use crate::run::antrieb;
use antrieb::simulator::Can;
use antrieb::transport::witness;
use serde_json::json;

/// When a place holds, whether the drive has moved then, and what is told.
const READINGS: [(&str, bool, &str); 3] =
    [("power-on", false, "stored"), ("at-once", true, "moved"), ("reset-node", false, "stored")];

fn bus(reading: &str, nodes: &[(u8, &str)]) -> String {
    let row = |(id, set): &(u8, &str)| format!("[[drive]]\nmodel = \"acu\"\naddress = {id}\nset = {{ {set} }}\n");
    format!("[readings]\nplace = \"{reading}\"\n{}", nodes.iter().map(row).collect::<String>())
}

fn left() -> Can {
    witness::left_can().unwrap()
}

#[test]
fn a_bit_rate_is_changed_and_followed_whenever_it_holds() {
    for (reading, moves, result) in READINGS {
        let typed = "--protocol sdo -a 5 --yes line set --baud 250000";
        let run = antrieb(typed).on(&bus(reading, &[(5, "")])).json().exits(0);
        let now = if moves { 250_000 } else { 500_000 };
        assert_eq!([run.data("/now/baud"), run.data("/result")], [&json!(now), &json!(result)], "{reading}");
        let back = run.data("/way_back").as_str().unwrap();
        assert!(back.ends_with(&format!("-b {now} -a 5 line set --baud 500000")), "{back}");
        let bus = left();
        assert_eq!(bus.eeprom(5, 903, 0), Some(6), "{reading}");
        assert!(bus.remarks().is_empty() && !bus.is_open(), "{reading}: {:?}", bus.remarks());
    }
}

/// Two rates on one bus, and nobody understands anybody.
#[test]
fn a_bit_rate_is_not_changed_beside_others() {
    for (others, named) in [((6, ""), "6"), ((0, "\"919\" = 0"), "master"), ((0, "\"919\" = 50"), "master")] {
        let run = antrieb("--protocol sdo -a 5 --yes line set --baud 250000").on(&bus("at-once", &[(5, ""), others]));
        let run = run.json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.others_on_bus");
        assert!(run.error()["message"].as_str().unwrap().contains(&format!("({named})")), "{}", run.error());
        let bus = left();
        assert!(bus.counts()[2] == 0 && bus.remarks().is_empty(), "{:?}", bus.remarks());
    }
}

#[test]
fn the_channel_for_tools_is_switched_off_and_on_over_the_bus() {
    for (reading, moves, result) in READINGS {
        let typed = "--protocol sdo -a 5 --yes protocol set sdo1";
        let run = antrieb(typed).on(&bus(reading, &[(5, ""), (6, "")])).json().exits(0);
        let now = if moves { "sdo1" } else { "sdo" };
        assert_eq!([run.data("/now/protocol"), run.data("/result")], [&json!(now), &json!(result)], "{reading}");
        let back = run.data("/way_back").as_str().unwrap();
        assert!(back.contains(&format!("--protocol {now} ")) && back.ends_with("protocol set sdo"), "{back}");
        let end = left();
        assert!(end.eeprom(5, 923, 0) == Some(0) && end.remarks().is_empty(), "{:?}", end.remarks());
        // And back, over the channel that is left.
        let typed = "--protocol sdo1 -a 5 --yes protocol set sdo";
        let run = antrieb(typed).on(&bus(reading, &[(5, "\"923\" = 0")])).json().exits(0);
        let now = if moves { "sdo" } else { "sdo1" };
        assert_eq!([run.data("/now/protocol"), run.data("/result")], [&json!(now), &json!(result)], "{reading}");
        let end = left();
        assert!(end.eeprom(5, 923, 0) == Some(1) && end.remarks().is_empty(), "{:?}", end.remarks());
    }
    let there = antrieb("--protocol sdo1 -a 5 --yes protocol set sdo").on(&bus("at-once", &[(5, "")])).json().exits(0);
    assert_eq!(*there.data("/result"), json!("unchanged"));
}

#[test]
fn a_drive_that_would_be_out_of_reach_keeps_its_channel() {
    for (nodes, code) in [
        (vec![(5, "\"921\" = 1700")], "forbidden.own_line"),
        (vec![(5, ""), (0, "\"919\" = 50")], "forbidden.other_master"),
    ] {
        let run = antrieb("--protocol sdo -a 5 --yes protocol set sdo1").on(&bus("at-once", &nodes)).json().exits(8);
        assert_eq!(run.error()["code"], code);
        let bus = left();
        assert!(bus.counts()[2] == 0 && bus.remarks().is_empty(), "{:?}", bus.remarks());
    }
}

/// What sets the channel that nobody asks over is a setting like any other.
#[test]
fn the_other_channel_is_set_by_write() {
    for (protocol, what, code) in [
        ("sdo", "921=1700", 0),
        ("sdo", "922=1500", 0),
        ("sdo", "921=1700 922=1500", 0),
        ("sdo1", "923=0", 0),
        ("sdo", "923=0", 8),
        ("sdo1", "921=1700", 8),
        ("sdo", "903=6", 8),
    ] {
        for (reading, ..) in READINGS {
            let typed = format!("--protocol {protocol} -a 5 --yes write {what}");
            let run = antrieb(&typed).on(&bus(reading, &[(5, "")])).json().exits(code);
            if code == 8 {
                assert_eq!(run.error()["code"], "forbidden.own_line", "{what}");
                assert!(run.error()["hint"].as_str().unwrap().contains("antrieb "), "{}", run.error());
            }
            // It is read back, and nobody is told that the drive is gone.
            let results = run.value.pointer("/data/values").and_then(|rows| rows.as_array());
            let is_proven = results.is_some_and(|rows| rows.iter().all(|row| row["result"] == "verified"));
            assert!(code == 8 || is_proven && run.value["warnings"] == json!([]), "{what}: {:#}", run.value);
            // Refused before the line is opened, where the catalogue alone tells.
            let bus = witness::left_can();
            assert!(bus.as_ref().is_none_or(|bus| bus.remarks().is_empty()), "{what}");
            assert!(code == 0 || bus.is_none_or(|bus| bus.counts()[2] == 0), "{what}");
        }
    }
}

#[test]
fn what_is_no_setting_of_the_line_is_refused() {
    for typed in [
        "--protocol sdo -a 5 --yes line set --baud 9600",
        "--protocol sdo -a 5 --yes line set --parity even",
        "--protocol sdo -a 5 --yes protocol set rtu",
    ] {
        antrieb(typed).on(&bus("at-once", &[(5, "")])).exits(7);
    }
    antrieb("-a 5 --yes protocol set sdo1").on("[[drive]]\nmodel = \"acu\"\naddress = 5\n").exits(7);
    let plan = antrieb("--protocol sdo -a 5 line set --baud 250000 --dry-run").on(&bus("at-once", &[(5, "")]));
    assert_eq!(*plan.json().exits(0).data("/telegrams/0/hex"), json!("645#2B 87 03 00 06 00 00 00"));
}

#[test]
fn the_line_of_a_bus_is_the_place_on_it_and_a_shaft_is_not_commanded_over_it() {
    let run = antrieb("--protocol sdo -a 5 line show").on(&bus("power-on", &[(5, "")])).json().exits(0);
    let shown: Vec<_> = run.data("/values").as_array().unwrap().iter().map(|row| row["param"].clone()).collect();
    assert_eq!(shown, [900, 903, 921, 922, 923]);
    for verb in ["statemachine enable", "sollwert 5Hz"] {
        let run = antrieb(&format!("--protocol sdo -a 5 {verb}")).on(&bus("power-on", &[(5, "")])).json().exits(2);
        assert!(
            run.error()["hint"].as_str().unwrap().contains("no watchdog of a drive watches SDO"),
            "{}",
            run.error()
        );
    }
}

/// Whatever is said to do next can be done on a CAN bus.
#[test]
fn a_drive_that_is_lost_is_searched_for_as_a_bus_can_be_searched() {
    let gone = "[[drive.event]]\nafter_writes = 1\nsilent = \"10h\"\n";
    let bench = bus("at-once", &[(5, "")]) + gone;
    for typed in ["line set --baud 250000", "line set --address 7"] {
        let run = antrieb(&format!("--protocol sdo -a 5 --yes {typed}")).on(&bench).json().exits(4);
        assert_eq!(run.error()["code"], "silence.lost", "{:#}", run.value);
        let hint = run.error()["hint"].as_str().unwrap();
        assert!(hint.contains("scan` asks every node at one bit rate") && !hint.contains("auto"), "{hint}");
    }
}

#[test]
fn whoever_gives_a_node_another_number_is_told_who_stays_unseen() {
    let asked =
        antrieb("--protocol sdo -a 5 line set --address 7").on(&bus("at-once", &[(5, "")])).answered("n").exits(8);
    assert!(asked.err.contains("a stopped node"), "{}", asked.err);
    let serial = "[[drive]]\nmodel = \"acu\"\naddress = 5\n";
    let asked = antrieb("-a 5 line set --address 7").on(serial).answered("n").exits(8);
    assert!(!asked.err.contains("stopped"), "{}", asked.err);
}

/// What settles a plug, or a place, that nothing of this goes over is a setting like any other: it is read back, and nobody is told
/// that the drive is gone.
#[test]
fn what_does_not_lie_on_the_way_to_a_drive_cuts_nothing() {
    let behind = "[[drive]]\nmodel = \"acu\"\naddress = 3\nprotocol = \"vabus\"\nmodules = [\"EM-RES-03\"]\n\
                  nodes = [{ id = 17, model = \"acu\", modules = [\"EM-RES-03\"] }]\n";
    for (way, bench) in [
        ("--protocol sdo -a 5", bus("at-once", &[(5, "")])),
        ("--protocol sdo1 -a 5", bus("at-once", &[(5, "")])),
        ("--protocol vabus -a 3.17", behind.to_owned()),
    ] {
        // The master asks the SDO1 of its nodes, so their SDO2 is not on that way.
        let more = if way.contains("vabus") { "923=1" } else { "395=2" };
        for what in ["395=0", "395=2", "10=5", "394=7", "1376=9", "395=2 10=5", more] {
            let run = antrieb(&format!("{way} --yes --force write {what}")).on(&bench).json().exits(0);
            let rows = run.data("/values").as_array().unwrap();
            assert!(rows.iter().all(|row| row["result"] == "verified"), "{way} {what}: {:#}", run.value);
            assert_eq!(run.value["warnings"], json!([]), "{way} {what}");
            assert!(!run.err.contains("line set") && !run.err.contains("protocol set"), "{}", run.err);
        }
    }
    // Its place on the bus is on the way of who asks it through another drive: it is looked for where it was.
    for (what, back) in [("900=9", "at 3.9"), ("903=4", "its own serial plug"), ("921=1700", "serial plug")] {
        let run = antrieb(&format!("--protocol vabus -a 3.17 --yes write {what}")).on(behind).json().exits(0);
        assert_eq!(*run.data("/values/0/result"), json!("verified"), "{what}");
        let told = run.value["warnings"][0]["message"].as_str().unwrap();
        assert!(told.contains("still answers at 3.17") && told.contains("no source") && told.contains(back), "{told}");
    }
    for typed in ["--yes write 921=1700 922=1500", "--yes dataset load {dir}/x.toml --only 900"] {
        let file = "antrieb = 1\ndrive.family = \"acu\"\nvalues.900 = 9\n";
        let run = antrieb(&format!("--protocol vabus -a 3.17 {typed}")).on(behind).file("x.toml", file).json();
        let hint = run.error()["hint"].as_str().unwrap();
        assert!(hint.contains("still answers") || hint.contains("noch antwortet"), "{typed}: {hint}");
    }
}
