//! The keypad of a run over PROFIBUS: a key stops it, a dead man starts it and stops it.

use super::rig::{Came, Hand, RESTS, does, module};
use crate::pictures::are_documented;
use antrieb::drive::Button;
use antrieb::outcome::{Event, Record};

const RUN: &str = "sollwert 10Hz --enable --hold --duration 30s --take-control --watchdog 2s";

fn held(options: &str, buttons: &[(usize, Button)]) -> Came {
    does(&format!("{RUN} {options}"), &module(RESTS, "", ""), Hand { buttons, ..Hand::default() })
}

#[test]
fn a_key_stops_a_run_that_is_held() {
    for button in [Button::Stop, Button::End] {
        let came = held("--view", &[(300, button)]);
        assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
        assert_eq!((came.stop().because, came.stop().standing), ("key", Some(true)));
        assert!(came.is_given_back() && came.sent.len() > 300);
        came.holds("a key");
    }
}

#[test]
fn a_dead_man_runs_it_only_as_long_as_a_key_is_held() {
    // Repeats come faster than 300 ms: a telegram takes some 27 ms.
    let repeats: Vec<_> = (200..400).step_by(8).map(|telegram| (telegram, Button::Hold)).collect();
    let came = held("--dead-man", &repeats);
    assert_eq!(came.code(), ("", 0), "{:?}", came.failure());
    assert_eq!((came.stop().because, came.stop().standing), ("dead-man", Some(true)));
    assert!(came.first(0x047F) > 200, "it waits for the key");
    came.holds("let go");
    let stop = came.words().iter().rposition(|word| *word == 0x047E);
    assert!(stop.is_some());
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
    let by_key = || held("--view", &[(300, Button::Stop)]);
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
                    assert!(sample.state.is_some() && (phase == "starting" || value("actual-frequency").is_some()));
                    if phase == "stopping" {
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
    let came = held("--view", &[(400, Button::Stop)]);
    are_documented("run-profibus", &came.story, &[("held", 12, false), ("stopping", 1, false)]);
}
