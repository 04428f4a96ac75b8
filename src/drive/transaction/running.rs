//! The shaft, while a file goes into its drive: nothing is written to one that runs, whoever started it and when.

use crate::drive::motion::has_power;
use crate::drive::{Reader, Session, Target};
use crate::failure::{Class, Failure};
use crate::profile::{Param, Role};
use crate::text::both;

/// The code of a drive that runs.
pub const RUNNING: &str = "forbidden.running";

/// Who started the shaft: the values themselves, which somebody agreed to, or somebody else.
#[derive(Debug, Default)]
pub(super) struct Shaft {
    /// What was written last can start it.
    may_start: bool,
    /// It was started by what was written.
    is_ours: bool,
}

impl Shaft {
    /// Looks before a write. To a drive that runs because of its new values goes only what is of that kind: the rest of what was
    /// agreed to, or the way back.
    pub(super) async fn allows(
        &mut self,
        session: &mut Session<'_>,
        target: &mut Target,
        param: &Param,
    ) -> Result<(), Failure> {
        let may_start = std::mem::take(&mut self.may_start);
        match standstill(session, target).await {
            Err(failure) if failure.class == Class::Forbidden => {
                self.is_ours |= may_start;
                let is_let = self.is_ours && target.family.files.may_start(param);
                if is_let { Ok(()) } else { Err(failure) }
            }
            stands => stands,
        }
    }

    /// Takes note of a write: what starts now is its doing.
    pub(super) fn writes(&mut self, target: &Target, param: &Param) {
        self.may_start = target.family.files.may_start(param);
    }
}

/// Refuses a drive that runs, or does not say in a state that we know that it does not (CM-485 manual 6.6, cause 8): some parameters cannot be written then, which ones no source tells, and the others would change
/// a shaft that turns.
pub(super) async fn standstill(session: &mut Session<'_>, target: &mut Target) -> Result<(), Failure> {
    let address = target.address;
    if target.family.role(Role::StatusWord).is_none() {
        // A family of the user's own that tells no state.
        return Ok(());
    }
    let mut reader = Reader::new(session, target);
    let state = reader.vital_role(Role::StatusWord).await?.and_then(|value| value.word?.state);
    // Where the word names no state, the frequency tells whether the shaft turns.
    let turns = match (&state, reader.target.family.role(Role::ActualFrequency)) {
        (None, Some(_)) => reader.vital_role(Role::ActualFrequency).await?.is_some_and(|value| value.raw != Some(0)),
        _ => false,
    };
    if let Some(failure) = reader.into_failures().0.into_iter().next() {
        return Err(failure);
    }
    let state = match state.filter(|state| has_power(&state.slug) != Some(false)) {
        Some(state) => state.name,
        None if turns => both!("its shaft turns", "seine Welle dreht sich"),
        None => return Ok(()),
    };
    let message = both!(
        "drive {address} runs ({state}): a file is written to a drive that does not run",
        "Antrieb {address} läuft ({state}): eine Datei wird in einen Antrieb geschrieben, der nicht läuft",
        state
    );
    Err(Failure::new(Class::Forbidden, RUNNING, message).with("address", address).hint(both!(
        "stop it first, such as with `antrieb statemachine disable`; `antrieb write` writes single values to a drive that runs",
        "ihn zuerst anhalten, etwa mit `antrieb statemachine disable`; `antrieb write` schreibt einzelne Werte in einen \
         laufenden Antrieb"
    )))
}
