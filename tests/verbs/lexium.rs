//! The LXM05 through the program: the worked sequences of its manual, reading, writing, diagnosis, safety.

use super::run::{Output, antrieb};
use serde_json::json;

/// An LXM05 whose settings differ from everything that the manual's examples write.
const BENCH: &str = "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 500, RAMPdecel = 600, RAMPn_max = 3000, PPn_target = 50, HMn = 60, HMn_out = 6, JOGn_slow = 30, JOGn_fast = 90 }\n";

fn bench(rest: &str) -> String {
    format!("[[drive]]\nmodel = \"lxm05\"\n{rest}\n")
}

/// A line of a worked sequence: `FC16 / name (address)` with its 32-bit value, or `FC 3 / name (address)`.
#[derive(Clone, Copy, Debug)]
enum Line {
    Write(u16, u32),
    Read(u16),
}
use Line::{Read, Write};

/// Disable voltage, shut down, operation enable, state, mode, proof of the mode: the same in every sequence.
fn enabled_in(mode: u32) -> [Line; 6] {
    let [off, ready, on] = [0x00, 0x06, 0x0F].map(|word| Write(6914, word));
    [off, ready, on, Read(6916), Write(6918, mode), Read(6920)]
}

/// What code 16 or code 3 of a line looks like on the wire, without its check.
fn telegram(line: &Line) -> String {
    let hex = |bytes: &[u8]| bytes.iter().map(|byte| format!("{byte:02X}")).collect::<Vec<_>>().join(" ");
    match line {
        Write(address, value) => {
            let [high, low] = address.to_be_bytes();
            hex(&[&[1, 16, high, low, 0, 2, 4][..], &value.to_be_bytes()].concat())
        }
        Read(address) => {
            let [high, low] = address.to_be_bytes();
            hex(&[1, 3, high, low, 0, 2])
        }
    }
}

/// Every line of the sequence must have been sent, in this order.
#[track_caller]
fn assert_sequence(output: &Output, first: &[Line], mode: u32, last: &[Line]) {
    let sent = output.sent();
    let mut rest = sent.iter();
    for line in [first, &enabled_in(mode), last].into_iter().flatten() {
        let wanted = telegram(line);
        let found = rest.any(|telegram| telegram.starts_with(&wanted));
        assert!(found, "{line:?} ({wanted}) was not sent where the manual sends it:\n{}", sent.join("\n"));
    }
}

fn moved(words: &str) -> Output {
    antrieb(&format!("-a 1 -v --yes sollwert {words} --enable --hold --duration 50ms")).on(BENCH).exits(0)
}

#[test]
fn point_to_point_runs_as_5_4_1() {
    let output = moved(
        "48usr --start relative --set RAMPacc=2000 --set RAMPdecel=4000 --set RAMPn_max=6000 --set PPn_target=4000",
    );
    let first = [Write(1556, 0x07D0), Write(1558, 0x0FA0), Write(1554, 0x1770), Write(6942, 0x0FA0)];
    let last = [Write(6940, 0x30), Write(6914, 0x5F), Read(6916), Write(6914, 0x0F)];
    assert_sequence(&output, &first, 1, &last);
}

#[test]
fn velocity_profile_runs_as_5_4_2() {
    let output =
        moved("1000rpm --mode velocity --until reached --set RAMPacc=2000 --set RAMPdecel=10000 --set RAMPn_max=10000");
    let first = [Write(1556, 0x07D0), Write(1558, 0x2710), Write(1554, 0x2710)];
    let last = [Write(6938, 0x03E8), Read(6916), Write(6938, 0), Read(6916)];
    assert_sequence(&output, &first, 3, &last);
}

#[test]
fn homing_runs_as_5_4_3() {
    let output = moved("17 --mode homing --set HMn=100 --set HMn_out=10");
    let first = [Write(10248, 0x64), Write(10250, 0x0A)];
    let last = [Write(6936, 0x11), Write(6914, 0x1F), Read(6916), Write(6914, 0x0F)];
    assert_sequence(&output, &first, 6, &last);
}

#[test]
fn current_control_runs_as_5_5_1() {
    let output = moved("10A");
    let last = [Write(6944, 2), Write(8200, 0x03E8)];
    assert_sequence(&output, &[], 0xFFFF_FFFD, &last);
}

#[test]
fn speed_control_runs_as_5_5_2() {
    let output = moved("1000rpm --mode speed");
    let last = [Write(6946, 2), Write(8456, 0x03E8)];
    assert_sequence(&output, &[], 0xFFFF_FFFC, &last);
}

#[test]
fn electronic_gear_runs_as_5_5_3() {
    let output = moved("2/3 --set IOposInterfac=1");
    let last = [Write(6948, 1), Write(9734, 3), Write(9736, 2)];
    let first = [Write(1284, 1)];
    assert_sequence(&output, &first, 0xFFFF_FFFE, &last);
}

#[test]
fn jogging_runs_as_5_5_4() {
    let output = antrieb(
        "-a 1 -v --yes sollwert --mode jog --profile {dir}/jog.csv --set JOGn_slow=100 --set JOGn_fast=250 --enable \
         --hold --duration 50ms",
    );
    let output = output.file("jog.csv", "0s, positive slow\n500ms, positive fast\n").on(BENCH).exits(0);
    let first = [Write(10504, 0x64), Write(10506, 0xFA)];
    let last = [Write(6930, 1), Write(6930, 5)];
    assert_sequence(&output, &first, 0xFFFF_FFFF, &last);
}
