//! `systembus`: the CAN bus between drives as it is planned (EM-RES-03 manual 5.11, 5.14). No drive is needed.

mod load;
mod plan;

use super::Context;
use super::verb::{Verb, Working};
use crate::args::Takes;
use crate::outcome::{BusLoad, BusPlan, Document, OrBusLoad};
use clap::{Args as ClapArgs, Subcommand};

/// Plans the system bus (CAN) of ACTIVE Cube drives. No drive is needed.
///
/// A plan says which drive sends which PDO to whom, and what stands in it (docs/system-bus.md). It becomes the list of communication
/// relations, the virtual links in both directions and every setting of each drive; what the manual forbids or advises against is
/// told. Nothing is written to a drive.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Check a plan and show what becomes of it
    ///
    /// A plan (TOML), or a DCF for each drive. Exit code 1 if it breaks a rule.
    Plan(plan::Options),
    /// What PDOs cost the bus
    ///
    /// Without a rate the tables of the manual: time of a telegram and load by rate and send time. With a rate and send times their sum.
    /// A PDO counts with 140 bits; SYNC, SDO, NMT and emergencies are not in it. Up to 80 % is okay, up to 90 % critical. Exit
    /// code 1 above that.
    Load(load::Options),
}

impl Verb for Args {
    const NAME: &'static str = "systembus";
    const TAKES: Takes = Takes::BROWSES;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb systembus plan bus.toml",
        "antrieb systembus plan bus.toml --dcf . --svg bus.svg",
        "antrieb systembus load",
        "antrieb systembus load 500 1 2 8",
    ];
    type Prints = Document<OrBusLoad<BusPlan, BusLoad>>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(std::future::ready(match &self.action {
            Action::Plan(options) => plan::run(options, context),
            Action::Load(options) => load::run(options),
        }))
    }
}
