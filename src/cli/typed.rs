//! What was typed: the tree of arguments from the list of verbs, and what to say of what does not fit it.

use super::closed;
use super::page::FIRST_STEPS;
use super::printed::{PRINTED, Printed};
use crate::args::{Environment, Globals, Useless, language};
use crate::command::{self, Entry, VERBS};
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::render::{self, Console, Format, Manner, Stream, View};
use crate::text::{Lang, Text, Wrong, both};
use clap::{ArgMatches, Args as _, CommandFactory, FromArgMatches, Parser, Subcommand};
use std::borrow::Cow;
use std::ffi::OsString;
use std::io::Write;

/// Commissioning tool for industrial drives on serial lines.
///
/// Finds drives, says in plain words what they say, reads and writes their parameters in four data sets, and diagnoses
/// the line. `--port sim` is a built-in bench with two drives: try everything there first.
#[derive(Debug, Parser)]
#[command(name = "antrieb", version, after_help = SHORT, after_long_help = exit_codes() + FIRST_STEPS, max_term_width = 100, disable_help_subcommand = true)]
pub(super) struct Line {
    #[command(subcommand)]
    pub(super) what: What,
    #[command(flatten)]
    pub(super) globals: Globals,
}

/// What a command line asks for.
#[derive(Debug)]
pub(super) enum What {
    /// The work of a verb.
    Work(&'static Entry, Box<dyn command::Typed>),
    /// Something that the program knows of itself.
    Print(&'static Printed, ArgMatches),
}

impl What {
    /// What was asked for before the verb and will not happen.
    pub(super) fn unkept(&self, typed: &Globals) -> Option<Failure> {
        match self {
            What::Work(verb, _) => verb.takes.unkept(verb.name, typed),
            What::Print(printed, _) => printed.takes.unkept(printed.name, typed),
        }
    }
}

impl Subcommand for What {
    fn augment_subcommands(root: clap::Command) -> clap::Command {
        let verbs = VERBS.iter().map(|verb| (verb.command)());
        root.subcommands(verbs).subcommands(PRINTED.iter().map(|printed| (printed.command)()))
    }

    fn augment_subcommands_for_update(root: clap::Command) -> clap::Command {
        Self::augment_subcommands(root)
    }

    fn has_subcommand(name: &str) -> bool {
        VERBS.iter().any(|verb| verb.name == name) || PRINTED.iter().any(|printed| printed.name == name)
    }
}

impl FromArgMatches for What {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let missing = || clap::Error::new(clap::error::ErrorKind::MissingSubcommand);
        let (name, own) = matches.subcommand().ok_or_else(missing)?;
        if let Some(printed) = PRINTED.iter().find(|printed| printed.name == name) {
            return Ok(What::Print(printed, own.clone()));
        }
        let verb = VERBS.iter().find(|verb| verb.name == name).ok_or_else(missing)?;
        Ok(What::Work(verb, (verb.typed)(own)?))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

fn exit_codes() -> String {
    let rows = Class::TABLE.iter().map(|(_, code, meaning)| format!("  {code:>3}  {meaning}\n"));
    format!("Exit codes:\n    0  done\n{}\n", rows.collect::<String>())
}

/// What `antrieb -h` ends with.
const SHORT: &str = "Exit codes: antrieb --help; first steps: antrieb --port sim scan";

/// How much of the options of every verb is explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Depth {
    /// A line for each that matters to the verb, all of them together.
    Short,
    /// All that a verb takes, by their subjects.
    Whole,
}

/// The whole tree.
fn tree(depth: Depth) -> clap::Command {
    let root = Line::command();
    let globals: Vec<_> = root.get_arguments().map(|arg| arg.get_id().clone()).collect();
    let root = root.mut_args(|arg| {
        let is_first = FIRST.contains(&arg.get_id().as_str());
        together(arg, depth).hide_short_help(!is_first)
    });
    // A verb's own option of the same name has no heading.
    let is_common = |arg: &clap::Arg| globals.contains(arg.get_id()) && arg.get_help_heading().is_some();
    root.mut_subcommands(|verb| verb.mut_args(|arg| if is_common(&arg) { together(arg, depth) } else { arg }))
}

/// What `antrieb -h` tells.
const FIRST: &[&str] = &["port", "address", "baud", "parity", "protocol", "drive", "format", "lang", "dry_run", "yes"];

fn together(arg: clap::Arg, depth: Depth) -> clap::Arg {
    if depth == Depth::Short { arg.help_heading("Options of every verb (more with --help)") } else { arg }
}

/// Everything, for pages.
pub(super) fn whole() -> clap::Command {
    tree(Depth::Whole)
}

/// The tree for completions: what is offered, and nothing that only takes the place of something.
pub(super) fn offered() -> clap::Command {
    let root = Line::command().mut_args(|arg| arg.global(false).hide_short_help(false));
    let verbs: Vec<_> =
        root.get_subcommands().filter(|verb| !verb.is_hide_set()).map(|verb| alone(verb, &[])).collect();
    let args = root.get_arguments().cloned().collect();
    bare(&root, args, verbs)
}

/// A verb, or one within it, with the options that come down to it.
fn alone(command: &clap::Command, inherited: &[clap::Arg]) -> clap::Command {
    let own = |arg: &clap::Arg| command.get_arguments().any(|own| own.get_id() == arg.get_id());
    let inherited: Vec<_> = inherited.iter().filter(|arg| !own(arg)).cloned().collect();
    let visible = command.get_arguments().filter(|arg| !arg.is_hide_set()).cloned();
    let args: Vec<_> = visible.chain(inherited).collect();
    let passed_on: Vec<_> = args.iter().filter(|arg| arg.is_global_set()).cloned().collect();
    let verbs = command.get_subcommands().filter(|verb| !verb.is_hide_set());
    let verbs = verbs.map(|verb| alone(verb, &passed_on)).collect();
    bare(command, args, verbs)
}

fn bare(command: &clap::Command, args: Vec<clap::Arg>, verbs: Vec<clap::Command>) -> clap::Command {
    let about = command.get_about().cloned().unwrap_or_default();
    let aliases: Vec<_> = command.get_visible_aliases().map(str::to_owned).collect();
    let args = args.into_iter().map(|arg| arg.global(false));
    let bare = clap::Command::new(command.get_name().to_owned()).about(about).args(args).subcommands(verbs);
    bare.disable_help_subcommand(true).visible_aliases(aliases)
}

/// Only a verb that is mentioned can be meant. The whole tree, in which every verb has its copy of every global argument,
/// is built where something is to be explained.
pub(super) fn parse(arguments: &[OsString]) -> Result<Line, clap::Error> {
    let read = |tree: clap::Command| Line::from_arg_matches(&tree.try_get_matches_from(arguments)?);
    let depth = if arguments.iter().any(|word| word == "-h") { Depth::Short } else { Depth::Whole };
    read(mentioned(arguments)).or_else(|_| read(tree(depth)))
}

/// The tree with only those verbs that stand among the arguments; enough to read them, but not to explain anything.
pub(super) fn mentioned(arguments: &[OsString]) -> clap::Command {
    let stands = |name: &str| arguments.iter().any(|word| word == name);
    let root = clap::Command::new("antrieb").disable_help_subcommand(true);
    let verbs = VERBS.iter().filter(|verb| stands(verb.name) || verb.alias.is_some_and(stands));
    let printed = PRINTED.iter().filter(|printed| stands(printed.name));
    let root = Globals::augment_args(root).subcommands(verbs.map(|verb| (verb.command)()));
    root.subcommands(printed.map(|printed| (printed.command)()))
}

/// Help goes to stdout and is a success; anything else is a usage error, in JSON too if JSON was asked for.
pub(super) fn explain(
    error: &clap::Error,
    arguments: &[OsString],
    environment: &Environment,
    out: &mut dyn Write,
    err: Box<dyn Write>,
) -> u8 {
    let words: Vec<_> = arguments.iter().map(|word| word.to_string_lossy()).collect();
    let lang = language(value_of(&words, "--lang").and_then(|lang| lang.parse().ok()), environment);
    let console = Console::new(err, lang, true, false);
    let text = error.render().to_string();
    if !error.use_stderr() {
        let printed = out.write_all(text.as_bytes()).and_then(|()| out.flush());
        return printed.map_or_else(|error| closed(&error, &console), |()| 0);
    }
    let useless = std::error::Error::source(error).and_then(|why| why.downcast_ref::<Useless>());
    let ours = useless.cloned().map(Failure::from).or_else(|| lacks_command(error, &words));
    let failure = ours.clone().unwrap_or_else(|| unfit(error, &text));
    if words.iter().any(|word| word == "--json") || value_of(&words, "--format") == Some("json") {
        let root = tree(Depth::Whole);
        let verb = words
            .iter()
            .skip(1)
            .find_map(|word| root.find_subcommand(word.as_ref()))
            .map_or("", |verb| verb.get_name());
        let outcome = Outcome::from(failure);
        let _closed = if verb == "monitor" {
            let manner = Manner::of(lang);
            Stream::open(View::Ndjson, out, manner, &console).and_then(|stream| stream.finish(&outcome, "monitor"))
        } else {
            render::print(&outcome, verb, Format::Json, Manner::of(lang), out, &console)
        };
    } else if lang == Lang::De || ours.is_some() {
        console.failure(&failure);
    } else {
        text.lines().for_each(|line| console.line(line));
        if let Some(verb) = elsewhere(error) {
            console.line(&format!("hint: antrieb {verb}"));
        }
    }
    Class::Usage.exit()
}

/// The failure of a verb that needs a word behind it: clap prints its help there, which says neither that it is an error nor
/// what was expected. `antrieb` alone shows its help.
fn lacks_command(error: &clap::Error, words: &[Cow<'_, str>]) -> Option<Failure> {
    use clap::error::ErrorKind::{DisplayHelpOnMissingArgumentOrSubcommand, MissingSubcommand};
    if !matches!(error.kind(), DisplayHelpOnMissingArgumentOrSubcommand | MissingSubcommand) {
        return None;
    }
    let root = tree(Depth::Whole);
    let (path, command) = words.iter().skip(1).fold((String::new(), &root), |(path, command), word| {
        let inner = command.find_subcommand(word.as_ref());
        inner.map_or((path.clone(), command), |inner| (format!("{path}{} ", inner.get_name()), inner))
    });
    let known: Vec<_> = command.get_subcommands().map(clap::Command::get_name).filter(|name| *name != "help").collect();
    if path.is_empty() && error.kind() == MissingSubcommand {
        let shown = command.get_subcommands().filter(|verb| !verb.is_hide_set()).map(clap::Command::get_name);
        let known = shown.collect::<Vec<_>>().join(", ");
        let message = both!("expected a verb: {known}", "erwartet: ein Befehl: {known}");
        return Some(Failure::new(Class::Usage, "usage.arguments", message).hint(Text::name("antrieb --help")));
    }
    (!path.is_empty() && !known.is_empty()).then(|| {
        let (verb, known) = (path.trim_end(), known.join(", "));
        let message = both!("expected behind `{verb}`: {known}", "erwartet hinter `{verb}`: {known}");
        Failure::new(Class::Usage, "usage.arguments", message).hint(Text::name(format_args!("antrieb {verb} --help")))
    })
}

/// A usage error. clap speaks English; its usual errors are told in German too, the rest as clap tells them.
fn unfit(error: &clap::Error, text: &str) -> Failure {
    let told = text.lines().map(str::trim).take_while(|line| !line.starts_with("Usage:"));
    let told: Vec<_> = told.filter(|line| !line.is_empty()).collect();
    let english = told.join(" ").trim_start_matches("error: ").to_owned();
    let german = german(error).unwrap_or_else(|| english.clone());
    let message = Text { en: english.into(), de: german.into() };
    let hint = elsewhere(error).map_or_else(|| "antrieb --help".to_owned(), |verb| format!("antrieb {verb}"));
    Failure::new(Class::Usage, "usage.arguments", message).hint(Text::name(hint))
}

fn german(error: &clap::Error) -> Option<String> {
    use clap::error::{ContextKind as Told, ErrorKind};
    let told = |kind: Told| error.get(kind).map(ToString::to_string).filter(|text| !text.is_empty());
    let (what, value) = (told(Told::InvalidArg).unwrap_or_default(), told(Told::InvalidValue));
    let valid = told(Told::ValidValue).map_or_else(String::new, |valid| format!(" (erwartet: {valid})"));
    let near = |kind: Told| told(kind).map_or_else(String::new, |near| format!("; gemeint ist vielleicht '{near}'"));
    Some(match (error.kind(), value) {
        (ErrorKind::InvalidValue, Some(value)) => format!("'{value}' passt nicht für '{what}'{valid}"),
        (ErrorKind::InvalidValue, None) => format!("für '{what}' fehlt ein Wert{valid}"),
        (ErrorKind::ValueValidation, value) => {
            let why = std::error::Error::source(error).map_or_else(String::new, unfit_value);
            format!("'{}' passt nicht für '{what}'{why}", value.unwrap_or_default())
        }
        (ErrorKind::UnknownArgument, _) => {
            format!("'{what}' wird hier nicht erwartet{}", near(Told::SuggestedArg))
        }
        (ErrorKind::InvalidSubcommand, _) => {
            let verb = told(Told::InvalidSubcommand).unwrap_or_default();
            format!("den Befehl '{verb}' gibt es nicht{}", near(Told::SuggestedSubcommand))
        }
        (ErrorKind::MissingRequiredArgument, _) => format!("es fehlt: {what}"),
        (ErrorKind::MissingSubcommand, _) => "es fehlt ein Befehl".to_owned(),
        (ErrorKind::ArgumentConflict, _) => {
            format!("'{what}' geht nicht zusammen mit '{}'", told(Told::PriorArg).unwrap_or_default())
        }
        (ErrorKind::TooManyValues | ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues, _) => {
            format!("'{what}' hat nicht so viele Werte wie erwartet")
        }
        _ => return None,
    })
}

/// Why a value does not do: in our words, in those of a number, or as it was said.
fn unfit_value(why: &(dyn std::error::Error + 'static)) -> String {
    let told = why.to_string();
    match (why.downcast_ref::<Wrong>(), told.split_once(" is not in ")) {
        (Some(ours), _) => format!(": {}", ours.0.de),
        (None, Some((_, range))) => match range.split_once("..") {
            Some((first, last)) if last == u64::MAX.to_string() => {
                format!(": erwartet wird eine ganze Zahl ab {first}")
            }
            _ => format!(": erwartet wird eine ganze Zahl in {range}"),
        },
        (None, None) if why.is::<std::net::AddrParseError>() => {
            ": erwartet werden Adresse und Port wie 127.0.0.1:5020".to_owned()
        }
        (None, None) if why.is::<std::num::ParseIntError>() => ": erwartet wird eine ganze Zahl".to_owned(),
        (None, None) => format!(": {}", Text::quoted(told).de),
    }
}

/// What was typed for an option, in whichever of its two ways: `--lang de`, `--lang=de`.
fn value_of<'w>(words: &'w [Cow<'_, str>], option: &str) -> Option<&'w str> {
    let joined = words.iter().find_map(|word| word.strip_prefix(option)?.strip_prefix('='));
    joined.or_else(|| Some(words.windows(2).find(|pair| pair.first().is_some_and(|w| w == option))?.last()?.as_ref()))
}

/// The verb under which an unknown one is to be found: `statemachine enable` for `enable`.
fn elsewhere(error: &clap::Error) -> Option<String> {
    let Some(clap::error::ContextValue::String(word)) = error.get(clap::error::ContextKind::InvalidSubcommand) else {
        return None;
    };
    let root = tree(Depth::Whole);
    let verb = root.get_subcommands().find(|verb| verb.find_subcommand(word).is_some())?;
    Some(format!("{} {word}", verb.get_name()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_verbs_that_are_mentioned_suffice_to_read_the_arguments() {
        for typed in [
            "antrieb -p sim -a 1 --drive act read 372@2 --json",
            "antrieb read monitor --drive scan",
            "antrieb state --port sim show",
            "antrieb --lang de setpoint 25Hz --hold",
            "antrieb decode status 0x0237",
        ] {
            let words: Vec<OsString> = typed.split(' ').map(Into::into).collect();
            let [few, all] = [mentioned(&words), tree(Depth::Whole)].map(|tree| tree.try_get_matches_from(&words));
            let [few, all] = [few, all].map(|matches| Line::from_arg_matches(&matches.unwrap()).unwrap());
            assert_eq!(format!("{few:?}"), format!("{all:?}"), "{typed}");
        }
    }

    #[test]
    fn no_name_is_taken_twice() {
        let aliases = VERBS.iter().filter_map(|verb| verb.alias);
        let mut names: Vec<_> = VERBS.iter().map(|verb| verb.name).chain(aliases).collect();
        names.extend(PRINTED.iter().map(|printed| printed.name));
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count, "{names:?}");
    }
}
