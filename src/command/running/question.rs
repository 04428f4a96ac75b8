//! What somebody is asked before a shaft may turn.

use super::Plan;
use crate::args::StopArg;
use crate::drive::motion::{Situation, watchdog_words};
use crate::drive::{Target, describe};
use crate::gate::{Hazard, Question};
use crate::outcome::Decimal;
use crate::profile::Family;
use crate::text::{Text, both};

/// Names address, family, present state and what will happen.
pub(super) fn question(plan: &Plan<'_>, target: &Target, node: u8, before: &Situation) -> Question {
    let state = describe::state(&target.family, before.status).name;
    let who = crate::command::who(target.address, node, &target.family.drive);
    let mut details = vec![both!("{who}: now in {state}", "{who}: jetzt in {state}", who, state)];
    let powers = plan.powers(before);
    details.push(at_the_end(plan, &target.family, before, powers));
    let is_off = before.watchdog_s.is_some_and(|seconds| seconds.raw == 0) && plan.args.watchdog.is_none();
    if powers && is_off {
        details.push(nothing_stops_it(&target.family, before.watchdog_s));
    }
    details.extend(plan.details.iter().cloned());
    details.push(both!("MOTION: the shaft may turn", "BEWEGUNG: die Welle kann drehen"));
    Question { hazards: vec![Hazard::Motion], title: plan.announce.clone(), details }
}

/// What becomes of the drive when this program ends.
fn at_the_end(plan: &Plan<'_>, family: &Family, before: &Situation, powers: bool) -> Text {
    match (plan.args.hold, plan.args.on_exit) {
        (true, StopArg::Keep) if has_watchdog(plan, before) => both!(
            "no stop is sent when this program ends (--on-exit keep): it runs on until its watchdog stops it",
            "endet dieses Programm, wird kein Halt gesendet (--on-exit keep): er läuft, bis sein Watchdog ihn anhält"
        ),
        (true, StopArg::Keep) => both!(
            "it keeps running when this program ends (--on-exit keep)",
            "er läuft weiter, wenn dieses Programm endet (--on-exit keep)"
        ),
        (true, stop) if plan.args.dead_man => both!(
            "it runs only while a key is held, and is stopped when that is let go or this program ends ({stop})",
            "er läuft nur, solange eine Taste gehalten wird; beim Loslassen und am Programmende wird er angehalten ({stop})",
            stop = stop_name(stop)
        ),
        (true, _) if plan.is_started_by_others(family, before) => started_by_others(family),
        (true, stop) => both!(
            "it is stopped when this program ends ({stop})",
            "er wird angehalten, wenn dieses Programm endet ({stop})",
            stop = stop_name(stop)
        ),
        (false, _) if plan.aim.is_some() => both!("it is to stop", "er soll anhalten"),
        (false, _) if powers && has_watchdog(plan, before) => both!(
            "the drive runs on when this program ends, until its watchdog stops it; --hold bounds it",
            "der Antrieb läuft weiter, wenn dieses Programm endet, bis sein Watchdog ihn anhält; --hold begrenzt es"
        ),
        (false, _) if powers => both!(
            "the drive KEEPS RUNNING when this program ends; --hold bounds it",
            "der Antrieb LÄUFT WEITER, wenn dieses Programm endet; --hold begrenzt es"
        ),
        (false, _) => both!(
            "what is set stays when this program ends; --hold bounds it",
            "was eingestellt wird, bleibt nach Programmende; --hold begrenzt es"
        ),
    }
}

/// Whether the drive's watchdog is on, or will be in this run.
fn has_watchdog(plan: &Plan<'_>, before: &Situation) -> bool {
    plan.args.watchdog.is_some() || before.watchdog_s.is_some_and(|seconds| seconds.raw > 0)
}

/// What the end of a run is whose only hand is on the setpoint.
fn started_by_others(family: &Family) -> Text {
    both!(
        "its contacts or its keypad start and stop it ({label}): when this program ends only the setpoint goes to 0",
        "seine Kontakte oder seine Bedieneinheit starten und halten ihn ({label}): endet dieses Programm, geht nur der \
         Sollwert auf 0",
        label = family.role_label("control-mode")
    )
}

pub(super) fn nothing_stops_it(family: &Family, watchdog_s: Option<Decimal>) -> Text {
    both!(
        "{watchdog}: if the line breaks, nothing stops it; --watchdog 2s sets it",
        "{watchdog}: bricht die Leitung, hält ihn nichts an; --watchdog 2s stellt ihn ein",
        watchdog = watchdog_words(family, watchdog_s)
    )
}

fn stop_name(stop: StopArg) -> &'static str {
    match stop {
        StopArg::Ramp => "ramp",
        StopArg::QuickStop => "quick-stop",
        StopArg::Coast => "coast",
        StopArg::Keep => "keep",
    }
}
