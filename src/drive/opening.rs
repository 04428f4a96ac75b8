//! How a line is opened: what with where nobody says otherwise, at which port, and whether it is recorded.

use super::trouble;
use crate::exchange::Limits;
use crate::failure::{Class, Failure};
use crate::files::{self, FileError, of_system};
use crate::outcome::{Event, Warning};
use crate::protocol::Protocol;
use crate::protocol::dp::NAME as DP;
use crate::protocol::line::{LineSetting, Parity};
use crate::protocol::modbus::Framing;
use crate::text::both;
use crate::tick::Span;
use crate::transport::{Link, Port, Rs485, Trace, list_ports};
use std::path::Path;

/// A gateway waits for its stations itself and then says so; many wait for a second or more.
const GATEWAY_PATIENCE: Span = Span::from_secs(3);
/// TCP loses nothing, and a gateway says itself when a station is silent: one that says nothing is asked once.
const GATEWAY_REPEATS: u8 = 0;

/// An adapter or a bridge loses frames, and nothing on the bus says so: where one in ten is lost either way, six repeats leave one question in
/// a hundred thousand without an answer.
const BUS_REPEATS: u8 = 6;

/// Behind both halves of a request over PKW and what is borne of a slave besides, whoever keeps it going says himself that it is silent.
const SLAVE_PATIENCE: Span = Span::from_secs(15);

/// How to open a line.
#[derive(Debug)]
pub struct Opening<'a> {
    /// Where the drives are.
    pub port: &'a Port,
    /// Speed and character format.
    pub line: LineSetting,
    /// Who switches the direction of an RS-485 line.
    pub rs485: Rs485,
    /// What is spoken.
    pub protocol: Protocol,
    /// Whether PROFIBUS-DP is spoken there, to which we only listen; `protocol` says nothing then.
    pub profibus: bool,
    /// How long to wait for a reply; `None` for the manual's time.
    pub timeout: Option<Span>,
    /// How often to repeat a question; `None` for the usual number.
    pub retries: Option<u8>,
    /// File to record the line to, if anybody wants that.
    pub trace: Option<Recording<'a>>,
    /// Whether every telegram is told as an event.
    pub verbose: bool,
    /// Whether a CAN bus is only listened to: then nobody can be asked.
    pub listens: bool,
}

/// Where a line is recorded to.
#[derive(Clone, Copy, Debug)]
pub struct Recording<'a> {
    /// The file.
    pub path: &'a Path,
    /// Whether one that exists is replaced.
    pub overwrite: bool,
}

impl<'a> Opening<'a> {
    /// How long and how often a question is asked on it.
    pub(super) fn limits(&self) -> Limits {
        let usual = Limits::default();
        let (patience, repeats) = match self.protocol {
            Protocol::Modbus(Framing::Tcp) => (GATEWAY_PATIENCE, GATEWAY_REPEATS),
            Protocol::Pkw => (SLAVE_PATIENCE, GATEWAY_REPEATS),
            Protocol::Sdo(_) => (usual.reply_timeout, BUS_REPEATS),
            _ => (usual.reply_timeout, usual.retries),
        };
        let (reply_timeout, retries) = (self.timeout.unwrap_or(patience), self.retries.unwrap_or(repeats));
        Limits { reply_timeout, retries, ..usual }
    }

    /// What a recording of it calls what is spoken.
    pub(super) fn spoken(&self) -> &'static str {
        if self.profibus { DP } else { self.protocol.name() }
    }

    /// A line as drives of the ACTIVE family speak on it from the factory: Modbus RTU, 19200 baud, even parity (CM-485
    /// manual 5). What is another way is put in its place: `Opening { retries: Some(0), ..Opening::at(&port) }`.
    pub fn at(port: &'a Port) -> Self {
        Opening {
            port,
            line: LineSetting::rtu(19_200, Parity::Even),
            rs485: Rs485::default(),
            protocol: Framing::Rtu.into(),
            profibus: false,
            timeout: None,
            retries: None,
            trace: None,
            verbose: false,
            listens: false,
        }
    }
}

/// The port that was named, or the one USB serial adapter that is plugged in, which is said. None, or several of them, is `port.none`.
pub fn open_port(named: Option<&Port>, observe: &mut dyn FnMut(Event)) -> Result<Port, Failure> {
    if let Some(port) = named {
        return Ok(port.clone());
    }
    let ports = list_ports();
    let adapters: Vec<_> = ports.iter().filter(|port| port.usb).collect();
    if let [only] = adapters.as_slice() {
        observe(Event::Note(both!(
            "no port given, taking {only}",
            "kein Anschluss angegeben, es wird genommen: {only}"
        )));
        return Ok(Port::Serial(only.name.clone()));
    }
    let message = match adapters.len() {
        0 => both!(
            "no port given, and no USB serial adapter is plugged in",
            "kein Anschluss angegeben, und kein USB-Adapter ist eingesteckt"
        ),
        _ => both!(
            "no port given, and more than one USB serial adapter is plugged in",
            "kein Anschluss angegeben, und mehr als ein USB-Adapter ist eingesteckt"
        ),
    };
    let found = trouble::found_ports();
    let hint = both!("name it with -p; {found}", "angeben mit -p; {found}", found);
    Err(Failure::new(Class::Port, "port.none", message).hint(hint))
}

/// The file that the line is recorded to.
pub(super) fn open_trace(recording: Recording<'_>, about: &str) -> Result<Trace, Failure> {
    let Recording { path, overwrite } = recording;
    let trace = files::create(path, overwrite).and_then(|file| Ok(Trace::new(Box::new(file), about)?));
    trace.map_err(|error| {
        let failure = Failure::new(
            Class::Data,
            "data.trace",
            both!("{file}: {why}", "{file}: {why}", file = path.display(), why = error.text()),
        );
        match error {
            FileError::Exists => failure.hint(both!(
                "name another file; --force replaces this one, and forces whatever else the verb would refuse",
                "eine andere Datei nennen; --force ersetzt diese und erzwingt auch, was der Befehl sonst ablehnte"
            )),
            _ => failure,
        }
    })
}

/// Tells once that a recording has ended before its time.
pub(super) fn cut_recording(link: &mut Link) -> Option<Event> {
    let error = link.take_trace_error()?;
    let message = both!(
        "the recording (--trace) ends here: {why}",
        "die Aufzeichnung (--trace) endet hier: {why}",
        why = of_system(&error)
    );
    Some(Event::Warned(Warning { code: "trace.cut".to_owned(), message }))
}

/// Whether every character takes its time on the way: on the bench and on a serial port, but not on a pty, which hands over
/// what it gets at once, nor behind a network.
pub(super) fn is_wired(port: &Port) -> bool {
    match port {
        Port::Sim(_) | Port::Beside(_) => true,
        Port::Serial(name) => {
            let real = std::fs::canonicalize(name).unwrap_or_else(|_| name.into());
            !(real.starts_with("/dev/pts") || real.starts_with("/dev/ttys"))
        }
        _ => false,
    }
}
