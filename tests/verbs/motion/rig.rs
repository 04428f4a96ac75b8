//! A drive on a bench of its own in virtual time, a motor that runs on it, and what came of that.

use crate::run::{Document, Run, antrieb};
use antrieb::drive::motion::{Ended, Motor, StopChoice, look};
use antrieb::drive::{Interrupt, Opening, Session, Target};
use antrieb::failure::Failure;
use antrieb::gate::Relief;
use antrieb::outcome::Event;
use antrieb::profile::Registry;
use antrieb::protocol::line::{LineSetting, Parity};
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::{Port, witness};
use std::cell::{Cell, RefCell};

/// A drive that runs from the first moment on, and obeys the control word.
pub(super) const RUNNING: &str = "\"410\" = 15, \"412\" = 1, \"434\" = 2, \"484\" = 10, \"418\" = 0";

/// A verb on drives that have run for so long.
pub(super) fn ran(lasts: Span, line: &str, bench: &str) -> Run {
    antrieb("-b 19200 -a 1 --timeout 1ms --retries 0 --drive acu read 411").on(bench).run();
    let (mut left, at) = witness::left().unwrap();
    let at = at + lasts;
    left.advance(at);
    witness::stands(left, at);
    antrieb(line).on(bench)
}

/// Telegrams that went out, as they are shown, with the time of each in ms.
pub(super) fn sent(err: &str) -> Vec<(f64, String)> {
    let lines = err.lines().filter_map(|line| line.split_once(" ms > "));
    lines.filter_map(|(at, hex)| Some((at.trim().parse().ok()?, hex.trim().to_owned()))).collect()
}

/// When the first one that begins so went out.
pub(super) fn when(err: &str, word: &str) -> f64 {
    let found = sent(err).into_iter().find(|(_, hex)| hex.starts_with(word));
    found.unwrap_or_else(|| panic!("{word}: {err}")).0
}

pub(super) fn drive(set: &str, rest: &str) -> String {
    format!("[[drive]]\nmodel = \"acu\"\nbaud = 115200\nreply_delay = \"1ms\"\nset = {{ {set} }}\n{rest}\n")
}

/// Without a terminal and without `--yes`.
pub(super) fn alone(verb: &str, bench: &str) -> Document {
    antrieb(&format!("-v -b 115200 -a 1 {verb}")).on(bench).json()
}

/// What came of a run of a motor, on a bench of its own in virtual time.
pub(super) struct Came {
    pub(super) ended: Ended<()>,
    pub(super) notes: Vec<String>,
    /// What was said while it went on.
    pub(super) told: Vec<String>,
    /// When the run had ended.
    pub(super) took: Tick,
    pub(super) turning: u64,
    pub(super) energised: u64,
    /// Telegrams that went out, in hex, and when.
    pub(super) sent: Vec<String>,
    pub(super) at: Vec<Tick>,
    /// When the last one came in.
    pub(super) heard: Tick,
}

impl Came {
    pub(super) fn stop(&self) -> &antrieb::outcome::Stop {
        self.ended.stop.as_ref().unwrap()
    }
}

/// Holds a run, presses Ctrl-C whenever one of `presses` has gone out (`+7`: seven turns of the loop after the one before;
/// `-01 03`: it lets one of them pass), and then lets `rest` pass.
pub(super) fn held(
    bench: &str,
    presses: &[&str],
    choice: StopChoice,
    rest: Span,
    work: impl AsyncFnOnce(&mut Motor<'_, '_>) -> Result<(), Failure>,
) -> Came {
    held_of("acu", bench, presses, choice, rest, work)
}

pub(super) fn held_of(
    model: &str,
    bench: &str,
    presses: &[&str],
    choice: StopChoice,
    rest: Span,
    work: impl AsyncFnOnce(&mut Motor<'_, '_>) -> Result<(), Failure>,
) -> Came {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, bench).unwrap();
    let registry = Registry::open(&[]).unwrap();
    let (port, interrupt) = (Port::Sim(Some(file)), Interrupt::default());
    let (signals, sent) = (interrupt.clone(), RefCell::new(Vec::<String>::new()));
    let (at, heard, told) = (RefCell::new(Vec::new()), Cell::new(Tick::ZERO), RefCell::new(Vec::new()));
    let mut left: Vec<&str> = presses.to_vec();
    let yields = |next: &&str| next.strip_prefix('+').and_then(|count| count.parse::<usize>().ok());
    let mut observe = |event: Event| {
        if let Event::Note(note) = &event {
            told.borrow_mut().push(note.en.to_string());
        }
        if let Event::Telegram { at_us, direction: '<', .. } = event {
            heard.set(Tick::ZERO + Span::from_micros(at_us));
        }
        if let Event::Telegram { at_us, direction: '>', hex, .. } = event {
            at.borrow_mut().push(Tick::ZERO + Span::from_micros(at_us));
            if left.first().and_then(|next| next.strip_prefix('-')).is_some_and(|next| hex.starts_with(next)) {
                left.remove(0);
            } else if left.first().is_some_and(|next| hex.starts_with(next)) {
                left.remove(0);
                signals.press();
                // Once more, so many turns of the loop later, whatever is under way then.
                if let Some(turns) = left.first().and_then(yields) {
                    left.remove(0);
                    let signals = signals.clone();
                    tokio::spawn(async move {
                        for _ in 0..turns {
                            tokio::task::yield_now().await;
                        }
                        signals.press();
                    });
                }
            }
            sent.borrow_mut().push(hex);
        }
    };
    let opening = Opening {
        line: LineSetting::rtu(if model == "lxm05" { 19_200 } else { 115_200 }, Parity::Even),
        verbose: true,
        ..Opening::at(&port)
    };
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let mut session = runtime.block_on(Session::open(opening, &registry, interrupt, &mut observe)).unwrap();
    let mut target = Target::new(1, registry.family(model).unwrap());
    // Any permit will do; what a motor does with it is the work's business.
    let permit = Relief::QuickStop.permit();
    let (ended, notes, took) = runtime.block_on(async {
        let before = look(&mut session, &mut target).await.unwrap();
        let mut motor = Motor::new(&mut session, &mut target, &permit, None);
        motor.controls(&before);
        let ended = motor.run(true, choice, work).await;
        let notes = motor.notes.iter().map(|note| note.en.to_string()).collect();
        let took = session.now();
        session.rest(rest).await.unwrap();
        (ended, notes, took)
    });
    let totals = session.bench().map(|bench: &mut Bench| bench.totals()).unwrap();
    drop(session);
    let (sent, at, heard, told) = (sent.into_inner(), at.into_inner(), heard.get(), told.into_inner());
    Came { ended, notes, told, took, turning: totals.turning, energised: totals.energised, sent, at, heard }
}

pub(super) const READY: &str = "\"412\" = 1, \"434\" = 2, \"418\" = 0";

/// Enables, runs at 20 Hz, holds.
pub(super) async fn run_at_20_hz(motor: &mut Motor<'_, '_>, duration: Option<Span>) -> Result<(), Failure> {
    let setpoint = Registry::open(&[]).unwrap().family("acu").unwrap().role("setpoint-frequency").unwrap().clone();
    motor.walk("operation-enabled").await?;
    motor.give(&setpoint, 2_000, "Hz").await?;
    motor.until_reached().await?;
    motor.hold(duration, async |motor: &mut Motor<'_, '_>, _| motor.refresh(&setpoint, 2_000).await).await
}

pub(super) const DISABLE: &str = "01 06 01 9A 00 07";
pub(super) const QUICK_STOP: &str = "01 06 01 9A 00 02";
pub(super) const COAST: &str = "01 06 01 9A 00 00";
pub(super) const ENCODER: &str = "01 64 00 D9";
pub(super) const REFRESH: &str = "01 65 01 E4";

/// Enables a servo, and runs it at a speed.
pub(super) async fn servo_at(motor: &mut Motor<'_, '_>, rpm: i64, duration: Option<Span>) -> Result<(), Failure> {
    let registry = Registry::open(&[]).unwrap();
    let family = registry.family("lxm05").unwrap();
    let mode = family.mode("velocity").unwrap().clone();
    let param = family.param_or_unknown(mode.setpoint);
    motor.prepare(&mode);
    motor.give(&param, 0, "rpm").await?;
    motor.walk("operation-enabled").await?;
    motor.enter().await?;
    motor.give(&param, rpm, "rpm").await?;
    motor.hold(duration, async |motor: &mut Motor<'_, '_>, _| motor.refresh(&param, rpm).await).await
}

pub(super) fn servo(set: &str, rest: &str) -> String {
    format!("[[drive]]\nmodel = \"lxm05\"\nset = {{ {set} }}\n{rest}\n")
}
