//! Whether a run ended as it was promised, and what its end is called if it did not.

use super::Plan;
use super::done::{Done, Seen};
use crate::drive::motion::{Ended, Situation, has_power, tripped, what_stops_it};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Change, Setpoint, Stop};
use crate::profile::Family;
use crate::text::{Text, both};

/// A shaft that nobody saw standing may coast.
pub(super) const STANDSTILL_UNPROVEN: &str = "forbidden.standstill_unproven";
/// Nor may one that was seen to.
const STILL_COASTING: &str = "forbidden.still_coasting";

/// The failure of a run; `None` only if the final state is the one that was promised.
pub(super) fn of(
    plan: &Plan<'_>,
    family: &Family,
    seen: &Seen,
    ended: &Ended<()>,
    running: Option<bool>,
    done: &Done,
) -> Option<Failure> {
    let failure = match (ended.result.as_ref().err().cloned(), &ended.stop) {
        (Some(failure), Some(stop)) => {
            let failure = told_whole(failure, fault(plan, seen).map(|code| tripped(family, code)));
            Some(stopped(failure, stop, running, family, done))
        }
        // A stop that nobody saw come to anything.
        (Some(failure), None) if plan.aim.is_some() && running != Some(false) && tells_nothing(&failure) => {
            Some(dangerous(failure, family))
        }
        (Some(failure), None) => Some(failure),
        (None, Some(stop)) if stop.because == "interrupted" => {
            Some(stopped(interrupted(), stop, running, family, done))
        }
        (None, Some(stop)) if is_unproven(stop) => Some(match fault(plan, seen) {
            Some(code) => stopped(tripped(family, code), stop, running, family, done),
            None => unproven(stop, family, done),
        }),
        (None, _) => broken_promise(plan, family, seen, running, done.standing)
            .or_else(|| other_stop(done))
            .or_else(|| unseen_relief(plan, done))
            .or_else(|| still_coasting(plan, done))
            .or_else(|| not_standing(plan, family, running, done.setpoint.as_ref()))
            .or_else(|| not_given_back(plan, &done.changed)),
    };
    let failure = failure.map(|failure| told_of_its_coast(failure, plan, ended, done));
    let failure = failure.or_else(|| done.twins.clone());
    // Of two drives only one was told of, whichever it was.
    if done.is_doubled(plan) { failure.map(|failure| dangerous(failure, family)) } else { failure }
}

/// Who did not wait for the end of a stop learns what the shaft does all the same.
fn told_of_its_coast(failure: Failure, plan: &Plan<'_>, ended: &Ended<()>, done: &Done) -> Failure {
    let must_rest = matches!(plan.aim, Some(act) if act != Relief::Zero);
    if failure.class != Class::Interrupted || failure.alarm || !must_rest || done.standing != Some(false) {
        return failure;
    }
    // What came of a stop tells it already.
    let message = match ended.stop {
        Some(_) => failure.message.clone(),
        None => both!("{why}; {coasts}", "{why}; {coasts}", why = failure.message, coasts = coasting()),
    };
    warned(Failure { message, ..failure })
}

/// Somebody who interrupts has waited for no answer; and behind a line that failed, the drive may say that it tripped.
fn told_whole(failure: Failure, trip: Option<Failure>) -> Failure {
    let mut failure = failure;
    match trip {
        _ if failure.class == Class::Interrupted => failure.message = both!("interrupted", "unterbrochen"),
        Some(trip) if tells_nothing(&failure) => {
            failure.message = both!("{why}; {trip}", "{why}; {trip}", why = failure.message, trip = trip.message);
        }
        _ => {}
    }
    failure
}

/// Whether a stop is not the one that was promised: a ramp or a quick stop ends at standstill, whoever was in a hurry, and
/// whoever turned the shaft before.
fn is_unproven(stop: &Stop) -> bool {
    let ends_still = !["coast", "keep"].contains(&stop.choice);
    stop.choice != "keep" && (!stop.acknowledged || (ends_still && stop.standing != Some(true)))
}

/// Whether it leaves open what the drive does: the line is the reason, or the drive refuses to be asked or told.
fn tells_nothing(failure: &Failure) -> bool {
    matches!(failure.class, Class::Silence | Class::Garbled | Class::Port | Class::Interrupted | Class::Refused)
}

/// A run that went wrong, and what its stop did.
fn stopped(failure: Failure, stop: &Stop, running: Option<bool>, family: &Family, done: &Done) -> Failure {
    let mut failure = failure;
    if stop.choice == "keep" {
        failure.message = both!(
            "{why}; keep: no stop was sent, as asked for",
            "{why}; keep: es wurde kein Halt gesendet, wie verlangt",
            why = failure.message
        );
        return if failure.class == Class::Port { dangerous(failure, family) } else { failure };
    }
    let runs_on = stop.acknowledged && running == Some(true);
    failure = with_its_stop(failure, stop, done.idle);
    if runs_on {
        let again = still_running(family);
        failure.message = both!("{why}; {again}", "{why}; {again}", why = failure.message, again = again.message);
        return dangerous(hinted(failure, [again.hint.map(|hint| *hint)]), family);
    }
    if stop.acknowledged && stop.standing == Some(true) {
        return failure;
    }
    let is_over = stop.acknowledged || is_off(stop) || running == Some(false);
    let failure = hinted(failure, [stop.note.clone()]);
    match is_over {
        // A shaft that does not become slower has power, whatever the state says.
        true if failure.code == "forbidden.still_turning" => dangerous(failure, family),
        false => dangerous(failure, family),
        // Nothing stops a shaft without power, but whoever stands beside it must know.
        true if is_unproven(stop) && !done.idle && done.crept.is_none() => warned(failure),
        true => failure,
    }
}

/// What ended a run, and what came of its stop.
pub(in crate::command) fn with_its_stop(failure: Failure, stop: &Stop, idle: bool) -> Failure {
    let way = stop.escalated.map_or_else(|| stop.choice.to_owned(), |by| format!("{} -> {by}", stop.choice));
    let message =
        both!("{why}; {way}: {came}", "{why}; {way}: {came}", why = failure.message, came = came_of(stop, idle));
    Failure { message, ..failure }
}

/// What came of a stop, so that nobody takes a shaft without power for one that stands.
fn came_of(stop: &Stop, idle: bool) -> Text {
    match (stop.acknowledged, stop.standing) {
        (_, Some(false)) if is_off(stop) => {
            both!("without power, but the shaft still turns", "ohne Strom, aber die Welle dreht noch")
        }
        (_, None) if is_off(stop) && !idle => {
            both!("without power; whether the shaft stands is not told", "ohne Strom; ob die Welle steht, zeigt nichts")
        }
        (true, _) => both!("the stop was acknowledged", "der Halt wurde bestätigt"),
        (false, _) => both!("the stop was NOT acknowledged", "der Halt wurde NICHT bestätigt"),
    }
}

pub(super) fn is_off(stop: &Stop) -> bool {
    stop.state.as_ref().is_some_and(|state| has_power(&state.slug) == Some(false))
}

/// The danger first, and what ends it; why it came to that is for later.
fn dangerous(failure: Failure, family: &Family) -> Failure {
    if failure.alarm {
        return failure;
    }
    hinted(warned(failure), [Some(what_stops_it(Some(family)))])
}

/// The danger first.
pub(super) fn warned(failure: Failure) -> Failure {
    Failure { alarm: true, ..failure }
}

/// A failure with hints before the one that it has.
fn hinted<const N: usize>(failure: Failure, hints: [Option<Text>; N]) -> Failure {
    let mut failure = failure;
    let last = failure.hint.take().map(|hint| *hint).filter(|hint| !hint.is_empty());
    let hints: Vec<_> = hints.into_iter().flatten().chain(last).collect();
    if hints.is_empty() { failure } else { failure.hint(Text::join(&hints, "; ")) }
}

/// The end came as it was to come, but not the stop.
fn unproven(stop: &Stop, family: &Family, done: &Done) -> Failure {
    if is_off(stop) && stop.standing.is_none() {
        let failure = hinted(unseen(stop.note.clone()), [done.instead.clone()]);
        // What nobody gave power here turns by itself, if at all, and what crept as its power went hardly turns.
        return if done.idle || done.crept.is_some() { failure } else { warned(failure) };
    }
    let text = match is_off(stop) {
        true => came_of(stop, false),
        false => both!("the stop at the end was NOT acknowledged", "der Halt am Ende wurde NICHT bestätigt"),
    };
    let (class, code) = match stop.state {
        Some(_) => (Class::Forbidden, "forbidden.not_stopped"),
        None => (Class::Silence, "silence.stop"),
    };
    let failure = hinted(Failure::new(class, code, text), [stop.note.clone()]);
    // Who coasts is stopped by nothing of that.
    if is_off(stop) { warned(failure) } else { dangerous(failure, family) }
}

/// A stop that took the power away, and nothing showed the shaft at standstill.
fn unseen(why: Option<Text>) -> Failure {
    let text = both!(
        "the drive is without power, but nothing showed that the shaft stands",
        "der Antrieb ist ohne Strom, aber nichts zeigte, dass die Welle steht",
    );
    hinted(Failure::new(Class::Forbidden, STANDSTILL_UNPROVEN, text), [why])
}

/// A drive that was to stop, and was not seen to stand: its first look came behind the stop, so that it may have been turning
/// even where that showed no power any more. What is set to coast may do so.
fn unseen_relief(plan: &Plan<'_>, done: &Done) -> Option<Failure> {
    let seen = done.unseen.as_ref()?;
    let failure = match plan.aim? {
        Relief::QuickStop | Relief::Disable if done.crept.is_some() => {
            return Some(hinted(unseen(Some(seen.why.clone())), [done.crept.clone()]));
        }
        Relief::QuickStop => unseen(Some(seen.why.clone())),
        Relief::Disable if !seen.as_set => unseen(Some(seen.why.clone())),
        Relief::Zero if done.setpoint.as_ref()?.reached.is_none() => {
            let text = both!(
                "the setpoint is 0, but nothing showed that the shaft stands",
                "der Sollwert ist 0, aber nichts zeigte, dass die Welle steht",
            );
            let why = both!("it lost its power on the way", "er hat unterwegs seinen Strom verloren");
            Failure::new(Class::Forbidden, STANDSTILL_UNPROVEN, text).hint(why)
        }
        _ => return None,
    };
    Some(warned(failure))
}

/// The drive is stopped, but not in the way that was asked for.
fn other_stop(done: &Done) -> Option<Failure> {
    let failure = Failure::new(Class::Forbidden, "forbidden.other_stop", done.instead.clone()?);
    Some(if done.standing == Some(true) { failure } else { warned(failure) })
}

/// Nothing went wrong on the way; is the drive where it was to be?
fn broken_promise(
    plan: &Plan<'_>,
    family: &Family,
    seen: &Seen,
    running: Option<bool>,
    standing: Option<bool>,
) -> Option<Failure> {
    if seen.after.is_none() {
        return Some(dangerous(unknown(), family));
    }
    if let Some(code) = fault(plan, seen) {
        return Some(tripped(family, code));
    }
    let must_stand = plan.args.ends_in_a_stop();
    let must_stop = matches!(plan.aim, Some(act) if act != Relief::Zero);
    // A run that was to end must have ended, whatever was acknowledged on the way.
    let turns_on = ((must_stand || must_stop) && running != Some(false)).then(|| still_running(family));
    turns_on.map(|failure| if standing == Some(true) { failure } else { warned(failure) }).or_else(|| {
        let must_run = plan.runs && !must_stand;
        (must_run && running == Some(false)).then(|| {
            let text = both!("the drive does not run any more", "der Antrieb läuft nicht mehr");
            Failure::new(Class::Forbidden, "forbidden.not_running", text)
        })
    })
}

/// The fault in which the run ended; a stop of a drive that had tripped before may leave it so.
fn fault(plan: &Plan<'_>, seen: &Seen) -> Option<u32> {
    let tripped = |situation: &&Situation| situation.state.starts_with("fault");
    let had = seen.before.as_ref().or(seen.first.as_ref()).filter(tripped).is_some() && plan.aim.is_some();
    let after = seen.after.as_ref().filter(tripped).filter(|_| !had)?;
    Some(after.fault.unwrap_or(0) as u32)
}

/// A drive that was to come to rest, and whose shaft turns without power: somebody else had enabled it meanwhile.
fn still_coasting(plan: &Plan<'_>, done: &Done) -> Option<Failure> {
    let must_rest = matches!(plan.aim?, Relief::QuickStop | Relief::Disable) && done.standing == Some(false);
    must_rest.then(|| warned(Failure::new(Class::Forbidden, STILL_COASTING, coasting())))
}

fn coasting() -> Text {
    both!(
        "the drive is without power, but the shaft still turns",
        "der Antrieb ist ohne Strom, aber die Welle dreht noch"
    )
}

/// A setpoint of zero at which the shaft turns on.
fn not_standing(
    plan: &Plan<'_>,
    family: &Family,
    running: Option<bool>,
    setpoint: Option<&Setpoint>,
) -> Option<Failure> {
    let setpoint = setpoint?;
    let is_lifted = setpoint.effective.is_some_and(|makes| makes.raw != 0) && running == Some(true);
    let turns = match plan.aim {
        Some(aim) => aim == Relief::Zero && setpoint.reached == Some(false),
        None => setpoint.value.raw == 0 && is_lifted && !plan.runs && !plan.args.hold,
    };
    turns.then(|| {
        let text =
            both!("the setpoint is 0, but the shaft turns on", "der Sollwert ist 0, aber die Welle dreht weiter");
        warned(Failure::new(Class::No, "no.not_standing", text)).hint(both!(
            "{stops}; {why}",
            "{stops}; {why}",
            stops = how_to_stop(family),
            why = family.motion.not_reached
        ))
    })
}

/// What a run changed and could not give back, also where that is better so: it is not as it was promised.
fn not_given_back(plan: &Plan<'_>, changed: &[Change]) -> Option<Failure> {
    let left: Vec<_> = changed.iter().filter(|change| plan.gives_back() && !change.restored).collect();
    let settings = |old: bool| {
        let of = |change: &&Change| match old {
            true => format!("{}={}", change.name.trim_start_matches("P."), change.old),
            false => format!("{} = {}", change.name, change.new),
        };
        left.iter().map(of).collect::<Vec<_>>()
    };
    (!left.is_empty()).then(|| {
        let text = both!(
            "all was done, but not given back: {left}",
            "alles ist getan, aber nicht zurückgegeben: {left}",
            left = settings(false).join(", ")
        );
        Failure::new(Class::Partial, "partial.not_given_back", text).hint(both!(
            "the notes say why; `antrieb write {back}` sets it, when nothing can start",
            "die Anmerkungen sagen, warum; `antrieb write {back}` stellt es zurück, wenn nichts anlaufen kann",
            back = settings(true).join(" ")
        ))
    })
}

/// The work was done, and somebody did not wait for its end.
pub(in crate::command) fn interrupted() -> Failure {
    let text = both!("interrupted while it was stopped", "beim Anhalten unterbrochen");
    Failure::new(Class::Interrupted, "interrupted", text)
}

fn still_running(family: &Family) -> Failure {
    let text = both!(
        "the drive is running at the end of a run that was to stop it",
        "der Antrieb läuft am Ende eines Laufs, der ihn anhalten sollte",
    );
    Failure::new(Class::Forbidden, "forbidden.still_running", text).hint(how_to_stop(family))
}

/// What stops a drive that runs on: not everyone obeys the control word at all times.
fn how_to_stop(family: &Family) -> Text {
    match family.motion.control {
        Some(control) => both!(
            "its start contact or enable input stops it, and `antrieb statemachine quick-stop` where {label} = {obeys}",
            "ihn hält sein Startkontakt oder seine Freigabe an, und `antrieb statemachine quick-stop` bei {label} = {obeys}",
            label = family.role_label("control-mode"),
            obeys = control.obeys
        ),
        None => both!("`antrieb statemachine quick-stop` stops it", "`antrieb statemachine quick-stop` hält ihn an"),
    }
}

fn unknown() -> Failure {
    let text = both!(
        "all was done, but the drive does not tell in which state it is now",
        "alles ist getan, aber der Antrieb sagt nicht, in welchem Zustand er jetzt ist",
    );
    Failure::new(Class::Silence, "silence.final_state", text)
        .hint(both!("`antrieb statemachine show` asks again", "`antrieb statemachine show` fragt noch einmal"))
}
