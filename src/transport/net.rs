//! A serial line or a gateway behind a TCP connection.

use super::clock::Clock;
use super::rfc2217::{Telnet, Unsettled};
use super::{Endpoint, Ends, LinkError, Wake};
use crate::files::of_system;
use crate::protocol::line::LineSetting;
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use std::io;
use tokio::io::AsyncWriteExt;
use tokio::net::TcpStream;

/// What a TCP connection leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Far {
    /// A device server that passes bytes on as they are.
    Raw,
    /// A device server whose serial side is set through the connection.
    Rfc2217,
    /// A gateway that knows the telegrams.
    Gateway,
}

#[derive(Debug)]
pub(super) struct NetLink {
    /// As it was named: `tcp://host:4001`.
    name: String,
    endpoint: Endpoint,
    far: Far,
    line: LineSetting,
    connection: Ends<Connection>,
    clock: Clock,
    deviations: Vec<Text>,
}

#[derive(Debug)]
struct Connection {
    stream: TcpStream,
    telnet: Option<Telnet>,
}

/// Longest time to reach a host, and longest time for a device server to take its settings.
const LIMIT: Span = Span::from_secs(3);
/// How long a raw device server gets to bring what was left in it.
const STALE: Span = Span::from_millis(5);
/// A far side that has not taken a telegram within this time does not fetch what is sent to it.
const STUCK: Span = Span::from_secs(1);

impl NetLink {
    pub(super) async fn open(name: String, endpoint: Endpoint, far: Far, line: LineSetting) -> Result<Self, LinkError> {
        let (connection, clock, deviations) = (Ends::Closed, Clock::start(), Vec::new());
        let mut link = NetLink { name, endpoint, far, line, connection, clock, deviations };
        link.reopen().await?;
        Ok(link)
    }

    /// Connects anew; the clock goes on.
    pub(super) async fn reopen(&mut self) -> Result<(), LinkError> {
        self.connection = Ends::Closed;
        let connecting = tokio::time::timeout(LIMIT.into(), connect(&self.endpoint)).await;
        let stream =
            connecting.map_err(|_| self.unreachable(silent()))?.map_err(|error| self.unreachable(of_system(&error)))?;
        let telnet = (self.far == Far::Rfc2217).then(|| Telnet::new(self.line));
        let mut connection = Connection { stream, telnet };
        if self.far == Far::Raw {
            connection.discard(self.clock).await.map_err(|error| self.unreachable(of_system(&error)))?;
        }
        self.deviations = connection.settle(self.clock).await.map_err(|why| self.unsettled(why))?;
        self.connection = Ends::Open(connection);
        Ok(())
    }

    pub(super) fn can_set_line(&self) -> bool {
        self.far == Far::Rfc2217
    }

    /// Sets the serial side of the device server; what came in with the old setting is discarded.
    pub(super) async fn set_line(&mut self, line: LineSetting) -> Result<(), LinkError> {
        if line == self.line {
            return Ok(());
        }
        let Ends::Open(connection) = &mut self.connection else { return Err(LinkError::Lost(self.name.clone())) };
        let Some(telnet) = &mut connection.telnet else { return Err(LinkError::Fixed(self.name.clone())) };
        telnet.ask(line);
        self.line = line;
        match connection.settle(self.clock).await {
            Ok(deviations) => self.deviations = deviations,
            Err(Unsettled::Lost) => return Err(self.connection.lost(&self.name)),
            Err(why) => return Err(self.unsettled(why)),
        }
        Ok(())
    }

    pub(super) fn deviations(&self) -> &[Text] {
        &self.deviations
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn now(&self) -> Tick {
        self.clock.now()
    }

    /// Keeps the line until a moment, if there still is one.
    pub(super) fn outlast(&self, until: Tick) {
        if matches!(self.connection, Ends::Open(_)) {
            self.clock.sleep_until(until);
        }
    }

    pub(super) async fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        let sending = async {
            match &mut self.connection {
                Ends::Open(connection) => connection.send(bytes).await,
                Ends::Lost | Ends::Closed => Err(io::ErrorKind::NotConnected.into()),
            }
        };
        match tokio::time::timeout(STUCK.into(), sending).await {
            Ok(Ok(())) => Ok(()),
            Ok(Err(_)) => Err(self.connection.lost(&self.name)),
            // A piece of it may be out, and a stream has no pauses: whatever follows would be taken for the rest.
            Err(_) => {
                self.connection.lost(&self.name);
                Err(LinkError::Stuck(self.name.clone()))
            }
        }
    }

    /// Hands over bytes at once, or not at all.
    pub(super) fn push(&mut self, bytes: &[u8]) -> bool {
        match &self.connection {
            Ends::Open(Connection { stream, telnet: None }) => stream.try_write(bytes).is_ok(),
            _ => false,
        }
    }

    pub(super) async fn wait(&mut self, until: Tick) -> Result<Wake, LinkError> {
        let woken = match &mut self.connection {
            Ends::Open(connection) => connection.wait(self.clock, until).await,
            Ends::Lost => Err(io::ErrorKind::NotConnected.into()),
            Ends::Closed => {
                self.clock.rest_until(until).await;
                Ok(Wake::Silence)
            }
        };
        woken.map_err(|_| self.connection.lost(&self.name))
    }

    fn unreachable(&self, message: Text) -> LinkError {
        LinkError::Unreachable { port: self.name.clone(), message }
    }

    fn unsettled(&self, why: Unsettled) -> LinkError {
        match why {
            Unsettled::Lost => LinkError::Lost(self.name.clone()),
            Unsettled::Refused => LinkError::NoRfc2217(self.name.clone()),
        }
    }
}

impl Connection {
    async fn send(&mut self, bytes: &[u8]) -> io::Result<()> {
        match &mut self.telnet {
            Some(telnet) => telnet.send(&mut self.stream, bytes).await,
            None => self.stream.write_all(bytes).await,
        }
    }

    async fn wait(&mut self, clock: Clock, until: Tick) -> io::Result<Wake> {
        match &mut self.telnet {
            Some(telnet) => telnet.wait(&mut self.stream, clock, until).await,
            None => clock.listen(&mut self.stream, until).await,
        }
    }

    /// Has a device server take the setting that its client asks for; tells what it set in place of it.
    async fn settle(&mut self, clock: Clock) -> Result<Vec<Text>, Unsettled> {
        match &mut self.telnet {
            Some(telnet) => telnet.settle(&mut self.stream, clock, LIMIT).await,
            None => Ok(Vec::new()),
        }
    }

    /// Throws away what comes at once, and no longer, whatever comes.
    async fn discard(&mut self, clock: Clock) -> io::Result<()> {
        let until = clock.now() + STALE;
        while let Wake::Bytes(_) = clock.listen(&mut self.stream, until).await?
            && clock.now() < until
        {}
        Ok(())
    }
}

fn silent() -> Text {
    both!("no answer within {LIMIT}", "keine Antwort innerhalb von {LIMIT}")
}

async fn connect(endpoint: &Endpoint) -> io::Result<TcpStream> {
    let stream = TcpStream::connect((endpoint.host.as_str(), endpoint.port)).await?;
    // Telegrams are small and every one of them is waited for: nothing may be held back for the next.
    stream.set_nodelay(true)?;
    Ok(stream)
}

#[cfg(test)]
mod tests {
    use super::super::{Link, Port, Rs485};
    use super::*;
    use crate::protocol::line::Parity;
    use tokio::io::AsyncReadExt;
    use tokio::net::TcpListener;

    const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

    async fn listener(scheme: &str) -> (TcpListener, Port) {
        let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
        let port = format!("{scheme}://{}", listener.local_addr().unwrap()).parse().unwrap();
        (listener, port)
    }

    fn run(test: impl Future<Output = ()>) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        runtime.block_on(test);
    }

    /// Opens a link to a listener and takes the connection.
    async fn pair(scheme: &str) -> (Link, TcpStream, TcpListener) {
        let (listener, port) = listener(scheme).await;
        let (link, accepted) = tokio::join!(Link::open(&port, LINE, Rs485::default()), listener.accept());
        (link.unwrap(), accepted.unwrap().0, listener)
    }

    #[test]
    fn a_raw_port_carries_bytes_as_they_are() {
        run(async {
            let (mut link, mut server, _listener) = pair("tcp").await;
            link.send(&[1, 0xFF, 3]).await.unwrap();
            let mut got = [0; 3];
            server.read_exact(&mut got).await.unwrap();
            assert_eq!(got, [1, 0xFF, 3]);
            server.write_all(&[0xFF, 0xFF]).await.unwrap();
            let until = link.now() + Span::from_secs(5);
            assert_eq!(link.wait(until).await.unwrap(), Wake::Bytes(vec![0xFF, 0xFF]));
            let until = link.now() + Span::from_millis(5);
            assert_eq!(link.wait(until).await.unwrap(), Wake::Silence);
        });
    }

    #[test]
    fn what_a_raw_server_had_left_is_discarded() {
        run(async {
            let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
            let stream = TcpStream::connect(listener.local_addr().unwrap()).await.unwrap();
            let mut server = listener.accept().await.unwrap().0;
            server.write_all(b"old").await.unwrap();
            stream.readable().await.unwrap();
            let mut connection = Connection { stream, telnet: None };
            let clock = Clock::start();
            connection.discard(clock).await.unwrap();
            server.write_all(b"new").await.unwrap();
            let heard = connection.wait(clock, clock.now() + Span::from_secs(5)).await.unwrap();
            assert_eq!(heard, Wake::Bytes(b"new".to_vec()));
        });
    }

    #[test]
    fn a_server_that_floods_is_connected_to_in_time() {
        run(async {
            let (listener, port) = listener("tcp").await;
            let flood = async {
                let mut server = listener.accept().await.unwrap().0;
                while server.write_all(&[0x55; 4_096]).await.is_ok() {}
            };
            let work = async {
                let mut link = Link::open(&port, LINE, Rs485::default()).await.unwrap();
                assert!(link.now() < Tick::ZERO + Span::from_secs(30));
                let until = link.now() + Span::from_secs(5);
                assert!(matches!(link.wait(until).await, Ok(Wake::Bytes(bytes)) if bytes.len() <= 512));
            };
            tokio::select! { () = flood => {} () = work => {} }
        });
    }

    #[test]
    fn a_server_that_fetches_nothing_ends_in_time() {
        run(async {
            for scheme in ["tcp", "mbtcp"] {
                let (mut link, _server, _listener) = pair(scheme).await;
                let error = loop {
                    if let Err(error) = link.send(&[0; 65_536]).await {
                        break error;
                    }
                };
                assert!(matches!(error, LinkError::Stuck(_)), "{error}");
                assert!(matches!(link.send(&[1]).await, Err(LinkError::Lost(_))));
            }
        });
    }

    #[test]
    fn a_connection_that_ends_is_lost_at_once_and_comes_back() {
        run(async {
            for scheme in ["tcp", "mbtcp"] {
                let (mut link, server, listener) = pair(scheme).await;
                drop(server);
                let until = link.now() + Span::from_secs(60);
                assert!(matches!(link.wait(until).await, Err(LinkError::Lost(_))));
                assert!(link.now() < until);
                assert!(matches!(link.send(&[1]).await, Err(LinkError::Lost(_))));
                assert!(matches!(link.wait(until).await, Err(LinkError::Lost(_))));
                let (reopened, accepted) = tokio::join!(link.reopen(), listener.accept());
                reopened.unwrap();
                link.send(&[7]).await.unwrap();
                assert_eq!(accepted.unwrap().0.read_u8().await.unwrap(), 7);
            }
        });
    }

    #[test]
    fn nobody_there_is_unreachable_and_waiting_for_it_passes_the_time() {
        run(async {
            let (mut link, server, listener) = pair("tcp").await;
            drop((server, listener));
            let error = link.reopen().await.unwrap_err();
            assert!(matches!(error, LinkError::Unreachable { .. }), "{error}");
            let until = link.now() + Span::from_millis(5);
            assert_eq!(link.wait(until).await.unwrap(), Wake::Silence);
            assert!(link.now() >= until);
        });
    }

    #[test]
    fn the_far_side_of_a_raw_port_cannot_be_set() {
        run(async {
            for scheme in ["tcp", "mbtcp"] {
                let (mut link, _server, _listener) = pair(scheme).await;
                assert!(!link.can_set_line());
                link.set_line(LINE).await.unwrap();
                let error = link.set_line(LineSetting { baud: 9_600, ..LINE }).await.unwrap_err();
                assert!(matches!(&error, LinkError::Fixed(_)), "{error}");
            }
        });
    }
}
