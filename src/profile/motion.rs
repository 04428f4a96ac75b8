//! How a family is moved: who obeys the control word, what must be given before it runs, how it is stopped, and in which
//! operating modes it takes which setpoints. The `[motion]` and `[[modes]]` tables of a catalogue.

use super::machine::{Need, Takes};
use super::role::Role;
use super::row::CatalogueRow;
use crate::text::{Text, both};
use serde::Deserialize;

/// What moving a drive of this family needs besides its state machine.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MotionRules {
    /// The parameter that says who controls the drive; without one it always obeys the control word.
    pub control: Option<Control>,
    /// Command that is sent before the drive is walked up, so that no bit of an earlier run stands.
    pub begin: Option<String>,
    /// A fault cannot be reset earlier than this many seconds after it came.
    #[serde(default)]
    pub fault_lock_s: u64,
    /// What the parameter with the role `movement` is.
    pub movement: Movement,
    /// The movement is the frequency of the stator, which tells of the shaft only under power; any other always does.
    pub stator: Option<Stator>,
    /// Bit of the status word that says that the setpoint is reached, in modes that name no other.
    pub reached: u8,
    /// What must be given before the drive runs, and how it is seen.
    #[serde(default)]
    pub interlocks: Vec<Interlock>,
    /// What turns the shaft as soon as it is enabled, if it is not 0: setpoints and their sources.
    #[serde(default)]
    pub rest: Vec<Rest>,
    /// Ways to stop, for `--on-exit`.
    pub stops: Vec<StopRow>,
    /// Roles of times, in their own units, that braking may take longer.
    #[serde(default)]
    pub patience: Vec<Role>,
    /// What the watchdog does when nobody talks to the drive any more.
    pub watchdog: Text,
    /// What `sollwert` shows.
    pub show: Show,
    /// Ways to reset a fault without the control word.
    pub other_resets: Option<Text>,
    /// What can keep the drive from its setpoint.
    pub not_reached: Text,
}

/// Parameters that `sollwert` shows side by side.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Show {
    /// Setpoints.
    pub setpoints: Vec<u32>,
    /// Actual values.
    pub actual: Vec<u32>,
    /// What decides how the setpoint is formed.
    pub sources: Vec<u32>,
}

/// A setpoint, or the source of one, that may stand in a drive from before.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rest {
    /// Parameter that is set to 0.
    pub param: u32,
    /// Parameter that shows it, where it cannot be read itself; it may show more than that.
    pub shown: Option<u32>,
}

/// Who controls a drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// Value of the role `control-mode` with which the control word is obeyed.
    pub obeys: i64,
    /// Value with which the control word stands for contacts.
    pub contacts: i64,
    /// Value with which the drive's own contacts decide.
    pub terminals: i64,
    /// Bits of the control word that start it where it stands for contacts.
    #[serde(default)]
    pub start_contacts: u16,
}

/// What the parameter with the role `movement` tells.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Movement {
    /// The shaft stands when it is 0.
    #[default]
    Speed,
    /// The shaft stands when it does not change.
    Position,
}

/// What a drive tells of its shaft whose movement is the frequency of the stator: 0 without power, whatever the shaft does.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stator {
    /// Roles of what an encoder shows, in the order in which they are asked for: turning it proves at any time, a standstill
    /// only if it was seen turning.
    pub encoders: Vec<Role>,
    /// Role of the setting that says how a ramp stop ends.
    pub ends: Role,
    /// Its values with which that frequency says nothing of the shaft.
    pub blind: Vec<Blind>,
    /// What lets the power go before the shaft stands, and what to do about it.
    pub early: Text,
}

/// A way to end a ramp stop that the frequency of the stator does not show.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Blind {
    /// Value of the setting.
    pub value: i64,
    /// It switches the power off and does no more: whoever asked for that was given it.
    #[serde(default)]
    pub coasts: bool,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
}

impl Blind {
    /// What it is called.
    pub fn text(&self) -> Text {
        Text { en: self.en.clone().into(), de: self.de.clone().into() }
    }
}

/// Something that a transition needs, and how its absence is seen.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Interlock {
    /// The need that it stands for.
    pub need: Need,
    #[serde(default)]
    pub(super) drives: Option<Vec<String>>,
    /// Bit of the status word that is 1 when it is given.
    pub bit: Option<u8>,
    /// A setting that forbids it.
    pub setting: Option<Setting>,
    /// The bit tells only while the control word is obeyed.
    #[serde(default)]
    pub controlled: bool,
    /// What it is, in a list.
    pub what: Text,
    /// What is seen while it is missing; nothing is told without it.
    pub missing: Option<Text>,
    /// What it consists of.
    #[serde(default)]
    pub parts: Vec<Part>,
    /// Where one sees the parts.
    pub seen: Option<Text>,
}

/// A setting that stands in the way.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Setting {
    /// Role of the parameter.
    pub role: String,
    /// Its value, modulo this …
    pub modulo: i64,
    /// … must not be this.
    pub not: i64,
}

/// A part of an interlock.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Part {
    #[serde(default)]
    pub(super) drives: Option<Vec<String>>,
    /// Bits of the role `digital-inputs`, one of which is set when it is given.
    pub inputs: Vec<u8>,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
}

impl Part {
    /// What it is called.
    pub fn text(&self) -> Text {
        Text { en: self.en.clone().into(), de: self.de.clone().into() }
    }
}

/// A way to stop a drive.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StopRow {
    /// Word of `--on-exit`: `ramp`, `quick-stop`, `coast`.
    pub slug: String,
    /// Commands, in this order; before the second the shaft must stand.
    pub commands: Vec<String>,
    /// First the setpoint goes to 0 and the shaft must stand, in modes whose setpoint 0 brings it to rest.
    #[serde(default)]
    pub zero: bool,
    /// The way that is taken in its place in other modes.
    pub otherwise: Option<String>,
    /// State that proves it.
    pub goal: String,
    /// What it waits for.
    pub takes: Option<Takes>,
}

impl MotionRules {
    /// What a need is that the catalogue explains.
    pub fn interlock(&self, need: Need) -> Option<&Interlock> {
        self.interlocks.iter().find(|row| row.need == need)
    }

    /// The way to stop with this word.
    pub fn stop(&self, slug: &str) -> Option<&StopRow> {
        self.stops.iter().find(|row| row.slug == slug)
    }

    /// Only what concerns this drive.
    pub(super) fn keep(&mut self, drive: &str) {
        let ours = |drives: &Option<Vec<String>>| drives.as_ref().is_none_or(|list| list.iter().any(|id| id == drive));
        self.interlocks.retain(|row| ours(&row.drives));
        for row in &mut self.interlocks {
            row.parts.retain(|part| ours(&part.drives));
        }
    }
}

/// A kind of setpoint: what is set, in which operating mode, and how one sees that it is reached.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Mode {
    /// Word of `--mode`.
    pub slug: String,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// Value of the role `mode` that selects it; without one there is nothing to select.
    pub value: Option<i64>,
    /// Parameter that takes the setpoint.
    pub setpoint: u32,
    /// The setpoint is a ratio: parameter that takes its denominator, written first.
    pub denominator: Option<u32>,
    /// The setpoint may also be given in another unit, and is converted.
    pub convert: Option<Convert>,
    /// Parameters of the mode that may be given with it; they are written first.
    #[serde(default)]
    pub options: Vec<u32>,
    /// Written once the mode is active, before the setpoint.
    #[serde(default)]
    pub engage: Vec<Preset>,
    /// Control words that start a movement to the setpoint; without one the setpoint acts at once. The first is usual.
    #[serde(default)]
    pub starts: Vec<Start>,
    /// Bit of the status word that says that it is done, if it is not the family's usual one.
    pub reached: Option<u8>,
    /// Nothing says that the setpoint is reached.
    #[serde(default)]
    pub endless: bool,
    /// The setpoint 0 moves nothing: it is written before the drive is enabled, and, where it also holds, is how a ramp stop
    /// begins.
    #[serde(default)]
    pub zero: bool,
    /// The setpoint 0 leaves the shaft without torque, or acts on something else than its speed: a load or its own mass may
    /// turn it, and it stops nothing.
    #[serde(default)]
    pub slack: bool,
    /// Parameter that bounds the setpoint's magnitude.
    pub limit: Option<u32>,
    /// A setting that decides whether the setpoint counts.
    pub source: Option<Source>,
    /// The setpoint is a code: only what its table names is sent. What to do in place of another number.
    pub codes: Option<Text>,
    /// What the drive adds to the setpoint.
    pub adds: Option<Adds>,
    /// A setting that lifts small setpoints.
    pub floor: Option<Floor>,
    #[serde(default)]
    pub(super) replace: bool,
}

/// How a setpoint is converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Convert {
    /// From 1/min to Hz by the role `pole-pairs`.
    PolePairs,
}

/// A value that a mode needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Preset {
    /// Parameter.
    pub param: u32,
    /// Raw value.
    pub value: i64,
}

/// A control word that starts a movement.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Start {
    /// Word of `--start`.
    pub slug: String,
    /// What is written; afterwards the enable command is written again.
    pub word: u16,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// What to know about it before one relies on it.
    pub note: Option<Text>,
}

impl Start {
    /// What it is called.
    pub fn text(&self) -> Text {
        Text { en: self.en.clone().into(), de: self.de.clone().into() }
    }
}

/// A setting that decides whether a setpoint counts.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Parameter.
    pub param: u32,
    /// Its value with which the setpoint is ignored.
    pub ignored: i64,
    /// Words of `--source` and the values that they set.
    pub choices: Vec<Choice>,
    /// What is told while the setpoint is ignored.
    pub why: Text,
}

/// A value with a word.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Choice {
    /// Word.
    pub slug: String,
    /// Raw value.
    pub value: i64,
}

/// What a drive adds to a setpoint by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Adds {
    /// Parameter that shows what is added.
    pub param: u32,
    /// It is added only with this value of the mode's source; always without one.
    pub source: Option<i64>,
    /// Parameter that selects where it comes from.
    pub by: u32,
    /// The parameter shows the sum, so that the part that is added is not known.
    #[serde(default)]
    pub sum: bool,
    /// A modulus and what the role `configuration` is by it where a controller may make the drive's own setpoint of this one.
    pub controls: Option<(i64, i64)>,
}

/// A setting that lifts small setpoints.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Floor {
    /// Parameter with the least magnitude.
    pub param: u32,
    /// It acts only with this value of the mode's source.
    pub source: i64,
    /// What it does, told to who gives less; `{}` is the least magnitude.
    pub why: Text,
}

impl Mode {
    /// What it is called.
    pub fn text(&self) -> Text {
        Text { en: self.en.clone().into(), de: self.de.clone().into() }
    }

    /// Whether the setpoint 0 brings the shaft to rest.
    pub fn zero_stops(&self) -> bool {
        self.zero && !self.slack
    }

    /// Every parameter that it names.
    pub fn params(&self) -> impl Iterator<Item = u32> + '_ {
        let single = [Some(self.setpoint), self.denominator, self.limit, self.source.as_ref().map(|row| row.param)];
        let engage = self.engage.iter().map(|row| row.param);
        let adds = self.adds.iter().flat_map(|row| [row.param, row.by]);
        single.into_iter().flatten().chain(engage).chain(adds).chain(self.options.iter().copied())
    }
}

impl CatalogueRow for Mode {
    fn key(&self) -> Text {
        both!("mode {slug}", "Betriebsart {slug}", slug = self.slug)
    }
    fn replaces(&self) -> bool {
        self.replace
    }
    fn texts(&self) -> Vec<&str> {
        vec![&self.slug, &self.en, &self.de]
    }
}
