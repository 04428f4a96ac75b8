//! What went wrong, said in both languages, with what to do next.

use super::access::{AccessError, Refusal};
use super::decode::wrong;
use super::route::No;
use crate::exchange::ExchangeError;
use crate::failure::{Class, Failure};
use crate::profile::{Cause, Family};
use crate::protocol::modbus::Hex;
use crate::text::{Text, both};
use crate::transport::{LinkError, list_ports};

impl AccessError {
    /// The failure to show for a question to `address`. `family` knows the texts of the error register.
    pub fn failure(&self, address: u8, family: Option<&Family>) -> Failure {
        match self {
            AccessError::Refused(refusal) => refused(refusal, address, family),
            AccessError::Exchange(error) => exchange(error, address),
            AccessError::Unspeakable => unspeakable(),
            AccessError::Link(error) => link(error),
            AccessError::Interrupted => interrupted(),
        }
        .with("address", address)
    }
}

fn refused(refusal: &Refusal, address: u8, family: Option<&Family>) -> Failure {
    let row = refusal.cause.and_then(|code| family?.error(code.into()));
    let (where_key, where_text) = match family.map(|family| family.link.cause) {
        Some(Cause::Diagnostics(_)) => ("sync_error", both!("synchronous error", "synchroner Fehler")),
        _ => ("p11", Text::name("P.11")),
    };
    let said = match refusal.no {
        No::Exception(exception) => wrong::exception(exception),
        No::Nak => Text::name("NAK"),
    };
    let (code, cause) = match (refusal.cause, row) {
        (Some(0) | None, _) => {
            let code = match refusal.no {
                No::Exception(exception) => exception.name().replace(' ', "_"),
                No::Nak => "nak".to_owned(),
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
    let message =
        both!("drive {address} refused: {said}{cause}", "Antrieb {address} lehnt ab: {said}{cause}", said, cause);
    let mut failure = Failure::new(Class::Refused, format!("refused.{}", code.replace('-', "_")), message);
    if let No::Exception(exception) = refusal.no {
        failure = failure.with("exception", exception.code());
    }
    if let Some(cause) = refusal.cause {
        failure = failure.with(where_key, cause);
    }
    let unknown = match refusal.cause {
        None if refusal.unheard => both!(
            "the answer that told the cause was lost, and reading clears it: try again, and `diag line` shows why answers \
             are lost",
            "die Antwort mit der Ursache ging verloren, und Lesen löscht sie: noch einmal versuchen; `diag line` zeigt, warum \
             Antworten verloren gehen"
        ),
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
    Failure::new(Class::Garbled, "garbled.never_silent", message).hint(both!(
        "another master, two drives at one address, or a wrong baud rate? `antrieb sniff` shows what is said",
        "ein zweiter Master, zwei Antriebe mit einer Adresse oder eine falsche Baudrate? `antrieb sniff` zeigt, was \
         gesprochen wird"
    ))
}

fn times(asked: impl Into<u64>) -> Text {
    match asked.into() {
        1 => both!("asked once", "einmal gefragt"),
        asked => both!("asked {asked} times", "{asked}-mal gefragt"),
    }
}

fn exchange(error: &ExchangeError, address: u8) -> Failure {
    let at = both!("address {address}", "Adresse {address}");
    match error {
        ExchangeError::Silence { timeout, asked } => {
            let message = both!(
                "{at}: no reply within {timeout}, {times}",
                "{at}: keine Antwort innerhalb von {timeout}, {times}",
                at,
                times = times(*asked)
            );
            Failure::new(Class::Silence, "silence.no_reply", message).hint(both!(
                "check address, baud rate, parity and protocol (P.395; a drive leaves the factory speaking VABus, not \
                 Modbus), whether A and B are swapped, termination, and whether another master is on the bus; \
                 `antrieb scan` asks every address",
                "Adresse, Baudrate, Parität und Protokoll prüfen (P.395; ab Werk spricht der Antrieb VABus, nicht \
                 Modbus), ferner vertauschte Adern A und B, Abschluss und ob ein zweiter Master am Bus ist; \
                 `antrieb scan` fragt alle Adressen"
            ))
        }
        ExchangeError::Unreached => {
            let said =
                both!("the gateway got no answer from the station", "das Gateway bekam keine Antwort der Station");
            Failure::new(Class::Silence, "silence.gateway", both!("{at}: {said}", "{at}: {said}", at, said)).hint(
                both!(
                    "check the address, and the serial setting of the gateway",
                    "Adresse und serielle Einstellung des Gateways prüfen"
                ),
            )
        }
        ExchangeError::Garbled { asked, bytes } => {
            let message = both!(
                "{at}: no valid reply, {times}; {bytes} bytes of garbage came",
                "{at}: keine gültige Antwort, {times}; {bytes} gestörte Bytes",
                at,
                times = times(*asked),
                bytes = bytes.len()
            );
            Failure::new(Class::Garbled, "garbled.no_valid_reply", message)
                .hint(both!(
                    "check baud rate and parity, two drives with the same address, termination and shielding",
                    "Baudrate und Parität, doppelt vergebene Adressen, Abschluss und Schirmung prüfen"
                ))
                .with("bytes", Hex(bytes))
        }
        ExchangeError::Stray { station } => {
            let (code, message) = match *station == address {
                true => (
                    "garbled.wrong_answer",
                    both!(
                        "{at}: answers with a telegram that does not fit the question",
                        "{at}: antwortet mit einem Telegramm, das nicht zur Frage passt",
                        at
                    ),
                ),
                false => (
                    "garbled.wrong_responder",
                    both!(
                        "{at}: station {station} answered in place of the one that was asked",
                        "{at}: statt der gefragten antwortet Station {station}",
                        at
                    ),
                ),
            };
            Failure::new(Class::Garbled, code, message)
                .hint(both!(
                    "-v shows the telegrams; is it a drive of this family, or is another master on the bus?",
                    "-v zeigt die Telegramme; ist es ein Antrieb dieser Familie, oder ist ein zweiter Master am Bus?"
                ))
                .with("responder", station)
        }
        ExchangeError::NeverSilent { asked } => {
            let message = both!(
                "{at}: the line is never silent, {times}",
                "{at}: die Leitung schweigt nie, {times}",
                at,
                times = times(*asked)
            );
            never_silent(message)
        }
        ExchangeError::Unproven { asked } => {
            let message = both!(
                "{at}: answers came, but each may be one to an older question, {times}",
                "{at}: Antworten kamen, aber jede kann einer älteren Frage gelten, {times}",
                at,
                times = times(*asked)
            );
            Failure::new(Class::Garbled, "garbled.unproven", message).hint(both!(
                "replies come late, twice or from somebody else: a longer --timeout, and look for a second master, a \
                 repeater or two drives with one address",
                "Antworten kommen spät, doppelt oder von anderen: --timeout verlängern und nach einem zweiten Master, \
                 einem Repeater oder zwei Antrieben mit einer Adresse suchen"
            ))
        }
        ExchangeError::TwoAnswers { .. } => {
            let said = both!("more than one answer came to one question", "auf eine Frage kam mehr als eine Antwort");
            Failure::new(Class::Garbled, "garbled.two_answers", both!("{at}: {said}", "{at}: {said}", at, said)).hint(both!("two drives answer at this address, or another master asks the same drive: leave one drive on the line and \
                 give it another address", "zwei Antriebe antworten unter dieser Adresse, oder ein zweiter Master fragt denselben: nur einen Antrieb am \
                 Bus lassen und ihm eine andere Adresse geben"))
        }
        ExchangeError::BroadcastRead => {
            let message = both!("a broadcast can only write", "an alle kann nur geschrieben werden");
            Failure::new(Class::Usage, "usage.broadcast_read", message)
                .hint(both!("name one drive to read from", "zum Lesen einen Antrieb nennen"))
        }
    }
}

/// The failure to show when somebody pressed Ctrl-C.
pub(super) fn interrupted() -> Failure {
    let text = both!("interrupted before the answer came", "unterbrochen, bevor die Antwort kam");
    Failure::new(Class::Interrupted, "interrupted", text)
}

/// The failure to show when a port cannot be used.
pub(super) fn link(error: &LinkError) -> Failure {
    let german = match error {
        LinkError::NotFound(port) => format!("es gibt keinen Anschluss '{port}'"),
        LinkError::Busy(port) => format!("Anschluss '{port}' wird von einem anderen Programm benutzt"),
        LinkError::Permission(port) => format!("keine Berechtigung, Anschluss '{port}' zu öffnen"),
        LinkError::Setting { port, message } => format!("Anschluss '{port}': {message}"),
        LinkError::Direction { port, mode, message } => {
            format!("Anschluss '{port}' bietet --rs485 {} nicht: {message}", mode.name())
        }
        LinkError::Fixed(port) => format!("die serielle Leitung hinter '{port}' ist von hier nicht einstellbar"),
        LinkError::NoRfc2217(port) => format!("'{port}' spricht kein RFC 2217"),
        LinkError::Unreachable { port, message } => format!("keine Verbindung zu '{port}': {message}"),
        LinkError::Lost(port) => {
            format!("Anschluss '{port}' verloren: Adapter abgezogen oder Gegenseite hat aufgelegt")
        }
        LinkError::Stuck(port) => format!("Anschluss '{port}' nimmt keine Bytes an: niemand holt sie dort ab"),
        LinkError::Stranger { port, found } => {
            format!("Anschluss '{port}' ist jetzt ein anderer Adapter: {found}")
        }
        LinkError::Recording { file, message } => format!("Aufzeichnung {}: {}", file.display(), message.de),
        LinkError::OffTape { file, line, expected, sent } => {
            let (file, expected, sent) = (file.display(), Hex(expected), Hex(sent));
            format!("Aufzeichnung {file}, Zeile {line}: aufgezeichnet ist {expected}, gesendet wurde {sent}")
        }
    };
    let message = Text { en: error.to_string().into(), de: german.into() };
    let (code, hint) = match error {
        LinkError::NotFound(_) => ("port.not_found", found_ports()),
        LinkError::Busy(_) => (
            "port.busy",
            both!(
                "close the other program; ModemManager and brltty grab adapters on Linux (`fuser -v PORT`)",
                "das andere Programm schließen; unter Linux greifen ModemManager und brltty nach Adaptern (`fuser -v PORT`)"
            ),
        ),
        LinkError::Permission(_) => (
            "port.permission",
            both!(
                "join the group that owns the port, usually `sudo usermod -aG dialout $USER`, and log in again",
                "der Gruppe des Anschlusses beitreten, meist `sudo usermod -aG dialout $USER`, und neu anmelden"
            ),
        ),
        LinkError::Setting { .. } => (
            "port.setting",
            both!(
                "is it a serial port, and can it do this speed?",
                "ist es ein serieller Anschluss, und kann er diese Geschwindigkeit?"
            ),
        ),
        LinkError::Direction { .. } => (
            "port.rs485",
            both!(
                "--rs485 adapter leaves the direction to the adapter, as most USB adapters want it",
                "--rs485 adapter überlässt die Richtung dem Adapter, wie es die meisten USB-Adapter wollen"
            ),
        ),
        LinkError::Fixed(_) => (
            "port.fixed_line",
            both!(
                "set speed and parity at the device server, or use rfc2217:// where it offers that",
                "Geschwindigkeit und Parität am Geräteserver einstellen, oder rfc2217:// verwenden, wo er es anbietet"
            ),
        ),
        LinkError::NoRfc2217(_) => (
            "port.no_rfc2217",
            both!(
                "is it the raw port of the device server? Then it is tcp://HOST:PORT",
                "ist es der rohe Port des Geräteservers? Dann heißt er tcp://RECHNER:PORT"
            ),
        ),
        LinkError::Unreachable { .. } => (
            "port.unreachable",
            both!(
                "check host and TCP port; many device servers accept one connection at a time",
                "Rechner und TCP-Port prüfen; viele Geräteserver nehmen nur eine Verbindung zugleich an"
            ),
        ),
        LinkError::Recording { .. } => (
            "data.recording",
            both!("`--trace FILE` writes such a recording", "`--trace DATEI` schreibt eine solche Aufzeichnung"),
        ),
        LinkError::OffTape { .. } => (
            "port.recording",
            both!(
                "play it back with the command, the options and the version that recorded it",
                "mit dem Befehl, den Optionen und der Version abspielen, mit denen aufgezeichnet wurde"
            ),
        ),
        LinkError::Stuck(_) => (
            "port.stuck",
            both!(
                "plug the adapter in again; if it is a device server, is its serial side stopped by a handshake?",
                "den Adapter neu einstecken; bei einem Geräteserver: hält ein Handshake seine serielle Seite an?"
            ),
        ),
        LinkError::Stranger { .. } => (
            "port.stranger",
            both!(
                "plug the first adapter in again, or start anew with -p; /dev/serial/by-id names an adapter for good",
                "den ersten Adapter wieder einstecken oder mit -p neu beginnen; /dev/serial/by-id benennt ihn für immer"
            ),
        ),
        LinkError::Lost(port) if port.contains("://") => (
            "port.lost",
            both!(
                "is the server still there? Many device servers accept one connection at a time, and drop an idle one",
                "ist der Server noch da? Viele Geräteserver nehmen nur eine Verbindung zugleich an und trennen eine stille"
            ),
        ),
        LinkError::Lost(_) => (
            "port.lost",
            both!(
                "plug the adapter in again; under /dev/serial/by-id it keeps its name",
                "den Adapter wieder einstecken; unter /dev/serial/by-id behält er seinen Namen"
            ),
        ),
    };
    let class = if matches!(error, LinkError::Recording { .. }) { Class::Data } else { Class::Port };
    Failure::new(class, code, message).hint(hint)
}

/// What ports there are, for a hint.
pub(super) fn found_ports() -> Text {
    let ports: Vec<String> = list_ports().iter().map(ToString::to_string).collect();
    let found = match ports.is_empty() {
        true => both!("no serial port was found", "es wurde kein serieller Anschluss gefunden"),
        false => both!("found: {ports}", "gefunden: {ports}", ports = ports.join(", ")),
    };
    both!("{found}; `--port sim` is the built-in bench", "{found}; `--port sim` ist der eingebaute Prüfstand", found)
}
