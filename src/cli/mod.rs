//! The program: dispatch over the list of verbs, the forms of their output, the exit code.

mod complete;
mod forms;
mod manual;
mod overview;
mod page;
mod placeholder;
mod printed;
mod short;
mod signals;
mod typed;
mod unfit;
mod values;

use crate::args::{
    ColorChoice, Environment, Globals, Settings, is_apart, language, settings_of_plant, settings_over_lines,
};
use crate::command::{Context, Entry, Flow, OverLines, Typed, behind, file_failure, on_bus, over_lines};
use crate::drive::{Calls, Interrupt};
use crate::failure::{Class, Failure};
use crate::files::of_system;
use crate::outcome::{Event, Outcome};
use crate::profile::Registry;
use crate::render::{self, Console, Format, Manner, Patience, Stream, Streams, Terminal, View};
use crate::text::both;
use anyhow::Context as _;
use clap::ArgMatches;
use forms::{fits, kept, recorded, view};
use page::Source;
use printed::Printed;
use signals::{Signals, obey_keys, raise_on_closed_output};
use std::cell::{Cell, RefCell};
use std::ffi::OsString;
use std::io::{self, Write};
use std::pin::pin;
use std::time::Duration;
use tokio::runtime::Runtime;
use typed::What;

/// How long a run that is over waits for a reader who takes nothing of what it says. Everything else waits for its reader as
/// long as he takes, as any program does: a pager is read page by page.
const UNTAKEN: Duration = Duration::from_secs(5);
/// The same where somebody wished the end.
const UNTAKEN_BY_WISH: Duration = Duration::from_secs(2);

/// Runs the program and returns its exit code. Nothing is read but what is handed in here, the files that the settings
/// name, and the port.
pub fn run(arguments: &[OsString], environment: &Environment, streams: Streams) -> u8 {
    signals::outlive_limits();
    let Streams { mut out, queued, err, input, out_is_terminal, err_is_terminal, input_is_terminal, width, patience } =
        streams;
    let helped = typed::helped(arguments);
    let arguments = helped.as_deref().unwrap_or(arguments);
    let (globals, what, again) = match typed::parse(arguments) {
        Ok((typed::Line { globals, what }, again)) => (globals, what, again),
        Err(error) => {
            return unfit::explain(&error, arguments, environment, out.as_mut(), (err, err_is_terminal, width));
        }
    };
    let settings = settings_for(&what, &globals, environment);
    let lang = settings.as_ref().map_or_else(|_| language(globals.lang, environment), |settings| settings.lang);
    let progress = !globals.quiet && !globals.no_progress;
    let console = Console::new(err, lang, globals.quiet, err_is_terminal && progress)
        .told_by_lines(progress)
        .wrapped(err_is_terminal, width);
    let (entry, verb) = match what {
        What::Work(entry, verb) => (entry, verb),
        What::Print(page, matches) => return print(page, &matches, (&globals, environment), out.as_mut(), &console),
    };
    let (format, choice) = form(&settings, &globals);
    let color = may_color(choice, environment, out_is_terminal);
    let width = width.filter(|_| out_is_terminal);
    let is_can = settings.as_ref().is_ok_and(Settings::is_can);
    let node = settings.as_ref().map_or(0, |settings| settings.node);
    let manner = Manner { lang, width, full: globals.verbose > 0, color, holds_stderr: err_is_terminal, is_can, node };
    let flow = verb.streams();
    let settings = settings.and_then(|settings| fits(format, flow.as_ref()).map_or(Ok(settings), Err));
    let sends = settings.as_ref().is_ok_and(|settings| !settings.dry_run);
    let terminals = (out_is_terminal, out_is_terminal && input_is_terminal);
    let view = flow.as_ref().and_then(|flow| view(flow, format, sends, environment, terminals));
    let is_run = sends && matches!(flow, Some(Flow::Run { .. }));
    let watch = watch_of(view, err_is_terminal && progress, out_is_terminal).filter(|_| is_run);
    let carry_out = |stream: Option<&RefCell<Stream<'_>>>| {
        let outcome = settings.and_then(|settings| {
            let present = input_is_terminal && err_is_terminal;
            let (yes, quiet, lang) = (settings.yes, settings.quiet, settings.lang);
            let mut ask = Terminal { console: console.clone(), input: Some(input), present, yes, quiet, lang };
            let looks = Looks { stream, watch, terminal: err_is_terminal };
            let outcome = work(entry, verb.as_ref(), &settings, &mut ask, (&console, &patience), looks);
            match (settings.is_can(), settings.node) {
                (true, _) => Ok(on_bus::advised(outcome)),
                (_, 0) => outcome,
                (_, node) => Ok(behind::told(outcome, node)),
            }
        });
        again.told(outcome.unwrap_or_else(Outcome::from))
    };
    let printed = match view {
        None => whole(carry_out(None), entry, format, manner, out.as_mut(), &console),
        Some(view) if is_run || matches!(flow, Some(Flow::Search)) => {
            let queue = queued.filter(|_| is_run).map(|queued| queued(patience.clone()));
            let stream = Stream::of_run(view, queue, out.as_mut(), manner, &console);
            let outcome = shown(stream, |stream| carry_out(Some(stream)));
            whole(outcome, entry, format, manner, out.as_mut(), &console)
        }
        Some(view) => kept(flow.as_ref())
            .and_then(|keep| Ok(Stream::open(view, out.as_mut(), manner, &console)?.beside(keep)))
            .map(|stream| stream.recorded(recorded(flow, format, globals.force)))
            .and_then(|stream| streamed(stream, (entry.name, &console), |stream| carry_out(Some(stream)))),
    };
    let exit = |outcome: Outcome| outcome.failure.map_or(0, |failure| failure.class.exit());
    printed.map_or_else(|error| closed(&error, &console), exit)
}

/// A run or a search: what comes on the way is shown as it comes, and the document behind it.
fn shown<'o>(stream: Stream<'o>, carry_out: impl FnOnce(&RefCell<Stream<'o>>) -> Outcome) -> Outcome {
    let stream = RefCell::new(stream);
    let outcome = carry_out(&stream);
    stream.into_inner().close();
    outcome
}

/// What holds for what was typed.
fn settings_for(what: &What, globals: &Globals, environment: &Environment) -> Result<Settings, Failure> {
    let resolve = match what {
        What::Work(entry, _) if entry.of_plant => settings_of_plant,
        What::Work(_, verb) if !matches!(verb.over_lines(), OverLines::One(_)) => settings_over_lines,
        _ => Settings::resolve,
    };
    let instead = |failure: Failure| match what {
        What::Work(_, verb) if is_apart(&failure) => verb.over_lines().refused(failure),
        _ => failure,
    };
    let settings = what.unkept(globals).map_or_else(|| resolve(globals, environment).map_err(instead), Err)?;
    what.unspoken(&settings).map_or(Ok(settings), Err)
}

/// Who watches a run. Its line is progress; where its records or its view have the terminal there is none.
fn watch_of(view: Option<View>, has_progress: bool, out_is_terminal: bool) -> Option<Watch> {
    let line = has_progress && !(view.is_some() && out_is_terminal);
    (view.is_some() || line).then_some(Watch { keys: view == Some(View::Live), line })
}

/// Prints what the program knows of itself.
fn print(
    page: &Printed,
    matches: &ArgMatches,
    (globals, environment): (&Globals, &Environment),
    out: &mut dyn Write,
    console: &Console,
) -> u8 {
    let printed = match page.takes.unkept(page.name, globals) {
        Some(failure) => Ok(Some(failure)),
        None => (page.print)(matches, source(environment), out),
    };
    match printed {
        Ok(None) => 0,
        Ok(Some(failure)) => {
            let (code, manner) = (failure.class.exit(), Manner::of(console.lang()));
            let document = || render::print(&failure.clone().into(), page.name, Format::Json, manner, out, console);
            match globals.json.then(document) {
                Some(Ok(())) => {}
                Some(Err(error)) if !is_closed(&error) => return closed(&error, console),
                _ => console.failure(&failure),
            }
            code
        }
        Err(error) => closed(&error, console),
    }
}

/// Prints what is found as it comes.
fn streamed<'o>(
    stream: Stream<'o>,
    (verb, console): (&'static str, &Console),
    carry_out: impl FnOnce(&RefCell<Stream<'o>>) -> Outcome,
) -> io::Result<Outcome> {
    let stream = RefCell::new(stream);
    let outcome = carry_out(&stream);
    match stream.into_inner().finish(&outcome, verb) {
        Err(error) if is_untaken(&error) => Ok(outcome),
        // It was ended by whoever closed the pipe, or it had failed before.
        Err(error)
            if is_closed(&error) && outcome.failure.as_ref().is_some_and(|it| it.class != Class::Interrupted) =>
        {
            outcome.failure.iter().for_each(|failure| console.failure(failure));
            Ok(outcome)
        }
        printed => printed.map(|()| outcome),
    }
}

/// What pages are made of.
fn source(environment: &Environment) -> Source<'_> {
    Source { environment, whole: typed::whole, offered: typed::offered, mentioned: typed::mentioned }
}

/// Prints what was found, all of it at the end.
fn whole(
    outcome: Outcome,
    verb: &Entry,
    format: Format,
    manner: Manner,
    out: &mut dyn Write,
    console: &Console,
) -> io::Result<Outcome> {
    match render::print(&outcome, verb.name, format, manner, out, console) {
        // Nobody reads any more, but how a run ended, or why none came of it, must be heard of: a shaft may still turn. So must
        // what was written, and which file takes it back. What failed is no success because nobody reads it.
        Err(error)
            if outcome.is_run()
                || outcome.has_written()
                || outcome.failure.is_some() && (verb.turns || is_closed(&error)) =>
        {
            let outcome = unwritten(outcome, &error);
            render::print_end(&outcome, verb.name, Manner { color: false, ..manner }, console);
            if outcome.failure.is_some() || is_untaken(&error) { Ok(outcome) } else { Err(error) }
        }
        Err(error) if is_untaken(&error) => Ok(outcome),
        printed => printed.map(|()| outcome),
    }
}

/// Nobody interrupted a run whose records had no place any more; a terminal that is gone was closed by somebody.
fn unwritten(mut outcome: Outcome, error: &io::Error) -> Outcome {
    use io::ErrorKind::{FileTooLarge, QuotaExceeded, StorageFull};
    let is_full = matches!(error.kind(), StorageFull | QuotaExceeded | FileTooLarge);
    if let Some(failure) = outcome.failure.as_mut().filter(|failure| is_full && failure.class == Class::Interrupted) {
        failure.message = both!(
            "cannot write the output: {error}; {what}",
            "die Ausgabe lässt sich nicht schreiben: {error}; {what}",
            error = of_system(error),
            what = failure.message
        );
        (failure.class, failure.code) = (Class::Port, "port.output".into());
    }
    outcome
}

/// The reader took nothing any more, and was waited for long enough, or his terminal is gone: what could not be said is lost, what came
/// of the work is not.
fn is_untaken(error: &io::Error) -> bool {
    error.kind() == io::ErrorKind::TimedOut || is_hung_up(error)
}

/// Whoever writes to a terminal that is gone is told EIO, as of a disk that fails.
#[cfg(unix)]
fn is_hung_up(error: &io::Error) -> bool {
    error.raw_os_error() == Some(rustix::io::Errno::IO.raw_os_error()) && render::output_is_closed()
}

#[cfg(not(unix))]
fn is_hung_up(_error: &io::Error) -> bool {
    false
}

/// In which form, and whether in colour; of settings that cannot be had, what was typed.
fn form(settings: &Result<Settings, Failure>, globals: &Globals) -> (Format, ColorChoice) {
    match settings {
        Ok(settings) => (settings.format, settings.color),
        Err(_) if globals.json => (Format::Json, ColorChoice::Never),
        Err(_) => (globals.format.unwrap_or_default(), ColorChoice::Never),
    }
}

/// Who looks at a run that is held.
#[derive(Clone, Copy)]
struct Watch {
    /// By a view with keys.
    keys: bool,
    /// By a line on stderr.
    line: bool,
}

/// Who looks at what a verb does on its way.
struct Looks<'s, 'o> {
    stream: Option<&'s RefCell<Stream<'o>>>,
    watch: Option<Watch>,
    /// stderr is a terminal.
    terminal: bool,
}

/// Whether colours may go to stdout: `--color` before NO_COLOR (no-color.org), CLICOLOR and TERM.
fn may_color(choice: ColorChoice, environment: &Environment, out_is_terminal: bool) -> bool {
    let is = |name: &str, what: &dyn Fn(&str) -> bool| environment.variables.get(name).is_some_and(|set| what(set));
    match choice {
        ColorChoice::Always => true,
        ColorChoice::Never => false,
        ColorChoice::Auto => {
            let unwanted = is("NO_COLOR", &|set| !set.is_empty()) || is("CLICOLOR", &|set| set == "0");
            out_is_terminal && !unwanted && !is("TERM", &|set| set == "dumb")
        }
    }
}

/// Whether the pipe was closed on the other side: the reader has what it wanted.
fn is_closed(error: &io::Error) -> bool {
    // ERROR_PIPE_NOT_CONNECTED (233) is one of Windows' ways to say so, and std does not know it.
    error.kind() == io::ErrorKind::BrokenPipe || cfg!(windows) && error.raw_os_error() == Some(233)
}

/// A closed pipe is a success.
fn closed(error: &io::Error, console: &Console) -> u8 {
    if is_closed(error) {
        return 0;
    }
    let said = of_system(error);
    let text = both!("cannot write the output: {said}", "die Ausgabe lässt sich nicht schreiben: {said}", said);
    let failure = file_failure(error).unwrap_or_else(|| Failure::new(Class::Port, "port.output", text));
    console.failure(&failure);
    failure.class.exit()
}

/// Everything waits in one thread.
fn one_thread() -> Result<Runtime, Failure> {
    files_left()?;
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
    runtime.context("cannot start the runtime").map_err(|error| Failure::caused(Class::Bug, "bug.runtime", &error))
}

/// A runtime, its signals and a port take this many open files, some of which nobody can be told that they fail.
#[cfg(unix)]
const FILES: usize = 12;

/// Whether this process may open what it needs.
fn files_left() -> Result<(), Failure> {
    #[cfg(unix)]
    {
        let taken: io::Result<Vec<_>> = (0..FILES).map(|_| std::fs::File::open("/dev/null")).collect();
        taken.map_err(|error| {
            let text = both!(
                "too few files can be opened: {error}",
                "es lassen sich zu wenige Dateien öffnen: {error}",
                error = of_system(&error)
            );
            Failure::new(Class::Port, "port.files", text).hint(both!(
                "`ulimit -n` shows the limit of this shell; 64 are plenty",
                "`ulimit -n` zeigt die Grenze dieser Shell; 64 reichen gut"
            ))
        })?;
    }
    Ok(())
}

/// Who calls for rounds on stdin, if the verb wants that. Somebody at the keyboard is told how.
fn calls(verb: &dyn Typed, ask: &mut Terminal, observe: &mut dyn FnMut(Event)) -> Option<Calls> {
    let gathers = matches!(verb.streams(), Some(Flow::Samples { gather: true, .. }));
    let input = ask.input.take_if(|_| gathers)?;
    if ask.present {
        observe(Event::Note(both!("Enter takes a sample, Ctrl-D ends", "Enter nimmt einen Messpunkt, Strg-D beendet")));
    }
    Some(render::calls(input))
}

fn work(
    entry: &Entry,
    verb: &dyn Typed,
    settings: &Settings,
    ask: &mut Terminal,
    (console, patience): (&Console, &Patience),
    looks: Looks<'_, '_>,
) -> Result<Outcome, Failure> {
    let Looks { stream, watch, terminal } = looks;
    let registry = Registry::open(&settings.catalogues)
        .map_err(|error| Failure::new(Class::Data, "data.catalogue", error.text()))?;
    let runtime = one_thread()?;
    let interrupt = Interrupt::default();
    let ends = interrupt.clone();
    let mut observe = |event| match stream {
        None => console.observe(event),
        // Nobody reads any more.
        Some(stream) if !stream.borrow_mut().observe(event) => ends.raise(),
        Some(_) => {}
    };
    if let Some(Watch { keys, line }) = watch {
        interrupt.panel().watch(keys);
        if line {
            console.shows_run();
        }
    }
    let keys = stream.and_then(|stream| stream.borrow_mut().keys());
    settings.catalogue_notes.iter().for_each(|note| observe(Event::Note(note.clone())));
    let calls = calls(verb, ask, &mut observe);
    let (observe, sheet) = (&mut observe, render::sheet);
    let mut context =
        Context { settings, registry: &registry, ask, observe, interrupt: interrupt.clone(), sheet, calls };
    // Nobody's reading may hold up a run, or its stop.
    console.waits(!entry.turns);
    let outcome = runtime.block_on(async {
        // A verb that turns a shaft must notice that nobody reads any more; others finish what they began.
        let pipe = entry.turns.then(|| tokio::spawn(raise_on_closed_output(interrupt.clone(), terminal)));
        // From the first moment on a signal is heard, and does not just kill us.
        let signals = Signals::listen(entry.turns);
        let (has_keys, over) = (keys.is_some(), Cell::new(false));
        let mut hand = pin!(obey_keys(keys, stream, &interrupt, watch.is_some(), &over));
        let outcome = tokio::select! {
            outcome = over_lines::run(verb, &mut context) => outcome,
            () = &mut hand => Ok(Outcome::default()),
            () = signals.obey(&interrupt, console) => Ok(Outcome::default()),
        };
        // However a run ended, of itself or by a port that is lost: a key that is still held is not left to the shell.
        over.set(true);
        if has_keys && watch.is_some() {
            hand.await;
        }
        if let Some(pipe) = pipe {
            pipe.abort();
        }
        outcome
    });
    // What is typed into a run that shows no line is nobody's command: a shell would start the drive once more, unasked.
    if entry.turns && !settings.dry_run {
        render::forget_what_was_typed();
    }
    // Before a signal can end us as it ends any program: the terminal of a run is given back.
    if watch.is_some() {
        console.finish();
    }
    if interrupt.is_raised() {
        // Another signal, such as Ctrl-C pressed twice, takes nobody the report of what was put back or stopped.
        patience.limit(UNTAKEN_BY_WISH);
    } else {
        signals::act_as_usual();
        if outcome.as_ref().map_or(entry.turns, Outcome::is_run) {
            patience.limit(UNTAKEN);
        }
    }
    console.waits(true);
    // What was warned of on the way a script finds in the document.
    console.warned(outcome)
}
