//! What carries bytes, and the clock that goes with it: a serial port, a port on the network, a recording, or the
//! built-in bench.
//!
//! Every link tells its own time: real on a line, virtual on the bench and on a recording, where a scan of 247 silent
//! addresses takes no time at all and every run of it is the same. This room knows no telegrams.

mod adapter;
mod between;
#[cfg(target_os = "linux")]
mod can;
#[cfg(target_os = "linux")]
mod can_rate;
#[cfg(target_os = "linux")]
mod can_trouble;
mod clock;
mod door;
mod error;
mod ioctl;
mod mailbox;
mod net;
mod port;
mod ports;
mod rfc2217;
mod rs485;
mod serial;
pub mod serve;
mod sim;
mod tape;
mod trace;
mod tty;

pub use adapter::{AdapterInfo, ErrorCounts, LowLatency};
pub use between::{Ailing, Between};
pub use error::LinkError;
pub use mailbox::Mailbox;
pub use port::{Endpoint, Port};
pub use ports::{PortInfo, list_ports};
pub use rs485::{Rs485, Rs485Mode};
pub use sim::witness;
pub use trace::{Trace, TraceLine, read_trace};

use crate::protocol::line::{LineSetting, Parity};
use crate::simulator::{Bench, Can, Profibus};
use crate::text::Text;
use crate::tick::{Span, Tick};
use net::Far;

/// What ended a wait.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wake {
    /// Bytes came.
    Bytes(Vec<u8>),
    /// The time is over.
    Silence,
}

/// A way to the drives.
#[derive(Debug)]
pub struct Link {
    carrier: Carrier,
    trace: Option<Trace>,
    /// What stands between telegrams and the bytes of an adapter.
    between: Option<Box<dyn Between>>,
}

#[derive(Debug)]
enum Carrier {
    Serial(Box<serial::SerialLink>),
    Net(Box<net::NetLink>),
    #[cfg(target_os = "linux")]
    Can(Box<can::CanLink>),
    Tape(Box<tape::TapeLink>),
    Sim(Box<sim::SimLink>),
    Beside(Mailbox),
}

/// Whether a port can be talked through.
#[derive(Debug)]
enum Ends<T> {
    Open(T),
    /// It was lost: whoever talks or listens is told so.
    Lost,
    /// It is being opened anew: until that succeeds, waiting only passes the time.
    Closed,
}

impl<T> Ends<T> {
    /// Lets go of a port that has failed.
    fn lost(&mut self, name: &str) -> LinkError {
        if matches!(self, Ends::Open(_)) {
            *self = Ends::Lost;
        }
        LinkError::Lost(name.to_owned())
    }
}

/// How an adapter is talked to that says nothing of it (CDC-ACM ignores it).
const ADAPTER: LineSetting = LineSetting { baud: 115_200, data_bits: 8, parity: Parity::None, stop_bits: 1 };

impl Link {
    /// Opens a port, with what came in before cleared; the bench is no port of this machine: [`Link::open_sim`]. A serial port is
    /// taken exclusively, and on Linux its driver is asked for low latency until it is closed. `rs485` concerns serial
    /// ports only. Takes up to 3 s to reach a host, and as long again for a device server to take its settings.
    pub async fn open(port: &Port, line: LineSetting, rs485: Rs485) -> Result<Self, LinkError> {
        let net = async |endpoint: &Endpoint, far| {
            let link = net::NetLink::open(port.to_string(), endpoint.clone(), far, line).await?;
            Ok::<_, LinkError>(Carrier::Net(Box::new(link)))
        };
        let carrier = match port {
            Port::Serial(name) => Carrier::Serial(Box::new(serial::SerialLink::open(name, line, rs485)?)),
            Port::Tcp(endpoint) => net(endpoint, Far::Raw).await?,
            Port::Rfc2217(endpoint) => net(endpoint, Far::Rfc2217).await?,
            Port::Mbtcp(endpoint) => net(endpoint, Far::Gateway).await?,
            // A bus has no characters; its adapter has, and most take any speed.
            Port::Slcan(port) => return Box::pin(Link::open(port, ADAPTER, Rs485::default())).await,
            #[cfg(target_os = "linux")]
            Port::Can(interface) => Carrier::Can(Box::new(can::CanLink::open(port.to_string(), interface, line.baud)?)),
            #[cfg(not(target_os = "linux"))]
            Port::Can(_) => return Err(LinkError::NotFound(port.to_string())),
            Port::Tape(file) => Carrier::Tape(Box::new(tape::TapeLink::open(file, line)?)),
            Port::Beside(mailbox) => Carrier::Beside(mailbox.clone()),
            Port::Sim(_) => return Err(LinkError::NotFound(port.to_string())),
        };
        Ok(Link::of(carrier))
    }

    fn of(carrier: Carrier) -> Self {
        Link { carrier, trace: None, between: None }
    }

    /// A bench in virtual time.
    pub fn open_sim(bench: Bench, line: LineSetting) -> Self {
        Link::of(Carrier::Sim(Box::new(sim::SimLink::new(bench, line))))
    }

    /// A PROFIBUS line in virtual time.
    pub fn open_profibus(bus: Profibus, line: LineSetting) -> Self {
        Link::of(Carrier::Sim(Box::new(sim::SimLink::profibus(bus, line))))
    }

    /// A CAN bus behind an adapter, in virtual time.
    pub fn open_can(bus: Can) -> Self {
        Link::of(Carrier::Sim(Box::new(sim::SimLink::can(bus, ADAPTER))))
    }

    /// From now on telegrams go to the adapter and come from it by this.
    pub fn put_between(&mut self, between: Box<dyn Between>) {
        self.between = Some(between);
    }

    /// Says to an adapter that it is over, if there is one, and waits for nothing.
    pub fn part(&mut self) {
        if let Some(between) = self.between.take() {
            self.push(between.farewell());
        }
    }

    /// Hands over bytes as they are, as far as that can be done at once, and waits for nothing.
    pub fn push(&mut self, bytes: &[u8]) {
        let at = self.now();
        let is_out = match &mut self.carrier {
            Carrier::Serial(link) => link.push(bytes),
            Carrier::Net(link) => link.push(bytes),
            #[cfg(target_os = "linux")]
            Carrier::Can(link) => link.push(bytes),
            Carrier::Sim(link) => link.send(bytes).is_ok(),
            Carrier::Tape(_) | Carrier::Beside(_) => false,
        };
        if let Some(trace) = self.trace.as_mut().filter(|_| is_out) {
            trace.sent(at, bytes);
        }
    }

    /// Why the trace ended early, if it did; once.
    pub fn take_trace_error(&mut self) -> Option<std::io::Error> {
        self.trace.as_mut()?.take_error()
    }

    /// Writes every chunk of bytes to a trace from now on.
    pub fn record_to(&mut self, trace: Trace) {
        self.trace = Some(trace);
    }

    /// Lets the time of the bench follow the wall clock from now on, for verbs that watch or hold: waiting really
    /// waits. The times that the link tells stay those of the bench. A real line does so anyway, a recording never.
    pub fn pace(&mut self) {
        if let Carrier::Sim(link) = &mut self.carrier {
            link.pace();
        }
    }

    /// Opens a port that was lost anew, with its clock going on: a USB adapter by its serial number, under whatever name it
    /// has now ([`Link::name`]), anything else by its name. Until that succeeds nothing can be sent, and waiting only
    /// passes the time. [`LinkError::Stranger`] if another adapter has the name.
    pub async fn reopen(&mut self) -> Result<(), LinkError> {
        match &mut self.carrier {
            Carrier::Serial(link) => link.reopen(),
            Carrier::Net(link) => link.reopen().await,
            #[cfg(target_os = "linux")]
            Carrier::Can(link) => link.reopen(),
            Carrier::Tape(_) => Ok(()),
            Carrier::Beside(mailbox) => Err(LinkError::Lost(mailbox.name().to_owned())),
            Carrier::Sim(link) => {
                link.reopen();
                Ok(())
            }
        }
    }

    /// What the serial port is called now, links as they were given; `None` of anything else.
    pub fn name(&self) -> Option<&str> {
        match &self.carrier {
            Carrier::Serial(link) => Some(link.name()),
            _ => None,
        }
    }

    /// Whether [`Link::set_line`] works: a raw TCP port or a gateway carries bytes only, its far side is set by other
    /// means.
    pub fn can_set_line(&self) -> bool {
        match &self.carrier {
            Carrier::Net(link) => link.can_set_line(),
            Carrier::Beside(_) => false,
            _ => true,
        }
    }

    /// Whether the bit rate of a CAN bus is set through it, in words of an adapter; an interface of the kernel has one already.
    pub fn can_set_bit_rate(&self) -> bool {
        #[cfg(target_os = "linux")]
        if let Carrier::Can(_) = self.carrier {
            return false;
        }
        true
    }

    /// Changes speed and character format of the open link, from the next telegram on; what came in before is
    /// discarded. Bytes that are still on their way out may be cut off: wait for them first. [`Link::deviations`]
    /// tells anew where the driver did not obey. On a recording nothing is set: it has its own.
    ///
    /// [`LinkError::Setting`] where the driver refuses, [`LinkError::Fixed`] and [`LinkError::NoRfc2217`] where nothing
    /// can be set, [`LinkError::Lost`] once the port
    /// is gone.
    pub async fn set_line(&mut self, line: LineSetting) -> Result<(), LinkError> {
        match &mut self.carrier {
            Carrier::Serial(link) => link.set_line(line)?,
            Carrier::Net(link) => link.set_line(line).await?,
            Carrier::Sim(link) => link.set_line(line),
            _ => {}
        }
        let at = self.now();
        if let Some(trace) = &mut self.trace {
            trace.line_set(at, line);
        }
        Ok(())
    }

    /// What the driver set in place of what was asked, if it did not obey in all.
    pub fn deviations(&self) -> &[Text] {
        match &self.carrier {
            Carrier::Serial(link) => link.deviations(),
            Carrier::Net(link) => link.deviations(),
            Carrier::Tape(link) => link.deviations(),
            _ => &[],
        }
    }

    /// What is known of the adapter behind the link; of anything but a tty only its name.
    pub fn adapter(&self) -> AdapterInfo {
        let named = |name: &str| AdapterInfo { name: name.to_owned(), ..AdapterInfo::default() };
        match &self.carrier {
            Carrier::Serial(link) => link.adapter(),
            Carrier::Net(link) => named(link.name()),
            #[cfg(target_os = "linux")]
            Carrier::Can(link) => named(link.name()),
            Carrier::Tape(_) => named("tape"),
            Carrier::Sim(_) => named("sim"),
            Carrier::Beside(mailbox) => named(mailbox.name()),
        }
    }

    /// The time of day in UTC (RFC 3339); the bench and a recording have none.
    pub fn utc(&self) -> Option<String> {
        self.since_1970().map(clock::utc)
    }

    /// The same since the beginning of 1970.
    pub fn since_1970(&self) -> Option<Span> {
        match &self.carrier {
            Carrier::Tape(_) | Carrier::Sim(_) => None,
            _ => Some(clock::since_1970()),
        }
    }

    /// Whether its time only goes on by waiting on it, and takes none then.
    pub fn stands_still(&self) -> bool {
        match &self.carrier {
            Carrier::Tape(_) | Carrier::Beside(_) => true,
            Carrier::Sim(link) => !link.is_paced(),
            _ => false,
        }
    }

    /// The time of this link.
    pub fn now(&self) -> Tick {
        match &self.carrier {
            Carrier::Serial(link) => link.now(),
            Carrier::Net(link) => link.now(),
            #[cfg(target_os = "linux")]
            Carrier::Can(link) => link.now(),
            Carrier::Tape(link) => link.now(),
            Carrier::Sim(link) => link.now(),
            Carrier::Beside(mailbox) => mailbox.now(),
        }
    }

    /// Puts bytes on the line. They may still be on their way when this returns; with [`Rs485Mode::Rts`] they are out,
    /// and the line is free.
    pub async fn send(&mut self, bytes: &[u8]) -> Result<(), LinkError> {
        let told = self.between.as_mut().map(|between| between.put(bytes));
        let bytes = told.as_deref().unwrap_or(bytes);
        let at = self.now();
        match &mut self.carrier {
            Carrier::Serial(link) => link.send(bytes).await?,
            Carrier::Net(link) => link.send(bytes).await?,
            #[cfg(target_os = "linux")]
            Carrier::Can(link) => link.send(bytes)?,
            Carrier::Tape(link) => link.send(bytes)?,
            Carrier::Sim(link) => link.send(bytes)?,
            Carrier::Beside(mailbox) => mailbox.send(bytes)?,
        }
        if let Some(trace) = &mut self.trace {
            trace.sent(at, bytes);
        }
        Ok(())
    }

    /// Waits until bytes come or the time is over; bytes that are there already come at once. What an adapter says that is no
    /// telegram ends no wait.
    pub async fn wait(&mut self, until: Tick) -> Result<Wake, LinkError> {
        loop {
            let wake = self.hear(until).await?;
            let (Some(between), Wake::Bytes(bytes)) = (&mut self.between, &wake) else { return Ok(wake) };
            let telegrams = between.take(bytes);
            match between.ailing() {
                Some(Ailing::Unsent) => return Err(LinkError::Unsent(self.known_as())),
                Some(Ailing::Unacknowledged(flags)) => {
                    return Err(LinkError::Unacknowledged { port: self.known_as(), flags });
                }
                None if !telegrams.is_empty() => return Ok(Wake::Bytes(telegrams)),
                // A bus that is busy with others must not hold up who waits.
                None if self.now() >= until => return Ok(Wake::Silence),
                None => {}
            }
        }
    }

    /// What the port is called in what is told of it.
    fn known_as(&self) -> String {
        self.adapter().name
    }

    async fn hear(&mut self, until: Tick) -> Result<Wake, LinkError> {
        let begun = self.now();
        let wake = match &mut self.carrier {
            Carrier::Serial(link) => link.wait(until).await?,
            Carrier::Net(link) => link.wait(until).await?,
            #[cfg(target_os = "linux")]
            Carrier::Can(link) => link.wait(until).await?,
            Carrier::Tape(link) => link.wait(until),
            Carrier::Sim(link) => link.wait(until).await?,
            Carrier::Beside(mailbox) => mailbox.wait(until).await?,
        };
        // Bytes that came while the thread slept are seen at the end of the wait, or a little later: not late, though.
        let at = self.now().min(until.max(begun));
        if let (Some(trace), Wake::Bytes(bytes)) = (&mut self.trace, &wake) {
            trace.received(at, bytes);
        }
        Ok(wake)
    }

    /// Keeps the line until a moment without listening, whatever else happens. A line that is lost is not kept, and in
    /// virtual time there is nobody to keep it from.
    pub fn outlast(&mut self, until: Tick) {
        match &self.carrier {
            Carrier::Serial(link) => link.outlast(until),
            Carrier::Net(link) => link.outlast(until),
            #[cfg(target_os = "linux")]
            Carrier::Can(link) => link.outlast(until),
            Carrier::Tape(_) | Carrier::Sim(_) | Carrier::Beside(_) => {}
        }
    }

    /// The bench behind the link, if it is one.
    pub fn bench(&mut self) -> Option<&mut Bench> {
        match &mut self.carrier {
            Carrier::Sim(link) => link.bench(),
            _ => None,
        }
    }
}
