//! Asking the user before anything is done. Whoever interrupts at the question ends it at once, and nothing is sent.

use crate::drive::{AccessError, Interrupt, Session};
use crate::failure::{Class, Failure};
use crate::gate::{self, Ask, Denied, Kind, Permit, Question};
use crate::profile::Lang;

/// Asks with the line open: it is kept going meanwhile, and the question ends if it is lost.
pub(super) async fn on_line<K: Kind>(
    session: &mut Session<'_>,
    ask: &mut dyn Ask,
    question: &Question,
    lang: Lang,
) -> Result<Permit<K>, Failure> {
    match session.during(gate::ask(ask, question)).await {
        Ok(answer) => answer.map_err(|why| denied(why, lang)),
        Err(AccessError::Interrupted) => Err(interrupted(lang)),
        Err(error) => Err(error.failure(0, None, lang)),
    }
}

/// Asks before anything is opened.
pub(super) async fn off_line<K: Kind>(
    interrupt: &Interrupt,
    ask: &mut dyn Ask,
    question: &Question,
    lang: Lang,
) -> Result<Permit<K>, Failure> {
    let answer = tokio::select! {
        biased;
        answer = gate::ask(ask, question) => answer,
        () = interrupt.raised() => return Err(interrupted(lang)),
    };
    if interrupt.is_raised() { Err(interrupted(lang)) } else { answer.map_err(|why| denied(why, lang)) }
}

fn interrupted(lang: Lang) -> Failure {
    let text =
        lang.pick("interrupted at the question, nothing was sent", "bei der Frage abgebrochen, nichts wurde gesendet");
    Failure::new(Class::Interrupted, "interrupted.question", text)
}

/// The failure to show when there is no permit.
pub(super) fn denied(denied: Denied, lang: Lang) -> Failure {
    match denied {
        Denied::Refused => {
            let text = lang.pick("not confirmed, nothing was sent", "nicht bestätigt, nichts wurde gesendet");
            Failure::new(Class::Forbidden, "forbidden.not_confirmed", text)
        }
        Denied::Nobody => {
            let text = lang.pick(
                "there is no terminal to ask for confirmation, nothing was sent",
                "kein Terminal da, um nachzufragen; nichts wurde gesendet",
            );
            Failure::new(Class::Forbidden, "forbidden.no_terminal", text).hint(lang.pick(
                "--yes answers the question; --dry-run shows what would be sent",
                "--yes beantwortet die Frage; --dry-run zeigt, was gesendet würde",
            ))
        }
    }
}
