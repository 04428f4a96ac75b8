//! What the lines of a file mean for a drive of its family.

use super::advice::no_value;
use super::file::{Line, ParamFile};
use super::parse::FileFault;
use super::settings::{Setting, Settings};
use crate::profile::LookupError;
use crate::profile::family::Family;
use crate::profile::param::{Param, Type};
use crate::profile::select::{DataSets, SelectError, Selector, Store};
use crate::profile::value::{self, ValueError};
use crate::text::{Text, both};

impl ParamFile {
    /// The lines by number and data set, with raw values. Ranges are not looked at: what a drive told may lie outside of
    /// them, and only what is written is held against them.
    ///
    /// # Errors
    /// A line that names no parameter of the family, a value that is none of it, or two lines for one place.
    pub fn settings(&self, family: &Family) -> Result<Settings, FileFault> {
        self.resolved(&self.lines, family)
    }

    /// What a transaction was about to write; `None` if the file is none that takes one back.
    ///
    /// # Errors
    /// As [`ParamFile::settings`].
    pub fn coming(&self, family: &Family) -> Option<Result<Settings, FileFault>> {
        self.undo.as_ref().map(|undo| self.resolved(&undo.lines, family))
    }

    /// What stood in the RAM alone before a transaction; none where the file says nothing of it.
    ///
    /// # Errors
    /// As [`ParamFile::settings`].
    pub fn in_ram_alone(&self, family: &Family) -> Result<Settings, FileFault> {
        self.resolved(self.undo.as_ref().map_or(&[], |undo| undo.ram.as_slice()), family)
    }

    /// What perhaps did not come back when a transaction failed; none where the file says nothing of it.
    ///
    /// # Errors
    /// As [`ParamFile::settings`].
    pub fn unproven(&self, family: &Family) -> Result<Settings, FileFault> {
        self.resolved(self.undo.as_ref().map_or(&[], |undo| undo.unproven.as_slice()), family)
    }

    fn resolved(&self, lines: &[Line], family: &Family) -> Result<Settings, FileFault> {
        let mut settings = Settings::default();
        for line in lines {
            let (param, set) = self.place(line, family)?;
            // What was found out by asking goes before what a catalogue presumes.
            let kind = self.head.types.get(&param.id).copied().or(param.kind);
            let raw = raw(line, family, &param, kind)?;
            if let Some(before) = settings.exactly(param.id, set) {
                let why = both!(
                    "P.{param} in this data set has its value in line {line} already",
                    "P.{param} hat in diesem Datensatz schon in Zeile {line} seinen Wert",
                    param = param.id,
                    line = before.at.line
                );
                return Err(FileFault::new(line.at.clone(), why));
            }
            settings.insert(Setting { param, set, raw, kind, at: line.at.clone() });
        }
        Ok(settings)
    }

    /// The parameter and data set that a line is about.
    fn place(&self, line: &Line, family: &Family) -> Result<(Param, u8), FileFault> {
        let fault = |why: Text| FileFault::new(line.at.clone(), why);
        let selector: Selector = line.key.parse().map_err(|error| fault(unread(&error)))?;
        let set = match selector.sets() {
            DataSets::Unnamed | DataSets::All(Store::Eeprom) => 0,
            DataSets::One(set, Store::Eeprom) => set,
            DataSets::One(_, Store::Ram) | DataSets::All(Store::Ram) => {
                return Err(fault(both!(
                    "'{key}': a parameter file names what is stored, data sets 0 to 4",
                    "'{key}': eine Parameterdatei nennt, was gespeichert ist, Datensatz 0 bis 4",
                    key = line.key
                )));
            }
        };
        let found = selector.resolve(family).map_err(|error| fault(unknown(&error)))?;
        let param = match <[_; 1]>::try_from(found) {
            Ok([one]) if !one.of_group => one.param,
            _ => {
                return Err(fault(both!(
                    "'{key}': a line names one parameter, such as 372@2",
                    "'{key}': eine Zeile nennt einen Parameter, etwa 372@2",
                    key = line.key
                )));
            }
        };
        if !family.link.carries(param.number()) {
            let why = both!(
                "there is no parameter {number}: {numbers}",
                "einen Parameter {number} gibt es nicht: {numbers}",
                number = param.id,
                numbers = family.link.numbers
            );
            return Err(fault(why));
        }
        if set != 0 && !family.link.route.has_data_sets() {
            return Err(fault(both!("this family has no data sets", "diese Familie hat keine Datensätze")));
        }
        Ok((param, set))
    }
}

/// Why a key is none: a file names fewer data sets than are typed.
fn unread(error: &SelectError) -> Text {
    match error {
        SelectError::Set(set) => both!(
            "'{set}' is no data set of a parameter file: expected 0-4, and a line for each",
            "'{set}' ist kein Datensatz einer Parameterdatei: erwartet 0-4, und für jeden eine Zeile"
        ),
        _ => error.text(),
    }
}

/// Why nothing of that name can be had, and what was perhaps meant.
fn unknown(error: &SelectError) -> Text {
    let why = error.text();
    match error {
        SelectError::Lookup(LookupError::Unknown { near, .. }) if !near.is_empty() => both!(
            "{why}; did you mean {near}?",
            "{why}; gemeint ist vielleicht {near}",
            why,
            near = Text::join(near, ", ")
        ),
        _ => why,
    }
}

/// The raw value of a line.
fn raw(line: &Line, family: &Family, param: &Param, kind: Option<Type>) -> Result<i64, FileFault> {
    let fault = |error: ValueError| FileFault::new(line.value_at.clone(), error.text());
    let raw = match line.value.strip_prefix("raw ") {
        Some(raw) => value::parse_decimal(raw.trim(), 0).map_err(fault)?,
        None => value::parse(&line.value, param, &family.choices(param)).map_err(|error| {
            let is_scale = matches!(error, ValueError::NoScale { .. });
            let mut fault = fault(error);
            if is_scale {
                let why = fault.why;
                fault.why = both!("{why}; `raw 1234` is the integer", "{why}; `raw 1234` ist die Ganzzahl", why);
            }
            FileFault { hint: line.value.trim().is_empty().then(|| Box::new(no_value())), ..fault }
        })?,
    };
    match kind.map(|kind| (kind, family.link.route.carried(kind))) {
        Some((kind, carried)) if kind == carried => value::check_type(raw, kind, param).map_err(fault)?,
        // A drive may tell more there than its type promises.
        Some((_, carried)) => value::check_width(raw, carried, param.decimals_or_zero()).map_err(fault)?,
        None => {}
    }
    Ok(raw)
}
