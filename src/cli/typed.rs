//! What was typed: the tree of arguments from the list of verbs, and what to say of what does not fit it.

use super::closed;
use super::printed::{PRINTED, Printed};
use crate::args::{Environment, Globals, language};
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
#[command(name = "antrieb", version, after_help = after_help(), max_term_width = 100, disable_help_subcommand = true)]
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

fn after_help() -> String {
    let mut text = "Exit codes:\n    0  done\n".to_owned();
    for (_, code, meaning) in Class::TABLE {
        text += &format!("  {code:>3}  {meaning}\n");
    }
    text + "\nFirst steps:\n  antrieb --port sim scan\n  antrieb --port sim -a 1 read 372@2 481 @actual\n  antrieb --port sim -a 2 diag\n"
}

/// The whole tree.
pub(super) fn tree() -> clap::Command {
    Line::command()
}

/// Only a verb that is mentioned can be meant. The whole tree, in which every verb has its copy of every global argument,
/// is built where something is to be explained.
pub(super) fn parse(arguments: &[OsString]) -> Result<Line, clap::Error> {
    let read = |tree: clap::Command| Line::from_arg_matches(&tree.try_get_matches_from(arguments)?);
    read(mentioned(arguments)).or_else(|_| read(tree()))
}

/// The tree with only those verbs that stand among the arguments; enough to read them, but not to explain anything.
fn mentioned(arguments: &[OsString]) -> clap::Command {
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
    let lacking = lacks_command(error, &words);
    let failure = lacking.clone().unwrap_or_else(|| unfit(error, &text));
    if words.iter().any(|word| word == "--json") || value_of(&words, "--format") == Some("json") {
        let root = tree();
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
    } else if lang == Lang::De || lacking.is_some() {
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
    let root = tree();
    let (path, command) = words.iter().skip(1).fold((String::new(), &root), |(path, command), word| {
        let inner = command.find_subcommand(word.as_ref());
        inner.map_or((path.clone(), command), |inner| (format!("{path}{} ", inner.get_name()), inner))
    });
    let known: Vec<_> = command.get_subcommands().map(clap::Command::get_name).filter(|name| *name != "help").collect();
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
        (None, Some((_, range))) => format!(": erwartet wird eine ganze Zahl in {range}"),
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
    let root = tree();
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
            let [few, all] = [mentioned(&words), tree()].map(|tree| tree.try_get_matches_from(&words));
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
