//! `--trace FILE` and `-p tape:FILE`: what was recorded plays back to the same result.

use crate::run::antrieb;
use serde_json::json;

#[test]
fn a_recorded_run_plays_back_to_the_same_document_and_telegrams() {
    let directory = tempfile::tempdir().unwrap();
    let trace = directory.path().join("run.trace").display().to_string();
    let tape = format!("tape:{trace}");
    for words in [
        "-a 1,2 read 372@all 481 411 12345",
        "-a 1-4 scan",
        "-a 1,2 identify",
        "-a 1,2 diag --link-test 20",
        "-a 1 write 376@4=1.5kW --yes",
        "-a 9 read 411",
    ] {
        let _old = std::fs::remove_file(&trace);
        let recorded = antrieb(&format!("-p sim --trace {trace} --json -v {words}")).run();
        let played = antrieb(&format!("-p {tape} --json -v {words}")).run();
        assert_eq!((played.exit, played.out.replace(&tape, "sim")), (recorded.exit, recorded.out), "{words}");
        assert_eq!(played.err.replace(&tape, "sim"), recorded.err, "{words}");
    }
}

#[test]
fn another_run_than_the_recorded_one_is_refused_with_the_line() {
    let directory = tempfile::tempdir().unwrap();
    let trace = directory.path().join("run.trace").display().to_string();
    antrieb(&format!("-p sim --trace {trace} -a 1 --drive act read 411")).exits(0);
    let refused = antrieb(&format!("-p tape:{trace} -a 1 --drive act read 412")).json().exits(3);
    assert_eq!(refused.error()["code"], "port.recording");
    let message = refused.error()["message"].as_str().unwrap();
    assert!(message.contains("line 11: recorded was 01 03 01 9B 00 01"), "{message}");
}

#[test]
fn what_is_no_recording_is_told_and_an_empty_one_is_a_silent_line() {
    let bad =
        antrieb("-p tape:{dir}/run.trace read 411").file("run.trace", "# antrieb trace 1, 19200 8E1, rtu\nhello\n");
    let refused = bad.json().exits(7);
    assert!(refused.error()["message"].as_str().unwrap().contains("line 2: expected"), "{}", refused.error());
    antrieb("-p tape:{dir}/run.trace read 411").file("run.trace", "").json().exits(4);
    antrieb("-p tape:{dir}/nothing read 411").json().exits(7);
}

#[test]
fn a_recording_can_be_replayed_offline() {
    let run = antrieb("-p sim -a 1 --trace {dir}/line.txt read 372@2 1600").exits(9);
    let trace = std::fs::read_to_string(run.directory().join("line.txt")).unwrap();
    assert!(trace.starts_with("# antrieb trace 1, 19200 8E1, rtu\n"), "{trace}");
    let decoded = antrieb("decode trace {dir}/line.txt").file("line.txt", &trace).json().exits(0);
    let telegrams = decoded.data("/telegrams").as_array().unwrap();
    assert_eq!(
        telegrams.len(),
        18,
        "four questions tell the family, and two answers in the words of another are asked for again: {trace}"
    );
    assert!(telegrams.iter().all(|telegram| telegram["check_ok"] == true));
    assert!(telegrams.iter().any(|telegram| telegram["meaning"] == "address 1: read P.372@2 Rated Speed, 16 bit"));
    let last = telegrams.last().unwrap();
    assert_eq!((&last["direction"], &last["hex"]), (&json!("reply"), &json!("01 03 02 00 0B F9 83")));
    let bad = antrieb("decode trace {dir}/bad.txt").file("bad.txt", "# antrieb trace 1\nhello\n").json().exits(7);
    assert!(bad.error()["message"].as_str().unwrap().contains('2'), "names the line: {}", bad.error());
    antrieb("decode trace {dir}/none.txt").json().exits(7);
}
