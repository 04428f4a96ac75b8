//! The program: root command, dispatch, signals, hidden verbs that print completions and man pages.

use crate::args::{ColorChoice, Environment, Globals, Settings};
use crate::command::{self, Context};
use crate::drive::Interrupt;
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::profile::{Lang, Registry};
use crate::render::{self, Console, Format, Keys, Manner, Stream, Streams, Terminal, View};
use clap::{Args as _, CommandFactory, FromArgMatches, Parser, Subcommand};
use std::cell::RefCell;
use std::ffi::OsString;
use std::io::{self, Write};

/// Commissioning tool for industrial drives on serial lines.
///
/// Finds drives, says in plain words what they say, reads and writes their parameters in four data sets, and diagnoses
/// the line. `--port sim` is a built-in bench with two drives: try everything there first.
#[derive(Clone, Debug, Parser)]
#[command(name = "antrieb", version, after_help = after_help(), max_term_width = 100, disable_help_subcommand = true)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
    #[command(flatten)]
    globals: Globals,
}

#[derive(Clone, Debug, Subcommand)]
enum Verb {
    Scan(command::scan::Args),
    Identify(command::identify::Args),
    Read(command::read::Args),
    Write(command::write::Args),
    Dataset(command::dataset::Args),
    Diag(command::diag::Args),
    #[command(visible_alias = "state")]
    Statemachine(command::statemachine::Args),
    #[command(visible_alias = "setpoint")]
    Sollwert(command::sollwert::Args),
    Monitor(command::monitor::Args),
    Protocol(command::protocol::Args),
    Line(command::line::Args),
    Params(command::params::Args),
    Decode(command::decode::Args),
    Sniff(command::sniff::Args),
    Simulate(command::simulate::Args),
    /// Prints the JSON Schema of a verb's output, or of every verb's
    Schema {
        /// The verb
        verb: Option<String>,
    },
    /// Prints a completion script
    #[command(hide = true)]
    Completions {
        /// bash, zsh, fish, powershell
        shell: clap_complete::Shell,
    },
    /// Prints a man page: of the program, or of a verb
    #[command(hide = true)]
    Man {
        /// The verb
        verb: Option<String>,
    },
}

fn after_help() -> String {
    let mut text = "Exit codes:\n    0  done\n".to_owned();
    for (_, code, meaning) in Class::TABLE {
        text += &format!("  {code:>3}  {meaning}\n");
    }
    text + "\nFirst steps:\n  antrieb --port sim scan\n  antrieb --port sim -a 1 read 372@2 481 @actual\n  antrieb --port sim -a 2 diag\n"
}

/// Runs the program and returns its exit code. Nothing is read but what is handed in here, the files that the settings
/// name, and the port.
pub fn run(arguments: &[OsString], environment: &Environment, streams: Streams) -> u8 {
    let Streams { mut out, err, input, out_is_terminal, err_is_terminal, input_is_terminal, width } = streams;
    let cli = match parse(arguments) {
        Ok(cli) => cli,
        Err(error) => return clap_exit(&error, arguments, out.as_mut(), err),
    };
    let quiet = cli.globals.quiet;
    let console = Console::new(err, quiet, err_is_terminal && !quiet && !cli.globals.no_progress);
    let (name, printed) = match &cli.verb {
        Verb::Schema { verb } => ("schema", print_schema(verb.as_deref(), out.as_mut())),
        Verb::Completions { shell } => ("completions", completions(*shell, out.as_mut())),
        Verb::Man { verb } => ("man", man(verb.as_deref(), out.as_mut())),
        _ => ("", Ok(None)),
    };
    if !name.is_empty() {
        return match printed {
            Ok(None) => 0,
            Ok(Some(failure)) if cli.globals.json => {
                let code = failure.class.exit();
                match render::print(&failure.into(), name, Format::Json, Lang::En, None, out.as_mut(), &console) {
                    Ok(()) => code,
                    Err(error) => closed(&error, &console),
                }
            }
            Ok(Some(failure)) => {
                render::print_failure(&failure, &console);
                failure.class.exit()
            }
            Err(error) => closed(&error, &console),
        };
    }
    let verb = verb_name(&cli.verb);
    let settings = Settings::resolve(&cli.globals, environment);
    let (format, lang) = match &settings {
        Ok(settings) => (settings.format, settings.lang),
        Err(_) if cli.globals.json => (Format::Json, Lang::En),
        Err(_) => (cli.globals.format.unwrap_or_default(), Lang::En),
    };
    let width = if out_is_terminal { width } else { None };
    let view = view(&cli.verb, format, settings.as_ref().ok(), environment, out_is_terminal);
    let choice = settings.as_ref().map_or(ColorChoice::Never, |settings| settings.color);
    let color = may_color(choice, environment, out_is_terminal);
    let carry_out = |stream: Option<&RefCell<Stream<'_>>>| {
        let outcome = settings.and_then(|settings| {
            let present = input_is_terminal && err_is_terminal;
            let (yes, quiet, lang) = (settings.yes, settings.quiet, settings.lang);
            let mut ask = Terminal { console: console.clone(), input: Some(input), present, yes, quiet, lang };
            work(&cli.verb, &settings, &mut ask, &console, stream)
        });
        outcome.unwrap_or_else(Outcome::from)
    };
    let printed = match view {
        None => {
            let outcome = carry_out(None);
            match render::print(&outcome, verb, format, lang, width, out.as_mut(), &console) {
                // Nobody reads any more, but how a run ended, or why none came of it, must be heard of: a shaft may still turn.
                Err(error) if outcome.is_run() || turns(&cli.verb) && outcome.failure.is_some() => {
                    render::print_end(&outcome, lang, &console);
                    if outcome.failure.is_some() { Ok(outcome) } else { Err(error) }
                }
                printed => printed.map(|()| outcome),
            }
        }
        Some(view) => {
            let manner = Manner { lang, width, color, holds_stderr: err_is_terminal };
            Stream::open(view, out.as_mut(), manner, &console).and_then(|stream| {
                let stream = RefCell::new(stream);
                let outcome = carry_out(Some(&stream));
                stream.into_inner().finish(&outcome, verb).map(|()| outcome)
            })
        }
    };
    match printed {
        Ok(outcome) => outcome.failure.map_or(0, |failure| failure.class.exit()),
        Err(error) => closed(&error, &console),
    }
}

/// The form of a verb that streams; `None` for what is printed as a whole at the end.
fn view(
    verb: &Verb,
    format: Format,
    settings: Option<&Settings>,
    environment: &Environment,
    out_is_terminal: bool,
) -> Option<View> {
    let args = match verb {
        Verb::Monitor(args) => args,
        Verb::Sniff(_) => return sniff_view(format, settings),
        _ => return None,
    };
    let is_dumb = environment.variables.get("TERM").is_some_and(|term| term == "dumb");
    match format {
        // A stream has no end to wait for, so its JSON is one object a line.
        Format::Json | Format::Ndjson => Some(View::Ndjson),
        _ if settings.is_none_or(|settings| settings.dry_run) => None,
        Format::Csv => Some(View::Csv),
        Format::Table if out_is_terminal && args.line => Some(View::Ticker),
        Format::Table if out_is_terminal && !is_dumb => Some(View::Live),
        Format::Table => Some(View::Lines),
    }
}

/// `sniff` has an end to wait for where a document is asked for.
fn sniff_view(format: Format, settings: Option<&Settings>) -> Option<View> {
    match format {
        Format::Ndjson => Some(View::Ndjson),
        Format::Table if settings.is_some_and(|settings| !settings.dry_run) => Some(View::Telegrams),
        Format::Table | Format::Json | Format::Csv => None,
    }
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

/// Only a verb that is mentioned can be meant. The whole tree, in which every verb has its copy of every global argument,
/// is built where something is to be explained.
fn parse(arguments: &[OsString]) -> Result<Cli, clap::Error> {
    let read = |tree: clap::Command| Cli::from_arg_matches(&tree.try_get_matches_from(arguments)?);
    read(mentioned(arguments)).or_else(|_| read(Cli::command()))
}

/// The tree with only those verbs that stand among the arguments; enough to read them, but not to explain anything.
fn mentioned(arguments: &[OsString]) -> clap::Command {
    let root = || clap::Command::new("antrieb").disable_help_subcommand(true);
    let stands = |verb: &&clap::Command| {
        let mut names = verb.get_name_and_visible_aliases().into_iter();
        names.any(|name| arguments.iter().any(|word| word == name))
    };
    let verbs = Verb::augment_subcommands(root());
    Globals::augment_args(root()).subcommands(verbs.get_subcommands().filter(stands).cloned())
}

/// Help goes to stdout and is a success; anything else is a usage error, in JSON too if JSON was asked for.
fn clap_exit(error: &clap::Error, arguments: &[OsString], out: &mut dyn Write, err: Box<dyn Write>) -> u8 {
    let text = error.render().to_string();
    if !error.use_stderr() {
        let printed = out.write_all(text.as_bytes()).and_then(|()| out.flush());
        return printed.map_or_else(|error| closed(&error, &Console::new(err, true, false)), |()| 0);
    }
    let console = Console::new(err, true, false);
    let words: Vec<_> = arguments.iter().map(|word| word.to_string_lossy()).collect();
    let wants_json = words.iter().any(|word| word == "--json" || word == "--format=json")
        || words
            .windows(2)
            .any(|pair| pair.first().is_some_and(|w| w == "--format") && pair.last().is_some_and(|w| w == "json"));
    if wants_json {
        let told = text.lines().map(str::trim).take_while(|line| !line.starts_with("Usage:"));
        let told: Vec<_> = told.filter(|line| !line.is_empty()).collect();
        let message = told.join(" ").trim_start_matches("error: ").to_owned();
        let failure = Failure::new(Class::Usage, "usage.arguments", message)
            .hint(elsewhere(error).map_or_else(|| "antrieb --help".to_owned(), |verb| format!("antrieb {verb}")));
        let root = Cli::command();
        let verb = words
            .iter()
            .skip(1)
            .find_map(|word| root.find_subcommand(word.as_ref()))
            .map_or("", |verb| verb.get_name());
        let outcome = Outcome::from(failure);
        let _closed = if verb == "monitor" {
            let manner = Manner { lang: Lang::En, width: None, color: false, holds_stderr: false };
            Stream::open(View::Ndjson, out, manner, &console).and_then(|stream| stream.finish(&outcome, "monitor"))
        } else {
            render::print(&outcome, verb, Format::Json, Lang::En, None, out, &console)
        };
    } else {
        text.lines().for_each(|line| console.line(line));
        if let Some(verb) = elsewhere(error) {
            console.line(&format!("hint: antrieb {verb}"));
        }
    }
    Class::Usage.exit()
}

/// The verb under which an unknown one is to be found: `statemachine enable` for `enable`.
fn elsewhere(error: &clap::Error) -> Option<String> {
    let Some(clap::error::ContextValue::String(word)) = error.get(clap::error::ContextKind::InvalidSubcommand) else {
        return None;
    };
    let root = Cli::command();
    let verb = root.get_subcommands().find(|verb| verb.find_subcommand(word).is_some())?;
    Some(format!("{} {word}", verb.get_name()))
}

/// A pipe that was closed on the other side is a success: the reader has what it wanted.
fn closed(error: &io::Error, console: &Console) -> u8 {
    if error.kind() == io::ErrorKind::BrokenPipe {
        return 0;
    }
    console.line(&format!("error: cannot write the output: {error}"));
    Class::Port.exit()
}

fn work(
    verb: &Verb,
    settings: &Settings,
    ask: &mut Terminal,
    console: &Console,
    stream: Option<&RefCell<Stream<'_>>>,
) -> Result<Outcome, Failure> {
    let registry = Registry::open(&settings.catalogues)
        .map_err(|error| Failure::new(Class::Data, "data.catalogue", error.to_string()))?;
    let bug = |error: io::Error| Failure::new(Class::Bug, "bug.runtime", format!("cannot start the runtime: {error}"));
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().map_err(bug)?;
    let interrupt = Interrupt::default();
    let ends = interrupt.clone();
    let mut observe = |event| match stream {
        None => console.observe(event),
        // Nobody reads any more.
        Some(stream) if !stream.borrow_mut().observe(event) => ends.raise(),
        Some(_) => {}
    };
    let keys = stream.and_then(|stream| stream.borrow_mut().keys());
    settings.catalogue_notes.iter().for_each(|note| observe(crate::outcome::Event::Note(note.clone())));
    let mut context =
        Context { settings, registry: &registry, ask, observe: &mut observe, interrupt: interrupt.clone() };
    runtime.block_on(async {
        // A verb that turns a shaft must notice that nobody reads any more; others finish what they began.
        let pipe = turns(verb).then(|| tokio::spawn(raise_on_closed_output(interrupt.clone())));
        let signals = tokio::spawn(raise_on_signal(interrupt.clone()));
        // From the first moment on a signal is heard, and does not just kill us.
        tokio::task::yield_now().await;
        let outcome = tokio::select! {
            outcome = dispatch(verb, &mut context) => outcome,
            () = obey_keys(keys, stream, &interrupt) => Ok(Outcome::default()),
        };
        signals.abort();
        if let Some(pipe) = pipe {
            pipe.abort();
        }
        outcome
    })
}

/// Whether a verb can turn a shaft.
fn turns(verb: &Verb) -> bool {
    matches!(verb, Verb::Statemachine(_) | Verb::Sollwert(_))
}

/// Hands the keys that are pressed to the view, for ever.
async fn obey_keys(keys: Option<Keys>, stream: Option<&RefCell<Stream<'_>>>, interrupt: &Interrupt) {
    let (Some(mut keys), Some(stream)) = (keys, stream) else { return std::future::pending().await };
    loop {
        let key = keys.next().await;
        if stream.borrow_mut().press(key) {
            interrupt.raise();
        }
    }
}

async fn dispatch(verb: &Verb, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    match verb {
        Verb::Scan(args) => command::scan::run(args, context).await,
        Verb::Identify(args) => command::identify::run(args, context).await,
        Verb::Read(args) => command::read::run(args, context).await,
        Verb::Write(args) => command::write::run(args, context).await,
        Verb::Dataset(args) => command::dataset::run(args, context).await,
        Verb::Diag(args) => command::diag::run(args, context).await,
        Verb::Statemachine(args) => command::statemachine::run(args, context).await,
        Verb::Sollwert(args) => command::sollwert::run(args, context).await,
        Verb::Monitor(args) => command::monitor::run(args, context).await,
        Verb::Protocol(args) => command::protocol::run(args, context).await,
        Verb::Line(args) => command::line::run(args, context).await,
        Verb::Params(args) => command::params::run(args, context),
        Verb::Decode(args) => command::decode::run(args, context),
        Verb::Sniff(args) => command::sniff::run(args, context).await,
        Verb::Simulate(args) => command::simulate::run(args, context).await,
        Verb::Schema { .. } | Verb::Completions { .. } | Verb::Man { .. } => Ok(Outcome::default()),
    }
}

fn verb_name(verb: &Verb) -> &'static str {
    match verb {
        Verb::Scan(_) => "scan",
        Verb::Identify(_) => "identify",
        Verb::Read(_) => "read",
        Verb::Write(_) => "write",
        Verb::Dataset(_) => "dataset",
        Verb::Diag(_) => "diag",
        Verb::Statemachine(_) => "statemachine",
        Verb::Sollwert(_) => "sollwert",
        Verb::Monitor(_) => "monitor",
        Verb::Protocol(_) => "protocol",
        Verb::Line(_) => "line",
        Verb::Params(_) => "params",
        Verb::Decode(_) => "decode",
        Verb::Sniff(_) => "sniff",
        Verb::Simulate(_) => "simulate",
        Verb::Schema { .. } => "schema",
        Verb::Completions { .. } => "completions",
        Verb::Man { .. } => "man",
    }
}

/// Raises the interrupt when the reader of stdout has gone away.
#[expect(clippy::disallowed_methods, reason = "looks at a pipe now and then; no telegram depends on this time")]
async fn raise_on_closed_output(interrupt: Interrupt) {
    while !render::output_is_closed() {
        tokio::time::sleep(std::time::Duration::from_millis(100)).await;
    }
    interrupt.raise();
}

/// Hands every Ctrl-C and SIGTERM on, so that a second one counts too, and a SIGHUP.
#[cfg(unix)]
async fn raise_on_signal(interrupt: Interrupt) {
    use tokio::signal::unix::{SignalKind, signal};
    let (Ok(mut term), Ok(mut hangup)) = (signal(SignalKind::terminate()), signal(SignalKind::hangup())) else {
        return;
    };
    loop {
        tokio::select! {
            pressed = tokio::signal::ctrl_c() => match pressed {
                Ok(()) => interrupt.press(),
                Err(_) => return,
            },
            _ = term.recv() => interrupt.press(),
            // The terminal is gone, and with it stdout: that is one wish, not two.
            _ = hangup.recv() => interrupt.raise(),
        }
    }
}

#[cfg(not(unix))]
async fn raise_on_signal(interrupt: Interrupt) {
    while tokio::signal::ctrl_c().await.is_ok() {
        interrupt.press();
    }
}

fn print_schema(verb: Option<&str>, out: &mut dyn Write) -> io::Result<Option<Failure>> {
    let root = Cli::command();
    let name = verb.map(|verb| root.find_subcommand(verb).map_or(verb, |found| found.get_name()));
    let Some(schema) = render::schema(name) else {
        let message = format!("'{}' has no JSON output", verb.unwrap_or_default());
        return Ok(Some(Failure::new(Class::Usage, "usage.schema", message)));
    };
    serde_json::to_writer_pretty(&mut *out, &schema)?;
    writeln!(out)?;
    out.flush().map(|()| None)
}

fn completions(shell: clap_complete::Shell, out: &mut dyn Write) -> io::Result<Option<Failure>> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), "antrieb", &mut script);
    out.write_all(&script)?;
    out.flush().map(|()| None)
}

fn man(verb: Option<&str>, out: &mut dyn Write) -> io::Result<Option<Failure>> {
    let mut root = Cli::command();
    root.build();
    let page = match verb {
        None => clap_mangen::Man::new(root),
        Some(verb) => match root.find_subcommand(verb) {
            Some(found) => clap_mangen::Man::new(found.clone().version(env!("CARGO_PKG_VERSION"))),
            None => {
                let message = format!("there is no verb '{verb}'");
                return Ok(Some(Failure::new(Class::Usage, "usage.verb", message)));
            }
        },
    };
    // No date: the page must be the same whenever it is built.
    page.date("").source("antrieb").manual("Commissioning of drives").render(out)?;
    out.flush().map(|()| None)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_verbs_that_are_mentioned_suffice_to_read_the_arguments() {
        for line in [
            "antrieb -p sim -a 1 --drive act read 372@2 --json",
            "antrieb read monitor --drive scan",
            "antrieb state --port sim show",
            "antrieb --lang de setpoint 25Hz --hold",
            "antrieb schema read",
        ] {
            let words: Vec<OsString> = line.split(' ').map(Into::into).collect();
            let [few, all] = [mentioned(&words), Cli::command()].map(|tree| tree.try_get_matches_from(&words));
            let [few, all] = [few, all].map(|matches| Cli::from_arg_matches(&matches.unwrap()).unwrap());
            assert_eq!(format!("{few:?}"), format!("{all:?}"), "{line}");
        }
    }
}
