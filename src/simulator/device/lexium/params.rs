//! Every parameter that the LXM05 manual names, and the values of one drive.
//!
//! The manual prints range and factory setting only of the parameters of the line (4.1). All others are choices of this
//! bench and claim nothing about real drives. An address is that of the first of two registers.

use std::collections::BTreeMap;

/// Signal selection of the position interface.
pub(crate) const POSITION_INTERFACE: u16 = 1_284;
/// Limit of the speed, 1/min.
pub(crate) const SPEED_LIMIT: u16 = 1_554;
/// Acceleration, 1/min in a second.
pub(crate) const ACCELERATION: u16 = 1_556;
/// Deceleration, 1/min in a second.
pub(crate) const DECELERATION: u16 = 1_558;
/// MBbaud.
pub(crate) const BAUD: u16 = 5_638;
/// MBadr.
pub(crate) const ADDRESS: u16 = 5_640;
/// MBformat.
pub(crate) const FORMAT: u16 = 5_642;
/// MBnode_guard, ms.
pub(crate) const NODE_GUARD: u16 = 5_644;
/// MBdword_order.
pub(crate) const WORD_ORDER: u16 = 5_646;
/// DCOMcontrol.
pub(crate) const CONTROL: u16 = 6_914;
/// DCOMstatus.
pub(crate) const STATUS: u16 = 6_916;
/// DCOMopmode.
pub(crate) const MODE: u16 = 6_918;
/// _DCOMopmd_act.
pub(crate) const MODE_ACTIVE: u16 = 6_920;
/// JOGactivate.
pub(crate) const JOG: u16 = 6_930;
/// HMmethod.
pub(crate) const HOMING_METHOD: u16 = 6_936;
/// PVn_target, 1/min.
pub(crate) const VELOCITY: u16 = 6_938;
/// PPp_targetusr, user units.
pub(crate) const TARGET: u16 = 6_940;
/// PPn_target, 1/min.
pub(crate) const TARGET_SPEED: u16 = 6_942;
/// CURreference.
pub(crate) const CURRENT_SOURCE: u16 = 6_944;
/// SPEEDreference.
pub(crate) const SPEED_SOURCE: u16 = 6_946;
/// GEARreference.
pub(crate) const GEAR_SOURCE: u16 = 6_948;
/// _p_act, user units on this bench.
pub(crate) const POSITION: u16 = 7_700;
/// CUR_I_target, 0.01 A.
pub(crate) const CURRENT: u16 = 8_200;
/// SPEEDn_target, 1/min.
pub(crate) const SPEED: u16 = 8_456;
/// GEARdenom.
pub(crate) const GEAR_DENOMINATOR: u16 = 9_734;
/// GEARnum.
pub(crate) const GEAR_NUMERATOR: u16 = 9_736;
/// HMn, 1/min.
pub(crate) const HOMING_SPEED: u16 = 10_248;
/// HMn_out, 1/min.
pub(crate) const HOMING_SPEED_OUT: u16 = 10_250;
/// JOGn_slow, 1/min.
pub(crate) const JOG_SLOW: u16 = 10_504;
/// JOGn_fast, 1/min.
pub(crate) const JOG_FAST: u16 = 10_506;
/// FLT_err_num; class, time and qualifier are its neighbours.
pub(crate) const FAULT_NUMBER: u16 = 15_362;
/// FLT_class.
pub(crate) const FAULT_CLASS: u16 = 15_364;
/// FLT_Time.
pub(crate) const FAULT_TIME: u16 = 15_366;
/// FLT_Qual.
pub(crate) const FAULT_QUALIFIER: u16 = 15_368;

/// What may be done with a parameter, and what becomes of it without power.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Kept without power ("per."): every write is one of the EEPROM.
    Kept,
    /// Written, and back at its factory setting after power-on.
    Lost,
    /// An actual value.
    ReadOnly,
}

/// A parameter.
#[derive(Debug)]
pub(crate) struct Row {
    pub(crate) address: u16,
    /// Short name of the manual.
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    range: Range,
    factory: i32,
    /// Decimals of its unit.
    pub(crate) decimals: u8,
}

impl Row {
    const fn new(address: u16, name: &'static str, kind: Kind, range: Range, factory: i32) -> Self {
        Row { address, name, kind, range, factory, decimals: 0 }
    }

    const fn read_only(address: u16, name: &'static str) -> Self {
        Row::new(address, name, Kind::ReadOnly, ANY, 0)
    }

    /// Whether the drive takes this value.
    pub(crate) fn takes(&self, value: i32) -> bool {
        match self.range {
            Range::From(min, max) => (min..=max).contains(&value),
            Range::OneOf(values) => values.contains(&value),
        }
    }

    /// Whether a bench file may say what it is at power-on: settings, setpoints, and the fault memory.
    pub(crate) fn is_settable(&self) -> bool {
        let commands = [CONTROL, MODE, JOG, CURRENT_SOURCE, SPEED_SOURCE, GEAR_SOURCE];
        self.is_set_by_others() && !commands.contains(&self.address)
    }

    /// Whether somebody else may set it later: the commands as well.
    pub(crate) fn is_set_by_others(&self) -> bool {
        let memory = [FAULT_NUMBER, FAULT_CLASS, FAULT_TIME, FAULT_QUALIFIER];
        self.kind != Kind::ReadOnly || memory.contains(&self.address)
    }
}

/// What a parameter takes.
#[derive(Debug)]
enum Range {
    From(i32, i32),
    OneOf(&'static [i32]),
}

const ANY: Range = Range::From(i32::MIN, i32::MAX);
/// Speeds of a bench motor, 1/min: the worked sequences go up to a limit of 10000.
const SPEEDS: Range = Range::From(0, 13_200);
const BOTH_WAYS: Range = Range::From(-13_200, 13_200);
const RAMPS: Range = Range::From(1, 3_000_000);
const WORD: Range = Range::From(0, 0xFFFF);

/// Baud rates (manual 4.1).
pub(crate) const BAUD_RATES: [i32; 3] = [9_600, 19_200, 38_400];
/// Modes of operation (manual 5.4, 5.5).
const MODES: [i32; 7] = [1, 3, 6, -1, -2, -3, -4];
/// Homing methods of the bench.
const METHODS: [i32; 3] = [17, 18, 35];

/// All parameters, by address.
#[rustfmt::skip]
pub(crate) const ROWS: &[Row] = &[
    Row::new(POSITION_INTERFACE, "IOposInterfac", Kind::Kept, Range::From(0, 2), 0),
    Row::new(1_544, "SPVswLimPusr", Kind::Kept, ANY, i32::MAX),
    Row::new(1_546, "SPVswLimNusr", Kind::Kept, ANY, i32::MIN),
    Row::new(SPEED_LIMIT, "RAMPn_max", Kind::Kept, Range::From(1, 13_200), 13_200),
    Row::new(ACCELERATION, "RAMPacc", Kind::Kept, RAMPS, 600),
    Row::new(DECELERATION, "RAMPdecel", Kind::Kept, RAMPS, 600),
    Row::new(BAUD, "MBbaud", Kind::Kept, Range::OneOf(&BAUD_RATES), 19_200), // manual 4.1
    Row::new(ADDRESS, "MBadr", Kind::Kept, Range::From(1, 247), 1),             // manual 4.1
    Row::new(FORMAT, "MBformat", Kind::Kept, Range::From(1, 4), 2),             // manual 4.1
    Row::new(NODE_GUARD, "MBnode_guard", Kind::Lost, Range::From(0, 10_000), 0), // manual 4.1: not persistent
    Row::new(WORD_ORDER, "MBdword_order", Kind::Kept, Range::From(0, 1), 0),    // manual 4.1
    Row::new(CONTROL, "DCOMcontrol", Kind::Lost, WORD, 0),
    Row::read_only(STATUS, "DCOMstatus"),
    Row::new(MODE, "DCOMopmode", Kind::Lost, Range::OneOf(&MODES), 0),
    Row::read_only(MODE_ACTIVE, "_DCOMopmd_act"),
    Row::new(JOG, "JOGactivate", Kind::Lost, Range::From(0, 7), 0),
    Row::new(HOMING_METHOD, "HMmethod", Kind::Lost, Range::OneOf(&METHODS), 17),
    Row::new(VELOCITY, "PVn_target", Kind::Lost, BOTH_WAYS, 0),
    Row::new(TARGET, "PPp_targetusr", Kind::Lost, ANY, 0),
    Row::new(TARGET_SPEED, "PPn_target", Kind::Lost, SPEEDS, 60),
    Row::new(CURRENT_SOURCE, "CURreference", Kind::Lost, Range::From(0, 2), 0),
    Row::new(SPEED_SOURCE, "SPEEDreference", Kind::Lost, Range::From(0, 2), 0),
    Row::new(GEAR_SOURCE, "GEARreference", Kind::Lost, Range::From(0, 2), 0),
    Row::read_only(POSITION, "_p_act"),
    Row { decimals: 2, ..Row::new(CURRENT, "CUR_I_target", Kind::Lost, Range::From(-30_000, 30_000), 0) },
    Row::new(SPEED, "SPEEDn_target", Kind::Lost, BOTH_WAYS, 0),
    Row::new(GEAR_DENOMINATOR, "GEARdenom", Kind::Lost, Range::From(1, i32::MAX), 1),
    Row::new(GEAR_NUMERATOR, "GEARnum", Kind::Lost, ANY, 1),
    Row::new(HOMING_SPEED, "HMn", Kind::Kept, Range::From(1, 13_200), 60),
    Row::new(HOMING_SPEED_OUT, "HMn_out", Kind::Kept, Range::From(1, 3_000), 6),
    Row::new(JOG_SLOW, "JOGn_slow", Kind::Kept, Range::From(1, 13_200), 60),
    Row::new(JOG_FAST, "JOGn_fast", Kind::Kept, Range::From(1, 13_200), 180),
    Row::read_only(FAULT_NUMBER, "FLT_err_num"),
    Row::read_only(FAULT_CLASS, "FLT_class"),
    Row::read_only(FAULT_TIME, "FLT_Time"),
    Row::read_only(FAULT_QUALIFIER, "FLT_Qual"),
];

/// The parameter at an address.
pub(crate) fn at(address: u16) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.address == address)
}

/// The parameter that a bench file names: by short name or by address.
pub(crate) fn named(name: &str) -> Option<&'static Row> {
    ROWS.iter().find(|row| row.name.eq_ignore_ascii_case(name) || name.parse() == Ok(row.address))
}

/// What one drive holds.
#[derive(Clone, Debug)]
pub(crate) struct Values {
    values: BTreeMap<u16, i32>,
    /// What stood there when the power came.
    at_power_on: BTreeMap<u16, i32>,
    writes: u64,
}

impl Values {
    /// A drive as it leaves the factory.
    pub(crate) fn new() -> Self {
        Values {
            values: ROWS.iter().map(|row| (row.address, row.factory)).collect(),
            at_power_on: BTreeMap::new(),
            writes: 0,
        }
    }

    /// Present value; 0 of what there is not.
    pub(crate) fn get(&self, address: u16) -> i64 {
        self.values.get(&address).copied().unwrap_or(0).into()
    }

    /// Puts a value there as the drive itself does, or the bench file.
    pub(crate) fn put(&mut self, address: u16, value: i32) {
        self.values.insert(address, value);
    }

    /// A write of the master.
    pub(crate) fn write(&mut self, row: &Row, value: i32) {
        self.writes += u64::from(row.kind == Kind::Kept);
        self.put(row.address, value);
    }

    /// Cells of the EEPROM written since the drive was built.
    pub(crate) fn writes(&self) -> u64 {
        self.writes
    }

    /// What stands there now is what the EEPROM holds.
    pub(crate) fn settle(&mut self) {
        self.at_power_on = self.values.clone();
    }

    /// Power-on: what is not kept goes back to its factory setting; what nobody has `saved` to what it was.
    pub(crate) fn power_up(&mut self, unsaved_is_lost: bool) {
        for row in ROWS.iter().filter(|row| unsaved_is_lost && row.kind == Kind::Kept) {
            if let Some(&value) = self.at_power_on.get(&row.address) {
                self.put(row.address, value);
            }
        }
        for row in ROWS.iter().filter(|row| row.kind == Kind::Lost) {
            self.put(row.address, row.factory);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses_are_even_and_rise_and_factory_settings_are_in_range() {
        assert_eq!(ROWS.len(), 36);
        assert!(ROWS.iter().all(|row| row.address % 2 == 0 && (row.address == MODE || row.takes(row.factory))));
        assert!(ROWS.windows(2).all(|pair| pair[0].address < pair[1].address));
    }

    /// Two readings of one manual: whoever wrote the catalogue has not seen this table.
    #[test]
    fn bench_and_catalogue_agree() {
        let family = crate::profile::Registry::open(&[]).unwrap().family("lxm05").unwrap();
        assert_eq!(family.params.len(), ROWS.len());
        for row in ROWS {
            let param = family.param(row.address.into()).unwrap();
            assert_eq!(param.short.as_deref(), Some(row.name));
            assert_eq!(param.access.writes(), row.kind != Kind::ReadOnly, "{}", row.name);
            assert_eq!(param.decimals_or_zero(), row.decimals, "{}", row.name);
            assert!(param.default.is_none_or(|default| default == i64::from(row.factory)), "{}", row.name);
            let takes = |limit: Option<i64>| limit.is_none_or(|limit| row.takes(limit as i32));
            assert!(takes(param.min) && takes(param.max), "{}", row.name);
            assert!(param.max.is_none_or(|max| !row.takes(max as i32 + 1)), "{}", row.name);
        }
    }

    #[test]
    fn only_what_is_persistent_outlives_the_power() {
        let mut values = Values::new();
        for (address, value) in [(BAUD, 9_600), (NODE_GUARD, 500), (CONTROL, 15)] {
            values.write(at(address).unwrap(), value);
        }
        values.power_up(false);
        assert_eq!((values.get(BAUD), values.get(NODE_GUARD), values.get(CONTROL)), (9_600, 0, 0));
        assert_eq!(values.writes(), 1);
    }
}
