//! Identifiers: each once, none of another service, in the advised range (EM-RES-03 manual 5.8.2, 5.9.4, 5.11.1, 5.11.4, 5.14).

use super::{Remark, error, note, repeated, warning};
use crate::protocol::can::{EMERGENCIES, FOR_PDOS, PdoNumber, SdoChannel, Service};
use crate::systembus::plan::{Drive, Plan};
use crate::systembus::settings::SYNC;
use crate::text::{Text, both};

pub(super) fn check(plan: &Plan) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let sent: Vec<(String, u16)> =
        plan.sent().map(|(name, tx, identifier, _)| (sender(name, tx), identifier)).collect();
    for identifier in repeated(sent.iter().map(|row| row.1)) {
        let senders =
            sent.iter().filter(|row| row.1 == identifier).map(|row| row.0.as_str()).collect::<Vec<_>>().join(", ");
        remarks.push(error(
            "identifier_twice",
            both!(
                "identifier {identifier} is sent by several: {senders}",
                "Identifier {identifier} wird von mehreren gesendet: {senders}"
            ),
        ));
    }
    let taken = taken(plan);
    for (who, identifier) in &sent {
        remarks.extend(of_a_pdo(who, *identifier, &taken));
    }
    remarks.extend(sync(plan, &taken));
    remarks.extend(sdo(plan));
    remarks.extend(preset(plan, &sent));
    remarks
}

fn sender(name: &str, tx: Option<&crate::systembus::Tx>) -> String {
    tx.map_or_else(|| name.to_owned(), |tx| format!("{name} TxPDO{}", tx.number.number()))
}

/// Identifiers that the other services of the planned drives have.
fn taken(plan: &Plan) -> Vec<(u16, String)> {
    let mut taken = vec![(plan.sync_identifier, "SYNC".to_owned())];
    for drive in &plan.drives {
        let node = drive.node;
        let mut add = |what: &str, identifier: Option<u16>| {
            taken.extend(identifier.map(|identifier| (identifier, format!("{what} {}", drive.name))));
        };
        let preset = |channel| Service::SdoRequest(channel, node).identifier();
        add("RxSDO1", drive.rx_sdo1.or_else(|| preset(SdoChannel::One)));
        add("TxSDO1", drive.tx_sdo1.or_else(|| Service::SdoReply(SdoChannel::One, node).identifier()));
        if drive.sdo2 != Some(false) {
            add("RxSDO2", preset(SdoChannel::Two));
            add("TxSDO2", Service::SdoReply(SdoChannel::Two, node).identifier());
        }
        add("boot-up", Service::BootUp(node).identifier());
    }
    taken
}

fn of_a_pdo(who: &str, identifier: u16, taken: &[(u16, String)]) -> Option<Remark> {
    if EMERGENCIES.contains(&identifier) {
        return Some(error("identifier_emergency", forbidden(who, identifier)));
    }
    if let Some((_, other)) = taken.iter().find(|row| row.0 == identifier) {
        let text = both!(
            "{who}: identifier {identifier} is taken ({other})",
            "{who}: Identifier {identifier} ist vergeben ({other})"
        );
        return Some(error("identifier_taken", text));
    }
    let (first, last) = (FOR_PDOS.start(), FOR_PDOS.end());
    (!FOR_PDOS.contains(&identifier)).then(|| {
        let text = both!(
            "{who}: identifier {identifier} is outside {first} to {last}, which the manual advises for PDOs",
            "{who}: Identifier {identifier} liegt außerhalb von {first} bis {last}, die die Anleitung für PDOs empfiehlt"
        );
        warning("identifier_advised", text)
    })
}

fn forbidden(who: &str, identifier: u16) -> Text {
    let (first, last) = (EMERGENCIES.start(), EMERGENCIES.end());
    both!(
        "{who}: identifier {identifier} is forbidden: {first} to {last} belong to the emergencies",
        "{who}: Identifier {identifier} ist verboten: {first} bis {last} gehören den Emergency-Telegrammen"
    )
}

fn sync(plan: &Plan, taken: &[(u16, String)]) -> Vec<Remark> {
    let identifier = plan.sync_identifier;
    let mut remarks = Vec::new();
    if EMERGENCIES.contains(&identifier) {
        remarks.push(error("identifier_emergency", forbidden("SYNC", identifier)));
    } else if let Some((_, other)) = taken.iter().skip(1).find(|row| row.0 == identifier) {
        remarks.push(error(
            "identifier_taken",
            both!(
                "SYNC: identifier {identifier} is taken ({other})",
                "SYNC: Identifier {identifier} ist vergeben ({other})"
            ),
        ));
    }
    if identifier != SYNC && plan.master().is_some() {
        remarks.push(warning(
            "sync_identifier",
            both!(
                "the manual lets the SYNC identifier be changed only where the master is a controller",
                "die Anleitung lässt einen anderen SYNC-Identifier nur zu, wenn der Master eine Steuerung ist"
            ),
        ));
    }
    remarks
}

fn sdo(plan: &Plan) -> Vec<Remark> {
    let changed = plan.drives.iter().filter(|drive| drive.rx_sdo1.is_some() || drive.tx_sdo1.is_some());
    let mut remarks = Vec::new();
    for drive in changed {
        let name = &drive.name;
        for identifier in [drive.rx_sdo1, drive.tx_sdo1].into_iter().flatten().filter(|it| EMERGENCIES.contains(it)) {
            remarks.push(error("identifier_emergency", forbidden(name, identifier)));
        }
        if plan.master().is_some() {
            remarks.push(error(
                "sdo_identifier",
                both!(
                    "{name}: with a drive as master the identifiers of SDO1 must stay as they are (P.921, P.922 = 0)",
                    "{name}: mit einem Antrieb als Master müssen die Identifier von SDO1 bleiben (P.921, P.922 = 0)"
                ),
            ));
        }
    }
    remarks
}

/// A PDO with an identifier that another drive has by its factory setting: it is free only because the plan switches that one off.
fn preset(plan: &Plan, sent: &[(String, u16)]) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for (who, identifier) in sent {
        let owner = plan.drives.iter().find_map(|drive| Some((drive, unused_of(drive, *identifier)?)));
        if let Some((drive, pdo)) = owner {
            let name = &drive.name;
            remarks.push(note(
                "identifier_preset",
                both!(
                    "{who}: identifier {identifier} is the factory one of {pdo} of {name}, which must stay unused",
                    "{who}: Identifier {identifier} ist der werkseitige von {pdo} von {name}; das muss unbenutzt bleiben"
                ),
            ));
        }
    }
    remarks
}

/// The PDO of a drive that is not planned and has this identifier by the predefined connection set.
fn unused_of(drive: &Drive, identifier: u16) -> Option<String> {
    let is = |service: Service| service.identifier() == Some(identifier);
    PdoNumber::ALL.into_iter().find_map(|pdo| {
        let (sends, receives) =
            (drive.tx.iter().any(|tx| tx.number == pdo), drive.rx.iter().any(|rx| rx.number == pdo));
        let number = pdo.number();
        if !sends && is(Service::TxPdo(pdo, drive.node)) {
            return Some(format!("TxPDO{number}"));
        }
        (!receives && is(Service::RxPdo(pdo, drive.node))).then(|| format!("RxPDO{number}"))
    })
}
