//! Several drives are stopped side by side: one that ignores its stop, coasts or is dead costs no other one his proof, and who presses
//! Ctrl-C gets the stronger stop of all.

use super::rig::{RUNNING, ran};
use crate::run::{Document, antrieb};
use antrieb::drive::motion::{Ended, Motor, StopChoice};
use antrieb::drive::{Interrupt, Opening, Session, Target};
use antrieb::gate::Relief;
use antrieb::outcome::Event;
use antrieb::profile::Registry;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::tick::Span;
use antrieb::transport::Port;
use std::cell::RefCell;

/// A drive at 10 Hz: a quick stop by so many hertz a second, and more.
pub(super) fn drive(address: u8, quick: &str, more: &str) -> String {
    format!(
        "[[drive]]\nmodel = \"acu\"\naddress = {address}\nbaud = 19200\nset = {{ {RUNNING}, \"424\" = \"{quick}\", \"425\" = \"{quick}\" }}\n\
         ramps = {{ up_right = 50, down_right = 5, up_left = 50, down_left = 5 }}\n{more}\n"
    )
}

const DEAD: &str = "[[drive.event]]\nat = \"0s\"\nsilent = \"10min\"";
const REFUSES: &str = "[[drive.event]]\nat = \"0s\"\nrefuses = 410";
const SERVO: &str = "[[drive]]\nmodel = \"lxm05\"\naddress = 6\nbaud = 19200\n";

/// A verb on drives that run for a second.
pub(super) fn running(line: &str, bench: &str) -> crate::run::Run {
    ran(Span::from_secs(1), &format!("-b 19200 {line}"), bench)
}

/// What is told of a drive: `(standing, exit of its error)`.
pub(super) fn of(run: &Document, at: usize) -> (Option<bool>, Option<u64>) {
    let told = |pointer: &str| run.value.pointer(&format!("/data/drives/{at}/{pointer}")).cloned().unwrap_or_default();
    (told("motion/standing").as_bool(), told("error/exit").as_u64())
}

/// The longest time in ms between two telegrams to a drive, until `until`.
fn longest_gap(run: &Document, address: u8, until: f64) -> f64 {
    let to = run.err.lines().filter_map(|line| line.split_once(" ms > "));
    let to = to.filter(|(_, hex)| hex.starts_with(&format!("{address:02X} ")));
    let at: Vec<f64> = to.map(|(at, _)| at.trim().parse().unwrap()).filter(|&at: &f64| at < until).collect();
    at.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max)
}

/// Whoever is beside it, a drive that stops is seen to stand, in both orders, and is looked at all the time.
#[test]
fn who_ignores_coasts_refuses_or_is_dead_costs_no_other_one_his_proof() {
    let good = drive(2, "10", "");
    for (other, verb, exit) in [
        // It takes 100 s to stop.
        (drive(1, "0.1", ""), "quick-stop", 0),
        (drive(1, "10", DEAD), "quick-stop", 9),
        (drive(1, "10", REFUSES), "quick-stop", 9),
        (drive(1, "10", DEAD), "disable", 9),
        (drive(1, "10", "reply_delay = \"80ms\""), "quick-stop", 0),
        // Under P.392 = 0 it coasts, and has no encoder.
        (drive(1, "10", "").replace("\"424\"", "\"392\" = 0, \"217\" = 0, \"218\" = 0, \"424\""), "disable", 0),
    ] {
        for order in ["1,2", "2,1"] {
            let bench = [other.clone(), good.clone()].concat();
            let line = format!("-v -a {order} statemachine {verb}");
            let run = running(&line, &bench).json();
            let told = format!("{order} {verb}: {other} {:#} {}", run.value, run.err);
            let at = order.split(',').position(|address| address == "2").unwrap();
            assert_eq!((run.exit, of(&run, at)), (exit, (Some(true), None)), "{told}");
        }
    }
}

/// A slow drive may or may not be proven itself, as the turns fall.
#[test]
fn who_is_slow_costs_no_other_one_his_proof() {
    let slow = drive(1, "10", "slow = \"400ms\"");
    for order in ["1,2", "2,1"] {
        let bench = [slow.clone(), drive(2, "10", "")].concat();
        let run = running(&format!("-v -a {order} statemachine quick-stop"), &bench).json();
        let at = order.split(',').position(|address| address == "2").unwrap();
        assert_eq!(of(&run, at), (Some(true), None), "{order} {:#} {}", run.value, run.err);
        assert_ne!(of(&run, 1 - at).0, Some(false), "{order} {:#} {}", run.value, run.err);
    }
}

/// Seven at once, in both orders: four that stop, and every kind of bad one.
#[test]
fn the_order_of_a_group_tells_nothing_of_its_proofs() {
    let bench = [
        drive(1, "5", ""),
        drive(2, "4", ""),
        drive(4, "10", REFUSES),
        drive(5, "10", "").replace("\"412\" = 1", "\"412\" = 44"),
        SERVO.to_owned(),
        drive(7, "0.5", ""),
        drive(8, "8", ""),
        drive(9, "10", DEAD),
    ]
    .concat();
    for order in ["1,2,4,5,6,7,8,9", "9,8,7,6,5,4,2,1"] {
        let run = running(&format!("-v -a {order} statemachine quick-stop"), &bench).json().exits(9);
        for (at, address) in order.split(',').enumerate() {
            let proven = ["1", "2", "7", "8"].contains(&address);
            let told = of(&run, at);
            assert_eq!(
                told.0 == Some(true) && told.1.is_none(),
                proven || address == "6",
                "{order} {address} {told:?} {}",
                run.err
            );
        }
        assert!(longest_gap(&run, 8, 5_000.0) < 2_000.0, "{order}");
    }
}

/// A zero is a stop, too: pumps are running.
#[test]
fn a_setpoint_of_zero_stops_several() {
    let bench = [drive(1, "10", ""), drive(2, "10", ""), drive(3, "10", DEAD)].concat();
    for zero in ["0", "0Hz", "0,0Hz"] {
        let run = running(&format!("-v -a 1,2 sollwert {zero}"), &bench).json().exits(0);
        assert_eq!((of(&run, 0), of(&run, 1)), ((Some(true), None), (Some(true), None)), "{zero} {:#}", run.value);
        let run = running(&format!("-v -a 3,2,1 sollwert {zero}"), &bench).json().exits(9);
        assert_eq!((of(&run, 1).0, of(&run, 2).0), (Some(true), Some(true)), "{zero} {:#}", run.value);
        assert_eq!(run.data("/drives/0/error/class"), "silence", "{zero} {:#}", run.value);
    }
    let plan = antrieb("-a 1,2 --drive acu sollwert 0Hz --dry-run").json().exits(0);
    assert!(
        plan.data("/telegrams").as_array().unwrap().iter().any(|row| row["hex"].as_str().unwrap().starts_with("02 65"))
    );
    // Anything else is one drive's.
    for more in ["10Hz", "0Hz --enable", "0Hz --hold"] {
        antrieb(&format!("-a 1,2 sollwert {more} --yes")).on(&bench).exits(2);
    }
    antrieb("-a 0,1 sollwert 0Hz").on(&bench).exits(2);
}

/// The internal setpoint would turn it on (P.434 = 3): that is asked of one drive, and the others stop.
#[test]
fn a_zero_that_must_be_asked_is_left_out_and_the_others_stop() {
    let adds = drive(1, "10", "").replace("\"434\" = 2", "\"434\" = 3, \"228\" = -5");
    let run = running("-a 1,2 sollwert 0Hz", &[adds, drive(2, "10", "")].concat()).json().exits(9);
    assert_eq!(of(&run, 1), (Some(true), None), "{:#}", run.value);
    assert_eq!(run.data("/drives/0/error/exit"), 8, "{:#}", run.value);
}

/// What came of drives that were told to stop by a quick stop, 10 s long, where somebody wished for the end meanwhile.
struct Pressed {
    ended: Vec<Ended<()>>,
    sent: Vec<String>,
    took: Span,
}

fn pressed(bench: &str, addresses: &[u8], presses: &[&str], wish: fn(&Interrupt)) -> Pressed {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, bench).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let (port, mut interrupt) = (Port::Sim(Some(file)), Interrupt::default());
    interrupt.hear_only_keys();
    let (signals, sent) = (interrupt.clone(), RefCell::new(Vec::<String>::new()));
    let mut left = presses.to_vec();
    let mut observe = |event: Event| {
        if let Event::Telegram { direction: '>', hex, .. } = event {
            if left.first().is_some_and(|next| hex.starts_with(next)) {
                left.remove(0);
                wish(&signals);
            }
            sent.borrow_mut().push(hex);
        }
    };
    let opening = Opening { line: LineSetting::rtu(19_200, Parity::Even), verbose: true, ..Opening::at(&port) };
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let mut session = runtime.block_on(Session::open(opening, &registry, interrupt, &mut observe)).unwrap();
    let act = Relief::QuickStop;
    let (ended, took) = runtime.block_on(async {
        session.rest(Span::from_secs(1)).await.unwrap();
        let begun = session.now();
        let stop = async |session: &mut Session<'_>, at: usize| {
            let mut target = Target::new(addresses[at], registry.family("acu").unwrap());
            let permit = act.permit();
            let begun = session.now();
            let mut motor = Motor::new(session, &mut target, &permit, None);
            motor.relieving = Some(begun);
            let relieve = async |motor: &mut Motor<'_, '_>| motor.relieve(act).await;
            motor.run(false, StopChoice::beyond(act), relieve).await
        };
        let ended = session.side_by_side(addresses, stop).await;
        (ended, session.now().since(begun))
    });
    drop(session);
    Pressed { ended, sent: sent.into_inner(), took }
}

/// One that is proven is left alone; all others hear the stronger word before any of them is looked at again.
#[test]
fn an_interrupt_makes_the_stop_of_all_stronger_at_once() {
    let bench = [drive(1, "1", ""), drive(2, "1", ""), drive(3, "1", "")].concat();
    // Behind the looks at each, as all are ramping.
    let looks = ["03 64 00 D2", "03 64 00 D2", "01 64 00 D2"];
    for presses in [&looks[..1], &["02 03 01 9B"], &["01 03 01 9B"]] {
        let came = pressed(&bench, &[1, 2, 3], presses, Interrupt::press);
        for (address, ended) in (1u8..).zip(&came.ended) {
            let stop = ended.stop.as_ref().unwrap();
            assert_eq!(
                (stop.choice, stop.because, stop.acknowledged),
                ("coast", "interrupted", true),
                "{address} {stop:?}"
            );
        }
        let word = |address: u8| {
            came.sent.iter().position(|hex| hex.starts_with(&format!("{address:02X} 06 01 9A 00 00"))).unwrap()
        };
        let (first, last) = ((1..=3).map(word).min().unwrap(), (1..=3).map(word).max().unwrap());
        assert!(last - first <= 14, "{presses:?} {:?}", &came.sent[first..=last]);
        assert!(came.took < Span::from_secs(6), "{}", came.took);
    }
}

/// The terminal is gone, which is nobody's wish: the stop goes on as it was chosen, and is proven.
#[test]
fn a_hang_up_ends_no_stop_of_several() {
    let bench = [drive(1, "5", ""), drive(2, "5", "")].concat();
    for hangs_up in ["02 64 00 D2", "01 03 01 9B"] {
        let came = pressed(&bench, &[1, 2], &[hangs_up], Interrupt::raise);
        for ended in &came.ended {
            assert!(ended.result.is_ok() && ended.stop.is_none(), "{hangs_up} {:?}", ended.stop);
        }
        let coasts = came.sent.iter().filter(|hex| hex.contains(" 06 01 9A 00 00")).count();
        assert_eq!(coasts, 0, "{hangs_up} {:?}", came.sent);
    }
}
