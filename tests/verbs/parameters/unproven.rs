//! What a drive perhaps did not take back stands in the undo file, and goes out of it only by a write that was proven.

use super::memory::{Left, left, load};
use crate::run::Output;
use antrieb::tick::Span;

/// A drive that tells its RAM as stored (docs/open-points.md, `ram_reads`), and whose EEPROM takes nothing for 480@1 from 100 s to 300 s.
const WORN_FOR_A_WHILE: &str = "set = { \"480\" = 5 }\nreadings = { ram_reads = \"in-force\" }\n\
    [[drive.event]]\nat = \"100s\"\neeprom = { \"480@1\" = \"refuses\" }\n\
    [[drive.event]]\nat = \"300s\"\neeprom = { \"480@1\" = \"takes\" }\n";
const VALUES: &str = "\"480@1\" = 8\n\"480@2\" = 8";
const UNDO: &str = "-a 1 --yes dataset undo {dir}/f.undo.toml";

/// The bench so much later.
fn later(Left(mut bench, at): Left, seconds: u64) -> Left {
    let later = at + Span::from_secs(seconds);
    bench.advance(later);
    Left(bench, later)
}

/// A load, and an undo that the EEPROM refuses: the file names 480@1.
fn refused_once(more: &str) -> Output {
    let run = load(&format!("{WORN_FOR_A_WHILE}{more}"), VALUES).exits(0);
    let worn = later(left(), 150).then(run, UNDO).exits(9);
    assert!(worn.text_of("f.undo.toml").contains("[undo.unproven]\n\"480@1\""), "{}", worn.text_of("f.undo.toml"));
    worn
}

/// Beside a file of so long a name no file system takes another one: that is a folder without a right to write, also for who has
/// every right.
fn long() -> String {
    format!("{}.toml", "x".repeat(248))
}

#[test]
fn an_undo_whose_file_cannot_be_rewritten_writes_nothing_and_says_what_to_do() {
    let name = long();
    let run = load(WORN_FOR_A_WHILE, VALUES).exits(0);
    let text = run.text_of("f.undo.toml");
    let undo = format!("-a 1 dataset undo {{dir}}/{name}");
    let seen = later(left(), 150);
    let before = seen.worn();
    let refused = seen.then(run, &undo).file(&name, &text).and("--yes").exits(7);
    let seen = left();
    assert_eq!((seen.cell(480, 1).0, seen.worn()), (Some(800), before));
    for word in ["cannot be rewritten", "nothing was written", "copy", "f.undo.toml"] {
        let word = word.replace("f.undo.toml", &name);
        assert!(refused.err.contains(&word), "{word}: {}", refused.err);
    }
    // Nobody is asked what cannot come.
    let refused = seen.then(refused, &undo).answered("j").and("--lang de").exits(7);
    assert!(!refused.err.contains("[j/N]"), "{}", refused.err);
    // The EEPROM refuses, and the copy keeps it.
    let worn = left().then(refused, UNDO).exits(9);
    let undone = later(left(), 300).then(worn, UNDO).exits(0);
    let seen = left();
    assert_eq!([seen.cell(480, 1).0, seen.cell(480, 2).0], [Some(500); 2], "{}", undone.err);
    // Where nothing is to be written, nothing has to be kept.
    seen.then(undone, &undo).and("--yes").exits(0);
}

#[cfg(unix)]
#[test]
fn an_undo_through_a_link_names_the_file_that_it_leads_to() {
    let run = load(WORN_FOR_A_WHILE, VALUES).exits(0);
    let text = run.text_of("f.undo.toml");
    let next = later(left(), 150).then(run, "-a 1 --yes dataset undo {dir}/link.toml").file("d/real.toml", &text);
    std::os::unix::fs::symlink("d/real.toml", next.directory().join("link.toml")).unwrap();
    let refused = next.exits(7);
    assert!(refused.err.contains("d/real.toml"), "{}", refused.err);
    assert_eq!(left().cell(480, 1).0, Some(800));
}

/// What the file keeps of 480.
fn kept(ended: &Output) -> String {
    let text = ended.text_of("f.undo.toml");
    text.split_once("[undo.unproven]\n").map(|(_, kept)| kept.to_owned()).unwrap_or_default()
}

/// Somebody has set other values since: 480@1 is left as it is, 480@2 goes back, and 480@1 is written once it looks as before.
#[test]
fn what_an_undo_left_stays_in_the_file_until_it_was_written() {
    let since = "[[drive.event]]\nat = \"400s\"\nset = { \"480@1ram\" = 6, \"480@2ram\" = 8 }\n\
                 [[drive.event]]\nat = \"600s\"\nset = { \"480@1ram\" = 5 }";
    let worn = refused_once(since);
    let before = kept(&worn);
    let partly = later(left(), 300).then(worn, UNDO).exits(9);
    let seen = left();
    assert_eq!((seen.cell(480, 1).0, kept(&partly)), (Some(800), before), "{}", partly.out);
    let undone = later(seen, 300).then(partly, UNDO).exits(0);
    assert_eq!((left().cell(480, 1), kept(&undone)), ((Some(500), Some(500)), String::new()));
}

/// A reply of the second undo is an exception, whichever: what could not be read, or was not written, stays in the file.
#[test]
fn what_an_undo_could_not_read_stays_in_the_file_until_it_was_written() {
    let mut left_open = 0;
    for telegram in 40..100 {
        let since = "[[drive.event]]\nat = \"400s\"\nset = { \"480@2ram\" = 8 }";
        let disturbed = format!("\n[[disturb]]\nonce = {telegram}\nkind = \"exception\"\nbyte = 4");
        let run = load(&format!("{WORN_FOR_A_WHILE}{since}{disturbed}"), VALUES).run();
        let worn = later(left(), 150).then(run, UNDO).run();
        if !kept(&worn).contains("480@1") {
            continue;
        }
        let partly = later(left(), 300).then(worn, UNDO).run();
        let seen = left();
        let is_back = seen.cell(480, 1).0 == Some(500);
        assert!(is_back || partly.exit != 0 && kept(&partly).contains("480@1"), "{telegram}: {}", partly.out);
        if is_back || partly.exit != 9 {
            continue;
        }
        left_open += 1;
        seen.then(partly, UNDO).exits(0);
        assert_eq!(left().cell(480, 1).0, Some(500), "{telegram}");
    }
    assert!(left_open > 0);
}

/// The four data sets were one when they were loaded, differed at the first undo, and are told as one at the second.
#[test]
fn four_data_sets_that_look_like_one_again_are_not_taken_for_proven() {
    let run = load(WORN_FOR_A_WHILE, "480 = 8").exits(0);
    let torn = "-a 1 --yes write 480@2=7";
    let written = later(left(), 20).then(run, torn).exits(0);
    let worn = later(left(), 150).then(written, &format!("{UNDO} --force")).exits(9);
    assert!(kept(&worn).contains("480"), "{}", worn.text_of("f.undo.toml"));
    let undone = later(left(), 300).then(worn, UNDO).exits(0);
    let seen = left();
    let cells = [1, 2, 3, 4].map(|set| seen.cell(480, set).0);
    assert_eq!(cells, [Some(500); 4], "{}", undone.out);
}
