//! Paper as Markdown (CommonMark with the tables of GitHub). Pictures and the logo stand in it as data.

use super::html::data;
use super::paper::{Block, Cell, Paper, Table};
use crate::outcome::Logo;
use crate::render::clean;

pub(super) fn print(paper: &Paper) -> String {
    let mut text = format!("# {}\n\n", escaped(&paper.title));
    if let Some(logo) = &paper.logo {
        text += &format!("![]({})\n\n", data(logo));
    }
    for block in &paper.blocks {
        text += &print_block(block);
        text.push('\n');
    }
    text + &format!("---\n\n{}\n", escaped(&paper.foot))
}

fn print_block(block: &Block) -> String {
    match block {
        Block::Heading(level, text) => format!("{} {}\n", "#".repeat(usize::from(*level) + 1), escaped(text)),
        Block::Text(text) => format!("{}\n", escaped(text)),
        Block::Alarm(text) => format!("> **{}**\n", escaped(text)),
        Block::List(items) => items.iter().map(|item| format!("- {}\n", escaped(item))).collect(),
        Block::Facts(facts) => {
            let rows = facts.iter().map(|(name, text)| vec![Cell::from(name.clone()), Cell::from(text.clone())]);
            print_table(&Table { head: vec![(String::new(), false), (String::new(), false)], rows: rows.collect() })
        }
        Block::Table(table) => print_table(table),
        Block::Picture(picture, what) => {
            let picture = Logo { kind: "image/svg+xml", bytes: picture.clone().into_bytes() };
            format!("![{}]({})\n", escaped(what), data(&picture))
        }
        Block::Lines(lines) => {
            let row = |cells: &[String; 3]| {
                let line = "______________________";
                let named = |cell: &String| match cell.is_empty() {
                    true => line.to_owned(),
                    false => format!("{}: {line}", escaped(cell)),
                };
                cells.iter().map(named).collect::<Vec<_>>().join(" ")
            };
            lines.iter().map(|cells| format!("\n{}\n", row(cells))).collect()
        }
    }
}

/// A cell over several columns stands in the first of them.
fn print_table(table: &Table) -> String {
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = line(table.head.iter().map(|head| escaped(&head.0)).collect());
    text += &line(table.head.iter().map(|head| if head.1 { "--:" } else { "---" }.to_owned()).collect());
    for row in &table.rows {
        let mut cells = Vec::new();
        for cell in row {
            let told = escaped(&cell.text);
            cells.push(if cell.is_marked && !told.is_empty() { format!("**{told}**") } else { told });
            cells.extend((1..cell.span).map(|_| String::new()));
        }
        text += &line(cells);
    }
    text
}

/// What a device or a file is called is no markup; a line has no end within it.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for letter in clean(text).chars() {
        if "\\`*_{}[]<>#|~&!".contains(letter) {
            safe.push('\\');
        }
        safe.push(letter);
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_no_markup() {
        assert_eq!(escaped("a|b *c* <i>\n# [x](y)"), "a\\|b \\*c\\* \\<i\\>\\\\u\\{a\\}\\# \\[x\\](y)");
    }
}
