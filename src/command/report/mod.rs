//! `report`: drives and their line on a page that is handed over, with the records that were made of them.

mod drive;
mod paper;

use super::lines::OverLines;
use super::procedure::record;
use super::verb::{Verb, Working};
use super::{Context, addresses_to_read, connect, output, plan, plot, read_question};
use crate::args::{Takes, called};
use crate::drive::paramfile::Wanted;
use crate::drive::{Inquiry, Session, Target, Upper, check_line, harmless, is_over, summary};
use crate::failure::{Class, Failure};
use crate::outcome::{Data, Document, Form, OrPlan, Outcome, Report};
use crate::profile::paramfile::Scope;
use crate::text::both;
use clap::Args as ClapArgs;
use drive::Handed;
use std::path::{Path, PathBuf};

/// Writes down a drive and its line for who takes them over.
///
/// Who the drive is, what it does, its fault, the line with a link test, every setting with its four data sets side by side, what of
/// it differs from the factory settings, their signature, and pictures of records; with room for signatures. A page of HTML
/// (.html) has everything in it and prints on A4; the same goes into Markdown (.md). Nothing in a drive is changed.
///
/// For whom it is says `antrieb.toml`: `[report]` with customer, plant, and logo (PNG, JPEG or SVG, from where the file stands).
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// Where it goes: .html, .md, or one of each
    ///
    /// Written whole, or not at all; --force replaces an old one. Without it the report is told here, and with --json as data.
    #[arg(value_name = "FILE")]
    pub files: Vec<PathBuf>,

    /// Show a record of `monitor --record`; repeatable
    #[arg(long, value_name = "FILE")]
    pub record: Vec<PathBuf>,

    /// Show the record of a `procedure`; repeatable
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    pub procedure: Vec<PathBuf>,

    /// List only what differs from factory settings
    #[arg(long)]
    pub changed: bool,

    /// Questions of the link test to a drive
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub count: u32,
}

impl Verb for Args {
    const NAME: &'static str = "report";
    const TAKES: Takes = Takes::READS;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb --port sim -a 1 report pump.html",
        "antrieb --port sim -a 1,2 report plant.html plant.md --changed",
        "antrieb --port sim -a 1 report pump.html --record record.csv --lang de",
    ];
    const UPPER: Upper = Upper::drive(180).each(48, "parameter, and one for each question of --count");
    type Prints = Document<OrPlan<Report>>;

    fn over_lines(&self) -> OverLines {
        OverLines::One(Some(both!(
            "a report measures one line: one for each, with its port behind -p",
            "ein Bericht misst eine Leitung: einer für jede, mit ihrem Anschluss hinter -p"
        )))
    }

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Reads every drive that was named, measures the line, and writes it down.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let goals = args.goals(context)?;
    if context.settings.dry_run {
        return dry_run(context);
    }
    let mut report = paper::head(context.settings)?;
    report.changed_only = args.changed;
    for file in &args.procedure {
        report.procedures.push(record::read(file)?);
    }
    for file in &args.record {
        let wish = plot::Args::whole(file);
        for (plot, picture) in plot::every(&wish, context.registry, context.settings.lang, report.records.len())? {
            report.records.push(plot);
            report.pictures.push(picture);
        }
    }
    let failure = read(args, context, &mut report).await?;
    if !failure.as_ref().is_some_and(is_over) {
        for (path, form) in &goals {
            output::write(path, &(context.sheet)(&report, *form, context.settings.lang), context.settings.force)?;
            report.files.push(path.display().to_string());
        }
    }
    Ok(Outcome { data: Some(Data::Report(Box::new(report))), warnings: Vec::new(), failure })
}

/// Reads the drives and measures the line, into the report; why that is not all.
async fn read(args: &Args, context: &mut Context<'_>, report: &mut Report) -> Result<Option<Failure>, Failure> {
    let names = called(context.settings)?;
    let Context { settings, registry, interrupt, observe, .. } = context;
    let addresses = addresses_to_read(settings, *observe)?;
    let mut session = connect(settings, registry, interrupt, *observe).await?;
    report.time = session.utc();
    let (mut targets, mut missing, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    for address in addresses {
        session.allow(session.now(), <Args as Verb>::UPPER.drive);
        let Handed { mut drive, target, failure } =
            drive::hand_over(&mut session, settings, registry, address, args.changed).await;
        drive.called = names.get(&address).cloned();
        report.drives.push(drive);
        match (target, failure) {
            (_, Some(failure)) if is_over(&failure) => return Ok(Some(failure)),
            (Some(target), failure) => {
                targets.push(target);
                failures.extend(failure);
            }
            (None, failure) => missing.extend(failure.map(|failure| (address, failure))),
        }
    }
    let whole = targets.len().saturating_sub(failures.len());
    failures.extend(measured(&mut session, targets, &missing, args.count, report).await);
    Ok(summary(failures, whole))
}

/// Measures the line to the drives that were found.
async fn measured(
    session: &mut Session<'_>,
    targets: Vec<Target>,
    missing: &[(u8, Failure)],
    count: u32,
    report: &mut Report,
) -> Vec<Failure> {
    session.allow(session.now(), u64::from(count) * targets.len() as u64);
    let (check, failures) = check_line(session, targets, missing, count.into()).await;
    if !failures.iter().any(is_over) {
        report.line = Some(check);
    }
    failures
}

/// What would be asked, as if the four data sets of everything were equal.
fn dry_run(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let family = super::offline_family(context.settings, context.registry)?;
    let settings = Wanted::of(Scope::Settings, &family)?.asked;
    let mut questions: Vec<Inquiry> = super::diag::looks(&family);
    questions.extend(super::identify::looks(&family));
    questions.extend(settings.iter().map(|one| read_question(&one.param, 0)));
    questions.push(harmless(&family, context.settings.protocol));
    plan(context, &family, &questions)
}

impl Args {
    /// Where it goes, and in which form; whatever stands in the way is told before anything is asked.
    fn goals(&self, context: &Context<'_>) -> Result<Vec<(PathBuf, Form)>, Failure> {
        let goal = |file: &PathBuf| {
            let form = form(file)?;
            output::check(file, context.settings.force)?;
            Ok((file.clone(), form))
        };
        self.files.iter().map(goal).collect()
    }
}

/// The form that the name of a file asks for.
fn form(file: &Path) -> Result<Form, Failure> {
    let ending = file.extension().map(|ending| ending.to_string_lossy().to_ascii_lowercase());
    match ending.as_deref() {
        Some("html" | "htm") => Ok(Form::Html),
        Some("md" | "markdown") => Ok(Form::Markdown),
        _ => {
            let message = both!(
                "expected a file that ends with .html or .md, got {file}",
                "erwartet: eine Datei, die mit .html oder .md endet; angegeben: {file}",
                file = file.display()
            );
            Err(Failure::new(Class::Usage, "usage.file", message))
        }
    }
}
