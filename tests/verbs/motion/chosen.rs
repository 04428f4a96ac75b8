//! What is chosen in a run, by us and by others: setpoints, modes, and the time that it has.

use super::rig::{READY, drive, servo, when};
use crate::run::antrieb;
use serde_json::json;

const KEYS: &str = "RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000";
const ENABLE: &str = "01 10 1B 02 00 02 04 00 00 00 0F";
const QUICK_STOP: &str = "01 10 1B 02 00 02 04 00 00 00 02";
/// DCOMopmode and _DCOMopmd_act.
const MODE: &str = "01 10 1B 06";
const SHOWN: &str = "01 03 1B 08";

/// Its least frequency would turn the shaft at a zero, so its setpoint goes out first; then another master gives one of his own.
#[test]
fn a_setpoint_that_another_master_gives_before_the_enable_is_taken_away() {
    const SETPOINT: &str = "01 65 01 E4";
    let line = "-v -b 115200 -a 1 --drive acu --yes sollwert --enable --hold --duration 1s -- -15Hz";
    let bench = |event: &str| drive("\"412\" = 1, \"434\" = 2, \"418\" = 10", event);
    let calm = antrieb(line).on(&bench("")).exits(0).sent();
    let given = calm.iter().position(|hex| hex.starts_with(SETPOINT)).unwrap() + 1;
    for after in given..given + 6 {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"484\" = 40 }}\n");
        let run = antrieb(line).on(&bench(&event)).run();
        let writes: Vec<_> =
            run.sent().into_iter().filter(|hex| hex.starts_with(SETPOINT) || hex.ends_with("E8 1D")).collect();
        let enable = writes.iter().position(|hex| hex.starts_with("01 06")).unwrap_or(writes.len());
        assert!(writes[enable - 1].starts_with("01 65 01 E4 00 00 00 00"), "{after}: {writes:#?}");
    }
}

/// No manual says how soon it is told: nobody else has chosen a mode that is the one from before for a second.
#[test]
fn a_mode_that_is_shown_late_is_waited_for_and_one_that_is_never_shown_is_not() {
    let line = "-v -a 1 --drive lxm05 --yes sollwert 300rpm --enable --hold --duration 500ms";
    let written = when(&antrieb(line).on(&servo(KEYS, "")).exits(0).err, MODE);
    let late = |ms: f64| {
        let at = (written + ms) as u32;
        let event = format!("[[drive.event]]\nat = \"0ms\"\nignores = 6918\n[[drive.event]]\nat = \"{at}ms\"\n");
        antrieb(line).on(&servo(KEYS, &format!("{event}set = {{ DCOMopmode = 3 }}\n"))).json()
    };
    for ms in [300.0, 900.0] {
        let run = late(ms);
        assert_eq!(run.exit, 0, "{ms}: {:#} {}", run.value, run.err);
    }
    let run = late(2_500.0);
    assert_eq!((run.exit, &run.error()["code"]), (8, &json!("forbidden.otherwise")), "{:#}", run.value);
    let given_up = when(&run.err, QUICK_STOP) - written;
    assert!((1_000.0..1_300.0).contains(&given_up), "{given_up}: {}", run.err);
}

/// Its load keeps it turning: that somebody else has chosen another mode is asked once, and not at every look.
#[test]
fn a_shaft_that_does_not_become_slower_is_asked_for_its_mode_once() {
    let line = "-v -a 1 --drive lxm05 --yes sollwert 600rpm --jog 700ms";
    let run = antrieb(line).on(&servo(KEYS, "[[drive.event]]\nat = \"800ms\"\ndragged = true\n")).run();
    let (_, behind) = run.err.split_once("> 01 10 1B 1A 00 02 04 00 00 02 58").unwrap();
    let (_, behind) = behind.split_once("> 01 10 1B 1A 00 02 04 00 00 00 00").unwrap();
    let (ramp, _) = behind.split_once(&format!("> {QUICK_STOP}")).unwrap();
    let asked = ramp.matches(&format!("> {SHOWN}")).count();
    assert!((1..=3).contains(&asked), "{asked}: {}", run.err);
}

/// Its enable is gone for a moment just as the word goes out: the time of its run begins when it has power.
#[test]
fn the_time_of_a_run_begins_with_its_power_and_not_with_a_word_that_gives_none() {
    const WORD: &str = "01 06 01 9A 00 0F";
    const DISABLE: &str = "01 06 01 9A 00 07";
    let line = "-v -b 115200 -a 1 --drive acu --yes statemachine enable --hold --duration 1s";
    let word =
        antrieb(line).on(&drive(READY, "")).exits(0).sent().iter().position(|hex| hex.starts_with(WORD)).unwrap();
    for (after, gone) in [(word, 500), (word + 1, 500), (word, 1_500), (word + 1, 2_500)] {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\nenable = false\nfor = \"{gone}ms\"\n");
        let run = antrieb(line).on(&drive(READY, &event)).run();
        assert_eq!(run.exit, 0, "{gone}: {}", run.err);
        let lasted = when(run.err.split("running; Ctrl-C").last().unwrap(), DISABLE) - when(&run.err, WORD);
        assert!(lasted > f64::from(gone) + 900.0, "{gone}: {lasted} {}", run.err);
    }
}

/// Another master gives it a quick stop as it is enabled, and it stays in that with power: its run has its time, and no more.
#[test]
fn the_time_of_a_run_goes_on_while_somebody_else_holds_its_shaft() {
    let line = "-v -a 1 --drive lxm05 --yes statemachine enable --hold --duration 1s";
    let slow = "readings = { quick_stop = \"stays\" }\n[[disturb]]\nevery = 1\nkind = \"late\"\nby = \"300ms\"\n";
    let enabled = when(&antrieb(line).on(&servo(KEYS, slow)).exits(0).err, ENABLE);
    let at = enabled as u32 + 200;
    let event = format!("[[drive.event]]\nat = \"{at}ms\"\nset = {{ DCOMcontrol = 2 }}\n");
    let run = antrieb(line).on(&servo(KEYS, &slow.replacen("[[", &format!("{event}[["), 1))).run();
    let took = when(&run.err, QUICK_STOP) - enabled;
    assert!(took < 1_800.0, "{took}: {}", run.err);
}
