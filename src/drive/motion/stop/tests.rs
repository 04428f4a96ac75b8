//! The words of the stops, and which of them follows.

use super::super::look::watchdog_seconds;
use super::super::watchdog_words;
use super::*;
use crate::profile::Registry;
use crate::text::Lang;

#[test]
fn every_stop_has_its_word_and_a_stronger_one() {
    use StopChoice::{Coast, Keep, QuickStop, Ramp};
    for (choice, word, stronger) in [
        (Ramp, "ramp", Some(QuickStop)),
        (QuickStop, "quick-stop", Some(Coast)),
        (Coast, "coast", None),
        (Keep, "keep", None),
    ] {
        assert_eq!((choice.slug(), choice.stronger(), StopChoice::of(word)), (word, stronger, choice));
    }
    assert_eq!(StopChoice::of("anything"), Coast, "what nobody knows takes the power away");
}

#[test]
fn what_the_watchdog_does_is_said_with_its_time() {
    let family = Registry::open(&[]).unwrap().family("lxm05").unwrap();
    let words = |raw: Option<i64>, lang: Lang| {
        watchdog_words(&family, raw.map(|raw| watchdog_seconds(&family, raw))).get(lang).to_owned()
    };
    assert!(words(Some(0), Lang::En).ends_with("is off"), "{}", words(Some(0), Lang::En));
    assert!(words(Some(0), Lang::De).ends_with("ist aus"), "{}", words(Some(0), Lang::De));
    assert!(words(Some(1_500), Lang::En).contains("is 1.500 s: it makes a quick stop"));
    assert!(words(Some(1_500), Lang::De).contains("steht auf 1.500 s: er löst"));
    assert!(words(None, Lang::En).contains("not known") && words(None, Lang::De).contains("unbekannt"));
}
