//! What somebody else changed between the plan and a write, such as while a question stood: that is his, there and back.

use super::plan::{Kept, Plan, is_behind, is_touched};
use super::progress::{Doing, progress};
use super::running::standstill;
use super::weigh::{covers, place};
use crate::drive::Session;
use crate::drive::job::Step;
use crate::drive::stands::{in_ram, ram_stands, stands};
use crate::failure::{Class, Failure};
use crate::outcome::{ErrorDoc, WriteResult, Written};
use crate::profile::DataSets;
use crate::profile::paramfile::value_text;
use crate::text::both;
use std::collections::BTreeMap;

/// Reads once more what the plan was made of: it holds only as long as that stands. Somebody may have changed it while a question
/// stood.
///
/// # Errors
/// Something stands there that was not asked about; its rows say what. Or the drive does not answer.
pub(super) async fn still_stands(session: &mut Session<'_>, plan: &mut Plan) -> Result<(), Failure> {
    let is_planned = |row: &Written| matches!(row.result, WriteResult::Planned | WriteResult::Unchanged);
    stand(session, plan, plan.groups(is_planned), Doing::Reads).await
}

/// Reads once more what the drive had already when it was planned: nobody wrote it, and somebody may have changed it since, or the
/// drive itself behind a value that changes others. What stands in the RAM alone the proof of what was written looks at.
///
/// # Errors
/// As [`still_stands`].
pub(super) async fn still_equal(session: &mut Session<'_>, plan: &mut Plan) -> Result<(), Failure> {
    let is_equal = |row: &Written| row.result == WriteResult::Unchanged && row.store != "ram";
    stand(session, plan, plan.groups(is_equal), Doing::Proves).await
}

async fn stand(
    session: &mut Session<'_>,
    plan: &mut Plan,
    groups: Vec<Vec<usize>>,
    doing: Doing,
) -> Result<(), Failure> {
    let mut failures = Vec::new();
    let total = plan.job.steps.len();
    for group in groups {
        if let Some((first, step)) = group.first().and_then(|index| Some((*index, plan.job.steps.get(*index)?))) {
            session.tell(progress(doing, first, total, &step.param));
        }
        failures.extend(compared(session, plan, group).await?);
    }
    let count = failures.len();
    let Some(first) = failures.into_iter().next() else { return Ok(()) };
    Err(match count {
        1 => first,
        _ => first.within(|why| {
            both!(
                "{count} values were changed since they were asked about, the rows say which; {why}",
                "{count} Werte wurden seit der Frage geändert, die Zeilen sagen welche; {why}",
                why
            )
        }),
    })
}

/// Looks at one place right before it is written. Behind a value that changes others nobody knows which those are (P.30: no source
/// tells), and whose doing it is.
///
/// # Errors
/// As [`still_stands`].
pub(super) async fn still_stands_at(session: &mut Session<'_>, plan: &mut Plan, index: usize) -> Result<(), Failure> {
    if plan.altering().next().is_some() {
        return Ok(());
    }
    compared(session, plan, vec![index]).await?.into_iter().next().map_or(Ok(()), Err)
}

/// What stands at the data sets of a parameter, or why it is not told.
type Now = BTreeMap<u8, Result<i64, Failure>>;

/// What changed at these places of one parameter.
async fn compared(session: &mut Session<'_>, plan: &mut Plan, group: Vec<usize>) -> Result<Vec<Failure>, Failure> {
    let mut failures = Vec::new();
    let steps: Vec<(usize, Step)> =
        group.into_iter().filter_map(|index| Some((index, plan.job.steps.get(index)?.clone()))).collect();
    let Some(param) = steps.first().map(|(_, step)| step.param.clone()) else { return Ok(failures) };
    let sets: Vec<u8> = steps.iter().map(|(_, step)| step.set).collect();
    let target = &mut plan.job.target;
    let mut now: Now = stands(session, target, &param, &sets).await?.into_iter().collect();
    now.extend(ram_stands(session, target, &param, &sets).await?);
    for (index, step) in &steps {
        // What goes into the RAM by itself has a row of its own.
        let has_row = |kept: &Kept| plan.job.steps.iter().any(|own| kept.is_of(own));
        let behind: Vec<Kept> = plan.behind(step).filter(|kept| !has_row(kept)).cloned().collect();
        let Some(row) = plan.job.rows.get_mut(*index) else { continue };
        failures.extend(changed(row, step, &behind, &now));
    }
    Ok(failures)
}

/// What stands at a place or behind it in the RAM, if that is not what was planned with, or why it is not told.
fn changed(row: &mut Written, step: &Step, behind: &[Kept], now: &Now) -> Option<Failure> {
    // Four that differed may be told as one by now.
    let found = |set: u8| now.get(&set).or_else(|| now.get(&(set - set % DataSets::RAM_OFFSET)));
    let told = |set: u8| found(set).and_then(|told| told.as_ref().ok()).copied();
    let stored = row.old_raw.map(|raw| (step.set, raw));
    let planned = stored.into_iter().chain(behind.iter().map(|kept| (kept.set, kept.raw)));
    let (set, then) = planned.into_iter().find(|(set, raw)| told(*set) != Some(*raw))?;
    let failure = match found(set) {
        Some(Err(refused)) => refused.clone(),
        _ => not_as_planned(step, (set, then), told),
    };
    (row.result, row.error) = (WriteResult::Skipped, Some(ErrorDoc::from(&failure)));
    Some(failure)
}

fn not_as_planned(step: &Step, (set, then): (u8, i64), told: impl Fn(u8) -> Option<i64>) -> Failure {
    // Where all four were told as one, it is one of them now.
    let single = || (set + 1..=set + 4).filter(|_| set.is_multiple_of(5)).filter_map(|set| Some((set, told(set)?)));
    let found = told(set).map(|raw| (set, raw)).or_else(|| single().find(|(_, raw)| *raw != then));
    let at = Step { set: found.map_or(set, |(set, _)| set), ..step.clone() };
    let now = found.map_or_else(|| "?".to_owned(), |(_, raw)| value_text(&step.param, raw));
    let ram = if set >= DataSets::RAM_OFFSET { " (RAM)" } else { "" };
    let message = both!(
        "{label}{ram} was {then} when it was asked about, and is {now} now",
        "{label}{ram} war {then}, als danach gefragt wurde, und ist jetzt {now}",
        label = place(&at),
        then = value_text(&step.param, then)
    );
    Failure::new(Class::Forbidden, "forbidden.changed_meanwhile", message).with("param", step.param.id).hint(both!(
            "somebody else writes it too, or the drive lost its power; the same command again shows what stands there now, and asks again",
            "jemand anders schreibt ihn auch, oder der Antrieb war ohne Spannung; derselbe Befehl zeigt, was jetzt dort steht, und fragt noch \
             einmal"
    ))
}

impl Plan {
    /// Numbers of what was written and changes others.
    pub(super) fn altering(&self) -> impl Iterator<Item = u32> {
        let rules = &self.job.target.family.files;
        let touched = self.job.steps.iter().zip(&self.job.rows).filter(|(_, row)| is_touched(row));
        touched.map(|(step, _)| step.param.id).filter(|id| rules.altered_by(*id).next().is_some())
    }

    /// Whether a value can be the doing of this transaction, of the drive behind it, or of a power loss.
    fn is_own(&self, place: &Kept, now: i64) -> bool {
        let Kept { param, set, raw } = place;
        let rules = &self.job.target.family.files;
        let is_of = |step: &Step| step.param.id == param.id && (covers(step.set, *set) || lies_behind(*set, step.set));
        let alters = |id| rules.altered_by(id).any(|altered| altered == param.id);
        // What else such a value changes is in no source; what was written behind it is known.
        let is_written = |(step, row): (&Step, &Written)| is_touched(row) && is_of(step);
        let rows = || self.job.steps.iter().zip(&self.job.rows);
        // What a drive makes of a value that it does not take as it is nobody else has written.
        let by_row = |(step, row): (&Step, &Written)| {
            is_of(step) && (step.raw == now || row.old_raw == Some(now) || row.result == WriteResult::Differs)
        };
        let stood = |kept: &Kept| kept.param.id == param.id && covers(kept.set, *set) && kept.raw == now;
        let loses = |kept: &Kept| kept.param.id == param.id && lies_behind(*set, kept.set) && kept.raw == now;
        now == *raw
            || self.altering().any(alters)
            || self.altering().next().is_some() && !rows().any(is_written)
            || rows().any(by_row)
            || self.in_force.iter().any(stood)
            || self.beneath.iter().any(loses)
    }
}

/// Whether a place is in the RAM, and this stored one beneath it.
fn lies_behind(set: u8, stored: u8) -> bool {
    set >= DataSets::RAM_OFFSET && stored < DataSets::RAM_OFFSET && (is_behind(set, stored) || set.is_multiple_of(5))
}

/// Refuses to write over what somebody else has set since, also in the RAM, over which a write to the EEPROM goes too.
///
/// # Errors
/// It is somebody else's, or the RAM does not come.
pub(super) async fn is_ours(session: &mut Session<'_>, plan: &mut Plan, place: &Kept, now: i64) -> Result<(), Failure> {
    let beneath = in_ram(session, &mut plan.job.target, &place.param, &[place.set]).await?;
    let all = [(place.set, now)].into_iter().chain(beneath);
    let mut kept = all.map(|(set, now)| (Kept { set, ..place.clone() }, now));
    kept.find(|(kept, now)| !plan.is_own(kept, *now)).map_or(Ok(()), |(kept, now)| Err(theirs(&kept, now)))
}

/// The code of a value that stays, because somebody has changed it since.
pub const THEIRS: &str = "partial.changed_since";

fn theirs(kept: &Kept, now: i64) -> Failure {
    let ram = if kept.set >= DataSets::RAM_OFFSET { "ram" } else { "" };
    let message = both!(
        "{label}@{set}{ram} reads as {now}, which is not what was written and not what stood there before ({before}): somebody has \
         changed it since, and it stays",
        "{label}@{set}{ram} liest sich als {now}; das wurde nicht geschrieben und stand vorher nicht dort ({before}): jemand hat es \
         seitdem geändert, und es bleibt",
        label = kept.param.label(),
        set = kept.set % 5,
        now = value_text(&kept.param, now),
        before = value_text(&kept.param, kept.raw)
    );
    Failure::new(Class::Partial, THEIRS, message).with("param", kept.param.id).hint(both!(
        "`antrieb dataset undo` with --force takes it back all the same",
        "`antrieb dataset undo` mit --force nimmt es trotzdem zurück"
    ))
}

/// Looks whether what was agreed to may still be begun: the drive does not run, and what the plan was made of stands.
///
/// # Errors
/// It may not, or the drive does not answer.
pub async fn still_may(session: &mut Session<'_>, plan: &mut Plan) -> Result<(), Failure> {
    standstill(session, &mut plan.job.target).await?;
    still_stands(session, plan).await
}
