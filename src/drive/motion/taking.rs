//! Taking control of a drive from somebody else, and giving it back.

use super::own::shown;
use super::{Motor, Situation, has_power, role_raw};
use crate::drive::{Session, Target};
use crate::failure::Failure;
use crate::outcome::{Change, State};
use crate::profile::{Control, Family, Movement, Need, Param};
use crate::text::{Text, both};

/// How often it is asked what became of a write.
const TRIES: u8 = 3;

/// What becomes of a drive that runs as control over it is taken, in words; `None` if nobody runs it. `new`: who controls it
/// then; `again`: it is to run afterwards.
pub fn taken_over(before: &Situation, family: &Family, new: i64, again: bool) -> Option<Text> {
    let (control, old) = (family.motion.control?, before.mode.filter(|&old| old != new)?);
    if has_power(&before.state) != Some(true) {
        return None;
    }
    let (label, word) = (family.role_label("control-mode"), family.role_label("control-word"));
    let how = match counts(control, old) {
        true => both!(
            "what stands in {word} means something else then, which may take its power",
            "was in {word} steht, bedeutet dann etwas anderes und kann ihm den Strom nehmen"
        ),
        false => both!(
            "{word} is set first, so that it shall keep its power; no manual says that it does",
            "{word} wird vorher gesetzt, damit er den Strom behält; dass er das tut, sagt kein Handbuch"
        ),
    };
    let then = match again {
        true => both!(
            "without it the shaft coasts, and is powered again while it may still turn",
            "ohne ihn läuft die Welle aus und bekommt wieder Strom, während sie noch drehen kann"
        ),
        false => both!("without it the shaft coasts", "ohne ihn läuft die Welle aus"),
    };
    Some(both!(
        "somebody else runs it ({label} = {old}), control is taken while it runs: {how}; {then}",
        "jemand anderes lässt ihn laufen ({label} = {old}), die Steuerung wird im Lauf übernommen: {how}; {then}",
        how,
        then
    ))
}

/// What the shaft of a drive does that runs already, where the drive tells a speed.
pub async fn goes_now(session: &mut Session<'_>, target: &mut Target) -> Result<Option<Text>, Failure> {
    let family = target.family.clone();
    let Some(param) = family.role("movement").filter(|_| family.motion.movement == Movement::Speed) else {
        return Ok(None);
    };
    let raw = role_raw(session, target, "movement").await?;
    Ok(raw.map(|raw| {
        let (label, now) = (param.label(), shown(param, raw));
        both!("its shaft turns now: {label} = {now}", "seine Welle dreht jetzt: {label} = {now}")
    }))
}

/// Whether the control word does anything in a control mode. Where contacts decide it does not (CM-485 manual 9.1.1); of keypads
/// nothing is said.
fn counts(control: Control, mode: i64) -> bool {
    [control.obeys, control.contacts].contains(&mode)
}

impl Motor<'_, '_> {
    /// Takes control for the run; it is given back at the end. `word`: what shall stand in the control word by then, if the
    /// drive runs and the word counts for nothing yet, so that nothing interrupts its run.
    pub async fn take_control(&mut self, new: i64, word: Option<u16>) -> Result<(), Failure> {
        let family = self.target.family.clone();
        let Some((param, control)) = family.role("control-mode").zip(family.motion.control) else { return Ok(()) };
        let (set, old) = self.in_force(param).await?;
        if old == new {
            return Ok(());
        }
        self.note_change(param, set, old, new)?;
        let runs = self.taken == Taken::Running;
        let word = word.filter(|_| runs && self.enabled && !counts(control, old));
        if let Some(word) = word
            && let Err(failure) = self.write_control(word).await
        {
            // It counts for nothing, and the drive runs as before: there is nothing to stop.
            self.touched = false;
            return Err(failure);
        }
        if let Err(failure) = self.write(param, set, new).await {
            let counts_now = !self.is_still(param, old).await;
            self.touched &= word.is_none() || counts_now;
            self.has_hand_by(new, word.filter(|_| counts_now));
            return Err(failure);
        }
        self.has_hand_by(new, word);
        if runs {
            let state = self.state().await?;
            self.enabled = state.slug == "operation-enabled";
            self.tells_taken(&state, old, new);
        }
        Ok(())
    }

    /// Whether a setting is known to be what it was, whoever interrupts the question.
    async fn is_still(&mut self, param: &Param, old: i64) -> bool {
        for _ in 0..TRIES {
            self.session.note_interrupts();
            if let Ok((_, now)) = self.in_force(param).await {
                return now == old;
            }
        }
        false
    }

    /// What the control word is from now on, if one stands there.
    fn has_hand_by(&mut self, mode: i64, word: Option<u16>) {
        let contacts = self.target.family.motion.control.is_some_and(|control| control.contacts == mode);
        if word.is_some() {
            self.lever = if contacts { Lever::Contacts } else { Lever::ControlWord };
        }
    }

    /// Whether it is enabled, as far as was seen.
    pub fn is_enabled(&self) -> bool {
        self.enabled
    }

    /// What came of a run over which control was taken.
    fn tells_taken(&mut self, state: &State, old: i64, new: i64) {
        let label = self.target.family.role_label("control-mode");
        let told = match (state.slug.as_str(), has_power(&state.slug)) {
            ("operation-enabled", _) => both!(
                "control was taken while it ran ({label}: {old} -> {new}), and it kept its power",
                "die Steuerung wurde im Lauf übernommen ({label}: {old} -> {new}), er behielt seinen Strom"
            ),
            (_, Some(true)) => both!(
                "control was taken while it ran ({label}: {old} -> {new}), which stops it: {state}",
                "die Steuerung wurde im Lauf übernommen ({label}: {old} -> {new}), was ihn anhält: {state}",
                state = state.name
            ),
            _ => both!(
                "control was taken while it ran ({label}: {old} -> {new}), which took its power: the shaft coasted ({state})",
                "die Steuerung wurde im Lauf übernommen ({label}: {old} -> {new}), was ihm den Strom nahm: die Welle lief aus \
                 ({state})",
                state = state.name
            ),
        };
        self.tell(told.clone());
        self.notes.push(told);
    }

    /// Whether the drive stays where it is when control goes back. The control word of the stop would close virtual
    /// contacts, so it is cleared first; and contacts that are closed now would start a drive that listens to them, or one
    /// that ran before control was taken: who started it then is not known, and would start it again. So would a contact
    /// that was closed since.
    pub(super) async fn may_give_control_back(&mut self, change: &Change) -> bool {
        if self.write_control(0).await.is_err() {
            return false;
        }
        let family = self.target.family.clone();
        let Some(control) = family.motion.control else { return true };
        let Ok(status) = self.status().await else { return false };
        let old = change.old;
        let may_start = old == control.terminals || (old != control.contacts && self.taken != Taken::Idle);
        if !may_start || self.is_released(status) != Some(true) {
            return true;
        }
        let (label, now) = (family.role_label("control-mode"), change.new);
        let ran = self.taken == Taken::Running;
        self.notes.push(match ran {
            true => both!(
                "{label} stays {now}: enable and start contact are closed, and the drive ran under {label} = {old} before",
                "{label} bleibt {now}: Freigabe und Startkontakt sind geschlossen, und der Antrieb lief vorher unter {label} = \
                 {old}"
            ),
            false => both!(
                "{label} stays {now}: enable and start contact are closed and would start the drive under {label} = {old}",
                "{label} bleibt {now}: Freigabe und Startkontakt sind geschlossen und würden den Antrieb unter {label} = \
                 {old} starten"
            ),
        });
        false
    }

    /// Whether the contacts that a run needs are closed; `None` if the status word does not tell.
    fn is_released(&self, status: u32) -> Option<bool> {
        let bit = self.target.family.motion.interlock(Need::Release)?.bit?;
        Some(status >> bit & 1 == 1)
    }

    /// Takes note of the contacts at the first look behind the taking of control.
    pub(super) fn notes_contacts(&mut self, status: u32) {
        if self.taken == Taken::Unseen {
            self.taken = if self.is_released(status) == Some(true) { Taken::Idle } else { Taken::Open };
        }
    }
}

/// What a run has its hand on; the stop must use the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lever {
    /// The control word commands the state machine.
    ControlWord,
    /// The control word stands for contacts: all open is the stop. A command of the state machine would close contacts
    /// here and could start the drive.
    Contacts,
    /// Somebody else starts and stops the drive; ours is the setpoint, and zero is the stop.
    Setpoint,
    /// Control was taken away in the run. What is left are our setpoint, and a control word that asks for nothing.
    Taken,
}

/// What is known of the drive as control over it was taken from somebody else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Taken {
    /// It has not answered since.
    #[default]
    Unseen,
    /// It had power before: somebody else ran it.
    Running,
    /// It had none, though its contacts were closed: they do not start it.
    Idle,
    /// It had none, and its contacts were open.
    Open,
    /// It had none because of a fault: whether its contacts start it is not known.
    Tripped,
}
