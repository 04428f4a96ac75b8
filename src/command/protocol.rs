//! `protocol`: what a drive speaks on its line, and how it is brought to speak something else.

use super::Context;
use super::line::{move_drive, show};
use super::lines::OverLines;
use super::verb::{Verb, Working};
use crate::args::Takes;
use crate::drive::Upper;
use crate::drive::relocate::Wish;
use crate::failure::Failure;
use crate::outcome::{Document, OrRead, Outcome, Relocation};
use crate::tick::Span;
use clap::{Args as ClapArgs, Subcommand};

/// Shows or changes what a drive speaks: RTU, ASCII, VABus.
///
/// A drive leaves the factory speaking VABus. `protocol set rtu` brings it to Modbus without a keypad: it writes P.395,
/// which holds at once, follows the drive, and proves that it answers. If it does not, but the old protocol still does,
/// everything is left as it was. The way back is printed.
///
/// On a CAN bus (--protocol sdo) `set sdo1` switches the channel for tools off (P.923 = 0) and goes over SDO1, and `set sdo` the way back;
/// when that holds is in no source, so the drive is looked for over both.
///
/// The options say how the drive is reached now: antrieb --protocol vabus -a 1 protocol set rtu
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// Protocol, speed, parity and addresses as they are stored in the drive
    Show,
    /// Brings the drive to another protocol
    Set {
        /// rtu, ascii, vabus; on a CAN bus sdo, sdo1
        #[arg(id = "to", value_name = "PROTOCOL", value_parser = Wish::to_protocol)]
        wish: Wish,
    },
}

impl Verb for Args {
    const NAME: &'static str = "protocol";
    const TAKES: Takes = Takes::WRITES;
    const SDO: bool = true;
    const EXAMPLES: &'static [&'static str] =
        &["antrieb --port sim -a 1 protocol show", "antrieb --port sim -a 1 protocol set ascii --dry-run"];
    const UPPER: Upper = Upper::drive(120).besides(Span::from_secs(60));
    type Prints = Document<OrRead<Relocation>>;

    fn over_lines(&self) -> OverLines {
        if matches!(self.what, What::Show) { OverLines::Each } else { OverLines::One(None) }
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Shows or changes it.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    match args.what {
        What::Show => show(context).await,
        What::Set { wish } => move_drive(wish, context).await,
    }
}
