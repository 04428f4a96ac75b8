//! What `--port` names: a tty, a port on the network, a CAN adapter at one of these, a recording, or the built-in bench.

use super::Mailbox;
use crate::text::{Wrong, both};
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// Where the drives are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Port {
    /// A serial port by its path or name.
    Serial(String),
    /// `tcp://HOST:PORT`: a device server that passes bytes on as they are. Its serial side is set at the server.
    Tcp(Endpoint),
    /// `rfc2217://HOST:PORT`: a device server whose serial side is set through the connection (RFC 2217).
    Rfc2217(Endpoint),
    /// `mbtcp://HOST[:502]`: a Modbus/TCP gateway.
    Mbtcp(Endpoint),
    /// `slcan:PORT`: a CAN adapter that speaks SLCAN, on a tty or behind `tcp://`.
    Slcan(Box<Port>),
    /// `can:INTERFACE`: a CAN interface of the kernel (Linux).
    Can(String),
    /// `tape:FILE`: a recording that is played back.
    Tape(PathBuf),
    /// The built-in bench: the standard one, or one from a file.
    Sim(Option<PathBuf>),
    /// Somebody beside us, who has a port of his own; nobody types that.
    Beside(Mailbox),
}

/// A TCP port of a host.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Endpoint {
    /// Name or address of the host; an IPv6 address without brackets.
    pub host: String,
    /// TCP port, not 0.
    pub port: u16,
}

/// TCP port of Modbus/TCP (Modbus Messaging on TCP/IP Implementation Guide V1.0b, 3.1.3).
const MODBUS_PORT: u16 = 502;

impl FromStr for Port {
    type Err = Wrong;
    fn from_str(text: &str) -> Result<Self, Wrong> {
        if text.is_empty() {
            return Err(Wrong(both!(
                "the name of the port is empty; expected a tty such as /dev/ttyUSB0, or sim",
                "der Name des Anschlusses ist leer; erwartet: ein Gerät wie /dev/ttyUSB0, oder sim"
            )));
        }
        match text.split_once(':') {
            _ if text == "sim" => Ok(Port::Sim(None)),
            Some(("sim", "")) => {
                Err(Wrong(both!("expected sim:FILE.toml, or just sim", "erwartet: sim:DATEI.toml oder nur sim")))
            }
            Some(("sim", file)) => Ok(Port::Sim(Some(PathBuf::from(file)))),
            Some(("tape", "")) => Err(Wrong(both!(
                "expected tape:FILE, a recording that --trace has written",
                "erwartet: tape:DATEI, eine Aufzeichnung von --trace"
            ))),
            Some(("tape", file)) => Ok(Port::Tape(PathBuf::from(file))),
            Some(("tcp", rest)) => Endpoint::parse("tcp", rest, None).map(Port::Tcp),
            Some(("rfc2217", rest)) => Endpoint::parse("rfc2217", rest, None).map(Port::Rfc2217),
            Some(("mbtcp", rest)) => Endpoint::parse("mbtcp", rest, Some(MODBUS_PORT)).map(Port::Mbtcp),
            Some(("slcan", rest)) => match rest.parse() {
                Ok(port @ (Port::Serial(_) | Port::Tcp(_))) => Ok(Port::Slcan(Box::new(port))),
                _ => Err(Wrong(both!(
                    "expected slcan:TTY such as slcan:/dev/ttyACM0, or slcan:tcp://HOST:PORT; got '{text}'",
                    "erwartet: slcan:GERÄT wie slcan:/dev/ttyACM0, oder slcan:tcp://RECHNER:PORT; angegeben: '{text}'"
                ))),
            },
            Some(("can", _)) if cfg!(not(target_os = "linux")) => Err(Wrong(both!(
                "only Linux has can: ports; expected an adapter such as slcan:COM3",
                "Anschlüsse mit can: gibt es nur unter Linux; erwartet: ein Adapter wie slcan:COM3"
            ))),
            Some(("can", name)) if name.is_empty() || name.contains(['/', '.', ':']) => Err(Wrong(both!(
                "expected can:INTERFACE such as can:can0, got '{text}'",
                "erwartet: can:SCHNITTSTELLE wie can:can0; angegeben: '{text}'"
            ))),
            Some(("can", name)) => Ok(Port::Can(name.to_owned())),
            _ => Ok(Port::Serial(text.to_owned())),
        }
    }
}

impl fmt::Display for Port {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Port::Serial(name) => f.write_str(name),
            Port::Tcp(endpoint) => write!(f, "tcp://{endpoint}"),
            Port::Rfc2217(endpoint) => write!(f, "rfc2217://{endpoint}"),
            Port::Mbtcp(endpoint) => write!(f, "mbtcp://{endpoint}"),
            Port::Slcan(port) => write!(f, "slcan:{port}"),
            Port::Can(name) => write!(f, "can:{name}"),
            Port::Tape(file) => write!(f, "tape:{}", file.display()),
            Port::Sim(None) => f.write_str("sim"),
            Port::Sim(Some(file)) => write!(f, "sim:{}", file.display()),
            Port::Beside(mailbox) => write!(f, "{mailbox}"),
        }
    }
}

impl Endpoint {
    /// Reads what stands behind `SCHEME:`, such as `//192.168.1.50:4001` or `//[fe80::1]:4001`.
    fn parse(scheme: &str, rest: &str, default: Option<u16>) -> Result<Self, Wrong> {
        let port = if default.is_some() { "[:PORT]" } else { ":PORT" };
        let bad = || {
            Wrong(both!(
                "expected {scheme}://HOST{port}, an IPv6 address in brackets; got '{scheme}:{rest}'",
                "erwartet: {scheme}://RECHNER{port}, eine IPv6-Adresse in Klammern; angegeben: '{scheme}:{rest}'"
            ))
        };
        let text = rest.strip_prefix("//").ok_or_else(bad)?;
        let (host, port) = match text.strip_prefix('[').map(|inside| inside.split_once(']')) {
            Some(split) => split.ok_or_else(bad)?,
            None => text.split_at(text.find(':').unwrap_or(text.len())),
        };
        let port = match (port.strip_prefix(':'), default) {
            (Some(number), _) => number.parse().ok().filter(|port| *port != 0).ok_or_else(bad)?,
            (None, Some(default)) if port.is_empty() => default,
            (None, _) => return Err(bad()),
        };
        if host.is_empty() || host.contains(|c: char| c.is_whitespace() || "/[]@".contains(c)) {
            return Err(bad());
        }
        Ok(Endpoint { host: host.to_owned(), port })
    }
}

impl fmt::Display for Endpoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.host.contains(':') {
            write!(f, "[{}]:{}", self.host, self.port)
        } else {
            write!(f, "{}:{}", self.host, self.port)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_port_prints_as_it_is_written() {
        for text in [
            "/dev/ttyUSB0",
            "COM3",
            "tcp://192.168.1.50:4001",
            "tcp://[fe80::1%eth0]:4001",
            "rfc2217://server.local:2217",
            "mbtcp://gateway:1502",
            "slcan:/dev/ttyACM0",
            "slcan:tcp://adapter:3333",
            "can:can0",
            "tape:run.trace",
            "sim",
            "sim:bench.toml",
        ] {
            assert_eq!(text.parse::<Port>().map(|port| port.to_string()), Ok(text.to_owned()));
        }
        assert_eq!("mbtcp://gateway".parse::<Port>().unwrap().to_string(), "mbtcp://gateway:502");
        assert_eq!("mbtcp://[::1]".parse::<Port>().unwrap().to_string(), "mbtcp://[::1]:502");
    }

    #[test]
    fn what_is_no_port_is_told_with_what_was_expected() {
        for text in [
            "tcp://host",
            "tcp:host:1",
            "tcp://:1",
            "tcp://host:0",
            "tcp://host:65536",
            "tcp://host:",
            "tcp://::1:4001",
            "tcp://[::1:4001",
            "rfc2217://[::1]4001",
            "mbtcp://a b",
            "mbtcp://host/unit",
        ] {
            let error = text.parse::<Port>().unwrap_err().to_string();
            assert!(error.contains("HOST") && error.ends_with(&format!("got '{text}'")), "{text}: {error}");
        }
        for text in ["", "tape:", "sim:", "can:", "can:../x", "slcan:", "slcan:sim", "slcan:slcan:x", "slcan:tcp://a"] {
            assert!(text.parse::<Port>().unwrap_err().to_string().contains("expected"), "{text}");
        }
    }
}
