//! A module in words, as the manual names them: `L200 set deceleration (non inverted, index based, generic, min. 0x0001, max. 0x7530)`.

use super::{inverter, usage, word};
use crate::failure::Failure;
use crate::profile::{Access, Family, Param, Registry};
use crate::protocol::dp::module::{Content, Limits, Module, Series, Target};
use crate::text::{Text, both};
use std::rc::Rc;

/// From here on a parameter is one of the gateway or of PROFIdrive, and has an index only (manual 3.1.1; 600 itself is open).
const GATEWAY: u32 = 600;

/// What the words behind the name say.
#[derive(Default)]
struct Wishes {
    swapped: bool,
    by_address: bool,
    generic: bool,
    min: Option<i64>,
    max: Option<i64>,
}

pub(super) fn read(text: &str, named: Option<&Family>, registry: &Registry) -> Result<(Module, Rc<Family>), Failure> {
    let words = text.split(|c: char| c.is_whitespace() || matches!(c, ',' | '(' | ')' | '[' | ']' | '='));
    let mut words: Vec<&str> = words.map(|word| word.trim_end_matches('.')).filter(|word| !word.is_empty()).collect();
    let all = [Series::L200, Series::Sj200, Series::X200];
    let of = |name: &str| all.into_iter().find(|series| word(*series).eq_ignore_ascii_case(name));
    let series = match words.first().and_then(|first| of(first)) {
        Some(series) => {
            words.remove(0);
            series
        }
        None => named.and_then(|family| of(&family.drive)).ok_or_else(|| {
            usage(both!(
                "expected the series first: L200, SJ200 or X200, as in 'L200 set deceleration', got '{text}'",
                "zuerst die Serie: L200, SJ200 oder X200, wie in 'L200 set deceleration'; angegeben: '{text}'"
            ))
        })?,
    };
    let family = inverter(series, registry)?;
    let verb = words.first().map(|word| word.to_lowercase()).unwrap_or_default();
    let (name, wishes) = wishes(words.get(1..).unwrap_or_default())?;
    let content = match verb.as_str() {
        "basic" => block(&name, &wishes)?,
        "get" | "read" | "lesen" => parameter(&name, &wishes, false, &family)?,
        "set" | "write" | "schreiben" => parameter(&name, &wishes, true, &family)?,
        other => {
            return Err(usage(both!(
                "expected `get`, `set` or `basic block` behind the series, got '{other}'",
                "hinter der Serie: `get`, `set` oder `basic block`; angegeben: '{other}'"
            )));
        }
    };
    let content = match (content, series) {
        // The shorter format has no room for the length.
        (Content::Parameter { target, is_output, limits, .. }, Series::X200) => {
            Content::Parameter { target, is_output, length: None, limits }
        }
        (content, _) => content,
    };
    Ok((Module { series, content, swapped: wishes.swapped }, family))
}

/// The Basic block takes no name and no limits.
fn block(name: &str, wishes: &Wishes) -> Result<Content, Failure> {
    let is_plain = !wishes.generic && !wishes.by_address && wishes.min.is_none() && wishes.max.is_none();
    match name.is_empty() || name.eq_ignore_ascii_case("block") {
        true if is_plain => Ok(Content::Basic),
        true => Err(usage(both!(
            "the Basic block takes no address and no limits",
            "der Basic-Block hat keine Adresse und keine Grenzen"
        ))),
        false => Err(usage(both!(
            "expected 'basic block', got 'basic {name}'",
            "erwartet: 'basic block'; angegeben: 'basic {name}'"
        ))),
    }
}

/// The name, and what is wished behind it.
fn wishes(words: &[&str]) -> Result<(String, Wishes), Failure> {
    let (mut name, mut wishes) = (Vec::new(), Wishes::default());
    let mut words = words.iter();
    let mut is_not = false;
    while let Some(word) = words.next() {
        let negated = std::mem::take(&mut is_not);
        match word.to_lowercase().as_str() {
            "non" | "not" => is_not = true,
            "swapped" | "inverted" => wishes.swapped = !negated,
            "generic" => wishes.generic = !negated,
            "index" => {}
            "address" => wishes.by_address = true,
            "based" => {}
            "min" => wishes.min = Some(limit(words.next())?),
            "max" => wishes.max = Some(limit(words.next())?),
            _ => name.push(*word),
        }
    }
    Ok((name.join(" "), wishes))
}

/// A raw value: `0x0001`, `1`, `-1`.
fn limit(word: Option<&&str>) -> Result<i64, Failure> {
    let word = word.copied().unwrap_or_default();
    number(word).ok_or_else(|| {
        usage(both!(
            "expected a raw value such as 0x0001 or 1 behind `min` and `max`, got '{word}'",
            "hinter `min` und `max` ein Rohwert wie 0x0001 oder 1; angegeben: '{word}'"
        ))
    })
}

fn number(word: &str) -> Option<i64> {
    match word.strip_prefix("0x").or_else(|| word.strip_prefix("0X")) {
        Some(digits) if digits.bytes().all(|digit| digit.is_ascii_hexdigit()) => i64::from_str_radix(digits, 16).ok(),
        Some(_) => None,
        None => word.parse().ok(),
    }
}

fn parameter(name: &str, wishes: &Wishes, is_output: bool, family: &Family) -> Result<Content, Failure> {
    let param = found(name, family)?;
    let label = param.label();
    if is_output && param.access == Access::Read {
        return Err(usage(both!("{label} can only be read", "{label} lässt sich nur lesen")));
    }
    let length = param.kind.and_then(|kind| kind.bytes()).ok_or_else(|| {
        usage(both!("no source tells how long {label} is", "keine Quelle sagt, wie lang {label} ist"))
    })?;
    let target = match (wishes.by_address, param.address) {
        (false, _) => Target::Index(param.id as u16),
        (true, Some(address)) => Target::Address(address),
        (true, None) => {
            let first = GATEWAY;
            return Err(usage(both!(
                "{label} has no address: from {first} on there are indexes only",
                "{label} hat keine Adresse: ab {first} gibt es nur Indexe"
            )));
        }
    };
    let limits = limits(wishes, is_output, length)?;
    Ok(Content::Parameter { target, is_output, length: Some(length), limits })
}

/// By its index, by the maker's short name, by its name, or by the address of the option port.
fn found<'f>(name: &str, family: &'f Family) -> Result<&'f Param, Failure> {
    let missing = |why: Text| {
        usage(why).hint(both!(
            "`antrieb --drive {drive} params` lists them",
            "`antrieb --drive {drive} params` zeigt sie",
            drive = family.drive
        ))
    };
    if name.is_empty() {
        return Err(missing(both!(
            "expected a parameter behind `get` or `set`",
            "hinter `get` oder `set` fehlt ein Parameter"
        )));
    }
    if let Some(number) = number(name).and_then(|number| u32::try_from(number).ok()) {
        let at =
            |param: &&Param| param.id == number || param.address.is_some_and(|address| u32::from(address) == number);
        return family.params.values().find(at).ok_or_else(|| {
            missing(both!(
                "{drive} has no parameter {number}",
                "{drive} hat keinen Parameter {number}",
                drive = family.drive
            ))
        });
    }
    family.find(name).map_err(|error| missing(error.text()))
}

fn limits(wishes: &Wishes, is_output: bool, length: u8) -> Result<Limits, Failure> {
    let (min, max) = match (wishes.min, wishes.max) {
        (None, None) if !wishes.generic => return Ok(Limits::None),
        (Some(min), Some(max)) => (min, max),
        _ => {
            return Err(usage(both!(
                "a generic module needs `min` and `max`",
                "ein Modul mit Grenzen braucht `min` und `max`"
            )));
        }
    };
    if !is_output {
        return Err(usage(both!(
            "limits mean nothing to a module that reads",
            "Grenzen haben bei einem lesenden Modul keine Bedeutung"
        )));
    }
    let word = |value: i64| u16::try_from(value).ok().or_else(|| i16::try_from(value).ok().map(|value| value as u16));
    let byte = |value: i64| u8::try_from(value).ok();
    let limits = match length {
        1 => byte(min).zip(byte(max)).map(|(min, max)| Limits::Byte(min, max)),
        2 => word(min).zip(word(max)).map(|(min, max)| Limits::Word(min, max)),
        _ => None,
    };
    limits.ok_or_else(|| {
        usage(both!(
            "`min` {min} and `max` {max} do not fit into {length} byte(s)",
            "`min` {min} und `max` {max} passen nicht in {length} Byte(s)"
        ))
    })
}
