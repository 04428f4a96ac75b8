//! What does not fit the tree of arguments, in words of ours: clap knows one language, and says nothing to programs.

use super::placeholder::placed;
use super::typed::whole;
use super::{closed, overview};
use crate::args::below_zero::SIGN;
use crate::args::{Environment, Useless, language};
use crate::command::{Again, meant, stop_meant, word};
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::render::{self, Console, Format, Manner, Stream, View};
use crate::text::{Lang, Text, Wrong, both};
use clap::error::{ContextKind as Told, ContextValue, ErrorKind};
use std::borrow::Cow;
use std::ffi::OsString;
use std::io::Write;

/// Help goes to stdout and is a success; anything else is a usage error, in JSON too if JSON was asked for.
pub(super) fn explain(
    error: &clap::Error,
    arguments: &[OsString],
    environment: &Environment,
    out: &mut dyn Write,
    (err, is_terminal, width): (Box<dyn Write>, bool, Option<u16>),
) -> u8 {
    let words: Vec<_> = arguments.iter().map(|word| word.to_string_lossy()).collect();
    let lang = language(value_of(&words, "--lang").and_then(|lang| lang.parse().ok()), environment);
    let console = Console::new(err, lang, true, false).wrapped(is_terminal, width);
    if !error.use_stderr() {
        let page = error.render().to_string();
        // In the place of a blank line, so that a page still fits its terminal.
        let page = match lang {
            Lang::De if error.kind() == ErrorKind::DisplayHelp => page.replacen("\n\n", &format!("\n{ENGLISH}\n"), 1),
            _ => page,
        };
        let printed = out.write_all(page.as_bytes()).and_then(|()| out.flush());
        return printed.map_or_else(|error| closed(&error, &console), |()| 0);
    }
    let place = Place::of_error(&words, error);
    let failure = Again::guessed(arguments).hinted(as_typed(place.failure(error), &words));
    if words.iter().any(|word| word == "--json") || value_of(&words, "--format") == Some("json") {
        let (outcome, verb, manner) = (Outcome::from(failure.clone()), place.verb(), Manner::of(lang));
        let printed = if verb == "monitor" {
            Stream::open(View::Ndjson, out, manner, &console).and_then(|stream| stream.finish(&outcome, "monitor"))
        } else {
            render::print(&outcome, verb, Format::Json, manner, out, &console)
        };
        if printed.is_err() {
            console.failure(&failure);
        }
    } else if place.path.is_empty() && error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        // `antrieb` alone shows its help.
        overview::of(place.root).render_help().to_string().lines().for_each(|line| console.line(line));
    } else {
        console.failure(&failure);
    }
    Class::Usage.exit()
}

/// What the arrows of the keypad do.
const KEYPAD: &[&str] = &["--step", "--min", "--max"];

/// Help is English (the contract with the user), and says so to who has chosen German.
const ENGLISH: &str = "(Hilfetexte sind englisch; Ausgaben, Fragen und Fehler sind deutsch.)";

/// A value below zero in the sign with which it was typed (`args::below_zero`).
fn as_typed(failure: Failure, words: &[Cow<'_, str>]) -> Failure {
    if words.iter().any(|word| word.contains(SIGN)) {
        return failure;
    }
    let message = Text::by(|lang| failure.message.get(lang).replace(SIGN, "-"));
    Failure { message, ..failure }
}

/// What bytes, words and codes are by their look, where nobody said it.
fn by_look(word: &str) -> Option<&'static str> {
    let is_hex = |text: &str| !text.is_empty() && text.chars().all(|letter| letter.is_ascii_hexdigit());
    let code = word.strip_prefix(['F', 'f']).filter(|code| code.len() == 4);
    match word.strip_prefix("0x").or_else(|| word.strip_prefix("0X")) {
        Some(number) if is_hex(number) => Some("status"),
        _ if code.is_some_and(is_hex) => Some("fault"),
        _ if word.starts_with(':') || is_hex(word) => Some("telegram"),
        _ => None,
    }
}

/// Behind which command something does not fit.
struct Place {
    root: clap::Command,
    /// The names of the verb, and of the verb within it.
    path: Vec<String>,
    /// What was typed.
    words: Vec<String>,
}

impl Place {
    fn of(words: &[Cow<'_, str>]) -> Self {
        let root = whole();
        let (mut path, mut command) = (Vec::new(), &root);
        let words: Vec<String> = words.iter().map(ToString::to_string).collect();
        for pair in words.windows(2).filter(|pair| of_option(&root, pair).is_none()) {
            if let Some(inner) = pair.last().and_then(|word| command.find_subcommand(word)) {
                path.push(inner.get_name().to_owned());
                command = inner;
            }
        }
        Place { path, root, words }
    }

    /// The same for what clap did not take: a word before the verb was taken for one, and nothing stands behind it.
    fn of_error(words: &[Cow<'_, str>], error: &clap::Error) -> Self {
        let mut place = Place::of(words);
        let at = |word: &String| place.words.iter().skip(1).position(|one| one == word);
        if let Some(ContextValue::String(word)) = error.get(Told::InvalidSubcommand)
            && at(word).zip(place.path.first().and_then(at)).is_some_and(|(word, verb)| word < verb)
        {
            place.path.clear();
        }
        place
    }

    /// A verb that an option took as its value, because its own was forgotten: `-a read 411`.
    fn swallowed(&self, kind: ErrorKind) -> Option<Swallowed<'_>> {
        use ErrorKind::{InvalidSubcommand, InvalidValue, MissingSubcommand, ValueValidation};
        let is_open = match kind {
            MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => true,
            InvalidSubcommand | InvalidValue | ValueValidation => self.path.is_empty(),
            _ => false,
        };
        let pairs = self.words.windows(2).enumerate().filter(|_| is_open);
        let is_verb = |pair: &[String]| pair.last().is_some_and(|word| self.root.find_subcommand(word).is_some());
        let (at, arg) =
            pairs.filter(|(_, pair)| is_verb(pair)).find_map(|(at, pair)| Some((at, of_option(&self.root, pair)?)))?;
        let (option, verb) = (self.words.get(at)?, self.words.get(at + 1)?);
        let value = arg.get_value_names().and_then(|names| names.first()).map_or("VALUE", |name| name.as_str());
        let mut words = self.words.clone();
        words.insert(at + 1, value.to_owned());
        let line = words.get(1..)?.join(" ");
        Some(Swallowed { option, verb, what: own_value(arg.get_id().as_str()), line })
    }

    fn verb(&self) -> &str {
        self.path.first().map_or("", String::as_str)
    }

    /// What may stand behind it, as it is typed.
    fn known(&self) -> String {
        let command = self.path.iter().try_fold(&self.root, |command, name| command.find_subcommand(name));
        let inner = command.into_iter().flat_map(clap::Command::get_subcommands).filter(|inner| !inner.is_hide_set());
        let names = inner.map(clap::Command::get_name).filter(|name| *name != "help");
        names.collect::<Vec<_>>().join(", ")
    }

    fn failure(&self, error: &clap::Error) -> Failure {
        if let Some(useless) = std::error::Error::source(error).and_then(|why| why.downcast_ref::<Useless>()) {
            return useless.clone().into();
        }
        if let Some(Swallowed { option, verb, what, line }) = self.swallowed(error.kind()) {
            let message = both!(
                "{option} takes '{verb}' as its value: {what} is missing",
                "{option} nimmt '{verb}' als seinen Wert: es fehlt {what}",
                option,
                verb,
                what
            );
            return Failure::new(Class::Usage, "usage.arguments", message)
                .hint(both!("it is `antrieb {line}`", "es heißt `antrieb {line}`"));
        }
        Failure::new(Class::Usage, "usage.arguments", placed(&self.message(error))).hint(placed(&self.hint(error)))
    }

    /// Behind which command, for a sentence; nothing before a verb.
    fn behind(&self) -> Text {
        let path = self.path.join(" ");
        if path.is_empty() { Text::default() } else { both!(" behind `{path}`", " hinter `{path}`") }
    }

    /// What was expected, and what came.
    fn message(&self, error: &clap::Error) -> Text {
        let told = |kind: Told| error.get(kind).map(ToString::to_string).filter(|text| !text.is_empty());
        let what = told(Told::InvalidArg).unwrap_or_default();
        let what =
            if error.kind() == ErrorKind::MissingRequiredArgument { &*what } else { what.trim_end_matches("...") };
        let valid = told(Told::ValidValue)
            .map_or_else(Text::default, |valid| both!(" (expected: {valid})", " (erwartet: {valid})"));
        let (behind, known) = (self.behind(), self.known());
        match (error.kind(), told(Told::InvalidValue)) {
            (ErrorKind::InvalidValue, Some(value)) => {
                both!(
                    "'{value}' does not fit '{what}'{valid}",
                    "'{value}' passt nicht für '{what}'{valid}",
                    value,
                    what,
                    valid
                )
            }
            (ErrorKind::InvalidValue, None) => {
                both!("a value for '{what}' is missing{valid}", "für '{what}' fehlt ein Wert{valid}", what, valid)
            }
            (ErrorKind::ValueValidation, value) => both!(
                "'{value}' does not fit '{what}'{why}",
                "'{value}' passt nicht für '{what}'{why}",
                value = value.unwrap_or_default(),
                what,
                why = std::error::Error::source(error).map_or_else(Text::default, unfit_value)
            ),
            (ErrorKind::UnknownArgument, _) if self.is_early(what) => {
                let path = self.path.join(" ");
                both!(
                    "'{what}' stands before `{path}`, whose option it is",
                    "'{what}' steht vor `{path}` und gehört dahinter"
                )
            }
            (ErrorKind::UnknownArgument, _) => match behind.is_empty() {
                true => both!("'{what}' is not expected here", "'{what}' wird hier nicht erwartet"),
                false => {
                    both!("'{what}' is not expected{behind}", "'{what}' wird{behind} nicht erwartet", what, behind)
                }
            },
            (ErrorKind::InvalidSubcommand, _) => self.no_verb(&told(Told::InvalidSubcommand).unwrap_or_default()),
            (ErrorKind::MissingRequiredArgument, _) => {
                both!("missing{behind}: {what}", "es fehlt{behind}: {what}", behind, what)
            }
            (ErrorKind::MissingSubcommand | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand, _) => {
                match behind.is_empty() {
                    true => both!("expected a verb: {known}", "erwartet: ein Befehl: {known}"),
                    false => both!("expected{behind}: {known}", "erwartet{behind}: {known}", behind, known),
                }
            }
            (ErrorKind::ArgumentConflict, _) => conflict(what, &told(Told::PriorArg).unwrap_or_default()),
            (ErrorKind::TooManyValues, Some(value)) => {
                both!("'{value}' is a value too many for '{what}'", "'{value}' ist für '{what}' ein Wert zu viel")
            }
            (ErrorKind::TooManyValues | ErrorKind::TooFewValues | ErrorKind::WrongNumberOfValues, _) => {
                both!("'{what}' has not as many values as expected", "'{what}' hat nicht so viele Werte wie erwartet")
            }
            _ => Text::quoted(
                error.render().to_string().lines().next().unwrap_or_default().trim_start_matches("error: "),
            ),
        }
    }

    fn no_verb(&self, word: &str) -> Text {
        let (behind, known) = (self.behind(), self.known());
        match behind.is_empty() {
            true => both!("there is no verb '{word}'", "den Befehl '{word}' gibt es nicht"),
            false => both!(
                "expected{behind}: {known}; got '{word}'",
                "erwartet{behind}: {known}; angegeben: '{word}'",
                behind,
                known,
                word
            ),
        }
    }

    /// What to do next: what was perhaps meant, how it is called, or who tells that.
    fn hint(&self, error: &clap::Error) -> Text {
        // Whoever types a stop may have a turning shaft: nothing is suggested that is only spelt alike.
        if let Some(how) = self.stop(error) {
            return how;
        }
        let unknown = error.get(Told::InvalidArg).filter(|_| error.kind() == ErrorKind::UnknownArgument);
        let early = unknown.map(ToString::to_string).filter(|option| self.is_early(option));
        if let Some(option) = early {
            let path = self.path.join(" ");
            return both!(
                "options of a verb stand behind it: `antrieb … {path} … {option}`",
                "Optionen eines Befehls stehen hinter ihm: `antrieb … {path} … {option}`"
            );
        }
        if let Some((option, verbs)) = self.of_others(error) {
            if self.path == ["statemachine", "enable"] && KEYPAD.contains(&&*option) {
                return both!(
                    "the arrows change a setpoint, and `statemachine enable` gives none: it lets the drive run at the one that it has; \
                     `antrieb sollwert VALUE --enable --hold --view {option} …` gives one",
                    "die Pfeile ändern einen Sollwert, und `statemachine enable` gibt keinen: der Antrieb läuft mit dem, den er hat; \
                     `antrieb sollwert WERT --enable --hold --view {option} …` gibt einen"
                );
            }
            if let [verb, inner] = &self.path[..]
                && verbs.split(", ").any(|one| one == format!("`{verb}`"))
            {
                return both!(
                    "it stands before `{inner}`: `antrieb … {verb} {option} … {inner}`",
                    "sie steht vor `{inner}`: `antrieb … {verb} {option} … {inner}`"
                );
            }
            return both!("`{option}` is an option of {verbs}", "`{option}` ist eine Option von {verbs}");
        }
        if let Some(line) = self.meant(error) {
            return both!("it is `{line}`", "es heißt `{line}`");
        }
        let near = [Told::SuggestedArg, Told::SuggestedValue, Told::SuggestedSubcommand];
        if let Some(near) = near.into_iter().find_map(|kind| nearest(error.get(kind)?)) {
            return both!("did you mean '{near}'?", "gemeint ist vielleicht '{near}'");
        }
        if let Some(joined) = self.parted(error) {
            return both!(
                "a unit stands behind its number without a blank: {joined}",
                "eine Einheit steht ohne Leerzeichen hinter der Zahl: {joined}"
            );
        }
        if let Some(line) = self.elsewhere(error) {
            return both!("it is `{line}`", "es heißt `{line}`");
        }
        let help = [&["antrieb".to_owned()], &*self.path].concat().join(" ");
        let page = error.render().to_string();
        let usage = page.lines().find_map(|line| line.strip_prefix("Usage: "));
        match (usage, error.kind()) {
            (Some(usage), ErrorKind::MissingRequiredArgument) => both!(
                "it is called as `{usage}`; `{help} -h` shows the rest",
                "der Aufruf ist `{usage}`; `{help} -h` zeigt das Übrige"
            ),
            _ if self.path.is_empty() => {
                both!("`antrieb --help` shows what there is", "`antrieb --help` zeigt, was es gibt")
            }
            _ => both!("`{help} -h` shows what is taken there", "`{help} -h` zeigt, was dort angenommen wird"),
        }
    }

    fn stop(&self, error: &clap::Error) -> Option<Text> {
        let Some(ContextValue::String(word)) = error.get(Told::InvalidSubcommand) else { return None };
        stop_meant(word).filter(|_| matches!(self.verb(), "" | "statemachine"))
    }

    /// An option that stands behind the wrong verb, and the verbs that have it.
    fn of_others(&self, error: &clap::Error) -> Option<(String, String)> {
        let option = error.get(Told::InvalidArg).filter(|_| error.kind() == ErrorKind::UnknownArgument)?.to_string();
        let long = option.strip_prefix("--")?;
        let has = |command: &clap::Command| {
            command
                .get_arguments()
                .any(|arg| arg.get_long() == Some(long) && !arg.is_global_set() && !arg.is_hide_set())
        };
        let verbs = self.root.get_subcommands().filter(|verb| !verb.is_hide_set()).flat_map(|verb| {
            let inner = verb.get_subcommands().filter(|inner| has(inner));
            let inner = inner.map(|inner| format!("`{} {}`", verb.get_name(), inner.get_name()));
            has(verb).then(|| format!("`{}`", verb.get_name())).into_iter().chain(inner).collect::<Vec<_>>()
        });
        let verbs = verbs.collect::<Vec<_>>().join(", ");
        (!verbs.is_empty()).then_some((option, verbs))
    }

    /// Whether it is an option of the verb that was typed, and stands before it.
    fn is_early(&self, option: &str) -> bool {
        let Some(long) = option.strip_prefix("--") else { return false };
        let verb = self.path.iter().try_fold(&self.root, |command, name| command.find_subcommand(name));
        let has = |verb: &clap::Command| verb.get_arguments().any(|arg| arg.get_long() == Some(long));
        !self.path.is_empty() && verb.is_some_and(has)
    }

    /// The command that another word for a verb means, with all that was typed.
    fn meant(&self, error: &clap::Error) -> Option<String> {
        let Some(ContextValue::String(said)) = error.get(Told::InvalidSubcommand) else { return None };
        // Who pastes a command behind what he has typed already names the program twice.
        let is_twice = said == "antrieb" && self.words.iter().skip(1).any(|one| one == said);
        let command = match (is_twice, &*self.path) {
            (true, []) => "",
            (false, []) => meant(said)?,
            // `dataset compare`: another word for a verb within this one.
            (_, [verb]) => meant(said)?.strip_prefix(verb.as_str())?.strip_prefix(' ')?,
            _ => return None,
        };
        let words = self.words.iter().skip(1).filter(|one| *one != said || !command.is_empty());
        let words = words.map(|one| if one == said { command.to_owned() } else { word(one) });
        Some(std::iter::once("antrieb".to_owned()).chain(words).collect::<Vec<_>>().join(" "))
    }

    /// A number and its unit that were typed as two words, in one: `25 Hz`.
    fn parted(&self, error: &clap::Error) -> Option<String> {
        let unit = error.get(Told::InvalidArg).filter(|_| error.kind() == ErrorKind::UnknownArgument)?.to_string();
        let number = self.words.windows(2).find(|pair| pair.last() == Some(&unit))?.first()?;
        let is_number = number.trim_start_matches('-').starts_with(|letter: char| letter.is_ascii_digit());
        (is_number && unit.starts_with(char::is_alphabetic)).then(|| format!("{number}{unit}"))
    }

    /// What is to be decoded, from its first word on, with what it seems to be.
    fn decoded(&self, first: &str) -> Option<String> {
        let what = by_look(first)?;
        let words: Vec<String> = self.words.iter().skip_while(|one| *one != first).map(|one| word(one)).collect();
        Some(format!("{what} {}", words.join(" ")))
    }

    /// The verb under which an unknown one is to be found: `statemachine enable` for `enable`, `decode telegram` for a byte.
    fn elsewhere(&self, error: &clap::Error) -> Option<String> {
        let Some(ContextValue::String(word)) = error.get(Told::InvalidSubcommand) else { return None };
        if self.verb() == "decode" && self.path.len() == 1 {
            return Some(format!("antrieb decode {}", self.decoded(word)?));
        }
        if self.root.find_subcommand(word).is_some() {
            return Some(format!("antrieb {word}"));
        }
        let verb = self.root.get_subcommands().find(|verb| verb.find_subcommand(word).is_some())?;
        Some(format!("antrieb {} {word}", verb.get_name()))
    }
}

/// What an option took that stands in place of its value.
struct Swallowed<'p> {
    option: &'p str,
    verb: &'p str,
    what: Text,
    /// How it is meant.
    line: String,
}

/// The option of every verb whose value the second word is.
fn of_option<'r>(root: &'r clap::Command, pair: &[String]) -> Option<&'r clap::Arg> {
    let option = pair.first()?;
    let is_it = |arg: &&clap::Arg| match option.strip_prefix("--") {
        Some(long) => arg.get_long() == Some(long),
        None => {
            option.strip_prefix('-').is_some_and(|short| arg.get_short().map(String::from).as_deref() == Some(short))
        }
    };
    root.get_arguments().filter(|arg| arg.get_action().takes_values()).find(is_it)
}

/// What an option wants.
fn own_value(option: &str) -> Text {
    match option {
        "address" => both!("the address", "die Adresse"),
        "port" => both!("the port", "der Anschluss"),
        "baud" => both!("the speed", "die Baudrate"),
        "drive" => both!("the family", "die Familie"),
        "protocol" => both!("the protocol", "das Protokoll"),
        "parity" => both!("the parity", "die Parität"),
        "timeout" => both!("the time", "die Zeit"),
        _ => both!("its own", "der eigene"),
    }
}

fn conflict(what: &str, prior: &str) -> Text {
    let prior = prior.trim_end_matches("...");
    match prior == what || prior.is_empty() {
        true => both!("'{what}' is there twice", "'{what}' steht zweimal da"),
        false => both!("'{what}' does not go together with '{prior}'", "'{what}' geht nicht zusammen mit '{prior}'"),
    }
}

/// The nearest of what is suggested, which is the last of several.
fn nearest(value: &ContextValue) -> Option<&str> {
    match value {
        ContextValue::String(name) => Some(name),
        ContextValue::Strings(names) => names.last().map(String::as_str),
        _ => None,
    }
}

/// Why a value does not do: in our words, in those of a number, or as it was said.
fn unfit_value(why: &(dyn std::error::Error + 'static)) -> Text {
    let told = why.to_string();
    match (why.downcast_ref::<Wrong>(), told.split_once(" is not in ")) {
        (Some(ours), _) => both!(": {why}", ": {why}", why = ours.0),
        (None, Some((_, range))) => match range.split_once("..") {
            Some((first, last)) if last == u64::MAX.to_string() || last.is_empty() => {
                both!(": expected a whole number from {first} on", ": erwartet wird eine ganze Zahl ab {first}")
            }
            Some((first, last)) => {
                let last = last.trim_start_matches('=');
                both!(
                    ": expected a whole number, {first} to {last}",
                    ": erwartet wird eine ganze Zahl, {first} bis {last}"
                )
            }
            None => both!(": expected a whole number, {range}", ": erwartet wird eine ganze Zahl, {range}"),
        },
        (None, None) if why.is::<std::net::AddrParseError>() => both!(
            ": expected an address and a port such as 127.0.0.1:5020",
            ": erwartet werden Adresse und Port wie 127.0.0.1:5020"
        ),
        (None, None) if why.is::<std::num::ParseIntError>() => {
            both!(": expected a whole number", ": erwartet wird eine ganze Zahl")
        }
        (None, None) => both!(": {told}", ": {told}", told = Text::quoted(&told)),
    }
}

/// What was typed for an option, in whichever of its two ways: `--lang de`, `--lang=de`.
fn value_of<'w>(words: &'w [Cow<'_, str>], option: &str) -> Option<&'w str> {
    let joined = words.iter().find_map(|word| word.strip_prefix(option)?.strip_prefix('='));
    joined.or_else(|| Some(words.windows(2).find(|pair| pair.first().is_some_and(|w| w == option))?.last()?.as_ref()))
}
