//! Exact values: an integer and a count of decimals. No float anywhere but where a register holds one (`float`).

use super::float;
use super::param::{Param, Type};
use super::time;
use crate::text::{Text, both};

/// Why a text is not a value of a parameter.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ValueError {
    /// No number, and no text of the parameter's table either.
    #[error("{}", self.text().en)]
    NotANumber {
        /// What came.
        text: String,
        /// Texts that would be right.
        choices: Vec<Text>,
    },
    /// The unit is another one than the parameter's.
    #[error("{}", self.text().en)]
    Unit {
        /// What came.
        got: String,
        /// The parameter's unit.
        expected: Option<String>,
    },
    /// Nobody knows how many decimals the parameter has.
    #[error("{}", self.text().en)]
    NoScale {
        /// Unit of the parameter.
        unit: String,
    },
    /// More decimals than the parameter has.
    #[error("{}", self.text().en)]
    Decimals {
        /// What came.
        text: String,
        /// The least step of the parameter, in its unit.
        step: String,
        /// The nearest values that it takes, below and above.
        near: [String; 2],
    },
    /// A point or comma before three digits, which some write between thousands.
    #[error("{}", self.text().en)]
    Thousands {
        /// What came.
        text: String,
        /// The number if it is a decimal point.
        fraction: String,
        /// The number if it parts thousands.
        whole: String,
    },
    /// The lower number of a ratio is 0.
    #[error("{}", self.text().en)]
    Denominator {
        /// What came.
        text: String,
    },
    /// Out of the printed range.
    #[error("{}", self.text().en)]
    Range {
        /// What came.
        value: String,
        /// Lower limit.
        min: String,
        /// Upper limit.
        max: String,
    },
    /// Larger than what any type holds.
    #[error("{}", self.text().en)]
    TooLarge {
        /// What came.
        value: String,
    },
    /// Does not fit into the width of the type.
    #[error("{}", self.text().en)]
    Width {
        /// What came.
        value: String,
        /// The type.
        kind: &'static str,
    },
}

impl ValueError {
    /// In words for people.
    pub fn text(&self) -> Text {
        match self {
            ValueError::NotANumber { text, choices } if choices.len() < 2 => {
                both!("'{text}' is no number{known}", "'{text}' ist keine Zahl{known}", known = list(choices))
            }
            ValueError::NotANumber { text, choices } => both!(
                "'{text}' is neither a number nor one of the values of this parameter{known}",
                "'{text}' ist weder eine Zahl noch einer der Werte dieses Parameters{known}",
                known = list(choices)
            ),
            ValueError::Unit { got, expected: Some(unit) } => both!(
                "the unit '{got}' does not fit: this parameter is in {unit}",
                "die Einheit '{got}' passt nicht: dieser Parameter ist in {unit}"
            ),
            ValueError::Unit { got, expected: None } => both!(
                "the unit '{got}' does not fit: the unit of this parameter is unknown; without one the number is what \
                 the drive keeps, and a catalogue of one's own can tell the unit (`params import`, --catalogue)",
                "die Einheit '{got}' passt nicht: die Einheit dieses Parameters ist unbekannt; ohne sie ist die Zahl, \
                 was der Antrieb speichert, und ein eigener Katalog kann sie nennen (`params import`, --catalogue)"
            ),
            ValueError::NoScale { unit } => both!(
                "no source tells the decimals of this parameter in {unit}",
                "keine Quelle nennt die Nachkommastellen dieses Parameters in {unit}"
            ),
            ValueError::Decimals { text, step, near: [below, above] } => both!(
                "'{text}' has more decimals than this parameter: its step is {step}, so it takes {below} or {above}",
                "'{text}' hat mehr Nachkommastellen als dieser Parameter: seine Schrittweite ist {step}, er nimmt also {below} oder \
                 {above}"
            ),
            ValueError::Thousands { text, fraction, whole } => both!(
                "'{text}' may mean {fraction} or {whole}: write it without a separator of thousands, and without zeros at its end",
                "'{text}' kann {fraction} oder {whole} heißen: ohne Tausendertrennzeichen und ohne Nullen am Ende schreiben"
            ),
            ValueError::Denominator { text } => both!(
                "'{text}': the lower number of a ratio is never 0",
                "'{text}': der Nenner eines Verhältnisses ist nie 0"
            ),
            ValueError::Range { value, min, max } => {
                both!("{value} is out of the range {min} … {max}", "{value} liegt außerhalb des Bereichs {min} … {max}")
            }
            ValueError::TooLarge { value } => {
                both!("{value} is more than any parameter holds", "{value} ist mehr, als irgendein Parameter fasst")
            }
            ValueError::Width { value, kind } => {
                both!("{value} does not fit into a {kind}", "{value} passt nicht in den Typ {kind}")
            }
        }
    }
}

fn list(choices: &[Text]) -> Text {
    match choices.is_empty() {
        true => Text::default(),
        false => both!(" (expected: {choices})", " (erwartet: {choices})", choices = Text::join(choices, ", ")),
    }
}

/// Units that are the same or differ by a power of ten: as typed, as in the catalogue, power.
const UNITS: &[(&str, &str, i32)] = &[
    ("rpm", "1/min", 0),
    ("min-1", "1/min", 0),
    ("u/min", "1/min", 0),
    ("deg", "°", 0),
    ("w", "kW", -3),
    ("mw", "kW", -6),
    ("ma", "A", -3),
    ("mv", "V", -3),
    ("kv", "V", 3),
    ("ms", "s", -3),
    ("s", "ms", 3),
    ("khz", "Hz", 3),
];

/// `raw` with its decimal point: `-12000` with two decimals is `-120.00`.
pub fn format_decimal(raw: i64, decimals: u8) -> String {
    let places = usize::from(decimals);
    let digits = format!("{:0width$}", raw.unsigned_abs(), width = places + 1);
    let (whole, fraction) = digits.split_at(digits.len() - places);
    let sign = if raw < 0 { "-" } else { "" };
    if places == 0 { format!("{sign}{whole}") } else { format!("{sign}{whole}.{fraction}") }
}

/// The value of a raw integer: its digits, and how many stand behind the point. `None`: a floating point that is no number, or
/// none that can be written out.
pub fn digits(param: &Param, raw: i64) -> Option<(i64, u8)> {
    match param.kind {
        Some(Type::Float) => float::decimal(u32::try_from(raw).ok()?),
        Some(Type::Time) => time::decimal(raw),
        _ => Some((raw, param.decimals_or_zero())),
    }
}

/// What a floating point is that no digits are written for.
pub fn odd(param: &Param, raw: i64) -> Option<Text> {
    digits(param, raw).is_none().then(|| u32::try_from(raw).map_or_else(|_| Text::name(raw), float::odd))
}

/// A raw integer as its value is written, without unit.
pub fn written(param: &Param, raw: i64) -> String {
    match digits(param, raw) {
        Some((digits, decimals)) => format_decimal(digits, decimals),
        None => format!("0x{raw:08X}"),
    }
}

/// Reads `text` as a decimal number with at most `decimals` places; accepts point or comma.
///
/// Returns the raw integer. Trailing zeros beyond the places are accepted, other digits are not.
pub fn parse_decimal(text: &str, decimals: u8) -> Result<i64, ValueError> {
    shifted(text, decimals, 0)
}

/// Like [`parse_decimal`], with the number multiplied by `10^power` first.
fn shifted(text: &str, decimals: u8, power: i32) -> Result<i64, ValueError> {
    let no_number = || ValueError::NotANumber { text: text.to_owned(), choices: Vec::new() };
    // It is a number, but no drive has one so large.
    let too_large = || ValueError::TooLarge { value: text.to_owned() };
    let (negative, digits) = match text.strip_prefix(['-', '−']) {
        Some(rest) => (true, rest),
        None => (false, text.strip_prefix('+').unwrap_or(text)),
    };
    let (whole, fraction) = digits.split_once(['.', ',']).unwrap_or((digits, ""));
    if (whole.is_empty() && fraction.is_empty()) || !(whole.chars().chain(fraction.chars())).all(|c| c.is_ascii_digit())
    {
        return Err(no_number());
    }
    let places = i32::from(decimals) + power;
    let exponent = places - i32::try_from(fraction.len()).map_err(|_| no_number())?;
    let digits = format!("{whole}{fraction}");
    let digits = digits.trim_start_matches('0');
    let too_fine = |kept: &str| {
        let less: i64 = kept.parse().unwrap_or(0);
        let near = if negative { [-less - 1, -less] } else { [less, less.saturating_add(1)] };
        let shown = |raw: i64| format_decimal(raw, decimals);
        ValueError::Decimals { text: text.to_owned(), step: shown(1), near: near.map(shown) }
    };
    let scaled = match usize::try_from(exponent) {
        Ok(zeros) if digits.is_empty() => "0".repeat(zeros.min(1)),
        Ok(zeros) if zeros > 20 => return Err(no_number()),
        Ok(zeros) => format!("{digits}{}", "0".repeat(zeros)),
        Err(_) => {
            let cut = exponent.unsigned_abs() as usize;
            let keep = digits.len().saturating_sub(cut);
            let (kept, dropped) = digits.split_at(keep);
            if dropped.contains(|c| c != '0') {
                return Err(too_fine(kept));
            }
            kept.to_owned()
        }
    };
    let magnitude: i64 = if scaled.is_empty() { 0 } else { scaled.parse().map_err(|_| too_large())? };
    Ok(if negative { -magnitude } else { magnitude })
}

/// A number as somebody types it: `1.450` is refused where the parameter has no third decimal, because it is one thousand to some.
pub(super) fn typed(text: &str, decimals: u8, power: i32) -> Result<i64, ValueError> {
    let raw = shifted(text, decimals, power)?;
    let (whole, places) = text.trim_start_matches(['-', '−', '+']).split_once(['.', ',']).unwrap_or((text, ""));
    let parts_thousands = places.len() == 3 && (1..=3).contains(&whole.len()) && !whole.starts_with('0');
    if parts_thousands && i32::from(decimals) + power < 3 {
        let fraction = format!("{whole}.{places}").trim_end_matches('0').trim_end_matches('.').to_owned();
        return Err(ValueError::Thousands { text: text.to_owned(), fraction, whole: format!("{whole}{places}") });
    }
    Ok(raw)
}

/// Splits `10,3 A` into number and unit.
pub(super) fn split_unit(text: &str) -> (&str, &str) {
    let text = text.trim();
    let end =
        text.find(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '+' | '−'))).unwrap_or(text.len());
    let (number, unit) = text.split_at(end);
    (number.trim(), unit.trim())
}

/// Whether a typed value carries this unit, or one that converts to it.
pub(super) fn carries_unit(text: &str, unit: Option<&str>) -> bool {
    unit_power(split_unit(text).1, unit).is_some()
}

/// Power of ten between a typed unit and the parameter's; `None` if they do not fit.
fn unit_power(typed: &str, unit: Option<&str>) -> Option<i32> {
    let unit = unit?;
    // Small and capital letters are the same, but for the prefix: MW is no mW.
    let is_mega = typed.starts_with('M') && !typed.eq_ignore_ascii_case("min");
    let is = |name: &str| name.eq_ignore_ascii_case(typed) && !(is_mega && name.starts_with('m'));
    if is(unit) {
        return Some(0);
    }
    UNITS.iter().find(|row| is(row.0) && row.1 == unit).map(|row| row.2)
}

/// Reads a typed value for a parameter: number with or without unit, `0x…`, or a text of its table (`choices`).
///
/// Checks unit and decimals; [`check_range`] and [`check_width`] come after, because they can be forced.
pub fn parse(text: &str, param: &Param, choices: &[(i64, [&str; 2])]) -> Result<i64, ValueError> {
    let text = text.trim();
    if let Some(hex) = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")) {
        // `from_str_radix` takes a sign; a raw pattern of bits has none.
        let digits = Some(hex).filter(|hex| hex.chars().all(|c| c.is_ascii_hexdigit()));
        let raw = digits.and_then(|hex| i64::from_str_radix(hex, 16).ok());
        return raw.ok_or_else(|| ValueError::NotANumber { text: text.to_owned(), choices: Vec::new() });
    }
    let by_text = || choice(text, choices);
    let (number, unit) = split_unit(text);
    if number.is_empty() {
        return by_text()
            .ok_or_else(|| ValueError::NotANumber { text: text.to_owned(), choices: may_be(param, choices) });
    }
    let power = match unit {
        "" => 0,
        typed => match unit_power(typed, param.unit.as_deref()) {
            Some(power) => power,
            None => {
                let mismatch = ValueError::Unit { got: typed.to_owned(), expected: param.unit.clone() };
                return by_text().ok_or(mismatch);
            }
        },
    };
    // `10=19200` means the value that is called "19200 Bd", not the raw value 19200, which P.10 does not take. A number that the
    // parameter may take is one: tables do not name all of them.
    if let Ok(raw) = shifted(number, 0, 0)
        && !choices.is_empty()
        && !choices.iter().any(|choice| choice.0 == raw)
        && !may_be_raw(raw, param, choices)
        && let Some(named) = by_text()
    {
        return Ok(named);
    }
    if param.kind == Some(Type::Float) {
        let no_number = || ValueError::NotANumber { text: text.to_owned(), choices: Vec::new() };
        return float::bits(number, power).map(i64::from).ok_or_else(no_number);
    }
    if param.kind == Some(Type::Time) {
        let hundredths = typed(number, 2, power)?;
        let outside = || ValueError::Range {
            value: format_decimal(hundredths, 2),
            min: "0.01 … 99.99, 100.0".to_owned(),
            max: "3000.0".to_owned(),
        };
        return time::raw(hundredths).ok_or_else(outside);
    }
    if let (false, Some(unit)) = (param.has_scale(), &param.unit) {
        return Err(ValueError::NoScale { unit: unit.clone() });
    }
    typed(number, param.decimals_or_zero(), power).map_err(|error| match (error, &param.unit) {
        (ValueError::Decimals { step, near, .. }, Some(unit)) => {
            let with_unit = |value: String| format!("{value} {unit}");
            ValueError::Decimals { text: text.to_owned(), step: with_unit(step), near: near.map(with_unit) }
        }
        (error, _) => error,
    })
}

/// What a parameter may be: the values of its table, as many as can be read at once, or its range.
fn may_be(param: &Param, choices: &[(i64, [&str; 2])]) -> Vec<Text> {
    let named = |(raw, [en, de]): &(i64, [&str; 2])| Text::by(|lang| format!("{raw} = {}", lang.pick(en, de)));
    let more = (choices.len() > MOST_NAMED)
        .then(|| both!("… (`antrieb params {id}` lists all)", "… (`antrieb params {id}` zeigt alle)", id = param.id));
    let shown = |raw: i64| written(param, raw);
    let range = param.min.zip(param.max).filter(|_| choices.is_empty());
    let range = range.map(|(min, max)| Text::name(format!("{} … {}", shown(min), shown(max))));
    choices.iter().take(MOST_NAMED).map(named).chain(more).chain(range).collect()
}

/// So many values of a table are named.
const MOST_NAMED: usize = 8;

/// Whether a parameter may take a value that its table does not name: within its range, or, if no source tells that, up to the
/// largest of the table.
fn may_be_raw(raw: i64, param: &Param, choices: &[(i64, [&str; 2])]) -> bool {
    match param.min.or(param.max) {
        Some(_) => check_range(raw, param).is_ok(),
        None => choices.iter().any(|choice| raw <= choice.0),
    }
}

/// The raw value whose text it is; or the only one whose text starts with it or has it as a word.
fn choice(text: &str, choices: &[(i64, [&str; 2])]) -> Option<i64> {
    let exact = choices.iter().find(|(_, names)| names.iter().any(|name| super::names::same(name, text)));
    if let Some((raw, _)) = exact {
        return Some(*raw);
    }
    let only = |fits: &dyn Fn(&str) -> bool| {
        let mut fitting = choices.iter().filter(|(_, names)| names.iter().any(|name| fits(name)));
        let first = fitting.next()?;
        fitting.next().is_none().then_some(first.0)
    };
    let query = super::names::fold(text);
    let has_word = |name: &str| super::names::fold(name).split(' ').any(|word| word == query);
    only(&|name| super::names::starts(name, text)).or_else(|| only(&has_word))
}

/// Holds a raw value against the printed range of the parameter: [`ValueError::Range`] beyond it, nothing where none is printed.
pub fn check_range(raw: i64, param: &Param) -> Result<(), ValueError> {
    let decimals = param.decimals_or_zero();
    let shown = |limit: Option<i64>| limit.map_or_else(|| "…".to_owned(), |raw| format_decimal(raw, decimals));
    if param.min.is_some_and(|min| raw < min) || param.max.is_some_and(|max| raw > max) {
        return Err(ValueError::Range {
            value: format_decimal(raw, decimals),
            min: shown(param.min),
            max: shown(param.max),
        });
    }
    Ok(())
}

/// Holds a raw value against the width of a type: [`ValueError::Width`] where it has no room for it. `decimals` is for the message.
pub fn check_width(raw: i64, kind: Type, decimals: u8) -> Result<(), ValueError> {
    let (min, max) = kind.raw_range();
    if raw < min || raw > max {
        return Err(ValueError::Width { value: format_decimal(raw, decimals), kind: kind.name() });
    }
    Ok(())
}

/// Holds a raw value against its type, sign included: a word is read back with a sign only where the range has one.
pub fn check_type(raw: i64, kind: Type, param: &Param) -> Result<(), ValueError> {
    let decimals = param.decimals_or_zero();
    check_width(raw, kind, decimals)?;
    match kind == Type::Word && from_wire(raw as u32, kind, param.min) != raw {
        true => Err(ValueError::Width { value: format_decimal(raw, decimals), kind: kind.name() }),
        false => Ok(()),
    }
}

/// The raw integer that bits on the wire stand for.
pub fn from_wire(bits: u32, kind: Type, min: Option<i64>) -> i64 {
    match kind {
        Type::Byte | Type::Uint | Type::String => i64::from(bits & 0xFFFF),
        Type::Int | Type::Time => i64::from(bits as u16 as i16),
        Type::Word if min.is_some_and(|min| min < 0) => i64::from(bits as u16 as i16),
        Type::Word => i64::from(bits & 0xFFFF),
        // What is never below 0 has no sign.
        Type::Long if min.is_some_and(|min| min >= 0) => i64::from(bits),
        Type::Long => i64::from(bits as i32),
        Type::Float => i64::from(bits),
    }
}

/// The bits on the wire for a raw integer: two's complement in the width of the type; of 16 bits the upper half is 0. A raw value that the
/// type has no room for is [`ValueError::Width`].
pub fn to_wire(raw: i64, kind: Type) -> Result<u32, ValueError> {
    check_width(raw, kind, 0)?;
    Ok(match kind {
        Type::Long => raw as i32 as u32,
        Type::Float => raw as u32,
        _ => raw as u32 & 0xFFFF,
    })
}

/// A value on the wire as people write it: `1.5 kW`.
pub fn format_value(param: &Param, bits: u32, long: bool) -> String {
    let (width, usual) = if long { (32, Type::Long) } else { (16, Type::Word) };
    let kind = param.kind.filter(|kind| kind.bits() == Some(width)).unwrap_or(usual);
    value_text(param, from_wire(bits, kind, param.min))
}

/// A value of a parameter with its unit: `1450 1/min`, or `raw 1234` where no source tells where its point stands.
pub fn value_text(param: &Param, raw: i64) -> String {
    match &param.unit {
        Some(_) if !param.has_scale() => format!("raw {raw}"),
        Some(unit) => format!("{} {unit}", written(param, raw)),
        None => written(param, raw),
    }
}

#[cfg(test)]
mod tests;
