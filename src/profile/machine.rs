//! State machines as data, and the pure planner on them.
//!
//! States come from the status word ([`super::DriveState`]); commands and numbered transitions from the catalogue. The
//! planner finds the commands from the present state to a goal, or says what stands in the way.

use super::row::CatalogueRow;
use crate::text::{Text, both};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// A command of the control word.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Command {
    /// Stable name.
    pub slug: String,
    /// What is written.
    pub word: u16,
    /// Bits that make a word this command.
    pub mask: u16,
    /// Their value.
    pub value: u16,
    /// It acts on a rising edge of its bits: they must be 0 before.
    #[serde(default)]
    pub edge: bool,
    /// English.
    pub en: String,
    /// German.
    pub de: String,
    #[serde(default)]
    replace: bool,
}

impl Command {
    /// What it is called.
    pub fn text(&self) -> Text {
        Text { en: self.en.clone().into(), de: self.de.clone().into() }
    }
}

impl CatalogueRow for Command {
    fn key(&self) -> Text {
        both!("command {slug}", "Befehl {slug}", slug = self.slug)
    }
    fn replaces(&self) -> bool {
        self.replace
    }
    fn texts(&self) -> Vec<&str> {
        vec![&self.slug, &self.en, &self.de]
    }
}

/// A numbered transition from one state to another.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Transition {
    /// Number in the manual: `4`, `4'`.
    pub number: String,
    #[serde(default)]
    pub(super) drives: Option<Vec<String>>,
    /// Slug of the state it leaves; `any` for every one, `power-on` for none.
    pub from: String,
    /// Slug of the state it leads to.
    pub to: String,
    /// Slug of the command that triggers it; the drive goes by itself without one.
    pub command: Option<String>,
    /// What must be so.
    #[serde(default)]
    pub needs: Vec<Need>,
    /// What it waits for.
    pub takes: Option<Takes>,
}

/// What a transition needs besides its command.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Need {
    /// Mains present.
    Voltage,
    /// External enable and start contact.
    Release,
    /// A configuration without positioning.
    NoPositioning,
    /// The lock after a fault has passed.
    Lock,
}

/// What a transition waits for before it is through.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Takes {
    /// Coasting, DC braking or the ramp, as P.392 says.
    #[serde(rename = "transition-5")]
    Transition5,
    /// The quick-stop ramp and the holding time.
    QuickStop,
    /// The lock after a fault.
    Lock,
}

/// What is known of the drive while planning: what is missing. What is not known does not stand in the way.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Facts {
    missing: BTreeSet<Need>,
}

impl Facts {
    /// These are known to be missing.
    pub fn lacking(missing: impl IntoIterator<Item = Need>) -> Self {
        Facts { missing: missing.into_iter().collect() }
    }

    fn grants(&self, need: Need) -> bool {
        !self.missing.contains(&need)
    }
}

/// Why no way leads to the goal.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NoPlan {
    /// A way would be there, but these are missing on it.
    #[error("missing: {0:?}")]
    Missing(Vec<Need>),
    /// No command leads there.
    #[error("no command leads from '{from}' to '{goal}'")]
    Unreachable {
        /// Present state.
        from: String,
        /// Goal.
        goal: String,
    },
}

/// Commands and transitions of a drive.
#[derive(Clone, Debug, Default)]
pub struct StateMachine {
    /// Commands.
    pub commands: Vec<Command>,
    /// Transitions.
    pub transitions: Vec<Transition>,
}

impl StateMachine {
    /// The command with this slug.
    pub fn command(&self, slug: &str) -> Option<&Command> {
        self.commands.iter().find(|command| command.slug == slug)
    }

    /// The transition that a command triggers in a state.
    pub fn transition(&self, from: &str, command: &str) -> Option<&Transition> {
        self.leaving(from).find(|transition| transition.command.as_deref() == Some(command))
    }

    /// The shortest row of transitions from a state to a goal. Ways that the drive goes by itself are part of it, but
    /// never a fault.
    pub fn plan(&self, from: &str, goal: &str, facts: &Facts) -> Result<Vec<&Transition>, NoPlan> {
        if let Some(way) = self.search(from, goal, |transition| transition.needs.iter().all(|&need| facts.grants(need)))
        {
            return Ok(way);
        }
        let Some(way) = self.search(from, goal, |_| true) else {
            return Err(NoPlan::Unreachable { from: from.to_owned(), goal: goal.to_owned() });
        };
        let mut missing: Vec<Need> =
            way.iter().flat_map(|transition| &transition.needs).copied().filter(|&need| !facts.grants(need)).collect();
        missing.sort_unstable();
        missing.dedup();
        Err(NoPlan::Missing(missing))
    }

    /// Breadth first, so the first way found is the shortest.
    fn search<'a>(
        &'a self,
        from: &str,
        goal: &str,
        allowed: impl Fn(&Transition) -> bool,
    ) -> Option<Vec<&'a Transition>> {
        let mut came_by: BTreeMap<&str, &'a Transition> = BTreeMap::new();
        let mut open = VecDeque::from([from]);
        while let Some(state) = open.pop_front() {
            if state == goal {
                let mut way = Vec::new();
                let mut at = goal;
                while at != from {
                    let transition = came_by.get(at)?;
                    way.push(*transition);
                    at = &transition.from;
                }
                way.reverse();
                return Some(way);
            }
            for transition in self.leaving(state).filter(|transition| allowed(transition)) {
                let to = transition.to.as_str();
                if to != from && !came_by.contains_key(to) {
                    came_by.insert(to, transition);
                    open.push_back(to);
                }
            }
        }
        None
    }

    fn leaving<'a, 'b>(&'a self, state: &'b str) -> impl Iterator<Item = &'a Transition> + use<'a, 'b> {
        self.transitions.iter().filter(move |transition| transition.from == state)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::profile::Registry;

    const STATES: [&str; 7] = [
        "not-ready",
        "switch-on-disabled",
        "ready-to-switch-on",
        "switched-on",
        "operation-enabled",
        "quick-stop-active",
        "fault",
    ];

    fn machine(drive: &str) -> StateMachine {
        Registry::open(&[]).unwrap().family(drive).unwrap().machine.clone()
    }

    fn numbers(way: &[&Transition]) -> Vec<String> {
        way.iter().map(|transition| transition.number.clone()).collect()
    }

    #[test]
    fn the_short_cut_is_taken_where_it_is_there() {
        let all = &Facts::default();
        for (drive, short) in [("act", "4"), ("acu", "4'")] {
            let machine = machine(drive);
            assert_eq!(numbers(&machine.plan("switch-on-disabled", "operation-enabled", all).unwrap()), [short]);
            assert_eq!(numbers(&machine.plan("fault", "switched-on", all).unwrap()), ["15", "2", "3"]);
        }
        let positioning = &Facts::lacking([Need::NoPositioning]);
        let machine = machine("acu");
        let way = machine.plan("switch-on-disabled", "operation-enabled", positioning).unwrap();
        assert_eq!(numbers(&way), ["2", "3", "4"]);
    }

    #[test]
    fn what_is_missing_is_named() {
        let dark = &Facts::lacking([Need::Voltage, Need::Release]);
        let missing = machine("acu").plan("switch-on-disabled", "operation-enabled", dark).unwrap_err();
        assert_eq!(missing, NoPlan::Missing(vec![Need::Voltage, Need::Release]));
        let missing = machine("act").plan("switched-on", "operation-enabled", dark).unwrap_err();
        assert_eq!(missing, NoPlan::Missing(vec![Need::Release]));
    }

    #[test]
    fn from_any_state_any_goal_is_reached_or_the_reason_is_told() {
        let needs = [Need::Voltage, Need::Release, Need::NoPositioning];
        for drive in ["act", "acu", "lxm05"] {
            let machine = machine(drive);
            for from in STATES {
                for goal in STATES {
                    for bits in 0..8u8 {
                        let lacking = needs.iter().enumerate().filter(|(bit, _)| bits >> bit & 1 == 1);
                        let facts = Facts::lacking(lacking.map(|(_, need)| *need));
                        match machine.plan(from, goal, &facts) {
                            Ok(way) => {
                                let mut at = from;
                                for transition in &way {
                                    assert_eq!(transition.from, at);
                                    assert!(transition.needs.iter().all(|&need| facts.grants(need)));
                                    at = &transition.to;
                                }
                                assert_eq!(at, goal);
                                assert!(way.len() < STATES.len());
                            }
                            Err(NoPlan::Missing(missing)) => assert!(!missing.is_empty()),
                            // Nobody commands a fault, and a drive that was switched on is never "not ready" again.
                            Err(NoPlan::Unreachable { goal, .. }) => {
                                assert!(["fault", "not-ready"].contains(&goal.as_str()), "{from} -> {goal}");
                            }
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn every_number_of_the_manual_is_there() {
        for (drive, short) in [("act", "4"), ("acu", "4'")] {
            let machine = machine(drive);
            for number in (0..=15).map(|n| n.to_string()).chain([short.to_owned()]) {
                assert!(machine.transitions.iter().any(|transition| transition.number == number), "{drive} {number}");
            }
            for transition in &machine.transitions {
                let command = transition.command.as_ref().map(|slug| machine.command(slug).unwrap());
                if let Some(command) = command {
                    assert_eq!(command.word & command.mask, command.value, "{}", command.slug);
                }
            }
        }
    }
}
