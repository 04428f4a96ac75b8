//! What went wrong, said in both languages, with what to do next.

use super::session::{AccessError, Refusal};
use crate::exchange::modbus::ExchangeError;
use crate::failure::{Class, Failure};
use crate::profile::{Family, Lang};
use crate::protocol::modbus::Hex;
use crate::transport::{LinkError, list_ports};

impl AccessError {
    /// The failure to show for a question to `address`. `family` knows the texts of the error register.
    pub fn failure(&self, address: u8, family: Option<&Family>, lang: Lang) -> Failure {
        match self {
            AccessError::Refused(refusal) => refused(refusal, address, family, lang),
            AccessError::Exchange(error) => exchange(error, address, lang),
            AccessError::Link(error) => link(error, lang),
            AccessError::Interrupted => {
                let text = lang.pick("interrupted before the answer came", "unterbrochen, bevor die Antwort kam");
                Failure::new(Class::Interrupted, "interrupted", text)
            }
        }
        .with("address", address)
    }
}

fn refused(refusal: &Refusal, address: u8, family: Option<&Family>, lang: Lang) -> Failure {
    let row = refusal.cause.and_then(|code| family?.error(code.into()));
    let (code, cause) = match (refusal.cause, row) {
        (Some(0) | None, _) => (refusal.exception.name().replace(' ', "_"), String::new()),
        (Some(code), Some(row)) => (row.slug.clone(), format!(", P.11 = {code}: {}", row.name(lang))),
        (Some(code), None) => {
            (format!("error_{code}"), format!(", P.11 = {code} ({})", lang.pick("unknown code", "unbekannter Code")))
        }
    };
    let said = lang.pick("refused: exception", "lehnt ab: Ausnahme");
    let message = format!("{} {address} {said} {}{cause}", lang.pick("drive", "Antrieb"), refusal.exception);
    let failure = Failure::new(Class::Refused, format!("refused.{}", code.replace('-', "_")), message)
        .with("exception", refusal.exception.code());
    let failure = match refusal.cause {
        Some(cause) => failure.with("p11", cause),
        None => failure,
    };
    failure.hint(row.map_or(
        lang.pick(
            "the drive gave no cause; check the function code, the parameter and the value",
            "der Antrieb nennt keine Ursache; Funktionscode, Parameter und Wert prüfen",
        ),
        |row| row.hint.get(lang),
    ))
}

fn exchange(error: &ExchangeError, address: u8, lang: Lang) -> Failure {
    let at = format!("{} {address}", lang.pick("address", "Adresse"));
    match error {
        ExchangeError::Silence { timeout, asked } => {
            let message = match lang {
                Lang::En => format!("{at}: no reply within {timeout}, asked {asked} times"),
                Lang::De => format!("{at}: keine Antwort innerhalb von {timeout}, {asked}-mal gefragt"),
            };
            Failure::new(Class::Silence, "silence.no_reply", message).hint(lang.pick(
                "check address, baud rate, parity and protocol (P.395; a drive leaves the factory speaking VABus, not \
                 Modbus), whether A and B are swapped, termination, and whether another master is on the bus; \
                 `antrieb scan` asks every address",
                "Adresse, Baudrate, Parität und Protokoll prüfen (P.395; ab Werk spricht der Antrieb VABus, nicht \
                 Modbus), ferner vertauschte Adern A und B, Abschluss und ob ein zweiter Master am Bus ist; \
                 `antrieb scan` fragt alle Adressen",
            ))
        }
        ExchangeError::Garbled { asked, bytes } => {
            let message = match lang {
                Lang::En => format!("{at}: no valid reply, asked {asked} times; {} bytes of garbage came", bytes.len()),
                Lang::De => format!("{at}: keine gültige Antwort, {asked}-mal gefragt; {} gestörte Bytes", bytes.len()),
            };
            Failure::new(Class::Garbled, "garbled.no_valid_reply", message)
                .hint(lang.pick(
                    "check baud rate and parity, two drives with the same address, termination and shielding",
                    "Baudrate und Parität, doppelt vergebene Adressen, Abschluss und Schirmung prüfen",
                ))
                .with("bytes", Hex(bytes))
        }
        ExchangeError::Stray { station } => {
            let (code, message) = match (*station == address, lang) {
                (true, Lang::En) => {
                    ("garbled.wrong_answer", format!("{at}: answers with a telegram that does not fit the question"))
                }
                (true, Lang::De) => {
                    ("garbled.wrong_answer", format!("{at}: antwortet mit einem Telegramm, das nicht zur Frage passt"))
                }
                (false, Lang::En) => (
                    "garbled.wrong_responder",
                    format!("{at}: station {station} answered in place of the one that was asked"),
                ),
                (false, Lang::De) => {
                    ("garbled.wrong_responder", format!("{at}: statt der gefragten antwortet Station {station}"))
                }
            };
            Failure::new(Class::Garbled, code, message)
                .hint(lang.pick(
                    "-v shows the telegrams; is it a drive of this family, or is another master on the bus?",
                    "-v zeigt die Telegramme; ist es ein Antrieb dieser Familie, oder ist ein zweiter Master am Bus?",
                ))
                .with("responder", station)
        }
        ExchangeError::BroadcastRead => {
            let message = lang.pick("a broadcast can only write", "an alle kann nur geschrieben werden");
            Failure::new(Class::Usage, "usage.broadcast_read", message)
                .hint(lang.pick("name one drive to read from", "zum Lesen einen Antrieb nennen"))
        }
    }
}

/// The failure to show when a port cannot be used.
pub(super) fn link(error: &LinkError, lang: Lang) -> Failure {
    let message = match (error, lang) {
        (error, Lang::En) => error.to_string(),
        (LinkError::NotFound(port), _) => format!("es gibt keinen Anschluss '{port}'"),
        (LinkError::Busy(port), _) => format!("Anschluss '{port}' wird von einem anderen Programm benutzt"),
        (LinkError::Permission(port), _) => format!("keine Berechtigung, Anschluss '{port}' zu öffnen"),
        (LinkError::Setting { port, message }, _) => format!("Anschluss '{port}': {message}"),
        (LinkError::Lost(port), _) => {
            format!("Anschluss '{port}' verloren: Adapter abgezogen oder Gegenseite hat aufgelegt")
        }
    };
    let (code, hint) = match error {
        LinkError::NotFound(_) => ("port.not_found", found_ports(lang)),
        LinkError::Busy(_) => (
            "port.busy",
            lang.pick(
                "close the other program; ModemManager and brltty grab adapters on Linux (`fuser -v PORT`)",
                "das andere Programm schließen; unter Linux greifen ModemManager und brltty nach Adaptern (`fuser -v PORT`)",
            )
            .to_owned(),
        ),
        LinkError::Permission(_) => (
            "port.permission",
            lang.pick(
                "join the group that owns the port, usually `sudo usermod -aG dialout $USER`, and log in again",
                "der Gruppe des Anschlusses beitreten, meist `sudo usermod -aG dialout $USER`, und neu anmelden",
            )
            .to_owned(),
        ),
        LinkError::Setting { .. } => (
            "port.setting",
            lang.pick(
                "is it a serial port, and can it do this speed?",
                "ist es ein serieller Anschluss, und kann er diese Geschwindigkeit?",
            )
            .to_owned(),
        ),
        LinkError::Lost(_) => (
            "port.lost",
            lang.pick(
                "plug the adapter in again; under /dev/serial/by-id it keeps its name",
                "den Adapter wieder einstecken; unter /dev/serial/by-id behält er seinen Namen",
            )
            .to_owned(),
        ),
    };
    Failure::new(Class::Port, code, message).hint(hint)
}

/// What ports there are, for a hint.
pub(super) fn found_ports(lang: Lang) -> String {
    let ports = list_ports().into_iter().map(|port| format!("{} {}", port.name, port.about).trim().to_owned());
    let ports: Vec<_> = ports.collect();
    let found = match (ports.is_empty(), lang) {
        (true, Lang::En) => "no serial port was found".to_owned(),
        (true, Lang::De) => "es wurde kein serieller Anschluss gefunden".to_owned(),
        (false, Lang::En) => format!("found: {}", ports.join(", ")),
        (false, Lang::De) => format!("gefunden: {}", ports.join(", ")),
    };
    format!("{found}; {}", lang.pick("`--port sim` is the built-in bench", "`--port sim` ist der eingebaute Prüfstand"))
}
