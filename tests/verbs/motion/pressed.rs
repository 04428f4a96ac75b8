//! Who presses Ctrl-C while several drives are stopped, once, twice or three times: each that is not proven hears the next stronger word, and
//! the end comes soon.

use super::by_chance::{BEGIN, Manner, Member, Trial};
use antrieb::failure::Class;
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;

fn member(address: u8, model: &'static str, manner: Manner, delay: u64) -> Member {
    Member { address, model, manner, delay, ramp: 4_000 }
}

/// When something went out first that begins so, in ms since the stop began.
fn first(log: &[String], begins: &str) -> Option<f64> {
    let sent = log.iter().filter_map(|line| line.split_once(" > "));
    let at = |at: &str| at.trim().parse::<f64>().ok().map(|ms| ms - BEGIN.as_millis() as f64);
    sent.filter(|(_, hex)| hex.starts_with(begins)).find_map(|(ms, _)| at(ms))
}

/// When the n-th Ctrl-C was heard, in ms since the stop began.
fn pressed_at(log: &[String], nth: usize) -> Option<f64> {
    let at = log.iter().enumerate().filter(|(_, line)| line.trim() == "Ctrl-C").nth(nth)?.0;
    let time = |line: &String| line.split_once(['>', '<', '~'])?.0.trim().parse::<f64>().ok();
    log.iter().take(at).rev().find_map(time).map(|ms| ms - BEGIN.as_millis() as f64)
}

/// Drives that ignore their stop, quick and slow ones, one that ramps down, and a dead one.
fn group(verb: &'static str, presses: &[usize]) -> Trial {
    let members = vec![
        member(1, "acu", Manner::Good, 10),
        member(2, "acu", Manner::Ignores, 10),
        member(3, "acu", Manner::Ignores, 450),
        member(4, "lxm05", Manner::Ignores, 5),
        member(5, "acu", Manner::Dead, 10),
    ];
    Trial { members, verb, presses: presses.to_vec(), hangs_up: None }
}

/// The strongest word to each of those that ignore theirs.
const STRONGEST: [&str; 3] = ["02 06 01 9A 00 00", "03 06 01 9A 00 00", "04 10 1B 02 00 02 04 00 00 00 00"];

#[test]
fn each_press_is_a_stronger_word_for_whoever_is_not_proven() {
    let registry = Registry::open(&[]).unwrap();
    for verb in ["statemachine disable", "statemachine quick-stop"] {
        for presses in [&[][..], &[70], &[70, 90], &[70, 90, 110]] {
            let trial = group(verb, presses);
            let seen = trial.run(&registry);
            let took = seen.at.since(Tick::ZERO + BEGIN);
            let told = format!("{verb} {presses:?}: {took}\n{}", seen.log.join("\n"));
            assert_eq!(trial.sins(&seen), Vec::<String>::new(), "{told}");
            let coasts: Vec<_> = STRONGEST.iter().map(|word| first(&seen.log, word)).collect();
            let pressed: Vec<_> = (0..presses.len()).map(|nth| pressed_at(&seen.log, nth)).collect();
            let latest = coasts.iter().map(|at| at.unwrap_or(f64::MAX)).fold(0.0, f64::max);
            // 450 ms for each answer, in less than half of the time, and nothing to be taken for one of before.
            assert!(latest < 21_000.0, "{latest} {told}");
            // Who answers at once waits for nobody: it hears the strongest right behind the second press.
            let quick = [coasts[0], coasts[2]].map(Option::unwrap);
            let strongest = if verb.ends_with("disable") { 1 } else { 0 };
            if let Some(press) = pressed.get(strongest).copied().flatten() {
                assert!(quick.iter().all(|at| at - press < 1_500.0), "{quick:?} {press} {told}");
                // Who is slow had not had his turn when it was pressed twice, and hears it in his next ones all the same.
                assert!(coasts[1].is_some_and(|at| at - press < 6_000.0), "{coasts:?} {press} {told}");
            }
        }
    }
}

/// One whose shaft coasts shows by its encoder when it stands, whoever is beside it.
#[test]
fn an_encoder_proves_a_shaft_that_coasts_beside_others() {
    let registry = Registry::open(&[]).unwrap();
    for other in [(Manner::Dead, 10), (Manner::Ignores, 450), (Manner::Doubled(450), 10), (Manner::Good, 450)] {
        let members =
            vec![Member { ramp: 1_000, ..member(1, "acu", Manner::Encoder, 10) }, member(2, "acu", other.0, other.1)];
        let trial = Trial { members, verb: "statemachine disable", presses: Vec::new(), hangs_up: None };
        let seen = trial.run(&registry);
        let told = format!("{other:?}: {}", seen.log.join("\n"));
        let coasting = seen.drives[0].motion.as_ref();
        assert_eq!(coasting.and_then(|motion| motion.standing), Some(true), "{told}");
        assert!(seen.drives[0].error.is_none(), "{told}");
        assert_eq!(seen.bench.drive(1).unwrap().turning(seen.at), 0, "{told}");
        let sins: Vec<_> = trial.sins(&seen).into_iter().filter(|sin| !sin.starts_with("SLOW")).collect();
        assert_eq!(sins, Vec::<String>::new(), "{told}");
        assert!(seen.at.since(Tick::ZERO + BEGIN) < Span::from_secs(40), "{told}");
    }
}

/// A held run on a line that went dead: three presses end it, however long `--timeout` lets an answer take.
#[test]
fn three_presses_end_a_held_run_on_a_dead_line_whatever_its_time_out() {
    let registry = Registry::open(&[]).unwrap();
    let set = "\"412\" = 1, \"434\" = 2, \"418\" = 0";
    for timeout in ["500ms", "10s", "60s"] {
        for dead in [60, 61, 70] {
            let silent = format!("[[drive.event]]\nafter_telegrams = {dead}\nsilent = \"600s\"");
            let bench = format!("[[drive]]\nmodel = \"acu\"\nset = {{ {set} }}\n{silent}\n");
            let line = format!("--timeout {timeout} -a 1 --drive acu sollwert 10Hz --enable --hold --duration 60s");
            let presses: Vec<usize> = (1..=3).map(|nth| 2 * dead + nth).collect();
            let seen = Trial::on_bench(&line, &bench, &registry, (&presses, None));
            let told = format!("{timeout} {dead}: {:?}\n{}", seen.failure, seen.log.join("\n"));
            let since = first(&seen.log, "01 06 01 9A 00 00").expect(&told);
            let took = seen.at.since(Tick::ZERO).as_millis() as f64 - (since + BEGIN.as_millis() as f64);
            println!("{timeout} {dead}: {took} ms behind the third");
            assert!(took < 16_000.0, "{took} {told}");
            let failure = seen.failure.unwrap();
            assert!(failure.told().en.starts_with("THE SHAFT MAY STILL TURN"), "{failure:?}");
        }
    }
}

/// One stands early, somebody enables it again, and Ctrl-C comes while the other one slows: it is seen behind that, and stopped.
#[test]
fn whoever_stood_before_the_press_is_looked_at_behind_it() {
    let registry = Registry::open(&[]).unwrap();
    for verb in ["statemachine quick-stop", "statemachine disable"] {
        let [mut early, late] = [member(1, "acu", Manner::Good, 5), member(2, "acu", Manner::Good, 5)];
        early.ramp = 20;
        let run = |event: &str, presses: &[usize]| {
            let bench = early.table() + event + &late.table();
            let mut left = Bench::from_toml("bench", &bench, &registry).unwrap();
            left.advance(Tick::ZERO + BEGIN);
            witness::stands(left, Tick::ZERO + BEGIN);
            Trial::on_bench(&format!("-a 1,2 {verb}"), &bench, &registry, (presses, None))
        };
        let timed = |line: &String| line.split_once(['>', '<', '~'])?.0.trim().parse::<f64>().ok();
        let telegrams: Vec<f64> = run("", &[]).log.iter().filter_map(timed).collect();
        for (enabled, pressed) in [(1_900, 100.0), (2_500, 300.0)] {
            let at = BEGIN.as_millis() + enabled;
            let set =
                |(later, word)| format!("[[drive.event]]\nat = \"{}ms\"\nset = {{ \"410\" = {word} }}\n", at + later);
            let press = telegrams.iter().filter(|ms| **ms < at as f64 + pressed).count();
            let mut seen = run(&[(0, 6), (20, 7), (40, 15)].map(set).concat(), &[press]);
            seen.bench.advance(seen.at);
            let told = format!("{verb} {enabled} {press}: {:?}\n{}", seen.failure, seen.log.join("\n"));
            assert!(press < telegrams.len() && pressed_at(&seen.log, 0).is_some(), "{told}");
            assert_eq!((seen.bench.totals().turning, seen.bench.totals().energised), (0, 0), "{told}");
            let notes = format!("{:?}", seen.drives[0].motion.as_ref().map(|motion| &motion.notes));
            assert!(notes.contains("it was enabled again behind its stop"), "{notes} {told}");
            assert_eq!(seen.failure.map(|failure| failure.class), Some(Class::Interrupted), "{told}");
        }
    }
}

/// Whoever does not wait for the end of `disable` is told by the first line that the shaft coasts, wherever he presses.
#[test]
fn a_press_beside_a_shaft_that_coasts_is_told_with_the_capitals() {
    let registry = Registry::open(&[]).unwrap();
    let bench =
        "[[drive]]\nmodel = \"lxm05\"\naddress = 1\nreply_delay = \"5ms\"\n[drive.readings]\ncontrol_7 = \"coasts\"\n";
    let mut coasting = 0;
    for press in 4..24 {
        witness::stands(Bench::from_toml("bench", bench, &registry).unwrap(), Tick::ZERO);
        let start = "-a 1 --drive lxm05 sollwert 3000rpm --mode velocity --enable --until reached";
        let started = Trial::on_bench(start, bench, &registry, (&[], None));
        witness::stands(started.bench, started.at);
        let mut seen = Trial::on_bench("-a 1 statemachine disable", bench, &registry, (&[press], None));
        seen.bench.advance(seen.at);
        let told = format!("{press}: {:?}\n{}", seen.failure, seen.log.join("\n"));
        if seen.bench.totals().turning > 0 {
            coasting += 1;
            assert!(seen.failure.is_some_and(|failure| failure.alarm), "{told}");
        }
    }
    assert!(coasting > 3, "{coasting}");
}
