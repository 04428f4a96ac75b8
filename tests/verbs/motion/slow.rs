//! Drives that take long to answer: what is seen of them is little, and must do.

use super::rig::{DISABLE, READY, RUNNING, drive};
use crate::run::antrieb;
use serde_json::json;

const LINE: &str = "-v -b 115200 -a 1 --drive acu statemachine";
/// P.412 in RAM, of the active data set.
const CONTROL: &str = "01 03 61 9C";

fn late(ms: u32) -> String {
    format!("[[disturb]]\nevery = 1\nkind = \"late\"\nby = \"{ms}ms\"\n")
}

fn ramps(down: u32) -> String {
    format!("ramps = {{ up_right = 999, down_right = {down}, up_left = 999, down_left = {down} }}\n")
}

/// The load keeps it turning for two answers.
fn dragged(at: u32, ms: u32) -> String {
    format!("[[drive.event]]\nat = \"{at}ms\"\ndragged = true\nfor = \"{}ms\"\n", 2 * ms)
}

/// Its frequency is 0 under power for a few tenths of a second only.
#[test]
fn the_short_standstill_of_a_slow_drive_is_seen() {
    for verb in ["disable", "quick-stop"] {
        for ms in [400, 470] {
            let run =
                antrieb(&format!("{LINE} {verb}")).on(&drive(RUNNING, &format!("{}{}", ramps(5), late(ms)))).json();
            let told = format!("{verb}, {ms} ms late: {:#} {}", run.value, run.err);
            assert_eq!((run.exit, run.data("/standing")), (0, &json!(true)), "{told}");
        }
    }
}

/// It shows 0 because it has no power: nobody knows whether its shaft coasts, whatever was acknowledged.
#[test]
fn a_slow_drive_without_power_is_not_said_to_stand() {
    for verb in ["disable", "quick-stop"] {
        for ms in [250, 400] {
            let idle = drive(&format!("{READY}, \"217\" = 0, \"218\" = 0"), &late(ms));
            let run = antrieb(&format!("{LINE} {verb}")).on(&idle).json();
            let told = format!("{verb}, {ms} ms late: {:#}", run.value);
            assert_eq!((run.exit, run.data("/standing")), (8, &json!(null)), "{told}");
            assert_eq!(run.error()["code"], "forbidden.standstill_unproven", "{told}");
        }
    }
}

/// It was seen to become slower by its word, so that this is neither said again nor asked about: both would take the time in which its
/// standstill shows.
#[test]
fn a_ramp_that_a_slow_drive_was_seen_to_obey_is_said_once() {
    for (ms, at) in [(250, 900), (250, 1_500), (400, 900), (400, 1_500)] {
        let bench = drive(RUNNING, &format!("{}{}{}", ramps(2), dragged(at, ms), late(ms)));
        let run = antrieb(&format!("{LINE} disable")).on(&bench).json();
        let told = format!("{ms} ms late, {at}: {:#} {}", run.value, run.err);
        assert_eq!((run.exit, run.data("/standing")), (0, &json!(true)), "{told}");
        assert_eq!(run.err.matches(&format!("> {DISABLE}")).count(), 1, "{told}");
        assert!(!run.err.contains(&format!("> {CONTROL}")), "{told}");
    }
}

/// It did not tell in time what its control word is, and becomes slower by the quick stop that went out: that is not what was asked for.
#[test]
fn a_quick_stop_in_place_of_a_ramp_is_told_of_a_slow_drive_too() {
    let first = "[[disturb]]\nonce = 1\nkind = \"lost\"\n";
    for (ms, at, slows) in [(250, 1_000, 2), (250, 1_500, 4), (400, 1_500, 2), (400, 2_000, 2)] {
        let brakes = format!("{RUNNING}, \"424\" = {slows}, \"425\" = {slows}");
        let rest = format!("{}{}{first}{}", ramps(2), dragged(at, ms + 50), late(ms));
        let run = antrieb(&format!("{LINE} disable")).on(&drive(&brakes, &rest)).json();
        let told = format!("{ms} ms late, {at}: {:#} {}", run.value, run.err);
        assert_eq!((run.exit, &run.error()["code"]), (8, &json!("forbidden.other_stop")), "{told}");
    }
}

/// It answers until the time of its stop is over, and works on: it is not said to be silent.
#[test]
fn a_slow_drive_that_does_not_obey_is_not_called_silent() {
    for ms in [200, 450] {
        let deaf = format!("[[drive.event]]\nat = \"0ms\"\nignores = 410\n{}", late(ms));
        let run = antrieb(&format!("{LINE} disable --wait 20s")).on(&drive(RUNNING, &deaf)).json();
        let told = format!("{ms} ms late: {:#}", run.value);
        assert_eq!(run.exit, 8, "{told}");
        assert!(
            run.error()["message"].as_str().unwrap().contains("the drive answers, but was not seen to stop"),
            "{told}"
        );
    }
}
