//! What another master, or a silence, makes of a run where its answer was looked at too late, or too early.

use super::rig::{DISABLE, RUNNING, drive, servo, when};
use crate::run::antrieb;
use serde_json::json;

const KEYS: &str = "RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000";
const QUICK_STOP: &str = "01 10 1B 02 00 02 04 00 00 00 02";

/// Between two questions it begins to tell both what was written and what is in force: nobody else has chosen our own mode.
#[test]
fn a_mode_that_a_drive_tells_late_is_nobody_elses() {
    let line = "-v -a 1 --drive lxm05 --yes sollwert 300rpm --enable --hold --duration 500ms";
    let written = when(&antrieb(line).on(&servo(KEYS, "")).exits(0).err, "01 10 1B 06");
    let mut blamed = Vec::new();
    for ms in (300..900).step_by(20) {
        let at = written as u32 + ms;
        let event = format!("[[drive.event]]\nat = \"0ms\"\nignores = 6918\n[[drive.event]]\nat = \"{at}ms\"\n");
        let run = antrieb(line).on(&servo(KEYS, &format!("{event}set = {{ DCOMopmode = 3 }}\n"))).json();
        if run.exit != 0 {
            blamed.push(format!("{ms}: {}", run.error()["message"]));
        }
    }
    assert!(blamed.is_empty(), "{}", blamed.join("\n"));
}

/// Another master lets it turn by a speed, in which its state shows "reached": the movement waits for nothing any more.
#[test]
fn a_movement_in_whose_place_another_master_turns_the_shaft_is_ended_at_once() {
    for rest in ["--until reached --duration 1s", "--duration 8s"] {
        let line = format!("-v -a 1 --yes sollwert 300000usr --set PPn_target=300 --enable --hold {rest}");
        let other = "[[drive.event]]\nat = \"1s\"\nset = { DCOMopmode = 3, PVn_target = 300 }\n";
        let run = antrieb(&line).on(&servo(KEYS, other)).json();
        let told = format!("{rest}: {:#}", run.value);
        let ended = when(&run.err, QUICK_STOP);
        assert!(ended < 3_600.0, "it turned until {ended} ms: {told}");
        assert_eq!(run.error()["code"], "forbidden.otherwise", "{told}");
        assert_ne!(run.data("/setpoint/reached"), &json!(true), "{told}");
    }
}

/// Its first word was acknowledged, and then three answers are lost: the same as one telegram later.
#[test]
fn a_ramp_that_was_acknowledged_before_the_silence_stays_a_ramp() {
    let slow = "ramps = { up_right = 999, down_right = 2 }\n[[drive.event]]\nafter_telegrams = 3\nsilent = \"1700ms\"";
    let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&drive(RUNNING, slow)).run();
    let words = run.sent().into_iter().filter(|hex| hex.starts_with("01 06 01 9A"));
    let harder: Vec<_> = words.filter(|word| !word.starts_with(DISABLE)).collect();
    assert!(harder.is_empty(), "{harder:?} {}{}", run.out, run.err);
}
