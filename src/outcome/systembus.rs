//! What `systembus` planned, computed and read.

use super::{ErrorDoc, Value};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `systembus load`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusLoad {
    /// What one PDO costs, rate by rate; empty where a rate was named.
    pub rates: Vec<BusRate>,
    /// The rate that was named.
    pub rate_kbd: Option<u16>,
    /// What was to be summed up.
    pub pdos: Vec<BusCharge>,
    /// The sum; null where no rate was named.
    pub total: Option<BusTotal>,
}

/// What one PDO costs at a rate.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusRate {
    /// Bit rate in kBd.
    pub rate_kbd: u16,
    /// Longest line in metres; a guide.
    pub metres: u16,
    /// Time on the bus at worst (140 bits), in microseconds.
    pub telegram_us: u32,
    /// Share of the bus in percent, if it is sent every 1, 2, … 10 ms; to the millionth.
    pub load_percent: Vec<f64>,
    /// The same with the digits of the manual, for people.
    #[serde(skip)]
    pub shown: Vec<String>,
}

/// What a PDO costs that is sent so often.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusCharge {
    /// In milliseconds.
    pub every_ms: u32,
    /// Share of the bus in percent, to the millionth.
    pub load_percent: f64,
    /// The same for people.
    #[serde(skip)]
    pub shown: String,
}

/// What all PDOs cost together.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct BusTotal {
    /// Share of the bus in percent, to the millionth. SYNC, SDO, NMT and emergencies are not in it.
    pub load_percent: f64,
    /// Of the exact sum: `okay` up to 80 %, `critical` up to 90 %, `not_feasible`.
    pub verdict: &'static str,
    /// The sum lacks PDOs of which nobody says how often they are sent.
    pub incomplete: bool,
    /// The load for people.
    #[serde(skip)]
    pub shown: String,
}

/// Result of `systembus plan`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusPlan {
    /// What was read.
    pub files: Vec<String>,
    /// Bit rate in kBd.
    pub rate_kbd: u16,
    /// Longest line in metres; a guide.
    pub metres: u16,
    /// Identifier of SYNC.
    pub sync_identifier: u16,
    /// How often SYNC is sent, where it is said.
    pub sync_every_ms: Option<u32>,
    /// The drive that is the master, or `external`; null for none.
    pub master: Option<String>,
    /// The drives with their settings.
    pub drives: Vec<BusDrive>,
    /// Every PDO with all who hear it.
    pub relations: Vec<BusRelation>,
    /// Every virtual link, from source to parameter.
    pub links: Vec<BusLink>,
    /// What all PDOs cost together.
    pub total: BusTotal,
    /// What is forbidden, advised against, or good to know.
    pub remarks: Vec<BusRemark>,
    /// The picture that was written.
    pub svg: Option<String>,
    /// Whether a page shows the settings.
    #[serde(skip)]
    pub shows_settings: bool,
}

/// A drive of a plan.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusDrive {
    /// What it is called.
    pub name: String,
    /// P.900; 0 is the master.
    pub node: u8,
    /// Every parameter that the plan decides.
    pub settings: Vec<BusSetting>,
    /// The DCF that was written.
    pub dcf: Option<String>,
}

/// What a parameter shall be.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusSetting {
    /// Number.
    pub param: u32,
    /// Name; null where no catalogue has one.
    pub name: Option<Text>,
    /// Value; null where it depends on how the drive counts the functions of its RxPDOs.
    pub raw: Option<i64>,
    /// What the value means.
    pub text: Option<Text>,
}

/// A PDO.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusRelation {
    /// Its identifier.
    pub identifier: u16,
    /// Who sends it; null for nobody.
    pub sender: Option<String>,
    /// Which of a drive's TxPDOs.
    pub pdo: Option<u8>,
    /// Sent with SYNC.
    pub on_sync: bool,
    /// How often it is sent, where that is known.
    pub every_ms: Option<u32>,
    /// Share of the bus in percent.
    pub load_percent: Option<f64>,
    /// The same for people.
    #[serde(skip)]
    pub shown: String,
    /// Who hears it.
    pub receivers: Vec<BusReceiver>,
}

/// Who hears a PDO.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusReceiver {
    /// The drive.
    pub drive: String,
    /// Which of its RxPDOs.
    pub pdo: u8,
    /// How long it may be missing; 0 is for ever.
    pub timeout_ms: u32,
    /// Handed on with SYNC.
    pub on_sync: bool,
}

/// A virtual link; what lacks an end has nulls there.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusLink {
    /// Identifier of the PDO.
    pub identifier: u16,
    /// `word1`, `long2` …
    pub place: String,
    /// First of its bytes.
    pub first_byte: u8,
    /// Last of its bytes.
    pub last_byte: u8,
    /// Who sends.
    pub sender: Option<String>,
    /// Parameter of the sender.
    pub sender_param: Option<u32>,
    /// Source that it is set to.
    pub sender_source: Option<u16>,
    /// What that source is, where it is known.
    pub sender_source_name: Option<Text>,
    /// Who receives.
    pub receiver: Option<String>,
    /// Parameter of the receiver.
    pub receiver_param: Option<u32>,
    /// What it is called, where it is known.
    pub receiver_param_name: Option<Text>,
    /// Source that it is set to.
    pub receiver_source: Option<u16>,
}

/// What is said of a plan.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusRemark {
    /// `error`, `warning`, `note`.
    pub level: &'static str,
    /// Stable.
    pub code: &'static str,
    /// For people.
    pub message: Text,
}

/// `systembus show`: what the settings of drives come to.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusShow {
    /// A row for each drive that was asked.
    pub drives: Vec<BusNode>,
}

/// A drive on the system bus; what it did not tell is null.
#[derive(Debug, Default, Serialize, JsonSchema)]
pub struct BusNode {
    /// Address that it was asked at.
    pub address: u8,
    /// Family: `acu`; `unknown` where nobody answers.
    pub drive: String,
    /// P.900: -1 is off the bus, 0 the master.
    pub node: Option<i64>,
    /// Bit rate in kBd (P.903).
    pub rate_kbd: Option<u16>,
    /// Code of the state that it has on the bus (P.978).
    pub node_state: Option<i64>,
    /// What that is.
    pub node_state_text: Option<Text>,
    /// Code of how its controller of the bus is (P.979).
    pub can_state: Option<i64>,
    /// What that is.
    pub can_state_text: Option<Text>,
    /// Identifier of SYNC (P.918).
    pub sync_identifier: Option<u16>,
    /// How long SYNC may be missing; 0 is for ever (P.939).
    pub sync_timeout_ms: Option<u32>,
    /// How often it sends SYNC if it is the master; 0 is never (P.919).
    pub sync_every_ms: Option<u32>,
    /// How long it waits before it starts the others if it is the master (P.904).
    pub boot_up_delay_ms: Option<u32>,
    /// What it does when another one trips if it is the master (P.989).
    pub emergency_reaction: Option<Text>,
    /// Identifier of questions over SDO1 (P.921).
    pub rx_sdo1: Option<u16>,
    /// Identifier of its answers to them (P.922).
    pub tx_sdo1: Option<u16>,
    /// Whether SDO2 is there (P.923).
    pub sdo2: Option<bool>,
    /// How it counts the functions of its RxPDOs where it shows that: `0-2`; null where nothing tells.
    pub rx_functions: Option<&'static str>,
    /// PDOs that it sends.
    pub sent: Vec<BusChannel>,
    /// PDOs that it receives.
    pub received: Vec<BusChannel>,
    /// Every value as it was read.
    pub values: Vec<Value>,
    /// Why it was not asked, or told nothing.
    pub error: Option<ErrorDoc>,
}

/// A PDO of a drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusChannel {
    /// Which of its TxPDOs or RxPDOs, from 1.
    pub pdo: u8,
    /// Its identifier.
    pub identifier: Option<u16>,
    /// Code of its function.
    pub code: Option<i64>,
    /// `off`, `time`, `sync`; null where the code has two meanings.
    pub function: Option<&'static str>,
    /// How often it is sent by time, or how long it may be missing; 0 is for ever.
    pub ms: Option<u32>,
    /// What fills it, or takes from it, as far as the catalogue knows such parameters.
    pub places: Vec<BusPlace>,
}

/// What stands at a place of a PDO.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BusPlace {
    /// `word1`, `long2` …
    pub place: String,
    /// First of its bytes.
    pub first_byte: u8,
    /// Last of its bytes.
    pub last_byte: u8,
    /// Parameter that puts something there, or takes it.
    pub param: u32,
    /// What it is called.
    pub param_name: Option<Text>,
    /// Source that it is set to.
    pub source: u16,
    /// What that is, where it is known.
    pub source_name: Option<Text>,
}
