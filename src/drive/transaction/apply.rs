//! Writing a plan: value by value, each proven, all proven once more at the end; and back, if anything goes wrong.

use super::back::put_back;
use super::choice::in_sets;
use super::ended::{Applied, untouched};
use super::meanwhile::{still_equal, still_stands, still_stands_at};
use super::plan::{Kept, Plan, is_touched};
use super::progress::{Doing, progress};
use super::proof::{in_force, look};
use super::running::standstill;
use super::undo_file::UndoFile;
use super::weigh::place;
use crate::drive::job::{self, Job, Step};
use crate::drive::stands::{has_ram, in_ram, stands_at};
use crate::drive::{Session, Terms};
use crate::failure::{Class, Failure};
use crate::gate::{Permit, Writing};
use crate::outcome::{ErrorDoc, LoadEnd, WriteResult, Written};
use crate::profile::DataSets;
use crate::profile::value;
use crate::text::{Text, both};

/// Writes what is planned. Whatever ends it early, what was written goes back; the rows say what became of each value.
///
/// The undo file has been left, or nothing could be taken back by who comes later.
pub async fn apply(
    session: &mut Session<'_>,
    plan: &mut Plan,
    terms: &Terms<'_>,
    permit: &Permit<Writing>,
    left: &UndoFile,
) -> Applied {
    // At the question somebody may have changed something.
    let went = match still_stands(session, plan).await {
        Err(failure) => Err(failure),
        Ok(()) => forward(session, plan, terms, permit).await,
    };
    let failure = match went {
        Ok(applied) => return applied,
        Err(failure) => failure,
    };
    let Applied { mut failures, .. } = untouched(plan, failure);
    if !plan.job.rows.iter().any(is_touched) {
        return Applied { ended: LoadEnd::Untouched, failures, notes: Vec::new() };
    }
    failures.extend(put_back(session, plan, permit, &failures[..], left).await);
    let was_written = plan.job.rows.iter().any(|row| row.result == WriteResult::Restored);
    let ended = match (failures.len(), was_written) {
        (1, true) => LoadEnd::Back,
        (1, false) => LoadEnd::Untouched,
        _ => LoadEnd::Torn,
    };
    Applied { ended, failures, notes: Vec::new() }
}

/// Writes value by value and proves everything; tells what the drive changed by itself.
async fn forward(
    session: &mut Session<'_>,
    plan: &mut Plan,
    terms: &Terms<'_>,
    permit: &Permit<Writing>,
) -> Result<Applied, Failure> {
    let total = plan.todo();
    let mut done = 0;
    for index in 0..plan.job.steps.len() {
        let Some(step) = plan.job.steps.get(index).cloned() else { break };
        let is_planned = |row: &Written| row.result == WriteResult::Planned;
        if !plan.job.rows.get(index).is_some_and(is_planned) {
            continue;
        }
        session.tell(progress(Doing::Writes, done, total, &step.param));
        done += 1;
        // Somebody may change it, or start the shaft, at any moment.
        still_stands_at(session, plan, index).await?;
        plan.shaft.allows(session, &mut plan.job.target, &step.param).await?;
        plan.shaft.writes(&plan.job.target, &step.param);
        let Some(row) = plan.job.rows.get_mut(index) else { break };
        let failure = job::carry_step(session, &mut plan.job.target, &step, row, terms, permit).await;
        let result = row.result;
        if let Some(failure) = failure.or_else(|| unproven(&step, row)) {
            plan.doubt(&step, result, &failure);
            return Err(of(&step, failure));
        }
        look_again(session, plan, index).await?;
    }
    let mut notes = altered(session, plan).await;
    if let Err(failure) = standstill(session, &mut plan.job.target).await
        && failure.class == Class::Forbidden
    {
        notes.push(runs_now(plan.job.target.address));
    }
    let failures = in_force(session, plan).await?;
    still_equal(session, plan).await?;
    // The proof comes last: nothing is asked behind it that could find the drive restarted.
    prove(session, plan).await?;
    let ended = if failures.is_empty() { LoadEnd::Done } else { LoadEnd::Stored };
    Ok(Applied { ended, failures, notes })
}

/// What was asked about as MOTION has come: with its new values the drive runs.
fn runs_now(address: u8) -> Text {
    both!(
        "drive {address} RUNS with its new values: what starts it (contacts, control word) stands already; `antrieb statemachine \
         disable` stops it",
        "Antrieb {address} LÄUFT mit den neuen Werten: was ihn startet (Kontakte, Steuerwort), steht schon an; `antrieb \
         statemachine disable` hält ihn an"
    )
}

/// The failure with the place that it is about.
fn of(step: &Step, failure: Failure) -> Failure {
    let place = place(step);
    failure.within(|why| both!("{place}: {why}", "{place}: {why}", why))
}

/// A transaction believes nothing that could not be read back.
fn unproven(step: &Step, row: &mut Written) -> Option<Failure> {
    if row.result == WriteResult::Verified {
        return None;
    }
    let message = if step.set.is_multiple_of(DataSets::RAM_OFFSET) && in_sets(&step.param) {
        both!(
            "the drive took it and refuses to tell it for all data sets at once: they may differ",
            "der Antrieb hat es angenommen und sagt es nicht für alle Datensätze zugleich: sie können sich unterscheiden"
        )
    } else {
        both!(
            "the drive took it and refuses to be read back",
            "der Antrieb hat es angenommen und lässt sich nicht zurücklesen"
        )
    };
    let failure = Failure::new(Class::Garbled, "garbled.unproven", message).with("param", row.param);
    row.error = Some(ErrorDoc::from(&failure));
    Some(failure)
}

impl Plan {
    /// Where the EEPROM did not take a value, the RAM may have: of a drive that does not show it, nobody knows.
    fn doubt(&mut self, step: &Step, result: WriteResult, failure: &Failure) {
        let is_hidden = has_ram(&self.job.target, &step.param, step.set) && self.behind(step).next().is_none();
        if is_hidden && (job::eeprom_failed(failure) || result == WriteResult::Differs) {
            self.blind.push(Kept::wanted(step));
        }
    }
}

/// What the drive changes by itself behind this write is read again: it decides what is left to do.
async fn look_again(session: &mut Session<'_>, plan: &mut Plan, written: usize) -> Result<(), Failure> {
    let Some(id) = plan.job.steps.get(written).map(|step| step.param.id) else { return Ok(()) };
    let altered: Vec<u32> = plan.job.target.family.files.altered_by(id).collect();
    let job = &mut plan.job;
    for (step, row) in job.steps.iter().zip(&mut job.rows).skip(written + 1) {
        if altered.contains(&step.param.id) {
            let now = stands_at(session, &mut job.target, &step.param, step.set).await?;
            let in_force = in_ram(session, &mut job.target, &step.param, &[step.set]).await?;
            let is_there = now == step.raw && in_force.iter().all(|(_, raw)| *raw == step.raw);
            row.result = if is_there { WriteResult::Unchanged } else { WriteResult::Planned };
        }
    }
    Ok(())
}

/// Proves once more what was promised: power that failed for a moment takes back what went into the RAM, and a drive may
/// change what it was told before.
async fn prove(session: &mut Session<'_>, plan: &mut Plan) -> Result<(), Failure> {
    let is_due = |(step, row): (&Step, &Written)| match row.result {
        WriteResult::Verified | WriteResult::Stored => true,
        WriteResult::Unchanged => step.set >= DataSets::RAM_OFFSET,
        _ => false,
    };
    let Job { target, steps, rows } = &mut plan.job;
    let all = (0..).zip(steps.iter().zip(rows.iter()));
    let due: Vec<usize> = all.filter(|(_, pair)| is_due(*pair)).map(|(index, _)| index).collect();
    let of = |index: &usize| steps.get(*index).map(Kept::wanted);
    let places: Vec<Kept> = due.iter().filter_map(of).collect();
    let mut wrong = None;
    let looked = look(session, target, &places, |nth, now| {
        wrong = match (now, due.get(nth).and_then(|index| Some((steps.get(*index)?, rows.get_mut(*index)?)))) {
            (Ok(now), Some((step, _))) if now == step.raw => None,
            (now, Some((step, row))) => {
                let failure = now.map_or_else(|failure| failure, |now| changed_since(step, now));
                // What was not written stays so; what was is put back.
                let was_written = row.result != WriteResult::Unchanged;
                row.result = if was_written { row.result } else { WriteResult::Skipped };
                row.error = Some(ErrorDoc::from(&failure));
                Some(failure)
            }
            _ => None,
        };
        wrong.is_none()
    });
    looked.await?;
    wrong.map_or(Ok(()), Err)
}

fn changed_since(step: &Step, now: i64) -> Failure {
    let now = value::written(&step.param, now);
    let message = both!(
        "{label} was written and proven, and reads as {now} at the end",
        "{label} wurde geschrieben und geprüft und liest sich am Ende als {now}",
        label = step.param.label()
    );
    Failure::new(Class::Refused, "refused.changed_since", message).with("param", step.param.id).hint(both!(
        "the drive lost its power for a moment, changed it with another value, or somebody else writes it",
        "der Antrieb war kurz ohne Spannung, hat ihn mit einem anderen Wert geändert, oder jemand anders schreibt ihn"
    ))
}

/// What the drive changed by itself, of what the file does not name.
async fn altered(session: &mut Session<'_>, plan: &mut Plan) -> Vec<Text> {
    let mut notes = Vec::new();
    let named: Vec<(u32, u8)> = plan.job.steps.iter().map(|step| (step.param.id, step.set)).collect();
    for Kept { param, set, raw } in plan.watched.clone() {
        if named.contains(&(param.id, set)) {
            continue;
        }
        if let Ok(now) = stands_at(session, &mut plan.job.target, &param, set).await
            && now != raw
        {
            let shown = |raw| value::written(&param, raw);
            notes.push(both!(
                "the drive changed {label}@{set} by itself: {old} -> {now}",
                "der Antrieb hat {label}@{set} selbst geändert: {old} -> {now}",
                label = param.label(),
                old = shown(raw),
                now = shown(now)
            ));
        }
    }
    notes
}
