//! Every end of a run over PROFIBUS: the stop word until the frequency is 0, what was lent given back, and only then outputs of zero.

use super::rig::{Came, Hand, RESTS, Said, die, does, event, module, no_lost_port_leaves_a_shaft_turning};
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

/// A run that takes what it needs.
const RUN: &str = "sollwert 20Hz --enable --hold --duration 3s --take-control --watchdog 2s";

/// Every reading that concerns a start, a run or an end; alone, and those that belong together.
const READINGS: [&str; 19] = [
    "",
    "watchdog = \"telegrams\"",
    "unconfigured = \"basic\"",
    "unlock = \"no-loss\"",
    "clear = \"loss\"",
    "unlock = \"no-loss\", clear = \"loss\"",
    "without_control = \"ramp\"",
    "without_control = \"local\"",
    "start = \"level\"",
    "right = \"starts\"",
    "off2_off3 = \"coast-brake\"",
    "reached_at_rest = \"yes\"",
    "pkw_waits = \"empty\"",
    "pkw_again = \"every-cycle\"",
    "error_word = \"high\"",
    "negative_pwe = \"extended\"",
    "a004 = \"0.1hz\"",
    "a004 = \"0.01hz\"",
    "trip = \"silent\"",
];

fn on_time(readings: &str) -> Came {
    does(RUN, &module(RESTS, readings, ""), Hand::default())
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
        assert!(came.is_given_back() && motion.changed.len() == 2, "{readings}: {:?}", motion.changed);
        // 0406, the same start word with two setpoints, and the stop word that holds it before and behind.
        assert_eq!(came.words(), [0x047E, 0x0406, 0x047F, 0x047E, 0], "{readings}");
        let fastest = came.moments().iter().map(|moment| moment.shaft).max().unwrap();
        assert!((1_990..=2_000).contains(&fastest), "{readings}: {fastest}");
    }
}

#[test]
fn it_turns_the_other_way_and_in_percent() {
    for (value, stw, speed) in
        [("-20Hz", 0x0C7F, -2_000), ("40%", 0x047F, 2_000), ("-40%", 0x0C7F, -2_000), ("0.5Hz", 0x047F, 50)]
    {
        let line = RUN.replace("20Hz", value);
        let came = does(&line, &module(RESTS, "negative_setpoint = \"zero\"", ""), Hand::default());
        assert_eq!(came.code(), ("", 0), "{value}: {:?}", came.failure());
        came.holds(value);
        assert!(came.words().contains(&stw), "{value}: {:04X?}", came.words());
        let furthest = came.moments().iter().map(|moment| moment.shaft).max_by_key(|shaft| shaft.abs()).unwrap();
        assert!((furthest - speed).abs() <= 10, "{value}: {furthest}");
    }
}

#[test]
fn no_setpoint_goes_beyond_the_maximum() {
    for (value, code) in
        [("51Hz", "data.range"), ("-51Hz", "data.range"), ("500Hz", "usage.setpoint"), ("101%", "usage.setpoint")]
    {
        let came = does(&RUN.replace("20Hz", value), &module(RESTS, "", ""), Hand::default());
        assert_eq!(came.code().0, code, "{value}");
        came.holds(value);
        assert!(came.moments().iter().all(|moment| moment.shaft == 0), "{value}");
    }
    let full = does(&RUN.replace("20Hz", "50Hz"), &module(RESTS, "", ""), Hand::default());
    assert_eq!(full.code(), ("", 0));
    full.holds("50Hz");
}

#[test]
fn whoever_interrupts_stops_it_and_whoever_insists_lets_it_coast() {
    let undisturbed = on_time("");
    let start = undisturbed.first(0x047F);
    for presses in [&[start + 60][..], &[start + 60, start + 70], &[start + 60, start + 70, start + 80]] {
        for readings in ["", "off2_off3 = \"coast-brake\"", "without_control = \"ramp\"", "clear = \"loss\""] {
            let came = does(RUN, &module(RESTS, readings, ""), Hand { presses, ..Hand::default() });
            let what = format!("{presses:?} {readings}");
            assert_eq!(came.code(), ("interrupted", 130), "{what}: {:?}", came.failure());
            came.holds(&what);
            let stop = came.stop();
            assert_eq!((stop.because, stop.acknowledged), ("interrupted", true), "{what}");
            let is_one = presses.len() == 1;
            assert_eq!(stop.escalated, (!is_one).then_some("coast"), "{what}");
            assert_eq!(came.motion().standing, is_one.then_some(true), "{what}: off at once is no standstill");
            assert_eq!(stop.note.is_some(), !is_one, "{what}");
            assert_eq!(came.words().contains(&0x047A), !is_one, "{what}");
            assert!(came.is_given_back(), "{what}");
        }
    }
}

/// A motor may turn from before, so the stop word goes to whoever was taken, also where nothing was asked of him yet.
#[test]
fn who_interrupts_before_the_first_exchange_lets_no_motor_go_without_the_stop_word() {
    let whole = does(RUN, &driven(1, ""), Hand::default());
    let first = whole.first(0x047E);
    assert!(first > 3, "Slave_Diag, Set_Prm, Chk_Cfg stand before it");
    for press in 0..=first {
        let came = does(RUN, &driven(1, ""), Hand { presses: &[press], ..Hand::default() });
        let what = format!("behind telegram {press}: {:?}", came.failure());
        assert_eq!(came.code(), ("interrupted", 130), "{what}");
        let is_taken = came.words().contains(&0x047E);
        assert!(
            is_taken || came.moments().iter().all(|moment| ![Said::Clear, Said::Unlock].contains(&moment.said)),
            "{what}"
        );
        if is_taken {
            came.holds(&what);
        }
    }
}

#[test]
fn a_run_that_is_to_coast_does() {
    let came = does(&format!("{RUN} --on-exit coast"), &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    came.holds("coast");
    assert_eq!((came.stop().choice, came.stop().escalated), ("coast", None));
    assert_eq!(came.motion().standing, None);
    assert_eq!(came.words(), [0x047E, 0x0406, 0x047F, 0x047A, 0]);
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
            assert!(came.sent.is_empty() == (place == 0));
            assert!(came.words().iter().all(|stw| [0x047E, 0].contains(stw)), "{:04X?}", came.words());
        }
    }
}

#[test]
fn a_minute_at_a_question_is_no_watchdog() {
    let came = does(RUN, &module(RESTS, "", ""), Hand { thinks: Span::from_secs(60), ..Hand::default() });
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    came.holds("a minute");
    let gaps = came.sent.windows(2).map(|pair| pair[1].0.since(pair[0].0)).max().unwrap();
    assert!(gaps < Span::from_millis(100), "{gaps}");
    let span = came.sent.last().unwrap().0.since(came.sent[0].0);
    assert!(span > Span::from_secs(60), "{span}");
    // It was led to Data_Exchange once.
    let (parameterised, words) = (|said: Said| matches!(said, Said::Other), came.moments());
    let last = words.iter().rposition(|moment| parameterised(moment.said)).unwrap();
    assert!(last < 20, "led there anew at telegram {last}");
}

#[test]
fn what_is_agreed_to_names_what_is_changed_and_what_a_lost_bus_does() {
    let told = |line: &str, set: &str| {
        let came = does(line, &module(set, "", ""), Hand { denies: Some(1), ..Hand::default() });
        let details: Vec<String> = came.asked[1].details.iter().map(|text| text.en.to_string()).collect();
        details.join("\n")
    };
    let all = told(RUN, RESTS);
    for named in ["P.928 0 -> 1", "P.703 0 -> 2", "(P.703) = 0", "(P.620) = 1", "(P.89) = 1", "(P.88) = 1"] {
        assert!(all.contains(named), "{named}: {all}");
    }
    let plain = "sollwert 20Hz --enable --hold --duration 3s";
    for (lost, is_warned) in [(0, true), (1, false), (2, false), (3, false), (4, true)] {
        let set = RESTS.replace("\"703\" = 0", &format!("\"703\" = {lost}"));
        assert_eq!(told(plain, &set).contains("may not stop the motor"), is_warned, "{lost}");
        assert_eq!(told(RUN, &set).contains("-> 2 for the run"), is_warned, "{lost}");
    }
}

#[test]
fn a_start_that_is_not_obeyed_is_said_and_turns_nothing() {
    let no_right = RUN.replace("--take-control ", "");
    let came = does(&no_right, &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code(), ("forbidden.not_ready", 8), "{:?}", came.failure());
    came.holds("no right");
    assert!(came.is_given_back() && !came.words().contains(&0x047F), "{:04X?}", came.words());
    // Locked: nothing may be lent.
    let locked = module(&format!("{RESTS}, \"927\" = 0"), "", "");
    let came = does(RUN, &locked, Hand::default());
    assert_eq!(came.code().1, 6, "{:?}", came.failure());
    came.holds("locked");
    // A motor that its terminals run is not prepared.
    let driven = module(RESTS, "", &event("0s", "contact = true"));
    let came = does(&no_right, &driven, Hand::default());
    assert_eq!(came.code(), ("forbidden.not_still", 8), "{:?}", came.failure());
    assert!(
        !came.moments().iter().any(|moment| matches!(moment.said, Said::Words(0, _) | Said::Clear)),
        "no zero outputs"
    );
}

#[test]
fn a_trip_ends_a_run_and_starts_nothing_behind_it() {
    for readings in ["", "trip = \"silent\"", "start = \"level\""] {
        // At the question, on the ramp, at speed.
        for at in ["500ms", "3s", "4200ms", "5500ms"] {
            let came = does(RUN, &module(RESTS, readings, &event(at, "trip = true")), Hand::default());
            let what = format!("{readings} {at}");
            assert!(["forbidden.fault", "forbidden.tripped"].contains(&came.code().0), "{what}: {:?}", came.failure());
            came.holds(&what);
            assert_ne!(came.motion().standing, Some(true), "{what}: it coasts");
            assert!(came.is_given_back(), "{what}");
            let words = came.words();
            assert!(words.iter().filter(|stw| **stw & 1 != 0).count() <= 1, "{what}: {words:04X?}");
        }
    }
}

#[test]
fn a_fault_is_acknowledged_without_a_start_bit_and_with_the_edge_of_bit_7() {
    let tripped = |readings: &str| module(RESTS, readings, &event("100ms", "trip = true"));
    for readings in READINGS {
        let came = does("statemachine reset", &tripped(readings), Hand::default());
        assert_eq!(came.code(), ("", 0), "{readings}: {:?}", came.failure());
        came.holds(readings);
        assert_eq!(came.words(), [0x047E, 0x0406, 0x0486, 0x0406, 0x047E, 0], "{readings}");
        assert_eq!(came.motion().steps.len(), 1);
        assert_eq!(came.asked.len(), 1);
    }
    let came = does("statemachine reset", &module(RESTS, "", ""), Hand::default());
    assert_eq!(came.code(), ("forbidden.no_fault", 8));
    came.holds("no fault");
}

/// By terminals, whose right P.928 = 1 takes.
fn driven(right: u8, readings: &str) -> String {
    let set = RESTS.replace("\"928\" = 0", &format!("\"928\" = {right}"));
    module(&set, readings, &event("0s", "contact = true"))
}

#[test]
fn a_stop_asks_nobody_and_proves_the_standstill() {
    for verb in ["statemachine disable", "statemachine quick-stop", "sollwert 0Hz", "sollwert 0%"] {
        for readings in ["", "unlock = \"no-loss\"", "clear = \"loss\"", "without_control = \"ramp\""] {
            let came = does(verb, &driven(1, readings), Hand::default());
            let what = format!("{verb} {readings}");
            assert_eq!(came.code(), ("", 0), "{what}: {:?}", came.failure());
            came.holds(&what);
            assert!(came.asked.is_empty() && came.stop().acknowledged, "{what}");
            assert_eq!(came.words(), [0x047E, 0], "{what}");
        }
    }
    let came = does("statemachine disable-voltage", &driven(1, ""), Hand::default());
    assert_eq!((came.code(), came.words()), (("", 0), vec![0x047A, 0]));
    came.holds("disable-voltage");
}

#[test]
fn a_stop_that_is_not_obeyed_or_not_heard_says_that_the_shaft_may_turn() {
    // The terminals have it: no word of ours stops it, and it is said.
    let came = does("statemachine disable", &driven(0, ""), Hand::default());
    assert_eq!(came.code(), ("forbidden.not_still", 8), "{:?}", came.failure());
    assert_eq!((came.stop().acknowledged, came.motion().standing), (false, Some(false)));
    assert!(!came.moments().iter().any(|moment| matches!(moment.said, Said::Words(0, _) | Said::Clear)));
    for verb in ["statemachine disable", "sollwert 0"] {
        let cut = module(RESTS, "", &event("0s", "cut = true"));
        let came = does(verb, &cut, Hand::default());
        assert_eq!(came.code(), ("silence.no_reply", 4), "{verb}: {:?}", came.failure());
        let failure = came.failure().unwrap();
        assert!(failure.told().en.starts_with("THE SHAFT MAY STILL TURN: no stop was sent"), "{}", failure.told().en);
        assert!(!came.stop().acknowledged, "{verb}");
    }
}

/// Its ramp is what the first Ctrl-C asks for, and the second wants more.
#[test]
fn whoever_interrupts_the_own_end_of_a_run_has_its_ramp_and_whoever_insists_lets_it_coast() {
    let undisturbed = on_time("");
    let start = undisturbed.first(0x047F);
    let stop =
        start + undisturbed.moments()[start..].iter().position(|moment| moment.said == Said::Words(0x047E, 0)).unwrap();
    for presses in [&[stop + 10][..], &[stop + 10, stop + 20], &[stop + 10, stop + 10]] {
        let came = does(RUN, &module(RESTS, "", ""), Hand { presses, ..Hand::default() });
        came.holds("pressed");
        let is_one = presses.len() == 1;
        assert_eq!(came.code(), ("interrupted", 130), "{presses:?}: {:?}", came.failure());
        assert_eq!(came.words().contains(&0x047A), !is_one, "{presses:?}: {:04X?}", came.words());
        let stop = came.stop();
        assert_eq!((stop.because, stop.escalated), ("interrupted", (!is_one).then_some("coast")), "{presses:?}");
        assert_eq!(came.motion().standing, is_one.then_some(true), "{presses:?}");
        assert_eq!(came.failure().unwrap().alarm, !is_one, "{presses:?}");
        assert!(came.is_given_back(), "{presses:?}");
    }
}

#[test]
fn whoever_interrupts_a_stop_lets_it_coast() {
    let bench = driven(1, "");
    let stop = does("statemachine disable", &bench, Hand::default()).first(0x047E);
    let came = does("statemachine disable", &bench, Hand { presses: &[stop + 5], ..Hand::default() });
    came.holds("pressed");
    assert!(came.words().contains(&0x047A), "{:04X?}", came.words());
    assert_eq!(came.stop().escalated, Some("coast"));
}

/// A closed contact starts the motor as soon as P.928 is 0 again.
#[test]
fn control_is_not_given_back_where_that_starts_the_motor() {
    for (contact, note) in [("0s", "turned before"), ("4s", "started at once")] {
        let bench = module(RESTS, "", &event(contact, "contact = true"));
        let came = does(RUN, &bench, Hand::default());
        assert_eq!(came.code(), ("partial.not_given_back", 9), "{contact}: {:?}", came.failure());
        came.holds(contact);
        let motion = came.motion();
        assert!(motion.notes.iter().any(|told| told.en.contains(note)), "{contact}: {:?}", motion.notes);
        let right = motion.changed.iter().find(|change| change.param == 928).unwrap();
        assert!(!right.restored && motion.standing == Some(true), "{contact}");
    }
}

/// The wire is cut at speed, for less than the watchdog, for longer, for good.
#[test]
fn a_slave_that_is_lost_is_stopped_by_itself_or_by_us() {
    for lost in 0..=4 {
        for basic in [0, 1] {
            let set = RESTS.replace("\"703\" = 0", &format!("\"703\" = {lost}")) + &format!(", \"620\" = {basic}");
            for (until, is_back) in [("5200ms", true), ("8s", true), ("500s", false)] {
                let events = event("5s", "cut = true") + &event(until, "cut = false");
                let plain = "sollwert 20Hz --enable --hold --duration 6s --take-control";
                for line in [plain.to_owned(), format!("{plain} --watchdog 2s")] {
                    let came = does(&line, &module(&set, "", &events), Hand::default());
                    let what =
                        format!("{line}: P.703 = {lost}, P.620 = {basic}, cut until {until}: {:?}", came.failure());
                    match (until, is_back) {
                        // Missing answers are borne.
                        ("5200ms", _) => assert_eq!(came.code(), ("", 0), "{what}"),
                        (_, true) => assert_eq!(came.code(), ("refused.left", 6), "{what}"),
                        _ => assert_eq!(came.code().1, 4, "{what}"),
                    }
                    if is_back {
                        came.holds(&what);
                        continue;
                    }
                    let message = &came.failure().unwrap().told().en;
                    assert!(message.starts_with("THE SHAFT MAY STILL TURN"), "{message}");
                    let hint = &came.failure().unwrap().hint.as_ref().unwrap().en;
                    let stands = came.later()[0] == 0;
                    let stops = line.contains("--watchdog") || lost != 0;
                    assert_eq!(stands, stops, "{what}");
                    let in_force = if line.contains("--watchdog") && [0, 4].contains(&lost) { 2 } else { lost };
                    assert!(hint.contains(&format!("P.703 = {in_force}")), "{what}: {hint}");
                    let notes: Vec<_> = came.motion().notes.iter().map(|note| note.en.to_string()).collect();
                    let note = notes.iter().find(|note| note.contains("(P.703)")).unwrap();
                    assert!(note.contains(&format!("(P.703) = {in_force}")), "{what}: {note}");
                }
            }
        }
    }
}

/// While its scale is measured and P.611 and P.600 are asked, too: whoever comes back finds no start word.
#[test]
fn a_slave_that_is_lost_as_it_starts_is_not_started_anew() {
    let whole = on_time("");
    let (begun, _) = whole.sent[whole.first(0x047F)];
    for later in (0..600).step_by(30) {
        let at = begun.since(Tick::ZERO).as_millis() + later;
        let back = at + 2_500;
        let events = event(&format!("{at}ms"), "cut = true") + &event(&format!("{back}ms"), "cut = false");
        let came = does(RUN, &module(RESTS, "", &events), Hand::default());
        let what = format!("{later} ms behind the first start word: {:?}", came.failure());
        assert_eq!(came.code(), ("refused.left", 6), "{what}");
        came.holds(&what);
        // What goes to a slave that has left is refused; behind Slave_Diag it counts again.
        let back = Tick::ZERO + Span::from_millis(back);
        let moments = came.moments();
        let led = moments.iter().skip_while(|moment| moment.at < back || moment.said != Said::Other);
        assert!(led.clone().count() > 4, "{what}");
        assert!(led.into_iter().all(|moment| !matches!(moment.said, Said::Words(0x047F, _))), "{what}");
    }
}

#[test]
fn a_port_that_is_lost_at_any_telegram_leaves_no_shaft_turning() {
    no_lost_port_leaves_a_shaft_turning(|| on_time(""), 0x047F);
}

#[test]
fn who_is_killed_leaves_it_to_the_watchdog() {
    let whole = on_time("");
    let turning = whole.killed().iter().position(|shaft| *shaft != 0);
    assert_eq!(turning, None, "of {}", whole.sent.len());
    // What the question warns of without --watchdog: P.703 = 0 keeps it running.
    let line = RUN.replace(" --watchdog 2s", "");
    let came = does(&line, &module(RESTS, "", ""), Hand::default());
    assert_ne!(came.killed()[came.first(0x047F) + 80], 0);
}

/// Any end at any step, under any readings, with whatever happens to the line: a die of its own, the same every time.
#[test]
fn dice_over_ends_and_steps_leave_no_shaft_turning() {
    let mut die = die(7);
    let all = on_time("").sent.len();
    for round in 0..120 {
        let readings = READINGS[die(READINGS.len())];
        let at = format!("{}ms", 600 + die(9_000));
        let later = format!("{}ms", 700 + die(12_000));
        let events = match die(5) {
            0 => event(&at, "trip = true"),
            1 => event(&at, "cut = true"),
            2 => event(&at, "cut = true") + &event(&later, "cut = false"),
            _ => String::new(),
        };
        let lost = ["", "flips = 2", "losses = 3", "latency = \"4ms\""][die(4)];
        let bench = format!("[line]\nseed = {round}\n{lost}\n{}", module(RESTS, readings, &events));
        let mut presses: Vec<usize> = (0..die(4)).map(|_| die(all)).collect();
        presses.sort_unstable();
        let pulled = (die(4) == 0).then(|| die(all) as u64);
        witness::pull_after(pulled);
        let line = if die(3) == 0 { format!("{RUN} --on-exit coast") } else { RUN.to_owned() };
        let came = does(&line, &bench, Hand { presses: &presses, ..Hand::default() });
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

/// The shaft came down while nobody saw it.
const UNSEEN: &str = "forbidden.standstill_unproven";

/// The port takes no bytes for so long at speed, in the ramp down and around the end of the time, and then takes them again: nothing but
/// our stop takes the motor back, because P.703 keeps it running.
#[test]
fn a_port_that_takes_bytes_again_takes_the_stop() {
    for watchdog in ["", " --watchdog 200ms", " --watchdog 10s"] {
        let line = format!("sollwert 20Hz --enable --hold --duration 4s --take-control{watchdog}");
        for (at, by) in
            ["5s", "7s", "8s"].iter().flat_map(|at| ["300ms", "1500ms", "2600ms", "4s", "5s"].map(|by| (at, by)))
        {
            // The end goes out for 6 s from its begin on, which is shortly before 8 s.
            let stuck = format!("[[stuck]]\nat = \"{at}\"\nby = \"{by}\"\n");
            let came = does(&line, &module(RESTS, "", &stuck), Hand::default());
            let what = format!("{watchdog} {at} {by}: {:?}", came.failure());
            came.holds(&what);
            assert!(came.stop().acknowledged && came.is_given_back(), "{what}");
            assert!(["", "refused.left", "port.stuck", UNSEEN].contains(&came.code().0), "{what}");
            let spell = |text: &str| text.parse::<Span>().unwrap();
            let (from, over) = (Tick::ZERO + spell(at), Tick::ZERO + spell(at) + spell(by));
            let sent = came.sent.iter().filter(|(sent, _)| (from..over).contains(sent)).count();
            assert!(sent <= 16, "{what}: {sent} telegrams into the stuck port");
        }
    }
}

#[test]
fn a_port_that_takes_no_bytes_for_a_while_keeps_no_stop_from_its_motor() {
    for verb in ["statemachine disable", "statemachine disable-voltage", "sollwert 0"] {
        // While the configuration is asked for, the slave is led, and the motor stops.
        for at in ["1250ms", "1300ms", "1400ms", "1500ms", "1800ms"] {
            for by in ["400ms", "1s", "2600ms"] {
                let stuck = format!("[[stuck]]\nat = \"{at}\"\nby = \"{by}\"\n");
                let came = does(verb, &(driven(1, "") + &stuck), Hand::default());
                let what = format!("{verb} {at} {by}: {:?}", came.failure());
                assert!(["", UNSEEN].contains(&came.code().0), "{what}");
                came.holds(&what);
                assert!(came.stop().acknowledged, "{what}");
            }
        }
    }
}

/// A contact that was closed in the run starts the motor where outputs of zero give it to the terminals.
#[test]
fn a_motor_that_outputs_of_zero_start_is_stopped_again() {
    let line = "sollwert 20Hz --enable --hold --duration 3s --watchdog 2s";
    let set = RESTS.replace("\"928\" = 0", "\"928\" = 1");
    for (readings, code) in [("without_control = \"local\"", ("forbidden.terminals", 8)), ("", ("", 0))] {
        for at in ["4s", "6s"] {
            let bench = module(&set, readings, &event(at, "contact = true"));
            let came = does(line, &bench, Hand::default());
            let what = format!("{readings} {at}: {:?}", came.failure());
            assert_eq!(came.code(), code, "{what}");
            came.holds(&what);
            let motion = came.motion();
            assert_eq!((motion.running, motion.standing), (Some(false), Some(true)), "{what}");
            assert_eq!(came.moments().last().unwrap().shaft, 0, "{what}");
        }
    }
    // So is one that its terminals ran before it was taken.
    let came = does("statemachine disable", &driven(1, "without_control = \"local\""), Hand::default());
    assert_eq!(came.code(), ("forbidden.terminals", 8), "{:?}", came.failure());
    came.holds("driven before");
}
