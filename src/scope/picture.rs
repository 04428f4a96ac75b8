//! Curves as an SVG: black on white, told apart by the style of their lines, so that a print shows what a screen shows.

use super::thin::thin;
use super::ticks::Axis;
use super::{Curve, MarkKind, Part, Scene, Stretch};
use crate::text::both;
use std::fmt::Write;

/// The sheet and the plot on it, in units of the picture.
const WIDTH: f64 = 1000.0;
const LEFT: f64 = 75.0;
const RIGHT: f64 = 925.0;
const TOP: f64 = 92.0;
const BOTTOM: f64 = 480.0;
/// The band of the states, below the numbers of the time axis.
const BAND: (f64, f64) = (530.0, 554.0);
const LINE: f64 = 18.0;
/// So wide a letter is on the average, at the size of the text.
const LETTER: f64 = 7.3;
/// Most numbered states that are listed below; what comes behind is in the file.
const LISTED: usize = 24;

/// The picture, as the text of an SVG file. On a page with several of them it is the `nth`: no name within it is that of another.
pub fn picture(scene: &Scene, nth: usize) -> String {
    let sheet = Sheet::new(scene, nth);
    let mut body = String::new();
    sheet.frame(&mut body);
    sheet.gaps(&mut body);
    sheet.curves(&mut body);
    sheet.marks(&mut body);
    let height = sheet.states(&mut body);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"277mm\" lang=\"{lang}\" role=\"img\" \
         font-family=\"sans-serif\" font-size=\"14\" fill=\"#000\" stroke-linejoin=\"round\">\n<title>{title}</title>\n\
         <defs><pattern id=\"hatch-{nth}\" width=\"6\" height=\"6\" patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\">\
         <path d=\"M0 0V6\" stroke=\"#777\" stroke-width=\"1\"/></pattern></defs>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fff\"/>\n{body}</svg>\n",
        lang = scene.lang.pick("en", "de"),
        title = escaped(&scene.title),
    )
}

/// A scene on its axes.
struct Sheet<'s> {
    scene: &'s Scene,
    /// Which picture of its page it is.
    nth: usize,
    time: Axis,
    /// The left axis and the right one, with their units.
    axes: Vec<(String, Axis)>,
}

impl<'s> Sheet<'s> {
    fn new(scene: &'s Scene, nth: usize) -> Self {
        let axis = |unit: &str| {
            let of_unit = scene.curves.iter().filter(|curve| curve.unit == unit);
            (
                unit.to_owned(),
                Axis::around(of_unit.flat_map(|curve| curve.points.iter().filter_map(|point| point.1)), 6.0),
            )
        };
        let axes = scene.units().into_iter().take(2).map(axis).collect();
        Sheet { scene, nth, time: Axis::from_to(scene.from, scene.to, 10.0), axes }
    }

    fn x(&self, t: f64) -> f64 {
        LEFT + (RIGHT - LEFT) * self.time.share(t).clamp(0.0, 1.0)
    }

    /// Title, legend, axes and their numbers.
    fn frame(&self, out: &mut String) {
        text(out, (WIDTH / 2.0, 26.0), "middle", " font-size=\"17\" font-weight=\"bold\"", &self.scene.title);
        for tick in self.time.ticks() {
            let x = self.x(tick);
            line(out, (x, TOP, x, BOTTOM), GRID);
            text(out, (x, BOTTOM + 19.0), "middle", "", &self.time.label(tick));
        }
        text(out, ((LEFT + RIGHT) / 2.0, BOTTOM + 39.0), "middle", "", self.scene.across.get(self.scene.lang));
        for ((unit, axis), (x, side)) in self.axes.iter().zip([(LEFT, -1.0), (RIGHT, 1.0)]) {
            for tick in axis.ticks() {
                let y = y(*axis, tick);
                if side < 0.0 {
                    line(out, (LEFT, y, RIGHT, y), GRID);
                }
                line(out, (x, y, x + side * 5.0, y), AXIS);
                let anchor = if side < 0.0 { "end" } else { "start" };
                text(out, (x + side * 9.0, y + 5.0), anchor, "", &axis.label(tick));
            }
            let label = if unit.is_empty() { String::new() } else { format!("[{unit}]") };
            text(out, (x + side * 9.0, TOP - 12.0), if side < 0.0 { "end" } else { "start" }, "", &label);
        }
        let _infallible = writeln!(
            out,
            "<rect x=\"{LEFT}\" y=\"{TOP}\" width=\"{}\" height=\"{}\" fill=\"none\" {AXIS}/>",
            RIGHT - LEFT,
            BOTTOM - TOP
        );
        self.legend(out);
    }

    /// What each line is, with the axis that it is read on.
    fn legend(&self, out: &mut String) {
        let (mut x, mut y) = (LEFT + 10.0, 52.0);
        for (index, curve) in self.scene.curves.iter().enumerate() {
            let name = match self.axes.iter().position(|axis| axis.0 == curve.unit) {
                Some(nth) if self.axes.len() > 1 => {
                    let side = if nth == 0 { both!("left", "links") } else { both!("right", "rechts") };
                    format!("{} ({})", curve.name.get(self.scene.lang), side.get(self.scene.lang))
                }
                _ => curve.name.get(self.scene.lang).to_owned(),
            };
            let room = 60.0 + name.chars().count() as f64 * LETTER + 24.0;
            if x + room > RIGHT && x > LEFT + 10.0 {
                (x, y) = (LEFT + 10.0, y + LINE);
            }
            line(out, (x, y, x + 50.0, y), &self.style(index));
            text(out, (x + 58.0, y + 5.0), "start", "", &name);
            x += room;
        }
    }

    fn curves(&self, out: &mut String) {
        for (index, curve) in self.scene.curves.iter().enumerate() {
            let Some((_, axis)) = self.axes.iter().find(|axis| axis.0 == curve.unit) else { continue };
            let is_seen = |t: f64| (self.scene.from..=self.scene.to).contains(&t);
            let seen: Vec<_> = curve.points.iter().filter(|point| is_seen(point.0)).collect();
            for piece in seen.split(|point| point.1.is_none()) {
                let piece: Vec<_> =
                    piece.iter().filter_map(|(t, value)| Some((self.x(*t), y(*axis, (*value)?)))).collect();
                self.path(out, curve, index, &thin(&piece, 0.5));
            }
        }
    }

    /// A piece of a curve; one value alone is a dot.
    fn path(&self, out: &mut String, curve: &Curve, index: usize, points: &[(f64, f64)]) {
        let Some((&(x, y), rest)) = points.split_first() else { return };
        let mut path = format!("M{x:.2} {y:.2}");
        for (nth, (x, y)) in rest.iter().enumerate() {
            let _infallible = match curve.part {
                Part::Setpoint if is_step(points, nth) => write!(path, "H{x:.2}V{y:.2}"),
                _ => write!(path, "L{x:.2} {y:.2}"),
            };
        }
        if rest.is_empty() {
            path.push_str("h0.01");
        }
        let style = self.style(index);
        let _infallible = writeln!(out, "<path d=\"{path}\" fill=\"none\" {style}/>");
    }

    /// The style of a line: by what it is, and each other one by its place.
    fn style(&self, index: usize) -> String {
        let others = || self.scene.curves.iter().take(index).filter(|curve| curve.part == Part::Other).count();
        let (width, dash) = match self.scene.curves.get(index).map(|curve| curve.part) {
            Some(Part::Setpoint) => (1.4, "9 5"),
            Some(Part::Actual) => (2.2, ""),
            Some(Part::Current) => (1.6, "1.5 4"),
            _ => *OTHERS.get(others() % OTHERS.len()).unwrap_or(&(1.4, "")),
        };
        let dash = if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
        format!("stroke=\"#000\" stroke-width=\"{width}\" stroke-linecap=\"round\"{dash}")
    }

    /// Where nothing was answered.
    fn gaps(&self, out: &mut String) {
        let (gap, nth) = (both!("gap", "Lücke"), self.nth);
        for (from, to) in &self.scene.gaps {
            let (left, right) = (self.x(*from), self.x(*to));
            let width = (right - left).max(2.0);
            let _infallible = writeln!(
                out,
                "<rect x=\"{left:.2}\" y=\"{TOP}\" width=\"{width:.2}\" height=\"{}\" fill=\"url(#hatch-{nth})\" opacity=\"0.6\"/>",
                BOTTOM - TOP
            );
            if width > 40.0 {
                self.label(out, (left + width / 2.0, BOTTOM - 10.0), "middle", gap.get(self.scene.lang));
            }
        }
    }

    /// Triggers, faults and stops, their words each a line lower, so that they do not lie over each other.
    fn marks(&self, out: &mut String) {
        for (index, mark) in self.scene.marks.iter().enumerate() {
            let x = self.x(mark.t);
            let style = match mark.kind {
                MarkKind::Trigger => "stroke=\"#000\" stroke-width=\"1\" stroke-dasharray=\"4 3\"",
                MarkKind::Stop => "stroke=\"#000\" stroke-width=\"1\"",
                MarkKind::Fault => "stroke=\"#000\" stroke-width=\"3\"",
            };
            line(out, (x, TOP, x, BOTTOM), style);
            let _infallible = writeln!(out, "<path d=\"M{:.2} {}h12l-6 9z\"/>", x - 6.0, TOP - 10.0);
            let y = TOP + 16.0 + LINE * (index % 8) as f64;
            let words = mark.text.get(self.scene.lang);
            let is_late = x + 8.0 + words.chars().count() as f64 * LETTER > RIGHT;
            let (x, anchor) = if is_late { (x - 6.0, "end") } else { (x + 6.0, "start") };
            self.label(out, (x, y), anchor, words);
        }
    }

    /// The band of the states; what has no room for its name has a number, told below. The height of the picture.
    fn states(&self, out: &mut String) -> f64 {
        let (mut numbered, lang): (Vec<&str>, _) = (Vec::new(), self.scene.lang);
        let mut above: Option<(f64, bool)> = None;
        for Stretch { from, to, name, is_fault } in &self.scene.states {
            let (left, right) = (self.x(*from), self.x(*to));
            let width = (right - left).max(0.0);
            let fill = if *is_fault { "#ccc" } else { "#fff" };
            let _infallible = writeln!(
                out,
                "<rect x=\"{left:.2}\" y=\"{}\" width=\"{width:.2}\" height=\"{}\" fill=\"{fill}\" {AXIS}/>",
                BAND.0,
                BAND.1 - BAND.0
            );
            let name = name.get(lang);
            let fits = |letters: usize| letters as f64 * LETTER + 8.0 <= width;
            let told = if fits(name.chars().count()) {
                name.to_owned()
            } else {
                let known = numbered.iter().position(|known| *known == name);
                let nth = known.unwrap_or_else(|| {
                    numbered.push(name);
                    numbered.len() - 1
                });
                (nth + 1).to_string()
            };
            let middle = left + width / 2.0;
            if fits(told.chars().count()) {
                text(out, (middle, BAND.1 - 7.0), "middle", "", &told);
                continue;
            }
            // A number that has no room either stands above the band, on the second of two lines where the last one is near.
            let is_near = above.is_some_and(|(x, is_high)| !is_high && middle - x < LETTER * 2.0);
            let y = BAND.0 - if is_near { 12.0 } else { 3.0 };
            text(out, (middle, y), "middle", " font-size=\"10\"", &told);
            above = Some((middle, is_near));
        }
        let mut y = BAND.1 + 8.0;
        for (nth, name) in numbered.iter().take(LISTED).enumerate() {
            y += LINE;
            text(out, (LEFT, y), "start", "", &format!("{}  {name}", nth + 1));
        }
        y + 14.0
    }

    /// Words on a white ground, so that they can be read over lines.
    fn label(&self, out: &mut String, (x, y): (f64, f64), anchor: &str, words: &str) {
        let more = " stroke=\"#fff\" stroke-width=\"4\" paint-order=\"stroke\"";
        text(out, (x, y), anchor, more, words);
    }
}

const GRID: &str = "stroke=\"#bbb\" stroke-width=\"0.7\"";
const AXIS: &str = "stroke=\"#000\" stroke-width=\"1\"";
const OTHERS: [(f64, &str); 4] = [(1.4, "14 4 2 4"), (1.0, ""), (1.4, "4 4"), (1.4, "14 4 2 4 2 4")];

/// Whether a setpoint stands up to this point and behind the next one: then it was given at once, and is no ramp.
fn is_step(points: &[(f64, f64)], nth: usize) -> bool {
    let at = |index: Option<usize>| index.and_then(|index| points.get(index)).map(|point| point.1);
    let stood = at(nth.checked_sub(1)).is_none_or(|before| Some(before) == at(Some(nth)));
    stood && at(Some(nth + 2)).is_none_or(|behind| Some(behind) == at(Some(nth + 1)))
}

fn y(axis: Axis, value: f64) -> f64 {
    BOTTOM - (BOTTOM - TOP) * axis.share(value)
}

fn line(out: &mut String, (x0, y0, x1, y1): (f64, f64, f64, f64), style: &str) {
    let _infallible = writeln!(out, "<path d=\"M{x0:.2} {y0:.2}L{x1:.2} {y1:.2}\" fill=\"none\" {style}/>");
}

fn text(out: &mut String, (x, y): (f64, f64), anchor: &str, more: &str, words: &str) {
    let words = escaped(words);
    let _infallible = writeln!(out, "<text x=\"{x:.2}\" y=\"{y:.2}\" text-anchor=\"{anchor}\"{more}>{words}</text>");
}

/// What a device calls itself is no markup.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => safe.push_str("&amp;"),
            '<' => safe.push_str("&lt;"),
            '>' => safe.push_str("&gt;"),
            '"' => safe.push_str("&quot;"),
            letter if letter.is_control() => safe.push('\u{FFFD}'),
            letter => safe.push(letter),
        }
    }
    safe
}
