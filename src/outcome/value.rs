//! Values, words, states, faults: what a parameter says.

use super::ErrorDoc;
use crate::text::{Text, both};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize, Serializer};
use std::borrow::Cow;

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
    /// System-bus node behind it; missing where it is the drive itself.
    #[serde(default, skip_serializing_if = "super::is_zero")]
    pub node: u8,
    /// Family: `act`, `acu` …
    pub drive: String,
    /// Parameter number.
    pub param: u32,
    /// Element of an array, from 1; missing where it is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub index: Option<u8>,
    /// Stable English name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// Data set, 0-4.
    pub data_set: u8,
    /// `eeprom`, `ram`, or `unknown` where no source tells whether the value outlives power-off.
    pub store: &'static str,
    /// The value without its decimal point; null if it could not be read.
    pub raw: Option<i64>,
    /// The value; null if it could not be read, or if nobody knows its decimals or its width.
    pub value: Option<Decimal>,
    /// Places behind the point, where a source tells them.
    pub decimals: Option<u8>,
    /// Unit.
    pub unit: Option<String>,
    /// What the value stands for, where a table says so.
    pub text: Option<Text>,
    /// The bits, if the parameter is a word.
    pub word: Option<Word>,
    /// `uint`, `int`, `word`, `long`; null if nobody tells it. Of a value that was read, it is the width that nobody knows.
    #[serde(rename = "data_type")]
    pub kind: Option<&'static str>,
    /// Which catalogue the facts come from.
    pub origin: String,
    /// Facts of the catalogue that no second source confirms.
    pub unconfirmed: Vec<String>,
    /// What the catalogue expects, where the value lies outside of it and so is shown raw: a disturbed reply, two drives at
    /// one address, or a drive that the catalogue does not describe. Missing otherwise.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub expected: Option<String>,
    /// Why it could not be read.
    pub error: Option<ErrorDoc>,
    /// Shown in hexadecimal by habit.
    #[serde(skip)]
    pub hex: bool,
}

/// A parameter as people call it: `372`, and an element of it `915.1`.
pub fn numbered(param: u32, index: Option<u8>) -> String {
    index.map_or_else(|| param.to_string(), |index| format!("{param}.{index}"))
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
    pub name: Option<Text>,
    /// What it means and what to do.
    pub help: Option<Text>,
}

/// A state of the drive.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct State {
    /// Stable name; `unknown` if the word means none.
    pub slug: String,
    /// Name in the chosen language.
    #[serde(deserialize_with = "Text::as_printed")]
    pub name: Text,
}

/// A fault.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Fault {
    /// Value of the fault parameter.
    pub code: u32,
    /// As the drive displays it.
    pub key: String,
    /// Group in the chosen language.
    pub group: Option<Text>,
    /// Name in the chosen language.
    pub name: Text,
    /// What causes it.
    pub cause: Option<Text>,
    /// What to do.
    pub remedy: Option<Text>,
    /// Node that is meant, if the code carries one.
    pub node: Option<u32>,
}

impl Fault {
    /// In a line: `F0500 Output current overload`.
    pub fn told(&self) -> Text {
        both!("{key} {name}", "{key} {name}", key = self.key, name = self.name)
    }
}

/// A code of the error register.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Register {
    /// Code.
    pub code: u32,
    /// Stable name.
    pub slug: String,
    /// Name in the chosen language.
    pub name: Text,
    /// What to do.
    pub hint: Option<Text>,
}
