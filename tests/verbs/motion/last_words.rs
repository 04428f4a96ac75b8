//! What is said of a run when it is over, and how often something is tried before that.

use super::rig::{READY, drive, held};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::tick::Span;
use serde_json::json;

/// It is seen to turn when nobody waits any longer, and stands when the program leaves: both are told.
#[test]
fn a_shaft_that_comes_to_rest_behind_its_stop_is_said_to_stand() {
    // An encoder shows it, and this bench loses 10 Hz a second: it is watched for 30 s.
    let ramps = "ramps = { up_right = 999, down_right = 999, up_left = 999, down_left = 999 }";
    let bench = drive(&format!("{READY}, \"419\" = 400, \"549\" = 5, \"30\" = 210"), ramps);
    let mut seen = Vec::new();
    for tenths in 2_995..3_015 {
        let hertz = format!("{}.{}", tenths / 10, tenths % 10);
        let line = format!("-b 115200 -a 1 --yes sollwert {hertz}Hz --enable --hold --duration 50ms --on-exit coast");
        let run = antrieb(&format!("{line} --until reached")).on(&bench).json();
        seen.push((run.data("/stop/standing").as_bool(), run.data("/standing").as_bool()));
    }
    assert!(seen.contains(&(Some(false), Some(true))), "{seen:?}");
    assert!(!seen.contains(&(Some(true), Some(false))), "{seen:?}");
}

/// A drive that never had power: what a ramp owes is told, of a coast and behind an error nothing is.
#[test]
fn that_nothing_shows_a_shaft_is_said_where_a_standstill_was_owed() {
    let blind = drive(&format!("{READY}, \"217\" = 0, \"218\" = 0"), "");
    let fails = || antrieb::failure::Failure::new(antrieb::failure::Class::No, "no", antrieb::text::Text::name("no"));
    for (choice, error, told) in [
        (StopChoice::Ramp, false, true),
        (StopChoice::QuickStop, false, true),
        (StopChoice::Coast, false, false),
        (StopChoice::Ramp, true, false),
    ] {
        let came = held(
            &blind,
            &[],
            choice,
            Span::ZERO,
            async |_: &mut Motor<'_, '_>| {
                if error { Err(fails()) } else { Ok(()) }
            },
        );
        let note = came.stop().note.as_ref().map(|note| note.en.to_string()).unwrap_or_default();
        assert_eq!(note.contains("no power at any look"), told, "{choice:?} {error}: {note}");
    }
}

/// A band of a 500th, where that is more than the least one.
#[test]
fn a_ramp_is_through_within_a_500th_of_its_goal() {
    let setpoint = Registry::open(&[]).unwrap().family("acu").unwrap().role("setpoint-frequency").unwrap().clone();
    let ramps = "ramps = { up_right = 999, down_right = 999, up_left = 999, down_left = 999 }";
    let bench = drive(&format!("{READY}, \"419\" = 400, \"549\" = 5, \"30\" = 210"), ramps);
    for (goal, reached) in [(30_260, true), (30_261, false)] {
        let came = held(&bench, &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.walk("operation-enabled").await?;
            motor.expects = Some((30_200, goal));
            motor.give(&setpoint, 30_200, "Hz").await?;
            motor.until_reached().await
        });
        assert_eq!(came.ended.result.is_ok(), reached, "{goal}: {:?}", came.ended.result);
    }
}

/// Others have it, and their least frequency keeps it turning: it is asked once, and told.
#[test]
fn a_stop_of_a_drive_that_others_have_taken_is_tried_once() {
    let bench = drive(
        "\"412\" = 1, \"434\" = 2, \"418\" = 10, \"412@2\" = 0",
        "readings = { other_modes = \"contacts\" }\nramps = { up_right = 50, down_right = 20 }",
    );
    let family = Registry::open(&[]).unwrap().family("acu").unwrap();
    let (setpoint, set) = (family.role("setpoint-frequency").unwrap(), family.param(414).unwrap());
    let mut rounds = 0;
    let came = held(&bench, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.walk("operation-enabled").await?;
        motor.give(setpoint, 2_000, "Hz").await?;
        let each = async |motor: &mut Motor<'_, '_>, _| {
            rounds += 1;
            if rounds == 2 { motor.set(set, 2).await } else { motor.refresh(setpoint, 2_000).await }
        };
        motor.hold(Some(Span::from_secs(10)), each).await
    });
    let words = came.sent.iter().filter(|hex| hex.starts_with("01 06 01 9A 00 00")).count();
    assert!(!came.stop().acknowledged, "{:?}", came.ended);
    assert_eq!(words, 1, "{:?}", came.sent);
}

/// Contacts keep it enabled, at our setpoint of 0: that is the stop of such a run.
#[test]
fn a_setpoint_of_0_at_which_the_shaft_stands_is_an_acknowledged_stop() {
    let bench = drive(
        "\"412\" = 0, \"434\" = 2, \"418\" = 0",
        "readings = { other_modes = \"contacts\" }\nramps = { up_right = 50, down_right = 20 }",
    );
    let run = antrieb("-b 115200 -a 1 --yes sollwert 20Hz --hold --duration 1s").on(&bench).json();
    assert_eq!(
        (run.data("/stop/acknowledged"), run.data("/stop/standing")),
        (&json!(true), &json!(true)),
        "{:#}",
        run.value
    );
}

/// Without power already, seconds before it stands.
#[test]
fn an_interrupt_of_the_stop_of_a_coasting_shaft_names_no_other_stop() {
    let ramps = "ramps = { up_right = 999, down_right = 999, up_left = 999, down_left = 999 }";
    let bench = drive(
        &format!(
            "{READY}, \"419\" = 400, \"549\" = 5, \"30\" = 210, \"637\" = 60, \"638\" = 0, \"424\" = 100, \"425\" = 100"
        ),
        ramps,
    );
    let setpoint = Registry::open(&[]).unwrap().family("acu").unwrap().role("setpoint-frequency").unwrap().clone();
    let work = async |motor: &mut Motor<'_, '_>| {
        motor.walk("operation-enabled").await?;
        motor.give(&setpoint, 40_000, "Hz").await?;
        motor.until_reached().await?;
        motor.hold(Some(Span::from_millis(50)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    };
    for choice in [StopChoice::Ramp, StopChoice::QuickStop] {
        let clean = held(&bench, &[], choice, Span::ZERO, work);
        // Many looks at the encoder: the last of them are without power, and some seconds before it stands.
        let looks = clean.sent.iter().filter(|hex| hex.starts_with("01 64 00 D9")).count();
        let passes = vec!["-01 64 00 D9"; looks / 2];
        let presses: Vec<&str> = passes.into_iter().chain(["01 64 00 D9"]).collect();
        let came = held(&bench, &presses, choice, Span::ZERO, work);
        let told = format!("{choice:?} {looks}: {:?} {:?} {:?}", came.ended, came.notes, clean.took);
        assert!(came.took < clean.took, "{told}");
        assert_eq!((came.stop().acknowledged, came.stop().escalated), (true, None), "{told}");
        assert_eq!((came.stop().standing, came.turning), (Some(false), 1), "{told}");
    }
}

/// It lost its power and came back: the stop that it hears then is not what brought its shaft to rest.
#[test]
fn a_drive_that_restarted_in_the_last_moments_of_its_run_was_not_stopped() {
    for at in [700, 1_400, 1_500] {
        let cycle = format!("[[drive.event]]\nat = \"{at}ms\"\npower_cycle = true\n");
        for (drive, model, value) in [
            ("set = { IOposInterfac = 1 }\nservo = { guide = 163840 }\n", "lxm05", "900rpm"),
            ("set = { IOposInterfac = 1 }\nservo = { guide = 163840 }\n", "lxm05", "3A"),
            ("set = { IOposInterfac = 1 }\nservo = { guide = 163840 }\n", "lxm05", "2/3"),
            ("set = { IOposInterfac = 1 }\nservo = { guide = 163840 }\n", "lxm05", "90000000usr --start absolute"),
            ("set = { \"434\" = 3, \"228\" = 0 }\n", "acu", "10Hz --take-control"),
        ] {
            let drive = format!("[[drive]]\nmodel = \"{model}\"\n{drive}");
            for way in ["ramp", "quick-stop", "coast"] {
                let line = format!(
                    "-a 1 --drive {model} --yes sollwert {value} --enable --hold --duration 1s --on-exit {way}"
                );
                let run = antrieb(&line).on(&format!("{drive}{cycle}")).run();
                assert!([4, 8].contains(&run.exit), "{at} {line}: exit {} {} {}", run.exit, run.out, run.err);
                let calm = antrieb(&line).on(&drive).run();
                assert!(!format!("{}{}", calm.out, calm.err).contains("restart"), "{line}: {}", calm.out);
            }
        }
    }
}

/// The same where it comes back just as the stop goes out, so that this is answered at once.
#[test]
fn a_drive_that_is_back_as_its_run_ends_was_not_stopped() {
    const SERVO: &str = "[[drive]]\nmodel = \"lxm05\"\nset = { IOposInterfac = 1 }\nservo = { guide = 163840 }\n";
    const INVERTER: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"434\" = 3, \"228\" = 0 }\n";
    for (drive, value) in [(SERVO, "900rpm"), (SERVO, "3A"), (INVERTER, "10Hz --take-control")] {
        for way in ["ramp", "quick-stop", "coast"] {
            let line = format!("-v -a 1 --yes sollwert {value} --enable --hold --duration 8s --on-exit {way}");
            let calm = antrieb(&line).on(drive).run();
            let begins = calm.err.split_once("running; Ctrl-C").unwrap().0.lines().rev();
            let begins: u64 =
                begins.filter_map(|line| line.split_once(" ms > ")?.0.trim().parse::<f64>().ok()).next().unwrap()
                    as u64;
            let mut back = 0;
            for off in (2_600..=3_200).step_by(50) {
                let cycle = format!("[[drive.event]]\nat = \"{}ms\"\npower_cycle = true\n", begins + 8_000 - off);
                let run = antrieb(&line).on(&format!("{drive}{cycle}")).run();
                assert!([4, 8].contains(&run.exit), "{off} {line}: exit {} {} {}", run.exit, run.out, run.err);
                back += u32::from(run.out.contains("acknowledged") || run.err.contains("restart"));
            }
            assert!(back > 0, "{line}");
        }
    }
}

/// A silence alone is none of that, but nobody knows what happened in it.
#[test]
fn a_stop_that_was_heard_only_seconds_later_says_so() {
    let drive = "[[drive]]\nmodel = \"lxm05\"\n[[drive.event]]\nat = \"1366ms\"\nsilent = \"3s\"\n";
    for way in ["ramp", "quick-stop", "coast"] {
        let line = format!("-a 1 --drive lxm05 --yes sollwert 900rpm --enable --hold --duration 1s --on-exit {way}");
        let run = antrieb(&line).on(drive).run();
        assert!(run.out.contains("nothing answered the stop for"), "{way}: {} {}", run.out, run.err);
        assert!(!run.err.contains("restart"), "{way}: {} {}", run.out, run.err);
        for silent in ["1ms", "500ms", "700ms"] {
            let calm = antrieb(&line).on(&drive.replace("3s", silent)).run();
            assert!(!calm.out.contains("nothing answered the stop for"), "{way} {silent}: {}", calm.out);
        }
    }
}
