//! Which form a stream has on stdout, and what goes into files beside it.

use crate::args::Environment;
use crate::command::{Flow, keeper, recording};
use crate::failure::{Class, Failure};
use crate::render::{Format, Keep, Place, Stream, View};
use crate::text::both;
use std::io::{self, Write};
use std::path::Path;

/// The form of a stream; `None` where everything is printed at the end.
pub(super) fn view(
    flow: &Flow,
    format: Format,
    sends: bool,
    environment: &Environment,
    (out_is_terminal, at_terminal): (bool, bool),
) -> Option<View> {
    let is_dumb = environment.variables.get("TERM").is_some_and(|term| term == "dumb");
    match (flow, format) {
        (Flow::Run { .. }, _) if !sends => None,
        (Flow::Run { view: true }, _) if at_terminal && !is_dumb && Stream::has_terminal() => Some(View::Live),
        (Flow::Run { view: true }, _) => None,
        (Flow::Search, Format::Ndjson) if sends => Some(View::Ndjson),
        (Flow::Search, _) => None,
        (Flow::Telegrams { capture: Some(path) }, _) if sends && is_stdout(path) => Some(View::Pcap),
        (_, Format::Ndjson) => Some(View::Ndjson),
        // Without an end to wait for there is no document: its JSON is one object a line.
        (Flow::Samples { .. }, Format::Json) => Some(View::Ndjson),
        _ if !sends => None,
        (Flow::Samples { .. }, Format::Csv) => Some(View::Csv),
        (Flow::Samples { .. }, Format::Influx) => Some(View::Influx),
        (Flow::Samples { .. }, Format::OpenMetrics) => Some(View::OpenMetrics),
        (Flow::Samples { line: true, .. }, Format::Table) if out_is_terminal => Some(View::Ticker),
        (Flow::Samples { gather: false, .. }, Format::Table) if out_is_terminal && !is_dumb => Some(View::Live),
        (Flow::Samples { .. }, Format::Table) => Some(View::Lines),
        (Flow::Telegrams { .. }, Format::Table) => Some(View::Telegrams),
        _ => None,
    }
}

/// `-`, in the place of a file.
fn is_stdout(path: &Path) -> bool {
    path == Path::new("-")
}

/// Why a form cannot be had of what a verb tells.
pub(super) fn fits(format: Format, flow: Option<&Flow>) -> Option<Failure> {
    if matches!(flow, Some(Flow::Telegrams { capture: Some(_) })) && matches!(format, Format::Json | Format::Csv) {
        let text = both!(
            "--pcap goes with what is told as it comes, and json and csv are told at the end",
            "--pcap gehört zu dem, was gleich gezeigt wird; json und csv kommen erst am Ende"
        );
        let hint = both!("--format ndjson, or none", "--format ndjson, oder keines");
        return Some(Failure::new(Class::Usage, "usage.format", text).hint(hint));
    }
    if !format.is_for_samples() || matches!(flow, Some(Flow::Samples { .. })) {
        return None;
    }
    let text = both!(
        "--format influx and openmetrics are forms of samples that come again and again",
        "--format influx und openmetrics sind Formen von Messpunkten, die immer wieder kommen"
    );
    let hint = both!("`monitor` has them; else json, ndjson or csv", "`monitor` hat sie; sonst json, ndjson oder csv");
    Some(Failure::new(Class::Usage, "usage.format", text).hint(hint))
}

/// The file that a stream keeps beside it.
pub(super) fn kept(flow: Option<&Flow>) -> io::Result<Option<Keep>> {
    match flow {
        Some(Flow::Samples { textfile: Some(path), .. }) => {
            keeper(path.clone()).map(|keep| Some(Box::new(keep) as Keep))
        }
        _ => Ok(None),
    }
}

/// The file that keeps a stream, and in which form.
pub(super) fn recorded(flow: Option<Flow>, format: Format, force: bool) -> Option<(View, Place)> {
    let path = match flow? {
        Flow::Samples { record: Some(path), .. } => path,
        Flow::Telegrams { capture: Some(path) } if !is_stdout(&path) => {
            return Some((View::Pcap, Box::new(move || Ok(Box::new(recording(&path, force)?) as Box<dyn Write>))));
        }
        _ => return None,
    };
    let ending = path.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    let view = match ending.as_deref() {
        Some("csv") => View::Csv,
        Some("ndjson") => View::Ndjson,
        _ if format == Format::Csv => View::Csv,
        _ => View::Ndjson,
    };
    Some((view, Box::new(move || Ok(Box::new(recording(&path, force)?) as Box<dyn Write>))))
}
