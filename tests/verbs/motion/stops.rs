//! The stop trial: every way in which a run can end, at every step of it, on every family, under the strictest readings of
//! the manuals. After each the bench itself is asked: does the shaft turn, was the report true, was everything given back?
//!
//! In virtual time. Ctrl-C, SIGTERM, SIGHUP and a closed pipe are one wish to end here ([`Interrupt`]); that they reach it is
//! tried on real terminals by `tests/peers`.

use crate::agreeable::Agreeable;
use antrieb::args::{Environment, Globals, Settings};
use antrieb::command::{Context, sollwert, statemachine};
use antrieb::drive::Interrupt;
use antrieb::failure::{Class, Failure};
use antrieb::outcome::{Data, Event, Motion, Outcome};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use clap::Parser;
use std::cell::{Cell, RefCell};

#[derive(Parser)]
struct Cli {
    #[command(subcommand)]
    verb: Verb,
    #[command(flatten)]
    globals: Globals,
}

#[derive(clap::Subcommand)]
enum Verb {
    Sollwert(sollwert::Args),
    Statemachine(statemachine::Args),
}

/// A drive under some readings, and what is typed.
#[derive(Clone, Copy)]
struct Case {
    model: &'static str,
    keys: &'static str,
    readings: &'static str,
    line: &'static str,
    verb: &'static str,
    bound: &'static str,
    /// What must stand as before: parameters of the RAM.
    kept: &'static [u32],
}

/// How a run is brought to its end at a step of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    /// Its duration.
    Duration,
    /// Ctrl-C, SIGTERM, SIGHUP, a closed pipe.
    Wish,
    /// That, and once more a few telegrams later.
    Twice,
    Fault,
    /// Of a servo; of 3 and of an ACTIVE is [`End::Fault`].
    Class(u8),
    /// The adapter is pulled.
    Pulled,
    EnableLost,
    EnableBlinks,
    PowerCycle,
    /// Its mains, for good: an ACU lives on, an ACT is off.
    MainsLost,
    /// The line is dead for so long, ms.
    Silent(u64),
}

/// What came of a run.
struct Seen {
    telegrams: usize,
    motion: Option<Motion>,
    failure: Option<Failure>,
    bench: Bench,
    at: Tick,
}

/// So many telegrams later somebody presses again.
const AGAIN: usize = 5;
/// A second drive at the same address.
const TWIN: &str = "[[drive]]\nmodel = \"lxm05\"\nset = { RAMPacc = 3000, RAMPdecel = 3000 }\nreply_delay = \"4ms\"";
const TWIN_ACTIVE: [&str; 2] = [
    "[[drive]]\nmodel = \"act\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0 }\nreply_delay = \"14ms\"",
    "[[drive]]\nmodel = \"acu\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0 }\nreply_delay = \"14ms\"",
];
const ACTIVE: &str = "set = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"217\" = 0, \"218\" = 0 }";
/// Where the stop leaves the shaft turning without power: transition 5 coasts, or brakes with direct current for too short;
/// a high switch-off threshold without a holding time.
const COASTS: &str = "set = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"392\" = 0, \"217\" = 0, \"218\" = 0 }";
const BRAKES: &str =
    "set = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"392\" = 1, \"632\" = \"0.2\", \"217\" = 0, \"218\" = 0 }";
const DROPS: &str =
    "set = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"637\" = 15, \"638\" = 0, \"217\" = 0, \"218\" = 0 }";
/// The same with an encoder.
const DROPS_SEEN: &str = "set = { \"412\" = 1, \"434\" = 3, \"228\" = 0, \"637\" = 15, \"638\" = 0 }";
const ACTIVE_KEPT: &[u32] = &[412, 413, 434];
const SERVO: &str = "set = { RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000 }\nservo = { guide = 16384 }";
const SERVO_KEPT: &[u32] = &[1_284, 1_556, 5_644, 6_930, 6_938, 6_944, 6_946, 6_948, 8_200, 8_456, 9_734, 9_736];
const STRICT_SERVO: &str = "mode_change = \"refused\", references_after_run = \"kept\", references_after_mode = \"kept\", \
                            control_7 = \"refused\", node_guard = \"quick-stop\", quick_stop = \"stays\"";
const QUICK: &str = "--enable --hold --duration 400ms --watchdog 1s --on-exit quick-stop";
const COAST: &str = "--enable --hold --duration 400ms --watchdog 1s --on-exit coast";
const OVER_VABUS: &str = "protocol = \"vabus\"\nset = { \"412\" = 1, \"434\" = 3, \"228\" = 0 }";
const BOUND: &str = "--enable --hold --duration 400ms --watchdog 1s";

fn cases() -> Vec<Case> {
    let active = |model, readings, line| Case {
        model,
        keys: ACTIVE,
        readings,
        line,
        verb: "sollwert 10Hz --until reached",
        bound: BOUND,
        kept: ACTIVE_KEPT,
    };
    let servo = |readings, line, verb| Case {
        model: "lxm05",
        keys: SERVO,
        readings,
        line,
        verb,
        bound: BOUND,
        kept: SERVO_KEPT,
    };
    let doubled = "[[disturb]]\nevery = 3\nkind = \"doubled\"";
    let late = "[[disturb]]\nevery = 4\nkind = \"late\"\nby = \"400ms\"";
    let mut cases = vec![
        servo("", "", "sollwert 600rpm --mode velocity --set RAMPacc=2000"),
        servo(STRICT_SERVO, "", "sollwert 600rpm --mode velocity --set RAMPacc=2000"),
        servo(STRICT_SERVO, "", "sollwert 300rpm --mode speed"),
        servo(STRICT_SERVO, "", "sollwert 2/3 --set IOposInterfac=1"),
        servo("control_7 = \"brakes\", setpoints_after_run = \"zeroed\"", doubled, "sollwert 600rpm --mode velocity"),
        servo(STRICT_SERVO, late, "sollwert 600rpm --mode velocity"),
        Case { bound: QUICK, ..servo(STRICT_SERVO, "", "sollwert 600rpm --mode velocity") },
        Case { bound: COAST, ..servo(STRICT_SERVO, "", "sollwert 600rpm --mode velocity") },
        servo(STRICT_SERVO, TWIN, "sollwert 600rpm --mode velocity"),
        servo(STRICT_SERVO, "", "sollwert 2A"),
        servo(STRICT_SERVO, doubled, "sollwert 5 --mode jog"),
        Case { bound: QUICK, ..servo("node_guard = \"fault\"", late, "sollwert 300rpm --mode speed") },
    ];
    for model in ["act", "acu"] {
        cases.extend([
            active(model, "", ""),
            active(model, "control_word = \"edge\", ram_reads = \"in-force\"", ""),
            active(model, "", doubled),
            active(model, "control_word = \"edge\"", late),
            Case { bound: QUICK, ..active(model, "", "") },
            Case { bound: COAST, ..active(model, "", late) },
            Case { bound: QUICK, ..active(model, "", doubled) },
            active(model, "", TWIN_ACTIVE[usize::from(model == "acu")]),
            Case {
                verb: "statemachine enable",
                bound: "--hold --duration 400ms --watchdog 1s",
                ..active(model, "control_word = \"edge\"", "")
            },
            Case {
                keys: OVER_VABUS,
                verb: "--protocol vabus sollwert 10Hz",
                ..active(model, "after_nak = \"silence\"", "")
            },
            Case { keys: DROPS, bound: if model == "act" { BOUND } else { QUICK }, ..active(model, "", "") },
            Case { keys: DROPS_SEEN, bound: if model == "act" { QUICK } else { BOUND }, ..active(model, "", "") },
            Case { keys: if model == "act" { COASTS } else { BRAKES }, ..active(model, "", "") },
            Case { keys: COASTS, bound: COAST, ..active(model, "coast_shows = \"shaft\"", "") },
        ]);
    }
    cases
}

impl Case {
    fn bench(&self, end: End, step: usize) -> String {
        let event = |what: &str| format!("[[drive.event]]\nafter_telegrams = {step}\n{what}\n");
        let event = match (end, self.model) {
            (End::Duration | End::Wish | End::Twice | End::Pulled, _) => String::new(),
            (End::Class(class), _) => event(&format!("fault = \"E2300\"\nclass = {class}")),
            (End::Fault, "lxm05") => event("fault = \"E2300\""),
            (End::Fault, _) => event("fault = \"F0500\""),
            (End::EnableLost, _) => event("enable = false"),
            (End::EnableBlinks, _) => event("enable = false\nfor = \"600ms\""),
            (End::MainsLost, _) => event("mains = false"),
            (End::PowerCycle, _) => event("power_cycle = true"),
            (End::Silent(ms), _) => event(&format!("silent = \"{ms}ms\"")),
        };
        let Case { model, keys, readings, line, .. } = self;
        format!("[[drive]]\nmodel = \"{model}\"\n{keys}\nreadings = {{ {readings} }}\n{event}{line}\n")
    }

    fn ends(&self) -> Vec<End> {
        let mut ends = vec![End::Wish, End::Twice, End::Fault, End::PowerCycle, End::Pulled];
        ends.extend([End::Silent(700), End::Silent(3_600_000)]);
        ends.extend(match self.model {
            "lxm05" => &[End::Class(1), End::Class(2)][..],
            _ => &[End::EnableLost, End::EnableBlinks, End::MainsLost][..],
        });
        ends
    }

    fn run(&self, registry: &Registry, end: End, step: usize) -> Seen {
        let directory = tempfile::tempdir().unwrap();
        let file = directory.path().join("bench.toml");
        std::fs::write(&file, self.bench(end, step)).unwrap();
        let line =
            format!("antrieb -p sim:{} --drive {} -a 1 --yes {} {}", file.display(), self.model, self.verb, self.bound);
        let cli = Cli::parse_from(line.split(' '));
        let environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
        let settings = Settings { verbose: true, ..Settings::resolve(&cli.globals, &environment).unwrap() };
        let (interrupt, telegrams) = (Interrupt::default(), Cell::new(0));
        let wish = interrupt.clone();
        let mut observe = |event: Event| {
            if matches!(event, Event::Telegram { .. }) {
                telegrams.set(telegrams.get() + 1);
                match end {
                    End::Wish | End::Twice if telegrams.get() == step => wish.raise(),
                    End::Twice if telegrams.get() == step + AGAIN => wish.press(),
                    _ => {}
                }
            }
        };
        witness::call(true);
        witness::pull_after((end == End::Pulled).then_some(step as u64 / 2));
        let mut ask = Agreeable;
        let mut context = Context {
            settings: &settings,
            registry,
            ask: &mut ask,
            observe: &mut observe,
            interrupt,
            sheet: antrieb::render::sheet,
            calls: None,
        };
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        let result = runtime.block_on(async {
            match &cli.verb {
                Verb::Sollwert(args) => sollwert::run(args, &mut context).await,
                Verb::Statemachine(args) => statemachine::run(args, &mut context).await,
            }
        });
        let (motion, failure) = match result {
            Ok(Outcome { data: Some(Data::Motion(motion)), failure, .. }) => (Some(motion), failure),
            Ok(outcome) => (None, outcome.failure),
            Err(failure) => (None, Some(failure)),
        };
        let (bench, at) = witness::left().unwrap();
        Seen { telegrams: telegrams.get(), motion, failure, bench, at }
    }

    /// Everything that is wrong with what came of a run.
    fn sins(&self, registry: &Registry, end: End, seen: &Seen) -> Vec<String> {
        let mut sins = Vec::new();
        let (turning, energised) = (seen.bench.totals().turning, seen.bench.totals().energised);
        // The watchdog of the run stops what no telegram could stop.
        let mut later = seen.bench.clone();
        later.advance(seen.at + Span::from_secs(12));
        if later.totals().turning > 0 {
            sins.push("the shaft is left turning".to_owned());
        }
        let Some(motion) = &seen.motion else {
            if turning + energised > 0 {
                sins.push(format!("no report, and it runs: {:?}", seen.failure));
            }
            return sins;
        };
        let proven = motion.stop.as_ref().is_some_and(|stop| stop.acknowledged);
        let standing = motion.stop.as_ref().and_then(|stop| stop.standing);
        if proven && energised > 0 {
            sins.push(format!("acknowledged, but energised {energised}"));
        }
        if turning > 0 && standing == Some(true) {
            sins.push("standing, but it turns".to_owned());
        }
        let gently = motion.stop.as_ref().is_some_and(|stop| stop.choice != "coast");
        if seen.failure.is_none() && gently && !motion.idle && standing != Some(true) {
            sins.push(format!("exit 0 of a ramp, but standing {standing:?}"));
        }
        // "running: no" stands alone only beside a shaft that was seen to stand, or that nobody powered.
        let plain = motion.running == Some(false) && (motion.standing == Some(true) || motion.idle);
        if turning > 0 && (plain || motion.standing == Some(true)) {
            sins.push(format!("running no, standing {:?}, idle {}, but it turns", motion.standing, motion.idle));
        }
        if motion.running == Some(false) && energised > 0 {
            sins.push("running no, but energised".to_owned());
        }
        if seen.failure.is_none() && !proven {
            sins.push("exit 0 without a proven stop".to_owned());
        }
        let drive = seen.bench.drives().next().unwrap();
        // Over a dead line nothing is given back; it must be told.
        let gone = matches!(end, End::Pulled | End::Silent(_));
        let dead = seen.failure.as_ref().is_some_and(|failure| {
            matches!(failure.class, Class::Port | Class::Silence) || (gone && failure.code == "partial.not_given_back")
        });
        for change in &motion.changed {
            let now = drive.ram(change.param, change.data_set);
            if change.restored && now != Some(change.old) {
                sins.push(format!("{} is said to be given back and is {now:?}", change.name));
            }
            let stays = change.param == 412;
            if proven && !dead && !change.restored && now != Some(change.old) && !stays {
                sins.push(format!("{} is not given back: {now:?}", change.name));
            }
        }
        if proven {
            let fresh = Bench::from_toml("bench", &self.bench(End::Duration, 0), registry).unwrap();
            let fresh = fresh.drives().next().unwrap();
            for &param in self.kept {
                let left = [format!("({param}) may still stand"), format!("P.{param} may still stand")];
                let told = dead
                    && (motion.changed.iter().any(|change| change.param == param && !change.restored)
                        || motion.notes.iter().any(|note| left.iter().any(|left| note.en.contains(left))));
                if drive.ram(param, 0) != fresh.ram(param, 0) && !told {
                    sins.push(format!("{param} was {:?} and is {:?}", fresh.ram(param, 0), drive.ram(param, 0)));
                }
            }
        }
        sins
    }
}

/// Every reply comes so late that each question takes most of the 500 ms that a drive may take (CM-485 manual 6.8).
fn late_cases() -> Vec<Case> {
    let late = "[[disturb]]\nevery = 1\nkind = \"late\"\nby = \"400ms\"";
    let bounds = |hold: &'static str, quick: &'static str, nth: usize| if nth == 0 { hold } else { quick };
    let hold = "--enable --hold --duration 400ms --watchdog 3s";
    let quick = "--enable --hold --duration 400ms --watchdog 3s --on-exit quick-stop";
    let (mut cases, servo, active) = (Vec::new(), "sollwert 600rpm --mode velocity", "sollwert 10Hz --until reached");
    for (nth, readings) in ["", STRICT_SERVO].into_iter().enumerate() {
        let bound = bounds(hold, quick, nth);
        cases.push(Case { model: "lxm05", keys: SERVO, readings, line: late, verb: servo, bound, kept: SERVO_KEPT });
    }
    for (nth, model) in ["act", "acu"].into_iter().enumerate() {
        let bound = bounds(quick, hold, nth);
        cases.push(Case { model, keys: ACTIVE, readings: "", line: late, verb: active, bound, kept: ACTIVE_KEPT });
    }
    cases
}

/// Runs through cases with a stride; tells how many runs there were and what was wrong.
fn trial(cases: Vec<Case>, stride: usize) -> String {
    let registry = Registry::open(&[]).unwrap();
    let (mut runs, sins) = (0, RefCell::new(Vec::new()));
    for (nth, case) in cases.into_iter().enumerate() {
        let whole = case.run(&registry, End::Duration, 0);
        let name = format!("{} {} [{}] {}", case.model, case.verb, case.readings, case.line.replace('\n', " "));
        let mut note = |end: End, step: usize, seen: &Seen| {
            runs += 1;
            for sin in case.sins(&registry, end, seen) {
                let failure = seen.failure.as_ref().map(|failure| failure.code.clone());
                sins.borrow_mut().push(format!("{name}: {end:?} at {step}: {sin} ({failure:?})"));
            }
        };
        note(End::Duration, 0, &whole);
        // Where nothing shows whether the shaft stands, a ramp is no success.
        let code = whole.failure.as_ref().map(|failure| failure.code.as_str());
        let unseen = [DROPS, COASTS, BRAKES].contains(&case.keys) && case.bound != COAST;
        if code != unseen.then_some("forbidden.standstill_unproven") && (case.line.is_empty() || code.is_none()) {
            sins.borrow_mut().push(format!("{name}: does not end well by itself: {:?}", whole.failure));
        }
        for (end, shift) in case.ends().into_iter().zip(nth..) {
            for step in (1 + 7 * shift % stride..=whole.telegrams).step_by(stride) {
                note(end, step, &case.run(&registry, end, step));
            }
        }
    }
    let sins = sins.into_inner();
    let turning = sins.iter().filter(|sin| sin.contains("left turning")).count();
    let text = format!("{runs} runs: {turning} shafts left turning, {} false reports", sins.len() - turning);
    assert!(sins.is_empty(), "{text}\n{}", sins.join("\n"));
    text
}

/// STOPS_STRIDE=1 takes every step (the long form, some minutes); 83 is usual.
#[test]
#[expect(clippy::disallowed_methods, reason = "how long a trial is its caller says")]
fn no_end_at_any_step_leaves_a_shaft_turning_or_a_false_report() {
    let stride = std::env::var("STOPS_STRIDE").ok().and_then(|stride| stride.parse().ok());
    println!("{}", trial(cases(), stride.unwrap_or(83)));
}

/// Over RTU; an ACTIVE is also asked what it will run at.
#[test]
fn no_end_on_a_line_that_is_always_late_leaves_a_shaft_turning_or_a_false_report() {
    println!("{}", trial(late_cases(), 31));
}

/// Whoever interrupts the question how the drive ends a ramp has no answer to it: direct current shows 0 as well.
#[test]
fn an_interrupt_of_the_last_question_of_a_stop_proves_nothing() {
    let registry = Registry::open(&[]).unwrap();
    for case in cases().into_iter().filter(|case| case.keys == BRAKES) {
        let whole = case.run(&registry, End::Duration, 0).telegrams;
        for step in whole - 80..whole {
            let seen = case.run(&registry, End::Twice, step);
            assert_eq!(case.sins(&registry, End::Twice, &seen), Vec::<String>::new(), "{step} of {whole}");
        }
    }
}
