//! `statemachine`: in which state is the drive, and walking it safely through its states.

mod contacts;
mod over_profibus;
mod several;

use super::lines::OverLines;
use super::profibus::{ModeArg, SlaveArgs};
use super::rehearse::Rehearsal;
use super::running::{self, Plan};
use super::verb::{Flow, Verb, Working};
use super::{Context, InForce, Reader, Row, each_drive, finish, offline_family, plan, role_questions, target};
use crate::args::{MotionArgs, Settings, Takes};
use crate::drive::motion::{
    self, Motor, Situation, has_power, in_fault, missing, no_control, no_fault, surroundings, upon_enabling,
};
use crate::drive::{Session, Target, Upper, describe};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{
    Data, Document, ErrorDoc, Event, OrLines, OrMotion, OrRecord, Outcome, StateReport, StateRow, Statemachine,
};
use crate::profile::{DriveState, Family, Registry};
use crate::text::{Text, both};
use clap::{Args as ClapArgs, Subcommand};

/// Shows a drive's state, and walks it to another.
///
/// `show` (the default) reads only: the state, status and control word bit by bit, who controls the drive, what is
/// missing to run, and where each state leads. `disable`, `disable-voltage` and `quick-stop` only take motion away and act
/// at once, on several drives too (-a 1-5, -a all); everything else can turn the shaft and asks first. An ACTIVE obeys the
/// control word only with P.412 = 1 (--take-control) and with external enable and start contact given.
///
/// Over PROFIBUS (--protocol dp): `show`, the stops, `reset`, and `enable --hold` at a setpoint of 0, by the words of PROFIdrive, or of the
/// Basic block (--mode basic --drive l200); `sollwert` runs a motor.
///
/// Exit code of a stop of several: 0 if every shaft is proven to stand (behind `disable-voltage`, and where P.392 lets it coast: if every
/// drive is proven to have no power), 9 if some are; if none is, that of the drive of which least is known. The page says it of each.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// How a slave is taken.
    #[command(flatten)]
    slave: SlaveArgs,
    #[command(flatten)]
    mode: ModeArg,

    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Show state, words, what is missing (the default)
    Show,
    /// Shut down: to "ready to switch on"
    Shutdown(MotionArgs),
    /// Walk to "switched on"; the shaft does not turn yet
    SwitchOn(MotionArgs),
    /// Walk to "operation enabled": the motor follows its setpoint
    Enable(MotionArgs),
    /// Disable operation: coasts, brakes or ramps as P.392 says
    ///
    /// Transition 5.
    Disable(MotionArgs),
    /// Disable voltage: the shaft coasts
    ///
    /// Done (0) once the drive is without power: a shaft that turns coasts on, which is told.
    DisableVoltage(MotionArgs),
    /// Quick stop: by the emergency ramps P.424 and P.425
    QuickStop(MotionArgs),
    /// Reset a fault: once, when the drive's 15 s lock has passed
    Reset(MotionArgs),
    /// Walk to a state, the shortest way
    Goto {
        /// switched-on, operation-enabled …
        ///
        /// switch-on-disabled, ready-to-switch-on, switched-on, operation-enabled
        state: String,
        #[command(flatten)]
        motion: MotionArgs,
    },
    /// Set virtual contacts through the control word (P.412 = 2)
    ///
    /// S1IND … S6IND, MFI1D, EM-S1IND … EM-S3IND.
    Contacts {
        /// Contacts that are closed; all others are open
        contacts: Vec<String>,
        #[command(flatten)]
        motion: MotionArgs,
    },
}

impl Action {
    fn motion(&self) -> Option<&MotionArgs> {
        match self {
            Action::Show => None,
            Action::Shutdown(motion)
            | Action::SwitchOn(motion)
            | Action::Enable(motion)
            | Action::Disable(motion)
            | Action::DisableVoltage(motion)
            | Action::QuickStop(motion)
            | Action::Reset(motion)
            | Action::Goto { motion, .. }
            | Action::Contacts { motion, .. } => Some(motion),
        }
    }

    /// Whether it can only take motion away.
    fn is_stop(&self) -> bool {
        matches!(self, Action::Disable(_) | Action::DisableVoltage(_) | Action::QuickStop(_))
    }
}

/// Roles that are read, in this order.
const ROLES: [&str; 4] = ["status-word", "control-mode", "control-word", "fault"];

impl Verb for Args {
    const NAME: &'static str = "statemachine";
    const TAKES: Takes = Takes::WRITES;
    const PROFIBUS: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1 statemachine show",
        "antrieb --port sim -a 1 statemachine shutdown --take-control --yes",
        "antrieb --port sim -a 1 statemachine switch-on --take-control --dry-run",
        "antrieb -p sim -a 1 state enable --hold --duration 5s --take-control --yes",
        "antrieb --port sim -a 1 statemachine quick-stop --dry-run",
        "antrieb --port sim -a 1,2 statemachine disable --dry-run",
        "antrieb --port sim -a 1 statemachine disable-voltage --dry-run",
        "antrieb --port sim -a 1 statemachine reset --dry-run",
        "antrieb -p sim -a 1 statemachine goto switched-on --take-control --dry-run",
        "antrieb --port sim -a 1 statemachine contacts S2IND S3IND --dry-run",
        "antrieb --port sim --protocol dp -a 3 statemachine disable",
    ];
    const UPPER: Upper = Upper::drive(60).besides(motion::WAITS).unless(
        "A shaft that still becomes faster or slower is waited for as well, at most 10 min for each ramp; `reset` waits for the \
         15 s of the drive's lock, and --hold for --duration or Ctrl-C. `disable`, `disable-voltage` and `quick-stop` are said \
         at once, and end within 20 s unless the shaft becomes slower; several drives together within 20 s for each of \
         them.",
    );
    const ALIAS: Option<&'static str> = Some("state");
    const TURNS: bool = true;
    type Prints = OrRecord<Document<OrMotion<OrLines<Statemachine>>>>;

    fn streams(&self) -> Option<Flow> {
        let action = self.action.as_ref().filter(|action| !action.is_stop())?;
        let motion = action.motion()?;
        (motion.hold || motion.wants_keys()).then_some(Flow::Run { view: motion.wants_keys() })
    }

    fn over_lines(&self) -> OverLines {
        match &self.action {
            None | Some(Action::Show) => OverLines::Each,
            Some(action) if action.is_stop() => OverLines::Itself,
            _ => OverLines::One(Some(running::one_by_one())),
        }
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Shows the state of every drive that was named, or walks one.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if args.mode.is_meant(&args.slave, context.settings)? {
        return over_profibus::run(args, context).await;
    }
    let (slug, motion) = match &args.action {
        None | Some(Action::Show) => return show_all(context).await,
        Some(Action::Shutdown(motion)) => ("shutdown", motion),
        Some(Action::SwitchOn(motion)) => ("switch-on", motion),
        Some(Action::Enable(motion)) => ("enable", motion),
        Some(Action::Disable(motion)) => ("disable", motion),
        Some(Action::DisableVoltage(motion)) => ("disable-voltage", motion),
        Some(Action::QuickStop(motion)) => ("quick-stop", motion),
        Some(Action::Reset(motion)) => ("reset", motion),
        Some(Action::Goto { state, motion }) => return go_to(context, state, motion).await,
        Some(Action::Contacts { contacts, motion }) => return contacts::set(context, contacts, motion).await,
    };
    let family = offline_family(context.settings, context.registry)?;
    super::movable(&family)?;
    let command = family.machine.command(slug).cloned();
    let command = command.ok_or_else(|| {
        let text = both!("this drive has no command '{slug}'", "dieser Antrieb hat keinen Befehl '{slug}'");
        Failure::new(Class::Data, "data.machine", text)
    })?;
    let aim = relief_of(slug);
    let unheld = aim.map(|_| motion.of_a_stop());
    let bounds = motion.hold.then(no_run).filter(|_| aim.is_some());
    let motion = unheld.as_ref().unwrap_or(motion);
    if let (Some(act), Some(addresses)) = (aim, running::several(context.settings)) {
        return several::stop(context, &addresses, act, (slug, command.text(), motion)).await;
    }
    if context.settings.dry_run {
        let gives_back = aim.is_some() || slug == "reset";
        return dry_run(context, &family, motion, (true, gives_back), aim.map(|_| slug), |told| match slug {
            "enable" => told.walk("operation-enabled"),
            "switch-on" => told.walk("switched-on"),
            slug => told.command(slug),
        });
    }
    let relief = aim.filter(|_| Plan::only_relieves(motion, true));
    let (runs, takes_power) = (slug == "enable", slug == "shutdown");
    let plan = Plan { aim, relief, runs, takes_power, ..Plan::of(slug, command.text(), motion) };
    commanded(context, plan, bounds).await
}

/// Gives one command. `bounds`: what was typed and changes nothing.
async fn commanded(context: &mut Context<'_>, plan: Plan<'_>, bounds: Option<Text>) -> Result<Outcome, Failure> {
    let (slug, motion) = (plan.action, plan.args);
    running::run(
        context,
        plan,
        async |session, target, before, plan| {
            bounds.into_iter().for_each(|told| session.tell(Event::Note(told)));
            if plan.relief.is_some() {
                return Ok(());
            }
            obeyed(target, before, plan)?;
            if slug == "reset" && !before.state.starts_with("fault") {
                return Err(no_fault());
            }
            if slug == "enable" { enabling(session, target, before, plan).await } else { Ok(()) }
        },
        async |motor, ()| {
            let hold = (motion.hold && slug == "enable").then_some(motion.duration);
            let work = async |motor: &mut Motor<'_, '_>| match (slug, relief_of(slug)) {
                (_, Some(act)) => motor.relieve(act).await,
                ("enable", _) => motor.walk("operation-enabled").await,
                ("switch-on", _) => motor.walk("switched-on").await,
                ("reset", _) => motor.reset().await,
                (other, _) => motor.command(other).await,
            };
            motor.holding(hold, work).await
        },
    )
    .await
}

/// A stop goes out at once and is proven; nothing is left that could be held.
fn no_run() -> Text {
    both!(
        "a stop is no run: --hold, --duration, --view and --dead-man change nothing here",
        "ein Halt ist kein Lauf: --hold, --duration, --view und --dead-man ändern hier nichts"
    )
}

/// Commands that can only take motion away.
fn relief_of(slug: &str) -> Option<Relief> {
    match slug {
        "disable" => Some(Relief::Disable),
        "disable-voltage" => Some(Relief::DisableVoltage),
        "quick-stop" => Some(Relief::QuickStop),
        _ => None,
    }
}

/// Refuses at once, before anybody is asked, what the drive would not obey. Of a reset there are other ways.
fn obeyed(target: &Target, before: &Situation, plan: &Plan<'_>) -> Result<(), Failure> {
    let refused = no_control(before, target).filter(|_| !plan.args.take_control);
    match (refused, &target.family.motion.other_resets) {
        (None, _) => Ok(()),
        (Some(failure), Some(ways)) if plan.action == "reset" => {
            let hint = failure.hint.clone().unwrap_or_default();
            Err(failure.hint(Text::join([ways, &*hint], "; ")))
        }
        (Some(failure), _) => Err(failure),
    }
}

/// Tells what the shaft will do as soon as the drive is enabled.
async fn enabling(
    session: &mut Session<'_>,
    target: &mut Target,
    before: &Situation,
    plan: &mut Plan<'_>,
) -> Result<(), Failure> {
    if let Some(failure) = in_fault(before, &target.family) {
        return Err(failure);
    }
    if before.state != "operation-enabled" {
        let (told, promises) = upon_enabling(session, target).await?;
        plan.tells(session, told);
        plan.promises.extend(promises);
    }
    Ok(())
}

async fn go_to(context: &mut Context<'_>, state: &str, motion: &MotionArgs) -> Result<Outcome, Failure> {
    let family = offline_family(context.settings, context.registry)?;
    super::movable(&family)?;
    let Some(row) = family.states.iter().find(|row| row.slug == state) else {
        let leads = |slug: &str| family.machine.transitions.iter().any(|way| way.to == slug && way.command.is_some());
        let known: Vec<_> = family.states.iter().map(|row| row.slug.as_str()).filter(|slug| leads(slug)).collect();
        let message = both!(
            "there is no state '{state}' (expected: {known})",
            "es gibt keinen Zustand '{state}' (möglich: {known})",
            known = known.join(", ")
        );
        let failure = Failure::new(Class::Usage, "usage.state", message);
        return Err(match super::stop_meant(state) {
            Some(how) => failure.hint(how),
            None => failure,
        });
    };
    if context.settings.dry_run {
        return dry_run(context, &family, motion, (true, false), None, |told| told.walk(state));
    }
    let announce = both!("walk to '{state}'", "gehen nach '{state}'", state = row.text());
    let runs = state == "operation-enabled";
    let hold = (motion.hold && runs).then_some(motion.duration);
    let plan = Plan { runs, takes_power: has_power(state) == Some(false), ..Plan::of("goto", announce, motion) };
    running::run(
        context,
        plan,
        async |session, target, before, plan| {
            obeyed(target, before, plan)?;
            if runs { enabling(session, target, before, plan).await } else { Ok(()) }
        },
        async |motor, ()| motor.holding(hold, async |motor: &mut Motor<'_, '_>| motor.walk(state).await).await,
    )
    .await
}

/// What a run would send: what it reads first, what the options set, the way, and its end. Whether it needs the control word, and gives back
/// what it changed although it is not held.
fn dry_run(
    context: &Context<'_>,
    family: &Family,
    motion: &MotionArgs,
    needs: (bool, bool),
    stops: Option<&str>,
    way: impl FnOnce(&mut Rehearsal<'_>),
) -> Result<Outcome, Failure> {
    let address = running::single_address(context)?;
    Ok(rehearse(context.settings, family, address, motion, needs, stops, way)?.told())
}

fn rehearse<'r>(
    settings: &Settings,
    family: &'r Family,
    address: u8,
    motion: &MotionArgs,
    (needs_control, gives_back): (bool, bool),
    stops: Option<&str>,
    way: impl FnOnce(&mut Rehearsal<'_>),
) -> Result<Rehearsal<'r>, Failure> {
    let mut told = match stops {
        Some(slug) => Rehearsal::stopping(settings, family, address, slug),
        None => Rehearsal::new(settings, family, address),
    };
    told.bounds(motion, needs_control)?;
    way(&mut told);
    told.end(motion, None, gives_back);
    Ok(told)
}

async fn show_all(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let family = offline_family(context.settings, context.registry)?;
        return plan(context, &family, &role_questions(&family, &ROLES));
    }
    let named = context.settings.drive.clone().unwrap_or_else(|| "unknown".to_owned());
    let (drives, failures, succeeded) = each_drive(
        context,
        <Args as Verb>::UPPER.drive,
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            show(session, settings, registry, address).await
        },
        |address, failure: &Failure| StateReport {
            address,
            drive: named.clone(),
            state: None,
            status: None,
            control: None,
            control_mode: None,
            control_mode_stored: None,
            fault: None,
            fault_code: None,
            missing: Vec::new(),
            states: Vec::new(),
            error: Some(ErrorDoc::from(failure)),
        },
    )
    .await?;
    Ok(finish(Data::Statemachine(Statemachine { drives }), failures, succeeded, Vec::new()))
}

async fn show(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Row<StateReport>, Failure> {
    let mut target = target(session, settings, registry, address, false).await?;
    super::movable(&target.family)?;
    let mut reader = Reader::new(session, &mut target);
    let status = reader.vital_role("status-word").await?.and_then(|value| value.word);
    let InForce { value: control_mode, stored: control_mode_stored } = reader.in_force("control-mode").await?;
    let control = reader.role("control-word").await?.and_then(|value| value.word);
    let fault = reader.vital_role("fault").await?.and_then(|value| value.raw);
    let (failures, good) = reader.into_failures();
    let present = status.as_ref().zip(fault);
    let fault = present.map(|(word, code)| target.family.present_fault(Some(word.raw), code as u32).unwrap_or(0));
    let missing = match status.as_ref().filter(|_| failures.is_empty()) {
        Some(word) => {
            let around = surroundings(session, &mut target, word.raw).await?;
            missing(&Situation { fault: fault.map(i64::from), ..around }, &target)
        }
        None => Vec::new(),
    };
    let state = status.as_ref().and_then(|word| word.state.clone());
    let report = StateReport {
        address,
        drive: target.family.drive.clone(),
        states: states(&target.family, state.as_ref().map_or("", |state| &state.slug)),
        state,
        status,
        control,
        control_mode,
        control_mode_stored,
        fault: fault.and_then(|code| describe::fault(&target.family, code)),
        fault_code: fault.map(i64::from),
        missing,
        error: None,
    };
    Ok((report, failures, good))
}

/// The map of the state machine: every state, where it leads, and which is the present one.
fn states(family: &Family, present: &str) -> Vec<StateRow> {
    let order =
        ["switch-on-disabled", "ready-to-switch-on", "switched-on", "operation-enabled", "quick-stop-active", "fault"];
    let name = |slug: &str| family.states.iter().find(|row| row.slug == slug).map(DriveState::text);
    let row = |slug: &&str| {
        let leads = family.machine.transitions.iter().filter(|transition| transition.from == *slug);
        let leads = leads.map(|transition| {
            let by = transition.command.as_ref().map_or_else(|| both!("by itself", "von selbst"), Text::name);
            let to = name(&transition.to).unwrap_or_else(|| Text::name(&transition.to));
            both!("{number} {by} -> {to}", "{number} {by} -> {to}", number = transition.number, by, to)
        });
        Some(StateRow {
            slug: (*slug).to_owned(),
            name: name(slug)?,
            present: *slug == present,
            leads: leads.collect(),
        })
    };
    order.iter().filter_map(row).collect()
}
