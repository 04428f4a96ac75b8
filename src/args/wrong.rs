//! A setting that does not do.

use crate::failure::{Class, Failure};
use crate::text::{Text, both};

/// Settings whose name in German is another word.
const GERMAN: [(&str, &str); 9] = [
    ("address", "Adresse"),
    ("port", "Anschluss"),
    ("protocol", "Protokoll"),
    ("baud", "Baudrate"),
    ("parity", "Parität"),
    ("data_bits", "Datenbits"),
    ("stop_bits", "Stoppbits"),
    ("drive", "Antrieb"),
    ("catalogue", "Katalog"),
];

/// Why this setting does not do.
pub(super) fn bad_setting(name: &str, why: Text) -> Failure {
    let german = GERMAN.iter().find(|row| row.0 == name).map_or(name, |row| row.1);
    let name_in = Text::by(|lang| lang.pick(name, german).to_owned());
    Failure::new(Class::Usage, format!("usage.{name}"), both!("{name_in}: {why}", "{name_in}: {why}", name_in, why))
}
