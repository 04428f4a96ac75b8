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

/// Two drives alike; each counts the answers of the other as messages on the line, and so their counts differ.
#[test]
fn two_drives_that_are_alike_are_told_by_what_they_count() {
    for (first, second) in DELAYS {
        let alike = |delay| format!("[[drive]]\nmodel = \"act\"\naddress = 1\nreply_delay = \"{delay}ms\"\n");
        let bench = alike(first) + &alike(second);
        for drive in ["auto", "act"] {
            let run = antrieb(&format!("-a 1 --drive {drive} identify")).on(&bench).json();
            let error = run.error().to_string();
            // Of a named drive some values may be told to be doubtful before the second drive is heard.
            let named = drive == "act" && run.exit == 9 && error.contains("two drives");
            assert!(named || error.contains("garbled.two_answers"), "{first}/{second}, {drive}: {error}");
        }
    }
}

/// On a line in order that costs one question, which touches nothing in the drive.
#[test]
fn a_drive_that_somebody_named_is_greeted_once_before_its_first_value() {
    for (model, settings, param, asked) in [
        ("act", "--drive act", "480", 2),
        ("act", "--drive act --word-order high", "480", 2),
        ("act", "--drive act --protocol ascii", "480", 2),
        ("acu", "--drive acu", "480", 2),
        ("lxm05", "--drive lxm05", "RAMPacc", 3),
        ("lxm05", "--drive lxm05 --word-order high", "RAMPacc", 2),
        // Over VABus every answer names its parameter.
        ("act", "--drive act --protocol vabus", "480", 1),
    ] {
        let protocol = settings.split("--protocol ").nth(1).unwrap_or("rtu");
        let bench = format!("[[drive]]\nmodel = \"{model}\"\naddress = 1\nprotocol = \"{protocol}\"\n");
        for read in [param.to_owned(), format!("{param} {param}")] {
            let run = antrieb(&format!("-v -a 1 {settings} read {read}")).on(&bench).exits(0);
            let more = read.matches(' ').count();
            let greetings = run.err.lines().filter(|line| line.contains(" ms > ") && line.contains("diagnostics"));
            assert_eq!(greetings.count(), usize::from(protocol != "vabus"), "{settings}: {}", run.err);
            let questions = run.sent().iter().filter(|sent| *sent != "04").count();
            assert_eq!(questions, asked + more, "{settings}: {}", run.err);
        }
    }
}

/// A device that is silent to counters gives its values all the same.
#[test]
fn whoever_answers_no_greeting_is_asked_for_the_value() {
    let bench = "[[drive]]\nmodel = \"act\"\naddress = 1\n[[disturb]]\nonce = 1\nkind = \"lost\"\n";
    let run = antrieb("-v -a 1 --drive act read 372").on(bench).exits(0);
    assert!(run.sent()[0].starts_with("01 08"), "{}", run.err);
}

#[test]
fn a_twin_on_the_bench_is_named_however_late_it_answers() {
    // What comes when the last question has been answered nobody hears.
    for by in [3, 5, 15, 40] {
        let bench = format!(
            "[[drive]]\nmodel = \"act\"\naddress = 1\n[[disturb]]\nevery = 1\nkind = \"twin\"\nby = \"{by}ms\"\n"
        );
        for verb in ["read 372@1 480", "identify", "--drive act identify", "--drive act read 372@1"] {
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
