//! Arguments, environment and streams into [`antrieb::run`], its exit code out.

use antrieb::args::Environment;
use antrieb::render::Streams;
use std::io::{self, BufReader, IsTerminal};
use std::process::ExitCode;

fn main() -> ExitCode {
    let environment = Environment {
        variables: std::env::vars_os()
            .filter_map(|(k, v)| Some((k.into_string().ok()?, v.into_string().ok()?)))
            .collect(),
        directory: std::env::current_dir().unwrap_or_default(),
        user_config: antrieb::args::user_config_directory(),
    };
    let streams = Streams {
        out: Box::new(io::stdout()),
        err: Box::new(io::stderr()),
        input: Box::new(BufReader::new(io::stdin())),
        out_is_terminal: io::stdout().is_terminal(),
        err_is_terminal: io::stderr().is_terminal(),
        input_is_terminal: io::stdin().is_terminal(),
        width: antrieb::render::terminal_width(),
    };
    let arguments: Vec<_> = std::env::args_os().collect();
    let code =
        std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| antrieb::run(&arguments, &environment, streams)));
    ExitCode::from(code.unwrap_or(70))
}
