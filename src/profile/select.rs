//! How users name parameters and data sets: `372`, `rated-speed@2`, `480-483@all`, `@actual`, `372@2ram`.

use super::family::{Family, LookupError};
use super::param::Param;
use crate::text::{Text, both};
use std::fmt;
use std::str::FromStr;

/// Which memory of the drive is meant (CM-485 manual 7).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Store {
    /// Non-volatile; wears out after about a million writes.
    Eeprom,
    /// Lost at power-off.
    Ram,
}

/// Which data sets of a parameter are meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DataSets {
    /// None was named: data set 0.
    Unnamed,
    /// One, 0-4.
    One(u8, Store),
    /// All four, one by one.
    All(Store),
}

impl DataSets {
    /// RAM sets are numbered 5 above their EEPROM twins (CM-485 manual 7).
    pub const RAM_OFFSET: u8 = 5;

    /// The data set numbers to put on the wire.
    pub fn wire(self) -> Vec<u8> {
        match self {
            DataSets::Unnamed => vec![0],
            DataSets::One(set, store) => vec![store.wire(set)],
            DataSets::All(store) => (1..=4).map(|set| store.wire(set)).collect(),
        }
    }
}

impl Store {
    /// A data set (0-4) of this memory as on the wire.
    pub fn wire(self, set: u8) -> u8 {
        match self {
            Store::Eeprom => set,
            Store::Ram => set + DataSets::RAM_OFFSET,
        }
    }
}

/// What stands before the `@`.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Who {
    Number(u32),
    Range(u32, u32),
    Name(String),
    Group(String),
}

/// A parameter as the user named it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selector {
    who: Who,
    sets: DataSets,
}

/// A parameter and the data sets that are meant.
#[derive(Clone, Debug)]
pub struct Selection {
    /// The parameter; unknown to the catalogue if only its number was given.
    pub param: Param,
    /// The data sets.
    pub sets: DataSets,
    /// It came as one of a group or range: nobody named it alone.
    pub of_group: bool,
    /// It came as one of a group, so a drive need not have it.
    pub lenient: bool,
}

/// Why a text is no selector.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SelectError {
    /// The part behind `@` is no data set.
    #[error("{}", self.text().en)]
    Set(String),
    /// Nothing before the `@`.
    #[error("{}", self.text().en)]
    Empty(String),
    /// A range that runs backwards or is too long.
    #[error("{}", self.text().en)]
    Range(String),
    /// No such group.
    #[error("{}", self.text().en)]
    Group {
        /// What came.
        name: String,
        /// Groups of this drive.
        known: Vec<String>,
    },
    /// No such parameter.
    #[error(transparent)]
    Lookup(#[from] LookupError),
}

impl SelectError {
    /// In words for people.
    pub fn text(&self) -> Text {
        match self {
            SelectError::Set(set) => both!(
                "'{set}' is no data set: expected 0-4, 5-9, all, ram, allram, or 0ram-4ram",
                "'{set}' ist kein Datensatz: erwartet 0-4, 5-9, all, ram, allram oder 0ram-4ram"
            ),
            SelectError::Empty(text) => both!(
                "'{text}' names no parameter: expected a number, a range such as 480-483, a name, or a group such as @actual",
                "'{text}' nennt keinen Parameter: erwartet eine Nummer, ein Bereich wie 480-483, ein Name oder eine Gruppe wie \
                 @actual"
            ),
            SelectError::Range(text) => both!(
                "'{text}' is no range: expected FIRST-LAST, the smaller number first, with at most 1000 numbers",
                "'{text}' ist kein Bereich: erwartet ERSTE-LETZTE, die kleinere Nummer zuerst, mit höchstens 1000 Nummern"
            ),
            SelectError::Group { name, known } => both!(
                "there is no group '@{name}' (expected: {known})",
                "es gibt keine Gruppe '@{name}' (erwartet: {known})",
                known = known.join(", ")
            ),
            SelectError::Lookup(error) => error.text(),
        }
    }
}

impl FromStr for DataSets {
    type Err = SelectError;
    fn from_str(text: &str) -> Result<Self, SelectError> {
        let bad = || SelectError::Set(text.to_owned());
        let (number, store) = match text.strip_suffix("ram") {
            Some(rest) => (rest, Store::Ram),
            None => (text, Store::Eeprom),
        };
        match (number, store) {
            ("", Store::Ram) => Ok(DataSets::One(0, Store::Ram)),
            ("all", store) => Ok(DataSets::All(store)),
            (digit, store) => {
                let set: u8 = digit.parse().map_err(|_| bad())?;
                match (set, store) {
                    (0..=4, store) => Ok(DataSets::One(set, store)),
                    (5..=9, Store::Eeprom) => Ok(DataSets::One(set - DataSets::RAM_OFFSET, Store::Ram)),
                    _ => Err(bad()),
                }
            }
        }
    }
}

impl FromStr for Selector {
    type Err = SelectError;
    fn from_str(text: &str) -> Result<Self, SelectError> {
        let text = text.trim();
        if let Some(group) = text.strip_prefix('@') {
            let (name, sets) = match group.split_once('@') {
                Some((name, sets)) => (name, sets.parse()?),
                None => (group, DataSets::Unnamed),
            };
            return Ok(Selector { who: Who::Group(name.to_ascii_lowercase()), sets });
        }
        let (who, sets) = match text.rsplit_once('@') {
            Some((who, sets)) => (who.trim(), sets.trim().parse()?),
            None => (text, DataSets::Unnamed),
        };
        let who_text = bare(who);
        if who_text.is_empty() {
            return Err(SelectError::Empty(text.to_owned()));
        }
        let ends = who_text.split_once('-').and_then(|(first, last)| Some((number(first)?, number(last)?)));
        let who = match (number(who_text), ends) {
            (Some(id), _) => Who::Number(id.ok_or_else(|| SelectError::Empty(text.to_owned()))?),
            (None, Some((first, last))) => match (first, last) {
                (Some(first), Some(last)) if first <= last && last - first < 1000 => Who::Range(first, last),
                _ => return Err(SelectError::Range(text.to_owned())),
            },
            (None, None) => Who::Name(who_text.to_owned()),
        };
        Ok(Selector { who, sets })
    }
}

/// Without the `P.` before a number; `p372` is no name either.
fn bare(who: &str) -> &str {
    let Some(rest) = who.strip_prefix(['P', 'p']) else { return who };
    match rest.strip_prefix('.') {
        Some(number) => number,
        None if rest.starts_with(|first: char| first.is_ascii_digit()) && number(rest).is_some() => rest,
        None => who,
    }
}

/// A number as manuals write addresses: `7700`, `0x1E14`, `1E14h` (a digit first, or it could be a name), `16#1E14`.
/// `None` if it is none, `Some(None)` if it is too large.
fn number(text: &str) -> Option<Option<u32>> {
    let prefixed = ["0x", "0X", "16#"].iter().find_map(|start| text.strip_prefix(start));
    let suffixed = text.strip_suffix(['h', 'H']).filter(|digits| digits.starts_with(|c: char| c.is_ascii_digit()));
    let (digits, radix) = prefixed.or(suffixed).map_or((text, 10), |digits| (digits, 16));
    let is_number = !digits.is_empty() && digits.chars().all(|digit| digit.is_digit(radix));
    is_number.then(|| u32::from_str_radix(digits, radix).ok())
}

impl Selector {
    /// The group with this name.
    pub fn group(name: &str) -> Self {
        Selector { who: Who::Group(name.to_owned()), sets: DataSets::Unnamed }
    }

    /// Whether a whole group is meant.
    pub fn is_group(&self) -> bool {
        matches!(self.who, Who::Group(_))
    }

    /// The data sets that are meant.
    pub fn sets(&self) -> DataSets {
        self.sets
    }

    /// Whether its name is a whole one, not only the first letters of one.
    pub fn is_whole(&self, family: &Family) -> bool {
        match &self.who {
            Who::Name(name) => family.element(name).is_some() || family.has_name(name),
            _ => true,
        }
    }

    /// Whether data sets were named.
    pub fn names_sets(&self) -> bool {
        self.sets != DataSets::Unnamed
    }

    /// The parameters that are meant, in the order in which they were named. A range takes the rows that the
    /// catalogue has in it; if it has none, every number of it.
    pub fn resolve(&self, family: &Family) -> Result<Vec<Selection>, SelectError> {
        let lenient = self.is_group();
        let of_group = lenient || matches!(self.who, Who::Range(..));
        let select = |param: Param| Selection { param, sets: self.sets, of_group, lenient };
        Ok(match &self.who {
            Who::Number(id) => vec![select(family.param_or_unknown(*id))],
            Who::Range(first, last) => {
                let known: Vec<_> = family.params.range(first..=last).map(|(_, param)| select(param.clone())).collect();
                if known.is_empty() {
                    (*first..=*last).map(|id| select(family.param_or_unknown(id))).collect()
                } else {
                    known
                }
            }
            Who::Name(name) => match family.element(name) {
                Some(element) => vec![select(element)],
                None => vec![select(family.find(name)?.clone())],
            },
            Who::Group(name) => {
                let unknown = || SelectError::Group {
                    name: name.clone(),
                    known: family.group_names().map(|name| format!("@{name}")).collect(),
                };
                let ids = family.group(name).ok_or_else(unknown)?;
                ids.iter().filter_map(|&id| family.param(id)).map(|param| select(param.clone())).collect()
            }
        })
    }
}

/// As it is typed.
impl fmt::Display for Selector {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.who {
            Who::Number(id) => write!(f, "{id}")?,
            Who::Range(first, last) => write!(f, "{first}-{last}")?,
            Who::Name(name) => write!(f, "{name}")?,
            Who::Group(name) => write!(f, "@{name}")?,
        }
        if self.names_sets() { write!(f, "@{}", self.sets) } else { Ok(()) }
    }
}

impl fmt::Display for DataSets {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DataSets::Unnamed => write!(f, "0"),
            DataSets::One(set, Store::Eeprom) => write!(f, "{set}"),
            DataSets::One(set, Store::Ram) => write!(f, "{set}ram"),
            DataSets::All(Store::Eeprom) => write!(f, "all"),
            DataSets::All(Store::Ram) => write!(f, "allram"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sets(text: &str) -> Result<Vec<u8>, SelectError> {
        text.parse().map(DataSets::wire)
    }

    #[test]
    fn data_sets_become_numbers_on_the_wire() {
        for (text, wire) in [
            ("0", vec![0]),
            ("2", vec![2]),
            ("ram", vec![5]),
            ("2ram", vec![7]),
            ("7", vec![7]),
            ("all", vec![1, 2, 3, 4]),
            ("allram", vec![6, 7, 8, 9]),
        ] {
            assert_eq!(sets(text), Ok(wire), "{text}");
        }
        for text in ["", "10", "5ram", "x", "-1", "ramram"] {
            assert!(sets(text).is_err(), "{text}");
        }
    }

    #[test]
    fn selectors_are_numbers_ranges_names_and_groups() {
        let parsed = |text: &str| text.parse::<Selector>().map(|selector| selector.who);
        assert_eq!(parsed("372@2"), Ok(Who::Number(372)));
        for typed in ["P.372", "p.372", "P372", "p372"] {
            assert_eq!(parsed(typed), Ok(Who::Number(372)));
        }
        assert_eq!(parsed("p3x"), Ok(Who::Name("p3x".to_owned())));
        for text in ["7700", "0x1E14", "0X1e14", "1E14h", "1e14H", "16#1E14"] {
            assert_eq!(parsed(text), Ok(Who::Number(7700)), "{text}");
        }
        assert_eq!(parsed("0x1E14-1E18h@2"), Ok(Who::Range(7700, 7704)));
        for name in ["beach", "each", "0x", "0xG", "h", "1Gh"] {
            assert_eq!(parsed(name), Ok(Who::Name(name.to_owned())), "{name}");
        }
        assert!(parsed("0x123456789").is_err());
        assert_eq!(parsed("480-483@2"), Ok(Who::Range(480, 483)));
        assert_eq!(parsed("rated-speed@all"), Ok(Who::Name("rated-speed".to_owned())));
        assert_eq!(parsed("@actual"), Ok(Who::Group("actual".to_owned())));
        assert!(parsed("9-3").is_err());
        assert!(parsed("@2").is_ok_and(|who| who == Who::Group("2".to_owned())));
        assert!(parsed("372@").is_err());
        assert!(parsed("").is_err());
    }
}
