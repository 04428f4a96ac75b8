//! `antrieb -h`: every command on one screen, by what it is for.

use clap::Command;

/// What for, and the commands for it with a few words each; two stand on a line.
const GROUPS: &[(&str, &[(&str, &str)])] = &[
    ("Find", &[("scan", "drives on a line"), ("identify", "what a drive is")]),
    (
        "Values",
        &[
            ("read", "parameters"),
            ("write", "parameters"),
            ("dataset", "four sets, files"),
            ("params", "the catalogue"),
        ],
    ),
    (
        "Watch",
        &[
            ("diag", "fault, line"),
            ("monitor", "values, live"),
            ("plot", "a record, drawn"),
            ("report", "for who takes over"),
        ],
    ),
    (
        "Motion",
        &[
            ("statemachine", "state, stop, reset"),
            ("sollwert", "setpoint, a run"),
            ("procedure", "guided, step by step"),
        ],
    ),
    (
        "Plant",
        &[
            ("init", "writes antrieb.toml"),
            ("plan", "what would change"),
            ("apply", "makes it so"),
            ("check", "whether it is so"),
        ],
    ),
    (
        "Line",
        &[
            ("line", "speed, address"),
            ("protocol", "RTU, ASCII, VABus"),
            ("sniff", "listens, never sends"),
            ("simulate", "drives without any"),
        ],
    ),
    ("Bus", &[("systembus", "CAN, as a plan"), ("profibus", "who is on it, SJ2-PB")]),
    (
        "Explain",
        &[
            ("decode", "a telegram, a word"),
            ("man", "a page a command"),
            ("schema", "of the JSON"),
            ("completions", "for your shell"),
        ],
    ),
];

/// Options that it tells; the rest stands in `--help`.
const OPTIONS: &[&str] = &["port", "address", "dry_run", "yes"];

/// The command whose help is this page.
pub(super) fn of(root: Command) -> Command {
    let root = root.mut_args(|arg| {
        let is_told = OPTIONS.contains(&arg.get_id().as_str());
        arg.help_heading(None::<&str>).hide_short_help(!is_told)
    });
    root.help_template(format!("{{about}}\n{{usage-heading}} {{usage}}\n{}{{options}}\n{SHORT}\n", commands()))
}

/// What it ends with.
const SHORT: &str = "More: antrieb COMMAND -h, antrieb --help; first steps: antrieb --port sim scan";

fn commands() -> String {
    let mut page = String::new();
    for (title, group) in GROUPS {
        for (row, pair) in group.chunks(2).enumerate() {
            let title = if row == 0 { title } else { "" };
            let cells = pair.iter().map(|(name, what)| format!("{name:<13} {what:<22}"));
            page += &format!("  {title:<8}{}", cells.collect::<String>());
            page.truncate(page.trim_end().len());
            page.push('\n');
        }
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::printed::PRINTED;
    use crate::command::VERBS;

    #[test]
    fn every_command_stands_in_it_once() {
        let mut told: Vec<_> = GROUPS.iter().flat_map(|(_, group)| group.iter().map(|row| row.0)).collect();
        let mut known: Vec<_> = VERBS.iter().map(|verb| verb.name).collect();
        known.extend(PRINTED.iter().filter(|page| !(page.command)().is_hide_set()).map(|page| page.name));
        told.sort_unstable();
        known.sort_unstable();
        assert_eq!(told, known);
    }
}
