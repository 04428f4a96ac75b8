//! A CAN interface of the kernel (SocketCAN) as an adapter that speaks SLCAN: what carries bytes carries this too, and a recording of it
//! plays back like any other. Whoever opened the interface has set its bit rate; it acknowledges what it hears, so it cannot only listen.

use super::can_rate;
use super::can_trouble::CanTrouble;
use super::clock::Clock;
use super::{Ends, LinkError, Wake};
use crate::protocol::can::{Body, Frame, Identifier, Payload};
use crate::simulator::{Adapter, AdapterOut, AdapterQuirks};
use crate::tick::{Span, Tick};
use socketcan::{CanSocket, Socket, SocketOptions};
use std::collections::VecDeque;
use std::io::{self, Read, Write};
use std::path::Path;
use std::pin::Pin;
use std::task::{Context, Poll, ready};
use tokio::io::unix::AsyncFd;
use tokio::io::{AsyncRead, ReadBuf};

/// A CAN interface.
#[derive(Debug)]
pub(super) struct CanLink {
    /// As it was named: `can:can0`.
    name: String,
    interface: String,
    /// Bits per second that it is to have.
    rate: u32,
    voice: Ends<Voice>,
    clock: Clock,
}

/// An open interface, and the adapter that it is made.
#[derive(Debug)]
struct Voice {
    socket: AsyncFd<CanSocket>,
    adapter: Adapter,
    /// What the adapter says and nobody has read yet.
    said: VecDeque<u8>,
    /// Frames for which the kernel had no room, and since when the first of them waits.
    waiting: VecDeque<Frame>,
    waits_since: Option<Tick>,
    trouble: Option<CanTrouble>,
}

/// The kernel tells nobody when it has room again (ENOBUFS), so that is tried again behind this; a frame that waits for longer than the second
/// is refused, as an adapter does whose bus takes nothing.
const AGAIN: Span = Span::from_millis(2);
const REFUSED: Span = Span::from_millis(1_000);
/// Where the kernel tells of its interfaces.
const INTERFACES: &str = "/sys/class/net";
/// Bytes of a frame of the kernel (struct can_frame): identifier with flags, length, three unused, eight of data.
const RAW: usize = 16;
const EXTENDED: u32 = 1 << 31;
const REMOTE: u32 = 1 << 30;
const ERROR: u32 = 1 << 29;
/// Of a frame that tells of errors (linux/can/error.h): its kinds, and of those of a controller which state it came to.
const CONTROLLER: u32 = 1 << 2;
const PROTOCOL: u32 = 1 << 3;
const NO_ACKNOWLEDGE: u32 = 1 << 5;
const BUS_OFF: u32 = 1 << 6;
const BUS_ERROR: u32 = 1 << 7;
const WARNING: u8 = 1 << 2 | 1 << 3;
const PASSIVE: u8 = 1 << 4 | 1 << 5;
/// The same as flags of an adapter (Lawicel CANUSB manual, F).
const FLAG_WARNING: u8 = 1 << 2;
const FLAG_PASSIVE: u8 = 1 << 5;
const FLAG_ERROR: u8 = 1 << 7;

impl CanLink {
    pub(super) fn open(name: String, interface: &str, rate: u32) -> Result<Self, LinkError> {
        let mut link =
            CanLink { name, interface: interface.to_owned(), rate, voice: Ends::Closed, clock: Clock::start() };
        link.reopen()?;
        Ok(link)
    }

    pub(super) fn reopen(&mut self) -> Result<(), LinkError> {
        self.voice = Ends::Closed;
        if let Some(why) = CanTrouble::of_interface(Path::new(INTERFACES), &self.interface) {
            return Err(self.ails(why));
        }
        if let Some(is) = can_rate::bit_rate(&self.interface).filter(|is| *is != self.rate) {
            return Err(self.ails(CanTrouble::Rate { is, meant: self.rate }));
        }
        let voice = Voice::open(&self.interface).map_err(|error| match CanTrouble::of_system(&error) {
            Some(why) => self.ails(why),
            None => LinkError::Setting { port: self.name.clone(), message: error.to_string() },
        })?;
        self.voice = Ends::Open(voice);
        Ok(())
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn now(&self) -> Tick {
        self.clock.now()
    }

    pub(super) fn outlast(&self, until: Tick) {
        if matches!(self.voice, Ends::Open(_)) {
            self.clock.sleep_until(until);
        }
    }

    pub(super) fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        let sent = match &mut self.voice {
            Ends::Open(voice) => voice.hear_host(bytes),
            Ends::Lost | Ends::Closed => Err(io::ErrorKind::NotConnected.into()),
        };
        sent.map_err(|error| self.lost(&error))
    }

    /// Hands over bytes at once, or not at all.
    pub(super) fn push(&mut self, bytes: &[u8]) -> bool {
        self.send(bytes).is_ok()
    }

    pub(super) async fn wait(&mut self, until: Tick) -> Result<Wake, LinkError> {
        let woken = match &mut self.voice {
            Ends::Open(voice) => voice.wait(&self.clock, until).await,
            Ends::Lost => Err(io::ErrorKind::NotConnected.into()),
            Ends::Closed => {
                self.clock.rest_until(until).await;
                Ok(Wake::Silence)
            }
        };
        woken.map_err(|error| self.lost(&error))
    }

    fn ails(&self, why: CanTrouble) -> LinkError {
        LinkError::Can { port: self.name.clone(), why }
    }

    fn lost(&mut self, error: &io::Error) -> LinkError {
        let told = match &mut self.voice {
            Ends::Open(voice) => voice.trouble.take(),
            Ends::Lost | Ends::Closed => None,
        };
        let lost = self.voice.lost(&self.name);
        told.or(CanTrouble::of_system(error)).map_or(lost, |why| self.ails(why))
    }
}

impl Voice {
    #[expect(
        deprecated,
        reason = "it asks for a descriptor that stays open, which the socket's is; the other way is unsafe"
    )]
    fn open(interface: &str) -> io::Result<Self> {
        let socket = CanSocket::open(interface)?;
        socket.set_nonblocking(true)?;
        socket.set_error_filter_accept_all()?;
        let quirks = AdapterQuirks { listens: false, latency: Span::ZERO, ..AdapterQuirks::default() };
        let (adapter, socket) = (Adapter::new(quirks), AsyncFd::new(socket)?);
        let (said, waiting) = (VecDeque::new(), VecDeque::new());
        Ok(Voice { socket, adapter, said, waiting, waits_since: None, trouble: None })
    }

    /// What its host tells the adapter.
    fn hear_host(&mut self, bytes: &[u8]) -> io::Result<()> {
        for &byte in bytes {
            for out in self.adapter.feed(byte) {
                match out {
                    AdapterOut::Says(text, _) => self.said.extend(text.bytes()),
                    AdapterOut::Sends(frame) => self.waiting.push_back(frame),
                }
            }
        }
        self.put()
    }

    /// Waits until something comes or the time is over; what waits for room goes out meanwhile.
    async fn wait(&mut self, clock: &Clock, until: Tick) -> io::Result<Wake> {
        loop {
            self.put()?;
            let since = (!self.waiting.is_empty()).then(|| self.waits_since.unwrap_or(clock.now()));
            self.waits_since = since;
            if since.is_some_and(|since| clock.now().since(since) > REFUSED) {
                self.waiting.clear();
                self.said.push_back(b'\x07');
            }
            let step = since.map_or(until, |_| until.min(clock.now() + AGAIN));
            match clock.listen(self, step).await? {
                Wake::Silence if step < until => {}
                wake => return Ok(wake),
            }
        }
    }

    /// Frames go out as long as the kernel has room for them.
    fn put(&mut self) -> io::Result<()> {
        while let Some(frame) = self.waiting.front() {
            match self.socket.get_mut().write(&raw(frame)) {
                Ok(_) => {}
                Err(error)
                    if error.kind() == io::ErrorKind::WouldBlock || error.raw_os_error() == Some(libc::ENOBUFS) =>
                {
                    return Ok(());
                }
                Err(error) => return Err(error),
            }
            self.waiting.pop_front();
            self.waits_since = None;
        }
        Ok(())
    }

    /// What came from the kernel.
    fn take(&mut self, bytes: &[u8; RAW]) -> io::Result<()> {
        match heard(bytes) {
            Some(Heard::Frame(frame)) => self.said.extend(self.adapter.hears(&frame).unwrap_or_default().bytes()),
            Some(Heard::Errors(flags)) => self.adapter.flags(flags),
            Some(Heard::BusOff) => {
                self.trouble = Some(CanTrouble::BusOff);
                return Err(io::ErrorKind::NotConnected.into());
            }
            None => {}
        }
        Ok(())
    }
}

impl AsyncRead for Voice {
    fn poll_read(self: Pin<&mut Self>, cx: &mut Context<'_>, buffer: &mut ReadBuf<'_>) -> Poll<io::Result<()>> {
        let voice = self.get_mut();
        while voice.said.is_empty() {
            let mut bytes = [0; RAW];
            let mut ready = ready!(voice.socket.poll_read_ready_mut(cx))?;
            match ready.try_io(|socket| socket.get_mut().read(&mut bytes)) {
                Ok(Ok(RAW)) => voice.take(&bytes)?,
                Ok(Err(error)) => return Poll::Ready(Err(error)),
                // Another kind of frame, or none after all.
                Ok(Ok(_)) | Err(_) => {}
            }
        }
        let count = voice.said.len().min(buffer.remaining());
        let bytes: Vec<u8> = voice.said.drain(..count).collect();
        buffer.put_slice(&bytes);
        Poll::Ready(Ok(()))
    }
}

/// What the kernel passes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Heard {
    Frame(Frame),
    /// Flags of an adapter.
    Errors(u8),
    BusOff,
}

fn heard(bytes: &[u8; RAW]) -> Option<Heard> {
    let (head, rest) = bytes.split_first_chunk()?;
    let id = u32::from_ne_bytes(*head);
    let ([length, ..], data) = rest.split_at_checked(4)? else { return None };
    let (kinds, number) = (id & !(EXTENDED | REMOTE | ERROR), id & Identifier::MAX_EXTENDED);
    if id & ERROR != 0 {
        let state = if kinds & CONTROLLER != 0 { *data.get(1)? } else { 0 };
        let flag = |is_so: bool, flag: u8| if is_so { flag } else { 0 };
        return Some(match kinds & BUS_OFF != 0 {
            true => Heard::BusOff,
            false => Heard::Errors(
                flag(state & WARNING != 0, FLAG_WARNING)
                    | flag(state & PASSIVE != 0, FLAG_PASSIVE)
                    | flag(kinds & (PROTOCOL | BUS_ERROR | NO_ACKNOWLEDGE) != 0, FLAG_ERROR),
            ),
        });
    }
    let identifier = if id & EXTENDED != 0 { Identifier::extended(number)? } else { Identifier::standard(number)? };
    let body = match id & REMOTE != 0 {
        true => Body::Remote(*length),
        false => Body::Data(Payload::new(data.get(..usize::from(*length))?)?),
    };
    Some(Heard::Frame(Frame { identifier, body }))
}

/// A frame as the kernel takes it.
fn raw(frame: &Frame) -> [u8; RAW] {
    let extended = if matches!(frame.identifier, Identifier::Extended(_)) { EXTENDED } else { 0 };
    let (remote, length) = match frame.body {
        Body::Remote(length) => (REMOTE, length),
        Body::Data(_) => (0, frame.bytes().len() as u8),
    };
    let id = (frame.identifier.number() | extended | remote).to_ne_bytes();
    let bytes = id.into_iter().chain([length, 0, 0, 0]).chain(frame.bytes().iter().copied());
    let mut raw = [0; RAW];
    raw.iter_mut().zip(bytes).for_each(|(place, byte)| *place = byte);
    raw
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::protocol::can::candump;

    fn frame(told: &str) -> Frame {
        match candump::what(told).unwrap() {
            candump::What::Frame(frame) => frame,
            candump::What::Trouble { .. } => unreachable!("{told} is a frame"),
        }
    }

    #[test]
    fn frames_of_the_kernel_are_frames() {
        for text in ["645#409B010000000000", "000#0205", "080#", "1ABCDEFF#01", "705#R1"] {
            let frame = frame(text);
            assert_eq!(heard(&raw(&frame)), Some(Heard::Frame(frame)), "{text}");
        }
        let data = raw(&frame("645#4001"));
        assert_eq!(data[..10], [u32::to_ne_bytes(0x645).as_slice(), &[2, 0, 0, 0, 0x40, 1]].concat());
        let mut long = data;
        long[4] = 9;
        assert_eq!(heard(&long), None);
    }

    #[test]
    fn errors_of_the_kernel_are_flags_of_an_adapter() {
        let told = |kinds: u32, state: u8| {
            let mut bytes = [0; RAW];
            bytes[..4].copy_from_slice(&(kinds | ERROR).to_ne_bytes());
            (bytes[4], bytes[9]) = (8, state);
            heard(&bytes)
        };
        assert_eq!(told(CONTROLLER, 1 << 3), Some(Heard::Errors(FLAG_WARNING)));
        assert_eq!(told(CONTROLLER | BUS_ERROR, 1 << 4), Some(Heard::Errors(FLAG_PASSIVE | FLAG_ERROR)));
        assert_eq!(told(NO_ACKNOWLEDGE, 0), Some(Heard::Errors(FLAG_ERROR)));
        assert_eq!(told(CONTROLLER | BUS_OFF, 0), Some(Heard::BusOff));
    }
}
