//! What an undo file states: the way back, held against what it may say.

use super::super::weigh::{Coming, Unproven};
use crate::drive::job::Step;
use crate::drive::paramfile::broken;
use crate::failure::{Class, Failure};
use crate::profile::paramfile::{FileFault, ParamFile, Setting, Settings, UndoSettings, value_text};
use crate::profile::{DataSets, Family, Goes};
use crate::text::both;

/// What an undo file states.
#[derive(Debug)]
pub struct WayBack {
    /// The old values.
    pub steps: Vec<Step>,
    /// The new ones from which they lead back.
    pub from: Coming,
    /// What stood in the RAM alone: it is only named.
    pub in_ram_alone: Settings,
    /// What perhaps did not come back.
    pub unproven: Unproven,
}

/// What a file says of the way back: as it stands there, and as what is to be done.
pub(super) fn way_back(file: &ParamFile, family: &Family) -> Result<(UndoSettings, WayBack), Failure> {
    let Some((undo, coming)) = file.undo.as_ref().zip(file.coming(family)) else { return Err(no_undo_file(file)) };
    let old = file.settings(family).map_err(|fault| broken(&fault))?;
    old.iter().try_for_each(|it| was_loaded(it, family)).map_err(|fault| broken(&fault))?;
    let coming = coming.map_err(|fault| broken(&fault))?;
    let in_ram_alone = file.in_ram_alone(family).map_err(|fault| broken(&fault))?;
    let unproven = file.unproven(family).map_err(|fault| broken(&fault))?;
    unproven.iter().try_for_each(|it| was_undone(it, &old)).map_err(|fault| broken(&fault))?;
    let wire = |set| undo.store.wire(set);
    let step = |it: &Setting| Step { param: it.param.clone(), set: wire(it.set), raw: it.raw, kind: it.kind, at: None };
    let mut steps: Vec<Step> = old.iter().map(step).collect();
    steps.sort_by_key(|step| family.files.rank(&step.param, step.set));
    let from = coming.iter().map(|it| ((it.param.id, wire(it.set)), it.raw)).collect();
    let open = unproven.iter().map(|it| (it.param.id, wire(it.set))).collect();
    let way = WayBack { steps, from, in_ram_alone: in_ram_alone.clone(), unproven: open };
    Ok((UndoSettings { old, new: coming, store: undo.store, ram: in_ram_alone, unproven }, way))
}

/// Only what a load may write is taken back: a file is changed by anybody, and a control word that it brings would start the shaft.
fn was_loaded(setting: &Setting, family: &Family) -> Result<(), FileFault> {
    if family.files.goes(&setting.param) <= Goes::IfAsked {
        return Ok(());
    }
    let why = both!(
        "no load ever writes {label} ({called}), so it cannot be taken back",
        "{label} ({called}) schreibt kein Laden, also lässt es sich nicht zurücknehmen",
        label = setting.param.label(),
        called = setting.param.called()
    );
    let hint = both!("take the line out; nothing was written", "die Zeile herausnehmen; es wurde nichts geschrieben");
    Err(FileFault::new(setting.at.clone(), why).hint(hint))
}

/// What did not come back was to come back, with the value that stood there: else the file says two things.
fn was_undone(setting: &Setting, old: &Settings) -> Result<(), FileFault> {
    let covers = |set: u8| [set, 0].into_iter().find_map(|set| old.exactly(setting.param.id, set));
    let is_one = |set: u8| covers(set).is_some_and(|old| old.raw == setting.raw);
    if is_one(setting.set) || setting.set == 0 && (1..DataSets::RAM_OFFSET).all(is_one) {
        return Ok(());
    }
    let value = value_text(&setting.param, setting.raw);
    let why = both!(
        "[undo.unproven] has {label} = {value}, and [values], which undo brings back, has not",
        "[undo.unproven] hat {label} = {value}, und [values], was undo zurückholt, nicht",
        label = setting.param.label()
    );
    let hint = both!(
        "make both say the same, or take the line out of [undo.unproven]; nothing was written",
        "beide gleich machen oder die Zeile aus [undo.unproven] herausnehmen; es wurde nichts geschrieben"
    );
    Err(FileFault::new(setting.at.clone(), why).hint(hint))
}

fn no_undo_file(file: &ParamFile) -> Failure {
    let message = both!(
        "{path}: this file takes nothing back: it has no table [undo]",
        "{path}: diese Datei nimmt nichts zurück: sie hat keine Tabelle [undo]",
        path = file.path
    );
    Failure::new(Class::Data, "data.no_undo_file", message).hint(both!(
        "`antrieb dataset load` leaves one before it writes; `dataset load` writes a parameter file",
        "`antrieb dataset load` legt eine an, bevor es schreibt; `dataset load` schreibt eine Parameterdatei"
    ))
}
