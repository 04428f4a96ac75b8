//! `write` with PROFIBUS spoken: parameters of an inverter over PKW, asked for and proven as everywhere.

use super::given::{SlaveArgs, element};
use super::open;
use super::spoken::Spoken;
use super::taking::{question, whom};
use crate::command::{Context, asking};
use crate::drive::job::{self, Job, Step};
use crate::drive::profibus::{Ending, Exchange, UNLOCKS, planned};
use crate::drive::{Target, summary};
use crate::failure::{Class, Failure};
use crate::gate;
use crate::outcome::{Data, ErrorDoc, Outcome, Write, WriteResult, Written};
use crate::profile::{Family, HazardKind, Param};
use crate::text::{Text, both};
use std::rc::Rc;

/// The mapping of process words that are written (SJ2-PB manual 4.1.2.5): what stands in it makes a word of a master a value.
const MAPPING: u32 = 915;

/// What a parameter and a value, as they were typed, are for a family.
type Understood<'w> = dyn Fn(&Family, &str, &str) -> Result<Vec<Step>, Failure> + 'w;

/// What is to be written.
pub(in crate::command) struct Wanted<'w> {
    /// Parameters, and their values, as they were typed.
    pub(in crate::command) assignments: Vec<(&'w str, &'w str)>,
    /// What one of them is for a family.
    pub(in crate::command) assigned: &'w Understood<'w>,
    /// Also what is forbidden or changes nothing.
    pub(in crate::command) force: bool,
}

/// Writes to one inverter.
pub(in crate::command) async fn write(
    wanted: &Wanted<'_>,
    slave: &SlaveArgs,
    context: &mut Context<'_>,
) -> Result<Outcome, Failure> {
    let whom = whom(slave, context)?;
    whom.with_pkw()?;
    let (_, rows) = steps(wanted, &whom.presumed, whom.address)?;
    let is_lock = rows.iter().all(|row| row.param == UNLOCKS);
    if context.settings.dry_run {
        return Ok(Outcome::of(Data::Write(Write { dry_run: true, values: rows })));
    }
    let why = both!("to write its parameters", "um ihre Parameter zu schreiben");
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = asking::off_line(interrupt, *ask, &question(whom.address, &why, Some(Spoken::Profidrive))).await?;
    let mut line = open(slave.slot_time, (settings, registry), interrupt, *observe).await?;
    let mut exchange = whom.exchange(&mut line, &permit)?;
    let mut job = None;
    let done = async {
        let family = whom.family(&mut exchange, registry, is_lock).await?;
        let (steps, rows) = steps(wanted, &family, whom.address)?;
        let job = job.insert(Job { target: Target::new(whom.address, family.clone()), steps, rows });
        for (step, row) in job.steps.iter().zip(&mut job.rows) {
            exchange.before(step, row, wanted.force).await?;
        }
        carry_out(&mut exchange, job, *ask).await?;
        exchange.parting(&family).await
    };
    let done = done.await;
    let left = exchange.leave().await;
    Ok(told(job, done, left))
}

/// What was typed, by the names of a family.
fn steps(wanted: &Wanted<'_>, family: &Rc<Family>, address: u8) -> Result<(Vec<Step>, Vec<Written>), Failure> {
    let (mut steps, mut rows) = (Vec::new(), Vec::new());
    for (who, what) in &wanted.assignments {
        let (who, element) = element(who);
        for mut step in (wanted.assigned)(family, who, what)? {
            if let (None, Some(count)) = (element, step.param.elements) {
                return Err(no_element(step.param.id, count));
            }
            let mapped = u32::try_from(step.raw).ok().and_then(|index| family.param(index));
            if step.param.id == MAPPING && mapped.is_some_and(|param: &Param| param.hazard.is_some()) {
                step.param.hazard = Some(HazardKind::Motion);
            }
            rows.push(planned(address, family, &step, element)?);
            steps.push(step);
        }
    }
    Ok((steps, rows))
}

/// An array has no value as a whole.
fn no_element(id: u32, count: u8) -> Failure {
    let message =
        both!("P.{id} is an array of {count}: which element?", "P.{id} ist ein Feld mit {count} Elementen: welches?");
    Failure::new(Class::Usage, "usage.element", message)
        .hint(both!("behind a point, from 1: {id}.1", "hinter einem Punkt, ab 1: {id}.1"))
}

/// Asks, with the slave kept going, and writes one value after another; the first that fails leaves out the rest.
async fn carry_out(exchange: &mut Exchange<'_, '_>, job: &mut Job, ask: &mut dyn gate::Ask) -> Result<(), Failure> {
    let Some(question) = job::question(std::slice::from_ref(job), None) else { return Ok(()) };
    let permit = exchange.during(gate::ask(ask, &question)).await?.map_err(asking::denied)?;
    for (step, row) in job.steps.iter().zip(&mut job.rows) {
        if row.result == WriteResult::Planned {
            exchange.write(step, row, &permit).await?;
        }
    }
    Ok(())
}

fn told(job: Option<Job>, done: Result<Text, Failure>, left: Ending) -> Outcome {
    let mut values = job.map(|job| job.rows).unwrap_or_default();
    let (parting, failure) = match done {
        Ok(parting) => (Some(parting), None),
        Err(failure) => (None, Some(failure)),
    };
    let warnings = left.warnings(parting);
    for row in values.iter_mut().filter(|row| row.result == WriteResult::Planned) {
        row.result = WriteResult::Skipped;
        row.error = failure.as_ref().map(ErrorDoc::from);
    }
    let is_good = |row: &&Written| {
        row.error.is_none() && row.result != WriteResult::Skipped && row.result != WriteResult::Unknown
    };
    let succeeded = values.iter().filter(is_good).count();
    let failure = left.failure.or_else(|| summary(failure.into_iter().collect(), succeeded));
    Outcome { data: Some(Data::Write(Write { dry_run: false, values })), warnings, failure }
}
