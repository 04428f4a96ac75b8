//! Signals to the program at a terminal: what no virtual time shows.

use crate::program::{AtTerminal, Mute, alone, appears, full_pipe};
use std::process::Stdio;
use std::thread;
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// A drive that obeys the control word.
const OBEYS: &str = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 2 }\n";

/// A bench of its own, as a port; it goes with its directory.
fn bench(drives: &str) -> (TempDir, String) {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, drives).unwrap();
    let port = format!("sim:{}", file.display());
    (directory, port)
}

/// A held run of a shaft whose ramp would take 40 s.
fn turning() -> (TempDir, AtTerminal) {
    let (directory, port) = bench(
        "[[drive]]\nmodel = \"act\"\nramps = { up_right = 99, down_right = 1, up_left = 99, down_left = 1 }\n\
                 set = { \"412\" = 1, \"434\" = 2, \"418\" = 0, \"424\" = 1, \"425\" = 1 }\n",
    );
    let mut run = AtTerminal::start(&format!("-v -p {port} -a 1 --yes sollwert 40Hz --enable --until reached --hold"));
    run.shows("> 01 65 01 E4 00 00 0F A0");
    // Held once it is given again.
    thread::sleep(Duration::from_millis(1_500));
    run.shows("note: running; Ctrl-C stops: ramp");
    (directory, run)
}

#[test]
fn a_signal_at_the_question_ends_it_at_once_and_a_later_yes_writes_nothing() {
    let _alone = alone();
    for signal in ["-INT", "-TERM", "-HUP"] {
        let mut run = AtTerminal::start("-v -p sim -a 1 write 480@1=7Hz");
        run.shows("go on? [y/N]");
        run.signal(signal);
        assert_eq!(run.ends(), Some(130), "{signal}: {}", run.seen);
        run.types("y\n");
        run.shows("nothing was written");
        assert!(!run.seen.contains("> 01 65"), "{signal}: {}", run.seen);
    }
}

#[test]
fn what_was_typed_before_the_question_stood_there_is_no_answer_to_it() {
    let _alone = alone();
    let mut run = AtTerminal::start("-v -p sim -a 1 write 480@1=7Hz");
    run.types("y\n");
    run.shows("go on? [y/N]");
    thread::sleep(Duration::from_millis(500));
    run.types("\n");
    assert_eq!(run.ends(), Some(8), "{}", run.seen);
    run.shows("nothing was written");
    assert!(!run.seen.contains("> 01 65"), "{}", run.seen);
}

#[test]
fn every_further_signal_shortens_the_stop() {
    let _alone = alone();
    let (_directory, mut run) = turning();
    let begun = Instant::now();
    for (signal, sends) in
        [("-INT", "> 01 06 01 9A 00 07"), ("-TERM", "> 01 06 01 9A 00 02"), ("-INT", "> 01 06 01 9A 00 00")]
    {
        run.signal(signal);
        run.shows(sends);
        // The same at once would be the same wish.
        thread::sleep(Duration::from_millis(200));
    }
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    run.shows("note: stopping: ramp; another Ctrl-C: quick-stop");
    assert!(begun.elapsed() < Duration::from_secs(30), "the ramp would take 40 s: {:?}", begun.elapsed());
    run.shows("ramp -> coast: without power, but the shaft still turns");
    assert!(run.seen.contains("quick-stop in place of ramp") && run.seen.contains("coast in place of quick-stop"));
}

/// As from `timeout`, which signals its child and then the group of it.
#[test]
fn a_signal_that_comes_twice_at_once_is_one_wish() {
    let _alone = alone();
    let (_directory, port) = bench(OBEYS);
    for signal in ["-INT", "-TERM"] {
        let mut run =
            AtTerminal::start(&format!("-p {port} -a 1 --yes sollwert 5Hz --enable --hold --on-exit quick-stop"));
        run.shows("note: running; Ctrl-C stops: quick-stop");
        run.signal(signal);
        run.signal(signal);
        assert_eq!(run.ends(), Some(130), "{signal}: {}", run.seen);
        run.shows("error: interrupted");
        assert!(!run.seen.contains("coast in place of"), "{signal}: {}", run.seen);
    }
}

#[test]
fn whoever_signals_again_and_again_gets_the_strongest_stop() {
    let _alone = alone();
    let (_directory, mut run) = turning();
    for _ in 0..10 {
        run.signal("-INT");
        thread::sleep(Duration::from_millis(60));
    }
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    run.shows("coast in place of quick-stop");
}

#[test]
fn the_fate_of_the_stop_is_told_on_stderr_where_the_reader_of_stdout_died_of_the_same_signal() {
    let _alone = alone();
    let (_directory, port) = bench(OBEYS);
    let mut run =
        AtTerminal::start_into(&format!("-p {port} -a 1 --yes --json sollwert 5Hz --enable --hold"), Stdio::piped());
    run.shows("note: running; Ctrl-C stops: ramp");
    run.signal("-INT");
    drop(run.child.stdout.take());
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    // Whether a look fell into the second in which the drive holds the shaft is the machine's that runs this.
    run.shows("; ramp: ");
    assert!(run.seen.contains("the stop was acknowledged") || run.seen.contains("without power"), "{}", run.seen);
}

#[test]
fn a_stop_goes_out_where_nobody_reads_what_comes_of_it() {
    let _alone = alone();
    let (_directory, port) = bench(OBEYS);
    for format in ["--json", "--format ndjson", ""] {
        for (verb, word) in [
            ("statemachine quick-stop", "> 01 06 01 9A 00 02"),
            ("statemachine disable", "> 01 06 01 9A 00 0"),
            ("statemachine disable-voltage", "> 01 06 01 9A 00 00"),
            ("sollwert 0", "> 01 65 01 E4 00 00 00 00"),
        ] {
            let line = format!("-v -p {port} -a 1 {format} {verb}");
            let mut run = AtTerminal::start_into(&line, Stdio::piped());
            drop(run.child.stdout.take());
            let exit = run.ends();
            run.shows(word);
            assert!(!run.seen.contains("interrupted"), "{line}: {exit:?} {}", run.seen);
        }
    }
}

#[test]
fn a_run_that_did_not_begin_because_nobody_reads_is_no_success() {
    let _alone = alone();
    let (_directory, port) = bench(OBEYS);
    let line = format!("-p {port} -a 1 --yes --json sollwert 5Hz --enable --hold");
    let mut run = AtTerminal::start_into(&line, Stdio::piped());
    drop(run.child.stdout.take());
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    run.shows("error: ");
}

/// Somebody pressed Ctrl-S, or looks at the first page in a pager: nothing of what is said is read.
#[test]
fn a_run_is_held_and_stopped_where_nobody_takes_what_it_says() {
    let _alone = alone();
    let (directory, port) = bench(OBEYS);
    let (shut_down, coast) = ("01 06 01 9A 00 07", "01 06 01 9A 00 00");
    for (verbose, end, signals) in [
        ("", "--duration 1s", &[][..]),
        ("-v", "--duration 1s", &[]),
        ("", "", &["-TERM"]),
        ("-v", "", &["-INT", "-TERM", "-INT"]),
    ] {
        let (reader, writer) = full_pipe();
        let line = format!("-p {port} -a 1 --force --yes {verbose} sollwert 5Hz --enable --hold {end}");
        let mut run = Mute::start(&line, writer, &directory.path().join("trace"));
        run.sends("01 65 01 E4 00 00 01 F4");
        for signal in signals {
            // Each is a wish of its own only if the one before was heard.
            thread::sleep(Duration::from_millis(700));
            run.signal(signal);
        }
        run.sends(if signals.len() > 1 { coast } else { shut_down });
        drop(reader);
        assert_eq!(run.ends(), Some(if signals.is_empty() { 0 } else { 130 }), "{line}");
    }
}

/// Whoever reads nothing holds up neither the stop nor, behind it, the end of the program; its exit code stands.
#[test]
fn a_run_that_is_over_ends_where_nobody_takes_what_it_says() {
    let _alone = alone();
    let (directory, port) = bench(OBEYS);
    for (signal, exit, stuck) in [
        (None, 0, ["err"].as_slice()),
        (Some("-TERM"), 130, &["err"]),
        (Some("-INT"), 130, &["out"]),
        (Some("-HUP"), 130, &["out", "err"]),
    ] {
        let (_reader, writer) = full_pipe();
        let end = if signal.is_some() { "" } else { "--duration 1s" };
        let line = format!("-p {port} -a 1 --force --yes -v sollwert 5Hz --enable --hold {end}");
        let to = |name: &str| if stuck.contains(&name) { writer.try_clone().unwrap().into() } else { Stdio::null() };
        let err = if stuck.contains(&"err") { to("err") } else { Stdio::piped() };
        let mut run = Mute::start_into(&line, to("out"), err, &directory.path().join("trace"));
        run.sends("01 65 01 E4 00 00 01 F4");
        if let Some(signal) = signal {
            thread::sleep(Duration::from_millis(700));
            run.signal(signal);
        }
        run.sends("01 06 01 9A 00 07");
        let begun = Instant::now();
        let said = run.child.stderr.take().map(|err| thread::spawn(move || std::io::read_to_string(err).unwrap()));
        assert_eq!(run.ends(), Some(exit), "{signal:?} {stuck:?}");
        assert!(begun.elapsed() < Duration::from_secs(20), "{signal:?} {stuck:?}: {:?}", begun.elapsed());
        // Where only stdout is stuck, the fate of the stop is told on stderr.
        if let Some(said) = said {
            let said = said.join().unwrap();
            assert!(said.contains("; ramp: ") || said.contains("note: ramp: "), "{said}");
        }
    }
}

/// A pager that is read page by page gets everything, however long that takes, where nothing turned.
#[test]
fn a_slow_reader_loses_nothing_of_what_is_only_read() {
    let _alone = alone();
    let (directory, port) = bench(OBEYS);
    let line = format!("-p {port} -a 1 -v read 480 372");
    let whole = crate::program::Piped::run(&line).1;
    for stuck in ["out", "err"] {
        let (mut reader, writer) = full_pipe();
        let (out, err) = match stuck {
            "out" => (writer.into(), Stdio::null()),
            _ => (Stdio::null(), writer.into()),
        };
        let mut run = Mute::start_into(&line, out, err, &directory.path().join(stuck));
        thread::sleep(Duration::from_secs(7));
        assert!(run.child.try_wait().unwrap().is_none(), "{stuck}");
        let read = thread::spawn(move || {
            let mut read = Vec::new();
            std::io::Read::read_to_end(&mut reader, &mut read).unwrap();
            String::from_utf8_lossy(&read).into_owned()
        });
        assert_eq!(run.ends(), Some(0), "{stuck}");
        let read = read.join().unwrap();
        let expected = if stuck == "out" { whole.trim() } else { "read P.372" };
        assert!(read.contains(expected), "{stuck}: {}", read.trim());
    }
}

#[test]
fn no_signal_that_can_be_heard_leaves_a_shaft_turning() {
    let _alone = alone();
    let (_directory, port) = bench(OBEYS);
    for signal in ["-QUIT", "-HUP", "-USR1", "-USR2", "-ALRM", "-VTALRM", "-PROF", "-XCPU", "-XFSZ", "-IO"] {
        let mut run = AtTerminal::start(&format!("-v -p {port} -a 1 --yes sollwert 5Hz --enable --hold"));
        run.shows("note: running; Ctrl-C stops: ramp");
        run.signal(signal);
        assert_eq!(run.ends(), Some(130), "{signal}: {}", run.seen);
        run.shows("> 01 06 01 9A 00 07");
    }
}

/// Neither the signal nor the terminal that goes away is a wish for a stronger stop of several, and the exit code is that of the stop.
#[test]
fn a_hang_up_ends_no_stop_of_several() {
    let _alone = alone();
    let drive = |address: u8| {
        format!(
            "[[drive]]\nmodel = \"acu\"\naddress = {address}\nbaud = 19200\n\
             set = {{ \"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 10, \"418\" = 0, \"424\" = 4, \"425\" = 4 }}\n"
        )
    };
    let (directory, _) = bench(&[drive(1), drive(2)].concat());
    let (file, link) = (directory.path().join("bench.toml"), directory.path().join("bus"));
    for is_signal in [true, false] {
        let mut line = AtTerminal::start(&format!("simulate {} --link {}", file.display(), link.display()));
        appears(&link, &line.seen);
        // They run up.
        thread::sleep(Duration::from_secs(1));
        let mut run = AtTerminal::start(&format!("-v -p {} -a 1,2 statemachine quick-stop", link.display()));
        run.shows("> 02 64 00 D2");
        // Whether a look fell into the second in which the drives hold their shafts is the machine's that runs this.
        let exit = match is_signal {
            true => {
                run.signal("-HUP");
                let exit = run.ends();
                assert!(!run.seen.contains("interrupted"), "{}", run.seen);
                exit
            }
            false => run.hangs_up(),
        };
        assert!([0, 8, 9].map(Some).contains(&exit), "{is_signal} {exit:?}");
        line.signal("-TERM");
        line.ends();
    }
}

#[test]
fn a_run_is_not_suspended() {
    let _alone = alone();
    let (_directory, port) = bench(OBEYS);
    let mut run = AtTerminal::start(&format!("-v -p {port} -a 1 --yes sollwert 5Hz --enable --hold --duration 3s"));
    run.shows("note: running; Ctrl-C stops: ramp");
    run.signal("-TTOU");
    for _ in 0..2 {
        run.signal("-TSTP");
        run.shows("this is not suspended while a shaft may turn");
        run.seen.clear();
    }
    run.shows("> 01 06 01 9A 00 07");
    assert_eq!(run.ends(), Some(0), "{}", run.seen);
}

/// The work was done; who does not wait for the stop behind it has interrupted all the same.
#[test]
fn a_signal_while_the_stop_at_the_end_is_under_way_is_told() {
    let _alone = alone();
    let (_directory, port) = bench(
        "[[drive]]\nmodel = \"act\"\nramps = { up_right = 99, down_right = 1, up_left = 99, down_left = 1 }\n\
                 set = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n",
    );
    let line = format!("-v -p {port} -a 1 --yes sollwert 40Hz --enable --hold --duration 1s");
    let mut run = AtTerminal::start(&line);
    run.shows("> 01 06 01 9A 00 07");
    run.signal("-INT");
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    run.shows("interrupted while it was stopped");
}

/// `ulimit -f` ends a write, not the program in the middle of its writes: the recording ends with a note, the load goes on.
#[test]
fn a_file_at_its_limit_ends_no_load() {
    let (directory, port) = bench("[[drive]]\nmodel = \"act\"\n");
    let dir = directory.path();
    let values: String = (480..484).map(|id| format!("{id} = {}\n", id - 460)).collect();
    std::fs::write(dir.join("f.toml"), format!("antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n{values}")).unwrap();
    // In blocks of 512 or 1024 bytes: room for the undo file, not for the recording.
    let line = format!(
        "ulimit -f 8; {program} -p {port} -a 1 --yes dataset load {dir}/f.toml --trace {dir}/t.txt",
        program = env!("CARGO_BIN_EXE_antrieb"),
        dir = dir.display()
    );
    let ended = std::process::Command::new("sh").args(["-c", &line]).env("LANG", "C").output().unwrap();
    let told = String::from_utf8_lossy(&ended.stderr);
    assert_eq!(ended.status.code(), Some(0), "{told}");
    assert!(String::from_utf8_lossy(&ended.stdout).contains("done, every value proven"), "{told}");
}

/// Who closes the terminal while several drives are stopped hears no more of it: the exit code is that of the stop, and nothing is wrong
/// with the port.
#[test]
fn a_terminal_that_goes_away_during_a_stop_is_no_fault_of_the_port() {
    let _alone = alone();
    let drive = |address: u8| {
        format!(
            "[[drive]]\nmodel = \"act\"\naddress = {address}\nset = {{ \"412\" = 1, \"410\" = 15, \"484\" = 10 }}\n"
        )
    };
    let (_directory, port) = bench(&format!("{}{}", drive(1), drive(2)));
    let mut run = AtTerminal::start(&format!("-v -p {port} -a 1-2 statemachine disable-voltage"));
    run.shows("> 02 06 01 9A 00 00");
    let exit = run.hangs_up();
    assert!(matches!(exit, Some(0 | 9 | 130)), "{exit:?}");
}
