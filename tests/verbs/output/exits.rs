//! The exit codes of the contract, each reached.

use crate::run::antrieb;

#[test]
fn every_exit_code_is_reached() {
    for (code, class, line) in [
        (1, "no", "-p sim -a 9 scan"),
        (2, "usage", "-p sim -a 300 read 372"),
        (3, "port", "-p /dev/antrieb-has-no-such-port -a 1 read 372"),
        (4, "silence", "-p sim -a 9 read 372"),
        (6, "refused", "-p sim -a 1 read 1600"),
        (7, "data", "-p sim -a 1 --yes write 480@1=1000"),
        (8, "forbidden", "-p sim -a 1 write 480@1=6"),
        (9, "partial", "-p sim -a 1,9 read 372"),
    ] {
        let document = antrieb(line).json().exits(code);
        assert_eq!(document.error()["class"], class, "{line}");
        assert_eq!(antrieb(line).run().exit, code, "the table ends like the JSON document: {line}");
    }
    antrieb("-p sim -a 1 read 372").json().exits(0);
    let garbled = "[[drive]]\nmodel = \"act\"\n[[disturb]]\nevery = 1\nkind = \"garbled\"\n";
    assert_eq!(antrieb("-a 1 read 372").on(garbled).json().exits(5).error()["class"], "garbled");
}

#[test]
fn a_port_that_is_no_port_says_which_there_are() {
    let document = antrieb("-p /dev/antrieb-has-no-such-port scan").json().exits(3);
    assert_eq!(document.error()["code"], "port.not_found");
    assert!(document.error()["hint"].as_str().unwrap().contains("--port sim"));
    // A file is no serial port.
    let document = antrieb("-p {dir}/file scan").file("file", "").json().exits(3);
    assert_eq!(document.error()["class"], "port");
}

#[test]
fn usage_errors_are_told_on_stderr_and_in_json_on_stdout() {
    for line in ["frobnicate", "-p sim read --type float 372", "-p sim -a 1 write", "-p sim --baud 5 scan", "decode"] {
        let run = antrieb(line).exits(2);
        assert_eq!(run.out, "", "{line}");
        assert!(!run.err.is_empty(), "{line}");
        let document = antrieb(line).json().exits(2);
        assert_eq!(document.error()["class"], "usage", "{line}");
    }
    let run = antrieb("frobnicate --format json").exits(2);
    assert!(run.out.starts_with('{'), "{}", run.out);
    let run = antrieb("frobnicate --format=json").exits(2);
    assert!(run.out.starts_with('{'), "{}", run.out);
}

#[test]
fn help_and_version_are_no_errors() {
    for line in ["--help", "-h", "--version", "read --help", "dataset copy --help"] {
        let run = antrieb(line).exits(0);
        assert!(!run.out.is_empty() && run.err.is_empty(), "{line}");
    }
    let help = antrieb("--help").exits(0).out;
    for code in ["0  done", "4  silence", "6  refused by the drive", "130  interrupted"] {
        assert!(help.contains(code), "{code}: {help}");
    }
    let short = antrieb("-h").exits(0).out;
    assert!(short.contains("antrieb --help"), "{short}");
}

#[test]
fn every_failure_has_a_code_a_message_and_mostly_a_hint() {
    for line in [
        "-p sim -a 9 scan",
        "-p sim -a 9 read 372",
        "-p sim -a 1 read 1600",
        "-p sim -a 1 write 480@1=6",
        "-p sim -a 1 write 411=1",
        "-p sim write 480=1",
        "-p /dev/antrieb-has-no-such-port scan",
        "-p sim -a 0 read 372",
        "-p sim -a 1 read nonsense",
        "params nonsense",
    ] {
        let document = antrieb(line).json();
        assert!(document.error()["code"].as_str().unwrap().contains('.'), "{line}");
        assert!(document.error()["hint"].is_string(), "{line}: {}", document.error());
        let table = antrieb(line).run();
        assert!(table.err.contains("error: ") && table.err.contains("hint: "), "{line}: {}", table.err);
    }
}
