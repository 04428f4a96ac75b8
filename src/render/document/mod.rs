//! Puts an outcome into the form that was asked for, one file a form.

mod csv;
mod json;
mod ndjson;
mod table;

use super::{Console, Format, Manner};
use crate::outcome::{Data, Envelope, ErrorDoc, Outcome, SCHEMA_VERSION};
use crate::text::both;
use std::io::{self, Write};

/// What is to be printed, and for whom.
struct Print<'a> {
    outcome: &'a Outcome,
    command: &'a str,
    manner: Manner,
}

/// Prints an outcome: data to `out`, remarks and failures to the console (in JSON they are in the document too).
pub fn print(
    outcome: &Outcome,
    command: &str,
    format: Format,
    manner: Manner,
    out: &mut dyn Write,
    console: &Console,
) -> io::Result<()> {
    console.finish();
    let form = match format {
        Format::Table | Format::Influx | Format::OpenMetrics => table::print,
        Format::Json => json::print,
        Format::Ndjson => ndjson::print,
        Format::Csv => csv::print,
    };
    form(&Print { outcome, command, manner }, out)?;
    out.flush()?;
    for warning in &outcome.warnings {
        console.warning(&warning.message);
    }
    if let Some(failure) = &outcome.failure {
        console.failure(failure);
    }
    Ok(())
}

/// Says on the console how a run ended, or what was written, whose document nobody reads.
pub fn print_end(outcome: &Outcome, command: &str, manner: Manner, console: &Console) {
    console.finish();
    if outcome.has_written() {
        let mut page = Vec::new();
        let _never_fails = table::print(&Print { outcome, command, manner }, &mut page);
        String::from_utf8_lossy(&page).lines().for_each(|line| console.line(line));
        outcome.warnings.iter().for_each(|warning| console.warning(&warning.message));
    }
    if let Some(Data::Motion(motion)) = &outcome.data {
        if let Some(stop) = motion.stop.as_ref().filter(|_| outcome.failure.is_none()) {
            let proof = match stop.acknowledged {
                false if stop.choice == "keep" => {
                    both!("no stop was sent, as asked for", "es wurde kein Halt gesendet, wie verlangt")
                }
                true => both!("the stop was acknowledged", "der Halt wurde bestätigt"),
                false => both!("the stop was NOT acknowledged", "der Halt wurde NICHT bestätigt"),
            };
            let by = stop.escalated.unwrap_or(stop.choice);
            console.note(&both!("{by}: {proof}", "{by}: {proof}", proof));
        }
        motion.notes.iter().for_each(|note| console.note(note));
    }
    if let Some(failure) = &outcome.failure {
        console.failure(failure);
    }
}

impl Print<'_> {
    fn envelope<D>(&self, data: Option<D>) -> Envelope<'_, D> {
        let Print { outcome, command, .. } = self;
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
}
