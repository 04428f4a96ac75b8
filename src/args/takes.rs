//! Which of the options of every verb a verb takes, and how loudly it offers them.
//!
//! What an option asks for must happen, or the option is refused behind the verb: `--baud` sets nothing under `params`.
//! Before the verb settings are those of the bus, as in `antrieb.toml`, and each verb takes of them what it uses; only what
//! asks for something to be done (`--trace`, `--dry-run`) is refused there too. What holds anyway is taken in silence: where
//! nothing is asked, `--yes` has answered it.

use super::globals::Globals;
use crate::failure::{Class, Failure};
use crate::text::{Text, both};
use clap::{Arg, ArgAction, Args, Command};
use std::fmt;

/// What a verb does with the options of every verb, each named by its field of [`Globals`]. What is in none of these lists is
/// told by `--help` alone.
#[derive(Clone, Copy, Debug)]
pub struct Takes {
    /// Told by `-h` too.
    first: &'static [&'static str],
    /// Taken, but offered by nobody.
    silent: &'static [&'static str],
    /// Of no use here, list by list.
    refused: &'static [&'static [&'static str]],
}

impl Takes {
    /// Talks to drives, and asks nobody for leave.
    pub const READS: Takes = Takes {
        first: &["port", "address", "baud", "parity", "protocol", "drive", "format", "lang", "verbose", "dry_run"],
        silent: &["yes"],
        refused: &[],
    };
    /// Talks to drives, and asks before it changes something.
    pub const WRITES: Takes = Takes {
        first: &["port", "address", "baud", "parity", "protocol", "drive", "format", "dry_run", "yes"],
        silent: &[],
        refused: &[],
    };
    /// Finds drives.
    pub const SEARCHES: Takes = Takes {
        first: &["port", "address", "baud", "parity", "protocol", "timeout", "format", "lang", "verbose", "dry_run"],
        silent: &["drive", "word_order", "yes"],
        refused: &[],
    };
    /// Listens on a line.
    pub const LISTENS: Takes = Takes {
        first: &["port", "baud", "parity", "data_bits", "stop_bits", "protocol", "drive", "format", "lang", "trace"],
        silent: &["timeout", "retries", "yes"],
        refused: &[],
    };
    /// Listens on a CAN bus, which has no characters.
    pub const HEARS: Takes = Takes {
        first: &["port", "baud", "protocol", "drive", "format", "lang", "trace", "dry_run"],
        silent: &["timeout", "retries", "yes"],
        refused: &[&["parity", "stop_bits", "data_bits", "address", "word_order"]],
    };
    /// Explains what is on a line, without one.
    pub const EXPLAINS: Takes = Takes {
        first: &["protocol", "drive", "word_order", "format", "lang", "catalogue"],
        silent: &["address", "dry_run", "yes"],
        refused: &[SETTINGS, OVER_A_LINE],
    };
    /// Knows drives, and no line.
    pub const BROWSES: Takes = Takes {
        first: &["drive", "format", "lang", "catalogue"],
        silent: &["dry_run", "yes"],
        refused: &[SETTINGS, OVER_A_LINE, &["address", "protocol", "word_order"]],
    };
    /// Looks at a PROFIBUS line, which has one format and times of its own, or knows of it without one.
    pub const PROFIBUS: Takes = Takes {
        first: &["port", "address", "baud", "drive", "format", "lang", "verbose", "dry_run", "yes"],
        silent: &["protocol", "catalogue"],
        refused: &[&["parity", "stop_bits", "data_bits", "timeout", "word_order"]],
    };
    /// Looks at drives and writes to them, or knows of their bus without a line.
    pub const SYSTEM_BUS: Takes = Takes {
        first: &["port", "address", "baud", "protocol", "drive", "format", "lang", "dry_run", "yes"],
        silent: &[],
        refused: &[],
    };
    /// Draws what was recorded, without a line.
    pub const DRAWS: Takes = Takes {
        first: &["address", "format", "lang"],
        silent: &["drive", "dry_run", "yes"],
        refused: &[SETTINGS, OVER_A_LINE, &["protocol", "word_order"]],
    };
    /// Is a line itself.
    pub const SERVES: Takes = Takes {
        first: &["format", "lang", "quiet", "catalogue"],
        silent: &["yes"],
        refused: &[SETTINGS, OVER_A_LINE, OF_A_DRIVE],
    };
    /// Tells of the program itself.
    pub const TELLS: Takes = Takes {
        first: &[],
        silent: &[
            "format",
            "json",
            "lang",
            "quiet",
            "verbose",
            "color",
            "no_progress",
            "config",
            "no_config",
            "catalogue",
            "yes",
        ],
        refused: &[SETTINGS, OVER_A_LINE, OF_A_DRIVE],
    };

    /// The command with these options, as this verb takes them.
    pub fn fit(&self, command: Command) -> Command {
        let verb = command.get_name().to_owned();
        self.fit_named(command, &verb)
    }

    /// A part of a verb, with these options in place of those of the verb.
    pub fn fit_part(&self, part: Command, verb: &str) -> Command {
        let name = format!("{verb} {}", part.get_name());
        self.fit_named(part, &name)
    }

    fn fit_named(&self, command: Command, verb: &str) -> Command {
        let globals = Globals::augment_args(Command::new("globals"));
        let own: Vec<_> = command.get_arguments().map(|arg| arg.get_id().clone()).collect();
        let others = globals.get_arguments().filter(|arg| !own.contains(arg.get_id()));
        command.args(others.map(|arg| self.arg(arg, verb)))
    }

    fn arg(&self, arg: &Arg, verb: &str) -> Arg {
        let is_in = |list: &[&str]| list.contains(&arg.get_id().as_str());
        let is_first = is_in(self.first);
        if self.refuses(arg.get_id().as_str()) {
            refusing(arg, verb)
        } else {
            arg.clone().hide(is_in(self.silent)).hide_short_help(!is_first)
        }
    }

    fn refuses(&self, option: &str) -> bool {
        self.refused.iter().any(|list| list.contains(&option))
    }

    /// Whether it offers this option.
    pub fn offers(&self, option: &str) -> bool {
        !self.silent.contains(&option) && !self.refuses(option)
    }

    /// What was asked for before the verb and will not happen.
    pub fn unkept(&self, verb: &str, typed: &Globals) -> Option<Failure> {
        let asked = [("trace", typed.trace.is_some()), ("dry_run", typed.dry_run)];
        let unkept = asked.into_iter().find(|(option, asked)| *asked && self.refuses(option));
        unkept.map(|(option, _)| Useless { verb: verb.to_owned(), option: flag(option) }.into())
    }
}

/// How a line is reached and set.
pub const SETTINGS: &[&str] =
    &["port", "baud", "parity", "stop_bits", "data_bits", "rs485", "rs485_before", "rs485_after"];
/// How long an answer is waited for on it, how often it is asked for, and what is kept of all that.
const OVER_A_LINE: &[&str] = &["timeout", "retries", "trace"];
/// Whom is talked to on it, how, and what is done there.
const OF_A_DRIVE: &[&str] = &["address", "protocol", "drive", "word_order", "force", "dry_run"];

/// Takes the place of an option, and says that it is of no use here.
fn refusing(arg: &Arg, verb: &str) -> Arg {
    let option = flag(arg.get_id().as_str());
    let useless = Useless { verb: verb.to_owned(), option };
    let refuse = move |_: &str| Err::<String, _>(useless.clone());
    let values = if arg.get_action().takes_values() { 0..=1 } else { 0..=0 };
    let place = arg.clone().hide(true).action(ArgAction::Set).num_args(values);
    place.default_missing_value("").value_parser(refuse)
}

fn flag(option: &str) -> String {
    format!("--{}", option.replace('_', "-"))
}

/// An option behind a verb to which it says nothing.
#[derive(Clone, Debug)]
pub struct Useless {
    verb: String,
    option: String,
}

impl Useless {
    fn text(&self) -> Text {
        let Useless { verb, option } = self;
        both!("`{verb}` has no use for {option}", "`{verb}` kann mit {option} nichts anfangen")
    }
}

impl From<Useless> for Failure {
    fn from(useless: Useless) -> Self {
        let verb = &useless.verb;
        Failure::new(Class::Usage, "usage.no_use", useless.text()).hint(both!(
            "leave it out; `antrieb {verb} -h` shows what is taken there",
            "weglassen; `antrieb {verb} -h` zeigt, was dort angenommen wird"
        ))
    }
}

impl fmt::Display for Useless {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text().en)
    }
}

impl std::error::Error for Useless {}
