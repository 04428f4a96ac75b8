//! One folder, a bash for each command in it, and an end for what does not end.

use crate::files::{self, Around};
use crate::table::{How, Row};
use std::fs::{File, Permissions};
use std::os::unix::fs::{PermissionsExt, symlink};
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;

/// Longer than any command takes on a busy machine.
const LIMIT: Duration = Duration::from_secs(60);

/// Every question is answered, as somebody who types the command would; a pipe fails as its first part does.
const BEFORE: &str = "set -o pipefail\n\
    antrieb() { case \" $* \" in *' --yes '*) command antrieb \"$@\" ;; *) command antrieb --yes \"$@\" ;; esac; }\n";

/// Nothing else is run from a page: who installs something, or is root, is listed in the table.
const HARMLESS: &[&str] = &["antrieb", "cp", "mkdir", "printf", "tshark"];

/// How ports of this machine begin: a drive that hangs there is nobody's bench.
const REAL: &[&str] = &["/dev/", "COM", "://", "can:can"];

/// A folder with what the commands of a page find there.
pub(crate) struct Shell {
    folder: TempDir,
    around: Around,
    /// A command that goes on beside the next one.
    beside: Option<String>,
}

impl Shell {
    /// The folder of a page.
    pub(crate) fn new(page: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        symlink(env!("CARGO_BIN_EXE_antrieb"), folder.path().join("antrieb")).unwrap();
        let shell = Shell { folder, around: files::of(page), beside: None };
        shell.around.files.iter().for_each(|(name, text)| shell.write(name, text));
        shell
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        let path = self.path(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, text).unwrap();
    }

    /// Runs a command of a page; whether it ran, or what is wrong with it.
    pub(crate) fn runs(&mut self, typed: &str, row: &Row<'_>) -> Result<bool, String> {
        let expected = match row.how {
            How::Left(_) => return Ok(false),
            How::Needs(program) if !is_there(program) => return Ok(false),
            How::Needs(_) => 0,
            How::Exits(code) => code,
        };
        row.files.iter().for_each(|(name, text)| self.write(name, text));
        let mut line = typed.to_owned();
        for (from, to) in row.but.iter().chain(self.around.ports) {
            line = line.replace(from, to);
        }
        let missed = row.but.iter().find(|(from, _)| !typed.contains(from));
        if let Some((from, _)) = missed {
            return Err(format!("the row replaces '{from}', which is not in the line"));
        }
        if let Some(other) = line.split(['|', ';', '&', '(', '`']).find_map(first_unknown) {
            return Err(format!("'{other}' is not run from a page: say in the table why not"));
        }
        if let Some(port) = REAL.iter().find(|port| line.contains(**port)) {
            return Err(format!("'{port}' is no bench: say in `files` or in the table what stands for it"));
        }
        if let Some(before) = line.strip_suffix('&') {
            self.beside =
                Some(format!("{before}& trap \"kill $!\" EXIT\nuntil test -e {}; do sleep 0.02; done\n", row.tells));
            return Ok(true);
        }
        let line = format!("{}{line}{}", self.beside.take().unwrap_or_default(), row.more);
        let (code, out) = self.bash(&line);
        if code == Some(expected) && out.contains(row.tells) {
            return Ok(true);
        }
        Err(format!("ran: {line}\nexit {code:?}, expected {expected} and '{}'\n{}", row.tells, shortened(&out)))
    }

    /// Whether the program knows the words of a command that stands in the text of a page: its help comes only behind words that it knows.
    pub(crate) fn knows(&self, typed: &str) -> Option<String> {
        let asks = if typed.contains("--help") { "" } else { " --help" };
        let (code, out) = self.bash(&format!("{typed}{asks}"));
        (code != Some(0)).then(|| format!("exit {code:?}\n{}", shortened(&out)))
    }

    /// Runs a line; its exit code and all that it says.
    fn bash(&self, line: &str) -> (Option<i32>, String) {
        let told = self.path(".told");
        let into = File::create(&told).unwrap();
        let path = std::env::var("PATH").unwrap();
        let mut child = Command::new("bash")
            .args(["--norc", "-c", &format!("{BEFORE}{line}")])
            .current_dir(&self.folder)
            .env_clear()
            .env("PATH", format!("{}:{path}", self.folder.path().display()))
            .envs([("LC_ALL", "C"), ("ANTRIEB_PORT", self.around.bench), ("COLUMNS", "100")])
            .env("HOME", self.folder.path())
            .stdin(Stdio::null())
            .stdout(into.try_clone().unwrap())
            .stderr(into)
            .process_group(0)
            .spawn()
            .unwrap();
        let begun = Instant::now();
        let code = loop {
            if let Some(status) = child.try_wait().unwrap() {
                break status.code();
            }
            if begun.elapsed() > LIMIT {
                // With all that it has started.
                Command::new("kill").args(["-9", "--", &format!("-{}", child.id())]).status().unwrap();
                child.wait().unwrap();
                break None;
            }
            std::thread::sleep(Duration::from_millis(10));
        };
        (code, String::from_utf8_lossy(&std::fs::read(&told).unwrap()).into_owned())
    }
}

/// The program of a part of a line, if it is not one that is run.
fn first_unknown(part: &str) -> Option<&str> {
    part.split_whitespace().next().filter(|word| !HARMLESS.contains(word))
}

fn is_there(program: &str) -> bool {
    let path = std::env::var("PATH").unwrap();
    let runs = |file: PathBuf| file.metadata().is_ok_and(|file| Permissions::mode(&file.permissions()) & 0o111 != 0);
    path.split(':').any(|folder| runs(PathBuf::from(folder).join(program)))
}

/// The end of what was said, where the reason stands.
fn shortened(out: &str) -> String {
    let lines: Vec<&str> = out.lines().collect();
    lines[lines.len().saturating_sub(12)..].join("\n")
}
