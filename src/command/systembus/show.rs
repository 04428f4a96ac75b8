//! `systembus show`: what the settings of drives come to on the bus.

use super::Args;
use crate::args::Settings;
use crate::command::verb::Verb;
use crate::command::{Context, Row, each_drive, finish, named_family, offline_family, plan, read_question, target};
use crate::drive::{Reader, Session};
use crate::failure::{Class, Failure};
use crate::outcome::{BusChannel, BusNode, BusPlace, BusShow, Data, ErrorDoc, Outcome, Value, Warning};
use crate::profile::{DataSets, Family, Param, Registry};
use crate::systembus::{Channel, End, Function, Numbering, Standing};
use crate::text::both;
use std::collections::BTreeMap;
use std::rc::Rc;

/// Reads the settings of every drive that was named.
pub(super) async fn run(context: &mut Context<'_>) -> Result<Outcome, Failure> {
    if context.settings.dry_run {
        let name = context.settings.drive.as_deref().unwrap_or(super::plan::CUBE);
        let family: Rc<Family> = named_family(context.settings, context.registry, name)?;
        let questions: Vec<_> = params(&family).iter().map(|param| read_question(param, 0)).collect();
        return plan(context, &family, &questions);
    }
    let usual = offline_family(context.settings, context.registry)?;
    let most = params(&usual).len();
    let (drives, failures, succeeded) = each_drive(
        context,
        <Args as Verb>::UPPER.questions(most as u64),
        async |session: &mut Session<'_>, settings: &Settings, registry: &Registry, address| {
            look(session, settings, registry, address).await
        },
        |address, failure: &Failure| BusNode {
            address,
            drive: failure.family().to_owned(),
            error: Some(ErrorDoc::from(failure)),
            ..BusNode::default()
        },
    )
    .await?;
    let warnings = drives.iter().filter_map(uncounted).collect();
    Ok(finish(Data::BusShow(BusShow { drives }), failures, succeeded, warnings))
}

/// What is read: everything of the bus, and of the rest what can take from a PDO.
fn params(family: &Family) -> Vec<Param> {
    let bus = family.group(GROUP).unwrap_or_default();
    let takes = |param: &&Param| {
        param.enumeration.as_deref() == Some(SOURCES) && param.access.reads() && !bus.contains(&param.id)
    };
    let takers = family.params.values().filter(takes).cloned();
    bus.iter().map(|id| family.param_or_unknown(*id)).chain(takers).collect()
}

/// The group of the parameters of the bus, and the table of sources.
const GROUP: &str = "systembus";
const SOURCES: &str = "signal-source";

async fn look(
    session: &mut Session<'_>,
    settings: &Settings,
    registry: &Registry,
    address: u8,
) -> Result<Row<BusNode>, Failure> {
    let mut target = target(session, settings, registry, address, false).await?;
    let family = target.family.clone();
    if family.group(GROUP).is_none() {
        return Err(no_bus(&family).with("address", address));
    }
    let params = params(&family);
    let (bus, takers) = params.split_at(family.group(GROUP).map_or(0, |bus| bus.len()));
    let mut reader = Reader::new(session, &mut target);
    reader.lenient = true;
    let mut values = Vec::new();
    reader.fetch(bus).await?;
    for param in bus {
        values.extend(reader.rows(param, DataSets::Unnamed).await?);
    }
    // A drive without the module knows none of it.
    if values.iter().all(|value| value.raw.is_none()) {
        let (failures, _) = reader.into_failures();
        return match failures.into_iter().next() {
            Some(failure) => Err(without_module(failure)),
            None => Err(no_bus(&family).with("address", address)),
        };
    }
    for param in takers {
        values.extend(reader.rows(param, DataSets::Unnamed).await?);
    }
    let (failures, good) = reader.into_failures();
    Ok((told(address, &family, values), failures, good))
}

/// What the values come to.
fn told(address: u8, family: &Family, values: Vec<Value>) -> BusNode {
    let raw: BTreeMap<u32, i64> = values.iter().filter_map(|value| Some((value.param, value.raw?))).collect();
    let standing = Standing::new(&raw);
    let text = |param: u32| values.iter().find(|value| value.param == param).and_then(|value| value.text.clone());
    let [sync_every_ms, sync_timeout_ms, boot_up_delay_ms] = standing.times();
    let [rx_sdo1, tx_sdo1] = standing.sdo1();
    let channel = |one| channel(one, family);
    BusNode {
        address,
        drive: family.drive.clone(),
        node: standing.node(),
        rate_kbd: standing.rate().map(|rate| rate.kbd()),
        node_state: raw.get(&NODE_STATE).copied(),
        node_state_text: text(NODE_STATE),
        can_state: raw.get(&CAN_STATE).copied(),
        can_state_text: text(CAN_STATE),
        sync_identifier: standing.sync_identifier(),
        sync_timeout_ms,
        sync_every_ms,
        boot_up_delay_ms,
        emergency_reaction: text(EMERGENCY_REACTION),
        rx_sdo1,
        tx_sdo1,
        sdo2: standing.sdo2(),
        rx_functions: standing.numbering().map(Numbering::name),
        sent: standing.all_sent().into_iter().map(channel).collect(),
        received: standing.all_received().into_iter().map(channel).collect(),
        values,
        error: None,
    }
}

/// State on the bus, state of its controller, reaction to an emergency (EM-RES-03 manual 5.12, 5.8.3).
const NODE_STATE: u32 = 978;
const CAN_STATE: u32 = 979;
const EMERGENCY_REACTION: u32 = 989;

fn channel(one: Channel, family: &Family) -> BusChannel {
    let place = |End { place, param, source }: End| {
        let bytes = place.bytes();
        let row = family.param(param);
        BusPlace {
            place: place.to_string(),
            first_byte: bytes.start as u8,
            last_byte: bytes.end as u8 - 1,
            param,
            param_name: row.map(|row| row.name.clone()),
            source,
            source_name: row.and_then(|row| family.text_of(row, source.into())).cloned(),
        }
    };
    BusChannel {
        pdo: one.number.number(),
        identifier: one.identifier,
        code: one.code,
        function: one.function.map(Function::name),
        ms: one.ms,
        places: one.ends.into_iter().map(place).collect(),
    }
}

/// That nobody can tell what the functions of its RxPDOs mean.
fn uncounted(node: &BusNode) -> Option<Warning> {
    let is_open = node.rx_functions.is_none() && node.received.iter().any(|one| one.code.is_some());
    let message = both!(
        "drive {address}: what the functions of its RxPDOs (P.936 to P.938) mean is not known: 0 and 1 stand in both numberings of the \
         manual (5.11.2, 5.7.2)",
        "Antrieb {address}: was die Funktionen seiner RxPDOs (P.936 bis P.938) bedeuten, ist nicht bekannt: 0 und 1 stehen in beiden \
         Zählungen der Anleitung (5.11.2, 5.7.2)",
        address = node.address
    );
    is_open.then(|| Warning { code: "rx_functions".to_owned(), message })
}

fn no_bus(family: &Family) -> Failure {
    let drive = &family.drive;
    let message = both!(
        "a drive of the family {drive} has no system bus that a source tells of",
        "ein Antrieb der Familie {drive} hat keinen Systembus, von dem eine Quelle weiß"
    );
    Failure::new(Class::Data, "data.no_system_bus", message).of_family(drive)
}

fn without_module(failure: Failure) -> Failure {
    if failure.class != Class::Refused {
        return failure;
    }
    failure.hint(both!(
        "the parameters of the bus come with the module EM-RES-03; `antrieb identify` tells which modules answer",
        "die Parameter des Busses kommen mit dem Modul EM-RES-03; `antrieb identify` nennt, welche Module antworten"
    ))
}
