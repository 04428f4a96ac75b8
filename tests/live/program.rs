//! The program as a process: at a terminal of its own, or with what it prints read line by line.

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{LocalModes, Winsize};
use serde_json::Value;
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Write};
use std::os::fd::OwnedFd;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Longer than anything here takes on a busy machine.
const LIMIT: Duration = Duration::from_secs(240);

/// The turn of one test: side by side they would take each other's time.
pub(crate) fn alone() -> MutexGuard<'static, ()> {
    static TURN: Mutex<()> = Mutex::new(());
    TURN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Waits until a bench serves its link; what was seen of it stands in the message if it never does.
pub(crate) fn appears(link: &Path, seen: &str) {
    let begun = Instant::now();
    while !link.exists() {
        assert!(begun.elapsed() < Duration::from_secs(30), "{seen}");
        thread::sleep(Duration::from_millis(20));
    }
}

/// What is typed behind `antrieb`, with nobody's configuration.
fn antrieb(line: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
    command.args(["--no-config", "--lang", "en"]).args(line.split_whitespace());
    command
}

/// What a process writes, as it comes; ends with the process.
fn chunks(mut from: impl Read + Send + 'static) -> Receiver<Vec<u8>> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        let mut buffer = [0; 4096];
        while let Ok(count @ 1..) = from.read(&mut buffer) {
            if sender.send(buffer[..count].to_vec()).is_err() {
                break;
            }
        }
    });
    receiver
}

/// Must end by itself; returns the exit code.
#[track_caller]
fn ends(child: &mut Child, seen: &str) -> Option<i32> {
    let deadline = Instant::now() + LIMIT;
    loop {
        if let Some(status) = child.try_wait().unwrap() {
            return status.code();
        }
        if Instant::now() > deadline {
            child.kill().unwrap();
            panic!("still there after {LIMIT:?}:\n{seen}");
        }
        thread::sleep(Duration::from_millis(5));
    }
}

fn signal(child: &Child, name: &str) {
    assert!(Command::new("kill").args([name, &child.id().to_string()]).status().unwrap().success());
}

/// What was drawn, one behind the other: where the cursor goes elsewhere there is a blank, because blanks are not drawn.
fn picture(seen: &str) -> String {
    let mut parts = seen.split("\u{1b}[");
    let first = parts.next().unwrap_or_default().to_owned();
    let drawn = parts.map(|part| match part.split_once(|letter: char| letter.is_ascii_alphabetic()) {
        Some((code, text)) if part[code.len()..].starts_with('H') => format!(" {text}"),
        Some((_, text)) => text.to_owned(),
        None => String::new(),
    });
    std::iter::once(first).chain(drawn).collect()
}

/// A terminal: what a person has before him, and what a program gets.
fn terminal() -> (File, OwnedFd) {
    let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC).unwrap();
    grantpt(&master).unwrap();
    unlockpt(&master).unwrap();
    let name = ptsname(&master, Vec::new()).unwrap();
    let slave = File::options().read(true).write(true).open(name.to_str().unwrap()).unwrap().into();
    (File::from(master), slave)
}

fn resize(keyboard: &File, columns: u16, lines: u16) {
    let size = Winsize { ws_col: columns, ws_row: lines, ws_xpixel: 0, ws_ypixel: 0 };
    rustix::termios::tcsetwinsize(keyboard, size).unwrap();
}

/// A terminal that is read until nobody wants to hear of it, so that it can be closed.
struct Until {
    terminal: File,
    deaf: Arc<AtomicBool>,
}

impl Read for Until {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let look = Timespec { tv_sec: 0, tv_nsec: 20_000_000 };
        while !self.deaf.load(Ordering::Relaxed) {
            let mut watched = [PollFd::new(&self.terminal, PollFlags::IN)];
            if poll(&mut watched, Some(&look)).unwrap() > 0 {
                return self.terminal.read(buffer);
            }
        }
        Ok(0)
    }
}

/// The program at a terminal of its own.
pub(crate) struct AtTerminal {
    pub(crate) child: Child,
    keyboard: File,
    pub(crate) seen: String,
    screen: Receiver<Vec<u8>>,
    /// Nobody reads the screen any more.
    deaf: Arc<AtomicBool>,
}

impl AtTerminal {
    pub(crate) fn start(line: &str) -> Self {
        Self::start_into(line, Stdio::null())
    }

    pub(crate) fn start_into(line: &str, out: Stdio) -> Self {
        let (keyboard, slave) = terminal();
        let child = antrieb(line)
            .stdin(Stdio::from(slave.try_clone().unwrap()))
            .stdout(out)
            .stderr(Stdio::from(slave))
            .spawn()
            .unwrap();
        Self::of(child, keyboard)
    }

    /// With stdout at the terminal as well, of 80 columns and 24 lines.
    pub(crate) fn whole(line: &str) -> Self {
        let (keyboard, slave) = terminal();
        resize(&keyboard, 80, 24);
        let mut command = antrieb(line);
        command.env("TERM", "xterm-256color").stdin(Stdio::from(slave.try_clone().unwrap()));
        let child = command.stdout(Stdio::from(slave.try_clone().unwrap())).stderr(Stdio::from(slave)).spawn().unwrap();
        // What is handed to the child is open here as long as the command is.
        drop(command);
        Self::of(child, keyboard)
    }

    /// In a shell script at a terminal of its own, where `$antrieb` is the program; `None` where nobody gives a shell one.
    pub(crate) fn script(text: &str) -> Option<Self> {
        let (keyboard, slave) = terminal();
        let program = concat!(env!("CARGO_BIN_EXE_antrieb"), " --no-config --lang en");
        let mut command = Command::new("setsid");
        command
            .args(["--ctty", "sh", "-c", text])
            .env("antrieb", program)
            .stdin(Stdio::from(slave.try_clone().unwrap()));
        let child = command.stdout(Stdio::from(slave.try_clone().unwrap())).stderr(Stdio::from(slave)).spawn();
        drop(command);
        child.ok().map(|child| Self::of(child, keyboard))
    }

    fn of(child: Child, keyboard: File) -> Self {
        let deaf = Arc::<AtomicBool>::default();
        let screen = chunks(Until { terminal: keyboard.try_clone().unwrap(), deaf: deaf.clone() });
        AtTerminal { child, keyboard, screen, deaf, seen: String::new() }
    }

    /// Gives the terminal another size.
    pub(crate) fn resizes(&self, columns: u16, lines: u16) {
        resize(&self.keyboard, columns, lines);
    }

    /// Waits until this stands in a picture that is drawn anew, as it is for each new size.
    #[track_caller]
    pub(crate) fn draws(&mut self, text: &str) {
        self.seen.clear();
        let deadline = Instant::now() + LIMIT;
        for columns in [81, 80].into_iter().cycle() {
            self.resizes(columns, 24);
            let drawn = Instant::now() + Duration::from_millis(500);
            while let Ok(bytes) = self.screen.recv_timeout(drawn.saturating_duration_since(Instant::now())) {
                self.seen += &String::from_utf8_lossy(&bytes);
                if picture(&self.seen).contains(text) {
                    return;
                }
            }
            assert!(Instant::now() < deadline, "no '{text}' in:\n{}", self.seen);
        }
    }

    /// Waits until this stands in the picture, whose size stays.
    #[track_caller]
    pub(crate) fn pictures(&mut self, text: &str) {
        let deadline = Instant::now() + Duration::from_secs(15);
        while !picture(&self.seen).contains(text) {
            let left = deadline.saturating_duration_since(Instant::now());
            let bytes = self.screen.recv_timeout(left);
            let bytes = bytes.unwrap_or_else(|_| panic!("no '{text}' in:\n{}", self.seen));
            self.seen += &String::from_utf8_lossy(&bytes);
        }
    }

    /// Whether the terminal hands on whole lines and shows what is typed, as before.
    pub(crate) fn is_cooked(&self) -> bool {
        let modes = rustix::termios::tcgetattr(&self.keyboard).unwrap().local_modes;
        modes.contains(LocalModes::ICANON | LocalModes::ECHO)
    }

    /// The program's side of the terminal: what is typed and not read waits there for who comes next.
    pub(crate) fn other_side(&self) -> File {
        let name = ptsname(&self.keyboard, Vec::new()).unwrap();
        File::options().read(true).write(true).open(name.to_str().unwrap()).unwrap()
    }

    /// Nobody reads the screen from now on.
    pub(crate) fn looks_away(&self) {
        self.deaf.store(true, Ordering::Relaxed);
    }

    /// The terminal goes away; returns the exit code.
    #[track_caller]
    pub(crate) fn hangs_up(self) -> Option<i32> {
        let AtTerminal { mut child, keyboard, seen, screen, deaf } = self;
        deaf.store(true, Ordering::Relaxed);
        drop(keyboard);
        let exit = ends(&mut child, &seen);
        drop(screen);
        exit
    }

    /// Waits until this stands on the screen.
    #[track_caller]
    pub(crate) fn shows(&mut self, text: &str) {
        let deadline = Instant::now() + LIMIT;
        while !self.seen.contains(text) {
            let left = deadline.saturating_duration_since(Instant::now());
            let bytes = self.screen.recv_timeout(left);
            let bytes = bytes.unwrap_or_else(|_| panic!("no '{text}' in:\n{}", self.seen));
            self.seen += &String::from_utf8_lossy(&bytes);
        }
    }

    /// Somebody types this.
    pub(crate) fn types(&mut self, text: &str) {
        // Nobody reads what is typed to a program that has ended.
        let _gone = self.keyboard.write_all(text.as_bytes());
    }

    pub(crate) fn signal(&self, name: &str) {
        signal(&self.child, name);
    }

    /// Must end by itself; returns the exit code.
    #[track_caller]
    pub(crate) fn ends(&mut self) -> Option<i32> {
        ends(&mut self.child, &self.seen)
    }
}

/// A shell at a terminal of its own, with the program on its path.
pub(crate) struct Shell(AtTerminal);

impl Shell {
    /// `words` start it, `taught` is typed first and ends by printing `ready`.
    pub(crate) fn start(words: &[&str], taught: &str, directory: &Path) -> Self {
        let (keyboard, slave) = terminal();
        resize(&keyboard, 200, 50);
        let programs = Path::new(env!("CARGO_BIN_EXE_antrieb")).parent().unwrap().display();
        let path = format!("{programs}:{}", std::env::var("PATH").unwrap());
        let (program, arguments) = words.split_first().unwrap();
        let mut command = Command::new(program);
        command.args(arguments).current_dir(directory).env("HOME", directory).env("PATH", path);
        command.env("TERM", "dumb").env("LC_ALL", "C").env("INPUTRC", "/dev/null").env("PS1", "$ ");
        command.stdin(Stdio::from(slave.try_clone().unwrap())).stdout(Stdio::from(slave.try_clone().unwrap()));
        let child = command.stderr(Stdio::from(slave)).spawn().unwrap();
        drop(command);
        let mut shell = Shell(AtTerminal::of(child, keyboard));
        shell.0.types(taught);
        shell.0.shows("\nready");
        shell
    }

    /// What stands in the command line behind a Tab; the shell prints it between << and >> when it gets Ctrl-T.
    #[track_caller]
    pub(crate) fn completes(&mut self, typed: &str) -> String {
        self.0.seen.clear();
        // Ctrl-U empties the line.
        self.0.types(&format!("\u{15}{typed}\t\u{14}"));
        self.0.shows(">>");
        let (_, behind) = self.0.seen.split_once("<<").unwrap();
        let (line, _) = behind.split_once(">>").unwrap();
        line.to_owned()
    }
}

impl Drop for Shell {
    fn drop(&mut self) {
        // It may have ended by itself.
        let _gone = self.0.child.kill();
        let _code = self.0.child.wait();
    }
}

/// The program in a pipe, without a terminal.
pub(crate) struct Piped {
    child: Child,
    lines: Receiver<String>,
    err: Receiver<Vec<u8>>,
    /// What it printed until now.
    pub(crate) records: Vec<Value>,
}

impl Piped {
    pub(crate) fn start(line: &str) -> Self {
        Self::over(line, Stdio::null())
    }

    /// With somebody who calls by lines.
    pub(crate) fn called(line: &str) -> Self {
        Self::over(line, Stdio::piped())
    }

    fn over(line: &str, input: Stdio) -> Self {
        let mut child = antrieb(line).stdin(input).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let (sender, lines) = channel();
        let out = BufReader::new(child.stdout.take().unwrap());
        thread::spawn(move || {
            for line in out.lines().map_while(Result::ok) {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
        let err = chunks(child.stderr.take().unwrap());
        Piped { child, lines, err, records: Vec::new() }
    }

    /// Writes a line.
    pub(crate) fn call(&mut self) {
        self.child.stdin.as_mut().unwrap().write_all(b"\n").unwrap();
    }

    /// Closes what it reads.
    pub(crate) fn leave(&mut self) {
        self.child.stdin = None;
    }

    /// Reads records until one is such.
    #[track_caller]
    pub(crate) fn until(&mut self, what: &str, is: impl Fn(&Value) -> bool) {
        let deadline = Instant::now() + LIMIT;
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            let line = self.lines.recv_timeout(left);
            let line = line.unwrap_or_else(|_| panic!("no {what} behind {:#?}\n{}", self.records, self.said()));
            self.records.push(serde_json::from_str(&line).unwrap());
            if self.records.last().is_some_and(&is) {
                return;
            }
        }
    }

    pub(crate) fn signal(&self, name: &str) {
        signal(&self.child, name);
    }

    /// Must end by itself; reads what it prints until then, and returns the exit code.
    #[track_caller]
    pub(crate) fn ends(&mut self) -> Option<i32> {
        let exit = ends(&mut self.child, "");
        self.records.extend(self.lines.iter().map(|line| serde_json::from_str::<Value>(&line).unwrap()));
        exit
    }

    /// What it said on stderr until now.
    pub(crate) fn said(&self) -> String {
        self.err.try_iter().map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).collect()
    }

    /// Runs to its end and returns the exit code and the whole of stdout and stderr.
    #[track_caller]
    pub(crate) fn run(line: &str) -> (Option<i32>, String, String) {
        let mut program = Self::start(line);
        let exit = ends(&mut program.child, "");
        let out: Vec<String> = program.lines.iter().collect();
        let err: Vec<u8> = program.err.iter().flatten().collect();
        (exit, out.join("\n"), String::from_utf8_lossy(&err).into_owned())
    }
}

/// A pipe that is full, whatever it holds, so that who writes to it and waits, waits until the reader is gone.
pub(crate) fn full_pipe() -> (std::io::PipeReader, std::io::PipeWriter) {
    let (reader, writer) = std::io::pipe().unwrap();
    let mut filler = writer.try_clone().unwrap();
    thread::spawn(move || filler.write_all(&[b'\n'; 4 << 20]));
    thread::sleep(Duration::from_millis(100));
    (reader, writer)
}

/// The program with stderr into this.
pub(crate) struct Mute {
    pub(crate) child: Child,
    trace: PathBuf,
}

impl Mute {
    /// Records the line to `trace`, the only thing that tells what it does.
    pub(crate) fn start(line: &str, err: std::io::PipeWriter, trace: &Path) -> Self {
        Self::start_into(line, Stdio::null(), err.into(), trace)
    }

    pub(crate) fn start_into(line: &str, out: Stdio, err: Stdio, trace: &Path) -> Self {
        let line = format!("--trace {} {line}", trace.display());
        let child = antrieb(&line).stdin(Stdio::null()).stdout(out).stderr(err).spawn().unwrap();
        Mute { child, trace: trace.to_owned() }
    }

    /// Waits until this stands in the record of the line.
    #[track_caller]
    pub(crate) fn sends(&mut self, telegram: &str) {
        let deadline = Instant::now() + LIMIT;
        loop {
            let trace = std::fs::read_to_string(&self.trace).unwrap_or_default();
            if trace.contains(telegram) {
                return;
            }
            if Instant::now() > deadline {
                self.child.kill().unwrap();
                panic!("no '{telegram}' in:\n{trace}");
            }
            thread::sleep(Duration::from_millis(20));
        }
    }

    pub(crate) fn signal(&self, name: &str) {
        signal(&self.child, name);
    }

    /// Must end by itself; returns the exit code.
    #[track_caller]
    pub(crate) fn ends(&mut self) -> Option<i32> {
        ends(&mut self.child, "")
    }
}
