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
use crate::text::{Text, both};

/// What the sub-functions of code 8 do that return no counter (LXM05 manual, table 5.2).
const SERVICES: [(u16, Text); 4] = [
    (ECHO, Text::new("echo", "Echo")),
    (RESTART_COMMUNICATION, Text::new("start the port anew", "Anschluss neu starten")),
    (LISTEN_ONLY, Text::new("listen only", "nur noch zuhören")),
    (CLEAR_COUNTERS, Text::new("clear all counters", "alle Zähler löschen")),
];

/// Categories of identification (V1.1b3, 6.21).
const CATEGORIES: [(u8, Text); 4] = [
    (BASIC, Text::new("basic objects", "Grundangaben")),
    (2, Text::new("regular objects", "übliche Angaben")),
    (3, Text::new("extended objects", "erweiterte Angaben")),
    (SINGLE, Text::new("one object", "eine Angabe")),
];

/// Objects of an identification (V1.1b3, 6.21).
const OBJECTS: [(u8, Text); 3] = [
    (VENDOR_NAME, Text::new("vendor name", "Hersteller")),
    (PRODUCT_CODE, Text::new("product code", "Produktcode")),
    (REVISION, Text::new("revision", "Ausgabestand")),
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
        let meaning = both!("diagnostics, {service}{told}", "Diagnose, {service}{told}", service = self.service(sub));
        let fields = vec![
            field16(sub, both!("sub-function", "Unterfunktion"), Text::name(format_args!("0x{sub:04X}"))),
            field16(data, both!("data", "Daten"), Text::name(data)),
        ];
        (meaning, fields)
    }

    fn service(&self, sub: u16) -> Text {
        if let Some((_, name)) = SERVICES.into_iter().find(|row| row.0 == sub) {
            return name;
        }
        if let Some(row) = self.family.and_then(|family| family.counters.iter().find(|row| row.sub == sub)) {
            return row.text();
        }
        if self.family.is_some_and(|family| family.link.cause == Cause::Diagnostics(sub)) {
            return both!("last synchronous error", "letzter synchroner Fehler");
        }
        match sub {
            DIAGNOSTIC_REGISTER => both!("diagnostic register", "Diagnoseregister"),
            sub if COUNTERS.contains(&sub) => both!("counter 0x{sub:02X}", "Zähler 0x{sub:02X}"),
            _ => both!("sub-function 0x{sub:02X}", "Unterfunktion 0x{sub:02X}"),
        }
    }

    /// Code 43, type 14.
    pub(super) fn asks_identification(&self, category: u8, object: u8) -> Said {
        let (wanted, named) = (wanted(category), self.object(object));
        let first = match category {
            SINGLE => named.clone(),
            _ => both!("from {named}", "ab {named}", named),
        };
        let meaning =
            both!("read identification: {wanted}, {first}", "Identifikation lesen: {wanted}, {first}", wanted, first);
        let fields = vec![
            kind_field(IDENTIFICATION),
            field(&[category], both!("category", "Umfang"), wanted),
            field(&[object], both!("object", "Objekt"), named),
        ];
        (meaning, fields)
    }

    /// The reply to code 43, type 14.
    pub(super) fn identifies(&self, told: &Identification) -> Said {
        let text = |value: &[u8]| Text::name(format_args!("\"{}\"", value.escape_ascii()));
        let objects =
            told.objects.iter().map(|object| Text::join([&self.object(object.id), &text(&object.value)], " "));
        let more = told.next.map(|next| both!("more from {next}", "weiter ab {next}", next = self.object(next)));
        let listed: Vec<_> = objects.chain(more).collect();
        let meaning = both!("identification: {all}", "Identifikation: {all}", all = Text::join(&listed, ", "));
        let (follows, answer) = match told.next {
            Some(_) => (0xFF, both!("yes", "ja")),
            None => (0, both!("no", "nein")),
        };
        let conformity = Text::name(format_args!("0x{:02X}", told.conformity));
        let mut fields = vec![
            kind_field(IDENTIFICATION),
            field(&[told.category], both!("category", "Umfang"), wanted(told.category)),
            field(&[told.conformity], both!("conformity level", "Konformitätsstufe"), conformity),
            field(&[follows], both!("more follows", "weitere folgen"), answer),
            field8(told.next.unwrap_or(0), both!("next object", "nächstes Objekt")),
            field8(u8::try_from(told.objects.len()).unwrap_or(u8::MAX), both!("object count", "Objektanzahl")),
        ];
        fields.extend(told.objects.iter().map(|object| {
            let length = u8::try_from(object.value.len()).unwrap_or(u8::MAX);
            let bytes = [&[object.id, length], object.value.as_slice()].concat();
            field(&bytes, self.object(object.id), text(&object.value))
        }));
        (meaning, fields)
    }

    /// An object by its name; number 3 is the revision on an LXM05 only (sources G4).
    fn object(&self, id: u8) -> Text {
        let id = if id == REVISION_LEXIUM && self.paired().is_some() { REVISION } else { id };
        let row = OBJECTS.into_iter().find(|row| row.0 == id);
        row.map_or_else(|| both!("object {id}", "Objekt {id}"), |row| row.1)
    }
}

/// The byte behind code 43.
pub(super) fn kind_field(kind: u8) -> Field {
    let name = both!("encapsulated type", "eingebetteter Typ");
    match kind {
        IDENTIFICATION => field(&[kind], name, both!("14 (identification)", "14 (Identifikation)")),
        kind => field8(kind, name),
    }
}

fn wanted(category: u8) -> Text {
    let row = CATEGORIES.into_iter().find(|row| row.0 == category);
    row.map_or_else(|| both!("category {category}", "Umfang {category}"), |row| row.1)
}
