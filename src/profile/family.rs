//! One drive as its catalogues describe it, and decoding by it.

use super::files::FileRules;
use super::link::{Link, Route};
use super::machine::StateMachine;
use super::motion::{Mode, MotionRules};
use super::names::{fold, has_word, near, same, starts};
use super::param::Param;
use super::role::Role;
use super::row::{BitRow, CounterRow, DriveState, ErrorRow, FaultCodes, FaultGroup, FaultRow};
use crate::text::{Text, both};
use std::collections::BTreeMap;

/// Everything that the catalogues know of one drive.
#[derive(Clone, Debug)]
pub struct Family {
    /// Family of the catalogue: `active`.
    pub family: String,
    /// Word for `--drive` and JSON: `act`.
    pub drive: String,
    /// Every drive of the family.
    pub(super) siblings: Vec<String>,
    /// Title of the family.
    pub title: Text,
    /// How its parameters are reached.
    pub link: Link,
    /// What its parameter files hold, and in which order.
    pub files: FileRules,
    /// What moving it needs.
    pub motion: MotionRules,
    /// Kinds of setpoints that it takes; the first is the usual one.
    pub modes: Vec<Mode>,
    /// Parameters by number.
    pub params: BTreeMap<u32, Param>,
    /// States of the status word; the first that fits counts.
    pub states: Vec<DriveState>,
    /// Commands and transitions of the state machine.
    pub machine: StateMachine,
    /// Fault groups by the high byte of the fault code.
    pub fault_groups: Vec<FaultGroup>,
    /// How faults are numbered.
    pub fault_codes: FaultCodes,
    /// Faults.
    pub faults: Vec<FaultRow>,
    /// Codes of the error register.
    pub errors: Vec<ErrorRow>,
    /// Diagnostic counters of function code 8.
    pub counters: Vec<CounterRow>,
    pub(super) roles: BTreeMap<Role, u32>,
    pub(super) groups: BTreeMap<String, Vec<u32>>,
    pub(super) enums: BTreeMap<String, BTreeMap<i64, Text>>,
    pub(super) bits: BTreeMap<String, BTreeMap<u8, BitRow>>,
    /// What people say for the beginning of a word of a name, both folded.
    pub(super) synonyms: BTreeMap<String, String>,
}

/// A bit of a decoded word.
#[derive(Clone, Copy, Debug)]
pub struct WordBit<'a> {
    /// Number, from 0.
    pub bit: u8,
    /// Whether it is set.
    pub set: bool,
    /// What it is called; `None` if nobody defined it.
    pub row: Option<&'a BitRow>,
}

/// Why a query names no parameter.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LookupError {
    /// Nothing fits.
    #[error("{}", self.text().en)]
    Unknown {
        /// What was asked.
        query: String,
        /// Names that come near.
        near: Vec<Text>,
    },
    /// More than one fits.
    #[error("{}", self.text().en)]
    Ambiguous {
        /// What was asked.
        query: String,
        /// Parameters that fit.
        found: Vec<Text>,
    },
}

impl LookupError {
    /// In words for people.
    pub fn text(&self) -> Text {
        match self {
            LookupError::Unknown { query, .. } => {
                both!("no parameter is called '{query}'", "kein Parameter heißt '{query}'")
            }
            LookupError::Ambiguous { query, found } => {
                both!("'{query}' could be {found}", "'{query}' kann {found} sein", found = Text::join(found, ", "))
            }
        }
    }
}

/// A parameter as it is suggested: by its slug, or by its German name, which is found as well.
fn called(param: &Param) -> Text {
    let known = Text { en: param.slug.clone().into(), de: param.name.de.clone() };
    both!("{id} ({known})", "{id} ({known})", id = param.id, known)
}

impl Family {
    pub(super) fn empty(family: &str, drive: &str, title: Text) -> Self {
        Family {
            family: family.to_owned(),
            drive: drive.to_owned(),
            siblings: Vec::new(),
            title,
            link: Link::default(),
            files: FileRules::default(),
            motion: MotionRules::default(),
            modes: Vec::new(),
            params: BTreeMap::new(),
            states: Vec::new(),
            machine: StateMachine::default(),
            fault_groups: Vec::new(),
            fault_codes: FaultCodes::default(),
            faults: Vec::new(),
            errors: Vec::new(),
            counters: Vec::new(),
            roles: BTreeMap::new(),
            groups: BTreeMap::new(),
            enums: BTreeMap::new(),
            bits: BTreeMap::new(),
            synonyms: BTreeMap::new(),
        }
    }

    /// The row of a number.
    pub fn param(&self, id: u32) -> Option<&Param> {
        self.params.get(&id)
    }

    /// The same parameter in the second set of an inverter, where it has one: F202 beside F002 (SJ2-PB manual 5.5).
    pub fn in_second_set(&self, param: &Param) -> Option<&Param> {
        if self.link.route != Route::Pkw {
            return None;
        }
        let short = param.short.as_deref()?;
        let (function, number) = short.split_at_checked(1)?;
        let second = format!("{function}2{}", number.strip_prefix('0')?);
        self.params.values().find(|param| param.short.as_deref() == Some(second.as_str()))
    }

    /// Whether parameters can stand in it more than once.
    pub fn has_sets(&self) -> bool {
        self.link.route.has_data_sets() || self.params.values().any(|param| self.in_second_set(param).is_some())
    }

    /// An element of an array as it is typed: `915.1`.
    pub fn element(&self, text: &str) -> Option<Param> {
        let (number, element) = text.split_once('.')?;
        let array = self.param(number.parse().ok()?)?;
        let element = element.parse().ok().filter(|element| (1..=array.elements.unwrap_or(0)).contains(element))?;
        Some(array.of_element(element))
    }

    /// The row of a number, or a row that says that nobody knows it.
    pub fn param_or_unknown(&self, id: u32) -> Param {
        let unknown = || Param { kind: self.link.route.width(), ..Param::unknown(id) };
        self.param(id).cloned().unwrap_or_else(unknown)
    }

    /// The parameter that plays a role: [`Role`], or its name.
    pub fn role(&self, role: impl AsRef<str>) -> Option<&Param> {
        self.roles.get(&Role::of(role.as_ref())?).and_then(|&id| self.param(id))
    }

    /// What the parameter of a role is called in messages; nothing, if there is none.
    pub fn role_label(&self, role: impl AsRef<str>) -> String {
        self.role(role).map_or_else(String::new, Param::label)
    }

    /// Whether a catalogue tells how its shaft is moved: what it commands, and what it sees of it.
    pub fn is_movable(&self) -> bool {
        self.role(Role::StatusWord).is_some() && !self.machine.commands.is_empty()
    }

    /// Numbers of a group such as `actual`, as far as this drive has them; `all` is everything readable but the error
    /// register, which reading would clear.
    pub fn group(&self, name: &str) -> Option<Vec<u32>> {
        let readable = |id: &u32| self.param(*id).is_some_and(|param| param.access.reads());
        if name == "all" {
            let register = self.roles.get(&Role::ErrorRegister);
            return Some(self.params.keys().copied().filter(|id| readable(id) && register != Some(id)).collect());
        }
        Some(self.groups.get(name)?.iter().copied().filter(|id| readable(id)).collect())
    }

    /// Names of the groups.
    pub fn group_names(&self) -> impl Iterator<Item = &str> {
        self.groups.keys().map(String::as_str).chain(["all"])
    }

    /// Finds a parameter by slug, by the maker's short name or by a name in either language: exact first, then as a
    /// unique start that is not a word of other names as well; then the same in the words of the names (`synonyms` of the catalogue).
    pub fn find(&self, query: &str) -> Result<&Param, LookupError> {
        let fitting = |fits: fn(&str, &str) -> bool, query: &str| {
            let rows = self.params.values().filter(|param| param.names().any(|name| fits(name, query)));
            rows.collect::<Vec<_>>()
        };
        let spelt = self.spelt(query);
        for said in &spelt {
            let mut found = fitting(same, said);
            if found.is_empty() && !fitting(starts, said).is_empty() {
                // "Fault" is the start of its acknowledgment, and yet the fault itself may be meant.
                found = fitting(|name, query| starts(name, query) || has_word(name, query), said);
            }
            match found.as_slice() {
                [] => {}
                [only] => return Ok(only),
                several => {
                    let found = several.iter().take(8).map(|param| called(param));
                    return Err(LookupError::Ambiguous { query: query.to_owned(), found: found.collect() });
                }
            }
        }
        let mut near = self.search(query);
        if near.is_empty() {
            near = spelt.iter().flat_map(|query| self.resembling(query)).collect();
        }
        let near = near.into_iter().take(5).map(called);
        Err(LookupError::Unknown { query: query.to_owned(), near: near.collect() })
    }

    /// Whether a parameter has this name, not only one that begins so.
    pub fn has_name(&self, query: &str) -> bool {
        let is_its = |param: &Param, query: &str| param.names().any(|name| same(name, query));
        self.spelt(query).iter().any(|query| self.params.values().any(|param| is_its(param, query)))
    }

    /// What was typed, and the same in the words of the names, if some of it is said in others.
    fn spelt(&self, query: &str) -> Vec<String> {
        let folded = fold(query);
        let said = folded.split(' ').map(|word| {
            let synonym = self.synonyms.iter().find_map(|(said, name)| Some((name, word.strip_prefix(said.as_str())?)));
            synonym.map_or_else(|| word.to_owned(), |(name, rest)| format!("{name}{rest}"))
        });
        let said = said.collect::<Vec<_>>().join(" ");
        if said == folded { vec![query.to_owned()] } else { vec![query.to_owned(), said] }
    }

    /// Parameters with a name that was perhaps meant, the likeliest first.
    fn resembling(&self, query: &str) -> Vec<&Param> {
        let slips = |param: &Param| param.names().filter_map(|name| near(name, query)).min();
        let mut found: Vec<_> = self.params.values().filter_map(|param| Some((slips(param)?, param))).collect();
        found.sort_by_key(|(slips, param)| (*slips, param.id));
        found.into_iter().map(|(_, param)| param).collect()
    }

    /// The mode with this word.
    pub fn mode(&self, slug: &str) -> Option<&Mode> {
        self.modes.iter().find(|mode| mode.slug == slug)
    }

    /// Every parameter whose number, slug or names contain all words of `query`, as typed or in the words of the names.
    pub fn search(&self, query: &str) -> Vec<&Param> {
        let spelt = self.spelt(query);
        let queries: Vec<Vec<String>> =
            spelt.iter().map(|query| fold(query).split(' ').map(str::to_owned).collect()).collect();
        let hay = |param: &Param| {
            let names: Vec<&str> = param.names().chain(param.unit.as_deref()).collect();
            fold(&format!("{} {}", param.id, names.join(" ")))
        };
        let fits = |hay: &str, words: &[String]| words.iter().all(|word| hay.contains(word.as_str()));
        let is_hit = |param: &&Param| {
            let hay = hay(param);
            queries.iter().any(|words| fits(&hay, words))
        };
        self.params.values().filter(is_hit).collect()
    }

    /// Texts of a parameter's values.
    pub fn choices(&self, param: &Param) -> Vec<(i64, [&str; 2])> {
        let table = param.enumeration.as_ref().and_then(|name| self.enums.get(name));
        table.into_iter().flatten().map(|(&raw, text)| (raw, text.both())).collect()
    }

    /// Text of a raw value, if the parameter has a table that knows it.
    pub fn text_of(&self, param: &Param, raw: i64) -> Option<&Text> {
        self.enums.get(param.enumeration.as_ref()?)?.get(&raw)
    }

    /// Whether the parameter's value is a word of bits.
    pub fn is_word(&self, param: &Param) -> bool {
        param.bits.is_some()
    }

    /// Every named bit of a word, and every set bit that nobody named, from 0 up. `value_of` tells the present raw
    /// value of another parameter, where the bit names depend on one.
    pub fn word<'a>(&'a self, param: &Param, raw: u32, value_of: impl Fn(u32) -> Option<i64>) -> Vec<WordBit<'a>> {
        let other = param.bits_when.iter().find(|when| value_of(when.param) == Some(when.value)).map(|when| &when.bits);
        let table = other.or(param.bits.as_ref()).and_then(|name| self.bits.get(name));
        let row = |bit: u8| table.and_then(|table| table.get(&bit));
        let width = if raw > 0xFFFF { 32 } else { 16 };
        let bits = (0..width).map(|bit| WordBit { bit, set: raw >> bit & 1 == 1, row: row(bit) });
        bits.filter(|bit| bit.set || bit.row.is_some()).collect()
    }

    /// The state that a status word stands for.
    pub fn state(&self, status: u32) -> Option<&DriveState> {
        self.states.iter().find(|state| status & state.mask == state.value)
    }

    /// The row of a fault code.
    pub fn fault(&self, code: u32) -> Option<&FaultRow> {
        self.faults.iter().find(|row| (row.code..=row.last.unwrap_or(row.code)).contains(&code))
    }

    /// The group of a fault code, also of one that has no row.
    pub fn fault_group(&self, code: u32) -> Option<&FaultGroup> {
        self.fault_groups.iter().find(|group| group.high == code >> 8)
    }

    /// The code of the fault that is present, if any: what the role `fault` holds, as far as it tells of the present.
    /// `status`: the status word, where there is one.
    pub fn present_fault(&self, status: Option<u32>, code: u32) -> Option<u32> {
        let in_fault = |status| self.state(status).is_some_and(|state| state.slug.starts_with("fault"));
        let counts = !self.fault_codes.memory || status.is_some_and(in_fault);
        (counts && code != 0).then_some(code)
    }

    /// The row of a code of the error register.
    pub fn error(&self, code: u32) -> Option<&ErrorRow> {
        self.errors.iter().find(|row| row.code == code)
    }
}
