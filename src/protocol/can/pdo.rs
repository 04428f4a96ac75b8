//! Process data: eight bytes, at whose places stand booleans, words and longs (EM-RES-03 manual 5.11.5).
//!
//! The order of bytes is not printed for PDOs; it is read as in SDO, least significant first. No scale is printed at all.

use std::fmt;
use std::ops::Range;

/// What stands at a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    /// Two bytes; zero is false.
    Boolean,
    /// Two bytes: uint, int, or a percentage.
    Word,
    /// Four bytes.
    Long,
}

impl Kind {
    /// All of them.
    pub const ALL: [Kind; 3] = [Kind::Boolean, Kind::Word, Kind::Long];

    /// Bytes.
    pub fn size(self) -> usize {
        match self {
            Kind::Boolean | Kind::Word => 2,
            Kind::Long => 4,
        }
    }

    /// How many of them a PDO has room for.
    pub fn places(self) -> u8 {
        (Pdo::LEN / self.size()) as u8
    }

    /// As plans and parameters name it.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Boolean => "boolean",
            Kind::Word => "word",
            Kind::Long => "long",
        }
    }
}

/// A place in a PDO: `word3`, `long1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Place {
    kind: Kind,
    /// From 1 on.
    number: u8,
}

impl Place {
    /// `None` where a PDO has no such place.
    pub fn new(kind: Kind, number: u8) -> Option<Self> {
        (1..=kind.places()).contains(&number).then_some(Place { kind, number })
    }

    /// Every place: the booleans, the words, the longs.
    pub fn all() -> impl Iterator<Item = Place> {
        Kind::ALL.into_iter().flat_map(|kind| (1..=kind.places()).map(move |number| Place { kind, number }))
    }

    /// What stands there.
    pub fn kind(self) -> Kind {
        self.kind
    }

    /// The how-manieth of its kind, from 0 on.
    pub fn index(self) -> u16 {
        u16::from(self.number) - 1
    }

    /// Its bytes.
    pub fn bytes(self) -> Range<usize> {
        let first = usize::from(self.index()) * self.kind.size();
        first..first + self.kind.size()
    }

    /// Whether both have a byte in common.
    pub fn meets(self, other: Place) -> bool {
        self.bytes().start < other.bytes().end && other.bytes().start < self.bytes().end
    }
}

/// As plans name it: `word3`.
impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.kind.name(), self.number)
    }
}

/// The data of a PDO; always eight bytes here.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pdo(pub [u8; Pdo::LEN]);

impl Pdo {
    /// Bytes.
    pub const LEN: usize = 8;

    /// What stands at a place, as an unsigned number.
    pub fn get(&self, place: Place) -> u32 {
        let bytes = self.0.get(place.bytes()).unwrap_or_default();
        bytes.iter().rev().fold(0, |number, byte| (number << 8) | u32::from(*byte))
    }

    /// Puts a number at a place; what is wider than the place is cut.
    pub fn set(&mut self, place: Place, number: u32) {
        let bytes = self.0.get_mut(place.bytes()).unwrap_or_default();
        bytes.iter_mut().zip(number.to_le_bytes()).for_each(|(byte, new)| *byte = new);
    }
}
