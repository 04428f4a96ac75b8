//! The state of one inverter, as its status word tells it.

use super::given::SlaveArgs;
use super::open;
use super::taking::{question, whom};
use crate::command::{Context, asking};
use crate::drive::profibus::{self, Course, Haul};
use crate::failure::Failure;
use crate::outcome::{Data, Outcome, Plan, StateReport, Statemachine, Warning};
use crate::text::{Text, both};

/// Who may control (5.1), and the status word (5.1).
const RIGHT: u32 = 928;
const STATUS: u32 = 968;
/// Fault (4.1.2.2); which, no word tells.
const FAULT: u16 = 1 << 3;
/// Control from the bus is allowed.
const ALLOWED: i64 = 1;

/// Shows it.
pub(in crate::command) async fn show(slave: &SlaveArgs, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let whom = whom(slave, context)?;
    let address = whom.address;
    if context.settings.dry_run {
        let telegrams = profibus::words(Course::Stop(false));
        let telegrams = telegrams.into_iter().map(|words| profibus::cyclic(address, words, &whom.presumed)).collect();
        let notes = vec![both!(
            "station {address} is taken (Set_Prm, PPO1), held by the stop word, asked, and let go",
            "Station {address} wird übernommen (Set_Prm, PPO1), mit dem Stoppwort gehalten, gefragt und freigegeben"
        )];
        return Ok(Outcome::of(Data::Plan(Plan { dry_run: true, telegrams, notes })));
    }
    let why = both!("to see its state; nothing is written", "um ihren Zustand zu sehen; geschrieben wird nichts");
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = asking::off_line(interrupt, *ask, &question(address, &why)).await?;
    let mut line = open(slave.slot_time, (settings, registry), interrupt, *observe).await?;
    let mut exchange = whom.exchange(&mut line, &permit);
    let (mut haul, mut family) = (Haul::default(), whom.presumed.clone());
    let done = async {
        family = exchange.family(whom.named.clone(), registry).await?;
        for id in [STATUS, RIGHT] {
            exchange.value(&family, &(family.param_or_unknown(id), None), &mut haul).await?;
        }
        exchange.parting(&family).await
    };
    let done = done.await;
    let seen = exchange.seen();
    let left = exchange.leave().await.failure;
    let mut values = haul.values.into_iter();
    let (status, right) = (values.next(), values.next());
    let missing = right.as_ref().is_some_and(|right| right.raw != Some(ALLOWED)).then(no_right);
    let report = StateReport {
        address,
        drive: family.drive.clone(),
        state: seen.map(|seen| profibus::state(seen.zsw)),
        status: status.and_then(|status| status.word),
        control: None,
        control_mode: right,
        control_mode_stored: None,
        fault_code: seen.filter(|seen| seen.zsw & FAULT == 0).map(|_| 0),
        fault: None,
        missing: missing.into_iter().collect(),
        states: Vec::new(),
        error: None,
    };
    let warning = done.as_ref().ok().cloned();
    let warnings = warning.map(|message| Warning { code: "profibus.let_go".to_owned(), message }).into_iter().collect();
    let failure = left.or(done.err()).or_else(|| haul.failures.into_iter().next());
    Ok(Outcome { data: Some(Data::Statemachine(Statemachine { drives: vec![report] })), warnings, failure })
}

fn no_right() -> Text {
    both!(
        "P.928 is not 1: the bus has no right to control (--take-control sets it for a run)",
        "P.928 ist nicht 1: der Bus darf nicht steuern (--take-control setzt es für einen Lauf)"
    )
}
