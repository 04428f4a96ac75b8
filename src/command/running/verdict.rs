//! Whether a run ended as it was promised, and what its end is called if it did not.

use super::{Done, Plan, Seen};
use crate::args::StopArg;
use crate::drive::motion::{Ended, may_turn, tripped};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Change, Setpoint, Stop};
use crate::profile::{Family, Lang, Need};

/// The failure of a run; `None` only if the final state is the one that was promised.
pub(super) fn of(
    plan: &Plan<'_>,
    family: &Family,
    seen: &Seen,
    ended: &Ended<()>,
    running: Option<bool>,
    done: &Done,
    lang: Lang,
) -> Option<Failure> {
    match (ended.result.as_ref().err().cloned(), &ended.stop) {
        (Some(failure), Some(stop)) => Some(stopped(failure, stop, running, family, lang)),
        // A stop on a line that proves nothing, and nobody saw what became of it.
        (Some(failure), None) if plan.relief.is_some() && running.is_none() => Some(dangerous(failure, family, lang)),
        (Some(failure), None) => Some(failure),
        (None, Some(stop)) if !stop.acknowledged && stop.choice != "keep" => Some(unproven(stop, family, lang)),
        (None, _) => broken_promise(plan, family, seen, running, lang)
            .or_else(|| not_standing(plan, family, done.setpoint.as_ref(), lang))
            .or_else(|| not_given_back(plan, &done.changed, lang)),
    }
}

/// A run that went wrong, and what its stop did.
fn stopped(failure: Failure, stop: &Stop, running: Option<bool>, family: &Family, lang: Lang) -> Failure {
    let mut failure = failure;
    if stop.choice == "keep" {
        let kept = lang.pick("no stop was sent, as asked for", "es wurde kein Halt gesendet, wie verlangt");
        failure.message = format!("{}; keep: {kept}", failure.message);
        if failure.class != Class::Port {
            return failure;
        }
        failure.message = format!("{}: {}", danger(lang), failure.message);
        let hints = [Some(what_stops_it(family, lang)), failure.hint.take()];
        return failure.hint(hints.into_iter().flatten().collect::<Vec<_>>().join("; "));
    }
    let way = stop.escalated.map_or_else(|| stop.choice.to_owned(), |by| format!("{} -> {by}", stop.choice));
    let proof = match stop.acknowledged {
        true => lang.pick("the stop was acknowledged", "der Halt wurde bestätigt"),
        false => lang.pick("the stop was NOT acknowledged", "der Halt wurde NICHT bestätigt"),
    };
    failure.message = format!("{}; {way}: {proof}", failure.message);
    if stop.acknowledged || running == Some(false) {
        return failure;
    }
    let hints = [stop.note.clone(), failure.hint.take()];
    dangerous(failure.hint(hints.into_iter().flatten().collect::<Vec<_>>().join("; ")), family, lang)
}

/// The danger first, and what ends it; why it came to that is for later.
fn dangerous(failure: Failure, family: &Family, lang: Lang) -> Failure {
    let mut failure = failure;
    if failure.message.starts_with(danger(lang)) {
        return failure;
    }
    failure.message = format!("{}: {}", danger(lang), failure.message);
    let hints = [Some(what_stops_it(family, lang)), failure.hint.take().filter(|hint| !hint.is_empty())];
    failure.hint(hints.into_iter().flatten().collect::<Vec<_>>().join("; "))
}

/// The end came as it was to come, but not the stop.
fn unproven(stop: &Stop, family: &Family, lang: Lang) -> Failure {
    let text = lang.pick("the stop at the end was NOT acknowledged", "der Halt am Ende wurde NICHT bestätigt");
    let powered = stop.standing.is_none();
    let (class, code) = match stop.state {
        Some(_) => (Class::Forbidden, "forbidden.not_stopped"),
        None => (Class::Silence, "silence.stop"),
    };
    let message = if powered { format!("{}: {text}", danger(lang)) } else { text.to_owned() };
    let hints = [powered.then(|| what_stops_it(family, lang)), stop.note.clone()];
    Failure::new(class, code, message).hint(hints.into_iter().flatten().collect::<Vec<_>>().join("; "))
}

fn danger(lang: Lang) -> &'static str {
    may_turn(lang)
}

/// What stops a drive that cannot be reached.
fn what_stops_it(family: &Family, lang: Lang) -> String {
    let enable = family.motion.interlock(Need::Release).and_then(|row| row.parts.first());
    let enable = enable.map_or_else(
        || lang.pick("its safe-torque-off or enable input", "sein STO- oder Freigabeeingang").to_owned(),
        |part| part.name(lang).to_owned(),
    );
    match lang {
        Lang::En => format!("what stops it now: {enable}, the emergency stop, or the mains"),
        Lang::De => format!("was ihn jetzt anhält: {enable}, der Not-Halt oder das Netz"),
    }
}

/// Nothing went wrong on the way; is the drive where it was to be?
fn broken_promise(plan: &Plan<'_>, family: &Family, seen: &Seen, running: Option<bool>, lang: Lang) -> Option<Failure> {
    let Some(after) = &seen.after else { return Some(dangerous(unknown(lang), family, lang)) };
    let had_tripped = seen.before.as_ref().is_some_and(|before| before.state.starts_with("fault"));
    if after.state.starts_with("fault") && !(had_tripped && plan.relief.is_some()) {
        return Some(tripped(family, after.fault.unwrap_or(0) as u32, lang));
    }
    let must_stand = plan.args.hold && plan.args.on_exit != StopArg::Keep;
    let must_stop = matches!(plan.relief, Some(act) if act != Relief::Zero);
    // A run that was to end must have ended, whatever was acknowledged on the way.
    ((must_stand || must_stop) && running != Some(false)).then(|| still_running(lang)).or_else(|| {
        let must_run = plan.runs && !must_stand;
        (must_run && running == Some(false)).then(|| {
            let text = lang.pick("the drive does not run any more", "der Antrieb läuft nicht mehr");
            Failure::new(Class::Forbidden, "forbidden.not_running", text)
        })
    })
}

/// A setpoint of zero at which the shaft turns on.
fn not_standing(plan: &Plan<'_>, family: &Family, setpoint: Option<&Setpoint>, lang: Lang) -> Option<Failure> {
    let turns = plan.relief == Some(Relief::Zero) && setpoint?.reached == Some(false);
    turns.then(|| {
        let text =
            lang.pick("the setpoint is 0, but the shaft turns on", "der Sollwert ist 0, aber die Welle dreht weiter");
        let stops = lang.pick("`statemachine quick-stop` stops it", "`statemachine quick-stop` hält sie an");
        Failure::new(Class::No, "no.not_standing", text)
            .hint(format!("{stops}; {}", family.motion.not_reached.get(lang)))
    })
}

/// What a run changed and could not give back, also where that is better so: it is not as it was promised.
fn not_given_back(plan: &Plan<'_>, changed: &[Change], lang: Lang) -> Option<Failure> {
    let bounded = plan.args.hold && plan.args.on_exit != StopArg::Keep;
    let left = changed.iter().filter(|change| bounded && !change.restored);
    let left: Vec<_> = left.map(|change| format!("{} = {}", change.name, change.new)).collect();
    (!left.is_empty()).then(|| {
        let text = lang.pick("all was done, but not given back:", "alles ist getan, aber nicht zurückgegeben:");
        Failure::new(Class::Partial, "partial.not_given_back", format!("{text} {}", left.join(", "))).hint(lang.pick(
            "the notes say why; `write` sets it, when nothing can start",
            "die Hinweise sagen, warum; `write` stellt es zurück, wenn nichts anlaufen kann",
        ))
    })
}

fn still_running(lang: Lang) -> Failure {
    let text = lang.pick(
        "the drive is running at the end of a run that was to stop it",
        "der Antrieb läuft am Ende eines Laufs, der ihn anhalten sollte",
    );
    Failure::new(Class::Forbidden, "forbidden.still_running", text).hint(lang.pick(
        "stop it with `statemachine quick-stop`, or by its contacts",
        "anhalten mit `statemachine quick-stop` oder über seine Kontakte",
    ))
}

fn unknown(lang: Lang) -> Failure {
    let text = lang.pick(
        "all was done, but the drive does not tell in which state it is now",
        "alles ist getan, aber der Antrieb sagt nicht, in welchem Zustand er jetzt ist",
    );
    Failure::new(Class::Silence, "silence.final_state", text)
        .hint(lang.pick("`statemachine show` asks again", "`statemachine show` fragt noch einmal"))
}
