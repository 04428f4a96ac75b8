//! `statemachine`: in which state is the drive, and how is it controlled?

use super::{Context, Reader, Row, each_drive, finish, plan, role_questions, target};
use crate::args::Settings;
use crate::drive::{Session, describe};
use crate::failure::Failure;
use crate::outcome::{Data, ErrorDoc, Outcome, StateReport, Statemachine};
use crate::profile::Registry;
use clap::{Args as ClapArgs, Subcommand};

/// Shows the state of the drive's state machine. Reading only.
///
/// Shows the state that the status word means, status and control word bit by bit, the control mode (P.412) and the
/// active fault.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Copy, Debug, Subcommand)]
enum Action {
    /// Show state, words and control mode (the default)
    Show,
}

/// Roles that are read, in this order.
const ROLES: [&str; 4] = ["status-word", "control-mode", "control-word", "fault"];

/// Shows the state of every drive that was named.
pub async fn run(_args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let questions = role_questions(context, &ROLES)?;
        return plan(context, &questions);
    }
    let (drives, failures, succeeded) = each_drive(
        context,
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            show(session, settings, registry, address).await
        },
        |address, failure: &Failure| StateReport {
            address,
            drive: "unknown".to_owned(),
            state: None,
            status: None,
            control: None,
            control_mode: None,
            fault: None,
            fault_code: None,
            error: Some(ErrorDoc::from(failure)),
        },
    )
    .await?;
    Ok(finish(Data::Statemachine(Statemachine { drives }), failures, succeeded, Vec::new()))
}

async fn show(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Row<StateReport>, Failure> {
    let mut target = target(session, settings, registry, address, false).await?;
    let mut reader = Reader::new(session, &mut target, settings);
    let status = reader.vital_role("status-word").await?.and_then(|value| value.word);
    let control_mode = reader.role("control-mode").await?;
    let control = reader.role("control-word").await?.and_then(|value| value.word);
    let fault = reader.vital_role("fault").await?.and_then(|value| value.raw);
    let family = &reader.target.family;
    let report = StateReport {
        address,
        drive: family.drive.clone(),
        state: status.as_ref().and_then(|word| word.state.clone()),
        status,
        control,
        control_mode,
        fault: fault.and_then(|code| describe::fault(family, code as u32, settings.lang)),
        fault_code: fault,
        error: None,
    };
    let (failures, good) = reader.into_failures();
    Ok((report, failures, good))
}
