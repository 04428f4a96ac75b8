//! Who hears whom (EM-RES-03 manual 5.11.4), and what goes from which source to which parameter (5.11.5).

use super::ends;
use super::load::Load;
use super::plan::{Plan, Rx, Trigger, Tx};
use crate::protocol::can::pdo::Place;

/// A PDO with all who hear it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Relation<'p> {
    /// Its identifier.
    pub identifier: u16,
    /// Who sends it; `None` if nobody of the plan does.
    pub sender: Option<&'p str>,
    /// Which of a drive's PDOs it is.
    pub tx: Option<&'p Tx>,
    /// When it is sent.
    pub trigger: Option<Trigger>,
    /// What it costs, if somebody says how often it is sent.
    pub load: Option<Load>,
    /// Who hears it.
    pub receivers: Vec<Receiver<'p>>,
}

/// Who hears a PDO.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Receiver<'p> {
    /// The drive.
    pub drive: &'p str,
    /// Which of its PDOs.
    pub rx: &'p Rx,
}

/// Every PDO, in the order of identifiers: the first wins the bus. Also those that somebody waits for and nobody sends.
pub fn relations(plan: &Plan) -> Vec<Relation<'_>> {
    let hearing = |identifier: u16| -> Vec<Receiver<'_>> {
        let each =
            plan.drives.iter().flat_map(|drive| drive.rx.iter().map(move |rx| Receiver { drive: &drive.name, rx }));
        each.filter(|receiver| receiver.rx.identifier == identifier).collect()
    };
    let mut relations: Vec<Relation<'_>> = plan
        .sent()
        .map(|(sender, tx, identifier, trigger)| Relation {
            identifier,
            sender: Some(sender),
            tx,
            trigger: Some(trigger),
            load: plan.every_ms(trigger).and_then(|ms| plan.rate.load(ms)),
            receivers: hearing(identifier),
        })
        .collect();
    for rx in plan.drives.iter().flat_map(|drive| &drive.rx) {
        let identifier = rx.identifier;
        if !relations.iter().any(|known| known.identifier == identifier) {
            let receivers = hearing(identifier);
            relations.push(Relation { identifier, sender: None, tx: None, trigger: None, load: None, receivers });
        }
    }
    relations.sort_by_key(|relation| relation.identifier);
    relations
}

/// A virtual link: source -> parameter of a TxPDO -> bytes -> source of an RxPDO -> parameter. What has only one end lacks
/// the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Link<'p> {
    /// Identifier of the PDO.
    pub identifier: u16,
    /// Where in the PDO.
    pub place: Place,
    /// Who sends it.
    pub sender: Option<&'p str>,
    /// The parameter of the sender that is set, and the source that it is set to.
    pub input: Option<(u32, u16)>,
    /// Who receives it.
    pub receiver: Option<&'p str>,
    /// The parameter of the receiver that is set, and the source that it is set to.
    pub output: Option<(u32, u16)>,
}

/// Every virtual link, in the order of identifiers and places.
pub fn links(plan: &Plan) -> Vec<Link<'_>> {
    let mut links = Vec::new();
    for relation in relations(plan) {
        let (identifier, sender) = (relation.identifier, relation.sender);
        let mut heard = Vec::new();
        for Receiver { drive, rx } in &relation.receivers {
            for (place, param) in &rx.outputs {
                let sent =
                    relation.tx.and_then(|tx| tx.inputs.iter().find(|input| input.0 == *place).map(|row| (tx, row.1)));
                heard.push(*place);
                links.push(Link {
                    identifier,
                    place: *place,
                    sender,
                    input: sent.map(|(tx, source)| (ends::input(tx.number, *place), source)),
                    receiver: Some(drive),
                    output: Some((*param, ends::source(rx.number, *place))),
                });
            }
        }
        for (tx, (place, source)) in relation.tx.iter().flat_map(|tx| tx.inputs.iter().map(move |row| (tx, *row))) {
            if !heard.contains(&place) {
                let input = Some((ends::input(tx.number, place), source));
                links.push(Link { identifier, place, sender, input, receiver: None, output: None });
            }
        }
    }
    links.sort_by_key(|link| (link.identifier, link.place.bytes().start));
    links
}
