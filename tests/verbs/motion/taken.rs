//! Control that is taken from others: what ran before must not run again when it goes back, and is not stopped in name only.

use super::rig::{READY, drive, held};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::profile::Registry;
use antrieb::tick::Span;
use antrieb::transport::witness;
use serde_json::json;

/// A drive whose contacts start it under every P.412 but 1 and 2.
fn by_contacts(mode: u8, more: &str) -> String {
    let set = format!("\"412\" = {mode}, \"434\" = 2, \"484\" = 10, \"418\" = 10");
    drive(
        &set,
        &format!("readings = {{ other_modes = \"contacts\" }}\nramps = {{ up_right = 50, down_right = 20 }}\n{more}"),
    )
}

/// Whether the shaft turns a minute after the program has ended.
fn turns_later() -> bool {
    let (mut bench, at) = witness::left().unwrap();
    bench.advance(at + antrieb::tick::Span::from_secs(60));
    bench.totals().turning > 0
}

const RUN: &str = "-b 115200 -a 1 --yes sollwert 20Hz --enable --hold --duration 1s --take-control";

#[test]
fn a_drive_that_its_contacts_ran_does_not_run_again_when_control_goes_back() {
    for mode in [0, 44] {
        for verb in [RUN, "-b 115200 -a 1 --yes statemachine enable --hold --duration 1s --take-control"] {
            for way in ["ramp", "quick-stop"] {
                let line = format!("{verb} --on-exit {way}");
                let run = antrieb(&line).on(&by_contacts(mode, "")).json().exits(9);
                assert!(!turns_later(), "{mode} {line}");
                assert_eq!(run.error()["code"], "partial.not_given_back", "{mode} {line}");
                assert!(run.data("/notes").to_string().contains("P.412 stays 1"), "{:#}", run.value);
            }
        }
    }
}

#[test]
fn control_goes_back_to_who_did_not_run_the_drive_before() {
    let idle = drive(&READY.replace("\"412\" = 1", "\"412\" = 44"), "");
    let back = antrieb(RUN).on(&idle).json().exits(0);
    assert_eq!(back.data("/changed/0/restored"), &json!(true));
    assert!(!turns_later());
}

#[test]
fn a_stop_that_takes_control_first_is_no_success_unless_the_shaft_was_seen_to_stand() {
    for mode in [0, 44] {
        let blind = by_contacts(mode, "").replace("\"418\" = 10", "\"418\" = 10, \"217\" = 0, \"218\" = 0");
        let run = antrieb("-b 115200 -a 1 --yes statemachine quick-stop --take-control").on(&blind).json();
        assert_eq!(run.exit == 9, run.data("/standing") == &json!(true), "{mode} {:#}", run.value);
    }
}

/// What it took is given back, or it is said why not, and how that is done.
#[test]
fn a_stop_that_takes_control_gives_it_back_or_says_why_not() {
    for verb in ["quick-stop", "disable", "disable-voltage"] {
        let line = format!("-b 115200 -a 1 --yes statemachine {verb} --take-control");
        let run = antrieb(&line).on(&by_contacts(0, "")).json();
        assert!(!turns_later(), "{line}");
        assert_eq!(run.data("/changed/0/restored"), &json!(false), "{line} {:#}", run.value);
        assert!(run.data("/notes").to_string().contains("P.412 stays 1"), "{line} {:#}", run.value);
        assert!(run.exit != 0, "{line} {:#}", run.value);
        if run.error()["code"] == "partial.not_given_back" {
            assert!(run.error()["hint"].to_string().contains("write 412@1ram=0"), "{line} {:#}", run.value);
        }
        let idle = drive(&READY.replace("\"412\" = 1", "\"412\" = 44"), "");
        let back = antrieb(&line).on(&idle).json();
        assert_eq!(back.data("/changed/0/restored"), &json!(true), "{line} {:#}", back.value);
    }
    let run = antrieb("-b 115200 -a 1 --yes statemachine disable-voltage --take-control").on(&by_contacts(0, ""));
    assert_eq!(run.json().exits(9).error()["code"], "partial.not_given_back");
}

#[test]
fn a_zero_is_judged_by_the_shaft_whatever_stands_beside_it() {
    for more in ["", "--take-control", "--watchdog 2s"] {
        let run = antrieb(&format!("-b 115200 -a 1 --yes sollwert 0 {more}")).on(&by_contacts(0, "")).json().exits(1);
        assert_eq!(run.error()["code"], "no.not_standing", "{more}");
        assert!(run.error()["hint"].as_str().unwrap().contains("start contact"), "{}", run.error());
    }
    // It needs no control, so that it asks nobody.
    antrieb("-b 115200 -a 1 sollwert 0 --take-control").on(&by_contacts(0, "")).json().exits(1);
    let needless = antrieb("-b 115200 -a 1 --yes sollwert 5Hz --take-control").on(&by_contacts(0, "")).json().exits(2);
    assert_eq!(needless.error()["code"], "usage.take_control");
}

#[test]
fn the_question_names_every_place_at_which_a_profile_turns() {
    let line = "-b 115200 -a 1 sollwert --profile {dir}/way.csv --enable --hold";
    for (hertz, told) in [
        (&[5, 15, -5, 0][..], "5.00 Hz … 15.00 Hz … -5.00 Hz … 0.00 Hz"),
        // Not where it only goes on, or stays.
        (&[5, 10, 15, 15, 3, -5, 0], "5.00 Hz … 15.00 Hz … -5.00 Hz … 0.00 Hz"),
        (&[5, 10, 4, 9, 3, 8], "5.00 Hz … 10.00 Hz … 4.00 Hz … 9.00 Hz … 3.00 Hz … 8.00 Hz"),
        // A long one by its ends, and by the least and the greatest between them.
        (&[5, 10, 4, 9, 3, 8, 6], "5.00 Hz … 3.00 Hz … 10.00 Hz … 6.00 Hz"),
    ] {
        let profile: String = hertz.iter().enumerate().map(|(at, hertz)| format!("{at}s, {hertz}Hz\n")).collect();
        let run = antrieb(line).file("way.csv", &profile).on(&drive(READY, "")).answered("n").run();
        assert!(run.err.contains(told), "{told}: {}", run.err);
    }
    let percent = antrieb("-b 115200 -a 1 sollwert 30% --enable --hold")
        .on(&drive("\"412\" = 1, \"434\" = 2, \"418\" = \"3.5\"", ""));
    let percent = percent.answered("n").run();
    assert!(percent.err.contains("it runs at 3.50 Hz by itself (P.418, P.434 = 2)"), "{}", percent.err);
}

#[test]
fn a_stop_goes_out_whatever_else_somebody_must_agree_to() {
    let running = drive(super::rig::RUNNING, "ramps = { up_right = 50, down_right = 20 }");
    for verb in ["quick-stop", "disable", "disable-voltage"] {
        for more in ["--take-control", "--watchdog 2s"] {
            let run = antrieb(&format!("-b 115200 -a 1 statemachine {verb} {more}")).on(&running).json().exits(8);
            assert!(run.error()["message"].as_str().unwrap().starts_with("the stop was sent"), "{}", run.error());
            assert!(!turns_later(), "{verb} {more}");
        }
    }
}

#[test]
fn a_stop_is_not_held_and_a_zero_goes_out_before_anybody_is_asked_about_the_rest() {
    let running = drive(super::rig::RUNNING, "ramps = { up_right = 50, down_right = 20 }");
    for verb in ["quick-stop", "disable", "disable-voltage"] {
        let run =
            antrieb(&format!("-b 115200 -a 1 statemachine {verb} --hold --duration 1s")).on(&running).json().exits(0);
        assert!(run.err.contains("a stop is no run"), "{}", run.err);
        assert!(!turns_later(), "{verb}");
    }
    for more in ["--hold --duration 1s", "--source line", "--watchdog 2s"] {
        let run = antrieb(&format!("-b 115200 -a 1 sollwert 0 {more}")).on(&running).json().exits(8);
        let message = run.error()["message"].as_str().unwrap();
        assert!(message.starts_with("the stop was sent"), "{more}: {message}");
        assert!(!turns_later(), "{more}");
    }
}

/// Remote falls at the next look; who has control is asked only now and then.
#[test]
fn that_control_was_taken_is_seen_at_the_next_look() {
    let setpoint = Registry::open(&[]).unwrap().family("acu").unwrap().role("setpoint-frequency").unwrap().clone();
    let data_set = Registry::open(&[]).unwrap().family("acu").unwrap().param(414).unwrap().clone();
    // It was seen in a look before. As many rounds later the data set in which somebody else has control is selected.
    for round in 2..=4 {
        let bench = drive(&format!("{READY}, \"412@2\" = 0"), "");
        let (mut rounds, setpoint, data_set) = (0, &setpoint, &data_set);
        let came = held(&bench, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.walk("operation-enabled").await?;
            motor.give(setpoint, 2_000, "Hz").await?;
            motor
                .hold(Some(Span::from_secs(5)), async |motor: &mut Motor<'_, '_>, _| {
                    rounds += 1;
                    if rounds == round {
                        motor.set(data_set, 2).await?;
                    }
                    motor.refresh(setpoint, 2_000).await
                })
                .await
        });
        let selected = came.sent.iter().position(|hex| hex.starts_with("01 06 01 9E 00 02")).unwrap();
        let refreshed =
            came.sent.iter().skip(selected).filter(|hex| hex.starts_with("01 65 01 E4 00 00 07 D0")).count();
        assert!(came.ended.result.is_err() && refreshed == 1, "{round}: {refreshed} {:?}", came.sent);
    }
}
