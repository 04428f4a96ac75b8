//! Plants all mutants of some rooms into a copy of the house at once. Each sleeps until the environment's `MUTANT` names it, so that one
//! build serves them all.
//!
//!     antrieb-mutants COPY LEFT_OUT ROOM...
//!
//! A room is a file or folder below COPY/src. LEFT_OUT lists the numbers of those that do not compile. COPY/mutants.json tells of each its
//! number, file, line, function, what stood there, what it becomes, whether it is left out, and where it stands in the planted file.

mod found;
mod planted;

use serde_json::{Value, json};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// What a planted expression asks. With `MUTANT_LOG` every number that is asked for is written there, once.
const SWITCH: &str = r#"
/// Whether this mutant is awake.
pub fn mutant(number: usize) -> bool {
    use std::io::Write;
    use std::sync::OnceLock;
    use std::sync::atomic::{AtomicBool, Ordering::Relaxed};
    static AWAKE: OnceLock<usize> = OnceLock::new();
    static LOG: OnceLock<Option<std::fs::File>> = OnceLock::new();
    static SEEN: [AtomicBool; 20_000] = [const { AtomicBool::new(false) }; 20_000];
    let awake = *AWAKE.get_or_init(|| std::env::var("MUTANT").ok().and_then(|text| text.parse().ok()).unwrap_or(0));
    if !SEEN[number].load(Relaxed) && !SEEN[number].swap(true, Relaxed) {
        let log = LOG.get_or_init(|| std::env::var("MUTANT_LOG").ok().and_then(|path| std::fs::File::create(path).ok()));
        if let Some(mut log) = log.as_ref() {
            let _ = writeln!(log, "{number}");
        }
    }
    awake == number
}
"#;
/// A mutant may do what the compiler warns of.
const ALLOWED: &str = "#![allow(warnings, arithmetic_overflow, unconditional_panic)]\n";

/// The sources of a room, tests left out.
fn sources(place: &Path, found: &mut Vec<PathBuf>) -> io::Result<()> {
    if place.is_dir() {
        let mut all = fs::read_dir(place)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
        all.sort();
        return all.iter().filter(|path| !path.ends_with("tests")).try_for_each(|path| sources(path, found));
    }
    if place.extension().is_some_and(|end| end == "rs") && !place.ends_with("tests.rs") {
        found.push(place.to_owned());
    }
    Ok(())
}

fn main() -> io::Result<()> {
    let args: Vec<String> = env::args().skip(1).collect();
    let [copy, left_out, rooms @ ..] = &args[..] else {
        return Err(io::Error::other("expected: COPY LEFT_OUT ROOM..."));
    };
    let copy = Path::new(copy);
    let left_out = fs::read_to_string(left_out)?;
    let left_out: HashSet<usize> = left_out.lines().filter_map(|line| line.parse().ok()).collect();

    let mut files = Vec::new();
    rooms.iter().try_for_each(|room| sources(&copy.join("src").join(room), &mut files))?;
    let mut told: Vec<Value> = Vec::new();
    for path in files {
        let text = fs::read_to_string(&path)?;
        let mutants =
            found::mutants(&text).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))?;
        let first = told.len() + 1;
        let is_left_out = |nth: usize| left_out.contains(&(first + nth));
        let (new, places) = planted::planted(&text, &mutants, first, is_left_out);
        let file = path.strip_prefix(copy).unwrap_or(&path).display().to_string();
        for (nth, mutant) in mutants.iter().enumerate() {
            told.push(json!({
                "number": first + nth, "file": file, "line": mutant.line, "function": mutant.function,
                "was": mutant.was, "becomes": mutant.becomes, "left_out": is_left_out(nth), "places": places[nth],
            }));
        }
        fs::write(&path, new)?;
    }
    let root = copy.join("src/lib.rs");
    let text = fs::read_to_string(&root)?;
    fs::write(&root, format!("{ALLOWED}{text}{SWITCH}"))?;
    fs::write(copy.join("mutants.json"), serde_json::to_string(&told)?)?;
    println!("{} mutants, {} of them left out", told.len(), left_out.len());
    Ok(())
}
