//! A drive that acknowledges its stop and does not obey: the strongest word goes out soon, and the verb ends within the 20 s that its help
//! promises, alone and beside others.

use super::beside::{drive, of, running};
use crate::run::antrieb;
use antrieb::transport::witness;

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

/// What is left of a run whose drive ignores its control word: its setpoint, which it may still obey.
#[test]
fn who_ignores_his_control_word_in_a_run_gets_the_setpoint_0_in_the_end() {
    for model in ["act", "acu"] {
        for protocol in ["rtu", "ascii", "vabus"] {
            let bench = format!(
                "[[drive]]\nmodel = \"{model}\"\nprotocol = \"{protocol}\"\n\
                 set = {{ \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }}\n\
                 [[drive.event]]\nat = \"2500ms\"\nignores = 410\n"
            );
            let line = "sollwert 10Hz --enable --hold --duration 4s";
            let run = antrieb(&format!("--protocol {protocol} -a 1 --drive {model} --yes {line}")).on(&bench).json();
            let (left, _) = witness::left().unwrap();
            let told = format!("{protocol} {model}: {:#} {}", run.value, run.err);
            assert_eq!((run.exit, left.totals().turning), (8, 0), "{told}");
            assert!(run.data("/notes").to_string().contains("the setpoint went to 0 in its place"), "{told}");
            assert!(run.err.contains("THE SHAFT MAY STILL TURN"), "{told}");
        }
    }
}
