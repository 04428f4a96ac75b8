//! Guided work as data: the steps of a procedure, each with its warning and its source (`data/procedures/*.toml`). What a step
//! does is an [`Act`]; the code for it is `command::procedure`.

use crate::text::Text;
use serde::Deserialize;

/// What ships, in the order in which it is listed.
const SHIPPED: [&str; 4] = [
    include_str!("data/procedures/first-contact.toml"),
    include_str!("data/procedures/commission.toml"),
    include_str!("data/procedures/resolver-offset.toml"),
    include_str!("data/procedures/analog-input.toml"),
];

/// Guided work.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Procedure {
    /// How it is typed.
    pub slug: String,
    /// What it is for.
    pub title: Text,
    /// The drives for which a manual describes it.
    pub drives: Vec<String>,
    /// What must be known from elsewhere, such as a nameplate.
    #[serde(default, rename = "value")]
    pub values: Vec<Wanted>,
    /// What is done, in order.
    #[serde(rename = "step")]
    pub steps: Vec<Step>,
}

/// A value that a procedure is given.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Wanted {
    /// How it is typed: `watchdog`.
    pub key: String,
    /// What it is.
    pub what: Text,
    /// The procedure does without it.
    #[serde(default)]
    pub optional: bool,
}

/// A step.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Step {
    /// Its name in a record; the same for steps that stand in for each other on different drives.
    pub slug: String,
    /// What this program does.
    pub act: Act,
    /// Only for these drives; for all of the procedure if empty.
    #[serde(default)]
    pub drives: Vec<String>,
    /// In a few words.
    pub title: Text,
    /// What is to be done, or is done.
    pub does: Text,
    /// What the manual warns of, in our words.
    #[serde(default)]
    pub warning: Option<Text>,
    /// Where the manual says so.
    pub source: String,
}

/// What is done in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Act {
    /// Somebody does or sees it, and says so.
    Confirm,
    /// The drive is asked who it is, and how its line is set.
    Identify,
    /// The line is measured.
    Line,
    /// The drive's own watchdog is looked at, and set if a time was given.
    Watchdog,
    /// The nameplate of a motor is held against itself.
    Nameplate,
    /// It goes into the drive.
    Store,
    /// The motor turns, and somebody says whether that was the right way.
    Direction,
    /// It runs up and down, and both are measured.
    Ramp,
    /// It is stopped by a quick stop.
    Stop,
    /// Nobody talks to the drive until its watchdog has tripped it.
    Silence,
    /// Its fault is acknowledged.
    Reset,
    /// The data of the motor are shown, and somebody says that they are right.
    Motor,
    /// The pole pairs of the resolver, and that it tells the speed, go into the drive.
    Resolver,
    /// Somebody turns the shaft by hand, and the resolver must show which way.
    Hand,
    /// The offset of the resolver is sought with the shaft turning.
    Offset,
    /// The analog input is adjusted at 0 V.
    Zero,
    /// The analog input is adjusted at 10 V.
    Full,
}

impl Procedure {
    /// Every procedure.
    pub fn all() -> Vec<Procedure> {
        SHIPPED.iter().filter_map(|text| toml::from_str(text).ok()).collect()
    }

    /// Its steps for a drive.
    pub fn steps_of(&self, drive: &str) -> Vec<&Step> {
        let is_meant = |step: &&Step| step.drives.is_empty() || step.drives.iter().any(|known| known == drive);
        self.steps.iter().filter(is_meant).collect()
    }
}

impl Act {
    /// Whether it can turn a shaft.
    pub fn turns(self) -> bool {
        matches!(self, Act::Direction | Act::Ramp | Act::Stop | Act::Silence | Act::Reset | Act::Offset)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;
    use std::collections::BTreeSet;

    #[test]
    fn what_ships_can_be_read_and_names_what_there_is() {
        let drives = Registry::open(&[]).unwrap().drives().into_iter().map(|drive| drive.id.clone()).collect();
        for text in SHIPPED {
            let procedure: Procedure = toml::from_str(text).unwrap();
            let named: BTreeSet<_> =
                procedure.steps.iter().flat_map(|step| &step.drives).chain(&procedure.drives).collect();
            assert!(named.into_iter().all(|drive| BTreeSet::contains(&drives, drive)), "{}", procedure.slug);
            for drive in &procedure.drives {
                let steps = procedure.steps_of(drive);
                let slugs: BTreeSet<_> = steps.iter().map(|step| &step.slug).collect();
                assert_eq!(slugs.len(), steps.len(), "{drive}: a name of a step stands for one of them");
            }
            for step in &procedure.steps {
                let warning = step.warning.clone().unwrap_or_else(|| Text::name("x"));
                let texts = [&step.title, &step.does, &warning];
                assert!(texts.iter().all(|text| !text.en.is_empty() && !text.de.is_empty()), "{}", step.slug);
                assert!(step.source.contains("manual"), "{}: {}", step.slug, step.source);
            }
        }
        assert_eq!(Procedure::all().len(), SHIPPED.len());
    }
}
