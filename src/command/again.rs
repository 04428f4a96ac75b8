//! The command line of this run with another verb: what a hint tells to type must work as it stands there.

use super::{Entry, VERBS};
use crate::args::{Globals, SETTINGS};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, ErrorDoc, Load, Outcome, Warning};
use crate::text::{Lang, Text, both};
use clap::parser::ValueSource;
use clap::{ArgMatches, Args as _, Command};
use std::ffi::OsString;

/// What says where something is done, and how it is reached; how it is told and what is agreed to is said anew each time.
const CARRIED: [&[&str]; 3] = [
    &["config", "no_config", "catalogue"],
    SETTINGS,
    &["protocol", "timeout", "retries", "address", "drive", "word_order"],
];
/// Before and behind a command in a text, where it stands alone.
const MARK: char = '`';

/// The options of this run.
#[derive(Clone, Debug, Default)]
pub struct Again {
    given: Vec<Given>,
    /// The whole of it, behind the name of the program.
    words: Vec<String>,
}

/// A verb for one drive was asked of several: the hint says how it is typed for the first of them.
pub(super) fn one_of(failure: Failure, addresses: &[u8]) -> Failure {
    match addresses.first() {
        Some(first) => failure.with(ONE_OF, first),
        None => failure,
    }
}

const ONE_OF: &str = "one_of";

/// An option as it was typed.
#[derive(Clone, Debug)]
struct Given {
    id: &'static str,
    /// In both ways: `-p`, `--port`.
    names: Vec<String>,
    /// None of a flag.
    values: Vec<String>,
}

impl Again {
    /// Of a command line that was understood.
    pub fn of(matches: &ArgMatches) -> Self {
        let globals = Globals::augment_args(Command::new("antrieb"));
        let given = CARRIED.into_iter().flatten().filter_map(|&id| {
            let arg = globals.get_arguments().find(|arg| arg.get_id() == id)?;
            let raw = matches.try_get_raw(id).ok().flatten()?;
            if matches.value_source(id) != Some(ValueSource::CommandLine) {
                return None;
            }
            let values = if arg.get_action().takes_values() {
                raw.map(|value| value.to_string_lossy().into_owned()).collect()
            } else {
                Vec::new()
            };
            let short = arg.get_short().map(|short| format!("-{short}"));
            let names = short.into_iter().chain(arg.get_long().map(|long| format!("--{long}"))).collect();
            Some(Given { id, names, values })
        });
        Again { given: given.collect(), words: Vec::new() }
    }

    /// Of this command line, word for word.
    pub fn behind(self, arguments: &[OsString]) -> Self {
        let words = arguments.iter().skip(1).map(|word| word.to_string_lossy().into_owned()).collect();
        Again { words, ..self }
    }

    /// Of one that was not: so far as its options can be told.
    pub fn guessed(arguments: &[OsString]) -> Self {
        let tree = || Globals::augment_args(Command::new("antrieb")).disable_help_flag(true).ignore_errors(true);
        let before = tree().allow_external_subcommands(true).try_get_matches_from(arguments).unwrap_or_default();
        let mut again = Again::of(&before);
        let Some(behind) = before.subcommand().and_then(|(_, own)| own.try_get_raw("").ok().flatten()) else {
            return again;
        };
        let rest = clap::Arg::new("rest").num_args(0..);
        let words = std::iter::once(OsString::from("antrieb")).chain(behind.map(OsString::from));
        let behind = Again::of(&tree().arg(rest).try_get_matches_from(words).unwrap_or_default());
        again.given.retain(|one| behind.given.iter().all(|other| other.id != one.id));
        again.given.extend(behind.given);
        again
    }

    /// An outcome with commands that work as they stand there.
    pub fn told(&self, mut outcome: Outcome) -> Outcome {
        outcome.each_error(&mut |error| self.row(error));
        let Outcome { data, warnings, failure } = outcome;
        let warnings =
            warnings.into_iter().map(|it| Warning { message: self.typed(&it.message, About::default()), ..it });
        let data = data.map(|data| self.closed(data));
        Outcome { data, warnings: warnings.collect(), failure: failure.map(|failure| self.hinted(failure)) }
    }

    /// The same of a failure; it knows the address that nobody typed.
    pub fn hinted(&self, failure: Failure) -> Failure {
        let address = failure.context.iter().find(|(key, _)| *key == "address").map(|(_, address)| address.as_str());
        let about = About { address, is_unheard: matches!(failure.class, Class::Silence | Class::Garbled) };
        let hint = failure.hint.as_deref().map(|hint| self.typed(hint, about));
        let first = failure.context.iter().find(|(key, _)| *key == ONE_OF).map(|(_, first)| self.for_one(first));
        let hint = match (first, hint) {
            (Some(first), Some(hint)) => Some(both!("{first}; {hint}", "{first}; {hint}", first, hint)),
            (first, hint) => first.or(hint),
        };
        Failure { hint: hint.map(Box::new), message: self.typed(&failure.message, about), ..failure }
    }

    /// This run, of one drive.
    fn for_one(&self, address: &str) -> Text {
        let (mut typed, mut named) = (Vec::new(), false);
        let mut words = self.words.iter().filter(|word| *word != "--yes");
        while let Some(text) = words.next() {
            let is_behind = ["-a", "--address"].contains(&text.as_str());
            let is_joined = text.starts_with("--address=") || (text.starts_with("-a") && !is_behind);
            if is_behind {
                words.next();
            }
            match is_behind || is_joined {
                true => typed.extend(["-a".to_owned(), address.to_owned()]),
                false => typed.push(word(text)),
            }
            named |= is_behind || is_joined;
        }
        if !named {
            typed.splice(0..0, ["-a".to_owned(), address.to_owned()]);
        }
        let typed = typed.join(" ");
        both!("one at a time, such as `antrieb {typed}`", "einen nach dem anderen, etwa `antrieb {typed}`")
    }

    /// What is wrong with one row.
    fn row(&self, error: &mut ErrorDoc) {
        let address = error.context.get("address").cloned();
        let is_unheard = matches!(error.class, Class::Silence | Class::Garbled);
        let about = About { address: address.as_deref(), is_unheard };
        error.hint = error.hint.as_ref().map(|hint| self.typed(hint, about));
        error.message = self.typed(&error.message, about);
    }

    /// The last words of loads, which name a command.
    fn closed(&self, mut data: Data) -> Data {
        let loads: Vec<&mut Load> = match &mut data {
            Data::Load(load) => vec![load],
            Data::Plant(plant) => plant.drives.iter_mut().map(|drive| &mut drive.load).collect(),
            _ => Vec::new(),
        };
        for load in loads {
            load.closing = load.closing.as_ref().map(|told| self.typed(told, About::default()));
        }
        data
    }

    fn typed(&self, text: &Text, about: About<'_>) -> Text {
        commands(text, |command, verb| self.options(command, verb, about))
    }

    /// Whether it was a bus with a rate of its own, where nobody tries others.
    fn is_bus(&self) -> bool {
        let is = |id: &str, starts: &[&str]| {
            let mut values = self.given.iter().filter(|given| given.id == id).flat_map(|given| &given.values);
            values.any(|value| starts.iter().any(|start| value.starts_with(start)))
        };
        is("protocol", &["sdo", "dp"]) || is("port", &["slcan:", "can:"])
    }

    /// What of this run belongs to a command, and does not stand there.
    fn options(&self, command: &str, verb: &Entry, About { address, is_unheard }: About<'_>) -> Vec<String> {
        let searches = SEARCHING.contains(&verb.name);
        let stands = |given: &Given| {
            command.split(' ').any(|word| given.names.iter().any(|name| word.split('=').next() == Some(name)))
        };
        let belongs = |given: &&Given| {
            verb.takes.offers(given.id)
                && !stands(given)
                && (searches || verb.of_plant || given.id != "port" || given.values.len() == 1)
                && (given.id != "address" || !searches)
                && (searches || given.values.iter().all(|value| !value.eq_ignore_ascii_case("auto")))
        };
        // Nobody was understood at the setting that was typed: a search there would find nobody either.
        let sought = |given: &Given| searches && is_unheard && !self.is_bus() && SOUGHT.contains(&given.id);
        let words = |given: &Given| if sought(given) { given.auto() } else { given.words() };
        let mut options: Vec<String> = self.given.iter().filter(belongs).flat_map(words).collect();
        let is_open = !self.given.iter().any(|given| given.id == "address") && !command.contains(" -a ");
        if let Some(address) =
            address.filter(|_| is_open && !searches && !verb.of_plant && verb.takes.offers("address"))
        {
            options.extend(["-a".to_owned(), address.to_owned()]);
        }
        options
    }
}

/// What a text is about.
#[derive(Clone, Copy, Default)]
struct About<'t> {
    /// A drive that nobody may have typed.
    address: Option<&'t str>,
    /// Nobody was understood.
    is_unheard: bool,
}

/// What of the setting of a line a search finds out itself.
const SOUGHT: &[&str] = &["baud", "parity"];

/// The verbs that look at all of a line: for them no drive is picked.
const SEARCHING: &[&str] = &["scan", "init", "sniff"];

impl Given {
    fn auto(&self) -> Vec<String> {
        self.names.first().cloned().into_iter().chain(["auto".to_owned()]).collect()
    }

    fn words(&self) -> Vec<String> {
        let name = self.names.first().cloned().unwrap_or_default();
        match self.values.as_slice() {
            [] => vec![name],
            values => values.iter().flat_map(|value| [name.clone(), word(value)]).collect(),
        }
    }
}

/// The commands in a text for one drive of a plant: by its name, and where the line is searched, by its port.
pub(super) fn for_drive(text: &Text, name: &str, port: &str) -> Text {
    commands(text, |command, verb| match verb {
        _ if command.contains(" -a ") || command.contains(" -p ") || verb.of_plant => Vec::new(),
        _ if SEARCHING.contains(&verb.name) => vec!["-p".to_owned(), word(port)],
        _ if verb.takes.offers("address") && verb.takes.offers("port") => vec!["-a".to_owned(), word(name)],
        _ => Vec::new(),
    })
}

/// A text with more options in each of its commands.
fn commands(text: &Text, options: impl Fn(&str, &Entry) -> Vec<String>) -> Text {
    let [en, de] = text.both();
    if !en.contains("`antrieb ") && !de.contains("`antrieb ") {
        return text.clone();
    }
    Text::by(|lang: Lang| {
        let told = text.get(lang).split(MARK).enumerate().map(|(nth, part)| match part.strip_prefix("antrieb ") {
            Some(rest) if nth % 2 == 1 && !is_help(rest) => match verb_of(rest) {
                Some(verb) => {
                    let words = options(part, verb).into_iter().chain([rest.to_owned()]);
                    format!("antrieb {}", words.collect::<Vec<_>>().join(" "))
                }
                None => part.to_owned(),
            },
            _ => part.to_owned(),
        });
        told.collect::<Vec<_>>().join(&MARK.to_string())
    })
}

/// A page of help, or how a command is called in general.
fn is_help(rest: &str) -> bool {
    rest.split(' ').any(|word| word == "-h" || word == "--help" || word.starts_with('<'))
}

fn verb_of(rest: &str) -> Option<&'static Entry> {
    rest.split(' ').find_map(|word| VERBS.iter().find(|verb| verb.name == word || verb.alias == Some(word)))
}

/// A word as a shell takes it: between quotation marks where it would be several, or something else.
pub fn word(text: &str) -> String {
    let is_plain = |letter: char| letter.is_alphanumeric() || "_-./:@%+=,\\".contains(letter);
    match !text.is_empty() && text.chars().all(is_plain) {
        true if cfg!(windows) || !text.contains('\\') => text.to_owned(),
        _ if cfg!(windows) => format!("\"{text}\""),
        _ => format!("'{}'", text.replace('\'', "'\\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn again(line: &str) -> Again {
        Again::guessed(&line.split(' ').map(OsString::from).collect::<Vec<_>>())
    }

    fn said(line: &str, hint: &str) -> String {
        let hint = Text::name(hint);
        again(line).typed(&hint, About::default()).get(Lang::De).to_owned()
    }

    #[test]
    fn a_command_in_a_hint_is_for_this_run() {
        let line = "antrieb --config pumps.toml -p /dev/ttyUSB0 -b 57600 stop -a 3 --timeout=1s";
        for (hint, typed) in [
            (
                "`antrieb statemachine quick-stop`",
                "`antrieb --config pumps.toml -p /dev/ttyUSB0 -b 57600 --timeout 1s -a 3 statemachine quick-stop`",
            ),
            (
                "first; `antrieb scan` finds",
                "first; `antrieb --config pumps.toml -p /dev/ttyUSB0 -b 57600 --timeout 1s scan` finds",
            ),
            ("`antrieb params WORD`", "`antrieb --config pumps.toml params WORD`"),
            ("`antrieb scan -p X --baud auto`", "`antrieb --config pumps.toml --timeout 1s scan -p X --baud auto`"),
            ("`antrieb read -h`, `read` reads", "`antrieb read -h`, `read` reads"),
            ("`antrieb --help`", "`antrieb --help`"),
        ] {
            assert_eq!(said(line, hint), typed);
        }
        assert_eq!(
            said("antrieb -p A -p B plan", "`antrieb read 1`, `antrieb apply`"),
            "`antrieb read 1`, `antrieb -p A -p B apply`"
        );
        assert_eq!(
            said("antrieb --baud auto scan", "`antrieb read 1`, `antrieb init`"),
            "`antrieb read 1`, `antrieb -b auto init`"
        );
    }

    #[test]
    fn an_address_that_nobody_typed_is_that_of_the_failure() {
        let hint = both!("`antrieb statemachine disable`", "`antrieb statemachine disable`");
        let failure = Failure::new(Class::Forbidden, "f", Text::name("")).hint(hint).with("address", 7);
        let hint = again("antrieb -p sim read 1").hinted(failure).hint.unwrap();
        assert_eq!(hint.get(Lang::En), "`antrieb -p sim -a 7 statemachine disable`");
    }

    #[test]
    fn behind_silence_the_setting_that_was_typed_is_sought() {
        let hint = || Text::name("`antrieb scan`, `antrieb read 1`");
        for (class, scan) in [
            (Class::Silence, "-b auto --parity auto --timeout 1s scan"),
            (Class::Refused, "-b 9600 --parity odd --timeout 1s scan"),
        ] {
            let failure = Failure::new(class, "f", Text::name("")).hint(hint());
            let told = again("antrieb -b 9600 --parity odd --timeout 1s read 1").hinted(failure).hint.unwrap();
            let read = "`antrieb -b 9600 --parity odd --timeout 1s read 1`";
            assert_eq!(told.get(Lang::En), format!("`antrieb {scan}`, {read}"));
        }
    }

    /// The rate of a bus is not found out.
    #[test]
    fn behind_silence_on_a_bus_its_rate_stays() {
        for port in ["slcan:/dev/ttyACM0", "can:can0"] {
            let failure = Failure::new(Class::Silence, "f", Text::name("")).hint(Text::name("`antrieb scan`"));
            let told = again(&format!("antrieb -p {port} -b 500000 read 1")).hinted(failure).hint.unwrap();
            assert_eq!(told.get(Lang::En), format!("`antrieb -p {port} -b 500000 scan`"));
        }
    }

    #[test]
    fn a_drive_of_a_plant_is_called_by_its_name() {
        let hint = Text::name("`antrieb statemachine disable`; `antrieb scan`; `antrieb apply`");
        let told = for_drive(&hint, "act-1", "/dev/my tty");
        let told = told.get(Lang::En);
        assert_eq!(told, "`antrieb -a act-1 statemachine disable`; `antrieb -p '/dev/my tty' scan`; `antrieb apply`");
    }

    #[test]
    fn what_a_shell_would_part_stands_between_quotation_marks() {
        for (text, typed) in [("a/b.toml", "a/b.toml"), ("mein Ordner/b", "'mein Ordner/b'"), ("x'y", "'x'\\''y'")] {
            assert_eq!(word(text), typed);
        }
    }
}
