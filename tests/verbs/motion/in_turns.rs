//! What a stop gives each of several drives, and what one alone has of it: the first word in a round, then turns at the line.

use super::rig::{RUNNING, ran, sent};
use crate::run::{Document, antrieb};
use antrieb::tick::Span;

/// A drive that runs up to 10 Hz: a quick stop by so many hertz a second, and more.
fn drive(address: u8, quick: &str, more: &str) -> String {
    format!(
        "[[drive]]\nmodel = \"acu\"\naddress = {address}\nbaud = 19200\n\
         set = {{ {RUNNING}, \"424\" = \"{quick}\", \"425\" = \"{quick}\" }}\n{more}\n"
    )
}

const DEAD: &str = "[[drive.event]]\nat = \"0s\"\nsilent = \"10min\"";

/// A verb on drives that have run for a second.
fn running(line: &str, bench: &str) -> Document {
    ran(Span::from_secs(1), &format!("-v -b 19200 {line}"), bench).json()
}

#[test]
fn who_is_silent_has_no_more_than_half_of_the_time() {
    for named in ["", "--drive acu"] {
        let run = running(
            &format!("-a 1,2 {named} statemachine quick-stop"),
            &[drive(1, "10", DEAD), drive(2, "1", "")].concat(),
        );
        let to =
            |address: &str| sent(&run.err).iter().filter(|(at, hex)| *at < 9_000.0 && hex.starts_with(address)).count();
        // 500 ms each time, and 20 ms for who answers.
        assert!(to("02 ") > 2 * to("01 "), "{named}: {} {}", to("01 "), to("02 "));
    }
}

/// A lost answer in the round makes no quick stop of a ramp, and is no reason to speak to other families.
#[test]
fn what_was_not_told_in_the_round_is_asked_again_before_it_is_a_quick_stop() {
    for lost in 2..6 {
        let once = format!("[[disturb]]\nonce = {lost}\nkind = \"lost\"\n");
        let bench = [once, drive(1, "10", ""), drive(2, "10", "")].concat();
        let run = running("-a 1,2 --drive acu statemachine disable", &bench);
        assert!(
            !run.err.contains("in place of the ramp") && !run.err.contains("is --drive right"),
            "{lost}: {}",
            run.err
        );
        assert_eq!(run.exit, 0, "{lost}: {:#}", run.value);
    }
}

/// How long each word to a drive that does not answer is waited for, in ms, until the last of them.
fn waits(named: &str) -> Vec<u32> {
    let run = running(
        &format!("-a 1,2 {named} statemachine quick-stop"),
        &[drive(1, "10", DEAD), drive(2, "10", DEAD)].concat(),
    );
    let all = sent(&run.err);
    let is_word = |hex: &str| hex.starts_with("01 06") || hex.starts_with("01 10");
    let words = all.windows(2).filter(|pair| is_word(&pair[0].1));
    words.map(|pair| ((pair[1].0 - pair[0].0) / 10.0).round() as u32 * 10).collect()
}

/// Three words are said twice for a short time; one that is known is waited for as long as an answer may take.
#[test]
fn others_wait_for_a_silent_drive_for_a_short_time_only_at_first() {
    let (unnamed, named) = (waits(""), waits("--drive acu"));
    assert_eq!(unnamed[1..8], [260, 260, 250, 260, 510, 500, 510], "{unnamed:?}");
    assert!(named[1..5].iter().all(|&wait| wait == 500), "{named:?}");
}

/// Only where the echo of a line could pass for the answer to a word something is asked for its own sake, and once: who is
/// there, or behind the first word of a family that is named the shaft.
#[test]
fn a_line_is_sounded_once_and_only_where_nothing_else_is_asked_first() {
    let bench = [drive(1, "10", ""), drive(2, "10", ""), drive(3, "10", "")].concat();
    for (line, sounds, asked) in [
        ("-a 1-3 statemachine quick-stop", "2B", 3),
        ("-a 1-3 --drive acu statemachine quick-stop", "2B", 0),
        ("-a 1-3 --drive acu statemachine quick-stop", "64 00 D2", 1),
        ("-a 1-3 --drive acu sollwert 0Hz", "2B", 0),
    ] {
        let all = sent(&running(line, &bench).err);
        let word = |hex: &str| ["03 06 01 9A", "03 65 01 E4"].iter().any(|word| hex.starts_with(word));
        let before = all.iter().take_while(|(_, hex)| !word(hex));
        assert_eq!(before.filter(|(_, hex)| hex[3..].starts_with(sounds)).count(), asked, "{line}: {all:?}");
    }
}

#[test]
fn what_is_said_of_a_drive_in_the_round_names_it() {
    let bench = [drive(1, "10", ""), drive(2, "10", "")].concat();
    let run = running("-a 1,2 --drive lxm05 statemachine quick-stop", &bench);
    for address in [1, 2] {
        let named = format!("address {address}: the drive refuses the stop of the family lxm05");
        assert_eq!(run.err.matches(&named).count(), 1, "{}", run.err);
    }
}

/// Nobody waits, so nothing is hurried: behind the state it is asked at once who has control.
#[test]
fn one_drive_alone_is_asked_for_its_shaft_when_it_is_known_what_it_obeys() {
    let all = sent(&running("-a 1 --drive acu statemachine quick-stop", &drive(1, "10", "")).err);
    let place = |begins: &str| all.iter().position(|(_, hex)| hex.starts_with(begins)).unwrap();
    // Besides the look that tells the answer from an echo.
    let shaft = all.iter().rposition(|(_, hex)| hex.starts_with("01 64 00 D2")).unwrap();
    assert!(place("01 03 01 9B") < place("01 03 61 9C") && place("01 03 61 9C") < shaft, "{all:?}");
    assert!(place("01 03 61 9C") < place("01 64 00 D9"), "{all:?}");
}

/// A proof of no power is none for a shaft that turns without it: the strongest stop goes out too, and is told.
#[test]
fn a_shaft_that_turns_without_power_gets_the_stronger_stop() {
    let turning = drive(1, "10", "").replace("\"410\" = 15", "\"217\" = 5, \"410\" = 0");
    let run = running("-a 1 statemachine quick-stop", &turning);
    assert_eq!((run.exit, run.data("/stop/choice"), run.data("/stop/standing")), (8, &"coast".into(), &false.into()));
}

/// The setting says that the drive takes the power when the shaft stands; that is no standstill where the look behind it is lost.
#[test]
fn a_standstill_that_only_a_setting_promises_is_none_where_the_look_behind_it_is_lost() {
    let mut unproven = 0;
    for telegrams in 30..44 {
        let silent = format!("[[drive.event]]\nafter_telegrams = {telegrams}\nsilent = \"10min\"");
        let ramps = "ramps = { up_right = 50, down_right = 5, up_left = 50, down_left = 5 }\n";
        let run = antrieb("-b 19200 -a 1 --drive acu statemachine disable").on(&drive(
            1,
            "10",
            &(ramps.to_owned() + &silent),
        ));
        let run = run.json();
        if run.data("/running") == false && run.data("/standing").is_null() {
            unproven += 1;
            assert_eq!(run.exit, 8, "{telegrams}: {:#}", run.value);
        }
    }
    assert!(unproven >= 4, "{unproven}");
}

/// Where P.412 makes contacts of the control word, no command goes out in its place: it would close some.
#[test]
fn beside_others_too_a_drive_that_obeys_contacts_gets_no_command() {
    let contacts = drive(1, "10", "").replace("\"410\" = 15, \"412\" = 1", "\"410\" = 3, \"412\" = 2");
    for verb in ["disable", "quick-stop"] {
        let run = running(&format!("-a 1,2 statemachine {verb}"), &[contacts.clone(), drive(2, "10", "")].concat());
        let all = sent(&run.err);
        let words: Vec<_> = all.iter().filter_map(|(_, hex)| hex.strip_prefix("01 06 01 9A ")?.get(..5)).collect();
        assert!(words.iter().all(|word| ["00 02", "00 01", "00 00"].contains(word)), "{verb}: {words:?}");
        assert_eq!(words.last(), Some(&"00 00"), "{verb}");
        assert!(all.iter().any(|(_, hex)| hex.starts_with("01 03 61 9C")), "{verb}: P.412 is asked");
    }
}

/// A word to one drive alone is said again as soon as an answer could have come, five times, and so is a zero; behind its second
/// time it waits as long as a slow drive may take.
#[test]
fn one_drive_alone_is_told_five_times_without_a_pause() {
    for (line, word) in [("statemachine quick-stop", "01 06 01 9A"), ("sollwert 0Hz", "01 65 01 E4")] {
        let all = sent(&running(&format!("-a 1 --drive acu {line}"), &drive(1, "10", DEAD)).err);
        let words =
            all.iter().skip_while(|(_, hex)| !hex.starts_with(word)).take_while(|(_, hex)| hex.starts_with(word));
        let at: Vec<f64> = words.map(|(at, _)| *at).collect();
        assert_eq!(at.len(), 5, "{line}: {all:?}");
        for (pair, least) in at.windows(2).zip([250.0, 500.0, 250.0, 250.0]) {
            assert!((least..least + 10.0).contains(&(pair[1] - pair[0])), "{line}: {at:?}");
        }
    }
}

/// Who stands behind a cabinet that is switched off waits for no more than the words to it.
#[test]
fn nobody_who_is_named_waits_for_a_question_to_a_silent_one() {
    let dead = (1..=5).map(|address| drive(address, "10", DEAD)).collect::<String>();
    let run = running("-a 1-6 --drive acu statemachine quick-stop", &[dead, drive(6, "10", "")].concat());
    let first =
        |address: &str| sent(&run.err).iter().find(|(_, hex)| hex.starts_with(address)).map(|(at, _)| *at).unwrap();
    assert!(first("06 ") - first("01 ") < 1_000.0, "{}", run.err);
}
