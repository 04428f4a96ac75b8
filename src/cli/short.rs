//! `-h`: a line for each option, and no more lines than a terminal has beside its prompt.

use super::overview;
use clap::{Arg, Command};

/// Lines of a terminal (80 x 24), one of which is its prompt.
const SCREEN: usize = 23;

/// Options of every verb in the order in which they give way where a page has no room; who has no place here never does.
const GIVE_WAY: &[&str] = &[
    "parity",
    "protocol",
    "lang",
    "data_bits",
    "stop_bits",
    "timeout",
    "baud",
    "verbose",
    "format",
    "drive",
    "catalogue",
];

/// What a verb with commands does where none is named.
const DEFAULT: &str = "show";

/// The tree of what `-h` tells.
pub(super) fn of(root: Command) -> Command {
    let globals: Vec<_> = root.get_arguments().map(|arg| arg.get_id().clone()).collect();
    // A verb's own option of the same name has no heading.
    let is_common = |arg: &Arg| globals.contains(arg.get_id()) && arg.get_help_heading().is_some();
    let under = |arg: Arg| match is_common(&arg) {
        true => arg.help_heading(COMMON),
        false => arg.help_heading(None::<&str>),
    };
    let root = root.mut_subcommands(|verb| {
        let verb = verb.mut_args(under);
        let common: Vec<_> = verb.get_arguments().filter(|arg| is_common(arg)).cloned().collect();
        let verb = verb.mut_subcommands(|inner| {
            let own = |arg: &&Arg| !inner.get_arguments().any(|own| own.get_id() == arg.get_id());
            let common: Vec<_> = common.iter().filter(own).cloned().collect();
            fitted(inner.mut_args(under).args(common))
        });
        fitted(verb)
    });
    overview::of(root)
}

/// What the options of every verb stand under.
const COMMON: &str = "Options of every verb (more with --help)";

/// The same where the command has options of its own that its page leaves out.
const COMMON_TOO: &str = "Options of every verb (more, also of this one alone, with --help)";

/// The command with as many of the common options as its page has room for.
fn fitted(command: Command) -> Command {
    let is_told = |arg: &&Arg| !arg.is_hide_set() && !arg.is_hide_short_help_set();
    let told: Vec<_> = command.get_arguments().filter(is_told).collect();
    let shown = told.iter().map(|arg| arg.get_id().to_string()).collect::<Vec<_>>();
    let block = |rows: usize| if rows == 0 { 0 } else { rows + 2 };
    let positional = told.iter().filter(|arg| arg.is_positional()).count();
    let common = told.iter().filter(|arg| arg.get_help_heading() == Some(COMMON)).count();
    let inner = command.get_subcommands().filter(|inner| !inner.is_hide_set()).count();
    // `--help` is an option too.
    let options = told.len() - positional - common + 1;
    // What it does, and how it is called; behind the last block there is no blank line.
    let usages = 1 + usize::from(inner > 0 && command.is_args_conflicts_with_subcommands_set());
    let lines = 3 + usages + block(positional) + block(inner) + block(options) + block(common) - 1;
    let away = GIVE_WAY.iter().filter(|name| shown.iter().any(|shown| shown == *name));
    let lacking = lines.saturating_sub(SCREEN);
    let away: Vec<&str> = away.take(lacking).copied().collect();
    // What it does without a word gives way as the last.
    let is_default_away = away.len() < lacking && command.find_subcommand(DEFAULT).is_some();
    let command = if is_default_away { command.mut_subcommand(DEFAULT, |inner| inner.hide(true)) } else { command };
    let is_own = |arg: &&Arg| arg.get_help_heading() != Some(COMMON) && !arg.is_global_set();
    let hidden = |arg: &&Arg| is_own(arg) && arg.is_hide_short_help_set() && !arg.is_hide_set();
    let heading = if command.get_arguments().filter(hidden).count() > 0 { COMMON_TOO } else { COMMON };
    command.mut_args(|arg| {
        let arg = if away.contains(&arg.get_id().as_str()) { arg.hide_short_help(true) } else { arg };
        if arg.get_help_heading() == Some(COMMON) { arg.help_heading(heading) } else { arg }
    })
}
