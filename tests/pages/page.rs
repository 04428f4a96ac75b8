//! What a page says that somebody should type.

use std::path::{Path, PathBuf};

/// A page with its commands.
pub(crate) struct Page {
    /// From the root on: `docs/can.md`.
    pub(crate) name: String,
    /// Command lines of its blocks, and those in its text that name the bench, in their order.
    pub(crate) commands: Vec<String>,
    /// Any other `antrieb …` in its text, which may be the half of one.
    pub(crate) spans: Vec<String>,
}

pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// README.md and docs/*.md.
pub(crate) fn all() -> Vec<Page> {
    let docs = std::fs::read_dir(root().join("docs")).unwrap().map(|entry| entry.unwrap().path());
    let mut pages: Vec<PathBuf> = docs.filter(|path| path.extension().is_some_and(|ending| ending == "md")).collect();
    pages.push(root().join("README.md"));
    pages.sort();
    pages.iter().map(|path| read(path)).collect()
}

fn read(path: &Path) -> Page {
    let name = path.strip_prefix(root()).unwrap().display().to_string();
    let text = std::fs::read_to_string(path).unwrap();
    let (mut commands, mut spans, mut block) = (Vec::new(), Vec::new(), None);
    for line in text.lines() {
        block = match (line.strip_prefix("```"), block) {
            (Some(_), Some(_)) => None,
            (Some(kind), None) => Some(kind),
            (None, inside) => {
                commands.extend(command(line, inside, &name));
                let quoted = line.split('`').skip(1).step_by(2).filter(|span| inside.is_none() && is_whole(span));
                let (whole, named): (Vec<&str>, Vec<&str>) =
                    quoted.partition(|span| span.starts_with("antrieb -p sim "));
                commands.extend(whole.into_iter().map(str::to_owned));
                spans.extend(named);
                inside
            }
        };
    }
    assert_eq!(block, None, "{name}: a block has no end");
    Page { name, commands, spans: spans.into_iter().map(str::to_owned).collect() }
}

/// The command of a line, if it is one: in a block of `sh` or of no name every line, in one of `console` that behind the prompt, in one of `toml` what another
/// program is to start, without a block what is indented and calls the program.
fn command(line: &str, block: Option<&str>, page: &str) -> Option<String> {
    let typed = match block {
        Some("console") if is_tried(page) => None,
        Some("console") => line.strip_prefix("$ "),
        Some("sh" | "") => Some(line),
        Some("toml") => return started(line),
        Some("text") => None,
        Some(kind) => panic!("{page}: is a block of '{kind}' something to type?"),
        None => line.strip_prefix("    ").filter(|line| line.starts_with("antrieb ")),
    };
    // What stands behind a command in the same line explains it.
    let typed = typed?.split(" # ").next().unwrap_or_default().trim_end();
    (!typed.is_empty()).then(|| typed.to_owned())
}

/// The command that another program starts, from its settings: `command = ["antrieb", "monitor"]`.
fn started(line: &str) -> Option<String> {
    let words = line.strip_prefix("command = [")?.strip_suffix(']')?;
    Some(words.split(", ").map(|word| word.trim_matches('"')).collect::<Vec<_>>().join(" "))
}

/// Whether bash takes it: other shells and keys that are pressed are not its business.
fn is_whole(span: &str) -> bool {
    span.starts_with("antrieb ") && !span.contains(['|', '<'])
}

/// Whether the blocks of `console` of a page are run by `tests/cmd.rs`.
fn is_tried(page: &str) -> bool {
    include_str!("../cmd.rs").contains(&format!(".case(\"{page}\")"))
}
