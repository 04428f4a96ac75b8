//! The words of tables in both languages.

use crate::profile::Lang;

/// The word for `english` in `lang`; a word without a row stays English.
pub(super) fn word(lang: Lang, english: &'static str) -> &'static str {
    match lang {
        Lang::En => english,
        Lang::De => GERMAN.iter().find(|row| row.0 == english).map_or(english, |row| row.1),
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
    // The rest.
    ("access", "Zugriff"),
    ("acknowledged", "bestätigt"),
    ("NOT acknowledged", "NICHT bestätigt"),
    ("actual value", "Istwert"),
    ("changed", "geändert"),
    ("command", "Befehl"),
    ("given back", "zurückgestellt"),
    ("NOT given back", "NICHT zurückgestellt"),
    ("missing", "fehlt"),
    ("not reached", "nicht erreicht"),
    ("reached", "erreicht"),
    ("running", "läuft weiter"),
    ("setpoint", "Sollwert"),
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
    ("error register", "Fehlerregister"),
    ("evidence", "Beleg"),
    ("fault", "Störung"),
    ("field", "Feld"),
    ("from", "aus"),
    ("garbled", "gestört"),
    ("group", "Gruppe"),
    ("hazard", "Gefahr"),
    ("hint", "Hinweis"),
    ("link test", "Leitungstest"),
    ("meaning", "Bedeutung"),
    ("median", "Median"),
    ("module", "Modul"),
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
    ("yes", "ja"),
    // What became of a write.
    ("verified", "geprüft"),
    ("written", "geschrieben"),
    ("unchanged", "unverändert"),
    ("planned", "geplant"),
    ("refused", "abgelehnt"),
    ("unknown", "unbekannt"),
    ("differs", "abweichend"),
    ("broadcast", "an alle"),
    ("skipped", "ausgelassen"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_have_two_languages() {
        assert_eq!(word(Lang::De, "fault"), "Störung");
        assert_eq!(word(Lang::En, "fault"), "fault");
    }
}
