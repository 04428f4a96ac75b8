//! `plan`: what would be written to the drives of a plant.

use super::lines::{on_lines, wanted};
use super::told::{LEFT_OUT, NOT_YET};
use super::{dry_run, look, must_choose, told};
use crate::args::Takes;
use crate::command::Context;
use crate::command::dataset::loaded::nothing_to_come;
use crate::command::dataset::scope::Scope;
use crate::command::verb::{Verb, Working};
use crate::drive::Upper;
use crate::drive::transaction::NO_VALUES;
use crate::failure::{Class, Failure};
use crate::outcome::{Document, Outcome, Plant};
use crate::text::both;
use clap::Args as ClapArgs;

/// Shows what `apply` would write; 1 if something would change.
///
/// Reads every drive that antrieb.toml names, all ports at once, and holds it against its parameter files. Nothing is written. A drive
/// that does not answer, is another one than antrieb.toml says, or may not be written to now is left out and named.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(flatten)]
    scope: Scope,
}

impl Verb for Args {
    const NAME: &'static str = "plan";
    const OF_PLANT: bool = true;
    const TAKES: Takes = Takes::READS;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim --config plant.toml plan",
        "antrieb --port sim --config plant.toml -a pump plan --only motor,ramps",
        "antrieb --port sim --config plant.toml -a @water plan --json",
    ];
    const UPPER: Upper = Upper::drive(30).each(48, "parameter");
    type Prints = Document<Plant>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let wanted = wanted(context, &args.scope.choice())?;
    must_choose(&wanted).map_err(not_chosen)?;
    if context.settings.dry_run {
        return dry_run(context, &wanted);
    }
    on_lines(context, wanted, async |lines, wanted, _| {
        look(lines, Args::UPPER, &nothing_to_come()).await;
        let told = told::plant(&wanted, lines, (false, LEFT_OUT));
        let failure = told.failure.map(|failure| if failure.code == NOT_YET { writes(failure, args) } else { failure });
        Outcome { failure, ..told }
    })
    .await
}

/// Of a plan 1 says that something would change: where nothing is meant, nobody knows that.
fn not_chosen(failure: Failure) -> Failure {
    Failure { class: Class::Data, code: NO_VALUES.to_owned(), ..failure }
}

/// What would write just that.
fn writes(failure: Failure, args: &Args) -> Failure {
    let scope = args.scope.typed();
    failure.hint(both!("`antrieb apply{scope}` writes it", "`antrieb apply{scope}` schreibt es"))
}
