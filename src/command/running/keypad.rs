//! The view of a run that is held, and its keypad: there before anything is sent, opened once somebody agreed, and what it means
//! that a key ended the run.

use super::{Plan, asking};
use crate::args::{MotionArgs, StopArg};
use crate::command::monitor;
use crate::drive::motion::{Ended, Motor, Situation, Watched, look};
use crate::drive::{EndedBy, Interrupt, Panel, Session, Stays, Target, last_told};
use crate::failure::{Class, Failure};
use crate::gate::{self, Permit};
use crate::outcome::Event;
use crate::text::{Text, both};

/// Refuses what needs keys where there are none, and what no key could stop; before anything is opened.
pub(in crate::command) fn is_there(args: &MotionArgs, panel: &Panel) -> Result<(), Failure> {
    if !args.wants_keys() {
        return Ok(());
    }
    let flag = if args.dead_man { "--dead-man" } else { "--view" };
    let usage = |text| Err(Failure::new(Class::Usage, "usage.view", text));
    if !args.hold {
        return usage(both!(
            "{flag} is for a run that is held: add --hold",
            "{flag} gilt für einen gehaltenen Lauf: --hold angeben"
        ));
    }
    if args.on_exit == StopArg::Keep {
        return usage(both!(
            "{flag} has keys that stop, and --on-exit keep stops nothing",
            "{flag} hat Tasten, die anhalten, und --on-exit keep hält nichts an"
        ));
    }
    if panel.has_keys() {
        return Ok(());
    }
    let text = both!(
        "{flag} needs a terminal for its picture and its keys, nothing was sent",
        "{flag} braucht ein Terminal für Bild und Tasten; nichts wurde gesendet"
    );
    Err(Failure::new(Class::Forbidden, "forbidden.no_terminal", text).hint(both!(
        "without it one line is shown on a terminal, and `--format ndjson` writes records",
        "ohne sie zeigt ein Terminal eine Zeile, und `--format ndjson` schreibt Datensätze"
    )))
}

/// Begins to show the run, if anybody looks. With a dead man it waits until a key is held, and looks at the drive anew.
pub(super) async fn open(
    session: &mut Session<'_>,
    target: &mut Target,
    (plan, permit): (&Plan<'_>, &Permit<gate::Motion>),
    panel: &Panel,
    before: Option<Situation>,
) -> Result<(Option<Watched>, Option<Situation>), Failure> {
    if !panel.is_watched() || plan.relief.is_some() {
        return Ok((None, before));
    }
    let verb = if plan.action == "sollwert" { "sollwert" } else { "statemachine" };
    let items = monitor::usual_of_run(&target.family, plan.setpoint.as_ref());
    if plan.args.dead_man {
        panel.needs_holding();
    }
    let watched = Watched::begin(session, target, &items, (verb, plan.choice()), plan.keys.clone(), panel.clone());
    let (mut watched, mut before) = (Some(watched), before);
    if plan.args.dead_man {
        session.tell(Event::Note(hold_a_key()));
        let mut motor = Motor::new(session, target, permit, None);
        motor.watched = watched.take();
        motor.await_key(panel).await.map_err(|failure| match failure.class {
            Class::Interrupted => asking::left_before_start(),
            _ => failure,
        })?;
        watched = motor.watched.take();
        before = Some(look(session, target).await?);
    }
    watched.iter_mut().for_each(|watched| watched.starts(session));
    Ok((watched, before))
}

/// What a dead man waits for.
pub(in crate::command) fn hold_a_key() -> Text {
    both!("hold Enter or an arrow: it runs only as long", "Enter oder einen Pfeil halten: nur so lange läuft er")
}

/// How long the view of a run stays behind its end; `None` where nobody looks any more, or nothing was held nor pressed.
pub(in crate::command) fn stays(panel: &Panel, is_well: bool, was_held: bool) -> Option<Stays> {
    let stays = match panel.ended() {
        Some(EndedBy::Key | EndedBy::DeadMan) => Stays::UntilLeft,
        None if was_held && !is_well => Stays::AWhile,
        // The key of a dead man whose start was refused is still held.
        None if was_held || panel.presses() > 0 => Stays::UntilQuiet,
        None => return None,
    };
    (!panel.is_left()).then_some(stays)
}

/// A run that was held and ended by its keypad came to its normal end, unless somebody interrupted as well. Where it was only
/// stopped its view stays until somebody leaves, with what will be reported of its end.
pub(super) async fn close(
    motor: &mut Motor<'_, '_>,
    ended: &mut Ended<()>,
    plan: &Plan<'_>,
    interrupt: &Interrupt,
    verdict: impl FnOnce(&Ended<()>) -> Option<Failure>,
) {
    let panel = interrupt.panel();
    let by = panel.ended();
    let was_held = motor.watched.as_ref().is_some_and(Watched::was_held);
    let is_interrupted = matches!(&ended.result, Err(failure) if failure.class == Class::Interrupted);
    if let (true, true, false, Some(stop)) = (was_held, is_interrupted, panel.is_interrupted(), &mut ended.stop)
        && by.is_some()
        && plan.args.hold
        && stop.because == "interrupted"
    {
        ended.result = Ok(());
        stop.because = if by == Some(EndedBy::Key) { "key" } else { "dead-man" };
    }
    let Some(stays) = stays(panel, ended.result.is_ok(), was_held) else { return };
    let stands = ended.stop.as_ref().is_some_and(|stop| stop.acknowledged && stop.standing == Some(true));
    let told = verdict(ended).map_or_else(|| last_told(stands), |failure| failure.told_whole());
    motor.linger(interrupt, told, stays).await;
}
