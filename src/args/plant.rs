//! The plant that a project file tells of: its drives with all that holds for each, looked up when a verb asks for it.

use super::address::Addresses;
use super::globals::Globals;
use super::low::{Environment, Low, Typed};
use super::project::{Letterhead, PROJECT, Template, device, from_outside, wrong_in};
use super::settings::Settings;
use crate::failure::Failure;
use crate::files;
use crate::text::both;
use crate::transport::Port;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A drive of a plant, and what it shall have.
#[derive(Clone, Debug)]
pub struct Place {
    /// Its name in the file.
    pub name: String,
    /// Its address, 1 to 247.
    pub address: u8,
    /// What it calls itself, if the file says so.
    pub product: Option<String>,
    /// Its parameter files, later ones over earlier ones; they were there a moment ago.
    pub files: Vec<PathBuf>,
    /// What holds for it: port, line, protocol, family.
    pub settings: Settings,
}

impl Place {
    /// What two drives have in common that are on one line: the same port, by whatever name.
    pub fn line(&self) -> Option<String> {
        self.settings.port.as_ref().map(|port| device(&port.to_string()))
    }
}

/// The project file.
pub fn project_path(settings: &Settings) -> PathBuf {
    let project = settings.typed.globals.config.clone().unwrap_or_else(|| PathBuf::from(PROJECT));
    in_directory(settings, &project)
}

/// A path as it is typed in the directory that the program was started in.
pub fn in_directory(settings: &Settings, path: &Path) -> PathBuf {
    settings.typed.environment.directory.join(path)
}

/// A port as it is typed in that directory, for a file that stands elsewhere.
pub fn port_from_elsewhere(settings: &Settings, port: &str) -> String {
    let directory = &settings.typed.environment.directory;
    from_outside(port, directory, directory)
}

/// What holds for a verb that works on a whole plant: which drives and ports are meant is said by [`places`].
///
/// # Errors
/// A setting does not do.
pub fn settings_of_plant(globals: &Globals, environment: &Environment) -> Result<Settings, Failure> {
    let alone = Globals { address: None, port: Vec::new(), ..globals.clone() };
    let settings = Settings::resolve(&alone, environment)?;
    Ok(Settings { typed: Typed::new(globals, environment), ..settings })
}

/// What holds for a verb that goes over several lines, where the drives that were meant lie on such: for those of each line as if they
/// alone were meant.
///
/// # Errors
/// A setting does not do.
pub fn settings_over_lines(globals: &Globals, environment: &Environment) -> Result<Settings, Failure> {
    let lists = Low::read(globals, environment)?.lines()?;
    if lists.len() < 2 {
        return Settings::resolve(globals, environment);
    }
    let mut alone = environment.clone();
    alone.variables.remove("ANTRIEB_PORT");
    let line = |names: Vec<String>| {
        let globals = Globals { address: Some(names.join(",")), port: Vec::new(), ..globals.clone() };
        Settings::resolve(&globals, &alone).map(|line| Settings { is_one_of_lines: true, ..line })
    };
    let mut lines = lists.into_iter().map(line).collect::<Result<Vec<_>, _>>()?;
    // What is set otherwise on one port goes beside it.
    let port = |line: &Settings| line.port.as_ref().map(|port| device(&port.to_string()));
    let ports: Vec<_> = lines.iter().map(port).collect();
    lines.sort_by_key(|line| ports.iter().position(|one| *one == port(line)));
    let addresses = Addresses::Named(lines.iter().flat_map(|line| line.addresses.named()).copied().collect());
    Ok(Settings { addresses, lines, ..settings_of_plant(globals, environment)? })
}

/// The drives that were meant (`-a`, `-p`; otherwise all of them), by their names.
///
/// # Errors
/// The file names no such drive; what it says of one does not do, or a file that it names is not there; two drives of one
/// port want different lines.
pub fn places(settings: &Settings) -> Result<Vec<Place>, Failure> {
    let Typed { globals, environment } = &settings.typed;
    let low = Low::read(globals, environment)?;
    let mut places: Vec<Place> = Vec::new();
    for name in low.plant()? {
        places.extend(of_drive(settings, &low, &name)?);
    }
    check_lines(&project_path(settings), &places)?;
    Ok(places)
}

/// The drive of this name, if a project file has one.
///
/// # Errors
/// What the file says of it does not do.
pub fn place(settings: &Settings, name: &str) -> Result<Option<Place>, Failure> {
    let Typed { globals, environment } = &settings.typed;
    of_drive(settings, &Low::read(globals, environment)?, name)
}

fn of_drive(settings: &Settings, low: &Low<'_>, name: &str) -> Result<Option<Place>, Failure> {
    let Some(drive) = low.drive(name) else { return Ok(None) };
    let Typed { globals, environment } = &settings.typed;
    // A port that was typed is for drives of which no file says one.
    let port = if drive.port.is_none() { low.typed_ports()? } else { Vec::new() };
    let globals = Globals { address: Some(name.to_owned()), port, ..globals.clone() };
    let mut environment = environment.clone();
    environment.variables.remove("ANTRIEB_PORT");
    let own = Settings::resolve(&globals, &environment)?;
    let files = files_of(&project_path(settings), name, &drive.files)?;
    let (address, product) = (drive.address, drive.product.clone());
    Ok(Some(Place { name: name.to_owned(), address, product, files, settings: own }))
}

/// The files of a drive, from where the project file stands.
fn files_of(project: &Path, name: &str, named: &[PathBuf]) -> Result<Vec<PathBuf>, Failure> {
    let beside = project.parent().unwrap_or(Path::new(""));
    let paths: Vec<PathBuf> = named.iter().map(|file| beside.join(file)).collect();
    let missing = paths.iter().position(|path| files::found(path).is_none());
    let Some((index, path)) = missing.and_then(|index| Some((index, paths.get(index)?))) else { return Ok(paths) };
    let why = both!(
        "there is no file {path}; expected a parameter file, such as `antrieb dataset save` writes",
        "es gibt keine Datei {path}; erwartet wird eine Parameterdatei, wie `antrieb dataset save` sie schreibt",
        path = path.display()
    );
    Err(wrong_in(Path::new(""), project, &["drives", name, "files", &index.to_string()], why))
}

/// One line has one speed, one format, and one protocol.
fn check_lines(project: &Path, places: &[Place]) -> Result<(), Failure> {
    let setting = |place: &Place| format!("{} {}", place.settings.line, place.settings.protocol);
    for (index, place) in places.iter().enumerate() {
        let mut others = places.iter().take(index);
        let Some(other) = others.find(|other| other.line() == place.line() && setting(other) != setting(place)) else {
            continue;
        };
        let why = both!(
            "{name} is at {own}, {first} on the same port at {its}; expected one setting for a line",
            "{name} hat {own}, {first} am selben Anschluss {its}; erwartet wird eine Einstellung für eine Leitung",
            name = place.name,
            own = setting(place),
            first = other.name,
            its = setting(other)
        );
        return Err(wrong_in(Path::new(""), project, &["drives", &place.name], why));
    }
    Ok(())
}

/// The triggers that have a name: those of the project file before those of the user.
///
/// # Errors
/// A file does not do.
pub fn templates(settings: &Settings) -> Result<BTreeMap<String, Template>, Failure> {
    let Typed { globals, environment } = &settings.typed;
    let low = Low::read(globals, environment)?;
    let (_, project) = low.project();
    Ok(low.user().triggers.clone().into_iter().chain(project.triggers.clone()).collect())
}

/// What stands at the head of a report: what the project file says, else the user's.
///
/// # Errors
/// A file does not do.
pub fn letterhead(settings: &Settings) -> Result<Letterhead, Failure> {
    let Typed { globals, environment } = &settings.typed;
    let low = Low::read(globals, environment)?;
    let (path, project) = low.project();
    let beside = |path: &Path, head: &Letterhead| {
        let directory = environment.directory.join(path).parent().map(Path::to_owned).unwrap_or_default();
        Letterhead { logo: head.logo.as_ref().map(|logo| directory.join(logo)), ..head.clone() }
    };
    let of_user =
        || Some(beside(environment.user_config.as_ref()?.join("config.toml").as_ref(), low.user().report.as_ref()?));
    Ok(project.report.as_ref().map(|head| beside(path, head)).or_else(of_user).unwrap_or_default())
}

/// The names that the project file has for the drives at the ports of these settings, by their addresses.
///
/// # Errors
/// A file does not do.
pub fn called(settings: &Settings) -> Result<BTreeMap<u8, String>, Failure> {
    let Typed { globals, environment } = &settings.typed;
    let low = Low::read(globals, environment)?;
    let drives = low.project().1.drives.iter().filter(|(_, drive)| drive.is_at(&settings.ports));
    Ok(drives.map(|(name, drive)| (drive.address, name.clone())).collect())
}

/// The ports that were typed, or stand in the environment: only their drives are meant then.
///
/// # Errors
/// What was typed is no port.
pub fn typed_ports(settings: &Settings) -> Result<Vec<Port>, Failure> {
    let Typed { globals, environment } = &settings.typed;
    Low::read(globals, environment)?.typed_ports()
}
