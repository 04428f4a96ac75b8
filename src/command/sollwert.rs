//! `sollwert`: setpoints and actual values side by side, and giving a setpoint.

use super::running::{self, Plan};
use super::{
    Context, Reader, Row, each_drive, finish, offline, offline_family, plan, read_question, target, telegram_reader,
};
use crate::args::{MotionArgs, Settings, parse_span};
use crate::drive::motion::{Motor, Situation, no_control, role_raw, working};
use crate::drive::{Cell, Inquiry, Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::{self, Data, ErrorDoc, Outcome, SetpointReport, Sollwert, Value};
use crate::profile::setpoint::{self, SPEED_DECIMALS, SPEED_UNIT, Schedule};
use crate::profile::value::{self, check_range, format_decimal};
use crate::profile::{DataSets, Family, Lang, Mode, Param, Registry, Start, Type};
use crate::tick::Span;
use clap::{Args as ClapArgs, ValueEnum};
use std::path::{Path, PathBuf};

/// Shows setpoints and actual values side by side, or gives a setpoint.
///
/// Without a value it only reads: setpoints, actual values, and what decides how the setpoint is formed. With a value it
/// asks, and then writes it. Its unit says what it is a setpoint of: 25Hz, -12,5Hz, 30%, 1450rpm on an ACTIVE (line
/// setpoint P.484 or P.524, in RAM); 1000rpm, 48usr, 10A, 2/3 on an LXM05, or --mode names it. --enable walks the state
/// machine first; --hold bounds the run to this program.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// The setpoint: 25Hz, -12,5Hz, 30%, 1450rpm, 48usr, 10A, 2/3; with --mode also without a unit
    #[arg(value_name = "SETPOINT", allow_hyphen_values = true)]
    pub value: Option<String>,

    /// What is set: frequency, percent (ACTIVE); velocity, position, homing, current, speed, gear, jog (LXM05)
    #[arg(long, value_name = "MODE")]
    pub mode: Option<String>,

    /// Set a parameter of the mode first, such as RAMPacc=2000; with --hold it is given back
    #[arg(long = "set", value_name = "PARAMETER=VALUE")]
    pub options: Vec<String>,

    /// How the movement starts, in modes that need it: absolute (default), relative
    #[arg(long, value_name = "START")]
    pub start: Option<String>,

    /// Wait for something before the program goes on: `reached` (status bit 10)
    #[arg(long, value_name = "WHAT")]
    pub until: Option<Until>,

    /// Walk the state machine to "operation enabled" first
    #[arg(long)]
    pub enable: bool,

    /// Set what forms the setpoint for the run, in RAM; ACTIVE P.434: line = line setpoint only, sum = internal and line
    /// setpoint added
    #[arg(long, value_name = "SOURCE")]
    pub source: Option<String>,

    /// Lead the setpoint on a straight line: FROM:TO:TIME, such as 0Hz:50Hz:20s
    #[arg(long, value_name = "FROM:TO:TIME", allow_hyphen_values = true, conflicts_with_all = ["value", "profile"])]
    pub ramp: Option<String>,

    /// Lead the setpoint by a file of lines `TIME, SETPOINT`, such as `5s, 25Hz`
    #[arg(long, value_name = "FILE", conflicts_with = "value")]
    pub profile: Option<PathBuf>,

    /// Enable, run for this time, stop: the same as --enable --hold --duration TIME
    #[arg(long, value_name = "TIME", value_parser = parse_span, requires = "value", conflicts_with_all = ["hold", "duration"])]
    pub jog: Option<Span>,

    /// Give also a setpoint beyond its limit, and let the drive judge
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

/// Shows the setpoints of every drive that was named, or gives one.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let Some(spoken) = spoken(args, context.settings.lang)? else { return show_all(context).await };
    // Refused before the port is opened if no drive that it could be understands it.
    let lang = context.settings.lang;
    let (family, wanted) =
        offline(context.settings, context.registry, |family| understand(args, &spoken, family, lang))?;
    if context.settings.dry_run {
        return dry_run(&family, &wanted, context);
    }
    give(args, &spoken, context).await
}

/// Setpoints as they were typed, with their times in microseconds.
#[derive(Clone, Debug)]
struct Spoken {
    points: Vec<Point>,
    /// A file leads the setpoint in steps.
    file: Option<PathBuf>,
}

#[derive(Clone, Debug)]
struct Point {
    us: u64,
    text: String,
    /// Line of the file.
    line: usize,
}

fn spoken(args: &Args, lang: Lang) -> Result<Option<Spoken>, Failure> {
    let point = |us: u64, text: &str| Point { us, text: text.to_owned(), line: 0 };
    if let Some(text) = &args.value {
        return Ok(Some(Spoken { points: vec![point(0, text)], file: None }));
    }
    if let Some(text) = &args.ramp {
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, time] = parts.as_slice() else {
            return Err(bad(format!("expected FROM:TO:TIME such as 0Hz:50Hz:20s, got '{text}'")));
        };
        let time = parse_span(time).map_err(bad)?;
        return Ok(Some(Spoken { points: vec![point(0, from), point(time.as_micros(), to)], file: None }));
    }
    match &args.profile {
        Some(path) => read_profile(path).map(Some),
        None if args.enable || args.until.is_some() || args.motion.hold || args.mode.is_some() => {
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
fn read_profile(path: &Path) -> Result<Spoken, Failure> {
    let bad = |line: usize, why: &str| profile_failure(path, line, why);
    let text = std::fs::read_to_string(path).map_err(|error| bad(0, &error.to_string()))?;
    let mut points = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let (number, line) = (index + 1, line.split('#').next().unwrap_or("").trim());
        if line.is_empty() {
            continue;
        }
        let (time, value) = line
            .split_once([',', ';', '\t'])
            .ok_or_else(|| bad(number, "expected TIME, SETPOINT such as '5s, 25Hz'"))?;
        let time = parse_span(time).map_err(|why| bad(number, &why))?;
        points.push(Point { us: time.as_micros(), text: value.to_owned(), line: number });
    }
    match points.is_empty() {
        true => Err(bad(0, "no setpoint in the file")),
        false => Ok(Spoken { points, file: Some(path.to_owned()) }),
    }
}

fn profile_failure(path: &Path, line: usize, why: &str) -> Failure {
    Failure::new(Class::Data, "data.profile", format!("{}:{line}: {why}", path.display()))
}

/// A setpoint as one family understands it.
#[derive(Clone, Debug)]
struct Wanted {
    mode: Mode,
    param: Param,
    schedule: Schedule,
    /// The schedule is in 0.01 1/min, and pole pairs make it a frequency.
    by_speed: bool,
    denominator: Option<(Param, i64)>,
    start: Option<Start>,
    /// Settings for the run, in the order in which they were given.
    settings: Vec<(Param, i64)>,
}

impl Wanted {
    /// A value with its unit, as people write it.
    fn shown(&self, raw: i64, family: &Family, lang: Lang) -> String {
        if let Some(text) = family.text_of(&self.param, raw) {
            return text.get(lang).to_owned();
        }
        let (decimals, unit) = match (self.by_speed, &self.param.unit) {
            (true, _) => (SPEED_DECIMALS, SPEED_UNIT),
            (false, unit) => (self.param.decimals_or_zero(), unit.as_deref().unwrap_or("")),
        };
        let ratio = self.denominator.as_ref().map_or_else(String::new, |(_, raw)| format!("/{raw}"));
        format!("{}{ratio} {unit}", format_decimal(raw, decimals)).trim_end().to_owned()
    }
}

/// Reads the setpoint and what belongs to it in the words of a family.
fn understand(args: &Args, spoken: &Spoken, family: &Family, lang: Lang) -> Result<Wanted, Failure> {
    let failed = |point: &Point, why: String| match &spoken.file {
        Some(path) => profile_failure(path, point.line, &why),
        None => bad(why),
    };
    let first = spoken.points.first().ok_or_else(|| bad("expected a setpoint such as 25Hz".to_owned()))?;
    let mode = named_mode(args, family, lang)?;
    let mode = match mode {
        Some(mode) => mode,
        None => unit_mode(&first.text, family, lang)
            .map_err(|why| Failure { code: "usage.unit".to_owned(), ..failed(first, why) })?,
    };
    let mut said = Vec::new();
    for point in &spoken.points {
        let one = setpoint::parse(family, mode, &point.text).map_err(|error| failed(point, error.to_string()))?;
        if said.first().is_some_and(|first: &setpoint::Said| first.by_speed != one.by_speed) {
            return Err(failed(point, "all setpoints must have the same unit".to_owned()));
        }
        said.push(one);
    }
    let schedule = schedule(spoken, &said)?;
    let mut settings = options(args, mode, family)?;
    settings.extend(source(args, mode, family)?);
    let set = |id: u32, raw: i64| (family.param_or_unknown(id), raw);
    let denominator = said.first().and_then(|one| one.denominator);
    let wanted = Wanted {
        param: family.param_or_unknown(mode.setpoint),
        by_speed: said.first().is_some_and(|one| one.by_speed),
        denominator: mode.denominator.zip(denominator).map(|(id, raw)| set(id, raw)),
        start: start(args, mode)?,
        settings,
        schedule,
        mode: mode.clone(),
    };
    if args.until.is_some() && mode.endless {
        let text = lang.pick("nothing tells that this is reached:", "nichts zeigt an, dass das erreicht ist:");
        return Err(bad(format!("{text} {}", mode.name(lang))));
    }
    if !mode.starts.is_empty() && spoken.points.len() > 1 {
        let text =
            lang.pick("one movement has one target; it cannot be led", "eine Fahrt hat ein Ziel, keinen Verlauf:");
        return Err(bad(format!("{text}: {}", mode.name(lang))));
    }
    Ok(wanted)
}

/// The mode that was named.
fn named_mode<'f>(args: &Args, family: &'f Family, lang: Lang) -> Result<Option<&'f Mode>, Failure> {
    let Some(slug) = &args.mode else { return Ok(None) };
    family.mode(slug).map(Some).ok_or_else(|| {
        let text = match lang {
            Lang::En => format!("'{slug}' is no mode of this drive (expected: {})", modes(family)),
            Lang::De => format!("'{slug}' ist keine Betriebsart dieses Antriebs (möglich: {})", modes(family)),
        };
        Failure::new(Class::Usage, "usage.mode", text)
    })
}

/// The mode that the unit tells.
fn unit_mode<'f>(text: &str, family: &'f Family, lang: Lang) -> Result<&'f Mode, String> {
    let modes = modes(family);
    setpoint::mode_of(family, text).ok_or_else(|| match lang {
        Lang::En => format!("expected a setpoint with its unit, such as 25Hz, or --mode ({modes}), got '{text}'"),
        Lang::De => format!("erwartet: Sollwert mit Einheit, etwa 25Hz, oder --mode ({modes}); erhalten: '{text}'"),
    })
}

fn modes(family: &Family) -> String {
    family.modes.iter().map(|mode| mode.slug.as_str()).collect::<Vec<_>>().join(", ")
}

fn schedule(spoken: &Spoken, said: &[setpoint::Said]) -> Result<Schedule, Failure> {
    let points: Vec<(u64, i64)> =
        spoken.points.iter().map(|point| point.us).zip(said.iter().map(|one| one.raw)).collect();
    match (&spoken.file, points.as_slice()) {
        (Some(path), _) => Schedule::steps(points).map_err(|point| {
            let line = spoken.points.get(point.saturating_sub(1)).map_or(0, |point| point.line);
            profile_failure(path, line, "times must rise")
        }),
        (None, &[(_, from), (us, to)]) => Ok(Schedule::ramp(from, to, us)),
        (None, points) => {
            let raw = points.first().map_or(0, |point| point.1);
            Ok(Schedule::ramp(raw, raw, 0))
        }
    }
}

fn start(args: &Args, mode: &Mode) -> Result<Option<Start>, Failure> {
    let Some(slug) = &args.start else { return Ok(mode.starts.first().cloned()) };
    let found = mode.starts.iter().find(|start| start.slug == *slug);
    let known: Vec<_> = mode.starts.iter().map(|start| start.slug.as_str()).collect();
    found.cloned().map(Some).ok_or_else(|| unknown_word("--start", slug, &known, mode))
}

fn source(args: &Args, mode: &Mode, family: &Family) -> Result<Option<(Param, i64)>, Failure> {
    let Some(slug) = &args.source else { return Ok(None) };
    let choices = mode.source.iter().flat_map(|source| source.choices.iter().map(|choice| (source.param, choice)));
    let known: Vec<_> = choices.clone().map(|(_, choice)| choice.slug.as_str()).collect();
    let found = choices.clone().find(|(_, choice)| choice.slug == *slug);
    let found = found.map(|(id, choice)| (family.param_or_unknown(id), choice.value));
    found.map(Some).ok_or_else(|| unknown_word("--source", slug, &known, mode))
}

fn unknown_word(flag: &str, word: &str, known: &[&str], mode: &Mode) -> Failure {
    let expected = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
    let message = format!("{flag} {word} does not fit '{}' (expected: {expected})", mode.slug);
    Failure::new(Class::Usage, "usage.option", message)
}

/// Parameters of the mode that are set first, checked like every value.
fn options(args: &Args, mode: &Mode, family: &Family) -> Result<Vec<(Param, i64)>, Failure> {
    let mut options = Vec::new();
    for text in &args.options {
        let (name, what) =
            text.split_once('=').ok_or_else(|| bad(format!("expected PARAMETER=VALUE, got '{text}'")))?;
        let found = match name.parse() {
            Ok(id) => family.param(id),
            Err(_) => family.find(name).ok(),
        };
        let Some(param) = found.filter(|param| mode.options.contains(&param.id)) else {
            let known: Vec<_> = mode.options.iter().map(|&id| family.param_or_unknown(id).label()).collect();
            let known: Vec<_> = known.iter().map(String::as_str).collect();
            return Err(unknown_word("--set", name, &known, mode));
        };
        let bad = |error: value::ValueError| {
            Failure::new(Class::Data, "data.value", format!("{}: {error}", param.label())).with("param", param.id)
        };
        let raw = value::parse(what, param, &family.choices(param)).map_err(bad)?;
        check_range(raw, param).map_err(bad)?;
        options.push((param.clone(), raw));
    }
    Ok(options)
}

async fn give(args: &Args, spoken: &Spoken, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let lang = context.settings.lang;
    let mut motion = args.motion.clone();
    if args.jog.is_some() {
        (motion.hold, motion.duration) = (true, args.jog);
    }
    let enable = args.enable || args.jog.is_some();
    let plan =
        Plan { action: "sollwert", announce: String::new(), details: Vec::new(), args: &motion, needs_control: enable };
    running::run(
        context,
        plan,
        async |session, target, before, plan| {
            let wanted = understand(args, spoken, &target.family, lang)?;
            plan.announce = announce(&wanted, &target.family, enable, lang);
            plan.details.extend(
                wanted.start.as_ref().and_then(|start| start.note.as_ref()).map(|note| note.get(lang).to_owned()),
            );
            let needs_control = enable && !motion.take_control;
            let mut check = Check { args, session, target, before, lang };
            check.run(wanted, enable, needs_control).await
        },
        async |motor, wanted| carry_out(motor, &wanted, enable, args.until.is_some(), &motion).await,
    )
    .await
}

/// Sets what the mode needs, enables, selects the mode, gives the setpoint, and waits or holds as asked.
async fn carry_out(
    motor: &mut Motor<'_, '_>,
    wanted: &Wanted,
    enable: bool,
    until_reached: bool,
    motion: &MotionArgs,
) -> Result<(), Failure> {
    let unit = wanted.param.unit.as_deref().unwrap_or("");
    motor.prepare(&wanted.mode);
    for (param, raw) in &wanted.settings {
        motor.change_param(param, *raw).await?;
    }
    if wanted.mode.zero && (enable || wanted.mode.value.is_some()) {
        // A setpoint that still stands from before must not start the shaft.
        motor.give(&wanted.param, 0, unit).await?;
    }
    if enable {
        motor.walk("operation-enabled").await?;
    }
    motor.enter().await?;
    if let Some((param, raw)) = &wanted.denominator {
        motor.set(param, *raw).await?;
    }
    motor.give(&wanted.param, wanted.schedule.at(0), unit).await?;
    lead(motor, wanted, unit).await?;
    match &wanted.start {
        Some(start) => motor.travel(start).await?,
        None if until_reached => motor.until_reached().await?,
        None => {}
    }
    if motion.hold {
        let last = wanted.schedule.at(u64::MAX);
        let keeps = wanted.mode.zero;
        motor
            .hold(motion.duration, async |motor: &mut Motor<'_, '_>, _| match keeps {
                true => motor.refresh(&wanted.param, last).await,
                false => Ok(()),
            })
            .await?;
    }
    Ok(())
}

/// Leads the setpoint along its schedule.
async fn lead(motor: &mut Motor<'_, '_>, wanted: &Wanted, unit: &str) -> Result<(), Failure> {
    let end = wanted.schedule.end_us();
    if end == 0 {
        return Ok(());
    }
    let mut last = wanted.schedule.at(0);
    motor
        .hold(Some(Span::from_micros(end)), async |motor: &mut Motor<'_, '_>, gone| {
            let value = wanted.schedule.at(gone.as_micros());
            if value != last {
                last = value;
                motor.give(&wanted.param, value, unit).await?;
            }
            Ok(())
        })
        .await?;
    let value = wanted.schedule.at(end);
    if value == last { Ok(()) } else { motor.give(&wanted.param, value, unit).await }
}

fn announce(wanted: &Wanted, family: &Family, enable: bool, lang: Lang) -> String {
    let value = |raw: i64| wanted.shown(raw, family, lang);
    let (from, to) = (wanted.schedule.at(0), wanted.schedule.at(u64::MAX));
    let what = if wanted.schedule.end_us() == 0 { value(to) } else { format!("{} … {}", value(from), value(to)) };
    let what = format!("{} {what}", lang.pick("setpoint", "Sollwert"));
    let what = match &wanted.mode.value {
        Some(_) => format!("{}, {what}", wanted.mode.name(lang)),
        None => what,
    };
    let start = wanted.start.as_ref().map_or_else(String::new, |start| format!(", {}", start.name(lang)));
    let enables = if enable { lang.pick("enable operation, ", "Betrieb freigeben, ") } else { "" };
    format!("{enables}{what}{start}")
}

/// Holds a setpoint against what the drive says, before anybody is asked.
struct Check<'c, 's> {
    args: &'c Args,
    session: &'c mut Session<'s>,
    target: &'c mut Target,
    before: &'c Situation,
    lang: Lang,
}

impl Check<'_, '_> {
    async fn run(&mut self, mut wanted: Wanted, enable: bool, needs_control: bool) -> Result<Wanted, Failure> {
        if needs_control && let Some(failure) = no_control(self.before, self.target, self.lang) {
            return Err(failure);
        }
        if wanted.start.is_some() && !enable && self.before.state != "operation-enabled" {
            let text =
                self.lang.pick("the drive is not enabled, so nothing can start", "der Antrieb ist nicht freigegeben");
            let hint = self.lang.pick("add --enable", "--enable angeben");
            return Err(Failure::new(Class::Forbidden, "forbidden.not_enabled", text).hint(hint));
        }
        if wanted.by_speed {
            let pairs = self.pole_pairs().await?;
            wanted.schedule = wanted.schedule.map(|raw| setpoint::frequency_of_speed(raw, pairs));
            wanted.by_speed = false;
        }
        for raw in wanted.schedule.values().filter(|_| !self.args.force) {
            check_range(raw, &wanted.param).map_err(|error| {
                Failure::new(Class::Data, "data.range", format!("{}: {error}", wanted.param.label()))
                    .with("param", wanted.param.id)
            })?;
        }
        let source = self.source(&wanted).await?;
        self.limit(&wanted).await?;
        self.floor(&wanted, source).await?;
        Ok(wanted)
    }

    async fn pole_pairs(&mut self) -> Result<i64, Failure> {
        let pairs = role_raw(self.session, self.target, "pole-pairs", self.lang).await?;
        pairs.filter(|&pairs| pairs > 0).ok_or_else(|| {
            let label = self.target.family.role("pole-pairs").map_or_else(|| "-".to_owned(), Param::label);
            let text = match self.lang {
                Lang::En => format!("the drive does not tell its pole pairs ({label})"),
                Lang::De => format!("der Antrieb nennt seine Polpaarzahl ({label}) nicht"),
            };
            Failure::new(Class::Data, "data.pole_pairs", text)
                .hint(self.lang.pick("give the setpoint in Hz", "den Sollwert in Hz angeben"))
        })
    }

    /// What the drive works with, or will in this run; refused if the setpoint is ignored then.
    async fn source(&mut self, wanted: &Wanted) -> Result<Option<i64>, Failure> {
        let Some(source) = &wanted.mode.source else { return Ok(None) };
        let present = self.will_be(source.param, wanted).await?;
        if present != Some(source.ignored) {
            return Ok(present);
        }
        let ways: Vec<_> = source.choices.iter().map(|row| format!("--source {} ({})", row.slug, row.value)).collect();
        let (or, sets) =
            self.lang.pick(("or", "sets it in RAM for the run"), ("oder", "stellt es für den Lauf im RAM um"));
        let hint = format!("{} {sets}", ways.join(&format!(" {or} ")));
        Err(Failure::new(Class::Forbidden, "forbidden.ramp_setpoint", source.why.get(self.lang)).hint(hint))
    }

    async fn limit(&mut self, wanted: &Wanted) -> Result<(), Failure> {
        let Some(id) = wanted.mode.limit.filter(|_| !self.args.force) else { return Ok(()) };
        let (param, peak) = (self.target.family.param_or_unknown(id), wanted.schedule.peak());
        let Some(limit) = self.will_be(id, wanted).await?.filter(|&limit| peak > limit) else { return Ok(()) };
        let family = &self.target.family;
        let (peak, limit) = (wanted.shown(peak, family, self.lang), wanted.shown(limit, family, self.lang));
        let (name, label) = (param.name(self.lang), param.label());
        let text = match self.lang {
            Lang::En => format!("{peak} is above the limit {label} = {limit} ({name})"),
            Lang::De => format!("{peak} liegt über der Grenze {label} = {limit} ({name})"),
        };
        let hint =
            self.lang.pick("--force sends it; the drive limits it", "--force sendet ihn; der Antrieb begrenzt ihn");
        Err(Failure::new(Class::Data, "data.range", text).hint(hint))
    }

    async fn floor(&mut self, wanted: &Wanted, source: Option<i64>) -> Result<(), Failure> {
        let Some(floor) = wanted.mode.floor.as_ref().filter(|floor| source == Some(floor.source)) else {
            return Ok(());
        };
        let Some(least) = self.will_be(floor.param, wanted).await?.filter(|&least| least > 0) else { return Ok(()) };
        if wanted.schedule.values().any(|raw| raw.abs() < least) {
            let least = wanted.shown(least, &self.target.family, self.lang);
            self.session.tell(outcome::Event::Note(floor.why.get(self.lang).replace("{}", &least)));
        }
        Ok(())
    }

    /// The value that a parameter will have in this run.
    async fn will_be(&mut self, id: u32, wanted: &Wanted) -> Result<Option<i64>, Failure> {
        if let Some((_, raw)) = wanted.settings.iter().find(|(param, _)| param.id == id) {
            return Ok(Some(*raw));
        }
        let param = self.target.family.param_or_unknown(id);
        working(self.session, self.target, &param, self.lang).await
    }
}

/// What would be written besides the way to operation, which depends on the drive's state.
fn dry_run(family: &Family, wanted: &Wanted, context: &Context<'_>) -> Result<Outcome, Failure> {
    let address = running::single_address(context)?;
    if wanted.by_speed {
        let message = "a speed needs the drive's pole pairs (P.373), and a dry run asks no drive";
        return Err(Failure::new(Class::Usage, "usage.dry_run", message).hint("give the setpoint in Hz"));
    }
    let selects = wanted.mode.value.zip(family.role("mode")).map(|(value, param)| (param.clone(), value));
    let engage = wanted.mode.engage.iter().map(|preset| (family.param_or_unknown(preset.param), preset.value));
    let start = wanted.start.as_ref().zip(family.role("control-word"));
    let writes = wanted
        .settings
        .iter()
        .cloned()
        .chain(selects)
        .chain(engage)
        .chain(wanted.denominator.clone())
        .chain(wanted.schedule.values().map(|raw| (wanted.param.clone(), raw)))
        .chain(start.map(|(start, param)| (param.clone(), start.word.into())));
    let reader = telegram_reader(context.settings, family);
    let telegram = |(param, raw): (Param, i64)| {
        let cell = Cell { number: param.id, set: 0 };
        reader.question(address, Inquiry::Write(cell, param.kind.unwrap_or(Type::Long), raw as u32))
    };
    let mut telegrams: Vec<_> = writes.filter_map(telegram).collect();
    telegrams.dedup_by(|a, b| a.hex == b.hex);
    Ok(Outcome::of(Data::Plan(outcome::Plan { dry_run: true, telegrams })))
}

async fn show_all(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let family = offline_family(context.settings, context.registry)?;
        let show = &family.motion.show;
        let ids = [&show.setpoints[..], &show.actual, &show.sources].concat();
        let questions: Vec<_> =
            ids.iter().filter_map(|&id| family.param(id)).map(|param| read_question(param, 0)).collect();
        return plan(context, &family, &questions);
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
    let family = target.family.clone();
    let mut reader = Reader::new(session, &mut target, settings);
    reader.lenient = true;
    let report = SetpointReport {
        address,
        drive: family.drive.clone(),
        setpoints: values(&mut reader, &family, &family.motion.show.setpoints).await?,
        actual: values(&mut reader, &family, &family.motion.show.actual).await?,
        sources: values(&mut reader, &family, &family.motion.show.sources).await?,
        error: None,
    };
    let (failures, good) = reader.into_failures();
    Ok((report, failures, good))
}

async fn values(reader: &mut Reader<'_, '_, '_>, family: &Family, ids: &[u32]) -> Result<Vec<Value>, Failure> {
    let params: Vec<_> = ids.iter().filter_map(|&id| family.param(id).cloned()).collect();
    reader.fetch(&params).await?;
    let mut values = Vec::new();
    for param in &params {
        values.extend(reader.rows(param, DataSets::Unnamed).await?.into_iter().next());
    }
    Ok(values)
}
