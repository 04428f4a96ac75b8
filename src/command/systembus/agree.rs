//! `systembus check` and `systembus apply`: is a plan in the drives, and put it there.

use super::seated::Options;
use crate::command::Context;
use crate::command::plant::{apply, check};
use crate::drive::plant::Line;
use crate::failure::Failure;
use crate::outcome::{Data, Outcome, Plant, Warning, WriteResult};
use crate::text::both;

/// Holds the drives against the plan.
pub(super) async fn check(options: &Options, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let seated = options.seated(context)?;
    let (wanted, settings) = (seated.listed(context.settings)?, context.settings);
    let file = options.file.display().to_string();
    let hint = both!(
        "`antrieb systembus apply {file}` writes what the plan says",
        "`antrieb systembus apply {file}` schreibt, was der Plan sagt"
    );
    let settle = async |lines: &mut [Line<'_>], _| seated.settled(lines, settings, false).await;
    check::hold(context, wanted, settle, &|_, _| hint.clone()).await
}

/// Writes the plan into all of them, or none.
pub(super) async fn apply(options: &Options, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let seated = options.seated(context)?;
    let (wanted, settings) = (seated.listed(context.settings)?, context.settings);
    let settle = async |lines: &mut [Line<'_>], _| seated.settled(lines, settings, true).await;
    let mut outcome = apply::write(context, wanted, true, settle).await?;
    if let Some(Data::Plant(plant)) = &outcome.data {
        outcome.warnings.extend(in_force(plant));
    }
    Ok(outcome)
}

/// Node and rate (EM-RES-03 manual 5.4, 5.5).
const PLACE: [u32; 2] = [900, 903];

/// When a new place on the bus holds nobody says.
fn in_force(plant: &Plant) -> Option<Warning> {
    let mut rows = plant.drives.iter().flat_map(|drive| &drive.load.values);
    let is_new = rows.any(|row| PLACE.contains(&row.param) && row.result == WriteResult::Verified);
    let message = both!(
        "no source tells when a new node (P.900) and rate (P.903) hold: switch the drives off and on before you rely on them",
        "keine Quelle sagt, ab wann ein neuer Knoten (P.900) und eine neue Rate (P.903) gelten: die Antriebe vorher aus- und wieder \
         einschalten"
    );
    is_new.then(|| Warning { code: "bus.in_force".to_owned(), message })
}
