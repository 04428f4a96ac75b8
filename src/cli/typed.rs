//! What was typed: the tree of arguments from the list of verbs.

use super::page::FIRST_STEPS;
use super::printed::{PRINTED, Printed};
use super::short;
use crate::args::{Globals, Settings, below_zero};
use crate::command::{self, Again, Entry, VERBS};
use crate::failure::{Class, Failure};
use crate::text::{Text, both};
use clap::error::ErrorKind;
use clap::{ArgMatches, Args as _, CommandFactory, FromArgMatches, Parser, Subcommand};
use std::ffi::OsString;

/// Commissioning tool for industrial drives on serial lines.
///
/// Finds drives, says in plain words what they say, reads and writes their parameters in four data sets, and diagnoses
/// the line. `--port sim` is a built-in bench with two drives: try everything there first.
#[derive(Debug, Parser)]
#[command(name = "antrieb", version, after_long_help = exit_codes() + FIRST_STEPS, max_term_width = 100, disable_help_subcommand = true)]
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

    /// What is to be spoken and is not, by this verb.
    pub(super) fn unspoken(&self, settings: &Settings) -> Option<Failure> {
        let What::Work(verb, _) = self else { return None };
        let (what, code, speaks): (_, _, fn(&Entry) -> bool) = match (settings.profibus, settings.is_can()) {
            (true, _) => ("PROFIBUS-DP", "usage.profibus", |verb| verb.profibus),
            (_, true) => ("SDO", "usage.sdo", |verb| verb.sdo),
            _ => return None,
        };
        let cannot = !speaks(verb) && verb.takes.offers("protocol");
        cannot.then(|| {
            let name = verb.name;
            let can: Vec<_> = VERBS.iter().filter(|verb| speaks(verb)).map(|verb| verb.name).collect();
            let can = can.join(", ");
            let message = both!("`{name}` does not speak {what} yet", "`{name}` spricht noch kein {what}");
            let instead = INSTEAD.into_iter().find(|(verbs, of, _)| verbs.contains(&name) && *of == code);
            let hint = instead.map_or_else(
                || both!("what understands it: {can}", "was es versteht: {can}"),
                |(_, _, instead)| instead,
            );
            Failure::new(Class::Usage, code, message).hint(hint)
        })
    }
}

/// What there is to do where a verb does not speak something.
const INSTEAD: [(&[&str], &str, Text); 1] = [
    // They move a shaft by the control word.
    (
        &["statemachine", "sollwert"],
        "usage.sdo",
        Text::new(
            "no watchdog of a drive watches SDO (P.413 is that of its serial plug), so a shaft would go on behind a broken bus: command it over \
             the serial plug",
            "kein Watchdog eines Umrichters überwacht SDO (P.413 ist der des seriellen Anschlusses), eine Welle liefe hinter einem gestörten \
             Bus also weiter: über den seriellen Anschluss befehlen",
        ),
    ),
];

impl Subcommand for What {
    fn augment_subcommands(root: clap::Command) -> clap::Command {
        let verbs = VERBS.iter().map(|verb| (verb.command)());
        root.subcommands(verbs).subcommands(PRINTED.iter().map(|printed| (printed.command)()))
    }

    fn augment_subcommands_for_update(root: clap::Command) -> clap::Command {
        Self::augment_subcommands(root)
    }

    fn has_subcommand(name: &str) -> bool {
        VERBS.iter().any(|verb| verb.name == name || verb.alias == Some(name))
            || PRINTED.iter().any(|printed| printed.name == name)
    }
}

impl FromArgMatches for What {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let missing = || clap::Error::new(ErrorKind::MissingSubcommand);
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

/// Everything, for pages and for what does not fit.
pub(super) fn whole() -> clap::Command {
    Line::command()
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
pub(super) fn parse(arguments: &[OsString]) -> Result<(Line, Again), clap::Error> {
    let mentioned = mentioned(arguments);
    let shielded = below_zero::shielded(arguments, &mentioned);
    let read = |tree: clap::Command| {
        let matches = tree.try_get_matches_from(&shielded)?;
        Ok((Line::from_arg_matches(&matches)?, Again::of(&matches).behind(arguments)))
    };
    let told = || if arguments.iter().any(|word| word == "-h") { short::of(whole()) } else { whole() };
    read(mentioned).or_else(|error: clap::Error| match error.kind() {
        ErrorKind::DisplayVersion => Err(error),
        _ => read(told()),
    })
}

/// `antrieb help scan` is `antrieb scan --help`, and `antrieb help` is `antrieb --help`.
pub(super) fn helped(arguments: &[OsString]) -> Option<Vec<OsString>> {
    let at = arguments.iter().skip(1).position(|word| word == "help")? + 1;
    let (before, behind) = arguments.split_at_checked(at)?;
    let is_verb = |word: &OsString| word.to_str().is_some_and(What::has_subcommand);
    let options = before.iter().skip(1);
    if options.clone().any(is_verb)
        || options.clone().next().is_some_and(|word| !word.to_string_lossy().starts_with('-'))
    {
        return None;
    }
    let words = before.iter().chain(behind.iter().skip(1)).cloned();
    Some(words.chain(["--help".into()]).collect())
}

/// The tree with only those verbs that stand among the arguments; enough to read them, but not to explain anything.
pub(super) fn mentioned(arguments: &[OsString]) -> clap::Command {
    let stands = |name: &str| arguments.iter().any(|word| word == name);
    let root = clap::Command::new("antrieb").version(env!("CARGO_PKG_VERSION")).disable_help_subcommand(true);
    let verbs = VERBS.iter().filter(|verb| stands(verb.name) || verb.alias.is_some_and(stands));
    let printed = PRINTED.iter().filter(|printed| stands(printed.name));
    let root = Globals::augment_args(root).subcommands(verbs.map(|verb| (verb.command)()));
    root.subcommands(printed.map(|printed| (printed.command)()))
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
            let [few, all] = [mentioned(&words), whole()].map(|tree| tree.try_get_matches_from(&words));
            let [few, all] = [few, all].map(|matches| Line::from_arg_matches(&matches.unwrap()).unwrap());
            assert_eq!(format!("{few:?}"), format!("{all:?}"), "{typed}");
        }
    }

    #[test]
    fn help_is_a_word_as_well() {
        let words = |line: &str| line.split(' ').map(OsString::from).collect::<Vec<_>>();
        for (typed, meant) in [
            ("antrieb help", "antrieb --help"),
            ("antrieb help scan", "antrieb scan --help"),
            ("antrieb --lang de help decode fault", "antrieb --lang de decode fault --help"),
        ] {
            assert_eq!(helped(&words(typed)), Some(words(meant)), "{typed}");
        }
        for other in ["antrieb params search help", "antrieb scan", "antrieb state help"] {
            assert_eq!(helped(&words(other)), None, "{other}");
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
