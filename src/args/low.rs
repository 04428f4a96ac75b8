//! What was typed, and where: flags, environment, project file, user configuration, in this order.

use super::address::{Addresses, parse_addresses, parse_node};
use super::globals::Globals;
use super::project::{ALL, File, GROUP, NamedDrive, PROJECT, is_several, read_config, wrong_in};
use super::takes::Takes;
use super::wrong::bad_setting;
use crate::failure::{Class, Failure};
use crate::protocol::can::MASTER_STATION;
use crate::text::{Text, Wrong, both};
use crate::transport::Port;
use std::collections::{BTreeMap, BTreeSet};
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

/// What was typed and where, kept for what asks for more of it later.
#[derive(Clone, Debug, Default)]
pub struct Typed {
    pub(super) globals: Globals,
    pub(super) environment: Environment,
}

impl Typed {
    pub(super) fn new(globals: &Globals, environment: &Environment) -> Self {
        Typed { globals: globals.clone(), environment: environment.clone() }
    }

    /// Whether an address was typed.
    pub fn names_address(&self) -> bool {
        self.globals.address.is_some()
    }

    /// What was asked for and will not happen in a part of a verb that takes these options.
    pub fn unkept(&self, takes: Takes, part: &str) -> Option<Failure> {
        takes.unkept(part, &self.globals)
    }
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

impl<'a> Low<'a> {
    /// Reads the files.
    pub(super) fn read(flags: &'a Globals, environment: &'a Environment) -> Result<Self, Failure> {
        let project = flags.config.clone().unwrap_or_else(|| PathBuf::from(PROJECT));
        let (mut of_project, mut of_user) = (File::default(), File::default());
        let user = environment.user_config.as_ref().map(|directory| directory.join("config.toml"));
        if !flags.no_config {
            of_project = read_config(&environment.directory, &project, flags.config.is_some())?;
            of_user =
                user.as_deref().map(|path| read_config(Path::new(""), path, false)).transpose()?.unwrap_or_default();
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
        let (drive, node) = match text.split_once('.') {
            Some((drive, node)) => (drive, parse_node(drive, node)?),
            None => (text.as_str(), 0),
        };
        self.parsed(drive).map(|list| (Addresses::Named(list), node))
    }

    /// Whether the drive with node 0 was typed, and no drive that has this name.
    pub(super) fn means_master(&self) -> bool {
        self.flags.address.as_deref().is_some_and(|text| text.split(',').any(|part| self.is_master(part)))
    }

    fn is_master(&self, text: &str) -> bool {
        text.trim().eq_ignore_ascii_case(MASTER) && self.drive(text.trim()).is_none()
    }

    /// A list with the station of the master in place of its word.
    fn numbered(&self, text: &str) -> String {
        let number = |part: &str| if self.is_master(part) { MASTER_STATION.to_string() } else { part.to_owned() };
        text.split(',').map(number).collect::<Vec<_>>().join(",")
    }

    /// A list of addresses; of what is none it is said what would be.
    fn parsed(&self, text: &str) -> Result<Vec<u8>, Failure> {
        let is_group = || self.files.iter().any(|(_, file)| file.groups.contains_key(text));
        parse_addresses(&self.numbered(text), &self.names()).map_err(|failure| match is_group() {
            true => failure.hint(both!("the group is `-a {GROUP}{text}`", "die Gruppe ist `-a {GROUP}{text}`")),
            false => failure,
        })
    }

    /// The names of all drives that the files know.
    fn names(&self) -> Vec<&str> {
        self.files.iter().flat_map(|(_, file)| file.drives.keys()).map(String::as_str).collect()
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
        let parts = self.meant(text)?;
        let is_name = |part: &String| self.drive(part).is_some();
        if !parts.iter().any(is_name) {
            return Ok(None);
        }
        let is_typed = !self.typed_ports()?.is_empty();
        let mut list = Vec::new();
        let mut line: Option<(Origin, NamedDrive)> = None;
        for part in &parts {
            let Some(address) = self.call(part) else {
                list.extend(self.parsed(part)?);
                continue;
            };
            list.push(address);
            let Some((origin, mut drive)) = self.named.take() else { continue };
            if is_typed && text.split(',').any(|part| is_several(part.trim())) {
                // What stands at the typed port has it by another name perhaps.
                drive.port = None;
            }
            match &mut line {
                None => line = Some((origin, drive)),
                Some((_, first)) if first.line() != drive.line() => return Err(apart(text, part)),
                Some((_, first)) => first.is_as(&drive),
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

    /// The parts of a list of drives, each once: `all` and `@group` are the drives that the files say, as far as they are at
    /// the ports that were typed.
    fn meant(&self, text: &str) -> Result<Vec<String>, Failure> {
        let ports = self.typed_ports()?;
        let mut parts: Vec<String> = Vec::new();
        for part in text.split(',').map(str::trim) {
            let found = match self.of_word(part)? {
                None => vec![part.to_owned()],
                Some(names) => {
                    let is_there =
                        |name: &String| ports.is_empty() || self.drive(name).is_some_and(|it| it.is_at(&ports));
                    let there: Vec<String> = names.into_iter().filter(is_there).collect();
                    if there.is_empty() {
                        return Err(none_there(part, &ports, self.has_drives()));
                    }
                    there
                }
            };
            parts.extend(found);
        }
        let mut seen = BTreeSet::new();
        parts.retain(|part| seen.insert(part.clone()));
        Ok(parts)
    }

    /// The drives of a word that means several; `None` if it means none of them.
    fn of_word(&self, word: &str) -> Result<Option<Vec<String>>, Failure> {
        if word == ALL {
            let names: BTreeSet<&String> = self.files.iter().flat_map(|(_, file)| file.drives.keys()).collect();
            return Ok(Some(names.into_iter().cloned().collect()));
        }
        let Some(group) = word.strip_prefix(GROUP) else { return Ok(None) };
        let mut groups = self.files.iter().flat_map(|(_, file)| &file.groups);
        let found = groups.find(|(name, _)| *name == group).map(|(_, members)| members.clone());
        found.map(Some).ok_or_else(|| self.no_group(group))
    }

    fn no_group(&self, group: &str) -> Failure {
        let known: Vec<&str> = self.files.iter().flat_map(|(_, file)| file.groups.keys()).map(String::as_str).collect();
        let message = both!(
            "there is no group '{group}' (expected one of `[groups]` in {PROJECT}: {known})",
            "es gibt keine Gruppe '{group}' (erwartet wird eine aus `[groups]` in {PROJECT}: {known})",
            known = if known.is_empty() { "-".to_owned() } else { known.join(", ") }
        );
        bad_setting("address", message)
    }

    /// The ports that were typed, or stand in the environment.
    pub(super) fn typed_ports(&self) -> Result<Vec<Port>, Failure> {
        if !self.flags.port.is_empty() {
            return Ok(self.flags.port.clone());
        }
        let Some((text, origin)) = self.variable("ANTRIEB_PORT") else { return Ok(Vec::new()) };
        let port: Port = text.parse().map_err(|why: Wrong| {
            bad_setting("port", both!("{why} ({whence})", "{why} ({whence})", why = why.0, whence = origin.name()))
        })?;
        Ok(vec![port])
    }

    fn has_drives(&self) -> bool {
        self.files.iter().any(|(_, file)| !file.drives.is_empty())
    }

    /// What the files say of the drive with this name.
    pub(super) fn drive(&self, name: &str) -> Option<&NamedDrive> {
        self.files.iter().find_map(|(_, file)| file.drives.get(name))
    }

    /// The names of the drives of a plant that are meant; all of them if nobody said.
    pub(super) fn plant(&self) -> Result<Vec<String>, Failure> {
        let text = self.flags.address.as_deref().unwrap_or(ALL);
        if !self.has_drives() && self.flags.address.is_none() {
            return Err(nobody_named(&Text::default()));
        }
        let (ports, names) = (self.typed_ports()?, self.meant(text)?);
        if let Some(stranger) = names.iter().find(|name| self.drive(name).is_none()) {
            let known: Vec<&str> =
                self.files.iter().flat_map(|(_, file)| file.drives.keys()).map(String::as_str).collect();
            let message = both!(
                "expected names of drives, @group or all; got '{stranger}' ({PROJECT} has: {known})",
                "erwartet: Namen von Antrieben, @gruppe oder all; angegeben: '{stranger}' ({PROJECT} hat: {known})",
                known = known.join(", ")
            );
            return Err(bad_setting("address", message));
        }
        let is_there = |name: &String| ports.is_empty() || self.drive(name).is_some_and(|drive| drive.is_at(&ports));
        let there: Vec<String> = names.into_iter().filter(is_there).collect();
        if there.is_empty() { Err(none_there(text, &ports, self.has_drives())) } else { Ok(there) }
    }

    /// The names of the drives that are meant, by the lines on which they lie; none where something else is meant, too, or one port was
    /// typed for all.
    pub(super) fn lines(&self) -> Result<Vec<Vec<String>>, Failure> {
        let ports = self.typed_ports()?;
        let Some(text) = self.flags.address.as_deref().filter(|_| ports.len() != 1) else { return Ok(Vec::new()) };
        let mut lines: Vec<(&NamedDrive, Vec<String>)> = Vec::new();
        for name in self.meant(text)? {
            let Some(drive) = self.drive(&name) else { return Ok(Vec::new()) };
            match lines.iter_mut().find(|(first, _)| first.line() == drive.line()) {
                Some((_, names)) => names.push(name),
                None => lines.push((drive, vec![name])),
            }
        }
        Ok(lines.into_iter().map(|(_, names)| names).collect())
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
    /// the place where it stands: that of a file is a mistake in the file (exit 7), with line and column.
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
                    let in_file = self.wrong_in_file(&origin, name, &why);
                    let elsewhere = || both!("{why} ({whence})", "{why} ({whence})", why, whence = origin.name());
                    in_file.unwrap_or_else(|| bad_setting(name, elsewhere()))
                })?;
                (value, origin)
            }
        };
        self.origins.insert(name, origin);
        Ok(Some(value))
    }

    /// What is wrong with a setting of a file, with its place; `None` where it stands in no file.
    pub(super) fn wrong_in_file(&self, origin: &Origin, name: &str, why: &Text) -> Option<Failure> {
        wrong_at_origin(&self.environment.directory, origin, name, why)
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

/// What is wrong with a setting of a file, told with the place where it stands; `None` where it stands in no file.
pub(super) fn wrong_at_origin(directory: &Path, origin: &Origin, name: &str, why: &Text) -> Option<Failure> {
    let Origin::File { path, drive, .. } = origin else { return None };
    let why = both!("`{name}`: {why}", "`{name}`: {why}", why);
    let keys = match drive {
        Some(drive) => vec!["drives", drive.as_str(), name],
        None => vec![name],
    };
    Some(wrong_in(directory, path, &keys, why))
}

fn apart(text: &str, part: &str) -> Failure {
    let message = both!(
        "'{text}': {PROJECT} says that {part} is not on the line of the others",
        "'{text}': laut {PROJECT} ist {part} nicht an der Leitung der anderen"
    );
    bad_setting("address", message).with(APART, part).hint(both!(
        "this works on one line: name its port with -p, or one call for each line; what reads once, `dataset load`, `plan`, `apply` and \
         every stop go over all",
        "das arbeitet an einer Leitung: den Anschluss mit -p nennen, oder ein Aufruf für jede Leitung; was einmal liest, `dataset load`, \
         `plan`, `apply` und jeder Halt gehen über alle"
    ))
}

/// Who is on another line, among the facts of a failure.
const APART: &str = "apart";

/// Whether the drives that were meant lie on several lines, and that is why it failed.
pub fn is_apart(failure: &Failure) -> bool {
    failure.context.iter().any(|(fact, _)| *fact == APART)
}

/// No file names a drive; `typed` is what was said in its place.
fn nobody_named(typed: &Text) -> Failure {
    let message = both!(
        "{typed}no drive has a name; expected a table `[drives.NAME]` in {PROJECT}",
        "{typed}kein Antrieb hat einen Namen; erwartet wird eine Tabelle `[drives.NAME]` in {PROJECT}",
        typed
    );
    let hint = both!("`antrieb init` writes one from a scan", "`antrieb init` schreibt eine aus einem Scan");
    match typed.is_empty() {
        true => Failure::new(Class::Usage, "usage.address", message).hint(hint),
        false => bad_setting("address", message).hint(hint),
    }
}

fn none_there(text: &str, ports: &[Port], has_drives: bool) -> Failure {
    if !has_drives {
        return nobody_named(&Text::name(format!("'{text}': ")));
    }
    let ports = ports.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let message = both!(
        "'{text}': {PROJECT} names no such drive at {ports}",
        "'{text}': {PROJECT} nennt keinen solchen Antrieb an {ports}"
    );
    bad_setting("address", message)
        .hint(both!("-p without a drive of that port leaves nobody", "mit diesem -p bleibt kein Antrieb übrig"))
}

/// The word for the drive that is the master of a CAN bus.
const MASTER: &str = "master";
