//! Signals to the real program at a real terminal: what no virtual time shows.
#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "what a test needs and does not get ends it")]
#![expect(clippy::disallowed_methods, reason = "processes and terminals have a time of their own")]

use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use std::fs::File;
use std::io::{Read, Write};
use std::os::fd::OwnedFd;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

/// Longer than anything here takes on a busy machine.
const LIMIT: Duration = Duration::from_secs(20);

/// The program at a terminal of its own.
struct AtTerminal {
    child: Child,
    keyboard: File,
    screen: Receiver<Vec<u8>>,
    seen: String,
}

impl AtTerminal {
    fn start(line: &str) -> Self {
        Self::start_into(line, Stdio::null())
    }

    fn start_into(line: &str, out: Stdio) -> Self {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&master).unwrap();
        unlockpt(&master).unwrap();
        let name = ptsname(&master, Vec::new()).unwrap();
        let slave: OwnedFd = File::options().read(true).write(true).open(name.to_str().unwrap()).unwrap().into();
        let keyboard = File::from(master);
        let mut eyes = keyboard.try_clone().unwrap();
        let child = Command::new(env!("CARGO_BIN_EXE_antrieb"))
            .args(["--no-config", "--lang", "en"])
            .args(line.split_whitespace())
            .stdin(Stdio::from(slave.try_clone().unwrap()))
            .stdout(out)
            .stderr(Stdio::from(slave))
            .spawn()
            .unwrap();
        let (sender, screen) = channel();
        thread::spawn(move || {
            let mut buffer = [0; 4096];
            while let Ok(count @ 1..) = eyes.read(&mut buffer) {
                if sender.send(buffer[..count].to_vec()).is_err() {
                    break;
                }
            }
        });
        AtTerminal { child, keyboard, screen, seen: String::new() }
    }

    /// Waits until this stands on the screen.
    #[track_caller]
    fn shows(&mut self, text: &str) {
        let deadline = Instant::now() + LIMIT;
        while !self.seen.contains(text) {
            let left = deadline.saturating_duration_since(Instant::now());
            let bytes = self.screen.recv_timeout(left);
            let bytes = bytes.unwrap_or_else(|_| panic!("no '{text}' in:\n{}", self.seen));
            self.seen += &String::from_utf8_lossy(&bytes);
        }
    }

    fn signal(&self, name: &str) {
        assert!(Command::new("kill").args([name, &self.child.id().to_string()]).status().unwrap().success());
    }

    /// Must end by itself, soon; returns the exit code.
    #[track_caller]
    fn ends(&mut self) -> Option<i32> {
        let deadline = Instant::now() + LIMIT;
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status.code();
            }
            if Instant::now() > deadline {
                self.child.kill().unwrap();
                panic!("still there after {LIMIT:?}:\n{}", self.seen);
            }
            thread::sleep(Duration::from_millis(5));
        }
    }
}

#[test]
fn a_signal_at_the_question_ends_it_at_once_and_a_later_yes_writes_nothing() {
    for signal in ["-INT", "-TERM", "-HUP"] {
        let mut run = AtTerminal::start("-v -p sim -a 1 write 480@1=7Hz");
        run.shows("go on? [y/N]");
        run.signal(signal);
        assert_eq!(run.ends(), Some(130), "{signal}: {}", run.seen);
        let _gone = run.keyboard.write_all(b"y\n");
        run.shows("nothing was sent");
        assert!(!run.seen.contains("> 01 65"), "{signal}: {}", run.seen);
    }
}

#[test]
fn every_further_signal_shortens_the_stop() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    let bench = "[[drive]]\nmodel = \"act\"\nramps = { up_right = 99, down_right = 1, up_left = 99, down_left = 1 }\n\
                 set = { \"412\" = 1, \"434\" = 2, \"418\" = 0, \"424\" = 1, \"425\" = 1 }\n";
    std::fs::write(&file, bench).unwrap();
    let path = file.display();
    let mut run =
        AtTerminal::start(&format!("-v -p sim:{path} -a 1 --yes sollwert 40Hz --enable --until reached --hold"));
    run.shows("> 01 65 01 E4 00 00 0F A0");
    // Held once it is given again.
    thread::sleep(Duration::from_millis(1_500));
    run.shows("note: running; Ctrl-C stops: ramp");
    let begun = Instant::now();
    for (signal, sends) in
        [("-INT", "> 01 06 01 9A 00 07"), ("-TERM", "> 01 06 01 9A 00 02"), ("-INT", "> 01 06 01 9A 00 00")]
    {
        run.signal(signal);
        run.shows(sends);
    }
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    run.shows("note: stopping: ramp; another Ctrl-C: quick-stop");
    assert!(begun.elapsed() < Duration::from_secs(8), "the ramp would take 40 s: {:?}", begun.elapsed());
    run.shows("ramp -> coast: without power, but the shaft still turns");
    assert!(run.seen.contains("quick-stop in place of ramp") && run.seen.contains("coast in place of quick-stop"));
}

#[test]
fn the_fate_of_the_stop_is_told_on_stderr_where_the_reader_of_stdout_died_of_the_same_signal() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 2 }\n").unwrap();
    let mut run = AtTerminal::start_into(
        &format!("-p sim:{} -a 1 --yes --json sollwert 5Hz --enable --hold", file.display()),
        Stdio::piped(),
    );
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
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 2 }\n").unwrap();
    for format in ["--json", "--format ndjson", ""] {
        for (verb, word) in [
            ("statemachine quick-stop", "> 01 06 01 9A 00 02"),
            ("statemachine disable", "> 01 06 01 9A 00 0"),
            ("statemachine disable-voltage", "> 01 06 01 9A 00 00"),
            ("sollwert 0", "> 01 65 01 E4 00 00 00 00"),
        ] {
            let line = format!("-v -p sim:{} -a 1 {format} {verb}", file.display());
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
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 2 }\n").unwrap();
    let line = format!("-p sim:{} -a 1 --yes --json sollwert 5Hz --enable --hold", file.display());
    let mut run = AtTerminal::start_into(&line, Stdio::piped());
    drop(run.child.stdout.take());
    assert_eq!(run.ends(), Some(130), "{}", run.seen);
    run.shows("error: ");
}
