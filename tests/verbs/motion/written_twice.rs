//! What a run writes more than once, or as 0, and what becomes of that at its end.

use super::rig::{READY, drive, held, run_at_20_hz, servo};
use super::runs::with_motor;
use antrieb::drive::motion::{Keeps, Motor, StopChoice};
use antrieb::outcome::Change;
use antrieb::profile::Registry;
use antrieb::tick::Span;
use std::cell::RefCell;

/// Whoever comes when this program is gone knows what stands there now; what says nothing new is not kept again.
#[test]
fn a_setting_that_a_run_changes_again_is_kept_as_it_is_then() {
    let bench = servo("RAMPacc = 3000", "");
    with_motor(
        "lxm05",
        &bench,
        async |session, target, permit| {
            let ramp = target.family.param(1_556).unwrap().clone();
            let kept = RefCell::new(Vec::new());
            let keep = |change: &Change| {
                kept.borrow_mut().push((change.old, change.new));
                Ok(())
            };
            let mut motor = Motor::new(session, target, permit, None);
            motor.keeps = Some(Keeps(&keep));
            let ended = motor
                .run(true, StopChoice::Coast, async |motor: &mut Motor<'_, '_>| {
                    for raw in [2_000, 2_500, 2_500, 3_000] {
                        motor.set(&ramp, raw).await?;
                    }
                    Ok(())
                })
                .await;
            assert!(ended.result.is_ok(), "{ended:?}");
            assert_eq!(*kept.borrow(), [(3_000, 2_000), (3_000, 2_500)]);
            let told: Vec<_> = motor.changes.iter().map(|change| (change.old, change.new, change.restored)).collect();
            assert_eq!(told, [(3_000, 2_500, true)]);
        },
        |_| {},
    );
}

/// Only what stood there from before and was taken away stays 0.
#[test]
fn a_setting_that_a_run_sets_to_0_is_given_back() {
    let hold = Registry::open(&[]).unwrap().family("acu").unwrap().param(638).unwrap().clone();
    let bench = drive(&format!("{READY}, \"638\" = 2"), "");
    let came = held(&bench, &[], StopChoice::Coast, Span::ZERO, async |motor| motor.set(&hold, 0).await);
    let written: Vec<_> = came.sent.iter().filter(|hex| hex[3..].starts_with("06") && hex.contains("7E")).collect();
    assert!(came.ended.result.is_ok() && written.len() == 2, "{:?} {:?}", came.ended, came.sent);
}

/// A setpoint that went back to 0 does not stand in the drive any more; one whose zero is refused may.
#[test]
fn a_setpoint_that_may_still_stand_in_the_drive_is_told_and_no_other() {
    let second = Some(Span::from_secs(1));
    for (rest, stands) in [("", false), ("[[drive.event]]\nwhen = \"above 19Hz\"\nrefuses = 484", true)] {
        let bench = drive(READY, rest);
        let came =
            held(&bench, &[], StopChoice::QuickStop, Span::ZERO, async |motor| run_at_20_hz(motor, second).await);
        let told = came.notes.iter().any(|note| note.contains("may still stand in the drive"));
        assert_eq!(told, stands, "{:?} {:?}", came.notes, came.ended);
    }
}

/// It is there again, and ignores its stop: it keeps the settings that it runs with.
#[test]
fn a_drive_that_comes_back_and_ignores_its_stop_gets_no_settings_back() {
    let dies = "ramps = { up_right = 50, down_right = 20 }\n[[drive.event]]\nwhen = \"above 19Hz\"\nignores = 410\n\
                [[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"20s\"";
    with_motor(
        "acu",
        &drive(READY, dies).replace("115200", "19200"),
        async |session, target, permit| {
            let source = target.family.param(434).unwrap().clone();
            let mut motor = Motor::new(session, target, permit, None);
            let ended = motor
                .run(true, StopChoice::QuickStop, async |motor: &mut Motor<'_, '_>| {
                    motor.change_param(&source, 3).await?;
                    run_at_20_hz(motor, None).await
                })
                .await;
            let given_up = ended.stop.unwrap();
            assert!(!given_up.acknowledged && motor.unheard, "{given_up:?}");
            let stop = motor.stop_after_all(&given_up).await;
            assert!(!stop.acknowledged, "{stop:?}");
            assert!(motor.changes.iter().all(|change| !change.restored), "{:?}", motor.changes);
        },
        |bench| assert_eq!(bench.totals().energised, 1),
    );
}
