//! One call stops several drives: each hears the stop before any of them is looked at.

use super::rig::RUNNING;
use crate::run::{Run, antrieb};
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

/// Three that run, the one at 3 with `rest` besides.
fn line(rest: &str) -> String {
    let drive = |address: u8, model: &str, rest: &str| {
        format!(
            "[[drive]]\nmodel = \"{model}\"\naddress = {address}\nbaud = 19200\nset = {{ {RUNNING} }}\nreply_delay = \"2ms\"\n{rest}\n"
        )
    };
    [drive(1, "act", ""), drive(2, "acu", ""), drive(3, "acu", rest)].concat()
}

/// How many shafts turn when everything has come to an end.
fn turning() -> u64 {
    let (mut bench, at) = witness::left().unwrap();
    bench.advance(at + Span::from_secs(60));
    bench.totals().turning
}

#[test]
fn every_drive_hears_the_stop_before_one_is_looked_at() {
    for verb in ["quick-stop", "disable", "disable-voltage"] {
        let run = antrieb(&format!("-v -a 1-3 statemachine {verb}")).on(&line("")).run();
        assert_eq!((turning(), run.err.contains("MOTION")), (0, false), "{verb}: {}", run.err);
        // Code 6 writes P.410; what asks for the state comes behind the last of them.
        let sent = run.sent();
        let first = |address: u8| sent.iter().position(|hex| hex.starts_with(&format!("0{address} 06 01 9A"))).unwrap();
        let looks = sent.iter().position(|hex| hex.contains(" 03 01 9B ")).unwrap();
        assert!((1..=3).all(|address| first(address) < looks), "{verb}: {sent:?}");
        // They are watched in turns, so that each is seen to stand as long as it shows that.
        assert_eq!((run.exit, run.err.contains("THE SHAFT")), (0, false), "{verb}: {}", run.err);
        assert!((1..=3).all(|address| run.page().contains(&format!("drive {address} ("))), "{}", run.page());
    }
}

/// Behind a stop of several nobody is unseen for longer than one question to each of the others takes, or two: for the shaft and the state.
#[test]
fn the_last_questions_of_a_stop_go_to_each_as_often() {
    let drives = |model: &str| -> String {
        let set = if model == "acu" { "\"412\" = 1" } else { "" };
        let drive = |address| {
            format!("[[drive]]\nmodel = \"{model}\"\naddress = {address}\nreply_delay = \"10ms\"\nset = {{ {set} }}\n")
        };
        (1..=6).map(drive).collect()
    };
    for (model, verb, often) in
        [("lxm05", "sollwert 0", 1), ("acu", "sollwert 0", 1), ("lxm05", "statemachine disable", 2)]
    {
        let run = antrieb(&format!("-v -a 1-6 --drive {model} {verb}")).on(&drives(model)).exits(0);
        let sent = run.sent();
        let last: Vec<&str> = sent.iter().rev().take(6 * often).map(|hex| &hex[..2]).collect();
        let asked = |address: &str| last.iter().filter(|last| **last == address).count();
        assert_eq!(["01", "02", "03", "04", "05", "06"].map(asked), [often; 6], "{model} {verb}: {sent:#?}");
    }
}

/// One that answers late is asked several times; the others are asked again behind that.
#[test]
fn a_slow_one_keeps_none_of_the_others_unseen() {
    for (model, verb) in [("lxm05", "sollwert 0"), ("lxm05", "statemachine disable"), ("acu", "statemachine disable")] {
        let set = if model == "acu" { "\"410\" = 15, \"412\" = 1, \"418\" = 0, \"434\" = 2, \"484\" = 10" } else { "" };
        let drive = |address| {
            let delay = if address == 3 { 200 } else { 5 };
            format!(
                "[[drive]]\nmodel = \"{model}\"\naddress = {address}\nreply_delay = \"{delay}ms\"\nset = {{ {set} }}\n"
            )
        };
        let run =
            antrieb(&format!("-v -a 1-5 --drive {model} {verb}")).on(&(1..=5).map(drive).collect::<String>()).exits(0);
        let answers = run.err.lines().filter_map(|line| line.trim().split_once(" ms < "));
        let answers: Vec<(f64, &str)> = answers.map(|(at, hex)| (at.parse().unwrap(), &hex[..2])).collect();
        let end = answers.last().unwrap().0;
        for address in ["01", "02", "04", "05"] {
            let last = answers.iter().rfind(|answer| answer.1 == address).unwrap().0;
            assert!(end - last < 300.0, "{model} {verb} {address}: {last} of {end}");
        }
    }
}

#[test]
fn who_does_not_hear_is_named_and_the_others_stand() {
    let bench = line("[[drive.event]]\nat = \"0s\"\nsilent = \"2min\"\n");
    let came = antrieb("-a 1-3 statemachine disable-voltage").on(&bench).json().exits(9);
    assert!([0, 1].iter().all(|at| came.data(&format!("/drives/{at}/motion/running")) == false));
    assert_eq!(came.data("/drives/2/address"), 3);
    assert!(came.data("/drives/2/motion").is_null() && came.data("/drives/2/error/code").is_string());
    let told = came.error()["message"].as_str().unwrap();
    assert!(told.starts_with("address 3: THE SHAFT MAY STILL TURN"), "{told}");
    assert_eq!(came.error()["context"]["addresses"], "3");
    assert_eq!(turning(), 1);
}

#[test]
fn what_asks_and_everybody_are_one_drive_s() {
    for more in ["quick-stop --take-control", "disable --watchdog 2s", "enable", "goto switched-on"] {
        let run = antrieb(&format!("-a 1-3 statemachine {more} --yes")).on(&line("")).exits(2);
        assert!(run.sent().is_empty() && run.err.contains(" -a 1-3 statemachine quick-stop`"), "{}", run.err);
    }
    antrieb("-a 0,1 statemachine quick-stop").on(&line("")).exits(2);
}

/// A plant of three ports: its `antrieb.toml` and benches; on the middle one is `rest` at address 3.
fn plant(typed: &str, rest: &str) -> Run {
    let mut project = String::new();
    for (port, addresses) in [("left", 1..=3), ("middle", 1..=3), ("right", 1..=3)] {
        project += &format!("[ports.{port}]\npath = \"sim:{port}.bench\"\n");
        for address in addresses {
            project += &format!("[drives.{port}-{address}]\nport = \"{port}\"\naddress = {address}\n");
        }
    }
    project += "[groups]\nfirst = [\"left-1\", \"right-1\"]\n";
    let run = antrieb(&format!("--config {{dir}}/site/antrieb.toml {typed}")).file("site/antrieb.toml", &project);
    let run = run.file("site/left.bench", &line("")).file("site/middle.bench", &line(rest));
    run.file("site/right.bench", &line(""))
}

/// How many shafts turn on each bench that was left when everything has come to an end.
fn turning_everywhere() -> Vec<u64> {
    let ended = |(bench, at): &mut (Bench, Tick)| {
        bench.advance(*at + Span::from_secs(60));
        bench.totals().turning
    };
    witness::all_left().iter_mut().map(ended).collect()
}

#[test]
fn a_stop_goes_over_every_port_of_a_plant() {
    for verb in [
        "statemachine quick-stop",
        "statemachine disable",
        "statemachine disable-voltage",
        "sollwert 0",
        "sollwert 0Hz",
    ] {
        let run = plant(&format!("-v -a all {verb}"), "").exits(0);
        assert_eq!(turning_everywhere(), [0, 0, 0], "{verb}");
        for name in ["left-1", "middle-2", "right-3"] {
            assert!(run.out.contains(&format!("{name}: drive")), "{verb} {name}: {}", run.out);
        }
    }
    plant("-a @first statemachine quick-stop", "").exits(0);
    plant("--lang de -a all statemachine quick-stop", "").exits(0);
    let planned = plant("-a all statemachine quick-stop --dry-run", "").json().exits(0);
    assert!(planned.data("/telegrams").as_array().unwrap().len() > 9);
    plant("-a all sollwert 0 --dry-run", "").exits(0);
    // What starts a shaft is one drive's.
    for other in ["sollwert 5Hz", "statemachine enable"] {
        plant(&format!("-a all {other} --yes"), "").exits(2);
    }
}

#[test]
fn who_does_not_stand_on_one_port_is_named_and_the_others_do() {
    let silent = "[[drive.event]]\nat = \"0s\"\nsilent = \"2min\"\n";
    let came = plant("-a all statemachine disable-voltage", silent).json().exits(9);
    let told = came.error()["message"].as_str().unwrap();
    assert!(told.starts_with("middle-3: THE SHAFT MAY STILL TURN"), "{told}");
    assert_eq!(came.error()["context"]["addresses"], "middle-3");
    assert_eq!(turning_everywhere().iter().sum::<u64>(), 1);
    // A port that is not there takes nobody else his stop.
    let project =
        "[drives.a]\nport = \"sim:{dir}/a.bench\"\naddress = 1\n[drives.b]\nport = \"/dev/nowhere\"\naddress = 1\n";
    let gone = antrieb("-a all statemachine quick-stop").file("a.bench", &line(""));
    let project = project.replace("{dir}", &gone.directory().display().to_string());
    let came = gone.file("antrieb.toml", &project).json().exits(9);
    assert_eq!((came.data("/drives/0/called"), came.data("/drives/1/called")), (&"a".into(), &"b".into()));
    assert_eq!(came.data("/drives/1/error/code"), "port.not_found");
    assert!(came.data("/drives/0/error").is_null());
}

#[test]
fn a_dry_run_tells_the_telegrams_to_each() {
    let run = antrieb("-a 1,2 --drive acu statemachine quick-stop --dry-run").json();
    let told = run.data("/telegrams").as_array().unwrap();
    let to = |address: u8| {
        told.iter().filter(|row| row["hex"].as_str().unwrap().starts_with(&format!("0{address} "))).count()
    };
    assert!(to(1) > 1 && to(1) == to(2), "{told:?}");
}

/// What stays as it is, goes out once; the plan says so.
#[test]
fn a_dry_run_tells_a_setpoint_as_often_as_it_is_sent() {
    let act = "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1 }\n";
    let given = |hex: &str| hex.starts_with("01 65 01 E4");
    for setpoint in ["12Hz", "12,5Hz", "-5Hz", "12Hz --enable", "0Hz", "--ramp 1Hz:2Hz:10ms --enable"] {
        let line = format!("-a 1 --drive act --yes sollwert {setpoint}");
        let planned = antrieb(&line).on(act).and("--dry-run").json();
        let told = planned.data("/telegrams").as_array().unwrap().clone();
        let told = told.iter().filter(|row| given(row["hex"].as_str().unwrap())).count();
        let sent = antrieb(&format!("-v {line}")).on(act).run().sent();
        assert_eq!(told, sent.iter().filter(|hex| given(hex)).count(), "{setpoint}: {sent:?}");
    }
}

/// However late one of them answers: the others are seen until shortly before the end, until which the line is kept for what that one owes.
#[test]
fn nobody_of_a_group_is_unseen_behind_what_a_late_one_left_owed() {
    for model in ["lxm05", "acu"] {
        let runs = "\"410\" = 15, \"412\" = 1, \"418\" = 0, \"434\" = 2, \"484\" = 10";
        let set = if model == "acu" { runs } else { "" };
        for (delay, every) in [(5, 3), (5, 7), (150, 5), (250, 3), (600, 2)] {
            let drive = |address| {
                let delay = if address == 2 { delay } else { 5 };
                format!(
                    "[[drive]]\nmodel = \"{model}\"\naddress = {address}\nreply_delay = \"{delay}ms\"\nset = {{ {set} }}\n"
                )
            };
            let late = format!("[[disturb]]\naddress = 2\nevery = {every}\nkind = \"late\"\nby = \"700ms\"\n");
            let bench = (1..=8).map(drive).collect::<String>() + &late;
            for verb in ["sollwert 0", "statemachine disable", "statemachine quick-stop"] {
                let run = antrieb(&format!("-v -a 1-8 --drive {model} {verb}")).on(&bench).run();
                let end = witness::left().unwrap().1.as_micros() as f64 / 1000.0;
                let answers = run.err.lines().filter_map(|line| line.trim().split_once(" ms < "));
                let answers: Vec<(f64, &str)> = answers.map(|(at, hex)| (at.parse().unwrap(), &hex[..2])).collect();
                for address in ["01", "03", "04", "05", "06", "07", "08"] {
                    let last = answers.iter().rfind(|answer| answer.1 == address).unwrap().0;
                    assert!(
                        end - last < 350.0,
                        "{model} {verb} {delay} {every}: {address} {last} of {end}: {}",
                        run.err
                    );
                }
                assert!(end < 60_000.0, "{model} {verb} {delay} {every}: {end}");
            }
        }
    }
}
