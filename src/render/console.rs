//! stderr: notes, telegrams, progress; shared by everybody who has something to say.

use super::hush::Hush;
use super::run_line::RunLine;
use super::words::word;
use super::wrap::wrap;
use super::{Outlet, Patience, clean, progress_width, search};
use crate::failure::Failure;
use crate::outcome::{Event, FoundDrive, Outcome, Record, SearchNews, Warning};
use crate::text::{Lang, Text};
use indicatif::{MultiProgress, ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::io::{BufRead, Write};
use std::rc::Rc;

const NOTE: &Text = &Text::new("note", "Anmerkung");
const WARNING: &Text = &Text::new("warning", "Warnung");
const ERROR: &Text = &Text::new("error", "Fehler");
const HINT: &Text = &Text::new("hint", "Hinweis");

/// Where answers are typed.
pub type Input = Box<dyn BufRead + Send>;

/// What was typed at the terminal and nobody has read yet is gone, that of this process as well where stdin is another one or none:
/// whoever reads there next would take it. At a terminal that is in the hands of somebody else's job, nothing is.
pub fn forget_what_was_typed() {
    #[cfg(unix)]
    {
        use rustix::termios::{QueueSelector, tcflush, tcgetpgrp};
        let ours = rustix::process::getpgrp();
        let stdin = rustix::stdio::stdin();
        if tcgetpgrp(stdin).map_or(true, |group| group == ours) {
            let _gone = tcflush(stdin, QueueSelector::IFlush);
        }
        let own = std::fs::File::open("/dev/tty").ok();
        if let Some(own) = own.filter(|own| tcgetpgrp(own).is_ok_and(|group| group == ours)) {
            let _gone = tcflush(&own, QueueSelector::IFlush);
        }
    }
}

/// Where a run reads and writes; real for the program, made up for tests.
pub struct Streams {
    /// Data.
    pub out: Box<dyn Write>,
    /// The same once more, opened where nobody may wait for its reader; `None`: it never makes anybody wait.
    pub queued: Option<fn(Patience) -> Outlet>,
    /// Everything else.
    pub err: Box<dyn Write>,
    /// Answers to questions.
    pub input: Input,
    /// stdout is a terminal.
    pub out_is_terminal: bool,
    /// stderr is a terminal.
    pub err_is_terminal: bool,
    /// stdin is a terminal.
    pub input_is_terminal: bool,
    /// Columns of the terminal.
    pub width: Option<u16>,
    /// How long the readers of both are waited for.
    pub patience: Patience,
}

impl std::fmt::Debug for Streams {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Streams").field("width", &self.width).finish_non_exhaustive()
    }
}

/// stderr with a progress bar that gives way to lines.
#[derive(Clone)]
pub struct Console {
    inner: Rc<RefCell<Inner>>,
}

impl std::fmt::Debug for Console {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Console").finish_non_exhaustive()
    }
}

struct Inner {
    err: Box<dyn Write>,
    /// Warnings that were told on the way.
    has_said: Vec<Warning>,
    lang: Lang,
    quiet: bool,
    progress: bool,
    /// Without bars progress is told line by line, where it goes on for minutes.
    lines: bool,
    /// Prose is wrapped: at this width, or at that of the terminal on stderr.
    width: Option<Option<u16>>,
    /// What is written is waited for until its reader has taken it.
    waits: bool,
    /// The bars on the terminal, as long as there are any.
    drawn: Option<MultiProgress>,
    /// The line of a run that is held, if there is to be one.
    run: Option<RunLine>,
    /// What is typed meanwhile is not shown.
    hush: Option<Hush>,
    /// By what they are called; the bar of a verb that does one thing at a time has no name.
    bars: BTreeMap<String, ProgressBar>,
}

impl Console {
    /// stderr; a bar is only drawn on a terminal.
    pub fn new(err: Box<dyn Write>, lang: Lang, quiet: bool, progress: bool) -> Self {
        let (drawn, run, hush, bars) = (None, None, None, BTreeMap::new());
        let has_said = Vec::new();
        let inner = Inner {
            err,
            has_said,
            lang,
            quiet,
            progress,
            lines: false,
            width: None,
            waits: true,
            drawn,
            run,
            hush,
            bars,
        };
        Console { inner: Rc::new(RefCell::new(inner)) }
    }

    /// Without a bar the progress of what goes on for minutes is told line by line.
    #[must_use]
    pub fn told_by_lines(self, lines: bool) -> Self {
        self.inner.borrow_mut().lines = lines;
        self
    }

    /// On a terminal prose is wrapped at its width: at this one, or, if nobody knows it beforehand, at what stderr says.
    #[must_use]
    pub fn wrapped(self, is_terminal: bool, width: Option<u16>) -> Self {
        self.inner.borrow_mut().width = is_terminal.then_some(width);
        self
    }

    /// Whether what is written is waited for until its reader has taken it, as it is from the beginning. While a shaft turns
    /// nothing waits for a reader.
    pub fn waits(&self, waits: bool) {
        let mut inner = self.inner.borrow_mut();
        inner.waits = waits;
        inner.settle();
    }

    /// What is worth knowing besides.
    pub fn note(&self, text: &Text) {
        self.labelled(NOTE, text);
    }

    /// What may not be as it should.
    pub fn warning(&self, text: &Text) {
        if !self.inner.borrow().has_said.iter().any(|said| said.message == *text) {
            self.labelled(WARNING, text);
        }
    }

    /// An outcome with the warnings that were told on the way; they are not told again.
    pub fn warned(&self, outcome: Result<Outcome, Failure>) -> Result<Outcome, Failure> {
        let said = self.inner.borrow().has_said.clone();
        if said.is_empty() {
            return outcome;
        }
        let mut outcome = outcome.unwrap_or_else(Outcome::from);
        outcome.warnings.splice(0..0, said);
        Ok(outcome)
    }

    /// What went wrong, and what to do.
    pub fn failure(&self, failure: &Failure) {
        self.labelled(ERROR, &failure.told());
        if let Some(hint) = &failure.hint {
            self.labelled(HINT, hint);
        }
    }

    fn labelled(&self, label: &Text, text: &Text) {
        let lang = self.lang();
        self.say(&format!("{}: {}", label.get(lang), text.get(lang)));
    }

    /// Prose on stderr, above the bar: on a terminal in lines of its width.
    pub fn say(&self, text: &str) {
        self.inner.borrow_mut().say(text);
    }

    /// The language in which it speaks.
    pub fn lang(&self) -> Lang {
        self.inner.borrow().lang
    }

    /// Shows what happens on the way.
    pub fn observe(&self, event: Event) {
        if let Event::Warned(warning) = &event {
            let said = &mut self.inner.borrow_mut().has_said;
            if said.contains(warning) {
                return;
            }
            said.push(warning.clone());
        }
        if let Event::Note(text) | Event::Warned(Warning { message: text, .. }) = &event {
            if !self.inner.borrow().quiet {
                self.note(text);
            }
            return;
        }
        let mut inner = self.inner.borrow_mut();
        match event {
            Event::Telegram { at_us, direction, hex, meaning } => {
                let at = format!("{}.{:03}", at_us / 1_000, at_us % 1_000);
                let meaning = meaning.get(inner.lang).to_owned();
                inner.say(&format!("{at:>10} ms {direction} {hex}  {meaning}"));
            }
            Event::Progress { done, total, what } => inner.progress(String::new(), done, total, &what),
            Event::Search { port, done, total, what } => inner.progress(port, done, total, &what),
            Event::Sought(news) => inner.sought(&news),
            Event::Found(drive) => {
                if !inner.quiet {
                    let FoundDrive { drive, address, title, port, line, protocol, .. } = *drive;
                    let found = inner.lang.pick("found", "gefunden:");
                    let drive = if drive == "unknown" { word(inner.lang, "unknown").to_owned() } else { drive };
                    let (at, title) = (inner.lang.pick("at", "unter"), title.get(inner.lang));
                    inner.say(&format!("{found} {drive} {at} {address}: {title} ({port}, {line} {protocol})"));
                }
            }
            // A record is data, and goes to stdout by the stream; here it is at most progress.
            Event::Record(record) => inner.shows(&record),
            Event::Note(_) | Event::Warned(_) => {}
        }
    }

    /// A line on stderr, above the bar, as it is.
    pub fn line(&self, text: &str) {
        self.inner.borrow_mut().line(text);
    }

    /// Waits until what was said is out, before something else takes the terminal.
    pub fn settles(&self) {
        let mut inner = self.inner.borrow_mut();
        let waits = std::mem::replace(&mut inner.waits, true);
        inner.settle();
        inner.waits = waits;
    }

    /// Part of a line on stderr, for a question.
    pub fn prompt(&self, text: &str) {
        let mut inner = self.inner.borrow_mut();
        let _closed = write!(inner.err, "{}", clean(text));
        inner.settle();
    }

    /// From now on a line tells where a run is that is held, on a terminal.
    pub fn shows_run(&self) {
        let mut inner = self.inner.borrow_mut();
        let lang = inner.lang;
        inner.run = inner.progress.then(|| RunLine::new(lang));
    }

    /// Takes the bars, and the line of a run, away; the terminal is as before.
    pub fn finish(&self) {
        let mut inner = self.inner.borrow_mut();
        inner.clear();
        inner.hush = None;
        std::mem::take(&mut inner.bars).values().for_each(ProgressBar::finish_and_clear);
        inner.drawn = None;
    }
}

impl Inner {
    fn say(&mut self, text: &str) {
        let columns = self.width.map(|width| width.or_else(progress_width));
        let lines = wrap(&clean(text), columns.flatten());
        self.put(&lines);
    }

    fn line(&mut self, text: &str) {
        self.put(&clean(text));
    }

    fn put(&mut self, text: &str) {
        self.clear();
        if let Some(drawn) = &self.drawn {
            // Not `suspend`: it panics where the terminal is gone, and what is half written could not be taken back.
            let _gone = drawn.clear();
        }
        // A closed stderr is no reason to stop: what matters goes to stdout and into the exit code.
        let _closed = writeln!(self.err, "{text}");
        // Behind the bar that is drawn again, it would leave that standing.
        self.settle();
    }

    /// Takes away the line of a run until it is shown again.
    fn clear(&mut self) {
        if let Some(wiped) = self.run.as_mut().and_then(RunLine::wiped) {
            let _closed = write!(self.err, "{wiped}");
        }
    }

    fn shows(&mut self, record: &Record) {
        if self.run.is_some() && self.hush.is_none() && matches!(record, Record::Run(_)) {
            self.hush = Hush::begin(false);
        }
        if let Some(line) = self.run.as_mut().and_then(|run| run.record(record)) {
            let _closed = write!(self.err, "{line}");
            self.settle();
        }
    }

    /// What was written is out, if that is waited for.
    fn settle(&mut self) {
        if self.waits {
            let _closed = self.err.flush();
        }
    }

    fn progress(&mut self, name: String, done: u64, total: u64, what: &Text) {
        if !self.progress {
            return;
        }
        self.bar(name, (done, total), what, "{bar:16} {pos}/{len} {prefix}{wide_msg} {eta}");
    }

    /// How far a search for settings is: by its own estimate, because its steps do not take the same time.
    fn sought(&mut self, news: &SearchNews) {
        let name = if news.is_named { news.port.clone() } else { String::new() };
        match news {
            _ if news.setting == 0 && !self.quiet => {
                let told = search::begun(news).get(self.lang).to_owned();
                self.say(&told);
            }
            _ if self.progress && news.setting > 0 => {
                let (gone, left) = (news.t.raw.unsigned_abs(), news.left_s.raw.unsigned_abs());
                self.bar(name, (gone, gone + left), &search::short(news), "{bar:8} {prefix}{wide_msg}");
            }
            _ if self.lines && news.is_over => {
                let told = search::told(news).get(self.lang).to_owned();
                self.say(&told);
            }
            _ => {}
        }
    }

    fn bar(&mut self, name: String, (done, total): (u64, u64), what: &Text, template: &str) {
        if self.hush.is_none() && self.drawn.is_none() {
            self.hush = Hush::begin(true);
        }
        let stderr = || MultiProgress::with_draw_target(ProgressDrawTarget::stderr());
        let drawn = self.drawn.get_or_insert_with(stderr);
        let bar = self.bars.entry(name).or_insert_with_key(|name| {
            let bar = drawn.add(ProgressBar::new(total));
            if let Ok(style) = ProgressStyle::with_template(template) {
                bar.set_style(style);
            }
            if !name.is_empty() {
                bar.set_prefix(format!("{}: ", its_end(&clean(name))));
            }
            bar
        });
        bar.set_length(total);
        bar.set_position(done);
        bar.set_message(clean(what.get(self.lang)));
    }
}

/// Of a long name the end, by which ports differ that have a bar each.
fn its_end(name: &str) -> String {
    const MOST: usize = 24;
    match name.chars().count().checked_sub(MOST) {
        None | Some(0) => name.to_owned(),
        Some(more) => format!("…{}", name.chars().skip(more + 1).collect::<String>()),
    }
}
