//! A port that cannot be used: what is wrong with it, and its code.

use super::advice::advised;
use crate::failure::{Class, Failure, GONE, STUCK};
use crate::protocol::modbus::Hex;
use crate::text::{Text, both};
use crate::transport::{LinkError, list_ports};

/// The failure to show when a port cannot be used.
pub(in crate::drive) fn link(error: &LinkError) -> Failure {
    let class = match error {
        LinkError::Recording { .. } => Class::Data,
        LinkError::Unacknowledged { .. } | LinkError::Gone { .. } => Class::Silence,
        _ => Class::Port,
    };
    let failure = match error {
        LinkError::NotFound(port) => {
            let hint = meant(port, &list_ports().iter().map(ToString::to_string).collect::<Vec<_>>());
            Failure::new(class, "port.not_found", said(error)).hint(hint.unwrap_or_else(found_ports))
        }
        LinkError::Setting { port, message } if NO_PORT.iter().any(|said| message.starts_with(said)) => {
            let text = both!("{port} is no serial port", "{port} ist kein serieller Anschluss");
            Failure::new(class, "port.no_serial_port", text).hint(found_ports())
        }
        #[cfg(target_os = "linux")]
        LinkError::Can { port, why } => Failure::new(class, why.code(), said(error)).hint(why.hint(port)),
        // A server that hung up is another matter than an adapter that was unplugged, but the same failure.
        LinkError::Lost(port) if port.contains("://") => {
            Failure { code: "port.lost".to_owned(), ..advised(class, "port.lost_server", said(error)) }
        }
        error => advised(class, code(error), said(error)),
    };
    match error.port() {
        Some(port) => failure.with("port", port),
        None => failure,
    }
}

/// What was perhaps meant by a port that is not there: several of them, or one of those that are, without its folder.
fn meant(typed: &str, found: &[String]) -> Option<Text> {
    if typed.contains(',') && !typed.contains("://") {
        let each = typed.split(',').map(|port| format!("-p {}", port.trim())).collect::<Vec<_>>().join(" ");
        return Some(both!(
            "several ports are several options: {each}",
            "mehrere Anschlüsse sind mehrere Optionen: {each}"
        ));
    }
    let name = typed.to_lowercase();
    let is_it = |port: &&String| port.rsplit('/').next().is_some_and(|last| last.to_lowercase() == name);
    let near = found.iter().find(is_it).filter(|port| *port != typed)?;
    Some(both!("did you mean {near}?", "gemeint ist vielleicht {near}"))
}

/// What the system says of a file that has no line settings (ENOTTY, EISDIR).
const NO_PORT: &[&str] = &["Not a typewriter", "Inappropriate ioctl for device", "Is a directory"];

fn code(error: &LinkError) -> &'static str {
    match error {
        LinkError::NotFound(_) => "port.not_found",
        LinkError::Busy(_) => "port.busy",
        LinkError::Permission(_) => "port.permission",
        LinkError::Setting { .. } => "port.setting",
        LinkError::Direction { .. } => "port.rs485",
        LinkError::Fixed(_) => "port.fixed_line",
        LinkError::NoRfc2217(_) => "port.no_rfc2217",
        LinkError::Unreachable { .. } => "port.unreachable",
        LinkError::Recording { .. } => "data.recording",
        LinkError::OffTape { .. } => "port.recording",
        LinkError::Stuck(_) => STUCK,
        LinkError::Stranger { .. } => "port.stranger",
        LinkError::Lost(_) => "port.lost",
        LinkError::Gone { .. } => GONE,
        #[cfg(target_os = "linux")]
        LinkError::Can { why, .. } => why.code(),
        LinkError::Unsent(_) => "port.can_unsent",
        LinkError::Unacknowledged { .. } => "silence.no_acknowledge",
    }
}

/// The error in both languages; what the system or a driver said of it is quoted.
fn said(error: &LinkError) -> Text {
    match error {
        LinkError::NotFound(port) => both!("{error}", "es gibt keinen Anschluss '{port}'"),
        LinkError::Busy(port) => both!("{error}", "Anschluss '{port}' wird von einem anderen Programm benutzt"),
        LinkError::Permission(port) => both!("{error}", "keine Berechtigung, Anschluss '{port}' zu öffnen"),
        LinkError::Setting { port, message } => both!("{error}", "Anschluss '{port}': \"{message}\""),
        LinkError::Direction { port, mode, message } => {
            let (mode, german) = (mode.name(), &message.de);
            both!("{error}", "Anschluss '{port}' bietet --rs485 {mode} nicht: {german}")
        }
        LinkError::Fixed(port) => {
            both!("{error}", "die serielle Leitung hinter '{port}' ist von hier nicht einstellbar")
        }
        LinkError::NoRfc2217(port) => both!("{error}", "'{port}' spricht kein RFC 2217"),
        LinkError::Unreachable { port, message } => {
            let german = &message.de;
            both!("{error}", "keine Verbindung zu '{port}': {german}")
        }
        LinkError::Lost(port) => {
            both!("{error}", "Anschluss '{port}' verloren: Adapter abgezogen oder Gegenseite hat aufgelegt")
        }
        #[cfg(target_os = "linux")]
        LinkError::Can { port, why } => why.told(port),
        LinkError::Unsent(port) => both!("{error}", "der CAN-Adapter an '{port}' lehnt es ab, einen Frame zu senden"),
        LinkError::Unacknowledged { port, flags } => both!(
            "{error}",
            "der CAN-Adapter an '{port}' meldet Fehler (Statusbits {flags:02X}h): niemand am Bus bestätigt seine Frames"
        ),
        LinkError::Gone { why, .. } => why.clone(),
        LinkError::Stuck(port) => {
            both!("{error}", "Anschluss '{port}' nimmt keine Bytes an: niemand holt sie dort ab")
        }
        LinkError::Stranger { port, found } => {
            both!("{error}", "Anschluss '{port}' ist jetzt ein anderer Adapter: {found}")
        }
        LinkError::Recording { file, message } => {
            let (file, german) = (file.display(), &message.de);
            both!("{error}", "Aufzeichnung {file}: {german}")
        }
        LinkError::OffTape { file, line, expected, sent } => {
            let (file, expected, sent) = (file.display(), Hex(expected), Hex(sent));
            both!("{error}", "Aufzeichnung {file}, Zeile {line}: aufgezeichnet ist {expected}, gesendet wurde {sent}")
        }
    }
}

/// What ports there are, for a hint.
pub(in crate::drive) fn found_ports() -> Text {
    let ports: Vec<String> = list_ports().iter().map(ToString::to_string).collect();
    let found = match ports.is_empty() {
        true => both!("no serial port was found", "es wurde kein serieller Anschluss gefunden"),
        false => both!("found: {ports}", "gefunden: {ports}", ports = ports.join(", ")),
    };
    both!("{found}; `--port sim` is the built-in bench", "{found}; `--port sim` ist der eingebaute Prüfstand", found)
}

#[cfg(test)]
mod tests {
    use super::meant;
    use crate::text::Lang;

    #[test]
    fn a_port_that_is_not_there_leads_to_the_one_that_was_meant() {
        let found = ["/dev/ttyS0".to_owned(), "/dev/ttyUSB1".to_owned()];
        let hint = |typed| meant(typed, &found).map(|hint| Lang::ALL.map(|lang| hint.get(lang).to_owned()));
        assert!(hint("ttyS0").is_some_and(|hint| hint.iter().all(|hint| hint.contains("/dev/ttyS0"))));
        assert!(hint("ttyusb1").is_some_and(|hint| hint.iter().all(|hint| hint.contains("/dev/ttyUSB1"))));
        assert!(hint("A,B").is_some_and(|hint| hint.iter().all(|hint| hint.contains("-p A -p B"))));
        assert_eq!(hint("ttyACM0"), None);
        assert_eq!(hint("tcp://a,b:1"), None);
    }
}
