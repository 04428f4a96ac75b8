//! A plan as TOML (docs/system-bus.md).

use super::load::Rate;
use super::plan::{Drive, EmergencyReaction, Foreign, Numbering, Plan, Rx, Trigger, Tx};
use super::settings::SYNC;
use crate::profile::{place, stumbled};
use crate::protocol::can::pdo::{Kind, Place};
use crate::protocol::can::{Identifier, LAST_DRIVE, PdoNumber, Service};
use crate::text::{Text, both};
use serde::Deserialize;
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;

/// What is wrong with a plan as a file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {line}, column {column}: {}", why.en)]
pub struct PlanError {
    /// From 1.
    pub line: usize,
    /// From 1, in characters.
    pub column: usize,
    /// What is wrong.
    pub why: Text,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Whole {
    bus: Bus,
    drives: BTreeMap<String, Spanned<Node>>,
    #[serde(default)]
    pdo: Vec<Spanned<Pdo>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Bus {
    rate: Spanned<u32>,
    #[serde(default)]
    sync_identifier: Option<Spanned<u32>>,
    #[serde(default)]
    sync_every: Option<u32>,
    #[serde(default)]
    master: Option<Master>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Master {
    External,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Node {
    node: Spanned<u8>,
    #[serde(default)]
    sync_timeout: u32,
    #[serde(default)]
    boot_up_delay: Option<u32>,
    #[serde(default)]
    emergency_reaction: Option<Reaction>,
    #[serde(default)]
    sdo2: Option<bool>,
    #[serde(default)]
    rx_sdo1_identifier: Option<Spanned<u32>>,
    #[serde(default)]
    tx_sdo1_identifier: Option<Spanned<u32>>,
    #[serde(default)]
    rx_functions: Option<Functions>,
}

#[derive(Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Reaction {
    Fault,
    Warning,
}

#[derive(Deserialize)]
enum Functions {
    #[serde(rename = "0-1")]
    FromTime,
    #[serde(rename = "0-2")]
    FromOff,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Pdo {
    from: Spanned<String>,
    #[serde(default)]
    number: Option<Spanned<u8>>,
    #[serde(default)]
    identifier: Option<Spanned<u32>>,
    #[serde(default)]
    every: Option<u32>,
    #[serde(default)]
    on_sync: bool,
    #[serde(default)]
    put: BTreeMap<Spanned<String>, Spanned<u16>>,
    #[serde(default)]
    to: Vec<Spanned<To>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct To {
    drive: Spanned<String>,
    number: Spanned<u8>,
    #[serde(default)]
    timeout: u32,
    #[serde(default)]
    on_sync: bool,
    #[serde(default)]
    take: BTreeMap<Spanned<String>, Params>,
}

/// One parameter, or several that take the same.
#[derive(Deserialize)]
#[serde(untagged)]
enum Params {
    One(u32),
    Several(Vec<u32>),
}

/// Reads a plan.
///
/// # Errors
/// It is no TOML, or not of this format; whom it names is not there; with line and column.
pub fn read(text: &str) -> Result<Plan, PlanError> {
    let source = Source { text };
    let whole: Whole = toml::from_str(text).map_err(|error| {
        let (at, why) = stumbled(&error);
        source.wrong(at..at, why)
    })?;
    let rate = Rate::of_kbd(*whole.bus.rate.get_ref()).ok_or_else(|| {
        let rate = whole.bus.rate.get_ref();
        let known = Rate::ALL.map(|rate| rate.kbd().to_string()).join(", ");
        source.wrong(
            whole.bus.rate.span(),
            both!(
                "expected a rate of {known} kBd, got {rate}",
                "erwartet: eine Rate von {known} kBd; dort steht {rate}"
            ),
        )
    })?;
    let sync_identifier = source.identifier(whole.bus.sync_identifier.as_ref())?.unwrap_or(SYNC);
    let mut plan = Plan {
        rate,
        sync_identifier,
        sync_every_ms: whole.bus.sync_every,
        has_external_master: whole.bus.master.is_some(),
        drives: Vec::new(),
        foreign: Vec::new(),
    };
    for (name, node) in whole.drives {
        plan.drives.push(source.drive(name, node.into_inner())?);
    }
    // In the order of the file they read as they were written; by node they read as on the bus.
    plan.drives.sort_by_key(|drive| drive.node);
    for pdo in whole.pdo {
        source.pdo(&mut plan, pdo.into_inner())?;
    }
    Ok(plan)
}

struct Source<'t> {
    text: &'t str,
}

impl Source<'_> {
    fn wrong(&self, span: Range<usize>, why: Text) -> PlanError {
        let (line, column) = place(self.text, span.start);
        PlanError { line, column, why }
    }

    /// An identifier that may be left out; 0 is left out too, as in the drives.
    fn identifier(&self, given: Option<&Spanned<u32>>) -> Result<Option<u16>, PlanError> {
        let Some(given) = given else { return Ok(None) };
        match Identifier::standard(*given.get_ref()) {
            Some(Identifier::Standard(0)) => Ok(None),
            Some(Identifier::Standard(number)) => Ok(Some(number)),
            _ => {
                let got = given.get_ref();
                let why = both!(
                    "expected an identifier from 0 to 2047, got {got}",
                    "erwartet: ein Identifier von 0 bis 2047; dort steht {got}"
                );
                Err(self.wrong(given.span(), why))
            }
        }
    }

    fn drive(&self, name: String, node: Node) -> Result<Drive, PlanError> {
        let number = *node.node.get_ref();
        if number > LAST_DRIVE {
            let why = both!(
                "expected a node from 0 (the master) to {LAST_DRIVE}, got {number}",
                "erwartet: ein Knoten von 0 (der Master) bis {LAST_DRIVE}; dort steht {number}"
            );
            return Err(self.wrong(node.node.span(), why));
        }
        Ok(Drive {
            name,
            node: number,
            sync_timeout_ms: node.sync_timeout,
            boot_up_delay_ms: node.boot_up_delay,
            emergency_reaction: node.emergency_reaction.map(|reaction| match reaction {
                Reaction::Fault => EmergencyReaction::Fault,
                Reaction::Warning => EmergencyReaction::Warning,
            }),
            sdo2: node.sdo2,
            rx_sdo1: self.identifier(node.rx_sdo1_identifier.as_ref())?,
            tx_sdo1: self.identifier(node.tx_sdo1_identifier.as_ref())?,
            numbering: node.rx_functions.map(|functions| match functions {
                Functions::FromTime => Numbering::FromTime,
                Functions::FromOff => Numbering::FromOff,
            }),
            tx: Vec::new(),
            rx: Vec::new(),
        })
    }

    /// A PDO, which is put to the drives that send and receive it.
    fn pdo(&self, plan: &mut Plan, pdo: Pdo) -> Result<(), PlanError> {
        let trigger = match (pdo.every, pdo.on_sync) {
            (Some(ms), false) => Trigger::Time(ms),
            (None, true) => Trigger::Sync,
            _ => {
                let why = both!(
                    "expected either `every = MILLISECONDS` or `on-sync = true`",
                    "erwartet: entweder `every = MILLISEKUNDEN` oder `on-sync = true`"
                );
                return Err(self.wrong(pdo.from.span(), why));
            }
        };
        let name = pdo.from.get_ref();
        let given = self.identifier(pdo.identifier.as_ref())?;
        let identifier = match plan.drives.iter_mut().find(|drive| drive.name == *name) {
            Some(drive) => {
                let number = self.number(pdo.number.as_ref(), pdo.from.span())?;
                let preset = Service::TxPdo(number, drive.node).identifier().unwrap_or_default();
                let identifier = given.unwrap_or(preset);
                let mut inputs = Vec::new();
                for (key, source) in &pdo.put {
                    inputs.push((self.place(key)?, *source.get_ref()));
                }
                drive.tx.push(Tx { number, identifier, trigger, inputs });
                identifier
            }
            None => {
                let identifier = given.filter(|_| pdo.number.is_none() && pdo.put.is_empty());
                let identifier = identifier.ok_or_else(|| self.wrong(pdo.from.span(), not_a_drive(name)))?;
                plan.foreign.push(Foreign { name: name.clone(), identifier, trigger });
                identifier
            }
        };
        pdo.to.into_iter().try_for_each(|to| self.to(plan, identifier, to.into_inner()))
    }

    fn to(&self, plan: &mut Plan, identifier: u16, to: To) -> Result<(), PlanError> {
        let number = self.number(Some(&to.number), to.number.span())?;
        let mut outputs = Vec::new();
        for (key, params) in &to.take {
            let place = self.place(key)?;
            match params {
                Params::One(param) => outputs.push((place, *param)),
                Params::Several(params) => outputs.extend(params.iter().map(|param| (place, *param))),
            }
        }
        let name = to.drive.get_ref();
        let Some(drive) = plan.drives.iter_mut().find(|drive| drive.name == *name) else {
            let why = both!("there is no drive '{name}' in [drives]", "es gibt keinen Antrieb '{name}' in [drives]");
            return Err(self.wrong(to.drive.span(), why));
        };
        drive.rx.push(Rx { number, identifier, on_sync: to.on_sync, timeout_ms: to.timeout, outputs });
        Ok(())
    }

    fn number(&self, given: Option<&Spanned<u8>>, else_at: Range<usize>) -> Result<PdoNumber, PlanError> {
        let why = both!(
            "expected `number = 1`, 2 or 3: which PDO of the drive",
            "erwartet: `number = 1`, 2 oder 3: welches PDO des Antriebs"
        );
        let at = given.map_or(else_at, Spanned::span);
        given.and_then(|given| PdoNumber::new(*given.get_ref())).ok_or_else(|| self.wrong(at, why))
    }

    /// `word3`.
    fn place(&self, key: &Spanned<String>) -> Result<Place, PlanError> {
        let name = key.get_ref();
        Place::all().find(|place| place.to_string() == *name).ok_or_else(|| {
            let known = Kind::ALL.map(|kind| format!("{}1-{}", kind.name(), kind.places())).join(", ");
            let why = both!("expected {known}, got '{name}'", "erwartet: {known}; dort steht '{name}'");
            self.wrong(key.span(), why)
        })
    }
}

fn not_a_drive(name: &str) -> Text {
    both!(
        "there is no drive '{name}' in [drives]; of somebody else `identifier`, `every` or `on-sync`, and `to` are expected",
        "es gibt keinen Antrieb '{name}' in [drives]; von jemand anderem werden `identifier`, `every` oder `on-sync`, und `to` \
         erwartet"
    )
}
