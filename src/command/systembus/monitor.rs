//! `systembus monitor`: what goes over the bus, in the words of a plan. Never sends.

use super::nmt::no_bus;
use super::plan;
use crate::args::parse_span;
use crate::command::{Context, listen, named_family, telegram_reader};
use crate::drive::{Awaited, BusWatch, Port, watch_bus};
use crate::failure::Failure;
use crate::outcome::{Data, HeardPlace, HeardTaker, Outcome, Plan as DryRun, Warning};
use crate::profile::Family;
use crate::systembus::{self, Plan, Relation};
use crate::text::{Text, both};
use crate::tick::Span;
use clap::Args as ClapArgs;
use std::path::PathBuf;

#[derive(Clone, Debug, ClapArgs)]
pub(super) struct Options {
    /// The plan (TOML), which names senders, sources and takers
    #[arg(value_name = "FILE")]
    file: Option<PathBuf>,
    /// End after this time
    #[arg(long, visible_alias = "for", value_name = "TIME", value_parser = parse_span)]
    duration: Option<Span>,
}

/// Where time is virtual nobody would ever end it.
const QUIET: Span = Span::from_secs(10);
const LONGEST: Span = Span::from_secs(10);
/// A parameter that fills a place with a source: its table names sources.
const INPUT: u32 = 950;
/// What an adapter and a busy machine may hold back before a PDO is called missing; a choice.
const HELD_BACK: Span = Span::from_millis(250);
/// A PDO that nobody waits for is missing when it has not come so many times.
const MISSED: u64 = 5;

pub(super) async fn run(options: &Options, context: &mut Context<'_>) -> Result<Outcome, Failure> {
    let Context { settings, registry, interrupt, observe, .. } = context;
    if !settings.is_can() {
        return Err(no_bus());
    }
    if settings.dry_run {
        return Ok(Outcome::of(Data::Plan(DryRun { dry_run: true, telegrams: Vec::new(), notes: Vec::new() })));
    }
    let name = settings.drive.as_deref().unwrap_or(plan::CUBE);
    let family = named_family(settings, registry, name)?;
    let plan = options.file.as_ref().map(|file| plan::read(std::slice::from_ref(file))).transpose()?;
    let carried = |identifier: u16, bytes: &[u8]| match &plan {
        Some(plan) => systembus::carried(plan, identifier, bytes).into_iter().map(|one| told(one, &family)).collect(),
        None => Vec::new(),
    };
    let is_virtual = matches!(settings.port, Some(Port::Sim(_) | Port::Tape(_)));
    let watch = BusWatch {
        duration: options.duration.or(is_virtual.then_some(LONGEST)),
        quiet: (is_virtual && options.duration.is_none()).then_some(QUIET),
        tells_all: settings.is_for_each(),
        awaited: plan.as_ref().map(awaited).unwrap_or_default(),
        carried: &carried,
    };
    let mut session = listen(settings, registry, interrupt, *observe).await?;
    let (heard, failure) = watch_bus(&mut session, &telegram_reader(settings, &family), &watch).await;
    let missing = heard.heard.iter().filter(|one| one.missing).map(|one| {
        let (identifier, name) = (one.identifier, &one.name);
        let message = both!("{identifier} {name} is missing", "{identifier} {name} fehlt", name);
        Warning { code: "bus.missing".to_owned(), message }
    });
    let warnings = missing.collect();
    Ok(Outcome { data: Some(Data::BusMonitor(Box::new(heard))), warnings, failure })
}

/// The PDOs of a plan that somebody sends. What a receiver waits for is missing when he would miss it.
fn awaited(plan: &Plan) -> Vec<Awaited> {
    let one = |relation: &Relation<'_>| {
        let sender = relation.sender?;
        let every_ms = relation.trigger.and_then(|trigger| plan.every_ms(trigger));
        let timeouts = relation.receivers.iter().map(|one| one.rx.timeout_ms).filter(|ms| *ms > 0);
        let patience = timeouts.min().map(u64::from).or(every_ms.map(|ms| u64::from(ms) * MISSED));
        let pdo = relation.tx.map_or_else(String::new, |tx| format!(" TxPDO{}", tx.number.number()));
        let name = Text::name(format_args!("{sender}{pdo}"));
        Some(Awaited {
            identifier: relation.identifier,
            name,
            every_ms,
            patience: patience.map(|ms| Span::from_millis(ms) + HELD_BACK),
        })
    };
    systembus::relations(plan).iter().filter_map(one).collect()
}

fn told(one: systembus::Carried<'_>, family: &Family) -> HeardPlace {
    let bytes = one.place.bytes();
    let param = family.param(INPUT);
    let source_name = |source: u16| param.and_then(|param| family.text_of(param, source.into())).cloned();
    let taker = |(drive, param): &(&str, u32)| HeardTaker {
        drive: (*drive).to_owned(),
        param: *param,
        param_name: family.param(*param).map(|row| row.name.clone()),
    };
    HeardPlace {
        place: one.place.to_string(),
        first_byte: bytes.start as u8,
        last_byte: bytes.end as u8 - 1,
        source: one.source,
        source_name: one.source.and_then(source_name),
        takers: one.takers.iter().map(taker).collect(),
        raw: one.raw,
    }
}
