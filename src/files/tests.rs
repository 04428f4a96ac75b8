//! What is refused before it is opened, and what is never replaced.

use super::*;
use std::os::unix::fs::symlink;

#[test]
fn what_the_system_says_is_said_in_german_or_quoted() {
    let said = |error: io::Error| of_system(&error).de.into_owned();
    let nobody = "failed to lookup address information: Name or service not known";
    assert_eq!(said(io::Error::other(nobody)), "diesen Rechnernamen kennt niemand");
    assert_eq!(said(io::Error::from_raw_os_error(27)), "die Datei wird zu groß (Systemfehler 27)");
    assert_eq!(said(io::Error::other("frobnicated")), "\"frobnicated\"");
}

fn told<T: std::fmt::Debug>(result: Result<T, FileError>) -> String {
    result.unwrap_err().to_string()
}

#[test]
fn only_regular_files_are_read_and_only_so_far() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    std::fs::write(at("text"), "abc").unwrap();
    std::fs::write(at("bytes"), b"ab\xFF").unwrap();
    symlink(at("text"), at("link")).unwrap();
    rustix::fs::mknodat(rustix::fs::CWD, at("pipe"), rustix::fs::FileType::Fifo, 0o600.into(), 0).unwrap();
    let _socket = std::os::unix::net::UnixListener::bind(at("socket")).unwrap();
    assert_eq!(read(&at("text"), 3).unwrap(), "abc");
    assert_eq!(read(&at("link"), 3).unwrap(), "abc");
    std::fs::write(at("marked"), "\u{FEFF}abc").unwrap();
    assert_eq!(read(&at("marked"), 6).unwrap(), "abc", "a byte order mark is none of the text");
    assert_eq!(told(read(&at("text"), 2)), "expected at most 0 MiB, the file is longer");
    let no_text = "line 1, column 3: expected a text in UTF-8; an editor can save the file so";
    assert_eq!(told(read(&at("bytes"), 3)), no_text);
    for (path, kind) in [
        (at("pipe"), "a pipe"),
        (at("socket"), "a socket"),
        (dir.path().to_owned(), "a directory"),
        ("/dev/zero".into(), "a device"),
    ] {
        assert_eq!(told(read(&path, TEXT)), format!("expected a regular file, this is {kind}"));
        assert_eq!(told(create(&path, true)), format!("expected a regular file, this is {kind}"));
    }
    assert!(read(&at("nothing"), TEXT).unwrap_err().is_missing());
}

#[test]
fn a_whole_file_is_written_or_nothing_of_it() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    write_whole(&at("new"), "one", false).unwrap();
    assert_eq!(told(write_whole(&at("new"), "two", false)), "the file exists already");
    assert_eq!(std::fs::read_to_string(at("new")).unwrap(), "one");
    write_whole(&at("new"), "two", true).unwrap();
    assert_eq!(std::fs::read_to_string(at("new")).unwrap(), "two");
    symlink(at("new"), at("link")).unwrap();
    for overwrite in [false, true] {
        let refused = "expected a regular file, this is a symbolic link";
        assert_eq!(told(write_whole(&at("link"), "three", overwrite)), refused);
        assert!(told(write_whole(dir.path(), "three", overwrite)).ends_with("this is a directory"));
        assert!(write_whole(&at("none/where"), "three", overwrite).unwrap_err().is_missing());
    }
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 2, "nothing is left behind");
}

#[test]
fn what_a_crash_has_left_is_in_nobodys_way() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    for stale in [format!(".new.{}.new", std::process::id()), format!(".new.{}-0.new", std::process::id())] {
        std::fs::write(at(&stale), "half").unwrap();
    }
    write_whole(&at("new"), "one", false).unwrap();
    write_whole(&at("new"), "two", true).unwrap();
    assert_eq!(std::fs::read_to_string(at("new")).unwrap(), "two");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 3);
}

#[test]
fn a_file_system_without_links_gets_whole_files_too_and_replaces_none() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    let none = |_: &Path, _: &Path| Err(io::Error::from(io::ErrorKind::PermissionDenied));
    std::fs::write(at("beside"), "one").unwrap();
    place_new(&at("beside"), &at("new"), none).unwrap();
    assert_eq!((std::fs::read_to_string(at("new")).unwrap(), at("beside").exists()), ("one".to_owned(), false));
    std::fs::write(at("beside"), "two").unwrap();
    assert_eq!(told(place_new(&at("beside"), &at("new"), none)), "the file exists already");
    assert_eq!(std::fs::read_to_string(at("new")).unwrap(), "one");
    assert!(place_new(&at("nothing"), &at("other"), none).is_err());
    assert!(!at("other").exists(), "no reserved name is left behind");
}

#[test]
fn nothing_is_overwritten_unasked_and_nothing_through_a_link() {
    let dir = tempfile::tempdir().unwrap();
    let at = |name: &str| dir.path().join(name);
    create(&at("new"), false).unwrap();
    std::fs::write(at("old"), "precious").unwrap();
    assert_eq!(told(create(&at("old"), false)), "the file exists already");
    for (name, target) in [("link", at("old")), ("dangling", at("nothing"))] {
        symlink(target, at(name)).unwrap();
        for overwrite in [false, true] {
            assert_eq!(told(create(&at(name), overwrite)), "expected a regular file, this is a symbolic link");
        }
    }
    assert_eq!(std::fs::read_to_string(at("old")).unwrap(), "precious");
    assert!(!at("nothing").exists());
    create(&at("old"), true).unwrap();
    assert_eq!(std::fs::read_to_string(at("old")).unwrap(), "");
}

/// The file that is to be is not what is missing.
#[test]
fn a_directory_that_is_not_there_is_named() {
    let dir = tempfile::tempdir().unwrap();
    let told = |file: &str| {
        let file = dir.path().join(file);
        let error = check(&file, false).and_then(|()| read(&file, 3).map(drop)).unwrap_err();
        error.of(&file).en.replace(&dir.path().display().to_string(), "DIR")
    };
    assert_eq!(told("none/file"), "DIR/none/file: there is no directory DIR/none");
    assert_eq!(told("file"), "DIR/file: No such file or directory (os error 2)");
}
