//! How the parameters of a family are reached over Modbus: the `[link]` table of a catalogue.

use super::param::Type;
use crate::text::{Text, both};
use serde::Deserialize;
use std::ops::RangeInclusive;

/// Numbers of input registers, which function code 4 reads and nothing writes (V1.1b3 4.4, 6.4), in a family of plain registers:
/// their reference with six digits, as makers print it. 300001 is register 0.
pub const INPUTS: RangeInclusive<u32> = 300_001..=365_536;

/// The input register of such a number.
pub fn input_register(number: u32) -> Option<u16> {
    INPUTS.contains(&number).then(|| (number - INPUTS.start()) as u16)
}

/// The way to the parameters of a family.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Link {
    /// Which function codes, and what the address word means.
    pub route: Route,
    /// Highest number that a telegram can carry.
    #[serde(default = "last_register")]
    pub last: u32,
    /// What numbers there are, for hints.
    #[serde(default = "numbers")]
    pub numbers: Text,
    /// Of a value in two registers the lower half goes first, unless the drive or somebody says otherwise.
    #[serde(default)]
    pub low_half_first: bool,
    /// What the product code of the family's drives begins with (code 43, object 1).
    pub product: Option<String>,
    /// Where the drive says why it refused something.
    #[serde(default)]
    pub cause: Cause,
    /// Sub-function of code 8 that changes nothing, for link tests: 0 returns what was sent (V1.1b3 6.8).
    #[serde(default)]
    pub echo: u16,
    /// When a value takes effect that does not do so at once.
    #[serde(default = "after_reset")]
    pub after_reset: Text,
    /// How its line is set.
    #[serde(default)]
    pub line: LineTable,
}

fn last_register() -> u32 {
    u16::MAX.into()
}

fn numbers() -> Text {
    both!(
        "a number is that of a register, 0 to 65535, or of an input register, 300001 to 365536",
        "eine Nummer ist die eines Registers, 0 bis 65535, oder eines Eingangsregisters, 300001 bis 365536"
    )
}

fn after_reset() -> Text {
    both!("takes effect after a restart", "wird erst nach einem Neustart wirksam")
}

/// How the line of a family is set: values of the parameters that hold it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LineTable {
    /// Values of the role `baud-rate`, and their speeds.
    pub baud_rates: Vec<(i64, u32)>,
    /// Values of the role `bus-rate`, and their bits per second on a system bus.
    #[serde(default)]
    pub bus_rates: Vec<(i64, u32)>,
    /// Role of the parameter that holds the parity.
    pub parity: String,
    /// Its values: `even`, `odd`, `none`.
    pub parities: Vec<(i64, String)>,
    /// Values of the role `protocol`; empty where a drive speaks one protocol only.
    #[serde(default)]
    pub protocols: Vec<(i64, String)>,
    /// When a new address holds.
    pub address: Holds,
    /// Value of the role `reset` that restarts the drive; without one only switching it off and on does.
    pub restart: Option<i64>,
}

/// When a value takes effect.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Holds {
    /// At once.
    #[default]
    AtOnce,
    /// No source says whether at once or after the next power-on.
    Unsaid,
}

/// Function codes, width and addressing of parameters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Route {
    /// Codes 3 and 6 for 16 bits, 100 and 101 for 32; the address word carries the data set (CM-485 manual 6.4, 7).
    #[default]
    Active,
    /// Codes 3, 16 and 23; every parameter is two registers wide, and neighbours are two apart (LXM05 manual 5.2, 5.3).
    Registers32,
    /// PKW over PROFIBUS, by index; no telegram of Modbus reaches them (SJ2-PB manual 4.1, 5.5).
    Pkw,
    /// Codes 3, 4, 6 and 16: 16 bits in one register, 32 in two; the number of a parameter is that of its first register,
    /// from 0, or one of [`INPUTS`] (V1.1b3 4.4, 6.3, 6.4, 6.6, 6.12).
    Registers,
}

impl Route {
    /// Whether parameters can exist in several data sets.
    pub fn has_data_sets(self) -> bool {
        self == Route::Active
    }

    /// How many parameters one telegram can read: code 3 returns at most 125 registers.
    pub fn most(self) -> usize {
        match self {
            Route::Active | Route::Registers | Route::Pkw => 1,
            Route::Registers32 => 125 / 2,
        }
    }

    /// The width of a parameter that no catalogue knows, if the route alone decides it.
    pub fn width(self) -> Option<Type> {
        match self {
            Route::Active | Route::Pkw => None,
            Route::Registers32 => Some(Type::Long),
            Route::Registers => Some(Type::Word),
        }
    }

    /// The type in which a value of type `kind` travels: two registers carry 32 bits, whatever the value needs
    /// (LXM05 manual 5.2.1).
    pub fn carried(self, kind: Type) -> Type {
        match self {
            Route::Registers32 if kind != Type::Float => Type::Long,
            Route::Active | Route::Registers | Route::Registers32 | Route::Pkw => kind,
        }
    }

    /// The number behind `id` whose parameter may be read in the same telegram.
    pub fn neighbour(self, id: u32) -> Option<u32> {
        match self {
            Route::Active | Route::Registers | Route::Pkw => None,
            Route::Registers32 => id.checked_add(2),
        }
    }
}

/// Where a drive says why it refused something.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Cause {
    /// In the parameter with the role `error-register`; reading clears it.
    #[default]
    ErrorRegister,
    /// In this sub-function of code 8.
    Diagnostics(u16),
}

impl Link {
    /// Whether telegrams of Modbus or VABus reach it.
    pub fn is_asked_on_a_line(&self) -> bool {
        self.route != Route::Pkw
    }

    /// Whether a telegram can carry this number.
    pub fn carries(&self, id: u32) -> bool {
        id <= self.last || self.route == Route::Registers && INPUTS.contains(&id)
    }
}
