//! What the program tells of itself, without settings and without a line: schemas, completions, man pages.

use super::complete::{Complete, Shell};
use super::manual;
use super::page::{Page, Source};
use crate::args::Takes;
use crate::command::{VERBS, exemplified};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document};
use crate::text::{Text, both};
use clap::{ArgMatches, Args, Command};
use std::io::{self, Write};

/// One of these.
#[derive(Debug)]
pub(super) struct Printed {
    /// How it is typed.
    pub(super) name: &'static str,
    /// Which of the options of every verb it takes.
    pub(super) takes: Takes,
    /// Its arguments and its help.
    pub(super) command: fn() -> Command,
    /// Prints it, or says why there is none.
    pub(super) print: fn(&ArgMatches, Source<'_>, &mut dyn Write) -> io::Result<Option<Failure>>,
}

/// All of them.
pub(super) const PRINTED: &[Printed] =
    &[entry::<Schema>(), entry::<Completions>(), entry::<Man>(), entry::<Complete>()];

const fn entry<P: Page>() -> Printed {
    let takes = Takes::TELLS;
    Printed { name: P::NAME, takes, command: command::<P>, print: print::<P> }
}

fn command<P: Page>() -> Command {
    exemplified(Takes::TELLS.fit(P::augment_args(Command::new(P::NAME))), "", P::EXAMPLES)
}

fn print<P: Page>(matches: &ArgMatches, source: Source<'_>, out: &mut dyn Write) -> io::Result<Option<Failure>> {
    match P::from_arg_matches(matches) {
        Ok(page) => page.print(source, out),
        Err(error) => Ok(Some(Failure::new(Class::Usage, "usage.arguments", Text::quoted(error)))),
    }
}

/// Prints the JSON Schema of a verb's output, or of every verb's
///
/// It describes the document of --json, and the records of --format ndjson while a verb goes on. Other lines of --format ndjson are
/// the items of the document's lists, each with its `type`.
#[derive(Debug, Args)]
struct Schema {
    /// The verb
    verb: Option<String>,
}

impl Page for Schema {
    const NAME: &'static str = "schema";
    const EXAMPLES: &'static [&'static str] = &["antrieb schema read"];

    fn print(&self, _source: Source<'_>, out: &mut dyn Write) -> io::Result<Option<Failure>> {
        let schema = match self.verb.as_deref() {
            None => schemars::schema_for!(Document<Data>).to_value(),
            Some(typed) => match VERBS.iter().find(|verb| verb.name == typed || verb.alias == Some(typed)) {
                Some(verb) => (verb.schema)(),
                None => {
                    let message = both!("'{typed}' has no JSON output", "'{typed}' hat keine JSON-Ausgabe");
                    return Ok(Some(Failure::new(Class::Usage, "usage.schema", message).hint(verbs())));
                }
            },
        };
        serde_json::to_writer_pretty(&mut *out, &schema)?;
        writeln!(out)?;
        out.flush().map(|()| None)
    }
}

/// The verbs, for a hint.
fn verbs() -> Text {
    let verbs = VERBS.iter().map(|verb| verb.name).collect::<Vec<_>>().join(", ");
    both!("there are: {verbs}", "es gibt: {verbs}")
}

/// Prints a completion script: bash, zsh, fish, powershell
///
/// It completes values as well: ports, drives of antrieb.toml, parameters, groups, data sets. For these the script calls
/// this program. bash: put it into ~/.local/share/bash-completion/completions/antrieb; zsh: as _antrieb into a directory of
/// $fpath; fish: into ~/.config/fish/completions/antrieb.fish; PowerShell: call it in $PROFILE.
#[derive(Debug, Args)]
struct Completions {
    /// The shell
    shell: Shell,
}

impl Page for Completions {
    const NAME: &'static str = "completions";
    const EXAMPLES: &'static [&'static str] = &["antrieb completions bash"];

    fn print(&self, source: Source<'_>, out: &mut dyn Write) -> io::Result<Option<Failure>> {
        let mut script = Vec::new();
        clap_complete::generate(self.shell.written(), &mut (source.offered)(), "antrieb", &mut script);
        out.write_all(hooked(self.shell, &String::from_utf8_lossy(&script)).as_bytes())?;
        out.flush().map(|()| None)
    }
}

/// The script with what asks this program for values.
fn hooked(shell: Shell, script: &str) -> String {
    use Shell::{Bash, Fish, Powershell, Zsh};
    const ZSH: &str = "_antrieb() {\n";
    const POWERSHELL: &str = "param($wordToComplete, $commandAst, $cursorPosition)\n";
    match shell {
        Bash => format!("{script}{}", include_str!("hooks/antrieb.bash")),
        // What has no words of its own has a value.
        Fish => {
            let asked = script.replace(" -r\n", " -x -a \"(__fish_antrieb_values)\"\n");
            format!("{asked}{}", include_str!("hooks/antrieb.fish"))
        }
        Zsh => {
            let asks = format!("{}{ZSH}    _antrieb_values && return 0\n", include_str!("hooks/antrieb.zsh"));
            script.replacen(ZSH, &asks, 1)
        }
        Powershell => script.replacen(POWERSHELL, &format!("{POWERSHELL}{}", include_str!("hooks/antrieb.ps1")), 1),
    }
}

/// Prints a man page: of the program, or of a verb
#[derive(Debug, Args)]
struct Man {
    /// The verb, and a verb of its own behind it
    verb: Vec<String>,
}

impl Page for Man {
    const NAME: &'static str = "man";
    const EXAMPLES: &'static [&'static str] = &["antrieb man statemachine enable"];

    fn print(&self, source: Source<'_>, out: &mut dyn Write) -> io::Result<Option<Failure>> {
        let mut root = (source.whole)();
        root.build();
        let found = self.verb.iter().try_fold(&root, |command, verb| command.find_subcommand(verb));
        let Some(command) = found else {
            let verb = self.verb.join(" ");
            let message = both!("there is no verb '{verb}'", "es gibt keinen Befehl '{verb}'");
            let known = root.get_subcommands().filter(|known| !known.is_hide_set()).map(clap::Command::get_name);
            let known = known.collect::<Vec<_>>().join(", ");
            let hint = both!("there are: {known}", "es gibt: {known}");
            return Ok(Some(Failure::new(Class::Usage, "usage.verb", message).hint(hint)));
        };
        manual::print(command, out)?;
        out.flush().map(|()| None)
    }
}
