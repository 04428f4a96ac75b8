//! What a Tab makes of a command line, in the shells themselves: each breaks words in its own way. One that is not on the
//! machine is not tried.

use crate::program::{Shell, alone};
use std::io::Write;

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
    // What can be done, and what it must be told.
    ("procedure comm", "procedure commission "),
    ("-p sim procedure f", "-p sim procedure first-contact "),
    ("procedure commission pow", "procedure commission power="),
    ("procedure commission power=", "procedure commission power="),
    ("read --form", "read --format "),
    // Options have a beginning in common, which nobody typed.
    ("identify ", "identify "),
    ("-a 1 identify ", "-a 1 identify "),
];

/// The same in the others, where a word is a word; what stands there behind a Tab.
const ELSEWHERE: &[(&str, &str)] = &[
    ("write 480=", "write 480="),
    ("write 480@2=", "write 480@2="),
    ("-a 1 write 376@4=", "-a 1 write 376@4="),
    ("write 480=-", "write 480=-"),
    ("sollwert -5", "sollwert -5"),
    ("read 480@2r", "read 480@2ram "),
    ("write 48@1", "write 48@1"),
    ("write 395=modbus-r", "write 395=modbus-rtu "),
    ("--drive act read @actu", "--drive act read @actual "),
    ("dataset load ba", "dataset load backup.toml "),
    ("dataset undo ", "dataset undo backup.toml "),
    ("-p sim:ba", "-p sim:backup.toml "),
    ("--port=sim:ba", "--port=sim:backup.toml "),
    ("dataset lo", "dataset load "),
    ("procedure comm", "procedure commission "),
    ("procedure commission pow", "procedure commission power="),
    ("identify ", "identify "),
];

const ZSH: &[&str] = &["zsh", "-f", "-i"];
const ZSH_TAUGHT: &str = "unsetopt zle_bracketed_paste beep auto_menu 2>/dev/null; autoload -Uz compinit; compinit -u -D; \
    source <(antrieb completions zsh); told() { print -rn -- $'\\n'\"<<$BUFFER>>\" }; zle -N told; bindkey '^T' told; \
    bindkey '^U' kill-whole-line; echo rea''dy\n";

/// It wants a terminal that is its own (util-linux).
const FISH: &[&str] = &["setsid", "--ctty", "fish", "--no-config", "-i"];
const FISH_TAUGHT: &str = "set -g fish_autosuggestion_enabled 0; set -g fish_greeting; antrieb completions fish | source; \
    bind \\ct 'printf \"\\n<<%s>>\" (commandline | string collect)'; bind \\cu kill-whole-line; echo rea''dy\n";

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

/// One that is not there is said to be missing, and not tried; `.ci/run` installs both.
fn elsewhere(program: &str, words: &[&str], taught: &str) {
    let path = std::env::var("PATH").unwrap();
    if !std::env::split_paths(&path).any(|folder| folder.join(program).is_file()) {
        let _told = writeln!(std::io::stderr(), "{program} is not on this machine: not tried");
        return;
    }
    let _alone = alone();
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("backup.toml"), "").unwrap();
    let mut shell = Shell::start(words, taught, directory.path());
    for (typed, stands) in ELSEWHERE {
        assert_eq!(shell.completes(&format!("antrieb {typed}")), format!("antrieb {stands}"), "{program}: {typed}");
    }
}

#[test]
fn a_tab_changes_no_value_in_zsh() {
    elsewhere("zsh", ZSH, ZSH_TAUGHT);
}

#[test]
fn a_tab_changes_no_value_in_fish() {
    elsewhere("fish", FISH, FISH_TAUGHT);
}
