//! From when the time of a run counts, and what may stay unanswered at its end.

use super::rig::{READY, drive, sent, servo, when};
use crate::run::antrieb;

const ENABLE: &str = "01 06 01 9A 00 0F";
const GEAR: &str = "IOposInterfac = 1, RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000";
const GUIDE: &str = "servo = { guide = 163840 }\n";
const FOLLOWS: &str = "01 10 1B 24 00 02 04 00 00 00 01";
const QUICK_STOP: &str = "01 10 1B 02 00 02 04 00 00 00 02";

/// Its least frequency turns it from its enabling on; its enable comes a second and a half behind the word.
#[test]
fn a_drive_that_is_not_enabled_yet_loses_nothing_of_the_time_of_its_run() {
    let set = READY.replace("\"418\" = 0", "\"418\" = 5");
    let line = "-v -b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 2s";
    let calm = antrieb(line).on(&drive(&set, "")).exits(0).sent();
    let word = calm.iter().position(|hex| hex.starts_with(ENABLE)).unwrap() + 1;
    let gone = format!("[[drive.event]]\nafter_telegrams = {word}\nenable = false\nfor = \"1500ms\"");
    let run = antrieb(line).on(&drive(&set, &gone)).exits(0);
    let lasted = when(&run.err, "01 06 01 9A 00 07") - when(&run.err, ENABLE);
    assert!((3_350.0..3_650.0).contains(&lasted), "{lasted}: {}", run.err);
}

fn gear(rest: &str, event: &str) -> crate::run::Document {
    let line = format!("-v -a 1 --yes sollwert 2/3 --enable --hold --duration {rest}");
    antrieb(&line).on(&servo(GEAR, &format!("{GUIDE}{event}"))).json()
}

/// The telegram from which on the shaft follows its guide.
fn follows(duration: &str) -> usize {
    let sent = sent(&gear(duration, "").err);
    sent.iter().position(|(_, hex)| hex.starts_with(FOLLOWS)).unwrap() + 1
}

/// The shaft follows already when its ratio is given once more: that is refused, and so is the run.
#[test]
fn a_ratio_that_is_refused_behind_the_first_turn_ends_the_run() {
    let turns = follows("2s");
    let run = gear("2s", &format!("[[drive.event]]\nafter_telegrams = {turns}\nrefuses = 9736"));
    assert_eq!(
        (run.exit, &run.error()["code"]),
        (6, &"refused.slave_device_failure".into()),
        "{:#} {}",
        run.value,
        run.err
    );
    assert!(when(&run.err, QUICK_STOP) - when(&run.err, FOLLOWS) < 500.0, "{}", run.err);
}

/// Nor is a ratio that nobody acknowledges waited for twice as long: --wait is 3 s.
#[test]
fn a_drive_that_falls_silent_behind_its_first_turn_is_stopped_as_soon_as_it_would_be_later() {
    let turns = follows("30s");
    let run = gear("30s", &format!("[[drive.event]]\nafter_telegrams = {}\nsilent = \"20s\"", turns + 1));
    let stopped = when(&run.err, QUICK_STOP) - when(&run.err, FOLLOWS);
    assert!(stopped < 4_500.0, "{stopped}: {}", run.err);
}
