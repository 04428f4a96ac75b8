//! `init`: the project file of a plant, from a scan.

use crate::args::{Addresses, Settings, Takes, in_directory, port_from_elsewhere, usb_ports};
use crate::command::verb::{Flow, Verb, Working};
use crate::command::{Context, scan};
use crate::drive::Upper;
use crate::failure::{Class, Failure};
use crate::files::{self, FileError};
use crate::outcome::{Data, Document, FoundDrive, Init, NamedFind, OrPlan, OrRecord, Outcome, Scan};
use crate::text::{Lang, Text, both};
use clap::Args as ClapArgs;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Writes antrieb.toml from a scan: ports, drives and their names.
///
/// Searches the lines as `scan` does, and writes what it found into antrieb.toml (or FILE), with comments that say how to go on. A file
/// that is there is replaced only with --force. Nothing in a drive is changed.
#[derive(Clone, Debug, ClapArgs)]
#[group(id = "init")]
pub struct Args {
    /// The project file to write
    #[arg(value_name = "FILE", default_value = "antrieb.toml")]
    file: PathBuf,
    #[command(flatten)]
    scan: scan::Args,
    /// Search every USB adapter that is plugged in
    #[arg(long)]
    all_ports: bool,
}

impl Verb for Args {
    const NAME: &'static str = "init";
    const TAKES: Takes = Takes::SEARCHES;
    const EXAMPLES: &'static [&'static str] =
        &["antrieb --port sim init new.toml", "antrieb --port sim -a 1-10 init new.toml --fast"];
    const UPPER: Upper = <scan::Args as Verb>::UPPER;
    type Prints = OrRecord<Document<OrPlan<Init>>>;

    fn streams(&self) -> Option<Flow> {
        Some(Flow::Search)
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let settings = searched(args, context.settings)?;
    let path = in_directory(&settings, &args.file);
    let overwrite = context.settings.force;
    if !settings.dry_run {
        files::check(&path, overwrite).map_err(|error| unwritten(&path, &error))?;
    }
    let Context { registry, ask, observe, interrupt, sheet, .. } = context;
    let (interrupt, sheet) = (interrupt.clone(), *sheet);
    let (ask, observe, calls) = (&mut **ask, &mut **observe, None);
    let mut inner = Context { settings: &settings, registry, ask, observe, interrupt, sheet, calls };
    let outcome = scan::run(&args.scan, &mut inner).await?;
    let Outcome { data: Some(Data::Scan(found)), warnings, failure } = outcome else { return Ok(outcome) };
    let is_whole = failure.as_ref().is_none_or(|failure| failure.class != Class::Interrupted);
    let (drives, unknown) = named(found);
    let mut init = Init { project: None, drives, unknown };
    // A file counts its ports from where it stands.
    let is_elsewhere = args.file.parent().is_some_and(|folder| !folder.as_os_str().is_empty());
    let called = |port: &str| if is_elsewhere { port_from_elsewhere(&settings, port) } else { port.to_owned() };
    let text = text(&init, settings.lang, called);
    let failure = match failure {
        Some(failure) if !is_whole => Some(cut_short(failure, keep(&path, &init, &text))),
        failure => {
            if !init.drives.is_empty() {
                files::write_whole(&path, &text, overwrite).map_err(|error| unwritten(&path, &error))?;
                init.project = Some(path.display().to_string());
            }
            failure
        }
    };
    Ok(Outcome { data: Some(Data::Init(init)), warnings, failure })
}

/// Leaves beside the project file what a search that was interrupted had found; where, if there was anything and the disk took it.
fn keep(path: &Path, init: &Init, text: &str) -> Option<String> {
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let part = PathBuf::from(part);
    let is_kept = !init.drives.is_empty() && files::write_whole(&part, text, true).is_ok();
    is_kept.then(|| part.display().to_string())
}

/// Not all was searched: as the project file it would leave out drives that are there.
fn cut_short(failure: Failure, part: Option<String>) -> Failure {
    let by_itself = both!(
        "with --within 2min the search ends by itself and the file holds what was found by then",
        "mit --within 2min endet die Suche von selbst, und die Datei enthält, was bis dahin gefunden war"
    );
    failure.hint(match part {
        Some(part) => both!(
            "what was found so far stands in {part}, ready to be renamed; not everything was searched, so drives may be missing. \
             {by_itself}",
            "was bis dahin gefunden war, steht in {part} und braucht nur einen anderen Namen; nicht alles ist durchsucht, Antriebe \
             können fehlen. {by_itself}",
            by_itself
        ),
        None => both!(
            "no file was written, because not everything was searched; {by_itself}",
            "es wurde keine Datei geschrieben, weil nicht alles durchsucht ist; {by_itself}",
            by_itself
        ),
    })
}

/// The settings of the search. --force replaces the file; beside another master nobody asks because of it.
fn searched(args: &Args, settings: &Settings) -> Result<Settings, Failure> {
    let mut settings = Settings { force: false, ..settings.clone() };
    if !settings.names_drives() {
        // What an old file names is not all that may be there.
        settings.addresses = Addresses::Unnamed;
    }
    if !args.all_ports {
        return Ok(settings);
    }
    let ports = usb_ports();
    if ports.is_empty() {
        let message = both!("no USB serial adapter is plugged in", "kein USB-Adapter ist eingesteckt");
        return Err(Failure::new(Class::Port, "port.none", message)
            .hint(both!("name the ports with -p", "die Anschlüsse mit -p nennen")));
    }
    Ok(Settings { port: ports.first().cloned(), ports, ..settings })
}

fn unwritten(path: &Path, error: &FileError) -> Failure {
    let message = both!("{file}: {why}", "{file}: {why}", file = path.display(), why = error.text());
    let failure = Failure::new(Class::Data, "data.project", message);
    match error {
        FileError::Exists => failure.hint(both!(
            "--force replaces it; `antrieb init FILE` writes another one",
            "--force ersetzt sie; `antrieb init DATEI` schreibt eine andere"
        )),
        _ => failure,
    }
}

/// The drives that were recognised, each with a name that says what it is and where, and the others.
fn named(scan: Scan) -> (Vec<NamedFind>, Vec<FoundDrive>) {
    let (known, unknown): (Vec<FoundDrive>, Vec<FoundDrive>) =
        scan.drives.into_iter().partition(|drive| drive.drive != "unknown");
    let mut taken = BTreeSet::new();
    let name = |found: FoundDrive| {
        let kind = found.product.as_deref().map(plain).filter(|product| !product.is_empty());
        let kind = kind.unwrap_or_else(|| plain(&found.drive)).to_lowercase();
        NamedFind { called: free(format!("{kind}-{}", found.address), &mut taken), found }
    };
    (known.into_iter().map(name).collect(), unknown)
}

/// A name that TOML takes without quotes.
fn plain(text: &str) -> String {
    let allowed = |letter: char| if letter.is_ascii_alphanumeric() { letter } else { '-' };
    text.chars().map(allowed).collect::<String>().trim_matches('-').to_owned()
}

/// The name, or with a number behind it if it is taken.
fn free(name: String, taken: &mut BTreeSet<String>) -> String {
    let mut free = name.clone();
    let mut count = 1;
    while !taken.insert(free.clone()) {
        count += 1;
        free = format!("{name}-{count}");
    }
    free
}

/// The project file.
fn text(init: &Init, lang: Lang, called: impl Fn(&str) -> String) -> String {
    let mut text = String::new();
    comment(&mut text, &head(), lang);
    let mut ports: BTreeMap<&str, (String, &FoundDrive)> = BTreeMap::new();
    let mut taken = BTreeSet::new();
    for NamedFind { found, .. } in &init.drives {
        if ports.contains_key(found.port.as_str()) {
            continue;
        }
        let name = free(port_name(&found.port), &mut taken);
        let _ = write!(text, "\n[ports.{name}]\npath = {}\n{}", quoted(&called(&found.port)), line_of(found));
        ports.insert(&found.port, (name, found));
    }
    for NamedFind { called, found } in &init.drives {
        let Some((port, first)) = ports.get(found.port.as_str()) else { continue };
        let _ = write!(text, "\n[drives.{called}]\n# {}\nport = \"{port}\"\n", clean(found.title.get(lang)));
        let _ = write!(text, "address = {}\ndrive = {}\n", found.address, quoted(&found.drive));
        if let Some(product) = &found.product {
            let _ = writeln!(text, "product = {}", quoted(product));
        }
        if line_of(found) != line_of(first) {
            comment(&mut text, &other_line(), lang);
            text += &line_of(found);
        }
        let _ = writeln!(text, "# files = [\"base.toml\", \"{called}.toml\"]");
    }
    if !init.unknown.is_empty() {
        text += "\n";
        comment(
            &mut text,
            &both!("Answered, and was not recognised:", "Hat geantwortet und wurde nicht erkannt:"),
            lang,
        );
    }
    for found in &init.unknown {
        let FoundDrive { address, port, title, line, protocol, .. } = found;
        let told = both!(
            "address {address} at {port}, {line} {protocol}: {title}",
            "Adresse {address} an {port}, {line} {protocol}: {title}",
            title
        );
        comment(&mut text, &told, lang);
    }
    text += "\n";
    comment(&mut text, &both!("Groups: antrieb -a @water plan", "Gruppen: antrieb -a @wasser plan"), lang);
    let names: Vec<String> = init.drives.iter().map(|drive| format!("\"{}\"", drive.called)).collect();
    let _ = writeln!(text, "[groups]\n# {} = [{}]", lang.pick("water", "wasser"), names.join(", "));
    text
}

fn comment(text: &mut String, told: &Text, lang: Lang) {
    for line in told.get(lang).lines() {
        let _ = writeln!(text, "{}", format!("# {}", clean(line)).trim_end());
    }
}

/// Without what would end a comment.
fn clean(text: &str) -> String {
    text.replace(char::is_control, " ")
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

/// `/dev/ttyUSB0` is `ttyUSB0`.
fn port_name(port: &str) -> String {
    let last = port.rsplit('/').find(|part| !part.is_empty()).unwrap_or(port);
    let name = plain(last.trim_end_matches(".toml"));
    if name.contains(|letter: char| letter.is_ascii_alphabetic()) { name } else { format!("port-{name}") }
}

/// The settings of a line, from how it is told: `19200 8E1`.
fn line_of(found: &FoundDrive) -> String {
    let mut text = format!("protocol = {}\n", quoted(&found.protocol));
    let Some((baud, format)) = found.line.split_once(' ').filter(|_| found.protocol != "mbtcp") else { return text };
    let mut letters = format.chars();
    let parity = |letter| match letter {
        'E' => "even",
        'O' => "odd",
        _ => "none",
    };
    if let (Some(data), Some(letter), Some(stop)) = (letters.next(), letters.next(), letters.next()) {
        let _ =
            write!(text, "baud = {baud}\nparity = \"{}\"\ndata_bits = {data}\nstop_bits = {stop}\n", parity(letter));
    }
    text
}

fn other_line() -> Text {
    both!(
        "Another setting than the others on this port: `antrieb line set` or `protocol set` brings it to theirs.",
        "Eine andere Einstellung als die anderen an diesem Anschluss: `antrieb line set` oder `protocol set` gleicht sie an."
    )
}

fn head() -> Text {
    both!(
        "A plant: its ports, its drives, and what each drive shall have.\n\
         \n\
         \u{20}  antrieb -a NAME read 411     one drive by its name\n\
         \u{20}  antrieb -a all -p PORT diag  every drive of a port\n\
         \n\
         What a drive shall have stands in parameter files. Save one, name it in `files`, and then:\n\
         \n\
         \u{20}  antrieb -a NAME dataset save NAME.toml\n\
         \u{20}  antrieb plan                 what would change; 1 if something would\n\
         \u{20}  antrieb apply                writes it: one question, every value proven\n\
         \u{20}  antrieb check                1 if a drive is not as its files say\n\
         \n\
         Later files lie over earlier ones: files = [\"base.toml\", \"pump.toml\"].",
        "Eine Anlage: ihre Anschlüsse, ihre Antriebe, und was jeder haben soll.\n\
         \n\
         \u{20}  antrieb -a NAME read 411          ein Antrieb mit seinem Namen\n\
         \u{20}  antrieb -a all -p ANSCHLUSS diag  jeder Antrieb eines Anschlusses\n\
         \n\
         Was ein Antrieb haben soll, steht in Parameterdateien. Eine sichern, in `files` nennen, und dann:\n\
         \n\
         \u{20}  antrieb -a NAME dataset save NAME.toml\n\
         \u{20}  antrieb plan                      was sich ändern würde; 1, wenn etwas\n\
         \u{20}  antrieb apply                     schreibt es: eine Frage, jeder Wert geprüft\n\
         \u{20}  antrieb check                     1, wenn ein Antrieb nicht ist, wie seine Dateien sagen\n\
         \n\
         Spätere Dateien liegen über früheren: files = [\"base.toml\", \"pump.toml\"]."
    )
}
