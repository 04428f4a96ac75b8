//! Rows of a catalogue that carry texts: states, faults, errors, counters, bits; and what makes two rows the same.

use crate::text::{Lang, Text, both};
use serde::Deserialize;

/// A state of the drive's state machine.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DriveState {
    /// Stable name.
    pub slug: String,
    /// Bits that decide.
    pub mask: u32,
    /// Their value in this state.
    pub value: u32,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// Takes the place of the same row of an earlier catalogue.
    #[serde(default)]
    pub(super) replace: bool,
}

/// How the family numbers its faults.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FaultCodes {
    /// Letter before the number, as the drive displays it.
    pub letter: String,
    /// The number has two decimal digits (`E07`), not four hexadecimal ones.
    #[serde(default)]
    pub decimal: bool,
    /// The parameter with the role `fault` is an entry of the fault memory: it tells of the present only while the drive
    /// is in a fault state.
    #[serde(default)]
    pub memory: bool,
}

impl FaultCodes {
    /// A code as the drive displays it: `F0500`, `E07`.
    pub fn displayed(&self, code: u32) -> String {
        let letter = &self.letter;
        if self.decimal { format!("{letter}{code:02}") } else { format!("{letter}{code:04X}") }
    }

    /// The code that is displayed so.
    pub fn code(&self, displayed: &str) -> Option<u32> {
        let displayed = displayed.trim();
        let (letter, digits) = (displayed.get(..1)?, displayed.get(1..)?);
        let (radix, most) = if self.decimal { (10, 2) } else { (16, 4) };
        let fits = letter.eq_ignore_ascii_case(&self.letter)
            && (1..=most).contains(&digits.len())
            && digits.chars().all(|digit| digit.is_digit(radix));
        fits.then(|| u32::from_str_radix(digits, radix).ok()).flatten()
    }
}

/// Faults with the same high byte.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FaultGroup {
    /// High byte of the fault code.
    pub high: u32,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// Takes the place of the same row of an earlier catalogue.
    #[serde(default)]
    pub(super) replace: bool,
}

/// A fault.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FaultRow {
    /// Value of the fault parameter.
    pub code: u32,
    /// Last value, if a whole range means the same and its low byte is a node id.
    pub last: Option<u32>,
    /// As the drive displays it: `F0100`.
    pub key: String,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// What causes it, where a source tells it.
    pub cause: Option<Text>,
    /// What to do, where a source tells it.
    pub remedy: Option<Text>,
    /// Where the facts come from.
    pub source: Option<String>,
    /// Takes the place of the same row of an earlier catalogue.
    #[serde(default)]
    pub(super) replace: bool,
}

/// A code of the error register (P.11).
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ErrorRow {
    /// Value of the register.
    pub code: u32,
    /// Stable name.
    pub slug: String,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// What to do.
    pub hint: Text,
    /// To who reads, it says that the drive has no such parameter, or does not tell it.
    #[serde(default)]
    pub denies: bool,
    /// To who writes, it does not say that nothing was written.
    #[serde(default)]
    pub leaves_open: bool,
    /// Takes the place of the same row of an earlier catalogue.
    #[serde(default)]
    pub(super) replace: bool,
}

/// A diagnostic counter.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CounterRow {
    /// Sub-function of code 8 that returns it.
    pub sub: u16,
    /// Stable name.
    pub slug: String,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// What it counts and what a high value means.
    pub help: Text,
    /// Takes the place of the same row of an earlier catalogue.
    #[serde(default)]
    pub(super) replace: bool,
}

/// A bit of a word.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BitRow {
    /// Stable name.
    pub slug: String,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    /// What it means and what to do.
    pub help: Option<Text>,
    /// Takes the place of the same row of an earlier catalogue.
    #[serde(default)]
    pub(super) replace: bool,
}

/// A value of an enumeration in a catalogue.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EnumRow {
    pub(super) en: String,
    pub(super) de: String,
    #[serde(default)]
    pub(super) replace: bool,
}

/// A row of a catalogue that another catalogue may only replace openly.
pub(super) trait CatalogueRow: Clone {
    /// What makes two rows the same, as it is shown in errors; empty if the table's key does.
    fn key(&self) -> Text;
    /// Takes the place of the same row of an earlier catalogue.
    fn replaces(&self) -> bool;
    /// Every text of the row.
    fn texts(&self) -> Vec<&str>;
}

macro_rules! catalogue_rows {
    ($($row:ident, |$this:ident| $key:expr, $texts:expr;)*) => {$(
        impl CatalogueRow for $row {
            fn key(&self) -> Text {
                let $this = self;
                $key
            }
            fn replaces(&self) -> bool {
                self.replace
            }
            fn texts(&self) -> Vec<&str> {
                let $this = self;
                let mut texts = vec![$this.en.as_str(), $this.de.as_str()];
                texts.extend($texts);
                texts
            }
        }
    )*};
}
catalogue_rows! {
    EnumRow, |_row| Text::default(), None::<&str>;
    DriveState, |row| both!("state {slug}", "Zustand {slug}", slug = row.slug), [row.slug.as_str()];
    FaultGroup, |row| both!("fault group 0x{high:02X}", "Störungsgruppe 0x{high:02X}", high = row.high), None::<&str>;
    FaultRow, |row| both!("fault 0x{code:04X}", "Störung 0x{code:04X}", code = row.code),
        row.cause.iter().chain(&row.remedy).flat_map(|text| text.both()).chain([row.key.as_str()]).collect::<Vec<_>>();
    ErrorRow, |row| both!("error {code}", "Fehler {code}", code = row.code), row.hint.both().into_iter().chain([row.slug.as_str()]);
    CounterRow, |row| both!("counter 0x{sub:02X}", "Zähler 0x{sub:02X}", sub = row.sub), row.help.both().into_iter().chain([row.slug.as_str()]);
    BitRow, |row| { let _ = row; Text::default() },
        row.help.iter().flat_map(|help| help.both()).chain([row.slug.as_str()]).collect::<Vec<_>>();
}

macro_rules! two_languages {
    ($($row:ident),*) => {$(
        impl $row {
            /// The name in `lang`.
            pub fn name(&self, lang: Lang) -> &str {
                match lang {
                    Lang::En => &self.en,
                    Lang::De => &self.de,
                }
            }

            /// The name in both languages.
            pub fn text(&self) -> Text {
                Text { en: self.en.clone().into(), de: self.de.clone().into() }
            }
        }
    )*};
}
two_languages!(DriveState, FaultGroup, FaultRow, ErrorRow, CounterRow, BitRow);
