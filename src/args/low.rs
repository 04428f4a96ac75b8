//! What was typed, and where: flags, environment, project file, user configuration, in this order.

use super::address::{Addresses, parse_addresses, parse_node};
use super::globals::{AUTO, Globals};
use super::wrong::bad_setting;
use crate::failure::{Class, Failure};
use crate::files;
use crate::profile::place;
use crate::protocol::modbus::LAST_STATION;
use crate::text::{Text, both};
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

/// Where a setting comes from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Origin {
    /// It was typed.
    Flag,
    /// This environment variable.
    Variable(&'static str),
    /// This file.
    File {
        /// Its path as it was given.
        path: PathBuf,
        /// The drive in it that has the name.
        drive: Option<String>,
        /// It came with the directory, and not from the user.
        of_project: bool,
    },
    /// Nobody said it.
    #[default]
    Default,
}

impl Origin {
    /// In words.
    pub fn name(&self) -> Text {
        match self {
            Origin::Flag => both!("command line", "Kommandozeile"),
            Origin::Variable(name) => Text::name(name),
            Origin::File { path, drive: None, .. } => Text::name(path.display()),
            Origin::File { path, drive: Some(drive), .. } => Text::name(format!("{}: drives.{drive}", path.display())),
            Origin::Default => both!("default", "Vorgabe"),
        }
    }
}

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
    #[serde(default, deserialize_with = "named")]
    pub(super) drives: BTreeMap<String, NamedDrive>,
}

/// A drive with a name: `[drives.pump]`.
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
}

/// Everything that was typed.
pub(super) struct Low<'a> {
    pub(super) flags: &'a Globals,
    environment: &'a Environment,
    /// Project file and user configuration, with the paths that they are called by.
    files: [(PathBuf, File); 2],
    /// The drive that was called by its name, or the only one that the project file has.
    named: Option<(Origin, NamedDrive)>,
    /// Where each setting comes from that somebody said.
    origins: BTreeMap<&'static str, Origin>,
}

impl NamedDrive {
    /// What it says of its line.
    fn line(&self) -> (Option<&str>, Option<&str>, Option<u32>, Option<&str>) {
        (self.port.as_deref(), self.protocol.as_deref(), self.baud, self.parity.as_deref())
    }
}

impl<'a> Low<'a> {
    /// Reads the files.
    pub(super) fn read(flags: &'a Globals, environment: &'a Environment) -> Result<Self, Failure> {
        let project = flags.config.clone().unwrap_or_else(|| PathBuf::from(PROJECT));
        let (mut of_project, mut of_user) = (File::default(), File::default());
        let user = environment.user_config.as_ref().map(|directory| directory.join("config.toml"));
        if !flags.no_config {
            of_project = read_config(&environment.directory.join(&project), flags.config.is_some())?;
            of_user = user.as_deref().map(|path| read_config(path, false)).transpose()?.unwrap_or_default();
        }
        let files = [(project, of_project), (user.unwrap_or_default(), of_user)];
        Ok(Low { flags, environment, files, named: None, origins: BTreeMap::new() })
    }

    pub(super) fn project(&self) -> (&Path, &File) {
        (&self.files[0].0, &self.files[0].1)
    }

    pub(super) fn user(&self) -> &File {
        &self.files[1].1
    }

    /// Which drives are meant, and the node behind them. The drive that has a name brings its own settings.
    pub(super) fn addresses(&mut self) -> Result<(Addresses, u8), Failure> {
        let text = self.flags.address.clone();
        let typed = self.pick("address", text, self.said(|_| None, |file| file.address.clone()), Ok::<_, Text>)?;
        let Some(text) = typed else {
            let (_, project) = self.project();
            let mut drives = project.drives.iter();
            let only = drives.next().filter(|_| drives.next().is_none()).map(|(name, _)| name.clone());
            return Ok(match only.and_then(|name| self.call(&name)) {
                Some(address) => (Addresses::Named(vec![address]), 0),
                None => (Addresses::Unnamed, 0),
            });
        };
        if let Some(address) = self.call(&text) {
            return Ok((Addresses::Named(vec![address]), 0));
        }
        if let Some(list) = self.call_several(&text)? {
            return Ok((Addresses::Named(list), 0));
        }
        let names: Vec<&str> = self.files.iter().flat_map(|(_, file)| file.drives.keys()).map(String::as_str).collect();
        let (drive, node) = match text.split_once('.') {
            Some((drive, node)) => (drive, parse_node(drive, node)?),
            None => (text.as_str(), 0),
        };
        parse_addresses(drive, &names).map(|list| (Addresses::Named(list), node))
    }

    /// Takes the drive of this name, if there is one; its address.
    fn call(&mut self, name: &str) -> Option<u8> {
        let mut known = self.files.iter().enumerate();
        let (origin, drive) = known.find_map(|(place, (path, file))| {
            let drive = file.drives.get(name)?.clone();
            Some((Origin::File { path: path.clone(), drive: Some(name.to_owned()), of_project: place == 0 }, drive))
        })?;
        self.origins.insert("address", origin.clone());
        let address = drive.address;
        self.named = Some((origin, drive));
        Some(address)
    }

    /// Takes the drives of a list in which there is a name, and numbers beside them. They share a line, so what the file
    /// says of it must be the same for all; what they are may differ, and is asked then.
    fn call_several(&mut self, text: &str) -> Result<Option<Vec<u8>>, Failure> {
        let parts: Vec<&str> = text.split(',').map(str::trim).collect();
        let is_name = |part: &&str| self.files.iter().any(|(_, file)| file.drives.contains_key(*part));
        if !parts.iter().any(is_name) {
            return Ok(None);
        }
        let mut list = Vec::new();
        let mut line: Option<(Origin, NamedDrive)> = None;
        for part in parts {
            let Some(address) = self.call(part) else {
                list.extend(parse_addresses(part, &[])?);
                continue;
            };
            list.push(address);
            let Some((origin, drive)) = self.named.take() else { continue };
            match &mut line {
                None => line = Some((origin, drive)),
                Some((_, first)) if first.line() != drive.line() => {
                    let message = both!(
                        "'{text}': antrieb.toml says that {part} is not on the line of the others",
                        "'{text}': laut antrieb.toml ist {part} nicht an der Leitung der anderen"
                    );
                    return Err(bad_setting("address", message)
                        .hint(both!("one call for each line", "ein Aufruf für jede Leitung")));
                }
                Some((_, first)) if first.drive != drive.drive => first.drive = Some(AUTO.to_owned()),
                Some(_) => {}
            }
        }
        let mut seen = Vec::new();
        list.retain(|address| {
            !seen.contains(address) && {
                seen.push(*address);
                true
            }
        });
        self.named = line;
        Ok(Some(list))
    }

    /// What an environment variable says, if it is set.
    pub(super) fn variable(&self, name: &'static str) -> Option<(String, Origin)> {
        let text = self.environment.variables.get(name).filter(|text| !text.is_empty())?;
        Some((text.clone(), Origin::Variable(name)))
    }

    /// What the files say: first of the drive that has a name, then in general.
    pub(super) fn said<S>(
        &self,
        drive: impl Fn(&NamedDrive) -> Option<S>,
        file: impl Fn(&File) -> Option<S>,
    ) -> Option<(S, Origin)> {
        let of_drive = self.named.as_ref().and_then(|(origin, named)| Some((drive(named)?, origin.clone())));
        of_drive.or_else(|| {
            self.files.iter().enumerate().find_map(|(place, (path, text))| {
                Some((file(text)?, Origin::File { path: path.clone(), drive: None, of_project: place == 0 }))
            })
        })
    }

    /// A setting by its flag or what is said elsewhere, and notes where it comes from. What does not do is refused with
    /// the place where it stands.
    pub(super) fn pick<T, S, E: Into<Text>>(
        &mut self,
        name: &'static str,
        flag: Option<T>,
        said: Option<(S, Origin)>,
        parse: impl FnOnce(S) -> Result<T, E>,
    ) -> Result<Option<T>, Failure> {
        let (value, origin) = match (flag, said) {
            (Some(value), _) => (value, Origin::Flag),
            (None, None) => return Ok(None),
            (None, Some((said, origin))) => {
                let value = parse(said).map_err(|why| {
                    let why: Text = why.into();
                    bad_setting(name, both!("{why} ({whence})", "{why} ({whence})", why, whence = origin.name()))
                })?;
                (value, origin)
            }
        };
        self.origins.insert(name, origin);
        Ok(Some(value))
    }

    /// Where this setting comes from.
    pub(super) fn origin(&self, name: &str) -> Origin {
        self.origins.get(name).cloned().unwrap_or_default()
    }

    /// Where the settings come from that somebody said.
    pub(super) fn into_origins(self) -> BTreeMap<&'static str, Origin> {
        self.origins
    }
}

/// The project file.
const PROJECT: &str = "antrieb.toml";

fn read_config(path: &Path, must_exist: bool) -> Result<File, Failure> {
    let shown = path.display();
    let text = match files::read(path, files::TEXT) {
        Ok(text) => text,
        Err(error) if error.is_missing() && !must_exist => return Ok(File::default()),
        Err(error) => {
            let text = both!("{shown}: {why}", "{shown}: {why}", why = error.text());
            return Err(Failure::new(Class::Data, "data.config", text));
        }
    };
    toml::from_str(&text).map_err(|error| {
        let (line, column) = place(&text, error.span().map_or(0, |span| span.start));
        let message = error.message().replace(|c: char| c.is_control(), " ");
        let message = Text::quoted(message);
        let text = both!("{shown}:{line}:{column}: {message}", "{shown}:{line}:{column}: {message}", message);
        Failure::new(Class::Data, "data.config", text)
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

/// The drives by name. A name that could be a list of addresses would take the place of one, and start another drive.
fn named<'de, D: Deserializer<'de>>(file: D) -> Result<BTreeMap<String, NamedDrive>, D::Error> {
    let drives = BTreeMap::<String, NamedDrive>::deserialize(file)?;
    match drives.keys().find(|name| !name.contains(char::is_alphabetic)) {
        Some(name) => Err(D::Error::custom(format!(
            "drives.\"{name}\" reads as an address; the name of a drive has a letter in it"
        ))),
        None => Ok(drives),
    }
}

fn no_station(got: &dyn std::fmt::Display) -> String {
    format!("address: expected 1 to {LAST_STATION}, got {got}; 0 is everybody and goes on the command line only")
}
