//! `decode`: what bytes, words and codes say.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Decode, Field, TelegramDoc};
use crate::render::clean;

impl Finding for Decode {
    fn table(&self, page: Page) -> String {
        page.decode(self)
    }

    fn rows(&self) -> Rows {
        if self.telegrams.is_empty() { Rows::of("decoded", &[self]) } else { Rows::of("telegram", &self.telegrams) }
    }
}

impl Page {
    fn decode(self, decode: &Decode) -> String {
        let mut text = String::new();
        match decode.telegrams.as_slice() {
            [] => {}
            [only] => text += &self.telegram(only),
            // What was typed is told to the last field; a recording a line each.
            pair if ["telegram", "can"].contains(&decode.kind) => {
                text += &pair.iter().map(|doc| self.telegram(doc)).collect::<Vec<_>>().join("\n");
            }
            several => text += &self.telegrams(several),
        }
        if let Some(bits) = &decode.word {
            text += &clean(&bits.hex);
            text += &bits.state.as_ref().map_or_else(String::new, |state| format!(" {}", self.say(&state.name)));
            text += "\n";
            text += &self.bits(bits);
            let help = bits.bits.iter().filter(|bit| bit.set && bit.help.is_some());
            let rows: Vec<_> =
                help.map(|bit| vec![self.say_or_not(bit.name.as_ref()), self.say_or_not(bit.help.as_ref())]).collect();
            if !rows.is_empty() {
                text += "\n";
                text += &self.table(&["", ""], rows);
            }
        }
        match (&decode.fault, decode.kind) {
            (Some(fault), _) => text += &self.pairs(self.fault(fault)),
            (None, "fault") => text += &self.pairs(vec![("fault", self.word("none").to_owned())]),
            _ => {}
        }
        if let Some(parts) = &decode.parts {
            text += &self.table(&[""], vec![vec![self.say(&parts.meaning)]]);
            text += &self.fields(&parts.fields);
        }
        if let Some(register) = &decode.register {
            let mut rows = vec![("error register", format!("{} {}", register.code, self.say(&register.name)))];
            rows.extend(register.hint.iter().map(|hint| ("hint", self.say(hint))));
            text += &self.pairs(rows);
        }
        text
    }

    fn telegram(self, doc: &TelegramDoc) -> String {
        let mut text = self.table(&[""], vec![vec![doc.hex.clone()], vec![self.say(&doc.meaning)]]);
        text += &self.fields(&doc.fields);
        text
    }

    pub(super) fn fields(self, fields: &[Field]) -> String {
        let rows = fields.iter();
        let rows = rows.map(|field| vec![field.hex.clone(), self.say(&field.name), self.say(&field.value)]);
        let rows: Vec<_> = rows.collect();
        match rows.is_empty() {
            true => String::new(),
            false => "\n".to_owned() + &self.table(&["", "field", "value"], rows),
        }
    }
}
