//! The mixed code of the ramps of a Hitachi inverter (SJ2-PB manual 5.5, index 7): -1 to -9999 are 0.01 to 99.99 s, 1000 to
//! 30000 are 100.0 to 3000.0 s.

/// Least and largest raw value; what lies between -1 and 1000 is none.
pub(super) const RAW: (i64, i64) = (-9_999, 30_000);

/// The digits of the value, and how many stand behind the point; `None` for what is no value.
pub(super) fn decimal(raw: i64) -> Option<(i64, u8)> {
    match raw {
        -9_999..=-1 => Some((-raw, 2)),
        1_000..=30_000 => Some((raw, 1)),
        _ => None,
    }
}

/// The raw value of so many hundredths of a second.
pub(super) fn raw(hundredths: i64) -> Option<i64> {
    match hundredths {
        1..=9_999 => Some(-hundredths),
        10_000..=300_000 if hundredths % 10 == 0 => Some(hundredths / 10),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_of_both_halves_are_those_of_the_manual() {
        let ends = [(-1, (1, 2)), (-9_999, (9_999, 2)), (1_000, (1_000, 1)), (30_000, (30_000, 1))];
        assert!(ends.iter().all(|end| decimal(end.0) == Some(end.1)));
        assert!([0, 1, 999, 30_001, -10_000].iter().all(|raw| decimal(*raw).is_none()));
        assert!([0, -1, 10_001, 300_010].iter().all(|hundredths| raw(*hundredths).is_none()));
    }

    #[test]
    fn every_value_comes_back() {
        for hundredths in 1..=300_010 {
            let Some(raw) = raw(hundredths) else { continue };
            let (digits, decimals) = decimal(raw).unwrap();
            assert_eq!(digits * if decimals == 2 { 1 } else { 10 }, hundredths);
        }
    }
}
