//! A plan as settings of its drives: every parameter that it decides, also what it leaves unused, because factory settings of the
//! functions are not printed (EM-RES-03 manual 5.11.2) and an old TxPDO would go on sending.

use super::ends;
use super::plan::{Drive, EmergencyReaction, Numbering, Plan, Trigger};
use crate::protocol::can::PdoNumber;
use crate::protocol::can::pdo::Place;

/// What a parameter of a drive shall be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The parameter.
    pub param: u32,
    /// Its value; `None` where it depends on how the drive counts ([`Numbering`]).
    pub value: Option<i64>,
}

/// What a plan decides of a drive, by the number of the parameter.
pub fn settings(plan: &Plan, drive: &Drive) -> Vec<Setting> {
    let mut list: Vec<Setting> = Vec::new();
    let mut set = |param: u32, value: i64| list.push(Setting { param, value: Some(value) });
    set(ends::NODE, drive.node.into());
    set(ends::RATE, plan.rate.code().into());
    set(ends::SYNC_IDENTIFIER, if plan.sync_identifier == SYNC { 0 } else { plan.sync_identifier.into() });
    set(ends::RX_SDO1, drive.rx_sdo1.unwrap_or_default().into());
    set(ends::TX_SDO1, drive.tx_sdo1.unwrap_or_default().into());
    set(ends::SYNC_TIMEOUT, drive.sync_timeout_ms.into());
    if let Some(sdo2) = drive.sdo2 {
        set(ends::SDO2, sdo2.into());
    }
    if drive.node == 0 {
        set(ends::SYNC_TIME, plan.sync_every_ms.unwrap_or_default().into());
        if let Some(delay) = drive.boot_up_delay_ms {
            set(ends::BOOT_UP_DELAY, delay.into());
        }
        if let Some(reaction) = drive.emergency_reaction {
            set(ends::EMERGENCY_REACTION, i64::from(reaction == EmergencyReaction::Warning));
        }
    }
    for pdo in PdoNumber::ALL {
        sent(drive, pdo, &mut set);
    }
    for rx in &drive.rx {
        set(ends::rx_identifier(rx.number), rx.identifier.into());
        set(ends::rx_timeout(rx.number), rx.timeout_ms.into());
        for (place, param) in &rx.outputs {
            set(*param, ends::source(rx.number, *place).into());
        }
    }
    for pdo in PdoNumber::ALL {
        received(drive, pdo, &mut list);
    }
    list.sort_by_key(|setting| setting.param);
    list
}

/// Identifier of SYNC by the predefined connection set; a drive takes 0 for it.
pub(super) const SYNC: u16 = 128;

/// A TxPDO, also one that is not used: it is switched off, and its places are emptied.
fn sent(drive: &Drive, pdo: PdoNumber, set: &mut impl FnMut(u32, i64)) {
    let tx = drive.tx.iter().find(|tx| tx.number == pdo);
    let function = match tx.map(|tx| tx.trigger) {
        None => 0,
        Some(Trigger::Time(ms)) => {
            set(ends::tx_time(pdo), ms.into());
            1
        }
        Some(Trigger::Sync) => 2,
    };
    set(ends::tx_function(pdo), function);
    if let Some(tx) = tx {
        set(ends::tx_identifier(pdo), tx.identifier.into());
    }
    for place in Place::all() {
        let filled = tx.and_then(|tx| tx.inputs.iter().find(|input| input.0 == place));
        set(ends::input(pdo, place), filled.map_or(ends::unused(place.kind()), |input| input.1).into());
    }
}

/// The function of an RxPDO. One that is not used is not watched, and is off where drives know an off.
fn received(drive: &Drive, pdo: PdoNumber, list: &mut Vec<Setting>) {
    let rx = drive.rx.iter().find(|rx| rx.number == pdo);
    if rx.is_none() {
        list.push(Setting { param: ends::rx_timeout(pdo), value: Some(0) });
    }
    let value = match (drive.numbering, rx.map(|rx| rx.on_sync)) {
        (Some(Numbering::FromTime), Some(on_sync)) => Some(on_sync.into()),
        (Some(Numbering::FromOff), Some(on_sync)) => Some(1 + i64::from(on_sync)),
        (Some(Numbering::FromOff), None) => Some(0),
        (None, Some(_)) => None,
        (_, None) => return,
    };
    list.push(Setting { param: ends::rx_function(pdo), value });
}
