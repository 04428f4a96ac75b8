//! What a module answers to PKW (manual 4.1.1, 5).

use super::inverter::Kind;
use super::module::{LOCK, Module, RIGHT};
use super::readings::Reading;
use crate::protocol::dp::pkw::{Pkw, Task};
use crate::tick::Tick;

/// Numbers of a refusal (4.1.1).
mod refusal {
    pub(super) const NUMBER: u32 = 0;
    pub(super) const READ_ONLY: u32 = 1;
    pub(super) const LIMIT: u32 = 2;
    pub(super) const SUB_INDEX: u32 = 3;
    pub(super) const NO_ARRAY: u32 = 4;
    pub(super) const TYPE: u32 = 5;
    pub(super) const NO_DESCRIPTION: u32 = 9;
    pub(super) const NO_RIGHT: u32 = 11;
}

/// Arrays, with their elements (5.1).
const WRITTEN: u16 = 915;
const READ: u16 = 916;
const IDENTITY: u16 = 964;
/// Serial number, type, version, year, day and month: the order is open (5.1).
const IDENTITY_WORDS: [u16; 5] = [0x1234, 0x0002, 0x0200, 2007, 0x0C0A];
/// Edges that do something (5.3).
const RESET: u16 = 603;
const READ_OUT: u16 = 616;
/// Bytes of a double word.
const LONG: u8 = 4;
/// The last value of what is a choice (5.1 to 5.3).
const LAST: [(u16, i64); 6] = [(620, 1), (623, 8), (703, 4), (704, 3), (927, 1), (928, 2)];

impl Module {
    /// The answer to a request.
    pub(crate) fn answer(&mut self, now: Tick, request: Pkw) -> Pkw {
        let said = match self.carry_out(now, request) {
            _ if request.ak == 0 => return Pkw::default(),
            Ok(said) => said,
            Err(refusal::NO_RIGHT) if !self.readings.has(Reading::LockedIsError) => (8, 0),
            Err(number) => (7, if self.readings.has(Reading::ErrorInHighWord) { number << 16 } else { number }),
        };
        Pkw { ak: said.0, pwe: said.1, ..request }
    }

    fn carry_out(&mut self, now: Tick, request: Pkw) -> Result<(u8, u32), u32> {
        let (task, index, element) = (Task::of(request.ak), request.pnu, request.sub_index());
        if self.inverter.stored(LOCK) == 0 && u32::from(index) != LOCK {
            return Err(refusal::NO_RIGHT);
        }
        let count = elements(index);
        let row = self.inverter.row(index.into()).ok_or(refusal::NUMBER)?;
        match task {
            Task::ReadDescription | Task::WriteDescription => return Err(refusal::NO_DESCRIPTION),
            Task::CountElements => return count.map(|count| (6, count)).ok_or(refusal::NO_ARRAY),
            _ if task.has_element() => {
                let count = count.ok_or(refusal::NO_ARRAY)?;
                if !(1..=count).contains(&element.into()) {
                    return Err(refusal::SUB_INDEX);
                }
            }
            _ if count.is_some() => return Err(refusal::SUB_INDEX),
            _ => {}
        }
        if task.writes() {
            // No parameter of four bytes can be written (5.5), and AK 8 is not supported (4.1.1).
            if task.is_double() {
                return Err(refusal::TYPE);
            }
            self.write(now, index, element, request.pwe, true)?;
            return Ok((if task.has_element() { 4 } else { 1 }, request.pwe));
        }
        let raw = match index {
            WRITTEN | READ | IDENTITY => self.element(index, element).into(),
            _ => self.value(now, index.into()).ok_or(refusal::NUMBER)?,
        };
        let bits = match (row.bytes == LONG, self.readings.has(Reading::SignedPwe)) {
            (true, _) | (false, true) => raw as u32,
            (false, false) => (raw & 0xFFFF) as u32,
        };
        Ok((
            if task.has_element() {
                4
            } else if row.bytes == LONG {
                2
            } else {
                1
            },
            bits,
        ))
    }

    /// Writes a value, by PKW or by a mapped word.
    pub(crate) fn write(&mut self, now: Tick, index: u16, element: u8, pwe: u32, by_pkw: bool) -> Result<(), u32> {
        let row = self.inverter.row(index.into()).ok_or(refusal::NUMBER)?;
        let raw = row.raw(pwe);
        if !row.writes {
            return Err(refusal::READ_ONLY);
        }
        let is_below = row.min.is_some_and(|min| raw < min);
        let max = row.max.or(LAST.into_iter().find(|row| row.0 == index).map(|row| row.1));
        if is_below || max.is_some_and(|max| raw > max) || row.bytes == 1 && !(0..=0xFF).contains(&raw) {
            return Err(refusal::LIMIT);
        }
        let place = usize::from(element).checked_sub(1);
        let cell = |map: &mut [u16; 8]| {
            let cell = place.and_then(|place| map.get_mut(place)).ok_or(refusal::SUB_INDEX)?;
            *cell = (pwe & 0xFFFF) as u16;
            Ok(())
        };
        match index {
            WRITTEN if by_pkw => return cell(&mut self.written),
            READ if by_pkw => return cell(&mut self.read),
            _ => {}
        }
        let edge = raw == 1 && self.inverter.stored(index.into()) == 0;
        self.inverter.store(index.into(), raw);
        match index {
            RESET if edge => self.inverter.trip = None,
            READ_OUT if edge => self.read_out = self.inverter.trip.unwrap_or_default(),
            _ => {}
        }
        if u32::from(index) == RIGHT {
            self.steer(now);
        }
        Ok(())
    }

    /// What stands there at power-on.
    pub(crate) fn preset(&mut self, index: u32, element: u8, raw: i64) {
        let place = usize::from(element).checked_sub(1);
        let map = match index as u16 {
            WRITTEN => Some(&mut self.written),
            READ => Some(&mut self.read),
            _ => None,
        };
        match map.zip(place).and_then(|(map, place)| map.get_mut(place)) {
            Some(cell) => *cell = (raw & 0xFFFF) as u16,
            None => self.inverter.store(index, raw),
        }
    }

    /// Word of an element of an array.
    pub(crate) fn element(&self, index: u16, element: u8) -> u16 {
        let words: &[u16] = match index {
            WRITTEN => &self.written,
            READ => &self.read,
            _ => &IDENTITY_WORDS,
        };
        usize::from(element).checked_sub(1).and_then(|place| words.get(place)).copied().unwrap_or(0)
    }

    /// Raw value as it is now; `None` if the series has no such index.
    pub(crate) fn value(&self, now: Tick, index: u32) -> Option<i64> {
        let inverter = &self.inverter;
        inverter.row(index)?;
        let frequency = inverter.motor.frequency(now);
        let direction = match frequency.signum() {
            1 => 1,
            -1 => 2,
            _ => 0,
        };
        Some(match index {
            // 5.5
            239 => frequency.abs() / 10,
            240 => inverter.current(now),
            245 => self.machine.setpoint(inverter.motor.full, self.readings).abs() / 10,
            246 => direction,
            247 => match inverter.state(now) {
                10 => 8,
                3 => 4,
                1 => 3,
                _ => 2,
            },
            // 5.6
            300 => self.read_out.cause.into(),
            301 => self.read_out.frequency.abs(),
            // 5.3
            600 => self.who(),
            602 => i64::from(self.layout.is_some()),
            604 => direction,
            611 => self.machine.setpoint(inverter.motor.full, self.readings).abs(),
            614 => frequency.abs(),
            615 => inverter.current(now) / 10,
            622 => inverter.state(now).into(),
            624 => match inverter.kind {
                Kind::Sj200 => 0x10,
                Kind::L200 => 0x20,
                Kind::X200 => 0x40,
            },
            // 5.2, 5.4, 5.1
            700 => self.machine.hsw.into(),
            701 => self.actual(now).into(),
            801 => 0x0200,
            918 => self.address.into(),
            965 => 0x0302,
            967 => self.machine.stw.into(),
            968 => self.status(now).into(),
            other => inverter.stored(other),
        })
    }
}

/// How many elements an array has; `None` of what is none.
fn elements(index: u16) -> Option<u32> {
    match index {
        WRITTEN | READ => Some(8),
        IDENTITY => Some(5),
        _ => None,
    }
}
