//! `plot`: a chart in letters, and what the curves come to.

use super::page::Page;
use super::{Finding, Rows};
use crate::outcome::{Plot, PlotCurve};
use crate::render::clean;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::symbols::Marker;
use ratatui::widgets::{Axis, Chart, Dataset, GraphType, Widget};

impl Finding for Plot {
    fn table(&self, page: Page) -> String {
        let mut text = ["left", "right"].map(|axis| page.chart(self, axis)).concat();
        let marks =
            self.marks.iter().map(|mark| vec![number(mark.t), page.word(mark.kind).to_owned(), page.say(&mark.text)]);
        let gaps = self
            .gaps
            .iter()
            .map(|gap| vec![number(gap.from), page.word("gap").to_owned(), format!("{} s", number(gap.to - gap.from))]);
        let across = if self.across == "V" { ">input [V]" } else { ">t [s]" };
        text += &page.table(&[across, "", ""], marks.chain(gaps).collect());
        if let Some(responses) = &self.responses {
            text += "\n";
            text += &page.measures(self);
            let row = |one: &crate::outcome::PlotResponse| {
                let told = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), number);
                let way = format!("{} → {}", number(one.from), number(one.to));
                let measured = [one.overshoot_percent, one.settling_s, one.slope, one.dead_time_s].map(told);
                [number(one.t), way, one.unit.clone().unwrap_or_default()].into_iter().chain(measured).collect()
            };
            let head = [">t [s]", ">setpoint", "unit", ">overshoot %", ">settling s", ">slope /s", ">dead time s"];
            let table = page.table(&head, responses.iter().map(row).collect());
            if !table.is_empty() {
                text += "\n";
                text += &table;
            }
        }
        for note in &self.notes {
            text += "\n";
            text += &page.prose(&page.say(note));
        }
        if let Some(svg) = &self.svg {
            text += &format!("{}: {}\n", page.word("picture"), clean(svg));
        }
        text
    }

    fn rows(&self) -> Rows {
        Rows::of("curve", &self.curves)
    }
}

/// What the curves are drawn with, one after the other.
const DRAWN: [(Marker, &str); 4] =
    [(Marker::Dot, "•"), (Marker::Braille, "⣀"), (Marker::Custom('+'), "+"), (Marker::Custom('o'), "o")];
/// Lines of a chart.
const HEIGHT: u16 = 12;
/// Columns where nobody says how many there are.
const WIDTH: u16 = 78;

impl Page {
    /// The curves of one axis.
    fn chart(self, plot: &Plot, side: &str) -> String {
        let curves: Vec<&PlotCurve> = plot.curves.iter().filter(|curve| curve.axis == side).collect();
        if curves.is_empty() {
            return String::new();
        }
        let mut legend: Vec<String> = Vec::new();
        for (curve, (_, sign)) in curves.iter().zip(DRAWN) {
            let unit = curve.unit.as_ref().map_or_else(String::new, |unit| format!(" [{unit}]"));
            legend.push(clean(&format!("{sign} {}{unit}", self.say(&curve.name))));
        }
        let values = curves.iter().flat_map(|curve| curve.lines.iter().flatten().map(|point| point.1));
        let (low, high) = values.fold((0.0f64, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
        let high = if high > low { high } else { low + 1.0 };
        let moment = |kind: &str| -> Vec<(f64, f64)> {
            plot.marks.iter().filter(|mark| mark.kind == kind).map(|mark| (mark.t, high)).collect()
        };
        let moments = [("trigger", '▼'), ("fault", '!'), ("stop", '■')].map(|(kind, sign)| (kind, sign, moment(kind)));
        let gaps: Vec<(f64, f64)> = plot
            .gaps
            .iter()
            .flat_map(|gap| (0..=20).map(|nth| (gap.from + (gap.to - gap.from) * f64::from(nth) / 20.0, low)))
            .collect();
        for (kind, sign, _) in moments.iter().filter(|moment| !moment.2.is_empty()) {
            legend.push(format!("{sign} {}", self.word(kind)));
        }
        if !gaps.is_empty() {
            legend.push(format!("× {}", self.word("gap")));
        }
        let mut sets: Vec<Dataset<'_>> = Vec::new();
        for (curve, (marker, _)) in curves.iter().zip(DRAWN) {
            let line = |line| Dataset::default().marker(marker).graph_type(GraphType::Line).data(line);
            sets.extend(curve.lines.iter().map(|points| line(points.as_slice())));
        }
        let dots = |sign: char, data| {
            Dataset::default().marker(Marker::Custom(sign)).graph_type(GraphType::Scatter).data(data)
        };
        sets.push(dots('×', &gaps));
        sets.extend(moments.iter().map(|(_, sign, at)| dots(*sign, at.as_slice())));
        let numbers = [low, (low + high) / 2.0, high].map(number);
        let x = Axis::default()
            .bounds([plot.from, plot.to])
            .labels([plot.from, plot.to].map(|t| format!("{} {}", number(t), plot.across)));
        let y = Axis::default().bounds([low, high]).labels(numbers);
        let area = Rect::new(0, 0, self.width.unwrap_or(WIDTH).clamp(40, 200), HEIGHT);
        let mut buffer = Buffer::empty(area);
        Chart::new(sets).x_axis(x).y_axis(y).legend_position(None).render(area, &mut buffer);
        let line = |y: u16| -> String {
            let line: String = (0..area.width).filter_map(|x| Some(buffer.cell((x, y))?.symbol())).collect();
            format!("{}\n", line.trim_end())
        };
        format!("{}{}\n", folded(&legend, area.width.into()), (0..area.height).map(line).collect::<String>())
    }

    /// What each curve comes to.
    fn measures(self, plot: &Plot) -> String {
        let told = |value: Option<f64>| value.map_or_else(|| "-".to_owned(), number);
        let row = |curve: &PlotCurve| {
            let measured = [curve.min, curve.max, curve.mean, curve.rms].map(told);
            let unit = curve.unit.clone().unwrap_or_default();
            [self.say(&curve.name), unit].into_iter().chain(measured).collect()
        };
        self.table(&["name", "unit", ">min", ">max", ">mean", ">RMS"], plot.curves.iter().map(row).collect())
    }
}

/// Words one behind the other, on as many lines as they need.
fn folded(words: &[String], width: usize) -> String {
    let mut text = String::new();
    let mut room = 0;
    for word in words {
        let columns = word.chars().count() + 2;
        if room < columns {
            text += if text.is_empty() { "" } else { "\n" };
            room = width;
        } else {
            text += "  ";
        }
        text += word;
        room = room.saturating_sub(columns);
    }
    text + "\n"
}

/// A number with three decimals, or as many of them as it needs.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.3}");
    let short = text.trim_end_matches('0').trim_end_matches('.');
    if short == "-0" { "0".to_owned() } else { short.to_owned() }
}
