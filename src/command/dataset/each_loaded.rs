//! `dataset load` of several drives: the same files, or a file for each, and a transaction for each, as `apply` does it.

use super::load::{LoadArgs, read_all, unbegun};
use super::naming::Naming;
use super::one_of;
use crate::args::{Place, Settings};
use crate::command::plant::apply;
use crate::command::plant::lines::{Said, Wanted, by_line};
use crate::command::{Context, running};
use crate::drive::transaction::UndoPlace;
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::text::{Text, both};
use std::path::{Path, PathBuf};

/// Loads files into every drive that was named, behind one question.
pub(super) async fn load(args: &LoadArgs, context: &mut Context<'_>, addresses: &[u8]) -> Result<Outcome, Failure> {
    super::not_everybody(addresses)?;
    let lines = running::lines(context.settings);
    lines.iter().try_for_each(Settings::check_one_line)?;
    one_setting(lines)?;
    if context.settings.force {
        let message = both!(
            "--force loads into one drive: what it overrides is looked at one by one",
            "--force lädt in einen Antrieb: was es übergeht, wird einzeln angesehen"
        );
        return Err(one_of(Failure::new(Class::Usage, "usage.force", message), addresses));
    }
    let mut wanted = Vec::new();
    for line in lines {
        for of in Naming::of_line(line, line.addresses.named())? {
            wanted.push(of_drive(args, context, line, &of)?);
        }
    }
    by_line(context.settings, &mut wanted)?;
    apply::write(context, wanted, false, async |_, wanted| Ok(wanted)).await
}

/// What one of the drives shall have.
fn of_drive(args: &LoadArgs, context: &Context<'_>, settings: &Settings, of: &Naming) -> Result<Wanted, Failure> {
    let files: Vec<PathBuf> = args.files.iter().map(|file| of.own(file)).collect();
    let opened = read_all(&files, settings, context.registry)?;
    let (steps, left_out) = args.scope.choice().steps(&opened.settings, &opened.family)?;
    let undo = match (&args.undo_file, args.files.first()) {
        (Some(path), _) => named(path, of)?,
        (None, first) => UndoPlace::Beside(beside(first.map(PathBuf::as_path).unwrap_or(Path::new("")), of)),
    };
    let place = Place { name: of.name.clone(), address: of.address, product: None, files, settings: settings.clone() };
    Ok(Wanted { place, said: Said::Typed, opened, steps, left_out, undo, unsettled: None })
}

/// One port has one setting here: its drives are told their values on one open line.
fn one_setting(lines: &[Settings]) -> Result<(), Failure> {
    let Some([one, ..]) = lines.windows(2).find(|pair| matches!(pair, [one, other] if one.port == other.port)) else {
        return Ok(());
    };
    let port = one.port.as_ref().map(ToString::to_string).unwrap_or_default();
    let message = both!(
        "the drives at {port} want different line settings; expected one setting for a line",
        "die Antriebe an {port} wollen verschiedene Leitungseinstellungen; erwartet wird eine Einstellung für eine Leitung"
    );
    Err(Failure::new(Class::Usage, "usage.line", message)
        .hint(both!("one call for each setting", "ein Aufruf für jede Einstellung")))
}

/// Where the undo file of a drive stands, if it is named.
fn named(path: &Path, of: &Naming) -> Result<UndoPlace, Failure> {
    if !of.tells_apart(path) {
        let message = both!(
            "one undo file is of one drive, and several addresses were given",
            "eine Datei zum Zurücknehmen gehört zu einem Antrieb, und es sind mehrere Adressen angegeben"
        );
        return Err(of.refused(message, &Text::default()));
    }
    let place = UndoPlace::Named(of.own(path));
    place.check_typed().map_err(unbegun)?;
    Ok(place)
}

/// Beside which name the undo file of a drive stands: each has its own.
fn beside(file: &Path, of: &Naming) -> PathBuf {
    if of.tells_apart(file) {
        return of.own(file);
    }
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    file.with_file_name(format!("{stem}-{}.toml", of.word()))
}
