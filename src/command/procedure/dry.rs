//! `procedure NAME --dry-run`: the steps, and what each would send.

use super::aim::{Aim, Params};
use super::analog::Point;
use super::given::Given;
use super::guide::row;
use super::resolver::ENCODER_2;
use super::{aim, analog, nameplate, turning};
use crate::args::Settings;
use crate::command::rehearse::Rehearsal;
use crate::command::{identify, sollwert, telegram_reader};
use crate::drive::motion::watchdog_raw;
use crate::drive::{Cell, Inquiry, harmless, job};
use crate::outcome::{Data, Outcome, Procedure as Told, TelegramDoc};
use crate::profile::procedure::{Act, Procedure};
use crate::profile::{DataSets, Family, Param, Role, Sets, Type, value};
use crate::text::both;

/// What would be done, without opening anything.
pub(super) fn run(procedure: &Procedure, given: &Given, family: &Family, address: u8, settings: &Settings) -> Outcome {
    let steps = procedure.steps_of(&family.drive).into_iter().map(|step| {
        let mut row = row(step, None);
        row.telegrams = telegrams(step.act, given, family, address, settings);
        row
    });
    let mut notes = Vec::new();
    if settings.drive.is_none() {
        notes.push(both!(
            "a dry run asks no drive: taken for '{drive}'; --drive names another",
            "ein Probelauf fragt keinen Antrieb: angenommen ist '{drive}'; --drive nennt einen anderen",
            drive = family.drive
        ));
    }
    if procedure.steps_of(&family.drive).iter().any(|step| step.act == Act::Offset) {
        notes.push(both!(
            "of the search one try is shown, with offset 0 and data set 1; it takes as many as it needs, then one at half of the rated \
             frequency, and what it finds is written once",
            "von der Suche ist ein Versuch gezeigt, mit Offset 0 und Datensatz 1; sie macht so viele wie nötig, dann einen mit halber \
             Bemessungsfrequenz, und was sie findet, wird einmal geschrieben"
        ));
    }
    let told = Told {
        dry_run: true,
        procedure: procedure.slug.clone(),
        title: procedure.title.clone(),
        address,
        drive: family.drive.clone(),
        record: None,
        complete: false,
        given: given.told(),
        steps: steps.collect(),
        notes,
    };
    Outcome::of(Data::Procedure(Box::new(told)))
}

fn telegrams(act: Act, given: &Given, family: &Family, address: u8, settings: &Settings) -> Vec<TelegramDoc> {
    let reader = telegram_reader(settings, family);
    let asked = match act {
        Act::Confirm => Vec::new(),
        Act::Identify => identify::looks(family),
        Act::Line => vec![harmless(family, settings.protocol)],
        Act::Watchdog => watchdog(given, family),
        Act::Store => writes(given, family),
        Act::Nameplate => Vec::new(),
        Act::Motor | Act::Resolver | Act::Hand => resolver(act, given, family),
        Act::Zero => calibration(Point::Zero, family),
        Act::Full => calibration(Point::Full, family),
        Act::Offset => {
            let args = aim::rehearsed(given, family);
            let run = args.map_or_else(Vec::new, |args| sollwert::rehearse(&args, family, settings, address));
            let first = lows(given, family).into_iter().filter_map(|inquiry| reader.question(address, inquiry));
            return first.chain(run).collect();
        }
        Act::Direction | Act::Ramp | Act::Stop | Act::Silence => {
            let args = turning::rehearsed(act, given);
            return args.map_or_else(Vec::new, |args| sollwert::rehearse(&args, family, settings, address));
        }
        Act::Reset => {
            let mut told = Rehearsal::new(settings, family, address);
            told.command("reset");
            return told.telegrams();
        }
    };
    asked.into_iter().filter_map(|inquiry| reader.question(address, inquiry)).collect()
}

fn writes(given: &Given, family: &Family) -> Vec<Inquiry> {
    let steps = nameplate::steps(given, family).map(|(steps, _)| steps).unwrap_or_default();
    let write = |step: &job::Step| {
        let kind = step.kind.unwrap_or(Type::Word);
        let bits = value::to_wire(step.raw, family.link.route.carried(kind)).ok()?;
        Some(Inquiry::Write(Cell { number: step.param.id, set: step.set }, kind, bits))
    };
    steps.iter().filter_map(write).collect()
}

/// What is looked at, or written, before the offset of a resolver is sought.
fn resolver(act: Act, given: &Given, family: &Family) -> Vec<Inquiry> {
    let Ok(params) = Params::of(family) else { return Vec::new() };
    let read = |param: &Param| Inquiry::Read(Cell { number: param.id, set: 0 }, param.kind.unwrap_or(Type::Word));
    match (act, Aim::of(given, &params)) {
        (Act::Hand, _) => vec![read(&params.resolver)],
        (Act::Resolver, Ok(aim)) => {
            let pairs = write(&params.resolver_pairs, aim.resolver_pairs, family);
            pairs.into_iter().chain(write(&params.source, ENCODER_2, family)).collect()
        }
        _ => vec![read(&params.motor_pairs)],
    }
}

/// What goes into the RAM of a data set before a try: the limits, and an offset, for which 0 stands.
fn lows(given: &Given, family: &Family) -> Vec<Inquiry> {
    let Ok(params) = Params::of(family) else { return Vec::new() };
    let Ok(aim) = Aim::of(given, &params) else { return Vec::new() };
    let in_ram = |(param, raw): (&Param, i64)| {
        let kind = param.kind.unwrap_or(Type::Word);
        let bits = value::to_wire(raw, family.link.route.carried(kind)).ok()?;
        let set = DataSets::RAM_OFFSET + u8::from(param.sets == Some(Sets::Four));
        Some(Inquiry::Write(Cell { number: param.id, set }, kind, bits))
    };
    [(&params.limit, aim.limit), (&params.current, aim.current), (&params.offset, 0)]
        .into_iter()
        .filter_map(in_ram)
        .collect()
}

fn calibration(point: Point, family: &Family) -> Vec<Inquiry> {
    analog::params(family).and_then(|(mode, _)| write(&mode, point.mode(), family)).into_iter().collect()
}

fn write(param: &Param, raw: i64, family: &Family) -> Option<Inquiry> {
    let kind = param.kind.unwrap_or(Type::Word);
    let bits = value::to_wire(raw, family.link.route.carried(kind)).ok()?;
    Some(Inquiry::Write(Cell { number: param.id, set: 0 }, kind, bits))
}

fn watchdog(given: &Given, family: &Family) -> Vec<Inquiry> {
    let Some(param) = family.role(Role::Watchdog) else { return Vec::new() };
    let (cell, kind) = (Cell { number: param.id, set: 0 }, param.kind.unwrap_or(Type::Word));
    let raw = given.span("watchdog").ok().flatten().and_then(|span| watchdog_raw(family, span).ok());
    let bits = raw.and_then(|raw| value::to_wire(raw, family.link.route.carried(kind)).ok());
    let write = bits.map(|bits| Inquiry::Write(cell, kind, bits));
    [Inquiry::Read(cell, kind)].into_iter().chain(write).collect()
}
