//! From raw integers to what people and scripts read: values, words, states, faults, catalogue rows.

use super::transfer::Reading;
use crate::failure::Failure;
use crate::outcome::{
    Bit, ChoiceDoc, Decimal, ErrorDoc, Fault, ParamDoc, Register, State, Value, Word, WriteResult, Written,
};
use crate::profile::value::format_decimal;
use crate::profile::{DataSets, Effective, Family, HazardKind, Lang, Param, Role, Sets, Store};

/// Tells the present raw value of another parameter, where the names of bits depend on one.
pub type Lookup<'a> = &'a dyn Fn(u32) -> Option<i64>;

/// Data set (0-4) and memory that a data set number on the wire (0-9) stands for.
pub fn place(wire_set: u8) -> (u8, Store) {
    match wire_set.checked_sub(DataSets::RAM_OFFSET) {
        Some(set) => (set, Store::Ram),
        None => (wire_set, Store::Eeprom),
    }
}

/// Word that names a memory: `eeprom` or `ram`. Volatile parameters live in RAM whatever the data set says.
fn store_name(store: Store, volatile: bool) -> &'static str {
    if volatile || store == Store::Ram { "ram" } else { "eeprom" }
}

/// Where a parameter is kept, as far as a source tells it: `eeprom`, `ram`, or `unknown`.
pub fn kept(store: Store, param: &Param) -> &'static str {
    let unknown = param.unconfirmed.iter().any(|field| field == "volatile");
    if unknown { "unknown" } else { store_name(store, param.is_volatile()) }
}

/// What the catalogue expects of a value that lies outside of it: a number beyond its printed range, or one that its table
/// does not name although the range says that the table is whole. `None` if the value may be right.
pub fn expected(family: &Family, param: &Param, raw: i64) -> Option<String> {
    let sure = |field: &str| !param.unconfirmed.iter().any(|doubt| doubt == field || doubt == "row");
    let min = param.min.filter(|_| sure("min"));
    let max = param.max.filter(|_| sure("max"));
    let choices = family.choices(param);
    let (low, high) = (choices.first().map(|row| row.0), choices.last().map(|row| row.0));
    // The table of a setting of the line is whole; others name what the sources name.
    let is_whole = low.is_some() && (min, max) == (low, high) && sure("enum");
    let is_named = choices.iter().any(|row| row.0 == raw);
    let is_outside = min.is_some_and(|min| raw < min) || max.is_some_and(|max| raw > max);
    if !is_outside && (!is_whole || is_named) {
        return None;
    }
    let shown = |raw: i64| format_decimal(raw, param.decimals_or_zero());
    let range = |limit: Option<i64>| limit.map_or_else(|| "?".to_owned(), shown);
    let list = || choices.iter().map(|row| shown(row.0)).collect::<Vec<_>>().join(", ");
    Some(if is_whole { list() } else { format!("{} … {}", range(min), range(max)) })
}

/// A value that was read.
pub fn value(address: u8, family: &Family, param: &Param, reading: Reading, lang: Lang, lookup: Lookup<'_>) -> Value {
    let decimals = param.decimals_or_zero();
    if reading.text.is_some() {
        let kind = Some(reading.kind.name());
        return Value { text: reading.text, kind, ..blank(address, family, param, reading.set, lang) };
    }
    let text = family.text_of(param, reading.raw).map(|text| text.get(lang).to_owned());
    let word = family.is_word(param).then(|| word(family, param, reading.raw as u32, lang, lookup));
    let text = text.or_else(|| coded(family, param, reading.raw, lang));
    let expected = expected(family, param, reading.raw);
    Value {
        raw: Some(reading.raw),
        value: (param.has_scale() && expected.is_none()).then_some(Decimal { raw: reading.raw, decimals }),
        text,
        word,
        expected,
        kind: Some(reading.kind.name()),
        ..blank(address, family, param, reading.set, lang)
    }
}

/// What codes stand for that have tables of their own: faults and the error register.
fn coded(family: &Family, param: &Param, raw: i64, lang: Lang) -> Option<String> {
    let is = |role: Role| family.role(role).is_some_and(|known| known.id == param.id);
    let code = u32::try_from(raw).ok()?;
    if is(Role::Fault) {
        let none = if lang == Lang::De { "keine Störung" } else { "no fault" };
        return Some(fault(family, code, lang).map_or_else(|| none.to_owned(), |f| format!("{} {}", f.key, f.name)));
    }
    is(Role::ErrorRegister).then(|| register(family, code, lang).name)
}

/// A value that could not be read.
pub fn unread(address: u8, family: &Family, param: &Param, wire_set: u8, lang: Lang, failure: &Failure) -> Value {
    Value { error: Some(ErrorDoc::from(failure)), ..blank(address, family, param, wire_set, lang) }
}

fn blank(address: u8, family: &Family, param: &Param, wire_set: u8, lang: Lang) -> Value {
    let (data_set, store) = place(wire_set);
    Value {
        address,
        node: 0,
        drive: family.drive.clone(),
        param: param.id,
        slug: param.slug.clone(),
        name: param.name(lang).to_owned(),
        data_set,
        store: kept(store, param),
        raw: None,
        value: None,
        decimals: param.decimals,
        unit: param.unit.clone(),
        text: None,
        word: None,
        kind: param.kind.map(|kind| kind.name()),
        origin: param.origin.clone(),
        unconfirmed: param.unconfirmed.clone(),
        expected: None,
        error: None,
        hex: param.hex,
    }
}

/// A value that is, or was, to be written.
pub fn to_write(address: u8, family: &Family, param: &Param, wire_set: u8, raw: i64, lang: Lang) -> Written {
    let (data_set, store) = place(wire_set);
    let after_reset = family.link.after_reset.get(lang);
    Written {
        address,
        node: 0,
        drive: family.drive.clone(),
        param: param.id,
        slug: param.slug.clone(),
        name: param.name(lang).to_owned(),
        data_set,
        store: kept(store, param),
        old_raw: None,
        old: None,
        raw,
        value: Decimal { raw, decimals: param.decimals_or_zero() },
        unit: param.unit.clone(),
        text: family.text_of(param, raw).map(|text| text.get(lang).to_owned()),
        result: WriteResult::Planned,
        telegram: None,
        meaning: None,
        note: (param.effective == Effective::Reset).then(|| after_reset.to_owned()),
        error: None,
    }
}

/// A word bit by bit.
pub fn word(family: &Family, param: &Param, raw: u32, lang: Lang, lookup: Lookup<'_>) -> Word {
    let bits: Vec<Bit> = family
        .word(param, raw, lookup)
        .into_iter()
        .map(|bit| Bit {
            bit: bit.bit,
            set: bit.set,
            slug: bit.row.map(|row| row.slug.clone()),
            name: bit.row.map(|row| row.name(lang).to_owned()),
            help: bit.row.and_then(|row| row.help.as_ref()).map(|help| help.get(lang).to_owned()),
        })
        .collect();
    let is_status = family.role(Role::StatusWord).is_some_and(|status| status.id == param.id);
    Word {
        raw,
        hex: format!("0x{raw:04X}"),
        unknown: bits.iter().filter(|bit| bit.set && bit.slug.is_none()).map(|bit| bit.bit).collect(),
        bits,
        state: is_status.then(|| state(family, raw, lang)),
    }
}

/// The state that a status word stands for.
pub fn state(family: &Family, status: u32, lang: Lang) -> State {
    match family.state(status) {
        Some(row) => State { slug: row.slug.clone(), name: row.name(lang).to_owned() },
        None => {
            let name = if lang == Lang::De { "unbekannter Zustand" } else { "unknown state" };
            State { slug: "unknown".to_owned(), name: name.to_owned() }
        }
    }
}

/// The fault behind a code; `None` for 0.
pub fn fault(family: &Family, code: u32, lang: Lang) -> Option<Fault> {
    if code == 0 {
        return None;
    }
    let row = family.fault(code);
    let group = family.fault_group(code).map(|group| group.name(lang).to_owned());
    let unknown = || {
        let text = if lang == Lang::De { "nicht dokumentierte Störung" } else { "undocumented fault" };
        text.to_owned()
    };
    let node = row.and_then(|row| row.last).map(|_| code & 0xFF);
    // Texts of a whole range say the word `nn` where the number belongs.
    let fill = |word: &str, node: u32| if word == "nn" { node.to_string() } else { word.to_owned() };
    let filled = |text: &str| match node {
        Some(node) => text.split(' ').map(|word| fill(word, node)).collect::<Vec<_>>().join(" "),
        None => text.to_owned(),
    };
    Some(Fault {
        code,
        key: format!("{}{code:04X}", family.fault_codes.letter),
        group,
        name: row.map_or_else(unknown, |row| filled(row.name(lang))),
        cause: row.map(|row| filled(row.cause.get(lang))),
        remedy: row.map(|row| filled(row.remedy.get(lang))),
        node,
    })
}

/// A code of the error register.
pub fn register(family: &Family, code: u32, lang: Lang) -> Register {
    match family.error(code) {
        Some(row) => Register {
            code,
            slug: row.slug.clone(),
            name: row.name(lang).to_owned(),
            hint: Some(row.hint.get(lang).to_owned()),
        },
        None => {
            // 0 means the same everywhere: nothing was refused.
            let (slug, name) = match code {
                0 => ("none", lang.pick("nothing was refused", "nichts wurde abgelehnt")),
                _ => ("unknown", lang.pick("unknown code", "unbekannter Code")),
            };
            Register { code, slug: slug.to_owned(), name: name.to_owned(), hint: None }
        }
    }
}

/// A row of the catalogue.
pub fn param_doc(family: &Family, param: &Param, lang: Lang) -> ParamDoc {
    let decimal = |raw: Option<i64>| raw.map(|raw| Decimal { raw, decimals: param.decimals_or_zero() });
    let index = usize::from(lang == Lang::De);
    let named = family.word(param, u32::MAX, |_| None);
    ParamDoc {
        param: param.id,
        slug: param.slug.clone(),
        name: param.name(lang).to_owned(),
        unit: param.unit.clone(),
        kind: param.kind.map(|kind| kind.name()),
        decimals: param.decimals,
        min: decimal(param.min),
        max: decimal(param.max),
        default: decimal(param.default),
        access: param.access.name(),
        data_sets: param.sets.map(|sets| if sets == Sets::Four { 4 } else { 1 }),
        volatile: param.volatile,
        after_reset: param.effective == Effective::Reset,
        hazard: param.hazard.map(|hazard| match hazard {
            HazardKind::Motion => "motion",
            HazardKind::Line => "line",
            HazardKind::Reset => "reset",
        }),
        module: param.module.clone(),
        values: family
            .choices(param)
            .into_iter()
            .map(|(raw, names)| ChoiceDoc { raw, text: names.get(index).copied().unwrap_or_default().to_owned() })
            .collect(),
        bits: named
            .into_iter()
            .filter_map(|bit| {
                bit.row.map(|row| Bit {
                    bit: bit.bit,
                    set: false,
                    slug: Some(row.slug.clone()),
                    name: Some(row.name(lang).to_owned()),
                    help: row.help.as_ref().map(|help| help.get(lang).to_owned()),
                })
            })
            .collect(),
        note: param.note.as_ref().map(|note| note.get(lang).to_owned()),
        unconfirmed: param.unconfirmed.clone(),
        source: param.source.clone(),
        origin: param.origin.clone(),
    }
}
