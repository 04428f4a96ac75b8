//! `apply --atomic`: what is begun, what goes back, and what somebody else changes meanwhile.

use super::plant::{ONE, TWO, plant, states};
use crate::run::antrieb;
use antrieb::transport::witness;

/// A drive starts to run, behind every telegram to it: who reads that nothing was written may believe it.
/// Busy is no refusal (V1.1b3 7): it is asked once more, and a write is read back first. Acknowledge has even begun it.
#[test]
fn a_drive_that_is_busy_for_a_moment_does_not_end_a_load() {
    let text = "antrieb = 1\n[drive]\nfamily = \"act\"\n[values]\n\"480@2\" = 8\n372 = 1440\n";
    let load = |protocol: &str, disturb: &str| {
        let bench = format!("[[drive]]\nmodel = \"act\"\naddress = 1\nprotocol = \"{protocol}\"\n{disturb}");
        let line = format!("--protocol {protocol} -a 1 dataset load {{dir}}/f.toml --yes");
        let run = antrieb(&line).on(&bench).file("f.toml", text);
        let ended = run.run();
        let worn = witness::all_left().iter().map(|(bench, _)| bench.totals().eeprom_writes).sum::<u64>();
        (ended, worn)
    };
    for protocol in ["rtu", "ascii"] {
        let (calm, worn) = load(protocol, "");
        assert_eq!((calm.exit, worn), (0, 5), "{}", calm.err);
        for (at, code) in (1..70).zip([6, 6, 5].into_iter().cycle()) {
            let disturb = format!("[[disturb]]\nonce = {at}\nkind = \"exception\"\nbyte = {code}\n");
            let (ended, worn) = load(protocol, &disturb);
            assert_eq!((ended.exit, worn), (0, 5), "{protocol}, exception {code} at reply {at}: {}", ended.err);
        }
    }
}

#[test]
fn all_or_none_looks_at_every_drive_before_it_begins_with_one() {
    let mut seen = std::collections::BTreeSet::new();
    for after in 1..40 {
        let starts = format!(
            "model = \"acu\"\naddress = 2\nstart_right = false\nset = {{ \"412\" = 0, \"480\" = 5 }}\n\
             [[drive.event]]\nafter_telegrams = {after}\nstart_right = true\n"
        );
        let starting = TWO.replacen("model = \"acu\"\naddress = 2\n", &starts, 1);
        let ended = plant("-a a1,a2 apply --yes --atomic", [&starting, TWO, ONE]).json();
        let worn = witness::all_left().iter().map(|(bench, _)| bench.totals().eeprom_writes).sum::<u64>();
        let message = ended.value["error"]["message"].as_str().unwrap_or_default();
        let states = states(&ended);
        match (ended.exit, states.as_str()) {
            (8, "a1 skipped, a2 skipped") => assert_eq!(worn, 0, "{after}"),
            (9, "a1 back, a2 untouched") => {
                assert!(worn > 0 && message.contains("as before again: a1"), "{after}: {message}");
            }
            (0, _) | (9, "a1 back, a2 torn") => {}
            other => panic!("{after}: {other:?} {message}"),
        }
        seen.insert((ended.exit, states));
    }
    assert!(seen.contains(&(8, "a1 skipped, a2 skipped".to_owned())), "{seen:?}");
    assert!(seen.contains(&(9, "a1 back, a2 untouched".to_owned())), "{seen:?}");
}

#[test]
fn a_drive_that_is_done_and_changed_by_somebody_is_not_taken_back_over_it() {
    // a2 refuses 480@1; behind each telegram to a1 that may be, which is done by then, somebody sets 480@2 of it.
    let mut named = 0;
    for after in 10..60 {
        let changed =
            format!("address = 1\n[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"480@2\" = 12.34 }}\n");
        let refuses = format!("address = 2\n[[drive.event]]\nat = \"0s\"\nrefuses = {}\n", 1 << 12 | 480);
        let bench = TWO.replacen("address = 1\n", &changed, 1).replacen("address = 2\n", &refuses, 1);
        let ended = plant("-a a1,a2 apply --yes --atomic", [&bench, TWO, ONE]).json();
        let (bench, _) = witness::all_left().swap_remove(0);
        let now = bench.drive(1).unwrap().eeprom(480, 2);
        if ended.value.to_string().contains("reads as 12.34 Hz") {
            assert_eq!((ended.exit, now), (9, Some(1234)), "{after}: {:#}", ended.value);
            named += usize::from(states(&ended).starts_with("a1 torn"));
        }
    }
    assert!(named > 0);
}
