//! A serial port through tokio-serial: exclusive, input cleared, settings read back, every kind of hang-up told as
//! "lost", and closed without waiting for an adapter that takes no bytes.

use super::adapter::{AdapterInfo, Tuned};
use super::clock::Clock;
use super::ports::{Host, Identity, Whereabouts};
use super::rs485::{Rs485, Rs485Mode};
use super::{Ends, LinkError, Wake, tty};
use crate::files::of_system;
use crate::protocol::line::{LineSetting, Parity};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::io;
use tokio::io::AsyncWriteExt;
use tokio_serial::{ClearBuffer, DataBits, SerialPort, SerialPortBuilderExt, SerialStream, StopBits};

#[derive(Debug)]
pub(super) struct SerialLink {
    name: String,
    machine: Host,
    /// The adapter, whatever its port is called next time; `None` of what is no USB adapter.
    identity: Option<Identity>,
    /// What was sent is on the wire by then.
    sent_by: Tick,
    line: LineSetting,
    rs485: Rs485,
    port: Ends<OpenPort>,
    clock: Clock,
    deviations: Vec<Text>,
}

/// A port that is held exclusively. What was asked of its driver is given back before it is closed.
#[derive(Debug)]
struct OpenPort {
    driver: Option<Tuned>,
    stream: SerialStream,
    /// We switch the direction of the line with RTS, with these delays.
    rts: Option<Rs485>,
}

/// An adapter that has not taken a telegram so long after the time that the wire needs does not take it any more.
const STUCK: Span = Span::from_millis(500);
/// How long after that time bytes are waited for when the port is closed: what was sent last may be a stop.
const LINGER: Span = Span::from_millis(100);

impl SerialLink {
    pub(super) fn open(name: &str, line: LineSetting, rs485: Rs485) -> Result<Self, LinkError> {
        Self::open_on(Host::default(), name, line, rs485)
    }

    /// Opens a port of a machine.
    fn open_on(machine: Host, name: &str, line: LineSetting, rs485: Rs485) -> Result<Self, LinkError> {
        let (port, deviations) = connect(name, line, rs485)?;
        let (identity, name, port) = (machine.identity(name), name.to_owned(), Ends::Open(port));
        let (clock, sent_by) = (Clock::start(), Tick::ZERO);
        Ok(SerialLink { name, machine, identity, sent_by, line, rs485, port, clock, deviations })
    }

    /// Opens the port of the same adapter anew, whatever it is called now; the clock goes on. What is no USB adapter is
    /// known by its name only.
    pub(super) fn reopen(&mut self) -> Result<(), LinkError> {
        // Closed first: a port that is held exclusively lets nobody else in, not even us.
        self.close();
        let name = match self.identity.as_ref().map(|identity| self.machine.seek(&self.name, identity)) {
            None => self.name.clone(),
            Some(Whereabouts::At(name)) => name,
            Some(Whereabouts::Gone) => return Err(LinkError::NotFound(self.name.clone())),
            Some(Whereabouts::Stranger(found)) => {
                return Err(LinkError::Stranger { port: self.name.clone(), found });
            }
        };
        let (port, deviations) = connect(&name, self.line, self.rs485)?;
        (self.port, self.deviations, self.name) = (Ends::Open(port), deviations, name);
        Ok(())
    }

    /// Lets go of the port: what was sent goes out, but an adapter that does not take it is waited for by nobody.
    fn close(&mut self) {
        let Ends::Open(port) = std::mem::replace(&mut self.port, Ends::Closed) else { return };
        let holds_bytes = |port: &OpenPort| port.stream.bytes_to_write().is_ok_and(|count| count > 0);
        let until = self.sent_by + LINGER;
        while holds_bytes(&port) && self.clock.now() < until {
            self.clock.sleep_until(until.min(self.clock.now() + Span::from_millis(1)));
        }
        if !holds_bytes(&port) {
            return;
        }
        let _best_effort = port.stream.clear(ClearBuffer::Output);
        // Linux waits in close() for up to 30 s until unsent bytes are out (tty_wait_until_sent), and drivers of USB
        // adapters discard nothing. It waits in a thread of its own, which ends with the program.
        let _unless_there_is_no_thread = std::thread::Builder::new().spawn(move || drop(port));
    }

    /// Name of the port, which may be another one after it was opened anew.
    pub(super) fn name(&self) -> &str {
        &self.name
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

    pub(super) fn deviations(&self) -> &[Text] {
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
        let takes = self.line.chars(bytes.len() as u64);
        self.sent_by = self.sent_by.max(self.clock.now()) + takes;
        let sent = match &mut self.port {
            Ends::Open(port) => {
                let limit = takes + takes + self.rs485.before + self.rs485.after + STUCK;
                let sending = port.send(bytes, self.line, self.clock);
                tokio::time::timeout(limit.into(), sending).await
            }
            Ends::Lost | Ends::Closed => Ok(Err(io::ErrorKind::NotConnected.into())),
        };
        match sent {
            Ok(Ok(())) => Ok(()),
            // Whatever the system calls it (EIO, ENXIO, ENODEV, EPIPE), an error on an open port means that it is gone.
            Ok(Err(_)) => Err(self.port.lost(&self.name)),
            Err(_) => Err(LinkError::Stuck(self.name.clone())),
        }
    }

    /// Hands over bytes at once, or not at all; closing the port waits for them.
    pub(super) fn push(&mut self, bytes: &[u8]) -> bool {
        let Ends::Open(port) = &mut self.port else { return false };
        self.sent_by = self.sent_by.max(self.clock.now()) + self.line.chars(bytes.len() as u64);
        io::Write::write(&mut port.stream, bytes).is_ok()
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

impl Drop for SerialLink {
    fn drop(&mut self) {
        self.close();
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
fn connect(name: &str, line: LineSetting, rs485: Rs485) -> Result<(OpenPort, Vec<Text>), LinkError> {
    let builder =
        tokio_serial::new(name, line.baud).data_bits(data_bits(line)).parity(parity(line)).stop_bits(stop_bits(line));
    // Opened before the port is taken exclusively: afterwards the kernel lets nobody else in but root. Whoever finds it
    // taken must not even try: serialport ends everybody's exclusivity when it closes (TIOCNXCL).
    let side_door = tty::open(name).ok();
    if side_door.as_ref().is_some_and(|tty| !tty::claim(tty, name)) {
        return Err(LinkError::Busy(name.to_owned()));
    }
    // Elsewhere than on Unix a port has one opener by itself.
    #[cfg(unix)]
    let builder = builder.exclusive(side_door.is_none());
    let stream = builder.open_native_async().map_err(|error| open_error(name, &error))?;
    side_door.iter().for_each(tty::exclude);
    let mut deviations = side_door.as_ref().map_or_else(Vec::new, |tty| tty::finish(tty, name, line));
    // Only the input: clearing the output as well could destroy what is sent next.
    stream.clear(ClearBuffer::Input).map_err(|error| open_error(name, &error))?;
    let mut port = OpenPort { driver: side_door.map(Tuned::new), stream, rts: None };
    let switched = port.choose_direction(rs485);
    let refused =
        |error: io::Error| LinkError::Direction { port: name.to_owned(), mode: rs485.mode, message: of_system(&error) };
    deviations.extend(switched.map_err(refused)?);
    Ok((port, deviations))
}

impl OpenPort {
    /// Arranges who switches an RS-485 line; tells what is not as asked.
    fn choose_direction(&mut self, rs485: Rs485) -> io::Result<Vec<Text>> {
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
            (Rs485Mode::Auto | Rs485Mode::Adapter, _) if rs485.has_delays() => Ok(vec![both!(
                "the RS-485 delays do nothing here: the adapter switches the direction by itself",
                "die RS-485-Verzögerungen wirken hier nicht: der Adapter schaltet die Richtung selbst um"
            )]),
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
    fn an_adapter_that_takes_no_bytes_ends_in_time() {
        run(async {
            let (_master, port) = pty();
            let mut link = Link::open(&port, LINE, Rs485::default()).await.unwrap();
            let error = loop {
                if let Err(error) = link.send(&[0; 4_096]).await {
                    break error;
                }
            };
            assert!(matches!(error, LinkError::Stuck(_)), "{error}");
            let before = link.now();
            // Not given up: a stop may get through when it takes bytes again.
            assert!(matches!(link.send(&[0; 8]).await, Err(LinkError::Stuck(_))));
            assert!(link.now().since(before) < Span::from_secs(30));
        });
    }

    #[test]
    fn a_second_start_neither_gets_the_port_nor_ends_the_exclusivity_of_the_first() {
        run(async {
            let (_master, port) = pty();
            let link = Link::open(&port, LINE, Rs485::default()).await.unwrap();
            for _ in 0..2 {
                let error = Link::open(&port, LINE, Rs485::default()).await.unwrap_err();
                assert!(matches!(error, LinkError::Busy(_)), "{error}");
            }
            let Port::Serial(name) = &port else { panic!("no tty") };
            // Root alone gets this far.
            if let Ok(tty) = tty::open(name) {
                assert!(tty::is_exclusive(&tty));
            }
            drop(link);
            Link::open(&port, LINE, Rs485::default()).await.unwrap();
        });
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn a_lost_adapter_is_taken_again_by_its_serial_number_and_a_stranger_is_not() {
        use super::super::ports::fake::Desk;
        run(async {
            let desk = Desk::new();
            let name = desk.path("ttyUSB0");
            let (first, Port::Serial(tty)) = pty() else { panic!("no tty") };
            desk.plug("ttyUSB0", "1-1", Some("A5"), &tty);
            let mut link = SerialLink::open_on(desk.machine(), &name, LINE, Rs485::default()).unwrap();
            drop(first);
            desk.unplug("ttyUSB0", "1-1");
            assert!(link.wait(link.now() + Span::from_secs(9)).await.is_err());
            assert!(matches!(link.reopen(), Err(LinkError::NotFound(_))));

            let (mut stranger, Port::Serial(tty)) = pty() else { panic!("no tty") };
            desk.plug("ttyUSB0", "1-1", Some("B7"), &tty);
            let error = link.reopen().unwrap_err();
            assert!(matches!(&error, LinkError::Stranger { found, .. } if found.ends_with("B7")), "{error}");
            rustix::io::ioctl_fionbio(&stranger, true).unwrap();
            assert!(link.send(&[1]).await.is_err());
            assert!(rustix::io::read(&mut stranger, &mut [0; 8]).is_err());

            let (second, Port::Serial(tty)) = pty() else { panic!("no tty") };
            desk.plug("ttyUSB1", "1-2", Some("A5"), &tty);
            link.reopen().unwrap();
            assert_eq!(link.name(), desk.path("ttyUSB1"));
            link.send(&[7]).await.unwrap();
            let mut got = [0; 8];
            assert_eq!(rustix::io::read(&second, &mut got).unwrap(), 1);
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
            assert!(link.deviations()[0].en.contains("delays do nothing"), "{:?}", link.deviations());
            let adapter = link.adapter();
            assert_eq!(Port::Serial(adapter.name), port);
            assert_eq!((adapter.low_latency, adapter.error_counts), (LowLatency::Unsupported, None));
            assert_eq!(adapter.rs485.mode, Rs485Mode::Adapter);
        });
    }
}
