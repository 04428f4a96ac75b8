//! What a verb found, and what happens on the way: plain types for JSON, CSV and tables.
//!
//! The shapes here are the contract with scripts ([`SCHEMA_VERSION`]); `antrieb schema` prints them. Texts are in the
//! language that the user chose; numbers, slugs and codes are the same in every language.

use crate::failure::Failure;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Version of the JSON shapes.
pub const SCHEMA_VERSION: u32 = 1;

/// What a verb found.
#[derive(Debug, Default)]
pub struct Outcome {
    /// The findings; also partial ones beside a failure.
    pub data: Option<Data>,
    /// Remarks that do not stand in the way.
    pub warnings: Vec<Warning>,
    /// Why it is not all that was asked for.
    pub failure: Option<Failure>,
}

impl Outcome {
    /// Findings without remarks.
    pub fn of(data: Data) -> Self {
        Outcome { data: Some(data), ..Outcome::default() }
    }
}

impl Outcome {
    /// Whether a shaft may still turn that was to be stopped.
    pub fn leaves_danger(&self) -> bool {
        match &self.data {
            Some(Data::Motion(motion)) => {
                self.failure.is_some() && motion.stop.as_ref().is_none_or(|stop| !stop.acknowledged)
            }
            _ => false,
        }
    }
}

impl From<Failure> for Outcome {
    fn from(failure: Failure) -> Self {
        Outcome { failure: Some(failure), ..Outcome::default() }
    }
}

/// A remark.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Warning {
    /// Stable and dotted.
    pub code: String,
    /// For people.
    pub message: String,
}

/// The findings of every verb.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum Data {
    /// `scan`
    Scan(Scan),
    /// `identify`
    Identify(Identify),
    /// `read`
    Read(Read),
    /// `write`
    Write(Write),
    /// `dataset show`, `dataset copy` …
    Dataset(Dataset),
    /// `diag`
    Diag(Diag),
    /// `statemachine`
    Statemachine(Statemachine),
    /// `sollwert`
    Sollwert(Sollwert),
    /// `params`
    Params(Params),
    /// `decode`
    Decode(Decode),
    /// `simulate`
    Simulate(Simulate),
    /// `monitor`, behind its stream
    Monitor(Monitor),
    /// `--dry-run` of a verb that reads
    Plan(Plan),
    /// `statemachine enable`, `sollwert 25Hz` …
    Motion(Motion),
}

/// Something that happens while a verb works.
#[derive(Clone, Debug)]
pub enum Event {
    /// A telegram went over the line; for `-v`.
    Telegram {
        /// Microseconds since the port was opened.
        at_us: u64,
        /// `>` sent, `<` received, `~` stray or garbage.
        direction: char,
        /// The bytes.
        hex: String,
        /// What they say.
        meaning: String,
    },
    /// So much is done.
    Progress {
        /// Steps done.
        done: u64,
        /// Steps in all.
        total: u64,
        /// What is being tried.
        what: String,
    },
    /// A drive was found.
    Found(FoundDrive),
    /// For people, on the way.
    Note(String),
    /// A line of a stream: data, as it comes.
    Record(Box<Record>),
}

/// An integer with a count of decimals; a JSON number, exact to its decimals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decimal {
    /// The value without its decimal point.
    pub raw: i64,
    /// Places behind the point.
    pub decimals: u8,
}

impl Serialize for Decimal {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.decimals == 0 {
            return serializer.serialize_i64(self.raw);
        }
        // Divided, not multiplied by 0.1…: the quotient is the float nearest to the decimal number.
        serializer.serialize_f64(self.raw as f64 / 10f64.powi(self.decimals.into()))
    }
}

impl JsonSchema for Decimal {
    fn schema_name() -> Cow<'static, str> {
        "Decimal".into()
    }
    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({ "type": "number" })
    }
}

/// A value of a parameter in one data set.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Value {
    /// Address of the drive.
    pub address: u8,
    /// Family: `act`, `acu` …
    pub drive: String,
    /// Parameter number.
    pub param: u32,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
    /// Data set, 0-4.
    pub data_set: u8,
    /// `eeprom` or `ram`.
    pub store: &'static str,
    /// The value without its decimal point; null if it could not be read.
    pub raw: Option<i64>,
    /// The value; null if it could not be read, or if nobody knows its decimals.
    pub value: Option<Decimal>,
    /// Places behind the point, where a source tells them.
    pub decimals: Option<u8>,
    /// Unit.
    pub unit: Option<String>,
    /// What the value stands for, where a table says so.
    pub text: Option<String>,
    /// The bits, if the parameter is a word.
    pub word: Option<Word>,
    /// `uint`, `int`, `word`, `long`.
    #[serde(rename = "type")]
    pub kind: Option<&'static str>,
    /// Which catalogue the facts come from.
    pub origin: String,
    /// Facts of the catalogue that no second source confirms.
    pub unconfirmed: Vec<String>,
    /// Why it could not be read.
    pub error: Option<ErrorDoc>,
    /// Shown in hexadecimal by habit.
    #[serde(skip)]
    pub hex: bool,
}

/// A word of bits.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Word {
    /// As a number.
    pub raw: u32,
    /// As `0x0237`.
    pub hex: String,
    /// Every named bit, and every set bit without a name.
    pub bits: Vec<Bit>,
    /// Set bits that nobody defined.
    pub unknown: Vec<u8>,
    /// The state that the word means, if it is a status word.
    pub state: Option<State>,
}

/// A bit of a word.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Bit {
    /// Number, from 0.
    pub bit: u8,
    /// Whether it is set.
    pub set: bool,
    /// Stable name; null if nobody defined it.
    pub slug: Option<String>,
    /// Name in the chosen language.
    pub name: Option<String>,
    /// What it means and what to do.
    pub help: Option<String>,
}

/// A state of the drive.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct State {
    /// Stable name; `unknown` if the word means none.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
}

/// A failure in JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ErrorDoc {
    /// Decides the exit code.
    pub class: crate::failure::Class,
    /// Stable and dotted.
    pub code: String,
    /// For people.
    pub message: String,
    /// What to do next.
    pub hint: Option<String>,
    /// Exit code of the process for this failure.
    pub exit: u8,
    /// Facts for machines.
    pub context: BTreeMap<String, String>,
}

impl From<&Failure> for ErrorDoc {
    fn from(failure: &Failure) -> Self {
        ErrorDoc {
            class: failure.class,
            code: failure.code.clone(),
            message: failure.message.clone(),
            hint: failure.hint.clone(),
            exit: failure.class.exit(),
            context: failure.context.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect(),
        }
    }
}

/// Result of `scan`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Scan {
    /// Port that was searched.
    pub port: String,
    /// Line setting that was used.
    pub line: String,
    /// Protocol that was used.
    pub protocol: &'static str,
    /// How many addresses were to be asked.
    pub addresses: usize,
    /// How many were asked.
    pub asked: usize,
    /// Whether every address was asked.
    pub complete: bool,
    /// What answered.
    pub drives: Vec<FoundDrive>,
}

/// Something that answered a scan.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct FoundDrive {
    /// Address.
    pub address: u8,
    /// Family, or `unknown`.
    pub drive: String,
    /// Title of the family, or what answered in its place.
    pub title: String,
    /// What the device answered that tells the family.
    pub evidence: Vec<Evidence>,
    /// State, if it is a drive that we know.
    pub state: Option<State>,
    /// Active fault, if there is one.
    pub fault: Option<String>,
}

/// One thing that tells a family.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Evidence {
    /// What was asked.
    pub asked: String,
    /// What came.
    pub answered: String,
    /// What it tells.
    pub tells: String,
}

/// Result of `identify`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Identify {
    /// One entry a drive.
    pub drives: Vec<Identity>,
}

/// What can be told of one drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Identity {
    /// Address.
    pub address: u8,
    /// Family, or `unknown`.
    pub drive: String,
    /// Title of the family.
    pub title: String,
    /// What the device answered that tells the family.
    pub evidence: Vec<Evidence>,
    /// Option modules that answered, and those that did not.
    pub modules: Vec<Module>,
    /// Settings that matter for talking to it.
    pub values: Vec<Value>,
    /// Why it could not be identified.
    pub error: Option<ErrorDoc>,
}

/// An option module.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Module {
    /// Name.
    pub name: String,
    /// Whether its parameters answer.
    pub present: bool,
    /// How that was found out.
    pub evidence: String,
}

/// Result of `read`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Read {
    /// One entry a value.
    pub values: Vec<Value>,
}

/// Result of `write` and of everything else that writes.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Write {
    /// Whether nothing was sent.
    pub dry_run: bool,
    /// One entry a value.
    pub values: Vec<Written>,
}

/// A value that was, or would be, written.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Written {
    /// Address of the drive; 0 is a broadcast.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Parameter number.
    pub param: u32,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
    /// Data set, 0-4.
    pub data_set: u8,
    /// `eeprom` or `ram`.
    pub store: &'static str,
    /// Raw value before; null if it could not be read.
    pub old_raw: Option<i64>,
    /// Value before.
    pub old: Option<Decimal>,
    /// Raw value asked for.
    pub raw: i64,
    /// Value asked for.
    pub value: Decimal,
    /// Unit.
    pub unit: Option<String>,
    /// What the new value stands for.
    pub text: Option<String>,
    /// What became of it.
    pub result: WriteResult,
    /// The telegram that was, or would be, sent.
    pub telegram: Option<String>,
    /// What the telegram says.
    pub meaning: Option<String>,
    /// When it takes effect, if not at once.
    pub note: Option<String>,
    /// Why it was not written.
    pub error: Option<ErrorDoc>,
}

/// What became of a write.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum WriteResult {
    /// Echoed and read back.
    Verified,
    /// Echoed; cannot be read back.
    Written,
    /// The drive has this value already; nothing was sent.
    Unchanged,
    /// A dry run: nothing was sent.
    Planned,
    /// The drive, or we, refused.
    Refused,
    /// The reply is missing and the value could not be read back.
    Unknown,
    /// The drive took the telegram but reads back another value.
    Differs,
    /// Sent to everybody; nobody answers a broadcast.
    Broadcast,
    /// Not tried, because something before it failed.
    Skipped,
}

/// What a verb did that can turn a shaft.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Motion {
    /// Address of the drive.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// What was asked for: `enable`, `quick-stop`, `sollwert` …
    pub action: String,
    /// State before.
    pub from: Option<State>,
    /// State at the end.
    pub to: Option<State>,
    /// Transitions that were walked, in order.
    pub steps: Vec<Step>,
    /// Setpoint that was given.
    pub setpoint: Option<Setpoint>,
    /// Settings that were changed for the run, and given back.
    pub changed: Vec<Change>,
    /// The drive's own watchdog in seconds; 0 is off, null could not be read.
    pub watchdog_s: Option<i64>,
    /// The stop at the end, if one was needed.
    pub stop: Option<Stop>,
    /// Whether the drive keeps running now that the program leaves; null if that is not known.
    pub running: Option<bool>,
    /// What is worth knowing besides.
    pub notes: Vec<String>,
}

/// A transition that was walked.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Step {
    /// Number in the manual.
    pub transition: String,
    /// Command; null if the drive goes by itself.
    pub command: Option<String>,
    /// Control word that was written, as `0x000F`.
    pub control: Option<String>,
    /// State that was reached.
    pub state: State,
    /// How long it took.
    pub took_ms: u64,
}

/// A setpoint that was given.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Setpoint {
    /// Parameter that it was written to.
    pub param: u32,
    /// Last value.
    pub value: Decimal,
    /// Unit.
    pub unit: String,
    /// How often a value was written.
    pub writes: u64,
    /// Whether the drive reports it as reached; null if nobody waited.
    pub reached: Option<bool>,
    /// Actual value at the end.
    pub actual: Option<Decimal>,
}

/// A setting that was changed for a run.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Change {
    /// Parameter number.
    pub param: u32,
    /// Data set, 0-4; always in RAM.
    pub data_set: u8,
    /// Raw value before.
    pub old: i64,
    /// Raw value during the run.
    pub new: i64,
    /// Whether the old value stands again.
    pub restored: bool,
}

/// The stop at the end of a run.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Stop {
    /// `ramp`, `quick-stop`, `coast`, `keep`.
    pub choice: &'static str,
    /// Why: `end`, `interrupted`, `error`.
    pub because: &'static str,
    /// Whether the drive's state proves that it was obeyed.
    pub acknowledged: bool,
    /// State that was seen last.
    pub state: Option<State>,
    /// What stops the drive if the line is dead.
    pub note: Option<String>,
}

/// A line of a stream: of `monitor`. Times are seconds since the port was opened, by the clock of the line.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum Record {
    /// What is going to be watched; the first line.
    Start(StreamStart),
    /// The values of one drive in one round.
    Sample(Sample),
    /// The port was lost; the samples until `reopened` are gaps.
    Lost(PortChange),
    /// The port is back.
    Reopened(PortChange),
    /// What would be sent, under `--dry-run`.
    Telegram(TelegramDoc),
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
    /// Line setting.
    pub line: String,
    /// Protocol.
    pub protocol: &'static str,
    /// Seconds from round to round; 0 is as fast as the line allows.
    pub interval: Decimal,
    /// One entry a drive.
    pub drives: Vec<WatchedDrive>,
}

/// A drive that is watched.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct WatchedDrive {
    /// Address.
    pub address: u8,
    /// Family; `unknown` as long as the drive does not answer.
    pub drive: String,
    /// Title of the family.
    pub title: Option<String>,
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
    /// `eeprom` or `ram`.
    pub store: &'static str,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
    /// Unit.
    pub unit: Option<String>,
    /// What the parameter is to the drive, if it is one that every family has: `status-word`, `setpoint-ramp` …
    pub role: Option<&'static str>,
    /// Whether raw values can be turned into values; otherwise nobody knows the decimals.
    pub scaled: bool,
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

/// The values of one drive in one round.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Sample {
    /// Seconds, when the round came to this drive.
    pub t: Decimal,
    /// Number of the round, from 0.
    pub n: u64,
    /// Address.
    pub address: u8,
    /// Family; `unknown` as long as the drive does not answer.
    pub drive: String,
    /// State, if the status word is watched.
    pub state: Option<State>,
    /// The values; null with an error where there is a gap. Bits come without their help, which `params` shows.
    pub values: Vec<SampleValue>,
    /// Why the whole sample is a gap.
    pub error: Option<ErrorDoc>,
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
    pub summary: Option<Monitor>,
    /// Remarks.
    pub warnings: Vec<Warning>,
    /// Why it is not all that was asked for.
    pub error: Option<ErrorDoc>,
}

/// What `monitor` streamed.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Monitor {
    /// Why it ended: `count`, `duration`, `interrupted`, `lost`, `no_drive`.
    pub because: &'static str,
    /// Seconds from the start to the end.
    pub t: Decimal,
    /// Rounds.
    pub rounds: u64,
    /// Samples, gaps among them.
    pub samples: u64,
    /// Samples that are gaps.
    pub gaps: u64,
}

/// What a verb that reads would send, under `--dry-run`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Plan {
    /// True: nothing was opened, nothing was sent.
    pub dry_run: bool,
    /// The telegrams, as far as they do not depend on answers.
    pub telegrams: Vec<TelegramDoc>,
}

/// Result of `dataset`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Dataset {
    /// Address of the drive.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Data set that the drive works with (P.249).
    pub active: Option<i64>,
    /// How it is selected (P.414).
    pub selection: Option<Value>,
    /// Parameters beside each other.
    pub rows: Vec<DatasetRow>,
    /// Values that were, or would be, written.
    pub written: Vec<Written>,
    /// Whether nothing was sent.
    pub dry_run: bool,
}

/// A parameter in several data sets.
#[derive(Debug, Serialize, JsonSchema)]
pub struct DatasetRow {
    /// Parameter number.
    pub param: u32,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
    /// Unit.
    pub unit: Option<String>,
    /// Whether the values are the same.
    pub equal: bool,
    /// One value a data set.
    pub values: Vec<Value>,
}

/// Result of `diag`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Diag {
    /// One entry a drive.
    pub drives: Vec<Diagnosis>,
}

/// What ails a drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Diagnosis {
    /// Address.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Whether neither fault nor warning is present.
    pub healthy: bool,
    /// Status word with its state.
    pub status: Option<Word>,
    /// Value of the fault parameter; null if it could not be read, 0 if there is no fault.
    pub fault_code: Option<i64>,
    /// Active fault; null if there is none, or if it could not be read.
    pub fault: Option<Fault>,
    /// Warning word.
    pub warnings: Option<Word>,
    /// Error register, as it stood before this command asked anything; reading clears it.
    pub error_register: Option<Register>,
    /// Diagnostic counters.
    pub counters: Vec<Counter>,
    /// Whether the counters were set to zero.
    pub counters_cleared: bool,
    /// Result of the link test.
    pub link: Option<LinkTest>,
    /// Why it could not be diagnosed.
    pub error: Option<ErrorDoc>,
}

/// A fault.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Fault {
    /// Value of the fault parameter.
    pub code: u32,
    /// As the drive displays it.
    pub key: String,
    /// Group in the chosen language.
    pub group: Option<String>,
    /// Name in the chosen language.
    pub name: String,
    /// What causes it.
    pub cause: Option<String>,
    /// What to do.
    pub remedy: Option<String>,
    /// Node that is meant, if the code carries one.
    pub node: Option<u32>,
}

/// A code of the error register.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Register {
    /// Code.
    pub code: u32,
    /// Stable name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
    /// What to do.
    pub hint: Option<String>,
}

/// A diagnostic counter.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Counter {
    /// Sub-function of code 8.
    pub sub: u16,
    /// Stable name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
    /// Count; null if it could not be read.
    pub count: Option<u16>,
    /// What it counts and what a high value means.
    pub help: String,
}

/// Result of a link test.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LinkTest {
    /// Questions asked.
    pub asked: u64,
    /// Good replies.
    pub replies: u64,
    /// Questions without a reply.
    pub silent: u64,
    /// Questions answered by garbage.
    pub garbled: u64,
    /// Telegrams that belonged to no question.
    pub strays: u64,
    /// Share of questions that failed, in percent.
    pub error_rate_percent: f64,
    /// Shortest time from the end of a request to the last byte of its reply.
    pub fastest_us: Option<u64>,
    /// Half of the replies were faster.
    pub median_us: Option<u64>,
    /// 95 of 100 replies were faster.
    pub p95_us: Option<u64>,
    /// Longest time.
    pub slowest_us: Option<u64>,
}

/// Result of `statemachine show`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Statemachine {
    /// One entry a drive.
    pub drives: Vec<StateReport>,
}

/// State of one drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct StateReport {
    /// Address.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// State of the status word.
    pub state: Option<State>,
    /// Status word bit by bit.
    pub status: Option<Word>,
    /// Control word as last written, bit by bit, if it can be read.
    pub control: Option<Word>,
    /// How the drive is controlled (P.412).
    pub control_mode: Option<Value>,
    /// Value of the fault parameter; null if it could not be read, 0 if there is no fault.
    pub fault_code: Option<i64>,
    /// Active fault; null if there is none, or if it could not be read.
    pub fault: Option<Fault>,
    /// What keeps the drive from running by the control word, and how one sees it.
    pub missing: Vec<String>,
    /// The map of the state machine.
    pub states: Vec<StateRow>,
    /// Why it could not be read.
    pub error: Option<ErrorDoc>,
}

/// A state and where it leads.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct StateRow {
    /// Stable name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: String,
    /// Whether the drive is in it.
    pub present: bool,
    /// Transitions with their number, command and goal.
    pub leads: Vec<String>,
}

/// Result of `sollwert` without a value.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Sollwert {
    /// One entry a drive.
    pub drives: Vec<SetpointReport>,
}

/// Setpoints and actual values of one drive.
#[derive(Debug, Serialize, JsonSchema)]
pub struct SetpointReport {
    /// Address.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Setpoints.
    pub setpoints: Vec<Value>,
    /// Actual values.
    pub actual: Vec<Value>,
    /// What decides how the setpoint is formed.
    pub sources: Vec<Value>,
    /// Why it could not be read.
    pub error: Option<ErrorDoc>,
}

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
    pub name: String,
    /// Unit.
    pub unit: Option<String>,
    /// Data type, where a source tells it.
    #[serde(rename = "type")]
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
    /// A remark.
    pub note: Option<String>,
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
    pub text: String,
}

/// Result of `decode`.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Decode {
    /// `telegram`, `status`, `control`, `warnings`, `fault`, `error`.
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
}

/// A telegram taken apart.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct TelegramDoc {
    /// Microseconds since the start of the recording, if it is from one.
    pub at_us: Option<u64>,
    /// `rtu` or `ascii`.
    pub protocol: &'static str,
    /// `request`, `reply`, or null if it could be either.
    pub direction: Option<&'static str>,
    /// Address of the slave; 0 is a broadcast.
    pub address: Option<u8>,
    /// Function code, without the exception bit.
    pub function: Option<u8>,
    /// Whether the check value is right.
    pub check_ok: bool,
    /// The bytes.
    pub hex: String,
    /// What it says.
    pub meaning: String,
    /// Field by field.
    pub fields: Vec<Field>,
}

/// A field of a telegram.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Field {
    /// Its bytes.
    pub hex: String,
    /// What it is.
    pub name: String,
    /// What it says.
    pub value: String,
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
    /// What the judge noted about the master.
    pub remarks: Vec<String>,
}
