//! What `statemachine` and `sollwert` share: ask, take control, do it, hold it, stop it, report.

use super::{Context, addresses_to_write, asking, connect, named_family, target};
use crate::args::{MotionArgs, Settings, StopArg};
use crate::drive::motion::{
    Ended, FirstWord, Meant, Motor, PROOF, Situation, StopChoice, Unseen, coasting, look, may_turn, shout, shout_zero,
    watchdog_raw, watchdog_words,
};
use crate::drive::{Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::gate::{Hazard, Question, Relief};
use crate::outcome::{Data, Decimal, Motion, Outcome};
use crate::profile::{Family, Lang, Mode, Registry};

mod verdict;

/// How often a drive that could not be reached for its stop may come back.
const MOST_RETURNS: u8 = 5;

/// The modes of a family in which something is meant.
pub(super) type Modes<'m> = dyn Fn(&Family) -> Vec<Mode> + 'm;

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
    /// It can only take motion away, so nobody is asked. The check may find out otherwise.
    pub(super) relief: Option<Relief>,
    /// The drive is to run when it is done, unless the run is bounded.
    pub(super) runs: bool,
    /// A setpoint of zero: the modes of a family in which it is one.
    pub(super) zero: Option<&'p Modes<'p>>,
    /// What takes motion away has gone out already.
    pub(super) said: bool,
}

impl Plan<'_> {
    /// What takes control or changes a setting does more than take motion away; what is held is a run.
    pub(super) fn only_relieves(args: &MotionArgs) -> bool {
        !(args.hold || args.take_control || args.watchdog.is_some())
    }

    /// Whether the drive is powered in it, or can be.
    fn powers(&self, before: &Situation) -> bool {
        self.runs || self.args.hold || before.state == "operation-enabled" || self.action == "contacts"
    }

    /// Whether nothing of this run is obeyed but its setpoint.
    fn is_started_by_others(&self, family: &Family, before: &Situation) -> bool {
        !(before.obeys(family) || self.args.take_control && self.needs_control || self.action == "contacts")
    }

    fn choice(&self) -> StopChoice {
        self.relief.map_or_else(|| choice(self.args.on_exit), StopChoice::beyond)
    }
}

/// The only drive that is meant; several at once are not moved by one command.
pub(super) fn single_address(context: &Context<'_>) -> Result<u8, Failure> {
    let lang = context.settings.lang;
    match addresses_to_write(context.settings)?.as_slice() {
        [0] => Err(not_everybody(context)),
        [only] => Ok(*only),
        _ => Err(usage(lang.pick(
            "expected the address of one drive, got several; motion is one drive at a time",
            "erwartet: die Adresse eines Antriebs; erhalten: mehrere. Bewegt wird immer nur einer",
        ))),
    }
}

/// A run is one drive's; to all at once goes only what a single telegram does, unproven.
fn not_everybody(context: &Context<'_>) -> Failure {
    let lang = context.settings.lang;
    let failure = usage("expected the address of one drive, got 0 (everybody)");
    let family = super::offline_family(context.settings, context.registry).ok();
    let word = family
        .as_ref()
        .and_then(|family| Some((family.role("control-word")?, family.machine.command("disable-voltage")?)));
    let Some((param, command)) = word else { return failure };
    let (name, word) = (param.short.clone().unwrap_or_else(|| param.id.to_string()), command.word);
    failure.hint(match lang {
        Lang::En => format!("`-a 0 write {name}={word}` takes the power from all of them at once; no answer proves it"),
        Lang::De => format!("`-a 0 write {name}={word}` nimmt allen auf einmal die Spannung; keine Antwort belegt es"),
    })
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
    let Context { settings, registry, interrupt, observe, ask } = context;
    let lang = settings.lang;
    let act = plan.relief;
    if act.is_some() {
        // A stop goes out and is proven whether or not somebody reads what comes of it.
        interrupt.hear_only_keys();
    }
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    // What can only take motion away goes out before anything is asked.
    let mut first_word = FirstWord::default();
    if let Some(act) = act {
        (plan.said, first_word) = stop_first(&mut session, settings, registry, address, act, plan.zero).await?;
        session.insist(true);
        session.end_at(Some(session.now() + PROOF));
    }
    let begun = session.now();
    let said = plan.said;
    let unstopped = |failure: Failure| act.map_or(failure.clone(), |act| unstopped(failure, act, said, lang));
    let mut target = target(&mut session, settings, registry, address, false).await.map_err(unstopped)?;
    let watchdog = plan.args.watchdog.map(|span| watchdog_raw(&target.family, span, lang)).transpose()?;
    // A command that relieves looks for itself, and goes out even where little can be seen.
    let before = match act {
        Some(Relief::Disable | Relief::QuickStop | Relief::DisableVoltage) => None,
        act => match look(&mut session, &mut target, lang).await {
            Err(failure) if act.is_none() || matches!(failure.class, Class::Port | Class::Interrupted) => {
                return Err(unstopped(failure));
            }
            seen => seen.ok(),
        },
    };
    let blind = Situation::default();
    let checked = check(&mut session, &mut target, before.as_ref().unwrap_or(&blind), &mut plan).await;
    let checked = checked.map_err(unstopped)?;
    let permit = match plan.relief {
        Some(act) => act.permit(),
        None => {
            session.demand_one_drive(address).map_err(|error| error.failure(address, Some(&target.family), lang))?;
            session.insist(false);
            session.end_at(None);
            let question = question(&plan, &target, settings.node, before.as_ref().unwrap_or(&blind), lang);
            asking::on_line(&mut session, *ask, &question, lang).await?
        }
    };
    if plan.args.hold {
        session.pace();
    }
    let family = target.family.clone();
    let mut motor = Motor::new(&mut session, &mut target, &permit, lang, plan.args.wait);
    if let Some(before) = &before {
        motor.controls(before);
    }
    motor.relieving = plan.relief.map(|_| begun);
    motor.first_word = first_word;
    let mut ended = motor
        .run(plan.args.hold, plan.choice(), async |motor: &mut Motor<'_, '_>| {
            prepare(motor, &plan, &family, watchdog).await?;
            work(motor, checked).await
        })
        .await;
    let mut after = motor.leave().await;
    for _ in 0..MOST_RETURNS {
        // A drive that answers again, and runs, gets its stop as soon as that is seen.
        let Some(stop) = ended.stop.as_ref().filter(|_| motor.unheard) else { break };
        if !after.as_ref().is_some_and(has_power) {
            break;
        }
        ended.stop = Some(motor.stop_after_all(stop).await);
        after = motor.leave().await;
    }
    let standing = match &ended.stop {
        Some(stop) if after.is_none() => stop.standing,
        Some(stop) if stop.standing == Some(true) && !after.as_ref().is_some_and(has_power) => stop.standing,
        _ if after.is_some() => motor.stands_at_the_end().await,
        _ => None,
    };
    let unseen = match plan.relief {
        Some(_) if standing.is_none() && (motor.shouted || motor.powered) => Some(motor.why_unseen().await),
        _ => None,
    };
    let done = Done {
        standing,
        idle: motor.is_idle(),
        unseen,
        steps: std::mem::take(&mut motor.steps),
        changed: std::mem::take(&mut motor.changes),
        setpoint: motor.setpoint.take(),
        notes: std::mem::take(&mut motor.notes),
        mode: motor.mode.take().map(|mode| mode.slug),
        instead: motor.instead.take(),
    };
    let seen = Seen { before, first: motor.first_seen.take(), after };
    Ok(report(&plan, &target, seen, done, ended, lang))
}

/// Sends what stops the drive, before anything is asked that it does not need.
async fn stop_first(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
    act: Relief,
    zero: Option<&Modes<'_>>,
) -> Result<(bool, FirstWord), Failure> {
    let family = settings.drive.as_deref().map(|name| named_family(settings, registry, name)).transpose()?;
    let meant = Meant { address, family, order: settings.word_order };
    let sent = match zero {
        Some(modes) => shout_zero(session, registry, &meant, modes).await.map(|sent| (sent, FirstWord::default())),
        None => shout(session, registry, &meant, act).await.map(|first| (true, first)),
    };
    sent.map_err(|error| unstopped(error.failure(address, None, settings.lang), act, zero.is_none(), settings.lang))
}

/// The failure of an act that was to take motion away, where the line is the reason: nothing proves that the shaft stands.
fn unstopped(failure: Failure, act: Relief, said: bool, lang: Lang) -> Failure {
    if !matches!(failure.class, Class::Silence | Class::Garbled | Class::Interrupted | Class::Data) {
        return failure;
    }
    let mut failure = failure;
    let (said, hint) = match act {
        Relief::Zero if said => (
            lang.pick(
                "the setpoint 0 was sent, whether it is obeyed is not known",
                "der Sollwert 0 wurde gesendet; ob er befolgt wird, ist unbekannt",
            ),
            lang.pick(
                "`statemachine quick-stop` stops it; or its enable input, the emergency stop, the mains",
                "`statemachine quick-stop` hält ihn an; oder sein Freigabeeingang, der Not-Halt, das Netz",
            ),
        ),
        Relief::Zero => (
            lang.pick("no setpoint was sent", "es wurde kein Sollwert gesendet"),
            lang.pick(
                "what a zero does must be asked from the drive first; `statemachine quick-stop` goes out at once",
                "was eine Null bewirkt, muss der Antrieb erst sagen; `statemachine quick-stop` geht sofort hinaus",
            ),
        ),
        _ => (
            lang.pick(
                "the stop was sent, whether it is obeyed is not known",
                "der Halt wurde gesendet; ob er befolgt wird, ist unbekannt",
            ),
            lang.pick(
                "what stops it now: its enable input, the emergency stop, or the mains",
                "was ihn jetzt anhält: sein Freigabeeingang, der Not-Halt oder das Netz",
            ),
        ),
    };
    failure.message = format!("{}: {said}; {}", may_turn(lang), failure.message);
    let hints = [Some(hint.to_owned()), failure.hint.take()];
    failure.hint(hints.into_iter().flatten().collect::<Vec<_>>().join("; "))
}

/// Changes for the run what the user wants changed.
async fn prepare(
    motor: &mut Motor<'_, '_>,
    plan: &Plan<'_>,
    family: &Family,
    watchdog: Option<i64>,
) -> Result<(), Failure> {
    if let Some(watchdog) = watchdog {
        motor.change("watchdog", watchdog).await?;
    }
    if let Some(control) = family.motion.control.filter(|_| plan.args.take_control && plan.needs_control) {
        motor.change("control-mode", control.obeys).await?;
    }
    Ok(())
}

/// What a run leaves in its motor.
struct Done {
    steps: Vec<crate::outcome::Step>,
    changed: Vec<crate::outcome::Change>,
    setpoint: Option<crate::outcome::Setpoint>,
    notes: Vec<String>,
    mode: Option<String>,
    /// Whether the shaft stands.
    standing: Option<bool>,
    /// The drive had no power at any look.
    idle: bool,
    /// Why nothing shows whether a drive stands that was to be stopped.
    unseen: Option<Unseen>,
    /// Another stop was given than was asked for: which, and why.
    instead: Option<String>,
}

/// What the drive said before and afterwards.
struct Seen {
    before: Option<Situation>,
    /// The first look at a drive to which what takes motion away had gone out already.
    first: Option<Situation>,
    after: Option<Situation>,
}

fn report(plan: &Plan<'_>, target: &Target, seen: Seen, done: Done, ended: Ended<()>, lang: Lang) -> Outcome {
    let family = &target.family;
    let state = |situation: &Situation| describe::state(family, situation.status, lang);
    let to = seen.after.as_ref().map(state);
    let running = seen.after.as_ref().map(has_power);
    let mut notes = done.notes.clone();
    if running == Some(true) {
        notes.push(keeps(plan, seen.after.as_ref(), done.standing, lang).to_owned());
    }
    let is_said = ended.stop.as_ref().is_some_and(|stop| stop.note.is_some());
    let is_theirs = done.idle && done.standing.is_none();
    let coasts = coasting(done.standing, lang).filter(|_| running == Some(false) && !is_theirs && !is_said);
    notes.extend(coasts.map(str::to_owned));
    let watchdog_s = seen.after.as_ref().or(seen.before.as_ref()).and_then(|seen| seen.watchdog_s);
    let is_off = watchdog_s.is_some_and(|seconds| seconds.raw == 0);
    let held = is_held(seen.after.as_ref(), done.standing);
    if is_off && plan.args.watchdog.is_none() && running != Some(false) && !held {
        notes.push(nothing_stops_it(family, watchdog_s, lang));
    }
    if watchdog_s.is_some_and(|seconds| seconds.raw > 0) || (watchdog_s.is_none() && running == Some(true) && !held) {
        notes.push(watchdog_words(family, watchdog_s, lang));
    }
    let failure = verdict::of(plan, family, &seen, &ended, running, &done, lang);
    let data = Motion {
        address: target.address,
        drive: family.drive.clone(),
        action: plan.action.to_owned(),
        mode: done.mode,
        from: seen.before.as_ref().map(state),
        to,
        steps: done.steps,
        setpoint: done.setpoint,
        changed: done.changed,
        watchdog_s,
        stop: ended.stop,
        running,
        standing: done.standing,
        idle: done.idle,
        notes,
    };
    Outcome { data: Some(Data::Motion(data)), warnings: Vec::new(), failure }
}

/// What the drive does that keeps its power.
fn keeps(plan: &Plan<'_>, after: Option<&Situation>, standing: Option<bool>, lang: Lang) -> &'static str {
    match (plan.relief, after.map(|seen| seen.state.as_str())) {
        (Some(Relief::Zero), _) => {
            lang.pick("the drive stays enabled, at a setpoint of 0", "der Antrieb bleibt freigegeben, Sollwert 0")
        }
        _ if is_held(after, standing) => lang.pick(
            "the quick stop holds the shaft at standstill, with power",
            "der Schnellhalt hält die Welle im Stillstand, mit Strom",
        ),
        (_, Some("quick-stop-active")) => {
            lang.pick("the quick stop is under way, with power", "der Schnellhalt läuft noch, mit Strom")
        }
        _ => lang.pick("the drive keeps running", "der Antrieb läuft weiter"),
    }
}

/// A quick stop that has brought the shaft to rest and holds it there.
fn is_held(after: Option<&Situation>, standing: Option<bool>) -> bool {
    after.is_some_and(|seen| seen.state == "quick-stop-active") && standing == Some(true)
}

fn has_power(situation: &Situation) -> bool {
    crate::drive::motion::has_power(&situation.state) == Some(true)
}

/// Names address, family, present state and what will happen.
fn question(plan: &Plan<'_>, target: &Target, node: u8, before: &Situation, lang: Lang) -> Question {
    let state = describe::state(&target.family, before.status, lang);
    let who = super::who(target.address, node, &target.family.drive, lang);
    let mut details = vec![format!("{who}: {} {}", lang.pick("now in", "jetzt in"), state.name)];
    let stop = plan.args.on_exit;
    let powers = plan.powers(before);
    details.push(match (plan.args.hold, stop, lang) {
        (true, StopArg::Keep, Lang::En) => "it keeps running when this program ends (--on-exit keep)".to_owned(),
        (true, StopArg::Keep, Lang::De) => "er läuft weiter, wenn dieses Programm endet (--on-exit keep)".to_owned(),
        (true, _, lang) if plan.is_started_by_others(&target.family, before) => started_by_others(&target.family, lang),
        (true, _, Lang::En) => format!("it is stopped when this program ends ({})", stop_name(stop)),
        (true, _, Lang::De) => format!("er wird angehalten, wenn dieses Programm endet ({})", stop_name(stop)),
        (false, _, lang) if powers => lang
            .pick(
                "the drive KEEPS RUNNING when this program ends; --hold bounds it",
                "der Antrieb LÄUFT WEITER, wenn dieses Programm endet; --hold begrenzt es",
            )
            .to_owned(),
        (false, _, Lang::En) => "what is set stays when this program ends; --hold bounds it".to_owned(),
        (false, _, Lang::De) => "was eingestellt wird, bleibt nach Programmende; --hold begrenzt es".to_owned(),
    });
    let is_off = before.watchdog_s.is_some_and(|seconds| seconds.raw == 0) && plan.args.watchdog.is_none();
    if powers && is_off {
        details.push(nothing_stops_it(&target.family, before.watchdog_s, lang));
    }
    details.extend(plan.details.iter().cloned());
    details.push(lang.pick("MOTION: the shaft may turn", "BEWEGUNG: die Welle kann drehen").to_owned());
    Question { hazards: vec![Hazard::Motion], title: plan.announce.clone(), details }
}

/// What the end of a run is whose only hand is on the setpoint.
fn started_by_others(family: &Family, lang: Lang) -> String {
    let label = family.role_label("control-mode");
    match lang {
        Lang::En => format!(
            "its contacts or its keypad start and stop it ({label}): when this program ends only the setpoint goes to 0"
        ),
        Lang::De => format!(
            "seine Kontakte oder seine Bedieneinheit starten und halten ihn ({label}): endet dieses Programm, geht nur der \
             Sollwert auf 0"
        ),
    }
}

fn nothing_stops_it(family: &Family, watchdog_s: Option<Decimal>, lang: Lang) -> String {
    let danger = lang.pick(
        "if the line breaks, nothing stops it; --watchdog 2s sets it",
        "bricht die Leitung, hält ihn nichts an; --watchdog 2s stellt ihn ein",
    );
    format!("{}: {danger}", watchdog_words(family, watchdog_s, lang))
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
