//! Rows as a catalogue in TOML, one line each, so that what is wrong with one can be told by the line of the list.

use super::draft::{Draft, Own};
use super::export::hazard_name;
use crate::profile::family::Family;
use crate::profile::names::fold;
use crate::profile::param::{Effective, Sets};
use crate::text::Text;
use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

/// What the catalogue is for.
#[derive(Clone, Debug)]
pub struct Target {
    /// Name of the family.
    pub family: String,
    /// Its drives, if it is known.
    pub known: Vec<Rc<Family>>,
    /// What makes it a family of its own.
    pub own: Option<Own>,
    /// Rows that are there already are replaced.
    pub replace: bool,
}

/// A catalogue, and which of its lines comes from which of the list.
#[derive(Clone, Debug, Default)]
pub struct Written {
    /// TOML.
    pub text: String,
    /// Lines of the catalogue and of the list.
    pub lines: Vec<(usize, usize)>,
    /// Stable names, one a row.
    pub slugs: Vec<String>,
}

/// Tables of names by their name.
type Tables = BTreeMap<String, Vec<(i64, Text)>>;

/// Writes a catalogue.
pub fn write(target: &Target, drafts: &[Draft]) -> Written {
    let mut text = format!("schema = 1\nfamily = {}\n", quoted(&target.family));
    if let Some(own) = &target.own {
        let (id, title) = (quoted(&own.id), quoted(&own.title));
        text += &format!("title = {{ en = {title}, de = {title} }}\n");
        text += &format!("drives = [{{ id = {id}, en = {title}, de = {title} }}]\n");
    }
    text += "params = [\n";
    let (mut enums, mut bits) = (Tables::new(), Tables::new());
    let slugs = slugs(target, drafts);
    let mut lines = Vec::new();
    let mut line = text.matches('\n').count();
    for (draft, slug) in drafts.iter().zip(&slugs) {
        let tables = [
            table(&mut enums, &draft.enumeration, slug, |name| {
                target.known.iter().any(|family| family.enums.contains_key(name))
            }),
            table(&mut bits, &draft.bits, slug, |name| {
                target.known.iter().any(|family| family.bits.contains_key(name))
            }),
        ];
        line += 1;
        lines.push((line, draft.line));
        text += &format!("  {{ {} }},\n", row(target, draft, slug, &tables).join(", "));
    }
    text += "]\n";
    if let Some(own) = &target.own {
        let low = if own.low_half_first { "low_half_first = true\n" } else { "" };
        text += &format!("\n[link]\nroute = \"registers\"\n{low}");
        text += &groups(drafts);
    }
    for (name, table) in enums {
        text += &format!("\n[enums.{}]\n", quoted(&name));
        for (raw, name) in table {
            text += &format!("\"{raw}\" = {{ {} }}\n", names(&name));
        }
    }
    for (name, table) in bits {
        text += &format!("\n[bits.{}]\n", quoted(&name));
        for (bit, name) in table {
            let slug = Some(slug_of(&name.en)).filter(|slug| !slug.is_empty()).unwrap_or_else(|| format!("bit-{bit}"));
            text += &format!("\"{bit}\" = {{ slug = {}, {} }}\n", quoted(&slug), names(&name));
        }
    }
    Written { text, lines, slugs }
}

fn quoted(text: &str) -> String {
    // JSON quotes as TOML's basic strings do: both know \" \\ and \u with four digits.
    serde_json::Value::from(text).to_string()
}

fn names(name: &Text) -> String {
    format!("en = {}, de = {}", quoted(&name.en), quoted(&name.de))
}

fn slug_of(name: &str) -> String {
    fold(name).replace(' ', "-")
}

/// A stable name for every row, none twice, none that another parameter of the family has.
fn slugs(target: &Target, drafts: &[Draft]) -> Vec<String> {
    let ids: BTreeSet<u32> = drafts.iter().map(|draft| draft.id).collect();
    let others = target.known.iter().flat_map(|family| family.params.values()).filter(|param| !ids.contains(&param.id));
    let taken: BTreeSet<String> = others.map(|param| param.slug.clone()).collect();
    let mut used: BTreeMap<String, u32> = BTreeMap::new();
    let mut slug = |draft: &Draft| {
        let wanted = draft.slug.clone().unwrap_or_else(|| slug_of(&draft.name.en));
        // A number alone is that of a parameter.
        let is_name = wanted.chars().any(|letter| letter.is_ascii_alphabetic());
        let wanted = if is_name { wanted } else { format!("parameter-{}", draft.id) };
        let is_taken = taken.contains(&wanted) || used.get(&wanted).is_some_and(|id| *id != draft.id);
        let slug = if is_taken { format!("{wanted}-{}", draft.id) } else { wanted };
        used.insert(slug.clone(), draft.id);
        slug
    };
    drafts.iter().map(&mut slug).collect()
}

/// The name of a row's table: one that the family has, or one that is written behind the rows.
fn table(
    tables: &mut Tables,
    (name, rows): &(Option<String>, Vec<(i64, Text)>),
    slug: &str,
    is_known: impl Fn(&str) -> bool,
) -> Option<String> {
    match name {
        Some(name) if is_known(name) => return Some(name.clone()),
        _ if rows.is_empty() => return name.clone(),
        _ => {}
    }
    let mut name = name.clone().unwrap_or_else(|| slug.to_owned());
    while is_known(&name) || tables.get(&name).is_some_and(|table| table != rows) {
        name += "-own";
    }
    let mut seen = BTreeSet::new();
    tables.insert(name.clone(), rows.iter().filter(|row| seen.insert(row.0)).cloned().collect());
    Some(name)
}

/// The keys of a row.
fn row(target: &Target, draft: &Draft, slug: &str, [values, bits]: &[Option<String>; 2]) -> Vec<String> {
    let mut keys = vec![format!("id = {}", draft.id), format!("slug = {}", quoted(slug)), names(&draft.name)];
    let mut text =
        |key: &str, value: Option<&str>| keys.extend(value.map(|value| format!("{key} = {}", quoted(value))));
    text("short", draft.short.as_deref());
    text("unit", draft.unit.as_deref());
    text("type", draft.kind.map(|kind| kind.name()));
    text("access", Some(draft.access.name()));
    text("sets", draft.sets.map(|sets| if sets == Sets::Four { "four" } else { "one" }));
    text("effective", (draft.effective == Effective::Reset).then_some("reset"));
    text("hazard", draft.hazard.map(hazard_name));
    text("module", draft.module.as_deref());
    text("enum", values.as_deref());
    text("bits", bits.as_deref());
    text("source", draft.source.as_deref());
    for (key, number) in ["min", "max", "default"].into_iter().zip(&draft.limits) {
        let plain = number.as_deref().map(|number| match number.contains('.') {
            true => number.trim_end_matches('0').trim_end_matches('.'),
            false => number,
        });
        keys.extend(plain.map(|number| match number.contains('.') {
            true => format!("{key} = {}", quoted(number)),
            false => format!("{key} = {number}"),
        }));
    }
    keys.extend(draft.decimals.map(|decimals| format!("decimals = {decimals}")));
    keys.extend(draft.note.as_ref().map(|note| format!("note = {{ {} }}", names(note))));
    let list = |words: &[String]| words.iter().map(|word| quoted(word)).collect::<Vec<_>>().join(", ");
    let lists = [("unconfirmed", &draft.unconfirmed), ("drives", &draft.drives)];
    keys.extend(lists.iter().filter(|row| !row.1.is_empty()).map(|(key, words)| format!("{key} = [{}]", list(words))));
    if !draft.bits_when.is_empty() {
        let when = |(param, value, bits): &(u32, i64, String)| {
            format!("{{ param = {param}, value = {value}, bits = {} }}", quoted(bits))
        };
        keys.push(format!("bits_when = [{}]", draft.bits_when.iter().map(when).collect::<Vec<_>>().join(", ")));
    }
    let is_there = |family: &Rc<Family>| family.params.contains_key(&draft.id);
    let flags = [
        ("volatile", draft.volatile),
        ("hex", draft.hex),
        ("replace", target.replace && target.known.iter().any(is_there)),
    ];
    keys.extend(flags.iter().filter(|flag| flag.1).map(|flag| format!("{} = true", flag.0)));
    keys
}

/// Groups of a family of its own.
fn groups(drafts: &[Draft]) -> String {
    let mut groups: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for draft in drafts {
        let name = draft.group.as_deref().map(slug_of).filter(|name| !name.is_empty() && name != "all");
        groups.entry(name.unwrap_or_default()).or_default().push(draft.id.to_string());
    }
    groups.remove("");
    let rows: String = groups.iter().map(|(name, ids)| format!("{} = [{}]\n", quoted(name), ids.join(", "))).collect();
    if rows.is_empty() { rows } else { format!("\n[groups]\n{rows}") }
}
