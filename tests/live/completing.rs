//! What a Tab makes of a command line, in the shells themselves: each breaks words in its own way. One that is not on the
//! machine is not tried.

use crate::program::{Shell, alone};

/// How each is started, and taught: Ctrl-T prints the line between marks.
const BASH: &[&str] = &["bash", "--norc", "--noprofile", "-i"];
const TAUGHT: &str = "source <(antrieb completions bash); bind 'set bell-style none'; \
    bind 'set enable-bracketed-paste off'; bind 'set completion-query-items 0'; bind 'set page-completions off'; \
    bind -x '\"\\C-t\": printf \"\\n<<%s>>\\n\" \"$READLINE_LINE\"'; echo rea''dy\n";

/// What is typed behind `antrieb`, and what stands there behind a Tab.
const CASES: &[(&str, &str)] = &[
    // A value is nobody's but of who types it.
    ("write 480=", "write 480="),
    ("write 372=", "write 372="),
    ("write rated-speed=", "write rated-speed="),
    ("write 480@2=", "write 480@2="),
    ("-a 1 write 376@4=", "-a 1 write 376@4="),
    ("write 480=-", "write 480=-"),
    ("write 480 ", "write 480 "),
    ("write 480 5", "write 480 5"),
    ("write 13", "write 13"),
    ("sollwert ", "sollwert "),
    ("sollwert -5", "sollwert -5"),
    ("-a @", "-a @"),
    // A data set stays behind its parameter, and a group a group.
    ("read 480@2", "read 480@2"),
    ("write 48@1", "write 48@1"),
    ("-a 1 read 41@1", "-a 1 read 41@1"),
    ("write 480@2ra", "write 480@2ram="),
    ("read 480@2r", "read 480@2ram "),
    ("--drive act read @actu", "--drive act read @actual "),
    ("write 395=modbus-r", "write 395=modbus-rtu "),
    // Files where files stand.
    ("dataset load ", "dataset load backup.toml "),
    ("dataset undo ", "dataset undo backup.toml "),
    ("dataset diff ba", "dataset diff backup.toml "),
    ("plot ", "plot backup.toml "),
    ("--port=sim:ba", "--port=sim:backup.toml "),
    ("--drive act dataset load --only mot", "--drive act dataset load --only motor"),
    ("dataset lo", "dataset load "),
    ("read --form", "read --format "),
];

#[test]
fn a_tab_changes_no_value_in_bash() {
    let _alone = alone();
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("backup.toml"), "").unwrap();
    let mut bash = Shell::start(BASH, TAUGHT, directory.path());
    for (typed, stands) in CASES {
        assert_eq!(bash.completes(&format!("antrieb {typed}")), format!("antrieb {stands}"), "{typed}");
    }
}
