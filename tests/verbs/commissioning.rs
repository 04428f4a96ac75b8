//! `procedure commission`: nameplate, direction, ramp, stop, watchdog by silence, reset. Every end is tried at every step, and
//! the bench itself is asked what turns.

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

const ACT: &str = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1 }\n";
const PLATE: &str = "power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm";
const RECORD: &str = "procedure-commission-1.json";
const STEPS: [&str; 9] = ["ready", "answer", "nameplate", "store", "direction", "ramp", "stop", "silence", "reset"];

fn commission(plate: &str) -> String {
    format!("-a 1 --yes procedure commission {plate}")
}

#[test]
fn a_motor_is_commissioned_end_to_end() {
    for model in ["act", "acu"] {
        let bench = ACT.replace("act", model);
        let told = antrieb(&commission(PLATE)).on(&bench).json().exits(0);
        assert!(told.data("/complete") == true, "{:#}", told.value);
        let step = |nth: usize| told.data(&format!("/steps/{nth}"));
        assert_eq!((0..9).map(|nth| step(nth)["step"].as_str().unwrap()).collect::<Vec<_>>(), STEPS);
        let found = |nth: usize| step(nth)["found"].to_string();
        assert!(found(2).contains("2 pole pairs, slip 7.3 %") && found(2).contains("60.1 %"), "{}", found(2));
        assert!(
            found(3).contains("P.372@0 Rated Speed") && found(3).contains("to be set at the keypad"),
            "{}",
            found(3)
        );
        assert!(found(4).contains("stop (ramp) proven, at standstill"), "{}", found(4));
        // The bench runs up and down with 5 Hz/s.
        assert!(found(5).contains("up in 4") && found(5).contains(": 4."), "{}", found(5));
        assert!(found(6).contains("stop (quick-stop) proven, at standstill"), "{}", found(6));
        assert!(found(7).contains("F2010"), "{}", found(7));
        let (bench, _) = witness::left().unwrap();
        let totals = bench.totals();
        assert_eq!((totals.turning, totals.energised), (0, 0), "{model}");
        let remarks: Vec<_> = bench.remarks().iter().map(ToString::to_string).collect();
        assert!(remarks.is_empty(), "{remarks:?}");
        // What a run changes in RAM is given back.
        let drive = bench.drives().next().unwrap();
        assert_eq!((drive.ram(413, 0), drive.ram(412, 0)), (Some(0), Some(1)), "{model}");
    }
}

#[test]
fn a_nameplate_that_cannot_be_so_is_refused_with_words_before_anything_is_sent() {
    for (plate, word, german) in [
        ("power=15kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm", "more than the motor takes", "mehr, als"),
        ("power=0.2kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm", "only 8.0 %", "nur 8.0 %"),
        (
            "power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=3100rpm",
            "no motor turns faster than 3000",
            "3000",
        ),
        ("power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=1150rpm", "23.3 %", "23.3 %"),
        (
            "power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm pole-pairs=4",
            "of 2 pole pairs, not of 4",
            "mit 2",
        ),
        ("power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm cos-phi=1.4", "at most 1", "höchstens 1"),
        (
            "power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm cos-phi=0.5",
            "more than the motor takes",
            "1.25",
        ),
        ("power=1.5V voltage=400V current=3.6A frequency=50Hz speed=1390rpm", "above 0 kW", "über 0 kW"),
        ("power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm data-set=5", "0 to 4", "0 bis 4"),
        ("power=1.5kW voltage=400V current=3.6A frequency=50Hz speed=1390rpm test=fast", "test", "test"),
    ] {
        for (lang, word) in [("en", word), ("de", german)] {
            let told = antrieb(&commission(plate)).on(ACT).and(&format!("-v --lang {lang}")).exits(7);
            assert!(told.err.contains(word), "{plate}: {}", told.err);
            assert!(told.sent().is_empty() && !told.directory().join(RECORD).exists(), "{plate}");
        }
    }
    let told = antrieb("-a 1 --yes procedure commission power=1.5kW").on(ACT).and("-v").exits(2);
    assert!(told.err.contains("voltage (") && told.sent().is_empty(), "{}", told.err);
    let servo = antrieb(&commission(PLATE)).and("--drive lxm05").on("[[drive]]\nmodel = \"lxm05\"\n").exits(7);
    assert!(servo.err.contains("no manual describes"), "{}", servo.err);
}

/// A test at which nothing turns proves nothing, a fast one is none at low speed, and 0 is no watchdog.
#[test]
fn a_test_that_proves_nothing_is_refused_before_anything_is_sent() {
    for (given, word) in [
        ("test=0Hz", "1 to 10 Hz"),
        ("test=0.2Hz", "1 to 10 Hz"),
        ("test=45Hz", "1 to 10 Hz"),
        ("test=-5Hz", "1 to 10 Hz"),
        ("ramp=4Hz", "more than the frequency of the tests"),
        ("watchdog=0s", "0 would be no watchdog"),
        ("watchdog=1500ms", "whole multiple of 1 s"),
    ] {
        let told = antrieb(&commission(&format!("{PLATE} {given}"))).on(ACT).and("-v").exits(7);
        assert!(told.err.contains(word) && told.sent().is_empty(), "{given}: {}", told.err);
        assert!(!told.directory().join(RECORD).exists(), "{given}");
    }
}

/// A drive from the factory, whose contacts are closed: behind the reset of a fault they could start it under its own P.412.
#[test]
fn a_control_mode_that_must_stay_is_asked_for_and_is_an_agreed_end() {
    let bench = "[[drive]]\nmodel = \"acu\"\ntorque = 20\nset = { \"418\" = 0, \"412\" = 44 }\n";
    let told = antrieb(&commission(PLATE)).on(bench).json().exits(0);
    assert!(told.data("/complete") == true, "{:#}", told.value);
    let found = told.data("/steps/8/found").to_string();
    assert!(found.contains("P.412@1ram stays 1 (was 44), as agreed"), "{found}");
    assert!(told.err.contains("such an end is agreed to here"), "{}", told.err);
    let (bench, _) = witness::left().unwrap();
    assert_eq!((bench.drives().next().unwrap().ram(412, 1), bench.totals().turning), (Some(1), 0));
}

/// As a killed run leaves a drive: its record says what stood before.
#[test]
fn what_a_killed_run_has_left_goes_back_or_is_named() {
    let line = format!("-a 1 procedure commission {PLATE}");
    let first = antrieb(&line).answered("y\ny\ny\nn").on(ACT).exits(1);
    let mut kept: serde_json::Value = serde_json::from_str(&first.text_of(RECORD)).unwrap();
    kept["lent"] = serde_json::json!([
        { "param": 413, "name": "P.413@0ram", "data_set": 0, "old": 0, "new": 2 },
        { "param": 412, "name": "P.412@1ram", "data_set": 1, "old": 44, "new": 1 },
        { "param": 434, "name": "P.434@1ram", "data_set": 1, "old": 3, "new": 2 },
    ]);
    let left = ACT.replace("\"412\" = 1", "\"412\" = 1, \"413\" = 2, \"434@1ram\" = 2");
    let told = antrieb(&format!("{} --again", commission(PLATE))).file(RECORD, &kept.to_string()).on(&left).json();
    let told = told.exits(0);
    let found = told.data("/steps/4/found").to_string();
    assert!(found.contains("P.412@1ram stays 1 (was 44)") && found.contains("P.434@1"), "{found}");
    let (bench, _) = witness::left().unwrap();
    let drive = bench.drives().next().unwrap();
    assert_eq!((drive.ram(434, 1), drive.ram(413, 0), drive.ram(412, 1)), (Some(3), Some(0), Some(1)));
}

#[test]
fn a_data_set_in_which_the_drive_does_not_work_is_not_tested() {
    let told = antrieb(&commission(&format!("{PLATE} data-set=2"))).on(ACT).json().exits(8);
    assert_eq!(told.error()["code"], "forbidden.data_set");
    assert!(told.data("/steps/3/found").to_string().contains("P.372@2"), "{:#}", told.value);
    let selected = ACT.replace("\"412\" = 1", "\"412\" = 1, \"414\" = 2");
    antrieb(&commission(&format!("{PLATE} data-set=2"))).on(&selected).json().exits(0);
}

#[test]
fn the_wrong_way_ends_it_and_is_not_repeated_unasked() {
    let line = format!("-a 1 procedure commission {PLATE}");
    let first = antrieb(&line).answered("y\ny\ny\nn").on(ACT).exits(1);
    assert!(first.err.contains("turns the wrong way") && first.err.contains("two motor phases"), "{}", first.err);
    let again = first.then("-a 1 -v --yes procedure commission").on(ACT).exits(8);
    assert!(again.err.contains("with --again repeats step 5 of 9"), "{}", again.err);
    assert!(!again.sent().iter().any(|sent| sent.starts_with("01 06")), "{:?}", again.sent());
    let on = again.then("-a 1 --yes procedure commission --again").on(ACT).exits(0);
    assert!(!on.err.contains("[4/9]") && on.err.contains("[5/9]"), "{}", on.err);
}

#[test]
fn the_other_direction_is_tried_where_it_is_wanted() {
    let told = antrieb(&commission(&format!("{PLATE} reverse=yes"))).on(ACT).json().exits(0);
    let motions = told.data("/steps/4/motions").as_array().unwrap();
    let ways: Vec<_> = motions.iter().map(|motion| motion["setpoint"]["value"].as_f64().unwrap()).collect();
    assert_eq!(ways, [5.0, -5.0]);
    assert!(told.err.contains("Was that counter-clockwise?"), "{}", told.err);
    let no = antrieb(&commission(PLATE)).on(ACT).json().exits(0);
    assert_eq!(no.data("/steps/4/motions").as_array().unwrap().len(), 1);
    let told = antrieb(&commission(&format!("{PLATE} reverse=maybe"))).on(ACT).and("-v").exits(7);
    assert!(told.err.contains("expected yes or no") && told.sent().is_empty(), "{}", told.err);
}

#[test]
fn without_a_watchdog_nothing_turns() {
    // The drive refuses P.413 in RAM: data set 5.
    let refuses = format!("{ACT}[[drive.event]]\nat = \"0s\"\nrefuses = {}\n", 5 * 4096 + 413);
    let told = antrieb(&commission(PLATE)).on(&refuses).json().exits(6);
    assert!(told.data("/steps/4/result") == "failed", "{:#}", told.value);
    let totals = witness::left().unwrap().0.totals();
    assert_eq!((totals.turning, totals.energised), (0, 0));
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
    telegrams: usize,
    failure: Option<Failure>,
    bench: Bench,
    at: Tick,
}

/// A commission in a directory, interrupted at a telegram.
fn interrupted(directory: &Path, bench: &str, more: &str, step: usize) -> Seen {
    let file = directory.join("bench.toml");
    std::fs::write(&file, bench).unwrap();
    let line = format!("antrieb -p sim:{} --drive act -a 1 --yes procedure commission {more}", file.display());
    let cli = Cli::parse_from(line.split_whitespace());
    let environment = Environment { directory: directory.to_owned(), ..Environment::default() };
    let settings = Settings { verbose: true, ..Settings::resolve(&cli.globals, &environment).unwrap() };
    let (interrupt, mut telegrams) = (Interrupt::default(), 0);
    let wish = interrupt.clone();
    let mut observe = |event: Event| {
        if matches!(event, Event::Telegram { .. }) {
            telegrams += 1;
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
    let (bench, at) = witness::left().unwrap();
    Seen { telegrams, failure: outcome.failure, bench, at }
}

#[test]
fn whoever_interrupts_anywhere_leaves_nothing_turning_and_what_moved_is_not_repeated_unasked() {
    let whole = tempfile::tempdir().unwrap();
    let length = interrupted(whole.path(), ACT, PLATE, usize::MAX).telegrams;
    let mut refused = 0;
    for step in (1..length).step_by(length / 60) {
        let directory = tempfile::tempdir().unwrap();
        let seen = interrupted(directory.path(), ACT, PLATE, step);
        let kept = std::fs::read_to_string(directory.path().join(RECORD)).unwrap_or_default();
        let Some(failure) = seen.failure else {
            // Behind the proof of the last step nothing is left to interrupt.
            let all_done = kept.matches("\"result\": \"done\"").count() == STEPS.len();
            assert!(all_done && seen.bench.totals().turning == 0, "{step} of {length}: nobody heard of it");
            continue;
        };
        assert_eq!(failure.class.exit(), 130, "{step}: {failure:?}");
        let mut later = seen.bench.clone();
        later.advance(seen.at + Span::from_secs(12));
        assert_eq!(later.totals().turning, 0, "{step}: {failure:?}");
        let moved = kept.contains("\"begun\"") || (kept.contains("\"failed\"") && kept.contains("\"turns\": true"));
        // On a fresh bench: the same command goes on, but for what moves and was begun.
        let again = interrupted(directory.path(), ACT, PLATE, usize::MAX);
        let code = again.failure.as_ref().map(|failure| failure.code.clone());
        if moved && code.as_deref() == Some("forbidden.again") {
            refused += 1;
            let totals = again.bench.totals();
            assert_eq!((totals.turning, totals.energised), (0, 0), "{step}");
        } else {
            // The fault of the watchdog is gone with the bench.
            assert!(code.is_none() || kept.contains("\"silence\""), "{step}: {:?}\n{kept}", again.failure);
        }
    }
    assert!(refused > 20, "{refused}");
}
