//! Asking the user before anything is done. Whoever interrupts at the question ends it at once, and nothing is sent.

use crate::drive::{AccessError, Interrupt, Session};
use crate::failure::{Class, Failure};
use crate::gate::{self, Ask, Denied, Kind, Permit, Question};
use crate::text::both;

/// Asks with the line open: it is kept going meanwhile, and the question ends if it is lost.
pub(super) async fn on_line<K: Kind>(
    session: &mut Session<'_>,
    ask: &mut dyn Ask,
    question: &Question,
) -> Result<Permit<K>, Failure> {
    match session.during(gate::ask(ask, question)).await {
        Ok(answer) => answer.map_err(denied),
        Err(AccessError::Interrupted) => Err(interrupted()),
        Err(error) => Err(error.failure(0, None)),
    }
}

/// Asks before anything is opened.
pub(super) async fn off_line<K: Kind>(
    interrupt: &Interrupt,
    ask: &mut dyn Ask,
    question: &Question,
) -> Result<Permit<K>, Failure> {
    let answer = tokio::select! {
        biased;
        answer = gate::ask(ask, question) => answer,
        () = interrupt.raised() => return Err(interrupted()),
    };
    if interrupt.is_raised() { Err(interrupted()) } else { answer.map_err(denied) }
}

pub(super) fn interrupted() -> Failure {
    let text = both!(
        "interrupted at the question, nothing was written",
        "bei der Frage abgebrochen, nichts wurde geschrieben"
    );
    Failure::new(Class::Interrupted, "interrupted.question", text)
}

/// Somebody leaves while the run waits for a key to be held.
pub(super) fn left_before_start() -> Failure {
    let text = both!(
        "interrupted before a key was held: nothing was started",
        "abgebrochen, ehe eine Taste gehalten wurde: nichts wurde gestartet"
    );
    Failure::new(Class::Interrupted, "interrupted.start", text)
}

/// The failure to show when there is no permit.
pub(super) fn denied(denied: Denied) -> Failure {
    match denied {
        Denied::Refused => {
            let text = both!("not confirmed, nothing was written", "nicht bestätigt, nichts wurde geschrieben");
            Failure::new(Class::Forbidden, "forbidden.not_confirmed", text)
        }
        Denied::Nobody => {
            let text = both!(
                "there is no terminal to ask for confirmation, nothing was written",
                "kein Terminal da, um nachzufragen; nichts wurde geschrieben"
            );
            Failure::new(Class::Forbidden, "forbidden.no_terminal", text).hint(both!(
                "--yes answers the question; --dry-run shows what would be sent",
                "--yes beantwortet die Frage; --dry-run zeigt, was gesendet würde"
            ))
        }
    }
}
