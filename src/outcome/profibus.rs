//! What `profibus` says.

use super::Field;
use crate::text::Text;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of `profibus module`: a module of an SJ2-PB in Basic mode.
#[derive(Debug, Serialize, JsonSchema)]
pub struct BasicModule {
    /// What was given.
    pub input: String,
    /// Series that the module expects: `l200`, `sj200`, `x200`.
    pub drive: String,
    /// Its parameter, if it carries one that the catalogue knows.
    pub param: Option<u32>,
    /// Its bytes in Set_Prm, behind what the GSD puts in front.
    pub parameters: String,
    /// Its byte in Chk_Cfg; null where the manual leaves it open.
    pub cfg: Option<String>,
    /// In words.
    pub meaning: Text,
    /// Field by field.
    pub fields: Vec<Field>,
    /// What the manual leaves open.
    pub notes: Vec<Text>,
}
