//! What `plot` drew and measured.

use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `plot`. Times are seconds of the record; of the characteristic of an analog input they are volts.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Plot {
    /// The record, or the parameter file.
    pub file: String,
    /// The picture that was written.
    pub svg: Option<String>,
    /// Address of the drive; 0 where a parameter file names none.
    pub address: u8,
    /// Family.
    pub drive: String,
    /// Unit of the horizontal axis: `s`, `V`.
    pub across: &'static str,
    /// What was drawn begins here, in the unit of `across`.
    pub from: f64,
    /// It ends here, in the unit of `across`.
    pub to: f64,
    /// What was drawn.
    pub curves: Vec<PlotCurve>,
    /// How the actual value followed each change of the setpoint; null without --measure.
    pub responses: Option<Vec<PlotResponse>>,
    /// Triggers and faults.
    pub marks: Vec<PlotMark>,
    /// When nothing was answered.
    pub gaps: Vec<PlotGap>,
    /// What of it cannot be told from this record.
    pub notes: Vec<Text>,
}

/// A curve. What it comes to is in its unit, and null without --measure, and where it has no value.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlotCurve {
    /// Name of the column.
    pub column: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Unit; null where there is none.
    pub unit: Option<String>,
    /// `setpoint`, `actual`, `current`, `other`.
    pub part: &'static str,
    /// `left`, `right`.
    pub axis: &'static str,
    /// How many values it has.
    pub samples: u64,
    /// Smallest value.
    pub min: Option<f64>,
    /// Largest value.
    pub max: Option<f64>,
    /// Mean over time.
    pub mean: Option<f64>,
    /// Effective value: root of the mean of the squares over time.
    pub rms: Option<f64>,
    /// Its lines from gap to gap, for a terminal.
    #[serde(skip)]
    pub lines: Vec<Vec<(f64, f64)>>,
}

/// How the actual value followed a change of the setpoint. What cannot be told is null.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlotResponse {
    /// Seconds of the record at which the setpoint was seen to change first.
    pub t: f64,
    /// The setpoint before it, in `unit`.
    pub from: f64,
    /// The setpoint behind it, in `unit`.
    pub to: f64,
    /// Unit of setpoints and actual values; null where there is none.
    pub unit: Option<String>,
    /// The actual value at the beginning, in `unit`.
    pub start: f64,
    /// The actual value at the end, in `unit`: before the next change, or of the record.
    pub end: f64,
    /// By how much it went beyond its end, in percent of its way.
    pub overshoot_percent: Option<f64>,
    /// Seconds until it stays near its end.
    pub settling_s: Option<f64>,
    /// Slope between a tenth and nine tenths of its way, in units a second.
    pub slope: Option<f64>,
    /// Seconds until the line of that slope leaves the beginning.
    pub dead_time_s: Option<f64>,
}

/// A moment.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlotMark {
    /// When it was, in the unit of `across`.
    pub t: f64,
    /// `trigger`, `fault`, `stop`; `zero` where the setpoint of an analog input is zero.
    pub kind: &'static str,
    /// What it was.
    pub text: Text,
}

/// A time without answers.
#[derive(Debug, Serialize, JsonSchema)]
pub struct PlotGap {
    /// Seconds of the last answer before it.
    pub from: f64,
    /// Seconds of the first one behind it, or of the end of the record.
    pub to: f64,
}
