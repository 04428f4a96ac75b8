//! Every end of a run in Basic mode: the stop word, with start and setpoint kept from the terminals, until the frequency is 0; and only
//! then outputs of zero, which hand both to them.

use super::rig::{Came, Hand, Moment, Said, die, does, event, module, no_lost_port_leaves_a_shaft_turning};
use crate::run::antrieb;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

/// At rest; what P.703 and P.928 say is nothing to the Basic block, and P.620 stops a motor that loses its master.
const RESTS: &str = "\"620\" = 0, \"703\" = 0, \"928\" = 0";
/// Ramps of 2 s to 50 Hz.
const RUN: &str = "sollwert 20Hz --enable --hold --duration 3s --watchdog 2s --mode basic --set F002=2s --set F003=2s";

/// Every reading that concerns a start, a run or an end.
const READINGS: [&str; 14] = [
    "",
    "watchdog = \"telegrams\"",
    "unlock = \"no-loss\"",
    "clear = \"loss\"",
    "unlock = \"no-loss\", clear = \"loss\"",
    "run_bits = \"command\"",
    "run_bits = \"command\", unlock = \"no-loss\"",
    "basic_lost = \"conn-sta\"",
    "basic_lost = \"p620\"",
    "basic_ramps = \"held\"",
    "basic_end = \"local\"",
    "basic_end = \"local\", clear = \"loss\"",
    "trip = \"silent\"",
    "unconfigured = \"basic\"",
];

fn on_time(readings: &str) -> Came {
    does(RUN, &module(RESTS, readings, ""), Hand::default())
}

fn has_zero_outputs(came: &Came) -> bool {
    came.moments().iter().any(|moment| matches!(moment.said, Said::Words(0, _) | Said::Clear))
}

#[test]
fn a_run_ends_by_its_duration_under_every_reading() {
    for readings in READINGS {
        let came = on_time(readings);
        assert_eq!(came.code(), ("", 0), "{readings}: {:?}", came.failure());
        came.holds(readings);
        assert_eq!(came.remarks(), Vec::<String>::new(), "{readings}");
        let (motion, stop) = (came.motion(), came.stop());
        assert_eq!((stop.choice, stop.because, stop.acknowledged, stop.escalated), ("ramp", "end", true, None));
        assert_eq!((motion.standing, motion.running), (Some(true), Some(false)), "{readings}");
        assert!(motion.changed.is_empty());
        assert_eq!(came.words(), [0x0050, 0x0051, 0x0050, 0], "{readings}");
        let fastest = came.moments().iter().map(|moment| moment.shaft).max().unwrap();
        assert!((1_990..=2_000).contains(&fastest), "{readings}: {fastest}");
    }
}

#[test]
fn it_turns_the_other_way_and_slowly() {
    for (value, word, speed) in [("-20Hz", 0x0052, -2_000), ("0.5Hz", 0x0051, 50), ("50Hz", 0x0051, 5_000)] {
        let came = does(&RUN.replace("20Hz", value), &module(RESTS, "", ""), Hand::default());
        assert_eq!(came.code(), ("", 0), "{value}: {:?}", came.failure());
        came.holds(value);
        assert!(came.words().contains(&word), "{value}: {:04X?}", came.words());
        let furthest = came.moments().iter().map(|moment| moment.shaft).max_by_key(|shaft| shaft.abs()).unwrap();
        assert!((furthest - speed).abs() <= 10, "{value}: {furthest}");
        assert_eq!(came.motion().setpoint.as_ref().unwrap().param, 611);
    }
}

#[test]
fn a_setpoint_above_the_maximum_is_told_as_not_reached() {
    let came = does(&RUN.replace("20Hz", "60Hz"), &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    came.holds("60Hz");
    let setpoint = came.motion().setpoint.as_ref().unwrap();
    assert_eq!((setpoint.reached, setpoint.actual.unwrap().raw), (Some(false), 5_000));
}

#[test]
fn its_time_begins_where_the_setpoint_is_reached() {
    let profidrive = "sollwert 20Hz --enable --hold --duration 3s --take-control --watchdog 2s";
    for (line, start) in [(RUN, 0x0051), (profidrive, 0x047F)] {
        for (until, least, most) in [("", 2_000, 2_500), (" --until reached", 3_000, 3_100)] {
            let ramps = format!("{RESTS}, \"7\" = -200, \"9\" = -200");
            let came =
                does(&format!("{line}{until}"), &module(&ramps, "reached_at_rest = \"yes\"", ""), Hand::default());
            assert_eq!(came.code(), ("", 0), "{line}{until}: {:?}", came.failure());
            came.holds(line);
            let moments = came.moments();
            let last = moments.iter().rev().find(|moment| matches!(moment.said, Said::Words(word, _) if word == start));
            let first = moments.iter().find(|moment| moment.shaft >= 1_990).unwrap();
            let held = last.unwrap().at.since(first.at).as_millis();
            assert!((least..=most).contains(&held), "{line}{until}: {held} ms");
        }
    }
    let came = does(&RUN.replace("20Hz", "60Hz --until reached"), &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code(), ("no.not_reached", 1), "{:?}", came.failure());
    came.holds("60Hz, and 50 at most");
    assert_eq!(came.motion().standing, Some(true));
}

#[test]
fn what_the_basic_block_has_no_word_for_is_refused_before_anything_is_taken() {
    for (line, code) in [
        (RUN.replace("20Hz", "40%"), "usage.setpoint"),
        (RUN.replace("20Hz", "401Hz"), "usage.setpoint"),
        (format!("{RUN} --on-exit coast"), "usage.profibus"),
        (RUN.replace("F003=2s", "F003=0s"), "usage.setpoint"),
        (RUN.replace("F003=2s", "F004=2s"), "usage.setpoint"),
        (RUN.replace("--mode basic", "--mode profidrive"), "usage.ramps"),
        (RUN.replace("--mode basic", "--mode speed"), "usage.mode"),
    ] {
        let came = does(&line, &module(RESTS, "", ""), Hand::default());
        assert_eq!(came.code(), (code, 2), "{line}: {:?}", came.failure());
        assert!(came.sent.is_empty(), "{line}");
    }
}

/// There is no stronger word: whoever insists gets the ramp.
#[test]
fn whoever_interrupts_stops_it() {
    let start = on_time("").first(0x0051);
    for presses in [&[start + 60][..], &[start + 60, start + 70], &[start + 60, start + 70, start + 80]] {
        for readings in ["", "clear = \"loss\"", "run_bits = \"command\"", "basic_ramps = \"held\""] {
            let came = does(RUN, &module(RESTS, readings, ""), Hand { presses, ..Hand::default() });
            let what = format!("{presses:?} {readings}");
            assert_eq!(came.code(), ("interrupted", 130), "{what}: {:?}", came.failure());
            came.holds(&what);
            assert_eq!((came.stop().acknowledged, came.stop().escalated), (true, None), "{what}");
            assert_eq!(came.motion().standing, Some(true), "{what}");
        }
    }
}

#[test]
fn who_ends_it_at_a_question_has_started_nothing() {
    for place in [0, 1] {
        let pressed = does(RUN, &module(RESTS, "", ""), Hand { presses_at: Some(place), ..Hand::default() });
        assert_eq!(pressed.code(), ("interrupted.question", 130), "{place}");
        let denied = does(RUN, &module(RESTS, "", ""), Hand { denies: Some(place), ..Hand::default() });
        assert_eq!(denied.code(), ("forbidden.not_confirmed", 8), "{place}");
        for came in [pressed, denied] {
            came.holds("at a question");
            assert_eq!(came.asked.len(), place + 1);
            assert!(came.words().iter().all(|word| [0x0050, 0].contains(word)), "{:04X?}", came.words());
        }
    }
}

#[test]
fn a_minute_at_a_question_is_no_watchdog() {
    let came = does(RUN, &module(RESTS, "", ""), Hand { thinks: Span::from_secs(60), ..Hand::default() });
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    came.holds("thinks");
    assert_eq!(came.remarks(), Vec::<String>::new());
}

#[test]
fn the_question_says_what_stays_unknown() {
    let came = on_time("");
    let [first, second] = &came.asked[..] else { panic!("{:?}", came.asked) };
    let said = |question: &antrieb::gate::Question| {
        question.details.iter().map(|detail| detail.en.to_string()).collect::<Vec<_>>().join("\n")
    };
    let (first, second) = (said(first), said(second));
    assert!(first.contains("0050") && !first.contains("047E"), "{first}");
    for word in ["A001", "A002", "closed start contact", "P.620", "Conn Sta", "2.0 s up, 2.0 s down"] {
        assert!(second.contains(word), "{word}: {second}");
    }
}

#[test]
fn a_trip_ends_a_run_and_starts_nothing_behind_it() {
    let moments = on_time("").moments();
    let of = |index: usize, later: u64| moments[index].at.since(Tick::ZERO).as_millis() + later;
    let runs = |moment: &Moment| matches!(moment.said, Said::Words(0x0051, _));
    let [first, last] = [moments.iter().position(runs), moments.iter().rposition(runs)].map(Option::unwrap);
    for readings in ["", "trip = \"silent\"", "run_bits = \"command\""] {
        // At the question, on the ramp, at speed, on the way down.
        for at in [500, of(first, 300), of(first, 2_000), of(last, 300)].map(|at| format!("{at}ms")) {
            let came = does(RUN, &module(RESTS, readings, &event(&at, "trip = true")), Hand::default());
            let what = format!("{readings} {at}");
            assert!(
                ["forbidden.fault", "forbidden.tripped", "forbidden.standstill_unproven"].contains(&came.code().0),
                "{what}: {:?}",
                came.failure()
            );
            came.holds(&what);
            assert_ne!(came.motion().standing, Some(true), "{what}: it coasts");
            assert!(came.words().iter().filter(|word| **word & 3 != 0).count() <= 1, "{what}: {:04X?}", came.words());
        }
    }
}

#[test]
fn a_fault_is_acknowledged_with_no_run_bit() {
    for readings in READINGS {
        let tripped = module(RESTS, readings, &event("100ms", "trip = true"));
        let came = does("statemachine --mode basic reset", &tripped, Hand::default());
        assert_eq!(came.code(), ("", 0), "{readings}: {:?}", came.failure());
        came.holds(readings);
        assert_eq!(came.words(), [0x0050, 0x00D0, 0x0050, 0], "{readings}");
    }
    let came = does("statemachine --mode basic reset", &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code(), ("forbidden.no_fault", 8));
    came.holds("no fault");
}

/// Outputs of zero would give it back to the contact that ran it.
#[test]
fn a_stop_asks_nobody_and_does_not_give_the_motor_back_to_a_closed_contact() {
    for verb in
        ["statemachine --mode basic disable", "statemachine --mode basic quick-stop", "sollwert 0Hz --mode basic"]
    {
        for readings in
            ["", "unlock = \"no-loss\"", "clear = \"loss\"", "run_bits = \"command\"", "basic_ramps = \"held\""]
        {
            let driven = module(RESTS, readings, &event("0s", "contact = true"));
            let came = does(verb, &driven, Hand::default());
            let what = format!("{verb} {readings}");
            assert_eq!(came.code(), ("forbidden.terminals", 8), "{what}: {:?}", came.failure());
            came.holds(&what);
            assert!(came.asked.is_empty() && came.stop().acknowledged && !has_zero_outputs(&came), "{what}");
            assert_eq!(came.motion().standing, Some(true), "{what}");
            let came = does(verb, &module(RESTS, readings, ""), Hand::default());
            assert_eq!((came.code(), came.words()), (("", 0), vec![0x0050, 0]), "{what}: {:?}", came.failure());
            came.holds(&what);
        }
    }
    let came = does("statemachine --mode basic disable-voltage", &module(RESTS, "", ""), Hand::default());
    assert_eq!((came.code(), came.words(), came.stop().choice), (("", 0), vec![0x0050, 0], "ramp"));
}

/// Under our word it comes down by its own ramp, of 10 s to 50 Hz here: that is waited for, and then it is started.
#[test]
fn a_motor_that_turned_before_comes_down_by_its_ramp_before_it_is_started() {
    let driven = module(RESTS, "basic_ramps = \"held\"", &event("0s", "contact = true"));
    let came = does("sollwert 20Hz --enable --hold --duration 1s --mode basic", &driven, Hand::default());
    // The contact is still closed, so that it gets no outputs of zero.
    assert_eq!(came.code(), ("forbidden.terminals", 8), "{:?}", came.failure());
    came.holds("it was started");
    assert_eq!(came.words(), [0x0050, 0x0051, 0x0050]);
}

/// What no end of ours can keep, and what its failure says.
#[test]
fn a_contact_that_counts_without_a_master_turns_the_motor_behind_us() {
    let driven = module(RESTS, "basic_end = \"local\"", &event("0s", "contact = true"));
    let came = does("statemachine --mode basic disable", &driven, Hand::default());
    assert_eq!(came.code(), ("forbidden.terminals", 8));
    let hint = &came.failure().unwrap().hint.as_ref().unwrap().en;
    assert!(hint.contains("no source tells") && came.later()[0] == 1, "{hint}");
}

#[test]
fn a_contact_that_closes_meanwhile_is_seen_and_stopped() {
    for readings in ["", "unlock = \"no-loss\"", "clear = \"loss\"", "run_bits = \"command\"", "basic_ramps = \"held\""]
    {
        let came = does(RUN, &module(RESTS, readings, &event("4s", "contact = true")), Hand::default());
        assert_eq!(came.code(), ("forbidden.terminals", 8), "{readings}: {:?}", came.failure());
        came.holds(readings);
        assert_eq!(came.words(), [0x0050, 0x0051, 0x0050, 0, 0x0050], "{readings}");
        assert!(!came.moments().iter().any(|moment| moment.said == Said::Clear), "{readings}");
    }
}

/// The wire is cut at speed, for less than the watchdog, for longer, for good.
#[test]
fn a_slave_that_is_lost_is_stopped_by_itself_or_by_us() {
    for (kept, readings) in [(0, ""), (1, ""), (1, "basic_lost = \"conn-sta\""), (0, "basic_lost = \"p620\"")] {
        let set = RESTS.replace("\"620\" = 0", &format!("\"620\" = {kept}"));
        for (until, is_back) in [("4200ms", true), ("8s", true), ("500s", false)] {
            let events = event("4s", "cut = true") + &event(until, "cut = false");
            let came = does(&RUN.replace("3s", "6s"), &module(&set, readings, &events), Hand::default());
            let what = format!("P.620 = {kept} {readings}, cut until {until}: {:?}", came.failure());
            match (until, is_back) {
                // Missing answers are borne.
                ("4200ms", _) => assert_eq!(came.code(), ("", 0), "{what}"),
                (_, true) => assert_eq!(came.code(), ("refused.left", 6), "{what}"),
                _ => assert_eq!(came.code().1, 4, "{what}"),
            }
            if is_back {
                came.holds(&what);
                continue;
            }
            let failure = came.failure().unwrap();
            assert!(failure.told().en.starts_with("THE SHAFT MAY STILL TURN"), "{what}");
            assert!(failure.hint.as_ref().unwrap().en.contains("P.620"), "{what}");
            assert_eq!(came.later()[0] == 0, kept == 0 || readings.contains("conn-sta"), "{what}");
        }
    }
}

#[test]
fn a_port_that_is_lost_at_any_telegram_leaves_no_shaft_turning() {
    no_lost_port_leaves_a_shaft_turning(|| on_time(""), 0x0051);
}

#[test]
fn who_is_killed_leaves_it_to_the_watchdog() {
    for readings in ["", "run_bits = \"command\"", "basic_lost = \"p620\"", "basic_end = \"local\""] {
        let whole = on_time(readings);
        assert_eq!(whole.killed().iter().position(|shaft| *shaft != 0), None, "{readings}");
    }
    // What the question warns of: P.620 = 1 keeps it running.
    let keeps = RESTS.replace("\"620\" = 0", "\"620\" = 1");
    let came = does(RUN, &module(&keeps, "", ""), Hand::default());
    assert_ne!(came.killed()[came.first(0x0051) + 60], 0);
    let conn_sta = does(RUN, &module(&keeps, "basic_lost = \"conn-sta\"", ""), Hand::default());
    assert!(conn_sta.killed().iter().all(|shaft| *shaft == 0), "no word of ours has Conn Sta");
}

/// Any end at any step, under any readings, with whatever happens to the line: a die of its own, the same every time.
#[test]
fn dice_over_ends_and_steps_leave_no_shaft_turning() {
    let mut die = die(11);
    let all = on_time("").sent.len();
    for round in 0..120 {
        let readings = READINGS[die(READINGS.len())];
        let at = 600 + die(7_000);
        // A contact that closes for good behind us is somebody else's start.
        let opens = format!("{}ms", at + die(4_000));
        let (at, later) = (format!("{at}ms"), format!("{}ms", 700 + die(10_000)));
        let events = match die(6) {
            0 => event(&at, "trip = true"),
            1 => event(&at, "cut = true"),
            2 => event(&at, "cut = true") + &event(&later, "cut = false"),
            3 => event(&at, "contact = true") + &event(&opens, "contact = false"),
            _ => String::new(),
        };
        let lost = ["", "flips = 2", "losses = 3", "latency = \"4ms\""][die(4)];
        let bench = format!("[line]\nseed = {round}\n{lost}\n{}", module(RESTS, readings, &events));
        let mut presses: Vec<usize> = (0..die(4)).map(|_| die(all)).collect();
        presses.sort_unstable();
        let pulled = (die(4) == 0).then(|| die(all) as u64);
        witness::pull_after(pulled);
        let came = does(RUN, &bench, Hand { presses: &presses, ..Hand::default() });
        witness::pull_after(None);
        let what = format!("{round}: {readings} {events} {lost} {presses:?} {pulled:?}: {:?}", came.code());
        assert_eq!(came.later()[0], 0, "{what}");
        let is_lost = pulled.is_some() || events.contains("cut");
        if !is_lost {
            came.holds(&what);
        }
        if let Ok(outcome) = &came.outcome {
            assert!(outcome.data.is_some());
            let turned = came.moments().iter().any(|moment| moment.shaft != 0);
            assert!(!turned || came.motion().standing != Some(true) || came.stop().acknowledged, "{what}");
        }
    }
}

#[test]
fn the_mode_is_that_of_get_cfg_where_the_series_is_known() {
    let line = "-a 3 --protocol dp --yes statemachine disable";
    for (readings, drive, said) in [
        ("unconfigured = \"basic\"", "--drive l200", "mode Basic: Get_Cfg tells F3"),
        (
            "unconfigured = \"basic\"",
            "",
            "mode ProfiDrive (PPO1): Get_Cfg tells F3, the Basic block, but not which series",
        ),
        ("", "--drive l200", "mode ProfiDrive (PPO1): Get_Cfg tells F3 F1"),
        ("", "--drive l200 --mode basic", "mode Basic: --mode"),
    ] {
        let mode = drive.replace("--drive l200", "").trim().to_owned();
        let drive = if drive.is_empty() { "" } else { "--drive l200" };
        let line = line.replace("disable", &format!("{mode} disable"));
        let run = antrieb(&format!("{drive} {line}")).on(&module(RESTS, readings, "")).exits(0);
        assert!(run.err.contains(said), "{readings} {drive}: {}", run.err);
    }
    let run = antrieb("-a 3 --protocol dp --yes statemachine --mode basic disable").on(&module(RESTS, "", "")).json();
    assert_eq!(run.exits(2).error()["code"], "usage.series");
    // The wrong series is refused, in words.
    let run = antrieb("-a 3 --drive sj200 --protocol dp --yes statemachine --mode basic disable");
    assert_eq!(run.on(&module(RESTS, "", "")).json().exits(6).error()["code"], "refused.cfg_fault");
}

#[test]
fn pages_and_plans_are_german_where_that_is_wanted() {
    let tripped = module(RESTS, "", &event("100ms", "trip = true"));
    let given = "-a 3 --drive l200 --protocol dp --yes";
    for (line, bench, code) in [
        ("sollwert 20Hz --jog 2s --mode basic", module(RESTS, "", ""), 0),
        ("sollwert 20Hz --jog 9s --mode basic", module(RESTS, "", &event("6s", "trip = true")), 8),
        ("sollwert 20Hz --jog 9s --mode basic", module(RESTS, "", &event("6s", "cut = true")), 4),
        ("sollwert 20Hz --jog 2s --mode basic", tripped.clone(), 8),
        ("sollwert 20Hz --jog 2s --mode basic --dry-run", module(RESTS, "", ""), 0),
        ("statemachine --mode basic show", module(RESTS, "", ""), 0),
        ("statemachine --mode basic show", tripped.clone(), 0),
        ("statemachine --mode basic reset", tripped, 0),
        ("statemachine --mode basic disable", module(RESTS, "", &event("0s", "contact = true")), 8),
        ("statemachine --mode basic disable --dry-run", module(RESTS, "", ""), 0),
    ] {
        antrieb(&format!("{given} {line} --lang de")).on(&bench).exits(code);
        antrieb(&format!("{given} {line}")).on(&bench).exits(code);
    }
    let asked = antrieb("-a 3 --drive l200 --protocol dp sollwert 20Hz --jog 2s --mode basic --lang de");
    let asked = asked.on(&module(RESTS, "", "")).answered("j\nj").exits(0);
    assert!(asked.err.contains("10.0 s hoch") && asked.err.contains("P.620"), "{}", asked.err);
    let tripped = module(RESTS, "", &event("100ms", "trip = true"));
    let run = antrieb(&format!("{given} statemachine --mode basic show")).on(&tripped).json().exits(0);
    assert_eq!(run.data("/drives/0/state/slug"), "fault");
    assert_eq!(run.data("/drives/0/fault/key"), "25h");
}
