//! The tables of a bench file as TOML has them. What their keys mean is told in `bench.toml`.

use serde::Deserialize;
use std::collections::BTreeMap;
use toml::{Spanned, Value};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    #[serde(default)]
    pub(super) line: LineTable,
    #[serde(default)]
    pub(super) drive: Vec<Spanned<DriveTable>>,
    #[serde(default)]
    pub(super) disturb: Vec<Spanned<DisturbTable>>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LineTable {
    #[serde(default)]
    pub(super) seed: u64,
    #[serde(default)]
    pub(super) echo: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DriveTable {
    pub(super) model: Spanned<String>,
    pub(super) address: Option<Spanned<i64>>,
    pub(super) protocol: Option<Spanned<String>>,
    pub(super) baud: Option<Spanned<i64>>,
    pub(super) parity: Option<Spanned<String>>,
    pub(super) data_bits: Option<Spanned<i64>>,
    pub(super) stop_bits: Option<Spanned<i64>>,
    pub(super) reply_delay: Option<Spanned<String>>,
    pub(super) jitter: Option<Spanned<String>>,
    pub(super) load: Option<Spanned<String>>,
    pub(super) slow: Option<Spanned<String>>,
    #[serde(default)]
    pub(super) strict_silence: bool,
    #[serde(default)]
    pub(super) strict_remote: bool,
    #[serde(default = "given")]
    pub(super) enable: bool,
    pub(super) stoa: Option<Spanned<bool>>,
    pub(super) stob: Option<Spanned<bool>>,
    pub(super) start_right: Option<bool>,
    pub(super) start_left: Option<bool>,
    pub(super) mains: Option<bool>,
    pub(super) torque: Option<Spanned<i64>>,
    pub(super) ramps: Option<RampTable>,
    #[serde(default)]
    pub(super) modules: Vec<Spanned<String>>,
    #[serde(default)]
    pub(super) set: BTreeMap<String, Spanned<Value>>,
    #[serde(default)]
    pub(super) registers: BTreeMap<String, Spanned<i64>>,
    #[serde(default)]
    pub(super) nodes: Vec<Spanned<NodeTable>>,
    pub(super) servo: Option<Spanned<ServoTable>>,
    #[serde(default)]
    pub(super) readings: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    pub(super) event: Vec<Spanned<EventTable>>,
}

/// A drive on the system bus.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct NodeTable {
    pub(super) id: u8,
    pub(super) model: Spanned<String>,
    #[serde(default)]
    pub(super) modules: Vec<Spanned<String>>,
    #[serde(default)]
    pub(super) set: BTreeMap<String, Spanned<Value>>,
}

/// What stands around an LXM05, and what it tells of itself.
#[derive(Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ServoTable {
    pub(super) limn: Option<i64>,
    pub(super) limp: Option<i64>,
    pub(super) limits: Option<bool>,
    pub(super) guide: Option<i64>,
    pub(super) waver: Option<i64>,
    pub(super) bit6: Option<Spanned<String>>,
    pub(super) vendor: Option<Spanned<String>>,
    pub(super) product: Option<Spanned<String>>,
    pub(super) revision: Option<Spanned<String>>,
    pub(super) revision_object: Option<Spanned<u8>>,
    pub(super) in_pieces: Option<bool>,
}

/// Hertz per second.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RampTable {
    pub(super) up_right: Option<Spanned<Value>>,
    pub(super) down_right: Option<Spanned<Value>>,
    pub(super) up_left: Option<Spanned<Value>>,
    pub(super) down_left: Option<Spanned<Value>>,
}

fn given() -> bool {
    true
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EventTable {
    pub(super) at: Option<Spanned<String>>,
    pub(super) when: Option<Spanned<String>>,
    pub(super) after_writes: Option<Spanned<u64>>,
    pub(super) after_telegrams: Option<Spanned<u64>>,
    #[serde(rename = "for")]
    pub(super) lasts: Option<Spanned<String>>,
    pub(super) fault: Option<Spanned<String>>,
    pub(super) class: Option<u8>,
    pub(super) qualifier: Option<u16>,
    pub(super) warning: Option<u16>,
    pub(super) power_cycle: Option<bool>,
    pub(super) silent: Option<Spanned<String>>,
    pub(super) mains: Option<bool>,
    pub(super) enable: Option<bool>,
    pub(super) stoa: Option<Spanned<bool>>,
    pub(super) stob: Option<Spanned<bool>>,
    pub(super) start_right: Option<bool>,
    pub(super) start_left: Option<bool>,
    pub(super) torque: Option<Spanned<i64>>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DisturbTable {
    pub(super) every: Option<Spanned<u64>>,
    pub(super) once: Option<Spanned<u64>>,
    pub(super) at: Option<Spanned<String>>,
    pub(super) kind: Spanned<String>,
    pub(super) by: Option<Spanned<String>>,
    pub(super) byte: Option<u8>,
    pub(super) address: Option<Spanned<i64>>,
    pub(super) pattern: Option<Spanned<String>>,
    #[serde(rename = "for")]
    pub(super) lasts: Option<Spanned<String>>,
}
