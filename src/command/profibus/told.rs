//! What came of a run over PROFIBUS, as it is reported, and what is shown of it meanwhile.

use super::job::{Action, Job};
use crate::command::running::{interrupted, kept_back, with_its_stop};
use crate::drive::EndedBy;
use crate::drive::profibus::{Ending, Run, Seen, Wanted, coasting, off, state};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Decimal, Motion, Outcome, Setpoint, Stop};
use crate::profile::Family;
use crate::text::Text;

/// What was told before, and what a run came to.
#[derive(Debug, Default)]
pub(super) struct Told {
    /// What decides on the motor once the slave is let go.
    pub(super) parting: Option<Text>,
    pub(super) from: Option<Seen>,
    pub(super) run: Run,
    /// The keypad ended it.
    pub(super) by: Option<EndedBy>,
}

/// The setpoint word (5.2), and the setpoint in Hz (5.3), which is what the Basic block sends.
const HSW: u32 = 700;
const SETPOINT: u32 = 611;

pub(super) fn report(
    (job, choice): (&Job<'_>, &'static str),
    (address, family): (u8, &Family),
    told: Told,
    done: Result<(), Failure>,
    ending: Ending,
) -> Outcome {
    // Who interrupts the end of a run has interrupted it.
    let done = if ending.hastened { done.and_then(|()| Err(interrupted())) } else { done };
    let (is_run, has_turned) = (matches!(job.action, Action::Run(_)), ending.has_turned);
    let Ending { is_dark, standing, coasted, changed, seen, is_lost, notes, parting, beside, failure: left, .. } =
        ending;
    // What it does now nobody knows whom it does not answer any more.
    let now = seen.filter(|_| !is_lost);
    let because = match &done {
        Ok(()) if told.by == Some(EndedBy::Key) => "key",
        Ok(()) if told.by.is_some() => "dead-man",
        Ok(()) => "end",
        Err(failure) if failure.class == Class::Interrupted => "interrupted",
        Err(_) => "error",
    };
    let stop = Stop {
        choice,
        escalated: (coasted && choice != "coast").then_some("coast"),
        because,
        acknowledged: is_dark,
        standing,
        state: now.and_then(state),
        note: (is_dark && has_turned && standing.is_none()).then(off),
    };
    let done = done.map_err(|why| if told.run.setpoints > 0 { with_its_stop(why, &stop, !has_turned) } else { why });
    let is_unproven = is_dark && has_turned && choice == "ramp" && standing != Some(true);
    let mut failure = match (left, done.err()) {
        (Some(left), Some(why)) if left.code != why.code => Some(together(left, &why)),
        (left, done) => left.or(done),
    };
    failure = match failure {
        None if is_unproven => Some(coasting(address)),
        // Nothing stops a shaft without power, but whoever stands beside it must know.
        Some(failure) if is_unproven => Some(Failure { alarm: true, ..failure }),
        failure => failure,
    };
    if job.is_stop() && seen.is_none() {
        failure = failure.map(kept_back);
    }
    let data = Motion {
        address,
        drive: family.drive.clone(),
        asked_as: family.drive.clone(),
        action: job.word.to_owned(),
        mode: is_run.then(|| "frequency".to_owned()),
        from: told.from.and_then(state),
        to: now.and_then(state),
        steps: told.run.steps.clone(),
        setpoint: setpoint(job, &told.run, seen)
            .map(|told| Setpoint { actual: told.actual.filter(|_| !is_lost), ..told }),
        changed,
        watchdog_s: None,
        stop: Some(stop),
        // What never was started, and was never seen to turn, does not run by what a line that went dead left open.
        running: now.map(|_| !is_dark).filter(|running| !running || has_turned || told.run.reached.is_some()),
        standing,
        idle: !has_turned,
        notes: parting.or(told.parting).into_iter().chain(notes).collect(),
    };
    Outcome { data: Some(Data::Motion(data)), warnings: beside.into_iter().collect(), failure }
}

/// What is left of it decides, unless somebody interrupted: that is what came of the run then.
fn together(left: Failure, why: &Failure) -> Failure {
    let (first, then) = if why.class == Class::Interrupted { (why, &left) } else { (&left, why) };
    let message = Text::join([&first.message, &then.said()], "; ");
    let (alarm, hint) = (left.alarm || why.alarm, left.hint.clone().or_else(|| why.hint.clone()));
    Failure { alarm, message, hint, ..first.clone() }
}

fn setpoint(job: &Job<'_>, run: &Run, seen: Option<Seen>) -> Option<Setpoint> {
    let Action::Run(wanted) = job.action else { return None };
    run.reached?;
    let full = match wanted {
        Wanted::Hertz(_) => run.maximum,
        Wanted::Percent(_) => Some(10_000),
    };
    let raw = run.given.unwrap_or(wanted.value());
    // 4000h is 100 % of A004.
    let actual = run.actual.zip(full).map(|(hiw, full)| i64::from(hiw) * full / 0x4000);
    Some(Setpoint {
        param: if seen.is_some_and(|seen| seen.state.is_some()) { SETPOINT } else { HSW },
        value: Decimal { raw, decimals: 2 },
        denominator: None,
        effective: None,
        unit: wanted.unit().to_owned(),
        writes: run.setpoints,
        reached: run.reached,
        actual: actual.map(|raw| Decimal { raw, decimals: 2 }),
    })
}
