//! How the rows of a catalogue join those that are there already: each row proved, none replaced unasked.

use super::BUILT_IN;
use super::format::{Body, Number, ParamRow};
use super::place::{CatalogueError, Origin, Position, shorten};
use crate::profile::family::Family;
use crate::profile::machine::Transition;
use crate::profile::motion::Mode;
use crate::profile::names::fold;
use crate::profile::param::{HazardKind, Param};
use crate::profile::row::{BitRow, CatalogueRow, EnumRow, FaultRow};
use crate::profile::value::parse_decimal;
use crate::text::Text;
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

/// Tables of a catalogue by name, their rows by key.
type Tables<T> = BTreeMap<String, BTreeMap<String, T>>;

/// Decimals of a parameter: a value of 32 bits has no more digits.
const MOST_DECIMALS: u8 = 9;

impl Origin {
    /// Adds the rows that concern the family's drive.
    pub(super) fn pour(&self, body: Body, family: &mut Family) -> Result<(), CatalogueError> {
        self.enums(body.enums, family)?;
        self.bits(body.bits, family)?;
        let anywhere: BTreeSet<u32> = body.params.iter().map(|row| row.id).collect();
        self.params(body.params, family)?;
        self.faults(body.faults, family)?;
        self.join("states", body.states, &mut family.states)?;
        self.join("commands", body.commands, &mut family.machine.commands)?;
        self.transitions(body.transitions, family)?;
        family.fault_codes = body.fault_codes.unwrap_or_else(|| std::mem::take(&mut family.fault_codes));
        family.link = body.link.unwrap_or_else(|| std::mem::take(&mut family.link));
        let ordered: Vec<u32> = body.files.iter().flat_map(|files| files.numbers()).collect();
        family.files = body.files.unwrap_or_else(|| std::mem::take(&mut family.files));
        family.motion = body.motion.unwrap_or_else(|| std::mem::take(&mut family.motion));
        self.modes(body.modes, family)?;
        self.join("fault_groups", body.fault_groups, &mut family.fault_groups)?;
        self.join("errors", body.errors, &mut family.errors)?;
        self.join("counters", body.counters, &mut family.counters)?;
        for id in body.roles.values().chain(body.groups.values().flatten()).chain(&ordered) {
            if !family.params.contains_key(id) && !anywhere.contains(id) {
                let message = format!("a role, group or [files] names parameter {id}, which has no row");
                return Err(self.error(Position::File, message));
            }
        }
        family.roles.extend(body.roles);
        family.groups.extend(body.groups);
        family.synonyms.extend(body.synonyms.iter().map(|(said, name)| (fold(said), fold(name))));
        Ok(())
    }

    fn enums(&self, tables: Tables<EnumRow>, family: &mut Family) -> Result<(), CatalogueError> {
        for (name, table) in tables {
            let mut into = family.enums.remove(&name).unwrap_or_default();
            for (value, row) in self.table(("enums", &name), table, |value| into.contains_key(&value))? {
                into.insert(value, Text { en: row.en.into(), de: row.de.into() });
            }
            family.enums.insert(name, into);
        }
        Ok(())
    }

    fn bits(&self, tables: Tables<BitRow>, family: &mut Family) -> Result<(), CatalogueError> {
        for (name, table) in tables {
            let mut into = family.bits.remove(&name).unwrap_or_default();
            let is_known = |bit| u8::try_from(bit).is_ok_and(|bit| into.contains_key(&bit));
            for (bit, row) in self.table(("bits", &name), table, is_known)? {
                into.insert(bit as u8, row);
            }
            family.bits.insert(name, into);
        }
        Ok(())
    }

    fn faults(&self, rows: Vec<FaultRow>, family: &mut Family) -> Result<(), CatalogueError> {
        for (index, row) in rows.iter().enumerate() {
            if row.last.is_some_and(|last| last < row.code) {
                let message = format!("fault {}: last is below code", row.key);
                return Err(self.error(Position::Row("faults", index), message));
            }
        }
        self.join("faults", rows, &mut family.faults)
    }

    fn transitions(&self, rows: Vec<Transition>, family: &mut Family) -> Result<(), CatalogueError> {
        for (index, row) in rows.into_iter().enumerate() {
            if row.drives.as_ref().is_some_and(|drives| !drives.contains(&family.drive)) {
                continue;
            }
            if row.command.as_ref().is_some_and(|slug| family.machine.command(slug).is_none()) {
                let message = format!("transition {}: there is no such command", row.number);
                return Err(self.error(Position::Row("transitions", index), message));
            }
            family.machine.transitions.push(row);
        }
        Ok(())
    }

    fn modes(&self, rows: Vec<Mode>, family: &mut Family) -> Result<(), CatalogueError> {
        for (index, row) in rows.iter().enumerate() {
            if let Some(id) = row.params().find(|id| !family.params.contains_key(id)) {
                let message = format!("mode '{}' names parameter {id}, which has no row", row.slug);
                return Err(self.error(Position::Row("modes", index), message));
            }
        }
        self.join("modes", rows, &mut family.modes)
    }

    fn params(&self, rows: Vec<ParamRow>, family: &mut Family) -> Result<(), CatalogueError> {
        let mut own = BTreeSet::new();
        let mut slugs: BTreeMap<String, u32> =
            family.params.values().map(|param| (param.slug.clone(), param.id)).collect();
        for (index, row) in rows.into_iter().enumerate() {
            let at = Position::Row("params", index);
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
                self.keeps_its_scale(at, old, &param, family)?;
            }
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

    fn param(&self, at: Position<'_>, row: ParamRow, family: &Family) -> Result<Param, CatalogueError> {
        let texts = [&row.de, &row.en]
            .into_iter()
            .chain(&row.slug)
            .chain(&row.short)
            .chain(&row.unit)
            .chain(&row.source)
            .map(String::as_str);
        for text in texts.chain(row.note.iter().flat_map(Text::both)) {
            self.check_text(at, text)?;
        }
        let [min, max, default] = self.limits(at, &row)?;
        self.references(at, &row, family)?;
        // Of a family of which we know nothing nobody knows what outlives the power, unless the row says it.
        let is_ours = BUILT_IN.iter().any(|row| row.0 == family.family);
        let is_told = row.volatile.is_some() || is_ours;
        let kept = (!is_told).then(|| "volatile".to_owned());
        Ok(Param {
            id: row.id,
            slug: row.slug.unwrap_or_else(|| fold(&row.en).replace(' ', "-")),
            short: row.short,
            name: Text { en: row.en.into(), de: row.de.into() },
            unit: row.unit,
            kind: row.kind,
            decimals: row.decimals,
            min,
            max,
            default,
            access: row.access,
            sets: row.sets,
            volatile: row.volatile.unwrap_or_default(),
            effective: row.effective,
            hazard: row.hazard,
            enumeration: row.enumeration,
            bits: row.bits,
            bits_when: row.bits_when,
            hex: row.hex,
            address: row.address,
            note: row.note,
            unconfirmed: row.unconfirmed.into_iter().chain(kept).collect(),
            module: row.module,
            source: row.source.unwrap_or_default(),
            origin: self.path().to_owned(),
        })
    }

    /// A row that takes the place of one that moves a shaft must not say that its numbers mean something else: 20 Hz that
    /// somebody agreed to would be sent as 200.
    fn keeps_its_scale(
        &self,
        at: Position<'_>,
        old: &Param,
        new: &Param,
        family: &Family,
    ) -> Result<(), CatalogueError> {
        let scale = |param: &Param| (param.kind, param.decimals, param.unit.clone());
        let moves = old.hazard == Some(HazardKind::Motion) || family.roles.values().any(|id| *id == old.id);
        if !moves || scale(old) == scale(new) {
            return Ok(());
        }
        let message = format!(
            "parameter {}: type, decimals and unit stay as {} has them, because runs are computed with them",
            old.id, old.origin
        );
        Err(self.error(at, message))
    }

    /// Smallest, largest and factory value, raw.
    fn limits(&self, at: Position<'_>, row: &ParamRow) -> Result<[Option<i64>; 3], CatalogueError> {
        let decimals = row.decimals.unwrap_or(0);
        if decimals > MOST_DECIMALS {
            let message = format!("parameter {}: {decimals} decimals; expected at most {MOST_DECIMALS}", row.id);
            return Err(self.error(at, message));
        }
        let numbers = [&row.min, &row.max, &row.default].into_iter().flatten().next();
        if let Some(kind) = row.kind.filter(|kind| kind.is_coded())
            && (row.decimals.is_some() || numbers.is_some())
        {
            let (id, kind) = (row.id, kind.name());
            let message = format!("parameter {id}: a {kind} has no decimals, min, max and default here");
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
        Ok([min, max, default])
    }

    /// Tables that a parameter names must be there.
    fn references(&self, at: Position<'_>, row: &ParamRow, family: &Family) -> Result<(), CatalogueError> {
        let dangling =
            |kind: &str, name: &str| self.error(at, format!("parameter {}: there is no table [{kind}.{name}]", row.id));
        if let Some(name) = row.enumeration.as_ref().filter(|name| !family.enums.contains_key(*name)) {
            return Err(dangling("enums", name));
        }
        let tables = row.bits.iter().chain(row.bits_when.iter().map(|when| &when.bits));
        if let Some(name) = tables.into_iter().find(|name| !family.bits.contains_key(*name)) {
            return Err(dangling("bits", name));
        }
        Ok(())
    }

    /// Adds rows to a list; the same row twice is an error unless the later one says that it replaces.
    fn join<T: CatalogueRow>(&self, list: &str, rows: Vec<T>, into: &mut Vec<T>) -> Result<(), CatalogueError> {
        let mut known: BTreeMap<String, usize> = into.iter().map(T::key).zip(0..).collect();
        for (index, row) in rows.into_iter().enumerate() {
            let at = Position::Row(list, index);
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
            let at = Position::Entry(tables, name, &key);
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
}

fn twice(what: &str) -> String {
    format!("{what} is there already; add replace = true to this row if it shall take its place")
}
