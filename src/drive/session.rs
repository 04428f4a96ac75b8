//! An open line: asks questions, tells what goes over it, and turns what goes wrong into failures with a hint.

use super::pump::{self, Interrupt, PumpError};
use super::{decode, route::RegisterAddress, trouble};
use crate::exchange::modbus::{Answer, ExchangeError, Limits, Master};
use crate::exchange::{Record, Tally, Verdict};
use crate::failure::{Class, Failure};
use crate::outcome::Event;
use crate::profile::{Lang, Registry, Type};
use crate::protocol::line::LineSetting;
use crate::protocol::modbus::pdu::{Exception, Reply, Request};
use crate::protocol::modbus::{Framing, Hex};
use crate::simulator::Bench;
use crate::tick::{Span, Tick};
use crate::transport::{Link, LinkError, Port, Trace, list_ports};
use std::path::Path;

/// Number of the error register of the ACTIVE family; reading clears it (CM-485 manual 6.6).
pub(super) const ERROR_REGISTER: u32 = 11;

/// How to open a line.
#[derive(Debug)]
pub struct Opening<'a> {
    /// Where the drives are.
    pub port: &'a Port,
    /// Speed and character format.
    pub line: LineSetting,
    /// RTU or ASCII.
    pub framing: Framing,
    /// How long to wait for a reply; `None` for the manual's time.
    pub timeout: Option<Span>,
    /// How often to repeat a question; `None` for the usual number.
    pub retries: Option<u8>,
    /// File to record the line to.
    pub trace: Option<&'a Path>,
    /// Whether every telegram is told as an event.
    pub verbose: bool,
    /// Language of what is told.
    pub lang: Lang,
}

/// An open line.
pub struct Session<'a> {
    port: String,
    link: Link,
    master: Master,
    observe: &'a mut dyn FnMut(Event),
    interrupt: Interrupt,
    verbose: bool,
    lang: Lang,
}

impl std::fmt::Debug for Session<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Session").field("link", &self.link).field("master", &self.master).finish_non_exhaustive()
    }
}

/// The drive understood the question and said no.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refusal {
    /// Exception code of the reply.
    pub exception: Exception,
    /// The cause, read back from the error register at once (P.11).
    pub cause: Option<u16>,
}

/// Why a question brought no value.
#[derive(Debug, thiserror::Error)]
pub enum AccessError {
    /// The drive said no.
    #[error("refused: {}", .0.exception)]
    Refused(Refusal),
    /// No valid reply.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// The port is gone.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// Somebody pressed Ctrl-C.
    #[error("interrupted")]
    Interrupted,
}

impl<'a> Session<'a> {
    /// Opens the line.
    pub fn open(
        opening: Opening<'_>,
        registry: &Registry,
        interrupt: Interrupt,
        observe: &'a mut dyn FnMut(Event),
    ) -> Result<Self, Failure> {
        let Opening { port, line, framing, timeout, retries, trace, verbose, lang } = opening;
        let usual = Limits::default();
        let limits = Limits {
            reply_timeout: timeout.unwrap_or(usual.reply_timeout),
            retries: retries.unwrap_or(usual.retries),
            ..usual
        };
        let mut link = match port {
            Port::Serial(name) => Link::open_serial(name, line).map_err(|error| trouble::link(&error, lang))?,
            Port::Sim(file) => Link::open_sim(super::bench::load(file.as_deref(), registry)?, line),
        };
        if let Some(path) = trace {
            link.record_to(open_trace(path, &format!("{line}, {}", framing.name()))?);
        }
        for deviation in link.deviations() {
            observe(Event::Note(format!("{port}: {deviation}")));
        }
        let (port, master) = (port.to_string(), Master::new(framing, line, limits));
        Ok(Session { port, link, master, observe, interrupt, verbose, lang })
    }

    /// Asks a station and waits for the answer.
    pub async fn ask(&mut self, station: u8, request: Request) -> Result<Answer, AccessError> {
        self.master.ask(station, request, self.link.now());
        let outcome = pump::run(&mut self.master, &mut self.link, &self.interrupt).await;
        let records = self.master.take_records();
        if self.verbose {
            for record in records {
                (self.observe)(telegram_event(self.master.framing(), self.lang, &record));
            }
        }
        match outcome {
            Ok(Ok(answer)) => Ok(answer),
            Ok(Err(error)) => Err(error.into()),
            Err(PumpError::Link(error)) => Err(error.into()),
            Err(PumpError::Interrupted) => Err(AccessError::Interrupted),
        }
    }

    /// Asks a station for a reply that is no exception; after a refusal reads the cause back from the error register,
    /// at once, because anything else could read it away.
    pub async fn demand(&mut self, station: u8, request: Request) -> Result<(Reply, Span), AccessError> {
        match self.ask(station, request.clone()).await? {
            Answer::Broadcast => Ok((Reply::Registers(Vec::new()), Span::ZERO)),
            Answer::Reply { reply: Reply::Exception { code, .. }, .. } => {
                let tells = matches!(code, Exception::DeviceFailure | Exception::IllegalDataAddress);
                let cause = if tells { self.error_register(station).await? } else { None };
                // 0 is "nothing was refused": the register belongs to something else, or there is none.
                let cause = cause.filter(|&cause| cause != 0);
                Err(AccessError::Refused(Refusal { exception: code, cause }))
            }
            Answer::Reply { reply, after } => Ok((reply, after)),
        }
    }

    /// Reads, and so clears, the error register; `None` if the station does not answer it with a value.
    pub async fn error_register(&mut self, station: u8) -> Result<Option<u16>, AccessError> {
        let Some(at) = RegisterAddress::new(ERROR_REGISTER, 0) else { return Ok(None) };
        match self.ask(station, super::route::read(at, Type::Uint)).await {
            Ok(Answer::Reply { reply: Reply::Registers(values), .. }) => Ok(values.first().copied()),
            Ok(_) | Err(AccessError::Exchange(_)) => Ok(None),
            Err(error) => Err(error),
        }
    }

    /// Waits without asking anything; ends early with an error if somebody interrupts or the port is lost.
    pub async fn rest(&mut self, span: Span) -> Result<(), AccessError> {
        let result = pump::rest(&mut self.master, &mut self.link, &self.interrupt, span).await;
        result.map_err(|error| match error {
            PumpError::Link(error) => error.into(),
            PumpError::Interrupted => AccessError::Interrupted,
        })
    }

    /// From now on the line is used whether somebody interrupts or not: for the stop that must still go out.
    pub fn ignore_interrupts(&mut self) {
        self.interrupt = Interrupt::default();
    }

    /// Opens a port that was lost anew; its clock goes on. Then listens for as long as a reply may take, so that what
    /// was on its way to a lost question is nobody's answer.
    pub async fn reopen(&mut self) -> Result<(), AccessError> {
        self.link.reopen()?;
        self.rest(self.limits().reply_timeout).await
    }

    /// Lets the time of the bench follow the wall clock from now on, for verbs that watch or hold.
    pub fn pace(&mut self) {
        self.link.pace();
    }

    /// The time of the link.
    pub fn now(&self) -> Tick {
        self.link.now()
    }

    /// Tells an event to whoever watches.
    pub fn tell(&mut self, event: Event) {
        (self.observe)(event);
    }

    /// Counts of what happened on the line.
    pub fn tally(&self) -> Tally {
        self.master.tally()
    }

    /// Time limits.
    pub fn limits(&self) -> Limits {
        self.master.limits()
    }

    /// Other time limits from now on.
    pub fn set_limits(&mut self, limits: Limits) {
        self.master.set_limits(limits);
    }

    /// Other number of repeats from now on; returns the one that held until now.
    pub fn set_retries(&mut self, retries: u8) -> u8 {
        let limits = self.limits();
        self.set_limits(Limits { retries, ..limits });
        limits.retries
    }

    /// Name of the port.
    pub fn port(&self) -> &str {
        &self.port
    }

    /// How telegrams are framed.
    pub fn framing(&self) -> Framing {
        self.master.framing()
    }

    /// Setting of the line.
    pub fn line(&self) -> LineSetting {
        self.master.line()
    }

    /// The bench behind the line, if it is the simulator.
    pub fn bench(&mut self) -> Option<&mut Bench> {
        self.link.bench()
    }
}

/// A drive that answers late may still owe a reply. Nobody else gets the line before it has come or cannot come any
/// more: the next program would take it for the answer to its own question. Costs nothing unless a reply is missing.
impl Drop for Session<'_> {
    fn drop(&mut self) {
        if let Some(until) = self.master.owes_until(self.link.now()) {
            self.link.outlast(until);
        }
    }
}

/// The port that was named, or the one USB serial adapter that is plugged in, which is said.
pub fn open_port(named: Option<&Port>, lang: Lang, observe: &mut dyn FnMut(Event)) -> Result<Port, Failure> {
    if let Some(port) = named {
        return Ok(port.clone());
    }
    let ports = list_ports();
    let adapters: Vec<_> = ports.iter().filter(|port| port.usb).collect();
    if let [only] = adapters.as_slice() {
        let taking = lang.pick("no port given, taking", "kein Anschluss angegeben, es wird genommen:");
        observe(Event::Note(format!("{taking} {} ({})", only.name, only.about)));
        return Ok(Port::Serial(only.name.clone()));
    }
    let message = match (adapters.len(), lang) {
        (0, Lang::En) => "no port given, and no USB serial adapter is plugged in",
        (0, Lang::De) => "kein Anschluss angegeben, und kein USB-Adapter ist eingesteckt",
        (_, Lang::En) => "no port given, and more than one USB serial adapter is plugged in",
        (_, Lang::De) => "kein Anschluss angegeben, und mehr als ein USB-Adapter ist eingesteckt",
    };
    let hint = format!("{} -p; {}", lang.pick("name it with", "angeben mit"), trouble::found_ports(lang));
    Err(Failure::new(Class::Port, "port.none", message).hint(hint))
}

fn open_trace(path: &Path, about: &str) -> Result<Trace, Failure> {
    let file = std::fs::File::create(path).and_then(|file| Trace::new(Box::new(file), about));
    file.map_err(|error| Failure::new(Class::Data, "data.trace", format!("{}: {error}", path.display())))
}

fn telegram_event(framing: Framing, lang: Lang, record: &Record) -> Event {
    let (direction, is_request) = match record.verdict {
        Verdict::Request | Verdict::Fence => ('>', Some(true)),
        Verdict::Reply => ('<', Some(false)),
        Verdict::Stray { .. } | Verdict::Garbage => ('~', Some(false)),
    };
    let reader = decode::Reader { framing, family: None, lang };
    let told = reader.telegram(&record.bytes, is_request);
    let meaning = match record.verdict {
        Verdict::Fence => format!("fence: {}", told.meaning),
        Verdict::Stray { station } => format!("not the answer, from address {station}: {}", told.meaning),
        _ => told.meaning,
    };
    Event::Telegram { at_us: record.at.as_micros(), direction, hex: Hex(&record.bytes).to_string(), meaning }
}

impl AccessError {
    /// Whether the whole session is over, not just this question.
    pub fn is_fatal(&self) -> bool {
        matches!(self, AccessError::Link(_) | AccessError::Interrupted)
    }

    /// Whether the drive said no.
    pub fn is_refused(&self) -> bool {
        matches!(self, AccessError::Refused(_))
    }
}
