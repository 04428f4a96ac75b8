//! Runs and stops end by the clock, with the truth: behind a silence of the line, on one that is never silent, and at the
//! end of their duration.

use crate::run::{Output, antrieb};
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

const SERVO: &str = "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 600, RAMPdecel = 600 }\nreadings = { control_7 = \
                     \"refused\", node_guard = \"quick-stop\", quick_stop = \"stays\" }\n";
const INVERTER: &str = "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0 }\n";

/// Runs on a bench; what came of it, how long it took, and how many shafts turn.
fn ended(line: &str, bench: &str) -> (Output, Span, u64) {
    let run = antrieb(line).on(bench).run();
    let (bench, at) = witness::left().unwrap();
    (run, at.since(Tick::ZERO), bench.totals().turning)
}

#[test]
fn behind_a_silence_of_any_length_a_run_ends_with_the_truth_within_seconds() {
    let runs = [
        (SERVO, "--drive lxm05 -a 1 --yes sollwert 300rpm --enable --until reached --hold --duration 4s"),
        (INVERTER, "--drive acu -a 1 --yes sollwert 10Hz --enable --until reached --hold --duration 4s"),
    ];
    let mut sins = Vec::new();
    for (drive, line) in runs {
        for adapter in ["", "[line]\necho = true\n"] {
            for watchdog in ["", " --watchdog 2s"] {
                for (at, silent) in
                    [(400, 3_000), (1_000, 700), (1_000, 1_600), (1_000, 4_500), (1_000, 9_000), (1_700, 6_000)]
                {
                    let event = format!("[[drive.event]]\nat = \"{at}ms\"\nsilent = \"{silent}ms\"\n");
                    let (run, took, _) = ended(&format!("{line}{watchdog}"), &format!("{drive}{event}{adapter}"));
                    let most = Span::from_millis(at + silent + 7_000).longer(Span::from_secs(14));
                    // Where its own watchdog took the power, nothing shows when the shaft stands: that is said.
                    let untold = run.out.contains("NOT acknowledged") && !run.out.contains("without power");
                    if took > most || untold {
                        let told = run.out.lines().find(|line| line.starts_with("stop")).unwrap_or("-");
                        sins.push(format!(
                            "{line}{watchdog} {adapter}{at} {silent}: exit {}, {took}, {told}",
                            run.exit
                        ));
                    }
                }
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

/// Milliseconds at which a telegram went out.
fn at(line: &str) -> Option<f64> {
    line.split_once(" ms > ")?.0.trim().parse().ok()
}

#[test]
fn a_question_under_way_does_not_put_off_the_end_of_a_run() {
    let runs = [
        // PVn_target (6938 = 1B1Ah) = 0; P.410 (019Ah) = 7, disable operation.
        (
            SERVO,
            "--drive lxm05 -a 1 --yes -v sollwert 300rpm --enable --hold --duration 2s",
            "01 10 1B 1A 00 02 04 00 00 00 00",
        ),
        (INVERTER, "--drive acu -a 1 --yes -v sollwert 10Hz --enable --hold --duration 2s", "01 06 01 9A 00 07"),
    ];
    let mut sins = Vec::new();
    for (drive, line, stop) in runs {
        for from in (1_500..4_000).step_by(90) {
            let event = format!("[[drive.event]]\nat = \"{from}ms\"\nsilent = \"700ms\"\n");
            let (run, ..) = ended(line, &format!("{drive}{event}"));
            let mut behind = run.err.lines().skip_while(|line| !line.contains("running; Ctrl-C"));
            let begun = behind.find_map(at);
            let ended = behind.find(|line| line.contains(&format!("> {stop}"))).and_then(at);
            let over = begun.zip(ended).map(|(begun, ended)| ended - begun - 2_000.0);
            // Before it a line that is silent is waited for, at most 100 ms.
            if over.is_none_or(|over| !(-150.0..150.0).contains(&over)) && run.exit == 0 {
                sins.push(format!("{line}: silent at {from}: over by {over:?} ms\n{}", run.err));
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

#[test]
fn what_is_given_again_goes_out_on_time_though_looks_hang() {
    let runs = [
        (
            SERVO,
            "--drive lxm05 -a 1 --yes -v sollwert 300rpm --enable --hold --duration 6s --watchdog 2s",
            "01 10 1B 1A 00 02 04 00 00 01 2C",
            2,
        ),
        (
            INVERTER,
            "--drive acu -a 1 --yes -v sollwert 10Hz --enable --hold --duration 6s --watchdog 2s",
            "01 65 01 E4 00 00 03 E8",
            2,
        ),
    ];
    for (drive, line, refresh, guard) in runs {
        for from in (1_500..3_500).step_by(170) {
            let event = format!("[[drive.event]]\nat = \"{from}ms\"\nsilent = \"900ms\"\n");
            let (run, ..) = ended(line, &format!("{drive}{event}"));
            let held = run.err.lines().skip_while(|line| !line.contains("running; Ctrl-C"));
            let times: Vec<f64> = held.filter(|line| line.contains(&format!("> {refresh}"))).filter_map(at).collect();
            let gaps = times.windows(2).map(|pair| pair[1] - pair[0]);
            let longest = gaps.fold(0.0, f64::max);
            assert!(times.len() > 2 && longest < f64::from(guard) * 600.0, "{line} {from}: {longest} ms\n{}", run.err);
        }
    }
}

#[test]
fn what_only_takes_motion_away_gives_up_in_time_and_says_what_stops_the_shaft() {
    let babble = [
        "kind = \"babble\"\npattern = \"55\"\nby = \"20ms\"",
        "kind = \"babble\"\npattern = \"master\"\nby = \"12ms\"",
        "kind = \"babble\"\npattern = \"random\"\nby = \"1ms\"",
        "kind = \"babble\"\npattern = \"digits\"\nby = \"0ms\"",
        "every = 1\nkind = \"late\"\nby = \"6s\"",
        "every = 1\nkind = \"lost\"",
    ];
    let mut sins = Vec::new();
    for (model, set) in [("act", "\"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 20"), ("lxm05", "")] {
        for protocol in ["rtu", "ascii", "vabus"].into_iter().filter(|protocol| model == "act" || *protocol == "rtu") {
            for (nth, babble) in babble.into_iter().enumerate() {
                let bench = format!(
                    "[[drive]]\nmodel = \"{model}\"\nprotocol = \"{protocol}\"\nset = {{ {set} }}\n[[disturb]]\n{babble}\n"
                );
                let verbs =
                    ["statemachine quick-stop", "statemachine disable", "statemachine disable-voltage", "sollwert 0"];
                for (at, verb) in verbs.into_iter().enumerate() {
                    // Every other one is named, so that each verb and each line is tried both ways.
                    let drive = if (nth + at) % 2 == 0 { format!("--drive {model}") } else { String::new() };
                    let (run, took, _) = ended(&format!("--protocol {protocol} {drive} -a 1 {verb}"), &bench);
                    let told = run.exit == 0
                        || run.err.contains("without power")
                        || run.err.contains("THE SHAFT MAY STILL TURN")
                        || run.out.lines().any(|line| line.starts_with("running") && line.contains(" no"));
                    // The stop is given up within 18 s; behind it are two looks of 1.5 s, for who is enabled in that time.
                    if took > Span::from_millis(21_500) || !told {
                        let error = run.err.lines().find(|line| line.contains("error:")).unwrap_or("-");
                        sins.push(format!("{protocol} {drive} {verb} {babble:?}: {took}, exit {}, {error}", run.exit));
                    }
                }
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

#[test]
fn an_older_answer_proves_no_stop() {
    let servo = "--drive lxm05 -a 1 --yes sollwert 300rpm --enable --hold";
    let inverter = "--drive acu -a 1 --yes sollwert 10Hz --enable --hold";
    let runs =
        [(SERVO, servo, ""), (INVERTER, inverter, ""), (INVERTER, inverter, "ascii"), (INVERTER, inverter, "vabus")];
    let doubled =
        [1, 8, 15, 40, 90, 160, 240, 333, 420, 500].map(|by| format!("every = 1\nkind = \"doubled\"\nby = \"{by}ms\""));
    let late = [(2, 700), (3, 900), (4, 1_500), (3, 2_500), (5, 4_000), (7, 6_000)]
        .map(|(every, by)| format!("every = {every}\nkind = \"late\"\nby = \"{by}ms\""));
    let mut sins = Vec::new();
    for (drive, line, protocol) in runs {
        let protocol = if protocol.is_empty() { "rtu" } else { protocol };
        let drive = drive.replacen("[[drive]]", &format!("[[drive]]\nprotocol = \"{protocol}\""), 1);
        for disturb in doubled.iter().chain(&late) {
            for (duration, choice) in [(10, "quick-stop"), (120, "coast"), (330, "ramp"), (600, "quick-stop")] {
                let line = format!("--protocol {protocol} {line} --duration {duration}ms --on-exit {choice}");
                let run = antrieb(&line).on(&format!("{drive}[[disturb]]\n{disturb}\n")).run();
                let (bench, _) = witness::left().unwrap();
                let proven = run.out.lines().any(|line| line.starts_with("stop ") && line.contains(", acknowledged"));
                let (energised, turning) = (bench.totals().energised, bench.totals().turning);
                if proven && energised > 0 || (proven && turning > 0 && protocol == "rtu" && choice != "coast") {
                    sins.push(format!("{line} {disturb:?}: acknowledged, {energised} energised, {turning} turning"));
                }
            }
        }
    }
    assert!(sins.is_empty(), "{}", sins.join("\n"));
}

#[test]
fn a_stream_does_not_read_the_fault_memory_on() {
    for what in ["", "@actual"] {
        let run = antrieb(&format!("-v --drive lxm05 -a 1 monitor {what} --interval 50ms --duration 600ms"));
        let run = run.on("[[drive]]\nmodel = \"lxm05\"\n").exits(0);
        // FLT_err_num: 15362 = 3C02h.
        assert!(!run.sent().is_empty() && !run.sent().iter().any(|hex| hex.starts_with("01 03 3C 02")), "{}", run.err);
    }
    let named = antrieb("-v --drive lxm05 -a 1 monitor FLT_err_num --interval 50ms --duration 300ms");
    let named = named.on("[[drive]]\nmodel = \"lxm05\"\n").exits(0);
    assert!(named.sent().iter().any(|hex| hex.starts_with("01 03 3C 02")), "{}", named.err);
}

#[test]
fn a_new_address_is_proven_where_the_drive_is_then() {
    let bench = "[[drive]]\nmodel = \"acu\"\n";
    let run = antrieb("-v -a 1 --drive acu --yes write 1376=7").on(bench).json().exits(0);
    assert_eq!(run.data("/values/0/result"), "verified", "{:#}", run.value);
    assert!(run.err.contains(" > 07 "), "{}", run.err);
    // Its reply does not come, but it is found where it went.
    let lost = antrieb("-v -a 1 --drive acu --yes write 1376=7");
    let lost = lost.on("[[drive]]\nmodel = \"acu\"\n[[disturb]]\nonce = 2\nkind = \"lost\"\n").json();
    assert!(["verified", "unknown"].contains(&lost.data("/values/0/result").as_str().unwrap()), "{:#}", lost.value);
}
