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
/// The same drive once the nameplate stands in it.
const KNOWN: &str =
    "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"372\" = 1390, \"373\" = 2, \"375\" = 50, \"376\" = \"1.5\" }\n";
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
        ("watchdog=61s", "at most 60 s"),
        ("ramp=500Hz", "at most 100 Hz"),
        ("ramp=1000000Hz", "out of the range"),
        ("ramp=10rpm", "the unit 'rpm' does not fit"),
        ("pole-pairs=2.5", "whole number"),
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
    let notes = told.data("/notes").to_string();
    assert!(notes.contains("P.412@1ram stays 1 (was 44): contacts"), "{notes}");
    assert!(told.err.contains("such an end is agreed to here"), "{}", told.err);
    let (bench, _) = witness::left().unwrap();
    assert_eq!((bench.drives().next().unwrap().ram(412, 1), bench.totals().turning), (Some(1), 0));
}

/// What a killed run has left, by the record that it leaves: a step that was begun, and what it had set for its time.
fn killed(lent: &serde_json::Value) -> String {
    let line = format!("-a 1 procedure commission {PLATE}");
    let first = antrieb(&line).answered("y\ny\ny\nn").on(ACT).exits(1);
    let mut kept: serde_json::Value = serde_json::from_str(&first.text_of(RECORD)).unwrap();
    kept["lent"] = lent.clone();
    kept.to_string()
}

/// As a killed run leaves a drive: its record says what stood before.
#[test]
fn what_a_killed_run_has_left_goes_back_or_is_named() {
    let kept = killed(&serde_json::json!([
        { "param": 413, "name": "P.413@0ram", "data_set": 0, "old": 0, "stood": "0", "new": 2 },
        { "param": 412, "name": "P.412@1ram", "data_set": 1, "old": 44, "stood": "44", "new": 1 },
        { "param": 434, "name": "P.434@1ram", "data_set": 1, "old": 3, "stood": "3", "new": 1, "was": 2 },
    ]));
    let left = KNOWN.replace("\"412\" = 1", "\"412\" = 1, \"413\" = 2, \"434@1ram\" = 2");
    let told = antrieb(&format!("{} --again", commission(PLATE))).file(RECORD, &kept).on(&left).json();
    let told = told.exits(0);
    let found = told.data("/steps/4/found").to_string();
    let notes = told.data("/notes").to_string();
    assert!(notes.contains("P.412@1ram stays 1 (was 44)") && found.contains("P.434@1"), "{found} {notes}");
    let (bench, _) = witness::left().unwrap();
    let drive = bench.drives().next().unwrap();
    assert_eq!((drive.ram(434, 1), drive.ram(413, 0), drive.ram(412, 1)), (Some(3), Some(0), Some(1)));
}

/// P.412 that stays is named until it stands again as it was, in however many runs a record is gone on with.
#[test]
fn what_stays_is_not_forgotten_by_who_goes_on_in_two_steps() {
    let kept = killed(&serde_json::json!([
        { "param": 412, "name": "P.412@1ram", "data_set": 1, "old": 44, "stood": "44", "new": 1 },
    ]));
    let first = antrieb(&commission(PLATE)).file(RECORD, &kept).on(KNOWN).exits(8);
    assert!(first.out.contains("P.412@1ram stays 1 (was 44)"), "{}", first.out);
    let second = first.then("-a 1 --yes procedure commission --again").on(KNOWN).exits(0);
    assert!(second.out.contains("P.412@1ram stays 1 (was 44)"), "{}", second.out);
    // Also where nothing is left to do, and in the report.
    let done = second.then("-a 1 --yes procedure commission").on(KNOWN).exits(0);
    assert!(done.out.contains("P.412@1ram stays 1 (was 44)"), "{}", done.out);
    let line = format!("-a 1 --lang de report --count 5 {{dir}}/r.md --procedure {{dir}}/{RECORD}");
    let told = done.then(&line).on(KNOWN).exits(0);
    assert!(told.text_of("r.md").contains("P.412@1ram bleibt 1 (war 44)"), "{}", told.text_of("r.md"));
    // Once nothing can start it any more, it goes back.
    let open = KNOWN.replace("model = \"act\"\n", "model = \"act\"\nenable = false\n");
    let back = antrieb(&commission(PLATE)).file(RECORD, &kept).on(&open).exits(8);
    assert!(!back.text_of(RECORD).contains("\"lent\""), "{}", back.text_of(RECORD));
    assert_eq!(witness::left().unwrap().0.drives().next().unwrap().ram(412, 1), Some(44));
}

/// Only what stands as the run has set it is its own: what an operator has set since stays, is named, and is asked about before the
/// shaft turns.
#[test]
fn what_the_killed_run_did_not_leave_is_left_alone_and_named() {
    let kept = killed(&serde_json::json!([
        { "param": 413, "name": "P.413@0ram", "data_set": 0, "old": 0, "stood": "0", "new": 2 },
        { "param": 434, "name": "P.434@1ram", "data_set": 1, "old": 3, "stood": "3", "new": 2 },
    ]));
    let changed = KNOWN.replace("\"412\" = 1", "\"412\" = 1, \"413\" = 5, \"434@1ram\" = 2");
    let again = format!("{} --again", commission(PLATE));
    let told = antrieb(&again).file(RECORD, &kept).on(&changed).exits(9);
    assert!(told.err.contains("left alone: P.413@0ram = 5 (was 0)"), "{}", told.err);
    assert!(told.err.contains("`antrieb -p sim:") && told.err.contains("write 413@0ram=0`"), "{}", told.err);
    let (bench, _) = witness::left().unwrap();
    let drive = bench.drives().next().unwrap();
    assert_eq!((drive.ram(413, 0), drive.ram(434, 1)), (Some(5), Some(3)));
    assert_eq!(bench.totals().energised, 0);
    // It was told, so that who goes on then knows it, and what a run of his sets goes back to the 5.
    let noted = told.text_of(RECORD);
    let on = told.then("-a 1 --yes procedure commission --again").on(&changed).json().exits(0);
    assert!(on.data("/notes").to_string().contains("P.413@0ram was left alone at 5"), "{:#}", on.value);
    assert_eq!(witness::left().unwrap().0.drives().next().unwrap().ram(413, 0), Some(5));
    // Who sets what stood before has it struck out.
    let set = antrieb(&again).file(RECORD, &noted).on(KNOWN).json().exits(0);
    assert!(*set.data("/notes") == serde_json::json!([]), "{:#}", set.value);
    // A record that is replaced takes with it what it knew.
    let anew = antrieb(&commission(PLATE)).and("--force").file(RECORD, &kept).on(KNOWN).exits(0);
    assert!(anew.err.contains("P.413@0ram = 0, P.434@1ram = 3"), "{}", anew.err);
}

/// A record is a file that anybody can change: what the procedure never sets is not set back, and what cannot have stood there is not
/// either. A control word that a record calls lent would start the shaft.
#[test]
fn what_the_procedure_never_sets_is_refused_before_anything_is_sent() {
    let row = |param: u32, place: &str, old: i64, new: i64| {
        let data_set: u8 = place[..1].parse().unwrap();
        let (name, stood) = (format!("P.{param}@{place}"), old.to_string());
        serde_json::json!({ "param": param, "name": name, "data_set": data_set, "old": old, "stood": stood, "new": new })
    };
    let watchdog = || row(413, "0ram", 0, 2);
    let with = |key: &str, value: serde_json::Value| {
        let mut row = watchdog();
        row[key] = value;
        row
    };
    for (lent, words) in [
        (row(410, "0ram", 15, 0), ["P.410@0ram back to 15", "P.410@0ram auf 15"]),
        (row(34, "0ram", 123, 0), ["P.34@0ram back to 123", "P.34@0ram auf 123"]),
        (row(480, "1ram", 20, 0), ["P.480@1ram back to", "P.480@1ram auf"]),
        // What another procedure sets is not this one's.
        (row(417, "0ram", 9_999, 500), ["P.417@0ram back to 9999", "P.417@0ram auf 9999"]),
        (row(413, "0ram", 99_999, 2), ["99999", "99999"]),
        (row(434, "1ram", 7, 2), ["P.434@1ram back to 7", "P.434@1ram auf 7"]),
        // Under 1 the control word counts, whatever stands in it: a run goes there, and never comes from elsewhere.
        (row(412, "1ram", 1, 0), ["P.412@1ram back to 1 where it is 0", "P.412@1ram auf 1 zurückstellen, wo 0 steht"]),
        (with("data_set", 9.into()), ["calls it P.413@0ram", "nennt das P.413@0ram"]),
        (with("name", "P.410".into()), ["calls it P.410", "nennt das P.410"]),
        (with("stood", "0 410=15".into()), ["calls it P.413@0ram = 0 410=15", "nennt das P.413@0ram = 0 410=15"]),
    ] {
        let kept = killed(&serde_json::json!([watchdog(), lent]));
        for (lang, word) in ["en", "de"].into_iter().zip(words) {
            let line = format!("--lang {lang} -v {} --again", commission(PLATE));
            let told = antrieb(&line).file(RECORD, &kept).on(KNOWN).exits(7);
            assert!(told.err.contains(word) && told.err.contains("commission"), "{word}: {}", told.err);
            assert!(told.sent().is_empty(), "{word}: {:?}", told.sent());
            assert_eq!(told.text_of(RECORD), kept);
        }
    }
}

/// Who goes on asks again who answers: what was proven of one drive is no proof of another, and nothing is set back in it.
#[test]
fn a_record_does_not_go_on_with_another_drive() {
    let kept = killed(&serde_json::json!([
        { "param": 413, "name": "P.413@0ram", "data_set": 0, "old": 0, "stood": "0", "new": 2 },
    ]));
    for (other, word) in [
        (KNOWN.replace("1390", "1000").replace("\"412\" = 1", "\"412\" = 1, \"413\" = 2"), "P.372@0 is 1000"),
        (KNOWN.replace("model = \"act\"", "model = \"acu\""), "a drive of the family acu answers"),
        ("[[drive]]\nmodel = \"lxm05\"\n".to_owned(), "a drive of the family lxm05 answers"),
        (KNOWN.replace("model = \"act\"", "model = \"act\"\nmodules = [\"EM-RES-03\"]"), "option modules: EM-RES-03"),
    ] {
        let told = antrieb(&format!("{} --again -v", commission(PLATE))).file(RECORD, &kept).on(&other).exits(7);
        assert!(told.err.contains(word), "{word}: {}", told.err);
        assert!(!told.sent().iter().any(|sent| sent.starts_with("01 06") || sent.starts_with("01 10")), "{word}");
        let now: serde_json::Value = serde_json::from_str(&told.text_of(RECORD)).unwrap();
        let before: serde_json::Value = serde_json::from_str(&kept).unwrap();
        assert_eq!(now, before, "{word}");
    }
}

/// What the drive itself bounds is looked at before anything is written, and long before the shaft turns.
#[test]
fn a_ramp_that_the_drive_does_not_reach_is_refused_before_anything_turns() {
    let told = antrieb(&commission(&format!("{PLATE} ramp=80Hz"))).and("-v").on(ACT).exits(7);
    assert!(told.err.contains("80.00 Hz is above the limit P.419") && !told.err.contains("[3/9]"), "{}", told.err);
    assert!(!told.err.contains("--force sends it"), "{}", told.err);
    assert!(!told.sent().iter().any(|sent| sent.starts_with("01 06")), "{:?}", told.sent());
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
    let again = first.then("-a 1 -v --yes procedure commission").on(KNOWN).exits(8);
    assert!(again.err.contains("with --again repeats step 5 of 9"), "{}", again.err);
    assert!(!again.sent().iter().any(|sent| sent.starts_with("01 06")), "{:?}", again.sent());
    let on = again.then("-a 1 --yes procedure commission --again").on(KNOWN).exits(0);
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
        // One who interrupts as the run ends by itself makes its stop a harder one, behind which nothing may show a standstill.
        let unseen = failure.code == "forbidden.standstill_unproven" && failure.alarm;
        assert!(failure.class.exit() == 130 || unseen, "{step}: {failure:?}");
        let mut later = seen.bench.clone();
        later.advance(seen.at + Span::from_secs(12));
        assert_eq!(later.totals().turning, 0, "{step}: {failure:?}");
        let moved = kept.contains("\"begun\"") || (kept.contains("\"failed\"") && kept.contains("\"turns\": true"));
        // The drive without the fault: the same command goes on, but for what moves and was begun.
        let again = interrupted(directory.path(), KNOWN, PLATE, usize::MAX);
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
