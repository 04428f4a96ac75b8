//! What came of a run, as it is reported.

use super::done::{Done, Seen, has_power};
use super::{Plan, nothing_stops_it, verdict};
use crate::drive::motion::{Ended, Motor, Situation, Unseen, coasting, watchdog_words};
use crate::drive::{Target, describe};
use crate::gate::Relief;
use crate::outcome::{Data, Motion, Outcome, State, Stop};
use crate::text::{Text, both};

/// How often a drive that could not be reached for its stop may come back.
const MOST_RETURNS: u8 = 5;
/// How often at most it is looked once more behind what was owed.
const MOST_LOOKS: u8 = 3;

/// What a run leaves: a drive that answers again, and runs, gets its stop as soon as that is seen.
pub(super) async fn aftermath(
    motor: &mut Motor<'_, '_>,
    ended: &mut Ended<()>,
    plan: &Plan<'_>,
) -> (Done, Option<Situation>) {
    let mut after = motor.leave().await;
    for nth in 0..MOST_RETURNS {
        // Who fights for it has been fought with long enough where a stronger stop did not end that.
        let is_again = |stop: &&Stop| nth == 0 && verdict::is_off(stop) && stop.escalated.is_none();
        let Some(stop) = ended.stop.as_ref().filter(|stop| motor.unheard || is_again(stop)) else { break };
        if !after.as_ref().is_some_and(has_power) {
            break;
        }
        if !motor.unheard {
            motor.notes_enabled_again();
        }
        ended.stop = Some(motor.stop_after_all(stop).await);
        after = motor.leave().await;
    }
    let is_on = after.as_ref().is_some_and(has_power);
    let mut standing = match &ended.stop {
        Some(stop) if after.is_none() => stop.standing,
        Some(stop) if stop.standing == Some(true) && !is_on && motor.stays_still() => stop.standing,
        _ if after.is_some() => stands(motor, plan, &mut after).await,
        _ => None,
    };
    let mut is_undone = standing == Some(false) && ended.stop.as_ref().is_some_and(|stop| stop.standing == Some(true));
    let is_relieved = plan.aim.is_some_and(|aim| aim != Relief::Zero) && (!is_on || ended.result.is_ok());
    let mut unseen = match plan.aim {
        Some(_) if standing.is_none() && (motor.shouted || motor.powered) => Some(motor.why_unseen().await),
        _ => None,
    };
    let is_off = is_relieved || ended.stop.as_ref().is_some_and(verdict::is_off);
    // The line is kept for what is owed, so whoever enables in that time is looked for behind it; each look may leave something owed.
    let most = if plan.aim.is_some() { 2 } else { MOST_LOOKS };
    for nth in 0..most {
        // Beside others the time is theirs as well.
        let may_wait = ended.stop.is_some() || (plan.aim.is_some() && !motor.is_beside());
        let is_late = may_wait && (motor.waits_for_what_is_owed().await || (nth == 0 && motor.looked_long_ago()));
        if !is_late && (nth > 0 || (standing == Some(true) && !is_on)) {
            break;
        }
        let heard_at = motor.heard_at();
        if after.is_some() && is_off {
            is_undone |= motor.look_again(&mut after).await;
        } else if after.is_some() && is_late && plan.aim == Some(Relief::Zero) {
            after = motor.leave().await;
            standing = stands(motor, plan, &mut after).await;
        } else {
            break;
        }
        if motor.heard_at() == heard_at {
            // Who does not say that will not say more either.
            break;
        }
    }
    if plan.aim == Some(Relief::Zero)
        && (standing == Some(false) || (standing.is_none() && (motor.is_beside() || after.is_none())))
        && let Some(setpoint) = &mut motor.setpoint
    {
        // Whatever it was before, somebody turns it now, or it is on its way; beside others, or without an answer, it is not known any more.
        setpoint.reached = standing;
    }
    if is_undone {
        // What it had come to is over; of one that was said again nobody has seen what comes of it.
        standing = standing.filter(|stands| !stands);
        if plan.aim.is_some() && !after.as_ref().is_some_and(has_power) {
            unseen.get_or_insert_with(set_going_at_the_end);
        }
        if let Some(stop) = &mut ended.stop {
            (stop.acknowledged, stop.standing) = (false, standing);
        }
    }
    let done = Done {
        standing,
        idle: motor.is_idle(),
        crept: motor.crept().filter(|_| standing.is_none()),
        unseen,
        steps: std::mem::take(&mut motor.steps),
        changed: std::mem::take(&mut motor.changes),
        setpoint: motor.setpoint.take(),
        notes: std::mem::take(&mut motor.notes),
        mode: motor.mode.take().map(|mode| mode.slug),
        instead: motor.instead.take(),
        differs: motor.differs(),
        twins: motor.twins(),
    };
    (done, after)
}

/// Whether the shaft stands now. At a setpoint of 0 that is the proof: without an answer to it nothing is known of the drive; and to one that had
/// come to its standstill, and that somebody else has set going since, it is given once more.
async fn stands(motor: &mut Motor<'_, '_>, plan: &Plan<'_>, after: &mut Option<Situation>) -> Option<bool> {
    let mut stands = motor.stands_at_the_end().await;
    let Some(zero) = plan.setpoint.as_ref().filter(|_| plan.aim == Some(Relief::Zero)) else {
        return stands.ok().flatten();
    };
    let had_stood = motor.setpoint.as_ref().is_some_and(|setpoint| setpoint.reached == Some(true));
    if matches!(stands, Ok(Some(false))) && had_stood {
        motor.zero_again(zero).await;
        *after = motor.leave().await;
        stands = motor.stands_at_the_end().await;
    }
    if stands.is_err() {
        *after = None;
    }
    stands.ok().flatten()
}

pub(super) fn report(plan: &Plan<'_>, target: &Target, seen: Seen, done: Done, ended: Ended<()>) -> Outcome {
    let family = &target.family;
    let state = |situation: &Situation| describe::state(family, situation.status);
    let to = seen.after.as_ref().map(state);
    let running = seen.runs();
    let ended = Ended { stop: ended.stop.map(|stop| in_force(stop, running, to.as_ref())), ..ended };
    let mut notes = done.notes.clone();
    if running == Some(true) {
        notes.push(keeps(plan, seen.after.as_ref(), done.standing));
    }
    let is_said = ended.stop.as_ref().is_some_and(|stop| stop.note.is_some());
    let is_theirs = done.idle && done.standing.is_none();
    let coasts = coasting(done.standing).filter(|_| running == Some(false) && !is_theirs && !is_said);
    notes.extend(coasts);
    let watchdog_s = seen.after.as_ref().or(seen.before.as_ref()).and_then(|seen| seen.watchdog_s);
    let is_off = watchdog_s.is_some_and(|seconds| seconds.raw == 0);
    let held = is_held(seen.after.as_ref(), done.standing);
    if is_off && plan.args.watchdog.is_none() && running != Some(false) && !held {
        notes.push(nothing_stops_it(family, watchdog_s));
    }
    if watchdog_s.is_some_and(|seconds| seconds.raw > 0) || (watchdog_s.is_none() && running == Some(true) && !held) {
        notes.push(watchdog_words(family, watchdog_s));
    }
    let failure = verdict::of(plan, family, &seen, &ended, running, &done);
    // Nothing is told of one drive that may be of another.
    let is_doubled = failure.is_some() && done.is_doubled(plan);
    let unproven = |stop| Stop { acknowledged: false, standing: None, state: None, ..stop };
    let stop = if is_doubled { ended.stop.map(unproven) } else { ended.stop };
    let data = Motion {
        address: target.address,
        drive: family.drive.clone(),
        asked_as: family.drive.clone(),
        action: plan.action.to_owned(),
        mode: done.mode,
        from: seen.before.as_ref().map(state),
        to: to.filter(|_| !is_doubled),
        steps: done.steps,
        setpoint: done.setpoint,
        changed: done.changed,
        watchdog_s,
        stop,
        running: running.filter(|_| !is_doubled),
        standing: done.standing.filter(|_| !is_doubled),
        idle: done.idle,
        notes,
    };
    Outcome { data: Some(Data::Motion(data)), warnings: Vec::new(), failure }
}

/// A stop whose drive has its power again is none any more.
fn in_force(stop: Stop, running: Option<bool>, to: Option<&State>) -> Stop {
    match running {
        Some(true) if verdict::is_off(&stop) => {
            Stop { acknowledged: false, standing: None, state: to.cloned(), note: None, ..stop }
        }
        _ => stop,
    }
}

/// What the drive does that keeps its power.
fn keeps(plan: &Plan<'_>, after: Option<&Situation>, standing: Option<bool>) -> Text {
    match (plan.aim, after.map(|seen| seen.state.as_str())) {
        (Some(Relief::Zero), _) => {
            both!("the drive stays enabled, at a setpoint of 0", "der Antrieb bleibt freigegeben, Sollwert 0")
        }
        _ if is_held(after, standing) => both!(
            "the quick stop holds the shaft at standstill, with power",
            "der Schnellhalt hält die Welle im Stillstand, mit Strom"
        ),
        (_, Some("quick-stop-active")) => {
            both!("the quick stop is under way, with power", "der Schnellhalt läuft noch, mit Strom")
        }
        _ => both!("the drive keeps running", "der Antrieb läuft weiter"),
    }
}

/// A quick stop that has brought the shaft to rest and holds it there.
fn is_held(after: Option<&Situation>, standing: Option<bool>) -> bool {
    after.is_some_and(|seen| seen.state == "quick-stop-active") && standing == Some(true)
}

/// Somebody has set it going in the last moment: it was told to stop once more, and what came of that nobody has seen.
fn set_going_at_the_end() -> Unseen {
    let why = both!(
        "somebody else has set it going at the end of its stop: stop that, and say the stop again",
        "jemand anderes hat ihn am Ende seines Halts in Gang gesetzt: das abstellen, und den Halt noch einmal geben"
    );
    Unseen { why, as_set: false }
}
