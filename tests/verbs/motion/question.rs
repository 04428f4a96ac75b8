//! At the question: whoever interrupts ends it at once, and what is typed afterwards does nothing.

use antrieb::args::{Addresses, Globals, Settings};
use antrieb::command::{Context, diag, line, sollwert, statemachine, write};
use antrieb::drive::Interrupt;
use antrieb::failure::Class;
use antrieb::gate::{Answer, Ask, Question, Reply};
use antrieb::outcome::{Event, Outcome};
use antrieb::profile::Registry;
use clap::{Args, Command};

/// Interrupts when asked, and then says yes, or nothing for ever.
struct Interrupting {
    interrupt: Interrupt,
    then: Option<Answer>,
    asked: bool,
}

impl Ask for Interrupting {
    fn ask<'a>(&'a mut self, _: &'a Question) -> Reply<'a> {
        self.asked = true;
        self.interrupt.press();
        match self.then {
            Some(answer) => Box::pin(async move { answer }),
            None => Box::pin(std::future::pending()),
        }
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

/// What came of a verb that was interrupted at its question, and whether anything was written.
fn interrupted(
    then: Option<Answer>,
    verb: impl AsyncFnOnce(&mut Context<'_>) -> Result<Outcome, antrieb::failure::Failure>,
) {
    let flags = Globals { port: vec!["sim".parse().unwrap()], verbose: 1, ..Globals::default() };
    let mut settings = Settings::resolve(&flags, &antrieb::args::Environment::default()).unwrap();
    settings.addresses = Addresses::Named(vec![1]);
    let registry = Registry::open(&[]).unwrap();
    let interrupt = Interrupt::default();
    let mut ask = Interrupting { interrupt: interrupt.clone(), then, asked: false };
    let mut sent = Vec::new();
    let mut observe = |event| {
        if let Event::Telegram { direction: '>', hex, .. } = event {
            sent.push(hex);
        }
    };
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
    let failure = runtime.block_on(verb(&mut context)).unwrap_err();
    assert!(ask.asked, "{failure:?}");
    assert_eq!((failure.class, failure.class.exit()), (Class::Interrupted, 130), "{failure:?}");
    assert_eq!(failure.code, "interrupted.question");
    let writes = ["01 06", "01 10", "01 65"];
    assert!(!sent.iter().any(|hex| writes.iter().any(|write| hex.starts_with(write))), "{sent:?}");
}

#[test]
fn an_interrupt_at_the_question_ends_every_verb_that_asks_and_nothing_is_sent() {
    for then in [None, Some(Answer::Yes)] {
        interrupted(then, async |context| statemachine::run(&arguments("enable --take-control"), context).await);
        interrupted(then, async |context| sollwert::run(&arguments("5Hz --source line"), context).await);
        interrupted(then, async |context| write::run(&arguments("480@1=7Hz"), context).await);
        interrupted(then, async |context| diag::run(&arguments("--clear"), context).await);
        interrupted(then, async |context| line::run(&arguments("set --baud 9600"), context).await);
    }
}
