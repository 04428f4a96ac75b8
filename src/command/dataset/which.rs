//! A side of a comparison, as it is typed.

use crate::profile::{DataSets, Store};
use crate::text::{Wrong, both};
use std::path::PathBuf;
use std::str::FromStr;

/// A side, as it is typed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Which {
    /// A data set of the drive.
    Set(u8, Store),
    /// The factory settings that are known.
    Factory,
    /// The drive at this address; at the only one that is given.
    Drive(Option<u8>),
    /// A parameter file.
    File(PathBuf),
}

impl FromStr for Which {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let is_set = text.trim_end_matches("ram").chars().all(|c| c.is_ascii_digit());
        match text.parse() {
            Ok(DataSets::One(set @ 1..=4, store)) => return Ok(Which::Set(set, store)),
            _ if is_set => {
                return Err(Wrong(both!(
                    "'{text}' is no data set: expected 1-4 or 1ram-4ram",
                    "'{text}' ist kein Datensatz: erwartet 1-4 oder 1ram-4ram"
                )));
            }
            _ => {}
        }
        let address = text.strip_prefix("drive:").map(|address| address.parse().ok().filter(|address| *address > 0));
        match (text, address) {
            ("factory", _) => Ok(Which::Factory),
            ("drive", _) => Ok(Which::Drive(None)),
            (_, Some(Some(address))) => Ok(Which::Drive(Some(address))),
            (_, Some(None)) => Err(Wrong(both!(
                "'{text}': expected the address of a drive, such as drive:3",
                "'{text}': erwartet die Adresse eines Antriebs, etwa drive:3"
            ))),
            _ => Ok(Which::File(text.into())),
        }
    }
}

impl Which {
    /// The word for it in JSON.
    pub(super) fn kind(&self) -> &'static str {
        match self {
            Which::Set(..) => "set",
            Which::Factory => "factory",
            Which::Drive(_) => "drive",
            Which::File(_) => "file",
        }
    }

    /// The address of the drive that is asked, if one is.
    pub(super) fn address(&self, only: Option<u8>) -> Option<u8> {
        match self {
            Which::Drive(Some(address)) => Some(*address),
            Which::Set(..) | Which::Drive(None) => only,
            Which::Factory | Which::File(_) => None,
        }
    }
}
