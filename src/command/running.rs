//! What `statemachine` and `sollwert` share: ask, take control, do it, hold it, stop it, report.

use super::{Context, addresses_to_write, connect, target};
use crate::args::{MotionArgs, StopArg};
use crate::drive::motion::{Motor, Situation, StopChoice, look, watchdog_raw, watchdog_seconds, watchdog_words};
use crate::drive::{Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::gate::{self, Hazard, Question};
use crate::outcome::{Data, Motion, Outcome};
use crate::profile::Lang;

/// What is to be done, and what the user is told about it.
pub(super) struct Plan<'p> {
    /// Word for JSON: `enable`, `sollwert` …
    pub(super) action: &'p str,
    /// What will happen, for the question.
    pub(super) announce: String,
    /// What to know besides before one agrees.
    pub(super) details: Vec<String>,
    /// How the run is bounded.
    pub(super) args: &'p MotionArgs,
    /// The control word is needed, so it must be obeyed.
    pub(super) needs_control: bool,
}

/// The only drive that is meant; several at once are not moved by one command.
pub(super) fn single_address(context: &Context<'_>) -> Result<u8, Failure> {
    match addresses_to_write(context.settings)?.as_slice() {
        [0] => Err(usage("expected the address of one drive, got 0 (everybody)")),
        [only] => Ok(*only),
        _ => Err(usage("expected the address of one drive, got several; motion is one drive at a time")),
    }
}

fn usage(text: &str) -> Failure {
    Failure::new(Class::Usage, "usage.address", text)
}

/// Asks, then runs `work` on the drive; stops and reports whatever happens.
///
/// `check` looks at the drive before anybody is asked, may refuse, and may say more about what will happen.
pub(super) async fn run<'p, C>(
    context: &mut Context<'_>,
    mut plan: Plan<'p>,
    check: impl AsyncFnOnce(&mut Session<'_>, &mut Target, &Situation, &mut Plan<'p>) -> Result<C, Failure>,
    work: impl AsyncFnOnce(&mut Motor<'_, '_>, C) -> Result<(), Failure>,
) -> Result<Outcome, Failure> {
    let address = single_address(context)?;
    // Nothing is opened if there is nobody to ask: not one byte goes over the line.
    gate::somebody(context.ask).map_err(|why| super::asking::denied(why, context.settings.lang))?;
    let Context { settings, registry, interrupt, observe, ask } = context;
    let lang = settings.lang;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    let mut target = target(&mut session, settings, registry, address, false).await?;
    let before = look(&mut session, &mut target, lang).await?;
    let checked = check(&mut session, &mut target, &before, &mut plan).await?;
    let question = question(&plan, &target, settings.node, &before, lang);
    let permit = super::asking::on_line(&mut session, *ask, &question, lang).await?;
    let from = describe::state(&target.family, before.status, lang);
    if plan.args.hold {
        session.pace();
    }
    let family = target.family.clone();
    let mut motor = Motor::new(&mut session, &mut target, &permit, lang, plan.args.wait);
    motor.controls(&before);
    let ended = motor
        .run(plan.args.hold, choice(plan.args.on_exit), async |motor: &mut Motor<'_, '_>| {
            if let Some(watchdog) = plan.args.watchdog {
                motor.change("watchdog", watchdog_raw(&family, watchdog)).await?;
            }
            if let Some(control) = family.motion.control.filter(|_| plan.args.take_control && plan.needs_control) {
                motor.change("control-mode", control.obeys).await?;
            }
            work(motor, checked).await
        })
        .await;
    let (steps, changed, setpoint) =
        (std::mem::take(&mut motor.steps), std::mem::take(&mut motor.changes), motor.setpoint.take());
    let mut notes = std::mem::take(&mut motor.notes);
    let mode = motor.mode.take().map(|mode| mode.slug);
    let after = look(&mut session, &mut target, lang).await.ok();
    let to = after.as_ref().map(|after| describe::state(&target.family, after.status, lang));
    let running = to.as_ref().map(|state| ["operation-enabled", "quick-stop-active"].contains(&state.slug.as_str()));
    if running == Some(true) {
        notes.push(lang.pick("the drive keeps running", "der Antrieb läuft weiter").to_owned());
    }
    let watchdog_s = before.watchdog_s;
    let is_off = watchdog_s.is_some_and(|seconds| seconds.raw == 0);
    if is_off && plan.args.watchdog.is_none() && running != Some(false) {
        let danger = lang.pick(
            "if the line breaks, nothing stops it; --watchdog 2s sets it",
            "bricht die Leitung, hält ihn nichts an; --watchdog 2s stellt ihn ein",
        );
        notes.push(format!("{}: {danger}", watchdog_words(&family, watchdog_s, lang)));
    }
    let set = plan.args.watchdog.map(|span| watchdog_seconds(&family, watchdog_raw(&family, span)));
    let watching = set.filter(|_| !plan.args.hold).or(watchdog_s);
    if watching.is_some_and(|seconds| seconds.raw > 0) {
        notes.push(watchdog_words(&family, watching, lang));
    }
    let data = Motion {
        address,
        drive: target.family.drive.clone(),
        action: plan.action.to_owned(),
        mode,
        from: Some(from),
        to,
        steps,
        setpoint,
        changed,
        watchdog_s,
        stop: ended.stop,
        running,
        notes,
    };
    let failure = match (ended.result.err(), &data.stop) {
        (Some(mut failure), Some(stop)) => {
            let proof = if stop.acknowledged {
                lang.pick("the stop was acknowledged", "der Halt wurde bestätigt")
            } else {
                lang.pick("the stop was NOT acknowledged", "der Halt wurde NICHT bestätigt")
            };
            failure.message = format!("{}; {}: {proof}", failure.message, stop.choice);
            Some(failure)
        }
        (None, Some(stop)) if !stop.acknowledged && stop.choice != "keep" => {
            let text = lang.pick("the stop at the end was NOT acknowledged", "der Halt am Ende wurde NICHT bestätigt");
            let failure = Failure::new(Class::Silence, "silence.stop", text);
            Some(match &stop.note {
                Some(note) => failure.hint(note.clone()),
                None => failure,
            })
        }
        // A run that was to end must have ended, whatever was acknowledged on the way.
        (None, _) if plan.args.hold && plan.args.on_exit != StopArg::Keep && running != Some(false) => {
            let text = lang.pick(
                "the drive is running at the end of a run that was to stop it",
                "der Antrieb läuft am Ende eines Laufs, der ihn anhalten sollte",
            );
            Some(Failure::new(Class::Forbidden, "forbidden.still_running", text).hint(lang.pick(
                "stop it with `statemachine quick-stop`, or by its contacts",
                "anhalten mit `statemachine quick-stop` oder über seine Kontakte",
            )))
        }
        (failure, _) => failure,
    };
    Ok(Outcome { data: Some(Data::Motion(data)), warnings: Vec::new(), failure })
}

/// Names address, family, present state and what will happen.
fn question(plan: &Plan<'_>, target: &Target, node: u8, before: &Situation, lang: Lang) -> Question {
    let state = describe::state(&target.family, before.status, lang);
    let who = super::who(target.address, node, &target.family.drive, lang);
    let mut details = vec![format!("{who}: {} {}", lang.pick("now in", "jetzt in"), state.name)];
    let stop = plan.args.on_exit;
    details.push(match (plan.args.hold, stop, lang) {
        (true, StopArg::Keep, Lang::En) => "it keeps running when this program ends (--on-exit keep)".to_owned(),
        (true, StopArg::Keep, Lang::De) => "er läuft weiter, wenn dieses Programm endet (--on-exit keep)".to_owned(),
        (true, _, Lang::En) => format!("it is stopped when this program ends ({})", stop_name(stop)),
        (true, _, Lang::De) => format!("er wird angehalten, wenn dieses Programm endet ({})", stop_name(stop)),
        (false, _, Lang::En) => "what is set stays when this program ends; --hold bounds it".to_owned(),
        (false, _, Lang::De) => "was eingestellt wird, bleibt nach Programmende; --hold begrenzt es".to_owned(),
    });
    details.extend(plan.details.iter().cloned());
    details.push(lang.pick("MOTION: the shaft may turn", "BEWEGUNG: die Welle kann drehen").to_owned());
    Question { hazards: vec![Hazard::Motion], title: plan.announce.clone(), details }
}

fn stop_name(stop: StopArg) -> &'static str {
    match stop {
        StopArg::Ramp => "ramp",
        StopArg::QuickStop => "quick-stop",
        StopArg::Coast => "coast",
        StopArg::Keep => "keep",
    }
}

fn choice(stop: StopArg) -> StopChoice {
    match stop {
        StopArg::Ramp => StopChoice::Ramp,
        StopArg::QuickStop => StopChoice::QuickStop,
        StopArg::Coast => StopChoice::Coast,
        StopArg::Keep => StopChoice::Keep,
    }
}
