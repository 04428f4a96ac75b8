//! What tells one way to run a drive from another that looks the same on most days.

use super::rig::{DISABLE, READY, drive, held, held_of, run_at_20_hz, servo};
use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::tick::Span;

const ENABLE: &str = "01 06 01 9A 00 0F";
const STATE: &str = "01 03 01 9B";

/// Its watchdog is fed by its enable as long as it shows that; a drive that tripped hears no enable any more.
#[test]
fn a_drive_that_tripped_is_not_fed_with_its_enable() {
    let fed = |rest: &str| {
        held(&drive(READY, rest), &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.change("watchdog", 1).await?;
            motor.walk("operation-enabled").await?;
            motor.hold(Some(Span::from_millis(1_900)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
        })
    };
    let first = fed("").sent.iter().position(|hex| hex.starts_with(ENABLE)).unwrap();
    for telegrams in first + 2..first + 16 {
        let sent = fed(&format!("[[drive.event]]\nafter_telegrams = {telegrams}\nfault = \"F0500\"")).sent;
        let later = sent.get(telegrams + 1..).unwrap_or_default();
        assert!(!later.iter().any(|hex| hex.starts_with(ENABLE)), "{telegrams}: {later:?}");
    }
}

/// A servo whose watchdog only writes feed waits in a state without power: the word that led there goes on feeding it.
#[test]
fn a_word_that_asks_for_no_power_feeds_a_drive_without_power() {
    let bench = servo("", "readings = { node_guard_fed_by = \"writes\" }");
    let came = held_of("lxm05", &bench, &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.change("watchdog", 600).await?;
        motor.walk("ready-to-switch-on").await?;
        motor.hold(Some(Span::from_secs(4)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    });
    assert!(came.ended.result.is_ok(), "{:?} {:?}", came.ended, came.sent);
    let fed = came.sent.iter().filter(|hex| hex.starts_with("01 10 1B 02 00 02 04 00 00 00 06")).count();
    assert!((12..40).contains(&fed), "{fed}");
}

/// While a long ramp lasts its state is looked at every second, and not any more just before its frequency is 0.
#[test]
fn the_state_is_looked_at_while_a_ramp_is_long_and_not_at_its_end() {
    let bench = drive(READY, "ramps = { up_right = 50, down_right = 4 }");
    let second = Some(Span::from_secs(1));
    let came = held(&bench, &[], StopChoice::Ramp, Span::ZERO, async |motor| run_at_20_hz(motor, second).await);
    let stop = came.sent.iter().position(|hex| hex.starts_with(DISABLE)).unwrap();
    let looks = |from_ms: u64, to_ms: u64| {
        let within = |at: &antrieb::tick::Tick| (from_ms..to_ms).contains(&at.since(came.at[stop]).as_millis());
        (stop..came.sent.len()).filter(|&index| came.sent[index].starts_with(STATE) && within(&came.at[index])).count()
    };
    // 20 Hz at 4 Hz a second.
    assert_eq!((looks(500, 2_800) > 0, looks(3_300, 4_900)), (true, 0), "{:?}", came.at[stop]);
}

/// Nobody has seen the shaft yet.
#[test]
fn who_interrupts_the_first_look_at_a_shaft_is_not_told_that_it_turns() {
    let blind = drive(&format!("{READY}, \"217\" = 0, \"218\" = 0"), "");
    // The first question for the frequency behind the stop.
    let sent = held(&blind, &[], StopChoice::Coast, Span::ZERO, async |motor| {
        run_at_20_hz(motor, Some(Span::from_millis(100))).await
    })
    .sent;
    let looks = |until: usize| sent[..until].iter().filter(|hex| hex.starts_with("01 64 00 D2")).count();
    let stop = sent.iter().rposition(|hex| hex.starts_with("01 06 01 9A 00 00")).unwrap();
    let presses: Vec<&str> = vec!["-01 64 00 D2"; looks(stop)].into_iter().chain(["01 64 00 D2"]).collect();
    let came = held(&blind, &presses, StopChoice::Coast, Span::ZERO, async |motor| {
        run_at_20_hz(motor, Some(Span::from_millis(100))).await
    });
    assert_eq!((came.stop().acknowledged, came.stop().standing), (true, None), "{:?}", came.ended);
}

/// The zero of a servo was refused, and the one of an inverter would turn the shaft the other way: one of them went out.
#[test]
fn a_zero_that_was_refused_was_sent() {
    let bench = drive("\"410\" = 15, \"412\" = 1, \"434\" = 3, \"228\" = -40, \"484\" = 50, \"418\" = 0", "");
    let run = antrieb("-v -b 115200 -a 1 --drive lxm05 sollwert 0").on(&bench).run();
    assert!(
        run.err.contains("error: THE SHAFT MAY STILL TURN") && !run.err.contains("nothing was sent"),
        "{}",
        run.err
    );
    assert!(!run.err.contains("> 01 65 01 E4"), "{}", run.err);
}

/// The mode that it turns in is named, and not another one.
#[test]
fn a_shaft_that_somebody_else_turns_is_named_with_its_mode() {
    with_motor(
        "lxm05",
        &servo("RAMPacc = 3000", ""),
        async |session, target, permit| {
            let family = Registry::open(&[]).unwrap().family("lxm05").unwrap();
            let mode = family.mode("velocity").unwrap();
            let mut motor = Motor::new(session, target, permit, None);
            motor.prepare(mode);
            motor.walk("operation-enabled").await.unwrap();
            motor.enter().await.unwrap();
            motor.make_it_count().await.unwrap();
            motor.give(family.param(mode.setpoint).unwrap(), 300, "rpm").await.unwrap();
            motor.until_reached().await.unwrap();
            let jog = family.mode("jog").unwrap();
            let refused =
                antrieb::drive::motion::may_change_mode(session, target, "operation-enabled", jog).await.unwrap_err();
            let (is, wanted) = (mode.text().en.to_string(), jog.text().en.to_string());
            assert!(refused.message.en.contains(&format!("turns in mode '{is}'; '{wanted}'")), "{refused:?}");
        },
        |_| {},
    );
}

/// It is set to brake with direct current; that nothing shows its shaft has another reason.
#[test]
fn a_drive_that_never_had_power_is_not_said_to_have_braked() {
    for (brakes, set) in [(false, super::rig::READY), (true, super::rig::RUNNING)] {
        let bench = drive(&format!("{set}, \"392\" = 1, \"632\" = \"0.2\", \"217\" = 0, \"218\" = 0"), "");
        let run = antrieb("-b 115200 -a 1 --drive acu statemachine disable").on(&bench).run();
        assert_eq!(run.err.contains("P.392 = 1"), brakes, "{}", run.err);
        assert_eq!(run.err.contains("no power at any look"), !brakes, "{}", run.err);
    }
}

/// What is added to it turns the shaft the same way, so that a zero only slows it: that takes two questions.
#[test]
fn a_zero_beside_an_internal_setpoint_of_the_same_sign_goes_out_at_once() {
    for (internal, line) in [(10, 20), (-10, -20), (0, 20), (10, 0)] {
        let set =
            format!("\"410\" = 15, \"412\" = 1, \"434\" = 3, \"228\" = {internal}, \"484\" = {line}, \"418\" = 0");
        let run = antrieb("-v -b 115200 -a 1 --drive acu sollwert 0").on(&drive(&set, "")).run();
        let questions = run.sent().iter().position(|hex| hex.starts_with("01 65 01 E4 00 00 00 00"));
        assert!(questions.is_some_and(|questions| questions <= 3), "{internal} {line}: {}", run.err);
    }
}

/// Contacts take its power on the way to 0. What its frequency shows from then on is the shaft, and it comes to rest.
#[test]
fn a_shaft_that_is_seen_to_coast_to_rest_stands() {
    for loses_ms in [900, 1_200] {
        let bench = drive(
            &format!("{}, \"217\" = 0, \"218\" = 0", super::rig::RUNNING),
            &format!(
                "readings = {{ coast_shows = \"shaft\" }}\nramps = {{ up_right = 50, down_right = 5 }}\n[[drive.event]]\n\
                 at = \"{loses_ms}ms\"\nenable = false"
            ),
        );
        with_motor(
            "acu",
            &bench.replace("baud = 115200\n", ""),
            async |session, target, permit| {
                session.rest(Span::from_millis(600)).await.unwrap();
                let family = target.family.clone();
                let mode = family.modes.first().unwrap();
                let mut motor = Motor::new(session, target, permit, None);
                motor.look().await.unwrap();
                motor.relieve_setpoint(mode, family.role("setpoint-frequency").unwrap()).await.unwrap();
                let reached = motor.setpoint.as_ref().and_then(|setpoint| setpoint.reached);
                assert_eq!(reached, Some(true), "{loses_ms}");
            },
            |bench| assert_eq!((bench.totals().turning, bench.totals().energised), (0, 0), "{loses_ms}"),
        );
    }
}
