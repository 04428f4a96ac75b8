//! What a PDO of a plan carries: at each of its places the source that fills it, who takes it, and the number that stands there.

use super::plan::Plan;
use super::relations::links;
use crate::protocol::can::pdo::{Pdo, Place};

/// What stands at a place of a PDO.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Carried<'p> {
    /// Where.
    pub place: Place,
    /// The source that fills it, where a drive sends it.
    pub source: Option<u16>,
    /// Who takes it: the drive, and its parameter.
    pub takers: Vec<(&'p str, u32)>,
    /// The number, without a sign and without a scale: none is printed.
    pub raw: u32,
}

/// What these bytes carry under an identifier; nothing where the plan knows no PDO with it, or they are not eight.
pub fn carried<'p>(plan: &'p Plan, identifier: u16, bytes: &[u8]) -> Vec<Carried<'p>> {
    let Ok(bytes) = <[u8; Pdo::LEN]>::try_from(bytes) else { return Vec::new() };
    let mut list: Vec<Carried<'p>> = Vec::new();
    for link in links(plan).into_iter().filter(|link| link.identifier == identifier) {
        let taker = link.receiver.zip(link.output.map(|output| output.0));
        match list.iter_mut().find(|known| known.place == link.place) {
            Some(known) => known.takers.extend(taker),
            None => list.push(Carried {
                place: link.place,
                source: link.input.map(|input| input.1),
                takers: taker.into_iter().collect(),
                raw: Pdo(bytes).get(link.place),
            }),
        }
    }
    list
}
