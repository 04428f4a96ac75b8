//! The import law: which room may name which. Reads `crate::` paths in the sources.

#![expect(clippy::unwrap_used, reason = "what a test needs and does not get ends it")]

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Room, and the rooms that it may name. A path below a room (`protocol::line`) allows only that part of it.
const LAW: &[(&str, &[&str])] = &[
    ("tick", &[]),
    ("failure", &[]),
    ("files", &[]),
    ("gate", &[]),
    ("outcome", &["failure"]),
    ("profile", &[]),
    ("protocol", &["tick"]),
    ("exchange", &["protocol", "tick"]),
    ("simulator", &["protocol", "profile", "tick"]),
    ("transport", &["simulator", "files", "protocol::line", "tick"]),
    (
        "drive",
        &["exchange", "transport", "profile", "gate", "failure", "files", "outcome", "tick", "simulator", "protocol"],
    ),
    ("render", &["outcome", "failure", "gate", "profile"]),
    (
        "args",
        &[
            "transport",
            "profile",
            "render",
            "failure",
            "files",
            "tick",
            "protocol::line",
            "protocol::modbus",
            "protocol::Protocol",
        ],
    ),
    ("command", &["args", "drive", "profile", "gate", "outcome", "failure", "files", "tick"]),
    ("cli", &["args", "command", "drive", "profile", "render", "outcome", "failure"]),
];

/// Files of `drive` that may name `protocol` and `simulator`; the rest of the room speaks of parameters.
const DRIVE_TELEGRAMS: &[&str] = &[
    "decode.rs",
    "diag.rs",
    "family.rs",
    "journey.rs",
    "mod.rs",
    "modbus.rs",
    "order.rs",
    "plot.rs",
    "registers.rs",
    "relocate.rs",
    "route.rs",
    "services.rs",
    "session.rs",
    "sniff.rs",
    "transfer.rs",
    "trouble.rs",
    "vabus.rs",
];
const DRIVE_SIMULATOR: &[&str] = &["bench.rs", "session.rs"];

#[test]
fn every_room_names_only_what_the_law_allows() {
    let mut broken = Vec::new();
    for (room, file) in sources() {
        let allowed = LAW.iter().find(|row| row.0 == room).unwrap_or_else(|| panic!("room '{room}' has no law")).1;
        for path in named(&file) {
            let own = path.split("::").next() == Some(room.as_str());
            let granted = allowed.iter().any(|allowed| path == *allowed || path.starts_with(&format!("{allowed}::")));
            if !own && !granted {
                broken.push(format!("{}: {room} must not name crate::{path}", file.display()));
            }
            let name = file.file_name().unwrap().to_string_lossy().into_owned();
            for (target, files) in [("protocol", DRIVE_TELEGRAMS), ("simulator", DRIVE_SIMULATOR)] {
                if room == "drive" && path.starts_with(target) && !files.contains(&name.as_str()) {
                    broken.push(format!("{}: only {files:?} of drive name crate::{target}", file.display()));
                }
            }
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn the_law_has_no_circles() {
    let law: BTreeMap<&str, BTreeSet<&str>> = LAW
        .iter()
        .map(|(room, to)| (*room, to.iter().map(|path| path.split("::").next().unwrap()).collect()))
        .collect();
    let mut settled: BTreeSet<&str> = BTreeSet::new();
    while settled.len() < law.len() {
        let next = law.iter().find(|(room, to)| !settled.contains(*room) && to.is_subset(&settled));
        settled.insert(next.unwrap_or_else(|| panic!("a circle among the rooms that are not in {settled:?}")).0);
    }
}

#[test]
fn no_room_is_a_lumber_room() {
    for (room, file) in sources() {
        for bad in ["common", "util", "utils", "helpers", "misc"] {
            assert!(room != bad && file.file_stem().unwrap() != bad, "{}", file.display());
        }
    }
}

/// Every source file with the room that it is in.
fn sources() -> Vec<(String, PathBuf)> {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    collect(&src, &mut files);
    let files = files.into_iter().filter(|file| !["lib.rs", "main.rs"].iter().any(|root| *file == src.join(root)));
    files
        .map(|file| {
            let room = file.strip_prefix(&src).unwrap().components().next().unwrap();
            let room = room.as_os_str().to_string_lossy().trim_end_matches(".rs").to_owned();
            (room, file)
        })
        .collect()
}

fn collect(directory: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

/// Paths behind `crate::` in code, up to two levels; tests at the end of a file may name what they like.
fn named(file: &Path) -> Vec<String> {
    let text = std::fs::read_to_string(file).unwrap();
    let text = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap();
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let mut paths = Vec::new();
    for line in code {
        for (at, _) in line.match_indices("crate::") {
            if line[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$') {
                continue;
            }
            let rest = &line[at + "crate::".len()..];
            let path: String = rest.chars().take_while(|c| c.is_alphanumeric() || matches!(c, '_' | ':')).collect();
            let levels: Vec<&str> = path.split("::").filter(|part| !part.is_empty()).take(2).collect();
            paths.push(levels.join("::"));
        }
    }
    paths
}
