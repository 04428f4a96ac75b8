//! `params`: browse the catalogue, without a drive; take a list of parameters into a catalogue of one's own, and write one.

mod export;
mod import;
mod told;

use super::verb::{Verb, Working};
use super::{Context, offline_family};
use crate::args::Takes;
use crate::drive::describe;
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, ListOr, Outcome, Params};
use crate::profile::{Family, Param};
use crate::text::both;
use clap::{Args as ClapArgs, Subcommand};

/// Browses the parameter catalogue. No drive is needed.
///
/// Shows every parameter whose number, slug or name contains the words; with one hit, everything that is known of it:
/// unit, type, range, factory setting, data sets, values, bits, source. --drive act or acu picks the drive.
/// `params -- import` looks for the word "import".
#[derive(Clone, Debug, ClapArgs)]
#[command(args_conflicts_with_subcommands = true)]
pub struct Args {
    /// Number, range such as 480-483, or words of a slug or name
    #[arg(value_name = "SEARCH")]
    pub search: Vec<String>,
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Make a catalogue of your own of a list: CSV, or MBMap (JSON)
    ///
    /// A table (CSV) of a site or a supplier, or a map of registers in the MBMap format, version 2. Columns are guessed from their headings (German or English) and contents. What was taken for what, and which rows were
    /// left out and why, stands above the catalogue, or on stdout with --output. What the list does not say stays open;
    /// whatever it does not allow to write is read only. The catalogue is loaded as --catalogue would before it is written.
    /// Rows are for the family that `params` shows (--drive), or with --own for one of its own, which is read, watched and
    /// written over plain Modbus and never moved. An MBMap always brings a family of its own.
    Import(import::Options),
    /// Write parameters as a table (CSV) that `params import` takes back
    Export(export::Options),
}

impl Verb for Args {
    const NAME: &'static str = "params";
    const TAKES: Takes = Takes::BROWSES;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb params 372",
        "antrieb params rated",
        "antrieb --drive lxm05 params nenn --format csv",
        "antrieb params import list.csv --set access=rw",
        "antrieb params export rated",
    ];
    type Prints = Document<ListOr<Params>>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(std::future::ready(run(self, context)))
    }
}

/// Searches the catalogue, or takes or writes a list.
pub fn run(args: &Args, context: &Context<'_>) -> Result<Outcome, Failure> {
    match &args.action {
        None => search(args, context),
        Some(Action::Import(options)) => import::run(options, context),
        Some(Action::Export(options)) => export::run(options, context),
    }
}

/// What the words mean: one number, a range of them, or every parameter that has them.
fn hits<'f>(family: &'f Family, words: &[String]) -> Vec<&'f Param> {
    let query = words.join(" ");
    let number = |text: &str| text.trim().parse::<u32>().ok();
    let range = query.split_once('-').and_then(|(first, last)| Some(number(first)?..=number(last)?));
    match (number(&query).and_then(|id| family.param(id)), range) {
        (Some(exact), _) => vec![exact],
        (None, Some(range)) => family.params.values().filter(|param| range.contains(&param.id)).collect(),
        (None, None) if query.trim().is_empty() => family.params.values().collect(),
        (None, None) => family.search(&query),
    }
}

fn search(args: &Args, context: &Context<'_>) -> Result<Outcome, Failure> {
    let family = offline_family(context.settings, context.registry)?;
    let params: Vec<_> =
        hits(&family, &args.search).into_iter().map(|param| describe::param_doc(&family, param)).collect();
    let none = params.is_empty().then(|| none(&family, &args.search));
    let data = Params { drive: family.drive.clone(), params };
    Ok(Outcome { data: Some(Data::Params(data)), warnings: Vec::new(), failure: none })
}

fn none(family: &Family, words: &[String]) -> Failure {
    let message = both!(
        "no parameter of '{drive}' contains '{query}'",
        "kein Parameter von '{drive}' enthält '{query}'",
        drive = family.drive,
        query = words.join(" ")
    );
    Failure::new(Class::No, "no.parameter_found", message).hint(both!(
        "a drive has more parameters than its catalogue: `antrieb read NUMBER` reads any of them",
        "ein Antrieb hat mehr Parameter als sein Katalog: `antrieb read NUMMER` liest jeden davon"
    ))
}
