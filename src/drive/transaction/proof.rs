//! Looking once more at what was promised: what a drive forgot or changed meanwhile is never called proven.

use super::plan::{Kept, Plan, is_behind};
use super::progress::{Doing, progress};
use super::weigh::place;
use crate::drive::job::Step;
use crate::drive::stands::{in_ram, stands_at};
use crate::drive::{Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::{ErrorDoc, WriteResult};
use crate::profile::DataSets;
use crate::profile::paramfile::value_text;
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
        session.tell(progress(Doing::Proves, told, places.len(), &kept.param));
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

/// Looks whether the drive works with what was stored, as far as it shows what it works with: a failure for each value with which it
/// does not. The row says so too.
///
/// # Errors
/// The drive does not answer.
pub(super) async fn in_force(session: &mut Session<'_>, plan: &mut Plan) -> Result<Vec<Failure>, Failure> {
    let mut failures = Vec::new();
    for group in plan.groups(|row| matches!(row.result, WriteResult::Verified | WriteResult::Restored)) {
        let steps: Vec<(usize, Step)> =
            group.into_iter().filter_map(|index| Some((index, plan.job.steps.get(index)?.clone()))).collect();
        let shown = steps.iter().filter(|(_, step)| plan.behind(step).next().is_some());
        let (sets, param) =
            (shown.map(|(_, step)| step.set).collect::<Vec<_>>(), steps.first().map(|one| &one.1.param));
        let Some(param) = param.filter(|_| !sets.is_empty()) else { continue };
        let now = in_ram(session, &mut plan.job.target, param, &sets).await?;
        for (index, step) in &steps {
            let other = now.iter().find(|(set, raw)| is_behind(*set, step.set) && *raw != step.raw);
            if let (Some((_, raw)), Some(row)) = (other, plan.job.rows.get_mut(*index)) {
                let failure = stored_only(step, *raw);
                (row.result, row.error) = (WriteResult::Stored, Some(ErrorDoc::from(&failure)));
                failures.push(failure);
            }
        }
    }
    Ok(failures)
}

fn stored_only(step: &Step, now: i64) -> Failure {
    let message = both!(
        "{label} is stored as {stored}, but the drive works with {now} (RAM)",
        "{label} ist als {stored} gespeichert, der Antrieb arbeitet aber mit {now} (RAM)",
        label = place(step),
        stored = value_text(&step.param, step.raw),
        now = value_text(&step.param, now)
    );
    Failure::new(Class::Partial, "partial.not_in_force", message).with("param", step.param.id).hint(both!(
        "it may take effect after switching the drive off and on; the same load again writes the RAM alone",
        "vielleicht wirkt es nach Aus- und Einschalten des Antriebs; noch einmal geladen, wird nur das RAM geschrieben"
    ))
}
