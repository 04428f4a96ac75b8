//! Codes 8 and 43 in words: what a device tells of itself (LXM05 manual 5.2.2, 5.2.5; CM-485 manual 6.4.5).

use super::{Reader, Said, field, field8, field16};
use crate::outcome::Field;
use crate::profile::Cause;
use crate::protocol::modbus::pdu::identification::{
    BASIC, PRODUCT_CODE, REVISION, REVISION_LEXIUM, SINGLE, VENDOR_NAME,
};
use crate::protocol::modbus::pdu::{
    CLEAR_COUNTERS, COUNTERS, DIAGNOSTIC_REGISTER, ECHO, IDENTIFICATION, Identification, LISTEN_ONLY,
    RESTART_COMMUNICATION,
};

/// What the sub-functions of code 8 do that return no counter: number, English, German (LXM05 manual, table 5.2).
const SERVICES: [(u16, &str, &str); 4] = [
    (ECHO, "echo", "Echo"),
    (RESTART_COMMUNICATION, "start the port anew", "Anschluss neu starten"),
    (LISTEN_ONLY, "listen only", "nur noch zuhören"),
    (CLEAR_COUNTERS, "clear all counters", "alle Zähler löschen"),
];

/// Categories of identification: number, English, German (V1.1b3, 6.21).
const CATEGORIES: [(u8, &str, &str); 4] = [
    (BASIC, "basic objects", "Grundangaben"),
    (2, "regular objects", "übliche Angaben"),
    (3, "extended objects", "erweiterte Angaben"),
    (SINGLE, "one object", "eine Angabe"),
];

/// Objects of an identification: number, English, German (V1.1b3, 6.21).
const OBJECTS: [(u8, &str, &str); 3] = [
    (VENDOR_NAME, "vendor name", "Hersteller"),
    (PRODUCT_CODE, "product code", "Produktcode"),
    (REVISION, "revision", "Ausgabestand"),
];

impl Reader<'_> {
    /// Code 8, both ways. A request for a number has nothing to tell yet.
    pub(super) fn diagnostics(&self, sub: u16, data: u16, is_request: bool) -> Said {
        let told = match sub {
            ECHO => format!(": 0x{data:04X}"),
            DIAGNOSTIC_REGISTER if !is_request => format!(": 0x{data:04X}"),
            _ if is_request || SERVICES.iter().any(|row| row.0 == sub) => String::new(),
            _ => format!(": {data}"),
        };
        let meaning = format!("{}, {}{told}", self.pick("diagnostics", "Diagnose"), self.service(sub));
        let fields = vec![
            field16(sub, self.pick("sub-function", "Unterfunktion"), format!("0x{sub:04X}")),
            field16(data, self.pick("data", "Daten"), data),
        ];
        (meaning, fields)
    }

    fn service(&self, sub: u16) -> String {
        if let Some(row) = SERVICES.iter().find(|row| row.0 == sub) {
            return self.pick(row.1, row.2).to_owned();
        }
        if let Some(row) = self.family.and_then(|family| family.counters.iter().find(|row| row.sub == sub)) {
            return row.name(self.lang).to_owned();
        }
        if self.family.is_some_and(|family| family.link.cause == Cause::Diagnostics(sub)) {
            return self.pick("last synchronous error", "letzter synchroner Fehler").to_owned();
        }
        let kind = match sub {
            DIAGNOSTIC_REGISTER => return self.pick("diagnostic register", "Diagnoseregister").to_owned(),
            sub if COUNTERS.contains(&sub) => self.pick("counter", "Zähler"),
            _ => self.pick("sub-function", "Unterfunktion"),
        };
        format!("{kind} 0x{sub:02X}")
    }

    /// Code 43, type 14.
    pub(super) fn asks_identification(&self, category: u8, object: u8) -> Said {
        let wanted = self.category(category);
        let first = match category {
            SINGLE => self.object(object),
            _ => format!("{} {}", self.pick("from", "ab"), self.object(object)),
        };
        let meaning = format!("{}: {wanted}, {first}", self.pick("read identification", "Identifikation lesen"));
        let fields = vec![
            self.kind_field(IDENTIFICATION),
            field(&[category], self.pick("category", "Umfang"), wanted),
            field(&[object], self.pick("object", "Objekt"), self.object(object)),
        ];
        (meaning, fields)
    }

    /// The reply to code 43, type 14.
    pub(super) fn identifies(&self, told: &Identification) -> Said {
        let text = |value: &[u8]| format!("\"{}\"", value.escape_ascii());
        let objects = told.objects.iter().map(|object| format!("{} {}", self.object(object.id), text(&object.value)));
        let more = told.next.map(|next| format!("{} {}", self.pick("more from", "weiter ab"), self.object(next)));
        let listed: Vec<_> = objects.chain(more).collect();
        let meaning = format!("{}: {}", self.pick("identification", "Identifikation"), listed.join(", "));
        let follows = match told.next {
            Some(_) => (0xFF, self.pick("yes", "ja")),
            None => (0, self.pick("no", "nein")),
        };
        let mut fields = vec![
            self.kind_field(IDENTIFICATION),
            field(&[told.category], self.pick("category", "Umfang"), self.category(told.category)),
            field(
                &[told.conformity],
                self.pick("conformity level", "Konformitätsstufe"),
                format!("0x{:02X}", told.conformity),
            ),
            field(&[follows.0], self.pick("more follows", "weitere folgen"), follows.1),
            field8(told.next.unwrap_or(0), self.pick("next object", "nächstes Objekt")),
            field8(u8::try_from(told.objects.len()).unwrap_or(u8::MAX), self.pick("object count", "Objektanzahl")),
        ];
        fields.extend(told.objects.iter().map(|object| {
            let length = u8::try_from(object.value.len()).unwrap_or(u8::MAX);
            let bytes = [&[object.id, length], object.value.as_slice()].concat();
            field(&bytes, &self.object(object.id), text(&object.value))
        }));
        (meaning, fields)
    }

    /// The byte behind code 43.
    pub(super) fn kind_field(&self, kind: u8) -> Field {
        let name = self.pick("encapsulated type", "eingebetteter Typ");
        match kind {
            IDENTIFICATION => field(&[kind], name, self.pick("14 (identification)", "14 (Identifikation)")),
            kind => field8(kind, name),
        }
    }

    fn category(&self, category: u8) -> String {
        let row = CATEGORIES.iter().find(|row| row.0 == category);
        row.map_or_else(
            || format!("{} {category}", self.pick("category", "Umfang")),
            |row| self.pick(row.1, row.2).to_owned(),
        )
    }

    /// An object by its name; number 3 is the revision on an LXM05 only (sources G4).
    fn object(&self, id: u8) -> String {
        let id = if id == REVISION_LEXIUM && self.paired().is_some() { REVISION } else { id };
        let row = OBJECTS.iter().find(|row| row.0 == id);
        row.map_or_else(|| format!("{} {id}", self.pick("object", "Objekt")), |row| self.pick(row.1, row.2).to_owned())
    }
}
