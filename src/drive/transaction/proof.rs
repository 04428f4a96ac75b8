//! Looking once more at what was promised: what a drive forgot or changed meanwhile is never called proven.

use super::plan::Kept;
use crate::drive::stands::stands_at;
use crate::drive::{Session, Target};
use crate::failure::{Class, Failure};
use crate::profile::DataSets;
use crate::text::both;

/// So often everything in the RAM is asked again at most, until it is told without a gap.
const ROUNDS: usize = 6;

/// Looks at these places; `takes` gets what stands at each, by its index, and says whether to go on. In the RAM all of them must
/// be told without a gap: behind a missing answer, which may be a restart, it begins anew.
///
/// # Errors
/// So many answers are missing that nothing is proven of a RAM.
pub(super) async fn look(
    session: &mut Session<'_>,
    target: &mut Target,
    places: &[Kept],
    mut takes: impl FnMut(usize, Result<i64, Failure>) -> bool,
) -> Result<(), Failure> {
    let in_ram = places.iter().any(|kept| kept.set >= DataSets::RAM_OFFSET);
    let (mut told, most) = (0, places.len() * ROUNDS);
    for (index, kept) in places.iter().enumerate().cycle().take(most) {
        let repeats = session.tally().repeats;
        let now = stands_at(session, target, &kept.param, kept.set).await;
        told = match (&now, in_ram && session.tally().repeats > repeats) {
            (Err(_), _) if in_ram => 0,
            (_, true) => 1,
            _ => told + 1,
        };
        if !takes(index, now) || told == places.len() {
            return Ok(());
        }
    }
    if places.is_empty() { Ok(()) } else { Err(unsteady()) }
}

/// The failure of a line over which nothing can be proven of a RAM.
fn unsteady() -> Failure {
    let message = both!(
        "so many answers are missing that nobody knows whether the drive restarted meanwhile",
        "so viele Antworten fehlen, dass offen ist, ob der Antrieb zwischendurch neu gestartet ist"
    );
    Failure::new(Class::Garbled, "garbled.unsteady", message)
}
