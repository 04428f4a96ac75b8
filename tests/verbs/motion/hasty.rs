//! Who presses Ctrl-C while a stop is being said gets it all the same, sooner and not less.

use super::rig::{RUNNING, drive};
use antrieb::drive::motion::{Meant, Motor, StopChoice, shout};
use antrieb::drive::{Interrupt, Opening, Session, Target};
use antrieb::gate::Relief;
use antrieb::outcome::Event;
use antrieb::profile::Registry;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::tick::Span;
use antrieb::transport::Port;
use std::cell::RefCell;

/// What went out, what was told, and how many shafts turn in the end.
pub(super) struct Came {
    pub(super) sent: Vec<String>,
    pub(super) notes: Vec<String>,
    pub(super) turning: u64,
}

/// Does `work` on a bench at 115200 Bd, and presses Ctrl-C as the n-th telegram goes out, and at each of those behind it
/// that `again` says.
pub(super) fn pressed(
    bench: &str,
    presses: impl Fn(usize, &str) -> bool,
    work: impl AsyncFnOnce(&mut Session<'_>, &Registry),
) -> Came {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, bench).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let (port, interrupt) = (Port::Sim(Some(file)), Interrupt::default());
    let (signals, sent, notes) = (interrupt.clone(), RefCell::new(Vec::new()), RefCell::new(Vec::new()));
    let mut observe = |event: Event| match event {
        Event::Telegram { direction: '>', hex, .. } => {
            let mut sent = sent.borrow_mut();
            if presses(sent.len(), &hex) {
                signals.press();
            }
            sent.push(hex);
        }
        Event::Note(text) => notes.borrow_mut().push(text.en),
        _ => {}
    };
    let opening = Opening { line: LineSetting::rtu(115_200, Parity::Even), verbose: true, ..Opening::at(&port) };
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let mut session = runtime.block_on(Session::open(opening, &registry, interrupt, &mut observe)).unwrap();
    let turning = runtime.block_on(async {
        work(&mut session, &registry).await;
        session.heed(Interrupt::default());
        session.rest(Span::from_secs(60)).await.unwrap();
        session.bench().unwrap().totals().turning
    });
    drop(session);
    Came { sent: sent.into_inner(), notes: notes.into_inner().iter().map(ToString::to_string).collect(), turning }
}

/// P.410 by code 6.
const WORD: &str = "01 06 01 9A 00 0";

#[test]
fn an_interrupt_of_the_questions_before_a_stop_does_not_keep_it_back() {
    for (named, act) in [Some("acu"), None]
        .into_iter()
        .flat_map(|named| [Relief::Disable, Relief::QuickStop, Relief::DisableVoltage].map(|act| (named, act)))
    {
        for press in 0..4 {
            let came = pressed(
                &drive(RUNNING, ""),
                |count, _| count == press,
                async |session, registry| {
                    let meant = Meant { address: 1, family: named.and_then(|name| registry.family(name)), order: None };
                    let _interrupted_or_not = shout(session, registry, &meant, act).await;
                },
            );
            let told = format!("{named:?} {act:?} {press}: {:?}", came.sent);
            assert!(came.sent.iter().any(|hex| hex.starts_with(WORD)), "{told}");
            assert_eq!(came.turning, 0, "{told}");
        }
    }
}

/// Nobody answers, so that nobody knows who it is: each family has its word once.
#[test]
fn an_interrupt_of_a_stop_that_nobody_answers_leaves_no_family_out() {
    let silent = drive(RUNNING, "[[drive.event]]\nat = \"0ms\"\nsilent = \"600s\"");
    for press in 0..6 {
        let came = pressed(
            &silent,
            |count, _| count == press,
            async |session, registry| {
                let meant = Meant { address: 1, family: None, order: None };
                let said = shout(session, registry, &meant, Relief::QuickStop).await;
                assert!(said.is_err() || press == 0);
            },
        );
        // P.410, and DCOMcontrol in both orders.
        for word in ["01 06 01 9A 00 02", "01 10 1B 02 00 02 04 00 00 00 02", "01 10 1B 02 00 02 04 00 02 00 00"] {
            assert!(came.sent.iter().any(|hex| hex.starts_with(word)), "{press}: {word} {:?}", came.sent);
        }
    }
}

/// The word came back, and it is asked whether that was the answer or the echo: what was pressed is passed on.
#[test]
fn an_interrupt_of_the_question_behind_a_word_makes_the_stop_stronger() {
    let pressed_once = std::cell::Cell::new(false);
    let came = pressed(
        &drive(RUNNING, ""),
        |_, hex| hex.starts_with("01 03 01 9B") && !pressed_once.replace(true),
        async |session, registry| {
            let meant = Meant { address: 1, family: registry.family("acu"), order: None };
            shout(session, registry, &meant, Relief::QuickStop).await.unwrap();
            let mut target = Target::new(1, registry.family("acu").unwrap());
            let permit = Relief::QuickStop.permit();
            let mut motor = Motor::new(session, &mut target, &permit, None);
            let relief = async |motor: &mut Motor<'_, '_>| motor.relieve(Relief::QuickStop).await;
            let ended = motor.run(false, StopChoice::beyond(Relief::QuickStop), relief).await;
            let stop = ended.stop.unwrap();
            assert_eq!((stop.choice, stop.because, stop.acknowledged), ("coast", "interrupted", true), "{stop:?}");
        },
    );
    assert!(came.sent.iter().any(|hex| hex.starts_with("01 06 01 9A 00 00")), "{:?}", came.sent);
}

/// The ramp went out, and nobody has looked yet.
#[test]
fn an_interrupt_of_the_first_look_behind_a_stop_makes_it_stronger() {
    let looks = |_: usize, hex: &str| hex.starts_with("01 03 01 9B");
    let pressed_once = std::cell::Cell::new(false);
    let came = pressed(
        &drive(RUNNING, ""),
        |count, hex| looks(count, hex) && !pressed_once.replace(true),
        async |session, registry| {
            let mut target = Target::new(1, registry.family("acu").unwrap());
            let permit = Relief::Disable.permit();
            let mut motor = Motor::new(session, &mut target, &permit, None);
            let relief = async |motor: &mut Motor<'_, '_>| motor.relieve(Relief::Disable).await;
            let ended = motor.run(false, StopChoice::beyond(Relief::Disable), relief).await;
            let stop = ended.stop.unwrap();
            assert_eq!((stop.choice, stop.because), ("quick-stop", "interrupted"), "{stop:?}");
        },
    );
    assert!(came.sent.iter().any(|hex| hex.starts_with("01 06 01 9A 00 02")), "{:?}", came.sent);
    assert_eq!(came.turning, 0, "{:?} {:?}", came.sent, came.notes);
}
