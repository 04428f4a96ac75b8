//! What keeps a drive from running, in words.

use super::look::Situation;
use crate::drive::describe;
use crate::drive::target::Target;
use crate::failure::{Class, Failure};
use crate::profile::{Family, Need, Part};
use crate::text::{Text, both};

/// What keeps the drive from running, in words, and how one sees it.
pub fn missing(situation: &Situation, target: &Target) -> Vec<Text> {
    let family = &target.family;
    let mut missing: Vec<Text> = not_obeyed(situation, family).into_iter().collect();
    let lacking = family.motion.interlocks.iter().filter(|row| situation.lacks(row, family));
    missing.extend(lacking.filter_map(|row| situation.told(row)));
    missing.extend(family.motion.interlocks.iter().filter_map(|row| situation.open(row, family)));
    if let Some(fault) = situation.fault.and_then(|code| describe::fault(family, code as u32)) {
        missing.push(fault.told());
    }
    missing
}

fn not_obeyed(situation: &Situation, family: &Family) -> Option<Text> {
    let (control, mode) = (family.motion.control?, situation.mode?);
    if mode == control.obeys {
        return None;
    }
    let (label, obeys) = (family.role("control-mode")?.label(), control.obeys);
    Some(both!(
        "{label} is {mode}: the control word is obeyed only with {obeys} (--take-control)",
        "{label} ist {mode}: auf das Steuerwort hört der Antrieb nur bei {obeys} (--take-control)"
    ))
}

/// The failure to show where the control word is not obeyed; `None` where it is, or where the drive does not say.
pub fn no_control(situation: &Situation, target: &Target) -> Option<Failure> {
    let (control, mode) = (target.family.motion.control?, situation.mode?);
    if mode == control.obeys {
        return None;
    }
    let (label, obeys) = (target.family.role("control-mode")?.label(), control.obeys);
    let text = both!(
        "the drive is not controlled by the control word: {label} is {mode}, it must be {obeys}",
        "der Antrieb hört nicht auf das Steuerwort: {label} ist {mode}, nötig ist {obeys}"
    );
    Some(Failure::new(Class::Forbidden, "forbidden.control_mode", text).hint(both!(
        "--take-control sets it in RAM; behind a --hold, a stop and a reset it is given back, where that starts nothing",
        "--take-control stellt es im RAM um; nach --hold, einem Halt und einer Quittierung geht es zurück, wo das nichts \
         startet"
    )))
}

/// The failure to show of a drive that is not commanded by a word.
pub fn no_control_word() -> Failure {
    let text = both!("this drive has no control word", "dieser Antrieb hat kein Steuerwort");
    Failure::new(Class::Data, "data.role", text)
}

/// The failure to show where a drive is to start that stands in a fault: nothing was sent that could start it.
pub fn in_fault(situation: &Situation, family: &Family) -> Option<Failure> {
    let code = situation.state.starts_with("fault").then(|| situation.fault.unwrap_or(0) as u32)?;
    let failure = tripped(family, code);
    let what = describe::fault(family, code).filter(|_| code != 0).map(|fault| fault.told());
    let text = both!(
        "the drive is in a fault and starts only once that is acknowledged",
        "der Antrieb steht in einer Störung und startet erst, wenn sie quittiert ist"
    );
    let resets = both!(
        "`antrieb statemachine reset` acknowledges it when its cause is gone",
        "`antrieb statemachine reset` quittiert sie, wenn ihre Ursache behoben ist"
    );
    let hints: Vec<Text> = std::iter::once(resets).chain(failure.hint.as_deref().cloned()).collect();
    let message = what.iter().fold(text, |text, what| Text::join([&text, what], ": "));
    Some(Failure { message, ..failure }.hint(Text::join(&hints, "; ")))
}

/// The failure to show where the drive has tripped.
pub fn tripped(family: &Family, code: u32) -> Failure {
    let fault = describe::fault(family, code);
    let text = both!("the drive has tripped", "der Antrieb hat abgeschaltet");
    let text = fault.iter().fold(text, |text, fault| Text::join([&text, &fault.told()], ": "));
    let failure = Failure::new(Class::Forbidden, "forbidden.fault", text);
    match fault.and_then(|fault| fault.remedy) {
        Some(remedy) => failure.hint(remedy),
        None => failure,
    }
}

/// What stops a drive that cannot be reached, or does not obey.
pub fn what_stops_it(family: Option<&Family>) -> Text {
    let enable = family.and_then(|family| family.motion.interlock(Need::Release)).and_then(|row| row.parts.first());
    let usual = || both!("its safe-torque-off or enable input", "sein STO- oder Freigabeeingang");
    both!(
        "what stops it now: {enable}, the emergency stop, or the mains",
        "was ihn jetzt anhält: {enable}, der Not-Halt oder das Netz",
        enable = enable.map_or_else(usual, Part::text)
    )
}
