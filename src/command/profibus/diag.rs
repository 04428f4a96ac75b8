//! `diag` with PROFIBUS spoken: Slave_Diag, the trip, what a lost master means, and what the LEDs say. Nothing is written: P.616, which
//! fills the trip data or clears them, stays as it is.

use super::given::SlaveArgs;
use super::mode::held;
use super::open;
use super::spoken::Choice;
use super::taking::{question, whom};
use crate::command::{Context, asking};
use crate::drive::profibus::{self, Exchange, Haul, WATCHDOG};
use crate::failure::Failure;
use crate::outcome::{Diagnosis, ErrorDoc, Outcome, SlaveDiagnosis, Value, Warning, Word};
use crate::profile::{Family, Registry};
use crate::text::{Text, both};
use std::rc::Rc;

/// Status word and control right (5.1).
const STATUS: u32 = 968;
const RIGHT: u32 = 928;

/// What was found: the row, why it is not all, and what is to be known besides. A plan where nothing is to be asked.
pub(in crate::command) async fn diag(
    (slave, choice, blank): (&SlaveArgs, Choice, Diagnosis),
    context: &mut Context<'_>,
) -> Result<Result<(Diagnosis, Option<Failure>, Vec<Warning>), Outcome>, Failure> {
    let whom = whom(slave, context)?;
    let address = whom.address;
    whom.knows(choice)?;
    if context.settings.dry_run {
        return Ok(Err(held(&whom, choice)));
    }
    let why = both!("to diagnose it; nothing is written", "um sie zu diagnostizieren; geschrieben wird nichts");
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = asking::off_line(interrupt, *ask, &question(address, &why, choice.spoken)).await?;
    let mut line = open(slave.slot_time, (settings, registry), interrupt, *observe).await?;
    let before = profibus::slave_diag(&mut line, address).await?;
    let taking = whom.taking(&mut line, choice, (WATCHDOG, false), &permit).await?;
    let mut found = SlaveDiagnosis { diagnosis: before, ..SlaveDiagnosis::default() };
    let mut report = Diagnosis { address, drive: whom.presumed.drive.clone(), ..blank };
    let exchange = Exchange::new(&mut line, address, taking, &permit);
    let (failure, warnings) = looks(exchange, (whom.named.clone(), registry), &mut report, &mut found).await;
    report.error =
        failure.as_ref().filter(|_| report.fault_code.is_none() && report.fault.is_none()).map(ErrorDoc::from);
    report.slave = Some(found);
    Ok(Ok((report, failure, warnings)))
}

/// Takes the slave, looks, and lets it go. What went wrong, and what decides on the motor from then on.
async fn looks(
    mut exchange: Exchange<'_, '_>,
    (named, registry): (Option<Rc<Family>>, &Registry),
    report: &mut Diagnosis,
    found: &mut SlaveDiagnosis,
) -> (Option<Failure>, Vec<Warning>) {
    let mut haul = Haul::default();
    let done = async {
        let family = exchange.family(named, registry).await?;
        report.drive.clone_from(&family.drive);
        if exchange.mode().has_pkw() {
            let known = |id: &u32| family.params.contains_key(id);
            for id in [STATUS].into_iter().chain(profibus::LOOKED_AT).filter(known) {
                exchange.value(&family, &(family.param_or_unknown(id), None), &mut haul).await?;
            }
        }
        let diagnosis = exchange.slave_diag().await?;
        if !diagnosis.is_empty() {
            found.diagnosis = diagnosis;
        }
        exchange.parting(&family).await
    };
    let done = done.await;
    let seen = exchange.seen();
    let left = exchange.leave().await;
    let (status, values): (Vec<Value>, _) = haul.values.into_iter().partition(|value| value.param == STATUS);
    let word = status.into_iter().find_map(|value| value.word);
    report.status = word.map(|word| Word { state: seen.and_then(profibus::state), ..word });
    report.missing =
        values.iter().filter(|value| value.param == RIGHT && value.raw != Some(1)).map(|_| no_right()).collect();
    found.leds = seen.map(|seen| profibus::leds(seen, &values)).unwrap_or_default();
    found.values = values;
    report.fault = seen.and_then(profibus::fault);
    report.fault_code = seen.filter(|seen| !seen.is_faulted()).map(|_| 0);
    report.healthy = report.fault_code == Some(0);
    let warnings = left.warnings(done.as_ref().ok().cloned());
    (left.failure.or(done.err()), warnings)
}

pub(super) fn no_right() -> Text {
    both!(
        "P.928 is not 1: the bus has no right to control (--take-control sets it for a run)",
        "P.928 ist nicht 1: der Bus darf nicht steuern (--take-control setzt es für einen Lauf)"
    )
}
