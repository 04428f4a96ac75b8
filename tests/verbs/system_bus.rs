//! Drives on the system bus: what they are set to, held against a plan, and set to it; over the bus itself and over the serial plug.

use crate::run::antrieb;
use antrieb::transport::witness;
use serde_json::{Value, json};

const PLAN: &str = include_str!("../../docs/examples/system-bus-setpoint.toml");

/// What drive-2 of the plan has when it has all of it.
const SET: &str = "\"99\" = 704, \"137\" = 709, \"924\" = 385, \"936\" = 1, \"941\" = 40";

/// Drives on a serial line or on a bus, each with its address and more settings.
fn drives(rows: &[(u8, &str)]) -> String {
    let row = |(address, set): &(u8, &str)| {
        format!("[[drive]]\nmodel = \"acu\"\naddress = {address}\nmodules = [\"EM-RES-03\"]\nset = {{ {set} }}\n")
    };
    rows.iter().map(row).collect()
}

fn on_bus(rows: &[(u8, &str)]) -> String {
    drives(rows).replace("modules = [\"EM-RES-03\"]\n", "")
}

#[test]
fn what_drives_are_set_to_is_the_same_over_every_protocol() {
    let set = "\"900\" = 5, \"903\" = 7, \"923\" = 1, \"918\" = 100, \"930\" = 2, \"950\" = 740, \"955\" = 62, \"934\" = 1, \
               \"929\" = 900, \"936\" = 2, \"924\" = 385, \"941\" = 40, \"99\" = 704";
    let vabus = drives(&[(5, set)]).replace("address = 5", "address = 5\nprotocol = \"vabus\"");
    let benches = [("", drives(&[(5, set)])), ("--protocol vabus", vabus), ("--protocol sdo", on_bus(&[(5, set)]))];
    let found = benches.each_ref().map(|(protocol, bench)| {
        let run = antrieb(&format!("{protocol} -a 5 systembus show")).on(bench).json().exits(0);
        let mut drive = run.data("/drives/0").clone();
        // A serial bench has no bus that its module could be on.
        drive
            .as_object_mut()
            .unwrap()
            .retain(|name, _| !["values", "node_state", "node_state_text"].contains(&&**name));
        drive
    });
    assert_eq!((&found[0], &found[0]), (&found[1], &found[2]));
    let of = |path: &str| found[0].pointer(path).cloned().unwrap_or(Value::Null);
    assert_eq!(
        ["/node", "/rate_kbd", "/sync_identifier", "/rx_sdo1"].map(of),
        [json!(5), json!(500), json!(100), json!(1541)]
    );
    let sent = ["/sent/0/identifier", "/sent/0/function", "/sent/1/function", "/sent/2/identifier"].map(of);
    assert_eq!(sent, [json!(389), json!("sync"), json!("off"), json!(900)]);
    assert_eq!(of("/sent/0/places/1/param"), 955);
    assert_eq!(of("/sent/0/places/1/source_name"), "Output of frequency setpoint channel");
    // A 2 tells how the others are counted, too.
    assert_eq!(["/rx_functions", "/received/1/function"].map(of), [json!("0-2"), json!("off")]);
    assert_eq!(["/received/0/ms", "/received/0/places/0/param"].map(of), [json!(40), json!(99)]);
    let page = antrieb("--lang de -a 5 systembus show").on(&benches[0].1).exits(0).out;
    assert!(page.contains("500 kBd") && page.contains("99 Quelle Steuerwort"), "{page}");
}

#[test]
fn codes_with_two_meanings_are_told_as_such() {
    let run = antrieb("-a 5 systembus show").on(&drives(&[(5, "\"936\" = 1")])).json().exits(0);
    assert_eq!(run.value["warnings"][0]["code"], "rx_functions");
    assert_eq!(
        (run.data("/drives/0/received/0/function"), run.data("/drives/0/received/0/code")),
        (&Value::Null, &json!(1))
    );
    // A drive without the module knows none of it.
    let bare = "[[drive]]\nmodel = \"acu\"\naddress = 5\n";
    let run = antrieb("-a 5 systembus show").on(bare).json().exits(6);
    assert!(run.error()["hint"].as_str().unwrap().contains("EM-RES-03"));
    let run = antrieb("-a 1 systembus show").on("[[drive]]\nmodel = \"lxm05\"\naddress = 1\n").json().exits(7);
    assert_eq!(run.error()["code"], "data.no_system_bus");
}

#[test]
fn a_plan_is_held_against_the_drives() {
    let check = "--protocol sdo systembus check {dir}/bus.toml drive-2";
    let same = on_bus(&[(1, SET)]);
    let run = antrieb(check).on(&same).file("bus.toml", PLAN).json().exits(0);
    assert_eq!(run.data("/drives/0/equal"), true);
    let other = on_bus(&[(1, &SET.replace("385", "386"))]);
    let run = antrieb(check).on(&other).file("bus.toml", PLAN).json().exits(1);
    let rows = run.data("/drives/0/differences").as_array().unwrap();
    assert_eq!((rows.len(), &rows[0]["param"]), (1, &json!(924)));
    assert!(run.error()["hint"].as_str().unwrap().contains("systembus apply"));
    let remarks = witness::left_can().unwrap().remarks().to_vec();
    assert!(remarks.is_empty(), "{remarks:?}");
    antrieb(check).on(&on_bus(&[(2, SET)])).file("bus.toml", PLAN).exits(4);
}

#[test]
fn a_plan_goes_into_its_drives_over_the_bus_and_back() {
    let plan = PLAN.replace("node = 0 ", "node = 3 ").replace("master\n", "\n");
    let plan = plan.replace("boot-up-delay = 3500\nemergency-reaction = \"fault\"\n", "rx-functions = \"0-2\"\n");
    let plan = plan.replace("sync-every = 10", "master = \"external\"");
    let bench = on_bus(&[(1, "\"932\" = 1, \"960\" = 5"), (3, "")]);
    let apply = "--protocol sdo --yes systembus apply {dir}/bus.toml";
    let run = antrieb(apply).on(&bench).file("bus.toml", &plan).exits(0);
    let bus = witness::left_can().unwrap();
    let of = |node, param| bus.eeprom(node, param, 0).unwrap();
    assert_eq!([924, 936, 941, 932, 960].map(|param| of(1, param)), [385, 1, 40, 0, 9], "what is unused is off");
    assert_eq!([925, 930, 931, 950, 955].map(|param| of(3, param)), [385, 1, 8, 740, 62]);
    assert_eq!([99, 137].map(|param| of(1, param)), [704, 709]);
    assert!(bus.remarks().is_empty() && !bus.is_open(), "{:?}", bus.remarks());
    assert!(run.text_of("bus-drive-2.undo.toml").contains("[undo]"));
    let back = run.then("--protocol sdo -a 1 --yes dataset undo {dir}/bus-drive-2.undo.toml");
    back.on(&bench).exits(0);
}

/// A byte of a TxPDO that changes its user: given free before it is taken, there, on the way back, and by the undo file.
#[test]
fn a_byte_is_given_free_before_it_is_taken() {
    let plan = "[bus]\nmaster = \"external\"\nrate = 500\n[drives.a]\nnode = 1\n[[pdo]]\nfrom = \"a\"\nnumber = 1\nevery = 8\n\
                identifier = 385\nput = { PUT }\n";
    for (stands, put) in [
        ("\"955\" = 62", "word4 = 740"),
        ("\"953\" = 740", "long2 = 62"),
        ("\"953\" = 740", "boolean3 = 161, word4 = 741"),
    ] {
        let bench = format!("[readings]\nshared_byte = \"abort-1\"\n{}", on_bus(&[(1, stands)]));
        let plan = plan.replace("PUT", put);
        let apply = "--protocol sdo --yes systembus apply {dir}/bus.toml";
        let run = antrieb(apply).on(&bench).file("bus.toml", &plan).exits(0);
        let all = |bus: &antrieb::simulator::Can| (946..=955).map(|id| bus.eeprom(1, id, 0)).collect::<Vec<_>>();
        let then = witness::left_can().unwrap();
        let rows = (900..=989).filter_map(|id| Some(format!("\"{id}\" = {}", then.eeprom(1, id, 0)?)));
        let bench =
            format!("[readings]\nshared_byte = \"abort-1\"\n{}", on_bus(&[(1, &rows.collect::<Vec<_>>().join(", "))]));
        run.then("--protocol sdo -a 1 --yes dataset undo {dir}/bus-a.undo.toml").on(&bench).exits(0);
        let undone = witness::left_can().unwrap();
        assert_ne!(all(&then), all(&undone));
        // Another drive fails, and this one goes back.
        let (place, taker) = if put.contains("long2") { ("long2", 137) } else { ("word4", 99) };
        let both = format!(
            "{plan}[[pdo.to]]\ndrive = \"b\"\nnumber = 1\ntake = {{ {place} = {taker} }}\n[drives.b]\nnode = 2\nrx-functions = \"0-1\"\n"
        );
        let worn = on_bus(&[(2, "")]) + &format!("eeprom = {{ \"{taker}\" = \"refuses\" }}\n");
        let failing = format!("[readings]\nshared_byte = \"abort-1\"\n{}{worn}", on_bus(&[(1, stands)]));
        let run = antrieb(apply).on(&failing).file("bus.toml", &both).run();
        assert!(run.exit != 0 && run.out.contains("restored"), "{}", run.out);
        assert_eq!(all(&witness::left_can().unwrap()), all(&undone), "{}\n{}", run.out, run.err);
    }
}

/// A drive behind its master, over the plug of that one.
#[test]
fn a_node_behind_a_drive_shows_itself() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 3\nprotocol = \"vabus\"\nmodules = [\"EM-RES-03\"]\nset = { \"900\" = 0 }\n\
                 [[drive.nodes]]\nid = 17\nmodel = \"acu\"\nmodules = [\"EM-RES-03\"]\n\
                 set = { \"900\" = 17, \"930\" = 1, \"950\" = 740 }\n";
    let of =
        |address: &str| antrieb(&format!("--protocol vabus -a {address} systembus show")).on(bench).json().exits(0);
    assert_eq!((of("3").data("/drives/0/node"), of("3.17").data("/drives/0/node")), (&json!(0), &json!(17)));
    assert_eq!(*of("3.17").data("/drives/0/sent/0/places/0/source"), json!(740));
}

/// The master has a station of its own, which is not everybody: read, written, and set by a plan with the others.
#[test]
fn the_master_drive_is_reached_over_the_bus() {
    let bench = on_bus(&[(0, "\"480\" = 7"), (1, "")]);
    let run = antrieb("--protocol sdo -a master read 900 480").on(&bench).json().exits(0);
    let raw = |nth: usize| {
        run.data("/values").as_array().unwrap().get(nth).map(|row| (row["raw"].clone(), row["address"].clone()))
    };
    assert_eq!([raw(0), raw(1)], [Some((json!(0), json!(64))), Some((json!(700), json!(64)))], "{:#}", run.value);
    antrieb("--protocol sdo -a 64 --yes write 480@1=8Hz").on(&bench).exits(0);
    let bus = witness::left_can().unwrap();
    assert_eq!([bus.eeprom(0, 480, 1), bus.eeprom(1, 480, 1)], [Some(800), Some(500)]);
    assert!(bus.remarks().is_empty() && bus.orders().is_empty(), "{:?}", bus.remarks());
    let run = antrieb("--protocol sdo --yes systembus apply {dir}/bus.toml").on(&bench).file("bus.toml", PLAN);
    run.exits(0);
    let bus = witness::left_can().unwrap();
    assert_eq!([925, 931, 950, 955].map(|param| bus.eeprom(0, param, 0)), [385, 8, 740, 62].map(Some));
    assert_eq!([924, 941, 99].map(|param| bus.eeprom(1, param, 0)), [385, 40, 704].map(Some));
    // It is found where it is silent, and beside itself nobody else is asked.
    let run = antrieb("--protocol sdo scan").on(&bench).json().exits(0);
    let found = run.data("/drives").as_array().unwrap();
    assert_eq!(found.iter().map(|row| row["address"].clone()).collect::<Vec<_>>(), [json!(1), json!(64)]);
    for line in ["-a master read 411", "--protocol sdo -a 0 read 411", "--protocol sdo -a 65 read 411"] {
        assert_eq!(antrieb(line).on(&drives(&[(1, "")])).json().exits(2).error()["code"], "usage.address", "{line}");
    }
}

#[test]
fn a_line_is_opened_once() {
    for (verb, code) in [("check", 1), ("apply", 0)] {
        let typed = format!("--protocol sdo --yes --trace {{dir}}/line.txt systembus {verb} {{dir}}/bus.toml drive-2");
        let run = antrieb(&typed).on(&on_bus(&[(1, "")])).file("bus.toml", PLAN).exits(code);
        assert_eq!(run.text_of("line.txt").matches("> 4F 0D").count(), 1, "{}", &run.text_of("line.txt")[..400]);
    }
}

#[test]
fn all_drives_get_it_or_none() {
    let plan =
        PLAN.replace("node = 0 ", "node = 3 ").replace("boot-up-delay = 3500\nemergency-reaction = \"fault\"\n", "");
    let plan = plan.replace("sync-every = 10", "master = \"external\"");
    let apply = "--protocol sdo --yes systembus apply {dir}/bus.toml";
    let run = antrieb(apply).on(&on_bus(&[(1, "")])).file("bus.toml", &plan).json();
    let writes = witness::left_can().unwrap().counts()[2];
    assert!([4, 9].contains(&run.exit) && writes == 0, "{}: {writes} written", run.exit);
}

#[test]
fn how_functions_are_counted_is_found_out_or_must_be_said() {
    let silent = PLAN.replace("rx-functions = \"0-2\"", "#");
    let apply = "--protocol sdo --yes systembus apply {dir}/bus.toml drive-2";
    for verb in ["check", "apply"] {
        let run =
            antrieb(&apply.replace("apply", verb)).on(&on_bus(&[(1, SET)])).file("bus.toml", &silent).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.rx_functions", "{verb}");
        assert!(run.error()["hint"].as_str().unwrap().contains("rx-functions"));
        assert_eq!(witness::left_can().unwrap().counts()[2], 0);
    }
    let shows = on_bus(&[(1, &format!("{SET}, \"937\" = 2"))]);
    antrieb(apply).on(&shows).file("bus.toml", &silent).exits(0);
    let bus = witness::left_can().unwrap();
    assert_eq!([936, 937].map(|param| bus.eeprom(1, param, 0)), [Some(1), Some(0)]);
    let contradicts = PLAN.replace("\"0-2\"", "\"0-1\"");
    let run = antrieb(apply).on(&shows).file("bus.toml", &contradicts).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.rx_functions");
    antrieb(apply).on(&on_bus(&[(1, "")])).file("bus.toml", &contradicts).exits(0);
    assert_eq!(witness::left_can().unwrap().eeprom(1, 936, 0), Some(0), "0 is by time there");
}

#[test]
fn over_the_bus_nobody_is_moved_on_it() {
    let plan = PLAN.replace("node = 1\n", "node = 1\nsdo2 = false\n");
    let run = antrieb("--protocol sdo --yes systembus apply {dir}/bus.toml drive-2").on(&on_bus(&[(1, "")]));
    let run = run.file("bus.toml", &plan).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.own_line");
    assert_eq!(witness::left_can().unwrap().counts()[2], 0);
    let file = "antrieb = 1\ndrive.family = \"acu\"\nvalues.923 = 0\n";
    let run = antrieb("--protocol sdo -a 1 --yes dataset load {dir}/x.toml --only 923").on(&on_bus(&[(1, "")]));
    assert_eq!(run.file("x.toml", file).json().exits(8).error()["code"], "forbidden.cuts");
}

/// No source tells when a node holds (5.5), so the drive is looked for at both.
#[test]
fn a_node_is_moved_over_the_bus_and_found_whenever_it_holds() {
    for (place, now, result) in [("power-on", 5, "stored"), ("at-once", 9, "moved"), ("reset-node", 5, "stored")] {
        let bench = format!("[readings]\nplace = \"{place}\"\n{}", on_bus(&[(5, ""), (6, "")]));
        let run = antrieb("--protocol sdo -a 5 --yes line set --address 9").on(&bench).json().exits(0);
        assert_eq!([run.data("/now/address"), run.data("/result")], [&json!(now), &json!(result)], "{place}");
        let back = run.data("/way_back").as_str().unwrap();
        assert!(back.ends_with(&format!("-a {now} line set --address 5")) && !back.contains("parity"), "{back}");
        let bus = witness::left_can().unwrap();
        assert_eq!((bus.eeprom(now, 900, 0), bus.remarks().len()), (Some(9), 0), "{place}: {:?}", bus.remarks());
    }
    let bench = on_bus(&[(5, ""), (6, ""), (0, "")]);
    for (typed, exit) in [
        ("-a 5 --yes line set --address 6", 8),
        ("-a 5 --yes line set --address 64", 7),
        ("-a 5 --yes line set --baud 9600", 7),
        ("-a master --yes line set --address 9", 8),
        ("-a 5 line set --address 9", 8),
    ] {
        antrieb(&format!("--protocol sdo {typed}")).on(&bench).exits(exit);
        assert!(witness::left_can().is_none_or(|bus| bus.counts()[2] == 0), "{typed}");
    }
    let run = antrieb("--protocol sdo -a 5 line set --address 9 --dry-run").on(&bench).json().exits(0);
    assert_eq!(*run.data("/telegrams/0/hex"), json!("645#2B 84 03 00 09 00 00 00"));
}

#[test]
fn over_the_serial_plug_a_drive_gets_its_place_too() {
    let bench = drives(&[(1, ""), (7, "")]);
    let typed = "--yes systembus apply {dir}/bus.toml drive-1=1 drive-2=7";
    let run = antrieb(typed).on(&bench).file("bus.toml", PLAN).json().exits(0);
    assert_eq!(run.value["warnings"][0]["code"], "bus.in_force");
    let rows = run.data("/drives/1/values").as_array().unwrap();
    let of = |param: u32| rows.iter().find(|row| row["param"] == param).map(|row| row["result"].clone());
    assert_eq!([900, 903, 924, 99].map(of), [900, 903, 924, 99].map(|_| Some(json!("verified"))));
    // The same, with their places in the project file.
    let project = "[drives.drive-1]\naddress = 1\n[drives.drive-2]\naddress = 7\n";
    let run = antrieb("--config {dir}/plant.toml --dry-run systembus apply {dir}/bus.toml").on(&bench);
    let run = run.file("bus.toml", PLAN).file("plant.toml", project).json().exits(0);
    assert_eq!(*run.data("/drives/1/address"), json!(7));
}

#[test]
fn a_plan_that_does_not_do_opens_nothing() {
    let broken = PLAN.replace("identifier = 385", "identifier = 150");
    for (typed, plan, code, what) in [
        ("systembus apply {dir}/bus.toml drive-1=1", broken.as_str(), 7, "data.plan"),
        ("systembus apply {dir}/bus.toml", PLAN, 2, "usage.address"),
        ("systembus check {dir}/bus.toml drive-9=1", PLAN, 2, "usage.address"),
        ("systembus check {dir}/bus.toml drive-1=0", PLAN, 2, "usage.address"),
        ("systembus check {dir}/bus.toml drive-1=1 drive-1=2", PLAN, 2, "usage.address"),
        ("-a 1 systembus check {dir}/bus.toml", PLAN, 2, "usage.address"),
        ("systembus plan {dir}/bus.toml --trace {dir}/x", PLAN, 2, "usage.no_use"),
        ("--trace {dir}/x systembus load", PLAN, 2, "usage.no_use"),
    ] {
        let run = antrieb(typed).on(&drives(&[(1, "")])).file("bus.toml", plan).json().exits(code);
        assert_eq!(run.error()["code"], what, "{typed}");
    }
}

#[test]
fn the_settings_of_a_drive_are_saved_and_loaded_over_the_bus() {
    let bench = on_bus(&[(5, "\"480\" = 7, \"99\" = 704")]);
    let run = antrieb("--protocol sdo -a 5 dataset save {dir}/x.toml").on(&bench).exits(0);
    let text = run.text_of("x.toml");
    assert!(text.contains("7.00 Hz") && text.contains("704"), "{text}");
    let run = run.then("--protocol sdo -a 5 dataset check {dir}/x.toml").on(&bench).exits(0);
    let file = text.replace("7.00 Hz", "8.00 Hz");
    let load = "--protocol sdo -a 5 --yes dataset load {dir}/y.toml --only 480";
    let run = run.then(load).on(&bench).file("y.toml", &file).exits(0);
    let bus = witness::left_can().unwrap();
    assert!((1..=4).all(|set| bus.eeprom(5, 480, set) == Some(800)) && bus.remarks().is_empty());
    run.then("--protocol sdo -a 5 --yes dataset undo {dir}/y.undo.toml").on(&bench.replace("= 7,", "= 8,")).exits(0);
    assert_eq!(witness::left_can().unwrap().eeprom(5, 480, 1), Some(700));
}

#[test]
fn what_may_be_a_number_below_zero_is_neither_saved_nor_loaded() {
    // No source tells the width of P.99.
    let bench = on_bus(&[(5, "\"99\" = 40000")]);
    let run = antrieb("--protocol sdo -a 5 dataset save {dir}/x.toml").on(&bench).exits(0);
    let text = run.text_of("x.toml");
    assert!(text.contains("no-known-width") && !text.contains("40000"), "{text}");
    // Nothing that was asked proves a width.
    assert!(!text.contains("[types]"), "{text}");
    let file = "antrieb = 1\ndrive.family = \"acu\"\nvalues.99 = 704\n";
    let run =
        antrieb("--protocol sdo -a 5 --yes dataset load {dir}/x.toml").on(&bench).file("x.toml", file).json().exits(7);
    assert_eq!(witness::left_can().unwrap().counts()[2], 0, "{:?}", run.error());
}

/// Over SDO no answer tells a width, so what may be a number below zero is shown raw, unless somebody says what it is.
#[test]
fn a_value_whose_width_nobody_tells_is_shown_raw_and_so_told() {
    for (typed, raw, kind) in [
        ("--protocol sdo -a 5 read 99", 40_000, Value::Null),
        ("--protocol sdo -a 5 read 99 --type uint", 40_000, "uint".into()),
        ("--protocol sdo -a 5 read 99 --type int", -25_536, "int".into()),
        ("--protocol sdo -a 6 read 99", 704, "word".into()),
    ] {
        let bench = on_bus(&[(5, "\"99\" = 40000"), (6, "\"99\" = 704")]);
        let table = antrieb(typed).on(&bench).exits(0);
        let run = antrieb(typed).on(&bench).json().exits(0);
        let row = run.data("/values/0");
        assert_eq!((&row["raw"], &row["data_type"]), (&raw.into(), &kind), "{typed}: {row}");
        assert_eq!(table.out.contains("width not known"), kind.is_null(), "{}", table.out);
        assert!(row["value"].is_null() || !kind.is_null(), "{row}");
    }
}

#[test]
fn a_bus_that_loses_frames_gets_its_plan_all_the_same() {
    let bench = format!("[bus]\nlosses = 100\n{}", on_bus(&[(1, "")]));
    let apply = "--protocol sdo --yes --retries 9 systembus apply {dir}/bus.toml drive-2";
    antrieb(apply).on(&bench).file("bus.toml", PLAN).exits(0);
    let bus = witness::left_can().unwrap();
    assert_eq!([924, 936, 941].map(|param| bus.eeprom(1, param, 0)), [Some(385), Some(1), Some(40)]);
}

/// A node behind a drive is told by the address that was typed.
#[test]
fn a_node_behind_a_drive_is_told_with_its_node() {
    let bench = "[[drive]]\nmodel = \"acu\"\naddress = 3\nprotocol = \"vabus\"\nmodules = [\"EM-RES-03\"]\n\
                 nodes = [{ id = 17, model = \"acu\", modules = [\"EM-RES-03\"] }]\n";
    let on = |line: &str| antrieb(&format!("--protocol vabus -a 3.17 {line}")).on(bench);
    for (line, exit) in [("identify", 0), ("diag", 0), ("systembus show", 0), ("write 480@1=6Hz 480@2=6Hz --yes", 0)] {
        let run = on(line).exits(exit);
        assert!(run.out.contains("3.17") || line.starts_with("write"), "{line}: {}", run.out);
    }
    assert!(on("--lang de identify").exits(0).out.starts_with("Antrieb 3.17 ("));
    assert_eq!(on("identify").json().exits(0).data("/drives/0/node"), 17);
    assert_eq!(on("diag").json().exits(0).data("/drives/0/node"), 17);
    let own = antrieb("--protocol vabus -a 3 identify").on(bench).json().exits(0);
    assert_eq!(own.data("/drives/0").get("node"), None);
    // It has the number that it is reached by.
    assert_eq!(on("read 900").json().exits(0).data("/values/0/raw"), 17);
    let refused = on("--drive acu read 1234").json().exits(6);
    assert!(refused.error()["message"].as_str().unwrap().starts_with("drive 3.17 refused"), "{}", refused.error());
    assert_eq!(refused.error()["context"]["node"], "17");
    let rows = on("monitor 480 --count 1 --format table").exits(0).out;
    assert!(rows.lines().nth(1).unwrap().contains(" 3.17 "), "{rows}");
    // And so in what goes on over time, is compared, and is handed over.
    let records = on("monitor 480 --count 1 --format ndjson").exits(0).out;
    let records: Vec<Value> = records.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!([&records[0]["drives"][0]["node"], &records[1]["node"]], [&json!(17), &json!(17)], "{records:?}");
    let csv = on("monitor 480 --count 1 --format csv").exits(0).out;
    assert!(csv.contains(",3.17,acu,"), "{csv}");
    let file = "antrieb = 1\ndrive.family = \"acu\"\nvalues.480 = 9\n";
    let check = || on("dataset check {dir}/x.toml").file("x.toml", file);
    assert!(check().exits(1).out.contains("drive 3.17 ("));
    let side = check().json().exits(1).data("/comparisons/0/b").clone();
    assert_eq!([&side["name"], &side["node"]], [&json!("drive 3.17"), &json!(17)]);
    let unified = on("dataset check {dir}/x.toml --unified").file("x.toml", file).exits(1).out;
    assert!(unified.contains("drive 3.17") && !unified.contains("drive 3\n"), "{unified}");
    let report = on("report").exits(0).out;
    assert!(report.contains("3.17") && !report.contains("   3  acu"), "{report}");
    assert_eq!(on("report").json().exits(0).data("/drives/0/node"), 17);
}

/// A drive of a plan may be a node behind another one.
#[test]
fn a_plan_is_held_against_a_node_behind_a_drive_and_set_there() {
    let bench = |set: &str| {
        format!(
            "[[drive]]\nmodel = \"acu\"\naddress = 3\nprotocol = \"vabus\"\nmodules = [\"EM-RES-03\"]\n\
             nodes = [{{ id = 1, model = \"acu\", modules = [\"EM-RES-03\"], set = {{ {set} }} }}]\n"
        )
    };
    let set = format!("\"903\" = 7, {SET}");
    let on = |line: &str, set: &str| antrieb(line).on(&bench(set)).file("bus.toml", PLAN);
    let check = "--protocol vabus systembus check {dir}/bus.toml drive-2=3.1";
    assert!(on(check, &set).exits(0).out.contains("  3.1  acu "));
    let run = on(check, &set).json().exits(0);
    assert_eq!([run.data("/drives/0/b/name"), run.data("/drives/0/b/node")], [&json!("drive 3.1"), &json!(1)]);
    // Drive 3 itself has none of it.
    on("--protocol vabus systembus check {dir}/bus.toml drive-2=3", &set).json().exits(1);
    on("systembus check {dir}/bus.toml drive-2=3.1", &set).exits(2);
    let apply = "--protocol vabus --yes systembus apply {dir}/bus.toml drive-2=3.1";
    let run = on(apply, "\"903\" = 7").json().exits(0);
    let values = run.data("/drives/0/values").as_array().unwrap();
    assert!(!values.is_empty() && values.iter().all(|row| row["node"] == 1), "{values:?}");
    assert!(on(apply, "\"903\" = 7").exits(0).out.contains("drive 3.1 (acu)"));
}

/// Where one frame in ten is lost either way, a long run comes to its end, and who stays silent is told as on a bus.
#[test]
fn what_is_lost_on_the_way_ends_no_long_run() {
    for seed in [3, 8] {
        let bench = format!("[bus]\nlosses = 100\nseed = {seed}\n{}", on_bus(&[(5, "")]));
        antrieb("--protocol sdo -a 5 read 900-989").on(&bench).exits(0);
        antrieb("--protocol sdo -a 5 dataset save {dir}/x.toml").on(&bench).exits(0);
        let run = antrieb("--protocol sdo -a 5 --retries 0 read 900-989").on(&bench).json().exits(9);
        let hint = run.error()["hint"].as_str().unwrap();
        assert!(hint.contains("P.900") && !hint.contains("P.395"), "{hint}");
    }
}
