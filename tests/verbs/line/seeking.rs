//! `sniff --search`: the setting of a line on which others speak, found by listening alone.
use crate::run::antrieb;
use serde_json::json;

/// Another master on a line with this setting, who polls five times a second.
fn polled(protocol: &str, baud: u32, parity: &str) -> String {
    format!(
        "[[drive]]\nmodel = \"act\"\naddress = 20\nprotocol = \"{protocol}\"\n\
         [[disturb]]\nkind = \"babble\"\npattern = \"master\"\nreply_delay = \"30ms\"\nby = \"200ms\"\n\
         baud = {baud}\nparity = \"{parity}\"\n"
    )
}

/// What a bench of ACTIVE drives takes: all that is looked for but 38400, which an LXM05 has.
const BAUDS: [u32; 6] = [19_200, 9_600, 115_200, 57_600, 4_800, 2_400];

#[test]
fn a_setting_is_found_by_listening_and_nothing_is_sent() {
    for protocol in ["rtu", "ascii", "vabus"] {
        for baud in BAUDS {
            for parity in ["even", "odd", "none"] {
                // VABus has no other parity; ASCII comes last, so some of it will do.
                if protocol == "vabus" && parity != "even" || protocol == "ascii" && ![9_600, 115_200].contains(&baud) {
                    continue;
                }
                let bench = polled(protocol, baud, parity);
                let run = antrieb("-v sniff --search --count 6").on(&bench).exits(0);
                assert!(run.sent().is_empty(), "{}", run.err);
                let told = format!("--baud {baud} --parity {parity} --protocol {protocol}");
                assert!(run.err.contains(&told), "{told}\n{}", run.err);
                let read = run.out.matches("P.372").count() + run.out.matches("372").count();
                assert!(read >= 2, "{told}\n{}", run.out);
            }
        }
    }
}

#[test]
fn silence_is_told_as_silence_in_a_bounded_time() {
    let silent = "[[drive]]\nmodel = \"act\"\naddress = 1\n";
    let document = antrieb("sniff --search").on(silent).json().exits(4);
    assert_eq!(document.error()["code"], "silence.nothing_heard");
    assert_eq!(*document.data("/search"), json!({ "found": false, "tried": 49, "characters": 0 }));
    assert_eq!(*document.data("/because"), "search");
    // As long as was said, and no longer.
    let timed = antrieb("sniff --search --duration 2s").on(silent).json().exits(4);
    assert_eq!((timed.data("/because"), timed.data("/search/tried")), (&json!("duration"), &json!(2)));
    for lang in ["en", "de"] {
        let told = antrieb(&format!("--lang {lang} sniff --search")).on(silent).exits(4);
        assert!(told.err.contains("--search --duration 10m"), "{}", told.err);
    }
}

#[test]
fn who_speaks_no_telegrams_is_told_of() {
    let noise = "[[drive]]\nmodel = \"act\"\naddress = 1\n\
         [[disturb]]\nkind = \"babble\"\npattern = \"random\"\nby = \"50ms\"\nbaud = 19200\nparity = \"even\"\n";
    let document = antrieb("sniff --search").on(noise).json().exits(5);
    assert_eq!(document.error()["code"], "garbled.nothing_valid");
    assert!(document.data("/search/characters").as_u64() > Some(500), "{}", document.value);
}

#[test]
fn what_is_typed_stays_and_auto_is_looked_for_alone() {
    let bench = polled("rtu", 9_600, "none");
    let tried = |line: &str, exit: u8| {
        let document = antrieb(line).on(&bench).json().exits(exit);
        (document.data("/search/found").as_bool().unwrap(), document.data("/search/tried").as_u64().unwrap())
    };
    assert_eq!(tried("-b 9600 --protocol rtu sniff --search --count 6", 0), (true, 2));
    assert_eq!(tried("--parity none --protocol rtu --baud auto sniff --count 6", 0), (true, 2));
    assert_eq!(tried("-b 4800 --protocol rtu sniff --search", 5), (false, 3));
    let tape = antrieb("-p tape:{dir}/t sniff --search").file("t", "# antrieb trace 1, 19200 8E1, rtu\n").exits(2);
    assert!(tape.err.contains("first line"), "{}", tape.err);
}

#[test]
fn who_polls_seldom_is_heard_for_longer() {
    let seldom = polled("rtu", 19_200, "even").replace("by = \"200ms\"", "by = \"1100ms\"").replace("30ms", "1100ms");
    let run = antrieb("sniff --search --count 3").on(&seldom).exits(0);
    assert!(run.err.contains("--baud 19200 --parity even --protocol rtu"), "{}", run.err);
}
