//! What holds: every setting of a run, resolved once.

use super::address::Addresses;
use super::bus::{bit_rate, check_bus, check_node, on_bus};
use super::globals::{AUTO, Auto, ColorChoice, Globals, parse_span, usual_baud};
use super::low::{Environment, Low, Origin, Typed, wrong_at_origin};
use super::warned::{catalogue_notes, network_note};
use super::wrong::bad_setting;
use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::profile::{CatalogueFile, Lang};
use crate::protocol::Protocol;
use crate::protocol::dp::NAME as DP;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Framing;
use crate::protocol::modbus::pdu::WordOrder;
use crate::render::Format;
use crate::text::{Text, Wrong, both};
use crate::tick::Span;
use crate::transport::{Port, Rs485, Rs485Mode};
use std::collections::BTreeMap;
use std::path::PathBuf;

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
    /// PROFIBUS-DP is spoken, by the verbs that can; `protocol` says nothing then.
    pub profibus: bool,
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
    pub port_note: Option<Text>,
    /// The same for a catalogue that replaces rows. Told when it is read.
    pub catalogue_notes: Vec<Text>,
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
    /// Nothing is sent.
    pub dry_run: bool,
    /// The safety question is answered.
    pub yes: bool,
    /// What holds on each of several lines, for what goes over them ([`settings_over_lines`](super::settings_over_lines)).
    pub lines: Vec<Settings>,
    /// Whether these are of one of several lines.
    pub is_one_of_lines: bool,
    /// What was typed, for who works on a whole plant.
    pub typed: Typed,
    /// Where each of them comes from that somebody said, by the name that it has in a file.
    pub origins: BTreeMap<&'static str, Origin>,
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

impl Settings {
    /// The same for work that talks to one slave of PROFIBUS as to a drive on any line: it is kept going by somebody else, and nothing can be
    /// set on that line from here.
    pub fn through_slave(&self, port: Option<Port>, drive: &str) -> Settings {
        Settings {
            ports: port.iter().cloned().collect(),
            port,
            protocol: Protocol::Pkw,
            profibus: false,
            drive: Some(drive.to_owned()),
            timeout: None,
            retries: None,
            trace: None,
            verbose: false,
            port_note: None,
            ..self.clone()
        }
    }

    /// The same with nothing left to be found out, at this speed.
    pub fn at_speed(&self, baud: u32) -> Settings {
        Settings { line: LineSetting { baud, ..self.line }, unknown: Unknown::default(), ..self.clone() }
    }

    /// Whether these are such settings.
    pub fn is_through_slave(&self) -> bool {
        self.protocol == Protocol::Pkw
    }

    /// Resolves everything once.
    pub fn resolve(globals: &Globals, environment: &Environment) -> Result<Self, Failure> {
        let mut low = Low::read(globals, environment)?;
        let (addresses, node) = low.addresses()?;
        let ports = ports(&mut low)?;
        let (protocol, is_unknown, profibus) = protocol(&mut low, &ports)?;
        let line = line(&mut low, protocol, &ports)?;
        check_node(node, protocol)?;
        check_bus(&low, &addresses, protocol)?;
        let unknown = Unknown {
            baud: globals.baud == Some(Auto::Auto),
            parity: globals.parity == Some(Auto::Auto),
            protocol: is_unknown,
        };
        let drive = low.said(|drive| drive.drive.clone(), |file| file.drive.clone());
        let drive = low.pick("drive", globals.drive.clone(), drive, Ok::<_, Text>)?.filter(|drive| drive != AUTO);
        let timeout = timeout(&mut low)?;
        let retries = low.said(|_| None, |file| file.retries);
        let retries = low.pick("retries", globals.retries, retries, Ok::<_, Text>)?;
        let format = format(&mut low)?;
        let lang = lang(&mut low, environment)?;
        let rs485 = rs485(&mut low)?;
        let (path, project) = low.project();
        let catalogue_notes = catalogue_notes(project, &environment.directory, path);
        let is_of_project = matches!(low.origin("port"), Origin::File { of_project: true, .. });
        let port_note = ports.first().filter(|_| is_of_project).and_then(|port| network_note(port, path));
        Ok(Settings {
            port_note,
            catalogue_notes,
            port: ports.first().cloned(),
            ports,
            addresses,
            node,
            line,
            rs485,
            protocol,
            profibus,
            unknown,
            drive,
            word_order: globals.word_order.map(WordOrder::from),
            timeout,
            retries,
            format,
            lang,
            catalogues: catalogues(&low, environment)?,
            verbose: globals.verbose > 0,
            quiet: globals.quiet,
            trace: globals.trace.clone(),
            force: globals.force,
            color: globals.color.unwrap_or_default(),
            dry_run: globals.dry_run,
            yes: globals.yes,
            lines: Vec::new(),
            is_one_of_lines: false,
            typed: Typed::new(globals, environment),
            origins: low.into_origins(),
        })
    }

    /// Where a setting comes from, by the name that it has in a file.
    pub fn origin(&self, name: &str) -> Origin {
        self.origins.get(name).cloned().unwrap_or_default()
    }

    /// Whether somebody has typed which drives are meant, by address or by name.
    pub fn names_drives(&self) -> bool {
        self.typed.globals.address.is_some()
    }

    /// The family that was typed: whoever types it knows better than the drive. What a file states is asked.
    pub fn named_drive(&self) -> Option<&str> {
        self.drive.as_deref().filter(|_| self.origin("drive") == Origin::Flag)
    }

    /// Why what a file states does not do, with the place where it stands; `None` of what stands in no file.
    pub fn wrong_in_file(&self, name: &str, why: &Text) -> Option<Failure> {
        wrong_at_origin(&self.typed.environment.directory, &self.origin(name), name, why)
    }

    /// The settings of the line with where each comes from, for `-v`.
    pub fn told(&self) -> Text {
        let auto = || AUTO.to_owned();
        let addresses = match &self.addresses {
            Addresses::Unnamed => None,
            Addresses::Named(list) => Some(list.iter().map(u8::to_string).collect::<Vec<_>>().join(",")),
        };
        let or_auto = |is_unknown: bool, known: String| if is_unknown { auto() } else { known };
        // A bus has no characters.
        let on_line = |told: String| Some(told).filter(|_| !self.line.is_can());
        let rows = [
            ("port", self.port.as_ref().map(Port::to_string)),
            ("address", addresses),
            ("baud", Some(or_auto(self.unknown.baud, self.line.baud.to_string()))),
            ("parity", on_line(or_auto(self.unknown.parity, format!("{:?}", self.line.parity).to_lowercase()))),
            ("data_bits", on_line(self.line.data_bits.to_string())),
            ("stop_bits", on_line(self.line.stop_bits.to_string())),
            ("protocol", Some(or_auto(self.unknown.protocol, self.spoken().to_owned()))),
            ("drive", Some(self.drive.clone().unwrap_or_else(auto))),
            ("timeout", self.timeout.map(|span| span.to_string())),
            ("retries", self.retries.map(|count| count.to_string())),
            ("lang", Some(self.lang.pick("en", "de").to_owned())),
        ];
        let told = rows.into_iter().filter_map(|(name, value)| {
            let value = value?;
            Some(both!("{name} {value} ({whence})", "{name} {value} ({whence})", whence = self.origin(name).name()))
        });
        let told: Vec<Text> = told.collect();
        both!("settings: {told}", "Einstellungen: {told}", told = Text::join(&told, ", "))
    }

    /// The word that names what is spoken.
    fn spoken(&self) -> &'static str {
        if self.profibus { DP } else { self.protocol.name() }
    }

    /// Whether the line is a CAN bus.
    pub fn is_can(&self) -> bool {
        self.line.is_can() && !self.profibus
    }

    /// Whether the form of the output is one document or table of data, so that nothing can be told on the way.
    pub fn tells_at_the_end(&self) -> bool {
        matches!(self.format, Format::Json | Format::Csv)
    }

    /// Whether the output is a record for each thing that happens, for programs.
    pub fn is_for_each(&self) -> bool {
        self.format == Format::Ndjson
    }

    /// Whether the output is one JSON document.
    pub fn is_json(&self) -> bool {
        self.format == Format::Json
    }

    /// Refuses what only a search can do: several ports at once, and settings that are to be found out.
    pub fn check_one_line(&self) -> Result<(), Failure> {
        if self.ports.len() > 1 {
            let ports: Vec<String> = self.ports.iter().map(ToString::to_string).collect();
            let (count, ports) = (ports.len(), ports.join(", "));
            return Err(bad_setting(
                "port",
                both!(
                    "expected one port, got {count}: {ports}",
                    "erwartet: ein Anschluss; angegeben: {count}: {ports}"
                ),
            )
            .hint(both!(
                "this verb works on one; `scan`, `init`, `plan`, `apply` and `check` go over several",
                "dieser Befehl arbeitet an einem; `scan`, `init`, `plan`, `apply` und `check` gehen über mehrere"
            )));
        }
        if self.unknown != Unknown::default() {
            return Err(bad_setting(
                "auto",
                both!(
                    "auto is for `scan`; expected the settings of the line",
                    "auto ist für `scan`; erwartet: die Einstellungen der Leitung"
                ),
            )
            .hint(both!(
                "`antrieb scan` with auto finds them, and says what to give here",
                "`antrieb scan` mit auto findet sie und sagt, was hier anzugeben ist"
            )));
        }
        Ok(())
    }
}

/// The directory of the user's configuration, by the custom of the system: `~/.config/antrieb`.
pub fn user_config_directory() -> Option<PathBuf> {
    use etcetera::BaseStrategy;
    etcetera::choose_base_strategy().ok().map(|strategy| strategy.config_dir().join("antrieb"))
}

/// How long a reply is waited for.
fn timeout(low: &mut Low<'_>) -> Result<Option<Span>, Failure> {
    let said = low.said(|_| None, |file| file.timeout.clone());
    let timeout = low.pick("timeout", low.flags.timeout, said, |text| parse_span(&text))?;
    if timeout.is_some_and(|timeout| timeout < Span::from_millis(1)) {
        return Err(bad_setting(
            "timeout",
            both!(
                "expected at least 1ms; drives answer not before 10 ms",
                "erwartet: mindestens 1ms; Antriebe antworten nicht vor 10 ms"
            ),
        ));
    }
    Ok(timeout)
}

/// What is printed.
fn format(low: &mut Low<'_>) -> Result<Format, Failure> {
    let typed = low.flags.format.or(low.flags.json.then_some(Format::Json));
    let said = low.said(|_| None, |file| file.format.clone());
    Ok(low.pick("format", typed, said, |text| text.parse())?.unwrap_or(Format::Table))
}

/// Every port that was named.
fn ports(low: &mut Low<'_>) -> Result<Vec<Port>, Failure> {
    let typed = Some(low.flags.port.clone()).filter(|ports| !ports.is_empty());
    let said = low.variable("ANTRIEB_PORT").or_else(|| low.said(|drive| drive.port.clone(), |file| file.port.clone()));
    let ports = low.pick("port", typed, said, |text| text.parse().map(|port| vec![port]))?;
    Ok(ports.unwrap_or_default())
}

/// What is spoken, and whether that is only a guess; and whether it is PROFIBUS-DP.
fn protocol(low: &mut Low<'_>, ports: &[Port]) -> Result<(Protocol, bool, bool), Failure> {
    let said = low.said(|drive| drive.protocol.clone(), |file| file.protocol.clone());
    let text = low.pick("protocol", low.flags.protocol.clone(), said, Ok::<_, Text>)?;
    let text = text.as_deref();
    if text.is_some_and(|text| text.trim().eq_ignore_ascii_case(DP)) {
        return Ok((Protocol::Modbus(Framing::Rtu), false, true));
    }
    let named = text
        .filter(|&text| text != AUTO)
        .map(|text| text.parse().map_err(|why: Wrong| protocol_failure(low, text, why.0)));
    let protocol = named.transpose()?.unwrap_or(Protocol::Modbus(Framing::Rtu));
    Ok((fitting(protocol, text.is_some(), ports)?, text == Some(AUTO), false))
}

/// Speed and format.
fn line(low: &mut Low<'_>, protocol: Protocol, ports: &[Port]) -> Result<LineSetting, Failure> {
    let said = low.said(|drive| drive.parity.clone(), |file| file.parity.clone());
    let parity = low.flags.parity.and_then(Auto::known);
    let parity = low.pick("parity", parity, said, |text| text.parse())?.unwrap_or(Parity::Even);
    let said = low.said(|drive| drive.baud, |file| file.baud);
    let baud = low.pick("baud", low.flags.baud.and_then(Auto::known), said, usual_baud)?;
    if let Protocol::Sdo(_) = protocol {
        return bit_rate(baud, ports).map(LineSetting::can);
    }
    let mut line = protocol.line(baud.unwrap_or(19_200), parity); // CM-485 manual 5: factory setting
    let said = low.said(|drive| drive.data_bits, |file| file.data_bits);
    let data_bits = low.pick("data_bits", low.flags.data_bits, said, |bits| one_of(7..=8, bits))?;
    let said = low.said(|drive| drive.stop_bits, |file| file.stop_bits);
    let stop_bits = low.pick("stop_bits", low.flags.stop_bits, said, |bits| one_of(1..=2, bits))?;
    line.data_bits = data_bits.unwrap_or(line.data_bits);
    line.stop_bits = stop_bits.unwrap_or(line.stop_bits);
    if protocol == Framing::Rtu.into() && line.data_bits != 8 {
        return Err(bad_setting("data_bits", both!("RTU needs 8 data bits", "RTU braucht 8 Datenbits"))
            .hint(both!("7 data bits are for --protocol ascii", "7 Datenbits sind für --protocol ascii")));
    }
    Ok(line)
}

fn one_of(range: std::ops::RangeInclusive<u8>, value: u8) -> Result<u8, Text> {
    let (first, last) = (range.start(), range.end());
    let expected =
        || both!("expected {first} or {last}, got {value}", "erwartet: {first} oder {last}; angegeben: {value}");
    if range.contains(&value) { Ok(value) } else { Err(expected()) }
}

fn lang(low: &mut Low<'_>, environment: &Environment) -> Result<Lang, Failure> {
    let said = low.said(|_| None, |file| file.lang.clone());
    let lang = low.pick("lang", low.flags.lang, said, |text| text.parse())?;
    Ok(language(lang, environment))
}

/// The language that was typed, else that of the system: the first of LC_ALL, LC_MESSAGES and LANG that is set decides
/// (POSIX).
pub fn language(typed: Option<Lang>, environment: &Environment) -> Lang {
    let variables = ["LC_ALL", "LC_MESSAGES", "LANG"].iter();
    let set = variables.filter_map(|name| environment.variables.get(*name)).find(|value| !value.is_empty());
    typed.unwrap_or_else(|| set.map_or(Lang::En, |locale| Lang::of_locale(locale)))
}

/// A gateway speaks Modbus/TCP and nothing else; nobody speaks it on a serial line.
fn fitting(protocol: Protocol, named: bool, ports: &[Port]) -> Result<Protocol, Failure> {
    let tcp = Protocol::Modbus(Framing::Tcp);
    if let Some(spoken) = on_bus(protocol, named, ports)? {
        return Ok(spoken);
    }
    let has_gateway = ports.iter().any(|port| matches!(port, Port::Mbtcp(_)));
    let has_line = ports.iter().any(|port| matches!(port, Port::Serial(_) | Port::Rfc2217(_) | Port::Sim(_)));
    match (protocol == tcp, named) {
        (false, true) if has_gateway => Err(bad_setting(
            "protocol",
            both!(
                "a gateway (mbtcp://) speaks {tcp}, got {protocol}",
                "ein Gateway (mbtcp://) spricht {tcp}; angegeben: {protocol}"
            ),
        )
        .hint(both!(
            "a device server that passes bytes on as they are is tcp://HOST:PORT",
            "ein Geräteserver, der Bytes unverändert weitergibt, ist tcp://RECHNER:PORT"
        ))),
        (true, _) if has_line => Err(bad_setting(
            "protocol",
            both!("{tcp} is not spoken on a serial line", "{tcp} wird auf einer seriellen Leitung nicht gesprochen"),
        )
        .hint(both!("name the gateway with -p mbtcp://HOST", "das Gateway mit -p mbtcp://RECHNER nennen"))),
        (false, false) if has_gateway => Ok(tcp),
        _ => Ok(protocol),
    }
}

/// Who switches the direction of an RS-485 line, and its delays.
fn rs485(low: &mut Low<'_>) -> Result<Rs485, Failure> {
    let said = low.variable("ANTRIEB_RS485").or_else(|| low.said(|_| None, |file| file.rs485.clone()));
    let mode = low.pick("rs485", low.flags.rs485, said, |text| text.parse())?.unwrap_or(Rs485Mode::Auto);
    let said = low.variable("ANTRIEB_RS485_BEFORE").or_else(|| low.said(|_| None, |file| file.rs485_before.clone()));
    let before = low.pick("rs485_before", low.flags.rs485_before, said, |text| parse_span(&text))?;
    let said = low.variable("ANTRIEB_RS485_AFTER").or_else(|| low.said(|_| None, |file| file.rs485_after.clone()));
    let after = low.pick("rs485_after", low.flags.rs485_after, said, |text| parse_span(&text))?;
    let rs485 = Rs485 { mode, before: before.unwrap_or(Span::ZERO), after: after.unwrap_or(Span::ZERO) };
    if rs485.before.max(rs485.after) > LONGEST_RS485_DELAY {
        return Err(bad_setting(
            "rs485_before, rs485_after",
            both!("expected at most 100ms", "erwartet: höchstens 100ms"),
        ));
    }
    Ok(rs485)
}

/// The Linux kernel takes no longer ones (RS485_MAX_RTS_DELAY).
const LONGEST_RS485_DELAY: Span = Span::from_millis(100);

fn protocol_failure(low: &Low<'_>, text: &str, why: Text) -> Failure {
    let in_file = low.wrong_in_file(&low.origin("protocol"), "protocol", &why);
    let failure = in_file.unwrap_or_else(|| bad_setting("protocol", why));
    match text.to_ascii_lowercase().as_str() {
        "profibus" => failure.hint(both!("PROFIBUS-DP is dp here", "PROFIBUS-DP heißt hier dp")),
        _ => failure
            .hint(both!("dp is PROFIBUS-DP; `scan` takes auto too", "dp ist PROFIBUS-DP; `scan` nimmt auch auto")),
    }
}

/// The user's catalogues: configuration directory, then files named in configurations, then `--catalogue`.
fn catalogues(low: &Low<'_>, environment: &Environment) -> Result<Vec<CatalogueFile>, Failure> {
    let mut paths = Vec::new();
    if let Some(directory) = environment.user_config.as_ref().filter(|_| !low.flags.no_config) {
        let entries = std::fs::read_dir(directory.join("catalogues")).into_iter().flatten().flatten();
        paths.extend(entries.map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|e| e == "toml")));
        paths.sort();
    }
    let named = low.user().catalogue.iter().chain(&low.project().1.catalogue).chain(&low.flags.catalogue);
    paths.extend(named.map(|path| environment.directory.join(path)));
    let read = |path: PathBuf| {
        let shown = path.display().to_string();
        let unread = |error: FileError| Failure::new(Class::Data, "data.catalogue", error.of(&path));
        let text = files::read(&path, files::TEXT).map_err(unread)?;
        Ok(CatalogueFile { path: shown, text })
    };
    paths.into_iter().map(read).collect()
}

#[cfg(test)]
mod tests;
