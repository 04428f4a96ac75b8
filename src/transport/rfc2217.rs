//! The client's side of a device server that speaks Telnet with COM-PORT-OPTION (RFC 2217). The state machine is the
//! crate `rfc2217`, which does no I/O; here it gets a connection and a clock.

use super::Wake;
use super::clock::Clock;
use crate::protocol::line::{LineSetting, Parity};
use crate::text::{Text, both};
use crate::tick::{Span, Tick};
use ::rfc2217::{Client, ComPortState, DataBits, Event, PortSettings, Purge, Setting, StopBits};
use std::io;
use tokio::io::AsyncWriteExt;
use tokio::net::TcpStream;

#[derive(Debug)]
pub(super) struct Telnet {
    client: Client,
    /// What still has to be written. Kept here, so that a wait may be given up in the midst of writing.
    unsent: Vec<u8>,
}

/// Why a device server has not taken a setting.
#[derive(Debug)]
pub(super) enum Unsettled {
    /// The connection is gone.
    Lost,
    /// It has no RFC 2217, or does not answer.
    Refused,
}

/// Answers to questions about options that may wait to be fetched, in bytes.
const MOST_UNSENT: usize = 64 * 1_024;
/// A server that does not acknowledge a purge is not waited for any longer.
const PURGE_LIMIT: Span = Span::from_millis(500);

impl Telnet {
    pub(super) fn new(line: LineSetting) -> Self {
        Telnet { client: Client::new(settings(line)), unsent: Vec::new() }
    }

    /// Asks for another setting; [`Telnet::settle`] has it done.
    pub(super) fn ask(&mut self, line: LineSetting) {
        self.client.set_port_settings(settings(line));
    }

    /// Has the server take the setting that was asked for and throw away what it received before; tells what it set
    /// in place of what was asked.
    pub(super) async fn settle(
        &mut self,
        stream: &mut TcpStream,
        clock: Clock,
        limit: Span,
    ) -> Result<Vec<Text>, Unsettled> {
        let until = clock.now() + limit;
        while self.is_open() && clock.now() < until && self.exchange(stream, clock, until).await?.is_some() {}
        if self.client.com_port_state() != ComPortState::Active {
            return Err(Unsettled::Refused);
        }
        self.client.purge(Purge::Receive);
        let until = clock.now() + PURGE_LIMIT;
        while let Some(events) = self.exchange(stream, clock, until).await? {
            if events.iter().any(|event| matches!(event, Event::Purged(_))) || clock.now() >= until {
                break;
            }
        }
        Ok(self.deviations())
    }

    pub(super) async fn send(&mut self, stream: &mut TcpStream, bytes: &[u8]) -> io::Result<()> {
        self.client.write_data(bytes);
        self.flush(stream).await
    }

    pub(super) async fn wait(&mut self, stream: &mut TcpStream, clock: Clock, until: Tick) -> io::Result<Wake> {
        loop {
            self.flush_some(stream)?;
            let Wake::Bytes(bytes) = clock.listen(stream, until).await? else { return Ok(Wake::Silence) };
            let data = self.client.receive(&bytes);
            while self.client.poll_event().is_some() {}
            if !data.is_empty() {
                return Ok(Wake::Bytes(data));
            }
            // Endless talk about options is silence.
            if clock.now() >= until {
                return Ok(Wake::Silence);
            }
        }
    }

    /// Writes what there is to write and takes what comes next; data are thrown away. `None` when the time is over.
    async fn exchange(
        &mut self,
        stream: &mut TcpStream,
        clock: Clock,
        until: Tick,
    ) -> Result<Option<Vec<Event>>, Unsettled> {
        let heard = async {
            self.flush_some(stream)?;
            clock.listen(stream, until).await
        };
        let Wake::Bytes(bytes) = heard.await.map_err(|_| Unsettled::Lost)? else { return Ok(None) };
        let _stale = self.client.receive(&bytes);
        Ok(Some(std::iter::from_fn(|| self.client.poll_event()).collect()))
    }

    /// Whether the server still owes an answer.
    fn is_open(&self) -> bool {
        match self.client.com_port_state() {
            ComPortState::Negotiating => true,
            ComPortState::Active => !self.client.pending_settings().is_empty(),
            ComPortState::Refused => false,
        }
    }

    async fn flush(&mut self, stream: &mut TcpStream) -> io::Result<()> {
        self.unsent.append(&mut self.client.take_output());
        while !self.unsent.is_empty() {
            let count = stream.write(&self.unsent).await?;
            self.unsent.drain(..count);
        }
        Ok(())
    }

    /// Writes what the server takes at once; the rest has time until the next turn. Answers that it asks for and never
    /// fetches pile up so far and no further: then it is lost.
    fn flush_some(&mut self, stream: &TcpStream) -> io::Result<()> {
        self.unsent.append(&mut self.client.take_output());
        match stream.try_write(&self.unsent) {
            Ok(count) => _ = self.unsent.drain(..count),
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => {}
            Err(error) => return Err(error),
        }
        if self.unsent.len() > MOST_UNSENT { Err(io::ErrorKind::OutOfMemory.into()) } else { Ok(()) }
    }

    fn deviations(&self) -> Vec<Text> {
        let silent = self.client.pending_settings();
        let silent = silent.iter().map(|setting| {
            both!(
                "the server does not say which {name} it set",
                "der Server sagt nicht, was er eingestellt hat: {name}",
                name = named(setting)
            )
        });
        let other = self.client.mismatched_settings();
        let other = other.iter().map(|setting| {
            both!(
                "asked for another {name}, the server set {set}",
                "{name}: verlangt war anderes, der Server stellte {set} ein",
                name = named(setting),
                set = self.set(setting)
            )
        });
        silent.chain(other).collect()
    }

    /// What the server says it has set.
    fn set(&self, setting: Setting) -> Text {
        let set = self.client.reported_settings();
        let told = match setting {
            Setting::BaudRate => set.baud_rate.map(|baud| baud.to_string()),
            Setting::DataBits => set.data_bits.map(|bits| format!("{bits:?}")),
            Setting::Parity => set.parity.map(|parity| format!("{parity:?}")),
            Setting::StopBits => set.stop_bits.map(|bits| format!("{bits:?}")),
            Setting::FlowControl => set.flow_control.map(|control| format!("{control:?}")),
        };
        told.map_or_else(|| both!("something unknown", "etwas Unbekanntes"), |told| Text::name(told.to_lowercase()))
    }
}

/// Without flow control: the line is RS-485.
fn settings(line: LineSetting) -> PortSettings {
    PortSettings {
        baud_rate: line.baud,
        data_bits: if line.data_bits == 7 { DataBits::Seven } else { DataBits::Eight },
        parity: match line.parity {
            Parity::Even => ::rfc2217::Parity::Even,
            Parity::Odd => ::rfc2217::Parity::Odd,
            Parity::None => ::rfc2217::Parity::None,
        },
        stop_bits: if line.stop_bits == 2 { StopBits::Two } else { StopBits::One },
        ..PortSettings::default()
    }
}

fn named(setting: Setting) -> Text {
    match setting {
        Setting::BaudRate => both!("{setting}", "Baudrate"),
        Setting::DataBits => both!("{setting}", "Datenbits"),
        Setting::Parity => both!("{setting}", "Parität"),
        Setting::StopBits => both!("{setting}", "Stoppbits"),
        Setting::FlowControl => both!("{setting}", "Flusskontrolle"),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Link, LinkError, Rs485};
    use super::*;
    use ::rfc2217::{Server, ServerEvent};
    use tokio::io::AsyncReadExt;
    use tokio::net::TcpListener;

    const LINE: LineSetting = LineSetting::rtu(19_200, Parity::Even);

    /// Opens a link to a device server that `serve` plays, and works with it for as long as the server lives.
    fn with_server(serve: impl AsyncFn(TcpStream), work: impl AsyncFnOnce(Result<Link, LinkError>)) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
        runtime.block_on(async {
            let listener = TcpListener::bind("127.0.0.1:0").await.unwrap();
            let port = format!("rfc2217://{}", listener.local_addr().unwrap()).parse().unwrap();
            let serving = async {
                loop {
                    serve(listener.accept().await.unwrap().0).await;
                }
            };
            tokio::select! {
                () = serving => {}
                () = async { work(Link::open(&port, LINE, Rs485::default()).await).await } => {}
            }
        });
    }

    /// A device server that takes every setting, has old bytes in its buffer, and answers each byte with 0xFF and the
    /// setting that it came at.
    async fn obey(mut stream: TcpStream) {
        let (mut server, mut line, mut buffer) =
            (Server::new(PortSettings::default()), PortSettings::default(), [0; 64]);
        server.write_data(b"old");
        loop {
            if stream.write_all(&server.take_output()).await.is_err() {
                return;
            }
            let Ok(count @ 1..) = stream.read(&mut buffer).await else { return };
            let data = server.receive(&buffer[..count]);
            while let Some(event) = server.poll_event() {
                if let ServerEvent::SettingsChanged(set) = event {
                    line = set;
                }
            }
            for byte in data {
                let told = format!("{} {:?} {:?} {:?}", line.baud_rate, line.data_bits, line.parity, line.stop_bits);
                server.write_data(&[byte, 0xFF]);
                server.write_data(told.as_bytes());
            }
        }
    }

    async fn answer(link: &mut Link, byte: u8, length: usize) -> Vec<u8> {
        link.send(&[byte]).await.unwrap();
        let (until, mut heard) = (link.now() + Span::from_secs(5), Vec::new());
        while heard.len() < length {
            match link.wait(until).await.unwrap() {
                Wake::Bytes(bytes) => heard.extend(bytes),
                Wake::Silence => break,
            }
        }
        heard
    }

    #[test]
    fn the_far_side_is_set_and_bytes_come_through_as_they_are() {
        with_server(obey, async |link| {
            let mut link = link.unwrap();
            assert!(link.can_set_line() && link.deviations().is_empty());
            let expected = b"\xFF\xFF19200 Eight Even One";
            assert_eq!(answer(&mut link, 0xFF, expected.len()).await, expected);
            link.set_line(LineSetting::ascii(9_600, Parity::None)).await.unwrap();
            let expected = b"x\xFF9600 Seven None Two";
            assert_eq!(answer(&mut link, b'x', expected.len()).await, expected);
            link.reopen().await.unwrap();
            assert_eq!(answer(&mut link, b'x', expected.len()).await, expected);
        });
    }

    #[test]
    fn a_server_that_sets_something_else_is_told_of() {
        // DO COM-PORT-OPTION, then 9600 baud, 8 data bits, no parity, 1 stop bit, no flow control (RFC 2217).
        const ANSWER: [&[u8]; 7] = [
            &[255, 253, 44],
            &[255, 250, 44, 101, 0, 0, 0x25, 0x80, 255, 240],
            &[255, 250, 44, 102, 8, 255, 240],
            &[255, 250, 44, 103, 1, 255, 240],
            &[255, 250, 44, 104, 1, 255, 240],
            &[255, 250, 44, 105, 1, 255, 240],
            &[255, 250, 44, 112, 1, 255, 240],
        ];
        let stubborn = async |mut stream: TcpStream| {
            let mut buffer = [0; 256];
            let mut answer = ANSWER.iter();
            while let Ok(1..) = stream.read(&mut buffer).await {
                // The settings are answered once they were asked for, the purge once all is set.
                let count = match answer.len() {
                    7 => 1,
                    6 => 5,
                    _ => 1,
                };
                for part in answer.by_ref().take(count) {
                    stream.write_all(part).await.unwrap();
                }
            }
        };
        with_server(stubborn, async |link| {
            let expected =
                ["asked for another baud rate, the server set 9600", "asked for another parity, the server set none"];
            let told: Vec<_> = link.unwrap().deviations().iter().map(|text| text.en.clone()).collect();
            assert_eq!(told, expected);
        });
    }

    /// A device server that says this again and again from the beginning, and fetches nothing.
    fn babbler(what: &'static [u8]) -> impl AsyncFn(TcpStream) {
        async move |mut stream: TcpStream| while stream.write_all(&what.repeat(1_000)).await.is_ok() {}
    }

    #[test]
    fn a_server_that_floods_is_given_up_in_time() {
        // Data; IAC NOP; DO an option that nobody has; the end of a subnegotiation that never ends.
        for what in [b"U".as_slice(), &[255, 241], &[255, 253, 99], &[255, 250, 44]] {
            with_server(babbler(what), async |link| {
                let error = link.unwrap_err();
                assert!(matches!(&error, LinkError::NoRfc2217(_) | LinkError::Lost(_)), "{error}");
            });
        }
    }

    #[test]
    fn endless_talk_about_options_is_silence() {
        let obeying = async |mut stream: TcpStream| {
            let (mut server, mut buffer) = (Server::new(PortSettings::default()), [0; 64]);
            let mut said = 0;
            loop {
                if stream.write_all(&server.take_output()).await.is_err() {
                    return;
                }
                let reading = tokio::time::timeout(std::time::Duration::from_millis(1), stream.read(&mut buffer));
                match reading.await {
                    Ok(Ok(count @ 1..)) => {
                        let _data = server.receive(&buffer[..count]);
                        while server.poll_event().is_some() {
                            said += 1;
                        }
                    }
                    Ok(_) => return,
                    // Settled: from now on nothing but NOP.
                    Err(_) if said > 5 => while stream.write_all(&[255, 241].repeat(200)).await.is_ok() {},
                    Err(_) => {}
                }
            }
        };
        with_server(obeying, async |link| {
            let mut link = link.unwrap();
            let until = link.now() + Span::from_millis(300);
            assert_eq!(link.wait(until).await.unwrap(), Wake::Silence);
            assert!(link.now().since(until) < Span::from_secs(30));
        });
    }

    #[test]
    fn a_server_that_is_set_and_then_fetches_nothing_ends_in_time() {
        // Settled, it takes no more than lies in the buffers on the way.
        let sulking = async |mut stream: TcpStream| {
            let (mut server, mut buffer) = (Server::new(PortSettings::default()), [0; 64]);
            loop {
                if stream.write_all(&server.take_output()).await.is_err() {
                    return;
                }
                let Ok(count @ 1..) = stream.read(&mut buffer).await else { return };
                let data = server.receive(&buffer[..count]);
                while server.poll_event().is_some() {}
                if !data.is_empty() {
                    break;
                }
            }
            std::future::pending::<()>().await;
        };
        with_server(sulking, async |link| {
            let mut link = link.unwrap();
            let error = loop {
                let begun = link.now();
                let sent = link.send(&[0; 65_536]).await;
                assert!(link.now().since(begun) < Span::from_secs(30));
                if let Err(error) = sent {
                    break error;
                }
            };
            assert!(matches!(error, LinkError::Stuck(_)), "{error}");
            assert!(
                matches!(link.send(&[1]).await, Err(LinkError::Lost(_))),
                "what follows would be taken for the rest"
            );
        });
    }

    #[test]
    fn a_telnet_server_without_the_option_is_refused() {
        let plain = async |mut stream: TcpStream| {
            stream.write_all(&[255, 254, 44]).await.unwrap(); // DONT COM-PORT-OPTION
            let mut buffer = [0; 256];
            while let Ok(1..) = stream.read(&mut buffer).await {}
        };
        with_server(plain, async |link| {
            let error = link.unwrap_err();
            assert!(matches!(&error, LinkError::NoRfc2217(_)), "{error}");
        });
    }
}
