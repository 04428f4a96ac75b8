//! A serial port through tokio-serial: exclusive, input cleared, settings read back, every kind of hang-up told as
//! "lost".

use super::{LinkError, Wake};
use crate::protocol::line::{LineSetting, Parity};
use crate::tick::{Span, Tick};
use std::io;
use std::time::{Duration, Instant};
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio_serial::{ClearBuffer, DataBits, SerialPort, SerialPortBuilderExt, SerialStream, StopBits};

/// A port of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PortInfo {
    /// Path or name to open it.
    pub name: String,
    /// What is plugged in there, as far as USB tells.
    pub about: String,
    /// Whether it is a USB adapter.
    pub usb: bool,
}

/// The serial ports of this machine, USB adapters first.
pub fn list_ports() -> Vec<PortInfo> {
    let ports = serialport::available_ports().unwrap_or_default();
    let mut ports: Vec<_> = ports.into_iter().map(port_info).collect();
    ports.sort_by(|a, b| b.usb.cmp(&a.usb).then_with(|| a.name.cmp(&b.name)));
    ports
}

fn port_info(port: serialport::SerialPortInfo) -> PortInfo {
    let (about, usb) = match port.port_type {
        serialport::SerialPortType::UsbPort(usb) => {
            let maker = usb.manufacturer.unwrap_or_default();
            let product = usb.product.unwrap_or_default();
            (format!("{maker} {product} {:04x}:{:04x}", usb.vid, usb.pid).trim().to_owned(), true)
        }
        serialport::SerialPortType::BluetoothPort => ("Bluetooth".to_owned(), false),
        serialport::SerialPortType::PciPort => ("built-in".to_owned(), false),
        serialport::SerialPortType::Unknown => (String::new(), false),
    };
    PortInfo { name: port.port_name, about, usb }
}

#[derive(Debug)]
pub(super) struct SerialLink {
    name: String,
    line: LineSetting,
    /// `None` once it was closed to be opened anew.
    stream: Option<SerialStream>,
    opened: Instant,
    deviations: Vec<String>,
}

/// tokio's timers are 1-2 ms late, so the end of a wait is slept by the thread and the very last of it is spun
/// (facts/engineering.md, measured).
const THREAD_SLEEPS_FROM: Span = Span::from_millis(3);
const SPIN_FROM: Duration = Duration::from_micros(150);

impl SerialLink {
    #[expect(clippy::disallowed_methods, reason = "the serial link is the room that owns the real clock")]
    pub(super) fn open(name: &str, line: LineSetting) -> Result<Self, LinkError> {
        let (stream, deviations) = connect(name, line)?;
        Ok(SerialLink { name: name.to_owned(), line, stream: Some(stream), opened: Instant::now(), deviations })
    }

    /// Opens the port anew; the clock goes on.
    pub(super) fn reopen(&mut self) -> Result<(), LinkError> {
        // Closed first: a port that is held exclusively lets nobody else in, not even us.
        self.stream = None;
        let (stream, deviations) = connect(&self.name, self.line)?;
        (self.stream, self.deviations) = (Some(stream), deviations);
        Ok(())
    }

    pub(super) fn deviations(&self) -> &[String] {
        &self.deviations
    }

    #[expect(clippy::disallowed_methods, reason = "the serial link is the room that owns the real clock")]
    pub(super) fn now(&self) -> Tick {
        Tick::ZERO + Span::from(self.opened.elapsed())
    }

    pub(super) async fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        // No flush: tcdrain can block for ever on a dead adapter, and the wire time is known.
        match &mut self.stream {
            Some(stream) => stream.write_all(bytes).await.map_err(|_| self.lost()),
            None => Err(self.lost()),
        }
    }

    pub(super) async fn wait(&mut self, until: Tick) -> Result<Wake, LinkError> {
        let mut buffer = [0; 512];
        let coarse = Duration::from(until.since(self.now()) - THREAD_SLEEPS_FROM);
        let Some(stream) = &mut self.stream else {
            self.pass(coarse).await;
            return Ok(Wake::Silence);
        };
        if !coarse.is_zero()
            && let Ok(read) = tokio::time::timeout(coarse, stream.read(&mut buffer)).await
        {
            return self.took(read, &buffer);
        }
        self.sleep_until(until);
        // A time-out of zero would cost a millisecond; one turn of the reactor and one look do not.
        tokio::task::yield_now().await;
        let Some(stream) = &mut self.stream else { return Ok(Wake::Silence) };
        tokio::select! {
            biased;
            read = stream.read(&mut buffer) => self.took(read, &buffer),
            () = std::future::ready(()) => Ok(Wake::Silence),
        }
    }

    #[expect(clippy::disallowed_methods, reason = "the end of a wait is exact to a fraction of a character")]
    pub(super) fn sleep_until(&self, until: Tick) {
        loop {
            let rest = Duration::from(until.since(self.now()));
            match rest.checked_sub(SPIN_FROM) {
                _ if rest.is_zero() => return,
                Some(sleep) if !sleep.is_zero() => std::thread::sleep(sleep),
                _ => std::hint::spin_loop(),
            }
        }
    }

    /// Lets time go by while there is no port to listen on.
    #[expect(clippy::disallowed_methods, reason = "the serial link is the room that owns the real clock")]
    async fn pass(&self, time: Duration) {
        tokio::time::sleep(time).await;
    }

    fn took(&self, read: io::Result<usize>, buffer: &[u8]) -> Result<Wake, LinkError> {
        match read {
            // A tty that was hung up reads as end of file for ever.
            Ok(0) => Err(self.lost()),
            Ok(count) => Ok(Wake::Bytes(buffer.get(..count).unwrap_or_default().to_vec())),
            Err(_) => Err(self.lost()),
        }
    }

    /// Whatever the system calls it (EIO, ENXIO, ENODEV, EPIPE), an error on an open port means that it is gone.
    fn lost(&self) -> LinkError {
        LinkError::Lost(self.name.clone())
    }
}

/// Opens the port exclusively, with its input cleared; tells what the driver set in place of what was asked.
fn connect(name: &str, line: LineSetting) -> Result<(SerialStream, Vec<String>), LinkError> {
    let builder = tokio_serial::new(name, line.baud)
        .data_bits(if line.data_bits == 7 { DataBits::Seven } else { DataBits::Eight })
        .parity(match line.parity {
            Parity::Even => tokio_serial::Parity::Even,
            Parity::Odd => tokio_serial::Parity::Odd,
            Parity::None => tokio_serial::Parity::None,
        })
        .stop_bits(if line.stop_bits == 2 { StopBits::Two } else { StopBits::One });
    // Opened before the port is taken exclusively: afterwards the kernel lets nobody else in.
    let side_door = tty::open(name);
    let stream = builder.open_native_async().map_err(|error| open_error(name, &error))?;
    let deviations = match side_door {
        Ok(tty) => tty::finish(&tty, name, line),
        Err(_) => Vec::new(),
    };
    // Only the input: clearing the output as well could destroy what is sent next.
    stream.clear(ClearBuffer::Input).map_err(|error| open_error(name, &error))?;
    Ok((stream, deviations))
}

fn open_error(name: &str, error: &serialport::Error) -> LinkError {
    use serialport::ErrorKind;
    match error.kind() {
        ErrorKind::Io(io::ErrorKind::PermissionDenied) => LinkError::Permission(name.to_owned()),
        ErrorKind::Io(io::ErrorKind::NotFound) => LinkError::NotFound(name.to_owned()),
        ErrorKind::NoDevice if error.description.contains("busy") || error.description.contains("lock") => {
            LinkError::Busy(name.to_owned())
        }
        ErrorKind::NoDevice => LinkError::NotFound(name.to_owned()),
        _ => LinkError::Setting { port: name.to_owned(), message: error.description.clone() },
    }
}

/// What tokio-serial does not offer: stripping the eighth bit, and reading back what the driver accepted.
#[cfg(unix)]
mod tty {
    use super::{LineSetting, Parity};
    use rustix::fd::OwnedFd;
    use rustix::fs::{Mode, OFlags};
    use rustix::termios::{ControlModes, InputModes, OptionalActions, tcgetattr, tcsetattr};

    pub(super) fn open(name: &str) -> rustix::io::Result<OwnedFd> {
        rustix::fs::open(name, OFlags::RDWR | OFlags::NOCTTY | OFlags::NONBLOCK | OFlags::CLOEXEC, Mode::empty())
    }

    /// Sets ISTRIP for 7-bit characters and says what the driver set in place of what was asked.
    pub(super) fn finish(tty: &OwnedFd, name: &str, line: LineSetting) -> Vec<String> {
        let Ok(mut termios) = tcgetattr(tty) else { return Vec::new() };
        termios.input_modes.set(InputModes::ISTRIP, line.data_bits == 7);
        let _best_effort = tcsetattr(tty, OptionalActions::Now, &termios);
        let Ok(set) = tcgetattr(tty) else { return Vec::new() };
        let mut deviations = Vec::new();
        if set.input_speed() != line.baud {
            deviations.push(format!("asked for {} baud, the driver set {}", line.baud, set.input_speed()));
        }
        let is_pty = std::fs::canonicalize(name).is_ok_and(|path| path.starts_with("/dev/pts"));
        if is_pty {
            return deviations; // the kernel masks parity and width on a pty
        }
        let modes = set.control_modes;
        let parity = match (modes.contains(ControlModes::PARENB), modes.contains(ControlModes::PARODD)) {
            (false, _) => Parity::None,
            (true, false) => Parity::Even,
            (true, true) => Parity::Odd,
        };
        if parity != line.parity {
            deviations.push(format!("asked for parity {}, the driver set {}", line.parity.name(), parity.name()));
        }
        let data_bits = if modes & ControlModes::CSIZE == ControlModes::CS7 { 7 } else { 8 };
        if data_bits != line.data_bits {
            deviations.push(format!("asked for {} data bits, the driver set {data_bits}", line.data_bits));
        }
        deviations
    }
}

#[cfg(not(unix))]
mod tty {
    use super::LineSetting;

    pub(super) fn open(_name: &str) -> Result<(), ()> {
        Err(())
    }

    pub(super) fn finish(_tty: &(), _name: &str, _line: LineSetting) -> Vec<String> {
        Vec::new()
    }
}
