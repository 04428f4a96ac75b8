//! `complete`: what could stand where somebody types. The completion scripts call it for values; options and verbs are
//! left to what they know by themselves. Where a value stands it says so even if it has none to offer ([`FILES`],
//! [`NOTHING`]), so that no shell adds of its own to what may be a number. Nothing is opened, and whatever goes wrong is silence.

use super::page::{Page, Source};
use super::values::{self, Place};
use crate::failure::Failure;
use clap::{Arg, ArgAction, Args, Command, ValueEnum, ValueHint};
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::{self, Write};

/// A value stands here, and a file can be it; no candidate, because it begins with a tabulator.
const FILES: &str = "\tfiles";

/// A value stands here, and nobody but who types knows it.
const NOTHING: &str = "\tnothing";

/// Prints what could be typed next, a candidate a line
#[derive(Debug, Args)]
#[command(hide = true)]
pub(super) struct Complete {
    /// For which script
    shell: Shell,
    /// A new word begins: for a shell that cannot hand on an empty one
    #[arg(long)]
    next: bool,
    /// What was typed behind `antrieb`, the unfinished word last
    #[arg(last = true, allow_hyphen_values = true)]
    words: Vec<OsString>,
}

/// Who asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Shell {
    /// Bare candidates.
    Bash,
    /// Candidate, tabulator, what it is.
    Zsh,
    /// The same; of `--option=value` the value alone.
    Fish,
    /// As zsh.
    Powershell,
}

impl Shell {
    /// Who writes the script for it.
    pub(super) fn written(self) -> clap_complete::Shell {
        match self {
            Shell::Bash => clap_complete::Shell::Bash,
            Shell::Zsh => clap_complete::Shell::Zsh,
            Shell::Fish => clap_complete::Shell::Fish,
            Shell::Powershell => clap_complete::Shell::PowerShell,
        }
    }
}

impl Page for Complete {
    const NAME: &'static str = "complete";
    const EXAMPLES: &'static [&'static str] = &["antrieb complete zsh -- read rated"];

    fn print(&self, source: Source<'_>, out: &mut dyn Write) -> io::Result<Option<Failure>> {
        let mut words: Vec<String> = self.words.iter().map(|word| word.to_string_lossy().into_owned()).collect();
        if self.next || words.is_empty() {
            words.push(String::new());
        }
        let arguments: Vec<OsString> = words.iter().map(OsString::from).collect();
        let (place, head) = place(&(source.mentioned)(&arguments), &words);
        // fish keeps `--port=` by itself, and `-p` not.
        let head = if self.shell == Shell::Fish && head.starts_with("--") { "" } else { head };
        let Some(place) = place else { return Ok(None) };
        let found = values::fitting(&place, source.environment);
        if found.is_empty() {
            writeln!(out, "{}", if place.file { FILES } else { NOTHING })?;
        }
        for (value, about) in found {
            let about = about.replace(char::is_control, " ");
            match self.shell {
                Shell::Bash => writeln!(out, "{head}{value}")?,
                _ => writeln!(out, "{head}{value}\t{about}")?,
            }
        }
        out.flush().map(|()| None)
    }
}

/// Where the last word stands, and what of it is the option in front of its value (`--port=`, `-p`).
fn place<'w>(root: &Command, words: &'w [String]) -> (Option<Place<'w>>, &'w str) {
    let Some((word, before)) = words.split_last() else { return (None, "") };
    let mut path = vec![root];
    let mut said: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    let mut row: Vec<&str> = Vec::new();
    let mut open: Option<&Arg> = None;
    for typed in before {
        let inner = path.last().and_then(|command| command.find_subcommand(typed));
        if let Some(arg) = open.take() {
            said.entry(arg.get_id().to_string()).or_default().push(typed);
        } else if let Some((flag, value)) = typed.split_once('=').filter(|(flag, _)| flag.starts_with('-')) {
            let arg = option(&path, flag);
            arg.into_iter().for_each(|arg| said.entry(arg.get_id().to_string()).or_default().push(value));
        } else if is_option(typed) {
            open = option(&path, typed).filter(|arg| takes_value(arg));
        } else if let Some(inner) = inner {
            path.push(inner);
        } else {
            row.push(typed);
        }
    }
    let verb = path.get(1).map_or("", |verb| verb.get_name());
    let at = |arg: &Arg, word: &'w str, row: Vec<&'w str>| Place {
        verb: verb.to_owned(),
        value: arg.get_id().to_string(),
        possible: arg.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect(),
        word,
        row,
        said: said.clone(),
        file: is_file(arg, word),
    };
    if let Some(arg) = open {
        return (Some(at(arg, word, row)), "");
    }
    if word.starts_with("--") {
        let Some(end) = word.find('=') else { return (None, "") };
        let (head, value) = word.split_at(end + 1);
        return (option(&path, head.trim_end_matches('=')).map(|arg| at(arg, value, row)), head);
    }
    if is_option(word) {
        let value = word.char_indices().nth(2).map(|(at, _)| word.split_at(at));
        let Some((head, value)) = value else { return (None, "") };
        return (option(&path, head).filter(|arg| takes_value(arg)).map(|arg| at(arg, value, row)), head);
    }
    let Some(command) = path.last() else { return (None, "") };
    let positional = command.get_positionals().nth(row.len()).or_else(|| {
        let last = command.get_positionals().last();
        last.filter(|arg| matches!(arg.get_action(), ArgAction::Append))
    });
    // A verb that takes no word more: what its options have in common at their beginning is none.
    let nothing = Arg::new("nothing");
    let ends = word.is_empty() && path.len() > 1 && !command.has_subcommands();
    (positional.or(ends.then_some(&nothing)).map(|arg| at(arg, word, row)), "")
}

/// The option with this flag: of the innermost command, or one that comes down to it.
fn option<'c>(path: &[&'c Command], flag: &str) -> Option<&'c Arg> {
    let long = flag.strip_prefix("--");
    let short = flag.strip_prefix('-').filter(|_| long.is_none()).and_then(|short| short.chars().next());
    let named = |arg: &&Arg| {
        long.is_some_and(|long| arg.get_long() == Some(long)) || short.is_some() && arg.get_short() == short
    };
    path.iter().rev().find_map(|command| command.get_arguments().filter(|arg| !arg.is_hide_set()).find(named))
}

/// Whether this is no value: what is below zero is one.
fn is_option(word: &str) -> bool {
    word.strip_prefix('-')
        .is_some_and(|rest| !rest.starts_with(|letter: char| letter.is_ascii_digit() || letter == '.'))
}

/// Whether a file can stand here: as such, or as what a port (`sim:FILE`) or a side of a comparison is.
fn is_file(arg: &Arg, word: &str) -> bool {
    let among_others = ["port", "a", "b"].contains(&arg.get_id().as_str()) && !word.contains("://");
    among_others || matches!(arg.get_value_hint(), ValueHint::AnyPath | ValueHint::FilePath | ValueHint::DirPath)
}

fn takes_value(arg: &Arg) -> bool {
    arg.get_action().takes_values()
}
