//! What stands in a cell: numbers, types, access, ranges, values with names.

use crate::profile::names::fold;
use crate::profile::param::{Access, Type};
use crate::text::{Text, both};

/// Most places that a value of 32 bits can have.
const MOST_DECIMALS: usize = 9;

/// A word without case, blanks and punctuation.
pub(super) fn dense(text: &str) -> String {
    fold(text).replace(' ', "")
}

/// A number with a point from what people type: `0,5`, `1.234,5`, `−3 000`, `0x1F`; a unit behind it is none of it.
/// In a list with decimal commas a point before three digits parts thousands, in any other a comma does.
pub(super) fn number(text: &str, commas: bool) -> Option<String> {
    let text = text.trim().replace(['−', '–'], "-").replace([' ', '\u{A0}', '\u{202F}', '\''], "");
    if let Some(hex) = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        return Some(i64::from_str_radix(hex, 16).ok()?.to_string());
    }
    let end = text.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '+'))).unwrap_or(text.len());
    let (digits, unit) = text.split_at(end);
    if unit.chars().any(|c| c.is_ascii_digit()) {
        return None;
    }
    let (sign, digits) = match digits.strip_prefix('-') {
        Some(rest) => ("-", rest),
        None => ("", digits.strip_prefix('+').unwrap_or(digits)),
    };
    let thousands = |point: char| {
        let mut parts = digits.split(point);
        let first = parts.next().is_some_and(|part| (1..=3).contains(&part.len()) && part != "0");
        first && parts.all(|part| part.len() == 3)
    };
    let plain = match (digits.rfind('.'), digits.rfind(',')) {
        (Some(point), Some(comma)) if point < comma => digits.replace('.', "").replace(',', "."),
        (Some(_), Some(_)) => digits.replace(',', ""),
        (Some(_), None) if commas && thousands('.') => digits.replace('.', ""),
        (None, Some(_)) if !commas && thousands(',') => digits.replace(',', ""),
        (None, Some(_)) => digits.replace(',', "."),
        _ => digits.to_owned(),
    };
    let (whole, fraction) = plain.split_once('.').unwrap_or((&plain, ""));
    let is_plain = |part: &str| part.is_empty() || are_digits(part);
    if whole.len() + fraction.len() == 0 || !is_plain(whole) || !is_plain(fraction) {
        return None;
    }
    let whole = whole.trim_start_matches('0');
    let whole = if whole.is_empty() { "0" } else { whole };
    Some(if fraction.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") })
}

/// Whether a cell has a decimal mark, a point or a comma, that can be nothing else: not before three digits, or behind the other one,
/// which parts thousands.
pub(super) fn has_decimal(text: &str, mark: char) -> bool {
    let thousands = if mark == ',' { '.' } else { ',' };
    text.split_once(mark).is_some_and(|(whole, fraction)| {
        let whole = whole.trim_start_matches('-');
        let fraction = fraction.split(' ').next().unwrap_or("");
        let is_certain = fraction.len() != 3 || whole == "0" || whole.contains(thousands);
        are_digits(&whole.replace(thousands, "")) && are_digits(fraction) && is_certain
    })
}

/// Whether its only point or comma may part thousands as well as decimals: `1.000`, `12,500 Hz`.
pub(super) fn is_open(text: &str) -> bool {
    let number = text.trim_start_matches('-').split(' ').next().unwrap_or("");
    number.split_once(['.', ',']).is_some_and(|(whole, rest)| {
        (1..=3).contains(&whole.len()) && whole != "0" && rest.len() == 3 && are_digits(whole) && are_digits(rest)
    })
}

fn are_digits(part: &str) -> bool {
    !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit())
}

/// The number of a parameter: `370`, `P.370`, `P370`, `0x172`, `172h`.
pub(super) fn id(text: &str) -> Option<u32> {
    let text = text.trim();
    let bare = ["Parameter", "Par.", "Par", "Pr.", "Pr", "P.", "P", "#"]
        .iter()
        .find_map(|start| {
            text.get(..start.len()).filter(|head| head.eq_ignore_ascii_case(start)).map(|_| &text[start.len()..])
        })
        .unwrap_or(text)
        .trim();
    let hex = bare.strip_prefix("0x").or_else(|| bare.strip_prefix("0X"));
    let hex = hex.or_else(|| bare.strip_suffix('h').or_else(|| bare.strip_suffix('H')));
    let digits = |text: &str, radix| !text.is_empty() && text.chars().all(|c: char| c.is_digit(radix));
    match hex {
        Some(hex) if digits(hex, 16) => u32::from_str_radix(hex, 16).ok(),
        None if digits(bare, 10) => bare.parse().ok(),
        _ => None,
    }
}

/// What a word for a type means.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// One of ours.
    Is(Type),
    /// 32 bits without a sign: carried as 32 bits, never below 0.
    Unsigned32,
    /// Its words would be shown as another number.
    Cannot,
    /// Nobody knows.
    Unknown,
}

/// The type behind a word of a catalogue, of IEC 61131-3, of C, or of a spreadsheet.
pub(super) fn kind(text: &str) -> Kind {
    match dense(text).as_str() {
        "int" | "int16" | "i16" | "s16" | "sint16" | "signed" | "signed16" | "integer" | "integer16" | "short" => {
            Kind::Is(Type::Int)
        }
        "uint" | "uint16" | "u16" | "unsigned" | "unsigned16" | "ushort" => Kind::Is(Type::Uint),
        "word" => Kind::Is(Type::Word),
        "long" | "int32" | "i32" | "s32" | "sint32" | "dint" | "signed32" | "integer32" => Kind::Is(Type::Long),
        "uint32" | "u32" | "udint" | "dword" | "ulong" | "unsigned32" => Kind::Unsigned32,
        "float" | "float32" | "f32" | "real" | "real32" | "single" | "ieee754" => Kind::Is(Type::Float),
        "string" => Kind::Is(Type::String),
        other => {
            let foreign = ["float", "real", "double", "lreal", "int64", "uint64", "lint", "ulint", "i64", "u64", "bcd"];
            let one_bit = ["bool", "boolean", "bit", "coil", "text", "ascii", "char", "int8", "uint8", "byte"];
            if foreign.iter().any(|word| other.starts_with(word)) || one_bit.contains(&other) {
                Kind::Cannot
            } else {
                Kind::Unknown
            }
        }
    }
}

/// Whether two words are the same but for case, blanks and punctuation; such that are only punctuation, letter by letter.
pub(super) fn is_same(one: &str, other: &str) -> bool {
    one.trim() == other.trim() || (!dense(one).is_empty() && dense(one) == dense(other))
}

/// A word by which a list tells 16 bits from others that it may call int.
pub(super) fn is_short(text: &str) -> bool {
    matches!(dense(text).as_str(), "short" | "ushort" | "unsignedshort" | "shortint")
}

/// A word that means 16 bits to some and 32 to others.
pub(super) fn is_plain_int(text: &str) -> bool {
    matches!(dense(text).as_str(), "int" | "uint" | "signed" | "unsigned" | "integer" | "unsignedint")
}

/// Who may read and write.
pub(super) fn access(text: &str) -> Option<Access> {
    Some(match dense(text).as_str() {
        "r" | "rd" | "ro" | "read" | "readonly" | "lesen" | "nurlesen" | "l" | "lesbar" => Access::Read,
        "rw" | "rdwr" | "wr" | "readwrite" | "lesenschreiben" | "ls" | "lesenundschreiben" | "readandwrite" => {
            Access::ReadWrite
        }
        "w" | "wo" | "write" | "writeonly" | "nurschreiben" => Access::Write,
        _ => return None,
    })
}

/// Who may read and write what a list calls writable or not.
pub(super) fn writable(text: &str) -> Option<Access> {
    let is_no = ["no", "nein", "false", "falsch", "0", "n"].contains(&&*dense(text)) || matches!(text, "-" | "–" | "—");
    if yes(text) { Some(Access::ReadWrite) } else { is_no.then_some(Access::Read) }
}

/// A yes.
pub(super) fn yes(text: &str) -> bool {
    ["yes", "ja", "true", "wahr", "x", "1", "y", "j"].contains(&dense(text).as_str())
}

/// Both ends of `0,00 … 999,99 Hz`, `0..100`, `-100 bis 100`, `0 - 5`.
pub(super) fn range(text: &str, commas: bool) -> Option<(String, String)> {
    let text = text.trim().trim_matches(['[', ']', '(', ')']);
    let parted =
        ["...", "…", "..", " bis ", " to ", " – ", " - ", ";", "–"].iter().find_map(|mark| text.split_once(mark));
    let (low, high) = parted.or_else(|| {
        let at = text.get(1..)?.find('-')? + 1;
        Some((text.get(..at)?, text.get(at + 1..)?))
    })?;
    Some((number(low.trim_matches('.'), commas)?, number(high.trim_matches('.'), commas)?))
}

/// Places behind the point for a value that is its raw number times `scale`; `None` if that is no power of ten.
pub(super) fn decimals(scale: &str) -> Option<u8> {
    let plain = scale.trim_end_matches('0').trim_end_matches('.');
    match scale.split_once('.') {
        None => (scale == "1").then_some(0),
        Some(_) if plain == "1" => Some(0),
        Some(_) => {
            let places = plain.strip_prefix("0.")?;
            let is_power = places.strip_suffix('1').is_some_and(|zeros| zeros.bytes().all(|byte| byte == b'0'));
            (is_power && places.len() <= MOST_DECIMALS).then_some(places.len() as u8)
        }
    }
}

/// Values with names: `0=Aus | 1=Ein`, `0: off, 1: on`. Nothing, if it is anything else.
pub(super) fn values(text: &str) -> Vec<(i64, String)> {
    let mut found: Vec<(i64, String)> = Vec::new();
    let marks: &[char] = if text.contains('|') { &['|'] } else { &['|', ';', ','] };
    for part in text.split(marks).map(str::trim).filter(|part| !part.is_empty()) {
        let parted = part.split_once(['=', ':']);
        let number = parted.and_then(|(number, _)| self::number(number, false)?.parse::<i64>().ok());
        match (number, parted, found.last_mut()) {
            (Some(number), Some((_, name)), _) => found.push((number, name.trim().to_owned())),
            // A comma inside a name.
            (None, _, Some(last)) => last.1 = format!("{}, {part}", last.1),
            _ => return Vec::new(),
        }
    }
    found
}

/// Why a type is left out.
pub(super) fn cannot(kind: &str) -> Text {
    both!(
        "the type '{kind}' is none that this program shows right (integers of 16 and 32 bit, floats of 32 bit)",
        "den Typ '{kind}' kann dieses Programm nicht richtig zeigen (nur ganze Zahlen mit 16 und 32 Bit, Gleitkommazahlen mit 32)"
    )
}

/// Why a floating point is left out that the list scales.
pub(super) fn scaled_float() -> Text {
    both!(
        "a float that is scaled or shifted: this program shows it as it stands in the register",
        "eine Gleitkommazahl, die skaliert oder verschoben wird: dieses Programm zeigt sie, wie sie im Register steht"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_as_people_type_them() {
        for (typed, commas, read) in [
            ("0,5", true, Some("0.5")),
            ("1.234,5 Hz", true, Some("1234.5")),
            ("1.234", true, Some("1234")),
            ("1.234", false, Some("1.234")),
            ("0.125", true, Some("0.125")),
            ("1,500", false, Some("1500")),
            ("1,500", true, Some("1.500")),
            ("0,125", false, Some("0.125")),
            ("1,234.5", false, Some("1234.5")),
            ("−3 000", true, Some("-3000")),
            ("0x1F", false, Some("31")),
            ("007", false, Some("7")),
            ("12 A", true, Some("12")),
            ("abc", true, None),
            ("", true, None),
            ("1,2,3", true, None),
            ("3-4", true, None),
        ] {
            assert_eq!(number(typed, commas).as_deref(), read, "{typed}");
        }
        for (cell, has) in [
            ("-12,5", true),
            ("12,5 Hz", true),
            ("0,125", true),
            ("1.000,5", true),
            ("1.000,500", true),
            ("1,234", false),
            ("1,234.5", false),
            ("1.234", false),
            ("a,b", false),
            ("1,2,3", false),
        ] {
            assert_eq!(has_decimal(cell, ','), has, "{cell}");
            let swapped: String = cell
                .chars()
                .map(|c| {
                    if c == ',' {
                        '.'
                    } else if c == '.' {
                        ','
                    } else {
                        c
                    }
                })
                .collect();
            assert_eq!(has_decimal(&swapped, '.'), has, "{swapped}");
        }
        for (cell, open) in [
            ("1.000", true),
            ("-12,500 Hz", true),
            ("0.125", false),
            ("1.5", false),
            ("1.000.000", false),
            ("1.000,5", false),
            ("1000", false),
            ("a.bcd", false),
        ] {
            assert_eq!(is_open(cell), open, "{cell}");
        }
    }

    #[test]
    fn numbers_of_parameters() {
        let told = ["370", "P.370", "p370", "Pr. 370", "0x172", "172h", "Parameter 370"].map(id);
        assert_eq!(told, [Some(370); 7]);
        assert_eq!(["", "P", "3.7", "-3", "x", "99999999999", "Motor"].map(id), [None; 7]);
    }

    #[test]
    fn ranges_scales_and_values() {
        let both = |low: &str, high: &str| Some((low.to_owned(), high.to_owned()));
        assert_eq!(range("0,00 … 999,99 Hz", true), both("0.00", "999.99"));
        assert_eq!(range("-100 bis 100", true), both("-100", "100"));
        assert_eq!(range("0-5", true), both("0", "5"));
        assert_eq!(range("-10...-5", true), both("-10", "-5"));
        assert_eq!(range("frei", true), None);
        let told = ["1", "0.1", "0.010", "0.001", "10", "0.5", "1.0"].map(decimals);
        assert_eq!(told, [Some(0), Some(1), Some(2), Some(3), None, None, Some(0)]);
        let two = vec![(0, "Aus".to_owned()), (1, "Ein, lang".to_owned())];
        assert_eq!(values("0=Aus | 1=Ein, lang"), two);
        assert_eq!(values("anything"), []);
    }
}
