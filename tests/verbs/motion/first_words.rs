//! What comes to the first words of a stop: who refuses them, tells late who he is, loses an answer, or presses Ctrl-C meanwhile.

use super::by_chance::Trial;
use super::hasty::pressed;
use super::rig::{DISABLE, QUICK_STOP, RUNNING, drive, servo};
use crate::run::antrieb;
use antrieb::drive::motion::{Meant, shout, shout_round};
use antrieb::drive::{Interrupt, Session};
use antrieb::gate::Relief;
use antrieb::profile::Registry;
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;

const WORD: &str = "01 06 01 9A";
const SERVO: &str = "01 10 1B 02";
const SILENT: &str = "[[drive.event]]\nat = \"0ms\"\nsilent = \"600s\"";

fn meant(registry: &Registry, address: u8, named: Option<&str>) -> Meant {
    Meant { address, family: named.and_then(|name| registry.family(name)), order: None }
}

fn beside(address: u8, drive: &str) -> String {
    drive.replace("baud =", &format!("address = {address}\nbaud ="))
}

/// The other end closes the connection behind every answer.
#[test]
fn a_connection_that_ends_again_and_again_is_made_once_more_and_then_told() {
    let bench = drive(RUNNING, "[[disturb]]\nevery = 1\nkind = \"hang-up\"");
    let came = pressed(
        &bench,
        |count, hex| {
            assert!(count < 40, "it goes on for ever: {hex}");
            false
        },
        async |session, registry| {
            let said = shout(session, registry, &meant(registry, 1, Some("acu")), Relief::QuickStop).await;
            assert!(said.is_err_and(|error| error.is_lost()));
            session.reopen().await.unwrap();
        },
    );
    assert_eq!(came.sent.iter().filter(|hex| hex.starts_with(WORD)).count(), 2, "{:?}", came.sent);
}

/// Presses Ctrl-C so many turns of the loop later, whatever is under way then.
pub(super) fn press_after(session: &mut Session<'_>, turns: usize) -> Interrupt {
    let wish = Interrupt::default();
    session.heed(wish.clone());
    let hand = wish.clone();
    tokio::spawn(async move {
        for _ in 0..turns {
            tokio::task::yield_now().await;
        }
        hand.press();
    });
    wish
}

/// Whoever interrupts the question before a ramp gets a quick stop at once and no stronger one behind it; whoever interrupts a word is told.
#[test]
fn an_interrupt_is_a_quick_stop_before_a_ramp_and_a_stronger_stop_behind_it() {
    let (mut instead, mut behind) = (0, 0);
    for turns in 0..40 {
        let came = pressed(
            &drive(RUNNING, ""),
            |_, _| false,
            async |session, registry| {
                let wish = press_after(session, turns);
                let first = shout(session, registry, &meant(registry, 1, Some("acu")), Relief::Disable).await.unwrap();
                let kinds = (first.leaves_the_strongest(), first.pressed);
                assert!(kinds != (true, true), "{turns}: one press counts twice");
                assert!(
                    kinds != (false, false) || !wish.is_raised() || session.is_interrupted(),
                    "{turns}: it is lost"
                );
                instead += u32::from(kinds.0);
                behind += u32::from(kinds.1);
            },
        );
        assert!(came.sent.iter().any(|hex| hex.starts_with(WORD)), "{turns}: {:?}", came.sent);
    }
    assert!(instead > 0 && behind > 0, "{instead} {behind}");
}

/// The same where others wait: its word goes out before anybody else is spoken to, and a quick stop is told as one, whoever else it
/// could be.
#[test]
fn an_interrupt_in_the_round_keeps_no_word_back_and_makes_no_ramp_of_a_quick_stop() {
    let lost = "[[disturb]]\nonce = 1\nkind = \"lost\"";
    for (named, rest) in [(Some("acu"), ""), (None, lost)] {
        let mut instead = 0;
        for turns in 0..60 {
            let bench = drive(RUNNING, rest) + &beside(2, &drive(RUNNING, ""));
            let quick = Cell::new(false);
            let came = pressed(
                &bench,
                |_, _| false,
                async |session, registry| {
                    press_after(session, turns);
                    let drives = [1, 2].map(|address| meant(registry, address, named));
                    let (calls, _) = shout_round(session, registry, &drives, Relief::Disable).await;
                    let first = calls.into_iter().next().unwrap().go_on(session, registry).await;
                    quick.set(first.is_ok_and(|first| first.leaves_the_strongest()));
                },
            );
            let place = |begins: &str| came.sent.iter().position(|hex| hex.starts_with(begins));
            let told = format!("{named:?} {turns}: {:?}", came.sent);
            if named.is_none() && !came.sent[0].starts_with("01 2B") {
                continue;
            }
            assert!(place(WORD).is_some() && place(WORD) < place("02 "), "{told}");
            assert_eq!(place(QUICK_STOP).is_some() && place(DISABLE).is_none(), quick.get(), "{told}");
            instead += u32::from(quick.get());
        }
        assert!(instead > 0, "{named:?}");
    }
}

/// Whenever it comes, whoever answers: it is told of who was spoken to then, or still there for the next.
#[test]
fn an_interrupt_while_several_are_told_is_heard() {
    for (rest, named) in [("", Some("acu")), (SILENT, Some("acu")), (SILENT, None)] {
        for turns in 0..60 {
            let bench = drive(RUNNING, rest) + &beside(2, &drive(RUNNING, SILENT));
            pressed(
                &bench,
                |_, _| false,
                async |session, registry| {
                    let wish = press_after(session, turns);
                    let drives = [1, 2].map(|address| meant(registry, address, named));
                    let (calls, pressed) = shout_round(session, registry, &drives, Relief::QuickStop).await;
                    let is_before = wish.is_raised();
                    let is_lost = is_before && !pressed && !session.is_interrupted();
                    assert!(!is_lost || named.is_none(), "{named:?} {rest} {turns}: lost in the round");
                    let calls = RefCell::new(calls.into_iter().map(Some).collect::<Vec<_>>());
                    let one = async |session: &mut Session<'_>, at: usize| {
                        let call = calls.borrow_mut()[at].take().unwrap();
                        let told = call.go_on(session, registry).await.map_or(true, |first| first.pressed);
                        is_before || told || !wish.is_raised() || session.is_interrupted()
                    };
                    let heard = session.side_by_side(&[1, 2], one).await;
                    assert_eq!(heard, [true, true], "{named:?} {rest} {turns}: lost behind the round");
                },
            );
        }
    }
}

/// Nobody answers: whoever presses before the word has left hears it once, and no other keeps the stronger one waiting.
#[test]
fn an_interrupt_of_a_word_that_nobody_answers_waits_for_no_other() {
    let mut said = BTreeSet::new();
    for turns in 0..40 {
        let came = pressed(
            &drive(RUNNING, SILENT),
            |_, _| false,
            async |session, registry| {
                press_after(session, turns);
                let _told_or_not = shout(session, registry, &meant(registry, 1, Some("acu")), Relief::QuickStop).await;
            },
        );
        said.insert(came.sent.iter().filter(|hex| hex.starts_with(QUICK_STOP)).count());
    }
    assert_eq!(said, (1..=6).collect(), "so often it is said");
}

/// It acknowledges: that is told, with who pressed.
#[test]
fn an_interrupt_of_a_word_that_is_acknowledged_ends_no_stop() {
    for turns in 0..20 {
        pressed(
            &drive(RUNNING, ""),
            |_, _| false,
            async |session, registry| {
                press_after(session, turns);
                let said = shout(session, registry, &meant(registry, 1, Some("acu")), Relief::QuickStop).await;
                assert!(said.is_ok(), "{turns}: it was acknowledged");
            },
        );
    }
}

/// A family was named, and the drive knows no such word: those of the others follow its first no.
#[test]
fn whoever_refuses_the_stop_of_the_family_that_was_named_hears_that_of_the_others_at_once() {
    for (bench, named, refused, word) in
        [(servo("", ""), "acu", WORD, SERVO), (drive(RUNNING, ""), "lxm05", SERVO, WORD)]
    {
        let speed = if named == "acu" { "" } else { "-b 115200 " };
        let run = antrieb(&format!("-v {speed}-a 1 --drive {named} statemachine quick-stop")).on(&bench).run();
        let sent = run.sent();
        let first = sent.iter().position(|hex| hex.starts_with(word)).unwrap();
        let before = sent[..first].iter().filter(|hex| hex.starts_with(refused)).count();
        // A servo is told in both word orders.
        assert_eq!(before, if named == "acu" { 1 } else { 2 }, "{named}: {sent:?}");
    }
}

/// It was named as another, its refusal is lost, and what it is it tells while the next one keeps it waiting: it is told until it takes a
/// word.
#[test]
fn a_drive_of_another_family_whose_refusal_is_lost_is_told_all_the_same() {
    let dead = "[[drive]]\nmodel = \"lxm05\"\naddress = 2\n[[drive.event]]\nat = \"0s\"\nsilent = \"600s\"\n";
    let lost = |once: u32| format!("[[disturb]]\nonce = {once}\nkind = \"lost\"\naddress = 1\n");
    for late in (300..700).step_by(20) {
        let late = format!("[[disturb]]\nonce = 2\nkind = \"late\"\nby = \"{late}ms\"\naddress = 1\n");
        let bench = [&servo("", ""), dead, &lost(1), &late, &lost(3)].concat();
        let run = antrieb("-v -a 1,2 --drive acu statemachine quick-stop").on(&bench).run();
        let word = "01 10 1B 02 00 02 04 00 00 00 02";
        assert!(run.sent().iter().any(|hex| hex.starts_with(word)), "{late} {}", run.err);
    }
}

/// Nobody knows whether it is a servo, and it has no control word of the others to tell: its own goes out in its turn.
#[test]
fn a_word_that_needs_no_question_goes_out_in_the_first_round() {
    let bench = [
        servo("", ""),
        "[[drive]]\nmodel = \"lxm05\"\naddress = 2\n".to_owned(),
        "[[disturb]]\nonce = 1\nkind = \"lost\"\n".to_owned(),
    ]
    .concat();
    let sent = antrieb("-v -a 1,2 statemachine disable").on(&bench).run().sent();
    let place = |begins: &str| sent.iter().position(|hex| hex.starts_with(begins));
    assert!(place(SERVO).is_some() && place(SERVO) < place("02 "), "{sent:?}");
}

/// Its questions took as long: it is slow, and one word is waited for instead of being said again.
#[test]
fn a_drive_that_told_its_control_word_late_hears_its_ramp_once() {
    for delay in [260, 300, 400] {
        let bench = drive(RUNNING, "").replace("\"1ms\"", &format!("\"{delay}ms\""));
        let sent = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&bench).run().sent();
        let word = sent.iter().position(|hex| hex.starts_with(DISABLE)).unwrap();
        assert!(!sent[word + 1].starts_with(DISABLE), "{delay}: {sent:?}");
    }
}

/// Behind a ramp that nobody answers one press is a quick stop and two are the strongest stop, and no weaker one follows it.
#[test]
fn the_stop_behind_an_unanswered_ramp_is_the_one_that_was_pressed_for() {
    let registry = Registry::open(&[]).unwrap();
    for (presses, way, words) in [(&[2][..], "quick-stop", "222"), (&[2, 2], "coast", "200"), (&[2, 3], "coast", "200")]
    {
        let bench = drive(RUNNING, "[[drive.event]]\nat = \"0ms\"\nsilent = \"1900ms\"").replace("115200", "19200");
        let seen = Trial::on_bench("-a 1 --drive acu statemachine disable", &bench, &registry, (presses, None));
        let said: String =
            seen.log.iter().filter_map(|line| line.split_once(" > 01 06 01 9A 00 0")?.1.chars().next()).collect();
        let told = format!("{presses:?}: {:?}\n{}", seen.failure, seen.log.join("\n"));
        assert_eq!(said, words, "{told}");
        let message = seen.failure.unwrap().message.en;
        assert_eq!(message, format!("interrupted; {way}: the stop was acknowledged"), "{told}");
    }
}
