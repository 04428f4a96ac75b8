//! A drive that acknowledges its stop and does not obey: the strongest word goes out soon, and the verb ends within the 20 s that its help
//! promises, alone and beside others.

use super::beside::{drive, of, running};

const IGNORES: &str = "[[drive.event]]\nat = \"0s\"\nignores = 410";

/// When what is told so went out, in ms: `value`, in front of what it means.
fn words(err: &str, place: &str, value: &str) -> Vec<f64> {
    let sent = err.lines().filter_map(|line| line.split_once(" ms > "));
    let is_it = |told: &str| told.contains(place) && told.rsplit("= ").next().is_some_and(|is| is.starts_with(value));
    sent.filter(|(_, told)| is_it(told)).map(|(at, _)| at.trim().parse().unwrap()).collect()
}

#[test]
fn who_ignores_his_stop_gets_the_strongest_soon_and_is_given_up_in_time() {
    for (verb, strongest) in [("quick-stop", 4_000.0), ("disable", 8_500.0), ("disable-voltage", 100.0)] {
        for (addresses, exit, protocol) in [("1", 8, "rtu"), ("1,2", 9, "rtu"), ("2,1", 9, "rtu"), ("1", 8, "vabus")] {
            let bench = [drive(1, "10", IGNORES), drive(2, "10", "")].concat();
            let bench = bench.replace("baud =", &format!("protocol = \"{protocol}\"\nbaud ="));
            let line = format!("-v --protocol {protocol} -a {addresses} statemachine {verb}");
            let run = running(&line, &bench).json();
            let told = format!("{protocol} {verb} {addresses}: {:#} {}", run.value, run.err);
            assert_eq!(run.exit, exit, "{told}");
            // It began after a second.
            let coasts = words(&run.err, "write P.410@0", "0");
            assert!(coasts[0] < 1_000.0 + strongest, "{told}");
            assert!(words(&run.err, "", "").into_iter().fold(0.0, f64::max) < 14_000.0, "{told}");
            assert!(run.err.contains("THE SHAFT MAY STILL TURN"), "{told}");
            if let Some(at) = addresses.split(',').position(|address| address == "2") {
                assert_eq!(of(&run, at).1, None, "{told}");
            }
        }
    }
}
