//! Which families a drive may be of that nobody has named, before its first word.

use super::{BRIEF, unless_interrupted};
use crate::drive::access::AccessError;
use crate::drive::recognise;
use crate::drive::route::Meant;
use crate::drive::session::Session;
use crate::profile::{Family, Registry};
use crate::text::{Text, both};
use std::rc::Rc;

/// The families that it may be, and whether it has told so. One question tells who describes itself and who does not; without an
/// answer it may be any.
pub(super) async fn presumed(
    session: &mut Session<'_>,
    registry: &Registry,
    address: u8,
) -> Result<(Vec<Rc<Family>>, bool), AccessError> {
    let mut kinds = kinds(registry);
    session.end_at(Some(session.now() + BRIEF));
    let describes = recognise::describes_itself(session, address).await;
    let describes = unless_interrupted(session, describes)?.flatten();
    narrow(&mut kinds, describes);
    Ok((kinds, describes.is_some()))
}

/// What is left of them when the answer comes late; whether it did.
pub(super) fn narrowed(session: &Session<'_>, address: u8, families: &mut Vec<Rc<Family>>) -> bool {
    let describes = recognise::described_itself(session, address);
    narrow(families, describes);
    describes.is_some()
}

fn narrow(families: &mut Vec<Rc<Family>>, describes: Option<bool>) {
    if let Some(describes) = describes {
        families.retain(|family| family.link.product.is_some() == describes);
    }
}

/// Who refuses the words of its family may be of another one: the families of the other kinds, if there was one.
pub(super) fn others(registry: &Registry, families: &[Rc<Family>]) -> Option<(Rc<Family>, Vec<Rc<Family>>)> {
    let [named] = families else { return None };
    let others = kinds(registry).into_iter().filter(|family| kind(family) != kind(named)).collect();
    named.is_movable().then(|| (named.clone(), others))
}

/// What is doubted of a drive that refuses the words of its family; `None`: it has told its product and refuses them for another
/// reason.
pub(super) fn doubted(meant: &Meant, family: &Family) -> Option<Text> {
    match meant.family.is_some() {
        true => Some(both!(": is --drive right?", ": stimmt --drive?")),
        false => family.link.product.is_none().then(|| Text::name(".")),
    }
}

/// One family of each kind that can be moved.
fn kinds(registry: &Registry) -> Vec<Rc<Family>> {
    let mut kinds: Vec<Rc<Family>> = Vec::new();
    for family in registry.families().filter(|family| family.is_movable()) {
        if kinds.iter().all(|known| kind(known) != kind(&family)) {
            kinds.push(family);
        }
    }
    kinds
}

/// Drives whose control words are reached the same way are stopped the same way.
pub(super) fn kind(family: &Family) -> (crate::profile::Route, Option<u32>) {
    (family.link.route, family.role("control-word").map(|param| param.id))
}
