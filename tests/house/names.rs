//! Who names whom: the paths that each file spells, and the files that they lead to.
//!
//! `use` trees, `crate::`, `self::`, `super::`, names that were imported, and child modules are all followed, and so is
//! what another file hands on (`pub use`): what counts is the file in which a thing is defined. A method that is called
//! names nobody.

use crate::tokens::{Token, code};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Path of a module below the crate, as its names.
pub(crate) type Module = Vec<String>;

/// A file of the library.
pub(crate) struct Source {
    pub(crate) module: Module,
    pub(crate) file: PathBuf,
    tokens: Vec<Token>,
    /// What it imports: the name that it has here, and its path from the crate on.
    imports: BTreeMap<String, Module>,
    /// Everything of these modules.
    globs: Vec<Module>,
    /// Names of the items that it defines, in whatever depth.
    defines: BTreeSet<String>,
}

/// All files of the library, as `mod` leads to them from `lib.rs`: no tests.
pub(crate) struct Sources(BTreeMap<Module, Source>);

/// One file names something in another.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Arrow {
    pub(crate) from: Module,
    pub(crate) to: Module,
    pub(crate) name: String,
}

impl Sources {
    pub(crate) fn of(src: &Path) -> Self {
        let mut sources = BTreeMap::new();
        let mut todo = vec![(Module::new(), src.join("lib.rs"), src.to_owned())];
        while let Some((module, file, directory)) = todo.pop() {
            let tokens = code(&std::fs::read_to_string(&file).unwrap());
            for name in children(&tokens) {
                let (flat, folder) = (directory.join(format!("{name}.rs")), directory.join(&name));
                let file = if flat.exists() { flat } else { folder.join("mod.rs") };
                todo.push(([module.clone(), vec![name]].concat(), file, folder));
            }
            sources.insert(module.clone(), Source::new(module, file, tokens));
        }
        let mut sources = Sources(sources);
        sources.import();
        sources
    }

    #[cfg(test)]
    fn of_texts(texts: &[(&str, &str)]) -> Self {
        let module =
            |path: &str| -> Module { path.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect() };
        let source = |&(path, text): &(&str, &str)| (module(path), Source::new(module(path), path.into(), code(text)));
        let mut sources = Sources(texts.iter().map(source).collect());
        sources.import();
        sources
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Source> {
        self.0.values()
    }

    fn import(&mut self) {
        let trees: Vec<_> = self.0.values().map(|source| (source.module.clone(), imports(&source.tokens))).collect();
        for (module, trees) in trees {
            for (path, name) in trees {
                let Some(path) = self.absolute(&module, &path) else { continue };
                let Some(source) = self.0.get_mut(&module) else { continue };
                match name.as_str() {
                    "*" => source.globs.push(path),
                    _ => drop(source.imports.insert(name, path)),
                }
            }
        }
    }

    /// A path that a file spells, from the crate on; `None` if it leads out of the crate, or is no path of modules.
    fn absolute(&self, module: &Module, path: &[String]) -> Option<Module> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => Some(rest.to_vec()),
            "self" => Some([module.as_slice(), rest].concat()),
            "super" => {
                let ups = path.iter().take_while(|name| *name == "super").count();
                let above = module.get(..module.len().checked_sub(ups)?)?;
                Some([above, &path[ups..]].concat())
            }
            name => {
                let child = [module.as_slice(), std::slice::from_ref(first)].concat();
                let source = self.0.get(module)?;
                let known =
                    source.imports.get(name).cloned().or_else(|| self.0.contains_key(&child).then_some(child))?;
                Some([known.as_slice(), rest].concat())
            }
        }
    }

    /// Every path that a file spells, from the crate on.
    pub(crate) fn spelt(&self, source: &Source) -> BTreeSet<Module> {
        let imported = source.imports.values().chain(&source.globs).cloned();
        let written = paths(&source.tokens).into_iter().filter_map(|path| self.absolute(&source.module, &path));
        imported.chain(written).collect()
    }

    /// The file that defines what a path names; of a path to a module alone there is none.
    fn definer(&self, path: &[String], depth: usize) -> Option<&Module> {
        let most = (0..=path.len()).rev().find(|&length| self.0.contains_key(&path[..length]))?;
        let source = self.0.get(&path[..most])?;
        let (name, rest) = path[most..].split_first()?;
        if source.defines.contains(name) || depth == 0 {
            return Some(&source.module);
        }
        if let Some(import) = source.imports.get(name) {
            return self.definer(&[import.as_slice(), rest].concat(), depth - 1);
        }
        let through = |glob: &Module| {
            let path = [glob.as_slice(), std::slice::from_ref(name), rest].concat();
            let definer = self.definer(&path, depth - 1)?;
            self.0.get(definer)?.defines.contains(name).then_some(definer)
        };
        source.globs.iter().find_map(through).or(Some(&source.module))
    }

    /// Who names whom.
    pub(crate) fn arrows(&self) -> BTreeSet<Arrow> {
        let mut arrows = BTreeSet::new();
        for source in self.iter() {
            for path in self.spelt(source) {
                let Some(to) = self.definer(&path, 8).filter(|to| **to != source.module) else { continue };
                let name = path.last().cloned().unwrap_or_default();
                arrows.insert(Arrow { from: source.module.clone(), to: to.clone(), name });
            }
            let globs = source.globs.iter().filter(|glob| self.0.contains_key(*glob) && **glob != source.module);
            arrows.extend(globs.map(|to| Arrow { from: source.module.clone(), to: to.clone(), name: "*".to_owned() }));
        }
        arrows
    }
}

impl Source {
    fn new(module: Module, file: PathBuf, tokens: Vec<Token>) -> Self {
        let kinds = ["fn", "struct", "enum", "trait", "type", "const", "static", "union"];
        let defines = tokens.windows(2).filter(|pair| kinds.contains(&pair[0].as_str())).map(|pair| pair[1].clone());
        let macros = tokens.windows(3).filter(|three| three[0] == "macro_rules").map(|three| three[2].clone());
        let defines = defines.chain(macros).collect();
        Source { module, file, tokens, imports: BTreeMap::new(), globs: Vec::new(), defines }
    }
}

/// The modules that a file declares without their text.
fn children(tokens: &[Token]) -> Vec<String> {
    let declared = tokens.windows(3).filter(|three| three[0] == "mod" && three[2] == ";");
    declared.map(|three| three[1].clone()).collect()
}

/// What the `use` trees of a file import: path, and the name that it has here (`*` for all of it).
fn imports(tokens: &[Token]) -> Vec<(Vec<String>, String)> {
    let mut found = Vec::new();
    for (at, token) in tokens.iter().enumerate() {
        let before = at.checked_sub(1).and_then(|at| tokens.get(at)).map_or(";", String::as_str);
        if token == "use" && matches!(before, ";" | "}" | "{" | ")" | "]" | "pub") {
            tree(&tokens[at + 1..], &[], &mut found);
        }
    }
    found
}

/// Reads one branch of a tree; returns how many words it has.
fn tree(tokens: &[Token], above: &[String], found: &mut Vec<(Vec<String>, String)>) -> usize {
    let mut path = above.to_vec();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        match token.as_str() {
            "::" => at += 1,
            "{" => {
                at += 1;
                while tokens.get(at).is_some_and(|token| token != "}") {
                    at += tree(&tokens[at..], &path, found);
                    at += usize::from(tokens.get(at).is_some_and(|token| token == ","));
                }
                return at + 1;
            }
            "as" => {
                let name = tokens.get(at + 1).cloned().unwrap_or_default();
                found.push((path, name));
                return at + 2;
            }
            "*" => {
                found.push((path, "*".to_owned()));
                return at + 1;
            }
            "," | "}" | ";" => break,
            "self" if !path.is_empty() => at += 1,
            name => {
                path.push(name.to_owned());
                at += 1;
            }
        }
    }
    let name = path.last().cloned().unwrap_or_default();
    found.push((path, name));
    at
}

/// Every path of two names or more that a file spells, outside its imports, and every single name that was imported.
fn paths(tokens: &[Token]) -> Vec<Vec<String>> {
    let is_name = |token: &Token| token.chars().all(|c| c.is_alphanumeric() || c == '_');
    let mut found = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let begins = is_name(&tokens[at]) && at.checked_sub(1).is_none_or(|before| tokens[before] != "::");
        let mut path = vec![tokens[at].clone()];
        at += 1;
        while begins && tokens.get(at).is_some_and(|token| token == "::") && tokens.get(at + 1).is_some_and(is_name) {
            path.push(tokens[at + 1].clone());
            at += 2;
        }
        if begins && path.len() > 1 {
            found.push(path);
        }
    }
    found
}

#[test]
fn every_way_to_name_a_thing_is_seen() {
    let sources = Sources::of_texts(&[
        ("", "pub mod a; pub mod b;"),
        ("a", "mod inner; pub use inner::Thing; pub struct Own;"),
        ("a::inner", "pub struct Thing; use super::Own; pub fn make() {}"),
        ("b", "mod deep; use crate::a::{self, Thing as Other}; fn f() { a::Own; }"),
        ("b::deep", "fn g() { super::super::a::Own; matches!(x, crate::a::Thing); } use crate::a::*;"),
    ]);
    let arrows: Vec<String> = sources
        .arrows()
        .iter()
        .map(|arrow| format!("{} -> {}: {}", arrow.from.join("::"), arrow.to.join("::"), arrow.name))
        .collect();
    let seen = [
        "a -> a::inner: Thing",
        "a::inner -> a: Own",
        "b -> a: Own",
        "b -> a::inner: Thing",
        "b::deep -> a: *",
        "b::deep -> a: Own",
        "b::deep -> a::inner: Thing",
    ];
    assert_eq!(arrows, seen);
}
