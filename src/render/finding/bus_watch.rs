//! `systembus monitor` at its end, and `systembus nmt`.

use super::page::{Page, shown};
use super::{Finding, Rows};
use crate::outcome::{BusMonitor, BusOrdered, BusOrders, Decimal, HeardEmergency, HeardOnBus, HeardPlace, HeardTaker};
use crate::render::clean;

impl Finding for BusMonitor {
    fn table(&self, page: Page) -> String {
        page.bus_heard(self)
    }

    fn rows(&self) -> Rows {
        Rows::of("heard", &self.heard).without_lists()
    }
}

impl Finding for BusOrders {
    fn table(&self, page: Page) -> String {
        let rows = self.nodes.iter().map(|row| page.ordered(row)).collect();
        page.table(&[">node", "before", "after", "proof"], rows)
    }

    fn rows(&self) -> Rows {
        Rows::of("node", &self.nodes)
    }
}

impl Page {
    /// What was heard on a bus.
    pub(in crate::render) fn bus_heard(self, heard: &BusMonitor) -> String {
        let rows = heard.heard.iter().map(|row| self.heard_row(row)).collect();
        let head = [">identifier", "name", ">frames", ">every ms", ">longest ms", "last"];
        let mut text = self.yielding(&head, rows, &["longest ms", "every ms"]);
        let places: Vec<_> =
            heard.heard.iter().flat_map(|row| row.places.iter().map(|one| self.heard_place(row, one))).collect();
        if !places.is_empty() {
            text += &format!("\n{}", self.table(&[">identifier", "bytes", "source", ">raw", "receiver"], places));
        }
        let emergencies: Vec<_> = heard.emergencies.iter().map(|one| self.heard_emergency(one)).collect();
        if !emergencies.is_empty() {
            text += &format!("\n{}", self.table(&[">s", "emergency", "cleared"], emergencies));
        }
        let load = format!("{} %", shown(heard.load_percent, false));
        text + &format!("\n{}", self.pairs(vec![("bus load", load)]))
    }

    fn heard_row(self, row: &HeardOnBus) -> Vec<String> {
        let time = |time: Option<Decimal>| time.map_or_else(|| "-".to_owned(), |time| shown(time, false));
        let last = match (&row.hex, row.missing) {
            (hex, true) => format!("{} {}", self.word("missing"), hex.as_deref().unwrap_or_default()),
            (hex, false) => hex.clone().unwrap_or_else(|| "-".to_owned()),
        };
        vec![
            row.identifier.to_string(),
            clean(row.name.get(self.lang)),
            row.frames.to_string(),
            time(row.every_ms),
            time(row.longest_ms),
            last.trim().to_owned(),
        ]
    }

    fn heard_place(self, row: &HeardOnBus, place: &HeardPlace) -> Vec<String> {
        let source = place.source.map_or_else(
            || "-".to_owned(),
            |source| format!("{source} {}", self.say_or_not(place.source_name.as_ref())).trim().to_owned(),
        );
        let taker = |one: &HeardTaker| format!("{} P.{}", clean(&one.drive), one.param);
        let takers = place.takers.iter().map(taker).collect::<Vec<_>>().join(", ");
        vec![
            row.identifier.to_string(),
            format!("{}-{} {}", place.first_byte, place.last_byte, place.place),
            source,
            place.raw.to_string(),
            if takers.is_empty() { "-".to_owned() } else { takers },
        ]
    }

    fn heard_emergency(self, one: &HeardEmergency) -> Vec<String> {
        let cleared = one.cleared.map_or_else(|| self.word("standing").to_owned(), |at| shown(at, false));
        vec![shown(one.t, false), clean(one.meaning.get(self.lang)), cleared]
    }

    fn ordered(self, row: &BusOrdered) -> Vec<String> {
        let state = |raw: Option<i64>, text: Option<&crate::text::Text>| match (raw, text) {
            (_, Some(text)) => self.say(text),
            (Some(raw), None) => raw.to_string(),
            (None, None) => self.word("silent").to_owned(),
        };
        let proof = match row.proof {
            Some("state") => self.word("state"),
            Some("silence") => self.word("silence"),
            Some(_) => "Boot-Up",
            None => self.word("none"),
        };
        vec![
            row.address.to_string(),
            state(row.before, row.before_text.as_ref()),
            state(row.after, row.after_text.as_ref()),
            proof.to_owned(),
        ]
    }
}
