//! What a finding is as a list, for NDJSON and CSV: its rows, and every column that they can have, whatever was found.

use schemars::{JsonSchema, SchemaGenerator};
use serde::Serialize;
use serde_json::{Map, Value};

/// A row: what it is, and its fields.
#[derive(Clone, Debug)]
pub(in crate::render) struct Row {
    /// `drive`, `value` …
    pub(in crate::render) kind: &'static str,
    /// Fields in the order of the JSON document.
    pub(in crate::render) fields: Map<String, Value>,
}

/// A field that rows can have.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::render) struct Column {
    pub(in crate::render) name: String,
    /// It has a number and the names of its bits.
    pub(in crate::render) is_word: bool,
    is_list: bool,
    /// Fields of what it holds, one or a list of it, where that is a record.
    pub(in crate::render) parts: Vec<Column>,
}

/// Rows of one kind or of several.
#[derive(Debug, Default)]
pub(in crate::render) struct Rows {
    /// Those of all kinds, in the order of the JSON document, also of kinds of which there is no row.
    pub(in crate::render) columns: Vec<Column>,
    pub(in crate::render) rows: Vec<Row>,
}

impl Rows {
    /// A list of one kind.
    pub(super) fn of<T: Serialize + JsonSchema>(kind: &'static str, items: &[T]) -> Self {
        let fields = items.iter().filter_map(|item| match serde_json::to_value(item) {
            Ok(Value::Object(fields)) => Some(fields),
            _ => None,
        });
        Rows { columns: columns::<T>(), rows: fields.map(|fields| Row { kind, fields }).collect() }
    }

    /// Rows of which no type tells the fields: each has all of these, as text.
    pub(super) fn named(kind: &'static str, names: &[&str], cells: impl Iterator<Item = Vec<String>>) -> Self {
        let named =
            |cells: Vec<String>| names.iter().map(|name| (*name).to_owned()).zip(cells.into_iter().map(Value::from));
        let rows = cells.map(|cells| Row { kind, fields: named(cells).collect() }).collect();
        Rows { columns: names.iter().map(|name| Column::plain(name)).collect(), rows }
    }

    /// These, and others behind them.
    pub(super) fn and(mut self, more: Rows) -> Self {
        for column in more.columns {
            if !self.columns.iter().any(|known| known.name == column.name) {
                self.columns.push(column);
            }
        }
        self.rows.extend(more.rows);
        self
    }

    /// The columns of all kinds, but only one of them, where the others stand in for it.
    pub(super) fn or(self, instead: Rows) -> Self {
        let instead = Rows { rows: if self.rows.is_empty() { instead.rows } else { Vec::new() }, ..instead };
        self.and(instead)
    }

    /// Without what is a list in itself.
    pub(super) fn without_lists(self) -> Self {
        let lists: Vec<String> =
            self.columns.iter().filter(|column| column.is_list).map(|column| column.name.clone()).collect();
        self.without(&lists.iter().map(String::as_str).collect::<Vec<_>>())
    }

    /// Without these fields.
    pub(super) fn without(mut self, names: &[&str]) -> Self {
        self.columns.retain(|column| !names.contains(&column.name.as_str()));
        self.rows.iter_mut().for_each(|row| row.fields.retain(|name, _| !names.contains(&name.as_str())));
        self
    }

    /// Those of a port, each with the name of its drive.
    pub(super) fn of_drives(mut self, port: &str, called: impl Fn(&Map<String, Value>) -> Option<String>) -> Self {
        self.columns.retain(|column| !["called", "port"].contains(&column.name.as_str()));
        self.columns.splice(0..0, ["called", "port"].map(Column::plain));
        for row in &mut self.rows {
            let own = std::mem::take(&mut row.fields);
            let of = [("called".to_owned(), called(&own).into()), ("port".to_owned(), port.into())];
            row.fields = of.into_iter().chain(own).collect();
        }
        self
    }

    /// Each with another field before its own.
    pub(super) fn under(mut self, name: &str, value: &Value) -> Self {
        self.columns.retain(|column| column.name != name);
        self.columns.insert(0, Column::plain(name));
        for row in &mut self.rows {
            let own = std::mem::take(&mut row.fields);
            row.fields = std::iter::once((name.to_owned(), value.clone())).chain(own).collect();
        }
        self
    }
}

impl Column {
    fn plain(name: &str) -> Self {
        Column { name: name.to_owned(), is_word: false, is_list: false, parts: Vec::new() }
    }
}

/// The fields of a type, as its JSON Schema tells them.
fn columns<T: JsonSchema>() -> Vec<Column> {
    let schema = SchemaGenerator::default().into_root_schema_for::<T>().to_value();
    fields_of(&schema, &schema, DEPTH)
}

/// No record of ours holds others any deeper.
const DEPTH: usize = 3;

fn fields_of(form: &Value, schema: &Value, depth: usize) -> Vec<Column> {
    let column = |(name, field): (&String, &Value)| {
        let forms = forms(field, schema);
        let items = forms.iter().filter_map(|form| form.get("items")).flat_map(|items| self::forms(items, schema));
        let held = forms.iter().copied().chain(items).find(|form| form.get("properties").is_some());
        Column {
            name: name.clone(),
            is_word: forms.iter().any(|form| ["hex", "bits"].iter().all(|part| has(form, part))),
            is_list: field.get("type").is_some_and(|kind| kind == "array" || kind[0] == "array"),
            parts: held.filter(|_| depth > 0).map_or_else(Vec::new, |held| fields_of(held, schema, depth - 1)),
        }
    };
    form.get("properties").and_then(Value::as_object).into_iter().flatten().map(column).collect()
}

/// What a field can be, wherever the schema describes it.
fn forms<'a>(field: &'a Value, schema: &'a Value) -> Vec<&'a Value> {
    let described = |form: &'a Value| {
        let place = form.get("$ref").and_then(Value::as_str).and_then(|place| place.strip_prefix('#'));
        place.and_then(|place| schema.pointer(place)).unwrap_or(form)
    };
    let any = field.get("anyOf").and_then(Value::as_array).into_iter().flatten();
    std::iter::once(field).chain(any).map(described).collect()
}

fn has(form: &Value, part: &str) -> bool {
    form.get("properties").is_some_and(|parts| parts.get(part).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::outcome::{Diagnosis, Difference, PlantDrive, Written};

    fn names(rows: &Rows) -> Vec<&str> {
        rows.columns.iter().map(|column| column.name.as_str()).collect()
    }

    #[test]
    fn columns_are_those_of_the_kind_and_not_of_what_was_found() {
        let none = Rows::of::<Difference>("difference", &[]).under("address", &1.into());
        assert_eq!(names(&none)[..4], ["address", "group", "param", "slug"]);
        assert!(none.rows.is_empty());
        let both = Rows::of::<PlantDrive>("drive", &[]).without_lists().and(Rows::of::<Written>("written", &[]));
        assert!(
            ["called", "state", "undo_file", "error", "param", "result"].iter().all(|name| names(&both).contains(name))
        );
        assert!(!names(&both).contains(&"values"), "a list has rows of its own");
    }

    #[test]
    fn a_word_is_known_by_its_type() {
        let words = Rows::of::<Diagnosis>("drive", &[]).columns.into_iter().filter(|column| column.is_word);
        assert_eq!(words.map(|column| column.name).collect::<Vec<_>>(), ["status", "warnings", "inputs"]);
    }
}
