//! `scan` of a line whose setting nobody knows and on which somebody speaks: another master is left alone before the first byte, noise
//! is no reason to leave anybody out.

use super::scanning::{Played, drives, play};
use crate::run::antrieb;
use antrieb::drive::{Manner, ScanPlan, Talker, Unknown};
use antrieb::tick::Span;

const EVERYTHING: Unknown = Unknown { baud: true, parity: true, protocol: true };

fn all() -> ScanPlan {
    ScanPlan { unknown: EVERYTHING, ..ScanPlan::new(1..=247) }
}

/// Another master at this setting, which asks so often and is answered 30 ms later.
fn master(setting: &str, every: u64) -> String {
    let by = every - 40;
    format!(
        "[[disturb]]\nkind = \"babble\"\npattern = \"master\"\nreply_delay = \"30ms\"\nby = \"{by}ms\"\nat = \"70ms\"\n{setting}\n"
    )
}

fn noise(bytes: &str, by: &str) -> String {
    format!("[[disturb]]\nkind = \"babble\"\npattern = \"{bytes}\"\nby = \"{by}\"\nat = \"333ms\"\n")
}

/// Nobody answers by himself on a line of which all is garbled: a drive far away.
fn far() -> String {
    drives(&[(200, "baud = 57600\nparity = \"odd\"")])
}

fn left_alone(name: &str, played: &Played) -> Talker {
    let yielded = played.result.yielded.unwrap_or_else(|| panic!("{name}: it was searched"));
    assert!(yielded.unasked, "{name}");
    assert_eq!(played.sent, 0, "{name}: nothing goes out");
    yielded.to
}

#[test]
fn a_line_on_which_another_master_polls_is_left_alone_before_the_first_byte() {
    for baud in [2_400, 4_800, 9_600, 19_200, 57_600, 115_200] {
        for every in [100, 200, 350, 1_000] {
            for parity in ["even", "odd", "none"] {
                let setting = format!("baud = {baud}\nparity = \"{parity}\"");
                let name = format!("{setting}, every {every} ms");
                let played = play(&(far() + &master(&setting, every)), &all());
                left_alone(&name, &played);
                assert!(played.took < Span::from_secs(22), "{name}: {}", played.took);
            }
        }
    }
    // Who understands him says who he is; at whatever setting he asks.
    let played = play(&(far() + &master("baud = 9600", 1_000)), &all());
    assert_eq!(left_alone("once a second", &played), Talker::Master);
}

#[test]
fn another_master_in_another_protocol_or_whose_drive_is_dead_is_left_alone() {
    for protocol in ["ascii", "vabus"] {
        for every in [100, 200, 350, 1_000] {
            let drive = format!("[[drive]]\nmodel = \"act\"\naddress = 20\nprotocol = \"{protocol}\"\nbaud = 4800\n");
            let played = play(&(drive + &master("", every)), &all());
            left_alone(&format!("{protocol}, every {every} ms"), &played);
        }
    }
    // Nobody answers him.
    let asks = "1E 03 01 74 00 01 C6 5F";
    for by in ["100ms", "200ms", "350ms"] {
        left_alone(by, &play(&(far() + &noise(asks, by)), &all()));
    }
}

#[test]
fn where_it_cannot_be_told_from_a_master_silence_is_preferred_and_force_goes_on() {
    let babble = noise("11 A2 53 E4 95 06", "90ms");
    let run = |more: &str| {
        antrieb(&format!("--baud auto --parity auto --protocol auto {more} -v scan --within 40s"))
            .on(&(drives(&[(1, "")]) + &babble))
    };
    let left = run("").exits(8);
    assert_eq!(left.sent(), [""; 0]);
    assert!(left.err.contains("it can be another master, so nothing was sent"), "{}", left.err);
    assert!(left.err.contains("--force searches beside it"), "{}", left.err);
    assert!(
        left.err.contains("note: listening first, for 1.25 s\n")
            && left.err.contains("\nnote: somebody speaks on the line;"),
        "{}",
        left.err
    );
    run("--lang de").exits(8);
    let forced = run("--force").run();
    assert!(forced.out.contains("19200 8E1"), "{} {}", forced.out, forced.err);
    assert!(forced.err.contains("somebody spoke ") && !forced.err.contains("only garbage came"), "{}", forced.err);
}

/// A master that asks too seldom for the first listening is noticed on the way.
#[test]
fn a_master_that_asks_every_three_seconds_is_noticed_on_the_way() {
    let played = play(&(drives(&[(200, "")]) + &master("baud = 19200", 3_000)), &all());
    assert_eq!(played.result.yielded.map(|yielded| yielded.to), Some(Talker::Master));
}

#[test]
fn a_few_stray_bytes_do_not_cost_the_likeliest_settings_their_turn() {
    let bursts =
        [("11 A2 53 E4 95 06", "1s"), ("11 A2", "1300ms"), ("11 A2 53 E4 95", "1001ms"), ("11 A2 53 E4 95 06", "3s")];
    for (bytes, by) in bursts {
        for at in ["", "baud = 9600", "parity = \"none\"\nprotocol = \"ascii\"", "baud = 57600\nparity = \"odd\""] {
            let plan = ScanPlan { within: Some(Span::from_secs(60)), ..all() };
            let played = play(&(drives(&[(5, at)]) + &noise(bytes, by)), &plan);
            assert_eq!(played.addresses(), [5], "{bytes} every {by}, {at}");
            let found = played.found[0].0;
            assert!(found < Span::from_secs(50), "{bytes} every {by}, {at}: {found}");
        }
    }
}

/// What is said again whenever it is asked is an answer, whatever noise there is besides.
#[test]
fn garbage_that_is_an_answer_still_goes_first() {
    let odd = "baud = 4800\nparity = \"none\"";
    let bench = drives(&[(1, odd), (1, odd), (200, odd)]);
    for noise in [String::new(), noise("11 A2 53", "2700ms")] {
        let plan = ScanPlan { within: Some(Span::from_secs(90)), manner: Manner::Usual, ..all() };
        let played = play(&(bench.clone() + &noise), &plan);
        assert_eq!(played.addresses(), [200], "{noise}");
        assert!(played.found[0].0 < Span::from_secs(50), "{noise}: {}", played.found[0].0);
        let told = played.result.warnings.iter().find(|warning| warning.code == "scan.same_address").unwrap();
        assert!(told.message.get(antrieb::profile::Lang::En).starts_with("4800 8N2 rtu: address 1: "), "{told:?}");
    }
}
