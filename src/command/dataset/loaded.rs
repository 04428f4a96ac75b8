//! What is told of a `dataset load` or `dataset undo`: how it ended, what is left to do.

use crate::command::{Context, terms, write};
use crate::drive::describe;
use crate::drive::job::{self, Step};
use crate::drive::transaction::{Applied, Ended, Plan};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Load, LoadEnd, NotLoaded, Outcome, Warning, WriteResult};
use crate::profile::{Effective, Family, Role};
use crate::text::{Text, both};
use std::path::Path;
use std::rc::Rc;

/// A report that knows nothing yet.
pub(super) fn blank(address: u8, family: &Family, files: Vec<String>, left_out: Vec<NotLoaded>) -> Load {
    Load {
        address,
        node: 0,
        drive: family.drive.clone(),
        files,
        dry_run: false,
        ended: None,
        undo_file: None,
        eeprom_writes: 0,
        eeprom_writes_back: 0,
        restart: false,
        left_out,
        values: Vec::new(),
    }
}

/// Why nothing may be begun, if so: the rows say which values are in the way.
pub(super) fn forbidden(plan: &mut Plan) -> Option<Failure> {
    let failures = std::mem::take(&mut plan.failures);
    let count = failures.len();
    let first = failures.into_iter().next()?;
    for row in plan.job.rows.iter_mut().filter(|row| row.result == WriteResult::Planned) {
        row.result = WriteResult::Skipped;
    }
    let why = first.message.clone();
    let message = match count {
        1 => both!("{why}; nothing was written", "{why}; es wurde nichts geschrieben", why),
        _ => both!(
            "{why}; {more} more in the way; nothing was written",
            "{why}; {more} weitere stehen im Weg; es wurde nichts geschrieben",
            why,
            more = count - 1
        ),
    };
    Some(Failure { message, ..first })
}

/// What would be sent, without opening anything.
pub(super) fn dry_run(
    context: &Context<'_>,
    mut report: Load,
    family: &Rc<Family>,
    steps: &[Step],
) -> Result<Outcome, Failure> {
    let terms = terms(context.settings, context.registry)?;
    for step in steps {
        let mut row = describe::to_write(report.address, family, &step.param, step.set, step.raw);
        row.node = terms.speech.node;
        job::tell(&mut row, step.kind.and_then(|kind| job::telegram(&terms, family, report.address, step, kind)));
        report.values.push(row);
    }
    report.dry_run = true;
    let mut outcome = Outcome::of(Data::Load(report));
    outcome.warnings = vec![write::dry_run_reads()];
    Ok(outcome)
}

/// The whole of it, with what takes effect later.
pub(super) fn outcome(mut report: Load, plan: Plan, mut warnings: Vec<Warning>, failure: Option<Failure>) -> Outcome {
    let family = plan.job.target.family.clone();
    let rows = plan.job.steps.iter().zip(&plan.job.rows);
    let later: Vec<String> = rows
        .filter(|(step, row)| row.result == WriteResult::Verified && step.param.effective == Effective::Reset)
        .map(|(step, _)| step.param.label())
        .collect();
    report.restart = !later.is_empty();
    if report.restart {
        let labels = later.join(", ");
        let how = family.role(Role::Reset).map_or_else(Text::default, |param| {
            both!(" (restarts it: {label})", " (startet ihn neu: {label})", label = param.label())
        });
        let message = both!(
            "{labels} take effect after a restart of the drive{how}",
            "{labels}: wirkt erst nach einem Neustart des Antriebs{how}",
            how
        );
        warnings.push(Warning { code: "load.restart".to_owned(), message });
    }
    report.values = plan.job.rows;
    Outcome { data: Some(Data::Load(report)), warnings, failure }
}

/// How a transaction ended, and what to do next.
pub(super) fn applied_outcome(mut report: Load, plan: Plan, applied: Applied, left: &Path) -> Outcome {
    let Applied { ended, failures, notes } = applied;
    report.ended = Some(match ended {
        Ended::Done => LoadEnd::Done,
        Ended::Untouched => LoadEnd::Untouched,
        Ended::Back => LoadEnd::Back,
        Ended::Torn => LoadEnd::Torn,
    });
    let mut warnings: Vec<Warning> =
        notes.into_iter().map(|message| Warning { code: "load.altered".to_owned(), message }).collect();
    let file = left.display();
    let mut failures = failures.into_iter();
    let failure = failures.next().map(|first| {
        let why = first.message.clone();
        match ended {
            Ended::Done | Ended::Untouched => Failure {
                message: both!("{why}; nothing was changed", "{why}; es wurde nichts geändert", why),
                ..first
            },
            Ended::Back => partial(
                first,
                "partial.put_back",
                both!(
                    "{why}; all that was written is as it was before",
                    "{why}; alles Geschriebene ist wie vorher",
                    why
                ),
                both!("mend that and load it again", "das beheben und noch einmal laden"),
            ),
            Ended::Torn => partial(
                first,
                "partial.torn",
                unlike(&why, failures.len()),
                both!(
                    "`antrieb dataset undo {file}` brings them back once the drive answers",
                    "`antrieb dataset undo {file}` holt sie zurück, sobald der Antrieb antwortet"
                ),
            ),
        }
    });
    let more = failures.map(|failure| Warning { code: "load.not_put_back".to_owned(), message: failure.message });
    warnings.extend(more);
    outcome(report, plan, warnings, failure)
}

fn partial(first: Failure, code: &str, message: Text, hint: Text) -> Failure {
    Failure { class: Class::Partial, code: code.to_owned(), message, ..first }.hint(hint)
}

/// Why not everything is as it was.
pub(super) fn not_all_back(failures: Vec<Failure>) -> Option<Failure> {
    let count = failures.len();
    let first = failures.into_iter().next()?;
    let message = unlike(&first.message, count);
    Some(Failure { class: Class::Partial, code: "partial.undo".to_owned(), message, ..first })
}

fn unlike(why: &Text, count: usize) -> Text {
    match count {
        1 => both!(
            "{why}; 1 value may not be as before, the rows say which",
            "{why}; 1 Wert ist vielleicht nicht wie vorher, die Zeilen sagen welcher",
            why
        ),
        _ => both!(
            "{why}; {count} values may not be as before, the rows say which",
            "{why}; {count} Werte sind vielleicht nicht wie vorher, die Zeilen sagen welche",
            why
        ),
    }
}
