//! The characteristic of the analog input of an EM-RES-03 as a parameter file has it: setpoint over voltage (EM-RES-03 manual 6.1).

use super::Args;
use crate::command::dataset::opened::Opened;
use crate::command::{Context, output};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Outcome, Plot, PlotCurve, PlotMark, Warning};
use crate::profile::Param;
use crate::profile::characteristic::{Characteristic, Mode, Points};
use crate::scope::{Curve, Part, Scene, picture};
use crate::text::{Text, both};
use std::path::Path;

/// Parameters, by their slugs.
const MODE: &str = "em-s1ina-mode";
const BAND: &str = "em-s1ina-tolerance-band";
const POINTS: [&str; 4] = ["em-s1ina-x1", "em-s1ina-y1", "em-s1ina-x2", "em-s1ina-y2"];
/// What it is in percent of, and what lifts it near zero: P.419 or P.519, P.418 or P.518.
const UNIT: &str = "%";
const FULL: f64 = 10.0;
const LEAST: u32 = 418;

/// Whether a file is one of settings.
pub(super) fn is_settings(file: &Path) -> bool {
    file.extension().is_some_and(|kind| kind.eq_ignore_ascii_case("toml"))
}

/// What a file says of the input, set by set.
struct Input {
    set: u8,
    points: Points,
    mode: Option<i64>,
}

/// Draws it.
pub(super) fn run(args: &Args, context: &Context<'_>) -> Result<Outcome, Failure> {
    if args.measure || args.from.is_some() || args.to.is_some() {
        let message = both!(
            "--measure, --from and --to are for a record over time, and {file} holds settings",
            "--measure, --from und --to gehören zu einer Aufzeichnung über der Zeit, und {file} enthält Einstellungen",
            file = args.file.display()
        );
        return Err(Failure::new(Class::Usage, "usage.no_use", message));
    }
    let named = context.settings.drive.as_deref();
    let opened = Opened::read(&args.file, context.registry, named)?;
    let family = opened.family.clone();
    let row = |slug: &str| family.params.values().find(|param| param.slug == slug);
    let [Some(x1), Some(y1), Some(x2), Some(y2)] = POINTS.map(row) else { return Err(no_input(&family.drive)) };
    let (Some(band), Some(mode)) = (row(BAND), row(MODE)) else { return Err(no_input(&family.drive)) };
    let mut assumed: Vec<Text> = Vec::new();
    let mut value = |param: &Param, set: u8| {
        let held = opened.settings.get(param.id, set).map(|setting| setting.raw);
        let usual = param.default.unwrap_or(0);
        let label = param.label();
        let told = both!("{label} = {value}", "{label} = {value}", value = shown(usual));
        if held.is_none() && !assumed.contains(&told) {
            assumed.push(told);
        }
        held.unwrap_or(usual)
    };
    let mut inputs: Vec<Input> = Vec::new();
    for set in 1..=4 {
        let (first, second) = ((value(x1, set), value(y1, set)), (value(x2, set), value(y2, set)));
        let points = Points { first, second, band: value(band, set) };
        let mode = opened.settings.get(mode.id, set).map(|setting| setting.raw);
        if inputs.iter().all(|input| (input.points, input.mode) != (points, mode)) {
            inputs.push(Input { set, points, mode });
        }
    }
    let least = (1..=4).filter_map(|set| opened.settings.get(LEAST, set)).map(|setting| setting.raw).max();
    let chosen = modes(&args.columns)?;
    let mut drawn: Vec<(Text, Mode, Characteristic)> = Vec::new();
    for input in &inputs {
        let own = Mode::ALL.into_iter().filter(|mode| input.mode == Some(mode.code()));
        let of_file: Vec<Mode> = own.collect();
        let all = if chosen.is_empty() { &of_file } else { &chosen };
        let all = if all.is_empty() { &Mode::ALL.to_vec() } else { all };
        for one in all {
            let line = Characteristic::new(input.points, *one).ok_or_else(|| no_line(*one, input.set))?;
            let name = family.text_of(mode, one.code()).cloned().unwrap_or_default();
            let name = both!("{code} {name}", "{code} {name}", code = one.code(), name);
            let name = match inputs.len() {
                1 => name,
                _ => both!("{name}, data set {set}", "{name}, Datensatz {set}", name, set = input.set),
            };
            drawn.push((name, *one, line));
        }
    }
    let from = drawn.iter().map(|row| row.1.begins()).fold(FULL, f64::min);
    // Beyond the points only where one line is drawn: more would be a tangle, and nothing of it is printed.
    let is_alone = drawn.len() == 1;
    let curves: Vec<Curve> = drawn.iter().flat_map(|row| curves(row, from, is_alone)).collect();
    let name = args.file.file_name().unwrap_or_default().to_string_lossy();
    let lang = context.settings.lang;
    let scene = Scene {
        title: format!("{name} · EM-S1INA"),
        across: both!("input [V]", "Eingang [V]"),
        curves,
        states: Vec::new(),
        marks: Vec::new(),
        gaps: Vec::new(),
        from,
        to: FULL,
        lang,
    };
    if let Some(path) = &args.svg {
        output::write(path, &picture(&scene, 0), context.settings.force)?;
    }
    let plot = Plot {
        file: args.file.display().to_string(),
        svg: args.svg.as_ref().map(|path| path.display().to_string()),
        address: opened.file.head.drive.address.unwrap_or(0),
        drive: family.drive.clone(),
        across: "V",
        from,
        to: FULL,
        curves: scene.curves.iter().map(told).collect(),
        responses: None,
        marks: drawn.iter().filter_map(turn).collect(),
        gaps: Vec::new(),
        notes: Vec::new(),
    };
    let warnings = warnings(&assumed, least.is_some_and(|least| least != 0));
    Ok(Outcome { data: Some(Data::Plot(plot)), warnings, failure: None })
}

/// The modes that were named.
fn modes(named: &[String]) -> Result<Vec<Mode>, Failure> {
    let mode = |word: &String| {
        Mode::ALL.into_iter().find(|mode| *word == mode.code().to_string()).ok_or_else(|| {
            let message = both!(
                "expected a mode of P.562 (1, 11, 21, 101) behind a file of settings, got '{word}'",
                "erwartet: eine Betriebsart von P.562 (1, 11, 21, 101) hinter einer Datei mit Einstellungen; angegeben: '{word}'"
            );
            Failure::new(Class::Usage, "usage.columns", message)
        })
    };
    named.iter().map(mode).collect()
}

/// The line between its points, and beyond them.
fn curves((name, _, line): &(Text, Mode, Characteristic), from: f64, beyond: bool) -> Vec<Curve> {
    let (low, high) = line.ends();
    let points = |is_drawn: &dyn Fn(f64) -> bool| -> Vec<(f64, Option<f64>)> {
        line.corners(from, FULL).into_iter().filter(|x| is_drawn(*x)).map(|x| (x, Some(line.at(x)))).collect()
    };
    let curve = |name: Text, part: Part, points| Curve { name, unit: UNIT.to_owned(), part, points };
    let within = curve(name.clone(), Part::Other, points(&|x| line.is_printed(x)));
    if !beyond {
        return vec![within];
    }
    let mut out = points(&|x| x <= low);
    out.push((low, None));
    out.extend(points(&|x| x >= high));
    let told = both!("beyond the points (not printed)", "jenseits der Punkte (nicht gedruckt)");
    vec![within, curve(told, Part::Other, out)]
}

fn told(curve: &Curve) -> PlotCurve {
    let pieces = curve.points.split(|point| point.1.is_none()).filter(|piece| !piece.is_empty());
    let values = || curve.points.iter().filter_map(|point| point.1);
    let seen = |fold: fn(f64, f64) -> f64| values().reduce(fold).map(super::rounded);
    PlotCurve {
        column: "em-s1ina".to_owned(),
        name: curve.name.clone(),
        unit: Some(curve.unit.clone()),
        part: super::part(curve.part),
        axis: "left",
        samples: values().count() as u64,
        min: seen(f64::min),
        max: seen(f64::max),
        mean: None,
        rms: None,
        lines: pieces.map(|piece| piece.iter().filter_map(|(x, y)| Some((*x, (*y)?))).collect()).collect(),
    }
}

/// Where a setpoint changes its sign.
fn turn((name, mode, line): &(Text, Mode, Characteristic)) -> Option<PlotMark> {
    let (at, band) = line.turns_at()?;
    let text = match mode {
        Mode::Absolute => both!(
            "{name}: zero at {at:.2} V, within {band:.2} V around it",
            "{name}: null bei {at:.2} V, in einem Band von {band:.2} V darum",
            name
        ),
        _ => both!(
            "{name}: changes direction at {at:.2} V, zero within {band:.2} V around it",
            "{name}: Wechsel der Drehrichtung bei {at:.2} V, null in einem Band von {band:.2} V darum",
            name
        ),
    };
    Some(PlotMark { t: super::rounded(at), kind: "zero", text })
}

fn warnings(assumed: &[Text], lifts: bool) -> Vec<Warning> {
    let warning = |code: &str, message: Text| Warning { code: code.to_owned(), message };
    let open = warning(
        "plot.open",
        both!(
            "the manual prints the line between the two points; what the setpoint is beyond them is drawn as the line going on, or not at all",
            "die Anleitung druckt die Gerade zwischen den beiden Punkten; jenseits davon ist sie weitergezeichnet, oder gar nicht"
        ),
    );
    let usual = (!assumed.is_empty()).then(|| {
        let list = Text::join(assumed, ", ");
        warning(
            "plot.factory",
            both!(
                "not in the file, drawn as from the factory: {list}",
                "nicht in der Datei, wie ab Werk gezeichnet: {list}",
                list
            ),
        )
    });
    let lifted = lifts.then(|| {
        warning(
            "plot.least",
            both!(
                "P.418 is not 0: near zero the setpoint stays at that frequency until the input has left the band on the other side",
                "P.418 ist nicht 0: nahe null bleibt der Sollwert auf dieser Frequenz, bis der Eingang das Band auf der anderen Seite verlässt"
            ),
        )
    });
    usual.into_iter().chain(lifted).chain([open]).collect()
}

fn no_input(drive: &str) -> Failure {
    let message = both!(
        "the family '{drive}' has no analog input of an EM-RES-03",
        "die Familie '{drive}' hat keinen Analogeingang eines EM-RES-03"
    );
    Failure::new(Class::Data, "data.no_input", message)
}

fn no_line(mode: Mode, set: u8) -> Failure {
    let code = mode.code();
    let message = both!(
        "in mode {code} both points lie at one voltage (data set {set}): no line goes through them",
        "in Betriebsart {code} liegen beide Punkte bei einer Spannung (Datensatz {set}): durch sie geht keine Gerade"
    );
    Failure::new(Class::Data, "data.no_line", message)
        .hint(both!("P.564 and P.566 have to differ", "P.564 und P.566 müssen sich unterscheiden"))
}

/// Hundredths of a percent.
fn shown(raw: i64) -> String {
    let (sign, size) = (if raw < 0 { "-" } else { "" }, raw.abs());
    format!("{sign}{}.{:02} %", size / 100, size % 100)
}
