//! Curves over time: what they come to between two markers, how a drive follows its setpoint, and a picture of them. Knows
//! numbers and texts; neither drives nor files.

mod measure;
mod picture;
mod thin;
mod ticks;

pub use measure::{Response, Statistics, responses, statistics};
pub use picture::picture;

use crate::text::{Lang, Text};

/// A value over time.
#[derive(Clone, Debug)]
pub struct Curve {
    /// What it is called.
    pub name: Text,
    /// Unit; empty where there is none.
    pub unit: String,
    /// What it is to the drive.
    pub part: Part,
    /// Seconds and values, in the order of time; no value where there is a gap.
    pub points: Vec<(f64, Option<f64>)>,
}

/// What a curve is to a drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// What it shall do.
    Setpoint,
    /// What it does.
    Actual,
    /// Its current.
    Current,
    /// Anything else.
    Other,
}

/// A state of the drive, from one moment to another, in seconds.
#[derive(Clone, Debug)]
pub struct Stretch {
    /// From then on.
    pub from: f64,
    /// Until then.
    pub to: f64,
    /// Its name.
    pub name: Text,
    /// It is a fault.
    pub is_fault: bool,
}

/// A moment.
#[derive(Clone, Debug)]
pub struct Mark {
    /// Seconds.
    pub t: f64,
    /// What it is.
    pub kind: MarkKind,
    /// What is said of it.
    pub text: Text,
}

/// What a moment is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MarkKind {
    /// A trigger came true.
    Trigger,
    /// The drive went into a fault.
    Fault,
    /// The end of a run: from then on nobody follows a setpoint.
    Stop,
}

/// Everything that a picture shows.
#[derive(Clone, Debug)]
pub struct Scene {
    /// What stands above it.
    pub title: String,
    /// What its horizontal axis is, with the unit: time in seconds.
    pub across: Text,
    /// The curves, of at most two units.
    pub curves: Vec<Curve>,
    /// The states, in the order of time.
    pub states: Vec<Stretch>,
    /// The moments.
    pub marks: Vec<Mark>,
    /// From when to when nothing was answered, in seconds.
    pub gaps: Vec<(f64, f64)>,
    /// Where the horizontal axis begins, in its unit.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The language of the picture.
    pub lang: Lang,
}

impl Scene {
    /// The units, that of the left axis first.
    pub fn units(&self) -> Vec<&str> {
        let mut units: Vec<&str> = Vec::new();
        for curve in &self.curves {
            if !units.contains(&curve.unit.as_str()) {
                units.push(&curve.unit);
            }
        }
        units
    }
}
