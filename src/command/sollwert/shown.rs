//! `sollwert` without a value: what the drives have and do.

use super::Args;
use crate::args::Settings;
use crate::command::verb::Verb;
use crate::command::{Context, Reader, Row, each_drive, finish, offline_family, plan, read_question, target};
use crate::drive::Session;
use crate::drive::motion::role_raw;
use crate::failure::Failure;
use crate::outcome::{Data, ErrorDoc, Outcome, SetpointReport, Sollwert, Value};
use crate::profile::{DataSets, Family, Registry, Sets, Store};

/// Shows every drive that was named.
pub(super) async fn show_all(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let family = offline_family(context.settings, context.registry)?;
        let show = &family.motion.show;
        let ids = [&show.setpoints[..], &show.actual, &show.sources].concat();
        let questions: Vec<_> =
            ids.iter().filter_map(|&id| family.param(id)).map(|param| read_question(param, 0)).collect();
        return plan(context, &family, &questions);
    }
    let (drives, failures, succeeded) = each_drive(
        context,
        <Args as Verb>::UPPER.drive,
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
    let family = target.family.clone();
    let works_in = match family.link.route.has_data_sets() {
        true => role_raw(session, &mut target, "active-set").await.ok().flatten(),
        false => None,
    };
    let mut reader = Reader::new(session, &mut target);
    reader.lenient = true;
    let report = SetpointReport {
        address,
        drive: family.drive.clone(),
        setpoints: values(&mut reader, &family, &family.motion.show.setpoints, None).await?,
        actual: values(&mut reader, &family, &family.motion.show.actual, None).await?,
        sources: values(&mut reader, &family, &family.motion.show.sources, works_in).await?,
        error: None,
    };
    let (failures, good) = reader.into_failures();
    Ok((report, failures, good))
}

/// What the drive works with, where its data sets are told: RAM of the one in use, or what is the same in all of them.
async fn values(
    reader: &mut Reader<'_, '_>,
    family: &Family,
    ids: &[u32],
    works_in: Option<i64>,
) -> Result<Vec<Value>, Failure> {
    let params: Vec<_> = ids.iter().filter_map(|&id| family.param(id).cloned()).collect();
    if works_in.is_none() {
        reader.fetch(&params).await?;
    }
    let mut values = Vec::new();
    for param in &params {
        let active = works_in.filter(|_| param.sets == Some(Sets::Four)).and_then(|set| u8::try_from(set).ok());
        let sets = match works_in {
            Some(_) => DataSets::One(active.unwrap_or(0), Store::Ram),
            None => DataSets::Unnamed,
        };
        values.extend(reader.rows(param, sets).await?.into_iter().next());
    }
    Ok(values)
}
