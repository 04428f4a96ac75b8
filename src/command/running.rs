//! What `statemachine` and `sollwert` share: ask, take control, do it, hold it, stop it, report.

use super::again::one_of;
use super::{Context, addresses_to_write, asking, connect};
use crate::args::{Addresses, MotionArgs, Settings, StopArg};
use crate::drive::motion::{
    Ended, FirstWord, Keeps, LAST_LOOK, Meant, Motor, PROOF, Promise, Situation, StopChoice, demand_as_shown, look,
    shout, shout_zero, turns, watchdog_raw,
};
use crate::drive::{Interrupt, Session, Target};
use crate::failure::{Class, Failure};
use crate::gate::{self, Ask, Permit, Relief};
use crate::outcome::{Data, Event, Outcome, RunKeys};
use crate::profile::{Family, Mode, Param, Registry};
use crate::text::{Text, both};

mod done;
pub(super) mod keypad;
pub(super) mod keys;
pub(super) mod leads;
mod question;
mod report;
mod sets;
mod several;
mod unstopped;
mod verdict;
mod whom;

use done::Seen;
use question::{nothing_stops_it, question};
use report::{aftermath, report};
pub(super) use several::{lines, stop_each};
use unstopped::{but_said, disobeyed, unstopped};
pub(super) use unstopped::{kept_back, unsent};
pub(super) use verdict::{interrupted, with_its_stop};
use whom::{first_said, meant, stop_harder, whom};

/// The modes of a family in which something is meant.
pub(super) type Modes<'m> = dyn Fn(&Family) -> Vec<Mode> + 'm;

/// What is to be done, and what the user is told about it.
pub(super) struct Plan<'p> {
    /// Word for JSON: `enable`, `sollwert` …
    pub(super) action: &'p str,
    /// What will happen, for the question.
    pub(super) announce: Text,
    /// What to know besides before one agrees.
    pub(super) details: Vec<Text>,
    /// What is shown of the drive's own settings: still so when somebody has agreed, or nothing is done.
    pub(super) promises: Vec<Promise>,
    /// What is set for the run besides.
    pub(super) sets: Vec<(Param, i64)>,
    /// How the run is bounded.
    pub(super) args: &'p MotionArgs,
    /// The control word is needed, so it must be obeyed.
    pub(super) needs_control: bool,
    /// What it is to take away, if it is there to stop the drive: it is judged by that.
    pub(super) aim: Option<Relief>,
    /// It can do nothing else, so nobody is asked, and it goes out first. The check may find out otherwise.
    pub(super) relief: Option<Relief>,
    /// The drive is to run when it is done, unless the run is bounded.
    pub(super) runs: bool,
    /// It leaves the drive without power.
    pub(super) takes_power: bool,
    /// A setpoint of zero, which goes out first: the modes of a family in which it is one.
    pub(super) zero: Option<&'p Modes<'p>>,
    /// What takes motion away has gone out already.
    pub(super) said: bool,
    /// What the arrows of the keypad do.
    pub(super) keys: Option<RunKeys>,
    /// Who keeps what is changed for the run, before it is.
    pub(super) keeps: Option<Keeps<'p>>,
    /// What takes the setpoint.
    pub(super) setpoint: Option<Param>,
}

impl<'p> Plan<'p> {
    /// Something that needs the control word, may turn the shaft, and leaves the drive as it comes to stand.
    pub(super) fn of(action: &'p str, announce: Text, args: &'p MotionArgs) -> Self {
        let (details, aim, relief, zero) = (Vec::new(), None, None, None);
        Plan {
            action,
            announce,
            details,
            promises: Vec::new(),
            sets: Vec::new(),
            args,
            needs_control: true,
            aim,
            relief,
            runs: false,
            takes_power: false,
            zero,
            said: false,
            keys: None,
            keeps: None,
            setpoint: None,
        }
    }

    /// What takes control or changes a setting does more than take motion away; what is held is a run.
    pub(super) fn only_relieves(args: &MotionArgs, needs_control: bool) -> bool {
        !(args.hold || (needs_control && args.take_control) || args.watchdog.is_some())
    }

    /// Whether the drive is powered in it, or can be.
    fn powers(&self, before: &Situation) -> bool {
        let works_on = before.state == "operation-enabled" && !self.takes_power;
        self.runs || self.args.hold || works_on || self.action == "contacts"
    }

    /// Whether nothing of this run is obeyed but its setpoint.
    fn is_started_by_others(&self, family: &Family, before: &Situation) -> bool {
        !(before.obeys(family) || self.args.take_control && self.needs_control || self.action == "contacts")
    }

    /// What goes out before anything is asked, whatever else somebody must agree to.
    fn goes_first(&self) -> Option<Relief> {
        self.relief.or(self.aim).or(self.zero.map(|_| Relief::Zero))
    }

    fn choice(&self) -> StopChoice {
        self.relief.map_or_else(|| choice(self.args.on_exit), StopChoice::beyond)
    }

    /// Tells what one has to know, now and in the question.
    pub(super) fn tells(&mut self, session: &mut Session<'_>, told: Vec<Text>) {
        told.iter().for_each(|text| session.tell(Event::Note(text.clone())));
        self.details.extend(told);
    }
}

/// What to do where a run is wanted of drives of several lines.
pub(super) fn one_by_one() -> Text {
    both!(
        "motion is one drive at a time: name it, as in `antrieb -a NAME …`; every stop goes over all",
        "bewegt wird immer nur einer: ihn nennen, wie in `antrieb -a NAME …`; jeder Halt geht über alle"
    )
}

/// The drives, where several were named.
pub(super) fn several(settings: &Settings) -> Option<Vec<u8>> {
    match &settings.addresses {
        Addresses::Named(list) if list.len() > 1 => Some(list.clone()),
        _ => None,
    }
}

/// The only drive that is meant; several at once are not moved by one command.
pub(super) fn single_address(context: &Context<'_>) -> Result<u8, Failure> {
    match addresses_to_write(context.settings)?.as_slice() {
        [0] => Err(not_everybody(context)),
        [only] => Ok(*only),
        several => Err(one_of(
            usage(both!(
                "expected the address of one drive, got several; motion is one drive at a time",
                "erwartet: die Adresse eines Antriebs; erhalten: mehrere. Bewegt wird immer nur einer"
            ))
            .hint(both!(
                "`antrieb statemachine quick-stop`, `disable`, `disable-voltage` and `sollwert 0` stop several",
                "`antrieb statemachine quick-stop`, `disable`, `disable-voltage` und `sollwert 0` halten mehrere an"
            )),
            several,
        )),
    }
}

/// A run is one drive's; to all at once goes only what a single telegram does, unproven.
fn not_everybody(context: &Context<'_>) -> Failure {
    let failure = usage(both!(
        "expected the address of one drive, got 0 (everybody)",
        "erwartet: die Adresse eines Antriebs; angegeben: 0 (alle)"
    ));
    let family = super::offline_family(context.settings, context.registry).ok();
    let word = family
        .as_ref()
        .and_then(|family| Some((family.role("control-word")?, family.machine.command("disable-voltage")?)));
    let Some((param, command)) = word else { return failure };
    let (name, word) = (param.short.clone().unwrap_or_else(|| param.id.to_string()), command.word);
    failure.hint(both!(
        "`-a 0 write {name}={word}` takes the power from all of them at once; no answer proves it",
        "`-a 0 write {name}={word}` nimmt allen auf einmal die Spannung; keine Antwort belegt es"
    ))
}

fn usage(text: Text) -> Failure {
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
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    keypad::is_there(plan.args, interrupt.panel())?;
    // Whatever else somebody must agree to, a command that stops goes out before.
    let goes_first = plan.goes_first();
    if goes_first.is_some() {
        // A stop goes out and is proven whether or not somebody reads what comes of it.
        interrupt.hear_only_keys();
    }
    let session = connect(settings, registry, interrupt, *observe).await;
    let mut session = session.map_err(|failure| if goes_first.is_some() { unsent(failure) } else { failure })?;
    let mut first_word = FirstWord::default();
    for (drive, act) in meant(settings, registry, &[address])?.iter().zip(goes_first) {
        first_word = first_said(&mut session, (settings, registry), drive, act, &mut plan).await?;
    }
    let said = Said { address, pressed: first_word.pressed, first_word };
    let mut around = Around { settings, registry, interrupt, ask: *ask };
    on_drive(&mut session, &mut around, said, plan, check, work).await
}

/// What went out to a drive that takes motion away.
struct Said {
    address: u8,
    first_word: FirstWord,
    /// Somebody interrupted meanwhile, so a stronger one follows.
    pressed: bool,
}

/// What a run on an open line needs besides.
pub(super) struct Around<'w> {
    pub(super) settings: &'w Settings,
    pub(super) registry: &'w Registry,
    pub(super) interrupt: &'w Interrupt,
    pub(super) ask: &'w mut dyn Ask,
}

/// A run on a line that is open already, to a drive to which nothing went out yet; asked, stopped and reported as by [`run`].
pub(super) async fn on_line<'p, C>(
    session: &mut Session<'_>,
    around: &mut Around<'_>,
    address: u8,
    plan: Plan<'p>,
    check: impl AsyncFnOnce(&mut Session<'_>, &mut Target, &Situation, &mut Plan<'p>) -> Result<C, Failure>,
    work: impl AsyncFnOnce(&mut Motor<'_, '_>, C) -> Result<(), Failure>,
) -> Result<Outcome, Failure> {
    let said = Said { address, first_word: FirstWord::default(), pressed: false };
    on_drive(session, around, said, plan, check, work).await
}

/// A run on one drive of an open line, behind the first word that takes motion away, if there is one.
async fn on_drive<'p, C>(
    session: &mut Session<'_>,
    around: &mut Around<'_>,
    said: Said,
    mut plan: Plan<'p>,
    check: impl AsyncFnOnce(&mut Session<'_>, &mut Target, &Situation, &mut Plan<'p>) -> Result<C, Failure>,
    work: impl AsyncFnOnce(&mut Motor<'_, '_>, C) -> Result<(), Failure>,
) -> Result<Outcome, Failure> {
    let Said { address, first_word, mut pressed } = said;
    let Around { settings, registry, interrupt, ask } = around;
    let (act, goes_first) = (plan.relief, plan.goes_first());
    if goes_first.is_some() {
        // From now on the end of the proof counts.
        session.insist(true);
        session.end_at(Some(session.now() + PROOF));
    }
    let (begun, said) = (session.now(), plan.said);
    let unstopped = |failure: Failure| goes_first.map_or(failure.clone(), |act| unstopped(failure, act, said));
    let passing = first_word.passing(session.is_shared()).filter(|_| settings.named_drive().is_none());
    let mut target = match &passing {
        Some(kind) => Target::new(address, kind.clone()),
        None => {
            let stops = goes_first.is_some();
            whom(session, (settings, registry), address, (act, stops), &mut pressed).await.map_err(unstopped)?
        }
    };
    super::movable(&target.family)?;
    let watchdog = plan.args.watchdog.map(|span| watchdog_raw(&target.family, span)).transpose()?;
    let before = first_look(session, &mut target, act).await.map_err(unstopped)?;
    if before.is_some() && goes_first.is_some() {
        // It answers, and a slow one takes long for all that is asked.
        session.end_at(Some(session.now() + PROOF));
    }
    let blind = Situation::default();
    let checked = check(session, &mut target, before.as_ref().unwrap_or(&blind), &mut plan).await;
    let checked = checked
        .map_err(|failure| goes_first.map_or(failure.clone(), |act| disobeyed(failure, act, said, before.as_ref())))?;
    if plan.relief.is_none() {
        let told = plan.tells_sets(session, &mut target, before.as_ref().unwrap_or(&blind), watchdog).await;
        told.map_err(unstopped)?;
    }
    let permit = match plan.relief {
        Some(act) => act.permit(),
        None => {
            let situation = (settings.node, before.as_ref().unwrap_or(&blind));
            match (agreed(session, *ask, &mut target, &plan, situation).await, goes_first) {
                (Err(failure), Some(act)) if plan.said => {
                    return Err(but_said(failure, act, rests(session, &mut target).await));
                }
                (agreed, _) => agreed?,
            }
        }
    };
    if plan.args.hold {
        session.pace();
    }
    let (watched, before) = keypad::open(session, &mut target, (&plan, &permit), interrupt.panel(), before).await?;
    let family = target.family.clone();
    let mut motor = Motor::new(session, &mut target, &permit, plan.args.wait);
    if let Some(before) = &before {
        motor.controls(before);
    }
    // Behind a quick stop in place of the ramp no other one follows, nor behind what takes the power.
    let choice = if first_word.leaves_the_strongest() { StopChoice::Coast } else { plan.choice() };
    motor.relieving = plan.relief.map(|_| begun);
    if goes_first.is_some() {
        // Whoever presses while that is on its way means nothing but the stop.
        motor.heeded = 0;
    }
    motor.first_word = first_word.taken_for(passing.clone());
    motor.promises.clone_from(&plan.promises);
    motor.watched = watched;
    motor.keeps = plan.keeps;
    let mut ended = motor
        .run(plan.args.hold, choice, async |motor: &mut Motor<'_, '_>| {
            if pressed && is_command(act) {
                return Err(motor.breaks_off());
            }
            prepare(motor, &plan, &family, watchdog).await?;
            work(motor, checked).await
        })
        .await;
    let (done, after) = aftermath(&mut motor, &mut ended, &plan).await;
    let seen = Seen { before, first: motor.first_seen.take(), after };
    let verdict = |ended: &Ended<()>| verdict::of(&plan, &family, &seen, ended, seen.runs(), &done);
    keypad::close(&mut motor, &mut ended, &plan, interrupt, verdict).await;
    if passing.is_some() {
        session.end_at(Some(session.now() + PROOF));
        let named = super::target(session, settings, registry, address, false).await;
        let mut outcome = report(&plan, named.as_ref().unwrap_or(&target), seen, done, ended);
        if let (Some(Data::Motion(motion)), Err(_)) = (&mut outcome.data, &named) {
            "unknown".clone_into(&mut motion.drive);
        }
        return Ok(outcome);
    }
    Ok(report(&plan, &target, seen, done, ended))
}

/// Whether the shaft of a drive that was told to stop is seen to stand.
async fn rests(session: &mut Session<'_>, target: &mut Target) -> bool {
    session.end_at(Some(session.now() + LAST_LOOK));
    matches!(turns(session, target).await, Ok(false))
}

/// What the drive says before anything else is done. A command that relieves looks for itself, and goes out even where little
/// can be seen; so does a setpoint of zero.
async fn first_look(
    session: &mut Session<'_>,
    target: &mut Target,
    act: Option<Relief>,
) -> Result<Option<Situation>, Failure> {
    if act.is_some_and(|act| act != Relief::Zero) {
        return Ok(None);
    }
    match look(session, target).await {
        Err(failure) if act.is_none() || matches!(failure.class, Class::Port | Class::Interrupted) => Err(failure),
        seen => Ok(seen.ok()),
    }
}

/// Asks, with what was seen of the node; what was shown must still be so behind the answer.
async fn agreed(
    session: &mut Session<'_>,
    ask: &mut dyn Ask,
    target: &mut Target,
    plan: &Plan<'_>,
    (node, before): (u8, &Situation),
) -> Result<Permit<gate::Motion>, Failure> {
    let one = session.demand_one_drive(target.address);
    one.map_err(|error| error.failure(target.address, Some(&target.family)))?;
    session.insist(false);
    session.end_at(None);
    let permit = asking::on_line(session, ask, &question(plan, target, node, before)).await?;
    for promise in &plan.promises {
        promise.demand(session, target).await?;
    }
    if plan.runs {
        demand_as_shown(session, target, before).await?;
    }
    Ok(permit)
}

/// Sends what stops the drive, before anything is asked that it does not need, and notes in the plan whether something went out.
async fn said_of(
    session: &mut Session<'_>,
    registry: &Registry,
    meant: &Meant,
    act: Relief,
    plan: &mut Plan<'_>,
) -> Result<FirstWord, Failure> {
    let sent = match plan.zero {
        Some(modes) => shout_zero(session, registry, meant, modes).await.map(|sent| (sent, FirstWord::default())),
        None => shout(session, registry, meant, act).await.map(|first| (true, first)),
    };
    let is_word = plan.zero.is_none();
    let (said, first_word) = sent.map_err(|error| unstopped(error.failure(meant.address, None), act, is_word))?;
    plan.said = said;
    Ok(first_word)
}

/// Whether an act is a word that is said at once.
fn is_command(act: Option<Relief>) -> bool {
    act.is_some_and(|act| act != Relief::Zero)
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
    if let Some(obeys) = plan.takes(family).filter(|_| plan.needs_control) {
        // A stop that went out first stands in the control word already.
        let enable = family.machine.command("enable").filter(|_| plan.aim.is_none());
        motor.take_control(obeys, enable.map(|command| command.word)).await?;
    }
    Ok(())
}

fn choice(stop: StopArg) -> StopChoice {
    match stop {
        StopArg::Ramp => StopChoice::Ramp,
        StopArg::QuickStop => StopChoice::QuickStop,
        StopArg::Coast => StopChoice::Coast,
        StopArg::Keep => StopChoice::Keep,
    }
}
