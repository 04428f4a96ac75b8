//! What is told of what goes over a line: every telegram in the words of its drive, and what is odd about a station.

use super::decode;
use crate::exchange::{Record, Verdict};
use crate::outcome::Event;
use crate::profile::Family;
use crate::protocol::Protocol;
use crate::protocol::modbus::Hex;
use crate::protocol::modbus::pdu::WordOrder;
use crate::text::both;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// Tells whoever watches a line.
pub(super) struct Account<'a> {
    observe: &'a mut dyn FnMut(Event),
    /// What is known of the drives by address, to name what goes over the line.
    known: BTreeMap<u8, Known>,
    /// Drives of which it was told that they answer twice.
    twice: BTreeSet<u8>,
    /// Drives of which it was told that two of their answers differ.
    differing: BTreeSet<u8>,
    verbose: bool,
}

/// A drive whose telegrams can be told in the words of its family.
struct Known {
    family: Rc<Family>,
    /// The upper half of a value in two registers comes first.
    order: WordOrder,
}

impl<'a> Account<'a> {
    /// Whether every telegram is told.
    pub(super) fn is_verbose(&self) -> bool {
        self.verbose
    }

    /// Tells this observer; every telegram only if `verbose`.
    pub(super) fn new(observe: &'a mut dyn FnMut(Event), verbose: bool) -> Self {
        Account { observe, known: BTreeMap::new(), twice: BTreeSet::new(), differing: BTreeSet::new(), verbose }
    }

    /// Tells an event.
    pub(super) fn tell(&mut self, event: Event) {
        (self.observe)(event);
    }

    /// Remembers what a drive is.
    pub(super) fn knows(&mut self, address: u8, family: &Rc<Family>, order: WordOrder) {
        if self.verbose {
            self.known.insert(address, Known { family: family.clone(), order });
        }
    }

    /// Tells what went over the line while `asked` was asked.
    pub(super) fn show(&mut self, protocol: Protocol, records: &[Record], asked: Option<u8>) {
        if !self.verbose {
            return;
        }
        for record in records {
            let station = match record.verdict {
                Verdict::Stray { station } => Some(station),
                _ => asked,
            };
            let known = station.and_then(|station| self.known.get(&station));
            (self.observe)(telegram_event(protocol, known, record));
        }
    }

    /// Tells once that everything is answered twice: what is read may come from either of two drives.
    pub(super) fn tell_twice(&mut self, station: u8) {
        if self.twice.insert(station) {
            let note = both!(
                "address {station}: every question is answered twice: two drives with one address, a repeater, or a drive that \
                 answers later than --timeout, so that it was asked again",
                "Adresse {station}: jede Frage wird zweimal beantwortet: zwei Antriebe mit einer Adresse, ein Repeater, oder ein \
                 Antrieb, der später als --timeout antwortet und deshalb noch einmal gefragt wurde"
            );
            (self.observe)(Event::Note(note));
        }
    }

    /// Tells once that one question was answered in two ways, where values are believed all the same.
    pub(super) fn tell_differing(&mut self, station: u8) {
        if self.differing.insert(station) {
            let note = both!(
                "address {station}: one question was answered in two ways: two drives with one address, or a reply that came \
                 late",
                "Adresse {station}: eine Frage wurde auf zwei Arten beantwortet: zwei Antriebe mit einer Adresse, oder eine \
                 verspätete Antwort"
            );
            (self.observe)(Event::Note(note));
        }
    }
}

fn telegram_event(protocol: Protocol, known: Option<&Known>, record: &Record) -> Event {
    let (direction, is_request) = match record.verdict {
        Verdict::Request | Verdict::Fence | Verdict::Farewell => ('>', Some(true)),
        Verdict::Reply => ('<', Some(false)),
        Verdict::Echo => ('~', Some(true)),
        Verdict::Copy | Verdict::Stray { .. } | Verdict::Garbage => ('~', Some(false)),
    };
    let family = known.map(|known| &*known.family);
    let order = known.map(|known| known.order);
    let reader = decode::Reader { protocol, node: 0, family, order };
    let told = reader.telegram(&record.bytes, is_request);
    let said = told.meaning;
    let meaning = match record.verdict {
        Verdict::Fence => both!("fence: {said}", "Sperrfrage: {said}", said),
        Verdict::Echo => both!("echo of the adapter: {said}", "Echo des Adapters: {said}", said),
        Verdict::Copy => both!(
            "the answer, or the echo of the adapter: {said}",
            "die Antwort, oder das Echo des Adapters: {said}",
            said
        ),
        // On a bus of CAN everybody hears what is asked.
        Verdict::Stray { .. } if told.can.is_some() && told.direction == Some("request") => {
            both!("somebody else asks: {said}", "jemand anders fragt: {said}", said)
        }
        Verdict::Stray { station } => both!(
            "not the answer, from address {station}: {said}",
            "nicht die Antwort, von Adresse {station}: {said}",
            said
        ),
        _ => said,
    };
    // A frame of CAN that was too short is marked so, with bytes that did not come.
    let hex = if told.can.is_some() && !told.check_ok { told.hex } else { Hex(&record.bytes).to_string() };
    Event::Telegram { at_us: record.at.as_micros(), direction, hex, meaning }
}
