//! What proves something and what does not, look by look: control, power, standstill, and who is there.

use super::rig::{READY, RUNNING, alone, drive, held, run_at_20_hz};
use super::runs::with_motor;
use crate::run::antrieb;
use antrieb::drive::motion::{Motor, StopChoice, look};
use antrieb::profile::Registry;
use antrieb::tick::Span;
use serde_json::json;

/// The setpoint 20 Hz, and P.410.
const REFRESH: &str = "01 65 01 E4 00 00 07 D0";
const WORD: &str = "01 06 01 9A ";

/// Remote in the status word falls with the data set, a second before anybody asks for P.412.
#[test]
fn control_that_the_status_word_shows_as_gone_is_missed_at_the_next_look() {
    let family = Registry::open(&[]).unwrap().family("acu").unwrap();
    let (setpoint, set) = (family.role("setpoint-frequency").unwrap(), family.param(414).unwrap());
    let bench = drive(&format!("{READY}, \"412@2\" = 0"), "");
    let came = held(&bench, &[], StopChoice::Ramp, Span::ZERO, async |motor: &mut Motor<'_, '_>| {
        motor.walk("operation-enabled").await?;
        motor.give(setpoint, 2_000, "Hz").await?;
        motor.until_reached().await?;
        let mut rounds = 0;
        let each = async |motor: &mut Motor<'_, '_>, _| {
            rounds += 1;
            if rounds == 2 {
                motor.set(set, 2).await?;
            }
            motor.refresh(setpoint, 2_000).await
        };
        motor.hold(Some(Span::from_secs(30)), each).await
    });
    let chosen = came.sent.iter().rposition(|hex| hex.starts_with("01 06 01 9E 00 02")).unwrap();
    let later = came.sent[chosen..].iter().filter(|hex| hex.starts_with(REFRESH)).count();
    assert_eq!(later, 1, "{:?}", &came.sent[chosen..]);
}

/// The stator shows 0 Hz then; what the encoder shows is the shaft.
#[test]
fn a_shaft_that_loses_its_power_between_the_last_looks_is_seen_to_coast() {
    let line = "-v -b 115200 -a 1 --yes sollwert 20Hz --enable --until reached --hold --duration 50ms --on-exit keep";
    let ramps = "ramps = { up_right = 50, down_right = 20, up_left = 50, down_left = 20 }";
    let sent = antrieb(line).on(&drive(READY, ramps)).exits(0).sent();
    let kept = antrieb(line).on(&drive(READY, ramps)).json();
    assert_eq!(kept.data("/stop/note"), &json!("the drive keeps running, as asked for"), "{:#}", kept.value);
    let held = sent.iter().rposition(|hex| hex.starts_with(REFRESH)).unwrap();
    for after in held + 2..sent.len() {
        let lost = format!("{ramps}\n[[drive.event]]\nafter_telegrams = {after}\nenable = false");
        let run = antrieb(line).on(&drive(READY, &lost)).json();
        assert_eq!(run.data("/standing"), &json!(false), "{after} of {}: {:#}", sent.len(), run.value);
    }
}

/// Whatever is lost from the stop on, and wherever: what was seen stays seen, and what was not is not claimed.
#[test]
fn an_end_that_is_cut_off_at_any_telegram_claims_what_was_seen() {
    let ramps = "ramps = { up_right = 50, down_right = 40, up_left = 50, down_left = 40 }";
    let set = format!("{READY}, \"217\" = 0, \"218\" = 0, \"424\" = 40, \"638\" = \"0.3\"");
    for choice in [StopChoice::Ramp, StopChoice::QuickStop] {
        let cut_off = |after: usize| {
            let dies = format!("{ramps}\n[[drive.event]]\nafter_telegrams = {after}\nsilent = \"600s\"");
            let mut told = None;
            with_motor(
                "acu",
                &drive(&set, &dies).replace("115200", "19200"),
                async |session, target, permit| {
                    let mut motor = Motor::new(session, target, permit, None);
                    let work = async |motor: &mut Motor<'_, '_>| run_at_20_hz(motor, Some(Span::from_millis(50))).await;
                    let ended = motor.run(true, choice, work).await;
                    let stands = motor.stands_at_the_end().await.ok().flatten();
                    told = Some((ended, stands));
                },
                |_| {},
            );
            told.unwrap()
        };
        let (mut seen, mut unseen, mut after) = (0, 0, 20);
        while seen < 4 && after < 400 {
            let (ended, stands) = cut_off(after);
            if let Some(stop) = &ended.stop {
                let told = format!("{choice:?}, dead after {after}: {stands:?} {ended:?}");
                assert!(!stop.acknowledged || stop.standing == Some(true), "{told}");
                assert!(stop.standing != Some(true) || stands == Some(true), "{told}");
                (seen, unseen) = (seen + u8::from(stop.acknowledged), unseen + u8::from(!stop.acknowledged));
            }
            after += 1;
        }
        assert!(seen == 4 && unseen > 5, "{choice:?}: {seen} {unseen} {after}");
    }
}

/// Which word goes first is decided by the control mode in force: that of the active data set.
#[test]
fn disable_says_first_what_the_control_mode_in_force_makes_of_it() {
    for (set, word) in [
        ("\"410\" = 3, \"412@1\" = 1, \"412@2\" = 2, \"414\" = 2", "00 01"),
        ("\"410\" = 3, \"412@1\" = 2, \"412@2\" = 1, \"414\" = 2", "00 07"),
        ("\"410\" = 6, \"412\" = 1", "00 07"),
        ("\"410\" = 6, \"412\" = 2", "00 00"),
        ("\"410\" = 6, \"412\" = 0", "00 02"),
    ] {
        let run = antrieb("-v -b 115200 -a 1 --drive acu statemachine disable").on(&drive(set, "")).run();
        let sent = run.sent();
        let first = sent.iter().find_map(|hex| hex.strip_prefix(WORD)?.get(..5));
        assert_eq!(first, Some(word), "{set}: {}", run.err);
    }
}

/// Two answers that differ were heard; that is long ago, and questions are answered again. Yet whatever is started there could
/// be started twice.
#[test]
fn where_two_answers_differed_nothing_is_enabled_later_either() {
    let bench = format!("{}[[disturb]]\nonce = 2\nkind = \"twin\"\n", drive(READY, "")).replace("115200", "19200");
    with_motor(
        "acu",
        &bench,
        async |session, target, permit| {
            let mut motor = Motor::new(session, target, permit, None);
            assert_eq!(motor.walk("switched-on").await.unwrap_err().code, "garbled.two_answers");
            session.rest(Span::from_secs(120)).await.unwrap();
            assert_eq!(look(session, target).await.unwrap().state, "switch-on-disabled");
            let mut motor = Motor::new(session, target, permit, None);
            assert_eq!(motor.walk("operation-enabled").await.unwrap_err().code, "garbled.two_answers");
        },
        |bench| assert_eq!(bench.totals().energised, 0),
    );
}

/// A drive that holds its shaft for long (P.638) is asked how long that takes, and one that turns on is told as that: whoever is
/// ready to wait for longer gets no other stop, and no other reason.
#[test]
fn a_longer_wait_makes_no_stop_worse() {
    for wait in ["", "--wait 9s", "--wait 30s", "--wait 5min"] {
        let holds = drive(&format!("{RUNNING}, \"638\" = 20"), "");
        let run = alone(&format!("statemachine disable {wait}"), &holds).exits(0);
        assert_eq!(run.data("/running"), &json!(false), "{wait}: {:#}", run.value);
        let lifted = drive(&RUNNING.replace("\"418\" = 0", "\"418\" = \"3.5\""), "");
        let run = alone(&format!("sollwert 0 {wait}"), &lifted).exits(1);
        assert_eq!((&run.error()["code"], run.data("/running")), (&json!("no.not_standing"), &json!(true)), "{wait}");
    }
}
