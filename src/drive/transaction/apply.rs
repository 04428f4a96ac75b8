//! Writing a plan: value by value, each proven, all proven once more at the end; and back, if anything goes wrong.

use super::back::put_back;
use super::plan::{Kept, Plan, is_touched, standstill};
use super::reading::stands_at;
use super::undo_file::UndoFile;
use crate::drive::job::{self, Step};
use crate::drive::{Session, Terms};
use crate::failure::{Class, Failure};
use crate::gate::{Permit, Writing};
use crate::outcome::{ErrorDoc, Event, WriteResult, Written};
use crate::profile::DataSets;
use crate::profile::value::format_decimal;
use crate::text::{Text, both};

/// So often everything in the RAM is asked again at most, until it is told without a gap.
const PROOFS: usize = 6;

/// How a transaction ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
    /// Everything is as it was wanted.
    Done,
    /// Nothing was written.
    Untouched,
    /// Everything is as it was before, proven.
    Back,
    /// Some of it is not as it was before, or nobody knows; the rows say which.
    Torn,
}

/// What became of a transaction.
#[derive(Debug)]
pub struct Applied {
    /// How it ended.
    pub ended: Ended,
    /// Why it did not end well: first what went wrong, then what could not be put back.
    pub failures: Vec<Failure>,
    /// What the drive changed by itself.
    pub notes: Vec<Text>,
}

/// Writes what is planned. Whatever ends it early, what was written goes back; the rows say what became of each value.
///
/// The undo file has been left, or nothing could be taken back by who comes later.
pub async fn apply(
    session: &mut Session<'_>,
    plan: &mut Plan,
    terms: &Terms<'_>,
    permit: &Permit<Writing>,
    _left: &UndoFile,
) -> Applied {
    // At the question somebody may have started it.
    let went = match standstill(session, &mut plan.job.target).await {
        Err(failure) => Err(failure),
        Ok(()) => forward(session, plan, terms, permit).await,
    };
    let failure = match went {
        Ok(notes) => return Applied { ended: Ended::Done, failures: Vec::new(), notes },
        Err(failure) => failure,
    };
    for row in plan.job.rows.iter_mut().filter(|row| row.result == WriteResult::Planned) {
        row.result = WriteResult::Skipped;
    }
    if !plan.job.rows.iter().any(is_touched) {
        return Applied { ended: Ended::Untouched, failures: vec![failure], notes: Vec::new() };
    }
    let mut failures = vec![failure];
    failures.extend(put_back(session, plan, permit, &failures[..]).await);
    let was_written = plan.job.rows.iter().any(|row| row.result == WriteResult::Restored);
    let ended = match (failures.len(), was_written) {
        (1, true) => Ended::Back,
        (1, false) => Ended::Untouched,
        _ => Ended::Torn,
    };
    Applied { ended, failures, notes: Vec::new() }
}

/// Writes value by value and proves everything; tells what the drive changed by itself.
async fn forward(
    session: &mut Session<'_>,
    plan: &mut Plan,
    terms: &Terms<'_>,
    permit: &Permit<Writing>,
) -> Result<Vec<Text>, Failure> {
    let total = plan.todo() as u64;
    let mut done = 0;
    for index in 0..plan.job.steps.len() {
        let job = &mut plan.job;
        let (Some(step), Some(row)) = (job.steps.get(index), job.rows.get_mut(index)) else { break };
        if row.result != WriteResult::Planned {
            continue;
        }
        session.tell(writing(done, total, step));
        done += 1;
        let failure = job::carry_step(session, &mut job.target, step, row, terms, permit).await;
        if let Some(failure) = failure.or_else(|| unproven(row)) {
            return Err(of(step, failure));
        }
        look_again(session, plan, index).await?;
    }
    // The proof comes last: nothing is asked behind it that could find the drive restarted.
    let mut notes = altered(session, plan).await;
    if let Err(failure) = standstill(session, &mut plan.job.target).await
        && failure.class == Class::Forbidden
    {
        notes.push(runs_now(plan.job.target.address));
    }
    prove(session, plan).await.map(|()| notes)
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
    let (label, set) = (step.param.label(), step.set % 5);
    let place = if set == 0 { label } else { format!("{label}@{set}") };
    Failure { message: both!("{place}: {why}", "{place}: {why}", why = failure.message), ..failure }
}

/// A transaction believes nothing that could not be read back.
fn unproven(row: &mut Written) -> Option<Failure> {
    if row.result == WriteResult::Verified {
        return None;
    }
    let message = both!("P.{param} could not be read back", "P.{param} ließ sich nicht zurücklesen", param = row.param);
    let failure = Failure::new(Class::Garbled, "garbled.unproven", message).with("param", row.param);
    row.error = Some(ErrorDoc::from(&failure));
    Some(failure)
}

/// What the drive changes by itself behind this write is read again: it decides what is left to do.
async fn look_again(session: &mut Session<'_>, plan: &mut Plan, written: usize) -> Result<(), Failure> {
    let Some(id) = plan.job.steps.get(written).map(|step| step.param.id) else { return Ok(()) };
    let altered: Vec<u32> = plan.job.target.family.files.altered_by(id).collect();
    let job = &mut plan.job;
    for (step, row) in job.steps.iter().zip(&mut job.rows).skip(written + 1) {
        if altered.contains(&step.param.id) {
            let now = stands_at(session, &mut job.target, &step.param, step.set).await?;
            row.result = if now == step.raw { WriteResult::Unchanged } else { WriteResult::Planned };
        }
    }
    Ok(())
}

/// Proves once more what was promised: power that failed for a moment takes back what went into the RAM, and a drive may
/// change what it was told before. In the RAM all values must be told without a gap: behind a missing answer, which may be a
/// restart, it begins anew.
async fn prove(session: &mut Session<'_>, plan: &mut Plan) -> Result<(), Failure> {
    let in_ram = plan.job.steps.iter().any(|step| step.set >= DataSets::RAM_OFFSET);
    let all = in_ram || !plan.watched.is_empty();
    let is_due = |row: &Written| row.result == WriteResult::Verified || (all && row.result == WriteResult::Unchanged);
    let due: Vec<usize> = (0..).zip(&plan.job.rows).filter(|(_, row)| is_due(row)).map(|(index, _)| index).collect();
    let (mut told, most) = (0, due.len() * PROOFS);
    for index in due.iter().copied().cycle().take(most) {
        let repeats = session.tally().repeats;
        let job = &mut plan.job;
        let (Some(step), Some(row)) = (job.steps.get(index), job.rows.get_mut(index)) else { break };
        let wrong = match stands_at(session, &mut job.target, &step.param, step.set).await {
            Ok(now) if now == step.raw => {
                told = if in_ram && session.tally().repeats > repeats { 1 } else { told + 1 };
                if told == due.len() {
                    return Ok(());
                }
                continue;
            }
            Ok(now) => changed_since(step, now),
            Err(failure) => failure,
        };
        // What was not written stays so; what was is put back.
        row.result = if row.result == WriteResult::Unchanged { WriteResult::Skipped } else { WriteResult::Differs };
        row.error = Some(ErrorDoc::from(&wrong));
        return Err(wrong);
    }
    if due.is_empty() { Ok(()) } else { Err(unsteady()) }
}

/// The failure of a line over which nothing can be proven of a RAM.
fn unsteady() -> Failure {
    let message = both!(
        "so many answers are missing that nobody knows whether the drive restarted meanwhile",
        "so viele Antworten fehlen, dass offen ist, ob der Antrieb zwischendurch neu gestartet ist"
    );
    Failure::new(Class::Garbled, "garbled.unsteady", message)
}

fn changed_since(step: &Step, now: i64) -> Failure {
    let now = format_decimal(now, step.param.decimals_or_zero());
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
            let shown = |raw| format_decimal(raw, param.decimals_or_zero());
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

fn writing(done: u64, total: u64, step: &Step) -> Event {
    Event::Progress {
        done,
        total,
        what: both!("writing {label}", "{label} wird geschrieben", label = step.param.label()),
    }
}
