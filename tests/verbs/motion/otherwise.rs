//! What a drive makes of a setpoint by its own settings is what was shown, when somebody agrees and in the run.

use crate::run::antrieb;
use serde_json::json;

const SUM: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"418\" = 0 }\n";
const RUN: &str = "-v -a 1 --yes sollwert 10Hz --enable --hold --duration 8s";

/// Whenever the internal setpoint comes, before the question, behind it or in the run, it is shown or ends the run.
#[test]
fn a_source_that_changes_is_never_run_at_unseen() {
    let telegrams = antrieb(RUN).on(SUM).exits(0).sent().len();
    assert!(telegrams > 40, "{telegrams}");
    let mut seen = [0; 2];
    // It is looked at every second, and told by the way that the ramp goes.
    for after in (1..telegrams / 2).step_by(11) {
        for internal in [40, -30] {
            let bench = format!("{SUM}[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"228\" = {internal} }}\n");
            let run = antrieb(RUN).on(&bench).json();
            let told = run.value.pointer("/data/setpoint/effective").cloned();
            if run.exit == 0 {
                seen[0] += 1;
                assert_eq!(told, Some(json!(f64::from(10 + internal))), "{after} {internal}: {}", run.value);
            } else {
                seen[1] += 1;
                assert_eq!(
                    (run.exit, &run.error()["code"]),
                    (8, &json!("forbidden.otherwise")),
                    "{after} {internal}: {}",
                    run.value
                );
                assert!(
                    run.value.pointer("/data/stop").is_none_or(|stop| stop["acknowledged"] == true),
                    "{}",
                    run.value
                );
            }
        }
    }
    assert!(seen[0] > 3 && seen[1] > 10, "{seen:?}");
}

/// Nor is a limit, whenever it is lowered: before the question, behind it, on the way up, where the ramp then stands still, or at the goal.
#[test]
fn a_limit_that_changes_is_never_run_at_unseen() {
    let telegrams = antrieb(RUN).on(SUM).exits(0).sent().len();
    let (mut before, mut later) = (0, 0);
    for after in (1..40).chain((40..telegrams / 2).step_by(9)) {
        let bench = format!("{SUM}[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"419\" = 5 }}\n");
        let run = antrieb(RUN).on(&bench).json();
        match run.exit {
            7 => before += 1,
            exit => {
                later += 1;
                assert_eq!((exit, &run.error()["code"]), (8, &json!("forbidden.otherwise")), "{after}: {}", run.value);
                assert!(run.err.contains("P.419"), "{after}: {}", run.err);
            }
        }
    }
    assert!(before > 2 && later > 10, "{before} {later}");
}

/// What the run itself has set stands in the data set that was in force then.
#[test]
fn another_data_set_in_the_run_ends_it_also_where_the_run_chose_its_source() {
    let sets = "[[drive]]\nmodel = \"acu\"\nfour = [434, 228]\n\
                set = { \"412\" = 1, \"414\" = 1, \"434\" = 3, \"228@1\" = 0, \"228@2\" = -30, \"418\" = 0 }\n";
    let typed = "-v -a 1 --yes sollwert 10Hz --source line --enable --hold --duration 8s";
    let telegrams = antrieb(typed).on(sets).exits(0).sent();
    let held = telegrams.iter().position(|hex| hex.starts_with("01 06 01 9A 00 0F")).unwrap() + 8;
    for after in [held, held + 9, held + 30] {
        let bench = format!("{sets}[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"414\" = 2 }}\n");
        let run = antrieb(typed).on(&bench).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.otherwise", "{after}: {}", run.value);
        assert!(run.err.contains("P.434"), "{after}: {}", run.err);
        assert_eq!(run.data("/stop/acknowledged"), true, "{after}");
    }
}

/// Nor does it count only behind the way along which a setpoint is led, which may be minutes.
#[test]
fn another_data_set_ends_a_run_whose_setpoint_is_led_at_once() {
    let sets = "[[drive]]\nmodel = \"acu\"\nfour = [434, 228]\n\
                set = { \"412\" = 1, \"414\" = 1, \"434@1\" = 2, \"434@2\" = 3, \"228\" = -30, \"418\" = 0 }\n\
                [[drive.event]]\nat = \"3s\"\nset = { \"414\" = 2 }\n";
    let profile = "0s, 5Hz\n5s, 9Hz\n10s, 5Hz\n20s, 10Hz\n";
    for led in ["--ramp 5Hz:10Hz:20s", "--ramp 5Hz:10Hz:20s --source line", "--profile {dir}/way.csv"] {
        let typed = format!("-v -a 1 --yes sollwert {led} --enable --hold --duration 1s");
        let run = antrieb(&typed).on(sets).file("way.csv", profile).json().exits(8);
        assert_eq!(run.error()["code"], "forbidden.otherwise", "{led}: {}", run.value);
        assert_eq!(run.data("/stop/acknowledged"), true, "{led}");
        let stop = run.err.lines().find(|line| line.contains("> 01 06 01 9A 00 07")).unwrap();
        let at: f64 = stop.split_whitespace().next().unwrap().parse().unwrap();
        assert!((3_000.0..5_500.0).contains(&at), "{led}: {stop}");
        // Nor is it agreed to where it comes before the first look, and the ramp of the drive is through by then.
        let fast = sets.replace(
            "[[drive.event]]",
            "ramps = { up_right = 500, down_right = 500, up_left = 500, down_left = 500 }\n[[drive.event]]",
        );
        let sent = antrieb(&typed).on(fast.split("[[drive.event]]").next().unwrap()).file("way.csv", profile);
        let enabled = sent.exits(0).sent().iter().position(|hex| hex.starts_with("01 06 01 9A 00 0F")).unwrap() + 1;
        for after in enabled..enabled + 6 {
            let early = fast.replace("at = \"3s\"", &format!("after_telegrams = {after}"));
            let run = antrieb(&typed).on(&early).file("way.csv", profile).json().exits(8);
            assert_eq!(run.error()["code"], "forbidden.otherwise", "{led} {after}: {}", run.value);
        }
        // As long as it goes along its way, nothing ends it.
        let calm = sets.split("[[drive.event]]").next().unwrap();
        antrieb(&typed).on(calm).file("way.csv", profile).exits(0);
    }
}

/// A setpoint in percent is added to what the drive runs at by its own settings: these are held to as well.
#[test]
fn a_run_in_percent_ends_where_the_drive_runs_at_another_setpoint_of_its_own() {
    let sets = "[[drive]]\nmodel = \"acu\"\nfour = [434, 476]\n\
                set = { \"412\" = 1, \"414\" = 1, \"434@1\" = 2, \"434@2\" = 3, \"434@3\" = 2, \"476@3\" = 2, \"228\" = -30, \"418\" = 0 }\n";
    let adds = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 5, \"418\" = 0 }\n";
    let way = "0s, 10%\n6s, 20%\n";
    for typed in ["10%", "--ramp 10%:20%:6s", "--profile {dir}/way.csv"] {
        let typed = format!("-v -a 1 --yes sollwert {typed} --enable --hold --duration 7s");
        for (bench, changed, told) in [
            (sets, "\"414\" = 2", "P.434"),
            (sets, "\"414\" = 3", "P.476"),
            (adds, "\"228\" = -30", "P.228"),
            (adds, "\"434\" = 1", "P.434"),
            (adds, "\"419\" = 5", "P.419"),
        ] {
            let calm = antrieb(&typed).on(bench).file("way.csv", way).exits(0).sent();
            let enabled = calm.iter().position(|hex| hex.starts_with("01 06 01 9A 00 0F")).unwrap() + 1;
            for after in [enabled - 1, enabled, enabled + 4, enabled + 40] {
                let event = format!("{bench}[[drive.event]]\nafter_telegrams = {after}\nset = {{ {changed} }}\n");
                let run = antrieb(&typed).on(&event).file("way.csv", way).json().exits(8);
                assert_eq!(run.error()["code"], "forbidden.otherwise", "{typed} {changed} {after}: {}", run.value);
                assert!(run.err.contains(told), "{typed} {changed} {after}: {}", run.err);
                assert_eq!(run.data("/stop/acknowledged"), true, "{typed} {changed} {after}");
            }
        }
    }
}

/// A controller that works in percent may lead the internal setpoint: that is no change of a setting.
#[test]
fn what_a_controller_makes_of_percents_ends_no_run() {
    let bench = |configuration: u32| {
        format!(
            "[[drive]]\nmodel = \"acu\"\nset = {{ \"412\" = 1, \"434\" = 1, \"228\" = 5, \"418\" = 0, \"30\" = {configuration} }}\n\
             [[drive.event]]\nat = \"3s\"\nset = {{ \"228\" = 20 }}\n"
        )
    };
    let typed = "-a 1 --yes sollwert 10% --enable --hold --duration 5s";
    antrieb(typed).on(&bench(111)).json().exits(0);
    antrieb(typed).on(&bench(110)).json().exits(8);
}

/// Nor is it agreed to where somebody waits until the setpoint is reached, whenever it comes.
#[test]
fn another_data_set_ends_a_run_that_waits_for_its_setpoint_at_once() {
    let sets = "[[drive]]\nmodel = \"acu\"\nfour = [434]\n\
                set = { \"412\" = 1, \"414\" = 1, \"434@1\" = 2, \"434@2\" = 3, \"228\" = -30, \"418\" = 0 }\n";
    for typed in ["--until reached", "--until reached --hold --duration 1s", ""] {
        let typed = format!("-v -a 1 --yes sollwert 10Hz --enable {typed}");
        let calm = antrieb(&typed).on(sets).exits(0).sent();
        let enabled = calm.iter().position(|hex| hex.starts_with("01 06 01 9A 00 0F")).unwrap() + 1;
        let given = calm[enabled..].iter().position(|hex| hex.starts_with("01 65 01 E4 00 00 03 E8")).unwrap();
        let given = enabled + given + 1;
        for after in enabled..=given {
            let event = format!("{sets}[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"414\" = 2 }}\n");
            let run = antrieb(&typed).on(&event).json().exits(8);
            assert_eq!(run.error()["code"], "forbidden.otherwise", "{typed} {after}: {}", run.value);
            assert_eq!(run.data("/stop/acknowledged"), true, "{typed} {after}");
            let at = |what: &str| {
                let line =
                    run.err.lines().find(|line| line.contains(what)).unwrap_or_else(|| panic!("{what}: {}", run.err));
                line.split_whitespace().next().unwrap().parse::<f64>().unwrap()
            };
            assert!(at("> 01 06 01 9A 00 07") - at("> 01 06 01 9A 00 0F") < 800.0, "{typed} {after}: {}", run.err);
        }
    }
}

/// What changes between the last look and the end is no success either.
#[test]
fn another_data_set_in_the_last_second_is_told() {
    let sets = "[[drive]]\nmodel = \"acu\"\nfour = [434]\n\
                set = { \"412\" = 1, \"414\" = 1, \"434@1\" = 2, \"434@2\" = 3, \"228\" = -30, \"418\" = 0 }\n";
    for run in
        ["sollwert 10Hz --enable", "sollwert --ramp 5Hz:10Hz:2s --enable", "sollwert 10Hz --source line --enable"]
    {
        let typed = format!("-v -a 1 --yes {run} --hold --duration 2s");
        let calm = antrieb(&typed).on(sets).exits(0).sent();
        let stop = calm.iter().rposition(|hex| hex.starts_with("01 06 01 9A 00 07")).unwrap() + 1;
        for after in stop - 12..stop {
            let event = format!("{sets}[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"414\" = 2 }}\n");
            let run = antrieb(&typed).on(&event).json().exits(8);
            assert_eq!(run.error()["code"], "forbidden.otherwise", "{typed} {after}: {}", run.value);
            assert_eq!(run.data("/stop/acknowledged"), true, "{typed} {after}");
        }
    }
}

/// Somebody else starts it: it is shown, or nothing is done.
#[test]
fn a_drive_that_somebody_else_starts_while_it_asks_is_left_alone() {
    let bench = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 2, \"484\" = 20, \"418\" = 0 }\n";
    let typed = "-v -a 1 --yes sollwert 10Hz --enable --hold --duration 1s";
    let sent = antrieb(typed).on(bench).exits(0).sent();
    let first = sent.iter().position(|hex| hex.starts_with("01 65") || hex.starts_with("01 06")).unwrap();
    let mut refused = 0;
    for after in 1..first {
        let event = format!("{bench}[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"410\" = 15 }}\n");
        let run = antrieb(typed).on(&event).json();
        let shown = run.err.contains("now in Operation enabled");
        let left_alone = run.exit == 8 && run.error()["code"] == "forbidden.otherwise";
        refused += i32::from(left_alone);
        assert!(shown || left_alone, "{after}: {} {}", run.err, run.value);
        assert!(!left_alone || !run.err.contains("> 01 65") && !run.err.contains("> 01 06"), "{after}: {}", run.err);
    }
    assert!(refused > 0);
}

#[test]
fn what_starts_the_shaft_by_itself_is_looked_at_again_behind_the_question() {
    for verb in ["statemachine enable", "statemachine goto operation-enabled", "statemachine contacts S1IND S2IND"] {
        let bench = if verb.contains("contacts") { SUM.replace("\"412\" = 1", "\"412\" = 2") } else { SUM.to_owned() };
        let line = format!("-v -a 1 --yes {verb} --hold --duration 1s");
        let sent = antrieb(&line).on(&bench).exits(0).sent();
        // What comes behind the last look is not seen.
        let looked = sent.iter().take_while(|hex| !hex.starts_with("01 06")).collect::<Vec<_>>();
        let looked = looked.iter().rposition(|hex| hex.starts_with("01 64 00 E4")).unwrap();
        let mut refused = 0;
        for after in 1..=looked {
            let event = format!("{bench}[[drive.event]]\nafter_telegrams = {after}\nset = {{ \"228\" = 40 }}\n");
            let run = antrieb(&line).on(&event).json();
            let told = run.err.contains("40.00 Hz by itself");
            refused += i32::from(run.exit == 8 && run.error()["code"] == "forbidden.otherwise");
            assert!(told || run.exit == 8, "{verb} {after}: {}", run.err);
        }
        assert!(refused > 0, "{verb}");
    }
}

/// A zero would turn the shaft by itself until its setpoint comes.
#[test]
fn where_zero_turns_the_shaft_its_setpoint_goes_out_before_the_enable() {
    for (own, setpoint, first) in [
        ("\"434\" = 2, \"418\" = 10", "-15Hz", "FF FF FA 24"),
        ("\"434\" = 3, \"228\" = 40, \"418\" = 0", "-35Hz", "FF FF F2 54"),
    ] {
        let bench = format!("[[drive]]\nmodel = \"acu\"\nset = {{ \"412\" = 1, {own} }}\n");
        let line = format!("-v -a 1 --yes sollwert --enable --hold --duration 1s -- {setpoint}");
        let run = antrieb(&line).on(&bench).run();
        assert_eq!(run.exit, 0, "{}", run.err);
        let sent = run.sent();
        let writes: Vec<_> =
            sent.iter().filter(|hex| hex.starts_with("01 65 01 E4") || hex.starts_with("01 06 01 9A 00 0F")).collect();
        let enable = writes.iter().position(|hex| hex.starts_with("01 06")).unwrap();
        assert!(enable > 0 && writes[..enable].iter().all(|hex| hex.contains(first)), "{writes:#?}");
        // At the end nothing stands in the drive.
        assert!(writes.last().unwrap().contains("00 00 00 00"), "{writes:#?}");
    }
}

/// Limits that are not the same in all data sets are those of the one that is active.
#[test]
fn limits_of_the_active_data_set_count() {
    let sets = "[[drive]]\nmodel = \"acu\"\nfour = [418, 419]\nset = { \"414\" = 2, \"412\" = 1, \"434\" = 2, \"418@1\" = 0, \"418@2\" = 3.5, \"419@2\" = 9 }\n";
    let plain =
        antrieb("-a 1 sollwert 1Hz --enable").on(&sets.replace("\"414\" = 2", "\"414\" = 1")).answered("n").exits(8);
    assert!(!plain.err.contains("does not tell"), "{}", plain.err);
    let lifted = antrieb("-a 1 sollwert 1Hz --enable").on(sets).answered("n").exits(8);
    assert!(lifted.err.contains("3.50 Hz"), "{}", lifted.err);
    let beyond = antrieb("-a 1 --yes sollwert 10Hz --enable").on(sets).json().exits(7);
    assert!(beyond.error()["message"].as_str().unwrap().contains("9.00 Hz"), "{}", beyond.error());
}
