//! `scan` of a line whose setting nobody knows: the likely first, an estimate that holds, an end that is kept to.

use super::scanning::{Played, drives, play};
use crate::agreeable::Agreeable;
use crate::run::{antrieb, check_document};
use antrieb::args::{Addresses, Environment, Globals, Settings, Unknown as Sought};
use antrieb::command::{Context, VERBS, scan};
use antrieb::drive::{Interrupt, Manner, ScanPlan, Unknown};
use antrieb::outcome::{Data, Decimal, Event, Outcome};
use antrieb::profile::{Lang, Registry};
use antrieb::render::{self, Console, Format};
use antrieb::tick::Span;
use serde_json::Value;

const EVERYTHING: Unknown = Unknown { baud: true, parity: true, protocol: true };
const BAUD: Unknown = Unknown { baud: true, parity: false, protocol: false };

fn all(unknown: Unknown) -> ScanPlan {
    ScanPlan { unknown, ..ScanPlan::new(1..=247) }
}

fn slow_pair() -> String {
    drives(&[(12, "baud = 2400"), (60, "baud = 2400")])
}

fn seconds(decimal: Decimal) -> f64 {
    decimal.raw as f64 / 10f64.powi(decimal.decimals.into())
}

fn babble(pattern: &str, by: &str) -> String {
    format!("[[disturb]]\nkind = \"babble\"\npattern = \"{pattern}\"\nby = \"{by}\"\nat = \"10ms\"\n")
}

/// 212 s before the first was found, and 449 s to the end.
#[test]
fn drives_at_2400_baud_with_addresses_12_and_60_have_a_verdict_in_bounded_time() {
    let most = |played: &Played| seconds(played.news[0].at_most_s);
    for (unknown, found_by, whole) in [(BAUD, 35, 75), (EVERYTHING, 85, 480)] {
        let played = play(&slow_pair(), &all(unknown));
        assert_eq!(played.addresses(), [12, 60]);
        let last = played.found.last().unwrap().0;
        assert!(last < Span::from_secs(found_by), "{last}");
        assert!(played.took < Span::from_secs(whole), "{}", played.took);
        assert!(played.took.as_millis() as f64 / 1e3 < most(&played), "{} of {}", played.took, most(&played));
        // The help says so.
        assert!(unknown == BAUD || (450.0..480.0).contains(&seconds(played.news[0].left_s)) && most(&played) < 960.0);
        let hasty = ScanPlan { within: Some(Span::from_secs(90)), ..all(unknown) };
        let hasty = play(&slow_pair(), &hasty);
        assert_eq!(hasty.addresses(), [12, 60], "the likely first");
        assert!(hasty.took < Span::from_secs(91), "{}", hasty.took);
        assert_eq!(hasty.result.is_over_time, unknown == EVERYTHING);
    }
}

/// The reports past the first few whose estimate is off by more than half of what really came.
fn wrong(played: &Played) -> Vec<String> {
    const FEW: usize = 8;
    let took = played.took.as_micros() as f64 / 1e6;
    let rest = |t: Decimal| took - seconds(t);
    let told = played.news.iter().skip(FEW);
    // Near the end nobody can tell how often noise will meet those of the last setting, or the look at a find: a twentieth of the
    // whole search.
    let slack = (took / 20.0).max(2.0);
    let off = told.filter(|news| (seconds(news.left_s) - rest(news.t)).abs() > (rest(news.t) / 2.0).max(slack));
    off.map(|news| format!("at {} s: {} s left, {:.1} s came", seconds(news.t), seconds(news.left_s), rest(news.t)))
        .collect()
}

#[test]
fn at_every_report_past_the_first_few_the_estimate_holds_within_half() {
    let odd = "baud = 57600\nparity = \"odd\"";
    let last = "baud = 2400\nparity = \"odd\"\nprotocol = \"ascii\"";
    let lines = [
        ("empty", slow_pair() + "[[disturb]]\nevery = 1\nkind = \"lost\"\n"),
        ("one of another kind", drives(&[(200, odd)])),
        ("the last one of all", drives(&[(247, last)])),
        ("two slow ones", slow_pair()),
        ("a late one", drives(&[(5, "reply_delay = \"310ms\"")])),
        ("two with one address", drives(&[(1, odd), (1, odd), (77, odd)])),
        ("a byte every 5 s", slow_pair() + &babble("55", "5s")),
        ("a byte every 700 ms", slow_pair() + &babble("55", "700ms")),
        ("a byte every 200 ms", slow_pair() + &babble("55", "200ms")),
        ("a byte every 60 ms", slow_pair() + &babble("55", "60ms")),
        ("a byte every 25 ms", slow_pair() + &babble("55", "25ms")),
        ("never silent", slow_pair() + &babble("55", "12ms")),
        ("replies lost", slow_pair() + "[[disturb]]\nevery = 2\nkind = \"lost\"\n"),
        ("replies garbled", slow_pair() + "[[disturb]]\nevery = 1\nkind = \"garbled\"\n"),
    ];
    // Everything takes the machine some seconds; what differs between lines shows with seven settings, too.
    let whole = ["the last one of all", "a byte every 700 ms"];
    for (name, bench) in lines {
        for unknown in [BAUD, EVERYTHING].into_iter().filter(|&unknown| unknown == BAUD || whole.contains(&name)) {
            let played = play(&bench, &all(unknown));
            println!("{name}: {} of {} s", played.took, seconds(played.news[0].at_most_s));
            assert!(played.news.len() > 5 || name == "never silent", "{name}");
            assert_eq!(wrong(&played), [""; 0], "{name}, {unknown:?}");
            // The looks at what answers come on top: here two.
            let most = seconds(played.news[0].at_most_s) + 2.0 * 30.0;
            assert!((played.took.as_millis() as f64) / 1e3 < most, "{name}: {} of {most} s", played.took);
        }
    }
}

#[test]
fn a_setting_is_told_with_its_number_and_what_came_of_it() {
    let played = play(&slow_pair(), &all(BAUD));
    let first = &played.news[0];
    assert_eq!((first.setting, first.settings, first.rounds, first.found), (0, 7, 4, 0));
    let over: Vec<_> = played.news.iter().filter(|news| news.is_over).collect();
    let rounds: Vec<_> = over.iter().map(|news| (news.round, news.setting)).collect();
    let mut expected: Vec<_> = (1..=4).flat_map(|round| (1..=7).map(move |setting| (round, setting))).collect();
    // Where 12 was found the rest follows at once, so the last round has nothing to do there.
    assert_eq!(expected.pop(), Some((4, 7)));
    expected.push((4, 7));
    expected.sort_by_key(|&(round, setting)| if (round, setting) == (4, 7) { (3, 8) } else { (round, setting) });
    assert_eq!(rounds, expected);
    let asked: Vec<_> = over.iter().filter(|news| news.setting == 7).map(|news| news.asked_here.as_str()).collect();
    assert_eq!(asked, ["1", "2-10", "1,4-32", "33-247"], "who has had his time in the second round is not asked again");
    let found: Vec<_> = over.iter().filter(|news| !news.found_here.is_empty()).collect();
    let found: Vec<_> = found.iter().map(|news| (news.line.as_str(), news.found_here.clone(), news.found)).collect();
    assert_eq!(found, [("2400 8E1", vec![12], 1), ("2400 8E1", vec![60], 2)]);
    // A setting that takes long is told of every second.
    let times: Vec<f64> = played.news.iter().map(|news| seconds(news.t)).collect();
    assert!(times.windows(2).all(|two| two[1] - two[0] < 1.6), "{times:?}");
}

/// Two drives from the factory on one line are heard as garbage at address 1.
#[test]
fn where_garbage_came_everybody_is_asked_before_the_next_round() {
    let setting = "baud = 4800\nparity = \"none\"";
    let bench = drives(&[(1, setting), (1, setting), (200, setting)]);
    let played = play(&bench, &all(EVERYTHING));
    assert_eq!(played.addresses(), [200]);
    let found = played.found[0].0;
    assert!(found < Span::from_secs(15), "{found}");
    assert!(
        played.result.warnings.iter().any(|warning| warning.code == "scan.same_address"),
        "{:?}",
        played.result.warnings
    );
}

#[test]
fn a_fast_search_ends_with_the_first_setting_that_has_a_drive() {
    let plan = ScanPlan { manner: Manner::Fast, ..all(EVERYTHING) };
    let played = play(&slow_pair(), &plan);
    assert_eq!(played.addresses(), [12, 60]);
    assert!(played.took < Span::from_secs(75), "{}", played.took);
}

/// A search of everything that is interrupted after so much time; with what it prints.
fn interrupted(after: Span) -> (Outcome, Value) {
    let directory = tempfile::tempdir().unwrap();
    let path = directory.path().join("bench.toml");
    std::fs::write(&path, slow_pair()).unwrap();
    let flags = Globals { port: vec![format!("sim:{}", path.display()).parse().unwrap()], ..Globals::default() };
    let settings = Settings::resolve(&flags, &Environment::default()).unwrap();
    let unknown = Sought { baud: true, parity: true, protocol: true };
    let settings = Settings { addresses: Addresses::Unnamed, unknown, ..settings };
    let (registry, interrupt) = (Registry::open(&[]).unwrap(), Interrupt::default());
    let pressed = interrupt.clone();
    let mut observe = |event| {
        if matches!(event, Event::Sought(news) if seconds(news.t) * 1e6 >= after.as_micros() as f64) {
            pressed.raise();
        }
    };
    let mut ask = Agreeable;
    let mut context = Context {
        settings: &settings,
        registry: &registry,
        ask: &mut ask,
        observe: &mut observe,
        interrupt,
        sheet: antrieb::render::sheet,
        calls: None,
    };
    let runtime = tokio::runtime::Builder::new_current_thread().build().unwrap();
    let outcome = runtime.block_on(scan::run(&scan::Args::default(), &mut context)).unwrap();
    let (mut out, console) = (Vec::new(), Console::new(Box::new(std::io::sink()), Lang::En, true, false));
    let manner = render::Manner::of(Lang::En);
    render::print(&outcome, "scan", Format::Json, manner, &mut out, &console).unwrap();
    (outcome, serde_json::from_slice(&out).unwrap())
}

#[test]
fn an_interrupted_search_tells_what_was_covered_and_what_was_not() {
    let (outcome, document) = interrupted(Span::from_secs(40));
    check_document(&document, 130);
    let Some(Data::Scan(found)) = &outcome.data else { panic!("no data") };
    assert_eq!(
        (found.settings, found.settings_done, found.complete, found.drives.len()),
        (49, 3, false, 0),
        "VABus has 30"
    );
    let left = document["data"]["left_s"].as_u64().unwrap();
    assert!((300..500).contains(&left), "{left}");
    let searches = document["data"]["searches"].as_array().unwrap();
    assert_eq!(searches.len(), 49, "also what was not asked");
    assert_eq!((&searches[0]["asked"], &searches[0]["open"]), (&"1-32".into(), &"33-247".into()));
    assert_eq!((&searches[48]["asked"], &searches[48]["open"]), (&"2-5".into(), &"1,6-247".into()));
    let told = outcome.warnings.iter().find(|warning| warning.code == "scan.open").unwrap().message.get(Lang::En);
    assert!(told.starts_with("asked to the end: 1-32 at ") && told.contains("left open: 33-247 at "), "{told}");
    let german = outcome.warnings[0].message.get(Lang::De);
    assert!(german.starts_with("zu Ende gefragt: 1-32 mit ") && german.contains("offen: 33-247 mit "), "{german}");
    let failure = outcome.failure.unwrap();
    let message = failure.message.get(Lang::En);
    assert!(
        message.starts_with("interrupted; ")
            && message.contains(" of 10584 addresses had their full time to answer")
            && message.contains("; what is left takes about "),
        "{message}"
    );
}

#[test]
fn a_search_within_a_time_ends_then_with_a_verdict() {
    let run = |within: &str| antrieb(&format!("--baud auto --parity auto scan --within {within}")).on(&slow_pair());
    let none = run("10s").json().exits(1);
    assert_eq!(none.error()["code"], "no.drive_found");
    assert!(none.error()["message"].as_str().unwrap().contains("within 10"), "{}", none.error());
    assert!(none.warnings().contains(&"scan.open"));
    assert_eq!(none.data("/complete"), false);
    let some = run("90s").json().exits(0);
    assert_eq!(some.data("/drives").as_array().unwrap().len(), 2);
    let known = antrieb("-p sim scan --within 1s").json().exits(0);
    assert_eq!(known.data("/complete"), false);
    run("10s").and("--lang de").exits(1);
}

/// Neither listening before the first byte nor looking at many finds, each of which answers late, puts off an end that was
/// named: behind it comes what is on the wire, and nothing is asked any more.
#[test]
fn a_time_that_was_named_is_kept_whatever_the_line_brings() {
    const WORD: Span = Span::from_secs(4);
    let slow: Vec<_> = (1..=30).map(|address| (address, "reply_delay = \"400ms\"")).collect();
    let odd: Vec<_> = (1..=30).map(|address| (address, "baud = 9600\nreply_delay = \"300ms\"")).collect();
    let lines = [
        ("late drives", drives(&slow), BAUD),
        ("late drives at a setting that is known", drives(&slow), Unknown::default()),
        ("late drives elsewhere", drives(&odd), EVERYTHING),
        ("somebody speaks at every setting", slow_pair() + &babble("55", "60ms"), EVERYTHING),
        ("a line that is never silent", slow_pair() + &babble("55", "12ms"), EVERYTHING),
        ("another master", slow_pair() + &babble("master", "50ms"), EVERYTHING),
        ("garbled", drives(&slow) + "[[disturb]]\nevery = 1\nkind = \"garbled\"\n", BAUD),
    ];
    for (name, bench, unknown) in lines {
        for manner in [Manner::Usual, Manner::Fast, Manner::Thorough] {
            let plan = ScanPlan { within: Some(WORD), manner, force: true, ..all(unknown) };
            let played = play(&bench, &plan);
            println!("{name}, {manner:?}: {}", played.took);
            assert!(played.took < WORD + Span::from_millis(1_500), "{name}, {manner:?}: {}", played.took);
            assert!(played.result.is_over_time || played.took < WORD, "{name}, {manner:?}");
        }
    }
}

/// Who answered and could not be asked more is told, as no drive that is known, and asked again by whoever goes on.
#[test]
fn who_answers_at_the_end_of_a_time_is_told_as_left_open() {
    let bench = drives(&[(1, "reply_delay = \"400ms\"")]);
    let hasty = antrieb("-a 1-3 scan --within 500ms --json").on(&bench).exits(0);
    let told: Value = serde_json::from_str(&hasty.out).unwrap();
    let drive = &told["data"]["drives"][0];
    assert_eq!((&drive["address"], &drive["drive"]), (&1.into(), &"unknown".into()), "{drive:#}");
    assert_eq!(drive["title"], "answered; the time was over before it was asked what it is");
    assert_eq!((&told["data"]["complete"], &told["data"]["searches"][0]["open"]), (&false.into(), &"1-3".into()));
    let going_on = "-p sim:{dir}/bench.toml -a 1-3 scan --resume {dir}/before.json";
    let before = hasty.out.clone();
    let whole = hasty.then(going_on).file("before.json", &before).json().exits(0);
    let drives: Vec<_> = whole.data("/drives").as_array().unwrap().iter().map(|drive| drive["drive"].clone()).collect();
    assert_eq!(drives, ["act"], "{:#}", whole.value);
    antrieb("--lang de -a 1-3 scan --within 500ms").on(&bench).exits(0);
}

/// What another search has left open at settings that are not sought now is not done.
#[test]
fn who_goes_on_seeks_what_was_sought() {
    let auto = "--baud auto --parity auto --protocol auto";
    let bench = drives(&[(60, "baud = 2400")]);
    let begun = antrieb(&format!("{auto} scan --within 5s --json")).on(&bench).run();
    let before = begun.out.clone();
    let refused = begun.then("-p sim:{dir}/bench.toml scan --resume {dir}/o.json").file("o.json", &before).exits(2);
    assert!(refused.err.contains(&format!("repeat {auto}")), "{}", refused.err);
    let in_part = "-p sim:{dir}/bench.toml --baud auto --protocol auto scan --resume {dir}/o.json";
    assert!(refused.then(in_part).file("o.json", &before).exits(2).err.contains("repeat --parity auto"));
}

#[test]
fn in_a_pipe_every_setting_is_a_line_and_with_ndjson_a_record() {
    let run = |more: &str| antrieb(&format!("--baud auto -a 1-40 {more} scan")).on(&slow_pair());
    for (lang, first, each) in [
        (
            "en",
            "7 settings, the likeliest first, in 4 rounds: about ",
            "2/7, round 1/4: 9600 8E1 rtu, 1: nobody; found 0, about ",
        ),
        (
            "de",
            "7 Einstellungen, die wahrscheinlichsten zuerst",
            "2/7, Runde 1/4: 9600 8E1 rtu, 1: niemand; gefunden 0, noch ",
        ),
    ] {
        let err = run(&format!("--lang {lang}")).exits(0).err;
        assert!(
            err.lines().next().unwrap().contains(["listening first", "zugehört"][usize::from(lang == "de")]),
            "{err}"
        );
        assert!(err.lines().nth(1).unwrap().starts_with(first), "{err}");
        assert!(err.lines().any(|line| line.starts_with(each)), "{err}");
    }
    assert_eq!(run("-q").exits(0).err, "");
    let without = run("--no-progress").exits(0).err;
    assert!(without.lines().count() == 4 && without.contains("found act at 12"), "{without}");
    assert!(without.contains("note: all addresses at 2400 8E1 rtu had their turn"), "{without}");
    let output = run("--format ndjson").exits(0);
    let records: Vec<Value> = output.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let schema = (VERBS.iter().find(|verb| verb.name == "scan").unwrap().schema)();
    let validator = jsonschema::validator_for(&schema).unwrap();
    let searches: Vec<_> = records.iter().filter(|record| record["type"] == "search").collect();
    assert_eq!(searches.len(), 1 + 7 * 4, "before it begins, and after each setting in each round");
    assert!(searches.iter().all(|record| validator.is_valid(record)), "{searches:#?}");
    assert_eq!(searches[1]["asked_here"], "1");
    assert_eq!(records.iter().filter(|record| record["type"] == "drive").count(), 1);
    assert_eq!(records.last().unwrap()["type"], "end");
    // Who asks one setting has nothing to be told.
    let known = antrieb("-p sim -a 1-3 scan --format ndjson").exits(0).out;
    assert!(!known.contains("\"search\""), "{known}");
}

#[test]
fn nothing_is_sent_to_a_line_on_which_another_master_asks() {
    let run = |more: &str| {
        antrieb(&format!("--baud auto --parity auto {more} -v scan")).on(&(slow_pair() + &babble("master", "25ms")))
    };
    let left = run("").exits(8);
    assert_eq!(left.sent(), [""; 0], "it is listened to first");
    assert!(left.err.contains("another master asks on this line"), "{}", left.err);
    assert!(!run("-a 1-3 --force").run().sent().is_empty());
}
