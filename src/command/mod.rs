//! One file per verb: its arguments and its `run`. Nothing here prints, nothing here knows bytes.

mod asking;
pub mod dataset;
pub mod decode;
pub mod diag;
pub mod diag_line;
pub mod identify;
pub mod line;
pub mod monitor;
pub mod params;
pub mod protocol;
pub mod read;
mod rehearse;
mod running;
pub mod scan;
pub mod simulate;
pub mod sniff;
pub mod sollwert;
pub mod statemachine;
mod verb;
pub mod write;

pub use verb::{Entry, Flow, Typed, Verb, Working};

/// Every verb, in the order of the help.
pub const VERBS: &[Entry] = &[
    verb::entry::<scan::Args>(),
    verb::entry::<identify::Args>(),
    verb::entry::<read::Args>(),
    verb::entry::<write::Args>(),
    verb::entry::<dataset::Args>(),
    verb::entry::<diag::Args>(),
    verb::entry::<statemachine::Args>(),
    verb::entry::<sollwert::Args>(),
    verb::entry::<monitor::Args>(),
    verb::entry::<protocol::Args>(),
    verb::entry::<line::Args>(),
    verb::entry::<params::Args>(),
    verb::entry::<decode::Args>(),
    verb::entry::<sniff::Args>(),
    verb::entry::<simulate::Args>(),
];

use crate::args::{Addresses, Origin, Settings};
use crate::drive::motion::working;
use crate::drive::{
    AccessError, Cell, Inquiry, Interrupt, Opening, Port, Reading, Recording, Session, Target, describe, open_port,
    recognise,
};
use crate::failure::{Class, Failure};
use crate::gate::Ask;
use crate::outcome::{Data, Event, Outcome, Plan, Value, Warning};
use crate::profile::{DataSets, Family, Lang, Param, Registry, Selector, Store, Type};
use std::collections::BTreeMap;
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
}

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
    let port = open_port(settings.port.as_ref(), settings.lang, observe)?;
    open(&port, settings, registry, interrupt, observe).await
}

/// Opens one of the lines that the settings name.
async fn open<'a>(
    port: &Port,
    settings: &Settings,
    registry: &Registry,
    interrupt: &Interrupt,
    observe: &'a mut dyn FnMut(Event),
) -> Result<Session<'a>, Failure> {
    let opening = Opening {
        port,
        line: settings.line,
        rs485: settings.rs485,
        protocol: settings.protocol,
        timeout: settings.timeout,
        retries: settings.retries,
        trace: settings.trace.as_deref().map(|path| Recording { path, overwrite: settings.force }),
        verbose: settings.verbose,
        lang: settings.lang,
    };
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
            "address 0 is everybody: it can be written to, but nobody answers",
        )
        .hint("name one drive, such as -a 1")),
        Addresses::Named(list) => Ok(list.clone()),
        Addresses::Unnamed => {
            let taking = settings.lang.pick(
                "no address given, taking 1 (the factory setting)",
                "keine Adresse angegeben, es wird 1 genommen (Werkseinstellung)",
            );
            observe(Event::Note(taking.to_owned()));
            Ok(vec![1])
        }
    }
}

/// Addresses to write to: only those that were named.
fn addresses_to_write(settings: &Settings) -> Result<Vec<u8>, Failure> {
    match &settings.addresses {
        Addresses::Named(list) => Ok(list.clone()),
        Addresses::Unnamed => {
            Err(Failure::new(Class::Usage, "usage.address", "expected the address of the drive to write to, got none")
                .hint("add -a ADDRESS; `antrieb scan` finds the drives"))
        }
    }
}

/// The drive at an address: of the family that was named, or asked. `shows_register`: the verb is going to read the error
/// register, so asking must not lose it.
async fn target(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
    shows_register: bool,
) -> Result<Target, Failure> {
    if let Some(name) = &settings.drive {
        return Ok(Target::new(address, named_family(settings, registry, name)?).in_word_order(settings.word_order));
    }
    let presumed = registry.family("acu");
    let finding = recognise(session, registry, address, settings.lang, shows_register)
        .await
        .map_err(|error| error.failure(address, presumed.as_deref(), settings.lang))?;
    let target = finding.target(address, registry);
    target.map(|target| target.in_word_order(settings.word_order)).ok_or_else(|| {
        let told: Vec<_> =
            finding.evidence.iter().map(|row| format!("{}: {} ({})", row.asked, row.answered, row.tells)).collect();
        Failure::new(Class::Data, "data.unknown_drive", format!("address {address} is no drive that we know"))
            .hint(format!("{}; name the family with --drive if you know better", told.join("; ")))
            .with("address", address)
    })
}

/// The family that `--drive` names.
fn named_family(settings: &Settings, registry: &Registry, name: &str) -> Result<Rc<Family>, Failure> {
    registry.family(name).ok_or_else(|| {
        let known: Vec<_> = registry.drives().into_iter().map(|drive| drive.id).collect();
        let whence = match settings.origin("drive") {
            Origin::File { path, .. } => format!("{}: ", path.display()),
            _ => String::new(),
        };
        let message = format!("{whence}unknown drive '{name}' (expected: auto, {})", known.join(", "));
        Failure::new(Class::Usage, "usage.drive", message)
    })
}

/// The family for work without a line: the one that was named, or the one with the larger catalogue.
fn offline_family(settings: &Settings, registry: &Registry) -> Result<Rc<Family>, Failure> {
    named_family(settings, registry, settings.drive.as_deref().unwrap_or("acu"))
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
    let usual = offline_family(settings, registry)?;
    let families = registry.families();
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
    if families.iter().any(|family| known.iter().all(|known| known.contains(&family.drive.as_str()))) {
        return Ok(());
    }
    let whose = selectors.iter().zip(&known).map(|(selector, known)| format!("{selector} ({})", known.join(", ")));
    let whose = whose.collect::<Vec<_>>().join(", ");
    let text = settings.lang.pick("no drive has all of these", "kein Antrieb hat alle diese");
    Err(Failure::new(Class::Data, "data.unknown_parameter", format!("{text}: {whose}")).hint(settings.lang.pick(
        "ask for what belongs to one family at a time",
        "nach dem fragen, was zu einer Familie gehört, eine nach der anderen",
    )))
}

/// Whether a failure is about something that the family does not know, but another may.
fn is_unknown(failure: &Failure) -> bool {
    ["data.unknown_parameter", "data.unknown_group", "usage.mode", "usage.unit", "usage.option"]
        .contains(&failure.code.as_str())
}

/// What a verb that reads would ask every drive that was named, without opening anything.
fn plan(context: &mut Context<'_>, family: &Family, questions: &[Inquiry]) -> Result<Outcome, Failure> {
    let addresses = addresses_to_read(context.settings, context.observe)?;
    let reader = telegram_reader(context.settings, family);
    let each = |address: u8| questions.iter().filter_map(move |question| reader.question(address, *question));
    let telegrams = addresses.into_iter().flat_map(each).collect();
    Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes: Vec::new() })))
}

/// The questions that read the parameters with these roles.
fn role_questions(family: &Family, roles: &[&str]) -> Vec<Inquiry> {
    roles.iter().filter_map(|role| family.role(role)).map(|param| read_question(param, 0)).collect()
}

/// Whom a question to the user names: `drive 3 (acu)`; with a node of the system bus behind it `drive 3.17 (acu)`.
fn who(address: u8, node: u8, drive: &str, lang: Lang) -> String {
    let behind = if node == 0 { String::new() } else { format!(".{node}") };
    format!("{} {address}{behind} ({drive})", lang.pick("drive", "Antrieb"))
}

fn read_question(param: &Param, set: u8) -> Inquiry {
    Inquiry::Read(Cell { number: param.id, set }, param.kind.unwrap_or(Type::Word))
}

fn telegram_reader<'f>(settings: &Settings, family: &'f Family) -> crate::drive::decode::Reader<'f> {
    crate::drive::decode::Reader {
        protocol: settings.protocol,
        node: settings.node,
        family: Some(family),
        order: settings.word_order.unwrap_or_default(),
        lang: settings.lang,
    }
}

/// Refuses numbers that no telegram of the family can carry.
fn check_number(family: &Family, param: &Param, lang: Lang) -> Result<(), Failure> {
    if family.link.carries(param.id) {
        return Ok(());
    }
    let message = format!("there is no parameter {}: expected a number from 0 to {}", param.id, family.link.last);
    Err(Failure::new(Class::Data, "data.unknown_parameter", message).hint(family.link.numbers.get(lang)))
}

/// Refuses data sets where the family has none.
fn check_sets(family: &Family, sets: DataSets, lang: Lang) -> Result<(), Failure> {
    if sets == DataSets::Unnamed || family.link.route.has_data_sets() {
        return Ok(());
    }
    let text = lang.pick("this drive has no data sets", "dieser Antrieb hat keine Datensätze");
    let hint = lang.pick("name the parameter without @", "den Parameter ohne @ angeben");
    Err(Failure::new(Class::Data, "data.no_data_sets", text).hint(hint))
}

/// Reads parameters of one drive into rows, remembering the parameters that the names of bits depend on.
struct Reader<'t, 's, 'o> {
    session: &'t mut Session<'o>,
    target: &'t mut Target,
    settings: &'s Settings,
    modes: BTreeMap<u32, i64>,
    /// Values that came with their neighbours.
    fetched: BTreeMap<u32, Reading>,
    /// Not every drive has everything: what it does not know is a row with an error, but no failure of the verb.
    lenient: bool,
    /// Values that were read.
    good: usize,
    /// Refusals that are no failures, unless nothing else came.
    forgiven: Vec<Failure>,
    failures: Vec<Failure>,
    warnings: Vec<Warning>,
    asked_widths: Vec<u32>,
}

impl<'t, 's, 'o> Reader<'t, 's, 'o> {
    fn new(session: &'t mut Session<'o>, target: &'t mut Target, settings: &'s Settings) -> Self {
        Reader {
            session,
            target,
            settings,
            modes: BTreeMap::new(),
            fetched: BTreeMap::new(),
            lenient: false,
            good: 0,
            forgiven: Vec::new(),
            failures: Vec::new(),
            warnings: Vec::new(),
            asked_widths: Vec::new(),
        }
    }

    /// What failed. Refusals of single parameters are forgiven, but not if the drive refused everything.
    fn into_failures(mut self) -> (Vec<Failure>, usize) {
        for warning in self.warnings.drain(..) {
            self.session.tell(Event::Note(warning.message));
        }
        if self.good == 0 && self.failures.is_empty() {
            self.failures.extend(self.forgiven.into_iter().next());
        }
        (self.failures, self.good)
    }

    /// The parameter that plays a role, read in its own data set; `None` if the family has none.
    async fn role(&mut self, role: &str) -> Result<Option<Value>, Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(None) };
        self.lenient = true;
        Ok(self.rows(&param, DataSets::Unnamed).await?.into_iter().next())
    }

    /// The parameter that plays a role as the drive works with it, and the stored one where that differs. A drive without
    /// data sets has one value.
    async fn in_force(&mut self, role: &str) -> Result<InForce, Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(InForce::default()) };
        self.lenient = true;
        if !self.target.family.link.route.has_data_sets() || param.is_volatile() {
            let value = self.rows(&param, DataSets::Unnamed).await?.into_iter().next();
            return Ok(InForce { value, stored: None });
        }
        let set = self.target.working_set(self.session, &param).await;
        let set =
            set.map_err(|error| error.failure(self.target.address, Some(&self.target.family), self.settings.lang))?;
        let forgiven = self.forgiven.len();
        let working = self.rows(&param, DataSets::One(set, Store::Ram)).await?.into_iter().next();
        let stored = self.rows(&param, DataSets::One(set, Store::Eeprom)).await?.into_iter().next();
        let Some(working) = working.filter(|value| value.error.is_none()) else {
            // It does not show its RAM: what it stores is all that there is to know.
            self.forgiven.truncate(forgiven);
            return Ok(InForce { value: stored, stored: None });
        };
        let stored = stored.filter(|stored| stored.error.is_none() && stored.raw != working.raw);
        Ok(InForce { value: Some(working), stored })
    }

    /// Like [`Reader::role`], but a refusal is a failure: the verb is about this value.
    async fn vital_role(&mut self, role: &str) -> Result<Option<Value>, Failure> {
        let Some(param) = self.target.family.role(role).cloned() else { return Ok(None) };
        self.lenient = false;
        Ok(self.rows(&param, DataSets::Unnamed).await?.into_iter().next())
    }

    /// Reads in few telegrams what lies next to each other; [`Reader::rows`] takes it from there.
    async fn fetch(&mut self, params: &[Param]) -> Result<(), Failure> {
        match self.target.neighbours(self.session, params).await {
            Ok(readings) => {
                self.fetched.extend(readings);
                Ok(())
            }
            Err(error) => Err(error.failure(self.target.address, Some(&self.target.family), self.settings.lang)),
        }
    }

    /// One row per data set. Refusals are rows with an error; what ends the session is an error.
    async fn rows(&mut self, param: &Param, sets: DataSets) -> Result<Vec<Value>, Failure> {
        self.learn_modes(param).await?;
        if let Some(reading) = self.fetched.remove(&param.id).filter(|_| sets == DataSets::Unnamed) {
            return Ok(vec![self.row(param, 0, Ok(reading))?]);
        }
        let mut rows = Vec::new();
        for (set, result) in self.target.read(self.session, param, sets).await {
            rows.push(Value { node: self.session.node(), ..self.row(param, set, result)? });
        }
        Ok(rows)
    }

    fn row(&mut self, param: &Param, set: u8, result: Result<Reading, AccessError>) -> Result<Value, Failure> {
        let (address, lang) = (self.target.address, self.settings.lang);
        match result {
            Ok(reading) => {
                self.good += 1;
                if param.kind.is_none() && !self.asked_widths.contains(&param.id) {
                    self.asked_widths.push(param.id);
                    let bits = reading.kind.bits().unwrap_or(0);
                    let found = match self.settings.lang {
                        Lang::En => format!("parameter {}: {bits} bits wide, found out by asking", param.id),
                        Lang::De => format!("Parameter {}: {bits} Bit breit, durch Fragen ermittelt", param.id),
                    };
                    self.session.tell(Event::Note(found));
                }
                if reading.corrected {
                    self.warnings.push(Warning {
                        code: "catalogue.width".to_owned(),
                        message: format!(
                            "parameter {}: the catalogue says {} (unconfirmed), drive {address} uses {}",
                            param.id,
                            param.kind.map_or("nothing", |kind| kind.name()),
                            reading.kind.name()
                        ),
                    });
                }
                let lookup = |id: u32| self.modes.get(&id).copied();
                let value = describe::value(address, &self.target.family, param, reading, lang, &lookup);
                self.warnings.extend(implausible(&value, param, lang));
                Ok(value)
            }
            Err(error) => {
                let failure = error.failure(address, Some(&self.target.family), lang).with("param", param.id);
                if error.is_fatal() {
                    return Err(failure);
                }
                let row = describe::unread(address, &self.target.family, param, set, lang, &failure);
                if failure.class == Class::Refused && self.lenient {
                    self.forgiven.push(failure);
                } else {
                    self.failures.push(failure);
                }
                Ok(row)
            }
        }
    }

    /// Reads the parameters that decide what this one's bits are called.
    async fn learn_modes(&mut self, param: &Param) -> Result<(), Failure> {
        for when in &param.bits_when {
            if self.modes.contains_key(&when.param) {
                continue;
            }
            let deciding = self.target.family.param_or_unknown(when.param);
            // What is in force decides, not what is stored.
            if let Some(raw) = working(self.session, self.target, &deciding, self.settings.lang).await? {
                self.modes.insert(when.param, raw);
            }
        }
        Ok(())
    }
}

/// The warning about a value that the catalogue says cannot be.
fn implausible(value: &Value, param: &Param, lang: Lang) -> Option<Warning> {
    let (expected, raw) = (value.expected.as_ref()?, value.raw?);
    let (label, address) = (param.label(), value.address);
    let message = match lang {
        Lang::En => format!(
            "drive {address}: {label} reads as {raw}, expected {expected}: two drives at one address, a disturbed reply, \
             or a drive of another kind (--drive)?"
        ),
        Lang::De => format!(
            "Antrieb {address}: {label} liest sich als {raw}, erwartet {expected}: zwei Antriebe mit einer Adresse, eine \
             gestörte Antwort oder ein Antrieb anderer Art (--drive)?"
        ),
    };
    Some(Warning { code: "value.implausible".to_owned(), message })
}

/// A setting as the drive works with it, and as it is stored where that is another value.
#[derive(Debug, Default)]
struct InForce {
    value: Option<Value>,
    stored: Option<Value>,
}

impl InForce {
    /// One row, or two that differ; the second says that it is only stored.
    fn rows(self, lang: Lang) -> impl Iterator<Item = Value> {
        let only = lang.pick("stored, not in force", "gespeichert, nicht wirksam");
        let stored = self.stored.map(|value| {
            let text = value.text.into_iter().chain([only.to_owned()]).collect::<Vec<_>>().join("; ");
            Value { text: Some(text), ..value }
        });
        self.value.into_iter().chain(stored)
    }
}

/// What to say when some of many questions failed: nothing, the failure itself, or that it is partly done.
fn summary(failures: Vec<Failure>, succeeded: usize, lang: Lang) -> Option<Failure> {
    let count = failures.len();
    if let Some(end) = failures.iter().find(|failure| is_over(failure)) {
        return Some(end.clone());
    }
    let first = failures.into_iter().next()?;
    if succeeded == 0 {
        return Some(first);
    }
    let message = match lang {
        Lang::En => format!("{count} of {} failed; the first: {}", count + succeeded, first.message),
        Lang::De => format!("{count} von {} gescheitert; zuerst: {}", count + succeeded, first.message),
    };
    let failure = Failure { class: Class::Partial, code: "partial".to_owned(), message, ..first };
    Some(failure)
}

/// The outcome of a verb that goes over several drives.
fn finish(data: Data, failures: Vec<Failure>, succeeded: usize, warnings: Vec<Warning>, lang: Lang) -> Outcome {
    Outcome { data: Some(data), warnings, failure: summary(failures, succeeded, lang) }
}

/// A row of a verb that goes over several drives, what failed on the way to it, and how many values were read.
type Row<R> = (R, Vec<Failure>, usize);

/// Rows of a verb that goes over several drives, the first failure of each drive that had one, and how many drives were
/// done without.
type Rows<R> = (Vec<R>, Vec<Failure>, usize);

/// Runs a verb's work on every drive and collects what fails. Ends early only if the session is over.
async fn each_drive<R>(
    context: &mut Context<'_>,
    mut work: impl AsyncFnMut(&mut Session<'_>, &Settings, &Registry, u8) -> Result<Row<R>, Failure>,
    failed: impl Fn(u8, &Failure) -> R,
) -> Result<Rows<R>, Failure> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    let addresses = addresses_to_read(settings, *observe)?;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let (mut rows, mut failures, mut succeeded) = (Vec::new(), Vec::new(), 0);
    for address in addresses {
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

/// Whether a failure ends the session: the port is gone, or somebody pressed Ctrl-C.
fn is_over(failure: &Failure) -> bool {
    matches!(failure.class, Class::Port | Class::Interrupted)
}
