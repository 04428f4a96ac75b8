//! What a transaction is going to do: every old value read, every new one checked, nothing sent.

use super::choice::in_sets;
use super::progress::{Doing, progress};
use super::running::{Shaft, standstill};
use super::weigh::{Purpose, Unproven, differs_in_ram, not_in_force, unread, unread_in_ram, unwatched, weigh};
use crate::drive::job::{self, Job, Step};
use crate::drive::stands::{has_ram, lacking, ram_stands, stands};
use crate::drive::{Session, Target, Terms, describe, is_over};
use crate::failure::{Class, Failure};
use crate::outcome::{WriteResult, Written};
use crate::profile::{DataSets, Family, Param, Sets, Store};
use crate::text::{Text, both};
use std::collections::{BTreeMap, BTreeSet};

/// What there is to do.
#[derive(Debug)]
pub struct Plan {
    /// The drive, the values in their order, and what becomes of them.
    pub job: Job,
    /// What the drive may change by itself behind a write, and is put back with it.
    pub(super) watched: Vec<Kept>,
    /// What stands in the RAM behind the places that are stored: a write to the EEPROM goes over it too.
    pub(super) in_force: Vec<Kept>,
    /// Places of the RAM that the drive has not got: nothing can be written there.
    pub(super) lacking: BTreeSet<(u32, u8)>,
    /// What is stored beneath places that are written in the RAM alone: a power loss brings it.
    pub(super) beneath: Vec<Kept>,
    /// Somewhere the RAM holds something else than what is told as stored, so this drive tells the two apart.
    pub(super) tells_apart: bool,
    /// Who started the shaft, if it runs.
    pub(super) shaft: Shaft,
    /// Places whose RAM may have taken what the EEPROM did not, and of which the drive does not show the RAM.
    pub(super) blind: Vec<Kept>,
    /// Places of which an earlier way back left open whether the drive has taken them.
    pub(super) unproven: Unproven,
    /// What whoever is asked must know besides.
    pub notes: Vec<Text>,
    /// That only what is stored can be proven, because the drive does not show its RAM.
    pub hidden: Option<Text>,
    /// Why nothing of it may be begun.
    pub failures: Vec<Failure>,
    /// Cells of the EEPROM that are written at most.
    pub eeprom_writes: u64,
    /// Cells that putting everything back writes at most.
    pub eeprom_writes_back: u64,
}

/// A value as it stood before anything was written.
#[derive(Clone, Debug)]
pub(super) struct Kept {
    pub(super) param: Param,
    /// Data set as on the wire.
    pub(super) set: u8,
    pub(super) raw: i64,
}

impl Kept {
    /// The place of a step, with what it wants there.
    pub(super) fn wanted(step: &Step) -> Self {
        Kept { param: step.param.clone(), set: step.set, raw: step.raw }
    }

    /// Whether it is of the place of a step.
    pub(super) fn is_of(&self, step: &Step) -> bool {
        (self.param.id, self.set) == (step.param.id, step.set)
    }

    /// Whether both are of one place.
    pub(super) fn is_at(&self, other: &Kept) -> bool {
        (self.param.id, self.set) == (other.param.id, other.set)
    }
}

impl Plan {
    /// Values that are going to be written.
    pub fn todo(&self) -> usize {
        self.job.rows.iter().filter(|row| row.result == WriteResult::Planned).count()
    }

    /// What nobody can know of a drive whose RAM holds nowhere else than what it tells as stored: the manual leaves open which of
    /// the two the data sets 0-4 show (docs/open-points.md, `ram_reads`).
    pub fn open_memory(&self) -> Option<Text> {
        let target = &self.job.target;
        let is_open = |step: &Step| has_ram(target, &step.param, step.set);
        (!self.tells_apart && self.job.steps.iter().any(is_open)).then(|| {
            both!(
                "a drive of this kind may tell what it works with (RAM) as stored, which its manual leaves open: what was set in RAM \
                 only counts as stored then; switching it off and on before a load settles that",
                "ein Antrieb dieser Art zeigt vielleicht das, womit er arbeitet (RAM), als gespeichert, was seine Anleitung offen \
                 lässt: was nur im RAM steht, gilt dann als gespeichert; Aus- und Einschalten vor dem Laden klärt das"
            )
        })
    }

    /// That nobody could look whether the drive runs.
    pub fn unwatched(&self) -> Option<Text> {
        unwatched(&self.job.target)
    }

    /// Whether all that is going to be written goes into the RAM: an undo file is of one memory, and of the EEPROM if both are
    /// written.
    pub fn is_of_ram(&self) -> bool {
        let mut rows =
            self.job.steps.iter().zip(&self.job.rows).filter(|(_, row)| row.result != WriteResult::Unchanged);
        rows.all(|(step, _)| step.set >= DataSets::RAM_OFFSET)
    }

    /// Places of the rows of which this holds, those of one parameter together.
    pub(super) fn groups(&self, holds: impl Fn(&Written) -> bool) -> Vec<Vec<usize>> {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (index, row) in self.job.rows.iter().enumerate().filter(|(_, row)| holds(row)) {
            let same = |group: &&mut Vec<usize>| {
                let first = group.first().and_then(|first| self.job.rows.get(*first));
                first.is_some_and(|first| first.param == row.param)
            };
            match groups.last_mut().filter(same) {
                Some(group) => group.push(index),
                None => groups.push(vec![index]),
            }
        }
        groups
    }

    /// What the drive worked with behind a place that is stored, as far as it showed that.
    pub(super) fn behind<'p>(&'p self, step: &'p Step) -> impl Iterator<Item = &'p Kept> {
        let is_its = |kept: &&Kept| kept.param.id == step.param.id && is_behind(kept.set, step.set);
        self.in_force.iter().filter(move |kept| step.set < DataSets::RAM_OFFSET && is_its(kept))
    }
}

/// Whether the value of a row may have been changed.
pub(super) fn is_touched(row: &Written) -> bool {
    use WriteResult::{Differs, Refused, Restored, Stored, Unknown, Unrestored, Verified};
    let is_begun =
        matches!(row.result, Verified | WriteResult::Written | Stored | Differs | Unknown | Restored | Unrestored);
    // Refused by the drive; what we refuse is never begun.
    is_begun || row.result == Refused
}

/// Whether a value is going to be written although the drive tells it already.
pub(super) fn is_doubted(row: &Written) -> bool {
    row.result == WriteResult::Planned && row.old_raw == Some(row.raw)
}

/// Reads what stands in the drive and checks everything; what the drive has already is not going to be written.
///
/// # Errors
/// The drive does not answer, or the session is over. What forbids single values stands in the plan.
pub async fn plan(
    session: &mut Session<'_>,
    target: Target,
    terms: &Terms<'_>,
    steps: Vec<Step>,
) -> Result<Plan, Failure> {
    prepare(session, target, terms, steps, &Purpose::Forward).await
}

/// See [`plan`].
pub(super) async fn prepare(
    session: &mut Session<'_>,
    mut target: Target,
    terms: &Terms<'_>,
    steps: Vec<Step>,
    purpose: &Purpose,
) -> Result<Plan, Failure> {
    let failures = match standstill(session, &mut target).await {
        Ok(()) => Vec::new(),
        Err(failure) if failure.class == Class::Forbidden => vec![failure],
        Err(failure) => return Err(failure),
    };
    let here = |step: Step| Step { param: terms.on_line(&target.family, &step.param), ..step };
    let steps: Vec<Step> = steps.into_iter().map(here).collect();
    let mut plan = Plan::empty(target, failures);
    let (mut silences, total) = (0, steps.len());
    for group in grouped(steps) {
        let Some(param) = group.first().map(|step| step.param.clone()) else { continue };
        session.tell(progress(Doing::Reads, plan.job.steps.len(), total, &param));
        let target = &mut plan.job.target;
        if let Some(kind) = group.first().and_then(|step| step.kind) {
            target.set_width(param.id, kind);
        }
        let sets: Vec<u8> = group.iter().map(|step| step.set).collect();
        let old = stands(session, target, &param, &sets).await;
        let old: BTreeMap<u8, _> = match old {
            Err(failure) if purpose.bears(&failure, silences) => {
                silences += 1;
                sets.iter().map(|set| (*set, Err(failure.clone()))).collect()
            }
            old => {
                silences = 0;
                old?.into_iter().collect()
            }
        };
        let told: Vec<u8> = old.iter().filter(|(_, raw)| raw.is_ok()).map(|(set, _)| *set).collect();
        let shown = ram_stands(session, target, &param, &told).await?;
        plan.lacking.extend(lacking(&shown).map(|set| (param.id, set)));
        let ram = shown.into_iter().filter_map(|(set, raw)| Some((set, raw.ok()?))).collect();
        plan.look_beneath(session, &param, &told).await?;
        plan.take(session, terms, purpose, spread(group, &old), &Stand { old, ram });
    }
    plan.watch(session).await?;
    plan.note_hidden(session, terms, purpose);
    plan.count(purpose);
    Ok(plan)
}

/// What stands at the places of one parameter, by data set as on the wire.
struct Stand {
    old: BTreeMap<u8, Result<i64, Failure>>,
    ram: Vec<(u8, i64)>,
}

impl Plan {
    fn empty(target: Target, failures: Vec<Failure>) -> Self {
        Plan {
            job: Job { target, steps: Vec::new(), rows: Vec::new() },
            watched: Vec::new(),
            in_force: Vec::new(),
            lacking: BTreeSet::new(),
            hidden: None,
            beneath: Vec::new(),
            tells_apart: false,
            shaft: Shaft::default(),
            blind: Vec::new(),
            unproven: Unproven::default(),
            notes: Vec::new(),
            failures,
            eeprom_writes: 0,
            eeprom_writes_back: 0,
        }
    }

    /// Takes in the steps of one parameter. What is stored already, but is not what the drive works with, goes into the RAM alone:
    /// the EEPROM bears nothing for it.
    fn take(&mut self, session: &Session<'_>, terms: &Terms<'_>, purpose: &Purpose, steps: Vec<Step>, at: &Stand) {
        for step in steps {
            let old = at.old.get(&step.set).cloned().unwrap_or_else(|| Err(unread(&step.param)));
            let beneath = || at.ram.iter().filter(|(set, _)| is_behind(*set, step.set)).copied();
            self.in_force.extend(beneath().map(|(set, raw)| Kept { param: step.param.clone(), set, raw }));
            let stored = old.clone().ok();
            let apart: Vec<(u8, i64)> = beneath().filter(|(_, raw)| stored.is_some_and(|old| old != *raw)).collect();
            self.tells_apart |= !apart.is_empty();
            let in_ram_alone = matches!(purpose, Purpose::Forward) && stored == Some(step.raw);
            let result = self.add((session, terms, purpose), step.clone(), old, None);
            for (set, raw) in apart {
                if in_ram_alone {
                    let step = Step { set, ..step.clone() };
                    self.add((session, terms, purpose), step, Ok(raw), Some(not_in_force()));
                } else {
                    self.notes.extend(differs_in_ram(&step, (set, raw), result, purpose));
                }
            }
        }
    }

    /// Adds a step with what stands there; what is to become of it.
    fn add(
        &mut self,
        (session, terms, purpose): (&Session<'_>, &Terms<'_>, &Purpose),
        step: Step,
        old: Result<i64, Failure>,
        note: Option<Text>,
    ) -> WriteResult {
        let (row, failure) = weigh(session, &self.job.target, terms, (&step, purpose), old);
        let result = row.result;
        self.failures.extend(failure);
        self.job.rows.push(Written { note: note.or(row.note), ..row });
        self.job.steps.push(step);
        result
    }
}

impl Plan {
    /// Adds a step into a place of the RAM that the drive does not show.
    pub(super) fn add_unread(&mut self, session: &Session<'_>, terms: &Terms<'_>, step: Step) {
        let target = &self.job.target;
        let row = describe::to_write(target.address, &target.family, &step.param, step.set, step.raw);
        let mut row = Written { node: session.node(), note: Some(unread_in_ram()), ..row };
        let kind = target.known_width(step.param.id).or(step.kind);
        job::tell(&mut row, kind.and_then(|kind| job::telegram(terms, &target.family, target.address, &step, kind)));
        self.job.rows.push(row);
        self.job.steps.push(step);
    }

    /// Whether a place of the RAM goes back without having been read.
    pub(super) fn is_unread(&self, kept: &Kept) -> bool {
        let rows = self.job.steps.iter().zip(&self.job.rows);
        let is_its = |step: &Step| kept.is_of(step);
        rows.filter(|(step, _)| is_its(step))
            .any(|(_, row)| row.old_raw.is_none() && row.result == WriteResult::Planned)
    }
}

/// Data set 0 that turned out to be four which differ is written set by set.
fn spread(group: Vec<Step>, old: &BTreeMap<u8, Result<i64, Failure>>) -> Vec<Step> {
    let single = match group.as_slice() {
        [only] if only.set.is_multiple_of(5) && !old.contains_key(&only.set) => only.clone(),
        _ => return group,
    };
    old.keys().map(|set| Step { set: *set, ..single.clone() }).collect()
}

/// Steps that follow each other and are about one parameter.
fn grouped(steps: Vec<Step>) -> Vec<Vec<Step>> {
    let mut groups: Vec<Vec<Step>> = Vec::new();
    for step in steps {
        match groups.last_mut().filter(|group| group.first().is_some_and(|first| first.param.id == step.param.id)) {
            Some(group) => group.push(step),
            None => groups.push(vec![step]),
        }
    }
    groups
}

impl Plan {
    /// Reads what is stored beneath these places of the RAM.
    async fn look_beneath(&mut self, session: &mut Session<'_>, param: &Param, sets: &[u8]) -> Result<(), Failure> {
        let target = &mut self.job.target;
        let stored = sets.iter().filter_map(|set| set.checked_sub(DataSets::RAM_OFFSET));
        let stored: Vec<u8> = stored.filter(|set| has_ram(target, param, *set)).collect();
        match stands(session, target, param, &stored).await {
            Err(failure) if is_over(&failure) => return Err(failure),
            found => {
                let told = found.unwrap_or_default().into_iter().filter_map(|(set, raw)| Some((set, raw.ok()?)));
                self.beneath.extend(told.map(|(set, raw)| Kept { param: param.clone(), set, raw }));
            }
        }
        Ok(())
    }

    /// Reads what the drive may change by itself behind the values that are going to be written.
    async fn watch(&mut self, session: &mut Session<'_>) -> Result<(), Failure> {
        let family = self.job.target.family.clone();
        for (id, ram) in self.alters() {
            for param in family.files.altered_by(id).filter_map(|id| family.param(id)) {
                let first = if ram { 5 } else { 0 };
                let sets: Vec<u8> = if in_sets(param) { (first + 1..=first + 4).collect() } else { vec![first] };
                for (set, raw) in stands(session, &mut self.job.target, param, &sets).await? {
                    // What it does not tell cannot be watched: an ACT without the module has not got it.
                    let raw = raw.ok();
                    self.watched.extend(raw.map(|raw| Kept { param: param.clone(), set, raw }));
                }
            }
        }
        Ok(())
    }

    /// The parameters that are going to be written and change others, and whether in RAM only.
    pub(super) fn alters(&self) -> Vec<(u32, bool)> {
        let rules = &self.job.target.family.files;
        let rows = self.job.steps.iter().zip(&self.job.rows);
        let todo = rows.filter(|(_, row)| row.result == WriteResult::Planned);
        let altering = todo.filter(|(step, _)| rules.altered_by(step.param.id).next().is_some());
        altering.map(|(step, _)| (step.param.id, step.set >= 5)).collect()
    }

    /// Bounds for what the EEPROM has to bear. What the drive changes by itself counts too.
    fn count(&mut self, purpose: &Purpose) {
        let family = self.job.target.family.clone();
        let rows = self.job.steps.iter().zip(&self.job.rows);
        let todo = rows.clone().filter(|(_, row)| row.result == WriteResult::Planned);
        let written: u64 = todo.map(|(step, _)| cells(step, &family)).sum();
        let watched = self.watched.iter().filter(|kept| kept.set < 5).count() as u64;
        let is_watched = |step: &Step| self.watched.iter().any(|kept| kept.is_of(step));
        let equal = |watched: bool| {
            let equal = rows.clone().filter(|(_, row)| row.result == WriteResult::Unchanged);
            equal.filter(|(step, _)| is_watched(step) == watched).map(|(step, _)| cells(step, &family)).sum::<u64>()
        };
        // A value that changes others may take with it what nobody writes: that goes back too.
        let moved = if self.alters().is_empty() { 0 } else { equal(false) };
        let moved_on = if matches!(purpose, Purpose::Back { .. }) { moved } else { 0 };
        self.eeprom_writes = written + watched + equal(true) + moved_on;
        self.eeprom_writes_back = written + 2 * watched + moved;
    }
}

/// Whether a data set in RAM is the one in force behind one of the EEPROM; behind data set 0 all of them are.
pub(super) fn is_behind(ram: u8, stored: u8) -> bool {
    [0, ram - DataSets::RAM_OFFSET].contains(&stored)
}

/// Cells of the EEPROM that a write wears at most.
fn cells(step: &Step, family: &Family) -> u64 {
    let (set, store) = describe::place(step.set);
    let many = set == 0 && step.param.sets != Some(Sets::One) && family.link.route.has_data_sets();
    match store {
        _ if step.param.is_volatile() => 0,
        Store::Ram => 0,
        Store::Eeprom if many => 4,
        Store::Eeprom => 1,
    }
}
