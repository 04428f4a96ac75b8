//! `antrieb.toml` and the user's `config.toml`: their keys, and what must hold between them. Every mistake is told with line and
//! column.

use super::globals::AUTO;
use crate::failure::{Class, Failure};
use crate::files;
use crate::profile::{in_both, place, stumbled};
use crate::protocol::modbus::LAST_STATION;
use crate::text::{Text, both};
use crate::transport::Port;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use toml::de::{DeTable, DeValue};

/// The project file.
pub(super) const PROJECT: &str = "antrieb.toml";
/// Every drive that has a name: `-a all`.
pub(super) const ALL: &str = "all";
/// What stands before the name of a group: `-a @pumps`.
pub(super) const GROUP: char = '@';

/// `antrieb.toml` and the user's `config.toml`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    pub(super) port: Option<String>,
    #[serde(default, deserialize_with = "stations")]
    pub(super) address: Option<String>,
    pub(super) baud: Option<u32>,
    pub(super) parity: Option<String>,
    pub(super) stop_bits: Option<u8>,
    pub(super) data_bits: Option<u8>,
    pub(super) rs485: Option<String>,
    pub(super) rs485_before: Option<String>,
    pub(super) rs485_after: Option<String>,
    pub(super) protocol: Option<String>,
    pub(super) drive: Option<String>,
    pub(super) timeout: Option<String>,
    pub(super) retries: Option<u8>,
    pub(super) lang: Option<String>,
    pub(super) format: Option<String>,
    #[serde(default)]
    pub(super) catalogue: Vec<PathBuf>,
    #[serde(default)]
    ports: BTreeMap<String, NamedPort>,
    #[serde(default)]
    pub(super) drives: BTreeMap<String, NamedDrive>,
    #[serde(default)]
    pub(super) groups: BTreeMap<String, Vec<String>>,
    #[serde(default)]
    pub(super) triggers: BTreeMap<String, Template>,
    pub(super) report: Option<Letterhead>,
}

/// What stands at the head of a report: `[report]`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Letterhead {
    /// For whom it is.
    pub customer: Option<String>,
    /// What it is about.
    pub plant: Option<String>,
    /// A picture; in the file a path from where the file stands.
    pub logo: Option<PathBuf>,
}

/// A trigger with a name, for `monitor`: `[triggers.trip]`.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Template {
    /// The trigger, as it is typed.
    pub when: String,
    /// How long before it is recorded.
    pub pre: Option<String>,
    /// How long behind it is recorded.
    pub post: Option<String>,
    /// Whether the first one ends the watch.
    #[serde(default)]
    pub once: bool,
    /// The parameters that are watched.
    #[serde(default)]
    pub watch: Vec<String>,
}

/// A port with a name: `[ports.left]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct NamedPort {
    path: String,
    protocol: Option<String>,
    baud: Option<u32>,
    parity: Option<String>,
    stop_bits: Option<u8>,
    data_bits: Option<u8>,
}

/// A drive with a name: `[drives.pump]`. What it does not say of its line, its port says, once the file is settled.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct NamedDrive {
    #[serde(deserialize_with = "station")]
    pub(super) address: u8,
    pub(super) port: Option<String>,
    pub(super) drive: Option<String>,
    pub(super) protocol: Option<String>,
    pub(super) baud: Option<u32>,
    pub(super) parity: Option<String>,
    pub(super) stop_bits: Option<u8>,
    pub(super) data_bits: Option<u8>,
    /// What the drive calls itself, where it does (code 43).
    pub(super) product: Option<String>,
    /// The parameter files that it shall have, later ones over earlier ones.
    #[serde(default)]
    pub(super) files: Vec<PathBuf>,
}

/// Where something stands in the file: its keys, from the outermost.
type Keys<'k> = &'k [&'k str];

impl NamedDrive {
    /// What it says of its line; two names of one port are one.
    pub(super) fn line(&self) -> impl PartialEq + use<> {
        let port = self.port.as_deref().map(device);
        let NamedDrive { protocol, baud, parity, stop_bits, data_bits, .. } = self;
        (port, protocol.clone(), *baud, parity.clone(), *stop_bits, *data_bits)
    }

    /// Whether it can be reached at one of these ports: it is at none other.
    pub(super) fn is_at(&self, ports: &[Port]) -> bool {
        let at = |own: &String| ports.iter().any(|port| device(&port.to_string()) == device(own));
        self.port.as_ref().is_none_or(at)
    }

    /// What is true of several drives, so far as this one says the same.
    pub(super) fn is_as(&mut self, other: &NamedDrive) {
        if self.drive != other.drive {
            self.drive = Some(AUTO.to_owned());
        }
    }

    fn takes(&mut self, port: &NamedPort) {
        self.port = Some(port.path.clone());
        self.protocol = self.protocol.take().or_else(|| port.protocol.clone());
        self.parity = self.parity.take().or_else(|| port.parity.clone());
        self.baud = self.baud.or(port.baud);
        self.stop_bits = self.stop_bits.or(port.stop_bits);
        self.data_bits = self.data_bits.or(port.data_bits);
    }
}

/// A port by whatever name: two paths that lead to one device are one, also where one of them names no folder.
pub(super) fn device(port: &str) -> String {
    let is_path = matches!(port.parse(), Ok(Port::Serial(_)));
    let real = is_path.then(|| std::fs::canonicalize(port).ok()).flatten();
    real.map_or_else(|| port.to_owned(), |real| real.display().to_string())
}

/// A port as it is called from outside of a folder, in which it is called so: what is a path, and no name of a device, begins there.
/// `folder` is how the folder is called, `stands` where it stands.
pub(super) fn from_outside(port: &str, folder: &Path, stands: &Path) -> String {
    let is_path = |name: &str| Path::new(name).components().count() > 1 || files::found(&stands.join(name)).is_some();
    let outside = match port.parse() {
        Ok(Port::Serial(name)) if is_path(&name) => Port::Serial(folder.join(name).display().to_string()),
        Ok(Port::Slcan(inner)) => return format!("slcan:{}", from_outside(&inner.to_string(), folder, stands)),
        Ok(Port::Sim(Some(file))) => Port::Sim(Some(folder.join(file))),
        Ok(Port::Tape(file)) => Port::Tape(folder.join(file)),
        _ => return port.to_owned(),
    };
    outside.to_string()
}

/// Reads a file, called by this path from a directory; nothing stands in one that is not there, unless it must be.
pub(super) fn read_config(directory: &Path, called: &Path, must_exist: bool) -> Result<File, Failure> {
    let path = &directory.join(called);
    let text = match files::read(path, files::TEXT) {
        Ok(text) => text,
        Err(error) if error.is_missing() && !must_exist => return Ok(File::default()),
        Err(error) => return Err(Failure::new(Class::Data, "data.config", error.of(path))),
    };
    let mut file: File = toml::from_str(&text).map_err(|error| {
        let (at, why) = stumbled(&error);
        let failure = wrong_at(path, &text, at, why);
        if is_bare_head(&text, at) { failure.hint(in_quotes()) } else { failure }
    })?;
    if let (Some(folder), Some(stands)) = (called.parent().filter(|it| !it.as_os_str().is_empty()), path.parent()) {
        file.call_ports(|port| from_outside(port, folder, stands));
    }
    match file.settle() {
        Ok(()) => Ok(file),
        Err((keys, why)) => Err(wrong_at(path, &text, offset(&text, &keys), why)),
    }
}

/// The failure of a file, called by this path from a directory, in which something stands that does not do, behind these keys.
pub(super) fn wrong_in(directory: &Path, path: &Path, keys: Keys<'_>, why: Text) -> Failure {
    let text = files::read(&directory.join(path), files::TEXT).unwrap_or_default();
    let keys: Vec<String> = keys.iter().map(|key| (*key).to_owned()).collect();
    wrong_at(path, &text, offset(&text, &keys), why)
}

fn wrong_at(path: &Path, text: &str, offset: usize, why: Text) -> Failure {
    let (shown, (line, column)) = (path.display(), place(text, offset));
    let text = both!("{shown}:{line}:{column}: {why}", "{shown}:{line}:{column}: {why}", why);
    Failure::new(Class::Data, "data.config", text)
}

/// Whether it is the head of a table with a name that is no word of TOML: `[drives.Pumpe Nord]`.
fn is_bare_head(text: &str, at: usize) -> bool {
    let before = text.get(..at).unwrap_or_default();
    let line = text.get(before.rfind('\n').map_or(0, |end| end + 1)..).unwrap_or_default().lines().next();
    let name = line.and_then(|line| line.trim().strip_prefix('[')).unwrap_or_default().trim_end_matches(']');
    !name.contains('"') && name.contains(|letter: char| letter == ' ' || !letter.is_ascii())
}

fn in_quotes() -> Text {
    both!(
        "a name with blanks or umlauts stands in quotes: `[drives.\"Pump North\"]`",
        "ein Name mit Leerzeichen oder Umlauten steht in Anführungszeichen: `[drives.\"Pumpe Süd\"]`"
    )
}

/// Where a value stands; that of the last key that there is.
fn offset(text: &str, keys: &[String]) -> usize {
    let Ok(root) = DeTable::parse(text) else { return 0 };
    let Some((first, rest)) = keys.split_first() else { return 0 };
    let Some((key, mut value)) = root.get_ref().get_key_value(first.as_str()) else { return 0 };
    let mut at = key.span().start;
    for key in rest {
        let found = match value.get_ref() {
            DeValue::Table(table) => table.get_key_value(key.as_str()).map(|(key, value)| (key.span().start, value)),
            DeValue::Array(list) => {
                key.parse().ok().and_then(|index: usize| list.get(index)).map(|value| (value.span().start, value))
            }
            _ => None,
        };
        let Some((start, inner)) = found else { break };
        (at, value) = (start, inner);
    }
    at
}

/// What is wrong between the keys of a file, and where.
type Fault = (Vec<String>, Text);

fn fault(keys: Keys<'_>, why: Text) -> Fault {
    (keys.iter().map(|key| (*key).to_owned()).collect(), why)
}

impl File {
    /// Calls every port otherwise, but those that are names of `[ports]`.
    fn call_ports(&mut self, otherwise: impl Fn(&str) -> String) {
        let of_drives = self.drives.values_mut().filter_map(|drive| drive.port.as_mut());
        let typed = of_drives.chain(&mut self.port).filter(|port| !self.ports.contains_key(*port));
        typed.for_each(|port| *port = otherwise(port));
        self.ports.values_mut().for_each(|port| port.path = otherwise(&port.path));
    }

    /// Puts in each drive what its port says, and looks whether everything fits together.
    fn settle(&mut self) -> Result<(), Fault> {
        // It would take the place of an address, or of a list of them, and start another drive.
        if let Some(name) = self.drives.keys().find(|name| !name.contains(char::is_alphabetic)) {
            let why = both!(
                "`drives.\"{name}\"` reads as an address; the name of a drive has a letter in it",
                "`drives.\"{name}\"` liest sich als Adresse; der Name eines Antriebs hat einen Buchstaben"
            );
            return Err(fault(&["drives", name], why));
        }
        if let Some(name) = self.drives.keys().find(|name| is_several(name)) {
            let why = both!(
                "`all`, `@group` and lists with commas mean several drives; expected another name for this one",
                "`all`, `@gruppe` und Listen mit Kommas meinen mehrere Antriebe; erwartet wird ein anderer Name für diesen"
            );
            return Err(fault(&["drives", name], why));
        }
        for (name, drive) in &mut self.drives {
            let Some(port) = drive.port.clone() else { continue };
            match self.ports.get(&port) {
                Some(named) => drive.takes(named),
                None if self.ports.is_empty() || !is_word(&port) => {}
                None => return Err(no_port(name, &port, self.ports.keys())),
            }
        }
        self.check_groups()?;
        self.check_addresses()
    }

    fn check_groups(&self) -> Result<(), Fault> {
        for (name, members) in &self.groups {
            if members.is_empty() {
                let why = both!(
                    "the group {name} has no drives; expected names of `[drives]`",
                    "die Gruppe {name} hat keine Antriebe; erwartet werden Namen aus `[drives]`"
                );
                return Err(fault(&["groups", name], why));
            }
            for (index, member) in members.iter().enumerate() {
                if !self.drives.contains_key(member) {
                    let known = self.drives.keys().cloned().collect::<Vec<_>>().join(", ");
                    let why = both!(
                        "there is no drive '{member}'; expected one of: {known}",
                        "es gibt keinen Antrieb '{member}'; erwartet wird einer von: {known}"
                    );
                    return Err(fault(&["groups", name, &index.to_string()], why));
                }
            }
        }
        Ok(())
    }

    /// Two drives at one address of one port would be one drive with two sets of files.
    fn check_addresses(&self) -> Result<(), Fault> {
        let mut seen: BTreeMap<(Option<String>, u8), &str> = BTreeMap::new();
        for (name, drive) in &self.drives {
            let port = drive.port.as_ref().or(self.port.as_ref()).map(|port| device(port));
            if let Some(first) = seen.insert((port, drive.address), name) {
                let why = both!(
                    "drives {first} and {name} have the same address {address} on the same port; give each its own",
                    "die Antriebe {first} und {name} haben dieselbe Adresse {address} am selben Anschluss; jeder braucht seine eigene",
                    address = drive.address
                );
                return Err(fault(&["drives", name, "address"], why));
            }
        }
        Ok(())
    }
}

/// Whether a word means drives by what the file says of them, and not one by its name.
pub(super) fn is_several(word: &str) -> bool {
    word == ALL || word.starts_with(GROUP) || word.contains(',')
}

/// Whether it reads like a name, and not like a port of some kind.
fn is_word(port: &str) -> bool {
    let com = port.get(..3).is_some_and(|start| start.eq_ignore_ascii_case("com"));
    matches!(port.parse(), Ok(Port::Serial(_)) | Err(_)) && !port.contains(['/', ':', '\\']) && !com
}

fn no_port<'n>(drive: &str, port: &str, known: impl Iterator<Item = &'n String>) -> Fault {
    let known = known.cloned().collect::<Vec<_>>().join(", ");
    let why = both!(
        "there is no port '{port}'; expected one of `[ports]` ({known}), or a path such as /dev/ttyUSB0",
        "es gibt keinen Anschluss '{port}'; erwartet wird einer aus `[ports]` ({known}) oder ein Pfad wie /dev/ttyUSB0"
    );
    fault(&["drives", drive, "port"], why)
}

/// The address of a drive in a file. 0 is everybody and only ever typed: what stands in a file for good must not become a
/// broadcast.
fn station<'de, D: Deserializer<'de>>(file: D) -> Result<u8, D::Error> {
    let number = i64::deserialize(file)?;
    let station = u8::try_from(number).ok().filter(|station| (1..=LAST_STATION).contains(station));
    station.ok_or_else(|| in_both(&no_station(number)))
}

/// The same for a list of addresses; what is no number is a name, which is looked up later.
fn stations<'de, D: Deserializer<'de>>(file: D) -> Result<Option<String>, D::Error> {
    let text = String::deserialize(file)?;
    let numbers = text.split([',', '-', '.']).filter_map(|part| part.trim().parse::<u32>().ok());
    match numbers.into_iter().find(|number| !(1..=LAST_STATION.into()).contains(number)) {
        Some(number) => Err(in_both(&no_station(number.into()))),
        None => Ok(Some(text)),
    }
}

fn no_station(got: i64) -> Text {
    both!(
        "address: expected 1 to {LAST_STATION}, got {got}; 0 is everybody and goes on the command line only",
        "Adresse: erwartet wird 1 bis {LAST_STATION}, dort steht {got}; 0 sind alle und steht nur auf der Befehlszeile"
    )
}
