//! What a parameter file of a family holds, and in which order it goes into a drive: the `[files]` table of a catalogue.
//!
//! What a row says already is not said again here: what cannot be read or written, what lives in RAM only, what restarts a
//! drive is never written from a file; what cuts the line is left out until somebody asks for it.

use super::param::{Effective, HazardKind, Param, Type};
use serde::Deserialize;

/// What is particular about parameters when many of them are written.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct FileRules {
    /// Written before everything else, in this order: what stands behind may depend on it.
    pub first: Vec<u32>,
    /// Written behind everything else, in this order: what can start a shaft finds everything in its place.
    pub last: Vec<u32>,
    /// Left out until somebody asks for it.
    pub asked: Vec<u32>,
    /// Known not to be writable while the drive runs. What stands in no list is not known to be writable either.
    pub standstill: Vec<u32>,
    /// What takes a place that others may want, and gives it free by its factory setting: that goes first, there and back.
    pub frees: Vec<u32>,
    /// What the drive changes by itself behind a write.
    pub alters: Vec<Alters>,
}

/// A parameter whose write changes others.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Alters {
    /// The parameter that is written.
    pub by: u32,
    /// Those that may be another value then.
    pub what: Vec<u32>,
}

/// Whether a parameter goes from a file into a drive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Goes {
    /// It does.
    Always,
    /// Only if somebody asks for it: settings of a bus, what hangs on an index.
    IfAsked,
    /// It never does: what the drive tells.
    Told,
    /// It never does: commands and setpoints, which live in RAM only.
    Commands,
    /// It never does: it restarts the drive.
    Restarts,
    /// It never does: texts have no telegram.
    Text,
}

impl FileRules {
    /// Whether this parameter goes from a file into a drive.
    pub fn goes(&self, param: &Param) -> Goes {
        let is_of_line = param.hazard == Some(HazardKind::Line) || self.asked.contains(&param.id);
        match param {
            Param { kind: Some(Type::String), .. } => Goes::Text,
            Param { hazard: Some(HazardKind::Reset), .. } => Goes::Restarts,
            param if !param.access.writes() => Goes::Told,
            param if param.volatile || !param.access.reads() => Goes::Commands,
            _ if is_of_line => Goes::IfAsked,
            _ => Goes::Always,
        }
    }

    /// Where a parameter stands in the order of writing: first those that others depend on, then what exists once, then what
    /// exists in data sets, last what can start a shaft; what restarts the line behind everything.
    pub fn rank(&self, param: &Param, set: u8) -> (u8, usize, u32, u8) {
        let among = |list: &[u32]| list.iter().position(|id| *id == param.id);
        let in_sets = u8::from(!set.is_multiple_of(5));
        match (among(&self.first), among(&self.last)) {
            _ if param.hazard == Some(HazardKind::Line) && param.effective == Effective::AtOnce => {
                (4, 0, param.id, set)
            }
            (Some(place), _) => (0, place, param.id, set),
            (_, Some(place)) => (3, place, param.id, set),
            _ => (1 + in_sets, 0, param.id, set),
        }
    }

    /// Whether this value gives a place free that others may want.
    pub fn frees(&self, param: &Param, raw: i64) -> bool {
        param.default == Some(raw) && self.frees.contains(&param.id)
    }

    /// Whether it can start a shaft.
    pub fn may_start(&self, param: &Param) -> bool {
        self.last.contains(&param.id)
    }

    /// What a write of this parameter may change besides.
    pub fn altered_by(&self, id: u32) -> impl Iterator<Item = u32> {
        self.alters.iter().filter(move |row| row.by == id).flat_map(|row| &row.what).copied()
    }

    /// Every number that these rules name.
    pub(super) fn numbers(&self) -> impl Iterator<Item = u32> {
        let lists = [&self.first, &self.last, &self.asked, &self.standstill, &self.frees].into_iter().flatten();
        lists.chain(self.alters.iter().flat_map(|row| row.what.iter().chain([&row.by]))).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::{Access, Registry};

    fn of(drive: &str, id: u32) -> Goes {
        let family = Registry::open(&[]).unwrap().family(drive).unwrap();
        family.files.goes(family.param(id).unwrap())
    }

    #[test]
    fn commands_actual_values_and_restarts_never_come_from_a_file_and_bus_settings_only_if_asked_for() {
        for drive in ["act", "acu"] {
            let goes = [372, 30, 412, 10, 1376, 413, 900, 34, 410, 484, 211, 411, 11, 17].map(|id| of(drive, id));
            use Goes::{Always, Commands, IfAsked, Restarts, Told};
            let expected = [Always, Always, Always, IfAsked, IfAsked, IfAsked, IfAsked, Restarts, Commands, Commands];
            assert_eq!((&goes[..10], &goes[10..]), (&expected[..], &[Told, Told, Told, Goes::Text][..]), "{drive}");
        }
        let servo = [1556, 9736, 5638, 5646, 5644, 6914, 6940, 7700].map(|id| of("lxm05", id));
        use Goes::{Always, Commands, IfAsked, Told};
        assert_eq!(servo, [Always, Always, IfAsked, IfAsked, Commands, Commands, Commands, Told]);
    }

    #[test]
    fn the_configuration_goes_before_what_it_changes_and_what_starts_a_shaft_behind_everything() {
        let family = Registry::open(&[]).unwrap().family("acu").unwrap();
        let mut order =
            [(412, 1), (1376, 0), (480, 1), (414, 0), (68, 0), (392, 2), (372, 4), (424, 1), (400, 0), (30, 0)];
        order.sort_by_key(|&(id, set)| family.files.rank(family.param(id).unwrap(), set));
        let ids = order.map(|(id, _)| id);
        assert_eq!(ids, [30, 400, 372, 392, 424, 480, 68, 412, 414, 1376]);
        assert_eq!(family.files.altered_by(30).collect::<Vec<_>>(), [392]);
    }

    #[test]
    fn everything_that_a_file_can_bring_belongs_to_a_group_so_that_it_can_be_named() {
        for family in Registry::open(&[]).unwrap().families() {
            let groups = family.group_names().filter(|name| !["all", "actual"].contains(name));
            let grouped: Vec<u32> = groups.flat_map(|name| family.group(name).unwrap()).collect();
            let brought = family.params.values().filter(|param| family.files.goes(param) <= Goes::IfAsked);
            let lost: Vec<u32> = brought.map(|param| param.id).filter(|id| !grouped.contains(id)).collect();
            assert!(lost.is_empty(), "{}: {lost:?}", family.drive);
            assert!(family.files.standstill.iter().all(|id| family.param(*id).unwrap().access == Access::ReadWrite));
        }
    }
}
