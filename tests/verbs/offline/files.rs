//! Files that a user names, and output that cannot be written: refused in words, at once, with the right exit code.

use crate::run::antrieb;

/// Every way to name a file, with what reads it.
const NAMED: [&str; 8] = [
    "-p sim --catalogue FILE read 411",
    "-p sim --config FILE read 411",
    "-p sim:FILE read 411",
    "-p tape:FILE read 411",
    "-p sim scan --resume FILE",
    "-p sim -a 1 sollwert --profile FILE --yes",
    "simulate FILE",
    "decode trace FILE",
];

#[cfg(target_os = "linux")]
fn pipe(path: &std::path::Path) {
    rustix::fs::mknodat(rustix::fs::CWD, path, rustix::fs::FileType::Fifo, 0o600.into(), 0).unwrap();
}

#[cfg(target_os = "linux")]
#[test]
fn only_regular_files_are_read_wherever_a_file_is_named() {
    for line in NAMED {
        for (name, kind) in [("{dir}/pipe", "a pipe"), ("/dev/zero", "a device"), ("{dir}", "a directory")] {
            let run = antrieb(&line.replace("FILE", name));
            pipe(&run.directory().join("pipe"));
            let refused = run.exits(7);
            assert!(refused.err.contains(&format!("expected a regular file, this is {kind}")), "{}", refused.err);
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_project_file_or_a_catalogue_that_is_a_pipe_is_refused_too() {
    let project = antrieb("-p sim read 411");
    pipe(&project.directory().join("antrieb.toml"));
    assert!(project.exits(7).err.contains("this is a pipe"));
    let catalogue = antrieb("-p sim read 411").user_file("catalogues/readme.txt", "");
    pipe(&catalogue.directory().join("home/catalogues/strange.toml"));
    assert!(catalogue.exits(7).err.contains("this is a pipe"));
}

#[test]
fn a_file_without_end_is_refused_after_its_limit() {
    for line in NAMED {
        let run = antrieb(&line.replace("FILE", "{dir}/long"));
        // A hole: a terabyte that costs nothing.
        std::fs::File::create(run.directory().join("long")).unwrap().set_len(1 << 40).unwrap();
        let refused = run.exits(7);
        assert!(refused.err.contains("MiB, the file is longer"), "{}", refused.err);
    }
}

#[test]
fn a_recording_replaces_nothing_unasked() {
    let line = "-p sim -a 1 read 411 --trace {dir}/run.trace";
    let refused = antrieb(line).file("run.trace", "precious").json().exits(7);
    assert_eq!(refused.error()["code"], "data.trace");
    assert!(refused.error()["hint"].as_str().unwrap().contains("--force"));
    let kept = antrieb(line).file("run.trace", "precious").exits(7);
    assert_eq!(std::fs::read_to_string(kept.directory().join("run.trace")).unwrap(), "precious");
    let replaced = antrieb(&format!("{line} --force")).file("run.trace", "precious").exits(0);
    let text = std::fs::read_to_string(replaced.directory().join("run.trace")).unwrap();
    assert!(text.starts_with("# antrieb trace 1, 19200 8E1, rtu\n"), "{text}");
}

#[cfg(unix)]
#[test]
fn a_recording_never_goes_through_a_link() {
    for force in ["", "--force"] {
        let run = antrieb(&format!("-p sim -a 1 read 411 --trace {{dir}}/link {force}")).file("target", "precious");
        std::os::unix::fs::symlink(run.directory().join("target"), run.directory().join("link")).unwrap();
        let refused = run.exits(7);
        assert!(refused.err.contains("symbolic link"), "{}", refused.err);
        assert_eq!(std::fs::read_to_string(refused.directory().join("target")).unwrap(), "precious");
    }
}

#[test]
fn a_bench_file_that_makes_no_sense_is_refused_with_its_place() {
    let document = antrieb("scan").on("[[drive]]\nmodel = \"act\"\naddress = 248\n").json().exits(7);
    assert!(document.error()["message"].as_str().unwrap().contains("bench.toml:3:11: address = 248"));
    antrieb("-p sim:{dir}/none.toml scan").json().exits(7);
}
