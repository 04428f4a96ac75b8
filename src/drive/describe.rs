//! From raw integers to what people and scripts read: values, words, states, faults, catalogue rows.

use super::transfer::Reading;
use crate::failure::Failure;
use crate::outcome::{
    Bit, ChoiceDoc, Decimal, ErrorDoc, Fault, NotLoaded, NotLoadedWhy, ParamDoc, Register, State, Value, Word,
    WriteResult, Written,
};
use crate::profile::value::{self, format_decimal};
use crate::profile::{Cause, DataSets, Effective, Family, HazardKind, Param, Role, Sets, Store};
use crate::text::{Text, both};

/// Tells the present raw value of another parameter, where the names of bits depend on one.
pub type Lookup<'a> = &'a dyn Fn(u32) -> Option<i64>;

/// Data set (0-4) and memory that a data set number on the wire (0-9) stands for.
pub fn place(wire_set: u8) -> (u8, Store) {
    match wire_set.checked_sub(DataSets::RAM_OFFSET) {
        Some(set) => (set, Store::Ram),
        None => (wire_set, Store::Eeprom),
    }
}

/// The same as what is asked for.
pub fn sets(wire_set: u8) -> DataSets {
    let (set, store) = place(wire_set);
    DataSets::One(set, store)
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
pub fn value(address: u8, family: &Family, param: &Param, reading: Reading, lookup: Lookup<'_>) -> Value {
    if reading.text.is_some() {
        let kind = Some(reading.kind.name());
        return Value { text: reading.text.map(Text::name), kind, ..blank(address, family, param, reading.set) };
    }
    let text = family.text_of(param, reading.raw).cloned();
    let word = family.is_word(param).then(|| word(family, param, reading.raw as u32, lookup));
    let text = text.or_else(|| coded(family, param, reading.raw));
    let digits = value::digits(param, reading.raw);
    let text = text.or_else(|| value::odd(param, reading.raw));
    let expected = expected(family, param, reading.raw);
    Value {
        raw: Some(reading.raw),
        value: digits.filter(|_| param.has_scale() && expected.is_none()).map(decimal),
        text,
        word,
        expected,
        kind: Some(reading.kind.name()),
        ..blank(address, family, param, reading.set)
    }
}

fn decimal((raw, decimals): (i64, u8)) -> Decimal {
    Decimal { raw, decimals }
}

/// What codes stand for that have tables of their own: faults and the error register.
fn coded(family: &Family, param: &Param, raw: i64) -> Option<Text> {
    let is = |role: Role| family.role(role).is_some_and(|known| known.id == param.id);
    let code = u32::try_from(raw).ok()?;
    if is(Role::Fault) {
        return Some(fault(family, code).map_or_else(|| both!("no fault", "keine Störung"), |fault| fault.told()));
    }
    is(Role::ErrorRegister).then(|| register(family, code).name)
}

/// A value that could not be read.
pub fn unread(address: u8, family: &Family, param: &Param, wire_set: u8, failure: &Failure) -> Value {
    Value { error: Some(ErrorDoc::from(failure)), ..blank(address, family, param, wire_set) }
}

fn blank(address: u8, family: &Family, param: &Param, wire_set: u8) -> Value {
    let (data_set, store) = place(wire_set);
    Value {
        address,
        node: 0,
        drive: family.drive.clone(),
        param: param.number(),
        index: param.element(),
        slug: param.slug.clone(),
        name: param.name.clone(),
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
pub fn to_write(address: u8, family: &Family, param: &Param, wire_set: u8, raw: i64) -> Written {
    let (data_set, store) = place(wire_set);
    Written {
        address,
        node: 0,
        drive: family.drive.clone(),
        param: param.number(),
        index: param.element(),
        slug: param.slug.clone(),
        name: param.name.clone(),
        data_set,
        store: kept(store, param),
        old_raw: None,
        old: None,
        raw,
        value: scaled(param, raw).or_else(|| param.has_scale().then_some(decimal((raw, 0)))),
        unit: param.unit.clone(),
        text: family.text_of(param, raw).cloned(),
        result: WriteResult::Planned,
        telegram: None,
        meaning: None,
        note: (param.effective == Effective::Reset).then(|| family.link.after_reset.clone()),
        error: None,
    }
}

/// A raw integer as its value; `None` where no source tells where its point stands.
pub fn scaled(param: &Param, raw: i64) -> Option<Decimal> {
    value::digits(param, raw).filter(|_| param.has_scale()).map(decimal)
}

/// What a row tells as old and as new, and behind it the unit, or that they are raw.
pub fn change(row: &Written) -> (Option<String>, String, Text) {
    let shown = |value: Option<Decimal>, raw: i64| match value {
        Some(value) => format_decimal(value.raw, value.decimals),
        None => raw.to_string(),
    };
    let unit = match (&row.unit, row.value) {
        (None, _) => Text::default(),
        (Some(unit), Some(_)) => both!(" {unit}", " {unit}"),
        (Some(unit), None) => both!(" (raw, decimals unknown: {unit})", " (roh, Nachkommastellen unbekannt: {unit})"),
    };
    (row.old_raw.map(|raw| shown(row.old, raw)), shown(row.value, row.raw), unit)
}

/// A setting of a file that is not written.
pub fn left_out(param: &Param, data_set: u8, why: NotLoadedWhy) -> NotLoaded {
    NotLoaded { param: param.number(), data_set, slug: param.slug.clone(), name: param.name.clone(), why }
}

/// A word bit by bit.
pub fn word(family: &Family, param: &Param, raw: u32, lookup: Lookup<'_>) -> Word {
    let bits: Vec<Bit> = family
        .word(param, raw, lookup)
        .into_iter()
        .map(|bit| Bit {
            bit: bit.bit,
            set: bit.set,
            slug: bit.row.map(|row| row.slug.clone()),
            name: bit.row.map(|row| row.text()),
            help: bit.row.and_then(|row| row.help.clone()),
        })
        .collect();
    // Some families name no states.
    let is_status =
        family.role(Role::StatusWord).is_some_and(|status| status.id == param.id && !family.states.is_empty());
    Word {
        raw,
        hex: format!("0x{raw:04X}"),
        unknown: bits.iter().filter(|bit| bit.set && bit.slug.is_none()).map(|bit| bit.bit).collect(),
        bits,
        state: is_status.then(|| state(family, raw)),
    }
}

/// The state that a status word stands for.
pub fn state(family: &Family, status: u32) -> State {
    match family.state(status) {
        Some(row) => State { slug: row.slug.clone(), name: row.text() },
        None => State { slug: "unknown".to_owned(), name: both!("unknown state", "unbekannter Zustand") },
    }
}

/// The fault behind a code; `None` for 0.
pub fn fault(family: &Family, code: u32) -> Option<Fault> {
    if code == 0 {
        return None;
    }
    let row = family.fault(code);
    let group = family.fault_group(code).map(|group| group.text());
    let unknown = || both!("undocumented fault", "nicht dokumentierte Störung");
    let node = row.and_then(|row| row.last).map(|_| code & 0xFF);
    // Texts of a whole range say the word `nn` where the number belongs.
    let fill = |word: &str, node: u32| if word == "nn" { node.to_string() } else { word.to_owned() };
    let filled = |text: &Text| match node {
        Some(node) => Text::by(|lang| {
            let words = text.get(lang).split(' ').map(|word| fill(word, node));
            words.collect::<Vec<_>>().join(" ")
        }),
        None => text.clone(),
    };
    Some(Fault {
        code,
        key: family.fault_codes.displayed(code),
        group,
        name: row.map_or_else(unknown, |row| filled(&row.text())),
        cause: row.and_then(|row| row.cause.as_ref()).map(filled),
        remedy: row.and_then(|row| row.remedy.as_ref()).map(filled),
        node,
    })
}

/// A code of the error register.
pub fn register(family: &Family, code: u32) -> Register {
    match family.error(code) {
        Some(row) => Register { code, slug: row.slug.clone(), name: row.text(), hint: Some(row.hint.clone()) },
        None => {
            // 0 means the same everywhere: nothing was refused.
            let (slug, name) = match code {
                0 => ("none", both!("nothing was refused", "nichts wurde abgelehnt")),
                _ if matches!(family.link.cause, Cause::Diagnostics(_)) => (
                    "unknown",
                    both!(
                        "a telegram was refused at some time, of whomever; no source tells what the number means",
                        "irgendwann wurde ein Telegramm abgelehnt, gleich wessen; was die Nummer heißt, sagt keine Quelle"
                    ),
                ),
                _ => ("unknown", both!("unknown code", "unbekannter Code")),
            };
            Register { code, slug: slug.to_owned(), name, hint: None }
        }
    }
}

/// A row of the catalogue.
pub fn param_doc(family: &Family, param: &Param) -> ParamDoc {
    let decimal = |raw: Option<i64>| raw.map(|raw| Decimal { raw, decimals: param.decimals_or_zero() });
    let named = family.word(param, u32::MAX, |_| None);
    ParamDoc {
        param: param.id,
        slug: param.slug.clone(),
        name: param.name.clone(),
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
            .filter_map(|(raw, _)| Some(ChoiceDoc { raw, text: family.text_of(param, raw)?.clone() }))
            .collect(),
        bits: named
            .into_iter()
            .filter_map(|bit| {
                bit.row.map(|row| Bit {
                    bit: bit.bit,
                    set: false,
                    slug: Some(row.slug.clone()),
                    name: Some(row.text()),
                    help: row.help.clone(),
                })
            })
            .collect(),
        address: param.address,
        note: param.note.clone(),
        unconfirmed: param.unconfirmed.clone(),
        source: param.source.clone(),
        origin: param.origin.clone(),
    }
}
