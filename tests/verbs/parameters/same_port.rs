//! One port under two names: a link, a relative path. Two drives at one address of it would be asked as one.

use super::plant::{ONE, TWO, with};
use crate::run::antrieb;

#[test]
fn two_names_of_one_port_are_one_port() {
    let run = antrieb("plan");
    let dir = run.directory().to_owned();
    std::fs::write(dir.join("tty"), "").unwrap();
    std::os::unix::fs::symlink(dir.join("tty"), dir.join("by-id")).unwrap();
    let config = "[ports.one]\npath = \"{dir}/tty\"\n[ports.other]\npath = \"{dir}/by-id\"\n\
                  [drives.a]\nport = \"one\"\naddress = 1\n[drives.b]\nport = \"other\"\naddress = 1\n";
    let told = with(run, config, [TWO, TWO, ONE]).json().exits(7).error()["message"].to_string();
    assert!(told.contains("antrieb.toml:10:1: drives a and b have the same address 1"), "{told}");
    // At two addresses they are two drives of one line: opened once, and it is no serial port.
    let run = antrieb("plan");
    let dir = run.directory().to_owned();
    std::fs::write(dir.join("tty"), "").unwrap();
    std::os::unix::fs::symlink(dir.join("tty"), dir.join("by-id")).unwrap();
    let config =
        config.replace("address = 1\n[", "address = 2\nfiles = [\"act.toml\"]\n[") + "files = [\"act.toml\"]\n";
    let told = with(run, &config, [TWO, TWO, ONE]).json().exits(3);
    assert_eq!(told.error()["code"].as_str().unwrap().split('.').next(), Some("port"));
}

/// A name that is not told from the root is a name all the same, also beside one that is.
#[test]
fn two_relative_names_of_one_port_are_one_port() {
    for other in ["{up}{dir}/tty", "{dir}/tty", "{up}{dir}/../{last}/by-id"] {
        let run = antrieb("plan");
        let dir = run.directory().to_owned();
        std::fs::write(dir.join("tty"), "").unwrap();
        std::os::unix::fs::symlink(dir.join("tty"), dir.join("by-id")).unwrap();
        let here = std::env::current_dir().unwrap();
        let up = vec![".."; here.components().count() - 1].join("/");
        let other = other.replace("{last}", &dir.file_name().unwrap().to_string_lossy());
        let config = format!(
            "[ports.one]\npath = \"{up}{{dir}}/by-id\"\n[ports.other]\npath = \"{other}\"\n\
             [drives.a]\nport = \"one\"\naddress = 1\n[drives.b]\nport = \"other\"\naddress = 1\n",
            other = other.replace("{up}", &up),
        );
        let told = with(run, &config, [TWO, TWO, ONE]).json().exits(7).error()["message"].to_string();
        assert!(told.contains("antrieb.toml:10:1: drives a and b have the same address 1"), "{other}: {told}");
    }
}
