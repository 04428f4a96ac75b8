//! Two drives at one address: what they say is refused, and the cause is named.

use crate::run::antrieb;

/// Two drives at address 1 whose parameters differ; the second answers later.
fn twins(protocol: &str, first: u32, second: u32) -> String {
    let drive = |delay, speed, frequency| {
        format!(
            "[[drive]]\nmodel = \"act\"\naddress = 1\nprotocol = \"{protocol}\"\nreply_delay = \"{delay}ms\"\nset = {{ \
             \"372@1\" = {speed}, \"480\" = \"{frequency}\" }}\n"
        )
    };
    drive(first, 1391, "12.00") + &drive(second, 1491, "5.00")
}

/// Delays of the two drives.
const DELAYS: [(u32, u32); 3] = [(30, 45), (4, 14), (10, 40)];

#[test]
fn a_value_that_two_drives_answer_is_refused_and_the_cause_is_named() {
    for protocol in ["rtu", "ascii", "vabus"] {
        for (first, second) in DELAYS {
            let run = antrieb(&format!("--protocol {protocol} -a 1 read 372@1 480"));
            let run = run.on(&twins(protocol, first, second)).json();
            // Over VABus an answer names its parameter, so the first may be told before the second drive is heard.
            assert!(run.exit == 5 || run.exit == 9 && protocol == "vabus", "{protocol} {first}/{second}: {}", run.exit);
            assert!(run.error()["hint"].as_str().unwrap().contains("two drives answer"), "{}", run.error());
            let code = run.error()["code"].as_str().unwrap();
            assert_eq!(code == "garbled.two_answers", run.exit == 5, "{protocol} {first}/{second}: {code}");
        }
    }
}

#[test]
fn whoever_asks_two_drives_at_one_address_who_they_are_is_told() {
    for protocol in ["rtu", "ascii"] {
        for (first, second) in DELAYS {
            let run =
                antrieb(&format!("--protocol {protocol} --lang de -a 1 identify")).on(&twins(protocol, first, second));
            let run = run.run();
            assert!(run.err.contains("zwei Antriebe"), "{protocol} {first}/{second}: {}", run.err);
        }
    }
}

#[test]
fn a_twin_on_the_bench_is_named_however_late_it_answers() {
    // What comes when the last question has been answered nobody hears.
    for by in [3, 5, 15, 40] {
        let bench = format!(
            "[[drive]]\nmodel = \"act\"\naddress = 1\n[[disturb]]\nevery = 1\nkind = \"twin\"\nby = \"{by}ms\"\n"
        );
        for verb in ["read 372@1 480", "identify"] {
            let run = antrieb(&format!("-a 1 {verb}")).on(&bench).json().exits(5);
            assert_eq!(run.error()["code"], "garbled.two_answers", "{by} ms, {verb}: {}", run.error());
        }
    }
}

#[test]
fn two_drives_at_one_address_are_never_started() {
    for (first, second) in [(30, 45), (4, 14), (10, 40), (30, 75)] {
        let bench = twins("rtu", first, second).replace("set = {", "set = { \"412\" = 1, \"434\" = 2, \"418\" = 0,");
        let bench = bench.replacen("\"412\" = 1,", "\"412\" = 1, \"413\" = 17,", 1);
        let run = antrieb("-v -a 1 --yes sollwert 20Hz --enable --hold --duration 500ms").on(&bench).run();
        assert!(!run.sent().iter().any(|sent| sent.starts_with("01 06 01 9A 00 0F")), "{first}/{second}: {}", run.err);
        assert_eq!(run.exit, 5, "{first}/{second}: {}", run.err);
    }
}

#[test]
fn two_servos_at_one_address_are_named_whether_their_family_was_named_or_not() {
    for by in [3, 5, 15, 40, 45, 60] {
        for delay in [10, 30] {
            let bench = format!(
                "[[drive]]\nmodel = \"lxm05\"\naddress = 1\nreply_delay = \"{delay}ms\"\n[[disturb]]\nevery = 1\nkind = \
                 \"twin\"\nby = \"{by}ms\"\n"
            );
            for drive in ["auto", "lxm05"] {
                let run = antrieb(&format!("-a 1 --drive {drive} read _p_act RAMPacc DCOMstatus"));
                let run = run.on(&bench).json();
                let told = format!("{delay} ms, {by} ms, {drive}: {}", run.data("/values"));
                assert!(matches!(run.exit, 5 | 9), "{}: {told}", run.exit);
                let error = run.error().to_string();
                assert!(error.contains("more than one answer") || error.contains("two drives answer"), "{error}");
                // What one drive said before the other was heard is right.
                let rows = run.data("/values").as_array().unwrap().clone();
                for (row, right) in rows.iter().zip([0, 600, 592]) {
                    assert!(row["raw"].is_null() || row["raw"] == right, "{told}");
                }
            }
        }
    }
}
