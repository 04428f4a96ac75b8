//! What the manual forbids of a plan, advises against, or leaves open (EM-RES-03 manual 5.8 to 5.14, facts G3).

mod identifiers;
mod places;
mod timing;

use super::plan::Plan;
use crate::profile::Family;
use crate::text::{Text, both};

/// How much a remark weighs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// It is not allowed, or cannot work.
    Error,
    /// It is advised against.
    Warning,
    /// Good to know.
    Note,
}

impl Level {
    /// As JSON has it.
    pub fn name(self) -> &'static str {
        match self {
            Level::Error => "error",
            Level::Warning => "warning",
            Level::Note => "note",
        }
    }
}

/// What is said of a plan.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// How much it weighs.
    pub level: Level,
    /// Stable.
    pub code: &'static str,
    /// For people.
    pub text: Text,
}

fn error(code: &'static str, text: Text) -> Remark {
    Remark { level: Level::Error, code, text }
}

fn warning(code: &'static str, text: Text) -> Remark {
    Remark { level: Level::Warning, code, text }
}

fn note(code: &'static str, text: Text) -> Remark {
    Remark { level: Level::Note, code, text }
}

/// Everything that is to be said of a plan, the worst first. `family`: whose parameters and sources it names.
pub fn check(plan: &Plan, family: &Family) -> Vec<Remark> {
    let mut remarks = nodes(plan);
    remarks.extend(identifiers::check(plan));
    remarks.extend(places::check(plan, family));
    remarks.extend(timing::check(plan));
    remarks.sort_by_key(|remark| remark.level);
    remarks
}

/// Nodes, the master, and PDOs that a drive would have twice.
fn nodes(plan: &Plan) -> Vec<Remark> {
    let mut remarks = Vec::new();
    for (nth, drive) in plan.drives.iter().enumerate() {
        let (name, node) = (&drive.name, drive.node);
        if let Some(other) = plan.drives.iter().take(nth).find(|other| other.node == node) {
            let other = &other.name;
            remarks.push(error(
                "node_twice",
                both!("{other} and {name} are both node {node}", "{other} und {name} sind beide Knoten {node}"),
            ));
        }
        let sent = drive.tx.iter().map(|tx| format!("TxPDO{}", tx.number.number()));
        let received = drive.rx.iter().map(|rx| format!("RxPDO{}", rx.number.number()));
        for twice in repeated(sent.chain(received)) {
            remarks.push(error("pdo_twice", both!("{name} has its {twice} twice", "{name} hat seine {twice} zweimal")));
        }
        let is_slave_with_duties =
            node != 0 && (drive.boot_up_delay_ms.is_some() || drive.emergency_reaction.is_some());
        if is_slave_with_duties {
            remarks.push(warning(
                "not_master",
                both!(
                    "{name}: boot-up-delay and emergency-reaction act in the master only (node 0)",
                    "{name}: boot-up-delay und emergency-reaction wirken nur im Master (Knoten 0)"
                ),
            ));
        }
        if drive.boot_up_delay_ms.is_some_and(|ms| !(3500..=50_000).contains(&ms)) {
            let text = both!(
                "{name}: boot-up-delay must be 3500 to 50000 ms (P.904)",
                "{name}: boot-up-delay muss 3500 bis 50000 ms sein (P.904)"
            );
            remarks.push(error("boot_up_delay", text));
        }
    }
    remarks.extend(master(plan));
    remarks
}

fn master(plan: &Plan) -> Option<Remark> {
    match (plan.master(), plan.has_external_master) {
        (Some(drive), true) => {
            let name = &drive.name;
            Some(error(
                "two_masters",
                both!(
                    "{name} is the master (node 0), and so is somebody external: only one may be",
                    "{name} ist der Master (Knoten 0) und jemand Externes auch: nur einer darf es sein"
                ),
            ))
        }
        (None, false) => Some(warning(
            "no_master",
            both!(
                "nobody starts the nodes: give a drive node 0, or say master = \"external\"",
                "niemand startet die Knoten: einem Antrieb Knoten 0 geben oder master = \"external\" angeben"
            ),
        )),
        _ => None,
    }
}

/// What comes more than once, each once.
fn repeated<T: PartialEq>(items: impl Iterator<Item = T>) -> Vec<T> {
    let (mut seen, mut twice) = (Vec::new(), Vec::new());
    for item in items {
        match seen.contains(&item) {
            true if !twice.contains(&item) => twice.push(item),
            true => {}
            false => seen.push(item),
        }
    }
    twice
}
