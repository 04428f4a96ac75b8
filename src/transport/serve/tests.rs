//! The bench on pseudo terminals and TCP ports of this machine, with real clients.

use super::*;
use crate::simulator::Bench;
use serialport::SerialPort;
use std::io::{Read, Write};
use std::sync::mpsc;
use tokio::sync::oneshot;

const REQUEST: [u8; 8] = [0x01, 0x03, 0x21, 0x74, 0x00, 0x01, 0xCE, 0x2C];
const REPLY: [u8; 7] = [0x01, 0x03, 0x02, 0x05, 0x6E, 0x3A, 0xF8];

/// Longer than anything here takes on a busy machine.
const LIMIT: Duration = Duration::from_secs(60);

/// A client's port, and what the server has noted of its clients.
struct Client {
    name: String,
    noted: mpsc::Receiver<Note>,
}

impl Client {
    fn open(&self, baud: u32, parity: serialport::Parity) -> serialport::TTYPort {
        serialport::new(&self.name, baud).parity(parity).timeout(LIMIT).open_native().unwrap()
    }

    fn connect(&self) -> std::net::TcpStream {
        let client = std::net::TcpStream::connect(self.name.strip_prefix("tcp://").unwrap()).unwrap();
        client.set_read_timeout(Some(LIMIT)).unwrap();
        client
    }

    /// Goes away, and waits until the server has seen it.
    fn leave<P>(&self, port: P) {
        drop(port);
        while self.noted.recv_timeout(LIMIT).unwrap() != Note::Left {}
    }
}

/// Serves the standard bench while `client` runs in a thread of its own; returns what the client returned, what was
/// noted, and the bench.
fn serve<T: Send + 'static>(place: Place, client: impl FnOnce(&Client) -> T + Send + 'static) -> (T, Vec<Note>, Bench) {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let mut bench = Bench::built_in();
    let mut server = Server::open(place).unwrap();
    let name = server.name();
    let (done, stop) = oneshot::channel();
    let (tell, noted) = mpsc::channel();
    let client = std::thread::spawn(move || {
        let result = client(&Client { name, noted });
        let _ = done.send(());
        result
    });
    let mut notes = Vec::new();
    let stop = async {
        let end = tokio::time::timeout(4 * LIMIT, stop);
        assert!(end.await.is_ok(), "the client does not come to an end");
    };
    let note = |note: Note| {
        notes.push(note);
        // A client that has ended hears nothing any more.
        let _ = tell.send(note);
    };
    runtime.block_on(server.run(&mut bench, stop, note)).unwrap();
    (client.join().unwrap(), notes, bench)
}

#[test]
fn clients_come_one_after_the_other_and_replies_take_their_time() {
    let (times, notes, bench) = serve(Place::Pty { link: None }, |client| {
        let mut times = Vec::new();
        for _ in 0..2 {
            let mut port = client.open(19_200, serialport::Parity::Even);
            for _ in 0..3 {
                let asked = Instant::now();
                port.write_all(&REQUEST).unwrap();
                let mut reply = [0; REPLY.len()];
                port.read_exact(&mut reply).unwrap();
                assert_eq!(reply, REPLY);
                times.push(asked.elapsed());
                std::thread::sleep(Duration::from_millis(5));
            }
            client.leave(port);
        }
        times
    });
    // 8 characters, 10 ms, 7 characters at 19200 8E1; never earlier.
    let fastest = Duration::from_micros(4_584 + 10_000 + 4_011);
    assert!(times.iter().all(|time| *time >= fastest), "{times:?}");
    assert_eq!(notes, [Note::Connected, Note::Left, Note::Connected, Note::Left]);
    assert_eq!((bench.totals().answered, bench.remarks()), (6, &[][..]));
}

#[test]
fn a_drive_is_silent_to_another_speed_or_parity() {
    let (_, _, bench) = serve(Place::Pty { link: None }, |client| {
        for (baud, parity) in
            [(9_600, serialport::Parity::Even), (19_200, serialport::Parity::Odd), (19_200, serialport::Parity::None)]
        {
            let mut port = client.open(baud, parity);
            port.write_all(&REQUEST).unwrap();
            port.set_timeout(Duration::from_secs(1)).unwrap();
            assert!(port.read(&mut [0; 8]).is_err(), "{baud} {parity:?}");
            client.leave(port);
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
    let taken = Server::open(Place::Pty { link: Some(link.clone()) }).unwrap_err();
    assert!(taken.to_string().contains("which is in use"), "{taken}");
    assert!(std::fs::read_link(&link).unwrap().exists(), "and the link of the first is left alone");
    drop(server);
    assert!(std::fs::symlink_metadata(&link).is_err());
    // One that a crash has left leads to a terminal that is gone; what a user has made may lead anywhere.
    let point = |target: &str| {
        let _gone = std::fs::remove_file(&link);
        std::os::unix::fs::symlink(target, &link).unwrap();
        Server::open(Place::Pty { link: Some(link.clone()) }).map(drop).map_err(|error| error.to_string())
    };
    assert_eq!(point("/dev/pts/99999"), Ok(()));
    std::fs::write(dir.path().join("beside"), "mine").unwrap();
    for (target, why) in [
        ("beside", "which is in use"),
        ("nothing", "which is not there now"),
        ("/dev/ttyNONE", "which is not there now"),
    ] {
        let told = point(target).unwrap_err();
        assert!(told.contains(why), "{target}: {told}");
        assert_eq!(std::fs::read_link(&link).unwrap(), std::path::Path::new(target));
    }
    std::fs::remove_file(&link).unwrap();
    std::fs::write(&link, "mine").unwrap();
    let error = Server::open(Place::Pty { link: Some(link.clone()) }).unwrap_err();
    assert!(error.to_string().ends_with("a file that is no symbolic link is in its place"), "{error}");
    assert_eq!(std::fs::read_to_string(&link).unwrap(), "mine");
}

#[test]
fn after_a_flood_the_next_client_is_served_at_once() {
    let inside = Place::Tcp { addr: "127.0.0.1:0".parse().unwrap() };
    let (reply, notes, _) = serve(inside, |client| {
        let mut flood = client.connect();
        // At 19200 baud ten minutes, which nobody here waits for.
        flood.write_all(&vec![0x55; 1_000_000]).unwrap();
        client.leave(flood);
        asked(client)
    });
    assert_eq!((reply, notes.last()), (REPLY, Some(&Note::Left)));
}

#[test]
fn tcp_serves_every_drive_and_stays_at_home() {
    let outside = Place::Tcp { addr: "0.0.0.0:0".parse().unwrap() };
    assert!(matches!(Server::open(outside), Err(ServeError::NotLoopback(_))));
    let inside = Place::Tcp { addr: "127.0.0.1:0".parse().unwrap() };
    let (reply, notes, _) = serve(inside, asked);
    assert_eq!((reply, notes), (REPLY, vec![Note::Connected, Note::Left]));
}

/// What a client gets that asks once over TCP.
fn asked(client: &Client) -> [u8; REPLY.len()] {
    let mut stream = client.connect();
    stream.write_all(&REQUEST).unwrap();
    let mut reply = [0; REPLY.len()];
    stream.read_exact(&mut reply).unwrap();
    client.leave(stream);
    reply
}

/// A line on which nothing is to happen; how far it has come.
struct Idle(Tick);

impl Served for Idle {
    fn allow(&mut self, _: Span) {}
    fn master_sends(&mut self, _: Tick, _: LineSetting, _: &[u8]) {}
    fn next_event(&self) -> Option<Tick> {
        None
    }
    fn advance(&mut self, to: Tick) -> Vec<(Tick, u8)> {
        self.0 = to;
        Vec::new()
    }
    fn line_of(&self, _: &[u8]) -> Option<LineSetting> {
        None
    }
}

#[test]
fn the_bench_has_come_to_the_end_of_its_time_when_it_is_told_of() {
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
    let mut line = Idle(Tick::ZERO);
    runtime.block_on(async {
        let mut server = Server::open(Place::Tcp { addr: "127.0.0.1:0".parse().unwrap() }).unwrap();
        server.run(&mut line, Server::pause(Span::from_millis(100)), |_| {}).await.unwrap();
    });
    assert!(line.0 >= Tick::ZERO + Span::from_millis(100), "{:?}", line.0);
}
