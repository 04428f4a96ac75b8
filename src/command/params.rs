//! `params`: browse the catalogue, without a drive.

use super::verb::{Verb, Working};
use super::{Context, offline_family};
use crate::args::Takes;
use crate::drive::describe;
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, Outcome, Params};
use crate::text::both;
use clap::Args as ClapArgs;

/// Browses the parameter catalogue. No drive is needed.
///
/// Shows every parameter whose number, slug or name contains the words; with one hit, everything that is known of it:
/// unit, type, range, factory setting, data sets, values, bits, source. --drive act or acu picks the drive.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// Number, or words of a slug or name
    #[arg(value_name = "SEARCH")]
    pub search: Vec<String>,
}

impl Verb for Args {
    const NAME: &'static str = "params";
    const TAKES: Takes = Takes::BROWSES;
    const EXAMPLES: &'static [&'static str] =
        &["antrieb params 372", "antrieb params rated", "antrieb --drive lxm05 params nenn --format csv"];
    type Prints = Document<Params>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(std::future::ready(run(self, context)))
    }
}

/// Searches the catalogue.
pub fn run(args: &Args, context: &Context<'_>) -> Result<Outcome, Failure> {
    let family = offline_family(context.settings, context.registry)?;
    let query = args.search.join(" ");
    let number: Option<u32> = query.trim().parse().ok();
    let rows = match number.and_then(|id| family.param(id)) {
        Some(exact) => vec![exact],
        None if query.trim().is_empty() => family.params.values().collect(),
        None => family.search(&query),
    };
    let params: Vec<_> = rows.into_iter().map(|param| describe::param_doc(&family, param)).collect();
    let none = params.is_empty().then(|| {
        Failure::new(
            Class::No,
            "no.parameter_found",
            both!(
                "no parameter of '{drive}' contains '{query}'",
                "kein Parameter von '{drive}' enthält '{query}'",
                drive = family.drive
            ),
        )
        .hint(both!(
            "a drive has more parameters than its catalogue: `antrieb read NUMBER` reads any of them",
            "ein Antrieb hat mehr Parameter als sein Katalog: `antrieb read NUMMER` liest jeden davon"
        ))
    });
    let data = Params { drive: family.drive.clone(), params };
    Ok(Outcome { data: Some(Data::Params(data)), warnings: Vec::new(), failure: none })
}
