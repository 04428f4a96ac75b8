//! A module in words and bytes.

use super::{is_output, usage, word};
use crate::drive::decode::field;
use crate::failure::Failure;
use crate::outcome::{BasicModule, Field};
use crate::profile::value::{digits, from_wire, written};
use crate::profile::{Family, Param, Type};
use crate::protocol::dp::cfg::{Layout, of_words};
use crate::protocol::dp::module::{Content, Limits, Module, ModuleError, Target};
use crate::protocol::modbus::Hex;
use crate::text::{Text, both};

pub(super) fn told(input: &str, module: &Module, family: &Family) -> Result<BasicModule, Failure> {
    let bytes = module.encode().map_err(|error| usage(wrong(&error)))?;
    let param = known(module, family);
    let length = bytes_of(module, param);
    let (cfg, open) = identifier(module, length);
    let mut notes: Vec<Text> = open.into_iter().collect();
    notes.extend(doubts(module, family, param));
    Ok(BasicModule {
        input: input.to_owned(),
        drive: word(module.series).to_owned(),
        param: param.map(|param| param.id),
        parameters: Hex(&bytes).to_string(),
        cfg: cfg.map(|byte| Hex(&[byte]).to_string()),
        meaning: meaning(module, param),
        fields: fields(module, &bytes, param),
        notes,
    })
}

/// Why bytes are no module.
pub(super) fn wrong(error: &ModuleError) -> Text {
    match error {
        ModuleError::Length(len) => {
            both!("{error}", "Länge {len}; ein Modul hat 3, 5 oder 7 Bytes (L200, SJ200) oder 2, 4 oder 6 (X200)")
        }
        ModuleError::Target(number) => both!("{error}", "{number:04X}h passt nicht in die Bytes des Moduls"),
    }
}

/// The parameter that a module carries, if the catalogue knows it.
fn known<'f>(module: &Module, family: &'f Family) -> Option<&'f Param> {
    let Content::Parameter { target, .. } = module.content else { return None };
    match target {
        Target::Index(index) => family.param(index.into()),
        Target::Address(address) => family.params.values().find(|param| param.address == Some(address)),
    }
}

/// Length of the value: as the flags say, else as the catalogue does.
fn bytes_of(module: &Module, param: Option<&Param>) -> Option<u8> {
    match module.content {
        Content::Basic => Some(8),
        Content::Parameter { length, .. } => length.or_else(|| param?.kind?.bytes()),
    }
}

/// Identifier of Chk_Cfg. The examples show words only; of a module of one byte or of four it is open.
fn identifier(module: &Module, length: Option<u8>) -> (Option<u8>, Option<Text>) {
    let out = is_output(module);
    let open = |bytes: [u8; 2]| {
        let [first, second] = bytes;
        both!(
            "the identifier in Chk_Cfg is open: the examples of the manual show words only; {first:02X} or {second:02X}, as the GSD says",
            "die Kennung in Chk_Cfg ist offen: die Beispiele der Anleitung zeigen nur Wörter; {first:02X} oder {second:02X}, wie es die GSD sagt"
        )
    };
    match (module.content == Content::Basic, length) {
        (true, _) => (Layout::Basic.bytes().first().copied(), None),
        (false, Some(2)) => (Some(of_words(1, out)), None),
        (false, Some(1)) => (None, Some(open([of_words(1, out) & !0x40, of_words(1, out)]))),
        (false, Some(4)) => (None, Some(open([of_words(2, out), of_words(4, out) & !0x40]))),
        (false, _) => {
            (None, Some(both!("no source tells the length of the value", "keine Quelle nennt die Länge des Werts")))
        }
    }
}

fn meaning(module: &Module, param: Option<&Param>) -> Text {
    let series = word(module.series).to_uppercase();
    let Content::Parameter { target, is_output, .. } = module.content else {
        return both!("{series}: Basic block", "{series}: Basic-Block");
    };
    let what = match (param, target) {
        (Some(param), _) => Text::join([&Text::name(param.label()), &param.name], " "),
        (None, Target::Index(index)) => both!("index {index}, in no source", "Index {index}, in keiner Quelle"),
        (None, Target::Address(address)) => {
            both!("address {address:04X}h, in no source", "Adresse {address:04X}h, in keiner Quelle")
        }
    };
    match is_output {
        true => both!("{series}: set {what}", "{series}: setzt {what}", what),
        false => both!("{series}: get {what}", "{series}: liest {what}", what),
    }
}

/// The bytes one by one, and the flags of the first.
fn fields(module: &Module, bytes: &[u8], param: Option<&Param>) -> Vec<Field> {
    let (head, limits) = bytes.split_at(if bytes.len().is_multiple_of(2) { 2 } else { 3 });
    let (flags, number) = head.split_at(1);
    let mut fields = vec![field(flags, both!("flags", "Merker"), flags_of(module))];
    fields.push(match module.content {
        Content::Basic => field(number, both!("index", "Index"), both!("Basic block", "Basic-Block")),
        Content::Parameter { target: Target::Index(index), .. } => {
            field(number, both!("index", "Index"), Text::name(index))
        }
        Content::Parameter { target: Target::Address(address), .. } => {
            field(number, both!("address", "Adresse"), Text::name(format_args!("{address:04X}h")))
        }
    });
    let (low, high) = limits.split_at(limits.len() / 2);
    if !limits.is_empty() {
        fields.push(field(low, both!("least value", "kleinster Wert"), raw(low, param)));
        fields.push(field(high, both!("largest value", "größter Wert"), raw(high, param)));
    }
    fields
}

/// A raw limit, with what the catalogue makes of it.
fn raw(bytes: &[u8], param: Option<&Param>) -> Text {
    let bits = bytes.iter().fold(0, |word: u32, byte| word << 8 | u32::from(*byte));
    let kind = param.and_then(|param| param.kind).unwrap_or(Type::Uint);
    let value = param.filter(|param| param.has_scale()).and_then(|param| {
        let raw = from_wire(bits, kind, param.min);
        digits(param, raw)?;
        let number = written(param, raw);
        Some(param.unit.as_ref().map_or(number.clone(), |unit| format!("{number} {unit}")))
    });
    match value {
        Some(value) => Text::name(format_args!("{bits} = {value}")),
        None => Text::name(bits),
    }
}

fn flags_of(module: &Module) -> Text {
    let mut told = vec![Text::name(word(module.series).to_uppercase())];
    told.push(match is_output(module) || module.content == Content::Basic {
        true => both!("output", "Ausgang"),
        false => both!("input", "Eingang"),
    });
    if let Content::Parameter { target, length, limits, .. } = module.content {
        told.push(match target {
            Target::Index(_) => both!("by index", "über Index"),
            Target::Address(_) => both!("by address", "über Adresse"),
        });
        if limits != Limits::None {
            told.push(both!("generic", "mit Grenzen (generic)"));
        }
        told.extend(length.map(|length| Text::count(length.into(), ["byte", "bytes"], ["Byte", "Bytes"])));
    }
    told.push(match module.swapped {
        true => both!("swapped", "vertauscht (swapped)"),
        false => both!("not swapped", "nicht vertauscht"),
    });
    Text::join(&told, ", ")
}

/// What the manual leaves open of this module.
fn doubts(module: &Module, family: &Family, param: Option<&Param>) -> Vec<Text> {
    let mut doubts = Vec::new();
    let Content::Parameter { limits, .. } = module.content else { return doubts };
    if param.is_none() {
        let drive = family.drive.to_uppercase();
        doubts.push(both!(
            "the catalogue of {drive} has no such parameter",
            "der Katalog von {drive} hat keinen solchen Parameter"
        ));
    }
    if param.is_some_and(|param| param.kind == Some(Type::Time)) {
        doubts.push(both!(
            "times below 100 s are negative in the list of parameters, while the manual's module has the limits 0001h to 7530h: \
             which code a module uses is open",
            "Zeiten unter 100 s sind in der Parameterliste negativ, das Modul der Anleitung hat aber die Grenzen 0001h bis 7530h: \
             welchen Code ein Modul benutzt, ist offen"
        ));
    }
    if module.swapped {
        doubts.push(both!(
            "swapped: the bytes of a word, or the words of a double word; the manual can be read both ways",
            "vertauscht: die Bytes eines Worts oder die Wörter eines Doppelworts; die Anleitung lässt beides zu"
        ));
    }
    if limits == Limits::Missing {
        doubts.push(both!("generic, and no limits follow", "mit Grenzen (generic), aber es folgen keine"));
    }
    doubts
}
