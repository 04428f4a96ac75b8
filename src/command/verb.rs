//! What a verb is. It is declared in its own file, by [`Verb`] for its arguments, and once in the list
//! [`VERBS`](super::VERBS): dispatch, help, completions, man pages, schemas and the matrix of tests walk that list.

use super::Context;
use super::lines::OverLines;
use crate::args::Takes;
use crate::drive::Upper;
use crate::failure::Failure;
use crate::outcome::Outcome;
use schemars::{JsonSchema, schema_for};
use std::fmt::Debug;
use std::future::Future;
use std::path::PathBuf;
use std::pin::Pin;

/// The work of a verb on its way.
pub type Working<'a> = Pin<Box<dyn Future<Output = Result<Outcome, Failure>> + 'a>>;

/// A verb, told by the type of its arguments; their doc comment is its help.
pub trait Verb: clap::Args + Debug + 'static {
    /// How it is typed.
    const NAME: &'static str;
    /// How it may be typed as well.
    const ALIAS: Option<&'static str> = None;
    /// Whether it can turn a shaft. Then it ends when nobody reads its output any more, and says on stderr how.
    const TURNS: bool = false;
    /// Whether it works on a whole plant, over several lines: then `-a` and `-p` pick of its drives.
    const OF_PLANT: bool = false;
    /// Whether it understands PROFIBUS-DP (`--protocol dp`).
    const PROFIBUS: bool = false;
    /// Whether it understands SDO (`--protocol sdo`).
    const SDO: bool = false;
    /// The longest that it takes, whatever comes over the line.
    const UPPER: Upper = Upper::OFFLINE;
    /// Which of the options of every verb it takes.
    const TAKES: Takes;
    /// Its parts that take other options.
    const PARTS: &'static [(&'static str, Takes)] = &[];
    /// Command lines that its help shows, and a test runs. Of what it does, each at least once.
    const EXAMPLES: &'static [&'static str];
    /// What it prints as JSON: `Document<D>` with what it finds, or the lines of its stream.
    type Prints: JsonSchema;

    /// What it tells while it works; `None` if it tells everything at the end.
    fn streams(&self) -> Option<Flow> {
        None
    }

    /// What it does with drives that lie on several lines.
    fn over_lines(&self) -> OverLines {
        OverLines::One(None)
    }

    /// Works. What ends it early is a failure; what fails on the way stands in the outcome beside what was found.
    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a>;
}

/// What comes while a verb works.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Flow {
    /// Values of drives, again and again, without an end to wait for.
    Samples {
        /// On a terminal one line that is refreshed is wanted, and not the whole of it.
        line: bool,
        /// Each line on stdin calls for them.
        gather: bool,
        /// A file that always holds the last round.
        textfile: Option<PathBuf>,
        /// A file that keeps what comes.
        record: Option<PathBuf>,
    },
    /// Telegrams.
    Telegrams {
        /// A file that keeps them as a capture; `-` is stdout, in the place of anything else.
        capture: Option<PathBuf>,
    },
    /// How far a search is, and a document at its end.
    Search,
    /// A run that is held, and a document at its end.
    Run {
        /// The whole terminal is wanted, with its keys.
        view: bool,
    },
}

/// A verb with its arguments as they were typed.
pub trait Typed: Debug {
    /// See [`Verb::streams`].
    fn streams(&self) -> Option<Flow>;
    /// See [`Verb::over_lines`].
    fn over_lines(&self) -> OverLines;
    /// See [`Verb::run`].
    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a>;
}

impl<V: Verb> Typed for V {
    fn streams(&self) -> Option<Flow> {
        Verb::streams(self)
    }
    fn over_lines(&self) -> OverLines {
        Verb::over_lines(self)
    }
    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Verb::run(self, context)
    }
}

/// A row of the list of verbs.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// How it is typed.
    pub name: &'static str,
    /// How it may be typed as well.
    pub alias: Option<&'static str>,
    /// Whether it can turn a shaft.
    pub turns: bool,
    /// Whether it works on a whole plant.
    pub of_plant: bool,
    /// Whether it understands PROFIBUS-DP.
    pub profibus: bool,
    /// Whether it understands SDO.
    pub sdo: bool,
    /// The longest that it takes, whatever comes over the line.
    pub upper: Upper,
    /// Which of the options of every verb it takes.
    pub takes: Takes,
    /// Command lines that its help shows.
    pub examples: &'static [&'static str],
    /// Its arguments and its help.
    pub command: fn() -> clap::Command,
    /// JSON Schema of what it prints.
    pub schema: fn() -> serde_json::Value,
    /// Takes what was typed.
    pub typed: fn(&clap::ArgMatches) -> Result<Box<dyn Typed>, clap::Error>,
}

/// The row of a verb.
pub(super) const fn entry<V: Verb>() -> Entry {
    Entry {
        name: V::NAME,
        alias: V::ALIAS,
        turns: V::TURNS,
        of_plant: V::OF_PLANT,
        profibus: V::PROFIBUS,
        sdo: V::SDO,
        upper: V::UPPER,
        takes: V::TAKES,
        examples: V::EXAMPLES,
        command: command::<V>,
        schema: schema::<V>,
        typed: typed::<V>,
    }
}

fn command<V: Verb>() -> clap::Command {
    let command = V::TAKES.fit(V::augment_args(clap::Command::new(V::NAME)));
    let command = V::PARTS
        .iter()
        .fold(command, |command, (part, takes)| command.mut_subcommand(part, |part| takes.fit_part(part, V::NAME)));
    let more = command.get_after_long_help().map(ToString::to_string).into_iter().chain(V::UPPER.told());
    let more = more.collect::<Vec<_>>().join("\n\n");
    let command = exemplified(command, &more, V::EXAMPLES);
    V::ALIAS.into_iter().fold(command, clap::Command::visible_alias)
}

/// The command with what its long help ends with: this, and the examples. Of them a subcommand shows those that name it.
pub fn exemplified(command: clap::Command, more: &str, examples: &[&str]) -> clap::Command {
    let ending = |more: &str, examples: &[&str]| {
        let examples = examples.iter().fold(EXAMPLES.to_owned(), |text, line| format!("{text}\n  {line}"));
        if more.is_empty() { examples } else { format!("{more}\n\n{examples}") }
    };
    let command = command.mut_subcommands(|inner| {
        let named = examples.iter().filter(|line| line.split(' ').any(|word| word == inner.get_name()));
        let named: Vec<_> = named.copied().collect();
        inner.after_long_help(ending("", &named))
    });
    command.after_long_help(ending(more, examples))
}

/// What the examples of a help stand behind.
pub const EXAMPLES: &str = "Examples:";

fn schema<V: Verb>() -> serde_json::Value {
    schema_for!(V::Prints).to_value()
}

fn typed<V: Verb>(matches: &clap::ArgMatches) -> Result<Box<dyn Typed>, clap::Error> {
    Ok(Box::new(V::from_arg_matches(matches)?))
}
