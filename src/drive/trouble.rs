//! What went wrong, said in both languages, with what to do next.

mod aborts;
mod advice;
mod port;

use super::access::{AccessError, Refusal};
use super::decode::wrong;
use super::route::No;
use crate::exchange::ExchangeError;
use crate::failure::{Class, Failure};
use crate::profile::{Cause, Family};
use crate::protocol::modbus::Hex;
use crate::text::{Text, both};
pub use advice::advice;
use advice::advised;

pub(super) use port::{found_ports, link};

impl AccessError {
    /// The failure to show for a question to `address`, or with 0 for what no drive was asked. `family` knows the texts of
    /// the error register.
    pub fn failure(&self, address: u8, family: Option<&Family>) -> Failure {
        let failure = match self {
            AccessError::Refused(refusal) => refused(refusal, address, family),
            AccessError::Exchange(error) => exchange(error, address),
            AccessError::Unspeakable => unspeakable(),
            AccessError::Link(error) => link(error),
            AccessError::Interrupted => interrupted(),
        };
        if address == 0 { failure } else { failure.with("address", address) }
    }
}

fn refused(refusal: &Refusal, address: u8, family: Option<&Family>) -> Failure {
    if let No::Pkw(pwe) = refusal.no {
        return super::profibus::refused(address, pwe);
    }
    let row = refusal.cause.and_then(|code| family?.error(code.into()));
    let (where_key, where_text) = match family.map(|family| family.link.cause) {
        _ if matches!(refusal.no, No::Abort(_)) => ("abort", both!("code", "Code")),
        Some(Cause::Diagnostics(_)) => ("sync_error", both!("synchronous error", "synchroner Fehler")),
        _ => ("p11", Text::name("P.11")),
    };
    let said = match refusal.no {
        No::Exception(exception) => wrong::exception(exception),
        No::Nak => Text::name("NAK"),
        No::Abort(code) => wrong::abort(code),
        No::Pkw(pwe) => super::profibus::no(pwe),
    };
    let (code, cause) = match (refusal.cause, row) {
        (Some(0) | None, _) => {
            let code = match refusal.no {
                No::Exception(exception) => exception.name().replace(' ', "_"),
                No::Nak => "nak".to_owned(),
                No::Abort(_) => "abort".to_owned(),
                No::Pkw(_) => "pkw".to_owned(),
            };
            let unheard = both!(", cause not known", ", Ursache unbekannt");
            (code, if refusal.unheard { unheard } else { Text::default() })
        }
        (Some(code), Some(row)) => (
            row.slug.clone(),
            both!(", {place} = {code}: {name}", ", {place} = {code}: {name}", place = where_text, name = row.text()),
        ),
        (Some(code), None) => {
            let told =
                both!(", {place} = {code} (unknown code)", ", {place} = {code} (unbekannter Code)", place = where_text);
            (format!("error_{code}"), told)
        }
    };
    let stands = match refusal.taken {
        Some(true) => both!(
            "; read back, what was written stands there all the same",
            "; zurückgelesen steht das Geschriebene trotzdem dort"
        ),
        Some(false) => {
            both!(
                "; read back, what was written does not stand there",
                "; zurückgelesen steht das Geschriebene nicht dort"
            )
        }
        None => Text::default(),
    };
    let message = both!(
        "drive {address} refused: {said}{cause}{stands}",
        "Antrieb {address} lehnt ab: {said}{cause}{stands}",
        said,
        cause,
        stands
    );
    let mut failure = Failure::new(Class::Refused, format!("refused.{}", code.replace('-', "_")), message);
    if let No::Exception(exception) = refusal.no {
        failure = failure.with("exception", exception.code());
    }
    if let Some(cause) = refusal.cause {
        failure = failure.with(where_key, cause);
    }
    let unknown = match refusal.cause {
        None if refusal.unheard => both!(
            "the answer that told the cause was lost, and reading clears it: try again, and `antrieb diag line` shows why answers \
             are lost",
            "die Antwort mit der Ursache ging verloren, und Lesen löscht sie: noch einmal versuchen; `antrieb diag line` zeigt, warum \
             Antworten verloren gehen"
        ),
        None if let No::Abort(code) = refusal.no => aborts::hint(code),
        None => both!(
            "the drive gave no cause; check the function code, the parameter and the value",
            "der Antrieb nennt keine Ursache; Funktionscode, Parameter und Wert prüfen"
        ),
        Some(_) => both!(
            "the drive's own manual explains the number; check the parameter and the value",
            "die Nummer erklärt das Handbuch des Antriebs; Parameter und Wert prüfen"
        ),
    };
    failure.hint(row.map_or(unknown, |row| row.hint.clone()))
}

fn unspeakable() -> Failure {
    let text = both!(
        "the protocol on this line has no telegram for this",
        "das Protokoll dieser Leitung hat dafür kein Telegramm"
    );
    Failure::new(Class::Data, "data.no_telegram", text).hint(both!(
        "parameter numbers, addresses and data sets have limits; strings travel only over VABus",
        "Parameternummern, Adressen und Datensätze haben Grenzen; Strings gehen nur über VABus"
    ))
}

/// Somebody speaks on the line all the time.
pub(super) fn never_silent(message: Text) -> Failure {
    advised(Class::Garbled, "garbled.never_silent", message)
}

/// What a station that was asked has not answered as it should.
fn exchange(error: &ExchangeError, address: u8) -> Failure {
    let (class, code) = sorted(error, address);
    let of = (class != Class::Usage).then_some(address);
    let failure = Failure { of, ..advised(class, code, said(error, address)) };
    match error {
        ExchangeError::Garbled { bytes, .. } => failure.with("bytes", Hex(bytes)),
        ExchangeError::Stray { station } => failure.with("responder", station),
        _ => failure,
    }
}

fn sorted(error: &ExchangeError, address: u8) -> (Class, &'static str) {
    match error {
        ExchangeError::Silence { .. } => (Class::Silence, "silence.no_reply"),
        ExchangeError::Unreached => (Class::Silence, "silence.gateway"),
        ExchangeError::Garbled { .. } => (Class::Garbled, "garbled.no_valid_reply"),
        ExchangeError::Short { .. } => (Class::Garbled, "garbled.short"),
        ExchangeError::Pieces { .. } => (Class::Garbled, "garbled.in_pieces"),
        ExchangeError::Stray { station } if *station == address => (Class::Garbled, "garbled.wrong_answer"),
        ExchangeError::Stray { .. } => (Class::Garbled, "garbled.wrong_responder"),
        ExchangeError::NeverSilent { .. } => (Class::Garbled, "garbled.never_silent"),
        ExchangeError::Unproven { .. } => (Class::Garbled, "garbled.unproven"),
        ExchangeError::NoTime { .. } => (Class::Silence, NO_TIME),
        ExchangeError::TwoAnswers { .. } => (Class::Garbled, "garbled.two_answers"),
        ExchangeError::BroadcastRead => (Class::Usage, "usage.broadcast_read"),
    }
}

/// In words: what came, and how often was asked where that tells something.
fn said(error: &ExchangeError, address: u8) -> Text {
    let (what, asked) = match error {
        ExchangeError::Silence { timeout, asked } => {
            (both!("no reply within {timeout}", "keine Antwort innerhalb von {timeout}"), Some(*asked))
        }
        ExchangeError::Unreached => {
            (both!("the gateway got no answer from the station", "das Gateway bekam keine Antwort der Station"), None)
        }
        ExchangeError::Garbled { asked, bytes } => (came_garbled(*asked, bytes.len()), None),
        ExchangeError::Short { asked, bytes } => (
            both!(
                "answers with {came}, where every SDO has 8",
                "antwortet mit {came}, wo jedes SDO 8 hat",
                came = Text::count((*bytes).into(), ["byte", "bytes"], ["Byte", "Bytes"])
            ),
            Some(*asked),
        ),
        ExchangeError::Pieces { asked } => (
            both!(
                "answers that the value follows in pieces, which no drive does: all that it has fits in one frame",
                "kündigt den Wert in Teilstücken an, was kein Umrichter tut: bei ihm passt alles in einen Frame"
            ),
            Some(*asked),
        ),
        ExchangeError::Stray { station } if *station == address => (
            both!(
                "answers with a telegram that does not fit the question",
                "antwortet mit einem Telegramm, das nicht zur Frage passt"
            ),
            None,
        ),
        ExchangeError::Stray { station } => (
            both!(
                "station {station} answered in place of the one that was asked",
                "statt der gefragten antwortet Station {station}"
            ),
            None,
        ),
        ExchangeError::NeverSilent { asked } => {
            (both!("the line is never silent", "die Leitung schweigt nie"), Some(*asked))
        }
        ExchangeError::Unproven { asked } => (
            both!(
                "answers came, but each may be one to an older question",
                "Antworten kamen, aber jede kann einer älteren Frage gelten"
            ),
            Some(*asked),
        ),
        ExchangeError::NoTime { asked: 0 } => (both!("no time was left to ask", "zum Fragen blieb keine Zeit"), None),
        ExchangeError::NoTime { asked } => (
            both!("no answer came in the time that was left", "in der Zeit, die blieb, kam keine Antwort"),
            Some(*asked),
        ),
        ExchangeError::TwoAnswers { .. } => {
            (both!("more than one answer came to one question", "auf eine Frage kam mehr als eine Antwort"), None)
        }
        ExchangeError::BroadcastRead => {
            return both!("a broadcast can only write", "an alle kann nur geschrieben werden");
        }
    };
    asked.map_or_else(|| what.clone(), |asked| Text::join([&what, &times(asked)], ", "))
}

fn came_garbled(asked: impl Into<u64>, bytes: usize) -> Text {
    both!(
        "no valid reply, {times}; {bytes} bytes of garbage came",
        "keine gültige Antwort, {times}; {bytes} gestörte Bytes",
        times = times(asked)
    )
}

fn times(asked: impl Into<u64>) -> Text {
    match asked.into() {
        1 => both!("asked once", "einmal gefragt"),
        asked => both!("asked {asked} times", "{asked}-mal gefragt"),
    }
}

/// The failure to show when somebody pressed Ctrl-C.
pub(super) fn interrupted() -> Failure {
    let text = both!("interrupted before the answer came", "unterbrochen, bevor die Antwort kam");
    Failure::new(Class::Interrupted, "interrupted", text)
}

/// A question was over before it could go out.
pub(super) const NO_TIME: &str = "silence.no_time";
/// The time of a run was over before the drive was where it was to go.
pub(super) const TIME_OVER: &str = "no.time_over";

/// The failure of such a run.
pub(super) fn time_over() -> Failure {
    let text = both!(
        "the time of the run (--duration) was over before the drive was there",
        "die Zeit des Laufs (--duration) war um, ehe der Antrieb so weit war"
    );
    Failure::new(Class::No, TIME_OVER, text).hint(both!(
        "choose a longer --duration: it begins with the first word that can turn the shaft",
        "--duration länger wählen: sie beginnt mit dem ersten Wort, das die Welle drehen kann"
    ))
}
