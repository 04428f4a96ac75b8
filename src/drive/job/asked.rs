//! What is asked before values are written.

use super::{Job, Step, cuts, is_elsewhere};
use crate::drive::{Session, describe, who};
use crate::gate::{Hazard, Question};
use crate::outcome::{Decimal, WriteResult, Written};
use crate::profile::paramfile::ranges;
use crate::profile::value::written;
use crate::profile::{Family, HazardKind, Role, Store};
use crate::text::{Text, both};

/// Reads behind the answer what stands there now: a row tells what it replaces, and that it is not what was shown.
pub async fn look_again(session: &mut Session<'_>, jobs: &mut [Job]) {
    for Job { target, steps, rows } in jobs {
        let shown = |row: &&mut Written| row.result == WriteResult::Planned && row.old_raw.is_some();
        for (step, row) in steps.iter().zip(rows.iter_mut()).filter(|(_, row)| shown(row)) {
            // What does not answer now is told by the write.
            let Ok(now) = target.read_set(session, &step.param, step.set).await else { continue };
            if row.old_raw == Some(now.raw) {
                continue;
            }
            let told = |raw: Option<i64>| raw.map_or_else(String::new, |raw| written(&step.param, raw));
            row.note = Some(both!(
                "it changed while you were asked: {was} -> {now}",
                "er änderte sich während der Frage: {was} -> {now}",
                was = told(row.old_raw),
                now = told(Some(now.raw))
            ));
            row.old = row.old.map(|old| Decimal { raw: now.raw, ..old });
            row.old_raw = Some(now.raw);
        }
    }
}

/// What is to be asked before everything that is left to do, where the drives are reached under the address of this role; `None` if that is nothing.
pub fn question(jobs: &[Job], own: Option<Role>) -> Option<Question> {
    let todo = jobs.iter().flat_map(|job| job.steps.iter().zip(&job.rows).map(move |pair| (job, pair)));
    let todo: Vec<_> = todo.filter(|(_, (_, row))| row.result == WriteResult::Planned).collect();
    if todo.is_empty() {
        return None;
    }
    let mut hazards = vec![Hazard::Write];
    let mut details = Vec::new();
    for (job, (step, _)) in &todo {
        hazards.extend(hazards_of(step, &job.target.family, own));
    }
    for alike in todo.chunk_by(|(_, (_, one)), (_, (_, other))| is_alike(one, other)) {
        let sets = ranges(alike.iter().map(|(_, (_, row))| row.data_set.into())).replace(", ", ",");
        let first = alike.first().map(|(job, (step, row))| describe_step(step, row, &sets, &job.target.family));
        details.extend(first);
    }
    hazards.sort_unstable();
    hazards.dedup();
    if todo.len() > 1 && todo.iter().any(|(job, (step, _))| cuts(&step.param, &job.target.family, own)) {
        let last = both!("what cuts the line at once goes last", "was die Leitung sofort kappt, geht zuletzt hinaus");
        details.push(last);
    }
    details.extend(hazards.iter().filter_map(|hazard| consequence(*hazard)));
    let title = match todo.len() {
        1 => both!("write 1 value", "1 Wert schreiben"),
        count => both!("write {count} values", "{count} Werte schreiben"),
    };
    Some(Question { hazards, title, details })
}

/// How many lines of a question tell the values of a job, before what can happen.
pub fn lines(job: &Job) -> usize {
    let rows: Vec<&Written> = job.rows.iter().filter(|row| row.result == WriteResult::Planned).collect();
    rows.chunk_by(|one, other| is_alike(one, other)).count()
}

/// Whether two rows tell the same of two data sets: they stand in one line then, as in the tables.
fn is_alike(one: &Written, other: &Written) -> bool {
    let what = |row: &Written| (row.address, row.node, row.param, row.store.to_string(), row.old_raw, row.raw);
    what(one) == what(other) && one.data_set > 0 && other.data_set > 0
}

fn hazards_of(step: &Step, family: &Family, own: Option<Role>) -> Vec<Hazard> {
    let (_, store) = describe::place(step.set);
    let mut hazards = Vec::new();
    if store == Store::Eeprom && !step.param.is_volatile() && family.link.route.has_data_sets() {
        hazards.push(Hazard::Wear);
    }
    let is_here = |hazard: &HazardKind| *hazard != HazardKind::Line || !is_elsewhere(&step.param, family, own);
    hazards.extend(step.param.hazard.filter(is_here).map(|hazard| match hazard {
        HazardKind::Motion => Hazard::Motion,
        HazardKind::Line => Hazard::Line,
        HazardKind::Reset => Hazard::Reset,
    }));
    hazards
}

fn consequence(hazard: Hazard) -> Option<Text> {
    Some(match hazard {
        Hazard::Write | Hazard::Counters => return None,
        Hazard::Wear => both!(
            "EEPROM: each of these writes wears it a little; @ram does not",
            "EEPROM: jedes Schreiben nutzt es etwas ab; @ram nicht"
        ),
        Hazard::Motion => both!(
            "MOTION: this can start the shaft or change how it turns",
            "BEWEGUNG: das kann die Welle anlaufen lassen oder ihre Drehung ändern"
        ),
        Hazard::Line => both!(
            "LINE: this can cut the line to the drive; the old setting is shown above",
            "LEITUNG: das kann die Verbindung zum Antrieb kappen; die alte Einstellung steht oben"
        ),
        Hazard::Reset => both!(
            "RESET: the drive restarts or its faults are reset",
            "RESET: der Antrieb startet neu oder seine Störungen werden quittiert"
        ),
    })
}

fn describe_step(step: &Step, row: &Written, sets: &str, family: &Family) -> Text {
    let (old, new, unit) = describe::change(row);
    let old = old.unwrap_or_else(|| "?".to_owned());
    let text = row.text.as_ref().map_or_else(Text::default, |text| both!(" ({text})", " ({text})", text));
    let who = match row.address {
        0 => both!("every drive", "alle Antriebe"),
        address => who(address, row.node, &row.drive),
    };
    let (label, store) = match family.link.route.has_data_sets() {
        true => (format!("P.{}@{sets}", row.param), format!(", {}", row.store)),
        false => {
            let element = row.index.map_or_else(String::new, |index| format!(".{index}"));
            (step.param.label() + &element, String::new())
        }
    };
    both!(
        "{who}: {label} {name}: {old} -> {new}{unit}{text}{store}",
        "{who}: {label} {name}: {old} -> {new}{unit}{text}{store}",
        who,
        name = step.param.name,
        unit,
        text
    )
}
