//! What is drawn of a drive over the last minutes.

use super::past::{Drive, Past, float};
use super::screen::Screen;
use crate::render::clean;
use crate::render::stream::cells::{Board, GAP, find, number};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::Color;
use ratatui::symbols::Marker;
use ratatui::text::{Line, Span};
use ratatui::widgets::{Axis, Chart, Dataset, GraphType, Paragraph};

/// Fewest seconds that the chart spans; with long intervals it is more.
const SPAN: f64 = 60.0;

impl Screen {
    pub(super) fn chart(&self, frame: &mut Frame<'_>, area: Rect, drive: &Drive) {
        let [title, plot] = Layout::vertical([Constraint::Length(1), Constraint::Min(0)]).areas(area);
        let looks = [(Marker::Dot, self.tint(Color::Yellow), "•"), (Marker::Braille, self.tint(Color::Cyan), "⣀⣀")];
        let board = Board { columns: drive.about.columns.clone() };
        let mut legend = Vec::new();
        for (&index, (_, style, sign)) in drive.drawn.iter().zip(&looks) {
            let Some(column) = board.columns.get(index) else { continue };
            let value = drive.last.as_ref().and_then(|sample| find(column, sample)).map_or(GAP.to_owned(), number);
            let unit = column.unit.clone().unwrap_or_default();
            legend.push(Span::styled(format!(" {sign} "), *style));
            legend.push(Span::raw(clean(&format!("{} {value} {unit} ", board.label(column, self.lang)))));
        }
        let now = drive.past.back().map_or(0.0, |past| past.t);
        let interval = self.start.as_ref().and_then(|start| start.interval).map_or(1.0, float);
        let span = SPAN.max(interval * 60.0);
        let from = (now - span).max(drive.past.front().map_or(0.0, |past| past.t));
        let (from, to) = (from, now.max(from + span.min(10.0 * interval.max(1.0))));
        let seen: Vec<&Past> = drive.past.iter().filter(|past| past.t >= from).collect();
        let holes = holes(&seen, (to - from) / f64::from(plot.width.max(1)));
        if !holes.is_empty() {
            legend.push(Span::styled(" × ", self.tint(Color::Red)));
            legend.push(Span::raw(self.word("gap").to_owned()));
        }
        let (low, high) = bounds(seen.iter().flat_map(|past| past.values.iter().flatten().copied()));
        // Lines end where a gap begins.
        let mut lines: Vec<(usize, Vec<(f64, f64)>)> = Vec::new();
        for series in 0..drive.drawn.len() {
            let values: Vec<_> = seen.iter().map(|past| (past.t, past.values.get(series).copied().flatten())).collect();
            for line in values.split(|(_, value)| value.is_none()).filter(|line| !line.is_empty()) {
                lines.push((series, line.iter().filter_map(|(t, value)| Some((*t, (*value)?))).collect()));
            }
        }
        let holes: Vec<(f64, f64)> = holes.into_iter().map(|t| (t, low)).collect();
        let mut sets: Vec<Dataset<'_>> = lines
            .iter()
            .filter_map(|(series, line)| {
                let (marker, style, _) = looks.get(*series)?;
                Some(Dataset::default().marker(*marker).style(*style).graph_type(GraphType::Line).data(line))
            })
            .collect();
        let hole = Dataset::default().marker(Marker::Custom('×')).style(self.tint(Color::Red)).data(&holes);
        sets.push(hole.graph_type(GraphType::Scatter));
        let marks = [low, (low + high) / 2.0, high];
        let decimals = usize::from(marks.iter().any(|mark| mark.fract() != 0.0));
        let marks = marks.map(|mark| format!("{mark:.decimals$}"));
        let axis = self.tint(Color::DarkGray);
        let x = Axis::default().style(axis).bounds([from, to]).labels([format!("{from:.0} s"), format!("{to:.0} s")]);
        let y = Axis::default().style(axis).bounds([low, high]).labels(marks);
        frame.render_widget(Paragraph::new(Line::from(legend)), title);
        frame.render_widget(Chart::new(sets).x_axis(x).y_axis(y).legend_position(None), plot);
    }
}

/// Marks for the times from which there is no value: from the last good sample before to the first one after.
fn holes(seen: &[&Past], step: f64) -> Vec<f64> {
    let is_gap = |past: &&Past| past.is_gap;
    let mut marks: Vec<f64> = seen.iter().filter(|past| is_gap(past)).map(|past| past.t).collect();
    for pair in seen.windows(2) {
        if let [before, after] = pair
            && (is_gap(before) || is_gap(after))
        {
            let count = ((after.t - before.t) / step) as usize;
            marks.extend((1..count).map(|index| before.t + step * index as f64));
        }
    }
    marks
}

/// Bounds of an axis that hold all values, and zero, at round numbers.
pub(super) fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((0.0f64, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
    let step = match high - low {
        span if span < 1.0 => 1.0,
        span => 10f64.powf(span.log10().floor()) / 2.0,
    };
    let (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
    (low, if high > low { high } else { low + step })
}
