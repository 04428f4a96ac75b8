//! An undo file: made ready before the first byte, noted where no room is left, read again, and refused where it says two things.

use super::*;
use crate::files;
use crate::profile::Registry;
use crate::profile::paramfile::ParamFile;
use std::path::Path;

const UNDO: &str = "# Pump 7, cellar\nantrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"480@1\" = \"5.00 Hz\"\n480 = 5\n\
    [undo]\n[undo.values]\n\"480@1\" = 8\n480 = 8\n";

fn opened(path: &Path) -> UndoFile {
    let registry = Registry::open(&[]).unwrap();
    let family = registry.family("act").unwrap();
    let file = ParamFile::parse("u", &std::fs::read_to_string(path).unwrap()).unwrap();
    UndoFile::read(path, &file, &family).unwrap().0
}

fn kept(set: u8) -> Kept {
    let param = Registry::open(&[]).unwrap().family("act").unwrap().param(480).unwrap().clone();
    Kept { param, set, raw: 500 }
}

/// The names that a file beside may have are all taken: no disk takes one more.
fn fill(path: &Path, first: u32) {
    let name = path.file_name().unwrap().to_str().unwrap();
    for count in first..99 {
        let beside = path.with_file_name(format!(".{name}.{}-{count}.new", std::process::id()));
        std::fs::write(beside, "").unwrap();
    }
}

#[test]
fn what_was_made_ready_needs_no_room_when_it_is_noted() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("u.toml");
    std::fs::write(&path, UNDO).unwrap();
    let file = opened(&path);
    file.make_ready([kept(0), kept(1)].iter().map(Kept::setting)).unwrap();
    fill(&path, 1);
    file.note(&[kept(1)]).unwrap();
    let said = std::fs::read_to_string(&path).unwrap();
    assert!(said.contains("[undo.unproven]\n\"480\""), "more than it has to: {said}");
    // It can be written again by now, and says what did not come back.
    file.strike(&[kept(1)], &[]).unwrap();
    let said = std::fs::read_to_string(&path).unwrap();
    assert!(said.contains("[undo.unproven]\n\"480@1\""), "{said}");
    assert_eq!(file.strike(&[kept(1)], &[&kept(1)]).map_err(|failure| failure.message), Ok(()));
}

#[test]
fn what_can_neither_be_made_ready_nor_noted_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("u.toml");
    std::fs::write(&path, UNDO).unwrap();
    fill(&path, 0);
    let file = opened(&path);
    assert!(file.make_ready([kept(1)].iter().map(Kept::setting)).is_err());
    let failure = file.note(&[kept(1)]).unwrap_err();
    assert!(failure.message.en.contains("cannot be rewritten"), "{}", failure.message.en);
    // Of what it does not say nothing has to be struck out.
    assert!(file.strike(&[kept(1)], &[&kept(1)]).is_ok());
    assert_eq!(files::read(&path, files::TEXT).unwrap(), UNDO);
}

#[test]
fn of_four_data_sets_each_has_to_come_back() {
    let one: Settings = [kept(0).setting()].into_iter().collect();
    let four = [1, 2, 3, 4].map(kept);
    let back: Vec<&Kept> = four.iter().collect();
    assert_eq!(without(one.clone(), &back[..3]).len(), 1);
    assert_eq!(without(one.clone(), &back).len(), 0);
    assert_eq!(without(four.iter().map(Kept::setting).collect(), &[&kept(0)]).len(), 0);
    assert_eq!(without(four.iter().map(Kept::setting).collect(), &[&kept(2)]).len(), 3);
}

#[test]
fn what_a_hand_has_written_stays_in_a_file_that_is_written_again() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("u.toml");
    std::fs::write(&path, UNDO).unwrap();
    opened(&path).note(&[kept(1)]).unwrap();
    let noted = std::fs::read_to_string(&path).unwrap();
    assert!(noted.starts_with(&UNDO.replace("antrieb = 1", "antrieb = 2")), "{noted}");
    assert!(noted.contains("\n[undo.unproven]\n\"480@1\" = \"5.00 Hz\""), "{noted}");
    // And twice, and back.
    opened(&path).note(&[kept(1)]).unwrap();
    assert_eq!(std::fs::read_to_string(&path).unwrap(), noted);
    opened(&path).strike(&[kept(1)], &[&kept(1)]).unwrap();
    assert_eq!(std::fs::read_to_string(&path).unwrap(), UNDO);
    // What is written in another way is printed anew.
    let inline = UNDO.replace("[undo]\n", "[undo]\nunproven = { \"480@1\" = 5 }\n");
    std::fs::write(&path, inline.replace("antrieb = 1", "antrieb = 2")).unwrap();
    opened(&path).note(&[kept(0)]).unwrap();
    assert_eq!(opened(&path).settings.unproven.iter().count(), 2);
}

#[test]
fn a_file_that_says_two_things_is_refused_with_its_line() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("u.toml");
    std::fs::write(&path, UNDO).unwrap();
    let family = Registry::open(&[]).unwrap().family("act").unwrap();
    for (row, is_read) in
        [("480@1 = 5", true), ("480@2 = 5", true), ("480 = 5", true), ("480@1 = 9", false), ("481@1 = 5", false)]
    {
        let (place, value) = row.split_once(" = ").unwrap();
        let text = UNDO.replace("antrieb = 1", "antrieb = 2") + &format!("[undo.unproven]\n\"{place}\" = {value}\n");
        let file = ParamFile::parse("u", &text).unwrap();
        match UndoFile::read(&path, &file, &family) {
            Ok(_) => assert!(is_read, "{row}"),
            Err(failure) => assert!(!is_read && failure.message.en.contains("[undo.unproven] has"), "{row}: {failure}"),
        }
    }
}
