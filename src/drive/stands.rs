//! What stands in a drive at the places that are going to be written: in as few telegrams as possible.

use super::{AccessError, Session, Target, describe};
use crate::failure::Failure;
use crate::profile::{DataSets, Param};

/// What stands in the data sets of one parameter: by data set as on the wire.
pub(super) type Stands = Vec<(u8, Result<i64, Failure>)>;

/// Reads these data sets of a parameter, given as on the wire. All four are asked for at once; where data set 0 turns out to
/// be four that differ, there are four.
///
/// # Errors
/// The drive does not answer, or the session is over.
pub(super) async fn stands(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    sets: &[u8],
) -> Result<Stands, Failure> {
    let ram = sets.iter().all(|set| *set >= DataSets::RAM_OFFSET);
    let first = if ram { DataSets::RAM_OFFSET } else { 0 };
    let four: Vec<u8> = (first + 1..=first + 4).collect();
    let asked = if sets == four { vec![first] } else { sets.to_vec() };
    let mut found = Stands::new();
    for set in asked {
        // What the RAM is not shown for costs no further question.
        let rows = match ram {
            true => target.read(session, param, describe::sets(set)).await,
            false => target.read_as_it_is(session, param, &[describe::sets(set)]).await,
        };
        for (at, result) in rows {
            let result = result.map(|reading| reading.raw);
            let result = match result {
                // A value may be refused; a drive that does not answer can be told nothing.
                Err(error) if !error.is_refused() => return Err(failure(&error, target, param)),
                result => result.map_err(|error| failure(&error, target, param)),
            };
            match at == first && sets == four {
                true => found.extend(four.iter().map(|set| (*set, result.clone()))),
                false => found.push((at, result)),
            }
        }
    }
    Ok(found)
}

/// Whether a value that is stored in this data set stands in the RAM too, where it is the one in force (CM-485 manual 7).
pub(super) fn has_ram(target: &Target, param: &Param, set: u8) -> bool {
    let is_stored = target.family.link.route.has_data_sets() && set < DataSets::RAM_OFFSET;
    is_stored && !param.is_volatile() && target.address != 0
}

/// What stands in the RAM behind these data sets of the EEPROM, by data set as on the wire: a write to the EEPROM replaces both
/// (CM-485 manual 7), and what is stored already may not be in force. A drive that does not show its RAM tells nothing.
///
/// # Errors
/// The drive does not answer, or the session is over.
pub(super) async fn in_ram(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    sets: &[u8],
) -> Result<Vec<(u8, i64)>, Failure> {
    let shown = ram_stands(session, target, param, sets).await?;
    Ok(shown.into_iter().filter_map(|(set, raw)| Some((set, raw.ok()?))).collect())
}

/// The same, with why it is not told where it is not.
pub(super) async fn ram_stands(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    sets: &[u8],
) -> Result<Stands, Failure> {
    let stored = sets.iter().filter(|set| has_ram(target, param, **set));
    let sets: Vec<u8> = stored.map(|set| set + DataSets::RAM_OFFSET).collect();
    stands(session, target, param, &sets).await
}

/// The raw value of one place.
pub(super) async fn stands_at(
    session: &mut Session<'_>,
    target: &mut Target,
    param: &Param,
    set: u8,
) -> Result<i64, Failure> {
    let read = target.read_set(session, param, set).await;
    read.map(|reading| reading.raw).map_err(|error| failure(&error, target, param))
}

/// The code of a data set that a drive has not got (CM-485 manual 6.6 and EM-RES-03 manual 5.10.1, code 2).
pub(super) const NO_SUCH_SET: &str = "refused.data_set_not_permitted";

/// The data sets of the RAM, as on the wire, that a drive says it has not got: what is not there holds nothing of its own, and takes
/// nothing. One that it only does not show may hold something (code 3).
pub(super) fn lacking(shown: &Stands) -> impl Iterator<Item = u8> {
    let lacks = |raw: &Result<i64, Failure>| raw.as_ref().is_err_and(|failure| failure.code == NO_SUCH_SET);
    shown.iter().filter(move |(_, raw)| lacks(raw)).map(|(set, _)| *set)
}

fn failure(error: &AccessError, target: &Target, param: &Param) -> Failure {
    error.failure(target.address, Some(&target.family)).with("param", param.id)
}
