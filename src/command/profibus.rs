//! `profibus`: what a PROFIBUS master has to be told of a Hitachi SJ2-PB.

use super::verb::{Verb, Working};
use super::{Context, named_family};
use crate::args::Takes;
use crate::drive::profibus;
use crate::failure::Failure;
use crate::outcome::{BasicModule, Data, Document, Outcome};
use clap::{Args as ClapArgs, Subcommand};

/// Makes and explains the bytes that a PROFIBUS master sends to a Hitachi SJ2-PB.
///
/// No line is opened. What a telegram says is told by `decode`.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// A module of the Basic mode: by name, or by its bytes
    ///
    /// By name: the series (or --drive), get or set, and a parameter: its index, the maker's short name, its name, or an
    /// address. Behind it may stand "address based", "swapped", and for what is set "min 0x0001 max 0x7530", raw. "basic block" is
    /// the four words in and out. By bytes: those of the module in Set_Prm. What the GSD wants in front of them, and the ident
    /// number, are in no source.
    Module {
        /// L200 set deceleration, or 81 00 07
        #[arg(required = true, value_name = "MODULE")]
        module: Vec<String>,
    },
}

impl Verb for Args {
    const NAME: &'static str = "profibus";
    const TAKES: Takes = Takes::BROWSES;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb profibus module L200 get acceleration",
        "antrieb profibus module L200 set deceleration min 0x0001 max 0x7530",
        "antrieb profibus module X200 get F002 swapped address based",
        "antrieb profibus module C7 FF FF",
    ];
    type Prints = Document<BasicModule>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(std::future::ready(run(self, context)))
    }
}

/// Makes or explains a module.
pub fn run(args: &Args, context: &Context<'_>) -> Result<Outcome, Failure> {
    let What::Module { module } = &args.what;
    let (settings, registry) = (context.settings, context.registry);
    let named = settings.drive.as_deref().map(|name| named_family(settings, registry, name)).transpose()?;
    let found = profibus::module(&module.join(" "), named.as_deref(), registry)?;
    Ok(Outcome::of(Data::BasicModule(found)))
}
