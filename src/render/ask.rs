//! Puts the safety question on the terminal.

use super::Console;
use super::console::{Input, forget_what_was_typed};
use crate::gate::{Answer, Ask, Question, Reply};
use crate::profile::Lang;
use std::thread;
use std::time::Duration;
use tokio::sync::oneshot;

/// Somebody at the terminal, or `--yes`.
pub struct Terminal {
    /// Where the question is shown.
    pub console: Console,
    /// Where the answer comes from; nowhere, while somebody still waits there for an answer that nobody wants any more.
    pub input: Option<Input>,
    /// There is somebody who can answer: stdin and stderr are terminals.
    pub present: bool,
    /// The answer was given on the command line.
    pub yes: bool,
    /// The question is not shown if it is answered already.
    pub quiet: bool,
    /// Language of the question.
    pub lang: Lang,
}

impl std::fmt::Debug for Terminal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Terminal").field("present", &self.present).field("yes", &self.yes).finish_non_exhaustive()
    }
}

impl Ask for Terminal {
    fn ask<'a>(&'a mut self, question: &'a Question) -> Reply<'a> {
        Box::pin(self.put(question))
    }

    fn is_there(&self) -> bool {
        self.yes || self.present
    }

    fn takes_time(&self) -> bool {
        !self.yes
    }
}

impl Terminal {
    async fn put(&mut self, question: &Question) -> Answer {
        self.console.finish();
        if !(self.yes && self.quiet) {
            self.console.say(question.title.get(self.lang));
            for detail in &question.details {
                self.console.say(&format!("  {}", detail.get(self.lang)));
            }
        }
        if self.yes {
            return Answer::Yes;
        }
        let Some(input) = self.input.take().filter(|_| self.present) else { return Answer::Nobody };
        let (prompt, yes) = match self.lang {
            Lang::En => ("go on? [y/N] ", ["y", "yes"]),
            Lang::De => ("fortfahren? [j/N] ", ["j", "ja"]),
        };
        // Nobody has answered what was not shown yet.
        forget_what_was_typed();
        self.console.prompt(prompt);
        let mut open = OpenPrompt { console: &self.console, is_open: true };
        let (typed, input) = read_line(input).await;
        // The newline of who answers is on the screen; who ends the input (Ctrl-D) has typed none.
        open.is_open = !typed.as_ref().is_some_and(|line| line.ends_with('\n'));
        drop(open);
        self.input = input;
        match typed {
            Some(line) if yes.contains(&line.trim().to_lowercase().as_str()) => Answer::Yes,
            _ => Answer::No,
        }
    }
}

/// Reads a line in a thread of its own, so that nothing else waits for it. The thread of a question that nobody waits for
/// any more ends with the program, and what is typed then is read by nobody.
#[expect(clippy::disallowed_methods, reason = "a person has typed; no telegram depends on this time")]
async fn read_line(mut input: Input) -> (Option<String>, Option<Input>) {
    let (done, typed) = oneshot::channel();
    thread::spawn(move || {
        let mut line = String::new();
        let line = input.read_line(&mut line).ok().map(|_| line);
        let _nobody_waits = done.send((line, input));
    });
    let answer = typed.await.map_or((None, None), |(line, input)| (line, Some(input)));
    tokio::time::sleep(GRACE).await;
    answer
}

/// A signal that came a moment before the answer is heard before it.
const GRACE: Duration = Duration::from_millis(100);

/// A question on the terminal; what is said next begins a line of its own if it was never answered.
struct OpenPrompt<'c> {
    console: &'c Console,
    is_open: bool,
}

impl Drop for OpenPrompt<'_> {
    fn drop(&mut self) {
        if self.is_open {
            self.console.line("");
        }
    }
}
