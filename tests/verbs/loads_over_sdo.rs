//! Files into a drive on the system bus, over SDO, and every way in which that ends: the bus itself is asked what stands there.

use crate::run::{Document, Run, antrieb};
use antrieb::simulator::Can;
use antrieb::transport::witness;
use serde_json::Value;

const VALUES: &str = "\"480\" = \"8 Hz\"\n\"481@2\" = \"3 Hz\"\n\"372\" = 1440\n\"400\" = 4\n";
/// What the file writes, and what stands there before.
const CELLS: [(u32, u8, i64); 7] =
    [(480, 1, 500), (480, 2, 500), (480, 3, 500), (480, 4, 500), (481, 2, 1_200), (372, 1, 1_390), (372, 4, 1_390)];

/// One ACU alone on the bus, or another beside it.
fn load(event: &str, beside: bool) -> Run {
    let beside = if beside { "[[drive]]\nmodel = \"acu\"\naddress = 2\n" } else { "" };
    let bench =
        format!("[[drive]]\nmodel = \"acu\"\naddress = 1\nset = {{ \"480\" = 5, \"481@2\" = 12 }}\n{event}{beside}");
    let text = format!("antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n{VALUES}");
    antrieb("--protocol sdo -a 1 --yes dataset load {dir}/l.toml").on(&bench).file("l.toml", &text)
}

fn event(when: &str, what: &str) -> String {
    format!("[[drive.event]]\n{when}\n{what}\n")
}

/// Cells that are not as they were.
fn changed(bus: &Can) -> Vec<(u32, u8)> {
    let is = |(number, set, raw): &(u32, u8, i64)| {
        [bus.eeprom(1, *number, *set), bus.ram(1, *number, *set)].iter().all(|now| *now == Some(*raw))
    };
    CELLS.iter().filter(|cell| !is(cell)).map(|cell| (cell.0, cell.1)).collect()
}

fn ended(document: &Document) -> &str {
    document.value["data"]["ended"].as_str().unwrap_or("none")
}

fn is_named(document: &Value, (number, set): (u32, u8)) -> bool {
    let rows = document["data"]["values"].as_array().unwrap();
    rows.iter().any(|row| row["param"] == number && row["data_set"] == set && row["result"] == "unrestored")
}

#[test]
fn a_drive_that_drops_off_for_a_moment_is_waited_for_also_alone_on_its_bus() {
    for beside in [false, true] {
        let mut back = 0;
        for at in 1..8 {
            let run = load(&event(&format!("after_writes = {at}"), "silent = \"4s\""), beside).json();
            let bus = witness::left_can().unwrap();
            // Where its last write is proven all the same, it is done.
            assert!(["back", "done"].contains(&ended(&run)), "{at}, {beside}: {:#}", run.value);
            assert!(ended(&run) == "done" || changed(&bus).is_empty(), "{at}, {beside}: {:?}", changed(&bus));
            back += usize::from(ended(&run) == "back");
        }
        assert!(back > 3, "{beside}: {back}");
    }
    // Who does not come back is not waited for without end.
    let gone = load(&event("after_writes = 2", "silent = \"10h\""), false).json().exits(9);
    assert_eq!(ended(&gone), "torn", "{:#}", gone.value);
}

#[test]
fn a_write_that_the_bench_refuses_or_ignores_is_refused_or_ignored_over_sdo_too() {
    let place = 2 << 12 | 481;
    let refused = load(&event("after_telegrams = 1", &format!("refuses = {place}")), false).json().exits(9);
    assert_eq!(ended(&refused), "back", "{:#}", refused.value);
    let message = refused.error()["message"].as_str().unwrap();
    assert!(message.contains("SDO abort") && message.contains("481"), "{message}");
    assert_eq!(changed(&witness::left_can().unwrap()), []);
    let ignored = load(&event("after_telegrams = 1", &format!("ignores = {place}")), false).json().exits(9);
    assert_eq!(ended(&ignored), "back", "{:#}", ignored.value);
    assert!(ignored.error()["message"].as_str().unwrap().contains("reads back as"), "{:#}", ignored.value);
    assert_eq!(changed(&witness::left_can().unwrap()), []);
}

#[test]
fn no_end_at_any_telegram_over_sdo_is_called_done_or_as_before_and_is_not() {
    let refuses = format!("refuses = {}", 1 << 12 | 372);
    let mut seen = std::collections::BTreeSet::new();
    for what in [
        "silent = \"4s\"",
        "silent = \"60s\"",
        "power_cycle = true",
        &refuses,
        "start_right = true\nset = { \"411\" = 55 }",
    ] {
        for at in (1..70).step_by(3) {
            let run = load(&event(&format!("after_telegrams = {at}"), what), false).json();
            let bus = witness::left_can().unwrap();
            let (changed, ended) = (changed(&bus), ended(&run));
            seen.insert(ended.to_owned());
            let is_right = match ended {
                "done" => run.exit == 0 && changed.len() == CELLS.len(),
                "back" | "untouched" | "none" => run.exit != 0 && changed.is_empty(),
                // What a power loss took from the RAM by itself is as before.
                _ => run.exit == 9 && changed.iter().all(|cell| is_named(&run.value, *cell)),
            };
            assert!(is_right, "{what} at {at}: {ended}, {} {changed:?}\n{:#}", run.exit, run.value);
            let of = |key: &str| run.value["data"][key].as_u64().unwrap_or(0);
            let most = of("eeprom_writes") + of("eeprom_writes_back");
            assert!(bus.counts()[2] <= most, "{what} at {at}: {} of {most}", bus.counts()[2]);
        }
    }
    assert!(["done", "back", "torn"].iter().all(|end| seen.contains(*end)), "{seen:?}");
}

/// A drive that has no sub-index 5 to 9 (EM-RES-03 manual 5.10.1 leaves that open) has no RAM that an undo could bring back: nothing is
/// written there, and what is stored as before is as before.
#[test]
fn an_undo_behind_a_half_load_is_proven_where_a_drive_has_no_data_sets_of_the_ram() {
    let text = format!("antrieb = 1\n[drive]\nfamily = \"acu\"\n[values]\n{BEFORE}\n[undo]\nvalues = {{ {CAME} }}\n");
    for (reading, hides) in [("abort-2", true), ("ram", false)] {
        // The load came as far as P.480.
        let bench = format!(
            "[readings]\nram_sets = \"{reading}\"\n[[drive]]\nmodel = \"acu\"\naddress = 1\nset = {{ \"480\" = 8, \"481@2\" = 12 }}\n"
        );
        let undo = "--protocol sdo -a 1 --yes dataset undo {dir}/u.toml";
        let run = antrieb(undo).on(&bench).file("u.toml", &text).json().exits(0);
        assert_eq!(ended(&run), "done", "{:#}", run.value);
        let told = run.value["warnings"].to_string();
        assert_eq!(told.contains("does not show its RAM"), hides, "{told}");
        let bus = witness::left_can().unwrap();
        assert_eq!(changed(&bus), []);
        // One write to all four, or four.
        assert!(bus.remarks().is_empty() && bus.counts()[2] <= 4, "{:?} {:?}", bus.counts(), bus.remarks());
        let again = antrieb(undo).on(&bench.replace("= 8,", "= 5,")).file("u.toml", &text).json().exits(0);
        assert_eq!(ended(&again), "done", "{:#}", again.value);
        assert_eq!(witness::left_can().unwrap().counts()[2], 0);
    }
}

const BEFORE: &str = "\"480\" = \"5 Hz\"\n\"481@2\" = \"12 Hz\"\n\"372\" = 1390\n\"400\" = 2";
const CAME: &str = "\"480\" = \"8 Hz\", \"481@2\" = \"3 Hz\", \"372\" = 1440, \"400\" = 4";
