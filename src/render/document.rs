//! Puts an outcome into the form that was asked for.

use super::{Console, Format, rows, table};
use crate::failure::Failure;
use crate::outcome::{Data, Envelope, ErrorDoc, Outcome, SCHEMA_VERSION};
use crate::profile::Lang;
use std::io::{self, Write};

/// Prints an outcome: data to `out`, remarks and failures to the console (in JSON they are in the document too).
pub fn print(
    outcome: &Outcome,
    command: &str,
    format: Format,
    lang: Lang,
    width: Option<u16>,
    out: &mut dyn Write,
    console: &Console,
) -> io::Result<()> {
    console.finish();
    match format {
        Format::Table => {
            if let Some(data) = &outcome.data {
                let text = table::render(data, lang, width);
                // Nothing slips through, whichever cell it stands in.
                let lines: Vec<String> = text.split('\n').map(super::clean).collect();
                out.write_all(lines.join("\n").as_bytes())?;
            }
        }
        Format::Json => json(outcome, command, out)?,
        Format::Ndjson => ndjson(outcome, command, out)?,
        Format::Csv => csv(outcome, out)?,
    }
    out.flush()?;
    for warning in &outcome.warnings {
        console.line(&format!("warning: {}", warning.message));
    }
    if let Some(failure) = &outcome.failure {
        print_failure(failure, console);
    }
    Ok(())
}

/// Says on the console what went wrong and what to do.
pub fn print_failure(failure: &Failure, console: &Console) {
    console.line(&format!("error: {}", failure.message));
    if let Some(hint) = &failure.hint {
        console.line(&format!("hint: {hint}"));
    }
}

/// Says on the console how a run ended whose document nobody reads.
pub fn print_end(outcome: &Outcome, lang: Lang, console: &Console) {
    console.finish();
    if let Some(Data::Motion(motion)) = &outcome.data {
        if let Some(stop) = motion.stop.as_ref().filter(|_| outcome.failure.is_none()) {
            let proof = match stop.acknowledged {
                false if stop.choice == "keep" => {
                    lang.pick("no stop was sent, as asked for", "es wurde kein Halt gesendet, wie verlangt")
                }
                true => lang.pick("the stop was acknowledged", "der Halt wurde bestätigt"),
                false => lang.pick("the stop was NOT acknowledged", "der Halt wurde NICHT bestätigt"),
            };
            console.line(&format!("note: {}: {proof}", stop.escalated.unwrap_or(stop.choice)));
        }
        motion.notes.iter().for_each(|note| console.line(&format!("note: {note}")));
    }
    if let Some(failure) = &outcome.failure {
        print_failure(failure, console);
    }
}

fn envelope<'a, D>(outcome: &'a Outcome, command: &'a str, data: Option<D>) -> Envelope<'a, D> {
    Envelope {
        schema: SCHEMA_VERSION,
        tool: "antrieb",
        command,
        ok: outcome.failure.is_none(),
        data,
        warnings: &outcome.warnings,
        error: outcome.failure.as_ref().map(ErrorDoc::from),
    }
}

fn json(outcome: &Outcome, command: &str, out: &mut dyn Write) -> io::Result<()> {
    serde_json::to_writer_pretty(&mut *out, &envelope(outcome, command, outcome.data.as_ref()))?;
    writeln!(out)
}

/// One object a line: the rows, then the envelope without data as the last.
fn ndjson(outcome: &Outcome, command: &str, out: &mut dyn Write) -> io::Result<()> {
    let tagged = |kind: &str, fields: serde_json::Map<String, serde_json::Value>| {
        let mut line = serde_json::Map::new();
        line.insert("type".to_owned(), kind.into());
        line.extend(
            fields.into_iter().map(|(key, value)| (if key == "type" { "data_type".to_owned() } else { key }, value)),
        );
        line
    };
    for row in outcome.data.iter().flat_map(rows::rows) {
        serde_json::to_writer(&mut *out, &tagged(row.kind, row.fields))?;
        writeln!(out)?;
    }
    if let serde_json::Value::Object(mut fields) = serde_json::to_value(envelope(outcome, command, None::<()>))? {
        fields.remove("data");
        serde_json::to_writer(&mut *out, &tagged("end", fields))?;
        writeln!(out)?;
    }
    Ok(())
}

/// The rows with the fields of the first as head line; lists and objects as JSON in a cell.
fn csv(outcome: &Outcome, out: &mut dyn Write) -> io::Result<()> {
    let rows: Vec<_> = outcome.data.iter().flat_map(rows::rows).collect();
    let Some(first) = rows.first() else { return Ok(()) };
    let columns: Vec<String> = first.fields.keys().cloned().collect();
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(&columns).map_err(io_error)?;
    for row in &rows {
        writer
            .write_record(columns.iter().map(|column| match row.fields.get(column) {
                None | Some(serde_json::Value::Null) => String::new(),
                Some(serde_json::Value::String(text)) => super::clean(text),
                Some(other) => super::clean(&other.to_string()),
            }))
            .map_err(io_error)?;
    }
    writer.flush()
}

/// The I/O error inside, with its kind: a closed pipe must be known as one.
fn io_error(error: csv::Error) -> io::Error {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => error,
        other => io::Error::other(format!("{other:?}")),
    }
}
