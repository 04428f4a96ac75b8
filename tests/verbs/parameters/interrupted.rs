//! What `dataset`, or `init`, leaves behind where it is brought to its end on the way: nothing that it calls whole, restored or as before, and is not.

use super::ends::{Case, End, Ended, Seen, brought_to_end};
use super::plant::TWO;
use antrieb::failure::Class;
use antrieb::outcome::{Data, Init, LoadEnd, WriteResult};
use antrieb::profile::Registry;
use antrieb::tick::{Span, Tick};

/// A fresh ACT, a file for it, and what takes that back; whatever is typed behind `dataset` runs there, and ends so.
fn on_act(words: &str, end: End, step: usize) -> (Seen, tempfile::TempDir) {
    let case = Case { model: "act", keys: "", options: "", ram: false };
    on(case, words, end, step)
}

fn on(case: Case, words: &str, end: End, step: usize) -> (Seen, tempfile::TempDir) {
    let dir = tempfile::tempdir().unwrap();
    let values = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"372@1\" = 1400\n\"480@2\" = 7\n";
    let undo = format!("{values}[undo]\nvalues = {{ \"372@1\" = 1390, \"480@2\" = 10 }}\n");
    std::fs::write(dir.path().join("bench.toml"), case.bench(end, step, (0, 0))).unwrap();
    std::fs::write(dir.path().join("u.toml"), undo).unwrap();
    std::fs::write(dir.path().join("f.toml"), values.replace("\"372@1\"", "372")).unwrap();
    let seen = case.run(&Registry::open(&[]).unwrap(), dir.path(), words, end, step);
    (seen, dir)
}

#[test]
fn an_undo_that_is_interrupted_before_its_first_write_has_changed_nothing_and_says_so() {
    let (mut before, mut between, mut on_its_way) = (0, 0, 0);
    for step in 1..50 {
        let (seen, _dir) = on_act("undo {dir}/u.toml", End::Wish, step);
        let (worn, ended) = (seen.bench.totals().eeprom_writes, seen.load.as_ref().and_then(|load| load.ended));
        let Some(failure) = seen.failure else { continue };
        match (worn, failure.class.exit()) {
            (0, 130) => {
                before += 1;
                assert!(matches!(ended, None | Some(LoadEnd::Untouched)), "{step}: {ended:?}");
                assert!(!failure.message.en.contains("may not be as before"), "{step}: {failure:?}");
            }
            // The first write is on the line: nobody knows whether it has come.
            (_, 9) => {
                on_its_way += usize::from(worn == 0);
                between += 1;
                assert_eq!(ended, Some(LoadEnd::Torn), "{step}");
            }
            other => panic!("{step}: {other:?} {failure:?}"),
        }
    }
    assert!(before > 5 && between > on_its_way && on_its_way < 3, "{before} {between} {on_its_way}");
}

#[test]
fn what_a_save_has_read_stays_and_is_never_called_whole() {
    for (model, from) in [("act", 14), ("lxm05", 8)] {
        let case = Case { model, keys: "", options: "", ram: false };
        let mut held = Vec::new();
        for step in (from..60).step_by(3) {
            for end in [End::Killed, End::Wish] {
                let (seen, dir) = on(case, "save {dir}/x.toml", end, step);
                let part = std::fs::read_to_string(dir.path().join("x.toml.part"));
                if dir.path().join("x.toml").exists() {
                    continue;
                }
                let Ok(part) = part else {
                    assert!(end == End::Wish || step < 12, "{model} {end:?} {step}");
                    continue;
                };
                assert!(part.contains("complete = false"), "{model} {end:?} {step}: {part}");
                let values = part.split("[values]").nth(1).unwrap().lines().count();
                if end == End::Wish {
                    assert!(seen.failure.is_some_and(|failure| failure.class.exit() == 130), "{model} {step}");
                    held.push(values);
                }
            }
        }
        assert!(held.windows(2).all(|pair| pair[0] <= pair[1]) && held.iter().any(|values| *values > 5), "{held:?}");
        // Three questions are for who it is; of what every further one brought nothing is lost.
        assert!(held.first().is_some_and(|values| *values > 0) && held.len() > 3, "{model}: {held:?}");
    }
}

#[test]
fn a_way_back_over_a_line_that_falls_silent_ends_soon_and_calls_restored_only_what_it_saw() {
    let mut ends = std::collections::BTreeSet::new();
    for step in 14..134 {
        let silent = format!("[[drive.event]]\nafter_telegrams = {step}\nsilent = \"10h\"\n");
        // The last of its values is refused: all of it goes back.
        let keys = format!("[[drive.event]]\nafter_telegrams = 1\nrefuses = {}\n{silent}", 2 << 12 | 480);
        let case = Case { model: "act", keys: Box::leak(keys.into_boxed_str()), options: "", ram: false };
        let (seen, _dir) = on(case, "load {dir}/f.toml", End::Whole, 0);
        let load = seen.load.unwrap();
        let drive = seen.bench.drives().next().unwrap();
        for row in load.values.iter().filter(|row| row.result == WriteResult::Restored) {
            assert_eq!(drive.eeprom(row.param, row.data_set), row.old_raw, "{step}: P.{}@{}", row.param, row.data_set);
        }
        let exit = seen.failure.map(|failure| failure.class.exit());
        assert!(seen.at < Tick::ZERO + Span::from_secs(60), "{step}: {:?}", seen.at);
        assert!(load.ended != Some(LoadEnd::Torn) || exit == Some(9), "{step}: {exit:?}");
        ends.insert(format!("{:?} {exit:?}", load.ended));
    }
    assert!(ends.contains("Some(Torn) Some(9)") && ends.contains("Some(Back) Some(9)"), "{ends:?}");
}

/// Ctrl-C at every telegram of the search: what it had found is not lost, and no project file lacks drives without a word.
#[test]
fn what_an_interrupted_search_had_found_is_kept_beside_the_project_file() {
    let registry = Registry::open(&[]).unwrap();
    let (mut kept, mut empty) = (0, 0);
    for step in (2..200).step_by(9) {
        let dir = tempfile::tempdir().unwrap();
        std::fs::write(dir.path().join("bench.toml"), TWO).unwrap();
        let line = "-p sim:{dir}/bench.toml -a 1-9 init {dir}/antrieb.toml";
        let Ended { outcome, .. } = brought_to_end(dir.path(), line, &registry, End::Wish, step);
        let Some(failure) = outcome.failure.filter(|failure| failure.class == Class::Interrupted) else { break };
        assert!(!dir.path().join("antrieb.toml").exists(), "{step}");
        let (part, hint) = (dir.path().join("antrieb.toml.part"), failure.hint.unwrap().en.to_string());
        let Some(Data::Init(Init { project: None, drives, .. })) = outcome.data else { panic!("{step}") };
        assert_eq!(part.exists(), !drives.is_empty(), "{step}");
        assert_eq!(hint.contains("antrieb.toml.part"), part.exists(), "{step}: {hint}");
        assert_eq!(hint.contains("no file was written"), !part.exists(), "{step}: {hint}");
        if part.exists() {
            let text = std::fs::read_to_string(&part).unwrap();
            let named = drives.iter().all(|drive| text.contains(&format!("[drives.{}]", drive.called)));
            assert!(named, "{step}: {text}");
            kept += 1;
        } else {
            empty += 1;
        }
    }
    assert!(kept > 0 && empty > 0, "{kept} {empty}");
}
