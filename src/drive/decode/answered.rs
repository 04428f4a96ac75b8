//! A reply in the light of its request: the answer to a question alone does not say what was asked.

use super::{Reader, addressed};
use crate::drive::describe;
use crate::drive::transfer::Reading;
use crate::outcome::{Field, TelegramDoc};
use crate::profile::value::from_wire;
use crate::profile::{Family, Param, Type};
use crate::protocol::Protocol;
use crate::protocol::modbus::pdu::{ParamAddress, Reply, Request};
use crate::text::{Text, both};

impl Reader<'_> {
    /// Tells of a reply what it answers; both are whole telegrams.
    pub(super) fn answered(&self, asked: &TelegramDoc, (request, reply): (&[u8], &[u8]), doc: &mut TelegramDoc) {
        let Protocol::Modbus(framing) = self.protocol else { return };
        let Ok((request, reply)) = framing.decode(request).and_then(|request| Ok((request, framing.decode(reply)?)))
        else {
            return;
        };
        if request.station != reply.station {
            return;
        }
        if doc.refuses {
            let why = &doc.meaning;
            doc.meaning =
                both!("{why} (asked for: {asked})", "{why} (verlangt war: {asked})", why, asked = asked.meaning);
            return;
        }
        let (Ok(request), Ok(reply)) = (Request::decode(&request.pdu), Reply::decode(&reply.pdu)) else { return };
        let told = match (request, reply) {
            (Request::ReadRegisters { start, .. }, Reply::Registers(words)) if self.paired().is_some() => {
                Some(self.assigned(start, &words))
            }
            (Request::ReadRegisters { start, count: 1 }, Reply::Registers(words)) => {
                words.first().map(|word| self.reads_as(start, (*word).into(), false, &mut doc.fields))
            }
            (Request::ReadLong { address }, Reply::Long(bits)) => {
                Some(self.reads_as(address, bits, true, &mut doc.fields))
            }
            _ => None,
        };
        if let (Some(told), Some(station)) = (told, doc.address) {
            doc.meaning = Text::join([&addressed(station), &told], ": ");
        }
    }

    /// What an ACTIVE says of a parameter; the field of its value says it too.
    fn reads_as(&self, word: u16, bits: u32, is_long: bool, fields: &mut [Field]) -> Text {
        let (param, shown) = (self.param(word), self.value(word, bits, is_long));
        let address = ParamAddress::from_word(word);
        let known = self.active().and_then(|family| Some((family, family.param(address.number().into())?)));
        let told = known.map(|(family, param)| told(family, param, (address.set(), bits, is_long)));
        let (hex, meant) = told.unwrap_or_default();
        let shown = hex.map_or(shown, Text::name);
        let shown = match meant {
            Some(meant) => both!("{shown} ({meant})", "{shown} ({meant})", shown, meant),
            None => shown,
        };
        // Before the check value there is nothing behind the value.
        let is_value = |field: &&mut Field| field.name == both!("value", "Wert");
        if let Some(field) = fields.iter_mut().find(is_value) {
            field.value = shown.clone();
        }
        Text::join([&param, &shown], " = ")
    }
}

/// What a value stands for: the state of a status word and what is set in any, a fault, a choice; words as their hex.
fn told(family: &Family, param: &Param, (set, bits, is_long): (u8, u32, bool)) -> (Option<String>, Option<Text>) {
    let kind = param.kind.unwrap_or(if is_long { Type::Long } else { Type::Word });
    let reading = Reading { set, raw: from_wire(bits, kind, param.min), text: None, kind, corrected: false };
    let value = describe::value(0, family, param, reading, &|_| None);
    let Some(word) = value.word else { return (None, value.text) };
    let set = word.bits.iter().filter(|bit| bit.set).filter_map(|bit| bit.name.clone()).collect::<Vec<_>>();
    let state = word.state.map(|state| state.name);
    let told: Vec<Text> = state.into_iter().chain((!set.is_empty()).then(|| Text::join(&set, ", "))).collect();
    (Some(word.hex), (!told.is_empty()).then(|| Text::join(&told, ": ")))
}
