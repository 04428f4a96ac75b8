//! A run of `dataset` or `apply` in virtual time, and how it is brought to its end.
//!
//! Ctrl-C and SIGTERM are one wish to end here; a kill -9 is a program that is gone between two telegrams.

use crate::agreeable::Agreeable;
use antrieb::args::{Environment, Globals, Settings, settings_of_plant};
use antrieb::command::{Context, VERBS};
use antrieb::drive::Interrupt;
use antrieb::failure::Failure;
use antrieb::outcome::{Data, Event, Load, Outcome};
use antrieb::profile::Registry;
use antrieb::simulator::Bench;
use antrieb::tick::Tick;
use antrieb::transport::witness;
use clap::{Args, FromArgMatches};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::path::Path;

/// A drive, and how it is reached.
#[derive(Clone, Copy)]
pub(super) struct Case {
    pub(super) model: &'static str,
    pub(super) keys: &'static str,
    pub(super) options: &'static str,
    pub(super) ram: bool,
}

/// How a load is brought to its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// By itself.
    Whole,
    /// Ctrl-C, SIGTERM.
    Wish,
    /// That, and once more a few telegrams later.
    Twice,
    /// The adapter is pulled.
    Pulled,
    /// The drive loses its power for a moment.
    Power,
    /// The line is dead for so long, ms.
    Silent(u64),
    /// The drive refuses one of the values from then on.
    Refuses,
    /// kill -9.
    Killed,
}

/// What came of a run.
pub(super) struct Seen {
    pub(super) telegrams: usize,
    pub(super) sent: usize,
    pub(super) load: Option<Load>,
    pub(super) failure: Option<Failure>,
    pub(super) warnings: String,
    pub(super) killed: bool,
    pub(super) bench: Bench,
    pub(super) at: Tick,
}

impl Case {
    pub(super) fn bench(&self, end: End, step: usize, victim: (u32, u8)) -> String {
        let event = |what: &str| format!("[[drive.event]]\nafter_telegrams = {step}\n{what}\n");
        let ram = u32::from(self.ram) * 5;
        let place = match self.model {
            "lxm05" => victim.0,
            _ => (u32::from(victim.1.max(1)) + ram) << 12 | victim.0,
        };
        let event = match end {
            End::Power => event("power_cycle = true"),
            End::Silent(ms) => event(&format!("silent = \"{ms}ms\"")),
            End::Refuses => event(&format!("refuses = {place}")),
            _ => String::new(),
        };
        format!("[[drive]]\nmodel = \"{}\"\n{}\n{event}", self.model, self.keys)
    }

    /// Runs what is typed behind `dataset`.
    pub(super) fn run(&self, registry: &Registry, dir: &Path, words: &str, end: End, step: usize) -> Seen {
        let line = format!(
            "-p sim:{0}/bench.toml --drive {1} -a 1 --yes {2} dataset {words}",
            dir.display(),
            self.model,
            self.options
        );
        let Ended { telegrams, sent, killed, outcome } = brought_to_end(dir, &line, registry, end, step);
        let warnings = outcome.warnings.iter().map(|warning| warning.message.en.to_string()).collect();
        let load = match outcome.data {
            Some(Data::Load(load)) => Some(load),
            _ => None,
        };
        let (bench, at) = witness::left().unwrap_or_else(|| panic!("{words}: {:?}", outcome.failure));
        Seen { telegrams, sent, load, failure: outcome.failure, warnings, killed, bench, at }
    }
}

/// What came of a command line; of one that was killed nothing.
pub(super) struct Ended {
    pub(super) telegrams: usize,
    pub(super) sent: usize,
    pub(super) killed: bool,
    pub(super) outcome: Outcome,
}

/// Runs a command line, in which `{dir}` is this directory, to this end at this telegram. What a drive does stands in its bench.
pub(super) fn brought_to_end(dir: &Path, line: &str, registry: &Registry, end: End, step: usize) -> Ended {
    let line = line.replace("{dir}", &dir.display().to_string());
    let tree = Globals::augment_args(clap::Command::new("antrieb"));
    let tree = tree.subcommands(VERBS.iter().map(|verb| (verb.command)()));
    let matches = tree.get_matches_from(["antrieb"].into_iter().chain(line.split_whitespace()));
    let (name, own) = matches.subcommand().unwrap();
    let entry = VERBS.iter().find(|verb| verb.name == name).unwrap();
    let (verb, globals) = ((entry.typed)(own).unwrap(), Globals::from_arg_matches(&matches).unwrap());
    let environment = Environment { directory: dir.to_owned(), ..Environment::default() };
    let resolve = if entry.of_plant { settings_of_plant } else { Settings::resolve };
    let settings = Settings { verbose: true, ..resolve(&globals, &environment).unwrap() };
    let (interrupt, mut telegrams, mut sent) = (Interrupt::default(), 0, 0);
    let wish = interrupt.clone();
    let mut observe = |event: Event| {
        if let Event::Telegram { direction, .. } = event {
            telegrams += 1;
            sent += usize::from(direction == '>');
            match end {
                End::Wish | End::Twice if telegrams == step => wish.press(),
                End::Twice if telegrams == step + 5 => wish.press(),
                End::Killed if telegrams == step => resume_unwind(Box::new("kill -9")),
                _ => {}
            }
        }
    };
    witness::call(true);
    if end == End::Pulled {
        witness::pull_after(Some(step as u64 / 2));
    }
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
    let ended = catch_unwind(AssertUnwindSafe(|| runtime.block_on(verb.run(&mut context))));
    witness::pull_after(None);
    let killed = ended.is_err();
    let outcome = ended.unwrap_or_else(|_| Ok(Outcome::default())).unwrap_or_else(Outcome::from);
    Ended { telegrams, sent, killed, outcome }
}
