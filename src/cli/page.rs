//! What the program tells of itself, as a page: what such a page is, and what it is made of.

use crate::args::Environment;
use crate::failure::Failure;
use clap::{Args, Command};
use std::ffi::OsString;
use std::io::{self, Write};

/// A page.
pub(super) trait Page: Args {
    /// How it is typed.
    const NAME: &'static str;
    /// Command lines that its help shows.
    const EXAMPLES: &'static [&'static str];
    /// Prints it, or says why there is none.
    fn print(&self, source: Source<'_>, out: &mut dyn Write) -> io::Result<Option<Failure>>;
}

/// What pages are made of. The trees are built where they are needed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Source<'e> {
    /// What the process was started in.
    pub(super) environment: &'e Environment,
    /// The whole tree of arguments.
    pub(super) whole: fn() -> Command,
    /// What of it is offered.
    pub(super) offered: fn() -> Command,
    /// The verbs that are mentioned.
    pub(super) mentioned: fn(&[OsString]) -> Command,
}

/// What `antrieb --help` ends with.
pub(super) const FIRST_STEPS: &str = "First steps:
  antrieb --port sim scan
  antrieb --port sim -a 1 read 372@2 481 @actual
  antrieb --port sim -a 2 diag
";
