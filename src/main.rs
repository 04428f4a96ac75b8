//! Arguments, environment and streams into [`antrieb::run`], its exit code out.

use antrieb::args::Environment;
use antrieb::render::{Outlet, Patience, Stdout, Streams};
use std::io::{self, BufReader, IsTerminal};
use std::process::ExitCode;
use std::time::Duration;

/// How long the last words wait for a reader of stderr that takes nothing.
const PATIENCE: Duration = Duration::from_secs(2);

fn main() -> ExitCode {
    let environment = Environment {
        variables: std::env::vars_os()
            .filter_map(|(k, v)| Some((k.into_string().ok()?, v.into_string().ok()?)))
            .collect(),
        directory: std::env::current_dir().unwrap_or_default(),
        user_config: antrieb::args::user_config_directory(),
    };
    let patience = Patience::default();
    let err = Outlet::new(io::stderr(), patience.clone());
    let streams = Streams {
        out: Box::new(Stdout::new(patience.clone())),
        queued: Some(Outlet::of_stdout),
        err: Box::new(err.clone()),
        input: Box::new(BufReader::new(io::stdin())),
        out_is_terminal: io::stdout().is_terminal(),
        err_is_terminal: io::stderr().is_terminal(),
        input_is_terminal: io::stdin().is_terminal(),
        width: antrieb::render::terminal_width(),
        patience,
    };
    let arguments: Vec<_> = std::env::args_os().collect();
    let code =
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| antrieb::run(&arguments, &environment, streams)));
    err.drain(Some(PATIENCE));
    ExitCode::from(code.unwrap_or(70))
}
