//! `-h`: a line for each option, and no more lines than a terminal has beside its prompt.
//!
//! One rule for every verb. First what every call needs (port, address, `--dry-run`, `--yes`) and the verb's own options, those marked
//! `hide_short_help` as the last of them; then the options of every verb that `Takes` puts first, in the order in which they matter, as
//! long as there is room. How many are left to `--help` stands in the heading.

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

/// The heading of options that say something to one protocol alone.
const ONE_PROTOCOL: &str = "PROFIBUS";

/// What a verb with commands does where none is named.
const DEFAULT: &str = "show";

/// The tree of what `-h` tells.
pub(super) fn of(root: Command) -> Command {
    let globals: Vec<_> = root.get_arguments().map(|arg| arg.get_id().clone()).collect();
    // A verb's own option of the same name has no heading.
    let is_common = |arg: &Arg| globals.contains(arg.get_id()) && arg.get_help_heading().is_some();
    let under = |arg: Arg| match arg.get_help_heading() {
        Some(_) if is_common(&arg) => arg.help_heading(COMMON),
        Some(ONE_PROTOCOL) if arg.is_hide_short_help_set() => arg,
        _ => arg.help_heading(None::<&str>),
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

/// What the options of every verb stand under, before it is known how many are left out.
const COMMON: &str = "Options of every verb";

/// The same with what `--help` tells besides.
fn heading(own: usize, common: usize) -> String {
    match (own, common) {
        (0, 0) => COMMON.to_owned(),
        (0, more) => format!("{COMMON} ({more} more with --help)"),
        (own, common) => format!("{COMMON} ({} more with --help, {own} of them of this verb)", own + common),
    }
}

/// The command with as many of its own options as its page has room for, and behind them of the common ones.
fn fitted(command: Command) -> Command {
    let is_common = |arg: &&Arg| arg.get_help_heading() == Some(COMMON);
    let is_told = |arg: &Arg| !arg.is_hide_short_help_set();
    let gives_way = |arg: &Arg| GIVE_WAY.contains(&arg.get_id().as_str());
    let offered: Vec<&Arg> = command.get_arguments().filter(|arg| !arg.is_hide_set()).collect();
    let (all_common, own): (Vec<&Arg>, Vec<&Arg>) = offered.into_iter().partition(is_common);
    let (positional, own): (Vec<&Arg>, Vec<&Arg>) = own.into_iter().partition(|arg| arg.is_positional());
    let inner = command.get_subcommands().filter(|inner| !inner.is_hide_set()).count();
    let usages = 1 + usize::from(inner > 0 && command.is_args_conflicts_with_subcommands_set());
    let block = |rows: usize| if rows == 0 { 0 } else { rows + 2 };
    // What it does, and how it is called; `--help` is an option too; behind the last block there is no blank line.
    let blocks = 3 + usages + block(positional.len()) + block(inner) - 1;
    let has_room = |own: usize, common: usize| blocks + block(own + 1) + block(common) <= SCREEN;
    let mut told: Vec<String> = own.iter().filter(|arg| is_told(arg)).map(|arg| arg.get_id().to_string()).collect();
    let kept = all_common.iter().filter(|arg| is_told(arg) && !gives_way(arg)).map(|arg| arg.get_id().to_string());
    let mut common: Vec<String> = kept.collect();
    // Under their heading stands how many are left out.
    let least = usize::from(all_common.iter().any(|arg| is_told(arg)));
    // Those of one protocol alone stand under a heading of their own, in `--help`.
    for arg in own.iter().filter(|arg| !is_told(arg) && arg.get_help_heading().is_none()) {
        if has_room(told.len() + 1, common.len().max(least)) {
            told.push(arg.get_id().to_string());
        }
    }
    for name in GIVE_WAY.iter().rev() {
        let arg = all_common.iter().find(|arg| arg.get_id() == name && is_told(arg));
        if let Some(arg) = arg.filter(|_| has_room(told.len(), common.len() + 1)) {
            common.push(arg.get_id().to_string());
        }
    }
    let (own, left) = (own.len() - told.len(), all_common.len() - common.len());
    // What it does without a word gives way as the last.
    let is_default_away = !has_room(told.len(), common.len()) && command.find_subcommand(DEFAULT).is_some();
    let command = if is_default_away { command.mut_subcommand(DEFAULT, |inner| inner.hide(true)) } else { command };
    let heading = heading(own, left);
    command.mut_args(|arg| {
        let is_away = |told: &[String]| !told.iter().any(|id| arg.get_id() == id.as_str());
        if arg.get_help_heading() == Some(COMMON) {
            let is_away = is_away(&common);
            arg.hide_short_help(is_away).help_heading(heading.clone())
        } else if arg.is_positional() {
            arg
        } else {
            let is_away = is_away(&told);
            arg.hide_short_help(is_away)
        }
    })
}
