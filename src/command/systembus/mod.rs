//! `systembus`: the CAN bus between drives: as it is planned (EM-RES-03 manual 5.11, 5.14), as drives are set to it, and the one into the other.

mod agree;
mod load;
mod monitor;
mod nmt;
mod plan;
mod seated;
mod show;

use super::Context;
use super::lines::OverLines;
use super::verb::{Flow, Verb, Working};
use crate::args::Takes;
use crate::drive::Upper;
use crate::outcome::{Document, OrBus};
use clap::{Args as ClapArgs, Subcommand};

/// Plans the system bus (CAN) of ACTIVE Cube drives, and sets drives to it.
///
/// A plan says which drive sends which PDO to whom, and what stands in it (docs/system-bus.md). It becomes the list of communication
/// relations, the virtual links in both directions and every setting of each drive; what the manual forbids or advises against is
/// told.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Check a plan and show what becomes of it
    ///
    /// A plan (TOML), or a DCF for each drive. Exit code 1 if it breaks a rule. No drive is needed.
    Plan(plan::Options),
    /// What PDOs cost the bus
    ///
    /// Without a rate the tables of the manual: time of a telegram and load by rate and send time. With a rate and send times their sum.
    /// A PDO counts with 140 bits; SYNC, SDO, NMT and emergencies are not in it. Up to 80 % is okay, up to 90 % critical. Exit
    /// code 1 above that.
    Load(load::Options),
    /// How drives are set to the bus
    ///
    /// Node, rate, identifiers, times, and what fills the PDOs and takes from them, read from P.900 to P.989 over any protocol. Nothing
    /// in a drive is changed.
    Show,
    /// Is a plan in its drives? 1 if a value differs
    ///
    /// Asked is what the plan decides. A drive that does not answer is named (exit 9).
    Check(seated::Options),
    /// Write a plan into its drives, with one question
    ///
    /// All drives or none: every drive is read and checked first, each value is proven, and whatever goes wrong, what was written goes
    /// back. Each drive leaves an undo file beside the plan. Every function is written, also of what the plan leaves unused. How a drive
    /// counts the functions of its RxPDOs (P.936 to P.938) is seen where a 2 stands; else the plan must say (rx-functions). Over
    /// SDO the place of a drive on the bus (P.900, 903, 921 to 923) is not changed.
    Apply(seated::Options),
    /// Watch the bus. Never sends
    ///
    /// Needs a CAN adapter, which listens only. With a plan PDOs have the names of their senders, and what stands in them its source and its takers; numbers
    /// are raw, because no scale is printed. Told as it comes: network, boot-ups, emergencies, what is missing, and the first frame of
    /// each identifier; --format ndjson has every frame. At the end a table, and the load. Ctrl-C is the usual end, with exit code 0.
    Monitor(monitor::Options),
    /// Start or stop the exchange of PDOs, reset nodes
    ///
    /// As master of the network; where another one is heard nothing is sent without --force. `start` and `reset` ask, because what PDOs bring can turn a
    /// shaft. `stop` and `preop` are no stop of a shaft, and a master undoes them. What the nodes show behind it is the proof: P.978, the silence of a
    /// stopped node, a boot-up.
    Nmt(nmt::Options),
}

impl Verb for Args {
    const NAME: &'static str = "systembus";
    const SDO: bool = true;
    const TAKES: Takes = Takes::SYSTEM_BUS;
    const PARTS: &'static [(&'static str, Takes)] = &[
        ("plan", Takes::BROWSES),
        ("load", Takes::BROWSES),
        ("show", Takes::READS),
        ("check", Takes::READS),
        ("monitor", Takes::HEARS),
    ];
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb systembus plan bus.toml",
        "antrieb systembus plan bus.toml --dcf . --svg bus.svg",
        "antrieb systembus load",
        "antrieb systembus load 500 1 2 8",
        "antrieb --port sim --protocol sdo -a 1,2 systembus show",
        "antrieb --port sim --protocol sdo systembus check bus.toml drive-2",
        "antrieb --port sim --protocol sdo systembus apply bus.toml drive-2 --yes",
        "antrieb -p slcan:/dev/ttyACM0 -b 500000 systembus monitor bus.toml",
        "antrieb --port sim --protocol sdo systembus nmt start --node 1 --yes",
    ];
    const UPPER: Upper = Upper::drive(160).each(48, "parameter");
    type Prints = Document<OrBus>;

    fn streams(&self) -> Option<Flow> {
        matches!(self.action, Action::Monitor(_)).then_some(Flow::Telegrams { capture: None })
    }

    fn over_lines(&self) -> OverLines {
        if matches!(self.action, Action::Show) { OverLines::Each } else { OverLines::One(None) }
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        let alone = |part| context.settings.typed.unkept(Takes::BROWSES, part).map_or(Ok(()), Err);
        match &self.action {
            Action::Plan(options) => {
                let run = alone("systembus plan").and_then(|()| plan::run(options, context));
                Box::pin(std::future::ready(run))
            }
            Action::Load(options) => {
                let run = alone("systembus load").and_then(|()| load::run(options));
                Box::pin(std::future::ready(run))
            }
            Action::Show => Box::pin(show::run(context)),
            Action::Check(options) => Box::pin(agree::check(options, context)),
            Action::Apply(options) => Box::pin(agree::apply(options, context)),
            Action::Monitor(options) => Box::pin(monitor::run(options, context)),
            Action::Nmt(options) => Box::pin(nmt::run(options, context)),
        }
    }
}
