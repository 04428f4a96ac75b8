//! `profibus`: a line of it without a controller, and what a master has to be told of a Hitachi SJ2-PB.

mod diag;
mod given;
mod identify;
pub(super) mod job;
mod mode;
pub(super) mod read;
pub(super) mod run;
mod scan;
mod show;
pub(super) mod spoken;
mod taking;
mod through;
mod told;
mod watch;
pub(super) mod write;

pub(super) use diag::diag;
pub use given::SlaveArgs;
pub(super) use identify::identify;
pub(super) use scan::{Ends, scan};
pub(super) use show::show;
pub use spoken::ModeArg;
pub use taking::PRESUMED;
pub(super) use taking::refuse;
pub(super) use through::through;
pub(super) use watch::{Watch, watch};

use super::verb::{Flow, Verb, Working};
use super::{Context, named_family};
use crate::args::{Addresses, Settings, Takes, parse_span};
use crate::drive::profibus::Round;
use crate::drive::{Interrupt, Opening, Recording, open_port, profibus};
use crate::failure::{Class, Failure};
use crate::outcome::{BasicModule, Data, Document, Event, LiveList, OrLive, OrRead, OrRecord, Outcome, Plan};
use crate::profile::Registry;
use crate::text::both;
use crate::tick::Span;
use clap::{Args as ClapArgs, Subcommand};

/// Looks at a PROFIBUS line without a controller; bytes for a Hitachi SJ2-PB.
///
/// What a telegram says is told by `decode`.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(Clone, Debug, Subcommand)]
enum What {
    /// Who is on the line: stations, idents, states, configurations
    ///
    /// Asks every address from 0 to 125, or those given with -a, for its FDL status, and the slaves for Slave_Diag and Get_Cfg.
    /// That changes nothing in a slave. We are master 0 on the line and pass no token. The line is listened to for 1.25 s first: if
    /// another master asks on it, nothing is sent, and the exit code is 8.
    ///
    /// The ident number of an SJ2-PB is in no source: it is read here. One station alone is told in full.
    Live {
        /// How soon an answer begins [default: 30ms or 8ms]
        ///
        /// 8 ms hold from 93750 Bd on. An adapter that holds bytes back needs more.
        #[arg(long, value_name = "TIME", value_parser = parse_span)]
        slot_time: Option<Span>,
        /// Ask each station so often how it is
        ///
        /// Its FDL status. Told are repeats as a histogram, questions without an answer, and the shortest, median and longest reply time, with
        /// what the adapter adds.
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
        questions: Option<u32>,
        /// Go on asking: stations as they come, go, or change
        ///
        /// A line for each, with state and ident number; --format ndjson streams them. Who is there is asked every 0.5 s, and a new one is
        /// found within a round over all addresses. Ctrl-C or --duration end it.
        #[arg(long, conflicts_with = "questions")]
        follow: bool,
        /// End --follow after this time
        #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "follow")]
        duration: Option<Span>,
    },
    /// Parameters of one inverter, over PKW
    ///
    /// A slave tells its parameters only to a master that exchanges data with it, so it is taken for this (PPO1), held by the stop word
    /// 047E, and let go again, and you are asked before: a motor that a lost controller left running stops, and afterwards P.703 and
    /// A002 decide. The stop word goes on until the frequency is 0; only then go zero outputs, Clear and Unlock, also behind Ctrl-C. The
    /// watchdog of the slave is set to 2 s. Nothing is written to a parameter.
    Read {
        /// Indexes, short names (F002) or names
        #[arg(required = true, value_name = "PARAMETER")]
        parameters: Vec<String>,
        /// How it is taken.
        #[command(flatten)]
        slave: SlaveArgs,
    },
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
    const TAKES: Takes = Takes::PROFIBUS;
    const PROFIBUS: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim profibus live",
        "antrieb --port sim -a 3 profibus live",
        "antrieb --port sim -a 3 profibus live --questions 100",
        "antrieb --port sim -a 3 --yes profibus read F002 614",
        "antrieb profibus module L200 get acceleration",
        "antrieb profibus module L200 set deceleration min 0x0001 max 0x7530",
        "antrieb profibus module X200 get F002 swapped address based",
        "antrieb profibus module C7 FF FF",
    ];
    type Prints = OrRecord<Document<OrLive<OrRead<BasicModule>>>>;

    fn streams(&self) -> Option<Flow> {
        matches!(self.what, What::Live { follow: true, .. }).then_some(Flow::Telegrams { capture: None })
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        match &self.what {
            What::Live { slot_time, questions, follow, duration } => {
                let asked = Asked { questions: questions.unwrap_or_default(), follow: *follow, duration: *duration };
                Box::pin(live(*slot_time, asked, context))
            }
            What::Read { parameters, slave } => Box::pin(read::read(parameters, slave, context)),
            What::Module { module } => Box::pin(std::future::ready(self::module(module, context))),
        }
    }
}

/// Makes or explains a module.
fn module(module: &[String], context: &Context<'_>) -> Result<Outcome, Failure> {
    let (settings, registry) = (context.settings, context.registry);
    let named = settings.drive.as_deref().map(|name| named_family(settings, registry, name)).transpose()?;
    let found = profibus::module(&module.join(" "), named.as_deref(), registry)?;
    Ok(Outcome::of(Data::BasicModule(found)))
}

/// How a line is asked.
#[derive(Clone, Copy)]
struct Asked {
    questions: u32,
    follow: bool,
    duration: Option<Span>,
}

/// Tells who is on the line.
async fn live(slot_time: Option<Span>, asked: Asked, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let addresses = addresses(context.settings)?;
    if context.settings.dry_run {
        let telegrams = profibus::questions(addresses.first().copied());
        let count = addresses.len();
        let notes = vec![both!(
            "{count} address(es) are asked so; slaves for Slave_Diag and Get_Cfg as well",
            "{count} Adresse(n) werden auf diese Weise gefragt, Slaves dazu nach Slave_Diag und Get_Cfg"
        )];
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes })));
    }
    let Context { settings, registry, interrupt, observe, .. } = context;
    let mut line = open(slot_time, (settings, registry), interrupt, *observe).await?;
    let Asked { questions, follow, duration } = asked;
    let (found, ended) = match follow {
        true => {
            line.pace();
            let until = duration.map(|duration| line.now() + duration);
            profibus::follow(&mut line, &addresses, until).await
        }
        false => {
            let round = Round { addresses: &addresses, questions, until_first: false, until: None };
            profibus::live(&mut line, round).await
        }
    };
    if follow {
        return Ok(Outcome { data: Some(Data::LiveList(found)), warnings: Vec::new(), failure: ended });
    }
    let failure = ended.or_else(|| nobody(&found)).or_else(|| incomplete(&found));
    Ok(Outcome { data: Some(Data::LiveList(found)), warnings: Vec::new(), failure })
}

/// Opens the line that the settings name.
async fn open<'a>(
    slot_time: Option<Span>,
    (settings, registry): (&Settings, &Registry),
    interrupt: &Interrupt,
    observe: &'a mut dyn FnMut(Event),
) -> Result<profibus::Line<'a>, Failure> {
    settings.check_one_line()?;
    let port = open_port(settings.port.as_ref(), observe)?;
    let opening = Opening {
        port: &port,
        line: settings.line,
        rs485: settings.rs485,
        retries: settings.retries,
        trace: settings.trace.as_deref().map(|path| Recording { path, overwrite: settings.force }),
        verbose: settings.verbose,
        ..Opening::at(&port)
    };
    if settings.verbose {
        observe(Event::Note(settings.told()));
    }
    if let Some(note) = &settings.port_note {
        observe(Event::Note(note.clone()));
    }
    profibus::Line::open(opening, slot_time, registry, interrupt.clone(), observe).await
}

/// Addresses to ask: those that were named, or all.
fn addresses(settings: &Settings) -> Result<Vec<u8>, Failure> {
    let everybody = profibus::everybody();
    let Addresses::Named(list) = &settings.addresses else { return Ok(everybody) };
    let Some(wrong) = list.iter().find(|address| !everybody.contains(address)) else { return Ok(list.clone()) };
    let message = both!(
        "there is no station {wrong}: expected addresses from 0 to 125",
        "es gibt keine Station {wrong}: erwartet werden Adressen von 0 bis 125"
    );
    Err(Failure::new(Class::Usage, "usage.address", message))
}

/// Why it was of no use to ask.
fn nobody(found: &LiveList) -> Option<Failure> {
    if !found.stations.is_empty() {
        return None;
    }
    let line = &found.line;
    let message = both!("nobody answers at {line}", "bei {line} antwortet niemand");
    Some(Failure::new(Class::No, "no.station", message).hint(both!(
        "another speed with --baud (9600, 19200, 93750, 187500, 500000)? A slave finds the speed by itself, but not every adapter \
         reaches it; adapters often label A and B the other way; termination and bias need the 5 V of pin 6",
        "eine andere Baudrate mit --baud (9600, 19200, 93750, 187500, 500000)? Ein Slave findet sie selbst, aber nicht jeder \
         Adapter erreicht sie; Adapter beschriften A und B oft umgekehrt; Abschluss und Ruhepegel brauchen die 5 V von Pin 6"
    )))
}

/// Why the rows do not tell everything.
fn incomplete(found: &LiveList) -> Option<Failure> {
    let first = found.stations.iter().find(|station| station.error.is_some())?;
    let address = first.address;
    let message = both!(
        "station {address} did not answer everything; the rows say which else",
        "Station {address} hat nicht alles beantwortet; die Zeilen sagen, welche noch"
    );
    Some(Failure::new(Class::Partial, "partial", message).with("address", address))
}
