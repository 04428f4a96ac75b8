//! What was asked for is what is given: the stop, its proof, and what goes back.

use super::rig::{READY, RUNNING, drive, held, held_of, run_at_20_hz, servo, servo_at};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::failure::Class;
use antrieb::gate::Relief;
use antrieb::tick::Span;
use antrieb::transport::witness;
use serde_json::json;

const CONTROL: &str = "01 06 01 9A";

/// CM-485 manual 6.8: 500 ms are in time.
#[test]
fn a_drive_that_answers_within_its_time_is_ramped_down() {
    for model in ["act", "acu"] {
        for protocol in ["rtu", "ascii", "vabus"] {
            for ms in [130, 200, 310, 480] {
                let rest = format!("reply_delay = \"{ms}ms\"\nprotocol = \"{protocol}\"");
                let bench = format!("[[drive]]\nmodel = \"{model}\"\nset = {{ {RUNNING} }}\n{rest}\n");
                let line = format!("-v --protocol {protocol} -a 1 --drive {model} statemachine disable");
                let run = antrieb(&line).on(&bench).json();
                let word = |value: &str| run.err.contains(&format!("Control word = {value}"));
                assert!(word("7") && !word("2") && !word("0"), "{model} {protocol} {ms}: {}", run.err);
                assert_eq!(run.data("/running"), &json!(false), "{model} {protocol} {ms}");
            }
        }
    }
}

#[test]
fn a_proof_that_was_made_stays_one_whatever_is_lost_later() {
    let (mut later, mut sins) = (0, Vec::new());
    for (verb, word) in [("quick-stop", "00 02"), ("disable", "00 07")] {
        for dead in 1..30 {
            let event = format!("[[drive.event]]\nafter_telegrams = {dead}\nsilent = \"600s\"");
            let bench = drive(&format!("{RUNNING}, \"424\" = 999, \"425\" = 999, \"638\" = \"0.2\""), &event);
            let run = antrieb(&format!("-v -b 115200 -a 1 --drive acu statemachine {verb}")).on(&bench).json();
            assert_eq!(run.data("/from"), &json!(null), "it was not looked at before the stop");
            if run.data("/running") == &json!(false) {
                later += u8::from(run.data("/notes").to_string().contains("not read after that"));
                let message = run.error()["message"].as_str().unwrap_or("");
                let told = ["NOT acknowledged", "coast:"].iter().any(|text| message.contains(text));
                let seen = run.exit == 0 || run.error()["code"] == "forbidden.standstill_unproven";
                let word = run.err.contains(&format!("> {CONTROL} {word}"));
                if told || !seen || !word || !run.data("/stop").is_null() {
                    sins.push(format!("{verb}, dead after {dead}: {:#}", run.value));
                }
            }
        }
    }
    assert!(sins.is_empty() && later > 2, "{later} {}", sins.join("\n"));
}

#[test]
fn what_contacts_cannot_do_is_said_and_is_no_success() {
    let contacts = drive("\"410\" = 3, \"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0", "");
    for (lang, text) in [("en", "contacts know no quick stop"), ("de", "Kontakte kennen keinen Schnellhalt")] {
        for drive in ["", "--drive acu"] {
            let line = format!("--lang {lang} -b 115200 -a 1 {drive} statemachine quick-stop");
            let run = antrieb(&line).on(&contacts).json().exits(8);
            let message = run.error()["message"].as_str().unwrap();
            assert!(message.contains(text) && message.contains("P.412"), "{message}");
            assert_eq!(run.error()["code"], "forbidden.other_stop");
        }
        let line = format!("-v --lang {lang} -b 115200 -a 1 --yes statemachine contacts S1IND S2IND --hold");
        let run = antrieb(&format!("{line} --on-exit quick-stop")).on(&contacts).json().exits(2);
        assert!(run.error()["message"].as_str().unwrap().contains(text), "{}", run.error());
        assert!(!run.err.contains(&format!("> {CONTROL}")), "{}", run.err);
    }
}

#[test]
fn who_interrupts_the_strongest_stop_again_still_gets_it() {
    // The line is never silent, so that the stop waits for its turn when somebody presses again.
    for babble in ["", "kind = \"babble\"\npattern = \"55\"\nby = \"20ms\""] {
        let babble = if babble.is_empty() { String::new() } else { format!("[[disturb]]\n{babble}\n") };
        for turns in 0..40 {
            let again = format!("+{turns}");
            let bench = format!("{}{babble}", drive(READY, ""));
            let presses = ["01 65 01 E4 00 00 07 D0", &again];
            let came = held(&bench, &presses, StopChoice::Coast, Span::from_secs(30), async |motor| {
                run_at_20_hz(motor, None).await
            });
            let told = format!("{turns} {babble}: {:?}", came.ended);
            assert!(came.sent.iter().any(|hex| hex.starts_with("01 06 01 9A 00 00")), "{told}");
            assert_eq!((came.turning, came.energised), (0, 0), "{told}");
            assert!(came.stop().acknowledged || !babble.is_empty(), "{told}");
        }
    }
}

/// Parameters of the LXM05 that a run writes: GEARnum, GEARdenom, GEARreference, HMmethod, PPp_targetusr, RAMPacc.
const WRITTEN: [u32; 6] = [9_736, 9_734, 6_948, 6_936, 6_940, 1_556];

#[test]
fn everything_that_a_run_writes_is_given_back_and_told() {
    let set = "RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000, GEARnum = 5, GEARdenom = 7, HMmethod = 18, \
               PPp_targetusr = 12";
    for (words, expected) in [
        ("2/3 --set IOposInterfac=1", &["GEARnum", "GEARdenom", "GEARreference"][..]),
        ("17 --mode homing --set HMn=30", &["HMmethod", "HMn"]),
        ("3000usr --set RAMPacc=2000", &["PPp_targetusr", "RAMPacc"]),
    ] {
        let bench = servo(set, "servo = { limn = -8192, guide = 16384 }");
        let line = format!("-a 1 --drive lxm05 --yes sollwert {words} --enable --hold --duration 300ms");
        let run = antrieb(&line).on(&bench).json().exits(0);
        let (after, _) = witness::left().unwrap();
        let registry = antrieb::profile::Registry::open(&[]).unwrap();
        let fresh = antrieb::simulator::Bench::from_toml("bench", &bench, &registry).unwrap();
        let (after, fresh) = (after.drives().next().unwrap(), fresh.drives().next().unwrap());
        for param in WRITTEN {
            assert_eq!(after.ram(param, 0), fresh.ram(param, 0), "{words}: {param}");
        }
        let told = run.data("/changed").to_string();
        assert!(expected.iter().all(|name| told.contains(name)), "{words}: {told}");
        assert!(!told.contains("\"restored\":false"), "{words}: {told}");
    }
}

#[test]
fn a_watchdog_that_could_not_be_read_is_not_called_off() {
    // Nothing comes behind the setpoint of zero and the first look.
    for dead in 2..24 {
        let event = format!("[[drive.event]]\nafter_telegrams = {dead}\nsilent = \"600s\"");
        let run = antrieb("-v -b 115200 -a 1 --drive acu sollwert 0").on(&drive(RUNNING, &event)).run();
        let read = run.err.contains("read P.413") && run.err.lines().any(|line| line.contains("P.413"));
        let off = [&run.out, &run.err].iter().any(|text| text.contains("watchdog (P.413) is off"));
        assert!(read || !off, "{dead}: {}{}", run.out, run.err);
        let reached = run.out.lines().any(|line| line.starts_with("setpoint") && line.contains(", reached"));
        assert!(!reached || run.err.contains("read P.210"), "{dead}: {}{}", run.out, run.err);
    }
}

/// Holds an enabled servo with nothing but looks; the times of its writes in ms while it was held.
fn feeding(guard: i64, by: &str) -> (Vec<String>, bool) {
    let bench = servo("RAMPacc = 3000", &format!("readings = {{ node_guard_fed_by = \"{by}\" }}"));
    let work = async |motor: &mut Motor<'_, '_>| {
        if guard > 0 {
            motor.change("watchdog", guard).await?;
        }
        motor.walk("operation-enabled").await?;
        motor.hold(Some(Span::from_secs(4)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    };
    let came = held_of("lxm05", &bench, &[], StopChoice::Coast, Span::ZERO, work);
    let ok = came.ended.result.is_ok();
    (came.sent, ok)
}

/// Control word 000Fh (DCOMcontrol 6914 = 1B02h): what was written last, said again.
const ENABLE: &str = "01 10 1B 02 00 02 04 00 00 00 0F";

#[test]
fn a_watchdog_is_fed_in_time_not_too_often_and_by_what_was_written_last() {
    for (guard, least, most) in [(0, 1, 1), (600, 10, 21), (1_200, 5, 11), (3_000, 2, 6)] {
        for by in ["writes", "all"] {
            let (sent, ok) = feeding(guard, by);
            let fed = sent.iter().filter(|hex| hex.starts_with(ENABLE)).count();
            assert!(ok && (least..=most).contains(&fed), "{guard} ms by {by}: fed {fed} times");
            let other = sent.iter().filter(|hex| hex.starts_with("01 10 1B 02")).count() - fed;
            // Disable voltage, 6, 7 on the way up, and the end.
            assert!(other <= 6, "{guard} ms by {by}: {other}");
        }
    }
}

#[test]
fn a_drive_that_is_no_longer_enabled_is_not_fed_with_its_enable() {
    let lost = "[[drive.event]]\nat = \"2500ms\"\nenable = false\n[[drive.event]]\nat = \"9s\"\nenable = true";
    let came = held(
        &drive(&format!("{READY}, \"413\" = 1"), lost),
        &[],
        StopChoice::Ramp,
        Span::from_secs(20),
        async |motor| {
            motor.walk("operation-enabled").await?;
            motor.hold(Some(Span::from_secs(5)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
        },
    );
    assert!(came.ended.result.is_err(), "{:?}", came.ended);
    let last = came.sent.iter().rposition(|hex| hex.starts_with("01 06 01 9A 00 0F")).unwrap();
    let stop = came.sent.iter().position(|hex| hex.starts_with("01 06 01 9A 00 07")).unwrap();
    assert!(last < stop && came.energised == 0, "{:?}", came.sent);
}

/// What a drive refuses it refuses again; only what was lost is said once more.
#[test]
fn what_is_refused_in_a_run_is_not_said_again_and_again() {
    let bench = drive(READY, "[[drive.event]]\nat = \"1ms\"\nrefuses = 484");
    let came = held(&bench, &[], StopChoice::Ramp, Span::ZERO, async |motor| run_at_20_hz(motor, None).await);
    let class = came.ended.result.as_ref().map_err(|failure| failure.class);
    assert_eq!(class, Err(Class::Refused), "{:?}", came.ended);
    let said = came.sent.iter().filter(|hex| hex.starts_with("01 65 01 E4 00 00 07 D0")).count();
    assert_eq!((said, came.energised), (1, 0), "{:?}", came.sent);
}

/// A line setpoint from before would turn the shaft with the enable. An ACU does not let its setpoint be read back, so that the
/// refusal of the 0 is all that tells.
#[test]
fn a_drive_whose_setpoint_does_not_go_to_0_is_not_enabled() {
    for model in ["act", "acu"] {
        let set = "\"412\" = 1, \"434\" = 2, \"484\" = 10, \"418\" = 0";
        let bench = drive(set, "[[drive.event]]\nat = \"1ms\"\nrefuses = 484").replace("acu", model);
        let line = "-v -b 115200 -a 1 --yes statemachine enable --hold --duration 300ms";
        let run = antrieb(line).on(&bench).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.standing_setpoint", "{model}: {}", run.error());
        assert!(!run.err.contains(&format!("> {CONTROL} 00 0F")), "{model}: {}", run.err);
    }
}

/// Without power before it stands, a shaft would coast in place of its quick stop.
#[test]
fn a_servo_keeps_its_power_until_its_quick_stop_has_brought_it_to_rest() {
    let bench = servo("RAMPacc = 3000, RAMPdecel = 3000", "readings = { quick_stop = \"stays\" }");
    let came = held_of("lxm05", &bench, &[], StopChoice::QuickStop, Span::from_secs(5), async |motor| {
        servo_at(motor, 900, Some(Span::from_secs(2))).await
    });
    let sent = |word: &str, from: usize| {
        let begins = format!("01 10 1B 02 00 02 04 00 00 00 {word}");
        came.sent.iter().skip(from).position(|hex| hex.starts_with(&begins)).map(|found| found + from)
    };
    let quick = sent("02", 0).unwrap();
    let off = sent("00", quick).unwrap();
    let places = came.sent[quick..off].iter().filter(|hex| hex.starts_with("01 03 1E 14")).count();
    assert!(places >= 2, "{:?}", &came.sent[quick..=off]);
    assert_eq!((came.stop().acknowledged, came.stop().standing), (true, Some(true)), "{:?}", came.ended);
}

/// As contacts the words of the state machine would close what the stop has opened.
#[test]
fn who_interrupts_the_opening_of_contacts_gets_all_of_them_opened() {
    let ramps = "ramps = { up_right = 50, down_right = 2, up_left = 50, down_left = 2 }";
    let contacts = drive("\"410\" = 3, \"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0", ramps);
    for turns in ["+1", "+5", "+20", "+60"] {
        let presses = ["01 06 01 9A 00 01", turns];
        let came = held(&contacts, &presses, StopChoice::QuickStop, Span::from_secs(30), async |motor| {
            motor.relieve(Relief::Disable).await
        });
        let words: Vec<&str> = came.sent.iter().filter_map(|hex| hex.strip_prefix("01 06 01 9A 00 ")).collect();
        assert!(words.iter().all(|word| word.starts_with("01") || word.starts_with("00")), "{turns}: {words:?}");
        assert_eq!((words.last().map(|word| &word[..2]), came.energised), (Some("00"), 0), "{turns}: {words:?}");
    }
}
