//! What could be said of a line, for completion: ports that are there, drives that have names.

use super::globals::Globals;
use super::low::{Environment, Low};
use super::project::{ALL, GROUP};
use crate::transport::{Port, list_ports};

/// The serial ports of this machine by each of their names, with what is plugged in there.
pub fn ports_there() -> Vec<(String, String)> {
    let names = list_ports().into_iter().flat_map(|port| {
        let about = port.about;
        [Some(port.name), port.by_id].into_iter().flatten().map(move |name| (name, about.clone()))
    });
    names.collect()
}

/// Every USB serial adapter that is plugged in.
pub fn usb_ports() -> Vec<Port> {
    list_ports().into_iter().filter(|port| port.usb).map(|port| Port::Serial(port.name)).collect()
}

/// The groups that the project file and the user's configuration name, as they are typed, with their drives; `all` is one as
/// soon as a drive has a name.
pub fn named_groups(flags: &Globals, environment: &Environment) -> Vec<(String, String)> {
    let Ok(low) = Low::read(flags, environment) else { return Vec::new() };
    let files = || [low.project().1, low.user()].into_iter();
    let groups = files().flat_map(|file| &file.groups).map(|(name, of)| (format!("{GROUP}{name}"), of.join(", ")));
    let names: Vec<&str> = files().flat_map(|file| file.drives.keys()).map(String::as_str).collect();
    let all = Some((ALL.to_owned(), names.join(", "))).filter(|_| !names.is_empty());
    groups.chain(all).collect()
}

/// The drives that the project file and the user's configuration name, with their addresses; none of files that cannot be
/// read.
pub fn named_drives(flags: &Globals, environment: &Environment) -> Vec<(String, u8)> {
    let Ok(low) = Low::read(flags, environment) else { return Vec::new() };
    let drives = [low.project().1, low.user()].into_iter().flat_map(|file| &file.drives);
    drives.map(|(name, drive)| (name.clone(), drive.address)).collect()
}
