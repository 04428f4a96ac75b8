//! `dataset`: the four data sets of a drive, and its settings as a file.

mod check;
mod diff;
mod each_loaded;
pub(super) mod load;
pub(super) mod loaded;
mod naming;
mod of_each;
pub(super) mod opened;
mod save;
pub(super) mod scope;
mod sets;
pub(super) mod weighing;
mod which;

use super::again::one_of;
use super::lines::OverLines;
use super::profibus::{SlaveArgs, through};
use super::verb::{Verb, Working};
use super::{Context, name_one, running};
use crate::args::Takes;
use crate::drive::Upper;
use crate::failure::{Class, Failure};
use crate::outcome::{Dataset, Document, OrFile, OrLoad, Outcome};
use crate::text::both;
use clap::{Args as ClapArgs, Subcommand};

/// Shows, selects, copies a drive's data sets; saves and compares its settings.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    action: Action,
    #[command(flatten)]
    slave: SlaveArgs,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    #[command(flatten)]
    Sets(sets::Action),
    /// Compare data sets, files, drives, factory settings; 1 if they differ
    ///
    /// A side is a data set (1-4, 1ram-4ram), a file of `dataset save`, `factory`, `drive` (the one at -a) or `drive:3`.
    /// Two data sets are compared whole. Otherwise what a file holds is compared, or what has a known factory setting.
    Diff(diff::Options),
    /// Save a drive's settings into a file
    ///
    /// Every parameter that is a setting is read, in all four data sets, as it is stored in the EEPROM. The file is text (TOML): a
    /// line for each value, and in its head what it does not hold and why. It is written whole or not at all; what an interrupted
    /// save has read is kept in FILE.part, and --resume goes on with it.
    Save(save::Options),
    /// Check a drive against a file; exits with 1 if they differ
    ///
    /// Asked is what the file holds, and nothing else.
    Check(check::Options),
    /// Write parameter files into a drive: all of it, or nothing
    Load(load::LoadArgs),
    /// Take a `dataset load` back, by the undo file that it left
    Undo(load::UndoArgs),
}

impl Verb for Args {
    const NAME: &'static str = "dataset";
    const TAKES: Takes = Takes::WRITES;
    const SDO: bool = true;
    const PROFIBUS: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1 dataset show 372",
        "antrieb --port sim -a 1 dataset active",
        "antrieb --port sim -a 1 dataset select 2 --ram --yes",
        "antrieb --port sim -a 1 dataset copy 1 2 480-483 --yes",
        "antrieb --port sim -a 1 dataset diff 1 2 372",
        "antrieb --port sim -a 1 dataset diff factory drive",
        "antrieb --port sim -a 1 dataset save pump.toml",
        "antrieb --port sim -a 1,2 dataset save --changed 'drive-{address}.toml'",
        "antrieb --port sim -a 1 dataset check pump.toml",
        "antrieb --port sim -a 1 dataset load base.toml extra.toml --yes",
        "antrieb --port sim -a 1 dataset load base.toml --only motor,ramps --dry-run",
        "antrieb --port sim -a 1 dataset undo base.undo.toml --yes",
        "antrieb --port sim --protocol dp -a 3 dataset save mixer.toml --yes",
    ];
    const UPPER: Upper = Upper::drive(30).each(48, "parameter");
    type Prints = Document<OrFile<OrLoad<Dataset>>>;

    fn over_lines(&self) -> OverLines {
        match &self.action {
            Action::Load(_) => OverLines::Itself,
            Action::Undo(_) => OverLines::One(Some(both!(
                "an undo file is of one drive: name it, as in `antrieb -a NAME dataset undo FILE`",
                "eine Datei zum Zurücknehmen gehört zu einem Antrieb: ihn nennen, wie in `antrieb -a NAME dataset undo DATEI`"
            ))),
            Action::Sets(sets::Action::Select { .. } | sets::Action::Copy { .. }) => OverLines::One(None),
            _ => OverLines::Each,
        }
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Works on the data sets of drives, or on files.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let is_offline = matches!(&args.action, Action::Diff(options) if !options.is_live());
    if !args.slave.is_meant(context.settings)? || is_offline {
        return act(args, context).await;
    }
    let why = match &args.action {
        Action::Load(_) | Action::Undo(_) | Action::Sets(sets::Action::Select { .. } | sets::Action::Copy { .. }) => {
            both!("to write its parameters", "um ihre Parameter zu schreiben")
        }
        _ => both!("to read its parameters; nothing is written", "um ihre Parameter zu lesen; geschrieben wird nichts"),
    };
    through((&args.slave, &why), context, async |context: &mut Context<'_>| act(args, context).await).await
}

async fn act(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    match &args.action {
        Action::Save(options) => save::run(options, context).await,
        Action::Check(options) => check::run(options, context).await,
        Action::Diff(options) => match options.sets() {
            Some(pair) if !options.unified || context.settings.dry_run => {
                sets::run(&sets::Action::Diff { pair, params: options.params.clone() }, context).await
            }
            _ => diff::run(options, context).await,
        },
        Action::Load(options) => match running::several(context.settings) {
            Some(addresses) => each_loaded::load(options, context, &addresses).await,
            None => load::load(options, context).await,
        },
        Action::Undo(options) => load::undo(options, context).await,
        Action::Sets(sets::Action::Copy { .. }) if context.settings.is_can() => Err(no_copy()),
        Action::Sets(action) => sets::run(action, context).await,
    }
}

/// Over SDO no answer tells a width, so a copy might not be one.
fn no_copy() -> Failure {
    let message = both!(
        "`dataset copy` does not speak SDO: no answer tells how wide a value is",
        "`dataset copy` spricht kein SDO: keine Antwort sagt, wie breit ein Wert ist"
    );
    Failure::new(Class::Usage, "usage.sdo", message).hint(both!(
        "`antrieb dataset save` and `antrieb dataset load` go over SDO, and leave out what no source tells the width of",
        "`antrieb dataset save` und `antrieb dataset load` gehen über SDO und lassen weg, wovon keine Quelle die Breite nennt"
    ))
}

/// What takes a load back is of one drive.
fn only_one(addresses: &[u8]) -> Result<u8, Failure> {
    not_everybody(addresses)?;
    match addresses {
        &[address] => Ok(address),
        _ => {
            let message = both!(
                "expected the address of one drive, got several: an undo file is of one drive",
                "erwartet: die Adresse eines Antriebs; angegeben sind mehrere, und eine Datei zum Zurücknehmen gehört zu einem"
            );
            Err(one_of(Failure::new(Class::Usage, "usage.address", message), addresses))
        }
    }
}

/// Nobody answers to address 0.
fn not_everybody(addresses: &[u8]) -> Result<(), Failure> {
    if !addresses.contains(&0) {
        return Ok(());
    }
    let message = both!(
        "expected addresses of drives, got 0 (everybody), and nobody answers to that",
        "erwartet: Adressen von Antrieben; angegeben ist 0 (alle), und darauf antwortet niemand"
    );
    Err(Failure::new(Class::Usage, "usage.address", message).hint(name_one()))
}
