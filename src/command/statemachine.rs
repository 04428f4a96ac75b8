//! `statemachine`: in which state is the drive, and walking it safely through its states.

use super::rehearse::Rehearsal;
use super::running::{self, Plan};
use super::verb::{Verb, Working};
use super::{Context, InForce, Reader, Row, each_drive, finish, offline_family, plan, role_questions, target};
use crate::args::{MotionArgs, Settings, StopArg};
use crate::drive::motion::{Motor, Situation, look, missing, no_control, no_fault, runs_at, upon_enabling};
use crate::drive::{Session, Target, describe};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Data, Document, ErrorDoc, Event, OrMotion, Outcome, StateReport, StateRow, Statemachine};
use crate::profile::{Family, Lang, Registry};
use clap::{Args as ClapArgs, Subcommand};

/// Shows the state of the drive, and walks it through its state machine.
///
/// `show` (the default) reads only: the state, status and control word bit by bit, who controls the drive, what is
/// missing to run, and where each state leads. `disable`, `disable-voltage` and `quick-stop` only take motion away and act
/// at once; everything else can turn the shaft and asks first. An ACTIVE obeys the
/// control word only with P.412 = 1 (--take-control) and with external enable and start contact given.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    #[command(subcommand)]
    action: Option<Action>,
}

#[derive(Clone, Debug, Subcommand)]
enum Action {
    /// Show state, words, control mode, what is missing (the default)
    Show,
    /// Shut down: to "ready to switch on"
    Shutdown(MotionArgs),
    /// Walk to "switched on"; the shaft does not turn yet
    SwitchOn(MotionArgs),
    /// Walk to "operation enabled": the motor is powered and follows its setpoint
    Enable(MotionArgs),
    /// Disable operation: transition 5, which coasts, brakes or ramps as P.392 says
    Disable(MotionArgs),
    /// Disable voltage: the shaft coasts
    DisableVoltage(MotionArgs),
    /// Quick stop: by the emergency ramps P.424 and P.425
    QuickStop(MotionArgs),
    /// Reset a fault: once, when the drive's 15 s lock has passed
    Reset(MotionArgs),
    /// Walk to a state, the shortest way
    Goto {
        /// switch-on-disabled, ready-to-switch-on, switched-on, operation-enabled
        state: String,
        #[command(flatten)]
        motion: MotionArgs,
    },
    /// Set virtual contacts through the control word (P.412 = 2): S1IND … S6IND, MFI1D, EM-S1IND … EM-S3IND
    Contacts {
        /// Contacts that are closed; all others are open
        contacts: Vec<String>,
        #[command(flatten)]
        motion: MotionArgs,
    },
}

/// Roles that are read, in this order.
const ROLES: [&str; 4] = ["status-word", "control-mode", "control-word", "fault"];

impl Verb for Args {
    const NAME: &'static str = "statemachine";
    const ALIAS: Option<&'static str> = Some("state");
    const TURNS: bool = true;
    type Prints = Document<OrMotion<Statemachine>>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Shows the state of every drive that was named, or walks one.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let lang = context.settings.lang;
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
        Some(Action::Contacts { contacts, motion }) => return set_contacts(context, contacts, motion).await,
    };
    let family = offline_family(context.settings, context.registry)?;
    let command = family.machine.command(slug).cloned();
    let command = command.ok_or_else(|| Failure::new(Class::Data, "data.machine", format!("no command '{slug}'")))?;
    let relief = relief_of(slug).filter(|_| Plan::only_relieves(motion));
    if context.settings.dry_run {
        return dry_run(context, &family, motion, true, relief.map(|_| slug), |told| match slug {
            "enable" => told.walk("operation-enabled"),
            "switch-on" => told.walk("switched-on"),
            slug => told.command(slug),
        });
    }
    let plan = Plan {
        action: slug,
        announce: command.name(lang).to_owned(),
        details: Vec::new(),
        args: motion,
        needs_control: true,
        relief,
        runs: slug == "enable",
        zero: None,
        said: false,
    };
    let hold = motion.hold.then_some(motion.duration);
    running::run(
        context,
        plan,
        async |session, target, before, plan| {
            if plan.relief.is_some() {
                return Ok(());
            }
            obeyed(target, before, plan, lang)?;
            if slug == "reset" && !before.state.starts_with("fault") {
                return Err(no_fault(lang));
            }
            if slug == "enable" { enabling(session, target, before, plan, lang).await } else { Ok(()) }
        },
        async |motor, ()| {
            match (slug, relief_of(slug)) {
                (_, Some(act)) => motor.relieve(act).await?,
                ("enable", _) => motor.walk("operation-enabled").await?,
                ("switch-on", _) => motor.walk("switched-on").await?,
                ("reset", _) => motor.reset().await?,
                (other, _) => motor.command(other).await?,
            }
            if let (Some(duration), "enable") = (hold, slug) {
                motor.hold(duration, async |_: &mut Motor<'_, '_>, _| Ok(())).await?;
            }
            Ok(())
        },
    )
    .await
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
fn obeyed(target: &Target, before: &Situation, plan: &Plan<'_>, lang: Lang) -> Result<(), Failure> {
    let refused = no_control(before, target, lang).filter(|_| !plan.args.take_control);
    match (refused, &target.family.motion.other_resets) {
        (None, _) => Ok(()),
        (Some(failure), Some(ways)) if plan.action == "reset" => {
            let hint = failure.hint.clone().unwrap_or_default();
            Err(failure.hint(format!("{}; {}", ways.get(lang), hint.get(lang))))
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
    lang: Lang,
) -> Result<(), Failure> {
    if before.state != "operation-enabled" {
        let told = upon_enabling(session, target, lang).await?;
        told.iter().for_each(|text| session.tell(Event::Note(text.clone().into())));
        plan.details.extend(told);
    }
    Ok(())
}

async fn go_to(context: &mut Context<'_>, state: &str, motion: &MotionArgs) -> Result<Outcome, Failure> {
    let lang = context.settings.lang;
    let family = offline_family(context.settings, context.registry)?;
    let Some(row) = family.states.iter().find(|row| row.slug == state) else {
        let known: Vec<_> = family.states.iter().map(|row| row.slug.as_str()).collect();
        let message = match lang {
            Lang::En => format!("there is no state '{state}' (expected: {})", known.join(", ")),
            Lang::De => format!("es gibt keinen Zustand '{state}' (möglich: {})", known.join(", ")),
        };
        return Err(Failure::new(Class::Usage, "usage.state", message));
    };
    if context.settings.dry_run {
        return dry_run(context, &family, motion, true, None, |told| told.walk(state));
    }
    let announce = format!("{} '{}'", lang.pick("walk to", "gehen nach"), row.name(lang));
    let (hold, runs) = (motion.hold.then_some(motion.duration), state == "operation-enabled");
    let plan = Plan {
        action: "goto",
        announce,
        details: Vec::new(),
        args: motion,
        needs_control: true,
        relief: None,
        runs,
        zero: None,
        said: false,
    };
    running::run(
        context,
        plan,
        async |session, target, before, plan| {
            obeyed(target, before, plan, lang)?;
            if runs { enabling(session, target, before, plan, lang).await } else { Ok(()) }
        },
        async |motor, ()| {
            motor.walk(state).await?;
            if let (Some(duration), true) = (hold, runs) {
                motor.hold(duration, async |_: &mut Motor<'_, '_>, _| Ok(())).await?;
            }
            Ok(())
        },
    )
    .await
}

/// Closes virtual contacts by name. They act only with the hardware enable given (CM-485 manual 9.1.3, 10.1).
async fn set_contacts(context: &mut Context<'_>, contacts: &[String], motion: &MotionArgs) -> Result<Outcome, Failure> {
    let lang = context.settings.lang;
    let family = offline_family(context.settings, context.registry)?;
    let word = contact_word(&family, contacts, lang)?;
    if motion.hold && motion.on_exit == StopArg::QuickStop {
        let text = lang.pick("contacts know no quick stop", "Kontakte kennen keinen Schnellhalt");
        return Err(Failure::new(Class::Usage, "usage.on_exit", text).hint(lang.pick(
            "--on-exit ramp opens the start contacts first, --on-exit coast opens all at once",
            "--on-exit ramp öffnet zuerst die Startkontakte, --on-exit coast alle zugleich",
        )));
    }
    if context.settings.dry_run {
        return dry_run(context, &family, motion, false, None, |told| {
            let control = family.motion.control.filter(|_| motion.take_control);
            if let (Some(control), Some(param)) = (control, family.role("control-mode")) {
                told.change(param, control.contacts);
            }
            told.control(word);
        });
    }
    let shown = if contacts.is_empty() { "-".to_owned() } else { contacts.join(" ") };
    let announce = format!(
        "{}: {shown}",
        lang.pick("close these contacts, open all others", "diese Kontakte schließen, alle anderen öffnen")
    );
    let plan = Plan {
        action: "contacts",
        announce,
        details: Vec::new(),
        args: motion,
        needs_control: false,
        relief: None,
        runs: false,
        zero: None,
        said: false,
    };
    let (hold, take) = (motion.hold.then_some(motion.duration), motion.take_control);
    running::run(
        context,
        plan,
        async |session, target, before, plan| {
            if plan.args.hold {
                plan.details.push(opened(plan.args.on_exit, lang).to_owned());
            }
            let Some(control) = target.family.motion.control else {
                let text =
                    lang.pick("this drive has no virtual contacts", "dieser Antrieb hat keine virtuellen Kontakte");
                return Err(Failure::new(Class::Forbidden, "forbidden.no_contacts", text));
            };
            if before.mode == Some(control.contacts) || take {
                if word != 0 {
                    let told = runs_at(session, target, lang).await?;
                    told.iter().for_each(|text| session.tell(Event::Note(text.clone().into())));
                    plan.details.extend(told);
                }
                return Ok(control.contacts);
            }
            let mode = before.mode.map_or_else(|| "?".to_owned(), |mode| mode.to_string());
            let label = target.family.role_label("control-mode");
            let needed = control.contacts;
            let text = match lang {
                Lang::En => {
                    format!("the drive does not listen to virtual contacts: {label} is {mode}, it must be {needed}")
                }
                Lang::De => {
                    format!("der Antrieb hört nicht auf virtuelle Kontakte: {label} ist {mode}, nötig ist {needed}")
                }
            };
            Err(Failure::new(Class::Forbidden, "forbidden.control_mode", text).hint(lang.pick(
                "--take-control sets it in RAM for the run and gives it back",
                "--take-control stellt es für den Lauf im RAM um und danach zurück",
            )))
        },
        async |motor, contacts| {
            if take {
                motor.change("control-mode", contacts).await?;
            }
            motor.contacts(word).await?;
            if let Some(duration) = hold {
                motor.hold(duration, async |_: &mut Motor<'_, '_>, _| Ok(())).await?;
            }
            Ok(())
        },
    )
    .await
}

/// What each way to stop is where contacts decide.
fn opened(stop: StopArg, lang: Lang) -> &'static str {
    match stop {
        StopArg::Ramp => lang.pick(
            "at the end the start contacts S2IND and S3IND open, the enable only once the drive is without power",
            "am Ende öffnen die Startkontakte S2IND und S3IND, die Freigabe erst, wenn der Antrieb ohne Strom ist",
        ),
        StopArg::Coast | StopArg::QuickStop => {
            lang.pick("at the end all contacts open, and the shaft coasts", "am Ende öffnen alle, die Welle läuft aus")
        }
        StopArg::Keep => lang.pick("the contacts stay closed", "die Kontakte bleiben geschlossen"),
    }
}

/// The control word whose bits are the contacts with these names.
fn contact_word(family: &Family, contacts: &[String], lang: Lang) -> Result<u16, Failure> {
    let param = family.role("control-word");
    let param = param.ok_or_else(|| Failure::new(Class::Data, "data.role", "this drive has no control word"))?;
    let bits = family.word(param, 0, |_| Some(2));
    let fold = |name: &str| name.to_uppercase().replace(['-', '_', ' '], "");
    let mut word = 0;
    for contact in contacts {
        let bit = bits.iter().find(|bit| bit.row.is_some_and(|row| fold(&row.en) == fold(contact)));
        let bit = bit.ok_or_else(|| {
            let known: Vec<_> = bits.iter().filter_map(|bit| bit.row.map(|row| row.en.as_str())).collect();
            let message = match lang {
                Lang::En => format!("there is no contact '{contact}' (expected: {})", known.join(", ")),
                Lang::De => format!("es gibt keinen Kontakt '{contact}' (möglich: {})", known.join(", ")),
            };
            Failure::new(Class::Usage, "usage.contact", message)
        })?;
        word |= 1 << bit.bit;
    }
    Ok(word)
}

/// What a run would send: what it reads first, what the options set, the way, and its end.
fn dry_run(
    context: &Context<'_>,
    family: &Family,
    motion: &MotionArgs,
    needs_control: bool,
    stops: Option<&str>,
    way: impl FnOnce(&mut Rehearsal<'_>),
) -> Result<Outcome, Failure> {
    let address = running::single_address(context)?;
    let mut told = match stops {
        Some(slug) => Rehearsal::stopping(context.settings, family, address, slug),
        None => Rehearsal::new(context.settings, family, address),
    };
    told.bounds(motion, needs_control)?;
    way(&mut told);
    told.end(motion, None);
    Ok(told.told())
}

async fn show_all(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let family = offline_family(context.settings, context.registry)?;
        return plan(context, &family, &role_questions(&family, &ROLES));
    }
    let (drives, failures, succeeded) = each_drive(
        context,
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            show(session, settings, registry, address).await
        },
        |address, failure: &Failure| StateReport {
            address,
            drive: "unknown".to_owned(),
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
    Ok(finish(Data::Statemachine(Statemachine { drives }), failures, succeeded, Vec::new(), context.settings.lang))
}

async fn show(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Row<StateReport>, Failure> {
    let lang = settings.lang;
    let mut target = target(session, settings, registry, address, false).await?;
    let mut reader = Reader::new(session, &mut target, settings.lang);
    let status = reader.vital_role("status-word").await?.and_then(|value| value.word);
    let InForce { value: control_mode, stored: control_mode_stored } = reader.in_force("control-mode").await?;
    let control = reader.role("control-word").await?.and_then(|value| value.word);
    let fault = reader.vital_role("fault").await?.and_then(|value| value.raw);
    let present = status.as_ref().zip(fault).map(|(word, code)| (word.raw, code as u32));
    let (failures, good) = reader.into_failures();
    let missing = if failures.is_empty() {
        let mut situation = look(session, &mut target, lang).await?;
        // The first reading is the newest entry, where each moves on to the one before.
        situation.fault = present.map(|(status, code)| target.family.present_fault(status, code).unwrap_or(0).into());
        missing(&situation, &target, lang)
    } else {
        Vec::new()
    };
    let state = status.as_ref().and_then(|word| word.state.clone());
    let fault = present.map(|(status, code)| target.family.present_fault(status, code).unwrap_or(0));
    let report = StateReport {
        address,
        drive: target.family.drive.clone(),
        states: states(&target.family, state.as_ref().map_or("", |state| &state.slug), lang),
        state,
        status,
        control,
        control_mode,
        control_mode_stored,
        fault: fault.and_then(|code| describe::fault(&target.family, code, lang)),
        fault_code: fault.map(i64::from),
        missing,
        error: None,
    };
    Ok((report, failures, good))
}

/// The map of the state machine: every state, where it leads, and which is the present one.
fn states(family: &Family, present: &str, lang: Lang) -> Vec<StateRow> {
    let order =
        ["switch-on-disabled", "ready-to-switch-on", "switched-on", "operation-enabled", "quick-stop-active", "fault"];
    let name = |slug: &str| family.states.iter().find(|row| row.slug == slug).map(|row| row.name(lang).to_owned());
    let row = |slug: &&str| {
        let leads = family.machine.transitions.iter().filter(|transition| transition.from == *slug);
        let leads = leads.map(|transition| {
            let by = transition.command.as_deref().unwrap_or(lang.pick("by itself", "von selbst"));
            format!("{} {by} -> {}", transition.number, name(&transition.to).unwrap_or_else(|| transition.to.clone()))
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
