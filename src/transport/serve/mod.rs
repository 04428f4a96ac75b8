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

mod backlog;
#[cfg(unix)]
mod pty;
mod tcp;
#[cfg(unix)]
#[cfg(test)]
#[expect(clippy::disallowed_methods, reason = "the clients of these tests live in real time")]
mod tests;

use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::{Parting, Served};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use crate::transport::clock::THREAD_SLEEPS_FROM;
use backlog::Backlog;
use std::future::Future;
use std::io;
use std::net::SocketAddr;
use std::path::PathBuf;
use std::pin::pin;
use std::time::{Duration, Instant};
use tcp::Tcp;

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
    #[error("cannot make the link {}: {}", path.display(), why.en)]
    Link {
        /// The link.
        path: PathBuf,
        /// What is in the way.
        why: Text,
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

impl ServeError {
    /// In words for people.
    pub fn text(&self) -> Text {
        match self {
            ServeError::Pty(why) => {
                both!("{self}", "das Pseudoterminal lässt sich nicht anlegen: {why}")
            }
            ServeError::Link { path, why } => {
                let path = path.display();
                both!("cannot make the link {path}: {why}", "der Link {path} lässt sich nicht anlegen: {why}", why)
            }
            ServeError::NotLoopback(addr) => {
                both!("{self}", "{addr} ist keine Loopback-Adresse; erwartet: 127.0.0.1:PORT oder [::1]:PORT")
            }
            ServeError::Tcp { addr, why } => both!("{self}", "tcp://{addr} lässt sich nicht öffnen: {why}"),
        }
    }
}

/// A port with a bench behind it.
#[derive(Debug)]
pub struct Server {
    opened: Instant,
    port: Port,
}

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
            // Windows has no pseudo terminals.
            #[cfg(not(unix))]
            Place::Pty { link: None } => Port::Tcp(Tcp::open(std::net::SocketAddr::from(([127, 0, 0, 1], 0)))?),
            #[cfg(not(unix))]
            Place::Pty { .. } => return Err(ServeError::Pty(io::ErrorKind::Unsupported.into())),
            Place::Tcp { addr } if !addr.ip().is_loopback() => return Err(ServeError::NotLoopback(addr)),
            Place::Tcp { addr } => Port::Tcp(Tcp::open(addr)?),
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
        bench: &mut impl Served,
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
            if let Some(parting) = bench.hangs_up()
                && self.port.hang_up(parting)
            {
                backlog.leave();
                note(Note::Left);
            }
            let next = bench.next_event().into_iter().chain(backlog.goes_on()).min();
            let opened = self.opened;
            tokio::select! {
                biased;
                () = &mut stop => {
                    // What nobody waits for happens all the same: a ramp that ends.
                    bench.advance(self.now());
                    return Ok(());
                }
                change = self.port.change() => match change? {
                    Change::Connected => note(Note::Connected),
                    Change::Left => {
                        backlog.leave();
                        note(Note::Left);
                    }
                    Change::Bytes(bytes) => {
                        let line = self.port.line().map(|set| bench.meant(set));
                        let line = line.or(bench.line_of(&bytes)).unwrap_or(FACTORY);
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
            Port::Tcp(tcp) => tcp.write(bytes),
        }
    }

    /// Ends the connection of a client, if there is one that can be ended.
    fn hang_up(&mut self, parting: Parting) -> bool {
        match self {
            #[cfg(unix)]
            Port::Pty(_) => false,
            Port::Tcp(tcp) => tcp.hang_up(parting),
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
