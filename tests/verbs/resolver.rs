//! `procedure resolver-offset`: from any offset, with the phases either way, to a flux-forming voltage of 0; a shaft that runs away is
//! stopped; whoever interrupts finds P.417 and P.728 as they were.

use crate::agreeable::Agreeable;
use crate::run::antrieb;
use antrieb::args::{Environment, Globals, Settings};
use antrieb::command::{Context, procedure};
use antrieb::drive::Interrupt;
use antrieb::failure::Failure;
use antrieb::outcome::{Event, Outcome};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use clap::Parser;
use std::path::Path;

const LINE: &str = "-a 1 --yes procedure resolver-offset resolver-pairs=1 current=3.6A";
const RECORD: &str = "procedure-resolver-offset-1.json";

/// A synchronous motor with its resolver, uncoupled, that a hand turns.
fn bench(pairs: i64, offset: f64, more: &str) -> String {
    format!(
        "[[drive]]\nmodel = \"acu\"\nmodules = [\"EM-RES-03\"]\ntorque = 0\nresolver = {{ offset = {offset}{more} }}\n\
         set = {{ \"30\" = 510, \"412\" = 1, \"373\" = {pairs}, \"375\" = 50, \"417\" = 9999, \"728\" = 50, \"418\" = 0 }}\n\
         [[drive.event]]\nat = \"0s\"\nhand = 0.5\n"
    )
}

/// The flux-forming voltage as sine of the error, of a motor that turns.
fn error(bench: &Bench, pairs: i64, truth: f64) -> f64 {
    let set = bench.drives().next().unwrap().ram(382, 1).unwrap() as f64 / 10.0;
    ((set - truth) * pairs as f64).to_radians().sin()
}

#[test]
fn it_ends_near_zero_from_any_offset() {
    for (pairs, offset) in
        [(3, 0.0), (3, 33.0), (3, 61.0), (3, 95.5), (1, 200.0), (1, 359.9), (4, 45.3), (7, 12.5), (2, 90.0)]
    {
        let told = antrieb(LINE).on(&bench(pairs, offset, "")).json().exits(0);
        assert!(told.data("/complete") == true, "{:#}", told.value);
        let (bench, _) = witness::left().unwrap();
        let drive = bench.drives().next().unwrap();
        assert!(error(&bench, pairs, offset).abs() < 0.03, "{pairs} {offset}: {:?}", drive.ram(382, 1));
        assert_eq!(drive.eeprom(382, 1), drive.ram(382, 1), "it stays");
        assert_eq!((drive.ram(417, 0), drive.ram(728, 0)), (Some(9_999), Some(50)), "{pairs} {offset}");
        // P.381 is at its factory setting already: P.766 and P.382 wear one cell each, if they change at all.
        assert!(drive.eeprom_writes() <= 2, "{}", drive.eeprom_writes());
        let totals = bench.totals();
        assert_eq!((totals.turning, totals.energised), (0, 0), "{pairs} {offset}");
        let remarks: Vec<_> = bench.remarks().iter().map(ToString::to_string).collect();
        assert!(remarks.is_empty(), "{remarks:?}");
    }
}

#[test]
fn phases_that_are_exchanged_are_asked_for_and_found() {
    // Somebody exchanges them while the question for it stands.
    let swapped = bench(3, 20.0, ", swapped = true") + "[[drive.event]]\nat = \"30s\"\nexchange_phases = true\n";
    let told = antrieb(LINE).on(&swapped).json().exits(0);
    let found = told.data("/steps/6/found").to_string();
    assert!(found.contains("it stands"), "{found}");
    assert!(told.err.contains("exchange two motor phases"), "{}", told.err);
    assert!(error(&witness::left().unwrap().0, 3, 20.0).abs() < 0.03, "{found}");
}

#[test]
fn phases_that_stay_exchanged_end_it_with_everything_as_it_was() {
    let told = antrieb(LINE).on(&bench(3, 20.0, ", swapped = true")).json().exits(1);
    assert_eq!(told.error()["code"], "no.offset");
    let (bench, _) = witness::left().unwrap();
    let drive = bench.drives().next().unwrap();
    assert_eq!((drive.ram(417, 0), drive.ram(728, 0), drive.ram(382, 1)), (Some(9_999), Some(50), Some(0)));
    assert_eq!((bench.totals().turning, bench.totals().energised), (0, 0));
}

#[test]
fn a_shaft_that_runs_away_is_stopped_and_tried_half_a_turn_further() {
    let told = antrieb(LINE).on(&bench(3, 60.0, "")).json().exits(0);
    let found = told.data("/steps/6/found").to_string();
    assert!(found.contains("it ran away and was stopped"), "{found}");
    // The rotor never was faster than it races in the time of a few looks, far from where it would end.
    let motions = told.data("/steps/6/motions").as_array().unwrap();
    let runs: Vec<_> = motions.iter().filter(|motion| motion["action"] != "reset").collect();
    assert_eq!(runs.len(), 3, "away, found, and at half of the rated frequency");
    for motion in runs {
        assert_eq!((&motion["standing"], &motion["running"]), (&true.into(), &false.into()), "{motion:#?}");
        let changed = motion["changed"].as_array().unwrap();
        assert!(changed.iter().all(|change| change["restored"] == true), "{changed:#?}");
    }
}

#[test]
fn a_resolver_that_counts_the_other_way_ends_it_before_anything_turns() {
    for (more, hand) in [(", inverted = true", "0.5"), ("", "-0.5")] {
        let told =
            antrieb(LINE).on(&bench(3, 10.0, more).replace("hand = 0.5", &format!("hand = {hand}"))).json().exits(1);
        assert_eq!(told.error()["code"], "no.direction");
        assert!(told.error()["hint"].to_string().contains("SIN+ and SIN-"), "{}", told.error());
        assert_eq!(witness::left().unwrap().0.totals().energised, 0);
    }
    let still = bench(3, 10.0, "").replace("hand = 0.5", "hand = 0");
    assert_eq!(antrieb(LINE).on(&still).json().exits(1).error()["code"], "no.turning");
}

#[test]
fn what_cannot_be_is_refused() {
    let ratio = antrieb(&LINE.replace("pairs=1", "pairs=2")).on(&bench(3, 10.0, "")).json().exits(7);
    assert_eq!(ratio.error()["code"], "data.pole_pairs");
    for (line, word) in [
        (LINE.replace("pairs=1", "pairs=8"), "resolver-pairs"),
        (format!("{LINE} limit=20Hz"), "at most 10 Hz"),
        (format!("{LINE} limit=0Hz"), "above 0"),
        (LINE.replace("3.6A", "3.6V"), "above 0 A"),
    ] {
        let told = antrieb(&line).on(&bench(3, 10.0, "")).and("-v").exits(7);
        assert!(told.err.contains(word) && told.sent().is_empty(), "{line}: {}", told.err);
    }
    // It is low already: the search must not raise it.
    let low = bench(3, 10.0, "").replace("\"728\" = 50", "\"728\" = 2");
    let told = antrieb(LINE).on(&low).json().exits(7);
    assert!(told.error()["message"].to_string().contains("only be lowered"), "{}", told.error());
    let without = antrieb("-a 1 --yes procedure resolver-offset current=3A").on(&bench(3, 10.0, "")).exits(2);
    assert!(without.err.contains("resolver-pairs ("), "{}", without.err);
}

#[derive(Parser)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
    #[command(flatten)]
    globals: Globals,
}

#[derive(clap::Subcommand)]
enum Verb {
    Procedure(procedure::Args),
}

struct Seen {
    /// The record as it stood on the disk at each telegram, where it was another one than before.
    records: Vec<String>,
    telegrams: usize,
    failure: Option<Failure>,
    bench: Bench,
    at: Tick,
    told: String,
}

/// A search in a directory, interrupted at a telegram.
fn interrupted(directory: &Path, bench: &str, step: usize) -> Seen {
    let file = directory.join("bench.toml");
    std::fs::write(&file, bench).unwrap();
    let line = format!("antrieb -p sim:{} --drive acu {LINE}", file.display());
    let cli = Cli::parse_from(line.split_whitespace());
    let environment = Environment { directory: directory.to_owned(), ..Environment::default() };
    let settings = Settings { verbose: true, ..Settings::resolve(&cli.globals, &environment).unwrap() };
    let (interrupt, mut telegrams, mut records) = (Interrupt::default(), 0, Vec::new());
    let wish = interrupt.clone();
    let mut observe = |event: Event| {
        if matches!(event, Event::Telegram { .. }) {
            telegrams += 1;
            let record = std::fs::read_to_string(directory.join(RECORD)).unwrap_or_default();
            if records.last() != Some(&record) {
                records.push(record);
            }
            if telegrams == step {
                wish.press();
            }
        }
    };
    witness::call(true);
    let (mut ask, registry) = (Agreeable, Registry::open(&[]).unwrap());
    let (sheet, calls) = (antrieb::render::sheet, None);
    let mut context = Context {
        settings: &settings,
        registry: &registry,
        ask: &mut ask,
        observe: &mut observe,
        interrupt,
        sheet,
        calls,
    };
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let Verb::Procedure(args) = &cli.verb;
    let outcome = runtime.block_on(procedure::run(args, &mut context)).unwrap_or_else(Outcome::from);
    let told = serde_json::to_string(&outcome.data).unwrap_or_default();
    let (bench, at) = witness::left().unwrap();
    Seen { records, telegrams, failure: outcome.failure, bench, at, told }
}

#[test]
fn whoever_interrupts_anywhere_leaves_nothing_turning_and_the_limits_as_they_were() {
    // It runs away first, so that every branch is on the way.
    let bench = bench(3, 60.0, "");
    let whole = tempfile::tempdir().unwrap();
    let length = interrupted(whole.path(), &bench, usize::MAX).telegrams;
    for step in (1..length).step_by((length / 60).max(1)) {
        let directory = tempfile::tempdir().unwrap();
        let seen = interrupted(directory.path(), &bench, step);
        let mut later = seen.bench.clone();
        later.advance(seen.at + Span::from_secs(30));
        let totals = later.totals();
        assert_eq!((totals.turning, totals.energised), (0, 0), "{step} of {length}");
        let drive = seen.bench.drives().next().unwrap();
        let low = (drive.ram(417, 0), drive.ram(728, 0)) == (Some(9_999), Some(50));
        let named = seen.told.contains("\"restored\":false");
        assert!(low || named, "{step} of {length}: {:?} {:?}", drive.ram(417, 0), drive.ram(728, 0));
        let Some(failure) = seen.failure else {
            assert!(seen.told.contains("\"complete\":true"), "{step}: nobody heard of it");
            continue;
        };
        assert_eq!(failure.class.exit(), 130, "{step}: {failure:?}");
        // What is not agreed to and proven is not kept: the offset is what it was, or the one that was written at the end.
        let (eeprom, ram) = (drive.eeprom(382, 1), drive.ram(382, 1));
        assert!(eeprom == ram || named, "{step} of {length}: {eeprom:?} {ram:?}");
        assert!(
            seen.told.is_empty() || !directory.path().join(RECORD).exists() || seen.told.contains("resolver-offset")
        );
    }
}

/// Killed in a try, a program gives nothing back: what stood before it is on the disk, and whoever goes on sets it back before all else.
#[test]
fn who_goes_on_behind_a_kill_gives_back_what_stood_before() {
    let directory = tempfile::tempdir().unwrap();
    let whole = interrupted(directory.path(), &bench(3, 52.0, ""), usize::MAX);
    let lent = ["P.413@0ram", "P.417@0ram", "P.728@0ram", "P.382@1ram"];
    assert!(whole.records.iter().any(|record| lent.iter().all(|name| record.contains(name))));
    let end = std::fs::read_to_string(directory.path().join(RECORD)).unwrap();
    assert!(!end.contains("\"lent\"") && end.contains("\"set-up\""), "all of it was given back: {end}");
    // As the killed run has left it: a raised limit would be a surprise to whoever takes it for the original.
    let left = bench(3, 52.0, "").replace(
        "\"417\" = 9999, \"728\" = 50",
        "\"417\" = 500, \"728\" = 4, \"382@1ram\" = RAM, \"413\" = 2, \"766\" = 2",
    );
    let offset = |record: &str| {
        let record: serde_json::Value = serde_json::from_str(record).unwrap_or_default();
        let lent = record["lent"].as_array().cloned().unwrap_or_default();
        lent.into_iter()
            .find(|lent| lent["param"] == 382)
            .map(|lent| (lent["new"].as_i64().unwrap(), lent["was"].as_i64()))
    };
    // Each value of the search is on the disk before it goes out, with the one before it, which stands if it never did.
    let sought: Vec<_> = whole.records.iter().filter_map(|record| offset(record)).collect();
    let steps: Vec<_> = sought.windows(2).filter(|pair| pair[0] != pair[1] && pair[1].1.is_some()).collect();
    assert!(steps.len() > 5 && steps.iter().all(|pair| pair[1].1 == Some(pair[0].0)), "{sought:?}");
    let kept =
        whole.records.iter().find(|record| offset(record).is_some_and(|(_, was)| was.is_some_and(|was| was > 0)));
    let kept = kept.unwrap();
    let (new, was) = offset(kept).unwrap();
    for value in [new, was.unwrap()] {
        let left = left.replace("RAM", &format!("\"{}\"", value as f64 / 10.0));
        let told = antrieb(LINE).file(RECORD, kept).on(&left).exits(8);
        assert!(told.err.contains("--again"), "{}", told.err);
        assert_eq!(witness::left().unwrap().0.drives().next().unwrap().ram(382, 1), Some(0), "{value}");
    }
    // What somebody else has set since stays, and the way back to 12.5° is told as it is typed.
    let mut record: serde_json::Value = serde_json::from_str(kept).unwrap();
    let of_offset = record["lent"].as_array_mut().unwrap().iter_mut().find(|lent| lent["param"] == 382);
    let of_offset = of_offset.unwrap();
    (of_offset["old"], of_offset["stood"]) = (125.into(), "12.5".into());
    let theirs = antrieb(&format!("{LINE} --again")).file(RECORD, &record.to_string());
    let theirs = theirs.on(&left.replace("RAM", "99")).exits(9);
    assert!(theirs.err.contains("P.382@1ram = 99.0 (was 12.5)"), "{}", theirs.err);
    assert!(theirs.err.contains(" write 382@1ram=12.5`"), "{}", theirs.err);
    assert!(theirs.text_of(RECORD).contains("382"), "{}", theirs.text_of(RECORD));
    assert!(
        theirs.out.contains("left alone at 99.0") && theirs.out.contains("was 12.5 (`antrieb write 382@1ram=12.5`)")
    );
    let replaced = antrieb(LINE).and("--force").file(RECORD, &record.to_string()).on(&bench(3, 52.0, ""));
    let replaced = replaced.exits(0);
    assert!(replaced.err.contains("P.382@1ram = 12.5"), "{}", replaced.err);
    let left = left.replace("RAM", &format!("\"{}\"", new as f64 / 10.0));
    let run = |more: &str, bench: &str| antrieb(&format!("{LINE} {more}")).file(RECORD, kept).on(bench);
    let told = run("--again", &left).json().exits(0);
    let found = told.data("/steps/6/found").to_string();
    for row in ["P.417@0", "P.728@0", "P.382@1", "P.413@0"] {
        assert!(found.contains(row), "{row}: {found}");
    }
    assert!(found.contains("-> 9999"), "{found}");
    assert!(told.err.contains("broken off"), "{}", told.err);
    let now = |bench: &Bench| {
        let drive = bench.drives().next().unwrap();
        [drive.ram(417, 0), drive.ram(728, 0), drive.ram(413, 0)]
    };
    let (after, _) = witness::left().unwrap();
    assert_eq!(now(&after), [Some(9_999), Some(50), Some(0)]);
    assert!(error(&after, 3, 52.0).abs() < 0.03);
    // Who may not go on has it set back all the same, and the record says so.
    let refused = run("", &left).exits(8);
    assert!(refused.err.contains("--again"), "{}", refused.err);
    let (after, _) = witness::left().unwrap();
    assert_eq!((now(&after), after.totals().energised), ([Some(9_999), Some(50), Some(0)], 0));
    assert_eq!(after.drives().next().unwrap().ram(382, 1), Some(0));
    assert!(!refused.text_of(RECORD).contains("\"lent\""), "{}", refused.text_of(RECORD));
    // Nothing is set back under a drive that has power, and it is named.
    let powered = run("--again -v", &left.replace("\"412\" = 1", "\"412\" = 1, \"410\" = 15")).exits(8);
    assert!(powered.err.contains("(was 0.0), P.728@0ram = "), "{}", powered.err);
    assert!(!powered.sent().iter().any(|sent| sent.starts_with("01 06")), "{:?}", powered.sent());
    assert!(powered.text_of(RECORD).contains("P.417@0ram"), "{}", powered.text_of(RECORD));
}

/// A drive that refuses a limit is told with the limit.
#[test]
fn a_refused_limit_is_named() {
    let refuses = bench(3, 60.0, "") + "[[drive.event]]\nat = \"100ms\"\nrefuses = 21208\n";
    let told = antrieb(LINE).on(&refuses).json().exits(6);
    assert!(told.error()["message"].to_string().contains("P.728: "), "{}", told.error());
    // What no manual describes for a drive never goes on.
    let other = antrieb(LINE).on("[[drive]]\nmodel = \"act\"\n").json().exits(7);
    assert!(!other.error()["hint"].to_string().contains("goes on with step"), "{}", other.error());
}

/// What is too large in a try makes a wrong offset dangerous, so a dry run shows it before anybody agrees to it.
#[test]
fn a_dry_run_of_the_search_shows_its_limits_and_its_offset() {
    let line = "-a 1 --drive acu --dry-run -v procedure resolver-offset resolver-pairs=1 current=3.6A";
    let told = antrieb(line).on("[[drive]]\nmodel = \"acu\"\n").json().exits(0);
    let search = told.data("/steps").as_array().unwrap().iter().find(|step| step["step"] == "offset").unwrap();
    let meanings: Vec<_> =
        search["telegrams"].as_array().unwrap().iter().map(|one| one["meaning"].to_string()).collect();
    for (nth, param) in ["P.417@5", "P.728@5", "P.382@6"].iter().enumerate() {
        assert!(meanings[nth].contains(param), "{meanings:#?}");
    }
    assert!(told.data("/notes").to_string().contains("with offset 0 and data set 1"), "{:#}", told.value);
}
