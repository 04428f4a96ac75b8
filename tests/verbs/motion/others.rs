//! What another master does to a servo that runs: it chooses another source of the setpoint, another mode, another limit or ratio.

use super::events::left;
use super::rig::{drive, sent, servo, when};
use crate::run::antrieb;
use antrieb::transport::witness;
use serde_json::json;

const KEYS: &str = "IOposInterfac = 1, RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000";
const WORLD: &str = "servo = { guide = 163840, analog = 900 }\n\
                     readings = { references_after_mode = \"kept\", references_after_run = \"kept\" }\n";
const ENABLE: &str = "01 10 1B 02 00 02 04 00 00 00 0F";
const QUICK_STOP: &str = "01 10 1B 02 00 02 04 00 00 00 02";
const START: &str = "01 10 1B 02 00 02 04 00 00 00 1F";

fn bench(event: &str) -> String {
    servo(KEYS, &format!("{WORLD}{event}"))
}

fn at_time(second: u32, set: &str) -> String {
    format!("[[drive.event]]\nat = \"{second}s\"\nset = {{ {set} }}\n")
}

#[test]
fn what_makes_the_setpoint_of_a_servo_count_is_looked_at_in_its_run() {
    for (typed, set, label) in [
        ("300rpm --mode speed", "SPEEDreference = 1", "SPEEDreference"),
        ("10A", "CURreference = 1", "CURreference"),
        ("2/3", "GEARreference = 2", "GEARreference"),
        ("2/3", "GEARnum = 9", "GEARnum"),
        ("2/3", "GEARdenom = 1", "GEARdenom"),
        ("300rpm", "RAMPn_max = 100", "RAMPn_max"),
    ] {
        let line = format!("-v -a 1 --yes sollwert {typed} --enable --hold --duration 8s");
        antrieb(&line).on(&bench("")).exits(0);
        let run = antrieb(&line).on(&bench(&at_time(3, set))).json();
        let told = format!("{typed} {set}: {:#} {}", run.value, run.err);
        assert_eq!((run.exit, &run.error()["code"]), (8, &json!("forbidden.otherwise")), "{told}");
        assert!(run.error()["message"].as_str().unwrap().contains(label), "{told}");
        assert_eq!((left(), run.data("/stop/acknowledged")), ((0, 0), &json!(true)), "{told}");
        // It is looked at every second; a ramp that stops nothing is not tried before.
        let last = sent(&run.err).last().map_or(0.0, |(at, _)| *at);
        assert!(last < 5_500.0, "{told}");
        if set.contains("reference = 1") {
            assert!((3_000.0..4_300.0).contains(&when(&run.err, QUICK_STOP)), "{told}");
        }
    }
}

/// The same where nobody asks for the standstill but the end of the run.
#[test]
fn a_source_that_another_master_chooses_in_the_last_second_makes_the_ramp_a_quick_stop() {
    let line = "-v -a 1 --yes sollwert 300rpm --mode speed --enable --hold --duration 2s";
    let calm = antrieb(line).on(&bench("")).exits(0);
    let zero = when(&calm.err, "01 10 21 08 00 02 04 00 00 01 2C") + 2_000.0;
    for before in [30.0, 150.0, 400.0] {
        let at = format!("[[drive.event]]\nat = \"{}ms\"\nset = {{ SPEEDreference = 1 }}\n", (zero - before) as u64);
        let run = antrieb(line).on(&bench(&at)).json();
        let told = format!("{before}: {:#} {}", run.value, run.err);
        assert_eq!((run.exit, left()), (8, (0, 0)), "{told}");
        assert!(run.err.contains("SPEEDreference"), "{told}");
        assert!(when(&run.err, QUICK_STOP) < zero + 500.0, "{told}");
    }
}

/// Whenever it comes, in an enabling too, it is stopped at once: no ramp of a setpoint that counts no more, and no mode that never comes,
/// is waited for.
#[test]
fn a_mode_that_another_master_chooses_is_stopped_at_once_whenever_it_comes() {
    for typed in ["300rpm", "300rpm --mode speed"] {
        let line = format!("-v -a 1 --yes sollwert {typed} --enable --hold --duration 6s");
        let calm = sent(&antrieb(&line).on(&bench("")).exits(0).err);
        let enabled = calm.iter().position(|(_, hex)| hex.starts_with(ENABLE)).unwrap() + 1;
        let late = calm.iter().position(|(at, _)| *at > calm[enabled].0 + 4_000.0).unwrap();
        for set in ["DCOMopmode = -2, GEARreference = 1", "DCOMopmode = -4, SPEEDreference = 1", "DCOMopmode = 3"] {
            if typed.contains("speed") == set.contains("-4") && (typed.contains("speed") || set.contains("= 3")) {
                continue;
            }
            for after in (enabled..enabled + 24).chain([late - 15, late]) {
                let event = format!("[[drive.event]]\nafter_telegrams = {after}\nset = {{ {set} }}\n");
                let run = antrieb(&line).on(&bench(&event)).json();
                let told = format!("{typed} {set} {after}: {:#} {}", run.value, run.err);
                assert_eq!(left(), (0, 0), "{told}");
                // What we select behind it counts, and that is what was agreed to.
                assert!(run.exit == 8 || (run.exit == 0 && after < enabled + 8), "{told}");
                if run.exit == 0 {
                    continue;
                }
                assert_eq!(run.error()["code"], "forbidden.otherwise", "{told}");
                let sent = sent(&run.err);
                let (came, over) = (sent[after - 1].0, sent.last().map_or(0.0, |(at, _)| *at));
                assert!(over - came < 2_600.0, "{came} {over} {told}");
            }
        }
    }
}

/// The time of a run is that of its movement too.
#[test]
fn a_movement_to_a_target_ends_with_its_run() {
    let run = |value: &str, rest: &str| {
        let line = format!("-v -a 1 --yes sollwert {value} --set PPn_target=300 --enable --hold --duration 2s {rest}");
        antrieb(&line).on(&bench("")).json()
    };
    for (value, whole) in [("9000000usr", false), ("8000usr", true)] {
        let ended = run(value, "").exits(0);
        let told = format!("{value}: {:#} {}", ended.value, ended.err);
        let took = when(&ended.err, QUICK_STOP) - when(&ended.err, START);
        assert!((1_900.0..2_300.0).contains(&took), "{took} {told}");
        assert_eq!((left(), ended.data("/stop/acknowledged")), ((0, 0), &json!(true)), "{told}");
        assert_eq!(ended.data("/setpoint/reached"), &json!(whole), "{told}");
        assert_eq!(ended.data("/notes").to_string().contains("not at its end"), !whole, "{told}");
    }
    // Who waits for it has the time of the run behind it.
    let ended = run("30000usr", "--until reached").exits(0);
    let took = when(&ended.err, QUICK_STOP) - when(&ended.err, START);
    assert!(took > 2_300.0 && ended.data("/setpoint/reached") == &json!(true), "{took} {}", ended.err);
}

/// Another master gives a setpoint, or enables, while a drive stops: the stop is said again as soon as that is seen.
#[test]
fn a_drive_that_becomes_faster_in_its_stop_is_stopped_again_at_once() {
    const ZERO: &str = "01 10 1B 1A 00 02 04 00 00 00 00";
    const OFF: &str = "01 10 1B 02 00 02 04 00 00 00 00";
    const SLOW: &str = "ramps = { up_right = 20, down_right = 10, up_left = 20, down_left = 10 }\n";
    const ENABLES: &[&str] = &["DCOMcontrol = 6", "DCOMcontrol = 15, PVn_target = 1500"];
    let inverter = |event: &str| drive("\"410\" = 0, \"412\" = 1, \"434\" = 2, \"418\" = 0", &format!("{SLOW}{event}"));
    let turns = |event: &str| drive("\"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 20", &format!("{SLOW}{event}"));
    let slow = |event: &str| servo(&KEYS.replace("3000, RAMPdecel = 3000", "3000, RAMPdecel = 150"), event);
    type Bench<'a> = &'a dyn Fn(&str) -> String;
    let cases: [(&str, Bench<'_>, &str, &[&str]); 4] = [
        ("sollwert 300rpm --jog 1s", &slow, ZERO, &["PVn_target = 500"]),
        ("sollwert 1500rpm --jog 1s --on-exit coast", &slow, OFF, ENABLES),
        ("sollwert 20Hz --jog 4s", &inverter, "01 06 01 9A 00 07", &["\"410\" = 15, \"484\" = 40"]),
        ("statemachine disable", &turns, "01 06 01 9A 00 07", &["\"410\" = 15, \"484\" = 40"]),
    ];
    for (verb, bench, stop, sets) in cases {
        let line = format!("-v -a 1 --yes {verb}{}", if verb.contains("rpm") { "" } else { " -b 115200" });
        let calm = antrieb(&line).on(&bench("")).run();
        assert!(!calm.out.contains("became faster"), "{}", calm.out);
        let zero = when(calm.err.split("running; Ctrl-C").last().unwrap(), stop);
        for behind in [100.0, 300.0, 700.0] {
            let came = zero + behind;
            let event = |(nth, set): (usize, &&str)| {
                format!("[[drive.event]]\nat = \"{}ms\"\nset = {{ {set} }}\n", came as usize + 20 * nth)
            };
            let events: String = sets.iter().enumerate().map(event).collect();
            let run = antrieb(&line).on(&bench(&events)).run();
            let told = format!("{verb} {sets:?} {behind}: {} {}", run.out, run.err);
            let stops = |hex: &str| hex.starts_with(stop) || hex.starts_with(QUICK_STOP) || hex.starts_with(OFF);
            let again = sent(&run.err).into_iter().find(|(at, hex)| *at > came && stops(hex));
            // One that goes on as fast as it was is seen only behind the looks at its shaft.
            let most = if verb.contains("coast") { 4_000.0 } else { 1_200.0 };
            assert!(again.is_some_and(|(at, _)| at - came < most), "{told}");
            assert_eq!(left(), (0, 0), "{told}");
        }
    }
}

/// Another master that gives its setpoint again and again within a ramp: after four zeros the quick stop follows.
#[test]
fn who_is_overruled_again_and_again_stops_by_a_stronger_way() {
    let slow = |event: &str| servo(&KEYS.replace("3000, RAMPdecel = 3000", "3000, RAMPdecel = 1500"), event);
    let line = "-v -a 1 --yes sollwert 900rpm --jog 1s";
    let calm = antrieb(line).on(&slow("")).exits(0);
    let zero = when(calm.err.split("running; Ctrl-C").last().unwrap(), "01 10 1B 1A 00 02 04 00 00 00 00");
    let each = |nth: u32| {
        let at = zero as u32 + 300 + 550 * nth;
        format!("[[drive.event]]\nat = \"{at}ms\"\nset = {{ PVn_target = 1500 }}\n")
    };
    let run = antrieb(line).on(&slow(&(0..12).map(each).collect::<String>())).run();
    let told = format!("exit {} {} {}", run.exit, run.out, run.err);
    assert!((zero + 1_000.0..zero + 5_000.0).contains(&when(&run.err, QUICK_STOP)), "{told}");
    assert!(run.out.contains("became faster") && run.out.contains("ramp -> quick-stop"), "{told}");
    assert_eq!(left(), (0, 0), "{told}");
}

/// Another master enables for good at the end of a run: what is told of the stop is what the drive does at the end.
#[test]
fn a_stop_whose_drive_is_enabled_for_good_is_no_stop() {
    let slow = |event: &str| servo(&KEYS.replace("3000, RAMPdecel = 3000", "3000, RAMPdecel = 150"), event);
    let mut running = 0;
    for way in ["ramp", "quick-stop", "coast"] {
        for every in [300, 700, 1_100] {
            let each = |at: usize| {
                format!(
                    "[[drive.event]]\nat = \"{at}ms\"\nset = {{ DCOMcontrol = 6 }}\n[[drive.event]]\nat = \"{}ms\"\nset = {{ \
                     DCOMcontrol = 15, PVn_target = 1500 }}\n",
                    at + 10
                )
            };
            let events: String = (1_600..90_000).step_by(every).map(each).collect();
            let line = format!("-v -a 1 --yes sollwert 300rpm --jog 1s --on-exit {way}");
            let run = antrieb(&line).on(&slow(&events)).run();
            let told =
                format!("{way} {every}: exit {} {} {}", run.exit, run.out, run.err.lines().last().unwrap_or_default());
            let error = run.err.lines().find(|line| line.starts_with("error:")).unwrap_or_default();
            if run.out.contains("running   yes") {
                running += 1;
                assert!(run.out.contains("NOT acknowledged") && !run.out.contains("without power"), "{told}");
                assert!(error.contains("THE SHAFT MAY STILL TURN") && run.err.contains("safe-torque-off"), "{told}");
                assert_eq!(run.exit, 8, "{told}");
            } else {
                assert_eq!(witness::left().unwrap().0.totals().energised, 0, "{told}");
            }
            assert!(sent(&run.err).last().unwrap().0 < 75_000.0, "{told}");
        }
    }
    assert!(running > 0);
}
