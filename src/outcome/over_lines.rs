//! What a verb found of drives that lie on several lines: line by line, and told as one.

use super::{Data, ErrorDoc};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use serde_json::{Map, Value};
use std::collections::{BTreeMap, BTreeSet};

/// What was found, line by line. As JSON it has the shape of what is found on one line, and each entry says of which drive it is.
#[derive(Debug)]
pub struct OverLines {
    /// What was found on each line.
    pub lines: Vec<OnLine>,
    /// The drives of which nothing was found.
    pub unreached: Vec<Unreached>,
}

/// What was found on one of several lines.
#[derive(Debug)]
pub struct OnLine {
    /// Port.
    pub port: String,
    /// The names of its drives, by their addresses.
    pub names: BTreeMap<u8, String>,
    /// What was found.
    pub data: Data,
}

/// A drive of which nothing was found.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Unreached {
    /// Its name in the project file.
    pub called: String,
    /// Port.
    pub port: String,
    /// Address.
    pub address: u8,
    /// Why.
    pub error: ErrorDoc,
}

/// What a verb finds of the drives of one line, or of several: for its schema. There each entry with an `address` has `called` and `port` too.
#[derive(Debug, Serialize, JsonSchema)]
pub struct OrLines<D> {
    /// What was found.
    #[serde(flatten)]
    pub found: D,
    /// The drives of which nothing was found; missing where there is none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub unreached: Vec<Unreached>,
}

impl OverLines {
    /// The lists of all lines, one behind the other; of anything else what the first says.
    fn merged(&self) -> serde_json::Result<Map<String, Value>> {
        let mut whole = Map::new();
        for line in &self.lines {
            for (name, field) in line.whole()? {
                match (whole.get_mut(&name), field) {
                    (Some(Value::Array(list)), Value::Array(more)) => {
                        // A note that holds for all is told once.
                        let new: Vec<Value> = more.into_iter().filter(|item| !list.contains(item)).collect();
                        list.extend(new);
                    }
                    (Some(_), _) => {}
                    (None, field) => drop(whole.insert(name, field)),
                }
            }
        }
        if !self.unreached.is_empty() {
            whole.insert("unreached".to_owned(), serde_json::to_value(&self.unreached)?);
        }
        Ok(whole)
    }
}

impl OnLine {
    /// The name of the drive of an entry.
    pub fn called(&self, entry: &Map<String, Value>) -> Option<&String> {
        self.names.get(&u8::try_from(address(entry)?).ok()?)
    }

    /// The addresses of the drives of which something was found.
    pub fn addresses(&self) -> BTreeSet<u8> {
        let fields = self.whole().unwrap_or_default();
        let entries = fields.values().filter_map(Value::as_array).flatten().filter_map(Value::as_object);
        let told = entries.filter(|entry| entry.contains_key(CALLED)).filter_map(address);
        told.filter_map(|address| address.try_into().ok()).collect()
    }

    /// The fields of what was found; what is told of one drive or of a line alone is one of several here.
    fn whole(&self) -> serde_json::Result<Map<String, Value>> {
        let Value::Object(mut fields) = serde_json::to_value(&self.data)? else { return Ok(Map::new()) };
        let alone = match self.data {
            Data::LineCheck(_) => {
                return Ok(Map::from_iter([("lines".to_owned(), vec![Value::Object(fields)].into())]));
            }
            Data::Dataset(_) => Some("drives"),
            _ => None,
        };
        if let Some(name) = alone {
            fields = Map::from_iter([(name.to_owned(), vec![Value::Object(fields)].into())]);
        }
        for item in fields.values_mut().filter_map(Value::as_array_mut).flatten() {
            if let Value::Object(entry) = item {
                let Some(called) = self.called(entry).cloned() else { continue };
                let own = std::mem::take(entry);
                let of = [(CALLED.to_owned(), called.into()), ("port".to_owned(), self.port.clone().into())];
                *entry = of.into_iter().chain(own).collect();
            }
        }
        Ok(fields)
    }
}

impl Serialize for OverLines {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.merged().map_err(serde::ser::Error::custom)?.serialize(serializer)
    }
}

/// The field with the name of a drive.
const CALLED: &str = "called";

/// The address that an entry is of: its own, or that of a side that is a drive.
fn address(entry: &Map<String, Value>) -> Option<u64> {
    let own = |entry: &Map<String, Value>| entry.get("address").and_then(Value::as_u64);
    own(entry).or_else(|| ["b", "a"].iter().find_map(|side| own(entry.get(*side)?.as_object()?)))
}
