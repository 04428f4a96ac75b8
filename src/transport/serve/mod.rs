//! The bench in real time, for any master: on a pseudo terminal or on a loopback TCP port.
//!
//! The bench itself lives in virtual time; here its clock is the real one. A pseudo terminal has no wires, so the time
//! that bytes take is the bench's: what arrives in one read counts as back to back from that moment on, and replies
//! go out byte by byte, each when its last bit would have been on the wire (docs/measured.md).
//!
//! The master side of a pseudo terminal sees what the client has set: speed and stop bits as they are; parity by
//! `INPCK` and `PARODD`, because the kernel masks `PARENB`; seven bits by `ISTRIP`, because it masks `CSIZE`
//! (measured, docs/measured.md). So a drive stays silent when speed, parity or width do not fit its own. TCP
//! carries no setting: every telegram is sent with the one of the drive that it addresses.

use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::Bench;
use crate::tick::{Span, Tick};
use std::collections::VecDeque;
use std::future::Future;
use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::pin::pin;
use std::time::{Duration, Instant};
use tokio::net::{TcpListener, TcpStream};

/// Where the bench is served.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// A new pseudo terminal; `link` is a symbolic link that names it.
    Pty {
        /// Made at the start and removed at the end; a file that is no symbolic link is never replaced.
        link: Option<PathBuf>,
    },
    /// A raw TCP port.
    Tcp {
        /// Loopback only; port 0 takes a free one.
        addr: SocketAddr,
    },
}

/// What happens to the clients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Note {
    /// A client has opened the port.
    Connected,
    /// The client has closed it.
    Left,
}

/// Why a bench cannot be served.
#[derive(Debug, thiserror::Error)]
pub enum ServeError {
    /// No pseudo terminal.
    #[error("cannot make a pseudo terminal: {0}")]
    Pty(#[source] io::Error),
    /// The link cannot be made.
    #[error("cannot make the link {}: {why}", path.display())]
    Link {
        /// The link.
        path: PathBuf,
        /// What is in the way.
        why: String,
    },
    /// The address can be reached from outside.
    #[error("{0} is no loopback address; expected 127.0.0.1:PORT or [::1]:PORT")]
    NotLoopback(SocketAddr),
    /// The TCP port does not work.
    #[error("cannot listen on tcp://{addr}: {why}")]
    Tcp {
        /// The address.
        addr: SocketAddr,
        /// What the system said.
        #[source]
        why: io::Error,
    },
}

/// A port with a bench behind it.
#[derive(Debug)]
pub struct Server {
    opened: Instant,
    port: Port,
}

/// tokio's timers are 1-2 ms late (docs/measured.md): what is nearer is slept by the thread.
const THREAD_SLEEPS_FROM: Span = Span::from_millis(3);
/// The last bit of a wait is spun. Spinning longer starves the kernel worker that carries the bytes of a pseudo
/// terminal, and replies arrive in one piece (docs/measured.md).
const SPIN_FROM: Span = Span::from_micros(80);

/// Setting of a line that nobody knows anything of (CM-485 manual 5).
const FACTORY: LineSetting = LineSetting::rtu(19_200, Parity::Even);

/// How late a telegram may be read on a busy machine.
const LATE: Span = Span::from_millis(10);

impl Server {
    /// Makes the port. A client may open it at once; it is answered as soon as [`Server::run`] runs.
    #[expect(clippy::disallowed_methods, reason = "the served bench runs by the real clock")]
    pub fn open(place: Place) -> Result<Server, ServeError> {
        let port = match place {
            #[cfg(unix)]
            Place::Pty { link } => Port::Pty(pty::Pty::open(link)?),
            #[cfg(not(unix))]
            Place::Pty { .. } => return Err(ServeError::Pty(io::ErrorKind::Unsupported.into())),
            Place::Tcp { addr } if !addr.ip().is_loopback() => return Err(ServeError::NotLoopback(addr)),
            Place::Tcp { addr } => {
                let failed = |why| ServeError::Tcp { addr, why };
                let listener = std::net::TcpListener::bind(addr).map_err(failed)?;
                listener.set_nonblocking(true).map_err(failed)?;
                let addr = listener.local_addr().map_err(failed)?;
                Port::Tcp(Tcp { listener, addr, accepting: None, client: None })
            }
        };
        Ok(Server { opened: Instant::now(), port })
    }

    /// What a client has to open: `/dev/pts/7`, the link, or `tcp://127.0.0.1:5020`.
    pub fn name(&self) -> String {
        match &self.port {
            #[cfg(unix)]
            Port::Pty(pty) => pty.name(),
            Port::Tcp(tcp) => format!("tcp://{}", tcp.addr),
        }
    }

    /// Waits, for callers that have no clock of their own.
    #[expect(clippy::disallowed_methods, reason = "the served bench runs by the real clock")]
    pub async fn pause(span: Span) {
        tokio::time::sleep(span.into()).await;
    }

    /// Serves the bench, one client after the other, until `stop` resolves. `note` hears of clients that come and go.
    ///
    /// The time of the bench is the time since [`Server::open`].
    pub async fn run(
        &mut self,
        bench: &mut Bench,
        stop: impl Future<Output = ()>,
        mut note: impl FnMut(Note),
    ) -> Result<(), ServeError> {
        bench.allow(LATE);
        let mut stop = pin!(stop);
        let mut backlog = Backlog::default();
        loop {
            let now = self.now();
            while let Some((at, line, bytes)) = backlog.next(now) {
                bench.master_sends(at, line, &bytes);
            }
            let due: Vec<u8> = bench.advance(now).into_iter().map(|(_, byte)| byte).collect();
            if !due.is_empty() {
                self.port.write(&due);
            }
            let next = bench.next_event().into_iter().chain(backlog.goes_on()).min();
            let opened = self.opened;
            tokio::select! {
                biased;
                () = &mut stop => return Ok(()),
                change = self.port.change() => match change? {
                    Change::Connected => note(Note::Connected),
                    Change::Left => {
                        backlog.leave();
                        note(Note::Left);
                    }
                    Change::Bytes(bytes) => {
                        let line = self.port.line().or(bench.line_of(&bytes)).unwrap_or(FACTORY);
                        backlog.take(line, &bytes);
                    }
                },
                () = wait_for(opened, next) => {}
            }
            // Lets the reactor look for bytes and signals, also while events follow each other closely.
            tokio::task::yield_now().await;
        }
    }

    #[expect(clippy::disallowed_methods, reason = "the served bench runs by the real clock")]
    fn now(&self) -> Tick {
        Tick::ZERO + Span::from(self.opened.elapsed())
    }
}

/// Waits until a moment of the bench, exact to some microseconds once it is near; for ever if there is none.
#[expect(clippy::disallowed_methods, reason = "the served bench runs by the real clock")]
async fn wait_for(opened: Instant, next: Option<Tick>) {
    let Some(next) = next else { return std::future::pending().await };
    let left = || next.since(Tick::ZERO + Span::from(opened.elapsed()));
    if left() > THREAD_SLEEPS_FROM {
        tokio::time::sleep((left() - THREAD_SLEEPS_FROM).into()).await;
        return;
    }
    let sleep = Duration::from(left() - SPIN_FROM);
    if !sleep.is_zero() {
        std::thread::sleep(sleep);
    }
    while left() > Span::ZERO {
        std::hint::spin_loop();
    }
}

/// What a client has sent and the wire has not taken yet. It is the buffer of a serial server: what does not fit is lost,
/// and what is left goes with the client.
#[derive(Debug, Default)]
struct Backlog {
    queue: VecDeque<(LineSetting, u8)>,
    /// Until then the bytes that were given to the bench are on the wire.
    busy: Tick,
}

/// Bytes that a client may be ahead of the wire: more than any telegram has.
const ROOM: usize = 4_096;
/// The bench is told so early of what follows back to back, so that no lateness of ours tears a telegram.
const AHEAD: Span = Span::from_millis(50);
/// Silence between two clients: longer than any that parts telegrams.
const BETWEEN_CLIENTS: Span = Span::from_millis(20);
/// Bytes that it is told at once.
const PIECE: usize = 64;

impl Backlog {
    fn take(&mut self, line: LineSetting, bytes: &[u8]) {
        // Without a speed nothing goes anywhere.
        if line.baud > 0 {
            let room = ROOM.saturating_sub(self.queue.len());
            self.queue.extend(bytes.iter().take(room).map(|&byte| (line, byte)));
        }
    }

    /// The client is gone. What it has on the wire already and what the next one sends are not one telegram.
    fn leave(&mut self) {
        self.queue.clear();
        self.busy += BETWEEN_CLIENTS;
    }

    /// The next bytes that go on the wire, and when.
    fn next(&mut self, now: Tick) -> Option<(Tick, LineSetting, Vec<u8>)> {
        let &(line, _) = self.queue.front().filter(|_| self.busy <= now + AHEAD)?;
        let count = self.queue.iter().take(PIECE).take_while(|(other, _)| *other == line).count();
        let bytes: Vec<u8> = self.queue.drain(..count).map(|(_, byte)| byte).collect();
        let at = self.busy.max(now);
        self.busy = at + line.chars(bytes.len() as u64);
        Some((at, line, bytes))
    }

    /// When there is room on the wire for more.
    fn goes_on(&self) -> Option<Tick> {
        self.queue.front().map(|_| Tick::ZERO + (self.busy.since(Tick::ZERO) - AHEAD))
    }
}

/// What a port tells.
#[derive(Debug)]
enum Change {
    Connected,
    Left,
    Bytes(Vec<u8>),
}

#[derive(Debug)]
enum Port {
    #[cfg(unix)]
    Pty(pty::Pty),
    Tcp(Tcp),
}

impl Port {
    /// The next thing that happens. May be dropped at any time without losing anything.
    async fn change(&mut self) -> Result<Change, ServeError> {
        match self {
            #[cfg(unix)]
            Port::Pty(pty) => pty.change().await.map_err(ServeError::Pty),
            Port::Tcp(tcp) => {
                let addr = tcp.addr;
                tcp.change().await.map_err(|why| ServeError::Tcp { addr, why })
            }
        }
    }

    /// Hands bytes to the client. Without a client, or with one that does not read, they are lost, as on a wire.
    fn write(&mut self, bytes: &[u8]) {
        match self {
            #[cfg(unix)]
            Port::Pty(pty) => pty.write(bytes),
            Port::Tcp(tcp) => {
                if let Some(client) = &tcp.client {
                    // A lost connection shows when it is read.
                    let _ = client.try_write(bytes);
                }
            }
        }
    }

    /// What the client has set; `None` where there is nothing to set.
    fn line(&self) -> Option<LineSetting> {
        match self {
            #[cfg(unix)]
            Port::Pty(pty) => Some(pty.line()),
            Port::Tcp(_) => None,
        }
    }
}

/// Longest piece that is read at once.
const CHUNK: usize = 4_096;

#[derive(Debug)]
struct Tcp {
    listener: std::net::TcpListener,
    addr: SocketAddr,
    /// The listener as the runtime knows it.
    accepting: Option<TcpListener>,
    client: Option<TcpStream>,
}

impl Tcp {
    async fn change(&mut self) -> io::Result<Change> {
        let Some(client) = &self.client else {
            if self.accepting.is_none() {
                self.accepting = Some(TcpListener::from_std(self.listener.try_clone()?)?);
            }
            let Some(accepting) = &self.accepting else { return Err(io::ErrorKind::NotConnected.into()) };
            let (client, _) = accepting.accept().await?;
            // Every byte has its time: nothing may wait for the next.
            client.set_nodelay(true)?;
            self.client = Some(client);
            return Ok(Change::Connected);
        };
        let mut buffer = vec![0; CHUNK];
        loop {
            client.readable().await?;
            match client.try_read(&mut buffer) {
                Err(error) if error.kind() == io::ErrorKind::WouldBlock => {}
                Ok(count @ 1..) => {
                    buffer.truncate(count);
                    return Ok(Change::Bytes(buffer));
                }
                Ok(0) | Err(_) => {
                    self.client = None;
                    return Ok(Change::Left);
                }
            }
        }
    }
}

#[cfg(unix)]
mod pty {
    //! A pseudo terminal, seen from its master side. No slave side is kept open, so that the master sees clients come
    //! and go.

    use super::{CHUNK, Change, ServeError};
    use crate::protocol::line::{LineSetting, Parity};
    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    use rustix::fs::{Mode, OFlags};
    use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
    use rustix::termios::{ControlModes, InputModes, OptionalActions, tcgetattr, tcsetattr};
    use std::io;
    use std::os::fd::{AsFd, OwnedFd};
    use std::path::{Path, PathBuf};
    use std::time::Duration;
    use tokio::io::Interest;
    use tokio::io::unix::AsyncFd;

    /// How often it is looked whether a client has come.
    const LOOK: Duration = Duration::from_millis(5);
    /// Speed between two clients. Tools that set everything at once fail on a pseudo terminal that already has their
    /// speed (docs/measured.md).
    const IDLE_BAUD: u32 = 38_400;

    #[derive(Debug)]
    pub(super) struct Pty {
        master: OwnedFd,
        slave: String,
        link: Option<PathBuf>,
        /// The master side as the runtime knows it, while a client is there. A new one for every client, because the
        /// runtime never forgets that a side was closed.
        client: Option<AsyncFd<OwnedFd>>,
    }

    impl Pty {
        pub(super) fn open(link: Option<PathBuf>) -> Result<Self, ServeError> {
            let (master, slave) = pair().map_err(|error| ServeError::Pty(error.into()))?;
            let mut pty = Pty { master, slave, link: None, client: None };
            if let Some(link) = link {
                make_link(&pty.slave, &link)?;
                pty.link = Some(link);
            }
            Ok(pty)
        }

        pub(super) fn name(&self) -> String {
            self.link.as_ref().map_or_else(|| self.slave.clone(), |link| link.display().to_string())
        }

        #[expect(clippy::disallowed_methods, reason = "nothing tells that a client opens the other side")]
        pub(super) async fn change(&mut self) -> io::Result<Change> {
            let Some(client) = &self.client else {
                while !is_open(&self.master)? {
                    tokio::time::sleep(LOOK).await;
                }
                self.client = Some(self.register()?);
                return Ok(Change::Connected);
            };
            let mut buffer = vec![0; CHUNK];
            let mut guard = client.readable().await?;
            let read = guard.try_io(|fd| rustix::io::read(fd, &mut buffer[..]).map_err(io::Error::from));
            match read {
                Ok(Ok(count @ 1..)) => {
                    buffer.truncate(count);
                    Ok(Change::Bytes(buffer))
                }
                // EIO: nobody has the slave side open.
                Ok(Ok(0) | Err(_)) => {
                    self.client = None;
                    set_idle(&self.master)?;
                    Ok(Change::Left)
                }
                Err(_) => {
                    if guard.ready().is_read_closed() {
                        // Closed and opened again before anybody looked.
                        drop(guard);
                        self.client = Some(self.register()?);
                    }
                    Ok(Change::Bytes(Vec::new()))
                }
            }
        }

        fn register(&self) -> io::Result<AsyncFd<OwnedFd>> {
            #[expect(
                deprecated,
                reason = "its successor is unsafe, for types that may close or swap their descriptor; an OwnedFd does not"
            )]
            AsyncFd::with_interest(self.master.try_clone()?, Interest::READABLE)
        }

        pub(super) fn write(&self, bytes: &[u8]) {
            if self.client.is_some() {
                // Full or closed: the bytes are lost, as on a wire that nobody listens to.
                let _ = rustix::io::write(&self.master, bytes);
            }
        }

        /// What the client has set.
        pub(super) fn line(&self) -> LineSetting {
            let Ok(set) = tcgetattr(&self.master) else {
                return LineSetting { baud: 0, data_bits: 8, parity: Parity::None, stop_bits: 1 };
            };
            let input = |mode| set.input_modes.contains(mode);
            let control = |mode| set.control_modes.contains(mode);
            let parity = match (input(InputModes::INPCK), control(ControlModes::PARODD)) {
                (false, _) => Parity::None,
                (true, false) => Parity::Even,
                (true, true) => Parity::Odd,
            };
            LineSetting {
                baud: set.output_speed(),
                data_bits: if input(InputModes::ISTRIP) { 7 } else { 8 },
                parity,
                stop_bits: if control(ControlModes::CSTOPB) { 2 } else { 1 },
            }
        }
    }

    impl Drop for Pty {
        fn drop(&mut self) {
            let Some(link) = &self.link else { return };
            // Only what is still ours.
            if std::fs::read_link(link).is_ok_and(|target| target == Path::new(&self.slave)) {
                let _ = std::fs::remove_file(link);
            }
        }
    }

    /// A master side that does not block, and the name of its slave side.
    fn pair() -> rustix::io::Result<(OwnedFd, String)> {
        let master = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY)?;
        grantpt(&master)?;
        unlockpt(&master)?;
        rustix::io::fcntl_setfd(&master, rustix::io::FdFlags::CLOEXEC)?;
        let slave = ptsname(&master, Vec::new())?.to_string_lossy().into_owned();
        // Opened and closed once: only from then on the master sees that nobody is there.
        let side = rustix::fs::open(slave.as_str(), OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC, Mode::empty())?;
        set_idle(&side)?;
        drop(side);
        let flags = rustix::fs::fcntl_getfl(&master)?;
        rustix::fs::fcntl_setfl(&master, flags | OFlags::NONBLOCK)?;
        Ok((master, slave))
    }

    /// Raw, at the speed between two clients, without parity.
    fn set_idle(side: &impl AsFd) -> rustix::io::Result<()> {
        let mut set = tcgetattr(side)?;
        set.make_raw();
        set.input_modes.remove(InputModes::INPCK | InputModes::ISTRIP);
        set.control_modes.remove(ControlModes::CSTOPB | ControlModes::PARODD);
        set.set_speed(IDLE_BAUD)?;
        tcsetattr(side, OptionalActions::Now, &set)
    }

    /// Whether a client has the slave side open.
    fn is_open(master: &OwnedFd) -> rustix::io::Result<bool> {
        let mut polled = [PollFd::new(master, PollFlags::IN)];
        poll(&mut polled, Some(&Timespec { tv_sec: 0, tv_nsec: 0 }))?;
        let [polled] = polled;
        Ok(!polled.revents().contains(PollFlags::HUP))
    }

    fn make_link(slave: &str, link: &Path) -> Result<(), ServeError> {
        let failed = |why: String| ServeError::Link { path: link.to_owned(), why };
        match std::fs::symlink_metadata(link) {
            Ok(found) if !found.file_type().is_symlink() => {
                return Err(failed("a file that is no symbolic link is in its place".to_owned()));
            }
            Ok(_) => std::fs::remove_file(link).map_err(|error| failed(error.to_string()))?,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(failed(error.to_string())),
        }
        std::os::unix::fs::symlink(slave, link).map_err(|error| failed(error.to_string()))
    }
}

#[cfg(unix)]
#[cfg(test)]
#[expect(clippy::disallowed_methods, reason = "the clients of these tests live in real time")]
mod tests {
    use super::*;
    use std::io::{Read, Write};
    use tokio::sync::oneshot;

    const REQUEST: [u8; 8] = [0x01, 0x03, 0x21, 0x74, 0x00, 0x01, 0xCE, 0x2C];
    const REPLY: [u8; 7] = [0x01, 0x03, 0x02, 0x05, 0x6E, 0x3A, 0xF8];

    /// Serves the standard bench while `client` runs in a thread of its own with the name of the port; returns what
    /// the client returned, what was noted, and the bench.
    fn serve<T: Send + 'static>(
        place: Place,
        client: impl FnOnce(String) -> T + Send + 'static,
    ) -> (T, Vec<Note>, Bench) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        let mut bench = Bench::built_in();
        let mut server = Server::open(place).unwrap();
        let name = server.name();
        let (done, stop) = oneshot::channel();
        let client = std::thread::spawn(move || {
            let result = client(name);
            // The server sees the client go before it stops.
            std::thread::sleep(Duration::from_millis(50));
            let _ = done.send(());
            result
        });
        let mut notes = Vec::new();
        let stop = async {
            let end = tokio::time::timeout(Duration::from_secs(20), stop);
            assert!(end.await.is_ok(), "the client does not come to an end");
        };
        runtime.block_on(server.run(&mut bench, stop, |note| notes.push(note))).unwrap();
        (client.join().unwrap(), notes, bench)
    }

    fn open(name: &str, baud: u32, parity: serialport::Parity) -> serialport::TTYPort {
        let port = serialport::new(name, baud).parity(parity).timeout(Duration::from_secs(2));
        port.open_native().unwrap()
    }

    #[test]
    fn clients_come_one_after_the_other_and_replies_take_their_time() {
        let (times, notes, bench) = serve(Place::Pty { link: None }, |name| {
            let mut times = Vec::new();
            for _ in 0..2 {
                let mut port = open(&name, 19_200, serialport::Parity::Even);
                for _ in 0..3 {
                    let asked = Instant::now();
                    port.write_all(&REQUEST).unwrap();
                    let mut reply = [0; REPLY.len()];
                    port.read_exact(&mut reply).unwrap();
                    assert_eq!(reply, REPLY);
                    times.push(asked.elapsed());
                    std::thread::sleep(Duration::from_millis(5));
                }
                drop(port);
                std::thread::sleep(Duration::from_millis(50));
            }
            times
        });
        // 8 characters, 10 ms, 7 characters at 19200 8E1; never earlier.
        let fastest = Duration::from_micros(4_584 + 10_000 + 4_011);
        assert!(times.iter().all(|time| *time >= fastest), "{times:?}");
        assert!(times.iter().min().unwrap() < &(fastest + Duration::from_millis(15)), "{times:?}");
        assert_eq!(notes, [Note::Connected, Note::Left, Note::Connected, Note::Left]);
        assert_eq!((bench.totals().answered, bench.remarks()), (6, &[][..]));
    }

    #[test]
    fn a_drive_is_silent_to_another_speed_or_parity() {
        let (_, _, bench) = serve(Place::Pty { link: None }, |name| {
            for (baud, parity) in [
                (9_600, serialport::Parity::Even),
                (19_200, serialport::Parity::Odd),
                (19_200, serialport::Parity::None),
            ] {
                let mut port = serialport::new(&name, baud)
                    .parity(parity)
                    .timeout(Duration::from_millis(100))
                    .open_native()
                    .unwrap();
                port.write_all(&REQUEST).unwrap();
                assert!(port.read(&mut [0; 8]).is_err(), "{baud} {parity:?}");
            }
        });
        assert_eq!((bench.totals().ignored.wrong_line, bench.totals().answered), (3, 0));
    }

    #[test]
    fn a_link_names_the_port_and_goes_with_it() {
        let dir = tempfile::tempdir().unwrap();
        let link = dir.path().join("bench");
        let server = Server::open(Place::Pty { link: Some(link.clone()) }).unwrap();
        assert_eq!(server.name(), link.display().to_string());
        assert!(std::fs::read_link(&link).unwrap().exists());
        drop(server);
        assert!(std::fs::symlink_metadata(&link).is_err());
        std::fs::write(&link, "mine").unwrap();
        let error = Server::open(Place::Pty { link: Some(link.clone()) }).unwrap_err();
        assert!(error.to_string().ends_with("a file that is no symbolic link is in its place"), "{error}");
        assert_eq!(std::fs::read_to_string(&link).unwrap(), "mine");
    }

    #[test]
    fn after_a_flood_the_next_client_is_served_at_once() {
        let inside = Place::Tcp { addr: "127.0.0.1:0".parse().unwrap() };
        let (asked, notes, _) = serve(inside, |name| {
            let addr = name.strip_prefix("tcp://").unwrap().to_owned();
            let mut flood = std::net::TcpStream::connect(&addr).unwrap();
            // At 19200 baud ten minutes.
            flood.write_all(&vec![0x55; 1_000_000]).unwrap();
            drop(flood);
            std::thread::sleep(Duration::from_millis(200));
            let mut client = std::net::TcpStream::connect(addr).unwrap();
            client.set_read_timeout(Some(Duration::from_secs(2))).unwrap();
            let asked = Instant::now();
            client.write_all(&REQUEST).unwrap();
            let mut reply = [0; REPLY.len()];
            client.read_exact(&mut reply).unwrap();
            assert_eq!(reply, REPLY);
            asked.elapsed()
        });
        assert!(asked < Duration::from_millis(500), "{asked:?}");
        assert_eq!(notes.last(), Some(&Note::Left));
    }

    #[test]
    fn tcp_serves_every_drive_and_stays_at_home() {
        let outside = Place::Tcp { addr: "0.0.0.0:0".parse().unwrap() };
        assert!(matches!(Server::open(outside), Err(ServeError::NotLoopback(_))));
        let inside = Place::Tcp { addr: "127.0.0.1:0".parse().unwrap() };
        let (reply, notes, _) = serve(inside, |name| {
            let addr = name.strip_prefix("tcp://").unwrap().to_owned();
            let mut client = std::net::TcpStream::connect(addr).unwrap();
            client.set_read_timeout(Some(Duration::from_secs(2))).unwrap();
            client.write_all(&REQUEST).unwrap();
            let mut reply = [0; REPLY.len()];
            client.read_exact(&mut reply).unwrap();
            reply
        });
        assert_eq!((reply, notes), (REPLY, vec![Note::Connected, Note::Left]));
    }
}
