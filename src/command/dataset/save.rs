//! `dataset save`: a drive's settings into a file.

use super::naming::Naming;
use super::opened::Opened;
use crate::command::again::word;
use crate::command::output::{misnamed, unwritten, write};
use crate::command::verb::Verb;
use crate::command::{Context, addresses_to_read, connect, offline_family, plan, read_question, terms};
use crate::drive::paramfile::{Draft, Harvest, Wanted, factory, harvest, left_out, rows};
use crate::drive::{Session, Target, Terms, is_over, summary};
use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::outcome::{Data, ErrorDoc, Outcome, SavedFile, Saves};
use crate::profile::Family;
use crate::profile::paramfile::{Head, NotHeld, Scope, numbers};
use crate::text::{Lang, both};
use clap::Args as ClapArgs;
use std::path::{Path, PathBuf};

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// The file; with {address} or {name} in it, or a directory: one a drive
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Only what differs from the factory settings that are known
    #[arg(long, conflicts_with = "discover")]
    changed: bool,
    /// All numbers 0-1599, also those that no catalogue knows
    #[arg(long)]
    discover: bool,
    /// Go on with a save that was interrupted
    #[arg(long)]
    resume: bool,
}

/// Where the settings of a drive go.
#[derive(Debug)]
struct Goal {
    address: u8,
    /// As it was typed: for several drives with a place for the address, or a directory.
    typed: PathBuf,
    file: PathBuf,
    /// What an interrupted save leaves.
    part: PathBuf,
    before: Option<Opened>,
    /// The file is whole already: of several drives that are gone on with, one that was done before.
    done: Option<Opened>,
}

pub(super) async fn run(options: &Options, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        return options.dry_run(context);
    }
    let addresses = addresses_to_read(context.settings, context.observe)?;
    let several = addresses.len() > 1 || context.settings.is_one_of_lines;
    let goal = |of: &Naming| options.goal(of, several, context);
    let goals = Naming::of_line(context.settings, &addresses)?.iter().map(goal).collect::<Result<Vec<_>, _>>()?;
    let Context { settings, registry, interrupt, observe, .. } = context;
    let terms = terms(settings, registry)?;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let (mut saved, mut failures, mut succeeded) = (Vec::new(), Vec::new(), 0);
    for goal in &goals {
        session.allow(session.now(), <super::Args as Verb>::UPPER.drive);
        let one = match &goal.done {
            Some(done) => same_drive(done, goal, (&session, None), settings.force)
                .map(|()| (options.there(goal, done, &session), None)),
            None => save(options, &mut session, &terms, goal, (settings.force, settings.lang)).await,
        };
        let (row, failure) = match one {
            Ok((row, failure)) => (row, failure),
            Err(failure) => (options.nothing(goal, &failure), Some(failure)),
        };
        succeeded += usize::from(row.file.is_some());
        saved.push(row);
        let over = failure.as_ref().is_some_and(is_over);
        failures.extend(failure);
        if over {
            break;
        }
    }
    if let Some(why) = failures.last().filter(|_| saved.len() < goals.len()).cloned() {
        let left = goals.iter().skip(saved.len()).map(|goal| options.nothing(goal, &why)).collect::<Vec<_>>();
        saved.extend(left);
    }
    let failure = match failures.as_slice() {
        // One drive's own failure says what is missing.
        [only] if goals.len() == 1 => Some(only.clone()),
        _ => summary(failures, succeeded),
    };
    let warnings = misnamed(&options.file).into_iter().collect();
    Ok(Outcome { data: Some(Data::Saves(Saves { saved })), warnings, failure })
}

/// Reads a drive and writes its file, or what there is of it beside.
async fn save(
    options: &Options,
    session: &mut Session<'_>,
    terms: &Terms<'_>,
    goal: &Goal,
    (force, lang): (bool, Lang),
) -> Result<(SavedFile, Option<Failure>), Failure> {
    let mut drive = terms.recognised(session, goal.address, false).await?;
    drive.product = terms.product(session, &drive).await?;
    let family = drive.target.family.clone();
    let scope = options.scope(goal);
    let mut before = Harvest::default();
    if let Some(opened) = &goal.before {
        opened.fits(&family.drive)?;
        same_drive(opened, goal, (session, drive.product.as_deref()), force)?;
        before = resumed(opened);
    }
    let wanted = Wanted::of(scope, &family)?;
    wanted.left.iter().for_each(|&(number, reason)| before.leave(number, reason));
    session.allow(session.now(), <super::Args as Verb>::UPPER.questions(wanted.asked.len() as u64));
    let draft = Draft::of(session, &drive, scope, lang);
    // Where it cannot be written, that is told before the drive is asked for all of it.
    let mut first = before.clone();
    let open: Vec<u32> = wanted.asked.iter().map(|one| one.param.id).filter(|id| first.is_open(*id)).collect();
    open.into_iter().for_each(|id| first.leave(id, NotHeld::NotAsked));
    write(&goal.part, &draft.text(&first), true)?;
    // What is kept on the way is a kindness: where that fails, the end says so.
    let mut keep = |so_far: &Harvest| drop(write(&goal.part, &draft.text(so_far), true));
    let mut done = harvest(session, &mut drive.target, &wanted.asked, before, &mut keep).await;
    if scope == Scope::Changed && done.is_complete() {
        leave_factory(&mut done, &family);
    }
    let failure = done.failure();
    let told = |file| row(goal, &done, (session, &drive.target), scope, file);
    let (saved, failure) = match store(goal, &draft.text(&done), &done, force) {
        Ok(None) => (told(None), failure),
        Ok(file) => (told(file), failure.map(|failure| unfinished(failure, goal))),
        // What was read is told, though no file holds it.
        Err(failure) => (SavedFile { complete: false, signature: None, ..told(None) }, Some(failure)),
    };
    Ok((SavedFile { error: failure.as_ref().map(ErrorDoc::from), ..saved }, failure))
}

/// The row of a drive of which this was read, and its file.
fn row(
    goal: &Goal,
    held: &Harvest,
    (session, target): (&Session<'_>, &Target),
    scope: Scope,
    file: Option<&Path>,
) -> SavedFile {
    SavedFile {
        address: goal.address,
        drive: target.family.drive.clone(),
        file: file.map(|file| file.display().to_string()),
        scope: scope.name(),
        complete: held.is_complete(),
        signature: Some(held.settings.signature(&target.family.drive).to_string()),
        values: rows(session, target, &held.settings),
        not_held: left_out(held),
        error: None,
    }
}

/// Writes the whole file; what is not whole goes beside it.
fn store<'g>(goal: &'g Goal, text: &str, done: &Harvest, force: bool) -> Result<Option<&'g Path>, Failure> {
    if done.is_complete() {
        if let Err(failure) = write(&goal.file, text, force) {
            // What was read is not lost with the name.
            return Err(match write(&goal.part, text, true) {
                Ok(()) => unfinished(failure, goal),
                Err(_) => cut_short(failure, goal),
            });
        }
        // It stands in the file now.
        let _gone = files::remove(&goal.part);
        return Ok(Some(&goal.file));
    }
    if done.settings.is_empty() {
        let _gone = files::remove(&goal.part);
        return Ok(None);
    }
    write(&goal.part, text, true).map_err(|failure| cut_short(failure, goal))?;
    Ok(Some(&goal.part))
}

/// What was begun with one drive is not gone on with by another: its values would stand among those of the first. A port may have another
/// name by now, which only the user knows.
fn same_drive(
    opened: &Opened,
    goal: &Goal,
    (session, product): (&Session<'_>, Option<&str>),
    force: bool,
) -> Result<(), Failure> {
    let Head { drive: of, saved, .. } = &opened.file.head;
    let at = (goal.address, session.node());
    let is_place = of.address.is_none_or(|address| (address, of.node.unwrap_or(0)) == at);
    let is_alike = is_place && of.product.as_deref().zip(product).is_none_or(|(of, found)| of == found);
    let is_port = saved.port.as_deref().is_none_or(|port| port == session.port());
    if is_alike && (is_port || force) {
        return Ok(());
    }
    let anew = both!("--force without --resume saves anew", "--force ohne --resume sichert neu");
    let hint = match is_alike {
        true => both!(
            "if it is the same one, --resume --force goes on; {anew}",
            "ist es derselbe, setzt --resume --force fort; {anew}",
            anew
        ),
        false => anew,
    };
    let message = both!(
        "{path} is of another drive: address {address} at {port}",
        "{path} ist von einem anderen Antrieb: Adresse {address} an {port}",
        path = opened.file.path,
        address = of.address.unwrap_or(goal.address),
        port = saved.port.as_deref().unwrap_or_else(|| session.port())
    );
    Err(Failure::new(Class::Data, "data.other_drive", message).hint(hint))
}

/// What an interrupted save had read.
fn resumed(opened: &Opened) -> Harvest {
    let head = &opened.file.head;
    let numbers = head.not_held.iter().map(|(&reason, list)| (reason, numbers(list).unwrap_or_default()));
    Harvest {
        settings: opened.settings.clone(),
        not_held: numbers.collect(),
        types: head.types.clone(),
        ..Harvest::default()
    }
}

/// Leaves out what has its factory setting.
fn leave_factory(done: &mut Harvest, family: &Family) {
    let factory = factory(family);
    let params: Vec<u32> = done.settings.params().map(|param| param.id).collect();
    let is_factory = |number, raw| factory.get(number, 0).is_some_and(|one| one.raw == raw);
    done.settings.retain(|one| !is_factory(one.param.id, one.raw));
    for number in params {
        if !done.settings.params().any(|param| param.id == number) {
            done.leave(number, NotHeld::FactorySetting);
        }
    }
}

/// Says where what was read is kept, and how it goes on.
fn unfinished(failure: Failure, goal: &Goal) -> Failure {
    let (goes_on, part) = (goal.goes_on(), goal.part.display().to_string());
    let Failure { message, .. } = &failure;
    let message =
        both!("{message}; what was read stands in {part}", "{message}; was gelesen wurde, steht in {part}", message);
    Failure { message, ..failure }.hint(both!("`{goes_on}` goes on", "`{goes_on}` setzt fort"))
}

/// Says what stays of what was read where it cannot be written whole: what was kept on the way.
fn cut_short(failure: Failure, goal: &Goal) -> Failure {
    if files::found(&goal.part) != Some(false) {
        return failure;
    }
    let (goes_on, part) = (goal.goes_on(), goal.part.display().to_string());
    let Failure { message, .. } = &failure;
    let message = both!(
        "{message}; {part} stays, with what was kept on the way",
        "{message}; {part} bleibt, mit dem, was unterwegs gesichert wurde",
        message
    );
    let hint = both!(
        "make room there, then `{goes_on}` reads the rest anew",
        "dort Platz schaffen, dann liest `{goes_on}` das Übrige neu"
    );
    Failure { message, ..failure }.hint(hint)
}

impl Goal {
    /// The command that goes on; an older file in the place of the new one is replaced by --force alone.
    fn goes_on(&self) -> String {
        let replaces = if files::found(&self.file) == Some(false) { " --force" } else { "" };
        format!("antrieb dataset save {} --resume{replaces}", word(&self.typed.display().to_string()))
    }
}

impl Options {
    /// Where the settings of the drive at an address go, and what there is of them.
    fn goal(&self, of: &Naming, several: bool, context: &Context<'_>) -> Result<Goal, Failure> {
        let (address, typed, file) = (of.address, self.file.clone(), self.path(of, several)?);
        let mut name = file.file_name().unwrap_or_default().to_owned();
        name.push(".part");
        let part = file.with_file_name(name);
        let settings = context.settings;
        let exists = |path: &Path| files::found(path).is_some();
        let directory = file.parent().filter(|directory| !directory.as_os_str().is_empty());
        if let Some(directory) = directory.filter(|directory| files::found(directory) != Some(true)) {
            let shown = directory.display().to_string();
            let (message, hint) = match files::found(directory) {
                None => (
                    both!("there is no directory {shown}", "es gibt kein Verzeichnis {shown}"),
                    both!("make it first, or name another one", "es zuerst anlegen, oder ein anderes nennen"),
                ),
                Some(_) => (
                    both!("{shown} is no directory", "{shown} ist kein Verzeichnis"),
                    both!("name another one", "ein anderes nennen"),
                ),
            };
            return Err(Failure::new(Class::Data, "data.output", message).hint(hint));
        }
        for path in [&file, &part] {
            files::check(path, true).map_err(|error| unwritten(path, &error))?;
        }
        if several && self.resume && exists(&file) && !exists(&part) {
            let done = Opened::read(&file, context.registry, settings.named_drive())?;
            if done.file.head.drive.address == Some(address) && done.file.head.saved.complete {
                return Ok(Goal { address, typed, file, part, before: None, done: Some(done) });
            }
        }
        if exists(&file) && !settings.force {
            return Err(unwritten(&file, &FileError::Exists));
        }
        if self.resume && exists(&part) {
            let before = Opened::read(&part, context.registry, settings.named_drive())?;
            self.same_scope(&before)?;
            return Ok(Goal { address, typed, file, part, before: Some(before), done: None });
        }
        let shown = part.display().to_string();
        if self.resume && !several {
            let message = both!(
                "there is nothing to go on with: {shown} is not there",
                "es gibt nichts fortzusetzen: {shown} gibt es nicht"
            );
            return Err(Failure::new(Class::Data, "data.resume", message)
                .hint(both!("without --resume it begins anew", "ohne --resume beginnt es von vorn")));
        }
        if exists(&part) && !settings.force {
            let message = both!(
                "an earlier save was interrupted: {shown} is there",
                "ein früheres Sichern wurde unterbrochen: {shown} ist da"
            );
            return Err(Failure::new(Class::Data, "data.resume", message).hint(both!(
                "--resume goes on with it, --force begins anew",
                "--resume setzt es fort, --force beginnt von vorn"
            )));
        }
        Ok(Goal { address, typed, file, part, before: None, done: None })
    }

    /// What was begun with one scope is not gone on with in another: the file would hold some of either.
    fn same_scope(&self, before: &Opened) -> Result<(), Failure> {
        let typed = self.typed().zip(before.file.head.saved.scope);
        let Some((asked, begun)) = typed.filter(|(asked, begun)| asked != begun) else { return Ok(()) };
        let message = both!(
            "{path} was begun as `{begun}`, not as `{asked}`",
            "{path} wurde als `{begun}` begonnen, nicht als `{asked}`",
            path = before.file.path,
            begun = begun.name(),
            asked = asked.name()
        );
        Err(Failure::new(Class::Usage, "usage.scope", message).hint(both!(
            "--resume alone goes on as it was begun; --force without --resume begins anew",
            "--resume allein setzt fort, wie begonnen; --force ohne --resume beginnt von vorn"
        )))
    }

    /// The scope that was typed, if one was.
    fn typed(&self) -> Option<Scope> {
        let changed = self.changed.then_some(Scope::Changed);
        changed.or_else(|| self.discover.then_some(Scope::Discovered))
    }

    /// The row of a drive whose file was whole before.
    fn there(&self, goal: &Goal, done: &Opened, session: &Session<'_>) -> SavedFile {
        let head = &done.file.head;
        let numbers = head.not_held.iter().map(|(&reason, list)| (reason, numbers(list).unwrap_or_default()));
        let held = Harvest { settings: done.settings.clone(), not_held: numbers.collect(), ..Harvest::default() };
        let target = Target::new(goal.address, done.family.clone());
        row(goal, &held, (session, &target), self.scope(goal), Some(&goal.file))
    }

    /// The file of a drive.
    fn path(&self, of: &Naming, several: bool) -> Result<PathBuf, Failure> {
        let name = self.file.to_string_lossy();
        if name == "-" {
            let message =
                both!("expected the name of a file, got '-'", "erwartet: der Name einer Datei; angegeben: '-'");
            return Err(Failure::new(Class::Usage, "usage.file", message).hint(both!(
                "with --json the values stand on stdout as well; ./- names a file that is called so",
                "mit --json stehen die Werte auch auf stdout; ./- meint eine Datei, die so heißt"
            )));
        }
        if files::found(&self.file) == Some(true) {
            return Ok(self.file.join(format!("drive-{}.toml", of.word())));
        }
        if several && !of.tells_apart(&self.file) {
            let message = both!(
                "one file holds one drive, and several addresses were given",
                "eine Datei fasst einen Antrieb, und es sind mehrere Adressen angegeben"
            );
            return Err(of.refused(message, &both!(", or name a directory", " oder ein Verzeichnis angeben")));
        }
        Ok(of.own(&self.file))
    }

    /// What the file is to hold; one that is gone on with says it itself.
    fn scope(&self, goal: &Goal) -> Scope {
        let begun = goal.before.as_ref().or(goal.done.as_ref()).and_then(|before| before.file.head.saved.scope);
        begun.or_else(|| self.typed()).unwrap_or(Scope::Settings)
    }

    /// The row of a drive of which nothing was read.
    fn nothing(&self, goal: &Goal, failure: &Failure) -> SavedFile {
        SavedFile {
            address: goal.address,
            drive: failure.family().to_owned(),
            file: None,
            scope: self.scope(goal).name(),
            complete: false,
            signature: None,
            values: Vec::new(),
            not_held: Vec::new(),
            error: Some(ErrorDoc::from(failure)),
        }
    }

    /// The questions, as if the four data sets of everything were equal.
    fn dry_run(&self, context: &mut Context<'_>) -> Result<Outcome, Failure> {
        let family = offline_family(context.settings, context.registry)?;
        let scope = self.typed().unwrap_or(Scope::Settings);
        let wanted = Wanted::of(scope, &family)?;
        let questions: Vec<_> = wanted.asked.iter().map(|one| read_question(&one.param, 0)).collect();
        plan(context, &family, &questions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The name cannot be taken: a directory has it.
    #[test]
    fn what_was_read_is_not_lost_with_its_name_and_it_is_said_where_it_stands() {
        let at = tempfile::tempdir().unwrap();
        let (file, part) = (at.path().join("f.toml"), at.path().join("f.toml.part"));
        let goal =
            Goal { address: 1, typed: file.clone(), file: file.clone(), part: part.clone(), before: None, done: None };
        std::fs::create_dir(&file).unwrap();
        let failure = store(&goal, "all", &Harvest::default(), false).unwrap_err();
        assert_eq!(std::fs::read_to_string(&part).unwrap(), "all");
        assert!(failure.message.en.contains(&format!("what was read stands in {}", part.display())), "{failure:?}");
        assert!(failure.hint.is_some_and(|hint| hint.en.contains("--resume` goes on")));
        // Where not even that can be written, what was kept on the way is named; nothing is named that is not there.
        let failure = || Failure::new(Class::Data, "data.output", both!("no room", "kein Platz"));
        let told = cut_short(failure(), &goal);
        for lang in Lang::ALL {
            assert!(told.message.get(lang).contains(&part.display().to_string()), "{told:?}");
        }
        assert!(told.hint.is_some_and(|hint| hint.de.contains("--resume")));
        // An older file in its place is replaced by --force alone.
        std::fs::remove_dir(&file).unwrap();
        std::fs::write(&file, "older").unwrap();
        assert!(cut_short(failure(), &goal).hint.is_some_and(|hint| hint.en.contains("--resume --force`")));
        std::fs::remove_file(&part).unwrap();
        assert_eq!(cut_short(failure(), &goal).message, failure().message);
    }
}
