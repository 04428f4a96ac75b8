//! `scan`: who is on the line?

mod resume;

use super::Context;
use super::verb::{Verb, Working};
use crate::args::{Addresses, Settings, Takes};
use crate::drive::{First, Manner, Port, ScanPlan, ScanResult, Searched, Unknown, Upper, open_port, scan};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, Event, FoundDrive, OrPlan, Outcome, Plan, Scan, Search, Warning};
use crate::text::{Text, both};
use clap::Args as ClapArgs;
use resume::{asked_before, earlier, ranges};
use std::cell::RefCell;
use std::path::PathBuf;
use std::pin::pin;
use std::task::Poll;

/// Finds every drive on a line, whatever its setting.
///
/// Asks address after address (1-247, or those given with -a) for its status word and recognises the family from what
/// comes back. Nothing in a drive is changed. Other devices are listed as unknown, with what they answered.
///
/// Nobody is waited for before the next is asked, but replies are credited to the address that they name, whenever they
/// come, and whoever may have been garbled is asked again. A drive that takes long to answer can still be lost behind the
/// question to another; --thorough leaves nobody out.
///
/// What is not known of the line is found with `--baud auto`, `--parity auto`, `--protocol auto`: likely settings and low
/// addresses first. Where a drive is found, its setting is searched to the end at once. Several ports are searched at
/// once: -p A -p B.
///
/// A line is left alone when another master turns out to ask on it: nothing more is sent, and the exit code is 8. --force
/// goes on.
///
/// Ctrl-C ends the search and shows what was found so far; `--resume` goes on from a result that was saved with --json.
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
    /// Go on where this result of `scan --json` ends
    #[arg(long, value_name = "RESULT.json")]
    pub resume: Option<PathBuf>,
}

impl Verb for Args {
    const NAME: &'static str = "scan";
    const TAKES: Takes = Takes::SEARCHES;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim scan",
        "antrieb --port sim -a 1-10 scan --until-first",
        "antrieb --port sim --baud auto --parity auto -a 1,2 scan",
    ];
    const UPPER: Upper =
        Upper::drive(30).each(4, "address and setting").unless("Ctrl-C ends it before, and shows what was found.");
    type Prints = Document<OrPlan<Scan>>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Searches the lines.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let settings = context.settings;
    let addresses = addresses(settings)?;
    if settings.dry_run {
        return dry_run(context, &addresses);
    }
    let ports = ports(context)?;
    let before = args.resume.as_deref().map(|path| earlier(path, &ports)).transpose()?;
    let plan = ScanPlan {
        unknown: unknown(settings),
        manner: match (args.fast, args.thorough) {
            (true, _) => Manner::Fast,
            (_, true) => Manner::Thorough,
            _ => Manner::Usual,
        },
        until_first: args.until_first.then(First::default),
        force: settings.force,
        ..ScanPlan::new(addresses)
    };
    let lines = search_all(context, &ports, &plan, before.as_ref()).await;
    Ok(report(settings, &ports, lines, before))
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
    let usage = |code: &str, message: Text| Err(Failure::new(Class::Usage, code, message));
    let mut named = settings.ports.iter();
    while let Some(port) = named.next() {
        if named.as_slice().contains(port) {
            return usage(
                "usage.port",
                both!(
                    "port: {port} is named twice; expected every port once",
                    "port: {port} ist zweimal genannt; erwartet: jeder Anschluss einmal"
                ),
            );
        }
    }
    if settings.ports.len() > 1 && settings.trace.is_some() {
        return usage(
            "usage.trace",
            both!(
                "trace: one file holds one line; expected one port",
                "trace: eine Datei fasst eine Leitung; erwartet: ein Anschluss"
            ),
        );
    }
    if settings.ports.is_empty() {
        return Ok(vec![open_port(None, context.observe)?]);
    }
    Ok(settings.ports.clone())
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
        async move {
            let mut tell = |event| tell(if several { of_port(&name, event) } else { event });
            let mut session = super::open(port, settings, registry, interrupt, &mut tell).await?;
            let before = before.map(|scan| asked_before(scan, &name)).transpose()?;
            let plan = ScanPlan { before: before.unwrap_or_default(), ..plan.clone() };
            Ok(scan(&mut session, &plan, registry).await)
        }
    });
    side_by_side(searches.collect()).await
}

/// What happens on one of several ports, with its name.
fn of_port(port: &str, event: Event) -> Event {
    match event {
        Event::Progress { done, total, what } => Event::Search { port: port.to_owned(), done, total, what },
        Event::Telegram { at_us, direction, hex, meaning } => {
            let meaning = both!("{port}: {meaning}", "{port}: {meaning}", meaning);
            Event::Telegram { at_us, direction, hex, meaning }
        }
        event => event,
    }
}

/// Runs futures at once on this thread; their results in the same order.
async fn side_by_side<F: Future>(futures: Vec<F>) -> Vec<F::Output> {
    let mut running: Vec<_> = futures.into_iter().map(|future| (Box::pin(future), None)).collect();
    let all = std::future::poll_fn(|context| {
        let mut is_over = true;
        for (future, output) in running.iter_mut().filter(|(_, output)| output.is_none()) {
            match future.as_mut().poll(context) {
                Poll::Ready(value) => *output = Some(value),
                Poll::Pending => is_over = false,
            }
        }
        if is_over { Poll::Ready(()) } else { Poll::Pending }
    });
    pin!(all).await;
    running.into_iter().filter_map(|(_, output)| output).collect()
}

/// One result of all that the ports brought.
fn report(
    settings: &Settings,
    ports: &[Port],
    lines: Vec<Result<ScanResult, Failure>>,
    before: Option<Scan>,
) -> Outcome {
    let (mut drives, mut searches) = before.map_or_else(Default::default, |scan| (scan.drives, scan.searches));
    let (mut addresses, mut asked, mut complete) = (0, 0, true);
    let (mut warnings, mut failures): (Vec<Warning>, Vec<Failure>) = (Vec::new(), Vec::new());
    for (port, line) in ports.iter().zip(lines) {
        let result = match line {
            Ok(result) => result,
            Err(failure) => {
                complete = false;
                failures.push(failure);
                continue;
            }
        };
        let left_out = result.left_out();
        drives.extend(result.drives);
        warnings.extend(result.warnings);
        failures.extend(result.yielded.then(other_master).or(left_out));
        failures.extend(result.cut.map(|error| {
            let mut failure = error.failure(0, None);
            failure.context.clear();
            failure
        }));
        for searched in &result.searched {
            addresses += searched.total;
            asked += searched.asked.len();
            complete &= searched.is_complete();
            let search = search(port, searched);
            searches.retain(|old: &Search| {
                (&old.port, &old.line, &old.protocol) != (&search.port, &search.line, &search.protocol)
            });
            if !search.asked.is_empty() || !search.garbled.is_empty() {
                searches.push(search);
            }
        }
    }
    let failure = verdict(settings, failures, ports.len(), &drives, (asked, addresses));
    let names: Vec<String> = ports.iter().map(ToString::to_string).collect();
    // In the order of the addresses, not of the finds, so that two scans of one line give the same document.
    drives.sort_by_key(|drive| (names.iter().position(|name| *name == drive.port), drive.address));
    let unknown = settings.unknown;
    let auto = |is_unknown: bool, known: String| if is_unknown { "auto".to_owned() } else { known };
    let data = Scan {
        port: names.join(", "),
        line: auto(unknown.baud || unknown.parity, settings.line.to_string()),
        protocol: auto(unknown.protocol, settings.protocol.name().to_owned()),
        addresses,
        asked,
        complete,
        drives,
        searches,
    };
    Outcome { data: Some(Data::Scan(data)), warnings, failure }
}

/// What was asked at one setting.
fn search(port: &Port, searched: &Searched) -> Search {
    Search {
        port: port.to_string(),
        line: searched.tuning.line.to_string(),
        protocol: searched.tuning.protocol.name().to_owned(),
        asked: ranges(&searched.asked),
        complete: searched.is_complete(),
        garbled: searched.garbled.iter().copied().collect(),
    }
}

/// Why it is not all that was asked for: interrupted, a port that failed, or nobody there.
fn verdict(
    settings: &Settings,
    failures: Vec<Failure>,
    ports: usize,
    drives: &[FoundDrive],
    (asked, addresses): (usize, usize),
) -> Option<Failure> {
    let count = failures.len();
    let interrupted = failures.iter().position(|failure| failure.class == Class::Interrupted);
    let Some(first) = failures.into_iter().nth(interrupted.unwrap_or(0)) else {
        return drives.is_empty().then(|| nobody(settings));
    };
    let so_far = both!(
        "{why}; {asked} of {addresses} addresses were asked",
        "{why}; {asked} von {addresses} Adressen wurden gefragt",
        why = first.message
    );
    if interrupted.is_some() {
        let hint = both!(
            "a result that was saved with --json can be gone on with: scan --resume RESULT.json",
            "ein mit --json gesichertes Ergebnis lässt sich fortsetzen: scan --resume ERGEBNIS.json"
        );
        return Some(Failure { message: so_far, ..first }.hint(hint));
    }
    if ports == 1 || count == ports {
        return Some(if addresses > 0 { Failure { message: so_far, ..first } } else { first });
    }
    let message = both!(
        "{count} of {ports} ports failed; the first: {why}",
        "{count} von {ports} Anschlüssen gescheitert; zuerst: {why}",
        why = first.message
    );
    Some(Failure { class: Class::Partial, code: "partial".to_owned(), message, ..first })
}

fn other_master() -> Failure {
    let message = both!(
        "another master asks on this line, so nothing more was sent",
        "ein anderer Master fragt auf dieser Leitung, deshalb wurde nichts mehr gesendet"
    );
    let hint = both!(
        "disconnect the other master; `antrieb sniff` shows what it asks; --force goes on beside it and may disturb it",
        "den anderen Master abklemmen; `antrieb sniff` zeigt, was er fragt; --force macht neben ihm weiter und kann ihn \
         stören"
    );
    Failure::new(Class::Forbidden, "forbidden.other_master", message).hint(hint)
}

fn nobody(settings: &Settings) -> Failure {
    let hint = if settings.unknown == crate::args::Unknown::default() {
        both!(
            "if the setting of the line is not known: --baud auto --parity auto --protocol auto (a drive leaves the \
             factory speaking VABus, P.395 = 0); else check whether A and B are swapped, and termination",
            "falls die Einstellung der Leitung unbekannt ist: --baud auto --parity auto --protocol auto (ein Antrieb \
             spricht ab Werk VABus, P.395 = 0); sonst prüfen, ob A und B vertauscht sind, und den Abschluss"
        )
    } else {
        both!(
            "no setting brought an answer: check supply, whether A and B are swapped, termination, and the adapter",
            "keine Einstellung brachte eine Antwort: Versorgung, Vertauschung von A und B, Abschluss und Adapter prüfen"
        )
    };
    Failure::new(Class::No, "no.drive_found", both!("no drive answered", "kein Antrieb hat geantwortet")).hint(hint)
}
