//! The view of a run and its keypad at a real terminal: every key, another size, a terminal that goes away, a dead man. What the
//! keys mean in which order is tried in virtual time (`tests/verbs/motion/keypad.rs`).

use crate::program::{AtTerminal, Piped, alone, appears};
use std::thread;
use std::time::Duration;
use tempfile::TempDir;

/// A drive that obeys the control word, as a port; it goes with its directory.
fn bench() -> (TempDir, String) {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    let drive = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n\
                 ramps = { up_right = 20, down_right = 20, up_left = 20, down_left = 20 }\n";
    std::fs::write(&file, drive).unwrap();
    let port = format!("sim:{}", file.display());
    (directory, port)
}

/// A run in its view.
fn view(port: &str, more: &str) -> AtTerminal {
    AtTerminal::whole(&format!("-p {port} -a 1 --yes sollwert 5Hz --enable --hold {more}"))
}

/// How a terminal is given back: no pasting, the page from before, the cursor.
const GIVEN_BACK: &str = "\u{1b}[?2004l\u{1b}[?1049l\u{1b}[?25h";

#[test]
fn every_key_of_the_view_does_what_it_says() {
    let _alone = alone();
    let (_directory, port) = bench();
    let mut run = view(&port, "--view --step 0.5Hz --max 6Hz");
    run.draws("space stop");
    run.draws("held setpoint 5.00");
    run.types("\u{1b}[A");
    run.draws("setpoint 5.50 Hz");
    run.types("\u{1b}[A\u{1b}[A\u{1b}[A");
    run.draws("agreed are 0.00 to 6.00 Hz");
    // A paste is nobody's finger.
    run.types("\u{1b}[200~ q \u{1b}[201~");
    run.types("d");
    run.draws("status word: 0x");
    run.types("d");
    run.resizes(3, 2);
    run.types("\u{c}");
    run.draws("space stop");
    run.types(" ");
    run.draws("q ends");
    run.types("q");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    run.shows(GIVEN_BACK);
    run.shows("ramp (key), acknowledged");
    assert!(run.is_cooked(), "the terminal is as before");
}

/// An arrow and Enter that somebody presses who forgot `--view` are the same run once more to the shell behind it.
#[test]
fn what_is_typed_into_the_line_of_a_run_is_shown_to_nobody_and_left_to_nobody() {
    let _alone = alone();
    let (_directory, port) = bench();
    let mut run = AtTerminal::start(&format!("-p {port} -a 1 --yes sollwert 5Hz --enable --hold --duration 3s"));
    let behind = run.other_side();
    run.shows(" s left  Ctrl-C stops: ramp");
    assert!(!run.is_cooked(), "nothing is echoed");
    run.types("xyzzy\n");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    assert!(!run.seen.contains("xyzzy"), "{}", run.seen);
    assert!(run.is_cooked(), "the terminal is as before");
    assert_eq!(rustix::io::ioctl_fionread(&behind).unwrap(), 0, "nothing waits for a shell");
}

/// The terminal of a run is that of its script or shell, wherever stdin comes from; that of a job in the background is somebody else's.
#[test]
fn what_is_typed_into_a_run_is_left_to_nobody_wherever_its_stdin_is() {
    let _alone = alone();
    let (_directory, port) = bench();
    let run = format!("$antrieb -q -p {port} -a 1 --yes sollwert 5Hz --enable --hold --duration 3s");
    let then = "echo over $?; read -r word; echo left:$word:";
    for (script, left) in [
        (format!("{run} </dev/null; {then}"), "left:clean:"),
        (format!("echo | {run} | cat; {then}"), "left:clean:"),
        (format!("set -m; {run} </dev/null & wait $!; {then}"), "left:xyzzy:"),
    ] {
        let Some(mut shell) = AtTerminal::script(&format!("echo begins; {script}")) else { return };
        shell.shows("begins");
        thread::sleep(Duration::from_millis(1_500));
        shell.types("xyzzy\n");
        shell.shows("over 0");
        shell.types("clean\n");
        shell.shows(left);
        assert_eq!(shell.ends(), Some(0), "{script}: {}", shell.seen);
    }
}

#[test]
fn a_profile_is_led_in_the_view_and_its_keys_work_at_its_end() {
    let _alone = alone();
    let (directory, port) = bench();
    let profile = directory.path().join("profile.csv");
    std::fs::write(&profile, "0s, 2Hz\n4s, 4Hz\n").unwrap();
    let line = format!("--profile {} --enable --hold --view --step 0.5Hz --max 6Hz", profile.display());
    let mut run = AtTerminal::whole(&format!("-p {port} -a 1 --yes sollwert {line}"));
    // What is typed before the view is there is forgotten, and the question has words with these letters.
    run.draws("space stop");
    run.draws("led setpoint 2");
    run.types("\u{1b}[A");
    run.draws("the arrows work when the way is at its end");
    run.draws("held setpoint 4.00");
    run.types("\u{1b}[A");
    run.draws("setpoint 4.50 Hz");
    run.types("q");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    run.shows(GIVEN_BACK);
    run.shows("ramp (key), acknowledged");
    assert!(run.is_cooked());
}

#[test]
fn contacts_that_are_held_are_shown_and_opened_by_a_key() {
    let _alone = alone();
    let (directory, _) = bench();
    let file = directory.path().join("contacts.toml");
    std::fs::write(&file, "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 2 }\n").unwrap();
    let line = "statemachine contacts S1IND S2IND --hold --view";
    let mut run = AtTerminal::whole(&format!("-p sim:{} -a 1 --yes {line}", file.display()));
    run.draws("held");
    run.types("d");
    run.draws("status word: 0x");
    run.types(" ");
    run.draws("q ends");
    run.types("q");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    run.shows(GIVEN_BACK);
    assert!(run.is_cooked());
}

#[test]
fn ctrl_c_twice_in_the_view_escalates_and_gives_the_terminal_back() {
    let _alone = alone();
    let (directory, port) = bench();
    let slow = std::fs::read_to_string(directory.path().join("bench.toml")).unwrap().replace("= 20", "= 1");
    std::fs::write(directory.path().join("bench.toml"), slow).unwrap();
    let mut run = view(&port, "--view");
    run.shows("held");
    thread::sleep(Duration::from_millis(1_500));
    run.types("\u{3}");
    run.draws("STOPPING");
    thread::sleep(Duration::from_millis(400));
    run.types("\u{3}");
    run.shows("quick-stop in place of ramp");
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    run.shows(GIVEN_BACK);
    assert!(run.is_cooked());
}

#[test]
fn a_terminal_that_goes_away_stops_the_run() {
    let _alone = alone();
    let (directory, port) = bench();
    for more in ["--view", ""] {
        let trace = directory.path().join(format!("trace{more}"));
        let mut run = view(&port, &format!("{more} --trace {}", trace.display()));
        run.shows("Operation enabled");
        let exit = run.hangs_up();
        // Nobody is left to be told; the line is: shut down.
        let sent = std::fs::read_to_string(&trace).unwrap();
        assert!(sent.contains("01 06 01 9A 00 07"), "{more} {exit:?}: {sent}");
        assert_eq!(exit, Some(130), "{more}");
    }
}

/// A shell would take an arrow for the last line, and Enter runs it again.
#[test]
fn keys_that_are_still_held_at_the_end_are_not_typed_into_the_shell() {
    let _alone = alone();
    let (_directory, port) = bench();
    let mut run = view(&port, "--view --step 0.5Hz --max 6Hz --duration 1s");
    run.draws("held");
    for _ in 0..100 {
        run.types("\u{1b}[A");
        thread::sleep(Duration::from_millis(50));
    }
    assert!(!run.is_cooked(), "the view stays as long as a key repeats");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    run.shows("ramp (end), acknowledged");
    assert!(run.is_cooked());
}

/// Somebody looks at another screen: what is drawn is not taken.
#[test]
fn a_terminal_that_takes_nothing_holds_up_no_stop() {
    let _alone = alone();
    let (directory, port) = bench();
    let trace = directory.path().join("trace");
    let mut run = view(&port, &format!("--view --duration 4s --trace {}", trace.display()));
    run.looks_away();
    assert_eq!(run.ends(), Some(0), "what is not read is no reason for another end");
    assert!(std::fs::read_to_string(&trace).unwrap().contains("01 06 01 9A 00 07"));
    assert!(run.is_cooked());
}

#[test]
fn a_dead_man_who_lets_go_stops_the_run() {
    let _alone = alone();
    let (_directory, port) = bench();
    let mut run = view(&port, "--dead-man");
    // Nothing else happens meanwhile that would draw it.
    run.pictures("waiting for a key to be held");
    for _ in 0..60 {
        run.types("\r");
        thread::sleep(Duration::from_millis(40));
    }
    run.shows("held");
    run.draws("the run is over");
    // Who takes hold again, or has not noticed, starts nothing, and types nothing into the shell.
    for wait in [0, 2_000] {
        thread::sleep(Duration::from_millis(wait));
        run.types("\u{1b}[A\r \r");
    }
    thread::sleep(Duration::from_secs(2));
    assert!(!run.is_cooked(), "the view stays until somebody leaves");
    run.draws("q ends");
    run.types("q");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    run.shows("ramp (dead-man), acknowledged");
    assert!(run.is_cooked());
}

/// Nothing more is shown of a slave whose port is gone; a key that is held on meanwhile is not left to the shell either.
#[test]
fn a_key_that_is_held_where_the_port_is_lost_is_not_typed_into_the_shell() {
    let _alone = alone();
    let directory = tempfile::tempdir().unwrap();
    let (file, link) = (directory.path().join("line.toml"), directory.path().join("bus"));
    std::fs::write(&file, "[[module]]\ndrive = \"l200\"\naddress = 3\n").unwrap();
    let bench = format!("simulate {} --profibus --link {} --duration 60s", file.display(), link.display());
    let bench = Piped::start(&bench);
    appears(&link, "no bench");
    let line = "--yes sollwert 5Hz --enable --hold --take-control --dead-man";
    let mut run = AtTerminal::whole(&format!("-p {} --protocol dp -a 3 {line}", link.display()));
    run.pictures("waiting for a key to be held");
    for press in 0..200 {
        run.types("\r");
        thread::sleep(Duration::from_millis(40));
        if press == 60 {
            bench.signal("-KILL");
        }
    }
    assert!(!run.is_cooked(), "the view stays as long as a key repeats");
    assert_eq!(run.ends(), Some(3), "{}", run.seen);
    run.shows("was lost");
    assert!(run.is_cooked());
}

#[test]
fn a_signal_in_the_view_stops_the_run_and_gives_the_terminal_back() {
    let _alone = alone();
    let (_directory, port) = bench();
    for signal in ["-TERM", "-HUP", "-QUIT"] {
        let mut run = view(&port, "--view");
        run.shows("held");
        run.signal(signal);
        assert_eq!(run.ends(), Some(130), "{signal}: {}", run.seen);
        run.shows(GIVEN_BACK);
        assert!(run.is_cooked(), "{signal}");
    }
}

#[test]
fn one_line_tells_of_a_run_where_there_is_a_terminal() {
    let _alone = alone();
    let (_directory, port) = bench();
    let mut run = view(&port, "--duration 3s");
    run.shows("Operation enabled  5.00 -> 5.00 Hz");
    run.shows("s left  Ctrl-C stops: ramp");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
    run.shows("ramp (end), acknowledged");
}
