//! What was typed, and what it means in the words of a family.

use super::Args;
use super::unit::{modes, unit_mode};
use crate::args::parse_span;
use crate::command::running::keys::{Keys, bad as bad_keys, other_unit};
use crate::command::stop_meant;
use crate::drive::motion::Total;
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::RunKeys;
use crate::profile::setpoint::{self, SPEED_DECIMALS, SPEED_UNIT, Schedule};
use crate::profile::value::{self, check_range, format_decimal, parse_decimal};
use crate::profile::{Family, Mode, Param, Start, Type};
use crate::text::{Text, both};
use std::path::{Path, PathBuf};

/// Setpoints as they were typed, with their times in microseconds.
#[derive(Clone, Debug)]
pub(super) struct Spoken {
    points: Vec<Point>,
    /// A file leads the setpoint in steps.
    file: Option<PathBuf>,
}

impl Spoken {
    /// Just a zero, without a unit.
    pub(super) fn is_bare_zero(&self) -> bool {
        self.file.is_none() && matches!(self.points.as_slice(), [only] if is_zero(&only.text))
    }
}

fn is_zero(text: &str) -> bool {
    parse_decimal(text.trim(), 9).is_ok_and(|raw| raw == 0)
}

#[derive(Clone, Debug)]
struct Point {
    us: u64,
    text: String,
    /// Line of the file.
    line: usize,
}

pub(super) fn spoken(args: &Args) -> Result<Option<Spoken>, Failure> {
    let point = |us: u64, text: &str| Point { us, text: text.to_owned(), line: 0 };
    if let Some(text) = &args.value {
        return Ok(Some(Spoken { points: vec![point(0, text)], file: None }));
    }
    if let Some(text) = &args.ramp {
        let parts: Vec<&str> = text.split(':').collect();
        let [from, to, time] = parts.as_slice() else {
            return Err(bad(both!(
                "expected FROM:TO:TIME such as 0Hz:50Hz:20s, got '{text}'",
                "erwartet: VON:BIS:ZEIT wie 0Hz:50Hz:20s; angegeben: '{text}'"
            )));
        };
        let time = parse_span(time).map_err(|why| bad(why.0))?;
        return Ok(Some(Spoken { points: vec![point(0, from), point(time.as_micros(), to)], file: None }));
    }
    match &args.profile {
        Some(path) => read_profile(path).map(Some),
        None if args.enable || args.until.is_some() || args.motion.hold || args.mode.is_some() => {
            Err(bad(both!("expected a setpoint such as 25Hz, got none", "Sollwert fehlt, zum Beispiel 25Hz")))
        }
        None => Ok(None),
    }
}

fn bad(message: Text) -> Failure {
    Failure::new(Class::Usage, "usage.setpoint", message)
}

/// Reads lines `TIME, SETPOINT`; the error names file and line.
fn read_profile(path: &Path) -> Result<Spoken, Failure> {
    let bad = |line: usize, why: &Text| profile_failure(path, line, why);
    let text = files::read(path, files::TEXT).map_err(|error| bad(0, &error.text()))?;
    let mut points = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let (number, line) = (index + 1, line.split('#').next().unwrap_or("").trim());
        if line.is_empty() {
            continue;
        }
        let expected =
            || both!("expected TIME, SETPOINT such as '5s, 25Hz'", "erwartet: ZEIT, SOLLWERT wie '5s, 25Hz'");
        let (time, value) = line.split_once([',', ';', '\t']).ok_or_else(|| bad(number, &expected()))?;
        let time = parse_span(time).map_err(|why| bad(number, &why.0))?;
        points.push(Point { us: time.as_micros(), text: value.to_owned(), line: number });
    }
    match points.is_empty() {
        true => Err(bad(0, &both!("no setpoint in the file", "die Datei enthält keinen Sollwert"))),
        false => Ok(Spoken { points, file: Some(path.to_owned()) }),
    }
}

fn profile_failure(path: &Path, line: usize, why: &Text) -> Failure {
    let place = if line == 0 { path.display().to_string() } else { format!("{}:{line}", path.display()) };
    Failure::new(Class::Data, "data.profile", both!("{place}: {why}", "{place}: {why}", why))
}

/// A setpoint as one family understands it.
#[derive(Clone, Debug)]
pub(super) struct Wanted {
    pub(super) mode: Mode,
    pub(super) param: Param,
    pub(super) schedule: Schedule,
    /// The schedule is in 0.01 1/min, and pole pairs make it a frequency.
    pub(super) by_speed: bool,
    pub(super) denominator: Option<(Param, i64)>,
    pub(super) start: Option<Start>,
    /// Settings for the run, in the order in which they were given.
    pub(super) settings: Vec<(Param, i64)>,
    /// What the drive makes of the setpoint, if that is known.
    pub(super) effective: Option<Total>,
    /// The least that the drive lifts a setpoint to, whatever is given.
    pub(super) least: Option<i64>,
    /// It may do so with another source as well.
    pub(super) may_lift: bool,
    /// What the arrows of the keypad do.
    pub(super) keys: Option<Keys>,
}

impl Wanted {
    /// Whether the drive would turn its shaft at a setpoint of 0, as far as its own settings tell.
    pub(super) fn turns_at_zero(&self) -> bool {
        self.least.is_some_and(|least| least > 0) || self.effective.is_some_and(|total| total.of(0) != Some(0))
    }

    /// What a setpoint is and what the drive's ramp then goes to, where that is told: only frequencies are shown behind their ramp.
    pub(super) fn expects(&self, raw: i64) -> Option<(i64, i64)> {
        let total = self.effective.filter(|_| self.mode.source.is_some())?;
        total.of(raw).map(|sum| (raw, sum))
    }

    /// Every setpoint that may be given: those of the schedule, and the bounds of the keypad.
    pub(super) fn values(&self) -> impl Iterator<Item = i64> + '_ {
        self.schedule.values().chain(self.keys.iter().flat_map(|keys| [keys.min, keys.max]))
    }

    /// Every value fits into its telegram: nothing is sent of a run that could not be sent whole. A speed is held against
    /// it once it is a frequency.
    pub(super) fn check_widths(&self) -> Result<(), Failure> {
        let led = self.values().filter(|_| !self.by_speed).map(|raw| (&self.param, raw));
        let rest = self.denominator.iter().chain(&self.settings).map(|(param, raw)| (param, *raw));
        for (param, raw) in led.chain(rest) {
            let kind = param.kind.unwrap_or(Type::Long);
            value::check_width(raw, kind, param.decimals_or_zero()).map_err(|error| out_of_range(param, &error))?;
        }
        Ok(())
    }

    /// The same setpoint in another mode.
    pub(super) fn in_mode(self, mode: &Mode, family: &Family) -> Self {
        Wanted { mode: mode.clone(), param: family.param_or_unknown(mode.setpoint), ..self }
    }

    /// What the arrows do, as it is shown.
    pub(super) fn shown_keys(&self) -> Option<RunKeys> {
        self.keys.map(|keys| keys.shown(self.param.decimals_or_zero(), self.param.unit.as_deref().unwrap_or("")))
    }

    /// What is agreed to that the arrows may do.
    pub(super) fn told_keys(&self, family: &Family) -> Option<Text> {
        self.keys.map(|keys| keys.told(|raw| self.shown(raw, family)))
    }

    /// What a key is told that would have left the bounds.
    pub(super) fn refused_key(&self) -> Option<Text> {
        self.keys.map(|keys| keys.refused(self.param.decimals_or_zero(), self.param.unit.as_deref().unwrap_or("")))
    }

    /// A value with its unit, as people write it.
    pub(super) fn shown(&self, raw: i64, family: &Family) -> Text {
        if let Some(text) = family.text_of(&self.param, raw) {
            return text.clone();
        }
        let (decimals, unit) = match (self.by_speed, &self.param.unit) {
            (true, _) => (SPEED_DECIMALS, SPEED_UNIT),
            (false, unit) => (self.param.decimals_or_zero(), unit.as_deref().unwrap_or("")),
        };
        let ratio = self.denominator.as_ref().map_or_else(String::new, |(_, raw)| format!("/{raw}"));
        Text::name(format!("{}{ratio} {unit}", format_decimal(raw, decimals)).trim_end())
    }
}

/// Reads the setpoint and what belongs to it in the words of a family.
pub(super) fn understand(args: &Args, spoken: &Spoken, family: &Family) -> Result<Wanted, Failure> {
    let expected = || bad(both!("expected a setpoint such as 25Hz", "erwartet: ein Sollwert wie 25Hz"));
    let first = spoken.points.first().ok_or_else(expected)?;
    let mode = named_mode(args, family)?;
    let mode = match mode {
        Some(mode) => mode,
        None if spoken.is_bare_zero() => zero_mode(family).ok_or_else(|| {
            bad(both!("no mode of this drive stands still at 0", "keine Betriebsart dieses Antriebs steht bei 0 still"))
        })?,
        None => unit_mode(&first.text, family)
            .map_err(|why| Failure { code: "usage.unit".to_owned(), ..at_point(spoken, first, why) })
            .map_err(|failure| match stop_meant(&first.text) {
                Some(how) => failure.hint(how),
                None => failure,
            })?,
    };
    let said = every_point(spoken, mode, family)?;
    let raw: Vec<i64> = said.iter().map(|one| one.raw).collect();
    let schedule = schedule(spoken, &raw)?;
    check_codes(args, mode, family, &schedule)?;
    let mut settings = options(args, mode, family)?;
    settings.extend(source(args, mode, family)?);
    let set = |id: u32, raw: i64| (family.param_or_unknown(id), raw);
    let denominator = said.first().and_then(|one| one.denominator);
    let by_speed = said.first().is_some_and(|one| one.by_speed);
    let wanted = Wanted {
        keys: keys(args, (mode, family), &schedule, by_speed)?,
        param: family.param_or_unknown(mode.setpoint),
        by_speed,
        denominator: mode.denominator.zip(denominator).map(|(id, raw)| set(id, raw)),
        start: start(args, mode)?,
        settings,
        effective: None,
        least: None,
        may_lift: false,
        schedule,
        mode: mode.clone(),
    };
    wanted.check_widths()?;
    fits_mode(args, spoken, mode)?;
    Ok(wanted)
}

/// What the arrows do, in the words of the mode.
fn keys(
    args: &Args,
    (mode, family): (&Mode, &Family),
    schedule: &Schedule,
    by_speed: bool,
) -> Result<Option<Keys>, Failure> {
    let is_followed = mode.zero && mode.starts.is_empty() && mode.codes.is_none() && mode.denominator.is_none();
    if args.keypad.step.is_some() && !is_followed {
        return Err(bad_keys(both!(
            "--step is for a setpoint that the shaft follows, not for '{mode}'",
            "--step gilt für einen Sollwert, dem die Welle folgt, nicht für '{mode}'",
            mode = mode.text()
        )));
    }
    let raw = |flag: &str, text: &str| {
        let wrong = |error: value::ValueError| bad_keys(both!("{flag}: {why}", "{flag}: {why}", why = error.text()));
        let said = setpoint::parse(family, mode, text).map_err(wrong)?;
        (said.by_speed == by_speed).then_some(said.raw).ok_or_else(|| other_unit(flag, text))
    };
    Keys::of(&args.keypad, raw, schedule, args.motion.wants_keys())
}

/// The failure of a point: with its place, where it stands in a file.
fn at_point(spoken: &Spoken, point: &Point, why: Text) -> Failure {
    match &spoken.file {
        Some(path) => profile_failure(path, point.line, &why),
        None => bad(why),
    }
}

/// Every setpoint in the words of the mode, all of them with one unit.
fn every_point(spoken: &Spoken, mode: &Mode, family: &Family) -> Result<Vec<setpoint::Said>, Failure> {
    let mut said = Vec::new();
    for point in &spoken.points {
        let one = setpoint::parse(family, mode, &point.text).map_err(|error| match error {
            value::ValueError::Width { value, .. } | value::ValueError::TooLarge { value } => {
                beyond(&family.param_or_unknown(mode.setpoint), value)
            }
            error => at_point(spoken, point, error.text()),
        })?;
        if said.first().is_some_and(|first: &setpoint::Said| first.by_speed != one.by_speed) {
            return Err(at_point(spoken, point, one_unit()));
        }
        said.push(one);
    }
    Ok(said)
}

/// Refuses what a mode cannot do: to reach a setpoint that has no end, or to be led to several targets.
fn fits_mode(args: &Args, spoken: &Spoken, mode: &Mode) -> Result<(), Failure> {
    if args.until.is_some() && mode.endless {
        return Err(bad(both!(
            "nothing tells that this is reached: {mode}",
            "nichts zeigt an, dass das erreicht ist: {mode}",
            mode = mode.text()
        )));
    }
    if !mode.starts.is_empty() && spoken.points.len() > 1 {
        return Err(bad(both!(
            "one movement has one target; it cannot be led: {mode}",
            "eine Fahrt hat ein Ziel, keinen Verlauf: {mode}",
            mode = mode.text()
        )));
    }
    Ok(())
}

pub(super) fn out_of_range(param: &Param, error: &value::ValueError) -> Failure {
    of_param(param, "data.range", error)
}

fn of_param(param: &Param, code: &str, error: &value::ValueError) -> Failure {
    let text = both!("{label}: {why}", "{label}: {why}", label = param.label(), why = error.text());
    Failure::new(Class::Data, code, text).with("param", param.id)
}

/// A code is none of the numbers between two others: a speed that is typed in its place must not start the drive.
fn check_codes(args: &Args, mode: &Mode, family: &Family, schedule: &Schedule) -> Result<(), Failure> {
    let Some(codes) = mode.codes.as_ref().filter(|_| !args.force) else { return Ok(()) };
    let param = family.param_or_unknown(mode.setpoint);
    let unknown = |raw: &i64| family.text_of(&param, *raw).is_none();
    let Some(raw) = schedule.values().find(unknown) else { return Ok(()) };
    let label = param.label();
    let text = both!(
        "{raw} is no code of {label}: it takes codes, not speeds",
        "{raw} ist kein Code von {label}: dort stehen Codes, keine Drehzahlen"
    );
    Err(Failure::new(Class::Data, "data.code", text).hint(codes.clone()).with("param", param.id))
}

/// A number that is larger than any that can be sent.
fn beyond(param: &Param, value: String) -> Failure {
    let largest = if value.starts_with(['-', '−']) { i64::MIN } else { i64::MAX };
    let error = match check_range(largest, param) {
        Err(value::ValueError::Range { min, max, .. }) => value::ValueError::Range { value, min, max },
        _ => value::ValueError::TooLarge { value },
    };
    out_of_range(param, &error)
}

/// The mode that a zero without a unit means, before the drive is asked.
fn zero_mode(family: &Family) -> Option<&Mode> {
    family.modes.iter().find(|mode| mode.zero_stops())
}

/// The mode that was named.
fn named_mode<'f>(args: &Args, family: &'f Family) -> Result<Option<&'f Mode>, Failure> {
    let Some(slug) = &args.mode else { return Ok(None) };
    family.mode(slug).map(Some).ok_or_else(|| {
        let text = both!(
            "'{slug}' is no mode of the family {drive} (expected: {modes})",
            "'{slug}' ist keine Betriebsart der Familie {drive} (möglich: {modes})",
            drive = family.drive,
            modes = modes(family)
        );
        Failure::new(Class::Usage, "usage.mode", text)
    })
}

/// The way of a setpoint in words that no family has, and its unit: `parse` understands a number with its unit, which is one for all.
pub(super) fn way<U: PartialEq + Copy>(
    spoken: &Spoken,
    parse: impl Fn(&str) -> Result<(i64, U), Failure>,
) -> Result<(Schedule, U), Failure> {
    let (mut raw, mut unit) = (Vec::new(), None);
    for point in &spoken.points {
        let (value, its) = parse(&point.text).map_err(|why| at_point(spoken, point, why.message))?;
        if *unit.get_or_insert(its) != its {
            return Err(at_point(spoken, point, one_unit()));
        }
        raw.push(value);
    }
    let none = || bad(both!("expected a setpoint such as 25Hz", "erwartet: ein Sollwert wie 25Hz"));
    Ok((schedule(spoken, &raw)?, unit.ok_or_else(none)?))
}

fn one_unit() -> Text {
    both!("all setpoints must have the same unit", "alle Sollwerte brauchen dieselbe Einheit")
}

fn schedule(spoken: &Spoken, raw: &[i64]) -> Result<Schedule, Failure> {
    let points: Vec<(u64, i64)> = spoken.points.iter().map(|point| point.us).zip(raw.iter().copied()).collect();
    match (&spoken.file, points.as_slice()) {
        (Some(path), _) => Schedule::steps(points).map_err(|point| {
            let line = spoken.points.get(point.saturating_sub(1)).map_or(0, |point| point.line);
            profile_failure(path, line, &both!("times must rise", "die Zeiten müssen steigen"))
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
    let expected = if known.is_empty() { both!("none", "keine") } else { Text::name(known.join(", ")) };
    let message = both!(
        "{flag} {word} does not fit '{mode}' (expected: {expected})",
        "{flag} {word} passt nicht zu '{mode}' (möglich: {expected})",
        mode = mode.slug,
        expected
    );
    Failure::new(Class::Usage, "usage.option", message)
}

/// Parameters of the mode that are set first, checked like every value.
fn options(args: &Args, mode: &Mode, family: &Family) -> Result<Vec<(Param, i64)>, Failure> {
    let mut options = Vec::new();
    for text in &args.options {
        let expected =
            || both!("expected PARAMETER=VALUE, got '{text}'", "erwartet: PARAMETER=WERT; angegeben: '{text}'");
        let (name, what) = text.split_once('=').ok_or_else(|| bad(expected()))?;
        let found = match name.parse() {
            Ok(id) => family.param(id),
            Err(_) => family.find(name).ok(),
        };
        let Some(param) = found.filter(|param| mode.options.contains(&param.id)) else {
            let known: Vec<_> = mode.options.iter().map(|&id| family.param_or_unknown(id).label()).collect();
            let known: Vec<_> = known.iter().map(String::as_str).collect();
            return Err(unknown_word("--set", name, &known, mode));
        };
        let bad = |error: value::ValueError| of_param(param, "data.value", &error);
        let raw = value::parse(what, param, &family.choices(param)).map_err(bad)?;
        check_range(raw, param).map_err(bad)?;
        options.push((param.clone(), raw));
    }
    Ok(options)
}
