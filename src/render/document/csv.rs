//! The rows with the fields of the first as head line; lists and objects as JSON in a cell.

use super::Print;
use crate::render::{clean, finding};
use std::io::{self, Write};

pub(super) fn print(page: &Print<'_>, out: &mut dyn Write) -> io::Result<()> {
    let rows: Vec<_> = page.outcome.data.iter().flat_map(|data| finding::of(data).rows()).collect();
    let Some(first) = rows.first() else { return Ok(()) };
    let columns: Vec<String> = first.fields.keys().cloned().collect();
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
