//! The one catalogue format, for what we ship and for what users bring: TOML, one inline table per parameter.
//!
//! A catalogue is refused as a whole, with file, line and column, if it has unknown keys, duplicate ids, control
//! characters, dangling references or limits that do not fit its decimals.

use super::family::{BitRow, CatalogueRow, CounterRow, EnumRow, ErrorRow, Family, FaultGroup, FaultRow, StateRow};
use super::machine::{Command, Transition};
use super::param::{Access, BitsWhen, Effective, HazardKind, Param, Sets, Type};
use super::text::Text;
use super::value::parse_decimal;
use serde::{Deserialize, Deserializer, de};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt;
use std::rc::Rc;
use toml::Spanned;

/// Version of the format that this program reads.
const SCHEMA: i64 = 1;
/// Largest catalogue that is read at all.
const MAX_FILE: usize = 4 << 20;
/// Longest name, text or remark.
const MAX_TEXT: usize = 2_000;

/// The catalogues that we ship: family, text.
const BUILT_IN: &[(&str, &str)] = &[("active", include_str!("data/active.toml"))];

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
            files.push(Catalogue::read(&format!("built-in {family}.toml"), text)?);
        }
        for file in user {
            let catalogue = Catalogue::read(&file.path, &file.text)?;
            if !files.iter().any(|known| known.body.family == catalogue.body.family) {
                let known: Vec<_> = BUILT_IN.iter().map(|row| row.0).collect();
                let message = format!("unknown family '{}' (expected: {})", catalogue.body.family, known.join(", "));
                return Err(catalogue.error(0, message));
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

    /// Every drive, in the order of the catalogues.
    pub fn drives(&self) -> Vec<DriveTitle> {
        let rows = self.files.iter().flat_map(|file| &file.body.drives);
        rows.map(|row| DriveTitle { id: row.id.clone(), title: Text { en: row.en.clone(), de: row.de.clone() } })
            .collect()
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
        let Some(home) = self.files.iter().find(|file| file.body.drives.iter().any(|row| row.id == drive)) else {
            return Ok(None);
        };
        let mut family = Family::empty(&home.body.family, drive, home.body.title.clone().unwrap_or_default());
        family.siblings = home.body.drives.iter().map(|row| row.id.clone()).collect();
        for file in self.files.iter().filter(|file| file.body.family == home.body.family) {
            file.pour(&mut family)?;
        }
        Ok(Some(family))
    }
}

/// One catalogue file as it was read.
#[derive(Clone, Debug)]
struct Catalogue {
    path: String,
    /// Offset of the start of every line.
    lines: Vec<usize>,
    body: Body,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Body {
    schema: i64,
    family: String,
    title: Option<Text>,
    #[serde(default)]
    drives: Vec<DriveRow>,
    #[serde(default)]
    params: Vec<Spanned<ParamRow>>,
    #[serde(default)]
    states: Vec<Spanned<StateRow>>,
    #[serde(default)]
    commands: Vec<Spanned<Command>>,
    #[serde(default)]
    transitions: Vec<Spanned<Transition>>,
    #[serde(default)]
    fault_groups: Vec<Spanned<FaultGroup>>,
    #[serde(default)]
    faults: Vec<Spanned<FaultRow>>,
    #[serde(default)]
    errors: Vec<Spanned<ErrorRow>>,
    #[serde(default)]
    counters: Vec<Spanned<CounterRow>>,
    #[serde(default)]
    roles: BTreeMap<String, u32>,
    #[serde(default)]
    groups: BTreeMap<String, Vec<u32>>,
    #[serde(default)]
    enums: BTreeMap<String, BTreeMap<String, Spanned<EnumRow>>>,
    #[serde(default)]
    bits: BTreeMap<String, BTreeMap<String, Spanned<BitRow>>>,
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
    fn read(path: &str, text: &str) -> Result<Self, CatalogueError> {
        let lines = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect::<Vec<_>>();
        let empty = Body {
            schema: SCHEMA,
            family: String::new(),
            title: None,
            drives: Vec::new(),
            params: Vec::new(),
            states: Vec::new(),
            commands: Vec::new(),
            transitions: Vec::new(),
            fault_groups: Vec::new(),
            faults: Vec::new(),
            errors: Vec::new(),
            counters: Vec::new(),
            roles: BTreeMap::new(),
            groups: BTreeMap::new(),
            enums: BTreeMap::new(),
            bits: BTreeMap::new(),
        };
        let mut catalogue = Catalogue { path: path.to_owned(), lines, body: empty };
        if text.len() > MAX_FILE {
            return Err(catalogue.error(0, format!("{} bytes; a catalogue has at most {MAX_FILE}", text.len())));
        }
        catalogue.body = toml::from_str(text)
            .map_err(|error| catalogue.error(error.span().map_or(0, |span| span.start), shorten(error.message())))?;
        if catalogue.body.schema != SCHEMA {
            let message = format!("schema {}; this program reads schema {SCHEMA}", catalogue.body.schema);
            return Err(catalogue.error(0, message));
        }
        Ok(catalogue)
    }

    fn error(&self, offset: usize, message: String) -> CatalogueError {
        let line = self.lines.partition_point(|&start| start <= offset).max(1);
        let column = offset - self.lines.get(line - 1).copied().unwrap_or(0) + 1;
        CatalogueError { path: self.path.clone(), line, column, message }
    }

    /// Adds the rows of this file that concern the family's drive.
    fn pour(&self, family: &mut Family) -> Result<(), CatalogueError> {
        for (name, table) in &self.body.enums {
            let into = family.enums.entry(name.clone()).or_default();
            for (value, row) in self.table(name, table, |value| into.contains_key(&value))? {
                into.insert(value, Text { en: row.en, de: row.de });
            }
        }
        for (name, table) in &self.body.bits {
            let into = family.bits.entry(name.clone()).or_default();
            for (bit, row) in
                self.table(name, table, |bit| u8::try_from(bit).is_ok_and(|bit| into.contains_key(&bit)))?
            {
                into.insert(bit as u8, row);
            }
        }
        let mut own = Vec::new();
        for row in &self.body.params {
            let at = row.span().start;
            let row = row.get_ref();
            if let Some(unknown) = row.drives.iter().flatten().find(|drive| !family.siblings.contains(drive)) {
                let known = family.siblings.join(", ");
                return Err(
                    self.error(at, format!("parameter {}: unknown drive '{unknown}' (expected: {known})", row.id))
                );
            }
            if row.drives.as_ref().is_some_and(|drives| !drives.contains(&family.drive)) {
                continue;
            }
            if own.contains(&row.id) {
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
            own.push(row.id);
            let param = self.param(at, row, family)?;
            if let Some(twin) = family.params.values().find(|other| other.slug == param.slug && other.id != param.id) {
                let message = format!("slug '{}' is already the one of parameter {}", param.slug, twin.id);
                return Err(self.error(at, message));
            }
            family.params.insert(param.id, param);
        }
        for row in &self.body.faults {
            if row.get_ref().last.is_some_and(|last| last < row.get_ref().code) {
                return Err(self.error(row.span().start, format!("fault {}: last is below code", row.get_ref().key)));
            }
        }
        self.join(&self.body.faults, &mut family.faults)?;
        self.join(&self.body.states, &mut family.states)?;
        self.join(&self.body.commands, &mut family.machine.commands)?;
        for row in &self.body.transitions {
            let (at, row) = (row.span().start, row.get_ref());
            if row.drives.as_ref().is_some_and(|drives| !drives.contains(&family.drive)) {
                continue;
            }
            let known = |slug: &String| family.machine.command(slug).is_some();
            if row.command.as_ref().is_some_and(|slug| !known(slug)) {
                return Err(self.error(at, format!("transition {}: there is no such command", row.number)));
            }
            family.machine.transitions.push(row.clone());
        }
        self.join(&self.body.fault_groups, &mut family.fault_groups)?;
        self.join(&self.body.errors, &mut family.errors)?;
        self.join(&self.body.counters, &mut family.counters)?;
        family.roles.extend(self.body.roles.iter().map(|(name, &id)| (name.clone(), id)));
        family.groups.extend(self.body.groups.iter().map(|(name, ids)| (name.clone(), ids.clone())));
        let mentioned = self.body.roles.values().chain(self.body.groups.values().flatten());
        for id in mentioned {
            let anywhere = family.params.contains_key(id) || self.body.params.iter().any(|row| row.get_ref().id == *id);
            if !anywhere {
                return Err(self.error(0, format!("a role or group names parameter {id}, which has no row")));
            }
        }
        Ok(())
    }

    fn param(&self, at: usize, row: &ParamRow, family: &Family) -> Result<Param, CatalogueError> {
        let texts = [&row.de, &row.en].into_iter().chain(&row.slug).chain(&row.unit).chain(&row.source);
        for text in texts.chain(row.note.iter().flat_map(|note| [&note.en, &note.de])) {
            self.check_text(at, text)?;
        }
        let decimals = row.decimals.unwrap_or(0);
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
            slug: row.slug.clone().unwrap_or_else(|| super::text::fold(&row.en).replace(' ', "-")),
            name: Text { en: row.en.clone(), de: row.de.clone() },
            unit: row.unit.clone(),
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
            enumeration: row.enumeration.clone(),
            bits: row.bits.clone(),
            bits_when: row.bits_when.clone(),
            hex: row.hex,
            note: row.note.clone(),
            unconfirmed: row.unconfirmed.clone(),
            module: row.module.clone(),
            source: row.source.clone().unwrap_or_default(),
            origin: self.path.clone(),
        })
    }

    /// Adds rows to a list; the same row twice is an error unless the later one says that it replaces.
    fn join<T: CatalogueRow>(&self, rows: &[Spanned<T>], into: &mut Vec<T>) -> Result<(), CatalogueError> {
        for row in rows {
            let (at, row) = (row.span().start, row.get_ref());
            self.check_texts(at, row)?;
            match into.iter_mut().find(|known| known.key() == row.key()) {
                Some(known) if row.replaces() => *known = row.clone(),
                Some(_) => return Err(self.error(at, twice(&row.key()))),
                None => into.push(row.clone()),
            }
        }
        Ok(())
    }

    /// The rows of a table with their keys as numbers.
    fn table<T: CatalogueRow>(
        &self,
        name: &str,
        table: &BTreeMap<String, Spanned<T>>,
        is_known: impl Fn(i64) -> bool,
    ) -> Result<Vec<(i64, T)>, CatalogueError> {
        let mut rows = Vec::new();
        for (key, row) in table {
            let (at, row) = (row.span().start, row.get_ref());
            self.check_texts(at, row)?;
            let number = match key.strip_prefix("0x") {
                Some(hex) => i64::from_str_radix(hex, 16).ok(),
                None => key.parse().ok(),
            };
            let number =
                number.ok_or_else(|| self.error(at, format!("table '{name}': key '{}' is no number", shorten(key))))?;
            if is_known(number) && !row.replaces() {
                return Err(self.error(at, twice(&format!("table '{name}', {number}"))));
            }
            rows.push((number, row.clone()));
        }
        Ok(rows)
    }

    fn check_texts<T: CatalogueRow>(&self, at: usize, row: &T) -> Result<(), CatalogueError> {
        row.texts().into_iter().try_for_each(|text| self.check_text(at, text))
    }

    fn check_text(&self, at: usize, text: &str) -> Result<(), CatalogueError> {
        if text.len() > MAX_TEXT {
            return Err(self.error(at, format!("a text of {} bytes; at most {MAX_TEXT} are allowed", text.len())));
        }
        match text.chars().find(|c| c.is_control()) {
            Some(bad) => Err(self.error(at, format!("control character U+{:04X} in a text", u32::from(bad)))),
            None => Ok(()),
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
