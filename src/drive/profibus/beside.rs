//! What went out beside another master who was heard on the line: the end of an exchange goes out all the same, and whoever shares the line
//! is told what did.

use super::trouble;
use crate::exchange::dp::{Asked, Place};
use crate::outcome::Warning;
use crate::protocol::dp::Service;
use crate::protocol::dp::pkw::{Pkw, Task};
use crate::text::{Text, both};

/// What went out behind the first telegram of another master, each once, in its order.
#[derive(Debug, Default)]
pub(super) struct Beside(Vec<Text>);

impl Beside {
    /// These went out.
    pub(super) fn went_out(&mut self, said: Vec<Text>) {
        for text in said {
            if !self.0.contains(&text) {
                self.0.push(text);
            }
        }
    }

    /// That another master was active on the line, and what went out beside it.
    pub(super) fn told(&self, master: u8) -> Warning {
        let went_out = Text::join(&self.0, ", ");
        let message = match self.0.is_empty() {
            true => both!(
                "another master became active on this line, at address {master}; nothing more was sent beside it",
                "auf dieser Leitung wurde ein anderer Master aktiv, unter Adresse {master}; neben ihm wurde nichts mehr gesendet"
            ),
            false => both!(
                "another master became active on this line, at address {master}; sent beside it, to end the exchange: {went_out}",
                "auf dieser Leitung wurde ein anderer Master aktiv, unter Adresse {master}; neben ihm gesendet, um den Austausch zu \
                 beenden: {went_out}",
                went_out
            ),
        };
        Warning { code: "profibus.other_master".to_owned(), message }
    }
}

/// What a question of an exchange with these outputs says to whoever reads of it.
pub(super) fn saying(asked: &Asked, (stw, pkw): (u16, Pkw), is_leaving: bool) -> Vec<Text> {
    match asked.asks() {
        Service::DataExchange => {
            let word = match stw {
                0 => both!("zero outputs", "Ausgänge auf null"),
                stw => Text::name(format_args!("{stw:04X}h")),
            };
            let task = Task::of(pkw.ak);
            let element = task.has_element().then(|| pkw.sub_index());
            let place = trouble::label(Place { pnu: pkw.pnu, element });
            let written = Text::name(format_args!("{place} = {}", pkw.pwe));
            task.writes().then_some(written).into_iter().chain([word]).collect()
        }
        Service::GlobalControl => vec![Text::name("Clear")],
        Service::SetPrm if is_leaving => vec![Text::name("Unlock")],
        service => vec![Text::name(service.name())],
    }
}
