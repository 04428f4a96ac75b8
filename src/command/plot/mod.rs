//! `plot`: a record of `monitor` as a picture, and what its curves come to; or the characteristic of an analog input. No drive is needed.

mod input;
mod record;

use super::verb::{Verb, Working};
use super::{Context, output};
use crate::args::{Addresses, Takes, parse_span};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, Outcome, Plot, PlotCurve, PlotGap, PlotMark, PlotResponse};
use crate::profile::Registry;
use crate::scope::{Curve, MarkKind, Part, Response, Scene, picture, responses, statistics};
use crate::text::{Lang, Text, both};
use crate::tick::Span;
use clap::Args as ClapArgs;
use record::{Column, Track};
use std::path::{Path, PathBuf};

/// Draws a record of `monitor` over time, or the characteristic of an analog input.
///
/// On a terminal as a chart, with --svg as a picture for print: lines that differ without colour, two axes, states, faults, gaps and
/// triggers. No drive is needed. Columns are named by their slug, number, or setpoint, actual, current; curves of at most two units
/// fit on a picture. Times are seconds of the record.
///
/// --measure tells what each curve comes to between --from and --to (mean and effective value are weighed with time), and how the
/// actual value followed each change of the setpoint: overshoot, settling time, slope, dead time. What a record cut short does not
/// tell is left open.
///
/// Of a file of settings (`dataset save`, .toml) the analog input of an EM-RES-03 is drawn: setpoint over voltage, by P.560 and P.562 to
/// P.567. Numbers behind it are modes of P.562 (1, 11, 21, 101) in place of the one of the file.
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// A record of `monitor --record`, or a parameter file
    #[arg(value_name = "FILE")]
    pub file: PathBuf,

    /// What is drawn [default: setpoint, actual value, current]
    #[arg(value_name = "COLUMN")]
    pub columns: Vec<String>,

    /// Write a picture
    ///
    /// Written whole, or not at all; --force replaces an old one.
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,

    /// From this time of the record on
    #[arg(long, value_name = "TIME", value_parser = parse_span)]
    pub from: Option<Span>,

    /// Until this time of the record
    #[arg(long, value_name = "TIME", value_parser = parse_span)]
    pub to: Option<Span>,

    /// Overshoot, settling time, slope; min, max, mean, RMS
    #[arg(long)]
    pub measure: bool,

    /// How near its end is settled, in percent
    #[arg(long, value_name = "PERCENT", default_value_t = BAND, value_parser = clap::value_parser!(u8).range(1..=50))]
    pub band: u8,
}

impl Verb for Args {
    const NAME: &'static str = "plot";
    const TAKES: Takes = Takes::DRAWS;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb plot record.csv",
        "antrieb plot record.csv --measure --from 1s --to 9s",
        "antrieb plot record.csv setpoint actual --svg ramp.svg",
        "antrieb plot drive.toml 1 11 21 101 --svg input.svg",
    ];
    type Prints = Document<Plot>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(std::future::ready(run(self, context)))
    }
}

/// Draws and measures.
pub fn run(args: &Args, context: &Context<'_>) -> Result<Outcome, Failure> {
    args.svg.as_deref().map_or(Ok(()), is_named_svg)?;
    if input::is_settings(&args.file) {
        return input::run(args, context);
    }
    let settings = context.settings;
    let mut tracks = record::read(&args.file, context.registry)?;
    let known: Vec<u8> = tracks.keys().copied().collect();
    let address = match &settings.addresses {
        Addresses::Named(list) => list.first().copied(),
        Addresses::Unnamed => known.first().copied(),
    };
    let (address, track) = address
        .and_then(|address| Some((address, tracks.remove(&address)?)))
        .ok_or_else(|| nobody(&args.file, address, &known))?;
    let (plot, scene) = args.draw(address, &track, settings.lang)?;
    if let Some(path) = &args.svg {
        output::write(path, &picture(&scene, 0), settings.force)?;
    }
    Ok(Outcome::of(Data::Plot(plot)))
}

/// Refuses a name that promises another form of picture.
fn is_named_svg(path: &Path) -> Result<(), Failure> {
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    if !ending.is_some_and(|ending| OTHERS.contains(&ending.as_str())) {
        return Ok(());
    }
    let file = path.display();
    let message = both!(
        "expected a file that ends with .svg, got {file}: no other form is drawn",
        "erwartet: eine Datei, die mit .svg endet; angegeben: {file}: eine andere Form wird nicht gezeichnet"
    );
    Err(Failure::new(Class::Usage, "usage.file", message))
}

/// Endings of other pictures and pages.
const OTHERS: [&str; 9] = ["png", "jpg", "jpeg", "gif", "webp", "bmp", "tiff", "pdf", "html"];

/// Every drive of a record that has something to draw, with its picture in SVG, the first of them the `nth` on its page.
pub(super) fn every(args: &Args, registry: &Registry, lang: Lang, nth: usize) -> Result<Vec<(Plot, String)>, Failure> {
    let tracks = record::read(&args.file, registry)?;
    let drawn = tracks.iter().enumerate().map(|(index, (address, track))| {
        let (plot, scene) = args.draw(*address, track, lang)?;
        Ok((plot, picture(&scene, nth + index)))
    });
    drawn.collect()
}

impl Args {
    /// All of a record, measured.
    pub(super) fn whole(file: &Path) -> Self {
        let file = file.to_owned();
        Args { file, columns: Vec::new(), svg: None, from: None, to: None, measure: true, band: BAND }
    }

    /// What is drawn of a drive, and what it comes to.
    fn draw(&self, address: u8, track: &Track, lang: Lang) -> Result<(Plot, Scene), Failure> {
        let (first, last) = track.ends();
        let seconds = |span: Span| span.as_micros() as f64 / 1e6;
        let (from, to) = (self.from.map_or(first, seconds), self.to.map_or(last, seconds));
        if from >= to || from >= last || to <= first {
            return Err(outside((from, to), (first, last)));
        }
        let columns = chosen(&self.columns, track)?;
        let curves: Vec<Curve> = columns.iter().map(|column| column.curve()).collect();
        let name = self.file.file_name().unwrap_or_default().to_string_lossy();
        let title = format!("{name} · {} {address}", track.drive);
        let is_seen = |t: f64| (from..=to).contains(&t);
        let marks = track.marks.iter().filter(|mark| is_seen(mark.t)).cloned().collect();
        let gaps = track.gaps().into_iter().filter(|gap| gap.1 > from && gap.0 < to).collect();
        let states = track.states().into_iter().filter(|state| state.to >= from && state.from <= to).collect();
        let across = both!("time [s]", "Zeit [s]");
        let scene = Scene { title, across, curves, states, marks, gaps, from, to, lang };
        let units = scene.units();
        let row = |(column, curve): (&&Column, &Curve)| row(column, curve, &units, (from, to), self.measure);
        let breaks = if self.measure { track.breaks() } else { Vec::new() };
        let responses = self.measure.then(|| followed(&scene, f64::from(self.band) / 100.0, &breaks));
        let unseen = responses
            .iter()
            .flat_map(|responses| unseen(&scene, &track.starts(&breaks), responses))
            .collect::<Vec<_>>();
        let is_blind = !track.has_state() && !responses.iter().all(Vec::is_empty);
        let plot = Plot {
            file: self.file.display().to_string(),
            svg: self.svg.as_ref().map(|path| path.display().to_string()),
            address,
            drive: track.drive.clone(),
            across: "s",
            from: rounded(from),
            to: rounded(to),
            curves: columns.iter().zip(&scene.curves).map(row).collect(),
            responses,
            marks: scene.marks.iter().map(told).collect(),
            gaps: scene.gaps.iter().map(|(from, to)| PlotGap { from: *from, to: *to }).collect(),
            notes: is_blind.then(stateless).into_iter().chain(unseen).collect(),
        };
        Ok((plot, scene))
    }
}

/// How near its end is settled, in percent, where nobody says.
const BAND: u8 = 2;

impl Column {
    fn curve(&self) -> Curve {
        Curve { name: self.name.clone(), unit: self.unit.clone(), part: self.part, points: self.points.clone() }
    }

    /// Whether it is called so.
    fn is(&self, name: &str) -> bool {
        let by_number = name.parse().ok().filter(|_| !self.key.contains('@'));
        self.key == name || by_number.is_some_and(|number: u32| self.number == Some(number)) || part(self.part) == name
    }

    fn has_values(&self) -> bool {
        self.points.iter().any(|point| point.1.is_some())
    }
}

/// The columns that are drawn: those that were named, or setpoint, actual value and current, or the first of one unit.
fn chosen<'t>(names: &[String], track: &'t Track) -> Result<Vec<&'t Column>, Failure> {
    let drawable: Vec<&Column> = track.columns.iter().filter(|column| column.has_values()).collect();
    let mut columns: Vec<&Column> = Vec::new();
    for name in names {
        let named = drawable.iter().filter(|column| column.is(name)).copied().collect::<Vec<_>>();
        if named.is_empty() {
            return Err(strange(name, &drawable));
        }
        columns.extend(named);
    }
    if names.is_empty() {
        let usual = |part: Part| drawable.iter().find(|column| column.part == part).copied();
        columns = [Part::Setpoint, Part::Actual, Part::Current].into_iter().filter_map(usual).collect();
        if columns.is_empty() {
            let unit = drawable.first().map(|column| column.unit.clone());
            columns = drawable.iter().filter(|column| Some(&column.unit) == unit.as_ref()).copied().take(4).collect();
        }
    }
    let mut units: Vec<&str> = columns.iter().map(|column| column.unit.as_str()).collect();
    units.sort_unstable();
    units.dedup();
    if units.len() > 2 || columns.is_empty() {
        let units = units.join(", ");
        let message = both!(
            "expected curves of one or two units, got: {units}",
            "erwartet: Kurven von einer oder zwei Einheiten; angegeben: {units}"
        );
        return Err(Failure::new(Class::Usage, "usage.columns", message).hint(has(&drawable)));
    }
    Ok(columns)
}

fn row(column: &Column, curve: &Curve, units: &[&str], (from, to): (f64, f64), measure: bool) -> PlotCurve {
    let found = statistics(curve, from, to);
    let told = found.filter(|_| measure);
    let within: Vec<_> = curve.points.iter().filter(|point| (from..=to).contains(&point.0)).collect();
    let piece = |piece: &[&(f64, Option<f64>)]| piece.iter().filter_map(|(t, value)| Some((*t, (*value)?))).collect();
    let pieces = within.split(|point| point.1.is_none()).filter(|piece| !piece.is_empty());
    PlotCurve {
        column: column.key.clone(),
        name: curve.name.clone(),
        unit: Some(curve.unit.clone()).filter(|unit| !unit.is_empty()),
        part: part(curve.part),
        axis: if units.first() == Some(&curve.unit.as_str()) { "left" } else { "right" },
        samples: found.map_or(0, |found| found.samples as u64),
        min: told.map(|told| rounded(told.min)),
        max: told.map(|told| rounded(told.max)),
        mean: told.map(|told| rounded(told.mean)),
        rms: told.map(|told| rounded(told.rms)),
        lines: pieces.map(piece).collect(),
    }
}

/// How the actual value followed the setpoint, where both are drawn in one unit.
fn followed(scene: &Scene, band: f64, breaks: &[(f64, f64)]) -> Vec<PlotResponse> {
    let of = |part: Part| scene.curves.iter().find(|curve| curve.part == part);
    let (Some(setpoint), Some(actual)) = (of(Part::Setpoint), of(Part::Actual)) else { return Vec::new() };
    if setpoint.unit != actual.unit {
        return Vec::new();
    }
    let told = |response: Response| PlotResponse {
        t: rounded(response.t),
        from: rounded(response.from),
        to: rounded(response.to),
        unit: Some(actual.unit.clone()).filter(|unit| !unit.is_empty()),
        start: rounded(response.start),
        end: rounded(response.end),
        overshoot_percent: response.overshoot_percent.map(rounded),
        settling_s: response.settling_s.map(rounded),
        slope: response.slope.map(rounded),
        dead_time_s: response.dead_time_s.map(rounded),
    };
    let stops: Vec<f64> = scene.marks.iter().filter(|mark| mark.kind == MarkKind::Stop).map(|mark| mark.t).collect();
    responses(setpoint, actual, (scene.from, scene.to), band, (&stops, breaks)).into_iter().map(told).collect()
}

/// Where the drive got power while its setpoint stood already, nothing tells how it followed that: the change was not seen.
fn unseen(scene: &Scene, starts: &[(f64, f64)], responses: &[PlotResponse]) -> Vec<Text> {
    let of = |part: Part| scene.curves.iter().find(|curve| curve.part == part);
    let (Some(setpoint), Some(_)) = (of(Part::Setpoint), of(Part::Actual)) else { return Vec::new() };
    let stands = |&(from, to): &(f64, f64)| {
        let is_in = |t: f64| (from.max(scene.from)..=to.min(scene.to)).contains(&t);
        let is_measured = responses.iter().any(|response| is_in(response.t));
        let (t, value) = setpoint.points.iter().find_map(|(t, value)| Some((*t, value.filter(|_| is_in(*t))?)))?;
        (value != 0.0 && !is_measured).then(|| {
            let (unit, t) = (&setpoint.unit, format!("{t:.3}"));
            both!(
                "at {t} s the drive got power with a setpoint of {value} {unit} that stood already: how it followed that is not measured",
                "bei {t} s bekam der Antrieb Spannung, und ein Sollwert von {value} {unit} stand schon an: wie er ihm folgte, ist nicht \
                 gemessen"
            )
        })
    };
    starts.iter().filter_map(stands).collect()
}

fn told(mark: &crate::scope::Mark) -> PlotMark {
    let kind = match mark.kind {
        MarkKind::Trigger => "trigger",
        MarkKind::Fault => "fault",
        MarkKind::Stop => "stop",
    };
    PlotMark { t: rounded(mark.t), kind, text: mark.text.clone() }
}

fn part(part: Part) -> &'static str {
    match part {
        Part::Setpoint => "setpoint",
        Part::Actual => "actual",
        Part::Current => "current",
        Part::Other => "other",
    }
}

/// To the millionth: what lies behind it is made by the arithmetic.
fn rounded(number: f64) -> f64 {
    let round = (number * 1e6).round() / 1e6;
    if round == 0.0 { 0.0 } else { round }
}

fn stateless() -> Text {
    both!(
        "the record holds no state of the drive (its status word was not asked): what is told as following a setpoint may be a stop, a coast or \
         a trip",
        "die Aufzeichnung enthält keinen Zustand des Antriebs (sein Statuswort wurde nicht gefragt): was als Folgen eines Sollwerts gemessen \
         ist, kann auch ein Halt, ein Auslaufen oder eine Störung sein"
    )
}

fn nobody(file: &Path, address: Option<u8>, known: &[u8]) -> Failure {
    let known = known.iter().map(u8::to_string).collect::<Vec<_>>().join(", ");
    let (file, address) = (file.display(), address.unwrap_or_default());
    let message = both!(
        "{file} has no drive with address {address} (it has: {known})",
        "{file} hat keinen Antrieb mit Adresse {address} (es hat: {known})"
    );
    Failure::new(Class::Data, "data.address", message)
}

fn outside((from, to): (f64, f64), (first, last): (f64, f64)) -> Failure {
    let message = both!(
        "expected a time between {first:.3} s and {last:.3} s, got {from:.3} s to {to:.3} s",
        "erwartet: eine Zeit zwischen {first:.3} s und {last:.3} s; angegeben: {from:.3} s bis {to:.3} s"
    );
    Failure::new(Class::Usage, "usage.time", message)
}

fn strange(name: &str, drawable: &[&Column]) -> Failure {
    let message = both!("there is no column '{name}' with numbers", "es gibt keine Spalte '{name}' mit Zahlen");
    Failure::new(Class::Data, "data.unknown_parameter", message).hint(has(drawable))
}

fn has(drawable: &[&Column]) -> crate::text::Text {
    let known =
        drawable.iter().map(|column| format!("{} [{}]", column.key, column.unit)).collect::<Vec<_>>().join(", ");
    both!("the record has: {known}", "die Aufzeichnung hat: {known}")
}
