//! `--duration` counts from the word that can turn the shaft: of every mode and protocol, whether its answer is lost or late.

use super::keypad;
use super::rig::sent;
use crate::run::{Output, antrieb};
use antrieb::tick::Span;

/// A run, what goes out first of all that can turn the shaft, and what takes that away.
#[derive(Clone, Copy)]
struct Turn {
    drive: &'static str,
    line: &'static str,
    turns: &'static str,
    stop: &'static str,
    /// How long the shaft may turn by itself, ms.
    most: f64,
}

const INVERTER: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }\n";
const ASCII: &str =
    "[[drive]]\nmodel = \"acu\"\nprotocol = \"ascii\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }\n";
const BUS: &str =
    "[[drive]]\nmodel = \"acu\"\nprotocol = \"vabus\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }\n";
/// No manual says that P.418 counts with P.434 = 2 alone: from the enabling on the shaft may turn at that.
const LIFTED: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 3.5 }\n";
const CONTACTS: &str =
    "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 2, \"434\" = 3, \"228\" = 0, \"418\" = 0, \"480\" = 10 }\n";
/// Of the gear stands a ratio from before, at which nobody agreed to turn.
const SERVO: &str = "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 3000, RAMPdecel = 3000, IOposInterfac = 1, GEARnum = 5 }\n\
                     servo = { guide = 163840 }\n\
                     readings = { control_7 = \"refused\", node_guard = \"quick-stop\", quick_stop = \"stays\" }\n";

const SETPOINT: &str = "01 65 01 E4 00 00 03";
const DISABLE: &str = "01 06 01 9A 00 07";
/// The same in the characters of ASCII.
const ASCII_SETPOINT: &str = "3A 30 31 36 35 30 31 45 34 30 30 30 30 30 33";
const ASCII_DISABLE: &str = "3A 30 31 30 36 30 31 39 41 30 30 30 37";
const BUS_SETPOINT: &str = "04 41 02 30 30 34 38 34 30 38 30 30 30 30 30 33";
const BUS_DISABLE: &str = "04 41 02 30 30 34 31 30 30 34 30 30 30 37";
/// DCOMcontrol (6914 = 1B02h) = 2.
const QUICK_STOP: &str = "01 10 1B 02 00 02 04 00 00 00 02";
const START: &str = "01 10 1B 02 00 02 04 00 00 00 1F";

const fn of(drive: &'static str, line: &'static str, turns: &'static str, stop: &'static str) -> Turn {
    Turn { drive, line, turns, stop, most: 1_000.0 }
}

const INVERTERS: &[Turn] = &[
    of(INVERTER, "sollwert 10Hz --enable --hold --duration 1s", SETPOINT, DISABLE),
    of(INVERTER, "sollwert --ramp 5Hz:10Hz:500ms --enable --hold --duration 500ms", "01 65 01 E4 00 00 01", DISABLE),
    of(INVERTER, "sollwert --profile {dir}/p.csv --enable --hold --duration 500ms", SETPOINT, DISABLE),
    Turn { most: 700.0, ..of(INVERTER, "sollwert 10Hz --jog 700ms", SETPOINT, DISABLE) },
    of(INVERTER, "sollwert 20% --enable --hold --duration 1s", "01 65 02 0C 00 00 07", DISABLE),
    of(INVERTER, "statemachine enable --hold --duration 1s", "01 06 01 9A 00 0F", DISABLE),
    of(INVERTER, "statemachine goto operation-enabled --hold --duration 1s", "01 06 01 9A 00 0F", DISABLE),
    of(CONTACTS, "statemachine contacts S2IND --hold --duration 1s", "01 06 01 9A 00 0", "01 06 01 9A 00 00"),
    of(LIFTED, "sollwert 10Hz --enable --hold --duration 1s", "01 06 01 9A 00 0F", DISABLE),
    Turn { most: 2_000.0, ..of(LIFTED, "sollwert 10Hz --jog 2s", "01 06 01 9A 00 0F", DISABLE) },
    of(BUS, "--protocol vabus sollwert 10Hz --enable --hold --duration 1s", BUS_SETPOINT, BUS_DISABLE),
    of(BUS, "--protocol vabus sollwert 10Hz --jog 1s", BUS_SETPOINT, BUS_DISABLE),
    of(ASCII, "--protocol ascii sollwert 10Hz --enable --hold --duration 1s", ASCII_SETPOINT, ASCII_DISABLE),
    of(ASCII, "--protocol ascii sollwert 10Hz --jog 1s", ASCII_SETPOINT, ASCII_DISABLE),
];

/// Every mode of an LXM05. What turns its shaft is, of the gear, that it follows the guide (GEARreference, 6948 = 1B24h); of a movement
/// its start; of the others their setpoint.
const SERVOS: &[Turn] = &[
    of(
        SERVO,
        "sollwert 300rpm --enable --hold --duration 1s",
        "01 10 1B 1A 00 02 04 00 00 01",
        "01 10 1B 1A 00 02 04 00 00 00 00",
    ),
    of(
        SERVO,
        "sollwert 300rpm --mode speed --enable --hold --duration 1s",
        "01 10 21 08 00 02 04 00 00 01",
        "01 10 21 08 00 02 04 00 00 00 00",
    ),
    of(
        SERVO,
        "sollwert 5 --mode jog --enable --hold --duration 1s",
        "01 10 1B 12 00 02 04 00 00 00 05",
        "01 10 1B 12 00 02 04 00 00 00 00",
    ),
    of(SERVO, "sollwert 3A --enable --hold --duration 1s", "01 10 20 08 00 02 04 00 00 01", QUICK_STOP),
    of(SERVO, "sollwert 2/3 --enable --hold --duration 1s", "01 10 1B 24 00 02 04 00 00 00 01", QUICK_STOP),
    of(SERVO, "sollwert 90000000usr --start absolute --enable --hold --duration 1s", START, QUICK_STOP),
    of(SERVO, "sollwert 17 --mode homing --set HMn=30 --enable --hold --duration 1s", START, QUICK_STOP),
];

/// When the shaft began to turn, and when the first word went out that ends that.
fn turned(turn: &Turn, run: &Output) -> Option<(f64, Option<f64>)> {
    let sent = sent(&run.err);
    let mut rest = sent.iter().skip_while(|(_, told)| !told.starts_with(turn.turns));
    let begun = rest.next()?.0;
    Some((begun, rest.find(|(_, told)| told.starts_with(turn.stop)).map(|found| found.0)))
}

fn runs(turn: &Turn, rest: &str, disturb: &str) -> Output {
    let model = if turn.drive == SERVO { "lxm05" } else { "acu" };
    let line = format!("--drive {model} -a 1 --yes -v {rest}{}", turn.line);
    antrieb(&line).file("p.csv", "0s, 8Hz\n500ms, 9Hz\n").on(&format!("{}{disturb}", turn.drive)).run()
}

/// A word that is obeyed and whose answer is lost turns the shaft all the same.
fn it_turns_no_longer_where_answers_are_lost(turns: &[Turn]) {
    let mut sins = Vec::new();
    for turn in turns {
        for timeout in ["", "--timeout 10s "] {
            let lost_from = |from: usize| {
                let lost: String =
                    (from..from + 250).map(|once| format!("[[disturb]]\nonce = {once}\nkind = \"lost\"\n")).collect();
                runs(turn, timeout, &lost)
            };
            // Where answers are lost long before that word, it never goes out.
            let calm = sent(&runs(turn, timeout, "").err);
            let word = calm.iter().position(|(_, told)| told.starts_with(turn.turns)).unwrap();
            let never = |from: &usize| turned(turn, &lost_from(*from)).is_none();
            let (mut found, mut first) = (0, (1..=word).rev().step_by(4).find(never).unwrap_or(0));
            for from in first + 1..90 {
                let run = lost_from(from);
                let Some((begun, ended)) = turned(turn, &run) else {
                    first = from;
                    continue;
                };
                found += 1;
                // Before the word that stops it a line that is silent is waited for, at most 100 ms.
                if ended.is_none_or(|ended| ended - begun > turn.most + 150.0) {
                    sins.push(format!("{timeout}{}: lost from {from} on: from {begun} to {ended:?}", turn.line));
                }
                if from > first + 8 {
                    break;
                }
            }
            assert!(found > 3, "{}: it never turned", turn.line);
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

#[test]
fn the_time_of_a_run_counts_from_the_word_that_can_turn_an_inverter() {
    it_turns_no_longer_where_answers_are_lost(INVERTERS);
}

#[test]
fn the_time_of_a_run_counts_from_the_word_that_can_turn_a_servo_in_every_mode() {
    it_turns_no_longer_where_answers_are_lost(SERVOS);
}

/// No answer is lost, but each comes late: neither the run nor its end is longer by that.
#[test]
fn on_a_slow_line_the_time_of_a_run_is_what_it_is() {
    let mut sins = Vec::new();
    for turn in INVERTERS.iter().chain(SERVOS) {
        for late in [100, 300, 600] {
            let run =
                runs(turn, "--timeout 2s ", &format!("[[disturb]]\nevery = 1\nkind = \"late\"\nby = \"{late}ms\"\n"));
            let took = turned(turn, &run).map(|(begun, ended)| ended.map(|ended| ended - begun));
            if took.flatten().is_none_or(|took| took > turn.most + 150.0) {
                sins.push(format!("{}: {late} ms late: {took:?}, exit {}", turn.line, run.exit));
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

/// Behind `--until reached` the time counts from the first of the looks that showed it one after the other; where these take longer,
/// it is over with the last.
#[test]
fn behind_a_setpoint_that_is_reached_no_question_comes_before_the_clock() {
    let inverter = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }\nramps = { up_right = 50 }\n";
    let state = ["01 03 01 9B", "01 03 1B 04"];
    let mut sins = Vec::new();
    for (drive, line, stop) in [
        (inverter, "sollwert 10Hz", DISABLE),
        (SERVO, "sollwert 300rpm", "01 10 1B 1A 00 02 04 00 00 00 00"),
        (SERVO, "sollwert 8000usr --start absolute", QUICK_STOP),
    ] {
        let model = if drive == SERVO { "lxm05" } else { "acu" };
        for delay in [1, 100, 300, 600] {
            let late = format!("[[disturb]]\nevery = 1\nkind = \"late\"\nby = \"{delay}ms\"\n");
            let line = format!(
                "--drive {model} -a 1 --yes -v --timeout 2s {line} --enable --until reached --hold --duration 500ms"
            );
            let run = antrieb(&line).on(&format!("{drive}{late}")).run();
            let (before, behind) =
                run.err.split_once("running; Ctrl-C").unwrap_or_else(|| panic!("{line}: {}", run.err));
            let mut states = Vec::new();
            let lines: Vec<_> = before.lines().filter_map(|told| told.split_once(" ms ")).collect();
            for pair in lines.windows(2) {
                let is_state = state.iter().any(|state| pair[0].1.starts_with(&format!("> {state}")));
                if is_state && let Some(hex) = pair[1].1.strip_prefix("< ") {
                    // Bit 10 of the last word.
                    let bytes: Vec<u8> = hex.split(' ').map_while(|byte| u8::from_str_radix(byte, 16).ok()).collect();
                    let at: f64 = pair[1].0.trim().parse().unwrap();
                    states.push((at, bytes[bytes.len() - 4] & 4 != 0));
                }
            }
            let (last, is_there) = *states.last().unwrap();
            assert!(is_there, "{line}: {}", run.err);
            let first = states.iter().rev().take_while(|(_, is_there)| *is_there).last().unwrap().0;
            let ended = sent(behind).into_iter().find(|(_, told)| told.starts_with(stop)).map(|found| found.0);
            // What is told behind the last look at the state is asked for once, and the line is silent before the stop.
            let most = (first + 500.0).max(last + 4.5 * f64::from(delay)) + 150.0;
            if ended.is_none_or(|ended| ended > most || ended < first + 350.0) {
                sins.push(format!("{line}: {delay} ms: {ended:?} of {most}, {first} {last}, exit {}", run.exit));
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

/// The gear follows its guide at the ratio that was agreed to, and not for a moment at the one that stood there.
#[test]
fn a_gear_follows_at_the_ratio_that_was_agreed_to_from_its_first_moment_on() {
    let run = runs(&SERVOS[4], "", "");
    let sent = sent(&run.err);
    let at = |word: &str| sent.iter().position(|(_, told)| told.starts_with(word));
    // GEARdenom (9734) = 3, GEARnum (9736) = 2, GEARreference (6948) = 1.
    let ratio = [at("01 10 26 06 00 02 04 00 00 00 03"), at("01 10 26 08 00 02 04 00 00 00 02")];
    let follows = at("01 10 1B 24 00 02 04 00 00 00 01");
    assert!(ratio[0].is_some() && ratio[0] < ratio[1] && ratio[1] < follows, "{}", run.err);
    assert_eq!(run.exit, 0, "{}", run.err);
}

/// Who gave less time than an answer takes is told that, and is not sent to look for a cable; and what a drive ends by itself with its run
/// is nobody's doing.
#[test]
fn a_time_that_is_shorter_than_an_answer_is_no_fault_of_the_line() {
    let late = "[[disturb]]\nevery = 1\nkind = \"late\"\nby = \"300ms\"\n";
    for (drive, value) in
        [(INVERTER, "10Hz"), (SERVO, "300rpm"), (SERVO, "3A"), (SERVO, "2/3"), (SERVO, "300rpm --mode speed")]
    {
        let line = format!("-a 1 --yes sollwert {value} --enable --hold --duration 100ms");
        let run = antrieb(&line).on(&format!("{drive}{late}")).run();
        assert!(run.err.contains("--duration was over before the drive had answered"), "{line}: {}", run.err);
        assert!(run.err.contains("choose a longer --duration") && !run.err.contains("cable"), "{line}: {}", run.err);
        assert!(!run.out.contains("somebody else"), "{line}: {}", run.out);
        let german = antrieb(&format!("--lang de {line}")).on(&format!("{drive}{late}")).run();
        assert!(german.err.contains("--duration länger wählen"), "{line}: {}", german.err);
    }
}

/// Who interrupts a stop again and again waits no longer, though the drive answers late and seems to run on.
#[test]
fn who_interrupts_the_strongest_stop_is_not_kept_waiting() {
    let servo = "set = { RAMPacc = 3000, RAMPdecel = 3000 }\n";
    for (model, keys, line, from) in [
        ("lxm05", servo, "sollwert 900rpm --enable --hold", 74),
        ("acu", "set = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }\n", "sollwert 20Hz --enable --hold", 74),
    ] {
        for late in ["3s", "6s"] {
            let bad: String = (from / 2..from / 2 + 300)
                .map(|once| format!("[[disturb]]\nonce = {once}\nkind = \"late\"\nby = \"{late}\"\n"))
                .collect();
            let mut pressed = Vec::new();
            let seen =
                keypad::run((model, &format!("{keys}{bad}"), line), "--timeout 60s", &mut |telegram, at, hand| {
                    if telegram >= from && pressed.len() < 3 {
                        pressed.push(at);
                        hand.press();
                    }
                });
            let took = seen.at.since(*pressed.last().unwrap());
            assert_eq!(pressed.len(), 3);
            assert!(took < Span::from_secs(25), "{model} {late}: {took} {pressed:?} {:?}", seen.notes);
            assert!(seen.failure.is_some(), "{model} {late}");
        }
    }
}

/// Nor does a line on which each question takes a time-out keep anybody from seeing that the setpoint is reached.
#[test]
fn on_the_way_to_a_setpoint_no_question_takes_longer_than_in_the_run() {
    let doubled = "[[disturb]]\nevery = 1\nkind = \"doubled\"\nby = \"20ms\"\n";
    for timeout in ["", "--timeout 10s "] {
        let line = "sollwert 300rpm --enable --until reached --hold --duration 1s";
        let turn = of(SERVO, line, "01 10 1B 1A 00 02 04 00 00 01", "01 10 1B 1A 00 02 04 00 00 00 00");
        let run = runs(&turn, timeout, doubled);
        let (begun, ended) = turned(&turn, &run).unwrap();
        assert!(ended.is_some_and(|ended| ended - begun < 8_000.0), "{timeout}: {begun} {ended:?}");
        // Nothing is heard behind the first word that turns it: borne as long as --wait says.
        for from in 31..40 {
            let lost: String =
                (from..from + 250).map(|once| format!("[[disturb]]\nonce = {once}\nkind = \"lost\"\n")).collect();
            let run = runs(&turn, timeout, &lost);
            let Some((begun, ended)) = turned(&turn, &run) else { continue };
            assert!(ended.is_some_and(|ended| ended - begun < 8_500.0), "{timeout} {from}: {begun} {ended:?}");
        }
    }
}
