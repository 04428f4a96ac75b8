//! One drive, read for a report: what ails it first, because every question can overwrite why it refused something last.

use super::Args;
use crate::args::Settings;
use crate::command::verb::Verb;
use crate::command::{diag, identify, terms};
use crate::drive::paramfile::{Harvest, Wanted, compare, factory, harvest, in_force, left_out, rows};
use crate::drive::{Recognised, Session, Target, is_over};
use crate::failure::{Class, Failure};
use crate::outcome::{ErrorDoc, ReportedDrive};
use crate::profile::Registry;
use crate::profile::paramfile::Scope;

/// What a drive told.
pub(super) struct Handed {
    pub(super) drive: ReportedDrive,
    /// It is there.
    pub(super) target: Option<Target>,
    /// Why that is not all.
    pub(super) failure: Option<Failure>,
}

/// Reads the drive at an address.
pub(super) async fn hand_over(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
    changed_only: bool,
) -> Handed {
    let mut drive = blank(address);
    let found = async {
        let terms = terms(settings, registry)?;
        let mut found = terms.recognised(session, address, true).await?;
        found.product = terms.product(session, &found).await?;
        Ok::<_, Failure>(found)
    };
    let mut found = match found.await {
        Ok(found) => found,
        Err(failure) => {
            drive.error = Some(ErrorDoc::from(&failure));
            return Handed { drive, target: None, failure: Some(failure) };
        }
    };
    drive.drive = found.target.family.drive.clone();
    let failures = match tell(session, registry, &mut found, &mut drive, changed_only).await {
        Ok(failures) => failures,
        Err(failure) => vec![failure],
    };
    let failure = worst(failures, drive.values.is_empty());
    drive.error = failure.as_ref().map(ErrorDoc::from);
    Handed { drive, target: Some(found.target), failure }
}

/// Asks everything; what failed of it and hinders nothing else.
async fn tell(
    session: &mut Session<'_>,
    registry: &Registry,
    found: &mut Recognised,
    drive: &mut ReportedDrive,
    changed_only: bool,
) -> Result<Vec<Failure>, Failure> {
    let (diagnosis, mut failures, _) = diag::look(session, &mut found.target).await?;
    drive.diagnosis = Some(diagnosis);
    let (identity, more, _) = identify::told(session, registry, found).await?;
    drive.identity = Some(identity);
    failures.extend(more);
    if !failures.iter().any(is_over) {
        failures.extend(settings(session, &mut found.target, drive, changed_only).await?);
    }
    Ok(failures)
}

/// Reads every setting.
async fn settings(
    session: &mut Session<'_>,
    target: &mut Target,
    drive: &mut ReportedDrive,
    changed_only: bool,
) -> Result<Option<Failure>, Failure> {
    let family = target.family.clone();
    let wanted = Wanted::of(Scope::Settings, &family)?;
    session.allow(session.now(), <Args as Verb>::UPPER.questions(wanted.asked.len() as u64));
    let mut before = Harvest::default();
    wanted.left.iter().for_each(|&(number, reason)| before.leave(number, reason));
    let read = harvest(session, target, &wanted.asked, before, &mut |_| {}).await;
    let known = |number: u32| read.settings.params().any(|param| param.id == number);
    let mut factory = factory(&family);
    factory.retain(|one| known(one.param.id));
    let compared = compare(&factory, &read.settings, false, &read.failures, &family);
    (drive.compared, drive.differences) = (compared.count, compared.differences);
    let is_whole = read.is_complete() && !read.settings.is_empty();
    drive.signature = is_whole.then(|| read.settings.signature(&family.drive).to_string());
    drive.not_held = left_out(&read);
    let mut stored = read.settings.clone();
    if changed_only {
        // Of what differs all data sets stand side by side, and so do those that differ from each other.
        let differs = |number: u32| drive.differences.iter().any(|row| row.param == number);
        stored.retain(|one| one.set > 0 || differs(one.param.id));
    }
    drive.values = rows(session, target, &stored);
    let failure = read.failure();
    if !failure.as_ref().is_some_and(is_over) {
        drive.in_force = in_force(session, target, &read.settings).await;
    }
    Ok(failure)
}

/// What is told of several things that failed: what ends the session; else the first of them, or, where something was read, that it
/// is only partly done.
fn worst(failures: Vec<Failure>, is_nothing: bool) -> Option<Failure> {
    let end = failures.iter().find(|failure| is_over(failure)).cloned();
    let first = failures.into_iter().next();
    let partial = |failure: Failure| Failure { class: Class::Partial, code: "partial".to_owned(), ..failure };
    end.or(if is_nothing { first } else { first.map(partial) })
}

fn blank(address: u8) -> ReportedDrive {
    ReportedDrive {
        address,
        node: 0,
        drive: "unknown".to_owned(),
        called: None,
        identity: None,
        diagnosis: None,
        signature: None,
        values: Vec::new(),
        not_held: Vec::new(),
        compared: 0,
        differences: Vec::new(),
        in_force: Vec::new(),
        error: None,
    }
}
