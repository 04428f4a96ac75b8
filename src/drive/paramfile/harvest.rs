//! Reading many settings of a drive in few telegrams, so that it can end at any of them and be gone on with.
//!
//! Data set 0 is asked first: it can be read where all four are equal, and is refused where they differ (CM-485 manual 7). So
//! n parameters of which d differ take n + 5 d questions: the refusal, its cause, and four values for each that differs.

use super::asked::Asking;
use crate::drive::transfer::{hides_width, proves_width};
use crate::drive::widths::{Rows, doubted, refusal};
use crate::drive::{AccessError, Reading, Refusal, Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::outcome::Event;
use crate::profile::paramfile::{At, NotHeld, Setting, Settings};
use crate::profile::{DataSets, Param, Type};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::collections::{BTreeMap, BTreeSet};

/// So many parameters in a row without an answer, each asked as often as is set: nobody is there any more.
const NOBODY_AFTER: usize = 3;
/// So often what is there so far is handed out.
const CHECKPOINT: Span = Span::from_secs(10);

/// What was read, and what was not.
#[derive(Clone, Debug, Default)]
pub struct Harvest {
    /// The values.
    pub settings: Settings,
    /// Numbers of parameters that are not among them, and why.
    pub not_held: BTreeMap<NotHeld, BTreeSet<u32>>,
    /// Data types that were found out by asking, where they are not the usual one of 16 bits.
    pub types: BTreeMap<u32, Type>,
    /// Why parameters were refused or not answered, by number.
    pub failures: BTreeMap<u32, Failure>,
    /// Why it ended before all was asked.
    pub end: Option<Failure>,
}

impl Harvest {
    /// Notes why a parameter is not held.
    pub fn leave(&mut self, number: u32, reason: NotHeld) {
        self.forget(number);
        self.not_held.entry(reason).or_default().insert(number);
    }

    /// A parameter is not missing any more.
    fn forget(&mut self, number: u32) {
        self.not_held.retain(|_, numbers| {
            numbers.remove(&number);
            !numbers.is_empty()
        });
    }

    /// Whether nothing has to be asked again.
    pub fn is_complete(&self) -> bool {
        self.end.is_none() && !self.not_held.keys().any(|reason| reason.is_open())
    }

    /// Numbers of those that are not held, and why: of an element that of its array.
    pub fn left(&self) -> impl Iterator<Item = (NotHeld, BTreeSet<u32>)> + '_ {
        let number = |id: &u32| Param::unknown(*id).number();
        self.not_held.iter().map(move |(&reason, ids)| (reason, ids.iter().map(number).collect()))
    }

    /// What of this is still to be asked.
    pub fn is_open(&self, number: u32) -> bool {
        let read = self.settings.params().any(|param| param.id == number);
        let closed = |(reason, numbers): (&NotHeld, &BTreeSet<u32>)| !reason.is_open() && numbers.contains(&number);
        !read && !self.not_held.iter().any(closed)
    }

    /// Numbers that may still be read: nobody knows what they are.
    pub fn open(&self) -> impl Iterator<Item = u32> {
        self.not_held.iter().filter(|(reason, _)| reason.is_open()).flat_map(|(_, numbers)| numbers).copied()
    }

    /// Why it is not all that was wanted.
    pub fn failure(&self) -> Option<Failure> {
        let count = self.open().count();
        let not_asked = (count > 0).then(not_asked);
        let why = self.end.clone().or_else(|| self.unanswered().next().cloned()).or(not_asked)?;
        if self.settings.is_empty() {
            return Some(why);
        }
        let missing =
            Text::count(count as u64, ["parameter is", "parameters are"], ["Parameter fehlt", "Parameter fehlen"]);
        let ends = matches!(why.class, Class::Port | Class::Interrupted);
        let class = if ends { why.class } else { Class::Partial };
        let told = |why| both!("{missing} missing; {why}", "{missing}; {why}", missing, why);
        Some(Failure { class, ..why.within(told) })
    }

    /// Why parameters were not answered, or refused for a reason that says nothing of them.
    pub fn unanswered(&self) -> impl Iterator<Item = &Failure> {
        self.open().filter_map(|number| self.failures.get(&number))
    }
}

/// A save that was begun with a longer list leaves open what this one does not know.
fn not_asked() -> Failure {
    let message = both!(
        "the catalogues and options with which the save was begun name them, those of today do not",
        "die Kataloge und Optionen, mit denen die Sicherung begann, nennen sie, die von heute nicht"
    );
    Failure::new(Class::Partial, "partial.not_asked", message)
}

/// Reads what is asked of a drive and is not in `before` yet. `keep` is handed what is there so far, from time to time.
pub async fn harvest(
    session: &mut Session<'_>,
    target: &mut Target,
    asked: &[Asking],
    before: Harvest,
    keep: &mut dyn FnMut(&Harvest),
) -> Harvest {
    let mut so_far = Harvest { end: None, ..before };
    let todo: Vec<&Asking> = asked.iter().filter(|one| so_far.is_open(one.param.id)).collect();
    for one in &todo {
        so_far.failures.remove(&one.param.id);
        so_far.leave(one.param.id, NotHeld::NotAsked);
    }
    let mut work = Work { session, target, so_far, silences: 0 };
    let began = work.session.now();
    let mut kept = began;
    work.fetch(&todo).await;
    for (done, one) in todo.iter().enumerate() {
        if work.so_far.end.is_some() {
            break;
        }
        work.tell(began, done, todo.len());
        if work.so_far.is_open(one.param.id) {
            work.ask(one).await;
        }
        if work.session.now().since(kept) >= CHECKPOINT {
            kept = work.session.now();
            keep(&work.so_far);
        }
    }
    work.leave_what_moves(asked).await;
    work.so_far
}

/// Reading a drive, and how it went so far.
struct Work<'w, 's> {
    session: &'w mut Session<'s>,
    target: &'w mut Target,
    so_far: Harvest,
    silences: usize,
}

impl Work<'_, '_> {
    /// What lies next to each other, where one telegram can ask for several.
    async fn fetch(&mut self, todo: &[&Asking]) {
        let whole = todo.iter().filter(|one| one.sets == [DataSets::Unnamed]);
        let params: Vec<Param> = whole.map(|one| one.param.clone()).collect();
        let (readings, end) = self.target.neighbours(self.session, &params).await;
        let readings: BTreeMap<u32, Reading> = readings.into_iter().collect();
        for param in &params {
            if let Some(reading) = readings.get(&param.id) {
                self.take(param, vec![(0, Ok(reading.clone()))], false);
            }
        }
        if let Err(error) = end {
            self.end(&error);
        }
    }

    /// Asks for a parameter, and once more where nobody knows why it was refused, or where another width may be the right one.
    async fn ask(&mut self, one: &Asking) {
        let presumed = presumed(&one.param);
        let mut rows = self.read(&presumed, &one.sets).await;
        let first = refusal(&rows);
        if first.is_some_and(|first| !first.is_of_width() && !first.denies(&self.target.family)) {
            rows = self.read(&presumed, &one.sets).await;
        }
        let denies =
            |last: Refusal| last.denies(&self.target.family) || first == Some(last) && last.denies_if_repeated();
        let is_denied = refusal(&rows).is_some_and(denies);
        self.take(&one.param, rows, is_denied);
    }

    async fn read(&mut self, param: &Param, asked: &[DataSets]) -> Rows {
        let rows = self.target.read_as_it_is(self.session, param, asked).await;
        // Where the answer that told why was lost, the four were asked although they are equal.
        match asked {
            [DataSets::Unnamed] => all_at_once(rows),
            _ => rows,
        }
    }

    /// Takes the values of a parameter: all of them, or none. `is_denied`: the drive does not have it, or does not tell it.
    fn take(&mut self, param: &Param, rows: Rows, is_denied: bool) {
        let mut readings = Vec::new();
        for (_, row) in rows {
            match row {
                Ok(reading) => readings.push(reading),
                Err(error) => return self.miss(param, &error, is_denied),
            }
        }
        self.silences = 0;
        if readings.iter().any(|reading| reading.text.is_some()) {
            return self.so_far.leave(param.id, NotHeld::NoNumber);
        }
        if readings.iter().any(|reading| hides_width(self.session, param, reading.raw)) {
            return self.so_far.leave(param.id, NotHeld::NoKnownWidth);
        }
        for reading in readings {
            // What whoever reads the file would not expect.
            let kind = Some(reading.kind).filter(|_| proves_width(self.session, param));
            if kind.is_some_and(|kind| param.kind.unwrap_or(Type::Word).bits() != kind.bits()) {
                self.so_far.types.insert(param.id, reading.kind);
            }
            let (set, _) = describe::place(reading.set);
            let at = At { path: format!("drive {}", self.target.address).into(), line: 0, column: 0 };
            self.so_far.settings.insert(Setting { param: param.clone(), set, raw: reading.raw, kind, at });
        }
        self.so_far.forget(param.id);
    }

    fn miss(&mut self, param: &Param, error: &AccessError, is_denied: bool) {
        if error.is_fatal() {
            return self.end(error);
        }
        let failure = error.failure(self.target.address, Some(&self.target.family)).with("param", param.id);
        let is_refused = failure.class == Class::Data || is_denied;
        self.silences = if is_refused || failure.class == Class::Refused { 0 } else { self.silences + 1 };
        self.so_far.leave(param.id, if is_refused { NotHeld::Refused } else { NotHeld::Unanswered });
        self.so_far.failures.insert(param.id, failure.clone());
        if self.silences >= NOBODY_AFTER {
            self.so_far.end = Some(failure);
        }
    }

    fn end(&mut self, error: &AccessError) {
        self.so_far.end = Some(error.failure(self.target.address, Some(&self.target.family)));
    }

    fn tell(&mut self, began: Tick, done: usize, total: usize) {
        let spent = self.session.now().since(began).as_millis();
        let rate = (done as u64 * 1_000).checked_div(spent).unwrap_or(0);
        let what = both!("parameters, {rate}/s", "Parameter, {rate}/s");
        self.session.tell(Event::Progress { done: done as u64, total: total as u64, what });
    }

    /// Of a number that no catalogue knows nobody knows whether it is a setting. What has moved meanwhile is none, whether it was
    /// read now or before the save was interrupted.
    async fn leave_what_moves(&mut self, asked: &[Asking]) {
        for param in asked.iter().map(|one| &one.param).filter(|param| !param.is_known()) {
            if self.so_far.end.is_some() {
                return;
            }
            let Some(first) = self.so_far.settings.iter().find(|one| one.param.id == param.id).cloned() else {
                continue;
            };
            match self.target.read_set(self.session, param, first.set).await {
                Ok(reading) if reading.raw == first.raw => {}
                Ok(_) => {
                    self.drop(param);
                    self.so_far.leave(param.id, NotHeld::ActualValue);
                }
                Err(error) => {
                    if !error.is_fatal() {
                        self.drop(param);
                    }
                    // It has told it once: it has it.
                    self.miss(param, &error, false);
                }
            }
        }
    }

    fn drop(&mut self, param: &Param) {
        self.so_far.settings.retain(|one| one.param.id != param.id);
        self.so_far.types.remove(&param.id);
    }
}

/// Four data sets that hold the same, as the one value that data set 0 is.
fn all_at_once(rows: Rows) -> Rows {
    let [(1, Ok(first)), others @ ..] = rows.as_slice() else { return rows };
    let is_same = |(_, other): &(u8, Result<Reading, AccessError>)| {
        other.as_ref().is_ok_and(|other| Reading { set: first.set, ..other.clone() } == *first)
    };
    if others.len() == 3 && others.iter().all(is_same) {
        vec![(0, Ok(Reading { set: 0, ..first.clone() }))]
    } else {
        rows
    }
}

/// A parameter whose width no source tells, with the one that is asked for first: every frequency that is printed with its type
/// has 32 bits. The drive is right where it says otherwise.
fn presumed(param: &Param) -> Param {
    match (param.kind, param.unit.as_deref()) {
        (None, Some("Hz")) => doubted(&Param { kind: Some(Type::Long), ..param.clone() }),
        _ => param.clone(),
    }
}
