//! The rows of a result, for NDJSON and CSV.

use crate::outcome::Data;
use serde::Serialize;
use serde_json::Value;

/// A row: what it is, and its fields.
#[derive(Clone, Debug)]
pub struct Row {
    /// `drive`, `value` …
    pub kind: &'static str,
    /// Fields in the order of the JSON document.
    pub fields: serde_json::Map<String, Value>,
}

/// The list that a result is in the main.
pub(super) fn rows(data: &Data) -> Vec<Row> {
    match data {
        Data::Scan(scan) => list("drive", &scan.drives),
        Data::Identify(identify) => list("drive", &identify.drives),
        Data::Read(read) => list("value", &read.values),
        Data::Write(write) => list("written", &write.values),
        Data::Dataset(dataset) => {
            let mut rows = list("value", &dataset.rows.iter().flat_map(|row| &row.values).collect::<Vec<_>>());
            rows.extend(list("written", &dataset.written));
            if rows.is_empty() {
                rows.extend(list("dataset", &[dataset]));
            }
            rows
        }
        Data::Diag(diag) => list("drive", &diag.drives),
        Data::LineCheck(check) => list("drive", &check.drives),
        Data::Statemachine(report) => list("drive", &report.drives),
        Data::Sollwert(report) => {
            let values = report
                .drives
                .iter()
                .flat_map(|drive| drive.setpoints.iter().chain(&drive.actual).chain(&drive.sources));
            let mut rows = list("value", &values.collect::<Vec<_>>());
            // A drive that failed has no values, but must not be missing.
            rows.extend(list("drive", &report.drives.iter().filter(|drive| drive.error.is_some()).collect::<Vec<_>>()));
            rows
        }
        Data::Params(params) => list("param", &params.params),
        Data::Decode(decode) if !decode.telegrams.is_empty() => list("telegram", &decode.telegrams),
        Data::Decode(decode) => list("decoded", &[decode]),
        Data::Sniff(sniff) => list("telegram", &sniff.telegrams),
        Data::Motion(motion) => list("motion", &[motion]),
        Data::Relocation(relocation) => list("relocation", &[relocation]),
        Data::Monitor(summary) => list("end", &[summary]),
        Data::Plan(plan) => list("telegram", &plan.telegrams),
        Data::Simulate(simulate) => list("end", &[simulate]),
    }
}

fn list<T: Serialize>(kind: &'static str, items: &[T]) -> Vec<Row> {
    let fields = items.iter().filter_map(|item| match serde_json::to_value(item) {
        Ok(Value::Object(fields)) => Some(fields),
        _ => None,
    });
    fields.map(|fields| Row { kind, fields }).collect()
}
