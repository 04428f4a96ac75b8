//! Numbers of 32 bits with a floating point (IEEE 754), as some registers hold them: between their bits and decimals, exactly.

use crate::text::{Text, both};

/// Digits behind the point that are written out; what is smaller is no value of a drive.
const MOST_DECIMALS: usize = 18;

/// The shortest decimal that stands for these bits and no others, without its point, and the places behind it. `None`: no
/// number, an infinite one, or one that is written with more digits than anybody reads.
pub(super) fn decimal(bits: u32) -> Option<(i64, u8)> {
    let number = f32::from_bits(bits);
    let text = number.is_finite().then(|| number.to_string())?;
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, ""));
    let places = Some(fraction.len()).filter(|places| *places <= MOST_DECIMALS)?;
    let raw = format!("{whole}{fraction}").parse().ok()?;
    Some((raw, u8::try_from(places).ok()?))
}

/// What bits are that no decimal is written for.
pub(super) fn odd(bits: u32) -> Text {
    let number = f32::from_bits(bits);
    match number {
        _ if number.is_nan() => both!("no number", "keine Zahl"),
        _ if number.is_infinite() => both!("infinite", "unendlich"),
        _ => Text::name(format!("{number:e}")),
    }
}

/// The bits of what is nearest to a decimal times a power of ten; `None`: no number, or one that is too large.
pub(super) fn bits(decimal: &str, power: i32) -> Option<u32> {
    let plain = decimal.replace(',', ".").replace('−', "-");
    let is_decimal = |letter: char| letter.is_ascii_digit() || matches!(letter, '.' | '-' | '+');
    let number = plain.chars().all(is_decimal).then(|| format!("{plain}e{power}").parse::<f32>().ok())?;
    number.filter(|number| number.is_finite()).map(f32::to_bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_float_is_the_shortest_decimal_that_means_it() {
        for (number, shown) in
            [(230.4_f32, (2304, 1)), (-0.1, (-1, 1)), (0.0, (0, 0)), (1e7, (10_000_000, 0)), (50.02, (5002, 2))]
        {
            assert_eq!(decimal(number.to_bits()), Some(shown), "{number}");
        }
        for nothing in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e30, 1e-30] {
            assert_eq!(decimal(nothing.to_bits()), None, "{nothing}");
        }
    }

    #[test]
    fn what_is_typed_is_the_nearest_float() {
        assert_eq!(bits("230,4", 0), Some(230.4_f32.to_bits()));
        assert_eq!(bits("-1.5", -3), Some((-0.0015_f32).to_bits()));
        for wrong in ["", "1e5", "nan", "inf", "1.2.3"] {
            assert_eq!(bits(wrong, 0), None, "{wrong}");
        }
        assert_eq!(bits("9", 60), None, "too large");
    }
}
