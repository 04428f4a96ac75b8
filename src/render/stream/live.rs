//! The whole terminal: what drives do, now and over the last minutes.
//!
//! [`Screen`] knows records and draws them, on any terminal that ratatui can draw on, as much of it as fits.
//! [`Terminal`] takes the real one and gives it back, whatever happens; [`Keys`] listens to it.

use super::cells::{Board, GAP, find, is_number, long, number, seconds, short};
use super::{Form, Manner};
use crate::outcome::{Column, Decimal, Record, Sample, StreamStart, WatchedDrive};
use crate::profile::Lang;
use crate::render::clean;
use crate::render::words::word;
use ratatui::Frame;
use ratatui::crossterm::event::{self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use ratatui::crossterm::terminal::{self, EnterAlternateScreen, LeaveAlternateScreen};
use ratatui::crossterm::{cursor, execute};
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::prelude::CrosstermBackend;
use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::Marker;
use ratatui::text::{Line, Span, Text};
use ratatui::widgets::{Axis, Chart, Dataset, GraphType, Paragraph, Row, Table};
use std::collections::VecDeque;
use std::io::{self, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;
use tokio::sync::mpsc;

/// The live view on a real terminal.
pub(super) struct Live<'a> {
    terminal: Terminal<'a>,
    screen: Screen,
    holds_stderr: bool,
}

impl<'a> Live<'a> {
    pub(super) fn new(terminal: Terminal<'a>, manner: Manner) -> io::Result<Self> {
        // Whether there are colours was decided with the settings; crossterm must not look at NO_COLOR for itself.
        ratatui::crossterm::style::force_color_output(manner.color);
        let screen = Screen::new(manner.lang, manner.color);
        let mut live = Live { terminal, screen, holds_stderr: manner.holds_stderr };
        live.draw()?;
        Ok(live)
    }

    fn draw(&mut self) -> io::Result<()> {
        self.terminal.inner.draw(|frame| self.screen.draw(frame)).map(|_| ())
    }
}

impl Form for Live<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        self.screen.record(record);
        self.draw()
    }

    fn note(&mut self, text: &str) -> io::Result<bool> {
        if !text.is_empty() {
            text.clone_into(&mut self.screen.note);
            self.draw()?;
        }
        Ok(self.holds_stderr)
    }

    fn press(&mut self, key: Key) -> io::Result<()> {
        match key {
            Key::Next => self.screen.turn(1),
            Key::Previous => self.screen.turn(-1),
            Key::Redraw | Key::Quit => {}
        }
        self.draw()
    }
}

/// A terminal that was taken over; dropping it gives it back.
pub(super) struct Terminal<'a> {
    inner: ratatui::Terminal<CrosstermBackend<&'a mut dyn Write>>,
}

impl<'a> Terminal<'a> {
    /// Whether there is a terminal that can be taken over.
    pub(super) fn is_there() -> bool {
        let is_there = terminal::enable_raw_mode().is_ok() && terminal::size().is_ok();
        let _as_it_was = terminal::disable_raw_mode();
        is_there
    }

    /// Takes the terminal over.
    pub(super) fn take(out: &'a mut dyn Write) -> io::Result<Self> {
        let mut terminal = Terminal { inner: ratatui::Terminal::new(CrosstermBackend::new(out))? };
        terminal::enable_raw_mode()?;
        execute!(terminal.inner.backend_mut(), EnterAlternateScreen, cursor::Hide)?;
        Ok(terminal)
    }
}

impl Drop for Terminal<'_> {
    fn drop(&mut self) {
        let _closed = execute!(self.inner.backend_mut(), LeaveAlternateScreen, cursor::Show);
        let _closed = terminal::disable_raw_mode();
    }
}

/// What a key is good for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// q, Escape, Ctrl-C: end.
    Quit,
    /// Tab, right: the next drive.
    Next,
    /// Left: the drive before.
    Previous,
    /// The terminal has another size.
    Redraw,
}

impl Key {
    fn of(event: &Event) -> Option<Key> {
        match event {
            Event::Resize(..) => Some(Key::Redraw),
            Event::Key(KeyEvent { kind: KeyEventKind::Release, .. }) => None,
            Event::Key(KeyEvent { code, modifiers, .. }) => match code {
                KeyCode::Char('c' | 'd') if modifiers.contains(KeyModifiers::CONTROL) => Some(Key::Quit),
                KeyCode::Char('q' | 'Q') | KeyCode::Esc => Some(Key::Quit),
                KeyCode::Tab | KeyCode::Right => Some(Key::Next),
                KeyCode::BackTab | KeyCode::Left => Some(Key::Previous),
                KeyCode::Char('l') if modifiers.contains(KeyModifiers::CONTROL) => Some(Key::Redraw),
                _ => None,
            },
            _ => None,
        }
    }
}

/// The keys of a terminal that was taken over, read by a thread of their own.
#[derive(Debug)]
pub struct Keys {
    coming: mpsc::UnboundedReceiver<Key>,
    over: Arc<AtomicBool>,
}

/// So long the thread may outlive its listener.
const LOOK: Duration = Duration::from_millis(100);

impl Keys {
    pub(super) fn read() -> Self {
        let (send, coming) = mpsc::unbounded_channel();
        let over = Arc::new(AtomicBool::new(false));
        let ends = over.clone();
        std::thread::spawn(move || {
            while !ends.load(Ordering::Relaxed) {
                let key = match event::poll(LOOK) {
                    Ok(false) => continue,
                    Ok(true) => event::read(),
                    Err(error) => Err(error),
                };
                // A terminal that cannot be read has gone; SIGHUP or the next write tells.
                let Ok(key) = key else { return };
                if Key::of(&key).is_some_and(|key| send.send(key).is_err()) {
                    return;
                }
            }
        });
        Keys { coming, over }
    }

    /// The next key; never comes if the terminal is gone.
    pub async fn next(&mut self) -> Key {
        match self.coming.recv().await {
            Some(key) => key,
            None => std::future::pending().await,
        }
    }
}

impl Drop for Keys {
    fn drop(&mut self) {
        self.over.store(true, Ordering::Relaxed);
    }
}

/// What is known of a drive, and what was.
struct Drive {
    about: WatchedDrive,
    /// Indices of the columns that are drawn: setpoint and actual value, or the first numbers of one unit.
    drawn: Vec<usize>,
    last: Option<Sample>,
    past: VecDeque<Past>,
}

/// A sample as far as it is drawn.
struct Past {
    t: f64,
    values: Vec<Option<f64>>,
}

/// The live view without a terminal.
pub(super) struct Screen {
    lang: Lang,
    color: bool,
    start: Option<StreamStart>,
    drives: Vec<Drive>,
    /// The drive whose chart and values are shown.
    turned_to: usize,
    t: Decimal,
    rounds: u64,
    gaps: u64,
    lost: bool,
    note: String,
}

/// Most samples of a drive that are kept.
const KEPT: usize = 2_000;
/// Fewest seconds that the chart spans; with long intervals it is more.
const SPAN: f64 = 60.0;
/// Fewest lines of a chart with its axis.
const CHART: u16 = 7;
/// Fewest columns of a chart.
const CHART_WIDTH: u16 = 36;

impl Screen {
    fn new(lang: Lang, color: bool) -> Self {
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
        }
    }

    fn record(&mut self, record: &Record) {
        match record {
            Record::Start(start) => {
                self.drives = start.drives.iter().map(|drive| Drive::new(drive.clone())).collect();
                self.start = Some(start.clone());
            }
            Record::Sample(sample) => {
                self.t = sample.t;
                self.rounds = sample.n + 1;
                self.gaps += u64::from(sample.error.is_some());
                let drive = self.drives.iter_mut().find(|drive| drive.about.address == sample.address);
                if let Some(drive) = drive {
                    drive.take(sample);
                }
            }
            Record::Lost(_) => self.lost = true,
            Record::Reopened(_) => self.lost = false,
            Record::Telegram(_) | Record::End(_) => {}
        }
    }

    /// Shows another drive.
    fn turn(&mut self, by: isize) {
        let count = self.drives.len() as isize;
        if count > 0 {
            self.turned_to = (self.turned_to as isize + by).rem_euclid(count) as usize;
        }
    }

    fn word(&self, english: &'static str) -> &'static str {
        word(self.lang, english)
    }

    fn draw(&self, frame: &mut Frame<'_>) {
        let area = frame.area();
        let drives = (self.drives.len() as u16).min((area.height / 4).max(1));
        let (head, foot) = (u16::from(area.height >= 3), u16::from(area.height >= 5));
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
        let all = [format!(" antrieb monitor  {place}  {counts}"), format!(" {place}  {counts}"), format!(" {counts}")];
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
        let Some(sample) = &drive.last else { return Line::raw(format!("{marker}{}", drive.about.address)) };
        let mut spans = vec![Span::styled(format!("{marker}{} {}  ", sample.address, clean(&sample.drive)), bold)];
        if let Some(error) = &sample.error {
            let text = format!("{}: {}", self.word("gap"), clean(&error.message));
            spans.push(Span::styled(text, self.tint(Color::Red).add_modifier(Modifier::BOLD)));
            return Line::from(spans);
        }
        if let Some(state) = &sample.state {
            let tint = match state.slug.as_str() {
                "operation-enabled" => self.tint(Color::Green),
                slug if slug.starts_with("fault") => self.tint(Color::Red),
                _ => Style::new(),
            };
            spans.push(Span::styled(clean(&state.name), tint.add_modifier(Modifier::BOLD)));
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
            let names = if brief { short(column, Some(value), self.lang) } else { long(column, value, self.lang) };
            let tint = if present { self.tint(color).add_modifier(Modifier::BOLD) } else { Style::new() };
            spans.push(Span::raw(format!("  {}: ", self.word(role))));
            spans.push(Span::styled(clean(&names), tint));
        }
        Line::from(spans)
    }

    fn foot(&self, frame: &mut Frame<'_>, area: Rect) {
        let next = if self.drives.len() > 1 { format!("  Tab {}", self.word("next drive")) } else { String::new() };
        let keys = format!(" q {}{next}", self.word("end"));
        let note = if self.note.is_empty() { keys } else { format!("{keys}  {}", clean(&self.note)) };
        frame.render_widget(Paragraph::new(note).style(Style::new().add_modifier(Modifier::DIM)), area);
    }

    fn table(&self, frame: &mut Frame<'_>, area: Rect, drive: &Drive) {
        let board = Board { columns: drive.about.columns.clone() };
        let columns = board.columns.iter().filter(|column| column.role != Some("status-word"));
        let rows = columns.map(|column| {
            let value = drive.last.as_ref().and_then(|sample| find(column, sample));
            let shown = match value {
                Some(value) if is_number(column) => number(value),
                value => short(column, value, self.lang),
            };
            let text = value.map_or_else(|| self.why(drive, column), |value| long(column, value, self.lang));
            let text = if text == shown { String::new() } else { text };
            let unit = column.unit.as_ref().filter(|_| value.is_some());
            let set = if column.data_set > 0 { format!("@{}", column.data_set) } else { String::new() };
            Row::new([
                Text::raw(format!("{}{set}", column.param)).right_aligned(),
                Text::raw(clean(&column.name)),
                Text::raw(clean(&shown)).right_aligned(),
                Text::raw(unit.map_or_else(String::new, |unit| clean(unit))),
                Text::raw(clean(&text)),
            ])
        });
        let name = if area.width < 60 { Constraint::Fill(1) } else { Constraint::Length(30) };
        let text = if area.width < 60 { Constraint::Length(0) } else { Constraint::Fill(1) };
        let widths = [Constraint::Length(6), name, Constraint::Length(10), Constraint::Length(5), text];
        frame.render_widget(Table::new(rows, widths), area);
    }

    /// Why a value is missing though its drive answers.
    fn why(&self, drive: &Drive, column: &Column) -> String {
        let Some(sample) = drive.last.as_ref().filter(|sample| sample.error.is_none()) else { return String::new() };
        let value = sample.values.iter().find(|value| column.holds(&value.value));
        value.and_then(|value| value.value.error.as_ref()).map_or_else(String::new, |error| error.message.clone())
    }

    fn chart(&self, frame: &mut Frame<'_>, area: Rect, drive: &Drive) {
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
        let interval = self.start.as_ref().map_or(1.0, |start| float(start.interval));
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

    fn tint(&self, color: Color) -> Style {
        if self.color { Style::new().fg(color) } else { Style::new() }
    }
}

impl Drive {
    fn new(about: WatchedDrive) -> Self {
        let role = |roles: &[&str]| {
            let found = |column: &Column| column.scaled && column.role.is_some_and(|role| roles.contains(&role));
            about.columns.iter().position(found)
        };
        let setpoint = role(&["setpoint-ramp", "setpoint-bus"]);
        let actual = role(&["actual-frequency", "stator-frequency", "encoder-frequency", "actual-speed"]);
        let mut drawn: Vec<usize> = setpoint.into_iter().chain(actual).collect();
        if drawn.is_empty() {
            let numbers = about.columns.iter().enumerate().filter(|(_, column)| is_number(column));
            let first = numbers.clone().next().and_then(|(_, column)| column.unit.clone());
            drawn = numbers.filter(|(_, column)| column.unit == first).map(|(index, _)| index).take(2).collect();
        }
        Drive { about, drawn, last: None, past: VecDeque::new() }
    }

    fn take(&mut self, sample: &Sample) {
        let value = |index: &usize| find(self.about.columns.get(*index)?, sample)?.value.map(float);
        let values = self.drawn.iter().map(value).collect();
        if self.past.len() == KEPT {
            self.past.pop_front();
        }
        self.past.push_back(Past { t: float(sample.t), values });
        self.last = Some(sample.clone());
    }
}

/// Marks for the times from which there is no value: from the last good sample before to the first one after.
fn holes(seen: &[&Past], step: f64) -> Vec<f64> {
    let is_gap = |past: &&Past| past.values.iter().all(Option::is_none);
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

fn float(decimal: Decimal) -> f64 {
    decimal.raw as f64 / 10f64.powi(decimal.decimals.into())
}

/// Bounds of an axis that hold all values, and zero, at round numbers.
fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values.fold((0.0f64, 0.0f64), |(low, high), value| (low.min(value), high.max(value)));
    let step = match high - low {
        span if span < 1.0 => 1.0,
        span => 10f64.powf(span.log10().floor()) / 2.0,
    };
    let (low, high) = ((low / step).floor() * step, (high / step).ceil() * step);
    (low, if high > low { high } else { low + step })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::failure::{Class, Failure};
    use crate::outcome::{ErrorDoc, SampleValue, State, Value};
    use ratatui::backend::TestBackend;

    fn column(param: u32, name: &str, unit: Option<&str>, role: &'static str) -> Column {
        Column {
            param,
            data_set: 0,
            store: "ram",
            slug: role.to_owned(),
            name: name.to_owned(),
            unit: unit.map(str::to_owned),
            role: Some(role),
            scaled: true,
        }
    }

    fn watched(address: u8) -> WatchedDrive {
        let columns = vec![
            column(411, "State word", None, "status-word"),
            column(283, "Ramp reference frequency", Some("Hz"), "setpoint-ramp"),
            column(210, "Stator frequency", Some("Hz"), "stator-frequency"),
            column(260, "Current\u{1b} error", None, "fault"),
        ];
        WatchedDrive { address, drive: "act".to_owned(), title: None, columns }
    }

    fn at(second: i64) -> Decimal {
        Decimal { raw: second * 1_000_000, decimals: 6 }
    }

    /// A sample of every column; `None` is a gap.
    fn sample(address: u8, n: u64, raw: Option<i64>) -> Record {
        let t = at(n as i64);
        let columns = watched(address).columns;
        let error =
            raw.is_none().then(|| ErrorDoc::from(&Failure::new(Class::Silence, "silence.no_reply", "no reply")));
        let value = |column: Column| Value {
            address,
            node: 0,
            drive: "act".to_owned(),
            param: column.param,
            slug: column.slug,
            name: column.name,
            data_set: 0,
            store: "ram",
            raw: if column.param == 260 { raw.map(|_| 0) } else { raw },
            value: raw.map(|raw| Decimal { raw, decimals: 2 }),
            decimals: Some(2),
            unit: column.unit,
            text: None,
            word: None,
            kind: None,
            origin: String::new(),
            unconfirmed: Vec::new(),
            expected: None,
            error: error.clone(),
            hex: false,
        };
        Record::Sample(Sample {
            t,
            n,
            address,
            drive: "act".to_owned(),
            state: raw.map(|_| State { slug: "operation-enabled".to_owned(), name: "Operation enabled".to_owned() }),
            values: columns.into_iter().map(|column| SampleValue { t, value: value(column) }).collect(),
            error: error.clone(),
        })
    }

    fn screen(drives: u8, samples: &[Option<i64>]) -> Screen {
        let mut screen = Screen::new(Lang::En, false);
        screen.record(&Record::Start(StreamStart {
            t: at(0),
            schema: 1,
            tool: "antrieb",
            command: "monitor",
            port: "sim".to_owned(),
            line: "19200 8E1".to_owned(),
            protocol: "rtu",
            interval: at(1),
            drives: (1..=drives).map(watched).collect(),
        }));
        for (n, raw) in (0..).zip(samples) {
            (1..=drives).for_each(|address| screen.record(&sample(address, n, *raw)));
        }
        screen
    }

    fn drawn(screen: &Screen, width: u16, height: u16) -> Vec<String> {
        let mut terminal = ratatui::Terminal::new(TestBackend::new(width, height)).unwrap();
        terminal.draw(|frame| screen.draw(frame)).unwrap();
        let buffer = terminal.backend().buffer();
        let cells: Vec<&str> = buffer.content().iter().map(|cell| cell.symbol()).collect();
        cells.chunks(width.into()).map(|row| row.concat().trim_end().to_owned()).collect()
    }

    #[test]
    fn it_draws_on_every_terminal() {
        let many = screen(9, &[Some(0), None, Some(-500), Some(2_500)]);
        for screen in [Screen::new(Lang::De, true), screen(0, &[]), screen(1, &[None]), many] {
            for width in [1, 2, 9, 36, 59, 60, 130] {
                [1, 2, 3, 4, 5, 8, 12, 15, 30].into_iter().for_each(|height| drop(drawn(&screen, width, height)));
            }
        }
    }

    #[test]
    fn a_wide_terminal_shows_chart_and_table() {
        let shown = drawn(&screen(1, &[Some(0), Some(1_250), Some(2_500), None, Some(2_500)]), 100, 30);
        let page = shown.join("\n");
        assert!(shown[0].contains("sim  19200 8E1 rtu  4.000 s  #5  gaps: 1"), "{page}");
        assert!(shown[1].contains("1 act  Operation enabled  fault: none"), "{page}");
        assert!(shown[2].contains("setpoint 25.00 Hz") && shown[2].contains("actual 25.00 Hz"), "{page}");
        assert!(page.contains('×') && page.contains("gap"), "{page}");
        assert!(shown[28].contains("260 Current\\u{1b} error"), "{page}");
        assert!(shown.iter().any(|line| line.starts_with("25.0│")), "{page}");
    }

    #[test]
    fn a_narrow_terminal_shows_less() {
        let screen = screen(1, &[Some(0), Some(2_500)]);
        // Chart and table.
        assert!(drawn(&screen, 60, 20).iter().any(|line| line.contains('│')));
        // The table without the chart, then only the drive.
        let small = drawn(&screen, 40, 8);
        assert!(!small.iter().any(|line| line.contains('│')) && small.iter().any(|line| line.contains("25.00")));
        assert_eq!(drawn(&screen, 40, 1), [" 1 act  Operation enabled  fault: none"]);
        assert_eq!(drawn(&screen, 26, 1), [" 1 act  Operation enabled"]);
    }

    #[test]
    fn lines_of_a_chart_end_where_a_gap_begins() {
        let mut screen = screen(1, &[Some(2_500), Some(2_500), None, None, None, Some(2_500), Some(2_500)]);
        let top = |screen: &Screen| drawn(screen, 100, 30)[3].clone();
        assert!(top(&screen).trim_end_matches(' ').contains("   "), "{}", top(&screen));
        screen.turn(1);
        assert_eq!(screen.turned_to, 0);
    }

    #[test]
    fn axes_hold_all_values_at_round_numbers() {
        assert_eq!(bounds([0.0].into_iter()), (0.0, 1.0));
        assert_eq!(bounds([3.0, 24.9].into_iter()), (0.0, 25.0));
        assert_eq!(bounds([-12.0, 49.0].into_iter()), (-15.0, 50.0));
        assert_eq!(bounds(std::iter::empty()), (0.0, 1.0));
    }

    #[test]
    fn keys_that_end_it() {
        let key = |code, modifiers| Key::of(&Event::Key(KeyEvent::new(code, modifiers)));
        assert_eq!(key(KeyCode::Char('q'), KeyModifiers::NONE), Some(Key::Quit));
        assert_eq!(key(KeyCode::Char('c'), KeyModifiers::CONTROL), Some(Key::Quit));
        assert_eq!(key(KeyCode::Char('c'), KeyModifiers::NONE), None);
        assert_eq!(key(KeyCode::Tab, KeyModifiers::NONE), Some(Key::Next));
    }
}
