//! What `params`, `decode` and `simulate` say.

use super::{Bit, Decimal, Fault, Register, Word};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `params`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Params {
    /// Family.
    pub drive: String,
    /// One entry a parameter.
    pub params: Vec<ParamDoc>,
}

/// A row of the catalogue.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ParamDoc {
    /// Number.
    pub param: u32,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Unit.
    pub unit: Option<String>,
    /// Data type, where a source tells it.
    #[serde(rename = "data_type")]
    pub kind: Option<&'static str>,
    /// Places behind the point, where a source tells them.
    pub decimals: Option<u8>,
    /// Lower limit.
    pub min: Option<Decimal>,
    /// Upper limit.
    pub max: Option<Decimal>,
    /// Factory setting.
    pub default: Option<Decimal>,
    /// `r`, `w`, `rw`.
    pub access: &'static str,
    /// 1 or 4, where a source tells it.
    pub data_sets: Option<u8>,
    /// Lives in RAM only.
    pub volatile: bool,
    /// Takes effect only after a reset.
    pub after_reset: bool,
    /// `motion`, `line`, `reset`.
    pub hazard: Option<&'static str>,
    /// Option module that it comes with.
    pub module: Option<String>,
    /// Values with a name.
    pub values: Vec<ChoiceDoc>,
    /// Bits with a name.
    pub bits: Vec<Bit>,
    /// Address of the option port, where a module of PROFIBUS reaches it by one as well.
    pub address: Option<u16>,
    /// A remark.
    pub note: Option<Text>,
    /// Facts that no second source confirms.
    pub unconfirmed: Vec<String>,
    /// Where the facts come from.
    pub source: String,
    /// Which catalogue.
    pub origin: String,
}

/// A value with a name.
#[derive(Debug, Serialize, JsonSchema)]
pub struct ChoiceDoc {
    /// Raw value.
    pub raw: i64,
    /// Name in the chosen language.
    pub text: Text,
}

/// Result of `decode`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Decode {
    /// `telegram`, `can`, `trace`, `status`, `control`, `warnings`, `fault`, `error`, `pkw`, `diagnosis`, `basic-status`, `basic-control`.
    pub kind: &'static str,
    /// What was given.
    pub input: String,
    /// Telegrams, in order.
    pub telegrams: Vec<TelegramDoc>,
    /// The word bit by bit.
    pub word: Option<Word>,
    /// The fault.
    pub fault: Option<Fault>,
    /// The code of the error register.
    pub register: Option<Register>,
    /// What stands in a telegram of PROFIBUS-DP, taken apart.
    pub parts: Option<Parts>,
}

/// What bytes say, as a whole and field by field.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Parts {
    /// As a whole.
    pub meaning: Text,
    /// Field by field.
    pub fields: Vec<Field>,
}

/// A telegram taken apart.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct TelegramDoc {
    /// Microseconds since the start of the recording, if it is from one.
    pub at_us: Option<u64>,
    /// `rtu`, `ascii`, `mbtcp`, `vabus`, `can`, `dp`.
    pub protocol: &'static str,
    /// `request`, `reply`, or null if it could be either.
    pub direction: Option<&'static str>,
    /// Address of the slave; 0 is a broadcast, over PROFIBUS 127.
    pub address: Option<u8>,
    /// Function code, without the exception bit.
    pub function: Option<u8>,
    /// Whether the check value is right.
    pub check_ok: bool,
    /// The bytes.
    pub hex: String,
    /// What it says.
    pub meaning: Text,
    /// Field by field.
    pub fields: Vec<Field>,
    /// Of a frame of CAN.
    #[serde(flatten)]
    pub can: Option<CanDoc>,
    /// It is a reply that refuses what was asked.
    #[serde(skip)]
    pub refuses: bool,
    /// When it came, in microseconds since the beginning of 1970, where the line has a time of day.
    #[serde(skip)]
    pub since_1970_us: Option<u64>,
}

impl TelegramDoc {
    /// One of which nothing is known but its bytes, and whether they are a telegram.
    pub(crate) fn blank(protocol: &'static str, hex: String, check_ok: bool) -> Self {
        TelegramDoc {
            at_us: None,
            protocol,
            direction: None,
            address: None,
            function: None,
            check_ok,
            hex,
            meaning: Text::default(),
            fields: Vec::new(),
            can: None,
            refuses: false,
            since_1970_us: None,
        }
    }
}

/// What only a frame of CAN has. Its node stands as `address`: 0 is everybody for NMT, else the master.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct CanDoc {
    /// Interface that it came from, where a recording tells it.
    pub interface: Option<String>,
    /// Whether this program sent it, where a recording of its own tells it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sent: Option<bool>,
    /// Its identifier; null for what was never on the bus.
    pub identifier: Option<u32>,
    /// By the predefined connection set: `nmt`, `sync`, `emergency`, `tx_pdo`, `rx_pdo`, `sdo_request`, `sdo_reply`, `boot_up`,
    /// `heartbeat`, `time`, `free`; else `remote`, `foreign` (29 bits), `adapter`, `trouble`.
    pub service: &'static str,
    /// Which PDO (1 to 4) or SDO (1, 2).
    pub channel: Option<u8>,
    /// Parameter, or index of an object.
    pub param: Option<u32>,
    /// Data set, or sub-index.
    pub data_set: Option<u8>,
    /// Value of the parameter, where its width is known; fault key of an emergency; code of an abort.
    pub raw: Option<i64>,
}

/// A field of a telegram.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Field {
    /// Its bytes.
    pub hex: String,
    /// What it is.
    pub name: Text,
    /// What it says.
    pub value: Text,
}

/// Result of `simulate`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Simulate {
    /// Where the bench could be reached.
    pub port: String,
    /// Clients that connected.
    pub clients: u64,
    /// Telegrams that the drives received.
    pub received: u64,
    /// Telegrams that they answered.
    pub answered: u64,
    /// Of these, exceptions.
    pub exceptions: u64,
    /// EEPROM cells that were written.
    pub eeprom_writes: u64,
    /// Shafts that still turn at the end, coasting ones included.
    pub turning: u64,
    /// Motors that are still powered at the end.
    pub energised: u64,
    /// Pauses that masters kept between a reply and their next telegram, up to 100 ms.
    pub gaps: GapStatistics,
    /// What the judge noted about the master.
    pub remarks: Vec<String>,
}

/// Pauses between a reply and the next telegram of a master.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct GapStatistics {
    /// How many were measured.
    pub count: u64,
    /// Of these, shorter than the station wants.
    pub early: u64,
    /// The shortest.
    pub least_us: Option<u64>,
    /// The median of the last 4096.
    pub median_us: Option<u64>,
}
