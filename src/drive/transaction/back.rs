//! The way back: what was touched is brought to the value that it had before, proven; what could not be is named.
//!
//! At once, when a transaction fails ([`put_back`]), or later, from its undo file ([`undo`]).

use super::ended::{Applied, untouched};
use super::meanwhile::{THEIRS, is_ours, still_may};
use super::plan::{Kept, Plan, is_behind, is_touched};
use super::progress::{Doing, progress};
use super::proof::{in_force, look};
use super::running::RUNNING;
use super::undo_file::UndoFile;
use super::unproven::open;
use crate::drive::job::{self, Job, Step};
use crate::drive::stands::{stands, stands_at};
use crate::drive::{AccessError, Order, Session, WriteFate, is_over};
use crate::failure::{Class, Failure};
use crate::gate::{Permit, Writing};
use crate::outcome::{ErrorDoc, Event, LoadEnd, WriteResult, Written};
use crate::profile::{DataSets, FileRules, Role};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::cmp::Reverse;

/// A drive that restarts answers again "after a few seconds" (CM-485 manual 5.2.1); so long it is waited for.
pub(in crate::drive) const LONGEST_RESTART: Span = Span::from_secs(15);
/// Between two looks for it.
const PAUSE: Span = Span::from_millis(500);
/// So often what came back is looked at anew, where the drive falls silent meanwhile and comes again.
const LOOKS: usize = 3;
/// In what is known of a failure: which memory it is about.
pub const STORE: &str = "store";
/// In what is known of a failure: which parameter it is about.
const PARAM: &str = "param";
/// In what is known of a failure: of which data set it is.
pub const SET: &str = "data_set";

/// Puts back what was touched and says what could not be: a failure for each.
pub(super) async fn put_back(
    session: &mut Session<'_>,
    plan: &mut Plan,
    permit: &Permit<Writing>,
    why: &[Failure],
    left: &UndoFile,
) -> Vec<Failure> {
    // Whoever interrupted wants this; who does it again ends it.
    session.note_interrupts();
    session.tell(Event::Note(both!("putting back what was written", "was geschrieben wurde, wird zurückgenommen")));
    let is_silent = why.iter().any(is_unheard);
    let mut way = Way::default();
    let nobody = is_silent && !way.await_return(session, plan).await;
    let order = back_order(plan);
    match nobody {
        true => order.iter().filter_map(|kept| told(plan, kept, Err(unseen(kept)))).collect(),
        false => restore_all(session, plan, &order, (permit, left), way).await.failures,
    }
}

/// How far the way back came.
#[derive(Debug, Default)]
struct Way {
    /// A failure for each value that did not come back.
    failures: Vec<Failure>,
    /// Something was written.
    is_begun: bool,
    /// Why the session is over.
    over: Option<Failure>,
    /// The drive ran when something was to be written.
    runs: Option<Failure>,
    /// So long a drive that fell silent is waited for.
    until: Option<Tick>,
    /// It was waited for in vain.
    is_gone: bool,
}

impl Way {
    /// Whether asking for more is in vain.
    fn is_lost(&self) -> bool {
        self.over.is_some() || self.is_gone
    }

    fn note(&mut self, failure: Option<&Failure>) {
        if self.runs.is_none() {
            self.runs = failure.filter(|failure| failure.code == RUNNING).cloned();
        }
        if self.over.is_none() {
            self.over = failure.filter(|failure| is_over(failure)).cloned();
        }
    }

    /// Waits for a drive that does not answer: perhaps it restarts. Asked is now this, now that, each once: no telegram goes out
    /// more than three times (sources A2). Tells whether anybody is there.
    async fn await_return(&mut self, session: &mut Session<'_>, plan: &mut Plan) -> bool {
        let until = *self.until.get_or_insert(session.now() + LONGEST_RESTART);
        let target = &mut plan.job.target;
        // Not first what was asked last: the place, or the state before a write.
        let roles = [Role::Fault, Role::StatusWord].map(|role| target.family.role(role).cloned());
        let first = plan.job.steps.first().map(|step| (step.param.clone(), step.set));
        let roles: Vec<_> = roles.into_iter().flatten().map(|param| (param, 0)).collect();
        let first = first.filter(|_| roles.len() < 2);
        let places: Vec<_> = roles.into_iter().chain(first).collect();
        let retries = session.set_retries(0);
        self.is_gone = true;
        for (param, set) in places.iter().cycle() {
            let found = stands_at(session, target, param, *set).await;
            self.is_gone = found.is_err_and(|failure| is_unheard(&failure));
            if !self.is_gone || session.now() >= until || pause(session).await.is_err() {
                break;
            }
        }
        session.set_retries(retries);
        !self.is_gone
    }
}

/// Waits for the next look. That nobody on a CAN bus acknowledges what its adapter sent before is no news, and ends no wait.
async fn pause(session: &mut Session<'_>) -> Result<(), AccessError> {
    let until = session.now() + PAUSE;
    loop {
        match session.rest(until.since(session.now())).await {
            Err(error) if is_unheard(&error.failure(0, None)) && session.now() < until => {}
            Err(error) if is_unheard(&error.failure(0, None)) => return Ok(()),
            rested => return rested,
        }
    }
}

/// Whether no valid answer came, and one may come later.
fn is_unheard(failure: &Failure) -> bool {
    matches!(failure.class, Class::Silence | Class::Garbled) && !failure.is_gone()
}

/// Brings these values back in this order, and looks at all of them once more at the end: only what that look has seen is said
/// to be as before. Meanwhile the undo file names all of them as unproven, and at the end what did not come back.
async fn restore_all(
    session: &mut Session<'_>,
    plan: &mut Plan,
    order: &[Kept],
    (permit, file): (&Permit<Writing>, &UndoFile),
    mut way: Way,
) -> Way {
    let mut open = open(plan, order);
    // Where the file cannot be written the values go back all the same; what did not come is told at the end.
    let _ = file.note(&open);
    let (mut back, mut torn) = (Vec::new(), Vec::new());
    for (done, kept) in (0..).zip(order) {
        session.tell(progress(Doing::PutsBack, done, order.len(), &kept.param));
        // A drive that may tell its RAM as stored would hide from an undo what is stored, were the RAM as before.
        let in_ram = kept.set >= DataSets::RAM_OFFSET;
        let hides = |stored: &&Kept| in_ram && stored.param.id == kept.param.id && is_behind(kept.set, stored.set);
        let stays = !plan.tells_apart && torn.iter().any(hides);
        let mut result = match way.is_lost() {
            true => Err(unseen(kept)),
            false if stays => Err(left(kept)),
            false => restore(session, plan, kept, permit, &mut way.is_begun).await,
        };
        way.note(result.as_ref().err());
        if result.as_ref().is_err_and(|failure| failure.class == Class::Silence)
            && !way.is_lost()
            && way.await_return(session, plan).await
        {
            result = restore(session, plan, kept, permit, &mut way.is_begun).await;
            way.note(result.as_ref().err());
        }
        match &result {
            // Nobody can look at it.
            Ok(Came::Unseen) => {}
            Ok(Came::Stood | Came::Back) => back.push(kept.clone()),
            Err(failure) if failure.code == THEIRS => {}
            Err(failure) => {
                // What is stored as before was not written.
                open.retain(|open| failure.code != NOT_SHOWN || !open.is_at(kept));
                torn.push(kept);
            }
        }
        way.failures.extend(told(plan, kept, result));
    }
    let seen = look_back(session, plan, &back, &mut way).await;
    let proven: Vec<&Kept> = back.iter().zip(&seen).filter(|(_, seen)| seen.is_ok()).map(|(kept, _)| kept).collect();
    way.failures.extend(file.strike(&open, &proven).err());
    let wrong = back.iter().zip(seen).filter_map(|(kept, seen)| told(plan, kept, Err(seen.err()?)));
    way.failures.extend(wrong);
    way
}

/// Looks at all that came back, and once more from the beginning where the drive fell silent and came again.
async fn look_back(
    session: &mut Session<'_>,
    plan: &mut Plan,
    back: &[Kept],
    way: &mut Way,
) -> Vec<Result<(), Failure>> {
    let mut seen: Vec<Result<(), Failure>> = back.iter().map(|kept| Err(unseen(kept))).collect();
    for round in 1..=LOOKS {
        if way.is_lost() {
            break;
        }
        let mut falls_silent = false;
        let looked = look(session, &mut plan.job.target, back, |index, now| {
            way.note(now.as_ref().err());
            let is_silent = now.as_ref().is_err_and(|failure| failure.class == Class::Silence);
            falls_silent = is_silent && round < LOOKS;
            if let Some((kept, seen)) = back.get(index).zip(seen.get_mut(index)) {
                *seen = now.and_then(|now| if now == kept.raw { Ok(()) } else { Err(left(kept)) });
            }
            !way.is_lost() && !falls_silent
        });
        let looked = looked.await;
        if falls_silent && !way.is_lost() {
            way.await_return(session, plan).await;
            continue;
        }
        if let Err(failure) = looked {
            // What is stored does not go with the power.
            let in_ram = back.iter().zip(&mut seen).filter(|(kept, _)| kept.set >= DataSets::RAM_OFFSET);
            in_ram.for_each(|(_, seen)| *seen = Err(failure.clone()));
        }
        break;
    }
    seen
}

/// What is put back, in its order: first what can start a shaft, then what the rest depends on, then the rest from its end.
fn back_order(plan: &Plan) -> Vec<Kept> {
    let rules = &plan.job.target.family.files;
    // What else a value changes that changes others, no source tells: all of the plan is looked at.
    let any = plan.altering().next().is_some();
    // Whatever ended the load may have taken from the RAM what nobody touched.
    let is_due = |(step, row): &(&job::Step, &Written)| any || is_touched(row) || step.set >= DataSets::RAM_OFFSET;
    let rows = plan.job.steps.iter().zip(&plan.job.rows).filter(is_due);
    let mut order: Vec<Kept> = rows
        .filter_map(|(step, row)| Some(Kept { param: step.param.clone(), set: step.set, raw: row.old_raw? }))
        .collect();
    let named: Vec<(u32, u8)> = order.iter().map(|kept| (kept.param.id, kept.set)).collect();
    let touches = |kept: &&Kept| {
        let by_touched = named.iter().any(|(id, _)| rules.altered_by(*id).any(|altered| altered == kept.param.id));
        by_touched && !named.contains(&(kept.param.id, kept.set))
    };
    order.extend(plan.watched.iter().filter(touches).cloned());
    // What is stored takes the RAM with it, there and back; and what it held besides goes with the power.
    let rows = || plan.job.steps.iter().zip(&plan.job.rows);
    for (step, row) in rows() {
        let is_due = |kept: &&Kept| any || is_touched(row) || row.old_raw != Some(kept.raw);
        order.extend(plan.behind(step).filter(is_due).cloned());
    }
    back_sorted(order, rules)
}

/// The order of putting back: what is stored before what was in force over it, whichever data sets either stands for.
fn back_sorted(mut order: Vec<Kept>, rules: &FileRules) -> Vec<Kept> {
    let ram = DataSets::RAM_OFFSET;
    let rank = |kept: &Kept| rules.rank(&kept.param, kept.set % ram);
    let stage = |kept: &Kept| match rank(kept).0 {
        0 => 1,
        1 | 2 => 2,
        _ => 0,
    };
    order.sort_by_key(|kept| (stage(kept), kept.set >= ram, !rules.frees(&kept.param, kept.raw), Reverse(rank(kept))));
    order.dedup_by(|one, other| one.is_at(other));
    order
}

/// How a value came to be as before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Came {
    /// It was.
    Stood,
    /// It was written.
    Back,
    /// It was written where the drive does not show it: acknowledged.
    Unseen,
}

/// Brings one value back, unless it stands there already; of four that were one, and are not any more, each that needs it.
async fn restore(
    session: &mut Session<'_>,
    plan: &mut Plan,
    kept: &Kept,
    permit: &Permit<Writing>,
    is_begun: &mut bool,
) -> Result<Came, Failure> {
    if plan.is_unread(kept) {
        return bring(session, plan, kept, permit, is_begun).await.map(|_| Came::Unseen);
    }
    let (mut came, mut stays) = (Came::Stood, None);
    for (set, now) in stands(session, &mut plan.job.target, &kept.param, &[kept.set]).await? {
        let (kept, now) = (Kept { set, ..kept.clone() }, now?);
        if now == kept.raw && !plan.may_hide(&kept) {
            continue;
        }
        // What somebody else has set since is his; the others go back all the same.
        match is_ours(session, plan, &kept, now).await {
            Err(failure) if failure.code == THEIRS => stays = stays.or(Some(failure)),
            Err(failure) => return Err(failure),
            Ok(()) => {
                came = bring(session, plan, &kept, permit, is_begun).await?;
            }
        }
    }
    let is_blind = plan.blind.iter().any(|blind| blind.is_at(kept));
    match stays {
        Some(failure) => Err(failure),
        None if is_blind && came == Came::Stood => Err(unshown(kept)),
        None => Ok(came),
    }
}

/// Writes one value as it was, and proves it; in a RAM that the drive does not show its acknowledgement has to do.
async fn bring(
    session: &mut Session<'_>,
    plan: &mut Plan,
    kept: &Kept,
    permit: &Permit<Writing>,
    is_begun: &mut bool,
) -> Result<Came, Failure> {
    let Kept { param, set, raw } = kept;
    let read_back = !plan.is_unread(kept);
    let target = &mut plan.job.target;
    plan.shaft.allows(session, target, param).await?;
    let address = target.address;
    let kind = target.width(session, param, *set).await;
    *is_begun |= kind.is_ok();
    let fate = match kind {
        Ok(kind) => target.write(session, param, Order { set: *set, raw: *raw, kind, read_back }, permit).await,
        Err(error) => Err(error),
    };
    match fate {
        Ok(WriteFate::Verified) => Ok(Came::Back),
        Ok(WriteFate::Written) if !read_back => Ok(Came::Unseen),
        Ok(WriteFate::Unknown(error)) | Err(error) => {
            Err(error.failure(address, Some(&target.family)).with("param", param.id))
        }
        Ok(WriteFate::Written | WriteFate::Differs(_) | WriteFate::Broadcast) => Err(left(kept)),
    }
}

/// The code of a value that the drive did not take back.
const NOT_PUT_BACK: &str = "partial.not_put_back";

fn left(kept: &Kept) -> Failure {
    let message = both!("{label} was not put back", "{label} wurde nicht zurückgenommen", label = kept.param.label());
    Failure::new(Class::Partial, NOT_PUT_BACK, message).with("param", kept.param.id)
}

/// The code of a value that is stored as before, and perhaps not in force.
pub const NOT_SHOWN: &str = "partial.ram_not_shown";

/// What brings into force what is stored, where the RAM is not shown.
pub fn switch_off() -> Text {
    both!(
        "switch the drive off and on: then it works with what is stored",
        "den Antrieb aus- und einschalten: dann arbeitet er mit dem, was gespeichert ist"
    )
}

/// The EEPROM did not take the new value, and whether the RAM did the drive does not show.
fn unshown(kept: &Kept) -> Failure {
    let message = both!(
        "{label} is stored as before, but the drive does not show its RAM, which may have the new value until it is switched off",
        "{label} ist gespeichert wie vorher, der Antrieb zeigt aber sein RAM nicht, in dem bis zum Ausschalten der neue Wert stehen \
         kann",
        label = kept.param.label()
    );
    Failure::new(Class::Partial, NOT_SHOWN, message).with("param", kept.param.id).hint(switch_off())
}

fn unseen(kept: &Kept) -> Failure {
    let message =
        both!("{label} was not asked any more", "{label} wurde nicht mehr gefragt", label = kept.param.label());
    Failure::new(Class::Partial, "partial.not_asked", message).with("param", kept.param.id)
}

/// Says in the row what became of putting it back: its own, or that of what is stored before it.
fn told(plan: &mut Plan, kept: &Kept, result: Result<Came, Failure>) -> Option<Failure> {
    let is_its = |step: &Step| kept.is_of(step);
    let is_over_it = |step: &Step| {
        let in_ram = kept.set >= DataSets::RAM_OFFSET && step.set < DataSets::RAM_OFFSET;
        in_ram && step.param.id == kept.param.id && is_behind(kept.set, step.set)
    };
    let Job { steps, rows, .. } = &mut plan.job;
    let is_own = steps.iter().any(is_its);
    let own = steps.iter().position(is_its).or_else(|| steps.iter().position(is_over_it));
    let row = own.and_then(|index| rows.get_mut(index));
    match (result, row) {
        (Ok(came), Some(row)) => {
            // What the drive refused was never another value, and what nobody touched stays so.
            use WriteResult::{Refused, Skipped, Unchanged, Unrestored};
            let keeps = came == Came::Stood && matches!(row.result, Refused | Skipped | Unchanged);
            let stays = keeps || row.result == Unrestored;
            row.result = match came {
                _ if stays => row.result,
                Came::Unseen => WriteResult::Written,
                Came::Stood | Came::Back => WriteResult::Restored,
            };
            None
        }
        (Ok(_), None) => None,
        (Err(failure), row) => {
            let (label, in_ram) = (kept.param.label(), kept.set >= DataSets::RAM_OFFSET);
            let memory = if in_ram { "ram" } else { "eeprom" };
            let failure = failure.within(|why| {
                both!(
                    "{label}@{set}{ram} may not be as before: {why}",
                    "{label}@{set}{ram} ist vielleicht nicht wie vorher: {why}",
                    set = kept.set % 5,
                    ram = if in_ram { "ram" } else { "" },
                    why
                )
            });
            // It counts as the value of its row, whatever was asked when it failed.
            let set = own.and_then(|index| steps.get(index)).map_or(kept.set, |step| step.set);
            let mut failure = failure.with(STORE, memory).with(SET, set % DataSets::RAM_OFFSET);
            failure.context.retain(|(key, _)| *key != PARAM);
            let failure = failure.with(PARAM, kept.param.id);
            // A row is of what is stored, where that did not come back either: its own error stays.
            let is_said = |row: &&mut Written| {
                let torn = row.result == WriteResult::Unrestored && row.error.is_some();
                !(torn && in_ram && !is_own)
            };
            if let Some(row) = row.filter(is_said) {
                let is_told = |error: &ErrorDoc| error.code == THEIRS && failure.code == THEIRS;
                if row.error.as_ref().is_some_and(is_told) {
                    return None;
                }
                row.result = WriteResult::Unrestored;
                row.error = Some(ErrorDoc::from(&failure));
            }
            Some(failure)
        }
    }
}

/// What an undo brings back, in its order.
pub(super) fn undo_order(plan: &Plan) -> Vec<Kept> {
    let rows = plan.job.steps.iter().zip(&plan.job.rows);
    let todo = rows.filter(|(_, row)| matches!(row.result, WriteResult::Planned | WriteResult::Unchanged));
    back_sorted(todo.map(|(step, _)| Kept::wanted(step)).collect(), &plan.job.target.family.files)
}

/// Tries, before anybody is asked, whether the file will take what an undo has to note in it.
///
/// # Errors
/// It cannot be rewritten: then nothing may be written to the drive.
pub fn make_ready(plan: &Plan, file: &UndoFile) -> Result<(), Failure> {
    file.make_ready(open(plan, &undo_order(plan)).iter().map(Kept::setting))
}

/// Takes back what an undo file states: each planned value is brought back, proven. What fails does not stop the others, and stands in
/// the file.
pub async fn undo(session: &mut Session<'_>, plan: &mut Plan, permit: &Permit<Writing>, left: &UndoFile) -> Applied {
    if let Err(failure) = still_may(session, plan).await {
        return untouched(plan, failure);
    }
    let before = plan.job.rows.clone();
    let order = undo_order(plan);
    // What could not be noted would be forgotten: nothing is written then.
    if let Err(failure) = left.note(&open(plan, &order)) {
        return untouched(plan, failure);
    }
    let Way { mut failures, is_begun, over, runs, .. } =
        restore_all(session, plan, &order, (permit, left), Way::default()).await;
    if let (Some(why), false) = (over.clone().or(runs), is_begun) {
        plan.job.rows = before;
        return untouched(plan, why);
    }
    let came_back = failures.is_empty();
    if over.is_none() {
        failures.extend(in_force(session, plan).await.unwrap_or_else(|failure| vec![failure]));
    }
    let ended = match (failures.is_empty(), came_back) {
        (true, _) => LoadEnd::Done,
        (false, true) => LoadEnd::Stored,
        (false, false) => LoadEnd::Torn,
    };
    Applied { ended, failures, notes: Vec::new() }
}

/// Takes back at once what a transaction of this run has done, proven: a failure for each value that did not come back. What
/// fails does not stop the others.
pub async fn take_back(
    session: &mut Session<'_>,
    plan: &mut Plan,
    permit: &Permit<Writing>,
    left: &UndoFile,
) -> Vec<Failure> {
    let order = back_order(plan);
    restore_all(session, plan, &order, (permit, left), Way::default()).await.failures
}
