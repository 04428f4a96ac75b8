//! The settings of a drive by number and data set, whatever file or drive they come from.

use super::file::At;
use super::signature::Signature;
use crate::profile::param::{Param, Type};
use std::collections::BTreeMap;

/// A value for one parameter.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Setting {
    /// The parameter, as the catalogue describes it.
    pub param: Param,
    /// Data set, 0-4: 0 is all four, or the only one.
    pub set: u8,
    /// The value without its decimal point.
    pub raw: i64,
    /// Its type, where a catalogue or the file tells it.
    pub kind: Option<Type>,
    /// Where it comes from.
    pub at: At,
}

/// Settings of one drive. Data set 0 of a parameter stands for all four; what one set says goes before it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    by_place: BTreeMap<(u32, u8), Setting>,
}

impl FromIterator<Setting> for Settings {
    fn from_iter<I: IntoIterator<Item = Setting>>(settings: I) -> Self {
        Settings { by_place: settings.into_iter().map(|it| ((it.param.id, it.set), it)).collect() }
    }
}

impl Settings {
    /// Adds a setting; returns what stood in its place.
    pub fn insert(&mut self, setting: Setting) -> Option<Setting> {
        self.by_place.insert((setting.param.id, setting.set), setting)
    }

    /// What is said of a parameter in a data set: of this set, or of all four.
    pub fn get(&self, param: u32, set: u8) -> Option<&Setting> {
        self.by_place.get(&(param, set)).or_else(|| self.by_place.get(&(param, 0)))
    }

    /// What is said of exactly this place.
    pub fn exactly(&self, param: u32, set: u8) -> Option<&Setting> {
        self.by_place.get(&(param, set))
    }

    /// Every setting, by number and data set.
    pub fn iter(&self) -> impl Iterator<Item = &Setting> {
        self.by_place.values()
    }

    /// The parameters that something is said of, by number.
    pub fn params(&self) -> impl Iterator<Item = &Param> {
        let mut last = None;
        self.by_place.values().filter_map(move |setting| {
            let is_next = last.replace(setting.param.id) != Some(setting.param.id);
            is_next.then_some(&setting.param)
        })
    }

    /// How many values.
    pub fn len(&self) -> usize {
        self.by_place.len()
    }

    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        self.by_place.is_empty()
    }

    /// Keeps what `keep` says yes to.
    pub fn retain(&mut self, keep: impl Fn(&Setting) -> bool) {
        self.by_place.retain(|_, setting| keep(setting));
    }

    /// Lays later settings over these. What is later said of all four data sets goes also before what was earlier said of
    /// one.
    pub fn lay_over(&mut self, later: Settings) {
        for &(param, set) in later.by_place.keys() {
            if set == 0 {
                self.by_place.retain(|place, _| place.0 != param);
            }
        }
        self.by_place.extend(later.by_place);
    }

    /// In the shortest form: of four data sets with one value, data set 0; where sets differ, each by itself.
    #[must_use]
    pub fn shortest(&self) -> Settings {
        let mut short = Settings::default();
        for param in self.params() {
            let four: Vec<&Setting> = (1..=4).filter_map(|set| self.get(param.id, set)).collect();
            let own = (1..=4).any(|set| self.exactly(param.id, set).is_some());
            let values = || four.iter().map(|setting| setting.raw);
            let alike = four.len() == 4 && values().all(|raw| Some(raw) == values().next());
            if !own || alike {
                let one = four.first().copied();
                short.by_place.extend(one.map(|one| ((param.id, 0), Setting { set: 0, ..one.clone() })));
                continue;
            }
            for set in 1..=4 {
                let one = self.get(param.id, set);
                short.by_place.extend(one.map(|one| ((param.id, set), Setting { set, ..one.clone() })));
            }
        }
        short
    }

    /// The signature of these settings of a drive of this family.
    pub fn signature(&self, family: &str) -> Signature {
        Signature::over(family, self.shortest().by_place.iter().map(|(&(param, set), one)| (param, set, one.raw)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(rows: &[(u32, u8, i64)]) -> Settings {
        let mut settings = Settings::default();
        for &(id, set, raw) in rows {
            let at = At { path: "x".into(), line: 1, column: 1 };
            settings.insert(Setting { param: Param::unknown(id), set, raw, kind: None, at });
        }
        settings
    }

    fn rows(settings: &Settings) -> Vec<(u32, u8, i64)> {
        settings.iter().map(|one| (one.param.id, one.set, one.raw)).collect()
    }

    #[test]
    fn later_files_lie_over_earlier_ones() {
        let mut base = settings(&[(372, 0, 1), (480, 1, 1), (480, 2, 2), (500, 0, 9)]);
        base.lay_over(settings(&[(372, 2, 7), (480, 0, 5)]));
        assert_eq!(rows(&base), [(372, 0, 1), (372, 2, 7), (480, 0, 5), (500, 0, 9)]);
        assert_eq!(base.get(372, 1).map(|one| one.raw), Some(1));
        assert_eq!(base.get(372, 2).map(|one| one.raw), Some(7));
    }

    #[test]
    fn the_signature_knows_only_what_is_set() {
        let same = [
            settings(&[(372, 0, 1), (480, 0, 5)]),
            settings(&[(480, 4, 5), (480, 2, 5), (480, 1, 5), (480, 3, 5), (372, 0, 1)]),
            settings(&[(480, 0, 7), (480, 2, 5), (480, 1, 5), (480, 3, 5), (480, 4, 5), (372, 0, 1)]),
        ];
        for one in &same {
            assert_eq!(one.signature("acu"), same[0].signature("acu"));
            assert_eq!(rows(&one.shortest()), [(372, 0, 1), (480, 0, 5)]);
        }
        assert_ne!(settings(&[(372, 0, 1), (480, 0, 6)]).signature("acu"), same[0].signature("acu"));
        let differing = settings(&[(480, 0, 5), (480, 3, 6)]);
        assert_eq!(rows(&differing.shortest()), [(480, 1, 5), (480, 2, 5), (480, 3, 6), (480, 4, 5)]);
        assert_eq!(rows(&settings(&[(480, 3, 6)]).shortest()), [(480, 3, 6)]);
    }
}
