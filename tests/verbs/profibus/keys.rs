//! The keypad of a run over PROFIBUS: a key stops it, a dead man starts it and stops it.

use super::rig::{Came, Hand, RESTS, does, module};
use antrieb::drive::Button;

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
