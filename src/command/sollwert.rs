//! `sollwert`: setpoints and actual values side by side, and giving a setpoint.

mod check;
mod dry;
mod guided;
mod over_profibus;
mod shown;
mod told;
mod unit;
mod wanted;
mod zero;

use super::lines::OverLines;
use super::profibus::SlaveArgs;
use super::running::leads::Leads;
use super::running::{self, Plan};
use super::verb::{Flow, Verb, Working};
use super::{Context, offline, offline_family};
use crate::args::{KeypadArgs, MotionArgs, Takes, below_zero, parse_span};
use crate::drive::motion::{self, Motor, Situation};
use crate::drive::{Panel, Session, Target, Upper};
use crate::failure::{Class, Failure};
use crate::gate::Relief;
use crate::outcome::{Document, OrLines, OrMotion, OrRecord, Outcome, Sollwert};
use crate::profile::Family;
use crate::text::{Text, both};
use crate::tick::Span;
use check::Check;
use clap::{Args as ClapArgs, ValueEnum};
pub(in crate::command) use guided::{Led, fits, led, rehearse};
use std::path::PathBuf;
use told::{announce, begins_later, tells_more};
use wanted::{Spoken, Wanted, spoken, understand};

/// Shows setpoint and actual value, or gives one.
///
/// Without a value it only reads: setpoints, actual values, and what decides how the setpoint is formed. With a value it
/// asks, and then writes it; a plain 0 only takes motion away and asks nobody, unless it changed the operating mode or
/// left another setpoint that turns the shaft the other way, and stops several drives too (-a 1-5, -a all). Its unit says what it is a setpoint of: 25Hz, -12,5Hz, 30%, 1450rpm on an ACTIVE (line
/// setpoint P.484 or P.524, in RAM); 1000rpm, 48usr, 10A, 2/3 on an LXM05, or --mode names it. --enable walks the state
/// machine first; --hold bounds the run to this program.
///
/// Over PROFIBUS (--protocol dp) a motor runs only while data are exchanged: Hz or %, with --enable --hold, or --jog, and in one direction.
/// --mode basic or profidrive says by which words.
///
/// What the drive makes of it by its own settings (an ACTIVE adds its internal setpoint with P.434 = 3, and bounds it by
/// P.418 and P.419) is worked out and told before you are asked. What stands in a drive from before and would turn the
/// shaft is set to 0 before it is enabled.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// 25Hz, -12,5Hz, 30%, 1450rpm, 48usr, 10A, 2/3
    ///
    /// With --mode also without a unit.
    #[arg(value_name = "SETPOINT", allow_negative_numbers = true, value_parser = below_zero::word)]
    pub value: Option<String>,

    /// What is set, where the unit does not tell
    ///
    /// frequency, percent (ACTIVE); velocity, position, homing, current, speed, gear, jog (LXM05). PROFIBUS: how the slave is led, basic
    /// or profidrive, else as Get_Cfg tells.
    #[arg(long, value_name = "MODE", hide_short_help = true)]
    pub mode: Option<String>,

    /// Set a parameter first, such as RAMPacc=2000
    ///
    /// One of the mode. With --hold it is given back. PROFIBUS: the ramps of the Basic block, F002=5s and F003=5s.
    #[arg(long = "set", value_name = "PARAMETER=VALUE", hide_short_help = true)]
    pub options: Vec<String>,

    /// absolute (default) or relative
    ///
    /// How the movement starts, in modes that need it.
    #[arg(long, value_name = "START", hide_short_help = true)]
    pub start: Option<String>,

    /// Wait until the setpoint is `reached`
    ///
    /// Waits before the program goes on (status bit 10); the time of --duration begins there.
    #[arg(long, value_name = "WHAT", hide_possible_values = true, hide_short_help = true)]
    pub until: Option<Until>,

    /// Walk to "operation enabled" first
    #[arg(long)]
    pub enable: bool,

    /// ACTIVE: line or sum forms the setpoint
    ///
    /// Set for the run, in RAM. P.434: line = line setpoint only, sum = internal and line setpoint added.
    #[arg(long, value_name = "SOURCE", hide_short_help = true)]
    pub source: Option<String>,

    /// Lead the setpoint, such as 0Hz:50Hz:20s
    ///
    /// On a straight line: FROM:TO:TIME. Its last setpoint is held until --duration is over, or until Ctrl-C.
    #[arg(long, value_name = "FROM:TO:TIME", allow_hyphen_values = true, value_parser = below_zero::word, conflicts_with_all = ["value", "profile"])]
    pub ramp: Option<String>,

    /// Lead the setpoint by lines such as `5s, 25Hz`
    ///
    /// TIME, SETPOINT: at this time this setpoint. The last one is held until --duration is over, or until Ctrl-C.
    #[arg(long, value_name = "FILE", conflicts_with = "value", hide_short_help = true)]
    pub profile: Option<PathBuf>,

    /// Enable, run for this time, stop
    ///
    /// The same as --enable --hold --duration TIME.
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "value", conflicts_with_all = ["hold", "duration", "until"])]
    pub jog: Option<Span>,

    /// Give also a setpoint beyond its limit
    ///
    /// The drive judges it.
    #[arg(long, hide_short_help = true)]
    pub force: bool,

    /// How the run is bounded.
    #[command(flatten)]
    pub motion: MotionArgs,

    /// What the arrows of its keypad do.
    #[command(flatten)]
    pub keypad: Box<KeypadArgs>,

    /// How a slave is taken.
    #[command(flatten)]
    pub slave: SlaveArgs,
}

/// What to wait for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Until {
    /// The drive reports the setpoint as reached.
    Reached,
}

impl Verb for Args {
    const NAME: &'static str = "sollwert";
    const TAKES: Takes = Takes::WRITES;
    const PROFIBUS: bool = true;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1 sollwert",
        "antrieb --port sim -a 1 sollwert 25Hz --jog 5s --take-control --yes",
        "antrieb --port sim -a 1 sollwert --ramp 0Hz:9Hz:5s --hold --enable --dry-run",
        "antrieb -p sim -a 1 sollwert 9Hz --enable --hold --view --step 1Hz --dry-run",
        "antrieb --port sim -a 1 sollwert 0Hz",
        "antrieb -p sim --protocol dp -a 3 sollwert 20Hz --jog 5s --take-control --yes",
    ];
    const UPPER: Upper = Upper::drive(60).besides(motion::WAITS).unless(
        "A shaft that still becomes faster or slower is waited for as well, at most 10 min for each ramp, and --hold for \
         --duration or Ctrl-C. A plain 0 is said at once, and ends within 20 s unless the shaft becomes slower; several \
         drives together within 20 s for each of them.",
    );
    const ALIAS: Option<&'static str> = Some("setpoint");
    const TURNS: bool = true;
    type Prints = OrRecord<Document<OrMotion<OrLines<Sollwert>>>>;

    fn streams(&self) -> Option<Flow> {
        let is_held = self.motion.hold || self.jog.is_some() || self.ramp.is_some() || self.profile.is_some();
        is_held.then_some(Flow::Run { view: self.motion.wants_keys() })
    }

    fn over_lines(&self) -> OverLines {
        match self.value.as_deref() {
            Some(value) if zero::is_said(value) => OverLines::Itself,
            None if self.streams().is_none() => OverLines::Each,
            _ => OverLines::One(Some(running::one_by_one())),
        }
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Shows the setpoints of every drive that was named, or gives one.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if args.slave.is_meant(context.settings)? {
        return over_profibus::run(args, context).await;
    }
    super::movable(&*offline_family(context.settings, context.registry)?)?;
    let Some(spoken) = spoken(args)? else { return shown::show_all(context).await };
    // Refused before the port is opened if no drive that it could be understands it.
    let understood = offline(context.settings, context.registry, |family| understand(args, &spoken, family));
    let whose = (context.settings.drive.is_some(), args.mode.as_deref().unwrap_or_default());
    let (family, wanted) = understood.map_err(|failure| unit::of_whom(failure, whose, context.registry))?;
    if context.settings.dry_run {
        return dry::run(args, &spoken, (&family, &wanted), context);
    }
    takes_what_it_needs(args, &wanted)?;
    let relief = zero::is_meant(args, &wanted).then_some(Relief::Zero);
    give(args, &spoken, (relief, zero::goes_first(args, &wanted)), context).await
}

/// A setpoint alone is obeyed whoever starts and stops the drive: control is taken for an enable only.
fn takes_what_it_needs(args: &Args, wanted: &Wanted) -> Result<(), Failure> {
    if !args.motion.take_control || args.enable || args.jog.is_some() || zero::is_aim(args, wanted) {
        return Ok(());
    }
    let message = both!(
        "--take-control needs --enable: a setpoint alone is obeyed whoever has control",
        "--take-control braucht --enable: ein Sollwert allein gilt, wer auch immer die Steuerung hat"
    );
    Err(Failure::new(Class::Usage, "usage.take_control", message)
        .hint(both!("add --enable, or leave --take-control out", "--enable angeben oder --take-control weglassen")))
}

async fn give(
    args: &Args,
    spoken: &Spoken,
    (relief, zero_first): (Option<Relief>, bool),
    context: &mut Context<'_>,
) -> Result<Outcome, Failure> {
    let mut motion = args.motion.clone();
    if args.jog.is_some() {
        (motion.hold, motion.duration) = (true, args.jog);
    }
    let panel = context.interrupt.panel().clone();
    let enable = args.enable || args.jog.is_some();
    let bare = spoken.is_bare_zero() && args.mode.is_none();
    let zeros = |family: &Family| zero::modes(args, bare, understand(args, spoken, family).ok(), family);
    let plan = || Plan {
        needs_control: enable,
        relief,
        runs: enable,
        zero: zero_first.then_some(&zeros as &running::Modes<'_>),
        ..Plan::of("sollwert", Text::default(), &motion)
    };
    let giving = Giving { args, spoken, motion: &motion, panel: &panel, enable, bare };
    let several = running::several(context.settings).filter(|addresses| !addresses.contains(&0));
    if let (Some(act), Some(_)) = (relief, several) {
        return running::stop_each(
            context,
            act,
            plan,
            async |session, target, before, plan| giving.check(session, target, before, plan).await,
            async |motor, checked| giving.work(motor, checked).await,
        )
        .await;
    }
    running::run(
        context,
        plan(),
        async |session, target, before, plan| giving.check(session, target, before, plan).await,
        async |motor, checked| giving.work(motor, checked).await,
    )
    .await
}

/// A setpoint on its way to a drive.
struct Giving<'g> {
    args: &'g Args,
    spoken: &'g Spoken,
    motion: &'g MotionArgs,
    panel: &'g Panel,
    enable: bool,
    /// A zero without a unit.
    bare: bool,
}

impl Giving<'_> {
    /// What it is for this drive, and whether it takes anything but motion away.
    async fn check(
        &self,
        session: &mut Session<'_>,
        target: &mut Target,
        before: &Situation,
        plan: &mut Plan<'_>,
    ) -> Result<(Wanted, Option<Relief>), Failure> {
        let Giving { args, motion, enable, .. } = *self;
        let mut wanted = understand(args, self.spoken, &target.family)?;
        if self.bare {
            let present = zero::present_mode(session, target).await?;
            wanted = present.map_or_else(|| wanted.clone(), |mode| wanted.clone().in_mode(&mode, &target.family));
        }
        plan.relief = match plan.relief.filter(|_| zero::is_meant(args, &wanted)) {
            // What went out needs no leave any more; what came of it is told.
            Some(act) if plan.said => Some(act),
            Some(_) => zero::relief(session, target, before, &wanted).await?,
            None => None,
        };
        plan.aim = match plan.relief {
            None if zero::is_aim(args, &wanted) => zero::relief(session, target, before, &wanted).await?,
            relief => relief,
        };
        if !self.bare && zero::is_aim(args, &wanted) {
            zero::demand_its_own(session, target, &wanted.mode).await?;
        }
        tells_more(session, target, plan, &wanted).await?;
        let waits = args.until.is_some() && motion.duration.is_some();
        plan.details.extend(waits.then(begins_later));
        plan.details.extend(wanted.start.as_ref().and_then(|start| start.note.clone()));
        let needs_control = enable && !motion.take_control;
        let mut check = Check { args, session, target, before };
        let (wanted, promise) = check.run(wanted, enable, needs_control).await?;
        plan.promises.extend(promise);
        plan.sets.extend(wanted.settings.iter().cloned());
        plan.announce = announce(&wanted, &target.family, enable);
        plan.details.extend(wanted.told_keys(&target.family));
        plan.keys = wanted.shown_keys();
        plan.setpoint = Some(wanted.param.clone());
        let aim = plan.aim;
        if zero::is_waited_for(args, &wanted, before) {
            // Its work is a run, since it changes the source, but it is judged as any other zero.
            plan.aim = Some(Relief::Zero);
        }
        Ok((wanted, aim))
    }

    async fn work(&self, motor: &mut Motor<'_, '_>, (wanted, aim): (Wanted, Option<Relief>)) -> Result<(), Failure> {
        match aim {
            Some(_) => motor.relieve_setpoint(&wanted.mode, &wanted.param).await,
            None if zero::changes_source(self.args, &wanted) && motor.is_enabled() => {
                let came = carry_out(motor, &wanted, (self.enable, true), self.motion, self.panel).await;
                // Like any other zero: that the shaft turns on is told, and stops nothing else.
                let turns = |failure: &Failure| failure.code == "no.not_reached";
                if came.as_ref().is_err_and(turns) { Ok(()) } else { came }
            }
            None => carry_out(motor, &wanted, (self.enable, self.args.until.is_some()), self.motion, self.panel).await,
        }
    }
}

/// Sets what the mode needs, enables, selects the mode, gives the setpoint, and waits or holds as asked.
async fn carry_out(
    motor: &mut Motor<'_, '_>,
    wanted: &Wanted,
    (enable, until_reached): (bool, bool),
    motion: &MotionArgs,
    panel: &Panel,
) -> Result<(), Failure> {
    let unit = wanted.param.unit.as_deref().unwrap_or("");
    motor.prepare(&wanted.mode);
    motor.expects = wanted.expects(wanted.schedule.at(u64::MAX));
    for (param, raw) in &wanted.settings {
        motor.change_param(param, *raw).await?;
    }
    let starts = enable && !motor.is_enabled();
    if wanted.mode.zero && (starts || wanted.mode.value.is_some()) {
        // A setpoint that still stands from before must not start the shaft; nor does 0 where the drive then turns by itself.
        let first = if enable && wanted.turns_at_zero() { wanted.schedule.at(0) } else { 0 };
        motor.give(&wanted.param, first, unit).await?;
    }
    let mut leads = Leads::new(&wanted.schedule, (wanted.keys, wanted.refused_key()), panel);
    // The time of the run is that of a movement too, unless somebody waits for its end first.
    let lasts = motion.duration.map(|span| span + leads.takes());
    let is_timed = motion.hold && !until_reached;
    if is_timed && enable && (wanted.turns_at_zero() || wanted.may_lift) {
        motor.will_hold(lasts);
    }
    if enable {
        motor.walk("operation-enabled").await?;
    }
    motor.enter().await?;
    if wanted.denominator.is_some() {
        // The shaft follows its guide as soon as that counts, at the ratio that stands in the drive then. Behind it the manual's own
        // sequence gives it (LXM05 manual 5.5.3).
        give_first(motor, wanted).await?;
    }
    match motion.hold {
        true if until_reached => motor.will_hold_there(motion.duration),
        true if wanted.start.is_none() => motor.will_hold(lasts),
        _ => {}
    }
    motor.make_it_count().await?;
    let given = give_first(motor, wanted).await;
    if wanted.denominator.is_some() { motor.or_over(given) } else { given }?;
    lead(motor, wanted, &mut leads).await?;
    if let Some(setpoint) = &mut motor.setpoint {
        setpoint.denominator = wanted.denominator.as_ref().map(|(_, raw)| *raw);
    }
    match &wanted.start {
        Some(start) => {
            if is_timed {
                motor.will_hold(lasts);
            }
            motor.travel(start).await?;
        }
        None if until_reached => {
            motor.until_reached().await?;
            as_told(motor, wanted)?;
        }
        None => {}
    }
    if motion.hold {
        hold(motor, wanted, if until_reached { motion.duration } else { lasts }, leads).await?;
    }
    Ok(())
}

/// Gives the first setpoint, and what belongs to it before.
async fn give_first(motor: &mut Motor<'_, '_>, wanted: &Wanted) -> Result<(), Failure> {
    if let Some((param, raw)) = &wanted.denominator {
        motor.set(param, *raw).await?;
    }
    motor.give(&wanted.param, wanted.schedule.at(0), wanted.param.unit.as_deref().unwrap_or("")).await
}

/// Gives the last setpoint again and again, or what the keypad has made of it.
async fn hold(
    motor: &mut Motor<'_, '_>,
    wanted: &Wanted,
    lasts: Option<Span>,
    mut leads: Leads<'_>,
) -> Result<(), Failure> {
    let mut given = leads.arrives();
    motor
        .hold(lasts, async |motor: &mut Motor<'_, '_>, _| {
            let (next, told) = leads.by_arrows();
            told.into_iter().for_each(|told| motor.tell(told));
            if next != given {
                if nudge(motor, wanted, next).await? {
                    given = next;
                    return Ok(());
                }
                leads.stays_at(given);
            }
            // Whatever keys come, it is given again.
            if wanted.mode.zero {
                motor.refresh(&wanted.param, given).await?;
            }
            Ok(())
        })
        .await
}

/// Gives another setpoint in a run that is held; `false`: the drive refuses it, and the one before stands.
async fn nudge(motor: &mut Motor<'_, '_>, wanted: &Wanted, raw: i64) -> Result<bool, Failure> {
    motor.expects = wanted.expects(raw);
    match motor.give(&wanted.param, raw, wanted.param.unit.as_deref().unwrap_or("")).await {
        Err(failure) if failure.class == Class::Refused => {
            motor.tell(failure.told());
            Ok(false)
        }
        given => given.map(|()| true),
    }
}

/// What a drive bends to its limits is not reached, whatever its own bit says.
fn as_told(motor: &mut Motor<'_, '_>, wanted: &Wanted) -> Result<(), Failure> {
    let last = wanted.schedule.at(u64::MAX);
    let Some(runs_at) = wanted.effective.filter(|total| total.bends(last)).and_then(|total| total.of(last)) else {
        return Ok(());
    };
    if let Some(setpoint) = &mut motor.setpoint {
        setpoint.reached = Some(false);
    }
    Err(motor.bent(last, runs_at))
}

/// Leads the setpoint along its schedule, as long as the drive goes there.
async fn lead(motor: &mut Motor<'_, '_>, wanted: &Wanted, leads: &mut Leads<'_>) -> Result<(), Failure> {
    let unit = wanted.param.unit.as_deref().unwrap_or("");
    if leads.takes() == Span::ZERO {
        return Ok(());
    }
    let mut last = wanted.schedule.at(0);
    motor.is_led(true);
    motor
        .hold(Some(leads.takes()), async |motor: &mut Motor<'_, '_>, gone| {
            let (value, told) = leads.on_its_way(gone);
            motor.expects = wanted.expects(value);
            if value != last {
                motor.give(&wanted.param, value, unit).await?;
                last = value;
            }
            told.into_iter().for_each(|told| motor.tell(told));
            Ok(())
        })
        .await?;
    motor.is_led(false);
    let value = leads.arrives();
    motor.expects = wanted.expects(value);
    if value == last {
        return Ok(());
    }
    let given = motor.give(&wanted.param, value, unit).await;
    motor.or_over(given)
}

/// What to do where a speed cannot be made a frequency.
fn in_hertz() -> Text {
    both!("give the setpoint in Hz", "den Sollwert in Hz angeben")
}
