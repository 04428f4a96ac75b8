//! A stream on its way out: records as they come, in the form that was asked for.
//!
//! One file a form. A form gets [`Record`]s and nothing else; it reads no clock, and what it cannot write ends the
//! stream. Notes for people go to stderr as ever, unless a form has the whole terminal.

pub(super) mod cells;
mod csv;
mod influx;
mod lines;
mod live;
mod metrics;
mod ndjson;
mod openmetrics;
mod pcap;
mod recorder;
mod telegrams;
mod ticker;

pub use live::{Key, Keys, Picture};
pub use openmetrics::Keep;
pub use recorder::Place;

use super::{Console, Outlet};
use crate::outcome::{
    Data, Decimal, ErrorDoc, Event, Monitor, Outcome, Record, SCHEMA_VERSION, SniffCount, SniffSummary, StreamEnd,
    StreamSummary,
};
use crate::text::{Lang, Text, both};
use std::io::{self, Write};

/// Form of a stream.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// One object a line.
    Ndjson,
    /// One row a sample, under a head line.
    Csv,
    /// InfluxDB line protocol.
    Influx,
    /// OpenMetrics text.
    OpenMetrics,
    /// One line a sample, for people.
    Lines,
    /// One line a telegram, for people.
    Telegrams,
    /// Telegrams as a capture.
    Pcap,
    /// One line that is refreshed.
    Ticker,
    /// The whole terminal: a chart and a table.
    Live,
}

/// What a form for people needs to know.
#[derive(Clone, Copy, Debug, Default)]
pub struct Manner {
    /// Language.
    pub lang: Lang,
    /// Columns of the terminal, if there is one.
    pub width: Option<u16>,
    /// Everything that was found is shown, not only what matters first.
    pub full: bool,
    /// Colours may be used.
    pub color: bool,
    /// stderr is the same terminal, so a form that has all of it must show the notes itself.
    pub holds_stderr: bool,
    /// Telegrams are frames of a CAN bus.
    pub is_can: bool,
    /// Node of the system bus behind every drive that is told of; 0 is the drive itself.
    pub node: u8,
}

impl Manner {
    /// Into a pipe: without a terminal, and short.
    pub fn of(lang: Lang) -> Self {
        Manner { lang, ..Manner::default() }
    }
}

/// One form of a stream.
trait Form {
    /// Writes a record, and flushes.
    fn record(&mut self, record: &Record) -> io::Result<()>;

    /// Somebody has something to say: shows it, or makes room for it on stderr and returns false.
    fn note(&mut self, _text: &str) -> io::Result<bool> {
        Ok(false)
    }

    /// Draws what had to wait for the terminal.
    fn catch_up(&mut self) -> io::Result<()> {
        Ok(())
    }

    /// A key was pressed.
    fn press(&mut self, _key: Key) -> io::Result<()> {
        Ok(())
    }
}

/// A stream that is being written.
pub struct Stream<'a> {
    form: Box<dyn Form + 'a>,
    view: View,
    manner: Manner,
    console: Console,
    keys: Option<Keys>,
    /// What is written waits here for its reader.
    queue: Option<Outlet>,
    /// What is written beside it.
    beside: Option<openmetrics::Beside>,
    /// What is kept in a file.
    recorder: Option<recorder::Recorder>,
    broken: Option<io::Error>,
}

impl std::fmt::Debug for Stream<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stream").field("view", &self.view).finish_non_exhaustive()
    }
}

impl<'a> Stream<'a> {
    /// Begins a stream to `out`. A terminal that cannot be taken over gets lines.
    pub fn open(view: View, out: &'a mut dyn Write, manner: Manner, console: &Console) -> io::Result<Self> {
        let view = if view == View::Live && !live::Terminal::is_there() { View::Lines } else { view };
        let form: Box<dyn Form + 'a> = match view {
            View::Ndjson => Box::new(ndjson::Ndjson::new(Box::new(out), manner.lang)),
            View::Csv => Box::new(csv::Csv::new(Box::new(out), manner.lang)),
            View::Influx => Box::new(influx::Influx::new(out)),
            View::OpenMetrics => Box::new(openmetrics::OpenMetrics::new(out)),
            View::Lines => Box::new(lines::Lines::new(out, manner.lang)),
            View::Telegrams => Box::new(telegrams::Telegrams::new(out, manner)),
            View::Pcap => Box::new(pcap::Pcap::new(Box::new(out), manner.is_can)?),
            View::Ticker => Box::new(ticker::Ticker::new(out, manner)),
            View::Live => {
                let (keys, ear) = Keys::new();
                let form = Box::new(live::Live::take(Box::new(out), None, manner, ear)?);
                return Ok(Stream::of(form, view, manner, console, Some(keys)));
            }
        };
        Ok(Stream::of(form, view, manner, console, None))
    }

    /// The same, with every round as Prometheus' text beside it.
    pub fn beside(self, keep: Option<Keep>) -> Self {
        Stream { beside: keep.map(openmetrics::Beside::new), ..self }
    }

    /// The same, kept in a file: as [`View::Csv`], else as [`View::Ndjson`].
    pub fn recorded(self, kept: Option<(View, Place)>) -> Self {
        let recorder = kept.map(|(view, place)| recorder::Recorder::new(view, self.manner, place));
        Stream { recorder, ..self }
    }

    /// Begins the stream of a run, for which nobody waits: the terminal is taken over with its first record, and given back by
    /// [`Stream::close`].
    pub fn of_run(
        view: View,
        queue: Option<Outlet>,
        out: &'a mut dyn Write,
        manner: Manner,
        console: &Console,
    ) -> Self {
        match (view, queue) {
            (View::Live, Some(queue)) => {
                let (keys, ear) = Keys::new();
                Stream::of(Box::new(live::Late::new(queue, manner, ear)), view, manner, console, Some(keys))
            }
            (_, Some(queue)) => {
                let form = ndjson::Ndjson::new(Box::new(queue.at_once()), manner.lang);
                let stream = Stream::of(Box::new(form), View::Ndjson, manner, console, None);
                Stream { queue: Some(queue), ..stream }
            }
            (_, None) => {
                let form = ndjson::Ndjson::new(Box::new(out), manner.lang);
                Stream::of(Box::new(form), View::Ndjson, manner, console, None)
            }
        }
    }

    fn of(form: Box<dyn Form + 'a>, view: View, manner: Manner, console: &Console, keys: Option<Keys>) -> Self {
        let (queue, beside, recorder, broken) = (None, None, None, None);
        Stream { form, view, manner, console: console.clone(), keys, queue, beside, recorder, broken }
    }

    /// Whether a terminal can be taken over.
    pub fn has_terminal() -> bool {
        live::Terminal::is_there()
    }

    /// Gives the terminal back, or waits until the records are out: what comes behind a run says itself how it ended.
    pub fn close(self) {
        let Stream { form, mut queue, .. } = self;
        drop(form);
        queue.iter_mut().for_each(|queue| drop(queue.flush()));
    }

    /// The keys that are pressed while the form has the terminal.
    pub fn keys(&mut self) -> Option<Keys> {
        self.keys.take()
    }

    /// Takes what happens. `false`: nobody reads any more, the stream should end.
    pub fn observe(&mut self, event: Event) -> bool {
        if self.broken.is_some() {
            return false;
        }
        if self.view == View::Live && matches!(&event, Event::Record(record) if matches!(**record, Record::Start(_))) {
            // The question stands on the screen that is given back; nothing turns yet.
            self.console.settles();
        }
        let written = match event {
            Event::Record(record) => {
                let beside = self.beside.iter_mut().try_for_each(|beside| beside.record(&record));
                let kept = beside.and_then(|()| self.recorder.iter_mut().try_for_each(|kept| kept.record(&record)));
                let written = kept.and_then(|()| self.form.record(&record));
                written.inspect(|()| self.console.observe(Event::Record(record)))
            }
            Event::Sought(news) if self.view == View::Ndjson => {
                let written = match news.is_told() {
                    true => self.form.record(&Record::Search((*news).clone())),
                    false => Ok(()),
                };
                written.inspect(|()| self.console.observe(Event::Sought(news)))
            }
            event => self.tell(event),
        };
        self.broken = written.err();
        self.broken.is_none()
    }

    fn tell(&mut self, event: Event) -> io::Result<()> {
        let text = match &event {
            Event::Note(text) => text.get(self.manner.lang).to_owned(),
            Event::Telegram { direction, meaning, .. } => format!("{direction} {}", meaning.get(self.manner.lang)),
            _ => String::new(),
        };
        if !self.form.note(&text)? {
            self.console.observe(event);
        }
        Ok(())
    }

    /// A moment is over: what had to wait for the terminal is drawn if it can be.
    pub fn catch_up(&mut self) {
        if let Err(error) = self.form.catch_up() {
            self.broken.get_or_insert(error);
        }
    }

    /// Takes a key. `true`: it is meant to end the stream.
    pub fn press(&mut self, key: Key) -> bool {
        if let Err(error) = self.form.press(key) {
            self.broken.get_or_insert(error);
        }
        matches!(key, Key::Quit | Key::Interrupt | Key::Gone) || self.broken.is_some()
    }

    /// Writes how it ended, gives the terminal back, and says on stderr what went wrong.
    pub fn finish(mut self, outcome: &Outcome, command: &'static str) -> io::Result<()> {
        if let Some(error) = self.broken.take() {
            return Err(error);
        }
        if let Some(Data::Plan(plan)) = &outcome.data {
            plan.telegrams.iter().try_for_each(|telegram| self.form.record(&Record::Telegram(telegram.clone())))?;
        }
        let summary = match &outcome.data {
            Some(Data::Monitor(summary)) => Some(StreamSummary::Monitor(summary.clone())),
            Some(Data::Sniff(sniff)) => Some(StreamSummary::Sniff(sniff.summary.clone())),
            Some(Data::BusMonitor(heard)) => Some(StreamSummary::Bus(heard.clone())),
            _ => None,
        };
        let (view, console) = (self.view, self.console.clone());
        let end = Record::End(end(outcome, command, summary.clone()));
        self.recorder.iter_mut().try_for_each(|kept| kept.record(&end))?;
        self.form.record(&end)?;
        // Gives the terminal back.
        drop(self);
        if let Some(summary) = summary
            && !matches!(view, View::Ndjson | View::Csv | View::Influx | View::OpenMetrics)
        {
            console.observe(Event::Note(told(&summary)));
        }
        outcome.warnings.iter().for_each(|warning| console.warning(&warning.message));
        if let Some(failure) = &outcome.failure {
            console.failure(failure);
        }
        Ok(())
    }
}

fn end(outcome: &Outcome, command: &'static str, summary: Option<StreamSummary>) -> StreamEnd {
    let t = summary.as_ref().map(|summary| match summary {
        StreamSummary::Monitor(monitor) => monitor.t,
        StreamSummary::Sniff(sniff) => sniff.count.t,
        StreamSummary::Bus(heard) => heard.t,
    });
    StreamEnd {
        t: t.unwrap_or(Decimal { raw: 0, decimals: 6 }),
        schema: SCHEMA_VERSION,
        tool: "antrieb",
        command,
        ok: outcome.failure.is_none(),
        summary,
        warnings: outcome.warnings.clone(),
        error: outcome.failure.as_ref().map(ErrorDoc::from),
    }
}

fn told(summary: &StreamSummary) -> Text {
    match summary {
        StreamSummary::Monitor(Monitor { samples, gaps, rounds, t, .. }) => both!(
            "{samples} in {rounds} and {t} s, {gaps}",
            "{samples} in {rounds} und {t} s, {gaps}",
            samples = Text::count(*samples, ["sample", "samples"], ["Messpunkt", "Messpunkte"]),
            rounds = Text::count(*rounds, ["round", "rounds"], ["Runde", "Runden"]),
            gaps = Text::count(*gaps, ["of them a gap", "of them gaps"], ["Lücke davon", "Lücken davon"]),
            t = cells::seconds(*t)
        ),
        StreamSummary::Sniff(SniffSummary { count: SniffCount { heard, garbled, t, .. }, .. }) => both!(
            "{heard} in {t} s, {garbled} of them disturbed",
            "{heard} in {t} s, davon {garbled} gestört",
            heard = Text::count(*heard, ["telegram", "telegrams"], ["Telegramm", "Telegramme"]),
            t = cells::seconds(*t)
        ),
        StreamSummary::Bus(heard) => both!(
            "{frames} in {t} s",
            "{frames} in {t} s",
            frames = Text::count(heard.frames, ["frame", "frames"], ["Frame", "Frames"]),
            t = cells::seconds(heard.t)
        ),
    }
}
