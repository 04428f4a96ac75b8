//! Triggers as they are typed: `current > 12A`, `frequency rising 10Hz`, `status-word:fault rising`, `state -> fault`.

use crate::command::check_number;
use crate::command::read::select_failure;
use crate::drive::{Compare, Condition, Item, Signal, Test};
use crate::failure::{Class, Failure};
use crate::profile::value::{ValueError, parse};
use crate::profile::{DataSets, Family, Param, Selection, Selector};
use crate::text::{Text, both};

/// What stands between a name and its level, the longer ones first.
const COMPARISONS: [(&str, Compare); 7] = [
    (">=", Compare::AtLeast),
    ("<=", Compare::AtMost),
    ("!=", Compare::Other),
    ("==", Compare::Equal),
    (">", Compare::Above),
    ("<", Compare::Below),
    ("=", Compare::Equal),
];
const BECOMES: &str = "->";
const STATE: &str = "state";
const RISING: &str = "rising";
const FALLING: &str = "falling";

/// Short names of what most drives have, by role.
const SHORT: [(&str, &[&str]); 8] = [
    ("state", &["status-word"]),
    ("setpoint", super::SETPOINT),
    ("actual", super::ACTUAL),
    ("frequency", super::ACTUAL),
    ("current", &["current"]),
    ("voltage", &["dc-link-voltage"]),
    ("fault", &["fault"]),
    ("warnings", &["warnings"]),
];

/// Whether a text is a trigger and not the name of one.
pub(super) fn is_condition(text: &str) -> bool {
    text.contains(['>', '<', '=', ' '])
}

/// What a trigger means in a family.
///
/// # Errors
/// It is none, or names what this family has not.
pub(super) fn condition(text: &str, family: &Family) -> Result<Condition, Failure> {
    let (name, test, level) = parts(text).ok_or_else(|| shapeless(text))?;
    let text = text.trim().to_owned();
    let Some(test) = test else {
        if name != STATE {
            return Err(shapeless(&text));
        }
        return Ok(Condition { text, signal: Signal::State, test: Test::Becomes(state(level, family)?) });
    };
    if name.eq_ignore_ascii_case(STATE) {
        return Err(shapeless(&text));
    }
    let (name, bit) = name.split_once(':').map_or((name, None), |(name, bit)| (name, Some(bit)));
    let item = item(name.trim(), family)?;
    let bit = bit.map(|bit| bit_of(bit.trim(), item.param(), family)).transpose()?;
    let level = match (bit, level) {
        // A bit rises from 0 to 1.
        (Some(_), "") => i64::from(matches!(test, Kind::Rising)),
        (Some(_), digit) => match (test, digit) {
            (Kind::Is(_), "0" | "1") => i64::from(digit == "1"),
            _ => return Err(shapeless(&text)),
        },
        (None, level) => self::level(level, item.param(), family)?,
    };
    let test = match test {
        Kind::Is(compare) => Test::Is(compare, level),
        Kind::Rising => Test::Rises(level),
        Kind::Falling => Test::Falls(level),
    };
    Ok(Condition { text, signal: Signal::Value(Box::new(item), bit), test })
}

/// How a value is held against its level.
#[derive(Clone, Copy)]
enum Kind {
    Is(Compare),
    Rising,
    Falling,
}

/// Name, kind and level; no kind for a state that is reached.
fn parts(text: &str) -> Option<(&str, Option<Kind>, &str)> {
    let text = text.trim();
    if let Some((name, state)) = text.split_once(BECOMES) {
        return Some((name.trim(), None, state.trim()))
            .filter(|(name, _, state)| !name.is_empty() && !state.is_empty());
    }
    for (word, kind) in [(RISING, Kind::Rising), (FALLING, Kind::Falling)] {
        let at = text.match_indices(word).map(|(at, _)| text.split_at(at));
        let whole = at.map(|(name, rest)| (name, rest.strip_prefix(word).unwrap_or_default()));
        let is_word = |(name, rest): &(&str, &str)| name.ends_with(' ') && (rest.is_empty() || rest.starts_with(' '));
        if let Some((name, level)) = whole.into_iter().find(is_word) {
            return Some((name.trim(), Some(kind), level.trim())).filter(|(name, ..)| !name.is_empty());
        }
    }
    let at = text.find(['>', '<', '=', '!'])?;
    let (name, rest) = text.split_at(at);
    let (sign, compare) = COMPARISONS.into_iter().find(|(sign, _)| rest.starts_with(sign))?;
    let level = rest.strip_prefix(sign)?.trim();
    (!name.trim().is_empty() && !level.is_empty()).then_some((name.trim(), Some(Kind::Is(compare)), level))
}

/// The parameter that a short name means; `None` if it is none.
pub(super) fn short(name: &str, family: &Family) -> Option<Result<Item, Failure>> {
    let (short, roles) = SHORT.into_iter().find(|row| row.0.eq_ignore_ascii_case(name))?;
    let param = super::one_of(roles, family).ok_or_else(|| lacks(short, family));
    let selection = |param| Selection { param, sets: DataSets::Unnamed, of_group: false, lenient: false };
    Some(param.map(|param| Item::new(selection(param))))
}

/// The parameter that is meant: by a short name, or as for `read`.
fn item(name: &str, family: &Family) -> Result<Item, Failure> {
    if let Some(item) = short(name, family) {
        return item;
    }
    let selector: Selector = name.parse().map_err(|error| select_failure(&error))?;
    let selections = selector.resolve(family).map_err(|error| select_failure(&error))?;
    let [only]: [Selection; 1] = selections.try_into().map_err(|_| {
        let message = both!(
            "a trigger looks at one parameter, '{name}' means several",
            "ein Auslöser sieht auf einen Parameter, '{name}' meint mehrere"
        );
        Failure::new(Class::Usage, "usage.trigger", message).hint(both!(
            "a --trigger for each; any of them triggers",
            "für jeden ein --trigger; jeder von ihnen löst aus"
        ))
    })?;
    check_number(family, &only.param)?;
    Ok(Item::new(only))
}

/// A short name never means whatever else begins with it.
fn lacks(short: &str, family: &Family) -> Failure {
    let known: Vec<_> = SHORT.iter().filter(|row| super::one_of(row.1, family).is_some()).map(|row| row.0).collect();
    let (drive, known) = (&family.drive, known.join(", "));
    let message = both!(
        "no source tells which parameter of {drive} is '{short}' (there is: {known})",
        "keine Quelle nennt den Parameter von {drive}, der '{short}' ist (es gibt: {known})"
    );
    Failure::new(Class::Data, "data.unknown_parameter", message).hint(both!(
        "a parameter is named as for `read`, by its number or whole name; --drive names another family, --catalogue brings what you know",
        "ein Parameter wird wie bei `read` genannt, mit Nummer oder ganzem Namen; --drive nennt eine andere Familie, --catalogue bringt \
         mit, was Sie wissen"
    ))
}

/// The raw value of a level; of a fault as the drive displays it too.
fn level(text: &str, param: &Param, family: &Family) -> Result<i64, Failure> {
    let is_fault = family.role("fault").is_some_and(|fault| fault.id == param.id);
    if let Some(code) = family.fault_codes.code(text).filter(|_| is_fault) {
        return Ok(code.into());
    }
    parse(text, param, &family.choices(param)).map_err(|error| {
        let code = match error {
            ValueError::Unit { .. } => "usage.unit",
            // A name that this family does not know may be one of another: of a fault, or what a value stands for.
            _ if text.starts_with(char::is_alphabetic) => "usage.option",
            _ => "usage.trigger",
        };
        let label = param.label();
        Failure::new(
            Class::Usage,
            code,
            both!("trigger on {label}: {why}", "Auslöser auf {label}: {why}", why = error.text()),
        )
    })
}

/// A bit by its name or number.
fn bit_of(text: &str, param: &Param, family: &Family) -> Result<u8, Failure> {
    let named = family.word(param, 0, |_| None);
    let by_name = named.iter().find(|bit| bit.row.is_some_and(|row| row.slug == text)).map(|bit| bit.bit);
    let by_number = || text.parse().ok().filter(|bit| *bit < u32::BITS as u8);
    by_name.or_else(by_number).ok_or_else(|| {
        let known: Vec<_> = named.iter().filter_map(|bit| Some(bit.row?.slug.as_str())).collect();
        let (label, known) = (param.label(), known.join(", "));
        let message = both!(
            "{label} has no bit '{text}' (expected 0 to 31, or one of: {known})",
            "{label} hat kein Bit '{text}' (erwartet: 0 bis 31 oder eines von: {known})"
        );
        Failure::new(Class::Usage, "usage.option", message)
    })
}

/// The stable name of a state.
fn state(text: &str, family: &Family) -> Result<String, Failure> {
    let is = |name: &str| name.eq_ignore_ascii_case(text);
    let found = family.states.iter().find(|state| is(&state.slug) || is(&state.en) || is(&state.de));
    found.map(|state| state.slug.clone()).ok_or_else(|| {
        let known: Vec<_> = family.states.iter().map(|state| state.slug.as_str()).collect();
        let message = both!(
            "there is no state '{text}' (expected one of: {known})",
            "es gibt keinen Zustand '{text}' (erwartet wird einer von: {known})",
            known = known.join(", ")
        );
        Failure::new(Class::Usage, "usage.option", message)
    })
}

fn shapeless(text: &str) -> Failure {
    let message = both!("'{text}' is no trigger", "'{text}' ist kein Auslöser");
    Failure::new(Class::Usage, "usage.trigger", message).hint(shapes())
}

/// What a trigger looks like.
pub(super) fn shapes() -> Text {
    both!(
        "expected 'current > 12A', 'frequency rising 10Hz' or falling, 'status-word:fault rising', 'state -> fault', or the \
         name of one of `[triggers]` in antrieb.toml",
        "erwartet: 'current > 12A', 'frequency rising 10Hz' oder falling, 'status-word:fault rising', 'state -> fault', oder \
         der Name eines der `[triggers]` in antrieb.toml"
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;

    fn of(text: &str) -> Result<Condition, Failure> {
        let registry = Registry::open(&[]).unwrap();
        condition(text, &registry.family("act").unwrap())
    }

    #[test]
    fn a_trigger_is_a_name_a_comparison_and_a_level() {
        let test = |text: &str| of(text).unwrap_or_else(|failure| panic!("{text}: {}", failure.message.en)).test;
        assert_eq!(test("current > 12A"), Test::Is(Compare::Above, 120));
        assert_eq!(test("211>=12,5 A"), Test::Is(Compare::AtLeast, 125));
        assert_eq!(test("frequency rising 10Hz"), Test::Rises(1_000));
        assert_eq!(test("stator-frequency falling -5"), Test::Falls(-500));
        assert_eq!(test("fault != 0"), Test::Is(Compare::Other, 0));
        assert_eq!(test("fault = F0500"), Test::Is(Compare::Equal, 0x0500));
        assert_eq!(test("fault == f1100"), Test::Is(Compare::Equal, 0x1100));
        assert_eq!(test("status-word:fault rising"), Test::Rises(1));
        assert_eq!(test("411:3 = 1"), Test::Is(Compare::Equal, 1));
        assert_eq!(test("state -> fault"), Test::Becomes("fault".to_owned()));
        assert_eq!(test("state->Störung"), Test::Becomes("fault".to_owned()));
        assert!(matches!(of("current > 12A").unwrap().signal, Signal::Value(item, None) if item.param().id == 211));
    }

    #[test]
    fn what_is_none_says_what_is_expected() {
        let code = |text: &str| of(text).unwrap_err().code;
        for text in [
            "current",
            "> 12",
            "current >",
            "current 12",
            "speed -> fault",
            "state ->",
            "current rising",
            "411:3 > x",
            "state = fault",
            "State != fault",
        ] {
            assert_eq!(code(text), "usage.trigger", "{text}");
        }
        assert_eq!(code("current > 12Hz"), "usage.unit");
        assert_eq!(code("state -> asleep"), "usage.option");
        assert_eq!(code("411:nothing rising"), "usage.option");
        assert_eq!(code("frobnicate > 1"), "data.unknown_parameter");
        // P.601 is Voltage Rise: a short name of what the family lacks does not mean it.
        let voltage = of("voltage > 50").unwrap_err();
        assert_eq!(voltage.code, "data.unknown_parameter");
        assert!(
            voltage.message.en.contains("(there is: state, setpoint, actual, frequency, current, fault, warnings)"),
            "{voltage:?}"
        );
        let hint = of("state = fault").unwrap_err().hint.unwrap();
        assert!(hint.en.contains("'state -> fault'"), "{hint:?}");
    }
}
