//! One parameter of a drive: what the catalogue knows about it.

use crate::text::{Lang, Text, Wrong, both};
use serde::Deserialize;

/// Data type of a parameter on the wire.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Type {
    /// 8 bits, unsigned; they travel in 16.
    Byte,
    /// 16 bits, unsigned.
    Uint,
    /// 16 bits, two's complement.
    Int,
    /// 16 bits whose sign no source proves: read as unsigned unless the range goes below zero.
    Word,
    /// 32 bits, two's complement.
    Long,
    /// 32 bits, IEEE 754; its raw integer is their pattern.
    Float,
    /// 16 bits, the mixed code of the ramps of a Hitachi inverter (`profile::time`).
    #[serde(rename = "ramp-time")]
    Time,
    /// Text; not over Modbus.
    String,
}

impl Type {
    /// Width on the wire in bits; `None` for texts.
    pub fn bits(self) -> Option<u8> {
        match self {
            Type::Byte | Type::Uint | Type::Int | Type::Word | Type::Time => Some(16),
            Type::Long | Type::Float => Some(32),
            Type::String => None,
        }
    }

    /// The word that names the type in catalogues, on the command line and in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Type::Byte => "byte",
            Type::Uint => "uint",
            Type::Int => "int",
            Type::Word => "word",
            Type::Long => "long",
            Type::Float => "float",
            Type::Time => "ramp-time",
            Type::String => "string",
        }
    }

    /// How many bytes the value has.
    pub fn bytes(self) -> Option<u8> {
        if self == Type::Byte { Some(1) } else { self.bits().map(|bits| bits / 8) }
    }

    /// Whether its raw integer is no number with a decimal point: it says itself where the point stands.
    pub fn is_coded(self) -> bool {
        matches!(self, Type::Float | Type::Time)
    }

    /// Smallest and largest raw value that the width can carry; a word may carry either sign.
    pub fn raw_range(self) -> (i64, i64) {
        match self {
            Type::Byte => (0, 0xFF),
            Type::Uint => (0, 0xFFFF),
            Type::Int => (-0x8000, 0x7FFF),
            Type::Word => (-0x8000, 0xFFFF),
            Type::Long => (i32::MIN.into(), i32::MAX.into()),
            Type::Float => (0, u32::MAX.into()),
            Type::Time => super::time::RAW,
            Type::String => (0, 0),
        }
    }
}

impl std::str::FromStr for Type {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let known = [Type::Uint, Type::Int, Type::Word, Type::Long];
        let found = known.into_iter().find(|known| known.name() == text);
        found.ok_or_else(|| {
            Wrong(both!(
                "expected uint, int, word or long, got '{text}'",
                "erwartet: uint, int, word oder long; angegeben: '{text}'"
            ))
        })
    }
}

/// Who may read and write a parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
pub enum Access {
    /// Read only.
    #[serde(rename = "r")]
    Read,
    /// Write only.
    #[serde(rename = "w")]
    Write,
    /// Both.
    #[serde(rename = "rw")]
    ReadWrite,
}

impl Access {
    /// Whether the parameter can be read.
    pub fn reads(self) -> bool {
        self != Access::Write
    }

    /// Whether the parameter can be written.
    pub fn writes(self) -> bool {
        self != Access::Read
    }

    /// The word that names the access: `r`, `w`, `rw`.
    pub fn name(self) -> &'static str {
        match self {
            Access::Read => "r",
            Access::Write => "w",
            Access::ReadWrite => "rw",
        }
    }
}

/// In how many data sets a parameter exists (CM-485 manual 7).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Sets {
    /// Once: data set 0.
    One,
    /// Four times: data sets 1-4, switchable.
    Four,
}

/// When a written value takes effect.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effective {
    /// At once.
    #[default]
    AtOnce,
    /// After a reset or power cycle.
    Reset,
}

/// What writing a parameter can do to people, the machine or the connection.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum HazardKind {
    /// May start the shaft or change its movement.
    Motion,
    /// May cut the line to the drive.
    Line,
    /// Resets the drive or its faults.
    Reset,
}

/// Other names for the bits of a word while another parameter has a certain value.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BitsWhen {
    /// The parameter that decides.
    pub param: u32,
    /// Its raw value.
    pub value: i64,
    /// Name of the `[bits.…]` table that holds then.
    pub bits: String,
}

/// A row of the catalogue. Limits and default are raw integers: the value without its decimal point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Param {
    /// Number.
    pub id: u32,
    /// Stable English name in kebab-case.
    pub slug: String,
    /// The maker's short name, where parameters are known by one: `MBnode_guard`.
    pub short: Option<String>,
    /// Name in both languages.
    pub name: Text,
    /// Unit as printed.
    pub unit: Option<String>,
    /// Data type, where a source tells it.
    pub kind: Option<Type>,
    /// Of an array, how many elements it has; they count from 1.
    pub elements: Option<u8>,
    /// Decimals of the value, where a source tells them.
    pub decimals: Option<u8>,
    /// Lower limit, raw.
    pub min: Option<i64>,
    /// Upper limit, raw.
    pub max: Option<i64>,
    /// Factory setting, raw.
    pub default: Option<i64>,
    /// Who may read and write it.
    pub access: Access,
    /// In how many data sets it exists, where a source tells it.
    pub sets: Option<Sets>,
    /// Lives in RAM only.
    pub volatile: bool,
    /// When a written value takes effect.
    pub effective: Effective,
    /// What writing it can do.
    pub hazard: Option<HazardKind>,
    /// Name of its table of values.
    pub enumeration: Option<String>,
    /// Name of its table of bits.
    pub bits: Option<String>,
    /// Other bit tables for other modes.
    pub bits_when: Vec<BitsWhen>,
    /// Shown in hexadecimal by habit.
    pub hex: bool,
    /// Address of the inverter's option port, where a module reaches the parameter by one as well.
    pub address: Option<u16>,
    /// A remark for the technician.
    pub note: Option<Text>,
    /// Fields whose facts no second source confirms; `row` stands for all.
    pub unconfirmed: Vec<String>,
    /// Option module that the parameter comes with.
    pub module: Option<String>,
    /// Where the facts come from.
    pub source: String,
    /// The catalogue that brought the row.
    pub origin: String,
}

/// Where the element of an array stands in an id.
const ELEMENT: u32 = 24;

/// The slug of a parameter without a name.
fn nameless(id: u32) -> String {
    format!("parameter-{id}")
}

impl Param {
    /// What it is called in a sentence: by its slug, which is English, or by its German name; both can be typed.
    pub fn called(&self) -> Text {
        Text::by(|lang| lang.pick(self.slug.clone(), self.name.get(Lang::De).to_owned()))
    }

    /// Whether it is called by more than its number.
    pub fn is_named(&self) -> bool {
        self.slug != nameless(self.id)
    }

    /// A parameter that no catalogue knows.
    pub fn unknown(id: u32) -> Self {
        Param {
            id,
            slug: nameless(id),
            short: None,
            name: Text { en: format!("Parameter {id}").into(), de: format!("Parameter {id}").into() },
            unit: None,
            kind: None,
            elements: None,
            decimals: None,
            min: None,
            max: None,
            default: None,
            access: Access::ReadWrite,
            sets: None,
            volatile: false,
            effective: Effective::AtOnce,
            hazard: None,
            enumeration: None,
            bits: None,
            bits_when: Vec::new(),
            hex: false,
            address: None,
            note: None,
            unconfirmed: vec!["row".to_owned()],
            module: None,
            source: String::new(),
            origin: "unknown".to_owned(),
        }
    }

    /// Every name that a user may call it by.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let [en, de] = self.name.both();
        [self.slug.as_str(), en, de].into_iter().chain(self.short.as_deref())
    }

    /// An element of this array, from 1. It is a parameter of its own: its id is that of the array with the element above every number that
    /// a telegram or a register can have.
    #[must_use]
    pub fn of_element(&self, element: u8) -> Param {
        let name = both!("{name} {element}", "{name} {element}", name = self.name);
        let slug = format!("{}-{element}", self.slug);
        Param { id: self.id | u32::from(element) << ELEMENT, slug, name, elements: None, ..self.clone() }
    }

    /// The number that it has: of an element that of its array.
    pub fn number(&self) -> u32 {
        self.id & ((1 << ELEMENT) - 1)
    }

    /// Which element of an array it is, if it is one.
    pub fn element(&self) -> Option<u8> {
        u8::try_from(self.id >> ELEMENT).ok().filter(|element| *element > 0)
    }

    /// How a file names it: `372`, `915.1`.
    pub fn key(&self) -> String {
        let number = self.number();
        self.element().map_or_else(|| number.to_string(), |element| format!("{number}.{element}"))
    }

    /// What it is called in messages: `P.413`, or with the maker's short name `MBnode_guard (5644)`.
    pub fn label(&self) -> String {
        match &self.short {
            Some(short) => format!("{short} ({})", self.key()),
            None => format!("P.{}", self.key()),
        }
    }

    /// Name in `lang`.
    pub fn name(&self, lang: Lang) -> &str {
        self.name.get(lang)
    }

    /// Whether it lives in RAM only: commands, and values that the drive itself produces.
    pub fn is_volatile(&self) -> bool {
        self.volatile || self.access == Access::Read
    }

    /// Whether a catalogue knows the parameter at all.
    pub fn is_known(&self) -> bool {
        self.origin != "unknown"
    }

    /// Whether a raw integer can be turned into the value: decimals are known, or there is no unit to scale to.
    pub fn has_scale(&self) -> bool {
        self.decimals.is_some() || self.unit.is_none() || self.kind.is_some_and(Type::is_coded)
    }

    /// Decimals to show; 0 where no source tells them.
    pub fn decimals_or_zero(&self) -> u8 {
        self.decimals.unwrap_or(0)
    }
}
