//! The settings of a run: flag before environment before project file before user configuration before default.

use super::globals::{ColorChoice, Globals, parse_span};
use crate::failure::{Class, Failure};
use crate::profile::{CatalogueFile, Lang};
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::{Framing, LAST_STATION};
use crate::render::Format;
use crate::tick::Span;
use crate::transport::Port;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// What the process was started in; read once, by `main`, or made up by a test.
#[derive(Clone, Debug, Default)]
pub struct Environment {
    /// Environment variables.
    pub variables: BTreeMap<String, String>,
    /// Directory of `antrieb.toml`.
    pub directory: PathBuf,
    /// Directory of the user's configuration, with `config.toml` and `catalogues/`.
    pub user_config: Option<PathBuf>,
}

/// Which drives are meant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Addresses {
    /// None was named.
    Unnamed,
    /// These, in this order.
    Named(Vec<u8>),
}

/// Everything that a verb needs to know besides its own arguments.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Where the drives are; `None` if nobody said.
    pub port: Option<Port>,
    /// Which drives.
    pub addresses: Addresses,
    /// Speed and format.
    pub line: LineSetting,
    /// RTU or ASCII.
    pub framing: Framing,
    /// Family, or `None` to ask the drive.
    pub drive: Option<String>,
    /// How long to wait for a reply; `None` for the manual's time.
    pub timeout: Option<Span>,
    /// How often to repeat a question; `None` for the usual number.
    pub retries: Option<u8>,
    /// Output format.
    pub format: Format,
    /// Language.
    pub lang: Lang,
    /// The user's catalogues, in the order in which they are read.
    pub catalogues: Vec<CatalogueFile>,
    /// Telegrams are shown.
    pub verbose: bool,
    /// Less on stderr.
    pub quiet: bool,
    /// Where to record the line.
    pub trace: Option<PathBuf>,
    /// Colour may be used on a terminal.
    pub color: ColorChoice,
    /// A progress bar may be shown on a terminal.
    pub progress: bool,
    /// Nothing is sent.
    pub dry_run: bool,
    /// The safety question is answered.
    pub yes: bool,
}

/// `antrieb.toml` and the user's `config.toml`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    port: Option<String>,
    address: Option<String>,
    baud: Option<u32>,
    parity: Option<String>,
    stop_bits: Option<u8>,
    data_bits: Option<u8>,
    protocol: Option<String>,
    drive: Option<String>,
    timeout: Option<String>,
    retries: Option<u8>,
    lang: Option<String>,
    format: Option<String>,
    #[serde(default)]
    catalogue: Vec<PathBuf>,
    #[serde(default)]
    drives: BTreeMap<String, NamedDrive>,
}

/// A drive with a name: `[drives.pump]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct NamedDrive {
    address: u8,
    port: Option<String>,
    drive: Option<String>,
    protocol: Option<String>,
    baud: Option<u32>,
    parity: Option<String>,
}

impl Settings {
    /// Resolves everything once.
    pub fn resolve(globals: &Globals, environment: &Environment) -> Result<Self, Failure> {
        let project = match (&globals.config, globals.no_config) {
            (_, true) => None,
            (Some(path), _) => Some(read_config(&environment.directory.join(path), true)?),
            (None, _) => Some(read_config(&environment.directory.join("antrieb.toml"), false)?),
        };
        let user = match &environment.user_config {
            Some(directory) if !globals.no_config => read_config(&directory.join("config.toml"), false)?,
            _ => File::default(),
        };
        let project = project.unwrap_or_default();
        let (addresses, named) = addresses(globals, &project, &user)?;
        let named = named.as_ref();
        let layers = [&project, &user];

        let port = match &globals.port {
            Some(port) => Some(port.clone()),
            None => {
                let variable = environment.variables.get("ANTRIEB_PORT").filter(|text| !text.is_empty());
                let text = variable.or(named.and_then(|drive| drive.port.as_ref()));
                text.or(first(layers, |file| file.port.as_ref()))
                    .map(|text| text.parse().map_err(|why: String| bad_setting("port", &why)))
                    .transpose()?
            }
        };
        let framing_text = globals.protocol.as_ref().or(named.and_then(|drive| drive.protocol.as_ref()));
        let framing_text = framing_text.or(first(layers, |file| file.protocol.as_ref()));
        let framing = framing_text
            .map_or(Ok(Framing::Rtu), |text| text.parse().map_err(|why: String| protocol_failure(text, &why)))?;
        let parity_text = named.and_then(|drive| drive.parity.as_ref()).or(first(layers, |file| file.parity.as_ref()));
        let parity = match (globals.parity, parity_text) {
            (Some(parity), _) => parity,
            (None, Some(text)) => text.parse().map_err(|why: String| bad_setting("parity", &why))?,
            (None, None) => Parity::Even,
        };
        let baud = globals.baud.or(named.and_then(|drive| drive.baud)).or(first(layers, |file| file.baud));
        let baud = baud.unwrap_or(19_200); // CM-485 manual 5: factory setting
        if !(300..=1_250_000).contains(&baud) {
            return Err(bad_setting("baud", &format!("expected 300 to 1250000, got {baud}")));
        }
        let mut line = match framing {
            Framing::Rtu => LineSetting::rtu(baud, parity),
            Framing::Ascii => LineSetting::ascii(baud, parity),
        };
        line.data_bits =
            choose("data_bits", 7..=8, globals.data_bits.or(first(layers, |file| file.data_bits)), line.data_bits)?;
        line.stop_bits =
            choose("stop_bits", 1..=2, globals.stop_bits.or(first(layers, |file| file.stop_bits)), line.stop_bits)?;

        if framing == Framing::Rtu && line.data_bits != 8 {
            return Err(bad_setting("data_bits", "RTU needs 8 data bits").hint("7 data bits are for --protocol ascii"));
        }

        let drive = globals.drive.clone().or(named.and_then(|drive| drive.drive.clone()));
        let drive = drive.or(first(layers, |file| file.drive.clone())).filter(|drive| drive != "auto");
        let timeout = match (globals.timeout, first(layers, |file| file.timeout.as_ref())) {
            (Some(timeout), _) => Some(timeout),
            (None, Some(text)) => Some(parse_span(text).map_err(|why| bad_setting("timeout", &why))?),
            (None, None) => None,
        };
        if timeout.is_some_and(|timeout| timeout < Span::from_millis(1)) {
            return Err(bad_setting("timeout", "expected at least 1ms; drives answer not before 10 ms"));
        }
        let format = match (globals.format, first(layers, |file| file.format.as_ref())) {
            _ if globals.json => Format::Json,
            (Some(format), _) => format,
            (None, Some(text)) => text.parse().map_err(|why: String| bad_setting("format", &why))?,
            (None, None) => Format::Table,
        };
        let lang = match (globals.lang, first(layers, |file| file.lang.as_ref())) {
            (Some(lang), _) => lang,
            (None, Some(text)) => text.parse().map_err(|why: String| bad_setting("lang", &why))?,
            (None, None) => locale(environment),
        };
        Ok(Settings {
            port,
            addresses,
            line,
            framing,
            drive,
            timeout,
            retries: globals.retries.or(first(layers, |file| file.retries)),
            format,
            lang,
            catalogues: catalogues(globals, environment, &project, &user)?,
            verbose: globals.verbose > 0,
            quiet: globals.quiet,
            trace: globals.trace.clone(),
            color: globals.color.unwrap_or_default(),
            progress: !globals.no_progress && !globals.quiet,
            dry_run: globals.dry_run,
            yes: globals.yes,
        })
    }
}

/// The directory of the user's configuration, by the custom of the system: `~/.config/antrieb`.
pub fn user_config_directory() -> Option<PathBuf> {
    use etcetera::BaseStrategy;
    etcetera::choose_base_strategy().ok().map(|strategy| strategy.config_dir().join("antrieb"))
}

fn first<'a, T>(layers: [&'a File; 2], pick: impl Fn(&'a File) -> Option<T>) -> Option<T> {
    layers.into_iter().find_map(pick)
}

fn choose(name: &str, range: std::ops::RangeInclusive<u8>, set: Option<u8>, default: u8) -> Result<u8, Failure> {
    match set {
        Some(value) if !range.contains(&value) => {
            Err(bad_setting(name, &format!("expected {} or {}, got {value}", range.start(), range.end())))
        }
        set => Ok(set.unwrap_or(default)),
    }
}

fn bad_setting(name: &str, why: &str) -> Failure {
    Failure::new(Class::Usage, format!("usage.{name}"), format!("{name}: {why}"))
}

fn protocol_failure(text: &str, why: &str) -> Failure {
    let later = ["vabus", "profibus", "sdo", "mbtcp"].contains(&text.to_ascii_lowercase().as_str());
    let failure = bad_setting("protocol", why);
    if later { failure.hint(format!("{text} is not supported by this version")) } else { failure }
}

/// The first of LC_ALL, LC_MESSAGES and LANG that is set decides (POSIX).
fn locale(environment: &Environment) -> Lang {
    let variables = ["LC_ALL", "LC_MESSAGES", "LANG"].iter();
    let set = variables.filter_map(|name| environment.variables.get(*name)).find(|value| !value.is_empty());
    set.map_or(Lang::En, |locale| Lang::of_locale(locale))
}

fn read_config(path: &Path, must_exist: bool) -> Result<File, Failure> {
    let shown = path.display();
    let text = match std::fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound && !must_exist => return Ok(File::default()),
        Err(error) => return Err(Failure::new(Class::Data, "data.config", format!("{shown}: {error}"))),
    };
    toml::from_str(&text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        let before = text.get(..at).unwrap_or("");
        let (line, column) =
            (before.matches('\n').count() + 1, before.chars().rev().take_while(|&c| c != '\n').count() + 1);
        let message = error.message().replace(|c: char| c.is_control(), " ");
        Failure::new(Class::Data, "data.config", format!("{shown}:{line}:{column}: {message}"))
    })
}

/// Which drives are meant, and what the project file knows of the one that has a name.
fn addresses(globals: &Globals, project: &File, user: &File) -> Result<(Addresses, Option<NamedDrive>), Failure> {
    let text = globals.address.as_ref().or(first([project, user], |file| file.address.as_ref()));
    let Some(text) = text else {
        let mut drives = project.drives.values();
        return Ok(match (drives.next(), drives.next()) {
            (Some(only), None) => (Addresses::Named(vec![only.address]), Some(only.clone())),
            _ => (Addresses::Unnamed, None),
        });
    };
    if let Some(drive) = first([project, user], |file| file.drives.get(text)) {
        check_address(drive.address.into(), text)?;
        return Ok((Addresses::Named(vec![drive.address]), Some(drive.clone())));
    }
    let names: Vec<&str> = project.drives.keys().chain(user.drives.keys()).map(String::as_str).collect();
    parse_addresses(text, &names).map(|list| (Addresses::Named(list), None))
}

/// Reads `1`, `1,2,5-9`.
fn parse_addresses(text: &str, names: &[&str]) -> Result<Vec<u8>, Failure> {
    let bad = || {
        let known = if names.is_empty() { String::new() } else { format!(", or one of: {}", names.join(", ")) };
        let expected = format!("expected addresses such as 1 or 1,2,5-9{known}; got '{text}'");
        bad_setting("address", &expected)
    };
    let mut list = Vec::new();
    for part in text.split(',').map(str::trim) {
        let (first, last) = part.split_once('-').unwrap_or((part, part));
        let first: u32 = first.trim().parse().map_err(|_| bad())?;
        let last: u32 = last.trim().parse().map_err(|_| bad())?;
        check_address(first, text)?;
        check_address(last, text)?;
        if first > last {
            return Err(bad());
        }
        for address in first..=last {
            let address = u8::try_from(address).map_err(|_| bad())?;
            if !list.contains(&address) {
                list.push(address);
            }
        }
    }
    Ok(list)
}

fn check_address(address: u32, text: &str) -> Result<(), Failure> {
    if address > LAST_STATION.into() {
        return Err(bad_setting("address", &format!("expected 0 to {LAST_STATION}, got {address} in '{text}'")));
    }
    Ok(())
}

/// The user's catalogues: configuration directory, then files named in configurations, then `--catalogue`.
fn catalogues(
    globals: &Globals,
    environment: &Environment,
    project: &File,
    user: &File,
) -> Result<Vec<CatalogueFile>, Failure> {
    let mut paths = Vec::new();
    if let Some(directory) = environment.user_config.as_ref().filter(|_| !globals.no_config) {
        let entries = std::fs::read_dir(directory.join("catalogues")).into_iter().flatten().flatten();
        paths.extend(entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|e| e == "toml")));
        paths.sort();
    }
    let named = user.catalogue.iter().chain(&project.catalogue).chain(&globals.catalogue);
    paths.extend(named.map(|path| environment.directory.join(path)));
    let read = |path: PathBuf| {
        let shown = path.display().to_string();
        let text = std::fs::read_to_string(&path)
            .map_err(|error| Failure::new(Class::Data, "data.catalogue", format!("{shown}: {error}")))?;
        Ok(CatalogueFile { path: shown, text })
    };
    paths.into_iter().map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(text: &str) -> Result<Vec<u8>, String> {
        parse_addresses(text, &[]).map_err(|failure| failure.message)
    }

    #[test]
    fn address_lists() {
        assert_eq!(parsed("1"), Ok(vec![1]));
        assert_eq!(parsed("1,2, 5-7,2"), Ok(vec![1, 2, 5, 6, 7]));
        for text in ["", "248", "5-2", "a", "1,,2", "-1"] {
            assert!(parsed(text).is_err(), "{text}");
        }
    }

    #[test]
    fn flags_beat_environment_beats_files() {
        let directory = tempfile::tempdir().unwrap();
        std::fs::write(
            directory.path().join("antrieb.toml"),
            "port = \"/dev/ttyS9\"\nbaud = 9600\nlang = \"de\"\n[drives.pump]\naddress = 7\nparity = \"odd\"\n",
        )
        .unwrap();
        let mut environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
        let settings = Settings::resolve(&Globals::default(), &environment).unwrap();
        assert_eq!(settings.port, Some(Port::Serial("/dev/ttyS9".to_owned())));
        assert_eq!(settings.addresses, Addresses::Named(vec![7]));
        assert_eq!(settings.line.to_string(), "9600 8O1");
        assert_eq!(settings.lang, Lang::De);

        environment.variables.insert("ANTRIEB_PORT".to_owned(), "sim".to_owned());
        let flags = Globals { baud: Some(57_600), address: Some("3".to_owned()), ..Globals::default() };
        let settings = Settings::resolve(&flags, &environment).unwrap();
        assert_eq!(settings.port, Some(Port::Sim(None)));
        assert_eq!(settings.addresses, Addresses::Named(vec![3]));
        assert_eq!(settings.line.to_string(), "57600 8E1");
    }

    #[test]
    fn errors_in_files_name_line_and_column() {
        let directory = tempfile::tempdir().unwrap();
        std::fs::write(directory.path().join("antrieb.toml"), "baud = 9600\nspeed = 1\n").unwrap();
        let environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
        let failure = Settings::resolve(&Globals::default(), &environment).unwrap_err();
        assert_eq!(failure.class, Class::Data);
        assert!(failure.message.contains("antrieb.toml:2:1: unknown field `speed`"), "{failure}");
    }
}
