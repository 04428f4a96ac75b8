//! Which values of parameter files are meant, as it is typed.

use crate::command::again::word;
use crate::drive::transaction::Choice;
use crate::profile::Store;
use crate::text::{Wrong, both};
use clap::Args as ClapArgs;
use std::ops::RangeInclusive;
use std::str::FromStr;

/// Which values of parameter files are written.
#[derive(Clone, Debug, Default, ClapArgs)]
pub(in crate::command) struct Scope {
    #[command(flatten)]
    picks: Picks,
    /// Write to RAM only, until power-off
    #[arg(long)]
    ram: bool,
}

impl Scope {
    /// What it picks of a file.
    pub(in crate::command) fn choice(&self) -> Choice {
        let store = if self.ram { Store::Ram } else { Store::Eeprom };
        Choice { store, ..self.picks.choice() }
    }

    /// As it is typed behind a verb: nothing, or ` --only motor --ram`.
    pub(in crate::command) fn typed(&self) -> String {
        self.picks.typed() + if self.ram { " --ram" } else { "" }
    }
}

/// Which values of parameter files are meant.
#[derive(Clone, Debug, Default, ClapArgs)]
pub(in crate::command) struct Picks {
    /// Only these groups and parameters: motor,ramps,480-483
    ///
    /// `params` lists parameters; groups are those of `read @GROUP`. Settings of a bus are written only if they are named here, such as
    /// by `bus`.
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    only: Vec<String>,
    /// Without these groups and parameters
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    except: Vec<String>,
    /// Only these data sets, 0 for what exists once: 1-3
    #[arg(long, value_name = "SETS", value_delimiter = ',')]
    sets: Vec<SetRange>,
}

impl Picks {
    /// What they pick of a file.
    pub(in crate::command) fn choice(&self) -> Choice {
        let sets = self.sets.iter().flat_map(|range| range.0.clone()).collect();
        Choice { only: self.only.clone(), except: self.except.clone(), sets, ..Choice::everything() }
    }

    /// As they are typed behind a verb: nothing, or ` --only motor`.
    pub(in crate::command) fn typed(&self) -> String {
        let Picks { only, except, sets } = self;
        let sets: Vec<String> = sets.iter().map(|range| format!("{}-{}", range.0.start(), range.0.end())).collect();
        let lists = [("only", only), ("except", except), ("sets", &sets)];
        let lists = lists.into_iter().filter(|(_, list)| !list.is_empty());
        lists.map(|(name, list)| format!(" --{name} {}", word(&list.join(",")))).collect()
    }
}

/// Data sets as they are typed: `2`, `1-3`.
#[derive(Clone, Debug)]
struct SetRange(RangeInclusive<u8>);

impl FromStr for SetRange {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        let set = |text: &str| text.trim().parse().ok().filter(|set| *set <= 4);
        let (first, last) = text.split_once('-').unwrap_or((text, text));
        let range = set(first).zip(set(last)).filter(|(first, last)| first <= last);
        range.map(|(first, last)| SetRange(first..=last)).ok_or_else(|| {
            Wrong(both!(
                "'{text}' is no data set: expected 0 to 4, or a range such as 1-3",
                "'{text}' ist kein Datensatz: erwartet 0 bis 4 oder ein Bereich wie 1-3"
            ))
        })
    }
}
