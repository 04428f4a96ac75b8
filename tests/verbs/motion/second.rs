//! A second drive with the same address that begins to answer in a run, late: what is told of one of them is told of none.

use crate::run::antrieb;

/// It runs by its contacts, or stands and obeys nobody.
const SECOND: [&str; 2] = [
    "set = { \"412\" = 0, \"434\" = 1, \"228\" = 20, \"418\" = 0 }\nstart_right = true\n",
    "set = { \"412\" = 0, \"434\" = 2, \"418\" = 0 }\n",
];

#[test]
fn a_second_drive_that_answers_long_behind_the_first_leaves_nothing_proven() {
    let first = "[[drive]]\nmodel = \"acu\"\nbaud = 115200\nreply_delay = \"1ms\"\nset = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }\n";
    for by in [350, 480, 700] {
        for (second, way) in SECOND.iter().zip(["ramp", "coast"]) {
            let bench = format!(
                "{first}[[drive]]\nmodel = \"acu\"\nbaud = 115200\nreply_delay = \"{by}ms\"\n{second}\
                 [[drive.event]]\nat = \"0s\"\nsilent = \"1s\"\n"
            );
            let line = format!("-b 115200 -a 1 --yes sollwert 10Hz --enable --hold --duration 2s --on-exit {way}");
            let run = antrieb(&line).on(&bench).json();
            let told = format!("{by} {way} {second}: {:#} {}", run.value, run.err);
            assert!(run.exit != 0 && run.err.contains("error: THE SHAFT MAY STILL TURN"), "{told}");
            for place in ["/running", "/standing", "/stop/standing"] {
                assert!(run.value.pointer(&format!("/data{place}")).is_none_or(serde_json::Value::is_null), "{told}");
            }
            assert!(!told.contains("seen without power"), "{told}");
        }
    }
}

/// Both answer at the same moment, so that what comes is garbage and the end of one of them.
#[test]
fn what_was_seen_last_counts_for_nothing_where_two_drives_answer_into_each_other() {
    let drive = "[[drive]]\nmodel = \"acu\"\nset = { \"434\" = 3, \"228\" = 15 }\n";
    let mut unproven = 0;
    for from in 38..60 {
        let twin: String = (from..from + 400)
            .map(|once| format!("[[disturb]]\nonce = {once}\nkind = \"twin\"\nby = \"20ms\"\n"))
            .collect();
        let line = "-a 1 --yes statemachine enable --take-control --hold --duration 1s --on-exit quick-stop";
        let run = antrieb(line).on(&format!("{drive}{twin}")).run();
        if run.out.contains("NOT proven") || run.out.contains("NOT acknowledged") {
            unproven += 1;
            let told = format!("{from}: {} {}", run.out, run.err);
            assert!(run.exit != 0 && run.err.contains("error: THE SHAFT MAY STILL TURN"), "{told}");
            assert!(!told.contains("last seen at"), "{told}");
        }
    }
    assert!(unproven > 5, "{unproven}");
}
