//! A plant: what its project file (`antrieb.toml`) says that its drives shall have, over all ports at once.

pub mod apply;
pub mod check;
pub mod init;
pub(in crate::command) mod lines;
pub mod plan;
mod told;

use super::Context;
use super::dataset::loaded::{blank, describe_steps, forbidden, would_be_in_the_way};
use crate::drive::Upper;
use crate::drive::plant::Line;
use crate::drive::transaction::fits;
use crate::failure::{Class, Failure};
use crate::outcome::{Data, ErrorDoc, Outcome, Plant, PlantDrive, PlantState};
use crate::text::{Text, both};
use futures_util::future::join_all;
use lines::{Said, Wanted};

/// What would be sent to each drive, without opening anything.
fn dry_run(context: &Context<'_>, wanted: &[Wanted]) -> Result<Outcome, Failure> {
    let (mut drives, mut failures) = (Vec::new(), Vec::new());
    for one in wanted {
        let family = &one.opened.family;
        let mut load = blank(one.place.address, &family.drive, one.files(), one.left_out.clone());
        load.node = one.place.settings.node;
        let terms = lines::terms(&one.place.settings, context.registry)?;
        let failure = would_be_in_the_way(describe_steps(&terms, &mut load, family, &one.steps, fits));
        let state = if failure.is_some() { PlantState::Skipped } else { PlantState::Planned };
        let (called, port, error) = (one.place.name.clone(), one.port(), failure.as_ref().map(ErrorDoc::from));
        failures.extend(failure.map(|failure| (called.clone(), failure)));
        drives.push(PlantDrive { called, port, state, load, error });
    }
    let failure = told::summary(failures, drives.len(), (false, told::LEFT_OUT));
    let mut outcome = Outcome::of(Data::Plant(Plant { project: project(wanted), dry_run: true, drives }));
    (outcome.warnings, outcome.failure) = (vec![super::write::dry_run_reads()], failure);
    Ok(outcome)
}

/// Refuses a choice that leaves nothing of any file: nothing would be as it was wanted, so that is no success.
fn must_choose(wanted: &[Wanted]) -> Result<(), Failure> {
    if wanted.iter().any(|one| !one.steps.is_empty()) {
        return Ok(());
    }
    let message = both!(
        "nothing is left to write: none of the values of the files was asked for",
        "es bleibt nichts zu schreiben: keiner der Werte der Dateien war verlangt"
    );
    Err(Failure::new(Class::No, "no.values", message).hint(both!(
        "--only, --except and --sets pick what is written; settings of a bus only if --only names them",
        "--only, --except und --sets wählen aus, was geschrieben wird; Einstellungen eines Busses nur, wenn --only sie nennt"
    )))
}

/// Looks at every drive, the lines side by side, and leaves out those that may not be written to now.
async fn look(lines: &mut [Line<'_>], upper: Upper, so: &Text) {
    join_all(lines.iter_mut().map(|line| line.look(upper))).await;
    for member in lines.iter_mut().flat_map(|line| &mut line.members) {
        if let Some(failure) = member.found.as_mut().and_then(|found| forbidden(&mut found.plan, so)) {
            member.leave(failure);
        }
    }
}

/// The project file, or the plan of a bus, as it is told, if one says all of it.
fn project(wanted: &[Wanted]) -> Option<String> {
    match &wanted.first()?.said {
        Said::Project(path) | Said::Plan(path) => Some(path.clone()),
        Said::Typed => None,
    }
}
