//! Two sides of a comparison, and what comes of it.

use super::opened::{Opened, edited};
use super::which::Which;
use crate::command::verb::Verb;
use crate::drive::paramfile::{Asking, Harvest, compare, factory, harvest, held, in_force, of_file, of_set, unified};
use crate::drive::{Session, Target, Terms, summary};
use crate::failure::{Class, Failure};
use crate::outcome::{Comparison, Comparisons, Data, ErrorDoc, Outcome, Side, Warning};
use crate::profile::paramfile::Settings;
use crate::profile::{DataSets, Family, Param, Store};
use crate::text::{Text, both};
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// A side on its way to being compared.
#[derive(Debug)]
pub(super) struct Weight {
    pub(super) family: Rc<Family>,
    pub(super) settings: Settings,
    /// The drive that is asked for it.
    pub(super) live: Option<Live>,
    side: Side,
    /// Of a file that an interrupted save has left: the command that completes it.
    completes: Option<Text>,
    harvest: Option<Harvest>,
}

/// A drive, and the data set that is meant if it is not all of it.
#[derive(Debug)]
pub(super) struct Live {
    target: Target,
    set: Option<(u8, Store)>,
}

impl Weight {
    pub(super) fn of(
        which: &Which,
        file: Option<&Opened>,
        target: Option<Target>,
        family: &Rc<Family>,
    ) -> Result<Self, Failure> {
        let address = target.as_ref().map(|target| target.address);
        let side = Side {
            kind: which.kind(),
            name: named(which, address),
            drive: family.drive.clone(),
            address,
            node: 0,
            signature: None,
            edited: file.and_then(Opened::is_edited),
        };
        let (settings, set) = match which {
            Which::Factory => (factory(family), None),
            Which::File(_) => (file.map(|file| file.settings.clone()).unwrap_or_default(), None),
            Which::Drive(_) => (Settings::default(), None),
            &Which::Set(set, store) => {
                crate::command::check_sets(family, DataSets::One(set, store))?;
                (Settings::default(), Some((set, store)))
            }
        };
        let live = target.map(|target| Live { target, set });
        let completes = file.filter(|file| !file.file.head.saved.complete).map(Opened::completes);
        Ok(Weight { family: family.clone(), settings, live, side, completes, harvest: None })
    }

    /// The data set that is meant, if it is not all of the drive.
    pub(super) fn set(&self) -> Option<(u8, Store)> {
        self.live.as_ref()?.set
    }

    /// Asks the drive.
    pub(super) async fn ask(&mut self, session: &mut Session<'_>, asked: &[Asking]) {
        let Some(live) = &mut self.live else { return };
        session.allow(session.now(), <super::Args as Verb>::UPPER.questions(asked.len() as u64));
        let done = harvest(session, &mut live.target, asked, Harvest::default(), &mut |_| {}).await;
        self.settings = done.settings.clone();
        self.harvest = Some(done);
    }

    /// Asks the drive for what the other side names, and keeps of that what both can have.
    pub(super) async fn fill(&mut self, session: &mut Session<'_>, other: &mut Weight) {
        if self.live.is_none() || self.harvest.is_some() {
            return;
        }
        let asked = match self.set() {
            Some((set, store)) => of_set(&other.settings, set, store),
            None => of_file(&other.settings, &self.family),
        };
        if let Some((set, _)) = self.set() {
            other.settings = held(&other.settings, set, set);
            other.settings.retain(|one| asked.iter().any(|asking| asking.param.id == one.param.id));
        }
        self.ask(session, &asked).await;
    }

    /// Asks a data set of the drive for these parameters. What it holds counts for the parameter, whichever set it is.
    pub(super) async fn ask_set(&mut self, session: &mut Session<'_>, params: &[&Param]) {
        let Some((set, store)) = self.set() else { return };
        let asking = |param: &&Param| Asking { param: (*param).clone(), sets: vec![DataSets::One(set, store)] };
        self.ask(session, &params.iter().map(asking).collect::<Vec<_>>()).await;
        self.settings = held(&self.settings, set, 0);
    }

    /// What the drive works with, where that is not what it has stored.
    async fn in_force(&mut self, session: &mut Session<'_>) -> Vec<Text> {
        match (&mut self.live, &self.harvest) {
            (Some(live), Some(harvest)) if harvest.failure().is_none() => {
                in_force(session, &mut live.target, &self.settings).await
            }
            _ => Vec::new(),
        }
    }

    /// What is odd about a file.
    fn warnings(&self) -> impl Iterator<Item = Warning> {
        let name = &self.side.name;
        let edited = (self.side.edited == Some(true)).then(|| edited(name));
        let part = self.completes.is_some().then(|| Warning {
            code: "file.part".to_owned(),
            message: both!(
                "{name} is what an interrupted save has left: not all of the drive is in it",
                "{name} stammt von einem unterbrochenen Sichern: nicht alles vom Antrieb steht darin",
                name
            ),
        });
        edited.into_iter().chain(part)
    }

    /// Why the drive did not tell all.
    fn failure(&self) -> Option<Failure> {
        self.harvest.as_ref().and_then(Harvest::failure)
    }
}

/// What came of a comparison.
#[derive(Debug)]
pub(in crate::command) struct Weighed {
    pub(in crate::command) comparison: Comparison,
    pub(in crate::command) failure: Option<Failure>,
    pub(in crate::command) warnings: Vec<Warning>,
}

impl Weighed {
    /// Holds two sides against each other; what only one of them has counts for both if `all`.
    pub(super) fn of(mut a: Weight, mut b: Weight, all: bool, is_unified: bool) -> Self {
        let family = a.family.clone();
        if [&a, &b].iter().any(|one| one.side.kind == "factory") {
            // The catalogue knows what this drive need not have, and of much it knows no factory setting.
            let both = |number, one: &Weight| one.settings.params().any(|param| param.id == number);
            let common: BTreeSet<u32> = a.settings.params().map(|param| param.id).filter(|id| both(*id, &b)).collect();
            [&mut a, &mut b].into_iter().for_each(|one| one.settings.retain(|row| common.contains(&row.param.id)));
        }
        let open: BTreeSet<u32> =
            [&a, &b].iter().filter_map(|one| one.harvest.as_ref()).flat_map(Harvest::open).collect();
        [&mut a, &mut b].into_iter().for_each(|one| one.settings.retain(|row| !open.contains(&row.param.id)));
        let mut failures = BTreeMap::new();
        for one in [&a, &b] {
            failures.extend(one.harvest.iter().flat_map(|harvest| harvest.failures.clone()));
        }
        let compared = compare(&a.settings, &b.settings, all, &failures, &family);
        let names = [&a.side.name, &b.side.name];
        let unified = is_unified.then(|| unified(names, &compared.differences, &family));
        let silent = a.failure().or_else(|| b.failure());
        // What a side was asked for and did not tell is neither the same nor different.
        let untold = compared.differences.iter().filter_map(|row| row.error.as_ref()).count();
        let count = compared.differences.len() - untold;
        let unread =
            compared.differences.iter().find_map(|row| failures.get(&row.param)).map(|why| unread(untold, count, why));
        let differ = (count > 0).then(|| differing(count));
        let none = (compared.count == 0).then(nothing_to_compare);
        let part = [&a, &b].into_iter().find_map(|one| Some(incomplete(&one.side.name, one.completes.clone()?)));
        // What differs does so whatever is missing.
        let part = part.filter(|_| count == 0);
        for one in [&mut a, &mut b] {
            one.side.signature = Some(one.settings.signature(&family.drive).to_string());
        }
        let warnings = [&a, &b].into_iter().flat_map(Weight::warnings).collect();
        let missing = silent.or(unread);
        let is_open = missing.is_some() || part.is_some() || compared.count == 0;
        let equal = if is_open { None } else { Some(count == 0) };
        let comparison = Comparison {
            a: a.side,
            b: b.side,
            equal: if count > 0 { Some(false) } else { equal },
            compared: compared.count,
            differences: compared.differences,
            error: missing.as_ref().or(part.as_ref()).map(ErrorDoc::from),
            unified,
        };
        Weighed { comparison, failure: missing.or(differ).or(none).or(part), warnings }
    }

    /// Beside something that could not be compared.
    pub(in crate::command) fn beside(mut self, unsettled: Option<&Failure>) -> Self {
        if self.failure.is_none() {
            self.comparison.equal = self.comparison.equal.filter(|_| unsettled.is_none());
            self.failure = unsettled.cloned();
        }
        self
    }

    /// A file whose drive could not be asked at all.
    pub(in crate::command) fn failed(file: &Opened, address: u8, failure: Failure) -> Self {
        let sides = [&Which::File(file.file.path.as_ref().into()), &Which::Drive(None)];
        Self::unasked(sides, [Some(file), None].into_iter(), address, failure)
    }

    /// Two sides of which the drive could not be asked at all.
    pub(super) fn unasked<'o>(
        sides: [&Which; 2],
        files: impl Iterator<Item = Option<&'o Opened>>,
        address: u8,
        failure: Failure,
    ) -> Self {
        let files: Vec<_> = files.collect();
        let family = files.iter().flatten().next().map_or("unknown", |file| &file.family.drive);
        let [a, b] = sides.map(|which| {
            let own = which.address(Some(address));
            let drive = if own.is_some() { failure.family() } else { family };
            Side {
                kind: which.kind(),
                name: named(which, own),
                drive: drive.to_owned(),
                address: own,
                node: 0,
                signature: None,
                edited: None,
            }
        });
        let comparison = Comparison {
            a,
            b,
            equal: None,
            compared: 0,
            differences: Vec::new(),
            error: Some(ErrorDoc::from(&failure)),
            unified: None,
        };
        Weighed { comparison, failure: Some(failure), warnings: Vec::new() }
    }
}

/// What a side is called; `address` is that of its drive.
fn named(which: &Which, address: Option<u8>) -> Text {
    let drive = || both!("drive {address}", "Antrieb {address}", address = address.unwrap_or(0));
    match which {
        Which::Factory => both!("factory settings", "Werkseinstellungen"),
        Which::File(path) => Text::name(path.display()),
        Which::Drive(_) => drive(),
        &Which::Set(set, store) => {
            let ram = if store == Store::Ram { "ram" } else { "" };
            both!("{drive}, data set {set}{ram}", "{drive}, Datensatz {set}{ram}", drive = drive())
        }
    }
}

/// Holds the drive at an address against a file.
pub(super) async fn against_drive(
    session: &mut Session<'_>,
    terms: &Terms<'_>,
    address: u8,
    file: &Opened,
    is_unified: bool,
) -> Result<Weighed, Failure> {
    let target = terms.target(session, address, false).await?;
    against_target(session, target, file, is_unified).await
}

/// Holds a drive that was found against a file.
pub(in crate::command) async fn against_target(
    session: &mut Session<'_>,
    target: Target,
    file: &Opened,
    is_unified: bool,
) -> Result<Weighed, Failure> {
    file.fits(&target.family.drive).map_err(|failure| failure.of_family(&target.family.drive))?;
    let which = Which::File(file.file.path.as_ref().into());
    let mut a = Weight::of(&which, Some(file), None, &file.family)?;
    let mut b = Weight::of(&Which::Drive(None), None, Some(target), &file.family)?;
    b.fill(session, &mut a).await;
    let notes = b.in_force(session).await;
    let weighed = Weighed::of(a, b, false, is_unified);
    let notes = notes.into_iter().map(|message| Warning { code: "check.in_force".to_owned(), message });
    Ok(Weighed { warnings: weighed.warnings.into_iter().chain(notes).collect(), ..weighed })
}

/// What a drive refused to tell can be anything.
fn unread(untold: usize, differ: usize, why: &Failure) -> Failure {
    let some = Text::count(
        untold as u64,
        ["value could not be read", "values could not be read"],
        ["Wert ließ sich nicht lesen", "Werte ließen sich nicht lesen"],
    );
    let others = match differ {
        0 => Text::default(),
        1 => both!(", 1 differs", ", 1 ist verschieden"),
        _ => both!(", {differ} differ", ", {differ} sind verschieden"),
    };
    let said = why.clone().within(|why| both!("{some}{others}; {why}", "{some}{others}; {why}", some, others, why));
    Failure { class: Class::Partial, code: "partial.unread".to_owned(), ..said }
}

fn differing(count: usize) -> Failure {
    let message = match count {
        1 => both!("1 value differs", "1 Wert ist verschieden"),
        count => both!("{count} values differ", "{count} Werte sind verschieden"),
    };
    Failure::new(Class::No, "no.differences", message)
}

/// What is not in a file can be anything.
fn incomplete(name: &Text, completes: Text) -> Failure {
    let message = both!(
        "nothing differs as far as {name} goes, which is not complete",
        "soweit {name} reicht, ist nichts verschieden, doch die Datei ist nicht vollständig",
        name
    );
    Failure::new(Class::Partial, "partial.file_incomplete", message).hint(completes)
}

fn nothing_to_compare() -> Failure {
    let message = both!("there is nothing to compare", "es gibt nichts zu vergleichen");
    Failure::new(Class::Data, "data.no_common", message).hint(both!(
        "the sides have no parameter in common of which both are known",
        "die Seiten haben keinen Parameter gemeinsam, von dem beide bekannt sind"
    ))
}

/// The outcome of comparisons, one a drive.
pub(super) fn told(weighed: Vec<Weighed>) -> Outcome {
    let (mut comparisons, mut failures, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
    for Weighed { comparison, failure, warnings: more } in weighed {
        comparisons.push(comparison);
        failures.extend(failure);
        warnings.extend(more);
    }
    let broken: Vec<_> = failures.iter().filter(|failure| failure.class != Class::No).cloned().collect();
    let failure = match broken.as_slice() {
        [] => match comparisons.iter().map(|one| one.differences.len()).sum() {
            0 => failures.into_iter().next(),
            count => Some(differing(count)),
        },
        [only] if comparisons.len() == 1 => Some(only.clone()),
        _ => summary(broken.clone(), comparisons.len() - broken.len()),
    };
    Outcome { data: Some(Data::Comparisons(Comparisons { comparisons })), warnings, failure }
}
