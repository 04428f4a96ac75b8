//! The JSON document around every result, and the shapes that its `data` has where a verb finds one of several things.

use super::{
    BusLoad, BusMonitor, BusOrders, BusPlan, BusShow, Datasets, ErrorDoc, LineCheck, LiveList, Load, Motion, OrLines,
    Plan, Plant, PlantCheck, Procedure, Procedures, Read, Record, Stops, Warning, Write,
};
use schemars::JsonSchema;
use serde::Serialize;

/// The document of a verb that finds `D`, for its schema.
pub type Document<D> = Envelope<'static, D>;

/// The JSON document around every result.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Envelope<'a, D> {
    /// Version of this shape.
    pub schema: u32,
    /// `antrieb`.
    pub tool: &'static str,
    /// The verb.
    pub command: &'a str,
    /// Whether all that was asked for was done.
    pub ok: bool,
    /// What was found; also partly, beside an error.
    pub data: Option<D>,
    /// Remarks.
    pub warnings: &'a [Warning],
    /// Why it is not all that was asked for.
    pub error: Option<ErrorDoc>,
}

/// What a verb that reads finds, or what it would send under `--dry-run`.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrPlan<D> {
    /// What was found.
    Found(D),
    /// What would be sent.
    Plan(Plan),
}

/// What a verb finds, or who is on a line.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrLive<D> {
    /// What was found.
    Found(D),
    /// Who is on the line.
    Live(LiveList),
}

/// What a verb finds, or what it would ask or write under `--dry-run`.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrWrite<D> {
    /// What was found.
    Found(D),
    /// What would be sent.
    Plan(Plan),
    /// What was written, or would be.
    Write(Write),
}

/// What a verb finds, what it would ask or write under `--dry-run`, or what became of a file.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrLoad<D> {
    /// What was found.
    Found(D),
    /// What would be sent.
    Plan(Plan),
    /// What was written, or would be.
    Write(Write),
    /// The same of several drives.
    Several(OrLines<Datasets>),
    /// What became of a parameter file.
    Load(Box<Load>),
    /// The same of several drives.
    Loads(Plant),
}

/// What a verb finds, what it did to the shaft, or what it would send under `--dry-run`.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrMotion<D> {
    /// What was found.
    Found(D),
    /// What the shaft did.
    Motion(Box<Motion>),
    /// What the shafts of several drives did.
    Stops(Stops),
    /// What would be sent.
    Plan(Plan),
}

/// One document, or, where a run is held, the records of `--format ndjson` while it goes on.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrRecord<D> {
    /// The document.
    Document(D),
    /// A line while the run goes on.
    Record(Box<Record>),
}

/// What ails the drives, or the line to them, or what would be asked under `--dry-run`.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrLine<D> {
    /// What was found.
    Found(D),
    /// What ails the line.
    Line(Box<LineCheck>),
    /// What ails several lines.
    Lines(OrLines<LineChecks>),
    /// What would be sent.
    Plan(Plan),
}

/// What a verb did to a drive's line, or the settings that it read.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrRead<D> {
    /// What was done.
    Done(D),
    /// The settings that were read.
    Read(OrLines<Read>),
    /// What would be sent.
    Plan(Plan),
}

/// What `systembus` finds: a plan, what PDOs cost, what drives are set to, what was compared or written.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrBus {
    /// A plan.
    Plan(Box<BusPlan>),
    /// The load.
    Load(BusLoad),
    /// What drives are set to.
    Show(OrLines<BusShow>),
    /// What was heard.
    Monitor(Box<BusMonitor>),
    /// What nodes were told.
    Orders(BusOrders),
    /// What drives have and the plan wants.
    Check(PlantCheck),
    /// What became of a plan in its drives.
    Apply(Plant),
    /// What would be sent.
    Telegrams(Plan),
}

/// What became of guided work, or what there is of it.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum OrListed {
    /// What was done.
    Done(Box<Procedure>),
    /// What there is.
    List(Procedures),
}

/// What ails several lines.
#[derive(Debug, Serialize, JsonSchema)]
pub struct LineChecks {
    /// One entry a line.
    pub lines: Vec<LineCheck>,
}
