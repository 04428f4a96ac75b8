//! The rows under a head line, which is the same whatever was found, each cell a plain value: of a word its hex and, in a column of
//! their own, the names of the bits that are set; a list as its members with semicolons between them.

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
    let with_bits = |column: Column| {
        let bits = column.is_word.then(|| bits_of(&column.name));
        std::iter::once(column.name).chain(bits)
    };
    let columns: Vec<String> = columns.into_iter().flat_map(with_bits).collect();
    let mut writer = ::csv::Writer::from_writer(out);
    writer.write_record(&columns).map_err(io_error)?;
    for row in &rows {
        writer.write_record(columns.iter().map(|column| clean(&cell(&row.fields, column)))).map_err(io_error)?;
    }
    writer.flush()
}

fn cell(fields: &Map<String, Value>, column: &str) -> String {
    let word = column.strip_suffix(BITS).and_then(|word| fields.get(word)).filter(|word| is_word(word));
    match (fields.get(column), word) {
        (Some(value), _) => plain(value),
        (None, Some(word)) => word.get("bits").map_or_else(String::new, plain),
        (None, None) => String::new(),
    }
}

/// What stands behind the name of a word over its bits.
const BITS: &str = "_bits";

fn bits_of(column: &str) -> String {
    format!("{column}{BITS}")
}

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

/// What was read of a parameter, with its unit; empty where it was not.
fn reading(value: &Value) -> Option<String> {
    let (_param, number) = value.get("param").zip(value.get("value"))?;
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
