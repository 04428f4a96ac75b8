//! From the text of a parameter file to what stands in it, or to the place where it is broken.

use super::advice::advice;
use super::file::{At, Head, Line, NotHeld, ParamFile, Provenance, SavedDrive, Undo, VERSION};
use super::ranges::numbers;
use super::signature::Signature;
use crate::profile::broken::stumbled;
use crate::profile::param::Type;
use crate::profile::select::Store;
use crate::text::{Lang, Text, both};
use schemars::JsonSchema;
use serde::{Deserialize, Deserializer};
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::rc::Rc;
use toml::Spanned;
use toml::de::DeTable;

/// Longest name or value.
const MAX_TEXT: usize = 200;

/// What is wrong with a parameter file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{at}: {}", why.en)]
pub struct FileFault {
    /// Where.
    pub at: At,
    /// What is wrong and what would be right.
    pub why: Text,
    /// It is right, but made by a newer program.
    pub newer: bool,
    /// What to do, where that is known.
    pub hint: Option<Box<Text>>,
}

impl FileFault {
    /// What is wrong at a place.
    pub fn new(at: At, why: Text) -> Self {
        FileFault { at, why, newer: false, hint: None }
    }

    /// The same with what to do.
    #[must_use]
    pub fn hint(self, hint: Text) -> Self {
        FileFault { hint: Some(Box::new(hint)), ..self }
    }

    /// In words for people.
    pub fn text(&self) -> Text {
        both!("{at}: {why}", "{at}: {why}", at = self.at, why = self.why)
    }
}

/// The JSON Schema of a file as it stands in `docs/`.
pub fn schema() -> schemars::Schema {
    schemars::schema_for!(Whole)
}

/// The settings of one drive as text (docs/parameter-files.md).
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
#[schemars(title = "Parameter file of antrieb")]
pub(super) struct Whole {
    /// Version of the format.
    #[schemars(range(min = 1, max = VERSION))]
    #[serde(rename = "antrieb")]
    _antrieb: u32,
    /// The drive that the settings are of, or for.
    drive: Placed<SavedDrive>,
    /// When and how the file was written.
    #[serde(default)]
    saved: Option<Placed<Provenance>>,
    /// Numbers of parameters that the file does not hold, by the reason, as ranges: `210-213, 217`.
    #[serde(default)]
    not_held: BTreeMap<NotHeld, Placed<String>>,
    /// Data types that were found out by asking, by number; of parameters whose type no catalogue tells.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, WordOfType>")]
    types: BTreeMap<Spanned<String>, Type>,
    /// The values by parameter and data set: `"372@2" = "1450 1/min"`. Without a data set all four are meant, or the only
    /// one. A value is written as for `antrieb write`; `raw 1234` is the integer without its decimal point.
    #[schemars(with = "BTreeMap<String, Scalar>")]
    values: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    /// What a transaction was about to write. `antrieb dataset undo` brings back the values.
    #[serde(default)]
    undo: Option<UndoTable>,
}

/// What a transaction was about to write.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct UndoTable {
    /// Where the values went.
    #[serde(default)]
    memory: Memory,
    /// The new values, like the old ones.
    #[schemars(with = "BTreeMap<String, Scalar>")]
    values: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    /// What stood in the RAM alone, over what was stored. `antrieb dataset undo` names it and does not bring it back. Since version 2.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Scalar>")]
    ram: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
    /// What the drive did not take back into its EEPROM when the transaction failed. It may tell its RAM as stored, so `antrieb dataset
    /// undo` writes it whatever is read. Since version 2.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Scalar>")]
    unproven: BTreeMap<Spanned<String>, Spanned<toml::Value>>,
}

/// Where the values of a transaction went.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Memory {
    /// To stay.
    #[default]
    Eeprom,
    /// Until power-off.
    Ram,
}

impl From<Memory> for Store {
    fn from(memory: Memory) -> Self {
        match memory {
            Memory::Eeprom => Store::Eeprom,
            Memory::Ram => Store::Ram,
        }
    }
}

/// Something with its place in the text.
pub(super) struct Placed<T>(Spanned<T>);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Placed<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Spanned::deserialize(deserializer).map(Placed)
    }
}

impl<T: JsonSchema> JsonSchema for Placed<T> {
    fn schema_name() -> Cow<'static, str> {
        T::schema_name()
    }
    fn inline_schema() -> bool {
        T::inline_schema()
    }
    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        T::json_schema(generator)
    }
}

/// The word for a data type.
#[derive(JsonSchema)]
#[schemars(rename_all = "lowercase")]
#[expect(dead_code, reason = "for the schema only")]
enum WordOfType {
    Uint,
    Int,
    Word,
    Long,
}

/// A value: text with or without a unit, or a bare number, which means the same as its text.
#[derive(JsonSchema)]
#[serde(untagged)]
#[expect(dead_code, reason = "for the schema only")]
enum Scalar {
    Text(String),
    Number(f64),
}

impl ParamFile {
    /// Takes the text of a file apart. `path`: as the user names it, for places.
    ///
    /// # Errors
    /// It is no TOML, not of this format, or of a newer one; with the line and column.
    pub fn parse(path: &str, text: &str) -> Result<Self, FileFault> {
        let begins = std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect();
        let source = Source { path: path.into(), text, begins };
        source.check_version()?;
        let whole: Whole = toml::from_str(text).map_err(|error| source.toml(&error))?;
        let Whole { drive, saved, not_held, types, values, undo, .. } = whole;
        let family_at = source.at(source.family());
        let drive = drive.0.into_inner();
        if let Some(saved) = &saved {
            source.check_signature(saved.0.span().start, saved.0.get_ref())?;
        }
        let saved =
            saved.map_or_else(|| Provenance { complete: true, ..Provenance::default() }, |it| it.0.into_inner());
        let not_held =
            not_held.into_iter().map(|(reason, list)| source.list(reason, list.0)).collect::<Result<_, _>>()?;
        let types = types.into_iter().map(|(key, kind)| source.kind(&key, kind)).collect::<Result<_, _>>()?;
        let lines = source.lines(&values)?;
        let undo = undo.map(|UndoTable { memory, values, ram, unproven }| {
            let [lines, ram, unproven] = [values, ram, unproven].map(|table| source.lines(&table));
            Ok(Undo { store: memory.into(), lines: lines?, ram: ram?, unproven: unproven? })
        });
        let undo = undo.transpose()?;
        let head = Head { drive, saved, not_held, types, lang: Lang::En };
        Ok(ParamFile { path: source.path, head, family_at, lines, undo })
    }
}

/// The text of a file, for saying where something stands.
struct Source<'t> {
    path: Rc<str>,
    text: &'t str,
    /// Where each line begins.
    begins: Vec<usize>,
}

impl Source<'_> {
    fn at(&self, byte: usize) -> At {
        let line = self.begins.partition_point(|begin| *begin <= byte);
        let begin = self.begins.get(line.saturating_sub(1)).copied().unwrap_or(0);
        let column = self.text.get(begin..byte).map_or(1, |before| before.chars().count() + 1);
        At { path: self.path.clone(), line, column }
    }

    /// Where the family stands.
    fn family(&self) -> usize {
        let root = DeTable::parse(self.text).ok();
        let family = root.as_ref().and_then(|root| root.get_ref().get("drive")?.get_ref().as_table()?.get("family"));
        family.map_or(0, |family| family.span().start)
    }

    fn fault(&self, byte: usize, why: Text) -> FileFault {
        FileFault::new(self.at(byte), why)
    }

    /// What the reader of TOML says.
    fn toml(&self, error: &toml::de::Error) -> FileFault {
        let (at, why) = stumbled(error);
        FileFault { hint: advice(self.text, at, error.message()).map(Box::new), ..self.fault(at, why) }
    }

    /// The version comes first: a newer file may hold what is unknown here, and that is not its fault.
    fn check_version(&self) -> Result<(), FileFault> {
        let table = DeTable::parse(self.text).map_err(|error| self.toml(&error))?;
        let Some(stated) = table.get_ref().get("antrieb") else {
            let why = both!(
                "this is no parameter file: expected `antrieb = 1` at its beginning",
                "das ist keine Parameterdatei: erwartet wird `antrieb = 1` an ihrem Anfang"
            );
            return Err(self.fault(0, why));
        };
        let start = stated.span().start;
        match stated.get_ref().as_integer().and_then(|it| it.as_str().parse::<u32>().ok()) {
            Some(version @ 1..) if version <= VERSION => Ok(()),
            Some(version) if version > VERSION => {
                let why = both!(
                    "format {version} is newer than this program, which knows formats up to {VERSION}",
                    "Format {version} ist neuer als dieses Programm, das Formate bis {VERSION} kennt"
                );
                Err(FileFault { newer: true, ..self.fault(start, why) })
            }
            _ => {
                let why = both!(
                    "expected the version of the format, 1 to {VERSION}",
                    "erwartet wird die Version des Formats, 1 bis {VERSION}"
                );
                Err(self.fault(start, why))
            }
        }
    }

    fn check_signature(&self, start: usize, saved: &Provenance) -> Result<(), FileFault> {
        match &saved.signature {
            Some(signature) if signature.parse::<Signature>().is_err() => Err(self.fault(
                start,
                both!(
                    "the signature '{signature}' is none: expected 16 hexadecimal digits",
                    "die Signatur '{signature}' ist keine: erwartet werden 16 Hexadezimalziffern"
                ),
            )),
            _ => Ok(()),
        }
    }

    fn list(&self, reason: NotHeld, list: Spanned<String>) -> Result<(NotHeld, String), FileFault> {
        if numbers(list.get_ref()).is_some() {
            return Ok((reason, list.into_inner()));
        }
        let why = both!(
            "expected numbers of parameters such as \"210-213, 217\"",
            "erwartet werden Nummern von Parametern wie \"210-213, 217\""
        );
        Err(self.fault(list.span().start, why))
    }

    fn kind(&self, key: &Spanned<String>, kind: Type) -> Result<(u32, Type), FileFault> {
        match key.get_ref().parse() {
            Ok(number) if kind != Type::String => Ok((number, kind)),
            _ => Err(self.fault(
                key.span().start,
                both!(
                    "expected the number of a parameter and uint, int, word or long",
                    "erwartet wird die Nummer eines Parameters und uint, int, word oder long"
                ),
            )),
        }
    }

    /// The lines of a table, as they stand.
    fn lines(&self, values: &BTreeMap<Spanned<String>, Spanned<toml::Value>>) -> Result<Vec<Line>, FileFault> {
        let mut lines: Vec<(usize, Line)> = Vec::new();
        for (key, value) in values {
            lines.push((key.span().start, self.line(key, value)?));
        }
        lines.sort_by_key(|(start, _)| *start);
        Ok(lines.into_iter().map(|(_, line)| line).collect())
    }

    fn line(&self, key: &Spanned<String>, value: &Spanned<toml::Value>) -> Result<Line, FileFault> {
        let written = match value.get_ref() {
            toml::Value::String(text) => text.clone(),
            // The digits as they stand there: no float ever comes between.
            toml::Value::Integer(_) | toml::Value::Float(_) => {
                self.text.get(value.span()).unwrap_or_default().replace('_', "")
            }
            _ => {
                let why = both!("expected a value such as \"1450 1/min\"", "erwartet wird ein Wert wie \"1450 1/min\"");
                return Err(self.fault(value.span().start, why));
            }
        };
        for (text, start) in [(key.get_ref(), key.span().start), (&written, value.span().start)] {
            if text.len() > MAX_TEXT || text.chars().any(char::is_control) {
                let why = both!(
                    "expected at most {MAX_TEXT} printable characters",
                    "erwartet werden höchstens {MAX_TEXT} druckbare Zeichen"
                );
                return Err(self.fault(start, why));
            }
        }
        let (at, value_at) = (self.at(key.span().start), self.at(value.span().start));
        Ok(Line { key: key.get_ref().clone(), at, value: written, value_at })
    }
}
