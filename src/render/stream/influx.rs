//! InfluxDB line protocol v2: one line a drive and round, as Telegraf's inputs and InfluxDB take it.

use super::Form;
use super::metrics::{Origin, error, key, number};
use crate::outcome::{LineNews, Record, Sample};
use crate::profile::value::format_decimal;
use std::io::{self, Write};

/// The name under which the values are found.
const MEASUREMENT: &str = "antrieb";

pub(super) struct Influx<'a> {
    out: &'a mut dyn Write,
    origin: Origin,
}

impl<'a> Influx<'a> {
    pub(super) fn new(out: &'a mut dyn Write) -> Self {
        Influx { out, origin: Origin::default() }
    }

    fn line(&self, sample: &Sample) -> String {
        let tags = self.origin.labels(sample).into_iter().map(|(name, what)| format!(",{name}={}", tag(&what)));
        let tags: String = tags.collect();
        let at = self.origin.nanoseconds(sample.t).map_or_else(String::new, |time| format!(" {time}"));
        format!("{MEASUREMENT}{tags} {}{at}\n", fields(sample).join(","))
    }
}

/// What a sample tells; whether it could be read always.
fn fields(sample: &Sample) -> Vec<String> {
    let reachable = format!("reachable={}", sample.error.is_none());
    let values = sample.values.iter().filter_map(|row| {
        let kind = if row.value.value.is_none() { "i" } else { "" };
        Some(format!("{}={}{kind}", key(&row.value), number(&row.value)?))
    });
    let state = sample.state.iter().map(|state| format!("state={}", text(&state.slug)));
    let error = error(sample).into_iter().map(|code| format!("error={}", text(code)));
    let line = sample.line.iter().flat_map(line);
    [reachable].into_iter().chain(values).chain(state).chain(error).chain(line).collect()
}

fn line(news: &LineNews) -> Vec<String> {
    let counts = [
        ("telegrams", news.telegrams),
        ("replies", news.replies),
        ("repeats", news.repeats),
        ("silences", news.silences),
        ("garbled", news.garbled),
    ];
    let counted = counts.iter().map(|(name, count)| format!("line_{name}={count}i"));
    let waited = format!("line_waited_seconds={}", format_decimal(news.waited.raw, news.waited.decimals));
    counted.chain([waited]).collect()
}

/// A value of a tag: comma, space and equals sign are escaped there, and it ends with the line.
fn tag(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            ',' | ' ' | '=' => escaped.extend(['\\', letter]),
            letter if letter.is_control() => escaped.push('_'),
            letter => escaped.push(letter),
        }
    }
    // A backslash at the end would escape the comma behind it.
    if escaped.ends_with('\\') {
        escaped.push('_');
    }
    if escaped.is_empty() { "unknown".to_owned() } else { escaped }
}

/// A text as a field.
fn text(text: &str) -> String {
    format!("\"{}\"", text.replace('\\', "\\\\").replace('"', "\\\"").replace(['\n', '\r'], " "))
}

impl Form for Influx<'_> {
    fn record(&mut self, record: &Record) -> io::Result<()> {
        match record {
            Record::Start(start) => {
                self.origin = Origin::of(start);
                Ok(())
            }
            // In one piece: a line must not be cut in two by whoever reads while it is written.
            Record::Sample(sample) => {
                self.out.write_all(self.line(sample).as_bytes())?;
                self.out.flush()
            }
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_a_meaning_in_a_line_is_escaped() {
        assert_eq!(tag("/dev/tty a,b=c\n"), "/dev/tty\\ a\\,b\\=c_");
        assert_eq!(tag("COM1\\"), "COM1\\_");
        assert_eq!(text("a \"b\" \\"), "\"a \\\"b\\\" \\\\\"");
    }
}
