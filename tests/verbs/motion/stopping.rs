//! What takes motion away: it asks nobody, it goes out whatever happens, and what is said of it is so.

use super::rig::{
    COAST, DISABLE, QUICK_STOP, READY, REFRESH, RUNNING, alone, drive, held, held_of, run_at_20_hz, servo, servo_at,
};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::tick::{Span, Tick};
use serde_json::json;

#[test]
fn what_can_only_take_motion_away_asks_nobody() {
    for verb in ["statemachine quick-stop", "statemachine disable", "statemachine disable-voltage"] {
        let run = alone(verb, &drive(RUNNING, "")).exits(0);
        assert_eq!(run.data("/running"), &json!(false), "{verb}");
        assert!(!run.err.contains("MOTION"), "{}", run.err);
    }
    for zero in ["0", "0Hz", "-0", "0,00 Hz", "0rpm", "+0.0"] {
        let run = alone(&format!("sollwert '{zero}'"), &drive(RUNNING, "")).exits(0);
        assert_eq!((run.data("/setpoint/value"), run.data("/setpoint/reached")), (&json!(0.0), &json!(true)), "{zero}");
        assert!(!run.err.contains("MOTION"), "{}", run.err);
    }
}

#[test]
fn a_zero_that_does_more_than_stop_asks() {
    // Alone, the internal setpoint would turn the shaft the other way.
    let against = drive("\"410\" = 15, \"412\" = 1, \"434\" = 3, \"484\" = 10, \"228\" = -10, \"418\" = 0", "");
    let with = drive("\"410\" = 15, \"412\" = 1, \"434\" = 3, \"484\" = 10, \"228\" = 0, \"418\" = 0", "");
    alone("sollwert 0Hz", &against).exits(8);
    alone("sollwert 0Hz", &with).exits(0);
    // What is waited for anyway is no reason to ask.
    alone("sollwert 0Hz --until reached", &with).exits(0);
    for more in ["--enable", "--hold --duration 1s", "--watchdog 2s", "--source line"] {
        alone(&format!("sollwert 0Hz {more}"), &drive(RUNNING, "")).exits(8);
    }
    alone("sollwert 0%", &drive(RUNNING, "")).exits(8);
    let servo = "[[drive]]\nmodel = \"lxm05\"\n";
    for verb in ["sollwert 0usr", "sollwert 0A", "sollwert 17 --mode homing"] {
        antrieb(&format!("-a 1 --drive lxm05 {verb}")).on(servo).json().exits(8);
    }
}

#[test]
fn a_zero_that_the_least_frequency_lifts_is_no_standstill() {
    let lifted = drive("\"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 10, \"418\" = \"3.5\"", "");
    let run = alone("sollwert 0", &lifted).exits(1);
    assert_eq!(run.error()["code"], "no.not_standing");
}

#[test]
fn under_virtual_contacts_a_stop_opens_them_all_and_closes_none() {
    // The first word of a quick stop goes out unseen, and leaves S1IND open. Of a ramp S1IND stays closed until the power is
    // gone.
    for (verb, allowed, exit) in [
        ("quick-stop", &["00 02", "00 00"][..], 8),
        ("disable", &["00 01", "00 00"], 0),
        ("disable-voltage", &["00 00"], 0),
    ] {
        for model in ["act", "acu"] {
            let contacts = drive("\"410\" = 3, \"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0, \"638\" = 1", "");
            let run = alone(&format!("statemachine {verb}"), &contacts.replace("acu", model)).exits(exit);
            assert_eq!(run.data("/running"), &json!(false), "{verb}");
            let sent = run.err.lines().filter_map(|line| line.split_once("> 01 06 01 9A ")?.1.get(..5));
            let words: Vec<_> = sent.collect();
            assert!(words.iter().all(|word| allowed.contains(word)) && words.last() == Some(&"00 00"), "{words:?}");
            assert!(words.first() == allowed.first(), "{words:?}");
        }
    }
}

#[test]
fn a_bounded_run_ends_with_its_stop_also_where_nothing_had_to_be_done() {
    for verb in ["statemachine enable", "statemachine goto operation-enabled"] {
        let run = antrieb(&format!("-b 115200 -a 1 --yes {verb} --hold --duration 50ms --on-exit quick-stop"));
        let run = run.on(&drive(RUNNING, "")).json().exits(0);
        assert_eq!(run.data("/steps").as_array().unwrap().len(), 0, "{verb}");
        assert_eq!((run.data("/stop/acknowledged"), run.data("/running")), (&json!(true), &json!(false)), "{verb}");
        assert_eq!(run.data("/stop/standing"), &json!(true));
    }
}

#[test]
fn a_reset_that_is_not_obeyed_is_refused_before_anything_is_sent() {
    let tripped = drive("\"412\" = 0", "[[drive.event]]\nat = \"1ms\"\nfault = \"F0500\"");
    let run = antrieb("-v -b 115200 -a 1 --yes statemachine reset").on(&tripped).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.control_mode");
    let hint = run.error()["hint"].as_str().unwrap();
    assert!(["P.34", "P.103", "--take-control"].iter().all(|way| hint.contains(way)), "{hint}");
    assert!(!run.err.contains("> 01 06 01 9A"), "{}", run.err);
}

#[test]
fn a_missing_enable_and_a_missing_start_contact_are_told_apart() {
    for (missing, says, silent) in [("enable", "STOA", "start contact"), ("start_right", "start contact", "STOA")] {
        let bench = drive("\"412\" = 1", "").replace("model", &format!("{missing} = false\nmodel"));
        let run = antrieb("-b 115200 -a 1 --yes statemachine enable").on(&bench).json().exits(8);
        let message = run.error()["message"].as_str().unwrap();
        assert!(message.contains(says) && !message.contains(silent), "{missing}: {message}");
    }
}

#[test]
fn the_watchdog_that_is_reported_is_the_one_in_force() {
    let bench = drive("\"412\" = 1, \"434\" = 2, \"413\" = 7", "");
    let kept = antrieb("-b 115200 -a 1 --yes sollwert 5Hz --watchdog 2s").on(&bench).json().exits(0);
    assert_eq!(kept.data("/watchdog_s"), &json!(2));
    let held = antrieb("-b 115200 -a 1 --yes sollwert 5Hz --watchdog 2s --hold --duration 10ms --on-exit coast");
    assert_eq!(held.on(&bench).json().exits(0).data("/watchdog_s"), &json!(7));
}

#[test]
fn whoever_interrupts_again_gets_a_stronger_stop() {
    let bench = drive(READY, "ramps = { up_right = 50, down_right = 1, up_left = 50, down_left = 1 }");
    let bench = bench.replace("\"418\" = 0", "\"418\" = 0, \"424\" = 1, \"425\" = 1");
    for (presses, way, escalated) in [
        (&[REFRESH][..], "ramp", None),
        (&[REFRESH, DISABLE], "ramp", Some("quick-stop")),
        (&[REFRESH, DISABLE, QUICK_STOP], "ramp", Some("coast")),
    ] {
        let came =
            held(&bench, presses, StopChoice::Ramp, Span::from_secs(30), async |motor| run_at_20_hz(motor, None).await);
        let stop = came.stop();
        assert_eq!((stop.choice, stop.escalated, stop.because), (way, escalated, "interrupted"));
        assert!(stop.acknowledged, "{stop:?}");
        assert_eq!((came.turning, came.energised), (0, 0));
        assert_eq!(came.sent.iter().any(|hex| hex.starts_with(COAST)), escalated == Some("coast"));
        let said = escalated.is_none_or(|way| came.notes.iter().any(|note| note.contains(way)));
        assert!(said, "{:?}", came.notes);
    }
}

/// The stop is under way: who interrupts for the first time has it, and who insists a stronger one.
#[test]
fn whoever_interrupts_the_own_end_of_a_run_has_its_stop() {
    let bench = drive(READY, "ramps = { up_right = 50, down_right = 1, up_left = 50, down_left = 1 }");
    let bench = bench.replace("\"418\" = 0", "\"418\" = 0, \"424\" = 1, \"425\" = 1");
    for (presses, escalated, because) in [
        (&[][..], None, "end"),
        (&[DISABLE][..], None, "interrupted"),
        (&[DISABLE, DISABLE], Some("quick-stop"), "interrupted"),
        (&[DISABLE, DISABLE, QUICK_STOP], Some("coast"), "interrupted"),
    ] {
        let brief = Some(Span::from_millis(200));
        let came = held(&bench, presses, StopChoice::Ramp, Span::from_secs(30), async |motor| {
            run_at_20_hz(motor, brief).await
        });
        let stop = came.stop();
        assert_eq!((stop.choice, stop.escalated, stop.because), ("ramp", escalated, because), "{presses:?}");
        assert!(stop.acknowledged && came.ended.result.is_ok(), "{presses:?}: {stop:?}");
        assert_eq!((came.turning, came.energised), (0, 0), "{presses:?}");
    }
}

#[test]
fn an_enable_that_is_lost_at_any_step_ends_the_run_and_does_not_start_it_again() {
    for writes in 1..9 {
        let lost = format!(
            "[[drive.event]]\nafter_writes = {writes}\nenable = false\n[[drive.event]]\nat = \"9s\"\nenable = true"
        );
        let came = held(&drive(READY, &lost), &[], StopChoice::QuickStop, Span::from_secs(60), async |motor| {
            run_at_20_hz(motor, Some(Span::from_secs(5))).await
        });
        assert!(came.ended.result.is_err(), "{writes}");
        assert_eq!((came.turning, came.energised), (0, 0), "write {writes}: {:?}", came.ended);
    }
}

#[test]
fn a_held_run_outlives_what_is_lost_late_or_garbled() {
    for watchdog in [0, 2] {
        for kind in ["lost", "garbled", "noise", "late"] {
            let (every, by) = if kind == "late" { (8, "by = \"700ms\"") } else { (7, "") };
            // On such a line it takes a long holding time for a standstill to be seen under power.
            let bench = drive(&format!("{READY}, \"413\" = {watchdog}, \"638\" = 4"), "");
            let bench = format!("{bench}[[disturb]]\nevery = {every}\nkind = \"{kind}\"\n{by}\n");
            let came = held(&bench, &[], StopChoice::QuickStop, Span::ZERO, async |motor| {
                run_at_20_hz(motor, Some(Span::from_secs(20))).await
            });
            // A watchdog of 2 s leaves little to replies that are late again and again: it may have to stop, and then it does.
            let is_stopped =
                came.ended.stop.as_ref().is_some_and(|stop| stop.acknowledged && stop.standing == Some(true));
            let may_end = (kind, watchdog) == ("late", 2) && is_stopped;
            assert!(came.ended.result.is_ok() || may_end, "{kind}, watchdog {watchdog}: {:?}", came.ended);
            // Looks that come late may miss the short time in which the standstill shows under power: then that is said.
            let says = came.stop().note.as_ref().is_some_and(|note| note.en.starts_with("without power"));
            let proven = came.stop().acknowledged || (kind == "late" && says);
            assert!(proven, "{kind}, watchdog {watchdog}: {:?}", came.ended);
            assert_eq!((came.turning, came.energised), (0, 0));
        }
    }
}

#[test]
fn a_held_run_on_a_dead_line_stops_within_the_margin_of_the_watchdog() {
    let dies = "[[drive.event]]\nwhen = \"above 19Hz\"\nsilent = \"600s\"";
    let bench = drive(&format!("{READY}, \"413\" = 4"), dies);
    let came = held(&bench, &[], StopChoice::QuickStop, Span::ZERO, async |motor| run_at_20_hz(motor, None).await);
    assert!(!came.stop().acknowledged);
    assert!(came.sent.iter().any(|hex| hex.starts_with(QUICK_STOP)), "the stop went out");
}

#[test]
fn a_fault_at_any_step_is_named_and_never_a_success() {
    for writes in 1..7 {
        let trips = format!("[[drive.event]]\nafter_writes = {writes}\nfault = \"F0500\"");
        let run = antrieb("-b 115200 -a 1 --yes sollwert 5Hz --enable --hold --duration 10ms --on-exit quick-stop");
        let run = run.on(&drive(READY, &trips)).json();
        if run.exit == 0 {
            // So many writes there were not.
            assert_ne!(run.data("/to/slug"), "fault", "write {writes}");
            continue;
        }
        assert!(run.error()["message"].as_str().unwrap().contains("F0500"), "write {writes}: {}", run.error());
    }
    for at in (0..600).step_by(40) {
        let trips = format!("[[drive.event]]\nat = \"{at}ms\"\nfault = \"F0500\"");
        let run =
            antrieb("-b 115200 -a 1 --yes statemachine enable --hold --duration 10ms").on(&drive(READY, &trips)).json();
        let Some(state) = run.value.pointer("/data/to/slug") else {
            // It stood before anything was asked.
            assert_eq!(run.error()["code"], "forbidden.fault", "{at} ms: {:#}", run.value);
            continue;
        };
        assert_eq!(run.exit == 0, state != "fault", "{at} ms: {:#}", run.value);
    }
}

#[test]
fn a_shaft_that_may_still_turn_is_the_first_thing_that_is_said() {
    let dies = "[[drive.event]]\nwhen = \"running\"\nsilent = \"600s\"";
    let line = "-b 115200 --timeout 50ms -a 1 --yes sollwert 5Hz --enable --hold --duration 9s --wait 100ms";
    let run = antrieb(line).on(&drive(READY, dies)).run();
    assert!(run.err.contains("error: THE SHAFT MAY STILL TURN"), "{}", run.err);
    assert!(run.err.contains("hint: what stops it now: external enable STOA"), "{}", run.err);
    assert!(run.err.contains("NOT acknowledged"), "{}", run.err);
    let kept = antrieb(&format!("{line} --on-exit keep --lang de")).on(&drive(READY, dies)).run();
    assert!(!kept.err.contains("NICHT bestätigt") && kept.err.contains("keep"), "{}", kept.err);
    assert!(kept.out.contains("keep (Fehler), kein Halt") && !kept.out.contains("bestätigt"), "{}", kept.out);
    assert_ne!((run.exit, kept.exit), (0, 0));
}

#[test]
fn a_drive_that_comes_back_while_it_is_stopped_is_stopped() {
    for choice in [StopChoice::Ramp, StopChoice::QuickStop, StopChoice::Coast] {
        for silent in [1, 4, 7, 9, 200] {
            let dies = |when: &str| format!("[[drive.event]]\nwhen = \"{when}\"\nsilent = \"{silent}s\"");
            let bench = drive(READY, &dies("above 19Hz"));
            let came = held(&bench, &[], choice, Span::ZERO, async |motor| {
                run_at_20_hz(motor, Some(Span::from_secs(20))).await
            });
            let servo = servo("RAMPacc = 2000, RAMPdecel = 2000", &dies("above 4Hz"));
            let work = async |motor: &mut Motor<'_, '_>| servo_at(motor, 300, Some(Span::from_secs(20))).await;
            let axis = held_of("lxm05", &servo, &[], choice, Span::ZERO, work);
            for (came, least) in [(came, 3), (axis, 3)] {
                let back = silent < 200;
                let told = format!("{silent} s, {choice:?}: {:?}", came.ended);
                assert!(came.ended.result.is_err() || silent < least, "{told}");
                if came.ended.result.is_err() {
                    assert_eq!((came.stop().acknowledged, came.energised), (back, u64::from(!back)), "{told}");
                }
                assert!(came.took < Tick::ZERO + Span::from_secs(60), "{told}");
            }
        }
    }
}

#[test]
fn a_position_that_wavers_neither_holds_up_a_stop_nor_hides_a_turning_shaft() {
    for waver in [1, 3, 10, 40, 300, 20_000] {
        for choice in [StopChoice::Ramp, StopChoice::QuickStop, StopChoice::Coast] {
            let bench = servo("RAMPacc = 2000, RAMPdecel = 2000", &format!("servo = {{ waver = {waver} }}"));
            let work = async |motor: &mut Motor<'_, '_>| {
                let _reached_or_not = servo_at(motor, 300, Some(Span::from_millis(200))).await;
                Ok(())
            };
            let came = held_of("lxm05", &bench, &[], choice, Span::ZERO, work);
            let told = format!("{waver}, {choice:?}, {:?}: {:?} {:?}", came.took, came.ended, came.notes);
            assert_eq!((came.turning, came.energised), (0, 0), "{told}");
            assert!(came.took < Tick::ZERO + Span::from_secs(40), "{told}");
            if waver <= 40 {
                assert!(came.stop().acknowledged && came.stop().escalated.is_none(), "{told}");
            } else if !came.stop().acknowledged {
                assert_eq!(came.stop().standing, Some(false), "{told}");
            }
        }
    }
}

#[test]
fn a_ramp_that_lasts_long_is_waited_for() {
    let bench = servo("RAMPacc = 6000, RAMPdecel = 30", "");
    let work = async |motor: &mut Motor<'_, '_>| servo_at(motor, 3_000, Some(Span::from_secs(1))).await;
    let came = held_of("lxm05", &bench, &[], StopChoice::Ramp, Span::ZERO, work);
    let stop = came.stop();
    assert_eq!((stop.acknowledged, stop.standing, stop.escalated), (true, Some(true), None), "{:?}", came.ended);
    assert_eq!((came.turning, came.energised), (0, 0));
    assert!(came.took > Tick::ZERO + Span::from_secs(99), "{:?}", came.took);
}

#[test]
fn a_watchdog_that_only_writes_feed_is_fed_in_every_wait_and_hold() {
    let fed = "servo = { limn = -8192 }\nreadings = { node_guard_fed_by = \"writes\" }";
    for (slug, raw, set) in [
        ("velocity", 240, "RAMPacc = 60"),
        ("velocity", 240, "RAMPdecel = 60"),
        ("position", 65_536, "PPn_target = 30"),
        ("homing", 17, "HMn = 10"),
        ("gear", 2, "IOposInterfac = 1"),
    ] {
        let work = async |motor: &mut Motor<'_, '_>| {
            let registry = Registry::open(&[]).unwrap();
            let family = registry.family("lxm05").unwrap();
            let mode = family.mode(slug).unwrap().clone();
            let param = family.param_or_unknown(mode.setpoint);
            motor.change("watchdog", 700).await?;
            motor.prepare(&mode);
            motor.walk("operation-enabled").await?;
            motor.enter().await?;
            if let Some(id) = mode.denominator {
                motor.set(&family.param_or_unknown(id), 3).await?;
            }
            motor.make_it_count().await?;
            motor.give(&param, raw, "").await?;
            match mode.starts.first() {
                Some(start) => motor.travel(start).await?,
                None if mode.endless => {}
                None => motor.until_reached().await?,
            }
            motor.hold(Some(Span::from_secs(4)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
        };
        let came = held_of("lxm05", &servo(set, fed), &[], StopChoice::Ramp, Span::ZERO, work);
        assert!(came.ended.result.is_ok(), "{slug}: {:?}", came.ended);
        assert!(came.stop().acknowledged && came.turning == 0, "{slug}: {:?}", came.ended);
    }
}

#[test]
fn control_that_is_taken_away_ends_the_run_at_once() {
    for (mode, choice) in [(0, StopChoice::Ramp), (2, StopChoice::Ramp), (0, StopChoice::QuickStop)] {
        let bench = drive(&format!("{READY}, \"412@2\" = {mode}"), "");
        let work = async |motor: &mut Motor<'_, '_>| {
            let family = Registry::open(&[]).unwrap().family("acu").unwrap();
            let (setpoint, set) = (family.role("setpoint-frequency").unwrap(), family.param(414).unwrap());
            motor.change_param(family.param(434).unwrap(), 3).await?;
            motor.walk("operation-enabled").await?;
            motor.give(setpoint, 2_000, "Hz").await?;
            motor.until_reached().await?;
            let mut rounds = 0;
            motor
                .hold(Some(Span::from_secs(30)), async |motor: &mut Motor<'_, '_>, _| {
                    rounds += 1;
                    // Somebody else chooses another data set.
                    if rounds == 3 {
                        motor.set(set, 2).await?;
                    }
                    motor.refresh(setpoint, 2_000).await
                })
                .await
        };
        let came = held(&bench, &[], choice, Span::ZERO, work);
        let told = format!("P.412 = {mode}: {:?} {:?} {:?}", came.took, came.ended, came.notes);
        let failure = came.ended.result.as_ref().err().unwrap_or_else(|| panic!("{told}"));
        assert_eq!(failure.code, "forbidden.control_taken", "{told}");
        assert!(failure.to_string().contains(&format!(" {mode},")), "{told}");
        assert_eq!(came.stop().escalated, None, "{told}");
        assert!(
            came.sent
                .iter()
                .any(|hex| hex.starts_with("01 65 01 E4 00 00 00 00 00 00") || hex.contains("01 E4 00 00 00 00")),
            "{told}"
        );
        // Whoever has it decides how it is stopped: as contacts, of which those that start open first.
        assert_eq!(came.sent.iter().any(|hex| hex.starts_with("01 06 01 9A 00 09")), mode == 2, "{told}");
        assert!(came.took < Tick::ZERO + Span::from_secs(16), "{told}");
        assert_eq!(came.turning, 0, "{told}");
    }
}

#[test]
fn a_ramp_under_virtual_contacts_opens_the_start_contacts_first() {
    let contacts = drive("\"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0", "");
    for (on_exit, words) in [("ramp", vec!["00 03", "00 01", "00 00"]), ("coast", vec!["00 03", "00 00"])] {
        let line = "-v -b 115200 -a 1 --yes statemachine contacts S1IND S2IND --hold --duration 1s --on-exit";
        let run = antrieb(&format!("{line} {on_exit}")).on(&contacts).json();
        let sent: Vec<_> = run.err.lines().filter_map(|line| line.split_once("> 01 06 01 9A ")?.1.get(..5)).collect();
        assert_eq!(sent, words, "{on_exit}: {}", run.err);
        assert!(run.data("/to/slug") == "switched-on", "{:#}", run.value);
    }
}

#[test]
fn a_setpoint_whose_write_was_not_answered_is_taken_back() {
    let bench = drive(READY, "");
    let mut given = false;
    for once in 18..38 {
        let lost = format!("{bench}[[disturb]]\nonce = {once}\nkind = \"lost\"\n");
        let run =
            antrieb("-v --retries 0 -b 115200 -a 1 --yes sollwert 20Hz --enable --hold --duration 10ms --wait 0s")
                .on(&lost)
                .json();
        let sent: Vec<_> =
            run.err.lines().filter(|line| line.contains("> 01 65 01 E4") || line.contains(" 01 E4 ")).collect();
        let twenty = sent.iter().any(|line| line.contains("00 00 07 D0"));
        given |= twenty && run.exit != 0;
        assert!(!twenty || sent.last().is_some_and(|line| !line.contains("00 00 07 D0")), "{once}: {}", run.err);
    }
    assert!(given);
}

#[test]
fn no_motor_is_powered_only_to_be_stopped() {
    let run =
        antrieb("-a 1 --drive lxm05 --yes -v statemachine goto quick-stop-active").on(&servo("", "")).json().exits(8);
    assert_eq!(run.error()["code"], "forbidden.detour");
    assert!(!run.err.contains("> 01 10 1B 02"), "{}", run.err);
}

#[test]
fn a_stop_of_a_drive_that_is_not_enabled_sends_nothing_that_leads_up() {
    let run = antrieb("-a 1 --drive lxm05 --yes -v sollwert 300rpm --hold --duration 50ms").on(&servo("", "")).json();
    assert!(!run.err.contains("> 01 10 1B 02 00 02 04 00 00 00 07"), "{}", run.err);
    assert_eq!(run.data("/to/slug"), "switch-on-disabled", "{:#}", run.value);
}
