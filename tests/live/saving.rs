//! What somebody sees of a save that takes its time.

use crate::program::{AtTerminal, alone, appears};

/// Whether this begins a progress with a rate and the time that is left: `40/s    4s`.
fn is_told(rest: &str) -> bool {
    let Some((rate, rest)) = rest.split_once("/s") else { return false };
    let left = rest.trim_start().split(|letter: char| !letter.is_ascii_alphanumeric()).next().unwrap_or_default();
    let seconds = left.strip_suffix('s').is_some_and(|number| number.parse::<u64>().is_ok());
    rate.parse::<u64>().is_ok() && seconds
}

#[test]
fn a_save_shows_how_far_it_is_how_fast_and_how_much_time_is_left() {
    let _alone = alone();
    let directory = tempfile::tempdir().unwrap();
    let (file, link) = (directory.path().join("bench.toml"), directory.path().join("bus"));
    std::fs::write(&file, "[[drive]]\nmodel = \"acu\"\naddress = 2\nbaud = 19200\n").unwrap();
    let mut line = AtTerminal::start(&format!("simulate {} --link {}", file.display(), link.display()));
    appears(&link, &line.seen);
    let saved = directory.path().join("pump.toml");
    let mut run = AtTerminal::whole(&format!("-p {} -a 2 dataset save {}", link.display(), saved.display()));
    run.shows("signature");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    let told = run.seen.match_indices(" parameters, ").filter(|(at, words)| {
        let how_far = run.seen[..*at].rsplit(' ').next().and_then(|far| far.split_once('/'));
        let is_far = how_far.is_some_and(|(done, all)| done.parse::<u64>().is_ok() && all.parse::<u64>().is_ok());
        is_far && is_told(&run.seen[at + words.len()..])
    });
    assert!(told.count() > 0, "{}", run.seen);
    assert!(saved.exists());
    line.signal("-TERM");
    line.ends();
}
