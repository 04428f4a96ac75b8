//! `scan`: who is on the line?

mod report;
mod resume;

use super::Context;
use super::lines::{OverLines, of_port, one_recording};
use super::profibus;
use super::verb::{Flow, Verb, Working};
use crate::args::{Addresses, Settings, Takes, parse_span};
use crate::drive::{First, Manner, Port, ScanPlan, ScanResult, Unknown, Upper, open_port, scan};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, OrPlan, OrRecord, Outcome, Plan, Scan};
use crate::text::{Text, both};
use crate::tick::Span;
use clap::Args as ClapArgs;
use futures_util::future::join_all;
use report::report;
use resume::{asked_before, earlier, goes_on};
use std::cell::RefCell;
use std::path::PathBuf;

/// Finds every drive on a line, whatever its setting.
///
/// Asks address after address (1-247, or those given with -a) for its status word and recognises the family from what
/// comes back. Nothing in a drive is changed. Other devices are listed as unknown, with what they answered.
///
/// Nobody is waited for before the next is asked, but replies are credited to the address that they name, whenever they
/// come, and whoever may have been garbled is asked again. A drive that takes long to answer can still be lost behind the
/// question to another; --thorough leaves nobody out.
///
/// What is not known of the line is found with `--baud auto`, `--parity auto`, `--protocol auto`, in rounds through all settings,
/// the likeliest first: address 1 at each of them, then addresses 1-10, then 1-32, then everybody. Where a drive is found its
/// setting is searched to the end at once, and the other settings follow; so it is before the next round where an address answered
/// with garbage, each time that it was asked.
/// Before it begins and after every setting the search says how long it still lasts. Several ports are searched at once:
/// -p A -p B.
///
/// A line is left alone when another master turns out to ask on it: nothing more is sent, and the exit code is 8. Where settings
/// are sought it is listened to for 1.25 s before anything is sent, and if somebody speaks, at every speed and parity: whoever
/// speaks more than 1.5 times a second, understood or not, is left alone as well; a few bytes now and then are noise. A master who begins later
/// is heard between our questions alone: at another setting than his it can take some seconds until he is known as one. --force
/// searches beside him: what both send at once is lost for both.
///
/// On a CAN bus (`--protocol sdo`) nodes 1 to 63 are asked, and node 0 as 64. Where a master is heard on it nobody is asked: it is listened to for
/// 5 s, or as long as --within says, and what shows itself is told with how sure that is; --force asks.
///
/// Over PROFIBUS (`--protocol dp`) the stations 0 to 125 are asked who they are (FDL status, Slave_Diag, Get_Cfg), as by `profibus live`; with
/// --baud auto at 19200, 9600, 93750, 187500, 500000 and 1500000, until somebody answers.
///
/// Ctrl-C ends the search, as --within does, and shows what was found so far and what was left open; `--resume` goes on from a
/// result that was saved with --json.
#[derive(Clone, Debug, Default, ClapArgs)]
pub struct Args {
    /// By the book: every address gets its full time
    ///
    /// Nobody else is asked before it is over.
    #[arg(long, conflicts_with = "fast")]
    pub thorough: bool,
    /// One time around, nothing is asked again
    ///
    /// The first setting with a drive ends the search for settings.
    #[arg(long)]
    pub fast: bool,
    /// The first drive ends the search
    #[arg(long)]
    pub until_first: bool,
    /// End after this time, whatever is left: `90s`, `2m`
    ///
    /// Nothing puts it off but what is on the wire, for a second at most. It begins with listening for 1.25 s, or half of it where
    /// somebody speaks. Addresses 1-10 at every setting go before everything else, the likeliest setting first, as far as they fit
    /// in; what was left open is told, and so is who answered and could not be asked any more what he is.
    #[arg(long, value_name = "TIME", value_parser = parse_span)]
    pub within: Option<Span>,
    /// Go on where this result of `scan --json` ends
    #[arg(long, value_name = "RESULT.json")]
    pub resume: Option<PathBuf>,
}

impl Verb for Args {
    const NAME: &'static str = "scan";
    const TAKES: Takes = Takes::SEARCHES;
    const SDO: bool = true;
    const PROFIBUS: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim scan",
        "antrieb --port sim -a 1-10 scan --until-first",
        "antrieb --port sim --baud auto --parity auto -a 1,2 scan",
        "antrieb --port sim --baud auto --parity auto --protocol auto scan --within 2m",
        "antrieb --port sim --protocol dp --baud auto scan",
    ];
    const UPPER: Upper = Upper::drive(30).each(4, "address at a setting that is known").unless(
        "A search for settings says before it begins how long it lasts and how long at most, and keeps to that: at most twice \
         the time of a silent line, and the questions to each drive that answers. With everything unknown, 49 settings and 247 \
         addresses, that is 8 min and at most 16 min. --within or Ctrl-C ends it before, and shows what was found.",
    );
    type Prints = OrRecord<Document<OrPlan<Scan>>>;

    fn streams(&self) -> Option<Flow> {
        Some(Flow::Search)
    }

    fn over_lines(&self) -> OverLines {
        OverLines::Itself
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Searches the lines.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.profibus {
        let Args { thorough, fast, until_first, within, ref resume } = *args;
        profibus::refuse(&[("--thorough", thorough), ("--fast", fast), ("--resume", resume.is_some())])?;
        return profibus::scan(profibus::Ends { until_first, within }, context).await;
    }
    let settings = context.settings;
    let addresses = addresses(settings)?;
    if settings.dry_run {
        return dry_run(context, &addresses);
    }
    let ports = ports(context)?;
    let before = args.resume.as_deref().map(|path| earlier(path, &ports)).transpose()?;
    before.as_ref().map_or(Ok(()), |before| goes_on(before, settings))?;
    let plan = ScanPlan {
        unknown: unknown(settings),
        manner: match (args.fast, args.thorough) {
            (true, _) => Manner::Fast,
            (_, true) => Manner::Thorough,
            _ => Manner::Usual,
        },
        until_first: args.until_first.then(First::default),
        force: settings.force,
        within: args.within,
        ..ScanPlan::new(addresses)
    };
    let lines = search_all(context, &ports, &plan, before.as_ref()).await;
    Ok(report(args, settings, &ports, lines, before))
}

fn addresses(settings: &Settings) -> Result<Vec<u8>, Failure> {
    match &settings.addresses {
        Addresses::Named(list) if list.contains(&0) => {
            let message = both!(
                "address 0 is everybody and nobody answers it; expected addresses from 1 to 247",
                "Adresse 0 sind alle, und niemand antwortet; erwartet werden Adressen von 1 bis 247"
            );
            Err(Failure::new(Class::Usage, "usage.broadcast_read", message))
        }
        Addresses::Named(list) => Ok(list.clone()),
        Addresses::Unnamed if settings.is_can() => Ok((1..=super::on_bus::LAST_STATION).collect()),
        Addresses::Unnamed => Ok((1..=crate::drive::LAST_STATION).collect()),
    }
}

fn unknown(settings: &Settings) -> Unknown {
    let crate::args::Unknown { baud, parity, protocol } = settings.unknown;
    Unknown { baud, parity, protocol }
}

/// A summary: the question to the first and to the last address, and how many settings of how many ports are asked so.
fn dry_run(context: &Context<'_>, addresses: &[u8]) -> Result<Outcome, Failure> {
    let settings = context.settings;
    let family = super::offline_family(settings, context.registry)?;
    let reader = super::telegram_reader(settings, &family);
    let probe = crate::drive::probe_question();
    let mut ends: Vec<u8> = addresses.first().into_iter().chain(addresses.last()).copied().collect();
    ends.dedup();
    let telegrams = ends.iter().filter_map(|&address| reader.question(address, probe)).collect();
    let (count, ports) = (addresses.len(), settings.ports.len().max(1));
    let crate::args::Unknown { baud, parity, protocol } = settings.unknown;
    let sought = [("baud", baud), ("parity", parity), ("protocol", protocol)];
    let sought: Vec<_> = sought.iter().filter(|row| row.1).map(|row| row.0).collect();
    let (line, spoken) = (settings.line, settings.protocol);
    let mut notes = vec![both!(
        "{count} address(es) on {ports} port(s) are asked for their status word, at {line} {spoken} first",
        "{count} Adresse(n) an {ports} Anschluss/Anschlüssen werden nach dem Statuswort gefragt, zuerst mit {line} \
         {spoken}"
    )];
    if !sought.is_empty() {
        let sought = sought.join(", ");
        notes.push(both!(
            "then again at every other likely setting: {sought} = auto",
            "danach mit jeder weiteren wahrscheinlichen Einstellung: {sought} = auto"
        ));
    }
    notes.push(both!(
        "whoever answers is asked on what it is (code 100, P.484, P.11, code 43); whoever was garbled is asked again",
        "wer antwortet, wird gefragt, was er ist (Code 100, P.484, P.11, Code 43); wer gestört kam, wird noch einmal \
         gefragt"
    ));
    Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes })))
}

/// The ports that were named, or the only one that there is.
fn ports(context: &mut Context<'_>) -> Result<Vec<Port>, Failure> {
    let settings = context.settings;
    let ports: Vec<Port> = match settings.lines.is_empty() {
        true => settings.ports.clone(),
        false => settings.lines.iter().filter_map(|line| line.port.clone()).collect(),
    };
    let usage = |code: &str, message: Text| Err(Failure::new(Class::Usage, code, message));
    let mut named = ports.iter();
    while let Some(port) = named.next() {
        if named.as_slice().contains(port) {
            return usage(
                "usage.port",
                both!(
                    "port: {port} is named twice; expected every port once",
                    "Anschluss: {port} ist zweimal genannt; erwartet: jeder Anschluss einmal"
                ),
            );
        }
    }
    one_recording(settings, ports.len())?;
    if ports.is_empty() {
        return Ok(vec![open_port(None, context.observe)?]);
    }
    Ok(ports)
}

/// Searches every port, all at once.
async fn search_all(
    context: &mut Context<'_>,
    ports: &[Port],
    plan: &ScanPlan,
    before: Option<&Scan>,
) -> Vec<Result<ScanResult, Failure>> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    let (settings, registry, interrupt) = (*settings, *registry, &*interrupt);
    let several = ports.len() > 1;
    let observe = RefCell::new(observe);
    let searches = ports.iter().map(|port| {
        let name = port.to_string();
        let tell = |event| (observe.borrow_mut())(event);
        // What the project file says of its drives.
        let line = settings.lines.iter().find(|line| line.port.as_ref() == Some(port));
        let (settings, addresses) = line.map_or((settings, &plan.addresses[..]), |line| (line, line.addresses.named()));
        async move {
            let mut tell = |event| tell(if several { of_port(&name, event) } else { event });
            let mut session = super::open(port, settings, registry, interrupt, &mut tell).await?;
            let before = before.map(|scan| asked_before(scan, &name)).transpose()?;
            let plan = ScanPlan { before: before.unwrap_or_default(), addresses: addresses.to_vec(), ..plan.clone() };
            Ok(scan(&mut session, &plan, registry).await)
        }
    });
    join_all(searches).await
}
