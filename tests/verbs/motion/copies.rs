//! A drive whose replies come twice is on the line of a group that is stopped: its copies are its own, and whoever answers once is
//! believed as if it were alone.

use super::beside::{drive, of, running};

/// Every reply of a drive comes once more, so much later.
fn twice(address: u8, by: u32) -> String {
    format!("[[disturb]]\nevery = 1\nkind = \"doubled\"\nby = \"{by}ms\"\naddress = {address}\n")
}

const JITTER: &str = "jitter = \"12ms\"";

/// What one drive that is alone at the line may take, in ms: 12 s behind its word, 6 s for a stronger one, and 1.5 s for what is reported.
const ALONE: f64 = 19_500.0;

/// When something came or went last, or went to who is meant, in ms.
fn last(err: &str, goes: &str) -> f64 {
    let lines = err.lines().rev().filter_map(|line| line.split_once(" ms "));
    let lines = lines.filter(|(_, telegram)| telegram.starts_with(goes));
    lines.filter_map(|(at, _)| at.trim().parse().ok()).next().unwrap_or_default()
}

/// Copies come sooner or later, adapters hold bytes back, and a copy meets what goes out: the others are proven as if it were not there, and
/// of its own drive nothing is said that was not seen.
#[test]
fn who_says_things_twice_costs_no_other_one_his_proof() {
    for by in [3, 20, 60, 200] {
        let bench = [drive(1, "5", JITTER), drive(2, "4", JITTER), drive(8, "8", JITTER), twice(8, by)].concat();
        for verb in ["quick-stop", "disable"] {
            for order in ["1,2,8", "8,2,1"] {
                let run = running(&format!("-v -a {order} statemachine {verb}"), &bench).json();
                let told = format!("{by} ms {verb} {order}: {:#} {}", run.value, run.err);
                for (at, address) in order.split(',').enumerate() {
                    let seen = of(&run, at);
                    assert!(address == "8" || seen == (Some(true), None), "{address} {told}");
                    assert!(address != "8" || seen.0 != Some(false), "{told}");
                }
                // Each value of the one that says things twice is asked for again behind a fence, so it may take all the time that it has. The
                // turns of the others are added to that: it is over so long after them. The help promises 20 s for each.
                let others = last(&run.err, "> 01").max(last(&run.err, "> 02"));
                assert!(last(&run.err, "") < others + ALONE, "{others} {told}");
            }
        }
    }
}
