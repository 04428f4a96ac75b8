//! A document as rows, as NDJSON and CSV tell it, and shortened as people read it.

use serde_json::{Map, Value};

/// What a value is in CSV.
pub(super) fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

/// The list that a document is in the main.
pub(super) fn rows(document: &Value) -> Vec<Map<String, Value>> {
    let data = &document["data"];
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let rows: Vec<Value> = match document["command"].as_str().unwrap() {
        _ if data.is_null() => Vec::new(),
        "scan" | "identify" | "diag" | "statemachine" => list(&data["drives"]),
        "read" | "write" => list(&data["values"]),
        "protocol" | "line" if data["values"].is_array() => list(&data["values"]),
        "protocol" | "line" | "simulate" => vec![data.clone()],
        "init" => {
            let found = list(&data["drives"]).into_iter().chain(list(&data["unknown"]));
            let row = |mut found: Value| {
                found.as_object_mut().unwrap().retain(|_, value| !value.is_array());
                found
            };
            found.map(row).collect()
        }
        "plan" | "apply" | "check" if data["telegrams"].is_array() => list(&data["telegrams"]),
        "plan" | "apply" => of_whole(&list(&data["drives"]), "values", |one| places(one, &["called", "port"])),
        "check" => of_whole(&list(&data["drives"]), "differences", |one| places(one, &["called", "port", "address"])),
        "sniff" => list(&data["telegrams"]),
        "plot" => list(&data["curves"]),
        "procedure" if data["procedures"].is_array() => list(&data["procedures"]),
        "procedure" => {
            let row = |mut step: Value| {
                step.as_object_mut().unwrap().retain(|_, value| !value.is_array());
                step
            };
            list(&data["steps"]).into_iter().map(row).collect()
        }
        "report" => {
            let values = list(&data["drives"]).into_iter().flat_map(|drive| list(&drive["values"]));
            let failed = list(&data["drives"]).into_iter().filter(|drive| list(&drive["values"]).is_empty());
            let failed = failed.map(|mut drive| {
                drive
                    .as_object_mut()
                    .unwrap()
                    .retain(|name, value| !value.is_array() && !["identity", "diagnosis"].contains(&name.as_str()));
                drive
            });
            values.chain(failed).collect()
        }
        "systembus" if data["links"].is_array() => list(&data["links"]),
        "systembus" if data["telegrams"].is_array() => list(&data["telegrams"]),
        "systembus" if data["drives"][0]["eeprom_writes"].is_number() => {
            of_whole(&list(&data["drives"]), "values", |one| places(one, &["called", "port"]))
        }
        "systembus" if data["drives"][0]["differences"].is_array() => {
            of_whole(&list(&data["drives"]), "differences", |one| places(one, &["called", "port", "address"]))
        }
        "systembus" if data["drives"].is_array() => {
            let row = |mut drive: Value| {
                let values = list(&drive["values"]);
                drive.as_object_mut().unwrap().retain(|_, value| !value.is_array());
                if values.is_empty() { vec![drive] } else { values }
            };
            list(&data["drives"]).into_iter().flat_map(row).collect()
        }
        "systembus" if list(&data["pdos"]).is_empty() => list(&data["rates"]),
        "systembus" => list(&data["pdos"]),
        "params" => list(&data["params"]),
        "decode" if !list(&data["telegrams"]).is_empty() => list(&data["telegrams"]),
        "profibus" if data["values"].is_array() => list(&data["values"]),
        "profibus" if data["stations"].is_array() => list(&data["stations"]),
        "profibus" if data["telegrams"].is_array() => list(&data["telegrams"]),
        "decode" | "profibus" => vec![data.clone()],
        "dataset" if data["saved"].is_array() => {
            let is_empty = |saved: &Value| list(&saved["values"]).is_empty();
            let failed = list(&data["saved"]).into_iter().filter(is_empty).map(|mut saved| {
                saved.as_object_mut().unwrap().retain(|_, value| !value.is_array());
                saved
            });
            let values = list(&data["saved"]).into_iter().flat_map(|saved| list(&saved["values"]));
            values.chain(failed).collect()
        }
        "dataset" if data["comparisons"].is_array() => of_whole(&list(&data["comparisons"]), "differences", |one| {
            let drive = if one["b"]["address"].is_null() { &one["a"] } else { &one["b"] };
            vec![("address", drive["address"].clone())]
        }),
        "dataset" if data["values"].is_array() => list(&data["values"]),
        "dataset" if list(&data["rows"]).is_empty() && list(&data["written"]).is_empty() => vec![data.clone()],
        "dataset" => {
            let values = list(&data["rows"]).into_iter().flat_map(|row| list(&row["values"]));
            values.chain(list(&data["written"])).collect()
        }
        "sollwert" => {
            let of = |drive: Value| {
                ["setpoints", "actual", "sources"]
                    .into_iter()
                    .flat_map(move |part| list(&drive[part]))
                    .collect::<Vec<_>>()
            };
            let failed = list(&data["drives"]).into_iter().filter(|drive| !drive["error"].is_null());
            list(&data["drives"]).into_iter().flat_map(of).chain(failed).collect()
        }
        other => panic!("{other}"),
    };
    rows.into_iter().map(|row| row.as_object().unwrap().clone()).collect()
}

/// Each whole without its lists and sides, then what it lists; all of them say of which they are.
fn of_whole(wholes: &[Value], rows: &str, of: impl Fn(&Value) -> Vec<(&'static str, Value)>) -> Vec<Value> {
    let mut told = Vec::new();
    for whole in wholes {
        let mut bare = whole.clone();
        bare.as_object_mut().unwrap().retain(|name, value| !value.is_array() && name != "a" && name != "b");
        for row in std::iter::once(&bare).chain(whole[rows].as_array().unwrap()) {
            let mut named: Map<String, Value> =
                of(whole).into_iter().map(|(name, value)| (name.to_owned(), value)).collect();
            let own = row.as_object().unwrap().clone();
            own.into_iter().for_each(|(name, value)| {
                named.entry(name).or_insert(value);
            });
            told.push(named.into());
        }
    }
    told
}

fn places(whole: &Value, names: &[&'static str]) -> Vec<(&'static str, Value)> {
    names.iter().map(|name| (*name, whole[*name].clone())).collect()
}

/// A document without its long lists of bits and counters, for snapshots that people read.
pub(super) fn shortened(mut value: Value) -> Value {
    match &mut value {
        Value::Object(fields) => {
            for (key, field) in fields.iter_mut() {
                match (key.as_str(), &field) {
                    ("bits" | "counters", Value::Array(list)) => *field = format!("({} rows)", list.len()).into(),
                    ("port" | "way_back", Value::String(_)) => *field = "(port)".into(),
                    _ => *field = shortened(field.take()),
                }
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|item| *item = shortened(item.take())),
        _ => {}
    }
    value
}
