//! The state of one inverter, as its status word tells it.

use super::diag::no_right;
use super::given::SlaveArgs;
use super::mode::held;
use super::open;
use super::spoken::Choice;
use super::taking::{question, whom};
use crate::command::{Context, asking};
use crate::drive::profibus::{self, Exchange, Haul, WATCHDOG};
use crate::failure::Failure;
use crate::outcome::{Data, Outcome, StateReport, Statemachine};
use crate::text::both;

/// Who may control (5.1), and the status word (5.1).
const RIGHT: u32 = 928;
const STATUS: u32 = 968;
/// Control from the bus is allowed.
const ALLOWED: i64 = 1;

/// Shows it.
pub(in crate::command) async fn show(
    slave: &SlaveArgs,
    choice: Choice,
    context: &mut Context<'_>,
) -> Result<Outcome, Failure> {
    let whom = whom(slave, context)?;
    let address = whom.address;
    whom.knows(choice)?;
    if context.settings.dry_run {
        return Ok(held(&whom, choice));
    }
    let why = both!("to see its state; nothing is written", "um ihren Zustand zu sehen; geschrieben wird nichts");
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = asking::off_line(interrupt, *ask, &question(address, &why, choice.spoken)).await?;
    let mut line = open(slave.slot_time, (settings, registry), interrupt, *observe).await?;
    let taking = whom.taking(&mut line, choice, (WATCHDOG, false), &permit).await?;
    let has_pkw = taking.mode.has_pkw();
    let mut exchange = Exchange::new(&mut line, address, taking, &permit);
    let (mut haul, mut family) = (Haul::default(), whom.presumed.clone());
    let done = async {
        family = exchange.family(whom.named.clone(), registry).await?;
        for id in [STATUS, RIGHT].into_iter().filter(|_| has_pkw) {
            exchange.value(&family, &(family.param_or_unknown(id), None), &mut haul).await?;
        }
        exchange.parting(&family).await
    };
    let done = done.await;
    let seen = exchange.seen();
    let left = exchange.leave().await;
    let mut values = haul.values.into_iter();
    let (status, right) = (values.next(), values.next());
    let missing = right.as_ref().is_some_and(|right| right.raw != Some(ALLOWED)).then(no_right);
    let report = StateReport {
        address,
        drive: family.drive.clone(),
        state: seen.and_then(profibus::state),
        status: status.and_then(|status| status.word),
        control: None,
        control_mode: right,
        control_mode_stored: None,
        fault_code: seen.filter(|seen| !seen.is_faulted()).map(|_| 0),
        fault: seen.and_then(profibus::fault),
        missing: missing.into_iter().collect(),
        states: Vec::new(),
        error: None,
    };
    let warnings = left.warnings(done.as_ref().ok().cloned());
    let failure = left.failure.or(done.err()).or_else(|| haul.failures.into_iter().next());
    Ok(Outcome { data: Some(Data::Statemachine(Statemachine { drives: vec![report] })), warnings, failure })
}
