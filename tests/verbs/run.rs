//! The program inside a test: a command line as it is typed, streams that end in buffers, a directory of its own.

use crate::german;
use antrieb::args::Environment;
use antrieb::command::VERBS;
use antrieb::render::{Patience, Streams};
use antrieb::simulator::Can;
use antrieb::transport::witness;
use jsonschema::Validator;
use serde_json::Value;
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ffi::OsString;
use std::io::{self, Write};
use std::path::Path;
use std::rc::Rc;
use std::sync::LazyLock;
use tempfile::TempDir;

/// The names of the verbs that print one document; `monitor` streams, and its records have a test of their own.
pub(crate) fn verbs() -> impl Iterator<Item = &'static str> {
    VERBS.iter().map(|verb| verb.name).filter(|name| *name != "monitor")
}

/// What a user types behind `antrieb`. Blanks part words, `'…'` holds them together, `{dir}` is the working directory.
pub(crate) fn antrieb(line: &str) -> Run {
    let directory = tempfile::tempdir().unwrap();
    let environment = Environment { directory: directory.path().to_owned(), ..Environment::default() };
    Run {
        line: line.to_owned(),
        port: None,
        directory,
        environment,
        answer: None,
        input: None,
        columns: None,
        pipe_holds: usize::MAX,
        is_paced: false,
    }
}

/// A run that is being prepared.
pub(crate) struct Run {
    line: String,
    port: Option<String>,
    directory: TempDir,
    environment: Environment,
    answer: Option<String>,
    input: Option<String>,
    columns: Option<u16>,
    pipe_holds: usize,
    is_paced: bool,
}

impl Run {
    /// On a bench of its own; adds the port to the command line.
    pub(crate) fn on(mut self, bench: &str) -> Self {
        self = self.file("bench.toml", bench);
        self.port = Some("-p sim:{dir}/bench.toml".to_owned());
        self
    }

    /// With a file in the working directory.
    pub(crate) fn file(self, name: &str, text: &str) -> Self {
        let path = self.directory.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
        self
    }

    /// With a file in the directory of the user's configuration.
    pub(crate) fn user_file(mut self, name: &str, text: &str) -> Self {
        self.environment.user_config = Some(self.directory.path().join("home"));
        self.file(&format!("home/{name}"), text)
    }

    /// With an environment variable.
    pub(crate) fn variable(mut self, name: &str, value: &str) -> Self {
        self.environment.variables.insert(name.to_owned(), value.to_owned());
        self
    }

    /// At a terminal, where somebody types this when asked.
    pub(crate) fn answered(mut self, answer: &str) -> Self {
        self.answer = Some(format!("{answer}\n"));
        self
    }

    /// At a terminal, where somebody ends the input (Ctrl-D) when asked.
    pub(crate) fn answered_by_the_end(mut self) -> Self {
        self.answer = Some(String::new());
        self
    }

    /// With this on stdin, which is no terminal.
    pub(crate) fn fed(mut self, input: &str) -> Self {
        self.input = Some(input.to_owned());
        self
    }

    /// With stdout on a terminal of this width.
    pub(crate) fn columns(mut self, columns: u16) -> Self {
        self.columns = Some(columns);
        self
    }

    /// Into a pipe whose reader goes away after so many bytes.
    pub(crate) fn into_pipe_of(mut self, bytes: usize) -> Self {
        self.pipe_holds = bytes;
        self
    }

    /// On a bench that follows the wall clock where the program wants that; otherwise the witness stands by.
    pub(crate) fn paced(mut self) -> Self {
        self.is_paced = true;
        self
    }

    /// Also with these words.
    pub(crate) fn and(mut self, more: &str) -> Self {
        self.line = format!("{} {more}", self.line);
        self
    }

    /// The working directory.
    pub(crate) fn directory(&self) -> &Path {
        self.directory.path()
    }

    /// Runs, whatever comes of it.
    pub(crate) fn run(self) -> Output {
        witness::call(!self.is_paced);
        let at = self.directory.path().display().to_string();
        let line = format!("antrieb {} {}", self.port.as_deref().unwrap_or(""), self.line);
        let words: Vec<OsString> = words(&line).into_iter().map(|word| word.replace("{dir}", &at).into()).collect();
        let (out, err) = (Buffer::default(), Buffer::default());
        let terminal = self.answer.is_some();
        let streams = Streams {
            out: Box::new(Pipe { buffer: out.clone(), room: self.pipe_holds }),
            queued: None,
            err: Box::new(Pipe { buffer: err.clone(), room: usize::MAX }),
            input: Box::new(io::Cursor::new(self.answer.or(self.input).unwrap_or_default())),
            out_is_terminal: self.columns.is_some(),
            err_is_terminal: terminal,
            input_is_terminal: terminal,
            width: self.columns,
            patience: Patience::default(),
        };
        let exit = antrieb::run(&words, &self.environment, streams);
        if !self.line.contains("--force") {
            witness::look_at_can(|bus| beside_a_master(bus, &self.line));
        }
        let text = |buffer: &Buffer| String::from_utf8(buffer.borrow().clone()).unwrap();
        Output { line: self.line, exit, out: text(&out), err: text(&err), directory: self.directory }
    }

    /// Runs, and must end with this exit code.
    #[track_caller]
    pub(crate) fn exits(self, code: u8) -> Output {
        // A table that is squeezed into a terminal tears words apart.
        let is_squeezed = self.columns.is_some();
        let output = self.run();
        assert_eq!(output.exit, code, "antrieb {}\n{}\n{}", output.line, output.out, output.err);
        if output.line.contains("--lang de") && !is_squeezed {
            german::check(&output.read_by_people());
        }
        output
    }

    /// Runs with `--json`; the document must be the only thing on stdout, fit its schema and agree with the exit code.
    #[track_caller]
    pub(crate) fn json(self) -> Document {
        // They are printed by runs of their own, which would send the witness of this one away.
        LazyLock::force(&SCHEMAS);
        let output = self.and("--json").run();
        let value: Value =
            serde_json::from_str(&output.out).unwrap_or_else(|error| panic!("{error}\n{}\n{}", output.out, output.err));
        check_document(&value, output.exit);
        Document { value, exit: output.exit, err: output.err }
    }
}

/// Whatever a test is about: on a CAN bus with a master drive nothing goes out but questions.
fn beside_a_master(bus: &Can, line: &str) {
    /// What the judge of the bus calls what is none.
    const UNASKED: [&str; 3] = ["the network is the master drive's", "nothing but SDO and NMT", "a remote request"];
    if bus.nodes().any(|(_, node, _)| node == Some(0)) {
        let unasked = bus.remarks().iter().find(|remark| UNASKED.iter().any(|text| remark.contains(text)));
        assert!(unasked.is_none() && bus.orders().is_empty(), "antrieb {line}: {unasked:?}");
    }
}

/// What came of a run.
pub(crate) struct Output {
    pub(crate) line: String,
    pub(crate) exit: u8,
    pub(crate) out: String,
    pub(crate) err: String,
    directory: TempDir,
}

impl Output {
    /// The working directory.
    pub(crate) fn directory(&self) -> &Path {
        self.directory.path()
    }

    /// Another command in the same directory.
    pub(crate) fn then(self, line: &str) -> Run {
        let environment = Environment { directory: self.directory.path().to_owned(), ..Environment::default() };
        Run { directory: self.directory, environment, ..antrieb(line) }
    }

    /// What stands in a file of the directory.
    #[track_caller]
    pub(crate) fn text_of(&self, name: &str) -> String {
        std::fs::read_to_string(self.directory.path().join(name)).unwrap()
    }

    /// What the user sees, for snapshots: without the place of the temporary directory.
    pub(crate) fn page(&self) -> String {
        let at = self.directory.path().display().to_string();
        let page = format!("$ antrieb {}\n{}----- stderr\n{}----- exit {}\n", self.line, self.out, self.err, self.exit);
        page.replace(&at, "DIR")
    }

    /// What is not made for programs.
    fn read_by_people(&self) -> String {
        let is_data = ["--json", "json", "csv"].iter().any(|form| self.line.contains(form));
        if is_data || self.line.contains("--help") { self.err.clone() } else { self.page() }
    }

    /// Telegrams that `-v` showed as sent, in hex.
    pub(crate) fn sent(&self) -> Vec<String> {
        self.telegrams('>')
    }

    /// The same without the greeting of a drive that was named: a counter (code 8).
    pub(crate) fn questions(&self) -> Vec<String> {
        self.sent().into_iter().filter(|sent| !sent.starts_with("01 08 ")).collect()
    }

    /// Telegrams in one direction, in hex.
    pub(crate) fn telegrams(&self, direction: char) -> Vec<String> {
        let marker = format!(" ms {direction} ");
        let lines = self.err.lines().filter_map(|line| line.split_once(&marker));
        lines.map(|(_, rest)| rest.split("  ").next().unwrap().to_owned()).collect()
    }

    /// Lines of the table without its head.
    pub(crate) fn rows(&self) -> Vec<&str> {
        self.out.lines().skip(1).collect()
    }
}

/// A JSON document of a run.
pub(crate) struct Document {
    pub(crate) value: Value,
    pub(crate) exit: u8,
    pub(crate) err: String,
}

impl Document {
    /// Must end with this exit code.
    #[track_caller]
    pub(crate) fn exits(self, code: u8) -> Self {
        assert_eq!(self.exit, code, "{:#}\n{}", self.value, self.err);
        self
    }

    /// What stands at a JSON pointer below `data`.
    #[track_caller]
    pub(crate) fn data(&self, pointer: &str) -> &Value {
        let found = self.value["data"].pointer(pointer);
        found.unwrap_or_else(|| panic!("no data{pointer} in {:#}", self.value))
    }

    /// The error of the document.
    pub(crate) fn error(&self) -> &Value {
        &self.value["error"]
    }

    /// Codes of the warnings.
    pub(crate) fn warnings(&self) -> Vec<&str> {
        self.value["warnings"].as_array().unwrap().iter().map(|row| row["code"].as_str().unwrap()).collect()
    }
}

/// Holds a document against its schema and against what the contract says of every document.
#[track_caller]
pub(crate) fn check_document(value: &Value, exit: u8) {
    let command = value["command"].as_str().unwrap();
    let validator = SCHEMAS.get(command).unwrap_or(&SCHEMAS[""]);
    let broken: Vec<String> =
        validator.iter_errors(value).map(|error| format!("{}: {error}", error.instance_path)).collect();
    assert!(broken.is_empty(), "{command}: {}\n{value:#}", broken.join("\n"));
    assert_eq!(value["schema"], 1);
    assert_eq!(value["tool"], "antrieb");
    assert_eq!(value["ok"], Value::Bool(exit == 0));
    assert_eq!(value["ok"], Value::Bool(value["error"].is_null()));
    if exit != 0 {
        assert_eq!(value["error"]["exit"], exit);
        assert!(!value["error"]["message"].as_str().unwrap().is_empty());
    }
}

/// What `antrieb schema` prints for each verb, compiled; under "" the one for documents of no verb.
pub(crate) static SCHEMAS: LazyLock<BTreeMap<&str, Validator>> = LazyLock::new(|| {
    let compiled = |verb: &str| {
        let printed = antrieb(&format!("schema {verb}")).exits(0);
        let schema: Value = serde_json::from_str(&printed.out).unwrap();
        assert!(jsonschema::meta::is_valid(&schema), "{verb}");
        jsonschema::validator_for(&schema).unwrap()
    };
    [""].into_iter().chain(verbs()).map(|verb| (verb, compiled(verb))).collect()
});

type Buffer = Rc<RefCell<Vec<u8>>>;

/// Takes so many bytes, then nobody reads any more.
struct Pipe {
    buffer: Buffer,
    room: usize,
}

impl Write for Pipe {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        if self.room == 0 && !bytes.is_empty() {
            return Err(io::ErrorKind::BrokenPipe.into());
        }
        let taken = bytes.len().min(self.room);
        self.room -= taken;
        self.buffer.borrow_mut().extend(&bytes[..taken]);
        Ok(taken)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word: Option<String> = None;
    let mut quoted = false;
    for letter in line.chars() {
        match letter {
            '\'' => {
                quoted = !quoted;
                word.get_or_insert_default();
            }
            ' ' if !quoted => words.extend(word.take()),
            _ => word.get_or_insert_default().push(letter),
        }
    }
    words.extend(word);
    words
}
