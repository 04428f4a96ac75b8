//! The live view without a terminal: a line for every drive, and the values of one of them.

use super::past::{Drive, float};
use crate::failure::{may_turn, unanswered_stop};
use crate::outcome::{Column, Decimal, Record, RunNews, Sample, StreamStart, addressed};
use crate::profile::Lang;
use crate::render::clean;
use crate::render::stream::cells::{Board, find, first_of, is_number, long, number, seconds, short};
use crate::render::words::word;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span, Text};
use ratatui::widgets::{Paragraph, Row, Table};
use std::collections::VecDeque;

/// The live view without a terminal.
pub(super) struct Screen {
    pub(super) lang: Lang,
    pub(super) color: bool,
    pub(super) start: Option<StreamStart>,
    pub(super) drives: Vec<Drive>,
    /// The drive whose chart and values are shown.
    pub(super) turned_to: usize,
    pub(super) t: Decimal,
    pub(super) rounds: u64,
    pub(super) gaps: u64,
    pub(super) lost: bool,
    pub(super) note: String,
    /// When that was said.
    noted: Decimal,
    /// That nothing proves that the shaft stands: it stays, whatever else is said, until the drive answers or the run comes to its next part.
    pub(super) alarm: String,
    /// What was said, as far as it may be shown again.
    pub(super) notes: VecDeque<String>,
    /// Where a run has come to, if this is one.
    pub(super) run: Option<RunNews>,
    /// The diagnosis stands in place of the chart.
    pub(super) diagnoses: bool,
}

/// A key that is taken in part is told so before the setpoint is given that it leads to; microseconds.
const AT_ONCE: i64 = 600_000;

/// Notes that are kept.
const NOTES: usize = 8;

/// Fewest lines of a chart with its axis.
const CHART: u16 = 7;
/// Fewest columns of a chart.
const CHART_WIDTH: u16 = 36;

impl Screen {
    pub(super) fn new(lang: Lang, color: bool) -> Self {
        Screen {
            lang,
            color,
            start: None,
            drives: Vec::new(),
            turned_to: 0,
            t: Decimal { raw: 0, decimals: 6 },
            rounds: 0,
            gaps: 0,
            lost: false,
            note: String::new(),
            noted: Decimal { raw: 0, decimals: 6 },
            alarm: String::new(),
            notes: VecDeque::new(),
            run: None,
            diagnoses: false,
        }
    }

    pub(super) fn record(&mut self, record: &Record) {
        match record {
            Record::Start(start) => {
                self.drives = start.drives.iter().map(|drive| Drive::new(drive.clone())).collect();
                self.start = Some(start.clone());
            }
            Record::Sample(sample) => {
                self.t = sample.t;
                self.rounds = sample.n + 1;
                self.gaps += u64::from(sample.error.is_some());
                // Who answers again is heard. Of a stop that is not obeyed, or was not proven, an answer proves nothing.
                if sample.error.is_none() && self.alarm == unanswered_stop().get(self.lang) {
                    self.alarm.clear();
                }
                let drive = self.drives.iter_mut().find(|drive| drive.about.address == sample.address);
                if let Some(drive) = drive {
                    drive.take(sample);
                }
            }
            Record::Lost(_) => self.lost = true,
            Record::Reopened(_) => self.lost = false,
            Record::Run(news) => {
                // What was said before belongs to what was then, and what a key was told to the setpoint that it was told at.
                let is_new = |run: &RunNews| {
                    run.phase != news.phase
                        || run.setpoint != news.setpoint && news.t.raw > self.noted.raw.saturating_add(AT_ONCE)
                };
                if self.run.as_ref().is_none_or(is_new) {
                    self.note.clear();
                    self.alarm.clear();
                }
                // That it runs, or how it stops, holds no more once it does not.
                if self.run.as_ref().is_some_and(|run| run.phase != news.phase)
                    && matches!(news.phase, "stopping" | "ended")
                {
                    self.notes.clear();
                }
                self.run = Some(news.clone());
            }
            // They are told as notes.
            Record::Trigger(_) | Record::Trip(_) => {}
            Record::Telegram(_) | Record::Statistics(_) | Record::Search(_) | Record::Station(_) | Record::End(_) => {}
        }
    }

    /// Somebody has something to say.
    pub(super) fn note(&mut self, text: &str) {
        let unanswered = unanswered_stop();
        let unanswered = unanswered.get(self.lang);
        // What an answer would end does not take the place of what it does not.
        let outlives = !self.alarm.is_empty() && self.alarm != unanswered && text == unanswered;
        let is_alarm = text.starts_with(may_turn().get(self.lang)) && !outlives;
        if is_alarm && text != unanswered {
            // What was said of the stop that is not obeyed holds no more.
            self.note.clear();
        }
        text.clone_into(if is_alarm { &mut self.alarm } else { &mut self.note });
        self.noted = self.t;
        // Who leans on a key hears the same again and again.
        self.notes.retain(|said| said != text);
        self.notes.push_back(text.to_owned());
        self.notes.drain(..self.notes.len().saturating_sub(NOTES));
    }

    /// Shows another drive.
    pub(super) fn turn(&mut self, by: isize) {
        let count = self.drives.len() as isize;
        if count > 0 {
            self.turned_to = (self.turned_to as isize + by).rem_euclid(count) as usize;
        }
    }

    pub(super) fn word(&self, english: &'static str) -> &'static str {
        word(self.lang, english)
    }

    pub(super) fn draw(&self, frame: &mut Frame<'_>) {
        let area = frame.area();
        let drives = (self.drives.len() as u16).min((area.height / 4).max(1));
        let foot = match &self.run {
            Some(run) => (self.said(run, area.width).len() as u16).min(area.height / 3),
            None => u16::from(area.height >= 5),
        };
        let head = u16::from(area.height >= 3);
        let [head, list, body, foot] = Layout::vertical([
            Constraint::Length(head),
            Constraint::Length(drives),
            Constraint::Min(0),
            Constraint::Length(foot),
        ])
        .areas(area);
        self.head(frame, head);
        self.list(frame, list);
        self.foot(frame, foot);
        let Some(drive) = self.drives.get(self.turned_to) else { return };
        if self.diagnoses {
            return self.diagnosis(frame, body, drive);
        }
        let rows = drive.about.columns.iter().filter(|column| column.role != Some("status-word")).count() as u16;
        let has_chart = !drive.drawn.is_empty() && body.width >= CHART_WIDTH && body.height >= CHART + rows.min(4);
        let table = if has_chart { rows.min(body.height - CHART) } else { body.height };
        let [chart, table] = Layout::vertical([Constraint::Min(0), Constraint::Length(table)]).areas(body);
        if has_chart {
            self.chart(frame, chart, drive);
        }
        self.table(frame, table, drive);
    }

    fn head(&self, frame: &mut Frame<'_>, area: Rect) {
        let place = self.start.as_ref().map_or_else(
            || self.word("connecting").to_owned(),
            |start| format!("{}  {} {}", clean(&start.port), start.line, start.protocol),
        );
        let lost = if self.lost { format!("  {}", self.word("PORT LOST")) } else { String::new() };
        let counts = format!("{} s  #{}  {}: {}{lost}", seconds(self.t), self.rounds, self.word("gaps"), self.gaps);
        let command = self.start.as_ref().map_or("monitor", |start| start.command);
        let all =
            [format!(" antrieb {command}  {place}  {counts}"), format!(" {place}  {counts}"), format!(" {counts}")];
        let fits = |text: &&String| Line::raw(text.as_str()).width() <= area.width.into();
        let text = all.iter().find(fits).or(all.last()).cloned().unwrap_or_default();
        frame.render_widget(Paragraph::new(text).style(Style::new().add_modifier(Modifier::REVERSED)), area);
    }

    fn list(&self, frame: &mut Frame<'_>, area: Rect) {
        // The drive that is shown is always among those listed.
        let first = (self.turned_to + 1).saturating_sub(area.height.into());
        let lines = self.drives.iter().enumerate().skip(first).take(area.height.into());
        let lines: Vec<_> = lines
            .map(|(index, drive)| {
                let [whole, brief] = [false, true].map(|brief| self.drive(drive, index == self.turned_to, brief));
                if whole.width() <= area.width.into() { whole } else { brief }
            })
            .collect();
        frame.render_widget(Paragraph::new(lines), area);
    }

    /// What a drive does, in a line; briefly where codes must do for names.
    fn drive<'l>(&self, drive: &'l Drive, shown: bool, brief: bool) -> Line<'l> {
        let bold = Style::new().add_modifier(Modifier::BOLD);
        let marker = if shown && self.drives.len() > 1 { ">" } else { " " };
        let Some(sample) = &drive.last else {
            return Line::raw(format!("{marker}{}", addressed(drive.about.address, drive.about.node)));
        };
        let mut spans = vec![Span::styled(
            format!("{marker}{} {}  ", addressed(sample.address, sample.node), clean(&sample.drive)),
            bold,
        )];
        if let Some(error) = &sample.error {
            let text = format!("{}: {}", self.word("gap"), clean(error.message.get(self.lang)));
            spans.push(Span::styled(text, self.tint(Color::Red).add_modifier(Modifier::BOLD)));
            return Line::from(spans);
        }
        if let Some(state) = &sample.state {
            let tint = match state.slug.as_str() {
                "operation-enabled" => self.tint(Color::Green),
                slug if slug.starts_with("fault") => self.tint(Color::Red),
                _ => Style::new(),
            };
            spans.push(Span::styled(clean(state.name.get(self.lang)), tint.add_modifier(Modifier::BOLD)));
        }
        for (role, color) in [("fault", Color::Red), ("warnings", Color::Yellow)] {
            let column = drive.about.columns.iter().find(|column| column.role == Some(role));
            let Some((column, value)) = column.and_then(|column| Some((column, find(column, sample)?))) else {
                continue;
            };
            let present = value.raw != Some(0);
            if brief && !present {
                continue;
            }
            let names = match (brief, role) {
                (true, "fault") => short(column, Some(value), self.lang),
                (true, _) => first_of(column, value, self.lang),
                (false, _) => long(column, value, self.lang),
            };
            let tint = if present { self.tint(color).add_modifier(Modifier::BOLD) } else { Style::new() };
            spans.push(Span::raw(format!("  {}: ", self.word(role))));
            spans.push(Span::styled(clean(&names), tint));
        }
        Line::from(spans)
    }

    fn foot(&self, frame: &mut Frame<'_>, area: Rect) {
        if let Some(run) = &self.run {
            let lines: Vec<_> = self.said(run, area.width).into_iter().map(Line::raw).collect();
            return frame.render_widget(Paragraph::new(lines), area);
        }
        let next = if self.drives.len() > 1 { format!("  Tab {}", self.word("next drive")) } else { String::new() };
        let keys = format!(" q {}{next}", self.word("end"));
        let note = if self.note.is_empty() { keys } else { format!("{keys}  {}", clean(&self.note)) };
        frame.render_widget(Paragraph::new(note).style(Style::new().add_modifier(Modifier::DIM)), area);
    }

    fn table(&self, frame: &mut Frame<'_>, area: Rect, drive: &Drive) {
        let board = Board { columns: drive.about.columns.clone() };
        let columns = board.columns.iter().filter(|column| column.role != Some("status-word"));
        let (mut names, mut words) = (NAMES, WORDS);
        let wider = |most: &mut u16, text: &str| {
            let width = u16::try_from(Line::raw(text).width()).unwrap_or(u16::MAX);
            *most = width.max(*most);
        };
        let rows: Vec<_> = columns
            .map(|column| {
                let value = drive.last.as_ref().and_then(|sample| find(column, sample));
                let shown = match value {
                    Some(value) if is_number(column) => number(value),
                    value => short(column, value, self.lang),
                };
                let text = value.map_or_else(|| self.why(drive, column), |value| long(column, value, self.lang));
                let text = if text == shown { String::new() } else { text };
                let age = drive.last.as_ref().and_then(|sample| age(column, sample));
                let style = if age.is_some() { Style::new().add_modifier(Modifier::DIM) } else { Style::new() };
                let text = age.map_or(text, |age| self.lang.pick("{} s ago", "vor {} s").replace("{}", &age));
                let unit = column.unit.as_ref().filter(|_| value.is_some());
                let set = if column.data_set > 0 { format!("@{}", column.data_set) } else { String::new() };
                let (name, text) = (clean(column.name.get(self.lang)), clean(&text));
                wider(&mut names, &name);
                wider(&mut words, &text);
                Row::new([
                    Text::raw(format!("{}{set}", column.param)).right_aligned(),
                    Text::raw(name),
                    Text::raw(clean(&shown)).right_aligned(),
                    Text::raw(unit.map_or_else(String::new, |unit| clean(unit))),
                    Text::raw(text),
                ])
                .style(style)
            })
            .collect();
        // Whole, as far as there is room for it beside what the numbers say in words.
        let name = names.min(area.width.saturating_sub(6 + 10 + 5 + 4).saturating_sub(words)).max(NAMES);
        let name = if area.width < 60 { Constraint::Fill(1) } else { Constraint::Length(name) };
        let text = if area.width < 60 { Constraint::Length(0) } else { Constraint::Fill(1) };
        let widths = [Constraint::Length(6), name, Constraint::Length(10), Constraint::Length(5), text];
        frame.render_widget(Table::new(rows, widths), area);
    }

    /// Why a value is missing though its drive answers.
    fn why(&self, drive: &Drive, column: &Column) -> String {
        let Some(sample) = drive.last.as_ref().filter(|sample| sample.error.is_none()) else { return String::new() };
        let value = sample.values.iter().find(|value| column.holds(&value.value));
        value
            .and_then(|value| value.value.error.as_ref())
            .map_or_else(String::new, |error| error.message.get(self.lang).to_owned())
    }

    pub(super) fn tint(&self, color: Color) -> Style {
        if self.color { Style::new().fg(color) } else { Style::new() }
    }
}

/// So many columns at least are kept for names, and for what numbers say in words.
const NAMES: u16 = 30;
const WORDS: u16 = 15;

/// A value older than this says so: what is beside it may be of now.
const OLD: f64 = 1.0;

/// How old a value is when its sample is told, in seconds, if it is not of now.
fn age(column: &Column, sample: &Sample) -> Option<String> {
    let value = sample.values.iter().find(|value| column.holds(&value.value))?;
    let age = float(sample.t) - float(value.t);
    (age > OLD).then(|| format!("{age:.1}"))
}
