//! `diag`: what ails the drive, or the line to it?

use super::{Context, Reader, Row, each_drive, finish, plan, role_questions, target};
use crate::args::Settings;
use crate::drive::{AccessError, Inquiry, Session, clear_counters, counters, describe, link_test};
use crate::failure::{Class, Failure};
use crate::gate::{self, Hazard, Permit, Question};
use crate::outcome::{Data, Diag, Diagnosis, ErrorDoc, Outcome};
use crate::profile::Registry;
use clap::Args as ClapArgs;

/// Diagnoses a drive and the line to it.
///
/// Shows the state, the active fault (P.260) with cause and remedy, every warning bit (P.270), the error register
/// (P.11; reading clears it) and the drive's diagnostic counters with what each means.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// Set the diagnostic counters to zero after showing them
    #[arg(long)]
    pub clear: bool,

    /// Ask N harmless questions and show error rate and reply times
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub link_test: Option<u32>,

    /// For scripts: exit with 1 if a fault is present
    #[arg(long)]
    pub check: bool,
}

/// Diagnoses every drive that was named.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let questions = questions(args, context)?;
        return plan(context, &questions);
    }
    let permit = if args.clear { Some(ask_to_clear(context)?) } else { None };
    let (drives, failures, succeeded) = each_drive(
        context,
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            diagnose(session, settings, registry, address, args, permit.as_ref()).await
        },
        |address, failure: &Failure| Diagnosis { error: Some(ErrorDoc::from(failure)), ..blank(address) },
    )
    .await?;
    let ill: Vec<_> =
        drives.iter().filter(|drive| drive.fault.is_some()).map(|drive| drive.address.to_string()).collect();
    let mut outcome = finish(Data::Diag(Diag { drives }), failures, succeeded, Vec::new(), context.settings.lang);
    if args.check && outcome.failure.is_none() && !ill.is_empty() {
        let message = format!("a fault is present at address {}", ill.join(", "));
        outcome.failure = Some(Failure::new(Class::No, "no.fault_present", message));
    }
    Ok(outcome)
}

/// What is asked, in this order; the link test repeats one of them.
fn questions(args: &Args, context: &Context<'_>) -> Result<Vec<Inquiry>, Failure> {
    let mut questions = role_questions(context, &["error-register", "status-word", "fault", "warnings"])?;
    let family = super::offline_family(context.settings, context.registry)?;
    questions.extend(family.counters.iter().map(|row| Inquiry::Counter(row.sub)));
    questions.extend(args.clear.then_some(Inquiry::ClearCounters));
    Ok(questions)
}

fn ask_to_clear(context: &mut Context<'_>) -> Result<Permit, Failure> {
    let question = Question {
        hazards: vec![Hazard::Write],
        title: "set the diagnostic counters of the drive to zero".to_owned(),
        details: vec!["what they counted so far is lost in the drive; this command shows it first".to_owned()],
    };
    gate::ask(context.ask, &question).map_err(super::write::denied)
}

fn blank(address: u8) -> Diagnosis {
    Diagnosis {
        address,
        drive: "unknown".to_owned(),
        healthy: false,
        status: None,
        fault: None,
        fault_code: None,
        warnings: None,
        error_register: None,
        counters: Vec::new(),
        counters_cleared: false,
        link: None,
        error: None,
    }
}

async fn diagnose(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
    args: &Args,
    permit: Option<&Permit>,
) -> Result<Row<Diagnosis>, Failure> {
    let lang = settings.lang;
    let mut target = target(session, settings, registry, address, true).await?;
    let mut reader = Reader::new(session, &mut target, settings);
    // First of all: any refused question would overwrite it.
    let register = reader.role("error-register").await?.and_then(|value| value.raw);
    let status = reader.vital_role("status-word").await?.and_then(|value| value.word);
    let fault = reader.vital_role("fault").await?.and_then(|value| value.raw);
    let warnings = reader.vital_role("warnings").await?.and_then(|value| value.word);
    let (mut failures, good) = reader.into_failures();
    let family = &target.family;
    let mut report = Diagnosis {
        drive: family.drive.clone(),
        healthy: fault == Some(0) && warnings.as_ref().is_some_and(|word| word.raw == 0),
        status,
        fault_code: fault,
        fault: fault.and_then(|code| describe::fault(family, code as u32, lang)),
        warnings,
        error_register: register.map(|code| describe::register(family, code as u32, lang)),
        ..blank(address)
    };
    let failed = |error: AccessError| error.failure(address, Some(&target.family), lang);
    match counters(session, &target, lang).await {
        Ok(counters) => report.counters = counters,
        Err(error) if error.is_fatal() => return Err(failed(error)),
        Err(error) => failures.push(failed(error)),
    }
    if let Some(count) = args.link_test {
        let (test, cut) = link_test(session, &target, count.into()).await;
        report.link = Some(test);
        if let Some(error) = cut {
            failures.push(failed(error));
            return Ok((report, failures, good));
        }
    }
    if let Some(permit) = permit {
        report.counters_cleared = clear_counters(session, &target, permit).await.map_err(failed)?;
    }
    Ok((report, failures, good))
}
