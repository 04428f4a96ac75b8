//! The tables of a catalogue as TOML, and their JSON, have them.

use crate::profile::files::FileRules;
use crate::profile::link::Link;
use crate::profile::machine::{Command, Transition};
use crate::profile::motion::{Mode, MotionRules};
use crate::profile::param::{Access, BitsWhen, Effective, HazardKind, Sets, Type};
use crate::profile::role::Role;
use crate::profile::row::{BitRow, CounterRow, DriveState, EnumRow, ErrorRow, FaultCodes, FaultGroup, FaultRow};
use crate::text::Text;
use serde::de;
use serde::{Deserialize, Deserializer};
use std::collections::BTreeMap;
use std::fmt;

/// Version of the format that this program reads.
pub(super) const SCHEMA: i64 = 1;
/// What a catalogue is about.
#[derive(Clone, Debug, Deserialize)]
pub(super) struct Head {
    pub(super) family: String,
    pub(super) title: Option<Text>,
    /// The drive that a device is taken for as long as nobody knows what it is.
    pub(super) presumed: Option<String>,
    #[serde(default)]
    pub(super) drives: Vec<DriveRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Body {
    pub(super) schema: i64,
    pub(super) family: String,
    pub(super) title: Option<Text>,
    pub(super) presumed: Option<String>,
    pub(super) fault_codes: Option<FaultCodes>,
    pub(super) link: Option<Link>,
    pub(super) files: Option<FileRules>,
    pub(super) motion: Option<MotionRules>,
    #[serde(default)]
    pub(super) modes: Vec<Mode>,
    #[serde(default)]
    pub(super) drives: Vec<DriveRow>,
    #[serde(default)]
    pub(super) params: Vec<ParamRow>,
    #[serde(default)]
    pub(super) states: Vec<DriveState>,
    #[serde(default)]
    pub(super) commands: Vec<Command>,
    #[serde(default)]
    pub(super) transitions: Vec<Transition>,
    #[serde(default)]
    pub(super) fault_groups: Vec<FaultGroup>,
    #[serde(default)]
    pub(super) faults: Vec<FaultRow>,
    #[serde(default)]
    pub(super) errors: Vec<ErrorRow>,
    #[serde(default)]
    pub(super) counters: Vec<CounterRow>,
    #[serde(default)]
    pub(super) roles: BTreeMap<Role, u32>,
    #[serde(default)]
    pub(super) groups: BTreeMap<String, Vec<u32>>,
    /// What people say for the beginning of a word of a name.
    #[serde(default)]
    pub(super) synonyms: BTreeMap<String, String>,
    #[serde(default)]
    pub(super) enums: BTreeMap<String, BTreeMap<String, EnumRow>>,
    #[serde(default)]
    pub(super) bits: BTreeMap<String, BTreeMap<String, BitRow>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct DriveRow {
    pub(super) id: String,
    pub(super) en: String,
    pub(super) de: String,
}

impl DriveRow {
    pub(super) fn title(&self) -> Text {
        Text { en: self.en.clone().into(), de: self.de.clone().into() }
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ParamRow {
    pub(super) id: u32,
    pub(super) slug: Option<String>,
    pub(super) short: Option<String>,
    pub(super) drives: Option<Vec<String>>,
    pub(super) module: Option<String>,
    pub(super) de: String,
    pub(super) en: String,
    pub(super) unit: Option<String>,
    #[serde(rename = "type")]
    pub(super) kind: Option<Type>,
    /// Of an array, how many it has; they count from 1.
    pub(super) elements: Option<u8>,
    pub(super) decimals: Option<u8>,
    pub(super) min: Option<Number>,
    pub(super) max: Option<Number>,
    pub(super) default: Option<Number>,
    pub(super) access: Access,
    pub(super) sets: Option<Sets>,
    pub(super) volatile: Option<bool>,
    #[serde(default)]
    pub(super) effective: Effective,
    pub(super) hazard: Option<HazardKind>,
    #[serde(rename = "enum")]
    pub(super) enumeration: Option<String>,
    pub(super) bits: Option<String>,
    #[serde(default)]
    pub(super) bits_when: Vec<BitsWhen>,
    #[serde(default)]
    pub(super) hex: bool,
    pub(super) address: Option<u16>,
    pub(super) note: Option<Text>,
    #[serde(default)]
    pub(super) unconfirmed: Vec<String>,
    pub(super) source: Option<String>,
    #[serde(default)]
    pub(super) replace: bool,
}

/// A number in human units, kept as text so that it stays exact.
#[derive(Clone, Debug)]
pub(super) struct Number(pub(super) String);

impl<'de> Deserialize<'de> for Number {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Visitor;
        impl de::Visitor<'_> for Visitor {
            type Value = Number;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number, or a number in quotes")
            }
            fn visit_i64<E: de::Error>(self, value: i64) -> Result<Number, E> {
                Ok(Number(value.to_string()))
            }
            fn visit_u64<E: de::Error>(self, value: u64) -> Result<Number, E> {
                Ok(Number(value.to_string()))
            }
            fn visit_f64<E: de::Error>(self, value: f64) -> Result<Number, E> {
                // The shortest text that reads back as the same float is what stands in the file.
                Ok(Number(value.to_string()))
            }
            fn visit_str<E: de::Error>(self, value: &str) -> Result<Number, E> {
                Ok(Number(value.to_owned()))
            }
        }
        deserializer.deserialize_any(Visitor)
    }
}

impl Body {
    /// The first of the keys that are said once for a family, by the catalogue that brings it.
    pub(super) fn founding_key(&self) -> Option<&'static str> {
        let keys = [
            ("[link]", self.link.is_some()),
            ("[files]", self.files.is_some()),
            ("[motion]", self.motion.is_some()),
            ("fault_codes", self.fault_codes.is_some()),
        ];
        keys.into_iter().find(|key| key.1).map(|key| key.0)
    }

    /// The first of the keys that move a shaft: what no test of ours has proven moves none.
    pub(super) fn moving_key(&self) -> Option<&'static str> {
        let keys = [
            ("[motion]", self.motion.is_some()),
            ("modes", !self.modes.is_empty()),
            ("commands", !self.commands.is_empty()),
            ("transitions", !self.transitions.is_empty()),
            ("roles.control-word", self.roles.contains_key(&Role::ControlWord)),
        ];
        keys.into_iter().find(|key| key.1).map(|key| key.0)
    }
}
