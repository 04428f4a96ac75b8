//! Holding settings against settings, whatever they come from.

use crate::failure::Failure;
use crate::outcome::{Decimal, Difference, ErrorDoc};
use crate::profile::paramfile::{Setting, Settings, value_text};
use crate::profile::{Family, Param, value};
use crate::text::Text;
use std::collections::BTreeMap;
use std::fmt::Write;

/// What came of a comparison.
#[derive(Debug, Default)]
pub struct Compared {
    /// How many values were held against each other.
    pub count: usize,
    /// Where they differ, by group and number.
    pub differences: Vec<Difference>,
}

/// Holds two sides against each other. What only `b` holds counts as well if `all`; `failures` says why a drive did not tell
/// a parameter.
pub fn compare(a: &Settings, b: &Settings, all: bool, failures: &BTreeMap<u32, Failure>, family: &Family) -> Compared {
    let mut compared = Compared::default();
    let mut params: BTreeMap<u32, &Param> = a.params().map(|param| (param.id, param)).collect();
    if all {
        params.extend(b.params().map(|param| (param.id, param)));
    }
    for (id, param) in params {
        let is_split = (1..=4).any(|set| a.exactly(id, set).is_some() || b.exactly(id, set).is_some());
        let sets = if is_split { 1..=4 } else { 0..=0 };
        for set in sets {
            let (one, other) = (a.get(id, set), b.get(id, set));
            let raw = |side: Option<&Setting>| side.map(|side| side.raw);
            if one.is_none() && (other.is_none() || !all) {
                continue;
            }
            compared.count += 1;
            if raw(one) != raw(other) {
                let error = failures.get(&id).map(ErrorDoc::from);
                compared.differences.push(difference(param, set, [raw(one), raw(other)], error, family));
            }
        }
    }
    compared
        .differences
        .sort_by(|one, other| (&one.group, one.param, one.data_set).cmp(&(&other.group, other.param, other.data_set)));
    compared
}

fn difference(param: &Param, set: u8, raws: [Option<i64>; 2], error: Option<ErrorDoc>, family: &Family) -> Difference {
    let value = |raw: Option<i64>| {
        let digits = raw.filter(|_| param.has_scale()).and_then(|raw| value::digits(param, raw));
        digits.map(|(raw, decimals)| Decimal { raw, decimals })
    };
    let text = |raw: Option<i64>| raw.and_then(|raw| family.text_of(param, raw).cloned());
    let [a, b] = raws;
    Difference {
        group: group(param, family),
        param: param.number(),
        slug: param.slug.clone(),
        name: param.name.clone(),
        data_set: set,
        unit: param.unit.clone(),
        a_raw: a,
        a_value: value(a),
        a_text: text(a),
        b_raw: b,
        b_value: value(b),
        b_text: text(b),
        error,
    }
}

/// The smallest group of the catalogue that a parameter belongs to.
fn group(param: &Param, family: &Family) -> Option<String> {
    let groups = family.group_names().filter(|name| *name != "all").map(str::to_owned);
    let of = groups
        .filter_map(|name| family.group(&name).filter(|ids| ids.contains(&param.id)).map(|ids| (ids.len(), name)));
    of.min().map(|(_, name)| name)
}

/// The differences as text: what stands in the one file, and what would stand there in the other.
pub fn unified(names: [&Text; 2], differences: &[Difference], family: &Family) -> Text {
    Text::by(|lang| {
        let mut text = String::new();
        if differences.is_empty() {
            return text;
        }
        let [one, other] = names.map(|name| name.get(lang));
        let _ = writeln!(text, "--- {one}\n+++ {other}");
        let mut group = None;
        for row in differences {
            if group.replace(&row.group) != Some(&row.group) {
                let name = row.group.as_ref().map_or_else(|| "-".to_owned(), |group| format!("@{group}"));
                let _ = writeln!(text, "@@ {name} @@");
            }
            let param = family.param_or_unknown(row.param);
            let at = if row.data_set == 0 { String::new() } else { format!("@{}", row.data_set) };
            for (mark, raw, meaning) in [('-', row.a_raw, &row.a_text), ('+', row.b_raw, &row.b_text)] {
                let Some(raw) = raw else { continue };
                let (value, name) = (value_text(&param, raw), param.name(lang));
                let meaning = meaning.as_ref().map_or_else(String::new, |meaning| format!(": {}", meaning.get(lang)));
                let _ = writeln!(text, "{mark}\"{}{at}\" = \"{value}\"  # {name}{meaning}", row.param);
            }
        }
        text
    })
}
