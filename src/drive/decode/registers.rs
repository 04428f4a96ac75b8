//! Codes 3, 16 and 23 in words (LXM05 manual 5.2, 5.3, with the lengths of sources G4): as parameters where those of the
//! family are pairs of registers, else as plain registers.

use super::modbus::{count_field, writes, written};
use super::{Reader, Said, field, field8, field16};
use crate::outcome::Field;
use crate::profile::{Family, Param, Route, format_value};
use crate::protocol::modbus::pdu::WordOrder;
use crate::text::{Text, both};

/// Most parameters or registers that one line names.
const FEW: usize = 4;

impl Reader<'_> {
    /// The family, if its parameters are pairs of registers.
    pub(super) fn paired(&self) -> Option<&Family> {
        self.family.filter(|family| family.link.route == Route::Registers32)
    }

    /// Code 3.
    pub(super) fn reads(&self, start: u16, count: u16) -> Said {
        let meaning = both!("read {span}", "lesen {span}", span = self.span(start, count));
        (meaning, self.span_fields(start, count))
    }

    /// Code 16.
    pub(super) fn writes(&self, start: u16, words: &[u16]) -> Said {
        (writes(&self.assigned(start, words)), self.written_fields(start, words))
    }

    /// The reply to code 16.
    pub(super) fn taken(&self, start: u16, count: u16) -> Said {
        (written(&self.span(start, count)), self.span_fields(start, count))
    }

    /// Code 23, which writes first (V1.1b3, 6.17).
    pub(super) fn exchanges(&self, start: u16, count: u16, write_start: u16, words: &[u16]) -> Said {
        let meaning = both!(
            "write {assigned}, then read {span}",
            "schreiben {assigned}, dann lesen {span}",
            assigned = self.assigned(write_start, words),
            span = self.span(start, count)
        );
        let mut fields = self.span_fields(start, count);
        fields.extend(self.written_fields(write_start, words));
        (meaning, fields)
    }

    /// The reply to codes 3 and 23, which does not say what was read.
    pub(super) fn told(&self, words: &[u16]) -> Said {
        let parts = self.parts(words);
        let shown: Vec<_> = parts.iter().map(Part::plain).collect();
        let mut fields = vec![bytes_field(words)];
        fields.extend(parts.iter().zip(&shown).map(|(part, shown)| part.field(both!("value", "Wert"), shown.clone())));
        (both!("value {all}", "Wert {all}", all = Text::join(&shown, ", ")), fields)
    }

    /// Code 6 of a family that does not have it: one register.
    pub(super) fn single(&self, address: u16, word: u16) -> Vec<Field> {
        vec![
            field16(address, both!("register", "Register"), self.span(address, 1)),
            field16(word, both!("value", "Wert"), Part::word(word).plain()),
        ]
    }

    /// What lies in `count` registers from `start` on.
    fn span(&self, start: u16, count: u16) -> Text {
        let (width, unit) = self.grain(count.into());
        let number = usize::from(count) / width;
        let addresses: Vec<u16> = addresses(start, width).take(number.min(FEW)).collect();
        match addresses.as_slice() {
            &[only] if number == 1 => self.named(only, width),
            few @ [_, ..] if few.len() == number && width == 2 => {
                Text::join(&few.iter().map(|&address| self.label(address, width)).collect::<Vec<_>>(), ", ")
            }
            _ => self.many(number, &unit, start, width),
        }
    }

    /// The values that go into the registers from `start` on.
    pub(super) fn assigned(&self, start: u16, words: &[u16]) -> Text {
        let (width, unit) = self.grain(words.len());
        let parts = self.parts(words);
        let each: Vec<(u16, &Part)> = addresses(start, width).zip(&parts).take(FEW).collect();
        let is = |name: Text, address: u16, part: &Part| Text::join([&name, &self.read_out(address, part)], " = ");
        match each.as_slice() {
            [(_, only)] if parts.len() == 1 => is(self.named(start, width), start, only),
            few @ [_, ..] if few.len() == parts.len() => {
                let each = few.iter().map(|(address, part)| is(self.label(*address, width), *address, part));
                Text::join(&each.collect::<Vec<_>>(), ", ")
            }
            _ => self.many(parts.len(), &unit, start, width),
        }
    }

    fn many(&self, number: usize, unit: &Text, start: u16, width: usize) -> Text {
        let start = if width == 2 { self.label(start, width) } else { Text::name(start) };
        both!("{number} {unit} from {start}", "{number} {unit} ab {start}", unit, start)
    }

    /// Registers that belong together, and what several of them are called.
    fn grain(&self, registers: usize) -> (usize, Text) {
        match self.paired() {
            Some(_) if registers > 0 && registers.is_multiple_of(2) => (2, both!("parameters", "Parameter")),
            _ => (1, both!("registers", "Register")),
        }
    }

    fn parts(&self, words: &[u16]) -> Vec<Part> {
        match self.grain(words.len()).0 {
            2 => words.as_chunks().0.iter().map(|pair| Part::pair(*pair, self.order.unwrap_or_default())).collect(),
            _ => words.iter().map(|&word| Part::word(word)).collect(),
        }
    }

    fn known(&self, address: u16) -> Option<&Param> {
        self.paired()?.param(address.into())
    }

    fn label(&self, address: u16, width: usize) -> Text {
        match self.paired().filter(|_| width == 2) {
            Some(family) => Text::name(family.param_or_unknown(address.into()).label()),
            None => both!("register {address}", "Register {address}"),
        }
    }

    fn named(&self, address: u16, width: usize) -> Text {
        let label = self.label(address, width);
        let name = self.known(address).filter(|_| width == 2);
        name.map_or_else(|| label.clone(), |param| Text::join([&label, &param.name], " "))
    }

    /// A value as people read it.
    fn read_out(&self, address: u16, part: &Part) -> Text {
        let known = self.paired().zip(self.known(address)).filter(|_| part.bytes.len() == 4);
        let Some((family, param)) = known else { return part.plain() };
        if param.hex {
            return Text::name(format_args!("0x{:04X}", part.bits));
        }
        let value = format_value(param, part.bits, true);
        match family.text_of(param, (part.bits as i32).into()) {
            Some(text) => both!("{value} ({text})", "{value} ({text})", text),
            None => Text::name(value),
        }
    }

    fn span_fields(&self, start: u16, count: u16) -> Vec<Field> {
        let width = self.grain(count.into()).0;
        vec![field16(start, both!("first register", "erstes Register"), self.named(start, width)), count_field(count)]
    }

    fn written_fields(&self, start: u16, words: &[u16]) -> Vec<Field> {
        let count = u16::try_from(words.len()).unwrap_or(u16::MAX);
        let mut fields = self.span_fields(start, count);
        fields.push(bytes_field(words));
        let width = self.grain(words.len()).0;
        let places = addresses(start, width).map(Some).chain(std::iter::repeat(None));
        fields.extend(places.zip(self.parts(words)).map(|(address, part)| match address {
            Some(address) => part.field(self.label(address, width), self.read_out(address, &part)),
            None => part.field(both!("behind the last register", "hinter dem letzten Register"), part.plain()),
        }));
        fields
    }
}

fn bytes_field(words: &[u16]) -> Field {
    field8(u8::try_from(words.len() * 2).unwrap_or(u8::MAX), both!("byte count", "Byteanzahl"))
}

/// Every `width`th register from `start` to the last that there is.
fn addresses(start: u16, width: usize) -> impl Iterator<Item = u16> {
    (start..=u16::MAX).step_by(width)
}

/// Registers that belong together.
struct Part {
    /// As they stand in the telegram.
    bytes: Vec<u8>,
    bits: u32,
}

impl Part {
    fn word(word: u16) -> Self {
        Part { bytes: word.to_be_bytes().to_vec(), bits: word.into() }
    }

    fn pair(words: [u16; 2], order: WordOrder) -> Self {
        Part { bytes: words.iter().flat_map(|word| word.to_be_bytes()).collect(), bits: order.join(words) }
    }

    fn field(&self, name: Text, value: Text) -> Field {
        field(&self.bytes, name, value)
    }

    /// The value where nobody knows what it means.
    fn plain(&self) -> Text {
        match self.bytes.len() {
            4 => Text::name(format_args!("{} (0x{:08X})", self.bits as i32, self.bits)),
            _ => Text::name(format_args!("{} (0x{:04X})", self.bits, self.bits)),
        }
    }
}
