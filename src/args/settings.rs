//! The settings of a run: flag before environment before project file before user configuration before default.

use super::globals::{AUTO, Auto, BAUD_RATES, ColorChoice, Globals, parse_span};
use crate::failure::{Class, Failure};
use crate::files;
use crate::profile::{CatalogueFile, Lang};
use crate::protocol::Protocol;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::pdu::WordOrder;
use crate::protocol::modbus::{Framing, LAST_STATION};
use crate::render::Format;
use crate::tick::Span;
use crate::transport::{Port, Rs485, Rs485Mode};
use serde::de::Error as _;
use serde::{Deserialize, Deserializer};
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
    /// Where the drives are; `None` if nobody said. The first of [`Settings::ports`].
    pub port: Option<Port>,
    /// Every port that was named.
    pub ports: Vec<Port>,
    /// Which drives.
    pub addresses: Addresses,
    /// System-bus node behind the drive; 0 is the drive itself. Not 0 only with VABus.
    pub node: u8,
    /// Speed and format.
    pub line: LineSetting,
    /// Who switches the direction of an RS-485 line.
    pub rs485: Rs485,
    /// What is spoken.
    pub protocol: Protocol,
    /// What of this is only a guess, because it is to be found out.
    pub unknown: Unknown,
    /// Family, or `None` to ask the drive.
    pub drive: Option<String>,
    /// Which half of a value in two registers goes first; `None` to ask the drive.
    pub word_order: Option<WordOrder>,
    /// How long to wait for a reply; `None` for the manual's time.
    pub timeout: Option<Span>,
    /// How often to repeat a question; `None` for the usual number.
    pub retries: Option<u8>,
    /// Output format.
    pub format: Format,
    /// Language.
    pub lang: Lang,
    /// What a project file decides that one may not expect: a port on the network. Told when the port is opened.
    pub port_note: Option<String>,
    /// The same for a catalogue that replaces rows. Told when it is read.
    pub catalogue_notes: Vec<String>,
    /// The user's catalogues, in the order in which they are read.
    pub catalogues: Vec<CatalogueFile>,
    /// Telegrams are shown.
    pub verbose: bool,
    /// Less on stderr.
    pub quiet: bool,
    /// Where to record the line.
    pub trace: Option<PathBuf>,
    /// Replace a recording that exists, and whatever else a verb does not do unasked.
    pub force: bool,
    /// Colour may be used on a terminal.
    pub color: ColorChoice,
    /// A progress bar may be shown on a terminal.
    pub progress: bool,
    /// Nothing is sent.
    pub dry_run: bool,
    /// The safety question is answered.
    pub yes: bool,
}

/// What is to be found out of a line (`auto`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Unknown {
    /// Its speed.
    pub baud: bool,
    /// Its parity.
    pub parity: bool,
    /// What is spoken.
    pub protocol: bool,
}

/// `antrieb.toml` and the user's `config.toml`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    port: Option<String>,
    #[serde(default, deserialize_with = "stations")]
    address: Option<String>,
    baud: Option<u32>,
    parity: Option<String>,
    stop_bits: Option<u8>,
    data_bits: Option<u8>,
    rs485: Option<String>,
    rs485_before: Option<String>,
    rs485_after: Option<String>,
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
    #[serde(deserialize_with = "station")]
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
        let shown = globals.config.clone().unwrap_or_else(|| PathBuf::from("antrieb.toml"));
        let must_exist = globals.config.is_some();
        let project = match globals.no_config {
            true => None,
            false => Some(read_config(&environment.directory.join(&shown), must_exist)?),
        };
        let user = match &environment.user_config {
            Some(directory) if !globals.no_config => read_config(&directory.join("config.toml"), false)?,
            _ => File::default(),
        };
        let project = project.unwrap_or_default();
        let (addresses, node, named) = addresses(globals, &project, &user)?;
        let named = named.as_ref();
        let layers = [&project, &user];

        let mut ports = globals.port.clone();
        let variable = environment.variables.get("ANTRIEB_PORT").filter(|text| !text.is_empty());
        let is_of_project = ports.is_empty()
            && variable.is_none()
            && (named.is_some_and(|drive| drive.port.is_some()) || project.port.is_some());
        if ports.is_empty() {
            let text = variable.or(named.and_then(|drive| drive.port.as_ref()));
            let text = text.or(first(layers, |file| file.port.as_ref()));
            let port = text.map(|text| text.parse().map_err(|why: String| bad_setting("port", &why)));
            ports.extend(port.transpose()?);
        }
        let protocol_text = globals.protocol.as_ref().or(named.and_then(|drive| drive.protocol.as_ref()));
        let protocol_text = protocol_text.or(first(layers, |file| file.protocol.as_ref()));
        let protocol_text = protocol_text.map(String::as_str);
        let protocol =
            protocol_text.filter(|&text| text != AUTO).map_or(Ok(Protocol::Modbus(Framing::Rtu)), |text| {
                text.parse().map_err(|why: String| protocol_failure(text, &why))
            })?;
        let protocol = fitting(protocol, protocol_text.is_some(), &ports)?;
        let parity_text = named.and_then(|drive| drive.parity.as_ref()).or(first(layers, |file| file.parity.as_ref()));
        let parity = match (globals.parity.and_then(Auto::known), parity_text) {
            (Some(parity), _) => parity,
            (None, Some(text)) => text.parse().map_err(|why: String| bad_setting("parity", &why))?,
            (None, None) => Parity::Even,
        };
        let baud = globals.baud.and_then(Auto::known).or(named.and_then(|drive| drive.baud));
        let baud = baud.or(first(layers, |file| file.baud));
        let baud = baud.unwrap_or(19_200); // CM-485 manual 5: factory setting
        if !BAUD_RATES.contains(&baud) {
            let expected = format!("expected {} to {}, got {baud}", BAUD_RATES.start(), BAUD_RATES.end());
            return Err(bad_setting("baud", &expected));
        }
        let unknown = Unknown {
            baud: globals.baud == Some(Auto::Auto),
            parity: globals.parity == Some(Auto::Auto),
            protocol: protocol_text == Some(AUTO),
        };
        if node != 0 && protocol != Protocol::Vabus {
            let why = "a node of the system bus is reached only over VABus";
            return Err(bad_setting("address", why).hint("add --protocol vabus, or name the drive alone"));
        }
        let mut line = protocol.line(baud, parity);
        line.data_bits =
            choose("data_bits", 7..=8, globals.data_bits.or(first(layers, |file| file.data_bits)), line.data_bits)?;
        line.stop_bits =
            choose("stop_bits", 1..=2, globals.stop_bits.or(first(layers, |file| file.stop_bits)), line.stop_bits)?;

        if protocol == Framing::Rtu.into() && line.data_bits != 8 {
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
            port_note: ports.first().filter(|_| is_of_project).and_then(|port| network_note(port, &shown, lang)),
            catalogue_notes: catalogue_notes(&project, &environment.directory, &shown, lang),
            port: ports.first().cloned(),
            ports,
            addresses,
            node,
            line,
            rs485: rs485(globals, environment, layers)?,
            protocol,
            unknown,
            drive,
            word_order: globals.word_order.map(WordOrder::from),
            timeout,
            retries: globals.retries.or(first(layers, |file| file.retries)),
            format,
            lang,
            catalogues: catalogues(globals, environment, &project, &user)?,
            verbose: globals.verbose > 0,
            quiet: globals.quiet,
            trace: globals.trace.clone(),
            force: globals.force,
            color: globals.color.unwrap_or_default(),
            progress: !globals.no_progress && !globals.quiet,
            dry_run: globals.dry_run,
            yes: globals.yes,
        })
    }
}

impl Settings {
    /// Whether the form of the output is one document or table of data, so that nothing can be told on the way.
    pub fn tells_at_the_end(&self) -> bool {
        matches!(self.format, Format::Json | Format::Csv)
    }

    /// Refuses what only a search can do: several ports at once, and settings that are to be found out.
    pub fn check_one_line(&self) -> Result<(), Failure> {
        if self.ports.len() > 1 {
            let ports: Vec<String> = self.ports.iter().map(ToString::to_string).collect();
            let several = format!("expected one port, got {}: {}", ports.len(), ports.join(", "));
            return Err(bad_setting("port", &several).hint("only `scan` works on several ports at once"));
        }
        if self.unknown != Unknown::default() {
            let why = "auto is for `scan`; expected the settings of the line";
            return Err(
                bad_setting("auto", why).hint("`antrieb scan` with auto finds them, and says what to give here")
            );
        }
        Ok(())
    }
}

/// The directory of the user's configuration, by the custom of the system: `~/.config/antrieb`.
pub fn user_config_directory() -> Option<PathBuf> {
    use etcetera::BaseStrategy;
    etcetera::choose_base_strategy().ok().map(|strategy| strategy.config_dir().join("antrieb"))
}

/// A gateway speaks Modbus/TCP and nothing else; nobody speaks it on a serial line.
fn fitting(protocol: Protocol, named: bool, ports: &[Port]) -> Result<Protocol, Failure> {
    let tcp = Protocol::Modbus(Framing::Tcp);
    let has_gateway = ports.iter().any(|port| matches!(port, Port::Mbtcp(_)));
    let has_line = ports.iter().any(|port| matches!(port, Port::Serial(_) | Port::Rfc2217(_) | Port::Sim(_)));
    match (protocol == tcp, named) {
        (false, true) if has_gateway => {
            let why = format!("a gateway (mbtcp://) speaks {tcp}, got {protocol}");
            Err(bad_setting("protocol", &why)
                .hint("a device server that passes bytes on as they are is tcp://HOST:PORT"))
        }
        (true, _) if has_line => {
            let why = format!("{tcp} is not spoken on a serial line");
            Err(bad_setting("protocol", &why).hint("name the gateway with -p mbtcp://HOST"))
        }
        (false, false) if has_gateway => Ok(tcp),
        _ => Ok(protocol),
    }
}

/// Who switches the direction of an RS-485 line, and its delays.
fn rs485(globals: &Globals, environment: &Environment, layers: [&File; 2]) -> Result<Rs485, Failure> {
    let text = |variable: &str, pick: fn(&File) -> Option<&String>| {
        let set = environment.variables.get(variable).filter(|text| !text.is_empty());
        set.or(first(layers, pick)).cloned()
    };
    let delay = |name: &str, flag: Option<Span>, text: Option<String>| match (flag, text) {
        (Some(span), _) => Ok(span),
        (None, Some(text)) => parse_span(&text).map_err(|why| bad_setting(name, &why)),
        (None, None) => Ok(Span::ZERO),
    };
    let mode = match (globals.rs485, text("ANTRIEB_RS485", |file| file.rs485.as_ref())) {
        (Some(mode), _) => mode,
        (None, Some(text)) => text.parse().map_err(|why: String| bad_setting("rs485", &why))?,
        (None, None) => Rs485Mode::Auto,
    };
    let before = text("ANTRIEB_RS485_BEFORE", |file| file.rs485_before.as_ref());
    let after = text("ANTRIEB_RS485_AFTER", |file| file.rs485_after.as_ref());
    let rs485 = Rs485 {
        mode,
        before: delay("rs485_before", globals.rs485_before, before)?,
        after: delay("rs485_after", globals.rs485_after, after)?,
    };
    if rs485.before.max(rs485.after) > LONGEST_RS485_DELAY {
        return Err(bad_setting("rs485_before, rs485_after", "expected at most 100ms"));
    }
    Ok(rs485)
}

/// The Linux kernel takes no longer ones (RS485_MAX_RTS_DELAY).
const LONGEST_RS485_DELAY: Span = Span::from_millis(100);

/// A project file comes with a directory that somebody else may have packed: where it reaches into the network is said.
fn network_note(port: &Port, file: &Path, lang: Lang) -> Option<String> {
    let reaches_out = matches!(port, Port::Tcp(_) | Port::Rfc2217(_) | Port::Mbtcp(_));
    let file = file.display();
    reaches_out.then(|| match lang {
        Lang::En => format!("{file} sets the port: {port} (another one with -p; --no-config leaves the file out)"),
        Lang::De => format!("{file} bestimmt den Anschluss: {port} (anderer mit -p; --no-config lässt die Datei weg)"),
    })
}

/// What a parameter means decides what is written to a drive: where a project file puts other rows in place of ours is
/// said.
fn catalogue_notes(project: &File, directory: &Path, file: &Path, lang: Lang) -> Vec<String> {
    let replaces = |path: &&PathBuf| {
        let text = std::fs::read_to_string(directory.join(path)).unwrap_or_default();
        toml::from_str::<toml::Value>(&text).is_ok_and(|value| replaces_rows(&value))
    };
    let file = file.display();
    let note = |path: &PathBuf| match lang {
        Lang::En => format!("{file}: the catalogue {} replaces rows of the built-in one", path.display()),
        Lang::De => format!("{file}: der Katalog {} ersetzt Zeilen des eingebauten", path.display()),
    };
    project.catalogue.iter().filter(replaces).map(note).collect()
}

fn replaces_rows(value: &toml::Value) -> bool {
    match value {
        toml::Value::Table(table) => {
            table.get("replace").and_then(toml::Value::as_bool) == Some(true) || table.values().any(replaces_rows)
        }
        toml::Value::Array(list) => list.iter().any(replaces_rows),
        _ => false,
    }
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
    let later = ["profibus", "sdo"].contains(&text.to_ascii_lowercase().as_str());
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
    let text = match files::read(path, files::TEXT) {
        Ok(text) => text,
        Err(error) if error.is_missing() && !must_exist => return Ok(File::default()),
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

/// The address of a drive in a file. 0 is everybody and only ever typed: what stands in a file for good must not become a
/// broadcast.
fn station<'de, D: Deserializer<'de>>(file: D) -> Result<u8, D::Error> {
    let number = i64::deserialize(file)?;
    let station = u8::try_from(number).ok().filter(|station| (1..=LAST_STATION).contains(station));
    station.ok_or_else(|| D::Error::custom(no_station(&number)))
}

/// The same for a list of addresses; what is no number is a name, which is looked up later.
fn stations<'de, D: Deserializer<'de>>(file: D) -> Result<Option<String>, D::Error> {
    let text = String::deserialize(file)?;
    let numbers = text.split([',', '-', '.']).filter_map(|part| part.trim().parse::<u32>().ok());
    match numbers.into_iter().find(|number| !(1..=LAST_STATION.into()).contains(number)) {
        Some(number) => Err(D::Error::custom(no_station(&number))),
        None => Ok(Some(text)),
    }
}

fn no_station(got: &dyn std::fmt::Display) -> String {
    format!("address: expected 1 to {LAST_STATION}, got {got}; 0 is everybody and goes on the command line only")
}

/// Which drives are meant, and what the project file knows of the one that has a name.
fn addresses(globals: &Globals, project: &File, user: &File) -> Result<(Addresses, u8, Option<NamedDrive>), Failure> {
    let text = globals.address.as_ref().or(first([project, user], |file| file.address.as_ref()));
    let Some(text) = text else {
        let mut drives = project.drives.values();
        return Ok(match (drives.next(), drives.next()) {
            (Some(only), None) => (Addresses::Named(vec![only.address]), 0, Some(only.clone())),
            _ => (Addresses::Unnamed, 0, None),
        });
    };
    if let Some(drive) = first([project, user], |file| file.drives.get(text)) {
        return Ok((Addresses::Named(vec![drive.address]), 0, Some(drive.clone())));
    }
    let names: Vec<&str> = project.drives.keys().chain(user.drives.keys()).map(String::as_str).collect();
    let (drive, node) = match text.split_once('.') {
        Some((drive, node)) => (drive, parse_node(drive, node)?),
        None => (text.as_str(), 0),
    };
    parse_addresses(drive, &names).map(|list| (Addresses::Named(list), node, None))
}

/// Reads the node of `3.17`: drive 3, and node 17 of the system bus behind it (EM-RES-03 manual 5.10.2.2).
fn parse_node(drive: &str, node: &str) -> Result<u8, Failure> {
    let number = node.trim().parse().ok().filter(|node| (1..=LAST_NODE).contains(node));
    let one = drive.trim().parse::<u8>().is_ok();
    number.filter(|_| one).ok_or_else(|| {
        let expected = format!("expected one drive and a node 1 to {LAST_NODE} behind it, such as 3.17");
        bad_setting("address", &format!("{expected}; got '{drive}.{node}'"))
    })
}

/// Highest node of the system bus (EM-RES-03 manual 5.10.2.2).
const LAST_NODE: u8 = 63;

/// Reads `1`, `1,2,5-9`; `names` are those that could stand there too.
pub fn parse_addresses(text: &str, names: &[&str]) -> Result<Vec<u8>, Failure> {
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
        let text = files::read(&path, files::TEXT)
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
        let flags = Globals { baud: Some(Auto::Is(57_600)), address: Some("3".to_owned()), ..Globals::default() };
        let settings = Settings::resolve(&flags, &environment).unwrap();
        assert_eq!(settings.port, Some(Port::Sim(None)));
        assert_eq!(settings.addresses, Addresses::Named(vec![3]));
        assert_eq!(settings.line.to_string(), "57600 8E1");
    }

    #[test]
    fn a_gateway_speaks_modbus_tcp_and_a_serial_line_does_not() {
        let resolve = |port: &str, protocol: Option<&str>| {
            let globals = Globals {
                port: vec![port.parse().unwrap()],
                protocol: protocol.map(str::to_owned),
                ..Globals::default()
            };
            let settings = Settings::resolve(&globals, &Environment::default());
            settings.map(|settings| settings.protocol.name()).map_err(|failure| failure.code)
        };
        assert_eq!(resolve("mbtcp://gateway", None), Ok("mbtcp"));
        assert_eq!(resolve("mbtcp://gateway", Some("mbtcp")), Ok("mbtcp"));
        assert_eq!(resolve("tape:run.trace", Some("mbtcp")), Ok("mbtcp"));
        assert_eq!(resolve("tcp://server:4001", None), Ok("rtu"));
        for (port, protocol) in [("mbtcp://gateway", "rtu"), ("mbtcp://gateway", "auto"), ("/dev/ttyS0", "mbtcp")] {
            assert_eq!(resolve(port, Some(protocol)), Err("usage.protocol".into()), "{port} {protocol}");
        }
    }

    #[test]
    fn who_switches_the_direction_comes_from_flags_environment_and_files() {
        let directory = tempfile::tempdir().unwrap();
        let file = "rs485 = \"kernel\"\nrs485_before = \"1ms\"\nrs485_after = \"2ms\"\n";
        std::fs::write(directory.path().join("antrieb.toml"), file).unwrap();
        let mut environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
        environment.variables.insert("ANTRIEB_RS485".to_owned(), "rts".to_owned());
        let flags = Globals { rs485_after: Some(Span::from_millis(3)), ..Globals::default() };
        let rs485 = Settings::resolve(&flags, &environment).unwrap().rs485;
        let expected = Rs485 { mode: Rs485Mode::Rts, before: Span::from_millis(1), after: Span::from_millis(3) };
        assert_eq!(rs485, expected);

        environment.variables.insert("ANTRIEB_RS485".to_owned(), "automatic".to_owned());
        let failure = Settings::resolve(&flags, &environment).unwrap_err();
        assert!(failure.message.contains("expected auto, kernel, rts or adapter, got 'automatic'"), "{failure}");
        environment.variables.clear();
        let flags = Globals { rs485_before: Some(Span::from_millis(101)), ..Globals::default() };
        assert!(Settings::resolve(&flags, &environment).unwrap_err().message.contains("at most 100ms"));
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
