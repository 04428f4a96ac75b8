//! The parameters of a drive as objects of its SDO servers (EM-RES-03 manual 5.10.1).

use super::readings::{Reading, Readings};
use super::settings;
use crate::profile::Type;
use crate::protocol::can::sdo::{Initiate, Multiplexer, Reply};
use crate::simulator::device::contract::{Device, Effect, Object};
use crate::tick::Tick;

/// Codes of an abort (manual 5.10.1).
const VALUE: u8 = 1;
const SET: u8 = 2;
pub(super) const TYPE: u8 = 10;
const UNKNOWN: u8 = 11;
pub(super) const OTHER: u8 = 15;
/// Parameters of the system bus (manual 7.2).
const OWN: std::ops::RangeInclusive<u16> = 900..=989;
/// The first data set that is of the RAM (CM-485 manual 7).
const FIRST_RAM: u8 = 5;

fn object(readings: Readings, of: Multiplexer) -> Result<Object, u8> {
    if readings.has(Reading::OwnParametersUnknown) && OWN.contains(&of.index) {
        return Err(UNKNOWN);
    }
    if of.sub >= FIRST_RAM && readings.has(Reading::NoRam) {
        return Err(SET);
    }
    Ok(Object { number: of.index, set: of.sub })
}

/// What is told of a parameter.
pub(super) fn upload(device: &mut dyn Device, readings: Readings, now: Tick, of: Multiplexer) -> Result<Reply, u8> {
    let object = object(readings, of)?;
    let taken = readings.has(Reading::SetsAreTaken);
    let sdo = device.sdo().ok_or(OTHER)?;
    let (bits, kind) = match sdo.upload(now, object) {
        Err(SET) if taken => sdo.upload(now, Object { set: 0, ..object })?,
        told => told?,
    };
    let word = bits as u16;
    let extended = kind == Type::Int && word & 0x8000 != 0 && readings.has(Reading::SignIsExtended);
    let bits = match kind {
        Type::Long => bits,
        _ if extended => 0xFFFF_0000 | u32::from(word),
        _ => u32::from(word),
    };
    Ok(Reply::Upload(of, Initiate::untold(bits)))
}

/// Takes a value, and what comes of it.
pub(super) fn download(
    device: &mut dyn Device,
    readings: Readings,
    now: Tick,
    of: Multiplexer,
    bits: u32,
) -> Result<Effect, u8> {
    let object = object(readings, of)?;
    let (taken, strict) = (readings.has(Reading::SetsAreTaken), readings.has(Reading::TailIsRefused));
    if settings::refuses(device, readings, of.index.into(), bits & 0xFFFF) {
        return Err(VALUE);
    }
    let sdo = device.sdo().ok_or(OTHER)?;
    if strict && bits > u32::from(u16::MAX) && sdo.upload(now, object).is_ok_and(|(_, kind)| kind != Type::Long) {
        return Err(VALUE);
    }
    match sdo.download(now, object, bits) {
        Err(SET) if taken => sdo.download(now, Object { set: 0, ..object }, bits),
        told => told,
    }
}
