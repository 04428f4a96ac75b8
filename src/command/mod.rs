//! One file per verb: its arguments and its `run`. Nothing here prints, nothing here knows bytes.

mod again;
mod asking;
pub mod behind;
pub mod dataset;
pub mod decode;
pub mod diag;
pub mod diag_line;
pub mod identify;
pub mod line;
mod lines;
pub mod monitor;
pub mod on_bus;
mod output;
pub mod over_lines;
pub mod params;
pub mod plant;
pub mod plot;
pub mod procedure;
pub mod profibus;
pub mod protocol;
pub mod read;
mod rehearse;
pub mod report;
mod running;
pub mod scan;
mod selecting;
pub mod simulate;
pub mod sniff;
pub mod sollwert;
mod stated;
pub mod statemachine;
mod stopping;
mod synonyms;
pub mod systembus;
mod verb;
pub mod write;

pub use again::{Again, word};
pub use lines::OverLines;
pub use monitor::{keeper, recording};
pub use output::file_failure;
pub use stopping::stop_meant;
pub use synonyms::meant;
pub use verb::{EXAMPLES, Entry, Flow, Typed, Verb, Working, exemplified};

/// Every verb, in the order of the help.
pub const VERBS: &[Entry] = &[
    verb::entry::<scan::Args>(),
    verb::entry::<identify::Args>(),
    verb::entry::<read::Args>(),
    verb::entry::<write::Args>(),
    verb::entry::<dataset::Args>(),
    verb::entry::<plant::init::Args>(),
    verb::entry::<plant::plan::Args>(),
    verb::entry::<plant::apply::Args>(),
    verb::entry::<plant::check::Args>(),
    verb::entry::<diag::Args>(),
    verb::entry::<statemachine::Args>(),
    verb::entry::<sollwert::Args>(),
    verb::entry::<monitor::Args>(),
    verb::entry::<plot::Args>(),
    verb::entry::<report::Args>(),
    verb::entry::<procedure::Args>(),
    verb::entry::<protocol::Args>(),
    verb::entry::<line::Args>(),
    verb::entry::<params::Args>(),
    verb::entry::<systembus::Args>(),
    verb::entry::<decode::Args>(),
    verb::entry::<profibus::Args>(),
    verb::entry::<sniff::Args>(),
    verb::entry::<simulate::Args>(),
];

use crate::args::{Addresses, Settings};
use crate::drive::decode::Reader as Speech;
use crate::drive::{
    Calls, Cell, InForce, Inquiry, Interrupt, Opening, Port, Reader, Recording, Session, is_over, open_port, summary,
    who,
};
use crate::failure::{Class, Failure};
use crate::gate::Ask;
use crate::outcome::{Data, Event, Form, Outcome, Plan, Report, Warning};
use crate::profile::{DataSets, Family, Param, Registry, Selector, Type};
use crate::text::{Lang, Text, both};
use stated::{named_family, target, target_to_change, terms};
use std::rc::Rc;

/// What every verb works with.
pub struct Context<'a> {
    /// Resolved settings.
    pub settings: &'a Settings,
    /// Catalogues.
    pub registry: &'a Registry,
    /// Who is asked for permission.
    pub ask: &'a mut dyn Ask,
    /// Who is told what happens on the way.
    pub observe: &'a mut dyn FnMut(Event),
    /// Raised by Ctrl-C and other signals.
    pub interrupt: Interrupt,
    /// Puts a report on paper.
    pub sheet: Sheet,
    /// Who calls for rounds, for a verb whose [`Flow`] wants that.
    pub calls: Option<Calls>,
}

/// A report as the text of a file.
pub type Sheet = fn(&Report, Form, Lang) -> String;

impl std::fmt::Debug for Context<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Context").field("settings", &self.settings).finish_non_exhaustive()
    }
}

/// Opens the line that the settings name.
async fn connect<'a>(
    settings: &Settings,
    registry: &Registry,
    interrupt: &Interrupt,
    observe: &'a mut dyn FnMut(Event),
) -> Result<Session<'a>, Failure> {
    settings.check_one_line()?;
    let port = open_port(settings.port.as_ref(), observe)?;
    open(&port, settings, registry, interrupt, observe).await
}

/// The same, to listen only where it is a CAN bus.
async fn listen<'a>(
    settings: &Settings,
    registry: &Registry,
    interrupt: &Interrupt,
    observe: &'a mut dyn FnMut(Event),
) -> Result<Session<'a>, Failure> {
    settings.check_one_line()?;
    let port = open_port(settings.port.as_ref(), observe)?;
    Session::open(Opening { listens: true, ..opening(&port, settings) }, registry, interrupt.clone(), observe).await
}

/// How the settings say that a line is opened.
fn opening<'s>(port: &'s Port, settings: &'s Settings) -> Opening<'s> {
    Opening {
        port,
        line: settings.line,
        rs485: settings.rs485,
        protocol: settings.protocol,
        profibus: settings.profibus,
        timeout: settings.timeout,
        retries: settings.retries,
        trace: settings.trace.as_deref().map(|path| Recording { path, overwrite: settings.force }),
        verbose: settings.verbose,
        listens: false,
    }
}

/// Opens one of the lines that the settings name.
async fn open<'a>(
    port: &Port,
    settings: &Settings,
    registry: &Registry,
    interrupt: &Interrupt,
    observe: &'a mut dyn FnMut(Event),
) -> Result<Session<'a>, Failure> {
    if let Some(name) = settings.drive.as_deref() {
        reachable(&*named_family(settings, registry, name)?, settings)?;
    }
    let opening = opening(port, settings);
    if settings.verbose {
        observe(Event::Note(settings.told()));
    }
    if let Some(note) = &settings.port_note {
        observe(Event::Note(note.clone()));
    }
    let mut session = Session::open(opening, registry, interrupt.clone(), observe).await?;
    session.reach_node(settings.node);
    Ok(session)
}

/// Addresses to read from: those that were named, or the factory address, which is said.
fn addresses_to_read(settings: &Settings, observe: &mut dyn FnMut(Event)) -> Result<Vec<u8>, Failure> {
    match &settings.addresses {
        Addresses::Named(list) if list.contains(&0) => Err(Failure::new(
            Class::Usage,
            "usage.broadcast_read",
            both!(
                "address 0 is everybody: it can be written to, but nobody answers",
                "Adresse 0 meint alle: schreiben geht, aber niemand antwortet"
            ),
        )
        .hint(name_one())),
        Addresses::Named(list) => Ok(list.clone()),
        Addresses::Unnamed if settings.is_can() => Err(on_bus::no_node()),
        Addresses::Unnamed => {
            let taking = both!(
                "no address given, taking 1 (the factory setting)",
                "keine Adresse angegeben, es wird 1 genommen (Werkseinstellung)"
            );
            observe(Event::Note(taking));
            Ok(vec![1])
        }
    }
}

/// Addresses to write to: only those that were named.
fn addresses_to_write(settings: &Settings) -> Result<Vec<u8>, Failure> {
    match &settings.addresses {
        Addresses::Named(list) => Ok(list.clone()),
        Addresses::Unnamed => Err(Failure::new(
            Class::Usage,
            "usage.address",
            both!(
                "expected the address of the drive to write to, got none",
                "erwartet: die Adresse des Antriebs, in den geschrieben wird; es ist keine angegeben"
            ),
        )
        .hint(both!(
            "add -a ADDRESS; `antrieb scan` finds the drives",
            "-a ADRESSE ergänzen; `antrieb scan` findet die Antriebe"
        ))),
    }
}

fn name_one() -> Text {
    both!("name one drive, such as -a 1", "einen Antrieb nennen, etwa -a 1")
}

/// Refuses a family that is reached over PROFIBUS alone.
fn reachable(family: &Family, settings: &Settings) -> Result<(), Failure> {
    if family.link.is_asked_on_a_line() || settings.is_through_slave() {
        return Ok(());
    }
    let drive = &family.drive;
    let message = both!(
        "{drive} is the inverter behind an SJ2-PB: it is reached over PROFIBUS alone",
        "{drive} ist der Umrichter hinter einem SJ2-PB: er ist nur über PROFIBUS erreichbar"
    );
    Err(Failure::new(Class::Usage, "usage.profibus", message).hint(both!(
        "nothing was sent; `read` and `write` speak it with --protocol dp; its parameters: `antrieb --drive {drive} params`",
        "es wurde nichts gesendet; `read` und `write` sprechen es mit --protocol dp; seine Parameter: `antrieb --drive {drive} params`"
    )))
}

/// Refuses what moves a shaft where no catalogue tells how.
fn movable(family: &Family) -> Result<(), Failure> {
    if family.is_movable() {
        return Ok(());
    }
    let message = both!(
        "no catalogue tells how a drive of the family {drive} is moved: its parameters can be read and written, and that is all",
        "kein Katalog sagt, wie ein Antrieb der Familie {drive} bewegt wird: nur seine Parameter lassen sich lesen und schreiben",
        drive = family.drive
    );
    Err(Failure::new(Class::Data, "data.not_movable", message).hint(both!(
        "nothing was sent; what stops a shaft: its enable input, the emergency stop, or the mains",
        "es wurde nichts gesendet; was eine Welle anhält: ihr Freigabeeingang, der Not-Halt oder das Netz"
    )))
}

/// The family for work without a line: the one that was named, or the presumed one.
fn offline_family(settings: &Settings, registry: &Registry) -> Result<Rc<Family>, Failure> {
    match (settings.drive.as_deref(), registry.presumed()) {
        (None, Some(family)) => Ok(family),
        (name, _) => named_family(settings, registry, name.unwrap_or_default()),
    }
}

/// Work without a line, in the words of the family that was named; otherwise of the usual one, or of the first of the
/// drives that it could be which knows what is meant. If none knows, the usual one says what is wrong.
fn offline<T>(
    settings: &Settings,
    registry: &Registry,
    work: impl Fn(&Family) -> Result<T, Failure>,
) -> Result<(Rc<Family>, T), Failure> {
    let usual = offline_family(settings, registry)?;
    let unknown = match work(&usual) {
        Err(failure) if settings.drive.is_none() && is_unknown(&failure) => failure,
        done => return Ok((usual, done?)),
    };
    for family in registry.families() {
        match work(&family) {
            Err(failure) if is_unknown(&failure) => {}
            done => return Ok((family, done?)),
        }
    }
    Err(unknown)
}

/// Blames the right one where several parameters are named and no family is: the name that no drive has, not the first
/// that the usual drive lacks.
fn known_somewhere(settings: &Settings, registry: &Registry, selectors: &[Selector]) -> Result<(), Failure> {
    if settings.drive.is_some() || selectors.len() < 2 {
        return Ok(());
    }
    if registry.families().any(|family| selectors.iter().all(|selector| selector.resolve(&family).is_ok())) {
        return Ok(());
    }
    let usual = offline_family(settings, registry)?;
    let families: Vec<_> = registry.families().collect();
    let knowing = |selector: &Selector| {
        let known = families.iter().filter(|family| selector.resolve(family).is_ok());
        known.map(|family| family.drive.as_str()).collect::<Vec<_>>()
    };
    let known: Vec<_> = selectors.iter().map(knowing).collect();
    for (selector, known) in selectors.iter().zip(&known) {
        if let (true, Err(error)) = (known.is_empty(), selector.resolve(&usual)) {
            return Err(read::select_failure(&error));
        }
    }
    let whose = selectors.iter().zip(&known).map(|(selector, known)| format!("{selector} ({})", known.join(", ")));
    let whose = whose.collect::<Vec<_>>().join(", ");
    Err(Failure::new(
        Class::Data,
        "data.unknown_parameter",
        both!("no drive has all of these: {whose}", "kein Antrieb hat alle diese: {whose}"),
    )
    .hint(both!(
        "ask for what belongs to one family at a time",
        "nach dem fragen, was zu einer Familie gehört, eine nach der anderen"
    )))
}

/// Whether a failure is about something that the family does not know, but another may.
fn is_unknown(failure: &Failure) -> bool {
    ["data.unknown_parameter", "data.unknown_group", "usage.mode", "usage.unit", "usage.option"]
        .contains(&failure.code.as_str())
}

/// What a verb that reads would ask every drive that was named, without opening anything.
fn plan(context: &mut Context<'_>, family: &Family, questions: &[Inquiry]) -> Result<Outcome, Failure> {
    reachable(family, context.settings)?;
    let addresses = addresses_to_read(context.settings, context.observe)?;
    let reader = telegram_reader(context.settings, family);
    let each = |address: u8| questions.iter().filter_map(move |question| reader.question(address, *question));
    let telegrams = addresses.into_iter().flat_map(each).collect();
    Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes: Vec::new() })))
}

/// The questions that read the parameters with these roles.
fn role_questions(family: &Family, roles: &[impl AsRef<str>]) -> Vec<Inquiry> {
    roles.iter().filter_map(|role| family.role(role)).map(|param| read_question(param, 0)).collect()
}

fn read_question(param: &Param, set: u8) -> Inquiry {
    Inquiry::Read(Cell { number: param.id, set }, param.kind.unwrap_or(Type::Word))
}

fn telegram_reader<'f>(settings: &Settings, family: &'f Family) -> Speech<'f> {
    Speech { family: Some(family), ..speech(settings) }
}

/// What is spoken, without names of parameters.
fn speech(settings: &Settings) -> Speech<'static> {
    Speech { protocol: settings.protocol, node: settings.node, family: None, order: settings.word_order }
}

/// Refuses numbers that no telegram of the family can carry.
fn check_number(family: &Family, param: &Param) -> Result<(), Failure> {
    if family.link.carries(param.number()) {
        return Ok(());
    }
    let message = both!(
        "there is no parameter {number}: expected a number from 0 to {last}",
        "es gibt keinen Parameter {number}: erwartet wird eine Nummer von 0 bis {last}",
        number = param.id,
        last = family.link.last
    );
    Err(Failure::new(Class::Data, "data.unknown_parameter", message).hint(family.link.numbers.clone()))
}

/// Refuses data sets where the family has none.
fn check_sets(family: &Family, sets: DataSets) -> Result<(), Failure> {
    if sets == DataSets::Unnamed || family.link.route.has_data_sets() {
        return Ok(());
    }
    let text = both!("this drive has no data sets", "dieser Antrieb hat keine Datensätze");
    let hint = both!("name the parameter without @", "den Parameter ohne @ angeben");
    Err(Failure::new(Class::Data, "data.no_data_sets", text).hint(hint))
}

/// The outcome of a verb that goes over several drives.
fn finish(data: Data, failures: Vec<Failure>, succeeded: usize, warnings: Vec<Warning>) -> Outcome {
    Outcome { data: Some(data), warnings, failure: summary(failures, succeeded) }
}

/// A row of a verb that goes over several drives, what failed on the way to it, and how many values were read.
type Row<R> = (R, Vec<Failure>, usize);

/// Rows of a verb that goes over several drives, the first failure of each drive that had one, and how many drives were
/// done without.
type Rows<R> = (Vec<R>, Vec<Failure>, usize);

/// Runs a verb's work on every drive, with time for so many questions to each, and collects what fails. Ends early only if
/// the session is over.
async fn each_drive<R>(
    context: &mut Context<'_>,
    questions: u64,
    mut work: impl AsyncFnMut(&mut Session<'_>, &Settings, &Registry, u8) -> Result<Row<R>, Failure>,
    failed: impl Fn(u8, &Failure) -> R,
) -> Result<Rows<R>, Failure> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    let addresses = addresses_to_read(settings, *observe)?;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let (mut rows, mut failures, mut succeeded) = (Vec::new(), Vec::new(), 0);
    for address in addresses {
        session.allow(session.now(), questions);
        match work(&mut session, settings, registry, address).await {
            Ok((row, row_failures, good)) => {
                rows.push(row);
                let over = row_failures.iter().any(is_over);
                // What ends the session must be heard, whatever failed before it.
                let mut heard = row_failures.iter().filter(|failure| !over || is_over(failure));
                match heard.next().cloned() {
                    None => succeeded += 1,
                    Some(failure) if good > 0 && !over => {
                        failures.push(Failure { class: Class::Partial, code: "partial".to_owned(), ..failure });
                    }
                    Some(failure) => failures.push(failure),
                }
                if over {
                    break;
                }
            }
            Err(failure) => {
                let over = is_over(&failure);
                rows.push(failed(address, &failure));
                failures.push(failure);
                if over {
                    break;
                }
            }
        }
    }
    Ok((rows, failures, succeeded))
}
