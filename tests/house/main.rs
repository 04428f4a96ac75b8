//! The import law: which room, and which file, may name which. Read from the sources, by path, down to the file.

#![expect(clippy::unwrap_used, reason = "what a test needs and does not get ends it")]

mod law;
mod names;
mod tokens;

use law::{LAW, SIBLINGS, STRICT, TELEGRAMS};
use names::{Arrow, Module, Sources};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

fn sources() -> Sources {
    Sources::of(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"))
}

/// Whether `module` is `path` or lies below it.
fn inside(module: &[String], path: &str) -> bool {
    path.split("::").zip(module.iter().map(String::as_str).chain(std::iter::repeat(""))).all(|(a, b)| a == b)
}

fn told(module: &[String]) -> String {
    module.join("::")
}

#[test]
fn every_room_names_only_what_the_law_allows() {
    let sources = sources();
    let mut broken = BTreeSet::new();
    for source in sources.iter().filter(|source| !source.module.is_empty()) {
        let row = |own: &Module| {
            let rows = LAW.iter().filter(|row| inside(own, row.0));
            rows.max_by_key(|row| row.0.split("::").count()).unwrap_or_else(|| panic!("'{}' has no law", told(own)))
        };
        let (room, allowed) = row(&source.module);
        for path in sources.spelt(source) {
            let granted = allowed.iter().any(|allowed| inside(&path, allowed));
            if !path.is_empty() && !inside(&path, room) && !granted {
                broken.insert(format!("{}: {room} must not name {}", source.file.display(), told(&path)));
            }
        }
    }
    assert!(broken.is_empty(), "{}", Vec::from_iter(broken).join("\n"));
}

#[test]
fn only_these_files_of_drive_speak_of_telegrams_and_benches() {
    let sources = sources();
    let mut broken = BTreeSet::new();
    for (target, files) in TELEGRAMS {
        let mut idle: BTreeSet<&str> = files.iter().copied().collect();
        for source in sources.iter().filter(|source| inside(&source.module, "drive")) {
            let own = told(&source.module);
            if sources.spelt(source).iter().any(|path| inside(path, target)) && !idle.remove(own.as_str()) {
                broken.insert(format!("{own} must not name {target}: only {files:?}"));
            }
        }
        broken
            .extend(idle.iter().map(|file| format!("{file} does not name {target} any more: take it out of the list")));
    }
    assert!(broken.is_empty(), "{}", Vec::from_iter(broken).join("\n"));
}

#[test]
fn siblings_do_not_name_each_other() {
    let mut broken = BTreeSet::new();
    for Arrow { from, to, name } in sources().arrows() {
        for (room, shared) in SIBLINGS {
            let depth = room.split("::").count();
            let part = |module: &Module| -> Option<String> {
                let part = module.get(depth).filter(|_| inside(module, room))?;
                Some(format!("{room}::{part}"))
            };
            let (Some(own), Some(other)) = (part(&from), part(&to)) else { continue };
            if own != other && !shared.contains(&other.as_str()) {
                broken.insert(format!("{} must not name {name} of {}", told(&from), told(&to)));
            }
        }
    }
    assert!(broken.is_empty(), "{}", Vec::from_iter(broken).join("\n"));
}

#[test]
fn no_file_is_in_a_circle() {
    let is_strict = |arrow: &Arrow| STRICT.iter().any(|room| inside(&arrow.from, room) && inside(&arrow.to, room));
    // A module and what lies inside it are one thing, but where the law is strict.
    let nested = |arrow: &Arrow| arrow.from.starts_with(&arrow.to) || arrow.to.starts_with(&arrow.from);
    let arrows = sources().arrows();
    let arrows: BTreeSet<Arrow> = arrows.into_iter().filter(|arrow| is_strict(arrow) || !nested(arrow)).collect();
    let found: Vec<String> = circles(&arrows).iter().map(|circle| drawn(circle, &arrows)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// Files that lead to each other, in whatever number of steps.
fn circles(arrows: &BTreeSet<Arrow>) -> Vec<BTreeSet<Module>> {
    let mut named: BTreeMap<&Module, BTreeSet<&Module>> = BTreeMap::new();
    for arrow in arrows {
        named.entry(&arrow.from).or_default().insert(&arrow.to);
    }
    let mut reach: BTreeMap<&Module, BTreeSet<&Module>> = BTreeMap::new();
    for file in named.keys() {
        let (mut todo, seen) = (vec![*file], reach.entry(file).or_default());
        while let Some(at) = todo.pop() {
            todo.extend(named.get(at).into_iter().flatten().filter(|to| seen.insert(to)));
        }
    }
    let mut found: Vec<BTreeSet<Module>> = Vec::new();
    for (file, reached) in &reach {
        let back = |other: &&&Module| reach.get(**other).is_some_and(|reached| reached.contains(file));
        let circle: BTreeSet<Module> = reached.iter().filter(back).map(|file| (**file).clone()).collect();
        if !circle.is_empty() && !found.contains(&circle) {
            found.push(circle);
        }
    }
    found
}

fn drawn(circle: &BTreeSet<Module>, arrows: &BTreeSet<Arrow>) -> String {
    let ties = arrows.iter().filter(|arrow| circle.contains(&arrow.from) && circle.contains(&arrow.to));
    let mut drawn: BTreeMap<(String, String), Vec<&str>> = BTreeMap::new();
    for arrow in ties {
        drawn.entry((told(&arrow.from), told(&arrow.to))).or_default().push(&arrow.name);
    }
    let drawn: Vec<String> =
        drawn.iter().map(|((from, to), names)| format!("  {from} -> {to}: {}", names.join(", "))).collect();
    format!("a circle of {} files:\n{}", circle.len(), drawn.join("\n"))
}

#[test]
fn a_circle_is_found_and_a_chain_is_none() {
    let arrow =
        |(from, to): &(&str, &str)| Arrow { from: vec![(*from).into()], to: vec![(*to).into()], name: "x".into() };
    let drawn = |pairs: &[(&str, &str)]| circles(&pairs.iter().map(arrow).collect());
    assert!(drawn(&[("a", "b"), ("b", "c"), ("a", "c")]).is_empty());
    let found = drawn(&[("a", "b"), ("b", "c"), ("c", "b"), ("c", "d")]);
    assert_eq!(found, [BTreeSet::from([vec!["b".to_owned()], vec!["c".to_owned()]])]);
}

#[test]
fn the_law_has_no_circles() {
    let room = |path: &str| path.split("::").next().unwrap().to_owned();
    let mut law: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (own, allowed) in LAW {
        let rooms = allowed.iter().map(|path| room(path)).filter(|other| *other != room(own));
        law.entry(room(own)).or_default().extend(rooms);
    }
    let mut settled: BTreeSet<String> = BTreeSet::new();
    while settled.len() < law.len() {
        let next = law.iter().find(|(room, to)| !settled.contains(*room) && to.is_subset(&settled));
        settled
            .insert(next.unwrap_or_else(|| panic!("a circle among the rooms that are not in {settled:?}")).0.clone());
    }
}

#[test]
fn no_room_is_a_lumber_room() {
    for source in sources().iter() {
        for bad in ["common", "util", "utils", "helpers", "misc"] {
            assert!(!source.module.iter().any(|name| name == bad), "{}", source.file.display());
        }
    }
}

/// `sources A2` or `facts A2` in a comment is a section of docs/sources.md, and nothing is cited that is not in the clone.
#[test]
fn every_source_that_is_cited_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let page = std::fs::read_to_string(root.join("docs/sources.md")).unwrap();
    let sections: BTreeSet<&str> =
        page.lines().filter_map(|line| line.strip_prefix("### ")?.split(' ').next()).collect();
    let data = ["active", "lexium05", "hitachi"].map(|name| root.join(format!("src/profile/data/{name}.toml")));
    let mut broken = Vec::new();
    for file in sources().iter().map(|source| source.file.clone()).chain(data) {
        let text = std::fs::read_to_string(&file).unwrap();
        let behind = |word: &'static str| text.split(word).skip(1);
        let cited = behind("sources ").chain(behind("facts "));
        let cited = cited.filter_map(|rest| rest.split([')', ';', ',', ':', '.', '\n', ' ', '"']).next());
        let is_section = |name: &&str| {
            let mut letters = name.chars();
            letters.next().is_some_and(|c| ('A'..='H').contains(&c)) && letters.all(|c| c.is_ascii_digit())
        };
        let missing = cited.filter(is_section).filter(|name| !sections.contains(name));
        broken.extend(missing.map(|name| format!("{}: docs/sources.md has no section {name}", file.display())));
        if text.contains("facts/") {
            broken.push(format!("{}: cites a page that is not in the clone", file.display()));
        }
    }
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}
