//! A drive that acknowledges its stop and does not obey: the strongest word goes out soon, and the verb ends within the 20 s that its help
//! promises, alone and beside others.

use super::beside::{drive, of, running};

const IGNORES: &str = "[[drive.event]]\nat = \"0s\"\nignores = 410";

/// When the words went out, in ms.
fn words(err: &str, word: &str) -> Vec<f64> {
    let sent = err.lines().filter_map(|line| line.split_once(" ms > "));
    sent.filter(|(_, hex)| hex.starts_with(word)).map(|(at, _)| at.trim().parse().unwrap()).collect()
}

#[test]
fn who_ignores_his_stop_gets_the_strongest_soon_and_is_given_up_in_time() {
    for (verb, strongest) in [("quick-stop", 4_000.0), ("disable", 8_500.0), ("disable-voltage", 100.0)] {
        for (addresses, exit) in [("1", 8), ("1,2", 9), ("2,1", 9)] {
            let bench = [drive(1, "10", IGNORES), drive(2, "10", "")].concat();
            let run = running(&format!("-v -a {addresses} statemachine {verb}"), &bench).json();
            let told = format!("{verb} {addresses}: {:#} {}", run.value, run.err);
            assert_eq!(run.exit, exit, "{told}");
            // It began after a second.
            let coasts = words(&run.err, "01 06 01 9A 00 00");
            assert!(coasts[0] < 1_000.0 + strongest, "{told}");
            assert!(words(&run.err, "").into_iter().fold(0.0, f64::max) < 14_000.0, "{told}");
            assert!(run.err.contains("THE SHAFT MAY STILL TURN"), "{told}");
            if let Some(at) = addresses.split(',').position(|address| address == "2") {
                assert_eq!(of(&run, at).1, None, "{told}");
            }
        }
    }
}
