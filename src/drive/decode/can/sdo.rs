//! SDO in words: parameters by their names, values as far as the catalogue tells their type.

use super::super::{Reader, field};
use super::{Told, names};
use crate::drive::describe;
use crate::outcome::Field;
use crate::profile::value::{from_wire, value_text};
use crate::profile::{Param, Type};
use crate::protocol::can::sdo::{AbortCode, Initiate, Multiplexer, Reply, Request, Segment};
use crate::protocol::can::{LAST_DRIVE, Payload, SdoChannel};
use crate::text::{Text, both};

/// What a frame of SDO says: meaning, whose value, the value, and the fields behind the command byte.
struct Said {
    meaning: Text,
    of: Option<Multiplexer>,
    raw: Option<i64>,
    fields: Vec<Field>,
    refuses: bool,
}

impl Said {
    fn bare(meaning: Text) -> Self {
        Said { meaning, of: None, raw: None, fields: Vec::new(), refuses: false }
    }
}

impl Reader<'_> {
    pub(super) fn sdo_request(&self, channel: SdoChannel, node: u8, payload: &Payload) -> Told {
        let Some(bytes) = payload.eight() else {
            return told(channel, node, "sdo_request", Err(names::eight_bytes()), payload);
        };
        let said = match Request::decode(bytes) {
            Request::Upload(of) => {
                let what = self.subject_of(of);
                self.about(of, both!("read {what}", "lesen {what}", what), None)
            }
            Request::Download(of, initiate) => {
                let (raw, value) = self.begun(of, initiate);
                let what = Text::join([&self.subject_of(of), &value], " = ");
                Said { raw, ..self.about(of, both!("write {what}", "schreiben {what}", what), Some(value)) }
            }
            Request::DownloadSegment(segment) => {
                let piece = piece(&segment);
                Said::bare(both!("write on: {piece}", "weiter schreiben: {piece}", piece))
            }
            Request::UploadSegment { .. } => Said::bare(both!("read on", "weiter lesen")),
            Request::Abort(of, code) => self.ended(of, code, &both!("given up", "abgebrochen")),
            Request::Other(command) => Said::bare(names::strange(command)),
        };
        told(channel, node, "sdo_request", Ok(said), payload)
    }

    pub(super) fn sdo_reply(&self, channel: SdoChannel, node: u8, payload: &Payload) -> Told {
        let Some(bytes) = payload.eight() else {
            return told(channel, node, "sdo_reply", Err(names::eight_bytes()), payload);
        };
        let said = match Reply::decode(bytes) {
            Reply::Upload(of, initiate) => {
                let (raw, value) = self.begun(of, initiate);
                let what = Text::join([&self.subject_of(of), &value], " = ");
                Said { raw, ..self.about(of, what, Some(value)) }
            }
            Reply::Downloaded(of) => {
                let what = self.subject_of(of);
                self.about(of, both!("written: {what}", "geschrieben: {what}", what), None)
            }
            Reply::UploadSegment(segment) => Said::bare(piece(&segment)),
            Reply::SegmentDownloaded { .. } => Said::bare(both!("piece taken", "Teilstück angenommen")),
            Reply::Abort(of, code) => self.ended(of, code, &both!("refused", "abgelehnt")),
            Reply::Other(command) => Said::bare(names::strange(command)),
        };
        told(channel, node, "sdo_reply", Ok(said), payload)
    }

    fn param_of(&self, of: Multiplexer) -> Option<&Param> {
        self.family.and_then(|family| family.param(of.index.into()))
    }

    /// `P.372@2 Rated Speed`; what is none of the drives' parameters is an object of CANopen.
    fn subject_of(&self, of: Multiplexer) -> Text {
        let Multiplexer { index, sub } = of;
        match self.param_of(of) {
            Some(param) => both!("P.{index}@{sub} {name}", "P.{index}@{sub} {name}", name = param.name),
            None if index > LAST_PARAM => both!("object {index:04X}h:{sub}", "Objekt {index:04X}h:{sub}"),
            None => Text::name(format_args!("P.{index}@{sub}")),
        }
    }

    /// A value, or that it follows in pieces.
    fn begun(&self, of: Multiplexer, initiate: Initiate) -> (Option<i64>, Text) {
        match initiate {
            Initiate::Expedited { bytes, size } => self.object_value(of, u32::from_le_bytes(bytes), size),
            Initiate::Segmented { size: Some(size) } => {
                (None, both!("{size} bytes follow in pieces", "{size} Byte folgen in Teilstücken"))
            }
            Initiate::Segmented { size: None } => (None, both!("follows in pieces", "folgt in Teilstücken")),
        }
    }

    /// A value as far as anybody tells what it is. The drives answer four bytes whatever the width (manual 5.10.1), and what is
    /// below zero in two of them looks like a large number.
    fn object_value(&self, of: Multiplexer, bits: u32, size: Option<u8>) -> (Option<i64>, Text) {
        let bits = match size {
            Some(size @ 1..=3) => bits & ((1 << (8 * u32::from(size))) - 1),
            _ => bits,
        };
        let untold = both!("0x{bits:08X}, width not known", "0x{bits:08X}, Breite nicht bekannt");
        let Some((family, param)) = self.family.zip(self.param_of(of)) else {
            let is_small = bits < 0x8000;
            return if is_small { (Some(bits.into()), Text::name(bits)) } else { (None, untold) };
        };
        let kind = param.kind.or_else(|| presumed(param, bits));
        let Some(kind) = kind.filter(|kind| fits(*kind, bits)) else { return (None, untold) };
        let raw = from_wire(bits, kind, param.min);
        let number = value_text(param, raw);
        let value = match family.text_of(param, raw) {
            Some(text) => both!("{number} ({text})", "{number} ({text})", text),
            None => Text::name(number),
        };
        (Some(raw), value)
    }

    /// What is said of a parameter, and its fields.
    fn about(&self, of: Multiplexer, meaning: Text, value: Option<Text>) -> Said {
        let subject = self.subject_of(of);
        let mut fields = vec![
            field(&of.index.to_le_bytes(), both!("index", "Index"), subject),
            field(&[of.sub], both!("sub-index", "Subindex"), names::set(of.sub)),
        ];
        fields.extend(value.map(|value| field(&[], both!("value", "Wert"), value)));
        Said { meaning, of: Some(of), raw: None, fields, refuses: false }
    }

    /// An abort: of a drive its error register's code, else one of CiA 301.
    fn ended(&self, of: Multiplexer, code: AbortCode, how: &Text) -> Said {
        let why = match (code.of_a_drive(), self.family) {
            (Some(code), Some(family)) => {
                let name = describe::register(family, code.into()).name;
                both!("error {code}, {name}", "Fehler {code}, {name}", name)
            }
            (Some(code), None) => both!("error {code}", "Fehler {code}"),
            (None, _) => names::abort(code.0),
        };
        let subject = self.subject_of(of);
        let meaning = both!("{how}: {subject}: {why}", "{how}: {subject}: {why}", how, subject, why);
        Said { raw: Some(code.0.into()), refuses: true, ..self.about(of, meaning, Some(why)) }
    }
}

/// Last parameter that a drive has (CM-485 manual); what is above is CANopen's.
const LAST_PARAM: u16 = 1599;

/// The type where no catalogue tells it: what fits in 15 bits reads the same in each width, and where the range has no negative
/// numbers 16 bits do.
fn presumed(param: &Param, bits: u32) -> Option<Type> {
    let is_positive = param.min.is_some_and(|min| min >= 0);
    match bits {
        0..0x8000 => Some(Type::Word),
        0x8000..=0xFFFF if is_positive => Some(Type::Uint),
        _ => None,
    }
}

/// Whether bits may be a value of that type: what is narrower has zeros above it, or its sign.
fn fits(kind: Type, bits: u32) -> bool {
    let is_extended = bits as i32 == i32::from(bits as u16 as i16);
    match kind.bits() {
        Some(16) => bits <= 0xFFFF || (kind != Type::Uint && is_extended),
        Some(_) => true,
        None => false,
    }
}

fn piece(segment: &Segment) -> Text {
    let shown = crate::protocol::Hex(segment.bytes()).to_string();
    match segment.is_last {
        true => both!("last piece {shown}", "letztes Teilstück {shown}"),
        false => both!("piece {shown}", "Teilstück {shown}"),
    }
}

fn told(channel: SdoChannel, node: u8, service: &'static str, said: Result<Said, Text>, payload: &Payload) -> Told {
    let direction = if service == "sdo_request" { "request" } else { "reply" };
    let base = match said {
        Err(expected) => Told::wrong(service, &expected),
        Ok(said) => {
            let whose = whose(channel, node);
            let command = payload.bytes().get(..1).unwrap_or_default();
            let mut fields = vec![field(command, both!("control byte", "Steuerbyte"), whose.clone())];
            fields.extend(said.fields);
            Told {
                param: said.of.map(|of| of.index.into()),
                data_set: said.of.map(|of| of.sub),
                raw: said.raw,
                refuses: said.refuses && service == "sdo_reply",
                fields,
                ..Told::new(service, Text::join([&whose, &said.meaning], ": "))
            }
        }
    };
    Told { node: Some(node), channel: Some(channel.number()), direction: Some(direction), ..base }
}

/// Whom an SDO is with. The second one of a drive has the identifier of the only one of a foreign node of CANopen.
fn whose(channel: SdoChannel, node: u8) -> Text {
    match channel {
        SdoChannel::One => both!("SDO1 node {node}", "SDO1 Knoten {node}"),
        SdoChannel::Two => {
            let other = node + LAST_DRIVE + 1;
            both!("SDO2 node {node} (CANopen: {other})", "SDO2 Knoten {node} (CANopen: {other})")
        }
    }
}
