//! A slave that is watched: taken, held by the stop word, let go again.

use super::given::SlaveArgs;
use super::mode::held;
use super::open;
use super::spoken::Choice;
use super::taking::{question, whom};
use crate::command::{Context, asking};
use crate::drive::profibus::{Exchange, NOT_STILL, Seen, WATCHDOG, by_words};
use crate::drive::{Chosen, Rounds, Terms};
use crate::failure::Failure;
use crate::outcome::{Outcome, Warning};
use crate::profile::Family;
use crate::text::both;

/// What is watched, how often, and how the slave is taken.
pub(in crate::command) struct Watch<'w> {
    pub(in crate::command) select: &'w dyn Fn(&Family) -> Result<Chosen, Failure>,
    pub(in crate::command) rounds: Rounds,
    pub(in crate::command) terms: Terms<'w>,
    pub(in crate::command) slave: &'w SlaveArgs,
    pub(in crate::command) choice: Choice,
    /// The time of the bench follows the clock.
    pub(in crate::command) is_paced: bool,
}

/// Watches it until the count or the time is over, or somebody ends it.
pub(in crate::command) async fn watch(job: Watch<'_>, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let Watch { select, rounds, terms, slave, choice, is_paced } = job;
    let whom = whom(slave, context)?;
    let address = whom.address;
    whom.knows(choice)?;
    select(&by_words(&whom.presumed, whom.planned(choice)))?;
    if context.settings.dry_run {
        return Ok(held(&whom, choice));
    }
    let why = match whom.planned(choice).further() {
        0 => both!("to watch it; nothing is written", "um sie zu beobachten; geschrieben wird nichts"),
        count => both!(
            "to watch it; P.916 is set for its time so that up to {count} parameters come with every cycle, and given back",
            "um sie zu beobachten; P.916 wird für diese Zeit gesetzt, damit bis zu {count} Parameter mit jedem Zyklus kommen, und \
             zurückgegeben"
        ),
    };
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let permit = asking::off_line(interrupt, *ask, &question(address, &why, choice.spoken)).await?;
    let mut line = open(slave.slot_time, (settings, registry), interrupt, *observe).await?;
    if is_paced {
        line.pace();
    }
    let taking = whom.taking(&mut line, choice, (WATCHDOG, false), &permit).await?;
    let mut exchange = Exchange::new(&mut line, address, taking, &permit);
    let done = async {
        let family = exchange.family(whom.named.clone(), registry).await?;
        let chosen = select(&by_words(&family, exchange.mode()))?;
        let parting = exchange.parting(&family).await?;
        Ok::<_, Failure>((exchange.watch(&family, &terms, rounds, chosen).await, parting))
    };
    let done = done.await;
    let is_by_bus = exchange.seen().is_some_and(Seen::is_by_bus);
    let left = exchange.leave().await;
    let (beside, left) = (left.beside, left.failure);
    // Who is run by its terminals, and was before, was only looked at.
    let (left, by_others) = match left {
        Some(left) if left.code == NOT_STILL && !is_by_bus => (None, Some(left)),
        left => (left, None),
    };
    let (mut outcome, parting) = match done {
        Ok((outcome, parting)) => (Outcome { failure: left.or(outcome.failure), ..outcome }, parting),
        Err(failure) => {
            let warnings = beside.into_iter().collect();
            return Ok(Outcome { data: None, warnings, failure: Some(left.unwrap_or(failure)) });
        }
    };
    outcome.warnings.extend(by_others.map(|left| Warning { code: left.code.to_string(), message: left.told() }));
    outcome.warnings.push(Warning { code: "profibus.let_go".to_owned(), message: parting });
    outcome.warnings.extend(beside);
    Ok(outcome)
}
