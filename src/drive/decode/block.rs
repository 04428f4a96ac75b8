//! A PKW block of a station, in the telegram of the cycle that carries it.

use super::Reader;
use crate::drive::profibus;
use crate::outcome::TelegramDoc;
use crate::protocol::Hex;
use crate::protocol::dp::pkw::Pkw;

impl Reader<'_> {
    pub(super) fn block(&self, bytes: &[u8]) -> TelegramDoc {
        let block = bytes.split_first().and_then(|(station, block)| Some((*station, block.try_into().ok()?)));
        match (block, self.family) {
            (Some((station, block)), Some(family)) => profibus::asking(station, Pkw::decode(block), family),
            _ => TelegramDoc::blank(self.protocol.name(), Hex(bytes).to_string(), false),
        }
    }
}
