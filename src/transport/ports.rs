//! The serial ports of this machine, and which adapter stands behind each.
//!
//! A name says where the system happened to put an adapter: the next one that is plugged in may get it. What an adapter
//! *is* stands in its USB descriptors: maker, product, serial number, interface. On Linux they are read from `/sys`; the
//! root of that tree is a value, so that a tree of a test is read as well as that of the machine.

use std::path::{Path, PathBuf};

/// A port of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PortInfo {
    /// Path or name to open it.
    pub name: String,
    /// What is plugged in there, as far as USB tells: `FTDI FT232R USB UART 0403:6001 A50285BI`, the serial number last.
    pub about: String,
    /// The name that goes with the adapter and not with the socket: `/dev/serial/by-id/usb-FTDI_…`.
    pub by_id: Option<String>,
    /// Whether it is a USB adapter.
    pub usb: bool,
    pub(super) identity: Option<Identity>,
}

/// Prints as `/dev/ttyUSB0 FTDI FT232R USB UART 0403:6001 A50285BI (/dev/serial/by-id/usb-FTDI_…)`.
impl std::fmt::Display for PortInfo {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.name)?;
        if !self.about.is_empty() {
            write!(f, " {}", self.about)?;
        }
        self.by_id.as_ref().map_or(Ok(()), |by_id| write!(f, " ({by_id})"))
    }
}

/// A USB adapter, whatever its port is called.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Identity {
    /// `0403:6001`.
    product: String,
    /// Cheap adapters have none, or all the same.
    serial: Option<String>,
    /// One adapter may have several ports.
    interface: Option<u8>,
    /// The socket it is plugged into, where the system tells: `1-1.2`.
    socket: Option<String>,
}

impl Identity {
    /// Whether this may be the same adapter.
    fn is_like(&self, other: &Identity) -> bool {
        (&self.product, &self.serial, self.interface) == (&other.product, &other.serial, other.interface)
    }
}

/// Prints as `0403:6001 A50285BI`.
impl std::fmt::Display for Identity {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let serial = self.serial.as_deref().map_or_else(String::new, |serial| format!(" {serial}"));
        write!(f, "{}{serial}", self.product)
    }
}

/// Where the adapter is that a port had.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Whereabouts {
    /// There, under this name.
    At(String),
    /// Another adapter has the name: this one.
    Stranger(String),
    /// It is not plugged in, or nobody can tell which of several it is.
    Gone,
}

/// The serial ports of this machine, USB adapters first.
pub fn list_ports() -> Vec<PortInfo> {
    Host::default().ports()
}

/// A machine with serial ports.
#[derive(Clone, Debug)]
pub(super) struct Host {
    root: PathBuf,
}

impl Default for Host {
    fn default() -> Self {
        Host { root: "/".into() }
    }
}

impl Host {
    /// The serial ports, USB adapters first.
    pub(super) fn ports(&self) -> Vec<PortInfo> {
        let mut ports = system::ports(&self.root);
        ports.sort_by(|a, b| b.usb.cmp(&a.usb).then_with(|| a.name.cmp(&b.name)));
        ports
    }

    /// The adapter behind a port; `None` of anything but USB.
    pub(super) fn identity(&self, name: &str) -> Option<Identity> {
        self.ports().into_iter().find(|port| same_device(&port.name, name))?.identity
    }

    /// Where the adapter is that was at `name`. By its serial number, whatever it is called now; one without, or of
    /// several with the same, by its socket, and last by its name if that leads to one of its kind.
    pub(super) fn seek(&self, name: &str, identity: &Identity) -> Whereabouts {
        let ports = self.ports();
        let like: Vec<&PortInfo> =
            ports.iter().filter(|port| port.identity.as_ref().is_some_and(|found| found.is_like(identity))).collect();
        let in_socket = |port: &&&PortInfo| {
            identity.socket.is_some() && port.identity.as_ref().is_some_and(|found| found.socket == identity.socket)
        };
        let found = match like.as_slice() {
            [only] if identity.serial.is_some() => Some(*only),
            several => {
                let named = || several.iter().find(|port| same_device(&port.name, name));
                several.iter().find(in_socket).or_else(named).copied()
            }
        };
        if let Some(found) = found {
            // The name that was given is kept where it leads there: /dev/serial/by-id is more telling.
            let is_same = same_device(&found.name, name);
            return Whereabouts::At(if is_same { name.to_owned() } else { found.name.clone() });
        }
        let other = ports.into_iter().find(|port| same_device(&port.name, name));
        match other {
            Some(other) => Whereabouts::Stranger(other.about),
            None => Whereabouts::Gone,
        }
    }
}

fn same_device(one: &str, other: &str) -> bool {
    let place = |name: &str| std::fs::canonicalize(name).unwrap_or_else(|_| PathBuf::from(name));
    one == other || place(one) == place(other)
}

/// What is plugged in, as it is shown.
fn about(maker: Option<String>, product: Option<String>, identity: &Identity) -> String {
    let words = [maker.unwrap_or_default(), product.unwrap_or_default(), identity.to_string()];
    words.iter().map(|word| word.trim()).filter(|word| !word.is_empty()).collect::<Vec<_>>().join(" ")
}

#[cfg(target_os = "linux")]
mod system {
    //! `/sys/class/tty`, as the kernel's sysfs rules describe it (Linux, Documentation/ABI/testing/sysfs-bus-usb).

    use super::{Identity, Path, PathBuf, PortInfo, about};
    use std::fs::{canonicalize, read_dir, read_to_string};

    pub(super) fn ports(root: &Path) -> Vec<PortInfo> {
        let entries = read_dir(root.join("sys/class/tty")).into_iter().flatten().flatten();
        entries.filter_map(|entry| port(root, &entry.path())).collect()
    }

    fn port(root: &Path, tty: &Path) -> Option<PortInfo> {
        let name = tty.file_name()?;
        let path = root.join("dev").join(name);
        if !path.exists() {
            return None;
        }
        let info = |about: &str| PortInfo {
            name: path.display().to_string(),
            about: about.to_owned(),
            by_id: None,
            usb: false,
            identity: None,
        };
        if name.to_string_lossy().starts_with("rfcomm") {
            return Some(info("Bluetooth"));
        }
        let device = canonicalize(tty.join("device")).ok()?;
        let subsystem = canonicalize(device.join("subsystem")).ok()?;
        let interface = match subsystem.file_name()?.to_str()? {
            "usb" => device.as_path(),
            "usb-serial" => device.parent()?,
            "pci" => return Some(info("built-in")),
            "amba" | "pnp" | "serial-base" => return Some(info("")),
            _ => return None,
        };
        let adapter = interface.parent()?;
        let identity = Identity {
            product: format!("{}:{}", text(adapter, "idVendor")?, text(adapter, "idProduct")?),
            serial: text(adapter, "serial"),
            interface: text(interface, "bInterfaceNumber").and_then(|text| u8::from_str_radix(&text, 16).ok()),
            socket: adapter.file_name().map(|socket| socket.to_string_lossy().into_owned()),
        };
        let told = about(text(adapter, "manufacturer"), text(adapter, "product"), &identity);
        Some(PortInfo { by_id: by_id(root, &path), usb: true, identity: Some(identity), ..info(&told) })
    }

    fn text(directory: &Path, file: &str) -> Option<String> {
        let text = read_to_string(directory.join(file)).ok()?;
        Some(text.trim().to_owned()).filter(|text| !text.is_empty())
    }

    /// The link that udev makes after the descriptors.
    fn by_id(root: &Path, path: &Path) -> Option<String> {
        let target = canonicalize(path).ok()?;
        let links = read_dir(root.join("dev/serial/by-id")).into_iter().flatten().flatten();
        let mut links: Vec<PathBuf> = links.map(|link| link.path()).collect();
        links.sort();
        let link = links.into_iter().find(|link| canonicalize(link).is_ok_and(|place| place == target))?;
        Some(link.display().to_string())
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    use super::{Identity, Path, PortInfo, about};
    use serialport::SerialPortType;

    pub(super) fn ports(_root: &Path) -> Vec<PortInfo> {
        serialport::available_ports().unwrap_or_default().into_iter().map(port).collect()
    }

    fn port(port: serialport::SerialPortInfo) -> PortInfo {
        let info = |about: String, identity: Option<Identity>| PortInfo {
            name: port.port_name.clone(),
            about,
            by_id: None,
            usb: identity.is_some(),
            identity,
        };
        match port.port_type {
            SerialPortType::UsbPort(usb) => {
                let identity = Identity {
                    product: format!("{:04x}:{:04x}", usb.vid, usb.pid),
                    serial: usb.serial_number.filter(|serial| !serial.is_empty()),
                    interface: usb.interface,
                    socket: None,
                };
                info(about(usb.manufacturer, usb.product, &identity), Some(identity))
            }
            SerialPortType::BluetoothPort => info("Bluetooth".to_owned(), None),
            SerialPortType::PciPort => info("built-in".to_owned(), None),
            SerialPortType::Unknown => info(String::new(), None),
        }
    }
}

/// A machine made of files, with ptys for ports.
#[cfg(target_os = "linux")]
#[cfg(test)]
pub(super) mod fake {
    use super::*;
    use std::fs;
    use std::os::unix::fs::symlink;
    use tempfile::TempDir;

    pub(in super::super) struct Desk {
        dir: TempDir,
    }

    impl Desk {
        pub(in super::super) fn new() -> Self {
            let dir = tempfile::tempdir().unwrap();
            for path in ["sys/class/tty", "sys/bus/usb-serial", "sys/devices", "dev/serial/by-id"] {
                fs::create_dir_all(dir.path().join(path)).unwrap();
            }
            Desk { dir }
        }

        pub(in super::super) fn machine(&self) -> Host {
            Host { root: self.dir.path().to_owned() }
        }

        /// Path of a port by its name.
        pub(in super::super) fn path(&self, name: &str) -> String {
            self.dir.path().join("dev").join(name).display().to_string()
        }

        /// Plugs an FTDI adapter into a socket; its port leads to `target`.
        pub(in super::super) fn plug(&self, name: &str, socket: &str, serial: Option<&str>, target: &str) {
            let root = self.dir.path();
            let adapter = root.join("sys/devices").join(socket);
            let port = adapter.join(format!("{socket}:1.0")).join(name);
            fs::create_dir_all(&port).unwrap();
            let file = |name: &str, text: &str| fs::write(adapter.join(name), format!("{text}\n")).unwrap();
            file("idVendor", "0403");
            file("idProduct", "6001");
            file("manufacturer", "FTDI");
            file("product", "FT232R USB UART");
            serial.iter().for_each(|serial| file("serial", serial));
            fs::write(port.parent().unwrap().join("bInterfaceNumber"), "00\n").unwrap();
            symlink(root.join("sys/bus/usb-serial"), port.join("subsystem")).unwrap();
            fs::create_dir_all(root.join("sys/class/tty").join(name)).unwrap();
            symlink(&port, root.join("sys/class/tty").join(name).join("device")).unwrap();
            symlink(target, root.join("dev").join(name)).unwrap();
            let by_id = format!("usb-FTDI_{}-if00-port0", serial.unwrap_or("none"));
            let _old = fs::remove_file(root.join("dev/serial/by-id").join(&by_id));
            symlink(root.join("dev").join(name), root.join("dev/serial/by-id").join(by_id)).unwrap();
        }

        pub(in super::super) fn unplug(&self, name: &str, socket: &str) {
            let root = self.dir.path();
            fs::remove_dir_all(root.join("sys/devices").join(socket)).unwrap();
            fs::remove_dir_all(root.join("sys/class/tty").join(name)).unwrap();
            fs::remove_file(root.join("dev").join(name)).unwrap();
        }
    }

    #[test]
    fn adapters_of_one_kind_are_told_apart_by_their_serial_numbers() {
        let desk = Desk::new();
        desk.plug("ttyUSB0", "1-1", Some("A5"), "/dev/null");
        desk.plug("ttyUSB1", "1-2", Some("B7"), "/dev/zero");
        let shown: Vec<String> = desk.machine().ports().iter().map(ToString::to_string).collect();
        let at = |name: &str| desk.path(name);
        let expected = [("ttyUSB0", "A5"), ("ttyUSB1", "B7")].map(|(name, serial)| {
            let by_id = at(&format!("serial/by-id/usb-FTDI_{serial}-if00-port0"));
            format!("{} FTDI FT232R USB UART 0403:6001 {serial} ({by_id})", at(name))
        });
        assert_eq!(shown, expected);
    }

    #[test]
    fn an_adapter_is_found_by_its_serial_number_whatever_it_is_called() {
        let desk = Desk::new();
        let (machine, name) = (desk.machine(), desk.path("ttyUSB0"));
        desk.plug("ttyUSB0", "1-1", Some("A5"), "/dev/null");
        let mine = machine.identity(&name).unwrap();
        assert_eq!(machine.seek(&name, &mine), Whereabouts::At(name.clone()));
        let by_id = desk.path("serial/by-id/usb-FTDI_A5-if00-port0");
        assert_eq!(machine.seek(&by_id, &mine), Whereabouts::At(by_id.clone()));
        desk.unplug("ttyUSB0", "1-1");
        assert_eq!(machine.seek(&name, &mine), Whereabouts::Gone);
        desk.plug("ttyUSB0", "1-1", Some("B7"), "/dev/null");
        let stranger = Whereabouts::Stranger("FTDI FT232R USB UART 0403:6001 B7".to_owned());
        assert_eq!(machine.seek(&name, &mine), stranger);
        desk.plug("ttyUSB1", "1-2", Some("A5"), "/dev/zero");
        assert_eq!(machine.seek(&name, &mine), Whereabouts::At(desk.path("ttyUSB1")));
    }

    #[test]
    fn an_adapter_without_a_serial_number_is_known_by_its_socket_then_by_its_name() {
        let desk = Desk::new();
        let (machine, name) = (desk.machine(), desk.path("ttyUSB0"));
        desk.plug("ttyUSB0", "1-1", None, "/dev/null");
        let mine = machine.identity(&name).unwrap();
        desk.unplug("ttyUSB0", "1-1");
        desk.plug("ttyUSB0", "1-3", None, "/dev/full");
        assert_eq!(machine.seek(&name, &mine), Whereabouts::At(name.clone()));
        desk.plug("ttyUSB1", "1-1", None, "/dev/zero");
        assert_eq!(machine.seek(&name, &mine), Whereabouts::At(desk.path("ttyUSB1")));
        desk.unplug("ttyUSB1", "1-1");
        desk.unplug("ttyUSB0", "1-3");
        desk.plug("ttyUSB0", "1-3", Some("C1"), "/dev/full");
        assert!(matches!(machine.seek(&name, &mine), Whereabouts::Stranger(_)));
    }
}
