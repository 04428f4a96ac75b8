//! `sollwert`: setpoints and actual values side by side.

use super::{Context, Reader, Row, each_drive, finish, plan, role_questions, target};
use crate::args::Settings;
use crate::drive::Session;
use crate::failure::Failure;
use crate::outcome::{Data, ErrorDoc, Outcome, SetpointReport, Sollwert, Value};
use crate::profile::Registry;
use clap::Args as ClapArgs;

/// Shows setpoints and actual values side by side. Reading only.
///
/// Setpoints: internal (P.228), from the line (P.282), at the ramp (P.283), percentage (P.229). Actual values:
/// frequencies, speed, current. Below them stands what decides how the setpoint is formed (P.434, limits).
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {}

const SETPOINTS: [&str; 4] = ["setpoint-internal", "setpoint-bus", "setpoint-ramp", "percent-reference"];
const ACTUAL: [&str; 5] = ["actual-frequency", "stator-frequency", "encoder-frequency", "encoder-speed", "current"];
const SOURCES: [&str; 3] = ["ramp-setpoint", "min-frequency", "max-frequency"];

/// Shows the setpoints of every drive that was named.
pub async fn run(_args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let questions = role_questions(context, &[&SETPOINTS[..], &ACTUAL, &SOURCES].concat())?;
        return plan(context, &questions);
    }
    let (drives, failures, succeeded) = each_drive(
        context,
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            show(session, settings, registry, address).await
        },
        |address, failure: &Failure| SetpointReport {
            address,
            drive: "unknown".to_owned(),
            setpoints: Vec::new(),
            actual: Vec::new(),
            sources: Vec::new(),
            error: Some(ErrorDoc::from(failure)),
        },
    )
    .await?;
    Ok(finish(Data::Sollwert(Sollwert { drives }), failures, succeeded, Vec::new()))
}

async fn show(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Row<SetpointReport>, Failure> {
    let mut target = target(session, settings, registry, address, false).await?;
    let mut reader = Reader::new(session, &mut target, settings);
    let report = SetpointReport {
        address,
        drive: reader.target.family.drive.clone(),
        setpoints: roles(&mut reader, &SETPOINTS).await?,
        actual: roles(&mut reader, &ACTUAL).await?,
        sources: roles(&mut reader, &SOURCES).await?,
        error: None,
    };
    let (failures, good) = reader.into_failures();
    Ok((report, failures, good))
}

async fn roles(reader: &mut Reader<'_, '_, '_>, roles: &[&str]) -> Result<Vec<Value>, Failure> {
    let mut values = Vec::new();
    for role in roles {
        values.extend(reader.role(role).await?);
    }
    Ok(values)
}
