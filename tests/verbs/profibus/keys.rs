//! The keypad of a run over PROFIBUS: a key stops it, a dead man starts it and stops it.

use super::rig::{Came, Hand, RESTS, Said, does, event, module};
use crate::pictures::are_documented;
use antrieb::drive::Button;
use antrieb::outcome::{Event, Record};

const RUN: &str = "sollwert 10Hz --enable --hold --duration 30s --take-control --watchdog 2s";

fn held(options: &str, buttons: &[(usize, Button)]) -> Came {
    does(&format!("{RUN} {options}"), &module(RESTS, "", ""), Hand { buttons, ..Hand::default() })
}

#[test]
fn a_key_stops_a_run_that_is_held() {
    for buttons in [&[(300, Button::Stop), (900, Button::End)][..], &[(300, Button::End)]] {
        let came = held("--view", buttons);
        assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
        assert_eq!((came.stop().because, came.stop().standing), ("key", Some(true)));
        assert!(came.is_given_back() && came.sent.len() > 300);
        came.holds("a key");
    }
}

/// As on every other line: the key that stops leaves the view, which shows the drive under the stop word until somebody leaves.
#[test]
fn the_view_stays_behind_a_stop_until_somebody_leaves() {
    let by_key = held("--view", &[(300, Button::Stop), (1_000, Button::End)]);
    let by_signal = does(
        &format!("{RUN} --view"),
        &module(RESTS, "", ""),
        Hand { buttons: &[(300, Button::Stop)], presses: &[1_000], ..Hand::default() },
    );
    for came in [by_key, by_signal] {
        assert_eq!((came.code(), came.stop().because), (("", 0), "key"), "{:?}", came.failure());
        assert!(came.sent.len() > 1_000 && came.is_given_back(), "{}", came.sent.len());
        let over = came.story.iter().position(|event| {
            matches!(event, Event::Record(record) if matches!(&**record, Record::Run(news) if news.phase == "ended"))
        });
        let behind = &came.story[over.unwrap()..];
        let is_shown = |event: &&Event| matches!(event, Event::Record(record) if matches!(**record, Record::Sample(_)));
        assert!(behind.iter().filter(is_shown).count() > 20, "the motor is shown on");
        assert!(matches!(&behind[1], Event::Note(told) if told.en.contains("the shaft stands")), "{:?}", behind[1]);
        assert!(came.moments()[400..1_000].iter().all(|moment| !matches!(moment.said, Said::Words(0, _))));
        came.holds("the view stayed");
    }
    // `q` stops and ends at once.
    assert!(held("--view", &[(300, Button::End)]).sent.len() < 700);
}

/// Whoever looks away while the view stays and whose slave is lost meanwhile is told so.
#[test]
fn a_slave_that_is_lost_while_the_view_stays_ends_it() {
    let cut = module(RESTS, "", &event("30s", "cut = true"));
    let came = does(&format!("{RUN} --view"), &cut, Hand { buttons: &[(300, Button::Stop)], ..Hand::default() });
    assert_eq!(came.code().1, 4, "{:?}", came.failure());
    // It was seen to stand, and what it does now is not known.
    assert_eq!((came.stop().acknowledged, came.motion().standing), (true, Some(true)));
    assert!(came.motion().to.is_none() && came.motion().running.is_none());
    came.holds("lost behind its stop");
}

/// A trip is a record at once, with its cause where one is told, and with what was seen last before it.
#[test]
fn a_trip_in_a_held_run_is_a_record() {
    for mode in ["", "--mode basic"] {
        let run = if mode.is_empty() { RUN.to_owned() } else { RUN.replace(" --take-control", "") };
        let tripped = module(RESTS, "", &event("9s", "trip = true"));
        let came = does(&format!("{run} {mode}"), &tripped, Hand::default());
        assert_eq!(came.code().0, "forbidden.tripped", "{mode}: {:?}", came.failure());
        let trips: Vec<usize> = (0..came.story.len())
            .filter(|at| matches!(&came.story[*at], Event::Record(record) if matches!(**record, Record::Trip(_))))
            .collect();
        let [at] = trips[..] else { panic!("{mode}: {} trips", trips.len()) };
        let Event::Record(record) = &came.story[at] else { panic!() };
        let Record::Trip(trip) = &**record else { panic!() };
        assert_eq!(trip.fault.as_ref().map(|fault| &*fault.key), (!mode.is_empty()).then_some("25h"), "{mode}");
        assert!(trip.before.state.as_ref().is_some_and(|state| state.slug != "fault"), "{mode}");
        let seen = trip.before.values.iter().find(|row| [701, 614].contains(&row.value.param)).unwrap();
        assert!((995..=1_000).contains(&seen.value.value.unwrap().raw), "{mode}: 10 Hz");
        let Event::Record(next) = &came.story[at + 1] else { panic!("{mode}") };
        let is_it = matches!(&**next, Record::Sample(sample) if sample.t == trip.t
            && sample.state.as_ref().is_some_and(|state| state.slug == "fault"));
        assert!(is_it, "{mode}: the sample that shows it");
        came.holds(mode);
    }
}

/// The view stays behind its stop, whoever holds the key on or presses it anew: elsewhere that would go to the shell.
#[test]
fn a_dead_man_runs_it_only_as_long_as_a_key_is_held_and_its_view_stays() {
    // Repeats come faster than 300 ms: a telegram takes some 27 ms.
    let held_for = |telegrams: std::ops::Range<usize>| telegrams.step_by(8).map(|telegram| (telegram, Button::Hold));
    for mode in ["", "--mode basic"] {
        let run = if mode.is_empty() { RUN.to_owned() } else { RUN.replace(" --take-control", "") };
        let mut buttons: Vec<_> = held_for(200..400).chain(held_for(420..900)).collect();
        buttons.push((1_600, Button::End));
        let hand = Hand { buttons: &buttons, ..Hand::default() };
        let came = does(&format!("{run} --dead-man {mode}"), &module(RESTS, "", ""), hand);
        assert_eq!(came.code(), ("", 0), "{mode}: {:?}", came.failure());
        assert_eq!((came.stop().because, came.stop().standing), ("dead-man", Some(true)), "{mode}");
        let (starts, stops) = if mode.is_empty() { (0x047F, 0x047E) } else { (0x0051, 0x0050) };
        assert!(came.first(starts) > 200, "{mode}: it waits for the key");
        assert!(came.sent.len() > 1_600 && came.is_given_back(), "{mode}: {}", came.sent.len());
        let words = came.words();
        assert_eq!(words.iter().filter(|word| **word == starts).count(), 1, "{mode}: {words:04X?}");
        assert!(words.contains(&stops), "{mode}: {words:04X?}");
        came.holds("let go");
    }
}

#[test]
fn who_interrupts_is_no_key_and_without_keys_nothing_is_sent() {
    let came = does(&format!("{RUN} --view"), &module(RESTS, "", ""), Hand { presses: &[300], ..Hand::default() });
    assert_eq!(came.code().1, 130);
    assert_eq!(came.stop().because, "interrupted");
    came.holds("Ctrl-C");
}

/// One watches the motor come down: the stop is told at its first telegram, and what the slave tells goes on until it stands.
#[test]
fn a_stop_is_shown_until_the_motor_stands() {
    let by_key = || held("--view", &[(300, Button::Stop), (900, Button::End)]);
    let by_signal =
        || does(&format!("{RUN} --view"), &module(RESTS, "", ""), Hand { presses: &[300], ..Hand::default() });
    for came in [by_key(), by_signal()] {
        let mut columns = Vec::new();
        let mut phase = "";
        let mut down = Vec::new();
        for event in &came.story {
            let Event::Record(record) = event else { continue };
            match &**record {
                Record::Start(start) => columns.clone_from(&start.drives[0].columns),
                Record::Run(news) => {
                    phase = news.phase;
                    assert!(phase != "stopping" || news.setpoint.is_none(), "nobody gives a setpoint any more");
                }
                Record::Sample(sample) => {
                    let value = |role| {
                        let column = columns.iter().find(|column| column.role == Some(role)).unwrap();
                        sample
                            .values
                            .iter()
                            .find(|value| column.holds(&value.value))
                            .and_then(|value| value.value.value)
                    };
                    // A slave that has outputs of zero reads 0, which is no state.
                    let is_over = value("actual-frequency").is_some_and(|value| value.raw == 0);
                    assert!(sample.state.is_some() || is_over, "{phase}");
                    assert!(phase == "starting" || value("actual-frequency").is_some());
                    if matches!(phase, "stopping" | "ended") {
                        down.push((value("actual-frequency").unwrap().raw, value("setpoint-bus").unwrap().raw));
                    }
                }
                _ => {}
            }
        }
        assert!(down.len() > 3 && down.iter().rev().is_sorted(), "{down:?}");
        assert!(down.first().unwrap().0 > 500 && down.last().unwrap().0 == 0, "{down:?}");
        assert!(down.iter().all(|(_, setpoint)| *setpoint == 0), "{down:?}");
    }
}

/// `docs/screens/run-profibus.*.txt`.
#[test]
fn pictures_of_a_run_over_profibus_are_those_of_the_bench() {
    let came = held("--view", &[(400, Button::Stop), (1_000, Button::End)]);
    are_documented("run-profibus", &came.story, &[("held", 12, false), ("stopping", 1, false)]);
}

/// As on every other line, and not only with the end: whoever stands beside it must know at once.
#[test]
fn a_stop_that_is_not_obeyed_is_told_at_once_and_stays() {
    for (mode, most) in [("", 22), ("--mode basic", 12)] {
        let run = if mode.is_empty() { RUN.to_owned() } else { RUN.replace(" --take-control", "") };
        let dragged = module(RESTS, "", &event("6s", "dragged = true"));
        let buttons = &[(300, Button::Stop), (2_000, Button::End)][..];
        let came = does(&format!("{run} --view {mode}"), &dragged, Hand { buttons, ..Hand::default() });
        let is_alarm =
            |event: &Event| matches!(event, Event::Note(told) if told.en.starts_with("THE SHAFT MAY STILL TURN"));
        let stopping = came
            .story
            .iter()
            .position(|event| matches!(event, Event::Record(record) if matches!(&**record, Record::Run(news) if news.phase == "stopping")))
            .unwrap();
        let behind = &came.story[stopping..];
        let alarm = behind.iter().position(is_alarm).unwrap_or_else(|| panic!("{mode}: {:?}", came.failure()));
        let samples = |events: &[Event]| {
            events
                .iter()
                .filter(|event| matches!(event, Event::Record(record) if matches!(**record, Record::Sample(_))))
                .count()
        };
        // One sample in 250 ms, and 3 s.
        assert!((8..=most).contains(&samples(&behind[..alarm])), "{mode}: {}", samples(&behind[..alarm]));
        let Event::Note(told) = &behind[alarm] else { panic!("{mode}") };
        assert!(told.en.contains("what stops it now") && told.de.contains("was ihn jetzt anhält"), "{mode}: {told:?}");
        assert_eq!(came.code().1, 8, "{mode}: {:?}", came.failure());
        assert!(came.failure().unwrap().alarm, "{mode}");
        // Who interrupts has interrupted it, and is told the same.
        let dragged = module(RESTS, "", &event("6s", "dragged = true"));
        let came = does(&format!("{run} --view {mode}"), &dragged, Hand { presses: &[300], ..Hand::default() });
        let failure = came.failure().unwrap();
        assert_eq!((came.code().1, failure.alarm), (130, true), "{mode}: {failure:?}");
        assert!(failure.message.en.starts_with("interrupted; "), "{mode}: {failure:?}");
        assert!(!failure.message.en.contains("THE SHAFT"), "{mode}: said once, and first: {failure:?}");
    }
}

#[test]
fn who_interrupts_a_run_is_told_what_came_of_its_stop() {
    let came = does(RUN, &module(RESTS, "", ""), Hand { presses: &[300], ..Hand::default() });
    assert_eq!(came.failure().unwrap().message.en, "interrupted; ramp: the stop was acknowledged");
}
