//! The program itself, as a process: what only shows when there is a real one, with real pipes and a real environment.

use std::io::Read;
use std::process::{Command, Stdio};

#[test]
fn cases() {
    trycmd::TestCases::new()
        .env("LC_ALL", "C")
        .env("ANTRIEB_PORT", "")
        // No configuration of the one who runs the tests.
        .env("XDG_CONFIG_HOME", "/nonexistent")
        .env("HOME", "/nonexistent")
        .env("COLUMNS", "100")
        .insert_var("[VERSION]", env!("CARGO_PKG_VERSION"))
        .unwrap()
        .case("tests/cmd/*.trycmd")
        .case("README.md")
        .case("docs/first-day.md")
        .case("docs/active.md")
        .case("docs/lexium.md")
        .case("docs/catalogues.md")
        .case("docs/profibus.md")
        .case("docs/can.md")
        .case("docs/system-bus.md")
        .case("docs/recording.md")
        .case("docs/feeding.md");
}

fn antrieb(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_antrieb"));
    command.args(arguments).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.env_clear().env("XDG_CONFIG_HOME", "/nonexistent").env("HOME", "/nonexistent");
    command
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    for format in ["table", "json", "ndjson", "csv"] {
        let mut child = antrieb(&["params", "--format", format]).spawn().unwrap();
        let mut start = [0; 16];
        let mut out = child.stdout.take().unwrap();
        out.read_exact(&mut start).unwrap();
        drop(out);
        let ended = child.wait_with_output().unwrap();
        assert_eq!(ended.status.code(), Some(0), "{format}: {}", String::from_utf8_lossy(&ended.stderr));
        assert_eq!(String::from_utf8_lossy(&ended.stderr), "", "{format}");
    }
}

#[test]
fn nobody_has_to_read_stderr() {
    let mut child = antrieb(&["-p", "sim", "-v", "-a", "1", "read", "@all"]).spawn().unwrap();
    drop(child.stderr.take());
    let ended = child.wait_with_output().unwrap();
    assert_eq!(ended.status.code(), Some(0));
    assert!(!ended.stdout.is_empty());
}

/// What cannot be written, and what cannot be opened, is neither an interrupt nor a bug of ours.
#[cfg(target_os = "linux")]
#[test]
fn what_the_system_does_not_give_is_named() {
    let run = "-p sim -a 1 --yes --format ndjson sollwert 5Hz --enable --hold --duration 2s --take-control";
    let mut full = antrieb(&run.split(' ').collect::<Vec<_>>());
    let ended = full.stdout(std::fs::File::options().write(true).open("/dev/full").unwrap()).output().unwrap();
    let told = String::from_utf8_lossy(&ended.stderr).into_owned();
    assert_eq!(ended.status.code(), Some(3), "{told}");
    assert!(told.contains("cannot write the output: No space left"), "{told}");
    for files in 4..12 {
        let line = format!("ulimit -n {files}; exec {} --lang en -p sim -a 1 read 411", env!("CARGO_BIN_EXE_antrieb"));
        let ended = Command::new("bash").args(["-c", &line]).output().unwrap();
        let told = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert_eq!(ended.status.code(), Some(3), "{files}: {told}");
        assert!(told.contains("too few files can be opened"), "{files}: {told}");
    }
}

/// Who reopens a port that was lost shall not do so because of a disk; what is in the file ends with a whole line.
#[cfg(target_os = "linux")]
#[test]
fn a_record_that_has_no_place_any_more_is_named_and_is_no_lost_port() {
    let directory = tempfile::tempdir().unwrap();
    let watch = "-p sim -a 1 monitor --count 500 --interval 0 --unpaced --format csv --record watch.ndjson";
    for (lang, why) in [("en", "File too large"), ("de", "die Datei wird zu groß")] {
        let line = format!("ulimit -f 8; exec {} --lang {lang} {watch} --force", env!("CARGO_BIN_EXE_antrieb"));
        let ended = Command::new("bash").args(["-c", &line]).current_dir(&directory).output().unwrap();
        let told = String::from_utf8_lossy(&ended.stderr).into_owned();
        assert_eq!(ended.status.code(), Some(7), "{told}");
        assert!(told.contains("watch.ndjson: ") && told.contains(why), "{told}");
        let kept = std::fs::read_to_string(directory.path().join("watch.ndjson")).unwrap();
        assert!(kept.ends_with("}\n") && kept.lines().count() > 1, "{kept}");
    }
}

/// A script that keeps recordings must not take half of one for the whole.
#[cfg(target_os = "linux")]
#[test]
fn a_recording_that_has_no_place_any_more_is_a_warning_whatever_was_recorded() {
    let directory = tempfile::tempdir().unwrap();
    for what in ["-a 1 read @all", "scan", "--protocol dp scan", "--protocol sdo scan"] {
        let line =
            format!("ulimit -f 1; exec {} -p sim {what} --json --trace t.txt --force", env!("CARGO_BIN_EXE_antrieb"));
        let ended = Command::new("bash").args(["-c", &line]).current_dir(&directory).output().unwrap();
        let document: serde_json::Value = serde_json::from_slice(&ended.stdout).unwrap();
        let codes: Vec<_> = document["warnings"].as_array().unwrap().iter().map(|warning| &warning["code"]).collect();
        assert!(codes.contains(&&serde_json::json!("trace.cut")), "{what}: {document}");
    }
}

#[test]
fn the_project_file_lies_in_the_working_directory() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("antrieb.toml"), "port = \"sim\"\n[drives.pump]\naddress = 2\n").unwrap();
    let ended = antrieb(&["-a", "pump", "read", "1376"]).current_dir(&directory).output().unwrap();
    assert_eq!(ended.status.code(), Some(0), "{}", String::from_utf8_lossy(&ended.stderr));
    assert!(String::from_utf8_lossy(&ended.stdout).contains("Modbus address"));
}

#[test]
fn the_environment_chooses_the_language() {
    let ended = antrieb(&["-p", "sim", "-a", "1", "read", "372"]).env("LANG", "de_DE.UTF-8").output().unwrap();
    assert!(String::from_utf8_lossy(&ended.stdout).contains("Bemessungsdrehzahl"));
    let ended = antrieb(&["-a", "1", "read", "372"]).env("ANTRIEB_PORT", "sim").output().unwrap();
    assert!(String::from_utf8_lossy(&ended.stdout).contains("Rated Speed"));
}

/// The script that bash loads, in a bash: values by the program, the rest by the script.
#[cfg(unix)]
#[test]
fn bash_completes_values_and_options() {
    let script = antrieb(&["completions", "bash"]).output().unwrap().stdout;
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("script"), script).unwrap();
    std::fs::write(directory.path().join("antrieb.toml"), "[drives.pump]\naddress = 1\n").unwrap();
    let program = env!("CARGO_BIN_EXE_antrieb");
    // As readline parts a line: `=` and `@` are words of their own, and behind `=` nothing is typed yet.
    for (words, typed, completed) in [
        ("read rated-sp", "rated-sp", "rated-speed"),
        ("read 372 @ al", "al", "all allram"),
        ("write 395 =", "", "vcb-bus-vabus p-bus-special-applications modbus-rtu modbus-ascii 0 1 2 3"),
        ("-a pu", "pu", "pump"),
        ("diag --link", "--link", "--link-test"),
        ("sni", "sni", "sniff"),
    ] {
        let line = words.replace(" @ ", "@").replace(" =", "=");
        let ask = format!(
            "source ./script; COMP_LINE='{program} {line}'; COMP_POINT=${{#COMP_LINE}}; COMP_WORDS=({program} {words}); \
             COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); _antrieb_values {program} '{typed}' \
             \"${{COMP_WORDS[COMP_CWORD-1]}}\" 2>/dev/null; echo \"${{COMPREPLY[*]}}\""
        );
        let Ok(told) = Command::new("bash").args(["--norc", "-c", &ask]).current_dir(&directory).output() else {
            return;
        };
        assert_eq!(String::from_utf8_lossy(&told.stdout).trim(), completed, "{line}");
    }
}

#[cfg(unix)]
#[test]
fn arguments_need_not_be_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;
    let strange = OsStr::from_bytes(b"\xFF\xFE");
    let ended = antrieb(&["-p", "sim", "read"]).arg(strange).output().unwrap();
    assert_eq!(ended.status.code(), Some(2));
    let ended = antrieb(&["--catalogue"]).arg(strange).args(["params", "372"]).output().unwrap();
    assert_eq!(ended.status.code(), Some(7), "{}", String::from_utf8_lossy(&ended.stderr));
}
