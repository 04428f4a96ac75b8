//! What PDOs cost the bus (EM-RES-03 manual 5.14.3): 140 bits each, exact sums, limits of 80 and 90 %.

use std::fmt;
use std::iter::Sum;
use std::ops::Add;

/// A bit rate that P.903 can set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rate {
    kbd: u16,
    /// Value of P.903.
    code: u8,
    /// Longest line in metres; a guide (manual 5.4).
    metres: u16,
}

impl Rate {
    /// Every rate, the fastest first as the manual lists them (5.4, 5.14.3).
    pub const ALL: [Rate; 6] = [
        Rate { kbd: 1000, code: 8, metres: 25 },
        Rate { kbd: 500, code: 7, metres: 100 },
        Rate { kbd: 250, code: 6, metres: 250 },
        Rate { kbd: 125, code: 5, metres: 500 },
        Rate { kbd: 100, code: 4, metres: 800 },
        Rate { kbd: 50, code: 3, metres: 1000 },
    ];

    /// The rate of so many kBd.
    pub fn of_kbd(kbd: u32) -> Option<Self> {
        Self::ALL.into_iter().find(|rate| u32::from(rate.kbd) == kbd)
    }

    /// The rate of a value of P.903.
    pub fn of_code(code: i64) -> Option<Self> {
        Self::ALL.into_iter().find(|rate| i64::from(rate.code) == code)
    }

    /// In kBd.
    pub fn kbd(self) -> u16 {
        self.kbd
    }

    /// Value of P.903.
    pub fn code(self) -> u8 {
        self.code
    }

    /// Longest line in metres; a guide.
    pub fn metres(self) -> u16 {
        self.metres
    }

    /// How long a PDO is on the bus at worst, in microseconds: exact for every rate.
    pub fn telegram_us(self) -> u32 {
        BITS * 1000 / u32::from(self.kbd)
    }

    /// What a PDO costs that is sent once in so many milliseconds; `None` for 0.
    pub fn load(self, every_ms: u32) -> Option<Load> {
        const PERCENT: u128 = 100;
        let time = u128::from(self.kbd) * u128::from(every_ms);
        (PERCENT * u128::from(BITS) * ONE).checked_div(time).map(Load)
    }
}

/// Bits of a PDO at worst, by the manual (5.14.3).
const BITS: u32 = 140;

/// A share of the bus in units of 10^-27 percent, cut off below that. Sums of some hundred of them are off by less than
/// 10^-24, far less than what sums of such fractions can be beside a limit without being equal to it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Load(u128);

/// A percent.
const ONE: u128 = 10_u128.pow(27);
/// The error that cutting off can have made of a sum.
const SLACK: u128 = 10_u128.pow(3);

impl Load {
    /// So many percent.
    pub fn percent(percent: u8) -> Self {
        Load(u128::from(percent) * ONE)
    }

    /// To the millionth of a percent.
    pub fn rounded(self) -> f64 {
        const MILLIONTH: u128 = ONE / 1_000_000;
        ((self.0 + MILLIONTH / 2) / MILLIONTH) as f64 / 1e6
    }

    /// Whether it is more than so many percent.
    pub fn exceeds(self, percent: u8) -> bool {
        self.0 > Self::percent(percent).0
    }

    /// As it is shown; with more digits where these would be the limit itself that it exceeds.
    pub fn beyond(self, percent: u8) -> String {
        let shown = self.to_string();
        if shown == percent.to_string() && self.exceeds(percent) { self.rounded().to_string() } else { shown }
    }

    /// What the manual says of a whole bus (5.14.3): up to 80 % okay, up to 90 % critical, above it not feasible.
    pub fn verdict(self) -> Verdict {
        match self {
            load if load.exceeds(90) => Verdict::NotFeasible,
            load if load.exceeds(80) => Verdict::Critical,
            _ => Verdict::Okay,
        }
    }
}

impl Add for Load {
    type Output = Load;
    fn add(self, other: Load) -> Load {
        Load(self.0 + other.0)
    }
}

/// Of fractions that make up a whole percent together nothing is lost: 3 of 14/3 are 14.
impl Sum for Load {
    fn sum<I: Iterator<Item = Load>>(loads: I) -> Load {
        let Load(sum) = loads.fold(Load::default(), Add::add);
        let above = sum.next_multiple_of(ONE);
        Load(if above - sum <= SLACK { above } else { sum })
    }
}

/// With the digits of the manual: one behind the point, none where it is 0.
impl fmt::Display for Load {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const TENTH: u128 = ONE / 10;
        let tenths = (self.0 + TENTH / 2) / TENTH;
        match tenths % 10 {
            0 => write!(f, "{}", tenths / 10),
            digit => write!(f, "{}.{digit}", tenths / 10),
        }
    }
}

/// What the manual says of a load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Up to 80 %.
    Okay,
    /// Up to 90 %.
    Critical,
    /// Above.
    NotFeasible,
}

impl Verdict {
    /// As JSON has it.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Okay => "okay",
            Verdict::Critical => "critical",
            Verdict::NotFeasible => "not_feasible",
        }
    }
}

/// What a PDO costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Charge {
    /// How often it is sent; `None` where nobody says: then it is not in the sum.
    pub every_ms: Option<u32>,
    /// Its share.
    pub load: Option<Load>,
}

/// What PDOs cost together. SYNC, SDO, NMT and emergencies are not in it, as in the manual's sheet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Budget {
    /// PDO by PDO.
    pub charges: Vec<Charge>,
    /// The exact sum.
    pub total: Load,
}

impl Budget {
    /// Of PDOs that are sent so often.
    pub fn new(rate: Rate, every_ms: impl IntoIterator<Item = Option<u32>>) -> Self {
        let charge = |every_ms: Option<u32>| Charge { every_ms, load: every_ms.and_then(|ms| rate.load(ms)) };
        let charges: Vec<Charge> = every_ms.into_iter().map(charge).collect();
        Budget { total: charges.iter().filter_map(|charge| charge.load).sum(), charges }
    }

    /// Whether a PDO is not in the sum, because nobody says how often it is sent.
    pub fn is_open(&self) -> bool {
        self.charges.iter().any(|charge| charge.load.is_none())
    }
}
