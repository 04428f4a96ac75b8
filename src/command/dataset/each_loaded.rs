//! `dataset load` of several drives: the same files, or a file for each, and a transaction for each, as `apply` does it.

use super::load::{LoadArgs, read_all, unbegun};
use super::one_of;
use super::save::ADDRESS;
use crate::args::{Place, called};
use crate::command::Context;
use crate::command::plant::apply;
use crate::command::plant::lines::{Said, Wanted};
use crate::drive::transaction::UndoPlace;
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::text::both;
use std::path::{Path, PathBuf};

/// Loads files into every drive that was named, behind one question.
pub(super) async fn load(args: &LoadArgs, context: &mut Context<'_>, addresses: &[u8]) -> Result<Outcome, Failure> {
    super::not_everybody(addresses)?;
    context.settings.check_one_line()?;
    if context.settings.force {
        let message = both!(
            "--force loads into one drive: what it overrides is looked at one by one",
            "--force lädt in einen Antrieb: was es übergeht, wird einzeln angesehen"
        );
        return Err(one_of(Failure::new(Class::Usage, "usage.force", message), addresses));
    }
    let names = called(context.settings)?;
    let wanted = addresses.iter().map(|&address| {
        let name = names.get(&address).cloned().unwrap_or_else(|| address.to_string());
        of_drive(args, context, address, name)
    });
    let wanted = wanted.collect::<Result<Vec<_>, _>>()?;
    apply::write(context, wanted, false, async |_, wanted| Ok(wanted)).await
}

/// What one of the drives shall have.
fn of_drive(args: &LoadArgs, context: &Context<'_>, address: u8, name: String) -> Result<Wanted, Failure> {
    let settings = context.settings;
    let files: Vec<PathBuf> = args.files.iter().map(|file| own(file, address)).collect();
    let opened = read_all(&files, settings, context.registry)?;
    let (steps, left_out) = args.scope.choice().steps(&opened.settings, &opened.family)?;
    let undo = match (&args.undo_file, args.files.first()) {
        (Some(path), _) => named(path, address)?,
        (None, first) => UndoPlace::Beside(beside(first.map(PathBuf::as_path).unwrap_or(Path::new("")), address)),
    };
    let place = Place { name, address, product: None, files, settings: settings.clone() };
    Ok(Wanted { place, said: Said::Typed, opened, steps, left_out, undo, unsettled: None })
}

/// The file of the drive at an address.
fn own(file: &Path, address: u8) -> PathBuf {
    PathBuf::from(file.to_string_lossy().replace(ADDRESS, &address.to_string()))
}

/// Where the undo file of a drive stands, if it is named.
fn named(path: &Path, address: u8) -> Result<UndoPlace, Failure> {
    let own = own(path, address);
    if own == path {
        let message = both!(
            "one undo file is of one drive, and several addresses were given",
            "eine Datei zum Zurücknehmen gehört zu einem Antrieb, und es sind mehrere Adressen angegeben"
        );
        return Err(Failure::new(Class::Usage, "usage.file", message)
            .hint(both!("put {{address}} into its name", "{{address}} in ihren Namen setzen")));
    }
    let place = UndoPlace::Named(own);
    place.check_typed().map_err(unbegun)?;
    Ok(place)
}

/// Beside which name the undo file of a drive stands: each has its own.
fn beside(file: &Path, address: u8) -> PathBuf {
    let own = own(file, address);
    if own != file {
        return own;
    }
    let stem = file.file_stem().unwrap_or_default().to_string_lossy();
    file.with_file_name(format!("{stem}-{address}.toml"))
}
