//! MBMap version 2: public maps of registers as JSON (docs/sources.md, "MBMap"). Only what the pages that were seen say of the
//! format is taken; a key of a register that is not known may change what its value means, so such a register is left out.

use super::cells::{self, Kind};
use super::draft::{Draft, ImportError, Imported, LeftOut, Own, Wishes};
use super::sheet;
use crate::profile::link::INPUTS;
use crate::profile::names::fold;
use crate::profile::param::{Access, Type};
use crate::text::{Text, both};
use serde_json::error::Category;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Keys of a register that are taken.
const TAKEN: &[&str] = &[
    "name",
    "group",
    "area",
    "address",
    "type",
    "length",
    "scale",
    "offset",
    "unit",
    "access",
    "enum",
    "word_order",
    "byte_order",
    "sentinels",
];
/// Keys of a register that say nothing of the number it holds.
const HARMLESS: &[&str] = &["description", "note", "notes", "bits", "min", "max", "source", "sources", "firmware"];
/// Keys of a map that are told, so that somebody can set the line.
const LINE: &[&str] =
    &["protocol", "unit_id", "port", "baudrate", "data_bits", "parity", "stop_bits", "max_read_registers"];

/// Reads a map.
pub fn mbmap(bytes: &[u8], wishes: &Wishes) -> Result<Imported, ImportError> {
    let (text, encoding) = sheet::text_of(bytes);
    let wrong = |line: usize, error: &serde_json::Error| {
        let column = error.column();
        ImportError::at(
            line,
            match error.classify() {
                Category::Eof => both!("no JSON: it ends in the middle", "kein JSON: es hört mittendrin auf"),
                Category::Data => {
                    both!("no JSON of a map: {error}", "kein JSON einer MBMap: {error}", error = Text::quoted(error))
                }
                Category::Syntax | Category::Io => {
                    both!("no JSON from column {column} on", "ab Spalte {column} kein JSON")
                }
            },
        )
    };
    let map: Map<String, Value> = serde_json::from_str(&text).map_err(|error| wrong(error.line(), &error))?;
    if map.get("mbmap") != Some(&Value::from(2)) {
        let why =
            both!("no MBMap of version 2: \"mbmap\": 2 is missing", "keine MBMap der Version 2: \"mbmap\": 2 fehlt");
        return Err(ImportError::at(1, why));
    }
    let Some(registers) = map.get("registers").and_then(Value::as_array) else {
        let why = both!("the list \"registers\" is missing", "die Liste \"registers\" fehlt");
        return Err(ImportError::at(1, why));
    };
    if let Some((field, _)) = wishes.sets.iter().chain(&wishes.columns).next() {
        let why = both!(
            "'{field}': --set and --column are for tables; an MBMap says itself what each register is",
            "'{field}': --set und --column gehören zu Tabellen; eine MBMap sagt selbst, was jedes Register ist"
        );
        return Err(ImportError::at(0, why));
    }
    let device = Device::of(&map, wishes)?;
    let lines = lines_of_registers(&text);
    let mut found = Imported { format: "mbmap", encoding, own: device.own(&map), ..Imported::default() };
    found.notes.extend(line_note(&map));
    let (mut seen, mut unbounded) = (BTreeMap::new(), Vec::new());
    for (index, register) in registers.iter().enumerate() {
        let line = lines.get(index).copied().unwrap_or(1);
        let draft = register.as_object().ok_or_else(|| both!("no object", "kein Objekt"));
        let draft =
            draft.and_then(|register| device.draft(line, register)).and_then(|draft| match seen.get(&draft.id) {
                Some(first) => Err(twice(draft.id, *first)),
                None => Ok(draft),
            });
        match draft {
            Ok(draft) => {
                seen.insert(draft.id, line);
                let has = |key: &str| register.get(key).is_some();
                if (has("min") || has("max")) && draft.limits[..2].iter().all(Option::is_none) {
                    unbounded.push(draft.id.to_string());
                }
                found.drafts.push(draft);
            }
            Err(why) => found.left_out.push(LeftOut { line, why }),
        }
    }
    let silent = registers.iter().filter(|register| register.get("access").is_none()).count();
    if silent > 0 {
        found.notes.push(both!(
            "{silent} registers without \"access\" are taken as read only",
            "{silent} Register ohne \"access\" werden als nur lesbar genommen"
        ));
    }
    if !unbounded.is_empty() {
        found.notes.push(open_ranges(&unbounded.join(", ")));
    }
    Ok(found)
}

fn open_ranges(registers: &str) -> Text {
    both!(
        "the ranges (min, max) of these registers are not taken, so nothing beyond them is refused: {registers}; they are scaled, and no \
         source tells whether their limits are",
        "die Bereiche (min, max) dieser Register sind nicht übernommen, deshalb wird nichts außerhalb zurückgewiesen: {registers}; sie sind \
         skaliert, und keine Quelle sagt, ob ihre Grenzen es auch sind"
    )
}

fn twice(id: u32, first: usize) -> Text {
    both!("register {id} is taken already, from line {first}", "Register {id} ist schon vergeben, aus Zeile {first}")
}

/// What a map says of all its registers.
struct Device<'a> {
    map: &'a Map<String, Value>,
    wishes: &'a Wishes,
    base: u32,
    word_order: &'a str,
}

impl<'a> Device<'a> {
    fn of(map: &'a Map<String, Value>, wishes: &'a Wishes) -> Result<Self, ImportError> {
        let word = |key: &str| map.get(key).and_then(Value::as_str);
        if let Some(other) = word("byte_order").filter(|order| *order != "big") {
            let why = both!(
                "byte_order '{other}': Modbus sends the upper byte of a register first, and so does this program",
                "byte_order '{other}': Modbus sendet in jedem Wort das obere Byte zuerst, dieses Programm auch"
            );
            return Err(ImportError::at(1, why));
        }
        let word_order = word("word_order").unwrap_or("big");
        if !["big", "little"].contains(&word_order) {
            let why = both!("word_order '{word_order}' is not known", "word_order '{word_order}' ist unbekannt");
            return Err(ImportError::at(1, why));
        }
        let said = map.get("address_base").and_then(Value::as_u64).and_then(|base| u32::try_from(base).ok());
        let Some(base) = wishes.base.or(said) else {
            let why = both!(
                "the map does not say whether its addresses begin with 0 or 1 (address_base)",
                "die MBMap sagt nicht, ob ihre Adressen mit 0 oder 1 beginnen (address_base)"
            );
            let hint =
                both!("say which number register 0 has: --base 0", "angeben, welche Nummer Register 0 hat: --base 0");
            return Err(ImportError::at(1, why).hint(hint));
        };
        Ok(Device { map, wishes, base, word_order })
    }

    fn own(&self, map: &Map<String, Value>) -> Own {
        let word = |key: &str| map.get(key).and_then(Value::as_str).map(tidy);
        let (vendor, model) = (word("vendor").unwrap_or_default(), word("model").unwrap_or_default());
        let ascii = |name: String| name.chars().filter(|c| c.is_ascii_alphanumeric() || *c == '-').collect::<String>();
        let id = ascii(fold(&format!("{vendor} {model}")).replace(' ', "-")).trim_matches('-').to_owned();
        let title = format!("{vendor} {model}").trim().to_owned();
        Own { id, title, low_half_first: self.word_order == "little" }
    }

    fn draft(&self, line: usize, register: &Map<String, Value>) -> Result<Draft, Text> {
        self.check_keys(register)?;
        let word = |key: &str| register.get(key).and_then(Value::as_str).map(tidy).filter(|word| !word.is_empty());
        let id = self.id(register)?;
        let name = word("name").unwrap_or_else(|| format!("Register {id}"));
        let mut draft = Draft::new(line, id, Text::name(name));
        draft.unit = word("unit");
        draft.group = word("group");
        draft.note = word("description").or_else(|| word("note")).map(Text::name);
        let kind = word("type").ok_or_else(|| both!("no type", "kein Typ"))?;
        match cells::kind(&kind) {
            Kind::Is(Type::String) | Kind::Cannot | Kind::Unknown => return Err(cells::cannot(&kind)),
            Kind::Is(kind) => draft.kind = Some(kind),
            Kind::Unsigned32 => {
                draft.kind = Some(Type::Long);
                draft.limits[0] = Some("0".to_owned());
            }
        }
        if let Some(order) =
            word("word_order").filter(|order| order != self.word_order && draft.kind.and_then(Type::bits) == Some(32))
        {
            return Err(both!(
                "word_order '{order}' is another one than that of the map",
                "word_order '{order}' ist eine andere als die der MBMap"
            ));
        }
        scale(register, &mut draft)?;
        limits(register, &mut draft);
        if let Some(access) = word("access") {
            draft.access = cells::access(&access)
                .ok_or_else(|| both!("the access '{access}' is not known", "der Zugriff '{access}' ist unbekannt"))?;
        }
        if INPUTS.contains(&draft.id) {
            draft.access = Access::Read;
        }
        draft.enumeration.1 = self.names(register, &kind);
        Ok(draft)
    }

    fn check_keys(&self, register: &Map<String, Value>) -> Result<(), Text> {
        let is_known = |key: &str| {
            TAKEN.contains(&key)
                || HARMLESS.contains(&key)
                || key.starts_with("x_")
                || self.wishes.ignored.iter().any(|known| known == key)
        };
        let unknown = register.keys().find(|key| !is_known(key)).map(|key| tidy(key));
        let big = register.get("byte_order").is_none_or(|order| order == "big");
        match unknown {
            Some(key) => Err(both!(
                "the key '{key}' is not known and may change the value (--ignore {key} takes the register without it)",
                "der Schlüssel '{key}' ist unbekannt und kann den Wert ändern (--ignore {key} nimmt das Register ohne ihn)"
            )),
            None if !big => Err(both!("another byte_order than big", "eine andere byte_order als big")),
            None => Ok(()),
        }
    }

    /// The number of a register that function code 3 or 4 reads.
    fn id(&self, register: &Map<String, Value>) -> Result<u32, Text> {
        let Some(area) = register.get("area").and_then(Value::as_str) else {
            return Err(both!(
                "`area` is missing (expected: \"holding\" or \"input\")",
                "`area` fehlt (erwartet: \"holding\" oder \"input\")"
            ));
        };
        match area {
            "holding" | "input" => {}
            other => {
                let other = tidy(other);
                return Err(both!("area '{other}' holds no register", "der Bereich '{other}' enthält keine Register"));
            }
        }
        let address = match register.get("address") {
            Some(Value::Number(number)) => number.as_u64().and_then(|number| u32::try_from(number).ok()),
            Some(Value::String(text)) => cells::id(text),
            _ => None,
        };
        let cell = address.and_then(|address| address.checked_sub(self.base)).filter(|id| *id <= u16::MAX.into());
        let first = if area == "input" && !self.wishes.input_as_holding { *INPUTS.start() } else { 0 };
        cell.map(|cell| first + cell).ok_or_else(|| {
            let (got, base) =
                (register.get("address").map(|value| tidy(&value.to_string())).unwrap_or_default(), self.base);
            both!(
                "address {got} is no register: {base} is register 0, the last one 65535",
                "Adresse {got} ist kein Register: {base} ist Register 0, das letzte 65535"
            )
        })
    }

    /// Values with names: those of the register, and what stands for "no value".
    fn names(&self, register: &Map<String, Value>, kind: &str) -> Vec<(i64, Text)> {
        let shared = |name: &str| self.map.get("enums").and_then(|enums| enums.get(name));
        let own = match register.get("enum") {
            Some(Value::String(name)) => shared(name),
            other => other,
        };
        let absent = register.get("sentinels").or_else(|| self.map.get("sentinels").and_then(|types| types.get(kind)));
        let tables = [own, absent].into_iter().flatten().filter_map(Value::as_object).flatten();
        let signed = |raw: i64| match cells::kind(kind) {
            Kind::Is(Type::Int) if (0x8000..=0xFFFF).contains(&raw) => raw - 0x1_0000,
            Kind::Is(Type::Long) if (0x8000_0000..=0xFFFF_FFFF).contains(&raw) => raw - 0x1_0000_0000,
            _ => raw,
        };
        let rows = tables.filter_map(|(raw, name)| {
            let raw = cells::number(raw, false)?.parse().ok()?;
            Some((signed(raw), Text::name(tidy(name.as_str()?))))
        });
        rows.collect()
    }
}

/// Places behind the point; what no power of ten scales, or what is shifted, is shown raw.
fn scale(register: &Map<String, Value>, draft: &mut Draft) -> Result<(), Text> {
    let number = |key: &str, usual: f64| match register.get(key) {
        None | Some(Value::Null) => Some(usual),
        Some(value) => value.as_f64(),
    };
    if draft.kind == Some(Type::Float) {
        return match (number("scale", 1.0), number("offset", 0.0)) {
            (Some(1.0), Some(0.0)) => Ok(()),
            _ => Err(cells::scaled_float()),
        };
    }
    let exact = |number: f64| format!("{number:.9}");
    let places = number("scale", 1.0).and_then(|scale| cells::decimals(&exact(scale)));
    draft.decimals = places.filter(|_| number("offset", 0.0) == Some(0.0));
    if draft.decimals.is_none() {
        draft.limits = [None, None, None];
        if draft.unit.is_none() {
            return Err(both!(
                "its scale or offset is none that this program computes with",
                "mit dieser Skalierung oder diesem Versatz rechnet dieses Programm nicht"
            ));
        }
        let why =
            both!("shown raw: the map scales or shifts it", "roh gezeigt: die MBMap skaliert oder verschiebt den Wert");
        draft.note.get_or_insert(why);
    }
    Ok(())
}

/// Both ends of the range, where it is the same raw and scaled: whether a map means the one or the other no source tells.
fn limits(register: &Map<String, Value>, draft: &mut Draft) {
    if draft.decimals != Some(0) || draft.kind == Some(Type::Float) {
        return;
    }
    for (limit, key) in draft.limits.iter_mut().zip(["min", "max"]) {
        let told = register.get(key).and_then(Value::as_i64).map(|number| number.to_string());
        *limit = told.or_else(|| limit.take());
    }
}

fn line_note(map: &Map<String, Value>) -> Option<Text> {
    let said =
        LINE.iter().filter_map(|key| Some(format!("{key} {}", tidy(&map.get(*key)?.to_string()).replace('"', ""))));
    let said = said.collect::<Vec<_>>().join(", ");
    (!said.is_empty()).then(|| both!("the map says of the line: {said}", "die MBMap sagt von der Leitung: {said}"))
}

/// A text in one line, and not endless.
fn tidy(text: &str) -> String {
    sheet::tidy(&text.chars().take(500).collect::<String>())
}

/// The lines where the objects of the list `registers` begin.
fn lines_of_registers(text: &str) -> Vec<usize> {
    let (mut depth, mut quoted, mut escaped, mut key) = (0_usize, false, false, String::new());
    let (mut inside, mut line, mut starts) = (false, 1, Vec::new());
    for letter in text.chars() {
        line += usize::from(letter == '\n');
        match letter {
            _ if escaped => escaped = false,
            '\\' if quoted => escaped = true,
            '"' => {
                quoted = !quoted;
                if quoted && depth == 1 {
                    key.clear();
                }
            }
            _ if quoted && depth == 1 => key.push(letter),
            _ if quoted => {}
            '{' | '[' => {
                inside |= depth == 1 && letter == '[' && key == "registers";
                if inside && depth == 2 && letter == '{' {
                    starts.push(line);
                }
                depth += 1;
            }
            '}' | ']' => {
                depth = depth.saturating_sub(1);
                inside &= depth > 1;
            }
            _ => {}
        }
    }
    starts
}
