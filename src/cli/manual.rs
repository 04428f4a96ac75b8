//! Man pages (man-pages(7): SYNOPSIS, OPTIONS, EXIT STATUS, EXAMPLES), from the tree of arguments.

use super::page::FIRST_STEPS;
use crate::args::Globals;
use crate::command::EXAMPLES;
use crate::failure::Class;
use clap::{Arg, Args as _, Command};
use clap_mangen::Man;
use std::io::{self, Write};

/// Prints the page of a command of the built tree.
pub(super) fn print(command: &Command, out: &mut dyn Write) -> io::Result<()> {
    let told = command.get_after_long_help().map(ToString::to_string).unwrap_or_default();
    let (more, examples) = match told.rsplit_once(EXAMPLES) {
        Some((more, examples)) => (more.trim_end(), examples),
        None => ("", FIRST_STEPS.split_once(":\n").map_or("", |(_, lines)| lines)),
    };
    // No date: the page must be the same whenever it is built.
    // What `-h` leaves out stands here, also where one line is all that is told of it.
    let command = &command.clone().mut_args(|arg| arg.hide_short_help(false));
    let page = Man::new(command.clone().version(env!("CARGO_PKG_VERSION")));
    let page = page.date("").source("antrieb").manual("Commissioning of drives");
    page.render_title(out)?;
    page.render_name_section(out)?;
    page.render_synopsis_section(out)?;
    page.render_description_section(out)?;
    page.render_options_section(out)?;
    if command.get_subcommands().next().is_some() {
        page.render_subcommands_section(out)?;
        options_of_subcommands(command, out)?;
    }
    if !more.is_empty() {
        // Lines that were set by hand stay as they are.
        let (begin, end) = if more.contains('\n') { (".nf\n", "\n.fi") } else { ("", "") };
        writeln!(out, ".SH NOTES\n{begin}{}{end}", escaped(more))?;
    }
    exit_status(out)?;
    writeln!(out, ".SH EXAMPLES\n.nf\n{}\n.fi", escaped(examples.trim_end()))?;
    page.render_version_section(out)
}

/// What stands behind a word of its own is told on the page of the verb too: the options of motion with `statemachine`.
fn options_of_subcommands(command: &Command, out: &mut dyn Write) -> io::Result<()> {
    let globals = Globals::augment_args(Command::new("globals"));
    let is_own = |arg: &Arg| {
        let id = arg.get_id();
        !arg.is_hide_set() && id != "help" && globals.get_arguments().all(|global| global.get_id() != id)
    };
    let mut rows: Vec<(Arg, Vec<&str>)> = Vec::new();
    for inner in command.get_subcommands() {
        for arg in inner.get_arguments().filter(|arg| is_own(arg) && !arg.is_positional()) {
            match rows.iter_mut().find(|(row, _)| row.get_id() == arg.get_id()) {
                Some((_, of)) => of.push(inner.get_name()),
                None => rows.push((arg.clone(), vec![inner.get_name()])),
            }
        }
    }
    if rows.is_empty() {
        return Ok(());
    }
    let told = rows.into_iter().map(|(arg, of)| {
        let help = arg.get_long_help().or(arg.get_help()).map(ToString::to_string).unwrap_or_default();
        // What it goes with or not is told by the page of the subcommand; here those others need not be.
        let shown = Arg::new(arg.get_id().clone()).action(arg.get_action().clone());
        let shown = shown.long_help(format!("{help}\n\nOf: {}", of.join(", ")));
        let shown = arg.get_value_names().into_iter().fold(shown, |shown, names| shown.value_names(names.to_vec()));
        let shown = arg.get_long().into_iter().fold(shown, |shown, long| shown.long(long.to_owned()));
        arg.get_short().into_iter().fold(shown, Arg::short)
    });
    let page = Command::new("options").disable_help_flag(true).args(told);
    let mut text = Vec::new();
    Man::new(page).render_options_section(&mut text)?;
    let text = String::from_utf8_lossy(&text).replacen(".SH OPTIONS", ".SH \"OPTIONS OF THE SUBCOMMANDS\"", 1);
    out.write_all(text.as_bytes())
}

fn exit_status(out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, ".SH \"EXIT STATUS\"\n.TP\n\\fB0\\fR\ndone")?;
    for (_, code, meaning) in Class::TABLE {
        writeln!(out, ".TP\n\\fB{code}\\fR\n{}", escaped(meaning))?;
    }
    Ok(())
}

/// As roff reads it: a backslash and a hyphen mean themselves, and a line does not begin with a control character.
fn escaped(text: &str) -> String {
    let lines = text.lines().map(|line| {
        let line = line.replace('\\', "\\e").replace('-', "\\-");
        if line.starts_with(['.', '\'']) { format!("\\&{line}") } else { line }
    });
    lines.collect::<Vec<_>>().join("\n")
}
