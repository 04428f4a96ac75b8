//! The tables of a bench file as TOML has them. What their keys mean is told in `bench.toml`.

use serde::Deserialize;
use std::collections::BTreeMap;
use toml::{Spanned, Value};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct File {
    #[serde(default)]
    pub(crate) line: LineTable,
    #[serde(default)]
    pub(crate) drive: Vec<Spanned<DriveTable>>,
    #[serde(default)]
    pub(crate) disturb: Vec<Spanned<DisturbTable>>,
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LineTable {
    #[serde(default)]
    pub(crate) seed: u64,
    #[serde(default)]
    pub(crate) echo: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DriveTable {
    pub(crate) model: Spanned<String>,
    pub(crate) address: Option<Spanned<i64>>,
    pub(crate) protocol: Option<Spanned<String>>,
    pub(crate) baud: Option<Spanned<i64>>,
    pub(crate) parity: Option<Spanned<String>>,
    pub(crate) data_bits: Option<Spanned<i64>>,
    pub(crate) stop_bits: Option<Spanned<i64>>,
    pub(crate) reply_delay: Option<Spanned<String>>,
    pub(crate) jitter: Option<Spanned<String>>,
    pub(crate) load: Option<Spanned<String>>,
    pub(crate) slow: Option<Spanned<String>>,
    #[serde(default)]
    pub(crate) strict_silence: bool,
    #[serde(default)]
    pub(crate) strict_remote: bool,
    #[serde(default = "given")]
    pub(crate) enable: bool,
    pub(crate) stoa: Option<Spanned<bool>>,
    pub(crate) stob: Option<Spanned<bool>>,
    pub(crate) start_right: Option<bool>,
    pub(crate) start_left: Option<bool>,
    pub(crate) mains: Option<bool>,
    pub(crate) torque: Option<Spanned<i64>>,
    pub(crate) ramps: Option<RampTable>,
    pub(crate) resolver: Option<ResolverTable>,
    pub(crate) analog: Option<AnalogTable>,
    #[serde(default)]
    pub(crate) modules: Vec<Spanned<String>>,
    #[serde(default)]
    pub(crate) set: BTreeMap<String, Spanned<Value>>,
    #[serde(default)]
    pub(crate) registers: BTreeMap<String, Spanned<i64>>,
    #[serde(default)]
    pub(crate) sources: BTreeMap<String, Spanned<i64>>,
    #[serde(default)]
    pub(crate) busy: bool,
    #[serde(default)]
    pub(crate) nodes: Vec<Spanned<NodeTable>>,
    pub(crate) servo: Option<Spanned<ServoTable>>,
    #[serde(default)]
    pub(crate) four: Vec<u32>,
    #[serde(default)]
    pub(crate) other_width: Vec<u32>,
    #[serde(default)]
    pub(crate) eeprom: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    pub(crate) readings: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    pub(crate) event: Vec<Spanned<EventTable>>,
}

/// A drive on the system bus.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct NodeTable {
    pub(crate) id: u8,
    pub(crate) model: Spanned<String>,
    #[serde(default)]
    pub(crate) modules: Vec<Spanned<String>>,
    #[serde(default)]
    pub(crate) set: BTreeMap<String, Spanned<Value>>,
}

/// What stands around an LXM05, and what it tells of itself.
#[derive(Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ServoTable {
    pub(crate) limn: Option<i64>,
    pub(crate) limp: Option<i64>,
    pub(crate) limits: Option<bool>,
    pub(crate) guide: Option<i64>,
    pub(crate) analog: Option<i64>,
    pub(crate) waver: Option<i64>,
    pub(crate) bit6: Option<Spanned<String>>,
    pub(crate) vendor: Option<Spanned<String>>,
    pub(crate) product: Option<Spanned<String>>,
    pub(crate) revision: Option<Spanned<String>>,
    pub(crate) revision_object: Option<Spanned<u8>>,
    pub(crate) in_pieces: Option<bool>,
}

/// Hertz per second.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct RampTable {
    pub(crate) up_right: Option<Spanned<Value>>,
    pub(crate) down_right: Option<Spanned<Value>>,
    pub(crate) up_left: Option<Spanned<Value>>,
    pub(crate) down_left: Option<Spanned<Value>>,
}

/// The motor that a resolver leads.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ResolverTable {
    pub(crate) offset: Spanned<Value>,
    #[serde(default)]
    pub(crate) swapped: bool,
    #[serde(default)]
    pub(crate) inverted: bool,
}

/// The analog input of an EM-RES-03.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct AnalogTable {
    pub(crate) volts: Option<Spanned<Value>>,
    pub(crate) offset: Option<Spanned<Value>>,
    pub(crate) gain: Option<Spanned<Value>>,
}

fn given() -> bool {
    true
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct EventTable {
    pub(crate) at: Option<Spanned<String>>,
    pub(crate) when: Option<Spanned<String>>,
    pub(crate) after_writes: Option<Spanned<u64>>,
    pub(crate) after_telegrams: Option<Spanned<u64>>,
    #[serde(rename = "for")]
    pub(crate) lasts: Option<Spanned<String>>,
    pub(crate) fault: Option<Spanned<String>>,
    pub(crate) class: Option<u8>,
    pub(crate) qualifier: Option<u16>,
    pub(crate) warning: Option<u16>,
    pub(crate) power_cycle: Option<bool>,
    pub(crate) silent: Option<Spanned<String>>,
    pub(crate) bus_off: Option<Spanned<String>>,
    pub(crate) refuses: Option<u16>,
    pub(crate) ignores: Option<u16>,
    #[serde(default)]
    pub(crate) eeprom: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    pub(crate) set: BTreeMap<String, Spanned<Value>>,
    pub(crate) mains: Option<bool>,
    pub(crate) enable: Option<bool>,
    pub(crate) stoa: Option<Spanned<bool>>,
    pub(crate) stob: Option<Spanned<bool>>,
    pub(crate) start_right: Option<bool>,
    pub(crate) start_left: Option<bool>,
    pub(crate) torque: Option<Spanned<i64>>,
    #[serde(default)]
    pub(crate) exchange_phases: bool,
    pub(crate) hand: Option<Spanned<Value>>,
    pub(crate) analog: Option<Spanned<Value>>,
    pub(crate) dragged: Option<bool>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DisturbTable {
    pub(crate) every: Option<Spanned<u64>>,
    pub(crate) once: Option<Spanned<u64>>,
    pub(crate) at: Option<Spanned<String>>,
    pub(crate) kind: Spanned<String>,
    pub(crate) by: Option<Spanned<String>>,
    pub(crate) byte: Option<u8>,
    pub(crate) address: Option<Spanned<i64>>,
    pub(crate) pattern: Option<Spanned<String>>,
    pub(crate) baud: Option<Spanned<i64>>,
    pub(crate) parity: Option<Spanned<String>>,
    pub(crate) reply_delay: Option<Spanned<String>>,
    #[serde(rename = "for")]
    pub(crate) lasts: Option<Spanned<String>>,
}
