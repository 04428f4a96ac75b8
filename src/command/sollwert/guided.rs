//! A run that a procedure leads: what `sollwert` does with a setpoint, on a line that is open already.

use super::check::Check;
use super::{Args, Giving, Until, dry, spoken, understand};
use crate::args::{KeypadArgs, MotionArgs, Settings};
use crate::command::profibus::SlaveArgs;
use crate::command::running::{self, Around, Plan};
use crate::drive::motion::{Keeps, Motor, Promise, look};
use crate::drive::{Session, Target};
use crate::failure::Failure;
use crate::gate::Question;
use crate::outcome::{Outcome, TelegramDoc};
use crate::profile::{Family, Param};
use crate::text::Text;

impl Args {
    /// A run at a setpoint that is waited for, which nothing is added to.
    pub(in crate::command) fn run_at(setpoint: &str, motion: MotionArgs) -> Self {
        Args {
            value: Some(setpoint.to_owned()),
            mode: None,
            options: Vec::new(),
            start: None,
            until: Some(Until::Reached),
            enable: true,
            source: Some("line".to_owned()),
            ramp: None,
            profile: None,
            jog: None,
            force: false,
            motion,
            keypad: Box::new(KeypadArgs { step: None, min: None, max: None }),
            slave: SlaveArgs::default(),
        }
    }
}

/// A run that a procedure leads.
pub(in crate::command) struct Led<'l> {
    /// The setpoint, and how the run is bounded.
    pub(in crate::command) args: &'l Args,
    /// What is asked besides.
    pub(in crate::command) question: Question,
    /// What is set for the run, raw, read back before anything turns, and given back at the end.
    pub(in crate::command) settings: &'l [(Param, i64)],
    /// Who keeps what is changed for the run, before it is.
    pub(in crate::command) keeps: Option<Keeps<'l>>,
}

/// Asks, runs, does something more, stops and reports. `begins` is called when somebody agreed, before anything is sent that moves.
pub(in crate::command) async fn led(
    session: &mut Session<'_>,
    around: &mut Around<'_>,
    address: u8,
    Led { args, question, settings, keeps }: Led<'_>,
    begins: impl FnOnce() -> Result<(), Failure>,
    then: impl AsyncFnOnce(&mut Motor<'_, '_>) -> Result<(), Failure>,
) -> Result<Outcome, Failure> {
    let Some(spoken) = spoken(args)? else { return Ok(Outcome::default()) };
    let panel = around.interrupt.panel().clone();
    // What has no time of its own is held by what is done then.
    let motion = MotionArgs { hold: args.motion.duration.is_some(), ..args.motion.clone() };
    let giving = Giving { args, spoken: &spoken, motion: &motion, panel: &panel, enable: true, bare: false };
    let plan = Plan { runs: true, keeps, ..Plan::of("procedure", Text::default(), &args.motion) };
    running::on_line(
        session,
        around,
        address,
        plan,
        async |session, target, before, plan| {
            let checked = giving.check(session, target, before, plan).await?;
            plan.announce = Text::join([&question.title, &plan.announce], ": ");
            plan.details.splice(0..0, question.details);
            Ok(checked)
        },
        async |motor, checked| {
            begins()?;
            for (param, raw) in settings {
                motor.adjust(param, *raw).await?;
            }
            giving.work(motor, checked).await?;
            motor.counts_no_more();
            then(motor).await
        },
    )
    .await
}

/// Whether the drive's own bounds let a run reach its setpoint: asked long before it is.
pub(in crate::command) async fn fits(
    session: &mut Session<'_>,
    target: &mut Target,
    args: &Args,
) -> Result<(), Failure> {
    let Some(spoken) = spoken(args)? else { return Ok(()) };
    let wanted = understand(args, &spoken, &target.family)?;
    let before = look(session, target).await?;
    let promise = Promise::read(session, target, &wanted.mode, &wanted.settings).await?;
    let check = Check { args, session, target, before: &before };
    check.limit(&wanted, promise.own, 0).map(drop)
}

/// What a run would send.
pub(in crate::command) fn rehearse(args: &Args, family: &Family, settings: &Settings, address: u8) -> Vec<TelegramDoc> {
    let wanted = spoken(args).ok().flatten().and_then(|said| understand(args, &said, family).ok());
    let Some(wanted) = wanted else { return Vec::new() };
    dry::one(args, family, &wanted, (settings, address)).map_or_else(|_| Vec::new(), |told| told.telegrams())
}
