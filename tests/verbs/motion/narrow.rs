//! What comes to a narrow place of a run: an answer on the way up, the last try of a stop, the first question behind it, the
//! moment in which a view opens or closes.

use super::keypad::{DRIVES, run};
use super::rig::{READY, RUNNING, drive, held, held_of, servo, servo_at};
use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice, look};
use antrieb::gate::Relief;
use antrieb::profile::Registry;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use serde_json::json;

const ONE: Span = Span::from_secs(1);
const ENABLE: &str = "01 06 01 9A 00 0F";
const WORD: &str = "01 06 01 9A";

fn silent_after(telegrams: usize, ms: u64) -> String {
    format!("[[drive.event]]\nafter_telegrams = {telegrams}\nsilent = \"{ms}ms\"")
}

/// The first word went out blind; then the drive tells that it listens to contacts.
#[test]
fn a_blind_word_that_took_the_power_of_contacts_is_told_and_one_that_did_not_is_none() {
    let ramps = "ramps = { up_right = 50, down_right = 20, up_left = 50, down_left = 20 }";
    for word in [3, 11] {
        let mut told = 0;
        for ms in (700..1_700).step_by(100) {
            let set = format!("\"410\" = {word}, \"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0");
            let bench = drive(&set, &format!("{ramps}\n[[drive.event]]\nat = \"1ms\"\nsilent = \"{ms}ms\""));
            let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&bench).run();
            let first = run.sent().into_iter().find(|hex| hex.starts_with(WORD)).unwrap();
            let took = run.err.contains("all contacts were opened");
            told += u32::from(took);
            // A quick stop opens S1IND; the ramp of the contacts keeps it.
            assert!(!took || first.starts_with("01 06 01 9A 00 02"), "{word} {ms}: {}", run.err);
            assert!(!run.out.contains("acknowledged") || run.exit == 0 || took, "{word} {ms}: {}{}", run.out, run.err);
        }
        assert!(told > 0, "{word}");
    }
}

/// One of the last answers before the enable comes twice, and the second time it says something else.
#[test]
fn two_drives_that_show_themselves_just_before_the_enable_are_not_enabled() {
    let bench = |rest: &str| drive(&format!("{READY}, \"30\" = 240"), rest).replace("115200", "19200");
    let walk = async |motor: &mut Motor<'_, '_>| motor.walk("operation-enabled").await;
    let whole = drive(&format!("{READY}, \"30\" = 240"), "");
    let look = held(&whole, &[], StopChoice::Keep, Span::ZERO, async |_| Ok(())).sent.len();
    let sent = held(&whole, &[], StopChoice::Keep, Span::ZERO, walk).sent;
    let last = sent.iter().position(|hex| hex.starts_with(ENABLE)).unwrap() - look;
    for (once, code) in [(last - 1, "garbled.two_answers"), (last + 20, "")] {
        let twin = format!("[[disturb]]\nonce = {once}\nkind = \"twin\"\nby = \"1ms\"");
        with_motor(
            "acu",
            &bench(&twin),
            async |session, target, permit| {
                let walked = Motor::new(session, target, permit, None).walk("operation-enabled").await;
                assert_eq!(walked.err().map_or("".into(), |failure| failure.code), code, "{once}");
            },
            |bench| assert_eq!(bench.totals().energised, u64::from(code.is_empty()), "{once}"),
        );
    }
}

/// What trips before it is held has no minute of diagnosis, because it was never seen to run: its view closes once no key repeats.
#[test]
fn a_run_that_was_never_held_closes_its_view_as_soon_as_no_key_repeats() {
    let (model, keys, line) = DRIVES[1];
    let soon = |keys: &str, line: &str| {
        let seen = run((model, keys, line), "--view", &mut |_, _, _| {});
        let ended = seen.news.iter().find(|news| news.phase == "ended").unwrap();
        let stays = seen.at.as_micros() as i64 - ended.t.raw;
        assert!(seen.failure.is_some() && stays < 3_000_000, "{stays} us behind its end: {:?}", seen.failure);
        assert!(seen.news.iter().all(|news| news.phase != "held"), "{:?}", seen.news);
    };
    soon(&format!("{keys}\nenable = false"), line);
    let trips = format!("{keys}\n[[drive.event]]\nwhen = \"above 1Hz\"\nfault = \"F0500\"");
    soon(&trips, &format!("{line} --until reached"));
}

/// A way that takes longer than any state, at an even speed; and one that ends before its target.
#[test]
fn an_even_way_to_a_target_is_waited_for_and_a_shaft_that_stands_before_it_is_not() {
    let travel = |speed: i64, guide: &str| {
        let bench = servo(&format!("RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000, PPn_target = {speed}"), guide);
        let registry = Registry::open(&[]).unwrap();
        let family = registry.family("lxm05").unwrap();
        let mode = family.modes.iter().find(|mode| !mode.starts.is_empty()).unwrap().clone();
        let target = family.param_or_unknown(mode.setpoint);
        held_of("lxm05", &bench, &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
            motor.prepare(&mode);
            motor.walk("operation-enabled").await?;
            motor.enter().await?;
            motor.give(&target, 163_840, "usr").await?;
            let start = mode.starts.iter().find(|start| start.slug == "relative").unwrap();
            motor.travel(start).await
        })
    };
    let far = travel(60, "");
    assert!(far.ended.result.is_ok(), "{:?}", far.ended);
    assert!(far.took > Tick::ZERO + Span::from_secs(8), "{:?}", far.took);
}

/// The line is gone for a moment at any telegram of the beginning of a ramp: it keeps its power until it stands.
#[test]
fn a_ramp_of_which_anything_is_lost_takes_no_power_from_a_turning_shaft() {
    const ZERO: &str = "01 10 1B 1A 00 02 04 00 00 00 00";
    let run = |rest: &str| {
        let bench = servo("RAMPacc = 3000, RAMPdecel = 120, RAMPn_max = 3000", rest);
        held_of("lxm05", &bench, &[], StopChoice::Ramp, Span::ZERO, async |motor| servo_at(motor, 600, Some(ONE)).await)
    };
    let clean = run("");
    let first = clean.sent.iter().skip(20).position(|hex| hex.starts_with(ZERO)).unwrap() + 20;
    let mut ramps = 0;
    for later in 1..9 {
        let came = run(&silent_after(first + later, 1_700));
        let word = came.sent.iter().skip(first).position(|hex| hex.starts_with("01 10 1B 02")).unwrap();
        assert!(came.stop().acknowledged && came.stop().escalated.is_none(), "{later}: {:?}", came.ended);
        // Where its mode is not told it is a quick stop.
        if !came.sent[first + word].starts_with("01 10 1B 02 00 02 04 00 00 00 02") {
            let ramped = came.at[first + word].since(came.at[first]);
            assert!(ramped > Span::from_millis(4_500), "{later}: {ramped} {:?}", &came.sent[first..]);
            ramps += 1;
        }
    }
    assert!(ramps > 2, "{ramps}");
}

/// Proven already; what is only reported costs whoever waits no more than one look, and what is owed before it.
#[test]
fn behind_a_proven_stop_a_line_that_dies_holds_nobody_up() {
    let line = "-v --timeout 4s -b 115200 -a 1 --drive acu statemachine disable-voltage";
    let clean = antrieb(line).on(&drive(RUNNING, "")).run();
    let (sent, (_, end)) = (clean.sent().len(), witness::left().unwrap());
    for dead in sent - 3..sent {
        let run = antrieb(line).on(&drive(RUNNING, &silent_after(dead, 600_000))).run();
        let more = witness::left().unwrap().1.since(end);
        assert!(more < Span::from_secs(6) || !run.out.contains("running  no"), "{dead} of {sent}: {more} {}", run.err);
    }
}

/// Without power it coasts for longer than a stop that proves nothing is waited for, and becomes slower all the time.
#[test]
fn a_shaft_that_coasts_for_long_behind_a_stop_is_waited_for() {
    let ramps = "ramps = { up_right = 999, down_right = 100, up_left = 999, down_left = 100 }";
    let set = "\"484\" = 300, \"419\" = 400, \"549\" = 5, \"30\" = 210, \"424\" = 100, \"425\" = 100, \"637\" = 60, \"638\" = 0";
    let bench = drive(&RUNNING.replace("\"484\" = 10", set), ramps);
    with_motor(
        "acu",
        &bench.replace("baud = 115200\n", ""),
        async |session, target, permit| {
            session.rest(Span::from_secs(2)).await.unwrap();
            let begun = session.now();
            let mut motor = Motor::new(session, target, permit, None);
            motor.relieving = Some(begun);
            motor.relieve(Relief::QuickStop).await.unwrap();
            assert!(session.now().since(begun) > Span::from_secs(14), "{}", session.now().since(begun));
            assert_eq!(session.bench().unwrap().totals().turning, 0);
        },
        |bench| assert_eq!(bench.totals().energised, 0),
    );
}

/// A setpoint that stands is looked at once.
#[test]
fn a_setpoint_that_is_reached_takes_one_look() {
    let setpoint = Registry::open(&[]).unwrap().family("acu").unwrap().role("setpoint-frequency").unwrap().clone();
    let came = held(&drive(READY, ""), &[], StopChoice::Coast, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.walk("operation-enabled").await?;
        motor.give(&setpoint, 2_000, "Hz").await?;
        motor.until_reached().await?;
        motor.give(&setpoint, 2_000, "Hz").await?;
        motor.until_reached().await?;
        motor.give(&setpoint, 2_000, "Hz").await
    });
    let given: Vec<_> =
        came.sent.iter().enumerate().filter(|(_, hex)| hex.starts_with("01 65 01 E4 00 00 07 D0")).collect();
    let &[_, (second, _), (third, _)] = &given[..] else { panic!("{given:?}") };
    let looks = came.sent[second..third].iter().filter(|hex| hex.starts_with("01 03 01 9B")).count();
    assert_eq!(looks, 1, "{:?}", came.sent);
}

/// It refuses its control word, and nobody else starts or stops it.
#[test]
fn a_stop_that_the_control_word_does_not_bring_is_blamed_on_no_contacts() {
    let refuses = "[[drive.event]]\nwhen = \"above 19Hz\"\nrefuses = 410";
    let came = held(&drive(READY, refuses), &[], StopChoice::QuickStop, Span::ZERO, async |motor| {
        super::rig::run_at_20_hz(motor, Some(ONE)).await
    });
    let note = came.stop().note.as_ref().map(|note| note.en.to_string()).unwrap_or_default();
    assert!(!came.stop().acknowledged && note.contains("watchdog") && !note.contains("keypad"), "{note}");
}

/// A ramp of contacts that nobody acknowledges is tried as often as any other stop, and the last time all of them open.
#[test]
fn the_fifth_try_opens_all_contacts() {
    let contacts = "\"412\" = 2, \"434\" = 2, \"484\" = 10, \"418\" = 0";
    let dies = "[[drive.event]]\nwhen = \"above 5Hz\"\nsilent = \"600s\"";
    let came = held(&drive(contacts, dies), &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.contacts(3).await?;
        motor.hold(Some(Span::from_secs(5)), async |_: &mut Motor<'_, '_>, _| Ok(())).await
    });
    let words: String =
        came.sent.iter().filter_map(|hex| hex.strip_prefix("01 06 01 9A 00 0")?.chars().next()).collect();
    let (ramp, _) = words.split_once('0').unwrap();
    assert_eq!(ramp.matches('1').count(), 5, "{words}");
}

/// A drive without power hears the stop that somebody gives it like any other.
#[test]
fn a_stop_goes_out_to_a_drive_that_has_nothing_to_stop() {
    for (verb, word) in [("disable", "07"), ("quick-stop", "02"), ("disable-voltage", "00")] {
        let run = antrieb(&format!("-v -b 115200 -a 1 --drive acu statemachine {verb}")).on(&drive(READY, "")).run();
        let words: Vec<_> = run.sent().into_iter().filter(|hex| hex.starts_with(WORD)).collect();
        let meant = words.iter().filter(|hex| hex.starts_with(&format!("{WORD} 00 {word}"))).count();
        assert!(meant >= 2 && meant == words.len(), "{verb}: {words:?}");
    }
}

/// Contacts start it and nobody obeys us: that is told, and no further stop is sent that would not be obeyed either.
#[test]
fn a_stop_that_is_not_obeyed_is_followed_by_no_other() {
    let bench = drive(
        "\"412\" = 0, \"434\" = 2, \"484\" = 10, \"418\" = 10",
        "readings = { other_modes = \"contacts\" }\nramps = { up_right = 50, down_right = 20 }",
    );
    let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine quick-stop").on(&bench).json();
    assert!(run.error()["message"].as_str().unwrap().contains("but it is not obeyed"), "{:#}", run.value);
    assert_eq!(run.data("/stop"), &json!(null), "{:#}", run.value);
    assert!(!run.err.contains(&format!("> {WORD} 00 00")), "{}", run.err);
}

#[test]
fn who_is_busy_is_not_taken_for_another_drive() {
    for (bench, is_another) in [("model = \"foreign\"\nbusy = true", false), ("model = \"lxm05\"", true)] {
        with_motor(
            "acu",
            &format!("[[drive]]\n{bench}\n"),
            async |session, target, _permit| {
                let failure = look(session, target).await.unwrap_err();
                let hint = failure.hint.as_ref().map(|hint| hint.en.to_string()).unwrap_or_default();
                assert_eq!(hint.contains("tells the state of every acu"), is_another, "{failure:?}");
            },
            |_| {},
        );
    }
}

/// Nobody answers: said five times, in one order, because 0 is the same in both.
#[test]
fn a_word_of_0_is_said_to_a_silent_servo_no_more_than_to_any_other() {
    let silent = servo("", "[[drive.event]]\nat = \"0ms\"\nsilent = \"600s\"");
    for (verb, times) in [("disable-voltage", 5), ("quick-stop", 10)] {
        let run = antrieb(&format!("-v -a 1 --drive lxm05 statemachine {verb}")).on(&silent).run();
        let sent = run.sent();
        let said = sent.iter().take_while(|hex| hex.starts_with("01 10 1B 02")).count();
        assert_eq!(said, times, "{verb}: {sent:?}");
    }
}

/// A drive that goes on without its enable being seen would be kept; the reason is told for that run as for any other.
#[test]
fn what_is_missing_is_told_of_a_run_that_was_to_be_kept_too() {
    for choice in ["keep", "ramp"] {
        let gone = "[[drive.event]]\nwhen = \"above 9Hz\"\nenable = false";
        let line = format!("-b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 5s --on-exit {choice}");
        let run = antrieb(&line).on(&drive(READY, gone)).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.left_run", "{choice}");
        assert!(run.error()["hint"].as_str().is_some_and(|hint| hint.contains("STOA")), "{choice}: {}", run.error());
    }
}
