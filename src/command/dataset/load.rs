//! `dataset load`, `dataset undo`: parameter files into a drive, and back.

use super::loaded::{applied, blank, dry_run, forbidden, nothing_to_write, nothing_written, undone_outcome, whole};
use super::only_one;
use super::opened::Opened;
use super::scope::Scope;
use crate::args::Settings;
use crate::command::again::word;
use crate::command::{Context, addresses_to_write, asking, connect, terms};
use crate::drive::paramfile::head;
use crate::drive::transaction::{self, Applied, Plan, UndoFile, UndoPlace, fits};
use crate::drive::{Recognised, Session, Terms, job};
use crate::failure::{Class, Failure};
use crate::gate::{Ask, Permit, Question, Writing};
use crate::outcome::{Load, LoadEnd, Outcome, Warning, WriteResult};
use crate::profile::paramfile::{At, Head, ParamFile, SavedDrive};
use crate::profile::{Family, Registry};
use crate::text::both;
use clap::Args as ClapArgs;
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Writes parameter files into a drive: all of it, or nothing.
///
/// Everything is checked and read first: family, ranges, types, and that the drive does not run. What the drive has already is
/// not written. Old and new values are shown, and you are asked once. An undo file is left before the first byte. Each value is
/// proven; if anything goes wrong, also by Ctrl-C, what was written goes back, and what could not is named (exit 9).
///
/// Several drives (-a 1,2, -a all) get the same files, or with {address} in a name each its own: one question, a transaction and an
/// undo file for each, as by `apply`.
#[derive(Clone, Debug, ClapArgs)]
pub(super) struct LoadArgs {
    /// Parameter files; later ones lie over earlier ones
    #[arg(value_name = "FILE", required = true)]
    pub(super) files: Vec<PathBuf>,
    #[command(flatten)]
    pub(super) scope: Scope,
    /// Where the undo file goes [default: beside FILE]
    #[arg(long, value_name = "FILE")]
    pub(super) undo_file: Option<PathBuf>,
}

/// Takes a `dataset load` back.
///
/// Brings back the values that the undo file states, proven, wherever the load has ended. What is neither as before nor as written
/// was changed since by somebody else, and stays (--force takes it back too).
#[derive(Clone, Debug, ClapArgs)]
pub(super) struct UndoArgs {
    /// The undo file that `dataset load` has left
    #[arg(value_name = "FILE")]
    file: PathBuf,
}

/// Loads files.
pub(super) async fn load(args: &LoadArgs, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let address = only_one(&addresses_to_write(context.settings)?)?;
    let opened = read_all(&args.files, context.settings, context.registry)?;
    let warnings = opened.doubts((address, context.settings.node));
    let mut outcome = load_into(args, context, address, (opened, &warnings)).await?;
    outcome.warnings.splice(0..0, warnings);
    Ok(outcome)
}

/// Loads what the files hold; whoever is asked is warned.
async fn load_into(
    args: &LoadArgs,
    context: &mut Context<'_>,
    address: u8,
    (opened, warnings): (Opened, &[Warning]),
) -> Result<Outcome, Failure> {
    let Opened { file, family, settings: values, .. } = opened;
    let (steps, left_out) = args.scope.choice().steps(&values, &family)?;
    let files = args.files.iter().map(|file| file.display().to_string()).collect();
    let mut report = blank(address, &family.drive, files, left_out);
    if steps.is_empty() {
        return Ok(nothing_to_write(report, &values));
    }
    if context.settings.dry_run {
        return dry_run(context, report, &family, &steps, fits);
    }
    let place = args.undo_place()?;
    place.check_typed().map_err(unbegun)?;
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let terms = terms(settings, registry)?;
    let drive = same_family(&mut session, &terms, address, (&family, &file.family_at, settings.force)).await?;
    let head = Head { lang: settings.lang, ..head(&session, &drive) };
    let mut plan = transaction::plan(&mut session, drive.target, &terms, steps).await?;
    plan.notes.extend(warnings.iter().map(|warning| warning.message.clone()));
    (report.eeprom_writes, report.eeprom_writes_back) = (plan.eeprom_writes, plan.eeprom_writes_back);
    report.node = session.node();
    if plan.todo() > 0 {
        plan.failures.extend(place.check().map_err(elsewhere).err());
    }
    if let Some(failure) = forbidden(&mut plan, &nothing_written()) {
        report.ended = Some(LoadEnd::Untouched);
        return Ok(whole(report, plan, Vec::new(), Some(failure)).into());
    }
    let permit = match permit(&mut session, *ask, &plan, Act::Load(&args.files)).await {
        Ok(Some(permit)) => permit,
        Ok(None) => {
            report.ended = Some(LoadEnd::Done);
            return Ok(whole(report, plan, Vec::new(), None).into());
        }
        Err(denied) => return not_agreed(denied, *ask, report, plan),
    };
    if let Err(other) = same_family(&mut session, &terms, address, (&family, &file.family_at, settings.force)).await {
        return Ok(another_by_now(report, plan, other));
    }
    let left = place.leave(&head, &plan).map_err(unbegun)?;
    let done = transaction::apply(&mut session, &mut plan, &terms, &permit, &left).await;
    let path = left.path().to_owned();
    let left = left.unless(done.ended == LoadEnd::Untouched);
    report.undo_file = left.map(|left| left.path().display().to_string());
    Ok(applied(report, plan, done, &path).into())
}

impl LoadArgs {
    /// Where somebody said, or beside the first file.
    fn undo_place(&self) -> Result<UndoPlace, Failure> {
        match (&self.undo_file, self.files.first()) {
            (Some(path), _) => Ok(UndoPlace::Named(path.clone())),
            // `/dev/stdin`, though it be a file: beside it nothing stays.
            (None, Some(file)) if ["/dev", "/proc"].iter().any(|folder| file.starts_with(folder)) => {
                Err(no_place(file))
            }
            (None, file) => Ok(UndoPlace::Beside(file.cloned().unwrap_or_default())),
        }
    }
}

fn no_place(file: &Path) -> Failure {
    let message = both!(
        "the undo file of {file} has no place beside it: expected --undo-file",
        "die Datei zum Zurücknehmen hat neben {file} keinen Platz: erwartet wird --undo-file",
        file = file.display()
    );
    Failure::new(Class::Usage, "usage.undo_file", message)
}

fn elsewhere(failure: Failure) -> Failure {
    failure.hint(both!("--undo-file names another place", "--undo-file nennt einen anderen Ort"))
}

/// The same where it ends the load.
pub(super) fn unbegun(failure: Failure) -> Failure {
    let so = nothing_written();
    elsewhere(Failure { message: both!("{why}; {so}", "{why}; {so}", why = failure.message, so), ..failure })
}

/// Takes a load back.
pub(super) async fn undo(args: &UndoArgs, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let address = only_one(&addresses_to_write(context.settings)?)?;
    let opened = Opened::read(&args.file, context.registry, context.settings.named_drive())?;
    let Opened { file, family, .. } = opened;
    let (left, mut back) = UndoFile::read(&args.file, &file, &family)?;
    same_address(&file, (address, context.settings.node), context.settings.force)?;
    let mut report = blank(address, &family.drive, vec![args.file.display().to_string()], Vec::new());
    if context.settings.dry_run {
        // What stood in the drive is not judged.
        return dry_run(context, report, &family, &back.steps, |_, _, _| Ok(()));
    }
    if context.settings.force {
        back.from.clear();
    }
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let terms = terms(settings, registry)?;
    let drive = same_family(&mut session, &terms, address, (&family, &file.family_at, settings.force)).await?;
    same_product(&file, drive.product.as_deref(), settings.force)?;
    let mut plan = transaction::plan_back(&mut session, drive.target, &terms, back).await?;
    let warning = other_port(&file, session.port());
    (report.eeprom_writes, report.node) = (plan.eeprom_writes, session.node());
    // What somebody has changed since, or what cannot be read, stays; the others go back.
    let (forbidding, theirs): (Vec<Failure>, _) =
        std::mem::take(&mut plan.failures).into_iter().partition(|failure| failure.code == transaction::RUNNING);
    plan.failures = forbidding;
    plan.failures.extend(transaction::make_ready(&plan, &left).err());
    if let Some(failure) = forbidden(&mut plan, &nothing_written()) {
        report.ended = Some(LoadEnd::Untouched);
        return Ok(whole(report, plan, Vec::new(), Some(failure)).into());
    }
    // Whoever is asked is told it before; behind it each is told in its own place.
    let told = plan.notes.len();
    plan.notes.extend(
        theirs.iter().map(|failure| &failure.message).chain(warning.iter().map(|warning| &warning.message)).cloned(),
    );
    let permit = permit(&mut session, *ask, &plan, Act::Undo(&args.file)).await;
    plan.notes.truncate(told);
    let undone = match permit {
        Ok(Some(permit)) => {
            let of = (&family, &file.family_at, settings.force);
            if let Err(other) = same_family(&mut session, &terms, address, of).await {
                return Ok(another_by_now(report, plan, other));
            }
            transaction::undo(&mut session, &mut plan, &permit, &left).await
        }
        Ok(None) => Applied::default(),
        Err(denied) => return not_agreed(denied, *ask, report, plan),
    };
    let mut outcome = undone_outcome(report, plan, theirs, (undone, &args.file));
    outcome.warnings.splice(0..0, warning);
    Ok(outcome)
}

/// While the question stood, another drive has come to the address, or the drive is gone.
fn another_by_now(mut report: Load, mut plan: Plan, why: Failure) -> Outcome {
    plan.failures = vec![why.clone()];
    let failure = forbidden(&mut plan, &nothing_written()).map(|_| why);
    report.ended = Some(LoadEnd::Untouched);
    whole(report, plan, Vec::new(), failure).into()
}

/// Ports get other names, and lines have drives of equal family and address: only the user knows which it is.
fn other_port(file: &ParamFile, found: &str) -> Option<Warning> {
    let of = file.head.saved.port.as_deref().filter(|of| *of != found)?;
    let message = both!(
        "{path} was left at {of}, this is {found}: make sure that it is the same drive",
        "{path} ist an {of} entstanden, hier ist {found}: sicherstellen, dass es derselbe Antrieb ist",
        path = file.path
    );
    Some(Warning { code: "undo.other_port".to_owned(), message })
}

/// Nobody said yes: where nobody could be asked, a script is told what it would have been asked about.
fn not_agreed(denied: Failure, ask: &dyn Ask, report: Load, plan: Plan) -> Result<Outcome, Failure> {
    if ask.is_there() {
        return Err(denied);
    }
    let report = Load { ended: Some(LoadEnd::Untouched), ..report };
    Ok(whole(report, plan, Vec::new(), Some(denied)).into())
}

/// What is asked about.
#[derive(Clone, Copy)]
enum Act<'a> {
    Load(&'a [PathBuf]),
    Undo(&'a Path),
}

/// Asks for permission; `None` if there is nothing to do.
async fn permit(
    session: &mut Session<'_>,
    ask: &mut dyn Ask,
    plan: &Plan,
    act: Act<'_>,
) -> Result<Option<Permit<Writing>>, Failure> {
    let Some(Question { hazards, title, mut details }) =
        job::question(std::slice::from_ref(&plan.job), session.own_address())
    else {
        return Ok(None);
    };
    let title = match act {
        Act::Load(files) => {
            let files = files.iter().map(|file| file.display().to_string()).collect::<Vec<_>>().join(", ");
            both!("{files}: {title}, all or nothing", "{files}: {title}, alle oder keinen", title)
        }
        Act::Undo(file) => {
            both!("take back {file}: {title}", "{file} zurücknehmen: {title}", file = file.display(), title)
        }
    };
    let unchanged = plan.job.rows.iter().filter(|row| row.result == WriteResult::Unchanged).count();
    let untold = plan.hidden.clone().into_iter().chain(plan.open_memory()).chain(plan.unwatched());
    details.extend(plan.notes.iter().cloned().chain(untold));
    if unchanged > 0 {
        details.push(both!(
            "equal already, and not written: {unchanged}",
            "schon gleich und nicht geschrieben: {unchanged}"
        ));
    }
    if plan.eeprom_writes > 0 {
        let (there, back) = (plan.eeprom_writes, plan.eeprom_writes_back);
        details.push(match act {
            Act::Load(_) => both!(
                "writes to the EEPROM: at most {there}; if all of it has to go back, at most {back} more",
                "Schreibvorgänge im EEPROM: höchstens {there}; muss alles zurück, höchstens {back} weitere"
            ),
            Act::Undo(_) => {
                both!("writes to the EEPROM: at most {there}", "Schreibvorgänge im EEPROM: höchstens {there}")
            }
        });
    }
    asking::on_line(session, ask, &Question { hazards, title, details }).await.map(Some)
}

/// The files, later ones over earlier ones, as one.
pub(in crate::command) fn read_all(
    paths: &[PathBuf],
    settings: &Settings,
    registry: &Registry,
) -> Result<Opened, Failure> {
    let mut laid: Option<Opened> = None;
    for path in paths {
        let opened = Opened::read(path, registry, settings.named_drive())?;
        if opened.file.undo.is_some() {
            let message = both!(
                "{path}: this file takes a load back; it is no parameter file to be written",
                "{path}: diese Datei nimmt ein Laden zurück; zum Schreiben ist sie keine Parameterdatei",
                path = opened.file.path
            );
            return Err(Failure::new(Class::Data, "data.is_undo_file", message).hint(both!(
                "`antrieb dataset undo {shown}` takes it back, and looks who has changed something since",
                "`antrieb dataset undo {shown}` nimmt es zurück und prüft, was seitdem jemand geändert hat",
                shown = word(&path.display().to_string())
            )));
        }
        if !opened.file.head.saved.complete {
            let message = both!(
                "{path}: this file is not complete: the save was interrupted",
                "{path}: diese Datei ist nicht vollständig: das Sichern wurde unterbrochen",
                path = opened.file.path
            );
            return Err(Failure::new(Class::Data, "data.file_incomplete", message).hint(both!(
                "{completes}; a file without `complete = false` is taken as it is",
                "{completes}; ohne `complete = false` wird sie genommen, wie sie ist",
                completes = opened.completes()
            )));
        }
        match &mut laid {
            None => laid = Some(opened),
            Some(below) => below.lay_over(opened)?,
        }
    }
    laid.ok_or_else(|| Failure::new(Class::Usage, "usage.file", both!("expected a file", "erwartet: eine Datei")))
}

/// The drive, if it is of the family that the file is for. It is asked, whatever `--drive` says; with `--force` that is believed.
async fn same_family(
    session: &mut Session<'_>,
    terms: &Terms<'_>,
    address: u8,
    (family, at, force): (&Rc<Family>, &At, bool),
) -> Result<Recognised, Failure> {
    let mut drive = match force {
        true => terms.recognised(session, address, false).await?,
        false => terms.asked(session, address, family).await?,
    };
    drive.product = terms.product(session, &drive).await?;
    let found = &drive.target.family.drive;
    if *found == family.drive {
        return Ok(drive);
    }
    let message = both!(
        "{at}: the file is for drives of the family {of}, drive {address} is of the family {found}; nothing was changed",
        "{at}: die Datei ist für Antriebe der Familie {of}, Antrieb {address} ist von der Familie {found}; geändert wurde nichts",
        of = family.drive
    );
    Err(Failure::new(Class::Data, "data.other_family", message).of_family(found).hint(both!(
        "what two families have in common has the same numbers, not the same meaning; --drive is believed with --force alone",
        "gleiche Nummern zweier Familien bedeuten nicht dasselbe; --drive wird nur mit --force geglaubt"
    )))
}

/// An undo file belongs to one drive.
fn same_address(file: &ParamFile, at: (u8, u8), force: bool) -> Result<(), Failure> {
    let SavedDrive { address, node, .. } = &file.head.drive;
    let Some(of) = address.map(|of| (of, node.unwrap_or(0))).filter(|of| *of != at && !force) else { return Ok(()) };
    let shown = |(address, node)| if node == 0 { format!("{address}") } else { format!("{address}.{node}") };
    let message = both!(
        "{path}: this undo file is of the drive with address {of}, not {at}",
        "{path}: diese Datei nimmt am Antrieb mit Adresse {of} etwas zurück, nicht an {at}",
        path = file.path,
        of = shown(of),
        at = shown(at)
    );
    Err(Failure::new(Class::Data, "data.other_drive", message).hint(both!(
        "if the drive has another address now: --force; it takes back too what somebody has changed since",
        "wenn der Antrieb jetzt eine andere Adresse hat: --force; es nimmt auch zurück, was seitdem jemand geändert hat"
    )))
}

/// The same address may be another drive by now: what it calls itself must be the same too.
fn same_product(file: &ParamFile, found: Option<&str>, force: bool) -> Result<(), Failure> {
    let (Some(of), Some(found)) = (file.head.drive.product.as_deref(), found) else { return Ok(()) };
    if of == found || force {
        return Ok(());
    }
    let message = both!(
        "{path}: this undo file is of '{of}', the drive calls itself '{found}'",
        "{path}: diese Datei nimmt an '{of}' etwas zurück, der Antrieb nennt sich '{found}'",
        path = file.path
    );
    Err(Failure::new(Class::Data, "data.other_drive", message)
        .hint(both!("if it is the same drive all the same: --force", "wenn es trotzdem derselbe Antrieb ist: --force")))
}
