//! A motor that is run over PROFIBUS in virtual time; and what its shaft did at every telegram, by saying the same to the same line once
//! more.

use antrieb::args::{Globals, Settings};
use antrieb::command::{Context, sollwert, statemachine};
use antrieb::drive::{Button, Interrupt};
use antrieb::failure::Failure;
use antrieb::gate::{Answer, Ask, Question, Reply};
use antrieb::outcome::{Data, Event, Motion, Outcome, Stop};
use antrieb::profile::Registry;
use antrieb::protocol::dp::{Parameters, Service, Telegram};
use antrieb::simulator::Profibus;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use clap::{Args, Command};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// A motor at rest that only the words of a master start: P.703 keeps it running, P.928 is 0, ramps of 2 s to 50 Hz.
pub(super) const RESTS: &str = "\"928\" = 0, \"703\" = 0, \"7\" = -200, \"9\" = -200";

/// An L200 at 3, with these raw values, readings, and whatever happens to it.
pub(super) fn module(set: &str, readings: &str, events: &str) -> String {
    format!("[[module]]\ndrive = \"l200\"\naddress = 3\nset = {{ {set} }}\nreadings = {{ {readings} }}\n{events}\n")
}

/// Something happens to it.
pub(super) fn event(at: &str, what: &str) -> String {
    format!("[[module.event]]\nat = \"{at}\"\n{what}\n")
}

/// What somebody does meanwhile.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Hand<'h> {
    /// Presses Ctrl-C behind these telegrams, counted from 0.
    pub(super) presses: &'h [usize],
    /// Presses it at this question, counted from 0.
    pub(super) presses_at: Option<usize>,
    /// Says no to this one.
    pub(super) denies: Option<usize>,
    /// So long is thought about the second.
    pub(super) thinks: Span,
    /// Presses these buttons of the keypad behind these telegrams.
    pub(super) buttons: &'h [(usize, Button)],
}

/// What came of it.
pub(super) struct Came {
    pub(super) outcome: Result<Outcome, Failure>,
    /// What was asked.
    pub(super) asked: Vec<Question>,
    /// What went out, and when.
    pub(super) sent: Vec<(Tick, Vec<u8>)>,
    /// Records and notes in their order.
    pub(super) story: Vec<Event>,
    /// The line as it was left.
    left: Option<Profibus>,
    bench: String,
}

/// What a telegram is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Said {
    /// Control word and setpoint of a cycle.
    Words(u16, u16),
    Clear,
    Unlock,
    Other,
}

/// The shaft as a telegram goes out, 0.01 Hz, and whether it is fed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Moment {
    pub(super) at: Tick,
    pub(super) said: Said,
    pub(super) shaft: i64,
    pub(super) is_fed: bool,
}

struct Somebody<'h> {
    hand: Hand<'h>,
    interrupt: Interrupt,
    asked: Rc<RefCell<Vec<Question>>>,
    clock: Rc<Cell<Tick>>,
}

impl Ask for Somebody<'_> {
    fn ask<'a>(&'a mut self, question: &'a Question) -> Reply<'a> {
        let place = self.asked.borrow().len();
        self.asked.borrow_mut().push(question.clone());
        if self.hand.presses_at == Some(place) {
            self.interrupt.press();
            return Box::pin(std::future::pending());
        }
        let answer = if self.hand.denies == Some(place) { Answer::No } else { Answer::Yes };
        let thinks = if place == 1 { self.hand.thinks } else { Span::ZERO };
        let (clock, until) = (self.clock.clone(), self.clock.get() + thinks);
        Box::pin(async move {
            while clock.get() < until {
                tokio::task::yield_now().await;
            }
            answer
        })
    }

    fn is_there(&self) -> bool {
        true
    }
}

fn arguments<A: Args>(line: &str) -> A {
    let words = ["verb"].into_iter().chain(line.split_whitespace());
    let matches = A::augment_args(Command::new("verb")).try_get_matches_from(words).unwrap();
    A::from_arg_matches(&matches).unwrap()
}

/// `{dir}/way.csv`, for `--profile`.
const WAY: &str = "0s, 5Hz\n1s, 15Hz\n2500ms, 8Hz\n";

/// Does it on a line of its own: `sollwert …` or `statemachine …`.
pub(super) fn does(line: &str, bench: &str, hand: Hand<'_>) -> Came {
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("line.toml");
    std::fs::write(&file, bench).unwrap();
    std::fs::write(directory.path().join("way.csv"), WAY).unwrap();
    let line = &line.replace("{dir}", &directory.path().display().to_string());
    let port = format!("sim:{}", file.display()).parse().unwrap();
    let flags = Globals { port: vec![port], verbose: 1, protocol: Some("dp".to_owned()), ..Globals::default() };
    let mut settings = Settings::resolve(&flags, &antrieb::args::Environment::default()).unwrap();
    settings.addresses = antrieb::args::Addresses::Named(vec![3]);
    settings.drive = line.contains("--mode basic").then(|| "l200".to_owned());
    let interrupt = Interrupt::default();
    let (asked, clock) = (Rc::new(RefCell::new(Vec::new())), Rc::new(Cell::new(Tick::ZERO)));
    let mut ask = Somebody { hand, interrupt: interrupt.clone(), asked: asked.clone(), clock: clock.clone() };
    interrupt.panel().watch(["--view", "--dead-man"].iter().any(|option| line.contains(option)));
    let (signals, mut sent, mut story) = (interrupt.clone(), Vec::new(), Vec::new());
    let mut observe = |event: Event| {
        if matches!(event, Event::Record(_) | Event::Note(_)) {
            story.push(event);
        } else if let Event::Telegram { at_us, direction: '>', hex, .. } = event {
            let at = Tick::ZERO + Span::from_micros(at_us);
            clock.set(at);
            hand.presses.iter().filter(|press| **press == sent.len()).for_each(|_| signals.press());
            let now = hand.buttons.iter().filter(|(telegram, _)| *telegram == sent.len());
            now.for_each(|(_, button)| signals.button(*button, at));
            signals.look(at);
            sent.push((at, hex.split(' ').map(|byte| u8::from_str_radix(byte, 16).unwrap()).collect()));
        }
    };
    let mut context = Context {
        settings: &settings,
        registry: registry(),
        ask: &mut ask,
        observe: &mut observe,
        interrupt,
        sheet: antrieb::render::sheet,
        calls: None,
    };
    witness::call(true);
    witness::time_passes(true);
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let (verb, rest) = line.split_once(' ').unwrap();
    let outcome = runtime.block_on(async {
        match verb {
            "sollwert" if rest.starts_with("--") => sollwert::run(&arguments(rest), &mut context).await,
            // The program itself knows a setpoint below zero from an option.
            "sollwert" => {
                let (value, options) = rest.split_once(' ').unwrap_or((rest, ""));
                sollwert::run(&arguments(&format!("{options} -- {value}")), &mut context).await
            }
            _ => statemachine::run(&arguments(rest), &mut context).await,
        }
    });
    witness::time_passes(false);
    let left = witness::left_profibus();
    Came { outcome, asked: asked.take(), sent, story, left, bench: bench.to_owned() }
}

/// A run whose port is lost, at every ninth telegram and around `word`, which starts the motor: no shaft is left turning, and that one may
/// be is said.
pub(super) fn no_lost_port_leaves_a_shaft_turning(run: impl Fn() -> Came, word: u16) {
    let whole = run();
    let (start, all) = (whole.first(word), whole.sent.len());
    let moments = whole.moments();
    let dark = start + moments[start..].iter().rposition(|moment| moment.is_fed).unwrap();
    for telegrams in (0..all).step_by(9).chain(start.saturating_sub(3)..start + 4) {
        witness::pull_after(Some(telegrams as u64));
        let came = run();
        witness::pull_after(None);
        assert_eq!(came.code().1, 3, "{telegrams}: {:?}", came.failure());
        assert_eq!(came.later(), [0, 0], "{telegrams}");
        let warned = came.failure().unwrap().told().en.starts_with("THE SHAFT MAY STILL TURN");
        assert!(warned || !(start + 1..dark).contains(&telegrams), "{telegrams} of {all}: {:?}", came.failure());
    }
}

/// A die of its own, the same every time.
pub(super) fn die(seed: u64) -> impl FnMut(usize) -> usize {
    let mut state = seed;
    move |sides| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize % sides
    }
}

impl Came {
    /// Why it failed, or was refused before anything was done.
    pub(super) fn failure(&self) -> Option<&Failure> {
        match &self.outcome {
            Ok(outcome) => outcome.failure.as_ref(),
            Err(failure) => Some(failure),
        }
    }

    /// Code of that, and how the program ends.
    pub(super) fn code(&self) -> (&str, u8) {
        self.failure().map_or(("", 0), |failure| (&*failure.code, failure.class.exit()))
    }

    /// What is told of the motor.
    #[track_caller]
    pub(super) fn motion(&self) -> &Motion {
        match self.outcome.as_ref().map(|outcome| &outcome.data) {
            Ok(Some(Data::Motion(motion))) => motion,
            _ => panic!("no motion: {:?}", self.failure()),
        }
    }

    #[track_caller]
    pub(super) fn stop(&self) -> &Stop {
        self.motion().stop.as_ref().unwrap()
    }

    /// Whether everything that was lent stands again.
    pub(super) fn is_given_back(&self) -> bool {
        self.motion().changed.iter().all(|change| change.restored)
    }

    /// Shafts that turn and modules that exchange data, ten minutes later.
    pub(super) fn later(&self) -> [u64; 2] {
        let Some(mut bus) = self.left.clone() else { return [0, 0] };
        bus.advance(Tick::ZERO + Span::from_secs(3_600));
        [bus.turning()[0], bus.counts()[3]]
    }

    /// What a judge had to say.
    pub(super) fn remarks(&self) -> Vec<String> {
        self.left.as_ref().map(|bus| bus.remarks().to_vec()).unwrap_or_default()
    }

    /// The shaft at every telegram.
    pub(super) fn moments(&self) -> Vec<Moment> {
        let mut bus = again(&self.bench);
        let say = |(at, bytes): &(Tick, Vec<u8>)| {
            bus.advance(*at);
            let (shaft, [_, fed]) = (bus.shaft(3).unwrap(), bus.turning());
            puts(&mut bus, *at, bytes);
            Moment { at: *at, said: said(bytes), shaft, is_fed: fed != 0 }
        };
        self.sent.iter().map(say).collect()
    }

    /// The shaft an hour after this program was killed, before each telegram that it would have said.
    pub(super) fn killed(&self) -> Vec<i64> {
        let mut bus = again(&self.bench);
        let die = |(at, bytes): &(Tick, Vec<u8>)| {
            let mut alone = bus.clone();
            alone.advance(Tick::ZERO + Span::from_secs(3_600));
            bus.advance(*at);
            puts(&mut bus, *at, bytes);
            alone.shaft(3).unwrap()
        };
        self.sent.iter().map(die).collect()
    }

    /// Words one behind the other, each once.
    pub(super) fn words(&self) -> Vec<u16> {
        let all = self.sent.iter().filter_map(|(_, bytes)| match said(bytes) {
            Said::Words(stw, _) => Some(stw),
            _ => None,
        });
        let mut words: Vec<u16> = all.collect();
        words.dedup();
        words
    }

    /// The first telegram with this control word.
    pub(super) fn first(&self, stw: u16) -> usize {
        let is_it = |(_, bytes): &(Tick, Vec<u8>)| matches!(said(bytes), Said::Words(word, _) if word == stw);
        self.sent.iter().position(is_it).unwrap()
    }

    /// Whether the Basic block was spoken.
    pub(super) fn is_basic(&self) -> bool {
        let is_block = |(_, bytes): &(Tick, Vec<u8>)| {
            matches!(Telegram::decode(bytes), Ok(Telegram::Frame(frame))
                if Service::of(&frame) == Service::DataExchange && frame.data.len() == BLOCK)
        };
        self.sent.iter().any(is_block)
    }

    /// What holds of every end: no start without 0406 (Basic mode: 0050) before it, no zero outputs, Clear and Unlock while the motor is fed, nor while the
    /// shaft turns of which is told that it stands; nobody is kept, and nothing turns afterwards.
    #[track_caller]
    pub(super) fn holds(&self, what: &str) {
        let stands = matches!(&self.outcome, Ok(Outcome { data: Some(Data::Motion(motion)), .. }) if motion.standing == Some(true));
        let (mut before, mut prepared) = (0, 0);
        let (starts, ready, most) = if self.is_basic() { (3, 0x0050, 40_000) } else { (1, 0x0406, 0x4000) };
        for Moment { at, said, shaft, is_fed } in self.moments() {
            let mut is_new = true;
            if let Said::Words(stw, hsw) = said {
                is_new = stw != before;
                if is_new {
                    (prepared, before) = (before, stw);
                }
                assert!(stw & starts == 0 || prepared == ready, "{what}: {stw:04X} behind {prepared:04X} at {at:?}");
                assert!(hsw <= most, "{what}: {hsw:04X}");
            }
            // Whoever starts it behind the first outputs of zero is seen by the next.
            if is_new && matches!(said, Said::Words(0, _) | Said::Clear | Said::Unlock) {
                assert!(!is_fed && (shaft == 0 || !stands), "{what}: {said:?} at {at:?}, shaft {shaft}");
            }
        }
        assert_eq!(self.later(), [0, 0], "{what}");
    }
}

fn again(bench: &str) -> Profibus {
    Profibus::from_toml("line.toml", bench, registry()).unwrap()
}

/// What is said again goes out as it did: later, or not at all, where the port took no bytes.
fn puts(bus: &mut Profibus, at: Tick, bytes: &[u8]) {
    let (line, free) = (bus.line(), bus.stuck_until().max(at));
    if free.since(at) <= Span::from_millis(500) {
        bus.master_sends(free, line, bytes);
    }
}

/// Read once a thread.
fn registry() -> &'static Registry {
    thread_local! {
        static REGISTRY: &'static Registry = Box::leak(Box::new(Registry::open(&[]).unwrap()));
    }
    REGISTRY.with(|registry| *registry)
}

/// Bytes of the Basic block.
const BLOCK: usize = 8;

/// What a telegram of the master is.
fn said(bytes: &[u8]) -> Said {
    let Ok(Telegram::Frame(frame)) = Telegram::decode(bytes) else { return Said::Other };
    match Service::of(&frame) {
        Service::DataExchange => match *frame.data.as_slice() {
            [a, b, c, d, ..] if frame.data.len() == BLOCK => {
                Said::Words(u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d]))
            }
            [.., a, b, c, d] => Said::Words(u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d])),
            _ => Said::Other,
        },
        Service::GlobalControl => Said::Clear,
        Service::SetPrm if Parameters::decode(&frame.data).is_some_and(|said| said.status & 0x40 != 0) => Said::Unlock,
        _ => Said::Other,
    }
}
