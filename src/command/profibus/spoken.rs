//! How a slave is to be led, as it was typed: the mode, and the ramps of the Basic block.

use super::given::SlaveArgs;
use crate::args::Settings;
use crate::drive::profibus::Ramps;
use crate::failure::{Class, Failure};
use crate::profile::value::parse_decimal;
use crate::text::{Text, Wrong, both};
use std::str::FromStr;

/// A mode as it was typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spoken {
    /// The Basic block.
    Basic,
    /// PPO1.
    Profidrive,
}

impl FromStr for Spoken {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        match text {
            "basic" => Ok(Spoken::Basic),
            "profidrive" => Ok(Spoken::Profidrive),
            _ => Err(Wrong(both!(
                "expected basic or profidrive, got '{text}'",
                "erwartet: basic oder profidrive; angegeben: '{text}'"
            ))),
        }
    }
}

/// What was typed of it.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::command) struct Choice {
    pub(in crate::command) spoken: Option<Spoken>,
    /// Ramps of the Basic block.
    pub(in crate::command) ramps: Option<Ramps>,
}

/// Ramps as they were typed: `F002=5s`, `F003=2,5s`.
pub(in crate::command) fn ramps(typed: &[String]) -> Result<Option<Ramps>, Failure> {
    let mut ramps = Ramps::default();
    for text in typed {
        let (name, value) = text.split_once('=').unwrap_or((text, ""));
        let tenths = parse_decimal(value.trim_end_matches('s').trim(), 1).ok().and_then(|raw| u16::try_from(raw).ok());
        let tenths = tenths.filter(|tenths| (1..=LONGEST).contains(tenths));
        match (name.to_ascii_uppercase().as_str(), tenths) {
            ("F002", Some(tenths)) => ramps.up = tenths,
            ("F003", Some(tenths)) => ramps.down = tenths,
            _ => {
                return Err(usage(both!(
                    "expected F002=5s (acceleration) or F003=5s (deceleration), 0.1 to 3000 s, got '{text}'",
                    "erwartet: F002=5s (Hochlauf) oder F003=5s (Runterlauf), 0,1 bis 3000 s; angegeben: '{text}'"
                )));
            }
        }
    }
    Ok((!typed.is_empty()).then_some(ramps))
}

/// The longest ramp of the Basic block, 0.1 s (SJ2-PB manual 3.2.2).
const LONGEST: u16 = 30_000;

/// The option of verbs that have no other `--mode`.
#[derive(Clone, Debug, Default, clap::Args)]
pub struct ModeArg {
    /// basic or profidrive [default: as Get_Cfg tells]
    ///
    /// How an SJ2-PB is led: the Basic block, with --drive l200, sj200 or x200, or PPO1.
    #[arg(long, value_name = "MODE", hide_short_help = true, help_heading = "PROFIBUS")]
    pub mode: Option<Spoken>,
}

impl ModeArg {
    /// Whether a slave is meant, by these options and those of how it is taken. Fails if only the options say so.
    pub(in crate::command) fn is_meant(&self, slave: &SlaveArgs, settings: &Settings) -> Result<bool, Failure> {
        let is_profibus = slave.is_meant(settings)?;
        if is_profibus || self.mode.is_none() {
            return Ok(is_profibus);
        }
        let message = both!("--mode means something on PROFIBUS alone", "--mode bedeutet nur am PROFIBUS etwas");
        Err(Failure::new(Class::Usage, "usage.profibus", message)
            .hint(both!("add --protocol dp, or leave it out", "--protocol dp angeben oder es weglassen")))
    }

    /// What was typed.
    pub(in crate::command) fn choice(&self) -> Choice {
        Choice { spoken: self.mode, ramps: None }
    }
}

pub(super) fn usage(message: Text) -> Failure {
    Failure::new(Class::Usage, "usage.setpoint", message)
}
