//! What a transaction is going to do: every old value read, every new one checked, nothing sent.

use super::choice::in_sets;
use crate::drive::job::{self, Job, Step};
use crate::drive::motion::has_power;
use crate::drive::stands::{in_ram, stands};
use crate::drive::{Reader, Session, Target, Terms, describe, is_over};
use crate::failure::{Class, Failure};
use crate::outcome::{Decimal, ErrorDoc, Event, WriteResult, Written};
use crate::profile::paramfile::value_text;
use crate::profile::value;
use crate::profile::{DataSets, Family, Param, Role, Sets, Store, Type};
use crate::text::{Text, both};
use std::collections::BTreeMap;

/// What there is to do.
#[derive(Debug)]
pub struct Plan {
    /// The drive, the values in their order, and what becomes of them.
    pub job: Job,
    /// What the drive may change by itself behind a write, and is put back with it.
    pub(super) watched: Vec<Kept>,
    /// What stands in the RAM where something else is stored: a write to the EEPROM goes over it too.
    pub(super) in_force: Vec<Kept>,
    /// What whoever is asked must know besides.
    pub notes: Vec<Text>,
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
}

impl Plan {
    /// Values that are going to be written.
    pub fn todo(&self) -> usize {
        self.job.rows.iter().filter(|row| row.result == WriteResult::Planned).count()
    }
}

/// Whether the value of a row may have been changed.
pub(super) fn is_touched(row: &Written) -> bool {
    use WriteResult::{Differs, Refused, Restored, Unknown, Unrestored, Verified};
    let is_begun = matches!(row.result, Verified | WriteResult::Written | Differs | Unknown | Restored | Unrestored);
    // Refused by the drive; what we refuse is never begun.
    is_begun || row.result == Refused
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

/// The code of a drive that runs.
pub const RUNNING: &str = "forbidden.running";
/// The code of a value that cannot be read on the way back.
const UNREAD: &str = "partial.unread";
/// So many values in a row that do not come tell that nobody is there.
const MOST_SILENCES: usize = 2;

/// Where a transaction goes.
pub(super) enum Purpose {
    /// To new values.
    Forward,
    /// Back from these, by number and data set; what is not named was changed by the drive itself.
    Back(BTreeMap<(u32, u8), i64>),
}

impl Purpose {
    /// Whether a value that does not come keeps nobody from bringing the others.
    fn bears(&self, failure: &Failure, silences: usize) -> bool {
        matches!(self, Purpose::Back(_)) && !is_over(failure) && silences < MOST_SILENCES
    }
}

/// See [`plan`].
pub(super) async fn prepare(
    session: &mut Session<'_>,
    mut target: Target,
    terms: &Terms<'_>,
    steps: Vec<Step>,
    purpose: &Purpose,
) -> Result<Plan, Failure> {
    let mut failures = match standstill(session, &mut target).await {
        Ok(()) => Vec::new(),
        Err(failure) if failure.class == Class::Forbidden => vec![failure],
        Err(failure) => return Err(failure),
    };
    let (mut planned, mut rows) = (Vec::new(), Vec::new());
    let (mut in_force, mut notes, mut silences) = (Vec::new(), Vec::new(), 0);
    let total = steps.len() as u64;
    for group in grouped(steps) {
        let Some(param) = group.first().map(|step| step.param.clone()) else { continue };
        session.tell(reading_of(planned.len() as u64, total, &param));
        if let Some(kind) = group.first().and_then(|step| step.kind) {
            target.set_width(param.id, kind);
        }
        let sets: Vec<u8> = group.iter().map(|step| step.set).collect();
        let old = stands(session, &mut target, &param, &sets).await;
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
        let ram = in_ram(session, &mut target, &param, &told).await?;
        for step in spread(group, &old) {
            let old = old.get(&step.set).cloned().unwrap_or_else(|| Err(unread(&param)));
            let beneath: Vec<(u8, i64)> = ram.iter().filter(|(set, _)| is_behind(*set, step.set)).copied().collect();
            let stored = old.as_ref().ok().copied();
            let (row, failure) = weigh(session, &target, terms, (&step, purpose), (old, &beneath));
            for (set, raw) in beneath.into_iter().filter(|(_, raw)| stored.is_some_and(|stored| stored != *raw)) {
                notes.extend(differs_in_ram(&param, (set, raw), &row, purpose));
                in_force.push(Kept { param: param.clone(), set, raw });
            }
            failures.extend(failure);
            planned.push(step);
            rows.push(row);
        }
    }
    let job = Job { target, steps: planned, rows };
    let watched = Vec::new();
    let mut plan = Plan { job, watched, in_force, notes, failures, eeprom_writes: 0, eeprom_writes_back: 0 };
    plan.watch(session).await?;
    plan.count();
    Ok(plan)
}

/// Refuses a drive that runs, or does not say in a state that we know that it does not (CM-485 manual 6.6, cause 8): some parameters cannot be written then, which ones no source tells, and the others would change
/// a shaft that turns.
pub(super) async fn standstill(session: &mut Session<'_>, target: &mut Target) -> Result<(), Failure> {
    let address = target.address;
    if target.family.role(Role::StatusWord).is_none() {
        // A family of the user's own that tells no state.
        return Ok(());
    }
    let mut reader = Reader::new(session, target);
    let state = reader.vital_role(Role::StatusWord).await?.and_then(|value| value.word?.state);
    if let Some(failure) = reader.into_failures().0.into_iter().next() {
        return Err(failure);
    }
    let Some(state) = state.filter(|state| has_power(&state.slug) != Some(false)) else { return Ok(()) };
    let message = both!(
        "drive {address} runs ({state}): a file is written to a drive that does not run",
        "Antrieb {address} läuft ({state}): eine Datei wird in einen Antrieb geschrieben, der nicht läuft",
        state = state.name
    );
    Err(Failure::new(Class::Forbidden, RUNNING, message).with("address", address).hint(both!(
        "stop it first, such as with `antrieb statemachine disable`; `antrieb write` writes single values to a drive that runs",
        "ihn zuerst anhalten, etwa mit `antrieb statemachine disable`; `antrieb write` schreibt einzelne Werte in einen \
         laufenden Antrieb"
    )))
}

/// The row of a value, and why it cannot be written.
fn weigh(
    session: &Session<'_>,
    target: &Target,
    terms: &Terms<'_>,
    (step, purpose): (&Step, &Purpose),
    (old, in_ram): (Result<i64, Failure>, &[(u8, i64)]),
) -> (Written, Option<Failure>) {
    let row = describe::to_write(target.address, &target.family, &step.param, step.set, step.raw);
    let mut row = Written { node: session.node(), ..row };
    if let Ok(old) = old {
        row.old_raw = Some(old);
        row.old = value::digits(&step.param, old).map(|(raw, decimals)| Decimal { raw, decimals });
    }
    let is_in_force = || in_ram.iter().all(|(_, raw)| *raw == step.raw);
    let kind = target.known_width(step.param.id).or(step.kind);
    let verdict = match (old, purpose) {
        (Ok(old), Purpose::Forward) if old == step.raw && is_in_force() => {
            row.result = WriteResult::Unchanged;
            return (row, None);
        }
        // An undo file states what was stored.
        (Ok(old), Purpose::Back(_)) if old == step.raw => {
            row.result = WriteResult::Unchanged;
            return (row, None);
        }
        (old @ Ok(_), Purpose::Forward) => {
            if old == Ok(step.raw) {
                row.note = Some(both!(
                    "stored already, but the drive works with another value (RAM)",
                    "schon gespeichert, der Antrieb arbeitet aber mit einem anderen Wert (RAM)"
                ));
            }
            let known = kind.ok_or_else(|| job::no_width(&step.param));
            known.and_then(|kind| fits(step, Some(kind)))
        }
        (Ok(old), Purpose::Back(from)) => stands_as_left(step, old, from),
        (Err(failure), Purpose::Forward) => Err(no_way_back(&step.param, failure)),
        (Err(failure), Purpose::Back(_)) => Err(not_told(&step.param, failure)),
    };
    job::tell(&mut row, kind.and_then(|kind| job::telegram(terms, &target.family, target.address, step, kind)));
    let failure = verdict.err();
    if let Some(failure) = &failure {
        let is_unknown = failure.code == UNREAD;
        row.result = if is_unknown { WriteResult::Unrestored } else { WriteResult::Refused };
        row.error = Some(ErrorDoc::from(failure));
    }
    (row, failure)
}

/// What forbids a value that is to be written, as far as that can be told without asking: the line, the range, the type if it is
/// known.
///
/// # Errors
/// What forbids it.
pub fn fits(step: &Step, kind: Option<Type>) -> Result<(), Failure> {
    let Step { param, raw, .. } = step;
    let label = param.label();
    if job::cuts(param) {
        let message = both!(
            "{label} cuts the line at once, and what cuts the line cannot be taken back over it",
            "{label} kappt die Leitung sofort, und was sie kappt, lässt sich über sie nicht zurücknehmen"
        );
        return Err(Failure::new(Class::Forbidden, "forbidden.cuts", message).hint(both!(
            "`antrieb line set` and `antrieb protocol set` change it and follow the drive",
            "`antrieb line set` und `antrieb protocol set` stellen es um und folgen dem Antrieb"
        )));
    }
    let wrong = |code: &str, error: value::ValueError| {
        let message =
            both!("{label} ({slug}): {why}", "{label} ({slug}): {why}", slug = param.slug, why = error.text());
        Failure::new(Class::Data, code, message).with("param", param.id).hint(both!(
            "--except {id} leaves it out",
            "--except {id} lässt es weg",
            id = param.id
        ))
    };
    value::check_range(*raw, param).map_err(|error| wrong("data.range", error))?;
    let typed = kind.map_or(Ok(()), |kind| value::check_type(*raw, kind, param));
    typed.map_err(|error| wrong("data.width", error))
}

/// Whether a value still is what the transaction made of it: what somebody has changed since is his.
fn stands_as_left(step: &Step, now: i64, from: &BTreeMap<(u32, u8), i64>) -> Result<(), Failure> {
    let Some(left) = from.get(&(step.param.id, step.set)).filter(|left| **left != now) else { return Ok(()) };
    let shown = |raw| value_text(&step.param, raw);
    let message = both!(
        "{label} reads as {now}, which is neither the value before the load ({before}) nor the one that it was to write ({left})",
        "{label} liest sich als {now}; das ist weder der Wert vor dem Laden ({before}) noch der, den es schreiben sollte ({left})",
        label = place(step),
        now = shown(now),
        before = shown(step.raw),
        left = shown(*left)
    );
    Err(Failure::new(Class::Forbidden, "forbidden.changed_since", message).hint(both!(
        "somebody has changed it since, or it is another drive; --force takes it back all the same",
        "jemand hat es seitdem geändert, oder es ist ein anderer Antrieb; --force nimmt es trotzdem zurück"
    )))
}

/// What cannot be read cannot be put back, so it is not written.
fn no_way_back(param: &Param, failure: Failure) -> Failure {
    let message = both!(
        "{label}: {why}; what cannot be read cannot be taken back",
        "{label}: {why}; was sich nicht lesen lässt, lässt sich nicht zurücknehmen",
        label = param.label(),
        why = failure.message
    );
    let hint = both!(
        "is it the drive, and the module, that the file was made for? --except leaves parameters out",
        "ist es der Antrieb, und das Modul, für die die Datei gemacht wurde? --except lässt Parameter weg"
    );
    Failure { message, ..failure }.hint(hint)
}

/// A value that cannot be read is not brought back: nobody could tell whether somebody has changed it since.
fn not_told(param: &Param, failure: Failure) -> Failure {
    let message = both!(
        "{label} is left as it is, because it cannot be read: {why}",
        "{label} bleibt, wie er ist, weil er sich nicht lesen lässt: {why}",
        label = param.label(),
        why = failure.message
    );
    Failure { message, code: UNREAD.to_owned(), ..failure }
}

fn unread(param: &Param) -> Failure {
    let message = both!("{label} was not read", "{label} wurde nicht gelesen", label = param.label());
    Failure::new(Class::Garbled, "garbled.unread", message)
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

fn reading_of(done: u64, total: u64, param: &Param) -> Event {
    Event::Progress { done, total, what: both!("reading {label}", "{label} wird gelesen", label = param.label()) }
}

impl Plan {
    /// Reads what the drive may change by itself behind the values that are going to be written.
    async fn watch(&mut self, session: &mut Session<'_>) -> Result<(), Failure> {
        let family = self.job.target.family.clone();
        for (id, ram) in self.altering() {
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
    fn altering(&self) -> Vec<(u32, bool)> {
        let rules = &self.job.target.family.files;
        let rows = self.job.steps.iter().zip(&self.job.rows);
        let todo = rows.filter(|(_, row)| row.result == WriteResult::Planned);
        let altering = todo.filter(|(step, _)| rules.altered_by(step.param.id).next().is_some());
        altering.map(|(step, _)| (step.param.id, step.set >= 5)).collect()
    }

    /// Bounds for what the EEPROM has to bear. What the drive changes by itself counts too.
    fn count(&mut self) {
        let family = self.job.target.family.clone();
        let rows = self.job.steps.iter().zip(&self.job.rows);
        let todo = rows.clone().filter(|(_, row)| row.result == WriteResult::Planned);
        let written: u64 = todo.map(|(step, _)| cells(step, &family)).sum();
        let watched = self.watched.iter().filter(|kept| kept.set < 5).count() as u64;
        let is_watched =
            |step: &Step| self.watched.iter().any(|kept| (kept.param.id, kept.set) == (step.param.id, step.set));
        let again = rows.filter(|(step, row)| row.result == WriteResult::Unchanged && is_watched(step));
        let again: u64 = again.map(|(step, _)| cells(step, &family)).sum();
        self.eeprom_writes = written + watched + again;
        self.eeprom_writes_back = written + 2 * watched;
    }
}

/// What is to be said of a value in force that is not the one that is stored.
fn differs_in_ram(param: &Param, (set, raw): (u8, i64), row: &Written, purpose: &Purpose) -> Option<Text> {
    let (label, set) = (param.label(), set - DataSets::RAM_OFFSET);
    let raw = value_text(param, raw);
    match (purpose, row.result) {
        (Purpose::Forward, _) => Some(both!(
            "{label}@{set}: the drive works with {raw} (RAM), which is not what is stored; both are replaced, and an undo file \
             brings back only what is stored",
            "{label}@{set}: der Antrieb arbeitet mit {raw} (RAM), gespeichert ist anderes; beides wird ersetzt, und eine Datei \
             zum Zurücknehmen bringt nur das Gespeicherte zurück"
        )),
        (Purpose::Back(_), WriteResult::Unchanged) => Some(both!(
            "{label}@{set}: what is stored is as before; the drive works with {raw} (RAM) until it is switched off",
            "{label}@{set}: gespeichert ist der Wert von vorher; der Antrieb arbeitet bis zum Ausschalten mit {raw} (RAM)"
        )),
        (Purpose::Back(_), _) => None,
    }
}

/// Whether a data set in RAM is the one in force behind one of the EEPROM; behind data set 0 all of them are.
pub(super) fn is_behind(ram: u8, stored: u8) -> bool {
    [0, ram - DataSets::RAM_OFFSET].contains(&stored)
}

/// A parameter with its data set, as people name it.
fn place(step: &Step) -> String {
    let label = step.param.label();
    if step.set.is_multiple_of(5) { label } else { format!("{label}@{}", step.set % 5) }
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
