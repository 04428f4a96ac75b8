//! What `systembus` planned and computed.

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
