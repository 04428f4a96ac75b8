//! The rows under a head line, which is the same whatever was found, each cell a plain value: of a word its hex and, in a column of
//! their own, the names of the bits that are set; a list as its members with semicolons between them; a record, or a list of them, in a column
//! for each of its fields.

use super::Print;
use crate::render::finding::{Column, Rows};
use crate::render::spoken::pick;
use crate::render::{clean, finding};
use serde_json::{Map, Value};
use std::io::{self, Write};

pub(super) fn print(page: &Print<'_>, out: &mut dyn Write) -> io::Result<()> {
    let Some(data) = &page.outcome.data else { return Ok(()) };
    let Rows { columns, mut rows } = finding::of(data).rows();
    rows.iter_mut().flat_map(|row| row.fields.values_mut()).for_each(|field| pick(field, page.manner.lang));
    let columns: Vec<Place> = columns.into_iter().flat_map(|column| places(column, &[])).collect();
    let mut writer = ::csv::Writer::from_writer(out);
    writer.write_record(columns.iter().map(Place::name)).map_err(io_error)?;
    for row in &rows {
        writer.write_record(columns.iter().map(|place| clean(&place.cell(&row.fields)))).map_err(io_error)?;
    }
    writer.flush()
}

/// A column of the text: where its value lies in a row, and whether the bits of that are meant.
struct Place {
    path: Vec<String>,
    is_bits: bool,
}

/// The columns of a field: its own, and that of its bits where it is a word; or those of its parts.
fn places(column: Column, under: &[String]) -> Vec<Place> {
    let is_record = is_record(&column);
    let Column { name, is_word, parts, .. } = column;
    let path: Vec<String> = under.iter().cloned().chain([name]).collect();
    if is_record {
        return parts.into_iter().flat_map(|part| places(part, &path)).collect();
    }
    let bits = is_word.then(|| Place { path: path.clone(), is_bits: true });
    std::iter::once(Place { path, is_bits: false }).chain(bits).collect()
}

/// Whether what a field holds is told by nothing shorter than its fields.
fn is_record(Column { is_word, parts, .. }: &Column) -> bool {
    let has = |name: &str| parts.iter().any(|part| part.name == name);
    let is_told = TOLD.iter().any(|told| told.iter().all(|name| has(name)));
    let is_other = ABSENT.iter().any(|name| has(name)) || READING.iter().all(|name| has(name)) || has("bit");
    !parts.is_empty() && !is_word && !is_told && !is_other
}

impl Place {
    fn name(&self) -> String {
        let name = self.path.join("_");
        if self.is_bits { name + BITS } else { name }
    }

    fn cell(&self, fields: &Map<String, Value>) -> String {
        let Some((first, rest)) = self.path.split_first() else { return String::new() };
        fields.get(first).map_or_else(String::new, |value| self.told(value, rest))
    }

    fn told(&self, value: &Value, path: &[String]) -> String {
        match (value, path.split_first()) {
            (word, None) if self.is_bits => word.get("bits").filter(|_| is_word(word)).map_or_else(String::new, plain),
            (value, None) => plain(value),
            (Value::Array(list), Some(_)) => {
                let cells: Vec<_> = list.iter().map(|item| self.told(item, path)).collect();
                // Where none of them has it there is nothing to keep apart.
                if cells.iter().all(String::is_empty) { String::new() } else { cells.join("; ") }
            }
            (value, Some((first, rest))) => value.get(first).map_or_else(String::new, |part| self.told(part, rest)),
        }
    }
}

/// What stands behind the name of a word over its bits.
const BITS: &str = "_bits";

fn is_word(value: &Value) -> bool {
    value.get("hex").is_some_and(Value::is_string) && value.get("bits").is_some_and(Value::is_array)
}

/// A value without any JSON around it: of what was read the number, of any other object what it is called or says, else its
/// fields by name.
fn plain(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Array(list) => {
            let is_clear = |item: &&Value| ABSENT.iter().any(|flag| item.get(flag) == Some(&Value::Bool(false)));
            let told = |item: &Value| match reading(item) {
                Some(value) => format!("{} {value}", item.get("name").map_or_else(String::new, plain)),
                None => plain(item),
            };
            list.iter().filter(|item| !is_clear(item)).map(told).collect::<Vec<_>>().join("; ")
        }
        Value::Object(fields) => {
            if let Some(value) = reading(value) {
                return value;
            }
            if let [Some(name), Some(old), Some(new)] = CHANGE.map(|part| fields.get(part).map(plain)) {
                return format!("{name} {old} -> {new}");
            }
            let told = TOLD.iter().find(|told| told.iter().all(|name| fields.contains_key(*name)));
            let told = told.map(|told| {
                let parts = told.iter().map(|name| fields.get(*name).map_or_else(String::new, plain));
                parts.collect::<Vec<_>>().join(" ").trim().to_owned()
            });
            let told = told.filter(|told| !told.is_empty());
            let number = fields.get("bit").map(|bit| format!("bit {bit}"));
            let all = || {
                let filled = fields.iter().filter(|(_, field)| !field.is_null());
                filled.map(|(name, field)| format!("{name} {}", plain(field))).collect::<Vec<_>>().join(", ")
            };
            told.or(number).unwrap_or_else(all)
        }
        other => other.to_string(),
    }
}

/// What says of a member of a list that it is not there.
const ABSENT: [&str; 2] = ["set", "present"];

/// What tells an object, the first of which it has all fields: a field of a telegram, a fault, the error register, a counter; a
/// word; a state that is present by the commands that lead out of it; what is called something; what went wrong.
const TOLD: [&[&str]; 8] = [
    &["hex", "name", "value"],
    &["key", "name"],
    &["code", "name"],
    &["name", "count"],
    &["hex"],
    &["leads"],
    &["name"],
    &["message"],
];

/// What makes a record a change, of which nothing is known without what stood before and behind it.
const CHANGE: [&str; 3] = ["name", "old", "new"];

/// What makes a record the reading of a parameter.
const READING: [&str; 2] = ["param", "value"];

/// What was read of a parameter, with its unit; empty where it was not.
fn reading(value: &Value) -> Option<String> {
    let [param, number] = READING.map(|name| value.get(name));
    let (_param, number) = param.zip(number)?;
    let unit = value.get("unit").map_or_else(String::new, plain);
    Some([plain(number), unit].join(" ").trim().to_owned())
}

/// The I/O error inside, with its kind: a closed pipe must be known as one.
fn io_error(error: ::csv::Error) -> io::Error {
    match error.into_kind() {
        ::csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
