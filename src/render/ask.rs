//! Puts the safety question on the terminal.

use super::{Console, clean};
use crate::gate::{Answer, Ask, Question};
use crate::profile::Lang;
use std::io::BufRead;

/// Somebody at the terminal, or `--yes`.
pub struct Terminal<'a> {
    /// Where the question is shown.
    pub console: Console,
    /// Where the answer comes from.
    pub input: &'a mut dyn BufRead,
    /// There is somebody who can answer: stdin and stderr are terminals.
    pub present: bool,
    /// The answer was given on the command line.
    pub yes: bool,
    /// The question is not shown if it is answered already.
    pub quiet: bool,
    /// Language of the question.
    pub lang: Lang,
}

impl std::fmt::Debug for Terminal<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Terminal").field("present", &self.present).field("yes", &self.yes).finish_non_exhaustive()
    }
}

impl Ask for Terminal<'_> {
    fn ask(&mut self, question: &Question) -> Answer {
        self.console.finish();
        if !(self.yes && self.quiet) {
            self.console.line(&question.title);
            for detail in &question.details {
                self.console.line(&format!("  {}", clean(detail)));
            }
        }
        if self.yes {
            return Answer::Yes;
        }
        if !self.present {
            return Answer::Nobody;
        }
        let (prompt, yes) = match self.lang {
            Lang::En => ("go on? [y/N] ", ["y", "yes"]),
            Lang::De => ("fortfahren? [j/N] ", ["j", "ja"]),
        };
        self.console.prompt(prompt);
        let mut answer = String::new();
        match self.input.read_line(&mut answer) {
            Ok(_) if yes.contains(&answer.trim().to_lowercase().as_str()) => Answer::Yes,
            _ => Answer::No,
        }
    }

    fn is_there(&self) -> bool {
        self.yes || self.present
    }
}
