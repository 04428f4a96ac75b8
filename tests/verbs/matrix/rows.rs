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
        "plan" | "apply" => of_plant(&list(&data["drives"]), "values"),
        "check" => of_plant(&list(&data["drives"]), "differences"),
        "sniff" => list(&data["telegrams"]),
        "plot" => list(&data["curves"]),
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
        "systembus" if list(&data["pdos"]).is_empty() => list(&data["rates"]),
        "systembus" => list(&data["pdos"]),
        "params" => list(&data["params"]),
        "decode" if !list(&data["telegrams"]).is_empty() => list(&data["telegrams"]),
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
        "dataset" if data["comparisons"].is_array() => {
            list(&data["comparisons"]).into_iter().flat_map(|one| list(&one["differences"])).collect()
        }
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

/// What is told of the drives of a plant: the rows of each, or itself without its lists.
fn of_plant(drives: &[Value], rows: &str) -> Vec<Value> {
    let mut told = Vec::new();
    for drive in drives {
        let own = drive[rows].as_array().unwrap();
        for row in own {
            let mut named = Map::new();
            for place in ["called", "port", "address"] {
                named.insert(place.to_owned(), drive[place].clone());
            }
            named.extend(row.as_object().unwrap().clone());
            told.push(named.into());
        }
        if own.is_empty() {
            let mut drive = drive.clone();
            drive.as_object_mut().unwrap().retain(|name, value| !value.is_array() && name != "a" && name != "b");
            told.push(drive);
        }
    }
    told
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
