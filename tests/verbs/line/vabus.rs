//! Every verb over VABus: the same values as over Modbus, strings, and nodes of the system bus.

use crate::run::antrieb;
use serde_json::json;

const CUBE: &str = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\naddress = 3\n\
                    nodes = [{ id = 17, model = \"acu\", set = { \"372\" = 2800 } }, { id = 5, model = \"act\" }]\n\
                    set = { \"19\" = \"0041\", \"412\" = 1 }\n";

fn on_cube(line: &str) -> crate::run::Run {
    antrieb(&format!("--protocol vabus {line}")).on(CUBE)
}

#[test]
fn a_drive_and_the_nodes_behind_it_are_told_apart() {
    for (address, node, drive, speed) in
        [("3", None, "acu", 1390), ("3.17", Some(17), "acu", 2800), ("3.5", Some(5), "act", 1390)]
    {
        let document = on_cube(&format!("-a {address} read 372@2")).json();
        let value = document.data("/values/0");
        assert_eq!((&value["drive"], &value["raw"]), (&json!(drive), &json!(speed)), "{address}");
        assert_eq!((&value["address"], value.get("node")), (&json!(3), node.map(|node| json!(node)).as_ref()));
    }
    let document = on_cube("-a 3.17 --yes write 480@1=-12.5").json();
    let written = document.data("/values/0");
    assert_eq!(
        (&written["node"], &written["result"], &written["old_raw"]),
        (&json!(17), &json!("verified"), &json!(500))
    );
}

#[test]
fn causes_of_the_system_bus_are_explained() {
    for (line, code) in [
        ("-a 3.18 read 372", "refused.systembus_node_unreachable"),
        ("-a 3.17 read 19", "refused.string_not_permitted"),
        ("-a 3.17 write 260=1 --force --yes", "refused.not_writable"),
    ] {
        let document = on_cube(line).json().exits(6);
        assert_eq!(document.error()["code"], code, "{line}");
    }
}

#[test]
fn strings_are_read() {
    let document = on_cube("-a 3 read 19").json();
    let value = document.data("/values/0");
    assert_eq!((&value["text"], &value["data_type"], &value["raw"]), (&json!("0041"), &json!("string"), &json!(null)));
}

#[test]
fn a_node_is_named_only_where_one_can_be_reached() {
    for line in [
        "-p sim -a 1.17 read 372",
        "-p sim --protocol vabus -a 1.64 read 372",
        "-p sim --protocol vabus -a 1,2.3 read 372",
    ] {
        assert_eq!(antrieb(line).json().exits(2).error()["code"], "usage.address", "{line}");
    }
    assert_eq!(on_cube("-a 3.17 --yes line set --address 4").json().exits(2).error()["code"], "usage.node");
}

#[test]
fn a_dry_run_shows_telegrams_of_vabus() {
    let document = on_cube("-a 3.17 --drive acu --dry-run write 480@1=12.5").json();
    let written = document.data("/values/0");
    assert_eq!(written["telegram"], "04 43 02 51 31 34 38 30 30 38 30 30 30 30 30 34 45 32 03 24");
}

#[test]
fn a_drive_is_moved_and_the_document_tells_where_it_is() {
    let fresh = "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\n";
    let moved = antrieb("--protocol vabus -a 1 --yes protocol set rtu").on(fresh).json().exits(0);
    assert_eq!((&moved.value["command"], moved.data("/result")), (&json!("protocol"), &json!("moved")));
    assert_eq!(moved.data("/now/text"), "rtu 19200 8E1, address 1");
    let line = "-p sim -a 1 -b 19200 --yes line set --baud 115200 --parity odd --address 5";
    let moved = antrieb(line).json().exits(0);
    let now = moved.data("/now");
    assert_eq!((&now["baud"], &now["parity"], &now["address"]), (&json!(115_200), &json!("odd"), &json!(5)));
    let document = antrieb("-p sim -a 2 line show").json();
    let shown = document.data("/values/1");
    assert_eq!((&shown["param"], &shown["text"]), (&json!(10), &json!("19200 Bd")));
}

#[test]
fn what_cannot_be_set_is_refused_before_anything_is_opened() {
    for (line, exit) in [
        ("-p sim -a 1 --yes line set", 2),
        ("-p sim -a 1 --yes line set --parity mark", 2),
        ("-p sim -a 1 --yes line set --baud 38400", 7),
        ("-p sim -a 1 --yes line set --address 248", 7),
        ("-p sim -a 1 --yes line set --address 300", 7),
        ("-p sim -a 1 --yes line set --address 0", 7),
        ("-p sim --yes line set --address 9", 2),
        ("-p sim -a 1,2 --yes line set --address 9", 2),
        ("-p sim -a 1 --yes protocol set p-bus", 2),
        ("-p sim -a 1 line set --address 9", 8),
        ("-p sim -a 1 --yes line set --address 2", 8),
    ] {
        antrieb(line).json().exits(exit);
    }
    // One range, whatever does not fit it.
    for address in [0, 250, 300] {
        let refused = antrieb(&format!("-p sim -a 1 --yes line set --address {address}")).exits(7);
        assert!(
            refused.err.starts_with(&format!("error: address: expected 1-247, got {address}\n")),
            "{}",
            refused.err
        );
    }
}

#[test]
fn the_question_names_every_step() {
    let asked = antrieb("-p sim -a 1 --yes --lang de line set --baud 115200").exits(0).err;
    assert!(asked.contains("P.10 Baudrate: 4 -> 6, gilt nach dem Neustart"), "{asked}");
    assert!(asked.contains("rtu 19200 8E1, Adresse 1 -> rtu 115200 8E1, Adresse 1"), "{asked}");
}

#[test]
fn a_dry_run_of_a_move_opens_nothing() {
    let hex = |line: &str| -> Vec<String> {
        let document = antrieb(&format!("-p /dev/nowhere --dry-run {line}")).json().exits(0);
        let telegrams = document.data("/telegrams").as_array().unwrap();
        telegrams.iter().map(|telegram| telegram["hex"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(hex("--protocol vabus -a 1 protocol set rtu"), ["04 41 02 30 30 33 39 35 30 34 30 30 30 32 03 3A"]);
    let moved = hex("-a 1 line set --baud 115200 --address 5");
    let starts: Vec<&str> = moved.iter().map(|telegram| &telegram[..17]).collect();
    assert_eq!(starts, ["01 06 05 60 00 05", "01 06 00 0A 00 06", "01 06 00 22 00 7B"]);
}

#[test]
fn every_verb_speaks_vabus() {
    for line in [
        "-a 3 identify",
        "-a 3 read @modbus",
        "-a 3 --yes write 376@4=1.5kW 480@2ram=-12",
        "-a 3 dataset show 480",
        "-a 3 --yes dataset copy 1 2 480",
        "-a 3 diag",
        "-a 3 statemachine",
        "-a 3 --yes statemachine enable",
        "-a 3 --yes sollwert 10Hz",
        "-a 1-4 scan",
        "-a 3 protocol show",
    ] {
        on_cube(line).json().exits(0);
    }
}

#[test]
fn questions_name_the_node() {
    let asked = on_cube("-a 3.17 --yes write 480@1=12.5").exits(0).err;
    assert!(asked.contains("drive 3.17 (acu): P.480@1"), "{asked}");
    let asked = on_cube("-a 3.5 --yes --lang de statemachine enable --take-control").exits(0).err;
    assert!(asked.contains("Antrieb 3.5 (act): jetzt in"), "{asked}");
}
