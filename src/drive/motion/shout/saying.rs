//! Saying one thing at once, and asking only what cannot wait.

use super::super::has_power;
use super::super::look::{raw, role_raw};
use super::super::passing::Look;
use super::{BRIEF, GLANCE, TURN};
use crate::drive::access::AccessError;
use crate::drive::describe;
use crate::drive::route::Meant;
use crate::drive::session::Session;
use crate::drive::target::Target;
use crate::exchange::{Answer, Limits, Question};
use crate::failure::{Class, Failure};
use crate::profile::Family;
use std::rc::Rc;

/// Says it once; whoever interrupts that gets it said again, and waits no longer than for this answer. Whether somebody did.
/// `tells` asks what tells its answer from an echo.
pub(super) async fn insist(
    session: &mut Session<'_>,
    address: u8,
    word: &Question,
    mut tells: impl AsyncFnMut(&mut Session<'_>) -> Result<(), AccessError>,
) -> (Result<Answer, AccessError>, bool) {
    let mut pressed = false;
    loop {
        session.end_at(Some(session.now() + BRIEF.longer(session.limits().reply_timeout)));
        match session.blurt(address, word.clone(), &mut tells).await {
            Err(AccessError::Interrupted) => {
                session.note_interrupts();
                pressed = true;
            }
            answer => return (answer, pressed),
        }
    }
}

/// Limits of a question that is waited for as long as a drive may take to answer, however long `--timeout` is.
pub(super) fn in_turn(session: &Session<'_>) -> Limits {
    let patient = session.patient();
    Limits { reply_timeout: patient.reply_timeout.min(TURN), ..patient }
}

/// Does it in short questions, also into a busy line; afterwards the session is as before.
pub(super) async fn at_once<T>(session: &mut Session<'_>, work: impl AsyncFnOnce(&mut Session<'_>) -> T) -> T {
    session.insist(true);
    let limits = session.limits();
    let brief = Limits { reply_timeout: GLANCE.min(limits.reply_timeout), retries: 0, ..limits };
    let said = session.within(brief, work).await;
    session.end_at(None);
    session.insist(false);
    said
}

/// Asks something whose echo is no answer: where a standstill shows only for a while, the shaft itself.
pub(super) async fn glimpsed(
    session: &mut Session<'_>,
    meant: &Meant,
    family: &Rc<Family>,
    looks: &mut Vec<Look>,
) -> Result<(), AccessError> {
    let Some(param) = family.role("movement").filter(|_| family.motion.stator.is_some()) else {
        return session.sound(meant.address).await;
    };
    let mut target = Target::new(meant.address, family.clone());
    looks.extend(in_short(raw(session, &mut target, param, 0).await)?.flatten().map(Look::Shaft));
    Ok(())
}

/// Looks at a drive in passing, where others wait to be told: its shaft, and before and behind that whether it has power. What is
/// not answered at once, or interrupted, is left to later looks.
pub(super) async fn passed_by(session: &mut Session<'_>, address: u8, family: &Rc<Family>, looks: &mut Vec<Look>) {
    let has_power = |look: &Look| match look {
        Look::Status(status) => has_power(&describe::state(family, *status).slug),
        Look::Shaft(_) => None,
    };
    if looks.iter().filter_map(has_power).next_back() == Some(false) {
        return;
    }
    let (mut target, is_first) =
        (Target::new(address, family.clone()), !looks.iter().any(|look| matches!(look, Look::Status(_))));
    let roles = [("status-word", is_first), ("movement", true), ("status-word", true)];
    for (role, _) in roles.into_iter().filter(|(_, is_asked)| *is_asked) {
        session.end_at(Some(session.now() + GLANCE));
        let Ok(Some(value)) = role_raw(session, &mut target, role).await else { return };
        looks.push(if role == "movement" { Look::Shaft(value) } else { Look::Status(value as u32) });
    }
}

/// What was not told in a short time is not known.
pub(super) fn in_short<T>(told: Result<T, Failure>) -> Result<Option<T>, AccessError> {
    match told {
        Ok(value) => Ok(Some(value)),
        Err(failure) if failure.class == Class::Interrupted => Err(AccessError::Interrupted),
        Err(_) => Ok(None),
    }
}

/// Whoever interrupts a question before the stop ends the question: the stop goes out without its answer.
pub(super) fn unless_interrupted<T>(
    session: &mut Session<'_>,
    told: Result<T, AccessError>,
) -> Result<Option<T>, AccessError> {
    match told {
        Err(AccessError::Interrupted) => {
            session.note_interrupts();
            Ok(None)
        }
        told => told.map(Some),
    }
}
