//! Which settings of a file go into a drive: by groups, numbers, data sets; the bus only if somebody asks for it.

use crate::drive::describe;
use crate::drive::job::Step;
use crate::failure::{Class, Failure};
use crate::outcome::{NotLoaded, NotLoadedWhy};
use crate::profile::paramfile::{Setting, Settings};
use crate::profile::{Family, Goes, Param, Selector, Sets, Store};
use crate::text::both;
use std::collections::BTreeSet;
use std::rc::Rc;

/// What somebody wants of a file.
#[derive(Clone, Debug)]
pub struct Choice {
    /// Groups and parameters; empty for everything but the bus.
    pub only: Vec<String>,
    /// Groups and parameters that are left out.
    pub except: Vec<String>,
    /// Data sets, 0 for what exists once; empty for all.
    pub sets: Vec<u8>,
    /// Where the values go.
    pub store: Store,
    /// The families of all drives that are meant: what one of them knows is no mistake of the others.
    pub families: Vec<Rc<Family>>,
}

/// The code of a file of which nothing is meant.
pub const NO_VALUES: &str = "data.no_values";

/// Everything readable: naming it asks for nothing in particular.
const EVERYTHING: &str = "all";

impl Choice {
    /// Everything that a file may bring.
    pub fn everything() -> Self {
        Choice { only: Vec::new(), except: Vec::new(), sets: Vec::new(), store: Store::Eeprom, families: Vec::new() }
    }

    /// The values to write, in the order in which they depend on each other, and what is left out by itself.
    ///
    /// # Errors
    /// A word names neither a group nor a parameter of the family, or the family has no such memory.
    pub fn steps(&self, settings: &Settings, family: &Family) -> Result<(Vec<Step>, Vec<NotLoaded>), Failure> {
        if self.store == Store::Ram && !family.link.route.has_data_sets() {
            let text = both!(
                "no source tells how values go into the RAM of the family {drive} only",
                "keine Quelle sagt, wie Werte nur in das RAM der Familie {drive} gelangen",
                drive = family.drive
            );
            return Err(
                Failure::new(Class::Data, "data.no_ram", text).hint(both!("leave --ram out", "--ram weglassen"))
            );
        }
        let is_meant = self.meant(family)?;
        let particular: Vec<String> = self.only.iter().filter(|word| !is_everything(word)).cloned().collect();
        let asked = self.named(&particular, family)?;
        let (mut steps, mut left_out) = (Vec::new(), Vec::new());
        for setting in settings.iter().filter(|setting| is_meant(setting.param.id)) {
            let id = setting.param.id;
            match family.files.goes(&setting.param) {
                Goes::Always => steps.extend(self.places(setting, settings)),
                Goes::IfAsked if asked.contains(&id) => steps.extend(self.places(setting, settings)),
                goes => left_out.extend(why(goes).map(|why| describe::left_out(&setting.param, setting.set, why))),
            }
        }
        steps.sort_by_key(|step| {
            let rank = family.files.rank(&step.param, step.set);
            (rank.0, !family.files.frees(&step.param, step.raw), rank)
        });
        Ok((steps, left_out))
    }

    /// Keeps of a file what is picked, as it is compared: also settings of a bus.
    ///
    /// # Errors
    /// A word names neither a group nor a parameter of the family, or nothing is left.
    pub fn pick(&self, settings: &mut Settings, family: &Family) -> Result<(), Failure> {
        let is_meant = self.meant(family)?;
        let mut picked = Settings::default();
        for setting in settings.iter().filter(|setting| is_meant(setting.param.id)) {
            match self.sets.is_empty() {
                true => drop(picked.insert(setting.clone())),
                false => self.places(setting, settings).into_iter().for_each(|step| {
                    picked.insert(Setting { set: step.set, ..setting.clone() });
                }),
            }
        }
        if picked.is_empty() {
            let message = both!(
                "there is nothing to compare: of the {count} values of the file none is meant",
                "es gibt nichts zu vergleichen: von den {count} Werten der Datei ist keiner gemeint",
                count = settings.len()
            );
            return Err(Failure::new(Class::Data, NO_VALUES, message).hint(both!(
                "--only, --except and --sets pick what is compared",
                "--only, --except und --sets wählen aus, was verglichen wird"
            )));
        }
        *settings = picked;
        Ok(())
    }

    /// Tells by its number whether a setting is meant. Everything is also what no catalogue knows (`--discover` saves it).
    fn meant(&self, family: &Family) -> Result<impl Fn(u32) -> bool, Failure> {
        let (only, except) = (self.named(&self.only, family)?, self.named(&self.except, family)?);
        let is_all = |words: &[String]| words.iter().any(|word| is_everything(word));
        let (any, none) = (self.only.is_empty() || is_all(&self.only), is_all(&self.except));
        Ok(move |id| (any || only.contains(&id)) && !none && !except.contains(&id))
    }

    /// The numbers that words name in a family; none where only another one knows them.
    fn named(&self, words: &[String], family: &Family) -> Result<BTreeSet<u32>, Failure> {
        let mut named = BTreeSet::new();
        for word in words {
            let is_known = || self.families.iter().any(|other| numbers(word, other).is_some());
            match numbers(word, family) {
                None if !is_known() => return Err(unknown(word, family)),
                found => named.extend(found.unwrap_or_default()),
            }
        }
        Ok(named)
    }

    /// The places of a setting: of one for all four data sets each that has no value of its own.
    fn places(&self, setting: &Setting, settings: &Settings) -> Vec<Step> {
        let Setting { param, set, raw, kind, at } = setting;
        let own = |set: u8| settings.exactly(param.id, set).is_some();
        let sets: Vec<u8> = match *set {
            0 if in_sets(param) || (1..=4).any(own) => (1..=4).filter(|set| !own(*set)).collect(),
            set => vec![set],
        };
        let wanted = sets.into_iter().filter(|set| self.sets.is_empty() || self.sets.contains(set));
        let step = |set| {
            let (param, at) = (param.clone(), Some(at.clone()));
            Step { param, set: self.store.wire(set), raw: *raw, kind: *kind, at }
        };
        wanted.map(step).collect()
    }
}

/// Whether it exists in four data sets, as far as a source tells it.
pub(super) fn in_sets(param: &Param) -> bool {
    param.sets == Some(Sets::Four)
}

/// The numbers that a word names in a family: a group with or without `@`, a parameter, a range.
fn numbers(word: &str, family: &Family) -> Option<BTreeSet<u32>> {
    if let Some(group) = family.group(&bare(word).to_ascii_lowercase()) {
        return Some(group.into_iter().collect());
    }
    let selector: Selector = word.parse().ok()?;
    // The first letters of a name may be a group in the words of the user: `rampen` are more than P.434.
    let meant = Some(selector).filter(|selector| selector.is_whole(family) && !selector.names_sets());
    let found = meant?.resolve(family).ok()?;
    Some(found.into_iter().map(|one| one.param.id).collect())
}

fn is_everything(word: &str) -> bool {
    bare(word).eq_ignore_ascii_case(EVERYTHING)
}

fn bare(word: &str) -> &str {
    word.strip_prefix('@').unwrap_or(word)
}

fn unknown(word: &str, family: &Family) -> Failure {
    let known = family.group_names().collect::<Vec<_>>().join(", ");
    let message = both!(
        "'{word}' names no group and no parameter of the family {drive}",
        "'{word}' nennt keine Gruppe und keinen Parameter der Familie {drive}",
        drive = family.drive
    );
    Failure::new(Class::Usage, "usage.scope", message).hint(both!(
        "groups: {known}; or parameters without a data set, such as 372 or 480-483",
        "Gruppen: {known}; oder Parameter ohne Datensatz, etwa 372 oder 480-483"
    ))
}

fn why(goes: Goes) -> Option<NotLoadedWhy> {
    Some(match goes {
        Goes::Always => return None,
        Goes::IfAsked => NotLoadedWhy::NotAskedFor,
        Goes::Told => NotLoadedWhy::ReadOnly,
        Goes::Commands => NotLoadedWhy::Command,
        Goes::Restarts => NotLoadedWhy::Restarts,
        Goes::Text => NotLoadedWhy::Text,
    })
}
