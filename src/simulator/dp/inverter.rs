//! The inverter behind a module: its parameters (manual 5.5), its terminals, its trips, its motor.

use super::motor::Motor;
use crate::profile::Family;
use crate::tick::{Span, Tick};
use std::collections::BTreeMap;

/// Which inverter it is, as P.624 tells (manual 5.3).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Sj200,
    L200,
    X200,
}

impl Kind {
    /// The words of `--drive`.
    pub(crate) const NAMES: [(&'static str, Kind); 3] =
        [("l200", Kind::L200), ("sj200", Kind::Sj200), ("x200", Kind::X200)];

    pub(crate) fn name(self) -> &'static str {
        Self::NAMES.iter().find(|row| row.1 == self).map_or("", |row| row.0)
    }
}

/// What the words, the terminals or a lost bus want of the motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    /// This frequency, 0.01 Hz, positive clockwise.
    Run(i64),
    /// As it is.
    Keep,
    /// The frequency that it has.
    Hold,
    /// By the ramp F003.
    Stop,
    /// By the DC brake.
    Brake,
    /// Without power.
    Coast,
}

/// A parameter that the series has.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row {
    /// Bytes of its value.
    pub(crate) bytes: u8,
    pub(crate) writes: bool,
    pub(crate) min: Option<i64>,
    pub(crate) max: Option<i64>,
    /// A word of it is two's complement; the code of the ramps has negative values too (5.5 index 7).
    is_signed: bool,
}

impl Row {
    /// What the low word of a PWE, or a mapped word, means there.
    pub(crate) fn raw(self, pwe: u32) -> i64 {
        if self.is_signed { ((pwe & 0xFFFF) as u16).cast_signed().into() } else { pwe.into() }
    }
}

/// A trip as P.300 to P.305 keep it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Trip {
    /// Cause of 3.2.3.
    pub(crate) cause: u8,
    /// 0.01 Hz.
    pub(crate) frequency: i64,
}

#[derive(Clone, Debug)]
pub(crate) struct Inverter {
    pub(crate) kind: Kind,
    rows: BTreeMap<u32, Row>,
    values: BTreeMap<u32, i64>,
    pub(crate) motor: Motor,
    /// The trip that stands.
    pub(crate) trip: Option<Trip>,
    /// The start contact FW is closed.
    pub(crate) contact: bool,
    /// Ramps of the Basic block, in the place of F002 and F003.
    pub(crate) ramps: [Option<Span>; 2],
    /// Runs by an order.
    pub(crate) ordered: bool,
}

/// Indexes of 5.5 that the bench works with.
const F002: u32 = 7;
const F003: u32 = 9;
const A003: u32 = 13;
const A004: u32 = 15;
const A038: u32 = 34;
const A001: u32 = 88;
const A002: u32 = 89;
/// Setpoint of the terminals, 0.01 Hz.
pub(crate) const TERMINALS: i64 = 1_000;
/// Maximum frequency of every inverter of the bench, 0.01 Hz.
const FULL: i64 = 5_000;
/// The cause that the bench knows best: an external trip (3.2.3).
pub(crate) const EXTERNAL: u8 = 0x25;

impl Inverter {
    pub(crate) fn new(kind: Kind, family: &Family, a004_scale: i64) -> Self {
        let rows = family.params.values().filter_map(|param| {
            let (kind, min, max) = (param.kind?, param.min, param.max);
            let is_signed = kind.is_coded() || min.is_some_and(|min| min < 0);
            Some((param.id, Row { bytes: kind.bytes()?, writes: param.access.writes(), min, max, is_signed }))
        });
        let rows: BTreeMap<u32, Row> = rows.collect();
        let full = FULL / 100 * a004_scale;
        // 10.00 s, 10.00 s, A003, A004, 5.00 Hz, setpoint and start by the terminals.
        let set = [(F002, -1_000), (F003, -1_000), (A003, full), (A004, full), (A038, 500), (A001, 1), (A002, 1)];
        Inverter {
            kind,
            values: rows.iter().map(|(index, row)| (*index, row.min.unwrap_or(0).max(0))).chain(set).collect(),
            rows,
            motor: Motor::new(FULL),
            trip: None,
            contact: false,
            ramps: [None; 2],
            ordered: false,
        }
    }

    /// The row of an index, if the series has it.
    pub(crate) fn row(&self, index: u32) -> Option<Row> {
        self.rows.get(&index).copied()
    }

    /// Raw value that stands there.
    pub(crate) fn stored(&self, index: u32) -> i64 {
        self.values.get(&index).copied().unwrap_or(0)
    }

    pub(crate) fn store(&mut self, index: u32, raw: i64) {
        self.values.insert(index, raw);
    }

    /// Jog frequency, 0.01 Hz.
    pub(crate) fn jog(&self) -> i64 {
        self.stored(A038)
    }

    /// Output current, 0.01 A: 1.6 A and a little for the frequency.
    pub(crate) fn current(&self, now: Tick) -> i64 {
        if self.motor.is_fed() { 160 + self.motor.frequency(now).abs() / 100 } else { 0 }
    }

    /// What the terminals want; A002 = 1 lets them (index 89).
    pub(crate) fn terminals(&self) -> Order {
        if self.contact && self.stored(A002) == 1 { Order::Run(TERMINALS) } else { Order::Stop }
    }

    /// Obeys, unless it has tripped.
    pub(crate) fn obey(&mut self, now: Tick, order: Order) {
        if self.trip.is_some() {
            self.ordered = false;
            return;
        }
        let up = self.ramps.first().copied().flatten().unwrap_or(time(self.stored(F002)));
        let down = self.ramps.last().copied().flatten().unwrap_or(time(self.stored(F003)));
        let speed = self.motor.shaft(now);
        self.ordered = match order {
            Order::Run(to) => {
                let ramp = if to.abs() < speed.abs() { down } else { up };
                self.motor.go(now, to, ramp);
                true
            }
            Order::Keep | Order::Hold => {
                if order == Order::Hold {
                    self.motor.hold(now);
                }
                self.ordered
            }
            Order::Stop => {
                self.motor.stop(now, down);
                false
            }
            Order::Brake => {
                self.motor.brake(now);
                false
            }
            Order::Coast => {
                self.motor.coast(now);
                false
            }
        };
    }

    /// Trips: the power goes.
    pub(crate) fn trips(&mut self, now: Tick, cause: u8) {
        self.trip = Some(Trip { cause, frequency: self.motor.frequency(now) });
        self.motor.coast(now);
        self.ordered = false;
    }

    /// State as of SJ100 and L100 (3.2.3, P.622).
    pub(crate) fn state(&self, now: Tick) -> u16 {
        match (self.trip, self.motor.is_fed() && (self.ordered || self.motor.frequency(now) != 0)) {
            (Some(_), _) => 10,
            (_, true) => 1,
            _ if self.motor.shaft(now) != 0 => 3,
            _ => 0,
        }
    }
}

/// A ramp in the mixed code: -1 to -9999 is 0.01 to 99.99 s, 1000 to 30000 is 100.0 to 3000.0 s (5.5 index 7).
fn time(raw: i64) -> Span {
    let of = |count: i64, ms: u64| Span::from_millis(u64::try_from(count).unwrap_or(1).max(1) * ms);
    if raw < 0 { of(-raw, 10) } else { of(raw, 100) }
}
