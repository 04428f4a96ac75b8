//! What the program tells of itself, without settings and without a line: schemas, completions, man pages.

use crate::command::VERBS;
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document};
use crate::text::{Text, both};
use clap::{ArgMatches, Args};
use std::io::{self, Write};

/// One of these.
#[derive(Debug)]
pub(super) struct Printed {
    /// How it is typed.
    pub(super) name: &'static str,
    /// Its arguments and its help.
    pub(super) command: fn() -> clap::Command,
    /// Prints it, or says why there is none.
    pub(super) print: fn(&ArgMatches, Tree, &mut dyn Write) -> io::Result<Option<Failure>>,
}

/// The whole tree of arguments, built where it is needed.
type Tree = fn() -> clap::Command;

/// All of them.
pub(super) const PRINTED: &[Printed] = &[
    Printed { name: "schema", command: command::<Schema>, print: print::<Schema> },
    Printed { name: "completions", command: command::<Completions>, print: print::<Completions> },
    Printed { name: "man", command: command::<Man>, print: print::<Man> },
];

trait Page: Args {
    const NAME: &'static str;
    fn print(&self, tree: Tree, out: &mut dyn Write) -> io::Result<Option<Failure>>;
}

fn command<P: Page>() -> clap::Command {
    P::augment_args(clap::Command::new(P::NAME))
}

fn print<P: Page>(matches: &ArgMatches, tree: Tree, out: &mut dyn Write) -> io::Result<Option<Failure>> {
    match P::from_arg_matches(matches) {
        Ok(page) => page.print(tree, out),
        Err(error) => Ok(Some(Failure::new(Class::Usage, "usage.arguments", Text::quoted(error)))),
    }
}

/// Prints the JSON Schema of a verb's output, or of every verb's
#[derive(Debug, Args)]
struct Schema {
    /// The verb
    verb: Option<String>,
}

impl Page for Schema {
    const NAME: &'static str = "schema";

    fn print(&self, _tree: Tree, out: &mut dyn Write) -> io::Result<Option<Failure>> {
        let schema = match self.verb.as_deref() {
            None => schemars::schema_for!(Document<Data>).to_value(),
            Some(typed) => match VERBS.iter().find(|verb| verb.name == typed || verb.alias == Some(typed)) {
                Some(verb) => (verb.schema)(),
                None => {
                    let message = both!("'{typed}' has no JSON output", "'{typed}' hat keine JSON-Ausgabe");
                    return Ok(Some(Failure::new(Class::Usage, "usage.schema", message)));
                }
            },
        };
        serde_json::to_writer_pretty(&mut *out, &schema)?;
        writeln!(out)?;
        out.flush().map(|()| None)
    }
}

/// Prints a completion script
#[derive(Debug, Args)]
#[command(hide = true)]
struct Completions {
    /// bash, zsh, fish, powershell
    shell: clap_complete::Shell,
}

impl Page for Completions {
    const NAME: &'static str = "completions";

    fn print(&self, tree: Tree, out: &mut dyn Write) -> io::Result<Option<Failure>> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell, &mut tree(), "antrieb", &mut script);
        out.write_all(&script)?;
        out.flush().map(|()| None)
    }
}

/// Prints a man page: of the program, or of a verb
#[derive(Debug, Args)]
#[command(hide = true)]
struct Man {
    /// The verb
    verb: Option<String>,
}

impl Page for Man {
    const NAME: &'static str = "man";

    fn print(&self, tree: Tree, out: &mut dyn Write) -> io::Result<Option<Failure>> {
        let mut root = tree();
        root.build();
        let page = match self.verb.as_deref() {
            None => clap_mangen::Man::new(root),
            Some(verb) => match root.find_subcommand(verb) {
                Some(found) => clap_mangen::Man::new(found.clone().version(env!("CARGO_PKG_VERSION"))),
                None => {
                    let message = both!("there is no verb '{verb}'", "es gibt keinen Befehl '{verb}'");
                    return Ok(Some(Failure::new(Class::Usage, "usage.verb", message)));
                }
            },
        };
        // No date: the page must be the same whenever it is built.
        page.date("").source("antrieb").manual("Commissioning of drives").render(out)?;
        out.flush().map(|()| None)
    }
}
