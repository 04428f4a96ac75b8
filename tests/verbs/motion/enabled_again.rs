//! Somebody else enables a drive in the last moments of what took its power: it is stopped once more, and told as it is then.

use super::events::left;
use super::rig::{RUNNING, drive, ran, sent};
use crate::run::antrieb;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

const OFF: &str = "01 06 01 9A 00 00";
const AGAIN: &str = "it was enabled again behind its stop, by somebody else: the stop went out again";

/// Enabled at any of the last telegrams; behind the last of them nobody looks any more. How often that was told.
fn enabled_at_the_end(delay: &str) -> usize {
    let quiet = format!("{RUNNING}, \"217\" = 0, \"218\" = 0");
    let bench = |event: &str| drive(&quiet, event).replace("\"1ms\"", delay);
    let line = "-v -b 115200 -a 1 --drive acu statemachine disable-voltage";
    let calm = antrieb(line).on(&bench("")).exits(0).sent();
    let proof = calm.iter().rposition(|hex| hex.starts_with(OFF)).unwrap() + 2;
    let mut told = 0;
    for after in proof..calm.len() {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"410\" = 15 }}");
        let run = antrieb(line).on(&bench(&event)).json();
        let seen = format!("{delay} {after} of {}: {:#} {}", calm.len(), run.value, run.err);
        let words = sent(&run.err).iter().skip(after).filter(|(_, hex)| hex.starts_with(OFF)).count();
        let is_told = run.data("/notes").to_string().contains(AGAIN);
        assert_eq!(is_told, words > 0, "what is told went out: {seen}");
        assert_eq!((left().1, run.data("/running").as_bool()), (0, Some(false)), "{seen}");
        told += usize::from(is_told);
    }
    told
}

#[test]
fn a_drive_that_is_enabled_again_while_its_shaft_is_looked_at_is_stopped_once_more() {
    let told = enabled_at_the_end("\"40ms\"");
    assert!(told > 3, "{told}");
}

/// Where all answers come at once the word before is a moment ago, in which no stop is said again: that moment is waited for.
#[test]
fn a_drive_that_answers_at_once_and_is_enabled_again_is_stopped_once_more() {
    let told = enabled_at_the_end("\"1ms\"");
    assert!(told > 3, "{told}");
}

/// As control goes back, the word that takes the power goes out once more: a shaft that somebody else has turned meanwhile coasts behind it.
#[test]
fn a_shaft_that_the_giving_back_leaves_coasting_is_not_told_as_one_that_stands() {
    let quiet = "\"412\" = 44, \"434\" = 2, \"484\" = 10, \"418\" = 0";
    let shows = "readings = { coast_shows = \"shaft\" }\nramps = { up_right = 20, down_right = 20, up_left = 50, down_left = 5 }\n";
    let bench = |event: &str| drive(quiet, &format!("{shows}{event}")).replace("\"1ms\"", "\"100ms\"");
    let line = "-v --yes -b 115200 -a 1 --drive acu sollwert 10Hz --take-control --jog 1s";
    let calm = antrieb(line).on(&bench("")).exits(0).sent();
    let proof = calm.iter().rposition(|hex| hex.starts_with("01 06 61 9C 00 2C")).unwrap() - 12;
    let mut turned = 0;
    for after in proof..calm.len() {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"410\" = 15, \"484\" = 3000 }}");
        let run = antrieb(line).on(&bench(&event)).json();
        let (mut now, at) = witness::left().unwrap();
        now.advance(at);
        let turning = now.totals().turning;
        let seen = format!("{after} of {}: {turning} {:#} {}", calm.len(), run.value, run.err);
        turned += usize::from(turning > 0);
        assert!(turning == 0 || run.exit != 0, "{seen}");
    }
    assert!(turned > 0);
}

/// One reply is lost, whichever: behind its last look no verb that stops keeps the line.
#[test]
fn a_stop_looks_once_more_behind_what_its_last_look_left_owed() {
    for (drive, verb, most) in [
        ("model = \"lxm05\"", "statemachine disable", 150),
        ("model = \"acu\"", "statemachine disable", 150),
        ("model = \"acu\"", "statemachine quick-stop", 150),
        ("model = \"acu\"\nset = { 412 = 1 }", "sollwert 0", 150),
        // An answer that may be a copy is held for so long.
        ("model = \"acu\"\nprotocol = \"vabus\"", "statemachine disable", 700),
    ] {
        for nth in 6..26 {
            let lost = format!("[[disturb]]\nonce = {nth}\nkind = \"lost\"");
            let bench = format!("[[drive]]\n{drive}\naddress = 1\nreply_delay = \"1ms\"\n{lost}\n");
            let protocol = if drive.contains("vabus") { "--protocol vabus" } else { "" };
            let run = antrieb(&format!("-a 1 {protocol} --trace {{dir}}/line.txt {verb}")).on(&bench).run();
            let (_, at) = witness::left().unwrap();
            let trace = std::fs::read_to_string(run.directory().join("line.txt")).unwrap();
            let last = trace.lines().rev().find_map(|line| line.split_once(" > ")).unwrap().0;
            let blind = at.since(Tick::ZERO + Span::from_micros(last.trim().parse().unwrap()));
            assert!(blind < Span::from_millis(most), "{drive} {verb} {nth}: {blind}\n{}\n{trace}", run.out);
        }
    }
}

/// The line is kept as long as a reply is owed, whoever leaves: what the drive does in that time is seen. (Behind the answer to a fence
/// none is: stations answer in order.)
#[test]
fn nobody_looks_for_the_last_time_while_a_reply_is_owed() {
    for every in [7, 9, 10, 13] {
        let disturbed = format!("[[disturb]]\nevery = {every}\nkind = \"late\"\nby = \"900ms\"");
        let bench = format!("[[drive]]\nmodel = \"lxm05\"\naddress = 3\nreply_delay = \"1ms\"\n{disturbed}\n");
        antrieb("-a 3 --drive lxm05 --yes sollwert 300rpm --jog 1s").on(&bench).exits(0);
        let (mut line, at) = witness::left().unwrap();
        let owed = line.advance(at + Span::from_secs(2));
        assert!(owed.is_empty(), "{every}: {owed:?} behind {at:?}");
    }
}

/// One drive of two stands early, and somebody enables it again while the other is proven: it is stopped once more, and that is told.
#[test]
fn a_drive_that_was_proven_early_is_looked_at_once_more_behind_the_others() {
    let one = |address: u8, ramp: u16, rest: &str| {
        let ramps = format!("ramps = {{ up_right = 50, down_right = {ramp}, up_left = 50, down_left = {ramp} }}");
        drive(RUNNING, &format!("{ramps}\n{rest}"))
            .replace("model = \"acu\"", &format!("model = \"acu\"\naddress = {address}"))
            .replace("\"1ms\"", "\"5ms\"")
    };
    let line = |verb: &str, event: &str| {
        let bench = format!("{}{}", one(1, 100, event), one(2, 2, ""));
        let run =
            ran(Span::from_secs(8), &format!("-v -b 115200 -a 1,2 --drive acu statemachine {verb}"), &bench).json();
        let (mut bench, end) = witness::left().unwrap();
        bench.advance(end + Span::from_secs(60));
        (run, bench.totals().turning, end)
    };
    let mut told = 0;
    for verb in ["disable", "quick-stop"] {
        let (calm, _, end) = line(verb, "");
        assert_eq!(calm.exit, 0, "{:#}", calm.value);
        let begun = 8_100;
        for at in (begun + 300..end.as_micros() / 1000 - 150).step_by(400) {
            let event = format!("[[drive.event]]\nat = \"{at}ms\"\nset = {{ \"410\" = 15 }}");
            let (run, turning, _) = line(verb, &event);
            let seen = format!("{verb} {at} of {end:?}: {:#}", run.value);
            assert_eq!(turning, 0, "{seen}");
            told += usize::from(run.data("/drives/0/motion/notes").to_string().contains(AGAIN));
        }
    }
    assert!(told > 2, "{told}");
}

/// Somebody enables one drive of a slow group in its closing rounds, and another one while that is stopped again: neither is missed.
#[test]
fn all_of_a_group_are_looked_at_behind_each_that_is_stopped_again() {
    let group = |last: &str, first: &str| -> String {
        let one = |address: u8| {
            let event = [first, "", "", last][usize::from(address) - 1];
            drive(&format!("{RUNNING}, \"424\" = 5000, \"425\" = 5000"), event)
                .replace("model = \"acu\"", &format!("model = \"acu\"\naddress = {address}"))
                .replace("\"1ms\"", "\"60ms\"")
        };
        (1..=4).map(one).collect()
    };
    let line = |bench: &str| {
        let run = ran(Span::from_secs(1), "-v -b 115200 -a 1-4 --drive acu statemachine disable", bench).json();
        let (mut bench, end) = witness::left().unwrap();
        bench.advance(end);
        (run, bench.totals().turning, end.as_micros() / 1_000)
    };
    let (calm, _, end) = line(&group("", ""));
    assert_eq!(calm.exit, 0, "{:#}", calm.value);
    let mut both = 0;
    for at in (end - 2_000..end).step_by(100) {
        for after in [300, 900] {
            let event = |at: u64| format!("[[drive.event]]\nat = \"{at}ms\"\nset = {{ \"410\" = 15 }}");
            let (run, turning, end) = line(&group(&event(at), &event(at + after)));
            let told = |nth: u8| run.data(&format!("/drives/{nth}/motion/notes")).to_string().contains(AGAIN);
            let seen = format!("{at} + {after} of {end}: {turning} {} {:#}", run.exit, run.value);
            assert!(turning == 0 || run.exit != 0 || at + after + 600 > end, "{seen}");
            both += usize::from(told(0) && told(3));
        }
    }
    assert!(both > 9, "{both}");
}

/// One that lost its power before it was seen to stand proves nothing; that it has power again is seen all the same.
#[test]
fn one_whose_standstill_nothing_showed_is_looked_at_behind_the_others_too() {
    let one = |address: u8, ramp: u8, rest: &str| {
        let ramps = format!("ramps = {{ up_right = 50, down_right = {ramp}, up_left = 50, down_left = {ramp} }}");
        drive(&format!("{RUNNING}, \"638\" = \"0.1\""), &format!("{ramps}\n{rest}"))
            .replace("\"acu\"", &format!("\"acu\"\naddress = {address}"))
            .replace("\"1ms\"", if address == 1 { "\"150ms\"" } else { "\"5ms\"" })
    };
    let line = |event: &str| {
        let bench = one(1, 50, event) + &one(2, 1, "");
        let run = ran(Span::from_secs(8), "-v -b 115200 -a 1,2 --drive acu statemachine disable", &bench).json();
        let (mut bench, end) = witness::left().unwrap();
        bench.advance(end);
        (run, bench.totals().turning, end.as_micros() / 1_000)
    };
    let (calm, _, end) = line("");
    assert_eq!(calm.data("/drives/0/error/code"), "forbidden.standstill_unproven", "{:#}", calm.value);
    let mut told = 0;
    for again in (8_600..end - 600).step_by(200) {
        let event = |(at, word)| format!("[[drive.event]]\nat = \"{at}ms\"\nset = {{ \"410\" = {word} }}\n");
        let (run, turning, end) = line(&[(again, 7), (again + 50, 15)].map(event).concat());
        assert_eq!(turning, 0, "{again} of {end:?}: {} {:#}", run.exit, run.value);
        told += usize::from(run.data("/drives/0/motion/notes").to_string().contains(AGAIN));
    }
    assert!(told > 5, "{told}");
}

/// Nobody knows what one of them is: it does not answer while it is asked that. It is looked at behind the others like any other drive.
#[test]
fn one_that_nobody_knows_is_looked_at_behind_the_others_too() {
    let one = |address: u8, rest: &str| {
        drive("\"412\" = 1, \"418\" = 0, \"434\" = 2, \"484\" = 10", rest)
            .replace("\"acu\"", &format!("\"acu\"\naddress = {address}"))
            .replace("\"1ms\"", "\"5ms\"")
    };
    let dozes = "[[drive.event]]\nafter_telegrams = 16\nsilent = \"2s\"\n";
    let line = |event: &str| {
        let bench = one(1, &format!("{dozes}{event}")) + &one(2, "");
        let run = antrieb("-v -b 115200 -a 1,2 statemachine disable-voltage").on(&bench).json();
        let (mut bench, end) = witness::left().unwrap();
        bench.advance(end);
        (run, bench.totals().energised, end.as_micros() / 1_000)
    };
    let (calm, _, end) = line("");
    assert_eq!((calm.data("/drives/0/motion/drive").as_str(), calm.exit), (Some("unknown"), 0), "{:#}", calm.value);
    let mut told = 0;
    for again in (end - 1_000..end - 100).step_by(100) {
        let event = |(at, word)| format!("[[drive.event]]\nat = \"{at}ms\"\nset = {{ \"410\" = {word} }}\n");
        let (run, energised, end) = line(&[(again, 6), (again + 30, 7), (again + 60, 15)].map(event).concat());
        assert_eq!(energised, 0, "{again} of {end}: {} {:#} {}", run.exit, run.value, run.err);
        told += usize::from(run.data("/drives/0/motion/notes").to_string().contains(AGAIN));
    }
    assert!(told > 1, "{told}");
}

/// One of the last answers takes long, but comes in its time: nothing is owed, and what the drive did meanwhile is seen all the same.
#[test]
fn a_slow_answer_at_the_end_of_a_stop_hides_no_enabling() {
    let mut turned = 0;
    for verb in ["disable", "quick-stop"] {
        let line = format!("-v -b 115200 -a 1 --drive acu statemachine {verb}");
        let calm = ran(Span::from_secs(1), &line, &drive(RUNNING, "")).exits(0).sent().len() as u64;
        let before = witness::left().unwrap().0.totals().received - calm;
        for nth in calm - 4..=calm {
            let nth = before + nth;
            let late = format!("[[disturb]]\nonce = {nth}\nkind = \"late\"\nby = \"400ms\"\n");
            let event = format!("[[drive.event]]\nafter_telegrams = {nth}\nset = {{ \"410\" = 15 }}\n");
            let run = ran(Span::from_secs(1), &line, &drive(RUNNING, &format!("{event}{late}"))).json();
            let (mut bench, at) = witness::left().unwrap();
            bench.advance(at);
            let now = bench.totals();
            let seen = format!("{verb} {nth}: {} {} {:#} {}", now.energised, now.turning, run.value, run.err);
            turned += usize::from(run.err.contains("by somebody else"));
            assert!(now.energised == 0 || run.exit != 0, "{seen}");
            assert!(now.turning == 0 || run.exit != 0, "{seen}");
        }
    }
    assert!(turned > 3, "{turned}");
}

/// A setpoint of 0 whose shaft somebody else sets going in the last looks is given once more, and stands in the end, or is told.
#[test]
fn a_shaft_that_is_set_going_in_the_last_looks_at_its_zero_is_given_that_once_more() {
    let bench = |event: &str| {
        drive("\"412\" = 1, \"410\" = 15, \"434\" = 2, \"484\" = 5, \"418\" = 0", event).replace("\"1ms\"", "\"20ms\"")
    };
    let line = "-v -b 115200 -a 1 --drive acu sollwert 0";
    let calm = antrieb(line).on(&bench("")).exits(0).sent();
    let mut again = 0;
    for after in calm.len() - 8..calm.len() {
        let event = format!("[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"484\" = 3000 }}");
        let run = antrieb(line).on(&bench(&event)).json();
        let (mut now, at) = witness::left().unwrap();
        now.advance(at);
        let seen = format!("{after} of {}: {} {:#} {}", calm.len(), now.totals().turning, run.value, run.err);
        let told = run.err.contains("THE SHAFT MAY STILL TURN");
        assert!(now.totals().turning == 0 || (run.exit != 0 && told) || after + 2 >= calm.len(), "{seen}");
        again += usize::from(run.data("/notes").to_string().contains("set going again") && run.exit == 0);
    }
    assert!(again > 0);
}
