//! What the bench knows of a parameter: the row of the catalogue, and a choice wherever no source says anything.
//!
//! The choices are those of this bench. They claim nothing about real drives:
//! a parameter of unknown type has 32 bits if its unit is Hz or its range needs them, else 16; a parameter of which
//! nobody says that it exists in four data sets exists once; an unknown factory setting comes from
//! [`BENCH_VALUES`], or is 0.

use crate::profile::{Access, Family, Param, Sets, Type};
use std::collections::BTreeMap;

/// A parameter as a drive of the bench has it.
#[derive(Clone, Debug)]
pub(crate) struct Spec {
    pub(crate) kind: Type,
    pub(crate) access: Access,
    /// Exists in the data sets 1-4.
    pub(crate) four: bool,
    pub(crate) volatile: bool,
    pub(crate) min: Option<i64>,
    pub(crate) max: Option<i64>,
    pub(crate) factory: i64,
    /// Not writable while the drive runs.
    pub(crate) locked: bool,
}

/// The parameters of a drive with these option modules.
pub(crate) fn specs(family: &Family, modules: &[String]) -> BTreeMap<u32, Spec> {
    let fitted = |param: &&Param| param.module.as_ref().is_none_or(|module| modules.contains(module));
    family.params.values().filter(fitted).map(|param| (param.id, Spec::new(param))).collect()
}

impl Spec {
    fn new(param: &Param) -> Self {
        let kind = param.kind.unwrap_or_else(|| guessed_type(param));
        let learned = LEARNED_MINIMA.iter().find(|row| row.0 == param.id).map(|row| row.1);
        let (min, max) = (param.min.or(learned), param.max);
        let bench = BENCH_VALUES.iter().find(|row| row.0 == param.id).map(|row| row.1);
        let zero = 0.max(min.unwrap_or(0)).min(max.unwrap_or(i64::MAX));
        Spec {
            kind,
            access: param.access,
            four: param.sets == Some(Sets::Four),
            volatile: param.volatile,
            min,
            max,
            factory: param.default.or(bench).unwrap_or(zero),
            locked: LOCKED_WHILE_RUNNING.contains(&param.id),
        }
    }

    /// Whether a written value is one that the drive takes.
    pub(crate) fn takes(&self, value: i64) -> bool {
        let (low, high) = self.kind.raw_range();
        (self.min.unwrap_or(low).max(low)..=self.max.unwrap_or(high).min(high)).contains(&value)
    }
}

fn guessed_type(param: &Param) -> Type {
    let wide = |limit: Option<i64>| limit.is_some_and(|limit| !(-0x8000..=0xFFFF).contains(&limit));
    let long = param.unit.as_deref() == Some("Hz") || wide(param.min) || wide(param.max);
    if long { Type::Long } else { Type::Word }
}

/// Limits that no table prints but that worked telegrams show (CM-485 manual 8.1.2 and 8.1.4): 376 refuses 0,
/// 375 refuses 9.00 Hz and takes 10.00 Hz. Where between the two the limit of 375 lies is unknown.
const LEARNED_MINIMA: &[(u32, i64)] = &[(375, 901), (376, 1)];

/// Parameters marked with a boxed cross in CM-485 manual 11.2, as far as it can mean "not writable while running":
/// 484 and 524 carry one too, but they are the setpoints of a running drive.
const LOCKED_WHILE_RUNNING: &[u32] = &[34];

/// Raw values of the bench for factory settings that no source tells.
const BENCH_VALUES: &[(u32, i64)] = &[
    (30, 110),    // a V/f configuration, named in CM-485 manual 9.1.2.2
    (68, 71),     // S2IND, CM-485 manual 9.1.3
    (69, 72),     // S3IND, sources B
    (372, 1_390), // CM-485 manual 8.1.1
    (373, 2),     // fits 1390 1/min at 50 Hz
    (375, 5_000),
    (376, 8),   // a 1390 1/min motor has 0.8 kW or so; the 1.5 kW of CM-485 manual 8.1.2 is written
    (412, 44),  // ACT; printed for ACU, CM-485 manual 10
    (418, 350), // for configurations 1xx, sources B
    (424, 1_000),
    (425, 1_000),
    (481, 1_000), // CM-485 manual 8.1.3
    (482, 2_500),
    (483, 5_000),
    (485, 500),
    (486, 1_000),
    (487, 2_500),
    (488, 5_000),
    (549, 500), // example of 5 %, sources B
    (632, 100),
    (637, 10),
    (638, 10),
    (903, 6),
    (978, 2),
    (979, 1),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unknown_types_are_guessed_by_unit_and_range() {
        let param = |unit: &str, max| Param { unit: Some(unit.to_owned()), max, ..Param::unknown(1) };
        assert_eq!(Spec::new(&param("Hz", None)).kind, Type::Long);
        assert_eq!(Spec::new(&param("%", Some(30_000))).kind, Type::Word);
        assert_eq!(Spec::new(&param("Hz/s", Some(999_999))).kind, Type::Long);
    }

    #[test]
    fn worked_telegrams_teach_limits() {
        let power = Spec::new(&Param::unknown(376));
        assert!(!power.takes(0) && power.takes(15));
        let frequency = Spec::new(&Param { kind: Some(Type::Long), ..Param::unknown(375) });
        assert!(!frequency.takes(900) && frequency.takes(1_000));
    }
}
