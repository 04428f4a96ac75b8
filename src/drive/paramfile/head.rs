//! What stands above the values of a file that was read from a drive, and what is told of them.

use super::harvest::Harvest;
use crate::drive::describe;
use crate::drive::{Reading, Recognised, Session, Target};
use crate::failure::{Class, Failure};
use crate::outcome::{LeftOut, Value};
use crate::profile::paramfile::{
    FileFault, Head, NotHeld, Provenance, SavedDrive, Scope, Setting, Settings, print, ranges,
};
use crate::profile::{Family, Type};
use crate::text::{Lang, Text, both};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A file that waits for its values.
#[derive(Clone, Debug)]
pub struct Draft {
    head: Head,
    family: Rc<Family>,
}

impl Draft {
    /// Of a drive at this line, at this time.
    pub fn of(session: &Session<'_>, drive: &Recognised, scope: Scope, lang: Lang) -> Self {
        let head = head(session, drive);
        let saved = Provenance { scope: Some(scope), complete: false, ..head.saved };
        Draft { head: Head { saved, lang, ..head }, family: drive.target.family.clone() }
    }

    /// The text of the file with this harvest.
    pub fn text(&self, harvest: &Harvest) -> String {
        let numbers = harvest.left();
        let head = Head {
            not_held: numbers.map(|(reason, numbers)| (reason, ranges(numbers))).collect(),
            types: harvest.types.clone(),
            saved: Provenance {
                complete: harvest.is_complete(),
                signature: Some(harvest.settings.signature(&self.family.drive).to_string()),
                ..self.head.saved.clone()
            },
            ..self.head.clone()
        };
        print(&head, &harvest.settings, &self.family)
    }
}

/// What stands above the values of a whole file that comes from a drive at this line, at this time.
pub fn head(session: &Session<'_>, drive: &Recognised) -> Head {
    let Recognised { target, evidence, product } = drive;
    let english = evidence.iter().map(|row| {
        let [asked, answered, tells] = [&row.asked, &row.answered, &row.tells].map(|text| text.get(Lang::En));
        format!("{asked}: {answered} ({tells})")
    });
    let drive = SavedDrive {
        family: target.family.drive.clone(),
        address: Some(target.address),
        node: Some(session.node()).filter(|node| *node != 0),
        product: product.clone(),
        evidence: english.collect(),
    };
    let saved = Provenance {
        time: session.utc(),
        tool: Some(format!("antrieb {}", env!("CARGO_PKG_VERSION"))),
        port: Some(session.port().to_owned()),
        line: Some(session.line().to_string()),
        protocol: Some(session.protocol().to_string()),
        complete: true,
        ..Provenance::default()
    };
    Head { drive, saved, not_held: BTreeMap::new(), types: BTreeMap::new(), lang: Lang::En }
}

/// The failure of a file that cannot be taken.
pub fn broken(fault: &FileFault) -> Failure {
    match fault.newer {
        true => Failure::new(Class::Data, "data.newer_format", fault.text())
            .hint(both!("a newer antrieb reads it", "ein neueres antrieb liest sie")),
        false => {
            let usual = both!(
                "`antrieb params` lists the names; `antrieb dataset save FILE` writes a file as it has to be",
                "`antrieb params` zeigt die Namen; `antrieb dataset save DATEI` schreibt eine Datei, wie sie sein muss"
            );
            let hint = fault.hint.as_deref().cloned().unwrap_or(usual);
            Failure::new(Class::Data, "data.parameter_file", fault.text()).hint(hint)
        }
    }
}

/// What a harvest does not hold, for people and scripts.
pub fn left_out(harvest: &Harvest) -> Vec<LeftOut> {
    let row = |(reason, numbers): (NotHeld, std::collections::BTreeSet<u32>)| LeftOut {
        reason: reason.name(),
        text: told(reason),
        count: numbers.len(),
        params: ranges(numbers),
    };
    harvest.left().map(row).collect()
}

/// A reason in words.
fn told(reason: NotHeld) -> Text {
    match reason {
        NotHeld::ActualValue => {
            Text::new("actual values, which the drive changes itself", "Istwerte, die der Antrieb selbst ändert")
        }
        NotHeld::RamOnly => {
            Text::new("commands and setpoints, which live in RAM only", "Befehle und Sollwerte, die es nur im RAM gibt")
        }
        NotHeld::WriteOnly => Text::new("can be written but not read", "nur schreibbar, nicht lesbar"),
        NotHeld::NoNumber => Text::new("texts", "Texte"),
        NotHeld::Refused => Text::new(
            "refused by the drive: it does not have them, or does not tell them",
            "vom Antrieb abgelehnt: er hat sie nicht oder zeigt sie nicht",
        ),
        NotHeld::Unanswered => Text::new(
            "no valid answer came, or one that refuses and does not say why",
            "keine gültige Antwort, oder eine Ablehnung, die nicht sagt, warum",
        ),
        NotHeld::NotAsked => Text::new("not asked yet", "noch nicht gefragt"),
        NotHeld::FactorySetting => Text::new("at their factory setting", "auf Werkseinstellung"),
        NotHeld::NoKnownFactorySetting => {
            Text::new("no source tells their factory setting", "keine Quelle nennt ihre Werkseinstellung")
        }
        NotHeld::NoKnownWidth => both!(
            "no source tells their width, nor does SDO: it may be a number below zero",
            "keine Quelle nennt ihre Breite, SDO auch nicht: es kann eine Zahl unter null sein"
        ),
    }
}

/// The settings as rows of values, as `read` shows them.
pub fn rows(session: &Session<'_>, target: &Target, settings: &Settings) -> Vec<Value> {
    let row = |one: &Setting| {
        let kind = one.kind.or(one.param.kind).unwrap_or(Type::Word);
        let reading = Reading { set: one.set, raw: one.raw, text: None, kind, corrected: false };
        let value = describe::value(target.address, &target.family, &one.param, reading, &|_| None);
        Value { node: session.node(), ..value }
    };
    settings.iter().map(row).collect()
}
