//! The words of a row: its data sets, when it counts, what writing it does, remarks, values with names.

use super::super::cells;
use super::super::draft::Draft;
use super::super::sheet::Record;
use super::List;
use crate::profile::param::{Effective, HazardKind, Sets};
use crate::text::{Text, both};

/// Words for data sets, as they are without blanks and punctuation: `1-4`, `1..4`, `1/2/3/4`.
const SETS: [(&str, Option<Sets>); 3] = [
    ("4 14 1234 four vier yes ja x alle all 1bis4 1to4 viermal ds14", Some(Sets::Four)),
    ("1 0 one eins einmal global", Some(Sets::One)),
    ("no nein n none keine kein ohne", None),
];
const EFFECTIVE: [(&str, Option<Effective>); 2] = [
    ("reset restart neustart powercycle", Some(Effective::Reset)),
    ("now atonce immediately sofort direkt", Some(Effective::AtOnce)),
];
const HAZARDS: [(&str, Option<HazardKind>); 4] = [
    ("motion bewegung", Some(HazardKind::Motion)),
    ("line leitung", Some(HazardKind::Line)),
    ("reset", Some(HazardKind::Reset)),
    ("no none nein keine n", None),
];

impl List<'_> {
    /// What a row says in words: mostly what only a list has that was written by `params export`.
    pub(super) fn words(&mut self, record: &Record, draft: &mut Draft) {
        let is = |field: &str| self.get(record, field).is_some_and(cells::yes);
        (draft.volatile, draft.hex) = (is("volatile"), is("hex"));
        draft.sets = self.word(record, "sets", &SETS, || {
            both!(
                "this word for data sets is not known, and not taken; --set sets.WORD=4 (or 1) says what it means",
                "dieses Wort für Datensätze ist unbekannt und wird nicht genommen; --set sets.WORT=4 (oder 1) sagt, was es heißt"
            )
        });
        let effective = self.word(record, "effective", &EFFECTIVE, || {
            both!(
                "when this takes effect is not known, taken as at once (one of now, reset)",
                "wann das wirkt, ist unbekannt, genommen wird sofort (eines von now, reset)"
            )
        });
        draft.effective = effective.unwrap_or_default();
        draft.hazard = self.word(record, "hazard", &HAZARDS, || {
            both!(
                "this hazard is not known, and not taken (one of motion, line, reset)",
                "diese Gefahr ist unbekannt und wird nicht genommen (eines von motion, line, reset)"
            )
        });
        draft.module = self.text(record, "module");
        draft.source = self.text(record, "source");
        draft.group = self.text(record, "group");
        let list = |field: &str| -> Vec<String> {
            self.get(record, field)
                .unwrap_or_default()
                .split([' ', ','])
                .filter(|word| !word.is_empty())
                .map(str::to_owned)
                .collect()
        };
        draft.unconfirmed = list("unconfirmed");
        // Of a family of its own that is so wherever nothing is said (`catalogue::merge`).
        draft.unconfirmed.retain(|field| !self.wishes.own || field != "volatile");
        draft.drives = list("drives");
        let [en, de] =
            ["note_en", "note_de"].map(|field| self.text(record, field).or_else(|| self.text(record, "note")));
        draft.note = match (en, de) {
            (None, None) => None,
            (Some(one), None) | (None, Some(one)) => Some(Text::name(one)),
            (Some(en), Some(de)) => Some(Text { en: en.into(), de: de.into() }),
        };
        let when = self.get(record, "bits_when").unwrap_or_default().split('|').filter_map(|part| {
            let (param, rest) = part.trim().split_once('=')?;
            let (value, bits) = rest.split_once(':')?;
            Some((param.parse().ok()?, value.parse().ok()?, bits.to_owned()))
        });
        draft.bits_when = when.collect();
    }

    /// What a word of a table means. What is no such word is told.
    fn word<T: Copy>(
        &mut self,
        record: &Record,
        field: &str,
        table: &[(&str, Option<T>)],
        unknown: impl Fn() -> Text,
    ) -> Option<T> {
        let cell = self.text(record, field).filter(|cell| !cell.is_empty())?;
        let said = cells::dense(&cell);
        let found = table.iter().find(|(words, _)| words.split(' ').any(|word| word == said));
        if found.is_none() && !said.is_empty() {
            self.note(record.line, unknown(), &cell);
        }
        found.and_then(|(_, means)| *means)
    }

    /// Values with names in one or both languages.
    pub(super) fn names(&self, record: &Record, fields: [&str; 2], both: &str) -> Vec<(i64, Text)> {
        let [en, de] = fields
            .map(|field| cells::values(self.get(record, field).or_else(|| self.get(record, both)).unwrap_or_default()));
        let (first, other) = if en.is_empty() { (&de, &en) } else { (&en, &de) };
        let pair = |(raw, name): &(i64, String)| {
            let twin = other.iter().find(|row| row.0 == *raw).map_or(name, |row| &row.1).clone();
            let (en, de) = if en.is_empty() { (twin, name.clone()) } else { (name.clone(), twin) };
            (*raw, Text { en: en.into(), de: de.into() })
        };
        first.iter().map(pair).collect()
    }
}
