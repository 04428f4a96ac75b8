//! What is told of the data sets of one drive or of several, and writing to them behind one question.

use crate::command::write::permit;
use crate::command::{InForce, Reader};
use crate::drive::job::{self, Job, Step};
use crate::drive::{Session, Target, Terms, is_over, summary};
use crate::failure::{Class, Failure};
use crate::gate::Ask;
use crate::outcome::{Data, Dataset, Datasets, ErrorDoc, Outcome, Warning, WriteResult};
use crate::text::both;

/// A drive, and what is told of it.
#[derive(Debug)]
pub(super) struct Told {
    pub(super) report: Dataset,
    pub(super) failure: Option<Failure>,
    pub(super) warnings: Vec<Warning>,
}

impl Told {
    /// Of a drive that could not be asked.
    pub(super) fn nothing(address: u8, failure: Failure) -> Self {
        Told { report: blank(address, failure.family()), failure: Some(failure), warnings: Vec::new() }
    }

    /// Whether nobody can be asked any more.
    pub(super) fn is_over(&self) -> bool {
        self.failure.as_ref().is_some_and(is_over)
    }
}

/// A report that knows nothing yet.
pub(super) fn blank(address: u8, drive: &str) -> Dataset {
    Dataset {
        address,
        drive: drive.to_owned(),
        active: None,
        selection: None,
        selection_stored: None,
        rows: Vec::new(),
        written: Vec::new(),
        dry_run: false,
        error: None,
    }
}

/// The data set in use, and what selects it.
pub(super) async fn selection(
    session: &mut Session<'_>,
    target: &mut Target,
) -> Result<(Option<i64>, InForce), Failure> {
    let mut reader = Reader::new(session, target);
    // Of two sets the first has the number 0 on the wire (SJ2-PB manual 5.3).
    let first = i64::from(!reader.target.family.link.route.has_data_sets());
    let active = reader.vital_role("active-set").await?.and_then(|value| value.raw).map(|raw| raw + first);
    let selection = reader.in_force("set-selection").await?;
    // It is what the verb is about: a refusal is no answer.
    let refused = selection.value.is_none().then(|| reader.forgiven.pop()).flatten();
    match reader.failures.pop().or(refused) {
        Some(failure) => Err(failure),
        None => Ok((active, selection)),
    }
}

/// What came of the `named` drives: of one alone its own report, of several a row for each.
pub(super) fn told(drives: Vec<Told>, named: usize) -> Outcome {
    let (mut reports, mut failures, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
    for Told { report, failure, warnings: more } in drives {
        let address = report.address;
        let error = failure.as_ref().map(ErrorDoc::from).filter(|_| named > 1);
        reports.push(Dataset { error, ..report });
        failures.extend(failure.map(|failure| (address, failure)));
        let of_one = |text| both!("drive {address}: {text}", "Antrieb {address}: {text}", text);
        warnings.extend(more.into_iter().map(|one| match named {
            1 => one,
            _ => Warning { message: of_one(one.message), ..one },
        }));
    }
    let failure = if named == 1 { failures.pop().map(|(_, failure)| failure) } else { of_several(failures, named) };
    let data = match (named, reports.pop()) {
        (1, Some(only)) => Data::Dataset(Box::new(only)),
        (_, last) => {
            reports.extend(last);
            Data::Datasets(Datasets { drives: reports })
        }
    };
    Outcome { data: Some(data), warnings, failure }
}

/// Why not all of several drives are as they were wanted; that some differ is told only where all could be asked.
fn of_several(failures: Vec<(u8, Failure)>, named: usize) -> Option<Failure> {
    let broken = failures.iter().filter(|(_, failure)| failure.class != Class::No).map(|(_, failure)| failure.clone());
    let broken: Vec<Failure> = broken.collect();
    let count = failures.len();
    if !broken.is_empty() {
        let good = named.saturating_sub(broken.len());
        return summary(broken, good);
    }
    let (address, first) = failures.into_iter().next()?;
    Some(first.within(|why| {
        both!(
            "{count} of {named} drives; drive {address}: {why}",
            "{count} von {named} Antrieben; Antrieb {address}: {why}",
            why
        )
    }))
}

/// What is to be written to a drive.
pub(super) struct Planned {
    pub(super) target: Target,
    pub(super) steps: Vec<Step>,
    pub(super) warnings: Vec<Warning>,
}

/// Writes, after asking once for all drives, and reports.
pub(super) async fn write(
    session: &mut Session<'_>,
    ask: &mut dyn Ask,
    terms: &Terms<'_>,
    planned: Vec<Planned>,
) -> Result<Outcome, Failure> {
    let (mut jobs, mut warned) = (Vec::new(), Vec::new());
    for Planned { mut target, steps, warnings } in planned {
        let rows = job::prepare(session, &mut target, terms, &steps, false).await?;
        jobs.push(Job { target, steps, rows });
        warned.push(warnings);
    }
    let (permit, denied) = match permit(session, ask, &mut jobs).await {
        Ok(permit) => (permit, None),
        // Nothing was begun; a script is told what it would have been asked about.
        Err(failure) if failure.is_gone() || !ask.is_there() => (None, Some(job::leave(&mut jobs, failure))),
        Err(failure) => return Err(failure),
    };
    let (mut drives, named, mut over) = (Vec::new(), jobs.len(), None);
    for (mut job, warnings) in jobs.into_iter().zip(warned) {
        let is_left = job.rows.iter().any(|row| row.result == WriteResult::Skipped);
        let mut failures: Vec<Failure> = denied.iter().filter(|_| is_left).cloned().collect();
        if let Some(permit) = &permit {
            match over.clone() {
                Some(failure) => failures.push(job::leave(std::slice::from_mut(&mut job), failure)),
                None => drop(job::carry_out(session, &mut job, terms, permit, &mut failures).await),
            }
        }
        let seen = selection(session, &mut job.target).await;
        let good = job.rows.iter().filter(|row| row.error.is_none() && row.result != WriteResult::Skipped).count();
        let (active, selection) = seen.unwrap_or_else(|failure| {
            failures.push(failure);
            (None, InForce::default())
        });
        let InForce { value: selection, stored: selection_stored } = selection;
        over = over.or_else(|| failures.iter().find(|failure| is_over(failure)).cloned());
        let blank = blank(job.target.address, &job.target.family.drive);
        let report = Dataset { active, selection, selection_stored, written: job.rows, ..blank };
        drives.push(Told { report, failure: summary(failures, good), warnings });
    }
    let told = told(drives, named);
    Ok(Outcome { failure: denied.or(told.failure), ..told })
}
