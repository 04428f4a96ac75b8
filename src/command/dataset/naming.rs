//! Files that are called after their drives.

use crate::args::{Settings, called};
use crate::command::plant::lines::plain;
use crate::failure::{Class, Failure};
use crate::text::{Text, both};
use std::path::{Path, PathBuf};

/// What stands for the address in the name of a file.
const ADDRESS: &str = "{address}";
/// What stands for the name in the project file.
const NAME: &str = "{name}";

/// What a file of a drive is called after.
#[derive(Clone, Debug)]
pub(super) struct Naming {
    pub(super) address: u8,
    /// In the project file; without one it is the address.
    pub(super) name: String,
    /// A drive of another line may have the same address.
    is_one_of_lines: bool,
}

impl Naming {
    /// That of every drive of a line.
    pub(super) fn of_line(settings: &Settings, addresses: &[u8]) -> Result<Vec<Naming>, Failure> {
        let mut names = called(settings)?;
        let of = |&address: &u8| Naming {
            address,
            name: names.remove(&address).unwrap_or_else(|| address.to_string()),
            is_one_of_lines: settings.is_one_of_lines,
        };
        Ok(addresses.iter().map(of).collect())
    }

    /// The file of this drive.
    pub(super) fn own(&self, file: &Path) -> PathBuf {
        let file = file.to_string_lossy().replace(ADDRESS, &self.address.to_string());
        PathBuf::from(file.replace(NAME, &plain(&self.name)))
    }

    /// Whether each drive has a file of its own so.
    pub(super) fn tells_apart(&self, file: &Path) -> bool {
        let file = file.to_string_lossy();
        file.contains(NAME) || file.contains(ADDRESS) && !self.is_one_of_lines
    }

    /// What tells it apart where nobody says what.
    pub(super) fn word(&self) -> String {
        if self.is_one_of_lines { plain(&self.name) } else { self.address.to_string() }
    }

    /// Refuses a file in whose name nothing tells the drives apart; `or` is what would do besides.
    pub(super) fn refused(&self, message: Text, or: &Text) -> Failure {
        let hint = match self.is_one_of_lines {
            true => both!(
                "put {{name}} into its name{or}: on several lines two drives may have one address",
                "{{name}} in ihren Namen setzen{or}: an mehreren Leitungen können zwei Antriebe dieselbe Adresse haben",
                or
            ),
            false => both!("put {{address}} into its name{or}", "{{address}} in ihren Namen setzen{or}", or),
        };
        Failure::new(Class::Usage, "usage.file", message).hint(hint)
    }
}
