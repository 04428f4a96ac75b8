//! `systembus plan`: a plan, what becomes of it, and whether it is allowed.

use super::super::{Context, named_family, output};
use super::load::total;
use crate::failure::{Class, Failure};
use crate::files;
use crate::outcome::{
    BusDrive, BusLink, BusPlan, BusReceiver, BusRelation, BusRemark, BusSetting, Data, Outcome, Warning,
};
use crate::profile::Family;
use crate::systembus::{self, Level, Link, Plan, Relation, Remark, Setting, Trigger};
use crate::text::{Text, both};
use clap::Args as ClapArgs;
use std::path::{Path, PathBuf};

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// The plan (TOML), or a DCF for each drive
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Show every setting of each drive
    #[arg(long)]
    settings: bool,
    /// Write a DCF for each drive into this directory
    ///
    /// CiA 306, NAME.dcf each; only if the plan breaks no rule. --force replaces old ones.
    #[arg(long, value_name = "DIRECTORY")]
    dcf: Option<PathBuf>,
    /// Write a picture: drives, PDOs, sources
    ///
    /// Written whole, or not at all; --force replaces an old one.
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
}

pub(super) fn run(options: &Options, context: &Context<'_>) -> Result<Outcome, Failure> {
    let settings = context.settings;
    let family = named_family(settings, context.registry, settings.drive.as_deref().unwrap_or(CUBE))?;
    let plan = read(&options.files)?;
    let remarks = systembus::check(&plan, &family);
    let mut drives: Vec<BusDrive> = plan.drives.iter().map(|drive| told(&plan, drive, &family)).collect();
    let errors = remarks.iter().filter(|remark| remark.level == Level::Error).count();
    let mut warnings = Vec::new();
    if let (Some(directory), 0) = (&options.dcf, errors) {
        for (drive, told) in plan.drives.iter().zip(&mut drives) {
            let (text, open) = systembus::dcf(&plan, drive, &family);
            let path = directory.join(format!("{}.dcf", drive.name.replace(['/', '\\'], "_")));
            output::write(&path, &text, settings.force)?;
            told.dcf = Some(path.display().to_string());
            warnings.extend(left_out(&drive.name, &open));
        }
    }
    let svg = options.svg.as_ref().filter(|_| errors == 0);
    if let Some(path) = svg {
        output::write(path, &systembus::picture(&plan, &family, settings.lang), settings.force)?;
    }
    let failure = (errors > 0).then(|| broken(&remarks, options));
    let data = BusPlan {
        files: options.files.iter().map(|path| path.display().to_string()).collect(),
        rate_kbd: plan.rate.kbd(),
        metres: plan.rate.metres(),
        sync_identifier: plan.sync_identifier,
        sync_every_ms: plan.sync_every_ms,
        master: plan
            .master()
            .map(|drive| drive.name.clone())
            .or(plan.has_external_master.then(|| "external".to_owned())),
        drives,
        relations: systembus::relations(&plan).iter().map(|relation| related(&plan, relation)).collect(),
        links: systembus::links(&plan).iter().map(|link| linked(link, &family)).collect(),
        total: total(&plan.budget()),
        remarks: remarks.into_iter().map(remarked).collect(),
        svg: svg.map(|path| path.display().to_string()),
        shows_settings: options.settings,
    };
    Ok(Outcome { data: Some(Data::BusPlan(Box::new(data))), warnings, failure })
}

/// The drive that has the module with the bus.
pub(super) const CUBE: &str = "acu";

fn is_dcf(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("dcf"))
}

pub(super) fn read(paths: &[PathBuf]) -> Result<Plan, Failure> {
    let text = |path: &PathBuf| files::read(path, files::RECORDING).map_err(|error| wrong(error.of(path)));
    if paths.iter().all(|path| is_dcf(path)) {
        let named = |path: &PathBuf| Ok((path.display().to_string(), text(path)?));
        let texts = paths.iter().map(named).collect::<Result<Vec<_>, Failure>>()?;
        return systembus::from_dcf(&texts).map_err(|error| {
            let (file, why) = (&error.file, &error.why);
            wrong(both!("{file}: {why}", "{file}: {why}", why))
        });
    }
    match paths {
        [path] => systembus::read(&text(path)?).map_err(|error| {
            let (path, line, column, why) = (path.display(), error.line, error.column, &error.why);
            wrong(both!("{path}:{line}:{column}: {why}", "{path}:{line}:{column}: {why}", why))
                .hint(both!("docs/system-bus.md shows the format", "docs/system-bus.md zeigt das Format"))
        }),
        _ => Err(Failure::new(
            Class::Usage,
            "usage.files",
            both!("expected one plan, or nothing but DCFs", "erwartet: ein Plan oder lauter DCFs"),
        )),
    }
}

fn wrong(why: Text) -> Failure {
    Failure::new(Class::Data, "data.plan", why)
}

fn broken(remarks: &[Remark], options: &Options) -> Failure {
    let errors: Vec<&Remark> = remarks.iter().filter(|remark| remark.level == Level::Error).collect();
    let count = Text::count(errors.len() as u64, ["rule", "rules"], ["Regel", "Regeln"]);
    let message = both!("the plan breaks {count}", "der Plan verletzt {count}", count);
    let failure = Failure::new(Class::No, "no.plan", message);
    match options.dcf.is_some() || options.svg.is_some() {
        true => failure.hint(both!("nothing was written", "es wurde nichts geschrieben")),
        false => failure,
    }
}

fn left_out(name: &str, open: &[u32]) -> Option<Warning> {
    let list = open.iter().map(|param| format!("P.{param}")).collect::<Vec<_>>().join(", ");
    let message = both!(
        "{name}: {list} left out of the DCF; how the drive counts them is not known (rx-functions)",
        "{name}: {list} fehlen in der DCF; wie der Umrichter sie zählt, ist nicht bekannt (rx-functions)"
    );
    (!open.is_empty()).then(|| Warning { code: "rx_functions".to_owned(), message })
}

fn told(plan: &Plan, drive: &systembus::Drive, family: &Family) -> BusDrive {
    let setting = |Setting { param, value }: Setting| {
        let row = family.param(param);
        let text = row.zip(value).and_then(|(row, value)| family.text_of(row, value)).cloned();
        BusSetting { param, name: row.map(|row| row.name.clone()), raw: value, text }
    };
    let settings = systembus::settings(plan, drive).into_iter().map(setting).collect();
    BusDrive { name: drive.name.clone(), node: drive.node, settings, dcf: None }
}

fn related(plan: &Plan, relation: &Relation<'_>) -> BusRelation {
    let receiver = |one: &systembus::Receiver<'_>| BusReceiver {
        drive: one.drive.to_owned(),
        pdo: one.rx.number.number(),
        timeout_ms: one.rx.timeout_ms,
        on_sync: one.rx.on_sync,
    };
    BusRelation {
        identifier: relation.identifier,
        sender: relation.sender.map(str::to_owned),
        pdo: relation.tx.map(|tx| tx.number.number()),
        on_sync: relation.trigger == Some(Trigger::Sync),
        every_ms: relation.trigger.and_then(|trigger| plan.every_ms(trigger)),
        load_percent: relation.load.map(|load| load.rounded()),
        shown: relation.load.map_or_else(String::new, |load| load.to_string()),
        receivers: relation.receivers.iter().map(receiver).collect(),
    }
}

fn linked(link: &Link<'_>, family: &Family) -> BusLink {
    let name = |param: u32| family.param(param).map(|row| row.name.clone());
    let source = link.input.and_then(|(param, source)| family.text_of(family.param(param)?, source.into()).cloned());
    let bytes = link.place.bytes();
    BusLink {
        identifier: link.identifier,
        place: link.place.to_string(),
        first_byte: bytes.start as u8,
        last_byte: bytes.end as u8 - 1,
        sender: link.sender.map(str::to_owned),
        sender_param: link.input.map(|input| input.0),
        sender_source: link.input.map(|input| input.1),
        sender_source_name: source,
        receiver: link.receiver.map(str::to_owned),
        receiver_param: link.output.map(|output| output.0),
        receiver_param_name: link.output.and_then(|output| name(output.0)),
        receiver_source: link.output.map(|output| output.1),
    }
}

fn remarked(remark: Remark) -> BusRemark {
    BusRemark { level: remark.level.name(), code: remark.code, message: remark.text }
}
