//! Stop words and zeros that are written as values: what can only take motion away asks nobody, everything else asks (CM-485 manual 9.1.2, 9.1.3,
//! 9.2).

use super::rig::{drive, ran};
use crate::run::antrieb;
use antrieb::tick::Span;
use antrieb::transport::witness;

/// A drive at 20 Hz: who controls it (P.412), where its setpoint comes from (P.434), and its internal setpoint (P.228).
fn inverter(control: u8, source: u8, internal: i32) -> String {
    drive(
        &format!(
            "\"410\" = 15, \"412\" = {control}, \"434\" = {source}, \"228\" = {internal}, \"418\" = 0, \"484\" = 20"
        ),
        "",
    )
}

/// Without a terminal, whoever would be asked refuses.
fn asks(line: &str, bench: &str) -> bool {
    let run = antrieb(&format!("-v {line}")).on(bench).run();
    let refused = run.err.contains("there is no terminal to ask");
    assert_eq!(run.exit, if refused { 8 } else { 0 }, "{line}: {}", run.err);
    refused
}

#[test]
fn a_value_that_can_only_take_motion_away_is_written_without_a_question() {
    let idle = inverter(1, 3, -10).replace("\"410\" = 15", "\"410\" = 0");
    let servo = "[[drive]]\nmodel = \"lxm05\"\nset = { PVn_target = 600 }\n";
    for (told, bench, values, asked) in [
        // Transition 7, 9 or 10; as contacts all open.
        ("commands", &inverter(1, 2, 0), "410=0", false),
        ("contacts", &inverter(2, 2, 0), "410=0", false),
        ("terminals", &inverter(0, 2, 0), "410=0", false),
        // Transition 11; as contacts S2IND alone, and without S1IND there is no release.
        ("commands", &inverter(1, 2, 0), "410=2", false),
        ("contacts", &inverter(2, 2, 0), "410=2", false),
        ("commands", &inverter(1, 2, 0), "410=6", true),
        ("commands", &inverter(1, 2, 0), "410=7", true),
        ("commands", &inverter(1, 2, 0), "410=0x80", true),
        ("contacts", &inverter(2, 2, 0), "410=3", true),
        // The line setpoint alone; it does not count; both are added; the internal one turns the other way.
        ("line", &inverter(1, 2, 0), "484=0", false),
        ("internal", &inverter(1, 1, 10), "484=0", false),
        ("sum", &inverter(1, 3, 10), "484=0", false),
        ("sum, the other way", &inverter(1, 3, -10), "484=0", true),
        ("sum, without power", &idle, "484=0", false),
        ("line", &inverter(1, 2, 0), "484=0.5Hz", true),
        ("a percentage is for a controller", &inverter(1, 2, 0), "524=0", true),
        ("two", &inverter(1, 2, 0), "484=0 410=0", false),
        ("two", &inverter(1, 2, 0), "484=0 480@1=7Hz", true),
    ] {
        let line = format!("-b 115200 -a 1 --drive acu write {values}");
        assert_eq!(asks(&line, bench), asked, "{told}: {values}");
    }
    for (values, asked) in
        [("DCOMcontrol=2", false), ("DCOMcontrol=15", true), ("PVn_target=0", false), ("PVn_target=100", true)]
    {
        assert_eq!(asks(&format!("-a 1 --drive lxm05 write {values}"), servo), asked, "{values}");
    }
    // Nobody has looked what else is there.
    assert!(asks("-b 115200 -a 0 --drive acu write 410=0", &inverter(1, 2, 0)));
    // What a controller makes of 0 % its own settings say (9.2.2).
    assert!(asks("-b 115200 -a 1 --drive act sollwert 0%", &inverter(1, 2, 0).replace("acu", "act")));
}

/// The verb that is quicker is named, in the words of what was written.
#[test]
fn a_stop_word_that_is_written_names_the_verb() {
    for (value, verb) in [("410=0", "statemachine disable-voltage"), ("410=2", "statemachine quick-stop")] {
        for lang in ["en", "de"] {
            let run = antrieb(&format!("--lang {lang} -b 115200 -a 1 write {value}")).on(&inverter(1, 2, 0)).exits(0);
            assert!(run.err.contains(verb), "{}", run.err);
        }
    }
    let other = antrieb("-b 115200 -a 1 --yes write 410=7").on(&inverter(1, 2, 0)).exits(0);
    assert!(!other.err.contains("statemachine"), "{}", other.err);
}

/// Whoever takes the other sources away and gives 0 is told that the shaft turns on all the same.
#[test]
fn a_zero_that_the_drive_lifts_is_no_success_whoever_chose_its_source() {
    let bench = "[[drive]]\nmodel = \"acu\"\nset = { \"228\" = 10 }\n[drive.readings]\nother_modes = \"contacts\"\n";
    let document = antrieb("-a 1 --yes sollwert 0 --source line").on(bench).json().exits(1);
    assert_eq!(document.error()["code"], "no.not_standing");
    assert!(document.err.contains("THE SHAFT MAY STILL TURN"), "{}", document.err);
}

/// A zero that changes where the setpoint comes from is asked about, and waited for like any other.
#[test]
fn a_zero_from_another_source_ends_when_the_shaft_stands() {
    let ramps = "ramps = { up_right = 50, down_right = 5, up_left = 50, down_left = 5 }";
    let bench = drive("\"410\" = 15, \"412\" = 1, \"434\" = 3, \"228\" = 10, \"484\" = 20, \"418\" = 0", ramps);
    let run = ran(Span::from_secs(5), "-b 115200 -a 1 --drive acu --yes sollwert 0 --source line", &bench).json();
    let (mut left, at) = witness::left().unwrap();
    left.advance(at);
    assert_eq!((run.exit, left.totals().turning), (0, 0), "{:#} {}", run.value, run.err);
    assert_eq!(run.data("/setpoint/reached").as_bool(), Some(true));
    let idle = drive("\"412\" = 1, \"434\" = 3", "");
    let run = antrieb("-b 115200 -a 1 --drive acu --yes sollwert 0 --source line").on(&idle).json().exits(0);
    assert!(run.data("/setpoint/reached").is_null(), "{:#}", run.value);
}

/// An answer is lost behind the standstill, and somebody sets the shaft going: it is given its 0 once more, or told.
#[test]
fn a_zero_from_another_source_is_looked_at_once_more_behind_a_lost_answer() {
    let set = "\"410\" = 15, \"412\" = 1, \"434\" = 3, \"228\" = 0, \"484\" = 10, \"418\" = 0";
    let line = "-v -b 115200 -a 1 --drive acu --yes sollwert 0 --source line";
    let calm = ran(Span::from_secs(3), line, &drive(set, "")).exits(0).sent().len();
    let mut stopped = 0;
    for lost in calm - 12..calm {
        let rest = format!(
            "[[drive.event]]\nafter_telegrams = {}\nset = {{ \"484\" = 3000 }}\n[[disturb]]\nonce = {lost}\nkind = \"lost\"\n",
            lost + 1
        );
        let run = ran(Span::from_secs(3), line, &drive(set, &rest)).run();
        let (mut left, at) = witness::left().unwrap();
        left.advance(at);
        let turns = left.totals().turning > 0;
        assert!(!turns || run.err.contains("THE SHAFT MAY STILL TURN"), "{lost} of {calm}: {} {}", run.exit, run.err);
        stopped += usize::from(!turns);
    }
    assert!(stopped > 3, "{stopped}");
}

/// Nobody agrees to another source: the zero went out before, and whether the shaft obeys it is looked at.
#[test]
fn a_zero_to_whose_rest_nobody_agreed_is_told_with_the_capitals_where_the_shaft_turns() {
    for (source, turns) in [(1, true), (3, false)] {
        let set = format!("\"410\" = 15, \"412\" = 1, \"434\" = {source}, \"228\" = 15, \"484\" = 20, \"418\" = 0");
        let bench = drive(&if turns { set } else { set.replace("15, \"412", "0, \"412") }, "");
        let run =
            ran(Span::from_secs(5), "-b 115200 -a 1 --drive acu sollwert 0 --source line", &bench).json().exits(8);
        assert_eq!(run.err.contains("THE SHAFT MAY STILL TURN"), turns, "{source}: {}", run.err);
        assert_eq!(run.err.contains("statemachine quick-stop` stops it"), turns, "{source}: {}", run.err);
        assert!(run.err.contains("nobody agreed to the rest"), "{source}: {}", run.err);
    }
}

/// The drive does not count the setpoint of the line: its shaft turns on at its own.
#[test]
fn a_zero_that_does_not_count_is_told_with_the_capitals_where_the_drive_has_power() {
    let first = |bench: &str, line: &str| {
        let run = antrieb(&format!("-b 115200 {line} sollwert 0")).on(bench).run();
        assert_ne!(run.exit, 0, "{}", run.err);
        run.err.contains("THE SHAFT MAY STILL TURN")
    };
    let turning = inverter(1, 1, 20);
    assert!(first(&turning, "-a 1"));
    let other = inverter(1, 2, 0).replace("\"acu\"", "\"acu\"\naddress = 2");
    assert!(first(&format!("{turning}{other}"), "-a 1,2"));
    assert!(!first(&turning.replace("\"410\" = 15", "\"410\" = 0"), "-a 1"), "without power");
}
