//! The words of tables in both languages.

use crate::profile::Lang;

/// The word for `english` in `lang`. A word without a row is a mistake of ours: tests end at it, a user reads it in English.
pub(super) fn word(lang: Lang, english: &str) -> &str {
    let row = || GERMAN.iter().find(|row| row.0 == english);
    match lang {
        Lang::En => english,
        Lang::De if english.is_empty() => english,
        Lang::De => {
            let german = row();
            debug_assert!(german.is_some(), "no German word for '{english}'");
            german.map_or(english, |row| row.1)
        }
    }
}

const GERMAN: &[(&str, &str)] = &[
    // The live view.
    ("actual", "Istwert"),
    ("connecting", "verbinde"),
    ("current", "Strom"),
    ("DC link", "Zwischenkreis"),
    ("end", "Ende"),
    ("gap", "Lücke"),
    ("gaps", "Lücken"),
    ("next drive", "nächster Antrieb"),
    ("PORT LOST", "ANSCHLUSS VERLOREN"),
    ("raw", "roh"),
    // The line.
    ("adapter", "Adapter"),
    ("adapter errors", "Adapterfehler"),
    ("granted", "gewährt"),
    ("latency timer", "Latenzzeit"),
    ("low latency", "geringe Latenz"),
    ("nothing to complain of", "nichts zu beanstanden"),
    ("stored, holds after power-on", "gespeichert, gilt ab dem nächsten Einschalten"),
    ("raw, implausible", "Rohwert, unplausibel"),
    ("expected", "erwartet"),
    ("stored, not in force", "gespeichert, nicht wirksam"),
    ("pauses", "Pausen"),
    ("refused", "abgelehnt"),
    ("required", "nötig"),
    ("RS-485 direction", "RS-485-Richtung"),
    ("unknown", "unbekannt"),
    ("unsupported", "nicht angeboten"),
    // Moving a drive to other line settings.
    ("proven", "bewiesen"),
    ("undone", "zurückgestellt"),
    ("failed", "gescheitert"),
    ("moved", "umgestellt"),
    ("left as it was", "gelassen, wie er war"),
    ("halfway", "auf halbem Weg"),
    ("lost", "verloren"),
    ("to", "nach"),
    ("answers at", "antwortet unter"),
    ("perhaps at", "vielleicht unter"),
    ("after a restart", "nach einem Neustart"),
    ("way back", "Rückweg"),
    // A search.
    ("port", "Anschluss"),
    ("line", "Leitung"),
    ("protocol", "Protokoll"),
    // The rest.
    ("access", "Zugriff"),
    ("acknowledged", "bestätigt"),
    ("NOT acknowledged", "NICHT bestätigt"),
    ("no stop", "kein Halt"),
    ("not known", "nicht bekannt"),
    ("interrupted", "unterbrochen"),
    ("key", "Taste"),
    ("dead-man", "Totmann"),
    ("error", "Fehler"),
    ("standstill NOT proven", "Stillstand NICHT belegt"),
    ("actual value", "Istwert"),
    ("changed", "geändert"),
    ("command", "Befehl"),
    ("given back", "zurückgestellt"),
    ("NOT given back", "NICHT zurückgestellt"),
    ("missing", "fehlt"),
    ("not reached", "nicht erreicht"),
    ("reached", "erreicht"),
    ("running", "läuft weiter"),
    ("powered, held at standstill", "mit Strom, im Stillstand gehalten"),
    ("the shaft still turns", "die Welle dreht noch"),
    ("whether the shaft stands is not told", "ob die Welle steht, zeigt nichts"),
    ("setpoint", "Sollwert"),
    ("makes", "ergibt"),
    ("stop", "Halt"),
    ("took", "Dauer"),
    ("active set", "aktiver Datensatz"),
    ("actual values", "Istwerte"),
    ("addr", "Adr"),
    ("after a reset", "nach Reset"),
    ("asked", "gefragt"),
    ("at once", "sofort"),
    ("bit", "Bit"),
    ("bits", "Bits"),
    ("cause", "Ursache"),
    ("control mode", "Steuerung"),
    ("control word", "Steuerwort"),
    ("could not be read", "nicht lesbar"),
    ("count", "Anzahl"),
    ("counters cleared", "Zähler gelöscht"),
    ("data sets", "Datensätze"),
    ("decimals", "Nachkommastellen"),
    ("default", "Werkseinstellung"),
    ("drive", "Antrieb"),
    ("equal", "gleich"),
    ("error rate", "Fehlerrate"),
    ("echo", "Echo"),
    ("error register", "Fehlerregister"),
    ("evidence", "Beleg"),
    ("fault", "Störung"),
    ("fault memory", "Fehlerspeicher"),
    ("field", "Feld"),
    ("from", "aus"),
    ("from here", "von hier"),
    ("garbled", "gestört"),
    ("group", "Gruppe"),
    ("hazard", "Gefahr"),
    ("motion", "Bewegung"),
    ("reset", "Neustart"),
    ("hint", "Hinweis"),
    ("link test", "Leitungstest"),
    ("meaning", "Bedeutung"),
    ("median", "Median"),
    ("module", "Modul"),
    ("ms", "ms"),
    ("name", "Name"),
    ("new", "neu"),
    ("no", "nein"),
    ("node", "Knoten"),
    ("none", "keine"),
    ("not fitted", "nicht vorhanden"),
    ("note", "Anmerkung"),
    ("old", "alt"),
    ("param", "Param"),
    ("present", "vorhanden"),
    ("range", "Bereich"),
    ("raw, decimals unknown", "roh, Nachkommastellen unbekannt"),
    ("remedy", "Abhilfe"),
    ("replies", "Antworten"),
    ("reply times", "Antwortzeiten"),
    ("result", "Ergebnis"),
    ("selection", "Auswahl"),
    ("set", "Satz"),
    ("setpoints", "Sollwerte"),
    ("silent", "stumm"),
    ("slug", "Kennung"),
    ("source", "Quelle"),
    ("sources", "Quellen"),
    ("step", "Schritt"),
    ("state", "Zustand"),
    ("status word", "Zustandswort"),
    ("store", "Speicher"),
    ("strays", "fremde"),
    ("telegram", "Telegramm"),
    ("tells", "sagt"),
    ("text", "Text"),
    ("type", "Typ"),
    ("unconfirmed", "unbestätigt"),
    ("unit", "Einheit"),
    ("unknown bits", "unbekannte Bits"),
    ("value", "Wert"),
    ("values", "Werte"),
    ("volatile", "flüchtig"),
    ("warnings", "Warnungen"),
    ("watchdog", "Watchdog"),
    ("yes", "ja"),
    // Parameter files.
    ("a", "a"),
    ("b", "b"),
    ("changed since it was saved", "seit dem Sichern geändert"),
    ("compared", "verglichen"),
    ("complete", "vollständig"),
    ("different", "verschieden"),
    ("file", "Datei"),
    ("not in the file", "nicht in der Datei"),
    ("signature", "Signatur"),
    // What became of a write.
    ("verified", "geprüft"),
    ("written", "geschrieben"),
    ("unchanged", "unverändert"),
    ("planned", "geplant"),
    ("differs", "abweichend"),
    ("broadcast", "an alle"),
    ("skipped", "ausgelassen"),
    ("restored", "zurückgenommen"),
    ("unrestored", "NICHT zurückgenommen"),
    // A plant.
    ("done", "fertig"),
    ("not recognised", "nicht erkannt"),
    // A parameter file in a drive.
    ("files", "Dateien"),
    ("undo file", "Datei zum Zurücknehmen"),
    ("done, every value proven", "fertig, jeder Wert geprüft"),
    ("nothing was changed", "nichts wurde geändert"),
    ("stored only", "nur gespeichert"),
    ("stored, not all in force", "gespeichert, nicht alles wirkt"),
    ("as before, proven", "wie vorher, geprüft"),
    ("NOT as before", "NICHT wie vorher"),
    ("left out until named", "ausgelassen bis genannt"),
    ("left out, only told", "ausgelassen, nur lesbar"),
    ("left out, commands", "ausgelassen, Befehle"),
    ("left out, restarts", "ausgelassen, Neustart"),
    ("left out, texts", "ausgelassen, Texte"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_word_stands_twice() {
        let mut words: Vec<_> = GERMAN.iter().map(|row| row.0).collect();
        words.sort_unstable();
        assert!(words.windows(2).all(|pair| pair.first() != pair.last()), "{words:?}");
    }

    #[test]
    fn words_have_two_languages() {
        assert_eq!(word(Lang::De, "fault"), "Störung");
        assert_eq!(word(Lang::En, "fault"), "fault");
    }
}
