//! The way back: what was touched is brought to the value that it had before, proven; what could not be is named.
//!
//! At once, when a transaction fails ([`put_back`]), or later, from its undo file ([`undo`]).

use super::plan::{Kept, Plan, is_touched, standstill};
use super::reading::stands_at;
use crate::drive::{Order, Session, WriteFate, is_over};
use crate::failure::{Class, Failure};
use crate::gate::{Permit, Writing};
use crate::outcome::{ErrorDoc, Event, WriteResult};
use crate::profile::{DataSets, FileRules, Role};
use crate::text::both;
use crate::tick::Span;
use std::cmp::Reverse;

/// A drive that restarts answers again "after a few seconds" (CM-485 manual 5.2.1); so long it is waited for.
const LONGEST_RESTART: Span = Span::from_secs(15);
/// Between two looks for it.
const PAUSE: Span = Span::from_millis(500);
/// So many values in a row without an answer tell that nobody is there.
const NOBODY_AFTER: usize = 3;

/// Puts back what was touched and says what could not be: a failure for each.
pub(super) async fn put_back(
    session: &mut Session<'_>,
    plan: &mut Plan,
    permit: &Permit<Writing>,
    why: &[Failure],
) -> Vec<Failure> {
    // Whoever interrupted wants this; who does it again ends it.
    session.note_interrupts();
    session.tell(Event::Note(both!("putting back what was written", "was geschrieben wurde, wird zurückgenommen")));
    let is_silent = why.iter().any(|failure| matches!(failure.class, Class::Silence | Class::Garbled));
    let nobody = is_silent && !await_return(session, plan).await;
    let order = back_order(plan);
    match nobody {
        true => order.iter().filter_map(|kept| told(plan, kept, Err(left(kept)))).collect(),
        false => restore_all(session, plan, &order, permit).await,
    }
}

/// Brings these values back in this order, and proves all of them at the end: a failure for each that did not come back.
async fn restore_all(
    session: &mut Session<'_>,
    plan: &mut Plan,
    order: &[Kept],
    permit: &Permit<Writing>,
) -> Vec<Failure> {
    let (mut failures, mut silences, mut over) = (Vec::new(), 0, false);
    for (done, kept) in (0..).zip(order) {
        session.tell(restoring(done, order.len() as u64, kept));
        let result = match over || silences >= NOBODY_AFTER {
            true => Err(left(kept)),
            false => restore(session, plan, kept, permit).await,
        };
        silences = match &result {
            Err(failure) if failure.class == Class::Silence => silences + 1,
            _ if silences >= NOBODY_AFTER => silences,
            _ => 0,
        };
        over |= result.as_ref().is_err_and(is_over);
        failures.extend(told(plan, kept, result));
    }
    if failures.is_empty() {
        for kept in order {
            if over || silences >= NOBODY_AFTER {
                failures.extend(told(plan, kept, Err(left(kept))));
                continue;
            }
            let result = match stands_at(session, &mut plan.job.target, &kept.param, kept.set).await {
                Ok(now) if now == kept.raw => continue,
                Ok(_) => Err(left(kept)),
                Err(failure) => Err(failure),
            };
            silences += usize::from(result.as_ref().is_err_and(|failure| failure.class == Class::Silence));
            over |= result.as_ref().is_err_and(is_over);
            failures.extend(told(plan, kept, result));
        }
    }
    failures
}

/// Waits for a drive that does not answer: perhaps it restarts. Asked is now this, now that, each once: no telegram goes out
/// more than three times (sources A2). Tells whether anybody is there.
async fn await_return(session: &mut Session<'_>, plan: &mut Plan) -> bool {
    let until = session.now() + LONGEST_RESTART;
    let target = &mut plan.job.target;
    let status = target.family.role(Role::StatusWord).cloned();
    let first = plan.job.steps.first().map(|step| (step.param.clone(), step.set));
    let places: Vec<_> = status.map(|param| (param, 0)).into_iter().chain(first).collect();
    let retries = session.set_retries(0);
    let mut is_there = false;
    for (param, set) in places.iter().cycle() {
        let found = stands_at(session, target, param, *set).await;
        is_there = !found.is_err_and(|failure| matches!(failure.class, Class::Silence | Class::Garbled));
        if is_there || session.now() >= until || session.rest(PAUSE).await.is_err() {
            break;
        }
    }
    session.set_retries(retries);
    is_there
}

/// What is put back, in its order: first what can start a shaft, then what the rest depends on, then the rest from its end.
fn back_order(plan: &Plan) -> Vec<Kept> {
    let rules = &plan.job.target.family.files;
    let rows = plan.job.steps.iter().zip(&plan.job.rows).filter(|(_, row)| is_touched(row));
    let mut order: Vec<Kept> = rows
        .filter_map(|(step, row)| Some(Kept { param: step.param.clone(), set: step.set, raw: row.old_raw? }))
        .collect();
    let named: Vec<(u32, u8)> = order.iter().map(|kept| (kept.param.id, kept.set)).collect();
    let touches = |kept: &&Kept| {
        let by_touched = named.iter().any(|(id, _)| rules.altered_by(*id).any(|altered| altered == kept.param.id));
        by_touched && !named.contains(&(kept.param.id, kept.set))
    };
    order.extend(plan.watched.iter().filter(touches).cloned());
    let behind = |kept: &Kept| [0, kept.set - DataSets::RAM_OFFSET].map(|set| (kept.param.id, set));
    let is_over_written = |kept: &&Kept| behind(kept).iter().any(|place| named.contains(place));
    order.extend(plan.in_force.iter().filter(is_over_written).cloned());
    back_sorted(order, rules)
}

/// The order of putting back: what is stored before what was in force over it.
fn back_sorted(mut order: Vec<Kept>, rules: &FileRules) -> Vec<Kept> {
    let ram = DataSets::RAM_OFFSET;
    let rank = |kept: &Kept| rules.rank(&kept.param, kept.set % ram);
    let stage = |kept: &Kept| match rank(kept).0 {
        0 => 1,
        1 | 2 => 2,
        _ => 0,
    };
    order.sort_by_key(|kept| (stage(kept), Reverse(rank(kept)), kept.set >= ram));
    order
}

/// How a value came to be as before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Came {
    /// It was.
    Stood,
    /// It was written.
    Back,
}

/// Brings one value back, unless it stands there already.
async fn restore(
    session: &mut Session<'_>,
    plan: &mut Plan,
    kept: &Kept,
    permit: &Permit<Writing>,
) -> Result<Came, Failure> {
    let Kept { param, set, raw } = kept;
    let target = &mut plan.job.target;
    if stands_at(session, target, param, *set).await? == *raw {
        return Ok(Came::Stood);
    }
    let address = target.address;
    let kind = target.width(session, param, *set).await;
    let fate = match kind {
        Ok(kind) => target.write(session, param, Order { set: *set, raw: *raw, kind, read_back: true }, permit).await,
        Err(error) => Err(error),
    };
    match fate {
        Ok(WriteFate::Verified) => Ok(Came::Back),
        Ok(WriteFate::Unknown(error)) | Err(error) => {
            Err(error.failure(address, Some(&target.family)).with("param", param.id))
        }
        Ok(WriteFate::Written | WriteFate::Differs(_) | WriteFate::Broadcast) => Err(left(kept)),
    }
}

fn left(kept: &Kept) -> Failure {
    let message = both!("{label} was not put back", "{label} wurde nicht zurückgenommen", label = kept.param.label());
    Failure::new(Class::Partial, "partial.not_put_back", message).with("param", kept.param.id)
}

/// Says in the row what became of putting it back.
fn told(plan: &mut Plan, kept: &Kept, result: Result<Came, Failure>) -> Option<Failure> {
    let job = &mut plan.job;
    let mut rows = job.steps.iter().zip(&mut job.rows);
    let row = rows.find(|(step, _)| (step.param.id, step.set) == (kept.param.id, kept.set)).map(|(_, row)| row);
    match (result, row) {
        (Ok(came), Some(row)) => {
            // What the drive refused was never another value, and what nobody touched stays so.
            let is_as_it_was = came == Came::Stood && row.result == WriteResult::Unchanged;
            let keeps = is_as_it_was || row.result == WriteResult::Refused;
            row.result = if keeps { row.result } else { WriteResult::Restored };
            None
        }
        (Ok(_), None) => None,
        (Err(failure), row) => {
            let label = kept.param.label();
            let failure = Failure {
                message: both!(
                    "{label}@{set} may not be as before: {why}",
                    "{label}@{set} ist vielleicht nicht wie vorher: {why}",
                    set = kept.set % 5,
                    why = failure.message
                ),
                ..failure
            };
            if let Some(row) = row {
                row.result = WriteResult::Unrestored;
                row.error = Some(ErrorDoc::from(&failure));
            }
            Some(failure)
        }
    }
}

/// What became of taking a transaction back.
#[derive(Debug)]
pub struct Restored {
    /// A failure for each value that is not as it was.
    pub failures: Vec<Failure>,
}

/// Takes back what an undo file states: each planned value is brought back, proven. What fails does not stop the others.
pub async fn undo(session: &mut Session<'_>, plan: &mut Plan, permit: &Permit<Writing>) -> Restored {
    if let Err(failure) = standstill(session, &mut plan.job.target).await {
        for row in plan.job.rows.iter_mut().filter(|row| row.result == WriteResult::Planned) {
            row.result = WriteResult::Skipped;
        }
        return Restored { failures: vec![failure] };
    }
    let rows = plan.job.steps.iter().zip(&plan.job.rows);
    let todo = rows.filter(|(_, row)| matches!(row.result, WriteResult::Planned | WriteResult::Unchanged));
    let order = todo.map(|(step, _)| Kept { param: step.param.clone(), set: step.set, raw: step.raw }).collect();
    let order = back_sorted(order, &plan.job.target.family.files);
    Restored { failures: restore_all(session, plan, &order, permit).await }
}

fn restoring(done: u64, total: u64, kept: &Kept) -> Event {
    let what = both!("putting back {label}", "{label} wird zurückgenommen", label = kept.param.label());
    Event::Progress { done, total, what }
}
