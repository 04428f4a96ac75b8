//! Words for a stop that are no verbs here: whoever types one may have a turning shaft, and nothing else is what he means.

use crate::profile::is_nearly;
use crate::text::{Text, both};

/// What people call it, in both languages.
const STOPS: &[&str] = &[
    "stop",
    "stopp",
    "stoppen",
    "halt",
    "halten",
    "anhalten",
    "brake",
    "bremsen",
    "off",
    "aus",
    "ausschalten",
    "emergency-stop",
    "estop",
    "e-stop",
    "notaus",
    "not-aus",
    "nothalt",
    "not-halt",
    "schnellhalt",
    "quickstop",
];

/// How a shaft is stopped, if that is what the word asks for, or is one slip of the keyboard away from it.
pub fn stop_meant(word: &str) -> Option<Text> {
    STOPS.iter().any(|stop| is_nearly(stop, word)).then(|| {
        both!(
            "a drive is stopped by `antrieb statemachine quick-stop`",
            "ein Antrieb wird angehalten mit `antrieb statemachine quick-stop`"
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stop_is_known_by_its_words_and_no_verb_is_one() {
        for word in ["stop", "STOP", "stpo", "halt", "Not-Aus", "not aus", "aus", "off", "anhaltn"] {
            assert!(stop_meant(word).is_some(), "{word}");
        }
        for word in crate::command::VERBS.iter().map(|verb| verb.name).chain(["start", "enable", "start", "shutdown"]) {
            assert!(stop_meant(word).is_none(), "{word}");
        }
    }
}
