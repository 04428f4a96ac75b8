//! The LXM05 through the program: the worked sequences of its manual, reading, writing, diagnosis, safety.

use crate::run::{Output, antrieb};
use serde_json::json;

/// An LXM05 whose settings differ from everything that the manual's examples write.
const BENCH: &str = "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 500, RAMPdecel = 600, RAMPn_max = 3000, PPn_target = 50, HMn = 60, HMn_out = 6, JOGn_slow = 30, JOGn_fast = 90 }\n";

fn bench(rest: &str) -> String {
    format!("[[drive]]\nmodel = \"lxm05\"\n{rest}\n")
}

/// A line of a worked sequence: `FC16 / name (address)` with its 32-bit value, or `FC 3 / name (address)`.
#[derive(Clone, Copy, Debug)]
enum Line {
    Write(u16, u32),
    Read(u16),
}
use Line::{Read, Write};

/// Disable voltage, shut down, operation enable, state, mode, proof of the mode: the same in every sequence.
fn enabled_in(mode: u32) -> [Line; 6] {
    let [off, ready, on] = [0x00, 0x06, 0x0F].map(|word| Write(6914, word));
    [off, ready, on, Read(6916), Write(6918, mode), Read(6920)]
}

/// What code 16 or code 3 of a line looks like on the wire, without its check.
fn telegram(line: &Line) -> String {
    let hex = |bytes: &[u8]| bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ");
    match line {
        Write(address, value) => {
            let [high, low] = address.to_be_bytes();
            hex(&[&[1, 16, high, low, 0, 2, 4][..], &value.to_be_bytes()].concat())
        }
        Read(address) => {
            let [high, low] = address.to_be_bytes();
            hex(&[1, 3, high, low, 0, 2])
        }
    }
}

/// Every line of the sequence must have been sent, in this order.
#[track_caller]
fn assert_sequence(output: &Output, first: &[Line], mode: u32, last: &[Line]) {
    let sent = output.sent();
    let mut rest = sent.iter();
    for line in [first, &enabled_in(mode), last].into_iter().flatten() {
        let wanted = telegram(line);
        let found = rest.any(|telegram| telegram.starts_with(&wanted));
        assert!(found, "{line:?} ({wanted}) was not sent where the manual sends it:\n{}", sent.join("\n"));
    }
}

fn moved(words: &str) -> Output {
    antrieb(&format!("-a 1 -v --yes sollwert {words} --enable --hold --duration 100ms")).on(BENCH).exits(0)
}

#[test]
fn point_to_point_runs_as_5_4_1() {
    let output = moved(
        "48usr --start relative --set RAMPacc=2000 --set RAMPdecel=4000 --set RAMPn_max=6000 --set PPn_target=4000 \
         --until reached",
    );
    let first = [Write(1556, 0x07D0), Write(1558, 0x0FA0), Write(1554, 0x1770), Write(6942, 0x0FA0)];
    let last = [Write(6940, 0x30), Write(6914, 0x5F), Read(6916), Write(6914, 0x0F)];
    assert_sequence(&output, &first, 1, &last);
}

#[test]
fn velocity_profile_runs_as_5_4_2() {
    let output =
        moved("1000rpm --mode velocity --until reached --set RAMPacc=2000 --set RAMPdecel=10000 --set RAMPn_max=10000");
    let first = [Write(1556, 0x07D0), Write(1558, 0x2710), Write(1554, 0x2710)];
    let last = [Write(6938, 0x03E8), Read(6916), Write(6938, 0), Read(6916)];
    assert_sequence(&output, &first, 3, &last);
}

#[test]
fn homing_runs_as_5_4_3() {
    let output = moved("17 --mode homing --set HMn=100 --set HMn_out=10 --until reached");
    let first = [Write(10248, 0x64), Write(10250, 0x0A)];
    let last = [Write(6936, 0x11), Write(6914, 0x1F), Read(6916), Write(6914, 0x0F)];
    assert_sequence(&output, &first, 6, &last);
}

#[test]
fn current_control_runs_as_5_5_1() {
    let output = moved("10A");
    let last = [Write(6944, 2), Write(8200, 0x03E8)];
    assert_sequence(&output, &[], 0xFFFF_FFFD, &last);
}

#[test]
fn speed_control_runs_as_5_5_2() {
    let output = moved("1000rpm --mode speed");
    let last = [Write(6946, 2), Write(8456, 0x03E8)];
    assert_sequence(&output, &[], 0xFFFF_FFFC, &last);
}

#[test]
fn electronic_gear_runs_as_5_5_3() {
    let output = moved("2/3 --set IOposInterfac=1");
    let last = [Write(6948, 1), Write(9734, 3), Write(9736, 2)];
    let first = [Write(1284, 1)];
    assert_sequence(&output, &first, 0xFFFF_FFFE, &last);
}

#[test]
fn jogging_runs_as_5_5_4() {
    let output = antrieb(
        "-a 1 -v --yes sollwert --mode jog --profile {dir}/jog.csv --set JOGn_slow=100 --set JOGn_fast=250 --enable \
         --hold --duration 50ms",
    );
    let output = output.file("jog.csv", "0s, positive slow\n500ms, positive fast\n").on(BENCH).exits(0);
    let first = [Write(10504, 0x64), Write(10506, 0xFA)];
    let last = [Write(6930, 1), Write(6930, 5)];
    assert_sequence(&output, &first, 0xFFFF_FFFF, &last);
}

#[test]
fn nothing_is_written_without_a_terminal() {
    for verb in ["sollwert 1000rpm --enable", "statemachine enable", "write MBadr=2"] {
        let run = antrieb(&format!("-v -a 1 --drive lxm05 {verb}")).on(BENCH).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.no_terminal", "{verb}");
        let writes = ["> 01 06", "> 01 10"];
        assert!(!writes.iter().any(|write| run.err.contains(write)), "not one write: {}", run.err);
    }
}

#[test]
fn the_question_warns_of_what_the_sources_disagree_about() {
    let asked = antrieb("-a 1 sollwert 48usr --enable").on(BENCH).answered("n").exits(8);
    for part in ["Point-to-point", "48 usr", "to an absolute position", "watch the first movement", "MOTION"] {
        assert!(asked.err.contains(part), "{part}: {}", asked.err);
    }
}

#[test]
fn every_mode_stops_as_its_catalogue_says_and_is_proven() {
    for (words, on_exit, state) in [
        ("1000rpm --until reached", "ramp", "switched-on"),
        ("1000rpm --until reached", "quick-stop", "switch-on-disabled"),
        ("1000rpm --until reached", "coast", "switch-on-disabled"),
        ("1000rpm --mode speed", "ramp", "switched-on"),
        ("5 --mode jog", "ramp", "switched-on"),
        // No setpoint 0 stops these: the ramp is a quick stop.
        ("48usr", "ramp", "switch-on-disabled"),
        ("2/3", "ramp", "switch-on-disabled"),
        // Nor does no current stop a mass.
        ("1A", "ramp", "switch-on-disabled"),
    ] {
        let line = format!("-a 1 --yes sollwert {words} --enable --hold --duration 300ms --on-exit {on_exit}");
        let run = antrieb(&line).on(BENCH).json().exits(0);
        assert_eq!((run.data("/stop/acknowledged"), run.data("/running")), (&json!(true), &json!(false)), "{line}");
        assert_eq!(run.data("/to/slug"), state, "{line}");
    }
}

#[test]
fn settings_of_a_held_run_are_given_back() {
    let run =
        antrieb("-a 1 -v --yes sollwert 1000rpm --set RAMPacc=2000 --watchdog 300ms --enable --hold --duration 300ms");
    let run = run.on(BENCH).json().exits(0);
    assert_eq!(run.data("/changed/0/name"), "MBnode_guard (5644)");
    for (index, (param, old, new)) in [(5644, 0, 300), (1556, 500, 2000)].into_iter().enumerate() {
        let change = run.data(&format!("/changed/{index}"));
        let told = (&change["param"], &change["old"], &change["new"], &change["restored"]);
        assert_eq!(told, (&json!(param), &json!(old), &json!(new), &json!(true)));
    }
    assert_eq!(run.data("/watchdog_s"), &json!(0.0));
}

#[test]
fn setpoints_are_checked_before_anybody_is_asked() {
    for (words, exit, says) in [
        ("20000rpm", 7, "RAMPn_max (1554) = 3000 1/min"),
        ("25Hz", 2, "--mode (velocity, position, homing, current, speed, gear, jog)"),
        ("48usr", 8, "not enabled"),
        ("10A --until reached --enable", 2, "nothing tells"),
        ("10A --set RAMPacc=5 --enable", 2, "--set RAMPacc does not fit"),
        ("1000rpm --start relative", 2, "--start relative does not fit"),
        ("--ramp 0usr:48usr:1s --enable", 2, "one target"),
        ("1000rpm --mode flying", 2, "no mode"),
    ] {
        let run = antrieb(&format!("-a 1 --drive lxm05 --yes sollwert {words}")).on(BENCH).json().exits(exit);
        let message = run.error()["message"].as_str().unwrap();
        assert!(message.contains(says), "{words}: {message}");
    }
}

#[test]
fn a_fault_is_shown_with_its_entry_and_reset_without_a_lock() {
    let tripped = bench("[[drive.event]]\nat = \"1ms\"\nfault = \"E2300\"\nqualifier = 7");
    let diag = antrieb("-a 1 --drive lxm05 diag").on(&tripped).json().exits(0);
    assert_eq!((diag.data("/drives/0/fault/key"), diag.data("/drives/0/healthy")), (&json!("E2300"), &json!(false)));
    let memory: Vec<_> =
        diag.data("/drives/0/memory").as_array().unwrap().iter().map(|value| value["raw"].clone()).collect();
    assert_eq!((&memory[0], &memory[3]), (&json!(0x2300), &json!(7)));
    let refused = antrieb("-a 1 --drive lxm05 --yes statemachine enable").on(&tripped).json().exits(8);
    assert_eq!(refused.error()["code"], "forbidden.fault");
    let reset = antrieb("-a 1 --drive lxm05 --yes statemachine reset").on(&tripped).json().exits(0);
    assert_eq!((reset.data("/from/slug"), reset.data("/to/slug")), (&json!("fault"), &json!("switch-on-disabled")));
    assert!(reset.data("/steps/0/took_ms").as_u64().unwrap() < 1_000);
}

#[test]
fn an_old_entry_of_the_fault_memory_is_no_fault() {
    let healthy = bench("set = { FLT_err_num = 0x2300 }");
    let state = antrieb("-a 1 statemachine").on(&healthy).json().exits(0);
    assert_eq!((state.data("/drives/0/fault_code"), state.data("/drives/0/fault")), (&json!(0), &json!(null)));
    assert_eq!(antrieb("-a 1 diag").on(&healthy).json().exits(0).data("/drives/0/healthy"), &json!(true));
}

#[test]
fn neighbours_come_in_one_telegram() {
    let output = antrieb("-a 1 -v --drive lxm05 read @faults").on(BENCH).exits(0);
    let asked: Vec<_> = output.sent().into_iter().filter(|telegram| telegram.starts_with("01 03 3C")).collect();
    assert_eq!(asked.len(), 1, "{asked:?}");
    assert!(asked[0].starts_with("01 03 3C 02 00 08"), "manual 5.3, example 1: {asked:?}");
}

#[test]
fn what_is_refused_with_its_neighbours_is_read_one_by_one() {
    // 1548 is nobody's address.
    let run = antrieb("-a 1 --drive lxm05 read 1544 1546 1548").on(BENCH).json().exits(9);
    let raws: Vec<_> = run.data("/values").as_array().unwrap().iter().map(|value| value["raw"].is_null()).collect();
    assert_eq!(raws, [false, false, true]);
}

#[test]
fn a_write_is_proven_in_the_exchange_that_writes() {
    let output = antrieb("-a 1 -v --drive lxm05 --yes write RAMPacc=2000").on(BENCH).exits(0);
    let last = output.sent().pop().unwrap();
    assert!(last.starts_with("01 17 06 14 00 02 06 14 00 02 04 00 00 07 D0"), "{last}");
    assert!(output.out.contains("verified"), "{}", output.out);
}

#[test]
fn the_word_order_is_asked_once_or_given() {
    let low = bench("set = { MBdword_order = 1, RAMPacc = 500 }");
    let asked = antrieb("-a 1 -v --drive lxm05 read RAMPacc RAMPdecel _p_act").on(&low).exits(0);
    assert_eq!(asked.sent().iter().filter(|telegram| telegram.starts_with("01 03 16 08")).count(), 1);
    assert!(asked.out.contains("500"), "{}", asked.out);
    let given = antrieb("-a 1 -v --drive lxm05 --word-order low --yes write RAMPacc=2000").on(&low).exits(0);
    assert!(given.sent().iter().all(|telegram| !telegram.starts_with("01 03 16 0")), "{:?}", given.sent());
    assert!(given.sent().pop().unwrap().contains("04 07 D0 00 00"), "low word first");
}

#[test]
fn what_the_family_does_not_have_is_refused_in_words() {
    for (verb, exit, says) in [
        ("read RAMPacc@2", 7, "no data sets"),
        ("--yes write RAMPacc@ram=5", 7, "no data sets"),
        ("dataset show", 7, "no data sets"),
        ("--yes sollwert 5A --mode velocity", 2, "the unit 'A' does not fit"),
        ("--yes statemachine contacts S1IND", 8, "no virtual contacts"),
    ] {
        let run = antrieb(&format!("-a 1 {verb}")).on(BENCH).json().exits(exit);
        let message = run.error()["message"].as_str().unwrap();
        assert!(message.contains(says), "{verb}: {message}");
    }
}

#[test]
fn one_bus_carries_both_families() {
    let mixed = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[drive]]\nmodel = \"acu\"\naddress = 2\n[[drive]]\nmodel = \"lxm05\"\naddress = 3\n";
    let read = antrieb("-a 1,2,3 read @actual").on(mixed).json().exits(0);
    let drives: std::collections::BTreeSet<_> =
        read.data("/values").as_array().unwrap().iter().map(|value| value["drive"].as_str().unwrap()).collect();
    assert_eq!(drives.into_iter().collect::<Vec<_>>(), ["act", "acu", "lxm05"]);
    for verb in ["diag", "statemachine", "sollwert", "identify"] {
        let run = antrieb(&format!("-a 1,2,3 {verb}")).on(mixed).json().exits(0);
        let drives: Vec<_> =
            run.data("/drives").as_array().unwrap().iter().map(|row| row["drive"].as_str().unwrap()).collect();
        assert_eq!(drives, ["act", "acu", "lxm05"], "{verb}");
    }
}

/// Every value travels as 32 bits (5.2.1), whatever its type: no sign gets lost.
#[test]
fn a_type_never_cuts_a_value_of_two_registers() {
    let bench = bench("");
    let run = antrieb("-v -a 1 --drive lxm05 --yes write 6940=-5 --type int").on(&bench).exits(0);
    let sent = run.sent();
    assert!(sent.iter().any(|hex| hex.contains("1B 1C 00 02 04 FF FF FF FB")), "{sent:?}");
    let planned = antrieb("-a 1 --drive lxm05 --dry-run write 6940=-5 --type int").on(&bench).exits(0).out;
    assert!(planned.contains("1B 1C 00 02 04 FF FF FF FB"), "{planned}");
}

/// A wrong word order must be seen.
#[test]
fn a_value_is_shown_with_all_of_its_bits() {
    let bench = bench("set = { MBdword_order = 1 }");
    let document = antrieb("-a 1 --drive lxm05 --word-order high read MBadr").on(&bench).json().exits(0);
    assert_eq!(document.data("/values/0/raw"), 65_536);
}

#[test]
fn a_drive_that_tells_of_itself_in_pieces_is_known() {
    let bench = bench("servo = { in_pieces = true, revision_object = 2 }");
    let document = antrieb("-a 1 identify").on(&bench).json().exits(0);
    assert_eq!(document.data("/drives/0/drive"), "lxm05");
    let evidence = document.data("/drives/0/evidence/0/answered");
    assert_eq!(evidence, "antrieb bench, LXM05-SIM, V02.001");
}

/// readings.md: reading FLT_err_num may move on to the entry before. One reading of 15362 x8 (5.3, example 1) serves both.
#[test]
fn the_fault_memory_is_read_once_for_the_present_fault_and_the_memory() {
    let event = |at: u8, fault: &str| format!("[[drive.event]]\nat = \"{at}ms\"\nfault = \"{fault}\"\n");
    let bench =
        bench(&format!("readings = {{ flt_err_num = \"moves-on\" }}\n{}{}", event(1, "E3201"), event(2, "E2300")));
    let diag = antrieb("-v -a 1 --drive lxm05 diag").on(&bench).json().exits(0);
    assert_eq!(
        (diag.data("/drives/0/fault/key"), diag.data("/drives/0/memory/0/raw")),
        (&json!("E2300"), &json!(0x2300))
    );
    assert_eq!(diag.err.matches("> 01 03 3C 02").count(), 1, "{}", diag.err);
    let state = antrieb("-a 1 --drive lxm05 statemachine").on(&bench).json().exits(0);
    assert_eq!(state.data("/drives/0/fault/key"), "E2300");
    let missing = state.data("/drives/0/missing").to_string();
    assert!(missing.contains("E2300") && !missing.contains("E3201"), "{missing}");
}

#[test]
fn a_gear_ratio_is_shown_whole() {
    let run = "-a 1 --yes sollwert 2/3 --enable --hold --duration 100ms";
    let table = antrieb(run).on(BENCH).exits(0);
    assert!(table.out.contains(" 2/3"), "{}", table.out);
    let document = antrieb(run).on(BENCH).json().exits(0);
    assert_eq!((document.data("/setpoint/value"), document.data("/setpoint/denominator")), (&2.into(), &3.into()));
}
