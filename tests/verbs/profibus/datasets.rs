//! The settings of an inverter as a file, over PKW: saved, compared, loaded as a transaction, and taken back; the slave is kept going
//! meanwhile, and let go however it ends.

use super::rig::{event, module};
use super::{is_let_go, later, line};
use crate::run::{Document, Run, antrieb};
use antrieb::simulator::Profibus;
use antrieb::transport::witness;

const HEAD: &str = "antrieb = 1\n[drive]\nfamily = \"l200\"\n[values]\n";
/// F002, P.703, and an element of the mapping that is read.
const WANTED: &str = "7 = \"5 s\"\n703 = 1\n\"916.2\" = 34\n";

fn file(values: &str) -> String {
    format!("{HEAD}{values}")
}

fn of(typed: &str, text: &str) -> Run {
    antrieb(&format!("-a 3 --protocol dp {typed}")).on(text)
}

/// What stands in the bench: acceleration, bus lost, element 2 of what is read.
fn stands(bus: &Profibus) -> [i64; 3] {
    let raw = |(index, element)| i64::from(bus.raw(3, index, element).unwrap() as u16 as i16);
    [(7, None), (703, None), (916, Some(2))].map(raw)
}

const BEFORE: [i64; 3] = [-1_000, 2, 0];
const AFTER: [i64; 3] = [-500, 1, 34];

fn results(run: &Document) -> Vec<String> {
    let rows = run.data("/values").as_array().unwrap();
    rows.iter().map(|row| row["result"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn what_is_saved_is_equal_and_holds_the_elements_of_arrays() {
    let run = of("--yes dataset save {dir}/s.toml", &line("", "")).run();
    assert_eq!(run.exit, 0, "{}", run.err);
    let text = run.text_of("s.toml");
    for key in ["\"915.1\" = ", "\"916.8\" = ", "\n\"703\" = ", "family = \"l200\""] {
        assert!(text.contains(key), "{key}: {text}");
    }
    assert!(is_let_go(&later()));
    let same = of("--yes dataset check {dir}/s.toml", &line("", "")).file("s.toml", &text).json().exits(0);
    assert_eq!(same.warnings(), ["profibus.let_go"]);
    assert!(is_let_go(&later()));
    let run = of("--yes dataset load {dir}/s.toml", &line("", "")).file("s.toml", &text).json().exits(0);
    assert!(results(&run).iter().all(|result| result == "unchanged"), "{:?}", results(&run));
    assert!(is_let_go(&later()));
    // An element is named as it is typed elsewhere.
    let line_of_one = "--dry-run dataset load {dir}/w.toml --only 916.2";
    let run = of(line_of_one, &line("", "")).file("w.toml", &file(WANTED)).json().exits(0);
    assert_eq!(results(&run), ["planned"]);
}

#[test]
fn a_load_is_proven_and_taken_back_by_its_undo_file() {
    for (more, readings) in
        [("", ""), ("flips = 2", ""), ("", "pkw_waits = \"empty\""), ("", "negative_pwe = \"extended\"")]
    {
        let run = of("--yes dataset load {dir}/w.toml", &line(more, readings)).file("w.toml", &file(WANTED)).run();
        assert_eq!(run.exit, 0, "{more} {readings}: {}", run.err);
        let bus = later();
        assert_eq!(stands(&bus), AFTER, "{more} {readings}");
        assert!(is_let_go(&bus) && (bus.remarks().is_empty() || !more.is_empty()), "{:?}", bus.remarks());
        let undo = run.text_of("w.undo.toml");
        let changed = line(more, readings).replace("\"703\" = 2", "\"703\" = 1, \"7\" = -500");
        let back = of("--yes dataset undo {dir}/u.toml", &changed).file("u.toml", &undo).json();
        let bus = later();
        assert_eq!(stands(&bus)[..2], BEFORE[..2], "{:?}", results(&back));
        assert!(is_let_go(&bus));
    }
}

#[test]
fn what_differs_is_told_and_nothing_is_written() {
    let run = of("--yes dataset check {dir}/w.toml", &line("", "")).file("w.toml", &file(WANTED)).json().exits(1);
    assert_eq!(run.error()["code"], "no.differences");
    let run = of("--yes dataset diff {dir}/w.toml drive", &line("", "")).file("w.toml", &file(WANTED)).exits(1);
    assert!(run.out.contains("916"), "{}", run.out);
    let bus = later();
    assert_eq!(stands(&bus), BEFORE);
    assert!(is_let_go(&bus));
}

#[test]
fn nothing_is_taken_for_what_is_wrong_without_a_slave_or_was_not_agreed_to() {
    let other = HEAD.replace("l200", "act") + "372 = 1400\n";
    of("--yes dataset load {dir}/w.toml", &line("", "")).file("w.toml", &file("9999 = 1\n")).exits(7);
    of("--yes dataset check {dir}/none.toml", &line("", "")).exits(7);
    of("dataset load {dir}/w.toml", &line("", "")).file("w.toml", &file(WANTED)).exits(8);
    of("dataset load {dir}/w.toml", &line("", "")).file("w.toml", &file(WANTED)).answered("n\n").exits(8);
    of("--dry-run dataset load {dir}/w.toml", &line("", "")).file("w.toml", &file(WANTED)).exits(0);
    assert!(witness::left_profibus().is_none(), "no line was opened");
    of("--yes dataset load {dir}/w.toml", &line("", "")).file("w.toml", &other).exits(7);
    assert!(is_let_go(&later()));
    antrieb("-p sim -a 1 dataset save x.toml --user-prm C7").exits(2);
}

#[test]
fn what_is_refused_leaves_everything_as_it_was() {
    let locked = line("", "").replace("\"703\" = 2", "\"703\" = 2, \"927\" = 0");
    of("--yes --drive l200 dataset load {dir}/w.toml", &locked).file("w.toml", &file(WANTED)).json().exits(6);
    let bus = later();
    assert_eq!(stands(&bus), BEFORE);
    assert!(is_let_go(&bus));
}

#[test]
fn a_shaft_that_turns_keeps_a_file_out() {
    // Its terminals run it, and P.928 = 0 leaves them the motor.
    let text = line("", "").replace("\"928\" = 1", "\"928\" = 0") + "\n[[module.event]]\nat = \"0s\"\ncontact = true\n";
    let run = of("--yes dataset load {dir}/w.toml", &text).file("w.toml", &file(WANTED)).json();
    assert_eq!(run.error()["class"], "forbidden", "{}", run.error());
    assert_eq!(stands(&later()), BEFORE);
}

#[test]
fn a_port_that_is_lost_at_any_telegram_of_a_load_is_told_with_what_stands() {
    for telegrams in (0..420).step_by(13) {
        witness::pull_after(Some(telegrams));
        let run = of("--yes --json dataset load {dir}/w.toml", &line("", "")).file("w.toml", &file(WANTED)).run();
        witness::pull_after(None);
        let bus = later();
        assert!(is_let_go(&bus), "{telegrams}");
        let told = run.out.clone();
        match run.exit {
            0 => assert_eq!(stands(&bus), AFTER, "{telegrams}"),
            3 | 9 => {
                let is_open = stands(&bus) != BEFORE;
                let names = ["unrestored", "unknown", "verified"].iter().any(|word| told.contains(word));
                assert!(!is_open || names, "{telegrams}: {told}");
            }
            other => panic!("{telegrams}: {other}: {}", run.err),
        }
    }
}

/// A slave that falls silent behind any of our bytes, its port being there: what stands half written is torn and exit 9, and no row tells of an adapter.
#[test]
fn a_slave_that_falls_silent_in_a_load_is_told_as_silent() {
    let (mut torn, mut quiet) = (0, 0);
    for at in (200..7_000).step_by(170) {
        let text = module("\"928\" = 1, \"703\" = 2", "", &event(&format!("{at}ms"), "cut = true"));
        let run = of("--yes --json dataset load {dir}/w.toml", &text).file("w.toml", &file(WANTED)).run();
        let bus = later();
        assert!(is_let_go(&bus), "{at}");
        let told = format!("{}{}", run.out, run.err);
        assert!(!told.contains("unplugged") && !told.contains("port.lost"), "{at}: {told}");
        match (run.exit, stands(&bus) == BEFORE) {
            // Loaded, and silent before it was let go, or after that.
            (0 | 4, false) => assert_eq!(stands(&bus), AFTER, "{at}: {told}"),
            (4, true) => {
                quiet += 1;
                assert!(told.contains("silence."), "{at}: {told}");
            }
            (9, _) => {
                torn += 1;
                assert!(told.contains("partial.torn") && told.contains("silence."), "{at}: {told}");
                assert!(told.contains("station 3 ") || told.contains("was not asked"), "{at}: {told}");
            }
            other => panic!("{at}: {other:?}: {told}"),
        }
    }
    assert!(torn > 3 && quiet > 3, "{torn} torn, {quiet} before anything was written");
}

#[test]
fn a_slave_that_falls_silent_in_a_check_is_told_as_silent() {
    let undo =
        of("--yes dataset load {dir}/w.toml", &line("", "")).file("w.toml", &file(WANTED)).run().text_of("w.undo.toml");
    for (at, typed, text) in [
        ("1s", "check {dir}/w.toml", &file(WANTED)),
        ("1s", "save {dir}/s.toml", &file(WANTED)),
        ("1500ms", "undo {dir}/w.toml", &undo),
    ] {
        let bench = module("\"928\" = 1, \"703\" = 1, \"7\" = -500, \"916.2\" = 34", "", &event(at, "cut = true"));
        let run = of(&format!("--yes dataset {typed}"), &bench).file("w.toml", text).run();
        assert!([4, 9].contains(&run.exit), "{typed}: {}: {}", run.exit, run.err);
        let told = format!("{}{}", run.out, run.err);
        assert!(
            told.contains("station 3 ") && !told.contains("unplugged") && !told.contains("lost:"),
            "{typed}: {told}"
        );
        assert!(is_let_go(&later()), "{typed}");
    }
}
