//! The rows of a family as a list that `table` takes back.

use crate::profile::family::Family;
use crate::profile::param::{Effective, HazardKind, Param, Sets};
use crate::profile::row::BitRow;
use crate::profile::value::format_decimal;
use crate::text::{Lang, Text};

/// The columns of a list, in their order; `table` knows them by these names.
pub const COLUMNS: &[&str] = &[
    "id",
    "slug",
    "short",
    "en",
    "de",
    "unit",
    "type",
    "decimals",
    "min",
    "max",
    "default",
    "access",
    "sets",
    "volatile",
    "effective",
    "hazard",
    "module",
    "enum",
    "values_en",
    "values_de",
    "bits",
    "bits_en",
    "bits_de",
    "bits_when",
    "hex",
    "note_en",
    "note_de",
    "unconfirmed",
    "drives",
    "group",
    "source",
];

/// Stands behind a limit that is the number on the wire, whatever its decimals are.
pub(super) const RAW: &str = "raw";

/// The cells of a parameter, one for each of [`COLUMNS`].
pub fn cells_of(family: &Family, param: &Param) -> Vec<(&'static str, String)> {
    COLUMNS.iter().map(|column| (*column, cell(column, family, param))).collect()
}

fn cell(column: &str, family: &Family, param: &Param) -> String {
    let or_empty = |text: &Option<String>| text.clone().unwrap_or_default();
    let yes = |is: bool| if is { "yes" } else { "" }.to_owned();
    let limit = |raw: Option<i64>| match (raw, param.has_scale()) {
        (None, _) => String::new(),
        (Some(raw), true) => format_decimal(raw, param.decimals_or_zero()),
        // Nobody knows where its point stands.
        (Some(raw), false) => format!("{raw} {RAW}"),
    };
    let note = |lang| param.note.as_ref().map(|note| note.get(lang).to_owned()).unwrap_or_default();
    match column {
        "id" => param.id.to_string(),
        "slug" => param.slug.clone(),
        "short" => or_empty(&param.short),
        "en" => param.name(Lang::En).to_owned(),
        "de" => param.name(Lang::De).to_owned(),
        "unit" => or_empty(&param.unit),
        "type" => param.kind.map(|kind| kind.name().to_owned()).unwrap_or_default(),
        "decimals" => param.decimals.map(|decimals| decimals.to_string()).unwrap_or_default(),
        "min" => limit(param.min),
        "max" => limit(param.max),
        "default" => limit(param.default),
        "access" => param.access.name().to_owned(),
        "sets" => param.sets.map(|sets| if sets == Sets::Four { "4" } else { "1" }.to_owned()).unwrap_or_default(),
        "volatile" => yes(param.volatile),
        "effective" => if param.effective == Effective::Reset { "reset" } else { "" }.to_owned(),
        "hazard" => param.hazard.map(|hazard| hazard_name(hazard).to_owned()).unwrap_or_default(),
        "module" => or_empty(&param.module),
        "enum" => or_empty(&param.enumeration),
        "values_en" => values(family, param, Lang::En),
        "values_de" => values(family, param, Lang::De),
        "bits" => or_empty(&param.bits),
        "bits_en" => bits(family, param, BitRow::name, Lang::En),
        "bits_de" => bits(family, param, BitRow::name, Lang::De),
        "bits_when" => {
            let when = param.bits_when.iter().map(|when| format!("{}={}:{}", when.param, when.value, when.bits));
            when.collect::<Vec<_>>().join(" | ")
        }
        "hex" => yes(param.hex),
        "note_en" => note(Lang::En),
        "note_de" => note(Lang::De),
        "unconfirmed" => param.unconfirmed.join(" "),
        "drives" => {
            if family.siblings.len() > 1 {
                family.drive.clone()
            } else {
                String::new()
            }
        }
        "group" => group(family, param),
        "source" => param.source.clone(),
        _ => String::new(),
    }
}

/// The word for a hazard in a catalogue.
pub(super) fn hazard_name(hazard: HazardKind) -> &'static str {
    match hazard {
        HazardKind::Motion => "motion",
        HazardKind::Line => "line",
        HazardKind::Reset => "reset",
    }
}

fn values(family: &Family, param: &Param, lang: Lang) -> String {
    let table = param.enumeration.as_ref().and_then(|name| family.enums.get(name));
    join(table.into_iter().flatten().map(|(raw, text): (&i64, &Text)| (*raw, text.get(lang).to_owned())))
}

fn bits(family: &Family, param: &Param, name: impl Fn(&BitRow, Lang) -> &str, lang: Lang) -> String {
    let table = param.bits.as_ref().and_then(|name| family.bits.get(name));
    join(table.into_iter().flatten().map(|(bit, row)| (i64::from(*bit), name(row, lang).to_owned())))
}

fn join(rows: impl Iterator<Item = (i64, String)>) -> String {
    rows.map(|(raw, name)| format!("{raw}={}", name.replace('|', "/"))).collect::<Vec<_>>().join(" | ")
}

/// The group of a family that only a catalogue of the user brings: groups of ours are added to by nobody.
fn group(family: &Family, param: &Param) -> String {
    let mut groups = family.groups.iter().filter(|_| !family.is_movable());
    groups.find(|group| group.1.contains(&param.id)).map(|group| group.0.clone()).unwrap_or_default()
}
