//! The rows under a head line with the fields of all of them; lists and objects as JSON in a cell.

use super::Print;
use crate::render::spoken::pick;
use crate::render::{clean, finding};
use std::io::{self, Write};

pub(super) fn print(page: &Print<'_>, out: &mut dyn Write) -> io::Result<()> {
    let mut rows: Vec<_> = page.outcome.data.iter().flat_map(|data| finding::of(data).rows()).collect();
    rows.iter_mut().flat_map(|row| row.fields.values_mut()).for_each(|field| pick(field, page.manner.lang));
    // Rows of several kinds stand in one table: every field of any of them has its column.
    let mut columns: Vec<String> = Vec::new();
    for column in rows.iter().flat_map(|row| row.fields.keys()) {
        if !columns.contains(column) {
            columns.push(column.clone());
        }
    }
    if rows.is_empty() {
        return Ok(());
    }
    let mut writer = ::csv::Writer::from_writer(out);
    writer.write_record(&columns).map_err(io_error)?;
    for row in &rows {
        writer
            .write_record(columns.iter().map(|column| match row.fields.get(column) {
                None | Some(serde_json::Value::Null) => String::new(),
                Some(serde_json::Value::String(text)) => clean(text),
                Some(other) => clean(&other.to_string()),
            }))
            .map_err(io_error)?;
    }
    writer.flush()
}

/// The I/O error inside, with its kind: a closed pipe must be known as one.
fn io_error(error: ::csv::Error) -> io::Error {
    match error.into_kind() {
        ::csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
