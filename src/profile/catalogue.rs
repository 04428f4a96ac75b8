//! The one catalogue format, for what we ship and for what users bring: TOML, one inline table per parameter.
//!
//! A catalogue is refused as a whole, with file, line and column, if it has unknown keys, duplicate ids, control
//! characters, dangling references or limits that do not fit its decimals.

use super::family::{
    BitRow, CatalogueRow, CounterRow, EnumRow, ErrorRow, Family, FaultCodes, FaultGroup, FaultRow, StateRow,
};
use super::link::Link;
use super::machine::{Command, Transition};
use super::motion::{Mode, Motion};
use super::param::{Access, BitsWhen, Effective, HazardKind, Param, Sets, Type};
use super::text::Text;
use super::value::parse_decimal;
use serde::de::{self, DeserializeOwned};
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::cell::RefCell;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::rc::Rc;
use toml::de::DeTable;

/// Version of the format that this program reads.
const SCHEMA: i64 = 1;
/// Largest catalogue that is read at all.
const MAX_FILE: usize = 4 << 20;
/// Longest name, text or remark.
const MAX_TEXT: usize = 2_000;

/// The catalogues that we ship: family, and `data/*.toml` as two lines of JSON, which are read in a tenth of the time:
/// the keys of [`Head`], then everything. `UPDATE=1 cargo test --test generated` writes them.
const BUILT_IN: &[(&str, &str)] =
    &[("active", include_str!("data/active.ndjson")), ("lexium05", include_str!("data/lexium05.ndjson"))];

/// A catalogue of the user: where it stands and what is in it.
#[derive(Clone, Debug)]
pub struct CatalogueFile {
    /// Shown in errors and as the origin of rows.
    pub path: String,
    /// TOML.
    pub text: String,
}

/// Why a catalogue is refused, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{path}:{line}:{column}: {message}")]
pub struct CatalogueError {
    /// File, or `built-in active.toml`.
    pub path: String,
    /// Line, from 1.
    pub line: usize,
    /// Column, from 1.
    pub column: usize,
    /// What is wrong and what would be right.
    pub message: String,
}

/// Every drive that the catalogues describe.
#[derive(Debug)]
pub struct Registry {
    files: Vec<Catalogue>,
    /// Families that were asked for.
    families: RefCell<BTreeMap<String, Rc<Family>>>,
}

/// A drive's id and title.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DriveTitle {
    /// Word for `--drive` and JSON: `act`.
    pub id: String,
    /// For people.
    pub title: Text,
}

impl Registry {
    /// Reads the shipped catalogues and those of the user, in this order; later files may replace rows of earlier ones.
    pub fn open(user: &[CatalogueFile]) -> Result<Self, CatalogueError> {
        let mut files = Vec::new();
        for (family, text) in BUILT_IN {
            files.push(Catalogue::shipped(family, text)?);
        }
        for file in user {
            let catalogue = Catalogue::read(&file.path, &file.text)?;
            if !files.iter().any(|known: &Catalogue| known.head.family == catalogue.head.family) {
                let known: Vec<_> = BUILT_IN.iter().map(|row| row.0).collect();
                let message = format!("unknown family '{}' (expected: {})", catalogue.head.family, known.join(", "));
                return Err(catalogue.origin.error(Place::File, message));
            }
            if catalogue.rows()?.belongs_to_us() {
                let message = "[link], [motion] and fault_codes belong to the shipped catalogues".to_owned();
                return Err(catalogue.origin.error(Place::File, message));
            }
            files.push(catalogue);
        }
        let registry = Registry { files, families: RefCell::default() };
        // The shipped catalogues are proved by our tests; what users bring must be proved now.
        if !user.is_empty() {
            for drive in registry.drives() {
                registry.load(&drive.id)?;
            }
        }
        Ok(registry)
    }

    /// Id and title of every drive, in the order of the catalogues.
    pub fn drives(&self) -> Vec<DriveTitle> {
        let rows = self.files.iter().flat_map(|file| &file.head.drives);
        rows.map(|row| DriveTitle { id: row.id.clone(), title: Text { en: row.en.clone(), de: row.de.clone() } })
            .collect()
    }

    /// Every drive, in the order of the catalogues.
    pub fn families(&self) -> Vec<Rc<Family>> {
        self.drives().iter().filter_map(|drive| self.family(&drive.id)).collect()
    }

    /// What a drive is; `None` if no catalogue describes it.
    pub fn family(&self, drive: &str) -> Option<Rc<Family>> {
        if let Some(known) = self.families.borrow().get(drive) {
            return Some(known.clone());
        }
        let family = Rc::new(self.load(drive).ok().flatten()?);
        self.families.borrow_mut().insert(drive.to_owned(), family.clone());
        Some(family)
    }

    fn load(&self, drive: &str) -> Result<Option<Family>, CatalogueError> {
        let Some(home) = self.files.iter().find(|file| file.head.drives.iter().any(|row| row.id == drive)) else {
            return Ok(None);
        };
        let mut family = Family::empty(&home.head.family, drive, home.head.title.clone().unwrap_or_default());
        family.siblings = home.head.drives.iter().map(|row| row.id.clone()).collect();
        for file in self.files.iter().filter(|file| file.head.family == home.head.family) {
            file.origin.pour(file.rows()?.into_owned(), &mut family)?;
        }
        family.motion.keep(drive);
        Ok(Some(family))
    }
}

/// One catalogue file.
#[derive(Debug)]
struct Catalogue {
    origin: Origin,
    head: Head,
    rows: Rows,
}

/// Where a catalogue comes from.
#[derive(Debug)]
enum Origin {
    /// It is ours, and proved by our tests.
    Shipped { path: String },
    /// It was read, and its text is kept to say where something stands that is wrong.
    File { path: String, text: String },
}

/// The rows of a catalogue.
#[derive(Debug)]
enum Rows {
    /// JSON that is read when the family is asked for.
    Shipped(&'static str),
    Read(Box<Body>),
}

/// Where something stands in a catalogue.
#[derive(Clone, Copy, Debug)]
enum Place<'a> {
    /// At its beginning.
    File,
    /// At this offset.
    Offset(usize),
    /// A row of a list.
    Row(&'a str, usize),
    /// A row of a table of tables: `[enums.protocol]` has the row `0`.
    Entry(&'a str, &'a str, &'a str),
}

/// What a catalogue is about.
#[derive(Clone, Debug, Deserialize)]
struct Head {
    family: String,
    title: Option<Text>,
    #[serde(default)]
    drives: Vec<DriveRow>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Body {
    schema: i64,
    family: String,
    title: Option<Text>,
    fault_codes: Option<FaultCodes>,
    link: Option<Link>,
    motion: Option<Motion>,
    #[serde(default)]
    modes: Vec<Mode>,
    #[serde(default)]
    drives: Vec<DriveRow>,
    #[serde(default)]
    params: Vec<ParamRow>,
    #[serde(default)]
    states: Vec<StateRow>,
    #[serde(default)]
    commands: Vec<Command>,
    #[serde(default)]
    transitions: Vec<Transition>,
    #[serde(default)]
    fault_groups: Vec<FaultGroup>,
    #[serde(default)]
    faults: Vec<FaultRow>,
    #[serde(default)]
    errors: Vec<ErrorRow>,
    #[serde(default)]
    counters: Vec<CounterRow>,
    #[serde(default)]
    roles: BTreeMap<String, u32>,
    #[serde(default)]
    groups: BTreeMap<String, Vec<u32>>,
    #[serde(default)]
    enums: BTreeMap<String, BTreeMap<String, EnumRow>>,
    #[serde(default)]
    bits: BTreeMap<String, BTreeMap<String, BitRow>>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct DriveRow {
    id: String,
    en: String,
    de: String,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct ParamRow {
    id: u32,
    slug: Option<String>,
    short: Option<String>,
    drives: Option<Vec<String>>,
    module: Option<String>,
    de: String,
    en: String,
    unit: Option<String>,
    #[serde(rename = "type")]
    kind: Option<Type>,
    decimals: Option<u8>,
    min: Option<Number>,
    max: Option<Number>,
    default: Option<Number>,
    access: Access,
    sets: Option<Sets>,
    #[serde(default)]
    volatile: bool,
    #[serde(default)]
    effective: Effective,
    hazard: Option<HazardKind>,
    #[serde(rename = "enum")]
    enumeration: Option<String>,
    bits: Option<String>,
    #[serde(default)]
    bits_when: Vec<BitsWhen>,
    #[serde(default)]
    hex: bool,
    note: Option<Text>,
    #[serde(default)]
    unconfirmed: Vec<String>,
    source: Option<String>,
    #[serde(default)]
    replace: bool,
}

/// A number in human units, kept as text so that it stays exact.
#[derive(Clone, Debug)]
struct Number(String);

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

impl Catalogue {
    /// A catalogue of ours; its rows are left for later.
    fn shipped(family: &str, text: &'static str) -> Result<Self, CatalogueError> {
        let origin = Origin::Shipped { path: format!("built-in {family}.toml") };
        let (head, rows) = text.split_once('\n').unwrap_or((text, ""));
        let head = origin.parse(head)?;
        Ok(Catalogue { origin, head, rows: Rows::Shipped(rows) })
    }

    fn read(path: &str, text: &str) -> Result<Self, CatalogueError> {
        let origin = Origin::File { path: path.to_owned(), text: text.to_owned() };
        if text.len() > MAX_FILE {
            let message = format!("{} bytes; a catalogue has at most {MAX_FILE}", text.len());
            return Err(origin.error(Place::File, message));
        }
        let body: Body = toml::from_str(text).map_err(|error| {
            origin.error(Place::Offset(error.span().map_or(0, |span| span.start)), shorten(error.message()))
        })?;
        if body.schema != SCHEMA {
            let message = format!("schema {}; this program reads schema {SCHEMA}", body.schema);
            return Err(origin.error(Place::File, message));
        }
        let (family, title, drives) = (body.family.clone(), body.title.clone(), body.drives.clone());
        let head = Head { family, title, drives };
        Ok(Catalogue { origin, head, rows: Rows::Read(Box::new(body)) })
    }

    fn rows(&self) -> Result<Cow<'_, Body>, CatalogueError> {
        match &self.rows {
            Rows::Shipped(json) => self.origin.parse(json).map(Cow::Owned),
            Rows::Read(body) => Ok(Cow::Borrowed(body)),
        }
    }
}

impl Body {
    /// Whether it has what only our catalogues may have.
    fn belongs_to_us(&self) -> bool {
        self.link.is_some() || self.motion.is_some() || self.fault_codes.is_some()
    }
}

impl Origin {
    fn path(&self) -> &str {
        match self {
            Origin::Shipped { path } | Origin::File { path, .. } => path,
        }
    }

    fn parse<T: DeserializeOwned>(&self, json: &str) -> Result<T, CatalogueError> {
        serde_json::from_str(json).map_err(|error| self.error(Place::File, error.to_string()))
    }

    fn error(&self, place: Place<'_>, message: String) -> CatalogueError {
        let text = match self {
            Origin::Shipped { .. } => "",
            Origin::File { text, .. } => text,
        };
        let (line, column) = super::text::place(text, place.offset(text).unwrap_or(0));
        CatalogueError { path: self.path().to_owned(), line, column, message }
    }

    /// Adds the rows that concern the family's drive.
    fn pour(&self, body: Body, family: &mut Family) -> Result<(), CatalogueError> {
        for (name, table) in body.enums {
            let mut into = family.enums.remove(&name).unwrap_or_default();
            for (value, row) in self.table(("enums", &name), table, |value| into.contains_key(&value))? {
                into.insert(value, Text { en: row.en, de: row.de });
            }
            family.enums.insert(name, into);
        }
        for (name, table) in body.bits {
            let mut into = family.bits.remove(&name).unwrap_or_default();
            let is_known = |bit| u8::try_from(bit).is_ok_and(|bit| into.contains_key(&bit));
            for (bit, row) in self.table(("bits", &name), table, is_known)? {
                into.insert(bit as u8, row);
            }
            family.bits.insert(name, into);
        }
        let anywhere: BTreeSet<u32> = body.params.iter().map(|row| row.id).collect();
        self.params(body.params, family)?;
        for (index, row) in body.faults.iter().enumerate() {
            if row.last.is_some_and(|last| last < row.code) {
                let message = format!("fault {}: last is below code", row.key);
                return Err(self.error(Place::Row("faults", index), message));
            }
        }
        self.join("faults", body.faults, &mut family.faults)?;
        self.join("states", body.states, &mut family.states)?;
        self.join("commands", body.commands, &mut family.machine.commands)?;
        for (index, row) in body.transitions.into_iter().enumerate() {
            if row.drives.as_ref().is_some_and(|drives| !drives.contains(&family.drive)) {
                continue;
            }
            if row.command.as_ref().is_some_and(|slug| family.machine.command(slug).is_none()) {
                let message = format!("transition {}: there is no such command", row.number);
                return Err(self.error(Place::Row("transitions", index), message));
            }
            family.machine.transitions.push(row);
        }
        if let Some(codes) = body.fault_codes {
            family.fault_codes = codes;
        }
        if let Some(link) = body.link {
            family.link = link;
        }
        if let Some(motion) = body.motion {
            family.motion = motion;
        }
        for (index, row) in body.modes.iter().enumerate() {
            if let Some(id) = row.params().find(|id| !family.params.contains_key(id)) {
                let message = format!("mode '{}' names parameter {id}, which has no row", row.slug);
                return Err(self.error(Place::Row("modes", index), message));
            }
        }
        self.join("modes", body.modes, &mut family.modes)?;
        self.join("fault_groups", body.fault_groups, &mut family.fault_groups)?;
        self.join("errors", body.errors, &mut family.errors)?;
        self.join("counters", body.counters, &mut family.counters)?;
        for id in body.roles.values().chain(body.groups.values().flatten()) {
            if !family.params.contains_key(id) && !anywhere.contains(id) {
                let message = format!("a role or group names parameter {id}, which has no row");
                return Err(self.error(Place::File, message));
            }
        }
        family.roles.extend(body.roles);
        family.groups.extend(body.groups);
        Ok(())
    }

    fn params(&self, rows: Vec<ParamRow>, family: &mut Family) -> Result<(), CatalogueError> {
        let mut own = BTreeSet::new();
        let mut slugs: BTreeMap<String, u32> =
            family.params.values().map(|param| (param.slug.clone(), param.id)).collect();
        for (index, row) in rows.into_iter().enumerate() {
            let at = Place::Row("params", index);
            if let Some(unknown) = row.drives.iter().flatten().find(|drive| !family.siblings.contains(drive)) {
                let known = family.siblings.join(", ");
                let message = format!("parameter {}: unknown drive '{unknown}' (expected: {known})", row.id);
                return Err(self.error(at, message));
            }
            if row.drives.as_ref().is_some_and(|drives| !drives.contains(&family.drive)) {
                continue;
            }
            if !own.insert(row.id) {
                return Err(self.error(at, format!("parameter {} stands twice for drive '{}'", row.id, family.drive)));
            }
            if let Some(old) = family.params.get(&row.id)
                && !row.replace
            {
                let message = format!(
                    "parameter {} is already in {}; add replace = true to this row if it shall take its place",
                    row.id, old.origin
                );
                return Err(self.error(at, message));
            }
            let param = self.param(at, row, family)?;
            if let Some(old) = family.params.get(&param.id) {
                slugs.remove(&old.slug);
            }
            if let Some(twin) = slugs.insert(param.slug.clone(), param.id) {
                let message = format!("slug '{}' is already the one of parameter {twin}", param.slug);
                return Err(self.error(at, message));
            }
            family.params.insert(param.id, param);
        }
        Ok(())
    }

    fn param(&self, at: Place<'_>, row: ParamRow, family: &Family) -> Result<Param, CatalogueError> {
        let texts =
            [&row.de, &row.en].into_iter().chain(&row.slug).chain(&row.short).chain(&row.unit).chain(&row.source);
        for text in texts.chain(row.note.iter().flat_map(|note| [&note.en, &note.de])) {
            self.check_text(at, text)?;
        }
        let decimals = row.decimals.unwrap_or(0);
        if decimals > MOST_DECIMALS {
            let message = format!("parameter {}: {decimals} decimals; expected at most {MOST_DECIMALS}", row.id);
            return Err(self.error(at, message));
        }
        let raw = |number: &Option<Number>| {
            let parsed = number.as_ref().map(|number| parse_decimal(&number.0, decimals)).transpose();
            parsed.map_err(|error| self.error(at, format!("parameter {}: {error}", row.id)))
        };
        let (min, max, default) = (raw(&row.min)?, raw(&row.max)?, raw(&row.default)?);
        if let (Some(low), Some(high)) = (min, max)
            && low > high
        {
            return Err(self.error(at, format!("parameter {}: min is above max", row.id)));
        }
        let dangling =
            |kind: &str, name: &str| self.error(at, format!("parameter {}: there is no table [{kind}.{name}]", row.id));
        if let Some(name) = row.enumeration.as_ref().filter(|name| !family.enums.contains_key(*name)) {
            return Err(dangling("enums", name));
        }
        let tables = row.bits.iter().chain(row.bits_when.iter().map(|when| &when.bits));
        if let Some(name) = tables.into_iter().find(|name| !family.bits.contains_key(*name)) {
            return Err(dangling("bits", name));
        }
        Ok(Param {
            id: row.id,
            slug: row.slug.unwrap_or_else(|| super::text::fold(&row.en).replace(' ', "-")),
            short: row.short,
            name: Text { en: row.en, de: row.de },
            unit: row.unit,
            kind: row.kind,
            decimals: row.decimals,
            min,
            max,
            default,
            access: row.access,
            sets: row.sets,
            volatile: row.volatile,
            effective: row.effective,
            hazard: row.hazard,
            enumeration: row.enumeration,
            bits: row.bits,
            bits_when: row.bits_when,
            hex: row.hex,
            note: row.note,
            unconfirmed: row.unconfirmed,
            module: row.module,
            source: row.source.unwrap_or_default(),
            origin: self.path().to_owned(),
        })
    }

    /// Adds rows to a list; the same row twice is an error unless the later one says that it replaces.
    fn join<T: CatalogueRow>(&self, list: &str, rows: Vec<T>, into: &mut Vec<T>) -> Result<(), CatalogueError> {
        let mut known: BTreeMap<String, usize> = into.iter().map(T::key).zip(0..).collect();
        for (index, row) in rows.into_iter().enumerate() {
            let at = Place::Row(list, index);
            self.check_texts(at, &row)?;
            match known.entry(row.key()) {
                Entry::Occupied(old) if row.replaces() => {
                    if let Some(old) = into.get_mut(*old.get()) {
                        *old = row;
                    }
                }
                Entry::Occupied(old) => return Err(self.error(at, twice(old.key()))),
                Entry::Vacant(new) => {
                    new.insert(into.len());
                    into.push(row);
                }
            }
        }
        Ok(())
    }

    /// The rows of a table with their keys as numbers.
    fn table<T: CatalogueRow>(
        &self,
        (tables, name): (&str, &str),
        table: BTreeMap<String, T>,
        is_known: impl Fn(i64) -> bool,
    ) -> Result<Vec<(i64, T)>, CatalogueError> {
        let mut rows = Vec::with_capacity(table.len());
        for (key, row) in table {
            let at = Place::Entry(tables, name, &key);
            self.check_texts(at, &row)?;
            let number = match key.strip_prefix("0x") {
                Some(hex) => i64::from_str_radix(hex, 16).ok(),
                None => key.parse().ok(),
            };
            let number = number
                .ok_or_else(|| self.error(at, format!("table '{name}': key '{}' is no number", shorten(&key))))?;
            if is_known(number) && !row.replaces() {
                return Err(self.error(at, twice(&format!("table '{name}', {number}"))));
            }
            rows.push((number, row));
        }
        Ok(rows)
    }

    fn check_texts<T: CatalogueRow>(&self, at: Place<'_>, row: &T) -> Result<(), CatalogueError> {
        row.texts().into_iter().try_for_each(|text| self.check_text(at, text))
    }

    fn check_text(&self, at: Place<'_>, text: &str) -> Result<(), CatalogueError> {
        if matches!(self, Origin::Shipped { .. }) {
            return Ok(());
        }
        if text.len() > MAX_TEXT {
            return Err(self.error(at, format!("a text of {} bytes; at most {MAX_TEXT} are allowed", text.len())));
        }
        match text.chars().find(|c| c.is_control()) {
            Some(bad) => Err(self.error(at, format!("control character U+{:04X} in a text", u32::from(bad)))),
            None => Ok(()),
        }
    }
}

impl Place<'_> {
    /// Offset in the text of the catalogue, which is parsed once more for it: only errors ask.
    fn offset(self, text: &str) -> Option<usize> {
        let table = |name: &str| Some(DeTable::parse(text).ok()?.get_ref().get(name)?.get_ref().clone());
        match self {
            Place::File => None,
            Place::Offset(at) => Some(at),
            Place::Row(list, index) => Some(table(list)?.get(index)?.span().start),
            Place::Entry(tables, name, key) => Some(table(tables)?.get(name)?.get_ref().get(key)?.span().start),
        }
    }
}

fn twice(what: &str) -> String {
    format!("{what} is there already; add replace = true to this row if it shall take its place")
}

/// A message that may quote the file, without its control characters and not longer than a few lines.
fn shorten(message: &str) -> String {
    let printable = message.chars().map(|c| if c.is_control() { ' ' } else { c });
    printable.take(300).collect()
}

/// Decimals of a parameter: a value of 32 bits has no more digits.
const MOST_DECIMALS: u8 = 9;

#[cfg(test)]
mod tests {
    use super::*;

    fn open(text: &str) -> Result<Registry, CatalogueError> {
        Registry::open(&[CatalogueFile { path: "mine.toml".to_owned(), text: text.to_owned() }])
    }

    fn refused(text: &str) -> String {
        open(text).unwrap_err().to_string()
    }

    const HEAD: &str = "schema = 1\nfamily = \"active\"\n";

    /// What we ship goes through everything that a user's catalogue goes through, and its JSON says the same.
    #[test]
    fn shipped_catalogues_are_proved() {
        let shipped = Registry::open(&[]).unwrap();
        for text in [include_str!("data/active.toml"), include_str!("data/lexium05.toml")] {
            let mut read = Catalogue::read("mine.toml", text).unwrap();
            if let Origin::File { path, .. } = &mut read.origin {
                *path = format!("built-in {}.toml", read.head.family);
            }
            let registry = Registry { files: vec![read], families: RefCell::default() };
            for drive in registry.drives() {
                let [read, shipped] = [&registry, &shipped].map(|registry| registry.load(&drive.id).unwrap().unwrap());
                assert!(
                    format!("{read:?}") == format!("{shipped:?}"),
                    "{}: UPDATE=1 cargo test --test generated",
                    drive.id
                );
            }
        }
    }

    #[test]
    fn a_row_of_the_user_joins_the_family() {
        let registry = open(&format!(
            "{HEAD}params = [\n  {{ id = 1500, de = \"Förderhöhe\", en = \"Head\", unit = \"m\", decimals = 2, min = -999.99, access = \"rw\" }},\n]\n"
        ));
        let family = registry.unwrap().family("acu").unwrap();
        let param = family.param(1500).unwrap();
        assert_eq!((param.slug.as_str(), param.min, param.origin.as_str()), ("head", Some(-99_999), "mine.toml"));
    }

    #[test]
    fn errors_name_file_line_and_column() {
        let row = |rest: &str| {
            format!("{HEAD}params = [\n  {{ id = 1500, de = \"x\", en = \"x\", access = \"r\"{rest} }},\n]\n")
        };
        assert!(refused(&row(", colour = 1")).starts_with("mine.toml:4:"), "{}", refused(&row(", colour = 1")));
        assert!(refused(&row(", min = 2, max = 1")).starts_with("mine.toml:4:3: parameter 1500: min is above max"));
        assert!(refused(&row(", enum = \"no\"")).contains("there is no table [enums.no]"));
        assert!(refused(&row(", decimals = 1, min = 0.25")).contains("more decimals"));
        assert!(refused(&row(", decimals = 40")).contains("at most 9"));
        assert!(refused("schema = 1\nfamily = \"x").starts_with("mine.toml:2:"));
        assert!(refused("schema = 2\nfamily = \"active\"").contains("reads schema 1"));
        assert!(refused("schema = 1\nfamily = \"toaster\"").contains("unknown family 'toaster' (expected: active"));
    }

    #[test]
    fn duplicates_are_refused_unless_they_replace() {
        let row = |rest: &str| {
            format!(
                "{HEAD}params = [{{ id = 372, slug = \"rated-speed\", de = \"x\", en = \"x\", access = \"r\"{rest} }}]"
            )
        };
        assert!(refused(&row("")).contains("already in built-in active.toml; add replace = true"));
        assert_eq!(open(&row(", replace = true")).unwrap().family("act").unwrap().param(372).unwrap().name.en, "x");
        let twice = format!(
            "{HEAD}params = [\n{{ id = 1501, de = \"x\", en = \"x\", access = \"r\" }},\n{{ id = 1501, de = \"x\", en = \"x\", access = \"r\" }}]"
        );
        assert!(refused(&twice).starts_with("mine.toml:5:1: parameter 1501 stands twice"));
    }

    #[test]
    fn rows_of_other_tables_must_replace_openly_too() {
        let fault = |rest: &str| {
            format!(
                "{HEAD}faults = [\n  {{ code = 0x0500, key = \"F0500\", en = \"x\", de = \"x\", cause = {{ en = \"x\", de = \"x\" }}, remedy = {{ en = \"x\", de = \"x\" }}{rest} }}]"
            )
        };
        assert!(
            refused(&fault("")).starts_with("mine.toml:4:3: fault 0x0500 is there already"),
            "{}",
            refused(&fault(""))
        );
        assert_eq!(open(&fault(", replace = true")).unwrap().family("act").unwrap().fault(0x500).unwrap().en, "x");
        let value = format!("{HEAD}[enums.modbus-parity]\n0 = {{ en = \"x\", de = \"x\" }}\n");
        assert!(refused(&value).starts_with("mine.toml:4:5: table 'modbus-parity', 0 is there already"));
        let bit = format!("{HEAD}[bits.mine]\n0 = {{ slug = \"x\", en = \"\\u001b\", de = \"x\" }}\n");
        assert!(refused(&bit).starts_with("mine.toml:4:5: control character"));
    }

    #[test]
    fn hostile_texts_are_refused() {
        let row = |name: &str| format!("{HEAD}params = [{{ id = 1500, de = \"x\", en = \"{name}\", access = \"r\" }}]");
        assert!(refused(&row("\\u001b[31m")).contains("control character U+001B"));
        assert!(refused(&row(&"a".repeat(1 << 20))).contains("at most 2000"));
        assert!(refused(&"#".repeat(MAX_FILE + 1)).contains("at most"));
    }
}
