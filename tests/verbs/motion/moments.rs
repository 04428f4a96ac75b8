//! What falls into one particular moment of a run: an answer that is lost just then, an interrupt, an enable that goes, a
//! drive that is slow or says no.

use super::rig::{
    DISABLE, ENCODER, QUICK_STOP, READY, REFRESH, RUNNING, drive, held, held_of, run_at_20_hz, servo, servo_at,
};
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice};
use antrieb::gate::Relief;
use antrieb::profile::{Param, Registry};
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::json;

const ONE: Span = Span::from_secs(1);
const ENABLE: &str = "01 06 01 9A 00 0F";

fn acu(role: &str) -> Param {
    Registry::open(&[]).unwrap().family("acu").unwrap().role(role).unwrap().clone()
}

fn silent_after(telegrams: usize, ms: u64) -> String {
    format!("[[drive.event]]\nafter_telegrams = {telegrams}\nsilent = \"{ms}ms\"")
}

/// The line dies at any step: nobody says that a drive was seen without power that has it.
#[test]
fn a_drive_that_has_power_is_never_said_to_have_been_seen_without() {
    let mut lost = 0;
    for verb in ["statemachine enable", "sollwert 10Hz --enable --hold --duration 300ms --on-exit keep"] {
        let line = format!("-v -b 115200 -a 1 --drive acu --yes {verb}");
        let sent = antrieb(&line).on(&drive(READY, "")).exits(0).sent();
        let enabled = sent.iter().position(|hex| hex.starts_with(ENABLE)).unwrap();
        for dead in enabled + 1..=sent.len() {
            let run = antrieb(&line).on(&drive(READY, &silent_after(dead, 600_000))).run();
            let energised = witness::left().unwrap().0.totals().energised;
            let said = format!("{}{}", run.out, run.err);
            assert!(energised == 0 || !said.contains("seen without power"), "{verb}, dead after {dead}: {said}");
            lost += energised;
        }
    }
    assert!(lost > 2, "{lost}");
}

/// Its answer is lost, and nothing is seen any more.
#[test]
fn a_word_that_may_have_given_power_leaves_no_idle_drive() {
    for (mode, word) in [("1", ENABLE), ("2", "01 06 01 9A 00 03")] {
        let bench = |rest: &str| drive(&READY.replace("\"412\" = 1", &format!("\"412\" = {mode}")), rest);
        let powered = |rest: &str| {
            let mut idle = None;
            let came = held(&bench(rest), &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
                let done = if mode == "1" { motor.walk("operation-enabled").await } else { motor.contacts(3).await };
                idle = Some(motor.is_idle());
                done
            });
            (came, idle)
        };
        let gives = powered("").0.sent.iter().position(|hex| hex.starts_with(word)).unwrap();
        let (came, idle) = powered(&silent_after(gives + 1, 600_000));
        assert_eq!((idle, came.ended.result.is_ok()), (Some(false), false), "{word}: {:?}", came.ended);
    }
}

/// What was not told in time went out as a quick stop, which opens a contact; that is said only where it took the power.
#[test]
fn contacts_that_were_opened_in_place_of_a_ramp_are_told_as_that_and_no_others() {
    let contacts = |word: u8, rest: &str| {
        let set = format!("\"410\" = {word}, \"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0");
        drive(&set, &format!("ramps = {{ up_right = 50, down_right = 20, up_left = 50, down_left = 20 }}\n{rest}"))
    };
    // It tells its control word, and nothing for a second behind that; or everything as late as it may.
    let (untold, late) = (silent_after(1, 1_000), "[[disturb]]\nevery = 1\nkind = \"late\"\nby = \"470ms\"".to_owned());
    for (word, rest, instead) in [
        (3, untold, true),
        (3, late, false),
        (3, String::new(), false),
        (0, String::new(), false),
        (1, String::new(), false),
    ] {
        let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&contacts(word, &rest)).json();
        let other = run.error()["code"] == "forbidden.other_stop";
        assert_eq!(other, instead, "{word} {rest}: {:#}", run.value);
        let why = run.error()["message"].as_str().is_some_and(|text| text.contains("was not told in time"));
        assert_eq!(why, instead, "{word} {rest}: {:#}", run.value);
        assert_eq!(witness::left().unwrap().0.totals().energised, 0, "{word} {rest}");
    }
}

/// It becomes silent for a moment just as its ramp begins: the ramp is said again, and it keeps its power until it stands.
#[test]
fn a_ramp_whose_beginning_is_lost_is_still_a_ramp() {
    const ZERO: &str = "01 10 1B 1A 00 02 04 00 00 00 00";
    const WORD: &str = "01 10 1B 02";
    let run = |rest: &str| {
        let bench = servo("RAMPacc = 3000, RAMPdecel = 300, RAMPn_max = 3000", rest);
        held_of("lxm05", &bench, &[], StopChoice::Ramp, Span::ZERO, async |motor| servo_at(motor, 600, Some(ONE)).await)
    };
    let clean = run("");
    let zero = clean.sent.iter().rposition(|hex| hex.starts_with(ZERO)).unwrap();
    let first = clean.sent.iter().skip(20).position(|hex| hex.starts_with(ZERO)).unwrap() + 20;
    let came = run(&silent_after(first, 700));
    let (begun, power) = (came.at[first], came.sent.iter().skip(first).position(|hex| hex.starts_with(WORD)).unwrap());
    let ramped = came.at[first + power].since(begun);
    assert!(zero >= first && ramped > ONE, "{first} {zero} {ramped}: {:?}", &came.sent[first..]);
    assert!(came.stop().acknowledged && came.stop().escalated.is_none(), "{:?}", came.ended);
    assert_eq!((came.stop().standing, came.turning), (Some(true), 0));
}

/// The enable goes as the last step of the way up is said: that step is not reported as taken.
#[test]
fn a_state_that_does_not_come_is_no_step_that_was_walked() {
    let line = "-v -b 115200 -a 1 --drive acu --yes statemachine enable";
    let sent = antrieb(line).on(&drive(READY, "")).exits(0).sent();
    let word = sent.iter().position(|hex| hex.starts_with(ENABLE)).unwrap();
    let gone = format!("[[drive.event]]\nafter_telegrams = {word}\nenable = false");
    let run = antrieb(line).on(&drive(READY, &gone)).json().exits(8);
    assert_eq!(run.data("/steps"), &json!([]), "{:#}", run.value);
    assert_eq!(run.error()["code"], "forbidden.interlock", "{:#}", run.value);
    let message = run.error()["message"].as_str().unwrap();
    assert!(message.contains("stays in 'Switch-on disabled'"), "{message}");
}

/// A servo ramps by its own word; where nothing is told the same word is said again, and no harder one.
#[test]
fn a_ramp_is_said_again_as_a_ramp_to_a_servo_that_says_nothing() {
    for (model, word, others) in
        [("lxm05", "01 10 1B 02 00 02 04 00 00 00 07", "01 10 1B 02"), ("acu", QUICK_STOP, DISABLE)]
    {
        let bench = match model {
            "acu" => drive(RUNNING, "[[drive.event]]\nat = \"300ms\"\nsilent = \"600s\""),
            _ => servo("RAMPacc = 3000", "[[drive.event]]\nat = \"600ms\"\nsilent = \"600s\""),
        };
        let came = held_of(model, &bench, &[], StopChoice::Keep, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            while motor.look().await.is_ok() {}
            motor.relieve(Relief::Disable).await
        });
        let said = |begin: &str| came.sent.iter().filter(|hex| hex.starts_with(begin)).count();
        assert!(said(word) > 0, "{model}: {:?}", came.sent);
        assert_eq!(said(others), if model == "acu" { 0 } else { said(word) }, "{model}: {:?}", came.sent);
    }
}

/// A no that passes: the stop is said again, and nothing takes its place.
#[test]
fn a_stop_that_is_refused_for_a_moment_is_said_again() {
    let stopped = |rest: &str| {
        held(&drive(READY, rest), &[], StopChoice::Coast, Span::ZERO, async |motor| {
            run_at_20_hz(motor, Some(Span::from_millis(10))).await
        })
    };
    let stop = stopped("").sent.iter().position(|hex| hex.starts_with("01 06 01 9A 00 00")).unwrap();
    let refuses = |after: usize, place: u16| format!("[[drive.event]]\nafter_telegrams = {after}\nrefuses = {place}\n");
    for later in 1..=4 {
        let came = stopped(&(refuses(stop, 410) + &refuses(stop + later, 9_999)));
        assert!(came.stop().acknowledged, "{later}: {:?} {:?}", came.ended, came.notes);
        assert!(!came.notes.iter().any(|note| note.contains("in its place")), "{later}: {:?}", came.notes);
    }
}

#[test]
fn who_interrupts_a_run_is_told_what_happens_and_what_another_interrupt_does() {
    for (choice, told) in [
        (StopChoice::Ramp, "stopping: ramp; another Ctrl-C: quick-stop"),
        (StopChoice::QuickStop, "stopping: quick-stop; another Ctrl-C: coast"),
        (StopChoice::Coast, "stopping: coast; another Ctrl-C waits no longer"),
    ] {
        for presses in [&[REFRESH][..], &[]] {
            let came = held(&drive(READY, ""), presses, choice, Span::ZERO, async |motor| {
                run_at_20_hz(motor, Some(Span::from_millis(600))).await
            });
            let count = came.told.iter().filter(|note| *note == told).count();
            assert_eq!(count, presses.len(), "{choice:?}: {:?}", came.told);
        }
    }
}

/// A servo works on in its ramp, as it should: who does not wait for that is told so, without an alarm.
#[test]
fn who_interrupts_a_ramp_that_is_obeyed_is_not_alarmed() {
    const GIVEN: &str = "01 10 1B 1A 00 02 04 00 00 02 58";
    const ZERO: &str = "01 10 1B 1A 00 02 04 00 00 00 00";
    let bench = servo("RAMPacc = 3000, RAMPdecel = 100, RAMPn_max = 3000", "");
    let came = held_of("lxm05", &bench, &[GIVEN, ZERO], StopChoice::Ramp, Span::ZERO, async |motor| {
        servo_at(motor, 600, Some(Span::from_secs(10))).await
    });
    let told = |text: &str| came.told.iter().filter(|note| note.contains(text)).count();
    assert_eq!(told("interrupted again: quick-stop in place of ramp"), 1, "{:?}", came.told);
    assert_eq!(told("MAY STILL TURN"), 0, "{:?}", came.told);
}

/// Contacts ran it; then a data set was selected in which it obeys the control word: the stop goes by that.
#[test]
fn a_drive_that_takes_the_control_word_in_the_run_is_stopped_by_it() {
    let registry = Registry::open(&[]).unwrap();
    let data_set = registry.family("acu").unwrap().param(414).unwrap().clone();
    let bench = drive(&format!("{}, \"412@2\" = 1", READY.replace("\"412\" = 1", "\"412\" = 2")), "");
    let (mut rounds, data_set) = (0, &data_set);
    let came = held(&bench, &[], StopChoice::QuickStop, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.contacts(15).await?;
        motor
            .hold(Some(Span::from_secs(6)), async |motor: &mut Motor<'_, '_>, _| {
                rounds += 1;
                if rounds == 2 { motor.set(data_set, 2).await } else { Ok(()) }
            })
            .await
    });
    let failure = came.ended.result.as_ref().unwrap_err();
    assert_eq!(failure.code, "forbidden.control_taken", "{failure:?}");
    assert!(failure.message.en.contains("contacts by the line are not obeyed"), "{failure:?}");
    assert!(came.sent.iter().any(|hex| hex.starts_with(QUICK_STOP)), "{:?}", came.sent);
    assert_eq!((came.turning, came.energised), (0, 0), "{:?}", came.ended);
}

/// A setpoint that the drive does not come to, while its shaft turns evenly: that is told in seconds.
#[test]
fn an_even_shaft_that_does_not_reach_its_setpoint_is_not_waited_for() {
    let setpoint = acu("setpoint-frequency");
    // What its ramp asks for, and how far it may be from what the drive will run at: 10, or a 500th.
    for (goal, reached) in [(2_010, true), (2_011, false)] {
        let came = held(&drive(READY, ""), &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.walk("operation-enabled").await?;
            motor.expects = Some((2_000, goal));
            motor.give(&setpoint, 2_000, "Hz").await?;
            motor.until_reached().await
        });
        assert_eq!(came.ended.result.is_ok(), reached, "{goal}: {:?}", came.ended.result);
        assert!(came.took < Tick::ZERO + Span::from_secs(20), "{goal}: {:?}", came.took);
    }
}

/// Whoever is told no keeps the setpoint from before, and nobody wonders whether it was written.
#[test]
fn a_setpoint_that_is_refused_was_not_given() {
    let bench = servo("RAMPacc = 3000", "[[drive.event]]\nwhen = \"above 4Hz\"\nrefuses = 6938");
    let registry = Registry::open(&[]).unwrap();
    let family = registry.family("lxm05").unwrap();
    let (mode, speed) = (family.mode("velocity").unwrap(), family.param(6_938).unwrap());
    let mut left = None;
    let came = held_of("lxm05", &bench, &[], StopChoice::QuickStop, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.prepare(mode);
        motor.walk("operation-enabled").await?;
        motor.enter().await?;
        motor.make_it_count().await?;
        motor.give(speed, 300, "rpm").await?;
        motor.until_reached().await?;
        let refused = motor.give(speed, 600, "rpm").await;
        left = motor.setpoint.as_ref().map(|setpoint| (setpoint.value.raw, setpoint.writes));
        refused
    });
    assert_eq!(left, Some((300, 1)), "{:?}", came.ended);
    assert!(!came.notes.iter().any(|note| note.contains("is not known")), "{:?}", came.notes);
}

/// It is written twice: first as it stands already, then otherwise.
#[test]
fn what_was_written_as_it_stood_and_then_otherwise_is_given_back() {
    let registry = Registry::open(&[]).unwrap();
    let family = registry.family("lxm05").unwrap();
    let ramp = family.param(1_556).unwrap();
    let bench = servo("RAMPacc = 3000", "");
    let came = held_of("lxm05", &bench, &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.set(ramp, 3_000).await?;
        motor.set(ramp, 2_000).await
    });
    let written: Vec<_> = came.sent.iter().filter(|hex| hex.starts_with("01 10 06 14")).collect();
    assert!(written.last().is_some_and(|hex| hex.contains("00 00 0B B8")), "{written:?}");
}

/// Without power already; whoever waits no longer gets what was seen, and no other stop.
#[test]
fn an_interrupt_while_a_shaft_coasts_behind_its_stop_is_no_harder_stop() {
    let ramps = "ramps = { up_right = 999, down_right = 999, up_left = 999, down_left = 999 }";
    let bench = drive(&format!("{READY}, \"419\" = 400, \"549\" = 5, \"30\" = 210, \"637\" = 40, \"638\" = 0"), ramps);
    for choice in [StopChoice::QuickStop, StopChoice::Ramp] {
        let setpoint = acu("setpoint-frequency");
        // The first look at the encoder is under power, the next ones are behind it.
        let presses = ["01 65 01 E4 00 00 9C 40", "-01 65", ENCODER];
        let presses = &presses[2..];
        let presses = [&["-01 64 00 D9", "-01 64 00 D9", "-01 64 00 D9"], presses].concat();
        let came = held(&bench, &presses, choice, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.walk("operation-enabled").await?;
            motor.give(&setpoint, 40_000, "Hz").await?;
            motor.until_reached().await
        });
        let told = format!("{choice:?}: {:?} {:?}", came.ended, came.sent);
        assert_eq!((came.stop().acknowledged, came.stop().escalated), (true, None), "{told}");
        assert_eq!((came.stop().standing, came.turning), (Some(false), 1), "{told}");
    }
}

/// 0 is the same in both orders, so that nobody who takes it hears it twice.
#[test]
fn a_servo_that_takes_it_hears_a_word_of_0_once() {
    let run = antrieb("-v -a 1 --drive lxm05 statemachine disable-voltage").on(&servo("", "")).run();
    let words = run.sent().iter().filter(|hex| hex.starts_with("01 10 1B 02")).count();
    // Said first, and once more by what was seen then.
    assert_eq!(words, 2, "{}", run.err);
}

/// The first answer is garbled and the next one in time: that is enough for a ramp.
#[test]
fn a_garbled_answer_before_a_stop_costs_no_ramp() {
    for disturbed in 1..=3 {
        let garbled = format!("[[disturb]]\nonce = {disturbed}\nkind = \"garbled\"");
        for set in [RUNNING.to_owned(), RUNNING.replace("\"410\" = 15", "\"410\" = 0")] {
            let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&drive(&set, &garbled)).run();
            let word = run.sent().into_iter().find(|hex| hex.starts_with("01 06 01 9A")).unwrap();
            assert!(word.starts_with(DISABLE), "{disturbed} {set}: {}", run.err);
        }
    }
}

/// A no that passes tells nothing of who says it; another one does.
#[test]
fn only_a_no_that_stays_asks_whether_the_family_is_right() {
    for (model, named, hinted) in [("lxm05", "acu", true), ("acu", "lxm05", true), ("acu", "acu", false)] {
        let bench = format!("[[drive]]\nmodel = \"{model}\"\nbusy = {}\n", !hinted);
        let run = antrieb(&format!("-a 1 --drive {named} --yes statemachine enable")).on(&bench).run();
        assert_eq!(
            run.err.contains("is --drive right?") || run.out.contains("is --drive right?"),
            hinted,
            "{model} {named}: {}{}",
            run.out,
            run.err
        );
    }
}

/// Bits that the control word does not have decide on P.412; those that it has stand for themselves.
#[test]
fn the_word_of_a_ramp_is_the_commands_where_it_only_takes_bits_away() {
    for (stands, mode, word) in
        [(15, 2, 7), (7, 0, 7), (8, 1, 7), (3, 1, 7), (3, 2, 1), (11, 2, 9), (3, 0, 2), (8, 0, 2)]
    {
        let set = RUNNING.replace("\"410\" = 15, \"412\" = 1", &format!("\"410\" = {stands}, \"412\" = {mode}"));
        let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&drive(&set, "")).run();
        let first = run.sent().into_iter().find(|hex| hex.starts_with("01 06 01 9A")).unwrap();
        assert!(first.starts_with(&format!("01 06 01 9A 00 {word:02X}")), "{stands} {mode}: {first} {}", run.err);
    }
}
