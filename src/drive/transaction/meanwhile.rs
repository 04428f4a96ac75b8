//! What happened between the plan and its first write, such as while a question stood.

use super::plan::{Kept, Plan};
use super::weigh::place;
use crate::drive::Session;
use crate::drive::job::Step;
use crate::drive::stands::{in_ram, stands};
use crate::failure::{Class, Failure};
use crate::outcome::{ErrorDoc, WriteResult, Written};
use crate::profile::DataSets;
use crate::profile::paramfile::value_text;
use crate::text::both;
use std::collections::BTreeMap;

/// Reads once more what the plan was made of: it holds only as long as that stands. Somebody may have changed it while a question
/// stood.
///
/// # Errors
/// Something stands there that was not asked about; its rows say what. Or the drive does not answer.
pub(super) async fn still_stands(session: &mut Session<'_>, plan: &mut Plan) -> Result<(), Failure> {
    let mut failures = Vec::new();
    for group in plan.groups(|row| matches!(row.result, WriteResult::Planned | WriteResult::Unchanged)) {
        let steps: Vec<(usize, Step)> =
            group.into_iter().filter_map(|index| Some((index, plan.job.steps.get(index)?.clone()))).collect();
        let Some(param) = steps.first().map(|(_, step)| step.param.clone()) else { continue };
        let sets: Vec<u8> = steps.iter().map(|(_, step)| step.set).collect();
        let target = &mut plan.job.target;
        let mut now: BTreeMap<u8, i64> = BTreeMap::new();
        for (set, told) in stands(session, target, &param, &sets).await? {
            now.extend(told.ok().map(|raw| (set, raw)));
        }
        now.extend(in_ram(session, target, &param, &sets).await?);
        for (index, step) in &steps {
            let behind: Vec<Kept> = plan.behind(step).cloned().collect();
            let Some(row) = plan.job.rows.get_mut(*index) else { continue };
            failures.extend(changed(row, step, &behind, &now));
        }
    }
    let count = failures.len();
    let Some(first) = failures.into_iter().next() else { return Ok(()) };
    let why = first.message.clone();
    let message = match count {
        1 => why,
        _ => both!(
            "{count} values were changed since they were asked about, the rows say which; {why}",
            "{count} Werte wurden seit der Frage geändert, die Zeilen sagen welche; {why}",
            why
        ),
    };
    Err(Failure { message, ..first })
}

/// What stands at a place or behind it in the RAM, if that is not what was planned with.
fn changed(row: &mut Written, step: &Step, behind: &[Kept], now: &BTreeMap<u8, i64>) -> Option<Failure> {
    let stored = row.old_raw.map(|raw| (step.set, raw));
    let planned = stored.into_iter().chain(behind.iter().map(|kept| (kept.set, kept.raw)));
    let (set, then) = planned.into_iter().find(|(set, raw)| now.get(set) != Some(raw))?;
    // Where all four were told as one, it is one of them now.
    let single = || (set + 1..=set + 4).filter(|_| set.is_multiple_of(5)).filter_map(|set| now.get(&set));
    let found = now.get(&set).or_else(|| single().find(|raw| **raw != then));
    let now = found.map_or_else(|| "?".to_owned(), |raw| value_text(&step.param, *raw));
    let ram = if set >= DataSets::RAM_OFFSET { " (RAM)" } else { "" };
    let message = both!(
        "{label}{ram} was {then} when it was asked about, and is {now} now",
        "{label}{ram} war {then}, als danach gefragt wurde, und ist jetzt {now}",
        label = place(step),
        then = value_text(&step.param, then)
    );
    let failure = Failure::new(Class::Forbidden, "forbidden.changed_meanwhile", message)
        .with("param", step.param.id)
        .hint(both!(
            "somebody else writes it too; the same command again shows what stands there now, and asks again",
            "jemand anders schreibt ihn auch; derselbe Befehl zeigt, was jetzt dort steht, und fragt noch einmal"
        ));
    (row.result, row.error) = (WriteResult::Skipped, Some(ErrorDoc::from(&failure)));
    Some(failure)
}
