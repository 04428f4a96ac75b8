//! What is said of a question whose time was over: nothing that came is no answer to something older, and nobody else is blamed.

use super::rig::{RUNNING, drive};
use crate::run::antrieb;
use antrieb::drive::{Interrupt, Opening, Session};
use antrieb::profile::Registry;
use antrieb::tick::Span;
use antrieb::transport::Port;
use std::future::poll_fn;
use std::task::Poll;

const DEAD: &str = "[[drive.event]]\nat = \"700ms\"\nsilent = \"10min\"\n";

#[test]
fn a_line_that_died_is_no_second_master() {
    let servo = format!("[[drive]]\nmodel = \"lxm05\"\n{DEAD}");
    let inverter = drive(RUNNING, DEAD);
    for (line, bench) in [
        ("-a 1 --yes sollwert 100rpm --enable --hold --duration 3s --watchdog 2s", servo.as_str()),
        ("-b 115200 -a 1 --yes sollwert 15Hz --enable --hold --duration 3s --watchdog 2s", &inverter),
        ("-a 1 statemachine quick-stop", &servo.replace("700ms", "0s")),
        ("-b 115200 -a 1 statemachine quick-stop", &inverter.replace("700ms", "0s")),
    ] {
        let run = antrieb(line).on(bench).json().exits(4);
        let told = format!("{line} {:#} {}", run.value, run.err);
        for blamed in ["asked 0 times", "older question", "second master", "never silent"] {
            assert!(!told.contains(blamed), "{blamed}: {told}");
        }
        assert!(run.error()["message"].as_str().unwrap().starts_with("THE SHAFT MAY STILL TURN"), "{told}");
    }
}

/// A station that is late is waited for, and that is not the line's doing.
#[test]
fn who_answers_late_is_not_a_line_that_is_never_silent() {
    for model in ["acu", "lxm05"] {
        for ms in [600, 900, 1_200] {
            let bench = format!("[[drive]]\nmodel = \"{model}\"\nreply_delay = \"{ms}ms\"\n");
            for verb in [
                "identify",
                "statemachine show",
                "sollwert 0",
                "--yes sollwert 10Hz --enable --hold --duration 2s",
                "diag",
            ] {
                let run = antrieb(&format!("-a 1 {verb}")).on(&bench).run();
                let told = format!("{model} {ms} {verb}: {} {}", run.out, run.err);
                assert!(!told.contains("never silent"), "{told}");
                assert!(run.exit != 5 || run.err.contains("--timeout"), "{told}");
            }
        }
    }
}

/// The time of a bench stands still at a question, also where several are talked to at once.
#[test]
fn a_question_takes_no_time_of_the_bench_whoever_shares_its_line() {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, drive(RUNNING, "")).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let (port, mut observe) = (Port::Sim(Some(file)), |_| {});
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let opening = Opening::at(&port);
    let took = runtime.block_on(async {
        let mut session = Session::open(opening, &registry, Interrupt::default(), &mut observe).await.unwrap();
        let asked = async |session: &mut Session<'_>, _: usize| {
            let (begun, mut left) = (session.now(), 5);
            let answer = poll_fn(|context| {
                left -= 1;
                context.waker().wake_by_ref();
                if left == 0 { Poll::Ready(()) } else { Poll::Pending }
            });
            session.during(answer).await.unwrap();
            session.now().since(begun)
        };
        session.side_by_side(&[1, 2], asked).await
    });
    assert_eq!(took, [Span::ZERO; 2]);
}
