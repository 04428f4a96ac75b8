//! How a run ends: its cause, what it keeps, what it gives back, and what is said of it.

use super::stopping::{Came, DISABLE, QUICK_STOP, READY, RUNNING, drive, held, held_of, run_at_20_hz, servo};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::failure::Failure;
use antrieb::tick::{Span, Tick};
use serde_json::json;

const ONE: Span = Span::from_secs(1);

/// Holds a drive that runs already, with nothing given by us.
async fn hold_only(motor: &mut Motor<'_, '_>) -> Result<(), Failure> {
    motor.hold(Some(ONE), async |_: &mut Motor<'_, '_>, _| Ok(())).await
}

fn held_only(rest: &str) -> Came {
    held(&drive(RUNNING, rest), &[], StopChoice::Ramp, Span::ZERO, hold_only)
}

#[test]
fn the_cause_of_the_end_is_told() {
    let trips = "[[drive.event]]\nwhen = \"above 19Hz\"\nfault = \"F0500\"";
    for (rest, because) in [("", "end"), (trips, "error")] {
        let bench = drive(READY, rest);
        let came =
            held(&bench, &[], StopChoice::QuickStop, Span::ZERO, async |motor| run_at_20_hz(motor, Some(ONE)).await);
        assert_eq!(came.stop().because, because, "{:?}", came.ended);
    }
}

#[test]
fn a_drive_that_runs_already_is_held_and_stopped_by_the_control_word() {
    let came = held_only("");
    assert!(came.ended.result.is_ok() && came.stop().acknowledged, "{:?}", came.ended);
    assert!(came.sent.iter().any(|hex| hex.starts_with(DISABLE)), "{:?}", came.sent);
    assert_eq!((came.turning, came.energised), (0, 0));
}

#[test]
fn an_enable_that_is_lost_between_two_looks_ends_the_run_and_names_what_is_missing() {
    // Telegrams of the look before the run.
    let before = held(&drive(RUNNING, ""), &[], StopChoice::Keep, Span::ZERO, async |_| Ok(())).sent.len();
    for later in 0..3 {
        let lost = format!("[[drive.event]]\nafter_telegrams = {}\nenable = false", before + later);
        let came = held_only(&lost);
        let failure = came.ended.result.as_ref().err().unwrap_or_else(|| panic!("{later}: {:?}", came.ended));
        assert_eq!(failure.code, "forbidden.left_run", "{later}");
        assert!(failure.hint.as_ref().is_some_and(|hint| hint.contains("STOA")), "{later}: {failure:?}");
        assert_eq!(came.energised, 0, "{later}");
    }
}

#[test]
fn a_state_below_operation_is_held_too() {
    let line = "-b 115200 -a 1 --yes statemachine goto switched-on --hold --duration 300ms --on-exit coast";
    let run = antrieb(line).on(&drive(READY, "")).json().exits(0);
    assert_eq!((run.data("/stop/acknowledged"), run.data("/running")), (&json!(true), &json!(false)));
    assert_eq!(run.data("/to/slug"), "switch-on-disabled");
}

#[test]
fn a_drive_that_is_to_keep_running_keeps_what_was_changed_for_it() {
    let line =
        "-v -b 115200 -a 1 --yes sollwert 10Hz --enable --until reached --watchdog 2s --hold --duration 50ms --on-exit";
    let kept = antrieb(&format!("{line} keep")).on(&drive(READY, "")).json().exits(0);
    assert_eq!((kept.data("/running"), kept.data("/changed/0/restored")), (&json!(true), &json!(false)));
    assert_eq!(kept.data("/stop/acknowledged"), &json!(false));
    assert!(!kept.err.contains(QUICK_STOP) && !kept.err.contains(DISABLE), "{}", kept.err);
    let stopped = antrieb(&format!("{line} ramp")).on(&drive(READY, "")).json().exits(0);
    assert_eq!((stopped.data("/running"), stopped.data("/changed/0/restored")), (&json!(false), &json!(true)));
    let actual = stopped.data("/setpoint/actual").as_f64().unwrap();
    assert_eq!((stopped.data("/setpoint/reached"), (9.0..=10.0).contains(&actual)), (&json!(true), true), "{actual}");
}

#[test]
fn what_was_changed_is_not_given_back_over_a_dead_line() {
    let dies = "[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"600s\"";
    let came = held(&drive(READY, dies), &[], StopChoice::QuickStop, Span::ZERO, async |motor| {
        motor.change("watchdog", 4).await?;
        run_at_20_hz(motor, None).await
    });
    assert!(!came.stop().acknowledged, "{:?}", came.ended);
    // P.413 is written once, for the run.
    let written: Vec<_> = came.sent.iter().filter(|hex| hex.starts_with("01 06") && hex.contains(" 9D 00 ")).collect();
    assert!(written.iter().all(|hex| hex.contains(" 00 04 ")), "{written:?}");
}

#[test]
fn a_run_is_held_as_often_as_its_watchdog_needs_and_no_longer_than_it_was_to_be() {
    // 250 ms without one; a quarter of 200 ms beside its telegrams; and the last round ends with the duration.
    let rounds = |watchdog: i64, duration: u64| {
        let mut rounds = Vec::new();
        let bench = servo("RAMPacc = 3000, RAMPdecel = 3000", "");
        let came = held_of("lxm05", &bench, &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            if watchdog > 0 {
                motor.change("watchdog", watchdog).await?;
            }
            motor.walk("operation-enabled").await?;
            let each = async |_: &mut Motor<'_, '_>, gone: Span| {
                rounds.push(gone);
                Ok(())
            };
            motor.hold(Some(Span::from_millis(duration)), each).await
        });
        assert!(came.ended.result.is_ok() && came.stop().acknowledged, "{:?}", came.ended);
        (rounds, came.took)
    };
    let (slow, at_2_s) = rounds(0, 2_000);
    assert!((7..=8).contains(&slow.len()), "{slow:?}");
    let (fast, _) = rounds(200, 2_000);
    assert!((22..=40).contains(&fast.len()), "{fast:?}");
    let (_, at_2_1_s) = rounds(0, 2_100);
    let more = at_2_1_s.since(Tick::ZERO).as_millis() - at_2_s.since(Tick::ZERO).as_millis();
    assert!((60..=140).contains(&more), "{more} ms more for 100 ms more");
}

/// A drive whose watchdog is set, held by its control word alone.
fn fed_by_its_word(rest: &str) -> Came {
    held(&drive(READY, rest), &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.change("watchdog", 1).await?;
        motor.walk("operation-enabled").await?;
        motor.hold(Some(Span::from_millis(1_900)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    })
}

#[test]
fn an_enable_feeds_the_watchdog_of_a_drive_that_shows_it_and_starts_none_that_does_not() {
    const ENABLE: &str = "01 06 01 9A 00 0F";
    let enables = |sent: &[String]| sent.iter().filter(|hex| hex.starts_with(ENABLE)).count();
    let whole = fed_by_its_word("");
    assert!(whole.ended.result.is_ok(), "{:?}", whole.ended);
    // Once to enable it, then within every third of a second or so.
    assert!((4..=7).contains(&enables(&whole.sent)), "{:?}", whole.sent);
    let first = whole.sent.iter().position(|hex| hex.starts_with(ENABLE)).unwrap();
    for telegrams in first + 2..first + 14 {
        let lost = format!("[[drive.event]]\nafter_telegrams = {telegrams}\nenable = false");
        let came = fed_by_its_word(&lost);
        // The look before may have shown it.
        let later = came.sent.get(telegrams + 1..).unwrap_or_default();
        assert_eq!(enables(later), 0, "lost after {telegrams}: {later:?}");
    }
}
