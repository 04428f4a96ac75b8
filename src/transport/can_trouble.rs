//! What can be wrong with a CAN interface of the kernel, each with its own code.

use crate::text::{Text, both};
use std::io;
use std::path::Path;

/// What is wrong with a CAN interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CanTrouble {
    /// There is none of this name.
    Missing,
    /// What has the name is no CAN interface.
    NoCan,
    /// It is not up.
    Down,
    /// The kernel has no CAN.
    Kernel,
    /// The user may not open it.
    Permission,
    /// Its controller has given the bus up.
    BusOff,
    /// It was opened with another bit rate than is meant.
    Rate {
        /// Bits per second that it has.
        is: u32,
        /// Bits per second that it is to have.
        meant: u32,
    },
}

/// What the kernel calls interfaces of this kind (ARPHRD_CAN), and the flag of one that is up (IFF_UP).
const KIND: &str = "280";
const UP: u32 = 1;

impl CanTrouble {
    /// What the kernel tells of its interfaces, in files below `interfaces`, before one is opened.
    pub(super) fn of_interface(interfaces: &Path, name: &str) -> Option<Self> {
        let told = |what: &str| std::fs::read_to_string(interfaces.join(name).join(what)).ok();
        let Some(kind) = told("type") else { return Some(CanTrouble::Missing) };
        let flags = told("flags").and_then(|flags| u32::from_str_radix(flags.trim().trim_start_matches("0x"), 16).ok());
        match kind.trim() == KIND {
            false => Some(CanTrouble::NoCan),
            true if flags.is_some_and(|flags| flags & UP == 0) => Some(CanTrouble::Down),
            true => None,
        }
    }

    /// What the kernel says when one is opened, or used; `None` for what is nothing of a bus.
    pub(super) fn of_system(error: &io::Error) -> Option<Self> {
        match error.raw_os_error() {
            Some(libc::ENODEV | libc::ENXIO) => Some(CanTrouble::Missing),
            Some(libc::ENETDOWN) => Some(CanTrouble::Down),
            Some(libc::EAFNOSUPPORT | libc::EPROTONOSUPPORT) => Some(CanTrouble::Kernel),
            Some(libc::EACCES | libc::EPERM) => Some(CanTrouble::Permission),
            _ => None,
        }
    }

    /// Its code.
    pub fn code(self) -> &'static str {
        match self {
            CanTrouble::Missing => "port.not_found",
            CanTrouble::NoCan => "port.no_can",
            CanTrouble::Down => "port.can_down",
            CanTrouble::Kernel => "port.can_kernel",
            CanTrouble::Permission => "port.permission",
            CanTrouble::BusOff => "port.bus_off",
            CanTrouble::Rate { .. } => "port.can_rate",
        }
    }

    /// What is said of it.
    pub fn told(self, port: &str) -> Text {
        match self {
            CanTrouble::Missing => {
                both!("there is no CAN interface '{port}'", "es gibt keine CAN-Schnittstelle '{port}'")
            }
            CanTrouble::NoCan => {
                both!(
                    "'{port}' is a network interface, but none of a CAN bus",
                    "'{port}' ist eine Netzwerkschnittstelle, aber keine für CAN"
                )
            }
            CanTrouble::Down => {
                both!("the CAN interface '{port}' is down", "die CAN-Schnittstelle '{port}' ist abgeschaltet")
            }
            CanTrouble::Kernel => {
                both!("this kernel has no CAN, for '{port}'", "dieser Kernel kann kein CAN, für '{port}'")
            }
            CanTrouble::Permission => {
                both!(
                    "no permission to open the CAN interface '{port}'",
                    "keine Berechtigung, die CAN-Schnittstelle '{port}' zu öffnen"
                )
            }
            CanTrouble::BusOff => both!(
                "the controller of '{port}' has given the bus up (bus off)",
                "der Controller von '{port}' hat den Bus aufgegeben (Bus-Off)"
            ),
            CanTrouble::Rate { is, meant } => both!(
                "the CAN interface '{port}' was opened with {is} bit/s, and {meant} bit/s are meant; nothing was sent",
                "die CAN-Schnittstelle '{port}' ist mit {is} bit/s geöffnet, gemeint sind {meant} bit/s; es wurde nichts gesendet"
            ),
        }
    }

    /// What to do next.
    pub fn hint(self, port: &str) -> Text {
        let name = port.trim_start_matches("can:");
        match self {
            CanTrouble::Missing => both!(
                "`ip -br link show type can` lists them; an adapter that speaks SLCAN is no interface: -p slcan:/dev/ttyACM0",
                "`ip -br link show type can` listet sie; ein Adapter, der SLCAN spricht, ist keine Schnittstelle: -p slcan:/dev/ttyACM0"
            ),
            CanTrouble::NoCan => both!(
                "`ip -br link show type can` lists those of CAN",
                "`ip -br link show type can` listet die von CAN"
            ),
            CanTrouble::Down => both!(
                "as root: `ip link set {name} up type can bitrate 500000`, with the bit rate of the bus (P.903)",
                "als root: `ip link set {name} up type can bitrate 500000`, mit der Bitrate des Busses (P.903)"
            ),
            CanTrouble::Rate { is, meant } => both!(
                "-b {is}, if the bus has that rate; else as root: `ip link set {name} down` and `ip link set {name} up type can bitrate {meant}`",
                "-b {is}, wenn der Bus diese Bitrate hat; sonst als root: `ip link set {name} down` und `ip link set {name} up type can bitrate {meant}`"
            ),
            CanTrouble::Kernel => {
                both!("as root: `modprobe can_raw`", "als root: `modprobe can_raw`")
            }
            CanTrouble::Permission => both!(
                "a container or a sandbox may forbid it; on the machine itself any user may",
                "ein Container oder eine Sandbox kann es verbieten; auf dem Rechner selbst darf es jeder"
            ),
            CanTrouble::BusOff => both!(
                "check bit rate and wiring, then as root: `ip link set {name} down` and `ip link set {name} up`",
                "Bitrate und Verdrahtung prüfen, dann als root: `ip link set {name} down` und `ip link set {name} up`"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_kernel_tells_of_an_interface() {
        let folder = tempfile::tempdir().unwrap();
        for (name, kind, flags) in
            [("can0", "280\n", "0x40041\n"), ("can1", "280\n", "0x40080\n"), ("eth0", "1\n", "0x1003\n")]
        {
            let of = folder.path().join(name);
            std::fs::create_dir(&of).unwrap();
            std::fs::write(of.join("type"), kind).unwrap();
            std::fs::write(of.join("flags"), flags).unwrap();
        }
        let of = |name| CanTrouble::of_interface(folder.path(), name);
        assert_eq!(
            ["can0", "can1", "eth0", "can9"].map(of),
            [None, Some(CanTrouble::Down), Some(CanTrouble::NoCan), Some(CanTrouble::Missing)]
        );
    }

    #[test]
    fn each_trouble_has_its_own_message_and_code() {
        let of = |code| CanTrouble::of_system(&io::Error::from_raw_os_error(code));
        let all = [
            (of(libc::ENODEV), "port.not_found", "there is no CAN interface"),
            (of(libc::ENETDOWN), "port.can_down", "is down"),
            (of(libc::EAFNOSUPPORT), "port.can_kernel", "no CAN"),
            (of(libc::EPERM), "port.permission", "no permission"),
            (Some(CanTrouble::BusOff), "port.bus_off", "bus off"),
            (Some(CanTrouble::Rate { is: 250_000, meant: 500_000 }), "port.can_rate", "with 250000 bit/s"),
        ];
        for (trouble, code, text) in all {
            let trouble = trouble.unwrap();
            assert!(trouble.code() == code && trouble.told("can:can0").en.contains(text), "{code}");
            assert!(!trouble.hint("can:can0").en.contains("can:can0"));
        }
        assert_eq!(of(libc::EIO), None);
    }
}
