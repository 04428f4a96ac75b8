//! Frames of a CAN bus in the place of telegrams: they come whole, and the adapter only listens.

use super::census::{Came, Lane, Terms};
use super::{Ear, Tick};
use crate::drive::can::trouble;
use crate::drive::decode::damaged_word;
use crate::drive::session::Session;
use crate::failure::Failure;
use crate::outcome::TelegramDoc;
use crate::protocol::can::{Frame, FrameError, Identifier, Service, duration, station};
use crate::text::{Text, both};
use crate::tick::Span;

/// Nobody has it: there is no everybody among those that are asked over SDO.
const NOBODY: u8 = u8::MAX;

/// What is counted is microseconds of frames, and no pause lies between them.
pub(super) fn terms(patience: Span) -> Terms {
    Terms { thousand: Span::from_millis(1), pause: None, patience, everybody: NOBODY }
}

/// Why it was of no use to listen on a CAN bus; `None` on any other line.
pub(super) async fn unheard(session: &mut Session<'_>) -> Option<Failure> {
    let line = session.line();
    if !line.is_can() {
        return None;
    }
    let flags = session.bus_errors().await.ok().flatten();
    Some(trouble::unheard(session.port(), line.baud, flags))
}

/// What an adapter does not tell of a bus; how many frames came faster than they were taken, and whether it lost some itself.
pub(super) fn unseen(lost: u64, is_overrun: bool) -> Text {
    let unseen = both!(
        "a CAN adapter tells whole frames, no levels and no disturbed ones; times are those of its driver, and who only listens \
         acknowledges nothing",
        "ein CAN-Adapter zeigt ganze Frames, keine Pegel und keine gestörten; Zeiten sind die seines Treibers, und wer nur zuhört, \
         bestätigt nichts"
    );
    let unseen = match is_overrun {
        true => both!(
            "the adapter tells that it lost frames (overrun): not all is here; {unseen}",
            "der Adapter meldet, dass er Frames verloren hat (Überlauf): hier steht nicht alles; {unseen}",
            unseen
        ),
        false => unseen,
    };
    match lost {
        0 => unseen,
        lost => both!(
            "{lost} frames came faster than they were taken, and are lost; {unseen}",
            "{lost} Frames kamen schneller, als sie abgeholt wurden, und sind verloren; {unseen}",
            unseen
        ),
    }
}

impl Ear<'_> {
    /// Frames that were handed over at once, and what came with them that is no word of an adapter.
    pub(super) fn frames(&mut self, at: Tick, frames: &[Frame], damaged: Vec<Vec<u8>>) -> Vec<TelegramDoc> {
        let mut told: Vec<_> = frames.iter().map(|frame| self.frame(at, frame)).collect();
        for bytes in damaged {
            let word = String::from_utf8_lossy(&bytes).into_owned();
            let doc = self.timed(at, damaged_word(&word, &FrameError::Form(word.clone())));
            // How long it was on the bus nobody knows.
            self.census.passes(&doc, 0);
            told.push(doc);
        }
        told
    }

    fn timed(&self, at: Tick, doc: TelegramDoc) -> TelegramDoc {
        let since_1970_us = self.since_1970.map(|span| span.as_micros() + at.as_micros());
        TelegramDoc { at_us: Some(at.as_micros()), since_1970_us, ..doc }
    }

    fn frame(&mut self, at: Tick, frame: &Frame) -> TelegramDoc {
        let doc = self.timed(at, self.reader.frame(frame));
        let busy = duration(self.bit_rate, frame.bytes().len() as u64).as_micros();
        match asked(frame) {
            Some((node, lane)) => {
                let counted = TelegramDoc { address: Some(station(node)), ..doc.clone() };
                self.census.note(&counted, Came { first: at, piece: busy, last: at, bytes: busy, alike: false, lane });
            }
            None => self.census.passes(&doc, busy),
        }
        doc
    }
}

/// The node of a question over SDO, or of an answer, and where it is asked; the rest is asked by nobody.
fn asked(frame: &Frame) -> Option<(u8, Lane)> {
    let Identifier::Standard(identifier) = frame.identifier else { return None };
    match Service::of(identifier) {
        Service::SdoRequest(channel, node) | Service::SdoReply(channel, node) => {
            Some((node, Lane::from(channel.number()) << u8::BITS | Lane::from(node)))
        }
        _ => None,
    }
}
