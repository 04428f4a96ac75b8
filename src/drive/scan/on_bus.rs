//! A CAN bus with a master is listened to, and nobody is asked; what shows itself there, and how sure that is.

use super::look::stranger;
use super::plan::ScanPlan;
use super::search::unsearched;
use super::{ScanResult, Session, Tuning};
use crate::drive::can::is_master;
use crate::exchange::can::Sign;
use crate::failure::{Class, Failure};
use crate::outcome::{Event, Evidence, FoundDrive, Warning};
use crate::text::{Text, both};
use crate::tick::Span;
use std::collections::BTreeSet;

/// How long a bus with a master is listened to, unless --within says otherwise. A choice: a PDO comes every 50 s at the latest
/// (EM-RES-03 manual 5.11.2), a boot-up and an emergency never if nothing happens.
const LISTENED: Span = Span::from_secs(5);
/// How long a drive that is the master may say nothing (P.904, manual 5.8.1).
const LONGEST_PAUSE: Span = Span::from_secs(50);

/// What shows itself on a bus with a master; `None` where nobody was heard who is one, or he does not matter.
pub(super) async fn only_listens(session: &mut Session<'_>, plan: &ScanPlan) -> Option<ScanResult> {
    if plan.force || !session.traffic()?.has_master {
        return None;
    }
    let span = plan.within.unwrap_or(LISTENED);
    let message = both!(
        "a master is active on this bus: it is listened to for {span}, and nobody is asked",
        "an diesem Bus ist ein Master aktiv: {span} lang wird zugehört und niemand gefragt"
    );
    session.tell(Event::Note(message.clone()));
    let cut = session.rest(span).await.err();
    let nodes = session.traffic()?.nodes;
    let drives = nodes.iter().filter(|(node, _)| plan.addresses.contains(node));
    let drives = drives.map(|(&node, signs)| heard(session, node, signs)).collect();
    let unasked = Failure::new(Class::Forbidden, "forbidden.other_master", message).hint(both!(
        "--force asks every node, over SDO2, which is there for tools; `read` asks one",
        "--force fragt jeden Knoten, über SDO2, das für Werkzeuge da ist; `read` fragt einen"
    ));
    let tuning = Tuning { protocol: session.protocol(), line: session.line() };
    let searched = vec![unsearched(plan, tuning)];
    Some(ScanResult {
        drives,
        searched,
        unasked: Some(unasked).filter(|_| cut.is_none()),
        cut,
        ..ScanResult::default()
    })
}

/// A node that was not asked.
fn heard(session: &Session<'_>, node: u8, signs: &BTreeSet<Sign>) -> FoundDrive {
    let evidence = signs.iter().map(|&sign| Evidence {
        asked: both!("listened", "zugehört"),
        answered: name(sign),
        tells: tells(sign),
    });
    let title = match signs.iter().any(|sign| *sign != Sign::Pdo) {
        true => both!("node, not asked", "Knoten, nicht gefragt"),
        false => both!("perhaps a node, not asked", "vielleicht ein Knoten, nicht gefragt"),
    };
    FoundDrive { evidence: evidence.collect(), ..stranger(session, node, title) }
}

fn name(sign: Sign) -> Text {
    match sign {
        Sign::BootUp => both!("boot-up", "Boot-Up"),
        Sign::Emergency => both!("emergency", "Emergency"),
        Sign::Answer => both!("answer over SDO", "Antwort über SDO"),
        Sign::Pdo => both!("PDO", "PDO"),
    }
}

fn tells(sign: Sign) -> Text {
    match sign {
        Sign::BootUp | Sign::Emergency | Sign::Answer => both!("it is there", "er ist da"),
        Sign::Pdo => both!(
            "it may be there: anybody can have been given this identifier",
            "er ist vielleicht da: diesen Identifier kann jeder bekommen haben"
        ),
    }
}

/// Whether there is a master: the drive that answers as node 0 is one; that none was heard is no proof.
pub(super) fn about_master(session: &Session<'_>, found: &[FoundDrive]) -> Option<Warning> {
    let is_quiet = !session.traffic()?.has_master;
    let warning = |code: &str, message: Text| Warning { code: code.to_owned(), message };
    if let Some(station) = found.iter().map(|drive| drive.address).find(|station| is_master(*station)) {
        let message = both!(
            "{station} is node 0, so this drive is the master of the bus: it starts the nodes and beats the time; it is reached as -a master",
            "{station} ist Knoten 0, dieser Umrichter ist also der Master des Busses: er startet die Knoten und gibt den Takt; erreichbar \
             ist er als -a master"
        );
        return Some(warning("scan.master_drive", message));
    }
    let message = both!(
        "no master was heard, which is no proof that there is none: a drive that is the master may say nothing for {LONGEST_PAUSE} (P.904)",
        "es war kein Master zu hören, was nicht beweist, dass es keinen gibt: ein Umrichter, der Master ist, schweigt bis zu \
         {LONGEST_PAUSE} (P.904)"
    );
    is_quiet.then(|| warning("scan.no_master_heard", message))
}
