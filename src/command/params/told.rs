//! What `params import` took for what, in lines: they stand above the catalogue as comments.

use crate::outcome::{Import, ImportColumn};
use crate::text::{Text, both};

/// So many rows are named that were left out; the rest is counted.
const MOST: usize = 50;

pub(super) fn told(report: &Import, head: usize) -> Vec<Text> {
    let mut lines = vec![summary(report)];
    if report.format == "table" {
        let (encoding, separator) = (report.encoding, separator(report.separator.as_deref()));
        lines.push(both!(
            "read as {encoding}, cells parted by {separator}, headings in line {head}:",
            "gelesen als {encoding}, Zellen getrennt durch {separator}, Überschriften in Zeile {head}:",
            encoding,
            separator,
            head
        ));
        lines.extend(report.columns.iter().map(column));
        if !report.unused.is_empty() {
            let unused = report.unused.join(", ");
            lines.push(both!("  not taken: {unused}", "  nicht genommen: {unused}"));
        }
    }
    let left = report.left_out.iter().map(|left| {
        let (line, why) = (left.line, &left.why);
        both!("left out, line {line}: {why}", "ausgelassen, Zeile {line}: {why}", line, why)
    });
    lines.extend(few(left.collect()));
    lines.extend(few(report.notes.iter().map(|note| both!("note: {note}", "Anmerkung: {note}", note)).collect()));
    lines
}

fn summary(report: &Import) -> Text {
    let Import { file, rows, left_out, family, .. } = report;
    let (taken, left) = (rows.len(), left_out.len());
    let to = match &report.output {
        Some(path) => both!(", written to {path}", ", geschrieben nach {path}", path),
        None => Text::default(),
    };
    match report.own {
        true => both!(
            "{file}: {taken} rows taken, {left} left out, for a family of its own '{family}'{to}",
            "{file}: {taken} Zeilen übernommen, {left} ausgelassen, für eine eigene Familie '{family}'{to}",
            file,
            taken,
            left,
            family,
            to
        ),
        false => both!(
            "{file}: {taken} rows taken, {left} left out, for the family '{family}'{to}",
            "{file}: {taken} Zeilen übernommen, {left} ausgelassen, für die Familie '{family}'{to}",
            file,
            taken,
            left,
            family,
            to
        ),
    }
}

fn separator(typed: Option<&str>) -> Text {
    match typed {
        Some("\t") => both!("tabs", "Tabulatoren"),
        other => Text::name(other.unwrap_or_default()),
    }
}

fn column(column: &ImportColumn) -> Text {
    let ImportColumn { field, heading, column, said } = column;
    match said {
        true => both!(
            "  {field} = column {column} '{heading}' (said by --column)",
            "  {field} = Spalte {column} '{heading}' (mit --column angegeben)",
            field,
            column,
            heading
        ),
        false => both!(
            "  {field} = column {column} '{heading}'",
            "  {field} = Spalte {column} '{heading}'",
            field,
            column,
            heading
        ),
    }
}

fn few(mut lines: Vec<Text>) -> Vec<Text> {
    let more = lines.len().saturating_sub(MOST);
    lines.truncate(MOST);
    if more > 0 {
        lines.push(both!("… and {more} more", "… und {more} weitere"));
    }
    lines
}
