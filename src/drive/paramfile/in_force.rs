//! What a drive works with, where that is not what it has stored: a file names what is stored.

use super::Asking;
use crate::drive::stands::{has_ram, in_ram};
use crate::drive::{Session, Target};
use crate::profile::paramfile::{Settings, value_text};
use crate::profile::{DataSets, Family, Param, Sets};
use crate::text::{Text, both};

/// So many parameters of a kind in a row without a RAM tell that the drive does not show it.
const MOST_HIDDEN: usize = 2;

/// The values with which a drive works, of what it has stored, where they are other ones (RAM), and that it does not show them. Asked is until
/// the drive refuses that or is gone: it is a note beside a comparison of what is stored.
pub async fn in_force(session: &mut Session<'_>, target: &mut Target, stored: &Settings) -> Vec<Text> {
    // A drive may have a RAM of what has data sets, and none of the rest.
    let (mut notes, mut hidden) = (Vec::new(), [0, 0]);
    let params: Vec<Param> = stored.params().cloned().collect();
    for param in params {
        let places: Vec<(u8, i64)> =
            (0..=4).filter_map(|set| Some((set, stored.exactly(param.id, set)?.raw))).collect();
        let sets: Vec<u8> = places.iter().map(|(set, _)| *set).filter(|set| has_ram(target, &param, *set)).collect();
        let [with_sets, without] = &mut hidden;
        let hidden = if param.sets == Some(Sets::Four) { with_sets } else { without };
        if sets.is_empty() || *hidden >= MOST_HIDDEN {
            continue;
        }
        let Ok(shown) = in_ram(session, target, &param, &sets).await else { break };
        *hidden = if shown.is_empty() { *hidden + 1 } else { 0 };
        for (ram, raw) in shown {
            let set = ram - DataSets::RAM_OFFSET;
            let beneath = places.iter().find(|(stored, _)| *stored == set).or_else(|| places.first());
            if let Some((_, old)) = beneath.filter(|(_, old)| *old != raw) {
                notes.push(both!(
                    "{label}@{set}: stored is {old}, the drive works with {raw} (RAM) until it is switched off",
                    "{label}@{set}: gespeichert ist {old}, der Antrieb arbeitet bis zum Ausschalten mit {raw} (RAM)",
                    label = param.label(),
                    old = value_text(&param, *old),
                    raw = value_text(&param, raw)
                ));
            }
        }
    }
    notes.extend(match hidden {
        [0, 0] => None,
        [0, _] if stored.params().any(|param| param.sets == Some(Sets::Four)) => Some(both!(
            "the drive shows its RAM of what has data sets alone: what it works with otherwise until it is switched off is not compared",
            "der Antrieb zeigt sein RAM nur von dem, was Datensätze hat: womit er sonst bis zum Ausschalten arbeitet, ist nicht verglichen"
        )),
        _ => Some(both!(
            "the drive does not show its RAM: what it works with until it is switched off is not compared",
            "der Antrieb zeigt sein RAM nicht: womit er bis zum Ausschalten arbeitet, ist nicht verglichen"
        )),
    });
    notes
}

/// The data sets, as on the wire, of the questions for what is in force.
pub fn ram_sets(asking: &Asking, family: &Family) -> Vec<u8> {
    let has = family.link.route.has_data_sets() && !asking.param.is_volatile();
    let sets = asking.sets.iter().filter(|_| has).flat_map(|sets| sets.wire());
    sets.filter(|set| *set < DataSets::RAM_OFFSET).map(|set| set + DataSets::RAM_OFFSET).collect()
}
