//! What a project file does that whoever unpacked it may not expect.

use super::project::File;
use crate::text::{Text, both};
use crate::transport::Port;
use std::path::{Path, PathBuf};

/// A project file comes with a directory that somebody else may have packed: where it reaches into the network is said.
pub(super) fn network_note(port: &Port, file: &Path) -> Option<Text> {
    let port = if let Port::Slcan(port) = port { port } else { port };
    let reaches_out = matches!(port, Port::Tcp(_) | Port::Rfc2217(_) | Port::Mbtcp(_));
    let file = file.display();
    reaches_out.then(|| {
        both!(
            "{file} sets the port: {port} (another one with -p; --no-config leaves the file out)",
            "{file} bestimmt den Anschluss: {port} (anderer mit -p; --no-config lässt die Datei weg)"
        )
    })
}

/// What a parameter means decides what is written to a drive: where a project file puts other rows in place of ours is
/// said.
pub(super) fn catalogue_notes(project: &File, directory: &Path, file: &Path) -> Vec<Text> {
    let replaces = |path: &&PathBuf| {
        let text = std::fs::read_to_string(directory.join(path)).unwrap_or_default();
        toml::from_str::<toml::Value>(&text).is_ok_and(|value| replaces_rows(&value))
    };
    let file = file.display();
    let note = |path: &PathBuf| {
        both!(
            "{file}: the catalogue {path} replaces rows of the built-in one",
            "{file}: der Katalog {path} ersetzt Zeilen des eingebauten",
            path = path.display()
        )
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
