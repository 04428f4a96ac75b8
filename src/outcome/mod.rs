//! What a verb found, and what happens on the way: plain types for JSON, CSV and tables.
//!
//! The shapes here are the contract with scripts ([`SCHEMA_VERSION`]); `antrieb schema` prints them. Texts are in the
//! language that the user chose; numbers, slugs and codes are the same in every language.

mod bus_watch;
mod document;
mod errors;
mod found;
mod import;
mod line;
mod motion;
mod offline;
mod over_lines;
mod paramfile;
mod plant;
mod plot;
mod procedure;
mod profibus;
mod relocation;
mod report;
mod stream;
mod systembus;
mod transfer;
mod value;

pub use bus_watch::{BusMonitor, BusOrdered, BusOrders, HeardEmergency, HeardOnBus, HeardPlace, HeardTaker};
pub use document::{
    Document, Envelope, LineChecks, OrBus, OrLine, OrListed, OrLive, OrLoad, OrMotion, OrPlan, OrRead, OrRecord,
    OrWrite,
};
pub use found::{
    Bucket, BusDiagnosis, Counter, Diag, Diagnosis, Evidence, FoundDrive, Identify, Identity, LinkTest, Module, Scan,
    Search, SearchNews,
};
pub use import::{Export, Import, ImportColumn, ImportRow, ListOr, RowLeftOut};
pub use line::{Adapter, AdapterErrors, Advice, CheckedDrive, LineCheck, Pauses};
pub use motion::{
    Change, Motion, Setpoint, SetpointReport, Sollwert, StateReport, StateRow, Statemachine, Step, Stop, Stopped, Stops,
};
pub use offline::{CanDoc, ChoiceDoc, Decode, Field, GapStatistics, ParamDoc, Params, Parts, Simulate, TelegramDoc};
pub use over_lines::{OnLine, OrLines, OverLines, Unreached};
pub use paramfile::{Comparison, Comparisons, Difference, LeftOut, OrFile, SavedFile, Saves, Side};
pub use plant::{Init, NamedFind, Plant, PlantCheck, PlantComparison, PlantDrive, PlantState};
pub use plot::{Plot, PlotCurve, PlotGap, PlotMark, PlotResponse};
pub use procedure::{
    Answered, GivenValue, KeptStep, Left, Lent, Procedure, ProcedureRecord, ProcedureStep, ProcedureTold, Procedures,
    StepFate, Stored,
};
pub use profibus::{Answers, BasicModule, LiveList, LiveStation, SlaveDiagnosis, StationChange, StationNews};
pub use relocation::{Moves, Place, Relocation, RelocationResult, RelocationStep, StepResult};
pub use report::{Form, Logo, Report, ReportedDrive};
pub use stream::{
    Before, Column, LineNews, Monitor, PortChange, Record, Repeats, RunKeys, RunNews, Sample, SampleValue, Sniff,
    SniffCount, SniffSearch, SniffSummary, SniffedStation, StreamEnd, StreamStart, StreamSummary, TriggerNews, Trip,
    Waits, WatchedDrive,
};
pub use systembus::{
    BusChannel, BusCharge, BusDrive, BusLink, BusLoad, BusNode, BusPlace, BusPlan, BusRate, BusReceiver, BusRelation,
    BusRemark, BusSetting, BusShow, BusTotal,
};
pub use transfer::{
    Dataset, DatasetRow, Datasets, Load, LoadEnd, NotLoaded, NotLoadedWhy, Plan, Read, Write, WriteResult, Written,
};
pub use value::{Bit, Decimal, Fault, Register, State, Value, Word, numbered};

use crate::failure::Failure;
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;
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
    /// Whether it tells of a run that could turn a shaft.
    pub fn is_run(&self) -> bool {
        matches!(self.data, Some(Data::Motion(_) | Data::Stops(_)))
    }
}

impl Outcome {
    /// Whether it tells of values that were written, or tried.
    pub fn has_written(&self) -> bool {
        match &self.data {
            Some(Data::Write(write)) => !write.dry_run && !write.values.is_empty(),
            Some(Data::Dataset(dataset)) => !dataset.dry_run && !dataset.written.is_empty(),
            Some(Data::Datasets(datasets)) => datasets.drives.iter().any(|one| !one.dry_run && !one.written.is_empty()),
            Some(Data::Load(load)) => !load.dry_run && !load.values.is_empty(),
            Some(Data::Plant(plant)) => {
                use PlantState::{Planned, Same, Skipped};
                plant.drives.iter().any(|one| !matches!(one.state, Same | Planned | Skipped))
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
    pub message: Text,
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
    Dataset(Box<Dataset>),
    /// The same of several drives
    Datasets(Datasets),
    /// `dataset load`, `dataset undo`
    Load(Load),
    /// `dataset save`
    Saves(Saves),
    /// `dataset check`, `dataset diff` of files
    Comparisons(Comparisons),
    /// `plan`, `apply`, `dataset load` of several drives
    Plant(Plant),
    /// `check`
    PlantCheck(PlantCheck),
    /// `init`
    Init(Init),
    /// `diag`
    Diag(Diag),
    /// `diag line`
    LineCheck(LineCheck),
    /// `statemachine`
    Statemachine(Statemachine),
    /// `sollwert`
    Sollwert(Sollwert),
    /// `params`
    Params(Params),
    /// `params import`
    Import(Box<Import>),
    /// `params export`
    Export(Export),
    /// `profibus live`
    LiveList(LiveList),
    /// `profibus module`
    BasicModule(BasicModule),
    /// `decode`
    Decode(Decode),
    /// `sniff`
    Sniff(Sniff),
    /// `simulate`
    Simulate(Simulate),
    /// `plot`
    Plot(Plot),
    /// `report`
    Report(Box<Report>),
    /// `procedure`
    Procedure(Box<Procedure>),
    /// `procedure list`
    Procedures(Procedures),
    /// `systembus plan`
    BusPlan(Box<BusPlan>),
    /// `systembus load`
    BusLoad(BusLoad),
    /// `systembus show`
    BusShow(BusShow),
    /// `systembus monitor`, behind its stream
    BusMonitor(Box<BusMonitor>),
    /// `systembus nmt`
    BusOrders(BusOrders),
    /// `monitor`, behind its stream
    Monitor(Monitor),
    /// `--dry-run` of a verb that reads
    Plan(Plan),
    /// `statemachine enable`, `sollwert 25Hz` …
    Motion(Motion),
    /// `statemachine quick-stop` of several drives
    Stops(Stops),
    /// `protocol set`, `line set`
    Relocation(Relocation),
    /// Whatever reads, of drives on several lines
    #[schemars(skip)]
    OverLines(OverLines),
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
        meaning: Text,
    },
    /// So much is done.
    Progress {
        /// Steps done.
        done: u64,
        /// Steps in all.
        total: u64,
        /// What is being tried.
        what: Text,
    },
    /// One of several searches that run at once has come so far.
    Search {
        /// Port.
        port: String,
        /// Steps done.
        done: u64,
        /// Steps in all.
        total: u64,
        /// What is being tried.
        what: Text,
    },
    /// A search for the setting of a line has come so far.
    Sought(Box<SearchNews>),
    /// A drive was found.
    Found(Box<FoundDrive>),
    /// For people, on the way.
    Note(Text),
    /// The same, and it belongs into the report as well.
    Warned(Warning),
    /// A line of a stream: data, as it comes.
    Record(Box<Record>),
}

/// An address as it is typed, with a node of the system bus behind it: `3`, `3.17`.
pub fn addressed(address: u8, node: u8) -> String {
    if node == 0 { address.to_string() } else { format!("{address}.{node}") }
}

/// Node 0 is the drive itself, and not told.
fn is_zero(node: &u8) -> bool {
    *node == 0
}

/// A failure in JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ErrorDoc {
    /// Decides the exit code.
    pub class: crate::failure::Class,
    /// Stable and dotted.
    pub code: String,
    /// For people.
    pub message: Text,
    /// What to do next.
    pub hint: Option<Text>,
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
            message: failure.told(),
            hint: failure.hint.as_deref().cloned(),
            exit: failure.class.exit(),
            context: failure.context.iter().map(|(key, value)| ((*key).to_owned(), value.clone())).collect(),
        }
    }
}
