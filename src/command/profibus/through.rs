//! Work of a verb that talks to drives on any line, on a slave of PROFIBUS: it is taken, kept going as long as the work lasts, asked by its
//! PKW block, held by the stop word, and let go.

use super::given::SlaveArgs;
use super::open;
use super::spoken::Spoken;
use super::taking::{question, whom};
use crate::args::Settings;
use crate::command::{Context, asking};
use crate::drive::Port;
use crate::failure::{Class, Failure};
use crate::outcome::{Event, Outcome, Warning};
use crate::text::Text;
use std::cell::RefCell;

/// What depends on values is no plan without a slave, and some of it asks for a port at once.
const UNPLANNED: &str = "usage.dry_run";

/// Does the work over the slave that the settings name. What is wrong with it without a slave is told before one is taken.
pub(in crate::command) async fn through(
    (slave, why): (&SlaveArgs, &Text),
    context: &mut Context<'_>,
    work: impl AsyncFn(&mut Context<'_>) -> Result<Outcome, Failure>,
) -> Result<Outcome, Failure> {
    let whom = whom(slave, context)?;
    whom.with_pkw()?;
    let Context { settings, registry, ask, observe, interrupt, sheet, .. } = context;
    let (registry, sheet) = (*registry, *sheet);
    let offline = settings.through_slave(None, &whom.presumed.drive);
    let planned = {
        let mut nobody = |_| {};
        let observe: &mut dyn FnMut(Event) = if settings.dry_run { *observe } else { &mut nobody };
        let settings = Settings { dry_run: true, ..offline };
        let interrupt = interrupt.clone();
        work(&mut Context { settings: &settings, registry, ask: *ask, observe, interrupt, sheet, calls: None }).await
    };
    let is_wrong = |failure: &Failure| failure.code != UNPLANNED && failure.class != Class::Port;
    if settings.dry_run || planned.as_ref().is_err_and(is_wrong) {
        return planned;
    }
    let permit = asking::off_line(interrupt, *ask, &question(whom.address, why, Some(Spoken::Profidrive))).await?;
    let observe = RefCell::new(&mut **observe);
    let (mut of_line, mut of_work) =
        (|event: Event| (*observe.borrow_mut())(event), |event: Event| (*observe.borrow_mut())(event));
    let mut line = open(slave.slot_time, (settings, registry), interrupt, &mut of_line).await?;
    let mut exchange = whom.exchange(&mut line, &permit)?;
    let (mut parting, mut lost) = (None, None);
    let done = match exchange.family(whom.named.clone(), registry).await {
        Err(failure) => Err(failure),
        Ok(family) => {
            let mailbox = exchange.mailbox();
            let settings = settings.through_slave(Some(Port::Beside(mailbox.clone())), &family.drive);
            let interrupt = interrupt.clone();
            let observe: &mut dyn FnMut(Event) = &mut of_work;
            let mut inner =
                Context { settings: &settings, registry, ask: *ask, observe, interrupt, sheet, calls: None };
            let (done, why) = exchange.serve(&mailbox, work(&mut inner)).await;
            lost = why;
            if lost.is_none() {
                parting = exchange.parting(&family).await.ok();
            }
            done
        }
    };
    let left = exchange.leave().await;
    let (parting, left) = (left.warnings(parting), left.failure);
    // The work knows only that the slave is gone; why, and what to do, is told by who kept it going.
    let true_one = |failure: Failure| {
        lost.clone().filter(|_| failure.is_gone() && failure.class != Class::Partial).unwrap_or(failure)
    };
    let Outcome { data, mut warnings, failure } = match done {
        Ok(outcome) => outcome,
        Err(failure) => Outcome::from(true_one(failure)),
    };
    warnings.extend(parting);
    let failure = match (left, failure.map(true_one)) {
        // What was left half done in the inverter is worse than the silence of its module.
        (Some(left), Some(torn)) if torn.class == Class::Partial => {
            warnings.push(Warning { code: left.code.clone(), message: left.told() });
            Some(Failure { alarm: torn.alarm || left.alarm, ..torn })
        }
        (left, failure) => left.or(failure),
    };
    Ok(Outcome { data, warnings, failure })
}
