//! What is otherwise where the line is a CAN bus.

use crate::args::Settings;
use crate::drive::job::{self, Step};
use crate::drive::{advice, cut_by};
use crate::failure::{Class, Failure};
use crate::outcome::Outcome;
use crate::text::{Text, both};

/// Stations on a bus: nodes 1 to 63 (manual 5.5), and the drive that is the master.
pub(super) const LAST_STATION: u8 = 64;
/// What a question ends with that nobody answers.
const SILENT: &str = "silence.no_reply";

/// No drive has a node from the factory (P.900 = -1), so none is taken unasked.
pub(super) fn no_node() -> Failure {
    let message = both!(
        "expected the node of a drive, got none",
        "erwartet: der Knoten eines Umrichters; es ist keiner angegeben"
    );
    Failure::new(Class::Usage, "usage.address", message).hint(both!(
        "name it with -a, from 1 to 63, or master: it is P.900, and -1 from the factory",
        "mit -a angeben, 1 bis 63 oder master: er steht in P.900, ab Werk -1"
    ))
}

/// Refuses what would cut our own line, and what nobody knows how to write: every answer has four bytes, so no width is found by asking.
pub(super) fn check(settings: &Settings, steps: &[Step]) -> Result<(), Failure> {
    if !settings.is_can() {
        return Ok(());
    }
    if let Some(step) = steps.iter().find(|step| cut_by(settings.protocol).contains(&step.param.id)) {
        return Err(own_line(step.param.id, &step.param.label()));
    }
    match steps.iter().find(|step| step.kind.is_none()) {
        Some(step) => Err(job::no_width(&step.param)),
        None => Ok(()),
    }
}

/// That a parameter would cut our own line, and what does the same and follows.
pub(super) fn own_line(param: u32, label: &str) -> Failure {
    let message = both!(
        "{label} is a setting of the bus that this goes over, and no source tells when it holds; nothing was sent",
        "{label} ist eine Einstellung des Busses, über den dies geht, und keine Quelle nennt, ab wann sie gilt; es wurde nichts gesendet"
    );
    let follows = |verb: &str| {
        both!(
            "`antrieb {verb}` writes it and follows the drive, whenever it holds",
            "`antrieb {verb}` schreibt es und folgt dem Umrichter, wann immer es gilt"
        )
    };
    let hint = match param {
        900 => follows("line set --address N"),
        903 => follows("line set --baud N"),
        923 => follows("protocol set sdo1"),
        _ => both!(
            "over SDO2 (--protocol sdo) it cuts nothing; `antrieb protocol set sdo` switches SDO2 on",
            "über SDO2 (--protocol sdo) trennt es nichts; `antrieb protocol set sdo` schaltet SDO2 ein"
        ),
    };
    Failure::new(Class::Forbidden, "forbidden.own_line", message).hint(hint).with("param", param)
}

/// What to do where a node is silent is another matter than on a serial line.
pub fn advised(outcome: Result<Outcome, Failure>) -> Outcome {
    let mut outcome = outcome.unwrap_or_else(Outcome::from);
    outcome.each_error(&mut |error| {
        if error.code == SILENT {
            error.hint = Some(silent());
        }
    });
    // What failed in part has the code of that, and the hint of what failed first.
    let serial = advice(SILENT);
    let is_silence = |failure: &Failure| failure.code == SILENT || failure.hint.as_deref() == serial.as_ref();
    let failure = outcome.failure.map(|failure| match is_silence(&failure) {
        true => failure.hint(silent()),
        false => failure,
    });
    Outcome { failure, ..outcome }
}

/// What to look at where nobody answers.
pub fn silent() -> Text {
    both!(
        "somebody acknowledges on the bus, so bit rate and wiring fit; check the node (P.900), whether SDO2 is active (P.923; \
         --protocol sdo1 is the way without it), and whether the node is stopped: then only its serial plug answers",
        "jemand bestätigt am Bus, Bitrate und Verdrahtung passen also; den Knoten prüfen (P.900), ob SDO2 aktiv ist (P.923; ohne \
         es geht --protocol sdo1), und ob der Knoten gestoppt ist: dann antwortet nur sein serieller Anschluss"
    )
}
