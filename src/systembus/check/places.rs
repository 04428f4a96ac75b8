//! What stands where: each byte once, sender and receiver alike, sources of the right kind (EM-RES-03 manual 5.11.5, facts G3.2).

use super::{Remark, error, note, repeated, warning};
use crate::profile::{Family, HazardKind};
use crate::protocol::can::pdo::Place;
use crate::systembus::ends;
use crate::systembus::plan::{Drive, Plan, Rx, Tx};
use crate::systembus::relations::relations;
use crate::text::both;

pub(super) fn check(plan: &Plan, family: &Family) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for drive in &plan.drives {
        for tx in &drive.tx {
            remarks.extend(sent(drive, tx, family));
        }
        for rx in &drive.rx {
            let places: Vec<Place> = rx.outputs.iter().map(|output| output.0).collect();
            remarks.extend(crowded(&format!("{} RxPDO{}", drive.name, rx.number.number()), &places));
        }
        remarks.extend(taken(drive, family));
    }
    for relation in relations(plan) {
        for receiver in &relation.receivers {
            remarks.extend(heard(relation.sender, relation.tx, receiver.drive, receiver.rx));
        }
        let identifier = relation.identifier;
        if let (Some(sender), true) = (relation.sender, relation.receivers.is_empty()) {
            let text = both!(
                "{sender}: nobody receives identifier {identifier}",
                "{sender}: niemand empfängt Identifier {identifier}"
            );
            remarks.push(note("unheard", text));
        }
    }
    remarks
}

/// Bytes that are used for two things.
fn crowded(who: &str, places: &[Place]) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for (nth, place) in places.iter().enumerate() {
        for other in places.iter().take(nth).filter(|other| **other != *place && other.meets(*place)) {
            remarks.push(error(
                "byte_twice",
                both!("{who}: {other} and {place} share bytes", "{who}: {other} und {place} teilen sich Bytes"),
            ));
        }
    }
    remarks
}

fn sent(drive: &Drive, tx: &Tx, family: &Family) -> Vec<Remark> {
    let who = format!("{} TxPDO{}", drive.name, tx.number.number());
    let places: Vec<Place> = tx.inputs.iter().map(|input| input.0).collect();
    let mut remarks = crowded(&who, &places);
    for (place, source) in &tx.inputs {
        let param = ends::input(tx.number, *place);
        let kind = place.kind();
        if *source == ends::unused(kind) {
            let text = both!(
                "{who}: {place} has source {source}, which leaves it unused",
                "{who}: {place} hat Quelle {source}, das lässt den Platz unbenutzt"
            );
            remarks.push(warning("unused", text));
            continue;
        }
        match ends::listed(*source) {
            Some(listed) if listed != kind => {
                let listed = listed.name();
                remarks.push(warning(
                    "source_kind",
                    both!(
                        "{who}: source {source} is listed as {listed} and stands at {place} (P.{param})",
                        "{who}: Quelle {source} ist als {listed} gelistet und steht an {place} (P.{param})"
                    ),
                ));
            }
            None if family.param(param).is_none_or(|row| family.text_of(row, (*source).into()).is_none()) => {
                remarks.push(note(
                    "source_unknown",
                    both!(
                        "{who}: source {source} is in none of our lists",
                        "{who}: Quelle {source} steht in keiner unserer Listen"
                    ),
                ));
            }
            _ => {}
        }
    }
    remarks
}

/// Parameters of a drive that take what it receives.
fn taken(drive: &Drive, family: &Family) -> Vec<Remark> {
    let name = &drive.name;
    let params: Vec<u32> = drive.rx.iter().flat_map(|rx| rx.outputs.iter().map(|output| output.1)).collect();
    let twice = repeated(params.iter().copied()).into_iter();
    let mut remarks: Vec<Remark> = twice
        .map(|param| {
            let text =
                both!("{name}: P.{param} is to take two sources", "{name}: P.{param} soll zwei Quellen übernehmen");
            error("parameter_twice", text)
        })
        .collect();
    for param in params {
        match family.param(param) {
            None => remarks.push(note(
                "parameter_unknown",
                both!(
                    "{name}: no catalogue knows P.{param}: whether it takes a source is not known",
                    "{name}: kein Katalog kennt P.{param}: ob er eine Quelle übernimmt, ist nicht bekannt"
                ),
            )),
            Some(row) if row.enumeration.as_deref() != Some("signal-source") => remarks.push(warning(
                "no_source",
                both!(
                    "{name}: P.{param} is not known to take a source",
                    "{name}: von P.{param} ist nicht bekannt, dass er eine Quelle übernimmt"
                ),
            )),
            Some(row) if row.hazard == Some(HazardKind::Motion) => remarks.push(note(
                "motion",
                both!(
                    "{name}: P.{param} can move the shaft as soon as the nodes are started",
                    "{name}: P.{param} kann die Welle bewegen, sobald die Knoten gestartet sind"
                ),
            )),
            Some(_) => {}
        }
    }
    remarks
}

/// Whether a drive takes what was sent, and as what it was sent.
fn heard(sender: Option<&str>, tx: Option<&Tx>, name: &str, rx: &Rx) -> Vec<Remark> {
    let (number, identifier) = (rx.number.number(), rx.identifier);
    let who = format!("{name} RxPDO{number}");
    let Some(sender) = sender else {
        let text =
            both!("{who}: nobody sends identifier {identifier}", "{who}: niemand sendet Identifier {identifier}");
        return vec![error("unsent", text)];
    };
    let mut remarks = Vec::new();
    if sender == name {
        let text = both!("{who} listens to its own drive", "{who} hört den eigenen Antrieb");
        remarks.push(warning("own_pdo", text));
    }
    let Some(tx) = tx else { return remarks };
    for place in rx.outputs.iter().map(|output| output.0) {
        if tx.inputs.iter().any(|input| input.0 == place) {
            continue;
        }
        let source = ends::source(rx.number, place);
        let text = match tx.inputs.iter().find(|input| input.0.meets(place)) {
            Some((other, _)) => both!(
                "{who}: takes {place} (source {source}), but {sender} puts {other} there: other bytes would arrive",
                "{who}: übernimmt {place} (Quelle {source}), aber {sender} legt dort {other} ab: es kämen andere Bytes an"
            ),
            None => both!(
                "{who}: takes {place} (source {source}), where {sender} puts nothing",
                "{who}: übernimmt {place} (Quelle {source}), wo {sender} nichts ablegt"
            ),
        };
        remarks.push(error("places_differ", text));
    }
    remarks
}
