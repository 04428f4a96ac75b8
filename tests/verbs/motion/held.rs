//! How a run ends: its cause, what it keeps, what it gives back, and what is said of it.

use super::rig::{Came, DISABLE, QUICK_STOP, READY, RUNNING, drive, held, held_of, run_at_20_hz, servo};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::failure::Failure;
use antrieb::profile::Registry;
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
        assert!(
            failure.hint.as_ref().is_some_and(|hint| hint.both().iter().all(|hint| hint.contains("STOA"))),
            "{later}: {failure:?}"
        );
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

const COAST: &str = "01 06 01 9A 00 00";

/// How often a telegram went out.
fn times(sent: &[String], begin: &str) -> usize {
    sent.iter().filter(|hex| hex.starts_with(begin)).count()
}

#[test]
fn an_interrupt_of_the_strongest_stop_leaves_it_at_work_for_seconds_and_no_longer() {
    // The drive is gone as soon as it runs: nothing proves any stop.
    let dies = "[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"600s\"";
    for (presses, words) in [(&[COAST][..], [0, 0]), (&[QUICK_STOP, COAST], [0, 1])] {
        let choice = if presses.len() == 1 { StopChoice::Coast } else { StopChoice::QuickStop };
        let came =
            held(&drive(READY, dies), presses, choice, Span::ZERO, async |motor| run_at_20_hz(motor, None).await);
        assert!(!came.stop().acknowledged, "{:?}", came.ended);
        let sent = [DISABLE, QUICK_STOP].map(|word| times(&came.sent, word));
        assert_eq!(sent, words, "{presses:?}: {:?}", came.sent);
        assert!(times(&came.sent, COAST) > 0, "{presses:?}: {:?}", came.sent);
        assert!(came.took < Tick::ZERO + Span::from_secs(16), "{presses:?}: {:?}", came.took);
    }
}

#[test]
fn a_drive_that_answers_again_just_as_it_is_given_up_is_stopped() {
    let gone = |set: &str, choice, ms: u64| {
        let dies = format!("[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"{ms}ms\"");
        let bench = drive(&format!("{READY}{set}"), &dies);
        let came = held(&bench, &[], choice, Span::ZERO, async |motor| run_at_20_hz(motor, None).await);
        assert!(came.ended.result.is_err(), "{ms}");
        came
    };
    for ms in (9_000..14_000).step_by(800) {
        let came = gone("", StopChoice::QuickStop, ms);
        if came.stop().state.is_some() {
            assert_eq!((came.stop().acknowledged, came.energised), (true, 0), "{ms}: {:?}", came.ended);
        }
    }
    for ms in [10_200, 13_400] {
        // It went off by its watchdog meanwhile, and nothing tells whether it stands: what a coast promised is so.
        let came = gone(", \"413\" = 2, \"217\" = 0, \"218\" = 0", StopChoice::Coast, ms);
        assert_eq!((came.stop().acknowledged, came.stop().standing), (true, None), "{ms}: {:?}", came.ended);
    }
    let dead = gone("", StopChoice::QuickStop, 600_000);
    assert!(dead.took < Tick::ZERO + Span::from_secs(25), "{:?}", dead.took);
}

#[test]
fn a_stop_goes_out_whole_however_long_every_answer_is_waited_for() {
    let dies = "[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"600s\"";
    for timeout in ["50ms", "2s", "4s"] {
        let line = format!("-v --timeout {timeout} -b 115200 -a 1 --yes sollwert 20Hz --enable --hold --duration 60s");
        let run = antrieb(&line).on(&drive(READY, dies)).run();
        assert!(times(&run.sent(), DISABLE) > 0, "{timeout}: {}", run.err);
        assert_ne!(run.exit, 0);
    }
}

#[test]
fn control_that_is_taken_away_just_before_the_stop_is_found_and_the_stop_is_the_others() {
    for (mode, choice) in
        [(0, StopChoice::Ramp), (2, StopChoice::Ramp), (0, StopChoice::QuickStop), (2, StopChoice::Coast)]
    {
        let bench = drive(&format!("{READY}, \"412@2\" = {mode}"), "");
        let came = held(&bench, &[], choice, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            run_at_20_hz(motor, Some(Span::from_millis(100))).await?;
            let family = Registry::open(&[]).unwrap().family("acu").unwrap();
            motor.set(family.param(414).unwrap(), 2).await
        });
        let told = format!("P.412 = {mode}, {choice:?}: {:?} {:?}", came.ended, came.notes);
        let named = came.notes.iter().any(|note| note.contains(&format!("P.412 in force is {mode}")));
        assert_eq!((named, came.stop().escalated), (choice != StopChoice::Coast, None), "{told}");
        // Contacts are opened; for whoever else has it there is a setpoint of 0, until P.414 has gone back.
        assert_eq!((came.turning, came.energised, came.stop().acknowledged), (0, 0, mode == 2), "{told}");
        assert!(came.took < Tick::ZERO + Span::from_secs(25), "{told} {:?}", came.took);
    }
}

#[test]
fn a_shaft_that_a_least_frequency_keeps_turning_is_reported_in_time() {
    let lifted = drive("\"410\" = 0, \"412\" = 0, \"434\" = 2, \"484\" = 10, \"418\" = \"3.5\"", "");
    let run = antrieb("-v -b 115200 -a 1 --yes sollwert 20Hz --hold --duration 500ms").on(&lifted).run();
    assert!(run.err.contains("error: THE SHAFT MAY STILL TURN"), "{}", run.err);
    // Once a second, for as long as it may take.
    let zeros = times(&run.sent(), "01 65 01 E4 00 00 00 00");
    assert!(run.exit != 0 && (5..=20).contains(&zeros), "{zeros}: {}", run.err);
}

#[test]
fn whoever_interrupts_again_waits_for_no_coasting_shaft() {
    let ramps = "ramps = { up_right = 999, down_right = 999, up_left = 999, down_left = 999 }";
    let bench = drive(&format!("{READY}, \"419\" = 400, \"549\" = 5, \"30\" = 210, \"424\" = 1, \"425\" = 1"), ramps);
    let came = held(
        &bench,
        &["01 65 01 E4 00 00 9C 3F", QUICK_STOP],
        StopChoice::QuickStop,
        Span::ZERO,
        async |motor: &mut Motor<'_, '_>| {
            let family = Registry::open(&[]).unwrap().family("acu").unwrap();
            let setpoint = family.role("setpoint-frequency").unwrap();
            motor.walk("operation-enabled").await?;
            motor.give(setpoint, 40_000, "Hz").await?;
            motor.until_reached().await?;
            motor.hold(None, async |motor: &mut Motor<'_, '_>, _| motor.refresh(setpoint, 39_999).await).await
        },
    );
    assert_eq!((came.stop().escalated, came.stop().acknowledged), (Some("coast"), true), "{:?}", came.ended);
    assert!(came.took < Tick::ZERO + Span::from_secs(10), "{:?}", came.took);
}

#[test]
fn a_frequency_that_is_reached_already_is_not_waited_for() {
    let took = |speeds: &[i64]| {
        let came = held(&drive(READY, ""), &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            let family = Registry::open(&[]).unwrap().family("acu").unwrap();
            let setpoint = family.role("setpoint-frequency").unwrap();
            motor.walk("operation-enabled").await?;
            for &raw in speeds {
                motor.give(setpoint, raw, "Hz").await?;
                motor.until_reached().await?;
            }
            Ok(())
        });
        assert!(came.ended.result.is_ok(), "{:?}", came.ended);
        came.took.since(Tick::ZERO).as_millis()
    };
    let (once, twice) = (took(&[2_000]), took(&[2_000, 2_000]));
    assert!(twice - once < 500);
}

#[test]
fn contacts_are_opened_all_in_the_end_where_nobody_answers_and_one_by_one_as_long_as_somebody_may() {
    const WORD: &str = "01 06 01 9A 00 0";
    let contacts = |rest: &str| drive("\"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0", rest);
    let words = |rest: &str| {
        let line = "-v -b 115200 --timeout 50ms -a 1 --yes statemachine contacts S1IND S2IND --hold --duration 5s --wait 500ms";
        let run = antrieb(line).on(&contacts(rest)).run();
        run.sent().into_iter().filter_map(|hex| hex.strip_prefix(WORD)?.chars().next()).collect::<String>()
    };
    let dead = words("[[drive.event]]\nwhen = \"above 5Hz\"\nsilent = \"600s\"");
    let (ramp, all) = dead.split_once('0').unwrap();
    assert!(ramp.starts_with('3') && ramp.matches('1').count() >= 4 && !all.is_empty(), "{dead}");
}

#[test]
fn a_setpoint_that_stands_already_counts_once_it_has_stood_and_a_new_one_as_soon_as_it_is_reached() {
    let took = |speeds: &[i64]| {
        let work = async |motor: &mut Motor<'_, '_>| {
            let registry = Registry::open(&[]).unwrap();
            let family = registry.family("lxm05").unwrap();
            let mode = family.mode("velocity").unwrap().clone();
            let param = family.param_or_unknown(mode.setpoint);
            motor.prepare(&mode);
            motor.walk("operation-enabled").await?;
            motor.enter().await?;
            motor.make_it_count().await?;
            for &rpm in speeds {
                motor.give(&param, rpm, "rpm").await?;
                motor.until_reached().await?;
            }
            Ok(())
        };
        let came =
            held_of("lxm05", &servo("RAMPacc = 3000, RAMPdecel = 3000", ""), &[], StopChoice::Coast, Span::ZERO, work);
        assert!(came.ended.result.is_ok(), "{speeds:?}: {:?}", came.ended);
        came.took.since(Tick::ZERO).as_millis()
    };
    let (once, twice, another) = (took(&[300]), took(&[300, 300]), took(&[300, 600]));
    assert!((950..1_500).contains(&(twice - once)), "the bit that stands may be that of the setpoint before");
    assert!(another - once < 800, "{another} {once}");
}
