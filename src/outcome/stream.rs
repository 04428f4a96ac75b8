//! What `monitor`, `sniff`, a search for settings and a run that is held tell as it comes.

use super::{BusMonitor, Decimal, ErrorDoc, Fault, SearchNews, State, StationNews, TelegramDoc, Value, Warning};
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// A line of a stream: of `monitor`, `sniff`, or a run that is held. Times are seconds since the port was opened, by the clock of the line.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Record {
    /// What is going to be watched; the first line.
    Start(StreamStart),
    /// The values of one drive in one round.
    Sample(Sample),
    /// A trigger came true; the next sample is the one that shows it.
    Trigger(TriggerNews),
    /// A drive went into a fault, with what was seen of it last; the next sample is the one that shows it.
    Trip(Box<Trip>),
    /// Where a run that is held has come to; again whenever that changes.
    Run(RunNews),
    /// The port was lost; the samples until `reopened` are gaps.
    Lost(PortChange),
    /// The port is back.
    Reopened(PortChange),
    /// What `sniff` heard, or what would be sent, under `--dry-run`.
    Telegram(TelegramDoc),
    /// What `sniff` has counted so far.
    Statistics(SniffCount),
    /// A station of a PROFIBUS line that came, went, or is otherwise than before.
    Station(Box<StationNews>),
    /// How far a search for settings has come; what it found stands in the rows behind.
    Search(SearchNews),
    /// How it ended; the last line.
    End(StreamEnd),
}

/// What is going to be watched.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StreamStart {
    /// Seconds.
    pub t: Decimal,
    /// Version of the JSON shapes.
    pub schema: u32,
    /// `antrieb`.
    pub tool: &'static str,
    /// The verb.
    pub command: &'static str,
    /// Port.
    pub port: String,
    /// When that was, in seconds since the beginning of 1970; null on the bench, which has no time of day.
    pub begun: Option<Decimal>,
    /// Line setting.
    pub line: String,
    /// Protocol.
    pub protocol: &'static str,
    /// Seconds from round to round; 0 is as fast as the line allows, null is a round whenever one is called for (`--gather`).
    pub interval: Option<Decimal>,
    /// What is waited for; missing where nothing is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub waits: Option<Waits>,
    /// One entry a drive.
    pub drives: Vec<WatchedDrive>,
}

/// What a watch waits for.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Waits {
    /// The triggers, as they were typed; any of them will do.
    pub triggers: Vec<String>,
    /// So many seconds before a trigger are recorded.
    pub pre: Decimal,
    /// And so many behind it.
    pub post: Decimal,
    /// The first one ends the watch, so long after it.
    pub once: bool,
}

/// A trigger that came true.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct TriggerNews {
    /// Seconds: those of the sample that shows it.
    pub t: Decimal,
    /// How many there were, this one included.
    pub n: u64,
    /// Address of the drive.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// The trigger, as it was typed.
    pub trigger: String,
}

/// A drive that went into a fault.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Trip {
    /// Seconds: those of the sample that shows it.
    pub t: Decimal,
    /// Address of the drive.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// The fault; null where it is not watched.
    pub fault: Option<Fault>,
    /// What was seen last before it.
    pub before: Before,
}

/// What was seen of a drive last before a fault: of each value the last one that could be read.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Before {
    /// State, if the status word is watched.
    pub state: Option<State>,
    /// The values, each with its time.
    pub values: Vec<SampleValue>,
}

/// A drive that is watched.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct WatchedDrive {
    /// Address.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Its name in the project file.
    pub called: Option<String>,
    /// Family; `unknown` as long as the drive does not answer.
    pub drive: String,
    /// Title of the family.
    pub title: Option<Text>,
    /// The values of its samples, in their order.
    pub columns: Vec<Column>,
}

/// A value that is watched.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Column {
    /// Parameter number.
    pub param: u32,
    /// Data set, 0-4.
    pub data_set: u8,
    /// `eeprom`, `ram`, or `unknown` where no source tells whether the value outlives power-off.
    pub store: &'static str,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Unit.
    pub unit: Option<String>,
    /// What the parameter is to the drive, if it is one that every family has: `status-word`, `setpoint-ramp` …
    pub role: Option<&'static str>,
    /// Whether raw values can be turned into values; otherwise nobody knows the decimals.
    pub scaled: bool,
    /// Whether its bits have names; every value says so itself.
    #[serde(skip)]
    pub is_word: bool,
}

impl Column {
    /// Whether both are the same parameter in the same data set.
    pub fn is_of(&self, other: &Column) -> bool {
        (self.param, self.data_set, self.store) == (other.param, other.data_set, other.store)
    }

    /// Whether this is the column of a value.
    pub fn holds(&self, value: &Value) -> bool {
        (self.param, self.data_set, self.store) == (value.param, value.data_set, value.store)
    }
}

/// Where a run that is held has come to.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RunNews {
    /// Seconds.
    pub t: Decimal,
    /// Address.
    pub address: u8,
    /// `waiting` for a key to be held (`--dead-man`), `starting`, `led` along its ramp or profile, `held`, `stopping`, `ended`.
    pub phase: &'static str,
    /// Setpoint as given last; null if none was, and from the stop on.
    pub setpoint: Option<Decimal>,
    /// Its unit.
    pub unit: Option<String>,
    /// Seconds at which this part of the run ends by itself; null if it has no end.
    pub ends: Option<Decimal>,
    /// How it is stopped: `ramp`, `quick-stop`, `coast`, `keep`.
    pub stop: &'static str,
    /// What the arrows of the keypad do; null where they do nothing.
    pub keys: Option<RunKeys>,
}

/// What the arrows of the keypad do.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RunKeys {
    /// By how much a press changes the setpoint.
    pub step: Decimal,
    /// It goes no lower.
    pub min: Decimal,
    /// And no higher.
    pub max: Decimal,
    /// Unit.
    pub unit: String,
}

/// The values of one drive in one round.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Sample {
    /// Seconds, when the round came to this drive.
    pub t: Decimal,
    /// Number of the round, from 0.
    pub n: u64,
    /// Port, as it was called at the start; null in the samples of a run.
    pub port: Option<String>,
    /// Address.
    pub address: u8,
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Its name in the project file; null in the samples of a run.
    pub called: Option<String>,
    /// Family; `unknown` as long as the drive does not answer.
    pub drive: String,
    /// State, if the status word is watched.
    pub state: Option<State>,
    /// The values; null with an error where there is a gap. Bits come without their help, which `params` shows.
    pub values: Vec<SampleValue>,
    /// Why the whole sample is a gap.
    pub error: Option<ErrorDoc>,
    /// What came of the line so far; null in the samples of a run.
    pub line: Option<LineNews>,
}

/// What came of a line since the port was opened, whichever drive was asked.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LineNews {
    /// Telegrams sent, repeats included.
    pub telegrams: u64,
    /// Answers taken.
    pub replies: u64,
    /// Seconds that these were waited for, in all.
    pub waited: Decimal,
    /// Repeats.
    pub repeats: u64,
    /// Requests that nobody answered in time.
    pub silences: u64,
    /// Requests answered by garbage only.
    pub garbled: u64,
}

/// A value with its time.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SampleValue {
    /// Seconds, when the answer had come.
    pub t: Decimal,
    /// The value.
    #[serde(flatten)]
    pub value: Value,
}

/// A port that was lost or is back.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct PortChange {
    /// Seconds.
    pub t: Decimal,
    /// The port.
    pub port: String,
    /// Why it was lost.
    pub error: Option<ErrorDoc>,
}

/// How a stream ended.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StreamEnd {
    /// Seconds.
    pub t: Decimal,
    /// Version of the JSON shapes.
    pub schema: u32,
    /// `antrieb`.
    pub tool: &'static str,
    /// The verb.
    pub command: &'static str,
    /// Whether all that was asked for was done.
    pub ok: bool,
    /// What was streamed; null if nothing was.
    pub summary: Option<StreamSummary>,
    /// Remarks.
    pub warnings: Vec<Warning>,
    /// Why it is not all that was asked for.
    pub error: Option<ErrorDoc>,
}

/// What `monitor` streamed.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Monitor {
    /// Why it ended: `count`, `duration`, `trigger` (--once), `input` (--gather), `interrupted`, `lost`, `no_drive`.
    pub because: &'static str,
    /// Seconds from the start to the end.
    pub t: Decimal,
    /// Rounds.
    pub rounds: u64,
    /// Samples, gaps among them.
    pub samples: u64,
    /// Samples that are gaps.
    pub gaps: u64,
    /// Triggers that came true.
    pub triggers: u64,
    /// Seconds from round to round that were asked for; 0 is as fast as the line allows, null is a round whenever one was called for.
    pub interval: Option<Decimal>,
    /// Seconds from round to round on average; null before the second round.
    pub interval_kept: Option<Decimal>,
    /// Rounds that came later than the interval says, because the one before took so long.
    pub late: u64,
}

/// What was streamed.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum StreamSummary {
    /// `monitor`
    Monitor(Monitor),
    /// `sniff`
    Sniff(SniffSummary),
    /// `systembus monitor`
    Bus(Box<BusMonitor>),
}

/// Result of `sniff`.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Sniff {
    /// How it went.
    #[serde(flatten)]
    pub summary: SniffSummary,
    /// What was heard, in order; in a stream these are records of their own.
    pub telegrams: Vec<TelegramDoc>,
}

/// What `sniff` heard, in numbers.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SniffSummary {
    /// Why it ended: `count`, `duration`, `quiet`, `trigger` (--once), `search` (no setting was found), `interrupted`, `lost`.
    pub because: &'static str,
    /// Port.
    pub port: String,
    /// Line setting.
    pub line: String,
    /// Protocol.
    pub protocol: &'static str,
    /// What came of looking for the setting; missing where it was known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub search: Option<SniffSearch>,
    /// What was counted.
    #[serde(flatten)]
    pub count: SniffCount,
    /// What a serial adapter does not tell of a line.
    pub unseen: Text,
}

/// What came of looking for the setting of a line by listening alone.
#[derive(Clone, Copy, Debug, Default, Serialize, JsonSchema)]
pub struct SniffSearch {
    /// Whether telegrams came at one; the line setting and the protocol are those, then.
    pub found: bool,
    /// How many settings were listened to; again and again counts again and again.
    pub tried: u64,
    /// Characters that came meanwhile, whatever they were.
    pub characters: u64,
}

/// What `sniff` has counted so far, whether it was told or not.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SniffCount {
    /// Seconds since it began to listen.
    pub t: Decimal,
    /// Telegrams, disturbed ones among them.
    pub heard: u64,
    /// Of these, disturbed or no telegrams at all.
    pub garbled: u64,
    /// Share of the time in which characters were on the line, in percent.
    pub load_percent: Decimal,
    /// One entry a station that was asked or answered.
    pub stations: Vec<SniffedStation>,
}

/// What was heard of a station. Times are those of the adapter; what it handed over in one piece has none.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct SniffedStation {
    /// Address; 0 is everybody.
    pub address: u8,
    /// Requests, repeats among them.
    pub requests: u64,
    /// Replies, refusals among them.
    pub replies: u64,
    /// Requests that nobody answered before the next one, or in time.
    pub unanswered: u64,
    /// Telegrams that can be a reply that came late or the same request once more: both look alike, and none of the other counts
    /// holds them.
    pub either: u64,
    /// Replies that refuse.
    pub exceptions: u64,
    /// How many questions were asked again how often.
    pub repeats: Vec<Repeats>,
    /// Shortest time from the end of a request to the beginning of its reply.
    pub fastest_us: Option<u64>,
    /// Half of the replies were faster, to 0.1 ms.
    pub median_us: Option<u64>,
    /// Longest time.
    pub slowest_us: Option<u64>,
    /// How often something disturbed came behind a request to it.
    pub check_errors: u64,
    /// Telegrams from it or to it behind less than half the pause that must lie before them (RTU).
    pub short_pauses: u64,
}

/// So many questions were asked again so often.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Repeats {
    /// How often again: 1 is once.
    pub times: u64,
    /// Questions.
    pub questions: u64,
}
