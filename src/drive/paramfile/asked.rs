//! Which parameters of a drive belong into a file, and in which data sets they are asked.

use crate::failure::{Class, Failure};
use crate::profile::paramfile::{At, NotHeld, Scope, Setting, Settings};
use crate::profile::{Access, DataSets, Family, Param, Route, Sets, Store, Type};
use crate::text::both;

/// Highest number of a parameter (CM-485 manual 6.4.1).
const LAST_NUMBER: u32 = 1599;

/// A parameter that is asked, and in which data sets.
#[derive(Clone, Debug)]
pub struct Asking {
    /// The parameter.
    pub param: Param,
    /// Data sets, one question each; `Unnamed` asks for all four at once.
    pub sets: Vec<DataSets>,
}

/// What a file is to hold, and what it cannot.
#[derive(Clone, Debug, Default)]
pub struct Wanted {
    /// What is asked.
    pub asked: Vec<Asking>,
    /// Numbers that are not asked, and why.
    pub left: Vec<(u32, NotHeld)>,
}

impl Asking {
    /// In all data sets at once: where they are equal that is one question (CM-485 manual 7).
    fn whole(param: Param) -> Self {
        Asking { param, sets: vec![DataSets::Unnamed] }
    }
}

/// Why a file does not hold a parameter; `None` if it is a setting.
pub fn reason(param: &Param) -> Option<NotHeld> {
    match param {
        Param { kind: Some(Type::String), .. } => Some(NotHeld::NoNumber),
        Param { access: Access::Read, .. } => Some(NotHeld::ActualValue),
        Param { access: Access::Write, .. } => Some(NotHeld::WriteOnly),
        Param { volatile: true, .. } => Some(NotHeld::RamOnly),
        _ => None,
    }
}

impl Wanted {
    /// What a file of this scope holds of a drive of this family.
    ///
    /// # Errors
    /// No source tells which numbers the family could have besides.
    pub fn of(scope: Scope, family: &Family) -> Result<Self, Failure> {
        let mut wanted = Wanted::default();
        if scope == Scope::Discovered {
            if family.link.route != Route::Active {
                return Err(no_numbers(family));
            }
            for number in 0..=LAST_NUMBER {
                wanted.add(family.param_or_unknown(number));
            }
            return Ok(wanted);
        }
        for param in family.params.values() {
            match scope {
                Scope::Changed if reason(param).is_none() && default(param).is_none() => {
                    wanted.left.push((param.id, NotHeld::NoKnownFactorySetting));
                }
                _ => wanted.add(param.clone()),
            }
        }
        Ok(wanted)
    }

    fn add(&mut self, param: Param) {
        match (reason(&param), param.elements) {
            (Some(reason), _) => self.left.push((param.id, reason)),
            (None, None) => self.asked.push(Asking::whole(param)),
            // An array has no value as a whole.
            (None, Some(count)) => {
                self.asked.extend((1..=count).map(|element| Asking::whole(param.of_element(element))));
            }
        }
    }
}

fn no_numbers(family: &Family) -> Failure {
    let message = both!(
        "no source tells which numbers the family {drive} may have beside those of its catalogue",
        "keine Quelle nennt, welche Nummern die Familie {drive} außer denen ihres Katalogs haben kann",
        drive = family.drive
    );
    Failure::new(Class::Data, "data.no_numbers", message).hint(both!(
        "without --discover every setting of the catalogue is saved; `read 7000-7010` tries numbers",
        "ohne --discover wird jede Einstellung des Katalogs gesichert; `read 7000-7010` probiert Nummern"
    ))
}

/// The factory setting of a parameter, where a source prints it.
fn default(param: &Param) -> Option<i64> {
    param.default.filter(|_| !param.unconfirmed.iter().any(|field| field == "default" || field == "row"))
}

/// The factory settings that are known.
pub fn factory(family: &Family) -> Settings {
    let mut settings = Settings::default();
    for param in family.params.values().filter(|param| reason(param).is_none()) {
        if let Some(raw) = default(param) {
            let at = At { path: "factory".into(), line: 0, column: 0 };
            settings.insert(Setting { param: param.clone(), set: 0, raw, kind: param.kind, at });
        }
    }
    settings
}

/// What is asked to hold a drive against these settings: where they name all data sets alike, all at once; else each that they
/// name.
pub fn of_file(settings: &Settings, family: &Family) -> Vec<Asking> {
    let short = settings.shortest();
    let asking = |param: &Param| {
        let named: Vec<u8> = (0..=4).filter(|&set| short.exactly(param.id, set).is_some()).collect();
        match named.as_slice() {
            [0] | [] => Asking::whole(param.clone()),
            _ if !family.link.route.has_data_sets() => Asking::whole(param.clone()),
            sets => {
                let sets = sets.iter().map(|&set| DataSets::One(set, Store::Eeprom)).collect();
                Asking { param: param.clone(), sets }
            }
        }
    };
    short.params().map(asking).collect()
}

/// What is asked to hold one data set against these settings: what they say of it, of parameters that have sets.
pub fn of_set(settings: &Settings, set: u8, store: Store) -> Vec<Asking> {
    let in_sets = settings.params().filter(|param| {
        let is_named = settings.exactly(param.id, set).is_some();
        is_named || (param.sets == Some(Sets::Four) && settings.get(param.id, set).is_some())
    });
    in_sets.map(|param| Asking { param: param.clone(), sets: vec![DataSets::One(set, store)] }).collect()
}

/// What these settings say of one data set, as what is said of the data set `of`.
pub fn held(settings: &Settings, set: u8, of: u8) -> Settings {
    let mut one = Settings::default();
    for param in settings.params() {
        if let Some(setting) = settings.get(param.id, set) {
            one.insert(Setting { set: of, ..setting.clone() });
        }
    }
    one
}
