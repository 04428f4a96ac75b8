//! Completions, man pages, the JSON of the catalogues and the schema of parameter files are committed; this keeps them true.
//! `UPDATE=1 cargo test --test generated` writes them.

#![expect(clippy::unwrap_used, reason = "what a test needs and does not get ends it")]

use antrieb::args::Environment;
use antrieb::command::VERBS;
use antrieb::render::{Patience, Streams};
use std::cell::RefCell;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::rc::Rc;

const SHELLS: &[(&str, &str)] =
    &[("bash", "antrieb.bash"), ("zsh", "_antrieb"), ("fish", "antrieb.fish"), ("powershell", "antrieb.ps1")];

#[test]
fn completions_are_up_to_date() {
    for (shell, file) in SHELLS {
        check(&["completions", shell], &root().join("completions").join(file));
    }
}

#[test]
fn man_pages_are_up_to_date() {
    check(&["man"], &root().join("man/antrieb.1"));
    for words in commands() {
        let words: Vec<&str> = words.iter().map(String::as_str).collect();
        let arguments: Vec<&str> = ["man"].into_iter().chain(words.iter().copied()).collect();
        check(&arguments, &root().join(format!("man/antrieb-{}.1", words.join("-"))));
    }
}

/// Two lines: what the catalogue is about, and the whole of it.
#[test]
fn the_json_of_the_catalogues_is_up_to_date() {
    for family in ["active", "lexium05", "hitachi"] {
        let file = root().join("src/profile/data").join(format!("{family}.toml"));
        let text = std::fs::read_to_string(&file).unwrap();
        let whole: serde_json::Map<String, serde_json::Value> = toml::from_str(&text).unwrap();
        let head = ["family", "title", "presumed", "drives"].into_iter();
        let head = head.filter_map(|key| Some((key, whole.get(key)?.clone())));
        let head = serde_json::Value::from_iter(head);
        check_text(&format!("{head}\n{}\n", serde_json::Value::Object(whole)), &file.with_extension("ndjson"));
    }
}

#[test]
fn the_schema_of_parameter_files_is_up_to_date() {
    let schema = serde_json::to_string_pretty(&antrieb::profile::paramfile::schema()).unwrap();
    check_text(&format!("{schema}\n"), &root().join("docs/parameter-file.schema.json"));
}

#[test]
fn every_verb_of_the_help_has_a_man_page() {
    let help = printed(&["--help"]);
    let verbs =
        help.lines().skip_while(|line| !line.starts_with("Commands:")).skip(1).take_while(|line| !line.is_empty());
    let verbs: Vec<&str> = verbs
        .filter(|line| line.starts_with("  ") && !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert_eq!(verbs, pages().collect::<Vec<_>>());
}

#[test]
fn every_option_of_a_man_page_is_told() {
    for command in commands() {
        let arguments: Vec<&str> = ["man"].into_iter().chain(command.iter().map(String::as_str)).collect();
        let page = printed(&arguments);
        let lines: Vec<&str> = page.lines().collect();
        let silent = lines.windows(3).find(|lines| lines[0] == ".TP" && lines[2].trim().is_empty());
        assert_eq!(silent, None, "{command:?}");
    }
}

#[test]
fn every_man_page_lists_every_exit_code() {
    for words in commands().into_iter().chain([Vec::new()]) {
        let arguments: Vec<&str> = ["man"].into_iter().chain(words.iter().map(String::as_str)).collect();
        let page = printed(&arguments);
        let status = page.split(".SH \"EXIT STATUS\"").nth(1).unwrap();
        for (_, code, meaning) in antrieb::failure::Class::TABLE {
            let start = meaning.split([':', ',', '-']).next().unwrap();
            assert!(status.contains(&format!("\\fB{code}\\fR\n{start}")), "{words:?} {code} {meaning}");
        }
    }
}

/// Every verb, and what is printed openly beside them.
fn pages() -> impl Iterator<Item = &'static str> {
    VERBS.iter().map(|verb| verb.name).chain(["schema", "completions", "man"])
}

/// The same with every verb within a verb: `statemachine enable`.
fn commands() -> Vec<Vec<String>> {
    let mut found: Vec<Vec<String>> = pages().map(|name| vec![name.to_owned()]).collect();
    for verb in VERBS {
        let inner = (verb.command)();
        found.extend(inner.get_subcommands().map(|inner| vec![verb.name.to_owned(), inner.get_name().to_owned()]));
    }
    found
}

/// What a page says of motion: the verb's own, and that of the word behind it.
#[test]
fn the_pages_of_the_state_machine_tell_the_options_of_a_run() {
    for page in [printed(&["man", "statemachine"]), printed(&["man", "statemachine", "enable"])] {
        for option in ["hold", "duration", "on\\-exit", "watchdog", "take\\-control", "wait"] {
            assert!(page.contains(&format!("\\-\\-{option}\\fR")), "{option}\n{page}");
        }
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn check(arguments: &[&str], file: &Path) {
    check_text(&printed(arguments), file);
}

#[expect(clippy::disallowed_methods, reason = "UPDATE=1 is how a test is told to write")]
fn check_text(text: &str, file: &Path) {
    if std::env::var_os("UPDATE").is_some() {
        std::fs::create_dir_all(file.parent().unwrap()).unwrap();
        std::fs::write(file, text).unwrap();
        return;
    }
    let committed = std::fs::read_to_string(file).unwrap_or_default();
    assert!(committed == text, "{} is out of date; run UPDATE=1 cargo test --test generated", file.display());
}

/// What the program prints, in process.
fn printed(arguments: &[&str]) -> String {
    let out = Rc::new(RefCell::new(Vec::new()));
    let streams = Streams {
        out: Box::new(Shared(out.clone())),
        queued: None,
        err: Box::new(io::sink()),
        input: Box::new(io::empty()),
        out_is_terminal: false,
        err_is_terminal: false,
        input_is_terminal: false,
        width: None,
        patience: Patience::default(),
    };
    let arguments: Vec<_> = std::iter::once("antrieb").chain(arguments.iter().copied()).map(Into::into).collect();
    assert_eq!(antrieb::run(&arguments, &Environment::default(), streams), 0, "{arguments:?}");
    String::from_utf8(out.take()).unwrap()
}

struct Shared(Rc<RefCell<Vec<u8>>>);

impl Write for Shared {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().write(bytes)
    }
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
