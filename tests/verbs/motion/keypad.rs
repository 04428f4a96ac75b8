//! The keypad of a held run, in virtual time: whatever is pressed, in whatever order, no shaft is left turning; and what is
//! shown of a run costs it nothing.

use crate::agreeable::Agreeable;
use crate::run::antrieb;
use antrieb::args::{Environment, Globals, Settings, below_zero};
use antrieb::command::{Context, VERBS, monitor, sollwert};
use antrieb::drive::{Button, Interrupt};
use antrieb::failure::Failure;
use antrieb::outcome::{Data, Event, Motion, Outcome, Record, RunNews, Sample};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::{Span, Tick};
use antrieb::transport::witness;
use clap::{CommandFactory, Parser};
use serde_json::Value;

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
    Monitor(monitor::Args),
}

const ACTIVE: &str = "set = { \"412\" = 1, \"434\" = 2, \"418\" = 0 }";
const SERVO: &str = "set = { RAMPacc = 3000, RAMPdecel = 3000, RAMPn_max = 3000 }\nservo = { guide = 16384 }";
/// A drive, how its bench is set, and a run of it with bounds for the arrows.
pub(super) const DRIVES: [(&str, &str, &str); 3] = [
    ("act", ACTIVE, "sollwert 10Hz --enable --hold --step 1Hz --min -3Hz --max 15Hz"),
    ("acu", ACTIVE, "sollwert -10Hz --enable --hold --step 2.5Hz --min -12Hz --max 5Hz"),
    ("lxm05", SERVO, "sollwert 300rpm --mode velocity --enable --hold --step 50rpm --min -100rpm --max 400rpm"),
];

/// What came of a run.
pub(super) struct Seen {
    motion: Option<Motion>,
    pub(super) failure: Option<Failure>,
    bench: Bench,
    pub(super) at: Tick,
    pub(super) news: Vec<RunNews>,
    /// Parameters that are shown.
    pub(super) columns: Vec<u32>,
    pub(super) samples: Vec<Sample>,
    pub(super) notes: Vec<String>,
    /// Records and notes in their order.
    pub(super) story: Vec<Event>,
    /// Telegrams that went out: when, and in hex.
    pub(super) sent: Vec<(Tick, String)>,
    /// When the records began.
    pub(super) begun: Option<Tick>,
}

/// Runs a line; `press` is called at every telegram, with its number and its time.
pub(super) fn run(
    (model, keys, line): (&str, &str, &str),
    more: &str,
    press: &mut dyn FnMut(usize, Tick, &Interrupt),
) -> Seen {
    let registry = Registry::open(&[]).unwrap();
    let directory = tempfile::tempdir().unwrap();
    let file = directory.path().join("bench.toml");
    std::fs::write(&file, format!("[[drive]]\nmodel = \"{model}\"\n{keys}\n")).unwrap();
    let line = format!("antrieb -p sim:{} --drive {model} -a 1 --yes {line} {more}", file.display());
    let words: Vec<_> = line.split_whitespace().map(Into::into).collect();
    let cli = Cli::parse_from(below_zero::shielded(&words, &Cli::command()));
    let environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
    let settings = Settings { verbose: true, ..Settings::resolve(&cli.globals, &environment).unwrap() };
    let interrupt = Interrupt::default();
    interrupt.panel().watch(true);
    let hand = interrupt.clone();
    let (mut telegrams, mut last, mut begun, mut columns) = (0, Tick::ZERO, None, Vec::new());
    let (mut news, mut samples, mut notes, mut sent) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut story = Vec::new();
    let mut observe = |event: Event| {
        if matches!(event, Event::Record(_) | Event::Note(_)) {
            story.push(event.clone());
        }
        match event {
            Event::Telegram { at_us, direction, hex, .. } => {
                (telegrams, last) = (telegrams + 1, Tick::from_micros(at_us));
                sent.extend((direction == '>').then_some((last, hex)));
                hand.look(last);
                press(telegrams, last, &hand);
            }
            Event::Record(record) => match *record {
                Record::Run(run) => {
                    if run.phase == "waiting" {
                        hand.button(Button::Hold, last);
                    }
                    news.push(run);
                }
                Record::Start(start) => {
                    begun = Some(last);
                    columns = start.drives.iter().flat_map(|drive| &drive.columns).map(|column| column.param).collect();
                }
                Record::Sample(sample) => samples.push(sample),
                _ => {}
            },
            Event::Note(note) => notes.push(note.en.into_owned()),
            _ => {}
        }
    };
    witness::call(true);
    let mut ask = Agreeable;
    let mut context = Context {
        settings: &settings,
        registry: &registry,
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
            Verb::Monitor(args) => monitor::run(args, &mut context).await,
        }
    });
    let (motion, failure) = match result {
        Ok(Outcome { data: Some(Data::Motion(motion)), failure, .. }) => (Some(motion), failure),
        Ok(outcome) => (None, outcome.failure),
        Err(failure) => (None, Some(failure)),
    };
    let (bench, at) = witness::left().unwrap();
    Seen { motion, failure, bench, at, news, columns, samples, notes, story, sent, begun }
}

impl Seen {
    pub(super) fn stop(&self) -> (&str, Option<u8>, Option<&str>) {
        let stop = self.motion.as_ref().and_then(|motion| motion.stop.as_ref()).unwrap();
        (stop.because, self.failure.as_ref().map(|failure| failure.class.exit()), stop.escalated)
    }

    fn setpoint(&self) -> i64 {
        self.motion.as_ref().unwrap().setpoint.as_ref().unwrap().value.raw
    }

    fn turning(&self) -> u64 {
        self.bench.totals().turning
    }
}

/// Numbers that are the same in every run.
struct Dice(u64);

impl Dice {
    fn below(&mut self, most: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % most
    }
}

/// From here on somebody wants to go home.
const LATE: usize = 180;

#[test]
fn no_shaft_is_left_turning_whatever_is_pressed() {
    let mut ends = std::collections::BTreeMap::<String, usize>::new();
    for seed in 0..500u64 {
        let mut dice = Dice(seed);
        let drive = DRIVES[(seed % 3) as usize];
        let more = match (seed % 2 == 1, seed % 5) {
            (true, 0) => "--dead-man --duration 2s",
            (true, _) => "--dead-man",
            (false, 0) => "--view --duration 2s",
            (false, 1) => "--view --watchdog 1s",
            (false, _) => "--view",
        };
        // From then on keys are pressed, and from then on, perhaps, the dead man lets go of all of them.
        let (begin, tired) = (dice.below(60) as usize, dice.below(200) as usize);
        let seen = run(drive, more, &mut |telegram, at, hand| match dice.below(400) {
            _ if telegram < begin => hand.button(Button::Hold, at),
            // Whoever only stopped still looks.
            _ if telegram > 3 * LATE => hand.button(Button::End, at),
            _ if telegram > tired && more.contains("dead") => {}
            _ if telegram > LATE => hand.button(Button::End, at),
            0 => hand.button(Button::Stop, at),
            1 => hand.button(Button::End, at),
            2 => hand.press(),
            3 => hand.raise(),
            4 => (0..200).for_each(|_| hand.button(Button::More, at)),
            5 => (0..200).for_each(|_| hand.button(Button::Less, at)),
            6..20 => hand.button(Button::More, at),
            20..34 => hand.button(Button::Less, at),
            _ => hand.button(Button::Hold, at),
        });
        let mut later = seen.bench.clone();
        later.advance(seen.at + Span::from_secs(12));
        assert_eq!(later.totals().turning, 0, "seed {seed}: {:?} {:?}", seen.motion, seen.failure);
        let Some(motion) = &seen.motion else { continue };
        let stop = motion.stop.as_ref();
        let proven = stop.is_some_and(|stop| stop.acknowledged && stop.standing == Some(true));
        assert!(seen.failure.is_some() || proven, "seed {seed}: 0 without a proven stop");
        assert!(!(proven && seen.turning() > 0), "seed {seed}: said to stand");
        for news in &seen.news {
            let (setpoint, keys) = (news.setpoint.map(|setpoint| setpoint.raw), news.keys.as_ref().unwrap());
            let agreed = keys.min.raw..=keys.max.raw;
            assert!(
                setpoint.is_none_or(|setpoint| setpoint == 0 || agreed.contains(&setpoint)),
                "seed {seed}: {news:?}"
            );
        }
        *ends.entry(stop.map_or("none", |stop| stop.because).to_owned()).or_default() += 1;
    }
    // The trial has tried all of them.
    let all: Vec<&str> = ends.keys().map(String::as_str).filter(|end| *end != "none").collect();
    assert_eq!(all, ["dead-man", "end", "interrupted", "key"], "{ends:?}");
}

#[test]
fn arrows_change_the_setpoint_by_steps_and_stop_at_what_was_agreed() {
    let [act, _, servo] = DRIVES;
    for (drive, button, times, expected) in [
        (act, Button::More, 3, 1_300),
        (act, Button::More, 30, 1_500),
        (act, Button::Less, 5, 500),
        (act, Button::Less, 50, -300),
        (servo, Button::More, 9, 400),
        (servo, Button::Less, 2, 200),
    ] {
        let seen = run(drive, "--view", &mut |telegram, at, hand| match telegram {
            // Held long before.
            120 => (0..times).for_each(|_| hand.button(button, at)),
            200.. => hand.button(Button::End, at),
            _ => {}
        });
        assert_eq!((seen.setpoint(), seen.turning()), (expected, 0), "{} {button:?} {times}", drive.0);
        assert_eq!(seen.stop(), ("key", None, None), "{:?}", seen.failure);
        let refused = seen.notes.iter().any(|note| note.starts_with("agreed are "));
        assert_eq!(refused, times > 6, "{:?}", seen.notes);
    }
}

/// Whichever answer is lost, a step is given and shown: a line that loses one is no reason to press again.
#[test]
fn a_step_whose_answer_is_lost_is_given_and_shown_all_the_same() {
    for (model, keys, line) in DRIVES {
        for nth in 4..12 {
            for kind in ["lost", "garbled"] {
                let keys = format!("{keys}\n[[disturb]]\nevery = {nth}\nkind = \"{kind}\"");
                let seen = run((model, &keys, line), "--view", &mut |telegram, at, hand| match telegram {
                    300 => hand.button(Button::More, at),
                    500.. => hand.button(Button::End, at),
                    _ => {}
                });
                let name = format!("{model}, every {nth}. answer {kind}");
                let steps: Vec<_> = seen
                    .news
                    .iter()
                    .filter(|news| news.phase == "held")
                    .map(|news| news.setpoint.unwrap().raw)
                    .collect();
                let Some(&from) = steps.first() else { panic!("{name}: {:?}", seen.failure) };
                let to = seen.setpoint();
                let step = seen.news.iter().find_map(|news| news.keys.as_ref()).unwrap().step.raw;
                assert_eq!((to, steps.last()), (from + step, Some(&to)), "{name}: {steps:?} {:?}", seen.failure);
                assert_eq!(seen.turning(), 0, "{name}");
            }
        }
    }
}

/// Whatever a mistake of ours breaks while the view is on, the run ends as any other: by its stop, and the view is closed.
#[test]
fn a_panic_while_the_view_is_on_stops_the_shaft_and_is_told() {
    for drive in DRIVES {
        for broken in [100, 120, 151, 200] {
            let mut is_broken = false;
            let seen = run(drive, "--view", &mut |telegram, at, hand| match telegram {
                _ if telegram >= broken && !is_broken => {
                    is_broken = true;
                    std::panic::resume_unwind(Box::new("a mistake of ours"));
                }
                // Behind the stop nobody looks any more.
                600.. => hand.button(Button::End, at),
                _ => {}
            });
            let failure = seen.failure.as_ref().unwrap();
            assert_eq!((failure.code.as_str(), failure.class.exit()), ("bug.panic", 70), "{} {broken}", drive.0);
            assert_eq!((seen.stop().0, seen.turning()), ("error", 0), "{} {broken}", drive.0);
            assert_eq!(seen.news.last().map(|news| news.phase), Some("ended"), "{} {broken}", drive.0);
        }
    }
}

/// Its key, pressed anew or held on, starts nothing, nor does it close the view: it would go to the shell.
#[test]
fn who_lets_go_is_obeyed_at_once_and_a_later_key_starts_nothing_and_leaves_the_view_open() {
    for drive in DRIVES {
        let (mut ended, mut let_go) = (0, Tick::ZERO);
        let seen = run(drive, "--dead-man", &mut |telegram, at, hand| match telegram {
            ..150 => {
                hand.button(Button::Hold, at);
                let_go = at;
            }
            // The stop is under way.
            170..600 => hand.button(Button::Hold, at),
            // Long over, and nobody has pressed anything for a while.
            _ if at.since(let_go) > Span::from_secs(90) && telegram > 600 => {
                ended = telegram;
                hand.button(Button::End, at);
            }
            _ => {}
        });
        assert_eq!((seen.stop(), seen.turning()), (("dead-man", None, None), 0), "{}: {:?}", drive.0, seen.failure);
        let phases: Vec<&str> = seen.news.iter().map(|news| news.phase).collect();
        assert_eq!(phases.iter().filter(|phase| **phase == "held").count(), 1, "{phases:?}");
        assert!(ended > 600 && phases.last() == Some(&"ended"), "{}: {phases:?}", drive.0);
    }
}

#[test]
fn a_space_leaves_the_view_open_and_q_closes_it() {
    let mut ended = 0;
    let seen = run(DRIVES[0], "--view", &mut |telegram, at, hand| match telegram {
        120 => hand.button(Button::Stop, at),
        // The stop takes less.
        600.. => {
            ended = telegram;
            hand.button(Button::End, at);
        }
        _ => {}
    });
    assert_eq!((seen.stop(), ended >= 600, seen.turning()), (("key", None, None), true, 0), "{:?}", seen.failure);
    assert_eq!(seen.news.last().map(|news| news.phase), Some("ended"));
    assert!(seen.notes.iter().any(|note| note == "the stop was acknowledged, the shaft stands"), "{:?}", seen.notes);
}

/// A stop that is not obeyed is told where somebody looks, with what stops the shaft now, and not only behind his key.
#[test]
fn a_stop_that_is_not_obeyed_is_told_in_the_view_that_stays() {
    let deaf = ["ignores = 410", "ignores = 6938\nrefuses = 6914"];
    for (model, keys, line) in DRIVES {
        for more in ["--view", "--dead-man"] {
            let deaf = deaf[usize::from(model == "lxm05")];
            let keys = format!("{keys}\n[[drive.event]]\nat = \"3s\"\n{deaf}");
            let (mut left, mut let_go) = (None, None);
            let seen = run((model, &keys, line), more, &mut |_, at, hand| match at.since(Tick::ZERO).as_millis() {
                ..4_000 => hand.button(Button::Hold, at),
                _ if let_go.is_none() => {
                    let_go = Some(at);
                    if more == "--view" {
                        hand.button(Button::Stop, at);
                    }
                }
                90_000.. if left.is_none() => {
                    left = Some(at);
                    hand.button(Button::End, at);
                }
                _ => {}
            });
            let what = format!("{model} {more}: {:?} {:?}", seen.failure, seen.notes);
            assert!(left.is_some() && seen.failure.as_ref().is_some_and(|failure| failure.alarm), "{what}");
            let is_end = |event: &Event| matches!(event, Event::Record(record) if matches!(&**record, Record::Run(news) if news.phase == "ended"));
            let end = seen.story.iter().position(is_end).unwrap_or_else(|| panic!("{what}"));
            let told = seen.story[end..]
                .iter()
                .find_map(|event| if let Event::Note(note) = event { Some(note.en.clone()) } else { None });
            let told = told.unwrap_or_else(|| panic!("{what}"));
            assert!(told.starts_with("THE SHAFT MAY STILL TURN: ") && told.contains("what stops it now: "), "{what}");
        }
    }
}

/// Who has asked for the strongest stop at once has seen nothing of it yet: that it is not obeyed is told while it is said again, and
/// what the drive may still obey goes out.
#[test]
fn three_interrupts_that_nothing_obeys_are_told_soon() {
    for (model, keys, line) in DRIVES {
        let servo = model == "lxm05";
        let deaf = if servo { "ignores = 6938\nrefuses = 6914" } else { "ignores = 410" };
        let keys = format!("{keys}\n[[drive.event]]\nat = \"3s\"\n{deaf}");
        let (mut pressed, mut last) = (0, Tick::ZERO);
        let seen = run((model, &keys, line), "--view", &mut |_, at, hand| {
            if pressed < 3 && at.since(Tick::ZERO).as_millis() >= 4_000 + 300 * pressed {
                (pressed, last) = (pressed + 1, at);
                hand.press();
            }
        });
        let what = format!("{model}: {:?} {:?}", seen.failure, seen.notes);
        let is_alarm = |event: &Event| matches!(event, Event::Note(note) if note.en.contains("coast is not obeyed"));
        let told = seen.story.iter().position(is_alarm).unwrap_or_else(|| panic!("{what}"));
        let Event::Note(note) = &seen.story[told] else { unreachable!() };
        assert!(note.en.starts_with("THE SHAFT MAY STILL TURN: ") && note.en.contains("what stops it now: "), "{what}");
        let time = |event: &Event| match event {
            Event::Record(record) => {
                if let Record::Sample(sample) = &**record {
                    Some(sample.t.raw)
                } else {
                    None
                }
            }
            _ => None,
        };
        let at = seen.story[..told].iter().filter_map(time).max().unwrap();
        let late = at + seen.begun.unwrap().since(Tick::ZERO).as_micros() as i64 - last.as_micros() as i64;
        assert!(late < 4_000_000, "{late} us: {what}");
        if !servo {
            let zero = seen.sent.iter().find(|(at, hex)| *at > last && hex.starts_with("01 65 01 E4 00 00 00 00"));
            assert!(zero.is_some_and(|(at, _)| at.since(last) < Span::from_secs(4)), "{what}");
            assert_eq!(seen.bench.totals().turning, 0, "{what}");
        }
    }
}

/// What stops it has taken its setpoint's place: nothing shows the one of the run any more.
#[test]
fn no_setpoint_is_shown_of_a_run_that_stops() {
    for drive in DRIVES {
        let seen = run(drive, "--view", &mut |telegram, at, hand| match telegram {
            150 => hand.button(Button::Stop, at),
            400.. => hand.button(Button::End, at),
            _ => {}
        });
        let told = |phase: &str| seen.news.iter().find(|news| news.phase == phase).map(|news| news.t.raw).unwrap();
        let (from, to) = (told("stopping"), told("ended"));
        let shows = |sample: &&Sample| sample.values.iter().any(|row| [282, 283, 484, 6938].contains(&row.value.param));
        let during = seen.samples.iter().filter(|sample| (from..to).contains(&sample.t.raw));
        assert_eq!(during.clone().filter(shows).count(), 0, "{}", drive.0);
        assert!(during.count() > 0 && seen.samples.iter().any(|sample| shows(&sample)), "{}", drive.0);
    }
}

#[test]
fn only_ctrl_c_asks_for_a_harder_stop() {
    let seen = run(DRIVES[0], "--view", &mut |telegram, at, hand| {
        if telegram >= 120 {
            [Button::Stop, Button::End, Button::Stop].into_iter().for_each(|button| hand.button(button, at));
        }
    });
    assert_eq!(seen.stop(), ("key", None, None), "who leans on the key gets the ramp");
    let seen = run(DRIVES[0], "--view", &mut |telegram, at, hand| match telegram {
        120 => hand.button(Button::End, at),
        130 => hand.press(),
        _ => {}
    });
    assert_eq!(seen.stop(), ("interrupted", Some(130), Some("quick-stop")));
}

#[test]
fn who_lets_go_while_it_stops_anyway_asks_for_nothing_harder() {
    let end = Tick::ZERO + Span::from_millis(2_800);
    let seen = run(DRIVES[0], "--dead-man --duration 2s", &mut |_, at, hand| {
        hand.look(at);
        if at < end {
            hand.button(Button::Hold, at);
        }
    });
    assert!(
        seen.at > end + Span::from_millis(500),
        "it was let go while the shaft became slower: {}",
        seen.at.since(end)
    );
    assert_eq!((seen.stop(), seen.turning()), (("end", None, None), 0), "{:?}", seen.failure);
}

#[test]
fn what_is_shown_starves_no_watchdog_on_a_line_that_stutters() {
    let late = "[[disturb]]\nevery = 4\nkind = \"late\"\nby = \"400ms\"";
    for (model, keys, line) in DRIVES {
        let keys = format!("{keys}\n{late}");
        let more = "--view --watchdog 2s --duration 20s";
        let seen = run((model, &keys, line), more, &mut |_, _, _| {});
        assert_eq!((seen.stop(), seen.turning()), (("end", None, None), 0), "{model}: {:?}", seen.failure);
    }
}

#[test]
fn records_of_a_run_fit_their_schema_and_come_before_its_document() {
    let bench = format!("[[drive]]\nmodel = \"acu\"\n{ACTIVE}\n");
    for (verb, line) in [
        ("sollwert", "-a 1 --yes sollwert 5Hz --enable --hold --duration 900ms"),
        ("sollwert", "-a 1 --yes sollwert --ramp 0Hz:5Hz:600ms --enable --hold --duration 300ms"),
        ("sollwert", "-a 1 --yes sollwert 5Hz --jog 600ms"),
        ("statemachine", "-a 1 --yes statemachine enable --hold --duration 600ms"),
        ("statemachine", "-a 1 --yes statemachine goto operation-enabled --hold --duration 600ms"),
    ] {
        let out = antrieb(&format!("{line} --format ndjson")).on(&bench).exits(0).out;
        let mut records: Vec<Value> = out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
        // What stood there before records came.
        let (end, row) = (records.pop().unwrap(), records.pop().unwrap());
        assert_eq!((&end["type"], &end["ok"], &row["stop"]["choice"]), (&"end".into(), &true.into(), &"ramp".into()));
        let entry = VERBS.iter().find(|entry| entry.name == verb).unwrap();
        let validator = jsonschema::validator_for(&(entry.schema)()).unwrap();
        for record in &records {
            assert!(validator.is_valid(record), "{record:#}");
        }
        let of = |tag: &str| records.iter().filter(|record| record["type"] == tag).collect::<Vec<_>>();
        assert_eq!((of("start").len(), records.first().map(|record| &record["type"])), (1, Some(&"start".into())));
        assert!(of("sample").iter().any(|sample| sample["state"]["slug"] == "operation-enabled"), "{records:#?}");
        let phases: Vec<_> = of("run").iter().map(|run| run["phase"].as_str().unwrap().to_owned()).collect();
        let mut parts = phases.clone();
        parts.dedup();
        let led = if line.contains("--ramp") {
            &["starting", "led", "held", "stopping"][..]
        } else {
            &["starting", "held", "stopping"]
        };
        assert_eq!(parts.iter().filter(|phase| *phase != "waiting").collect::<Vec<_>>(), led, "{line}");
    }
}

#[test]
fn without_a_terminal_a_view_is_refused_before_anything_is_sent() {
    let bench = format!("[[drive]]\nmodel = \"acu\"\n{ACTIVE}\n");
    for (line, exit, text) in [
        ("sollwert 5Hz --enable --hold --view", 8, "--view needs a terminal"),
        ("sollwert 5Hz --jog 1s --dead-man", 8, "--dead-man needs a terminal"),
        ("statemachine enable --hold --view", 8, "--view needs a terminal"),
        ("statemachine enable --view", 2, "add --hold"),
        ("statemachine enable --hold --view --on-exit keep", 2, "--on-exit keep stops nothing"),
        ("sollwert 5Hz --enable --hold --step 1A", 2, "--step"),
        ("sollwert 5Hz --enable --hold --step 0Hz", 2, "more than 0"),
        ("sollwert 5Hz --enable --hold --step 1Hz --max 4Hz", 2, "between --min and --max"),
        ("sollwert 5Hz --enable --hold --step 60rpm", 2, "the unit of the setpoint"),
        ("sollwert 5Hz --enable --hold --max 9Hz", 2, "--step"),
        ("sollwert 5Hz --enable --hold --step 1Hz", 2, "nothing would read a key"),
    ] {
        for lang in ["en", "de"] {
            let output = antrieb(&format!("-v -a 1 --yes --lang {lang} {line}")).on(&bench).exits(exit);
            assert!(!output.err.contains(" > "), "{line}: {}", output.err);
            assert!(lang == "de" || output.err.contains(text), "{line}: {}", output.err);
        }
    }
}

#[test]
fn bounds_are_held_against_the_drive_like_a_setpoint_that_is_typed() {
    let line = "sollwert 5Hz --enable --hold --duration 300ms --step 1Hz --view";
    let ends = |keys: &str, more: &str| {
        let seen = run(("acu", keys, line), more, &mut |_, _, _| {});
        let (exit, said) = seen.failure.map_or((0, String::new()), |failure| {
            let hint = failure.hint.map_or_else(String::new, |hint| hint.en.clone().into_owned());
            (failure.class.exit(), format!("{} {hint}", failure.message.en))
        });
        (exit, said, seen.news)
    };
    let (exit, said, _) = ends(ACTIVE, "--max 900Hz");
    assert!(exit == 7 && said.contains("P.419"), "{exit} {said}");
    // What the drive adds would move the bounds: a step up could turn the shaft the other way.
    let adding = ACTIVE.replace("\"434\" = 2", "\"434\" = 3, \"228\" = -10");
    assert_ne!(adding, ACTIVE);
    let (exit, said, _) = ends(&adding, "--max 9Hz");
    assert!(exit == 7 && said.contains("the drive adds -10.00 Hz") && said.contains("--source line"), "{exit} {said}");
    assert_eq!(ends(&adding, "--max 9Hz --source line").0, 0);
    let (exit, said, news) = ends(ACTIVE, "--max 9Hz");
    let keys = news[0].keys.as_ref().unwrap();
    assert_eq!((exit, keys.step.raw, keys.min.raw, keys.max.raw), (0, 100, 0, 900), "{said}");
}
