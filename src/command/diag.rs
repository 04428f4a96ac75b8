//! `diag`: what ails the drive, or the line to it?

use super::lines::OverLines;
use super::profibus::{self, ModeArg, SlaveArgs};
use super::verb::{Verb, Working};
use super::{Context, Reader, Row, each_drive, finish, is_over, plan, role_questions, target};
use crate::args::{Settings, Takes};
use crate::drive::motion::{missing, surroundings};
use crate::drive::{
    AccessError, Inquiry, Session, Target, Upper, clear_counters, counters, describe, last_refusal, link_test,
};
use crate::failure::{Class, Failure};
use crate::gate::{Counters, Hazard, Permit, Question};
use crate::outcome::{
    BusDiagnosis, Data, Diag, Diagnosis, Document, ErrorDoc, Event, OrLine, OrLines, Outcome, Value, Word,
};
use crate::profile::{Cause, DataSets, Family, Registry};
use crate::text::{Text, both};
use clap::Args as ClapArgs;

/// Diagnoses a drive and the line to it.
///
/// Shows the state, the active fault with cause and remedy, every warning bit, the digital inputs bit by bit, the entry of the fault memory, why the
/// drive refused something last (P.11, which reading clears, or the last synchronous error), its watchdog, and its
/// diagnostic counters with what each means. Over the system bus it shows the state of node and controller too (P.978, P.979), and the
/// emergencies that were heard meanwhile.
///
/// Over PROFIBUS (--protocol dp) a slave is taken for it, held by the stop word, and let go: Slave_Diag, the trip and its data, what
/// a lost master means (P.703, P.620), and what its LEDs show. Nothing is written.
#[derive(Clone, Debug, ClapArgs)]
#[command(args_conflicts_with_subcommands = true)]
pub struct Args {
    /// What to look at in place of the drives
    #[command(subcommand)]
    pub what: Option<What>,

    /// Set the diagnostic counters to zero after showing them
    #[arg(long)]
    pub clear: bool,

    /// Ask N harmless questions: error rate, reply times
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub link_test: Option<u32>,

    /// For scripts: exit with 1 if a fault is present
    #[arg(long)]
    pub check: bool,

    /// How a slave is taken.
    #[command(flatten)]
    pub slave: SlaveArgs,
    /// How it is led.
    #[command(flatten)]
    pub mode: ModeArg,
}

/// Something else to diagnose than drives.
#[derive(Clone, Debug, clap::Subcommand)]
pub enum What {
    /// The line itself
    Line(super::diag_line::Args),
}

impl Verb for Args {
    const NAME: &'static str = "diag";
    const TAKES: Takes = Takes::WRITES;
    const SDO: bool = true;
    const PROFIBUS: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1,2 diag --check",
        "antrieb --port sim -a 1 diag --link-test 100",
        "antrieb --port sim -a 1 diag line --count 50",
        "antrieb --port sim --protocol dp -a 3 diag --yes",
    ];
    const UPPER: Upper = Upper::drive(90).each(1, "question of --link-test or --count");
    type Prints = Document<OrLine<OrLines<Diag>>>;

    fn over_lines(&self) -> OverLines {
        if self.clear { OverLines::One(None) } else { OverLines::Each }
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Diagnoses every drive that was named.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if let Some(What::Line(args)) = &args.what {
        return super::diag_line::run(args, context).await;
    }
    if args.mode.is_meant(&args.slave, context.settings)? {
        return over_profibus(args, context).await;
    }
    if context.settings.dry_run {
        let family = super::offline_family(context.settings, context.registry)?;
        return plan(context, &family, &questions(args, &family));
    }
    let permit = if args.clear { Some(ask_to_clear(context).await?) } else { None };
    let (drives, failures, succeeded) = each_drive(
        context,
        <Args as Verb>::UPPER.questions(args.link_test.unwrap_or(0).into()),
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            diagnose(session, settings, registry, address, args, permit.as_ref()).await
        },
        |address, failure: &Failure| Diagnosis { error: Some(ErrorDoc::from(failure)), ..blank(address) },
    )
    .await?;
    let (faulted, unknown) = (listed(&drives, |drive| drive.fault.is_some()), listed(&drives, untold));
    let mut outcome = finish(Data::Diag(Diag { drives }), failures, succeeded, Vec::new());
    if args.check {
        outcome.failure = checked(outcome.failure, &faulted, &unknown);
    }
    Ok(outcome)
}

/// Diagnoses one slave of PROFIBUS and its inverter.
async fn over_profibus(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    profibus::refuse(&[("--clear", args.clear), ("--link-test", args.link_test.is_some())])?;
    let of = (&args.slave, args.mode.choice(), blank(0));
    let (report, mut failure, warnings) = match profibus::diag(of, context).await? {
        Ok(found) => found,
        Err(plan) => return Ok(plan),
    };
    let drives = vec![report];
    if args.check {
        failure = checked(
            failure,
            &listed(&drives, |drive| drive.fault.is_some()),
            &listed(&drives, |drive| untold(drive) && drive.fault.is_none()),
        );
    }
    Ok(Outcome { data: Some(Data::Diag(Diag { drives })), warnings, failure })
}

/// State of a node and of its controller (EM-RES-03 manual 5.12).
const BUS_STATES: [&str; 2] = ["node-state", "can-state"];

/// Whether nobody can say if the drive has a fault.
fn untold(drive: &Diagnosis) -> bool {
    drive.fault_code.is_none()
}

fn listed(drives: &[Diagnosis], which: impl Fn(&Diagnosis) -> bool) -> String {
    let addresses: Vec<_> = drives.iter().filter(|drive| which(drive)).map(|drive| drive.address.to_string()).collect();
    addresses.join(", ")
}

/// What `--check` says: a drive that does not answer hides no fault of another.
fn checked(failure: Option<Failure>, faulted: &str, unknown: &str) -> Option<Failure> {
    if faulted.is_empty() {
        let untold = || {
            let message = both!(
                "nothing tells whether a fault is present at address {unknown}",
                "nichts sagt, ob bei Adresse {unknown} eine Störung anliegt"
            );
            Failure::new(Class::Data, "data.fault_untold", message).with("unknown", unknown)
        };
        return failure.or_else(|| (!unknown.is_empty()).then(untold));
    }
    let message = both!("a fault is present at address {faulted}", "eine Störung liegt an bei Adresse {faulted}");
    Some(match failure {
        None => Failure::new(Class::No, "no.fault_present", message).with("faulted", faulted),
        Some(failure) => {
            let rest = match unknown.is_empty() {
                true => Text::default(),
                false => both!("; not known of address {unknown}", "; nicht bekannt von Adresse {unknown}"),
            };
            let class = if is_over(&failure) { failure.class } else { Class::Partial };
            let said =
                failure.within(|why| both!("{message}{rest}; {why}", "{message}{rest}; {why}", message, rest, why));
            Failure { class, ..said }.with("faulted", faulted).with("unknown", unknown)
        }
    })
}

/// What is asked, in this order; the link test repeats one of them.
fn questions(args: &Args, family: &Family) -> Vec<Inquiry> {
    let mut questions = looks(family);
    questions.extend(args.clear.then_some(Inquiry::ClearCounters));
    questions
}

/// What is asked of every drive, in this order.
pub(super) fn looks(family: &Family) -> Vec<Inquiry> {
    let mut questions = role_questions(family, &["error-register"]);
    if let Cause::Diagnostics(sub) = family.link.cause {
        questions.push(Inquiry::Counter(sub));
    }
    questions.extend(role_questions(family, &["status-word", "fault", "warnings", "digital-inputs", "watchdog"]));
    let memory = family.group("faults").unwrap_or_default();
    questions.extend(memory.iter().filter_map(|&id| family.param(id)).map(|param| super::read_question(param, 0)));
    questions.extend(family.counters.iter().map(|row| Inquiry::Counter(row.sub)));
    questions
}

async fn ask_to_clear(context: &mut Context<'_>) -> Result<Permit<Counters>, Failure> {
    let question = Question {
        hazards: vec![Hazard::Counters],
        title: both!(
            "set the diagnostic counters of the drive to zero",
            "die Diagnosezähler des Antriebs auf null setzen"
        ),
        details: vec![both!(
            "what they counted so far is lost in the drive; this command shows it first",
            "was sie bisher gezählt haben, geht im Antrieb verloren; dieser Befehl zeigt es vorher"
        )],
    };
    super::asking::off_line(&context.interrupt, context.ask, &question).await
}

fn blank(address: u8) -> Diagnosis {
    Diagnosis {
        address,
        node: 0,
        drive: "unknown".to_owned(),
        healthy: false,
        status: None,
        tells_faults: true,
        fault: None,
        fault_code: None,
        warnings: None,
        inputs: None,
        bus: None,
        missing: Vec::new(),
        memory: Vec::new(),
        watchdog: None,
        error_register: None,
        counters: Vec::new(),
        counters_cleared: false,
        link: None,
        slave: None,
        error: None,
    }
}

/// Recognising a drive asks it something that it refuses, and that is its last synchronous error then.
fn overwritten() -> Text {
    both!(
        "asking which drive it is has overwritten its last synchronous error; --drive shows it",
        "die Frage, welcher Antrieb es ist, hat seinen letzten synchronen Fehler überschrieben; --drive zeigt ihn"
    )
}

/// The parameters that show the entry of the fault memory, where the family has some.
async fn memory(reader: &mut Reader<'_, '_>, family: &Family) -> Result<Vec<Value>, Failure> {
    let Some(ids) = family.group("faults") else { return Ok(Vec::new()) };
    let params: Vec<_> = ids.iter().filter_map(|&id| family.param(id).cloned()).collect();
    reader.lenient = true;
    reader.fetch(&params).await?;
    let mut memory = Vec::new();
    for param in &params {
        memory.extend(reader.rows(param, DataSets::Unnamed).await?);
    }
    Ok(memory)
}

/// The fault that is present, 0 for none; `None` where nobody can say.
///
/// A family without a status word has no state that could tell that the code is of the past.
fn present_fault(family: &Family, status: Option<&Word>, code: Option<i64>) -> Option<u32> {
    let word = match status {
        Some(word) => Some(word.raw),
        None if family.role("status-word").is_none() => None,
        None => return None,
    };
    Some(family.present_fault(word, code? as u32).unwrap_or(0))
}

/// Why the drive refused something last, if this command has not made it refuse something itself.
async fn kept_refusal(session: &mut Session<'_>, target: &mut Target) -> Result<Option<u16>, AccessError> {
    if matches!(target.family.link.cause, Cause::Diagnostics(_)) && target.refused_on_the_way {
        session.tell(Event::Note(overwritten()));
        return Ok(None);
    }
    last_refusal(session, target).await
}

async fn diagnose(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
    args: &Args,
    permit: Option<&Permit<Counters>>,
) -> Result<Row<Diagnosis>, Failure> {
    let mut target = target(session, settings, registry, address, true).await?;
    let (mut report, mut failures, good) = look(session, &mut target).await?;
    failures.extend(the_line(session, &mut target, &mut report, args.link_test, permit).await?);
    Ok((report, failures, good))
}

/// What the drive itself tells of what ails it.
pub(super) async fn look(session: &mut Session<'_>, target: &mut Target) -> Result<Row<Diagnosis>, Failure> {
    let (address, family) = (target.address, target.family.clone());
    let failed = |error: AccessError| error.failure(address, Some(&family));
    // First of all: any refused question would overwrite it.
    let refusal = kept_refusal(session, target).await.map_err(failed)?;
    let mut reader = Reader::new(session, target);
    let register = reader.role("error-register").await?.and_then(|value| value.raw);
    let status = reader.vital_role("status-word").await?.and_then(|value| value.word);
    // Once for both: on some drives reading moves on to the entry before.
    let memory = memory(&mut reader, &family).await?;
    let newest = memory.iter().find(|value| family.role("fault").is_some_and(|param| param.id == value.param));
    let fault = match newest {
        Some(newest) => newest.raw,
        None => reader.vital_role("fault").await?.and_then(|value| value.raw),
    };
    let warnings = reader.vital_role("warnings").await?.and_then(|value| value.word);
    let inputs = reader.role("digital-inputs").await?.and_then(|value| value.word);
    let watchdog = reader.in_force("watchdog").await?.value;
    let (failures, good) = reader.into_failures();
    let code = present_fault(&family, status.as_ref(), fault);
    let missing = match status.as_ref().filter(|_| failures.is_empty() && family.is_movable()) {
        Some(word) => match surroundings(session, target, word.raw).await {
            Ok(around) => missing(&around, target),
            Err(failure) if is_over(&failure) => return Err(failure),
            // What it does not tell besides spoils no diagnosis.
            Err(_) => Vec::new(),
        },
        None => Vec::new(),
    };
    let warns = family.role("warnings").is_some() && warnings.as_ref().is_none_or(|word| word.raw != 0);
    let report = Diagnosis {
        drive: family.drive.clone(),
        healthy: code == Some(0) && !warns,
        status,
        tells_faults: family.role("fault").is_some(),
        fault_code: code.map(i64::from),
        fault: code.and_then(|code| describe::fault(&family, code)),
        warnings,
        inputs,
        bus: on_bus(session, target).await?,
        missing,
        memory,
        watchdog,
        error_register: register.or(refusal.map(i64::from)).map(|code| describe::register(&family, code as u32)),
        ..blank(address)
    };
    Ok((report, failures, good))
}

/// What a system bus tells of a drive that is asked over it.
async fn on_bus(session: &mut Session<'_>, target: &mut Target) -> Result<Option<BusDiagnosis>, Failure> {
    let (family, node) = (target.family.clone(), session.node());
    if node == 0 && !session.line().is_can() {
        return Ok(None);
    }
    let heard = if node == 0 { session.emergencies(target.address) } else { Vec::new() };
    let told = |fault: u16| match describe::fault(&family, fault.into()) {
        Some(fault) => fault.told(),
        None => both!("acknowledged", "quittiert"),
    };
    let emergencies = heard.into_iter().map(told).collect();
    let mut reader = Reader::new(session, target);
    reader.lenient = true;
    let mut values = Vec::new();
    for param in family.params.values().filter(|param| BUS_STATES.contains(&param.slug.as_str())) {
        values.extend(reader.rows(param, DataSets::Unnamed).await?);
    }
    Ok(Some(BusDiagnosis { values, emergencies }))
}

/// What its counters, and a test of the line to it, tell: what failed of that and hinders nothing else.
async fn the_line(
    session: &mut Session<'_>,
    target: &mut Target,
    report: &mut Diagnosis,
    link: Option<u32>,
    permit: Option<&Permit<Counters>>,
) -> Result<Vec<Failure>, Failure> {
    let (address, family) = (target.address, target.family.clone());
    let failed = |error: AccessError| error.failure(address, Some(&family));
    let mut failures = Vec::new();
    match counters(session, target).await {
        Ok(counters) => report.counters = counters,
        Err(error) if error.is_fatal() => return Err(failed(error)),
        Err(error) => failures.push(failed(error)),
    }
    if let Some(count) = link {
        let (test, cut) = link_test(session, target, count.into()).await.map_err(failed)?;
        report.link = Some(test);
        if let Some(error) = cut {
            failures.push(failed(error));
            return Ok(failures);
        }
    }
    if let Some(permit) = permit {
        report.counters_cleared = clear_counters(session, target, permit).await.map_err(failed)?;
    }
    Ok(failures)
}
