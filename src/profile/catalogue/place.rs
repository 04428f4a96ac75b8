//! Where a catalogue comes from, and where in it something is wrong.

use crate::profile::broken::Broken;
use crate::profile::row::CatalogueRow;
use crate::text::{Text, both};
use serde::de::DeserializeOwned;
use toml::de::DeTable;

/// Longest name, text or remark.
pub(super) const MAX_TEXT: usize = 2_000;

/// Where a catalogue comes from.
#[derive(Debug)]
pub(super) enum Origin {
    /// It is ours, and proved by our tests.
    Shipped { path: String },
    /// It was read, and its text is kept to say where something stands that is wrong.
    File { path: String, text: String },
}

/// Where something stands in a catalogue.
#[derive(Clone, Copy, Debug)]
pub(super) enum Position<'a> {
    /// At its beginning.
    File,
    /// At this offset.
    Offset(usize),
    /// A row of a list.
    Row(&'a str, usize),
    /// A row of a table of tables: `[enums.protocol]` has the row `0`.
    Entry(&'a str, &'a str, &'a str),
}

impl Origin {
    pub(super) fn path(&self) -> &str {
        match self {
            Origin::Shipped { path } | Origin::File { path, .. } => path,
        }
    }

    pub(super) fn parse<T: DeserializeOwned>(&self, json: &str) -> Result<T, Broken> {
        serde_json::from_str(json).map_err(|error| self.error(Position::File, Text::quoted(error)))
    }

    pub(super) fn error(&self, place: Position<'_>, message: Text) -> Broken {
        let text = match self {
            Origin::Shipped { .. } => "",
            Origin::File { text, .. } => text,
        };
        Broken::at(self.path(), text, place.offset(text).unwrap_or(0), message)
    }

    pub(super) fn check_texts<T: CatalogueRow>(&self, at: Position<'_>, row: &T) -> Result<(), Broken> {
        row.texts().into_iter().try_for_each(|text| self.check_text(at, text))
    }

    pub(super) fn check_text(&self, at: Position<'_>, text: &str) -> Result<(), Broken> {
        if matches!(self, Origin::Shipped { .. }) {
            return Ok(());
        }
        if text.len() > MAX_TEXT {
            let why = both!(
                "a text of {bytes} bytes; at most {MAX_TEXT} are allowed",
                "ein Text von {bytes} Byte; erlaubt sind höchstens {MAX_TEXT}",
                bytes = text.len()
            );
            return Err(self.error(at, why));
        }
        match text.chars().find(|c| c.is_control()) {
            Some(bad) => Err(self.error(
                at,
                both!(
                    "control character U+{code:04X} in a text",
                    "Steuerzeichen U+{code:04X} in einem Text",
                    code = u32::from(bad)
                ),
            )),
            None => Ok(()),
        }
    }
}

impl Position<'_> {
    /// Offset in the text of the catalogue, which is parsed once more for it: only errors ask.
    pub(super) fn offset(self, text: &str) -> Option<usize> {
        let table = |name: &str| Some(DeTable::parse(text).ok()?.get_ref().get(name)?.get_ref().clone());
        match self {
            Position::File => None,
            Position::Offset(at) => Some(at),
            Position::Row(list, index) => Some(table(list)?.get(index)?.span().start),
            Position::Entry(tables, name, key) => Some(table(tables)?.get(name)?.get_ref().get(key)?.span().start),
        }
    }
}
