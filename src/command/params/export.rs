//! `params export`: the rows of a catalogue as a table.

use super::{hits, none};
use crate::command::{Context, offline_family, output};
use crate::failure::Failure;
use crate::outcome::{Data, Export, Outcome};
use crate::profile::import::{COLUMNS, cells_of};
use clap::Args as ClapArgs;
use std::path::PathBuf;

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// Number, or words of a slug or name [default: all]
    #[arg(value_name = "SEARCH")]
    search: Vec<String>,
    /// Write to this file [default: stdout]
    ///
    /// Written whole, or not at all; --force replaces an old one.
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// For a German Excel: semicolons, decimal commas
    #[arg(long)]
    excel: bool,
}

pub(super) fn run(options: &Options, context: &Context<'_>) -> Result<Outcome, Failure> {
    let family = offline_family(context.settings, context.registry)?;
    let params = hits(&family, &options.search);
    if params.is_empty() {
        return Ok(none(&family, &options.search).into());
    }
    let rows: Vec<Vec<(&'static str, String)>> = params.into_iter().map(|param| cells_of(&family, param)).collect();
    let list = list(&rows, options.excel);
    if let Some(path) = &options.output {
        // Excel takes a file for UTF-8 that says so.
        let mark = if options.excel { "\u{FEFF}" } else { "" };
        output::write(path, &format!("{mark}{list}"), context.settings.force)?;
    }
    let output = options.output.as_ref().map(|path| path.display().to_string());
    let list = output.is_none().then_some(list);
    let params = rows.into_iter().map(|row| row.into_iter().collect()).collect();
    Ok(Outcome::of(Data::Export(Export {
        drive: family.drive.clone(),
        columns: COLUMNS.to_vec(),
        params,
        output,
        list,
    })))
}

/// RFC 4180, or what a German Excel opens by a double click.
fn list(rows: &[Vec<(&'static str, String)>], excel: bool) -> String {
    let separator = if excel { ";" } else { "," };
    let cell = |column: &str, text: &str| {
        let is_number = ["min", "max", "default"].contains(&column);
        let text = if excel && is_number { text.replace('.', ",") } else { text.to_owned() };
        match text.contains(separator) || text.contains(['"', '\n', '\r']) {
            true => format!("\"{}\"", text.replace('"', "\"\"")),
            false => text,
        }
    };
    let head = COLUMNS.join(separator);
    let lines =
        rows.iter().map(|row| row.iter().map(|(column, text)| cell(column, text)).collect::<Vec<_>>().join(separator));
    std::iter::once(head).chain(lines).map(|line| format!("{line}\n")).collect()
}
