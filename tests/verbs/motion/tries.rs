//! What takes motion away is tried again where the line fails now and then, as what it is and not for ever.

use super::rig::{DISABLE, QUICK_STOP, RUNNING, drive, when};
use crate::run::antrieb;

const LINE: &str = "-v -b 115200 -a 1 --drive acu statemachine disable";
const WORD: &str = "01 06 01 9A 00 ";

/// It runs at 10 Hz at once, and slows down for 5 s.
fn slows(rest: &str) -> String {
    drive(RUNNING, &format!("ramps = {{ up_right = 999, down_right = 2, up_left = 999, down_left = 2 }}\n{rest}"))
}

fn words(sent: Vec<String>) -> Vec<String> {
    sent.into_iter().filter(|hex| hex.starts_with(WORD)).collect()
}

/// It answers, and then nothing comes for as long as three answers are waited for.
#[test]
fn a_ramp_of_which_answers_are_lost_stays_a_ramp() {
    for after in 4..16 {
        let run = antrieb(LINE).on(&slows(&format!("[[drive.event]]\nafter_telegrams = {after}\nsilent = \"1700ms\"")));
        let run = run.run();
        let harder = words(run.sent()).into_iter().find(|word| !word.starts_with(DISABLE));
        assert_eq!((harder, run.exit), (None, 0), "silent after {after}: {}{}", run.out, run.err);
    }
}

/// Three answers of each try are lost: the first word, one word of each try, and then what is harder.
#[test]
fn behind_three_tries_of_a_ramp_a_quick_stop_follows() {
    let lost = |once: u32| format!("[[disturb]]\nonce = {once}\nkind = \"lost\"\n");
    let lost: String = (0..6).flat_map(|nth| (0..3).map(move |more| lost(9 + 12 * nth + more))).collect();
    let run = antrieb(LINE).on(&slows(&lost)).run();
    let words = words(run.sent());
    let ramps = words.iter().take_while(|word| word.starts_with(DISABLE)).count();
    assert_eq!(ramps, 4, "{words:?}");
    assert!(words[ramps].starts_with(QUICK_STOP), "{words:?}");
}

/// Its port takes no bytes for a moment, as the first look behind the stop is to go out: that ends nothing.
#[test]
fn a_port_that_is_stuck_for_a_moment_behind_a_stop_ends_no_stop() {
    for once in 2..5 {
        let stuck = format!("[[disturb]]\nonce = {once}\nkind = \"stuck\"\nby = \"800ms\"");
        let run = antrieb(LINE).on(&slows(&stuck)).run();
        assert_eq!(run.exit, 0, "stuck behind {once}: {}{}", run.out, run.err);
        assert_eq!(words(run.sent()).len(), 2, "stuck behind {once}: {}", run.err);
    }
}

/// Nothing is heard from its first word on: a stronger one does not wait for another try.
#[test]
fn a_dead_line_keeps_no_stronger_stop_back() {
    let run = antrieb(LINE).on(&slows("[[drive.event]]\nafter_telegrams = 2\nsilent = \"600s\"")).run();
    let harder = when(&run.err, QUICK_STOP);
    assert!(harder < 4_500.0, "{harder}: {}", run.err);
}
