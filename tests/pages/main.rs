//! Every command line of README.md and docs/*.md, by bash and with the real program, on the bench and its variants: whoever types what stands
//! there gets what stands there. Blocks of `console` on the pages of `tests/cmd.rs` are run there, with all that they print.
#![cfg(unix)]
#![expect(clippy::unwrap_used, reason = "what a test needs and does not get ends it")]
#![expect(clippy::disallowed_methods, reason = "processes have a time of their own")]

mod files;
mod page;
mod shell;
mod table;

use page::Page;
use std::collections::BTreeSet;
use table::{ELSEWHERE, ROWS, Row};

/// The row that speaks of this line.
fn row(page: &Page, typed: &str) -> Option<&'static Row<'static>> {
    ROWS.iter().find(|row| row.page == page.name && typed.ends_with(row.typed))
}

fn is_elsewhere(page: &Page) -> bool {
    ELSEWHERE.iter().any(|(name, _)| *name == page.name)
}

/// Runs a page from its top to its end in a folder of its own; returns how many commands ran, and what is not as it should be.
fn walk(page: &Page) -> (usize, Vec<String>) {
    let mut shell = shell::Shell::new(&page.name);
    let (mut ran, mut wrong) = (0, Vec::new());
    for typed in &page.commands {
        let usual = Row::new(&page.name, typed);
        match shell.runs(typed, row(page, typed).unwrap_or(&usual)) {
            Ok(true) => ran += 1,
            Ok(false) => {}
            Err(told) => wrong.push(format!("{}: {typed}\n{told}", page.name)),
        }
    }
    for typed in &page.spans {
        ran += 1;
        wrong.extend(shell.knows(typed).map(|told| format!("{}: `{typed}`\n{told}", page.name)));
    }
    (ran, wrong)
}

#[test]
fn every_command_of_the_pages_does_what_they_say() {
    let pages = page::all();
    let ended: Vec<_> = std::thread::scope(|scope| {
        let walks: Vec<_> =
            pages.iter().filter(|page| !is_elsewhere(page)).map(|page| scope.spawn(|| walk(page))).collect();
        walks.into_iter().map(|walk| walk.join().unwrap()).collect()
    });
    let wrong: Vec<_> = ended.iter().flat_map(|(_, wrong)| wrong.clone()).collect();
    assert!(wrong.is_empty(), "{} commands of the pages are not as they say:\n\n{}", wrong.len(), wrong.join("\n\n"));
    let ran: usize = ended.iter().map(|(ran, _)| ran).sum();
    assert!(ran > 140, "only {ran} commands were found");
}

/// A row that no line needs any more, or that two lines take for theirs, says nothing.
#[test]
fn every_row_speaks_of_one_line() {
    let pages = page::all();
    for row in ROWS {
        let page =
            pages.iter().find(|page| page.name == row.page).unwrap_or_else(|| panic!("there is no {}", row.page));
        let lines: BTreeSet<_> = page.commands.iter().filter(|line| line.ends_with(row.typed)).collect();
        assert_eq!(lines.len(), 1, "{}: '{}' is the end of {lines:?}", row.page, row.typed);
    }
    for (name, test) in ELSEWHERE {
        let text = std::fs::read_to_string(page::root().join(test)).unwrap();
        assert!(text.contains(name), "{test} does not run {name}");
        assert!(pages.iter().any(|page| page.name == *name), "there is no {name}");
    }
}
