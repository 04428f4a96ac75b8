//! What people call the verbs, in both languages: whoever types one of these words is told the verb.

use crate::profile::fold;

/// The words of each command.
const MEANT: &[(&str, &[&str])] = &[
    ("scan", &["suchen", "suche", "such", "finden", "find", "search"]),
    ("identify", &["identifizieren", "erkennen", "who", "wer"]),
    ("read", &["lesen", "lese", "lies", "auslesen", "get", "show", "anzeigen", "zeigen"]),
    ("write", &["schreiben", "schreibe", "schreib", "set", "setzen", "setze", "put"]),
    ("dataset save", &["save", "sichern", "speichern", "backup", "sicherung"]),
    ("dataset load", &["load", "laden", "lade", "restore", "einspielen"]),
    ("dataset undo", &["undo", "rückgängig", "zurücknehmen"]),
    ("dataset diff", &["diff", "vergleichen", "vergleiche", "vergleich", "compare"]),
    ("init", &["anlegen", "new", "neu"]),
    ("plan", &["planen", "preview", "vorschau"]),
    ("apply", &["anwenden", "übertragen"]),
    ("check", &["prüfen", "prüfe"]),
    ("diag", &["diagnose", "diagnostizieren", "fehler", "störung", "faults"]),
    ("statemachine show", &["zustand", "status"]),
    ("statemachine enable", &["freigeben", "freigabe"]),
    ("statemachine reset", &["quittieren", "quittiere", "acknowledge"]),
    ("sollwert", &["drehzahl", "frequenz", "speed", "frequency"]),
    ("monitor", &["beobachten", "überwachen", "watch"]),
    ("plot", &["zeichnen", "draw"]),
    ("protocol", &["protokoll"]),
    ("line", &["leitung"]),
    ("params", &["parameter", "parameters", "katalog", "list"]),
    ("report", &["bericht"]),
    ("procedure", &["prozedur", "inbetriebnahme", "commission", "guide", "anleitung"]),
    ("decode", &["dekodieren", "entschlüsseln", "explain"]),
    ("sniff", &["mithören", "mitlesen", "lauschen", "listen"]),
    ("simulate", &["simulieren", "simulator", "simulation"]),
    ("--help", &["hilfe"]),
];

/// The command that a word means, as it is typed behind `antrieb`.
pub fn meant(word: &str) -> Option<&'static str> {
    let word = fold(word);
    MEANT.iter().find(|(_, words)| words.iter().any(|said| fold(said) == word)).map(|(command, _)| *command)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command::{VERBS, stop_meant};

    #[test]
    fn every_word_leads_to_a_command_that_there_is_and_is_none_itself() {
        for (command, words) in MEANT {
            let mut path = command.split(' ');
            let verb = path.next().unwrap();
            let entry = VERBS.iter().find(|entry| entry.name == verb);
            let inner =
                entry.zip(path.next()).is_none_or(|(entry, inner)| (entry.command)().find_subcommand(inner).is_some());
            assert!(inner && (entry.is_some() || *command == "--help"), "{command}");
            for word in *words {
                assert_eq!(meant(word), Some(*command), "{word} stands there twice");
                assert!(VERBS.iter().all(|entry| entry.name != *word && entry.alias != Some(*word)), "{word}");
                assert!(stop_meant(word).is_none(), "{word}");
            }
        }
        assert_eq!([meant("PRUEFEN"), meant("Schreib"), meant("stop")], [Some("check"), Some("write"), None]);
    }
}
