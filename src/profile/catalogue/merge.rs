//! How the rows of a catalogue join those that are there already: each row proved, none replaced unasked.

use super::BUILT_IN;
use super::format::{Body, Number, ParamRow};
use super::place::{Origin, Position};
use crate::profile::broken::{Broken, shorten};
use crate::profile::family::Family;
use crate::profile::machine::Transition;
use crate::profile::motion::Mode;
use crate::profile::names::fold;
use crate::profile::param::{HazardKind, Param};
use crate::profile::row::{BitRow, CatalogueRow, EnumRow, FaultRow};
use crate::profile::value::parse_decimal;
use crate::text::{Text, both};
use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet};

/// Tables of a catalogue by name, their rows by key.
type Tables<T> = BTreeMap<String, BTreeMap<String, T>>;

/// Decimals of a parameter: a value of 32 bits has no more digits.
const MOST_DECIMALS: u8 = 9;

impl Origin {
    /// Adds the rows that concern the family's drive.
    pub(super) fn pour(&self, body: Body, family: &mut Family) -> Result<(), Broken> {
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
                let message = both!(
                    "a role, group or `[files]` names parameter {id}, which has no row",
                    "eine Rolle, eine Gruppe oder `[files]` nennt Parameter {id}, der keine Zeile hat"
                );
                return Err(self.error(Position::File, message));
            }
        }
        family.roles.extend(body.roles);
        family.groups.extend(body.groups);
        family.synonyms.extend(body.synonyms.iter().map(|(said, name)| (fold(said), fold(name))));
        Ok(())
    }

    fn enums(&self, tables: Tables<EnumRow>, family: &mut Family) -> Result<(), Broken> {
        for (name, table) in tables {
            let mut into = family.enums.remove(&name).unwrap_or_default();
            for (value, row) in self.table(("enums", &name), table, |value| into.contains_key(&value))? {
                into.insert(value, Text { en: row.en.into(), de: row.de.into() });
            }
            family.enums.insert(name, into);
        }
        Ok(())
    }

    fn bits(&self, tables: Tables<BitRow>, family: &mut Family) -> Result<(), Broken> {
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

    fn faults(&self, rows: Vec<FaultRow>, family: &mut Family) -> Result<(), Broken> {
        for (index, row) in rows.iter().enumerate() {
            if row.last.is_some_and(|last| last < row.code) {
                let message =
                    both!("fault {key}: last is below code", "Störung {key}: last ist kleiner als code", key = row.key);
                return Err(self.error(Position::Row("faults", index), message));
            }
        }
        self.join("faults", rows, &mut family.faults)
    }

    fn transitions(&self, rows: Vec<Transition>, family: &mut Family) -> Result<(), Broken> {
        for (index, row) in rows.into_iter().enumerate() {
            if row.drives.as_ref().is_some_and(|drives| !drives.contains(&family.drive)) {
                continue;
            }
            if row.command.as_ref().is_some_and(|slug| family.machine.command(slug).is_none()) {
                let message = both!(
                    "transition {number}: there is no such command",
                    "Übergang {number}: diesen Befehl gibt es nicht",
                    number = row.number
                );
                return Err(self.error(Position::Row("transitions", index), message));
            }
            family.machine.transitions.push(row);
        }
        Ok(())
    }

    fn modes(&self, rows: Vec<Mode>, family: &mut Family) -> Result<(), Broken> {
        for (index, row) in rows.iter().enumerate() {
            if let Some(id) = row.params().find(|id| !family.params.contains_key(id)) {
                let message = both!(
                    "mode '{mode}' names parameter {id}, which has no row",
                    "die Betriebsart '{mode}' nennt Parameter {id}, der keine Zeile hat",
                    mode = row.slug
                );
                return Err(self.error(Position::Row("modes", index), message));
            }
        }
        self.join("modes", rows, &mut family.modes)
    }

    fn params(&self, rows: Vec<ParamRow>, family: &mut Family) -> Result<(), Broken> {
        let mut own = BTreeSet::new();
        let mut slugs: BTreeMap<String, u32> =
            family.params.values().map(|param| (param.slug.clone(), param.id)).collect();
        for (index, row) in rows.into_iter().enumerate() {
            let at = Position::Row("params", index);
            if let Some(unknown) = row.drives.iter().flatten().find(|drive| !family.siblings.contains(drive)) {
                let known = family.siblings.join(", ");
                let message = both!(
                    "parameter {id}: unknown drive '{unknown}' (expected: {known})",
                    "Parameter {id}: unbekannter Antrieb '{unknown}' (erwartet: {known})",
                    id = row.id
                );
                return Err(self.error(at, message));
            }
            if row.drives.as_ref().is_some_and(|drives| !drives.contains(&family.drive)) {
                continue;
            }
            if !own.insert(row.id) {
                let message = both!(
                    "parameter {id} stands twice for drive '{drive}'",
                    "Parameter {id} steht für den Antrieb '{drive}' zweimal da",
                    id = row.id,
                    drive = family.drive
                );
                return Err(self.error(at, message));
            }
            if let Some(old) = family.params.get(&row.id)
                && !row.replace
            {
                let message = both!(
                    "parameter {id} is already in {place}; {replace}",
                    "Parameter {id} steht schon in {place}; {replace}",
                    id = row.id,
                    place = place(&old.origin),
                    replace = REPLACE
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
                let message = both!(
                    "slug '{slug}' is already the one of parameter {twin}",
                    "der Kurzname '{slug}' gehört schon zu Parameter {twin}",
                    slug = param.slug
                );
                return Err(self.error(at, message));
            }
            family.params.insert(param.id, param);
        }
        Ok(())
    }

    fn param(&self, at: Position<'_>, row: ParamRow, family: &Family) -> Result<Param, Broken> {
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
            elements: row.elements,
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
    fn keeps_its_scale(&self, at: Position<'_>, old: &Param, new: &Param, family: &Family) -> Result<(), Broken> {
        let scale = |param: &Param| (param.kind, param.decimals, param.unit.clone());
        let moves = old.hazard == Some(HazardKind::Motion) || family.roles.values().any(|id| *id == old.id);
        if !moves || scale(old) == scale(new) {
            return Ok(());
        }
        let message = both!(
            "parameter {id}: type, decimals and unit stay as {place} has them, because runs are computed with them",
            "Parameter {id}: Typ, Nachkommastellen und Einheit bleiben wie in {place}, weil Läufe mit ihnen gerechnet werden",
            id = old.id,
            place = old.origin
        );
        Err(self.error(at, message))
    }

    /// Smallest, largest and factory value, raw.
    fn limits(&self, at: Position<'_>, row: &ParamRow) -> Result<[Option<i64>; 3], Broken> {
        let decimals = row.decimals.unwrap_or(0);
        if decimals > MOST_DECIMALS {
            let message = both!(
                "parameter {id}: {decimals} decimals; expected at most {MOST_DECIMALS}",
                "Parameter {id}: {decimals} Nachkommastellen; erwartet werden höchstens {MOST_DECIMALS}",
                id = row.id
            );
            return Err(self.error(at, message));
        }
        let numbers = [&row.min, &row.max, &row.default].into_iter().flatten().next();
        if let Some(kind) = row.kind.filter(|kind| kind.is_coded())
            && (row.decimals.is_some() || numbers.is_some())
        {
            let message = both!(
                "parameter {id}: a {kind} has no `decimals`, `min`, `max` and `default` here",
                "Parameter {id}: `{kind}` hat hier kein `decimals`, `min`, `max` und `default`",
                id = row.id,
                kind = kind.name()
            );
            return Err(self.error(at, message));
        }
        let raw = |number: &Option<Number>| {
            let parsed = number.as_ref().map(|number| parse_decimal(&number.0, decimals)).transpose();
            parsed.map_err(|error| {
                self.error(at, both!("parameter {id}: {why}", "Parameter {id}: {why}", id = row.id, why = error.text()))
            })
        };
        let (min, max, default) = (raw(&row.min)?, raw(&row.max)?, raw(&row.default)?);
        if let (Some(low), Some(high)) = (min, max)
            && low > high
        {
            let message = both!(
                "parameter {id}: `min` is above `max`",
                "Parameter {id}: `min` ist größer als `max`",
                id = row.id
            );
            return Err(self.error(at, message));
        }
        Ok([min, max, default])
    }

    /// Tables that a parameter names must be there.
    fn references(&self, at: Position<'_>, row: &ParamRow, family: &Family) -> Result<(), Broken> {
        let dangling = |kind: &str, name: &str| {
            let message = both!(
                "parameter {id}: there is no table `[{kind}.{name}]`",
                "Parameter {id}: es gibt keine Tabelle `[{kind}.{name}]`",
                id = row.id
            );
            self.error(at, message)
        };
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
    fn join<T: CatalogueRow>(&self, list: &str, rows: Vec<T>, into: &mut Vec<T>) -> Result<(), Broken> {
        let mut known: BTreeMap<Text, usize> = into.iter().map(T::key).zip(0..).collect();
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
    ) -> Result<Vec<(i64, T)>, Broken> {
        let mut rows = Vec::with_capacity(table.len());
        for (key, row) in table {
            let at = Position::Entry(tables, name, &key);
            self.check_texts(at, &row)?;
            let number = match key.strip_prefix("0x") {
                Some(hex) => i64::from_str_radix(hex, 16).ok(),
                None => key.parse().ok(),
            };
            let no_number = || {
                both!(
                    "table '{name}': key '{key}' is no number",
                    "Tabelle '{name}': der Schlüssel '{key}' ist keine Zahl",
                    key = shorten(&key)
                )
            };
            let number = number.ok_or_else(|| self.error(at, no_number()))?;
            if is_known(number) && !row.replaces() {
                let row = both!("table '{name}', {number}", "Tabelle '{name}', {number}");
                return Err(self.error(at, twice(&row)));
            }
            rows.push((number, row));
        }
        Ok(rows)
    }
}

/// What to do about a row that is there already.
const REPLACE: Text = Text::new(
    "add `replace = true` to this row if it shall take its place",
    "mit `replace = true` tritt diese Zeile an ihre Stelle",
);

fn twice(what: &Text) -> Text {
    both!("{what} is there already; {replace}", "{what} ist schon da; {replace}", what, replace = REPLACE)
}

/// A catalogue by its origin: a file of somebody's own, or one that came with the program.
fn place(origin: &str) -> Text {
    let file = origin.strip_prefix("built-in ");
    file.map_or_else(|| Text::name(origin), |file| both!("built-in {file}", "der eingebauten {file}"))
}
