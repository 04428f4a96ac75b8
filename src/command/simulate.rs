//! `simulate`: the built-in bench in real time, for any master.

use super::Context;
use super::verb::{Verb, Working};
use crate::args::{Takes, parse_span};
use crate::drive::bench;
use crate::failure::Failure;
use crate::outcome::{Data, Document, Outcome, Simulate};
use crate::tick::Span;
use clap::Args as ClapArgs;
use std::net::SocketAddr;
use std::path::PathBuf;

/// Serves simulated drives on a pseudo terminal or a TCP port.
///
/// Any Modbus master may talk to them, one after the other: this program from another window, mbpoll, pymodbus, a PLC
/// programming tool. A drive stays silent when baud rate, parity or width do not fit its own, as a real one does.
/// Ends on Ctrl-C with counts.
#[derive(Clone, Debug, ClapArgs)]
#[command(after_long_help = bench::FILE_HELP)]
pub struct Args {
    /// Bench file [default: an ACT at 1, an ACU at 2]
    #[arg(value_name = "BENCH.toml")]
    pub bench: Option<PathBuf>,

    /// A PROFIBUS line with Hitachi inverters on it
    ///
    /// An L200 at 3 and an SJ200 at 5, or those of the file. Their watchdogs run, and what they do without a master is what P.703 or P.620 says. The ident number of the modules is made
    /// up: the true one is in no source.
    #[arg(long)]
    pub profibus: bool,

    /// A CAN bus with drives on it, behind an adapter
    ///
    /// ACUs as nodes 1 and 2 at 500 kbit/s without a master, or those of the file. The adapter speaks SLCAN: this program
    /// reaches it with -p slcan:PATH, python-can and slcand as any other.
    #[arg(long, conflicts_with = "profibus")]
    pub can: bool,

    /// Name the pseudo terminal with this symbolic link
    #[arg(long, value_name = "PATH", conflicts_with = "tcp")]
    pub link: Option<PathBuf>,

    /// Serve on a loopback address, such as 127.0.0.1:5020
    ///
    /// In place of a pseudo terminal. Windows has none: there a free port is taken without this option.
    #[arg(long, value_name = "ADDR:PORT")]
    pub tcp: Option<SocketAddr>,

    /// End after this time
    #[arg(long, visible_alias = "for", value_name = "TIME", value_parser = parse_span)]
    pub duration: Option<Span>,
}

impl Verb for Args {
    const NAME: &'static str = "simulate";
    const TAKES: Takes = Takes::SERVES;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb simulate --link drive --duration 1m",
        "antrieb simulate bench.toml --tcp 127.0.0.1:5020",
        "antrieb simulate --profibus --link drive --duration 1m",
        "antrieb simulate --can --link adapter --duration 1m",
    ];
    type Prints = Document<Simulate>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Serves until Ctrl-C.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let place = match args.tcp {
        Some(address) => bench::Place::Tcp { addr: address },
        None => bench::Place::Pty { link: args.link.clone() },
    };
    let (file, registry) = (args.bench.as_deref(), context.registry);
    let served = match (args.profibus, args.can) {
        (_, true) => {
            let mut bus = bench::can(file, registry)?;
            bench::serve_can(&mut bus, place, args.duration, &context.interrupt, context.observe).await?
        }
        (true, _) => {
            let mut bus = bench::profibus(file, registry)?;
            bench::serve_profibus(&mut bus, place, args.duration, &context.interrupt, context.observe).await?
        }
        _ => {
            let mut drives = bench::load(file, registry)?;
            bench::serve(&mut drives, place, args.duration, &context.interrupt, context.observe).await?
        }
    };
    Ok(Outcome::of(Data::Simulate(served)))
}
