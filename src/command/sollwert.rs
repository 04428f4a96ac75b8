//! `sollwert`: setpoints and actual values side by side, and giving a setpoint.

use super::running::{self, Plan};
use super::{Context, Reader, Row, each_drive, finish, offline_family, plan, role_questions, target, telegram_reader};
use crate::args::{MotionArgs, Settings, parse_span};
use crate::drive::motion::{Motor, Situation, role_raw, working_raw};
use crate::drive::{Inquiry, RegisterAddress, Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::{self, Data, ErrorDoc, Outcome, SetpointReport, Sollwert, Value};
use crate::profile::setpoint::{self, Quantity, Schedule};
use crate::profile::value::format_decimal;
use crate::profile::{Lang, Param, Registry, Type};
use crate::tick::Span;
use clap::{Args as ClapArgs, ValueEnum};
use std::path::{Path, PathBuf};

/// Shows setpoints and actual values side by side, or gives a setpoint.
///
/// Without a value it only reads: setpoints (P.228, P.282, P.283, P.229), actual values, and what decides how the
/// setpoint is formed (P.434, limits). With a value (25Hz, -12,5Hz, 30%, 1450rpm) it writes the line setpoint (P.484 or
/// P.524, in RAM) after asking. --enable walks the state machine first; --hold bounds the run to this program.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// The setpoint: 25Hz, -12,5Hz, 30%, 1450rpm
    #[arg(value_name = "SETPOINT", allow_hyphen_values = true)]
    pub value: Option<String>,

    /// Wait for something before the program goes on: `reached` (status bit 10, P.549)
    #[arg(long, value_name = "WHAT")]
    pub until: Option<Until>,

    /// Walk the state machine to "operation enabled" first
    #[arg(long)]
    pub enable: bool,

    /// Set P.434 for the run, in RAM: line = line setpoint only, sum = internal and line setpoint added
    #[arg(long, value_name = "SOURCE")]
    pub source: Option<Source>,

    /// Lead the setpoint on a straight line: FROM:TO:TIME, such as 0Hz:50Hz:20s
    #[arg(long, value_name = "FROM:TO:TIME", allow_hyphen_values = true, conflicts_with_all = ["value", "profile"])]
    pub ramp: Option<String>,

    /// Lead the setpoint by a file of lines `TIME, SETPOINT`, such as `5s, 25Hz`
    #[arg(long, value_name = "FILE", conflicts_with = "value")]
    pub profile: Option<PathBuf>,

    /// Enable, run for this time, stop: the same as --enable --hold --duration TIME
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "value", conflicts_with_all = ["hold", "duration"])]
    pub jog: Option<Span>,

    /// Give also a setpoint beyond P.419, and let the drive judge
    #[arg(long)]
    pub force: bool,

    /// How the run is bounded.
    #[command(flatten)]
    pub motion: MotionArgs,
}

/// What to wait for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Until {
    /// The drive reports the setpoint as reached.
    Reached,
}

/// What the ramp gets its setpoint from (P.434).
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Source {
    /// 2: line setpoint.
    Line,
    /// 3: internal setpoint and line setpoint, added.
    Sum,
}

const SETPOINTS: [&str; 4] = ["setpoint-internal", "setpoint-bus", "setpoint-ramp", "percent-reference"];
const ACTUAL: [&str; 5] = ["actual-frequency", "stator-frequency", "encoder-frequency", "encoder-speed", "current"];
const SOURCES: [&str; 5] = ["ramp-setpoint", "frequency-source", "percent-source", "min-frequency", "max-frequency"];

/// P.434: the internal setpoint only, so the line setpoint is ignored (CM-485 manual 9.2.1).
const INTERNAL_ONLY: i64 = 1;
/// P.434: the line setpoint only (CM-485 manual 9.2.1).
const LINE_ONLY: i64 = 2;
/// P.434: both added (CM-485 manual 9.2.1).
const BOTH: i64 = 3;

/// Shows the setpoints of every drive that was named, or gives one.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    match wanted(args, context.settings.lang)? {
        Some(wanted) => give(args, wanted, context).await,
        None => show_all(context).await,
    }
}

/// A setpoint as it was asked for: of what, and how it changes with time.
#[derive(Clone, Debug)]
struct Wanted {
    quantity: Quantity,
    schedule: Schedule,
}

fn wanted(args: &Args, lang: Lang) -> Result<Option<Wanted>, Failure> {
    let parse = |text: &str| setpoint::parse(text).map_err(|error| bad(error.to_string()));
    if let Some(text) = &args.value {
        let (quantity, raw) = parse(text)?;
        return Ok(Some(Wanted { quantity, schedule: Schedule::ramp(raw, raw, 0) }));
    }
    if let Some(text) = &args.ramp {
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, time] = parts.as_slice() else {
            return Err(bad(format!("expected FROM:TO:TIME such as 0Hz:50Hz:20s, got '{text}'")));
        };
        let ((quantity, from), (other, to)) = (parse(from)?, parse(to)?);
        if quantity != other {
            return Err(bad(format!("'{text}' mixes {} and {}", quantity.unit(), other.unit())));
        }
        let time = parse_span(time).map_err(bad)?;
        return Ok(Some(Wanted { quantity, schedule: Schedule::ramp(from, to, time.as_micros()) }));
    }
    match &args.profile {
        Some(path) => read_profile(path).map(Some),
        None if args.enable || args.until.is_some() || args.motion.hold => {
            let text = lang.pick("expected a setpoint such as 25Hz, got none", "Sollwert fehlt, zum Beispiel 25Hz");
            Err(bad(text.to_owned()))
        }
        None => Ok(None),
    }
}

fn bad(message: String) -> Failure {
    Failure::new(Class::Usage, "usage.setpoint", message)
}

/// Reads lines `TIME, SETPOINT`; the error names file and line.
fn read_profile(path: &Path) -> Result<Wanted, Failure> {
    let shown = path.display();
    let bad = |line: usize, why: &str| Failure::new(Class::Data, "data.profile", format!("{shown}:{line}: {why}"));
    let text = std::fs::read_to_string(path).map_err(|error| bad(0, &error.to_string()))?;
    let (mut points, mut lines, mut quantity) = (Vec::new(), Vec::new(), None);
    for (index, line) in text.lines().enumerate() {
        let number = index + 1;
        let line = line.split('#').next().unwrap_or("").trim();
        if line.is_empty() {
            continue;
        }
        let (time, value) = line
            .split_once([',', ';', '\t'])
            .ok_or_else(|| bad(number, "expected TIME, SETPOINT such as '5s, 25Hz'"))?;
        let time = parse_span(time).map_err(|why| bad(number, &why))?;
        let (of, raw) = setpoint::parse(value).map_err(|error| bad(number, &error.to_string()))?;
        if *quantity.get_or_insert(of) != of {
            return Err(bad(number, "all setpoints of a profile must have the same unit"));
        }
        points.push((time.as_micros(), raw));
        lines.push(number);
    }
    let Some(quantity) = quantity else { return Err(bad(0, "no setpoint in the file")) };
    let schedule = Schedule::steps(points)
        .map_err(|point| bad(lines.get(point.saturating_sub(1)).copied().unwrap_or(0), "times must rise"))?;
    Ok(Wanted { quantity, schedule })
}

/// What was found out before anybody is asked.
struct Checked {
    param: Param,
    unit: &'static str,
    schedule: Schedule,
}

async fn give(args: &Args, wanted: Wanted, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let lang = context.settings.lang;
    if context.settings.dry_run {
        return dry_run(&wanted, context);
    }
    let mut motion = args.motion.clone();
    if args.jog.is_some() {
        (motion.hold, motion.duration) = (true, args.jog);
    }
    let enable = args.enable || args.jog.is_some();
    let announce = announce(&wanted, enable, lang);
    let plan = Plan { action: "sollwert", announce, args: &motion, needs_control: enable };
    let takes_control = motion.take_control;
    running::run(
        context,
        plan,
        async |session, target, before| {
            check(args, &wanted, enable && !takes_control, session, target, before, lang).await
        },
        async |motor, checked| {
            if let Some(source) = args.source {
                motor.change("ramp-setpoint", if source == Source::Line { LINE_ONLY } else { BOTH }).await?;
            }
            let first = checked.schedule.at(0);
            if enable {
                // A setpoint that still stands from before must not start the shaft.
                motor.give(&checked.param, 0, checked.unit).await?;
                motor.walk("operation-enabled").await?;
            }
            motor.give(&checked.param, first, checked.unit).await?;
            lead(motor, &checked).await?;
            if args.until == Some(Until::Reached) {
                motor.until_reached().await?;
            }
            if motion.hold {
                let last = checked.schedule.at(u64::MAX);
                motor
                    .hold(motion.duration, async |motor: &mut Motor<'_, '_>, _| {
                        motor.refresh(&checked.param, last).await
                    })
                    .await?;
            }
            Ok(())
        },
    )
    .await
}

/// Leads the setpoint along its schedule.
async fn lead(motor: &mut Motor<'_, '_>, checked: &Checked) -> Result<(), Failure> {
    let end = checked.schedule.end_us();
    if end == 0 {
        return Ok(());
    }
    let mut last = checked.schedule.at(0);
    motor
        .hold(Some(Span::from_micros(end)), async |motor: &mut Motor<'_, '_>, gone| {
            let value = checked.schedule.at(gone.as_micros());
            if value != last {
                last = value;
                motor.give(&checked.param, value, checked.unit).await?;
            }
            Ok(())
        })
        .await?;
    let value = checked.schedule.at(end);
    if value == last { Ok(()) } else { motor.give(&checked.param, value, checked.unit).await }
}

fn announce(wanted: &Wanted, enable: bool, lang: Lang) -> String {
    let unit = wanted.quantity.unit();
    let value = |raw: i64| format!("{} {unit}", format_decimal(raw, setpoint::DECIMALS));
    let (from, to) = (wanted.schedule.at(0), wanted.schedule.at(u64::MAX));
    let what = if wanted.schedule.end_us() == 0 { value(to) } else { format!("{} … {}", value(from), value(to)) };
    let setpoint = lang.pick("setpoint", "Sollwert");
    if enable {
        format!("{}, {setpoint} {what}", lang.pick("enable operation", "Betrieb freigeben"))
    } else {
        format!("{setpoint} {what}")
    }
}

/// Holds the setpoint against what the drive says, before anybody is asked.
async fn check(
    args: &Args,
    wanted: &Wanted,
    needs_control: bool,
    session: &mut Session<'_>,
    target: &mut Target,
    before: &Situation,
    lang: Lang,
) -> Result<Checked, Failure> {
    if needs_control && before.mode.is_some_and(|mode| mode != 1) {
        let mode = before.mode.unwrap_or_default();
        let text = match lang {
            Lang::En => format!("the drive is not controlled by the control word: P.412 is {mode}, it must be 1"),
            Lang::De => format!("der Antrieb hört nicht auf das Steuerwort: P.412 ist {mode}, nötig ist 1"),
        };
        return Err(Failure::new(Class::Forbidden, "forbidden.control_mode", text).hint(lang.pick(
            "--take-control sets it in RAM for the run and gives it back",
            "--take-control stellt es für den Lauf im RAM um und danach zurück",
        )));
    }
    let (role, unit) = match wanted.quantity {
        Quantity::Percent => ("setpoint-percent", "%"),
        Quantity::Frequency | Quantity::Speed => ("setpoint-frequency", "Hz"),
    };
    let param = target.family.role(role).cloned();
    let param = param.ok_or_else(|| Failure::new(Class::Data, "data.role", "this drive has no such setpoint"))?;
    let schedule = match wanted.quantity {
        Quantity::Speed => {
            let pairs = role_raw(session, target, "pole-pairs", lang).await?.filter(|&pairs| pairs > 0);
            let pairs = pairs.ok_or_else(|| {
                let text = lang.pick(
                    "the drive does not tell its pole pairs (P.373)",
                    "der Antrieb nennt seine Polpaarzahl (P.373) nicht",
                );
                Failure::new(Class::Data, "data.pole_pairs", text)
                    .hint(lang.pick("give the setpoint in Hz", "den Sollwert in Hz angeben"))
            })?;
            wanted.schedule.map(|raw| setpoint::frequency_of_speed(raw, pairs))
        }
        Quantity::Frequency | Quantity::Percent => wanted.schedule.clone(),
    };
    for raw in schedule.values().filter(|_| !args.force) {
        crate::profile::value::check_range(raw, &param).map_err(|error| {
            Failure::new(Class::Data, "data.range", format!("P.{}: {error}", param.id)).with("param", param.id)
        })?;
    }
    if wanted.quantity != Quantity::Percent {
        check_frequency(args, &schedule, session, target, lang).await?;
    }
    Ok(Checked { param, unit, schedule })
}

/// P.434 decides whether the line setpoint counts, P.419 bounds it, P.418 lifts it.
async fn check_frequency(
    args: &Args,
    schedule: &Schedule,
    session: &mut Session<'_>,
    target: &mut Target,
    lang: Lang,
) -> Result<(), Failure> {
    let present = working_raw(session, target, "ramp-setpoint", lang).await?;
    let source = match args.source {
        Some(Source::Line) => Some(LINE_ONLY),
        Some(Source::Sum) => Some(BOTH),
        None => present,
    };
    if source == Some(INTERNAL_ONLY) {
        let text = lang.pick(
            "the line setpoint is ignored: P.434 is 1 (internal setpoint only)",
            "der Liniensollwert wird ignoriert: P.434 ist 1 (nur interner Sollwert)",
        );
        return Err(Failure::new(Class::Forbidden, "forbidden.ramp_setpoint", text).hint(lang.pick(
            "--source line (2) or --source sum (3) sets it in RAM for the run",
            "--source line (2) oder --source sum (3) stellt es für den Lauf im RAM um",
        )));
    }
    let maximum = working_raw(session, target, "max-frequency", lang).await?;
    let minimum = working_raw(session, target, "min-frequency", lang).await?;
    let hz = |raw: i64| format!("{} Hz", format_decimal(raw, setpoint::DECIMALS));
    if let Some(maximum) = maximum.filter(|&maximum| schedule.peak() > maximum && !args.force) {
        let text = match lang {
            Lang::En => format!("{} is above the maximum frequency P.419 = {}", hz(schedule.peak()), hz(maximum)),
            Lang::De => format!("{} liegt über der maximalen Frequenz P.419 = {}", hz(schedule.peak()), hz(maximum)),
        };
        return Err(Failure::new(Class::Data, "data.range", text)
            .hint(lang.pick("--force sends it; the drive limits it", "--force sendet ihn; der Antrieb begrenzt ihn")));
    }
    if let (Some(LINE_ONLY), Some(minimum)) = (source, minimum.filter(|&minimum| minimum > 0))
        && schedule.values().any(|raw| raw.abs() < minimum)
    {
        let text = match lang {
            Lang::En => format!(
                "with P.434 = 2 the drive lifts the setpoint to P.418 = {}; at 0 it turns on in the last direction",
                hz(minimum)
            ),
            Lang::De => format!(
                "bei P.434 = 2 hebt der Antrieb den Sollwert auf P.418 = {} an; bei 0 dreht er in der letzten Richtung weiter",
                hz(minimum)
            ),
        };
        session.tell(outcome::Event::Note(text));
    }
    Ok(())
}

fn dry_run(wanted: &Wanted, context: &Context<'_>) -> Result<Outcome, Failure> {
    let address = running::single_address(context)?;
    let family = offline_family(context.settings, context.registry)?;
    if wanted.quantity == Quantity::Speed {
        let message = "a speed needs the drive's pole pairs (P.373), and a dry run asks no drive";
        return Err(Failure::new(Class::Usage, "usage.dry_run", message).hint("give the setpoint in Hz"));
    }
    let role = if wanted.quantity == Quantity::Percent { "setpoint-percent" } else { "setpoint-frequency" };
    let at = family.role(role).and_then(|param| RegisterAddress::new(param.id, 0));
    let at = at.ok_or_else(|| Failure::new(Class::Data, "data.role", "this drive has no such setpoint"))?;
    let reader = telegram_reader(context.settings, &family);
    let telegrams =
        wanted.schedule.values().map(|raw| reader.question(address, Inquiry::Write(at, Type::Long, raw as u32)));
    let mut telegrams: Vec<_> = telegrams.collect();
    telegrams.dedup_by(|a, b| a.hex == b.hex);
    Ok(Outcome::of(Data::Plan(outcome::Plan { dry_run: true, telegrams })))
}

async fn show_all(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let questions = role_questions(context, &[&SETPOINTS[..], &ACTUAL, &SOURCES].concat())?;
        return plan(context, &questions);
    }
    let (drives, failures, succeeded) = each_drive(
        context,
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            show(session, settings, registry, address).await
        },
        |address, failure: &Failure| SetpointReport {
            address,
            drive: "unknown".to_owned(),
            setpoints: Vec::new(),
            actual: Vec::new(),
            sources: Vec::new(),
            error: Some(ErrorDoc::from(failure)),
        },
    )
    .await?;
    Ok(finish(Data::Sollwert(Sollwert { drives }), failures, succeeded, Vec::new(), context.settings.lang))
}

async fn show(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Row<SetpointReport>, Failure> {
    let mut target = target(session, settings, registry, address, false).await?;
    let mut reader = Reader::new(session, &mut target, settings);
    let report = SetpointReport {
        address,
        drive: reader.target.family.drive.clone(),
        setpoints: roles(&mut reader, &SETPOINTS).await?,
        actual: roles(&mut reader, &ACTUAL).await?,
        sources: roles(&mut reader, &SOURCES).await?,
        error: None,
    };
    let (failures, good) = reader.into_failures();
    Ok((report, failures, good))
}

async fn roles(reader: &mut Reader<'_, '_, '_>, roles: &[&str]) -> Result<Vec<Value>, Failure> {
    let mut values = Vec::new();
    for role in roles {
        values.extend(reader.role(role).await?);
    }
    Ok(values)
}
