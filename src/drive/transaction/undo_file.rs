//! The file that a transaction leaves before its first byte, so that whatever ends it can be taken back later: what stood in
//! the drive, and what was to come.

mod stated;

pub use stated::WayBack;

use super::plan::{Kept, Plan, is_doubted, prepare};
use super::weigh::{Purpose, not_taken_back};
use crate::drive::job::Step;
use crate::drive::stands::{has_ram, in_ram};
use crate::drive::{Session, Target, Terms};
use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::outcome::{WriteResult, Written};
use crate::profile::paramfile::{
    At, Head, ParamFile, Setting, Settings, UndoSettings, print_undo, value_text, with_unproven,
};
use crate::profile::{DataSets, Family, Store, Type};
use crate::text::{Text, both};
use stated::way_back;
use std::cell::RefCell;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// A file that says how to take a transaction back; it has been written, and is on the disk.
#[derive(Debug)]
pub struct UndoFile {
    path: PathBuf,
    head: Head,
    /// What it said at first.
    settings: UndoSettings,
    family: Rc<Family>,
    /// What stands in it as not proven.
    unproven: RefCell<Settings>,
    /// All that may have to stand there, on the disk before anything is written to the drive: then it needs no room.
    ready: RefCell<Option<(files::Ready, Settings)>>,
}

/// Where an undo file goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UndoPlace {
    /// Under this name, which must be free.
    Named(PathBuf),
    /// Beside this file, under the first name that is free: `base.undo.toml`, `base.undo-2.toml`.
    Beside(PathBuf),
}

/// So many names are tried where no name was given.
const MOST_NAMES: u32 = 999;

impl UndoFile {
    /// Where it stands.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// One that was left by an earlier run, and what it states.
    ///
    /// # Errors
    /// The file is none that takes something back, or does not fit the family.
    pub fn read(path: &Path, file: &ParamFile, family: &Rc<Family>) -> Result<(Self, WayBack), Failure> {
        let (settings, way) = way_back(file, family)?;
        let (path, head, family) = (path.to_owned(), file.head.clone(), family.clone());
        Ok((Self::new(path, head, settings, family), way))
    }

    fn new(path: PathBuf, head: Head, settings: UndoSettings, family: Rc<Family>) -> Self {
        let unproven = RefCell::new(settings.unproven.clone());
        UndoFile { path, head, settings, family, unproven, ready: RefCell::default() }
    }

    /// Puts on the disk what a way back may have to note of these places.
    ///
    /// # Errors
    /// The disk does not take it, or the file may not be replaced.
    pub(super) fn make_ready(&self, places: impl Iterator<Item = Setting>) -> Result<(), Failure> {
        let all = self.with(places);
        if !holds(&self.unproven.borrow(), &all) {
            let ready = files::Ready::write(&self.path, &self.text(&all));
            *self.ready.borrow_mut() = Some((ready.map_err(|error| unkept(&self.path, &error))?, all));
        }
        Ok(())
    }

    /// Says in it which values the drive perhaps will not take back: it may tell its RAM as stored, so that a later look would not find
    /// them. What stands there already is not written again.
    ///
    /// # Errors
    /// The disk does not take it; the file stands as before.
    pub(super) fn note(&self, open: &[Kept]) -> Result<(), Failure> {
        self.keep(self.with(open.iter().map(Kept::setting)))?;
        // From now on it says all that it may have to.
        self.ready.take();
        Ok(())
    }

    /// Says in it what did not come back: of what was open in this run and before, all but what was proven.
    ///
    /// # Errors
    /// As [`UndoFile::note`]; where it says more than it would have to, it may stay.
    pub(super) fn strike(&self, open: &[Kept], proven: &[&Kept]) -> Result<(), Failure> {
        self.keep(without(self.with(open.iter().map(Kept::setting)), proven))
    }

    /// What it stated at first as not proven, and these.
    fn with(&self, places: impl Iterator<Item = Setting>) -> Settings {
        let mut all = self.settings.unproven.clone();
        places.for_each(|place| drop(all.insert(place)));
        all
    }

    fn keep(&self, unproven: Settings) -> Result<(), Failure> {
        let mut stated = self.unproven.borrow_mut();
        if same(&stated, &unproven) {
            return Ok(());
        }
        let error = match files::write_whole(&self.path, &self.text(&unproven), true) {
            Ok(()) => {
                *stated = unproven;
                return Ok(());
            }
            Err(error) => error,
        };
        if !holds(&stated, &unproven)
            && let Some((ready, all)) = self.ready.borrow_mut().take()
            && ready.replace().is_ok()
        {
            *stated = all;
        }
        if holds(&stated, &unproven) { Ok(()) } else { Err(unkept(&self.path, &error)) }
    }

    /// The text with these as not proven: what stands on the disk by now, with its comments, if it is read so.
    fn text(&self, unproven: &Settings) -> String {
        let settings = UndoSettings { unproven: unproven.clone(), ..self.settings.clone() };
        let kept = files::read(&self.path, files::TEXT)
            .ok()
            .map(|text| with_unproven(&text, &settings, &self.family, self.head.lang));
        let is_read_so = |text: &String| {
            let file = ParamFile::parse("undo", text).ok();
            let told = file.and_then(|file| way_back(&file, &self.family).ok()).map(|(told, _)| told);
            told.is_some_and(|told| {
                let pairs = [
                    (&told.old, &settings.old),
                    (&told.new, &settings.new),
                    (&told.ram, &settings.ram),
                    (&told.unproven, unproven),
                ];
                told.store == settings.store && pairs.iter().all(|(one, other)| same(one, other))
            })
        };
        kept.filter(is_read_so).unwrap_or_else(|| print_undo(&self.head, &settings, &self.family))
    }

    /// Itself, unless nothing was written: then it is of no use, and is taken away.
    pub fn unless(self, is_untouched: bool) -> Option<Self> {
        let is_gone = is_untouched && files::remove(&self.path).is_ok();
        (!is_gone).then_some(self)
    }
}

impl UndoPlace {
    /// Tries it, and leaves nothing: what cannot come is told before anybody is asked.
    ///
    /// # Errors
    /// As [`UndoPlace::leave`].
    pub fn check(&self) -> Result<(), Failure> {
        self.first_free(|path| files::check(path, false)).map(drop)
    }

    /// Tries what was typed, before a drive is asked. That its name is taken is in nobody's way where nothing is to be written, which
    /// nobody knows yet.
    ///
    /// # Errors
    /// The disk would not take it.
    pub fn check_typed(&self) -> Result<(), Failure> {
        let Self::Named(path) = self else { return Ok(()) };
        match files::check(path, false) {
            Ok(()) | Err(FileError::Exists) => Ok(()),
            Err(error) => Err(unwritten(path, &error)),
        }
    }

    /// Writes it.
    ///
    /// # Errors
    /// The name is taken, or the disk does not take it: then nothing may be written to the drive.
    pub fn leave(&self, head: &Head, plan: &Plan) -> Result<UndoFile, Failure> {
        let (head, settings) = (plan.head(head), plan.undo_settings());
        let family = plan.job.target.family.clone();
        let text = print_undo(&head, &settings, &family);
        let path = self.first_free(|path| files::write_whole(path, &text, false))?;
        let file = UndoFile::new(path, head, settings, family);
        let is_open = !plan.tells_apart && file.settings.store == Store::Eeprom;
        let ready = if is_open { file.make_ready(file.settings.old.iter().cloned()) } else { Ok(()) };
        match ready {
            Ok(()) => Ok(file),
            Err(failure) => {
                file.unless(true);
                Err(failure)
            }
        }
    }

    /// The first of its names that nobody has and `take` takes.
    fn first_free(&self, take: impl Fn(&Path) -> Result<(), FileError>) -> Result<PathBuf, Failure> {
        let mut last = PathBuf::new();
        for path in self.names() {
            match take(&path) {
                Ok(()) => return Ok(path),
                Err(FileError::Exists) => last = path,
                Err(error) => return Err(unwritten(&path, &error)),
            }
        }
        Err(unwritten(&last, &FileError::Exists))
    }

    fn names(&self) -> Box<dyn Iterator<Item = PathBuf> + '_> {
        match self {
            Self::Named(path) => Box::new(std::iter::once(path.clone())),
            Self::Beside(file) => Box::new((1..=MOST_NAMES).map(|count| {
                let stem = file.file_stem().unwrap_or_default().to_string_lossy();
                let nth = if count == 1 { String::new() } else { format!("-{count}") };
                file.with_file_name(format!("{stem}.undo{nth}.toml"))
            })),
        }
    }
}

/// Whether one states all that the other does.
fn holds(stated: &Settings, all: &Settings) -> bool {
    all.iter().all(|it| stated.exactly(it.param.id, it.set).is_some_and(|own| own.raw == it.raw))
}

/// Whether both state the same.
fn same(one: &Settings, other: &Settings) -> bool {
    holds(one, other) && holds(other, one)
}

/// Without what has come back, of these: of four data sets in one, each of them.
fn without(mut open: Settings, back: &[&Kept]) -> Settings {
    let is_back = |id: u32, set: u8| back.iter().any(|kept| (kept.param.id, kept.set) == (id, set));
    let has_come = |Setting { param, set, .. }: &Setting| {
        [*set, 0].into_iter().any(|set| is_back(param.id, set))
            || *set == 0 && (1..DataSets::RAM_OFFSET).all(|set| is_back(param.id, set))
    };
    open.retain(|open| !has_come(open));
    open
}

/// The code of an undo file that cannot be written or rewritten.
pub const UNDO_FILE: &str = "data.undo_file";

/// What could not be noted would be forgotten: a later undo would take for done what the drive did not take back.
fn unkept(path: &Path, error: &FileError) -> Failure {
    let message = both!(
        "{path}: this undo file cannot be rewritten: {why}; it has to keep what the drive does not take back",
        "{path}: diese Datei zum Zurücknehmen lässt sich nicht neu schreiben: {why}; sie muss behalten, was der Antrieb nicht zurücknimmt",
        path = path.display(),
        why = error.text()
    );
    let hint = match files::leads_to(path) {
        Some(file) => both!(
            "the file itself: `antrieb dataset undo {file}`",
            "die Datei selbst: `antrieb dataset undo {file}`",
            file = file.display()
        ),
        None => both!(
            "copy {path} into a folder that takes files and has room, and undo the copy",
            "{path} in einen Ordner kopieren, der Dateien annimmt und Platz hat, und mit der Kopie zurücknehmen",
            path = path.display()
        ),
    };
    Failure::new(Class::Data, UNDO_FILE, message).hint(hint)
}

fn unwritten(path: &Path, error: &FileError) -> Failure {
    let message = both!(
        "{path}: the undo file cannot be written: {why}",
        "{path}: die Datei zum Zurücknehmen lässt sich nicht schreiben: {why}",
        path = path.display(),
        why = error.text()
    );
    Failure::new(Class::Data, UNDO_FILE, message)
}

impl Plan {
    /// The head with what the drive says otherwise than the catalogue: the file would not be read again without it.
    fn head(&self, head: &Head) -> Head {
        let own = |step: &Step| self.kind(step).filter(|kind| step.param.kind.is_some_and(|usual| usual != *kind));
        let types = self.job.steps.iter().filter_map(|step| Some((step.param.id, own(step)?))).collect();
        Head { types, ..head.clone() }
    }

    fn kind(&self, step: &Step) -> Option<Type> {
        self.job.target.known_width(step.param.id).or(step.kind)
    }

    /// The old values, and what was to come.
    fn undo_settings(&self) -> UndoSettings {
        let (mut old, mut new) = (Settings::default(), Settings::default());
        // Behind a value that changes others, also what nobody writes may stand otherwise.
        let moves = !self.alters().is_empty();
        let is_due =
            |row: &Written| row.result == WriteResult::Planned || moves && row.result == WriteResult::Unchanged;
        let rows = self.job.steps.iter().zip(&self.job.rows).filter(|(_, row)| is_due(row));
        let is_of_ram = self.is_of_ram();
        for (step, row) in rows.filter(|(step, _)| is_of_ram == (step.set >= DataSets::RAM_OFFSET)) {
            let of = |raw| Setting { kind: self.kind(step), ..Kept { raw, ..Kept::wanted(step) }.setting() };
            if let Some(before) = row.old_raw {
                old.insert(of(before));
                // Of what was not to be written nobody knows what came.
                if row.result == WriteResult::Planned {
                    new.insert(of(step.raw));
                }
            }
        }
        for kept in self.watched.iter().filter(|kept| is_of_ram == (kept.set >= DataSets::RAM_OFFSET)) {
            let setting = kept.setting();
            if old.exactly(setting.param.id, setting.set).is_none() {
                old.insert(setting);
            }
        }
        let store = if is_of_ram { Store::Ram } else { Store::Eeprom };
        let ram = if is_of_ram { Settings::default() } else { self.in_ram_alone() };
        UndoSettings { old, new, store, ram, unproven: Settings::default() }
    }
}

impl Kept {
    /// The same as a line of a file.
    pub(super) fn setting(&self) -> Setting {
        let Kept { param, set, raw } = self;
        Setting { param: param.clone(), set: set % DataSets::RAM_OFFSET, raw: *raw, kind: None, at: nowhere() }
    }
}

fn nowhere() -> At {
    At { path: "".into(), line: 0, column: 1 }
}

/// Reads what stands in the drive and says what there is to take back.
///
/// # Errors
/// The drive does not answer.
pub async fn plan_back(
    session: &mut Session<'_>,
    target: Target,
    terms: &Terms<'_>,
    WayBack { steps, from, in_ram_alone, unproven }: WayBack,
) -> Result<Plan, Failure> {
    let purpose = Purpose::Back { from, unproven: unproven.clone() };
    let mut plan = Plan { unproven, ..prepare(session, target, terms, steps, &purpose).await? };
    plan.notes.extend(plan.job.rows.iter().any(is_doubted).then(not_taken_back));
    plan.note_lost(session, &in_ram_alone).await?;
    Ok(plan)
}

impl Plan {
    /// What the drive works with that is not what it has stored, and that the plan writes over.
    fn in_ram_alone(&self) -> Settings {
        let mut alone = Settings::default();
        for (step, row) in self.job.steps.iter().zip(&self.job.rows) {
            for kept in self.behind(step).filter(|kept| row.old_raw != Some(kept.raw)) {
                alone.insert(kept.setting());
            }
        }
        alone
    }

    /// Notes what the RAM alone held before the load and does not hold any more: what is stored is not the whole way back.
    async fn note_lost(&mut self, session: &mut Session<'_>, in_ram_alone: &Settings) -> Result<(), Failure> {
        for one in in_ram_alone.iter() {
            let now = in_ram(session, &mut self.job.target, &one.param, &[one.set]).await?;
            if !now.contains(&(one.set + DataSets::RAM_OFFSET, one.raw)) {
                self.notes.push(not_back(one));
            }
        }
        Ok(())
    }

    /// Notes of which values only what is stored can be proven, because the drive does not show its RAM. What is stored as before
    /// may stand there otherwise all the same, because a load may have come so far and no further: it goes into the RAM unread, where
    /// the drive has one.
    pub(super) fn note_hidden(&mut self, session: &Session<'_>, terms: &Terms<'_>, purpose: &Purpose) {
        let rows = self.job.steps.iter().zip(&self.job.rows);
        let is_due = |row: &Written| matches!(row.result, WriteResult::Planned | WriteResult::Unchanged);
        let is_hidden =
            |step: &Step| has_ram(&self.job.target, &step.param, step.set) && self.behind(step).next().is_none();
        let hidden: Vec<_> = rows.filter(|(step, row)| is_due(row) && is_hidden(step)).collect();
        let Some((_, row)) = hidden.first() else { return };
        let address = row.address;
        let is_open = |(step, row): &&(&Step, &Written)| {
            row.result == WriteResult::Unchanged && purpose.may_stand_otherwise(step)
        };
        let is_there = |step: &Step| !self.lacking.contains(&(step.param.id, step.set));
        let unread = hidden.iter().filter(is_open).map(|(step, _)| in_ram_of(step));
        let unread: Vec<Step> = unread.filter(is_there).collect();
        // A drive may have a RAM of what has data sets, and none of the rest.
        let of = match self.in_force.is_empty() {
            true => Text::default(),
            false => both!(" of {count} of these values", " von {count} dieser Werte", count = hidden.len()),
        };
        self.hidden = Some(both!(
            "drive {address} does not show its RAM{of}: only what is stored is proven; switched off and on it works with that",
            "Antrieb {address} zeigt sein RAM{of} nicht: geprüft wird nur, was gespeichert ist; nach Aus- und Einschalten arbeitet er \
             damit",
            of
        ));
        unread.into_iter().for_each(|step| self.add_unread(session, terms, step));
    }
}

/// The same value in the RAM over its place.
fn in_ram_of(step: &Step) -> Step {
    Step { set: step.set + DataSets::RAM_OFFSET, ..step.clone() }
}

/// That a value which stood in the RAM alone does not come back.
fn not_back(one: &Setting) -> Text {
    let Setting { param, set, raw, .. } = one;
    both!(
        "{label}@{set}: before the load the drive worked with {raw} (RAM alone), which does not come back; `antrieb write` with \
         @{set}ram sets it",
        "{label}@{set}: vor dem Laden arbeitete der Antrieb mit {raw} (nur im RAM), und das kommt nicht zurück; `antrieb write` \
         mit @{set}ram setzt es",
        label = param.label(),
        raw = value_text(param, *raw)
    )
}

#[cfg(test)]
mod tests;
