//! A serial port through tokio-serial: exclusive, input cleared, settings read back, every kind of hang-up told as
//! "lost".

use super::adapter::{AdapterInfo, Tuned};
use super::clock::Clock;
use super::rs485::{Rs485, Rs485Mode};
use super::{Ends, LinkError, Wake, tty};
use crate::protocol::line::{LineSetting, Parity};
use crate::tick::{Span, Tick};
use std::io;
use tokio::io::AsyncWriteExt;
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
    rs485: Rs485,
    port: Ends<OpenPort>,
    clock: Clock,
    deviations: Vec<String>,
}

/// A port that is held exclusively. What was asked of its driver is given back before it is closed.
#[derive(Debug)]
struct OpenPort {
    driver: Option<Tuned>,
    stream: SerialStream,
    /// We switch the direction of the line with RTS, with these delays.
    rts: Option<Rs485>,
}

impl SerialLink {
    pub(super) fn open(name: &str, line: LineSetting, rs485: Rs485) -> Result<Self, LinkError> {
        let (port, deviations) = connect(name, line, rs485)?;
        let port = Ends::Open(port);
        Ok(SerialLink { name: name.to_owned(), line, rs485, port, clock: Clock::start(), deviations })
    }

    /// Opens the port anew; the clock goes on.
    pub(super) fn reopen(&mut self) -> Result<(), LinkError> {
        // Closed first: a port that is held exclusively lets nobody else in, not even us.
        self.port = Ends::Closed;
        let (port, deviations) = connect(&self.name, self.line, self.rs485)?;
        (self.port, self.deviations) = (Ends::Open(port), deviations);
        Ok(())
    }

    /// Changes speed and format of the open port; what came in with the old ones is discarded.
    pub(super) fn set_line(&mut self, line: LineSetting) -> Result<(), LinkError> {
        let Ends::Open(port) = &mut self.port else { return Err(LinkError::Lost(self.name.clone())) };
        set(&mut port.stream, line).map_err(|error| open_error(&self.name, &error))?;
        self.deviations = match &port.driver {
            Some(driver) => tty::finish(driver.tty(), &self.name, line),
            None => Vec::new(),
        };
        port.stream.clear(ClearBuffer::Input).map_err(|error| open_error(&self.name, &error))?;
        self.line = line;
        Ok(())
    }

    pub(super) fn deviations(&self) -> &[String] {
        &self.deviations
    }

    pub(super) fn adapter(&self) -> AdapterInfo {
        let Ends::Open(OpenPort { driver: Some(driver), rts, .. }) = &self.port else {
            return AdapterInfo::of_port(&self.name);
        };
        let info = driver.info(&self.name);
        AdapterInfo { rs485: rts.unwrap_or(info.rs485), ..info }
    }

    pub(super) fn now(&self) -> Tick {
        self.clock.now()
    }

    /// Keeps the line until a moment, if there still is one.
    pub(super) fn outlast(&self, until: Tick) {
        if matches!(self.port, Ends::Open(_)) {
            self.clock.sleep_until(until);
        }
    }

    pub(super) async fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        let sent = match &mut self.port {
            Ends::Open(port) => port.send(bytes, self.line, self.clock).await,
            Ends::Lost | Ends::Closed => Err(io::ErrorKind::NotConnected.into()),
        };
        // Whatever the system calls it (EIO, ENXIO, ENODEV, EPIPE), an error on an open port means that it is gone.
        sent.map_err(|_| self.port.lost(&self.name))
    }

    pub(super) async fn wait(&mut self, until: Tick) -> Result<Wake, LinkError> {
        let woken = match &mut self.port {
            Ends::Open(port) => self.clock.listen(&mut port.stream, until).await,
            Ends::Lost => Err(io::ErrorKind::NotConnected.into()),
            Ends::Closed => {
                self.clock.rest_until(until).await;
                Ok(Wake::Silence)
            }
        };
        woken.map_err(|_| self.port.lost(&self.name))
    }
}

impl OpenPort {
    /// No flush: tcdrain can block for ever on a dead adapter, and the wire time is known.
    async fn send(&mut self, bytes: &[u8], line: LineSetting, clock: Clock) -> io::Result<()> {
        let Some(delays) = self.rts else { return self.stream.write_all(bytes).await };
        let talking = Talking::begin(&mut self.stream)?;
        if delays.before > Span::ZERO {
            clock.rest_until(clock.now() + delays.before).await;
        }
        let over = clock.now() + line.chars(bytes.len() as u64) + delays.after;
        talking.0.write_all(bytes).await?;
        clock.rest_until(over).await;
        Ok(())
    }
}

/// RTS is high until this is dropped, whatever happens meanwhile: who keeps the line silences everybody.
struct Talking<'a>(&'a mut SerialStream);

impl<'a> Talking<'a> {
    fn begin(stream: &'a mut SerialStream) -> io::Result<Self> {
        stream.write_request_to_send(true)?;
        Ok(Talking(stream))
    }
}

impl Drop for Talking<'_> {
    fn drop(&mut self) {
        // A port that is gone shows when it is read.
        let _best_effort = self.0.write_request_to_send(false);
    }
}

/// Opens the port exclusively, with its input cleared; tells what the driver set in place of what was asked.
fn connect(name: &str, line: LineSetting, rs485: Rs485) -> Result<(OpenPort, Vec<String>), LinkError> {
    let builder =
        tokio_serial::new(name, line.baud).data_bits(data_bits(line)).parity(parity(line)).stop_bits(stop_bits(line));
    // Opened before the port is taken exclusively: afterwards the kernel lets nobody else in.
    let side_door = tty::open(name).ok();
    let stream = builder.open_native_async().map_err(|error| open_error(name, &error))?;
    let mut deviations = side_door.as_ref().map_or_else(Vec::new, |tty| tty::finish(tty, name, line));
    // Only the input: clearing the output as well could destroy what is sent next.
    stream.clear(ClearBuffer::Input).map_err(|error| open_error(name, &error))?;
    let mut port = OpenPort { driver: side_door.map(Tuned::new), stream, rts: None };
    let switched = port.choose_direction(rs485);
    let refused =
        |error: io::Error| LinkError::Direction { port: name.to_owned(), mode: rs485.mode, message: error.to_string() };
    deviations.extend(switched.map_err(refused)?);
    Ok((port, deviations))
}

impl OpenPort {
    /// Arranges who switches an RS-485 line; tells what is not as asked.
    fn choose_direction(&mut self, rs485: Rs485) -> io::Result<Vec<String>> {
        let by_kernel = self.driver.as_ref().is_some_and(Tuned::switches_direction);
        match (rs485.mode, &mut self.driver) {
            (Rs485Mode::Kernel, Some(driver)) => driver.switch_direction(rs485.before, rs485.after),
            (Rs485Mode::Kernel, None) => Err(io::ErrorKind::Unsupported.into()),
            (Rs485Mode::Rts, _) => {
                self.stream.write_request_to_send(false)?;
                self.rts = Some(rs485);
                Ok(Vec::new())
            }
            (Rs485Mode::Auto, Some(driver)) if by_kernel && rs485.has_delays() => {
                driver.switch_direction(rs485.before, rs485.after)
            }
            (Rs485Mode::Auto | Rs485Mode::Adapter, _) if rs485.has_delays() => {
                Ok(vec!["the RS-485 delays do nothing here: the adapter switches the direction by itself".to_owned()])
            }
            (Rs485Mode::Auto | Rs485Mode::Adapter, _) => Ok(Vec::new()),
        }
    }
}

fn set(stream: &mut SerialStream, line: LineSetting) -> serialport::Result<()> {
    stream.set_baud_rate(line.baud)?;
    stream.set_data_bits(data_bits(line))?;
    stream.set_parity(parity(line))?;
    stream.set_stop_bits(stop_bits(line))
}

fn data_bits(line: LineSetting) -> DataBits {
    if line.data_bits == 7 { DataBits::Seven } else { DataBits::Eight }
}

fn parity(line: LineSetting) -> tokio_serial::Parity {
    match line.parity {
        Parity::Even => tokio_serial::Parity::Even,
        Parity::Odd => tokio_serial::Parity::Odd,
        Parity::None => tokio_serial::Parity::None,
    }
}

fn stop_bits(line: LineSetting) -> StopBits {
    if line.stop_bits == 2 { StopBits::Two } else { StopBits::One }
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

#[cfg(unix)]
#[cfg(test)]
mod tests {
    use super::super::{Link, LowLatency, Port};
    use super::*;
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{InputModes, tcgetattr};
    use std::os::fd::OwnedFd;

    const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

    /// The master side of a pseudo terminal, and the port that its slave side is.
    fn pty() -> (OwnedFd, Port) {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY).unwrap();
        grantpt(&master).unwrap();
        unlockpt(&master).unwrap();
        let slave = ptsname(&master, Vec::new()).unwrap().into_string().unwrap();
        (master, Port::Serial(slave))
    }

    fn run(test: impl Future<Output = ()>) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        runtime.block_on(test);
    }

    #[test]
    fn an_open_port_takes_another_setting() {
        run(async {
            let (master, port) = pty();
            let mut link = Link::open(&port, LINE, Rs485::default()).await.unwrap();
            rustix::io::write(&master, b"old").unwrap();
            link.set_line(LineSetting::ascii(9_600, Parity::Odd)).await.unwrap();
            let seen = tcgetattr(&master).unwrap();
            assert_eq!(seen.output_speed(), 9_600);
            assert!(seen.input_modes.contains(InputModes::ISTRIP));
            link.set_line(LINE).await.unwrap();
            let seen = tcgetattr(&master).unwrap();
            assert_eq!(seen.output_speed(), 19_200);
            assert!(!seen.input_modes.contains(InputModes::ISTRIP));
            assert!(link.deviations().is_empty());
            rustix::io::write(&master, b"new").unwrap();
            let until = link.now() + Span::from_secs(5);
            assert_eq!(link.wait(until).await.unwrap(), Wake::Bytes(b"new".to_vec()));
        });
    }

    #[test]
    fn a_port_that_hangs_up_is_lost_at_once_for_whoever_listens_or_talks() {
        run(async {
            for talk_first in [false, true] {
                let (master, port) = pty();
                let mut link = Link::open(&port, LINE, Rs485::default()).await.unwrap();
                drop(master);
                let until = link.now() + Span::from_secs(60);
                if !talk_first {
                    assert!(matches!(link.wait(until).await, Err(LinkError::Lost(_))));
                }
                assert!(matches!(link.send(&[1]).await, Err(LinkError::Lost(_))));
                assert!(matches!(link.wait(until).await, Err(LinkError::Lost(_))));
                assert!(matches!(link.set_line(LINE).await, Err(LinkError::Lost(_))));
                assert!(link.now() < until);
                assert!(link.reopen().await.is_err());
                let until = link.now() + Span::from_millis(5);
                assert_eq!(link.wait(until).await.unwrap(), Wake::Silence);
                assert!(matches!(link.send(&[1]).await, Err(LinkError::Lost(_))));
            }
        });
    }

    #[test]
    fn a_pseudo_terminal_switches_no_direction_and_says_so() {
        run(async {
            let (_master, port) = pty();
            for mode in [Rs485Mode::Kernel, Rs485Mode::Rts] {
                let error = Link::open(&port, LINE, Rs485 { mode, ..Rs485::default() }).await.unwrap_err();
                assert!(matches!(error, LinkError::Direction { mode: refused, .. } if refused == mode), "{error}");
            }
            let delayed = Rs485 { after: Span::from_millis(1), ..Rs485::default() };
            let link = Link::open(&port, LINE, delayed).await.unwrap();
            assert!(link.deviations()[0].contains("delays do nothing"), "{:?}", link.deviations());
            let adapter = link.adapter();
            assert_eq!(Port::Serial(adapter.name), port);
            assert_eq!((adapter.low_latency, adapter.error_counts), (LowLatency::Unsupported, None));
            assert_eq!(adapter.rs485.mode, Rs485Mode::Adapter);
        });
    }
}
