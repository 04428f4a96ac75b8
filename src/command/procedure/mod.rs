//! `procedure`: guided work, step by step. The steps are data (`profile::procedure`); here is what they do.

mod aim;
mod analog;
mod bounds;
mod contact;
mod dry;
mod given;
mod guide;
mod held;
mod lent;
mod nameplate;
mod offset;
pub(in crate::command) mod record;
mod resolver;
mod search;
mod turning;

use super::verb::{Verb, Working};
use super::{Context, addresses_to_write, asking, connect, offline_family, running};
use crate::args::{Takes, in_directory};
use crate::drive::{Upper, motion};
use crate::failure::{Class, Failure};
use crate::gate;
use crate::outcome::{
    Data, Document, OrListed, Outcome, ProcedureRecord, ProcedureStep, ProcedureTold, Procedures, StepFate, Warning,
};
use crate::profile::Family;
use crate::profile::procedure::{Act, Procedure};
use crate::text::both;
use clap::Args as ClapArgs;
use given::Given;
use guide::Guide;
use std::path::PathBuf;
use std::rc::Rc;

/// Guided work, step by step.
///
/// Every step is shown with what the manual warns of, asked, proven by the drive where that can be, and kept in a record. The
/// record is written whole behind every step (procedure-NAME-ADDRESS.json, or --record), so that the same command goes on
/// where it was interrupted; what moves a shaft and was begun is done again only with --again. `antrieb report --procedure`
/// shows it.
///
/// list shows what there is. What a procedure must know stands behind it as KEY=VALUE, or in a TOML file (--given).
#[derive(Clone, Debug, ClapArgs)]
pub struct Args {
    /// Which one, or list
    #[arg(value_name = "NAME")]
    pub name: String,

    /// What it must know, such as watchdog=2s
    #[arg(value_name = "KEY=VALUE")]
    pub values: Vec<String>,

    /// Take KEY = "VALUE" from a TOML file
    #[arg(long, value_name = "FILE")]
    pub given: Option<PathBuf>,

    /// Keep the record here, and go on from it
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,

    /// Do again a step that moves and was begun before
    #[arg(long)]
    pub again: bool,
}

impl Verb for Args {
    const NAME: &'static str = "procedure";
    const TAKES: Takes = Takes::WRITES;
    const EXAMPLES: &'static [&'static str] = &[
        "antrieb procedure list",
        "antrieb --port sim -a 1 procedure first-contact --dry-run",
        "antrieb --port sim -a 1 procedure first-contact watchdog=2s --yes",
    ];
    const UPPER: Upper = Upper::drive(300).besides(motion::WAITS).unless(
        "That is for each step; between them it waits for you, and a shaft that still becomes faster or slower is waited for as \
         well, at most 10 min for each ramp.",
    );
    const TURNS: bool = true;
    type Prints = Document<OrListed>;

    fn run<'a>(&'a self, context: &'a mut Context<'_>) -> Working<'a> {
        Box::pin(run(self, context))
    }
}

/// Does a procedure, or goes on with one, or lists them.
pub async fn run(args: &Args, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if args.name == LIST {
        return Ok(list());
    }
    let procedure = named(&args.name)?;
    addresses_to_write(context.settings)?;
    let address = running::single_address(context)?;
    let path = args.record.clone().unwrap_or_else(|| PathBuf::from(format!("procedure-{}-{address}.json", args.name)));
    let path = in_directory(context.settings, &path);
    let replaced = context.settings.force.then(|| record::kept(&path).ok().flatten()).flatten();
    let kept = if context.settings.force { None } else { record::kept(&path)? };
    let given = Given::of(args, &procedure, context.settings, kept.as_ref())?;
    let family = family(&procedure, kept.as_ref(), context)?;
    given.fit(&family)?;
    let does = |act: Act| procedure.steps.iter().any(|step| step.act == act);
    if does(Act::Store) {
        turning::fit(&given, &family)?;
    }
    if does(Act::Offset) {
        aim::fit(&given, &family)?;
    }
    if context.settings.dry_run {
        return Ok(dry::run(&procedure, &given, &family, address, context.settings));
    }
    let record = record::open(&path, kept, &procedure, (address, &family), &given)?;
    held::held(&path, &record, &procedure, &family)?;
    if let Some(rows) = all_done(&procedure, &record) {
        let told = guide::told(&record, rows, &path);
        return Ok(Outcome { data: Some(told), warnings: vec![nothing_left()], failure: None });
    }
    gate::somebody(context.ask).map_err(asking::denied)?;
    let Context { settings, registry, interrupt, observe, ask, .. } = context;
    let session = connect(settings, registry, interrupt, *observe).await?;
    let (procedure, given, again) = (&procedure, &given, args.again);
    let ask = &mut **ask;
    let mut guide = Guide {
        settings,
        registry,
        interrupt,
        ask,
        session,
        target: None,
        procedure,
        given,
        record,
        path,
        again,
        met: false,
        said: None,
    };
    let mut outcome = guide.go().await;
    outcome.warnings.extend(replaced.as_ref().and_then(lent::forgotten));
    Ok(outcome)
}

/// The family whose steps are taken until the drive says what it is: the one that was named, that of the record, or the usual
/// one; where no manual describes the procedure for that, the first for which one does.
fn family(procedure: &Procedure, kept: Option<&ProcedureRecord>, context: &Context<'_>) -> Result<Rc<Family>, Failure> {
    let (settings, registry) = (context.settings, context.registry);
    let family = match (&settings.drive, kept) {
        (None, Some(kept)) => super::named_family(settings, registry, &kept.drive)?,
        _ => offline_family(settings, registry)?,
    };
    if settings.drive.is_some() || procedure.drives.contains(&family.drive) {
        guide::describes(procedure, &family.drive)?;
        return Ok(family);
    }
    super::named_family(settings, registry, procedure.drives.first().map_or("", String::as_str))
}

/// The steps, if nothing is left to do.
fn all_done(procedure: &Procedure, record: &ProcedureRecord) -> Option<Vec<ProcedureStep>> {
    let rows = procedure.steps_of(&record.drive).into_iter().map(|step| guide::row(step, record.step(&step.slug)));
    let rows: Vec<ProcedureStep> = rows.collect();
    rows.iter().all(|row| row.result == StepFate::Done).then_some(rows)
}

/// What stands in the place of a name.
const LIST: &str = "list";

fn list() -> Outcome {
    let told = |procedure: Procedure| {
        let keys = |optional: bool| {
            let keys = procedure.values.iter().filter(|value| value.optional == optional);
            keys.map(|value| value.key.as_str()).collect::<Vec<_>>().join(" ")
        };
        ProcedureTold {
            procedure: procedure.slug.clone(),
            title: procedure.title.clone(),
            drives: procedure.drives.join(" "),
            steps: procedure.drives.first().map_or(0, |drive| procedure.steps_of(drive).len()),
            values: keys(false),
            optional: keys(true),
        }
    };
    Outcome::of(Data::Procedures(Procedures { procedures: Procedure::all().into_iter().map(told).collect() }))
}

fn named(name: &str) -> Result<Procedure, Failure> {
    let all = Procedure::all();
    let known = all.iter().map(|one| one.slug.as_str()).chain([LIST]).collect::<Vec<_>>().join(", ");
    all.into_iter().find(|one| one.slug == name).ok_or_else(|| {
        let message = both!(
            "there is no procedure '{name}' (expected: {known})",
            "es gibt keine Prozedur '{name}' (erwartet: {known})"
        );
        Failure::new(Class::Usage, "usage.procedure", message)
    })
}

fn nothing_left() -> Warning {
    let message = both!(
        "nothing was sent: by its record all of it is done; --force begins anew",
        "es wurde nichts gesendet: laut Aufzeichnung ist alles getan; --force beginnt von vorn"
    );
    Warning { code: "procedure.done".to_owned(), message }
}
