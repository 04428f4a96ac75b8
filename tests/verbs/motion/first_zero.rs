//! A setpoint of zero, said before anything is asked that it does not need: to whom, how often, and where it would not only slow a shaft.

use super::first_words::press_after;
use super::hasty::pressed;
use super::rig::{RUNNING, drive, servo};
use crate::run::antrieb;
use antrieb::drive::is_there;
use antrieb::drive::motion::{Meant, shout_zero};
use antrieb::profile::{Family, Mode};
use std::collections::BTreeSet;

const ZERO: &str = "01 65 01 E4 00 00 00 00";
const SERVO_ZERO: &str = "01 10 1B 1A 00 02 04 00 00 00 00";
const SILENT: &str = "[[drive.event]]\nat = \"0ms\"\nsilent = \"600s\"";

fn zeros(family: &Family) -> Vec<Mode> {
    family.modes.iter().filter(|mode| mode.zero_stops() && mode.starts.is_empty()).take(1).cloned().collect()
}

/// The other end closes the connection behind every answer.
#[test]
fn a_connection_that_ends_again_and_again_is_made_once_more_for_a_zero_and_then_told() {
    pressed(
        &drive(RUNNING, "[[disturb]]\nevery = 1\nkind = \"hang-up\""),
        |count, hex| {
            assert!(count < 40, "it goes on for ever: {hex}");
            false
        },
        async |session, registry| {
            let meant = Meant { address: 1, family: None, order: None };
            let said = shout_zero(session, registry, &meant, &zeros).await;
            assert!(said.is_err_and(|error| error.is_lost()));
            session.reopen().await.unwrap();
        },
    );
}

/// A port that takes no bytes as the zero is to go out takes it later.
#[test]
fn a_zero_waits_for_a_port_that_takes_no_bytes() {
    for (named, by) in [(None, 3), (Some("acu"), 3), (None, 5)] {
        let came = pressed(
            &drive(RUNNING, &format!("[[disturb]]\nonce = 1\nkind = \"stuck\"\nby = \"{by}s\"")),
            |_, _| false,
            async |session, registry| {
                is_there(session, 1).await;
                let meant = Meant { address: 1, family: named.and_then(|name| registry.family(name)), order: None };
                let said = shout_zero(session, registry, &meant, &zeros).await;
                assert!(matches!(said, Ok(true)), "{named:?} {by}: {said:?}");
            },
        );
        assert!(came.sent.iter().any(|hex| hex.starts_with(ZERO)), "{named:?} {by}: {:?}", came.sent);
    }
}

/// Said five times to who does not answer; whoever presses meanwhile gets it once more at once, and waits for no others.
#[test]
fn who_interrupts_a_zero_that_nobody_answers_waits_no_longer() {
    let mut said = BTreeSet::new();
    for turns in 0..40 {
        let came = pressed(
            &drive(RUNNING, SILENT),
            |_, _| false,
            async |session, registry| {
                press_after(session, turns);
                let meant = Meant { address: 1, family: registry.family("acu"), order: None };
                let said = shout_zero(session, registry, &meant, &zeros).await;
                assert!(matches!(said, Ok(true)), "{turns}: {said:?}");
            },
        );
        said.insert(came.sent.iter().filter(|hex| hex.starts_with(ZERO)).count());
    }
    // In the first round it may have met something else on the line.
    assert_eq!(said, (2..=6).collect(), "so often it is said");
}

/// It does not tell in time who it is, and takes the zero that is tried first: the other families have none for it.
#[test]
fn who_takes_the_first_zero_hears_none_of_the_other_families() {
    let run = antrieb("-v -a 1 sollwert 0").on(&servo("", "[[disturb]]\nonce = 1\nkind = \"lost\"")).run();
    let sent = run.sent();
    assert!(sent.iter().any(|hex| hex.starts_with(SERVO_ZERO)), "{sent:?}");
    assert!(!sent.iter().any(|hex| hex.starts_with("01 65 01 E4")), "{sent:?}");
}

/// What is added to it turns the shaft the other way as far as is known: the zero stays away, whatever else is not told.
#[test]
fn a_zero_that_may_turn_a_shaft_the_other_way_does_not_go_out_unseen() {
    let set = "\"410\" = 15, \"412\" = 1, \"434\" = 3, \"228\" = -40, \"484\" = 50, \"418\" = 0";
    for (after, unseen) in [(1, true), (2, false), (3, false)] {
        let silent = format!("[[drive.event]]\nafter_telegrams = {after}\nsilent = \"600s\"");
        let run = antrieb("-v -b 115200 -a 1 --drive acu sollwert 0").on(&drive(set, &silent)).run();
        assert_eq!(run.sent().iter().any(|hex| hex.starts_with(ZERO)), unseen, "{after}: {}", run.err);
    }
}

/// It was busy as the first zero came, and tells who it is while it is asked what else that could be: the zeros of the other families stay
/// away.
#[test]
fn who_tells_late_who_it_is_hears_none_of_the_other_families() {
    let run = |description: &str| {
        let first = format!("[[disturb]]\nonce = 1\n{description}\n");
        let busy = "[[disturb]]\nonce = 2\nkind = \"exception\"";
        antrieb("-v -a 1 sollwert 0").on(&servo("", &(first + busy))).run()
    };
    let mode = run("kind = \"lost\"");
    let mode =
        mode.err.lines().find_map(|line| line.split_once(" ms > 01 03 1B 08")?.0.trim().parse::<f64>().ok()).unwrap();
    let mut told = 0;
    for late in (mode as u64 - 40..mode as u64 + 20).step_by(3) {
        let run = run(&format!("kind = \"late\"\nby = \"{late}ms\""));
        let tells = "not the answer, from address 1: address 1: identification";
        let (zero, split) = ("> 01 65 01 E4", run.err.split_once(tells));
        // It came into the answer to something else, which was waited for.
        let is_in_time = |(before, behind): &(&str, &str)| {
            !before.contains(zero) && behind.split(zero).next().is_some_and(|between| between.contains("< 01 "))
        };
        if let Some((_, behind)) = split.filter(is_in_time) {
            told += 1;
            assert!(!behind.contains(zero), "{late}: {}", run.err);
        }
    }
    assert!(told > 2, "{told}");
}
