//! `params import`: a list of parameters becomes a catalogue, which is loaded before it is reported as good.

use super::told::told;
use crate::command::{Context, offline_family, output};
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::{Data, Import, ImportColumn, ImportRow, Outcome, RowLeftOut};
use crate::profile::import::{self, Draft, ImportError, Imported, Own, Target, Wishes, Written};
use crate::profile::{Broken, CatalogueFile, Registry};
use crate::text::{Text, Wrong, both};
use clap::{Args as ClapArgs, ValueEnum};
use std::path::{Path, PathBuf};

/// What a list is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    /// A table: CSV, as spreadsheets write it
    Table,
    /// A map of registers: MBMap version 2, JSON
    Mbmap,
}

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// The list
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// Write the catalogue to this file [default: stdout]
    ///
    /// Written whole, or not at all; --force replaces an old one.
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Which heading is which field: id=Nr (repeatable)
    ///
    /// `unit=` without a heading takes no column for it.
    #[arg(long, value_name = "FIELD=HEAD", value_parser = pair)]
    column: Vec<(String, String)>,
    /// What every row says: access=rw (repeatable)
    ///
    /// Only of rows that say nothing themselves. `370.type=long`: what the row with this number says,
    /// whatever stands there. `type.int=long`: what a word means that stands in a field.
    #[arg(long, value_name = "FIELD=WORD", value_parser = pair)]
    set: Vec<(String, String)>,
    /// A family of its own, reached over plain Modbus
    #[arg(long, value_name = "NAME")]
    own: Option<String>,
    /// Rows take the place of those that are there
    #[arg(long)]
    replace: bool,
    /// What the device is called [default: from the list]
    #[arg(long, value_name = "TEXT", hide_short_help = true)]
    title: Option<String>,
    /// What the list calls register 0: 0, 1, 40001
    #[arg(long, value_name = "N", hide_short_help = true)]
    base: Option<u32>,
    /// Of two registers the first holds the lower half
    #[arg(long, hide_short_help = true)]
    low_half_first: bool,
    /// Input registers are read by code 3, not by code 4
    #[arg(long, hide_short_help = true)]
    input_as_holding: bool,
    /// A key of MBMap that changes no value (repeatable)
    #[arg(long, value_name = "KEY", hide_short_help = true)]
    ignore: Vec<String>,
    /// Between the cells: `;` `,` tab [default: found out]
    #[arg(long, value_name = "CHAR", value_parser = separator, hide_short_help = true)]
    separator: Option<char>,
    /// Before the decimals: `,` or `.` [default: found out]
    #[arg(long, value_name = "CHAR", value_parser = decimal_mark, hide_short_help = true)]
    decimal: Option<char>,
    /// table or mbmap [default: found out]
    #[arg(long = "as", value_enum, hide_possible_values = true, hide_short_help = true)]
    form: Option<Form>,
}

fn pair(text: &str) -> Result<(String, String), Wrong> {
    let wrong = || Wrong(both!("expected FIELD=…", "erwartet: FELD=…"));
    let (field, rest) = text.split_once('=').ok_or_else(wrong)?;
    Ok((field.trim().to_owned(), rest.trim().to_owned()))
}

fn separator(text: &str) -> Result<char, Wrong> {
    match text {
        "tab" | "\\t" => Ok('\t'),
        _ => {
            text.parse().map_err(|_| Wrong(both!("expected one character, or tab", "erwartet: ein Zeichen, oder tab")))
        }
    }
}

fn decimal_mark(text: &str) -> Result<char, Wrong> {
    match text {
        "," | "comma" | "komma" => Ok(','),
        "." | "point" | "punkt" => Ok('.'),
        _ => Err(Wrong(both!("expected ',' or '.'", "erwartet: ',' oder '.'"))),
    }
}

pub(super) fn run(options: &Options, context: &Context<'_>) -> Result<Outcome, Failure> {
    let file = options.file.display().to_string();
    let bytes = files::read_bytes(&options.file, files::TEXT).map_err(|error| {
        Failure::new(Class::Data, "data.list", both!("{file}: {why}", "{file}: {why}", why = error.text()))
    })?;
    let form = options.form.unwrap_or_else(|| form_of(&bytes));
    let wishes = options.wishes(form);
    let found = match form {
        Form::Table => import::table(&bytes, &wishes),
        Form::Mbmap => import::mbmap(&bytes, &wishes),
    };
    let found = found.map_err(|error| refused(&file, &error))?;
    if found.drafts.is_empty() {
        return Err(nothing(&file, &found));
    }
    let target = target(options, &wishes, context, &found)?;
    let written = import::write(&target, &found.drafts);
    let report = report(options, &file, found, &target, &written);
    let head: String = report.told.iter().map(|line| format!("# {}\n", line.get(context.settings.lang))).collect();
    check(options, &file, context, &written)?;
    if let Some(path) = &options.output {
        output::write(path, &(head + &written.text), context.settings.force)?;
    }
    Ok(Outcome::of(Data::Import(Box::new(report))))
}

/// JSON begins with a brace.
fn form_of(bytes: &[u8]) -> Form {
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes).trim_ascii_start();
    if text.starts_with(b"{") { Form::Mbmap } else { Form::Table }
}

impl Options {
    fn wishes(&self, form: Form) -> Wishes {
        Wishes {
            columns: self.column.clone(),
            sets: self.set.clone(),
            separator: self.separator,
            commas: self.decimal.map(|mark| mark == ','),
            base: self.base,
            input_as_holding: self.input_as_holding,
            ignored: self.ignore.clone(),
            own: self.own.is_some() || form == Form::Mbmap,
        }
    }
}

/// The family that the rows are for.
fn target(options: &Options, wishes: &Wishes, context: &Context<'_>, found: &Imported) -> Result<Target, Failure> {
    let replace = options.replace;
    if !wishes.own {
        let family = offline_family(context.settings, context.registry)?;
        let known = context.registry.families().filter(|known| known.family == family.family).collect();
        return Ok(Target { family: family.family.clone(), known, own: None, replace });
    }
    let id = options.own.clone().unwrap_or_else(|| found.own.id.clone());
    if id.is_empty() {
        let message = both!("the map names neither vendor nor model", "die MBMap nennt weder Hersteller noch Modell");
        let hint = both!("give the family a name: --own NAME", "der Familie einen Namen geben: --own NAME");
        return Err(Failure::new(Class::Data, "data.list", message).hint(hint));
    }
    let title = options.title.clone().unwrap_or_else(|| found.own.title.clone());
    let title = if title.is_empty() { id.clone() } else { title };
    let low_half_first = found.own.low_half_first || options.low_half_first;
    let own = Some(Own { id: id.clone(), title, low_half_first });
    Ok(Target { family: id, known: Vec::new(), own, replace })
}

/// What is reported, in fields and in lines.
fn report(options: &Options, file: &str, found: Imported, target: &Target, written: &Written) -> Import {
    let row = |(draft, slug): (&Draft, &String)| ImportRow {
        line: draft.line,
        param: draft.id,
        slug: slug.clone(),
        name: draft.name.clone(),
        unit: draft.unit.clone(),
        data_type: draft.kind.map(|kind| kind.name()),
        decimals: draft.decimals,
        access: draft.access.name(),
    };
    let column = |taken: import::ColumnTaken| ImportColumn {
        field: taken.field,
        heading: taken.heading,
        column: taken.column,
        said: taken.said,
    };
    let output = options.output.as_ref().map(|path| path.display().to_string());
    let mut report = Import {
        file: file.to_owned(),
        format: found.format,
        encoding: found.encoding,
        separator: found.separator.map(String::from),
        family: target.family.clone(),
        own: target.own.is_some(),
        rows: found.drafts.iter().zip(&written.slugs).map(row).collect(),
        columns: found.columns.into_iter().map(column).collect(),
        unused: found.unused,
        left_out: found.left_out.into_iter().map(|left| RowLeftOut { line: left.line, why: left.why }).collect(),
        notes: found.notes,
        catalogue: output.is_none().then(|| written.text.clone()),
        output,
        told: Vec::new(),
    };
    report.told = told(&report, found.head);
    report
}

/// Loads the catalogue beside all others, as `--catalogue` would. What is wrong is told by the line of the list.
fn check(options: &Options, file: &str, context: &Context<'_>, written: &Written) -> Result<(), Failure> {
    let is_same = |path: &str| {
        let same = |output: &PathBuf| {
            output.canonicalize().is_ok_and(|output| Path::new(path).canonicalize().is_ok_and(|path| path == output))
        };
        options.output.as_ref().is_some_and(same)
    };
    let others = context.settings.catalogues.iter().filter(|other| !is_same(&other.path)).cloned();
    let path = format!("{file} (catalogue)");
    let this = CatalogueFile { path: path.clone(), text: written.text.clone() };
    let registry = Registry::open(&others.chain([this]).collect::<Vec<_>>());
    let Err(error) = registry else { return Ok(()) };
    let failure = Failure::new(Class::Data, "data.list", wrong(file, &path, &error, written));
    Err(match already(&error.message).is_some() {
        true => failure.hint(both!(
            "--replace lets the rows of the list take the place of those that are there",
            "--replace lässt die Zeilen der Liste an die Stelle der vorhandenen treten"
        )),
        false => failure,
    })
}

fn wrong(file: &str, path: &str, error: &Broken, written: &Written) -> Text {
    if error.path != path {
        return error.text();
    }
    let line = written.lines.iter().find(|line| line.0 == error.line).map(|line| line.1);
    let told = already(&error.message).unwrap_or_else(|| error.message.clone());
    match line {
        Some(line) => both!("{file}:{line}: {told}", "{file}:{line}: {told}", file, line, told),
        None => both!("{file}: {told}", "{file}: {told}", file, told),
    }
}

/// What a catalogue says of a number that is there already, in words for who has a list: he has no rows of TOML.
fn already(message: &Text) -> Option<Text> {
    let (en, _) = message.en.split_once("; add `replace = true`")?;
    let (de, _) = message.de.split_once("; ")?;
    en.contains(" is already in ").then(|| Text { en: en.to_owned().into(), de: de.to_owned().into() })
}

fn refused(file: &str, error: &ImportError) -> Failure {
    let (line, why) = (error.line, &error.why);
    let message = match line {
        0 => both!("{file}: {why}", "{file}: {why}", file, why),
        _ => both!("{file}:{line}: {why}", "{file}:{line}: {why}", file, line, why),
    };
    let failure = Failure::new(Class::Data, "data.list", message);
    error.hint.iter().cloned().fold(failure, Failure::hint)
}

fn nothing(file: &str, found: &Imported) -> Failure {
    let why = found.left_out.iter().take(3).map(|left| {
        let (line, why) = (left.line, &left.why);
        both!("line {line}: {why}", "Zeile {line}: {why}", line, why)
    });
    let why = Text::join(&why.collect::<Vec<_>>(), "; ");
    let message =
        both!("{file}: no row can be taken ({why})", "{file}: keine Zeile lässt sich übernehmen ({why})", file, why);
    Failure::new(Class::Data, "data.list", message)
}
